// The summary's lines, aligned, and those of them that are warnings.
#include "cli/summary.h"

#include "base/place.h"
#include "cli/exit_status.h"
#include "cli/progress_line.h"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace isoscope {

namespace {

/// Beyond this share of the points it is said that the result does not follow them.
constexpr double far_share = 0.01;

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string stage_words(const StageStatistics& s) {
  return counted(s.operations, "operation") + ", " + counted(s.rejections(), "rejection") + ", Z " +
         counted(s.zero_set_vertices, "vertex", "vertices") + ", " + number("%.2f", s.seconds) + " s";
}

std::string normal_words(const NormalDeviation& n) {
  return "deviate by " + number("%.1f", n.mean) + "° on average, by at most " +
         number("%.1f", n.percentile_99) + "° on 99 % of the area; " + number("%.2g", 100 * n.above_90) +
         " % beyond 90°" + (n.oriented ? "" : " (without a sign: the input is not oriented)");
}

/// What is proven of all of Z in the words of the field.
std::string containment_words(const Certificate& c, const Scene& scene) {
  const std::string most = number("%.4f", c.max_distance / scene.delta) + " δ";
  switch (scene.field ? scene.field->kind() : FieldKind::triangles) {
  case FieldKind::surfaces:
    return "between the two surfaces, which no facet meets";
  case FieldKind::grid:
    return "between the two levels on every facet";
  case FieldKind::points:
    return "φ <= " + most + " everywhere" +
           (scene.points->neighbors > 1 ? ", so that the robust distance is at most δ" : "");
  case FieldKind::triangles:
    break;
  }
  return "d <= " + most + " everywhere";
}

/// Quantiles in δ.
std::string point_words(const PointDistances::Quantiles& q, double delta) {
  return number("%.3f", q.median / delta) + " δ for half of them, " +
         number("%.3f", q.percentile_90 / delta) + " for 90 %, " + number("%.3f", q.percentile_99 / delta) +
         " for 99 %, " + number("%.3g", q.most / delta) + " at most";
}

std::string holds_words(const RunResult& result, const Scene& scene) {
  using Topology = Certificate::Topology;
  const Certificate& c = result.certificate;
  const bool has_border = c.border && c.boundary_loops > 0; // all holes may be filled
  std::string words = has_border          ? "holds: with border, oriented"
                      : c.regions.empty() ? "holds: closed, oriented"
                                          : "holds: every region closed and oriented";
  words += ", free of intersections, " + containment_words(c, scene) + ", sides separated";
  if (has_border)
    words += ", border and rim within " + number("%.4f", c.border->to_rim / scene.delta) + " and " +
             number("%.4f", c.border->from_rim / scene.delta) + " δ of each other";
  if (const auto filled = std::count(result.holes.facets.begin(), result.holes.facets.end(), 1); filled > 0)
    words += ", but for " + counted(static_cast<std::size_t>(filled), "face") + " that fill holes";
  if (c.cover_limit && c.cover_note.empty() && (!scene.field || scene.field->surface() != nullptr))
    words += ", the input covered within " + number("%.4g", *c.cover_limit) + " δ";
  if (c.topology == Topology::as_expected) words += ", topology as expected";
  return words;
}

/// ", 3 regions" where there are several insides.
std::string region_words(const Certificate& c) {
  return c.regions.empty() ? "" : ", " + counted(c.regions.size(), "region");
}

std::string end_words(const RunResult& result) {
  switch (result.end) {
  case RunResult::End::finished:
    return result.failure ? "ended before its last stage" : "finished";
  case RunResult::End::stopped:
    return result.without_end ? "improved until the user stopped it" : "stopped by the user";
  case RunResult::End::limit:
    return result.without_end ? "improved until its time was up" : "stopped by a limit";
  }
  return {};
}

/// Points on what is too thin for Ω, which the result does not follow; empty where they are few. φ <= δ is
/// proven for the result, not for the points, and noise alone puts some of them far away.
std::string far_points_words(const RunParameters& parameters, const Scene& scene, const RunResult& result) {
  if (!result.points || !parameters.cover || result.mesh.triangles.empty()) return {};
  const auto kept = static_cast<double>(scene.points->points->points.size() - scene.points->dropped_points());
  const auto far = static_cast<double>(result.points->far);
  if (far <= far_share * kept) return {};
  return number("%.2g", 100 * far / kept) + " % of the points are farther than " +
         number("%.4g", *parameters.cover) + " δ from the result, the farthest, by " +
         number("%.3g", result.points->kept.most / scene.delta) + " δ, at " +
         place(result.points->farthest, 4) +
         ": what they are on is too thin there for Ω to have an inside. A smaller tolerance may keep it, as "
         "may points with less noise.";
}

/// Where the input is not covered, in lines of their own.
std::vector<std::string> uncovered_lines(const Certificate& c, double delta) {
  std::vector<std::string> lines;
  for (const UncoveredPlace& p : c.uncovered)
    lines.push_back("  " + number("%.4g", p.distance / delta) + " δ at " + place(p.point, 6) + ", " +
                    number("%.3g", p.size) + " long (" + number("%.3g", p.size / delta) + " δ)");
  if (c.uncovered_count > c.uncovered.size())
    lines.push_back("  and " + counted(c.uncovered_count - c.uncovered.size(), "nearer place"));
  return lines;
}

} // namespace

std::vector<std::string> warnings(const RunParameters& parameters, const Scene& scene,
                                  const RunResult& result, bool stop_told) {
  const Certificate& c = result.certificate;
  std::vector<std::string> lines;
  if (result.end != RunResult::End::finished && !result.without_end && !stop_told)
    lines.push_back("The run was " + end_words(result) + ": the mesh is what it had reached.");
  // What was asked for is no warning.
  const bool wanted =
      c.topology == Certificate::Topology::not_asked && parameters.topology == TopologyMode::separate;
  if (!c.topology_note.empty() && !wanted) lines.push_back(c.topology_note);
  for (const std::string& note : {c.cover_note, c.gap_note})
    if (!note.empty()) lines.push_back(note);
  if (std::string far = far_points_words(parameters, scene, result); !far.empty())
    lines.push_back(std::move(far));
  if (!c.holds()) lines.push_back("The certificate does NOT hold.");
  lines.insert(lines.end(), c.failures.begin(), c.failures.end());
  const std::vector<std::string> places = uncovered_lines(c, scene.delta);
  lines.insert(lines.end(), places.begin(), places.end());
  return lines;
}

std::string start_note(const RunParameters& parameters, const Scene& scene) {
  // Samples cost the refinement what facets cost the improver, about eight of them as much as one.
  constexpr double few = 1.0 / 8, many = 1.0 / 2;
  const double ratio = static_cast<double>(scene.input->triangles.size()) /
                       std::max(scene.sample_estimate.samples(0.5 * scene.delta), 1.0);
  if (parameters.start == FirstZ::input && ratio > many)
    return "The input has many triangles for this tolerance: --start delaunay would be faster.";
  RunParameters other = parameters;
  other.start = FirstZ::input;
  const bool could = parameters.start == FirstZ::delaunay && check(other) && scene.volume->has_surface() &&
                     scene.input_topology.embedded() && !scene.volume->has_rooms() &&
                     !scene.volume->has_inner_walls();
  return could && ratio < few ? "The input can be the first Z itself: --start input would be faster."
                              : std::string();
}

std::string summary(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                    const std::vector<StageStatistics>& stages, const std::string& stopped_at) {
  const Certificate& c = result.certificate;
  std::string text;
  const MeshSize given = scene.input_size, made = result.size();
  const std::string inner = parameters.inside.empty() ? "" : " and " + parameters.inside;
  text += line("Input",
               parameters.input + inner + ": " +
                   (given.triangles == 0
                        ? counted(given.vertices, "point")
                        : grouped(given.vertices) + " vertices, " + grouped(given.triangles) + " faces") +
                   "; δ = " + number("%.6g", scene.delta) + " (" +
                   (scene.input && scene.input->gives_volume() ? "given" : parameters.tolerance.text()) +
                   "), σ = " + number("%.3g", parameters.sigma_ratio(scene.default_sigma)) + " δ");
  if (scene.samples->size() > 0)
    text += line("Samples",
                 grouped(scene.samples->size()) + " on " +
                     counted(scene.boundary_components.size(), "boundary component") + ", " +
                     (scene.samples->over_rim.empty()
                          ? std::string()
                          : grouped(scene.samples->over_rim.size()) + " more over the rim of " +
                                counted(scene.volume->open_sides()->rim().loops().size(), "loop") + ", ") +
                     number("%.2f", scene.sampling_seconds) + " s");
  if (scene.held > 0)
    text += line("Held",
                 counted(scene.held, "point") + ", so that the mesh stays near to what is thin or overlaps");
  for (const StageStatistics& stage : stages) text += line(name(stage.stage), stage_words(stage));
  text += line("Output",
               counted(made.vertices, "vertex", "vertices") + ", " + counted(made.triangles, "face") + ", " +
                   counted(c.components, "component") + ", χ = " + std::to_string(c.euler_characteristic) +
                   (c.boundary_loops > 0 ? ", " + counted(c.boundary_loops, "boundary loop") : "") +
                   region_words(c) + (result.form == ZeroForm::free ? ", on Z alone" : ", inside T"));
  if (result.normals.points > 0) text += line("Normals", normal_words(result.normals));
  text += line("Certificate", c.holds() ? holds_words(result, scene) : "does NOT hold");
  if (c.input_distance.upper < std::numeric_limits<double>::infinity()) {
    text += line("", "the input is at most " + number("%.4f", c.input_distance.upper / scene.delta) +
                         " δ away from it, somewhere " +
                         number("%.4f", c.input_distance.lower / scene.delta) + " δ");
  }
  if (result.points) {
    text += line("Points", "within " + point_words(result.points->kept, scene.delta));
    if (scene.points->dropped_points() > 0)
      text += line("", "with the " + grouped(scene.points->dropped_points()) +
                           " left out: " + point_words(result.points->all, scene.delta));
    if (const std::string far = far_points_words(parameters, scene, result); !far.empty())
      text += line("", far);
  }
  if (!c.topology_note.empty()) text += line("", c.topology_note);
  for (const std::string& note : {c.cover_note, c.gap_note})
    if (!note.empty()) text += line("", note);
  for (const std::string& failure : c.failures) text += line("", failure);
  for (const std::string& where : uncovered_lines(c, scene.delta)) text += line("", where);
  text += line("Run", (stopped_at.empty() ? end_words(result) : "stopped at " + stopped_at) + ", " +
                          number("%.2f", result.seconds) + " s, " +
                          number("%.0f", static_cast<double>(result.peak_memory_bytes) / 1e6) + " MB");
  return text;
}

} // namespace isoscope
