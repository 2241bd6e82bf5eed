#include "host/scene/file/scene_files.h"

#include <variant>

#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"

namespace offing::scene {

std::vector<std::string> files_of(const Scene& scene) {
  std::vector<std::string> files;
  for (const Parameter& row : parameter_table()) {
    if (row.rule != ParameterRule::file_name) continue;
    for (const ElementIndex element : elements_of(scene, *row.section)) {
      const std::string& file =
          std::get<ValueAt<std::string>>(row.storage).in(struct_at(&scene, *row.section, element));
      if (!file.empty()) files.push_back(file);
    }
  }
  return files;
}

}  // namespace offing::scene
