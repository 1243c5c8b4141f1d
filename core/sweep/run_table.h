// The table of a sweep: what came of each model at each tolerance, a JSON line a run.
#pragma once

#include "base/status.h"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope::sweep {

/// What is asked: one run of the program.
struct Asked {
  std::string model;     ///< its name in the sweep
  std::string tolerance; ///< as given to --tolerance
  friend auto operator<=>(const Asked&, const Asked&) = default;
};

/// How a run can end, best first.
enum class Outcome : std::uint8_t {
  certified,
  uncertified,
  stopped, ///< by a limit of its own
  refused, ///< the input is none that can be worked on
  missing, ///< there is no such model
  out_of_time,
  out_of_memory,
  crashed,
  failed ///< anything else
};
constexpr int outcome_count = 9;
/// "out of time"
std::string_view name(Outcome outcome);

/// What came of it.
struct Row {
  Asked asked;
  int exit = 0; ///< 128 + signal where one ended it
  Outcome outcome = Outcome::certified;
  std::map<std::string, bool> certificate;    ///< its lines as in the report; empty without a result
  std::optional<std::size_t> input_triangles; ///< of what was read
  std::optional<long> euler_characteristic;   ///< of the output, as what follows
  std::optional<std::size_t> components, vertices;
  std::optional<double> covers; ///< upper bound of the distance from the input to the output, in δ
  double seconds = 0;           ///< of CPU time
  double memory = 0;            ///< peak, in MB
  std::string output;           ///< the mesh, a path in the sweep's folder; empty without one
  std::string message;          ///< the last line of standard error where the exit is not 0
};

/// What an exit status alone tells.
Outcome outcome_of(int exit, bool has_result);
/// One line, without its end.
std::string json_line(const Row& row);
/// A last line without its end, which a killed program left, is none. Fails with bad_input, naming file and
/// line.
Result<std::vector<Row>> read_table(const std::filesystem::path& file);
/// As they are, through a temporary file.
Status write_table(const std::filesystem::path& file, const std::vector<Row>& rows);

/// A table that grows line by line, each of them at once; nobody else can write it meanwhile.
class GrowingTable {
 public:
  /// Makes the file where there is none; takes a line without its end away. Fails with io, also where another
  /// program has it.
  static Result<GrowingTable> open(const std::filesystem::path& file);
  GrowingTable(GrowingTable&& other) noexcept;
  GrowingTable& operator=(GrowingTable&&) = delete;
  ~GrowingTable();
  /// Fails with io; nothing of the line is left then.
  Status append(const Row& row);

 private:
  GrowingTable(std::filesystem::path file, int descriptor)
      : file_(std::move(file)), descriptor_(descriptor) {}
  std::filesystem::path file_;
  int descriptor_;
};

} // namespace isoscope::sweep
