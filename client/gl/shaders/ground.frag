#include "face.glsl"
in vec2 place;
out vec4 result;

// A face is a little darker towards its edges.
void main() {
  float depth = max(depthInFace(place), 0.0);
  float wide = 1.0 - smoothstep(0.0, 0.55 * apothem, depth);
  float near = 1.0 - smoothstep(0.0, 26.0, depth);
  // Dithering by one step of the light map hides banding.
  float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  result = vec4(0.998 - 0.20 * wide * wide - 0.16 * near * near + (grain - 0.5) / 255.0, 0, 0, 1);
}
