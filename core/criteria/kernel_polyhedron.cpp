// The kernel's vertices and faces: a cube about it, cut by one half-space after another.
#include "criteria/kernel.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace isoscope {

namespace {

using Index = std::uint32_t;
using Face = std::vector<Index>;
constexpr Index of_cube = 0xffffffffu;

class Clipper {
 public:
  Clipper(Vec3 center, double half);
  void cut(const HalfSpace& h, Index source, double tolerance);
  /// Points nearer to each other than the tolerance are one vertex.
  KernelPolyhedron result(double tolerance) const;

 private:
  /// The points of each edge that the plane crosses, from its inner end to its outer.
  using Crossings = std::map<std::pair<Index, Index>, Index>;
  Index crossing(Crossings& crossings, Index in, Index out, double slack_in, double slack_out);

  std::vector<Vec3> vertices_;
  std::vector<Face> faces_;
  std::vector<Index> source_;
};

Clipper::Clipper(Vec3 center, double half) {
  for (int i = 0; i < 8; ++i) {
    vertices_.push_back(center + half * Vec3{i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  }
  faces_ = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  source_.assign(faces_.size(), of_cube);
}

Index Clipper::crossing(Crossings& crossings, Index in, Index out, double slack_in, double slack_out) {
  const auto [at, is_new] = crossings.try_emplace({in, out}, static_cast<Index>(vertices_.size()));
  if (is_new) {
    const double t = std::clamp(slack_in / (slack_in - slack_out), 0.0, 1.0);
    vertices_.push_back(vertices_[in] + t * (vertices_[out] - vertices_[in]));
  }
  return at->second;
}

void Clipper::cut(const HalfSpace& h, Index source, double tolerance) {
  std::vector<double> slack(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) slack[i] = h.slack(vertices_[i]);
  const auto inside = [&](Index v) { return slack[v] >= -tolerance; };
  Crossings crossings;
  std::map<Index, Index> next; // around the new face
  std::vector<Face> faces;
  std::vector<Index> sources;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    Face kept;
    Index exit = of_cube, entry = of_cube;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Index u = face[k], v = face[(k + 1) % face.size()];
      if (inside(u)) kept.push_back(u);
      if (inside(u) == inside(v)) continue;
      const Index in = inside(u) ? u : v, out = inside(u) ? v : u;
      const Index x = crossing(crossings, in, out, slack[in], slack[out]);
      (in == u ? exit : entry) = x;
      kept.push_back(x);
    }
    if (exit != of_cube && entry != of_cube) next[entry] = exit;
    if (kept.size() < 3) continue;
    faces.push_back(std::move(kept));
    sources.push_back(source_[f]);
  }
  if (!next.empty()) {
    Face cap;
    Index at = next.begin()->first;
    do {
      cap.push_back(at);
      const auto n = next.find(at);
      if (n == next.end()) break;
      at = n->second;
    } while (at != cap.front() && cap.size() <= next.size());
    if (cap.size() >= 3) {
      faces.push_back(std::move(cap));
      sources.push_back(source);
    }
  }
  faces_ = std::move(faces);
  source_ = std::move(sources);
}

KernelPolyhedron Clipper::result(double tolerance) const {
  KernelPolyhedron result;
  const auto number = [&](Vec3 p) {
    const auto at = std::find_if(result.vertices.begin(), result.vertices.end(),
                                 [&](Vec3 q) { return distance(p, q) <= tolerance; });
    const auto n = static_cast<Index>(at - result.vertices.begin());
    if (at == result.vertices.end()) result.vertices.push_back(p);
    return n;
  };
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    Face face;
    for (const Index v : faces_[f]) face.push_back(number(vertices_[v]));
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() < 3) continue;
    result.faces.push_back(std::move(face));
    result.source.push_back(source_[f]);
  }
  for (const Face& face : result.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Vec3 a = result.vertices[face[0]], b = result.vertices[face[k]], c = result.vertices[face[k + 1]];
      result.volume += dot(a, cross(b, c)) / 6;
    }
  }
  return result;
}

} // namespace

KernelPolyhedron kernel_polyhedron(const Kernel& kernel) {
  if (kernel.empty) return {};
  Box3 box;
  for (const Triangle3& f : kernel.facets) {
    for (const Vec3 p : f) box.add(p);
  }
  const double size = 2 * box.longest_edge();
  // Relative to the kernel's centre, against lost digits far from the origin.
  Clipper clipper({}, size);
  for (std::size_t i = 0; i < kernel.half_spaces.size(); ++i) {
    const Vec3 n = kernel.half_spaces[i].normal;
    clipper.cut({n, dot(n, kernel.facets[i][0] - kernel.center)}, static_cast<Index>(i), 1e-13 * size);
  }
  KernelPolyhedron result = clipper.result(1e-12 * size);
  for (Vec3& v : result.vertices) v += kernel.center;
  return result;
}

KernelPolyhedron half_space_polyhedron(std::span<const HalfSpace> half_spaces, Vec3 origin, double size) {
  const InscribedBall ball = inscribed_ball(half_spaces, origin, size);
  if (!(ball.radius > 1e-9 * size)) return {};
  Clipper clipper({}, 2 * size);
  for (std::size_t i = 0; i < half_spaces.size(); ++i) {
    const HalfSpace& h = half_spaces[i];
    clipper.cut({h.normal, -h.slack(ball.center)}, static_cast<Index>(i), 1e-13 * size);
  }
  KernelPolyhedron result = clipper.result(1e-12 * size);
  for (Vec3& v : result.vertices) v += ball.center;
  return result;
}

} // namespace isoscope
