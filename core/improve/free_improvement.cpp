// Translates between ids of the state and those of the improver's mesh.
#include "improve/free_improvement.h"

#include "improve/improver_log.h"

#include <limits>
#include <optional>

namespace isoscope {

namespace {

/// The free Z as a mesh, with the way back.
struct Numbering {
  TriangleMesh mesh;
  std::vector<VertexId> vertices; ///< by vertex of the mesh
  std::vector<FacetId> facets;    ///< by facet of the mesh

  /// With a box of those facets alone whose boxes meet it.
  explicit Numbering(const Complex& complex, const std::optional<ChangeBox>& box = std::nullopt) {
    constexpr std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t> number(complex.vertices.size(), none);
    const auto wanted = [&](const ZeroFacet& f) {
      const auto at = [&](std::size_t k) { return complex.vertices[f.v.at(k).index()].position; };
      return f.alive() && (!box || box_of(Triangle3{at(0), at(1), at(2)}).meets({box->lo, box->hi}));
    };
    for (std::size_t f = 0; f < complex.facets.size(); ++f) {
      if (!wanted(complex.facets[f])) continue;
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
      if (!wanted(facet)) continue;
      facets.push_back(FacetId(f));
      mesh.triangles.push_back(
          {number[facet.v[0].index()], number[facet.v[1].index()], number[facet.v[2].index()]});
      if (!complex.facet_labels.empty()) mesh.labels.push_back(complex.labels(facets.back()));
    }
  }
};

/// Applies the improver's changes to the state.
class FreeLog : public ImproverLog {
 public:
  /// `vertices`: of all of Z.
  FreeLog(Complex& complex, const Numbering& numbering, std::size_t vertices, double delta, StageLog& log)
      : ImproverLog(delta, log), complex_(complex), numbering_(numbering), vertices_(vertices) {}

 private:
  VertexId vertex(std::uint32_t v) const override { return numbering_.vertices[v]; }
  Delta follow(const SurfaceChange& change) override;
  StepFigures figures() const override {
    StepFigures figures;
    figures.zero_set_vertices = static_cast<std::uint32_t>(vertices_);
    figures.smallest_height = std::numeric_limits<float>::infinity();
    return figures;
  }
  FacetRecord record(const SurfaceChange::Facet& f) const {
    return {numbering_.facets[f.slot], {vertex(f.v[0]), vertex(f.v[1]), vertex(f.v[2])}};
  }

  Complex& complex_;
  const Numbering& numbering_;
  std::size_t vertices_;
};

Delta FreeLog::follow(const SurfaceChange& change) {
  Delta delta;
  delta.facet_slots_before = static_cast<std::uint32_t>(complex_.facets.size());
  for (const auto& f : change.removed) delta.removed_facets.push_back(record(f));
  for (const auto& f : change.added) delta.added_facets.push_back(record(f));
  for (const auto& m : change.moves) delta.moves.push_back({vertex(m.vertex), m.before, m.after});
  for (const std::uint32_t v : change.killed_vertices) delta.killed_vertices.push_back(vertex(v));
  vertices_ -= change.killed_vertices.size();
  complex_.apply(delta);
  return delta;
}

} // namespace

ImproverOutcome improve_free_zero_set(Complex& complex, const EvaluationContext& context,
                                      const ImproverOptions& options, StageLog& log) {
  Numbering numbering(complex);
  FreeLog recording(complex, numbering, numbering.vertices.size(), context.criteria.delta, log);
  return improve(numbering.mesh, context.volume, context.nearest, options, log.control(), recording);
}

void improve_free_piece(Complex& complex, const ImproverGround& ground, const ImproverOptions& options,
                        StageLog& log) {
  Numbering numbering(complex, ground.box);
  FreeLog recording(complex, numbering, Numbering(complex).vertices.size(), ground.delta, log);
  improve(numbering.mesh, ground, nullptr, options, log.control(), recording);
}

} // namespace isoscope
