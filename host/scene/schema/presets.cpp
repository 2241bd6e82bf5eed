#include "host/scene/schema/presets.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {
namespace {

constexpr Preset beaufort(std::string_view name, std::string_view label, std::string_view wind_mps,
                          std::string_view hs_m) {
  return {name,
          label,
          ParameterGroup::sea,
          {{{"ocean.wind_speed_mps", wind_mps},
            {"ocean.hs_m", hs_m},
            {"ocean.tp_s", ""},
            {"ocean.tz_s", ""},
            {"ocean.fetch_m", ""}}}};
}

}  // namespace

std::span<const Preset> presets() {
  static constexpr std::array all{beaufort("beaufort-1", "Beaufort 1, light air", "0.84", "0.1"),
                                  beaufort("beaufort-2", "Beaufort 2, light breeze", "2.4", "0.2"),
                                  beaufort("beaufort-3", "Beaufort 3, gentle breeze", "4.3", "0.6"),
                                  beaufort("beaufort-4", "Beaufort 4, moderate breeze", "6.7", "1"),
                                  beaufort("beaufort-5", "Beaufort 5, fresh breeze", "9.3", "2"),
                                  beaufort("beaufort-6", "Beaufort 6, strong breeze", "12.3", "3"),
                                  beaufort("beaufort-7", "Beaufort 7, near gale", "15.5", "4"),
                                  beaufort("beaufort-8", "Beaufort 8, gale", "18.9", "5.5"),
                                  beaufort("beaufort-9", "Beaufort 9, strong gale", "22.6", "7"),
                                  beaufort("beaufort-10", "Beaufort 10, storm", "26.4", "9"),
                                  beaufort("beaufort-11", "Beaufort 11, violent storm", "30.5", "11.5"),
                                  beaufort("beaufort-12", "Beaufort 12, hurricane", "34.8", "14")};
  return all;
}

const Preset& find_preset(std::string_view name, std::string_view subject) {
  const auto found = std::ranges::find(presets(), name, &Preset::name);
  if (found != presets().end()) return *found;
  std::string known;
  for (const Preset& preset : presets()) known += fmt::format("{}{}", known.empty() ? "" : ", ", preset.name);
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected the name of a preset, got \"{}\"", subject, name),
              "presets: " + known);
}

void apply(const Preset& preset, Scene& scene) {
  for (const Preset::Value& value : preset.values) {
    const Parameter& row = *find_parameter(value.key);
    if (value.text.empty()) {
      clear_value(scene, row);
    } else {
      store(scene, row, read_flag_value(row, std::string(value.text)),
            {.subject = fmt::format("preset {}: {}", preset.name, value.key)});
    }
  }
}

}  // namespace offing::scene
