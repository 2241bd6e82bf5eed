#include "host/command_line/input_files.h"

#include <optional>
#include <system_error>

#include <sys/stat.h>

#include "host/io/height_maps/files_of_raster.h"
#include "host/io/meshes/gltf_document.h"
#include "host/io/spectra/gzip.h"
#include "host/io/spectra/ndbc_spectra.h"
#include "host/io/tile_store/tile_store.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

std::optional<std::pair<dev_t, ino_t>> identity_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return std::pair(status.st_dev, status.st_ino);
}

}  // namespace

InputFiles::InputFiles(const GivenInputs& inputs) {
  for (const std::string& name : inputs.names) {
    if (name.empty()) continue;
    const fs::path path = name;
    add(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      if (is_tile_store(path)) {
        add_entries<fs::recursive_directory_iterator>(path);
      } else {
        add_entries<fs::directory_iterator>(path);
      }
      continue;
    }
    if (!fs::is_regular_file(path, ignored)) continue;
    if (const auto companions = spectra::ndbc_companion_paths(spectra::unpacked_name(path))) {
      for (fs::path file : {companions->alpha1, companions->alpha2, companions->r1, companions->r2}) {
        add(file);
        add(file += ".gz");
      }
    }
    for (const fs::path& file : meshes::files_of_gltf(path)) add(file);
    for (const fs::path& file : height_maps::files_of_raster(path, inputs.trust)) add(file);
  }
}

void InputFiles::add(const fs::path& path) {
  if (const auto identity = identity_of(path)) files_.insert(*identity);
}

template <class Iterator>
void InputFiles::add_entries(const fs::path& folder) {
  std::error_code failure;
  for (Iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure)) {
    add(entry->path());
  }
}

bool InputFiles::contains(const fs::path& path) const {
  const auto identity = identity_of(path);
  return identity && files_.contains(*identity);
}

}  // namespace offing
