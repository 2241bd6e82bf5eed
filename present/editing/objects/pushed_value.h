#pragma once

#include <string_view>

#include "host/scene/model/scene.h"

namespace offing::present {

/// A value within the range of its row of the parameter table, both in the stored unit.
double within_range(std::string_view key, double value);

/// Adds to a number of an element, and to all of its keyframes. What leaves the range of its row stops at its
/// end. Does nothing to an optional value that the scene does not give.
void push_value(scene::Scene& scene, std::string_view key, scene::ElementIndex element, double way);

/// The same of an angle, which stays within the range of its row by whole turns.
void turn_value(scene::Scene& scene, std::string_view key, scene::ElementIndex element, double way_rad);

}  // namespace offing::present
