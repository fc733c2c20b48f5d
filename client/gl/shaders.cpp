#include "client/gl/shaders.h"

namespace platon::shaders {

const char* const kFaceGeometry = R"(
uniform vec2 edges[5];    // outward normals; a face with fewer edges repeats its last one
uniform float apothem;

float depthInFace(vec2 place) {
  float out0 = max(dot(place, edges[0]), dot(place, edges[1]));
  float out1 = max(dot(place, edges[2]), dot(place, edges[3]));
  return apothem - max(max(out0, out1), dot(place, edges[4]));
}
)";

const char* const kInk = R"(
in vec2 place;

// Coverage of the face: 1 inside, 0 outside, smooth over one pixel.
float inFace() {
  float depth = depthInFace(place);
  return clamp(depth / fwidth(depth) + 0.5, 0.0, 1.0);
}

vec4 over(vec4 below, vec3 colour, float alpha) {
  float sum = alpha + below.a * (1.0 - alpha);
  return vec4((colour * alpha + below.rgb * below.a * (1.0 - alpha)) / max(sum, 1e-4), sum);
}
)";

const char* const kFaceVertex = R"(
layout(location = 0) in vec2 corner;
uniform mat4 toClip;
out vec2 place;

void main() {
  place = corner;
  gl_Position = toClip * vec4(corner, 0, 1);
}
)";

const char* const kFaceFragment = R"(
in vec2 place;
uniform vec3 colour;
uniform vec3 eye;
uniform vec3 light;
uniform float gridStep;
out vec4 result;

float grid(vec2 at) {
  vec2 pixel = fwidth(at);
  vec2 line = 1.0 - min(abs(fract(at - 0.5) - 0.5) / pixel, 1.0);
  return max(line.x, line.y) * clamp(1.0 - 6.0 * max(pixel.x, pixel.y), 0.0, 1.0);
}

void main() {
  vec3 toEye = normalize(eye - vec3(place, 0));
  float depth = depthInFace(place);
  float lit = 0.66 + 0.38 * max(light.z, 0.0);
  float sheen = max(normalize(toEye + light).z, 0.0);
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen;
  float rim = 1.0 - toEye.z;
  rim *= rim * rim;
  vec3 shade = colour * lit * (0.80 + 0.20 * smoothstep(0.0, 0.35 * apothem, depth));
  shade += grid(place / gridStep) * 0.045;
  shade += vec3(1.0, 0.97, 0.92) * sheen * 0.09 + (colour + 0.25) * rim * 0.35;
  float bevel = 1.0 - smoothstep(0.0, max(3.0, 1.5 * fwidth(depth)), depth);
  shade = mix(shade, colour * (lit + 0.35) + 0.12, bevel * 0.8);
  result = vec4(shade, 1);
}
)";

const char* const kRibbonVertex = R"(
layout(location = 0) in vec4 ends;
uniform mat4 toClip;
uniform float reach;
out vec2 place;
out vec2 along;           // x: distance from the first end, y: distance across
flat out vec2 direction;
flat out float extent;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 way = ends.zw - ends.xy;
  extent = length(way);
  direction = extent > 0.0 ? way / extent : vec2(1, 0);
  along = vec2(mix(-reach, extent + reach, corner.x), mix(-reach, reach, corner.y));
  place = ends.xy + direction * along.x + vec2(-direction.y, direction.x) * along.y;
  gl_Position = toClip * vec4(place, 0, 1);
}
)";

const char* const kRibbonFragment = R"(
in vec2 along;
flat in vec2 direction;
flat in float extent;
uniform vec3 light;
uniform float halfWidth;
uniform float shadow;     // 1: draw the shadow, 0: draw the rod
out vec4 result;

void main() {
  float clip = inFace();
  vec2 off = vec2(along.x - clamp(along.x, 0.0, extent), along.y);
  float distance = length(off);
  float pixel = max(fwidth(along.y), 1e-4);
  float wide = max(halfWidth, 0.8 * pixel);
  if (shadow > 0.5) {
    float dark = exp(-max(distance - wide, 0.0) * 0.35) * 0.5;
    result = vec4(0.01, 0.01, 0.03, dark * clip);
    return;
  }
  vec2 tilt = off / wide;
  vec2 inPlane = direction * tilt.x + vec2(-direction.y, direction.x) * tilt.y;
  vec3 normal = normalize(vec3(inPlane, sqrt(max(1.0 - dot(tilt, tilt), 0.15))));
  float lit = 0.80 + 0.24 * max(dot(normal, light), 0.0);
  result = vec4(vec3(0.98, 0.96, 0.90) * lit, clamp((wide - distance) / pixel + 0.5, 0.0, 1.0) * clip);
}
)";

const char* const kMarkVertex = R"(
layout(location = 0) in vec4 ends;
layout(location = 1) in float width;
layout(location = 2) in vec4 colourOfMark;
uniform mat4 toClip;
out vec2 place;
out vec2 along;           // x: distance from the first end, y: distance across
flat out float extent;
flat out float halfWidth;
flat out vec4 colour;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 way = ends.zw - ends.xy;
  extent = length(way);
  halfWidth = width / 2.0;
  colour = colourOfMark;
  vec2 direction = extent > 0.0 ? way / extent : vec2(1, 0);
  float reach = halfWidth + 2.0;
  along = vec2(mix(-reach, extent + reach, corner.x), mix(-reach, reach, corner.y));
  place = ends.xy + direction * along.x + vec2(-direction.y, direction.x) * along.y;
  gl_Position = toClip * vec4(place, 0, 1);
}
)";

const char* const kMarkFragment = R"(
in vec2 along;
flat in float extent;
flat in float halfWidth;
flat in vec4 colour;
out vec4 result;

void main() {
  float distance = length(vec2(along.x - clamp(along.x, 0.0, extent), along.y));
  float pixel = max(fwidth(along.y), 1e-4);
  result = vec4(colour.rgb, colour.a * clamp((halfWidth - distance) / pixel + 0.5, 0.0, 1.0) * inFace());
}
)";

const char* const kMarkerVertex = R"(
uniform mat4 toClip;
uniform vec2 centre;
uniform float reach;
uniform float angle;
out vec2 place;
out vec2 at;              // offset from the centre in the marker's frame

void main() {
  at = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * reach;
  vec2 turn = vec2(cos(angle), sin(angle));
  place = centre + vec2(at.x * turn.x - at.y * turn.y, at.x * turn.y + at.y * turn.x);
  gl_Position = toClip * vec4(place, 0, 1);
}
)";

const char* const kMarkerFragment = R"(
in vec2 at;
uniform int kind;         // 0 goal, 1 start, 2 shadow
uniform float radius;
uniform float seconds;    // time of the animation
out vec4 result;

// Signed distance to a five-pointed star.
float star(vec2 p, float size) {
  const vec2 k1 = vec2(0.809016994, -0.587785252);
  const vec2 k2 = vec2(-0.809016994, -0.587785252);
  p.x = abs(p.x);
  p -= 2.0 * max(dot(k1, p), 0.0) * k1;
  p -= 2.0 * max(dot(k2, p), 0.0) * k2;
  p.x = abs(p.x);
  p.y -= size;
  vec2 side = 0.45 * vec2(-k1.y, k1.x) - vec2(0, 1);
  float part = clamp(dot(p, side) / dot(side, side), 0.0, size);
  return length(p - side * part) * sign(p.y * side.x - p.x * side.y);
}

// Coverage of a shape by its signed distance: 1 inside, 0 outside, smooth over one pixel.
float filled(float distance) { return clamp(0.5 - distance / fwidth(distance), 0.0, 1.0); }

vec4 goal(float r) {
  vec3 gold = vec3(1.0, 0.84, 0.36);
  float pulse = 0.5 + 0.5 * sin(seconds * 2.5);
  vec4 shade = vec4(gold, (0.45 + 0.15 * pulse) * exp(-abs(r - radius) * (0.11 - 0.02 * pulse)));
  shade = over(shade, vec3(0.10, 0.07, 0.03), 0.75 * filled(r - radius));
  float spin = atan(at.y, at.x) + seconds * 0.6;
  float rays = 0.5 + 0.5 * cos(spin * 8.0);
  shade = over(shade, gold, 0.5 * rays * filled(r - radius) * smoothstep(0.55, 1.0, r / radius));
  shade = over(shade, gold, filled(abs(r - radius) - 1.5));
  return over(shade, vec3(1.0, 0.95, 0.75), filled(star(at, radius * 0.62)));
}

vec4 start(float r) {
  float dashes = filled((abs(fract(atan(at.y, at.x) * 12.0 / 6.2831853) - 0.5) - 0.32) * 6.0);
  float ring = filled(abs(r - radius) - 0.9) * dashes;
  vec2 p = vec2(abs(at.x), at.y - radius * 0.25);
  float chevron = filled(abs(p.y + p.x * 0.9) - 1.6) * filled(p.x - radius * 0.42);
  return vec4(vec3(0.85, 0.92, 1.0), 0.65 * max(ring, chevron));
}

void main() {
  float r = length(at);
  if (kind == 0) result = goal(r);
  else if (kind == 1) result = start(r);
  else result = vec4(0.0, 0.0, 0.02, 0.55 * (1.0 - smoothstep(0.7 * radius, 1.5 * radius, r)));
  result.a *= inFace();
}
)";

const char* const kBallVertex = R"(
layout(location = 0) in vec3 point;
uniform mat4 toClip;
out vec3 normal;

void main() {
  normal = point;
  gl_Position = toClip * vec4(point, 1);
}
)";

const char* const kBallFragment = R"(
in vec3 normal;
uniform vec3 colour;
uniform vec3 outline;
uniform vec3 toEye;
uniform vec3 light;
uniform float opacity;
out vec4 result;

void main() {
  vec3 n = normalize(normal);
  float facing = dot(n, toEye);
  float lit = 0.52 + 0.55 * max(dot(n, light), 0.0);
  float gloss = pow(max(dot(n, normalize(light + toEye)), 0.0), 48.0);
  vec3 shade = colour * lit + gloss * 0.5;
  float edge = fwidth(facing);
  result = vec4(mix(outline, shade, smoothstep(0.47 - edge, 0.47 + edge, facing)), opacity);
}
)";

const char* const kBackgroundVertex = R"(
out vec2 screen;

void main() {
  screen = vec2((gl_VertexID & 1) * 4 - 1, (gl_VertexID >> 1) * 4 - 1);
  gl_Position = vec4(screen, 1, 1);
}
)";

const char* const kBackgroundFragment = R"(
in vec2 screen;
out vec4 result;

void main() {
  vec3 shade = mix(vec3(0.108, 0.130, 0.200), vec3(0.030, 0.036, 0.066), min(dot(screen, screen) * 0.5, 1.0));
  // Dithering by less than one colour step hides banding.
  float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  result = vec4(shade + (grain - 0.5) / 255.0, 1);
}
)";

const char* const kStarVertex = R"(
uniform mat4 toClip;      // applied to directions: w = 0
uniform float pixels;     // per unit of star size
out float glow;

float random(float seed) { return fract(sin(float(gl_VertexID) * 12.9898 + seed) * 43758.5453); }

void main() {
  float z = random(1.0) * 2.0 - 1.0;
  float turn = random(2.0) * 6.2831853;
  float size = random(3.0);
  gl_Position = toClip * vec4(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z, 0);
  gl_Position.z = gl_Position.w;
  gl_PointSize = pixels * (1.5 + 2.0 * size * size);
  glow = 0.15 + 0.55 * size * size;
}
)";

const char* const kStarFragment = R"(
in float glow;
out vec4 result;

void main() {
  float away = length(gl_PointCoord - 0.5);
  result = vec4(0.82, 0.90, 1.0, glow * smoothstep(0.5, 0.1, away));
}
)";

const char* const kTextVertex = R"(
layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 inAtlas;
layout(location = 2) in vec4 colourOfGlyph;
uniform mat4 toClip;
out vec2 texel;
out vec4 colour;

void main() {
  texel = inAtlas;
  colour = colourOfGlyph;
  gl_Position = toClip * vec4(corner, 0, 1);
}
)";

const char* const kTextFragment = R"(
in vec2 texel;
in vec4 colour;
uniform sampler2D atlas;
uniform float halo;       // opacity of the dark outline around the letters
out vec4 result;

void main() {
  float distance = texture(atlas, texel).r - 0.502;
  float pixel = max(fwidth(distance), 1e-4);
  float letter = clamp(distance / pixel + 0.5, 0.0, 1.0);
  float dark = halo * smoothstep(-0.36, -0.08, distance);
  float alpha = letter + dark * (1.0 - letter);
  result = vec4(colour.rgb * letter / max(alpha, 1e-4), alpha * colour.a);
}
)";

const char* const kPanelVertex = R"(
layout(location = 0) in vec2 corner;
layout(location = 1) in vec2 fromMiddle;
layout(location = 2) in vec3 form;        // half width, half height, corner radius
layout(location = 3) in vec4 colourOfPanel;
uniform mat4 toClip;
out vec2 at;
flat out vec3 box;
flat out vec4 colour;

void main() {
  at = fromMiddle;
  box = form;
  colour = colourOfPanel;
  gl_Position = toClip * vec4(corner, 0, 1);
}
)";

const char* const kPanelFragment = R"(
in vec2 at;
flat in vec3 box;
flat in vec4 colour;
out vec4 result;

void main() {
  vec2 beyond = abs(at) - box.xy + box.z;
  float distance = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - box.z;
  result = vec4(colour.rgb, colour.a * clamp(0.5 - distance / fwidth(at.x), 0.0, 1.0));
}
)";

}  // namespace platon::shaders
