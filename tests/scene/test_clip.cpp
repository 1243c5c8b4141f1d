// The clip: points, cells and stretches of rays agree with each other.
#include "scene/clip.h"

#include <doctest/doctest.h>

#include <random>

using namespace isoscope;
using Shape = ClipSettings::Shape;
using Mode = ClipSettings::Mode;

namespace {

ClipSettings settings(Shape shape, bool flipped) {
  ClipSettings s;
  s.shape = shape;
  s.point = {0.1, -0.2, 0.3};
  s.normal = normalized(Vec3{1, 2, -1});
  s.radius = 0.7;
  s.flipped = flipped;
  return s;
}

/// Reproducible numbers in [-2, 2].
struct Numbers {
  std::mt19937 engine{7};
  double next() { return 4.0 * static_cast<double>(engine()) / 4294967296.0 - 2.0; }
  Vec3 point() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }
};

} // namespace

TEST_CASE("a plane keeps its negative side, a slab and a ball their inside") {
  ClipSettings plane = settings(Shape::plane, false);
  CHECK(Clip(plane).keeps(plane.point - plane.normal));
  CHECK_FALSE(Clip(plane).keeps(plane.point + plane.normal));
  CHECK(Clip(plane).kept_distance(plane.point - 0.25 * plane.normal) == doctest::Approx(0.25));
  for (const Shape shape : {Shape::slab, Shape::ball}) {
    const ClipSettings s = settings(shape, false), f = settings(shape, true);
    CHECK(Clip(s).keeps(s.point));
    CHECK_FALSE(Clip(f).keeps(s.point));
    CHECK_FALSE(Clip(s).keeps(s.point + 0.8 * s.normal));
    CHECK_FALSE(Clip(s).keeps(s.point - 0.8 * s.normal));
    CHECK(Clip(f).keeps(s.point + 0.8 * s.normal));
  }
  CHECK(Clip(ClipSettings()).keeps({1e9, 0, 0}));
}

TEST_CASE("kept stretches of rays are those whose points are kept") {
  Numbers numbers;
  for (const Shape shape : {Shape::none, Shape::plane, Shape::slab, Shape::ball})
    for (const bool flipped : {false, true}) {
      const Clip clip(settings(shape, flipped));
      for (int trial = 0; trial < 200; ++trial) {
        const Vec3 origin = numbers.point(), direction = numbers.point();
        const auto kept = clip.kept_intervals(origin, direction, 0, 3);
        for (int i = 0; i < 40; ++i) {
          const double t = 3.0 * (i + 0.5) / 40;
          const double inside = clip.kept_distance(origin + t * direction);
          if (std::abs(inside) < 1e-9) continue;
          bool listed = false;
          for (const auto& [a, b] : kept) listed = listed || (t >= a && t <= b);
          CHECK(listed == (inside > 0));
        }
      }
    }
}

TEST_CASE("cells: whole by their centroid, straddling by their corners, cut if anything may be left") {
  Numbers numbers;
  for (const Shape shape : {Shape::plane, Shape::slab, Shape::ball})
    for (const bool flipped : {false, true})
      for (int trial = 0; trial < 300; ++trial) {
        const std::array<Vec3, 4> p{numbers.point(), numbers.point(), numbers.point(), numbers.point()};
        ClipSettings s = settings(shape, flipped);
        int kept = 0;
        for (const Vec3 q : p) kept += Clip(s).keeps(q) ? 1 : 0;
        const Vec3 centroid = 0.25 * (p[0] + p[1] + p[2] + p[3]);
        s.mode = Mode::whole_cells;
        CHECK(Clip(s).shows_cell(p) == Clip(s).keeps(centroid));
        CHECK_FALSE(Clip(s).cuts());
        s.mode = Mode::straddle;
        if (kept > 0 && kept < 4) CHECK(Clip(s).shows_cell(p));
        if (shape != Shape::slab && (kept == 0 || kept == 4)) CHECK_FALSE(Clip(s).shows_cell(p));
        s.mode = Mode::cut;
        if (kept > 0) CHECK(Clip(s).shows_cell(p));
      }
}

TEST_CASE("points follow their cells when cells are shown as wholes") {
  ClipSettings s = settings(Shape::plane, false);
  const Vec3 n = s.normal, side = cross(n, Vec3{0, 0, 1});
  const std::array<Vec3, 4> straddling{s.point + n, s.point - n, s.point + side, s.point - side};
  const Vec3 cut_away = s.point + 0.1 * n;
  s.mode = Mode::cut;
  CHECK_FALSE(Clip(s).shows_point(cut_away, straddling));
  s.mode = Mode::straddle;
  CHECK(Clip(s).shows_point(cut_away, straddling));
  CHECK_FALSE(Clip(s).shows_point(cut_away, {}));
}
