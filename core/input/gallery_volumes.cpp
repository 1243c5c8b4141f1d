// Two walls from tori, a grid from six bumps.
#include "input/gallery_shapes.h"

#include "input/exact_circle.h"
#include "input/level_surface.h"

namespace isoscope {

TriangleSoup make_nested_tori() {
  TriangleSoup model = make_torus(1, 0.42, 64, 32);
  model.outer_triangles = model.triangles.size();
  append(model, make_torus(1.05, 0.2, 64, 24));
  return model;
}

TriangleSoup make_density() {
  constexpr std::size_t n = 48;
  constexpr int beads = 6;
  // (1 - r²/R²)³ inside of R: like a Gaussian, but the same bits with every library.
  constexpr double reach = 0.85;
  auto grid = std::make_shared<ScalarGrid>();
  grid->name = "density";
  grid->size = {n, n, n / 2};
  grid->spacing = Vec3{1, 1, 1} * (4.0 / (n - 1));
  grid->origin = {-2, -2, -0.5 * grid->spacing.z * (n / 2 - 1)};
  grid->values.reserve(n * n * (n / 2));
  for (std::size_t z = 0; z < n / 2; ++z)
    for (std::size_t y = 0; y < n; ++y)
      for (std::size_t x = 0; x < n; ++x) {
        double density = 0;
        for (int i = 0; i < beads; ++i) {
          const CirclePoint bead = circle_point(i, beads);
          const Vec3 from_bead = grid->point(x, y, z) - Vec3{bead.cosine, bead.sine, 0};
          const double u = squared_length(from_bead) / (reach * reach);
          if (u < 1) density += (1 - u) * (1 - u) * (1 - u);
        }
        grid->values.push_back(static_cast<float>(density));
      }
  TriangleSoup model;
  const RunControl control;
  for (const double level : {density_low, density_high}) add_level_surface(*grid, level, model, control);
  model.grid = std::move(grid);
  return model;
}

} // namespace isoscope
