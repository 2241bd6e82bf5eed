#include "host/io/file_trust.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

fs::path followed(const fs::path& path) {
  std::error_code failure;
  fs::path real = fs::weakly_canonical(fs::absolute(path, failure), failure);
  if (failure) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot be looked up: {}", one_line(path.string()), failure.message()),
                "check the links in its path and the permissions of its folders");
  }
  return real;
}

}  // namespace

bool is_address(std::string_view name) {
  return name.starts_with("/vsi") || name.find("://") != std::string_view::npos;
}

void require_below(const fs::path& folder, const fs::path& file) {
  const fs::path root = followed(folder.empty() ? fs::path(".") : folder), real = followed(file);
  if (std::mismatch(root.begin(), root.end(), real.begin(), real.end()).first == root.end()) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a file in {} or below, found one outside", one_line(file.string()),
                          one_line(root.string())),
              "copy the file there; leave out --untrusted only if you trust the author");
}

void require_beside(const fs::path& leader, const fs::path& file, Trust trust) {
  if (trust == Trust::untrusted) require_below(followed(leader).parent_path(), file);
}

}  // namespace offing
