// The largest ball as a linear program: its dual has four rows, so a simplex method over the half-spaces
// keeps a basis of four of them and ends with the witness at hand.
#include "criteria/kernel.h"

#include "mesh/predicates.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace isoscope {

namespace {

using Vec4 = std::array<double, 4>;
using Matrix4 = std::array<Vec4, 4>;

/// LU decomposition with row pivoting of the matrix whose columns are the basis.
class Factor {
 public:
  explicit Factor(Matrix4 rows) : m_(rows) {
    for (std::size_t k = 0; k < 4; ++k) {
      std::size_t pivot = k;
      for (std::size_t i = k + 1; i < 4; ++i) {
        if (std::abs(m_[i][k]) > std::abs(m_[pivot][k])) pivot = i;
      }
      std::swap(m_[k], m_[pivot]);
      std::swap(order_[k], order_[pivot]);
      regular_ = regular_ && std::abs(m_[k][k]) > 1e-13;
      if (!regular_) return;
      for (std::size_t i = k + 1; i < 4; ++i) {
        m_[i][k] /= m_[k][k];
        for (std::size_t j = k + 1; j < 4; ++j) m_[i][j] -= m_[i][k] * m_[k][j];
      }
    }
  }
  bool regular() const { return regular_; }
  /// B x = r
  Vec4 solve(const Vec4& r) const {
    Vec4 x{};
    for (std::size_t i = 0; i < 4; ++i) {
      x[i] = r[order_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= m_[i][j] * x[j];
    }
    for (std::size_t i = 4; i-- > 0;) {
      for (std::size_t j = i + 1; j < 4; ++j) x[i] -= m_[i][j] * x[j];
      x[i] /= m_[i][i];
    }
    return x;
  }
  /// Bᵀ y = r
  Vec4 solve_transposed(const Vec4& r) const {
    Vec4 z{}, y{};
    for (std::size_t i = 0; i < 4; ++i) {
      z[i] = r[i];
      for (std::size_t j = 0; j < i; ++j) z[i] -= m_[j][i] * z[j];
      z[i] /= m_[i][i];
    }
    for (std::size_t i = 4; i-- > 0;) {
      for (std::size_t j = i + 1; j < 4; ++j) z[i] -= m_[j][i] * z[j];
    }
    for (std::size_t i = 0; i < 4; ++i) y[order_[i]] = z[i];
    return y;
  }

 private:
  Matrix4 m_;
  std::array<std::size_t, 4> order_{0, 1, 2, 3};
  bool regular_ = true;
};

/// max r over n_i·x − r >= o_i, in coordinates where everything that matters is in the unit ball. Dual: λ >=
/// 0 with Σ λ_i (n_i, 1) = (0, 0, 0, 1). The first four half-spaces are a tetrahedron about the unit ball:
/// they make the first basis, whatever the others are.
class BallProgram {
 public:
  explicit BallProgram(std::size_t n) { h_.reserve(n + 4); }
  void add(HalfSpace h) { h_.push_back(h); }
  void solve();
  Vec3 center() const { return {y_[0], y_[1], y_[2]}; }
  const std::array<std::size_t, 4>& basis() const { return basis_; }
  const Vec4& weights() const { return lambda_; }
  bool bounded_by_frame() const {
    for (std::size_t k = 0; k < 4; ++k) {
      if (basis_[k] < 4 && lambda_[k] > tolerance) return true;
    }
    return false;
  }
  /// Moves the frame out to `distance`; the basis stays feasible.
  void set_frame(double distance) {
    for (std::size_t i = 0; i < 4; ++i) h_[i].offset = -distance;
  }

 private:
  static constexpr double tolerance = 1e-13;
  static constexpr int steps_by_violation = 60; ///< then by the first index, which cannot cycle
  static constexpr int most_steps = 1000;

  Vec4 column(std::size_t i) const { return {h_[i].normal.x, h_[i].normal.y, h_[i].normal.z, 1}; }
  double violation(std::size_t i) const { return h_[i].offset - dot(h_[i].normal, center()) - y_[3]; }
  std::optional<std::size_t> entering(bool by_violation) const;
  std::optional<std::size_t> leaving(const Vec4& direction, bool by_violation) const;

  std::vector<HalfSpace> h_;
  std::array<std::size_t, 4> basis_{0, 1, 2, 3};
  Vec4 lambda_{0.25, 0.25, 0.25, 0.25};
  Vec4 y_{}; ///< x and −r
};

std::optional<std::size_t> BallProgram::entering(bool by_violation) const {
  std::optional<std::size_t> best;
  double worst = tolerance * (1 + std::abs(y_[3]) + length(center()));
  for (std::size_t i = 0; i < h_.size(); ++i) {
    const double v = violation(i);
    if (v <= worst || std::find(basis_.begin(), basis_.end(), i) != basis_.end()) continue;
    if (!by_violation) return i;
    worst = v;
    best = i;
  }
  return best;
}

std::optional<std::size_t> BallProgram::leaving(const Vec4& direction, bool by_violation) const {
  std::optional<std::size_t> best;
  double least = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (direction[k] <= 1e-11) continue;
    const double ratio = std::max(lambda_[k], 0.0) / direction[k];
    bool better = !best || ratio < least - tolerance;
    if (best && !better && ratio <= least + tolerance) {
      better = by_violation ? direction[k] > direction[*best] : basis_[k] < basis_[*best];
    }
    if (better) {
      best = k;
      least = ratio;
    }
  }
  return best;
}

void BallProgram::solve() {
  for (int step = 0; step < most_steps; ++step) {
    Matrix4 rows{};
    Vec4 offsets{};
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec4 c = column(basis_[k]);
      for (std::size_t i = 0; i < 4; ++i) rows[i][k] = c[i];
      offsets[k] = h_[basis_[k]].offset;
    }
    const Factor factor(rows);
    if (!factor.regular()) return;
    y_ = factor.solve_transposed(offsets);
    lambda_ = factor.solve({0, 0, 0, 1});
    const bool by_violation = step < steps_by_violation;
    const auto in = entering(by_violation);
    if (!in) return;
    const auto out = leaving(factor.solve(column(*in)), by_violation);
    if (!out) return;
    basis_[*out] = *in;
  }
}

} // namespace

InscribedBall inscribed_ball(std::span<const HalfSpace> half_spaces, Vec3 origin, double size) {
  const double s = 1 / std::sqrt(3.0);
  BallProgram program(half_spaces.size());
  for (const Vec3 n : {Vec3{s, s, s}, Vec3{s, -s, -s}, Vec3{-s, s, -s}, Vec3{-s, -s, s}}) program.add({n, 0});
  for (const HalfSpace& h : half_spaces) program.add({h.normal, -h.slack(origin) / size});
  // Half-spaces that nearly meet can miss each other least far away: the frame then gives way to them.
  for (const double distance : {4.0, 4e3, 4e6}) {
    program.set_frame(distance);
    program.solve();
    if (!program.bounded_by_frame()) break;
  }
  InscribedBall ball;
  ball.center = origin + size * program.center();
  ball.radius = Box3::inf;
  for (const HalfSpace& h : half_spaces) {
    ball.radius = std::min(ball.radius, h.slack(origin) + size * dot(h.normal, program.center()));
  }
  for (std::size_t k = 0; k < 4; ++k) {
    if (program.basis()[k] >= 4 && program.weights()[k] > 0)
      ball.tight.push_back(static_cast<std::uint32_t>(program.basis()[k] - 4));
  }
  std::sort(ball.tight.begin(), ball.tight.end());
  return ball;
}

bool Kernel::contains(Vec3 x) const {
  return std::all_of(facets.begin(), facets.end(),
                     [x](const Triangle3& f) { return orientation(f[0], f[1], f[2], x) > 0; });
}

void Kernel::add(const Triangle3& f) {
  const Vec3 n = normalized(cross(f[1] - f[0], f[2] - f[0]));
  facets.push_back(f);
  half_spaces.push_back({n, dot(n, f[0])});
}

Kernel compute_kernel(const EdgeStar& star) {
  Kernel kernel;
  const Vec3 origin = 0.5 * (star.vertices[0].position + star.vertices[1].position);
  double size = 0;
  for (const EdgeStar::StarTet& t : star.tets) {
    if (t.ring()) continue;
    const auto end = static_cast<std::size_t>(
        std::find_if(t.v.begin(), t.v.end(), [](auto v) { return v < 2; }) - t.v.begin());
    const auto& outward = outward_facets[end];
    const std::array<Vec3, 4> p = star.positions(t);
    const Triangle3 f{p[outward[0]], p[outward[2]], p[outward[1]]};
    kernel.add(f);
    for (const Vec3 corner : f) size = std::max(size, distance(corner, origin));
  }
  const auto flat = std::find_if(kernel.half_spaces.begin(), kernel.half_spaces.end(),
                                 [](const HalfSpace& h) { return h.normal == Vec3{}; });
  if (flat != kernel.half_spaces.end() || !(size > 0)) {
    kernel.empty = true;
    kernel.center = origin;
    if (flat != kernel.half_spaces.end())
      kernel.witness = {static_cast<std::uint32_t>(flat - kernel.half_spaces.begin())};
    return kernel;
  }
  // Offsets about the edge's middle: those from the origin have lost digits where the star is far from it.
  std::vector<HalfSpace> near = kernel.half_spaces;
  for (std::size_t i = 0; i < near.size(); ++i)
    near[i].offset = dot(near[i].normal, kernel.facets[i][0] - origin);
  InscribedBall ball = inscribed_ball(near, {}, size);
  kernel.center = origin + ball.center;
  kernel.empty = ball.radius <= 1e-12 * size || !kernel.contains(kernel.center);
  kernel.inscribed_radius = kernel.empty ? std::min(ball.radius, 0.0) : ball.radius;
  if (kernel.empty) {
    kernel.witness = std::move(ball.tight);
    kernel.missing_slack = -kernel.inscribed_radius;
  }
  return kernel;
}

} // namespace isoscope
