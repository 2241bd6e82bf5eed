// Reads the text of a scene file as far as it goes, with all that is wrong with it.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/error.h"
#include "host/io/file_trust.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// What benchmarks take from a scene: nothing of it changes the scene.
inline constexpr std::string_view bench_section = "bench";

/// The reader stops after so many: a hostile scene may have a fault in each of millions of keys.
inline constexpr std::size_t most_faults = 1000;

/// A scene as read, and what is wrong with its file.
struct SceneReading {
  Scene scene;                             ///< of the parts without faults
  std::vector<Error> errors = {};          ///< in the file's order, at most most_faults
  std::vector<std::string> warnings = {};  ///< a line for each key that has a newer name
};

/// As parse_scene(). Throws Error(bad_input) for text that is not TOML, or a scene of another version.
SceneReading read_scene(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                        Trust trust);

/// The text of a scene file. Throws Error(bad_input) if it cannot be read or is too large.
std::string read_scene_text(const std::filesystem::path& file);

}  // namespace offing::scene
