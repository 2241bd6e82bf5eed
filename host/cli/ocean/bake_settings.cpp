#include "host/cli/ocean/bake_settings.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offing::cli {

namespace {

constexpr std::array<std::string_view, channel_group_count> channel_names = {
    "displacement", "slope", "gradient", "jacobian", "foam", "velocity", "normal"};

}  // namespace

std::vector<int> frames_in_share(const FrameRange& frames, const Share& share) {
  std::vector<int> own;
  for (int frame = frames.first + share.index; frame <= frames.last; frame += share.count) {
    own.push_back(frame);
  }
  return own;
}

ChannelGroups usual_channels(FileLayout layout) {
  return read_channels("--channels", layout == FileLayout::rgb ? "displacement,foam,normal"
                                                               : "displacement,slope,gradient,jacobian,foam");
}

ChannelGroups read_channels(std::string_view flag, std::string_view text) {
  ChannelGroups groups;
  while (true) {
    const std::size_t comma = text.find(',');
    const std::string_view name = text.substr(0, comma);
    const auto at = std::find(channel_names.begin(), channel_names.end(), name);
    if (at == channel_names.end()) {
      throw bad_argument(flag, fmt::format("names from {}", fmt::join(channel_names, ", ")), name,
                         "displacement,foam");
    }
    groups.set(static_cast<std::size_t>(at - channel_names.begin()));
    if (comma == std::string_view::npos) {
      return groups;
    }
    text.remove_prefix(comma + 1);
  }
}

std::string canonical_text(const BakeSettings& settings) {
  std::string text = fmt::format("layout {} pixel {} compression {} channels {}",
                                 static_cast<int>(settings.layout), static_cast<int>(settings.pixel_type),
                                 static_cast<int>(settings.compression), settings.channels.to_string());
  if (settings.axes == MapAxes::z_up) {
    text += " axes z-up";
  }
  if (settings.gerstner == GerstnerUse::included) {
    text += " gerstner included";
  }
  if (settings.has(ChannelGroup::velocity)) {
    text += fmt::format(" velocity depth {:.17g}", settings.velocity_depth_m);
  }
  if (!settings.wake_cells.empty()) {
    text += fmt::format(" wakes {}", fmt::join(settings.wake_cells, " "));
  }
  return text;
}

}  // namespace offing::cli
