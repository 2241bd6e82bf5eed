#include "host/scene/prepare/own_billboards.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/png_image.h"
#include "host/scene/model/named_file.h"

namespace offing::scene {
namespace {

std::vector<RgbaImage> read_images(const std::string& folder, Trust trust) {
  std::vector<std::filesystem::path> files;
  std::error_code failure;
  // Not a range: its steps throw what is no Error.
  for (std::filesystem::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    if (entry->path().extension() == ".png") files.push_back(entry->path());
  }
  if (failure || files.size() != CLOUD_TEXTURES) {
    throw Error(
        ErrorKind::bad_input,
        failure ? fmt::format("{}: cannot be read as a folder: {}", folder, failure.message())
                : fmt::format("{}: expected {} PNG files, found {}", folder, CLOUD_TEXTURES, files.size()),
        "name a folder with one PNG picture for each texture of a set");
  }
  std::sort(files.begin(), files.end());
  std::vector<RgbaImage> pictures;
  for (const std::filesystem::path& file : files) {
    if (trust == Trust::untrusted) require_below(folder, file);
    pictures.push_back(read_png_with_alpha(file));
  }
  return pictures;
}

}  // namespace

std::optional<clouds::BillboardTextures> own_billboards(const Scene& scene) {
  const CloudsScene& settings = scene.cloud_settings;
  if (settings.crisp_billboards.empty() && settings.soft_billboards.empty()) return {};
  clouds::BillboardTextures textures = clouds::billboard_textures();
  const auto replace = [&](const char* key, const std::string& folder, int set) {
    if (folder.empty()) return;
    read_named(scene, key, "a folder of pictures", folder, [&] {
      clouds::replace_billboards(textures, set, read_images(folder, scene.trust));
      return set;
    });
  };
  replace("clouds.crisp_billboards", settings.crisp_billboards, 0);
  replace("clouds.soft_billboards", settings.soft_billboards, 1);
  return textures;
}

}  // namespace offing::scene
