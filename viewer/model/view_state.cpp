// JSON of a view.
#include "model/view_state.h"

#include "base/fields_json.h"
#include "model/words.h"
#include "scene/view_fields.h"

#include <cmath>
#include <string>

namespace isoscope {

constexpr auto fields_of(const Renderer::SectionView*) {
  using S = Renderer::SectionView;
  return std::tuple{field(&S::u, {.name = "u", .range = {.low = -1e300, .high = 1e300}}),
                    field(&S::v, {.name = "v", .range = {.low = -1e300, .high = 1e300}}),
                    field(&S::height, {.name = "height", .range = {.low = 1e-300, .high = 1e300}})};
}

namespace {

using nlohmann::json;

json vector(Vec3 v) {
  return {v.x, v.y, v.z};
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

template <class S> json written(const S& s) {
  json object = json::object();
  for_each_field<S>([&](const auto& f) {
    if (!f.name.empty()) write_field(object, f, s.*(f.member));
  });
  return object;
}

/// Reads the fields that are there; false where one is not what it may be.
template <class S> bool read_part(const json& object, S& s) {
  bool sound = true;
  try {
    for_each_field<S>([&](const auto& f) {
      auto& place = s.*(f.member);
      if (f.name.empty() || !object.contains(f.name)) return;
      read_member(object, f, place);
      sound &= check_field(f, {}, place).ok();
    });
  } catch (const json::exception&) {
    return false;
  }
  return sound;
}

bool read_clip(const json& o, ClipSettings& c) {
  if (!read_part(o, c) || !read(o, "point", c.point) || !read(o, "normal", c.normal) ||
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
  json object = written(s.view);
  for (const LayerName& layer : layer_names())
    object["layers"][std::string(layer.name)] = written(s.view.*layer.member);
  object["camera"] = json::parse(to_json(s.camera));
  object["tetrahedra"] = written(s.view.tets);
  object["clip"] = written(s.view.clip);
  object["clip"]["point"] = vector(s.view.clip.point);
  object["clip"]["normal"] = vector(s.view.clip.normal);
  object["section"] = written(s.section);
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
  const auto read_parts = [&](const char* name, const auto& read) {
    const json* const found = part(object, name);
    any = any || found != nullptr;
    return found == nullptr || read(*found);
  };
  const auto read_layers = [&](const json& layers) {
    for (const LayerName& layer : layer_names())
      if (const json* l = part(layers, std::string(layer.name).c_str());
          l != nullptr && !read_part(*l, s.view.*layer.member))
        return false;
    return true;
  };
  if (!read_parts("layers", read_layers) ||
      !read_parts("tetrahedra", [&](const json& o) { return read_part(o, s.view.tets); }) ||
      !read_parts("clip", [&](const json& o) { return read_clip(o, s.view.clip); }) ||
      !read_parts("section", [&](const json& o) { return read_part(o, s.section); }) ||
      !read_part(object, s.view))
    return std::nullopt;
  any = any || object.contains("mode");
  return any ? std::optional(s) : std::nullopt;
}

} // namespace isoscope
