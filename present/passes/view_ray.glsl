// Rays of the camera through the points of a picture (screen.vert): host/base/camera.h.
uniform vec3 ray_forward;  // through the picture's middle, a unit vector
uniform vec3 ray_right;    // what a step of 1 in clip coordinates adds to it
uniform vec3 ray_up;

in vec2 clip;

// Through this pixel; its component along the line of sight is 1.
vec3 view_ray() {
  return ray_forward + clip.x * ray_right + clip.y * ray_up;
}
