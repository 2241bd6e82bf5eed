#include "host/scene/schema/parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
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
                "remove some values");
  }
  list.push_back(number);
}

/// The shortest text that reads back to a stored number.
std::string shortest_text(double stored, double scale) {
  constexpr int readable = 12, whole = 17;
  const double written = stored / scale;
  // A quotient does not always give its number back: one of its neighbours does.
  for (const double near : {written, std::nextafter(written, std::numeric_limits<double>::lowest()),
                            std::nextafter(written, std::numeric_limits<double>::max())}) {
    for (int digits = readable; digits <= whole; ++digits) {
      std::string text = fmt::format("{:.{}g}", near, digits);
      if (*parse_whole_text<double>(text) * scale == stored) return text;
    }
  }
  return number_text(written, Digits::exact);
}

}  // namespace

bool is_same_value(const Parameter& row, const void* a, const void* b) {
  return std::visit([&](const auto& at) { return at.in(a) == at.in(b); }, row.storage);
}

void copy_value(const Parameter& row, const void* from, void* to) {
  std::visit(Overloaded{[&](const ChoiceStorage& choice) { choice.set_in(to, choice.in(from)); },
                        [&](const auto& at) { at.in(to) = at.in(from); }},
             row.storage);
}

std::any value_in(const void* section, const Parameter& row) {
  return std::visit([&](const auto& at) { return std::any(at.in(section)); }, row.storage);
}

void put_in(void* section, const Parameter& row, const std::any& value) {
  std::visit(
      Overloaded{
          [&](const ChoiceStorage& choice) { choice.set_in(section, std::any_cast<std::size_t>(value)); },
          [&]<class Value>(ValueAt<Value> at) { at.in(section) = std::any_cast<const Value&>(value); }},
      row.storage);
}

std::vector<double*> numbers_in(void* section, const Parameter& row) {
  return std::visit(Overloaded{[&](ValueAt<double> at) { return std::vector{&at.in(section)}; },
                               [&](ValueAt<std::optional<double>> at) {
                                 std::optional<double>& number = at.in(section);
                                 return number ? std::vector{&*number} : std::vector<double*>{};
                               },
                               [&](ValueAt<glm::dvec3> at) {
                                 glm::dvec3& triple = at.in(section);
                                 return std::vector{&triple.x, &triple.y, &triple.z};
                               },
                               [](const auto&) { return std::vector<double*>{}; }},
                    row.storage);
}

void store_in(void* section, const Parameter& row, const WrittenValue& written, const Place& place) {
  const auto number = [&](auto at) { at.in(section) = checked_number(row, written, place); };
  const auto triple = [&](auto at) { at.in(section) = checked_triple(row, written, place); };
  std::visit(
      Overloaded{
          [&](ValueAt<double> at) { number(at); },
          [&](ValueAt<std::optional<double>> at) { number(at); },
          [&](ValueAt<int> at) { at.in(section) = static_cast<int>(checked_whole(row, written, place)); },
          [&](ValueAt<std::uint64_t> at) {
            at.in(section) = static_cast<std::uint64_t>(checked_whole(row, written, place));
          },
          [&](ValueAt<std::string> at) { at.in(section) = checked_name(row, written, place); },
          [&](ValueAt<std::optional<UtcTime>> at) { at.in(section) = checked_time(row, written, place); },
          [&](ValueAt<std::vector<double>> at) { append_to_list(at.in(section), row, written, place); },
          [&](ValueAt<glm::dvec3> at) { triple(at); },
          [&](ValueAt<std::optional<glm::dvec3>> at) { triple(at); },
          [&](const ChoiceStorage& choice) {
            choice.set_in(section, checked_choice(row, choice, written, place));
          },
      },
      row.storage);
}

std::string numbers_text(const Parameter& row, std::span<const double> stored) {
  if (stored.size() == 1) return shortest_text(stored[0], row.scale);
  std::vector<std::string> texts;
  for (const double number : stored) texts.push_back(shortest_text(number, row.scale));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string text_in(const void* section, const Parameter& row, Digits digits) {
  const auto scaled = [&](double value) {
    return digits == Digits::reads_back ? shortest_text(value, row.scale)
                                        : number_text(value / row.scale, digits);
  };
  const auto triple = [&](const glm::dvec3& value) {
    return fmt::format("[{}, {}, {}]", scaled(value.x), scaled(value.y), scaled(value.z));
  };
  const std::string absent{row.absent};
  return std::visit(
      Overloaded{
          [&](ValueAt<double> at) { return scaled(at.in(section)); },
          [&](ValueAt<std::optional<double>> at) {
            return at.in(section) ? scaled(*at.in(section)) : absent;
          },
          [&](ValueAt<int> at) { return fmt::format("{}", at.in(section)); },
          [&](ValueAt<std::uint64_t> at) { return fmt::format("{}", at.in(section)); },
          [&](ValueAt<std::string> at) { return at.in(section).empty() ? absent : at.in(section); },
          [&](ValueAt<std::optional<UtcTime>> at) {
            return at.in(section) ? iso_time(*at.in(section)).value_or("") : absent;
          },
          [&](ValueAt<std::vector<double>> at) {
            std::vector<std::string> texts;
            for (const double value : at.in(section)) texts.push_back(scaled(value));
            return texts.empty() ? absent : fmt::format("{}", fmt::join(texts, ","));
          },
          [&](ValueAt<glm::dvec3> at) { return triple(at.in(section)); },
          [&](ValueAt<std::optional<glm::dvec3>> at) {
            return at.in(section) ? triple(*at.in(section)) : absent;
          },
          [&](const ChoiceStorage& choice) { return std::string(choice.names[choice.in(section)]); },
      },
      row.storage);
}

void store(Scene& scene, const Parameter& parameter, const WrittenValue& written, const Place& place,
           std::optional<ElementIndex> element) {
  const ElementIndex index = element ? *element : last_element_or_first(scene, parameter, place);
  store_in(struct_at(&scene, *parameter.section, index), parameter, written, place);
  for (std::size_t number = 0; number < 3; ++number) scene.tracks.erase({parameter.key, index, number});
  scene.set_at.insert_or_assign({parameter.key, index}, place.subject);
}

void clear_list(Scene& scene, const Parameter& parameter) {
  if (const auto* at = std::get_if<ValueAt<std::vector<double>>>(&parameter.storage)) {
    at->in(struct_at(&scene, *parameter.section, {})).clear();
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
  return text_in(struct_at(&scene, *parameter.section, element), parameter, digits);
}

std::string value_text(const Scene& scene, const Parameter& parameter, Digits digits) {
  std::string text;
  std::optional<ElementIndex> before;
  for (const ElementIndex element : elements_in(&scene, *parameter.section)) {
    if (before) text += parameter.section->repeated_parent() && before->outer != element.outer ? ';' : ',';
    text += value_text(scene, parameter, element, digits);
    before = element;
  }
  return before ? text : "none";
}

std::string default_text(const Parameter& parameter) {
  return text_in(default_struct(*parameter.section), parameter, Digits::readable);
}

}  // namespace offing::scene
