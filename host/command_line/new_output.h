#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/App.hpp>

#include "host/base/argument.h"
#include "host/command_line/input_files.h"
#include "host/io/atomic_file.h"
#include "host/io/frame_name.h"

namespace offing {

/// The one rule for everything that a program writes: never over a file that it reads, by whatever name, and
/// never over an existing file without --force. Each function throws Error(bad_usage), before any work is
/// done, for an output that breaks it. `inputs` are the files and folders that the command was given; what is
/// read with them (input_files.h) counts too.

/// Adds --force. `existing` must outlive the command.
CLI::Option* add_force_flag(CLI::App& command, Existing& existing);

/// Whether an output is "-": standard output, for what is text.
inline bool is_standard_output(std::string_view output) {
  return output == "-";
}
/// For outputs that are no text, and for folders: refuses "-".
void require_file_name(const std::string& output);

/// For one file; an empty name is no output. Removes what killed runs left of it. Throws Error(file) for a
/// file that cannot be written.
void require_new(const std::string& output, Existing existing, const GivenInputs& inputs = {});

/// The files that frames of a sequence, or every `step`-th of them, would replace. Frames in one folder cost
/// one listing of it, however many they are.
std::vector<std::filesystem::path> existing_frames(const FrameName& names, FrameRange frames, int step = 1);

/// require_new() for a file a frame, or for every `step`-th alone.
void require_new_frames(const FrameName& names, FrameRange frames, Existing existing,
                        const GivenInputs& inputs, int step = 1);

/// A file, and the flag that names it.
struct NamedOutput {
  std::string_view flag;
  std::filesystem::path file;
};
/// Two flags that name one file: the last one written would replace the other. Empty names are no outputs.
void require_distinct(std::span<const NamedOutput> outputs);
inline void require_distinct(std::initializer_list<NamedOutput> outputs) {
  require_distinct(std::span(outputs.begin(), outputs.size()));
}

/// For files that may be replaced, such as those of a bake that resumes, but not if they are read.
void require_not_read(std::span<const std::filesystem::path> outputs, const GivenInputs& inputs);

}  // namespace offing
