// The octree of the complement of Ω'.
#include "tolerance/regions.h"

#include "base/parallel.h"
#include "tolerance/rounding.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <queue>
#include <unordered_set>

namespace isoscope {
namespace {

/// Cell positions are 32-bit, and face tests shift them to this level.
constexpr unsigned deepest_level = 30;
constexpr std::size_t most_cells = std::size_t{1} << 31;
/// Ways from the root begin at cells of a level of which there are less than one in so many.
constexpr std::size_t cells_by_entry = 16;
/// A flood splits many cells on its way through one.
constexpr std::uint32_t cells_between_questions = 64;

Error stopped() {
  return {ErrorCode::cancelled, "Stopped while building the tolerance volume.", ""};
}

std::array<std::uint32_t, 3> position(const Regions::Cell& c) {
  return {c.x, c.y, c.z};
}

/// From so many cells on those of finer levels can be told, and how far beyond the memory limit they must be
/// then not to be tried.
constexpr std::size_t telling_cells = 20000;
constexpr double clearly_more = 1.3;

/// Whether the cells down to some level fit, and those of the levels that are left as far as can be told:
/// along a surface, each level has four times as many as the one above.
Status check_memory(std::size_t cells, unsigned levels_left, const Regions::Options& options) {
  const double in_all = static_cast<double>(cells) * std::pow(4.0, levels_left);
  const double told = cells < telling_cells ? 0 : std::min(in_all, options.expected_cells);
  const double bytes = Regions::bytes_of_cell;
  if (static_cast<double>(cells) * bytes <= options.most_bytes &&
      told * bytes <= clearly_more * options.most_bytes)
    return {};
  char message[200], remedy[200];
  std::snprintf(
      message, sizeof message,
      "The tolerance is too small for this input: the cells of its volume need about %.2g GB, more than "
      "may be used.",
      1e-9 * bytes * (told > 0 ? told : in_all));
  std::snprintf(remedy, sizeof remedy,
                "Choose a tolerance about %.2g times as large, or give more with --memory-limit.",
                std::sqrt(in_all * bytes / options.most_bytes));
  return Error{ErrorCode::unsupported, message, remedy};
}

} // namespace

Regions::Regions(const ToleranceField& field, const Options& options)
    : field_(&field), boundary_(options.boundary) {
  // The domain is what the main side times a power of two makes it, so that main cells are as large as they
  // may be.
  const double needed = (field.bounds().longest_edge() + 2 * options.margin) * 1.0001;
  domain_side_ = options.main_side;
  while (main_level_ < deepest_level && domain_side_ < needed) domain_side_ *= 2, ++main_level_;
  domain_side_ = std::max(domain_side_, needed);
  max_level_ = main_level_;
  while (max_level_ < deepest_level && side(max_level_) > options.min_side) ++max_level_;
  const double half = 0.5 * domain_side_;
  origin_ = field.bounds().center() - Vec3{half, half, half};
}

Vec3 Regions::center(const Cell& c) const {
  const double s = side(c.level);
  return origin_ + Vec3{(c.x + 0.5) * s, (c.y + 0.5) * s, (c.z + 0.5) * s};
}

Box3 Regions::domain() const {
  return {origin_, origin_ + Vec3{domain_side_, domain_side_, domain_side_}};
}

Regions::Cell Regions::cell(CellIndex i) const {
  const Siblings& s = at(i);
  const unsigned k = place(i);
  Cell c;
  c.x = s.first[0] + (k & 1u);
  c.y = s.first[1] + ((k >> 1) & 1u);
  c.z = s.first[2] + (k >> 2);
  c.kind = s.kind[k];
  if (c.kind == Kind::ambiguous) c.child = s.link[k];
  c.triangle = s.triangle[k];
  c.distance = s.distance[k];
  c.level = s.level;
  return c;
}

Regions::CellIndex Regions::add_children(CellIndex i) {
  const Cell parent = cell(i);
  const auto first = static_cast<CellIndex>(size());
  Siblings children;
  children.first = {2 * parent.x, 2 * parent.y, 2 * parent.z};
  children.level = static_cast<std::uint8_t>(parent.level + 1);
  children.link.fill(none);
  link(i) = first;
  siblings_.push_back(children);
  return first;
}

void Regions::classify(CellIndex i, TriangleId guess, const TriangleNeighborhood& near) {
  const Cell c = cell(i);
  const Vec3 at = center(c);
  const ClosestPoint closest = field_->closest_near(at, guess, near);
  const double d = closest.distance(), reach = half_diagonal * side(c.level);
  Kind kind = d > boundary_ + reach ? Kind::out : (d + reach <= boundary_ ? Kind::in : Kind::ambiguous);
  if (const auto range = field_->range_in_cube(at, 0.5 * side(c.level)))
    kind = range->least > boundary_ ? Kind::out : range->most <= boundary_ ? Kind::in : Kind::ambiguous;
  Siblings& s = siblings_[group(i)];
  const unsigned k = place(i);
  s.distance[k] = static_cast<float>(d);
  s.triangle[k] = closest.triangle;
  s.kind[k] = kind;
  if (kind == Kind::out) s.link[k] = i;
}

/// Every site that gives φ at some child's centre gives at most a diagonal more than φ at the parent's.
void Regions::classify_children(CellIndex parent) {
  const Cell p = cell(parent);
  TriangleNeighborhood near;
  field_->find_neighborhood(center(p), static_cast<double>(p.distance) + 1.01 * half_diagonal * side(p.level),
                            near);
  for (unsigned k = 0; k < 8; ++k) classify(p.child + k, p.triangle, near);
}

Result<Regions> Regions::build(const ToleranceField& field, const Options& options,
                               const RunControl& control) {
  Regions r(field, options);
  auto& siblings = r.siblings_;
  Siblings root;
  root.first.fill(~std::uint32_t{0}); // one before 0, which the last of them is at
  root.link.fill(none);
  siblings.push_back(root);
  std::vector<CellIndex> parents; // of each group of eight in the level
  std::size_t level_begin = 0;
  for (unsigned level = 0; level <= r.main_level_; ++level) {
    if (control.cancelled()) return stopped();
    control.report("regions", static_cast<double>(level) / (r.main_level_ + 1));
    const std::size_t level_end = r.size();
    if (level == 0)
      r.classify(0, TriangleId(), {});
    else
      parallel_until(parents.size(), 32, control, [&](std::size_t i) { r.classify_children(parents[i]); });
    if (level < r.main_level_) {
      parents.clear();
      for (std::size_t i = level_begin; i < level_end; ++i)
        if (r.kind(static_cast<CellIndex>(i)) == Kind::ambiguous)
          parents.push_back(static_cast<CellIndex>(i));
      if (r.size() + 8 * parents.size() > most_cells)
        return Error{ErrorCode::unsupported,
                     "The tolerance is too small for this input: its volume needs too many cells.",
                     "Choose a larger tolerance."};
      if (Status fits = check_memory(r.size() + 8 * parents.size(), r.main_level_ - level - 1, options);
          !fits)
        return fits.error();
      siblings.reserve(siblings.size() + parents.size());
      SparsePoll poll(control);
      for (const CellIndex p : parents) {
        if (poll.cancelled()) break;
        r.add_children(p);
      }
    }
    level_begin = level_end;
  }
  r.main_size_ = r.size();
  r.fill_entries();
  r.unite_main(control);
  if (control.cancelled()) return stopped();
  return r;
}

/// Leaves above the main level are not ambiguous, so that they stay leaves.
void Regions::fill_entries() {
  while (entry_level_ < main_level_ && std::size_t{1} << (3 * entry_level_ + 3) <= size() / cells_by_entry)
    ++entry_level_;
  const std::uint32_t n = 1u << entry_level_;
  std::vector<CellIndex> entries(std::size_t{n} * n * n);
  for (std::uint32_t k = 0; k < entries.size(); ++k) {
    const std::array u{k & (n - 1), k >> entry_level_ & (n - 1), k >> (2 * entry_level_)};
    CellIndex i = 0;
    for (unsigned shift = entry_level_; shift-- > 0 && child(i) != none;)
      i = child(i) + ((u[0] >> shift) & 1u) + 2 * ((u[1] >> shift) & 1u) + 4 * ((u[2] >> shift) & 1u);
    entries[k] = i;
  }
  entries_ = std::move(entries);
}

void Regions::unite_main(const RunControl& control) {
  const auto find = [this](CellIndex i, std::vector<CellLink>& links) {
    if (kind(i) != Kind::out) return;
    const Cell c = cell(i);
    for (int face = 0; face < 6; ++face) {
      const CellIndex j = neighbor(c, face);
      // Of two of the same level one tells.
      if (j == none || kind(j) != Kind::out || (at(j).level == c.level && face % 2 == 0)) continue;
      links.push_back({i, j});
    }
  };
  for_each_link(size(), control, find, [this](const CellLink& link) { unite(link.a, link.b); });
}

Regions::CellIndex Regions::neighbor(const Cell& c, int face) const {
  auto p = position(c);
  auto& coordinate = p[static_cast<std::size_t>(face / 2)];
  const std::uint32_t last = (1u << c.level) - 1;
  if (coordinate == (face % 2 ? last : 0u)) return none;
  coordinate += face % 2 ? 1u : 0xffffffffu;
  return cell_at(c.level, p);
}

Regions::CellIndex Regions::cell_at(unsigned level, const std::array<std::uint32_t, 3>& p) const {
  CellIndex j = 0;
  unsigned reached = 0;
  if (level >= entry_level_) {
    const unsigned above = level - entry_level_;
    j = entry(p[0] >> above, p[1] >> above, p[2] >> above);
    reached = at(j).level;
  }
  while (reached < level) {
    const CellIndex below = child(j);
    if (below == none) break;
    const unsigned shift = level - ++reached;
    j = below + ((p[0] >> shift) & 1u) + 2 * ((p[1] >> shift) & 1u) + 4 * ((p[2] >> shift) & 1u);
  }
  return j;
}

/// Whether b, which does not hold a, shares area with that face of a on its far side.
bool Regions::touches(const Cell& a, const Cell& b, int face) const {
  const auto pa = position(a), pb = position(b);
  const unsigned sa = deepest_level - a.level, sb = deepest_level - b.level;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint64_t a0 = std::uint64_t{pa[axis]} << sa, a1 = (std::uint64_t{pa[axis]} + 1) << sa;
    const std::uint64_t b0 = std::uint64_t{pb[axis]} << sb, b1 = (std::uint64_t{pb[axis]} + 1) << sb;
    if (axis != static_cast<std::size_t>(face / 2)) {
      if (b1 <= a0 || b0 >= a1) return false;
    } else if (face % 2 ? b0 > a1 || b1 <= a1 : b1 < a0 || b0 >= a0) {
      return false;
    }
  }
  return true;
}

void Regions::split(CellIndex i) {
  const TriangleId guess = at(i).triangle[place(i)];
  const CellIndex first = add_children(i);
  for (unsigned k = 0; k < 8; ++k) classify(first + k, guess, {});
}

/// Walks from an entry towards p until ends_at(i), which may split a leaf; p is on the way.
template <class EndsAt> Regions::CellIndex Regions::descend(Vec3 p, const EndsAt& ends_at) const {
  const Box3 domain = this->domain();
  for (int a = 0; a < 3; ++a)
    if (!(p[a] >= domain.lo[a] && p[a] < domain.hi[a])) return none;
  const double deepest = static_cast<double>(1u << deepest_level);
  std::array<std::uint32_t, 3> u{};
  for (int a = 0; a < 3; ++a) {
    const double t = (p[a] - domain.lo[a]) / side(0) * deepest;
    u[static_cast<std::size_t>(a)] = static_cast<std::uint32_t>(std::clamp(t, 0.0, deepest - 1));
  }
  const unsigned above = deepest_level - entry_level_;
  CellIndex i = entry(u[0] >> above, u[1] >> above, u[2] >> above);
  for (unsigned shift = deepest_level - 1 - at(i).level;; --shift) {
    if (ends_at(i)) return i;
    i = child(i) + ((u[0] >> shift) & 1u) + 2 * ((u[1] >> shift) & 1u) + 4 * ((u[2] >> shift) & 1u);
  }
}

Regions::CellIndex Regions::locate(Vec3 p) const {
  return descend(p, [&](CellIndex i) { return child(i) == none; });
}

Regions::CellIndex Regions::locate_among(Vec3 p, std::size_t count) const {
  return descend(p, [&](CellIndex i) { return child(i) >= count; });
}

Regions::CellIndex Regions::locate_refining(Vec3 p) {
  return descend(p, [&](CellIndex i) {
    if (child(i) != none) return false;
    if (kind(i) != Kind::ambiguous || at(i).level >= max_level_) return true;
    split(i);
    return false;
  });
}

std::vector<CellLink> Regions::leaf_links(const RunControl& control) const {
  std::vector<CellLink> links;
  // Most leaves have three links. What grows would need room twice.
  links.reserve(size() / 8 * 7 * 3);
  const auto find = [this](CellIndex i, std::vector<CellLink>& of_cell) {
    const Cell c = cell(i);
    if (c.child != none) return;
    for (int face = 0; face < 6; ++face) {
      const CellIndex j = neighbor(c, face);
      // Finer neighbours link themselves, and of two of the same level one does.
      if (j == none || child(j) != none || (at(j).level == c.level && face % 2 == 0)) continue;
      of_cell.push_back({i, j});
    }
  };
  for_each_link(size(), control, find, [&](const CellLink& link) { links.push_back(link); });
  return links;
}

Regions::CellIndex Regions::root(CellIndex i) const {
  if (kind(i) != Kind::out) return i;
  for (;;) {
    const CellIndex parent = at(i).link[place(i)];
    if (parent == i) return i;
    i = parent;
  }
}

Regions::CellIndex Regions::compress(CellIndex i) {
  while (link(i) != i) i = link(i) = link(link(i));
  return i;
}

void Regions::flatten(const RunControl& control) {
  SparsePoll poll(control);
  for (CellIndex i = 0; i < size() && !poll.cancelled(); ++i)
    if (kind(i) == Kind::out) link(i) = root(i);
}

void Regions::unite(CellIndex a, CellIndex b) {
  const CellIndex at = b;
  a = compress(a);
  b = compress(b);
  if (a == b) return;
  const bool numbered_a = numbers_.contains(a), numbered_b = numbers_.contains(b);
  if (numbered_a && numbered_b) passages_.push_back({at, {numbers_.at(a), numbers_.at(b)}});
  const bool keep_a = numbered_a != numbered_b ? numbered_a : a < b;
  link(keep_a ? b : a) = keep_a ? a : b;
}

std::optional<std::uint32_t> Regions::number(CellIndex i) const {
  const auto found = numbers_.find(root(i));
  if (found == numbers_.end()) return std::nullopt;
  return found->second;
}

bool Regions::flood(CellIndex start, std::size_t budget, const RunControl& control) {
  return flood_through(
      start, budget, [](CellIndex) { return true; }, control);
}

bool Regions::flood_through(CellIndex start, std::size_t budget, const std::function<bool(CellIndex)>& enters,
                            const RunControl& control) {
  SparsePoll poll(control, cells_between_questions);
  std::priority_queue<std::pair<float, CellIndex>> queue;
  std::unordered_set<CellIndex> seen{start}; // asked for membership only
  std::vector<CellIndex> below;
  queue.push({distance(start), start});
  for (std::size_t visited = 0; !queue.empty() && visited < budget && !poll.cancelled(); ++visited) {
    const CellIndex i = queue.top().second;
    queue.pop();
    const Cell from = cell(i);
    for (int face = 0; face < 6; ++face) {
      const CellIndex across = neighbor(from, face);
      if (across == none) continue;
      below.assign(1, across);
      while (!below.empty()) {
        const CellIndex j = below.back();
        below.pop_back();
        const Cell c = cell(j);
        if (c.kind == Kind::in || !touches(from, c, face)) continue;
        if (c.child == none && !enters(j)) continue;
        if (c.kind == Kind::out) {
          const CellIndex other = compress(j);
          const bool met = is_goal(other) && other != compress(start);
          unite(i, j);
          if (met) return true;
          if (seen.insert(j).second) queue.push({c.distance, j});
          continue;
        }
        if (c.child == none) {
          if (c.level >= max_level_) continue;
          split(j);
        }
        for (unsigned k = 0; k < 8; ++k) below.push_back(child(j) + k);
      }
    }
  }
  return false;
}

std::size_t Regions::memory_bytes() const {
  return siblings_.size() * sizeof(Siblings) + entries_.capacity() * sizeof(CellIndex);
}

} // namespace isoscope
