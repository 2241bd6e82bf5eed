#pragma once

#include "host/cli/preview_surface.h"
#include "host/io/png_image.h"

namespace offing::cli {

/// What a map of the sea shows: x to the right, z down.
struct MapView {
  int width = 1024, height = 1024;
  double center_x_m = 0.0, center_z_m = 0.0;
  double width_m = 1000.0;  ///< across the picture
};

/// The displaced sea from straight above, to look for seams, repetition and traces of the grid: colour is
/// elevation (dark at -2.5 standard deviations, pale at +2.5), shaded by a light from the upper left, foam
/// white. Throws Error(bad_input) for a view out of range.
RgbImage render_sea_map(const PreviewSurface& surface, const MapView& view);

}  // namespace offing::cli
