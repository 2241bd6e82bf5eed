#pragma once

#include <span>
#include <string_view>

namespace offing::present {

/// A file under scenes/, embedded at build.
struct SceneSource {
  std::string_view name;  ///< "world.toml"
  std::string_view text;  ///< the file, unchanged
};

/// The one scene that is shown where none is asked for; it names no other files.
std::span<const SceneSource> scene_sources();

}  // namespace offing::present
