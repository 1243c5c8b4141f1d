// Answers from one state; nothing is kept.
#include "questions/element_questions.h"

#include "mesh/predicates.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

bool carries(const StateSnapshot& s, TetId t) {
  return s.complex.form == ZeroForm::interpolated && t.index() < s.complex.tets.size() &&
         s.complex.tet(t).alive() && s.complex.heterogeneous(t);
}

/// The ends of the shortest segment between apex and plane, or between two lines.
std::array<Vec3, 2> gap_of(const std::array<Vec3, 4>& p, const Height& h) {
  const Vec3 a = p[h.order[0]], b = p[h.order[1]], c = p[h.order[2]], d = p[h.order[3]];
  if (h.split == Height::Split::one_three) {
    const Vec3 normal = normalized(cross(c - b, d - b));
    return {a, a - dot(normal, a - b) * normal};
  }
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), det = uu * vv - uv * uv;
  if (!(det > 0)) return {a, c + dot(v, w) / vv * v};
  const double s = (uv * dot(v, w) - vv * dot(u, w)) / det, t = (uu * dot(v, w) - uv * dot(u, w)) / det;
  return {a + s * u, c + t * v};
}

bool is_vertex(const StateSnapshot& s, SampleId sample) {
  const Vec3 p = s.samples->positions[sample.index()];
  return std::any_of(s.complex.vertices.begin(), s.complex.vertices.end(),
                     [&](const Vertex& v) { return v.alive && v.position == p; });
}

/// The sample nearest to the circumcentre, where it lies strictly inside the circumscribed ball.
SampleId circumcenter_sample(const std::array<Vec3, 4>& p, const NearestSample& nearest) {
  const Vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0];
  const Vec3 offset =
      (squared_length(a) * cross(b, c) + squared_length(b) * cross(c, a) + squared_length(c) * cross(a, b)) /
      (2 * dot(a, cross(b, c)));
  if (!is_finite(offset)) return {};
  const SampleId s = nearest.nearest(p[0] + offset);
  if (!s.valid()) return {};
  return side_of_sphere(p[0], p[1], p[2], p[3], nearest.positions()[s.index()]) > 0 ? s : SampleId();
}

} // namespace

std::optional<TetInspection> inspect_tet(const StateSnapshot& state, TetId t, double shrink,
                                         const NearestSample* nearest) {
  if (!carries(state, t)) return std::nullopt;
  const auto p = state.complex.positions(t);
  const auto f = state.complex.values(t);
  const TetLabels labels = state.complex.labels(t);
  TetInspection out;
  out.height = tetrahedron_height(p, f, labels);
  if (out.height.split != Height::Split::none) out.gap = gap_of(p, out.height);
  out.shrink = shrink;
  const Vec3 center = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  for (std::size_t i = 0; i < 4; ++i) out.shrunk[i] = center + shrink * (p[i] - center);
  if (nearest != nullptr && state.samples) {
    out.orientation =
        check_orientation(p, f, labels, shrink, orientation_reach * state.criteria.delta, *nearest);
    out.candidate = circumcenter_sample(p, *nearest);
    out.candidate_is_vertex = out.candidate.valid() && is_vertex(state, out.candidate);
  }
  return out;
}

std::vector<TetId> misoriented_tets(const StateSnapshot& state) {
  std::vector<TetId> out;
  for (std::size_t i = 0; i < state.tet_flags.size(); ++i)
    if (state.tet_flags[i] & tet_violates_3) out.push_back(TetId(i));
  return out;
}

std::vector<FlatTet> flat_tets(const StateSnapshot& state, double limit) {
  std::vector<FlatTet> out;
  if (state.complex.form != ZeroForm::interpolated) return out;
  for (std::size_t i = 0; i < state.heights.size(); ++i)
    if ((state.tet_flags[i] & tet_heterogeneous) && static_cast<double>(state.heights[i]) < limit)
      out.push_back({TetId(i), static_cast<double>(state.heights[i])});
  std::stable_sort(out.begin(), out.end(),
                   [](const FlatTet& a, const FlatTet& b) { return a.height < b.height; });
  return out;
}

std::optional<SampleInspection> inspect_sample(const StateSnapshot& s, SampleId sample) {
  const std::size_t id = sample.index();
  if (!s.samples || !s.classifies() || id >= s.errors.size() || id >= s.sample_tets.size())
    return std::nullopt;
  SampleInspection out;
  out.tet = s.sample_tets[id];
  out.error = static_cast<double>(s.errors[id]);
  out.f = (1 - out.error) * (s.samples->labels[id] > 0 ? 1 : -1);
  out.bad = is_bad(out.error);
  out.within_margin = out.error <= s.criteria.error_limit();
  using Remedy = SampleInspection::Remedy;
  if (s.complex.form != ZeroForm::interpolated || !s.criteria.condition_1) {
    out.remedy = Remedy::not_asked;
    return out;
  }
  if (out.within_margin) return out;
  std::vector<float> worst(s.complex.tets.size(), -1);
  SampleId own = sample;
  for (std::size_t k = 0; k < s.errors.size(); ++k) {
    const TetId t = s.sample_tets[k];
    if (!t.valid()) continue;
    worst[t.index()] = std::max(worst[t.index()], s.errors[k]);
    if (t != out.tet || k == id) continue;
    out.worse_in_tet += s.errors[k] > s.errors[id];
    if (s.errors[k] > s.errors[own.index()]) own = SampleId(k);
  }
  const float of_tet = out.tet.valid() ? worst[out.tet.index()] : s.errors[id];
  for (std::size_t t = 0; t < worst.size(); ++t)
    out.tets_before += worst[t] > of_tet || (worst[t] == of_tet && TetId(t) < out.tet);
  out.fixer = own;
  if (is_vertex(s, sample))
    out.remedy = Remedy::vertex_already;
  else if (own != sample)
    out.remedy = Remedy::worse_in_tet;
  else
    out.remedy = out.tets_before == 0 ? Remedy::itself_next : Remedy::itself_later;
  return out;
}

namespace {

using Parameter = ParameterAdvice::Parameter;

/// Condition 1: ε <= 1 − α.
ParameterAdvice advise_error(double error, const CriteriaParameters& criteria) {
  ParameterAdvice a{Parameter::alpha, Condition::classification, criteria.alpha, false, {}, false};
  a.holds = error <= criteria.error_limit();
  if (!a.holds && error < 1) a.works = 1 - error;
  return a;
}

/// The largest factor below the present one with which the tetrahedron is oriented well.
std::optional<double> largest_good_shrink(const std::array<Vec3, 4>& p, const std::array<double, 4>& f,
                                          const TetLabels& labels, const CriteriaParameters& criteria,
                                          const NearestSample& nearest) {
  const double reach = orientation_reach * criteria.delta;
  const auto good = [&](double shrink) {
    return !check_orientation(p, f, labels, shrink, reach, nearest).misoriented;
  };
  constexpr double grain = 0.01;
  constexpr int halvings = 12;
  double bad = criteria.shrink;
  for (double shrink = criteria.shrink - grain; shrink > grain / 2; shrink -= grain) {
    if (!good(shrink)) {
      bad = shrink;
      continue;
    }
    double low = shrink;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + bad);
      (good(middle) ? low : bad) = middle;
    }
    return low;
  }
  return std::nullopt;
}

} // namespace

std::vector<ParameterAdvice> advise_tet(const StateSnapshot& s, TetId t, const NearestSample* nearest) {
  std::vector<ParameterAdvice> out;
  if (s.complex.form != ZeroForm::interpolated || t.index() >= s.complex.tets.size() ||
      !s.complex.tet(t).alive())
    return out;
  double error = -1;
  for (std::size_t k = 0; k < s.sample_tets.size() && k < s.errors.size(); ++k)
    if (s.sample_tets[k] == t) error = std::max(error, static_cast<double>(s.errors[k]));
  if (error >= 0) out.push_back(advise_error(error, s.criteria));
  if (!carries(s, t)) return out;
  const auto p = s.complex.positions(t);
  const auto f = s.complex.values(t);
  const TetLabels labels = s.complex.labels(t);
  const double height = tetrahedron_height(p, f, labels).value;
  const bool high = height >= s.criteria.height_limit();
  ParameterAdvice alpha{Parameter::alpha, Condition::height, s.criteria.alpha, high, {}, true};
  if (!high && 2 * s.criteria.sigma < height) alpha.works = 2 * s.criteria.sigma / height;
  out.push_back(alpha);
  ParameterAdvice sigma{Parameter::sigma, Condition::height, s.criteria.sigma, high, {}, false};
  if (!high && height > 0) sigma.works = 0.5 * s.criteria.alpha * height;
  out.push_back(sigma);
  if (nearest == nullptr) return out;
  ParameterAdvice shrink{Parameter::shrink, Condition::orientation, s.criteria.shrink, true, {}, false};
  const double reach = orientation_reach * s.criteria.delta;
  shrink.holds = !check_orientation(p, f, labels, s.criteria.shrink, reach, *nearest).misoriented;
  if (!shrink.holds) shrink.works = largest_good_shrink(p, f, labels, s.criteria, *nearest);
  out.push_back(shrink);
  return out;
}

std::vector<ParameterAdvice> advise_sample(const StateSnapshot& s, SampleId sample) {
  if (s.complex.form != ZeroForm::interpolated || !s.classifies() || sample.index() >= s.errors.size())
    return {};
  return {advise_error(static_cast<double>(s.errors[sample.index()]), s.criteria)};
}

} // namespace isoscope
