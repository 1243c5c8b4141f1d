// Newton steps on p-norms of the linearised distances of a whole patch.
#include "improve/joint_relocation.h"

#include "improve/facet_energy.h"
#include "improve/integer_power.h"
#include "improve/symmetric_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

constexpr std::array<int, 6> joint_exponents{2, 4, 8, 14, 14, 14};
constexpr double joint_shift = 1e-3;      ///< of the trace of a vertex's part of the Hessian
constexpr double longest_step = 8;        ///< in δ
constexpr double shortest_step = 1e-3;    ///< in δ
constexpr double least_joint_gain = 0.98; ///< energy after a step over that before, for another one
constexpr std::uint32_t unmoved = 0xffffffffu;

/// The facets around the vertices that move, evaluated at many places.
class PatchEvaluator {
 public:
  PatchEvaluator(const InputSurface& input, const SurfacePatch& patch);

  bool empty() const { return moving_.empty(); }
  const std::vector<std::uint32_t>& moving() const { return moving_; }
  /// The energy of the facets with the patch's vertices at these points; infinite, and unfit for anything
  /// else, once it is known to be above `most`.
  double evaluate(const std::vector<Vec3>& points, double most);
  /// Takes what evaluate() just found for the place to go on from.
  void keep() {
    kept_ = samples_;
    kept_quality_ = quality_;
    seeds_ = found_;
  }
  /// By moving vertex: the step from there that minimises the maximum of the linearised distances.
  std::vector<Vec3> step(const std::vector<double>& trust);
  /// Writes what was kept to the facets.
  void store(FacetComplex& complex) const;

 private:
  /// d of a sample as a function of the displacements of up to three vertices.
  struct Sample {
    std::array<std::uint32_t, 3> mover{unmoved, unmoved, unmoved};
    std::array<double, 3> weight{};
    double distance = 0;
    Vec3 direction;
  };
  struct Edge {
    std::uint32_t a, b;
    std::array<std::uint32_t, 2> facets{Facet::none, Facet::none}; ///< into facets_
  };

  bool add(Sample sample, std::initializer_list<std::uint32_t> facets, const DistanceSample* of_input);
  void add_to_step(const Sample& s, const std::vector<Vec3>& x, double largest, int p);

  const InputSurface* input_;
  const FacetComplex* complex_;
  std::vector<std::uint32_t> moving_;                 ///< local vertices
  std::vector<std::uint32_t> mover_;                  ///< by local vertex: into moving_, or unmoved
  std::vector<std::uint32_t> facets_;                 ///< of the patch
  std::vector<std::uint32_t> corners_;                ///< local vertices of these
  std::vector<std::vector<std::uint32_t>> at_corner_; ///< by corner: into facets_
  std::vector<Edge> edges_;
  std::vector<TriangleId> seeds_, found_; ///< by facet
  std::vector<FacetSums> sums_;
  std::vector<double> counts_;
  std::vector<FacetQuality> quality_, kept_quality_;
  std::vector<Sample> samples_, kept_;
  SymmetricSystem system_{0};
  double energy_ = 0, most_ = 0;
};

PatchEvaluator::PatchEvaluator(const InputSurface& input, const SurfacePatch& patch)
    : input_(&input), complex_(&patch.complex), mover_(patch.complex.points.size(), unmoved) {
  for (std::uint32_t v = 0; v < mover_.size(); ++v) {
    if (!patch.free[v] || !complex_->alive_vertex(v) || complex_->on_border(v)) continue;
    mover_[v] = static_cast<std::uint32_t>(moving_.size());
    moving_.push_back(v);
  }
  std::vector<std::uint32_t> corner_number(mover_.size(), unmoved);
  std::vector<Edge> halves;
  for (std::uint32_t f = 0; f < complex_->facets.size(); ++f) {
    const Facet& facet = complex_->facets[f];
    if (!facet.alive() ||
        std::all_of(facet.v.begin(), facet.v.end(), [&](std::uint32_t v) { return mover_[v] == unmoved; }))
      continue;
    const auto number = static_cast<std::uint32_t>(facets_.size());
    facets_.push_back(f);
    seeds_.push_back(facet.seed);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = facet.v[k], w = facet.v[(k + 1) % 3];
      if (corner_number[v] == unmoved) {
        corner_number[v] = static_cast<std::uint32_t>(corners_.size());
        corners_.push_back(v);
        at_corner_.emplace_back();
      }
      at_corner_[corner_number[v]].push_back(number);
      halves.push_back({std::min(v, w), std::max(v, w), {number, Facet::none}});
    }
  }
  std::sort(halves.begin(), halves.end(), [](const Edge& x, const Edge& y) {
    return std::tuple(x.a, x.b, x.facets[0]) < std::tuple(y.a, y.b, y.facets[0]);
  });
  for (const Edge& half : halves) {
    if (!edges_.empty() && edges_.back().a == half.a && edges_.back().b == half.b)
      edges_.back().facets[1] = half.facets[0];
    else
      edges_.push_back(half);
  }
  system_ = SymmetricSystem(3 * moving_.size());
}

bool PatchEvaluator::add(Sample sample, std::initializer_list<std::uint32_t> facets,
                         const DistanceSample* of_input) {
  for (const std::uint32_t f : facets) {
    if (f == Facet::none) continue;
    const double own =
        of_input != nullptr ? sums_[f].add(*of_input, *input_) : sums_[f].add(sample.distance, *input_);
    energy_ += own / counts_[f];
  }
  samples_.push_back(sample);
  return energy_ <= most_;
}

double PatchEvaluator::evaluate(const std::vector<Vec3>& points, double most) {
  const double delta = input_->delta();
  samples_.clear();
  sums_.assign(facets_.size(), {});
  counts_.assign(facets_.size(), 3);
  found_ = seeds_;
  energy_ = 0;
  most_ = most;
  std::vector<int> steps(edges_.size()), longest(facets_.size(), 2);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    steps[e] = sampling_steps(distance(points[edges_[e].a], points[edges_[e].b]), delta);
    for (const std::uint32_t f : edges_[e].facets) {
      if (f == Facet::none) continue;
      longest[f] = std::max(longest[f], steps[e]);
      counts_[f] += steps[e] - 1;
    }
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = complex_->facets[facets_[f]];
    counts_[f] +=
        static_cast<double>(inner_samples(longest[f]).size() + facet.extra.size() + facet.sides.size());
  }
  constexpr double too_much = std::numeric_limits<double>::infinity();
  const auto sample = [&](Vec3 p, std::uint32_t facet) {
    const DistanceSample s = input_->sample(p, found_[facet]);
    found_[facet] = s.triangle;
    return s;
  };
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const std::uint32_t v = corners_[c];
    const DistanceSample s = sample(points[v], at_corner_[c].front());
    for (const std::uint32_t f : at_corner_[c]) energy_ += sums_[f].add(s, *input_) / counts_[f];
    samples_.push_back({{mover_[v], unmoved, unmoved}, {1, 0, 0}, s.distance, s.direction});
    if (energy_ > most_) return too_much;
  }
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto& [a, b, of] = edges_[e];
    for (int j = 1; j < steps[e]; ++j) {
      const double t = j / static_cast<double>(steps[e]);
      const DistanceSample s = sample(points[a] + t * (points[b] - points[a]), of[0]);
      if (!add({{mover_[a], mover_[b], unmoved}, {1 - t, t, 0}, s.distance, s.direction}, {of[0], of[1]}, &s))
        return too_much;
    }
  }
  quality_.resize(facets_.size());
  double energy = 0;
  for (std::uint32_t f = 0; f < facets_.size(); ++f) {
    const Facet& facet = complex_->facets[facets_[f]];
    const Triangle3 t{points[facet.v[0]], points[facet.v[1]], points[facet.v[2]]};
    const std::array<std::uint32_t, 3> mover{mover_[facet.v[0]], mover_[facet.v[1]], mover_[facet.v[2]]};
    const auto add_at = [&](const Barycentric& w) {
      const DistanceSample s = sample(at(w, t), f);
      return add({mover, w, s.distance, s.direction}, {f}, &s);
    };
    for (const Barycentric& w : inner_samples(longest[f]))
      if (!add_at(w)) return too_much;
    for (const Barycentric& w : facet.extra)
      if (!add_at(w)) return too_much;
    for (const SideSample& side : facet.sides) {
      const SideDistance d = side_distance(side, t, delta);
      if (!add({mover, d.foot, d.distance, d.direction}, {f}, nullptr)) return too_much;
    }
    quality_[f] = judge(sums_[f], t, delta);
    energy += quality_[f].energy;
  }
  return energy;
}

/// Adds a sample's part of gradient and Hessian.
void PatchEvaluator::add_to_step(const Sample& s, const std::vector<Vec3>& x, double largest, int p) {
  double moved = s.distance;
  for (std::size_t i = 0; i < 3; ++i)
    if (s.mover[i] != unmoved) moved += s.weight[i] * dot(s.direction, x[s.mover[i]]);
  const double e = moved / largest, q = integer_power(std::abs(e), p - 2);
  if ((p - 1) * q < 1e-9) return;
  const std::array<double, 3> n{s.direction.x, s.direction.y, s.direction.z};
  for (std::size_t i = 0; i < 3; ++i) {
    if (s.mover[i] == unmoved) continue;
    const std::size_t row = 3 * std::size_t{s.mover[i]};
    for (std::size_t k = 0; k < 3; ++k) system_.b(row + k) += q * e * s.weight[i] * n[k];
    for (std::size_t j = 0; j < 3; ++j) {
      if (s.mover[j] == unmoved || s.mover[j] < s.mover[i]) continue;
      const std::size_t column = 3 * std::size_t{s.mover[j]};
      const double factor = (p - 1) * q * s.weight[i] * s.weight[j];
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = row == column ? k : 0; l < 3; ++l)
          system_.a(row + k, column + l) += factor * n[k] * n[l];
    }
  }
}

std::vector<Vec3> PatchEvaluator::step(const std::vector<double>& trust) {
  std::vector<Vec3> x(moving_.size());
  for (const int p : joint_exponents) {
    double largest = 0;
    for (const Sample& s : kept_) {
      double d = s.distance;
      for (std::size_t i = 0; i < 3; ++i)
        if (s.mover[i] != unmoved) d += s.weight[i] * dot(s.direction, x[s.mover[i]]);
      largest = std::max(largest, std::abs(d));
    }
    if (largest <= 0) break;
    system_.clear();
    for (const Sample& s : kept_) add_to_step(s, x, largest, p);
    double most_trace = 0;
    const auto trace = [&](std::size_t v) {
      return system_.a(3 * v, 3 * v) + system_.a(3 * v + 1, 3 * v + 1) + system_.a(3 * v + 2, 3 * v + 2);
    };
    for (std::size_t v = 0; v < x.size(); ++v) most_trace = std::max(most_trace, trace(v));
    for (std::size_t v = 0; v < x.size(); ++v) {
      const double shift = joint_shift * trace(v) + 1e-6 * most_trace + 1e-12;
      for (std::size_t k = 0; k < 3; ++k) system_.a(3 * v + k, 3 * v + k) += shift;
    }
    if (!system_.solve()) break;
    for (std::size_t v = 0; v < x.size(); ++v) {
      x[v] = x[v] - largest * Vec3{system_.b(3 * v), system_.b(3 * v + 1), system_.b(3 * v + 2)};
      if (const double l = length(x[v]); l > trust[v]) x[v] = (trust[v] / l) * x[v];
    }
  }
  return x;
}

void PatchEvaluator::store(FacetComplex& complex) const {
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    Facet& facet = complex.facets[facets_[f]];
    facet.energy = kept_quality_[f].energy;
    facet.largest = kept_quality_[f].largest;
    facet.folded = kept_quality_[f].folded;
    facet.seed = seeds_[f];
    facet.proven = false;
  }
}

} // namespace

bool relocate_jointly(const InputSurface& input, SurfacePatch& patch, int rounds) {
  FacetComplex& complex = patch.complex;
  if (patch.in_t || !complex.strata.empty()) return false;
  PatchEvaluator evaluator(input, patch);
  if (evaluator.empty()) return false;
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const double delta = input.delta();
  std::vector<double> trust;
  for (const std::uint32_t v : evaluator.moving()) {
    double reach = 0;
    for (const std::uint32_t f : complex.stars[v])
      for (const std::uint32_t w : complex.facets[f].v)
        reach = std::max(reach, distance(complex.points[v], complex.points[w]));
    trust.push_back(std::min(longest_step * delta, 0.5 * reach));
  }
  std::vector<Vec3> points = complex.points;
  double energy = evaluator.evaluate(points, unbounded);
  evaluator.keep();
  bool fell = false;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Vec3> step = evaluator.step(trust);
    double farthest = 0;
    for (const Vec3 s : step) farthest = std::max(farthest, length(s));
    if (farthest < shortest_step * delta) break;
    double part = 1;
    const double before = energy;
    bool improved = false;
    for (int halving = 0; halving < 3 && !improved; ++halving, part *= 0.4) {
      std::vector<Vec3> moved = points;
      for (std::size_t i = 0; i < step.size(); ++i) moved[evaluator.moving()[i]] += part * step[i];
      const double there = evaluator.evaluate(moved, energy);
      if (!(there < energy)) continue;
      evaluator.keep();
      points = std::move(moved);
      energy = there;
      for (std::size_t i = 0; i < step.size(); ++i)
        trust[i] = std::min(trust[i], 2 * part * length(step[i]) + 0.1 * delta);
      improved = fell = true;
    }
    if (!improved || energy > least_joint_gain * before) break;
  }
  if (!fell) return false;
  complex.points = std::move(points);
  evaluator.store(complex);
  return true;
}

} // namespace isoscope
