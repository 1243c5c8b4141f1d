// What the settings of a view say of each of their fields, once: view files and scripts visit them.
#pragma once

#include "scene/view_settings.h"

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>

namespace isoscope {

template <class S, class T> struct ViewField {
  std::string_view key;    ///< in view files; empty: it belongs to the window, not to a view
  std::string_view script; ///< in scripts
  std::string_view help;   ///< in scripts
  T S::*member = nullptr;
  double low = 0, high = 1;                     ///< of a number
  std::span<const std::string_view> words = {}; ///< of an enumeration, in its order; files hold its number
};

namespace view_words {
using namespace std::string_view_literals;
inline constexpr std::array shapes{"none"sv, "plane"sv, "slab"sv, "ball"sv};
inline constexpr std::array clip_modes{"cut"sv, "whole"sv, "straddle"sv};
inline constexpr std::array sides{"both"sv, "outer"sv, "inner"sv};
inline constexpr std::array moments{"both"sv, "before"sv, "after"sv};
inline constexpr std::array modes{"scene"sv, "section"sv, "split"sv};
inline constexpr std::array themes{"dark"sv, "light"sv, "paper"sv};
} // namespace view_words

/// The fields that are no layers and no parts of their own, in the order of the list of named values.
inline constexpr auto view_fields = [] {
  using V = ViewSettings;
  return std::tuple{
      ViewField<V, bool>{"zero_set_edges", "zero-edges", "edges of Z drawn", &V::zero_set_edges},
      ViewField<V, float>{"sample_size", "sample-size", "size of samples, pixels", &V::sample_size, 1, 30},
      ViewField<V, bool>{"side_tint", "side-tint", "tetrahedra in the colour of their side", &V::side_tint},
      ViewField<V, bool>{"focus", "focus",
                         "with an edge selected samples, Ω and changed tetrahedra step back", &V::focus},
      ViewField<V, Moment>{"moment", "moment", "which side of the operation is drawn", &V::moment, 0, 1,
                           view_words::moments},
      ViewField<V, bool>{"invalid_regions", "xray.psi", "Ψ drawn: where targets are known to fail",
                         &V::invalid_regions},
      ViewField<V, bool>{"octree_cells", "xray.cells", "cells of the octree search drawn", &V::octree_cells},
      ViewField<V, float>{"kernel_push", "xray.push",
                          "how far the planes of an empty kernel are pushed, of what they miss by",
                          &V::kernel_push},
      ViewField<V, bool>{"cost_ellipsoid", "xray.ellipsoid", "points of the same error as the target drawn",
                         &V::cost_ellipsoid},
      ViewField<V, bool>{"axes", "axes", "axes drawn", &V::axes},
      ViewField<V, bool>{"scale_bar", "scale-bar", "scale bar drawn", &V::scale_bar},
      ViewField<V, ViewMode>{"mode", "mode", "what the view shows", &V::mode, 0, 1, view_words::modes},
      ViewField<V, ThemeKind>{"", "theme", "colours", &V::theme, 0, 1, view_words::themes}};
}();

/// Of the filter of tetrahedra.
inline constexpr auto tet_fields = [] {
  using F = TetFilter;
  return std::tuple{
      ViewField<F, F::Sides>{"sides", "tets.sides", "tetrahedra of which sides, once Z is embedded",
                             &F::sides, 0, 1, view_words::sides},
      ViewField<F, bool>{"zero", "tets.zero", "tetrahedra that carry Z", &F::carry_zero_set},
      ViewField<F, bool>{"violate_1", "tets.violate-1", "tetrahedra that violate condition 1", &F::violate_1},
      ViewField<F, bool>{"violate_2", "tets.violate-2", "tetrahedra that violate condition 2", &F::violate_2},
      ViewField<F, bool>{"violate_3", "tets.violate-3", "tetrahedra that violate condition 3", &F::violate_3},
      ViewField<F, bool>{"changed", "tets.changed", "tetrahedra made by the last operations", &F::changed},
      ViewField<F, bool>{"all", "tets.all", "all tetrahedra", &F::all},
      ViewField<F, bool>{"box", "tets.box", "also those at the bounding box", &F::box},
      ViewField<F, std::uint32_t>{"recent", "tets.recent", "operations back that count as the last ones",
                                  &F::recent, 1, 1e6},
      ViewField<F, float>{"shrink", "tets.shrink", "display shrink of tetrahedra", &F::shrink, 0.05, 1}};
}();

/// Of the clip, but for its point and its normal.
inline constexpr auto clip_fields = [] {
  using C = ClipSettings;
  return std::tuple{ViewField<C, C::Shape>{"shape", "clip", "shape that cuts the scene", &C::shape, 0, 1,
                                           view_words::shapes},
                    ViewField<C, C::Mode>{"mode", "clip.mode", "what happens to cells at the cut", &C::mode,
                                          0, 1, view_words::clip_modes},
                    ViewField<C, bool>{"flipped", "clip.flip", "the other side is cut away", &C::flipped},
                    ViewField<C, double>{"radius", "clip.radius", "radius of the ball, half the slab",
                                         &C::radius, 1e-300, 1e300}};
}();

/// Calls visit(const ViewField<S, T>&) for each row of one of the lists.
template <class Fields, class Visit> constexpr void for_each_view_field(const Fields& fields, Visit&& visit) {
  std::apply([&](const auto&... each) { (visit(each), ...); }, fields);
}

} // namespace isoscope
