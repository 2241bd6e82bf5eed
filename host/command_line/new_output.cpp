#include "host/command_line/new_output.h"

#include <optional>
#include <system_error>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/error_report.h"
#include "host/command_line/input_files.h"
#include "host/io/atomic_file.h"
#include "host/io/file_presence.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  const fs::path folder = file.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

/// For files that exist.
void check(std::span<const fs::path> outputs, Overwriting overwriting, std::span<const std::string> inputs) {
  if (outputs.empty()) return;
  require_not_read(outputs, inputs);
  if (overwriting == Overwriting::allowed) return;
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("{}: expected a new file, found an existing one", one_line(outputs.front().string())),
      "add --force to replace it, or name another file");
}

}  // namespace

CLI::Option* add_force_flag(CLI::App& command, Overwriting& overwriting) {
  return command.add_flag_callback(
      "--force", [&overwriting] { overwriting = Overwriting::allowed; }, "replace existing files");
}

void require_file_name(const std::string& output) {
  if (!is_standard_output(output)) return;
  throw Error(ErrorKind::bad_usage,
              "-: expected a file name, found standard output, where this command does not write",
              "name a file or folder; write ./- for one that is named -");
}

void require_not_read(std::span<const fs::path> outputs, std::span<const std::string> inputs) {
  std::optional<InputFiles> files;
  for (const fs::path& output : outputs) {
    if (!is_there(output)) continue;
    if (!files) files.emplace(inputs);  // which may open them: only where it matters
    if (!files->contains(output)) continue;
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: expected an output file, found an input of this command", one_line(output.string())),
        "name another file to write");
  }
}

void require_new(const std::string& output, Overwriting overwriting,
                 std::initializer_list<std::string> inputs) {
  require_new(output, overwriting, std::span<const std::string>(inputs.begin(), inputs.size()));
}

void require_new(const std::string& output, Overwriting overwriting, std::span<const std::string> inputs) {
  if (output.empty()) return;
  require_file_name(output);
  const fs::path file = output;
  std::error_code ignored;
  // Folders and devices are never replaced: require_writable() says so.
  if (is_there(file) && fs::is_regular_file(file, ignored)) check(std::span(&file, 1), overwriting, inputs);
  remove_stale_partials(folder_of(file), file.filename().string());
  require_writable(file);
}

void require_new_frames(const FrameName& names, FrameRange frames, Overwriting overwriting,
                        std::span<const std::string> inputs) {
  std::vector<fs::path> outputs;
  std::error_code failure;
  const fs::path folder = folder_of(names.of(frames.first));
  for (int frame = frames.first; !names.is_one_folder() && frame <= frames.last; ++frame) {
    if (is_there(names.of(frame))) outputs.push_back(names.of(frame));
  }
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::optional<int> frame = names.frame_of(entry->path().filename().string());
    if (frame && *frame >= frames.first && *frame <= frames.last) outputs.push_back(entry->path());
  }
  check(outputs, overwriting, inputs);
  remove_stale_partials(folder, names.prefix());
  require_writable(names.of(frames.first));
}

}  // namespace offing
