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

const vec3 kGold = vec3(1.0, 0.84, 0.36);

// Light that calls: rings rise along the beam, and are seen to spread from above.
float calling(float r, float wide) {
  float high = fract(seconds * 0.35);
  float ring = exp(-abs(r - wide * (1.0 + 1.7 * high)) * 0.32);
  return 0.55 * ring * high * (1.0 - high) * 4.0 * step(1e-3, seconds);
}

// A quiet well of light: night in its depth, dawn along its ring.
vec4 portal(vec4 below, float r, float wide) {
  float depth = clamp(r / wide, 0.0, 1.0);
  float wave = 0.5 + 0.5 * sin(depth * 15.0 + seconds * 1.1);
  vec3 light = mix(vec3(0.09, 0.11, 0.22), vec3(0.62, 0.36, 0.24), smoothstep(0.15, 0.95, depth));
  light += kGold * (0.55 * pow(depth, 7.0) + 0.05 * wave * depth);
  return over(below, light, 0.92 * filled(r - wide) * opened);
}

vec4 goal(float r) {
  float pulse = 0.5 + 0.5 * sin(seconds * 2.5);
  float wide = radius * (1.0 + 0.25 * opened);
  float glow = mix(0.45 + 0.15 * pulse, 0.30, opened) * exp(-abs(r - wide) * (0.11 - 0.02 * pulse));
  vec4 shade = vec4(kGold, max(glow, calling(r, wide) * (1.0 - opened)));
  shade = over(shade, vec3(0.10, 0.07, 0.03), 0.75 * filled(r - wide) * (1.0 - opened));
  float spin = atan(at.y, at.x) + seconds * 0.6;
  float rays = 0.5 + 0.5 * cos(spin * 8.0);
  shade = over(shade, kGold, 0.5 * rays * filled(r - wide) * smoothstep(0.55, 1.0, r / wide) * (1.0 - opened));
  shade = portal(shade, r, wide);
  shade = over(shade, kGold, filled(abs(r - wide) - 1.5));
  return over(shade, vec3(1.0, 0.95, 0.75), filled(star(at, radius * 0.62)) * (1.0 - opened));
}

void main() {
  result = goal(length(at));
  result.a *= inFace();
}
