// Everything a run is asked, with the paper's symbols; what is said of each field is in
// run/parameter_fields.h.
#pragma once

#include "base/status.h"
#include "criteria/topology.h"
#include "journal/journal.h"
#include "simplify/simplification.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace isoscope {

struct FieldFacts;

/// How containment of Z in Ω is ensured (core/README.md, N2).
enum class Containment : std::uint8_t {
  certified, ///< coarse S, facet certificate (default)
  sampled    ///< the paper to the letter: dense S, α margin, condition 2
};

/// δ as given: a percentage of the longest edge of the input's bounding box, or an absolute length.
struct Tolerance {
  double value = 0.6;
  bool percent = true;
  double absolute(double longest_edge) const { return percent ? value / 100.0 * longest_edge : value; }
  std::string text() const; ///< "0.6%" or "0.012"
  /// Reads that; nothing where the text is no positive finite number.
  static std::optional<Tolerance> read(std::string_view text);
  Status check(const FieldFacts& field, const std::string& asked) const;
  friend bool operator==(const Tolerance&, const Tolerance&) = default;
};

struct RunParameters {
  std::string input;   ///< a file, or gallery:NAME
  Tolerance tolerance; ///< δ > 0
  double sigma = 0;    ///< σ/δ in (0, 1]; 0: 1/8 in sampled mode, default_sigma_ratio() in certified mode
  double alpha = 0.2;  ///< α in (0, 1)
  double shrink = 0.7; ///< in (0, 1]
  Containment containment = Containment::certified;
  TopologyMode topology = TopologyMode::keep;
  /// Whether parts that are thinner than 2δ everywhere are left out of the input instead of refused.
  bool drop_thin = false;
  /// How far from the result a point of the input may be, in δ, > 0; absent: as far as it likes, as in the
  /// paper, whose bound is one-sided.
  std::optional<double> cover = 3;
  SidesMode sides = SidesMode::automatic;                 ///< what tells inside from outside
  std::array<bool, 4> conditions{true, true, true, true}; ///< 1 to 4 of §2.3
  std::array<bool, stage_count> skipped{}; ///< stages to leave out: gamma, zero_set, all or improve
  TargetStrategy target = TargetStrategy::constraints; ///< how targets of general collapses are looked for
  CostRing cost_ring = CostRing::one;                  ///< facets of Z whose planes make the error (§2.4)
  int effort = 2;                                      ///< of the improver, 0 to 3
  ImproverPlace improver = ImproverPlace::free;        ///< on Z alone or inside T
  /// Components of the input whose box has a longest edge below so many δ are left out; 0: none.
  double drop_small = 0;
  unsigned threads = 0;    ///< 0: all cores
  double time_limit = 0;   ///< seconds, 0 none
  double memory_limit = 0; ///< MiB that Ω and S may take, as far as foreseen; 0: two thirds of what there is
  /// The last stage; absent: improve in certified mode, all in sampled mode, where the paper ends.
  std::optional<Stage> until;

  double most_bytes() const; ///< the memory limit in bytes; infinite where nothing is known
  /// `by_default`: what certified mode takes when nothing is given (Scene::default_sigma).
  double sigma_ratio(double by_default = 0.5) const {
    return sigma > 0 ? sigma : (containment == Containment::certified ? by_default : 0.125);
  }
  Stage last_stage() const {
    return until.value_or(containment == Containment::certified ? Stage::improve : Stage::all);
  }
  CriteriaParameters criteria(double delta, double default_sigma = 0.5) const;
  SimplificationParameters simplification() const;
  friend bool operator==(const RunParameters&, const RunParameters&) = default;
};

/// Checks every range; the error names the option, the value and the range.
Status check(const RunParameters& parameters);

} // namespace isoscope
