// What a call fails with.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/io/failure.h"

namespace pupflow::test {

/// Runs `call`, which must throw Failure with `code`, and returns the message.
template <class Call>
std::string failure_of(io::ExitCode code, Call call) {
  try {
    call();
  } catch (const io::Failure& failure) {
    EXPECT_EQ(static_cast<int>(failure.code()), static_cast<int>(code)) << failure.what();
    return failure.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

}  // namespace pupflow::test
