in vec3 shade;
out vec4 result;

void main() { result = vec4(shade, 1); }
