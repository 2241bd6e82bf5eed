#pragma once

#include <string>

#include "host/scene/ocean_scene.h"
#include "host/scene/parameter.h"

namespace offing::present {

/// How far an edit of a value has come.
enum class Edit {
  none,
  going_on,  ///< a slider is held
  done,
};

/// Draws a widget for one row of the parameter table, of the kind, range and unit that the row says, and
/// stores what the user enters. `fault` gets the message of a value that was refused.
Edit parameter_widget(scene::OceanScene& scene, const scene::Parameter& row, std::string& fault);

}  // namespace offing::present
