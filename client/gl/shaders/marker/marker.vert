uniform mat4 toClip;
uniform vec2 centre;
uniform vec2 reach;       // half the size
uniform float angle;
out vec2 place;
out vec2 at;              // offset from the centre in the marker's frame

void main() {
  at = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * reach;
  vec2 turn = vec2(cos(angle), sin(angle));
  place = centre + vec2(at.x * turn.x - at.y * turn.y, at.x * turn.y + at.y * turn.x);
  gl_Position = toClip * vec4(place, 0, 1);
}
