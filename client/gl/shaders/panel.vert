layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 fromMiddle;
layout(location = 2) in vec3 form;        // half width, half height, corner radius
layout(location = 3) in vec4 colourOfPanel;
uniform mat4 toClip;
out vec2 at;
flat out vec3 box;
flat out vec4 colour;

void main() {
  at = fromMiddle;
  box = form;
  colour = colourOfPanel;
  gl_Position = toClip * vec4(corner, 0, 1);
}
