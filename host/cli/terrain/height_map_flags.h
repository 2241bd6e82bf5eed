#pragma once

#include <string>

#include <CLI/App.hpp>

#include "host/io/height_maps/height_map_options.h"

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
  std::string encoding_, band_, channel_, raw_size_, raw_type_, raw_order_;
  std::string scale_, offset_, spacing_, spacing_x_, spacing_z_, nodata_, void_height_, unit_, reproject_to_;
};

}  // namespace offing::cli
