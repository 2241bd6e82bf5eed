#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::meshes {

/// Cuts polygons into triangles of the same corners and orientation; no corner is added or lost: n corners
/// give n - 2 triangles.
///
/// A polygon is seen along the axis nearest to its normal (Newell's sum over its edges). One that is convex
/// there becomes a fan around its first corner. From others, ears are cut one after the other: corners whose
/// triangle holds no other corner (Meisters 1975, "Polygons have ears"). Polygons that cross themselves or
/// have no area may have no ear left; then any corner is cut off, so that they are kept, too.
class PolygonCutter {
 public:
  /// `most_steps` of some nanoseconds: all polygons together.
  explicit PolygonCutter(std::span<const glm::dvec3> positions_m, std::size_t most_steps = 1'000'000'000)
      : positions_m_(positions_m), most_steps_(most_steps) {}

  /// Adds the triangles of a polygon of four corners or more. False, without its triangles, if this one and
  /// those before have taken too many steps: ears of n corners take n^2 at worst.
  bool cut(std::span<const std::uint32_t> corners, std::vector<TriangleIndices>& faces);

 private:
  bool project(std::span<const std::uint32_t> corners);
  bool is_convex() const;
  bool cut_ears(std::span<const std::uint32_t> corners, std::vector<TriangleIndices>& faces);
  double turn_at(std::uint32_t corner) const;
  bool is_ear(std::uint32_t corner);
  void find_reflex();

  std::span<const glm::dvec3> positions_m_;
  std::vector<glm::dvec2> points_;             // corners of the polygon in its plane, anticlockwise
  std::vector<std::uint32_t> before_, after_;  // the ring of corners that are not cut off
  std::vector<std::uint32_t> reflex_;          // corners that may lie in an ear
  std::size_t most_steps_, steps_ = 0;
};

}  // namespace offing::meshes
