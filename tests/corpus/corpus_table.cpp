// Rows as JSON, tables as files, differences as sentences.
#include "corpus/corpus_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace isoscope::corpus {

namespace {

using Json = nlohmann::ordered_json;

constexpr double much = 1.2;
/// Seconds and vertices below which a fifth more is chance.
constexpr double least_seconds = 0.5, least_vertices = 5;

template <class T> Json optional_value(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class T> std::optional<T> read_optional(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<T>();
}

double rounded(double value, double unit) {
  return std::round(value / unit) * unit;
}

Row read_row(const std::string& line) {
  const Json json = Json::parse(line);
  Row row;
  row.asked = {json.at("model"), json.at("tolerance"), json.at("effort")};
  row.exit = json.at("exit");
  for (const auto& [name, holds] : json.at("certificate").items()) row.certificate[name] = holds.get<bool>();
  row.euler_characteristic = read_optional<long>(json, "euler_characteristic");
  row.components = read_optional<std::size_t>(json, "components");
  row.vertices = read_optional<std::size_t>(json, "vertices");
  row.covers = read_optional<double>(json, "covers");
  row.seconds = json.at("cpu_seconds");
  row.memory = json.at("memory_mb");
  row.message = json.value("message", "");
  return row;
}

std::string name(const Asked& asked) {
  return asked.model + " at " + asked.tolerance + ": ";
}

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void compare_results(const Row& before, const Row& now, Comparison& out) {
  const std::string here = name(now.asked);
  if (before.exit != now.exit) {
    const std::string change = here + "exit " + std::to_string(before.exit) + " became " +
                               std::to_string(now.exit) +
                               (now.message.empty() ? "" : " (" + now.message + ")");
    (now.exit == 0 ? out.better : out.worse).push_back(change);
  }
  for (const auto& [line, held] : before.certificate) {
    const auto found = now.certificate.find(line);
    if (found == now.certificate.end()) continue; // the exit status tells
    if (held && !found->second) out.worse.push_back(here + "the certificate lost \"" + line + "\"");
    if (!held && found->second) out.better.push_back(here + "the certificate gained \"" + line + "\"");
  }
  if (before.exit == now.exit && before.euler_characteristic != now.euler_characteristic)
    out.notes.push_back(here + "χ " + std::to_string(before.euler_characteristic.value_or(0)) + " became " +
                        std::to_string(now.euler_characteristic.value_or(0)));
  if (before.vertices && now.vertices) {
    const auto a = static_cast<double>(*before.vertices), b = static_cast<double>(*now.vertices);
    const std::string change =
        here + std::to_string(*before.vertices) + " vertices became " + std::to_string(*now.vertices);
    if (b > much * a && b - a >= least_vertices) out.worse.push_back(change);
    if (a > much * b && a - b >= least_vertices) out.better.push_back(change);
  }
  if (before.covers && now.covers && *now.covers > much * *before.covers && *now.covers > 1)
    out.worse.push_back(here + "the input was " + number(*before.covers) + " δ away and is " +
                        number(*now.covers) + " δ");
}

double median(std::vector<double> values) {
  if (values.empty()) return 1;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

} // namespace

std::string json_line(const Row& row) {
  Json certificate = Json::object();
  for (const auto& [line, holds] : row.certificate) certificate[line] = holds;
  Json json{{"model", row.asked.model},
            {"tolerance", row.asked.tolerance},
            {"effort", row.asked.effort},
            {"exit", row.exit},
            {"certificate", certificate},
            {"euler_characteristic", optional_value(row.euler_characteristic)},
            {"components", optional_value(row.components)},
            {"vertices", optional_value(row.vertices)},
            {"covers", row.covers ? Json(rounded(*row.covers, 1e-3)) : Json(nullptr)},
            {"cpu_seconds", rounded(row.seconds, 0.01)},
            {"memory_mb", rounded(row.memory, 0.1)}};
  if (!row.message.empty()) json["message"] = row.message;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<std::vector<Row>> read_table(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in)
    return Error{ErrorCode::bad_input, file.string() + " cannot be read.",
                 "Give the table of an earlier run."};
  std::vector<Row> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (line.empty()) continue;
    try {
      rows.push_back(read_row(line));
    } catch (const Json::exception& wrong) {
      return Error{ErrorCode::bad_input,
                   file.string() + ", line " + std::to_string(number) + ": is no row of a corpus (" +
                       wrong.what() + ").",
                   "Give the table of an earlier run."};
    }
  }
  return rows;
}

Status write_table(const std::filesystem::path& file, std::vector<Row> rows) {
  std::sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.asked < b.asked; });
  std::ofstream out(file, std::ios::trunc);
  for (const Row& row : rows) out << json_line(row) << '\n';
  out.close();
  if (!out) return Error{ErrorCode::io, file.string() + " cannot be written.", "Check its folder."};
  return {};
}

Comparison compare(const std::vector<Row>& old_rows, const std::vector<Row>& new_rows) {
  std::map<Asked, const Row*> before;
  for (const Row& row : old_rows) before[row.asked] = &row;
  std::vector<std::pair<const Row*, const Row*>> pairs;
  Comparison out;
  for (const Row& row : new_rows) {
    const auto found = before.find(row.asked);
    if (found == before.end())
      out.notes.push_back(name(row.asked) + "is not in the old table");
    else
      pairs.emplace_back(found->second, &row);
  }
  out.compared = pairs.size();
  std::vector<double> ratios;
  for (const auto& [a, b] : pairs)
    if (a->exit == b->exit && a->seconds > least_seconds && b->seconds > 0)
      ratios.push_back(b->seconds / a->seconds);
  out.speed = median(ratios);
  for (const auto& [a, b] : pairs) {
    compare_results(*a, *b, out);
    const double fair = a->seconds * out.speed;
    if (a->exit == b->exit && b->seconds > much * fair && b->seconds - fair > least_seconds)
      out.worse.push_back(name(b->asked) + number(fair) + " CPU seconds became " + number(b->seconds) +
                          ", as this machine counts them");
  }
  return out;
}

} // namespace isoscope::corpus
