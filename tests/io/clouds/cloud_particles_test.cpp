// Particles as PLY files: what is written is read again, and what is wrong is refused.

#include "host/io/clouds/cloud_particles.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using ::testing::HasSubstr;

/// 500 particles within 4 km, relative to a multiple of 1024 m near their middle.
ParticleCloud example_particles() {
  ParticleCloud cloud{.origin_m = {1024.0 * 300, 2048.0, -1024.0 * 7}, .particles = {}};
  std::mt19937 random(11);
  const auto within = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() % 65536) / 65536.0f;
  };
  for (unsigned int i = 0; i < 500; ++i) {
    cloud.particles.push_back({.x = within(-500.0f, 500.0f),
                               .y = within(-100.0f, 100.0f),
                               .z = within(-500.0f, 500.0f),
                               .radius = within(10.0f, 90.0f),
                               .optical_mass = within(0.0f, 9000.0f),
                               .red = within(0.0f, 1.0f),
                               .green = within(0.0f, 1.0f),
                               .blue = within(0.0f, 1.0f),
                               .texture = i % 32,
                               .cloud = i % 5,
                               .id = 4'000'000'000u + i,
                               .turn = within(0.0f, 6.0f)});
  }
  return cloud;
}

class CloudParticleFiles : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& bytes) const {
    std::filesystem::path path = folder_.path() / "a.ply";
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

  std::optional<Error> error_of(const std::string& bytes) const {
    try {
      read_cloud_particles(write(bytes));
      return std::nullopt;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
      EXPECT_THAT(error.what(), HasSubstr("a.ply"));
      EXPECT_FALSE(error.hint().empty()) << error.what();
      return error;
    }
  }

  TemporaryFolder folder_;
};

std::string text_with(const std::string& values) {
  return "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n"
         "property float radius\nproperty float optical_mass\nproperty uchar texture\nend_header\n"
         "1 2 3 40 5 31\n" +
         values;
}

// Fails if any value of any particle is lost or rounded.
TEST_F(CloudParticleFiles, GivesTheSameParticlesAgain) {
  const ParticleCloud cloud = example_particles();
  write_cloud_particles(folder_.path() / "a.ply", cloud);
  const ParticleCloud back = read_cloud_particles(folder_.path() / "a.ply");
  EXPECT_EQ(back.origin_m, cloud.origin_m);
  ASSERT_EQ(back.particles.size(), cloud.particles.size());
  EXPECT_EQ(std::memcmp(back.particles.data(), cloud.particles.data(),
                        cloud.particles.size() * sizeof(CloudParticle)),
            0);
}

TEST_F(CloudParticleFiles, FillsInWhatAFileNeedNotHave) {
  const ParticleCloud cloud = read_cloud_particles(write(text_with("1500 2 3 50 6 0\n")));
  ASSERT_EQ(cloud.particles.size(), 2u);
  EXPECT_EQ(cloud.origin_m, glm::dvec3(1024.0, 0.0, 0.0));
  EXPECT_EQ(cloud.particles[0].x, -1023.0f);
  EXPECT_EQ(cloud.particles[0].texture, 31u);
  EXPECT_EQ(cloud.particles[1].id, 1u);
  EXPECT_EQ(cloud.particles[1].red, 1.0f);
}

TEST_F(CloudParticleFiles, RefusesWhatIsNoParticle) {
  EXPECT_THAT(error_of(text_with("1 2 3 -40 5 0\n"))->what(), HasSubstr("expected radius above 0, got -40"));
  EXPECT_THAT(error_of(text_with("1 2 3 0 5 0\n"))->what(), HasSubstr("radius above 0"));
  EXPECT_THAT(error_of(text_with("1 2 3 4 -5 0\n"))->what(), HasSubstr("optical_mass from 0 on"));
  EXPECT_THAT(error_of(text_with("1 2 3 4 5 32\n"))->what(), HasSubstr("texture below 32"));
  EXPECT_TRUE(error_of(text_with("1 2 nan 4 5 0\n")));
  EXPECT_TRUE(error_of(text_with("1 2 3 1e300 5 0\n")));
  EXPECT_TRUE(error_of(text_with("1 2 3\n")));
  EXPECT_TRUE(error_of(text_with("")));
  EXPECT_TRUE(error_of(""));
  EXPECT_TRUE(error_of("solid"));
  EXPECT_THAT(error_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n")->what(),
              HasSubstr("property y"));
  EXPECT_TRUE(error_of("ply\nformat ascii 1.0\nend_header\n"));
  EXPECT_TRUE(
      error_of("ply\nformat binary_little_endian 1.0\nelement vertex 99999999999\nproperty float x\n"
               "property float y\nproperty float z\nproperty float radius\nproperty float optical_mass\n"
               "end_header\n"));
}

// Fails if a file that ends early is taken for a whole one.
TEST_F(CloudParticleFiles, RefusesTruncatedFiles) {
  ParticleCloud cloud = example_particles();
  cloud.particles.resize(5);
  write_cloud_particles(folder_.path() / "whole.ply", cloud);
  std::ifstream file(folder_.path() / "whole.ply", std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  for (std::size_t size = 0; size < whole.size(); size += 5) {
    EXPECT_TRUE(error_of(whole.substr(0, size))) << "cut at " << size;
  }
}

}  // namespace
}  // namespace offing
