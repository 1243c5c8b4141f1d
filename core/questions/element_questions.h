// What a person asks of one tetrahedron or sample (§2.3): why it is misoriented or too flat, what would be
// inserted for it, and which values of the parameters would change the verdict.
#pragma once

#include "criteria/height.h"
#include "criteria/orientation.h"
#include "questions/snapshot.h"

#include <array>
#include <optional>
#include <vector>

namespace isoscope {

/// A tetrahedron under conditions 2 and 3.
struct TetInspection {
  Height height;
  std::array<Vec3, 2> gap; ///< the ends of the height: on the first and on the second supporting primitive
  double shrink = 0;       ///< factor of the copy
  std::array<Vec3, 4> shrunk;
  std::optional<OrientationVerdict> orientation; ///< absent without samples
  SampleId candidate;               ///< the sample nearest to the circumcentre, if inside the ball
  bool candidate_is_vertex = false; ///< it is in T already: nothing is left to insert
};
/// `shrink` in (0, 1]. Nothing where t is dead or does not carry Z, or Z is embedded.
std::optional<TetInspection> inspect_tet(const StateSnapshot& state, TetId t, double shrink,
                                         const NearestSample* nearest);

/// The tetrahedra that violate condition 3, ascending by slot; judged only where the state says so.
std::vector<TetId> misoriented_tets(const StateSnapshot& state);
/// The tetrahedra that carry Z below `limit`, the flattest first.
struct FlatTet {
  TetId tet;
  double height = 0; ///< absolute
};
std::vector<FlatTet> flat_tets(const StateSnapshot& state, double limit);

/// Who mends a sample (condition 1): each tetrahedron offers the worst of its samples, and the worst of these
/// goes in next.
struct SampleInspection {
  enum class Remedy : std::uint8_t {
    none_needed,   ///< ε is within its limit
    not_asked,     ///< condition 1 is off, or Z is embedded: only the class counts
    itself_next,   ///< it goes in next
    itself_later,  ///< it is the worst of its tetrahedron, but other tetrahedra come first
    worse_in_tet,  ///< a worse sample of its tetrahedron goes in before it
    vertex_already ///< it is a vertex of T: inserting it changes nothing
  };
  TetId tet;
  double f = 0, error = 0;
  bool bad = false, within_margin = true;
  Remedy remedy = Remedy::none_needed;
  SampleId fixer;               ///< the sample whose insertion is the first to touch its tetrahedron
  std::size_t tets_before = 0;  ///< tetrahedra whose worst sample is worse
  std::size_t worse_in_tet = 0; ///< samples of its tetrahedron that are worse
};
/// Nothing where the sample is not classified, as before T is there.
std::optional<SampleInspection> inspect_sample(const StateSnapshot& state, SampleId sample);

/// A parameter that a verdict depends on, and where the verdict changes.
struct ParameterAdvice {
  enum class Parameter : std::uint8_t { alpha, sigma, shrink };
  Parameter parameter = Parameter::alpha;
  Condition condition = Condition::none;
  double now = 0;
  bool holds = false;          ///< with the value now
  std::optional<double> works; ///< where it does not hold: the nearest value with which it does
  bool at_least = false;       ///< that value and above; else that value and below
};
/// Conditions 1, 2 and 3 of a tetrahedron. σ is absolute.
std::vector<ParameterAdvice> advise_tet(const StateSnapshot& state, TetId t, const NearestSample* nearest);
/// Condition 1 of a sample; nothing where it is not classified.
std::vector<ParameterAdvice> advise_sample(const StateSnapshot& state, SampleId sample);

} // namespace isoscope
