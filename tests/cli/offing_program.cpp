#include "tests/cli/offing_program.h"

#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace offing::test {

namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

OffingProgram::OffingProgram(const std::vector<std::string>& arguments, const char* program) {
  std::vector<std::string> words = {program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  constexpr int create = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, (folder_.path() / "output").c_str(), create,
                                   0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (folder_.path() / "errors").c_str(), create,
                                   0600);
  const int error = posix_spawn(&process_, program, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw std::runtime_error(std::string("cannot start ") + program);
  }
}

OffingProgram::~OffingProgram() {
  if (is_running()) {
    send_signal(SIGKILL);
    wait();
  }
}

void OffingProgram::send_signal(int number) const {
  if (process_ > 0) kill(process_, number);  // -1, one that has ended, would mean every process there is
}

bool OffingProgram::has_ended(int options) {
  rusage usage{};
  if (process_ > 0 && wait4(process_, &status_, options, &usage) == process_) {
    process_ = -1;
    peak_bytes_ = static_cast<std::size_t>(usage.ru_maxrss) * 1024;
  }
  return process_ <= 0;
}

bool OffingProgram::is_running() {
  return !has_ended(WNOHANG);
}

ProgramResult OffingProgram::wait() {
  has_ended(0);
  return {.exit_code = WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_),
          .output = text_of(folder_.path() / "output"),
          .errors = text_of(folder_.path() / "errors"),
          .peak_bytes = peak_bytes_};
}

ProgramResult run_offing(const std::vector<std::string>& arguments) {
  return OffingProgram(arguments).wait();
}

}  // namespace offing::test
