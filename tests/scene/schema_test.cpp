// The schemas of sections, on a toy of their own: no scene knows it.
#include "host/scene/schema/schema.h"

#include <algorithm>
#include <any>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/sections.h"

namespace offing::scene {
namespace {

enum class Sail { triangular, square };

struct ToyMast {
  double height_m = 10.0;
  std::optional<Sail> sail;
};

struct ToyHold {
  int barrels = 3;
};

struct ToyShip {
  std::string name;
  ToyHold hold;
  std::vector<ToyMast> masts;
};

struct ToyFleet {
  double unused_before = 0.0;  // so that no section begins where the whole does
  std::vector<ToyShip> ships;
  ToyHold depot;
};

std::string needs_sail(const UseContext&, const ToyMast& mast) {
  return mast.sail ? "" : "the mast has no sail";
}

Schema<ToyHold> hold_schema(std::string name) {
  Schema<ToyHold> schema(std::move(name));
  return schema.rows(ParameterGroup::world, Affects::bodies,
                     {{&ToyHold::barrels, {.key = "barrels", .low = 0.0, .high = 9.0}}});
}

Schema<ToyFleet> fleet_schema() {
  Schema<ToyMast> mast("mast");
  mast.rows(ParameterGroup::world, Affects::bodies,
            {{&ToyMast::height_m,
              {.key = "height_m", .affects = Affects::wakes, .unit = "m", .low = 0.0, .high = 99.0},
              needs_sail},
             {choice_or("bare", &ToyMast::sail, {"triangular", "square"}), {.key = "sail"}}});
  Schema<ToyShip> ship("ship");
  ship.rows(ParameterGroup::world, Affects::bodies,
            {{&ToyShip::name, {.key = "name", .absent = "none", .instead_of = "number"}}})
      .section(&ToyShip::hold, hold_schema("hold"))
      .rows(ParameterGroup::world, Affects::bodies,
            {{path(&ToyShip::hold, &ToyHold::barrels), {.key = "cargo", .alias = "load", .high = 9.0}}})
      .list(&ToyShip::masts, 3, mast);
  Schema<ToyFleet> fleet;
  return fleet.list(&ToyFleet::ships, 2, ship).section(&ToyFleet::depot, hold_schema("depot"));
}

class ToySchema : public testing::Test {
 protected:
  ToySchema() {
    fleet_.ships.resize(2);
    fleet_.ships[1].masts.resize(2);
  }

  const Parameter& row(std::string_view key) const {
    return *std::ranges::find(table_.rows(), key, &Parameter::key);
  }
  const void* struct_of(const Parameter& of, ElementIndex element = {}) const {
    return struct_at(&fleet_, *of.section, element);
  }
  void* struct_of(const Parameter& of, ElementIndex element = {}) {
    return struct_at(&fleet_, *of.section, element);
  }

  const SchemaTable table_{fleet_schema().node()};
  ToyFleet fleet_;
};

// Fails if keys lack their sections, or come in another order than they were written in.
TEST_F(ToySchema, KeysAreWholeAndInOrder) {
  std::vector<std::string_view> keys;
  for (const Parameter& each : table_.rows()) keys.push_back(each.key);
  EXPECT_THAT(keys, testing::ElementsAre("ship.name", "ship.hold.barrels", "ship.cargo", "ship.mast.height_m",
                                         "ship.mast.sail", "depot.barrels"));
  EXPECT_EQ(row("ship.name").instead_of, "ship.number");
  EXPECT_EQ(row("ship.cargo").alias, "ship.load");
  EXPECT_EQ(row("ship.name").max_count, 2u);
  EXPECT_EQ(row("depot.barrels").max_count, 1u);
}

// Fails if a row does not say what it affects, or does not inherit it.
TEST_F(ToySchema, RowsAffectWhatThoseAroundThemDo) {
  EXPECT_EQ(row("ship.mast.height_m").affects, Affects::wakes);
  EXPECT_EQ(row("ship.mast.sail").affects, Affects::bodies);
}

// Fails if a section is looked for in another element, or a section of one struct counts as an element.
TEST_F(ToySchema, SectionsLieInTheirElements) {
  EXPECT_EQ(struct_of(row("ship.mast.sail"), {1, 1}), &fleet_.ships[1].masts[1]);
  EXPECT_EQ(struct_of(row("ship.hold.barrels"), {1, 0}), &fleet_.ships[1].hold);
  EXPECT_EQ(struct_of(row("depot.barrels")), &fleet_.depot);
  EXPECT_THAT(elements_in(&fleet_, *row("ship.mast.sail").section),
              testing::ElementsAre(ElementIndex{1, 0}, ElementIndex{1, 1}));
  EXPECT_THAT(elements_in(&fleet_, *row("ship.hold.barrels").section),
              testing::ElementsAre(ElementIndex{0, 0}, ElementIndex{1, 0}));
  EXPECT_EQ(row("ship.mast.sail").section->repeated_parent(), row("ship.name").section);
}

// Fails if elements are appended to or taken from another list.
TEST_F(ToySchema, ListsGrowAndShrink) {
  const Section& masts = *row("ship.mast.sail").section;
  append_to(&fleet_, masts, {0, 0});
  EXPECT_EQ(fleet_.ships[0].masts.size(), 1u);
  fleet_.ships[1].masts[1].height_m = 20.0;
  remove_from(&fleet_, masts, {1, 0});
  ASSERT_EQ(count_of(&fleet_, masts, {1, 0}), 1u);
  EXPECT_EQ(fleet_.ships[1].masts[0].height_m, 20.0);
}

// Fails if a value is not stored, not checked, or copied and compared as another one.
TEST_F(ToySchema, ValuesAreStoredComparedAndCopied) {
  const Parameter& height = row("ship.mast.height_m");
  void* first = struct_of(height, {1, 0});
  void* second = struct_of(height, {1, 1});
  const Place place{.subject = "here", .assignment = "height_m = "};
  store_in(first, height, {.value = 42.0, .shown = "42"}, place);
  EXPECT_EQ(fleet_.ships[1].masts[0].height_m, 42.0);
  EXPECT_THROW(store_in(first, height, {.value = 100.0, .shown = "100"}, place), Error);
  EXPECT_FALSE(is_same_value(height, first, second));
  copy_value(height, first, second);
  EXPECT_TRUE(is_same_value(height, first, second));
  EXPECT_EQ(fleet_.ships[1].masts[1].height_m, 42.0);
  EXPECT_THAT(numbers_in(first, height), testing::ElementsAre(&fleet_.ships[1].masts[0].height_m));
  EXPECT_TRUE(numbers_in(first, row("ship.mast.sail")).empty());
}

// Fails if a value of any type is not what was kept of it.
TEST_F(ToySchema, ValuesArePutBack) {
  for (const Parameter& each : table_.rows()) {
    const ElementIndex element = each.section->repeated_parent() ? ElementIndex{1, 0} : ElementIndex{};
    ToyFleet other = fleet_;
    void* section = struct_at(&other, *each.section, element);
    const std::any kept = value_in(section, each);
    const std::string before = text_in(section, each, Digits::exact);
    other.ships[1] = {.name = "other", .hold = {8}, .masts = {{.height_m = 1.0, .sail = Sail::square}}};
    other.ships[0] = other.ships[1];
    other.depot = {7};
    section = struct_at(&other, *each.section, element);
    EXPECT_NE(text_in(section, each, Digits::exact), before) << each.key;
    put_in(section, each, kept);
    EXPECT_EQ(text_in(section, each, Digits::exact), before) << each.key;
  }
}

// Fails if an absent choice is not the first name, or a name is another value.
TEST_F(ToySchema, AnAbsentChoiceHasAName) {
  const Parameter& sail = row("ship.mast.sail");
  void* mast = struct_of(sail, {1, 0});
  EXPECT_EQ(text_in(mast, sail, Digits::readable), "bare");
  store_in(mast, sail, {.value = std::string("square"), .shown = "square"}, {});
  EXPECT_EQ(fleet_.ships[1].masts[0].sail, Sail::square);
  store_in(mast, sail, {.value = std::string("bare"), .shown = "bare"}, {});
  EXPECT_FALSE(fleet_.ships[1].masts[0].sail);
}

// Fails if a row is asked about another struct than that of its section.
TEST_F(ToySchema, RowsTellWhyTheyAreUnused) {
  const Scene scene;
  const Parameter& height = row("ship.mast.height_m");
  fleet_.ships[1].masts[1].sail = Sail::square;
  EXPECT_EQ(height.unused({.scene = scene}, struct_of(height, {1, 0})), "the mast has no sail");
  EXPECT_EQ(height.unused({.scene = scene}, struct_of(height, {1, 1})), "");
  EXPECT_FALSE(row("ship.name").unused);
}

// Fails if an angle that was written in tenths of degrees is saved as another one, or with more digits:
// degrees are kept as radians, and the quotient is not always the number that was written.
TEST(SchemaNumbers, EachTenthDegreeReadsBack) {
  const Parameter& direction = *find_parameter("wind.direction_deg");
  for (int tenths = -3600; tenths <= 3600; ++tenths) {
    const double written = tenths / 10.0;
    const double stored = written * radians_per_degree;
    EXPECT_EQ(numbers_text(direction, std::vector{stored}), fmt::format("{:.12g}", written));
  }
}

// Fails if a number that no text of degrees gives exactly is not saved to the nearest one.
TEST(SchemaNumbers, NumbersThatNobodyWroteAreKept) {
  const Parameter& direction = *find_parameter("wind.direction_deg");
  for (const double stored : {1.0, std::numbers::pi / 3.0, 0.1, 2.0 / 3.0, 1e-9}) {
    const double read = std::stod(numbers_text(direction, std::vector{stored})) * radians_per_degree;
    EXPECT_NEAR(read / stored, 1.0, 3e-16);
  }
}

}  // namespace
}  // namespace offing::scene
