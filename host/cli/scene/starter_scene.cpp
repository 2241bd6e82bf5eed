#include "host/cli/scene/starter_scene.h"

#include <span>

#include <fmt/format.h>

#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/key_tables.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::cli {

namespace {

using scene::Parameter;

struct StarterValue {
  std::string_view key;
  std::string_view value = {};  ///< as in a file; empty: the default
};

constexpr StarterValue values[] = {{"world.seed"},
                                   {"wind.speed_mps", "9"},
                                   {"wind.direction_deg", "60"},
                                   {"ocean.spectrum"},
                                   {"ocean.fetch_m"},
                                   {"ocean.choppiness"},
                                   {"ocean.water"},
                                   {"camera.y_m", "6"},
                                   {"camera.yaw_deg", "40"},
                                   {"camera.pitch_deg", "-4"},
                                   {"camera.fov_deg"},
                                   {"sun.azimuth_deg", "75"},
                                   {"sun.elevation_deg", "25"}};

constexpr StarterValue swell[] = {
    {"ocean.swell.hs_m", "1.5"}, {"ocean.swell.tp_s", "11"}, {"ocean.swell.direction_deg", "100"}};

/// The values with their sections. A mark, `#`, makes comments of their lines.
std::string lines_of(std::span<const StarterValue> written, std::string_view mark) {
  std::string text;
  const scene::Section* section = nullptr;
  for (const StarterValue& each : written) {
    const Parameter& row = *scene::find_parameter(each.key);
    if (row.section != section) {
      text += fmt::format("{}{}{}\n", section ? "\n" : "", mark, header_of(row));
      section = row.section;
    }
    const std::string usual = default_text(row);
    std::string value(each.value.empty() ? usual : each.value);
    if (is_text(row)) value = fmt::format("\"{}\"", value);
    text += fmt::format("# {}: {}; default {}\n{}{} = {}\n", row.help, expected_text(row), usual, mark,
                        scene::name_of(row.key), value);
  }
  return text;
}

}  // namespace

std::string starter_scene(std::string_view file) {
  return fmt::format(
      R"(# A sea in a fresh breeze. Draw it, find its errors, list all keys that a scene may have:
#   offing-view {0}
#   offing scene check {0}
#   offing scene keys
version = 1

{1}
# Swell from a distant storm. To add it, remove the # before [[ocean.swell]] and before each of its values.
{2})",
      file, lines_of(values, ""), lines_of(swell, "#"));
}

}  // namespace offing::cli
