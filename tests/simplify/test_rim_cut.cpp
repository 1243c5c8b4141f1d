// The cut on a T made by hand: where it takes a flap away, and where it gives up with a place.
#include "simplify/rim_cut.h"

#include "journal/synthetic.h"
#include "mesh/predicates.h"
#include "mesh/validity.h"
#include "tolerance/border_gate.h"
#include "tolerance/open_shapes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>

using namespace isoscope;
using namespace isoscope::test;

namespace {

using Height = std::function<double(double, double)>;

/// T over a grid of these coordinates, in layers of 0.2 between -0.2 and 0.2; Z, its middle, is lifted with
/// the others by `height`.
Complex layered(const std::vector<double>& xs, const std::vector<double>& ys, const Height& height) {
  constexpr std::size_t layers = 3;
  Complex c;
  c.form = ZeroForm::embedded;
  Delta all;
  const auto at = [&](std::size_t i, std::size_t j, std::size_t k) {
    return VertexId((k * ys.size() + j) * xs.size() + i);
  };
  for (std::size_t k = 0; k < layers; ++k)
    for (const double y : ys)
      for (const double x : xs) {
        Vertex v;
        v.position = {x, y, 0.2 * (static_cast<double>(k) - 1) + height(x, y)};
        v.value = static_cast<double>(k) - 1;
        v.kind = VertexKind::zero;
        all.added_vertices.push_back(v);
      }
  const auto position = [&](VertexId v) { return all.added_vertices[v.index()].position; };
  std::size_t slots = 0;
  for (std::size_t k = 0; k + 1 < layers; ++k)
    for (std::size_t j = 0; j + 1 < ys.size(); ++j)
      for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        std::array<int, 3> axes{0, 1, 2};
        do { // a simplex for each way along three edges of the cell
          std::array<std::size_t, 3> corner{i, j, k};
          std::array<VertexId, 4> v{at(i, j, k)};
          for (std::size_t n = 0; n < 3; ++n) {
            ++corner[static_cast<std::size_t>(axes[n])];
            v[n + 1] = at(corner[0], corner[1], corner[2]);
          }
          if (orientation(position(v[0]), position(v[1]), position(v[2]), position(v[3])) < 0)
            std::swap(v[2], v[3]);
          all.added.push_back(
              {TetId(slots++), canonical_order(v), static_cast<std::int8_t>(k == 0 ? -1 : 1), 0});
        } while (std::next_permutation(axes.begin(), axes.end()));
      }
  c.apply(all);
  REQUIRE(check_complex(c).empty());
  return c;
}

std::vector<double> steps(double from, double to, int n) {
  std::vector<double> all;
  for (int i = 0; i <= n; ++i) all.push_back(from + (to - from) * i / n);
  return all;
}

/// A cut along the rim of the unit square.
struct Cut {
  static constexpr double delta = 0.03;

  explicit Cut(Complex complex) : journal(std::make_shared<Journal>()) {
    const TriangleSoup square = grid_sheet(8, [](double, double) { return true; });
    auto built = ToleranceVolume::build(std::make_shared<const ClosestPointIndex>(square),
                                        analyse_input(square), {delta, 0.95}, RunControl());
    REQUIRE(built.ok());
    OpenGate gate;
    Recorder recorder(*journal, gate);
    const RunControl control;
    StageLog log(recorder, control);
    LiveComplex live(std::move(complex), nullptr);
    log.begin(Stage::rim);
    RimCut cut(live, *built, log);
    status = cut.run();
    after = live.complex();
    const auto open = built->border_gate()->rim().segments();
    rim.assign(open.begin(), open.end());
  }
  double from_rim(Vec3 p) const {
    double least = Box3::inf;
    for (const Segment3& s : rim) least = std::min(least, distance_to(s, p));
    return least;
  }
  /// The edges with one facet of what is left of Z.
  std::vector<Segment3> border() const {
    std::map<std::pair<VertexId, VertexId>, int> uses;
    for (std::size_t t = 0; t < after.tets.size(); ++t)
      for (std::size_t k = 0; after.tets[t].alive() && after.tets[t].side > 0 && k < 4; ++k) {
        if (!after.on_zero_set(TetId(t), k)) continue;
        const auto f = after.tets[t].facet(k);
        for (std::size_t i = 0; i < 3; ++i) ++uses[std::minmax(f[i], f[(i + 1) % 3])];
      }
    std::vector<Segment3> edges;
    for (const auto& [e, n] : uses)
      if (n == 1) edges.push_back({after.position(e.first), after.position(e.second)});
    return edges;
  }

  std::shared_ptr<Journal> journal;
  Status status;
  Complex after;
  std::vector<Segment3> rim;
};

} // namespace

TEST_CASE("A flat Z is cut at the wall over the rim") {
  const Cut cut(layered(steps(-0.3, 1.3, 8), steps(-0.3, 1.3, 8), [](double, double) { return 0; }));
  REQUIRE(cut.status.ok());
  const std::vector<Segment3> border = cut.border();
  double length = 0;
  for (const Segment3& s : border) {
    length += distance(s[0], s[1]);
    for (const Vec3 p : s) CHECK(cut.from_rim(p) <= 0.01 * Cut::delta);
  }
  CHECK(length == doctest::Approx(4).epsilon(1e-3));
  CHECK(check_complex(cut.after).empty());
}

TEST_CASE("Where Z rises out of Ω before the rim, the flap that is too far from it is taken away") {
  constexpr double delta = Cut::delta;
  // Half of δ before the rim x = 1 it rises to 2 δ, over a stretch of 1.2 δ, and comes down beside it.
  std::vector<double> xs = steps(-0.3, 0.9, 6), ys = steps(-0.3, 0.4, 4);
  for (const double x : {-0.9, -0.6, -0.5, -0.4, 0.0, 1.0, 3.0, 10.0}) xs.push_back(1 + x * delta);
  for (const double y : {-1.2, -0.6, -0.3, 0.0, 0.3, 0.6, 1.2}) ys.push_back(0.5 + y * delta);
  for (const double y : {0.6, 0.8, 1.05, 1.3}) ys.push_back(y);
  const auto rise = [](double from, double to, double t) {
    return std::clamp((t - from) / (to - from), 0., 1.);
  };
  const Cut cut(layered(xs, ys, [&](double x, double y) {
    const double across = rise(-0.6, -0.5, (x - 1) / delta),
                 along = rise(-0.6, -0.3, -std::abs(y - 0.5) / delta);
    return 2 * delta * across * along;
  }));
  REQUIRE(cut.status.ok());
  CHECK(check_complex(cut.after).empty());
  // What is left ends on the steep faces, 0.95 δ from the rim.
  std::size_t in_front = 0;
  for (const Segment3& s : cut.border())
    for (const Vec3 p : s) {
      if (p.z < 0.6 * delta) continue;
      CHECK(cut.from_rim(p) <= 0.95 * delta * (1 + 1e-6));
      if (std::abs(p.y - 0.5) > 0.25 * delta) continue;
      ++in_front;
      CHECK(cut.from_rim(p) == doctest::Approx(0.95 * delta).epsilon(0.02));
      CHECK(std::abs(p.x - (1 - 0.55 * delta)) <= 0.051 * delta);
    }
  CHECK(in_front >= 4);
  // Nowhere is it left bare: all of the rim has border within δ.
  std::vector<Segment3> border = cut.border();
  for (const Segment3& s : cut.rim) {
    double least = Box3::inf;
    for (const Segment3& b : border) least = std::min(least, distance_to(b, point_on(s, 0.5)));
    CHECK(least <= delta);
  }
}

TEST_CASE("Where Z leaves Ω far from the rim the cut gives up with a place") {
  // It lies on the square along x = 0.5, and leaves Ω at 0.2 and 0.8.
  const Cut cut(
      layered(steps(-0.3, 1.3, 8), steps(-0.3, 1.3, 8), [](double x, double) { return 0.1 * (x - 0.5); }));
  REQUIRE(!cut.status.ok());
  CHECK(cut.status.error().code == ErrorCode::unsupported);
  const std::string words = cut.status.error().message;
  CAPTURE(words);
  const std::string before = "Z leaves Ω before it is over the rim, in ";
  REQUIRE(words.starts_with(before));
  CHECK(std::stoi(words.substr(before.size())) > 200);
  const std::size_t open = words.find("near (");
  REQUIRE(open != std::string::npos);
  const double x = std::stod(words.substr(open + 6));
  CHECK(std::min(std::abs(x - 0.2), std::abs(x - 0.8)) < 0.02);
  CHECK(cut.status.error().remedy == "Use a smaller tolerance.");
  // What was split so far stays a T.
  CHECK(check_complex(cut.after).empty());
}
