#include "host/scene/schema/parameter_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {
namespace {

using Number = ValueAt<double>;
using OptionalNumber = ValueAt<std::optional<double>>;
using Numbers = ValueAt<std::vector<double>>;
using Triple = ValueAt<glm::dvec3>;
using OptionalTriple = ValueAt<std::optional<glm::dvec3>>;
using Whole = ValueAt<int>;
using Seed = ValueAt<std::uint64_t>;
using Text = ValueAt<std::string>;

/// A default scene with one element in each repeated section, so that all values show.
Scene scene_with_elements() {
  Scene scene;
  for (const Parameter& row : parameter_table()) {
    if (elements_of(scene, *row.section).empty()) append_element(scene, row, {});
  }
  return scene;
}

const Place place{.subject = "here", .assignment = "it = "};

bool is_number(const Parameter& row) {
  return std::holds_alternative<Number>(row.storage) || std::holds_alternative<OptionalNumber>(row.storage) ||
         std::holds_alternative<Numbers>(row.storage);
}

bool is_triple(const Parameter& row) {
  return std::holds_alternative<Triple>(row.storage) || std::holds_alternative<OptionalTriple>(row.storage);
}

bool is_whole(const Parameter& row) {
  return std::holds_alternative<Whole>(row.storage) || std::holds_alternative<Seed>(row.storage);
}

void try_number(const Parameter& row, double value) {
  Scene scene;
  store(scene, row, {.value = value, .shown = "x"}, place);
}

void try_whole(const Parameter& row, std::int64_t value) {
  Scene scene;
  store(scene, row, {.value = value, .shown = "x"}, place);
}

template <class Attempt>
std::string refusal(Attempt attempt) {
  try {
    attempt();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
  return "";
}

class EachParameter : public testing::TestWithParam<Parameter> {};

INSTANTIATE_TEST_SUITE_P(Table, EachParameter,
                         testing::ValuesIn(parameter_table().begin(), parameter_table().end()),
                         [](const auto& tested) {
                           std::string name;  // ocean.swell_period_s is not ocean.swell.period_s
                           for (const char c : tested.param.key) name += c == '.' ? "__" : std::string(1, c);
                           return name;
                         });

// Fails if a row lacks what help, hints and messages are made of.
TEST_P(EachParameter, IsCompleteAndNamed) {
  const Parameter& row = GetParam();
  EXPECT_FALSE(row.help.empty());
  EXPECT_EQ(row.help.find("[["), std::string_view::npos)
      << "the window shows it to people who write no files";
  EXPECT_FALSE(default_text(row).empty()) << "neither a default nor a text for its absence";
  EXPECT_TRUE(row.flag.empty() || row.flag.starts_with("--"));
  const std::string key(row.key);
  const std::map<std::string_view, std::string> suffixes = {
      {"m", "_m"}, {"m/s", "_mps"}, {"s", "_s"}, {"deg", "_deg"}};
  if (const auto suffix = suffixes.find(row.unit); suffix != suffixes.end()) {
    EXPECT_TRUE(key.ends_with(suffix->second)) << "a key in " << row.unit;
  }
}

// Fails if the default is a value that its own row refuses, or if text and value do not go back and forth.
TEST_P(EachParameter, AcceptsItsOwnDefault) {
  const Parameter& row = GetParam();
  const std::string text = default_text(row);
  if (text == row.absent) {
    return;
  }
  Scene scene;
  store(scene, row, read_flag_value(row, text), place);
  EXPECT_EQ(value_text(scene, row), text);
}

// Fails if a hint shows a value that the row itself refuses.
TEST_P(EachParameter, AcceptsItsOwnExample) {
  const Parameter& row = GetParam();
  if (!row.example.empty()) {
    Scene scene;
    store(scene, row, read_flag_value(row, row.example), place);
    EXPECT_EQ(value_text(scene, row), row.example);
  }
}

// Fails if a bound of the range is off by one unit in the last place, or is not enforced at all.
TEST_P(EachParameter, HoldsItsRange) {
  const Parameter& row = GetParam();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (is_triple(row)) {
    const auto attempt = [&](double second) {
      Scene scene;
      store(scene, row, {.value = std::vector<double>{row.low, second, row.high}, .shown = "x"}, place);
    };
    EXPECT_NO_THROW(attempt(row.low));
    EXPECT_NO_THROW(attempt(row.high));
    EXPECT_THROW(attempt(std::nextafter(row.low, -infinity)), Error);
    EXPECT_THROW(attempt(std::nextafter(row.high, infinity)), Error);
    EXPECT_THROW(attempt(std::nan("")), Error);
  } else if (is_number(row)) {
    EXPECT_NO_THROW(try_number(row, row.low));
    EXPECT_NO_THROW(try_number(row, row.high));
    EXPECT_THROW(try_number(row, std::nextafter(row.low, -infinity)), Error);
    EXPECT_THROW(try_number(row, std::nextafter(row.high, infinity)), Error);
  } else if (is_whole(row)) {
    EXPECT_NO_THROW(try_whole(row, static_cast<std::int64_t>(row.low)));
    EXPECT_THROW(try_whole(row, static_cast<std::int64_t>(row.low) - 1), Error);
    if (std::holds_alternative<Whole>(row.storage)) {
      EXPECT_NO_THROW(try_whole(row, static_cast<std::int64_t>(row.high)));
      EXPECT_THROW(try_whole(row, static_cast<std::int64_t>(row.high) + 1), Error);
    } else {
      EXPECT_NO_THROW(try_whole(row, std::numeric_limits<std::int64_t>::max()));
    }
  }
}

// Fails if NaN or an infinity slips through a comparison.
TEST_P(EachParameter, RefusesWhatIsNotFinite) {
  const Parameter& row = GetParam();
  for (const double value :
       {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(try_number(row, value), Error) << value;
  }
  if (is_number(row)) {
    for (const char* text : {"nan", "inf", "-inf", "1e999"}) {
      Scene scene;
      EXPECT_THROW(store(scene, row, read_flag_value(row, text), place), Error) << text;
    }
  }
}

// Fails if a value of another type is taken, or if the message does not say what was due and what was found.
TEST_P(EachParameter, RefusesOtherTypes) {
  const Parameter& row = GetParam();
  Scene scene;
  const std::string other = refusal([&] { store(scene, row, {.value = {}, .shown = "true"}, place); });
  EXPECT_EQ(other, "here: expected " + expected_text(row) + ", got true");
  if (is_number(row) || is_whole(row)) {
    EXPECT_NE(refusal([&] { store(scene, row, read_flag_value(row, "17 kn"), place); }), "");
    EXPECT_NE(refusal([&] { store(scene, row, read_flag_value(row, ""), place); }), "");
  } else {
    EXPECT_NE(refusal([&] { try_whole(row, 3); }), "");
    EXPECT_NE(refusal([&] { store(scene, row, read_flag_value(row, ""), place); }), "");
  }
}

// Fails if a slider goes beyond what its row takes, or belongs to a widget that has none.
TEST(ParameterTable, SlidersAreWithinTheirRanges) {
  for (const Parameter& row : parameter_table()) {
    if (!row.slider) continue;
    EXPECT_TRUE(std::holds_alternative<ValueAt<double>>(row.storage) ||
                std::holds_alternative<ValueAt<std::optional<double>>>(row.storage) ||
                std::holds_alternative<ValueAt<glm::dvec3>>(row.storage))
        << row.key;
    EXPECT_LE(row.low, row.slider->low) << row.key;
    EXPECT_LT(row.slider->low, row.slider->high) << row.key;
    EXPECT_LE(row.slider->high, row.high) << row.key;
  }
}

// Fails if two rows share a key or a flag: one of them would be out of reach.
TEST(ParameterTable, KeysAndFlagsAreUnique) {
  std::set<std::string_view> keys;
  std::set<std::string_view> flags;
  for (const Parameter& row : parameter_table()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_TRUE(row.flag.empty() || flags.insert(row.flag).second) << row.flag;
  }
}

// Fails if two rows write the same member: setting one would show in the other.
TEST(ParameterTable, NoTwoRowsShareStorage) {
  for (const Parameter& row : parameter_table()) {
    Scene scene = scene_with_elements();
    const Scene before = scene;
    const std::string text = [&]() -> std::string {
      if (const auto* choice = std::get_if<ChoiceStorage>(&row.storage)) {
        return std::string(choice->names[choice->in(struct_at(&scene, *row.section, {})) == 0 ? 1 : 0]);
      }
      if (std::holds_alternative<Text>(row.storage)) {
        return "other.spec";
      }
      if (is_triple(row)) return "[0.25, 0.5, 0.75]";
      if (std::holds_alternative<ValueAt<std::optional<UtcTime>>>(row.storage)) {
        return "2001-02-03T04:05Z";
      }
      if (row.rule == ParameterRule::power_of_two) {
        return "16";
      }
      if (is_whole(row))
        return std::to_string(
            default_text(row) == "2" ? 3 : std::max(2, static_cast<int>(std::min(row.low, 1e9))));
      return std::to_string(0.27 * row.low + 0.73 * row.high);
    }();
    store(scene, row, read_flag_value(row, text), place);
    for (const Parameter& other : parameter_table()) {
      if (other.key == row.key) {
        EXPECT_NE(value_text(scene, other), value_text(before, other))
            << row.key << " was not stored: " << text;
      } else {
        EXPECT_EQ(value_text(scene, other), value_text(before, other)) << row.key << " changed " << other.key;
      }
    }
  }
}

// Fails if an element's value goes to another element, or elements are not counted.
TEST(ParameterTable, ElementsHoldTheirOwnValues) {
  const Parameter& amplitude = *find_parameter("ocean.swell.amplitude_m");
  const Parameter& period = *find_parameter("ocean.swell.period_s");
  Scene scene;
  store(scene, amplitude, {.value = 2.0, .shown = "2"}, place);
  append_element(scene, period, place);
  store(scene, period, {.value = 9.0, .shown = "9"}, place);
  ASSERT_EQ(scene.ocean.swells.size(), 2u);
  EXPECT_EQ(value_text(scene, amplitude), "2,0.5");
  EXPECT_EQ(value_text(scene, period), std::string(period.absent) + ",9");
  while (scene.ocean.swells.size() < 64) append_element(scene, amplitude, place);
  EXPECT_EQ(refusal([&] { append_element(scene, amplitude, place); }),
            "here: expected at most 64 sections, found more");
}

// Fails if a value that a simulation depends on may move, which nothing follows, or one that is no number;
// if an angle goes the long way round, or one that counts turns does not.
TEST(ParameterTable, OnlyValuesOfPicturesMove) {
  using enum ParameterGroup;
  int count = 0;
  for (const Parameter& row : parameter_table()) {
    if (row.motion == ParameterMotion::constant) continue;
    ++count;
    EXPECT_TRUE(row.group == camera || row.group == sun || row.group == sky || row.group == render ||
                row.group == light || row.group == mesh || row.group == highlight || row.group == cloud ||
                row.group == wake || row.group == wake_hull || row.group == body)
        << row.key;
    EXPECT_TRUE(std::holds_alternative<Number>(row.storage) || std::holds_alternative<Triple>(row.storage) ||
                std::holds_alternative<ValueAt<std::optional<double>>>(row.storage))
        << row.key;
    EXPECT_EQ(row.motion == ParameterMotion::keyed_angle,
              row.unit == "deg" && row.high - row.low >= 360.0 && row.high - row.low <= 720.0)
        << row.key;
  }
  EXPECT_EQ(count, 59);
}

// Fails if degrees are stored as radians or the other way round.
TEST(ParameterTable, DegreesBecomeRadians) {
  Scene scene;
  store(scene, *find_parameter("wind.direction_deg"), {.value = 90.0, .shown = "90"}, place);
  EXPECT_NEAR(scene.wind.wind_direction_rad, 1.5707963267948966, 1e-15);
}

// Fails if a size that is no power of two passes the range check.
TEST(ParameterTable, SizeIsAPowerOfTwo) {
  const Parameter& size = *find_parameter("ocean.size");
  EXPECT_THAT(refusal([&] { try_whole(size, 500); }),
              testing::StrEq("here: expected a power of two within [16, 4096], got x"));
}

}  // namespace
}  // namespace offing::scene
