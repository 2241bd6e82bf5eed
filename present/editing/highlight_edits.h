#pragma once

#include <optional>
#include <vector>

#include "host/highlights/projectors/drawn_highlights.h"
#include "host/scene/model/scene.h"
#include "present/editing/mesh_picker.h"

namespace offing::present {

/// The picked highlight; nullptr where none is, or it is gone.
const highlights::DrawnHighlight* picked_highlight(const scene::Scene& scene,
                                                   const std::vector<world::WorldMesh>& meshes,
                                                   const std::optional<HighlightName>& picked);

/// Where a scene has the controls of a highlight: the [[mesh.highlight]] that it is drawn by. One that is
/// drawn as found gets one of its own, for the highlight of its light that is nearest to where it is now.
scene::ElementIndex controls_of(scene::Scene& scene, const HighlightName& name,
                                const highlights::DrawnHighlight& highlight);

/// Gives them these controls at a time: values with keyframes get one there, all others are changed for good.
void store_controls(scene::Scene& scene, scene::ElementIndex element,
                    const highlights::HighlightControls& controls, double time_s);

/// Keyframes of all controls that can have them, with these values at this time; one that is there already is
/// replaced.
void store_keys(scene::Scene& scene, scene::ElementIndex element,
                const highlights::HighlightControls& controls, double time_s);

/// Whether any of them has keyframes.
bool has_keys(const scene::Scene& scene, scene::ElementIndex element);

/// Takes all their keyframes away: from here on they are these.
void remove_keys(scene::Scene& scene, scene::ElementIndex element,
                 const highlights::HighlightControls& controls);

}  // namespace offing::present
