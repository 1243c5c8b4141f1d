// Undo and redo: what counts as one change, and that everything comes back.
#include "model/view_history.h"

#include <doctest/doctest.h>

#include <random>

using namespace isoscope;

namespace {

ViewMemento at_distance(double distance) {
  ViewMemento m;
  m.view.camera.distance = distance;
  return m;
}

double distance(const std::optional<ViewMemento>& m) {
  return m ? m->view.camera.distance : -1;
}

} // namespace

TEST_CASE("changes are undone and redone, and a new change ends the redone future") {
  ViewHistory h(0);
  for (int i = 0; i <= 3; ++i) h.observe(at_distance(i), i, false);
  CHECK(h.undo_depth() == 3);
  CHECK(distance(h.undo()) == 2);
  h.observe(at_distance(2), 4, false); // what was brought back is no change
  CHECK(h.redo_depth() == 1);
  CHECK(distance(h.undo()) == 1);
  CHECK(distance(h.redo()) == 2);
  CHECK(distance(h.redo()) == 3);
  CHECK(distance(h.redo()) == -1);
  CHECK(distance(h.undo()) == 2);
  h.observe(at_distance(9), 5, false);
  CHECK(h.redo_depth() == 0);
  CHECK(h.undo_depth() == 3);
  CHECK(distance(h.undo()) == 2);
  CHECK(distance(h.undo()) == 1);
  CHECK(distance(h.undo()) == 0);
  CHECK(distance(h.undo()) == -1);
}

TEST_CASE("a drag is one change however long it takes") {
  ViewHistory h(0);
  h.observe(at_distance(0), 0, false);
  for (int i = 1; i < 50; ++i) h.observe(at_distance(i), i, true);
  h.observe(at_distance(49), 50, false);
  CHECK(h.undo_depth() == 1);
  for (int i = 1; i < 50; ++i) h.observe(at_distance(49 + i), 50 + i, true);
  CHECK(h.undo_depth() == 2);
  CHECK(distance(h.undo()) == 49);
  CHECK(distance(h.undo()) == 0);
}

TEST_CASE("the same part changed again at once is the same change; another part is another") {
  ViewHistory h(0.5);
  h.observe(at_distance(1), 10, false);
  h.observe(at_distance(2), 11, false);
  h.observe(at_distance(3), 11.2, false);
  h.observe(at_distance(4), 11.4, false);
  CHECK(h.undo_depth() == 1);
  h.observe(at_distance(5), 12.5, false);
  CHECK(h.undo_depth() == 2);
  ViewMemento selected = at_distance(5);
  selected.picked.kind = Pick::Kind::tet;
  selected.picked.id = 3;
  h.observe(selected, 12.6, false);
  CHECK(h.undo_depth() == 3);
  CHECK(h.undo()->picked.kind == Pick::Kind::none);
  CHECK(distance(h.undo()) == 4);
  CHECK(distance(h.undo()) == 1);
}

TEST_CASE("what the program does by itself is taken without an entry") {
  ViewHistory h(0);
  h.observe(at_distance(1), 0, false);
  h.observe(at_distance(2), 1, false, ViewHistory::camera);
  CHECK(h.undo_depth() == 0);
  ViewMemento m = at_distance(3);
  m.panes.show_left = false;
  h.observe(m, 2, false, ViewHistory::camera);
  CHECK(h.undo_depth() == 1);
  CHECK(distance(h.undo()) == 2);
  h.reset();
  CHECK(h.undo_depth() == 0);
  CHECK(h.redo_depth() == 0);
}

TEST_CASE("every part is told apart") {
  const ViewMemento base;
  ViewMemento m = base;
  CHECK(difference(base, m) == 0);
  m.view.view.clip.radius = 7;
  CHECK(difference(base, m) == ViewHistory::look);
  m = base;
  m.view.section.u = 3;
  CHECK(difference(base, m) == ViewHistory::section);
  m = base;
  m.filter.kinds.reset(0);
  CHECK(difference(base, m) == ViewHistory::filter);
  m = base;
  m.kinds = PickKinds::samples;
  CHECK(difference(base, m) == ViewHistory::selection);
  m = base;
  m.panes.tab = BottomTab::events;
  m.view.camera.distance = 9;
  CHECK(difference(base, m) == (ViewHistory::layout | ViewHistory::camera));
}

TEST_CASE("any walk back and forth ends where it began, and the past stays within its limit") {
  std::mt19937 random(7);
  ViewHistory h(0);
  h.observe(at_distance(0), 0, false);
  for (int i = 1; i <= 300; ++i) h.observe(at_distance(i), i, false);
  CHECK(h.undo_depth() == ViewHistory::limit);
  int at = 300;
  for (int i = 0; i < 2000; ++i) {
    const bool back = random() % 2 == 0;
    const auto m = back ? h.undo() : h.redo();
    const int wanted = at + (back ? -1 : 1);
    if (wanted < 100 || wanted > 300) {
      CHECK(!m);
      continue;
    }
    at = wanted;
    CHECK(distance(m) == at);
    h.observe(*m, 400 + i, false);
  }
  CHECK(h.undo_depth() + h.redo_depth() == ViewHistory::limit);
}
