// Multiple forward scattering as Harris & Lastra 2001, "Real-time cloud rendering", have it (C10): light goes from particle
// to particle in light order; each takes from what passes through it, a share e^-t + w t p(0) G / (4 pi) being left, t its
// depth there, p(0) the phase function straight ahead and G = pi / 32 the solid angle of the forward cone. Kept as sums of
// -ln of shares over a map across the light. Particles of a group do not shade each other.
// In:    particles [count] and their order along the light, grids [clouds], looks [clouds], phases; (x, y, z) toward the sun.
// Inout: map [CLOUD_HARRIS_SIZE][CLOUD_HARRIS_SIZE], units of 1 / 65536, zero at first.
// Out:   reached [count]: share of the sun's light that reaches each particle.
// One work-group of GROUP_SIZE.
#include "clouds/chord.clh"
#include "clouds/light_grid.clh"

#define PARTICLES_OF_GROUP 64
#define UNITS 65536.0f
// No more is added to a sum that is larger: nothing comes through e^-8192, and the particles of a group, 64 of at most
// 64 each, add 2^28.
#define ENOUGH (1 << 29)

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void light_recurrence(
    __global const CloudParticle *restrict particles, int count, __global const uint *restrict order,
    __global const CloudGrid *restrict grids, int clouds, __global const CloudScattering *restrict looks,
    __global const float *restrict phases, float x, float y, float z, __global int *restrict map,
    __global float *restrict reached) {
  const int item = (int)get_local_id(0);
  // A square around all clouds, across the light.
  float3 low = (float3)(FLT_MAX), high = (float3)(-FLT_MAX);
  for (int i = 0; i < clouds; ++i) {
    const float3 corner = (float3)(grids[i].low_x, grids[i].low_y, grids[i].low_z);
    low = fmin(low, corner);
    high = fmax(high, corner + grid_size(grids[i]) * grid_cell(grids[i]));
  }
  const float3 sun = (float3)(x, y, z), middle = 0.5f * (low + high);
  const float texel = fmax(length(high - low) / (float)CLOUD_HARRIS_SIZE, 1e-6f);
  const float3 right = axis_across(sun);
  const float3 up = cross(sun, right);
  for (int i = item; i < CLOUD_HARRIS_SIZE * CLOUD_HARRIS_SIZE; i += GROUP_SIZE) map[i] = 0;
  barrier(CLK_GLOBAL_MEM_FENCE);
  for (int first = 0; first < count; first += PARTICLES_OF_GROUP) {
    const int end = min(first + PARTICLES_OF_GROUP, count);
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = first + item; i < end; i += GROUP_SIZE) {
        const CloudParticle particle = particles[order[i]];
        const float3 from = (float3)(particle.x, particle.y, particle.z) - middle;
        const float at_x = dot(from, right) / texel + 0.5f * (float)CLOUD_HARRIS_SIZE;
        const float at_y = dot(from, up) / texel + 0.5f * (float)CLOUD_HARRIS_SIZE;
        const bool is_inside =
            at_x >= 0.0f && at_y >= 0.0f && at_x < (float)CLOUD_HARRIS_SIZE && at_y < (float)CLOUD_HARRIS_SIZE;
        if (pass == 0) {
          reached[order[i]] = is_inside ? exp((float)-map[(int)at_y * CLOUD_HARRIS_SIZE + (int)at_x] / UNITS) : 1.0f;
          continue;
        }
        if (!is_inside || !isfinite(particle.optical_mass)) continue;
        const CloudScattering look = looks[particle.cloud];
        const float ahead = phases[(size_t)look.phase_table * CLOUD_PHASE_DEPTHS * CLOUD_PHASE_ANGLES];
        const float albedo = (particle.red + particle.green + particle.blue) / 3.0f;
        const float regained = fmin(1.0f, albedo * ahead * SKY_PI / 32.0f);
        const float radius = fmax(particle.radius / texel, 0.7f);
        const float depth = cloud_depth(particle.optical_mass, radius * texel);
        const int first_row = max((int)(at_y - radius), 0), first_column = max((int)(at_x - radius), 0);
        const int last_row = min((int)(at_y + radius), CLOUD_HARRIS_SIZE - 1);
        const int last_column = min((int)(at_x + radius), CLOUD_HARRIS_SIZE - 1);
        for (int row = first_row; row <= last_row; ++row) {
          for (int column = first_column; column <= last_column; ++column) {
            const float dx = ((float)column + 0.5f - at_x) / radius, dy = ((float)row + 0.5f - at_y) / radius;
            const float here = depth * cloud_chord(dx * dx + dy * dy);
            __global int *sum = map + row * CLOUD_HARRIS_SIZE + column;
            // Read by what changes nothing: others of the group may be adding.
            if (!(here > 0.0f) || atomic_or(sum, 0) > ENOUGH) continue;
            // A deep particle is a row of thin slices: what the print has for one slice would make light of a deep one.
            const float slices = ceil(here * 8.0f), thin = here / slices;
            const float kept = slices * -log(exp(-thin) + regained * thin);
            atomic_add(sum, (int)(fmin(kept, 64.0f) * UNITS));
          }
        }
      }
      barrier(CLK_GLOBAL_MEM_FENCE);
    }
  }
}
