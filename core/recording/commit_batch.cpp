// As the writer adds its rows.
#include "recording/commit_batch.h"

#include "recording/layout.h"

namespace isoscope {

bool add_to(Digest& checksum, const CommitBatch& batch) {
  for (const std::string& bytes : batch.sample_sets) checksum.add(std::string_view(bytes));
  for (const auto& record : batch.criteria) add_to(checksum, record);
  for (const std::string& text : batch.texts) checksum.add(std::string_view(text));
  for (const RepairDetail& detail : batch.repairs) {
    checksum.add(detail.size());
    for (const RepairSweep& w : detail) checksum.add(w);
  }
  for (const auto& mark : batch.marks) add_to(checksum, mark);
  std::size_t step = 0;
  for (const Event& e : batch.events) {
    checksum.add(e);
    if (!e.operation) continue;
    if (step >= batch.deltas.size()) return false;
    checksum.add(std::string_view(batch.deltas[step]));
    add_to(checksum, batch.figures[step]);
    ++step;
  }
  return step == batch.deltas.size();
}

} // namespace isoscope
