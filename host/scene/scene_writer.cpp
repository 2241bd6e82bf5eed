#include "host/scene/scene_writer.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <system_error>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/io/file_presence.h"
#include "host/scene/parameter_table.h"

namespace offing::scene {
namespace {

using Text = std::string& (*)(OceanScene&);
using List = std::vector<double>& (*)(OceanScene&);
using Time = std::optional<UtcTime>& (*)(OceanScene&);

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

/// As people write it, where that is the same number.
std::string number_of(const OceanScene& scene, const Parameter& row) {
  const std::string exact = value_text(scene, row, Digits::exact);
  std::string readable = value_text(scene, row, Digits::readable);
  OceanScene copy = scene;
  clear_list(copy, row);
  store(copy, row, read_flag_value(row, readable), {.subject = std::string(row.key), .assignment = ""});
  return value_text(copy, row, Digits::exact) == exact ? readable : exact;
}

/// The numbers of a repeated section's elements; empty text where an element has none.
std::vector<std::string> element_numbers(const OceanScene& scene, const Parameter& row,
                                         const ElementStorage& elements) {
  OceanScene copy = scene;
  OceanScene one;
  elements.append(one);
  std::vector<std::string> values;
  for (std::size_t i = 0; i < elements.count(scene); ++i) {
    const bool is_there = std::visit(
        [&](auto at) { return std::optional<double>(at(one, 0) = at(copy, i)).has_value(); }, elements.at);
    values.push_back(is_there ? number_of(one, row) : "");
  }
  return values;
}

/// `{ keys = [{ t = 0, value = 5 }, ...] }`.
std::string track_text(const KeyframeTrack& track, const Parameter& row) {
  OceanScene one;
  double& value = std::get<double& (*)(OceanScene&)>(row.storage)(one);
  std::string keys;
  for (const Keyframe& key : track.keys) {
    value = key.value;
    keys +=
        fmt::format("{}{{ t = {}, value = {} }}", keys.empty() ? "" : ", ", key.time_s, number_of(one, row));
  }
  const char* rest = track.interpolation == Interpolation::linear ? ", interpolation = \"linear\"" : "";
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

/// One text a value: lists and repeated sections have several.
std::vector<std::string> values_of(const OceanScene& scene, const Parameter& row,
                                   const std::filesystem::path& folder) {
  if (const auto track = scene.tracks.find(row.key); track != scene.tracks.end()) {
    return {track_text(track->second, row)};
  }
  if (const auto* elements = std::get_if<ElementStorage>(&row.storage)) {
    return element_numbers(scene, row, *elements);
  }
  if (std::holds_alternative<ChoiceStorage>(row.storage) || std::holds_alternative<Time>(row.storage))
    return {toml_text(value_text(scene, row))};
  OceanScene copy = scene;
  if (const auto* text = std::get_if<Text>(&row.storage)) {
    return {toml_text(name_from(folder, (*text)(copy)))};
  }
  if (const auto* list = std::get_if<List>(&row.storage)) {
    OceanScene one;
    std::vector<std::string> values;
    for (const double value : (*list)(copy)) {
      (*list)(one) = {value};
      values.push_back(number_of(one, row));
    }
    return values;
  }
  return {number_of(scene, row)};
}

bool is_as_usual(const OceanScene& scene, const Parameter& row) {
  return !scene.tracks.contains(row.key) &&
         value_text(scene, row, Digits::exact) == value_text(OceanScene{}, row, Digits::exact);
}

struct Line {
  std::string_view name;
  std::vector<std::string> values;  ///< empty where an element says nothing
};

struct Section {
  std::string_view name;
  bool is_repeated = false;  ///< written once an element of its lists
  std::vector<Line> lines;
};

/// Of two values that say the same, a file gives one.
void leave_out_what_does_not_count(Section& section) {
  for (const Parameter& row : parameter_table()) {
    if (row.instead_of.empty() || section_of(row.key) != section.name) continue;
    const auto line_of = [&](std::string_view key) {
      return std::find_if(section.lines.begin(), section.lines.end(),
                          [&](const Line& line) { return line.name == name_of(key); });
    };
    const auto line = line_of(row.key), other = line_of(row.instead_of);
    if (line == section.lines.end() || other == section.lines.end()) continue;
    for (std::size_t i = 0; i < line->values.size(); ++i) {
      if (!other->values[i].empty()) line->values[i].clear();
    }
  }
}

/// Sections that say something by being there, where all in them is as usual.
void add_bare_sections(const OceanScene& scene, std::vector<Section>& sections) {
  const auto is_missing = [&](std::string_view name) {
    return std::none_of(sections.begin(), sections.end(), [&](const Section& one) {
      return one.name == name || one.name.starts_with(fmt::format("{}.", name));
    });
  };
  if (!scene.terrain.is_given) return;
  if (is_missing("terrain")) sections.push_back({.name = "terrain", .lines = {}});
  if (scene.names_sea && is_missing("ocean")) sections.push_back({.name = "ocean", .lines = {}});
}

/// What is not as in a default-made scene, in the order of the table; rows of a section need not be
/// neighbours.
std::vector<Section> changed_sections(const OceanScene& scene, const std::filesystem::path& folder) {
  std::vector<Section> sections;
  for (const Parameter& row : parameter_table()) {
    if (is_as_usual(scene, row)) continue;
    auto section = std::find_if(sections.begin(), sections.end(),
                                [&](const Section& one) { return one.name == section_of(row.key); });
    if (section == sections.end())
      section = sections.insert(section, {.name = section_of(row.key), .lines = {}});
    section->is_repeated = section->is_repeated || row.max_count > 1;
    section->lines.push_back({.name = name_of(row.key), .values = values_of(scene, row, folder)});
  }
  for (Section& section : sections) leave_out_what_does_not_count(section);
  add_bare_sections(scene, sections);
  return sections;
}

void append(std::string& text, const Section& section) {
  std::size_t count = 1;
  for (const Line& line : section.lines) count = std::max(count, line.values.size());
  for (std::size_t element = 0; element < count; ++element) {
    text +=
        section.is_repeated ? fmt::format("\n[[{}]]\n", section.name) : fmt::format("\n[{}]\n", section.name);
    for (const Line& line : section.lines) {
      if (element < line.values.size() && !line.values[element].empty())
        text += fmt::format("{} = {}\n", line.name, line.values[element]);
    }
  }
}

}  // namespace

std::string scene_text(const OceanScene& scene, const std::filesystem::path& folder) {
  std::string text = "version = 1\n";
  for (const Section& section : changed_sections(scene, folder)) append(text, section);
  return text;
}

void save_scene(const OceanScene& scene, const std::filesystem::path& file, Existing existing) {
  require_extension(file, {".toml"});
  if (existing == Existing::keep && is_there(file)) {
    throw Error(ErrorKind::bad_usage, fmt::format("{}: is there already", file.string()),
                "choose another name, or overwrite it");
  }
  write_file_atomically(file, scene_text(scene, file.parent_path()));
}

}  // namespace offing::scene
