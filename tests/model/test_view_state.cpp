// A view travels as JSON without loss, and what is no view is refused.
#include "model/view_state.h"

#include "model/words.h"
#include "scene/view_fields.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <type_traits>

using namespace isoscope;

namespace {

/// Every field another value than it begins with.
template <class S> void change_all(S& s) {
  for_each_field<S>([&]<class T>(const Field<S, T>& f) {
    if (f.name.empty()) return;
    T& place = s.*(f.member);
    if constexpr (std::is_enum_v<T>)
      place = static_cast<T>((static_cast<std::size_t>(place) + 1) % f.choices.size());
    else if constexpr (std::is_same_v<T, bool>)
      place = !place;
    else
      place = static_cast<T>(place == static_cast<T>(f.range.high) ? f.range.low
                                                                   : std::min(f.range.high, f.range.low + 7));
  });
}

} // namespace

TEST_CASE("a view survives the journey, all of it") {
  ViewState s;
  change_all(s.view);
  change_all(s.view.tets);
  change_all(s.view.clip);
  s.camera.target = {1.25, -2.5, 1e-7};
  s.camera.distance = 0.123456789012345;
  s.camera.orientation = {0.5, -0.5, 0.5, 0.5};
  float opacity = 0.25f;
  for (const LayerName& layer : layer_names())
    s.view.*layer.member = {!(s.view.*layer.member).visible, opacity += 0.03125f};
  s.view.clip.point = {1, 2, 3};
  s.view.clip.normal = {0, 0, -1};
  s.section = {0.1, 0.2, 3};
  REQUIRE(s.view.kernel_push != ViewSettings().kernel_push);
  const auto back = view_from_json(to_json(s), ViewState{});
  REQUIRE(back.has_value());
  CHECK(back->camera == s.camera);
  CHECK(back->view == s.view);
  CHECK(back->section.u == s.section.u);
  CHECK(back->section.v == s.section.v);
  CHECK(back->section.height == s.section.height);
}

TEST_CASE("fields have one key and one name each") {
  std::set<std::string> keys, scripts;
  std::size_t fields = 0, in_files = 0;
  const auto note = [&](const auto& f) {
    scripts.insert(f.script_name());
    ++fields;
  };
  for_each_field<ViewSettings>(note);
  for_each_field<TetFilter>(note);
  for_each_field<ClipSettings>(note);
  CHECK(scripts.size() == fields);
  for_each_field<ViewSettings>([&](const auto& f) {
    keys.insert(std::string(f.name));
    ++in_files;
  });
  CHECK(keys.size() == in_files);
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
