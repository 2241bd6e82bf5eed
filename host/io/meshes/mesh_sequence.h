#pragma once

#include <filesystem>
#include <vector>

#include "host/io/file_trust.h"
#include "host/io/meshes/mesh_file.h"

namespace offing {

/// Whether a name stands for a sequence of mesh files: it has one %04d, or %d, for their number, and is not
/// itself that of a file.
bool is_mesh_sequence(const std::filesystem::path& name);

/// The files of a sequence, by their numbers; empty for any other name.
std::vector<std::filesystem::path> files_of_mesh_sequence(const std::filesystem::path& name);

/// The first mesh of a sequence, which deforms into the next ones: one every 1 / frames_per_s, the first at 0
/// s, and on straight ways between them. They are read when they are needed; at most 256 MB are kept. All
/// must have the same faces.
///
/// Throws Error(bad_input) as read_mesh_file(), where there are no files, and where a number between the
/// first and the last is missing. Forms throw it too, for files that are wrong. Files of an untrusted
/// sequence lie in its folder or below.
MeshFile read_mesh_sequence(const std::filesystem::path& name, double frames_per_s,
                            Trust trust = Trust::trusted);

}  // namespace offing
