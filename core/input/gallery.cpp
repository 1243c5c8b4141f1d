// The list of bundled models and how each is put together.
#include "input/gallery.h"

#include "input/gallery_shapes.h"

#include <array>

namespace isoscope {

namespace {

constexpr std::array<GalleryEntry, 19> entries{{
    {"bracket", "Angle bracket",
     "Long thin triangles, sharp edges and drilled holes do not matter: only the volume around them does, "
     "and refinement "
     "finds all three holes.",
     2.0, -4},
    {"knot", "Trefoil knot",
     "The zero set is tied into the same knot as the input, which no count of components and holes could "
     "tell apart "
     "from a ring: isotopy is more than topology.",
     1.5, 0},
    {"sphere", "Sphere",
     "The simplest case: watch how the first insertions turn a box into a ball, and how the margin α decides "
     "when to stop.",
     4.0, 2},
    {"torus", "Torus",
     "A single tunnel: the moment at which the zero set opens it is one step of the journal.", 3.0, 0},
    {"double-torus", "Double torus",
     "Two tunnels open one after the other, and the Euler characteristic counts them.", 3.0, -2},
    {"nested-spheres", "Nested spheres",
     "The tolerance volume has two parts and four boundaries: labels follow the regions between them, not "
     "the nearest "
     "surface.",
     2.0, 4, 0, 0, 0, true},
    {"rings", "Interlocked rings",
     "Two thin rings hook into each other without touching: their zero sets stay separate and stay linked.",
     1.0, 0},
    {"blob", "Bumpy blob",
     "Curvature varies, and so does the density of the insertions: bumps ask for more than hollows.", 2.5, 2},
    {"top", "Spinning top",
     "Disc and stem are thinner than 2δ: of their inside Ω leaves nothing, so the refinement goes into them "
     "and points are held there, or Z would end where the body does.",
     3.0, 2},
    {"soup", "Torn torus",
     "Gaps, overlaps, flipped and double triangles vanish inside the tolerance volume: only where it closes "
     "matters.",
     4.0, 0},
    {"noisy-sphere", "Noisy sphere",
     "Points with 1 % of noise and a few outliers: each is averaged with its neighbours, and Ω encloses the "
     "inside from some tolerance on, which the diagram of tolerances shows.",
     6.0, 2},
    {"scan", "Scan with a gap",
     "A ring of points with a slit and outliers: the tolerance closes the slit, and a blob that encloses "
     "nothing is left out.",
     5.5, 0},
    {"nested-tori", "Between two tori",
     "The volume itself is given, by its two walls: wide on one side and narrow on the other, and the zero "
     "set takes the room that there is.",
     0, 0},
    {"two-rooms", "Two rooms",
     "A wall divides a box: three regions have labels of their own, and their sheets meet in one closed "
     "curve.",
     4.0, 3, 0, 0, 0, true},
    {"bubbles", "Soap bubbles",
     "Four bubbles share walls: sheets meet in curves of three, and the curves of four rooms in one point.",
     4.0, 5, 0, 0, 0, true},
    {"density", "A ring of beads",
     "A grid of densities, as a scan is one: the zero set runs between two of its levels, and nothing else "
     "was ever a surface.",
     0, 0, density_low, density_high},
    {"hemisphere", "Hemisphere",
     "An open surface: samples over its rim belong to no side, and the zero set, which goes on beyond it, is "
     "cut there.",
     3.0, 1, 0, 0, 1},
    {"range-scan", "Range scan",
     "What a scanner sees from one place, with holes behind three knobs: each is kept, or filled between the "
     "vertices of its border.",
     3.0, -2, 0, 0, 4},
    {"half-scan", "Points from one side",
     "The same as points, with noise: nothing says where they end but balls, in which the samples around the "
     "sheet hang together there.",
     4.0, -2, 0, 0, 4},
}};

TriangleSoup make_nested_spheres() {
  TriangleSoup model = make_sphere(3);
  TriangleSoup inner = make_sphere(3);
  for (Vec3& p : inner.points) p = 0.6 * p;
  turn_inside_out(inner);
  append(model, inner);
  return model;
}

TriangleSoup make_rings() {
  TriangleSoup model = make_torus(1, 0.12, 72, 16);
  TriangleSoup other = model;
  for (Vec3& p : other.points) p = {p.x + 1, -p.z, p.y}; // stands upright, through the middle of the first
  append(model, other);
  return model;
}

TriangleSoup make_torn_scan() {
  const auto in_slit = [](Vec3 p) { return p.x > 0 && p.y > -0.04 && p.y < 0.04; };
  TriangleSoup scan = make_scan(make_torus(1, 0.45, 64, 32), 9000, 0.01, 200, in_slit);
  TriangleSoup blob = make_sphere(2);
  for (const Vec3 p : blob.points) scan.points.push_back(Vec3{1.4, 1.4, 0.4} + 0.08 * p);
  return scan;
}

TriangleSoup make_blob() {
  TriangleSoup model = make_sphere(4);
  const auto chebyshev4 = [](double t) { return 8 * t * t * t * t - 8 * t * t + 1; };
  for (Vec3& p : model.points) {
    const double bumps = chebyshev4(p.x) * chebyshev4(p.y) + chebyshev4(p.z);
    p = (1 + 0.13 * bumps + 0.1 * p.x * p.y) * p;
  }
  return model;
}

} // namespace

std::span<const GalleryEntry> gallery() {
  return entries;
}

std::string gallery_input(std::string_view name) {
  return std::string(gallery_prefix) + std::string(name);
}

const GalleryEntry* gallery_entry(std::string_view input) {
  for (const GalleryEntry& e : entries)
    if (input.starts_with(gallery_prefix) && input.substr(gallery_prefix.size()) == e.name) return &e;
  return nullptr;
}

Result<TriangleSoup> make_gallery_model(std::string_view name) {
  TriangleSoup model;
  if (name == "bracket")
    model = make_bracket(48);
  else if (name == "knot")
    model = make_trefoil(0.42, 216, 20);
  else if (name == "sphere")
    model = make_sphere(3);
  else if (name == "torus")
    model = make_torus(1, 0.4, 64, 32);
  else if (name == "double-torus")
    model = make_double_torus(3);
  else if (name == "nested-spheres")
    model = make_nested_spheres();
  else if (name == "rings")
    model = make_rings();
  else if (name == "blob")
    model = make_blob();
  else if (name == "top")
    model = make_spinning_top(48);
  else if (name == "soup")
    model = make_defective(make_torus(1, 0.4, 64, 32), 0.008);
  else if (name == "noisy-sphere")
    model = make_scan(make_sphere(3), 6000, 0.02, 180, {});
  else if (name == "scan")
    model = make_torn_scan();
  else if (name == "nested-tori")
    model = make_nested_tori();
  else if (name == "two-rooms")
    model = make_two_rooms();
  else if (name == "bubbles")
    model = make_bubbles();
  else if (name == "density")
    model = make_density();
  else if (name == "hemisphere")
    model = make_hemisphere(24);
  else if (name == "range-scan")
    model = make_range_scan(100);
  else if (name == "half-scan")
    model = make_scan(make_range_scan(100), 12000, 0.006, 0, {});
  else {
    std::string names;
    for (const GalleryEntry& e : entries) names += (names.empty() ? "" : ", ") + std::string(e.name);
    return Error{ErrorCode::bad_input, "There is no bundled model of this name.",
                 "There are: " + names + "."};
  }
  model.name = name;
  return model;
}

} // namespace isoscope
