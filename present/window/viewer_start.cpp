#include "present/window/viewer_start.h"

#include <fmt/format.h>

namespace offing::present {

ListedScene listed(const ViewOptions& options) {
  const std::filesystem::path& file = options.scene_file;
  return {.name = file.empty() ? options.scene_name + ".toml" : file.filename().string(), .file = file};
}

std::string first_save_name(const std::string& scene_name) {
  return (scene_name.empty() ? "scene" : scene_name) + "_edited.toml";
}

std::string title(const ViewOptions& options) {
  return options.scene_name.empty() ? "Offing" : fmt::format("Offing: {}", options.scene_name);
}

LiveSeaSettings sea_settings(const ViewOptions& options, const GlCapabilities& capabilities,
                             const CancelToken& cancel) {
  const Detail usual = capabilities.is_software ? Detail::low : Detail::high;
  return {.device = options.device,
          .frame = frame_settings(options.detail.value_or(usual), options.transfer),
          .cancel = &cancel};
}

ViewState start_state(const ViewOptions& options, const LiveSea& sea) {
  ViewState state{.scene = options.scene,
                  .camera = FreeCamera(sea.scene().view.camera),
                  .clock = SceneClock(options.time_s),
                  .save_name = first_save_name(options.scene_name),
                  .message = {.text = sea.warning()}};
  state.scene.view.camera = sea.scene().view.camera;
  return state;
}

float start_kept_hz(const ViewOptions& options, const GlCapabilities& capabilities) {
  constexpr double software_hz = 20.0;
  return static_cast<float>(options.kept_hz.value_or(capabilities.is_software ? software_hz : 0.0));
}

}  // namespace offing::present
