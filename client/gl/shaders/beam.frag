in vec2 at;
uniform vec4 colour;
out vec4 result;

void main() {
  float across = 1.0 - abs(at.x);
  float core = across * across;
  float along = smoothstep(0.0, 0.08, at.y) * (1.0 - at.y);
  result = vec4(colour.rgb, colour.a * core * (0.35 + 0.65 * core) * along);
}
