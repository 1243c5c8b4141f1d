// Feeds a target with its seeds and mutations of them, the same on every machine; or with files that failed
// before.
//
// A finding is kept in a file whose name the last line tells. It also comes back with the same --from and
// --inputs 1.
#include "base/scramble.h"
#include "fuzz/memory_meter.h"
#include "fuzz/target.h"
#include "support/mutations.h"

#include <CLI/CLI.hpp>

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fcntl.h>
#include <sys/time.h>
#include <unistd.h>

namespace isoscope::fuzz {

namespace {

/// What a signal handler can reach: the input that is being read.
std::string current;
std::array<char, 200> finding_name{};

void write_all(int descriptor, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t n = ::write(descriptor, data, size);
    if (n <= 0) return;
    data += n;
    size -= static_cast<std::size_t>(n);
  }
}

/// Keeps the input and lets the signal take its course.
extern "C" void keep_finding(int signal) {
  const int file = ::open(finding_name.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file >= 0) {
    write_all(file, current.data(), current.size());
    ::close(file);
  }
  constexpr std::string_view before = "finding kept in ";
  write_all(STDERR_FILENO, before.data(), before.size());
  write_all(STDERR_FILENO, finding_name.data(), std::string_view(finding_name.data()).size());
  write_all(STDERR_FILENO, signal == SIGPROF ? " (endless)\n" : "\n", signal == SIGPROF ? 11 : 1);
  ::_exit(1);
}

void set_patience(long seconds) {
  itimerval timer{};
  timer.it_value.tv_sec = seconds;
  ::setitimer(ITIMER_PROF, &timer, nullptr);
}

/// One input through the target. `patience` in CPU seconds.
void feed(std::string input, const std::string& label, long patience) {
  current = std::move(input);
  std::snprintf(finding_name.data(), finding_name.size(), "finding-%s-%s", std::string(target().name).c_str(),
                label.c_str());
  set_patience(patience);
  const std::size_t before = bytes_held();
  restart_peak();
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(current.data()), current.size());
  const std::size_t allowed = target().memory_base + target().memory_per_byte * current.size();
  if (peak_bytes() - before > allowed)
    require(false, std::to_string(peak_bytes() - before) + " bytes held for an input of " +
                       std::to_string(current.size()));
}

std::string mutation(const std::vector<std::string>& seeds, std::uint64_t series, std::uint64_t index) {
  test::Draws draws(scrambled(series) + index * golden_step);
  std::string input = seeds[draws.below(seeds.size())];
  if (draws.below(8) == 0) { // the head of one seed, the tail of another
    const std::string& other = seeds[draws.below(seeds.size())];
    input = input.substr(0, draws.below(input.size() + 1)) + other.substr(draws.below(other.size() + 1));
  }
  return draws.below(3) == 0 ? test::damaged(std::move(input), draws)
                             : test::edited(std::move(input), draws, target().words);
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

int run(int argc, char** argv) {
  std::uint64_t inputs = 1000, from = 0, series = 1;
  long patience = 10;
  std::filesystem::path seeds_folder;
  std::vector<std::filesystem::path> files;
  CLI::App app("Feeds the fuzz target \"" + std::string(target().name) + "\" with mutations of its seeds.");
  app.add_option("--inputs", inputs, "how many")->capture_default_str();
  app.add_option("--from", from, "the number of the first one")->capture_default_str();
  app.add_option("--series", series, "which mutations: another number, others")->capture_default_str();
  app.add_option("--patience", patience, "CPU seconds after which an input counts as endless")
      ->capture_default_str();
  app.add_option("--write-seeds", seeds_folder, "only writes the seeds into this folder");
  app.add_option("files", files, "inputs from files instead")->check(CLI::ExistingFile);
  CLI11_PARSE(app, argc, argv);

  const std::vector<std::string> seeds = target().seeds();
  if (!seeds_folder.empty()) {
    std::filesystem::create_directories(seeds_folder);
    for (std::size_t i = 0; i < seeds.size(); ++i)
      std::ofstream(seeds_folder / ("seed-" + std::to_string(i)), std::ios::binary) << seeds[i];
    return 0;
  }
  for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGPROF})
    std::signal(signal, keep_finding);
  if (!files.empty()) {
    for (const auto& file : files) feed(bytes_of(file), file.filename().string(), patience);
    std::printf("%s: %zu files, %zu accepted\n", std::string(target().name).c_str(), files.size(),
                accepted_inputs());
    return 0;
  }
  for (std::size_t i = 0; i < seeds.size(); ++i) feed(seeds[i], "seed-" + std::to_string(i), patience);
  const std::size_t sound = accepted_inputs();
  require(sound == seeds.size(), "a seed is refused");
  for (std::uint64_t i = from; i < from + inputs; ++i) {
    feed(mutation(seeds, series, i), std::to_string(series) + "-" + std::to_string(i), patience);
  }
  set_patience(0);
  const std::uint64_t accepted = accepted_inputs() - sound;
  std::printf("%s: %llu inputs, %llu accepted\n", std::string(target().name).c_str(),
              static_cast<unsigned long long>(inputs), static_cast<unsigned long long>(accepted));
  // Mutations that are all sound, or all broken at the first look, would test nothing.
  const bool telling = inputs < 500 || (accepted > inputs / 50 && accepted < inputs - inputs / 50);
  if (!telling) std::fprintf(stderr, "the mutations are too mild or too wild\n");
  return telling ? 0 : 1;
}

} // namespace

} // namespace isoscope::fuzz

int main(int argc, char** argv) {
  return isoscope::fuzz::run(argc, argv);
}
