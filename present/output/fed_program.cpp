#include "present/output/fed_program.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/base/error.h"

namespace offing::present {
namespace {

Error start_error(const std::filesystem::path& program, int error) {
  return Error(ErrorKind::file,
               fmt::format("{}: cannot be started: {}", program.string(), std::strerror(error)),
               "check the program and the limit of processes (ulimit -u)");
}

/// How posix_spawn() is told; what it takes is given back.
class SpawnSettings {
 public:
  SpawnSettings() {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
  const char* folders = std::getenv("PATH");
  std::string_view rest = folders == nullptr ? "" : folders;
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    const std::filesystem::path folder(rest.substr(0, end).empty() ? "." : rest.substr(0, end));
    std::error_code unknown;
    const std::filesystem::path file = folder / name;
    if (std::filesystem::is_regular_file(file, unknown) && access(file.c_str(), X_OK) == 0) return file;
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return {};
}

FedProgram::FedProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments)
    : complaints_(std::tmpfile(), &std::fclose) {
  if (!complaints_) throw start_error(program, errno);
  // A socket, not a pipe: writing to a program that has ended must not end this one.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw start_error(program, errno);
  input_ = ends[0];
  SpawnSettings settings;
  posix_spawn_file_actions_adddup2(&settings.files_, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&settings.files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&settings.files_, fileno(complaints_.get()), STDERR_FILENO);
  // A group of its own: Ctrl-C is for this program, which then ends the other one.
  posix_spawnattr_setflags(&settings.attributes_, POSIX_SPAWN_SETPGROUP);
  std::vector<std::string> all{program.string()};
  all.insert(all.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& argument : all) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const int error = posix_spawn(&process_, program.c_str(), &settings.files_, &settings.attributes_,
                                pointers.data(), environ);
  ::close(ends[1]);
  if (error == 0) return;
  process_ = -1;
  close_input();
  throw start_error(program, error);
}

FedProgram::~FedProgram() {
  close_input();
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void FedProgram::close_input() {
  if (input_ >= 0) ::close(input_);
  input_ = -1;
}

bool FedProgram::feed(std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t taken = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (taken < 0 && errno == EINTR) continue;
    if (taken < 0) {
      // Its last words may still be on their way, and reading them would move the place it writes them to.
      finish();
      return false;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(taken));
  }
  return true;
}

bool FedProgram::finish() {
  close_input();
  if (process_ < 0) return false;
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(process_, &status, 0);
  } while (ended < 0 && errno == EINTR);
  process_ = -1;
  return ended > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::string FedProgram::last_words() const {
  std::rewind(complaints_.get());
  std::string all;
  std::array<char, 512> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), complaints_.get()) != nullptr) {
    all += part.data();  // of a long line, its first or next piece
  }
  const std::size_t end = all.find_last_not_of("\r\n");
  if (end == std::string::npos) return {};
  const std::size_t start = all.find_last_of("\r\n", end);
  const std::size_t first = start == std::string::npos ? 0 : start + 1;
  return one_line(all.substr(first, end + 1 - first));
}

}  // namespace offing::present
