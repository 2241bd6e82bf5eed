#include "host/scene/file/parameter_track.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {

namespace {

void require_movable(const Parameter& parameter, const Place& place) {
  if (parameter.motion != ParameterMotion::constant) return;
  std::vector<std::string_view> movable, sections;
  for (const Parameter& row : parameter_table()) {
    if (row.motion == ParameterMotion::constant) continue;
    const std::string_view section = section_of(row.key);
    if (section == section_of(parameter.key)) movable.push_back(row.key);
    if (sections.empty() || sections.back() != section) sections.push_back(section);
  }
  if (movable.empty()) movable = sections;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected one value, got keyframes, which it cannot have", place.subject),
              fmt::format("write one constant value; keyframes are for {}", fmt::join(movable, ", ")));
}

double checked_time_s(const WrittenKeyframe& key, const std::vector<Keyframe>& before) {
  double time_s = std::nan("");
  if (const auto* real = std::get_if<double>(&key.time.value)) time_s = *real;
  if (const auto* whole = std::get_if<std::int64_t>(&key.time.value)) time_s = static_cast<double>(*whole);
  if (!(std::abs(time_s) <= largest_time_s)) {  // true for NaN too
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a time in s within [{:g}, {:g}], got {}", key.time_place.subject,
                            -largest_time_s, largest_time_s, key.time.shown),
                "write t = 2.5");
  }
  if (!before.empty() && time_s <= before.back().time_s) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a time after {:g}, the time of the key before, got {}",
                    key.time_place.subject, before.back().time_s, key.time.shown),
        time_s == before.back().time_s ? "remove one of the two keys" : "write the keys in order of time");
  }
  return time_s;
}

}  // namespace

void store_track(Scene& scene, const Parameter& parameter, const std::vector<WrittenKeyframe>& written,
                 Interpolation interpolation, const Place& place) {
  require_movable(parameter, place);
  if (written.empty() || written.size() > most_keyframes) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected 1 ... {} keys, found {}", place.subject, most_keyframes, written.size()),
        "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]");
  }
  KeyframeTrack like{.interpolation = interpolation};
  if (parameter.motion == ParameterMotion::keyed_angle) like.period = 2.0 * std::numbers::pi;
  const ElementIndex element = last_element_or_first(scene, parameter, place);
  // A number that may be absent is one from here on.
  store(scene, parameter, written.front().value, written.front().value_place, element);
  const std::vector<double*> numbers = numbers_of(scene, parameter, element);
  std::vector<KeyframeTrack> tracks(numbers.size(), like);
  for (const WrittenKeyframe& key : written) {
    const double time_s = checked_time_s(key, tracks.front().keys);
    store(scene, parameter, key.value, key.value_place, element);
    for (std::size_t i = 0; i < numbers.size(); ++i) tracks[i].keys.push_back({time_s, *numbers[i]});
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    *numbers[i] = tracks[i].keys.front().value;
    scene.tracks.insert_or_assign({parameter.key, element, i}, std::move(tracks[i]));
  }
  scene.set_at.insert_or_assign({parameter.key, element}, place.subject);
}

}  // namespace offing::scene
