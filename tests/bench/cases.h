// What is measured: models with tolerances, and what is expected of them.
#pragma once

#include "base/status.h"
#include "input/triangle_soup.h"
#include "run/parameters.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace isoscope::bench {

/// One line of the table.
struct Case {
  std::string model;
  Tolerance tolerance;
  std::function<Result<TriangleSoup>()> load;
  std::optional<std::size_t> at_most; ///< vertices that must be reached
  std::optional<std::size_t> goal;    ///< vertices aimed at
  std::optional<double> optimum;      ///< of the smooth surface, asymptotically
  bool of_all = false;                ///< one of all that can be compared; left out where it cannot
};

enum class Selection {
  quick,    ///< a few that take seconds
  standard, ///< those with targets, but for the longest
  complete  ///< all with targets
};
/// The models that have targets. Those whose file is not installed are left out, with a line that says so.
std::vector<Case> target_cases(Selection selection);
/// One model, a file or gallery:NAME, at each tolerance.
std::vector<Case> model_cases(const std::string& model, const std::vector<Tolerance>& tolerances);
/// A model of libcgal-demo by its file's name; none where it is not installed.
std::vector<Case> installed_cases(const std::string& file, const Tolerance& tolerance);
/// The spheres, with targets.
std::vector<Case> sphere_cases();
/// Every mesh file of libcgal-demo at each tolerance; which of them are closed shows when they are loaded.
std::vector<Case> demo_cases(const std::vector<Tolerance>& tolerances);
/// Those with an edge of one triangle alone once equal points are merged, the smallest files first.
std::vector<Case> open_demo_cases(const std::vector<Tolerance>& tolerances);
/// Those without, in the same order.
std::vector<Case> closed_demo_cases(const std::vector<Tolerance>& tolerances);

/// A subdivided icosahedron on the unit sphere: 10 · 4^levels + 2 vertices.
TriangleSoup icosphere(unsigned levels);
/// Vertices of the coarsest triangulation of a sphere of radius r within ±δ, asymptotically: 2 + 1.209 r/δ.
double sphere_optimum(double radius, double delta);

} // namespace isoscope::bench
