#include "marker.glsl"
uniform float opened;     // the light: 0 … 1
uniform vec2 form;        // half the length of the light along the edge
out vec4 result;

// Light along an edge, which goes through the middle; brightest there.
void main() {
  float along = at.x / form.x;
  float across = at.y / radius;
  float falls = max(1.0 - along * along, 0.0);
  float soft = exp(-3.0 * across * across) * 0.60;
  float core = exp(-90.0 * across * across) * 0.60;
  result = vec4(0.86, 0.95, 1.0, opened * falls * falls * (soft + core) * inFace());
}
