// What the settings of a view say of each of their fields, once: view files and scripts visit them.
// A field without a name in files belongs to the window, not to a view. What an enumeration is called in
// scripts stands in its order; files hold its number.
#pragma once

#include "base/fields.h"
#include "scene/view_settings.h"

#include <array>
#include <span>
#include <string_view>
#include <tuple>

namespace isoscope {

namespace view_words {
inline constexpr std::array<Choice, 4> shapes{{{"none"}, {"plane"}, {"slab"}, {"ball"}}};
inline constexpr std::array<Choice, 3> clip_modes{{{"cut"}, {"whole"}, {"straddle"}}};
inline constexpr std::array<Choice, 3> sides{{{"both"}, {"outer"}, {"inner"}}};
inline constexpr std::array<Choice, 3> moments{{{"both"}, {"before"}, {"after"}}};
inline constexpr std::array<Choice, 3> modes{{{"scene"}, {"section"}, {"split"}}};
inline constexpr std::array<Choice, 5> zero_maps{{{"none"}, {"distance"}, {"normals"}, {"valence"}, {"age"}}};
inline constexpr std::array<Choice, 3> themes{{{"dark"}, {"light"}, {"paper"}}};

constexpr FieldFacts plain(std::string_view name, std::string_view script, std::string_view words) {
  return {.name = name, .script = script, .words = words};
}
constexpr FieldFacts number(std::string_view name, std::string_view script, std::string_view words,
                            double low, double high) {
  return {.name = name, .script = script, .words = words, .range = {.low = low, .high = high}};
}
constexpr FieldFacts choice(std::string_view name, std::string_view script, std::string_view words,
                            std::span<const Choice> choices) {
  return {.name = name, .script = script, .words = words, .choices = choices, .ordinal = true};
}
} // namespace view_words

/// Those that are no layers and no parts of their own, in the order of the list of named values.
constexpr auto fields_of(const ViewSettings*) {
  using namespace view_words;
  using V = ViewSettings;
  return std::tuple{
      field(&V::zero_set_edges, plain("zero_set_edges", "zero-edges", "edges of Z drawn")),
      field(&V::zero_map, choice("zero_map", "colour-by", "what Z is coloured by", zero_maps)),
      field(&V::legend, plain("legend", "legend", "legend of the scene in view and pictures")),
      field(&V::sample_size, number("sample_size", "sample-size", "size of samples, pixels", 1, 30)),
      field(&V::near_samples,
            plain("near_samples", "samples.near", "good samples in 3D only around the current operation")),
      field(&V::side_tint, plain("side_tint", "side-tint", "tetrahedra in the colour of their side")),
      field(&V::focus,
            plain("focus", "focus", "with an edge selected samples, Ω and changed tetrahedra step back")),
      field(&V::haze_outer,
            number("haze_outer", "haze.outer", "haze in Ω at its outer boundary, optical depth of δ", 0, 4)),
      field(&V::haze_middle,
            number("haze_middle", "haze.middle", "haze in Ω at the input, optical depth of δ", 0, 4)),
      field(&V::haze_inner,
            number("haze_inner", "haze.inner", "haze in Ω at its inner boundary, optical depth of δ", 0, 4)),
      field(&V::moment, choice("moment", "moment", "which side of the operation is drawn", moments)),
      field(&V::invalid_regions,
            plain("invalid_regions", "xray.psi", "Ψ drawn: where targets are known to fail")),
      field(&V::octree_cells, plain("octree_cells", "xray.cells", "cells of the octree search drawn")),
      field(&V::kernel_push,
            number("kernel_push", "xray.push",
                   "how far the planes of an empty kernel are pushed, of what they miss by", 0, 1)),
      field(&V::cost_ellipsoid,
            plain("cost_ellipsoid", "xray.ellipsoid", "points of the same error as the target drawn")),
      field(&V::axes, plain("axes", "axes", "axes drawn")),
      field(&V::scale_bar, plain("scale_bar", "scale-bar", "scale bar drawn")),
      field(&V::clip_handle, plain("clip_handle", "clip.handle", "handle of the clip's plane in 3D")),
      field(&V::mode, choice("mode", "mode", "what the view shows", modes)),
      field(&V::theme, choice("", "theme", "colours", themes))};
}

/// Of the filter of tetrahedra.
constexpr auto fields_of(const TetFilter*) {
  using namespace view_words;
  using F = TetFilter;
  return std::tuple{
      field(&F::sides, choice("sides", "tets.sides", "tetrahedra of which sides, once Z is embedded",
                              view_words::sides)),
      field(&F::carry_zero_set, plain("zero", "tets.zero", "tetrahedra that carry Z")),
      field(&F::violate_1, plain("violate_1", "tets.violate-1", "tetrahedra that violate condition 1")),
      field(&F::violate_2, plain("violate_2", "tets.violate-2", "tetrahedra that violate condition 2")),
      field(&F::violate_3, plain("violate_3", "tets.violate-3", "tetrahedra that violate condition 3")),
      field(&F::changed, plain("changed", "tets.changed", "tetrahedra made by the last operations")),
      field(&F::all, plain("all", "tets.all", "all tetrahedra")),
      field(&F::box, plain("box", "tets.box", "also those at the bounding box")),
      field(&F::recent,
            number("recent", "tets.recent", "operations back that count as the last ones", 1, 1e6)),
      field(&F::shrink, number("shrink", "tets.shrink", "display shrink of tetrahedra", 0.05, 1))};
}

/// Of the clip, but for its point and its normal.
constexpr auto fields_of(const ClipSettings*) {
  using namespace view_words;
  using C = ClipSettings;
  return std::tuple{
      field(&C::shape, choice("shape", "clip", "shape that cuts the scene", shapes)),
      field(&C::mode, choice("mode", "clip.mode", "what happens to cells at the cut", clip_modes)),
      field(&C::flipped, plain("flipped", "clip.flip", "the other side is cut away")),
      field(&C::radius, number("radius", "clip.radius", "radius of the ball, half the slab", 1e-300, 1e300))};
}

/// Of a layer, for files; scripts name it before them.
constexpr auto fields_of(const LayerSettings*) {
  return std::tuple{field(&LayerSettings::visible, {.name = "visible"}),
                    field(&LayerSettings::opacity, {.name = "opacity", .range = {.low = 0, .high = 1}})};
}

} // namespace isoscope
