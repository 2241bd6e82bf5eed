// All that is wrong with a scene file, for its author.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "host/io/file_trust.h"

namespace offing::scene {

/// An error or a warning.
struct SceneMessage {
  std::string text;                  ///< the line that programs print, with file, place and key
  std::size_t line = 0, column = 0;  ///< from 1 on; 0: of the whole file
  std::string key;                   ///< "ocean.fetch_m"; may be empty
  std::string message;               ///< the rest of the text
  std::string hint;                  ///< may be empty
};

/// In the file's order.
struct SceneReport {
  std::vector<SceneMessage> errors, warnings;
};

/// Reads a scene file and whatever of it takes no device: its keys, whether the files it names are there, its
/// sea, its wakes, the lights that highlights name. Values without effect are warnings; they are found where
/// there are no errors. A file that cannot be read has one error. Errors of other kinds than bad_input are
/// thrown.
SceneReport check_scene(const std::filesystem::path& file, Trust trust = Trust::trusted);

}  // namespace offing::scene
