// What follows from the parameters, and what δ may be.
#include "run/parameters.h"

#include "base/memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

/// Without T there is nothing but the improver on Z alone.
Status check_start(const RunParameters& p) {
  const auto wrong = [&](const std::string& why, const char* remedy) {
    return Error{ErrorCode::usage, "--start " + std::string(word_of(&RunParameters::start, p)) + " " + why,
                 remedy};
  };
  if (p.improver == ImproverPlace::embedded)
    return wrong("has no T for --improver embedded to work in.", "Leave one of them out.");
  if (p.last_stage() != Stage::improve)
    return wrong("runs the improver alone, but the last stage is " + std::string(name(p.last_stage())) + ".",
                 "Give --until improve, or leave --start out.");
  if (p.skipped[static_cast<std::size_t>(Stage::improve)])
    return wrong("runs the improver alone, which --skip improve leaves out.", "Leave one of them out.");
  return {};
}

} // namespace

double RunParameters::most_bytes() const {
  constexpr double mebibyte = 1 << 20, share = 2.0 / 3;
  if (memory_limit > 0) return memory_limit * mebibyte;
  const std::uint64_t available = available_memory_bytes();
  return available > 0 ? share * static_cast<double>(available) : std::numeric_limits<double>::infinity();
}

CriteriaParameters RunParameters::criteria(double delta, double default_sigma) const {
  CriteriaParameters c;
  c.delta = delta;
  c.sigma = sigma_ratio(default_sigma) * delta;
  c.alpha = alpha;
  c.shrink = shrink;
  c.certified = containment == Containment::certified;
  c.condition_1 = conditions[0];
  c.condition_2 = conditions[1];
  c.condition_3 = conditions[2];
  c.condition_4 = conditions[3];
  return c;
}

SimplificationParameters RunParameters::simplification() const {
  SimplificationParameters s;
  s.until = last_stage();
  s.skipped = skipped;
  s.target = target;
  s.ring = cost_ring;
  s.effort = effort;
  s.improver = improver;
  s.fill = fill.choice();
  return s;
}

std::vector<LiveChange> live_changes(const RunParameters& from, const RunParameters& to,
                                     double default_sigma) {
  std::vector<LiveChange> changes;
  // Samples that collapses move keep the margin as well.
  const bool sampled = from.containment == Containment::sampled;
  const auto last = [&](std::string_view until, bool margin) {
    const auto named = std::find_if(stage_table.begin(), stage_table.end(),
                                    [&](const StageWords& words) { return words.name == until; });
    return (margin && sampled) || named == stage_table.end() ? Stage::all : named->value;
  };
  for_each_field<RunParameters>([&]<class T>(const Field<RunParameters, T>& f) {
    if (f.restart) return;
    if constexpr (FlagField<T>::value) {
      for (std::size_t i = 0; i < f.choices.size(); ++i)
        if ((from.*(f.member))[i] != (to.*(f.member))[i])
          changes.push_back({"condition " + std::string(f.choices[i].name),
                             (from.*(f.member))[i] ? "on" : "off", (to.*(f.member))[i] ? "on" : "off",
                             last(f.choices[i].until, false)});
    } else if constexpr (std::is_same_v<T, double>) {
      const bool sigma = f.member == &RunParameters::sigma;
      const double was = sigma ? from.sigma_ratio(default_sigma) : from.*(f.member);
      const double is = sigma ? to.sigma_ratio(default_sigma) : to.*(f.member);
      if (was != is)
        changes.push_back({std::string(f.symbol), general(was, 4), general(is, 4),
                           last(f.until, f.member == &RunParameters::alpha)});
    }
  });
  return changes;
}

Status check(const RunParameters& p) {
  if (Status each = check_fields(p); !each) return each;
  if (p.sides == SidesMode::multi && (p.levels.given() || p.label))
    return Error{ErrorCode::usage,
                 std::string(p.label ? "--label" : "--levels") +
                     " is given together with --sides multi, which takes all labels of a grid.",
                 "Leave one of them out."};
  if (!p.inside.empty() && (p.levels.given() || p.label))
    return Error{ErrorCode::usage,
                 "--levels and --label are for a grid, --inside and --outside for two surfaces.",
                 "Give one kind of volume."};
  if (p.start != FirstZ::delaunay) return check_start(p);
  return {};
}

} // namespace isoscope
