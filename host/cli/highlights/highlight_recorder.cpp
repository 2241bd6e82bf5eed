#include "host/cli/highlights/highlight_recorder.h"

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/highlights/projectors/texture_shapes.h"
#include "host/scene/file/version.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/world_scene.h"
#include "host/world/world.h"

namespace offing::cli {
namespace {

using highlights::DrawnHighlight;
using highlights::HighlightTexture;

constexpr int image_px = 128;
// Pictures of shapes are made in steps of softness that no eye tells apart.
constexpr double softness_steps = 32.0;

/// A shape as a white picture with its opacity.
RgbaImage image_of(HighlightTexture shape, double softness) {
  RgbaImage image{image_px, image_px, {}};
  const double pixel = 2.0 / image_px;
  for (int row = 0; row < image_px; ++row) {
    for (int column = 0; column < image_px; ++column) {
      const glm::dvec2 q((column + 0.5) * pixel - 1.0, 1.0 - (row + 0.5) * pixel);
      const double opacity = highlights::shape_opacity(shape, q, softness, pixel);
      image.rgba.insert(image.rgba.end(),
                        {255, 255, 255, static_cast<std::uint8_t>(std::lround(255.0 * opacity))});
    }
  }
  return image;
}

/// The textures of an animation, each once.
class Textures {
 public:
  explicit Textures(std::vector<animations::AnimatedTexture>& all) : all_(all) {}

  /// `file` is that of a picture.
  std::size_t index_of(const highlights::HighlightControls& controls, const std::string& file) {
    const bool has_file = is_image(controls.texture);
    const double softness = has_file ? 0.0 : std::round(controls.softness * softness_steps) / softness_steps;
    const auto [place, is_new] = known_.try_emplace(
        std::tuple(controls.texture, softness, has_file ? file : std::string()), all_.size());
    if (is_new) {
      all_.push_back({.name = std::string(highlights::name_of(controls.texture)),
                      .file = has_file ? file : std::string(),
                      .image = has_file ? RgbaImage{} : image_of(controls.texture, softness)});
    }
    return place->second;
  }

 private:
  std::vector<animations::AnimatedTexture>& all_;
  std::map<std::tuple<HighlightTexture, double, std::string>, std::size_t> known_;
};

animations::ProjectorSample sample_of(const DrawnHighlight& drawn, std::size_t texture) {
  const highlights::Projector& box = drawn.projector;
  return {.id = drawn.id,
          .rule = drawn.rule,
          .copy = drawn.copy,
          .light = drawn.id >= highlights::first_pin_id ? -1 : drawn.light,
          .position_m = box.centre_m,
          .right = box.right,
          .up = box.up,
          .normal = box.normal,
          .width_m = box.width_m,
          .height_m = box.height_m,
          .opacity = drawn.opacity,
          .texture = texture,
          .softness = drawn.controls.softness,
          .colour = drawn.controls.colour};
}

animations::MeshFrame frame_of(const world::WorldMesh& view, const scene::MeshScene& mesh,
                               Textures& textures) {
  animations::MeshFrame frame{view.motion().rotation, view.motion().translation_m, {}};
  for (const DrawnHighlight& drawn : view.highlights()) {
    if (!(drawn.opacity > 0.0)) continue;
    const std::string file =
        drawn.rule < 0 ? std::string() : mesh.highlights[static_cast<std::size_t>(drawn.rule)].picture;
    frame.projectors.push_back(sample_of(drawn, textures.index_of(drawn.controls, file)));
  }
  return frame;
}

/// Without what neither moves meshes nor lights them.
world::WorldParameters with_what_moves_meshes(world::WorldParameters parameters) {
  parameters.clouds.reset();
  parameters.wakes.clear();
  parameters.has_sea = !parameters.bodies.empty();
  return parameters;
}

void require_highlights(const scene::Scene& scene) {
  for (const scene::MeshScene& mesh : scene.meshes) {
    if (mesh.shown == scene::MeshHighlights::on) return;
  }
  throw Error(ErrorKind::bad_input,
              "highlights: expected a scene with a [[mesh]] that has highlights, found none",
              "add a [[mesh]] to the scene, such as that of scenes/knot.toml");
}

}  // namespace

animations::HighlightAnimation record_highlights(const ocl::Device& device, scene::Scene scene,
                                                 const FrameRange& frames, Progress& progress,
                                                 const CancelToken& cancel) {
  require_highlights(scene);
  // As offing-view shows it: the eye at its place, and bodies where they float.
  world::World world(device, with_what_moves_meshes(scene::prepare_shown_world(scene)));
  world.set_sea_samples(16);  // bodies feel the whole sea still, and nobody looks at it
  animations::HighlightAnimation animation{.generator = fmt::format("Offing {}", scene::version()),
                                           .frames_per_s = scene.frames_per_second,
                                           .first_frame = frames.first,
                                           .lights = {},
                                           .textures = {},
                                           .meshes = {}};
  for (const scene::LightScene& light : scene.lights) animation.lights.push_back(light.name);
  animation.lights.emplace_back("sun");
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    animation.meshes.push_back({.name = world.meshes()[i].parameters().name,
                                .file = scene.meshes[i].file,
                                .scale = scene.meshes[i].scale,
                                .frames = {}});
  }
  const highlights::LightingAt lighting = scene::lighting_of(scene, world.terrain());
  const double first_s = frames.first / scene.frames_per_second;
  Textures textures(animation.textures);
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    cancel.throw_if_cancelled();
    const scene::ViewScene view = scene::show_at(world, scene, frame / scene.frames_per_second);
    world.see_meshes(view.camera.eye_m, lighting, first_s);
    for (std::size_t i = 0; i < scene.meshes.size(); ++i)
      animation.meshes[i].frames.push_back(frame_of(world.meshes()[i], scene.meshes[i], textures));
    progress.advance();
  }
  return animation;
}

}  // namespace offing::cli
