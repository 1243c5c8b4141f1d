// The proofs of a whole mesh on the part of it that is met by one tile.
#include "tiles/tile_proof.h"

#include "base/halves.h"
#include "base/parallel.h"
#include "run/proof_budget.h"
#include "tiles/tile_piece.h"
#include "tiles/tile_schedule.h"
#include "tolerance/piece_witnesses.h"

#include <algorithm>
#include <functional>

namespace isoscope {
namespace {

constexpr double input_precision = 0.01; ///< of the input's distance, in δ
constexpr double first_reach = 4;        ///< where facets are looked for that are near to the input, in δ
/// Of a tile's side: what is longer is cut into pieces, each of which lies in the tile that has its middle,
/// or this far beyond.
constexpr double longest_piece = 1.0 / 8;

double longest_edge(const Triangle3& t) {
  const std::size_t i = longest_edge_of(t);
  return distance(t[i], t[(i + 1) % 3]);
}

/// The pieces of a triangle whose middles lie in a tile.
class PiecesInTile {
 public:
  PiecesInTile(const TileGrid& grid, const ProofPlan& plan, const GridPlace& tile)
      : plan_(plan), box_(grid.bounds(plan.tiling, tile)) {}

  bool holds(Vec3 p) const { return box_.holds(p); }
  Box3 box() const { return {box_.lo, box_.hi}; }
  /// How far from the tile a point of a piece may be.
  double margin() const { return plan_.tiling.whole ? 0 : plan_.piece; }

  template <class Take> void each_of(const Triangle3& whole, const Take& take) const {
    if (!box_of(whole).meets(box())) return;
    if (is_piece(whole)) {
      if (holds(middle(whole))) take(whole);
      return;
    }
    for (const Triangle3& half : halves(whole)) each_of(half, take);
  }
  bool has_any_of(const Triangle3& whole) const {
    bool any = false;
    each_of(whole, [&](const Triangle3&) { any = true; });
    return any;
  }

 private:
  bool is_piece(const Triangle3& t) const { return plan_.tiling.whole || longest_edge(t) <= plan_.piece; }
  /// In the box of the corners, whatever rounding does.
  static Vec3 middle(const Triangle3& t) {
    const Box3 box = box_of(t);
    Vec3 p = centroid(t);
    for (int i = 0; i < 3; ++i) p[i] = std::clamp(p[i], box.lo[i], box.hi[i]);
    return p;
  }

  const ProofPlan& plan_;
  ChangeBox box_;
};

/// One tile's proof in the making.
class TileProver {
 public:
  TileProver(const TileFolder& folder, const ProofPlan& plan, const GridPlace& tile,
             const RunControl& control)
      : folder_(folder), plan_(plan), pieces_(folder.grid(), plan, tile), control_(control),
        delta_(folder.manifest().delta), stop_([&control] { return control.cancelled(); }) {}

  Result<TileProof> prove() {
    auto z = folder_.z_before(plan_.round, pieces_.box());
    if (!z) return z.error();
    keep_meeting(*z, pieces_.box());
    facets_ = std::move(*z);
    auto input = read_input();
    if (!input) return input.error();
    if (!facets_.empty()) {
      proof_.surface = judge_surface(
          mesh_of(facets_), [this](Vec3 p) { return pieces_.holds(p); }, stop_);
      if (stop_()) return stopped();
    }
    const bool walls = std::any_of(input->begin(), input->end(),
                                   [this](const Triangle3& t) { return pieces_.has_any_of(t); });
    if (facets_.empty() && !walls) return std::move(proof_);
    if (Status measured = ask_input(std::move(*input), walls); !measured) return measured.error();
    if (walls && plan_.cover.measure)
      if (Status covered = judge_walls(); !covered) return covered.error();
    return std::move(proof_);
  }

 private:
  static Error stopped() { return {ErrorCode::cancelled, "The proof was stopped.", "Join the tiles again."}; }

  Result<std::vector<Triangle3>> read_input() const {
    const Box3 around = pieces_.box().grown(pieces_.margin() + tile_input_reach * delta_);
    auto input = folder_.input(around);
    if (input) keep_meeting(*input, around);
    return input;
  }

  /// All that asks for distances from the input.
  Status ask_input(std::vector<Triangle3> input, bool walls) {
    const ClosestPointIndex index = index_of(std::move(input), control_);
    if (stop_()) return stopped();
    if (Status contained = judge_containment(index); !contained) return contained;
    if (walls) {
      auto witnesses = witnesses_of_piece(index, delta_, pieces_.box(), control_);
      if (!witnesses) return witnesses.error();
      proof_.witnesses = std::move(*witnesses);
    }
    if (!index.empty())
      proof_.normals = measure_normals(
          facets_, {index, plan_.facet_area, [this](Vec3 p) { return pieces_.holds(p); }}, control_);
    return stop_() ? Status(stopped()) : Status();
  }

  Status judge_containment(const ClosestPointIndex& index) {
    std::vector<ContainmentFigures> figures(facets_.size());
    const FacetSearch search{proof_budget, {}, nullptr, 0, &stop_};
    const bool complete = parallel_until(facets_.size(), 64, stop_, [&](std::size_t f) {
      pieces_.each_of(facets_[f], [&](const Triangle3& piece) {
        add_verdict(certify_facet(index, piece, delta_, delta_, search), figures[f]);
      });
    });
    if (!complete || stop_()) return stopped();
    ContainmentFigures& all = proof_.containment;
    for (std::size_t f = 0; f < figures.size(); ++f) {
      const ContainmentFigures& one = figures[f];
      all.max_distance = std::max(all.max_distance, one.max_distance);
      if (one.worst > all.worst) all.worst = one.worst, all.where = one.where;
      if (one.outside > 0)
        proof_.outside.push_back(canonical(facets_[f]));
      else if (one.undecided > 0)
        proof_.undecided.push_back(canonical(facets_[f]));
    }
    return {};
  }

  /// The pieces of the input, which is read anew: in memory it would be there twice.
  Result<std::vector<Triangle3>> read_walls() const {
    const auto input = read_input();
    if (!input) return input.error();
    std::size_t count = 0;
    for (const Triangle3& t : *input) pieces_.each_of(t, [&](const Triangle3&) { ++count; });
    std::vector<Triangle3> walls;
    walls.reserve(count);
    for (const Triangle3& t : *input)
      pieces_.each_of(t, [&](const Triangle3& piece) { walls.push_back(piece); });
    return walls;
  }

  /// Facets are read in boxes that grow until none farther away can be nearer.
  Status judge_walls() {
    auto walls = read_walls();
    if (!walls) return walls.error();
    const ClosestPointIndex from = index_of(std::move(*walls), control_);
    const double limit = plan_.cover.limit.value_or(0) * delta_;
    for (double reach = std::max(first_reach * delta_, limit + delta_);; reach *= 2) {
      const Box3 around = pieces_.box().grown(pieces_.margin() + reach);
      auto near = folder_.z_before(plan_.round, around);
      if (!near) return near.error();
      const bool all = near->size() == plan_.facets;
      if (!all) keep_meeting(*near, around);
      const ClosestPointIndex z = index_of(std::move(*near), control_);
      proof_.input_distance = bound_distance(from, z, input_precision * delta_, control_);
      if (stop_()) return stopped();
      if (!all && !(proof_.input_distance.upper <= reach)) continue;
      if (!plan_.cover.limit) return {};
      proof_.coverage = judge_coverage(from, z, proof_.input_distance, limit, delta_, control_);
      if (stop_()) return stopped();
      return {};
    }
  }

  const TileFolder& folder_;
  const ProofPlan& plan_;
  PiecesInTile pieces_;
  const RunControl& control_;
  double delta_;
  std::function<bool()> stop_;
  std::vector<Triangle3> facets_; ///< of Z whose boxes meet the tile's
  TileProof proof_;
};

} // namespace

Result<ProofPlan> plan_proof(const TileFolder& folder, const CoverTest& cover) {
  const auto rounds = folder.complete_rounds();
  if (!rounds) return rounds.error();
  ProofPlan plan;
  plan.round = *rounds + 1;
  plan.cover = cover;
  const TileGrid grid = folder.grid();
  const auto loads = folder.loads_before(plan.round);
  if (!loads) return loads.error();
  plan.tiling = {0, 0, grid.is_whole(0)};
  while (!plan.tiling.whole &&
         heaviest_tile(grid, plan.tiling.level + 1, *loads) <= folder.manifest().memory) {
    ++plan.tiling.level;
    plan.tiling.whole = grid.is_whole(plan.tiling.level);
  }
  plan.piece = longest_piece * std::ldexp(bricks_of_tile * grid.brick(), plan.tiling.level);
  plan.tiles = tiles_met(grid, plan.tiling, *loads);
  const Status read = folder.each_facet_before(plan.round, [&](const Triangle3& f) {
    plan.facet_area += length(area_vector(f));
    ++plan.facets;
  });
  if (!read) return read.error();
  return plan;
}

Result<TileProof> prove_tile(const TileFolder& folder, const ProofPlan& plan, const GridPlace& tile,
                             const RunControl& control) {
  return TileProver(folder, plan, tile, control).prove();
}

} // namespace isoscope
