#pragma once

#include <algorithm>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/frame_files.h"
#include "host/cli/ocean/frame_maker.h"
#include "host/cli/ocean/frame_maps.h"
#include "host/cli/pictures/contact_sheet.h"
#include "host/io/exr_image.h"
#include "host/io/png_image.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// How far the 16-bit floats of a map were from the values, over all frames that were written.
struct HalfError {
  std::string_view unit;
  float largest_error = 0.0f, largest_value = 0.0f;
  /// What no error of values up to the largest is above.
  double bound() const { return std::max(largest_value * half_relative_error, half_absolute_error); }
};

/// Writes frames as EXR, mesh and preview, in this order, each file whole or not at all. Several threads may
/// write, each another frame.
class FrameWriter {
 public:
  /// The arguments must outlive this object.
  FrameWriter(const scene::Sea& sea, const BakeSettings& settings, const FrameFiles& files,
              std::string scene_hash, std::string spectrum_name);

  void write(BakedFrame frame);

  /// The sheet of all frames of the bake. It reads back pictures that this object did not write.
  const ContactSheet& contact_sheet() const { return contact_sheet_; }
  /// By name of the map; empty where 32-bit floats are written.
  const std::map<std::string_view, HalfError>& half_errors() const { return half_errors_; }

 private:
  RgbImage draw_preview(const BakedFrame& frame) const;
  void write_fields(BakedFrame& frame);
  void write_file(BakedFrame& frame, std::span<const BakedMap> maps);
  std::vector<float> round_to_half(const BakedMap& map, std::span<const float> values);
  ExrImage image_of(const BakedFrame& frame) const;
  void add_gerstner_attributes(ExrImage& image, double time_s) const;
  void set_wake_place(ExrImage& image, const BakedFrame::Wake& wake, int cells) const;
  void add_cascade_attributes(ExrImage& image, std::size_t cascade, const std::string& layer) const;

  const scene::Sea& sea_;
  const BakeSettings& settings_;
  const FrameFiles& files_;
  std::string scene_hash_;
  std::string spectrum_name_;
  double hs_m_;
  std::vector<BakedMap> maps_;
  ContactSheet contact_sheet_;
  std::mutex half_errors_mutex_;
  std::map<std::string_view, HalfError> half_errors_;
};

}  // namespace offing::cli
