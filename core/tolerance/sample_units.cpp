// Finds units of candidates and computes which cells each point reaches.
#include "tolerance/sample_units.h"

#include "tolerance/flat_candidates.h"

#include <array>

namespace isoscope {
namespace {

/// Rows have as many bits as a unit has cells; what is more, as in crevices, makes another unit.
constexpr std::size_t most_cells = 1024;
/// Points of neighbouring cells are often the same: a part of them is choice enough.
constexpr std::size_t cells_by_offer = 2;
constexpr std::size_t word_bits = 64;
/// Far away in single precision: never reached.
constexpr float nowhere = 1e18f;

} // namespace

SampleUnit::SampleUnit(std::vector<SampleCandidate> candidates, double sigma)
    : cells(std::move(candidates)), sigma_(sigma) {
  for (const SampleCandidate& c : cells) {
    const Vec3 h{c.half_side, c.half_side, c.half_side};
    box_.add(Box3{c.center - h, c.center + h});
  }
  center_ = box_.center();
  // Single precision is relative to the unit, at most 10 σ wide with all that is near: seven roundings of
  // 6e-8 of that are far less than what is taken off here.
  const auto reach = static_cast<float>(sigma * (1 - 2e-5));
  squared_reach_ = reach * reach;
  words_ = (cells.size() + word_bits - 1) / word_bits;
  for (auto& values : shapes_) values.assign(words_ * word_bits, nowhere);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Vec3 c = cells[i].center - center_;
    for (int a = 0; a < 3; ++a) shapes_[static_cast<std::size_t>(a)][i] = static_cast<float>(c[a]);
    shapes_[3][i] = static_cast<float>(cells[i].half_side);
  }
  for (std::size_t i = 0; i < cells.size(); i += cells_by_offer)
    if (cells[i].has_point || cells[i].ask_octree) offers_.push_back(static_cast<std::uint32_t>(i));
  rows_.resize(offers_.size() * words_);
  for (std::size_t i = 0; i < offers_.size(); ++i)
    find_row(cells[offers_[i]].point, {rows_.data() + i * words_, words_});
}

void SampleUnit::find_row(Vec3 p, std::span<std::uint64_t> row) const {
  const Vec3 q = p - center_;
  const auto qx = static_cast<float>(q.x), qy = static_cast<float>(q.y), qz = static_cast<float>(q.z);
  for (std::size_t w = 0; w < words_; ++w) {
    const float *x = &shapes_[0][word_bits * w], *y = &shapes_[1][word_bits * w];
    const float *z = &shapes_[2][word_bits * w], *h = &shapes_[3][word_bits * w];
    // Plain loops over a word's cells, which compilers turn into vector instructions.
    std::array<std::uint8_t, word_bits> reached;
    for (std::size_t k = 0; k < word_bits; ++k) {
      const float dx = std::abs(qx - x[k]) + h[k], dy = std::abs(qy - y[k]) + h[k],
                  dz = std::abs(qz - z[k]) + h[k];
      reached[k] = dx * dx + dy * dy + dz * dz <= squared_reach_;
    }
    std::uint64_t word = 0;
    for (std::size_t byte = 0; byte < 8; ++byte) {
      // Gathers the lowest bits of eight bytes, the first of them into the lowest bit.
      std::uint64_t eight = 0;
      for (std::size_t k = 0; k < 8; ++k) eight |= std::uint64_t{reached[8 * byte + k]} << (8 * k);
      word |= (eight * 0x0102040810204080u) >> 56 << (8 * byte);
    }
    row[w] = word;
  }
}

SampleUnitFinder::Cubes SampleUnitFinder::cubes(const Regions& octree, double sigma) {
  Cubes made{sigma, octree.side(octree.main_level())};
  while (made.side > widest_unit * sigma) made.side *= 0.5;
  while (2 * made.side <= widest_unit * sigma && made.shift < octree.main_level()) {
    if (2 * made.side > octree.side(octree.main_level())) ++made.shift;
    made.side *= 2;
  }
  return made;
}

SampleUnitFinder::SampleUnitFinder(const ToleranceVolume& volume, double sigma, double flat_sigma,
                                   const CandidateOptions& options)
    : volume_(volume), options_(options), flat_options_(options), cubes_(cubes(volume.octree(), sigma)) {
  if (!(flat_sigma > 0)) return;
  flat_options_.target_bound = flat_sigma;
  flat_cubes_ = cubes(volume.octree(), flat_sigma);
}

bool SampleUnitFinder::together(Regions::CellIndex a, Regions::CellIndex b) const {
  const Regions::Cell p = volume_.octree().cell(a), q = volume_.octree().cell(b);
  const unsigned shift = flat_cubes_ ? flat_cubes_->shift : cubes_.shift;
  return p.x >> shift == q.x >> shift && p.y >> shift == q.y >> shift && p.z >> shift == q.z >> shift;
}

std::vector<SampleUnit> SampleUnitFinder::find(std::span<const Regions::CellIndex> main_cells) const {
  std::vector<SampleCandidate> list, flat;
  FlatCandidates flats(volume_, flat_options_);
  for (const Regions::CellIndex i : main_cells) {
    const CandidateCube cube = cube_of(volume_, volume_.octree().cell(i));
    if (!flat_cubes_ || !flats.add(cube, flat)) find_candidates(volume_, cube, options_, list);
  }
  std::vector<SampleUnit> units;
  if (flat_cubes_) group(flat, *flat_cubes_, units);
  group(list, cubes_, units);
  return units;
}

std::vector<SampleUnit> SampleUnitFinder::find(const CandidateCube& part) const {
  std::vector<SampleCandidate> list;
  find_candidates(volume_, part, options_, list);
  std::vector<SampleUnit> units;
  group(list, cubes_, units);
  return units;
}

std::optional<double> SampleUnitFinder::part_side() const {
  const double part = units_by_part * cubes_.side;
  if (part * (1 + 1e-9) < volume_.octree().side(volume_.octree().main_level())) return part;
  return std::nullopt;
}

void SampleUnitFinder::group(const std::vector<SampleCandidate>& list, const Cubes& cubes,
                             std::vector<SampleUnit>& units) const {
  const Regions& octree = volume_.octree();
  const auto cube = [&](const SampleCandidate& c) {
    const Vec3 u = (c.center - octree.origin()) / cubes.side;
    return std::array{std::floor(u.x), std::floor(u.y), std::floor(u.z)};
  };
  for (std::size_t begin = 0, end = 0; begin < list.size(); begin = end) {
    while (end < list.size() && end - begin < most_cells && cube(list[end]) == cube(list[begin])) ++end;
    const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    units.emplace_back(std::vector<SampleCandidate>(at(begin), at(end)), cubes.sigma);
  }
}

} // namespace isoscope
