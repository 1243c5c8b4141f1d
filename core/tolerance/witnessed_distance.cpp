// Nearest neighbours by nanoflann's kd-tree, and what follows from them.
#include "tolerance/witnessed_distance.h"

#include "base/parallel.h"
#include "base/quantiles.h"
#include "base/scramble.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isoscope {
namespace {

constexpr std::size_t points_by_leaf = 10;
constexpr std::size_t points_by_task = 256;
/// Neighbours by which density is told.
constexpr std::size_t density_neighbors = 12;
/// A point is outlying whose neighbours are so many times as far as those of most: where a surface is sampled
/// a twelfth as densely they reach it.
constexpr double far_away = 3.5;
/// Beyond this share of outlying points more neighbours are needed to outvote them.
constexpr double few_outlying = 0.05;

struct Cloud {
  std::span<const Vec3> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][static_cast<int>(axis)]; }
  template <class Box> bool kdtree_get_bbox(Box&) const { return false; }
};

using Tree =
    nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud, 3, std::uint32_t>;

/// Calls at(i, neighbours of i, their squared distances) for each point, both ascending by distance.
template <class At>
void for_neighbors(const Cloud& cloud, const Tree& tree, std::size_t k, const RunControl& control,
                   const At& at) {
  const std::size_t n = cloud.points.size(), tasks = (n + points_by_task - 1) / points_by_task;
  parallel_until(tasks, 1, control, [&](std::size_t task) {
    std::vector<std::uint32_t> ids(k);
    std::vector<double> squared(k);
    const std::size_t begin = task * points_by_task, end = std::min(begin + points_by_task, n);
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 p = cloud.points[i];
      const double query[3] = {p.x, p.y, p.z};
      const std::size_t found = tree.knnSearch(query, k, ids.data(), squared.data());
      at(i, std::span(ids).first(found), std::span(squared).first(found));
    }
  });
}

/// Finds spacing, area and the share of outlying points from the radii that hold `k` of them.
void judge_density(const std::vector<double>& radii, std::size_t k, WitnessedDistance& result) {
  const double typical = upper_median(radii);
  const double by_point = std::numbers::pi / static_cast<double>(k);
  std::size_t outlying = 0;
  for (const double r : radii) {
    if (r > far_away * typical && typical > 0)
      ++outlying;
    else
      result.area += by_point * r * r;
  }
  result.outlying = static_cast<double>(outlying) / static_cast<double>(radii.size());
  result.spacing = typical * std::sqrt(by_point);
}

} // namespace

double WitnessedDistance::finest() const {
  constexpr double most = 0.8, farther = 1.2, least_spacing = 1.1; // of the sites; in units of the spacing
  if (sites.empty()) return 0;
  std::vector<double> weights;
  weights.reserve(sites.size());
  for (const WeightedPoint& s : sites) weights.push_back(s.weight);
  const auto at =
      weights.begin() + static_cast<std::ptrdiff_t>(most * static_cast<double>(weights.size() - 1));
  std::nth_element(weights.begin(), at, weights.end());
  return std::max(farther * std::sqrt(*at), least_spacing * spacing);
}

WitnessedDistance witness_distance(std::span<const Vec3> points, std::size_t neighbors,
                                   const RunControl& control) {
  WitnessedDistance result;
  if (points.empty()) return result;
  const std::size_t n = points.size();
  const Cloud cloud{points};
  const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(points_by_leaf));
  result.sites.resize(n);
  control.report("neighbours", -1);

  const auto set_sites = [&](std::size_t i, std::span<const std::uint32_t> ids) {
    const auto m = static_cast<double>(ids.size());
    Vec3 mean;
    for (const std::uint32_t j : ids) mean += points[j] / m;
    double weight = 0;
    for (const std::uint32_t j : ids) weight += squared_length(points[j] - mean) / m;
    result.sites[i] = {mean, weight};
  };
  const std::size_t density_k = std::min(density_neighbors, n);
  std::vector<double> radii(n);
  for_neighbors(cloud, tree, density_k, control, [&](std::size_t i, auto ids, auto squared) {
    radii[i] = std::sqrt(squared.back());
    set_sites(i, ids);
  });
  if (control.cancelled()) return result;
  judge_density(radii, density_k, result);

  result.automatic = neighbors == 0;
  if (result.automatic) neighbors = result.outlying > few_outlying ? robust_neighbors : usual_neighbors;
  result.neighbors = std::min(neighbors, n);
  if (result.neighbors == 1) { // not by a search, which may find another point at the same place
    for (std::size_t i = 0; i < n; ++i) result.sites[i] = {points[i], 0};
  } else if (result.neighbors != density_k) {
    for_neighbors(cloud, tree, result.neighbors, control,
                  [&](std::size_t i, auto ids, auto) { set_sites(i, ids); });
  }
  return result;
}

std::vector<Vec3> sample_area(const TriangleSoup& soup, std::size_t n, std::uint64_t seed) {
  std::uint64_t state = scrambled(seed);
  const auto draw = [&] { return static_cast<double>(scrambled(state += golden_step) >> 11) * 0x1p-53; };
  const double share = soup.area() / static_cast<double>(n);
  std::vector<Vec3> points;
  points.reserve(n);
  double passed = 0; // area of the triangles before
  double next = share * draw();
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    passed += area(t);
    for (; next < passed && points.size() < n; next = share * (static_cast<double>(points.size()) + draw())) {
      const double r = std::sqrt(draw()), s = draw();
      points.push_back((1 - r) * t[0] + r * (1 - s) * t[1] + r * s * t[2]);
    }
  }
  return points;
}

} // namespace isoscope
