// One light for all pixels: outlines, strokes, boxes.
uniform vec4 plain_light;  // kcd/m2, premultiplied, and coverage

out vec4 light;

void main() {
  light = plain_light;
}
