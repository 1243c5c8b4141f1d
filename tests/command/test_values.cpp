// Named values: what can be set can be read back, ranges hold, comparisons judge.
#include "app/app_model.h"

#include <doctest/doctest.h>

#include <set>

using namespace isoscope;

TEST_CASE("names are unique and described, and every value takes what it gives") {
  AppModel model([] {});
  std::set<std::string> names;
  for (const NamedValue& value : model.values.all()) {
    CAPTURE(value.name);
    CHECK(names.insert(value.name).second);
    CHECK(value.help.size() > 3);
    const std::string text = value.get();
    if (!value.set) continue;
    if (value.name == "clip.radius") continue; // 0.1 is no round number in every precision
    CHECK(value.set(text).ok());
    CHECK(value.get() == text);
    if (value.name != "inside") CHECK(!value.set("neither number nor word").ok()); // any text may be a file
  }
}

TEST_CASE("ranges are kept") {
  AppModel model([] {});
  CHECK(!model.values.find("alpha")->set("0").ok());
  CHECK(!model.values.find("alpha")->set("1").ok());
  CHECK(!model.values.find("alpha")->set("nan").ok());
  CHECK(model.values.find("alpha")->set("0.995").ok()); // as the command line takes it
  CHECK(model.values.find("alpha")->set("0.3").ok());
  CHECK(model.values.find("layer.zero")->set("off").ok());
  CHECK(!model.view.zero_set.visible);
  CHECK(model.values.find("mode")->set("split").ok());
  CHECK(model.view.mode == ViewMode::split);
  CHECK(model.values.find("tolerance")->set("0.6%").ok());
  CHECK(model.draft.tolerance.percent);
  CHECK(model.values.find("clip.normal")->set("0,3,4").ok());
  CHECK(model.view.clip.normal.z == doctest::Approx(0.8));
  CHECK(model.values.find("clip.normal")->set("y").ok());
  CHECK(model.view.clip.normal == Vec3{0, 1, 0});
  CHECK(!model.values.find("clip.normal")->set("0,0,0").ok());
  CHECK(!model.values.find("clip.normal")->set("1,2").ok());
  CHECK(model.values.find("nothing") == nullptr);
}

TEST_CASE("expectations") {
  AppModel model([] {});
  CHECK(model.values.expect("step == 0").ok());
  CHECK(model.values.expect("step >= 0 and phase == idle and selection == none").ok());
  CHECK(!model.values.expect("step > 0").ok());
  CHECK(!model.values.expect("step == 0 and phase == running").ok());
  CHECK(model.values.expect("phase != running").ok());
  // "topology" is a value too, and here a word.
  model.values.add("told", "what is told", [] { return std::string("topology"); });
  CHECK(model.values.expect("told == topology").ok());
  CHECK(model.values.expect("step = 0").error().code == ErrorCode::usage);
  CHECK(model.values.expect("step ==").error().code == ErrorCode::usage);
  CHECK(model.values.expect("stepp == 0").error().code == ErrorCode::usage);
  CHECK(model.values.expect("step == 0 or step == 1").error().code == ErrorCode::usage);
  CHECK(model.values.expect("phase < idle").error().code == ErrorCode::usage);
}

TEST_CASE("a draft differs by what is in force, and every parameter but a few needs a restart") {
  AppModel model([] {});
  auto scene = std::make_shared<Scene>();
  scene->default_sigma = 0.9;
  model.run.scene = scene;
  CHECK(!model.steering.draft_differs());
  model.draft.sigma = 0.9; // what the run takes anyway
  CHECK(!model.steering.draft_differs());
  model.draft.sigma = 0.5;
  CHECK(model.steering.draft_differs());
  model.draft.sigma = 0;
  model.draft.sides = SidesMode::winding;
  CHECK(model.steering.draft_differs());
  CHECK(!field_of(&RunParameters::sigma).restart);
  CHECK(field_of(&RunParameters::sides).restart);
}
