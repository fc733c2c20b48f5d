#include "ink.glsl"
in vec2 along;
flat in float extent;
flat in float halfWidth;
flat in vec4 colour;
out vec4 result;

void main() {
  float distance = length(vec2(along.x - clamp(along.x, 0.0, extent), along.y));
  float pixel = max(fwidth(along.y), 1e-4);
  result = vec4(colour.rgb, colour.a * clamp((halfWidth - distance) / pixel + 0.5, 0.0, 1.0) * inFace());
}
