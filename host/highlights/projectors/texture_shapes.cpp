#include "host/highlights/projectors/texture_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace offing::highlights {
namespace {

constexpr double ring_radius = 0.8, ring_half = 0.2;
constexpr double pane_middle = 0.54, pane_half = 0.46, pane_rounding = 0.08;
constexpr double notch_radius = 0.45;
constexpr double streak_half = 0.22;
// A circle through (0, +-1) and (streak_half, 0), and how far left its middle is.
constexpr double streak_radius = (1.0 + streak_half * streak_half) / (2.0 * streak_half);
constexpr double streak_centre = streak_radius - streak_half;
constexpr double lobe_middle = 0.46, lobe_radius = 0.54;
// Between the lobes: lobe_middle + sqrt(lobe_radius^2 - lobe_middle^2).
constexpr double cleft_y = 0.742842712474619;
// Of the tangent from (0, -1) to the right lobe's outer side.
constexpr glm::dvec2 tangent_touch{0.884684807384961, 0.126469170275972};
constexpr glm::dvec2 tangent_normal{0.786453347009187, -0.617649684674127};
// Of the circle around a place of the axis that touches the cleft and both tangents.
constexpr double heart_depth = 0.665450784551910;

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double share = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + share * along);
}

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

double window(const glm::dvec2& q) {
  const glm::dvec2 beyond = glm::abs(glm::abs(q) - pane_middle) - (pane_half - pane_rounding);
  return glm::length(glm::max(beyond, 0.0)) + std::min(std::max(beyond.x, beyond.y), 0.0) - pane_rounding;
}

double star(const glm::dvec2& q) {
  // All ten sides are one in the fold from a tip to the next notch.
  constexpr double fold_rad = 0.4 * std::numbers::pi;
  const double angle_rad = std::atan2(q.x, q.y);
  const double folded_rad = std::abs(angle_rad - fold_rad * std::round(angle_rad / fold_rad));
  const glm::dvec2 p = glm::length(q) * glm::dvec2(std::sin(folded_rad), std::cos(folded_rad));
  const glm::dvec2 tip(0.0, 1.0);
  const glm::dvec2 notch = notch_radius * glm::dvec2(std::sin(0.5 * fold_rad), std::cos(0.5 * fold_rad));
  const bool is_outside = cross(notch - tip, p - tip) > 0.0;
  return (is_outside ? 1.0 : -1.0) * distance_to_segment(p, tip, notch);
}

double streak(const glm::dvec2& q) {
  const glm::dvec2 p = glm::abs(q);
  const bool is_beside_arc = p.y * streak_centre <= p.x + streak_centre;
  if (!is_beside_arc) return glm::distance(p, glm::dvec2(0.0, 1.0));
  return glm::length(p + glm::dvec2(streak_centre, 0.0)) - streak_radius;
}

double heart(const glm::dvec2& q) {
  const glm::dvec2 p(std::abs(q.x), q.y), cleft(0.0, cleft_y), lobe(lobe_middle);
  const glm::dvec2 way = p - lobe;
  const bool is_beside_arc = cross(tangent_normal, way) > 0.0 || cross(cleft - lobe, way) < 0.0;
  if (is_beside_arc) return glm::length(way) - lobe_radius;
  const glm::dvec2 tip(0.0, -1.0);
  const double to_side = distance_to_segment(p, tip, tangent_touch);
  if (glm::dot(p - tip, tangent_normal) > 0.0) return to_side;
  return -std::min(to_side, glm::distance(p, cleft));
}

}  // namespace

double signed_distance(HighlightTexture shape, const glm::dvec2& q) {
  switch (shape) {
    case HighlightTexture::dot:
      return glm::length(q) - 1.0;
    case HighlightTexture::window:
      return window(q);
    case HighlightTexture::star:
      return star(q);
    case HighlightTexture::ring:
      return std::abs(glm::length(q) - ring_radius) - ring_half;
    case HighlightTexture::streak:
      return streak(q);
    case HighlightTexture::heart:
      return heart(q);
    case HighlightTexture::image:
    case HighlightTexture::normal_map:
      break;
  }
  return std::max(std::abs(q.x), std::abs(q.y)) - 1.0;
}

double depth_of(HighlightTexture shape) {
  switch (shape) {
    case HighlightTexture::window:
      return pane_half;
    case HighlightTexture::star:
      return notch_radius;
    case HighlightTexture::ring:
      return ring_half;
    case HighlightTexture::streak:
      return streak_half;
    case HighlightTexture::heart:
      return heart_depth;
    case HighlightTexture::dot:
    case HighlightTexture::image:
    case HighlightTexture::normal_map:
      break;
  }
  return 1.0;
}

double shape_opacity(HighlightTexture shape, const glm::dvec2& q, double softness, double pixel) {
  const double rim = std::max(std::min(is_image(shape) ? 0.0 : softness, depth_of(shape)), pixel);
  const double distance = signed_distance(shape, q);
  if (!(rim > 0.0)) return distance < 0.0 ? 1.0 : 0.0;
  return 1.0 - glm::smoothstep(-rim, 0.0, distance);
}

std::string_view name_of(HighlightTexture texture) {
  switch (texture) {
    case HighlightTexture::dot:
      return "dot";
    case HighlightTexture::window:
      return "window";
    case HighlightTexture::star:
      return "star";
    case HighlightTexture::ring:
      return "ring";
    case HighlightTexture::streak:
      return "streak";
    case HighlightTexture::heart:
      return "heart";
    case HighlightTexture::image:
      return "image";
    case HighlightTexture::normal_map:
      return "normal_map";
  }
  return "dot";
}

}  // namespace offing::highlights
