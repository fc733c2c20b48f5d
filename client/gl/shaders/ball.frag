in vec3 normal;
in vec3 skin;
uniform vec3 colour;
uniform vec3 outline;
uniform vec3 toEye;
uniform vec3 light;
uniform float opacity;
uniform int pattern;      // BallPattern
uniform vec3 up;          // where the mark of the player's up is
out vec4 result;

// Above 0 where the ball has its colour, below 0 where its pattern is dark. `p` is on the unit sphere.
float bright(vec3 p) {
  vec3 far = abs(p);
  float axis = max(max(far.x, far.y), far.z);
  if (pattern == 0) return 0.86 - axis;                                  // spots on the axes
  if (pattern == 1) return 0.18 - sin(p.z * 10.0) * 0.5;                 // stripes
  if (pattern == 2) return far.z - 0.30;                                 // a belt
  if (pattern == 3) return min(far.x, far.z) - 0.17;                     // a cross
  if (pattern == 4) return 0.955 - max(axis, dot(far, vec3(0.57735)));   // many dots
  if (pattern == 5) return p.z;                                          // halves
  if (pattern == 6) return 4.0 * p.x * p.y * p.z;                        // checks
  return 1.0;
}

void main() {
  vec3 n = normalize(normal);
  float facing = dot(n, toEye);
  float lit = 0.50 + 0.56 * max(dot(n, light), 0.0);
  float gloss = max(dot(n, normalize(light + toEye)), 0.0);
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  gloss *= gloss;
  float band = bright(skin);
  float soft = fwidth(band);
  vec3 shade = colour * mix(0.52, 1.0, smoothstep(-soft, soft, band)) * lit + gloss * 0.35;
  float mark = dot(n, up);
  shade = mix(shade, vec3(0.08, 0.08, 0.13), 0.60 * smoothstep(0.915, 0.935, mark));  // so that a bright ball has a mark
  shade = mix(shade, vec3(1.0, 0.99, 0.95), smoothstep(0.955, 0.972, mark));
  float edge = fwidth(facing);
  result = vec4(mix(outline, shade, smoothstep(0.40 - edge, 0.40 + edge, facing)), opacity);
}
