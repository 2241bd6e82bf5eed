#pragma once

#include "host/io/text/text_mesh.h"

namespace offing::text {

/// The functions of the module `cairo`.
struct CairoModule {
  decltype(&offing::text_mesh) text_mesh;
};

}  // namespace offing::text
