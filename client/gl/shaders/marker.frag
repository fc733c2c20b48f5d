#include "ink.glsl"
in vec2 at;
uniform int kind;         // 0 goal, 1 start, 2 shadow, 3 sign, 4 burst
uniform float opened;     // of the goal, or how far the burst is: 0 … 1
uniform vec2 form;        // of the sign: corners of the ring, dots
uniform float radius;
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

// Coverage of a shape by its signed distance: 1 inside, 0 outside, smooth over one pixel.
float filled(float distance) { return clamp(0.5 - distance / fwidth(distance), 0.0, 1.0); }

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

// A ring that spreads from the goal at a finish, and rays.
vec4 burst(float r) {
  float wide = radius * (1.0 + 6.0 * opened);
  float left = (1.0 - opened) * (1.0 - opened);
  float rays = 0.5 + 0.5 * cos(atan(at.y, at.x) * 12.0);
  float ring = exp(-abs(r - wide) * 0.12);
  float inner = rays * smoothstep(wide, 0.3 * wide, r) * 0.6;
  return vec4(vec3(1.0, 0.92, 0.62), left * max(ring, inner));
}

// Distance to the lines of the sign.
float linesAt(vec2 p) {
  float wedge = 3.14159265 / form.x;
  float turn = atan(p.x, p.y);
  float corner = cos(mod(turn + wedge, 2.0 * wedge) - wedge) / cos(wedge);
  float away = form.x > 6.5 ? length(p) - radius * 0.84 : length(p) * corner - radius * 0.80;
  float around = 6.2831853 / form.y;
  float nearest = (floor(turn / around) + 0.5) * around;
  vec2 middle = form.y < 1.5 ? vec2(0) : 0.30 * radius * vec2(sin(nearest), cos(nearest));
  return min(abs(away) - 0.075 * radius, length(p - middle) - 0.12 * radius);
}

// Cut into the stone: dark, with a bright lower edge.
vec4 engraving() {
  vec4 shade = vec4(1.0, 1.0, 1.0, 0.22 * filled(linesAt(at + vec2(-0.03, 0.05) * radius)));
  return over(shade, vec3(0.02, 0.02, 0.06), 0.34 * filled(linesAt(at)));
}

vec4 start(float r) {
  float dashes = filled((abs(fract(atan(at.y, at.x) * 12.0 / 6.2831853) - 0.5) - 0.32) * 6.0);
  float ring = filled(abs(r - radius) - 0.9) * dashes;
  vec2 p = vec2(abs(at.x), at.y - radius * 0.25);
  float chevron = filled(abs(p.y + p.x * 0.9) - 1.6) * filled(p.x - radius * 0.42);
  return vec4(vec3(0.85, 0.92, 1.0), 0.65 * max(ring, chevron));
}

void main() {
  float r = length(at);
  if (kind == 0) result = goal(r);
  else if (kind == 1) result = start(r);
  else if (kind == 2) result = vec4(0.02, 0.02, 0.06, 0.50 * (1.0 - smoothstep(0.55 * radius, 1.45 * radius, r)));
  else if (kind == 3) result = engraving();
  else result = burst(r);
  result.a *= inFace();
}
