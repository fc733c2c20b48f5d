#include "strip.glsl"
layout(location = 0) in vec4 ends;
uniform mat4 toClip;
uniform vec2 fall;
uniform float halfWidth;
uniform float soft;
out vec2 place;
flat out vec4 segment;

void main() {
  segment = ends;
  place = stripAlong(ends, vec2(halfWidth + soft + length(fall) + 4.0)).place;
  gl_Position = toClip * vec4(place, 0, 1);
}
