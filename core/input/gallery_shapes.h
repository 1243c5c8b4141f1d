// The shapes that the bundled models are made of: oriented outwards but for rooms, the same bits everywhere.
#pragma once

#include "input/triangle_soup.h"

#include <functional>

namespace isoscope {

/// The icosahedron subdivided `levels` times onto the unit sphere: 20·4^levels triangles.
TriangleSoup make_sphere(int levels);

/// A tube of circular cross-section around a closed curve. `frame(i)` gives the centre and two orthonormal
/// directions (u, v) across the curve at its i-th of `along` stations, so that cross(u, v) points along the
/// curve.
struct TubeFrame {
  Vec3 center, u, v;
};
TriangleSoup make_tube(int along, int around, double radius, const std::function<TubeFrame(int)>& frame);

/// The torus of centre circle radius `major` about the z axis and tube radius `minor`.
TriangleSoup make_torus(double major, double minor, int along, int around);

/// A plate of 5 × 3 × 1 cubes with two square holes, smoothed `levels` times by Catmull and Clark's
/// subdivision.
TriangleSoup make_double_torus(int levels);

/// A trefoil tied from a round tube.
TriangleSoup make_trefoil(double radius, int along, int around);

/// An angle bracket with a rounded lug, three drilled holes and sharp edges; `arc` segments a full circle, a
/// multiple of 4. Genus 3.
TriangleSoup make_bracket(int arc);

/// `model` taken apart as careless software would leave it: unwelded corners moved by up to `noise`,
/// triangles missing, enlarged, flipped and doubled.
TriangleSoup make_defective(const TriangleSoup& model, double noise);

/// `n` points evenly on a model, each moved by about normal noise of this size along each axis, then so many
/// anywhere around it; without those of the model for which `missing` holds.
TriangleSoup make_scan(const TriangleSoup& model, std::size_t n, double noise, std::size_t outliers,
                       const std::function<bool(Vec3)>& missing);

/// The upper half of the unit sphere, its border in the plane z = 0, as so many rings of triangles.
TriangleSoup make_hemisphere(int rings);

/// A body of revolution about the z axis with a disc and a stem that are thin, of so many segments around.
TriangleSoup make_spinning_top(int around);

/// A knobby ball as a scanner with so many rays along a side of its square sees it from one place, with holes
/// behind the knobs.
TriangleSoup make_range_scan(int rays);

/// The levels of make_density(), between which its ring of six beads is whole.
constexpr double density_low = 0.25, density_high = 0.5;

/// A torus and, inside of it, a thinner one that is not in its middle: two walls.
TriangleSoup make_nested_tori();

/// A grid: the density of six round beads that run into each other along a ring. With triangles of both
/// levels.
TriangleSoup make_density();

/// A box of two cubes with the wall between them: 11 squares that share no vertices.
TriangleSoup make_two_rooms();

/// Four equal soap bubbles that share walls.
TriangleSoup make_bubbles();

void append(TriangleSoup& to, const TriangleSoup& part);
void turn_inside_out(TriangleSoup& model);

} // namespace isoscope
