in vec2 texel;
in vec4 colour;
uniform sampler2D atlas;
uniform float halo;       // opacity of the dark outline around the letters
out vec4 result;

const float kSlope = 24.0 / 255.0;  // change of the distance value per sample, as in font.cpp

void main() {
  float distance = texture(atlas, texel).r - 0.502;
  // Not from the distance itself, whose slope vanishes in the middle of a stroke.
  vec2 samples = vec2(textureSize(atlas, 0));
  float pixel = kSlope * (length(dFdx(texel) * samples) + length(dFdy(texel) * samples)) / 2.0;
  float letter = clamp(distance / pixel + 0.5, 0.0, 1.0);
  float dark = halo * smoothstep(-0.36, -0.08, distance);
  float alpha = letter + dark * (1.0 - letter);
  result = vec4(colour.rgb * letter / max(alpha, 1e-4), alpha * colour.a);
}
