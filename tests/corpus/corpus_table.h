// The table of a corpus: what came of each model at each tolerance, a JSON line a run, and what two tables
// differ in.
#pragma once

#include "base/status.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace isoscope::corpus {

/// What is asked: one run of the program.
struct Asked {
  std::string model;     ///< a file's name
  std::string tolerance; ///< as given to --tolerance
  int effort = 0;
  friend auto operator<=>(const Asked&, const Asked&) = default;
};

/// What came of it.
struct Row {
  Asked asked;
  int exit = 0;                             ///< 128 + signal where one ended it
  std::map<std::string, bool> certificate;  ///< its lines as in the report; empty without a result
  std::optional<long> euler_characteristic; ///< of the output, as what follows
  std::optional<std::size_t> components, vertices;
  std::optional<double> covers; ///< upper bound of the distance from the input to the output, in δ
  double seconds = 0;           ///< of CPU time
  double memory = 0;            ///< peak, in MB
  std::string message;          ///< the last line of standard error where the exit is not 0
};

/// One line, without its end.
std::string json_line(const Row& row);
/// Fails with bad_input, naming file and line.
Result<std::vector<Row>> read_table(const std::filesystem::path& file);
/// Ascending by what is asked.
Status write_table(const std::filesystem::path& file, std::vector<Row> rows);

struct Comparison {
  std::vector<std::string> worse, better, notes; ///< sentences that begin with model and tolerance
  std::size_t compared = 0;
  double speed = 1; ///< median of new seconds over old: how this machine compares with the table's
};
/// Runs that both tables have: another exit status, lost lines of the certificate, a fifth more time than the
/// median would have it, a fifth more vertices or distance.
Comparison compare(const std::vector<Row>& old_rows, const std::vector<Row>& new_rows);

} // namespace isoscope::corpus
