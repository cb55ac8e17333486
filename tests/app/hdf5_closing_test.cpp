// Files that HDF5 crashes on as it closes them, or as it gives its memory back, where free() finds what
// was written behind a buffer. This program's own functions of HDF5's names stand for that: they crash in
// the process in which a file is tried first.
#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <unistd.h>

#include <csignal>

#include "app/io/checkpoint.h"
#include "tests/app/failing.h"
#include "tests/support/scratch.h"

namespace {

const pid_t test_process = ::getpid();
enum class Crash { none, as_it_closes, as_it_gives_back } crash = Crash::none;

void crash_at(Crash place) {
  if (crash == place && ::getpid() != test_process) std::raise(SIGSEGV);
}

}  // namespace

extern "C" herr_t H5Fclose(hid_t file) {
  crash_at(Crash::as_it_closes);
  static const auto close = reinterpret_cast<herr_t (*)(hid_t)>(::dlsym(RTLD_NEXT, "H5Fclose"));
  return close(file);
}

extern "C" herr_t H5garbage_collect() {
  crash_at(Crash::as_it_gives_back);
  return 0;
}

namespace pupflow::io {
namespace {

TEST(Hdf5Closing, ACrashIsARefusal) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.h5");
  Params params;
  params.pups = 1;
  params.face_points = 2;
  write_checkpoint(path, false, Simulation(params));
  EXPECT_EQ(read_checkpoint(path).params.pups, 1);
  for (const Crash place : {Crash::as_it_closes, Crash::as_it_gives_back}) {
    crash = place;
    EXPECT_THAT(test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(path); }),
                ::testing::HasSubstr("is damaged: HDF5 cannot read it"));
  }
}

}  // namespace
}  // namespace pupflow::io
