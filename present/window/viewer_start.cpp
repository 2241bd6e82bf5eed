#include "present/window/viewer_start.h"

#include <algorithm>

#include <fmt/format.h>

namespace offing::present {

ListedScene listed(const ViewOptions& options) {
  const std::filesystem::path& file = options.scene_file;
  return {.name = file.empty() ? options.scene_name + ".toml" : file.filename().string(), .file = file};
}

std::string first_save_name(const std::string& scene_name) {
  return scene_name.empty() ? "scene.toml" : scene_name + "_edited.toml";
}

std::string title(const ViewOptions& options) {
  return options.scene_name.empty() ? "Offing" : fmt::format("Offing: {}", options.scene_name);
}

WindowSettings window_settings(const ViewOptions& options, const WindowExtent& last) {
  const bool is_last = !options.size && !options.recording;
  const ImageSize size = options.size.value_or(ImageSize{});
  return {.title = title(options),
          .width = is_last ? last.width : size.width,
          .height = is_last ? last.height : size.height,
          .is_maximised = is_last && last.is_maximised};
}

LiveSeaSettings sea_settings(const ViewOptions& options, const GlCapabilities& capabilities,
                             const CancelToken& cancel, const Quality& quality) {
  const Detail usual = capabilities.is_software ? Detail::low : Detail::high;
  return {.device = options.device,
          .frame = frame_settings(options.detail.value_or(usual), options.transfer),
          .still = frame_settings(options.detail.value_or(Detail::high), options.transfer),
          .cancel = &cancel,
          .first = FirstView{
              .time_s = options.time_s,
              .quality = quality,
              .clouds = start_level(options, capabilities) > 0 ? FirstClouds::later : FirstClouds::at_once}};
}

ViewState start_state(const ViewOptions& options, const LiveSea& sea) {
  ViewState state{.scene = options.scene,
                  .camera = FreeCamera(sea.scene().view.camera),
                  .clock = SceneClock(options.time_s),
                  .message = {.text = sea.warning()}};
  state.scene.view.camera = sea.scene().view.camera;
  return state;
}

float start_kept_hz(const ViewOptions& options, const GlCapabilities& capabilities) {
  constexpr double software_hz = 20.0;
  return static_cast<float>(options.kept_hz.value_or(capabilities.is_software ? software_hz : 0.0));
}

std::size_t start_level(const ViewOptions& options, const GlCapabilities& capabilities) {
  constexpr double coarse_share = 0.6;
  if (!capabilities.is_software || start_kept_hz(options, capabilities) == 0.0f || options.recording)
    return 0;
  const auto coarse = std::ranges::find_if(
      quality_levels, [](const Quality& quality) { return quality.side_share <= coarse_share; });
  return static_cast<std::size_t>(coarse - quality_levels.begin());
}

}  // namespace offing::present
