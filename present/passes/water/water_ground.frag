// What a picture shows before its water, kept for the water's shader: ground at the picture's own pixels.
uniform sampler2D shown_light;  // kcd/m2
uniform sampler2D shown_depth;  // reversed; 0: nothing

layout(location = 0) out vec4 ground;  // light; reversed depth, 0: nothing

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(shown_depth, pixel, 0).r;
  ground = depth > 0.0 ? vec4(texelFetch(shown_light, pixel, 0).rgb, depth) : vec4(0.0);
}
