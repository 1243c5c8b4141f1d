// What a commit of a recording brings, before its checksum is known to be right.
#pragma once

#include "journal/digest.h"
#include "journal/journal.h"

#include <string>
#include <vector>

namespace isoscope {

struct CommitBatch {
  std::vector<std::string> sample_sets, texts, deltas;
  std::vector<Journal::ParameterRecord> criteria;
  std::vector<RepairDetail> repairs;
  std::vector<Journal::StageMark> marks;
  std::vector<Event> events;
  std::vector<StepFigures> figures; ///< of the operations, as deltas
};

/// The checksum after the batch, in the writer's order; false where it is not one delta an operation.
bool add_to(Digest& checksum, const CommitBatch& batch);

} // namespace isoscope
