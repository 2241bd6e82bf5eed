// --edge-m and --faces: how fine a command makes a mesh.
#pragma once

#include <optional>
#include <string_view>

#include <CLI/App.hpp>

#include "host/command_line/setting_options.h"

namespace offing::mesh_tools {

inline constexpr double most_faces = 1e8;

/// One of the two is set.
struct Fineness {
  std::optional<double> edge_m;
  int faces = 0;
};

/// Must outlive the command.
class FinenessFlags {
 public:
  void add_to(CLI::App& command, std::string_view edge_help, std::string_view faces_help);

  /// Throws Error(bad_usage) that names the command if neither is given.
  Fineness read(std::string_view command) const;

 private:
  SettingOptions<Fineness> options_;
};

}  // namespace offing::mesh_tools
