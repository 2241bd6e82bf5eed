#pragma once

#include <deque>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "host/cli/common/direction_text.h"
#include "host/command_line/input_files.h"
#include "host/command_line/option_rows.h"
#include "host/io/file_trust.h"
#include "host/scene/schema/parameter.h"

namespace offing::cli {

/// The scene parameters of a command: an optional SCENE file and the flags of the parameter table, which
/// override it.
class ParameterOptions {
 public:
  /// Adds SCENE, --untrusted, the flags of these groups and --compass to `command`, which this object must
  /// outlive.
  void add_to(CLI::App& command, std::initializer_list<scene::ParameterGroup> groups);

  /// The scene as file and flags say. Throws Error(bad_input).
  scene::Scene read() const;

  /// The files that this scene is read from: its own and those that it names.
  GivenInputs inputs(const scene::Scene& scene) const;

  /// How flags give directions, and results are to show them.
  DirectionStyle directions() const { return directions_; }

 private:
  struct Flag {
    const scene::Parameter* parameter = nullptr;
    std::vector<std::string> values = {};
    std::optional<OptionRow> bound = std::nullopt;
  };

  void add_sea_options(CLI::App& command);
  void read_flag(scene::Scene& scene, const Flag& flag) const;
  void store_flag(scene::Scene& scene, const scene::Parameter& parameter, const std::string& text,
                  const scene::Place& place) const;
  /// What says the same as this flag in another way: of the scene it no longer counts. Throws
  /// Error(bad_usage) if it is a flag that was given too.
  void take_out_others(scene::Scene& scene, const Flag& flag) const;
  void read_swell(scene::Scene& scene, const std::string& text) const;

  std::string scene_file_;
  Trust trust_ = Trust::trusted;
  DirectionStyle directions_ = DirectionStyle::travel;
  std::string preset_;
  std::vector<std::string> swells_;
  std::deque<Flag> flags_;  // a deque: CLI11 keeps references to the values
};

}  // namespace offing::cli
