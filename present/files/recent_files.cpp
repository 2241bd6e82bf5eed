#include "present/files/recent_files.h"

#include <sstream>
#include <string>
#include <system_error>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/io/atomic_file.h"
#include "host/io/whole_file.h"

namespace offing::present {
namespace {

constexpr std::size_t most_recent = 20;

}  // namespace

std::vector<std::filesystem::path> RecentFiles::all() const {
  std::error_code failed;
  if (list_.empty() || !std::filesystem::exists(list_, failed)) return {};
  constexpr std::size_t most_bytes = 1 << 20;
  std::vector<std::filesystem::path> files;
  try {
    std::istringstream lines(
        read_whole_file(list_, {.kind = "a list of recent files", .most_bytes = most_bytes}));
    for (std::string line; files.size() < most_recent && std::getline(lines, line);) {
      if (std::filesystem::exists(line, failed)) files.emplace_back(line);
    }
  } catch (const Error& error) {
    spdlog::debug("{}", error.what());
  }
  return files;
}

void RecentFiles::add(const std::filesystem::path& file) {
  std::error_code failed;
  const std::filesystem::path whole = std::filesystem::absolute(file, failed).lexically_normal();
  if (list_.empty() || failed || whole.string().find('\n') != std::string::npos) return;
  std::vector<std::filesystem::path> files = all();
  std::erase(files, whole);
  files.insert(files.begin(), whole);
  if (files.size() > most_recent) files.resize(most_recent);
  std::string text;
  for (const std::filesystem::path& each : files) text += each.string() + '\n';
  try {
    std::filesystem::create_directories(list_.parent_path(), failed);
    write_file_atomically(list_, text);
  } catch (const Error& error) {
    spdlog::debug("{}", error.what());
  }
}

}  // namespace offing::present
