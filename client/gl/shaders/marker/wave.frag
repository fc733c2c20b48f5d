#include "marker.glsl"
uniform float opened;     // part of the time: 0 … 1
out vec4 result;

// A ring of light that spreads to `radius`, ever slower and fainter, with a breath of light in it.
void main() {
  float r = length(at);
  float wide = radius * (1.0 - (1.0 - opened) * (1.0 - opened));
  float left = (1.0 - opened) * (1.0 - opened);
  float off = (r - wide) / (0.05 + 0.09 * opened) / radius;
  float ring = exp(-off * off) * 0.40;
  float edge = max(wide, 0.01 * radius);  // smoothstep is undefined between equal edges
  float inner = (1.0 - smoothstep(0.2 * edge, edge, r)) * 0.16;
  result = vec4(0.86, 0.95, 1.0, left * (ring + inner) * inFace());
}
