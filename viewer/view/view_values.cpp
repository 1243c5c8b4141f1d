// Each bound to its place.
#include "view/view_values.h"

#include "model/words.h"
#include "scene/view_fields.h"

#include <array>
#include <sstream>
#include <type_traits>

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

template <class Fields, class S> void add_fields(NamedValues& t, const Fields& fields, S& settings) {
  for_each_view_field(fields, [&]<class T>(const ViewField<S, T>& f) {
    const std::string name(f.script), help(f.help);
    T& place = settings.*(f.member);
    if constexpr (std::is_enum_v<T>)
      t.add_choice(name, help, {f.words.begin(), f.words.end()}, place);
    else if constexpr (std::is_same_v<T, bool>)
      t.add_switch(name, help, place);
    else
      t.add_number(name, help, place, f.low, f.high);
  });
}

} // namespace

void add_view_values(NamedValues& t, WindowState& m) {
  for (const LayerName& layer : layer_names()) {
    const auto member = layer.member;
    const std::string name = "layer." + std::string(layer.name);
    t.add_switch(name, std::string(layer.title) + " shown", (m.view.*member).visible);
    t.add_number(name + ".opacity", std::string(layer.title) + ", opacity", (m.view.*member).opacity, 0, 1);
  }
  add_fields(t, view_fields, m.view);
  add_fields(t, tet_fields, m.view.tets);
  add_fields(t, clip_fields, m.view.clip);
  t.add_choice("xray.target", "which targets the X-ray looks for",
               {"automatic", "halfedge", "general", "octree"}, m.selection.target);
  t.add_choice("plots.over", "what plots are drawn over", {"steps", "seconds"}, m.plot_time);
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
  t.add_number("ui-scale", "size of the interface", m.settings.ui_scale, 0.5, 4);
}

} // namespace isoscope
