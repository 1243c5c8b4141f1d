// What scripts can expect of an edge's questions: gates, kernel, candidates, pruning, what-if, unlocking,
// branches.
#include "edge/probe.h"

#include "questions/edge_standing.h"
#include "questions/outside_kernel.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace isoscope {
namespace {

std::string_view check_word(CheckVerdict::State state) {
  return state == CheckVerdict::State::passed   ? "passed"
         : state == CheckVerdict::State::failed ? "failed"
                                                : "skipped";
}

/// Of an X-ray or of a target that is tried.
constexpr auto verdict_of = [](const auto& x) {
  return x.attempt.possible() ? std::string_view("possible") : name(x.attempt.rejected);
};
constexpr auto cost_ratio_of = [](const auto& x) {
  return x.attempt.unconstrained_cost > 0 ? x.attempt.cost / x.attempt.unconstrained_cost
                                          : std::numeric_limits<double>::infinity();
};

/// Calls add(check, its name) for every check of a collapse.
template <class Add> void for_each_check(Add add) {
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    add(check, std::string(name(check)));
  }
}

/// How every check ended and what it measured.
constexpr auto add_check = [](const auto& of, CollapseCheck check, const std::string& key) {
  of(key, "passed, failed or skipped",
     [check](const auto& x) { return check_word(x.attempt.check(check).state); });
  of(key + ".value", "what the check measured",
     [check](const auto& x) { return x.attempt.check(check).value; });
};

void add_xray(NamedValues& t, const EdgeProbe& m) {
  using X = EdgeXray;
  const auto of = t.readings("xray.", [&m] { return m.xray(); });
  const auto of_kernel = [&of](const char* name, const char* help, auto get) {
    of(name, help, [get](const X& x) {
      return x.attempt.kernel ? get(*x.attempt.kernel) : decltype(get(*x.attempt.kernel))();
    });
  };
  of("verdict", "none where there is no X-ray; possible, or why the edge stays", verdict_of);
  of("found_by", "how its target was found", [](const X& x) { return x.attempt.found_by; });
  of("agrees", "whether the journal's verdict is the same; unasked without an event",
     [](const X& x) { return value_text(x.agrees, "unasked"); });
  of("halfedge", "whether the ends alone were asked", &X::halfedge);
  of("tried", "candidates judged", [](const X& x) { return x.attempt.tried; });
  of("recorded", "candidates recorded", [](const X& x) { return x.attempt.candidates.size(); });
  of("kernel_radius", "of the largest ball in the kernel", [](const X& x) {
    return x.attempt.kernel ? text_of(x.attempt.kernel->inscribed_radius) : std::string("nan");
  });
  of("kernel_faces", "of the kernel's polyhedron", [](const X& x) { return x.kernel.faces.size(); });
  of("psi_shown", "Ψ that have room in the kernel, the largest", [](const X& x) { return x.invalid.size(); });
  of("cells_visited", "cells of the octree search", [](const X& x) { return x.attempt.cells.size(); });
  of("outside", "points that lie outside the kernel: its ends and the place of least error",
     [](const X& x) { return points_outside(x).size(); });
  of("cost", "the error at the target", [](const X& x) { return x.attempt.cost; });
  of("optimum_cost", "the least error without constraints",
     [](const X& x) { return x.attempt.unconstrained_cost; });
  of("offenders", "simplices that break the link condition",
     [](const X& x) { return x.attempt.link.offending_t.size() + x.attempt.link.offending_zero.size(); });
  for_each_check([&of](CollapseCheck check, const std::string& key) {
    add_check(of, check, key);
    of(key + ".limit", "its limit", [check](const X& x) { return x.attempt.check(check).limit; });
  });
  of("kernel_volume", "of the kernel's polyhedron", [](const X& x) { return x.kernel.volume; });
  of_kernel("half_spaces", "of the kernel", [](const auto& k) { return k.half_spaces.size(); });
  of_kernel("kernel_witnesses", "half-spaces of an empty kernel that have no common point",
            [](const auto& k) { return k.witness.size(); });
  of_kernel("missing_slack", "by how much an empty kernel's half-spaces miss a common point",
            [](const auto& k) { return k.missing_slack; });
  of("missing_slack_delta", "the same in units of δ", [](const X& x) {
    return x.attempt.kernel && x.criteria.delta > 0 ? x.attempt.kernel->missing_slack / x.criteria.delta : 0;
  });
  of("cost_ratio", "the error at the target over the least one without constraints", cost_ratio_of);
  of("optimum_distance", "of the target from where the error is least", [](const X& x) {
    return x.attempt.possible() ? distance(x.attempt.target, x.attempt.optimum)
                                : std::numeric_limits<double>::quiet_NaN();
  });
  const auto standing = t.readings("stratum.", [&m]() -> std::optional<EdgeStanding> {
    const auto x = m.xray();
    if (!x || x->star.form != ZeroForm::embedded) return std::nullopt;
    return edge_standing(x->star, x->attempt.link);
  });
  const auto word = [](Stratum s) {
    constexpr std::array<std::string_view, 4> words{"point", "curve", "sheet", "room"};
    return words.at(static_cast<std::size_t>(s));
  };
  const auto answer = [](LinkAnswer a) {
    constexpr std::array<std::string_view, 3> words{"not-asked", "holds", "fails"};
    return words.at(static_cast<std::size_t>(a));
  };
  using S = EdgeStanding;
  standing("edge", "where the selected edge lies: in a sheet, on a curve, or in a room",
           [word](const S& s) { return word(s.strata.edge); });
  standing("a", "where the end lies that stays: a point, on a curve or sheet, or in a room",
           [word](const S& s) { return word(s.strata.a); });
  standing("b", "where the other end lies", [word](const S& s) { return word(s.strata.b); });
  standing("border", "whether the edge is of the border of Z", [](const S& s) { return s.strata.border; });
  standing("sides", "labels around it", [](const S& s) { return s.labels.size(); });
  standing("link_t", "its link condition in T: holds, fails or not-asked",
           [answer](const S& s) { return answer(s.in_t); });
  standing("link_sheets", "the same in the sheets of Z",
           [answer](const S& s) { return answer(s.in_sheets); });
  standing("link_curves", "the same on their curves", [answer](const S& s) { return answer(s.on_curves); });
  of("offenders_t", "simplices that break the link condition in T",
     [](const X& x) { return x.attempt.link.offending_t.size(); });
  of("offenders_zero", "the same in Z", [](const X& x) { return x.attempt.link.offending_zero.size(); });
  of("psi_count", "Ψ that the search met", [](const X& x) { return x.attempt.invalid_regions.size(); });
  of("cells_pruned", "octree cells left out for Ψ", [](const X& x) { return x.pruning.cells; });
  of("pruned_judged", "centres of them and of Ψ that were judged",
     [](const X& x) { return x.pruning.cells_judged + x.pruning.regions_judged; });
  of("pruned_wrong", "those that would have been accepted",
     [](const X& x) { return x.pruning.wrong.size(); });
  of("costlier_wrong", "centres left out as too costly that are not",
     [](const X& x) { return x.pruning.costlier_wrong; });
  for (const Reason reason : rejecting_reasons) {
    of("rejected." + std::string(name(reason)), "candidates rejected for that reason",
       [reason](const X& x) { return x.candidates[static_cast<std::size_t>(reason)]; });
  }
  for_each_check([&of](CollapseCheck check, const std::string& key) {
    of(key + ".seconds", "the time that the check took",
       [check](const X& x) { return x.attempt.check(check).seconds; });
  });
}

void add_what_if(NamedValues& t, const EdgeProbe& m) {
  using S = TargetStudy;
  const auto of = t.readings("what-if.", [&m] { return m.study(); });
  of("verdict", "none where no target is tried; possible, or why not there", verdict_of);
  of("failed", "the first check behind the kernel that fails", &S::failed);
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    of(axis[static_cast<std::size_t>(i)], "of the target", [i](const S& s) { return s.target[i]; });
  of("cost", "the error there", [](const S& s) { return s.attempt.cost; });
  of("cost_ratio", "over the least one without constraints", cost_ratio_of);
  of("slack", "by how much it lies in the kernel",
     [](const S& s) { return s.attempt.check(CollapseCheck::candidates).value; });
  of("facets", "of Z at the edge afterwards", [](const S& s) { return s.after.size(); });
  of("facets_outside", "of them not proven inside Ω", [](const S& s) {
    return std::count_if(s.after.begin(), s.after.end(), [](const auto& facet) { return !facet.inside; });
  });
  for_each_check([&of](CollapseCheck check, const std::string& key) {
    add_check(of, check, key);
    of(key + ".before", "the same before the collapse", [check](const S& s) {
      for (const auto& change : s.changes)
        if (change.check == check && change.before) return text_of(change.before->value);
      return std::string("nan");
    });
  });
  t.add("candidate", "the candidate that is shown",
        [&m] { return value_text(m.window.selection.candidate, "nan"); });
  const auto shown = [&m] {
    const auto xray = m.xray();
    const auto i = m.window.selection.candidate;
    return xray && i && *i < xray->attempt.candidates.size() ? std::optional(xray->attempt.candidates[*i])
                                                             : std::nullopt;
  };
  const auto of_candidate = t.readings("candidate.", shown, "nan");
  of_candidate("reason", "why it was rejected; none: taken", [](const auto& c) { return c.rejected; });
  of_candidate("value", "what rejected it measured", [](const auto& c) { return c.value; });
}

void add_unlock(NamedValues& t, const EdgeProbe& m) {
  using S = UnlockSearch;
  const auto of = t.readings("unlock.", [&m] { return m.unlock_search(); });
  of("trials", "neighbouring edges that were tried", [](const S& s) { return s.trials.size(); });
  of("possible", "those that can be collapsed themselves", [](const S& s) {
    return std::count_if(s.trials.begin(), s.trials.end(),
                         [](const UnlockTrial& trial) { return trial.rejected == Reason::none; });
  });
  of("count", "those whose collapse makes the picked one possible", &S::count);
}

const RepairDetail* sweeps_of(const EdgeProbe& m) {
  const auto event = m.window.selected_event();
  if (!event) return nullptr;
  const std::uint32_t detail = m.window.run.journal->events()[*event].detail;
  return detail > 0 && detail < m.window.run.journal->repairs().size()
             ? &m.window.run.journal->repairs()[detail]
             : nullptr;
}

void add_repairs(NamedValues& t, const EdgeProbe& m) {
  const auto sweeps = [&m] { return sweeps_of(m); };
  const auto swept = [&m]() -> const RepairDetail* {
    const RepairDetail* found = sweeps_of(m);
    return found != nullptr && !found->empty() ? found : nullptr;
  };
  t.readings("repair.", sweeps, "nan")("sweeps", "sweeps of the selected repair",
                                       [](const RepairDetail& s) { return s.size(); });
  const auto of = t.readings("repair.", swept, "nan");
  of("first", "its largest d after the first sweep",
     [](const RepairDetail& s) { return s.front().distance_left; });
  of("last", "its largest d after the last", [](const RepairDetail& s) { return s.back().distance_left; });
  of("excess", "the last in units of δ, less one",
     [&m](const RepairDetail& s) { return s.back().distance_left / m.window.run.scene->delta - 1; });
}

} // namespace

void EdgeProbe::add_values(NamedValues& values) {
  add_xray(values, *this);
  add_what_if(values, *this);
  add_unlock(values, *this);
  add_repairs(values, *this);
}

} // namespace isoscope
