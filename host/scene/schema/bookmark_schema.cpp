#include <algorithm>
#include <array>

#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/scene/schema/parameter_storage.h"
#include "host/scene/schema/row_lists.h"

namespace offing::scene {
namespace {

constexpr auto bookmarks = &Scene::bookmarks;
constexpr auto camera = &BookmarkScene::camera;
constexpr auto eye = &Camera::eye_m;
constexpr std::size_t max_bookmarks = 64;

struct CameraRow {
  std::string_view key;  // of the camera's row
  std::string_view own_key;
  ValueAt<double> storage;
};

constexpr std::array<CameraRow, 7> camera_rows{
    {{"camera.x_m", "bookmark.x_m", &element<bookmarks, camera, eye, &glm::dvec3::x>},
     {"camera.y_m", "bookmark.y_m", &element<bookmarks, camera, eye, &glm::dvec3::y>},
     {"camera.z_m", "bookmark.z_m", &element<bookmarks, camera, eye, &glm::dvec3::z>},
     {"camera.yaw_deg", "bookmark.yaw_deg", &element<bookmarks, camera, &Camera::yaw_rad>},
     {"camera.pitch_deg", "bookmark.pitch_deg", &element<bookmarks, camera, &Camera::pitch_rad>},
     {"camera.roll_deg", "bookmark.roll_deg", &element<bookmarks, camera, &Camera::roll_rad>},
     {"camera.fov_deg", "bookmark.fov_deg",
      &element<bookmarks, camera, &Camera::vertical_field_of_view_rad>}}};

}  // namespace

std::vector<Parameter> bookmark_parameters() {
  std::vector<Parameter> rows{{.key = "bookmark.name",
                               .storage = &element<bookmarks, &BookmarkScene::name>,
                               .help = "for the panel of bookmarks",
                               .example = "bow",
                               .absent = "none",
                               .rule = ParameterRule::name}};
  const std::vector<Parameter> of_camera = view_parameters();
  for (const CameraRow& each : camera_rows) {
    Parameter row = *std::ranges::find(of_camera, each.key, &Parameter::key);
    row.key = each.own_key;
    row.storage = each.storage;
    row.motion = ParameterMotion::constant;
    rows.push_back(row);
  }
  return rows_of_section(section_of_list<bookmarks>, ParameterGroup::bookmark, max_bookmarks,
                         std::move(rows));
}

}  // namespace offing::scene
