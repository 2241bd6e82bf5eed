#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

namespace offing::present {

/// The first file of this name in the folders of PATH that may be run.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// A program that runs beside this one and reads its standard input from it. What it prints goes nowhere,
/// what it complains of is kept. A key that ends this program does not reach it.
class FedProgram {
 public:
  /// Starts the program, without a shell. Throws Error(file) where that fails.
  FedProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  FedProgram(const FedProgram&) = delete;
  FedProgram& operator=(const FedProgram&) = delete;
  /// Kills it if nobody waited for its end.
  ~FedProgram();

  /// Waits until it has taken the bytes; false once it takes no more, and then it has ended.
  bool feed(std::span<const unsigned char> bytes);
  /// Ends its input and waits for its end; whether that was a good one. False if it had ended before.
  bool finish();
  /// The last line of its complaints, once it has ended, on one line; empty without any.
  std::string last_words() const;

 private:
  void close_input();

  int input_ = -1;
  pid_t process_ = -1;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> complaints_;
};

}  // namespace offing::present
