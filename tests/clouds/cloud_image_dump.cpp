// cloud_image_dump FILE: a small picture of particles, on the device that the environment names. FILE: red,
// green, blue, opacity and mean distance (km) of each pixel.
#include <algorithm>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <vector>

#include "host/clouds/image/cloud_image.h"
#include "kernels/shared/random.h"
#include "tests/ocl/dump_program.h"

namespace {

using namespace offing;
using namespace offing::clouds;

void write_dump(const char* path) {
  const ocl::Device device = ocl::Device::open();
  CloudImage picture(device, billboard_textures());
  // No multiples of a tile.
  constexpr int width = 37, height = 21;
  constexpr std::uint32_t count = 20;
  std::vector<CloudParticle> particles;
  std::vector<CloudSprite> sprites;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const auto random = [&](std::uint32_t index, std::size_t word) {
      return uniform_open01(philox_block(3, 0, OFFING_STREAM_SHAPES, i, 0, index).v[word]);
    };
    // The nearest ones around the eye, the farthest first.
    const float ahead_m = 400.0f - 20.5f * static_cast<float>(i);
    particles.push_back({.x = ahead_m * (random(0, 0) - 0.5f),
                         .y = 0.6f * ahead_m * (random(0, 1) - 0.5f),
                         .z = -ahead_m,
                         .radius = 20.0f + 30.0f * random(0, 2),
                         .optical_mass = 1.0f,
                         .red = 1.0f,
                         .green = 1.0f,
                         .blue = 1.0f,
                         .texture = static_cast<unsigned>(32.0f * random(0, 3)),
                         .cloud = 0,
                         .id = static_cast<unsigned>(i),
                         .turn = 6.0f * random(1, 0)});
    sprites.push_back(
        {.red = random(1, 1), .green = 0.5f, .blue = random(1, 2), .optical_depth = 3.0f * random(1, 3)});
  }
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  const ocl::Buffer<CloudParticle> device_particles(device, particles, "particles");
  const ocl::Buffer<CloudSprite> device_sprites(device, sprites, "sprites");
  const ocl::Buffer<std::uint32_t> device_order(device, order, "order");
  picture.fit(width, height);
  std::vector<float> depth(width * height, 0.0f);
  std::fill(depth.begin(), depth.begin() + width * height / 3, 0.05f / 200.0f);
  picture.scene_depth().write(depth);
  picture.draw(
      {.particles = device_particles, .sprites = device_sprites, .order = device_order, .count = count},
      {.eye_m = {0.0, 0.0, 0.0}, .vertical_field_of_view_rad = 0.7, .width_px = width, .height_px = height});
  const auto image = picture.image().read();
  const std::vector<float> distance_m = picture.distance_m().read();
  std::ofstream file(path, std::ios::binary);
  for (std::size_t i = 0; i < image.size(); ++i) {
    const float distance_km = 1e-3f * distance_m[i];
    file.write(reinterpret_cast<const char*>(image[i].data()), sizeof(image[i]));
    file.write(reinterpret_cast<const char*>(&distance_km), sizeof(distance_km));
  }
}

}  // namespace

int main(int argc, char** argv) {
  return offing::test::run_dump_program(argc, argv, write_dump);
}
