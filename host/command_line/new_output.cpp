#include "host/command_line/new_output.h"

#include <optional>
#include <system_error>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/file_presence.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

/// By name: links to one file are replaced one by one.
bool is_same_name(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return a.filename() == b.filename() &&
         fs::weakly_canonical(folder_of(a), ignored) == fs::weakly_canonical(folder_of(b), ignored);
}

/// For files that exist.
void check(std::span<const fs::path> outputs, Existing existing, const GivenInputs& inputs) {
  if (outputs.empty()) return;
  require_not_read(outputs, inputs);
  if (existing == Existing::replace) return;
  refuse_existing(outputs.front(), "add --force to replace it, or name another file");
}

}  // namespace

CLI::Option* add_force_flag(CLI::App& command, Existing& existing) {
  return command.add_flag_callback(
      "--force", [&existing] { existing = Existing::replace; }, "replace existing files");
}

void require_file_name(const std::string& output) {
  if (!is_standard_output(output)) return;
  throw Error(ErrorKind::bad_usage,
              "-: expected a file name, found standard output, to which this command cannot write",
              "name a file or folder; write ./- for one called -");
}

void require_not_read(std::span<const fs::path> outputs, const GivenInputs& inputs) {
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

void require_new(const std::string& output, Existing existing, const GivenInputs& inputs) {
  if (output.empty()) return;
  require_file_name(output);
  const fs::path file = output;
  // Folders and devices are never replaced: require_writable() says so.
  std::error_code ignored;
  const fs::file_type type = fs::status(file, ignored).type();
  const bool is_replaceable = type == fs::file_type::regular || type == fs::file_type::not_found;
  if (is_replaceable && is_taken(file)) check(std::span(&file, 1), existing, inputs);
  remove_stale_partials(folder_of(file), file.filename().string());
  require_writable(file);
}

std::vector<fs::path> existing_frames(const FrameName& names, FrameRange frames, int step) {
  std::vector<fs::path> outputs;
  std::error_code failure;
  const fs::path folder = folder_of(names.of(frames.first));
  for (int frame = frames.first; !names.is_one_folder() && frame <= frames.last; frame += step) {
    if (is_taken(names.of(frame))) outputs.push_back(names.of(frame));
  }
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const std::optional<int> frame = names.frame_of(entry->path().filename().string());
    if (frame && *frame >= frames.first && *frame <= frames.last && (*frame - frames.first) % step == 0) {
      outputs.push_back(entry->path());
    }
  }
  return outputs;
}

void require_new_frames(const FrameName& names, FrameRange frames, Existing existing,
                        const GivenInputs& inputs, int step) {
  check(existing_frames(names, frames, step), existing, inputs);
  remove_stale_partials(folder_of(names.of(frames.first)), names.prefix());
  require_writable(names.of(frames.first));
}

void require_distinct(std::span<const NamedOutput> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t j = i + 1; j < outputs.size(); ++j) {
      const auto& [first, file] = outputs[i];
      const auto& [second, other] = outputs[j];
      if (file.empty() || other.empty() || !is_same_name(file, other)) continue;
      throw Error(ErrorKind::bad_usage,
                  fmt::format("{}: expected a different file from that of {}, found {} for both", second,
                              first, one_line(file.string())),
                  "name two files");
    }
  }
}

}  // namespace offing
