// Small parts of the input are left out when asked, and those of Z are told.
#include "run/crumbs.h"

#include "recording/geometry_codec.h"
#include "run/complete_run.h"
#include "run/recorded_run.h"
#include "run/report.h"

#include <nlohmann/json.hpp>

#include <doctest/doctest.h>

#include <algorithm>

using namespace isoscope;
using namespace isoscope::test;
using Json = nlohmann::json;

namespace {

void add_cube(TriangleSoup& soup, Vec3 at, double edge) {
  constexpr std::uint32_t faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  for (int k = 0; k < 8; ++k)
    soup.points.push_back(at + edge * Vec3{double(k & 1), double((k >> 1) & 1), double((k >> 2) & 1)});
  for (const auto& f : faces) soup.triangles.push_back({first + f[0], first + f[1], first + f[2]});
}

/// A box of edge 1 and two of edge 0.12: with δ = 0.05 they are 2.4 δ.
std::shared_ptr<const TriangleSoup> box_with_crumbs() {
  TriangleSoup soup;
  add_cube(soup, {0, 0, 0}, 1);
  add_cube(soup, {1.4, 0, 0}, 0.12);
  add_cube(soup, {1.4, 0.8, 0}, 0.12);
  soup.name = "box";
  return std::make_shared<const TriangleSoup>(std::move(soup));
}

RunParameters parameters_with(double drop_small) {
  RunParameters parameters;
  parameters.input = "box";
  parameters.tolerance = {0.05, false};
  parameters.until = Stage::refinement;
  parameters.drop_small = drop_small;
  return parameters;
}

struct CrumbRun : CompleteRun {
  explicit CrumbRun(double drop_small) : CompleteRun(parameters_with(drop_small)) {
    soup = box_with_crumbs();
  }
};

std::vector<std::string> recorded_warnings(const Journal& journal) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < journal.events().size(); ++i) {
    const Event& e = journal.events()[i];
    if (e.kind == EventKind::warning) texts.push_back(journal.texts()[e.text]);
  }
  return texts;
}

bool any_says(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(part) != std::string::npos; });
}

} // namespace

TEST_CASE("Vertices of Z that went to crumbs are told with what helps") {
  CrumbRun run(0);
  REQUIRE(run.run());
  CHECK(run.result->certificate.components == 3);
  CHECK(run.result->crumbs.components == 2);
  const std::string note = crumbs_note(run.result->crumbs, run.result->size().vertices);
  CHECK(note.find("2 components smaller than 4 δ") != std::string::npos);
  CHECK(note.find("--drop-small 4") != std::string::npos);
  const Json report =
      Json::parse(report_json(run.parameters, *run.scene, *run.result, gather_statistics(*run.journal)));
  CHECK(report["output"]["crumbs"]["components"] == 2);
  CHECK(report["output"]["crumbs"]["vertices"] == run.result->crumbs.vertices);
  CHECK(report["warnings"].back() == note);
  // Where there is nothing but crumbs, nothing is said.
  CHECK(crumbs_note({2, run.result->mesh.points.size()}, run.result->mesh.points.size()).empty());
}

TEST_CASE("Small components of the input are left out and told, in a recording as in the run") {
  CrumbRun run(3);
  run.notes = {{"Corners leave their face's plane by up to", 0.01}};
  REQUIRE(run.run());
  CHECK(run.result->certificate.components == 1);
  CHECK(run.result->crumbs.vertices == 0);
  CHECK(run.scene->input->triangles.size() == 36); // what was given is shown
  CHECK(run.scene->field->size() == 12);
  CHECK(run.scene->longest_edge == run.scene->input->bounds().longest_edge());
  const std::vector<std::string> texts = recorded_warnings(*run.journal);
  CHECK(any_says(texts,
                 "2 of 3 components of the input, with 24 triangles, are smaller than 3 δ and left out"));
  CHECK(any_says(texts, "by up to 0.2 δ."));

  std::vector<InputNote> notes;
  const auto stored = decode_soup(encode(*run.scene->input, run.scene->notes), &notes);
  REQUIRE(stored.has_value());
  CHECK(notes == run.scene->notes);
  const auto rebuilt = rebuild_scene(run.parameters, std::make_shared<const TriangleSoup>(*stored),
                                     *run.journal, run.control, notes);
  REQUIRE(rebuilt.ok());
  REQUIRE((*rebuilt)->warnings.size() == run.scene->warnings.size());
  for (std::size_t i = 0; i < run.scene->warnings.size(); ++i)
    CHECK((*rebuilt)->warnings[i].message == run.scene->warnings[i].message);
}

TEST_CASE("Nothing small, nothing left, and a run that is cancelled") {
  CrumbRun none(2);
  REQUIRE(none.prepare());
  CHECK(none.scene->field->size() == 36);
  CHECK(!any_says(recorded_warnings(*none.journal), "left out"));
  CrumbRun all(40);
  CHECK(!all.prepare());
  REQUIRE(all.error.has_value());
  CHECK(all.error->code == ErrorCode::bad_input);
  CHECK(all.error->message.find("--drop-small 40") != std::string::npos);
  CrumbRun cancelled(3);
  cancelled.control.cancel();
  CHECK(!cancelled.prepare());
  CHECK(cancelled.error->code == ErrorCode::cancelled);
}
