// What a person asks of an edge beyond the verdict: chosen targets, what was left out, what unlocks it, and
// runs that go on from there.
#include "criteria/collapse_cost.h"
#include "journal/digest.h"
#include "mesh/strata.h"
#include "questions/edge_advice.h"
#include "questions/target_study.h"
#include "questions/unlock_search.h"
#include "run/complete_run.h"
#include "run/session.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;

namespace {

/// A finished run until T is left, and the state at any step of it.
struct Bench {
  std::unique_ptr<test::CompleteRun> run;
  std::unique_ptr<NearestSample> nearest;

  explicit Bench(const std::string& model, TargetStrategy target = TargetStrategy::constraints,
                 Containment containment = Containment::certified) {
    RunParameters parameters = test::gallery_parameters(model);
    parameters.until = Stage::all;
    parameters.target = target;
    parameters.containment = containment;
    if (containment == Containment::sampled) parameters.sigma = 0.5, parameters.conditions[1] = false;
    run = std::make_unique<test::CompleteRun>(parameters);
    REQUIRE(run->run());
    nearest = std::make_unique<NearestSample>(run->scene->samples->positions, run->scene->samples->labels);
  }
  XrayContext context() const { return {*run->scene, *run->journal, run->parameters, nearest.get()}; }
  std::shared_ptr<const StateSnapshot> state(Step step) const {
    Playback playback(run->journal);
    return make_snapshot(playback, step, {}, nullptr);
  }
  const SpillList<Event>& events() const { return run->journal->events(); }
  /// The first event of a kind, and of a reason where that is given, from a stage.
  std::uint32_t find(EventKind kind, Stage stage, Reason reason = Reason::none) const {
    for (std::uint32_t i = 0; i < events().size(); ++i)
      if (events()[i].kind == kind && events()[i].stage == stage &&
          (reason == Reason::none || events()[i].reason == reason))
        return i;
    FAIL("no such event");
    return 0;
  }
  EdgeXray xray(std::uint32_t event, XrayTarget target = XrayTarget::automatic) const {
    const Event& e = events()[event];
    const auto x = edge_xray(*state(e.step), {e.vertex, e.other, event, target}, context());
    REQUIRE(x.has_value());
    return *x;
  }
};

/// Made once: several tests look at it, none changes it.
const Bench& bracket() {
  static const Bench bench("bracket");
  return bench;
}

} // namespace

TEST_CASE("a chosen target is judged as the search judges its own") {
  const Bench& bench = bracket();
  std::size_t collapses = 0, rejections = 0;
  for (std::uint32_t i = 0; i < bench.events().size() && (collapses < 6 || rejections < 10); i += 5) {
    const Event& e = bench.events()[i];
    if (e.stage < Stage::zero_set || (e.kind != EventKind::collapse && e.kind != EventKind::rejection))
      continue;
    const EdgeXray x = bench.xray(i);
    if (e.kind == EventKind::collapse) {
      const TargetStudy study = study_target(x, e.point, bench.context());
      CHECK(study.attempt.possible());
      CHECK(study.attempt.cost == e.value);
      CHECK(!study.failed.has_value());
      CHECK(!study.after.empty());
      for (const auto& facet : study.after) CHECK(facet.inside);
      ++collapses;
    }
    for (const CandidateRecord& c : x.attempt.candidates) {
      const TargetStudy study = study_target(x, c.point, bench.context());
      CHECK((study.attempt.rejected == Reason::none) ==
            (c.rejected == Reason::none && x.attempt.link.holds()));
      if (c.rejected == Reason::none || !x.attempt.link.holds()) continue;
      CHECK(study.attempt.rejected == c.rejected);
      REQUIRE(study.failed.has_value());
      CHECK(study.attempt.check(*study.failed).value == c.value);
      CHECK(study.witness == c.witness);
      ++rejections;
    }
  }
  CHECK(collapses > 5);
  CHECK(rejections > 5);
}

TEST_CASE("outside the kernel the slack is told and the facets are judged all the same") {
  const Bench& bench = bracket();
  const EdgeXray x = bench.xray(bench.find(EventKind::collapse, Stage::zero_set));
  const Kernel& kernel = *x.attempt.kernel;
  // Through a facet of the kernel by a known length.
  const HalfSpace h = kernel.half_spaces[0];
  const double out = 0.25;
  const Vec3 target = kernel.center - (h.slack(kernel.center) + out) * h.normal;
  const TargetStudy study = study_target(x, target, bench.context());
  const CheckVerdict& inside = study.attempt.check(CollapseCheck::candidates);
  CHECK(inside.state == CheckVerdict::State::failed);
  CHECK(inside.value <= -out + 1e-12);
  CHECK(study.attempt.rejected == Reason::no_candidate);
  CHECK(study.attempt.check(CollapseCheck::containment).state == CheckVerdict::State::failed);
  CHECK(study.attempt.check(CollapseCheck::containment).value > x.criteria.delta);
  CHECK(study.attempt.check(CollapseCheck::witness).state == CheckVerdict::State::skipped);
}

TEST_CASE("targets snap to what they are told to") {
  const Bench& bench = bracket();
  const EdgeXray x = bench.xray(bench.find(EventKind::collapse, Stage::zero_set));
  const Vec3 far{100, 100, 100};
  CHECK(snapped(x, far, TargetSnap::found) == x.attempt.target);
  CHECK(snapped(x, far, TargetSnap::optimum) == x.attempt.optimum);
  CHECK(snapped(x, far, TargetSnap::kept) == x.star.vertices[0].position);
  CHECK(snapped(x, far, TargetSnap::removed) == x.star.vertices[1].position);
  const Kernel& kernel = *x.attempt.kernel;
  for (const TargetSnap snap : {TargetSnap::best, TargetSnap::vertex, TargetSnap::center}) {
    const auto point = snapped(x, far, snap);
    REQUIRE(point.has_value());
    CHECK(kernel.contains(*point));
  }
  // No point of the kernel is cheaper than the best one, and the constraints cost at least nothing.
  const CollapseCost cost(x.star);
  const double best = cost(*snapped(x, far, TargetSnap::best));
  CHECK(best >= x.attempt.unconstrained_cost - 1e-15);
  for (const Vec3& v : x.kernel.vertices)
    CHECK(cost(v + 0.01 * (kernel.center - v)) >= best * (1 - 1e-6) - 1e-15);
}

TEST_CASE("every check tells its number, and the time that it took") {
  const Bench& bench = bracket();
  const EdgeXray x = bench.xray(bench.find(EventKind::collapse, Stage::zero_set));
  const auto& a = x.attempt;
  CHECK(a.check(CollapseCheck::containment).value > 0);
  CHECK(a.check(CollapseCheck::containment).value <= x.criteria.delta);
  CHECK(a.check(CollapseCheck::containment).limit == x.criteria.delta);
  CHECK(a.check(CollapseCheck::kernel).value == a.kernel->inscribed_radius);
  CHECK(a.check(CollapseCheck::kernel).seconds > 0);
  CHECK(a.check(CollapseCheck::link).seconds > 0);
  CHECK(a.check(CollapseCheck::candidates).seconds > 0);
  // Where the link fails, what follows is judged too.
  const EdgeXray link = bench.xray(bench.find(EventKind::rejection, Stage::zero_set, Reason::link_condition));
  CHECK(link.attempt.check(CollapseCheck::link).state == CheckVerdict::State::failed);
  CHECK(link.attempt.check(CollapseCheck::kernel).state != CheckVerdict::State::skipped);
  CHECK(link.attempt.link.offending_t.size() > 0);
}

TEST_CASE("what the search leaves out would have failed") {
  for (const Containment containment : {Containment::certified, Containment::sampled}) {
    const Bench bench("sphere", TargetStrategy::constraints, containment);
    std::size_t cells = 0, regions = 0, costlier = 0;
    std::size_t seen = 0;
    for (std::uint32_t i = 0; i < bench.events().size() && seen < 8; i += 5) {
      const Event& e = bench.events()[i];
      if (e.kind != EventKind::rejection || e.stage < Stage::zero_set) continue;
      const EdgeXray x = bench.xray(i, XrayTarget::octree);
      if (!x.attempt.kernel || x.attempt.kernel->empty) continue;
      ++seen;
      CHECK(x.settings.search.strategy == TargetStrategy::octree);
      CHECK(x.pruning.wrong.empty());
      CHECK(x.pruning.costlier_wrong == 0);
      cells += x.pruning.cells_judged;
      regions += x.pruning.regions_judged;
      costlier += x.pruning.costlier_judged;
      std::uint32_t pruned = 0;
      for (const OctreeCell& c : x.attempt.cells) pruned += c.fate == OctreeCell::Fate::invalid;
      CHECK(x.pruning.cells == pruned);
    }
    CHECK(seen > 5);
    CHECK(cells + regions > 10);
  }
}

TEST_CASE("a collapse that another one unlocks is possible after it") {
  const Bench& bench = bracket();
  std::size_t trials = 0, unlocking = 0, asked = 0;
  for (std::uint32_t i = 0; i < bench.events().size() && asked < 6; i += 9) {
    const Event& e = bench.events()[i];
    if (e.kind != EventKind::rejection || e.stage != Stage::zero_set) continue;
    ++asked;
    const auto state = bench.state(e.step);
    double last = -1;
    const auto found = search_unlocks(*state, {e.vertex, e.other, i}, bench.context(), [&](double fraction) {
      CHECK(fraction > last);
      last = fraction;
      return true;
    });
    REQUIRE(found.has_value());
    CHECK(found->complete);
    trials += found->trials.size();
    unlocking += found->count();
    for (const UnlockTrial& t : found->trials) {
      CHECK(t.kind == EdgeKind::mixed);
      CHECK(state->complex.value(t.a) == 0);
      if (!t.unlocks()) continue;
      // On a copy, from scratch: it can be collapsed, and then so can the other.
      Complex copy = state->complex;
      copy.apply(collapse_delta(copy, Incidence(copy), t.a, t.b, t.target));
      const Incidence incidence(copy);
      const auto [a, b] = oriented_edge(copy, incidence, e.vertex, e.other);
      const EdgeStar star = gather_edge_star(copy, incidence, a, b, bench.run->parameters.cost_ring);
      CollapseSettings settings;
      const EvaluationContext context{*bench.run->scene->volume, bench.nearest.get(),
                                      bench.run->journal->parameters_at(e.step)};
      settings.kind = star.kind();
      CHECK(evaluate_target(star, t.target_then, settings, context).possible());
    }
  }
  MESSAGE(asked << " edges, " << trials << " neighbours tried, " << unlocking << " unlock");
  CHECK(trials > 20);
  CHECK(!search_unlocks(*bench.state(0), {VertexId(0), VertexId(1), {}, {}}, bench.context(), nullptr));
  // Told to stop, it stops.
  const Event& e = bench.events()[bench.find(EventKind::rejection, Stage::zero_set)];
  const auto stopped = search_unlocks(*bench.state(e.step), {e.vertex, e.other, {}, {}}, bench.context(),
                                      [](double) { return false; });
  REQUIRE(stopped.has_value());
  CHECK(!stopped->complete);
}

TEST_CASE("a branch begins with the past of the other run and a collapse made by hand") {
  const Bench& bench = bracket();
  const Journal& trunk = *bench.run->journal;
  const std::uint32_t event = bench.find(EventKind::collapse, Stage::zero_set);
  const EdgeXray x = bench.xray(event);
  const Event& e = bench.events()[event];
  // Another target than that of the run.
  const Vec3 target = e.point + 0.02 * (x.attempt.kernel->center - e.point);
  REQUIRE(study_target(x, target, bench.context()).attempt.possible());
  Session session;
  session.start_branch({bench.run->journal, e.step, e.vertex, e.other, target}, bench.run->parameters,
                       *bench.run->scene, 7);
  REQUIRE(session.wait_until_settled(60));
  const SessionSnapshot made = session.snapshot();
  REQUIRE(made.phase == SessionPhase::finished);
  CHECK(made.generation == 8);
  const Journal& branch = *made.journal;
  for (std::uint32_t i = 0; i < trunk.operations()[e.step].event; ++i)
    CHECK(branch.events()[i] == trunk.events()[i]);
  for (Step k = 0; k < e.step; ++k) {
    Digest a, b;
    a.add(branch.operations()[k].delta());
    b.add(trunk.operations()[k].delta());
    CHECK(a.value() == b.value());
  }
  const Event& by_hand = branch.events()[branch.operations()[e.step].event];
  CHECK(by_hand.reason == Reason::user);
  CHECK(by_hand.stage == Stage::zero_set);
  CHECK(by_hand.point == target);
  CHECK(branch.steps() > e.step + 1);
  CHECK(made.result->branch == "branched at step " + std::to_string(e.step) + ": edge " +
                                   std::to_string(e.vertex.value) + " - " + std::to_string(e.other.value) +
                                   " collapsed by hand");
  CHECK(made.result->certificate.holds());
  // Its stages begin once each, in order.
  std::array<int, stage_count> begun{};
  for (std::size_t i = 0; i < branch.events().size(); ++i)
    if (branch.events()[i].kind == EventKind::stage_begin)
      ++begun[static_cast<std::size_t>(branch.events()[i].stage)];
  for (const Stage stage :
       {Stage::refinement, Stage::gamma, Stage::tessellation, Stage::zero_set, Stage::all})
    CHECK(begun[static_cast<std::size_t>(stage)] == 1);
  // Replaying it gives a valid state everywhere; the other run is untouched.
  Playback playback(made.journal);
  CHECK(playback.seek(branch.steps()) == branch.steps());
  playback.seek(e.step);
  CHECK(playback.complex() == bench.state(e.step)->complex);
}

TEST_CASE("no branch where edges are not collapsed, or not to there") {
  const Bench bench("sphere");
  const Journal& trunk = *bench.run->journal;
  CHECK(!can_branch(trunk, 3).ok());
  const std::uint32_t event = bench.find(EventKind::collapse, Stage::zero_set);
  const Event& e = bench.events()[event];
  CHECK(can_branch(trunk, e.step).ok());
  Session session;
  session.start_branch({bench.run->journal, e.step, e.vertex, e.other, e.point + Vec3{50, 0, 0}},
                       bench.run->parameters, *bench.run->scene, 0);
  REQUIRE(session.wait_until_settled(60));
  REQUIRE(session.snapshot().phase == SessionPhase::failed);
  CHECK(session.snapshot().error->code == ErrorCode::usage);
}

namespace {

/// Whether the edge could collapse with another value of one parameter.
bool possible_with(const Bench& bench, const StateSnapshot& state, const Event& e,
                   double CriteriaParameters::*member, double value) {
  XrayContext context = bench.context();
  context.criteria = state.criteria;
  (*context.criteria).*member = value;
  const auto x = edge_xray(state, {e.vertex, e.other, {}, {}}, context);
  REQUIRE(x.has_value());
  return x->attempt.possible();
}

/// Asks about rejected edges and checks what is said of one parameter; how many of them it would unlock.
std::size_t check_advice(const Bench& bench, Reason reason, ParameterAdvice::Parameter parameter,
                         double CriteriaParameters::*member, std::size_t& asked) {
  std::size_t works = 0;
  for (std::uint32_t i = 0; i < bench.events().size() && asked < 4; ++i) {
    const Event& e = bench.events()[i];
    if (e.kind != EventKind::rejection || e.reason != reason) continue;
    const auto state = bench.state(e.step);
    const auto advice = advise_edge(*state, {e.vertex, e.other, {}, {}}, bench.context(), RunControl());
    const auto found = std::find_if(advice.begin(), advice.end(),
                                    [&](const ParameterAdvice& a) { return a.parameter == parameter; });
    REQUIRE(found != advice.end());
    CHECK(found->now == state->criteria.*member);
    CHECK(found->holds == possible_with(bench, *state, e, member, found->now));
    CHECK(!found->at_least);
    if (found->holds) continue; // the general search finds what the ends alone did not
    ++asked;
    if (!found->works) {
      for (const double part : {0.9, 0.5, 0.1})
        CHECK(!possible_with(bench, *state, e, member, part * found->now));
      continue;
    }
    ++works;
    CHECK(*found->works < found->now);
    CHECK(possible_with(bench, *state, e, member, *found->works));
  }
  return works;
}

} // namespace

TEST_CASE("advice on a locked edge names values with which it collapses, or there are none") {
  std::size_t shrinks = 0, alphas = 0;
  const std::size_t by_shrink = check_advice(bracket(), Reason::normals, ParameterAdvice::Parameter::shrink,
                                             &CriteriaParameters::shrink, shrinks);
  CHECK(shrinks > 0);
  const Bench sampled("sphere", TargetStrategy::constraints, Containment::sampled);
  const std::size_t by_alpha = check_advice(sampled, Reason::misclassified, ParameterAdvice::Parameter::alpha,
                                            &CriteriaParameters::alpha, alphas);
  CHECK(alphas > 0);
  MESSAGE(by_shrink << " of " << shrinks << " by shrink, " << by_alpha << " of " << alphas << " by alpha");
  // α belongs to condition 1, which certified mode does not ask of a collapse.
  const Event& e = bracket().events()[bracket().find(EventKind::collapse, Stage::zero_set)];
  const auto state = bracket().state(e.step);
  const auto advice = advise_edge(*state, {e.vertex, e.other, {}, {}}, bracket().context(), RunControl());
  for (const ParameterAdvice& a : advice) {
    CHECK(a.parameter == ParameterAdvice::Parameter::shrink);
    CHECK(a.holds);
    CHECK(!a.works);
  }
  CHECK(advice.size() == 1);
  CHECK(
      advise_edge(*bracket().state(0), {VertexId(0), VertexId(1), {}, {}}, bracket().context(), RunControl())
          .empty());
}
