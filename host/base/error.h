#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Errors, and how programs report them.
namespace offing {

/// What went wrong, as far as a caller can act on it. The command line maps it to an exit code.
enum class ErrorKind {
  bad_usage,      ///< the command line or an argument is wrong (exit 2)
  bad_input,      ///< an input file is missing, unreadable or wrong, or a parameter value is (exit 2)
  no_device,      ///< no OpenCL platform or no device that fits (exit 3)
  out_of_memory,  ///< host or device memory does not suffice (exit 1)
  build_failed,   ///< an OpenCL program does not compile (exit 1)
  device,         ///< any other OpenCL failure (exit 1)
  file,           ///< a file or a folder cannot be written, replaced or looked up (exit 1)
  cancelled,      ///< the user asked to stop (exit 130)
};

/// The one exception type. what() is one line: what and where, found and expected; hint() is one line with
/// the fix, or empty.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& what, std::string hint = {});

  ErrorKind kind() const noexcept { return kind_; }
  const std::string& hint() const noexcept { return hint_; }

 private:
  ErrorKind kind_;
  std::string hint_;
};

/// Process exit status for an error of this kind: 1 failed, 2 usage or input, 3 no device, 130 cancelled.
int exit_code(ErrorKind kind) noexcept;

/// Several errors of one file. As an Error it is the first one; report() prints all.
class ErrorList : public Error {
 public:
  /// `errors` holds at least one.
  explicit ErrorList(std::vector<Error> errors) : Error(errors.front()), errors_(std::move(errors)) {}

  const std::vector<Error>& errors() const noexcept { return errors_; }

 private:
  std::vector<Error> errors_;
};

/// Prints an error to stderr as its two lines, `error: ...` and `hint: ...`; of an ErrorList all errors.
void report(const Error& error);

/// One printable line: control characters, as hostile file names hold them, become `\xNN`.
std::string one_line(std::string_view text);

/// Words of a file fit for one line of an error message: control and non-ASCII bytes as `\xNN`, cut after 60
/// characters.
std::string printable(std::string_view text);

}  // namespace offing
