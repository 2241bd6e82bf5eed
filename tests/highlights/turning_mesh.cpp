#include "tests/highlights/turning_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace offing::test {
namespace {

using namespace highlights;

using std::numbers::pi;
constexpr int grown_up_frames = 10;

glm::dmat3 turn_about(const glm::dvec3& axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  glm::dmat3 result;
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 e(0.0);
    e[i] = 1.0;
    result[i] = c * e + s * glm::cross(axis, e) + (1.0 - c) * glm::dot(axis, e) * axis;
  }
  return result;
}

double angle_deg(const Projector& a, const Projector& b) {
  const double trace = glm::dot(a.right, b.right) + glm::dot(a.up, b.up) + glm::dot(a.normal, b.normal);
  return std::acos(std::clamp(0.5 * (trace - 1.0), -1.0, 1.0)) * 180.0 / pi;
}

Projector in_world(Projector p, const RigidMotion& motion) {
  p.centre_m = motion.rotation * p.centre_m + motion.translation_m;
  for (glm::dvec3* v : {&p.right, &p.up, &p.normal}) *v = motion.rotation * *v;
  return p;
}

double scale_between(double a, double b) {
  return std::max(a / b, b / a) - 1.0;
}

void add_changes(const Projector& before, const Projector& after, double diagonal_m, FrameChanges& changes) {
  changes.move_share =
      std::max(changes.move_share, glm::distance(before.centre_m, after.centre_m) / diagonal_m);
  changes.scale = std::max({changes.scale, scale_between(before.width_m, after.width_m),
                            scale_between(before.height_m, after.height_m)});
  changes.turn_deg = std::max(changes.turn_deg, angle_deg(before, after));
}

/// Points of one frame with the frames that each has been there and lit: it is the nearest one of the frame
/// before.
struct AgedPoint {
  HighlightPoint point;
  int frames = 0;
  bool is_lit = true;
};

std::vector<AgedPoint> aged(const std::vector<HighlightPoint>& points, const std::vector<AgedPoint>& before,
                            double reach_m, const LightShadow& shadow, const Source& light,
                            const HighlightSurface& surface, const HighlightSize& size) {
  std::vector<AgedPoint> result;
  for (const HighlightPoint& point : points) {
    const AgedPoint* nearest = nullptr;
    double least_m = reach_m;
    for (const AgedPoint& old : before) {
      const double distance_m = glm::distance(old.point.position_m, point.position_m);
      if (old.point.orientation != point.orientation || distance_m > least_m) continue;
      least_m = distance_m;
      nearest = &old;
    }
    const bool is_lit =
        shadow.lit_share(projector_at(surface, point, size), light) > TrackOptions().lit_share;
    result.push_back({point, nearest == nullptr || !is_lit ? 0 : nearest->frames + 1, is_lit});
  }
  return result;
}

/// Whether a highlight that is more than half opaque has its middle here, or is one with this point to the
/// eye.
bool is_covered(const HighlightPoint& point, const std::vector<HighlightTrack>& tracks, double diagonal_m) {
  return std::any_of(tracks.begin(), tracks.end(), [&](const HighlightTrack& track) {
    if (track.opacity <= 0.5) return false;
    const glm::dvec3 q = projection_of(track.projector) * glm::dvec4(point.position_m, 1.0);
    const TrackOptions options;
    return glm::distance(track.projector.centre_m, point.position_m) <= options.part_share * diagonal_m ||
           glm::length(q) < options.part_depth;
  });
}

/// The tracks of a mesh that are drawn, each where and as opaque as it is.
std::vector<HighlightTrack> as_drawn(const world::WorldMesh& view) {
  std::map<std::uint64_t, HighlightTrack> known, drawn;
  for (const HighlightTrack& track : view.tracks()->tracks()) known[track.id] = track;
  for (const DrawnHighlight& highlight : view.highlights()) {
    const auto [place, is_new] = drawn.try_emplace(highlight.id, known[highlight.id]);
    HighlightTrack& track = place->second;
    track.id = highlight.id;
    track.projector = highlight.found;
    track.opacity = highlight.opacity + (is_new ? 0.0 : track.opacity);
  }
  std::vector<HighlightTrack> tracks;
  for (const auto& [id, track] : drawn) tracks.push_back(track);
  return tracks;
}

}  // namespace

RigidMotion TurningMesh::motion(const HighlightSurface& surface, double time_s) const {
  const double frames = std::min(time_s * frames_per_s, static_cast<double>(moving_frames));
  const glm::dmat3 rotation =
      turn_about(glm::normalize(glm::dvec3(0.2, 1.0, 0.1)), frames * degrees_per_frame * pi / 180.0);
  return {rotation, -(rotation * surface.middle_m())};
}

Lighting TurningMesh::world_lighting(const HighlightSurface& surface) const {
  return {{Source::Kind::place, glm::dvec3(0.1, 0.3, 2.0) * surface.diagonal_m()},
          {{Source::Kind::direction, {0.5, 0.8, 0.6}}}};
}

Lighting TurningMesh::lighting(const HighlightSurface& surface, double time_s) const {
  return in_mesh_axes(world_lighting(surface), motion(surface, time_s));
}

LightingAt TurningMesh::lighting_at(const HighlightSurface& surface) const {
  return [this, &surface](double time_s) { return lighting(surface, time_s); };
}

world::WorldMesh view_of(const HighlightSurface& surface, const TurningMesh& turning) {
  world::MeshParameters parameters;
  parameters.name = "turning";
  parameters.mesh = std::make_shared<TriangleMesh>(surface.mesh());
  parameters.curvatures = std::make_shared<VertexCurvatures>(surface.curvatures());
  parameters.motion = [&](double time_s) { return turning.motion(surface, time_s); };
  return {surface.device(), parameters};
}

void show(world::WorldMesh& view, const TurningMesh& turning, double time_s) {
  view.at(
      time_s, [&](double) { return turning.world_lighting(view.surface()); }, 0.0);
}

Coherence turn(world::WorldMesh& view, const TurningMesh& turning) {
  Coherence result;
  const HighlightSurface& surface = view.surface();
  const LightShadow shadow(surface);
  HighlightFinder search(surface.device());
  const double diagonal_m = surface.diagonal_m();
  std::map<std::uint64_t, HighlightTrack> before;
  std::vector<AgedPoint> points;
  std::vector<double> lags;
  std::size_t grown_up = 0, covered = 0;
  RigidMotion motion_before;
  for (int frame = 0; frame < turning.moving_frames; ++frame) {
    const double time_s = frame / turning.frames_per_s;
    show(view, turning, time_s);
    const std::vector<HighlightTrack> tracks = as_drawn(view);
    const RigidMotion motion = turning.motion(surface, time_s);
    const Lighting lighting = turning.lighting(surface, time_s);
    points = aged(search.find(surface, lighting), points, 0.03 * diagonal_m, shadow, lighting.lights[0],
                  surface, view.tracks()->options().size);
    for (const AgedPoint& point : points) {
      result.in_shadow += point.is_lit ? 0 : 1;
      if (point.frames < grown_up_frames) continue;
      ++grown_up;
      covered += static_cast<std::size_t>(is_covered(point.point, tracks, diagonal_m));
    }
    std::map<std::uint64_t, HighlightTrack> now;
    for (const HighlightTrack& track : tracks) {
      now[track.id] = track;
      const auto old = before.find(track.id);
      const double opacity_before = old == before.end() ? 0.0 : old->second.opacity;
      if (frame > 0)
        result.changes.fade = std::max(result.changes.fade, std::abs(track.opacity - opacity_before));
      if (old == before.end()) {
        ++result.births;
        continue;
      }
      const Projector& p = old->second.projector;
      add_changes(p, track.projector, diagonal_m, result.changes);
      add_changes(in_world(p, motion_before), in_world(track.projector, motion), diagonal_m, result.changes);
      const double way_m = glm::distance(old->second.point.position_m, track.point.position_m);
      if (track.state == HighlightTrack::State::alive && way_m > 0.0)
        lags.push_back(glm::distance(track.projector.centre_m, track.point.position_m) / way_m);
      result.mean_shown += track.opacity > 0.5 ? 1.0 : 0.0;
    }
    for (const auto& [id, track] : before) {
      if (now.count(id) == 0) result.changes.fade = std::max(result.changes.fade, track.opacity);
    }
    result.mean_points += static_cast<double>(points.size());
    before = std::move(now);
    motion_before = motion;
  }
  result.covered = grown_up == 0 ? 1.0 : static_cast<double>(covered) / static_cast<double>(grown_up);
  if (!lags.empty()) {
    std::nth_element(lags.begin(), lags.begin() + static_cast<std::ptrdiff_t>(lags.size() / 2), lags.end());
    result.median_lag_frames = lags[lags.size() / 2];
  }
  result.mean_points /= turning.moving_frames;
  result.mean_shown /= turning.moving_frames;
  return result;
}

}  // namespace offing::test
