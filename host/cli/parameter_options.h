#pragma once

#include <deque>
#include <initializer_list>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "host/scene/parameter.h"

namespace offing::cli {

/// The scene parameters of a command: an optional SCENE file and the flags of the parameter table, which
/// override it.
class ParameterOptions {
 public:
  /// Adds SCENE and the flags of these groups to `command`, which this object must outlive.
  void add_to(CLI::App& command, std::initializer_list<scene::ParameterGroup> groups);

  /// The scene as file and flags say. Throws Error(bad_input).
  scene::OceanScene read() const;

  /// Whether the scene, or the default one, gives the frames: true if a SCENE was named.
  bool has_scene_file() const { return !scene_file_.empty(); }

 private:
  struct Flag {
    const scene::Parameter* parameter;
    std::vector<std::string> values;
  };

  std::string scene_file_;
  std::deque<Flag> flags_;  // a deque: CLI11 keeps references to the values
};

}  // namespace offing::cli
