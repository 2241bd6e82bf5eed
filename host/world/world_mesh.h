#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/highlights/projectors/drawn_highlights.h"
#include "host/highlights/search/highlight_surface.h"
#include "host/highlights/search/lighting.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/ocl/device.h"
#include "host/world/mesh_parameters.h"

namespace offing::world {

/// What a mesh covers from above, as a disc, and its lowest height.
struct MeshFootprint {
  glm::dvec2 middle_m{0.0};  ///< x, z
  double radius_m = 0.0, bottom_m = 0.0;
};

/// A mesh of a world on a device, and the highlights that eye and lights make on it.
class WorldMesh {
 public:
  /// Throws Error(bad_input) for a mesh that cannot be drawn, Error(out_of_memory) for one that does not fit.
  WorldMesh(const ocl::Device& device, const MeshParameters& parameters);
  WorldMesh(WorldMesh&&) noexcept;
  WorldMesh& operator=(WorldMesh&&) noexcept;
  ~WorldMesh();

  const MeshParameters& parameters() const { return parameters_; }
  bool is_visible() const { return parameters_.material.visible == MeshVisibility::on; }
  /// Another one for each form of each view that was ever made: what is copied from one need not be copied
  /// again.
  std::uint64_t revision() const { return revision_; }
  const highlights::HighlightSurface& surface() const;
  /// Of its box at rest, where the mesh is at this time.
  MeshFootprint footprint_at(double time_s) const;

  // All take effect with the next at() or follow().
  void set_material(const MeshMaterial& material) { parameters_.material = material; }
  void set_rules(std::vector<highlights::HighlightRule> rules) { parameters_.rules = std::move(rules); }
  void set_motion(std::function<highlights::RigidMotion(double time_s)> motion) {
    parameters_.motion = std::move(motion);
  }

  /// The mesh at a time and its highlights, which depend on the times, the lighting and the rules alone,
  /// whatever was shown before. The lighting is that of the world's axes at any time, the same for the same
  /// time and at every call. `first_s` is the time of the first picture of the sequence that this one is of,
  /// not after it: all of them share one past, from a round time ten to twenty seconds before the first on,
  /// in which highlights keep their ids and nothing jumps. A picture alone is the first of its own:
  /// highlights may be turned otherwise there than in a sequence that comes by, as the ends of a line are
  /// alike.
  void at(double time_s, const highlights::LightingAt& lighting, std::optional<double> first_s = {});
  /// The same for an eye that somebody moves: highlights go from where they were toward what this lighting
  /// makes of them, as far as they get since the time of the last call, and a little while time stands. They
  /// start anew where time has jumped.
  void follow(double time_s, const highlights::Lighting& lighting);

  // Of the last at() or follow().

  const highlights::RigidMotion& motion() const { return motion_; }
  /// In the mesh's axes; those that the mesh itself keeps from their light have faded or are gone.
  const std::vector<highlights::DrawnHighlight>& highlights() const;
  /// Of all highlights: DrawnHighlight::first_face.
  const std::vector<std::uint32_t>& highlight_faces() const;
  /// nullptr before the first at() or follow(), and without highlights.
  const highlights::HighlightTracker* tracks() const;

 private:
  struct Shown;

  highlights::RigidMotion motion_at(double time_s) const;
  void deform_to(double time_s);
  void show(const highlights::TrackState& tracks, const highlights::Lighting& lighting_in_mesh_axes);

  MeshParameters parameters_;
  std::uint64_t revision_;
  std::array<glm::dvec3, 2> box_m_;  // least and most
  std::unique_ptr<Shown> shown_;     // what refers to each other stays where it is
  highlights::RigidMotion motion_;
};

}  // namespace offing::world
