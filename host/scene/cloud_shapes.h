#pragma once

#include <map>
#include <string>

#include "host/scene/cloud_shape.h"

namespace offing::scene {

/// Shapes of clouds that are kept from one edit of a scene to the next: neither where a cloud is nor how it
/// moves makes them anew, and no file is read again that the last scene named in the same way.
class CloudShapes {
 public:
  /// What begins is the next scene: shapes that it does not take are forgotten with the one after it.
  void begin();
  /// take_shape() of a cloud, or what it gave before.
  RestingParticles take(const OceanScene& scene, std::size_t index, clouds::CloudParameters& parameters);

 private:
  struct Shape {
    clouds::CloudParameters parameters;
    RestingParticles particles;
  };
  std::map<std::string, Shape> last_, now_;  // by all that shapes depend on
};

}  // namespace offing::scene
