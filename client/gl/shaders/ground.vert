uniform mat4 toClip;
uniform float reach;      // half the side of the square
out vec2 place;

void main() {
  place = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * reach;
  gl_Position = toClip * vec4(place, 0, 1);
}
