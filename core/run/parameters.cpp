// What follows from the parameters, and what δ may be.
#include "run/parameters.h"

#include "base/memory.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace isoscope {

std::string Tolerance::text() const {
  if (automatic) return "auto";
  return shortest(value) + (percent ? "%" : "");
}

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
  return s;
}

std::optional<Tolerance> Tolerance::read(std::string_view text) {
  Tolerance tolerance;
  if (text == "auto") {
    tolerance.automatic = true;
    return tolerance;
  }
  std::string_view digits = text;
  tolerance.percent = !digits.empty() && digits.back() == '%';
  if (tolerance.percent) digits.remove_suffix(1);
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), tolerance.value);
  if (failure != std::errc() || end != digits.data() + digits.size() || !std::isfinite(tolerance.value) ||
      tolerance.value <= 0)
    return std::nullopt;
  return tolerance;
}

Status Tolerance::check(const FieldFacts& field, const std::string& asked) const {
  if (automatic) return {};
  if (!std::isfinite(value) || value <= 0)
    return Error{ErrorCode::usage, asked + " is " + shortest(value) + ", which is not above 0.",
                 "Give a percentage of the longest edge, as 0.6%, or a length."};
  return percent ? check_range(field, asked, value) : Status();
}

std::string Robust::text() const {
  return neighbors == automatic ? "auto" : neighbors == off ? "off" : std::to_string(neighbors);
}

std::optional<Robust> Robust::read(std::string_view text) {
  if (text == "auto") return Robust{automatic};
  if (text == "off") return Robust{off};
  int neighbors = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), neighbors);
  if (failure != std::errc() || end != text.data() + text.size() || neighbors < 2) return std::nullopt;
  return Robust{neighbors};
}

Status Robust::check(const FieldFacts& field, const std::string& asked) const {
  return check_range(field, asked, neighbors);
}

std::string Levels::text() const {
  return given() ? shortest(low) + " " + shortest(high) : "none";
}

std::optional<Levels> Levels::read(std::string_view text) {
  if (text == "none") return Levels{};
  Levels levels;
  const char *at = text.data(), *const end = text.data() + text.size();
  for (double* level : {&levels.low, &levels.high}) {
    while (at != end && *at == ' ') ++at;
    const auto [next, failure] = std::from_chars(at, end, *level);
    if (failure != std::errc() || !std::isfinite(*level)) return std::nullopt;
    at = next;
  }
  if (at != end || !(levels.low < levels.high)) return std::nullopt;
  return levels;
}

Status Levels::check(const FieldFacts& field, const std::string& asked) const {
  if (std::isfinite(low) && std::isfinite(high) && low <= high) return {};
  return unreadable_field(field, asked, text(), "");
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
