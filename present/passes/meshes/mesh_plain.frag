// One light for all pixels: outlines, strokes, boxes.

out vec4 light;

void main() {
  light = plain.light;
}
