// fork, setrlimit, exec, wait4; then the report.
#include "corpus/corpus_run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <csignal>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isoscope::corpus {

namespace {

using Json = nlohmann::json;

/// Elapsed seconds for each CPU second of the limit, after which a process that computes nothing is a hang
/// too.
constexpr double idle_factor = 20;
constexpr std::size_t longest_message = 300;

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string last_line(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  const std::size_t at = text.find_last_of("\n\r");
  if (at != std::string::npos) text.erase(0, at + 1);
  return text.substr(0, longest_message);
}

/// Becomes the program; never returns. Between fork and exec nothing may allocate: other threads may hold the
/// lock.
[[noreturn]] void become(char* const* argv, const Limits& limits, const char* error_file) {
  const auto cpu = static_cast<rlim_t>(std::ceil(limits.cpu_seconds));
  const auto bytes = static_cast<rlim_t>(limits.memory_mb * 1024 * 1024);
  const rlimit cpu_limit{cpu, cpu + 5}, memory_limit{bytes, bytes}, no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &cpu_limit);
  if (bytes > 0) ::setrlimit(RLIMIT_AS, &memory_limit);
  ::setrlimit(RLIMIT_CORE, &no_core);
  const int nowhere = ::open("/dev/null", O_RDWR),
            error = ::open(error_file, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(nowhere, STDIN_FILENO);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(error, STDERR_FILENO);
  ::execv(argv[0], argv);
  ::_exit(127);
}

/// Waits, and kills what takes far longer than its CPU time could.
int wait_for(pid_t process, double elapsed_limit, rusage& usage) {
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    int status = 0;
    const pid_t ended = ::wait4(process, &status, WNOHANG, &usage);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (ended < 0) return 127;
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > elapsed_limit)
      ::kill(process, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

void read_report(const std::string& text, Row& row) {
  const Json report = Json::parse(text);
  const Json& certificate = report.at("certificate");
  for (const auto& [line, holds] : certificate.items())
    if (holds.is_boolean()) row.certificate[line] = holds.get<bool>();
  row.vertices = report.at("output").at("vertices").get<std::size_t>();
  row.components = report.at("output").at("components").get<std::size_t>();
  row.euler_characteristic = report.at("output").at("euler_characteristic").get<long>();
  const Json& upper = certificate.at("input_distance").at("upper");
  if (upper.is_number())
    row.covers = upper.get<double>() / report.at("parameters").at("tolerance").get<double>();
}

} // namespace

Row run_one(const std::filesystem::path& program, const std::filesystem::path& model, const Asked& asked,
            const Limits& limits, const std::filesystem::path& folder) {
  const std::string stem = asked.model + "-" + asked.tolerance;
  const std::filesystem::path report = folder / (stem + ".json"), error = folder / (stem + ".txt");
  std::filesystem::remove(report);
  std::vector<std::string> arguments{program.string(), model.string(),
                                     "--tolerance",    asked.tolerance,
                                     "--effort",       std::to_string(asked.effort),
                                     "--threads",      "1",
                                     "--quiet",        "--report",
                                     report.string()};
  std::vector<char*> argv;
  for (std::string& a : arguments) argv.push_back(a.data());
  argv.push_back(nullptr);
  Row row;
  row.asked = asked;
  const pid_t process = ::fork();
  if (process == 0) become(argv.data(), limits, error.c_str());
  rusage usage{};
  row.exit = process < 0 ? 127 : wait_for(process, idle_factor * limits.cpu_seconds, usage);
  row.seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  row.memory = static_cast<double>(usage.ru_maxrss) / 1024;
  if (row.exit != 0) row.message = last_line(file_text(error));
  const std::size_t folder_at = row.message.find(model.string());
  if (folder_at != std::string::npos) row.message.replace(folder_at, model.string().size(), asked.model);
  try {
    if (std::filesystem::exists(report)) read_report(file_text(report), row);
  } catch (const Json::exception&) {
    if (row.message.empty()) row.message = "The report cannot be read.";
  }
  std::filesystem::remove(report);
  std::filesystem::remove(error);
  return row;
}

} // namespace isoscope::corpus
