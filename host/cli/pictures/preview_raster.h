#pragma once

#include <cstddef>
#include <vector>

namespace offing::cli {

/// A corner of the surface mesh on the screen.
struct ScreenVertex {
  float x = 0, y = 0;              ///< samples from the upper left corner
  float nearness = 0;              ///< 1 / distance along the optical axis, 1/m; <= 0: behind the eye
  float label_x = 0, label_z = 0;  ///< rest label, m from the eye
};

/// The nearest surface in each sample of the screen.
struct RasterSample {
  float nearness = 0;  ///< 0: none
  float label_x = 0, label_z = 0;
};

/// Draws a mesh of vertices [rows][columns] into samples [height][width] with hidden parts removed.
/// Deterministic: each vertical strip of the screen is filled by one thread, in the order of the mesh.
std::vector<RasterSample> rasterise(const std::vector<ScreenVertex>& vertices, int columns, int rows,
                                    int width, int height);

}  // namespace offing::cli
