// Bookmarks keep their order and come back from their sidecar as they were; what is no sidecar is refused.
#include "talk/bookmarks.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <unistd.h>

using namespace isoscope;
namespace fs = std::filesystem;

namespace {

Bookmark at_step(Step step, std::string note = "") {
  Bookmark b;
  b.step = step;
  b.note = std::move(note);
  return b;
}

std::string steps_of(const Bookmarks& bookmarks) {
  std::string text;
  for (const Bookmark& b : bookmarks.all()) text += (text.empty() ? "" : " ") + std::to_string(b.step);
  return text;
}

RunParameters sphere() {
  RunParameters p;
  p.input = "gallery:sphere";
  return p;
}

} // namespace

TEST_CASE("bookmarks are added, moved, noted and removed, and the current one stays the same") {
  Bookmarks list;
  CHECK(!list.neighbour(1));
  for (const Step s : {10u, 20u, 30u, 40u}) list.add(at_step(s));
  CHECK(*list.current() == 3);
  CHECK(!list.neighbour(1));
  CHECK(*list.neighbour(-1) == 2);
  REQUIRE(list.go(1) != nullptr);
  CHECK(list.go(9) == nullptr);
  CHECK(*list.current() == 1);
  CHECK(list.move(1, 3));
  CHECK(steps_of(list) == "10 30 40 20");
  CHECK(*list.current() == 3);
  CHECK(list.move(3, 0));
  CHECK(steps_of(list) == "20 10 30 40");
  CHECK(*list.current() == 0);
  CHECK(list.move(2, 0));
  CHECK(steps_of(list) == "30 20 10 40");
  CHECK(*list.current() == 1);
  CHECK(list.move(0, 3));
  CHECK(*list.current() == 0);
  CHECK(!list.move(0, 4));
  CHECK(list.set_note(2, "the worst sample"));
  CHECK(!list.set_note(4, ""));
  CHECK(list.all()[2].note == "the worst sample");
  CHECK(list.remove(3));
  CHECK(*list.current() == 0);
  CHECK(list.remove(0));
  CHECK(!list.current());
  CHECK(!list.remove(2));
  CHECK(*list.neighbour(1) == 0);
  CHECK(*list.neighbour(-1) == 1);
}

TEST_CASE("a sidecar gives back every part of every bookmark") {
  Bookmarks list;
  Bookmark b = at_step(37, "„Link“ \"quoted\"\nsecond line");
  b.picked.kind = Pick::Kind::edge;
  b.picked.id = 412;
  b.picked.other = 7;
  b.picked.point = {0.25, -1e-9, 3};
  b.event = 99;
  b.view.camera.distance = 0.1 + 0.2;
  b.view.camera.orthographic = true;
  b.view.view.samples.visible = false;
  b.view.view.clip.shape = ClipSettings::Shape::slab;
  b.view.view.tets.recent = 12;
  b.view.section.u = 0.5;
  list.add(b);
  list.add(at_step(4));
  const fs::path file = fs::temp_directory_path() / "isoscope-test-bookmarks" / "talk.json";
  fs::remove_all(file.parent_path());
  REQUIRE(save_bookmarks(file, list, sphere()).ok());
  CHECK(std::distance(fs::directory_iterator(file.parent_path()), fs::directory_iterator()) == 1);
  const auto loaded = load_bookmarks(file);
  REQUIRE(loaded.ok());
  REQUIRE(loaded->size() == 2);
  CHECK(!loaded->current());
  const Bookmark& back = loaded->all()[0];
  CHECK(back.step == 37);
  CHECK(back.note == b.note);
  CHECK(back.picked == b.picked);
  CHECK(back.picked.point == b.picked.point);
  CHECK(*back.event == 99);
  CHECK(back.view.camera == b.view.camera);
  CHECK(back.view.view == b.view.view);
  CHECK(back.view.section.u == b.view.section.u);
  CHECK(!loaded->all()[1].event);
  CHECK(to_json(*loaded, sphere()) == to_json(list, sphere()));
  fs::remove_all(file.parent_path());
}

TEST_CASE("what is no list of bookmarks is refused in words") {
  const std::string good = [] {
    Bookmarks list;
    list.add(at_step(3));
    return to_json(list, sphere());
  }();
  REQUIRE(bookmarks_from_json(good).ok());
  for (const auto& [from, to] : std::initializer_list<std::pair<std::string, std::string>>{
           {"isoscope-bookmarks", "something"},
           {"\"version\": 1", "\"version\": 2"},
           {"\"step\": 3", "\"step\": -3"},
           {"\"kind\": \"none\"", "\"kind\": \"house\""},
           {"\"note\": \"\"", "\"note\": 4"},
           {"\"camera\"", "\"camel\": [\""}}) {
    std::string bad = good;
    CAPTURE(from);
    REQUIRE(bad.find(from) != std::string::npos);
    bad.replace(bad.find(from), from.size(), to);
    const auto read = bookmarks_from_json(bad);
    REQUIRE(!read.ok());
    CHECK(read.error().code == ErrorCode::bad_input);
  }
  for (std::size_t cut = 0; cut + 2 < good.size(); cut += 7)
    CHECK(!bookmarks_from_json(good.substr(0, cut)).ok());
  CHECK(load_bookmarks("/no/such/file.json").error().code == ErrorCode::io);
}

TEST_CASE("runs that differ have sidecars of their own") {
  const RunParameters a = sphere();
  RunParameters b = a;
  CHECK(run_key(a) == run_key(b));
  CHECK(run_key(a).size() == 16);
  b.threads = 7;
  b.time_limit = 3;
  CHECK(run_key(a) == run_key(b));
  b.alpha = 0.3;
  CHECK(run_key(a) != run_key(b));
  b = a;
  b.input = "gallery:torus";
  CHECK(run_key(a) != run_key(b));
  b = a;
  b.skipped[static_cast<std::size_t>(Stage::gamma)] = true;
  CHECK(run_key(a) != run_key(b));
  std::set<std::string> keys{run_key(a)};
  const auto differs = [&](auto&& edit) {
    b = a;
    edit(b);
    CHECK(keys.insert(run_key(b)).second);
  };
  differs([](RunParameters& p) { p.improver = ImproverPlace::embedded; });
  differs([](RunParameters& p) { p.sides = SidesMode::winding; });
  differs([](RunParameters& p) { p.drop_thin = true; });
  differs([](RunParameters& p) { p.drop_small = 4; });
  differs([](RunParameters& p) { p.cover.reset(); });
  differs([](RunParameters& p) { p.conditions[3] = false; });
  differs([](RunParameters& p) { p.tolerance.percent = false; });
  differs([](RunParameters& p) { p.until = Stage::gamma; });
  b = a;
  b.until = a.last_stage(); // what was said is what was not
  CHECK(run_key(a) == run_key(b));
  CHECK(bookmark_files({}, {}, a).beside.empty());
  CHECK(bookmark_files({}, {}, a).fallback.empty());
  const BookmarkFiles files = bookmark_files("/any/x/settings.json", {}, a);
  CHECK(files.fallback == fs::path("/any/x/bookmarks") / (run_key(a) + ".json"));
}

TEST_CASE("they are kept beside what they belong to, else among the settings, and old ones are still read") {
  const fs::path folder = fs::temp_directory_path() / ("isoscope-bookmarks-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const fs::path settings = folder / "settings" / "settings.json";
  RunParameters p = sphere();
  CHECK(bookmark_files(settings, {}, p).beside.empty()); // a bundled model has no place
  CHECK(bookmark_files(settings, folder / "run.isorun", {}).beside == folder / "run.isorun.bookmarks.json");
  p.input = (folder / "model.off").string();
  const BookmarkFiles files = bookmark_files(settings, {}, p);
  CHECK(files.beside == folder / ("model.off." + run_key(p).substr(0, 8) + ".bookmarks.json"));

  Bookmarks old, now;
  old.add(at_step(3));
  now.add(at_step(4));
  now.add(at_step(5));
  CHECK(kept_bookmarks(files)->size() == 0);
  REQUIRE(save_bookmarks(files.fallback, old, p).ok());
  CHECK(steps_of(*kept_bookmarks(files)) == "3");
  CHECK(*keep_bookmarks(files, now, p) == files.beside);
  CHECK(steps_of(*kept_bookmarks(files)) == "4 5");

  // Where the input's folder takes no file, the settings do: here it is none.
  std::ofstream(folder / "no-folder") << "x";
  p.input = (folder / "no-folder" / "model.off").string();
  const BookmarkFiles elsewhere = bookmark_files(settings, {}, p);
  CHECK(*keep_bookmarks(elsewhere, now, p) == elsewhere.fallback);
  CHECK(steps_of(*kept_bookmarks(elsewhere)) == "4 5");
  CHECK(keep_bookmarks({}, now, p)->empty());
  fs::remove_all(folder);
}
