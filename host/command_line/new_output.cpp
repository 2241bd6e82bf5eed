#include "host/command_line/new_output.h"

#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/error_report.h"
#include "host/io/atomic_file.h"
#include "host/io/file_presence.h"

namespace offing {

void require_not_read(const std::string& output, std::span<const std::string> inputs) {
  if (!is_there(output)) return;
  for (const std::string& input : inputs) {
    std::error_code nowhere;
    if (!std::filesystem::equivalent(output, input, nowhere)) continue;
    throw Error(ErrorKind::file, fmt::format("{}: is the file that is read", one_line(output)),
                "name another file to write");
  }
}

void require_new(const std::string& output, Overwriting overwriting,
                 std::initializer_list<std::string> inputs) {
  require_new(output, overwriting, std::span<const std::string>(inputs.begin(), inputs.size()));
}

void require_new(const std::string& output, Overwriting overwriting, std::span<const std::string> inputs) {
  if (output.empty()) return;
  require_not_read(output, inputs);
  if (overwriting == Overwriting::refused && is_there(output)) {
    throw Error(ErrorKind::file, fmt::format("{}: is there already", one_line(output)),
                "--force replaces it, or name another file");
  }
  require_writable(output);
}

}  // namespace offing
