// Insertion and removal in the loose octree.
#include "improve/facet_octree.h"

namespace isoscope {

FacetOctree::FacetOctree(const Box3& domain)
    : origin_(domain.lo), side_(domain.longest_edge() > 0 ? domain.longest_edge() : 1), cells_(1) {}

template <class At> void FacetOctree::descend(const Box3& box, const At& at) {
  const Vec3 center = box.center();
  const double size = box.longest_edge();
  Vec3 corner = origin_;
  double half = side_ / 2;
  std::uint32_t index = 0;
  for (int level = 0;; ++level, half /= 2) {
    const bool last = level == most_levels || half < size;
    at(cells_[index], last);
    if (last) return;
    std::size_t child = 0;
    for (int k = 0; k < 3; ++k)
      if (center[k] >= corner[k] + half) {
        child |= std::size_t{1} << k;
        corner[k] += half;
      }
    if (cells_[index].children[child] == none) {
      cells_[index].children[child] = static_cast<std::uint32_t>(cells_.size());
      cells_.emplace_back();
    }
    index = cells_[index].children[child];
  }
}

void FacetOctree::insert(std::uint32_t facet, const Box3& box) {
  descend(box, [&](Cell& cell, bool last) {
    ++cell.count;
    if (last) cell.facets.push_back(facet);
  });
}

void FacetOctree::erase(std::uint32_t facet, const Box3& box) {
  descend(box, [&](Cell& cell, bool last) {
    --cell.count;
    if (last) std::erase(cell.facets, facet);
  });
}

} // namespace isoscope
