// Cells level by level, φ in parallel.
#include "tolerance/field_octree.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

/// How many cells go into a length of φ. Fewer, and not so small ones, where there are so many sites that the
/// cells would take long.
constexpr double fine = 3, coarse = 2.5, coarse_finest = 1.6;
constexpr std::size_t many_sites = 10000;
/// So much of the box lies around it.
constexpr double box_margin = 0.1;
/// Cells beyond which no level is added, and levels.
constexpr std::size_t most_cells = 16'000'000;
constexpr unsigned most_levels = 20;
constexpr double center_to_corner = 0.8660254038;

} // namespace

FieldOctree::FieldOctree(const ToleranceField& field, double finest, const RunControl& control) {
  if (field.empty() || !(finest > 0)) return;
  side_ = (1 + 2 * box_margin) * field.bounds().longest_edge() + 8 * finest;
  origin_ = field.bounds().center() - 0.5 * Vec3{side_, side_, side_};
  const bool many = field.size() > many_sites;
  const double factor = many ? coarse : fine;
  if (many) finest *= coarse_finest;
  cells_.emplace_back();
  std::vector<TriangleId> sites(1); // of the cells of a level: where to begin to look for those of the next
  for (unsigned level = 0; level <= most_levels; ++level) {
    const std::size_t begin = cells_.size() - sites.size();
    parallel_until(sites.size(), 64, control, [&](std::size_t i) {
      Cell& c = cells_[begin + i];
      const ClosestPoint at = field.closest_near(center(c), sites[i]);
      sites[i] = at.triangle;
      c.value = static_cast<float>(at.distance());
    });
    if (control.cancelled()) return;
    const double s = side(level);
    const auto splits = [&](const Cell& c) {
      const double value = static_cast<double>(c.value);
      return factor * s > std::max(value, finest) && value + center_to_corner * s > finest;
    };
    const auto parents = static_cast<std::size_t>(
        std::count_if(cells_.begin() + static_cast<std::ptrdiff_t>(begin), cells_.end(), splits));
    if (parents == 0 || cells_.size() + 8 * parents > most_cells || level == most_levels) break;
    const std::size_t end = cells_.size();
    cells_.reserve(end + 8 * parents);
    std::vector<TriangleId> of_children;
    of_children.reserve(8 * parents);
    for (std::size_t i = begin; i < end; ++i) {
      if (!splits(cells_[i])) continue;
      cells_[i].next = static_cast<std::uint32_t>(cells_.size());
      for (std::uint32_t k = 0; k < 8; ++k) {
        cells_.push_back({cells_[i].path << 3 | k, leaf_bit, 0});
        of_children.push_back(sites[i - begin]);
      }
    }
    sites = std::move(of_children);
  }
  leaves_.reserve(cells_.size() - cells_.size() / 8);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (!cells_[i].is_leaf()) continue;
    cells_[i].next |= static_cast<std::uint32_t>(leaves_.size());
    leaves_.push_back(static_cast<std::uint32_t>(i));
  }
}

std::array<std::uint32_t, 3> FieldOctree::Cell::position() const {
  std::array<std::uint32_t, 3> p{};
  const unsigned levels = level();
  for (unsigned l = 0; l < levels; ++l)
    for (unsigned a = 0; a < 3; ++a) p[a] |= static_cast<std::uint32_t>(path >> (3 * l + a) & 1u) << l;
  return p;
}

Vec3 FieldOctree::center(const Cell& c) const {
  const double s = side(c.level());
  const auto p = c.position();
  return origin_ + Vec3{(p[0] + 0.5) * s, (p[1] + 0.5) * s, (p[2] + 0.5) * s};
}

std::uint32_t FieldOctree::neighbor(std::uint32_t cell, unsigned face) const {
  const Cell& c = cells_[cell];
  const unsigned levels = c.level();
  // Half of them have the same parent.
  const std::uint32_t bit = 1u << face / 2, child = static_cast<std::uint32_t>(c.path & 7u);
  if (levels > 0 && ((child & bit) != 0) != (face % 2 != 0)) return cell - child + (child ^ bit);
  auto p = c.position();
  std::uint32_t& coordinate = p[face / 2];
  if (coordinate == (face % 2 ? (1u << levels) - 1 : 0u)) return none;
  coordinate += face % 2 ? 1u : 0xffffffffu;
  std::uint32_t at = 0;
  for (unsigned level = 1; level <= levels && !cells_[at].is_leaf(); ++level) {
    const unsigned shift = levels - level;
    at = cells_[at].next + ((p[0] >> shift) & 1u) + 2 * ((p[1] >> shift) & 1u) + 4 * ((p[2] >> shift) & 1u);
  }
  return at;
}

} // namespace isoscope
