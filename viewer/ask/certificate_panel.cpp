// The certificate under the inspector's summary: what is proven of the mesh, line by line.
#include "ask/investigation.h"

#include "model/words.h"
#include "ui/answer.h"
#include "ui/widgets.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace isoscope::panels {
namespace {

/// A line of the certificate; open: neither proven nor asked for.
enum class RowVerdict : std::uint8_t { good, bad, open };
struct CertificateRow {
  std::string name;
  RowVerdict verdict;
  const char* tip;
};

/// Green only where the topology is what was expected.
CertificateRow topology_row(Certificate::Topology topology) {
  switch (topology) {
  case Certificate::Topology::as_expected:
    return {"topology as expected", RowVerdict::good, "Components and Euler characteristic."};
  case Certificate::Topology::wrong:
    return {"topology not as expected", RowVerdict::bad, "Components and Euler characteristic."};
  case Certificate::Topology::missed:
    return {"topology not what was aimed at", RowVerdict::open,
            "Components and Euler characteristic. Ω is no thickening: nothing guarantees them."};
  case Certificate::Topology::not_asked:
    break;
  }
  return {"no topology asked for", RowVerdict::open, "Only the sides had to be separated."};
}

CertificateRow cover_row(const Certificate& c, bool surface) {
  if (!surface)
    return {"no surface to cover", RowVerdict::open,
            "The input is no surface that the mesh could leave behind."};
  if (!c.cover_limit)
    return {"cover not judged", RowVerdict::open,
            "The bound is one-sided, as in the paper: no limit was given."};
  if (!c.cover_note.empty())
    return {"thin parts cut or closed over", RowVerdict::open,
            "The input is farther than the limit in places, which separating the sides alone allows."};
  char name[64];
  std::snprintf(name, sizeof name, "covers the input within %.4g δ", *c.cover_limit);
  return {name, c.covers ? RowVerdict::good : RowVerdict::bad,
          "Every point of the input is proven to be so near to the mesh."};
}

/// The places of the input that the mesh leaves behind; a click goes there.
void uncovered_places(Ui& ui, const Certificate& c, double delta) {
  if (c.uncovered.empty()) return;
  widgets::quiet_text(ui, "Left behind, farthest first");
  for (std::size_t i = 0; i < c.uncovered.size(); ++i) {
    const UncoveredPlace& p = c.uncovered[i];
    if (widgets::link_row(
            ui, "uncovered", std::to_string(i + 1) + "  " + short_number(p.distance / delta) + " δ away",
            short_number(p.size / delta) + " δ long",
            "A part of the input that is farther from the mesh than the limit. The camera goes to "
            "its farthest point and marks it.",
            i))
      ui.commands.post("look-at-place", {"uncovered", std::to_string(i)});
  }
  if (c.uncovered_count > c.uncovered.size())
    widgets::quiet_text(ui, "and " + grouped(c.uncovered_count - c.uncovered.size()) + " nearer");
}

/// What is proven of every triangle, in the words of the field's kind.
const char* within_words(const Scene* scene) {
  switch (scene && scene->field ? scene->field->kind() : FieldKind::triangles) {
  case FieldKind::points:
    return "φ ≤ δ is proven on every triangle: the robust distance to the points is at most δ.";
  case FieldKind::surfaces:
    return "No triangle meets the given surfaces, by exact predicates, and the mesh lies between them.";
  case FieldKind::grid:
    return "The grid's function is proven to lie between its two levels on every triangle.";
  case FieldKind::triangles:
    break;
  }
  return "Every triangle is proven nearer than δ to the input.";
}

/// What the mesh is as a surface.
CertificateRow manifold_row(const Certificate& c) {
  const RowVerdict verdict = c.manifold ? RowVerdict::good : RowVerdict::bad;
  if (!c.regions.empty())
    return {"every region closed", verdict, "The boundary of each region is a closed 2-manifold."};
  if (c.border && c.boundary_loops > 0)
    return {"2-manifold with border", verdict,
            "Every edge has two triangles, or one on the border; every vertex one fan."};
  return {"closed 2-manifold", verdict, "Every edge has two triangles, every vertex one fan."};
}

} // namespace

void certificate(Ui& ui) {
  const auto& result = ui.window.run.result;
  if (!result || ui.window.transport.step() < ui.window.live_step()) return;
  const widgets::AnswerRegion region(ui, AnswerKind::certificate, ui.window.settled);
  const Certificate& c = result->certificate;
  widgets::bold_text(ui, c.holds() ? "Certified" : "Not certified");
  const auto judged = [](bool good) { return good ? RowVerdict::good : RowVerdict::bad; };
  const double delta = ui.window.run.scene ? ui.window.run.scene->delta : 0;
  std::vector<CertificateRow> rows{
      manifold_row(c),
      {"oriented", judged(c.oriented), "Neighbours agree on which side is outside."},
      {"free of self-intersections", judged(c.intersection_free), "By exact predicates."},
      {"within Ω", judged(c.within_tolerance), within_words(ui.window.run.scene.get())},
      cover_row(c, !ui.window.run.scene || ui.window.run.scene->field->surface() != nullptr),
      {"separates the boundaries", judged(c.separates), "The winding number is right in every region."},
      topology_row(c.topology)};
  if (c.border)
    rows.push_back({"border and rim within δ", judged(c.border->holds()),
                    "No point of one is farther than δ from the other, by branch and bound."});
  ImGui::PushFont(ui.fonts.small);
  for (const CertificateRow& row : rows) {
    if (row.verdict == RowVerdict::open) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      const float side = ImGui::GetTextLineHeight();
      widgets::glyph(ui, {at.x + side / 2, at.y + side / 2}, 4.5f, ui.colors.warning,
                     MarkerShape::hollow_diamond);
      ImGui::Dummy({side, side});
    } else {
      widgets::verdict_glyph(ui, row.verdict == RowVerdict::good);
    }
    ImGui::SameLine();
    ImGui::TextUnformatted(row.name.c_str());
    widgets::tip(ui, row.name, row.tip);
  }
  ImGui::PopFont();
  if (delta > 0)
    widgets::limit_bar(ui, "proven distance", c.max_distance / delta, 1, c.within_tolerance, "δ", true);
  if (delta > 0 && c.border) {
    widgets::limit_bar(ui, "border to rim", c.border->to_rim / delta, 1, c.border->to_rim <= delta, "δ",
                       true);
    widgets::limit_bar(ui, "rim to border", c.border->from_rim / delta, 1, c.border->from_rim <= delta, "δ",
                       true);
  }
  if (delta > 0 && c.cover_limit && c.input_distance.upper < std::numeric_limits<double>::infinity())
    widgets::limit_bar(ui, "of the input to it", c.input_distance.upper / delta, *c.cover_limit,
                       c.cover_note.empty() && c.covers, "δ", true);
  point_distances(ui, *result, delta);
  for (const std::string& failure : c.failures) widgets::quiet_text(ui, failure, true);
  if (const std::string crumbs = crumbs_note(result->crumbs, result->size().vertices); !crumbs.empty())
    widgets::quiet_text(ui, crumbs, true);
  for (const std::string& note : {c.topology_note, c.cover_note, c.gap_note})
    if (!note.empty()) widgets::quiet_text(ui, note, true);
  if (delta > 0) uncovered_places(ui, c, delta);
}

} // namespace isoscope::panels
