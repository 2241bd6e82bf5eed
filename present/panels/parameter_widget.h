#pragma once

#include <any>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"

namespace offing::present {

/// How far an edit of a value has come.
enum class Edit {
  none,
  refused,     ///< the table does not take the value, or the world did not while it was held
  taken_back,  ///< a hand let go where it took hold: all is as before that
  going_on,    ///< a slider is held, a number is typed
  done,
};

/// A slider that the mouse holds, or has just let go of.
struct HeldSlider {
  unsigned id = 0;     ///< that ImGui knows it by; 0: none
  double value = 0.0;  ///< before
  bool is_dragged = false;
  bool opens = false;  ///< in the next frame
};

/// What is kept while a value is edited, one at a time, and what widgets show beside the scene.
struct EditInProgress {
  std::any before = {};                                                ///< the value
  std::vector<std::pair<scene::ValueKey, KeyframeTrack>> tracks = {};  ///< its keyframes
  std::string fault = {};                       ///< why the last value was refused; empty if it was taken
  std::optional<scene::ValueKey> browsed = {};  ///< a row whose file is to be chosen in a dialog
  HeldSlider slider = {};
  std::map<std::string_view, double> computed = {};  ///< values that the scene leaves open, by their keys
};

/// A row's name in words, without its unit: "direction" of `wind.direction_deg`.
std::string words_of(const scene::Parameter& row);
/// The text beside a row's widget, and behind ## the key that ImGui knows it by.
std::string parameter_label(const scene::Parameter& row);

/// Draws a widget for one row of the parameter table, of the kind, range and unit that the row says, and
/// stores what the user enters if the table takes it. When an edit ends with a value that it does not take,
/// the value is as it was before the edit. A row that names a file has a button that asks for a dialog.
/// `element` is that of a repeated section.
Edit parameter_widget(scene::Scene& scene, const scene::Parameter& row, EditInProgress& edit,
                      scene::ElementIndex element = {});

}  // namespace offing::present
