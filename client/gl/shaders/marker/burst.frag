#include "marker.glsl"
uniform float opened;     // how far the burst is: 0 … 1
out vec4 result;

// A ring that spreads from the goal at a finish, and rays.
vec4 burst(float r) {
  float wide = radius * (1.0 + 6.0 * opened);
  float left = (1.0 - opened) * (1.0 - opened);
  float rays = 0.5 + 0.5 * cos(atan(at.y, at.x) * 12.0);
  float ring = exp(-abs(r - wide) * 0.12);
  float inner = rays * (1.0 - smoothstep(0.3 * wide, wide, r)) * 0.6;
  return vec4(vec3(1.0, 0.92, 0.62), left * max(ring, inner));
}

void main() {
  result = burst(length(at));
  result.a *= inFace();
}
