#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "host/ocl/device.h"
#include "host/ocl/float_view.h"
#include "present/gl/gl_context.h"
#include "present/gl/texture_array.h"

namespace offing::present {

/// The ways by which maps get from OpenCL to OpenGL, the best first.
enum class TransferRung {
  gl_sharing,      ///< the device copies into a buffer of OpenGL's (cl_khr_gl_sharing)
  mapped_pointer,  ///< the device computes in host memory: OpenGL reads it where it lies
  pbo_ring,        ///< reads that do not block, into buffers that OpenGL keeps mapped
  orphaned_pbo,    ///< blocking reads into buffers that OpenGL gives anew each time
  blocking_read,   ///< blocking reads into memory of our own: always possible
};
inline constexpr std::array all_transfer_rungs{TransferRung::gl_sharing, TransferRung::mapped_pointer,
                                               TransferRung::pbo_ring, TransferRung::orphaned_pbo,
                                               TransferRung::blocking_read};

/// "mapped-pointer", as --transfer takes it.
std::string_view to_string(TransferRung rung);
/// The rung of this name. Throws Error(bad_usage) that lists them.
TransferRung transfer_rung(std::string_view name);

/// A map of a simulation, and where it is to be drawn from.
struct Upload {
  ocl::FloatView source;
  const TextureArray* target = nullptr;
};

/// Takes maps from OpenCL to OpenGL by the best rung that both sides offer; a rung that fails gives way to
/// the next, with a warning.
class TransferLadder {
 public:
  /// Begins with `forced` if it is given, and then stays on it. Throws Error(bad_usage) if that rung cannot
  /// be used here.
  TransferLadder(const GlContext& context, const ocl::Device& device,
                 std::optional<TransferRung> forced = {});
  TransferLadder(TransferLadder&&) noexcept;
  TransferLadder& operator=(TransferLadder&&) noexcept;
  ~TransferLadder();

  TransferRung rung() const;

  /// Waits for the maps and fills the textures' finest levels. Throws Error(bad_usage) if the size of a map
  /// is not that of its texture, and what the last rung throws.
  void upload(std::span<const Upload> uploads);

  /// What one rung does.
  class Way;

 private:
  void climb_down(TransferRung from);

  bool is_forced_;
  GlCapabilities capabilities_;
  ocl::Device device_;
  TransferRung rung_;
  std::unique_ptr<Way> way_;
};

}  // namespace offing::present
