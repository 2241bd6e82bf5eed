#pragma once

#include <span>
#include <string>
#include <vector>

#include <CLI/App.hpp>

#include "host/terrain/earth_curve.h"
#include "host/terrain/height_field.h"

namespace offing::cli {

/// --curvature and --refraction, the same for every command that follows lines of sight.
class EarthCurveFlags {
 public:
  /// `this` must outlive the command.
  void add_to(CLI::App& command);

  /// Flat unless one of them is given. Throws bad_argument() for a refraction that cannot be.
  terrain::EarthCurve read() const;

 private:
  bool is_curved_ = false;
  std::string refraction_;
};

/// What rays hit over ground that falls away by a curve, or none.
std::vector<TerrainHit> cast(terrain::HeightField& field, std::span<const terrain::Ray> rays,
                             const terrain::EarthCurve& curve,
                             terrain::HitNormals normals = terrain::HitNormals::patch);

}  // namespace offing::cli
