#include "surface.glsl"
out vec4 result;

void main() { result = vec4(surface(), 1); }
