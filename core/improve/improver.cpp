// The schedule: greedy rounds and relaxation until nothing collapses, then rounds with repair.
#include "improve/improver.h"

#include "criteria/orientation.h"
#include "improve/further_rounds.h"
#include "improve/relaxation.h"
#include "improve/shake_round.h"
#include "improve/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace isoscope {
namespace {

/// How wide the triangles are.
double mean_width(const ClosestPointIndex& input) {
  return std::sqrt(2 * input.area() / static_cast<double>(std::max<std::size_t>(input.size(), 1)));
}

/// The cells in which triangles near to Z are listed: a little wider than δ, or half as wide as the
/// triangles, so that there are few where a few triangles are all there is. Wider cells list more triangles;
/// of smaller ones many are made for a few questions each.
double cell_side(const ClosestPointIndex& input, double delta) {
  return std::max(1.5 * delta, 0.5 * mean_width(input));
}
/// In δ: so many narrower triangles are near to any cell that a walk down the hierarchy is faster.
constexpr double least_width_for_cells = 0.35;

constexpr int sweeps_after_round = 2;
constexpr int most_rounds = 20;
/// A round that takes fewer than one vertex in this many is the last of its level.
constexpr std::size_t worthwhile = 100;
/// In δ: up to here edges are collapsed to cheaply placed targets.
constexpr double thinning_limit = 0.5;
/// In δ, on the cost of collapses with repair that fold a facet.
constexpr double folded_surcharge = 0.5;

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

/// One level of collapse with repair.
struct RepairLevel {
  int rings, sweeps;
  double excess; ///< cost limit in δ
  std::array<double, 3> funnel = RepairOptions::impatient;
  std::size_t most_attempts = unlimited;
};
/// Bounds of the default effort: large surfaces spend them on their cheapest edges. The first lets a surface
/// of some 1,300 vertices try all its edges, the second one of 350.
constexpr std::size_t most_repairs = 4000, most_patient_repairs = 1000;

/// Tries in a row that may fail in a round of the default effort, which asks the cheapest edges first. On cow
/// and elephant at 1 % a vertex came after at most 75 in vain; from there to the end of a round there was
/// none, for up to 240 tries. On a large surface those that succeed lie farther apart.
std::size_t most_in_vain(std::size_t vertices) {
  return std::max<std::size_t>(80, vertices / 2);
}

/// Flips against the energy, then collapses with repair of what has become cheap.
struct ShakeLevel {
  std::uint32_t most_passes;              ///< in all
  std::uint32_t patience;                 ///< passes in a row without a collapse
  std::size_t most_flips, most_collapses; ///< tries
};
/// Of the default effort. Larger surfaces have spent the time that they may take on the levels before: up to
/// 158 vertices 2,500 flips are tried, of 200 1,250, from 292 on 400. In eight runs on five models a vertex
/// came after at most four passes in vain.
ShakeLevel bounded_shakes(std::size_t vertices) {
  const double n = static_cast<double>(std::max<std::size_t>(vertices, 1));
  const auto flips = static_cast<std::size_t>(std::clamp(1e10 / (n * n * n), 400.0, 2500.0));
  return {30, 5, flips, flips / 5};
}

/// Up to so many vertices the passes come before the other collapses with repair: in eight models of 52 to
/// 160 vertices that left 897 instead of 906, in 56 instead of 66 CPU seconds. Of larger surfaces the bounds
/// reach a part: two of four were left with 3 % more; so were rooms, whose sheets have few vertices each.
constexpr std::size_t most_shaken_first = 200;

/// After a flip. More of both makes a few more flips come below δ, at half as much time again.
constexpr RepairOptions shake_repair{.sweeps = 4, .certificates = 2};
/// The collapses between two passes.
constexpr RepairLevel between_shakes{2, 14, 1.05};

class Improver {
 public:
  Improver(const TriangleMesh& mesh, const ImproverGround& ground, const NearestSample* samples,
           const ImproverOptions& options, const RunControl& control, ImproverObserver& observer,
           const RoomInT* room)
      : options_(options), control_(control), observer_(observer), room_(room), cells_(make_cells(ground)),
        input_(cells_ ? *cells_ : ground.field, ground.delta, mesh, control, ground.gate,
               ground.box ? InputSurface::Normals::as_given : InputSurface::Normals::like_surface),
        rules_(make_rules(mesh, ground, samples)),
        surface_(mesh, rules_, room != nullptr ? &room->embedding : nullptr, control) {}

  ImproverOutcome run() {
    if (!options_.rounds_alone) run_phases();
    if (options_.effort >= endless_effort) go_on();
    if (stopped_ || control_.cancelled()) outcome_.end = ImproverOutcome::End::stopped;
    return outcome_;
  }
  TriangleMesh result() const { return compacted(whole_ ? *whole_ : surface_.complex()); }

 private:
  void run_phases() {
    shrink_greedily();
    if (options_.effort < 2) return;
    const bool shakes_first = surface_.vertex_count() <= most_shaken_first &&
                              surface_.complex().strata.empty() && surface_.complex().border.empty();
    if (shakes_first) shake_and_repair(bounded_shakes(surface_.vertex_count()));
    repair({2, 14, 1.5, RepairOptions::impatient, most_repairs});
    if (!shakes_first) shake_and_repair(bounded_shakes(surface_.vertex_count()));
    repair({2, 20, 2.5, RepairOptions::patient, most_patient_repairs});
  }

  /// Flips are taken whatever the energy becomes: where only those stayed that lower it, elephant at 2 % was
  /// left with 80 vertices in the time in which it comes to 73.
  void go_on() {
    FurtherRounds rounds(options_.first_round);
    FailedEdges failed, failed_wide;
    CollapseRoundOptions narrow = round_options(between_shakes);
    CollapseRoundOptions wide =
        round_options({FurtherRounds::wide_rings, FurtherRounds::wide_sweeps, FurtherRounds::wide_excess});
    wide.repair.jointly = true;
    wide.most_attempts = FurtherRounds::most_wide_tries;
    for (std::size_t r = 0; r < options_.most_rounds; ++r) {
      if (stopped_ || control_.cancelled()) return;
      ++outcome_.rounds;
      const std::uint32_t before = surface_.commits();
      if (rounds.is_wide()) rounds.wide_saved(round(wide, failed_wide));
      if (stopped_ || control_.cancelled()) return;
      const ShakeFigures flips = shake_once(rounds.flips(surface_.vertex_count()));
      if (stopped_ || control_.cancelled()) return;
      round(narrow, failed);
      relax_all();
      if (!rounds.end(flips, surface_.commits() > before)) return;
    }
  }

  /// Tens of millions of queries go to the few places where Z may lie.
  static std::optional<NearestCells> make_cells(const ImproverGround& ground) {
    const ClosestPointIndex* surface = ground.field.surface();
    if (surface == nullptr || mean_width(*surface) < least_width_for_cells * ground.delta)
      return std::nullopt;
    return std::optional<NearestCells>(std::in_place, *surface, cell_side(*surface, ground.delta),
                                       ground.most_cell_bytes);
  }
  SurfaceRules make_rules(const TriangleMesh& mesh, const ImproverGround& ground,
                          const NearestSample* samples) {
    SurfaceRules rules;
    rules.input = &input_;
    const double delta = ground.delta;
    if (!mesh.labels.empty() && samples != nullptr) input_.set_rooms(room_samples(mesh, *samples, delta));
    if (options_.preserve_normals && samples != nullptr)
      rules.orientation =
          OrientationTester{samples, options_.shrink, orientation_reach * delta, &input_.field(), delta};
    rules.witnesses = ground.witnesses;
    rules.box = ground.box;
    return rules;
  }

  std::size_t round(const CollapseRoundOptions& options, FailedEdges& failed) {
    control_.report("improver", -1);
    const CollapseRoundFigures figures =
        collapse_round(surface_, rules_, options, failed, control_, observer_);
    outcome_.attempts += figures.attempts;
    outcome_.collapses += figures.collapses;
    if (options.repair.sweeps > 0) outcome_.repairs += figures.collapses;
    stopped_ = stopped_ || figures.stopped;
    return figures.collapses;
  }

  CollapseRoundOptions round_options(const RepairLevel& level) const {
    CollapseRoundOptions options;
    options.cost_limit = level.excess * input_.delta();
    options.rings = level.rings;
    options.repair.sweeps = level.sweeps;
    options.repair.funnel = level.funnel;
    // Flips may unfold what a collapse folds.
    options.placement = {true, 2, folded_surcharge};
    return options;
  }

  /// Runs a pass of many small commits over Z, which says what it did, and reports it as one operation; false
  /// where nothing changed. One that is cancelled is taken back, as nobody could make the same part of it
  /// again; in T it stays.
  bool report_pass(EventKind kind, const std::function<RelaxationFigures()>& pass) {
    FacetComplex before = surface_.complex();
    const Complex before_in_t = room_ != nullptr ? room_->embedding.complex() : Complex{};
    const RelaxationFigures figures = pass();
    if (room_ == nullptr && control_.cancelled()) {
      if (!whole_) whole_ = std::move(before);
      return false;
    }
    if (figures.moved + figures.flipped == 0) return false;
    SurfaceChange change = difference(before, surface_.complex(), kind);
    ImproverVerdict verdict;
    verdict.kind = kind;
    verdict.moved = static_cast<std::uint32_t>(change.moves.size());
    verdict.flipped = figures.flipped;
    verdict.value = figures.largest;
    verdict.limit = input_.delta();
    if (room_ != nullptr) change.tetrahedra = difference(before_in_t, room_->embedding.complex());
    stopped_ = !observer_.accepted(change, verdict);
    return true;
  }

  void relax_all() {
    for (int s = 0; s < sweeps_after_round && !stopped_ && !control_.cancelled(); ++s) {
      const bool changed = report_pass(EventKind::relaxation, [&] {
        const RelaxationFigures figures = relax(surface_, rules_, best_places_, control_);
        outcome_.moved += figures.moved;
        outcome_.flipped += figures.flipped;
        return figures;
      });
      if (!changed) break;
    }
    make_room();
  }

  /// A pass of flips, reported as one operation.
  ShakeFigures shake_once(const ShakeOptions& options) {
    ShakeFigures figures;
    const bool changed = report_pass(EventKind::shake, [&] {
      figures = shake(surface_, rules_, options, control_);
      return RelaxationFigures{0, figures.flipped, figures.largest};
    });
    if (changed) ++outcome_.shakes, outcome_.shaken_edges += figures.flipped;
    return figures;
  }

  /// Passes go on from one another: which edges collapse is chance, and more of it finds more.
  void shake_and_repair(const ShakeLevel& level) {
    CollapseRoundOptions options = round_options(between_shakes);
    FailedEdges failed;
    std::size_t flips_left = level.most_flips, collapses_left = level.most_collapses;
    std::uint32_t in_vain = 0;
    for (std::uint32_t pass = 0; pass < level.most_passes && in_vain < level.patience; ++pass) {
      if (flips_left == 0 || collapses_left == 0 || stopped_ || control_.cancelled()) return;
      const ShakeFigures flips = shake_once({pass, flips_left, shake_repair});
      flips_left -= std::min(flips_left, flips.attempts);
      if (flips.flipped == 0) return;
      options.most_attempts = collapses_left;
      const std::size_t before = outcome_.attempts, collapsed = round(options, failed);
      collapses_left -= std::min(collapses_left, outcome_.attempts - before);
      relax_all();
      in_vain = collapsed > 0 ? 0 : in_vain + 1;
    }
  }

  void make_room() {
    if (room_ == nullptr || stopped_ || control_.cancelled()) return;
    const std::uint32_t before = room_->embedding.clock();
    stopped_ = !room_->make();
    if (room_->embedding.clock() > before) surface_.room_changed(room_->embedding.changed_since(before));
  }

  bool is_worthwhile(std::size_t collapsed) const { return collapsed * worthwhile > surface_.vertex_count(); }

  void shrink_greedily() {
    CollapseRoundOptions options;
    FailedEdges failed;
    // Far below the limit the exact target does not matter yet.
    options.cost_limit = thinning_limit * input_.delta();
    options.placement = {false, 1};
    round(options, failed);
    options.cost_limit = rules_.sampled_limit();
    options.placement = {};
    failed.clear();
    for (int r = 0; r < most_rounds && !stopped_ && !control_.cancelled(); ++r) {
      const std::size_t collapsed = round(options, failed);
      if (options_.effort == 0) return;
      relax_all();
      if (r > 0 && !is_worthwhile(collapsed)) return;
    }
  }

  void repair(const RepairLevel& level) {
    CollapseRoundOptions options = round_options(level);
    FailedEdges failed;
    const std::size_t before = outcome_.attempts;
    for (int r = 0; r < most_rounds && !stopped_ && !control_.cancelled(); ++r) {
      options.most_attempts = level.most_attempts - std::min(level.most_attempts, outcome_.attempts - before);
      options.most_in_vain = most_in_vain(surface_.vertex_count());
      const std::size_t collapsed = round(options, failed);
      relax_all();
      if (!is_worthwhile(collapsed)) return;
    }
  }

  const ImproverOptions& options_;
  const RunControl& control_;
  ImproverObserver& observer_;
  const RoomInT* room_;
  std::optional<NearestCells> cells_;
  InputSurface input_;
  SurfaceRules rules_;
  LiveSurface surface_;
  BestPlaces best_places_;
  ImproverOutcome outcome_;
  std::optional<FacetComplex> whole_; ///< Z before a pass that was cancelled
  bool stopped_ = false;
};

/// Tells of a thinned mesh in the ids of what it was made from.
class Renumbering : public ImproverObserver {
 public:
  Renumbering(const ThinnedMesh& thinned, ImproverObserver& observer)
      : thinned_(thinned), observer_(observer) {}
  bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) override {
    SurfaceChange told = change;
    for (auto* facets : {&told.removed, &told.added})
      for (SurfaceChange::Facet& f : *facets) f = {thinned_.facets[f.slot], ids(f.v)};
    for (SurfaceChange::Move& m : told.moves) m.vertex = thinned_.vertices[m.vertex];
    for (std::uint32_t& v : told.killed_vertices) v = thinned_.vertices[v];
    return observer_.accepted(told, renumbered(verdict));
  }
  bool rejected(const ImproverVerdict& verdict) override { return observer_.rejected(renumbered(verdict)); }

 private:
  std::array<std::uint32_t, 3> ids(const std::array<std::uint32_t, 3>& v) const {
    return {thinned_.vertices[v[0]], thinned_.vertices[v[1]], thinned_.vertices[v[2]]};
  }
  ImproverVerdict renumbered(ImproverVerdict verdict) const {
    verdict.a = thinned_.vertices[verdict.a];
    verdict.b = thinned_.vertices[verdict.b];
    if (verdict.facet) verdict.facet = ids(*verdict.facet);
    return verdict;
  }

  const ThinnedMesh& thinned_;
  ImproverObserver& observer_;
};

} // namespace

ImproverOptions improver_options(const CriteriaParameters& criteria, int effort) {
  ImproverOptions options;
  options.effort = effort;
  options.preserve_normals = criteria.condition_3;
  options.shrink = criteria.shrink;
  return options;
}

ImproverGround ground_of(const ToleranceVolume& volume) {
  ImproverGround ground{volume.field(), volume.thresholds().delta, {}, volume.border_gate()};
  for (const Witness& w : volume.witnesses()) ground.witnesses.push_back(w.point);
  return ground;
}

ImproverOutcome improve(TriangleMesh& mesh, const ToleranceVolume& volume, const NearestSample* samples,
                        const ImproverOptions& options, const RunControl& control, ImproverObserver& observer,
                        const RoomInT* room) {
  return improve(mesh, ground_of(volume), samples, options, control, observer, room);
}

ImproverOutcome improve(TriangleMesh& mesh, const ImproverGround& ground, const NearestSample* samples,
                        const ImproverOptions& options, const RunControl& control, ImproverObserver& observer,
                        const RoomInT* room) {
  if (options.thin) {
    ThinnedMesh thinned =
        thin(mesh, {ground.field, ground.delta, ground.witnesses, ground.box}, control, observer);
    mesh = TriangleMesh();
    ImproverOptions rest = options;
    rest.thin = false;
    ImproverOutcome outcome{ImproverOutcome::End::stopped};
    Renumbering renumbering(thinned, observer);
    if (!thinned.stopped) outcome = improve(thinned.mesh, ground, samples, rest, control, renumbering, room);
    mesh = std::move(thinned.mesh);
    return outcome;
  }
  Improver improver(mesh, ground, samples, options, control, observer, room);
  const ImproverOutcome outcome = improver.run();
  mesh = improver.result();
  return outcome;
}

} // namespace isoscope
