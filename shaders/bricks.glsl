// φ/δ from the bricks of a distance grid: the lattice is divided into places, and each has a brick; those that Ω does not come
// near to share one of one value.
uniform usampler3D places;     // by place: where its brick is, and how many places around it may be crossed
uniform sampler3D bricks;      // φ over its largest value; with the sign of its side, where is_signed is 1
uniform sampler3D brick_sides; // +1 or -1, where is_signed is 0
uniform int is_signed;
uniform float largest_value;
uniform vec3 box_lo, box_hi;
uniform float place_side;      // scene units
uniform vec3 place_count;
uniform vec3 atlas_unit;       // one sample of `bricks`, in its texture coordinates

vec3 in_places(vec3 p) { return (p - box_lo) / place_side; }
// The place that holds a point; of one on the box's rim the outermost.
vec3 place_at(vec3 q) { return clamp(floor(q), vec3(0.0), place_count - 1.0); }
uint entry_at(vec3 place) { return texelFetch(places, ivec3(place), 0).r; }
// How many places, this one included, a ray may cross in any direction; 0 where it may meet Ω.
float free_places(uint entry) { return float(entry >> 18); }

// Where in the texture a point of a place is: its brick has 8 samples a side, at the corners of 7 cells, so that what is read
// between samples never leaves it.
vec3 in_atlas(vec3 q, vec3 place, uint entry) {
  vec3 brick = vec3(uvec3(entry, entry >> 2, entry >> 10) & uvec3(3u, 255u, 255u));
  return (8.0 * brick + 0.5 + 7.0 * clamp(q - place, 0.0, 1.0)) * atlas_unit;
}
float value_in(vec3 q, vec3 place, uint entry) { return largest_value * textureLod(bricks, in_atlas(q, place, entry), 0.0).r; }
float value_at(vec3 q) {
  vec3 place = place_at(q);
  return value_in(q, place, entry_at(place));
}
// Of what is signed anyway 1. Software drivers fetch in branches that are not taken: only who needs it asks.
#ifdef TWO_SIDED
float side_at(vec3 q) {
  vec3 place = place_at(q);
  return textureLod(brick_sides, in_atlas(q, place, entry_at(place)), 0.0).r < 0.0 ? -1.0 : 1.0;
}
#else
float side_at(vec3 q) { return 1.0; }
#endif
