#include "host/scene/schema/key_tables.h"

#include <algorithm>

#include <fmt/format.h>

namespace offing::scene {

namespace {

constexpr std::string_view heading = R"(# Scene keys

This page is the output of `offing scene keys --format markdown`. [scenes.md](../scenes.md) describes the format.

"moves" marks values that may have [keyframes](../scenes.md#keyframes); "turn" marks angles, which go the shorter way. Flags are those
of `offing ocean`.
)";

}  // namespace

std::string header_of(const Parameter& row) {
  return fmt::format(fmt::runtime(row.max_count > 1 ? "[[{}]]" : "[{}]"), row.section->name);
}

std::string_view motion_text(const Parameter& row) {
  switch (row.motion) {
    case ParameterMotion::keyed:
      return "keys";
    case ParameterMotion::keyed_angle:
      return "keys, turn";
    case ParameterMotion::constant:
      break;
  }
  return "";
}

std::vector<Parameter> by_section(std::span<const Parameter> rows) {
  std::vector<const Section*> sections;
  for (const Parameter& row : rows) {
    if (std::ranges::find(sections, row.section) == sections.end()) sections.push_back(row.section);
  }
  std::vector<Parameter> sorted(rows.begin(), rows.end());
  std::ranges::stable_sort(sorted, {},
                           [&](const Parameter& row) { return std::ranges::find(sections, row.section); });
  return sorted;
}

std::string key_page(std::span<const Parameter> rows) {
  std::string text(heading);
  const Section* section = nullptr;
  for (const Parameter& row : by_section(rows)) {
    if (row.section != section) {
      section = row.section;
      text += fmt::format("\n## `{}`\n\n", header_of(row));
      if (row.max_count > 1) text += fmt::format("At most {} of them.\n\n", row.max_count);
      text += "| key | value | default | moves | flag | meaning |\n|---|---|---|---|---|---|\n";
    }
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", name_of(row.key), expected_text(row),
                        default_text(row), motion_text(row),
                        row.flag.empty() ? std::string() : fmt::format("`{}`", row.flag), row.help);
  }
  return text;
}

}  // namespace offing::scene
