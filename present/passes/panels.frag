// Panels that were drawn before, to be mixed with the picture behind them.
uniform sampler2D drawn;  // premultiplied

out vec4 colour;

void main() {
  colour = texelFetch(drawn, ivec2(gl_FragCoord.xy), 0);
}
