// A strip along a segment, of four vertices.
struct Strip {
  vec2 direction;  // of the segment
  float extent;    // length of the segment
  vec2 at;         // this vertex, from the first end: x along, y to the left
  vec2 place;      // this vertex
};

// `reach`: beyond the ends, to each side.
Strip stripAlong(vec4 ends, vec2 reach) {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vec2 way = ends.zw - ends.xy;
  Strip strip;
  strip.extent = length(way);
  strip.direction = strip.extent > 0.0 ? way / strip.extent : vec2(1, 0);
  strip.at = vec2(mix(-reach.x, strip.extent + reach.x, corner.x), mix(-reach.y, reach.y, corner.y));
  strip.place = ends.xy + strip.direction * strip.at.x + vec2(-strip.direction.y, strip.direction.x) * strip.at.y;
  return strip;
}
