layout(location = 0) in vec2 corner;
uniform mat4 toClip;
uniform vec3 colour;
uniform float lit;
uniform vec2 slope;       // how the light changes over the face, per level unit
out vec2 place;
out vec3 lightest;        // colour where nothing shades the face

void main() {
  place = corner;
  lightest = colour * (lit + dot(corner, slope));
  gl_Position = toClip * vec4(corner, 0, 1);
}
