#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "host/base/argument.h"
#include "host/io/png_image.h"

namespace offing::cli {

/// One picture of many: up to 24 frames, evenly chosen with the first and the last among them, scaled down to
/// 320 pixels across, in rows, each with its number. All pictures are fitted to the size of the first.
class ContactSheet {
 public:
  /// `picture_of` gives the file of a frame's picture.
  ContactSheet(const FrameRange& frames, const std::function<std::filesystem::path(int)>& picture_of);

  /// Keeps a scaled copy of a frame's picture if the sheet shows that frame. draw() then does not read its
  /// file.
  void keep(int frame, const RgbImage& picture);

  /// Throws Error(bad_input) if a picture that was not kept is no PNG or cannot be read.
  RgbImage draw() const;

 private:
  struct Cell {
    int frame = 0;
    std::filesystem::path picture;
    RgbImage kept = {};  ///< the picture, scaled down; empty: to be read
  };
  std::vector<Cell> cells_;
};

}  // namespace offing::cli
