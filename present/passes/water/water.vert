// Vertices of the water's grid, as water_shape.frag has worked them out.
uniform sampler2D place_of;  // water_shape.frag's outputs
uniform sampler2D facet_of;
uniform sampler2D strain_of;

out vec2 label_m;            // relative to the eye
out vec3 position_m;         // relative to the eye
out vec2 gerstner_slope;     // dh/dx, dh/dz at labels
out vec3 gerstner_gradient;  // d dx/dx, d dx/dz, d dz/dz
out float gerstner_loss;     // share of the Gerstner waves' mean square slope that the grid is too coarse to draw
out float surf_foam;          // coverage by foam of waves that break on the shore
out vec2 grid_place;         // column and row

void main() {
  int stride = textureSize(place_of, 0).x;
  ivec2 vertex = ivec2(gl_VertexID % stride, gl_VertexID / stride);
  vec4 place = texelFetch(place_of, vertex, 0);
  vec4 facet = texelFetch(facet_of, vertex, 0);
  label_m = vec2(place.w, facet.w);
  position_m = place.xyz;
  gerstner_slope = facet.xy;
  gerstner_loss = facet.z;
  vec4 strain = texelFetch(strain_of, vertex, 0);
  gerstner_gradient = strain.xyz;
  surf_foam = strain.w;
  grid_place = vec2(vertex);
  gl_Position = grid.clip_from_eye * vec4(position_m, 1.0);
}
