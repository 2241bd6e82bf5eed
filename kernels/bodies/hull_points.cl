// Where the vertices of floating hulls are in the world: the places at which they ask for the water.
// In:  states [bodies] (shared/bodies.h); vertices [vertices][3] m in body axes; owners [vertices]: their bodies.
// Out: points [vertices] of ocean/surface_query.cl.
#include "bodies/turn.clh"
#include "shared/bodies.h"
#include "shared/query_params.h"

__kernel void hull_points(__global const BodyState* restrict states, __global const float* restrict vertices,
                          __global const uint* restrict owners, __global SurfaceQueryPoint* restrict points) {
  const size_t vertex = get_global_id(0);
  const BodyState state = states[owners[vertex]];
  const float3 arm = turned((float4)(state.turn_x, state.turn_y, state.turn_z, state.turn_w), vload3(vertex, vertices));
  const SurfaceQueryPoint point = {state.tile_x, state.tile_z, state.x_m + arm.x, state.z_m + arm.z};
  points[vertex] = point;
}
