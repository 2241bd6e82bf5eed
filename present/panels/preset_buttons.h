#pragma once

#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"
#include "present/panels/parameter_widget.h"

namespace offing::present {

/// A button for each preset of a group, with the last word of its name; those of a list set an element of it.
Edit draw_presets(scene::Scene& scene, scene::ParameterGroup group, scene::ElementIndex element = {});

}  // namespace offing::present
