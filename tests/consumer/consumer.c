/* A program in C of somebody who has Offing installed: the height of the sea under a hull, and a map of it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "host/c/offing.h"

static int failed(const char *what) {
  fprintf(stderr, "%s: %s\nhint: %s\n", what, offing_last_error(), offing_last_hint());
  return 1;
}

/* Highest and lowest water under a hull of 40 m over ten seconds, waves under 5 m left out. */
static int watch_hull(OffingWorld *world) {
  const OffingPoint hull[3] = {{-20.0, 0.0}, {0.0, 0.0}, {20.0, 0.0}};
  const OffingQuery query = {0.0, 5.0};
  OffingSample water[3];
  double highest_m = -1e9, lowest_m = 1e9;
  int frame, i;
  for (frame = 0; frame < 100; ++frame) {
    if (offing_frame(world, 0.1 * frame) != OFFING_OK) return failed("frame");
    if (offing_sample(world, &query, hull, 3, water) != OFFING_OK) return failed("sample");
    for (i = 0; i < 3; ++i) {
      highest_m = fmax(highest_m, water[i].height_m);
      lowest_m = fmin(lowest_m, water[i].height_m);
    }
  }
  printf("water from %.2f m to %.2f m\n", lowest_m, highest_m);
  return highest_m > 0.1 && lowest_m < -0.1 && highest_m < 5.0 ? 0 : 1;
}

/* Root mean square height of the first cascade. */
static int read_map(OffingWorld *world) {
  const int n = offing_map_size(world);
  const size_t count = (size_t)n * (size_t)n;
  float *height_m = malloc(count * sizeof *height_m);
  double sum = 0.0;
  size_t i;
  if (height_m == NULL) return 1;
  if (offing_read(world, 0, OFFING_DISPLACEMENT_Y, height_m, count) != OFFING_OK) {
    free(height_m);
    return failed("read");
  }
  for (i = 0; i < count; ++i) sum += (double)height_m[i] * height_m[i];
  free(height_m);
  printf("%.2f m rms on %.0f m\n", sqrt(sum / (double)count), offing_patch_length_m(world, 0));
  return sum > 0.0 ? 0 : 1;
}

int main(void) {
  OffingDevice *device = NULL;
  OffingScene *scene = NULL;
  OffingWorld *world = NULL;
  int result;
  if (offing_interface() != OFFING_INTERFACE) {
    fprintf(stderr, "compiled for another Offing\n");
    return 1;
  }
  if (offing_open_device(NULL, &device) != OFFING_OK) return failed("device");
  if (offing_parse_scene("version = 1\n[wind]\nspeed_mps = 9\n[ocean]\nsize = 64\n", NULL, &scene) != OFFING_OK) {
    return failed("scene");
  }
  if (offing_make_world(device, scene, &world) != OFFING_OK) return failed("world");
  printf("Offing %s on %s\n", offing_version(), offing_device_name(device));
  result = watch_hull(world);
  if (result == 0) result = read_map(world);
  offing_free_world(world);
  offing_free_scene(scene);
  offing_close_device(device);
  return result;
}
