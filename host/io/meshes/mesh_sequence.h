#pragma once

#include <filesystem>
#include <vector>

#include "host/io/file_trust.h"
#include "host/io/meshes/mesh_file.h"

namespace offing {

/// Whether a name stands for a sequence of mesh files: it has one %04d, or %d, for their number, and no file
/// has this name.
bool is_mesh_sequence(const std::filesystem::path& name);

/// The files of a sequence, by their numbers; empty for any other name.
std::vector<std::filesystem::path> files_of_mesh_sequence(const std::filesystem::path& name);

/// The first mesh of a sequence, which deforms into the next ones: the first at 0 s, another every
/// 1 / frames_per_s, and linear between them. Files are read when needed; at most 256 MB of them are kept.
/// All must have the same faces.
///
/// Throws Error(bad_input) as read_mesh_file(), where there are no files, and where a number between the
/// first and the last is missing. `form_at` throws it too, for damaged files. Files of an untrusted
/// sequence lie in its folder or below.
MeshFile read_mesh_sequence(const std::filesystem::path& name, double frames_per_s,
                            Trust trust = Trust::trusted);

}  // namespace offing
