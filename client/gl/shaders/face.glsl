// The face that is drawn on, in its frame.
uniform vec2 edges[5];    // outward normals; a face with fewer edges repeats its last one
uniform float apothem;

float depthInFace(vec2 place) {
  float out0 = max(dot(place, edges[0]), dot(place, edges[1]));
  float out1 = max(dot(place, edges[2]), dot(place, edges[3]));
  return apothem - max(max(out0, out1), dot(place, edges[4]));
}
