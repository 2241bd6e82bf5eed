#include "host/scene/file/scene_files.h"

#include <filesystem>
#include <variant>

#include "host/io/meshes/mesh_sequence.h"
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
      if (file.empty()) continue;
      files.push_back(file);
      for (const std::filesystem::path& each : files_of_mesh_sequence(file)) files.push_back(each.string());
    }
  }
  return files;
}

}  // namespace offing::scene
