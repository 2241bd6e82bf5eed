#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/scene/prepare/cloud_shape.h"

namespace offing::scene {

/// Shapes of clouds that are kept from one edit of a scene to the next: neither where a cloud is nor how it
/// moves makes them anew, and no file is read again that is as it was.
class CloudShapes {
 public:
  /// What begins is the next scene: shapes that it does not take are forgotten with the one after it.
  void begin();
  /// take_shape() of a cloud, or what it gave before.
  RestingParticles take(const Scene& scene, std::size_t index, clouds::CloudParameters& parameters);
  /// Remembers the shape of a cloud that is not shown, if it was taken before; none is made.
  void keep(const Scene& scene, std::size_t index, const clouds::CloudParameters& parameters);

 private:
  /// All that a shape depends on.
  struct Source {
    CloudShapeScene shape;
    CloudNoiseScene noise;
    CloudLookScene look;
    double scale = 1.0;
    clouds::CloudParameters at_rest;               // at the origin
    std::filesystem::file_time_type written = {};  // the file, if there is one
    std::uintmax_t bytes = 0;

    Source(const CloudScene& cloud, const clouds::CloudParameters& parameters);
    bool operator==(const Source&) const = default;
  };
  struct Shape {
    Source source;
    clouds::CloudParameters parameters;
    RestingParticles particles;
  };
  const Shape* known(const Source& source);

  std::vector<Shape> last_, now_;
};

}  // namespace offing::scene
