#pragma once

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::test {

/// Expects `call` to throw an Error of this kind whose what() is one line that contains `part`; gives the
/// error's hint, empty if nothing was thrown.
template <class Call>
std::string expect_error(ErrorKind kind, const std::string& part, Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_THAT(error.what(), ::testing::HasSubstr(part));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_EQ(error.hint().find('\n'), std::string::npos) << error.hint();
    return error.hint();
  }
  ADD_FAILURE() << "no error; expected one with \"" << part << "\"";
  return {};
}

}  // namespace offing::test
