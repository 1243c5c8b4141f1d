// Fixed random numbers and point sets.
#include "mesh/support.h"

#include "base/scramble.h"

#include <algorithm>

namespace isoscope::test {

namespace {

void shuffle(std::vector<Vec3>& points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

} // namespace

std::uint64_t Random::next() {
  state_ += golden_step;
  return scrambled(state_);
}

Vec3 Random::in(const Box3& box) {
  const Vec3 e = box.extent();
  const double x = uniform(), y = uniform(), z = uniform();
  return {box.lo.x + x * e.x, box.lo.y + y * e.y, box.lo.z + z * e.z};
}

std::vector<Vertex> box_corners(const Box3& box) {
  std::vector<Vertex> corners;
  for (int i = 0; i < 8; ++i) {
    const Vec3 p{i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z};
    corners.push_back({p, 1.0, VertexKind::box, true, 0, {}});
  }
  return corners;
}

std::vector<Vec3> random_points(std::size_t n, const Box3& box, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = random.in(box);
  return points;
}

std::vector<Vec3> lattice_points(int n, std::uint64_t seed) {
  std::vector<Vec3> points;
  for (int i = 0; i < n * n * n; ++i)
    points.push_back({double(i % n), double(i / n % n), double(i / (n * n))});
  shuffle(points, seed);
  return points;
}

std::vector<Vec3> cospherical_points(std::uint64_t seed) {
  std::vector<Vec3> points;
  for (int x = -25; x <= 25; ++x) {
    for (int y = -25; y <= 25; ++y) {
      for (int z = -25; z <= 25; ++z) {
        if (x * x + y * y + z * z == 625) points.push_back({double(x), double(y), double(z)});
      }
    }
  }
  shuffle(points, seed);
  return points;
}

Grown::Grown(const Box3& box) {
  deltas.push_back(delaunay.start(box_corners(box)));
  complex.apply(deltas.back());
}

bool Grown::insert(Vec3 p, double value) {
  auto delta = delaunay.insert({p, value, VertexKind::sample, true, 0, {}}, some_tet());
  if (!delta) {
    ++refused;
    return false;
  }
  complex.apply(*delta);
  deltas.push_back(std::move(*delta));
  return true;
}

TetId Grown::some_tet() const {
  return deltas.back().added.front().id;
}

Grown grow(const Box3& box, const std::vector<Vec3>& points, const std::function<double(Vec3)>& label) {
  Grown g(box);
  for (const Vec3 p : points) g.insert(p, label(p));
  return g;
}

Complex lattice_with_sides(int n, const std::function<int(Vec3)>& side,
                           const std::function<bool(Vec3)>& is_dropped) {
  const double end = n - 1 + 9;
  Complex c = grow({{-9, -9, -9}, {end, end, end}}, lattice_points(n, 3)).complex;
  c.form = ZeroForm::embedded;
  for (Vertex& v : c.vertices) v.value = 1;
  for (std::size_t t = 0; t < c.tets.size(); ++t) {
    if (!c.tets[t].alive()) continue;
    const auto p = c.positions(TetId(t));
    c.tets[t].side = static_cast<std::int8_t>(side(0.25 * (p[0] + p[1] + p[2] + p[3])));
  }
  for (Tet& t : c.tets) {
    if (!t.alive()) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!t.neighbor[k].valid() || c.tet(t.neighbor[k]).side == t.side) continue;
      auto f = t.facet(k);
      std::sort(f.begin(), f.end()); // from both sides the same centroid to the bit
      for (const VertexId v : f) c.vertices[v.index()].value = 0;
      if (is_dropped(centroid({c.position(f[0]), c.position(f[1]), c.position(f[2])})))
        t.dropped = static_cast<std::uint8_t>(t.dropped | 1u << k);
    }
  }
  return c;
}

} // namespace isoscope::test
