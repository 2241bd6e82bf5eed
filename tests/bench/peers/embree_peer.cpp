// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/embree_peer.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>
#if OFFING_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "host/base/error.h"

namespace offing::bench {
namespace {

constexpr int tile_px = 16;
constexpr float infinity = std::numeric_limits<float>::infinity();

/// Rays of a camera from the map's first post.
struct View {
  float eye[3], forward[3], right[3], up[3];
  int width_px, height_px;

  View(const Camera& camera, const terrain::PostGrid& grid)
      : width_px(camera.width_px), height_px(camera.height_px) {
    const CameraBasis axes = basis(camera);
    const glm::dvec2 extent = half_extent(camera);
    const glm::dvec3 from(grid.origin_x_m, 0.0, grid.origin_z_m);
    for (int axis = 0; axis < 3; ++axis) {
      eye[axis] = static_cast<float>(camera.eye_m[axis] - from[axis]);
      forward[axis] = static_cast<float>(axes.forward[axis]);
      right[axis] = static_cast<float>(extent.x * axes.right[axis]);
      up[axis] = static_cast<float>(extent.y * axes.up[axis]);
    }
  }

  void direction(int column, int row, float (&out)[3]) const {
    const float x = (static_cast<float>(column) + 0.5f) * 2.0f / static_cast<float>(width_px) - 1.0f;
    const float y = 1.0f - (static_cast<float>(row) + 0.5f) * 2.0f / static_cast<float>(height_px);
    for (int axis = 0; axis < 3; ++axis) out[axis] = forward[axis] + x * right[axis] + y * up[axis];
    const float scale = 1.0f / std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
    for (float& component : out) component *= scale;
  }
};

// All that differs between Embree 3 and 4: how a query says that its rays are coherent, and that 4 has no
// streams.
#if OFFING_EMBREE >= 4
using Coherence = RTCIntersectArguments;

Coherence coherent_rays() {
  Coherence coherence;
  rtcInitIntersectArguments(&coherence);
  coherence.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  return coherence;
}

void intersect(RTCScene scene, Coherence& coherence, RTCRayHit& ray) {
  rtcIntersect1(scene, &ray, &coherence);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit4& rays) {
  rtcIntersect4(valid, scene, &rays, &coherence);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit8& rays) {
  rtcIntersect8(valid, scene, &rays, &coherence);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &rays, &coherence);
}
void intersect_stream(RTCScene scene, Coherence& coherence, RTCRayHit* rays, unsigned count) {
  for (unsigned ray = 0; ray < count; ++ray) intersect(scene, coherence, rays[ray]);
}
#else
using Coherence = RTCIntersectContext;

Coherence coherent_rays() {
  Coherence coherence;
  rtcInitIntersectContext(&coherence);
  coherence.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return coherence;
}

void intersect(RTCScene scene, Coherence& coherence, RTCRayHit& ray) {
  rtcIntersect1(scene, &coherence, &ray);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit4& rays) {
  rtcIntersect4(valid, scene, &coherence, &rays);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit8& rays) {
  rtcIntersect8(valid, scene, &coherence, &rays);
}
void intersect(const int* valid, RTCScene scene, Coherence& coherence, RTCRayHit16& rays) {
  rtcIntersect16(valid, scene, &coherence, &rays);
}
void intersect_stream(RTCScene scene, Coherence& coherence, RTCRayHit* rays, unsigned count) {
  rtcIntersect1M(scene, &coherence, rays, count, sizeof(RTCRayHit));
}
#endif

template <class Packet>
constexpr int width_of = sizeof(Packet::hit.geomID) / sizeof(unsigned);

/// Sets one ray of a packet: members of RTCRayHit are numbers, those of the others arrays.
template <class Packet>
void set_ray(Packet& packet, int lane, const View& view, int column, int row) {
  float direction[3];
  view.direction(column, row, direction);
  const auto at = [lane]<class Member>(Member & member) -> auto& {
    if constexpr (std::is_array_v<Member>) {
      return member[lane];
    } else {
      return member;
    }
  };
  at(packet.ray.org_x) = view.eye[0];
  at(packet.ray.org_y) = view.eye[1];
  at(packet.ray.org_z) = view.eye[2];
  at(packet.ray.dir_x) = direction[0];
  at(packet.ray.dir_y) = direction[1];
  at(packet.ray.dir_z) = direction[2];
  at(packet.ray.tnear) = 0.0f;
  at(packet.ray.tfar) = infinity;
  at(packet.ray.time) = 0.0f;
  at(packet.ray.mask) = ~0u;
  at(packet.ray.flags) = 0u;
  at(packet.hit.geomID) = RTC_INVALID_GEOMETRY_ID;
}

/// Pixels from `left`, `top` to 16 more each way, in packets of 2 x 2, 4 x 2 or 4 x 4.
template <class Packet>
void cast_tile(RTCScene scene, const View& view, int left, int top, float* distances_m) {
  constexpr int lanes = width_of<Packet>, columns = lanes == 4 ? 2 : 4, rows = lanes / columns;
  Coherence coherence = coherent_rays();
  for (int row = top; row < std::min(top + tile_px, view.height_px); row += rows) {
    for (int column = left; column < std::min(left + tile_px, view.width_px); column += columns) {
      Packet packet;
      alignas(64) int valid[lanes];
      for (int lane = 0; lane < lanes; ++lane) {
        const int x = column + lane % columns, y = row + lane / columns;
        valid[lane] = x < view.width_px && y < view.height_px ? -1 : 0;
        set_ray(packet, lane, view, x, y);
      }
      intersect(valid, scene, coherence, packet);
      for (int lane = 0; lane < lanes; ++lane) {
        if (valid[lane] == 0) continue;
        distances_m[(row + lane / columns) * view.width_px + column + lane % columns] = packet.ray.tfar[lane];
      }
    }
  }
}

void cast_tile_singly(RTCScene scene, const View& view, int left, int top, float* distances_m) {
  Coherence coherence = coherent_rays();
  for (int row = top; row < std::min(top + tile_px, view.height_px); ++row) {
    for (int column = left; column < std::min(left + tile_px, view.width_px); ++column) {
      RTCRayHit ray;
      set_ray(ray, 0, view, column, row);
      intersect(scene, coherence, ray);
      distances_m[row * view.width_px + column] = ray.ray.tfar;
    }
  }
}

void cast_tile_as_stream(RTCScene scene, const View& view, int left, int top, float* distances_m) {
  Coherence coherence = coherent_rays();
  RTCRayHit rays[tile_px * tile_px];
  unsigned count = 0;
  const int right = std::min(left + tile_px, view.width_px), bottom = std::min(top + tile_px, view.height_px);
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) set_ray(rays[count++], 0, view, column, row);
  }
  intersect_stream(scene, coherence, rays, count);
  count = 0;
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) {
      distances_m[row * view.width_px + column] = rays[count++].ray.tfar;
    }
  }
}

}  // namespace

EmbreePeer::EmbreePeer(const terrain::PostGrid& grid, std::span<const float> heights_m, Geometry geometry)
    : geometry_(geometry), grid_(grid), device_(rtcNewDevice(nullptr)) {
  if (device_ == nullptr) throw Error(ErrorKind::device, "Embree: no device", "install libembree-dev again");
  const auto columns = static_cast<std::size_t>(grid.columns);
  vertices_.reserve(3 * heights_m.size() + 1);
  for (std::size_t post = 0; post < heights_m.size(); ++post) {
    vertices_.push_back(static_cast<float>(static_cast<double>(post % columns) * grid.spacing_x_m));
    vertices_.push_back(heights_m[post]);
    vertices_.push_back(static_cast<float>(static_cast<double>(post / columns) * grid.spacing_z_m));
  }
  vertices_.push_back(0.0f);
  if (geometry == Geometry::grid) return;
  for (unsigned row = 0; row + 1 < static_cast<unsigned>(grid.rows); ++row) {
    for (unsigned column = 0; column + 1 < columns; ++column) {
      const unsigned post = row * static_cast<unsigned>(columns) + column;
      const unsigned below = post + static_cast<unsigned>(columns);
      corners_.insert(corners_.end(), {post, below, post + 1, post + 1, below, below + 1});
    }
  }
}

EmbreePeer::~EmbreePeer() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void EmbreePeer::build() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  scene_ = rtcNewScene(device_);
  rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
  const bool is_grid = geometry_ == Geometry::grid;
  const RTCGeometry geometry =
      rtcNewGeometry(device_, is_grid ? RTC_GEOMETRY_TYPE_GRID : RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.data(), 0,
                             3 * sizeof(float), vertices_.size() / 3);
  if (is_grid) {
    auto* whole = static_cast<RTCGrid*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_GRID, 0, RTC_FORMAT_GRID, sizeof(RTCGrid), 1));
    *whole = {0, static_cast<unsigned>(grid_.columns), static_cast<unsigned short>(grid_.columns),
              static_cast<unsigned short>(grid_.rows)};
  } else {
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, corners_.data(), 0,
                               3 * sizeof(unsigned), corners_.size() / 3);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  if (const RTCError error = rtcGetDeviceError(device_); error != RTC_ERROR_NONE) {
    throw Error(ErrorKind::device, fmt::format("Embree: error {} while it builds", static_cast<int>(error)),
                "take a smaller map");
  }
}

void EmbreePeer::cast(const Camera& camera, Packet packet) {
  const View view(camera, grid_);
  distances_m_.resize(static_cast<std::size_t>(view.width_px) * static_cast<std::size_t>(view.height_px));
  const int across = (view.width_px + tile_px - 1) / tile_px, down = (view.height_px + tile_px - 1) / tile_px;
  float* distances_m = distances_m_.data();
#pragma omp parallel for schedule(dynamic, 4)
  for (int tile = 0; tile < across * down; ++tile) {
    const int left = tile % across * tile_px, top = tile / across * tile_px;
    switch (packet) {
      case Packet::one:
        cast_tile_singly(scene_, view, left, top, distances_m);
        break;
      case Packet::four:
        cast_tile<RTCRayHit4>(scene_, view, left, top, distances_m);
        break;
      case Packet::eight:
        cast_tile<RTCRayHit8>(scene_, view, left, top, distances_m);
        break;
      case Packet::sixteen:
        cast_tile<RTCRayHit16>(scene_, view, left, top, distances_m);
        break;
      case Packet::stream:
        cast_tile_as_stream(scene_, view, left, top, distances_m);
        break;
    }
  }
}

std::string EmbreePeer::name(Packet packet) const {
  constexpr const char* names[] = {"single rays", "packets of 4", "packets of 8", "packets of 16", "streams"};
  return fmt::format("{}, {}", name(), names[static_cast<std::size_t>(packet)]);
}

std::string EmbreePeer::name() const {
  return fmt::format("Embree {}, {}", OFFING_EMBREE, geometry_ == Geometry::grid ? "grid" : "triangles");
}

}  // namespace offing::bench
