#pragma once

#include <filesystem>
#include <string>

#include "host/io/png_image.h"
#include "host/world/world.h"
#include "present/passes/frame.h"

namespace offing::present {

/// Throws Error(bad_usage) unless the name ends in .png or .exr.
void require_image_name(const std::filesystem::path& path);

/// The first of stem_001.png, stem_002.png ... that is no file yet. Throws Error(file) for a name that cannot
/// be looked up.
std::filesystem::path unused_image_name(const std::string& stem);

/// The last picture of a frame as a screen shows it, the first row at the top.
RgbImage shown_image(const Frame& frame);

/// Writes the last picture of a frame: .png as a screen shows it; .exr scene-linear kcd/m2 with the time, the
/// eye and the exposure in its header. Equal pictures give equal bytes. Throws Error(file) if it cannot be
/// written.
void write_image(const std::filesystem::path& path, const Frame& frame, double time_s, double exposure,
                 Existing existing);

}  // namespace offing::present
