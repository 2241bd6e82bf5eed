#include "present/output/reference_comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/clouds/image/cloud_image.h"
#include "host/clouds/light/field_albedo.h"
#include "host/clouds/reference/reference_tracer.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/command_line/print_results.h"
#include "host/io/exr_image.h"
#include "host/io/png_image.h"
#include "host/ocl/device.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/world_scene.h"
#include "present/passes/sky/light_meter.h"

namespace offing::present {
namespace {

using clouds::LightImage;

// Of the reference's cells: as fine as a particle's shape shows, and no more than this many along the clouds.
constexpr double cells_a_radius = 3.5, most_cells = 400.0;
// Paths are traced in so many passes at most, between which there is time to stop.
constexpr int most_passes = 16;
// Error that error.png shows in full colour, in mean light of the pixels with any cloud.
constexpr double full_error = 0.5;

struct Compared {
  LightImage drawn;  ///< [height][width], row 0 at the top
  clouds::TracedImage reference;
  /// The reference by one half of its paths and by the other, which tells noise from light; the second is
  /// empty where there is one path.
  std::array<LightImage, 2> halves;
  double exposure = 1.0;
  Camera camera;                    ///< in the world
  clouds::CloudIllumination light;  ///< that paths find
  double cell_m = 1.0;              ///< of the density that they cross
};

double luminance(const glm::dvec3& light) {
  return glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722));  // Rec.709
}

/// What all clouds scatter with. Extinctions are those of their particles.
clouds::CloudLook look_of(const world::CloudSkyParameters& sky) {
  clouds::CloudLook first = sky.clouds.front().look;
  for (const clouds::CloudParameters& cloud : sky.clouds) {
    clouds::CloudLook look = cloud.look;
    look.extinction_per_m = first.extinction_per_m;
    look.albedo = first.albedo;  // paths take that of the particles
    look.billboards = first.billboards;
    if (look == first) continue;
    throw Error(ErrorKind::bad_input,
                "--compare-reference: expected clouds of one phase function, found several",
                "use a scene whose clouds all have the same phase function");
  }
  return first;
}

/// The mean of what lights the clouds, where they are at several altitudes: paths know one light.
clouds::CloudIllumination mean_illumination(std::span<const clouds::CloudIllumination> lights) {
  clouds::CloudIllumination mean;
  const double share = 1.0 / static_cast<double>(lights.size());
  for (const clouds::CloudIllumination& light : lights) {
    mean.sky_kcdpm2 += share * light.sky_kcdpm2;
    mean.ground_kcdpm2 += share * light.ground_kcdpm2;
    if (mean.suns.size() < light.suns.size()) mean.suns.resize(light.suns.size());
    for (std::size_t i = 0; i < light.suns.size(); ++i) {
      clouds::CloudLight& sun = mean.suns[i];
      if (sun.illuminance_klx == glm::dvec3(0.0)) sun.direction = light.suns[i].direction;
      sun.illuminance_klx += share * light.suns[i].illuminance_klx;
    }
  }
  return mean;
}

/// The extinction of particles and their albedos, for paths.
clouds::VolumeMedium medium_of(const ocl::Device& device, const std::vector<CloudParticle>& particles) {
  glm::dvec3 low(1e30), high(-1e30);
  double mean_radius_m = 0.0;
  for (const CloudParticle& particle : particles) {
    const glm::dvec3 place(particle.x, particle.y, particle.z);
    low = glm::min(low, place - double{particle.radius});
    high = glm::max(high, place + double{particle.radius});
    mean_radius_m += particle.radius / static_cast<double>(particles.size());
  }
  const glm::dvec3 extent_m = high - low;
  const double longest_m = std::max({extent_m.x, extent_m.y, extent_m.z});
  const double cell_m = std::max(mean_radius_m / cells_a_radius, longest_m / most_cells);
  CloudVolume volume = clouds::rasterised(device, particles, cell_m);
  volume.albedo = clouds::rasterised_albedo(device, particles, volume);
  return clouds::VolumeMedium(volume);
}

LightImage drawn_clouds(const ocl::Device& device, const scene::Scene& scene, const world::World& world,
                        const Camera& camera) {
  const world::WorldClouds& view = *world.clouds();
  const auto own = scene::own_billboards(scene);
  clouds::CloudImage picture(device, own ? *own : clouds::billboard_textures());
  picture.fit(camera.width_px, camera.height_px);
  const auto& [x, y, z] = world.parameters().sun.sun_direction;
  picture.draw({.particles = view.particles(),
                .sprites = view.sprites(),
                .order = view.order(),
                .count = view.count(),
                .origin_m = view.sky_origin_m(),
                .sun_direction = {x, y, z},
                .resolved = view.resolved()},
               camera);
  const auto image = picture.image().read();
  const auto width = static_cast<std::size_t>(camera.width_px);
  LightImage top_down;
  for (std::size_t row = image.size() / width; row-- > 0;) {
    for (std::size_t column = 0; column < width; ++column) {
      const auto& texel = image[row * width + column];
      top_down.emplace_back(texel[0], texel[1], texel[2], texel[3]);
    }
  }
  return top_down;
}

/// Adds a share of another picture.
void add(LightImage& sum, const LightImage& image, float share) {
  sum.resize(image.size());
  for (std::size_t i = 0; i < image.size(); ++i) sum[i] += share * image[i];
}

/// Fills the reference and its halves.
void trace(Compared& compared, const clouds::ReferenceTracer& tracer, const Camera& camera,
           const ViewOptions& options, const CancelToken& cancel) {
  const int samples = options.comparison->samples, passes = std::min(samples, most_passes);
  clouds::TracedImage& sum = compared.reference;
  std::array<int, 2> samples_of_half{};
  for (int pass = 0; pass < passes; ++pass)
    samples_of_half[static_cast<std::size_t>(pass % 2)] +=
        (pass + 1) * samples / passes - pass * samples / passes;
  Progress progress(passes, "passes", options.verbosity);
  for (int pass = 0; pass < passes; ++pass) {
    cancel.throw_if_cancelled();
    const int of_pass = (pass + 1) * samples / passes - pass * samples / passes;
    const clouds::TracedImage traced =
        tracer.image(camera, {.samples = of_pass, .seed = static_cast<std::uint64_t>(pass) + 1});
    const float share = static_cast<float>(of_pass) / static_cast<float>(samples);
    add(sum.image, traced.image, share);
    const auto half = static_cast<std::size_t>(pass % 2);
    add(compared.halves[half], traced.image,
        static_cast<float>(of_pass) / static_cast<float>(samples_of_half[half]));
    sum.orders.resize(traced.orders.size());
    for (std::size_t order = 0; order < traced.orders.size(); ++order)
      add(sum.orders[order], traced.orders[order], share);
    progress.advance();
  }
  cancel.throw_if_cancelled();
}

Compared compare(const ViewOptions& options, const CancelToken& cancel) {
  const ocl::Device device = ocl::Device::open(ocl::select_device(options.device));
  scene::Scene scene = options.scene;  // the ground may place its eye
  world::World world(device, scene::prepare_shown_world(scene));
  if (world.clouds() == nullptr) {
    throw Error(ErrorKind::bad_input, "--compare-reference: expected a scene with clouds, found none",
                "add [[cloud]] to the scene");
  }
  clouds::CloudLook look = look_of(world.clouds()->parameters());
  scene::ViewScene view = scene::show_at(world, scene, options.time_s);
  const ImageSize size = options.size.value_or(ImageSize{160, 90});
  view.camera.width_px = size.width;
  view.camera.height_px = size.height;
  world.see_clouds(view.camera);
  Compared compared;
  compared.exposure = LightMeter().exposure(world, view.camera, view.exposure_ev);
  compared.drawn = drawn_clouds(device, scene, world, view.camera);

  const world::WorldClouds& clouds = *world.clouds();
  std::vector<CloudParticle> particles = clouds.particles().read();
  particles.resize(clouds.count());
  // Of particles of one grey, whatever the look says; coloured ones have the medium's.
  if (!particles.empty()) look.albedo = glm::dvec3(double{particles.front().red});
  const clouds::VolumeMedium medium = medium_of(device, particles);
  compared.cell_m = medium.cell_m();
  compared.light = mean_illumination(clouds.illumination());
  compared.camera = view.camera;
  const clouds::ReferenceTracer tracer(medium, look, compared.light);
  Camera camera = view.camera;
  camera.eye_m -= clouds.sky_origin_m();
  trace(compared, tracer, camera, options, cancel);
  return compared;
}

/// Mean luminance over all pixels, kcd/m2.
double mean_light(const LightImage& image) {
  double sum = 0.0;
  for (const glm::vec4& texel : image) sum += luminance(glm::dvec3(texel));
  return sum / static_cast<double>(image.size());
}

RgbImage screen_image(const LightImage& light, ImageSize size, double exposure) {
  RgbImage image{.width = size.width, .height = size.height, .rgb = {}};
  for (const glm::vec4& texel : light)
    for (int channel = 0; channel < 3; ++channel)
      image.rgb.push_back(srgb_from_linear(static_cast<float>(exposure) * texel[channel]));
  return image;
}

/// Red where too much light is drawn, blue where too little, white where it is right.
RgbImage error_image(const Compared& compared, ImageSize size, double full_kcdpm2) {
  RgbImage image{.width = size.width, .height = size.height, .rgb = {}};
  for (std::size_t i = 0; i < compared.drawn.size(); ++i) {
    const double error = luminance(glm::dvec3(compared.drawn[i] - compared.reference.image[i]));
    const auto share = static_cast<float>(std::clamp(error / full_kcdpm2, -1.0, 1.0));
    const glm::vec3 colour = share > 0.0f ? glm::vec3(1.0f, 1.0f - share, 1.0f - share)
                                          : glm::vec3(1.0f + share, 1.0f + share, 1.0f);
    for (int channel = 0; channel < 3; ++channel) image.rgb.push_back(srgb_from_linear(colour[channel]));
  }
  return image;
}

void write_light(const std::filesystem::path& path, const Compared& compared, ImageSize size,
                 Existing existing) {
  std::vector<std::pair<std::string, const LightImage*>> layers{{"drawn", &compared.drawn},
                                                                {"reference", &compared.reference.image}};
  for (std::size_t order = 0; order < compared.reference.orders.size(); ++order)
    layers.emplace_back(fmt::format("order{}", order + 1), &compared.reference.orders[order]);
  for (std::size_t half = 0; half < compared.halves.size(); ++half)
    if (!compared.halves[half].empty())
      layers.emplace_back(fmt::format("half{}", half + 1), &compared.halves[half]);
  std::vector<std::pair<std::string, std::vector<float>>> values;
  for (const auto& [name, image] : layers) {
    for (int channel = 0; channel < 4; ++channel) {
      auto& [channel_name, plane] = values.emplace_back();
      channel_name = fmt::format("{}.{}", name, "RGBA"[channel]);
      for (const glm::vec4& texel : *image) plane.push_back(texel[channel]);
    }
  }
  std::vector<ImageChannel> channels;
  for (const auto& [name, plane] : values) channels.push_back({name, plane});
  write_exr(path,
            {.width = size.width,
             .height = size.height,
             .channels = channels,
             .attributes = {{"unit", std::string("kcd/m2")}, {"exposure", compared.exposure}}},
            PixelType::float_32, ExrCompression::zip, existing);
}

/// In how many pixels there is any cloud, by the reference, and how far they are off.
struct Errors {
  double covered_share = 0.0;
  double mean_kcdpm2 = 0.0;  ///< of the covered pixels, by the reference
  double rms_kcdpm2 = 0.0;   ///< of the covered pixels
};

Errors errors_of(const Compared& compared) {
  Errors errors;
  double covered = 0.0, squares = 0.0, light = 0.0;
  for (std::size_t i = 0; i < compared.drawn.size(); ++i) {
    if (compared.reference.image[i].a < 0.05f) continue;
    const double reference = luminance(glm::dvec3(compared.reference.image[i]));
    const double error = luminance(glm::dvec3(compared.drawn[i])) - reference;
    covered += 1.0;
    light += reference;
    squares += error * error;
  }
  errors.covered_share = covered / static_cast<double>(compared.drawn.size());
  if (covered == 0.0) return errors;
  errors.mean_kcdpm2 = light / covered;
  errors.rms_kcdpm2 = std::sqrt(squares / covered);
  return errors;
}

nlohmann::ordered_json json_of(const glm::dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

/// What another program needs for the reference's picture, beside the clouds.
void add_setting(nlohmann::ordered_json& json, const Compared& compared) {
  const CameraBasis axes = basis(compared.camera);
  json["camera"] = {{"eye_m", json_of(compared.camera.eye_m)},
                    {"forward", json_of(axes.forward)},
                    {"up", json_of(axes.up)},
                    {"vertical_field_of_view_deg", glm::degrees(compared.camera.vertical_field_of_view_rad)}};
  json["lights"] = nlohmann::ordered_json::array();
  for (const clouds::CloudLight& light : compared.light.suns) {
    json["lights"].push_back(
        {{"direction", json_of(light.direction)}, {"illuminance_klx", json_of(light.illuminance_klx)}});
  }
  json["sky_kcdpm2"] = json_of(compared.light.sky_kcdpm2);
  json["ground_kcdpm2"] = json_of(compared.light.ground_kcdpm2);
  json["cell_m"] = compared.cell_m;
}

void print(const Compared& compared, const Errors& errors, const ReferenceComparison& asked) {
  const double drawn = mean_light(compared.drawn), reference = mean_light(compared.reference.image);
  nlohmann::ordered_json json{{"samples", asked.samples},
                              {"covered_share", errors.covered_share},
                              {"drawn_kcdpm2", drawn},
                              {"reference_kcdpm2", reference},
                              {"rms_error_kcdpm2", errors.rms_kcdpm2},
                              {"orders", nlohmann::ordered_json::array()}};
  if (!asked.prints_json) {
    fmt::print(
        "drawn {:.4g} kcd/m2, reference {:.4g} kcd/m2 over the picture; {:.0f} % covered, there "
        "{:.4g} kcd/m2, root mean square error {:.4g} kcd/m2\n",
        drawn, reference, 100.0 * errors.covered_share, errors.mean_kcdpm2, errors.rms_kcdpm2);
  }
  const std::size_t count = compared.reference.orders.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double light = mean_light(compared.reference.orders[i]);
    const double share = reference > 0.0 ? light / reference : 0.0;
    json["orders"].push_back({{"order", i + 1}, {"kcdpm2", light}, {"share", share}});
    if (asked.prints_json) continue;
    fmt::print("scattered {}{} {}: {:5.1f} % of the light\n", i + 1, i + 1 == count ? " or more" : "",
               i == 0 ? "time" : "times", 100.0 * share);
  }
  add_setting(json, compared);
  if (asked.prints_json) print_json(json);
}

}  // namespace

void compare_with_reference(const ViewOptions& options, const CancelToken& cancel) {
  const ReferenceComparison& asked = *options.comparison;
  const Compared compared = [&] {
    try {
      return compare(options, cancel);
    } catch (...) {
      std::error_code ignored;
      if (asked.is_new_folder) std::filesystem::remove(asked.folder, ignored);
      throw;
    }
  }();
  const ImageSize size = options.size.value_or(ImageSize{160, 90});
  const Errors errors = errors_of(compared);
  write_png(asked.file("drawn.png"), screen_image(compared.drawn, size, compared.exposure), asked.existing);
  write_png(asked.file("reference.png"), screen_image(compared.reference.image, size, compared.exposure),
            asked.existing);
  write_png(asked.file("error.png"),
            error_image(compared, size, full_error * std::max(errors.mean_kcdpm2, 1e-9)), asked.existing);
  write_light(asked.file("compared.exr"), compared, size, asked.existing);
  print(compared, errors, asked);
}

}  // namespace offing::present
