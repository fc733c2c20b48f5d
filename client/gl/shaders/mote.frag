in float strength;
uniform vec3 colour;
out vec4 result;

void main() {
  float away = length(gl_PointCoord - 0.5);
  result = vec4(colour, strength * smoothstep(0.5, 0.05, away));
}
