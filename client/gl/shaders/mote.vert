uniform mat4 toClip;      // from the sphere of radius 1 round the solid's centre
uniform float pixels;     // per unit of size, at distance 1 from the eye
uniform float seconds;
out float strength;

float random(float seed) { return fract(sin(float(gl_VertexID) * 12.9898 + seed) * 43758.5453); }

// Motes turn slowly round the vertical axis of space and rise a little.
void main() {
  float z = fract(random(1.0) + seconds * (0.004 + 0.006 * random(4.0))) * 2.0 - 1.0;
  float turn = (random(2.0) + seconds * 0.0015) * 6.2831853;
  float size = random(3.0);
  float ring = 1.1 + 1.3 * random(5.0);
  vec3 place = vec3(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z * 1.4) * ring;
  gl_Position = toClip * vec4(place.x, place.z, place.y, 1);
  gl_Position.z = gl_Position.w;  // behind everything
  gl_PointSize = clamp(pixels * (1.6 + 3.2 * size * size) / max(gl_Position.w, 0.1), 1.5, 12.0);
  strength = (0.10 + 0.40 * size * size) * smoothstep(0.0, 0.15, 1.0 - abs(z));
}
