in vec2 at;
uniform vec4 colour;
uniform float tilt;       // half the height of the foot as it is seen from the side, in lengths of the beam
uniform float seconds;    // time of the animation
uniform bool hidden;      // by the solid
uniform float hiddenPart; // of the beam, from the foot
out vec4 result;

const float kDashes = 18.0;  // along the beam

// Rings that rise, by their height.
float ringsAt(float high) {
  float phase = fract(4.0 * high - 0.22 * seconds) - 0.5;
  return (1.0 - smoothstep(0.0, 0.06, abs(phase))) * step(0.0, high);
}

// What the solid hides is drawn as hidden lines are: a thin line of dashes, which nobody takes for light on the face in
// front. A dash at the rim of the solid fades: alone, it would look like a mark on the face.
float dashesAt(float aside, float high) {
  float line = 1.0 - smoothstep(0.10, 0.17, aside);
  float dash = abs(fract(kDashes * high) - 0.5);
  float middle = floor(kDashes * high) + 0.5;
  float inside = smoothstep(0.5, 1.5, kDashes * hiddenPart - middle);
  return line * (1.0 - smoothstep(0.20, 0.25, dash)) * (1.0 - high) * inside;
}

// A tube of light that stands on the ring of the goal and tapers to a thread.
void main() {
  if (hidden) {
    result = vec4(colour.rgb, colour.a * dashesAt(abs(at.x), at.y));
    return;
  }
  float wide = 1.0 - 0.82 * at.y;
  float across = min(abs(at.x) / wide, 1.0);
  float round = sqrt(1.0 - across * across);
  float body = mix(0.30 + 0.70 * across * across, round, smoothstep(0.0, 0.5, at.y));
  float rings = max(ringsAt(at.y + tilt * wide * round), 0.6 * ringsAt(at.y - tilt * wide * round));
  float along = (1.0 - at.y) * (1.0 - at.y) * smoothstep(0.0, 0.01, at.y);
  float edge = 1.0 - smoothstep(0.80, 1.0, across);
  result = vec4(colour.rgb, colour.a * (body + 0.9 * rings) * along * edge);
}
