#pragma once

#include <glm/vec2.hpp>

#include "host/scene/model/scene.h"
#include "host/sky/sun_position.h"
#include "present/panels/parameter_widget.h"

namespace offing::present {

/// The sky as a map seen from below with north up and east to the right: its zenith at (0, 0), the horizon at
/// distance 1, linear in elevation down to lowest_on_dial_rad below it. x grows to the right, y downward.
glm::dvec2 place_on_dial(const sky::SunAngles& sun);
/// The same backward; beyond the dial its rim counts.
sky::SunAngles sun_of_dial(glm::dvec2 place);
inline constexpr double dial_reach = 1.2;  // of its rim: 18 degrees below the horizon, where night begins

/// Puts the sun there, in the stead of its keyframes and its time.
void place_sun(scene::Scene& scene, const sky::SunAngles& sun);

/// Puts the sun where it stands at an hour (UTC, 0 ... 24) of its day, of a sun without one of a 21 June; in
/// the stead of its keyframes.
void set_hour(scene::Scene& scene, double hour);

/// Draws a button for each of some hours, which puts the sun where it then is on a summer day in middle
/// latitudes.
Edit draw_sun_presets(scene::Scene& scene);

/// Draws the dial, whose knob the mouse drags, and a slider for the hour of the day, which moves the sun as
/// the Earth turns, seen from the scene's latitude. `now` is where it stands.
Edit draw_sun_dial(scene::Scene& scene, const sky::SunAngles& now);

}  // namespace offing::present
