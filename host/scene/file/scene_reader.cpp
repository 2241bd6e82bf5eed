#include "host/scene/file/scene_reader.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "host/base/error.h"
#include "host/io/file_trust.h"
#include "host/io/toml_depth.h"
#include "host/scene/file/nearest_name.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/toml_value.h"
#include "host/scene/file/track_reader.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {

namespace {

class SceneReader {
 public:
  SceneReader(std::string_view name, std::filesystem::path folder, Trust trust)
      : name_(name), folder_(std::move(folder)) {
    scene_.trust = trust;
  }

  SceneReading read(const toml::table& root) {
    check_version(root);
    read_table(root, "");
    scene_.ocean.is_given = root.contains("ocean");
    scene_.terrain.is_given = root.contains("terrain");
    return {.scene = std::move(scene_), .errors = errors(), .warnings = std::move(warnings_)};
  }

 private:
  std::string place_of(const toml::source_region& region) const { return place_text(name_, region); }

  /// Reads a part of the file and keeps the error that it ends with.
  template <class Read>
  void attempt(const toml::source_region& region, Read read) {
    if (faults_.size() >= most_faults) return;
    try {
      read();
    } catch (const Error& error) {
      faults_.push_back({{region.begin.line, region.begin.column}, error});
    }
  }

  /// In the file's order: tables are read in that of their keys.
  std::vector<Error> errors() {
    std::ranges::stable_sort(faults_, {}, &Fault::place);
    std::vector<Error> errors;
    for (const Fault& fault : faults_) {
      // Two keys that exclude each other say the same.
      const bool is_known = std::ranges::any_of(
          errors, [&](const Error& each) { return std::string_view(each.what()) == fault.error.what(); });
      if (!is_known) errors.push_back(fault.error);
    }
    return errors;
  }

  /// Throws for another version, in whose files all else may be right.
  void check_version(const toml::table& root) {
    const toml::node* version = root.get("version");
    if (!version) {
      faults_.push_back({{1, 1},
                         Error(ErrorKind::bad_input,
                               fmt::format("{}:1:1: version: expected version = 1, found none", name_),
                               "write version = 1 on the first line")});
      return;
    }
    if (version->value_exact<std::int64_t>() != 1) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: version: expected 1, got {}", place_of(version->source()), shown_text(*version)),
          "this version of offing reads scenes of version = 1");
    }
  }

  void read_table(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string full_key = prefix + std::string(key.str());
      if (full_key == "version" || (full_key == bench_section && node.is_table())) {
        continue;
      }
      attempt(key.source(),
              [&, &key = key, &node = node] { read_entry(full_key, prefix, key, node, table); });
    }
  }

  void read_entry(const std::string& full_key, const std::string& prefix, const toml::key& key,
                  const toml::node& node, const toml::table& table) {
    if (const Parameter* parameter = find_parameter(full_key)) {
      refuse_both(parameter->instead_of, full_key, key, table);
      read_value(*parameter, std::string(key.str()), node);
    } else if (parameter = find_by_alias(full_key); parameter != nullptr) {
      refuse_both(parameter->key, full_key, key, table);
      warnings_.push_back(fmt::format("{}: {}: this key is now {}", place_of(key.source()), full_key,
                                      name_of(parameter->key)));
      read_value(*parameter, std::string(key.str()), node);
    } else if (first_row_below(full_key)) {
      read_section(full_key, key, node);
    } else {
      refuse_key(full_key, prefix, key);
    }
  }

  /// A row of a section or of one inside it; nullptr if no section has this name.
  static const Parameter* first_row_below(std::string_view key) {
    const std::string prefix = std::string(key) + '.';
    const auto table = parameter_table();
    const auto row = std::find_if(table.begin(), table.end(),
                                  [&](const Parameter& each) { return each.key.starts_with(prefix); });
    return row == table.end() ? nullptr : &*row;
  }

  static const Parameter* first_row_of(std::string_view section) {
    const auto table = parameter_table();
    return &*std::find_if(table.begin(), table.end(),
                          [&](const Parameter& each) { return section_of(each.key) == section; });
  }

  /// A section whose values are lists is written as an array of tables, one element an entry.
  static bool is_repeated(std::string_view key) {
    const std::string prefix = std::string(key) + '.';
    const auto table = parameter_table();
    return std::any_of(table.begin(), table.end(), [&](const Parameter& row) {
      return row.key.starts_with(prefix) && row.key.find('.', prefix.size()) == std::string_view::npos &&
             row.max_count > 1;
    });
  }

  void read_section(const std::string& full_key, const toml::key& key, const toml::node& node) {
    const bool repeated = is_repeated(full_key);
    const toml::array* elements = node.as_array();
    if (repeated && elements && elements->is_array_of_tables()) {
      const Parameter& row = *first_row_of(full_key);
      for (const toml::node& element : *elements) {
        attempt(element.source(), [&] {
          append_element(scene_, row,
                         {.subject = fmt::format("{}: {}", place_of(element.source()), full_key)});
          read_table(*element.as_table(), full_key + '.');
        });
      }
    } else if (!repeated && node.is_table()) {
      read_table(*node.as_table(), full_key + '.');
    } else {
      const std::string header = header_of(full_key);
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: {}: expected a section {}, got {}", place_of(key.source()), full_key,
                              header, shown_text(node)),
                  fmt::format("write {} on a line of its own and its keys below", header));
    }
  }

  /// Throws at the later one of two keys of a table that say the same in two ways.
  void refuse_both(std::string_view other_key, const std::string& full_key, const toml::key& key,
                   const toml::table& table) const {
    if (other_key.empty()) return;
    const std::string_view other_name = name_of(other_key);
    const auto other = table.find(other_name);
    if (other == table.end()) return;
    const auto position = [](const toml::key& each) {
      return std::pair(each.source().begin.line, each.source().begin.column);
    };
    const toml::key& later = position(key) < position(other->first) ? other->first : key;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: {}: expected either {} or {}, found both", place_of(later.source()),
                            &later == &key ? std::string_view(full_key) : other_key, key.str(), other_name),
                "remove one of them");
  }

  void read_value(const Parameter& parameter, const std::string& key, const toml::node& node) {
    const Place place{.subject = fmt::format("{}: {}", place_of(node.source()), parameter.key),
                      .assignment = key + " = "};
    if (const toml::table* table = node.as_table(); table && table->contains("keys")) {
      read_track(scene_, parameter, *table, name_);
      return;
    }
    store(scene_, parameter, written_value(node), place);
    if (parameter.rule == ParameterRule::file_name) {
      std::string& file =
          std::get<ValueAt<std::string>>(parameter.storage)
              .in(struct_at(&scene_, *parameter.section, last_element(scene_, *parameter.section)));
      file = named_file(file, place);
    }
  }

  /// A file as the scene names it; relative to its folder.
  std::string named_file(const std::string& written, const Place& place) {
    const std::string file = (folder_ / written).string();
    if (is_address(written)) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("{}: expected a file, got an address, \"{}\"", place.subject, printable(written)),
          "download it to the scene's folder, and write the name of the file");
    }
    if (!written.empty() && scene_.trust == Trust::untrusted) {
      try {
        require_below(folder_, file);
      } catch (const Error& error) {
        throw Error(error.kind(), fmt::format("{}: {}", place.subject, error.what()), error.hint());
      }
    }
    scene_.named_files.insert(file);
    return file;
  }

  [[noreturn]] void refuse_key(const std::string& full_key, const std::string& prefix,
                               const toml::key& key) const {
    const std::string place = place_of(key.source());
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: {}: expected a known key, got \"{}\"", place, full_key.substr(0, 60),
                            key.str().substr(0, 60)),
                hint_of(key.str(), prefix));
  }

  /// Where a key stands that is unknown below this prefix, or which one was meant: the key's own name
  /// anywhere, else the nearest here, else the nearest anywhere.
  static std::string hint_of(std::string_view name, std::string_view prefix) {
    if (const std::string sections = sections_of(name); !sections.empty()) {
      return fmt::format("{} belongs in {}", name, sections);
    }
    const std::vector<std::string> siblings = names_below(prefix);
    const std::vector<std::string_view> here(siblings.begin(), siblings.end());
    if (const std::string_view near = nearest_name(name, here); !near.empty()) {
      return fmt::format("did you mean {}?", near);
    }
    std::vector<std::string_view> anywhere;
    for (const Parameter& row : parameter_table()) anywhere.push_back(name_of(row.key));
    if (const std::string_view near = nearest_name(name, anywhere); !near.empty()) {
      return fmt::format("did you mean {} in {}?", near, sections_of(near));
    }
    return fmt::format("known here: {}", fmt::join(siblings, ", "));
  }

  /// The headers of the sections that have a key of this name, such as "[wind] or [[ocean.swell]]".
  static std::string sections_of(std::string_view name) {
    std::vector<std::string> headers;
    for (const Parameter& row : parameter_table()) {
      if (name_of(row.key) == name) headers.push_back(header_of(section_of(row.key)));
    }
    return fmt::format("{}", fmt::join(headers, " or "));
  }

  static std::string header_of(std::string_view section) {
    return fmt::format(fmt::runtime(is_repeated(section) ? "[[{}]]" : "[{}]"), section);
  }

  /// Keys and sections directly below a prefix such as "ocean.", each once.
  static std::vector<std::string> names_below(std::string_view prefix) {
    std::vector<std::string> names;
    for (const Parameter& row : parameter_table()) {
      if (row.key.starts_with(prefix)) {
        const std::string_view rest = row.key.substr(prefix.size());
        std::string name(rest.substr(0, rest.find('.')));
        if (std::find(names.begin(), names.end(), name) == names.end()) {
          names.push_back(std::move(name));
        }
      }
    }
    return names;
  }

  /// What is wrong with a part of the file, and where: line and column.
  struct Fault {
    std::pair<toml::source_index, toml::source_index> place;
    Error error;
  };

  std::string name_;
  std::filesystem::path folder_;
  Scene scene_;
  std::vector<Fault> faults_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::string read_scene_text(const std::filesystem::path& file) {
  std::error_code status_error;
  if (std::filesystem::is_directory(file, status_error)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: expected a scene file, found a folder", file.string()),
                "name a .toml file");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot open scene: {}", file.string(), std::strerror(errno)),
                "check the name of the scene file");
  }
  std::string text;
  std::array<char, 1 << 14> block{};
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most_scene_bytes) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("{}: expected a scene of at most {} bytes, found more", file.string(),
                              most_scene_bytes),
                  "name a scene file; measured spectra are given by --spectrum-file");
    }
  }
  if (stream.bad()) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot read scene: {}", file.string(), std::strerror(errno)),
                "check the file");
  }
  return text;
}

SceneReading read_scene(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                        Trust trust) {
  if (const std::optional<TomlPlace> place = too_deep_toml(text)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}:{}: expected at most {} nested names or brackets, found more", name,
                            place->line, place->column, most_toml_levels),
                "write lines such as speed_mps = 10 below headings such as [wind]");
  }
  toml::table root;
  try {
    root = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw Error(ErrorKind::bad_input,
                fmt::format("{}:{}:{}: expected TOML, found a syntax error: {}", name, at.line, at.column,
                            one_line(error.description())),
                "write lines such as speed_mps = 10 below headings such as [wind]");
  }
  return SceneReader(name, folder, trust).read(root);
}

}  // namespace offing::scene
