#include "present/window/bookmarks.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::present {
namespace {

std::string name_of(const scene::BookmarkScene& bookmark, std::size_t number) {
  return bookmark.name.empty() ? fmt::format("bookmark {}", number)
                               : fmt::format("bookmark {}, {}", number, bookmark.name);
}

}  // namespace

std::string set_bookmark(scene::Scene& scene, const Camera& camera, std::size_t number) {
  const std::size_t count = scene.bookmarks.size();
  if (number <= count) {
    scene.bookmarks[number - 1].camera = camera;
    return name_of(scene.bookmarks[number - 1], number) + " is this view now";
  }
  scene::append_element(scene, *scene::find_parameter("bookmark.name"), {.subject = "bookmark"});
  scene.bookmarks.back() = {.name = fmt::format("view {}", count + 1), .camera = camera};
  return name_of(scene.bookmarks.back(), count + 1) + " is this view";
}

std::string go_to_bookmark(const scene::Scene& scene, std::size_t number, Camera& camera) {
  if (number == 0 || number > scene.bookmarks.size()) {
    throw Error(ErrorKind::bad_usage, fmt::format("there is no bookmark {} in this scene", number),
                "Ctrl with the key sets it");
  }
  const int width_px = camera.width_px, height_px = camera.height_px;
  camera = scene.bookmarks[number - 1].camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  return name_of(scene.bookmarks[number - 1], number);
}

}  // namespace offing::present
