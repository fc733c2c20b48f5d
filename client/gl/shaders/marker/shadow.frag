#include "marker.glsl"
out vec4 result;

void main() {
  float dark = 1.0 - smoothstep(0.55 * radius, 1.45 * radius, length(at));
  result = vec4(0.02, 0.02, 0.06, 0.50 * dark * inFace());
}
