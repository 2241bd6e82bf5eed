#pragma once

#include <filesystem>
#include <vector>

#include "host/base/rgba_image.h"
#include "host/io/atomic_file.h"
#include "present/gl/render_target.h"

namespace offing::present {

/// Light of a picture, [height][width] of red, green, blue (kcd/m2) and alpha, row 0 at the bottom.
struct PictureLight {
  int width = 0, height = 0;
  std::vector<float> rgba;
};
PictureLight read_light(const RenderTarget& light);

/// The highlights of a picture alone, with alpha, row 0 at the top. Laid over the picture without highlights
/// they give the picture with them: light * 1 + (1 - alpha) * below.
struct HighlightLayer {
  int width = 0, height = 0;
  std::vector<float> light;  ///< premultiplied, kcd/m2
  RgbaImage shown;           ///< as a screen shows it, not premultiplied; goes over linear light too
};

/// `alone` has premultiplied highlights (HighlightShow::only), the others the same picture with its
/// highlights and without. Alpha is that of `alone`, more where the two pictures differ by more than a light
/// of 0 ... white of that alpha can make: their samples are not summed in proportion to their light
/// (mesh_end.frag).
HighlightLayer highlight_layer(const PictureLight& alone, const PictureLight& with,
                               const PictureLight& without, double exposure);

/// Highlights of HighlightShow::unobstructed, which belong over no picture: as they are over black.
HighlightLayer highlight_layer(const PictureLight& alone, double exposure);

/// Writes .png, not premultiplied, or .exr, premultiplied, with the time and the exposure in its header.
/// Throws Error(file) if it cannot be written.
void write_layer(const std::filesystem::path& path, const HighlightLayer& layer, double time_s,
                 double exposure, Existing existing);

}  // namespace offing::present
