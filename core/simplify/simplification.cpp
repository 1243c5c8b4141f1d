// The order of the stages, and how the improver's changes of Z become operations.
#include "simplify/simplification.h"

#include "collapse/collapse_stage.h"
#include "collapse/live_complex.h"
#include "criteria/nearest_sample.h"
#include "improve/embedded_improvement.h"
#include "improve/free_improvement.h"
#include "journal/stage_log.h"
#include "mesh/strata.h"
#include "simplify/first_surface.h"
#include "simplify/free_filling.h"
#include "simplify/rim_cut.h"
#include "simplify/tessellation.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace isoscope {

namespace {

constexpr int most_rounds = 10;
/// Rounds of the all-edges stage: mixed edges, then edges of Z again. Where the improver follows, further
/// ones bring nothing that it does not find too.
constexpr int most_exchanges = 8, exchanges_before_improver = 1;

/// Those behind the refinement.
constexpr std::span<const Stage> stage_order = std::span(stages_in_order).subspan(2);
static_assert(stage_order.front() == Stage::gamma);

} // namespace

struct Simplification::Impl {
  Impl(const ToleranceVolume& v, SearchedSamples s, const CriteriaParameters& c,
       const SimplificationParameters& p, Recorder& recorder, const RunControl& run_control, Complex complex,
       FirstSurfaceMaker maker)
      : samples(std::move(s.samples)), nearest(std::move(s.nearest)), context{v, nearest.get(), c},
        parameters(p), first(std::move(maker)), log(recorder, run_control) {
    if (in_t()) live = std::make_unique<LiveComplex>(std::move(complex), c.certified ? nullptr : samples);
    log.on_parameters([this](const CriteriaParameters& wanted) { adopt(wanted); });
  }

  std::shared_ptr<const BoundarySamples> samples;
  std::shared_ptr<const NearestSample> nearest;
  EvaluationContext context;
  SimplificationParameters parameters;
  FirstSurfaceMaker first; ///< where Z begins outside of T
  StageLog log;
  std::optional<RimCut> rim_cut;     ///< once it has begun
  std::unique_ptr<LiveComplex> live; ///< null once Z has left T, or where it begins outside of it
  Complex free;                      ///< the state after that
  bool filled = false;               ///< holes are, as far as they can be
  bool has_fillings = false;         ///< some are
  /// Inside T the improver knows two sides only.
  Stage last = context.volume.has_rooms() && parameters.improver == ImproverPlace::embedded ? Stage::all
                                                                                            : Stage::improve;
  std::size_t next = 0;           ///< into stage_order
  bool rejoined = false;          ///< the journal has begun the next stage
  bool further = false;           ///< the improver goes on without end, as was asked for after it had ended
  bool improving = false;         ///< the improver's stage has begun
  bool improved = false;          ///< it has done all but further rounds
  std::size_t further_rounds = 0; ///< begun by the improver

  bool in_t() const { return !first; }

  bool wanted(Stage stage) const {
    if (!in_t() && stage != Stage::improve) return false;
    if (comes_after(stage, parameters.until) || comes_after(stage, last) ||
        parameters.skipped[static_cast<std::size_t>(stage)])
      return false;
    if (context.volume.open_sides() == nullptr) return stage != Stage::rim;
    // What Z has beyond the rim stays as it is in T, and fills holes there.
    return stage != Stage::improve || parameters.fill.rule == HoleChoice::Rule::none ||
           parameters.improver == ImproverPlace::free;
  }

  /// σ, δ and what decides containment stay: they belong to what was refined.
  void adopt(const CriteriaParameters& w) {
    CriteriaParameters c = context.criteria;
    c.alpha = w.alpha;
    c.shrink = w.shrink;
    c.condition_3 = w.condition_3;
    if (!(w.delta > 0) || c == context.criteria) return;
    context.criteria = c;
    log.journal().add_parameters(c);
    Event e;
    e.kind = EventKind::parameter_change;
    log.event(e);
  }

  std::size_t collapse(EdgeKind kind, bool halfedge, int rounds) {
    CollapseSettings settings;
    settings.kind = kind;
    settings.halfedge = halfedge;
    settings.search.strategy = parameters.target;
    return CollapseStage(*live, context, settings, parameters.ring, samples.get(), log).run(rounds);
  }

  void all_edges() {
    const int exchanges = wanted(Stage::improve) ? exchanges_before_improver : most_exchanges;
    for (int i = 0; i < exchanges && !log.stopped(); ++i) {
      const std::size_t mixed = collapse(EdgeKind::mixed, false, 1);
      const std::size_t zero = collapse(EdgeKind::zero, false, most_rounds);
      if (mixed + zero == 0) break;
    }
  }

  Status tessellate() {
    Result<Delta> delta = mutual_tessellation(live->complex());
    if (!delta) {
      log.warn(delta.error().line());
      return delta.error();
    }
    live->apply(*delta);
    Event e;
    e.kind = EventKind::tessellation;
    e.count = static_cast<std::uint32_t>(delta->added_vertices.size());
    log.operation(e, std::move(*delta), live->step_figures());
    return {};
  }

  Status cut_along_rim() {
    if (!rim_cut) rim_cut.emplace(*live, context.volume, log);
    Status cut = rim_cut->run();
    if (!cut) log.warn(cut.error().line());
    return cut;
  }

  void leave() {
    Delta delta = departure(live->complex());
    live->apply(delta);
    Event e;
    e.kind = EventKind::departure;
    log.operation(e, std::move(delta), live->step_figures());
    free = live->complex();
    live.reset();
  }

  /// Z begins outside of T, by the first operation.
  Status start() {
    auto made = first(log.control());
    if (!made) return log.stopped() ? Status() : made.error();
    for (const FirstSurface::Look& look : made->looks) {
      Event e;
      e.kind = EventKind::topology_check;
      e.condition = Condition::topology;
      e.value = static_cast<double>(look.euler_characteristic);
      e.limit = std::numeric_limits<double>::infinity();
      e.count = static_cast<std::uint32_t>(look.components);
      log.event(e);
    }
    if (!made->warning.empty()) log.warn(made->warning);
    Delta delta = free_start(made->mesh);
    free.apply(delta);
    Event e;
    e.kind = EventKind::start;
    e.count = static_cast<std::uint32_t>(delta.added_vertices.size());
    e.text = log.journal().add_text(made->words);
    StepFigures figures;
    figures.zero_set_vertices = e.count;
    figures.smallest_height = std::numeric_limits<float>::infinity();
    log.operation(e, std::move(delta), figures);
    return {};
  }

  Status improve() {
    if (!in_t() && free.form != ZeroForm::free)
      if (Status started = start(); !started || log.stopped()) return started;
    if (live && parameters.improver == ImproverPlace::embedded) {
      // A vertex of Γ that goes to a vertex of Z leaves Z as it is and takes tetrahedra out of its way.
      const auto make_room = [this] { collapse(EdgeKind::mixed, true, most_rounds); };
      further_rounds += improve_embedded_zero_set(*live, context, improver_work(), make_room, log).rounds;
      return {};
    }
    if (live) leave();
    if (!log.stopped()) further_rounds += improve_free_zero_set(free, context, improver_work(), log).rounds;
    return {};
  }

  /// What the improver is to do this time: what it has done it does not begin again.
  ImproverOptions improver_work() {
    ImproverOptions options =
        improver_options(context.criteria, further ? endless_effort : parameters.effort);
    options.rounds_alone = further && improved;
    options.first_round = further_rounds;
    return options;
  }

  void refuse_to_fill(std::uint32_t loop, const std::string& why) {
    log.warn("The hole of loop " + std::to_string(loop + 1) + " is not filled: " + why + ".");
  }

  /// The operation by which `count` facets fill the holes of these loops.
  Event filling(std::size_t count, const std::vector<std::uint32_t>& loops) {
    has_fillings = true;
    Event e;
    e.kind = EventKind::fill;
    e.count = static_cast<std::uint32_t>(count);
    e.text = log.journal().add_text(loops_in_words(loops));
    return e;
  }

  /// Closes the holes that are to be filled, once; says of those that cannot be why.
  void fill_holes() {
    if (std::exchange(filled, true) || context.volume.open_sides() == nullptr ||
        parameters.fill.rule == HoleChoice::Rule::none)
      return;
    if (live)
      fill_in_complex();
    else
      fill_free();
  }

  void fill_free() {
    FreeFilling made =
        fill_free_holes(free, context.volume, parameters.fill, [this] { return log.stopped(); });
    if (log.stopped()) return;
    for (const FreeFilling::Refusal& refusal : made.refused) refuse_to_fill(refusal.loop, refusal.why);
    if (made.delta.added_facets.empty()) return;
    free.apply(made.delta);
    // No vertex comes or goes.
    const StepFigures figures = log.journal().operations().back().figures;
    log.operation(filling(made.delta.added_facets.size(), made.loops), std::move(made.delta), figures);
  }

  void fill_in_complex() {
    const auto loops = context.volume.open_sides()->rim().loops();
    std::vector<DroppedFacet> facets;
    std::vector<std::uint32_t> filled_loops;
    for (const Cap& cap : find_caps(live->complex(), context.volume)) {
      const bool wanted = std::any_of(cap.loops.begin(), cap.loops.end(), [&](std::uint32_t loop) {
        return parameters.fill.wants(loop, loops[loop]);
      });
      if (!wanted) continue;
      if (!cap.fills()) {
        refuse_to_fill(cap.loops.front(), "what Z has beyond it is no disc along that loop alone");
        continue;
      }
      facets.insert(facets.end(), cap.facets.begin(), cap.facets.end());
      filled_loops.push_back(cap.loops.front());
    }
    if (facets.empty()) return;
    Delta delta = fill_delta(live->complex(), facets);
    live->apply(delta);
    log.operation(filling(facets.size(), filled_loops), std::move(delta), live->step_figures());
  }

  /// A person's operation: as safe as those of the stages.
  Status collapse_by_hand(VertexId a, VertexId b, Vec3 target) {
    const auto is_alive = [&](VertexId v) {
      return v.valid() && v.index() < live->complex().vertices.size() && live->alive(v);
    };
    if (a == b || !is_alive(a) || !is_alive(b) || !live->adjacent(a, b))
      return Error{ErrorCode::usage, "T has no such edge at this step.", ""};
    const auto [stays, goes] = oriented_edge(live->complex(), live->incidence(), a, b);
    const EdgeStar star = live->star(stays, goes, parameters.ring);
    CollapseSettings settings;
    settings.kind = star.kind();
    const CollapseAttempt attempt = evaluate_target(star, target, settings, context);
    if (!attempt.possible())
      return Error{ErrorCode::usage,
                   "The edge cannot be collapsed there: " + std::string(name(attempt.rejected)) + ".",
                   "Move the target until every check passes."};
    Event e;
    e.kind = EventKind::collapse;
    e.reason = Reason::user;
    e.vertex = attempt.a;
    e.other = attempt.b;
    e.count = 1;
    e.point = target;
    e.witness = attempt.optimum;
    e.value = attempt.cost;
    e.limit = attempt.unconstrained_cost;
    Delta delta = live->collapse(attempt.a, attempt.b, target);
    live->apply(delta);
    log.operation(e, std::move(delta), live->step_figures());
    return {};
  }

  Status run_stage(Stage stage) {
    if (!std::exchange(rejoined, false)) log.begin(stage, further);
    Status made;
    switch (stage) {
    case Stage::gamma:
      collapse(EdgeKind::gamma, true, most_rounds);
      if (!context.criteria.certified) collapse(EdgeKind::gamma, false, most_rounds);
      break;
    case Stage::tessellation:
      made = tessellate();
      break;
    case Stage::rim:
      made = cut_along_rim();
      break;
    case Stage::zero_set:
      collapse(EdgeKind::zero, true, most_rounds);
      collapse(EdgeKind::zero, false, most_rounds);
      break;
    case Stage::all:
      all_edges();
      break;
    case Stage::improve:
      improving = true;
      made = improve();
      improved = improved || further_rounds > 0 || !log.stopped();
      break;
    default:
      break;
    }
    log.end();
    return made;
  }
};

Simplification::Simplification(const ToleranceVolume& volume, SearchedSamples samples,
                               const CriteriaParameters& criteria, const SimplificationParameters& parameters,
                               Recorder& recorder, const RunControl& control, Complex complex,
                               FirstSurfaceMaker first)
    : impl_(std::make_unique<Impl>(volume, std::move(samples), criteria, parameters, recorder, control,
                                   std::move(complex), std::move(first))) {}

Simplification::~Simplification() = default;

Status Simplification::begin_with(Stage stage, bool open, double seconds, VertexId a, VertexId b,
                                  Vec3 target) {
  Impl& m = *impl_;
  m.log.rejoin(stage, seconds);
  if (Status made = m.collapse_by_hand(a, b, target); !made) return made;
  const auto at = std::find(stage_order.begin(), stage_order.end(), stage);
  m.next = at != stage_order.end() ? static_cast<std::size_t>(at - stage_order.begin()) : 0;
  // What tessellated Z into T is not done twice.
  const bool again = stage != Stage::tessellation || m.live->complex().form == ZeroForm::interpolated;
  m.rejoined = open && again && at != stage_order.end();
  if (!again) ++m.next;
  return {};
}

void Simplification::begin_at(Stage stage) {
  const auto at = std::find(stage_order.begin(), stage_order.end(), stage);
  if (at != stage_order.end()) impl_->next = static_cast<std::size_t>(at - stage_order.begin());
}

bool Simplification::can_go_on() const {
  return impl_->improving && !impl_->has_fillings;
}

void Simplification::go_on(bool further) {
  impl_->further = further;
}

bool Simplification::without_end() const {
  return impl_->improving && (impl_->further || impl_->parameters.effort >= endless_effort);
}

void Simplification::finish() {
  impl_->log.resume();
  impl_->fill_holes();
}

Result<bool> Simplification::run() {
  Impl& m = *impl_;
  m.log.resume();
  for (; m.next < stage_order.size() && !m.log.stopped(); ++m.next) {
    const Stage stage = stage_order[m.next];
    if (!m.wanted(stage)) continue;
    if (Status done = m.run_stage(stage); !done) return done.error();
    if (m.log.stopped()) break;
  }
  if (m.log.stopped()) return false;
  m.fill_holes();
  if (comes_after(m.parameters.until, m.last))
    m.log.warn("Z between rooms ends with the stage all: inside T the improver knows two sides only.");
  m.next = std::min(m.next, stage_order.size() - 1);
  return true;
}

const Complex& Simplification::complex() const {
  return impl_->live ? impl_->live->complex() : impl_->free;
}

const CriteriaParameters& Simplification::criteria() const {
  return impl_->context.criteria;
}

} // namespace isoscope
