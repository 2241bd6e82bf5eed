#pragma once

#include <memory>
#include <optional>
#include <string>

namespace offing::test {

/// A display server without a display (Xvfb), which DISPLAY names while this object lives; ends with it.
class VirtualDisplay {
 public:
  static constexpr const char* usual_screen = "1280x1024x24";
  /// `screen` is WIDTHxHEIGHTxDEPTH. Nothing, with the reason, where Xvfb is not installed; throws where it
  /// does not start.
  static std::unique_ptr<VirtualDisplay> start(std::string& reason, const std::string& screen = usual_screen);
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;
  ~VirtualDisplay();

 private:
  VirtualDisplay() = default;
  int process_ = -1;
};

}  // namespace offing::test
