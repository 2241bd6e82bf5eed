#include "host/scene/file/scene_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {
namespace {

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (code < 0x20 || code == 0x7f) {
      result += fmt::format("\\u{:04x}", code);
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// `{ keys = [{ t = 0, value = 5 }, ...] }`, from the tracks of the numbers of a value.
std::string track_text(const Scene& scene, const Parameter& row, ElementIndex element) {
  std::vector<const KeyframeTrack*> tracks;
  for (std::size_t number = 0; scene.tracks.contains({row.key, element, number}); ++number) {
    tracks.push_back(&scene.tracks.at({row.key, element, number}));
  }
  const KeyframeTrack& first = *tracks.front();
  std::string keys;
  for (std::size_t key = 0; key < first.keys.size(); ++key) {
    std::vector<double> numbers;
    for (const KeyframeTrack* track : tracks) numbers.push_back(track->keys[key].value);
    keys += fmt::format("{}{{ t = {}, value = {} }}", keys.empty() ? "" : ", ", first.keys[key].time_s,
                        numbers_text(row, numbers));
  }
  const char* rest = first.interpolation == Interpolation::linear ? ", interpolation = \"linear\"" : "";
  return fmt::format("{{ keys = [{}]{} }}", keys, rest);
}

/// A file's name as it is found from a folder, "" being the current one; whole where that cannot be told.
std::string name_from(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code failure;
  const std::filesystem::path whole = std::filesystem::absolute(file, failure);
  if (failure) return file.generic_string();
  const std::filesystem::path from = std::filesystem::absolute(folder.empty() ? "." : folder, failure);
  const std::filesystem::path name = failure ? whole : std::filesystem::proximate(whole, from, failure);
  return (failure ? whole : name).generic_string();
}

/// Of two values that say the same, a file gives one.
void leave_out_what_does_not_count(std::string_view section, std::vector<ValueLine>& lines) {
  for (const Parameter& row : parameter_table()) {
    if (row.instead_of.empty() || section_of(row.key) != section) continue;
    const auto is_other = [&](const ValueLine& line) { return line.name == name_of(row.instead_of); };
    if (std::none_of(lines.begin(), lines.end(), is_other)) continue;
    std::erase_if(lines, [&](const ValueLine& line) { return line.name == name_of(row.key); });
  }
}

}  // namespace

std::string SceneText::whole() {
  text_ = "version = 1\n";
  std::vector<std::string_view> sections;
  for (const Parameter& row : parameter_table()) {
    const std::string_view section = section_of(row.key);
    if (std::find(sections.begin(), sections.end(), section) != sections.end()) continue;
    sections.push_back(section);
    if (!row.section->repeated_parent()) append_section(row, {});
  }
  append_bare_sections();
  return std::move(text_);
}

std::string SceneText::element(const Parameter& row, ElementIndex element) {
  text_.clear();
  append_element_of(row, element);
  return std::move(text_);
}

void SceneText::append_section(const Parameter& row, ElementIndex parent) {
  const std::string_view section = section_of(row.key);
  if (const auto* list = std::get_if<ValueAt<std::vector<double>>>(&row.storage)) {
    for (const double value : list->in(struct_at(&scene_, *row.section, {}))) {
      append("[[{}]]", section, {{name_of(row.key), numbers_text(row, std::array{value})}});
    }
  } else if (!row.section->is_repeated()) {
    const std::vector<ValueLine> lines = lines_of(section, {});
    if (!lines.empty()) append("[{}]", section, lines);
  } else {
    const std::size_t count = count_of(&scene_, *row.section, parent);
    if (count > row.max_count) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected at most {} sections, the most that can be read back, found {}",
                              section, row.max_count, count),
                  "remove some first");
    }
    for (std::size_t i = 0; i < count; ++i) {
      append_element_of(row,
                        row.section->repeated_parent() ? ElementIndex{parent.outer, i} : ElementIndex{i, 0});
    }
  }
}

void SceneText::append_element_of(const Parameter& row, ElementIndex element) {
  append("[[{}]]", section_of(row.key), lines_of(section_of(row.key), element));
  const Parameter* before = nullptr;
  for (const Parameter& inner : parameter_table()) {
    if (inner.section->repeated_parent() != row.section) continue;
    if (!before || section_of(before->key) != section_of(inner.key)) append_section(inner, element);
    before = &inner;
  }
}

void SceneText::append_bare_sections() {
  if (scene_.terrain.is_given && !has_section("terrain")) append("[{}]", "terrain", {});
  const bool needs_sea = scene_.terrain.is_given || !scene_.meshes.empty() || scene_.has_clouds();
  if (scene_.ocean.is_given && needs_sea && !has_section("ocean")) append("[{}]", "ocean", {});
}

bool SceneText::has_section(std::string_view name) const {
  return std::any_of(written_.begin(), written_.end(), [&](std::string_view section) {
    return section == name || section.starts_with(fmt::format("{}.", name));
  });
}

std::vector<ValueLine> SceneText::lines_of(std::string_view section, ElementIndex element) const {
  std::vector<ValueLine> lines;
  for (const Parameter& row : parameter_table()) {
    if (section_of(row.key) != section) continue;
    const bool is_usual =
        is_same_value(row, struct_at(&scene_, *row.section, element), default_struct(*row.section));
    if (is_usual && !scene_.tracks.contains({row.key, element})) continue;
    if (std::string value = value_of(row, element); !value.empty()) {
      lines.push_back({name_of(row.key), std::move(value)});
    }
  }
  leave_out_what_does_not_count(section, lines);
  return lines;
}

std::string SceneText::value_of(const Parameter& row, ElementIndex element) const {
  if (scene_.tracks.contains({row.key, element})) return track_text(scene_, row, element);
  const void* section = struct_at(&scene_, *row.section, element);
  if (const auto* text = std::get_if<ValueAt<std::string>>(&row.storage)) {
    const std::string& value = text->in(section);
    if (value.empty()) return "";
    return toml_text(row.rule == ParameterRule::file_name ? name_from(folder_, value) : value);
  }
  const std::string value = text_in(section, row, Digits::reads_back);
  if (value == row.absent) return "";
  const bool is_quoted = std::holds_alternative<ChoiceStorage>(row.storage) ||
                         std::holds_alternative<ValueAt<std::optional<UtcTime>>>(row.storage);
  return is_quoted ? toml_text(value) : value;
}

void SceneText::append(fmt::format_string<std::string_view&> header, std::string_view section,
                       const std::vector<ValueLine>& lines) {
  written_.push_back(section);
  text_ += '\n' + fmt::format(header, section) + '\n';
  for (const ValueLine& line : lines) text_ += fmt::format("{} = {}\n", line.name, line.value);
}

}  // namespace offing::scene
