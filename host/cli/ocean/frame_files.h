#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/frame_maps.h"
#include "host/command_line/input_files.h"
#include "host/io/exr_image.h"

namespace offing::cli {

/// 32 hexadecimal digits of all values of an EXR file, which its header has: uncompressed pixels have no
/// other check. The order of the channels does not matter.
std::string values_hash(std::vector<ImageChannel> channels);

/// Names of a bake's files, and what of them is there already.
class FrameFiles {
 public:
  /// `cascades` is how many the sea has, `scene_hash` what every EXR of this bake carries.
  FrameFiles(const BakeSettings& settings, int cascades, std::string scene_hash);

  /// Makes the folder, removes what killed runs left behind, and checks what is there. A folder with frames
  /// or the description of this very bake is an interrupted bake, which resumes: damaged frames, meshes and
  /// pictures are its own too. Throws Error(file) if the folder cannot be written to, Error(bad_usage) for an
  /// input among the files that a bake writes, and unless files may be replaced Error(bad_input) for another
  /// bake's frames and Error(bad_usage) for files that this bake would write over.
  void prepare_folder(const GivenInputs& inputs = {}) const;

  /// Whether all files of this frame exist, whole, from this very bake. Reads the EXR files through, so that
  /// a damaged one is found.
  bool is_done(int frame) const;

  /// Whether the frame's picture exists. Throws Error(file) if the system cannot tell.
  bool has_preview(int frame) const;

  /// Where another bake's frames are to be replaced: removes its EXR files of this frame that this bake will
  /// not write over (it had more cascades, or another layout), and the frame's pictures and meshes and the
  /// contact sheet, which would from then on stand beside the wrong sea. Files without a bake's hash stay.
  /// Throws Error(file).
  void remove_foreign_files(int frame) const;

  /// Removes the mesh and the picture of a frame that are to be made again. Throws Error(file).
  void remove_products(int frame) const;

  /// Whether this bake writes a file of this name into its folder.
  bool will_write(const std::filesystem::path& file) const;

  /// The EXR file of this BakedMap::file.
  std::filesystem::path exr(int frame, const std::string& file) const;
  std::filesystem::path mesh(int frame) const;
  std::filesystem::path preview(int frame) const;
  std::filesystem::path contact_sheet() const;
  std::filesystem::path description() const;  ///< ocean.json

 private:
  /// Files of a folder that have names of a bake's.
  struct Listing {
    std::vector<std::filesystem::path> exr_files, products;
  };
  static Listing list_folder(const std::filesystem::path& folder);
  void require_own_files(const Listing& listing) const;

  std::vector<std::filesystem::path> exr_files(int frame) const;
  /// What any bake may have named the EXR files of this frame.
  std::vector<std::filesystem::path> possible_exr_files(int frame) const;
  std::vector<std::filesystem::path> exr_files(int frame, const std::vector<BakedMap>& maps) const;
  std::filesystem::path product(int frame, const char* extension) const;

  const BakeSettings& settings_;
  std::vector<BakedMap> maps_, possible_maps_;
  std::string scene_hash_;
};

}  // namespace offing::cli
