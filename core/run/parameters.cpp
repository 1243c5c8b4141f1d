// What follows from the parameters, and what δ may be.
#include "run/parameters.h"

#include "base/memory.h"

#include <cmath>
#include <limits>

namespace isoscope {

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
  return {};
}

} // namespace isoscope
