// Widths and sizes in pixels of the interface become millimetres.
#include "scene/section_attempt_svg.h"

#include "scene/svg_words.h"

#include <string>
#include <vector>

namespace isoscope {
namespace {

using svg::hex, svg::number;

constexpr double millimetres = 0.26; ///< a pixel of the interface

std::string at(PlanePoint p) {
  return number(p.u) + "," + number(p.v);
}

class Page {
 public:
  explicit Page(const std::function<PlanePoint(const PlanePoint&)>& place) : place_(place) {}

  void area(const AttemptSection::Area& area) {
    std::vector<PlanePoint> corners;
    std::string d;
    for (const PlanePoint& p : area.corners) {
      corners.push_back(place_(p));
      d += (d.empty() ? "M" : "L") + at(corners.back());
    }
    const std::string color = hex(area.color);
    out += "<path fill=\"" + color + "\" fill-opacity=\"" + number(static_cast<double>(area.fill)) +
           "\" stroke=\"" + color + "\" stroke-opacity=\"" + number(static_cast<double>(area.line)) +
           "\" stroke-width=\"0.35\" d=\"" + d + "Z\"/>\n";
    if (!area.hatched) return;
    constexpr double spacing = 1.6;
    std::string hatch;
    for (const auto& [a, b] : hatch_lines(corners, spacing)) hatch += "M" + at(a) + "L" + at(b);
    out += "<path fill=\"none\" stroke=\"" + color + "\" stroke-opacity=\"0.6\" stroke-width=\"0.2\" d=\"" +
           hatch + "\"/>\n";
  }

  void line(const AttemptSection::Line& l) {
    out += "<path fill=\"none\" stroke=\"" + hex(l.color) + "\" stroke-opacity=\"" +
           number(static_cast<double>(l.strength)) + "\" stroke-width=\"" +
           number(millimetres * static_cast<double>(l.width)) + "\"" +
           (l.dashed ? " stroke-dasharray=\"1.2,1.2\"" : "") + " d=\"M" + at(place_(l.a)) + "L" +
           at(place_(l.b)) + "\"/>\n";
  }

  void mark(const AttemptSection::Mark& m) {
    const PlanePoint c = place_(m.at);
    const double r = 0.5 * millimetres * m.diameter;
    const auto number_of = static_cast<unsigned>(m.shape);
    const bool hollow = number_of >= static_cast<unsigned>(MarkerShape::hollow_square) ||
                        m.shape == MarkerShape::ring || m.shape == MarkerShape::circle;
    const bool strokes = m.shape == MarkerShape::cross || m.shape == MarkerShape::plus;
    const std::string color = hex(m.color);
    const std::string style = "fill=\"" + (hollow || strokes ? std::string("none") : color) + "\" stroke=\"" +
                              (hollow || strokes ? color : std::string("none")) +
                              "\" stroke-width=\"0.35\" opacity=\"" +
                              number(static_cast<double>(m.strength)) + "\"";
    const auto path = [&](std::initializer_list<PlanePoint> points, bool closed) {
      std::string d;
      for (const PlanePoint& p : points) d += (d.empty() ? "M" : "L") + at({c.u + r * p.u, c.v + r * p.v});
      out += "<path " + style + " d=\"" + d + (closed ? "Z" : "") + "\"/>\n";
    };
    switch (m.shape) {
    case MarkerShape::ring:
    case MarkerShape::disc:
    case MarkerShape::circle:
      out += "<circle " + style + " cx=\"" + number(c.u) + "\" cy=\"" + number(c.v) + "\" r=\"" + number(r) +
             "\"/>\n";
      break;
    case MarkerShape::square:
    case MarkerShape::hollow_square:
      path({{-0.8, -0.8}, {0.8, -0.8}, {0.8, 0.8}, {-0.8, 0.8}}, true);
      break;
    case MarkerShape::diamond:
    case MarkerShape::hollow_diamond:
      path({{0, -1}, {1, 0}, {0, 1}, {-1, 0}}, true);
      break;
    case MarkerShape::triangle:
    case MarkerShape::hollow_triangle:
      path({{0, -1}, {0.9, 0.7}, {-0.9, 0.7}}, true);
      break;
    case MarkerShape::cross:
      path({{-0.8, -0.8}, {0.8, 0.8}}, false);
      path({{-0.8, 0.8}, {0.8, -0.8}}, false);
      break;
    case MarkerShape::plus:
      path({{-1, 0}, {1, 0}}, false);
      path({{0, -1}, {0, 1}}, false);
      break;
    }
  }

  std::string out;

 private:
  const std::function<PlanePoint(const PlanePoint&)>& place_;
};

} // namespace

std::string attempt_svg(const AttemptSection& section,
                        const std::function<PlanePoint(const PlanePoint&)>& place) {
  Page page(place);
  const auto group = [&](const char* name, const auto& draw) {
    page.out += "<g id=\"" + std::string(name) + "\">\n";
    draw();
    page.out += "</g>\n";
  };
  const auto areas = [&](const char* name, AttemptSection::Role role) {
    if (section.count(role) == 0) return;
    group(name, [&] {
      for (const AttemptSection::Area& area : section.areas)
        if (area.role == role) page.area(area);
    });
  };
  areas("edge-cells", AttemptSection::Role::cell);
  areas("edge-kernel", AttemptSection::Role::kernel);
  areas("edge-psi", AttemptSection::Role::invalid);
  group("edge-lines", [&] {
    for (const AttemptSection::Line& l : section.lines) page.line(l);
  });
  group("edge-marks", [&] {
    for (const AttemptSection::Mark& m : section.marks) page.mark(m);
  });
  return std::move(page.out);
}

} // namespace isoscope
