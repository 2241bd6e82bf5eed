#include "host/scene/schema/parameter.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/scene/schema/checked_value.h"
#include "host/scene/schema/scene_elements.h"

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

template <class Number>
std::optional<Number> parse_whole_text(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) {
    return std::nullopt;
  }
  return number;
}

/// The numbers of "[1, 2.5, 3]" or "1, 2.5, 3".
std::optional<std::vector<double>> parse_list_text(std::string_view text) {
  if (text.starts_with('[') && text.ends_with(']')) text = text.substr(1, text.size() - 2);
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    const std::size_t end = std::min(text.find(','), text.size());
    const std::optional<double> number = parse_whole_text<double>(text.substr(0, end));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (end == text.size()) return numbers;
    text.remove_prefix(end + 1);
  }
}

void append_to_list(std::vector<double>& list, const Parameter& parameter, const WrittenValue& written,
                    const Place& place) {
  const double number = checked_number(parameter, written, place);
  if (list.size() == parameter.max_count) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected at most {} values, found more", place.subject, parameter.max_count),
                "remove the values that are too many");
  }
  list.push_back(number);
}

/// `scene` is only read; accessors hand out references that can be written through.
std::string text_of(Scene& scene, const Parameter& parameter, ElementIndex element, Digits digits) {
  const auto scaled = [&](double value) { return number_text(value / parameter.scale, digits); };
  const auto triple = [&](const glm::dvec3& value) {
    return fmt::format("[{}, {}, {}]", scaled(value.x), scaled(value.y), scaled(value.z));
  };
  const std::string absent{parameter.absent};
  return std::visit(
      Overloaded{
          [&](ValueAt<double> at) { return scaled(at(scene, element)); },
          [&](ValueAt<std::optional<double>> at) {
            return at(scene, element) ? scaled(*at(scene, element)) : absent;
          },
          [&](ValueAt<int> at) { return fmt::format("{}", at(scene, element)); },
          [&](ValueAt<std::uint64_t> at) { return fmt::format("{}", at(scene, element)); },
          [&](ValueAt<std::string> at) { return at(scene, element).empty() ? absent : at(scene, element); },
          [&](ValueAt<std::optional<UtcTime>> at) {
            return at(scene, element) ? iso_time(*at(scene, element)).value_or("") : absent;
          },
          [&](ValueAt<std::vector<double>> at) {
            std::vector<std::string> texts;
            for (const double value : at(scene, element)) texts.push_back(scaled(value));
            return texts.empty() ? absent : fmt::format("{}", fmt::join(texts, ","));
          },
          [&](ValueAt<glm::dvec3> at) { return triple(at(scene, element)); },
          [&](ValueAt<std::optional<glm::dvec3>> at) {
            return at(scene, element) ? triple(*at(scene, element)) : absent;
          },
          [&](const ChoiceStorage& choice) { return std::string(choice.names[choice.get(scene, element)]); },
      },
      parameter.storage);
}

}  // namespace

void store(Scene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place,
           std::optional<ElementIndex> element) {
  const ElementIndex index = element ? *element : last_element_or_first(scene, parameter, place);
  std::visit(
      Overloaded{
          [&](ValueAt<double> at) { at(scene, index) = checked_number(parameter, written, place); },
          [&](ValueAt<std::optional<double>> at) {
            at(scene, index) = checked_number(parameter, written, place);
          },
          [&](ValueAt<int> at) {
            at(scene, index) = static_cast<int>(checked_whole(parameter, written, place));
          },
          [&](ValueAt<std::uint64_t> at) {
            at(scene, index) = static_cast<std::uint64_t>(checked_whole(parameter, written, place));
          },
          [&](ValueAt<std::string> at) { at(scene, index) = checked_name(parameter, written, place); },
          [&](ValueAt<std::optional<UtcTime>> at) {
            at(scene, index) = checked_time(parameter, written, place);
          },
          [&](ValueAt<std::vector<double>> at) {
            append_to_list(at(scene, index), parameter, written, place);
          },
          [&](ValueAt<glm::dvec3> at) { at(scene, index) = checked_triple(parameter, written, place); },
          [&](ValueAt<std::optional<glm::dvec3>> at) {
            at(scene, index) = checked_triple(parameter, written, place);
          },
          [&](const ChoiceStorage& choice) {
            choice.set(scene, index, checked_choice(parameter, choice, written, place));
          },
      },
      parameter.storage);
  for (std::size_t number = 0; number < 3; ++number) scene.tracks.erase({parameter.key, index, number});
  scene.set_at.insert_or_assign({parameter.key, index}, place.subject);
}

void clear_list(Scene& scene, const Parameter& parameter) {
  if (const auto* at = std::get_if<ValueAt<std::vector<double>>>(&parameter.storage)) {
    (*at)(scene, {}).clear();
  }
}

WrittenValue read_flag_value(const Parameter& parameter, std::string_view text) {
  WrittenValue written{.value = std::string(text), .shown = fmt::format("\"{}\"", text)};
  if (is_text(parameter)) {
    return written;
  }
  if (is_triple(parameter)) {
    if (auto list = parse_list_text(text)) written.value = std::move(*list);
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
  const auto triple = [&](auto) { return "a list of three numbers" + range; };
  return std::visit(
      Overloaded{
          [&](ValueAt<double> at) { return number(at); },
          [&](ValueAt<std::optional<double>> at) { return number(at); },
          [&](ValueAt<std::vector<double>> at) { return number(at); },
          [&](ValueAt<glm::dvec3> at) { return triple(at); },
          [&](ValueAt<std::optional<glm::dvec3>> at) { return triple(at); },
          [&](ValueAt<int> at) { return whole(at); },
          [](ValueAt<std::uint64_t>) {
            // The largest value does not fit a double exactly: written out.
            return fmt::format("a whole number within [0, {}]", std::numeric_limits<std::int64_t>::max());
          },
          [&](ValueAt<std::string>) {
            return std::string(parameter.rule == ParameterRule::file_name ? "a file name" : "a name");
          },
          [](ValueAt<std::optional<UtcTime>>) {
            return fmt::format("a time in UTC of the years {} ... {}", first_year, last_year);
          },
          [](const ChoiceStorage& choice) { return fmt::format("one of {}", fmt::join(choice.names, ", ")); },
      },
      parameter.storage);
}

std::string value_text(const Scene& scene, const Parameter& parameter, ElementIndex element, Digits digits) {
  Scene copy = scene;
  return text_of(copy, parameter, element, digits);
}

std::string value_text(const Scene& scene, const Parameter& parameter, Digits digits) {
  Scene copy = scene;
  std::string text;
  std::optional<ElementIndex> before;
  for (const ElementIndex element : elements_of(scene, parameter.elements)) {
    if (before) text += parameter.elements->parent && before->outer != element.outer ? ';' : ',';
    text += text_of(copy, parameter, element, digits);
    before = element;
  }
  return before ? text : "none";
}

std::string default_text(const Parameter& parameter) {
  Scene scene;
  append_element(scene, parameter, {});
  return value_text(scene, parameter);
}

}  // namespace offing::scene
