// Shares of the parts, as they were measured on meshes and points of many sizes.
#include "model/preparation_progress.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

struct Part {
  std::string_view name;
  double weight;
  bool points; ///< only points have it
};
/// In their order.
constexpr std::array<Part, 7> parts{{{"input", 0.5, false},
                                     {"neighbours", 1, true},
                                     {"tolerances", 3, true},
                                     {"regions", 3, false},
                                     {"sides of open sheets", 1, true},
                                     {"boundary", 1.5, false},
                                     {"sampling", 5, false}}};
constexpr double least_share = 0.08, least_seconds = 1; ///< before the rest can be told

std::string seconds_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  return std::to_string(whole / 60) + " min" +
         (whole % 60 > 0 ? " " + std::to_string(whole % 60) + " s" : "");
}

} // namespace

void PreparationProgress::report(std::string_view part, double fraction, double seconds) {
  seconds_ = seconds;
  if (!part.empty()) part_ = part;
  double done = 0, all = 0;
  bool known = false;
  for (const Part& p : parts) {
    const bool here = p.name == part_;
    of_points_ |= here && p.points;
    if (here) done = all + std::clamp(fraction, 0.0, 1.0) * p.weight;
    known |= here;
    if (!p.points || of_points_) all += p.weight;
  }
  // Other tolerances may be tried, each with all of its parts.
  if (known) share_ = std::max(share_, done / all);
}

std::optional<double> PreparationProgress::seconds_left() const {
  if (share_ < least_share || seconds_ < least_seconds) return std::nullopt;
  return seconds_ * (1 - share_) / share_;
}

std::string PreparationProgress::words() const {
  std::string text = part_;
  if (seconds_ >= least_seconds) text += " \u00b7 " + seconds_text(seconds_);
  if (const auto left = seconds_left()) text += ", about " + seconds_text(std::max(1.0, *left)) + " left";
  return text;
}

} // namespace isoscope
