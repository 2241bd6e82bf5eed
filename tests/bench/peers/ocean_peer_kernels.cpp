// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/ocean_peer_kernels.h"

#ifdef __SSE__
#include <immintrin.h>
#endif

namespace offing::bench::peer {
namespace {

// Sixteen at once, by the compiler's vector types: one register of AVX-512, two of AVX2.
constexpr int width = 16;
using Floats = float __attribute__((vector_size(4 * width)));
using Words = std::uint32_t __attribute__((vector_size(4 * width)));
using SignedWords = std::int32_t __attribute__((vector_size(4 * width)));
// The same, at any address.
using UnalignedFloats = float __attribute__((vector_size(4 * width), aligned(4), may_alias));
using UnalignedWords = std::uint32_t __attribute__((vector_size(4 * width), aligned(4), may_alias));

// Lanes of two vectors, by place: 0 ... 15 in the first, 16 ... 31 in the second. Real and imaginary parts to
// complex numbers, forward and from the last to the first.
Floats low_halves(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}
Floats high_halves(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
}
Floats low_halves_reversed(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 15, 31, 14, 30, 13, 29, 12, 28, 11, 27, 10, 26, 9, 25, 8, 24);
}
Floats high_halves_reversed(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 7, 23, 6, 22, 5, 21, 4, 20, 3, 19, 2, 18, 1, 17, 0, 16);
}
// Complex numbers of two rows to pairs of them.
Floats low_pairs(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 0, 1, 16, 17, 2, 3, 18, 19, 4, 5, 20, 21, 6, 7, 22, 23);
}
Floats high_pairs(Floats a, Floats b) {
  return __builtin_shufflevector(a, b, 8, 9, 24, 25, 10, 11, 26, 27, 12, 13, 28, 29, 14, 15, 30, 31);
}

Floats load(const float* source) {
  return *reinterpret_cast<const UnalignedFloats*>(source);
}

void store(float* target, Floats values) {
  *reinterpret_cast<UnalignedFloats*>(target) = values;
}

/// Past the caches where the processor can; `target` is aligned to 64 bytes.
void stream(float* target, Floats values) {
#if defined(__AVX512F__)
  _mm512_stream_ps(target, reinterpret_cast<__m512>(values));
#elif defined(__SSE__)
  for (int part = 0; part < width; part += 4) {
    _mm_stream_ps(target + part, _mm_loadu_ps(reinterpret_cast<const float*>(&values) + part));
  }
#else
  store(target, values);
#endif
}

Floats reciprocal_root(Floats x) {
  Floats result;
#if defined(__AVX512F__)
  // 14 bits, and Newton's step for the rest. The masked form, because g++ 12 warns of the plain one's own
  // text.
  const Floats guess = reinterpret_cast<Floats>(_mm512_maskz_rsqrt14_ps(0xffff, reinterpret_cast<__m512>(x)));
  result = guess * (1.5f - 0.5f * x * guess * guess);
#else
  for (int lane = 0; lane < width; ++lane) result[lane] = 1.0f / __builtin_sqrtf(x[lane]);
#endif
  return result;
}

struct Wave {
  Floats cosine, sine;
};

/// The phase of whole and fractional ticks, modulo a turn; then the quadrant, and polynomials within an
/// eighth of a turn (Cephes' sinf, Moshier 1989).
Wave wave(Words rate, std::uint32_t ticks, float tick_fraction) {
  const Words fraction =
      __builtin_convertvector(__builtin_convertvector(rate, Floats) * tick_fraction, Words);
  const Words turns = rate * ticks + fraction;
  const Words quadrant = (turns + 0x20000000u) >> 30;
  constexpr float radians_per_unit = 1.4629180792671596e-9f;  // 2 pi / 2^32
  const Floats x = __builtin_convertvector(reinterpret_cast<SignedWords>(turns - (quadrant << 30)), Floats) *
                   radians_per_unit;
  const Floats z = x * x;
  const Floats s = x + x * z * ((-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f);
  const Floats c = 1.0f - 0.5f * z +
                   z * z * ((2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f);
  const auto is_odd = reinterpret_cast<SignedWords>(quadrant << 31) != 0;
  const Words cosine_sign = ((quadrant + 1u) & 2u) << 30, sine_sign = (quadrant & 2u) << 30;
  return {reinterpret_cast<Floats>(reinterpret_cast<Words>(is_odd ? s : c) ^ cosine_sign),
          reinterpret_cast<Floats>(reinterpret_cast<Words>(is_odd ? c : s) ^ sine_sign)};
}

void store_complex(float* target, Floats re, Floats im) {
  store(target, low_halves(re, im));
  store(target + width, high_halves(re, im));
}

/// Columns `column` ... `column` + 15 go to columns n - `column` - 15 ... n - `column`, where n is 0.
void store_reversed(float* row, int size, int column, Floats re, Floats im) {
  const Floats first = low_halves_reversed(re, im);
  const Floats second = high_halves_reversed(re, im);
  float* const target = row + static_cast<std::ptrdiff_t>(2) * (size - column - width + 1);
  store(target, first);
  if (column > 0) {
    store(target + width, second);
    return;
  }
  for (int i = 0; i < width - 2; ++i) target[width + i] = second[i];
  row[0] = second[width - 2];
  row[1] = second[width - 1];
}

}  // namespace

void evolve(const Frame& frame, const ModeRow& modes, float* row, float* mirrored, std::size_t field_floats) {
  const float kz = modes.kz_radpm, n = static_cast<float>(frame.size);
  Floats index{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  for (int column = 0; column < frame.size; column += width) {
    const Floats signed_index = index < n / 2.0f ? index : index - n;
    const Floats kx = signed_index * frame.wavenumber_step_radpm;
    index += static_cast<float>(width);

    const Words rate = *reinterpret_cast<const UnalignedWords*>(modes.rate + column);
    const Wave now = wave(rate, frame.ticks, frame.tick_fraction);
    const Floats re = load(modes.p_re + column) * now.cosine + load(modes.q_re + column) * now.sine;
    const Floats im = load(modes.p_im + column) * now.cosine + load(modes.q_im + column) * now.sine;
    // K = 0 meets an amplitude of zero.
    const Floats chop = frame.choppiness * reciprocal_root(kx * kx + (kz * kz + 1e-12f));
    const Floats x = kx * chop, z = kz * chop, xz = -kz * x, xx = -kx * x, zz = -kz * z;

    float* const target = row + static_cast<std::ptrdiff_t>(2) * column;
    store_complex(target, -(x + 1.0f) * im, (x + 1.0f) * re);
    store_complex(target + field_floats, -(z + xz) * im, (z + xz) * re);
    store_complex(target + 2 * field_floats, -kx * im - kz * re, kx * re - kz * im);
    store_complex(target + 3 * field_floats, xx * re - zz * im, xx * im + zz * re);
    if (mirrored == nullptr) continue;
    store_reversed(mirrored, frame.size, column, (1.0f - x) * im, (1.0f - x) * re);
    store_reversed(mirrored + field_floats, frame.size, column, (xz - z) * im, (xz - z) * re);
    store_reversed(mirrored + 2 * field_floats, frame.size, column, kz * re - kx * im, -kx * re - kz * im);
    store_reversed(mirrored + 3 * field_floats, frame.size, column, xx * re + zz * im, zz * re - xx * im);
  }
}

void pack(const float* first, const float* second, float* map, int size, Stores stores) {
  for (int i = 0; i < 2 * size; i += width) {
    const Floats a = load(first + i), b = load(second + i);
    const Floats low = low_pairs(a, b), high = high_pairs(a, b);
    float* const target = map + static_cast<std::ptrdiff_t>(2) * i;
    if (stores == Stores::streaming) {
      stream(target, low);
      stream(target + width, high);
    } else {
      store(target, low);
      store(target + width, high);
    }
  }
}

void finish_stores() {
#ifdef __SSE__
  _mm_sfence();
#endif
}

}  // namespace offing::bench::peer
