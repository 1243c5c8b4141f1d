// The summary's lines, aligned.
#include "cli/summary.h"

#include "cli/progress_line.h"

#include <cstdio>

namespace isoscope {

namespace {

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string line(std::string_view label, const std::string& text) {
  std::string result(label);
  result.resize(13, ' ');
  return result + text + "\n";
}

std::string counted(std::size_t n, const std::string& noun) {
  return grouped(n) + " " + noun + (n == 1 ? "" : "s");
}

std::string end_words(RunResult::End end) {
  switch (end) {
  case RunResult::End::finished:
    return "finished";
  case RunResult::End::stopped:
    return "stopped by the user";
  case RunResult::End::limit:
    return "stopped by a limit";
  }
  return {};
}

} // namespace

std::string summary(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                    const std::vector<StageStatistics>& stages) {
  const Certificate& c = result.certificate;
  std::string text;
  text += line("Input", parameters.input + ": " + grouped(scene.input->points.size()) + " vertices, " +
                            grouped(scene.input->triangles.size()) + " faces; δ = " +
                            number("%.6g", scene.delta) + " (" + parameters.tolerance.text() +
                            "), σ = " + number("%.3g", parameters.sigma_ratio(scene.default_sigma)) + " δ");
  text += line("Samples", grouped(scene.samples->size()) + " on " +
                              counted(scene.boundary_components.size(), "boundary component") + ", " +
                              number("%.2f", scene.sampling_seconds) + " s");
  for (const StageStatistics& stage : stages) {
    text += line(name(stage.stage), counted(stage.operations, "operation") + ", Z " +
                                        grouped(stage.zero_set_vertices) + " vertices, " +
                                        number("%.2f", stage.seconds) + " s");
  }
  text += line("Zero set", grouped(result.mesh.points.size()) + " vertices, " +
                               grouped(result.mesh.triangles.size()) + " faces, " +
                               counted(c.components, "component") +
                               ", χ = " + std::to_string(c.euler_characteristic));
  text += line("Certificate", c.holds() ? "holds: closed, oriented, free of intersections, d <= " +
                                              number("%.4f", c.max_distance / scene.delta) +
                                              " δ everywhere, sides separated, topology as expected"
                                        : "does NOT hold");
  for (const std::string& failure : c.failures) text += line("", failure);
  text += line("Run", end_words(result.end) + ", " + number("%.2f", result.seconds) + " s, " +
                          number("%.0f", static_cast<double>(result.peak_memory_bytes) / 1e6) + " MB");
  return text;
}

} // namespace isoscope
