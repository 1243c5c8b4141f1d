// Ranges of the options, checked before anything is computed.
#include "run/parameters.h"

#include "base/memory.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

namespace isoscope {

namespace {

std::string shortest(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

Status in_range(const char* option, double value, double low, bool low_included, double high,
                bool high_included, const char* remedy) {
  const bool above = low_included ? value >= low : value > low;
  const bool below = high_included ? value <= high : value < high;
  if (above && below) return {};
  std::string message = std::string(option) + " is " + shortest(value) + ", which is not in ";
  message +=
      (low_included ? "[" : "(") + shortest(low) + ", " + shortest(high) + (high_included ? "]." : ").");
  return Error{ErrorCode::usage, message, remedy};
}

} // namespace

std::string Tolerance::text() const {
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
  c.condition_1 = condition_1;
  c.condition_2 = condition_2;
  c.condition_3 = condition_3;
  c.condition_4 = condition_4;
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

std::string_view name(SidesMode mode) {
  constexpr std::array<std::string_view, 3> names{"auto", "winding", "parity"};
  return names[static_cast<std::size_t>(mode)];
}

std::optional<SidesMode> sides_mode(std::string_view text) {
  for (const SidesMode mode : {SidesMode::automatic, SidesMode::winding, SidesMode::parity})
    if (name(mode) == text) return mode;
  return std::nullopt;
}

Result<Tolerance> parse_tolerance(std::string_view text) {
  Tolerance tolerance;
  std::string_view digits = text;
  tolerance.percent = !digits.empty() && digits.back() == '%';
  if (tolerance.percent) digits.remove_suffix(1);
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), tolerance.value);
  if (failure != std::errc() || end != digits.data() + digits.size() || !std::isfinite(tolerance.value) ||
      tolerance.value <= 0) {
    return Error{ErrorCode::usage, "--tolerance is '" + std::string(text) + "', which is no positive number.",
                 "Give a percentage of the longest edge, as 0.6%, or a length, as 0.012."};
  }
  return tolerance;
}

Result<std::optional<double>> parse_cover(std::string_view text) {
  if (text == "off") return std::optional<double>();
  double value = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (failure != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value <= 0) {
    return Error{ErrorCode::usage,
                 "--cover is '" + std::string(text) + "', which is neither a positive number nor off.",
                 "It is in δ: 3 lets no point of the input be farther than 3 δ from the result."};
  }
  return std::optional<double>(value);
}

Status check(const RunParameters& p) {
  if (!std::isfinite(p.tolerance.value) || p.tolerance.value <= 0) {
    return Error{ErrorCode::usage,
                 "--tolerance is " + shortest(p.tolerance.value) + ", which is not above 0.",
                 "Give a percentage of the longest edge, as 0.6%, or a length."};
  }
  if (p.tolerance.percent) {
    if (Status s = in_range("--tolerance", p.tolerance.value, 0, false, 100, true,
                            "Percentages are of the longest edge of the input's bounding box.");
        !s) {
      return s;
    }
  }
  if (p.sigma != 0) {
    if (Status s = in_range("--sigma", p.sigma, 0, false, 1, true, "It is relative to δ: 0.5 means δ/2."); !s)
      return s;
  }
  if (Status s = in_range("--alpha", p.alpha, 0, false, 1, false, "The paper takes 0.2 everywhere."); !s)
    return s;
  if (Status s = in_range("--shrink", p.shrink, 0, false, 1, true, "The paper takes 0.7."); !s) return s;
  if (p.cover && !(std::isfinite(*p.cover) && *p.cover > 0)) {
    return Error{ErrorCode::usage, "--cover is " + shortest(*p.cover) + ", which is not above 0.",
                 "It is in δ; off takes the limit away."};
  }
  if (!std::isfinite(p.time_limit) || p.time_limit < 0) {
    return Error{ErrorCode::usage, "--time-limit is " + shortest(p.time_limit) + ", which is no time.",
                 "Give seconds, at least 0; 0 means none."};
  }
  if (Status s = in_range("--drop-small", p.drop_small, 0, true, 1e6, true,
                          "It is in δ: 4 leaves out parts with a box smaller than 4 δ; 0 leaves out none.");
      !s)
    return s;
  if (!std::isfinite(p.memory_limit) || p.memory_limit < 0) {
    return Error{ErrorCode::usage, "--memory-limit is " + shortest(p.memory_limit) + ", which is no size.",
                 "Give MiB, at least 0; 0 means two thirds of the machine's memory."};
  }
  if (p.effort < 0 || p.effort > 3) {
    return Error{ErrorCode::usage, "--effort is " + std::to_string(p.effort) + ", which is not 0, 1, 2 or 3.",
                 "2 is the default; 3 takes longest and gives the fewest vertices."};
  }
  if (p.threads > 1024) {
    return Error{ErrorCode::usage, "--threads is " + std::to_string(p.threads) + ", which is more than 1024.",
                 "0 takes all cores."};
  }
  return {};
}

} // namespace isoscope
