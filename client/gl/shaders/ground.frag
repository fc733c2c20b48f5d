#include "face.glsl"
in vec2 place;
out vec4 result;

// A face is a little darker towards its edges.
void main() {
  float depth = max(depthInFace(place), 0.0);
  float wide = 1.0 - smoothstep(0.0, 0.55 * apothem, depth);
  float near = 1.0 - smoothstep(0.0, 26.0, depth);
  result = vec4(1.0 - 0.20 * wide * wide - 0.16 * near * near, 0, 0, 1);
}
