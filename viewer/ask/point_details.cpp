// The inspector of a point of the input: what stands for it in the robust distance.
#include "ask/investigation.h"

#include "model/words.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>

namespace isoscope::panels {
namespace {

constexpr std::size_t listed_neighbors = 12;

std::string place_text(Vec3 p) {
  return short_number(p.x) + "  " + short_number(p.y) + "  " + short_number(p.z);
}

/// In δ.
std::string in_deltas(double length, double delta) {
  return short_number(length / delta) + " δ";
}

void neighbor_rows(Ui& ui, const PointInspection& x, const std::vector<Vec3>& points, double delta) {
  if (x.neighbors.size() < 2) return;
  ImGui::Dummy({0, ui.px(4)});
  widgets::bold_text(ui, "The " + grouped(x.neighbors.size()) + " nearest, itself among them");
  const std::size_t shown = std::min(listed_neighbors, x.neighbors.size());
  for (std::size_t i = 1; i < shown; ++i) {
    const std::uint32_t id = x.neighbors[i];
    ImGui::PushID(static_cast<int>(i));
    if (widgets::link_row(ui, "neighbour", "point " + grouped(id),
                          in_deltas(distance(points[id], x.position), delta),
                          "How far it is. Click selects it."))
      ui.commands.post("pick", {"point", std::to_string(id)});
    ImGui::PopID();
  }
  if (x.neighbors.size() > shown)
    widgets::quiet_text(ui, "and " + grouped(x.neighbors.size() - shown) + " farther, up to " +
                                in_deltas(distance(points[x.neighbors.back()], x.position), delta));
}

std::string verdict(const PointInspection& x) {
  if (x.kept) return "counts for Ω";
  return x.dropped == DroppedPoints::Why::outliers ? "dropped: an outlier" : "dropped: part of a blob";
}

std::string percent(std::size_t part, std::size_t whole) {
  return short_number(100 * static_cast<double>(part) /
                      static_cast<double>(std::max<std::size_t>(whole, 1))) +
         " %";
}

} // namespace

void point_details(Ui& ui, const Investigation& asked, std::uint32_t id) {
  const auto& scene = ui.window.run.scene;
  const auto x = asked.point();
  if (!scene || !scene->points || !x)
    return widgets::quiet_text(ui, "This point is not among those of the input.", true);
  const double delta = scene->delta;
  widgets::heading(ui, x->kept ? icon::dot : icon::close, "Point " + grouped(id),
                   scene->points->drawn ? "drawn from the triangles of the input" : "of the input");
  widgets::value_row(ui, "position", place_text(x->position));
  widgets::value_row(ui, "in φ", verdict(*x), x->kept ? ui.colors.good_text : ui.colors.bad_text);
  if (!x->kept)
    widgets::quiet_text(
        ui,
        x->dropped == DroppedPoints::Why::outliers
            ? "Its neighbours are so far that φ exceeds δ all around: w ≥ δ², and it has no "
              "ball."
            : "It belongs to a part of Ω of its own that encloses nothing: its site was taken "
              "away.",
        true);
  widgets::value_row(ui, "neighbours k", grouped(x->neighbors.size()));
  widgets::value_row(ui, "mean b", place_text(x->mean));
  widgets::value_row(ui, "b from the point", in_deltas(distance(x->position, x->mean), delta));
  widgets::limit_bar(ui, "weight √w", std::sqrt(x->weight) / delta, 1, x->weight < delta * delta, "δ", true);
  if (x->kept) widgets::value_row(ui, "radius of its ball", in_deltas(x->ball_radius(delta), delta));
  widgets::limit_bar(ui, "φ at the point", x->phi / delta, 1, x->phi <= delta, "δ", true);
  neighbor_rows(ui, *x, scene->points->points->points, delta);
}

void points_summary(Ui& ui) {
  const auto& scene = ui.window.run.scene;
  if (!scene || !scene->points) return;
  const PointField& field = *scene->points;
  const std::size_t all = field.points->points.size();
  widgets::bold_text(ui, field.drawn ? "Points drawn from the triangles" : "Points of the input");
  widgets::value_row(ui, "points", grouped(all));
  widgets::value_row(ui, "neighbours k",
                     field.neighbors == 1
                         ? "1: plain distance"
                         : grouped(field.neighbors) + (field.automatic ? ", automatic" : ""));
  for (std::size_t i = 0; i < field.dropped.size(); ++i) {
    const DroppedPoints& d = field.dropped[i];
    const bool outliers = d.why == DroppedPoints::Why::outliers;
    ImGui::PushID(static_cast<int>(i));
    if (widgets::link_row(ui, "dropped",
                          outliers      ? "outliers dropped"
                          : d.parts > 1 ? grouped(d.parts) + " blobs dropped"
                                        : "blob dropped",
                          grouped(d.points) + ", " + percent(d.points, all),
                          outliers ? "Points far from all others: φ at them exceeds δ. Click goes to one."
                          : d.parts > 1
                              ? "Small parts of Ω of their own that enclose nothing. Click goes to one."
                              : "A part of Ω of their own that encloses nothing. Click goes there."))
      ui.commands.post("look-at-place", {"dropped", std::to_string(i)});
    ImGui::PopID();
  }
  ImGui::Dummy({0, ui.px(6)});
}

void point_distances(Ui& ui, const RunResult& result, double delta) {
  if (!result.points || !(delta > 0)) return;
  widgets::quiet_text(ui, "Points to the mesh, in δ: all, and without the dropped");
  const auto row = [&](const char* name, double PointDistances::Quantiles::*value) {
    widgets::value_row(ui, name,
                       short_number(result.points->all.*value / delta) + "   " +
                           short_number(result.points->kept.*value / delta));
  };
  row("median", &PointDistances::Quantiles::median);
  row("90 %", &PointDistances::Quantiles::percentile_90);
  row("99 %", &PointDistances::Quantiles::percentile_99);
  row("farthest", &PointDistances::Quantiles::most);
}

} // namespace isoscope::panels
