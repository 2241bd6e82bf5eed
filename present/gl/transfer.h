#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "present/gl/gl_context.h"
#include "present/gl/texture_array.h"

namespace offing::present {

/// The ways by which maps get from OpenCL to OpenGL, the best first.
enum class TransferPath {
  gl_sharing,      ///< the device copies into a buffer of OpenGL's (cl_khr_gl_sharing)
  mapped_pointer,  ///< the device computes in host memory: OpenGL reads it where it lies
  pbo_ring,        ///< reads that do not block, into buffers that OpenGL keeps mapped
  orphaned_pbo,    ///< blocking reads into buffers that OpenGL gives anew each time
  blocking_read,   ///< blocking reads into memory of our own: always possible
};
inline constexpr std::array all_transfer_paths{TransferPath::gl_sharing, TransferPath::mapped_pointer,
                                               TransferPath::pbo_ring, TransferPath::orphaned_pbo,
                                               TransferPath::blocking_read};

/// "mapped-pointer", as --transfer takes it.
std::string_view to_string(TransferPath path);

/// A map of a simulation, and where it is to be drawn from.
struct Upload {
  ocl::FloatSpan source;
  const TextureArray* target = nullptr;
};

/// Takes maps from OpenCL to OpenGL by the best transfer path that both sides offer; a transfer path that
/// fails gives way to the next, with a warning.
class Transfer {
 public:
  /// Begins with `forced` if it is given, and then stays on it. Throws Error(bad_usage) if that transfer path
  /// cannot be used here.
  Transfer(const GlContext& context, const ocl::Device& device, std::optional<TransferPath> forced = {});
  Transfer(Transfer&&) noexcept;
  Transfer& operator=(Transfer&&) noexcept;
  ~Transfer();

  TransferPath path() const;

  /// Waits for the maps and fills the textures, all their levels. Throws Error(bad_usage) if the size of a map
  /// is not that of its texture, and what the last transfer path throws.
  void upload(std::span<const Upload> uploads);

  /// What one transfer path does.
  class Way;

 private:
  void climb_down(TransferPath from);

  bool is_forced_;
  GlCapabilities capabilities_;
  ocl::Device device_;
  TransferPath path_;
  std::unique_ptr<Way> way_;
};

}  // namespace offing::present
