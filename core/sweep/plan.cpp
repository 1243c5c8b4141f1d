// Lists, folders, and the plan as JSON.
#include "sweep/plan.h"

#include "base/folded.h"
#include "base/pending_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <string_view>

namespace isoscope::sweep {

namespace {

namespace fs = std::filesystem;
constexpr std::array<std::string_view, 7> endings{".off", ".obj", ".ply", ".stl", ".xyz", ".pts", ".asc"};
constexpr std::string_view bundled = "gallery:";

std::string lowered(std::string text) {
  for (char& c : text) c = folded(c);
  return text;
}

bool is_model_name(const fs::path& file) {
  return std::find(endings.begin(), endings.end(), lowered(file.extension().string())) != endings.end();
}

std::string whole_path(const fs::path& file) {
  return fs::absolute(file).lexically_normal().string();
}

Status take_folder(const fs::path& folder, std::vector<Model>& models) {
  std::error_code failure;
  std::vector<Model> found;
  const auto skip = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, skip, failure), end; !failure && at != end;
       at.increment(failure))
    if (at->is_regular_file(failure) && is_model_name(at->path()))
      found.push_back({at->path().lexically_relative(folder).string(), whole_path(at->path())});
  if (found.empty())
    return Error{ErrorCode::bad_input, folder.string() + " holds no models.",
                 "Models are files that end in .off, .obj, .ply, .stl, .xyz, .pts or .asc."};
  std::sort(found.begin(), found.end(), [](const Model& a, const Model& b) { return a.name < b.name; });
  models.insert(models.end(), found.begin(), found.end());
  return {};
}

Status take_list(const fs::path& list, std::vector<Model>& models) {
  std::ifstream in(list);
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
      line.pop_back();
    line.erase(0, line.find_first_not_of(" \t"));
    if (line.empty() || line.front() == '#') continue;
    if (line.find('\0') != std::string::npos)
      return Error{ErrorCode::bad_input,
                   list.string() + ", line " + std::to_string(number) + ": is no file name.",
                   "A list has the name of a model in each line."};
    models.push_back({line, line.starts_with(bundled) ? line : whole_path(list.parent_path() / line)});
  }
  if (models.empty())
    return Error{ErrorCode::bad_input, list.string() + " lists no models.",
                 "A list has the name of a model in each line."};
  return {};
}

Plan plan_of(const nlohmann::ordered_json& json) {
  Plan plan;
  for (const nlohmann::ordered_json& m : json.at("models"))
    plan.models.push_back({m.at("name"), m.at("path")});
  plan.tolerances = json.at("tolerances").get<std::vector<std::string>>();
  plan.options = json.at("options").get<std::vector<std::string>>();
  plan.limits = {json.at("cpu_limit"), json.at("memory_cap")};
  return plan;
}

nlohmann::ordered_json json_of(const Plan& plan) {
  nlohmann::ordered_json models = nlohmann::ordered_json::array();
  for (const Model& m : plan.models) models.push_back({{"name", m.name}, {"path", m.path}});
  return {{"isoscope-sweep", 1},
          {"tolerances", plan.tolerances},
          {"options", plan.options},
          {"cpu_limit", plan.limits.cpu_seconds},
          {"memory_cap", plan.limits.memory_mib},
          {"models", std::move(models)}};
}

/// What the plan that is there has otherwise.
std::string difference(const Plan& there, const Plan& wanted) {
  if (there.tolerances != wanted.tolerances) return "its tolerances are others";
  if (there.options != wanted.options) return "its runs have other options";
  if (there.models != wanted.models) return "its models are others";
  return "its limits are others";
}

} // namespace

Result<std::vector<Model>> find_models(const std::vector<std::string>& arguments) {
  std::vector<Model> models;
  for (const std::string& argument : arguments) {
    std::error_code failure;
    if (argument.starts_with(bundled)) {
      models.push_back({argument, argument});
    } else if (fs::is_directory(argument, failure)) {
      if (Status taken = take_folder(argument, models); !taken) return taken.error();
    } else if (is_model_name(argument)) {
      models.push_back({fs::path(argument).filename().string(), whole_path(argument)});
    } else if (fs::is_regular_file(argument, failure)) {
      if (Status taken = take_list(argument, models); !taken) return taken.error();
    } else {
      return Error{ErrorCode::bad_input, argument + " does not exist.",
                   "Give a folder of models, a list of them, or a model."};
    }
  }
  std::set<std::string> names;
  for (const Model& m : models)
    if (!names.insert(m.name).second)
      return Error{ErrorCode::usage, "Two models are called " + m.name + ".",
                   "Name each once, or give one folder that holds them all."};
  return models;
}

std::string Plan::output(std::size_t run) const {
  std::string name = model(run).name;
  if (name.starts_with(bundled)) name.erase(0, bundled.size());
  // A name that leads elsewhere, as ../x or /x, stays below the folder.
  std::string inside;
  for (const fs::path& part : fs::path(name).relative_path().lexically_normal())
    if (part != "..") inside += (inside.empty() ? "" : "/") + part.string();
  return asked(run).tolerance + "/" + inside + (lowered(inside).ends_with(".off") ? "" : ".off");
}

Result<Plan> read_plan(const Folder& folder) {
  const Error none{ErrorCode::bad_input, folder.path().string() + " holds no sweep.",
                   "isoscope-sweep MODELS --tolerance 1% -o FOLDER begins one."};
  std::ifstream in(folder.plan());
  if (!in) return none;
  try {
    return plan_of(nlohmann::ordered_json::parse(in));
  } catch (const nlohmann::ordered_json::exception&) {
    return none;
  }
}

Status write_plan(const Folder& folder, const Plan& plan) {
  std::error_code failure;
  fs::create_directories(folder.parts(), failure);
  fs::create_directories(folder.pictures(), failure);
  for (std::size_t run = 0; run < plan.runs(); ++run)
    fs::create_directories((folder.path() / plan.output(run)).parent_path(), failure);
  if (!fs::is_directory(folder.pictures(), failure))
    return Error{ErrorCode::io, folder.path().string() + " cannot be made.", "Give another folder."};
  if (fs::exists(folder.plan(), failure)) {
    const auto there = read_plan(folder);
    if (!there) return there.error();
    if (*there == plan) return {};
    return Error{ErrorCode::usage,
                 folder.path().string() + " holds another sweep: " + difference(*there, plan) + ".",
                 "Give another folder, or go on with that one by -o alone."};
  }
  PendingFile out;
  if (Status opened = out.open(folder.plan()); !opened) return opened;
  out.append(json_of(plan).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  return out.commit();
}

} // namespace isoscope::sweep
