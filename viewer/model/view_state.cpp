// JSON of a view.
#include "model/view_state.h"

#include "model/words.h"
#include "scene/view_fields.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

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

template <class Fields, class S> void write_fields(const Fields& fields, const S& s, json& object) {
  for_each_view_field(fields, [&]<class T>(const ViewField<S, T>& f) {
    if (f.key.empty()) return;
    if constexpr (std::is_enum_v<T>)
      object[std::string(f.key)] = static_cast<int>(s.*(f.member));
    else
      object[std::string(f.key)] = s.*(f.member);
  });
}

template <class Fields, class S> bool read_fields(const Fields& fields, const json& object, S& s) {
  bool sound = true;
  for_each_view_field(fields, [&]<class T>(const ViewField<S, T>& f) {
    if (!sound || f.key.empty()) return;
    const std::string key(f.key);
    if constexpr (std::is_enum_v<T>) {
      int value = static_cast<int>(s.*(f.member));
      sound = read(object, key.c_str(), value, 0, static_cast<double>(f.words.size()) - 1);
      s.*(f.member) = static_cast<T>(value);
    } else if constexpr (std::is_same_v<T, bool>) {
      sound = read(object, key.c_str(), s.*(f.member));
    } else {
      sound = read(object, key.c_str(), s.*(f.member), f.low, f.high);
    }
  });
  return sound;
}

bool read_clip(const json& o, ClipSettings& c) {
  if (!read_fields(clip_fields, o, c) || !read(o, "point", c.point) || !read(o, "normal", c.normal) ||
      squared_length(c.normal) == 0)
    return false;
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
  json object, filter, clip{{"point", vector(s.view.clip.point)}, {"normal", vector(s.view.clip.normal)}};
  write_fields(view_fields, s.view, object);
  write_fields(tet_fields, s.view.tets, filter);
  write_fields(clip_fields, s.view.clip, clip);
  object["camera"] = json::parse(to_json(s.camera));
  object["layers"] = layers;
  object["tetrahedra"] = filter;
  object["clip"] = clip;
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
    if (!read_fields(tet_fields, *filter, s.view.tets)) return std::nullopt;
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
  if (!read_fields(view_fields, object, s.view)) return std::nullopt;
  any = any || object.contains("mode");
  return any ? std::optional(s) : std::nullopt;
}

} // namespace isoscope
