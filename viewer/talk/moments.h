// The steps at which a talk should dwell: where stages begin, Z changes its topology, or a collapse comes
// through after many that did not.
#pragma once

#include "journal/journal.h"

#include <memory>
#include <vector>

namespace isoscope {

class Moments {
 public:
  /// Edges that must have stayed before an accepted collapse is one.
  static constexpr std::uint32_t patience = 50;

  /// Starts anew for another journal.
  void reset(std::shared_ptr<const Journal> journal);
  const std::shared_ptr<const Journal>& journal() const { return journal_; }
  /// Takes in at most `budget` new events.
  void update(std::size_t budget = 20000);
  /// Ascending, each once.
  const std::vector<Step>& steps() const { return steps_; }

 private:
  void add(Step step);
  std::shared_ptr<const Journal> journal_;
  std::size_t taken_ = 0;
  std::uint32_t rejected_ = 0; ///< edges in a row
  bool checked_ = false;       ///< the two below are known
  double euler_ = 0;
  std::uint32_t components_ = 0;
  std::vector<Step> steps_;
};

} // namespace isoscope
