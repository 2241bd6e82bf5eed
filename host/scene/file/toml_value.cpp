#include "host/scene/file/toml_value.h"

#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/utc_time.h"

namespace offing::scene {

namespace {

std::optional<std::string> utc_text(const toml::date_time& written) {
  if (!written.offset || written.time.nanosecond != 0) return std::nullopt;
  const UtcTime local{written.date.year, written.date.month,  written.date.day,
                      written.time.hour, written.time.minute, written.time.second};
  if (!is_valid(local)) return std::nullopt;
  return iso_time(from_unix_seconds(unix_seconds(local) - 60 * written.offset->minutes));
}

/// Those of a list of numbers.
std::optional<std::vector<double>> numbers_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->empty()) return std::nullopt;
  std::vector<double> numbers;
  for (const toml::node& each : *list) {
    if (!each.is_number()) return std::nullopt;
    numbers.push_back(*each.value<double>());
  }
  return numbers;
}

std::string cut(std::string shown) {
  constexpr std::size_t longest = 60;
  if (shown.size() > longest) shown = shown.substr(0, longest - 3) + "...";
  return shown;
}

}  // namespace

std::string place_text(std::string_view file, const toml::source_region& region) {
  if (file.empty()) return "scene";
  return fmt::format("{}:{}:{}", file, region.begin.line, region.begin.column);
}

std::string shown_text(const toml::node& node) {
  if (const std::optional<std::vector<double>> numbers = numbers_of(node)) {
    return cut(fmt::format("[{:g}]", fmt::join(*numbers, ", ")));
  }
  std::ostringstream text;
  node.visit([&](const auto& value) {
    using Node = std::remove_cvref_t<decltype(value)>;
    if constexpr (toml::is_table<Node>) {
      text << "a table";
    } else if constexpr (toml::is_array<Node>) {
      text << "an array";
    } else if constexpr (toml::is_string<Node>) {
      text << '"' << *value << '"';
    } else if constexpr (toml::is_boolean<Node>) {
      text << (*value ? "true" : "false");
    } else {
      text << value;
    }
  });
  return cut(text.str());
}

WrittenValue written_value(const toml::node& node) {
  WrittenValue written{.value = {}, .shown = shown_text(node)};
  if (const auto* whole = node.as_integer()) {
    written.value = whole->get();
  } else if (const auto* real = node.as_floating_point()) {
    written.value = real->get();
  } else if (const auto* text = node.as_string()) {
    written.value = text->get();
  } else if (std::optional<std::vector<double>> numbers = numbers_of(node)) {
    written.value = std::move(*numbers);
  } else if (const auto* date = node.as_date_time()) {
    if (std::optional<std::string> utc = utc_text(date->get())) written.value = std::move(*utc);
  }
  return written;
}

}  // namespace offing::scene
