#include "host/clouds/light/scattered_sky.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"
#include "host/clouds/particles/random_draws.h"
#include "host/clouds/shape/genera.h"

namespace offing::clouds {
namespace {

constexpr int squares = 512;  // along a side, in which cover is counted

void require_valid(const SkyCover& cover) {
  require_within("cloud_layer.coverage", cover.coverage, 0.0, 0.95);
  require_within("cloud_layer.extent_m", cover.extent_m, 100.0, 1e6);
  require_within("cloud_layer.middle_m.x", cover.middle_m.x, -farthest_point_m, farthest_point_m);
  require_within("cloud_layer.middle_m.z", cover.middle_m.y, -farthest_point_m, farthest_point_m);
  if (cover.base_m) require_within("cloud_layer.base_m", *cover.base_m, -1000.0, 50'000.0);
  require_within("cloud_layer.base_spread_m", cover.base_spread_m, 0.0, 10'000.0);
  require_within("cloud_layer.size_spread", cover.size_spread, 0.0, 0.9);
  require_within("cloud_layer.most_clouds", cover.most_clouds, 1, 100'000);
}

/// Which squares of the ground lie below a cloud.
class CoveredGround {
 public:
  explicit CoveredGround(const SkyCover& cover)
      : low_m_(cover.middle_m - 0.5 * cover.extent_m), square_m_(cover.extent_m / squares) {}

  void add(const CloudParameters& cloud) {
    for (const Metaball& ball : cloud.balls) {
      // Where h is above a tenth: the rim is too thin to be seen.
      const double radius = 0.8 * ball.radius_m / square_m_;
      const double x = (cloud.position_m.x + ball.centre_m.x - low_m_.x) / square_m_;
      const double z = (cloud.position_m.z + ball.centre_m.z - low_m_.y) / square_m_;
      for (int row = first(z - radius); row < past(z + radius); ++row) {
        const double across = row + 0.5 - z,
                     half = std::sqrt(std::max(0.0, radius * radius - across * across));
        for (int column = first(x - half); column < past(x + half); ++column) {
          std::uint8_t& square = covered_[static_cast<std::size_t>(row * squares + column)];
          count_ += square == 0 ? 1 : 0;
          square = 1;
        }
      }
    }
  }

  double share() const { return static_cast<double>(count_) / (squares * squares); }

 private:
  static int first(double place) {
    return static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, 1.0 * squares));
  }
  static int past(double place) { return first(place); }

  glm::dvec2 low_m_;
  double square_m_;
  std::vector<std::uint8_t> covered_ = std::vector<std::uint8_t>(squares * squares, 0);
  int count_ = 0;
};

}  // namespace

std::vector<CloudParameters> scattered_sky(const SkyCover& cover, std::uint64_t seed) {
  require_valid(cover);
  std::vector<CloudParameters> clouds;
  CoveredGround ground(cover);
  const GenusRange range = range_of(cover.genus);
  const double base_m = cover.base_m.value_or(0.5 * (range.lowest_base_m + range.highest_base_m));
  for (int number = 0; ground.share() < cover.coverage; ++number) {
    if (number >= cover.most_clouds) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("cloud layer: {} {} cover {:.3f} of the ground, expected {:.3f}", number,
                              range.name, ground.share(), cover.coverage),
                  "take a smaller extent or coverage, or allow more clouds");
    }
    RandomDraws draws(seed, OFFING_STREAM_CLOUD_SKY, number, static_cast<int>(cover.genus));
    const double size = 1.0 + cover.size_spread * draws.between(-1.0, 1.0);
    const double x = draws.between(-0.5, 0.5), z = draws.between(-0.5, 0.5);
    const double turn = 2.0 * std::numbers::pi * draws.next(),
                 up_m = cover.base_spread_m * draws.between(-1.0, 1.0);
    CloudParameters cloud =
        preset(cover.genus, seed + 0x9e3779b97f4a7c15u * static_cast<std::uint64_t>(number + 1), size);
    cloud.position_m = {cover.middle_m.x + x * cover.extent_m, base_m + up_m,
                        cover.middle_m.y + z * cover.extent_m};
    cloud.motion.wind_mps = cover.wind_mps;
    // Streaks lie along the wind; the others have no direction.
    if (cover.genus != Genus::cirrus) {
      for (Metaball& ball : cloud.balls) {
        const glm::dvec3 place_m = ball.centre_m;
        ball.centre_m.x = std::cos(turn) * place_m.x - std::sin(turn) * place_m.z;
        ball.centre_m.z = std::sin(turn) * place_m.x + std::cos(turn) * place_m.z;
      }
    }
    ground.add(cloud);
    clouds.push_back(cloud);
  }
  return clouds;
}

}  // namespace offing::clouds
