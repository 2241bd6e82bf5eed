#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/io/atomic_file.h"
#include "host/io/exr_image.h"

namespace offing {

/// An image as the blocks of a scan line EXR, one row each. OpenEXR's own ZIPS looks for repeated bytes that
/// the noise of floats does not have: this takes 0.4 of the time, and the files are as large.
struct ExrRows {
  int columns = 0, rows = 0;
  std::vector<std::span<const float>> channels;  ///< [rows][columns] each, in the order of their names
  PixelType pixel_type = PixelType::float_32;
  ExrCompression compression = ExrCompression::none;  ///< none or zips
};

/// Writes the table of places and the blocks behind the header, which begins the file. Packs on all
/// processors. Throws what AtomicFile throws, and Error(out_of_memory).
void write_exr_rows(AtomicFile& file, const ExrRows& image);

/// The bits of the 16-bit float that PixelType::half_16 makes of a value.
std::uint16_t half_bits(float value);

}  // namespace offing
