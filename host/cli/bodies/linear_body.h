#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "host/bodies/floating_body.h"
#include "host/bodies/hydrostatics.h"
#include "host/bodies/panel_method.h"
#include "host/scene/model/scene.h"

namespace offing::cli {

/// A body at rest in still water, by linear theory.
struct LinearBody {
  bodies::FloatingBody body;
  double level_m = 0.0;  ///< of the water, in the axes of its mesh
  bodies::Submerged below;
  std::shared_ptr<const HydrodynamicData> data;  ///< of its file, else of the panel method
  HullMatrix mass{}, restoring{};                ///< about data->about_m
};

/// The bodies of a scene. Throws Error(bad_input) for a scene without any, and what prepare_bodies() throws.
std::vector<LinearBody> linear_bodies(const scene::Scene& scene);

/// Motions as seafarers count them, in this order. Surge is forward, sway to starboard, heave up; roll lowers
/// the starboard side, pitch lifts the bow, yaw turns the bow to port.
inline constexpr std::array<const char*, hull_motions> motion_names{"surge", "sway",  "heave",
                                                                    "roll",  "pitch", "yaw"};
/// Where they stand in a HullWrench.
inline constexpr std::array<std::size_t, hull_motions> motion_places{0, 2, 1, 3, 5, 4};

/// An answer to waves: the motion of the mass centre and the turns, per metre of amplitude (m/m, rad/m), and
/// by how much of a turn each leads the wave's crest at the mass centre.
struct Response {
  std::array<double, hull_motions> amplitude{}, lead_rad{};  ///< [motion_names]
};
/// To waves that travel toward this direction, from the bow toward starboard: 0 from astern, pi from ahead.
Response response_of(const LinearBody& body, double frequency_radps, double direction_rad);

}  // namespace offing::cli
