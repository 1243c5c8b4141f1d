// Chooses the kind of field by the input.
#include "run/make_field.h"

#include "base/numbers.h"
#include "base/place.h"
#include "input/label_grid.h"
#include "input/level_surface.h"
#include "tolerance/grid_field.h"
#include "tolerance/index_building.h"
#include "tolerance/surface_pair_field.h"

namespace isoscope {
namespace {

/// A volume this thin against its size takes very many samples: its narrowest place is told.
constexpr double thin_volume = 0.002;

InputTopology known_sides() {
  InputTopology topology;
  topology.side_rule = SideRule::given;
  return topology;
}

TriangleSoup part(const TriangleSoup& soup, std::size_t begin, std::size_t end) {
  TriangleSoup one{soup.points, {}, soup.name};
  one.triangles.assign(soup.triangles.begin() + static_cast<std::ptrdiff_t>(begin),
                       soup.triangles.begin() + static_cast<std::ptrdiff_t>(end));
  return one;
}

Result<FieldInput> between_walls(const TriangleSoup& input, const RunControl& control) {
  auto pair = join_surfaces(part(input, 0, input.outer_triangles),
                            part(input, input.outer_triangles, input.triangles.size()), control);
  if (!pair) return pair.error();
  auto field = SurfacePairField::make(std::move(*pair), control);
  if (!field) return field.error();
  FieldInput made{.field = *field, .topology = known_sides(), .delta = (*field)->delta()};
  if (made.delta < thin_volume * (*field)->bounds().longest_edge())
    made.notes.push_back(
        "The surfaces come as near to each other as " + general(2 * made.delta, 4) + ", near " +
        place((*field)->narrowest(), place_digits) +
        ": half of that is δ everywhere, and samples are as dense. A larger --sigma takes fewer.");
  return made;
}

Result<FieldInput> between_levels(const std::shared_ptr<const TriangleSoup>& input,
                                  const RunParameters& parameters, const RunControl& control) {
  std::shared_ptr<const ScalarGrid> grid = input->grid;
  Levels levels = parameters.levels;
  if (parameters.label) {
    auto distance = label_distance(*grid, *parameters.label, control);
    if (!distance) return distance.error();
    grid = std::make_shared<const ScalarGrid>(std::move(*distance));
    if (!levels.given()) levels = {-label_level, label_level};
  }
  if (!levels.given())
    return Error{ErrorCode::usage, "The input is a grid, and the levels between which Ω lies are not given.",
                 "Give --levels LO HI, or --label N for a segmentation."};
  auto field = GridField::make(grid, levels.low, levels.high, control);
  if (!field) return field.error();
  auto shown = std::make_shared<TriangleSoup>();
  shown->name = input->name;
  shown->grid = input->grid;
  for (const double level : {levels.low, levels.high}) add_level_surface(*grid, level, *shown, control);
  return FieldInput{
      .field = *field, .topology = known_sides(), .delta = (*field)->delta(), .shown = std::move(shown)};
}

} // namespace

Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, std::optional<double> delta,
                              const RunControl& control) {
  if (input->grid) return between_levels(input, parameters, control);
  if (input->outer_triangles > 0) return between_walls(*input, control);
  FieldInput made;
  if (is_field_of_points(*input, parameters)) {
    made.points = make_point_field(input, parameters, delta, control);
    made.field = made.points.index;
    made.topology.side_rule = SideRule::depth;
    return made;
  }
  // What this needs is given back before the index is there.
  made.topology = analyse_input(*input, parameters.sides, control);
  made.field = build_index(*input, control);
  return made;
}

} // namespace isoscope
