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


#ifdef DETAIL
// A part of Ω in finer voxels: which of the two lattices is read, whoever reads chooses before.
uniform usampler3D detail_places;
uniform sampler3D detail_bricks, detail_brick_sides;
uniform float detail_largest_value;
uniform vec3 detail_box_lo, detail_box_hi;
uniform float detail_place_side;
uniform vec3 detail_place_count, detail_atlas_unit;
bool in_detail = false;
// Gradients look less than two voxels aside.
float detail_rim() { return 2.0 / 7.0 * detail_place_side; }
void choose_grid(vec3 p) {
  in_detail = all(greaterThan(p, detail_box_lo + detail_rim())) && all(lessThan(p, detail_box_hi - detail_rim()));
}
float side_of_place() { return in_detail ? detail_place_side : place_side; }
vec3 in_places(vec3 p) { return in_detail ? (p - detail_box_lo) / detail_place_side : (p - box_lo) / place_side; }
vec3 last_place() { return (in_detail ? detail_place_count : place_count) - 1.0; }
uint entry_at(vec3 place) {
  return in_detail ? texelFetch(detail_places, ivec3(place), 0).r : texelFetch(places, ivec3(place), 0).r;
}
vec3 unit_of_atlas() { return in_detail ? detail_atlas_unit : atlas_unit; }
float read_brick(vec3 at) {
  return in_detail ? detail_largest_value * textureLod(detail_bricks, at, 0.0).r : largest_value * textureLod(bricks, at, 0.0).r;
}
float read_side(vec3 at) { return in_detail ? textureLod(detail_brick_sides, at, 0.0).r : textureLod(brick_sides, at, 0.0).r; }
#else
void choose_grid(vec3 p) {}
float side_of_place() { return place_side; }
vec3 in_places(vec3 p) { return (p - box_lo) / place_side; }
vec3 last_place() { return place_count - 1.0; }
uint entry_at(vec3 place) { return texelFetch(places, ivec3(place), 0).r; }
vec3 unit_of_atlas() { return atlas_unit; }
float read_brick(vec3 at) { return largest_value * textureLod(bricks, at, 0.0).r; }
float read_side(vec3 at) { return textureLod(brick_sides, at, 0.0).r; }
#endif

// The place that holds a point; of one on the box's rim the outermost.
vec3 place_at(vec3 q) { return clamp(floor(q), vec3(0.0), last_place()); }
// How many places, this one included, a ray may cross in any direction; 0 where it may meet Ω.
float free_places(uint entry) { return float(entry >> 24); }

// Where in the texture a point of a place is: its brick has 8 samples a side, at the corners of 7 cells, so that what is read
// between samples never leaves it.
vec3 in_atlas(vec3 q, vec3 place, uint entry) {
  vec3 brick = vec3(uvec3(entry, entry >> 8, entry >> 16) & 255u);
  return (8.0 * brick + 0.5 + 7.0 * clamp(q - place, 0.0, 1.0)) * unit_of_atlas();
}
float value_in(vec3 q, vec3 place, uint entry) { return read_brick(in_atlas(q, place, entry)); }
float value_at(vec3 q) {
  vec3 place = place_at(q);
  return value_in(q, place, entry_at(place));
}
// Of what is signed anyway 1. Software drivers fetch in branches that are not taken: only who needs it asks.
#ifdef TWO_SIDED
float side_at(vec3 q) {
  vec3 place = place_at(q);
  return read_side(in_atlas(q, place, entry_at(place))) < 0.0 ? -1.0 : 1.0;
}
#else
float side_at(vec3 q) { return 1.0; }
#endif
