#pragma once

#include <optional>
#include <string>

#include "host/cli/common/global_options.h"
#include "host/command_line/setting_options.h"
#include "host/io/height_maps/height_map_options.h"
#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/height_field.h"

namespace offing::cli {

/// The flags that say how to read a height map, the same for every command that takes one.
class HeightMapFlags {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  /// Throws Error(bad_usage) for a flag that cannot be used.
  HeightMapOptions read() const;
  bool are_given() const;

 private:
  struct Settings {
    HeightMapOptions map;
    std::optional<double> spacing_m;  ///< along both axes
  };

  SettingOptions<Settings> options_;
  std::string nodata_, raw_size_;
};

/// The height map that a terrain command works on, and the flags that say how to read it.
class TerrainInput {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  const std::string& file() const { return file_; }
  HeightMapOptions options() const;
  Trust trust() const { return trust_; }
  /// Whether a flag says how to read a height map.
  bool has_reading_flags() const { return flags_.are_given(); }
  /// Throws what read_height_map() throws, and Error(bad_input) for a tile store.
  HeightMapFile read() const;

 private:
  std::string file_;
  Trust trust_ = Trust::trusted;
  HeightMapFlags flags_;
};

/// The map on a device, its first post at x = z = 0.
terrain::HeightField make_field(const HeightMap& map, const ocl::Device& device);

}  // namespace offing::cli
