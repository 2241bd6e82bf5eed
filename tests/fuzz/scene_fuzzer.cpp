// A scene that is read must have all that moves in it at any time, and be written as text that reads back the
// same.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/scene_meshes.h"
#include "tests/fuzz/expect.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace scene = offing::scene;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  return offing::fuzz::check_reading([&] {
    const scene::Scene read = scene::parse_scene(text, "fuzz.toml", "/nowhere");
    scene::view_at(read, 1.0);
    scene::lights_at(read, 1.0);
    scene::mesh_materials_at(read, 1.0);
    scene::mesh_rules_at(read, 1.0);
    const std::string written = scene::scene_text(read, "/nowhere");
    std::string again;
    try {
      again = scene::scene_text(scene::parse_scene(written, "again.toml", "/nowhere"), "/nowhere");
    } catch (const offing::Error&) {
      __builtin_trap();  // what is written can be read
    }
    offing::fuzz::expect(again == written);
  });
}
