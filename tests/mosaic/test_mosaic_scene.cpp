// What a click in a mosaic meets: closed bricks from outside, facets in open ones.
#include "mosaic/mosaic.h"
#include "scene/mosaic_scene.h"

#include <doctest/doctest.h>

#include <set>

using namespace isoscope;

namespace {

/// Two bricks in a row along x, and a facet across the second one.
MosaicScene two_bricks() {
  MosaicScene scene;
  scene.tiles = {{{}, true, {{0, 0, 0}, {1, 1, 1}}}, {{}, true, {{1, 0, 0}, {2, 1, 1}}}};
  scene.bricks = {{{{0, 0, 0}, {1, 1, 1}}, 0}, {{{1, 0, 0}, {2, 1, 1}}, 1}};
  scene.facets = {{{{1.5, -1, -1}, {1.5, 3, -1}, {1.5, -1, 3}}}};
  scene.tile_of_facet = {1};
  return scene;
}

} // namespace

TEST_CASE("a ray meets the nearest closed brick, and through an open one its facets") {
  MosaicScene scene = two_bricks();
  const Camera::Ray along{{5, 0.5, 0.5}, {-1, 0, 0}}, beside{{5, 2, 0.5}, {-1, 0, 0}};
  CHECK(pick_mosaic(scene, along)->tile == 1);
  CHECK(pick_mosaic(scene, along)->point.x == doctest::Approx(1.97)); // with a gap
  CHECK(!pick_mosaic(scene, beside).has_value());
  scene.tiles[1].closed = false;
  CHECK(pick_mosaic(scene, along)->tile == 1);
  CHECK(pick_mosaic(scene, along)->point.x == doctest::Approx(1.5));
  scene.facets[0][0].y = 0.6; // the ray passes beside it
  scene.facets[0][2].y = 0.6;
  CHECK(pick_mosaic(scene, along)->tile == 0);
  const Camera::Ray away{{5, 0.5, 0.5}, {1, 0, 0}};
  CHECK(!pick_mosaic(scene, away).has_value());
  CHECK(scene.bounds().lo == Vec3{0, 0, 0});
  CHECK(scene.bounds().hi == Vec3{2, 1, 1});
}

TEST_CASE("each state of a tile has a colour of its own in every theme") {
  for (const ThemeKind theme : {ThemeKind::dark, ThemeKind::light, ThemeKind::paper}) {
    const SceneColors colors = scene_colors(theme);
    std::set<std::array<float, 3>> seen;
    for (std::size_t i = 0; i < tile_state_count; ++i) {
      const glm::vec3 c = state_color(static_cast<TileState>(i), colors);
      CHECK(seen.insert({c.r, c.g, c.b}).second);
    }
    const glm::vec3 mark = frozen_color(colors);
    CHECK(seen.insert({mark.r, mark.g, mark.b}).second);
  }
}
