#include "present/parameter_widget.h"

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <type_traits>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/base/error.h"

namespace offing::present {
namespace {

using scene::OceanScene;
using scene::Parameter;
using scene::WrittenValue;

/// Through the table's own checks, as a scene file's values go.
bool try_store(OceanScene& scene, const Parameter& row, const WrittenValue& written, std::string& fault) {
  try {
    scene::store(scene, row, written, {.subject = std::string(row.key), .assignment = ""});
    fault.clear();
    return true;
  } catch (const Error& error) {
    fault = error.what();
    return false;
  }
}

Edit edit_state(bool is_changed) {
  if (ImGui::IsItemDeactivatedAfterEdit()) return Edit::done;
  return is_changed ? Edit::going_on : Edit::none;
}

/// A slider where the range is short, on a logarithmic scale where it spans decades, a field to drag where it
/// is both long and signed.
bool number_slider(const char* label, const Parameter& row, double& value) {
  constexpr ImGuiSliderFlags clamp = ImGuiSliderFlags_AlwaysClamp;
  constexpr double long_range = 1e5, decades = 1e3;
  const bool is_logarithmic = row.low > 0.0 && row.high / row.low >= decades;
  if (!is_logarithmic && row.high - row.low > long_range) {
    return ImGui::DragScalar(label, ImGuiDataType_Double, &value, 0.5f, &row.low, &row.high, "%.6g", clamp);
  }
  const ImGuiSliderFlags flags = clamp | (is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  return ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &row.low, &row.high, "%.5g", flags);
}

class Widget {
 public:
  Widget(OceanScene& scene, const Parameter& row, std::string& fault)
      : scene_(scene), row_(row), fault_(fault), label_(label_of(row)) {}

  Edit operator()(double& (*at)(OceanScene&)) { return number(at(scene_)); }

  Edit operator()(std::optional<double>& (*at)(OceanScene&)) {
    bool is_set = at(scene_).has_value();
    const bool was_set = is_set;
    ImGui::Checkbox(fmt::format("##set {}", row_.key).c_str(), &is_set);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("without: %s", std::string(row_.absent).c_str());
    ImGui::SameLine();
    if (is_set && !was_set) {
      try_store(scene_, row_, scene::read_flag_value(row_, row_.example), fault_);
      return Edit::done;
    }
    if (!is_set) {
      at(scene_).reset();
      ImGui::TextDisabled("%s: %s", label_.c_str(), std::string(row_.absent).c_str());
      return was_set ? Edit::done : Edit::none;
    }
    return number(*at(scene_));
  }

  Edit operator()(int& (*at)(OceanScene&)) {
    return row_.rule == scene::ParameterRule::power_of_two ? power_of_two(at(scene_)) : whole(at(scene_));
  }

  Edit operator()(std::uint64_t& (*at)(OceanScene&)) {
    constexpr std::uint64_t step = 1;
    std::uint64_t value = at(scene_);
    const bool is_changed = ImGui::InputScalar(label_.c_str(), ImGuiDataType_U64, &value, &step);
    if (is_changed && value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
      at(scene_) = value;
      return Edit::done;
    }
    return Edit::none;
  }

  Edit operator()(std::string& (*at)(OceanScene&)) {
    std::string text = at(scene_);
    if (!ImGui::InputText(label_.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue)) return Edit::none;
    if (text.empty()) {
      at(scene_).clear();
      return Edit::done;
    }
    return try_store(scene_, row_, {.value = text, .shown = text}, fault_) ? Edit::done : Edit::none;
  }

  /// Numbers between commas; nothing for the default.
  Edit operator()(std::vector<double>& (*at)(OceanScene&)) {
    std::string text = at(scene_).empty() ? "" : scene::value_text(scene_, row_);
    if (!ImGui::InputText(label_.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue)) return Edit::none;
    const std::vector<double> before = at(scene_);
    at(scene_).clear();
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
      part.erase(0, part.find_first_not_of(' '));
      if (try_store(scene_, row_, scene::read_flag_value(row_, part), fault_)) continue;
      at(scene_) = before;
      return Edit::none;
    }
    return Edit::done;
  }

  Edit operator()(const scene::ChoiceStorage& choice) {
    const std::size_t chosen = choice.get(scene_);
    Edit edit = Edit::none;
    if (!ImGui::BeginCombo(label_.c_str(), std::string(choice.names[chosen]).c_str())) return edit;
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      if (ImGui::Selectable(std::string(choice.names[i]).c_str(), i == chosen)) {
        choice.set(scene_, i);
        edit = Edit::done;
      }
    }
    ImGui::EndCombo();
    return edit;
  }

 private:
  static std::string label_of(const Parameter& row) {
    const std::string name(row.key.substr(row.key.rfind('.') + 1));
    return fmt::format("{}##{}", name, row.key);
  }

  Edit number(double& stored) {
    double value = stored / row_.scale;
    const bool is_changed = number_slider(label_.c_str(), row_, value);
    if (is_changed) stored = value * row_.scale;
    return edit_state(is_changed);
  }

  Edit whole(int& stored) {
    const bool is_changed = ImGui::DragInt(label_.c_str(), &stored, 0.1f, static_cast<int>(row_.low),
                                           static_cast<int>(row_.high), "%d", ImGuiSliderFlags_AlwaysClamp);
    return edit_state(is_changed);
  }

  Edit power_of_two(int& stored) {
    Edit edit = Edit::none;
    if (!ImGui::BeginCombo(label_.c_str(), fmt::format("{}", stored).c_str())) return edit;
    for (int value = static_cast<int>(row_.low); value <= static_cast<int>(row_.high); value *= 2) {
      if (ImGui::Selectable(fmt::format("{}", value).c_str(), value == stored)) {
        stored = value;
        edit = Edit::done;
      }
    }
    ImGui::EndCombo();
    return edit;
  }

  OceanScene& scene_;
  const Parameter& row_;
  std::string& fault_;
  std::string label_;
};

}  // namespace

Edit parameter_widget(OceanScene& scene, const Parameter& row, std::string& fault) {
  const Edit edit = std::visit(Widget(scene, row, fault), row.storage);
  if (ImGui::IsItemHovered() && !row.help.empty()) {
    ImGui::SetTooltip("%s%s%s", std::string(row.help).c_str(), row.unit.empty() ? "" : ", in ",
                      std::string(row.unit).c_str());
  }
  return edit;
}

}  // namespace offing::present
