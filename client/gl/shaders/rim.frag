#include "face.glsl"
#include "surface.glsl"
uniform vec3 colour;
uniform float gridStep;   // 0: no grid
out vec4 result;

float grid(vec2 at) {
  vec2 pixel = fwidth(at);
  vec2 line = 1.0 - min(abs(fract(at - 0.5) - 0.5) / pixel, 1.0);
  return max(line.x, line.y) * clamp(1.0 - 6.0 * max(pixel.x, pixel.y), 0.0, 1.0);
}

void main() {
  float depth = depthInFace(place);
  vec3 shade = surface();
  if (gridStep > 0.0) shade += 0.035 * grid(place / gridStep);
  float edge = 1.0 - smoothstep(0.0, max(1.6, 1.2 * fwidth(depth)), depth);
  result = vec4(mix(shade, colour * 1.25 + 0.10, edge * 0.45), 1);
}
