#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/exr_image.h"
#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

namespace {

const ExrContent::Channel& height_channel(const std::filesystem::path& path, const ExrContent& content,
                                          const std::string& wanted) {
  const auto find = [&](std::string_view name) {
    return std::find_if(content.channels.begin(), content.channels.end(),
                        [&](const ExrContent::Channel& channel) { return channel.name == name; });
  };
  if (wanted.empty() && content.channels.size() == 1) {
    return content.channels.front();
  }
  std::string there;
  for (const ExrContent::Channel& channel : content.channels) {
    there += (there.empty() ? "" : ", ") + channel.name;
  }
  constexpr std::array<std::string_view, 4> usual{"height", "Y", "Z", "R"};
  for (const std::string_view name : usual) {
    const auto found = find(wanted.empty() ? name : std::string_view(wanted));
    if (found != content.channels.end()) {
      return *found;
    }
  }
  throw Error(ErrorKind::bad_input,
              fmt::format("{}: expected a channel {}, found {}", path.string(),
                          wanted.empty() ? "height, Y, Z or R" : fmt::format("\"{}\"", wanted), there),
              "name the channel that holds heights: --channel NAME");
}

}  // namespace

SourceHeights read_exr_heights(const std::filesystem::path& path, const HeightMapOptions& options) {
  const ExrContent content = read_exr(path);
  const ExrContent::Channel& channel = height_channel(path, content, options.exr_channel);
  SourceHeights source = begin_heights(path, content.width, content.height);
  source.format = "OpenEXR";
  source.sample_type = "channel " + channel.name;
  const HeightScale scale{options.vertical_scale, options.offset_m};
  for (const float value : channel.values) append_sample(path, source, value, scale, options.nodata);
  return source;
}

}  // namespace offing::height_maps
