#include "present/editing/objects/object_editor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "host/bodies/body_pose.h"
#include "host/scene/prepare/mesh_motion.h"
#include "host/scene/prepare/scene_bodies.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/cloud_picker.h"
#include "present/editing/objects/handle_overlay.h"
#include "present/editing/objects/selection.h"
#include "present/editing/pointed_place.h"
#include "present/editing/terrain_pick.h"

namespace offing::present {
namespace {

using highlights::RigidMotion;

constexpr double snap_rad = std::numbers::pi / 12.0;
// Of a light without a place: so long is the arrow.
constexpr double aim_px = 100.0;
constexpr std::array aim_handles{ObjectHandle::free};
constexpr scene::Affects of_objects =
    scene::Affects::meshes | scene::Affects::mesh_looks | scene::Affects::bodies | scene::Affects::lights;

/// What a hand that holds this can change, but for bookmarks.
scene::Affects affected_by(const SceneObject& held) {
  if (held.kind == ObjectKind::cloud_layer) return scene::Affects::clouds;
  if (held.kind == ObjectKind::wake) return scene::Affects::wakes;
  return of_objects;
}

/// The mesh that is selected, or that the selected body moves.
std::optional<std::size_t> selected_mesh(const ViewState& state) {
  const std::optional<SceneObject> object = selected_object(state);
  if (!object) return {};
  if (object->kind == ObjectKind::mesh) return object->index;
  if (object->kind == ObjectKind::body) return hull_of_body(state.scene, object->index);
  return {};
}

std::optional<std::size_t> selected_light(const ViewState& state) {
  const std::optional<SceneObject> object = selected_object(state);
  if (!object || object->kind != ObjectKind::light) return {};
  return object->index;
}

glm::dvec3 in_world(const RigidMotion& motion, const glm::dvec3& place_m) {
  return motion.rotation * place_m + motion.translation_m;
}

/// The first of two motions that `both` are, one after the other.
RigidMotion outer_of(const RigidMotion& both, const RigidMotion& inner) {
  const glm::dmat3 rotation = both.rotation * glm::transpose(inner.rotation);
  return {rotation, both.translation_m - rotation * inner.translation_m};
}

highlights::Source light_at(const ViewState& state, std::size_t light) {
  return scene::lights_at(state.scene, state.clock.time_s()).at(light).source;
}

glm::dvec3 aim_from_m(const Screen& screen) {
  return screen.camera.eye_m + ahead_m * basis(screen.camera).forward;
}

double aim_length_m(const Screen& screen) {
  return aim_px * pixel_m(screen, aim_from_m(screen));
}

/// The direction that a point of the screen means for the end of an arrow: on the sphere around its start,
/// on the side of the eye, or on its outline.
glm::dvec3 aimed(const Screen& screen, glm::dvec2 clip, bool is_before) {
  const Ray ray = ray_at(screen, clip);
  const glm::dvec3 way_m = aim_from_m(screen) - ray.origin_m;
  const double along_m = glm::dot(way_m, ray.direction), length_m = aim_length_m(screen);
  const glm::dvec3 beside_m = along_m * ray.direction - way_m;
  const double depth_squared = length_m * length_m - glm::dot(beside_m, beside_m);
  const double depth_m = std::sqrt(std::max(depth_squared, 0.0));
  return glm::normalize(beside_m + (is_before ? -depth_m : depth_m) * ray.direction);
}

/// A tenth of what is about as large as the object.
double step_of(const Sphere& sphere) {
  return std::pow(10.0, std::floor(std::log10(std::max(sphere.radius_m, 1.0))));
}

/// How far along a ray the ground is; infinity where it meets none.
double distance_of_ground_m(LiveSea& sea, const Screen& screen, glm::dvec2 clip) {
  constexpr double none = std::numeric_limits<double>::infinity();
  if (sea.terrain() == nullptr || !sea.terrain()->is_in_reach()) return none;
  const std::optional<TerrainPick> ground = pick_terrain(*sea.terrain(), screen.camera, clip);
  return ground ? ground->distance_m : none;
}

/// A light that stands at a place, or a bookmark, on the screen.
struct ObjectIcon {
  SceneObject handle;
  glm::dvec2 place_px;
};
/// None while panels are hidden.
std::vector<ObjectIcon> object_icons(const ViewState& state, const Screen& screen) {
  std::vector<ObjectIcon> icons;
  if (!state.shows_panels) return icons;
  const auto add = [&](const SceneObject& object, const glm::dvec3& place_m) {
    if (const std::optional<glm::dvec2> place_px = pixel_of(screen, place_m))
      icons.push_back({object, *place_px});
  };
  for (std::size_t i = 0; i < state.scene.bookmarks.size(); ++i)
    add({ObjectKind::bookmark, i}, state.scene.bookmarks[i].camera.eye_m);
  for (std::size_t i = 0; i < state.scene.lights.size(); ++i) {
    if (state.scene.lights[i].kind == scene::LightKind::place)
      add({ObjectKind::light, i}, light_at(state, i).vector);
  }
  return icons;
}

void draw_light_icon(const OverlayPainter& painter, glm::dvec2 place_px) {
  constexpr ImU32 light_colour = IM_COL32(250, 220, 120, 255);
  constexpr int rays = 8;
  painter.disc(place_px, 5.5, handle_shade);
  painter.disc(place_px, 4.5, light_colour);
  for (int ray = 0; ray < rays; ++ray) {
    const double angle_rad = 2.0 * std::numbers::pi * ray / rays;
    const glm::dvec2 way(std::cos(angle_rad), std::sin(angle_rad));
    painter.line(place_px + 7.0 * way, place_px + 10.0 * way, light_colour, 1.5);
  }
}

/// A camera from the side.
void draw_camera_icon(const OverlayPainter& painter, glm::dvec2 place_px) {
  constexpr ImU32 camera_colour = IM_COL32(190, 150, 230, 255);
  const auto at = [&](double x, double y) { return place_px + glm::dvec2(x, y); };
  painter.rectangle(at(-8.0, -5.0), at(4.0, 6.0), handle_shade);
  painter.rectangle(at(-7.0, -4.0), at(3.0, 5.0), camera_colour);
  painter.triangle(at(2.0, 0.5), at(9.0, -5.0), at(9.0, 6.0), camera_colour);
}

void draw_icons(const OverlayPainter& painter, const std::vector<ObjectIcon>& icons) {
  for (const ObjectIcon& icon : icons) {
    if (icon.handle.kind == ObjectKind::light) {
      draw_light_icon(painter, icon.place_px);
    } else {
      draw_camera_icon(painter, icon.place_px);
    }
  }
}

/// The square that a layer of clouds or a wake window is.
std::optional<Sphere> square_of(const ViewState& state, const LiveSea& sea) {
  const std::optional<SceneObject> object = selected_object(state);
  if (!object || (object->kind != ObjectKind::cloud_layer && object->kind != ObjectKind::wake)) return {};
  const double time_s = state.clock.time_s();
  if (const std::optional<Sphere> place = place_of(state.scene, *object, time_s)) return place;
  const scene::WakeScene& wake = state.scene.ocean.wakes[object->index];
  if (wake.centre != scene::WakeCentre::body || sea.bodies() == nullptr) return {};
  const std::size_t body = scene::followed_body(state.scene, object->index);
  if (body >= sea.bodies()->size()) return {};
  const bodies::BodyPose pose = sea.bodies()->pose(body, time_s);
  const double heading_rad = bodies::heading_of(pose);
  const glm::dvec3 ahead(std::cos(heading_rad), 0.0, std::sin(heading_rad));
  const glm::dvec3 middle_m = pose.mass_centre_m - wake.behind_m * ahead;
  return Sphere{{middle_m.x, 0.0, middle_m.z}, 0.5 * wake.parameters.length_m};
}

/// Level, along the world's axes.
void draw_square(const OverlayPainter& painter, const Screen& screen, const Sphere& square) {
  constexpr std::array<glm::dvec2, 5> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
  constexpr int parts = 32;  // of a side, of which some may be behind the eye
  std::optional<glm::dvec2> last_px;
  for (std::size_t side = 0; side + 1 < corners.size(); ++side) {
    for (int part = 0; part <= parts; ++part) {
      const double share = 1.0 * part / parts;
      const glm::dvec2 way_m = square.radius_m * ((1.0 - share) * corners[side] + share * corners[side + 1]);
      const auto now_px = pixel_of(screen, square.centre_m + glm::dvec3(way_m.x, 0.0, way_m.y));
      if (last_px && now_px) painter.shaded_line(*last_px, *now_px, selected_colour);
      last_px = now_px;
    }
  }
}

HandleSet handles_of(ObjectKind kind) {
  if (kind == ObjectKind::bookmark) return camera_handles();
  return kind == ObjectKind::wake ? water_square_handles() : square_handles();
}

}  // namespace

std::optional<HeldPlace> held_place(const ViewState& state, const LiveSea& sea, const Screen& screen) {
  if (state.picked) return {};
  if (const std::optional<std::size_t> index = selected_mesh(state)) {
    if (*index >= sea.meshes().size()) return {};
    const world::WorldMesh& mesh = sea.meshes()[*index];
    const bool floats = body_of_mesh(state.scene, *index).has_value();
    return HeldPlace{{in_world(mesh.motion(), mesh.surface().middle_m()), 0.5 * mesh.surface().diagonal_m()},
                     floats ? floating_handles() : mesh_handles()};
  }
  const std::optional<std::size_t> light = selected_light(state);
  if (!light) {
    const std::optional<SceneObject> object = selected_object(state);
    const auto place = object ? place_of(state.scene, *object, state.clock.time_s()) : std::nullopt;
    if (!place) return {};
    return HeldPlace{*place, handles_of(object->kind)};
  }
  const highlights::Source source = light_at(state, *light);
  if (source.kind == highlights::Source::Kind::place) return HeldPlace{{source.vector, 0.0}, place_handles()};
  const glm::dvec3 tip_m = aim_from_m(screen) + aim_length_m(screen) * glm::normalize(source.vector);
  return HeldPlace{{tip_m, 0.0}, aim_handles, true};
}

/// All that the hand has changed.
void ObjectEditor::take_back(const Grab& grab, scene::Scene& scene) {
  const auto* object = std::get_if<SceneObject>(&grab.held);
  scene::take_values(object != nullptr ? affected_by(*object) : of_objects, grab.before, scene);
  if (object != nullptr && object->kind == ObjectKind::bookmark) scene.bookmarks = grab.before.bookmarks;
}

void ObjectEditor::let_go() {
  grab_.reset();
  pressed_.reset();
}

void ObjectEditor::press(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip) {
  pressed_ = clip;
  const std::optional<HeldPlace> place = held_place(state, sea, screen);
  if (!place) return;
  const std::optional<ObjectHandle> handle = object_handle_at(
      object_handle_places(screen, place->sphere, place->handles), pixel_of_clip(screen, clip));
  if (!handle) return;
  Grab grab{.handle = *handle,
            .sphere = place->sphere,
            .held = {},
            .aims = place->aims,
            .world = {},
            .from = clip,
            .before = state.scene,
            .at = clip};
  const double time_s = state.clock.time_s();
  if (const std::optional<std::size_t> index = selected_mesh(state)) {
    const world::WorldMesh& mesh = sea.meshes()[*index];
    grab.world = mesh.motion();
    if (const std::optional<std::size_t> body = body_of_mesh(state.scene, *index)) {
      HeldBody held{.body = *body, .hull = index};
      const bool drives = state.scene.bodies[*body].motion == scene::BodyMotion::forces;
      if (drives && sea.bodies() != nullptr && *body < sea.bodies()->size()) {
        const bodies::BodyPose pose = sea.bodies()->pose(*body, time_s);
        held.pose = {pose.mass_centre_m.x, pose.mass_centre_m.z, bodies::heading_of(pose)};
      }
      grab.held = held;
    } else {
      HeldMesh held{.mesh = *index, .middle_m = mesh.surface().middle_m()};
      held.local = scene::motion_of(state.scene, *index)(time_s);
      if (!state.scene.meshes[*index].aboard.empty()) held.parent = outer_of(mesh.motion(), held.local);
      grab.held = held;
    }
  } else {
    grab.held = *selected_object(state);
  }
  grab_ = std::move(grab);
}

Edit ObjectEditor::pull(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip, bool snaps) {
  Grab& grab = *grab_;
  if (clip == grab.at) return Edit::none;
  ObjectPull pulled;
  glm::dvec3 aim_before(0.0), aim_after(0.0);
  if (grab.aims) {
    aim_before = glm::normalize(grab.sphere.centre_m - aim_from_m(screen));
    const bool is_before = glm::dot(aim_before, basis(screen.camera).forward) < 0.0;
    aim_after = aimed(screen, clip, is_before);
  } else {
    const HandleSteps steps{snaps ? step_of(grab.sphere) : 0.0, snaps ? snap_rad : 0.0};
    const std::optional<ObjectPull> pull =
        object_pull(screen, grab.handle, grab.sphere, grab.from, clip, steps);
    if (!pull) return Edit::none;
    pulled = *pull;
  }
  grab.at = clip;
  grab.pull = pulled;
  take_back(grab, state.scene);
  if (const auto* mesh = std::get_if<HeldMesh>(&grab.held)) pull_mesh(state.scene, *mesh, pulled);
  if (const auto* body = std::get_if<HeldBody>(&grab.held)) pull_body(state.scene, *body, pulled);
  const auto* object = std::get_if<SceneObject>(&grab.held);
  if (object != nullptr && grab.aims) {
    aim_light(state.scene, object->index, aim_before, aim_after);
  } else if (object != nullptr) {
    pull_place(state.scene, *object, grab.sphere, pulled);
  }
  // Bodies begin anew with each edit, and so do clouds and wakes; a large mesh would hold up the hand.
  constexpr double quick_s = 0.1;
  const bool is_light = object != nullptr && object->kind == ObjectKind::light;
  const bool is_slow = !is_light && !std::holds_alternative<HeldMesh>(grab.held);
  if (is_slow || sea.edit_s() > quick_s) return Edit::none;
  grab.is_shown = true;
  return Edit::going_on;
}

void ObjectEditor::select_at(ViewState& state, LiveSea& sea, const Screen& screen, glm::dvec2 clip) {
  if (const auto object = handle_near(object_icons(state, screen), pixel_of_clip(screen, clip)))
    return select_object(state, *object);
  const std::optional<MeshHit> hit = picker_.hit(sea.meshes(), screen.camera, clip);
  if (hit && hit->distance_m < distance_of_ground_m(sea, screen, clip)) {
    const bool is_again = selected_mesh(state) == hit->mesh;
    const std::optional<std::size_t> body = body_of_mesh(state.scene, hit->mesh);
    const SceneObject object =
        body ? SceneObject{ObjectKind::body, *body} : SceneObject{ObjectKind::mesh, hit->mesh};
    if (!is_again) return select_object(state, object);
    state.picked = hit->highlight;
    return;
  }
  if (state.clouds.pick == CloudPick::clouds) {  // the editor of clouds has looked for one
    state.object.reset();
    state.picked.reset();
    return;
  }
  const ShownClouds shown{state.scene, sea.clouds(), state.clock.time_s()};
  if (const std::optional<CloudPart> cloud = pick_cloud(shown, ray_at(screen, clip)))
    return select_object(state, {ObjectKind::cloud, cloud->cloud});
  deselect_objects(state);
}

Edit ObjectEditor::release(ViewState& state, LiveSea& sea, const Screen& screen, const PointerEvent& event,
                           bool snaps) {
  std::optional<glm::dvec2> pressed = std::exchange(pressed_, std::nullopt);
  const bool is_click = pressed && glm::distance(pixel_of_clip(screen, *pressed),
                                                 pixel_of_clip(screen, event.clip)) <= click_px;
  if (!grab_) {
    if (is_click && !event.is_beside) select_at(state, sea, screen, event.clip);
    return Edit::none;
  }
  pull(state, sea, screen, event.clip, snaps);
  const Grab grab = *std::exchange(grab_, std::nullopt);
  if (grab.at != grab.from && !is_click) return Edit::done;
  take_back(grab, state.scene);
  // Handles lie over what they move.
  if (is_click) select_at(state, sea, screen, event.clip);
  return grab.is_shown ? Edit::taken_back : Edit::none;
}

Edit ObjectEditor::turn(ViewState& state, LiveSea& sea, const Screen& screen,
                        const std::vector<PointerEvent>& events, const PointerNow& pointer) {
  Edit edit = Edit::none;
  for (const PointerEvent& event : events) {
    if (event.kind == PointerEvent::Kind::pressed) {
      press(state, sea, screen, event.clip);
    } else {
      edit = std::max(edit, release(state, sea, screen, event, pointer.is_snapping));
    }
  }
  if (grab_) edit = std::max(edit, pull(state, sea, screen, pointer.clip, pointer.is_snapping));
  return edit;
}

const ObjectEditor::Box& ObjectEditor::box_of(const world::WorldMesh& mesh) {
  if (box_ && box_->revision == mesh.revision()) return *box_;
  Box box{mesh.revision(), glm::dvec3(std::numeric_limits<double>::infinity()), glm::dvec3(0.0)};
  box.high_m = -box.low_m;
  for (const glm::dvec3& place_m : mesh.surface().mesh().positions_m) {
    box.low_m = glm::min(box.low_m, place_m);
    box.high_m = glm::max(box.high_m, place_m);
  }
  box_ = box;
  return *box_;
}

/// Where a hand has brought it, though the world has not followed yet.
void ObjectEditor::draw_box(const OverlayPainter& painter, const LiveSea& sea, const Screen& screen,
                            std::size_t index) {
  const world::WorldMesh& mesh = sea.meshes()[index];
  const Box& box = box_of(mesh);
  RigidMotion motion = mesh.motion();
  double ratio = 1.0;
  if (grab_ && !grab_->is_shown) {
    ratio = grab_->pull.ratio;
    motion.rotation = rotation_of(grab_->pull) * grab_->world.rotation;
    motion.translation_m =
        grab_->sphere.centre_m + grab_->pull.way_m - motion.rotation * (ratio * mesh.surface().middle_m());
  }
  std::array<std::optional<glm::dvec2>, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 corner((i & 1u) != 0 ? box.high_m.x : box.low_m.x,
                            (i & 2u) != 0 ? box.high_m.y : box.low_m.y,
                            (i & 4u) != 0 ? box.high_m.z : box.low_m.z);
    corners[i] = pixel_of(screen, in_world(motion, ratio * corner));
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (const std::size_t bit : {1u, 2u, 4u}) {
      const std::size_t other = i | bit;
      if (other == i || !corners[i] || !corners[other]) continue;
      painter.shaded_line(*corners[i], *corners[other], selected_colour);
    }
  }
}

void ObjectEditor::draw(const ViewState& state, const LiveSea& sea, const Screen& screen) {
  const OverlayPainter painter(screen);
  draw_icons(painter, object_icons(state, screen));
  if (const std::optional<Sphere> square = square_of(state, sea)) draw_square(painter, screen, *square);
  const std::optional<HeldPlace> place = held_place(state, sea, screen);
  if (!place) return;
  if (const std::optional<std::size_t> mesh = selected_mesh(state)) draw_box(painter, sea, screen, *mesh);
  Sphere sphere = place->sphere;
  if (grab_ && !grab_->is_shown && !grab_->aims) sphere.centre_m = grab_->sphere.centre_m + grab_->pull.way_m;
  if (place->aims) {
    const auto from_px = pixel_of(screen, aim_from_m(screen)), to_px = pixel_of(screen, sphere.centre_m);
    if (from_px && to_px) painter.line(*from_px, *to_px, selected_colour, 2.0);
    const auto places = object_handle_places(screen, sphere, place->handles);
    if (object_handle_at(places, painter.pointer())) explain_handle("drag: turn the light");
  } else {
    explain_object_handle(painter, screen, sphere, place->handles);
  }
  draw_object_handles(painter, screen, sphere, place->handles);
}

}  // namespace offing::present
