// What a sweep is to run, and where in its folder things are.
#pragma once

#include "sweep/run_row.h"

#include <filesystem>
#include <string>
#include <vector>

namespace isoscope::sweep {

struct Model {
  std::string name; ///< in tables: its path below its folder, or as its list calls it
  std::string path; ///< absolute, or gallery:NAME
  friend bool operator==(const Model&, const Model&) = default;
};

/// The models that arguments stand for: a folder all mesh files in it and below, by name; a list those of its
/// lines, which are files beside it or gallery:NAME; a mesh file itself. Missing models stay: their runs say
/// so. Fails with bad_input on a folder without models and an argument that is not there, and with usage
/// where two models have one name.
Result<std::vector<Model>> find_models(const std::vector<std::string>& arguments);

/// The runs of a sweep, numbered from 0: all tolerances of the first model, then those of the next.
struct Plan {
  std::vector<Model> models;
  std::vector<std::string> tolerances;
  std::vector<std::string> options; ///< for the program
  Limits limits;
  friend bool operator==(const Plan&, const Plan&) = default;

  std::size_t runs() const { return models.size() * tolerances.size(); }
  const Model& model(std::size_t run) const { return models[run / tolerances.size()]; }
  Asked asked(std::size_t run) const { return {model(run).name, tolerances[run % tolerances.size()]}; }
  /// The mesh of a run, below the folder: "1%/stag.off".
  std::string output(std::size_t run) const;
};

/// Files of a sweep's folder.
class Folder {
 public:
  explicit Folder(std::filesystem::path path) : path_(std::move(path)) {}
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path plan() const { return path_ / "sweep.json"; }
  std::filesystem::path table() const { return path_ / "runs.jsonl"; }
  std::filesystem::path parts() const { return path_ / "parts"; }
  std::filesystem::path part(std::size_t number) const {
    return parts() / (std::to_string(number) + ".jsonl");
  }
  std::filesystem::path pictures() const { return path_ / "pictures"; }
  std::filesystem::path picture(std::size_t run) const { return pictures() / (std::to_string(run) + ".png"); }
  std::filesystem::path report(std::size_t run) const {
    return pictures() / (std::to_string(run) + ".report.json");
  }
  std::filesystem::path page() const { return path_ / "index.html"; }
  std::filesystem::path script() const { return path_ / "sweep.sh"; }

 private:
  std::filesystem::path path_;
};

/// Fails with bad_input where the folder holds no sweep.
Result<Plan> read_plan(const Folder& folder);
/// Makes the folder with its plan; one that has this plan already is left as it is. Fails with usage where it
/// holds another one, and says what differs.
Status write_plan(const Folder& folder, const Plan& plan);

} // namespace isoscope::sweep
