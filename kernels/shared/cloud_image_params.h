// A camera's picture of cloud particles, one layout for host and device: 4-byte scalars only.
#ifndef OFFING_KERNELS_SHARED_CLOUD_IMAGE_H
#define OFFING_KERNELS_SHARED_CLOUD_IMAGE_H

// Pixels along an edge of the tiles that a picture is made in.
#define CLOUD_TILE_PX 16

// Boxes of particles are padded to a multiple of so many, of which the last ones lie nowhere.
#define CLOUD_BOX_PAD 16

// Depth of a layer at the eye and by how much it grows a metre (kernels/clouds/billboard_project.cl).
#define CLOUD_LAYER_M 4.0f
#define CLOUD_LAYER_GROWTH 0.008f
#define CLOUD_LAYER_RATIO 1.00803209f  // e^CLOUD_LAYER_GROWTH

// Integral of h (C1) along a ball's diameter, in its radii.
#define CLOUD_CHORD 0.998942f

// The camera and the sun, in the axes of the particles.
typedef struct {
  float eye_x_m, eye_y_m, eye_z_m;        // m
  float forward_x, forward_y, forward_z;  // along the line of sight
  float right_x, right_y, right_z;        // unit, along the rows of the picture
  float up_x, up_y, up_z;                 // unit, along its columns
  float half_width, half_height;          // of the picture at distance 1
  int width_px, height_px;
  int tile_columns, tile_rows;
  int count;                  // of particles
  int box_pitch;              // count, padded
  float sun_x, sun_y, sun_z;  // unit, toward it
  float near_m;               // of depths: that over the distance along the line of sight
  float relief;               // how much brighter texels are that face the sun than those across
} CloudImageParams;

// A particle as a camera sees it; the axes of its texture carry its scale.
typedef struct {
  float x, y, z;  // m, of its middle from the eye
  float radius_m;
  float optical_depth;              // through its middle, over CLOUD_CHORD
  float red, green, blue;           // kcd/m^2
  float right_x, right_y, right_z;  // unit, along the rows of its texture
  float up_x, up_y, up_z;           // unit, along its columns
  float relief_x, relief_y;         // what turns (billboard_textures.h) count of its light
  float layer;                      // where it lies among the layers, 0 at the eye
  float layer_m;                    // where its layer begins
  float pattern;                    // share of the texture in its opacity, 0 ... 1
  unsigned int texels;              // the first one of the level of its texture
  int level_px;                     // along an edge of that level
  float coarser;                    // share of the next level, 0 ... 1
  float distance_m;
} CloudBillboard;

#ifndef __OPENCL_VERSION__
static_assert(sizeof(CloudImageParams) == 100, "no padding");
static_assert(sizeof(CloudBillboard) == 92, "no padding");
#endif

#endif
