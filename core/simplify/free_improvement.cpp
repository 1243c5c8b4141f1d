// Translates between ids of the state and those of the improver's mesh.
#include "simplify/free_improvement.h"

#include "simplify/improver.h"

#include <limits>

namespace isoscope {

namespace {

Reason reason_of(ImproverVerdict::Reason reason) {
  switch (reason) {
  case ImproverVerdict::Reason::accepted:
    return Reason::minimax_placement;
  case ImproverVerdict::Reason::distance:
    return Reason::stays_above;
  case ImproverVerdict::Reason::certificate:
    return Reason::outside_tolerance;
  case ImproverVerdict::Reason::folded:
    return Reason::folded;
  case ImproverVerdict::Reason::orientation:
    return Reason::normals;
  case ImproverVerdict::Reason::witness:
    return Reason::witness_side;
  case ImproverVerdict::Reason::intersection:
    return Reason::intersection;
  case ImproverVerdict::Reason::connectivity:
    break;
  }
  return Reason::zero_link_condition;
}

EventKind kind_of(SurfaceChange::Kind kind) {
  switch (kind) {
  case SurfaceChange::Kind::collapse:
    return EventKind::collapse;
  case SurfaceChange::Kind::relaxation:
    return EventKind::relaxation;
  case SurfaceChange::Kind::repair:
    break;
  }
  return EventKind::repair;
}

/// The free Z as a mesh, with the way back.
struct Numbering {
  TriangleMesh mesh;
  std::vector<VertexId> vertices; ///< by vertex of the mesh
  std::vector<FacetId> facets;    ///< by facet of the mesh

  explicit Numbering(const Complex& complex) {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> number(complex.vertices.size(), none);
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      if (!complex.facets[f].alive()) continue;
      for (const VertexId v : complex.facets[f].v) number[v.index()] = 0;
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == none) continue;
      number[v] = static_cast<std::uint32_t>(vertices.size());
      vertices.push_back(VertexId(v));
      mesh.points.push_back(complex.vertices[v].position);
    }
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      const ZeroFacet& facet = complex.facets[f];
      if (!facet.alive()) continue;
      facets.push_back(FacetId(f));
      mesh.triangles.push_back(
          {number[facet.v[0].index()], number[facet.v[1].index()], number[facet.v[2].index()]});
    }
  }
};

/// Applies the improver's changes to the state and records them.
class Recording : public ImproverObserver {
 public:
  Recording(Complex& complex, const Numbering& numbering, double delta, StageLog& log)
      : complex_(complex), numbering_(numbering), delta_(delta), vertices_(numbering.vertices.size()),
        log_(log) {}

  bool accepted(const SurfaceChange& change, const ImproverVerdict& verdict) override {
    Delta delta;
    delta.facet_slots_before = static_cast<std::uint32_t>(complex_.facets.size());
    for (const auto& f : change.removed) delta.removed_facets.push_back(record(f));
    for (const auto& f : change.added) delta.added_facets.push_back(record(f));
    for (const auto& m : change.moves) delta.moves.push_back({vertex(m.vertex), m.before, m.after});
    for (const std::uint32_t v : change.killed_vertices) delta.killed_vertices.push_back(vertex(v));
    vertices_ -= change.killed_vertices.size();
    complex_.apply(delta);

    Event e = event(verdict);
    e.kind = kind_of(change.kind);
    e.reason = Reason::minimax_placement;
    if (change.kind == SurfaceChange::Kind::relaxation) {
      e.vertex = e.other = VertexId();
      e.count = verdict.moved;
    }
    StepFigures figures;
    figures.zero_set_vertices = static_cast<std::uint32_t>(vertices_);
    figures.smallest_height = std::numeric_limits<float>::infinity();
    log_.operation(e, std::move(delta), figures);
    return !log_.stopped();
  }

  bool rejected(const ImproverVerdict& verdict) override {
    Event e = event(verdict);
    e.kind = EventKind::rejection;
    e.reason = reason_of(verdict.reason);
    log_.event(e);
    return !log_.stopped();
  }

 private:
  Complex& complex_;
  const Numbering& numbering_;
  double delta_;
  std::size_t vertices_;
  StageLog& log_;

  VertexId vertex(std::uint32_t v) const { return numbering_.vertices[v]; }
  FacetRecord record(const SurfaceChange::Facet& f) const {
    return {numbering_.facets[f.slot], {vertex(f.v[0]), vertex(f.v[1]), vertex(f.v[2])}};
  }
  Event event(const ImproverVerdict& v) {
    Event e;
    e.vertex = vertex(v.a);
    e.other = vertex(v.b);
    e.point = v.target;
    e.value = v.value;
    e.limit = v.accepted() ? delta_ : v.limit;
    e.witness = v.witness;
    e.count = v.moved;
    if (!v.sweeps.empty()) e.detail = log_.repair(v.sweeps);
    return e;
  }
};

} // namespace

void improve_free_zero_set(Complex& complex, const EvaluationContext& context, int effort, StageLog& log) {
  Numbering numbering(complex);
  ImproverOptions options;
  options.effort = effort;
  options.preserve_normals = context.criteria.condition_3;
  options.shrink = context.criteria.shrink;
  Recording recording(complex, numbering, context.criteria.delta, log);
  improve(numbering.mesh, context.volume, context.nearest, options, log.control(), recording);
}

} // namespace isoscope
