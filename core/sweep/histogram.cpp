// Bins, bars with round tops of their stacks, and three words below.
#include "sweep/histogram.h"

#include "base/markup.h"
#include "base/numbers.h"

#include <algorithm>
#include <cmath>

namespace isoscope::sweep {

namespace {

constexpr double width = 250, height = 118, left = 4, right = 4, top = 24, bottom = 20;
constexpr std::size_t most_bins = 24;

/// With as few digits as tell it: "1.2k".
std::string short_text(double value) {
  if (value >= 1e6) return general(value / 1e6, 2) + "M";
  if (value >= 1e4) return general(std::round(value / 1e3), 4) + "k";
  if (value >= 100) return grouped(static_cast<std::size_t>(std::lround(value)));
  return general(value, 2);
}

struct Scale {
  double low, high;
  bool logarithmic;
  double at(double value) const {
    if (high <= low) return 0.5;
    return logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
  }
  double value(double part) const {
    return logarithmic ? low * std::pow(high / low, part) : low + part * (high - low);
  }
};

std::string at(double value) {
  return general(std::round(value * 10) / 10, 6);
}

std::string rectangle(double x, double y, double w, double h, const std::string& style) {
  return "<rect class=\"" + style + "\" x=\"" + at(x) + "\" y=\"" + at(y) + "\" width=\"" + at(w) +
         "\" height=\"" + at(h) + "\"/>";
}

std::string words(double x, double y, const char* anchor, const std::string& style, const std::string& text) {
  return "<text class=\"" + style + "\" x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor +
         "\">" + escaped_markup(text) + "</text>";
}

} // namespace

std::string svg(const Histogram& histogram) {
  std::vector<double> all;
  for (const auto& values : histogram.series)
    for (const double v : values)
      if (v > 0 || (!histogram.logarithmic && v >= 0)) all.push_back(v);
  if (all.empty()) return {};
  std::sort(all.begin(), all.end());
  const double median = all[all.size() / 2];
  Scale scale{all.front(), all.back(), histogram.logarithmic};
  if (scale.high <= scale.low) // one value: a bar in the middle
    scale = {scale.low / 1.5, std::max(scale.high * 1.5, 1e-9), histogram.logarithmic};
  const std::size_t bins = std::clamp<std::size_t>(
      static_cast<std::size_t>(2 * std::sqrt(static_cast<double>(all.size()))) + 4, 8, most_bins);
  std::vector<std::vector<std::size_t>> counts(histogram.series.size(), std::vector<std::size_t>(bins));
  std::vector<std::size_t> sums(bins);
  for (std::size_t s = 0; s < histogram.series.size(); ++s)
    for (const double v : histogram.series[s]) {
      if (!(v > 0) && histogram.logarithmic) continue;
      const auto bin = std::min(
          bins - 1, static_cast<std::size_t>(std::max(0.0, scale.at(v)) * static_cast<double>(bins)));
      ++counts[s][bin];
      ++sums[bin];
    }
  const auto most = static_cast<double>(*std::max_element(sums.begin(), sums.end()));
  const double floor = height - bottom, room = floor - top - 4,
               step = (width - left - right) / static_cast<double>(bins);
  std::string out = "<svg class=\"histogram\" viewBox=\"0 0 " + at(width) + " " + at(height) +
                    "\" role=\"img\" aria-label=\"Histogram: " + escaped_markup(histogram.title) + "\">";
  out += words(left, 11, "start", "title", histogram.title);
  out += words(width - right, 11, "end", "quiet", "median " + short_text(median) + histogram.unit);
  for (std::size_t b = 0; b < bins; ++b) {
    if (sums[b] == 0) continue;
    const double x = left + static_cast<double>(b) * step;
    out += "<g><title>" + short_text(scale.value(static_cast<double>(b) / static_cast<double>(bins))) +
           " to " + short_text(scale.value(static_cast<double>(b + 1) / static_cast<double>(bins))) +
           histogram.unit + ": " + counted(sums[b], "run") + "</title>";
    double y = floor;
    for (std::size_t s = 0; s < counts.size(); ++s) {
      if (counts[s][b] == 0) continue;
      const double h = room * static_cast<double>(counts[s][b]) / most;
      y -= h;
      out += rectangle(x + 0.75, y, step - 1.5, h, "s" + std::to_string(s % 6));
    }
    out += "</g>";
  }
  out += rectangle(left, floor, width - left - right, 1, "axis");
  out += words(left, height - 6, "start", "quiet", short_text(scale.low) + histogram.unit);
  out += words(width - right, height - 6, "end", "quiet", short_text(scale.high) + histogram.unit);
  return out + "</svg>";
}

} // namespace isoscope::sweep
