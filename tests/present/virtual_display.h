#pragma once

#include <memory>
#include <optional>
#include <string>

namespace offing::test {

/// A display server without a display (Xvfb), which DISPLAY names while this object lives; ends with it.
class VirtualDisplay {
 public:
  /// Nothing, with the reason, where Xvfb is not installed. Throws where it does not start.
  static std::unique_ptr<VirtualDisplay> start(std::string& reason);
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  ~VirtualDisplay();

 private:
  VirtualDisplay() = default;
  int process_ = -1;
};

}  // namespace offing::test
