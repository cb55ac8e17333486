#include "app/io/interrupt.h"

#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>

namespace pupflow::io {

// Shared like the functions of the header, in case a compiler inlines these in a module. Other threads than
// that of the handler read it.
extern std::atomic<bool> came;
[[gnu::visibility("default")]] std::atomic<bool> came = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler takes no lock");

namespace {

void note_signal(int) {
  if (came.exchange(true)) _exit(130);
}

}  // namespace

void watch_for_interrupt() {
  struct sigaction action = {};
  action.sa_handler = note_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A terminal that goes away; under nohup it is ignored and stays so.
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);
}

bool interrupted() {
  return came;
}

bool wait_until_ready(int descriptor, short events) {
  constexpr int kLook = 100;  // milliseconds
  for (;;) {
    pollfd waited{descriptor, events, 0};
    const int ready = ::poll(&waited, 1, kLook);
    if (ready > 0 || (ready < 0 && errno != EINTR)) return true;  // the call that follows will tell
    if (interrupted()) return false;
  }
}

}  // namespace pupflow::io
