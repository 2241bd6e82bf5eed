// One round of averaging: each vertex gives its share away in equal parts, to its neighbours and itself, so that nothing is
// lost.
// In:  edges_begin [vertices + 1], neighbours: the other ends of each vertex's edges; shares [vertices], divided by the
//      edges of their vertex and one.
// Out: averaged [vertices], the same of the next round.
__kernel void share_average(__global const uint *restrict edges_begin, __global const uint *restrict neighbours,
                            __global const float8 *restrict shares, __global float8 *restrict averaged) {
  const size_t vertex = get_global_id(0);
  const uint begin = edges_begin[vertex], end = edges_begin[vertex + 1];
  float8 sum = shares[vertex];
  for (uint i = begin; i < end; ++i) sum += shares[neighbours[i]];
  averaged[vertex] = sum / (float)(end - begin + 1);
}
