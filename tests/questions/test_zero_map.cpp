// Maps of Z against what they measure.
#include "questions/zero_map.h"

#include "questions/state_at.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace isoscope;
using namespace isoscope::test;

namespace {

const CompleteRun& sphere_run() {
  static const std::unique_ptr<CompleteRun> run = [] {
    RunParameters parameters = complete_parameters("sphere");
    parameters.tolerance = {12, true};
    auto made = std::make_unique<CompleteRun>(parameters);
    REQUIRE(made->run());
    return made;
  }();
  return *run;
}

/// The pieces of each polygon cover it.
void check_pieces(const StateSnapshot& state, const ZeroMap& map) {
  REQUIRE(map.begin.size() == state.zero_set.polygons.size() + 1);
  for (std::size_t i = 0; i < state.zero_set.polygons.size(); ++i) {
    const ZeroSet::Polygon& p = state.zero_set.polygons[i];
    double whole = 0, sum = 0;
    for (std::size_t k = 2; k < p.count; ++k)
      whole += area({state.zero_set.vertices[p.v[0]].position, state.zero_set.vertices[p.v[k - 1]].position,
                     state.zero_set.vertices[p.v[k]].position});
    for (std::uint32_t k = map.begin[i]; k < map.begin[i + 1]; ++k) sum += area(map.pieces[k].corners);
    CHECK(sum == doctest::Approx(whole));
  }
  CHECK(map.least <= map.mean);
  CHECK(map.mean <= map.largest);
}

} // namespace

TEST_CASE("Z is measured by distance, normals, valence and age at every form of it") {
  const CompleteRun& run = sphere_run();
  const Step last = run.journal->steps();
  for (const Step step : {last / 4, last / 2, last}) {
    const auto state = state_at(run, step);
    if (state->zero_set.polygons.empty()) continue;
    CAPTURE(step);
    for (int k = 1; k < zero_map_count; ++k) {
      const auto kind = static_cast<ZeroMapKind>(k);
      const auto map = zero_map(*state, *run.scene, *run.journal, kind);
      REQUIRE(map.has_value());
      check_pieces(*state, *map);
      const auto ends = std::minmax_element(map->pieces.begin(), map->pieces.end(),
                                            [](const auto& a, const auto& b) { return a.value < b.value; });
      CHECK(map->least == ends.first->value);
      CHECK(map->largest == ends.second->value);
      if (kind == ZeroMapKind::age) CHECK(map->largest <= static_cast<float>(step));
    }
  }
  const auto end = state_at(run, last);
  const auto distance = zero_map(*end, *run.scene, *run.journal, ZeroMapKind::distance);
  CHECK(distance->limit == 1.0f);
  CHECK(distance->largest <= 1.0f); // certified: within Ω
  CHECK(distance->largest > 0.1f);
  const auto angles = zero_map(*end, *run.scene, *run.journal, ZeroMapKind::normals);
  CHECK(angles->largest <= 90);
  CHECK(angles->mean < 45);
  // Of a triangle mesh the mean valence is 6 − 6χ/V.
  const auto valence = zero_map(*end, *run.scene, *run.journal, ZeroMapKind::valence);
  CHECK(valence->least >= 3);
  CHECK(valence->least < 6);
  CHECK(!zero_map(*end, *run.scene, *run.journal, ZeroMapKind::none).has_value());
  RunControl stopped;
  stopped.cancel();
  CHECK(!zero_map(*end, *run.scene, *run.journal, ZeroMapKind::distance, stopped).has_value());
  CHECK(!zero_map(*end, *run.scene, *run.journal, ZeroMapKind::age, stopped).has_value());
}

TEST_CASE("what the last operation made has the age 0") {
  const CompleteRun& run = sphere_run();
  const auto begin = [&] {
    for (Step k = run.journal->steps(); k > 0; --k) {
      const auto state = state_at(run, k);
      if (!state->added_facets.empty() && state->complex.form == ZeroForm::embedded) return k;
    }
    return Step(0);
  }();
  REQUIRE(begin > 0);
  const auto state = state_at(run, begin);
  const auto map = zero_map(*state, *run.scene, *run.journal, ZeroMapKind::age);
  REQUIRE(map.has_value());
  CHECK(map->least == 0);
  CHECK(map->largest > 0);
}
