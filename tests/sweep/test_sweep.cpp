// The real program on tiny models: known answers, killed and resumed, what cannot be run.
#include "sweep/plan.h"
#include "sweep/tiny_models.h"

#include <doctest/doctest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <thread>

using namespace isoscope;
using namespace isoscope::sweep;
using namespace isoscope::test;

namespace {

namespace fs = std::filesystem;

std::map<Asked, Row> rows_of(const fs::path& folder) {
  std::map<Asked, Row> rows;
  const auto table = read_table(folder / "runs.jsonl");
  REQUIRE(table.ok());
  for (const Row& row : *table) CHECK(rows.emplace(row.asked, row).second);
  return rows;
}

constexpr const char* quick = " --tolerance 8%,5% --effort 0 --jobs 2";

} // namespace

TEST_CASE("A sweep has a row a run with known answers, meshes, pictures and a page") {
  const TemporaryFolder folder;
  const auto models = make_models(folder);
  const fs::path out = folder / "out";
  const Said said = shell("$SWEEP " + quoted(models) + quick + " -o " + quoted(out));
  CAPTURE(said.text);
  CHECK(said.status == 1); // not all are certified
  CHECK(said.text.find("6 runs of 6, 4 certified") != std::string::npos);
  const auto rows = rows_of(out);
  REQUIRE(rows.size() == 6);
  for (const char* tolerance : {"8%", "5%"}) {
    const Row &box = rows.at({"box.off", tolerance}), &ring = rows.at({"deep/ring.off", tolerance}),
              &broken = rows.at({"broken.off", tolerance});
    CHECK(box.outcome == Outcome::certified);
    CHECK(box.certificate.at("holds"));
    CHECK(box.euler_characteristic == 2);
    CHECK(box.input_triangles == 12);
    CHECK(box.vertices.value_or(0) >= 4);
    CHECK(box.covers.value_or(9) <= 3);
    CHECK(box.seconds > 0);
    CHECK(box.memory > 1);
    CHECK(ring.euler_characteristic == 0);
    CHECK(broken.outcome == Outcome::refused);
    CHECK(broken.message.find("broken.off") != std::string::npos);
    CHECK(broken.message.find(folder.path().string()) == std::string::npos);
    CHECK_FALSE(broken.vertices.has_value());
    CHECK(fs::exists(out / tolerance / "box.off"));
    CHECK(fs::exists(out / tolerance / "deep" / "ring.off"));
    CHECK(ring.output == std::string(tolerance) + "/deep/ring.off");
  }
  CHECK(fs::exists(out / "pictures" / "0.png"));
  CHECK(fs::exists(out / "index.html"));
  // Nothing is left to do, and the same page is written again.
  const std::string table = steady_table(out / "runs.jsonl");
  CHECK(shell("$SWEEP -o " + quoted(out) + " --quiet").text.empty());
  CHECK(steady_table(out / "runs.jsonl") == table);
  // Another sweep does not go there.
  const Said other = shell("$SWEEP " + quoted(models) + " --tolerance 8% --effort 0 -o " + quoted(out));
  CHECK(other.status == 2);
  CHECK(other.text.find("holds another sweep: its tolerances are others") != std::string::npos);
}

TEST_CASE("A sweep that is killed goes on where it was, with the same table") {
  const TemporaryFolder folder;
  const auto models = make_models(folder);
  const std::string begin = "$SWEEP " + quoted(models) + quick + " --quiet -o ";
  REQUIRE(shell(begin + quoted(folder / "whole")).status == 1);
  const fs::path out = folder / "killed";
  for (int kills = 0; kills < 3; ++kills) {
    // Killed once it has a line more, at any moment behind that.
    shell("before=$(cat " + quoted(out / "runs.jsonl") + " 2>/dev/null | wc -l)\n" + begin + quoted(out) +
          " & sweep=$!\nfor i in $(seq 600); do\n  now=$(cat " + quoted(out / "runs.jsonl") +
          " 2>/dev/null | wc -l)\n  [ $now -gt $before ] && break\n  kill -0 $sweep 2>/dev/null || break\n"
          "  sleep 0.02\ndone\nkill -9 $sweep; wait $sweep");
    const auto rows = read_table(out / "runs.jsonl");
    REQUIRE(rows.ok());
    CHECK(rows->size() >= 1);
  }
  // A line that was cut in its middle is done again.
  std::ofstream(out / "runs.jsonl", std::ios::app) << "{\"model\":\"box.o";
  CHECK(shell("$SWEEP --quiet -o " + quoted(out)).status == 1);
  CHECK(steady_table(out / "runs.jsonl") == steady_table(folder / "whole" / "runs.jsonl"));
}

TEST_CASE("An interrupted sweep keeps no row of what was under way") {
  const TemporaryFolder folder;
  const auto program = script(folder, "slow", "sleep 60");
  const auto out = folder / "out";
  const Said said = shell("$SWEEP gallery:sphere --tolerance 5% --program " + quoted(program) + " -o " +
                          quoted(out) + " & sweep=$!; sleep 1; kill -INT $sweep; wait $sweep");
  CHECK(said.status == 4);
  CHECK(rows_of(out).empty());
  CHECK(shell("$SWEEP missing " + quoted(out)).text == "0\n");
}

TEST_CASE("What is missing, crashes or takes too long has a row with a word") {
  const TemporaryFolder folder;
  const auto program = script(folder, "program", R"(case "$1" in
*/crash.off) kill -SEGV $$;;
*/endless.off) while :; do :; done;;
*/greedy.off) exec dd if=/dev/zero of=/dev/null bs=1G count=1;;
*/hungry.off) echo "isoscope-run: memory is exhausted." >&2; exit 1;;
*/odd.off) echo one >&2; echo two >&2; exit 77;;
esac)");
  for (const char* name : {"crash.off", "endless.off", "greedy.off", "hungry.off", "odd.off"})
    folder.file(name, box(1, 1, 1));
  const auto list =
      folder.file("list", "crash.off\nendless.off\ngreedy.off\nhungry.off\nodd.off\ngone.off\n");
  const auto out = folder / "out";
  CHECK(shell("$SWEEP " + quoted(list) + " --tolerance 5% --cpu-limit 1 --memory-cap 256 --program " +
              quoted(program) + " -o " + quoted(out))
            .status == 1);
  auto rows = rows_of(out);
  const auto row = [&](const char* name) { return rows.at({name, "5%"}); };
  CHECK(row("crash.off").outcome == Outcome::crashed);
  CHECK(row("crash.off").exit == 128 + 11);
  CHECK(row("endless.off").outcome == Outcome::out_of_time);
  CHECK(row("greedy.off").outcome != Outcome::certified);
  CHECK(row("hungry.off").outcome == Outcome::out_of_memory);
  CHECK(row("odd.off").outcome == Outcome::failed);
  CHECK(row("odd.off").message == "two");
  CHECK(row("gone.off").outcome == Outcome::missing);
  CHECK(row("gone.off").message == "gone.off does not exist.");
  CHECK(row("crash.off").message.find("signal 11") != std::string::npos);
  CHECK(row("endless.off").message.find("CPU seconds") != std::string::npos);
}

TEST_CASE("Two sweeps are compared") {
  const TemporaryFolder folder;
  Row row;
  row.asked = {"a.off", "1%"};
  row.certificate = {{"holds", true}};
  row.vertices = 100;
  row.seconds = 3;
  REQUIRE(write_table(folder / "before.jsonl", {row}).ok());
  row.vertices = 130;
  REQUIRE(write_table(folder / "after.jsonl", {row}).ok());
  const auto compared = [&](const char* a, const char* b) {
    return shell("$SWEEP compare " + quoted(folder / a) + " " + quoted(folder / b));
  };
  const Said worse = compared("before.jsonl", "after.jsonl");
  CHECK(worse.status == 1);
  CHECK(worse.text.find("a.off at 1%: 100 vertices became 130") != std::string::npos);
  CHECK(compared("before.jsonl", "before.jsonl").status == 0);
  CHECK(compared("after.jsonl", "before.jsonl").text.find("Better:") != std::string::npos);
  CHECK(compared("before.jsonl", "nothing").status == 2);
}

TEST_CASE("Wrong words are told at once") {
  const TemporaryFolder folder;
  const auto says = [&](const std::string& words, int status, const std::string& part) {
    const Said said = shell("$SWEEP " + words + " -o " + quoted(folder / "x"));
    CAPTURE(said.text);
    CHECK(said.status == status);
    CHECK(said.text.find(part) != std::string::npos);
  };
  says("gallery:sphere", 2, "--tolerance is missing");
  says("gallery:sphere --tolerance 1%,zero", 2, "zero");
  says("gallery:sphere --tolerance 1%,1%", 2, "twice");
  says("gallery:sphere --tolerance 1% --alpha 2", 2, "alpha");
  says("gallery:sphere --tolerance 1% --effort 3", 2, "--time-limit");
  says("nowhere --tolerance 1%", 3, "does not exist");
  says("--tolerance 1%", 2, "no models");
  says("", 3, "holds no sweep");
  says("gallery:sphere --tolerance 1% --program /nowhere", 2, "/nowhere cannot be started");
  says("gallery:sphere --tolerance 1% --levels 0 1", 2, "levels");
  CHECK_FALSE(fs::exists(folder / "x"));
}
