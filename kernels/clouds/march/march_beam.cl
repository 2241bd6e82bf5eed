// Optical depth of the way from the middle of each cell of a volume to each sun but the first. Carried from plane to plane
// along the axis that the light crosses fastest, mixed between the middles of four cells of the plane before. Other clouds before this one add theirs where the light enters.
// In:  the volume, density; grids, looks, lights [clouds]; of light_entry.cl entries, which count where there are several
//      clouds.
// Out: depths [suns][CLOUD_MARCH_CELLS], of these.
// One work-group of GROUP_SIZE a sun.
#include "clouds/march/march_entry.clh"

__kernel __attribute__((reqd_work_group_size(GROUP_SIZE, 1, 1))) void march_beam(
    const CloudMarchVolume volume, __global const float *restrict density, __global const CloudGrid *restrict grids,
    __global const CloudScattering *restrict looks, __global const CloudLightParams *restrict lights,
    __global const float *restrict entries, int clouds, int channels, __global float *restrict depths) {
  const int sun = 1 + (int)get_group_id(0), suns = 1 + (int)get_num_groups(0), item = (int)get_local_id(0);
  const CloudLightSource source = lights[volume.cloud].suns[sun];
  depths += (size_t)sun * CLOUD_MARCH_CELLS;

  const float3 way = -in_volume(volume, (float3)(source.x, source.y, source.z)), speed = fabs(way);
  const int axis = speed.x > speed.y ? (speed.x > speed.z ? 0 : 2) : (speed.y > speed.z ? 1 : 2);
  const int axis_a = axis == 0 ? 1 : 0, axis_b = axis == 2 ? 1 : 2;
  const int sizes[3] = {volume.size_x, volume.size_y, volume.size_z};
  const int strides[3] = {1, volume.size_x, volume.size_x * volume.size_y};
  const int planes = sizes[axis], size_a = sizes[axis_a], size_b = sizes[axis_b];
  const int stride_a = strides[axis_a], stride_b = strides[axis_b];
  const float planes_way = 1.0f / component(speed, axis), half_way = 0.5f * planes_way * volume.cell_m;
  const float back_a = -component(way, axis_a) * planes_way, back_b = -component(way, axis_b) * planes_way;
  const int left_a = back_a < 0.0f ? -1 : 0, left_b = back_b < 0.0f ? -1 : 0;
  // Not back - (float)left: of the -1 of a condition Oclgrind 21.10 makes 1.
  const float share_a = back_a < 0.0f ? 1.0f + back_a : back_a, share_b = back_b < 0.0f ? 1.0f + back_b : back_b;
  const bool is_rising = component(way, axis) > 0.0f;
  const int step = is_rising ? strides[axis] : -strides[axis];
  const MarchEntry entry = march_entry(volume, grids, looks, lights, entries, suns, channels, sun);

  for (int plane = 0; plane < planes; ++plane) {
    const int start = (is_rising ? plane : planes - 1 - plane) * strides[axis];
    for (int i = item; i < size_a * size_b; i += GROUP_SIZE) {
      const int b = i / size_a, a = i - b * size_a, cell = start + a * stride_a + b * stride_b;
      float arriving = 0.0f;
      for (int corner = 0; corner < 4; ++corner) {
        const int from_a = a + left_a + (corner & 1), from_b = b + left_b + (corner >> 1);
        const float weight = ((corner & 1) ? share_a : 1.0f - share_a) * ((corner >> 1) ? share_b : 1.0f - share_b);
        if (plane > 0 && from_a >= 0 && from_a < size_a && from_b >= 0 && from_b < size_b) {
          const int from = start - step + from_a * stride_a + from_b * stride_b;
          arriving += weight * (depths[from] + half_way * density[from]);
        } else if (clouds > 1) {
          arriving += weight * depth_before(volume, entry, cell % volume.size_x, cell / volume.size_x % volume.size_y,
                                            cell / (volume.size_x * volume.size_y));
        }
      }
      depths[cell] = arriving + half_way * density[cell];
    }
    wait_for_group();
  }
}
