#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "host/base/log.h"
#include "host/base/work.h"
#include "host/io/atomic_file.h"
#include "host/scene/model/scene.h"
#include "present/gl/transfer.h"
#include "present/output/recorder.h"
#include "present/passes/frame.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's
class App;
}  // namespace CLI

namespace offing::present {

struct ImageSize {
  int width = 1280, height = 720;
};

/// "1280x720", each side within 1 ... 16384. Throws Error(bad_usage).
ImageSize read_size(std::string_view flag, std::string_view text);

/// How finely pictures are drawn.
enum class Detail {
  low,   ///< for a window where the CPU draws
  high,  ///< for pictures in files, and where a GPU draws
};
FrameSettings frame_settings(Detail detail, std::optional<TransferPath> transfer = {});

/// What --compare-reference asks for.
struct ReferenceComparison {
  std::filesystem::path folder;
  int samples = 32;  ///< paths a pixel
  bool prints_json = false;
  Existing existing = Existing::keep;
  bool is_new_folder = false;  ///< made by this command: removed again if it fails

  /// "drawn.png", "reference.png", "error.png", "compared.exr"
  std::filesystem::path file(const char* name) const { return folder / name; }
};

/// What the command line asks for, checked.
struct ViewOptions {
  scene::Scene scene;
  std::string scene_name;            ///< for titles; empty without a file
  std::filesystem::path scene_file;  ///< empty: none
  bool opens_window = true;
  std::optional<ImageSize> size;  ///< absent: what suits the machine
  std::optional<Detail> detail;
  std::optional<double> kept_hz;   ///< frames a second that a window keeps; absent: what suits the machine
  double render_scale = 1.0;       ///< of a window to begin with: ViewState::render_scale
  std::optional<double> ui_scale;  ///< of panels and letters of a window; absent: the display's
  double time_s = 0.0;
  bool starts_paused = false;    ///< a window stands at time_s until it is let run
  std::filesystem::path output;  ///< one picture; empty: none
  Existing existing = Existing::keep;
  std::optional<Recording> recording;
  HighlightShow highlights = HighlightShow::shown;  ///< of pictures in files
  std::optional<ReferenceComparison> comparison;
  std::optional<TransferPath> transfer;
  std::string device;  ///< selector of ocl::select_device
  /// Checkout whose kernels and shaders are read instead of those built in; empty: none.
  std::filesystem::path sources;
  Verbosity verbosity = Verbosity::normal;
  Trust trust = Trust::trusted;  ///< in all scenes that are opened
};

/// From here on kernels and shaders are read from a checkout, as with OFFING_KERNEL_PATH and
/// OFFING_SHADER_PATH.
void use_sources(const std::filesystem::path& checkout);

/// Calls `visit` with the command line of offing-view, for a test that lists its options.
void visit_command_line(const std::function<void(const CLI::App&)>& visit);

/// Reads the command line; nothing if it asked for help or version, which are printed. Throws
/// Error(bad_usage) or what reading the scene throws.
std::optional<ViewOptions> read_view_options(int argc, const char* const* argv);

}  // namespace offing::present
