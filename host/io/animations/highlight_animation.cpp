#include "host/io/animations/highlight_animation.h"

#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"

namespace offing::animations {

void require_animation_name(const std::filesystem::path& file) {
  require_extension(file, {".json", ".glb", ".gltf"});
}

void write_highlights(const std::filesystem::path& file, const HighlightAnimation& animation,
                      Existing existing) {
  require_animation_name(file);
  if (file.extension() == ".json") {
    write_file_atomically(file, highlight_animation_json(animation), existing);
  } else {
    const GltfForm form = file.extension() == ".glb" ? GltfForm::binary : GltfForm::text;
    write_file_atomically(file, highlight_animation_gltf(animation, form), existing);
  }
}

}  // namespace offing::animations
