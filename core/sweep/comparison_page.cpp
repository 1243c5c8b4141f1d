// Three lists and two histograms.
#include "base/markup.h"
#include "base/numbers.h"
#include "sweep/histogram.h"
#include "sweep/page.h"
#include "sweep/page_parts.h"

namespace isoscope::sweep {

namespace {

std::string list(const char* heading, const char* color, const std::vector<std::string>& sentences) {
  if (sentences.empty()) return {};
  std::string text = "<h2><span class=\"dot\" style=\"--c:var(--" + std::string(color) + ")\"></span>" +
                     heading + " <small>" + grouped(sentences.size()) + "</small></h2>\n<ul>";
  for (const std::string& s : sentences) {
    const std::size_t end = std::min(s.find(": "), s.size());
    text += "<li><b>" + escaped_markup(s.substr(0, end)) + "</b>" + escaped_markup(s.substr(end)) + "</li>\n";
  }
  return text + "</ul>\n";
}

} // namespace

std::string comparison_page(const Comparison& comparison, const std::string& before,
                            const std::string& after) {
  std::string plots;
  for (const Histogram& h : {Histogram{"Vertices, after / before", "", {comparison.vertices}, true},
                             Histogram{"CPU time, after / before", "", {comparison.seconds}, true}})
    if (const std::string picture = svg(h); !picture.empty()) plots += "<figure>" + picture + "</figure>\n";
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped_markup(after) + " against " + escaped_markup(before) + "</title>\n<style>" + page_style +
         "</style></head><body>\n<h1>" + grouped(comparison.worse.size()) + " worse, " +
         grouped(comparison.better.size()) + " better</h1>\n<p>" + escaped_markup(after) + " against " +
         escaped_markup(before) + ": " + counted(comparison.compared, "run") + " in both, which took " +
         general(comparison.speed, 3) + " times as long.</p>\n<div class=\"plots\">" + plots + "</div>\n" +
         list("Worse", "crashed", comparison.worse) + list("Better", "certified", comparison.better) +
         list("Also", "refused", comparison.notes) + "</body></html>\n";
}

} // namespace isoscope::sweep
