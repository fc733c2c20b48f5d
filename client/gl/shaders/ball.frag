in vec3 normal;
in vec3 skin;
uniform vec3 colour;
uniform vec3 outline;
uniform vec3 toEye;
uniform vec3 light;
uniform float opacity;
uniform vec3 up;          // where the mark of the player's up is
out vec4 result;

void main() {
  vec3 n = normalize(normal);
  float facing = dot(n, toEye);
  float lit = 0.50 + 0.56 * max(dot(n, light), 0.0);
  float gloss = max(dot(n, normalize(light + toEye)), 0.0);
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  // Six dark spots, as on the axes.
  float band = 0.86 - max(max(abs(skin.x), abs(skin.y)), abs(skin.z));
  float soft = fwidth(band);
  vec3 shade = colour * mix(0.58, 1.0, smoothstep(-soft, soft, band)) * lit + gloss * 0.35;
  float mark = dot(n, up);
  shade = mix(shade, vec3(1.0, 0.99, 0.95), smoothstep(0.955, 0.972, mark));
  float edge = fwidth(facing);
  result = vec4(mix(outline, shade, smoothstep(0.40 - edge, 0.40 + edge, facing)), opacity);
}
