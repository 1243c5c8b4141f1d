// Each bound to its place.
#include "view/view_values.h"

#include "model/words.h"

#include <array>
#include <sstream>

namespace isoscope {
namespace {

Status set_normal(WindowState& m, const std::string& text) {
  Vec3 normal;
  if (text.size() == 1 && text[0] >= 'x' && text[0] <= 'z') {
    normal[text[0] - 'x'] = 1;
  } else {
    std::istringstream parts(text);
    std::string part;
    int count = 0;
    for (; std::getline(parts, part, ','); ++count) {
      const auto number = parse_number(part);
      if (!number || count > 2) return wrong_value(text, "x, y, z or three numbers");
      normal[count] = *number;
    }
    if (count != 3 || squared_length(normal) == 0) return wrong_value(text, "x, y, z or three numbers");
  }
  m.view.clip.normal = normalized(normal);
  return {};
}

} // namespace

void add_view_values(NamedValues& t, WindowState& m) {
  for (const LayerName& layer : layer_names()) {
    const auto member = layer.member;
    const std::string name = "layer." + std::string(layer.name);
    t.add_switch(name, std::string(layer.title) + " shown", (m.view.*member).visible);
    t.add_number(name + ".opacity", std::string(layer.title) + ", opacity", (m.view.*member).opacity, 0, 1);
  }
  t.add_switch("zero-edges", "edges of Z drawn", m.view.zero_set_edges);
  t.add_number("sample-size", "size of samples, pixels", m.view.sample_size, 1, 30);
  t.add_switch("side-tint", "tetrahedra in the colour of their side", m.view.side_tint);
  t.add_switch("focus", "with an edge selected samples, Ω and changed tetrahedra step back", m.view.focus);
  t.add_choice("moment", "which side of the operation is drawn", {"both", "before", "after"}, m.view.moment);
  t.add_choice("tets.sides", "tetrahedra of which sides, once Z is embedded", {"both", "outer", "inner"},
               m.view.tets.sides);
  t.add_choice("xray.target", "which targets the X-ray looks for",
               {"automatic", "halfedge", "general", "octree"}, m.selection.target);
  t.add_switch("xray.psi", "Ψ drawn: where targets are known to fail", m.view.invalid_regions);
  t.add_switch("xray.cells", "cells of the octree search drawn", m.view.octree_cells);
  t.add_number("xray.push", "how far the planes of an empty kernel are pushed, of what they miss by",
               m.view.kernel_push, 0, 1);
  t.add_switch("xray.ellipsoid", "points of the same error as the target drawn", m.view.cost_ellipsoid);
  t.add_choice("plots.over", "what plots are drawn over", {"steps", "seconds"}, m.plot_time);
  t.add_switch("axes", "axes drawn", m.view.axes);
  t.add_switch("scale-bar", "scale bar drawn", m.view.scale_bar);
  const auto filter = [&](const char* name, const char* help, bool TetFilter::*member) {
    t.add_switch(std::string("tets.") + name, help, m.view.tets.*member);
  };
  filter("zero", "tetrahedra that carry Z", &TetFilter::carry_zero_set);
  filter("violate-1", "tetrahedra that violate condition 1", &TetFilter::violate_1);
  filter("violate-2", "tetrahedra that violate condition 2", &TetFilter::violate_2);
  filter("violate-3", "tetrahedra that violate condition 3", &TetFilter::violate_3);
  filter("changed", "tetrahedra made by the last operations", &TetFilter::changed);
  filter("all", "all tetrahedra", &TetFilter::all);
  filter("box", "also those at the bounding box", &TetFilter::box);
  t.add_number("tets.recent", "operations back that count as the last ones", m.view.tets.recent, 1, 100000);
  t.add_number("tets.shrink", "display shrink of tetrahedra", m.view.tets.shrink, 0.05, 1);
  t.add_choice("clip", "shape that cuts the scene", {"none", "plane", "slab", "ball"}, m.view.clip.shape);
  t.add_choice("clip.mode", "what happens to cells at the cut", {"cut", "whole", "straddle"},
               m.view.clip.mode);
  t.add_switch("clip.flip", "the other side is cut away", m.view.clip.flipped);
  t.add_number("clip.radius", "radius of the ball, half the slab", m.view.clip.radius, 1e-12, 1e12);
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string name = axis[static_cast<std::size_t>(i)];
    t.add_number("clip." + name, "a point of the clip", m.view.clip.point[i], -1e12, 1e12);
  }
  t.add(
      "clip.normal", "the clip's normal: x, y, z, or three numbers as 1,0.5,0",
      [&m] {
        const Vec3 n = m.view.clip.normal;
        return text_of(n.x) + "," + text_of(n.y) + "," + text_of(n.z);
      },
      [&m](const std::string& text) { return set_normal(m, text); });
  t.add_choice("mode", "what the view shows", {"scene", "section", "split"}, m.view.mode);
  t.add_choice("theme", "colours", {"dark", "light", "paper"}, m.view.theme);
  t.add_number("ui-scale", "size of the interface", m.settings.ui_scale, 0.5, 4);
}

} // namespace isoscope
