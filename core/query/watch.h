// What expressions ask beyond the event itself, followed over the journal event by event.
#pragma once

#include "journal/journal.h"
#include "mesh/sample_sets.h"
#include "query/expression.h"
#include "query/zero_topology.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace isoscope {

/// The genus that Z should have, where somebody knows it: asked once a journal.
using ExpectedGenus = std::function<std::optional<double>()>;

/// A cursor at an event. Only what the needs ask for is followed: without needs a step costs nothing.
class JournalWatch {
 public:
  JournalWatch(std::shared_ptr<const Journal> journal, QueryNeeds needs, ExpectedGenus expected = {});
  /// For a journal that outlives this.
  JournalWatch(const Journal& journal, QueryNeeds needs, ExpectedGenus expected = {});

  /// Takes in the events from where it was up to this one. Going back starts anew.
  void go_to(std::uint32_t event);
  const QueryNeeds& needs() const { return needs_; }
  const Journal& journal() const { return *journal_; }

  // At the event taken last.
  bool has_topology() const { return topology_known_; }
  long euler_characteristic() const { return topology_.euler_characteristic(); }
  std::size_t components() const { return topology_.components(); }
  std::size_t boundary_loops() const { return topology_.boundary_loops(); }
  std::size_t component_recounts() const { return topology_.recounts(); }
  /// The genus that Z should have: as told, else by the topology check seen last; NaN before both.
  double expected_genus() const { return expected_genus_; }
  /// Attempts in a row that were not accepted, this one included; 0 at any other event.
  std::size_t stalled() const { return stalled_; }
  SampleClass sample_class(SampleId sample) const;
  bool sample_changed(SampleId sample) const;
  /// The ends of the edge the event names, before its operation; absent where it names none.
  std::optional<std::array<Vec3, 2>> edge() const { return edge_; }

 private:
  struct Watched {
    SampleId id;
    SampleClass now = SampleClass::outside, before = SampleClass::outside;
  };
  void restart();
  void take(std::uint32_t event);
  void apply(const Operation& operation);
  void place_samples();
  SampleClass judge(std::size_t watched, Step step) const;

  std::shared_ptr<const Journal> owned_;
  const Journal* journal_;
  QueryNeeds needs_;
  bool follows_state_ = false;
  double expected_genus_;
  double told_genus_;
  std::uint32_t next_ = 0; ///< the event to be taken next
  Complex complex_;
  std::optional<std::uint16_t> sample_set_;
  ZeroTopology topology_;
  bool topology_known_ = false;
  std::size_t rejected_ = 0, stalled_ = 0;
  std::optional<std::array<Vec3, 2>> edge_;
  std::vector<Watched> watched_;
  std::vector<Vec3> positions_; ///< of the watched samples in the present set
  std::vector<std::int8_t> labels_;
  std::unique_ptr<SampleSets> sets_;
};

/// Whether the event passes. `watch` stands at this event and covers the expression's needs; it may be null
/// where there are none.
bool holds(const Expression& expression, const Journal& journal, std::uint32_t event,
           const JournalWatch* watch);

} // namespace isoscope
