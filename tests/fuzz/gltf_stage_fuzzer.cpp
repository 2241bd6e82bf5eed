// Cameras and lights of a glTF, with what moves them. Buffers that are files are looked for in a folder that
// does not exist.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host/base/error.h"
#include "host/io/meshes/gltf_stage.h"
#include "tests/fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace offing;
  using fuzz::expect;
  try {
    const meshes::GltfStage stage =
        meshes::parse_gltf_stage({reinterpret_cast<const char*>(data), size}, "/nowhere/fuzz");
    const double end_s = stage.nodes->end_s();
    expect(std::isfinite(end_s) && end_s >= 0.0);
    for (const double part : {-1.0, 0.0, 0.4, 1.0}) {
      const std::vector<glm::dmat4> to_world = stage.nodes->to_world(part * end_s);
      for (const meshes::GltfCamera& camera : stage.cameras) expect(camera.node < to_world.size());
      for (const meshes::GltfLight& light : stage.lights) expect(light.node < to_world.size());
    }
    for (const meshes::GltfLight& light : stage.lights) expect(light.intensity >= 0.0);
    for (const meshes::GltfCamera& camera : stage.cameras)
      expect(camera.vertical_field_of_view_rad > 0.0 && camera.vertical_field_of_view_rad < 3.2);
    for (const LeftOut& item : stage.left_out) expect(item.count > 0);
  } catch (const Error& error) {
    fuzz::expect_told(error);
  }
  return 0;
}
