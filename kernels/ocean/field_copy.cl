// One field of interleaved maps as an array of its own.
// In:  maps [texels][stride] floats; the field begins at offset. Out: values [texels] from index first on.

__kernel void field_copy(__global const float *restrict maps, int offset, int stride, int first,
                         __global float *restrict values) {
  const int texel = (int)get_global_id(0);
  values[first + texel] = maps[offset + texel * stride];
}
