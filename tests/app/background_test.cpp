#include "app/io/background.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <vector>

namespace pupflow::io {
namespace {

TEST(Background, DoesJobsInTheirOrder) {
  std::vector<int> done;
  Background thread;
  Background::Ticket third = 0;
  for (int i = 0; i < 100; ++i) {
    const Background::Ticket ticket = thread.run([&done, i] { done.push_back(i); });
    if (i == 2) third = ticket;
  }
  thread.wait(third);
  thread.wait_for_all();
  ASSERT_EQ(done.size(), 100u);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
}

TEST(Background, TellsThatAJobFailedAndLeavesOutTheRest) {
  Background thread;
  bool later = false;
  thread.run([] { throw std::runtime_error("no room"); });
  thread.run([&] { later = true; });
  EXPECT_THROW(thread.wait_for_all(), std::runtime_error);
  EXPECT_THROW(thread.wait_for_all(), std::runtime_error);
  EXPECT_FALSE(later);
}

TEST(Background, EndsWithJobsLeft) {
  std::mutex gate;
  int done = 0;
  {
    Background thread;
    gate.lock();
    for (int i = 0; i < 5; ++i) {
      thread.run([&] {
        const std::lock_guard lock(gate);
        ++done;
      });
    }
    gate.unlock();
  }
  EXPECT_LE(done, 5);
}

}  // namespace
}  // namespace pupflow::io
