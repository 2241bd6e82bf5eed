#include "host/io/whole_file.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {

std::string read_whole_file(const std::filesystem::path& path, const FileExpectation& expectation) {
  const std::string shown = one_line(path.string());
  std::error_code status;
  const std::filesystem::file_status found = std::filesystem::status(path, status);
  if (found.type() == std::filesystem::file_type::not_found) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, got no such file", shown, expectation.kind), "check the path");
  }
  if (!status && !std::filesystem::is_regular_file(found)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, got a folder or device", shown, expectation.kind),
                "give the path of a file");
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  const auto fail = [&](const std::string& reason) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: cannot be read: {}", shown, reason),
                "check the permissions of the file and its folders");
  };
  if (!file) fail(std::strerror(errno));
  const std::uintmax_t size = std::filesystem::file_size(path, status);
  if (status) fail(status.message());
  if (size > expectation.most_bytes) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at most {} bytes, got {}", shown, expectation.most_bytes, size),
                std::string(expectation.hint_of_size));
  }
  std::string bytes(static_cast<std::size_t>(size), '\0');
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  if (std::ferror(file.get())) fail(std::strerror(errno));
  return bytes;
}

}  // namespace offing
