// Which models arguments stand for, and how a plan is kept.
#include "sweep/slurm.h"
#include "sweep/tiny_models.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::sweep;
using isoscope::test::make_models;

namespace {

std::vector<std::string> names(const Result<std::vector<Model>>& models) {
  std::vector<std::string> found;
  if (models)
    for (const Model& m : *models) found.push_back(m.name);
  return found;
}

Plan small_plan() {
  return {{{"a.off", "/m/a.off"},
           {"b/c.obj", "/m/b/c.obj"},
           {"gallery:knot", "gallery:knot"},
           {"../up.off", "/up.off"}},
          {"1%", "0.5"},
          {"--effort", "0"},
          {}};
}

} // namespace

TEST_CASE("A folder gives its models and those below, by name") {
  const TemporaryFolder folder;
  const auto models = find_models({make_models(folder).string()});
  CHECK(names(models) == std::vector<std::string>{"box.off", "broken.off", "deep/ring.off"});
  CHECK(models->back().path == (folder / "models/deep/ring.off").string());
  std::filesystem::create_directory(folder / "empty");
  CHECK(find_models({(folder / "empty").string()}).error().code == ErrorCode::bad_input);
  CHECK(find_models({(folder / "nothing").string()}).error().message.find("does not exist") !=
        std::string::npos);
}

TEST_CASE("A list gives a model a line, files beside it and bundled ones") {
  const TemporaryFolder folder;
  make_models(folder);
  const auto list = folder.file("list.txt", "# mine\nmodels/box.off\r\n\n  gallery:torus \n/away/x.off\n");
  const auto models = find_models({list.string()});
  CHECK(names(models) == std::vector<std::string>{"models/box.off", "gallery:torus", "/away/x.off"});
  CHECK((*models)[0].path == (folder / "models/box.off").string());
  CHECK((*models)[1].path == "gallery:torus");
  CHECK((*models)[2].path == "/away/x.off");
  CHECK_FALSE(find_models({folder.file("none", "# nothing\n").string()}).ok());
  const auto twice = find_models({list.string(), list.string()});
  REQUIRE_FALSE(twice.ok());
  CHECK(twice.error().code == ErrorCode::usage);
  // A model may be missing: its run will say so.
  CHECK(names(find_models({"gallery:knot", "not-there.off"})) ==
        std::vector<std::string>{"gallery:knot", "not-there.off"});
}

TEST_CASE("Runs are numbered model by model, and their meshes stay in the folder") {
  const Plan plan = small_plan();
  CHECK(plan.runs() == 8);
  CHECK(plan.asked(3) == Asked{"b/c.obj", "0.5"});
  CHECK(plan.output(0) == "1%/a.off");
  CHECK(plan.output(3) == "0.5/b/c.obj.off");
  CHECK(plan.output(4) == "1%/knot.off");
  CHECK(plan.output(6) == "1%/up.off");
}

TEST_CASE("A plan comes back, and another one does not take its place") {
  const TemporaryFolder folder;
  const Folder sweep(folder / "s");
  CHECK(read_plan(sweep).error().code == ErrorCode::bad_input);
  Plan plan = small_plan();
  REQUIRE(write_plan(sweep, plan).ok());
  CHECK(*read_plan(sweep) == plan);
  CHECK(write_plan(sweep, plan).ok());
  plan.options = {"--effort", "1"};
  const Status other = write_plan(sweep, plan);
  REQUIRE_FALSE(other.ok());
  CHECK(other.error().message.find("other options") != std::string::npos);
}

TEST_CASE("An array has the tasks that have something to do") {
  ArrayPlan array{{0, 1, 2, 5, 7}, 4, 2, {"--partition=long"}};
  CHECK(array_tasks(array, 8) == "0-3");
  array.runs = {1, 5};
  CHECK(array_tasks(array, 8) == "1");
  array.runs = {0, 2, 3, 7};
  CHECK(array_tasks(array, 8) == "0,2-3");
  array.most_tasks = 1000;
  CHECK(array_tasks(array, 8) == "0,2-3,7");
  const std::string text = array_script(Folder("/s"), small_plan(), array, "/bin/isoscope-sweep");
  CHECK(text.find("#SBATCH --array=0,2-3,7\n") != std::string::npos);
  CHECK(text.find("#SBATCH --cpus-per-task=2\n") != std::string::npos);
  CHECK(text.find("#SBATCH --partition=long\n") != std::string::npos);
  CHECK(text.find("step '/s' --run \"$SLURM_ARRAY_TASK_ID\" --every 8\n") != std::string::npos);
}
