#include "host/sky/clear_sky_glsl.h"

#include "host/ocl/glsl_source.h"

namespace offing::sky {

std::string clear_sky_glsl() {
  return ocl::glsl_source("sky/clear_sky.clh");
}

}  // namespace offing::sky
