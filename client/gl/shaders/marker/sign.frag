#include "marker.glsl"
uniform vec2 form;        // corners of the ring, dots
out vec4 result;

// Distance to the lines of the sign. No dot lies in the middle, so each sign shows how its face is turned.
float linesAt(vec2 p) {
  float wedge = 3.14159265 / form.x;
  float turn = atan(p.x, p.y);
  float corner = cos(mod(turn + wedge, 2.0 * wedge) - wedge) / cos(wedge);
  float away = form.x > 6.5 ? length(p) - radius * 0.84 : length(p) * corner - radius * 0.80;
  float around = 6.2831853 / form.y;
  float nearest = (floor(turn / around) + 0.5) * around;
  vec2 middle = 0.30 * radius * vec2(sin(nearest), cos(nearest));
  return min(abs(away) - 0.09 * radius, length(p - middle) - 0.14 * radius);
}

// Cut into the stone: dark, with a bright lower edge.
vec4 engraving() {
  vec4 shade = vec4(1.0, 1.0, 1.0, 0.36 * filled(linesAt(at + vec2(-0.03, 0.05) * radius)));
  return over(shade, vec3(0.02, 0.02, 0.06), 0.50 * filled(linesAt(at)));
}

void main() {
  result = engraving();
  result.a *= inFace();
}
