// The height of a tetrahedron: apex to plane where it is split 1–3, line to line where it is split 2–2.
#include "criteria/height.h"

namespace isoscope {
namespace {

double point_to_plane(Vec3 apex, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 normal = cross(b - a, c - a);
  const double area = length(normal);
  return area > 0 ? std::abs(dot(normal, apex - a)) / area : 0;
}

double line_to_line(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 u = b - a, v = d - c, w = c - a;
  const Vec3 normal = cross(u, v);
  const double area = length(normal);
  if (area > 0) return std::abs(dot(normal, w)) / area;
  const double l = length(u);
  return l > 0 ? length(cross(u, w)) / l : 0;
}

} // namespace

Height tetrahedron_height(const std::array<Vec3, 4>& p, const std::array<double, 4>& f) {
  std::array<std::uint8_t, 4> positive{}, negative{};
  std::size_t positives = 0, negatives = 0;
  for (std::uint8_t i = 0; i < 4; ++i) {
    if (f[i] > 0) positive[positives++] = i;
    if (f[i] < 0) negative[negatives++] = i;
  }
  Height height;
  if (positives == 0 || negatives == 0 || positives + negatives != 4) return height;
  if (positives == 2) {
    height.split = Height::Split::two_two;
    height.order = {positive[0], positive[1], negative[0], negative[1]};
    height.value = line_to_line(p[positive[0]], p[positive[1]], p[negative[0]], p[negative[1]]);
    return height;
  }
  const auto& lone = positives == 1 ? positive : negative;
  const auto& base = positives == 1 ? negative : positive;
  height.split = Height::Split::one_three;
  height.order = {lone[0], base[0], base[1], base[2]};
  height.value = point_to_plane(p[lone[0]], p[base[0]], p[base[1]], p[base[2]]);
  return height;
}

Height tetrahedron_height(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                          const TetLabels& labels) {
  const int count = label_count(labels);
  if (count < 3) return tetrahedron_height(p, seen_from_front(values, labels));
  Height least;
  for (const std::int8_t label : labels) {
    const Height height = tetrahedron_height(p, seen_from(label, values, labels));
    if (least.split == Height::Split::none || height.value < least.value) least = height;
  }
  return least;
}

} // namespace isoscope
