#pragma once

#include <string_view>

#include "host/base/error.h"

namespace offing::fuzz {

/// Ends the process, which libFuzzer reports as a finding.
inline void expect(bool holds) {
  if (!holds) __builtin_trap();
}

/// An error is one line with a hint.
inline void expect_told(const Error& error) {
  expect(std::string_view(error.what()).find('\n') == std::string_view::npos);
  expect(!error.hint().empty());
}

/// Runs `read`, which checks what it reads: it must return, or throw Error of one line with a hint.
template <class Read>
int check_reading(Read read) {
  try {
    read();
  } catch (const Error& error) {
    expect_told(error);
  }
  return 0;
}

}  // namespace offing::fuzz
