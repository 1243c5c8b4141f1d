// Undo and redo of what is looked at: view, filter, selection and layout, never the run.
#pragma once

#include "model/event_filter.h"
#include "model/settings.h"
#include "model/view_state.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace isoscope {

/// What undo brings back.
struct ViewMemento {
  ViewState view;
  EventFilter filter;
  std::string condition; ///< of the filter, in the query language
  Pick picked;
  PickKinds kinds = PickKinds::all;   ///< as Selection::kinds
  std::optional<std::uint32_t> event; ///< as Selection::event
  PaneLayout panes;
};

/// The past and the undone future of mementos. It is shown the present one every frame and finds out itself
/// what was done: a drag, or one part changed again within the window, is one entry.
class ViewHistory {
 public:
  /// Parts of a memento, as bits.
  enum Part : unsigned { camera = 1, look = 2, section = 4, filter = 8, selection = 16, layout = 32 };

  /// `window`: seconds within which changes of the same part are one entry; 0: every change is its own.
  explicit ViewHistory(double window = 0.5) : window_(window) {}
  void set_window(double seconds) { window_ = seconds; }

  /// Takes the present memento at `clock` seconds. `dragging`: a mouse button is held, so that everything up
  /// to its release is one entry. `unasked`: parts that nobody but the program changes at present; their
  /// changes are taken without an entry.
  void observe(const ViewMemento& now, double clock, bool dragging, unsigned unasked = 0);
  /// Forgets everything; what is observed next is the beginning.
  void reset();

  /// How many entries can be taken back, or brought again.
  std::size_t undo_depth() const { return past_.size(); }
  std::size_t redo_depth() const { return future_.size(); }
  /// The memento to return to; nullopt where there is none. What differs in between is then the present one.
  std::optional<ViewMemento> undo();
  std::optional<ViewMemento> redo();

  static constexpr std::size_t limit = 200; ///< entries kept

 private:
  double window_ = 0.5;
  std::optional<ViewMemento> present_;
  std::deque<ViewMemento> past_;
  std::vector<ViewMemento> future_;
  bool open_ = false;      ///< the newest entry may still take changes
  bool drag_open_ = false; ///< because a drag goes on
  unsigned open_parts_ = 0;
  double changed_at_ = 0;
};

/// The parts in which two mementos differ.
unsigned difference(const ViewMemento& a, const ViewMemento& b);

} // namespace isoscope
