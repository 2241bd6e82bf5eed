#pragma once

#include "host/command_line/setting_options.h"
#include "host/terrain/analysis/earth_curve.h"

namespace offing::cli {

/// --curvature and --refraction, the same for every command that follows lines of sight.
class EarthCurveFlags {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  bool are_given() const { return is_curved_ || options_.are_given(); }
  /// Flat unless one of them is given. Throws Error(bad_input) for a refraction that cannot be.
  terrain::EarthCurve read() const;

 private:
  struct Settings {
    double refraction = terrain::light_refraction;
  };

  bool is_curved_ = false;
  SettingOptions<Settings> options_;
};

}  // namespace offing::cli
