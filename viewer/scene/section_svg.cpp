// The 2D section as a vector figure.
#include "scene/section_svg.h"

#include "base/markup.h"
#include "base/sort_unique.h"
#include "journal/describe.h"
#include "questions/rim_questions.h"
#include "scene/level_loops.h"
#include "scene/palette.h"
#include "scene/section_attempt_svg.h"
#include "scene/section_view.h"
#include "scene/svg_words.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isoscope {
namespace {

using svg::hex, svg::number;

constexpr double margin = 3, line_height = 4.6, text_size = 3.2; // millimetres
constexpr int lattice_most = 1200;                               ///< values along the longer side

std::string short_number(double value) {
  return number(value, "%.4g");
}

/// 1, 2 or 5 times a power of ten, at most `most`.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

class Drawing {
 public:
  Drawing(const StateSnapshot& state, const DistanceGrid* grid, const SectionFigure& figure)
      : state_(state), grid_(grid), figure_(figure), colors_(scene_colors(ThemeKind::paper)),
        plane_(section_plane(figure.view.clip)),
        geometry_(section_geometry(state, plane_, {figure.view.tets.box, section_sample_distance(state)})),
        height_(figure.width / figure.aspect), scale_(height_ / figure.section.height) {}

  std::string text();

 private:
  std::string x(double u) const { return number(figure_.width / 2 + scale_ * (u - figure_.section.u)); }
  std::string y(double v) const { return number(height_ / 2 - scale_ * (v - figure_.section.v)); }
  std::string at(PlanePoint p) const { return x(p.u) + "," + y(p.v); }
  bool inside(PlanePoint p, double reach) const {
    return std::abs(p.u - figure_.section.u) * scale_ <= figure_.width / 2 + reach &&
           std::abs(p.v - figure_.section.v) * scale_ <= height_ / 2 + reach;
  }
  bool other_shown() const { return figure_.other && figure_.view.other_zero.shown(); }
  void tolerance();
  std::vector<int> room_labels() const;
  void hatches();
  void rooms();
  void segments(const char* name, const std::vector<SectionGeometry::Segment>& all, glm::vec3 color,
                double width, const char* more = "");
  void curves();
  void over_rim(double size);
  void points();
  void samples();
  void mark(const char* name, PlanePoint p, bool bad, bool outer, double size);
  void next_point();
  void scale_bar(double top);
  void legend(double top);
  void caption(double top);
  void line(const std::string& content, double left, double top, const char* anchor = "start");

  const StateSnapshot& state_;
  const DistanceGrid* grid_;
  const SectionFigure& figure_;
  SceneColors colors_;
  SectionPlane plane_;
  SectionGeometry geometry_;
  double height_, scale_; ///< of the drawing; millimetres a scene unit
  std::string out_;
};

void Drawing::tolerance() {
  const ViewSettings& view = figure_.view;
  if (grid_ == nullptr || (!view.outer.shown() && !view.inner.shown())) return;
  const Lattice lattice = section_lattice(*grid_, plane_);
  if (lattice.values.empty()) return;
  const auto band = [&](const char* name, float low, float high, glm::vec3 color) {
    std::string d;
    for (const float level : {low, high})
      for (const auto& loop : level_loops(lattice, level)) {
        for (std::size_t i = 0; i < loop.size(); ++i) d += (i == 0 ? "M" : "L") + at(loop[i]);
        d += "Z";
      }
    if (d.empty()) return;
    out_ += "<path id=\"" + std::string(name) + "\" fill=\"" + hex(color) +
            "\" fill-opacity=\"0.28\" fill-rule=\"evenodd\" stroke=\"none\" d=\"" + d + "\"/>\n";
  };
  out_ += "<g id=\"tolerance\">\n";
  if (view.outer.shown()) band("outer-half", 0, view.level, colors_.outer);
  if (view.inner.shown()) band("inner-half", -view.level, 0, colors_.inner);
  out_ += "</g>\n";
}

/// The labels of what is filled where there are several insides.
std::vector<int> Drawing::room_labels() const {
  std::vector<int> labels;
  if (!figure_.view.side_tint || !figure_.view.tetrahedra.shown() || !state_.zero_set.has_rooms())
    return labels;
  for (const SectionGeometry::Cell& cell : geometry_.cells) labels.push_back(cell.label);
  sort_unique(labels);
  return labels;
}

std::string room_id(int label) {
  return label > 0 ? "outside" : "room-" + std::to_string(-label);
}

/// One tile of each hatch that is used, in its room's colours.
void Drawing::hatches() {
  for (const int label : room_labels()) {
    const RoomStyle style{side_color(label, true, colors_), room_style(label).hatch};
    const std::string ink = "fill=\"none\" stroke=\"" + hex(style.color) + "\" stroke-width=\"0.5\"";
    const bool turned =
        style.hatch == Hatch::rising || style.hatch == Hatch::falling || style.hatch == Hatch::crossed;
    out_ += "<pattern id=\"hatch-" + room_id(label) +
            "\" width=\"2\" height=\"2\" patternUnits=\"userSpaceOnUse\"" +
            (turned ? " patternTransform=\"rotate(45)\"" : "") + "><rect width=\"2\" height=\"2\" fill=\"" +
            hex(style.color) + "\" fill-opacity=\"0.25\"/>";
    if (style.hatch == Hatch::rising || style.hatch == Hatch::upright || style.hatch == Hatch::crossed)
      out_ += "<path " + ink + " d=\"M1,0v2\"/>";
    if (style.hatch == Hatch::falling || style.hatch == Hatch::level || style.hatch == Hatch::crossed)
      out_ += "<path " + ink + " d=\"M0,1h2\"/>";
    if (style.hatch == Hatch::dots)
      out_ += "<circle fill=\"" + hex(style.color) + "\" cx=\"1\" cy=\"1\" r=\"0.45\"/>";
    out_ += "</pattern>\n";
  }
}

void Drawing::rooms() {
  for (const int label : room_labels()) {
    std::string d;
    for (const SectionGeometry::Cell& cell : geometry_.cells) {
      if (cell.label != label) continue;
      for (std::size_t i = 0; i < cell.count; ++i) d += (i == 0 ? "M" : "L") + at(cell.corners[i]);
      d += "Z";
    }
    out_ += "<path id=\"" + room_id(label) + "\" fill=\"url(#hatch-" + room_id(label) +
            ")\" stroke=\"none\" d=\"" + d + "\"/>\n";
  }
}

void Drawing::segments(const char* name, const std::vector<SectionGeometry::Segment>& all, glm::vec3 color,
                       double width, const char* more) {
  std::string d;
  for (const auto& s : all) d += "M" + at(s.a) + "L" + at(s.b);
  out_ += "<path id=\"" + std::string(name) + "\" fill=\"none\" stroke=\"" + hex(color) +
          "\" stroke-width=\"" + number(width) + "\" stroke-linecap=\"round\" " + more + "d=\"" + d +
          "\"/>\n";
}

/// Where curves of Z and the rim of the input cross the plane.
void Drawing::curves() {
  const auto circle = [&](PlanePoint p, const std::string& style, double radius) {
    out_ +=
        "<circle " + style + " cx=\"" + x(p.u) + "\" cy=\"" + y(p.v) + "\" r=\"" + number(radius) + "\"/>\n";
  };
  if (figure_.view.curves.shown())
    for (const SectionGeometry::Crossing& c : geometry_.crossings)
      circle(c.at, c.border ? "class=\"border\" fill=\"#000000\"" : "class=\"triple\" fill=\"#000000\"",
             c.border ? 0.9 : 0.7);
  const Rim* rim = figure_.scene && figure_.view.rim.shown() ? open_rim(*figure_.scene) : nullptr;
  if (rim == nullptr) return;
  for (const RimCrossing& p : rim_crossings(*rim, plane_))
    circle(p.at,
           "class=\"rim\" fill=\"none\" stroke=\"" + hex(colors_.rim) + "\" stroke-width=\"" +
               (p.open ? "0.4\"" : "0.2\""),
           1.6);
}

/// The boundary samples B.
void Drawing::over_rim(double size) {
  if (!figure_.view.over_rim.shown() || geometry_.over_rim.empty()) return;
  std::string d;
  const std::string r = number(0.65 * size);
  for (const PlanePoint& p : geometry_.over_rim)
    if (inside(p, size))
      d += "M" + at(p) + "m0,-" + r + "l" + r + "," + r + "l-" + r + "," + r + "l-" + r + ",-" + r + "z";
  out_ += "<path id=\"samples-over-rim\" fill=\"none\" stroke=\"" + hex(colors_.rim) + "\" stroke-width=\"" +
          number(std::max(0.2 * size, 0.12)) + "\" d=\"" + d + "\"/>\n";
}

void Drawing::mark(const char* name, PlanePoint p, bool bad, bool outer, double size) {
  const double r = size / 2;
  if (bad) {
    const double cx = figure_.width / 2 + scale_ * (p.u - figure_.section.u),
                 cy = height_ / 2 - scale_ * (p.v - figure_.section.v);
    const auto point = [&](double dx, double dy) { return number(cx + dx) + "," + number(cy + dy); };
    out_ += "<path class=\"" + std::string(name) + "\" d=\"M" + point(-r, -r) + "L" + point(r, r) + "M" +
            point(-r, r) + "L" + point(r, -r) + "\"/>\n";
  } else {
    out_ += "<circle class=\"" + std::string(name) + "\" cx=\"" + x(p.u) + "\" cy=\"" + y(p.v) + "\" r=\"" +
            number(outer ? r : 0.8 * r) + "\"/>\n";
  }
}

void Drawing::points() {
  const InputPoints* points = figure_.points.get();
  if (points == nullptr || !figure_.view.points.shown()) return;
  const double size = std::clamp(
      std::min(0.3 * static_cast<double>(figure_.view.sample_size), points->spacing * scale_), 0.25, 3.0);
  const double reach = section_point_distance(*points);
  const auto group = [&](const char* name, bool dropped, const std::string& style) {
    out_ += "<g id=\"points-" + std::string(name) + "\" " + style + ">\n";
    for (std::size_t i = 0; i < points->size(); ++i) {
      const Vec3 p = points->position(i);
      if (points->dropped(i) != dropped || std::abs(plane_.height(p)) > reach) continue;
      const PlanePoint q = plane_.project(p);
      if (!inside(q, size)) continue;
      if (dropped)
        mark("dropped", q, true, true, 1.2 * size);
      else
        out_ += "<circle fill=\"" + hex(weight_color(ThemeKind::paper, points->weights[i])) + "\" cx=\"" +
                x(q.u) + "\" cy=\"" + y(q.v) + "\" r=\"" + number(size / 2) + "\"/>\n";
    }
    out_ += "</g>\n";
  };
  group("by-weight", false, "stroke=\"none\"");
  group("dropped", true,
        "fill=\"none\" stroke=\"" + hex(colors_.dropped) + "\" stroke-width=\"" + number(0.25 * size) +
            "\" stroke-linecap=\"round\"");
}

void Drawing::samples() {
  const ViewSettings& view = figure_.view;
  if (!view.samples.shown()) return;
  // Neighbours touch at most.
  const double spacing = state_.samples ? state_.samples->sigma * scale_ : 2;
  const double size = std::clamp(std::min(0.3 * static_cast<double>(view.sample_size), spacing), 0.25, 4.0);
  const std::string good = hex(state_.classifies() ? colors_.good : colors_.tetrahedron);
  const std::string thin = number(std::max(0.2 * size, 0.1));
  const struct {
    const char* name;
    bool bad, outer, shown;
    std::string style;
  } classes[] = {
      {"good-outer", false, true, view.good_samples.shown(), "fill=\"" + good + "\" stroke=\"none\""},
      {"good-inner", false, false, view.good_samples.shown(),
       "fill=\"#ffffff\" stroke=\"" + good + "\" stroke-width=\"" + thin + "\""},
      {"bad", true, true, view.bad_samples.shown(),
       "fill=\"none\" stroke=\"" + hex(colors_.bad) + "\" stroke-width=\"" +
           number(std::max(0.3 * size, 0.2)) + "\" stroke-linecap=\"round\""}};
  for (const auto& c : classes) {
    if (!c.shown) continue;
    out_ += "<g id=\"samples-" + std::string(c.name) + "\" " + c.style + ">\n";
    for (const auto& s : geometry_.samples)
      if (s.bad == c.bad && (c.bad || s.outer == c.outer) && inside(s.at, size))
        mark(c.name, s.at, c.bad, c.outer, c.bad ? 1.4 * size : size);
    out_ += "</g>\n";
  }
  over_rim(size);
}

void Drawing::next_point() {
  if (!figure_.view.highlight.shown() || state_.bad_samples == 0 || !state_.samples ||
      !state_.worst_sample.valid() || state_.worst_sample.index() >= state_.samples->size())
    return;
  const Vec3 p = state_.samples->positions[state_.worst_sample.index()];
  if (std::abs(plane_.height(p)) > 4 * state_.samples->sigma) return;
  const PlanePoint q = plane_.project(p);
  out_ += "<circle id=\"next\" fill=\"none\" stroke=\"" + hex(colors_.bad) + "\" stroke-width=\"0.4\" cx=\"" +
          x(q.u) + "\" cy=\"" + y(q.v) + "\" r=\"2.2\"/>\n";
}

void Drawing::line(const std::string& content, double left, double top, const char* anchor) {
  out_ += "<text x=\"" + number(left) + "\" y=\"" + number(top) + "\" text-anchor=\"" + anchor + "\">" +
          escaped_markup(content) + "</text>\n";
}

void Drawing::scale_bar(double top) {
  const double unit = figure_.delta > 0 ? figure_.delta : 1;
  const double length = round_length(figure_.width / 4 / (scale_ * unit));
  const double extent = length * unit * scale_, right = figure_.width - margin, left = right - extent;
  out_ += "<path id=\"scale-bar\" fill=\"none\" stroke=\"#000000\" stroke-width=\"0.4\" d=\"M" +
          number(left) + "," + number(top - 1) + "v2M" + number(left) + "," + number(top) + "H" +
          number(right) + "M" + number(right) + "," + number(top - 1) + "v2\"/>\n";
  line(short_number(length) +
           (figure_.delta > 0 ? " δ = " + short_number(length * unit) + " units" : " units"),
       left - 1.5, top + 1.1, "end");
}

void Drawing::legend(double top) {
  double left = margin;
  const auto next = [&](const std::string& glyph, const std::string& text, double extent) {
    out_ += glyph;
    line(text, left + 6, top + 1.1);
    left += extent;
  };
  const auto stroke = [&](glm::vec3 color, double width) {
    return "<path fill=\"none\" stroke=\"" + hex(color) + "\" stroke-width=\"" + number(width) + "\" d=\"M" +
           number(left) + "," + number(top) + "h4.5\"/>\n";
  };
  const auto circle = [&](const std::string& style) {
    return "<circle " + style + " cx=\"" + number(left + 3) + "\" cy=\"" + number(top) + "\" r=\"0.9\"/>\n";
  };
  const ViewSettings& view = figure_.view;
  if (view.zero_set.shown()) next(stroke(colors_.section_zero, 0.7), "Z", 11);
  if (other_shown()) next(stroke(colors_.other_zero, 0.5), "Z of the other run", 32);
  if (view.gamma.shown()) next(stroke(colors_.gamma, 0.5), "∂Γ", 13);
  for (const int label : room_labels())
    next("<rect x=\"" + number(left + 1) + "\" y=\"" + number(top - 1.4) +
             "\" width=\"4\" height=\"2.8\" fill=\"url(#hatch-" + room_id(label) + ")\"/>\n",
         label > 0 ? "outside" : "room " + std::to_string(-label), 20);
  if (!view.samples.shown()) return;
  if (view.good_samples.shown()) {
    next(circle("fill=\"" + hex(colors_.good) + "\""), "outer", 17);
    next(circle("fill=\"#ffffff\" stroke=\"" + hex(colors_.good) + "\" stroke-width=\"0.3\""), "inner", 17);
  }
  if (view.bad_samples.shown())
    next("<path fill=\"none\" stroke=\"" + hex(colors_.bad) + "\" stroke-width=\"0.4\" d=\"M" +
             number(left + 2) + "," + number(top - 1) + "l2,2m0,-2l-2,2\"/>\n",
         "misclassified", 20);
  if (view.over_rim.shown() && !geometry_.over_rim.empty())
    next("<path fill=\"none\" stroke=\"" + hex(colors_.rim) + "\" stroke-width=\"0.3\" d=\"M" +
             number(left + 3) + "," + number(top - 1.1) + "l1.1,1.1l-1.1,1.1l-1.1,-1.1z\"/>\n",
         "over the rim", 20);
}

void Drawing::caption(double top) {
  const CriteriaParameters& c = state_.criteria;
  std::string first = figure_.model + ", step " + std::to_string(state_.step);
  if (state_.event) first += ", " + std::string(name(state_.event->stage));
  first += ": T " + std::to_string(state_.complex.alive_tets()) + " tetrahedra, Z " +
           std::to_string(state_.zero_set.vertices.size()) + " vertices";
  if (state_.complex.form == ZeroForm::interpolated)
    first += ", " + std::to_string(state_.bad_samples) + " samples misclassified";
  line(first, margin, top);
  line("δ = " + short_number(c.delta) + ", σ = " + short_number(c.sigma) + ", α = " + short_number(c.alpha) +
           ", shrink " + short_number(c.shrink) +
           (figure_.view.level == 1
                ? std::string()
                : ", Ω drawn at " + short_number(static_cast<double>(figure_.view.level)) + " δ") +
           "; 1 mm = " + short_number(1 / scale_) + " units",
       margin, top + line_height);
}

std::string Drawing::text() {
  const double whole = height_ + 4.5 * line_height;
  const std::string w = number(figure_.width), h = number(whole);
  out_ =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" "
      "width=\"" +
      w + "mm\" height=\"" + h + "mm\" viewBox=\"0 0 " + w + " " + h + "\">\n";
  out_ += "<title>" + escaped_markup(figure_.model) + ", section at step " + std::to_string(state_.step) +
          "</title>\n<desc>One millimetre is " + number(1 / scale_, "%.12g") + " scene units.</desc>\n";
  out_ += "<defs><clipPath id=\"frame\"><rect x=\"0\" y=\"0\" width=\"" + w + "\" height=\"" +
          number(height_) + "\"/></clipPath>\n";
  hatches();
  out_ += "</defs>\n<rect width=\"" + w + "\" height=\"" + h +
          "\" fill=\"#ffffff\"/>\n<g id=\"section\" clip-path=\"url(#frame)\">\n";
  const ViewSettings& view = figure_.view;
  rooms();
  tolerance();
  if (view.tetrahedra.shown()) segments("triangulation", geometry_.tetrahedra, colors_.section_line, 0.15);
  if (view.gamma.shown()) segments("gamma", geometry_.gamma, colors_.gamma, 0.5);
  if (view.dropped.shown())
    segments("dropped", geometry_.dropped, colors_.rim, 0.5, "stroke-dasharray=\"1.2,1.2\" ");
  if (view.zero_set.shown()) segments("zero-set", geometry_.zero_set, colors_.section_zero, 0.7);
  if (other_shown())
    segments("other-zero", zero_segments(figure_.other->zero_set, plane_), colors_.other_zero, 0.5);
  curves();
  points();
  samples();
  next_point();
  if (figure_.xray && view.xray.shown())
    out_ += attempt_svg(attempt_section(*figure_.xray, figure_.study.get(), plane_,
                                        {view.invalid_regions, view.octree_cells, colors_}),
                        [this](PlanePoint p) {
                          return PlanePoint{figure_.width / 2 + scale_ * (p.u - figure_.section.u),
                                            height_ / 2 - scale_ * (p.v - figure_.section.v)};
                        });
  out_ += "</g>\n<g id=\"caption\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"" +
          number(text_size) + "\" fill=\"#000000\">\n";
  legend(height_ + line_height);
  scale_bar(height_ + line_height);
  caption(height_ + 2.5 * line_height);
  out_ += "</g>\n</svg>\n";
  return std::move(out_);
}

} // namespace

Lattice section_lattice(const DistanceGrid& grid, const SectionPlane& plane) {
  Lattice lattice;
  if (grid.empty()) return lattice;
  PlanePoint low{Box3::inf, Box3::inf}, high{-Box3::inf, -Box3::inf};
  for (int corner = 0; corner < 8; ++corner) {
    const PlanePoint p = plane.project({(corner & 1) ? grid.box.hi.x : grid.box.lo.x,
                                        (corner & 2) ? grid.box.hi.y : grid.box.lo.y,
                                        (corner & 4) ? grid.box.hi.z : grid.box.lo.z});
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const double longest = std::max(high.u - low.u, high.v - low.v);
  lattice.spacing = std::max(grid.voxel, longest / lattice_most);
  lattice.origin = {low.u - lattice.spacing, low.v - lattice.spacing};
  lattice.columns = static_cast<int>((high.u - low.u) / lattice.spacing) + 4;
  lattice.rows = static_cast<int>((high.v - low.v) / lattice.spacing) + 4;
  lattice.values.assign(static_cast<std::size_t>(lattice.columns) * static_cast<std::size_t>(lattice.rows),
                        grid.reach);
  for (int y = 1; y + 1 < lattice.rows; ++y)
    for (int x = 1; x + 1 < lattice.columns; ++x) {
      const Vec3 p =
          plane.lift({lattice.origin.u + x * lattice.spacing, lattice.origin.v + y * lattice.spacing});
      bool within = true;
      for (int k = 0; k < 3; ++k) within = within && p[k] >= grid.box.lo[k] && p[k] <= grid.box.hi[k];
      if (within)
        lattice.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(lattice.columns) +
                       static_cast<std::size_t>(x)] = static_cast<float>(grid.signed_value(p));
    }
  return lattice;
}

std::string section_svg(const StateSnapshot& state, const DistanceGrid* grid, const SectionFigure& figure) {
  return Drawing(state, grid, figure).text();
}

} // namespace isoscope
