// φ/δ from the bricks of a distance grid: the lattice is divided into places, and those that Ω comes near to have a brick.
uniform usampler3D places;     // by place: its brick with the top bit, or how many places around it may be crossed
uniform sampler3D bricks;      // φ over its largest value; with the sign of its side, where is_signed is 1
uniform sampler3D brick_sides; // +1 or -1, where is_signed is 0
uniform int is_signed;
uniform float largest_value;
uniform vec3 box_lo, box_hi;
uniform float place_side;      // scene units
uniform vec3 place_count;
uniform vec3 atlas_size;       // of `bricks`, in samples

vec3 in_places(vec3 p) { return (p - box_lo) / place_side; }
// The place that holds a point; of one on the box's rim the outermost.
vec3 place_at(vec3 q) { return clamp(floor(q), vec3(0.0), place_count - 1.0); }
uint entry_at(vec3 q) { return texelFetch(places, ivec3(place_at(q)), 0).r; }
bool is_full(uint entry) { return (entry & 0x80000000u) != 0u; }

// Where in the texture a point of a full place is: its brick has 8 samples a side, at the corners of 7 cells.
vec3 in_atlas(vec3 q, uint entry) {
  uvec3 brick = uvec3(entry & 127u, (entry >> 7) & 127u, (entry & 0x7fffffffu) >> 14);
  return (8.0 * vec3(brick) + 0.5 + 7.0 * clamp(q - place_at(q), 0.0, 1.0)) / atlas_size;
}
float value_in(vec3 q, uint entry) { return largest_value * textureLod(bricks, in_atlas(q, entry), 0.0).r; }
// Of what is signed anyway 1. Software drivers fetch in branches that are not taken: only who needs it asks.
#ifdef TWO_SIDED
float side_in(vec3 q, uint entry) { return textureLod(brick_sides, in_atlas(q, entry), 0.0).r < 0.0 ? -1.0 : 1.0; }
#else
float side_in(vec3 q, uint entry) { return 1.0; }
#endif
float value_at(vec3 p) {
  vec3 q = in_places(p);
  return value_in(q, entry_at(q));
}
