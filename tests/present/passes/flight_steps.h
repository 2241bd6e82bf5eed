#pragma once

#include <functional>
#include <vector>

namespace offing::test {

/// Mean light of blocks of 8 x 8 pixels of a picture, in that of white, row-major. Pixels that are brighter
/// than white count as white, as the glitter of a sea, a hundred times as bright, does on a screen. What does
/// not fill a block is left out.
using Blocks = std::vector<double>;

struct ImageShape {
  int width = 0, height = 0;
};

/// Of pixels [height][width] RGBA, kcd/m2, with an exposure, 1 / (kcd/m2).
Blocks blocks_of(const std::vector<float>& pixels, ImageShape shape, double exposure);

/// What of a flight's changes from frame to frame its motion does not explain, in white.
struct FlightSteps {
  double worst_excess = 0.0;  ///< in a frame, beyond half of the change in two
  double worst_left = 0.0;    ///< when the time between two pictures goes to nothing
};

/// Looks for pops among the blocks that a flight shows at any time.
///
/// What motion explains goes to nothing with the time between two pictures, a pop does not: from a frame to
/// the next motion explains half of what changes in two, and nothing of a pop. Where blocks change most
/// beyond that, in 8 of the frames, the change is halved 12 times in time, each time to the half that
/// changes more: of motion alone 2^-12 of a change of white in two frames is left, 0.0003, and some times
/// that where it is quicker than in the mean.
FlightSteps flight_steps(const std::function<Blocks(double time_s)>& blocks_at, int frames,
                         double frames_per_second);

}  // namespace offing::test
