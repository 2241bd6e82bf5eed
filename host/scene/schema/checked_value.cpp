#include "host/scene/schema/checked_value.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/file/nearest_name.h"

namespace offing::scene {

namespace {

std::string short_text(double number) {
  return fmt::format("{:.12g}", number);
}

/// The power of two within the parameter's range that is nearest.
double nearest_power_of_two(const Parameter& parameter, double number) {
  double nearest = 1.0;
  while (nearest < parameter.low) nearest *= 2.0;
  for (double next = 2.0 * nearest; next <= parameter.high; next *= 2.0) {
    if (std::abs(next - number) < std::abs(nearest - number)) nearest = next;
  }
  return nearest;
}

/// The numbers that a value was written as; none where it was written otherwise.
std::vector<double> numbers_of(const WrittenValue& written) {
  if (const auto* real = std::get_if<double>(&written.value)) return {*real};
  if (const auto* whole = std::get_if<std::int64_t>(&written.value)) return {static_cast<double>(*whole)};
  if (const auto* list = std::get_if<std::vector<double>>(&written.value)) return *list;
  return {};
}

/// The allowed value that is nearest to what was written; empty where nothing is near.
std::string nearest_allowed(const Parameter& parameter, const WrittenValue& written) {
  if (const auto* choice = std::get_if<ChoiceStorage>(&parameter.storage)) {
    const auto* name = std::get_if<std::string>(&written.value);
    return std::string(name ? nearest_name(*name, choice->names) : "");
  }
  std::vector<double> numbers = numbers_of(written);
  const bool has_seed = std::holds_alternative<ValueAt<std::uint64_t>>(parameter.storage);
  if (is_text(parameter) || has_seed || numbers.size() != (is_triple(parameter) ? 3u : 1u)) return "";
  for (double& number : numbers) {
    if (std::isnan(number)) return "";
    number = std::clamp(number, parameter.low, parameter.high);
    if (std::holds_alternative<ValueAt<int>>(parameter.storage)) number = std::round(number);
    if (parameter.rule == ParameterRule::power_of_two) number = nearest_power_of_two(parameter, number);
  }
  if (numbers.size() == 1) return short_text(numbers[0]);
  return fmt::format("[{}, {}, {}]", short_text(numbers[0]), short_text(numbers[1]), short_text(numbers[2]));
}

[[noreturn]] void refuse(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  std::string example = nearest_allowed(parameter, written);
  if (example.empty())
    example = parameter.example.empty() ? default_text(parameter) : std::string(parameter.example);
  const bool quote = is_text(parameter);
  const bool in_file = place.assignment.ends_with("= ");
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected {}, got {}", place.subject, expected_text(parameter), written.shown),
              fmt::format(fmt::runtime(quote && in_file ? "write {}\"{}\"" : "write {}{}"), place.assignment,
                          example));
}

/// Throws with the fix where a time lacks nothing but its zone.
void require_zone(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const std::string_view quote = written.shown.starts_with('"') ? "\"" : "";
  std::string_view text = written.shown;
  if (!quote.empty()) text = text.substr(1, text.size() - 2);
  if (!parse_iso_time(fmt::format("{}Z", text))) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected {}, got {} without a zone", place.subject, expected_text(parameter),
                          written.shown),
              fmt::format("add a Z, which means UTC: {}{}{}Z{}", place.assignment, quote, text, quote));
}

}  // namespace

bool is_text(const Parameter& parameter) {
  return std::holds_alternative<ChoiceStorage>(parameter.storage) ||
         std::holds_alternative<ValueAt<std::string>>(parameter.storage) ||
         std::holds_alternative<ValueAt<std::optional<UtcTime>>>(parameter.storage);
}

bool is_triple(const Parameter& parameter) {
  return std::holds_alternative<ValueAt<glm::dvec3>>(parameter.storage) ||
         std::holds_alternative<ValueAt<std::optional<glm::dvec3>>>(parameter.storage);
}

double checked_number(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  double number = std::numeric_limits<double>::quiet_NaN();
  if (const auto* real = std::get_if<double>(&written.value)) {
    number = *real;
  } else if (const auto* whole = std::get_if<std::int64_t>(&written.value)) {
    number = static_cast<double>(*whole);
  }
  if (!(number >= parameter.low && number <= parameter.high)) {  // false for NaN too
    refuse(parameter, written, place);
  }
  return number * parameter.scale;
}

glm::dvec3 checked_triple(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const auto* list = std::get_if<std::vector<double>>(&written.value);
  const auto is_within = [&](double number) { return number >= parameter.low && number <= parameter.high; };
  if (!list || list->size() != 3 || !std::all_of(list->begin(), list->end(), is_within)) {
    refuse(parameter, written, place);
  }
  return parameter.scale * glm::dvec3((*list)[0], (*list)[1], (*list)[2]);
}

std::int64_t checked_whole(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const auto* whole = std::get_if<std::int64_t>(&written.value);
  if (!whole || static_cast<double>(*whole) < parameter.low || static_cast<double>(*whole) > parameter.high) {
    refuse(parameter, written, place);
  }
  if (parameter.rule == ParameterRule::power_of_two && (*whole & (*whole - 1)) != 0) {
    refuse(parameter, written, place);
  }
  return *whole;
}

const std::string& checked_name(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const auto* name = std::get_if<std::string>(&written.value);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (!name || name->empty() || std::find_if(name->begin(), name->end(), is_control) != name->end()) {
    refuse(parameter, written, place);
  }
  return *name;
}

UtcTime checked_time(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const auto* text = std::get_if<std::string>(&written.value);
  const std::optional<UtcTime> time = text ? parse_iso_time(*text) : std::nullopt;
  if (!time || time->year < first_year || time->year > last_year) {
    require_zone(parameter, written, place);
    refuse(parameter, written, place);
  }
  return *time;
}

std::size_t checked_choice(const Parameter& parameter, const ChoiceStorage& choice,
                           const WrittenValue& written, const Place& place) {
  const auto* name = std::get_if<std::string>(&written.value);
  for (std::size_t i = 0; name && i < choice.names.size(); ++i) {
    if (choice.names[i] == *name) {
      return i;
    }
  }
  refuse(parameter, written, place);
}

}  // namespace offing::scene
