// Everything that must hold at a step, judged from scratch, and the first step at which it did not.
#pragma once

#include "questions/snapshot.h"
#include "run/certificate.h"
#include "run/pipeline.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace isoscope {

/// What is checked.
enum class Invariant : std::uint8_t {
  tetrahedra,     ///< positively oriented, neighbours agree, one shell
  delaunay,       ///< locally Delaunay while the refinement lasts (§2.3)
  samples,        ///< each sample in exactly one tetrahedron, the one that is recorded
  classification, ///< ε of every sample as shown
  closed,         ///< Z is a closed 2-manifold
  oriented,       ///< its facets agree on the sides
  embedded,       ///< it does not intersect itself
  contained,      ///< every facet is proven inside Ω
  separating,     ///< the regions' witnesses lie on their sides
  topology        ///< components and χ as expected
};
constexpr std::size_t invariant_count = 10;
std::string_view name(Invariant invariant);

struct InvariantVerdict {
  enum class State : std::uint8_t {
    holds,
    broken,
    not_due, ///< a goal of the refinement, which still goes on
    absent   ///< there is nothing to ask it of: T is gone, Z is not there yet
  };
  State state = State::absent;
  std::string words;         ///< where broken or not due: what was found
  std::optional<Vec3> place; ///< where, if it has a place
};

struct StateReport {
  Step step = 0;
  std::array<InvariantVerdict, invariant_count> verdicts;
  const InvariantVerdict& operator[](Invariant i) const { return verdicts[static_cast<std::size_t>(i)]; }
  std::size_t broken() const;
  bool valid() const { return broken() == 0; }
};

/// Judges a state. `scene` may be null: what needs Ω is absent then. A cancelled report is not complete.
StateReport check_state(const Journal& journal, const StateSnapshot& state, const Scene* scene,
                        const RunControl& control);

/// The search for the first step that is not valid, by bisection: as long as what is broken stays broken, the
/// step is the first; otherwise it is one at which something broke.
struct FirstInvalid {
  enum class End : std::uint8_t { found, all_valid, cancelled };
  End end = End::all_valid;
  StateReport report;     ///< of the step found, or of the last one looked at
  std::size_t probes = 0; ///< states judged
};
/// Looks in [0, last]; valid at `last` ends it, since bisection needs a broken end. Reports progress.
FirstInvalid find_first_invalid(std::shared_ptr<const Journal> journal, Step last, const Scene* scene,
                                const RunControl& control);

} // namespace isoscope
