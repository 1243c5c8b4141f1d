// Two distributions and the request that is under way.
#include "model/window_times.h"

#include <cstdio>

namespace isoscope {

void WindowTimes::begin() {
  *this = {};
  on_ = true;
}

void WindowTimes::stands_at(Step wanted, double now) {
  if (wanted_ && *wanted_ != wanted) asked_at_ = now;
  wanted_ = wanted;
}

void WindowTimes::frame(double begun, double done, std::optional<Step> shown, Step wanted) {
  if (!on_) return;
  frames_.add(done - begun);
  if (!asked_at_ || shown != wanted || wanted_ != wanted) return;
  pictures_.add(done - *asked_at_);
  asked_at_.reset();
}

std::string WindowTimes::table() const {
  std::string text;
  char line[120];
  const auto add = [&](const char* what, const Quantiles& q) {
    std::snprintf(line, sizeof line, "%-18s %6zu %10.2f %10.2f %10.2f\n", what, q.size(), 1e3 * q.at(0.5),
                  1e3 * q.at(0.95), 1e3 * q.at(1));
    text += line;
  };
  std::snprintf(line, sizeof line, "%-18s %6s %10s %10s %10s\n", "ms", "times", "median", "95 %", "largest");
  text += line;
  add("frame", frames_);
  add("step to picture", pictures_);
  return text;
}

} // namespace isoscope
