// Tables come back as they were written, grow line by line, and tell what became worse.
#include "input/temporary_folder.h"
#include "sweep/comparison.h"
#include "sweep/run_table.h"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>

using namespace isoscope;
using namespace isoscope::sweep;

namespace {

Row certified(const std::string& model, double seconds, std::size_t vertices) {
  Row row;
  row.asked = {model, "1%"};
  row.certificate = {{"holds", true}, {"separates", true}};
  row.euler_characteristic = 2;
  row.components = 1;
  row.vertices = vertices;
  row.covers = 1.5;
  row.seconds = seconds;
  row.memory = 30;
  return row;
}

bool tells(const std::vector<std::string>& sentences, const std::string& what) {
  for (const std::string& s : sentences)
    if (s.find(what) != std::string::npos) return true;
  return false;
}

} // namespace

TEST_CASE("A table comes back") {
  const TemporaryFolder folder;
  Row refused;
  refused.asked = {"a \"b\".off", "8%"};
  refused.exit = 3;
  refused.outcome = Outcome::missing;
  refused.message = "nothing is left inside";
  REQUIRE(write_table(folder / "t", {refused, certified("b.off", 1.25, 40)}).ok());
  const auto back = read_table(folder / "t");
  REQUIRE(back.ok());
  REQUIRE(back->size() == 2);
  CHECK(back->front().asked == refused.asked);
  CHECK(back->front().message == refused.message);
  CHECK(back->front().outcome == Outcome::missing);
  CHECK_FALSE(back->front().vertices.has_value());
  CHECK(json_line(back->back()) == json_line(certified("b.off", 1.25, 40)));
  CHECK_FALSE(read_table(folder / "missing").ok());
  const auto broken = read_table(folder.file("broken", json_line(refused) + "\n{\"model\": 3}\n"));
  REQUIRE_FALSE(broken.ok());
  CHECK(broken.error().message.find("line 2") != std::string::npos);
}

TEST_CASE("What is worse is told, whatever the speed of the machine") {
  std::vector<Row> before, now;
  for (int i = 0; i < 9; ++i) {
    before.push_back(certified("m" + std::to_string(i), 2.0 + i, 100));
    now.push_back(certified("m" + std::to_string(i), 3 * (2.0 + i), 100));
  }
  const Comparison same = compare(before, now);
  CHECK(same.compared == 9);
  CHECK(same.speed == doctest::Approx(3));
  CHECK(same.worse.empty());

  now[0].seconds *= 1.3;
  now[1].exit = 1;
  now[1].outcome = Outcome::uncertified;
  now[1].certificate["separates"] = false;
  now[2].vertices = 130;
  now[3].covers = 2.5;
  now[4].exit = 3;
  now[4].outcome = Outcome::refused;
  now[4].message = "refused";
  now[5].vertices = 60;
  now.push_back(certified("new", 1, 10));
  const Comparison c = compare(before, now);
  CHECK(c.worse.size() == 6);
  CHECK(c.vertices.size() == 9);
  CHECK(c.vertices[2] == doctest::Approx(1.3));
  CHECK(tells(c.worse, "m0 at 1%: 6 CPU seconds became 7.8"));
  CHECK(tells(c.worse, "m1 at 1%: certified became not certified"));
  CHECK(tells(c.worse, "m1 at 1%: the certificate lost \"separates\""));
  CHECK(tells(c.worse, "m2 at 1%: 100 vertices became 130"));
  CHECK(tells(c.worse, "m3 at 1%: the input was 1.5 δ away and is 2.5 δ"));
  CHECK(tells(c.worse, "m4 at 1%: certified became refused (refused)"));
  CHECK(tells(c.better, "m5 at 1%: 100 vertices became 60"));
  CHECK(tells(c.notes, "new at 1%: is not in the old table"));
  // The other way round the lost ones are gained.
  CHECK(tells(compare(now, before).better, "m4 at 1%: refused became certified"));
}

TEST_CASE("A table grows by whole lines, for one program at a time") {
  const TemporaryFolder folder;
  const auto file = folder.file("t", json_line(certified("a.off", 1, 40)) + "\n{\"model\":\"b.o");
  CHECK(read_table(file)->size() == 1); // the line without an end is none
  {
    auto table = GrowingTable::open(file);
    REQUIRE(table.ok());
    const auto second = GrowingTable::open(file);
    REQUIRE_FALSE(second.ok());
    CHECK(second.error().message.find("in use") != std::string::npos);
    REQUIRE(table->append(certified("b.off", 1, 50)).ok());
    REQUIRE(table->append(certified("c.off", 1, 60)).ok());
  }
  const auto back = read_table(file);
  REQUIRE(back.ok());
  REQUIRE(back->size() == 3);
  CHECK(back->back().vertices == 60);
  CHECK(GrowingTable::open(file).ok());
  CHECK_FALSE(GrowingTable::open(folder / "no/such/folder").ok());
}

TEST_CASE("Tables of before outcomes had words tell them by the exit status") {
  const TemporaryFolder folder;
  const auto row = [&](const char* exit, const char* certificate) {
    return read_table(folder.file("t", std::string("{\"model\":\"a\",\"tolerance\":\"1%\",\"exit\":") + exit +
                                           ",\"certificate\":" + certificate +
                                           ",\"cpu_seconds\":1,\"memory_mb\":2}\n"))
        ->front();
  };
  CHECK(row("0", "{\"holds\":true}").outcome == Outcome::certified);
  CHECK(row("1", "{\"holds\":false}").outcome == Outcome::uncertified);
  CHECK(row("1", "{}").outcome == Outcome::failed);
  CHECK(row("3", "{}").outcome == Outcome::refused);
  CHECK(row("4", "{\"holds\":true}").outcome == Outcome::stopped);
  CHECK(row("139", "{}").outcome == Outcome::crashed);
}
