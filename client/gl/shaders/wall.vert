layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
uniform mat4 toClip;
uniform vec3 light;
uniform vec3 ground;      // colour of the face
uniform float lit;
out vec3 shade;

void main() {
  float sun = max(dot(normal, light), 0.0);
  float top = step(0.9, normal.z);
  vec3 side = mix(ground * 0.80, colour, 0.26 + 0.62 * sun) * (place.z > 0.0 ? 1.0 : 0.70);
  shade = mix(side, colour, top) * lit;
  gl_Position = toClip * vec4(place, 1);
}
