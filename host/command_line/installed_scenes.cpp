#include "host/command_line/installed_scenes.h"

#include <system_error>

namespace offing {

namespace fs = std::filesystem;

fs::path installed_scenes() {
  std::error_code failure;
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  if (failure) return {};
  return (program.parent_path() / OFFING_SCENES_FROM_PROGRAMS).lexically_normal();
}

std::string find_scene(const std::string& written) {
  const fs::path name = written;
  std::error_code ignored;
  if (name.has_parent_path() || name.extension() != ".toml" || fs::exists(name, ignored)) return written;
  const fs::path installed = installed_scenes() / name;
  return fs::is_regular_file(installed, ignored) ? installed.string() : written;
}

}  // namespace offing
