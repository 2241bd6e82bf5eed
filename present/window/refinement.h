#pragma once

#include <cstdint>
#include <optional>

#include "host/base/camera.h"
#include "host/scene/model/scene.h"
#include "present/passes/frame_request.h"

namespace offing::present {

/// All that a window's picture depends on.
struct ShownView {
  double time_s = 0.0;  ///< 0 in a scene that looks the same at any time
  Camera camera;        ///< as large as the picture in full
  std::uint64_t scene_revision = 0;
  WaterShow debug = WaterShow::none;
  Fill fill = Fill::solid;
  TerrainShow terrain = TerrainShow::light;
  MeshShow meshes = MeshShow::light;
  double ray_share = 1.0;  ///< of pixels, that the user asks for

  bool operator==(const ShownView& other) const;
};

/// Whether a scene looks otherwise as time goes by, if its camera stands.
bool moves_by_itself(const scene::Scene& scene);

/// How sharply a window draws a view.
enum class Sharpness {
  quick,  ///< as a moving view
  fine,   ///< with all that a moving view leaves out to keep a frame rate
  still,  ///< as a picture in a file
};

/// Chooses the picture that a window draws next: a quick one of each other view, sharper ones of a view that
/// stays, and at last none.
class Refinement {
 public:
  /// A view stays if it has not changed for so long: less often than hands that move it.
  static constexpr double settled_s = 0.15;

  /// The next picture of this view; nothing where none is due. `input_s`: when the last input came.
  std::optional<Sharpness> next(const ShownView& view, double now_s, double input_s) const;
  /// A picture of a view was drawn.
  void note(const ShownView& view, Sharpness drawn, double now_s);
  /// The next picture is quick, as for another view.
  void forget() { view_.reset(); }
  /// Whether nothing of this view is left to draw.
  bool is_complete(const ShownView& view) const { return view_ == view && drawn_ == Sharpness::still; }

 private:
  std::optional<ShownView> view_;  // that was drawn last
  Sharpness drawn_ = Sharpness::quick;
  double since_s_ = 0.0;  // when it was first drawn
};

}  // namespace offing::present
