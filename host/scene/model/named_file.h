#pragma once

#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_presence.h"
#include "host/io/file_trust.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// Where a scene names a file, for messages.
inline std::string place_of_name(const Scene& scene, const ValueKey& key) {
  const auto set_at = scene.set_at.find(key);
  return set_at == scene.set_at.end() ? std::string(key.key) : set_at->second;
}

/// How far a raster that the scene reads may lead.
inline FileTrust trust_in(const Scene& scene, const std::string& file) {
  return {.trust = scene.trust, .is_named_by_scene = scene.named_files.contains(file)};
}

/// What read() gives; faults are told where the scene names the file by this key. Throws Error(bad_input) for
/// a file that is not there, and what read() throws.
template <class Read>
auto read_named(const Scene& scene, const ValueKey& key, const char* expected, const std::string& file,
                Read read) {
  const std::string place = place_of_name(scene, key);
  if (!is_there(file)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, got no such file, {}", place, expected, file),
                "check the path; in a scene it is relative to the scene file");
  }
  try {
    return read();
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", place, error.what()), error.hint());
  }
}

}  // namespace offing::scene
