in vec2 screen;
uniform vec3 top;
uniform vec3 bottom;
uniform vec3 glow;
out vec4 result;

void main() {
  float high = screen.y * 0.5 + 0.5;
  vec3 shade = mix(bottom, top, high * (0.6 + 0.4 * high));
  float away = dot(screen, screen);
  shade = mix(shade, glow, 0.38 / (1.0 + 2.2 * away * (1.0 + away)));
  // Dithering by less than one colour step hides banding.
  float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  result = vec4(shade + (grain - 0.5) / 255.0, 1);
}
