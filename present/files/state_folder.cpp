#include "present/files/state_folder.h"

#include <cstdlib>

namespace offing::present {

std::filesystem::path state_folder() {
  const char* xdg = std::getenv("XDG_STATE_HOME");
  // The XDG rules ignore relative paths.
  if (xdg != nullptr && *xdg == '/') return std::filesystem::path(xdg) / "offing";
  const char* home = std::getenv("HOME");
  if (home != nullptr && *home == '/') return std::filesystem::path(home) / ".local" / "state" / "offing";
  return {};
}

std::filesystem::path state_file(const char* name) {
  const std::filesystem::path folder = state_folder();
  return folder.empty() ? folder : folder / name;
}

}  // namespace offing::present
