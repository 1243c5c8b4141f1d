// What scripts can expect of an edge's questions: gates, kernel, candidates, pruning, what-if, unlocking,
// branches.
#include "edge/probe.h"

#include <limits>

namespace isoscope {
namespace {

std::string count(std::size_t n) {
  return std::to_string(n);
}

std::string check_word(CheckVerdict::State state) {
  return state == CheckVerdict::State::passed   ? "passed"
         : state == CheckVerdict::State::failed ? "failed"
                                                : "skipped";
}

void add_xray(NamedValues& t, const EdgeProbe& m) {
  const auto of = [&](std::string name, std::string help, auto get) {
    t.add("xray." + std::move(name), std::move(help), [get, &m] {
      const auto xray = m.xray();
      return xray ? std::string(get(*xray)) : std::string("none");
    });
  };
  of("verdict", "none where there is no X-ray; possible, or why the edge stays", [](const EdgeXray& x) {
    return x.attempt.possible() ? std::string_view("possible") : name(x.attempt.rejected);
  });
  of("found_by", "how its target was found", [](const EdgeXray& x) { return name(x.attempt.found_by); });
  of("agrees", "whether the journal's verdict is the same; unasked without an event",
     [](const EdgeXray& x) { return x.agrees ? on_off(*x.agrees) : std::string("unasked"); });
  of("halfedge", "whether the ends alone were asked", [](const EdgeXray& x) { return on_off(x.halfedge); });
  of("tried", "candidates judged", [](const EdgeXray& x) { return count(x.attempt.tried); });
  of("recorded", "candidates recorded", [](const EdgeXray& x) { return count(x.attempt.candidates.size()); });
  of("kernel_radius", "of the largest ball in the kernel", [](const EdgeXray& x) {
    return x.attempt.kernel ? text_of(x.attempt.kernel->inscribed_radius) : std::string("nan");
  });
  of("kernel_faces", "of the kernel's polyhedron",
     [](const EdgeXray& x) { return count(x.kernel.faces.size()); });
  of("psi_shown", "Ψ that have room in the kernel, the largest",
     [](const EdgeXray& x) { return count(x.invalid.size()); });
  of("cells_visited", "cells of the octree search",
     [](const EdgeXray& x) { return count(x.attempt.cells.size()); });
  of("cost", "the error at the target", [](const EdgeXray& x) { return text_of(x.attempt.cost); });
  of("optimum_cost", "the least error without constraints",
     [](const EdgeXray& x) { return text_of(x.attempt.unconstrained_cost); });
  of("offenders", "simplices that break the link condition", [](const EdgeXray& x) {
    return count(x.attempt.link.offending_t.size() + x.attempt.link.offending_zero.size());
  });
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    const std::string key(name(check));
    of(key, "passed, failed or skipped",
       [check](const EdgeXray& x) { return check_word(x.attempt.check(check).state); });
    of(key + ".value", "what the check measured",
       [check](const EdgeXray& x) { return text_of(x.attempt.check(check).value); });
    of(key + ".limit", "its limit",
       [check](const EdgeXray& x) { return text_of(x.attempt.check(check).limit); });
  }
  of("kernel_volume", "of the kernel's polyhedron",
     [](const EdgeXray& x) { return text_of(x.kernel.volume); });
  of("half_spaces", "of the kernel",
     [](const EdgeXray& x) { return count(x.attempt.kernel ? x.attempt.kernel->half_spaces.size() : 0); });
  of("kernel_witnesses", "half-spaces of an empty kernel that have no common point",
     [](const EdgeXray& x) { return count(x.attempt.kernel ? x.attempt.kernel->witness.size() : 0); });
  of("missing_slack", "by how much an empty kernel's half-spaces miss a common point",
     [](const EdgeXray& x) { return text_of(x.attempt.kernel ? x.attempt.kernel->missing_slack : 0); });
  of("missing_slack_delta", "the same in units of δ", [](const EdgeXray& x) {
    return text_of(
        x.attempt.kernel && x.criteria.delta > 0 ? x.attempt.kernel->missing_slack / x.criteria.delta : 0);
  });
  of("cost_ratio", "the error at the target over the least one without constraints", [](const EdgeXray& x) {
    return text_of(x.attempt.unconstrained_cost > 0 ? x.attempt.cost / x.attempt.unconstrained_cost
                                                    : std::numeric_limits<double>::infinity());
  });
  of("optimum_distance", "of the target from where the error is least", [](const EdgeXray& x) {
    return text_of(x.attempt.possible() ? distance(x.attempt.target, x.attempt.optimum)
                                        : std::numeric_limits<double>::quiet_NaN());
  });
  of("offenders_t", "simplices that break the link condition in T",
     [](const EdgeXray& x) { return count(x.attempt.link.offending_t.size()); });
  of("offenders_zero", "the same in Z",
     [](const EdgeXray& x) { return count(x.attempt.link.offending_zero.size()); });
  of("psi_count", "Ψ that the search met",
     [](const EdgeXray& x) { return count(x.attempt.invalid_regions.size()); });
  of("cells_pruned", "octree cells left out for Ψ", [](const EdgeXray& x) { return count(x.pruning.cells); });
  of("pruned_judged", "centres of them and of Ψ that were judged",
     [](const EdgeXray& x) { return count(x.pruning.cells_judged + x.pruning.regions_judged); });
  of("pruned_wrong", "those that would have been accepted",
     [](const EdgeXray& x) { return count(x.pruning.wrong.size()); });
  of("costlier_wrong", "centres left out as too costly that are not",
     [](const EdgeXray& x) { return count(x.pruning.costlier_wrong); });
  for (int i = static_cast<int>(first_rejection); i <= static_cast<int>(last_rejection); ++i) {
    const auto reason = static_cast<Reason>(i);
    of("rejected." + std::string(name(reason)), "candidates rejected for that reason",
       [reason](const EdgeXray& x) { return count(x.candidates[static_cast<std::size_t>(reason)]); });
  }
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    of(std::string(name(check)) + ".seconds", "the time that the check took",
       [check](const EdgeXray& x) { return text_of(x.attempt.check(check).seconds); });
  }
}

void add_what_if(NamedValues& t, const EdgeProbe& m) {
  const auto of = [&](std::string name, std::string help, auto get) {
    t.add("what-if." + std::move(name), std::move(help), [get, &m] {
      const auto study = m.study();
      return study ? std::string(get(*study)) : std::string("none");
    });
  };
  of("verdict", "none where no target is tried; possible, or why not there", [](const TargetStudy& s) {
    return s.attempt.possible() ? std::string_view("possible") : name(s.attempt.rejected);
  });
  of("failed", "the first check behind the kernel that fails",
     [](const TargetStudy& s) { return s.failed ? name(*s.failed) : std::string_view("none"); });
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (int i = 0; i < 3; ++i)
    of(axis[static_cast<std::size_t>(i)], "of the target",
       [i](const TargetStudy& s) { return text_of(s.target[i]); });
  of("cost", "the error there", [](const TargetStudy& s) { return text_of(s.attempt.cost); });
  of("cost_ratio", "over the least one without constraints", [](const TargetStudy& s) {
    return text_of(s.attempt.unconstrained_cost > 0 ? s.attempt.cost / s.attempt.unconstrained_cost
                                                    : std::numeric_limits<double>::infinity());
  });
  of("slack", "by how much it lies in the kernel",
     [](const TargetStudy& s) { return text_of(s.attempt.check(CollapseCheck::candidates).value); });
  of("facets", "of Z at the edge afterwards", [](const TargetStudy& s) { return count(s.after.size()); });
  of("facets_outside", "of them not proven inside Ω", [](const TargetStudy& s) {
    std::size_t n = 0;
    for (const auto& facet : s.after) n += !facet.inside;
    return count(n);
  });
  for (std::size_t i = 0; i < collapse_check_count; ++i) {
    const auto check = static_cast<CollapseCheck>(i);
    const std::string key(name(check));
    of(key, "passed, failed or skipped",
       [check](const TargetStudy& s) { return check_word(s.attempt.check(check).state); });
    of(key + ".value", "what the check measured",
       [check](const TargetStudy& s) { return text_of(s.attempt.check(check).value); });
    of(key + ".before", "the same before the collapse", [check](const TargetStudy& s) {
      for (const auto& change : s.changes)
        if (change.check == check && change.before) return text_of(change.before->value);
      return std::string("nan");
    });
  }
  t.add("candidate", "the candidate that is shown", [&m] {
    return m.window.selection.candidate ? count(*m.window.selection.candidate) : std::string("nan");
  });
  t.add("candidate.reason", "why it was rejected; none: taken", [&m] {
    const auto xray = m.xray();
    const auto i = m.window.selection.candidate;
    return xray && i && *i < xray->attempt.candidates.size()
               ? std::string(name(xray->attempt.candidates[*i].rejected))
               : std::string("nan");
  });
  t.add("candidate.value", "what rejected it measured", [&m] {
    const auto xray = m.xray();
    const auto i = m.window.selection.candidate;
    return xray && i && *i < xray->attempt.candidates.size() ? text_of(xray->attempt.candidates[*i].value)
                                                             : std::string("nan");
  });
}

void add_unlock(NamedValues& t, const EdgeProbe& m) {
  const auto of = [&](std::string name, std::string help, auto get) {
    t.add("unlock." + std::move(name), std::move(help), [get, &m] {
      const auto search = m.unlock_search();
      return search ? std::string(get(*search)) : std::string("none");
    });
  };
  of("trials", "neighbouring edges that were tried",
     [](const UnlockSearch& s) { return count(s.trials.size()); });
  of("possible", "those that can be collapsed themselves", [](const UnlockSearch& s) {
    std::size_t n = 0;
    for (const UnlockTrial& trial : s.trials) n += trial.rejected == Reason::none;
    return count(n);
  });
  of("count", "those whose collapse makes the picked one possible",
     [](const UnlockSearch& s) { return count(s.count()); });
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
  t.add("repair.sweeps", "sweeps of the selected repair", [&m] {
    const RepairDetail* sweeps = sweeps_of(m);
    return sweeps ? count(sweeps->size()) : std::string("nan");
  });
  const auto of = [&](const char* name, const char* help, auto get) {
    t.add(name, help, [get, &m] {
      const RepairDetail* sweeps = sweeps_of(m);
      return sweeps && !sweeps->empty() ? text_of(get(*sweeps)) : std::string("nan");
    });
  };
  of("repair.first", "its largest d after the first sweep",
     [](const RepairDetail& s) { return s.front().distance_left; });
  of("repair.last", "its largest d after the last",
     [](const RepairDetail& s) { return s.back().distance_left; });
  of("repair.excess", "the last in units of δ, less one",
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
