// Named values: what can be set can be read back, ranges hold, comparisons judge.
#include "command/named_values.h"

#include <doctest/doctest.h>

#include <set>

using namespace isoscope;

TEST_CASE("names are unique and described, and every value takes what it gives") {
  AppModel model([] {});
  std::set<std::string> names;
  for (const NamedValue& value : named_values()) {
    CAPTURE(value.name);
    CHECK(names.insert(value.name).second);
    CHECK(value.help.size() > 3);
    const std::string text = value.get(model);
    if (!value.set) continue;
    if (value.name == "clip.radius") continue; // 0.1 is no round number in every precision
    CHECK(value.set(model, text).ok());
    CHECK(value.get(model) == text);
    CHECK(!value.set(model, "neither number nor word").ok());
  }
}

TEST_CASE("ranges are kept") {
  AppModel model([] {});
  CHECK(!find_value("alpha")->set(model, "0").ok());
  CHECK(!find_value("alpha")->set(model, "1").ok());
  CHECK(!find_value("alpha")->set(model, "nan").ok());
  CHECK(find_value("alpha")->set(model, "0.995").ok()); // as the command line takes it
  CHECK(find_value("alpha")->set(model, "0.3").ok());
  CHECK(find_value("layer.zero")->set(model, "off").ok());
  CHECK(!model.view.zero_set.visible);
  CHECK(find_value("mode")->set(model, "split").ok());
  CHECK(model.view.mode == ViewMode::split);
  CHECK(find_value("tolerance")->set(model, "0.6%").ok());
  CHECK(model.draft.tolerance.percent);
  CHECK(find_value("clip.normal")->set(model, "0,3,4").ok());
  CHECK(model.view.clip.normal.z == doctest::Approx(0.8));
  CHECK(find_value("clip.normal")->set(model, "y").ok());
  CHECK(model.view.clip.normal == Vec3{0, 1, 0});
  CHECK(!find_value("clip.normal")->set(model, "0,0,0").ok());
  CHECK(!find_value("clip.normal")->set(model, "1,2").ok());
  CHECK(find_value("nothing") == nullptr);
}

TEST_CASE("expectations") {
  AppModel model([] {});
  CHECK(expect(model, "step == 0").ok());
  CHECK(expect(model, "step >= 0 and phase == idle and selection == none").ok());
  CHECK(!expect(model, "step > 0").ok());
  CHECK(!expect(model, "step == 0 and phase == running").ok());
  CHECK(expect(model, "phase != running").ok());
  CHECK(expect(model, "step = 0").error().code == ErrorCode::usage);
  CHECK(expect(model, "step ==").error().code == ErrorCode::usage);
  CHECK(expect(model, "stepp == 0").error().code == ErrorCode::usage);
  CHECK(expect(model, "step == 0 or step == 1").error().code == ErrorCode::usage);
  CHECK(expect(model, "phase < idle").error().code == ErrorCode::usage);
}

TEST_CASE("a draft differs by what is in force, and every parameter but a few needs a restart") {
  AppModel model([] {});
  auto scene = std::make_shared<Scene>();
  scene->default_sigma = 0.9;
  model.run.scene = scene;
  CHECK(!model.draft_differs());
  model.draft.sigma = 0.9; // what the run takes anyway
  CHECK(!model.draft_differs());
  model.draft.sigma = 0.5;
  CHECK(model.draft_differs());
  CHECK(!model.draft_needs_restart());
  model.draft.sigma = 0;
  model.draft.sides = SidesMode::winding;
  CHECK(model.draft_differs());
  CHECK(model.draft_needs_restart());
}
