#include "host/scene/schema/scene_elements.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_presence.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {

namespace {

/// Drops what a map knows of an element and counts those behind it one less.
template <class Value>
void forget(std::map<ValueKey, Value>& map, const Section& section, ElementIndex element) {
  std::map<ValueKey, Value> kept;
  for (auto& [key, value] : map) {
    const Section& of_key = *find_parameter(key.key)->section;
    ValueKey now = key;
    if (&of_key == &section && section.repeated_parent()) {
      if (key.element == element) continue;
      if (key.element.outer == element.outer && key.element.inner > element.inner) --now.element.inner;
    } else if (&of_key == &section || of_key.repeated_parent() == &section) {
      if (key.element.outer == element.outer) continue;
      if (key.element.outer > element.outer) --now.element.outer;
    }
    kept.emplace(now, std::move(value));
  }
  map = std::move(kept);
}

/// Whether the section, or the one around its elements, has no element.
bool has_none(const Scene& scene, const Section& section) {
  const Section* above = section.repeated_parent();
  return (above && count_of(&scene, *above, {}) == 0) ||
         count_of(&scene, section, above ? last_element(scene, *above) : ElementIndex{}) == 0;
}

using Tracks = std::vector<std::pair<ValueKey, const KeyframeTrack*>>;

Tracks tracks_of(const Scene& scene, const Parameter& row) {
  Tracks tracks;
  for (const auto& [key, track] : scene.tracks) {
    if (key.key == row.key) tracks.emplace_back(key, &track);
  }
  return tracks;
}

bool has_same_keyframes(const Scene& before, const Scene& after, const Parameter& row) {
  if (row.motion == ParameterMotion::constant) return true;
  return std::ranges::equal(tracks_of(before, row), tracks_of(after, row), [](const auto& a, const auto& b) {
    return a.first == b.first && *a.second == *b.second;
  });
}

bool has_same_values(const Scene& before, const Scene& after, const Parameter& row) {
  const std::vector<ElementIndex> elements = elements_of(before, *row.section);
  return elements == elements_of(after, *row.section) &&
         std::ranges::all_of(elements, [&](ElementIndex element) {
           return is_same_value(row, struct_at(&before, *row.section, element),
                                struct_at(&after, *row.section, element));
         });
}

/// Gives a section as many elements as another scene has.
void make_as_many(const Section& section, const Scene& from, Scene& to) {
  if (!section.is_repeated()) return;
  const Section* above = section.repeated_parent();
  const std::vector<ElementIndex> parents =
      above ? elements_of(from, *above) : std::vector<ElementIndex>{ElementIndex{}};
  for (const ElementIndex parent : parents) {
    const std::size_t wanted = count_of(&from, section, parent);
    while (count_of(&to, section, parent) < wanted) append_to(&to, section, parent);
    for (std::size_t last = count_of(&to, section, parent); last-- > wanted;) {
      remove_from(&to, section, above ? ElementIndex{parent.outer, last} : ElementIndex{last, 0});
    }
  }
}

void take_tracks(Affects what, const Scene& from, Scene& to) {
  if (from.tracks == to.tracks) return;
  const auto is_taken = [&](const auto& track) {
    return share_a_bit(find_parameter(track.first.key)->affects, what);
  };
  std::erase_if(to.tracks, is_taken);
  for (const auto& track : from.tracks) {
    if (is_taken(track)) to.tracks.insert(track);
  }
}

/// Whether two elements have the same values of their own, whatever elements they have.
bool is_same_element(const Section& section, const Scene& one, ElementIndex in_one, const Scene& other,
                     ElementIndex in_other) {
  return std::ranges::all_of(parameter_table(), [&](const Parameter& row) {
    return row.section != &section ||
           is_same_value(row, struct_at(&one, section, in_one), struct_at(&other, section, in_other));
  });
}

void take_out_added(const Section& section, const Scene& before, const Scene& after, Scene& scene) {
  const std::size_t old = count_of(&before, section, {}), more = count_of(&after, section, {}) - old;
  // Those without which the most of the others are as before; at the end, where there is a choice.
  std::size_t first = 0, most_alike = 0;
  for (std::size_t place = 0; place <= old; ++place) {
    std::size_t alike = 0;
    for (std::size_t i = 0; i < old; ++i)
      alike += is_same_element(section, before, {i, 0}, after, {i < place ? i : i + more, 0}) ? 1 : 0;
    if (alike < most_alike) continue;
    most_alike = alike;
    first = place;
  }
  for (std::size_t added = first + more; added-- > first;) {
    const std::vector<ElementIndex> elements = elements_of(scene, section);
    auto place = std::ranges::find_if(elements, [&](ElementIndex element) {
      return is_same_element(section, scene, element, after, {added, 0});
    });
    if (place == elements.end()) place = std::ranges::find(elements, ElementIndex{added, 0});  // edited since
    if (place != elements.end()) remove_element(scene, section, *place);
  }
}

void take_out_keyframes(const Scene& before, const Scene& after, Scene& scene) {
  std::set<ValueKey> keys;
  for (const Scene* each : {&before, &after}) {
    for (const auto& [key, track] : each->tracks) keys.insert(key);
  }
  for (const ValueKey& key : keys) {
    const auto track_in = [&](const Scene& of) -> std::optional<KeyframeTrack> {
      const auto found = of.tracks.find(key);
      return found == of.tracks.end() ? std::nullopt : std::optional(found->second);
    };
    const std::optional<KeyframeTrack> was = track_in(before), is = track_in(after);
    if (was == is || track_in(scene) != is) continue;
    scene.tracks.erase(key);
    if (was) scene.tracks.emplace(key, *was);
  }
}

}  // namespace

ElementIndex last_element(const Scene& scene, const Section& section) {
  const Section* above = section.repeated_parent();
  ElementIndex last = above ? last_element(scene, *above) : ElementIndex{};
  if (!section.is_repeated() || (above && count_of(&scene, *above, {}) == 0)) return last;
  const std::size_t count = count_of(&scene, section, last);
  (above ? last.inner : last.outer) = count == 0 ? 0 : count - 1;
  return last;
}

std::vector<ElementIndex> elements_of(const Scene& scene, const Section& section) {
  return elements_in(&scene, section);
}

ElementIndex last_element_or_first(Scene& scene, const Parameter& parameter, const Place& place) {
  if (has_none(scene, *parameter.section)) append_element(scene, parameter, place);
  return last_element(scene, *parameter.section);
}

void append_element(Scene& scene, const Parameter& parameter, const Place& place) {
  const Section& section = *parameter.section;
  if (!section.is_repeated()) return;
  const Section* above = section.repeated_parent();
  if (above && count_of(&scene, *above, {}) == 0) append_to(&scene, *above, {});
  const ElementIndex parent = above ? last_element(scene, *above) : ElementIndex{};
  if (count_of(&scene, section, parent) == section.max_count) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at most {} sections, found more", place.subject, section.max_count),
                "remove some sections");
  }
  append_to(&scene, section, parent);
}

void remove_element(Scene& scene, const Section& section, ElementIndex element) {
  remove_from(&scene, section, element);
  forget(scene.tracks, section, element);
  forget(scene.set_at, section, element);
}

std::vector<double*> numbers_of(Scene& scene, const Parameter& parameter, ElementIndex element) {
  return numbers_in(struct_at(&scene, *parameter.section, element), parameter);
}

void clear_value(Scene& scene, const Parameter& parameter, ElementIndex element) {
  copy_value(parameter, default_struct(*parameter.section), struct_at(&scene, *parameter.section, element));
  const auto is_of_row = [&](const auto& entry) {
    return entry.first.key == parameter.key && entry.first.element == element;
  };
  std::erase_if(scene.set_at, is_of_row);
  std::erase_if(scene.tracks, is_of_row);
}

const void* default_struct(const Section& section) {
  static const Scene usual = [] {
    Scene scene;
    for (const Parameter& row : parameter_table()) {
      if (has_none(scene, *row.section)) append_element(scene, row, {});
    }
    return scene;
  }();
  return struct_at(&usual, section, {});
}

bool differ_in(Affects what, const Scene& before, const Scene& after) {
  return std::ranges::any_of(parameter_table(), [&](const Parameter& row) {
    return share_a_bit(row.affects, what) &&
           !(has_same_values(before, after, row) && has_same_keyframes(before, after, row));
  });
}

void take_values(Affects what, const Scene& from, Scene& to) {
  const Section* known = nullptr;
  for (const Parameter& row : parameter_table()) {
    if (!share_a_bit(row.affects, what)) continue;
    const Section& section = *row.section;
    if (std::exchange(known, &section) != &section) make_as_many(section, from, to);
    for (const ElementIndex element : elements_of(from, section)) {
      const void* source = struct_at(&from, section, element);
      void* target = struct_at(&to, section, element);
      if (!is_same_value(row, source, target)) copy_value(row, source, target);
    }
  }
  take_tracks(what, from, to);
  to.ocean.is_given = from.ocean.is_given;
  to.terrain.is_given = from.terrain.is_given;
  to.trust = from.trust;
  if (from.named_files != to.named_files) to.named_files = from.named_files;
}

void take_out_edit(const Scene& before, const Scene& after, Scene& scene) {
  take_out_keyframes(before, after, scene);
  std::set<const Section*> known;
  for (const Parameter& row : parameter_table()) {
    const Section& section = *row.section;
    const std::vector<ElementIndex> edited = elements_of(after, section), were = elements_of(before, section);
    if (known.insert(&section).second && section.is_repeated() && section.repeated_parent() == nullptr &&
        edited.size() > were.size()) {
      take_out_added(section, before, after, scene);
    }
    if (edited != were) continue;
    const std::vector<ElementIndex> elements = elements_of(scene, section);
    for (const ElementIndex element : elements) {
      if (std::ranges::find(edited, element) == edited.end()) continue;
      const void* old = struct_at(&before, section, element);
      const void* was = struct_at(&after, section, element);
      void* now = struct_at(&scene, section, element);
      if (!is_same_value(row, old, was) && is_same_value(row, was, now)) copy_value(row, old, now);
    }
  }
  if (before.ocean.is_given != after.ocean.is_given) scene.ocean.is_given = before.ocean.is_given;
  if (before.terrain.is_given != after.terrain.is_given) scene.terrain.is_given = before.terrain.is_given;
}

}  // namespace offing::scene
