#include "strip.glsl"
layout(location = 0) in vec4 ends;
layout(location = 1) in float width;
layout(location = 2) in vec4 colourOfMark;
uniform mat4 toClip;
out vec2 place;
out vec2 along;           // x: distance from the first end, y: distance across
flat out float extent;
flat out float halfWidth;
flat out vec4 colour;

void main() {
  halfWidth = width / 2.0;
  colour = colourOfMark;
  Strip strip = stripAlong(ends, vec2(halfWidth + 2.0));
  extent = strip.extent;
  along = strip.at;
  place = strip.place;
  gl_Position = toClip * vec4(place, 0, 1);
}
