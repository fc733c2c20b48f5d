in vec2 at;
uniform sampler2D picture;
uniform float opacity;
out vec4 result;

void main() { result = vec4(texture(picture, at).rgb, opacity); }
