#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "host/ocl/device_list.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// The longest side of a picture.
inline constexpr int longest_picture_px = 16384;

/// A picture that is asked for, and where it goes; an empty span: not wanted.
struct PictureRequest {
  double time_s = 0.0;
  int width_px = 0, height_px = 0;
  std::span<std::uint8_t> rgb = {};  ///< [height][width][3], sRGB, row 0 at the top
  std::span<float> light = {};       ///< [height][width][3], linear Rec.709, kcd/m2, row 0 at the top
};

/// Draws pictures of a scene without a window, each at a time of its own. Any thread may call, one at a time.
class SceneRenderer {
 public:
  SceneRenderer() = default;
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;
  virtual ~SceneRenderer() = default;

  /// Throws Error(bad_usage) for a size out of range or a span of another one.
  virtual void draw(const PictureRequest& request) = 0;
};

/// The functions of the module `present`, which links OpenGL (host/io/module.h).
struct PresentModule {
  /// Throws Error(no_device) where there is no OpenGL, and what preparing the scene's world throws.
  std::unique_ptr<SceneRenderer> (*make_renderer)(const Scene& scene, const ocl::DeviceInfo& device);
};

}  // namespace offing::scene
