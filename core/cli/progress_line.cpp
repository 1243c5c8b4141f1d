// Terminal progress by carriage return and erase-line.
#include "cli/progress_line.h"

#include <unistd.h>

#include <cstdio>

namespace isoscope {

namespace {
constexpr std::chrono::milliseconds interval{100};
}

ProgressLine::ProgressLine(bool quiet) : active_(!quiet && isatty(STDERR_FILENO) != 0) {}

bool ProgressLine::due() {
  if (!active_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (drawn_ && now - last_ < interval) return false;
  last_ = now;
  return true;
}

void ProgressLine::draw(const std::string& text) {
  std::fprintf(stderr, "\r\x1b[K%s", text.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

void ProgressLine::part(std::string_view what, double fraction) {
  if (!due()) return;
  std::string text(what);
  if (fraction >= 0) text += " " + std::to_string(static_cast<int>(100 * fraction)) + " %";
  draw(text);
}

void ProgressLine::operation(const Journal& journal, Stage stage) {
  if (!due()) return;
  const auto& figures = journal.operations().back().figures;
  const double seconds = figures.seconds;
  char text[160];
  std::snprintf(text, sizeof text, "%s: %u operations, Z %u vertices, %u bad samples, %.0f /s, %.1f s",
                std::string(name(stage)).c_str(), static_cast<unsigned>(journal.steps()),
                figures.zero_set_vertices, figures.bad_samples, seconds > 0 ? journal.steps() / seconds : 0.0,
                seconds);
  draw(text);
}

void ProgressLine::clear() {
  if (!drawn_) return;
  std::fprintf(stderr, "\r\x1b[K");
  std::fflush(stderr);
  drawn_ = false;
}

} // namespace isoscope
