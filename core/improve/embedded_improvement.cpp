// Z of T as the improver's mesh, and the log of what the improver does to it.
#include "improve/embedded_improvement.h"

#include "improve/improver_log.h"

#include <algorithm>

namespace isoscope {

namespace {

/// The embedded Z as a mesh, and the vertices of T that are its vertices.
struct EmbeddedMesh {
  TriangleMesh mesh;
  std::vector<VertexId> vertices; ///< ascending

  explicit EmbeddedMesh(const Complex& complex) {
    const ZeroSet z = extract_zero_set(complex);
    std::vector<std::uint32_t> number(complex.vertices.size(), 0);
    for (const auto& v : z.vertices) vertices.push_back(v.negative);
    std::sort(vertices.begin(), vertices.end());
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
      number[vertices[i].index()] = i;
      mesh.points.push_back(complex.position(vertices[i]));
    }
    const auto numbered = [&](std::uint32_t v) { return number[z.vertices[v].negative.index()]; };
    for (const auto& p : z.polygons)
      mesh.triangles.push_back({numbered(p.v[0]), numbered(p.v[1]), numbered(p.v[2])});
  }
};

class EmbeddedLog : public ImproverLog {
 public:
  EmbeddedLog(const LiveComplex& live, const Embedding& embedding, double delta, StageLog& log)
      : ImproverLog(delta, log), live_(live), embedding_(embedding) {}

 private:
  VertexId vertex(std::uint32_t v) const override { return embedding_.vertex(v); }
  /// The embedding has brought T there already.
  Delta follow(const SurfaceChange& change) override { return change.tetrahedra; }
  StepFigures figures() const override { return live_.step_figures(); }

  const LiveComplex& live_;
  const Embedding& embedding_;
};

} // namespace

ImproverOutcome improve_embedded_zero_set(LiveComplex& live, const EvaluationContext& context,
                                          const ImproverOptions& options,
                                          const std::function<void()>& make_room, StageLog& log) {
  EmbeddedMesh z(live.complex());
  Embedding embedding(live, std::move(z.vertices));
  EmbeddedLog recording(live, embedding, context.criteria.delta, log);
  const RoomInT room{embedding, [&] { return make_room(), !log.stopped(); }};
  return improve(z.mesh, context.volume, context.nearest, options, log.control(), recording, &room);
}

} // namespace isoscope
