// What the eye sees of each particle: light that it scatters toward the eye. The radiance L that would leave the cloud
// at a particle, of all that lies behind it in the delta-scaled medium, is carried along the line of sight through the
// grid; since billboards extinguish with the true depth, they must shine with S = f w L + A for their sum to be L in
// front, where A = w (P E B + glow (1 + drift . v)): light of the suns scattered toward the eye, with the phase P of the
// whole way (phase tables), and often scattered light. The albedo w is the particle's own, behind it that of the cells.
// In:  particles [end], grids, looks, lights, phases, medium, absorption, beams, glow, drift; the eye.
// Out: sprites [first ... end - 1].
#include "clouds/chord.clh"
#include "clouds/light_grid.clh"
#include "clouds/phase.clh"

// Where a particle of depth t shows from: FRONT_RADII t / (t + FRONT_DEPTH) radii before its middle.
#define FRONT_RADII 1.3f
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

// The albedo of each colour at a place of the grid.
static inline float3 albedo_at(const CloudGrid grid, __global const float *restrict absorbing, int channels, const CloudScattering look,
                               const GridSample sample, float extinction) {
  if (channels == 1) return (float3)(1.0f - look.absorbed_share);
  const float3 absorption =
      (float3)(sample_scalar(absorbing, sample), sample_scalar(absorbing + MEDIUM_CELLS(grid), sample),
               sample_scalar(absorbing + 2 * MEDIUM_CELLS(grid), sample));
  return clamp(1.0f - absorption / fmax(extinction, 1e-30f), (float3)(0.0f), (float3)(1.0f));
}

// Red, green and blue of what each channel has.
static inline float3 of_colours(const float *values, int channels) {
  return channels == 1 ? (float3)(values[0]) : (float3)(values[0], values[1], values[2]);
}

__kernel void particle_scatter(__global const CloudParticle *restrict particles, int first, int end, int particles_per_item,
                               __global const CloudGrid *restrict grids, __global const CloudScattering *restrict looks,
                               __global const CloudLightParams *restrict lights, __global const float *restrict phases,
                               __global const float *restrict absorption, __global const float *restrict beams,
                               __global const float4 *restrict glow, __global const float4 *restrict drift, int channels,
                               float eye_x_m, float eye_y_m, float eye_z_m, __global CloudSprite *restrict sprites) {
  const int own = first + (int)get_global_id(0) * particles_per_item, own_end = min(own + particles_per_item, end);
  for (int i = own; i < own_end; ++i) {
    const CloudParticle particle = particles[i];
    const size_t cloud = particle.cloud;
    const CloudGrid grid = grids[cloud];
    const CloudScattering look = looks[cloud];
    __global const CloudLightParams *light = lights + cloud;
    __global const float *absorbing = absorption + cloud * channels * MEDIUM_CELLS(grid) + FIRST_LEVEL(grid);
    __global const float *beam = beams + CLOUD_BEAM_MARGIN + cloud * light->sun_count * channels * grid.room;
    __global const float4 *shine = glow + cloud * grid.room;
    __global const float4 *lean = drift + cloud * channels * grid.room;
    const float depth = cloud_depth(particle.optical_mass, particle.radius);
    const float3 place = (float3)(particle.x, particle.y, particle.z);
    const float3 own_albedo = (float3)(particle.red, particle.green, particle.blue);
    const float3 way = (float3)(eye_x_m, eye_y_m, eye_z_m) - place;
    const float distance = length(way);
    const float3 view = distance > 0.0f ? way / distance : (float3)(0.0f, 1.0f, 0.0f);
    // Of a dense particle only the side toward the eye shows.
    const float forward = fmin(particle.radius * FRONT_RADII * depth / (depth + FRONT_DEPTH), distance);
    const float3 step = view / grid_cell(grid);  // cells a metre
    const float3 start = cells_at(grid, place + forward * view);
    const float3 speeds = fabs(step);
    const float cell_way = 1.0f / fmax(speeds.x, fmax(speeds.y, speeds.z));

    float angle_places[CLOUD_SUNS];
    for (int sun = 0; sun < light->sun_count; ++sun) {
      const CloudLightSource from = light->suns[sun];
      angle_places[sun] = phase_angle_place(-(from.x * view.x + from.y * view.y + from.z * view.z));
    }
    float before = 0.0f;
    const float way_before = fmin(way_out(grid, start, step), distance - forward) / (float)STEPS_BEFORE;
    for (int k = 0; k < STEPS_BEFORE; ++k)
      before += way_before * sample_vector(shine, grid_sample(grid, start + ((float)k + 0.5f) * way_before * step)).w;

    const float leave = way_out(grid, start, -step);
    float3 behind = (float3)(0.0f), here = behind, last = behind, share = (float3)(1.0f);
    float rough = 0.0f, depth_before = before, at = 0.0f;  // rough: greatest extinction in the scaled medium
    // Step -1 is the particle itself, which shines but does not dim.
    for (int k = -1; k < STEPS_BEHIND; ++k) {
      const float3 look_at = start - at * step;
      const float length_m = k < 0 ? 0.0f : fmin(fmax(0.5f / fmax(rough, 1e-20f), cell_way), fmax(2.0f * cell_way, leave * 0.25f));
      const float piece = fmin(length_m, leave - at);
      const GridSample sample = grid_sample(grid, look_at - 0.5f * piece * step);
      const float4 found = sample_vector(shine, sample);
      const float3 albedo = albedo_at(grid, absorbing, channels, look, sample, found.w);
      // Of the true extinction.
      const float3 scaled = 1.0f - look.forward_share * albedo;
      rough = found.w * fmax(scaled.x, fmax(scaled.y, scaled.z));
      float toward_eye[3];
      for (int channel = 0; channel < channels; ++channel)
        toward_eye[channel] = fmax(0.0f, 1.0f + dot(sample_vector(lean + channel * grid.room, sample).xyz, view));
      float3 shown = found.xyz * of_colours(toward_eye, channels);
      const float depth_of_eye = depth_before + 0.5f * piece * found.w;
      for (int sun = 0; sun < light->sun_count; ++sun) {
        const CloudLightSource from = light->suns[sun];
        float direct[3];
        for (int channel = 0; channel < channels; ++channel) {
          const float lit = sample_scalar(beam + (sun * channels + channel) * grid.room, sample);
          const float scaled_share = channel == 0 ? scaled.x : (channel == 1 ? scaled.y : scaled.z);
          const float scattered = channel == 0 ? albedo.x : (channel == 1 ? albedo.y : albedo.z);
          // The aureole grows with what scatters.
          const float depth_of_way = depth_of_eye - log(fmax(lit, 1e-30f)) / scaled_share;
          direct[channel] = phase_at(phases, look.phase_table, angle_places[sun], scattered * depth_of_way) * lit;
        }
        shown += of_colours(direct, channels) * (float3)(from.red, from.green, from.blue);
      }
      if (k < 0) {
        here = shown;
        continue;
      }
      last = albedo * shown / scaled;
      const float3 kept = exp(-found.w * piece * scaled);
      behind += share * (1.0f - kept) * last;
      share *= kept;
      depth_before += piece * found.w;
      at += piece;
      if (at >= leave || fmax(share.x, fmax(share.y, share.z)) < 0.02f) break;
    }
    const float3 sky = view.y < 0.0f ? (float3)(light->sky_red, light->sky_green, light->sky_blue)
                                     : (float3)(light->ground_red, light->ground_green, light->ground_blue);
    behind += share * (at < leave ? last : sky);
    const float3 seen = own_albedo * (look.forward_share * behind + here);
    const CloudSprite sprite = {seen.x, seen.y, seen.z, depth};
    sprites[i] = sprite;
  }
}
