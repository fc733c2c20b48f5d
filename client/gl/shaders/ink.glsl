// For fragments of what lies on a face.
#include "face.glsl"
in vec2 place;

// Coverage of the face: 1 inside, 0 outside, smooth over one pixel.
float inFace() {
  float depth = depthInFace(place);
  return clamp(depth / fwidth(depth) + 0.5, 0.0, 1.0);
}

vec4 over(vec4 below, vec3 colour, float alpha) {
  float sum = alpha + below.a * (1.0 - alpha);
  return vec4((colour * alpha + below.rgb * below.a * (1.0 - alpha)) / max(sum, 1e-4), sum);
}
