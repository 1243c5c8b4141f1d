// The table of named values.
#include "command/named_values.h"

#include "command/named_table.h"
#include "model/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace isoscope {
namespace {

using Table = NamedTable;

Error wrong(const std::string& text, const std::string& wanted) {
  return {ErrorCode::usage, "\"" + text + "\" is not " + wanted + ".", ""};
}

template <class Get>
void add_number(Table& t, std::string name, std::string help, Get get, double low, double high) {
  t.push_back({std::move(name), std::move(help),
               [get](const AppModel& m) { return text_of(static_cast<double>(get(m))); },
               [get, low, high](AppModel& m, const std::string& text) -> Status {
                 const auto number = parse_number(text);
                 if (!number) return number.error();
                 if (*number < low || *number > high)
                   return wrong(text, "between " + text_of(low) + " and " + text_of(high));
                 auto& place = get(m);
                 place = static_cast<std::remove_reference_t<decltype(place)>>(*number);
                 return {};
               }});
}

template <class Get> void add_switch(Table& t, std::string name, std::string help, Get get) {
  t.push_back({std::move(name), std::move(help),
               [get](const AppModel& m) { return std::string(get(m) ? "on" : "off"); },
               [get](AppModel& m, const std::string& text) -> Status {
                 const auto on = parse_switch(text);
                 if (!on) return on.error();
                 get(m) = *on;
                 return {};
               }});
}

template <class Get>
void add_choice(Table& t, std::string name, std::string help, std::vector<std::string> words, Get get) {
  t.push_back({std::move(name), std::move(help),
               [get, words](const AppModel& m) { return words.at(static_cast<std::size_t>(get(m))); },
               [get, words](AppModel& m, const std::string& text) -> Status {
                 const auto found = std::find(words.begin(), words.end(), text);
                 if (found == words.end()) {
                   std::string all;
                   for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
                   return wrong(text, "one of " + all);
                 }
                 auto& place = get(m);
                 place = static_cast<std::remove_reference_t<decltype(place)>>(found - words.begin());
                 return {};
               }});
}

void add_parameters(Table& t) {
  for (NamedField<RunParameters>& f : named_fields<RunParameters>())
    t.push_back(
        {std::move(f.name), std::move(f.help),
         [get = std::move(f.get)](const AppModel& m) { return get(m.draft); },
         [set = std::move(f.set)](AppModel& m, const std::string& text) { return set(m.draft, text); }});
}

Status set_normal(AppModel& m, const std::string& text) {
  Vec3 normal;
  if (text.size() == 1 && text[0] >= 'x' && text[0] <= 'z') {
    normal[text[0] - 'x'] = 1;
  } else {
    std::istringstream parts(text);
    std::string part;
    int count = 0;
    for (; std::getline(parts, part, ','); ++count) {
      const auto number = parse_number(part);
      if (!number || count > 2) return wrong(text, "x, y, z or three numbers");
      normal[count] = *number;
    }
    if (count != 3 || squared_length(normal) == 0) return wrong(text, "x, y, z or three numbers");
  }
  m.view.clip.normal = normalized(normal);
  return {};
}

void add_view(Table& t) {
  for (const LayerName& layer : layer_names()) {
    const auto member = layer.member;
    const std::string name = "layer." + std::string(layer.name);
    add_switch(
        t, name,
        std::string(layer.title) + " shown", [member](auto& m) -> auto& { return (m.view.*member).visible; });
    add_number(
        t, name + ".opacity", std::string(layer.title) + ", opacity",
        [member](auto& m) -> auto& { return (m.view.*member).opacity; }, 0, 1);
  }
  add_switch(
      t, "zero-edges", "edges of Z drawn", [](auto& m) -> auto& { return m.view.zero_set_edges; });
  add_number(
      t, "sample-size", "size of samples, pixels", [](auto& m) -> auto& { return m.view.sample_size; }, 1,
      30);
  add_switch(
      t, "side-tint", "tetrahedra in the colour of their side",
      [](auto& m) -> auto& { return m.view.side_tint; });
  add_switch(
      t, "focus", "with an edge selected samples, Ω and changed tetrahedra step back",
      [](auto& m) -> auto& { return m.view.focus; });
  add_choice(
      t, "moment", "which side of the operation is drawn", {"both", "before", "after"},
      [](auto& m) -> auto& { return m.view.moment; });
  add_choice(
      t, "tets.sides", "tetrahedra of which sides, once Z is embedded", {"both", "outer", "inner"},
      [](auto& m) -> auto& { return m.view.tets.sides; });
  add_choice(
      t, "xray.target", "which targets the X-ray looks for", {"automatic", "halfedge", "general", "octree"},
      [](auto& m) -> auto& { return m.selection.target; });
  add_switch(
      t, "xray.psi", "Ψ drawn: where targets are known to fail",
      [](auto& m) -> auto& { return m.view.invalid_regions; });
  add_switch(
      t, "xray.cells", "cells of the octree search drawn",
      [](auto& m) -> auto& { return m.view.octree_cells; });
  add_number(
      t, "xray.push", "how far the planes of an empty kernel are pushed, of what they miss by",
      [](auto& m) -> auto& { return m.view.kernel_push; }, 0, 1);
  add_switch(
      t, "xray.ellipsoid", "points of the same error as the target drawn",
      [](auto& m) -> auto& { return m.view.cost_ellipsoid; });
  add_choice(
      t, "plots.over", "what plots are drawn over", {"steps", "seconds"},
      [](auto& m) -> auto& { return m.plot_time; });
  add_switch(
      t, "axes", "axes drawn", [](auto& m) -> auto& { return m.view.axes; });
  add_switch(
      t, "scale-bar", "scale bar drawn", [](auto& m) -> auto& { return m.view.scale_bar; });
  const auto filter = [&](const char* name, const char* help, bool TetFilter::*member) {
    add_switch(
        t, std::string("tets.") + name, help, [member](auto& m) -> auto& { return m.view.tets.*member; });
  };
  filter("zero", "tetrahedra that carry Z", &TetFilter::carry_zero_set);
  filter("violate-1", "tetrahedra that violate condition 1", &TetFilter::violate_1);
  filter("violate-2", "tetrahedra that violate condition 2", &TetFilter::violate_2);
  filter("violate-3", "tetrahedra that violate condition 3", &TetFilter::violate_3);
  filter("changed", "tetrahedra made by the last operations", &TetFilter::changed);
  filter("all", "all tetrahedra", &TetFilter::all);
  filter("box", "also those at the bounding box", &TetFilter::box);
  add_number(
      t, "tets.recent", "operations back that count as the last ones",
      [](auto& m) -> auto& { return m.view.tets.recent; }, 1, 100000);
  add_number(
      t, "tets.shrink", "display shrink of tetrahedra", [](auto& m) -> auto& { return m.view.tets.shrink; },
      0.05, 1);
  add_choice(
      t, "clip", "shape that cuts the scene", {"none", "plane", "slab", "ball"},
      [](auto& m) -> auto& { return m.view.clip.shape; });
  add_choice(
      t, "clip.mode", "what happens to cells at the cut", {"cut", "whole", "straddle"},
      [](auto& m) -> auto& { return m.view.clip.mode; });
  add_switch(
      t, "clip.flip", "the other side is cut away", [](auto& m) -> auto& { return m.view.clip.flipped; });
  add_number(
      t, "clip.radius", "radius of the ball, half the slab",
      [](auto& m) -> auto& { return m.view.clip.radius; }, 1e-12, 1e12);
  const std::array<const char*, 3> axis{"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const std::string name = axis[static_cast<std::size_t>(i)];
    add_number(
        t, "clip." + name, "a point of the clip",
        [i](auto& m) -> decltype(auto) { return m.view.clip.point[i]; }, -1e12, 1e12);
  }
  t.push_back({"clip.normal", "the clip's normal: x, y, z, or three numbers as 1,0.5,0",
               [](const AppModel& m) {
                 const Vec3 n = m.view.clip.normal;
                 return text_of(n.x) + "," + text_of(n.y) + "," + text_of(n.z);
               },
               set_normal});
  add_choice(
      t, "mode", "what the view shows", {"scene", "section", "split"},
      [](auto& m) -> auto& { return m.view.mode; });
  add_choice(
      t, "theme", "colours", {"dark", "light", "paper"}, [](auto& m) -> auto& { return m.view.theme; });
  add_number(
      t, "ui-scale", "size of the interface", [](auto& m) -> auto& { return m.settings.ui_scale; }, 0.5, 4);
}

Table make_table() {
  Table t;
  add_parameters(t);
  add_view(t);
  add_readings(t);
  add_edge_readings(t);
  add_debug_readings(t);
  add_recording_readings(t);
  add_questions(t);
  add_comparison(t);
  add_slide_values(t);
  add_export_values(t);
  add_time_readings(t);
  return t;
}

bool compare(double a, const std::string& op, double b) {
  if (op == "==") return a == b;
  if (op == "!=") return a != b;
  if (op == "<") return a < b;
  if (op == "<=") return a <= b;
  if (op == ">") return a > b;
  return a >= b;
}

Status judge(const AppModel& model, const std::string& name, const std::string& op, const std::string& word) {
  static constexpr std::array<std::string_view, 6> operators{"==", "!=", "<", "<=", ">", ">="};
  const NamedValue* value = find_value(name);
  if (value == nullptr) return wrong(name, "a value that has a name (F1 lists them)");
  if (std::find(operators.begin(), operators.end(), op) == operators.end())
    return wrong(op, "== != < <= > or >=");
  const std::string found = value->get(model);
  const NamedValue* other = find_value(word);
  const std::string wanted = other != nullptr ? other->get(model) : word;
  const auto a = parse_number(found), b = parse_number(wanted);
  const bool numbers = a.ok() && b.ok();
  if (!numbers && op != "==" && op != "!=") return wrong(wanted, "a number (" + name + " is " + found + ")");
  const bool holds = numbers ? compare(*a, op, *b) : (found == wanted) == (op == "==");
  if (holds) return {};
  return Error{ErrorCode::internal, name + " is " + found + ", expected " + op + " " + wanted + ".", ""};
}

} // namespace

std::span<const NamedValue> named_values() {
  static const Table table = make_table();
  return table;
}

const NamedValue* find_value(std::string_view name) {
  for (const NamedValue& value : named_values())
    if (value.name == name) return &value;
  return nullptr;
}

Result<double> parse_number(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || at != end || !std::isfinite(value)) return wrong(text, "a finite number");
  return value;
}

Result<bool> parse_switch(const std::string& text) {
  if (text == "on" || text == "true" || text == "1") return true;
  if (text == "off" || text == "false" || text == "0") return false;
  return wrong(text, "on or off");
}

Status expect(const AppModel& model, const std::string& expression) {
  std::istringstream words(expression);
  std::string name, op, wanted, joint;
  while (true) {
    if (!(words >> name >> op >> std::quoted(wanted)))
      return Error{ErrorCode::usage, "Expected NAME OP VALUE in \"" + expression + "\".",
                   "For example: bad_samples == 0"};
    if (Status s = judge(model, name, op, wanted); !s) return s;
    if (!(words >> joint)) return {};
    if (joint != "and") return wrong(joint, "\"and\"");
  }
}

} // namespace isoscope
