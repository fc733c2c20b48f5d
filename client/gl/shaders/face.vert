layout(location = 0) in vec2 corner;
uniform mat4 toClip;
out vec2 place;

void main() {
  place = corner;
  gl_Position = toClip * vec4(corner, 0, 1);
}
