// The surface of a face without its edges.
#include "light.glsl"
in vec2 place;
in vec3 lightest;

const vec3 kShadow = vec3(0.40, 0.40, 0.50);

vec3 surface() { return lightest * mix(kShadow, vec3(1), lightAt(place)); }
