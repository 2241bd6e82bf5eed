#include <cstdint>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "host/c/arrays.h"
#include "host/c/handles.h"
#include "host/scene/prepare/scene_meshes.h"

using offing::Error;
using offing::ErrorKind;
using offing::c::require;
using offing::c::run;
using offing::c::Use;
using offing::c::write_values;
using offing::c::write_vector;
using offing::highlights::DrawnHighlight;
using offing::highlights::HighlightTexture;

static_assert(OFFING_TEXTURE_DOT == static_cast<int>(HighlightTexture::dot) &&
              OFFING_TEXTURE_WINDOW == static_cast<int>(HighlightTexture::window) &&
              OFFING_TEXTURE_STAR == static_cast<int>(HighlightTexture::star) &&
              OFFING_TEXTURE_RING == static_cast<int>(HighlightTexture::ring) &&
              OFFING_TEXTURE_STREAK == static_cast<int>(HighlightTexture::streak) &&
              OFFING_TEXTURE_HEART == static_cast<int>(HighlightTexture::heart) &&
              OFFING_TEXTURE_IMAGE == static_cast<int>(HighlightTexture::image) &&
              OFFING_TEXTURE_NORMAL_MAP == static_cast<int>(HighlightTexture::normal_map));

namespace {

const offing::world::WorldMesh& mesh_of(const OffingWorld& world, std::size_t mesh) {
  const std::vector<offing::world::WorldMesh>& meshes = world.world.meshes();
  if (mesh < meshes.size()) return meshes[mesh];
  throw Error(ErrorKind::bad_usage,
              fmt::format("mesh: expected an index below {}, got {}", meshes.size(), mesh),
              "offing_mesh_count() says how many meshes there are");
}

void write_highlight(const OffingHighlights& arrays, std::size_t index, const DrawnHighlight& drawn) {
  const offing::highlights::Projector& box = drawn.projector;
  const bool is_pin = drawn.id >= offing::highlights::first_pin_id;
  write_values(arrays.id, index, {std::uint64_t{drawn.id}});
  write_values(arrays.rule, index, {std::int32_t{drawn.rule}});
  write_values(arrays.copy, index, {std::int32_t{drawn.copy}});
  write_values(arrays.light, index, {std::int32_t{is_pin ? -1 : drawn.light}});
  write_vector(arrays.position_m, index, box.centre_m);
  write_vector(arrays.right, index, box.right);
  write_vector(arrays.up, index, box.up);
  write_vector(arrays.normal, index, box.normal);
  write_values(arrays.width_m, index, {box.width_m});
  write_values(arrays.height_m, index, {box.height_m});
  write_values(arrays.opacity, index, {drawn.opacity});
  write_values(arrays.texture, index, {static_cast<std::int32_t>(drawn.controls.texture)});
  write_values(arrays.softness, index, {drawn.controls.softness});
  write_vector(arrays.colour, index, drawn.controls.colour);
}

}  // namespace

size_t offing_mesh_count(const OffingWorld* world) {
  return world == nullptr ? 0 : world->world.meshes().size();
}

const char* offing_mesh_name(const OffingWorld* world, size_t mesh) {
  return mesh < offing_mesh_count(world) ? world->scene.meshes[mesh].name.c_str() : "";
}

OffingStatus offing_get_mesh_pose(OffingWorld* world, size_t mesh, OffingMeshPose* pose) {
  return run([&] {
    const Use use(world, "world");
    const auto& motion = mesh_of(*world, mesh).parameters().motion;
    const offing::highlights::RigidMotion found =
        motion ? motion(world->world.time_s()) : offing::highlights::RigidMotion{};
    const glm::dquat turn = glm::quat_cast(found.rotation);
    OffingMeshPose values{};
    values.size = sizeof values;
    write_vector(values.position_m, 0, found.translation_m);
    write_values(values.turn, 0, {turn.w, turn.x, turn.y, turn.z});
    offing::c::write_struct(pose, "pose", values);
  });
}

OffingStatus offing_find_highlights(OffingWorld* world, double first_s) {
  return run([&] {
    const Use use(world, "world");
    const double time_s = world->world.time_s();
    constexpr double longest_s = 7200.0;  // as far as bodies may leap
    if (!(first_s <= time_s && time_s - first_s <= longest_s)) {
      throw Error(ErrorKind::bad_input,
                  fmt::format("first_s: expected a time within {:g} s before that of the last frame, {:g} s, "
                              "got {:g} s",
                              longest_s, time_s, first_s),
                  "give the time of the first frame of the sequence");
    }
    world->world.see_meshes(world->camera.eye_m,
                            offing::scene::lighting_of(world->scene, world->world.terrain()), first_s);
  });
}

OffingStatus offing_count_highlights(OffingWorld* world, size_t mesh, size_t* count) {
  return run([&] {
    const Use use(world, "world");
    require(count, "count");
    *count = mesh_of(*world, mesh).highlights().size();
  });
}

OffingStatus offing_read_highlights(OffingWorld* world, size_t mesh, size_t count,
                                    const OffingHighlights* highlights) {
  return run([&] {
    const Use use(world, "world");
    const std::vector<DrawnHighlight>& found = mesh_of(*world, mesh).highlights();
    offing::c::require_count("count", count, found.size());
    if (count == 0) return;
    require(highlights, "highlights");
    const OffingHighlights wanted = offing::c::read_struct(highlights, "highlights");
    for (std::size_t i = 0; i < count; ++i) write_highlight(wanted, i, found[i]);
  });
}
