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
constexpr std::size_t many_sites = 200000;
/// So much of the box lies around it.
constexpr double margin = 0.1;
/// Cells beyond which no level is added, and levels.
constexpr std::size_t most_cells = 16'000'000;
constexpr unsigned most_levels = 20;
constexpr double half_diagonal = 0.8660254038;
constexpr std::size_t cells_by_task = 4096;

} // namespace

FieldOctree::FieldOctree(const ToleranceField& field, double finest, const RunControl& control) {
  if (field.empty() || !(finest > 0)) return;
  side_ = (1 + 2 * margin) * field.bounds().longest_edge() + 8 * finest;
  origin_ = field.bounds().center() - 0.5 * Vec3{side_, side_, side_};
  const bool many = field.size() > many_sites;
  const double factor = many ? coarse : fine;
  if (many) finest *= coarse_finest;
  cells_.emplace_back();
  std::vector<std::uint32_t> parents;
  for (unsigned level = 0; level <= most_levels; ++level) {
    const std::size_t begin = level == 0 ? 0 : cells_[parents.front()].child;
    parallel_until(cells_.size() - begin, 64, control, [&](std::size_t i) {
      Cell& c = cells_[begin + i];
      const ClosestPoint at = field.closest_near(center(c), c.site);
      c.site = at.triangle;
      c.value = static_cast<float>(at.distance());
    });
    if (control.cancelled()) return;
    const double s = side(level);
    parents.clear();
    for (std::size_t i = begin; i < cells_.size(); ++i) {
      const double value = static_cast<double>(cells_[i].value);
      if (factor * s > std::max(value, finest) && value + half_diagonal * s > finest)
        parents.push_back(static_cast<std::uint32_t>(i));
    }
    if (parents.empty() || cells_.size() + 8 * parents.size() > most_cells) break;
    cells_.reserve(cells_.size() + 8 * parents.size());
    for (const std::uint32_t p : parents) {
      const Cell parent = cells_[p];
      cells_[p].child = static_cast<std::uint32_t>(cells_.size());
      for (std::uint32_t k = 0; k < 8; ++k) {
        Cell child;
        for (unsigned a = 0; a < 3; ++a) child.position[a] = 2 * parent.position[a] + (k >> a & 1u);
        child.level = static_cast<std::uint8_t>(level + 1);
        child.site = parent.site;
        cells_.push_back(child);
      }
    }
  }
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (cells_[i].child != none) continue;
    cells_[i].leaf = static_cast<std::uint32_t>(leaves_.size());
    leaves_.push_back(static_cast<std::uint32_t>(i));
  }
}

Vec3 FieldOctree::center(const Cell& c) const {
  const double s = side(c.level);
  return origin_ + Vec3{(c.position[0] + 0.5) * s, (c.position[1] + 0.5) * s, (c.position[2] + 0.5) * s};
}

std::vector<double> FieldOctree::values() const {
  std::vector<double> values;
  values.reserve(leaves_.size());
  for (const std::uint32_t c : leaves_) values.push_back(static_cast<double>(cells_[c].value));
  return values;
}

std::uint32_t FieldOctree::neighbor(const Cell& c, unsigned face) const {
  auto p = c.position;
  std::uint32_t& coordinate = p[face / 2];
  if (coordinate == (face % 2 ? (1u << c.level) - 1 : 0u)) return none;
  coordinate += face % 2 ? 1u : 0xffffffffu;
  std::uint32_t at = 0;
  for (unsigned level = 1; level <= c.level && cells_[at].child != none; ++level) {
    const unsigned shift = c.level - level;
    at = cells_[at].child + ((p[0] >> shift) & 1u) + 2 * ((p[1] >> shift) & 1u) + 4 * ((p[2] >> shift) & 1u);
  }
  return at;
}

std::vector<CellLink> FieldOctree::links() const {
  const std::size_t tasks = (leaves_.size() + cells_by_task - 1) / cells_by_task;
  std::vector<std::vector<CellLink>> by_task(tasks);
  parallel_for(tasks, 1, [&](std::size_t task) {
    const std::size_t end = std::min((task + 1) * cells_by_task, leaves_.size());
    for (std::size_t i = task * cells_by_task; i < end; ++i) {
      const Cell& c = cells_[leaves_[i]];
      for (unsigned face = 0; face < 6; ++face) {
        const std::uint32_t other = neighbor(c, face);
        // Finer neighbours link themselves, and of two of the same level one does.
        if (other == none || cells_[other].child != none) continue;
        if (cells_[other].level == c.level && face % 2 == 0) continue;
        by_task[task].push_back({static_cast<std::uint32_t>(i), cells_[other].leaf});
      }
    }
  });
  std::vector<CellLink> links;
  for (const auto& part : by_task) links.insert(links.end(), part.begin(), part.end());
  return links;
}

std::vector<std::uint32_t> FieldOctree::border() const {
  std::vector<std::uint32_t> border;
  for (std::uint32_t i = 0; i < leaves_.size(); ++i)
    for (unsigned face = 0; face < 6; ++face)
      if (neighbor(cells_[leaves_[i]], face) == none) {
        border.push_back(i);
        break;
      }
  return border;
}

} // namespace isoscope
