// diff as people type it: statuses and the lines that matter.
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

using namespace isoscope;
using namespace isoscope::test;

namespace {

std::string record(const TemporaryFolder& folder, const std::string& name,
                   std::vector<std::string> options = {}) {
  const std::string file = (folder / (name + ".isorun")).string();
  std::vector<std::string> arguments{"gallery:sphere", "--quiet", "--effort", "0", "--record", file};
  arguments.insert(arguments.end(), options.begin(), options.end());
  REQUIRE(run_batch(arguments).status == 0);
  return file;
}

} // namespace

TEST_CASE("Recordings of the same run are the same, on any number of threads") {
  const TemporaryFolder folder;
  const std::string a = record(folder, "a"), b = record(folder, "b", {"--threads", "3"});
  const Ended found = run_batch({"diff", a, b});
  CHECK(found.status == 0);
  CHECK(found.says("Every decision and every number is the same."));
  CHECK(!found.says("Parameters"));
  const Ended quiet = run_batch({"diff", a, b, "--quiet"});
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
}

TEST_CASE("Other parameters are told with the first decision that they changed") {
  const TemporaryFolder folder;
  const std::string a = record(folder, "a"), b = record(folder, "b", {"--alpha", "0.5"}),
                    c = record(folder, "c", {"--sigma", "0.3"});
  const Ended alpha = run_batch({"diff", a, b, "--rows", "2"});
  CHECK(alpha.status == 1);
  CHECK(alpha.says("  α                           0.2          0.5\n"));
  CHECK(alpha.says("First event judged by other numbers: event 2, after 1 operation\n  A  2 · condition 1"));
  CHECK(alpha.says("First differing decision: event "));
  CHECK(alpha.says("Made by one run alone\n"));
  const Ended sigma = run_batch({"diff", a, c, "--rows", "0"});
  CHECK(sigma.status == 1);
  CHECK(sigma.says("σ/δ"));
  CHECK(sigma.says("samples of ∂Ω"));
  CHECK(sigma.says("First differing decision: event 2, after 1 operation"));
  CHECK(!sigma.says("Made by one run alone"));
  CHECK(run_batch({"diff", a, c, "--quiet"}).status == 1);
}

TEST_CASE("A run that ends sooner differs where it ends") {
  const TemporaryFolder folder;
  const std::string a = record(folder, "a"), b = record(folder, "b", {"--until", "gamma"});
  const Ended found = run_batch({"diff", b, a});
  CHECK(found.status == 1);
  CHECK(found.says("A  the run ends here\n  B  "));
  CHECK(!found.says("judged by other numbers"));
}

TEST_CASE("What cannot be compared is trouble") {
  const TemporaryFolder folder;
  const std::string a = record(folder, "a"), mesh = folder.file("mesh.off", "OFF\n0 0 0\n").string();
  CHECK(run_batch({"diff", a}).status == 2);
  const Ended foreign = run_batch({"diff", a, mesh});
  CHECK(foreign.status == 2);
  CHECK(foreign.says("mesh.off"));
  CHECK(run_batch({"diff", (folder / "none.isorun").string(), a}).status == 2);
  const Ended help = run_batch({"diff", "--help"});
  CHECK(help.status == 0);
  CHECK(help.says("0 the same, 1 different, 2 usage"));
  CHECK(run_batch({"--help"}).says("isoscope-run diff A.isorun B.isorun"));
}
