// The tables of a recording (.isorun) and what both of its sides agree on (core/README.md, D8).
#pragma once

#include "input/input_note.h"
#include "input/triangle_soup.h"
#include "journal/digest.h"
#include "journal/journal.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// In the file's head: `file RUN.isorun` and sqlite3's PRAGMA application_id tell it. "ISOR".
constexpr std::int64_t recording_application_id = 0x49534f52;
/// Grows with every change of the tables; other versions are refused.
constexpr std::int64_t recording_version = 4;

/// What is known when a run begins.
struct RecordingHeader {
  std::string program;                       ///< "isoscope 0.1.0"
  std::string parameters;                    ///< JSON, as asked for when the run began
  std::shared_ptr<const TriangleSoup> input; ///< so that no other file is needed
  std::vector<InputNote> notes = {};         ///< on reading it
};

/// How a recorded run ended.
struct RecordingEnd {
  std::string state;      ///< "finished", "stopped", "time limit"
  bool certified = false; ///< the certificate holds
  std::string report;     ///< JSON
};

/// How far a recording is: counts of everything the journal holds.
struct RecordingCounts {
  std::size_t events = 0, operations = 0, texts = 0, repairs = 0, sample_sets = 0, criteria = 0, marks = 0;
  friend bool operator==(const RecordingCounts&, const RecordingCounts&) = default;
};

/// Statements that make the empty tables, with comments for those who look with sqlite3.
extern const char* const recording_schema;

// What a commit's checksum is made of, in the order in which rows are written and read.
void add_to(Digest& digest, const Journal::ParameterRecord& record);
void add_to(Digest& digest, const Journal::StageMark& mark);
void add_to(Digest& digest, const StepFigures& figures);

/// Of points and triangles: the same input has the same digest whatever file it came from.
std::uint64_t digest(const TriangleSoup& soup);

} // namespace isoscope
