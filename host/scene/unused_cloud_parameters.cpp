#include "host/scene/unused_cloud_parameters.h"

namespace offing::scene {

std::string against_cloud(const CloudScene& cloud, ParameterUse use) {
  const CloudShapeScene& shape = cloud.shape;
  switch (use) {
    case ParameterUse::filed_cloud:
      return shape.file.empty() ? "cloud.file is not given" : "";
    case ParameterUse::shaped_cloud:
      return shape.mesh.empty() && shape.text.empty() && shape.solid == CloudSolid::none
                 ? "none of cloud.mesh, cloud.text and cloud.shape is given"
                 : "";
    case ParameterUse::text_cloud:
      return shape.text.empty() ? "cloud.text is not given" : "";
    case ParameterUse::heated_cloud:
      return cloud.motion.heat_k ? "" : "cloud.heat_k is not given";
    case ParameterUse::obstructed_cloud:
      return cloud.motion.obstacle_m ? "" : "cloud.obstacle_m is not given";
    default:
      return "";
  }
}

}  // namespace offing::scene
