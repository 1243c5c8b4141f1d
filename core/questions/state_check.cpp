// The checks of core/mesh and the certificate on one state; bisection over a playback of its own.
#include "questions/state_check.h"

#include "mesh/predicates.h"
#include "mesh/validity.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

using State = InvariantVerdict::State;

Vec3 center(const Complex& complex, TetId t) {
  const auto p = complex.positions(t);
  return 0.25 * (p[0] + p[1] + p[2] + p[3]);
}

InvariantVerdict from_defects(const std::vector<Defect>& defects, const Complex& complex) {
  InvariantVerdict v;
  v.state = defects.empty() ? State::holds : State::broken;
  if (defects.empty()) return v;
  v.words = defects.front().what;
  if (defects.size() > 1) v.words += " (" + std::to_string(defects.size()) + " defects)";
  const TetId t = defects.front().tet;
  if (t.valid() && t.index() < complex.tets.size() && complex.tet(t).alive()) v.place = center(complex, t);
  return v;
}

/// Whether the refinement is over at a step: an operation of a later stage led there or before.
bool refined(const Journal& journal, Step step) {
  if (step == 0) return false;
  const Event& e = journal.events()[journal.operations()[std::min(step, journal.steps()) - 1].event];
  return e.stage > Stage::refinement;
}

/// Whether Z ends where open surfaces do: before the cut along the rim it goes on beyond it.
bool is_cut(const StateSnapshot& s, const Scene& scene) {
  return scene.volume->open_sides() == nullptr || s.complex.form == ZeroForm::free ||
         std::any_of(s.complex.tets.begin(), s.complex.tets.end(),
                     [](const Tet& t) { return t.dropped != 0; });
}

void check_samples_anew(const StateSnapshot& s, StateReport& report) {
  InvariantVerdict& held = report.verdicts[static_cast<std::size_t>(Invariant::samples)];
  InvariantVerdict& classes = report.verdicts[static_cast<std::size_t>(Invariant::classification)];
  SampleSets anew(s.samples->positions);
  anew.assign_all(s.complex);
  held.state = classes.state = State::holds;
  std::size_t misplaced = 0, wrong = 0;
  constexpr double rounding = 1e-5; ///< errors are kept in single precision
  for (std::size_t i = 0; i < s.samples->size(); ++i) {
    const Vec3 p = s.samples->positions[i];
    const TetId t = s.sample_tets[i], walked = anew.tet_of(SampleId(i));
    const bool right = t == walked && (!t.valid() || holds_perturbed(s.complex.positions(t), p));
    if (!right) {
      if (misplaced++ == 0) held.place = p;
      continue;
    }
    if (!t.valid()) continue;
    const double error = sample_error_at(s.complex, t, p, s.samples->labels[i]);
    const auto shown = static_cast<double>(s.errors[i]);
    if (std::abs(error - shown) <= rounding * std::max(1.0, std::abs(error))) continue;
    if (wrong++ == 0) classes.place = p;
  }
  if (misplaced > 0) {
    held.state = State::broken;
    held.words = counted(misplaced, "sample is", "samples are") + " not in the tetrahedron that is recorded.";
  }
  if (wrong > 0) {
    classes.state = State::broken;
    classes.words = counted(wrong, "sample has", "samples have") + " another ε than shown.";
  }
}

void check_zero_set(const Journal& journal, const StateSnapshot& s, const Scene& scene, bool due,
                    bool certified, StateReport& report, const RunControl& control) {
  const TriangleMesh mesh = triangulate(s.zero_set);
  if (mesh.triangles.empty()) return;
  const FilledHoles holes = filled_holes(journal, s.step, s.complex, s.zero_set);
  const Certificate c = certify(mesh, *scene.volume, with_filled_holes(scene.expected, holes, mesh), control,
                                {std::nullopt, false, false}, holes);
  const auto set = [&](Invariant invariant, bool good, bool goal) {
    InvariantVerdict& v = report.verdicts[static_cast<std::size_t>(invariant)];
    v.state = good ? State::holds : goal && !due ? State::not_due : State::broken;
  };
  set(Invariant::closed, c.manifold, false);
  set(Invariant::oriented, c.oriented, false);
  set(Invariant::embedded, c.intersection_free, false);
  set(Invariant::contained, c.within_tolerance, true);
  // Sampled mode rests on the samples: it proves nothing about facets.
  InvariantVerdict& contained = report.verdicts[static_cast<std::size_t>(Invariant::contained)];
  if (!certified && contained.state == State::broken) contained.state = State::not_due;
  set(Invariant::separating, c.separates, true);
  // What nothing binds can neither hold nor break.
  if (c.topology == Certificate::Topology::as_expected || c.topology == Certificate::Topology::wrong)
    set(Invariant::topology, c.topology == Certificate::Topology::as_expected, true);
  const auto holds = [&](Invariant i) { return report[i].state == State::holds; };
  const auto words = [&](Invariant i) -> std::string& {
    return report.verdicts[static_cast<std::size_t>(i)].words;
  };
  for (const Invariant i : {Invariant::closed, Invariant::oriented, Invariant::embedded})
    if (!c.failures.empty() && !holds(i)) words(i) = c.failures.front(); // what fails first is told first
  char text[96];
  std::snprintf(text, sizeof text, "A facet reaches d = %.4g δ.", c.max_distance / scene.delta);
  if (!holds(Invariant::contained)) words(Invariant::contained) = text;
  if (!holds(Invariant::separating))
    words(Invariant::separating) = "Z winds around a region's deepest point on the wrong side.";
  std::snprintf(text, sizeof text, "Z has χ = %ld, %zu components and %zu boundary loops.",
                c.euler_characteristic, c.components, c.boundary_loops);
  if (!holds(Invariant::topology)) words(Invariant::topology) = text;
}

} // namespace

std::string_view name(Invariant invariant) {
  constexpr std::array<std::string_view, invariant_count> names{
      "tetrahedra", "delaunay", "samples",   "classification", "closed",
      "oriented",   "embedded", "contained", "separating",     "topology"};
  return names.at(static_cast<std::size_t>(invariant));
}

std::size_t StateReport::broken() const {
  return static_cast<std::size_t>(std::count_if(verdicts.begin(), verdicts.end(),
                                                [](const auto& v) { return v.state == State::broken; }));
}

StateReport check_state(const Journal& journal, const StateSnapshot& s, const Scene* scene,
                        const RunControl& control) {
  StateReport report;
  report.step = s.step;
  const auto at = [&](Invariant i) -> InvariantVerdict& {
    return report.verdicts[static_cast<std::size_t>(i)];
  };
  const bool later = refined(journal, s.step);
  const bool has_tets = s.complex.form != ZeroForm::free && s.complex.alive_tets() > 0;
  if (has_tets) {
    at(Invariant::tetrahedra) = from_defects(check_complex(s.complex), s.complex);
    const bool sound = at(Invariant::tetrahedra).state == State::holds;
    if (!later && sound) at(Invariant::delaunay) = from_defects(check_delaunay(s.complex), s.complex);
    if (s.samples && s.sample_tets.size() == s.samples->size() && sound && !control.cancelled())
      check_samples_anew(s, report);
    if (!sound) return report; // Z of a broken T means nothing
  }
  if (scene != nullptr && scene->volume && !control.cancelled())
    check_zero_set(journal, s, *scene, later && is_cut(s, *scene), s.criteria.certified, report, control);
  return report;
}

FirstInvalid find_first_invalid(std::shared_ptr<const Journal> journal, Step last, const Scene* scene,
                                const RunControl& control) {
  FirstInvalid out;
  std::optional<Playback> playback;
  const auto judge = [&](Step step) {
    ++out.probes;
    if (!playback) playback.emplace(journal);
    StateReport found = check_state(*journal, *make_snapshot(*playback, step, {}, nullptr), scene, control);
    // What a playback carries on from a broken T, the places of samples, may be wrong ever after.
    if (!found.valid()) playback.reset();
    return found;
  };
  const auto report_progress = [&](double width, double all) {
    control.report("bisection", all > 1 ? 1 - std::log2(std::max(width, 1.0)) / std::log2(all) : 1);
  };
  last = std::min(last, journal->steps());
  StateReport broken = judge(last);
  out.report = broken;
  if (control.cancelled()) {
    out.end = FirstInvalid::End::cancelled;
    return out;
  }
  if (broken.valid()) return out;
  Step good = 0, bad = last; // nothing is there at step 0
  while (bad - good > 1) {
    const Step middle = good + (bad - good) / 2;
    StateReport found = judge(middle);
    if (control.cancelled()) {
      out.end = FirstInvalid::End::cancelled;
      return out;
    }
    if (found.valid()) {
      good = middle;
    } else {
      bad = middle;
      broken = std::move(found);
    }
    report_progress(bad - good, last);
  }
  out.end = FirstInvalid::End::found;
  out.report = std::move(broken);
  return out;
}

} // namespace isoscope
