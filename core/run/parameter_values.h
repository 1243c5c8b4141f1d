// Parameters that are more than a number or a word: each has a text, and reads it.
#pragma once

#include "base/fields.h"
#include "base/status.h"
#include "simplify/hole_filling.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace isoscope {

/// δ as given: a percentage of the longest edge of the input's bounding box, or an absolute length, or left
/// to the run.
struct Tolerance {
  double value = 0.6;
  bool percent = true;
  bool automatic = false; ///< found from the input; the value does not count
  /// Not of an automatic one.
  double absolute(double longest_edge) const { return percent ? value / 100.0 * longest_edge : value; }
  std::string text() const; ///< "0.6%", "0.012" or "auto"
  /// Reads that; nothing where the text is no positive finite number.
  static std::optional<Tolerance> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

constexpr auto fields_of(const Tolerance*) {
  return std::tuple{field(&Tolerance::value, {.name = "", .help = ""}),
                    field(&Tolerance::percent, {.name = "percent", .help = ""}),
                    field(&Tolerance::automatic, {.name = "auto", .help = ""})};
}

/// How many neighbours make a point robust: the k of the witnessed k-distance.
struct Robust {
  static constexpr int automatic = 0, off = 1;
  int neighbors = automatic;
  std::string text() const; ///< "12", "auto" or "off"
  static std::optional<Robust> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  friend bool operator==(const Robust&, const Robust&) = default;
};

constexpr auto fields_of(const Robust*) {
  return std::tuple{field(&Robust::neighbors, {.name = "", .help = ""})};
}

/// γ of the ball test (§4.1), and whether points that enclose nothing are taken for an open surface by it.
struct BallTestFactor {
  static constexpr double automatic = 0, off = -1;
  static constexpr std::array<double, 3> usual{2, 1.6, 1.3}; ///< what automatic tries, in this order
  double gamma = automatic;
  std::string text() const; ///< "2", "auto" or "off"
  static std::optional<BallTestFactor> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  friend bool operator==(const BallTestFactor&, const BallTestFactor&) = default;
};

constexpr auto fields_of(const BallTestFactor*) {
  return std::tuple{field(&BallTestFactor::gamma, {.name = "", .help = ""})};
}

/// The values of a grid between which Ω lies; both 0: not given.
struct Levels {
  double low = 0, high = 0;
  bool given() const { return low != high; }
  std::string text() const; ///< "0.8 1.2", or "none"
  /// Reads that; nothing where the text is no two finite numbers, the smaller first.
  static std::optional<Levels> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  friend bool operator==(const Levels&, const Levels&) = default;
};

constexpr auto fields_of(const Levels*) {
  return std::tuple{field(&Levels::low, {.name = "low", .help = ""}),
                    field(&Levels::high, {.name = "high", .help = ""})};
}

/// Which holes of an open surface are filled.
struct Fill {
  std::string holes = "none"; ///< "none", "all", "flat", or numbers of loops from 1 on: "1,3"
  const std::string& text() const { return holes; }
  static std::optional<Fill> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  HoleChoice choice() const;
  friend bool operator==(const Fill&, const Fill&) = default;
};

constexpr auto fields_of(const Fill*) {
  return std::tuple{field(&Fill::holes, {.name = "", .help = ""})};
}

} // namespace isoscope
