#pragma once

#include <optional>

#include "present/editing/objects/scene_objects.h"
#include "present/panels/panels.h"

namespace offing::present {

/// The object that is selected, in the list of objects or in the picture: of clouds the one with what is
/// picked last. Nothing where the scene does not have it any more.
std::optional<SceneObject> selected_object(const ViewState& state);

/// Selects an object and nothing else; clicks then pick what it is one of.
void select_object(ViewState& state, const SceneObject& object);

/// Selects nothing; false if nothing was selected.
bool deselect_objects(ViewState& state);

}  // namespace offing::present
