#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "host/clouds/shape/cloud_parameters.h"
#include "present/editing/cloud_edits.h"
#include "present/editing/particle_picks.h"

namespace offing::present {

/// What clicks on clouds pick.
enum class CloudPick { none, balls, clouds, particles };
inline constexpr std::array<const char*, 4> cloud_pick_names{"nothing", "balls", "clouds", "particles"};

/// What a click does while clouds are edited.
enum class CloudTool { pick, place_ball, place_cloud };

/// What is picked of clouds, and what the next click makes.
struct CloudEditing {
  CloudPick pick = CloudPick::none;
  CloudTool tool = CloudTool::pick;
  std::vector<CloudPart> picked = {};  ///< balls or whole clouds; the last one has the handles
  PickedParticles particles = {};
  clouds::Genus genus = clouds::Genus::cumulus;  ///< of what is placed next
  double new_radius_m = 150.0;                   ///< of a ball that is placed next
  double step_m = 50.0;                          ///< that handles snap to while Ctrl is held

  void forget_picks() {
    picked.clear();
    particles = {};
  }
};

}  // namespace offing::present
