#include "present/window/scene_list.h"

#include <algorithm>
#include <system_error>

#include "present/window/scene_sources.h"

namespace offing::present {
namespace {

void sort_by_name(std::vector<ListedScene>& scenes) {
  std::ranges::sort(scenes, {}, &ListedScene::name);
}

}  // namespace

SceneList::SceneList() {
  for (const EmbeddedFile& file : scene_sources()) shipped_.push_back({std::string(file.name), {}});
  sort_by_name(shipped_);
}

void SceneList::follow(const std::filesystem::path& file) {
  if (!file.empty()) folder_ = file.parent_path();
  look();
}

void SceneList::look() {
  beside_.clear();
  std::error_code failed;
  std::filesystem::directory_iterator entry(folder_.empty() ? "." : folder_, failed);
  for (; !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed)) {
    std::error_code unknown;
    if (entry->path().extension() != ".toml" || !entry->is_regular_file(unknown)) continue;
    const std::filesystem::path name = entry->path().filename();
    beside_.push_back({name.string(), folder_ / name});
  }
  sort_by_name(beside_);
}

}  // namespace offing::present
