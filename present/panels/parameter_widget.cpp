#include "present/panels/parameter_widget.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "host/base/error.h"
#include "host/scene/schema/unused_parameters.h"
#include "present/panels/panel_layout.h"

namespace offing::present {
namespace {

using scene::Parameter;
using scene::Scene;
using scene::WrittenValue;

/// "%.6g m/s", as ImGui formats a value.
std::string format_of(const Parameter& row) {
  return row.unit.empty() ? "%.6g" : fmt::format("%.6g {}", row.unit);
}

/// A slider that a drag moves, and that a click opens to type a value. ImGui's own jumps to where it is
/// clicked, and opens after a click with Ctrl alone.
bool slider(const char* label, HeldSlider& held, double& value, const scene::SliderRange& range,
            const char* format, ImGuiSliderFlags flags) {
  ImGuiIO& io = ImGui::GetIO();
  const ImGuiID id = ImGui::GetID(label);
  const bool opens = held.id == id && held.opens;
  const bool was_clicked = io.MouseClicked[0], was_ctrl_held = io.KeyCtrl;
  if (opens) {
    held = {};
    io.MouseClicked[0] = io.KeyCtrl = true;
  }
  const double before = value;
  const bool is_changed =
      ImGui::SliderScalar(label, ImGuiDataType_Double, &value, &range.low, &range.high, format, flags);
  io.MouseClicked[0] = was_clicked;
  io.KeyCtrl = was_ctrl_held;
  if (ImGui::IsItemActivated() && !opens && !was_ctrl_held) held = {.id = id, .value = before};
  if (held.id != id) return is_changed;
  held.is_dragged |= ImGui::IsMouseDragging(ImGuiMouseButton_Left);
  const bool is_let_go = ImGui::IsItemDeactivated();
  if (held.is_dragged || !(is_let_go || ImGui::IsItemActive())) {
    if (!ImGui::IsItemActive()) held = {};
    return is_changed;
  }
  value = held.value;
  held.opens = is_let_go;
  return false;
}

/// A slider where the range is short, on a logarithmic scale where it spans decades, a field to drag where it
/// is both long and signed. Numbers that are typed are checked by the table.
bool number_slider(const char* label, const Parameter& row, HeldSlider& held, double& value) {
  constexpr double long_range = 1e5, decades = 1e3;
  constexpr float drag_speed = 0.5f;  // units a pixel
  const auto [low, high] = row.slider.value_or(scene::SliderRange{row.low, row.high});
  const std::string format = format_of(row);
  const bool is_logarithmic = low > 0.0 && high / low >= decades;
  if (!is_logarithmic && high - low > long_range) {
    return ImGui::DragScalar(label, ImGuiDataType_Double, &value, drag_speed, &low, &high, format.c_str());
  }
  return slider(label, held, value, {low, high}, format.c_str(),
                is_logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
}

// IEC 61966-2-1, continued above 1.
glm::dvec3 srgb_of(const glm::dvec3& linear) {
  const auto curve = [](double x) {
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  };
  return {curve(linear.x), curve(linear.y), curve(linear.z)};
}

glm::dvec3 linear_of(const glm::dvec3& srgb) {
  const auto curve = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return {curve(srgb.x), curve(srgb.y), curve(srgb.z)};
}

/// Of a choice, as people say it.
std::string shown_choice(std::string_view name) {
  if (name == "as_genus") return "usual";
  return std::string(name);
}

/// One kind of widget for each alternative of scene::Storage.
class Widget {
 public:
  Widget(Scene& scene, const Parameter& row, EditInProgress& edit, scene::ElementIndex element)
      : scene_(scene),
        row_(row),
        edit_(edit),
        element_(element),
        section_(scene::struct_at(&scene, *row.section, element)),
        label_(parameter_label(row)) {}

  Edit operator()(scene::ValueAt<double> at) { return number(at.in(section_)); }

  Edit operator()(scene::ValueAt<std::optional<double>> at) {
    return optional_value(at.in(section_), [&](double& value) { return number(value); });
  }

  Edit operator()(scene::ValueAt<glm::dvec3> at) { return triple(at.in(section_)); }

  Edit operator()(scene::ValueAt<std::optional<glm::dvec3>> at) {
    return optional_value(at.in(section_), [&](glm::dvec3& value) { return triple(value); });
  }

  Edit operator()(scene::ValueAt<int> at) {
    if (row_.rule == scene::ParameterRule::power_of_two) return power_of_two(at.in(section_));
    constexpr float drag_speed = 0.1f;
    int value = at.in(section_);
    const bool is_changed = ImGui::DragInt(label_.c_str(), &value, drag_speed, static_cast<int>(row_.low),
                                           static_cast<int>(row_.high));
    return stored(is_changed, {.value = std::int64_t{value}, .shown = fmt::format("{}", value)});
  }

  Edit operator()(scene::ValueAt<std::uint64_t> at) {
    std::uint64_t value = at.in(section_);
    const bool is_changed = ImGui::InputScalar(label_.c_str(), ImGuiDataType_U64, &value);
    return stored(is_changed, scene::read_flag_value(row_, fmt::format("{}", value)));
  }

  Edit operator()(scene::ValueAt<std::string> at) {
    if (row_.rule == scene::ParameterRule::file_name) browse_button();
    std::string text = at.in(section_);
    if (!is_entered(text)) return Edit::none;
    if (text.empty()) {
      at.in(section_).clear();
      return Edit::done;
    }
    return is_taken({.value = text, .shown = text}) ? Edit::done : Edit::refused;
  }

  Edit operator()(scene::ValueAt<std::optional<UtcTime>> at) {
    std::string text = at.in(section_) ? scene::text_in(section_, row_, scene::Digits::readable) : "";
    if (!is_entered(text)) return Edit::none;
    if (text.empty()) {
      at.in(section_).reset();
      return Edit::done;
    }
    return is_taken({.value = text, .shown = text}) ? Edit::done : Edit::refused;
  }

  /// Numbers between commas; nothing for the default.
  Edit operator()(scene::ValueAt<std::vector<double>> at) {
    std::string text = at.in(section_).empty() ? "" : scene::text_in(section_, row_, scene::Digits::readable);
    if (!is_entered(text)) return Edit::none;
    const std::vector<double> before = at.in(section_);
    at.in(section_).clear();
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) {
      part.erase(0, part.find_first_not_of(' '));
      if (is_taken(scene::read_flag_value(row_, part))) continue;
      at.in(section_) = before;
      return Edit::refused;
    }
    return Edit::done;
  }

  Edit operator()(const scene::ChoiceStorage& choice) {
    const std::size_t chosen = choice.in(section_);
    Edit edit = Edit::none;
    if (!ImGui::BeginCombo(label_.c_str(), shown_choice(choice.names[chosen]).c_str())) return edit;
    for (std::size_t i = 0; i < choice.names.size(); ++i) {
      if (ImGui::Selectable(shown_choice(choice.names[i]).c_str(), i == chosen)) {
        choice.set_in(section_, i);
        edit = Edit::done;
      }
    }
    ImGui::EndCombo();
    return edit;
  }

 private:
  /// Through the table's own checks, as a scene file's values go.
  bool is_taken(const WrittenValue& written) {
    try {
      const scene::Place place{.subject = std::string(row_.key), .assignment = ""};
      scene::store(scene_, row_, written, place, element_);
      edit_.fault.clear();
      return true;
    } catch (const Error& error) {
      edit_.fault = error.what();
      return false;
    }
  }

  template <class Value, class Draw>
  Edit optional_value(std::optional<Value>& at, Draw draw) {
    const bool was_set = at.has_value();
    bool is_set = was_set;
    ImGui::Checkbox(fmt::format("##set {}", row_.key).c_str(), &is_set);
    if (ImGui::IsItemHovered()) explain_item(fmt::format("without: {}", row_.absent));
    ImGui::SameLine();
    if (is_set && !was_set) {
      return is_taken(scene::read_flag_value(row_, row_.example)) ? Edit::done : Edit::refused;
    }
    if (is_set) return draw(*at);
    at.reset();
    draw_absent();
    return was_set ? Edit::done : Edit::none;
  }

  /// In the place of a widget, with the name beside it.
  void draw_absent() {
    const float width = ImGui::CalcItemWidth();
    const std::string text = absent_text(width);
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 0.5f * (width - ImGui::CalcTextSize(text.c_str()).x));
    ImGui::TextDisabled("%s", text.c_str());
    ImGui::SameLine(width + ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextDisabled("%s", words_of(row_).c_str());
    ImGui::EndGroup();
  }

  /// What holds without a value: as a number, if it is known, else in words, if they have room.
  std::string absent_text(float width) const {
    const auto computed = edit_.computed.find(row_.key);
    if (computed != edit_.computed.end()) return fmt::format("auto: {:.3g}", computed->second);
    const std::string words(row_.absent.substr(0, row_.absent.find_first_of(":;,")));
    return ImGui::CalcTextSize(words.c_str()).x <= width ? words : "auto";
  }

  Edit number(double& at) {
    double value = at / row_.scale;
    const bool is_changed = number_slider(label_.c_str(), row_, edit_.slider, value);
    return stored(is_changed, {.value = value, .shown = fmt::format("{:g}", value)});
  }

  Edit triple(const glm::dvec3& at) {
    const Edit picked = is_colour() ? colour_button(at) : Edit::none;
    glm::dvec3 value = at / row_.scale;
    constexpr double finest = 0.01, share = 1e-3;
    const double across = row_.high - row_.low;
    // Units a pixel; what has a slider's range is dragged across it in a thousand.
    const double speed =
        row_.slider ? share * (row_.slider->high - row_.slider->low) : std::min(finest, share * across);
    const bool is_changed =
        ImGui::DragScalarN(label_.c_str(), ImGuiDataType_Double, &value.x, 3, static_cast<float>(speed),
                           &row_.low, &row_.high, format_of(row_).c_str());
    return std::max(picked, stored(is_changed, written(value)));
  }

  static WrittenValue written(const glm::dvec3& value) {
    return {.value = std::vector<double>{value.x, value.y, value.z},
            .shown = fmt::format("[{:g}, {:g}, {:g}]", value.x, value.y, value.z)};
  }

  bool is_colour() const { return row_.unit.empty() && scene::name_of(row_.key).ends_with("colour"); }

  /// The next item goes beside the last one, and both take the width of one.
  void make_room_beside_button() {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float taken = ImGui::GetItemRectSize().x + gap;
    ImGui::SameLine(0.0f, gap);
    ImGui::SetNextItemWidth(std::max(1.0f, ImGui::CalcItemWidth() - taken));
  }

  void browse_button() {
    if (ImGui::Button(fmt::format("...##browse {}", row_.key).c_str()))
      edit_.browsed = scene::ValueKey(row_.key, element_);
    explain_item("choose a file");
    make_room_beside_button();
  }

  /// A button of the colour, which opens a picker. The picker shows sRGB, the value is linear.
  Edit colour_button(const glm::dvec3& at) {
    const glm::vec3 before(srgb_of(at));
    glm::vec3 picked = before;
    ImGuiColorEditFlags flags =
        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_Float;
    if (row_.high > 1.0) flags |= ImGuiColorEditFlags_HDR;
    const bool is_changed = ImGui::ColorEdit3(fmt::format("##pick {}", row_.key).c_str(), &picked.x, flags);
    glm::dvec3 value = at;
    // What was not moved keeps all its digits.
    for (int i = 0; i < 3; ++i) {
      if (picked[i] != before[i])
        value[i] = std::clamp(linear_of(glm::dvec3(picked))[i], row_.low, row_.high);
    }
    const Edit edit = stored(is_changed, written(value));
    make_room_beside_button();
    return edit;
  }

  /// Stores the value of the last item, if it changed.
  Edit stored(bool is_changed, const WrittenValue& value) {
    if (ImGui::IsItemActivated()) {
      remember();
      edit_.fault.clear();
    }
    Edit edit = Edit::none;
    if (is_changed) edit = is_taken(value) ? Edit::going_on : Edit::refused;
    if (!ImGui::IsItemDeactivatedAfterEdit()) return edit;
    if (edit_.fault.empty()) return Edit::done;
    put_back();
    return Edit::refused;
  }

  void remember() {
    edit_.before = scene::value_in(section_, row_);
    edit_.tracks.clear();
    for (std::size_t number = 0; number < 3; ++number) {
      const auto track = scene_.tracks.find({row_.key, element_, number});
      if (track != scene_.tracks.end()) edit_.tracks.emplace_back(*track);
    }
  }

  void put_back() {
    scene::put_in(section_, row_, edit_.before);
    for (const auto& track : edit_.tracks) scene_.tracks.insert(track);
  }

  /// Whether another text was entered: the old one may show fewer digits than there are.
  bool is_entered(std::string& text) {
    const std::string shown = text;
    return ImGui::InputText(label_.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue) && text != shown;
  }

  Edit power_of_two(int& at) {
    Edit edit = Edit::none;
    if (!ImGui::BeginCombo(label_.c_str(), fmt::format("{}", at).c_str())) return edit;
    for (int value = static_cast<int>(row_.low); value <= static_cast<int>(row_.high); value *= 2) {
      if (ImGui::Selectable(fmt::format("{}", value).c_str(), value == at)) {
        at = value;
        edit = Edit::done;
      }
    }
    ImGui::EndCombo();
    return edit;
  }

  Scene& scene_;
  const Parameter& row_;
  EditInProgress& edit_;
  scene::ElementIndex element_;
  void* section_;  // its struct
  std::string label_;
};

/// Whether text is typed and taken with Enter.
bool is_text(const Parameter& row) {
  return std::holds_alternative<scene::ValueAt<std::string>>(row.storage) ||
         std::holds_alternative<scene::ValueAt<std::optional<UtcTime>>>(row.storage) ||
         std::holds_alternative<scene::ValueAt<std::vector<double>>>(row.storage);
}

struct NamedWords {
  std::string_view name, words;
};

/// The words of a name; `absent` where it has none.
std::string_view words_in(std::span<const NamedWords> all, std::string_view name, std::string_view absent) {
  const auto found = std::ranges::find(all, name, &NamedWords::name);
  return found == all.end() ? absent : found->words;
}

/// The end of a key that says the unit, as those of the table are written.
std::string_view ending_of(std::string_view unit) {
  static constexpr auto endings = std::to_array<NamedWords>({{"m", "_m"},
                                                             {"s", "_s"},
                                                             {"deg", "_deg"},
                                                             {"m/s", "_mps"},
                                                             {"Hz", "_hz"},
                                                             {"m/s^2", "_mps2"},
                                                             {"1/m", "_per_m"},
                                                             {"1/s", "_per_s"},
                                                             {"kg", "_kg"},
                                                             {"kg/m3", "_kgpm3"},
                                                             {"N", "_n"},
                                                             {"N/m", "_npm"},
                                                             {"K", "_k"},
                                                             {"Pa", "_pa"},
                                                             {"DU", "_du"},
                                                             {"klx", "_klx"},
                                                             {"um", "_um"},
                                                             {"MiB", "_mb"},
                                                             {"m2", "_m2"},
                                                             {"1/(m2 s)", "_per_m2s"},
                                                             {"deg/s", "_deg_per_s"}});
  return words_in(endings, unit, {});
}

/// What a part of a key stands for, where that is no word.
std::string_view word_for(std::string_view part) {
  static constexpr auto words = std::to_array<NamedWords>({{"hs", "wave height"},
                                                           {"tp", "peak period"},
                                                           {"tz", "zero-crossing period"},
                                                           {"fov", "field of view"},
                                                           {"fps", "frames per second"},
                                                           {"ev", "(EV)"},
                                                           {"utc", "(UTC)"},
                                                           {"px", "(pixels)"},
                                                           {"min", "least"},
                                                           {"nodata", "no-data value"},
                                                           {"g", "asymmetry"},
                                                           {"x", "x (east)"},
                                                           {"y", "y (up)"},
                                                           {"z", "z (south)"}});
  return words_in(words, part, part);
}

/// The names of values whose keys are words of another trade.
std::string_view words_for_key(std::string_view key) {
  static constexpr auto named = std::to_array<NamedWords>({{"ocean.foam.onset_jacobian", "foam threshold"},
                                                           {"terrain.relief", "relief near the eye"},
                                                           {"terrain.origin_x_m", "west edge (x)"},
                                                           {"terrain.origin_z_m", "north edge (z)"},
                                                           {"body.x_m", "x (east) at the start"},
                                                           {"body.z_m", "z (south) at the start"},
                                                           {"body.heading_deg", "heading at the start"},
                                                           {"body.speed_mps", "speed at the start"},
                                                           {"ocean.foam.width", "threshold softness"},
                                                           {"ocean.foam.fraction", "foam cover"}});
  return words_in(named, key, {});
}

}  // namespace

std::string words_of(const Parameter& row) {
  if (const std::string_view named = words_for_key(row.key); !named.empty()) return std::string(named);
  std::string_view name = scene::name_of(row.key);
  const std::string_view ending = ending_of(row.unit);
  if (!ending.empty() && name.ends_with(ending)) name.remove_suffix(ending.size());
  std::string words;
  while (!name.empty()) {
    const std::string_view part = name.substr(0, name.find('_'));
    name.remove_prefix(std::min(part.size() + 1, name.size()));
    if (!words.empty()) words += ' ';
    words += word_for(part);
  }
  return row.unit == "m2" ? words + " area" : words;
}

std::string parameter_label(const Parameter& row) {
  return fmt::format("{}##{}", words_of(row), row.key);
}

Edit parameter_widget(Scene& scene, const Parameter& row, EditInProgress& edit, scene::ElementIndex element) {
  // What only files tell of a sea is left out: a value may then seem to have an effect.
  const scene::SeaFacts sea{.is_there = scene.has_sea(), .is_measured = !scene.ocean.spectrum_file.empty()};
  const std::string unused = scene::reason_unused(row, {.scene = scene, .element = element, .sea = sea});
  const ImGuiCol text_colour = unused.empty() ? ImGuiCol_Text : ImGuiCol_TextDisabled;
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[text_colour]);
  const Edit state = std::visit(Widget(scene, row, edit, element), row.storage);
  ImGui::PopStyleColor();
  if (ImGui::IsItemHovered()) {
    std::string text = fmt::format("{}\nin scene files: {}", row.help, row.key);
    if (!row.absent.empty()) text += fmt::format("\nwithout: {}", row.absent);
    if (!unused.empty()) text += fmt::format("\nno effect now: {}", unused);
    if (scene.tracks.contains({row.key, element})) text += "\nhas keyframes, which an edit removes";
    if (is_text(row)) text += "\npress Enter to apply the text";
    if (row.slider) text += "\nclick to type a value, also beyond the slider: " + scene::expected_text(row);
    explain_item(text);
  }
  return state;
}

}  // namespace offing::present
