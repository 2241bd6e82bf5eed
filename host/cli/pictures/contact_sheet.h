#pragma once

#include <filesystem>
#include <span>

#include "host/io/png_image.h"

namespace offing::cli {

/// A picture on disk and the number to print on it.
struct ContactFrame {
  std::filesystem::path picture;
  int number = 0;
};

/// One picture of many: up to 24 frames, evenly chosen with the first and the last among them, scaled down to
/// 320 pixels across, in rows, each with its number. All pictures are fitted to the size of the first. Throws
/// Error(bad_input) if there is no frame or a picture is no PNG, Error(file) if one cannot be read.
RgbImage make_contact_sheet(std::span<const ContactFrame> frames);

}  // namespace offing::cli
