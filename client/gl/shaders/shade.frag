in vec2 place;
flat in vec4 segment;
uniform vec2 fall;        // from the foot of a wall to the shadow of its top
uniform float halfWidth;
uniform float soft;       // width of the occlusion
out vec4 result;

float distanceTo(vec2 p) {
  vec2 way = segment.zw - segment.xy;
  float share = clamp(dot(p - segment.xy, way) / max(dot(way, way), 1e-6), 0.0, 1.0);
  return length(p - segment.xy - way * share) - halfWidth;
}

void main() {
  const int kSteps = 10;
  float near = clamp(1.0 - distanceTo(place) / soft, 0.0, 1.0);
  float occlusion = 0.42 * near * near;
  float shadow = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    float high = float(i) / float(kSteps);
    float blur = 0.8 + 5.0 * high;
    float covered = 1.0 - smoothstep(-blur, blur, distanceTo(place - fall * high));
    shadow = max(shadow, covered * (1.0 - 0.35 * high));
  }
  result = vec4(1.0 - min(occlusion + 0.62 * shadow, 0.85), 0, 0, 1);
}
