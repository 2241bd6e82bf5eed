// Rays of the camera through the points of a picture (screen.vert): host/base/camera.h.

in vec2 clip;

// Through this pixel; its component along the line of sight is 1.
vec3 view_ray() {
  return view.ray_forward + clip.x * view.ray_right + clip.y * view.ray_up;
}
