in vec2 at;
flat in vec3 box;
flat in vec4 colour;
out vec4 result;

void main() {
  vec2 beyond = abs(at) - box.xy + box.z;
  float distance = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - box.z;
  result = vec4(colour.rgb, colour.a * clamp(0.5 - distance / fwidth(at.x), 0.0, 1.0));
}
