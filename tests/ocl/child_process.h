#pragma once

#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/io/temporary_folder.h"

namespace offing::test {

/// The program ocl_child (ocl_child.cpp) running beside the test with the test's environment. Drivers keep
/// state in their process, so whatever needs a fresh driver or several of them runs there.
class ChildProcess {
 public:
  explicit ChildProcess(const std::vector<std::string>& arguments);
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;
  ~ChildProcess();

  /// Waits for its end; 128 + the signal's number if one ended it.
  int exit_status();
  /// What it wrote to stdout and stderr; call exit_status() before.
  std::string output() const;

 private:
  TemporaryFolder folder_;
  pid_t process_ = -1;
};

}  // namespace offing::test
