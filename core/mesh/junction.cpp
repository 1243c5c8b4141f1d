// Facets one after another: two labels leave a segment, three leave three from the middle.
#include "mesh/junction.h"

#include "mesh/zero_set.h"

#include <algorithm>

namespace isoscope {

namespace {

constexpr std::array<std::array<std::uint8_t, 2>, 6> edges{{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

std::uint8_t edge_number(std::uint8_t i, std::uint8_t j) {
  const std::array<std::uint8_t, 2> wanted{std::min(i, j), std::max(i, j)};
  return static_cast<std::uint8_t>(std::find(edges.begin(), edges.end(), wanted) - edges.begin());
}

/// Corners in the order of their numbers.
template <std::size_t N>
std::array<std::uint8_t, N> sorted_by_number(std::array<std::uint8_t, N> corners,
                                             const std::array<VertexId, 4>& v) {
  std::sort(corners.begin(), corners.end(), [&v](std::uint8_t a, std::uint8_t b) { return v[a] < v[b]; });
  return corners;
}

class Builder {
 public:
  Builder(const TetLabels& labels, const std::array<VertexId, 4>& v) : labels_(labels), v_(v) {}

  Junction build(const std::array<Vec3, 4>& p, const std::array<double, 4>& values) {
    for (std::uint8_t e = 0; e < edges.size(); ++e) {
      const auto [i, j] = edges[e];
      if (labels_[i] == labels_[j]) continue;
      const bool up = labels_[i] < labels_[j];
      const std::uint8_t n = up ? i : j, q = up ? j : i;
      made_.position[e] = zero_point(p[n], -std::abs(values[n]), p[q], std::abs(values[q]));
    }
    made_.position[Junction::center_corner] = mean<4>({0, 1, 2, 3});
    for (std::uint8_t k = 0; k < 4; ++k) add_facet(k);
    return made_;
  }

 private:
  /// The mean of the zeros on the edges between some corners.
  template <std::size_t N> Vec3 mean(const std::array<std::uint8_t, N>& corners) const {
    const auto order = sorted_by_number(corners, v_);
    Vec3 sum;
    double count = 0;
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = i + 1; j < N; ++j) {
        if (labels_[order[i]] == labels_[order[j]]) continue;
        sum = sum + made_.position[edge_number(order[i], order[j])];
        ++count;
      }
    return sum / count;
  }

  void add_facet(std::uint8_t opposite) {
    const auto& f = outward_facets[opposite];
    const TetLabels here{labels_[f[0]], labels_[f[1]], labels_[f[2]], 0};
    const int count = label_count(here);
    if (count == 1) return;
    const auto middle = static_cast<std::uint8_t>(Junction::first_facet + opposite);
    if (count == 3) made_.position[middle] = mean<3>(f);
    for (std::size_t r = 0; r < 3; ++r) {
      const std::uint8_t x = f[r], y = f[(r + 1) % 3], z = f[(r + 2) % 3];
      // Seen from outside the tetrahedron x lies on the left of both ways.
      if (count == 3)
        add(edge_number(x, y), middle, x, y);
      else if (labels_[x] != labels_[y] && labels_[x] != labels_[z])
        add(edge_number(x, y), edge_number(x, z), x, y);
    }
  }

  /// The triangle over a segment that has the corner `left` on its left and `right` on its right.
  void add(std::uint8_t from, std::uint8_t to, std::uint8_t left, std::uint8_t right) {
    const bool front = labels_[left] > labels_[right];
    if (!front) std::swap(from, to);
    made_.facets[made_.count++] = {{from, to, Junction::center_corner},
                                   {labels_[front ? left : right], labels_[front ? right : left]}};
  }

  TetLabels labels_;
  std::array<VertexId, 4> v_;
  Junction made_;
};

} // namespace

std::array<std::uint8_t, 2> Junction::edge(std::uint8_t corner) {
  return edges[corner];
}

Junction make_junction(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                       const TetLabels& labels, const std::array<VertexId, 4>& v) {
  return Builder(labels, v).build(p, values);
}

void append_zero_triangles(const std::array<Vec3, 4>& p, const std::array<double, 4>& values,
                           const TetLabels& labels, const std::array<VertexId, 4>& v,
                           std::vector<LabelledTriangle>& out) {
  if (std::find(labels.begin(), labels.end(), 0) != labels.end()) return;
  const int count = label_count(labels);
  if (count < 2) return;
  if (count > 2) {
    const Junction junction = make_junction(p, values, labels, v);
    for (std::size_t k = 0; k < junction.count; ++k) {
      const auto [a, b, c] = junction.facets[k].corner;
      out.push_back(
          {{junction.position[a], junction.position[b], junction.position[c]}, junction.facets[k].labels});
    }
    return;
  }
  const LabelPair pair = outer_labels(labels);
  const ZeroPolygon polygon = zero_polygon(p, seen_from_front(values, labels));
  const PolygonSplit split = split_polygon(polygon.corner, polygon.count);
  for (std::size_t k = 0; k < split.count; ++k) {
    const auto [i, j, l] = split.triangles[k];
    out.push_back({{polygon.corner[i], polygon.corner[j], polygon.corner[l]}, pair});
  }
}

} // namespace isoscope
