#include "tests/present/virtual_display.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace offing::test {

std::unique_ptr<VirtualDisplay> VirtualDisplay::start(std::string& reason, const std::string& screen) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("cannot make a pipe");
  // The server picks a free number and writes it to the pipe once it takes connections.
  std::string number_to = std::to_string(ends[1]);
  std::array<std::string, 9> words{"Xvfb", "-displayfd", number_to, "-screen", "0",
                                   screen, "-nolisten",  "tcp",     "-noreset"};
  std::array<char*, 10> arguments{};
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addclose(&actions, ends[0]);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", 0x1 /* O_WRONLY */, 0);
  std::unique_ptr<VirtualDisplay> display(new VirtualDisplay);
  const int error = posix_spawnp(&display->process_, "Xvfb", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  std::string number;
  char character = 0;
  while (error == 0 && read(ends[0], &character, 1) == 1 && character != '\n') number += character;
  close(ends[0]);
  if (error == ENOENT) {
    display->process_ = -1;
    reason = "Xvfb is not installed: apt-get install xvfb";
    return nullptr;
  }
  if (number.empty()) throw std::runtime_error("Xvfb does not start");
  setenv("DISPLAY", (":" + number).c_str(), 1);
  return display;
}

VirtualDisplay::~VirtualDisplay() {
  if (process_ < 0) return;
  kill(process_, SIGTERM);
  waitpid(process_, nullptr, 0);
  unsetenv("DISPLAY");
}

}  // namespace offing::test
