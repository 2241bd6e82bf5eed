#include "tests/ocl/child_process.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace offing::test {

ChildProcess::ChildProcess(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers{const_cast<char*>(OFFING_OCL_CHILD)};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  const std::string output_path = (folder_.path() / "output").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  const int error = posix_spawn(&process_, OFFING_OCL_CHILD, &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " OFFING_OCL_CHILD);
}

ChildProcess::~ChildProcess() {
  if (process_ > 0) exit_status();
}

int ChildProcess::exit_status() {
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string ChildProcess::output() const {
  std::ifstream file(folder_.path() / "output");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace offing::test
