// Spheres, tubes, subdivision surfaces and the art of spoiling them.
#include "input/gallery_shapes.h"

#include "base/scramble.h"
#include "input/exact_circle.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace isoscope {

namespace {

using Index = std::uint32_t;
using Quad = std::array<Index, 4>;
using Edge = std::pair<Index, Index>;

Edge edge_of(Index a, Index b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

struct QuadMesh {
  std::vector<Vec3> points;
  std::vector<Quad> quads;
};

/// One step of Catmull and Clark's subdivision of a closed mesh.
QuadMesh subdivide(const QuadMesh& mesh) {
  QuadMesh fine;
  const std::size_t n = mesh.points.size();
  std::vector<Vec3> face_sum(n), neighbour_sum(n);
  std::vector<int> valence(n, 0);
  std::vector<Vec3> face_point;
  std::map<Edge, Vec3> edge_face_sum; // of the two faces beside the edge
  for (const Quad& q : mesh.quads) {
    Vec3 sum;
    for (const Index v : q) sum += mesh.points[v];
    face_point.push_back(0.25 * sum);
    for (std::size_t k = 0; k < 4; ++k) {
      edge_face_sum[edge_of(q[k], q[(k + 1) % 4])] += face_point.back();
      face_sum[q[k]] += face_point.back();
    }
  }
  for (const auto& [edge, sum] : edge_face_sum) {
    const auto [a, b] = edge;
    neighbour_sum[a] += mesh.points[b];
    neighbour_sum[b] += mesh.points[a];
    ++valence[a];
    ++valence[b];
  }
  for (std::size_t v = 0; v < n; ++v) {
    const double k = valence[v];
    // Mean of faces, twice mean of edge midpoints, (k - 3) times the vertex, divided by k.
    const Vec3 faces = face_sum[v] / k;
    const Vec3 midpoints = 0.5 * (mesh.points[v] + neighbour_sum[v] / k);
    fine.points.push_back((faces + 2.0 * midpoints + (k - 3) * mesh.points[v]) / k);
  }
  std::map<Edge, Index> edge_vertex;
  for (const auto& [edge, sum] : edge_face_sum) {
    edge_vertex[edge] = static_cast<Index>(fine.points.size());
    fine.points.push_back(0.25 * (mesh.points[edge.first] + mesh.points[edge.second] + sum));
  }
  for (std::size_t f = 0; f < mesh.quads.size(); ++f) {
    const Quad& q = mesh.quads[f];
    const auto center = static_cast<Index>(fine.points.size());
    fine.points.push_back(face_point[f]);
    for (std::size_t k = 0; k < 4; ++k)
      fine.quads.push_back({q[k], edge_vertex[edge_of(q[k], q[(k + 1) % 4])], center,
                            edge_vertex[edge_of(q[(k + 3) % 4], q[k])]});
  }
  return fine;
}

/// The outside of the unit cubes for which `solid` holds, within [0, nx) × [0, ny) × {0}.
QuadMesh plate_surface(int nx, int ny, const std::function<bool(int, int)>& solid) {
  QuadMesh mesh;
  std::map<std::array<int, 3>, Index> ids;
  const auto vertex = [&](std::array<int, 3> p) {
    const auto [place, fresh] = ids.try_emplace(p, static_cast<Index>(mesh.points.size()));
    if (fresh) mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return place->second;
  };
  for (int x = 0; x < nx; ++x) {
    for (int y = 0; y < ny; ++y) {
      if (!solid(x, y)) continue;
      const auto face = [&](std::array<std::array<int, 3>, 4> p) {
        mesh.quads.push_back({vertex(p[0]), vertex(p[1]), vertex(p[2]), vertex(p[3])});
      };
      face({{{x, y, 1}, {x + 1, y, 1}, {x + 1, y + 1, 1}, {x, y + 1, 1}}});
      face({{{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}}});
      if (!solid(x - 1, y)) face({{{x, y, 0}, {x, y, 1}, {x, y + 1, 1}, {x, y + 1, 0}}});
      if (!solid(x + 1, y)) face({{{x + 1, y, 0}, {x + 1, y + 1, 0}, {x + 1, y + 1, 1}, {x + 1, y, 1}}});
      if (!solid(x, y - 1)) face({{{x, y, 0}, {x + 1, y, 0}, {x + 1, y, 1}, {x, y, 1}}});
      if (!solid(x, y + 1)) face({{{x, y + 1, 0}, {x, y + 1, 1}, {x + 1, y + 1, 1}, {x + 1, y + 1, 0}}});
    }
  }
  return mesh;
}

void add_quad(TriangleSoup& model, Index a, Index b, Index c, Index d) {
  model.triangles.push_back({a, b, c});
  model.triangles.push_back({a, c, d});
}

/// Numerical Recipes' linear congruence: enough to spoil a model the same way everywhere.
class Noise {
 public:
  /// In [-1, 1).
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_) / 2147483648.0 - 1.0;
  }

 private:
  std::uint32_t state_ = 20150801u;
};

} // namespace

TriangleSoup make_sphere(int levels) {
  TriangleSoup model;
  const double g = (1 + std::sqrt(5.0)) / 2;
  for (const Vec3 p :
       {Vec3{-1, g, 0}, Vec3{1, g, 0}, Vec3{-1, -g, 0}, Vec3{1, -g, 0}, Vec3{0, -1, g}, Vec3{0, 1, g},
        Vec3{0, -1, -g}, Vec3{0, 1, -g}, Vec3{g, 0, -1}, Vec3{g, 0, 1}, Vec3{-g, 0, -1}, Vec3{-g, 0, 1}})
    model.points.push_back(normalized(p));
  model.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<Edge, Index> middle;
    const auto midpoint = [&](Index a, Index b) {
      const auto [place, fresh] = middle.try_emplace(edge_of(a, b), static_cast<Index>(model.points.size()));
      if (fresh) model.points.push_back(normalized(model.points[a] + model.points[b]));
      return place->second;
    };
    std::vector<std::array<Index, 3>> fine;
    for (const auto& [a, b, c] : model.triangles) {
      const Index ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      fine.insert(fine.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    model.triangles = std::move(fine);
  }
  return model;
}

TriangleSoup make_tube(int along, int around, double radius, const std::function<TubeFrame(int)>& frame) {
  TriangleSoup model;
  for (int i = 0; i < along; ++i) {
    const TubeFrame f = frame(i);
    for (int j = 0; j < around; ++j) {
      const CirclePoint c = circle_point(j, around);
      model.points.push_back(f.center + radius * (c.cosine * f.u + c.sine * f.v));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<Index>((i % along) * around + j % around); };
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j) add_quad(model, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
  return model;
}

TriangleSoup make_torus(double major, double minor, int along, int around) {
  return make_tube(along, around, minor, [&](int i) {
    const CirclePoint c = circle_point(i, along);
    const Vec3 outwards{c.cosine, c.sine, 0};
    return TubeFrame{major * outwards, outwards, Vec3{0, 0, -1}};
  });
}

TriangleSoup make_double_torus(int levels) {
  QuadMesh mesh = plate_surface(5, 3, [](int x, int y) {
    const bool hole = y == 1 && (x == 1 || x == 3);
    return x >= 0 && x < 5 && y >= 0 && y < 3 && !hole;
  });
  for (int i = 0; i < levels; ++i) mesh = subdivide(mesh);
  TriangleSoup model;
  model.points = mesh.points;
  for (const auto& [a, b, c, d] : mesh.quads) add_quad(model, a, b, c, d);
  return model;
}

TriangleSoup make_trefoil(double radius, int along, int around) {
  // The (2, 3) knot on the torus of radii 2 and 1, whose normal serves as the frame's first direction.
  return make_tube(along, around, radius, [&](int i) {
    const CirclePoint turn = circle_point(2 * i, along), roll = circle_point(3 * i, along);
    const double r = 2 + roll.cosine;
    const Vec3 outwards{turn.cosine, turn.sine, 0}, sideways{-turn.sine, turn.cosine, 0}, up{0, 0, 1};
    const Vec3 tangent = normalized(2 * r * sideways + 3.0 * (roll.cosine * up - roll.sine * outwards));
    const Vec3 normal = roll.cosine * outwards + roll.sine * up;
    return TubeFrame{r * outwards + roll.sine * up, normal, cross(tangent, normal)};
  });
}

TriangleSoup make_defective(const TriangleSoup& model, double noise) {
  TriangleSoup soup;
  Noise random;
  const auto add = [&](Triangle3 t, bool flipped) {
    const auto first = static_cast<Index>(soup.points.size());
    for (Vec3 p : t) {
      for (int i = 0; i < 3; ++i) p[i] += noise * random.next();
      soup.points.push_back(p);
    }
    if (flipped)
      soup.triangles.push_back({first, first + 2, first + 1});
    else
      soup.triangles.push_back({first, first + 1, first + 2});
  };
  for (std::size_t i = 0; i < model.triangles.size(); ++i) {
    if (i % 13 == 5) continue; // a gap
    Triangle3 t = model.triangle(i);
    if (i % 17 == 3) { // an overlap
      const Vec3 center = centroid(t);
      for (Vec3& p : t) p = center + 1.8 * (p - center);
    }
    add(t, random.next() < -0.4);
    if (i % 11 == 7) { // an exact double
      const auto& last = soup.triangles.back();
      soup.triangles.push_back({last[0], last[1], last[2]});
    }
  }
  return soup;
}

TriangleSoup make_hemisphere(int rings) {
  TriangleSoup model;
  const int around = 4 * rings;
  model.points.push_back({0, 0, 1});
  for (int i = 1; i <= rings; ++i) {
    const CirclePoint down = circle_point(i, 4L * rings);
    for (int k = 0; k < around; ++k) {
      const CirclePoint at = circle_point(k, around);
      model.points.push_back({down.sine * at.cosine, down.sine * at.sine, down.cosine});
    }
  }
  const auto point = [&](int i, int k) {
    return i == 0 ? Index{0} : static_cast<Index>(1 + (i - 1) * around + k % around);
  };
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < around; ++k) {
      model.triangles.push_back({point(i, k), point(i + 1, k), point(i + 1, k + 1)});
      if (i > 0) model.triangles.push_back({point(i, k), point(i + 1, k + 1), point(i, k + 1)});
    }
  return model;
}

TriangleSoup make_spinning_top(int around) {
  struct Ring {
    double radius, height;
  };
  constexpr std::array<Ring, 13> rings{{{0.02, -1.1},
                                        {0.06, -1.0},
                                        {0.3, -0.55},
                                        {0.41, -0.25},
                                        {0.45, -0.015},
                                        {1.1, -0.015},
                                        {1.1, 0.015},
                                        {0.45, 0.015},
                                        {0.4, 0.2},
                                        {0.28, 0.36},
                                        {0.04, 0.45},
                                        {0.03, 0.5},
                                        {0.03, 1.1}}};
  constexpr auto count = static_cast<int>(rings.size());
  TriangleSoup model;
  for (const Ring& ring : rings)
    for (int k = 0; k < around; ++k) {
      const CirclePoint at = circle_point(k, around);
      model.points.push_back({ring.radius * at.cosine, ring.radius * at.sine, ring.height});
    }
  const auto point = [&](int i, int k) { return static_cast<Index>(i * around + k % around); };
  for (int i = 0; i + 1 < count; ++i)
    for (int k = 0; k < around; ++k) {
      model.triangles.push_back({point(i, k), point(i, k + 1), point(i + 1, k + 1)});
      model.triangles.push_back({point(i, k), point(i + 1, k + 1), point(i + 1, k)});
    }
  for (int k = 1; k + 1 < around; ++k) {
    model.triangles.push_back({point(0, 0), point(0, k + 1), point(0, k)});
    model.triangles.push_back({point(count - 1, 0), point(count - 1, k), point(count - 1, k + 1)});
  }
  return model;
}

TriangleSoup make_scan(const TriangleSoup& model, std::size_t n, double noise, std::size_t outliers,
                       const std::function<bool(Vec3)>& missing) {
  std::uint64_t state = 0;
  const auto draw = [&] { return static_cast<double>(scrambled(state += golden_step) >> 11) * 0x1p-53; };
  const auto gauss = [&] {
    double sum = -6; // of twelve draws: variance 1, and the same bits with every library
    for (int i = 0; i < 12; ++i) sum += draw();
    return sum;
  };
  std::vector<double> passed;
  double area = 0;
  for (std::size_t i = 0; i < model.triangles.size(); ++i)
    passed.push_back(area += isoscope::area(model.triangle(i)));
  TriangleSoup scan;
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = std::lower_bound(passed.begin(), passed.end() - 1, area * draw()) - passed.begin();
    const Triangle3 t = model.triangle(static_cast<std::size_t>(at));
    const double r = std::sqrt(draw()), s = draw();
    Vec3 p = (1 - r) * t[0] + r * (1 - s) * t[1] + r * s * t[2];
    if (missing && missing(p)) continue;
    for (int a = 0; a < 3; ++a) p[a] += noise * gauss();
    scan.points.push_back(p);
  }
  const Box3 box = model.bounds().grown(0.1 * model.bounds().longest_edge());
  for (std::size_t i = 0; i < outliers; ++i) {
    Vec3 p;
    for (int a = 0; a < 3; ++a) p[a] = box.lo[a] + draw() * (box.hi[a] - box.lo[a]);
    scan.points.push_back(p);
  }
  return scan;
}

void append(TriangleSoup& to, const TriangleSoup& part) {
  const auto shift = static_cast<Index>(to.points.size());
  to.points.insert(to.points.end(), part.points.begin(), part.points.end());
  for (const auto& [a, b, c] : part.triangles) to.triangles.push_back({a + shift, b + shift, c + shift});
}

void turn_inside_out(TriangleSoup& model) {
  for (auto& t : model.triangles) std::swap(t[1], t[2]);
}

} // namespace isoscope
