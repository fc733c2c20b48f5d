layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 colour;
layout(location = 3) in vec2 aside;       // of a corner of a top: the way from the axis of the wall, at any scale
uniform mat4 toClip;
uniform vec3 eye;
uniform vec3 light;
uniform vec3 ground;      // colour of the face
uniform float lit;
uniform vec2 pixels;      // half the size of the picture
uniform float asideScale; // level units per unit of `aside`
uniform vec2 up;          // of the ball on the face, as long as floors are bright: 0 … 1
out vec3 shade;

const vec3 kFloor = vec3(1.0, 0.72, 0.20);
const float kLeast = 0.52; // half the least width of a top, pixels

// How a point at `clip` moves on the picture when it goes this way on the face.
vec2 moved(vec4 clip, vec2 way) {
  vec4 change = toClip * vec4(way, 0, 0);
  return (change.xy - clip.xy * change.w / clip.w) / clip.w * pixels;
}

// A top that is seen almost from the side would be thinner than a pixel and break into dashes. It is widened on the
// picture, and drawn before the side below it.
vec4 widened(vec4 clip) {
  vec2 way = aside * asideScale;
  vec2 along = moved(clip, vec2(-way.y, way.x));
  vec2 across = vec2(-along.y, along.x) / max(length(along), 1e-6);
  float wide = dot(moved(clip, way), across);
  float lack = max(kLeast - abs(wide), 0.0);
  vec4 nearer = toClip * vec4(place + normalize(eye - place) * (12.0 * lack), 1);
  clip.z = nearer.z / nearer.w * clip.w;
  clip.xy += across * (wide < 0.0 ? -lack : lack) / pixels * clip.w;
  return clip;
}

// As a top turns away, it comes near to the colour of the sides.
float brightnessOfTop(float facing) { return mix(0.4, 1.0, smoothstep(0.0, 0.12, facing)); }

// As a face turns away, its walls come near to its colour: they lean out past its edges, where they would look like grey
// plates that belong to nothing.
float shareOfWall(float facing) { return mix(0.15, 1.0, smoothstep(0.0, 0.55, facing)); }

// How much of the tint a wall has: all if it is level or a slope on which a ball can stand, nothing on steep ones. The
// top of a wall has the tint of its side that is turned up.
float shareOfFloor() {
  vec2 across = aside == vec2(0) ? normal.xy : normalize(aside);
  float rise = dot(across, up);
  return smoothstep(0.60, 0.72, aside == vec2(0) ? rise : abs(rise));
}

void main() {
  float sun = max(dot(normal, light), 0.0);
  float facing = normalize(eye - place).z;
  float share = (0.26 + 0.62 * sun) * shareOfWall(facing);
  vec3 side = mix(ground * 0.80, colour, share) * (place.z > 0.0 ? 1.0 : 0.70);
  gl_Position = toClip * vec4(place, 1);
  float top = step(0.9, normal.z);
  if (top > 0.0) top = brightnessOfTop(facing);
  if (aside != vec2(0)) gl_Position = widened(gl_Position);
  shade = mix(mix(side, colour, top), kFloor, shareOfFloor()) * lit;
}
