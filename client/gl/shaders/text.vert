layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 inAtlas;
layout(location = 2) in vec4 colourOfGlyph;
uniform mat4 toClip;
out vec2 texel;
out vec4 colour;

void main() {
  texel = inAtlas;
  colour = colourOfGlyph;
  gl_Position = toClip * vec4(corner, 0, 1);
}
