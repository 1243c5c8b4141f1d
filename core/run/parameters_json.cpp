// One object; stages and strategies by name.
#include "run/parameters_json.h"

#include <nlohmann/json.hpp>

namespace isoscope {

namespace {

using Json = nlohmann::ordered_json;

std::optional<Stage> stage_of(const std::string& text) {
  for (int i = 0; i < stage_count; ++i)
    if (name(static_cast<Stage>(i)) == text) return static_cast<Stage>(i);
  return std::nullopt;
}

/// A whole number; throws on any other, which get() would cast.
std::int64_t whole(const Json& json) {
  return json.get_ref<const Json::number_integer_t&>();
}

void read_parameters(const Json& json, RunParameters& p) {
  p.input = json.value("input", p.input);
  p.tolerance.value = json.value("tolerance", p.tolerance.value);
  p.tolerance.percent = json.value("tolerance_percent", p.tolerance.percent);
  p.sigma = json.value("sigma", p.sigma);
  p.alpha = json.value("alpha", p.alpha);
  p.shrink = json.value("shrink", p.shrink);
  p.containment =
      json.value("containment", "certified") == "sampled" ? Containment::sampled : Containment::certified;
  p.topology = json.value("topology", "keep") == "separate" ? TopologyMode::separate : TopologyMode::keep;
  p.drop_thin = json.value("drop_thin", p.drop_thin);
  // Older recordings did not judge it.
  p.cover.reset();
  if (json.contains("cover") && !json.at("cover").is_null()) p.cover = json.at("cover").get<double>();
  p.sides = sides_mode(json.value("sides", std::string(name(p.sides)))).value_or(p.sides);
  const auto conditions = json.value("conditions", std::array<bool, 4>{true, true, true, true});
  p.condition_1 = conditions[0];
  p.condition_2 = conditions[1];
  p.condition_3 = conditions[2];
  p.condition_4 = conditions[3];
  if (json.contains("until")) p.until = stage_of(json.at("until").get<std::string>());
  for (const auto& skipped : json.value("skip", Json::array()))
    if (const auto stage = stage_of(skipped.get<std::string>()))
      p.skipped[static_cast<std::size_t>(*stage)] = true;
  const std::string target = json.value("target", std::string(name(p.target)));
  for (const TargetStrategy s : {TargetStrategy::optimum, TargetStrategy::constraints,
                                 TargetStrategy::sampling, TargetStrategy::octree})
    if (name(s) == target) p.target = s;
  p.cost_ring = whole(json.value("cost_ring", Json(1))) == 2 ? CostRing::two : CostRing::one;
  p.effort = static_cast<int>(whole(json.value("effort", Json(p.effort))));
  p.improver = json.value("improver", "free") == "embedded" ? ImproverPlace::embedded : ImproverPlace::free;
  p.drop_small = json.value("drop_small", p.drop_small);
  p.threads = static_cast<unsigned>(whole(json.value("threads", Json(p.threads))));
  p.time_limit = json.value("time_limit", p.time_limit);
  p.memory_limit = json.value("memory_limit", p.memory_limit);
}

} // namespace

std::string parameters_json(const RunParameters& p) {
  Json skipped = Json::array();
  for (int i = 0; i < stage_count; ++i)
    if (p.skipped[static_cast<std::size_t>(i)]) skipped.push_back(name(static_cast<Stage>(i)));
  Json json{{"input", p.input},
            {"tolerance", p.tolerance.value},
            {"tolerance_percent", p.tolerance.percent},
            {"sigma", p.sigma},
            {"alpha", p.alpha},
            {"shrink", p.shrink},
            {"containment", p.containment == Containment::certified ? "certified" : "sampled"},
            {"topology", p.topology == TopologyMode::keep ? "keep" : "separate"},
            {"drop_thin", p.drop_thin},
            {"cover", p.cover ? Json(*p.cover) : Json(nullptr)},
            {"sides", name(p.sides)},
            {"conditions", {p.condition_1, p.condition_2, p.condition_3, p.condition_4}},
            {"skip", skipped},
            {"target", name(p.target)},
            {"cost_ring", p.cost_ring == CostRing::one ? 1 : 2},
            {"effort", p.effort},
            {"improver", name(p.improver)},
            {"drop_small", p.drop_small},
            {"threads", p.threads},
            {"time_limit", p.time_limit},
            {"memory_limit", p.memory_limit}};
  if (p.until) json["until"] = name(*p.until);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<RunParameters> parse_parameters(std::string_view text) {
  RunParameters parameters;
  try {
    read_parameters(Json::parse(text), parameters);
  } catch (const Json::exception&) {
    return Error{ErrorCode::bad_input, "The parameters of the recording cannot be read.",
                 "The file is damaged; record the run again."};
  }
  if (Status valid = check(parameters); !valid)
    return Error{ErrorCode::bad_input,
                 "The parameters of the recording make no sense. " + valid.error().message,
                 "The file is damaged; record the run again."};
  return parameters;
}

} // namespace isoscope
