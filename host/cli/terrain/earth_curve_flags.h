#pragma once

#include <string>

#include <CLI/App.hpp>

#include "host/terrain/analysis/earth_curve.h"

namespace offing::cli {

/// --curvature and --refraction, the same for every command that follows lines of sight.
class EarthCurveFlags {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  bool are_given() const { return is_curved_ || !refraction_.empty(); }
  /// Flat unless one of them is given. Throws bad_argument() for a refraction that cannot be.
  terrain::EarthCurve read() const;

 private:
  bool is_curved_ = false;
  std::string refraction_;
};

}  // namespace offing::cli
