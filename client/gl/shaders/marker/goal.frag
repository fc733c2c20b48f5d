#include "marker.glsl"
uniform float opened;     // 0 … 1
uniform float seconds;    // time of the animation
out vec4 result;

// Signed distance to a five-pointed star.
float star(vec2 p, float size) {
  const vec2 k1 = vec2(0.809016994, -0.587785252);
  const vec2 k2 = vec2(-0.809016994, -0.587785252);
  p.x = abs(p.x);
  p -= 2.0 * max(dot(k1, p), 0.0) * k1;
  p -= 2.0 * max(dot(k2, p), 0.0) * k2;
  p.x = abs(p.x);
  p.y -= size;
  vec2 side = 0.45 * vec2(-k1.y, k1.x) - vec2(0, 1);
  float part = clamp(dot(p, side) / dot(side, side), 0.0, size);
  return length(p - side * part) * sign(p.y * side.x - p.x * side.y);
}

vec4 goal(float r) {
  vec3 gold = vec3(1.0, 0.84, 0.36);
  float pulse = 0.5 + 0.5 * sin(seconds * 2.5);
  float wide = radius * (1.0 + 0.9 * opened);
  vec4 shade = vec4(gold, (0.45 + 0.15 * pulse) * exp(-abs(r - wide) * (0.11 - 0.02 * pulse)));
  shade = over(shade, mix(vec3(0.10, 0.07, 0.03), vec3(1.0, 0.97, 0.86), opened), 0.75 * filled(r - wide));
  float spin = atan(at.y, at.x) + seconds * 0.6;
  float rays = 0.5 + 0.5 * cos(spin * 8.0);
  shade = over(shade, gold, 0.5 * rays * filled(r - wide) * smoothstep(0.55, 1.0, r / wide));
  shade = over(shade, gold, filled(abs(r - wide) - 1.5));
  return over(shade, vec3(1.0, 0.95, 0.75), filled(star(at, radius * 0.62)) * (1.0 - opened));
}

void main() {
  result = goal(length(at));
  result.a *= inFace();
}
