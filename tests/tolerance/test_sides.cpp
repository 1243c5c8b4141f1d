// Which side points are on where closed parts overlap, touch, lie inside each other or cannot be oriented.
#include "tolerance/facet_copies.h"
#include "tolerance/shapes.h"
#include "tolerance/thin_parts.h"
#include "tolerance/tolerance_volume.h"

#include <doctest/doctest.h>

using namespace isoscope;
using isoscope::testing::add_box;
using isoscope::testing::Random;

namespace {

struct Analysed {
  explicit Analysed(const TriangleSoup& soup, SidesMode mode = SidesMode::automatic)
      : index(std::make_shared<const ClosestPointIndex>(soup)), topology(analyse_input(soup, mode)),
        sides(index, topology.side_rule, topology.turns) {}
  std::shared_ptr<const ClosestPointIndex> index;
  InputTopology topology;
  InputSides sides;
};

Result<ToleranceVolume> build(const TriangleSoup& soup, double delta, SidesMode mode = SidesMode::automatic) {
  const auto index = std::make_shared<const ClosestPointIndex>(soup);
  return ToleranceVolume::build(index, analyse_input(soup, mode), {delta, 0.95}, RunControl());
}

void flip(TriangleSoup& soup, std::size_t begin, std::size_t end) {
  for (std::size_t t = begin; t < end; ++t) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
}

bool within(Vec3 p, Vec3 lo, Vec3 hi) {
  return p.x > lo.x && p.y > lo.y && p.z > lo.z && p.x < hi.x && p.y < hi.y && p.z < hi.z;
}

/// Two boxes that overlap at a corner.
TriangleSoup overlapping_boxes() {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  add_box(soup, {0.6, 0.3, 0.2}, {1.6, 1.3, 1.2});
  return soup;
}
bool in_overlapping_boxes(Vec3 p) {
  return within(p, {0, 0, 0}, {1, 1, 1}) || within(p, {0.6, 0.3, 0.2}, {1.6, 1.3, 1.2});
}

template <class Expected> std::size_t wrong_sides(const Analysed& a, const Expected& expected) {
  Random random(8);
  const Box3 box = a.index->bounds().grown(0.2);
  std::size_t wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = random.in_box(box);
    wrong += a.sides.inside(p) != expected(p) ? 1u : 0u;
  }
  return wrong;
}

/// A Klein bottle as a tube of figure-eight section, turned by half a turn on its way round: closed,
/// one-sided.
TriangleSoup klein_bottle() {
  TriangleSoup soup;
  constexpr unsigned n = 32, m = 16;
  const double turn = 2 * std::numbers::pi;
  const auto id = [&](unsigned i, unsigned j) {
    if (i == n) return (m - j) % m; // the section comes back turned over
    return i * m + j % m;
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < m; ++j) {
      const double u = turn * i / n, v = turn * j / m, c = std::cos(u / 2), s = std::sin(u / 2);
      const double r = 2 + c * std::sin(v) - s * std::sin(2 * v);
      soup.points.push_back({r * std::cos(u), r * std::sin(u), s * std::sin(v) + c * std::sin(2 * v)});
    }
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < m; ++j) {
      soup.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return soup;
}

} // namespace

TEST_CASE("overlapping parts are their union, whatever single facets do") {
  const TriangleSoup soup = overlapping_boxes();
  TriangleSoup twice = soup, opposite = soup, turned = soup, doubled = soup, everything = soup;
  twice.triangles.push_back(twice.triangles[5]);
  opposite.triangles.push_back(opposite.triangles[5]);
  flip(opposite, 24, 25);
  flip(turned, 3, 4);
  flip(turned, 17, 18);
  for (std::size_t t = 0; t < 12; ++t) doubled.triangles.push_back(doubled.triangles[t]);
  flip(everything, 0, 24);
  for (const TriangleSoup& s : {soup, twice, opposite, turned, doubled, everything}) {
    const Analysed a(s);
    CHECK(a.topology.side_rule == SideRule::winding);
    CHECK(a.topology.sides_known());
    CHECK(wrong_sides(a, in_overlapping_boxes) == 0);
  }
}

TEST_CASE("the same body twice is that body") {
  for (const bool inside_out : {false, true}) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    if (inside_out) flip(soup, 12, 24);
    CHECK(wrong_sides(Analysed(soup), [](Vec3 p) { return within(p, {0, 0, 0}, {1, 1, 1}); }) == 0);
  }
}

TEST_CASE("facets that are there again are left out where what is left is closed and bounds the same") {
  const auto rest = [](const TriangleSoup& soup) {
    return without_needless_copies(std::make_shared<const TriangleSoup>(soup), RunControl());
  };
  const TriangleSoup soup = overlapping_boxes();
  CHECK(rest(soup)->triangles == soup.triangles);
  TriangleSoup twice = soup, own_points = soup, turned_first = soup, bodies = soup;
  twice.triangles.push_back(twice.triangles[5]);
  twice.triangles.push_back(twice.triangles[5]);
  for (const auto v : soup.triangles[5]) own_points.points.push_back(soup.points[v]);
  const auto last = static_cast<std::uint32_t>(own_points.points.size());
  own_points.triangles.push_back({last - 2, last - 1, last - 3});
  bodies.triangles.insert(bodies.triangles.end(), soup.triangles.begin(), soup.triangles.end());
  for (const TriangleSoup& s : {twice, own_points, bodies}) CHECK(rest(s)->triangles == soup.triangles);
  // Of two that run both ways the one that fits stays.
  turned_first.triangles.push_back(turned_first.triangles[5]);
  flip(turned_first, 5, 6);
  const auto kept = rest(turned_first);
  CHECK(kept->triangles.size() == soup.triangles.size());
  CHECK(analyse_input(*kept).consistently_oriented);

  // The common face of two boxes closes both, and of what is open nothing is left out.
  TriangleSoup pair, open;
  add_box(pair, {0, 0, 0}, {1, 1, 1});
  add_box(pair, {1, 0, 0}, {2, 1, 1});
  CHECK(rest(pair)->triangles == pair.triangles);
  add_box(open, {0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  open.triangles.push_back(open.triangles[0]);
  CHECK(rest(open)->triangles == open.triangles);
  // A body in a cavity of its own shape fills it.
  TriangleSoup filled;
  add_box(filled, {0, 0, 0}, {3, 3, 3});
  add_box(filled, {1, 1, 1}, {2, 2, 2});
  flip(filled, 12, 24);
  add_box(filled, {1, 1, 1}, {2, 2, 2});
  CHECK(rest(filled)->triangles == filled.triangles);
}

TEST_CASE("boxes that share a face, an edge or a vertex are closed, and a face doubled elsewhere is one") {
  const std::array<Vec3, 3> corners{{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}}};
  for (const Vec3 corner : corners)
    for (const bool doubled : {false, true}) {
      TriangleSoup soup;
      add_box(soup, {0, 0, 0}, {1, 1, 1});
      add_box(soup, corner, corner + Vec3{1, 1, 1});
      if (doubled) soup.triangles.push_back(soup.triangles[0]);
      const Analysed a(soup);
      CHECK_FALSE(a.topology.closed_manifold);
      CHECK(a.topology.side_rule == SideRule::winding);
      CHECK(wrong_sides(a, [&](Vec3 p) {
              return within(p, {0, 0, 0}, {1, 1, 1}) || within(p, corner, corner + Vec3{1, 1, 1});
            }) == 0);
    }
}

TEST_CASE("parts with facets turned at random run outwards, and inwards where they are cavities") {
  TriangleSoup soup = overlapping_boxes();
  add_box(soup, {0.05, 0.05, 0.05}, {0.5, 0.5, 0.5});
  Random random(3);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (random.unit() < 0.5) flip(soup, t, t + 1);
  const Analysed a(soup);
  CHECK(a.topology.side_rule == SideRule::winding);
  CHECK(wrong_sides(a, [](Vec3 p) {
          return in_overlapping_boxes(p) && !within(p, {0.05, 0.05, 0.05}, {0.5, 0.5, 0.5});
        }) == 0);
}

TEST_CASE("a cavity of one of two overlapping parts is filled where the other one is") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_box(soup, {1, 1, 1}, {3, 3, 3});
  flip(soup, 12, 24);
  add_box(soup, {2, 1.5, 1.5}, {6, 2.5, 2.5});
  const Analysed a(soup);
  CHECK(wrong_sides(a, [](Vec3 p) {
          return within(p, {2, 1.5, 1.5}, {6, 2.5, 2.5}) ||
                 (within(p, {0, 0, 0}, {4, 4, 4}) && !within(p, {1, 1, 1}, {3, 3, 3}));
        }) == 0);
}

TEST_CASE("a shell inside another is a cavity by parity, with a note where it is oriented alike") {
  for (const bool alike : {false, true}) {
    TriangleSoup soup;
    add_box(soup, {0, 0, 0}, {1, 1, 1});
    add_box(soup, {0.3, 0.3, 0.3}, {0.7, 0.7, 0.7});
    if (!alike) flip(soup, 12, 24);
    const auto v = build(soup, 0.03);
    REQUIRE(v.ok());
    CHECK(v->sides().rule() == SideRule::parity);
    REQUIRE(v->regions().size() == 3);
    CHECK(v->sides().label({0.5, 0.5, 0.5}) == +1);
    CHECK(v->side_notes().size() == (alike ? 1 : 0));
    if (alike) CHECK(v->side_notes()[0].find("odd for a cavity") != std::string::npos);

    const auto solid = build(soup, 0.03, SidesMode::winding);
    REQUIRE(solid.ok());
    CHECK(solid->sides().label({0.5, 0.5, 0.5}) == (alike ? -1 : +1));
    CHECK(solid->has_inner_walls() == alike);
    CHECK(solid->side_notes().size() == (alike ? 1 : 0));
    CHECK(find_thin_parts(*solid).empty());
  }
}

TEST_CASE("an overlap counts as outside by parity, when that is asked for") {
  const Analysed a(overlapping_boxes(), SidesMode::parity);
  CHECK(a.topology.side_rule == SideRule::parity);
  CHECK_FALSE(a.topology.sides_known());
  CHECK_FALSE(a.sides.inside({0.8, 0.6, 0.6}));
  CHECK(a.sides.inside({0.2, 0.2, 0.2}));
}

TEST_CASE("a part turned inside out that overlaps others is named") {
  TriangleSoup soup = overlapping_boxes();
  flip(soup, 12, 24);
  const auto v = build(soup, 0.03);
  REQUIRE(v.ok());
  REQUIRE(v->side_notes().size() == 1);
  CHECK(v->side_notes()[0].find("turned inside out") != std::string::npos);
  CHECK(v->sides().label({0.8, 0.6, 0.6}) == +1);
  CHECK(v->sides().label({1.4, 1.2, 1.1}) == -1);
}

TEST_CASE("what cannot be oriented has its sides by parity, and is named") {
  const Analysed a(klein_bottle());
  CHECK(a.topology.side_rule == SideRule::parity);
  REQUIRE(a.topology.notes.size() == 1);
  CHECK(a.topology.notes[0].find("cannot be oriented near (") != std::string::npos);
}

TEST_CASE("an open soup has no sides of its own") {
  TriangleSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1});
  soup.triangles.pop_back();
  CHECK(Analysed(soup).topology.side_rule == SideRule::colouring);
  CHECK(Analysed(soup, SidesMode::parity).topology.side_rule == SideRule::colouring);
}

TEST_CASE("the walls of an overlap lie between regions inside, and the union is labelled so") {
  auto v = build(overlapping_boxes(), 0.03);
  REQUIRE(v.ok());
  CHECK(v->regions().size() == 4);
  CHECK(v->has_inner_walls());
  CHECK_FALSE(v->thickening());
  CHECK(v->thickening_note().find("overlap") != std::string::npos);
  for (const Region& r : v->regions()) CHECK(r.label == (r.unbounded ? +1 : -1));
  for (const Witness& w : v->witnesses()) CHECK(w.label == (in_overlapping_boxes(w.point) ? -1 : +1));
}
