// A marker on a face.
#include "ink.glsl"
in vec2 at;
uniform float radius;

// Coverage of a shape by its signed distance: 1 inside, 0 outside, smooth over one pixel.
float filled(float distance) { return clamp(0.5 - distance / fwidth(distance), 0.0, 1.0); }
