// A file that HDF5 crashes on as it closes it. This program's own H5Fclose stands for that: it crashes
// in the process in which a file is tried first.
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
bool crashes = false;

}  // namespace

extern "C" herr_t H5Fclose(hid_t file) {
  if (crashes && ::getpid() != test_process) std::raise(SIGSEGV);
  static const auto close = reinterpret_cast<herr_t (*)(hid_t)>(::dlsym(RTLD_NEXT, "H5Fclose"));
  return close(file);
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
  crashes = true;
  EXPECT_THAT(test::failure_of(ExitCode::bad_file, [&] { read_checkpoint(path); }),
              ::testing::HasSubstr("is damaged: HDF5 cannot read it"));
}

}  // namespace
}  // namespace pupflow::io
