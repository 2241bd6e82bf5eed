#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/base/rgba_image.h"
#include "kernels/shared/clouds.h"

namespace offing::clouds {

/// The two sets of CLOUD_TEXTURES billboard textures each (C8): what a particle of a cloud looks like. The
/// first is crisp as a cauliflower, for heaps; the second soft and wispy, for sheets and streaks.
///
/// A texture does not say how opaque a billboard is, but how that is spread over the texels that are equally
/// far from its middle, so that billboards agree in the mean with the density they stand for: of texels where
/// the analytic opacity is a = 1 - exp(-tau), it makes a pattern of mean a. A texel is four bytes, from the
/// lowest one: how far its surface turns to the right and upward (0 ... 255 for -1 ... 1), and its opacity
/// where the mean is 1/3 and where it is 2/3 (0 ... 255 for 0 ... 1); between these, 0 and 1 opacities are
/// linear in the mean. All of it may be filtered, in mip levels too, and keeps its means.
struct BillboardTextures {
  /// [2 CLOUD_TEXTURES][texels of all levels], each level [size][size] row-major from the largest to the
  /// smallest, row 0 at the bottom. The ball of a particle fills the square.
  std::vector<std::uint32_t> texels;
};

/// The sets that Offing draws itself, of Philox noise: the same on every machine.
BillboardTextures billboard_textures();

/// Puts pictures of an artist's own in the place of a set (0 or 1), in their order. Where a picture is bright
/// and opaque the billboard is dense; its colours are those of its light. Pictures of another size than
/// CLOUD_TEXTURE_SIZE are fitted to it. Throws Error(bad_input) unless there are CLOUD_TEXTURES pictures with
/// texels.
void replace_billboards(BillboardTextures& textures, int set, std::span<const RgbaImage> pictures);

}  // namespace offing::clouds
