// A z-buffer at twice the size, averaged down.
#include "ui/thumbnails.h"

#include "input/gallery.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace {

constexpr int oversampling = 2;
constexpr Vec3 base_color{0.62, 0.74, 0.86};

struct Raster {
  int width, height;
  std::vector<float> depth;
  std::vector<float> shade; ///< 0 where empty
};

/// Half the width of a point, in fine pixels.
constexpr double point_size = 2.5;

void fill(Raster& r, const std::array<Vec3, 3>& p, float shade) {
  const auto [x0, x1] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [y0, y1] = std::minmax({p[0].y, p[1].y, p[2].y});
  const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
  if (area == 0) return;
  for (int y = std::max(0, static_cast<int>(y0)); y <= std::min(r.height - 1, static_cast<int>(y1) + 1); ++y)
    for (int x = std::max(0, static_cast<int>(x0)); x <= std::min(r.width - 1, static_cast<int>(x1) + 1);
         ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const double b = ((px - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (py - p[0].y)) / area;
      const double c = ((p[1].x - p[0].x) * (py - p[0].y) - (px - p[0].x) * (p[1].y - p[0].y)) / area;
      if (b < 0 || c < 0 || b + c > 1) continue;
      const auto z = static_cast<float>(p[0].z + b * (p[1].z - p[0].z) + c * (p[2].z - p[0].z));
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(r.width) + static_cast<std::size_t>(x);
      if (z <= r.depth[at]) continue;
      r.depth[at] = z;
      r.shade[at] = shade;
    }
}

} // namespace

Thumbnail draw_thumbnail(const TriangleSoup& soup, int width, int height, bool opened) {
  Raster r{width * oversampling, height * oversampling, {}, {}};
  const auto cells = static_cast<std::size_t>(r.width) * static_cast<std::size_t>(r.height);
  r.depth.assign(cells, -1e30f);
  r.shade.assign(cells, 0);
  const double yaw = 0.6, pitch = 0.45;
  const Vec3 right{std::cos(yaw), 0, -std::sin(yaw)};
  const Vec3 back{std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
  const Vec3 up = cross(back, right);
  const auto turned = [&](Vec3 p) { return Vec3{dot(p, right), dot(p, up), dot(p, back)}; };
  Box3 box;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    for (const Vec3& p : soup.triangle(i)) box.add(turned(p));
  if (soup.is_point_set())
    for (const Vec3& p : soup.points) box.add(turned(p));
  const Vec3 extent = box.extent(), middle = box.center();
  const double scale =
      0.84 * std::min(r.width / std::max(extent.x, 1e-12), r.height / std::max(extent.y, 1e-12));
  const Vec3 light = normalized(Vec3{-0.35, 0.75, 0.8});
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle3 t = soup.triangle(i);
    std::array<Vec3, 3> p;
    const Vec3 center = turned((1.0 / 3) * (t[0] + t[1] + t[2])) - middle;
    if (opened && center.x > 0 && center.z > 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 q = turned(t[k]) - middle;
      p[k] = {r.width / 2.0 + scale * q.x, r.height / 2.0 - scale * q.y, q.z};
    }
    Vec3 normal = normalized(cross(turned(t[1]) - turned(t[0]), turned(t[2]) - turned(t[0])));
    if (normal.z < 0) normal = -normal;
    const double diffuse = std::max(0.0, dot(normal, light));
    fill(r, p, static_cast<float>(0.28 + 0.12 * (0.5 + 0.5 * normal.y) + 0.62 * diffuse));
  }
  if (soup.is_point_set())
    for (const Vec3& p : soup.points) {
      const Vec3 q = turned(p) - middle;
      const double x = r.width / 2.0 + scale * q.x, y = r.height / 2.0 - scale * q.y;
      const auto nearness = static_cast<float>(0.5 + q.z / std::max(extent.z, 1e-12));
      fill(r, {Vec3{x - point_size, y, q.z}, Vec3{x + point_size, y, q.z}, Vec3{x, y + point_size, q.z}},
           0.35f + 0.6f * nearness);
    }
  Thumbnail out{
      width, height,
      std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4)};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double light_sum = 0, cover = 0;
      for (int j = 0; j < oversampling; ++j)
        for (int i = 0; i < oversampling; ++i) {
          const auto at = static_cast<std::size_t>(y * oversampling + j) * static_cast<std::size_t>(r.width) +
                          static_cast<std::size_t>(x * oversampling + i);
          light_sum += static_cast<double>(r.shade[at]);
          cover += r.shade[at] > 0 ? 1 : 0;
        }
      if (cover == 0) continue;
      std::uint8_t* pixel = &out.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                         static_cast<std::size_t>(x)) *
                                        4];
      for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::clamp(255 * base_color[c] * light_sum / cover, 0.0, 255.0));
      pixel[3] = static_cast<std::uint8_t>(255 * cover / (oversampling * oversampling));
    }
  return out;
}

Thumbnails::~Thumbnails() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  if (worker_.joinable()) worker_.join();
}

void Thumbnails::begin(int width, int height, std::function<void()> notify) {
  if (worker_.joinable()) return;
  pictures_.resize(gallery().size());
  textures.resize(gallery().size(), 0);
  worker_ = std::thread([this, width, height, notify = std::move(notify)] {
    for (std::size_t i = 0; i < gallery().size(); ++i) {
      std::shared_ptr<const Thumbnail> made;
      if (const auto soup = make_gallery_model(gallery()[i].name))
        made = std::make_shared<const Thumbnail>(
            draw_thumbnail(*soup, width, height, gallery()[i].opened || gallery()[i].gives_volume()));
      {
        const std::lock_guard lock(mutex_);
        if (quit_) return;
        pictures_[i] = std::move(made);
        finished_ = i + 1 == gallery().size();
      }
      notify();
    }
  });
}

std::shared_ptr<const Thumbnail> Thumbnails::picture(std::size_t i) const {
  const std::lock_guard lock(mutex_);
  return i < pictures_.size() ? pictures_[i] : nullptr;
}

bool Thumbnails::finished() const {
  const std::lock_guard lock(mutex_);
  return finished_;
}

} // namespace isoscope
