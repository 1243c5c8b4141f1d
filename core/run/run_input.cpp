// Files, bundled models, walls and grids.
#include "run/run_input.h"

#include "input/gallery.h"
#include "input/gallery_shapes.h"
#include "input/grid_readers.h"
#include "input/label_walls.h"

#include <memory>
#include <string>
#include <utility>

namespace isoscope {
namespace {

/// Reads the `which` surface, outer or inner, of the two around a volume.
Result<InputMesh> read_wall(const std::string& file, const std::string& which, const RunControl& control) {
  const auto refused = [&](const char* what) {
    return Error{ErrorCode::bad_input, "The " + which + " surface, " + file + ", " + what + ".",
                 "The walls of a volume are two closed surfaces."};
  };
  if (is_grid_file(file)) return refused("is a grid");
  auto mesh = read_input_mesh(file, control);
  if (mesh && mesh->soup.triangles.empty()) return refused("has points and no triangles");
  return mesh;
}

/// Reads the walls of a volume: the outer one first.
Result<InputMesh> load_walls(const std::string& outer, const std::string& inner, const RunControl& control) {
  auto walls = read_wall(outer, "outer", control);
  if (!walls) return walls.error();
  auto inside = read_wall(inner, "inner", control);
  if (!inside) return inside.error();
  TriangleSoup& soup = walls->soup;
  soup.outer_triangles = soup.triangles.size();
  append(soup, inside->soup);
  soup.name += " and " + inside->soup.name;
  walls->notes.insert(walls->notes.end(), inside->notes.begin(), inside->notes.end());
  return walls;
}

} // namespace

Result<InputMesh> read_run_input(const RunParameters& parameters, const RunControl& control) {
  const std::string& input = parameters.input;
  if (input.starts_with(gallery_prefix)) {
    auto soup = make_gallery_model(input.substr(gallery_prefix.size()));
    if (!soup) return soup.error();
    return InputMesh{std::move(*soup), {}};
  }
  if (!parameters.inside.empty()) return load_walls(input, parameters.inside, control);
  if (!is_grid_file(input)) return read_input_mesh(input, control);
  auto grid = read_grid(input, control);
  if (!grid) return grid.error();
  if (parameters.sides == SidesMode::multi) {
    auto walls = walls_between_labels(*grid);
    if (!walls) return walls.error();
    return InputMesh{std::move(*walls), {}};
  }
  InputMesh mesh;
  mesh.soup.name = grid->name;
  mesh.soup.grid = std::make_shared<const ScalarGrid>(std::move(*grid));
  return mesh;
}

Status check_volume(const TriangleSoup& soup, const RunParameters& p) {
  if (!soup.grid && (p.levels.given() || p.label))
    return Error{ErrorCode::usage,
                 std::string(p.label ? "--label" : "--levels") + " is given, and the input is no grid.",
                 "Give a NRRD file, or raw data with a header."};
  if (soup.gives_volume() && (p.drop_small > 0 || p.drop_thin))
    return Error{ErrorCode::usage, "Nothing can be left out of an input that gives the volume itself.",
                 std::string("Leave ") + (p.drop_thin ? "--drop-thin" : "--drop-small") + " out."};
  return {};
}

Result<TriangleSoup> load_input(const RunParameters& parameters) {
  auto mesh = read_run_input(parameters, RunControl{});
  if (!mesh) return mesh.error();
  return std::move(mesh->soup);
}

} // namespace isoscope
