#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/io/atomic_file.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// The scene as a file that load_scene() reads back to the same values: `version = 1`, then by section every
/// value that is not the default one. File names are written relative to `folder`.
/// Throws Error(bad_input) for more sections of a kind than load_scene() takes.
std::string scene_text(const Scene& scene, const std::filesystem::path& folder);

/// Writes the scene's text, atomically. Throws Error(bad_usage) unless the name ends in .toml, or if there is
/// a file already that is to be kept; Error(bad_input) for one of more than most_scene_bytes, Error(file)
/// if it cannot be written, and as scene_text().
void save_scene(const Scene& scene, const std::filesystem::path& file, Existing existing);

/// The same with text that is there already.
void save_scene_text(std::string_view text, const std::filesystem::path& file, Existing existing);

}  // namespace offing::scene
