#pragma once

#include <span>
#include <string_view>

namespace offing::kernels {

/// One file under kernels/, embedded at build.
struct KernelSource {
  std::string_view name;  ///< path below kernels/, such as "ocean/spectrum_advance.cl"
  std::string_view text;  ///< the file, unchanged
};

/// Every embedded file: kernels (.cl), what they include (.clh) and headers shared with the host
/// (shared/*.h).
std::span<const KernelSource> kernel_sources();

}  // namespace offing::kernels
