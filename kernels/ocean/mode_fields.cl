// What queries sum over the modes: seven complex fields of each mode at time t.
// In:  amplitude, rate, wavenumber_step_radpm as in ocean/spectrum_advance.cl; size n; time; choppiness a; k_max: waves beyond
//      it count as 0; the depth below the surface of the flow, and the water's depth.
// Out: fields [cascades][8][2][columns/16][n][16], real and imaginary, of which shared/query_params.h names seven. With h
//      and h' the height and its rate, all fields of the sea are these or their derivatives along x and z.
// Linear theory at z = -d under the surface, as in ocean/velocity_advance.cl. The acceleration is the derivative in time of
// the velocity at a rest label.
#include "ocean/wave_phase.clh"
#include "shared/mode_layout.h"
#include "shared/query_params.h"
#include "simd/lane_masks.clh"

#define STORE_FIELD(field, re, im)                         \
  store_lanes(re, target + (size_t)(2 * (field)) * plane); \
  store_lanes(im, target + (size_t)(2 * (field) + 1) * plane)

// e^{-k d}, without an exponential at the surface and in water that is deep for any wave of a patch.
INLINE lanes faded(lanes k, float distance_m) {
  if (distance_m == 0.0f) return (lanes)1.0f;
  return distance_m >= 1e6f ? (lanes)0.0f : exp(-k * distance_m);
}

__kernel void mode_fields(__global const float *restrict amplitude, __global const uint *restrict rate,
                          __global const float *restrict wavenumber_step_radpm, int columns, int size, uint ticks,
                          float tick_fraction, float choppiness, float k_max_radpm, int has_flow, float radps_per_rate,
                          float depth_below_surface_m, float water_depth_m, __global float *restrict fields) {
  const int batch = (int)get_global_id(1), place = (int)get_global_id(0) * LANES;
  const size_t plane = mode_plane_size(columns, size);
  const int row = place / MODE_BLOCK_COLUMNS % size;
  const int column = place / (MODE_BLOCK_COLUMNS * size) * MODE_BLOCK_COLUMNS + place % MODE_BLOCK_COLUMNS;
  const float step = wavenumber_step_radpm[batch], kz = (float)(row < size / 2 ? row : row - size) * step;
  const lanes kx = ((float)column + LANE_INDEX) * step;
  // K = 0 gets a small value, which meets an amplitude of 0.
  const lanes k = sqrt(fmax(kx * kx + kz * kz, (lanes)1e-12f)), inverse_k = 1.0f / k;
  const uint_lanes rates = load_uint_lanes(rate + (size_t)batch * plane + place);
  lanes cosine, sine;
  wave_phase(rates, ticks, tick_fraction, &cosine, &sine);
  const lanes counted = select((lanes)1.0f, (lanes)0.0f, mask_of(k > k_max_radpm));
  cosine *= counted;
  sine *= counted;
  __global const float *source = amplitude + (size_t)batch * 4 * plane + place;
  __global float *target = fields + (size_t)batch * 2 * QUERY_FIELDS * plane + place;
  const lanes p_re = load_lanes(source), p_im = load_lanes(source + plane);
  const lanes q_re = load_lanes(source + 2 * plane), q_im = load_lanes(source + 3 * plane);
  const lanes height_re = p_re * cosine + q_re * sine, height_im = p_im * cosine + q_im * sine;
  const lanes chop = choppiness * inverse_k;
  STORE_FIELD(QUERY_SHIFT, chop * height_re, chop * height_im);
  STORE_FIELD(QUERY_HEIGHT, height_re, height_im);
  if (!has_flow) return;
  const lanes omega = convert_lanes(rates) * radps_per_rate;
  const lanes rise_re = omega * (q_re * cosine - p_re * sine), rise_im = omega * (q_im * cosine - p_im * sine);
  const lanes above_bed = faded(k, 2.0f * fmax(water_depth_m - depth_below_surface_m, 0.0f));
  const lanes at_bed = faded(k, 2.0f * water_depth_m), attenuation = faded(k, depth_below_surface_m);
  const lanes decay = attenuation / fmax(1.0f - at_bed, (lanes)1e-6f);
  const lanes vertical = decay * (1.0f - above_bed), horizontal = decay * (1.0f + above_bed) * inverse_k;
  const lanes head = attenuation * (1.0f + above_bed) / (1.0f + at_bed), against = -omega * omega;
  STORE_FIELD(QUERY_RISE, vertical * rise_re, vertical * rise_im);
  STORE_FIELD(QUERY_HEAD, head * height_re, head * height_im);
  STORE_FIELD(QUERY_FLOW, horizontal * rise_re, horizontal * rise_im);
  STORE_FIELD(QUERY_FLOW_RATE, against * horizontal * height_re, against * horizontal * height_im);
  STORE_FIELD(QUERY_RISE_RATE, against * vertical * height_re, against * vertical * height_im);
}
