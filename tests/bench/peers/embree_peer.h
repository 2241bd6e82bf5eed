// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <span>
#include <string>
#include <vector>

#include "host/base/camera.h"
#include "host/terrain/field/post_grid.h"

typedef struct RTCDeviceTy* RTCDevice;
typedef struct RTCSceneTy* RTCScene;

namespace offing::bench {

/// A height map in Embree 3 or 4, as it is used at its best: high quality, one thread a core, rays in tiles
/// of 16 x 16 pixels.
class EmbreePeer {
 public:
  enum class Geometry { grid, triangles };
  enum class Packet { one, four, eight, sixteen, stream };  ///< with Embree 4 a stream is cast ray by ray
  static constexpr Packet packets[] = {Packet::one, Packet::four, Packet::eight, Packet::sixteen,
                                       Packet::stream};

  EmbreePeer(const terrain::PostGrid& grid, std::span<const float> heights_m, Geometry geometry);
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;
  ~EmbreePeer();

  /// Builds the scene from the vertices, which the constructor made.
  void build();

  /// Distances along the camera's unit rays [height_px][width_px], +inf where they miss.
  void cast(const Camera& camera, Packet packet);
  const std::vector<float>& distances_m() const { return distances_m_; }

  std::string name() const;
  std::string name(Packet packet) const;

 private:
  Geometry geometry_;
  terrain::PostGrid grid_;
  std::vector<float> vertices_;  ///< x, y, z from the map's first post; a float of padding at the end
  std::vector<unsigned> corners_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  std::vector<float> distances_m_;
};

}  // namespace offing::bench
