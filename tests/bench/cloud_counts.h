// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

namespace offing::bench {

/// Particles of the clouds that are measured: those of table C16 of docs/sources.md, of its paper's examples
/// (cirrus 108 and 128, stratus 193, cumulus 946, person 1,998, snowman 1,325, the letter K 1,321, others),
/// and up to a million.
inline constexpr int cloud_counts[] = {100,  108,  128,  193,  946,  1000,  1321,   1325,
                                       1998, 2000, 2449, 2568, 3000, 30000, 1000000};

/// Those whose frames the paper prints, and ten times the most of them: in pictures of its size.
inline constexpr int paper_cloud_counts[] = {100, 1000, 2000, 3000, 30000};

/// Of these the largest number that whole frames are measured with.
inline constexpr int most_drawn_particles = 30000;

}  // namespace offing::bench
