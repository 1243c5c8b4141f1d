// Balls in parallel, then pieces of sides and what they say of each other.
#include "tolerance/ball_test.h"

#include "base/disjoint_sets.h"
#include "base/parallel.h"
#include "base/place.h"
#include "tolerance/sample_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace isoscope {
namespace {

/// How far centres of balls are from each other, in units of δ'.
constexpr double center_spacing = 1.0 / 3;
/// Steps by which B may grow until the sides part.
constexpr int most_growth = 6;
/// What is left of a side below that share of the samples of its sheet is no piece of its own.
constexpr double smallest_piece = 0.01;
/// Both sides hang together where so much of what balls say is against it.
constexpr double most_against = 0.05;
/// Samples of each side of a ball that are remembered.
constexpr std::size_t remembered = 6;
constexpr std::uint32_t none = 0xffffffffu;

/// Two sets of samples in a ball that do not hang together: what lies across from each other.
struct Across {
  Vec3 center;
  std::array<std::array<std::uint32_t, remembered>, 2> samples;
  std::array<std::uint8_t, 2> counts{};
};

class BallTest {
 public:
  BallTest(const ToleranceVolume& volume, const BoundarySamples& samples,
           std::span<const std::uint8_t> sheets, double gamma, const RunControl& control)
      : volume_(volume), samples_(samples), radius_(gamma * volume.thresholds().boundary),
        grid_(volume.domain().lo, 2 * samples.sigma), sheet_(samples.size(), none), in_b_(samples.size(), 0),
        piece_(samples.size(), none) {
    for (std::uint32_t i = 0; i < samples.size(); ++i) {
      grid_.add(samples.positions[i]);
      const std::uint32_t c = component_of(i);
      if (c != VolumeComponents::none && sheets[c] != 0) sheet_[i] = c;
    }
    choose_centers(sheets, control);
  }

  Result<SheetSides> run(const RunControl& control) {
    test_balls(control);
    SheetSides result;
    std::optional<Vec3> against;
    for (int growth = 0; !control.cancelled(); ++growth) {
      find_pieces(control);
      if (control.cancelled()) break;
      if (const auto whole = sheet_without_pieces()) return against ? joined_near(*against) : *whole;
      spread(control);
      against = find_sides(control);
      if (growth == 0) may_part_ = grown(in_b_, control);
      if (!against && growth > 0) against = parted_far_from_end(control);
      if (!against) break;
      if (growth == most_growth) return joined_near(*against);
      in_b_ = grown(in_b_, control);
    }
    if (control.cancelled()) return SheetSides{};
    result.labels.assign(samples_.size(), 0);
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (sheet_[i] != none && piece_[i] != none) result.labels[i] = side_[piece_[i]];
    result.boundary_samples = static_cast<std::size_t>(std::count(in_b_.begin(), in_b_.end(), 1));
    return result;
  }

 private:
  std::uint32_t component_of(std::uint32_t i) const {
    const std::uint16_t c = samples_.components[i];
    if (c < volume_.boundary_components().size()) return volume_.boundary_components()[c].volume_component;
    return volume_.volume_component(volume_.field().closest(samples_.positions[i]).triangle);
  }

  /// Sites of sheets, one in each small cube.
  void choose_centers(std::span<const std::uint8_t> sheets, const RunControl& control) {
    const double side = center_spacing * volume_.thresholds().boundary;
    std::set<std::array<double, 3>> taken;
    SparsePoll poll(control, 4096);
    for (std::uint32_t s = 0; s < volume_.field().size() && !poll.cancelled(); ++s) {
      const std::uint32_t c = volume_.volume_component(TriangleId(s));
      if (c == VolumeComponents::none || sheets[c] == 0) continue;
      for (const Vec3 p : places_on(TriangleId(s), side))
        if (taken.insert({std::floor(p.x / side), std::floor(p.y / side), std::floor(p.z / side)}).second)
          centers_.emplace_back(p, c);
    }
  }

  /// Places of a site, no farther from each other than that.
  std::vector<Vec3> places_on(TriangleId site, double spacing) const {
    if (!volume_.has_surface()) return {volume_.field().place_of(site)};
    const Triangle3& t = volume_.index().triangle(site);
    const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
    const int n = static_cast<int>(std::max(1.0, std::ceil(longest / spacing)));
    std::vector<Vec3> places;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
        places.push_back(t[0] + (static_cast<double>(i) / n) * (t[1] - t[0]) +
                         (static_cast<double>(j) / n) * (t[2] - t[0]));
    return places;
  }

  /// Calls visit(j) for the samples j of the same sheet within 2σ of sample i.
  template <class Visit> void for_each_near(std::uint32_t i, std::vector<std::uint32_t>& near, Visit visit) {
    const Vec3 p = samples_.positions[i];
    near.clear();
    grid_.gather(Box3{p, p}.grown(2 * samples_.sigma), near);
    for (const std::uint32_t j : near)
      if (j != i && sheet_[j] == sheet_[i] && distance(samples_.positions[j], p) <= 2 * samples_.sigma)
        visit(j);
  }

  void test_balls(const RunControl& control) {
    std::vector<std::vector<std::uint32_t>> whole(centers_.size());
    std::vector<Across> across(centers_.size());
    parallel_until(centers_.size(), 8, control, [&](std::size_t c) {
      const auto [center, sheet] = centers_[c];
      std::vector<std::uint32_t> in;
      grid_.gather(Box3{center, center}.grown(radius_), in);
      std::erase_if(in, [&, from = center, of = sheet](std::uint32_t i) {
        return sheet_[i] != of || distance(samples_.positions[i], from) > radius_;
      });
      if (in.empty()) return;
      std::sort(in.begin(), in.end());
      const std::vector<std::vector<std::uint32_t>> parts = parts_of(in);
      across[c].center = center;
      if (parts.size() == 1) {
        whole[c] = std::move(in);
        return;
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const std::size_t stride = parts[k].size() / remembered + 1;
        for (std::size_t i = 0; i < parts[k].size(); i += stride)
          across[c].samples[k][across[c].counts[k]++] = parts[k][i];
      }
    });
    for (const auto& list : whole)
      for (const std::uint32_t i : list) in_b_[i] = 1;
    for (const Across& a : across)
      if (a.counts[0] > 0) across_.push_back(a);
  }

  /// Those of some samples that hang together by steps of 2σ, largest first.
  std::vector<std::vector<std::uint32_t>> parts_of(std::span<const std::uint32_t> in) const {
    std::vector<std::vector<std::uint32_t>> parts;
    std::vector<std::uint32_t> left(in.begin(), in.end());
    while (!left.empty()) {
      std::vector<std::uint32_t>& part = parts.emplace_back();
      part.push_back(left.back());
      left.pop_back();
      for (std::size_t k = 0; k < part.size() && !left.empty(); ++k) {
        const Vec3 p = samples_.positions[part[k]];
        const auto rest = std::partition(left.begin(), left.end(), [&](std::uint32_t j) {
          return distance(samples_.positions[j], p) > 2 * samples_.sigma;
        });
        part.insert(part.end(), rest, left.end());
        left.erase(rest, left.end());
      }
      std::sort(part.begin(), part.end());
    }
    std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
      return a.size() != b.size() ? a.size() > b.size() : a.front() < b.front();
    });
    return parts;
  }

  /// What hangs together of what is not B; small pieces are none.
  void find_pieces(const RunControl& control) {
    DisjointSets sets(samples_.size());
    SparsePoll poll(control, 4096);
    std::vector<std::uint32_t> near;
    const auto counts = [&](std::uint32_t i) { return sheet_[i] != none && in_b_[i] == 0; };
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i)
      if (counts(i))
        for_each_near(i, near, [&](std::uint32_t j) {
          if (counts(j)) sets.unite(i, j);
        });
    std::map<std::uint32_t, std::size_t> sizes, of_sheets;
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
      if (sheet_[i] != none) ++of_sheets[sheet_[i]];
      if (counts(i)) ++sizes[sets.find(i)];
    }
    std::map<std::uint32_t, std::uint32_t> numbers;
    for (const auto& [first, size] : sizes)
      if (static_cast<double>(size) >= smallest_piece * static_cast<double>(of_sheets[sheet_[first]]))
        numbers.emplace(first, static_cast<std::uint32_t>(numbers.size()));
    std::fill(piece_.begin(), piece_.end(), none);
    pieces_ = numbers.size();
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (const auto at = counts(i) ? numbers.find(sets.find(i)) : numbers.end(); at != numbers.end())
        piece_[i] = at->second;
  }

  std::optional<Error> sheet_without_pieces() const {
    std::map<std::uint32_t, bool> has;
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (sheet_[i] != none) has[sheet_[i]] = has[sheet_[i]] || piece_[i] != none;
    for (const auto& [center, sheet] : centers_) {
      const auto found = has.find(sheet);
      if (found != has.end() && found->second) continue;
      return Error{ErrorCode::open_surface,
                   "No sheet with two sides was found around the points near " + place(center, place_digits) +
                       ": all of it is nearer to where it ends than the balls of --gamma reach.",
                   "Choose a smaller tolerance, or a smaller --gamma; points that fill a volume or follow a "
                   "curve have no sides."};
    }
    return std::nullopt;
  }

  /// What is B goes with the piece that is nearest along the samples.
  void spread(const RunControl& control) {
    struct Step {
      double way;
      std::uint32_t sample, piece;
      bool operator>(const Step& o) const {
        return std::tie(way, sample, piece) > std::tie(o.way, o.sample, o.piece);
      }
    };
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
    SparsePoll poll(control, 4096);
    std::vector<std::uint32_t> near;
    const auto go_on = [&](std::uint32_t i, double way, std::uint32_t piece) {
      for_each_near(i, near, [&](std::uint32_t j) {
        if (piece_[j] == none)
          queue.push({way + distance(samples_.positions[i], samples_.positions[j]), j, piece});
      });
    };
    std::vector<std::uint32_t> sources;
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (piece_[i] != none) sources.push_back(i);
    for (const std::uint32_t i : sources) go_on(i, 0, piece_[i]);
    while (!queue.empty() && !poll.cancelled()) {
      const Step step = queue.top();
      queue.pop();
      if (piece_[step.sample] != none) continue;
      piece_[step.sample] = step.piece;
      go_on(step.sample, step.way, step.piece);
    }
  }

  /// Two pieces are on different sides where balls see them across from each other; of others those that meet
  /// are on one. A place where what balls see is against that, where there is enough of it.
  std::optional<Vec3> find_sides(const RunControl& control) {
    using Pair = std::pair<std::uint32_t, std::uint32_t>;
    std::map<Pair, std::size_t> across, meeting;
    const auto pieces_across = [&](const Across& a) {
      std::set<Pair> pairs;
      for (std::size_t i = 0; i < a.counts[0]; ++i)
        for (std::size_t j = 0; j < a.counts[1]; ++j) {
          const std::uint32_t s = a.samples[0][i], t = a.samples[1][j];
          if (in_b_[s] == 0 && in_b_[t] == 0 && piece_[s] != none && piece_[t] != none)
            pairs.insert(std::minmax(piece_[s], piece_[t]));
        }
      return pairs;
    };
    for (const Across& a : across_)
      for (const Pair& p : pieces_across(a)) ++across[p];
    std::vector<std::uint32_t> near;
    SparsePoll poll(control, 4096);
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i)
      if (piece_[i] != none)
        for_each_near(i, near, [&](std::uint32_t j) {
          if (piece_[j] != none && piece_[i] < piece_[j]) ++meeting[{piece_[i], piece_[j]}];
        });
    struct Relation {
      bool across;
      std::size_t weight;
      Pair pieces;
    };
    std::vector<Relation> relations;
    for (const auto& [pair, n] : across)
      if (pair.first != pair.second) relations.push_back({true, n, pair});
    for (const auto& [pair, n] : meeting)
      if (!across.contains(pair)) relations.push_back({false, n, pair});
    std::stable_sort(relations.begin(), relations.end(), [](const Relation& a, const Relation& b) {
      return std::tuple(a.across, a.weight) > std::tuple(b.across, b.weight);
    });
    // Groups of pieces whose sides hang together, and how each is turned in its group.
    std::vector<std::uint32_t> group(pieces_);
    std::vector<std::int8_t> turn(pieces_, +1);
    for (std::uint32_t k = 0; k < pieces_; ++k) group[k] = k;
    for (const Relation& r : relations) {
      const auto [a, b] = r.pieces;
      if (group[a] == group[b]) continue;
      const auto flip = static_cast<std::int8_t>((r.across ? -1 : +1) * turn[a] * turn[b]);
      const std::uint32_t from = group[b], to = group[a];
      for (std::uint32_t k = 0; k < pieces_; ++k)
        if (group[k] == from) group[k] = to, turn[k] = static_cast<std::int8_t>(turn[k] * flip);
    }
    // Outside is the larger side.
    std::vector<long> balance(pieces_, 0);
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (piece_[i] != none) balance[group[piece_[i]]] += turn[piece_[i]];
    side_.resize(pieces_);
    for (std::uint32_t k = 0; k < pieces_; ++k)
      side_[k] = static_cast<std::int8_t>(balance[group[k]] < 0 ? -turn[k] : turn[k]);
    std::map<std::uint32_t, std::array<std::size_t, 2>> said; // by group: against, all
    std::map<std::uint32_t, Vec3> places;
    for (const Across& a : across_)
      for (const auto& [one, other] : pieces_across(a)) {
        ++said[group[one]][1];
        if (side_[one] != side_[other]) continue;
        ++said[group[one]][0];
        places.emplace(group[one], a.center);
      }
    for (std::uint32_t k = 0; k < pieces_; ++k) {
      const auto [against, all] = said[group[k]];
      const bool alone = std::none_of(side_.begin(), side_.end(), [&, k](const std::int8_t& s) {
        return group[static_cast<std::size_t>(&s - side_.data())] == group[k] && s == -side_[k];
      });
      if (alone || static_cast<double>(against) > most_against * static_cast<double>(all))
        return places.contains(group[k]) ? places[group[k]] : place_in(k);
    }
    return std::nullopt;
  }

  Vec3 place_in(std::uint32_t piece) const {
    const auto at = std::find(piece_.begin(), piece_.end(), piece) - piece_.begin();
    return samples_.positions[static_cast<std::size_t>(at)];
  }

  /// With what is a step from it.
  std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& from, const RunControl& control) {
    SparsePoll poll(control, 4096);
    std::vector<std::uint32_t> near;
    std::vector<std::uint8_t> more = from;
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i)
      if (from[i] != 0) for_each_near(i, near, [&](std::uint32_t j) { more[j] = 1; });
    return more;
  }

  /// A place where both sides meet that is not at the end of the sheet, as the balls found it: B has grown
  /// across a sheet with one side.
  std::optional<Vec3> parted_far_from_end(const RunControl& control) {
    SparsePoll poll(control, 4096);
    std::vector<std::uint32_t> near;
    for (std::uint32_t i = 0; i < samples_.size() && !poll.cancelled(); ++i) {
      if (piece_[i] == none || may_part_[i] != 0) continue;
      bool meets = false;
      for_each_near(i, near, [&](std::uint32_t j) {
        meets = meets || (piece_[j] != none && may_part_[j] == 0 && side_[piece_[i]] != side_[piece_[j]]);
      });
      if (meets) return samples_.positions[i];
    }
    return std::nullopt;
  }

  static Error joined_near(Vec3 p) {
    return {ErrorCode::open_surface,
            "The sides of the points cannot be told near " + place(p, place_digits) +
                ": what lies across from each other there is one side, as on a Möbius strip, or where the "
                "points leave holes or fill a volume.",
            "A larger tolerance closes holes; a strip with one side must be cut."};
  }

  const ToleranceVolume& volume_;
  const BoundarySamples& samples_;
  double radius_;
  SampleGrid grid_;
  std::vector<std::uint32_t> sheet_;   ///< by sample: the component of Ω' that it is around, of sheets
  std::vector<std::uint8_t> in_b_;     ///< by sample
  std::vector<std::uint8_t> may_part_; ///< by sample: no farther than a step from what balls found to be B
  std::vector<std::uint32_t> piece_;   ///< by sample
  std::vector<std::pair<Vec3, std::uint32_t>> centers_; ///< with their sheets
  std::vector<Across> across_;
  std::size_t pieces_ = 0;
  std::vector<std::int8_t> side_; ///< by piece
};

} // namespace

Result<SheetSides> tell_sheet_sides(const ToleranceVolume& volume, const BoundarySamples& samples,
                                    std::span<const std::uint8_t> sheets, double gamma,
                                    const RunControl& control) {
  return BallTest(volume, samples, sheets, gamma, control).run(control);
}

} // namespace isoscope
