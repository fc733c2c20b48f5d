#include "strip.glsl"
layout(location = 0) in vec4 ends;
layout(location = 1) in vec4 look;        // towards its edge (of up) or how full its clock is (of timed), kind, 1: active,
                                          // as in ElementStates
uniform mat4 toClip;
uniform float width;                      // of a segment
uniform float raised;                     // 0: what is flat, else what lies on walls of this height
out vec2 place;
out vec2 at;                              // from the first end, in widths: x along, y to the left
flat out vec2 direction;
flat out float extent;                    // in widths
flat out vec2 towards;
flat out int kind;
flat out float state;

// Half the size of what is drawn round the segment and round its middle, in widths.
const float kAside[kKinds] = float[kKinds](7.0, 6.0, 6.5, 4.0, 4.0, 4.0, 5.0, 4.0);
const float kRound[kKinds] = float[kKinds](0.0, 6.0, 0.0, 11.0, 11.0, 6.5, 11.0, 6.5);

void main() {
  towards = look.xy;
  kind = int(look.z);
  state = look.w;
  extent = distance(ends.xy, ends.zw) / width;
  float aside = max(kAside[kind], kRound[kind]);
  float beyond = max(kAside[kind], kRound[kind] - extent / 2.0);
  Strip strip = stripAlong(ends, width * vec2(beyond, aside));
  direction = strip.direction;
  at = strip.at / width;
  place = strip.place;
  bool taken = kind == kind_key && state < 0.5;
  bool onWalls = kind == kind_key || ((kind == kind_up || kind == kind_door || kind == kind_timed) && state > 0.5);
  bool drawn = !taken && onWalls == (raised > 0.0);
  gl_Position = drawn ? toClip * vec4(place, raised, 1) : vec4(0, 0, 0, 1);
}
