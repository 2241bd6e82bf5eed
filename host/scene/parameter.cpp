#include "host/scene/parameter.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"

namespace offing::scene {

namespace {

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

std::string number_text(double value, Digits digits = Digits::readable) {
  return digits == Digits::readable ? fmt::format("{:.12g}", value) : fmt::format("{:.17g}", value);
}

/// Whether values are written in quotes.
bool is_text(const Parameter& parameter) {
  return std::holds_alternative<ChoiceStorage>(parameter.storage) ||
         std::holds_alternative<std::string& (*)(OceanScene&)>(parameter.storage) ||
         std::holds_alternative<std::optional<UtcTime>& (*)(OceanScene&)>(parameter.storage);
}

[[noreturn]] void refuse(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const std::string example{parameter.example.empty() ? default_text(parameter)
                                                      : std::string(parameter.example)};
  const bool quote = is_text(parameter);
  const bool in_file = place.assignment.ends_with("= ");
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected {}, got {}", place.subject, expected_text(parameter), written.shown),
              fmt::format(fmt::runtime(quote && in_file ? "write {}\"{}\"" : "write {}{}"), place.assignment,
                          example));
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

/// A file name: not empty, and free of control characters, which would break messages and cut the name at a
/// NUL.
const std::string& checked_name(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const auto* name = std::get_if<std::string>(&written.value);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (!name || name->empty() || std::find_if(name->begin(), name->end(), is_control) != name->end()) {
    refuse(parameter, written, place);
  }
  return *name;
}

/// Years for which the sun's place is known (host/sky/sun_position.h).
constexpr int first_year = 1900, last_year = 2100;

/// Throws with the mend where a time lacks nothing but its zone.
void require_zone(const Parameter& parameter, const WrittenValue& written, const Place& place) {
  const std::string_view quote = written.shown.starts_with('"') ? "\"" : "";
  std::string_view text = written.shown;
  if (!quote.empty()) text = text.substr(1, text.size() - 2);
  if (!parse_iso_time(fmt::format("{}Z", text))) return;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("{}: expected {}, got {} without a zone", place.subject, expected_text(parameter),
                  written.shown),
      fmt::format("add a Z, which says that it is UTC: {}{}{}Z{}", place.assignment, quote, text, quote));
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

template <class Number>
std::optional<Number> parse_whole_text(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return number;
}

}  // namespace

void store(OceanScene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place) {
  std::visit(
      Overloaded{
          [&](double& (*at)(OceanScene&)) { at(scene) = checked_number(parameter, written, place); },
          [&](std::optional<double>& (*at)(OceanScene&)) {
            at(scene) = checked_number(parameter, written, place);
          },
          [&](int& (*at)(OceanScene&)) {
            at(scene) = static_cast<int>(checked_whole(parameter, written, place));
          },
          [&](std::uint64_t& (*at)(OceanScene&)) {
            at(scene) = static_cast<std::uint64_t>(checked_whole(parameter, written, place));
          },
          [&](std::string& (*at)(OceanScene&)) { at(scene) = checked_name(parameter, written, place); },
          [&](std::optional<UtcTime>& (*at)(OceanScene&)) {
            at(scene) = checked_time(parameter, written, place);
          },
          [&](std::vector<double>& (*at)(OceanScene&)) {
            const double number = checked_number(parameter, written, place);
            if (at(scene).size() == parameter.max_count) {
              throw Error(ErrorKind::bad_input,
                          fmt::format("{}: expected at most {} values, found more", place.subject,
                                      parameter.max_count),
                          "remove the values that are too many");
            }
            at(scene).push_back(number);
          },
          [&](const ChoiceStorage& choice) {
            choice.set(scene, checked_choice(parameter, choice, written, place));
          },
          [&](const ElementStorage& element) {
            const double number = checked_number(parameter, written, place);
            if (element.count(scene) == 0) element.append(scene);
            std::visit([&](auto at) { at(scene, element.count(scene) - 1) = number; }, element.at);
          },
      },
      parameter.storage);
  scene.tracks.erase(parameter.key);
  scene.set_at.insert_or_assign(parameter.key, place.subject);
}

void clear_list(OceanScene& scene, const Parameter& parameter) {
  if (const auto* at = std::get_if<std::vector<double>& (*)(OceanScene&)>(&parameter.storage)) {
    (*at)(scene).clear();
  }
}

void append_element(OceanScene& scene, const Parameter& parameter, const Place& place) {
  const auto* element = std::get_if<ElementStorage>(&parameter.storage);
  if (!element) return;
  if (element->count(scene) == parameter.max_count) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected at most {} sections, found more", place.subject, parameter.max_count),
        "remove the sections that are too many");
  }
  element->append(scene);
}

WrittenValue read_flag_value(const Parameter& parameter, std::string_view text) {
  WrittenValue written{.value = std::string(text), .shown = fmt::format("\"{}\"", text)};
  if (is_text(parameter)) {
    return written;
  }
  if (const auto whole = parse_whole_text<std::int64_t>(text)) {
    written.value = *whole;
  } else if (const auto real = parse_whole_text<double>(text)) {
    written.value = *real;
  }
  return written;
}

std::string expected_text(const Parameter& parameter) {
  const std::string in_unit = parameter.unit.empty() ? "" : fmt::format(" in {}", parameter.unit);
  const std::string range =
      fmt::format("{} within [{}, {}]", in_unit, number_text(parameter.low), number_text(parameter.high));
  const auto number = [&](auto) { return "a number" + range; };
  const auto whole = [&](auto) {
    return (parameter.rule == ParameterRule::power_of_two ? "a power of two" : "a whole number") + range;
  };
  return std::visit(
      Overloaded{
          [&](double& (*at)(OceanScene&)) { return number(at); },
          [&](std::optional<double>& (*at)(OceanScene&)) { return number(at); },
          [&](std::vector<double>& (*at)(OceanScene&)) { return number(at); },
          [&](int& (*at)(OceanScene&)) { return whole(at); },
          [](std::uint64_t& (*)(OceanScene&)) {
            // The largest value does not fit a double exactly: written out.
            return fmt::format("a whole number within [0, {}]", std::numeric_limits<std::int64_t>::max());
          },
          [](std::string& (*)(OceanScene&)) { return std::string("a file name"); },
          [](std::optional<UtcTime>& (*)(OceanScene&)) {
            return fmt::format("a time in UTC of the years {} ... {}", first_year, last_year);
          },
          [](const ChoiceStorage& choice) { return fmt::format("one of {}", fmt::join(choice.names, ", ")); },
          [&](const ElementStorage& element) { return number(element); },
      },
      parameter.storage);
}

std::string value_text(const OceanScene& scene, const Parameter& parameter, Digits digits) {
  OceanScene copy = scene;  // accessors hand out references that can be written through
  const auto scaled = [&](double value) { return number_text(value / parameter.scale, digits); };
  const std::string absent{parameter.absent};
  return std::visit(
      Overloaded{
          [&](double& (*at)(OceanScene&)) { return scaled(at(copy)); },
          [&](std::optional<double>& (*at)(OceanScene&)) { return at(copy) ? scaled(*at(copy)) : absent; },
          [&](int& (*at)(OceanScene&)) { return fmt::format("{}", at(copy)); },
          [&](std::uint64_t& (*at)(OceanScene&)) { return fmt::format("{}", at(copy)); },
          [&](std::string& (*at)(OceanScene&)) { return at(copy).empty() ? absent : at(copy); },
          [&](std::optional<UtcTime>& (*at)(OceanScene&)) {
            return at(copy) ? iso_time(*at(copy)).value_or("") : absent;
          },
          [&](std::vector<double>& (*at)(OceanScene&)) {
            std::vector<std::string> texts;
            for (const double value : at(copy)) {
              texts.push_back(scaled(value));
            }
            return texts.empty() ? absent : fmt::format("{}", fmt::join(texts, ","));
          },
          [&](const ChoiceStorage& choice) { return std::string(choice.names[choice.get(copy)]); },
          [&](const ElementStorage& element) {
            std::vector<std::string> texts;
            for (std::size_t i = 0; i < element.count(copy); ++i) {
              const std::optional<double> value =
                  std::visit([&](auto at) { return std::optional<double>(at(copy, i)); }, element.at);
              texts.push_back(value ? scaled(*value) : absent);
            }
            return texts.empty() ? "none" : fmt::format("{}", fmt::join(texts, ","));
          },
      },
      parameter.storage);
}

std::string default_text(const Parameter& parameter) {
  OceanScene scene;
  append_element(scene, parameter, {});
  return value_text(scene, parameter);
}

}  // namespace offing::scene
