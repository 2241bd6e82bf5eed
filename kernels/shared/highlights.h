// Arrays of the highlight search (H3), one layout for host and device: 4-byte scalars only. Places are
// relative to the middle of the mesh, in its own axes.
#ifndef OFFING_KERNELS_SHARED_HIGHLIGHTS_H
#define OFFING_KERNELS_SHARED_HIGHLIGHTS_H

// Lights that one launch takes: a bit each of a word.
#define HIGHLIGHT_LIGHTS 32

// Rows of vertices [HIGHLIGHT_VERTEX_ROWS][vertex pitch]; three rows each are x, y, z.
#define HIGHLIGHT_POSITION 0  // m
#define HIGHLIGHT_NORMAL 3    // unit vectors
#define HIGHLIGHT_E_MAX 6     // unit vectors along the larger curvature, or zero
#define HIGHLIGHT_K_MAX 9     // 1/m, convex positive
#define HIGHLIGHT_K_MIN 10
#define HIGHLIGHT_VERTEX_ROWS 11

// An eye or a light: at (x, y, z) m, or so far away that only the direction to it counts.
typedef struct {
  float x, y, z;   // a place, or a unit vector toward it
  float nearness;  // 1: a place, 0: a direction
} HighlightSource;

// One light with the eye, and the half vector H in the middle of the mesh.
typedef struct {
  HighlightSource eye, source;
  float axis_x, axis_y, axis_z;     // H there, a unit vector
  float right_x, right_y, right_z;  // unit vectors: right x up = axis
  float up_x, up_y, up_z;
  int is_constant;  // H is the same everywhere
} HighlightLight;

// A point where the normal is the half vector.
typedef struct {
  int face, light;
  int orientation;  // 1: the normals turn as the surface does (K > 0), -1: against it (K < 0)
  float weight_0, weight_1, weight_2;  // of the face's corners, >= 0, their sum is 1
  float n_dot_h;                       // of unit vectors
  float normal_x, normal_y, normal_z;  // unit vector
  float e_max_x, e_max_y, e_max_z;     // unit vector across it, of either sign
  float k_max_perm, k_min_perm;
} HighlightRecord;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(HighlightSource) == 16, "no padding");
static_assert(sizeof(HighlightLight) == 72, "no padding");
static_assert(sizeof(HighlightRecord) == 60, "no padding");
#endif

#endif
