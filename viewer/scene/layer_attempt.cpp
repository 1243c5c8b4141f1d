// The edge under the X-ray.
#include "scene/layers.h"

#include "journal/vocabulary.h"
#include "questions/outside_kernel.h"
#include "scene/attempt_builder.h"
#include "scene/search_regions.h"

#include <glad/gl.h>

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr std::uint32_t offender_color = meaning_color::offender;

struct Builder : AttemptBuilder {
  /// `length`: of the edge. A kernel many times as large would hide what it is the kernel of: it fades.
  void kernel(const KernelPolyhedron& k, double length) {
    const glm::vec3 color = rgb(kernel_color);
    Box3 box;
    for (const Vec3& v : k.vertices) box.add(v);
    constexpr double usual = 4, faintest = 0.2;
    const double share = box.empty() ? 1.0 : std::clamp(usual * length / box.longest_edge(), faintest, 1.0);
    const auto fill = static_cast<float>(0.3 * share), outline = static_cast<float>(0.95 * std::sqrt(share));
    for (const auto& face : k.faces) {
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = k.vertices[face[i]], b = k.vertices[face[(i + 1) % face.size()]];
        if (face[i] < face[(i + 1) % face.size()]) line(a, b, color, outline, 1.5f);
        if (i + 2 < face.size())
          faces.triangle(space.local(k.vertices[face[0]]), space.local(k.vertices[face[i + 1]]),
                         space.local(k.vertices[face[i + 2]]), color8(color, fill), 0);
      }
    }
  }

  void star(const EdgeStar& s, const SceneColors& colors) {
    // The ring's facets of Z before the collapse; the edges of T at the ends stay a hint.
    for (const StarFacet& f : zero_facets(s))
      for (std::size_t i = 0; i < 3; ++i)
        if (f.v[i] < f.v[(i + 1) % 3] || f.ring())
          line(s.vertices[f.v[i]].position, s.vertices[f.v[(i + 1) % 3]].position, colors.selection, 0.55f,
               1.2f);
    line(s.vertices[0].position, s.vertices[1].position, colors.selection, 1, 3.4f);
    mark(s.vertices[0].position, colors.selection, MarkerShape::disc, 8);
    mark(s.vertices[1].position, colors.selection, MarkerShape::ring, 11);
  }

  void offenders(const EdgeStar& s, const std::vector<std::vector<VertexId>>& simplices) {
    const auto place = [&](VertexId v) {
      for (const auto& w : s.vertices)
        if (w.id == v) return w.position;
      return s.vertices[0].position;
    };
    const glm::vec3 color = rgb(offender_color);
    for (const auto& simplex : simplices) {
      if (simplex.size() == 1) mark(place(simplex[0]), color, MarkerShape::square, 12);
      for (std::size_t i = 0; i < simplex.size() && simplex.size() > 1; ++i)
        line(place(simplex[i]), place(simplex[(i + 1) % simplex.size()]), color, 1, 2.8f);
      if (simplex.size() == 3)
        faces.triangle(space.local(place(simplex[0])), space.local(place(simplex[1])),
                       space.local(place(simplex[2])), color8(color, 0.45f), 0);
    }
  }

  void candidates(const CollapseAttempt& attempt) {
    for (const CandidateRecord& c : attempt.candidates) {
      const ReasonWords& style = words(c.rejected);
      if (c.rejected != Reason::none) mark(c.point, rgb(style.color), style.shape, 9, 0.95f);
    }
  }

  /// Where no candidate lay in the kernel: what lay outside, and the way into it.
  void outside(const EdgeXray& xray) {
    if (xray.attempt.rejected != Reason::no_candidate) return;
    const ReasonWords& style = words(Reason::no_candidate);
    for (const OutsidePoint& p : points_outside(xray)) {
      mark(p.point, rgb(style.color), style.shape, 15);
      line(p.point, xray.attempt.kernel->center, rgb(style.color), 0.8f, 1.4f, true);
    }
  }
};

} // namespace

void AttemptLayer::update(const EdgeXray* xray, const TargetStudy* study, const ViewFrame& frame) {
  const SceneColors& colors = frame.colors;
  Builder b{{frame.space, {}, {}, {}}};
  if (xray) {
    const CollapseAttempt& attempt = xray->attempt;
    b.star(xray->star, colors);
    if (attempt.kernel && attempt.kernel->empty)
      add_empty_kernel(b, *xray, static_cast<double>(frame.view.kernel_push));
    else
      b.kernel(xray->kernel, length(xray->star.vertices[1].position - xray->star.vertices[0].position));
    if (frame.view.invalid_regions) add_invalid_regions(*xray, frame.space, b.lines, b.faces);
    if (frame.view.octree_cells) add_octree_cells(attempt, frame.space, b.lines);
    b.offenders(xray->star, attempt.link.offending_t);
    b.offenders(xray->star, attempt.link.offending_zero);
    b.candidates(attempt);
    b.outside(*xray);
    for (const Vec3& wrong : xray->pruning.wrong) b.mark(wrong, colors.warning, MarkerShape::square, 13);
    const bool searched = attempt.kernel && !attempt.kernel->empty;
    if (searched) b.mark(attempt.optimum, colors.accent, MarkerShape::hollow_diamond, 14);
    const bool chosen = attempt.possible() || study;
    if (searched && chosen && frame.view.cost_ellipsoid)
      add_cost_ellipsoid(b, *xray, study ? study->target : attempt.target, colors.accent);
    if (attempt.possible()) {
      if (attempt.optimum != attempt.target)
        b.line(attempt.optimum, attempt.target, colors.accent, 0.8f, 1.4f, true);
      b.mark(attempt.target, colors.good, MarkerShape::disc, 12);
      b.mark(attempt.target, colors.good, MarkerShape::ring, 20);
    }
    if (study) add_ghost(b, *study, colors);
  }
  if (frame.mark) {
    b.mark(*frame.mark, colors.bad, MarkerShape::cross, 16);
    b.mark(*frame.mark, colors.bad, MarkerShape::ring, 26);
  }
  kernel_.upload(b.faces);
  edges_.upload(b.lines);
  marks_.upload(b.marks);
}

void AttemptLayer::draw(Programs& programs, const ViewFrame& frame) {
  const float opacity = frame.view.xray.opacity;
  MeshStyle faces;
  const auto pass = [&](float strength) {
    faces.opacity = strength * opacity;
    kernel_.draw(programs.mesh_flat, faces);
    edges_.draw(programs.line, strength * opacity, 2e-3f);
    marks_.draw(programs.marker, strength * opacity);
  };
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  // What Z hides stays readable: the kernel and its candidates straddle Z.
  glDepthFunc(GL_GREATER);
  pass(0.5f);
  glDepthFunc(GL_LEQUAL);
  pass(1.0f);
  glDepthMask(GL_TRUE);
}

} // namespace isoscope
