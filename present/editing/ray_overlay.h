#pragma once

#include "host/base/camera.h"
#include "host/terrain/cast/ray.h"
#include "present/editing/terrain_pick.h"
#include "present/panels/panel_layout.h"

namespace offing::present {

/// Draws a picked ray behind ImGui's windows, as this camera sees it: the ray, the maxima of the nodes that
/// it met, coloured by level, those that it went into with broad lines, and the cells whose patches it was
/// tested against.
void draw_ray_overlay(const TerrainPick& pick, const world::WorldTerrain& terrain, const Camera& camera);

/// Draws the colours of steps with their numbers (terrain::step_colours), as an ImGui window.
void draw_step_legend(PanelLayout& layout);

}  // namespace offing::present
