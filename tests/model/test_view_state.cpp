// A view travels as JSON without loss, and what is no view is refused.
#include "model/view_state.h"

#include <doctest/doctest.h>

using namespace isoscope;

TEST_CASE("a view survives the journey") {
  ViewState s;
  s.camera.target = {1.25, -2.5, 1e-7};
  s.camera.distance = 0.123456789012345;
  s.camera.orientation = {0.5, -0.5, 0.5, 0.5};
  s.view.outer.opacity = 0.375f;
  s.view.zero_set.visible = false;
  s.view.tets.all = true;
  s.view.tets.recent = 7;
  s.view.clip.shape = ClipSettings::Shape::slab;
  s.view.clip.normal = {0, 0.6, 0.8};
  s.view.mode = ViewMode::split;
  s.section = {0.1, 0.2, 3};
  const auto back = view_from_json(to_json(s), ViewState{});
  REQUIRE(back.has_value());
  CHECK(back->camera == s.camera);
  CHECK(back->view.outer == s.view.outer);
  CHECK(back->view.zero_set == s.view.zero_set);
  CHECK(back->view.tets == s.view.tets);
  CHECK(back->view.clip.shape == s.view.clip.shape);
  CHECK(distance(back->view.clip.normal, s.view.clip.normal) < 1e-15);
  CHECK(back->view.mode == s.view.mode);
  CHECK(back->section.height == s.section.height);
}

TEST_CASE("parts that are absent stay as they were") {
  ViewState base;
  base.camera.distance = 42;
  base.view.inner.opacity = 0.5f;
  const auto s = view_from_json(R"({"layers": {"outer": {"visible": false}}})", base);
  REQUIRE(s.has_value());
  CHECK(!s->view.outer.visible);
  CHECK(s->camera.distance == 42);
  CHECK(s->view.inner.opacity == 0.5f);
}

TEST_CASE("a bare pose is a view") {
  const auto s = view_from_json(to_json(CameraPose{{1, 2, 3}, 5, {0, 0, 0, 1}, 30, true}), ViewState{});
  REQUIRE(s.has_value());
  CHECK(s->camera.orthographic);
}

TEST_CASE("what is no view is refused") {
  for (const char* text :
       {"", "hello", "[]", "3", "{}", R"({"camera": {"target": [1]}})", R"({"clip": {"normal": [0, 0, 0]}})",
        R"({"layers": {"outer": {"opacity": 7}}})", R"({"mode": 9})", R"({"clip": {"shape": "plane"}})"})
    CHECK(!view_from_json(text, ViewState{}).has_value());
}
