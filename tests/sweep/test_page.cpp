// The page holds what the table does, and pictures show what they should.
#include "sweep/histogram.h"
#include "sweep/mesh_picture.h"
#include "sweep/page.h"
#include "sweep/tiny_models.h"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace isoscope;
using namespace isoscope::sweep;

namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

Row row_of(const Plan& plan, std::size_t run, Outcome outcome) {
  Row row;
  row.asked = plan.asked(run);
  row.outcome = outcome;
  row.seconds = 1.5;
  row.memory = 20;
  return row;
}

} // namespace

TEST_CASE("The page has a row a run, counts, and nothing that a name could break") {
  const TemporaryFolder folder;
  const Folder place(folder / "s");
  const Plan plan{
      {{"</script><b>.off", "/x.off"}, {"ok.off", "/ok.off"}}, {"1%", "2%"}, {"--effort", "0"}, {}};
  REQUIRE(write_plan(place, plan).ok());
  std::map<std::size_t, Row> rows{{0, row_of(plan, 0, Outcome::refused)},
                                  {1, row_of(plan, 1, Outcome::certified)},
                                  {2, row_of(plan, 2, Outcome::uncertified)}};
  rows[0].message = "<oh> & \"so\"";
  rows[1].vertices = 12;
  rows[1].covers = 1.25;
  rows[1].output = plan.output(1);
  rows[2].certificate = {{"holds", false}, {"covers", false}, {"separates", true}};
  std::ofstream(place.picture(1), std::ios::binary) << "picture";
  const std::string text = page(place, plan, rows);
  CHECK(count_of(text, "</script>") == 2);
  CHECK(count_of(text, "http") == 0); // it asks nobody for anything
  CHECK(text.find("<h1>1 of 4 runs certified</h1>") != std::string::npos);
  CHECK(text.find("1 run to go") != std::string::npos);
  CHECK(text.find("not certified 1</button>") != std::string::npos);
  const std::size_t from = text.find("id=\"rows\">") + 10;
  const auto data = nlohmann::json::parse(text.substr(from, text.find("</script>", from) - from));
  REQUIRE(data.at("rows").size() == 3);
  CHECK(data["rows"][0][1] == "</script><b>.off");
  CHECK(data["rows"][0][9] == "<oh> & \"so\"");
  CHECK(data["rows"][1][4] == 12);
  CHECK(data["rows"][1][10] == "2%25/%3C/script%3E%3Cb%3E.off");
  CHECK(data["rows"][1][11] == "data:image/png;base64,cGljdHVyZQ==");
  CHECK(data["rows"][2][9] == "Not: covers");
  CHECK(data["outcomes"].size() == outcome_count);
}

TEST_CASE("A histogram counts every value once") {
  Histogram h{"Vertices", "", {{10, 10, 1000}, {100}}, true};
  const std::string text = svg(h);
  CHECK(count_of(text, "class=\"s0\"") == 2);
  CHECK(count_of(text, "class=\"s1\"") == 1);
  CHECK(text.find(": 2 runs</title>") != std::string::npos);
  CHECK(text.find("median 100") != std::string::npos);
  CHECK(svg({"None", "", {{}, {0}}, true}).empty());
  CHECK(count_of(svg({"One", " s", {{5}}, true}), "<rect class=\"s0\"") == 1);
}

TEST_CASE("A picture is the same each time and small; nothing gives none") {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<std::array<std::uint32_t, 3>> facets{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const std::string picture = mesh_picture(points, facets, {});
  CHECK(picture.substr(1, 3) == "PNG");
  CHECK(picture.size() > 1000);
  CHECK(picture.size() < 16000);
  CHECK(mesh_picture(points, facets, {}) == picture);
  CHECK(mesh_picture(points, facets, {.result = false}) != picture);
  CHECK(mesh_picture(points, {}, {}).empty());
  // A facet seen from its side, and points that coincide, are no trouble.
  CHECK_FALSE(mesh_picture(points, std::vector<std::array<std::uint32_t, 3>>{{0, 0, 0}}, {}).empty());
  const TemporaryFolder folder;
  draw_result(folder.file("a.off", test::box(1, 2, 3)), true, folder / "a.png");
  CHECK(std::filesystem::file_size(folder / "a.png") > 1000);
  draw_result(folder.file("b.off", "OFF\n"), true, folder / "a.png");
  CHECK_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST_CASE("A comparison is a page too") {
  Comparison c;
  c.worse = {"<a>.off at 1%: certified became refused (oh: no)"};
  c.better = {"b.off at 1%: 50 vertices became 40"};
  c.compared = 7;
  c.vertices = {0.8, 1, 1, 1.25};
  const std::string text = comparison_page(c, "old", "new");
  CHECK(text.find("<h1>1 worse, 1 better</h1>") != std::string::npos);
  CHECK(text.find("<b>&lt;a&gt;.off at 1%</b>: certified became refused (oh: no)") != std::string::npos);
  CHECK(text.find("new against old: 7 runs in both") != std::string::npos);
  CHECK(count_of(text, "<svg") == 1); // no times are known
}
