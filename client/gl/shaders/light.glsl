// The light map: 1 where nothing shades the face, 0 in the darkest shadow.
uniform sampler2DArray lightMap;
uniform float layer;
uniform float lightScale;

float lightAt(vec2 place) { return texture(lightMap, vec3(place * lightScale + 0.5, layer)).r; }
