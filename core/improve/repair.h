// A collapse or a flip with repair as a pure function on a patch: the outcome is committed or forgotten.
#pragma once

#include "improve/change_box.h"
#include "improve/facet_orientation.h"
#include "improve/improver_verdict.h"
#include "improve/patch_moves.h"

#include <array>
#include <limits>
#include <optional>

namespace isoscope {

/// What every change of Z has to keep.
struct SurfaceRules {
  const InputSurface* input = nullptr;
  std::optional<OrientationTester> orientation; ///< when normals are preserved
  std::vector<Vec3> witnesses;                  ///< points of the regions deeper than δ
  std::optional<ChangeBox> box;                 ///< where Z may change; absent: everywhere

  /// Sampled distances up to here are worth a certificate.
  double sampled_limit() const { return 0.995 * input->delta(); }
};

/// How far a repair may go.
struct RepairOptions {
  int sweeps = 0;       ///< of relocations and flips over the patch; 0: the merged vertex alone is relocated
  int certificates = 8; ///< rounds of certificates, each of which adds the violating points to the samples
  /// What the largest d may be after two, three and four sweeps, as a share of what it has to come to.
  std::array<double, 3> funnel = impatient;
  /// In δ: flips whose new edge or facets have a larger d before their repair are given up.
  double most_flip_excess = 1.3;
  bool jointly = false; ///< all free vertices are relocated at once, not one after the other

  /// Gives up most repairs that will fail, and a few that would succeed.
  static constexpr std::array<double, 3> impatient{1.1, std::numeric_limits<double>::infinity(),
                                                   std::numeric_limits<double>::infinity()};
  /// Keeps those that begin far above and come down fast, as rings of vertices around a hole do.
  static constexpr std::array<double, 3> patient{1.3, 1.13, 1.05};
};

/// The outcome for the patch: accepted, or the first reason against it with its figures.
struct PatchVerdict : Refusal {
  using Corners = std::array<std::uint32_t, 3>;
  PatchVerdict() = default;
  PatchVerdict(const Refusal& refusal) : Refusal(refusal) {}
  PatchVerdict(const Refusal& refusal, const Corners& at) : Refusal(refusal), facet(at) {}
  std::optional<Corners> facet;   ///< the facet that the reason speaks of, local ids
  std::uint32_t points_added = 0; ///< samples that the failed check has added to the facets
  std::vector<RepairSweep> sweeps;
  std::uint32_t moved = 0, flipped = 0;
};

/// Merges b into a (local ids) at the target and repairs the patch until it is proven inside Ω. Everything is
/// checked but what needs the whole surface: intersections with facets outside of the patch, and whether the
/// rim stays covered.
PatchVerdict collapse_with_repair(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t a,
                                  std::uint32_t b, Vec3 target, const RepairOptions& options);
/// Whether flip_with_repair() is worth a try: there is such an edge, and the one that would replace it does
/// not begin too far above δ.
bool is_worth_a_flip(const SurfaceRules& rules, const FacetComplex& complex, std::uint32_t a, std::uint32_t b,
                     const RepairOptions& options);
/// Flips the edge ab (local ids) against the energy and repairs the patch without flipping it back; nothing
/// where the flip cannot be made or begins too far above δ. Everything is checked but the same. Of one that
/// fails in the end the reason alone is told, which may be any that holds.
std::optional<PatchVerdict> flip_with_repair(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t a,
                                             std::uint32_t b, const RepairOptions& options);
/// Relocates a free vertex (local id) and checks the patch; nothing when it is at its best place. Of one that
/// fails the same is told.
std::optional<PatchVerdict> relocate_vertex(const SurfaceRules& rules, SurfacePatch& patch, std::uint32_t v);
/// Certificates of the patch's changed facets and border edges, fold, orientation and witnesses.
PatchVerdict check_patch(const SurfaceRules& rules, SurfacePatch& patch);
/// The same where the reason matters alone: the first one that is found ends it, and the patch is of no use
/// then.
PatchVerdict check_briefly(const SurfaceRules& rules, SurfacePatch& patch);

} // namespace isoscope
