// Rows as JSON, tables as files.
#include "sweep/run_table.h"

#include "base/pending_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace isoscope::sweep {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, outcome_count> outcome_names{
    "certified",   "not certified", "stopped", "refused", "missing",
    "out of time", "out of memory", "crashed", "failed"};

template <class T> Json optional_value(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <class T> std::optional<T> read_optional(const Json& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<T>();
}

/// 1 / `parts` is the unit: dividing gives the shortest decimals.
double rounded(double value, double parts) {
  return std::round(value * parts) / parts;
}

Row read_row(const std::string& line) {
  const Json json = Json::parse(line);
  Row row;
  row.asked = {json.at("model"), json.at("tolerance")};
  row.exit = json.at("exit");
  for (const auto& [name, holds] : json.at("certificate").items()) row.certificate[name] = holds.get<bool>();
  row.outcome = outcome_of(row.exit, !row.certificate.empty());
  const std::string word = json.value("outcome", "");
  const auto known = std::find(outcome_names.begin(), outcome_names.end(), word);
  if (known != outcome_names.end()) row.outcome = static_cast<Outcome>(known - outcome_names.begin());
  row.input_triangles = read_optional<std::size_t>(json, "input_triangles");
  row.euler_characteristic = read_optional<long>(json, "euler_characteristic");
  row.components = read_optional<std::size_t>(json, "components");
  row.vertices = read_optional<std::size_t>(json, "vertices");
  row.covers = read_optional<double>(json, "covers");
  row.seconds = json.at("cpu_seconds");
  row.memory = json.at("memory_mb");
  row.output = json.value("output", "");
  row.message = json.value("message", "");
  return row;
}

Error cannot_write(const std::filesystem::path& file) {
  return {ErrorCode::io, file.string() + " cannot be written.",
          "Check its folder and the space on its disk."};
}

/// Where the last whole line ends.
off_t whole_lines(int descriptor, off_t size) {
  char byte = 0;
  while (size > 0 && ::pread(descriptor, &byte, 1, size - 1) == 1 && byte != '\n') --size;
  return size;
}

} // namespace

std::string_view name(Outcome outcome) {
  return outcome_names[static_cast<std::size_t>(outcome)];
}

Outcome outcome_of(int exit, bool has_result) {
  if (exit == 0) return Outcome::certified;
  if (exit == 1 && has_result) return Outcome::uncertified;
  if (exit == 3) return Outcome::refused;
  if (exit == 4) return Outcome::stopped;
  return exit > 128 ? Outcome::crashed : Outcome::failed;
}

std::string json_line(const Row& row) {
  Json certificate = Json::object();
  for (const auto& [line, holds] : row.certificate) certificate[line] = holds;
  Json json{{"model", row.asked.model},
            {"tolerance", row.asked.tolerance},
            {"exit", row.exit},
            {"outcome", name(row.outcome)},
            {"certificate", certificate},
            {"input_triangles", optional_value(row.input_triangles)},
            {"euler_characteristic", optional_value(row.euler_characteristic)},
            {"components", optional_value(row.components)},
            {"vertices", optional_value(row.vertices)},
            {"covers", row.covers ? Json(rounded(*row.covers, 1000)) : Json(nullptr)},
            {"cpu_seconds", rounded(row.seconds, 100)},
            {"memory_mb", rounded(row.memory, 10)}};
  if (!row.output.empty()) json["output"] = row.output;
  if (!row.message.empty()) json["message"] = row.message;
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<std::vector<Row>> read_table(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    return Error{ErrorCode::bad_input, file.string() + " cannot be read.", "Give the table of a sweep."};
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::vector<Row> rows;
  std::size_t number = 1;
  for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos;
       at = end + 1, ++number) {
    if (end == at) continue;
    try {
      rows.push_back(read_row(text.substr(at, end - at)));
    } catch (const Json::exception& wrong) {
      return Error{ErrorCode::bad_input,
                   file.string() + ", line " + std::to_string(number) + ": is no row of a sweep (" +
                       wrong.what() + ").",
                   "Give the table of a sweep."};
    }
  }
  return rows;
}

Status write_table(const std::filesystem::path& file, const std::vector<Row>& rows) {
  PendingFile out;
  if (Status opened = out.open(file); !opened) return opened;
  for (const Row& row : rows) out.append(json_line(row) + "\n");
  return out.commit();
}

Result<GrowingTable> GrowingTable::open(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) return cannot_write(file);
  GrowingTable table(file, descriptor);
  // File systems without locks are served too: there nobody tells of another sweep.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return Error{ErrorCode::io, file.string() + " is in use: another program works on these runs.",
                 "Wait until it has ended."};
  struct stat state {};
  if (::fstat(descriptor, &state) != 0) return cannot_write(file);
  const off_t whole = whole_lines(descriptor, state.st_size);
  if (whole < state.st_size && ::ftruncate(descriptor, whole) != 0) return cannot_write(file);
  return table;
}

GrowingTable::GrowingTable(GrowingTable&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

GrowingTable::~GrowingTable() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Status GrowingTable::append(const Row& row) {
  const std::string line = json_line(row) + "\n";
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  if (::write(descriptor_, line.data(), line.size()) == static_cast<ssize_t>(line.size())) return {};
  if (::ftruncate(descriptor_, before) != 0) return cannot_write(file_); // the next to open it mends it
  return cannot_write(file_);
}

} // namespace isoscope::sweep
