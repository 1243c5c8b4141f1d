// Z while it is improved: gives out patches, tests them against the rest and commits them.
#pragma once

#include "base/run_control.h"
#include "improve/embedding.h"
#include "improve/facet_octree.h"
#include "improve/improver_verdict.h"
#include "improve/repair.h"

#include <optional>

namespace isoscope {

/// A surface as a mesh without gaps.
TriangleMesh compacted(const FacetComplex& complex);

/// The whole surface. Reading is thread-safe; commits are for one thread.
class LiveSurface {
 public:
  /// Copies an oriented 2-manifold without intersections, inside Ω, and measures its facets. Its border keeps
  /// to the input's rim, if it has one. With labels it is one between rooms: sheets that meet along curves,
  /// which stay what they are; where they end nothing moves. A piece that the rules give a box has all facets
  /// whose boxes meet that, and ends outside of it. With an embedding, whose Z the mesh is, patches hold
  /// their part of T, and commits reach it. Once the control is cancelled facets are not measured: then only
  /// what the mesh was is of use.
  LiveSurface(const TriangleMesh& mesh, const SurfaceRules& rules, Embedding* embedding = nullptr,
              const RunControl& control = {});

  const FacetComplex& complex() const { return complex_; }
  std::size_t vertex_count() const { return vertex_count_; }
  /// Number of the last commit that changed a facet at v; 0 before the first.
  std::uint32_t stamp(std::uint32_t v) const { return stamps_[v]; }
  /// The same for the last collapse, with or without repair.
  std::uint32_t collapse_stamp(std::uint32_t v) const { return collapse_stamps_[v]; }
  std::uint32_t commits() const { return commits_; }
  const Embedding* embedding() const { return embedding_; }
  /// Whether a vertex stays where it is, with all its edges: a facet of it is not wholly in the box of the
  /// rules.
  bool frozen(std::uint32_t v) const { return !frozen_.empty() && frozen_[v] != 0; }
  /// Whether the facets between these vertices may change.
  bool may_change(std::span<const std::uint32_t> vertices) const;

  /// Takes all facets around the free vertices (ascending) that are not frozen.
  SurfacePatch patch(std::span<const std::uint32_t> free_vertices) const;
  /// Takes the two facets of a flip with all vertices fixed; nothing where T has no tetrahedron for it.
  std::optional<SurfacePatch> flip_patch(const FlipPlan& plan) const;

  /// Why a patch cannot be committed as the surface is now: a facet elsewhere that would be met (exact), or a
  /// vertex that would be left with too few facets, or a part of the rim that the border would leave. The
  /// patch's own facets must be as they were taken.
  Refusal check(const SurfacePatch& patch) const;
  /// Whether the patch's facets and vertices are still as they were taken.
  bool up_to_date(const SurfacePatch& patch) const;
  /// Takes the patch over; both checks must have passed.
  SurfaceChange commit(const SurfacePatch& patch, EventKind kind);
  /// Notes that T has changed around these vertices without a change of Z: what failed there may be tried
  /// again.
  void room_changed(std::span<const std::uint32_t> vertices);
  TriangleMesh compacted() const { return isoscope::compacted(complex_); }

 private:
  /// Gives the samples of the rim to the nearest border edges, and measures these.
  void share_rim(const InputSurface& input);
  void freeze();
  Refusal check_rim(const SurfacePatch& patch) const;

  Embedding* embedding_;
  const BorderGate* gate_; ///< null where the surface is closed
  FacetComplex complex_;
  FacetOctree octree_;
  std::optional<ChangeBox> box_;
  std::vector<std::uint8_t> frozen_;                    ///< by vertex; empty: none is
  std::vector<std::uint32_t> stamps_, collapse_stamps_; ///< by vertex
  std::uint32_t commits_ = 0;
  std::size_t vertex_count_ = 0;
};

/// What turned one state of a surface into another: for sweeps of many small commits.
SurfaceChange difference(const FacetComplex& before, const FacetComplex& after, EventKind kind);

} // namespace isoscope
