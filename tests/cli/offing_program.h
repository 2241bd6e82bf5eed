#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/io/temporary_folder.h"

namespace offing::test {

/// How a run of the program ended, and what it said.
struct ProgramResult {
  int exit_code = 0;  ///< 128 + the signal's number if one ended it
  std::string output;
  std::string errors;
  std::size_t peak_bytes = 0;  ///< the most memory that it had resident
};

/// The program `offing`, or another one, running beside the test, with the test's environment.
class OffingProgram {
 public:
  explicit OffingProgram(const std::vector<std::string>& arguments, const char* program = OFFING_PROGRAM);
  OffingProgram(const OffingProgram&) = delete;
  OffingProgram& operator=(const OffingProgram&) = delete;
  /// Kills it if nobody waited for it.
  ~OffingProgram();

  /// Does nothing once it is known to have ended.
  void send_signal(int number) const;
  bool is_running();
  ProgramResult wait();

 private:
  /// Whether it has ended, after waiting as waitpid() does with these options.
  bool has_ended(int options);

  TemporaryFolder folder_;
  pid_t process_ = -1;
  int status_ = 0;
  std::size_t peak_bytes_ = 0;
};

/// Runs the program to its end.
ProgramResult run_offing(const std::vector<std::string>& arguments);

}  // namespace offing::test
