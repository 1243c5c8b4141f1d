// Newton steps on p-norms of the linearised distances, checked against the true energy.
#include "improve/placement.h"

#include "improve/integer_power.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace isoscope {
namespace {

constexpr std::array<int, 7> exponents{2, 4, 8, 8, 14, 14, 14};
constexpr double regularisation = 1e-3; ///< of the Hessian's trace
constexpr double most_trust = 8;        ///< longest step in δ

/// Symmetric 3 x 3 matrix: xx, xy, xz, yy, yz, zz.
using Symmetric3 = std::array<double, 6>;

/// H⁻¹ g, or zero for a singular H.
Vec3 solve(const Symmetric3& h, Vec3 g) {
  const auto [xx, xy, xz, yy, yz, zz] = h;
  const double a = yy * zz - yz * yz, b = xz * yz - xy * zz, c = xy * yz - xz * yy;
  const double det = xx * a + xy * b + xz * c;
  if (det == 0) return {};
  const double d = xx * zz - xz * xz, e = xy * xz - xx * yz, f = xx * yy - xy * xy;
  return Vec3{a * g.x + b * g.y + c * g.z, b * g.x + d * g.y + e * g.z, c * g.x + e * g.y + f * g.z} / det;
}

/// A step from a point of the kernel that ends inside: it slides along what blocks it, and keeps a part of
/// the distance to each facet.
Vec3 step_inside(const Kernel& kernel, Vec3 from, Vec3 step) {
  constexpr double kept = 0.1;
  constexpr int most_bends = 3;
  Vec3 taken;
  for (int bend = 0; bend < most_bends; ++bend) {
    double part = 1;
    const HalfSpace* blocking = nullptr;
    for (const HalfSpace& h : kernel.half_spaces) {
      const double rate = -dot(h.normal, step);
      if (rate <= 0) continue;
      const double reach = std::max(0., (1 - kept) * h.slack(from + taken) / rate);
      if (reach < part) part = reach, blocking = &h;
    }
    taken += part * step;
    if (blocking == nullptr) break;
    step = (1 - part) * step;
    step = step - dot(blocking->normal, step) * blocking->normal;
  }
  return taken;
}

} // namespace

Star make_star(const FacetComplex& complex, std::span<const Wedge> wedges, bool with_extra) {
  Star star;
  star.wedges.reserve(wedges.size());
  for (const Wedge& w : wedges) {
    const Facet& f = complex.facets[w.facet];
    Star::Wedge wedge{complex.points[w.rim], {}, {}, w.corner, f.seed, f.labels};
    if (with_extra) wedge.extra = f.extra, wedge.sides = f.sides;
    star.wedges.push_back(wedge);
  }
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= wedges.size(); ++end) {
    const std::uint32_t next = wedges[end - 1].next;
    if (end < wedges.size() && wedges[end].rim == next) continue;
    Star::Fan& fan = star.fans.emplace_back(Star::Fan{begin, end, {}});
    if (next != wedges[begin].rim) fan.last = complex.points[next];
    begin = end;
  }
  return star;
}

void move_border(const InputSurface& input, const FacetComplex& complex, std::uint32_t a, std::uint32_t b,
                 Star& star) {
  star.gate = input.gate();
  star.rim = rim_around(complex, std::array{a, b});
}

void StarEvaluator::number_spokes() {
  const std::size_t n = star_->wedges.size();
  first_.resize(n);
  second_.resize(n);
  for (const Star::Fan& fan : star_->fans) {
    const std::size_t first = spokes_.size();
    for (std::size_t i = fan.begin; i < fan.end; ++i) {
      first_[i] = spokes_.size();
      second_[i] = spokes_.size() + 1;
      Spoke& spoke = spokes_.emplace_back();
      spoke.rim = star_->wedges[i].rim;
      spoke.after = i;
      if (i > fan.begin) spoke.before = i - 1;
    }
    if (fan.last) {
      spokes_.emplace_back().rim = *fan.last;
    } else {
      second_[fan.end - 1] = first;
    }
    spokes_[second_[fan.end - 1]].before = fan.end - 1;
  }
}

StarEvaluator::StarEvaluator(const InputSurface& input, const Star& star)
    : input_(&input), star_(&star), fixed_(star.wedges.size()), rim_steps_(star.wedges.size()) {
  number_spokes();
  const std::size_t n = star.wedges.size();
  TriangleId guess = star.wedges.front().seed;
  center_guess_ = guess;
  for (std::size_t i = 0; i < n; ++i) {
    const Star::Wedge& wedge = star.wedges[i];
    Spoke &first = spokes_[first_[i]], &second = spokes_[second_[i]];
    if (wedge.seed.valid()) guess = wedge.seed;
    const DistanceSample corner = input_->sample(wedge.rim, guess);
    guess = corner.triangle;
    beside(first_[i], [&](std::size_t w) { fixed_[w].add(corner, input); });
    const Vec3 along = second.rim - wedge.rim;
    rim_steps_[i] = sampling_steps(length(along), input.delta());
    for (int j = 1; j < rim_steps_[i]; ++j) {
      const DistanceSample s =
          input_->sample(wedge.rim + (j / static_cast<double>(rim_steps_[i])) * along, guess);
      guess = s.triangle;
      fixed_[i].add(s, input);
    }
    first.edge.fill(corner.triangle);
    first.inner.fill(guess);
    first.extra.assign(wedge.extra.size(), guess);
    if (input.rooms().samples != nullptr)
      for (const std::int8_t label : {wedge.labels.front, wedge.labels.back})
        for (const Vec3 p : {first.rim, second.rim}) fixed_[i].add(input.rooms().at(p, label).value, input);
    if (second.after != none) continue;
    const DistanceSample last = input_->sample(second.rim, guess);
    fixed_[i].add(last, input);
    second.edge.fill(last.triangle);
  }
}

DistanceSample StarEvaluator::sample(Vec3 p, double weight, TriangleId& guess) {
  const DistanceSample s = input_->sample(p, guess);
  guess = s.triangle;
  linear_.push_back({weight, s});
  return s;
}

Placement StarEvaluator::evaluate(Vec3 x, double most_energy, double most_distance) {
  const std::size_t n = star_->wedges.size();
  Placement result;
  result.point = x;
  result.facets.resize(n);
  result.seeds.resize(n);
  linear_.clear();
  sums_ = fixed_;
  spoke_steps_.resize(spokes_.size());
  counts_.resize(n);
  for (std::size_t i = 0; i < spokes_.size(); ++i)
    spoke_steps_[i] = sampling_steps(distance(spokes_[i].rim, x), input_->delta());
  const RoomSamples& rooms = input_->rooms();
  // What is summed so far, over the final number of samples, never exceeds the energy.
  double energy = 0, largest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Star::Wedge& wedge = star_->wedges[i];
    const auto inner = inner_samples(longest_steps(i)).size();
    counts_[i] =
        static_cast<double>(fixed_[i].count + spoke_steps_[first_[i]] + spoke_steps_[second_[i]] - 1) +
        static_cast<double>(inner + wedge.extra.size() + wedge.sides.size()) +
        (rooms.samples != nullptr ? 4 : 0);
    energy += fixed_[i].energy / counts_[i];
  }
  const auto add = [&](std::size_t wedge, const DistanceSample& s) {
    energy += sums_[wedge].add(s, *input_) / counts_[wedge];
    largest = std::max(largest, s.distance);
  };
  const auto is_enough = [&] { return energy > most_energy || largest > most_distance; };
  const auto give_up = [&] { result.energy = std::numeric_limits<double>::infinity(); };
  const DistanceSample center = sample(x, 1, center_guess_);
  for (std::size_t i = 0; i < n; ++i) add(i, center);
  for (std::size_t i = 0; i < spokes_.size(); ++i) {
    if (is_enough()) return give_up(), result;
    const Vec3 along = spokes_[i].rim - x;
    for (int j = 1; j < spoke_steps_[i]; ++j) {
      const double t = j / static_cast<double>(spoke_steps_[i]);
      const DistanceSample s = sample(x + t * along, 1 - t, spokes_[i].edge[static_cast<std::size_t>(j - 1)]);
      beside(i, [&](std::size_t w) { add(w, s); });
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (is_enough()) return give_up(), result;
    const Triangle3 t = facet(i, x);
    Spoke& spoke = spokes_[first_[i]];
    const auto inner = inner_samples(longest_steps(i));
    for (std::size_t j = 0; j < inner.size(); ++j)
      add(i, sample(at(inner[j], t), inner[j][0], spoke.inner[j]));
    const Star::Wedge& wedge = star_->wedges[i];
    for (std::size_t j = 0; j < wedge.extra.size(); ++j) {
      const Barycentric& e = wedge.extra[j];
      const Barycentric w{e[wedge.corner], e[(wedge.corner + 1u) % 3], e[(wedge.corner + 2u) % 3]};
      add(i, sample(at(w, t), w[0], spoke.extra[j]));
    }
    for (const SideSample& side : wedge.sides) {
      const SideDistance d = side_distance(side, t, input_->delta());
      energy += sums_[i].add(d.distance, *input_) / counts_[i];
      linear_.push_back({d.foot[0], {d.distance, d.direction, {}}});
    }
    if (rooms.samples == nullptr) continue;
    for (const std::int8_t label : {wedge.labels.front, wedge.labels.back})
      for (const auto& [p, weight] : {std::pair(x, 1.), std::pair(centroid(t), 1. / 3)}) {
        const RoomSamples::Distance d = rooms.at(p, label);
        energy += sums_[i].add(d.value, *input_) / counts_[i];
        linear_.push_back({weight, {d.value, d.direction, {}}});
      }
  }
  for (std::size_t i = 0; i < n; ++i) {
    result.facets[i] = judge(sums_[i], facet(i, x), input_->delta());
    result.seeds[i] = spokes_[first_[i]].edge[0];
    result.energy += result.facets[i].energy;
    result.largest = std::max(result.largest, result.facets[i].largest);
    result.folded = result.folded || result.facets[i].folded;
  }
  if (star_->gate != nullptr) add_border(x, result);
  return result;
}

void StarEvaluator::add_border(Vec3 x, Placement& placement) {
  const std::array<Segment3, 2> edges{Segment3{x, spokes_.front().rim}, Segment3{x, spokes_.back().rim}};
  std::array<FacetSums, 2> sums;
  const auto add = [&](std::size_t edge, const BorderSample& s) {
    sums[edge].add(s.distance, *input_);
    linear_.push_back({s.weight, {s.distance, s.direction, {}}});
  };
  for (std::size_t e = 0; e < 2; ++e) {
    const int steps = border_steps(edges[e], input_->delta());
    for (int j = 0; j <= steps; ++j)
      add(e, sample_of_border(*star_->gate, edges[e], static_cast<double>(j) / steps));
  }
  for (const Vec3 r : star_->rim) {
    const std::array<BorderSample, 2> to{sample_of_rim(r, edges[0]), sample_of_rim(r, edges[1])};
    const std::size_t nearer = to[0].distance <= to[1].distance ? 0 : 1;
    add(nearer, to[nearer]);
  }
  for (const FacetSums& s : sums) {
    placement.energy += s.energy / s.count;
    placement.largest = std::max(placement.largest, s.largest);
  }
}

int StarEvaluator::longest_steps(std::size_t i) const {
  return std::max({spoke_steps_[first_[i]], spoke_steps_[second_[i]], rim_steps_[i]});
}

Vec3 StarEvaluator::minimax_step(double trust) const {
  Vec3 step;
  std::vector<double> values(best_linear_.size()); // of the linearised distances after the step
  for (const int p : exponents) {
    double largest = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Linear& l = best_linear_[i];
      values[i] = l.sample.distance + l.weight * dot(l.sample.direction, step);
      largest = std::max(largest, std::abs(values[i]));
    }
    if (largest <= 0) break;
    Symmetric3 h{};
    Vec3 g;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Linear& l = best_linear_[i];
      const Vec3 n = l.sample.direction;
      const double e = values[i] / largest;
      const double q = integer_power(e, p - 2);
      const double first = q * e * l.weight, second = (p - 1) * q * l.weight * l.weight;
      g += first * n;
      h[0] += second * n.x * n.x;
      h[1] += second * n.x * n.y;
      h[2] += second * n.x * n.z;
      h[3] += second * n.y * n.y;
      h[4] += second * n.y * n.z;
      h[5] += second * n.z * n.z;
    }
    const double shift = regularisation * (h[0] + h[3] + h[5]) + 1e-12;
    h[0] += shift;
    h[3] += shift;
    h[5] += shift;
    step = step - largest * solve(h, g);
    const double l = length(step);
    if (l > trust) step = (trust / l) * step;
  }
  return step;
}

void StarEvaluator::improve(Placement& best, int rounds, const Kernel* kernel) {
  best_linear_ = linear_;
  const double delta = input_->delta();
  double scale = 0;
  for (const Star::Wedge& w : star_->wedges) scale = std::max(scale, distance(w.rim, best.point));
  double trust = std::min(most_trust * delta, 0.5 * scale);
  for (int round = 0; round < rounds; ++round) {
    Vec3 step = minimax_step(trust);
    if (kernel != nullptr) step = step_inside(*kernel, best.point, step);
    if (length(step) < 1e-3 * delta) return;
    const double before = best.energy;
    bool improved = false;
    for (int halving = 0; halving < 3 && !improved; ++halving, step = 0.4 * step) {
      if (kernel != nullptr && !kernel->contains(best.point + step)) continue;
      Placement candidate = evaluate(best.point + step, best.energy);
      if (!(candidate.energy < best.energy)) continue;
      best = std::move(candidate);
      best_linear_.swap(linear_);
      trust = std::min(trust, 2 * length(step) + 0.1 * delta);
      improved = true;
    }
    if (!improved || best.energy > 0.97 * before) return;
  }
}

} // namespace isoscope
