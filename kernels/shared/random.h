// Counter-based random numbers, the same on host and device.
// Philox 4x32-10: Salmon, Moraes, Dror, Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3".
// A number depends on nothing but (seed, stream, n, m, index): not on device, work-group shape or resolution.
#ifndef OFFING_KERNELS_SHARED_RANDOM_H
#define OFFING_KERNELS_SHARED_RANDOM_H

#ifdef __OPENCL_VERSION__
#define OFFING_RANDOM_INLINE static inline
typedef uint offing_uint32;
typedef ulong offing_uint64;
#else
#include <cstdint>
#define OFFING_RANDOM_INLINE inline
typedef std::uint32_t offing_uint32;
typedef std::uint64_t offing_uint64;
#pragma GCC diagnostic push  // only the C form of a cast means the same to both compilers
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

// Streams: one for each consumer, so that adding a consumer changes no other's numbers.
// Ocean cascade i uses OFFING_STREAM_OCEAN_CASCADE + i, i < 4.
#define OFFING_STREAM_OCEAN_CASCADE 0x0cea0000u
#define OFFING_STREAM_OCEAN_GERSTNER 0x0cea0100u
#define OFFING_STREAM_OCEAN_SWASH 0x0cea0102u
// Rain on a wake window: n and m are a square of the world, index the step.
#define OFFING_STREAM_WAKE_RAIN 0x0cea0101u
// Terrain: n and m are a lattice point, index its octave.
#define OFFING_STREAM_TERRAIN_FRACTAL 0x7e110000u
// Terrain: n and m are a cell, index the gullies of one width.
#define OFFING_STREAM_TERRAIN_GULLIES 0x7e110001u
// Made shapes: n is a vertex or a cell, m what is drawn for it.
#define OFFING_STREAM_SHAPES 0x5a9e0000u
// Billboard textures of clouds: n and m are a lattice point, index the octave of a texture.
#define OFFING_STREAM_CLOUD_BILLBOARDS 0xb2000000u
// Noise of clouds: n, m and index are a lattice point; bits 24 ... 27 are the octave, those below the layer
// of the fourth dimension (kernels/clouds/noise_lattice.clh). All from 0xc0000000u to 0xcfffffffu are taken.
#define OFFING_STREAM_CLOUD_NOISE 0xc0000000u
// Shifts of the noise's octaves: n is the octave.
#define OFFING_STREAM_CLOUD_OCTAVES 0xb1000000u
// Light traced through clouds: n and m are the low and high word of the path's number.
#define OFFING_STREAM_CLOUD_PATHS 0xb3000000u
// Lumps of marched clouds: n is a lattice point, m its octave.
#define OFFING_STREAM_CLOUD_LUMPS 0xb4000000u
// Growing hierarchies: n is the parent, m its level, index counts what is drawn.
#define OFFING_STREAM_CLOUD_HIERARCHY 0xb1000001u
// Particles: n is what is drawn, index the particle's id.
#define OFFING_STREAM_CLOUD_PARTICLES 0xb1000002u
// Layouts of clouds: n is the genus or the cloud of a sky, index counts what is drawn.
#define OFFING_STREAM_CLOUD_LAYOUT 0xb1000003u
#define OFFING_STREAM_CLOUD_SKY 0xb1000004u
// Merging samples of clouds: n, m and index are a block, counted from the lowest one.
#define OFFING_STREAM_CLOUD_MERGING 0xb1000005u

// Four words of a counter, or of random bits.
typedef struct {
  offing_uint32 v[4];
} PhiloxBlock;

// Four words for one 128-bit counter and one 64-bit key (low word, high word).
OFFING_RANDOM_INLINE PhiloxBlock philox_4x32_10(PhiloxBlock counter, offing_uint32 key_low,
                                                offing_uint32 key_high) {
  for (int round = 0; round < 10; ++round) {
    const offing_uint64 a = (offing_uint64)0xD2511F53u * counter.v[0];
    const offing_uint64 b = (offing_uint64)0xCD9E8D57u * counter.v[2];
    PhiloxBlock next;
    next.v[0] = (offing_uint32)(b >> 32) ^ counter.v[1] ^ key_low;
    next.v[1] = (offing_uint32)b;
    next.v[2] = (offing_uint32)(a >> 32) ^ counter.v[3] ^ key_high;
    next.v[3] = (offing_uint32)a;
    counter = next;
    key_low += 0x9E3779B9u;   // golden ratio
    key_high += 0xBB67AE85u;  // sqrt(3) - 1
  }
  return counter;
}

// The block of (stream, n, m, index) under a 64-bit seed.
OFFING_RANDOM_INLINE PhiloxBlock philox_block(offing_uint32 seed_low, offing_uint32 seed_high,
                                              offing_uint32 stream, int n, int m, offing_uint32 index) {
  PhiloxBlock counter;
  counter.v[0] = stream;
  counter.v[1] = (offing_uint32)n;
  counter.v[2] = (offing_uint32)m;
  counter.v[3] = index;
  return philox_4x32_10(counter, seed_low, seed_high);
}

// Uniform in (0, 1): the 23 high bits, centred in their cell, so that neither 0 nor 1 appears.
OFFING_RANDOM_INLINE float uniform_open01(offing_uint32 word) {
  return ((float)(word >> 9) + 0.5f) * (1.0f / 8388608.0f);
}

#ifndef __OPENCL_VERSION__
#pragma GCC diagnostic pop
static_assert(sizeof(PhiloxBlock) == 16, "no padding");
#endif

#endif
