// How a view travels as JSON.
#include "scene/camera.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace isoscope {
namespace {

using nlohmann::json;

bool read_numbers(const json& object, const char* key, std::size_t count, double* out) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array() || found->size() != count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(*found)[i].is_number()) return false;
    out[i] = (*found)[i].get<double>();
    if (!std::isfinite(out[i])) return false;
  }
  return true;
}

bool read_number(const json& object, const char* key, double lo, double hi, double& out) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return false;
  out = found->get<double>();
  return out > lo && out < hi;
}

} // namespace

std::string to_json(const CameraPose& pose) {
  json object;
  object["target"] = {pose.target.x, pose.target.y, pose.target.z};
  object["distance"] = pose.distance;
  object["orientation"] = pose.orientation;
  object["fov"] = pose.fov;
  object["orthographic"] = pose.orthographic;
  return object.dump();
}

std::optional<CameraPose> camera_from_json(const std::string& text) {
  const json object = json::parse(text, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  CameraPose pose;
  std::array<double, 3> target{};
  if (!read_numbers(object, "target", 3, target.data())) return std::nullopt;
  if (!read_numbers(object, "orientation", 4, pose.orientation.data())) return std::nullopt;
  if (!read_number(object, "distance", 0, 1e300, pose.distance)) return std::nullopt;
  if (!read_number(object, "fov", 0, 179, pose.fov)) return std::nullopt;
  pose.target = {target[0], target[1], target[2]};
  double norm = 0;
  for (const double q : pose.orientation) norm += q * q;
  if (std::abs(norm - 1) > 0.01) return std::nullopt;
  const auto orthographic = object.find("orthographic");
  pose.orthographic = orthographic != object.end() && orthographic->is_boolean() && orthographic->get<bool>();
  return pose;
}

} // namespace isoscope
