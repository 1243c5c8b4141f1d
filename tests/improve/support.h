// Start surfaces with their Ω for the tests of the improver.
#pragma once

#include "base/run_control.h"
#include "improve/improver.h"
#include "tolerance/tolerance_volume.h"

#include <memory>
#include <vector>

namespace isoscope::testing {

/// An input, its Ω, and the input itself as the surface to start from: it lies in Ω.
struct Start {
  TriangleSoup soup;
  TriangleMesh mesh;
  std::unique_ptr<ToleranceVolume> volume;

  /// `soup` must be a closed oriented 2-manifold without intersections.
  Start(const TriangleSoup& input, double percent);
  /// The same Ω for an input whose triangles are turned around where `turned(i)` says so.
  template <class Turned> static Start with_turned(const TriangleSoup& input, double percent, Turned turned) {
    TriangleSoup other = input;
    for (std::size_t i = 0; i < other.triangles.size(); ++i)
      if (turned(i)) std::swap(other.triangles[i][0], other.triangles[i][1]);
    Start start(other, percent);
    start.mesh.triangles = input.triangles;
    return start;
  }
  double delta() const { return volume->thresholds().delta; }
};

/// A start with the rules that its surface has to keep; `rules` points into it.
struct Bench {
  Start start;
  InputSurface input;
  SurfaceRules rules;

  Bench(const TriangleSoup& soup, double percent)
      : start(soup, percent), input(start.volume->index(), start.delta(), start.mesh) {
    rules.input = &input;
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
};

/// The defaults but for the effort.
ImproverOptions with_effort(int effort);

/// Keeps everything it hears; may stop the improver or cancel the control after a number of calls.
class Listener : public ImproverObserver {
 public:
  bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) override;
  bool rejected(const ImproverVerdict& verdict) override;

  std::vector<SurfaceChange> changes;
  std::vector<ImproverVerdict> verdicts, rejections;
  std::size_t stop_after = 0;   ///< commits; 0 never
  std::size_t cancel_after = 0; ///< calls; 0 never
  RunControl* control = nullptr;

 private:
  void count();
  std::size_t calls_ = 0;
};

/// Closed oriented 2-manifold, intersection free, proven inside Ω, separating, with this χ.
void check_valid(const TriangleMesh& mesh, const Start& start, long euler_characteristic);

/// A regular octahedron of radius r with outward facets: vertices ±x, ±y, ±z.
TriangleSoup octahedron(double r);
/// A sphere of radius 1 around the origin, of n segments.
TriangleSoup sphere(unsigned n);

} // namespace isoscope::testing
