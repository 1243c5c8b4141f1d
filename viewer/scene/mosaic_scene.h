// Bricks of tiles with the parts of Z in them, as plain data to be drawn and picked.
#pragma once

#include "base/geometry.h"
#include "scene/camera.h"
#include "scene/palette.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace isoscope {

struct MosaicScene {
  struct Brick {
    Box3 box;
    std::uint32_t tile = 0; ///< into the tiles
  };
  struct Tile {
    glm::vec3 color{0};
    bool closed = true; ///< its bricks hide what is in them; else they are outlines around its facets
    Box3 box;           ///< of its bricks
  };
  std::vector<Tile> tiles;
  std::vector<Brick> bricks;
  std::vector<Triangle3> facets;
  std::vector<std::uint32_t> tile_of_facet; ///< by facet
  std::vector<Vec3> frozen;                 ///< vertices of Z that are marked
  Box3 bounds() const;
};

/// Of the marks at frozen vertices.
glm::vec3 frozen_color(const SceneColors& colors);
/// A closed brick as it is drawn: with a gap to the next one.
Box3 drawn_box(const Box3& brick);

/// What a ray meets first: a closed brick, or a facet of a tile that is open.
struct MosaicPick {
  std::uint32_t tile = 0;
  Vec3 point;
};
std::optional<MosaicPick> pick_mosaic(const MosaicScene& scene, const Camera::Ray& ray);

} // namespace isoscope
