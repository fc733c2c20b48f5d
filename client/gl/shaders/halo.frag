in vec2 at;
uniform vec4 colour;
uniform float reach;      // half the side of the square, in radii of the ring
uniform float seconds;    // time of the animation
out vec4 result;

// The ring of the goal, and one that spreads from it.
void main() {
  float r = length(vec2(at.x, 2.0 * at.y - 1.0)) * reach;
  float thick = max(0.10, 0.9 * fwidth(r));
  float ring = 1.0 - smoothstep(0.5 * thick, thick, abs(r - 1.0));
  float spread = fract(seconds * 0.35);
  float calling = (1.0 - smoothstep(0.0, 2.0 * thick, abs(r - 1.0 - spread * (reach - 1.0)))) * (1.0 - spread);
  result = vec4(colour.rgb, colour.a * max(ring, 0.7 * calling));
}
