#include "host/world/world_mesh.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "host/highlights/curvature/diffused_curvature.h"
#include "host/highlights/tracks/nearest_place.h"

namespace offing::world {
namespace {

std::array<glm::dvec3, 2> box_of(const std::vector<glm::dvec3>& positions_m) {
  std::array<glm::dvec3, 2> box_m{positions_m.front(), positions_m.front()};
  for (const glm::dvec3& position_m : positions_m)
    box_m = {glm::min(box_m[0], position_m), glm::max(box_m[1], position_m)};
  return box_m;
}

// Pictures have a past of one to two of these before the first, longer than highlights take to fade or to
// reach their places; it begins at 0 where that is within two.
constexpr double past_s = 10.0;
// Time jumps where a frame takes it further than that, and passes at least this much for who flies while it
// stands.
constexpr double longest_frame_s = 0.5, least_frame_s = 1.0 / 30.0;

/// A function of the first picture's time alone, so that highlights are.
double start_of_past(double first_s) {
  if (first_s >= 0.0 && first_s < 2.0 * past_s) return 0.0;
  return past_s * (std::floor(first_s / past_s) - 1.0);
}

highlights::HighlightSurface surface_of(const ocl::Device& device, const MeshParameters& parameters) {
  return {device, *parameters.mesh,
          parameters.curvatures ? *parameters.curvatures
                                : highlights::diffused_curvatures(device, *parameters.mesh),
          parameters.surface};
}

std::uint64_t next_revision() {
  static std::atomic<std::uint64_t> revisions{0};
  return ++revisions;
}

}  // namespace

struct WorldMesh::Shown {
  explicit Shown(highlights::HighlightSurface made) : surface(std::move(made)) {}

  /// The tracks, which start with the lighting at hand.
  highlights::HighlightTracker& tracks_of(highlights::TrackOptions options) {
    if (!tracks) {
      options.has_shadows = true;
      tracks.emplace(
          surface, [this](double time_s) { return lighting(time_s); }, options);
      drawn.emplace(surface, tracks->options().size);
    }
    return *tracks;
  }

  highlights::HighlightSurface surface;
  std::optional<highlights::DiffusedCurvature> curvature;  // of a mesh that deforms
  std::optional<double> formed_at_s;                       // time of the surface's form; none: at rest
  highlights::LightingAt lighting;                         // in the mesh's axes
  std::optional<highlights::HighlightTracker> tracks;
  std::optional<highlights::HighlightDrawing> drawn;
  std::optional<double> start_s;        // of the past that the tracks have; none: they follow
  std::optional<double> followed_to_s;  // time of the last follow()
  double passed_s = 0.0;                // for tracks that follow
};

WorldMesh::WorldMesh(const ocl::Device& device, const MeshParameters& parameters)
    : parameters_(parameters),
      revision_(next_revision()),
      box_m_(box_of(parameters.mesh->positions_m)),
      shown_(std::make_unique<Shown>(surface_of(device, parameters))) {
  if (parameters.deformation) shown_->curvature.emplace(device, *parameters.mesh);
}

WorldMesh::WorldMesh(WorldMesh&&) noexcept = default;
WorldMesh& WorldMesh::operator=(WorldMesh&&) noexcept = default;
WorldMesh::~WorldMesh() = default;

MeshFootprint WorldMesh::footprint_at(double time_s) const {
  const highlights::RigidMotion motion = motion_at(time_s);
  const auto moved_m = [&](const glm::dvec3& place_m) {
    return motion.rotation * place_m + motion.translation_m;
  };
  const glm::dvec3 middle_m = moved_m(0.5 * (box_m_[0] + box_m_[1]));
  MeshFootprint footprint{.middle_m = {middle_m.x, middle_m.z}, .bottom_m = middle_m.y};
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const glm::dvec3 corner_m =
        moved_m({box_m_[corner & 1].x, box_m_[corner >> 1 & 1].y, box_m_[corner >> 2].z});
    footprint.radius_m =
        std::max(footprint.radius_m, std::hypot(corner_m.x - middle_m.x, corner_m.z - middle_m.z));
    footprint.bottom_m = std::min(footprint.bottom_m, corner_m.y);
  }
  return footprint;
}

const highlights::HighlightSurface& WorldMesh::surface() const {
  return shown_->surface;
}

const std::vector<highlights::DrawnHighlight>& WorldMesh::highlights() const {
  static const std::vector<highlights::DrawnHighlight> none;
  return shown_->drawn ? shown_->drawn->highlights() : none;
}

const std::vector<std::uint32_t>& WorldMesh::highlight_faces() const {
  static const std::vector<std::uint32_t> none;
  return shown_->drawn ? shown_->drawn->faces() : none;
}

const highlights::HighlightTracker* WorldMesh::tracks() const {
  return shown_->tracks ? &*shown_->tracks : nullptr;
}

highlights::RigidMotion WorldMesh::motion_at(double time_s) const {
  return parameters_.motion ? parameters_.motion(time_s) : highlights::RigidMotion{};
}

void WorldMesh::deform_to(double time_s) {
  const Deformation& deformation = parameters_.deformation;
  const double form_s = std::clamp(time_s, 0.0, deformation.end_s);
  if (!deformation || shown_->formed_at_s == form_s) return;
  MeshForm form = deformation.form_at(form_s);
  VertexCurvatures curvatures = shown_->curvature->of(form.positions_m);
  shown_->surface.deform(std::move(form.positions_m), std::move(form.normals), std::move(curvatures));
  shown_->formed_at_s = form_s;
  revision_ = next_revision();
}

void WorldMesh::at(double time_s, const highlights::LightingAt& lighting, std::optional<double> first_s) {
  motion_ = motion_at(time_s);
  if (!parameters_.has_highlights) {
    deform_to(time_s);
    return;
  }
  shown_->lighting = [this, lighting](double past_time_s) {
    deform_to(past_time_s);
    return in_mesh_axes(lighting(past_time_s), motion_at(past_time_s));
  };
  highlights::HighlightTracker& tracks = shown_->tracks_of(parameters_.tracks);
  const double start_s = start_of_past(first_s.value_or(time_s));
  // Rules for the nearest have a past too.
  const std::vector<highlights::NearestPlace> places = highlights::nearest_places(parameters_.rules);
  const bool has_this_past = shown_->start_s == start_s && tracks.state().places == places;
  tracks.set_places(places);
  if (!has_this_past) tracks.reset(start_s);
  shown_->start_s = start_s;
  const highlights::TrackState& shown = tracks.shown_at(time_s);
  show(shown, shown_->lighting(time_s));
}

void WorldMesh::follow(double time_s, const highlights::Lighting& lighting) {
  motion_ = motion_at(time_s);
  deform_to(time_s);
  if (!parameters_.has_highlights) return;
  const highlights::Lighting in_axes = in_mesh_axes(lighting, motion_);
  shown_->lighting = [in_axes](double) { return in_axes; };
  highlights::HighlightTracker& tracks = shown_->tracks_of(parameters_.tracks);
  const double frame_s = shown_->followed_to_s ? time_s - *shown_->followed_to_s : -1.0;
  tracks.set_places(highlights::nearest_places(parameters_.rules));
  const bool goes_on = !shown_->start_s && frame_s >= 0.0 && frame_s <= longest_frame_s;
  if (goes_on) {
    shown_->passed_s += std::max(frame_s, least_frame_s);
    tracks.advance_to(shown_->passed_s);
  } else {
    shown_->passed_s = 0.0;
    tracks.reset(0.0, highlights::KeyStates::none);
  }
  shown_->start_s.reset();
  shown_->followed_to_s = time_s;
  show(tracks.state(), in_axes);
}

void WorldMesh::show(const highlights::TrackState& tracks, const highlights::Lighting& lighting) {
  shown_->drawn->update(tracks, parameters_.rules, static_cast<int>(lighting.lights.size()));
}

}  // namespace offing::world
