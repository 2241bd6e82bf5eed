// What the eye sees of each particle by the paper's model (C10, C11): of each sun's light that reaches it, what it scatters
// toward the eye once, and a share of what sky and ground send on the average.
// In:  particles [end], looks, lights of one sun at most, phases, reached [end]; the eye.
// Out: sprites [first ... end - 1].
#include "clouds/chord.clh"
#include "clouds/phase.clh"
#include "shared/clouds.h"

__kernel void particle_first_order(__global const CloudParticle *restrict particles, int first, int end, int particles_per_item,
                                   __global const CloudScattering *restrict looks, __global const CloudLightParams *restrict lights,
                                   __global const float *restrict phases, __global const float *restrict reached,
                                   float eye_x_m, float eye_y_m, float eye_z_m, __global CloudSprite *restrict sprites) {
  const int own = first + (int)get_global_id(0) * particles_per_item, own_end = min(own + particles_per_item, end);
  for (int i = own; i < own_end; ++i) {
    const CloudParticle particle = particles[i];
    const CloudLightParams light = lights[particle.cloud];
    const float3 way = (float3)(eye_x_m - particle.x, eye_y_m - particle.y, eye_z_m - particle.z);
    const float3 view = way * rsqrt(fmax(dot(way, way), 1e-20f));
    float3 seen = 0.5f * (float3)(light.sky_red + light.ground_red, light.sky_green + light.ground_green,
                                  light.sky_blue + light.ground_blue);
    for (int sun = 0; sun < light.sun_count; ++sun) {
      const CloudLightSource from = light.suns[sun];
      const float place = phase_angle_place(-(from.x * view.x + from.y * view.y + from.z * view.z));
      seen += phase_at(phases, looks[particle.cloud].phase_table, place, 0.0f) * reached[i] *
              (float3)(from.red, from.green, from.blue);
    }
    const CloudSprite sprite = {seen.x * particle.red, seen.y * particle.green, seen.z * particle.blue,
                                cloud_depth(particle.optical_mass, particle.radius)};
    sprites[i] = sprite;
  }
}
