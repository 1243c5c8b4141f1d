// The tables of models, tolerances and targets.
#include "bench/cases.h"

#include "input/mesh_io.h"
#include "run/run_input.h"
#include "support/models.h"
#include "tolerance/welded_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

namespace isoscope::bench {

namespace {

constexpr unsigned sphere_levels = 6;

/// A model of libcgal-demo with targets. Where they are a share of what Lindstrom–Turk reaches, the numbers
/// are that share rounded down.
struct Target {
  const char* model;
  double percent;
  std::size_t at_most, goal;
  Selection from; ///< the smallest selection it is in
};
constexpr std::array targets{
    Target{"elephant.off", 0.5, 320, 260, Selection::standard},
    Target{"elephant.off", 1, 160, 130, Selection::quick},
    Target{"elephant.off", 2, 80, 65, Selection::quick},
    Target{"turbine.off", 0.6, 255, 215, Selection::standard},
    Target{"fandisk.off", 0.6, 80, 70, Selection::quick},
    Target{"armadillo.off", 0.9, 290, 230, Selection::standard},
    Target{"armadillo.off", 0.1, 6500, 4800, Selection::complete},
    Target{"rotor.off", 0.6, 144, 108, Selection::standard},
    Target{"knot1.off", 0.6, 367, 275, Selection::standard},
    Target{"anchor.off", 0.6, 104, 78, Selection::standard},
    Target{"joint.off", 0.6, 64, 48, Selection::quick},
};
/// Tolerances of the sphere as a share of its radius.
constexpr std::array sphere_deltas{0.01, 0.02, 0.04};

std::size_t rounded_down(double x) {
  return static_cast<std::size_t>(std::floor(x));
}

Case file_case(const std::string& name, const std::string& file, const Tolerance& tolerance) {
  RunParameters parameters;
  parameters.input = file;
  return {name, tolerance, [parameters] { return load_input(parameters); }, {}, {}, {}};
}

/// The mesh files that are open, or those that are not, the smallest first.
std::vector<Case> demo_cases_with_border(bool open, const std::vector<Tolerance>& tolerances) {
  std::vector<std::filesystem::path> files = demo_models();
  std::stable_sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return std::filesystem::file_size(a) < std::filesystem::file_size(b);
  });
  std::vector<Case> cases;
  for (const std::filesystem::path& file : files) {
    const auto soup = read_mesh(file.string());
    if (!soup || soup->triangles.empty() || border_uses(weld(*soup).triangles).empty() == open) continue;
    for (Case& c : model_cases(file.string(), tolerances)) cases.push_back(std::move(c));
  }
  return cases;
}

} // namespace

TriangleSoup icosphere(unsigned levels) {
  TriangleSoup soup;
  soup.name = "sphere";
  const double golden = 0.5 * (1 + std::sqrt(5.0));
  for (const double a : {-1.0, 1.0})
    for (const double b : {-golden, golden}) {
      soup.points.push_back(normalized({0, a, b}));
      soup.points.push_back(normalized({a, b, 0}));
      soup.points.push_back(normalized({b, 0, a}));
    }
  // The faces are the triples of mutually nearest corners.
  const auto near = [&](std::uint32_t i, std::uint32_t j) {
    return distance(soup.points[i], soup.points[j]) < 1.1;
  };
  for (std::uint32_t i = 0; i < 12; ++i)
    for (std::uint32_t j = i + 1; j < 12; ++j)
      for (std::uint32_t k = j + 1; k < 12; ++k) {
        if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
        const Vec3 &a = soup.points[i], &b = soup.points[j], &c = soup.points[k];
        if (dot(cross(b - a, c - a), a) > 0) {
          soup.triangles.push_back({i, j, k});
        } else {
          soup.triangles.push_back({i, k, j});
        }
      }
  for (unsigned level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(soup.points.size()));
      if (is_new) soup.points.push_back(normalized(soup.points[a] + soup.points[b]));
      return at->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    finer.reserve(4 * soup.triangles.size());
    for (const auto& [a, b, c] : soup.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    soup.triangles = std::move(finer);
  }
  return soup;
}

double sphere_optimum(double radius, double delta) {
  return 2 + 1.209 * radius / delta;
}

std::vector<Case> installed_cases(const std::string& file, const Tolerance& tolerance) {
  const auto path = demo_model(file);
  if (!path) return {};
  return {file_case(path->stem().string(), path->string(), tolerance)};
}

std::vector<Case> sphere_cases() {
  std::vector<Case> cases;
  for (const double delta : sphere_deltas) {
    Case c{"sphere", {delta, false}, [] { return icosphere(sphere_levels); }, {}, {}, {}};
    c.optimum = sphere_optimum(1, delta);
    c.at_most = rounded_down(1.5 * *c.optimum);
    c.goal = rounded_down(1.15 * *c.optimum);
    cases.push_back(std::move(c));
  }
  return cases;
}

std::vector<Case> target_cases(Selection selection) {
  std::vector<Case> cases;
  for (const Target& target : targets) {
    if (target.from > selection) continue;
    const auto file = demo_model(target.model);
    if (!file) continue;
    Case c = file_case(file->stem().string(), file->string(), {target.percent, true});
    c.at_most = target.at_most;
    c.goal = target.goal;
    cases.push_back(std::move(c));
  }
  for (Case& c : sphere_cases())
    if (selection != Selection::quick || c.tolerance.value >= sphere_deltas.back())
      cases.push_back(std::move(c));
  return cases;
}

std::vector<Case> model_cases(const std::string& model, const std::vector<Tolerance>& tolerances) {
  const std::string name = std::filesystem::path(model).stem().string();
  std::vector<Case> cases;
  for (const Tolerance& tolerance : tolerances) cases.push_back(file_case(name, model, tolerance));
  return cases;
}

std::vector<Case> demo_cases(const std::vector<Tolerance>& tolerances) {
  std::vector<Case> cases;
  for (const std::filesystem::path& file : demo_models()) {
    for (Case& c : model_cases(file.string(), tolerances)) cases.push_back(std::move(c));
  }
  return cases;
}

std::vector<Case> open_demo_cases(const std::vector<Tolerance>& tolerances) {
  return demo_cases_with_border(true, tolerances);
}

std::vector<Case> closed_demo_cases(const std::vector<Tolerance>& tolerances) {
  return demo_cases_with_border(false, tolerances);
}

} // namespace isoscope::bench
