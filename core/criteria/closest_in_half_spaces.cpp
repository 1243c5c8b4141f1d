// A dual active-set method [Goldfarb and Idnani 1983] for the distance to a point: in three dimensions at
// most three half-spaces are active.
#include "criteria/closest_in_half_spaces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {

namespace {

constexpr double tolerance = 1e-12;
/// A normal whose part outside the span of the active ones is shorter counts as dependent on them.
constexpr double dependent = 1e-10;

/// The active half-spaces with their multipliers.
struct ActiveSet {
  std::array<std::size_t, 3> index{};
  std::array<Vec3, 3> normal{};
  std::array<double, 3> multiplier{};
  std::size_t n = 0;

  void remove(std::size_t k) {
    for (; k + 1 < n; ++k) {
      index[k] = index[k + 1];
      normal[k] = normal[k + 1];
      multiplier[k] = multiplier[k + 1];
    }
    --n;
  }
};

/// v = Σ weights_k normal_k + rest, the rest orthogonal to the normals.
struct Split {
  std::array<double, 3> weights{};
  Vec3 rest;
};

Split split(const ActiveSet& active, Vec3 v) {
  // normal_k = Σ_{i<=k} r[i][k] q_i, the q orthonormal; twice against cancellation.
  std::array<Vec3, 3> q{};
  std::array<std::array<double, 3>, 3> r{};
  const auto reduce = [&](Vec3& w, std::size_t count, auto&& coefficient) {
    for (int pass = 0; pass < 2; ++pass) {
      for (std::size_t i = 0; i < count; ++i) {
        const double c = dot(q[i], w);
        coefficient(i) += c;
        w = w - c * q[i];
      }
    }
  };
  for (std::size_t k = 0; k < active.n; ++k) {
    Vec3 w = active.normal[k];
    reduce(w, k, [&](std::size_t i) -> double& { return r[i][k]; });
    r[k][k] = length(w);
    q[k] = w / r[k][k];
  }
  Split s;
  s.rest = v;
  reduce(s.rest, active.n, [&](std::size_t i) -> double& { return s.weights[i]; });
  for (std::size_t k = active.n; k-- > 0;) {
    for (std::size_t j = k + 1; j < active.n; ++j) s.weights[k] -= r[k][j] * s.weights[j];
    s.weights[k] /= r[k][k];
  }
  if (active.n == 3) s.rest = {};
  return s;
}

/// Makes half-space h tight, dropping active ones whose multiplier would turn negative; false when it has no
/// point in common with them.
bool enforce(const HalfSpace& h, std::size_t index, ActiveSet& active, Vec3& y) {
  double multiplier = 0;
  for (;;) {
    const Split s = split(active, h.normal);
    const double rest = squared_length(s.rest), slack = h.slack(y);
    const double full = rest > dependent * dependent ? -slack / rest : Box3::inf;
    double step = full;
    std::size_t blocking = active.n;
    for (std::size_t k = 0; k < active.n; ++k) {
      if (s.weights[k] <= tolerance) continue;
      const double t = active.multiplier[k] / s.weights[k];
      if (t < step) {
        step = t;
        blocking = k;
      }
    }
    if (step == Box3::inf) return false;
    for (std::size_t k = 0; k < active.n; ++k)
      active.multiplier[k] = std::max(0.0, active.multiplier[k] - step * s.weights[k]);
    multiplier += step;
    if (full != Box3::inf) y += step * s.rest;
    if (blocking == active.n) break;
    active.remove(blocking);
  }
  active.index[active.n] = index;
  active.normal[active.n] = h.normal;
  active.multiplier[active.n] = multiplier;
  ++active.n;
  return true;
}

} // namespace

std::optional<Vec3> closest_in_half_spaces(std::span<const HalfSpace> half_spaces, Vec3 p) {
  Vec3 y = p;
  ActiveSet active;
  // Each round raises the distance to p, so that no set of active half-spaces comes back; the bound is for
  // rounding alone.
  for (std::size_t round = 0; round < 20 + 10 * half_spaces.size(); ++round) {
    std::size_t worst = half_spaces.size();
    double violation = 0;
    for (std::size_t i = 0; i < half_spaces.size(); ++i) {
      const HalfSpace& h = half_spaces[i];
      const double v = -h.slack(y) - tolerance * (1 + std::abs(h.offset));
      if (v <= violation) continue;
      if (std::find(active.index.begin(), active.index.begin() + static_cast<std::ptrdiff_t>(active.n), i) !=
          active.index.begin() + static_cast<std::ptrdiff_t>(active.n))
        continue;
      violation = v;
      worst = i;
    }
    if (worst == half_spaces.size()) return y;
    if (!enforce(half_spaces[worst], worst, active, y)) return std::nullopt;
  }
  return std::nullopt;
}

} // namespace isoscope
