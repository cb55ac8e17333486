// Work that is tried in another process.
#include "app/io/trial.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>

namespace pupflow::io {
namespace {

TEST(Trial, OfWorkThatEndsLeavesNothing) {
  int done = 0;
  EXPECT_TRUE(ends_well(5, [&] { ++done; }));
  EXPECT_EQ(done, 0);
}

TEST(Trial, WhatIsThrownIsNoCrash) {
  EXPECT_TRUE(ends_well(5, [] { throw std::runtime_error("refused"); }));
}

TEST(Trial, TellsOfACrash) {
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE}) {
    EXPECT_FALSE(ends_well(5, [signal] { std::raise(signal); })) << signal;
  }
}

TEST(Trial, EndsWorkThatDoesNotEnd) {
  EXPECT_FALSE(ends_well(1, [] {
    for (volatile int i = 0;;) i = i + 1;
  }));
}

}  // namespace
}  // namespace pupflow::io
