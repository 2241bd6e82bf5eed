#pragma once

#include "host/base/cancel_token.h"
#include "host/cli/pictures/preview_surface.h"
#include "host/io/png_image.h"

namespace offing::cli {

/// Where the preview stands and looks, in the world frame (x east, y up, z south; 0 is the mean sea level).
struct PreviewView {
  int width = 1280, height = 720;
  double eye_x_m = 0.0, eye_z_m = 0.0;
  double camera_height_m = 10.0;  ///< > 0
  double yaw_rad = 0.0;           ///< looking direction, from +x toward +z
  double pitch_deg = -6.0;        ///< up positive, -60 ... 30
  double fov_deg = 55.0;          ///< across the width, 10 ... 120
  double sun_azimuth_rad = 0.5;   ///< direction toward the sun, from +x toward +z
  double sun_elevation_deg = 24.0;
  /// Variance of the slope along x, and along z, of waves too short for any cascade: they dull the mirror.
  double ripple_variance = 0.008;
  int samples = 2;  ///< along each side of a pixel, 1 ... 4
};

/// A picture of the sea from a low eye: displaced surface with hidden parts removed, mirrored sky, sun
/// glitter, light through crests, foam and haze. Heights and distances are true to scale, so a low sea looks
/// low. The sea has no end: the patches repeat to the horizon. The same input gives the same picture on any
/// number of processors. Throws Error(bad_input) for a view out of range, Error(cancelled) within a row when
/// asked to stop: a picture takes seconds.
RgbImage render_sea_preview(const PreviewSurface& surface, const PreviewView& view,
                            const CancelToken& cancel = {});

}  // namespace offing::cli
