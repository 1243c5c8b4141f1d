// Places samples in tetrahedra: plane filters with a proven margin first, exact predicates for the rest.
#include "mesh/sample_sets.h"

#include "base/parallel.h"
#include "mesh/label_functions.h"
#include "mesh/predicates.h"
#include "mesh/tet_planes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace isoscope {

namespace {

/// Samples per parallel block: walks inside a block start from the previous sample's tetrahedron.
constexpr std::size_t block_size = 2048;
constexpr std::uint32_t no_candidate = 0xffffffffu;
/// Among more tetrahedra samples are found by walking: a scan of them all for every point near a plane would
/// cost more.
constexpr std::size_t most_candidates = 256;

/// The tetrahedra among which samples are distributed, with filters whose error is below `margin` inside
/// `box`.
class Candidates {
 public:
  Candidates(const Complex& complex, std::span<const TetRecord> tets) {
    corners_.reserve(tets.size());
    for (const TetRecord& t : tets) {
      corners_.push_back({complex.position(t.v[0]), complex.position(t.v[1]), complex.position(t.v[2]),
                          complex.position(t.v[3])});
      for (const Vec3 p : corners_.back()) box_.add(p);
    }
    origin_ = box_.center();
    margin_ = plane_margin(box_);
    planes_.reserve(tets.size());
    for (const auto& p : corners_) planes_.emplace_back(p, origin_);
    link(complex, tets);
  }

  /// The candidate that holds x, tried from `guess` on; no_candidate when none does.
  std::uint32_t find(Vec3 x, std::uint32_t guess) const {
    const Vec3 local = x - origin_;
    const bool filtered = inside_box(x);
    const auto n = static_cast<std::uint32_t>(corners_.size());
    // A short walk finds nearly all; a point near a plane, or behind a facet of the hole, is left to the
    // scan.
    for (std::uint32_t step = 0, i = guess; filtered && step < n && i != no_candidate; ++step) {
      const auto [low, plane] = planes_[i].lowest(local);
      if (low > margin_) return i;
      if (low >= -margin_) break;
      i = across_[i][plane];
    }
    for (std::uint32_t k = 0, i = guess; k < n; ++k, i = i + 1 == n ? 0 : i + 1) {
      if (filtered) {
        const double low = planes_[i].lowest(local).first;
        if (low > margin_) return i;
        if (low < -margin_) continue;
      }
      if (holds_perturbed(corners_[i], x)) return i;
    }
    return no_candidate;
  }

 private:
  std::vector<std::array<Vec3, 4>> corners_;
  std::vector<TetPlanes> planes_;
  /// The candidate behind each plane, no_candidate where there is none.
  std::vector<std::array<std::uint32_t, 4>> across_;
  Box3 box_;
  Vec3 origin_;
  double margin_ = 0;

  bool inside_box(Vec3 x) const {
    return x.x >= box_.lo.x && x.x <= box_.hi.x && x.y >= box_.lo.y && x.y <= box_.hi.y && x.z >= box_.lo.z &&
           x.z <= box_.hi.z;
  }

  void link(const Complex& complex, std::span<const TetRecord> tets) {
    std::vector<std::pair<TetId, std::uint32_t>> number;
    for (const TetRecord& t : tets) number.push_back({t.id, static_cast<std::uint32_t>(number.size())});
    std::sort(number.begin(), number.end());
    across_.resize(tets.size());
    for (std::size_t i = 0; i < tets.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const TetId n = complex.tet(tets[i].id).neighbor[k];
        const auto at = std::lower_bound(number.begin(), number.end(), std::pair{n, std::uint32_t{0}});
        across_[i][k] = at != number.end() && at->first == n ? at->second : no_candidate;
      }
    }
  }
};

/// Walks from `start` towards x across facets that have x on their far side. Invalid when x lies outside the
/// hull.
TetId walk(const Complex& complex, TetId start, Vec3 x) {
  // Delaunay walks end; those in other triangulations may circle, so the first facet tried varies and the
  // length is bounded.
  const std::size_t most_steps =
      1000 + 64 * static_cast<std::size_t>(std::cbrt(static_cast<double>(complex.tets.size())));
  std::uint32_t turn = 0;
  TetId t = start;
  for (std::size_t step = 0; step < most_steps; ++step) {
    const auto p = complex.positions(t);
    bool moved = false;
    turn = turn * 1664525u + 1013904223u;
    for (std::uint32_t k = 0; k < 4 && !moved; ++k) {
      const std::size_t i = ((turn >> 24) + k) & 3;
      const auto& f = outward_facets[i];
      if (orientation_perturbed(p[f[0]], p[f[2]], p[f[1]], x) > 0) continue;
      t = complex.tet(t).neighbor[i];
      if (!t.valid()) return {};
      moved = true;
    }
    if (!moved) return t;
  }
  for (std::size_t i = 0; i < complex.tets.size(); ++i) {
    const TetId c(i);
    if (complex.tet(c).alive() && holds_perturbed(complex.positions(c), x)) return c;
  }
  return {};
}

/// Sorts distinct ids: by a bit set over their range where that is short, which it is for samples that lie
/// together.
void sort_ids(std::vector<std::uint32_t>& ids) {
  if (ids.size() < 2) return;
  const auto [lo, hi] = std::minmax_element(ids.begin(), ids.end());
  const std::uint32_t first = *lo, words = (*hi - *lo) / 64 + 1;
  if (ids.size() < 64 || words > 4 * ids.size()) {
    std::sort(ids.begin(), ids.end());
    return;
  }
  std::vector<std::uint64_t> bits(words, 0);
  for (const std::uint32_t id : ids) bits[(id - first) / 64] |= std::uint64_t{1} << ((id - first) % 64);
  std::size_t n = 0;
  for (std::uint32_t w = 0; w < words; ++w) {
    for (std::uint64_t b = bits[w]; b != 0; b &= b - 1) {
      ids[n++] = first + 64 * w + static_cast<std::uint32_t>(std::countr_zero(b));
    }
  }
}

/// In blocks, each in the order of `moving`; the same on any number of threads.
template <class Place> void in_blocks(std::size_t size, const Place& place) {
  if (size <= block_size)
    place(0, size);
  else
    parallel_ranges(size, block_size / 2, place);
}

std::vector<TetId> find_among(const Complex& complex, std::span<const TetRecord> to,
                              std::span<const Vec3> positions, const std::vector<std::uint32_t>& moving) {
  const Candidates candidates(complex, to);
  std::vector<TetId> target(moving.size());
  in_blocks(moving.size(), [&](std::size_t begin, std::size_t end) {
    std::uint32_t guess = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t found = candidates.find(positions[moving[i]], guess);
      if (found == no_candidate) continue;
      guess = found;
      target[i] = to[found].id;
    }
  });
  return target;
}

std::vector<TetId> walk_among(const Complex& complex, std::span<const TetRecord> to,
                              std::span<const Vec3> positions, const std::vector<std::uint32_t>& moving) {
  std::vector<bool> offered(complex.tets.size(), false);
  for (const TetRecord& t : to) offered[t.id.index()] = true;
  std::vector<TetId> target(moving.size());
  in_blocks(moving.size(), [&](std::size_t begin, std::size_t end) {
    TetId at = to.front().id;
    for (std::size_t i = begin; i < end; ++i) {
      const TetId found = walk(complex, at, positions[moving[i]]);
      if (!found.valid()) continue;
      at = found;
      if (offered[found.index()]) target[i] = found;
    }
  });
  return target;
}

} // namespace

double sample_error_at(const Complex& complex, TetId t, Vec3 place, int label) {
  return sample_error_in(complex.tet(t), LabelFunctions(complex, t).of(label)(place), label);
}

SampleSets::SampleSets(std::span<const Vec3> positions)
    : positions_(positions), tet_of_(positions.size()), next_(positions.size(), SampleId::none) {}

void SampleSets::assign_all(const Complex& complex) {
  head_.assign(complex.tets.size(), SampleId::none);
  const auto first =
      std::find_if(complex.tets.begin(), complex.tets.end(), [](const Tet& t) { return t.alive(); });
  if (first == complex.tets.end()) {
    std::fill(tet_of_.begin(), tet_of_.end(), TetId{});
  } else {
    const TetId start(static_cast<std::size_t>(first - complex.tets.begin()));
    parallel_ranges(positions_.size(), block_size, [&](std::size_t begin, std::size_t end) {
      TetId at = start;
      for (std::size_t s = begin; s < end; ++s) {
        tet_of_[s] = walk(complex, at, positions_[s]);
        if (tet_of_[s].valid()) at = tet_of_[s];
      }
    });
  }
  for (std::size_t s = tet_of_.size(); s-- > 0;) push_front(s, tet_of_[s]);
}

std::vector<SampleId> SampleSets::gather(std::span<const TetId> tets) const {
  std::vector<std::uint32_t> ids;
  for (const TetId t : tets) for_each(t, [&](SampleId s) { ids.push_back(s.value); });
  sort_ids(ids);
  return {ids.begin(), ids.end()};
}

std::size_t SampleSets::redistribute(const Complex& complex, std::span<const TetRecord> from,
                                     std::span<const TetRecord> to) {
  if (head_.size() < complex.tets.size()) head_.resize(complex.tets.size(), SampleId::none);
  std::vector<std::uint32_t> moving;
  for (const TetRecord& r : from) {
    if (r.id.index() >= head_.size()) continue;
    for (std::uint32_t s = head_[r.id.index()]; s != SampleId::none; s = next_[s]) moving.push_back(s);
    head_[r.id.index()] = SampleId::none;
  }
  if (moving.empty()) return 0;
  sort_ids(moving);

  const std::vector<TetId> target = to.size() <= most_candidates
                                        ? find_among(complex, to, positions_, moving)
                                        : walk_among(complex, to, positions_, moving);
  for (std::size_t i = moving.size(); i-- > 0;) push_front(moving[i], target[i]);
  return moving.size();
}

void SampleSets::push_front(std::size_t s, TetId t) {
  tet_of_[s] = t;
  next_[s] = t.valid() ? head_[t.index()] : SampleId::none;
  if (t.valid()) head_[t.index()] = static_cast<std::uint32_t>(s);
}

std::size_t SampleSets::memory_bytes() const {
  return sizeof(SampleSets) + tet_of_.capacity() * sizeof(TetId) +
         (head_.capacity() + next_.capacity()) * sizeof(std::uint32_t);
}

} // namespace isoscope
