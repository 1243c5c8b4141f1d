// Tables come back as they were written and tell what became worse; runs are measured and held within limits.
#include "corpus/corpus_run.h"
#include "corpus/corpus_table.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <csignal>

using namespace isoscope;
using namespace isoscope::corpus;

namespace {

Row certified(const std::string& model, double seconds, std::size_t vertices) {
  Row row;
  row.asked = {model, "1%", 0};
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

/// A small box as OFF.
constexpr const char* box = "OFF\n8 6 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n0 0 1\n2 0 1\n2 1 1\n0 1 1\n"
                            "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// A program for the shell in place of isoscope-run.
std::filesystem::path script(const TemporaryFolder& folder, const std::string& text) {
  const auto file = folder.file("program", "#!/bin/sh\n" + text + "\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

} // namespace

TEST_CASE("A table comes back, sorted by what was asked") {
  const TemporaryFolder folder;
  Row refused;
  refused.asked = {"a \"b\".off", "8%", 1};
  refused.exit = 3;
  refused.message = "nothing is left inside";
  REQUIRE(write_table(folder / "t", {certified("b.off", 1.25, 40), refused}).ok());
  const auto back = read_table(folder / "t");
  REQUIRE(back.ok());
  REQUIRE(back->size() == 2);
  CHECK(back->front().asked == refused.asked);
  CHECK(back->front().message == refused.message);
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
  now[1].certificate["separates"] = false;
  now[2].vertices = 130;
  now[3].covers = 2.5;
  now[4].exit = 3;
  now[4].message = "refused";
  now[5].vertices = 60;
  now.push_back(certified("new", 1, 10));
  const Comparison c = compare(before, now);
  CHECK(c.worse.size() == 6);
  CHECK(tells(c.worse, "m0 at 1%: 6 CPU seconds became 7.8"));
  CHECK(tells(c.worse, "m1 at 1%: exit 0 became 1"));
  CHECK(tells(c.worse, "m1 at 1%: the certificate lost \"separates\""));
  CHECK(tells(c.worse, "m2 at 1%: 100 vertices became 130"));
  CHECK(tells(c.worse, "m3 at 1%: the input was 1.5 δ away and is 2.5 δ"));
  CHECK(tells(c.worse, "m4 at 1%: exit 0 became 3 (refused)"));
  CHECK(tells(c.better, "m5 at 1%: 100 vertices became 60"));
  CHECK(tells(c.notes, "new at 1%: is not in the old table"));
  // The other way round the lost ones are gained.
  CHECK(tells(compare(now, before).better, "m4 at 1%: exit 3 became 0"));
}

TEST_CASE("A run of the program is measured") {
  const TemporaryFolder folder;
  const auto model = folder.file("box.off", box);
  const Row row = run_one(ISOSCOPE_RUN_PROGRAM, model, {"box.off", "5%", 0}, {300, 0}, folder.path());
  CAPTURE(row.message);
  CHECK(row.exit == 0);
  CHECK(row.certificate.at("holds"));
  CHECK(row.euler_characteristic == 2);
  CHECK(row.vertices.value_or(0) >= 4);
  CHECK(row.covers.value_or(0) > 0);
  CHECK(row.seconds > 0);
  CHECK(row.memory > 1);
  const Row refused = run_one(ISOSCOPE_RUN_PROGRAM, folder.file("bad.off", "OFF\n3 1"), {"bad.off", "5%", 0},
                              {}, folder.path());
  CHECK(refused.exit == 3);
  CHECK(refused.message.find("bad.off") != std::string::npos);
  CHECK(refused.message.find(folder.path().string()) == std::string::npos);
  CHECK_FALSE(refused.vertices.has_value());
}

TEST_CASE("Endless, greedy, crashing and missing programs end as rows") {
  const TemporaryFolder folder;
  const auto model = folder.file("box.off", box);
  const auto row_of = [&](const std::filesystem::path& program) {
    return run_one(program, model, {"box.off", "5%", 0}, {1, 256}, folder.path());
  };
  CHECK(row_of(script(folder, "while :; do :; done")).exit == 128 + SIGXCPU);
  CHECK(row_of(script(folder, "exec dd if=/dev/zero of=/dev/null bs=1G count=1")).exit == 1);
  CHECK(row_of(script(folder, "kill -SEGV $$")).exit == 128 + SIGSEGV);
  CHECK(row_of(script(folder, "echo one >&2; echo two >&2; exit 3")).message == "two");
  CHECK(row_of(folder / "nothing").exit == 127);
}
