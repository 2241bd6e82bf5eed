#include "host/cli/ocean/query_text.h"

#include <array>
#include <cfloat>
#include <cstddef>
#include <new>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace offing::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

// Fails if a float is printed with digits that it does not have, or with too few to give it again.
TEST(QueryText, FloatsHaveTheirOwnDigits) {
  EXPECT_EQ(nlohmann::json(shortest_decimals(0.1f)).dump(), "0.1");
  EXPECT_EQ(nlohmann::json(shortest_decimals(-30183.55f)).dump(), "-30183.55");
  EXPECT_EQ(nlohmann::json(shortest_decimals(-0.0f)).dump(), "0.0");
  for (const float value : {1.0f / 3.0f, 16777217.0f, FLT_MIN, FLT_MAX, -1e-12f}) {
    EXPECT_EQ(static_cast<float>(shortest_decimals(value)), value);
  }
}

// Fails if an answer starts with what lay in memory before it.
TEST(QueryText, AnswersStartAsZero) {
  alignas(QueryAnswer) std::array<std::byte, sizeof(QueryAnswer)> memory;
  memory.fill(std::byte{0xbe});
  const QueryAnswer* const answer = new (memory.data()) QueryAnswer;
  EXPECT_EQ(answer->sample.residual_m, 0.0f);
  EXPECT_EQ(answer->sample.velocity_z_mps, 0.0f);
}

// Fails if what is 0 as far as it is printed has a sign.
TEST(QueryText, ZeroHasNoSign) {
  QueryAnswer answer;
  answer.sample.pressure_pa = -0.04f;
  answer.sample.height_m = -4e-5f;
  answer.sample.velocity_x_mps = -0.0f;
  const std::string words = query_text(answer, 0.0);
  EXPECT_THAT(words, HasSubstr("pressure  0.0 Pa"));
  EXPECT_THAT(words, Not(HasSubstr("-0.0")));
  std::string csv;
  append_csv(answer, csv);
  EXPECT_THAT(csv, Not(HasSubstr(",-0,")));
  EXPECT_THAT(to_json(answer).dump(), Not(HasSubstr("-0.0,")));
  answer.sample.pressure_pa = -0.06f;
  EXPECT_THAT(query_text(answer, 0.0), HasSubstr("pressure  -0.1 Pa"));
}

}  // namespace
}  // namespace offing::cli
