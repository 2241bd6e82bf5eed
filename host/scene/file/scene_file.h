#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "host/io/file_trust.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// Scene files are written by hand, or by the window for hands: anything larger is some other file.
inline constexpr std::size_t most_scene_bytes = std::size_t{4} << 20;

/// Reads a scene file (TOML, `version = 1`); file names in it are relative to its folder.
///
/// A scene names files, never addresses. One that is not trusted names only files in its folder or below, and
/// these lead only to such (links, buffers of a glTF, companions of a spectrum).
///
/// Throws Error(bad_input) as `storm.toml:14:13: ocean.fetch_m: expected ..., got ...` for a file that cannot
/// be read, is not TOML, or has an unknown key, a wrong type, a value out of range or not finite, or a
/// section of a system that this version does not have. It is an ErrorList of the first ten such faults.
Scene load_scene(const std::filesystem::path& file, Trust trust = Trust::trusted);

/// What to do about keys that have a newer name.
enum class EarlierKeys { warn, accept };

/// The same from text. `name` stands for the file in messages; if it is empty, they name no lines. `folder`
/// is what file names are relative to.
Scene parse_scene(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                  Trust trust = Trust::trusted, EarlierKeys earlier_keys = EarlierKeys::warn);

}  // namespace offing::scene
