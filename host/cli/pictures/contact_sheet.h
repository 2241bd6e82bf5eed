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
  /// Of these frames, whose pictures are files of these names.
  ContactSheet(const FrameRange& frames, const std::function<std::filesystem::path(int)>& picture_of);

  /// Keeps what the sheet shows of a frame's picture, if anything: draw() then does not read the file.
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
