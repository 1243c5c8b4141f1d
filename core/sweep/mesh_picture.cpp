// Facets over a fine depth buffer; each pixel is then the mean of its samples, darker where others stand
// before it.
#include "sweep/mesh_picture.h"

#include "base/pending_file.h"
#include "input/mesh_io.h"
#include "sweep/png.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isoscope::sweep {

namespace {

constexpr int fine = 3; ///< samples along each side of a pixel
constexpr double margin = 0.05;
constexpr std::uintmax_t largest_file = 64u << 20;
constexpr std::size_t most_edged = 6000; ///< facets whose edges can be told apart
constexpr Rgba clay{232, 223, 207, 255}, stone{196, 203, 211, 255}, edge{60, 66, 76, 255};
/// Of the palette: opaque from edge to clay, then the middle colour from nothing to opaque.
constexpr int shades = 192, opacities = 64;

/// What is seen through a sample; brightness from 0, an edge, to 1, and where it is in pixels.
struct Seen {
  float depth = -std::numeric_limits<float>::infinity();
  float brightness = 0;
  std::int32_t facet = -1;
};

struct Frame {
  Vec3 right, up, towards;
  Vec3 of(Vec3 p) const { return {dot(p, right), dot(p, up), dot(p, towards)}; }
};

Frame usual_frame() {
  const Vec3 towards = normalized({0.58, 0.40, 0.71}), right = normalized(cross({0, 1, 0}, towards));
  return {right, cross(towards, right), towards};
}

/// A light over the left shoulder and a weak one from the right; the far side of a facet is dimmer.
double shade(Vec3 n) {
  const Vec3 key = normalized({-0.45, 0.65, 0.75}), fill = normalized({0.9, 0.1, 0.3});
  const double side = n.z >= 0 ? 1 : 0.82;
  if (n.z < 0) n = -n;
  return side * (0.35 + 0.63 * std::max(0.0, dot(n, key)) + 0.14 * std::max(0.0, dot(n, fill)));
}

class Canvas {
 public:
  Canvas(unsigned width, unsigned height)
      : width_(static_cast<int>(width) * fine), height_(static_cast<int>(height) * fine),
        seen_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  void draw(std::int32_t facet, const Triangle3& t, Vec3 normal, bool edges) {
    const double twice = (t[1].x - t[0].x) * (t[2].y - t[0].y) - (t[1].y - t[0].y) * (t[2].x - t[0].x);
    if (std::abs(twice) < 1e-9) return;
    std::array<double, 3> height{}; ///< of each corner over the opposite edge, in samples
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
      height[i] = std::abs(twice) / std::max(std::hypot(b.x - a.x, b.y - a.y), 1e-12);
    }
    const auto [low_x, high_x] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [low_y, high_y] = std::minmax({t[0].y, t[1].y, t[2].y});
    const int x0 = std::max(0, static_cast<int>(low_x - 0.5)),
              x1 = std::min(width_ - 1, static_cast<int>(high_x + 0.5));
    const int y0 = std::max(0, static_cast<int>(low_y - 0.5)),
              y1 = std::min(height_ - 1, static_cast<int>(high_y + 0.5));
    const auto light = static_cast<float>(shade(normal));
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double px = x + 0.5, py = y + 0.5;
        std::array<double, 3> w{};
        for (std::size_t i = 0; i < 3; ++i) {
          const Vec3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
          w[i] = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / twice;
        }
        if (w[0] < 0 || w[1] < 0 || w[2] < 0) continue;
        const auto depth = static_cast<float>(w[0] * t[0].z + w[1] * t[1].z + w[2] * t[2].z);
        Seen& there = at(x, y);
        if (depth <= there.depth) continue;
        const double to_edge = std::min({w[0] * height[0], w[1] * height[1], w[2] * height[2]});
        const bool on_edge = edges && to_edge < 0.45 * fine;
        there = {depth, on_edge ? 0 : light, facet};
      }
  }

  Seen& at(int x, int y) {
    return seen_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(x)];
  }
  const Seen& at(int x, int y) const { return const_cast<Canvas*>(this)->at(x, y); }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }

 private:
  int width_, height_;
  std::vector<Seen> seen_;
};

/// How much light reaches a sample past what stands before it, 0 to 1: what rises over its facet's plane in
/// a wheel of directions takes some of it.
double openness(const Canvas& canvas, int x, int y, std::span<const Vec3> normals) {
  const Seen& here = canvas.at(x, y);
  const Vec3 n = normals[static_cast<std::size_t>(here.facet)];
  const double steep = std::max(std::abs(n.z), 0.2), slope_x = -n.x / std::copysign(steep, n.z),
               slope_y = n.y / std::copysign(steep, n.z); // rows go downwards
  constexpr int directions = 12;
  constexpr std::array<double, 3> radii{4.0 * fine, 9.0 * fine, 17.0 * fine};
  double taken = 0;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
    for (const double r : radii) {
      const double dx = r * std::cos(angle), dy = r * std::sin(angle);
      const int sx = x + static_cast<int>(std::lround(dx)), sy = y + static_cast<int>(std::lround(dy));
      if (!canvas.inside(sx, sy) || canvas.at(sx, sy).facet < 0) continue;
      const double rise = (canvas.at(sx, sy).depth - here.depth - slope_x * dx - slope_y * dy) / r;
      // What is far before it is another part that only happens to be there.
      taken += std::clamp(rise - 0.1, 0.0, 1.0) / (1 + std::max(0.0, rise - 1.5) * 2);
    }
  }
  return 1 - 0.85 * taken / (directions * static_cast<double>(radii.size()));
}

std::vector<Rgba> palette_of(const Rgba& light) {
  const auto mixed = [&](double part, double opacity) {
    Rgba c{};
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = static_cast<std::uint8_t>(std::lround(edge[i] + part * (light[i] - edge[i])));
    c[3] = static_cast<std::uint8_t>(std::lround(255 * opacity));
    return c;
  };
  std::vector<Rgba> palette;
  for (int i = 0; i < shades; ++i) palette.push_back(mixed(static_cast<double>(i) / (shades - 1), 1));
  for (int i = 0; i < opacities; ++i) palette.push_back(mixed(0.22, static_cast<double>(i) / opacities));
  return palette;
}

std::uint8_t pixel_of(const Canvas& canvas, int x, int y, std::span<const Vec3> normals) {
  double brightness = 0, covered = 0;
  for (int sy = 0; sy < fine; ++sy)
    for (int sx = 0; sx < fine; ++sx) {
      const Seen& s = canvas.at(x * fine + sx, y * fine + sy);
      if (s.facet < 0) continue;
      ++covered;
      brightness += s.brightness;
    }
  constexpr double all = fine * fine;
  if (covered < all) return static_cast<std::uint8_t>(shades + static_cast<int>(opacities * covered / all));
  const double open = openness(canvas, x * fine + fine / 2, y * fine + fine / 2, normals);
  const double value = std::clamp(brightness / all * open, 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(value * (shades - 1)));
}

} // namespace

std::string mesh_picture(std::span<const Vec3> points,
                         std::span<const std::array<std::uint32_t, 3>> triangles, const PictureLook& look) {
  if (triangles.empty() || look.width == 0 || look.height == 0) return {};
  const Frame frame = usual_frame();
  Box3 box;
  for (const auto& t : triangles)
    for (const std::uint32_t v : t) box.add(frame.of(points[v]));
  const double wide = look.width * fine, high = look.height * fine;
  const double scale = (1 - 2 * margin) * std::min(wide / std::max(box.hi.x - box.lo.x, 1e-300),
                                                   high / std::max(box.hi.y - box.lo.y, 1e-300));
  const Vec3 middle = box.center();
  const auto place = [&](Vec3 p) {
    const Vec3 q = scale * (frame.of(p) - middle);
    return Vec3{wide / 2 + q.x, high / 2 - q.y, q.z};
  };
  Canvas canvas(look.width, look.height);
  std::vector<Vec3> normals(triangles.size());
  const bool edges = look.result && triangles.size() <= most_edged;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& t = triangles[i];
    const Triangle3 there{points[t[0]], points[t[1]], points[t[2]]};
    Vec3 n = frame.of(normalized(area_vector(there)));
    if (!look.result && n.z < 0) n = -n; // of raw triangles sides mean nothing
    normals[i] = n;
    canvas.draw(static_cast<std::int32_t>(i), {place(there[0]), place(there[1]), place(there[2])}, n, edges);
  }
  IndexedPicture picture{look.width, look.height, palette_of(look.result ? clay : stone), {}};
  for (int y = 0; y < static_cast<int>(look.height); ++y)
    for (int x = 0; x < static_cast<int>(look.width); ++x)
      picture.pixels.push_back(pixel_of(canvas, x, y, normals));
  return png(picture);
}

void draw_result(const std::filesystem::path& mesh, bool result, const std::filesystem::path& picture) {
  std::error_code failure;
  std::filesystem::remove(picture, failure);
  const auto size = std::filesystem::file_size(mesh, failure);
  if (failure || size > largest_file) return;
  const auto soup = read_mesh(mesh);
  if (!soup) return;
  const std::string bytes = mesh_picture(soup->points, soup->triangles, {.result = result});
  if (bytes.empty()) return;
  PendingFile out;
  if (!out.open(picture)) return;
  out.append(bytes);
  [[maybe_unused]] const Status kept = out.commit();
}

} // namespace isoscope::sweep
