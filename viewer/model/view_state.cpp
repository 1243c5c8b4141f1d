// JSON of a view.
#include "model/view_state.h"

#include "model/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

using nlohmann::json;

json vector(Vec3 v) {
  return {v.x, v.y, v.z};
}

bool read(const json& object, const char* key, bool& out) {
  const auto found = object.find(key);
  if (found == object.end()) return true;
  if (!found->is_boolean()) return false;
  out = found->get<bool>();
  return true;
}

template <class Number> bool read(const json& object, const char* key, Number& out, double low, double high) {
  const auto found = object.find(key);
  if (found == object.end()) return true;
  if (!found->is_number()) return false;
  const double value = found->get<double>();
  if (!(value >= low && value <= high)) return false;
  out = static_cast<Number>(value);
  return true;
}

bool read(const json& object, const char* key, Vec3& out) {
  const auto found = object.find(key);
  if (found == object.end()) return true;
  if (!found->is_array() || found->size() != 3) return false;
  for (int i = 0; i < 3; ++i) {
    const json& entry = (*found)[static_cast<std::size_t>(i)];
    if (!entry.is_number() || !std::isfinite(entry.get<double>())) return false;
    out[i] = entry.get<double>();
  }
  return true;
}

template <class Enum> bool read_choice(const json& object, const char* key, Enum& out, int count) {
  int value = static_cast<int>(out);
  if (!read(object, key, value, 0, count - 1)) return false;
  out = static_cast<Enum>(value);
  return true;
}

json filter_json(const TetFilter& f) {
  return {{"zero", f.carry_zero_set},
          {"violate_1", f.violate_1},
          {"violate_2", f.violate_2},
          {"violate_3", f.violate_3},
          {"changed", f.changed},
          {"all", f.all},
          {"box", f.box},
          {"recent", f.recent},
          {"shrink", f.shrink},
          {"sides", static_cast<int>(f.sides)}};
}

bool read_filter(const json& o, TetFilter& f) {
  return read(o, "zero", f.carry_zero_set) && read(o, "violate_1", f.violate_1) &&
         read(o, "violate_2", f.violate_2) && read(o, "violate_3", f.violate_3) &&
         read(o, "changed", f.changed) && read(o, "all", f.all) && read(o, "box", f.box) &&
         read(o, "recent", f.recent, 1, 1e6) && read(o, "shrink", f.shrink, 0.05, 1) &&
         read_choice(o, "sides", f.sides, 3);
}

json clip_json(const ClipSettings& c) {
  return {{"shape", static_cast<int>(c.shape)},
          {"mode", static_cast<int>(c.mode)},
          {"point", vector(c.point)},
          {"normal", vector(c.normal)},
          {"radius", c.radius},
          {"flipped", c.flipped}};
}

bool read_clip(const json& o, ClipSettings& c) {
  if (!(read_choice(o, "shape", c.shape, 4) && read_choice(o, "mode", c.mode, 3) &&
        read(o, "point", c.point) && read(o, "normal", c.normal) && read(o, "radius", c.radius, 0, 1e300) &&
        read(o, "flipped", c.flipped)))
    return false;
  if (squared_length(c.normal) == 0) return false;
  c.normal = normalized(c.normal);
  return true;
}

const json* part(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

} // namespace

std::string to_json(const ViewState& s) {
  json layers;
  for (const LayerName& layer : layer_names()) {
    const LayerSettings& l = s.view.*layer.member;
    layers[std::string(layer.name)] = {{"visible", l.visible}, {"opacity", l.opacity}};
  }
  json object;
  object["camera"] = json::parse(to_json(s.camera));
  object["layers"] = layers;
  object["tetrahedra"] = filter_json(s.view.tets);
  object["clip"] = clip_json(s.view.clip);
  object["mode"] = static_cast<int>(s.view.mode);
  object["zero_set_edges"] = s.view.zero_set_edges;
  object["sample_size"] = s.view.sample_size;
  object["side_tint"] = s.view.side_tint;
  object["invalid_regions"] = s.view.invalid_regions;
  object["octree_cells"] = s.view.octree_cells;
  object["section"] = {{"u", s.section.u}, {"v", s.section.v}, {"height", s.section.height}};
  return object.dump();
}

std::optional<ViewState> view_from_json(const std::string& text, const ViewState& base) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  ViewState s = base;
  bool any = false;
  const json* camera = part(object, "camera");
  if (camera != nullptr || object.contains("orientation")) {
    const auto pose = camera_from_json(camera ? camera->dump() : text);
    if (!pose) return std::nullopt;
    s.camera = *pose;
    any = true;
  }
  if (const json* layers = part(object, "layers")) {
    any = true;
    for (const LayerName& layer : layer_names())
      if (const json* l = part(*layers, std::string(layer.name).c_str())) {
        LayerSettings& out = s.view.*layer.member;
        if (!read(*l, "visible", out.visible) || !read(*l, "opacity", out.opacity, 0, 1)) return std::nullopt;
      }
  }
  if (const json* filter = part(object, "tetrahedra")) {
    any = true;
    if (!read_filter(*filter, s.view.tets)) return std::nullopt;
  }
  if (const json* clip = part(object, "clip")) {
    any = true;
    if (!read_clip(*clip, s.view.clip)) return std::nullopt;
  }
  if (const json* section = part(object, "section")) {
    any = true;
    if (!read(*section, "u", s.section.u, -1e300, 1e300) ||
        !read(*section, "v", s.section.v, -1e300, 1e300) ||
        !read(*section, "height", s.section.height, 1e-300, 1e300))
      return std::nullopt;
  }
  if (!read_choice(object, "mode", s.view.mode, 3) ||
      !read(object, "zero_set_edges", s.view.zero_set_edges) ||
      !read(object, "side_tint", s.view.side_tint) ||
      !read(object, "invalid_regions", s.view.invalid_regions) ||
      !read(object, "octree_cells", s.view.octree_cells) ||
      !read(object, "sample_size", s.view.sample_size, 1, 30))
    return std::nullopt;
  any = any || object.contains("mode");
  return any ? std::optional(s) : std::nullopt;
}

} // namespace isoscope
