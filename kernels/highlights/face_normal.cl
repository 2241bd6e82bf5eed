// Normal and area of each triangle.
// In:  positions_m [vertices][3]; corners [faces][3], anticlockwise seen from outside.
// Out: normals [faces]: unit vector outward, area m^2; all 0 without an area.
__kernel void face_normal(__global const float *restrict positions_m, __global const uint *restrict corners,
                          __global float4 *restrict normals) {
  const size_t face = get_global_id(0);
  const float3 a = vload3(corners[3 * face], positions_m);
  const float3 b = vload3(corners[3 * face + 1], positions_m);
  const float3 c = vload3(corners[3 * face + 2], positions_m);
  const float3 across = cross(b - a, c - a);
  const float doubled_area = length(across);
  normals[face] = doubled_area > 0.0f ? (float4)(across / doubled_area, 0.5f * doubled_area) : (float4)(0.0f);
}
