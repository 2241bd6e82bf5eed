#pragma once

#include <cstdio>

#include "host/base/error.h"

namespace offing::test {

/// The main() of a program that DeviceDump runs: `write` fills the file that the only argument names.
template <typename Write>
int run_dump_program(int argc, char** argv, const Write& write) {
  if (argc != 2) return 2;
  try {
    write(argv[1]);
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

}  // namespace offing::test
