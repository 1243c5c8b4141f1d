// What happened to one element over all steps, and when it changed last: read from events and deltas alone.
#pragma once

#include "base/run_control.h"
#include "journal/journal.h"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace isoscope {

/// The element that is asked about. An edge has both ends, others `id` alone.
struct ElementRef {
  enum class Kind : std::uint8_t { vertex, edge, tet, sample };
  Kind kind = Kind::vertex;
  std::uint32_t id = 0, other = 0;
  friend bool operator==(const ElementRef&, const ElementRef&) = default;
};

/// One line of a history.
struct HistoryRow {
  enum class Kind : std::uint8_t {
    born,      ///< a vertex, or an edge or tetrahedron that was not there before
    moved,     ///< a vertex, from and to
    absorbed,  ///< `other` was collapsed into the vertex
    merged,    ///< the vertex was collapsed into `other`, whose history goes on from here
    relabeled, ///< F of the vertex, or of one of the tetrahedron's, changed
    sided,     ///< a tetrahedron got its side of Z (§2.4.2), before and after
    gone,      ///< no longer there
    rejected,  ///< an attempt to collapse the edge failed: `reason`
    collapsed, ///< the edge was collapsed: `reason` tells how its target was found
    asked,     ///< a condition named the tetrahedron: an insertion because of it, or it was exhausted
    became_bad,
    became_good, ///< a sample changed class; before and after are ε
    other_set    ///< another sample set came into force; the sample's number is of one of them
  };
  Kind kind = Kind::born;
  Step step = 0;           ///< the step that shows it: after the operation, or at which the event came
  std::uint32_t event = 0; ///< index into Journal::events
  Reason reason = Reason::none;
  VertexId other;
  double before = 0, after = 0;
  Vec3 from, to;
  /// Whether the element itself is another one after it, rather than only having been asked about.
  bool changes() const { return kind != Kind::rejected && kind != Kind::asked; }
};
std::string_view name(HistoryRow::Kind kind);

struct ElementHistory {
  ElementRef element;
  std::vector<HistoryRow> rows; ///< ascending by event
  /// Of a vertex: where it was, in order, going on with the vertex that it was merged into.
  std::vector<Vec3> path;
  struct Inflow {
    Vec3 from, to; ///< where an absorbed vertex was, and where its collapse went
  };
  std::vector<Inflow> inflows;
  VertexId heir;                       ///< who stands for the vertex at the end; itself while it is there
  std::size_t absorbed = 0;            ///< vertices that ended in it, directly or through others
  std::optional<std::uint32_t> origin; ///< event that made the vertex
  Step steps = 0;                      ///< of the journal when this was read
  std::size_t attempts = 0, rejections = 0; ///< of the edge
  std::size_t changes() const;
  /// The last change before `step`, null when there is none.
  const HistoryRow* last_change(Step step) const;
};

/// Reads the whole journal. A sample's place is followed from `state`, T at step `at`, both ways; other
/// elements need no state. Empty rows when the element never existed; what was read so far when cancelled.
ElementHistory element_history(const Journal& journal, const ElementRef& element, const Complex& state,
                               Step at, const RunControl& control);

} // namespace isoscope
