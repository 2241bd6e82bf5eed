#pragma once

#include <cstddef>
#include <vector>

#include "host/terrain/field/height_field.h"

namespace offing::cli {

/// Frames of a flight over tiles against those over the whole map.
class FlightComparison {
 public:
  /// field must outlive this.
  explicit FlightComparison(terrain::HeightField& field) : field_(field) {}

  /// What tiles showed of a frame: where there was sky while some were still missing ([pixels]), and all once
  /// they were there.
  void add(const ocl::Device& device, const Camera& camera, const std::vector<bool>& sky_flown,
           const std::vector<TerrainHit>& loaded);

  struct Result {
    std::size_t frames = 0, pixels = 0;
    std::size_t holes_flown = 0, holes_loaded = 0;  ///< pixels of sky where the map has ground
    std::size_t raised = 0;  ///< pixels of ground where the map has sky, once all tiles were there
    /// Distance to the ground, off by so much of itself: of pixels that both show ground.
    double median_error = 0.0, worst_hundredth_error = 0.0;
  };
  Result result() const;

 private:
  terrain::HeightField& field_;
  Result result_;
  std::vector<float> errors_;
};

}  // namespace offing::cli
