// Light on clouds of every genus, and of every scene that comes with Offing, beside photons followed in
// double precision.
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/clouds/light/particle_light.h"
#include "host/clouds/light/phase_function.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/reference/photon_tracer.h"
#include "host/clouds/shape/genera.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_clouds.h"
#include "tests/clouds/example_clouds.h"

namespace offing::clouds {
namespace {

// Directions toward eyes: the corners of an icosahedron. Light is averaged over cones around them.
constexpr int eye_count = 12;
constexpr double cone_rad = 0.3;

std::vector<glm::dvec3> toward_eyes() {
  std::vector<glm::dvec3> eyes;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      glm::dvec3 eye(0.0);
      eye[axis] = corner % 2 == 0 ? -1.0 : 1.0;
      eye[(axis + 1) % 3] = corner < 2 ? -std::numbers::phi : std::numbers::phi;
      eyes.push_back(glm::normalize(eye));
    }
  }
  return eyes;
}

CloudIllumination afternoon() {
  CloudIllumination light;
  light.suns.push_back({glm::normalize(glm::dvec3(0.5, 0.6, 0.6)), glm::dvec3(100.0)});
  light.sky_kcdpm2 = glm::dvec3(4.0);
  light.ground_kcdpm2 = glm::dvec3(2.0);
  return light;
}

/// The particles of a cloud, and a sphere around them.
struct ShippedCloud {
  CloudParameters parameters;
  std::vector<CloudParticle> particles;
  glm::dvec3 middle_m{0.0};
  double radius_m = 0.0, mean_particle_m = 0.0;
  ParticleAlbedo albedo = ParticleAlbedo::of_look;

  ShippedCloud(const ocl::Device& device, CloudParameters shipped, std::optional<glm::vec3> painted)
      : parameters(std::move(shipped)) {
    particles = particles_at_rest(device, parameters);
    if (painted) paint_half(*painted);
    glm::dvec3 low(1e9), high(-1e9);
    for (const CloudParticle& particle : particles) {
      low = glm::min(low, place_of(particle) - double{particle.radius});
      high = glm::max(high, place_of(particle) + double{particle.radius});
      mean_particle_m += particle.radius / static_cast<double>(particles.size());
    }
    middle_m = 0.5 * (low + high);
    for (const CloudParticle& particle : particles)
      radius_m = std::max(radius_m, glm::length(place_of(particle) - middle_m) + particle.radius);
  }

  static glm::dvec3 place_of(const CloudParticle& particle) { return {particle.x, particle.y, particle.z}; }

 private:
  /// Gives the half toward +x, which the sun lights, another albedo.
  void paint_half(const glm::vec3& painted) {
    albedo = ParticleAlbedo::own;
    double middle_x = 0.0;
    for (const CloudParticle& particle : particles)
      middle_x += particle.x / static_cast<double>(particles.size());
    for (CloudParticle& particle : particles)
      if (particle.x > middle_x)
        particle.red = painted.x, particle.green = painted.y, particle.blue = painted.z;
  }
};

/// Intensities of the billboards toward the eyes, kcd: means over the cones by Radon's rule of seven points,
/// which is exact for polynomials of the fifth degree over a disc.
std::vector<glm::dvec3> shown(const ocl::Device& device, const ShippedCloud& cloud) {
  const ocl::Buffer<CloudParticle> particles(device, cloud.particles, "particles");
  ocl::Buffer<CloudSprite> sprites(device, cloud.particles.size(), "sprites");
  ParticleLight light(device);
  light.relight(particles, static_cast<std::uint32_t>(cloud.particles.size()), afternoon(),
                std::span(&cloud.parameters.look, 1), LightModel::calibrated, cloud.albedo);
  std::vector<glm::dvec3> intensities;
  for (const glm::dvec3& eye : toward_eyes()) {
    const glm::dvec3 aside = glm::normalize(glm::cross(eye, glm::dvec3(0.1, 0.3, 0.9))),
                     up = glm::cross(eye, aside);
    glm::dvec3 sum_kcd(0.0);
    for (int point = 0; point < 7; ++point) {
      const double from_middle_rad = point == 0 ? 0.0 : std::sqrt(2.0 / 3.0) * cone_rad,
                   around_rad = point * std::numbers::pi / 3.0;
      const glm::dvec3 toward =
          std::cos(from_middle_rad) * eye +
          std::sin(from_middle_rad) * (std::cos(around_rad) * aside + std::sin(around_rad) * up);
      light.see(glm::vec3(cloud.middle_m + 1e6 * toward), sprites);
      sum_kcd += (point == 0 ? 0.25 : 0.125) *
                 test::view_of(cloud.particles, sprites.read(), cloud.middle_m, cloud.radius_m, toward, 96)
                     .intensity_kcd;
    }
    intensities.push_back(sum_kcd);
  }
  return intensities;
}

/// Spearman's rank correlation, of ranks that count only against values which the reference has more than
/// 10 % away: twice a rank less its mean is the sum of the signs of all differences, of which those of near
/// pairs are left out on both sides. 1 where all are near.
double rank_correlation(const std::vector<double>& found, const std::vector<double>& reference) {
  const std::size_t count = found.size();
  double product = 0.0, found_squares = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double found_rank = 0.0, rank = 0.0;
    for (std::size_t j = 0; j < count; ++j) {
      if (std::abs(reference[i] - reference[j]) < 0.1 * std::max(reference[i], reference[j])) continue;
      found_rank += found[i] > found[j] ? 1.0 : -1.0;
      rank += reference[i] > reference[j] ? 1.0 : -1.0;
    }
    product += found_rank * rank;
    found_squares += found_rank * found_rank;
    squares += rank * rank;
  }
  return squares > 0.0 ? product / std::sqrt(found_squares * squares) : 1.0;
}

// Fails if near pairs count, or take their order from the reference: 1 and 1.05 are near, and the wrong order
// of the others is all that there is.
TEST(RankCorrelationTest, LeavesNearPairsOut) {
  EXPECT_NEAR(rank_correlation({1.0, 2.0, 3.0, 4.0}, {1.0, 2.0, 4.0, 3.0}), 0.8, 1e-12);
  EXPECT_EQ(rank_correlation({2.0, 1.0, 3.0}, {1.0, 1.05, 3.0}), 1.0);
  EXPECT_EQ(rank_correlation({1.0, 2.0, 0.5}, {1.0, 1.05, 3.0}), -1.0);
}

void make_green(CloudLook& look) {
  look.albedo = glm::dvec3(0.3, 1.0, 0.3);
}

void scatter_one_way(CloudLook& look, double g) {
  look.phase = PhaseKind::henyey_greenstein;
  look.g = g;
}

struct Kind {
  std::string name;
  int photons;                            ///< of each light
  std::string scene = {};                 ///< that has the cloud; of the preset with that name otherwise
  std::size_t index = 0;                  ///< in the scene, layers last
  void (*change)(CloudLook&) = nullptr;   ///< makes a cumulus another one
  std::optional<glm::vec3> painted = {};  ///< of half its particles
  double standard_error = 0.01;           ///< greatest of the reference
  double gate = 0.14;

  CloudParameters cloud() const {
    if (change != nullptr || painted) {
      CloudParameters cumulus = preset(Genus::cumulus, 1);
      if (change != nullptr) change(cumulus.look);
      return cumulus;
    }
    if (scene.empty()) return preset(genus_named(name), 1);
    const auto sky = scene::prepare_clouds(scene::load_scene(OFFING_SCENES "/" + scene + ".toml"));
    return sky.value().clouds.at(index);
  }
};

/// Of a coloured look each colour by itself, as a grey one of that albedo: where most light is swallowed,
/// paths are short and many are needed.
std::vector<TracedIntensity> traced_by_colour(const VolumeMedium& medium, const CloudLook& look,
                                              int photons) {
  constexpr int more_where_dark = 10;
  std::vector<TracedIntensity> traced(eye_count);
  std::map<double, std::vector<TracedIntensity>> of_albedo;
  for (int colour = 0; colour < 3; ++colour) {
    const double albedo = look.albedo[colour];
    const auto [grey, is_new] = of_albedo.try_emplace(albedo);
    if (is_new) {
      CloudLook grey_look = look;
      grey_look.albedo = glm::dvec3(albedo);
      grey->second =
          traced_intensities(medium, grey_look, afternoon(), toward_eyes(), cone_rad,
                             {.samples = albedo < 0.5 ? more_where_dark * photons : photons, .seed = 7});
    }
    for (std::size_t eye = 0; eye < eye_count; ++eye) {
      traced[eye].kcd[colour] = grey->second[eye].kcd[colour];
      traced[eye].relative_error[colour] = grey->second[eye].relative_error[colour];
    }
  }
  return traced;
}

class LightAccuracyTest : public testing::TestWithParam<Kind> {};

// Fails if a cloud is too bright or too dark from somewhere, or from the wrong side: the light that
// its billboards send toward twelve eyes, within 14 % of the reference (measured 13.1 % at worst), whose
// standard error is 1 % at most; and in the right order. Each colour by itself. Beside what is shipped, a
// green cumulus, of which the reference has a standard error of 2 %; one with a border between white and dark
// in its middle; and, whose light the grid's cells blur, cumuli of what is not scattered forward, where the
// sun does not shine (22.1 % and 25.9 %, gates 24 % and 28 %).
TEST_P(LightAccuracyTest, BillboardsShowWhatPhotonsDo) {
  const int photons = GetParam().photons;
  const ocl::Device device = ocl::Device::open();
  const ShippedCloud cloud(device, GetParam().cloud(), GetParam().painted);
  const std::vector<glm::dvec3> found = shown(device, cloud);
  // Half as many more cells a radius change what photons find by less than 1 %.
  CloudVolume volume =
      test::volume_of(cloud.particles, std::max(cloud.mean_particle_m / 3.5, cloud.radius_m / 150.0));
  if (cloud.albedo == ParticleAlbedo::own) volume.albedo = test::albedo_of(cloud.particles, volume);
  const VolumeMedium medium(volume);
  const std::vector<TracedIntensity> traced = traced_by_colour(medium, cloud.parameters.look, photons);
  double worst = 0.0, least_correlation = 1.0;
  for (int colour = 0; colour < 3; ++colour) {
    std::vector<double> of_colour, reference;
    for (std::size_t eye = 0; eye < eye_count; ++eye) {
      of_colour.push_back(found[eye][colour]);
      reference.push_back(traced[eye].kcd[colour]);
      const double ratio = of_colour.back() / reference.back();
      EXPECT_LE(traced[eye].relative_error[colour], GetParam().standard_error)
          << "toward eye " << eye << ", colour " << colour;
      EXPECT_NEAR(ratio, 1.0, GetParam().gate) << "toward eye " << eye << ", colour " << colour;
      worst = std::max(worst, std::abs(ratio - 1.0));
    }
    least_correlation = std::min(least_correlation, rank_correlation(of_colour, reference));
  }
  RecordProperty("worst", fmt::format("{:.3f}", worst));
  RecordProperty("rank_correlation", fmt::format("{:.3f}", least_correlation));
  EXPECT_GE(least_correlation, 0.9);
}

const std::vector<Kind> kinds{
    {"cumulus", 4'300'000},
    {"stratus", 1'600'000},
    {"cirrus", 600'000},
    {"stratocumulus", 1'300'000},
    {"altocumulus", 650'000},
    {"lenticular", 1'600'000},
    {"funnel", 1'900'000},
    {"cumulonimbus", 4'200'000},
    {"snowman", 3'900'000, "shapes", 0},
    {"person", 3'800'000, "shapes", 1},
    {"letter", 4'400'000, "shapes", 2},
    {"bird", 4'200'000, "shapes", 3},
    {"stratus_first", 1'600'000, "stratus", 0},
    {"cirrus_first", 600'000, "cirrus", 0},
    {"cirrus_second", 600'000, "cirrus", 1},
    {"cirrus_third", 600'000, "cirrus", 2},
    {"cirrus_fourth", 600'000, "cirrus", 3},
    {"cirrus_fifth", 600'000, "cirrus", 4},
    {"dusk_cumulus_second", 4'400'000, "dusk", 1},
    {"dusk_cumulus_third", 4'100'000, "dusk", 2},
    {"dusk_altocumulus", 650'000, "dusk", 3},
    {"sky_lenticular", 1'600'000, "sky", 0},
    {"sky_cumulonimbus", 4'200'000, "sky", 1},
    {"sky_cumulus", 3'200'000, "sky", 2},
    {.name = "green_cumulus", .photons = 1'200'000, .change = make_green, .standard_error = 0.02},
    {.name = "half_painted_cumulus",
     .photons = 2'400'000,
     .painted = glm::vec3(0.9999f, 0.9f, 0.4f),
     .standard_error = 0.03},
    {.name = "isotropic_cumulus",
     .photons = 1'000'000,
     .change = [](CloudLook& look) { scatter_one_way(look, 0.0); },
     .standard_error = 0.022,
     .gate = 0.24},
    {.name = "backward_cumulus",
     .photons = 1'000'000,
     .change = [](CloudLook& look) { scatter_one_way(look, least_mean_cosine); },
     .standard_error = 0.022,
     .gate = 0.28},
};

INSTANTIATE_TEST_SUITE_P(Shipped, LightAccuracyTest, testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace offing::clouds
