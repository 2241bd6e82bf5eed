// What the eye sees of each particle: light that it scatters toward the eye. The radiance L that would leave the cloud
// at a particle, of all that lies behind it in the delta-scaled medium, is carried along the line of sight through the
// grid; since billboards extinguish with the true depth, they must shine with S = f w L + A for their sum to be L in
// front, where A = w P E B + glow (1 + drift . v): light of the suns scattered toward the eye, with the phase P of the
// whole way (phase tables), and often scattered light.
// In:  particles [count], grids, looks, light, phases, beams, glow, drift; the eye.
// Out: sprites [count].
#include "clouds/chord.clh"
#include "clouds/light_grid.clh"
#include "clouds/phase.clh"

// Where a particle of depth t shows from: FRONT_RADII t / (t + FRONT_DEPTH) radii before its middle.
#define FRONT_RADII 1.4f
#define FRONT_DEPTH 3.0f

// Steps behind and before a particle.
#define STEPS_BEHIND 6
#define STEPS_BEFORE 2

// Distance to the box's side along a line in cells.
static inline float way_out(const CloudGrid grid, float3 cells, float3 step) {
  const float3 wall = select((float3)(0.0f), grid_size(grid), step > 0.0f);
  const float3 safe = select(step, (float3)(1e-20f), fabs(step) < 1e-20f);
  const float3 ways = (wall - cells) / safe;
  return fmax(0.0f, fmin(ways.x, fmin(ways.y, ways.z)));
}

__kernel void particle_scatter(__global const CloudParticle *restrict particles, int count, int particles_per_item,
                               __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                               const CloudLightParams light, __global const float *restrict phases,
                               __global const float *restrict beams, __global const float4 *restrict glow,
                               __global const float4 *restrict drift, float eye_x, float eye_y, float eye_z,
                               __global CloudSprite *restrict sprites) {
  const int end = min(((int)get_global_id(0) + 1) * particles_per_item, count);
  for (int i = (int)get_global_id(0) * particles_per_item; i < end; ++i) {
    const CloudParticle particle = particles[i];
    const uint cloud = particle.cloud;
    const CloudGrid grid = grids[cloud];
    const CloudScattering look = looks[cloud];
    __global const float *beam = beams + FIRST_BEAM + (size_t)cloud * CLOUD_SUNS * CELLS;
    __global const float4 *shine = glow + (size_t)cloud * CELLS;
    __global const float4 *lean = drift + (size_t)cloud * CELLS;
    const float depth = particle.optical_mass / (CLOUD_BALL_MASS * particle.radius * particle.radius);
    const float3 place = (float3)(particle.x, particle.y, particle.z);
    const float3 way = (float3)(eye_x, eye_y, eye_z) - place;
    const float distance = length(way);
    const float3 view = distance > 0.0f ? way / distance : (float3)(0.0f, 1.0f, 0.0f);
    // Of a dense particle only the side toward the eye shows.
    const float forward = fmin(particle.radius * FRONT_RADII * depth / (depth + FRONT_DEPTH), distance);
    const float3 step = view / grid_cell(grid);  // cells a metre
    const float3 start = cells_at(grid, place + forward * view);
    const float3 speeds = fabs(step);
    const float cell_way = 1.0f / fmax(speeds.x, fmax(speeds.y, speeds.z));

    float angle_places[CLOUD_SUNS];
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudSunLight from = light.suns[sun];
      angle_places[sun] = phase_angle_place(-(from.x * view.x + from.y * view.y + from.z * view.z));
    }
    float before = 0.0f;
    const float way_before = fmin(way_out(grid, start, step), distance - forward) / (float)STEPS_BEFORE;
    for (int k = 0; k < STEPS_BEFORE; ++k)
      before += way_before * sample_vector(shine, grid_sample(grid, start + ((float)k + 0.5f) * way_before * step)).w;

    const float scaled = 1.0f - forward_albedo(look);
    const float leave = way_out(grid, start, -step);
    float4 behind = (float4)(0.0f), here = (float4)(0.0f), last = (float4)(0.0f);
    float rough = 0.0f, share = 1.0f, depth_before = before, at = 0.0f;
    // Step -1 is the particle itself, which shines but does not dim.
    for (int k = -1; k < STEPS_BEHIND; ++k) {
      const float3 look_at = start - at * step;
      const float length_m = k < 0 ? 0.0f : fmin(fmax(0.5f / fmax(rough * scaled, 1e-20f), cell_way), fmax(2.0f * cell_way, leave * 0.25f));
      const float piece = fmin(length_m, leave - at);
      const GridSample sample = grid_sample(grid, look_at - 0.5f * piece * step);
      const float4 found = sample_vector(shine, sample);
      rough = found.w;
      const float3 leaning = sample_vector(lean, sample).xyz;
      float4 shown = found * fmax(0.0f, 1.0f + dot(leaning, view));
      for (int sun = 0; sun < light.sun_count; ++sun) {
        const CloudSunLight from = light.suns[sun];
        const float lit = sample_scalar(beam + sun * CELLS, sample);
        const float depth_of_way = depth_before + 0.5f * piece * found.w - log(fmax(lit, 1e-30f)) / scaled;
        shown += look.albedo_green * phase_at(phases, look.phase_table, angle_places[sun], depth_of_way) * lit *
                 (float4)(from.red, from.green, from.blue, 0.0f);
      }
      last = shown;
      if (k < 0) {
        here = shown;
        continue;
      }
      const float kept = exp(-found.w * scaled * piece);
      behind += share * (1.0f - kept) / scaled * shown;
      share *= kept;
      depth_before += piece * found.w;
      at += piece;
      if (at >= leave || share < 0.02f) break;
    }
    const float4 sky = view.y < 0.0f ? (float4)(light.sky_red, light.sky_green, light.sky_blue, 0.0f)
                                     : (float4)(light.ground_red, light.ground_green, light.ground_blue, 0.0f);
    behind += share * (at < leave ? last / scaled : sky);
    const float4 seen = forward_albedo(look) * behind + here;
    // The grid has the albedo of the cloud as a whole.
    const CloudSprite sprite = {seen.x * particle.red / fmax(look.albedo_red, 1e-6f),
                                seen.y * particle.green / fmax(look.albedo_green, 1e-6f),
                                seen.z * particle.blue / fmax(look.albedo_blue, 1e-6f), depth};
    sprites[i] = sprite;
  }
}
