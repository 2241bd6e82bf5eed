#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/ocl/device.h"
#include "host/ocl/kernel.h"

namespace offing::ocl {

/// -D values of a build, in order: {"SIZE", "512"} becomes -DSIZE=512. A value is part of the cache key.
class Defines {
 public:
  Defines& set(std::string name, std::string value);
  Defines& set(std::string name, long long value);
  Defines& set_flag(std::string name) { return set(std::move(name), std::string("1")); }
  const std::vector<std::pair<std::string, std::string>>& values() const { return values_; }

 private:
  std::vector<std::pair<std::string, std::string>> values_;
};

/// A compiled OpenCL program.
///
/// Its source is an embedded file (kernels/...) in which each `#include "path/below/kernels"` is replaced by
/// that file, with `#line` so that compiler messages name the true file and line. OFFING_KERNEL_PATH names a
/// folder whose files replace the embedded ones of the same name. Binaries are cached under
/// $OFFING_CACHE_DIR, else $XDG_CACHE_HOME/offing, else
/// ~/.cache/offing; a damaged or foreign cache entry is rebuilt, never fatal; OFFING_CACHE_DIR= (empty) turns
/// it off.
class Program {
 public:
  /// Builds `source_name`, such as "ocean/spectrum_advance.cl"; the same text with the same definitions once
  /// a device. Throws Error(build_failed) with the compiler's log.
  static Program build(const Device& device, std::string_view source_name, const Defines& defines = {});

  /// Throws Error(build_failed) if the program has no kernel of that name.
  Kernel kernel(std::string_view name) const;

 private:
  struct State;
  explicit Program(std::shared_ptr<State> state);
  std::shared_ptr<State> state_;
};

}  // namespace offing::ocl
