uniform mat4 toClip;
uniform vec3 foot;
uniform vec3 way;         // from the foot to the tip
uniform vec3 aside;       // half the width, across the line of sight
out vec2 at;              // x: −1 … 1 across, y: 0 at the foot … 1 at the tip

void main() {
  at = vec2((gl_VertexID & 1) * 2 - 1, gl_VertexID >> 1);
  gl_Position = toClip * vec4(foot + way * at.y + aside * at.x, 1);
}
