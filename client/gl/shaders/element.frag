#include "ink.glsl"
in vec2 at;
flat in vec2 direction;
flat in float extent;
flat in vec2 towards;
flat in int kind;
flat in float state;
uniform float lit;
uniform vec2 up;                          // the direction in which flags, keys and numbers stand upright
uniform float width;
out vec4 result;

const vec3 kWall = vec3(0.98, 0.96, 0.90);
const vec3 kBlue = vec3(0.52, 0.78, 1.0);
const vec3 kRed = vec3(1.0, 0.38, 0.27);
const vec3 kTeal = vec3(0.36, 0.92, 0.86);
const vec3 kGold = vec3(1.0, 0.80, 0.36);
const vec3 kViolet = vec3(0.80, 0.58, 1.0);
const vec3 kGreen = vec3(0.62, 0.96, 0.66);
const vec3 kDark = vec3(0.03, 0.03, 0.06);

// What follows are signed distances in widths; `thick` is half a thickness.
float pixel;

float rod(vec2 p, vec2 a, vec2 b, float thick) {
  vec2 way = b - a;
  float share = clamp(dot(p - a, way) / max(dot(way, way), 1e-6), 0.0, 1.0);
  return length(p - a - way * share) - max(thick, 0.8 * pixel);
}

float line(float aside, float thick) { return rod(at, vec2(0, aside), vec2(extent, aside), thick); }

// The middle of the nearest of the places that divide the segment evenly, about `gap` apart.
float nearest(float gap) {
  float count = max(1.0, floor(extent / gap));
  return (clamp(floor(at.x / extent * count), 0.0, count - 1.0) + 0.5) * extent / count;
}

float dashes(float gap, float share, float thick) {
  float reach = max(min(gap, extent) * share / 2.0 - thick, 0.0);
  float middle = nearest(gap);
  return rod(at, vec2(middle - reach, 0), vec2(middle + reach, 0), thick);
}

float triangle(vec2 p, vec2 a, vec2 b, vec2 c) {
  vec2 ab = b - a, bc = c - b, ca = a - c;
  float side = sign(ab.x * bc.y - ab.y * bc.x);
  vec2 pa = p - a, pb = p - b, pc = p - c;
  float d = min(min(rod(p, a, b, 0.0), rod(p, b, c, 0.0)), rod(p, c, a, 0.0)) + 0.8 * pixel;
  float inside = min(min(side * (ab.x * pa.y - ab.y * pa.x), side * (bc.x * pb.y - bc.y * pb.x)),
                     side * (ca.x * pc.y - ca.y * pc.x));
  return inside > 0.0 ? -d : d;
}

vec4 ink = vec4(0);

void paint(float distance, vec3 colour, float alpha) {
  ink = over(ink, colour, alpha * clamp(0.5 - distance / pixel, 0.0, 1.0));
}
void shadow(float distance, float alpha) { ink = over(ink, kDark, alpha * exp(-1.3 * max(distance, 0.0))); }
void glow(float distance, vec3 colour, float alpha) { ink = over(ink, colour, alpha * exp(-0.9 * max(distance, 0.0))); }

// Chevrons that lie flat point through the ledge, from the side from which it lets pass.
float chevrons(float head) {
  float middle = nearest(7.0);
  vec2 tip = vec2(middle, head);
  return min(rod(at, tip + vec2(-1.7, -1.5), tip, 0.36), rod(at, tip + vec2(1.7, -1.5), tip, 0.36));
}

void oneway() {
  float fall = clamp(1.0 + at.y / 7.0, 0.0, 1.0) * step(at.y, 0.0);
  float within = smoothstep(-0.6, 0.6, min(at.x, extent - at.x));
  ink = vec4(kWall, 0.30 * fall * fall * within);
  paint(chevrons(-1.7), kWall, 0.95);
  paint(chevrons(-3.9), kWall, 0.50);
}

// What blocks is filled, what lets pass is hollow: the blocks, which are walls only while they block, and the arrows.
void upwards() {
  float outline = max(0.25, 0.8 * pixel);
  paint(abs(dashes(4.0, 0.66, 0.5)) - outline, kBlue, 0.7 * (1.0 - state));
  vec2 aim = vec2(dot(towards, direction), dot(towards, vec2(-direction.y, direction.x)));
  vec2 aside = vec2(-aim.y, aim.x);
  vec2 head = vec2(nearest(24.0), 0) + 4.0 * aim;
  vec2 back = head - 3.0 * aim;
  float arrow = min(rod(at, head - 7.0 * aim, back, 0.7), triangle(at, head, back + 2.2 * aside, back - 2.2 * aside));
  paint(arrow - 0.6, kDark, 0.75);
  paint(arrow, kBlue, state);
  paint(abs(arrow) - outline, kBlue, 1.0);
}

void hazard() {
  float band = rod(at, vec2(0), vec2(extent, 0), 1.6);
  shadow(band, 0.55);
  glow(band, kRed, 0.25);
}

void checkpoint(vec2 p) {
  float flag = triangle(p, vec2(0, 8.6), vec2(5.4, 6.5), vec2(0, 4.4));
  float pole = rod(p, vec2(0), vec2(0, 8.6), 0.35);
  float ground = dashes(2.4, 0.62, 0.4);
  float all = min(min(flag, pole), ground);
  shadow(all, 0.5);
  glow(all, kTeal, 0.4 * state);
  paint(ground, kTeal, mix(0.75, 1.0, state));
  paint(flag, kTeal, state);
  paint(abs(flag) - max(0.3, 0.8 * pixel), kTeal, 1.0);
  paint(pole, mix(kTeal, vec3(1), 0.4), 1.0);
}

void key(vec2 p) {
  float badge = rod(p, vec2(-4.6, 0), vec2(4.6, 0), 3.4);
  float dots = rod(at, vec2(nearest(2.0), 0), vec2(nearest(2.0), 0), 0.4);
  float bow = abs(length(p - vec2(-4.4, 0)) - 1.5) - max(0.45, 0.8 * pixel);
  float bit = min(rod(p, vec2(-2.9, 0), vec2(1.2, 0), 0.45), rod(p, vec2(1.2, 0), vec2(1.2, -1.7), 0.45));
  bit = min(bit, rod(p, vec2(-0.4, 0), vec2(-0.4, -1.4), 0.45));
  shadow(min(badge, dots), 0.4);
  glow(badge, kGold, 0.3);
  paint(dots, kGold, 0.9);
  paint(badge, kDark, 0.82);
  paint(min(bow, bit), kGold, 1.0);
}

void door(vec2 p) {
  float badge = length(p) - 4.2;
  paint(dashes(4.0, 0.3, 0.2), kGold, 0.3 * (1.0 - state));
  paint(badge, kDark, mix(0.35, 0.9, state));
  paint(abs(badge) - max(0.3, 0.8 * pixel), kGold, state);
}

void plate() {
  float badge = length(at - vec2(extent / 2.0, 6.2)) - 3.4;
  float high = mix(1.6, 0.7, state);
  float bar = rod(at, vec2(0.15 * extent + high, high), vec2(0.85 * extent - high, high), 1.0);
  shadow(badge, 0.35);
  glow(bar, kViolet, 0.55 * state);
  paint(badge, kDark, 0.82);
}

// The hand goes round once in each state. What it has left behind is empty while the segment is solid, and full while it
// is open.
void timed(vec2 p) {
  float badge = length(p) - 4.2;
  float turn = atan(p.x, p.y) / 6.2831853;
  turn += turn < 0.0 ? 1.0 : 0.0;
  float full = towards.x;
  float hand = 1.0 - full;
  float within = state > 0.5 ? step(hand, turn) : step(turn, full);
  paint(dashes(2.0, 0.4, 0.3), kGreen, 0.45 * (1.0 - state));
  paint(badge, kDark, mix(0.6, 0.9, state));
  paint(length(p) - 3.2, kGreen, within * mix(0.45, 1.0, state));
  paint(abs(badge) - max(0.35, 0.8 * pixel), kGreen, 1.0);
}

void main() {
  pixel = max(fwidth(at.y), 1e-4);
  vec2 fromMiddle = (at.x - extent / 2.0) * direction + at.y * vec2(-direction.y, direction.x);
  vec2 p = vec2(dot(fromMiddle, vec2(up.y, -up.x)), dot(fromMiddle, up));
  switch (kind) {
    case kind_oneway: oneway(); break;
    case kind_up: upwards(); break;
    case kind_hazard: hazard(); break;
    case kind_checkpoint: checkpoint(p); break;
    case kind_key: key(p); break;
    case kind_door: door(p); break;
    case kind_plate: plate(); break;
    case kind_timed: timed(p); break;
  }
  result = vec4(ink.rgb * lit, ink.a * inFace());
}
