#include "marker.glsl"
out vec4 result;

vec4 start(float r) {
  float dashes = filled((abs(fract(atan(at.y, at.x) * 12.0 / 6.2831853) - 0.5) - 0.32) * 6.0);
  float ring = filled(abs(r - radius) - 0.9) * dashes;
  vec2 p = vec2(abs(at.x), at.y - radius * 0.25);
  float chevron = filled(abs(p.y + p.x * 0.9) - 1.6) * filled(p.x - radius * 0.42);
  return vec4(vec3(0.85, 0.92, 1.0), 0.65 * max(ring, chevron));
}

void main() {
  result = start(length(at));
  result.a *= inFace();
}
