// Convex bodies are cut edge by edge; points are projected, and fade with their distance from the plane.
#include "scene/section_attempt.h"

#include "questions/outside_kernel.h"
#include "scene/meanings.h"
#include "scene/octree_fates.h"
#include "scene/plane_cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace isoscope {
namespace {

using Points = std::vector<PlanePoint>;

/// Corners of a convex polygon by their angle around its middle.
Points in_order(Points points) {
  if (points.size() < 3) return {};
  PlanePoint middle;
  for (const PlanePoint& p : points) middle.u += p.u, middle.v += p.v;
  middle.u /= static_cast<double>(points.size());
  middle.v /= static_cast<double>(points.size());
  std::sort(points.begin(), points.end(), [&](const PlanePoint& a, const PlanePoint& b) {
    return std::atan2(a.v - middle.v, a.u - middle.u) < std::atan2(b.v - middle.v, b.u - middle.u);
  });
  return points;
}

std::optional<Vec3> crossing(Vec3 a, Vec3 b, const SectionPlane& plane) {
  const double ha = plane.height(a), hb = plane.height(b);
  if ((ha >= 0) == (hb >= 0)) return std::nullopt;
  return a + ha / (ha - hb) * (b - a);
}

std::optional<std::array<PlanePoint, 2>> cut_triangle(const Triangle3& t, const SectionPlane& plane) {
  return cut_polygon(
      3, [&](std::size_t i) { return plane.height(t[i]); },
      [&](std::size_t i, std::size_t j, double part) { return plane.project(t[i] + part * (t[j] - t[i])); });
}

class Builder {
 public:
  Builder(const EdgeXray& xray, const SectionPlane& plane, const AttemptSectionOptions& options)
      : xray_(xray), plane_(plane), options_(options) {
    Box3 box;
    for (const auto& v : xray.star.vertices) box.add(v.position);
    size_ = box.longest_edge();
  }

  void star() {
    const EdgeStar& s = xray_.star;
    line(s.vertices[0].position, s.vertices[1].position, options_.colors.selection, 1, 3.2f);
    mark(s.vertices[0].position, options_.colors.selection, MarkerShape::disc, 8);
    mark(s.vertices[1].position, options_.colors.selection, MarkerShape::ring, 11);
  }

  void kernel() {
    if (Points p = cut_polyhedron(xray_.kernel, plane_); !p.empty())
      out.areas.push_back(
          {AttemptSection::Role::kernel, std::move(p), rgb(meaning_color::kernel), 0.3f, 0.95f});
  }

  /// Of an empty one the half-spaces that already have no common point: their lines, each with a spike to
  /// its side.
  void empty_kernel() {
    const Kernel& k = *xray_.attempt.kernel;
    for (const std::uint32_t w : k.witness) {
      if (w >= k.half_spaces.size()) continue;
      const HalfSpace& h = k.half_spaces[w];
      const double nu = dot(h.normal, plane_.axes.u), nv = dot(h.normal, plane_.axes.v);
      const double length = std::hypot(nu, nv);
      if (length < 1e-3) continue; // the plane of the section runs along it
      const PlanePoint c = plane_.project(k.center);
      // The slack at the foot of the centre in the plane of the section.
      const double slack = h.slack(plane_.lift(c)) / length;
      const PlanePoint n{nu / length, nv / length}, foot{c.u - slack * n.u, c.v - slack * n.v};
      const double reach = 0.3 * size_, spike = 0.06 * size_;
      out.lines.push_back({{foot.u - reach * n.v, foot.v + reach * n.u},
                           {foot.u + reach * n.v, foot.v - reach * n.u},
                           rgb(meaning_color::kernel),
                           0.95f,
                           2.0f});
      const PlanePoint tip{foot.u + spike * n.u, foot.v + spike * n.v};
      out.lines.push_back({foot, tip, rgb(meaning_color::kernel), 0.9f, 1.4f});
      out.marks.push_back({tip, rgb(meaning_color::kernel), MarkerShape::triangle, 7, 1});
    }
    mark(k.center, rgb(meaning_color::kernel), MarkerShape::circle, 11);
  }

  void invalid_regions() {
    for (const EdgeXray::Invalid& region : xray_.invalid)
      if (Points p = cut_polyhedron(region.shape, plane_); !p.empty())
        out.areas.push_back(
            {AttemptSection::Role::invalid, std::move(p), rgb(meaning_color::invalid), 0.1f, 0.95f, true});
  }

  void cells() {
    for (const OctreeCell& cell : xray_.attempt.cells) {
      if (cell.fate == OctreeCell::Fate::split) continue;
      Points p = cut_box(cell.box, plane_);
      if (p.empty()) continue;
      const bool faint = is_faint(cell.fate);
      out.areas.push_back({AttemptSection::Role::cell, std::move(p), rgb(fate_style(cell.fate).color),
                           faint ? 0.0f : 0.12f, faint ? 0.3f : 0.8f});
    }
  }

  void offenders(const std::vector<std::vector<VertexId>>& simplices) {
    for (const auto& simplex : simplices) {
      std::vector<Vec3> places;
      for (const VertexId id : simplex)
        for (const auto& v : xray_.star.vertices)
          if (v.id == id) places.push_back(v.position);
      if (places.size() == 1) mark(places[0], rgb(meaning_color::offender), MarkerShape::square, 12);
      if (places.size() == 2) line(places[0], places[1], rgb(meaning_color::offender), 1, 2.8f);
      if (places.size() == 3)
        if (const auto s = cut_triangle({places[0], places[1], places[2]}, plane_))
          out.lines.push_back({(*s)[0], (*s)[1], rgb(meaning_color::offender), 1, 2.8f});
    }
  }

  void candidates() {
    for (const CandidateRecord& c : xray_.attempt.candidates)
      if (c.rejected != Reason::none) mark(c.point, rgb(words(c.rejected).color), words(c.rejected).shape, 9);
  }

  void outside() {
    if (xray_.attempt.rejected != Reason::no_candidate) return;
    const ReasonWords& style = words(Reason::no_candidate);
    for (const OutsidePoint& p : points_outside(xray_)) {
      mark(p.point, rgb(style.color), style.shape, 15);
      line(p.point, xray_.attempt.kernel->center, rgb(style.color), 0.8f, 1.4f);
    }
  }

  void targets(bool studied) {
    const CollapseAttempt& attempt = xray_.attempt;
    if (attempt.kernel && !attempt.kernel->empty)
      mark(attempt.optimum, options_.colors.accent, MarkerShape::hollow_diamond, 14);
    if (!attempt.possible()) return;
    mark(attempt.target, options_.colors.good, MarkerShape::disc, 12);
    if (!studied) mark(attempt.target, options_.colors.good, MarkerShape::ring, 20);
  }

  void ghost(const TargetStudy& study) {
    for (const TargetStudy::Facet& facet : study.after)
      if (const auto s = cut_triangle(facet.corners, plane_))
        out.lines.push_back({(*s)[0], (*s)[1], facet.inside ? options_.colors.accent : options_.colors.bad,
                             0.95f, facet.inside ? 1.6f : 2.4f, true});
    const bool possible = study.attempt.possible();
    mark(study.target, possible ? options_.colors.good : options_.colors.bad,
         possible ? MarkerShape::disc : MarkerShape::diamond, 12);
    mark(study.target, options_.colors.accent, MarkerShape::ring, 24);
  }

  AttemptSection out;

 private:
  void line(Vec3 a, Vec3 b, glm::vec3 color, float strength, float width) {
    const float near = std::min(strength_of(a), strength_of(b));
    out.lines.push_back({plane_.project(a), plane_.project(b), color, strength * near, width, near < 0.5f});
  }
  void mark(Vec3 p, glm::vec3 color, MarkerShape shape, std::uint8_t diameter) {
    out.marks.push_back({plane_.project(p), color, shape, diameter, strength_of(p)});
  }
  /// 1 on the plane; a hint beyond a fifth of the star.
  float strength_of(Vec3 p) const {
    const double far = size_ > 0 ? std::abs(plane_.height(p)) / (0.2 * size_) : 0;
    return static_cast<float>(std::clamp(1.0 - 0.75 * far, 0.25, 1.0));
  }

  const EdgeXray& xray_;
  const SectionPlane& plane_;
  const AttemptSectionOptions& options_;
  double size_ = 0; ///< of the star
};

} // namespace

std::size_t AttemptSection::count(Role role) const {
  return static_cast<std::size_t>(
      std::count_if(areas.begin(), areas.end(), [&](const Area& a) { return a.role == role; }));
}

std::vector<std::array<PlanePoint, 2>> hatch_lines(const std::vector<PlanePoint>& polygon, double spacing) {
  std::vector<std::array<PlanePoint, 2>> lines;
  const auto height = [](const PlanePoint& p) { return (p.u - p.v) * std::sqrt(0.5); };
  double low = Box3::inf, high = -Box3::inf;
  for (const PlanePoint& p : polygon) low = std::min(low, height(p)), high = std::max(high, height(p));
  if (!(spacing > 0) || !(high - low < 1e4 * spacing)) return lines;
  for (double k = std::ceil(low / spacing); k * spacing < high; ++k) {
    const auto ends = cut_polygon(
        polygon.size(), [&](std::size_t i) { return height(polygon[i]) - k * spacing; },
        [&](std::size_t i, std::size_t j, double t) {
          const PlanePoint a = polygon[i], b = polygon[j];
          return PlanePoint{a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
        });
    if (ends) lines.push_back(*ends);
  }
  return lines;
}

std::vector<PlanePoint> cut_polyhedron(const KernelPolyhedron& shape, const SectionPlane& plane) {
  Points points;
  for (const auto& face : shape.faces)
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      if (a > b) continue; // the other face of the edge has it too
      if (const auto p = crossing(shape.vertices[a], shape.vertices[b], plane))
        points.push_back(plane.project(*p));
    }
  return in_order(std::move(points));
}

std::vector<PlanePoint> cut_box(const Box3& box, const SectionPlane& plane) {
  const auto corner = [&](unsigned i) {
    return Vec3{i & 1u ? box.hi.x : box.lo.x, i & 2u ? box.hi.y : box.lo.y, i & 4u ? box.hi.z : box.lo.z};
  };
  Points points;
  for (unsigned i = 0; i < 8; ++i)
    for (const unsigned bit : {1u, 2u, 4u})
      if ((i & bit) == 0)
        if (const auto p = crossing(corner(i), corner(i | bit), plane)) points.push_back(plane.project(*p));
  return in_order(std::move(points));
}

AttemptSection attempt_section(const EdgeXray& xray, const TargetStudy* study, const SectionPlane& plane,
                               const AttemptSectionOptions& options) {
  Builder b(xray, plane, options);
  if (options.octree_cells) b.cells();
  if (xray.attempt.kernel && xray.attempt.kernel->empty)
    b.empty_kernel();
  else
    b.kernel();
  if (options.invalid_regions) b.invalid_regions();
  b.star();
  b.offenders(xray.attempt.link.offending_t);
  b.offenders(xray.attempt.link.offending_zero);
  b.candidates();
  b.outside();
  b.targets(study != nullptr);
  if (study != nullptr) b.ghost(*study);
  return std::move(b.out);
}

} // namespace isoscope
