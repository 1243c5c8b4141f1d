// Texts of parameters and back.
#include "run/parameter_values.h"

#include "base/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace isoscope {

std::string Tolerance::text() const {
  if (automatic) return "auto";
  return shortest(value) + (percent ? "%" : "");
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
  const auto neighbors = read_number<int>(text);
  if (!neighbors || *neighbors < 2) return std::nullopt;
  return Robust{*neighbors};
}

Status Robust::check(const FieldFacts& field, const std::string& asked) const {
  return check_range(field, asked, neighbors);
}

std::string BallTestFactor::text() const {
  return gamma == automatic ? "auto" : gamma == off ? "off" : shortest(gamma);
}

std::optional<BallTestFactor> BallTestFactor::read(std::string_view text) {
  if (text == "auto") return BallTestFactor{automatic};
  if (text == "off") return BallTestFactor{off};
  const auto gamma = read_number(text);
  if (!gamma || !(*gamma > 0)) return std::nullopt;
  return BallTestFactor{*gamma};
}

Status BallTestFactor::check(const FieldFacts& field, const std::string& asked) const {
  return gamma == automatic || gamma == off ? Status() : check_range(field, asked, gamma);
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

std::optional<Fill> Fill::read(std::string_view text) {
  if (text == "none" || text == "all" || text == "flat") return Fill{std::string(text)};
  const char *at = text.data(), *const end = text.data() + text.size();
  std::string holes;
  for (;;) {
    std::uint32_t loop = 0;
    const auto [next, failure] = std::from_chars(at, end, loop);
    if (failure != std::errc() || loop == 0) return std::nullopt;
    holes += (holes.empty() ? "" : ",") + std::to_string(loop);
    if (next == end) return Fill{holes};
    if (*next != ',') return std::nullopt;
    at = next + 1;
  }
}

Status Fill::check(const FieldFacts& field, const std::string& asked) const {
  return read(holes) ? Status() : Status(unreadable_field(field, asked, holes, ""));
}

HoleChoice Fill::choice() const {
  HoleChoice choice;
  if (holes == "none") return choice;
  choice.rule = holes == "all"    ? HoleChoice::Rule::all
                : holes == "flat" ? HoleChoice::Rule::flat
                                  : HoleChoice::Rule::listed;
  if (choice.rule != HoleChoice::Rule::listed) return choice;
  const char *at = holes.data(), *const end = holes.data() + holes.size();
  while (at < end) {
    std::uint32_t loop = 0;
    at = std::from_chars(at, end, loop).ptr + 1;
    choice.loops.push_back(loop - 1);
  }
  std::sort(choice.loops.begin(), choice.loops.end());
  return choice;
}

} // namespace isoscope
