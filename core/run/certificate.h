// The proof of a finished mesh (core/README.md, D7): each figure is proven, not sampled.
#pragma once

#include "base/run_control.h"
#include "criteria/topology.h"
#include "input/triangle_soup.h"
#include "run/border_certificate.h"
#include "run/coverage.h"
#include "run/reverse_distance.h"
#include "run/room_certificate.h"
#include "tolerance/tolerance_volume.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// What is asked of the distance of the input to the mesh.
struct CoverTest {
  std::optional<double> limit = 3; ///< in δ, > 0; absent: told, not judged
  /// Whether what is thinner than 2δ may be closed over or cut: told where the limit is exceeded, not judged.
  bool thin_may_go = false;
  /// Measuring takes longest; without it covers holds.
  bool measure = true;
};

struct Certificate {
  /// What became of the topology.
  enum class Topology : std::uint8_t {
    as_expected, ///< components and χ are what a surface inside Ω is known to have
    wrong,       ///< they are not
    missed,      ///< they are not what was aimed at where nothing is known to have it: Ω is no thickening
    not_asked    ///< nothing is aimed at
  };
  bool closed_manifold = false; ///< without border; of rooms: the boundary of each region is
  bool manifold = false;        ///< the same, or with a border where the input is an open surface
  bool oriented = false;
  std::vector<RegionCertificate> regions; ///< of rooms: each region's boundary; else empty
  bool intersection_free = false;         ///< exact predicates
  bool within_tolerance = false;          ///< every facet proven inside Ω, rounded outward
  double max_distance =
      0; ///< proven upper bound of d over the mesh, absolute; of the failing facet when it fails
  DistanceBounds
      input_distance; ///< of the input without inner walls and closed gaps to the mesh, to 1 % of δ
  /// Every point of the input is proven to be within cover_limit δ of the mesh, or need not be.
  bool covers = false;
  std::optional<double> cover_limit;     ///< that it was judged by, in δ
  std::vector<UncoveredPlace> uncovered; ///< where it is exceeded, farthest first, at most ten
  std::size_t uncovered_count = 0;       ///< of all such places
  std::string cover_note;                ///< where it is exceeded and need not hold: why; else empty
  std::string gap_note; ///< where walls are left out of that, as Ω closes the gap before them; else empty
  /// The winding number at the witness of every region is that of its side, of rooms for every boundary;
  /// beside open surfaces segments from one side to the other cross the mesh an odd number of times.
  bool separates = false;
  std::size_t boundary_loops = 0;
  std::optional<BorderProof> border; ///< of open surfaces
  Topology topology = Topology::wrong;
  bool topology_as_expected() const {
    return topology == Topology::as_expected || topology == Topology::not_asked;
  }
  /// Where the topology is not what was aimed at and nothing binds it, or nothing was asked: that, in words.
  std::string topology_note;
  std::size_t components = 0;
  long euler_characteristic = 0;
  std::vector<std::string> failures; ///< one sentence each: which, where
  bool holds() const {
    return manifold && oriented && intersection_free && within_tolerance && covers && separates &&
           topology != Topology::wrong && (!border || border->holds());
  }
};

/// One word: "as expected", "wrong", "missed" or "not asked".
std::string_view name(Certificate::Topology topology);

/// When the control is cancelled, its grace bounds the time that this may take: what is not proven by then
/// does not hold, and a failure says that it was not found out. An abandoned control ends it at once.
Certificate certify(const TriangleMesh& mesh, const ToleranceVolume& volume, const ExpectedTopology& expected,
                    const RunControl& control, const CoverTest& cover = {}, const FilledHoles& holes = {});

} // namespace isoscope
