// Pieces of surfaces with known answers on small lattices, however the cells are shared out among blocks.
#include "base/geometry.h"
#include "tolerance/kuhn_simplices.h"
#include "tolerance/surface_pieces.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

using namespace isoscope;

namespace {

using Place = SurfacePieces::Place;
using Inside = std::function<bool(Vec3)>;

constexpr std::uint32_t cells_by_axis = 16;

struct Counted {
  std::vector<std::size_t> pieces;
  long euler_characteristic = 0;
};

/// The cells of one block, counted as those of Ω's octree are.
SurfacePieces count_block(const std::vector<Place>& cells, const Inside& outer,
                          const std::function<std::uint16_t(Vec3)>& component, long& euler) {
  const auto simplices = kuhn::simplices_at_corner();
  const auto euler_of = kuhn::euler_by_outer_corners(simplices);
  const auto crossings = kuhn::crossings_by_outer_corners(simplices);
  std::map<Place, std::uint32_t> numbers;
  std::vector<Place> places;
  const auto number = [&](const Place& p) {
    const auto [at, added] = numbers.emplace(p, static_cast<std::uint32_t>(places.size()));
    if (added) places.push_back(p);
    return at->second;
  };
  const auto position = [](const Place& p) { return Vec3{double(p[0]), double(p[1]), double(p[2])}; };
  for (const Place& c : cells)
    for (unsigned k = 0; k < 8; ++k) number({c[0] + (k & 1u), c[1] + (k >> 1 & 1u), c[2] + (k >> 2)});

  PiecesOfBlock pieces(places.size());
  for (const Place& c : cells) {
    std::array<std::uint32_t, 8> corner{};
    unsigned mask = 0;
    for (unsigned k = 0; k < 8; ++k) {
      corner[k] = number({c[0] + (k & 1u), c[1] + (k >> 1 & 1u), c[2] + (k >> 2)});
      pieces.see(corner[k]);
      mask |= (outer(position(places[corner[k]])) ? 1u : 0u) << k;
    }
    euler += euler_of[mask];
    const auto vertex = [&](const kuhn::CrossedEdge& e) {
      return PiecesOfBlock::vertex(corner[e.low], e.direction, e.low_is_outer);
    };
    for (const kuhn::CrossedEdge& e : crossings[mask].vertices)
      pieces.add(vertex(e), component(position(places[corner[e.inner()]])));
    for (const auto& [a, b] : crossings[mask].links) pieces.join(vertex(a), vertex(b));
  }
  return pieces.settled([&](std::uint32_t i) { return places[i]; });
}

Counted count(
    const Inside& inside, std::uint32_t blocks, std::size_t components = 1,
    const std::function<std::uint16_t(Vec3)>& component = [](Vec3) { return std::uint16_t{0}; }) {
  std::vector<std::vector<Place>> cells(blocks);
  for (std::uint32_t z = 0; z < cells_by_axis; ++z)
    for (std::uint32_t y = 0; y < cells_by_axis; ++y)
      for (std::uint32_t x = 0; x < cells_by_axis; ++x) {
        // Slabs of slanted bars: neighbours stand in several blocks, and some of them inside of one.
        const std::uint32_t block = blocks == 1 ? 0 : ((x + 2 * y) / 5 + z / 3) % blocks;
        cells[block].push_back({x, y, z});
      }
  Counted counted;
  SurfacePieces all;
  const auto outer = [&](Vec3 p) { return !inside(p); };
  for (const auto& block : cells) all.add(count_block(block, outer, component, counted.euler_characteristic));
  counted.pieces = all.count(components, RunControl());
  return counted;
}

Inside ball(Vec3 center, double radius) {
  return [=](Vec3 p) { return distance(p, center) < radius; };
}

} // namespace

TEST_CASE("pieces are counted alike however cells are shared out") {
  const Inside a = ball({4.2, 4.1, 4.3}, 2.6), b = ball({11.4, 4.3, 4.2}, 2.2),
               c = ball({8.1, 11.2, 10.3}, 3.1);
  const Inside balls = [&](Vec3 p) { return a(p) || b(p) || c(p); };
  const Inside torus = [](Vec3 p) {
    const double ring = std::hypot(p.x - 8.1, p.y - 8.2) - 5.1;
    return std::hypot(ring, p.z - 8.3) < 2.1;
  };
  const Inside shell = [](Vec3 p) {
    const double r = distance(p, Vec3{8.1, 8.2, 8.3});
    return r < 6.6 && r > 3.4;
  };
  for (const std::uint32_t blocks : {1u, 2u, 5u, 13u}) {
    CAPTURE(blocks);
    CHECK(count(balls, blocks).pieces == std::vector<std::size_t>{3});
    CHECK(count(balls, blocks).euler_characteristic == 6);
    CHECK(count(torus, blocks).pieces == std::vector<std::size_t>{1});
    CHECK(count(torus, blocks).euler_characteristic == 0);
    CHECK(count(shell, blocks).pieces == std::vector<std::size_t>{2});
    CHECK(count(shell, blocks).euler_characteristic == 4);
  }
}

TEST_CASE("each boundary component has pieces of its own") {
  const Inside a = ball({4.2, 4.1, 4.3}, 2.6), b = ball({11.4, 4.3, 4.2}, 2.2),
               c = ball({8.1, 11.2, 10.3}, 3.1);
  const Inside balls = [&](Vec3 p) { return a(p) || b(p) || c(p); };
  const auto by_ball = [&](Vec3 p) { return static_cast<std::uint16_t>(c(p) ? 2 : 0); };
  for (const std::uint32_t blocks : {1u, 7u})
    CHECK(count(balls, blocks, 3, by_ball).pieces == std::vector<std::size_t>{2, 0, 1});
}

TEST_CASE("a link to what is no vertex joins nothing") {
  PiecesOfBlock block(4);
  const auto vertex = [](std::uint32_t corner) { return PiecesOfBlock::vertex(corner, 1, true); };
  block.add(vertex(0), 0);
  block.add(vertex(1), 0);
  block.join(vertex(0), vertex(3));
  block.join(vertex(3), vertex(1));
  SurfacePieces all;
  all.add(block.settled([](std::uint32_t corner) { return Place{corner, 0, 0}; }));
  CHECK(all.count(1, RunControl()) == std::vector<std::size_t>{2});

  PiecesOfBlock other(1);
  other.add(vertex(0), 0);
  all.add(other.settled([](std::uint32_t) { return Place{3, 0, 0}; }));
  CHECK(all.count(1, RunControl()) == std::vector<std::size_t>{1});
}
