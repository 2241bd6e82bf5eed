#pragma once

#include <array>
#include <cstddef>

namespace offing::terrain {

/// A mark of the heat map of steps (T11): rays of so many steps have this colour, linear Rec.709; those
/// between two marks a mixture.
struct StepColour {
  float steps;
  std::array<float, 3> rgb;
};

/// Blue at none, green at 16, yellow at 40, red at 80 and more.
inline constexpr std::array<StepColour, 4> step_colours{{{0.0f, {0.01f, 0.02f, 0.25f}},
                                                         {16.0f, {0.02f, 0.5f, 0.1f}},
                                                         {40.0f, {0.9f, 0.7f, 0.02f}},
                                                         {80.0f, {0.7f, 0.01f, 0.01f}}}};

/// The colour of so many steps.
inline std::array<float, 3> step_colour(float steps) {
  std::size_t i = 1;
  while (i + 1 < step_colours.size() && steps > step_colours[i].steps) ++i;
  const StepColour &low = step_colours[i - 1], &high = step_colours[i];
  const float share = steps >= high.steps ? 1.0f : (steps - low.steps) / (high.steps - low.steps);
  std::array<float, 3> mixed{};
  for (std::size_t c = 0; c < 3; ++c) mixed[c] = low.rgb[c] + share * (high.rgb[c] - low.rgb[c]);
  return mixed;
}

}  // namespace offing::terrain
