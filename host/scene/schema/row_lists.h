// The rows of the parameter table, a function a part of a scene.
#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of [[body]].
std::vector<Parameter> body_parameters();

/// The rows of the parameter table for views to come back to: those of [camera] that say where the eye is and
/// where it looks, and a name.
std::vector<Parameter> bookmark_parameters();

/// The rows of the parameter table for clouds: what is common to all, layers of many, and single ones.
std::vector<Parameter> cloud_parameters();

/// The rows of the parameter table for the shape, the noise, the look and the motion of a cloud.
std::vector<Parameter> cloud_shape_parameters();

/// The rows of the parameter table for waves beside the spectrum's: [[ocean.swell]], [[ocean.raindrop]].
std::vector<Parameter> extra_wave_parameters();

/// Rows of the parameter table for the highlights of meshes.
std::vector<Parameter> highlight_parameters();

/// Rows of the parameter table for lights beside the sun.
std::vector<Parameter> light_parameters();

/// Rows of the parameter table for meshes and what they look like.
std::vector<Parameter> mesh_parameters();

/// The rows of the parameter table for edits of particles of clouds by hand.
std::vector<Parameter> particle_edit_parameters();

/// The rows of the parameter table for the energy of a sea: its spectrum, modelled or measured, and its
/// water.
std::vector<Parameter> sea_parameters();

/// The rows of the parameter table for what lights a picture: sun and air.
std::vector<Parameter> sky_parameters();

/// The rows of the parameter table for the ground: [terrain].
std::vector<Parameter> terrain_parameters();

/// The rows of the parameter table for the eye of a picture: camera and exposure.
std::vector<Parameter> view_parameters();

/// The rows of the parameter table for wakes: [[ocean.wake]] and [[ocean.wake.hull]].
std::vector<Parameter> wake_sections();

}  // namespace offing::scene
