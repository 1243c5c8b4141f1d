// Rewrites a line with carriage return and "erase to the end".
#include "cli/progress_line.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace isoscope {

namespace {

constexpr std::chrono::milliseconds redraw_interval{100};

int terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

} // namespace

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
  finish();
}

bool ProgressLine::due() const {
  return Clock::now() - drawn_ >= redraw_interval;
}

void ProgressLine::begin(std::string_view name) {
  if (part_ == name) return;
  finish();
  part_ = name;
  part_began_ = Clock::now();
  drawn_ = {};
}

void ProgressLine::part(std::string_view name, double fraction) {
  if (!shown_) return;
  begin(name);
  line_ = fraction >= 0 ? std::to_string(static_cast<int>(100 * std::min(fraction, 1.0))) + " %" : "";
  if (due()) draw();
}

void ProgressLine::operation(const Journal& journal, Stage stage) {
  if (!shown_) return;
  begin(name(stage));
  const bool first = line_.empty();
  if (!first && !due()) return;
  const std::size_t steps = journal.operations().size();
  if (steps == 0) return;
  const StepFigures& figures = journal.operations()[steps - 1].figures;
  const double seconds = std::chrono::duration<double>(Clock::now() - part_began_).count();
  line_ = grouped(steps) + " operations   Z " + grouped(figures.zero_set_vertices) + " vertices   " +
          grouped(static_cast<std::size_t>(static_cast<double>(steps) / std::max(seconds, 1e-3))) + "/s";
  draw();
}

void ProgressLine::draw() {
  drawn_ = Clock::now();
  char text[200];
  const double seconds = std::chrono::duration<double>(drawn_ - part_began_).count();
  std::snprintf(text, sizeof text, "%-18s%s   %.1f s", part_.c_str(), line_.c_str(), seconds);
  const auto width = static_cast<std::size_t>(std::max(1, terminal_columns() - 1));
  std::fprintf(stderr, "\r%.*s\x1b[K", static_cast<int>(std::min(width, sizeof text)), text);
  std::fflush(stderr);
}

void ProgressLine::finish() {
  if (!shown_ || part_.empty()) return;
  draw();
  std::fputc('\n', stderr);
  part_.clear();
  line_.clear();
}

} // namespace isoscope
