// The words, in the order of the enumerations that they name.
#include "model/words.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace isoscope {
namespace {

constexpr std::array<LayerName, 17> layers{{
    {"outer", "Ω outer boundary",
     "The outer boundary surface of the tolerance volume Ω, d = δ outside (§2.1).", &ViewSettings::outer},
    {"inner", "Ω inner boundary",
     "The inner boundary surface of the tolerance volume Ω, d = δ inside (§2.1).", &ViewSettings::inner},
    {"zero", "Z zero set",
     "Z, the zero set of the piecewise linear function f: the mesh under construction (§2.3).",
     &ViewSettings::zero_set},
    {"samples", "S samples", "The σ-dense samples S of ∂Ω with their labels F = ±1 (§2.2).",
     &ViewSettings::samples},
    {"good", "Good samples", "Samples that f classifies as their label says: ε(s) < 1 (§2.2).",
     &ViewSettings::good_samples},
    {"bad", "Bad samples", "Samples on the wrong side of Z: ε(s) ≥ 1 (§2.2).", &ViewSettings::bad_samples},
    {"over-rim", "B boundary samples",
     "The boundary samples B: their closest point lies on the open rim of the input. They have no label, and "
     "refinement does not ask them (§4.1).",
     &ViewSettings::over_rim},
    {"curves", "Curves of Z",
     "The border of Z where it ends, and the curves where three sheets or more meet, as thick lines; points "
     "where these end, branch or cross, as squares (§4.1, §4.2).",
     &ViewSettings::curves},
    {"rim", "Rim of the input",
     "The border of the input: solid where Ω leaves it open, dashed where Ω bridges it (§4.1).",
     &ViewSettings::rim},
    {"dropped", "Facets cut off", "What was cut off Z along the wall over the rim (§4.1).",
     &ViewSettings::dropped},
    {"tets", "T tetrahedra", "Tetrahedra of the triangulation T that the filter lets through.",
     &ViewSettings::tetrahedra},
    {"gamma", "∂Γ boundary of Γ", "The boundary of Γ, the union of tetrahedra that carry Z (§2.3).",
     &ViewSettings::gamma},
    {"other-zero", "Z of the other run", "Edges of Z of the run beside this one, over Z of this one.",
     &ViewSettings::other_zero},
    {"highlight", "Current operation",
     "What the last operation touched: added elements solid, removed ones dashed, moves as arrows, the "
     "violated tetrahedron.",
     &ViewSettings::highlight},
    {"xray", "X-ray of the edge",
     "Of the selected edge: kernel, candidate points by reason, simplices that break the link condition, "
     "optimum and target (§2.4).",
     &ViewSettings::xray},
    {"points", "Points by weight",
     "The points that φ is made of, by √w/δ: what spreads around a point leaves its ball less. Crosses: "
     "those "
     "that were dropped.",
     &ViewSettings::points},
    {"input", "Input triangles", "The triangles as they were read.", &ViewSettings::input},
}};

} // namespace

std::string_view phase_word(SessionPhase phase) {
  constexpr std::array<std::string_view, 7> words{"idle",      "preparing", "running", "paused",
                                                  "following", "finished",  "failed"};
  return words.at(static_cast<std::size_t>(phase));
}
std::string_view transport_word(Transport::Mode mode) {
  constexpr std::array<std::string_view, 3> words{"paused", "playing", "following"};
  return words.at(static_cast<std::size_t>(mode));
}
std::string_view pick_word(Pick::Kind kind) {
  constexpr std::array<std::string_view, 8> words{"none",   "vertex", "edge",  "tet",
                                                  "sample", "facet",  "point", "over-rim"};
  return words.at(static_cast<std::size_t>(kind));
}
std::string side_text(int label, bool rooms) {
  return label > 0 ? "outer" : label == -1 && !rooms ? "inner" : "room " + std::to_string(-label);
}
std::span<const LayerName> layer_names() {
  return layers;
}

std::string short_number(double value) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
  const double size = std::abs(value);
  if (size >= 10000 && size < 1e12)
    return (value < 0 ? "−" : "") + grouped(static_cast<std::size_t>(std::llround(size)));
  if (size == 0 || (size >= 1e-4 && size < 1e12))
    return fixed(value, size >= 1000 ? 0 : size >= 100 ? 1 : size >= 10 ? 2 : size >= 1 ? 3 : 4);
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2e", value);
  return text.data();
}

std::string number_beside(double value, double limit) {
  constexpr double nothing = 1e-9; // of the limit: what arithmetic leaves of a zero
  if (std::abs(value) < nothing * std::abs(limit)) value = 0;
  std::string text = short_number(value);
  if (value == limit || !std::isfinite(value) || !std::isfinite(limit)) return text;
  // "1.0000" is "1.000", and reads as the limit.
  const auto reads_alike = [&](const std::string& number, const std::string& other) {
    return number == other || (number.find(',') == std::string::npos && std::stod(number) == limit);
  };
  constexpr int most = 16;
  std::string beside = short_number(limit);
  for (int digits = 4; digits < most && reads_alike(text, beside); ++digits) {
    text = fixed(value, digits);
    beside = fixed(limit, digits);
  }
  return text;
}

std::string bytes_text(std::size_t bytes) {
  constexpr std::array<const char*, 4> units{"B", "kB", "MB", "GB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 1000 && unit + 1 < units.size()) {
    value /= 1000;
    ++unit;
  }
  return fixed(value, value < 10 && unit > 0 ? 1 : 0) + " " + units[unit];
}

} // namespace isoscope
