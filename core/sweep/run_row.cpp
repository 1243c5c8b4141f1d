// The process, then its report.
#include "sweep/run_row.h"

#include "base/numbers.h"

#include <nlohmann/json.hpp>

#include <cstring>
#include <fstream>

namespace isoscope::sweep {

namespace {

namespace fs = std::filesystem;

void read_report(const fs::path& file, Row& row) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return;
  const nlohmann::json report = nlohmann::json::parse(in);
  row.input_triangles = report.at("input").at("faces").get<std::size_t>();
  const nlohmann::json& certificate = report.at("certificate");
  for (const auto& [line, holds] : certificate.items())
    if (holds.is_boolean()) row.certificate[line] = holds.get<bool>();
  row.vertices = report.at("output").at("vertices").get<std::size_t>();
  row.components = report.at("output").at("components").get<std::size_t>();
  row.euler_characteristic = report.at("output").at("euler_characteristic").get<long>();
  const nlohmann::json& upper = certificate.at("input_distance").at("upper");
  if (upper.is_number())
    row.covers = upper.get<double>() / report.at("parameters").at("tolerance").get<double>();
}

/// The sentence itself, which does not depend on where the model lies.
std::string plain_words(std::string message, const std::string& model, const std::string& name) {
  for (const std::string_view before : {"isoscope-run: ", "note: "})
    if (message.starts_with(before)) message.erase(0, before.size());
  const std::size_t at = message.find(model);
  if (at != std::string::npos) message.replace(at, model.size(), name);
  return message;
}

/// What ended a process that said nothing itself.
std::string end_in_words(const ChildEnd& end) {
  if (end.timed_out) return "Killed after " + fixed(end.seconds, 0) + " CPU seconds.";
  if (end.exit == 127) return "The program cannot be started.";
  return end.exit > 128
             ? "Ended by signal " + std::to_string(end.exit - 128) + ", " + ::strsignal(end.exit - 128) + "."
             : std::string();
}

bool is_missing(const std::string& model) {
  std::error_code failure;
  return !model.starts_with("gallery:") && !fs::exists(model, failure);
}

} // namespace

std::optional<Row> run_one(const RunCall& call, const Asked& asked, const Limits& limits,
                           const RunControl& control) {
  Row row;
  row.asked = asked;
  if (is_missing(call.model)) {
    row.exit = 3;
    row.outcome = Outcome::missing;
    row.message = asked.model + " does not exist.";
    return row;
  }
  std::error_code ignored;
  fs::remove(call.report, ignored);
  std::vector<std::string> command{call.program.string(), call.model, "--tolerance", asked.tolerance};
  command.insert(command.end(), call.options.begin(), call.options.end());
  command.insert(command.end(), {"--quiet", "--report", call.report.string()});
  if (!call.mesh.empty()) {
    fs::remove(call.mesh, ignored);
    command.insert(command.end(), {"-o", call.mesh.string()});
  }
  const ChildEnd end = run_child(command, limits, control);
  if (end.abandoned) {
    fs::remove(call.report, ignored);
    return std::nullopt;
  }
  row.exit = end.exit;
  row.seconds = end.seconds;
  row.memory = end.memory_mb;
  row.message = plain_words(end.last_words, call.model, asked.model);
  if (row.message.empty() || end.timed_out) row.message = end_in_words(end);
  try {
    read_report(call.report, row);
  } catch (const nlohmann::json::exception&) {
    if (row.message.empty()) row.message = "The report cannot be read.";
  }
  fs::remove(call.report, ignored);
  row.outcome = end.timed_out ? Outcome::out_of_time : outcome_of(row.exit, !row.certificate.empty());
  if (row.outcome == Outcome::failed && row.message.find("memory is exhausted") != std::string::npos)
    row.outcome = Outcome::out_of_memory;
  return row;
}

} // namespace isoscope::sweep
