#pragma once

#include <optional>

#include "host/clouds/image/billboard_textures.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// The billboard textures of a scene that names folders of pictures for them: all PNG files of a folder in
/// the order of their names are a set, and the other set, if it has no folder, is Offing's own. Nothing for a
/// scene that names none. Throws Error(bad_input) that tells where the scene names the folder, unless it has
/// CLOUD_TEXTURES whole PNG files.
std::optional<clouds::BillboardTextures> own_billboards(const Scene& scene);

}  // namespace offing::scene
