#include "host/scene/file/version.h"

namespace offing::scene {

std::string_view version() {
  return OFFING_VERSION;
}

}  // namespace offing::scene
