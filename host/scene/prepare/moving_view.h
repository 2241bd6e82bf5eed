#pragma once

#include <initializer_list>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Gives a moment, which has the scene's elements, the values that these groups' keyframes have at a time.
/// Throws Error(bad_input) for a time beyond 1e8 s.
void move_to(Scene& moment, const Scene& scene, double time_s, std::initializer_list<ParameterGroup> groups);

/// The view of a scene at one time, whatever was asked before: keyframes at their values of that time, and
/// the sun where it stands at its date, lifted by refraction, in sun_direction. Throws
/// Error(bad_input) for a time beyond 1e8 s, and where the sun's clock leaves the years 1900 ... 2100.
ViewScene view_at(const Scene& scene, double time_s);

}  // namespace offing::scene
