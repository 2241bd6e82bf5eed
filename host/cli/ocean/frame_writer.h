#pragma once

#include <string>

#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/frame_files.h"
#include "host/cli/ocean/frame_maker.h"
#include "host/cli/pictures/contact_sheet.h"
#include "host/io/png_image.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

/// Writes frames as EXR, mesh and preview, in this order, each file whole or not at all.
class FrameWriter {
 public:
  /// The arguments must outlive this object.
  FrameWriter(const scene::Sea& sea, const BakeSettings& settings, const FrameFiles& files,
              std::string scene_hash, std::string spectrum_name);

  void write(const BakedFrame& frame);

  /// The sheet of all frames of the bake. It reads back pictures that this object did not write.
  const ContactSheet& contact_sheet() const { return contact_sheet_; }

 private:
  RgbImage draw_preview(const BakedFrame& frame) const;
  void write_fields(const BakedFrame& frame) const;
  ExrImage image_of(const BakedFrame& frame) const;
  void add_gerstner_attributes(ExrImage& image, double time_s) const;
  void add_cascade(ExrImage& image, const BakedFrame::CascadeFields& fields, const std::string& layer) const;
  void add_cascade_attributes(ExrImage& image, std::size_t cascade, const std::string& layer) const;

  const scene::Sea& sea_;
  const BakeSettings& settings_;
  const FrameFiles& files_;
  std::string scene_hash_;
  std::string spectrum_name_;
  double hs_m_;
  ContactSheet contact_sheet_;
};

}  // namespace offing::cli
