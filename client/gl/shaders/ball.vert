layout(location = 0) in vec3 point;
uniform mat4 toClip;      // from the unit sphere
uniform mat4 turned;      // how the ball has rolled
uniform mat4 shaped;      // squash
out vec3 normal;
out vec3 skin;            // the point in the frame of the pattern

void main() {
  normal = point;
  skin = transpose(mat3(turned)) * point;
  gl_Position = toClip * (shaped * vec4(point, 1));
}
