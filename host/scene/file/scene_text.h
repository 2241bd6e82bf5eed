// The text of a scene and of its parts, as TOML.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// `name = value`
struct ValueLine {
  std::string_view name;
  std::string value;
};

/// Writes a scene, which must outlive it. File names are written relative to `folder`.
class SceneText {
 public:
  SceneText(const Scene& scene, std::filesystem::path folder) : scene_(scene), folder_(std::move(folder)) {}

  /// What scene_text() returns.
  std::string whole();
  /// An element of a repeated section, which `row` is of, and the sections within it.
  std::string element(const Parameter& row, ElementIndex element);
  /// The values of a section that are not the default ones.
  std::vector<ValueLine> lines_of(std::string_view section, ElementIndex element) const;
  /// A value in TOML, the default one too; empty for one that is absent.
  std::string value_of(const Parameter& row, ElementIndex element) const;

 private:
  /// The section of a row, of a repeated one all elements within this one of its parent.
  void append_section(const Parameter& row, ElementIndex parent);
  void append_element_of(const Parameter& row, ElementIndex element);
  /// Sections that say something by being there, where all their values are the default ones.
  void append_bare_sections();
  bool has_section(std::string_view name) const;
  void append(fmt::format_string<std::string_view&> header, std::string_view section,
              const std::vector<ValueLine>& lines);

  const Scene& scene_;
  std::filesystem::path folder_;
  std::vector<std::string_view> written_;
  std::string text_;
};

}  // namespace offing::scene
