// Components of Ω' by the distances between triangles.
#include "tolerance/volume_components.h"

#include "base/disjoint_sets.h"
#include "base/scramble.h"

#include <bit>

namespace isoscope {
namespace {

constexpr std::uint32_t triangles_between_questions = 16;

/// Which corners of triangles are at one place. Corner 3s + k is the k-th of the triangle in slot s:
/// neighbours come after each other.
class CornerPlaces {
 public:
  explicit CornerPlaces(const ClosestPointIndex& index)
      : index_(index), slots_(std::bit_ceil(index.size() + 2), none) {}

  /// The first of those asked for so far that is where this one is.
  std::uint32_t first_at(std::uint32_t corner) {
    if (2 * (places_ + 1) > slots_.size()) grow();
    std::uint32_t& slot = slots_[slot_of(point(corner))];
    if (slot == none) slot = corner, ++places_;
    return slot;
  }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  Vec3 point(std::uint32_t corner) const { return index_.triangle_at(corner / 3)[corner % 3]; }
  std::size_t slot_of(Vec3 p) const {
    std::uint64_t key = 0;
    for (int a = 0; a < 3; ++a) key = scrambled(key + std::bit_cast<std::uint64_t>(p[a] + 0.0)); // -0 is 0
    std::size_t i = key & (slots_.size() - 1);
    while (slots_[i] != none && point(slots_[i]) != p) i = (i + 1) & (slots_.size() - 1);
    return i;
  }
  void grow() {
    std::vector<std::uint32_t> old(2 * slots_.size(), none);
    old.swap(slots_);
    for (const std::uint32_t corner : old)
      if (corner != none) slots_[slot_of(point(corner))] = corner;
  }

  const ClosestPointIndex& index_;
  std::vector<std::uint32_t> slots_; ///< corners; a power of two of them, at most half of them taken
  std::size_t places_ = 0;
};

} // namespace

VolumeComponents ClosestPointIndex::components(double r, const RunControl& control) const {
  return find_volume_components(*this, r, control);
}

VolumeComponents find_volume_components(const ClosestPointIndex& index, double r, const RunControl& control) {
  const auto n = static_cast<std::uint32_t>(index.size());
  DisjointSets sets(n);
  std::size_t count = n;

  // Equal corners first: nearly all of the work on an ordinary mesh, without a distance.
  {
    CornerPlaces places(index);
    for (std::uint32_t corner = 0; corner < 3 * n; ++corner)
      if (sets.unite(index.id_at(places.first_at(corner) / 3).value, index.id_at(corner / 3).value)) --count;
  }

  SparsePoll poll(control, triangles_between_questions);
  for (std::uint32_t t = 0; t < n && count > 1 && !poll.cancelled(); ++t) {
    const Triangle3& triangle = index.triangle(TriangleId(t));
    Box3 box;
    for (const Vec3 p : triangle) box.add(p);
    for (const TriangleId other : index.triangles_in(box.grown(2 * r))) {
      if (count == 1) break;
      if (other.value <= t || sets.find(other.value) == sets.find(t)) continue;
      if (triangles_within(triangle, index.triangle(other), 2 * r) && sets.unite(t, other.value)) --count;
    }
  }

  VolumeComponents result;
  result.of_triangle.resize(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    const std::uint32_t root = sets.find(t);
    result.of_triangle[t] = root == t ? static_cast<std::uint32_t>(result.count++) : result.of_triangle[root];
  }
  return result;
}

} // namespace isoscope
