#include "marker.glsl"
uniform float opened;     // the light: 0 … 1
out vec4 result;

float rod(vec2 p, vec2 a, vec2 b) {
  vec2 way = b - a;
  return length(p - a - way * clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0));
}

// An arrow that points down and fades towards its tail. `radius` is half its length.
void main() {
  vec2 p = vec2(abs(at.x), at.y) / radius;
  float arrow = min(rod(p, vec2(0, 0.95), vec2(0, -0.85)), rod(p, vec2(0.52, -0.30), vec2(0, -0.85))) - 0.11;
  float tail = smoothstep(1.1, -0.2, p.y);
  vec4 shade = vec4(0.02, 0.02, 0.06, 0.35 * exp(-5.0 * max(arrow, 0.0)));
  shade = over(shade, vec3(0.90, 0.97, 1.0), filled(arrow * radius));
  result = vec4(shade.rgb, shade.a * opened * tail * inFace());
}
