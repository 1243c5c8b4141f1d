// Places of handles and small components.
#include "run/topology_places.h"

#include "input/gallery.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

using namespace isoscope;

namespace {

TriangleMesh gallery_mesh(const std::string& name) {
  const auto made = make_gallery_model(name);
  REQUIRE(made.ok());
  return {made->points, made->triangles};
}

void append(TriangleMesh& mesh, const TriangleMesh& other, double scale, Vec3 offset) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (const Vec3 p : other.points) mesh.points.push_back(scale * p + offset);
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// The numbers between the first parentheses.
Vec3 first_place(const std::string& words) {
  const auto at = words.find('(');
  REQUIRE(at != std::string::npos);
  Vec3 p;
  REQUIRE(std::sscanf(words.c_str() + at, "(%lf, %lf, %lf)", &p.x, &p.y, &p.z) == 3);
  return p;
}

} // namespace

TEST_CASE("A sphere has nothing to look at") {
  CHECK(topology_places(gallery_mesh("sphere"), RunControl()).empty());
}

TEST_CASE("The narrowest handles are named, the narrower first, and the smallest component") {
  const TriangleMesh torus = gallery_mesh("torus");
  const double size = TriangleSoup{torus.points, torus.triangles, {}}.bounds().longest_edge();
  TriangleMesh mesh = torus;
  std::string words = topology_places(mesh, RunControl());
  CHECK(words.find("Its narrowest handle is near (") == 0);
  // Around the tube: off the axis, within the tube.
  const double off_axis = length(first_place(words) - Vec3{});
  CHECK(off_axis > 0.2 * size);
  CHECK(off_axis < 0.5 * size);

  append(mesh, torus, 0.25, {3 * size, 0, 0});
  words = topology_places(mesh, RunControl());
  CHECK(words.find("The narrowest handles of its components are near (") == 0);
  CHECK(distance(first_place(words), {3 * size, 0, 0}) < 0.15 * size);
  const auto smallest = words.find("The smallest component is near (");
  REQUIRE(smallest != std::string::npos);
  CHECK(distance(first_place(words.substr(smallest)), {3 * size, 0, 0}) < 0.01 * size);
}

TEST_CASE("Of rooms the handles of each boundary are named, with the room") {
  TriangleMesh mesh = gallery_mesh("sphere");
  const double size = TriangleSoup{mesh.points, mesh.triangles, {}}.bounds().longest_edge();
  mesh.labels.assign(mesh.triangles.size(), {+1, -1});
  CHECK(topology_places(mesh, certify_regions(mesh), RunControl()).empty());
  append(mesh, gallery_mesh("torus"), 1, {3 * size, 0, 0});
  mesh.labels.resize(mesh.triangles.size(), {+1, -2});
  const std::string words = topology_places(mesh, certify_regions(mesh), RunControl());
  CAPTURE(words);
  CHECK(words.find("The boundary of the outside has a handle near (") == 0);
  CHECK(words.find(", of room 2 has a handle near (") != std::string::npos);
  CHECK(words.find("room 1") == std::string::npos);
  CHECK(std::abs(first_place(words).x - 3 * size) < size);
}
