// The sky behind everything, linear between the nodes at which its light is known.
uniform sampler2D nodes;  // kcd/m2, the first one at the picture's lower left corner

out vec4 light;

void main() {
  vec2 place = (gl_FragCoord.xy / sky_nodes.step_px + 0.5) / vec2(textureSize(nodes, 0));
  light = vec4(textureLod(nodes, place, 0.0).rgb, 1.0);
}
