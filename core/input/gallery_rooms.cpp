// Rooms that share walls: boxes from squares, bubbles from balls cut by the planes between them.
#include "input/exact_circle.h"
#include "input/gallery_shapes.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace isoscope {

namespace {

/// {x : dot(normal, x) <= offset}.
struct Half {
  Vec3 normal;
  double offset = 0;
  double excess(Vec3 p) const { return dot(normal, p) - offset; }
};

using Polygon = std::vector<Vec3>;

Polygon clipped(const Polygon& polygon, const Half& half) {
  Polygon rest;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = half.excess(a), at_b = half.excess(b);
    if (at_a <= 0) rest.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0)) rest.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return rest;
}

void add(const Polygon& polygon, TriangleSoup& soup) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), polygon.begin(), polygon.end());
  for (std::uint32_t k = 2; k < polygon.size(); ++k)
    soup.triangles.push_back({first, first + k - 1, first + k});
}

/// A regular polygon about `center` in the plane across `axis`, a unit vector.
Polygon disc(Vec3 center, Vec3 axis, double radius, int corners) {
  const Vec3 away = std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(axis, away)), v = cross(axis, u);
  Polygon polygon;
  for (int i = 0; i < corners; ++i) {
    const CirclePoint c = circle_point(i, corners);
    polygon.push_back(center + radius * (c.cosine * u + c.sine * v));
  }
  return polygon;
}

} // namespace

TriangleSoup make_two_rooms() {
  TriangleSoup model;
  const auto square = [&](Vec3 corner, Vec3 u, Vec3 v) {
    add({corner, corner + u, corner + u + v, corner + v}, model);
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  for (int wall = 0; wall < 3; ++wall) square(static_cast<double>(wall) * x, y, z);
  for (int room = 0; room < 2; ++room) {
    const Vec3 corner = static_cast<double>(room) * x;
    for (const Vec3 side : {Vec3{}, y}) square(corner + side, x, z);
    for (const Vec3 side : {Vec3{}, z}) square(corner + side, x, y);
  }
  return model;
}

TriangleSoup make_bubbles() {
  // Four balls of radius 1, each through the centres of the others: caps and walls meet at 120°.
  const double edge = 1 / std::sqrt(2.0) / 2;
  const std::array<Vec3, 4> centers{
      Vec3{edge, edge, edge}, {edge, -edge, -edge}, {-edge, edge, -edge}, {-edge, -edge, edge}};
  const auto nearer_to = [&](std::size_t i, std::size_t j) {
    const Vec3 n = centers[j] - centers[i];
    return Half{n, dot(n, 0.5 * (centers[i] + centers[j]))};
  };
  const TriangleSoup ball = make_sphere(3);
  constexpr int corners = 48;
  TriangleSoup model;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
      Polygon cap;
      for (const Vec3 p : ball.triangle(t)) cap.push_back(centers[i] + p);
      for (std::size_t j = 0; j < centers.size(); ++j)
        if (j != i) cap = clipped(cap, nearer_to(i, j));
      add(cap, model);
    }
    for (std::size_t j = i + 1; j < centers.size(); ++j) {
      const Vec3 between = centers[j] - centers[i];
      const double half = 0.5 * length(between);
      Polygon wall =
          disc(0.5 * (centers[i] + centers[j]), normalized(between), std::sqrt(1 - half * half), corners);
      for (std::size_t k = 0; k < centers.size(); ++k)
        if (k != i && k != j) wall = clipped(wall, nearer_to(i, k));
      add(wall, model);
    }
  }
  return model;
}

} // namespace isoscope
