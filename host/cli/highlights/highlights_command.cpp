// `offing highlights`: the projectors of a scene's highlights, frame by frame.
#include "host/cli/highlights/highlights_command.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/progress.h"
#include "host/base/work.h"
#include "host/cli/common/device_choice.h"
#include "host/command_line/frame_flags.h"
#include "host/command_line/general_flags.h"
#include "host/command_line/installed_scenes.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/highlights/projectors/texture_shapes.h"
#include "host/io/animations/highlight_animation.h"
#include "host/ocl/device.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_files.h"
#include "host/scene/file/version.h"
#include "host/scene/model/scene.h"
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
  animations::MeshFrame frame{
      .rotation = view.motion().rotation, .translation_m = view.motion().translation_m, .projectors = {}};
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

/// What an animation has beside highlights.
enum class Around { nothing, scene };

animations::MeshLook look_of(const world::WorldMesh& view) {
  return {std::make_shared<TriangleMesh>(view.surface().mesh()), view.parameters().material.colour};
}

/// The form of a mesh that deforms, that of the frame before if it is the same.
std::shared_ptr<const MeshForm> form_of(const world::WorldMesh& view,
                                        const std::vector<animations::MeshFrame>& before) {
  if (!view.parameters().deformation) return {};
  const TriangleMesh& mesh = view.surface().mesh();
  const auto is_same = [&](const MeshForm& form) {
    return form.positions_m == mesh.positions_m && form.normals == mesh.normals;
  };
  if (!before.empty() && is_same(*before.back().form)) return before.back().form;
  return std::make_shared<MeshForm>(MeshForm{mesh.positions_m, mesh.normals});
}

/// Throws Error(bad_input) where the forms of a world's meshes, each with its weights, would not fit into a
/// glTF, whose numbers of bytes end at 2^32. A form for each frame until the animation ends.
void require_room_for_forms(const world::World& world, const FrameRange& frames, double frames_per_s) {
  constexpr double most_bytes = 4294967296.0, weight_bytes = 4.0, vector_bytes = 12.0;
  const double frame_count = frames.last - frames.first + 1.0;
  double bytes = 0.0, bytes_per_frame = 0.0, weights_per_frame = 0.0;
  for (const world::WorldMesh& view : world.meshes()) {
    const Deformation& deformation = view.parameters().deformation;
    if (!deformation) continue;
    const TriangleMesh& mesh = view.surface().mesh();
    const double forms = std::clamp(deformation.end_s * frames_per_s - frames.first + 2.0, 1.0, frame_count);
    const double form_bytes =
        vector_bytes * static_cast<double>(mesh.positions_m.size() + mesh.normals.size());
    bytes += forms * (form_bytes + weight_bytes * frame_count);
    bytes_per_frame += form_bytes;
    weights_per_frame += weight_bytes;
  }
  if (bytes <= most_bytes) return;
  // n frames need n (bytes_per_frame + weights_per_frame n).
  const double half = 0.5 * bytes_per_frame / weights_per_frame;
  const double fit = std::floor(std::sqrt(half * half + most_bytes / weights_per_frame) - half);
  constexpr double bytes_per_gib = 1073741824.0;
  throw Error(
      ErrorKind::bad_input,
      fmt::format(
          "--with-scene: expected forms of meshes that fit into 4 GiB, got {:.1f} GiB in {:.0f} frames",
          bytes / bytes_per_gib, frame_count),
      fit < 1.0
          ? std::string("simplify the meshes that deform, or leave --with-scene out")
          : fmt::format("write them in parts: --frames {}:{:.0f}", frames.first, frames.first + fit - 1.0));
}

/// The lights of a world at rest, without frames yet. A near one is as far away as the first mesh is from it.
std::vector<animations::AnimatedLight> lights_of(const world::World& world) {
  std::vector<animations::AnimatedLight> lights;
  for (const world::Light& light : world.parameters().lights) {
    const bool is_near = light.source.kind == highlights::Source::Kind::place;
    const glm::dvec3& mesh_m = world.meshes().front().motion().translation_m;
    lights.push_back({.is_near = is_near,
                      .distance_m = is_near ? glm::distance(light.source.vector, mesh_m) : 1.0,
                      .frames = {}});
  }
  lights.emplace_back();  // the sun
  return lights;
}

/// Adds what stands around the highlights at this time.
void add_frame(animations::AnimatedScene& around, const world::World& world, const Camera& camera) {
  around.cameras.push_back(camera);
  const std::vector<world::Light>& lights = world.parameters().lights;
  for (std::size_t i = 0; i < lights.size(); ++i)
    around.lights[i].frames.push_back(
        {lights[i].source.vector, lights[i].colour * lights[i].illuminance_klx});
  const auto& [x, y, z] = world.parameters().sun.sun_direction;
  const sky::Rgb& sun_klx = world.illuminance().sun_klx;
  around.lights.back().frames.push_back(
      {{x, y, z}, y > 0.0 ? glm::dvec3(sun_klx[0], sun_klx[1], sun_klx[2]) : glm::dvec3(0.0)});
}

/// The highlights of a scene's meshes over frames, as offing-view draws them in files, with the same id as
/// long as each lasts. Throws Error(bad_input) for a scene without meshes that have highlights,
/// Error(cancelled), and what preparing its world and showing its meshes throws.
animations::HighlightAnimation record_highlights(const ocl::Device& device, scene::Scene scene,
                                                 const FrameRange& frames, Around around, Progress& progress,
                                                 const CancelToken& cancel) {
  require_highlights(scene);
  // As offing-view shows it: the eye at its place, and bodies where they float.
  world::World world(device, with_what_moves_meshes(scene::prepare_shown_world(scene)));
  world.set_sea_samples(16);  // bodies feel the whole sea still, and nobody looks at it
  if (around == Around::scene) require_room_for_forms(world, frames, scene.time.frames_per_second);
  animations::HighlightAnimation animation{.generator = fmt::format("Offing {}", scene::version()),
                                           .frames_per_s = scene.time.frames_per_second,
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
    if (around == Around::scene) animation.meshes.back().look = look_of(world.meshes()[i]);
  }
  const highlights::LightingAt lighting = scene::lighting_of(scene, world.terrain());
  const double first_s = frames.first / scene.time.frames_per_second;
  Textures textures(animation.textures);
  for (int frame = frames.first; frame <= frames.last; ++frame) {
    cancel.throw_if_cancelled();
    const scene::ViewScene view = scene::show_at(world, scene, frame / scene.time.frames_per_second);
    world.see_meshes(view.camera.eye_m, lighting, first_s);
    if (around == Around::scene) {
      if (!animation.scene) animation.scene = {.cameras = {}, .lights = lights_of(world)};
      add_frame(*animation.scene, world, view.camera);
    }
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      std::vector<animations::MeshFrame>& shown = animation.meshes[i].frames;
      animations::MeshFrame next = frame_of(world.meshes()[i], scene.meshes[i], textures);
      if (around == Around::scene) next.form = form_of(world.meshes()[i], shown);
      shown.push_back(std::move(next));
    }
    progress.advance();
  }
  return animation;
}

struct HighlightsArguments {
  std::string scene, output;
  FrameFlags frames;
  bool has_scene = false;
  bool json = false;
  Existing existing = Existing::keep;
  Trust trust = Trust::trusted;
};

/// Pictures and meshes as a file in that folder names them.
void name_from(const std::filesystem::path& folder, animations::HighlightAnimation& animation) {
  const auto rename = [&](std::string& file) {
    if (file.empty()) return;
    std::error_code failure;
    const std::filesystem::path name = std::filesystem::relative(file, folder, failure);
    if (!failure && !name.empty()) file = name.generic_string();
  };
  for (animations::AnimatedTexture& texture : animation.textures) rename(texture.file);
  for (animations::AnimatedMesh& mesh : animation.meshes) rename(mesh.file);
}

struct Counts {
  std::size_t highlights = 0;  ///< different ones, of all meshes
  std::size_t most = 0;        ///< projectors of one frame
};

Counts counts_of(const animations::HighlightAnimation& animation) {
  Counts counts;
  std::set<std::tuple<std::size_t, std::uint64_t>> names;
  std::vector<std::size_t> per_frame;
  for (std::size_t mesh = 0; mesh < animation.meshes.size(); ++mesh) {
    const std::vector<animations::MeshFrame>& frames = animation.meshes[mesh].frames;
    per_frame.resize(frames.size(), 0);
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
      per_frame[frame] += frames[frame].projectors.size();
      for (const animations::ProjectorSample& sample : frames[frame].projectors)
        names.insert({mesh, sample.id});
    }
  }
  counts.highlights = names.size();
  for (const std::size_t count : per_frame) counts.most = std::max(counts.most, count);
  return counts;
}

void run(const HighlightsArguments& arguments, const GlobalOptions& options) {
  const std::filesystem::path output = arguments.output;
  animations::require_animation_name(output);
  if (arguments.has_scene && output.extension() == ".json") {
    throw Error(ErrorKind::bad_usage,
                fmt::format("--with-scene: expected a file .glb or .gltf, got {}", arguments.output),
                "name it highlights.glb, or leave --with-scene out");
  }
  scene::Scene scene = scene::load_scene(arguments.scene, arguments.trust);
  GivenInputs inputs{scene::files_of(scene), arguments.trust};
  inputs.names.push_back(arguments.scene);
  require_new(arguments.output, arguments.existing, inputs);
  scene.time = arguments.frames.times(scene);
  const FrameRange frames = arguments.frames.frames(scene);
  const ocl::Device device = ocl::Device::open(choose_one_device(options.device));
  animations::HighlightAnimation animation = [&] {
    Progress progress(frames.last - frames.first + 1, "frames", options.verbosity);
    return record_highlights(device, scene, frames, arguments.has_scene ? Around::scene : Around::nothing,
                             progress, options.cancel);
  }();
  name_from(std::filesystem::absolute(output).parent_path(), animation);
  animations::write_highlights(output, animation, arguments.existing);
  const Counts counts = counts_of(animation);
  const int frame_count = frames.last - frames.first + 1;
  if (arguments.json) {
    print_json({{"file", arguments.output},
                {"frames", frame_count},
                {"frames_per_s", animation.frames_per_s},
                {"meshes", animation.meshes.size()},
                {"highlights", counts.highlights},
                {"most_in_a_frame", counts.most},
                {"bytes", std::filesystem::file_size(output)}});
  } else {
    print_summary("{}: {} frame{}, {} highlight{} on {} mesh{}, up to {} projector{} at once\n",
                  one_line(arguments.output), frame_count, frame_count == 1 ? "" : "s", counts.highlights,
                  counts.highlights == 1 ? "" : "s", animation.meshes.size(),
                  animation.meshes.size() == 1 ? "" : "es", counts.most, counts.most == 1 ? "" : "s");
  }
}

}  // namespace

void add_highlights_command(CLI::App& app, GlobalOptions& options) {
  const auto arguments = std::make_shared<HighlightsArguments>();
  CLI::App* command = app.add_subcommand("highlights", "export the moving highlights of a scene's meshes");
  command->add_option("SCENE", arguments->scene, "scene file (TOML) with [[mesh]]")
      ->transform(find_scene)
      ->required();
  constexpr const char* group = "Output";
  const auto add = [&](const char* names, std::string& target, const char* placeholder, const char* help) {
    return command->add_option(names, target, help)->type_name(placeholder)->group(group);
  };
  add("-o,--output", arguments->output, "FILE",
      "file to write. .json: all numbers, in world axes; .glb or .gltf: one node per projector, for engines")
      ->required();
  command
      ->add_flag("--with-scene", arguments->has_scene,
                 "also write the meshes, the camera and the lights (.glb, .gltf)")
      ->group(group);
  arguments->frames.add_frames_to(*command, group);
  arguments->frames.add_fps_to(*command, group);
  add_force_flag(*command, arguments->existing);
  command->add_flag("--json", arguments->json, "print the summary as JSON");
  add_trust_flag(*command, arguments->trust);
  add_global_options(*command, options, DeviceUse::one);
  command->footer(R"(
A projector is a box that casts its texture along -normal onto the faces of its mesh. The texture reaches
from -1 to 1 along right and up, over the box's width and height; beyond it is transparent. In glTF the +x,
+y and +z axes of its node are right, up and normal, and the node's scale is the size of the box. A scale
of 0 means no highlight.

Examples:
  offing highlights scenes/knot.toml -o knot.json --frames 0:47 --fps 24
  offing highlights scenes/knot.toml -o knot.glb
  offing highlights scenes/knot.toml --with-scene -o shot.glb)");
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli
