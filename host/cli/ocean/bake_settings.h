#pragma once

#include <bitset>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "host/base/argument.h"
#include "host/command_line/new_output.h"
#include "host/io/exr_image.h"

namespace offing::cli {

/// Groups of channels in a baked EXR; foam, jacobian and the rest are of one cascade alone.
enum class ChannelGroup { displacement, slope, gradient, jacobian, foam, velocity, normal };
inline constexpr std::size_t channel_group_count = 7;
using ChannelGroups = std::bitset<channel_group_count>;

/// One file a cascade with all channels, one file a frame, or one plain RGB or Y file a map.
enum class FileLayout { channels, combined, rgb };
/// What x, y and z are in files: east, up and south, or east, north and up.
enum class MapAxes { y_up, z_up };
enum class MeshFormat { none, obj, ply };
enum class PreviewUse { none, pictures };
/// Whether the first cascade holds the Gerstner waves, or the header alone.
enum class GerstnerUse { listed, included };

/// How frames are written, and where.
struct BakeSettings {
  std::filesystem::path folder;
  FrameRange frames;
  Share share;
  double frames_per_second = 24.0;
  FileLayout layout = FileLayout::channels;
  MapAxes axes = MapAxes::y_up;
  PixelType pixel_type = PixelType::float_32;
  ExrCompression compression = ExrCompression::none;
  ChannelGroups channels;
  double velocity_depth_m = 0.0;  ///< of the velocity channels, below the instantaneous surface
  MeshFormat mesh = MeshFormat::none;
  PreviewUse preview = PreviewUse::none;
  GerstnerUse gerstner = GerstnerUse::listed;
  Existing existing = Existing::keep;
  std::vector<int> wake_cells;  ///< sizes of the wake windows that are written; none: they are left out

  bool has(ChannelGroup group) const { return channels.test(static_cast<std::size_t>(group)); }
  double time_s(int frame) const { return frame / frames_per_second; }
};

/// Frames of a share: first + index, first + index + count, ... so that every process gets early and late
/// ones and shares differ by at most one frame.
std::vector<int> frames_in_share(const FrameRange& frames, const Share& share);

/// Groups that are written unless others are asked for.
ChannelGroups usual_channels(FileLayout layout);

/// "displacement,slope,foam" as groups. Throws Error(bad_usage) that names an unknown one.
ChannelGroups read_channels(std::string_view flag, std::string_view text);

/// All that shapes the bytes of an EXR besides the sea, in one line; for the scene hash.
std::string canonical_text(const BakeSettings& settings);

}  // namespace offing::cli
