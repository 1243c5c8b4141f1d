// --record and replay as people type them: statuses, messages, files.
#include "input/mesh_io.h"
#include "input/temporary_folder.h"
#include "support/run_program.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include <sys/resource.h>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("A recorded run replays, and its last Z is the mesh that was written") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string();
  const std::string mesh = (folder / "mesh.off").string(), again = (folder / "again.off").string();
  REQUIRE(run_batch({"gallery:sphere", "--quiet", "--record", run, "-o", mesh}).status == 0);
  const Ended summary = run_batch({"replay", run, "-o", again});
  CHECK(summary.status == 0);
  CHECK(summary.says("gallery:sphere"));
  CHECK(summary.says("finished, certified"));
  CHECK(bytes_of(mesh) == bytes_of(again));
  const Ended check = run_batch({"replay", run, "--check", "--threads", "3"});
  CHECK(check.status == 0);
  CHECK(check.says("the final Z is the same"));
  const Ended quiet = run_batch({"replay", run, "--check", "--quiet"});
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
}

TEST_CASE("What reading had to decide is told by the run, its report and its recording, and replays") {
  const TemporaryFolder folder;
  // A cube with one corner pushed outward, and one of 2.4 δ beside it.
  const std::string model =
      folder
          .file("bent.off",
                "OFF 16 12 0\n-0.2 -0.2 -0.2\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                "1.5 0 0\n1.62 0 0\n1.62 .12 0\n1.5 .12 0\n1.5 0 .12\n1.62 0 .12\n1.62 .12 .12\n"
                "1.5 .12 .12\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"
                "4 8 11 10 9\n4 12 13 14 15\n4 8 9 13 12\n4 9 10 14 13\n4 10 11 15 14\n4 11 8 12 15\n")
          .string();
  const std::string run = (folder / "run.isorun").string(), report = (folder / "report.json").string();
  const Ended ended = run_batch({model, "--tolerance", "0.05", "--until", "refinement", "--drop-small", "4",
                                 "--record", run, "--report", report});
  CHECK(ended.status == 0);
  for (const char* note : {"3 of 12 faces", "1 of 2 components"}) {
    CAPTURE(note);
    CHECK(ended.error.find(note) != std::string::npos);
    CHECK(bytes_of(report).find(note) != std::string::npos);
    CHECK(run_batch({"replay", run}).out.find(note) != std::string::npos);
  }
  CHECK(run_batch({"replay", run, "--check"}).status == 0);
  const Ended crumbs = run_batch({model, "--tolerance", "0.05", "--until", "refinement"});
  CHECK(crumbs.error.find("vertices went to 1 component smaller than 4 δ; --drop-small 4") !=
        std::string::npos);
}

TEST_CASE("A run that a limit stopped says so when it is replayed") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string();
  REQUIRE(run_batch({"gallery:torus", "--quiet", "--record", run, "--until", "gamma"}).status <= 1);
  const Ended summary = run_batch({"replay", run});
  CHECK(summary.status <= 1);
  CHECK(summary.says("finished"));
}

TEST_CASE("Wrong files are told before the work starts") {
  const TemporaryFolder folder;
  const std::string mesh = folder.file("mesh.off", "OFF\n0 0 0\n").string();
  const Ended foreign = run_batch({"gallery:sphere", "--record", mesh});
  CHECK(foreign.status == 2);
  CHECK(foreign.says("is not a recording"));
  CHECK(bytes_of(mesh) == "OFF\n0 0 0\n");
  CHECK(run_batch({"gallery:sphere", "--record", (folder / "none" / "a.isorun").string()}).status == 2);
  const Ended clash = run_batch({mesh, "--record", mesh});
  CHECK(clash.status == 2);
  CHECK(clash.says("the input itself"));
  // A run that does not begin leaves no file.
  const std::string run = (folder / "run.isorun").string();
  CHECK(run_batch({(folder / "missing.off").string(), "--record", run}).status == 3);
  CHECK(!std::filesystem::exists(run));
  CHECK(run_batch({"replay"}).status == 2);
  CHECK(run_batch({"replay", run}).status == 3);
  CHECK(run_batch({"replay", mesh}).status == 3);
}

TEST_CASE("A file that cannot grow further does not stop the run, and holds what was committed") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string(), mesh = (folder / "mesh.off").string();
  const std::string program = ISOSCOPE_RUN_PROGRAM;
  const std::string error = (folder / "error").string();
  const std::string command = "ulimit -f 512; exec " + program +
                              " gallery:torus --effort 0 --quiet --record " + run + " -o " + mesh + " 2> " +
                              error;
  const int status = std::system(command.c_str());
  CHECK(WEXITSTATUS(status) == 1);
  CHECK(bytes_of(error).find("run.isorun") != std::string::npos);
  CHECK(read_mesh(mesh).ok());
  const Ended replayed = run_batch({"replay", run});
  CHECK(replayed.status == 4);
  CHECK(replayed.says("ended without finishing"));
}

TEST_CASE("A recording that cannot be written further is told once, and the run goes on to its mesh") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string(), mesh = (folder / "mesh.off").string();
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{120000, limit.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const Ended ended = run_batch({"gallery:torus", "--effort", "0", "--record", run, "-o", mesh});
  setrlimit(RLIMIT_FSIZE, &limit);
  CHECK(ended.status == 1);
  const std::size_t told = ended.error.find("run.isorun");
  REQUIRE(told != std::string::npos);
  CHECK(ended.error.find("run.isorun", told + 1) == std::string::npos);
  CHECK(ended.says("Certificate  holds"));
  CHECK(read_mesh(mesh).ok());
}

TEST_CASE("A run whose history goes to the disk ends and replays as one without") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string();
  const std::string mesh = (folder / "a.off").string(), spilled = (folder / "b.off").string();
  REQUIRE(run_batch({"gallery:torus", "--effort", "0", "--quiet", "-o", mesh}).status == 0);
  REQUIRE(run_batch({"gallery:torus", "--effort", "0", "--quiet", "--history-limit", "1", "--record", run,
                     "-o", spilled})
              .status == 0);
  CHECK(bytes_of(mesh) == bytes_of(spilled));
  CHECK(run_batch({"replay", run, "--check"}).status == 0);
  CHECK(run_batch({"gallery:torus", "--history-limit", "0"}).status == 2);
}

TEST_CASE("A damaged recording is saved up to the damage, by the command that the refusal names") {
  const TemporaryFolder folder;
  const std::string run = (folder / "run.isorun").string(), saved = (folder / "saved.isorun").string();
  REQUIRE(run_batch({"gallery:sphere", "--tolerance", "12%", "--quiet", "--record", run}).status == 0);
  const std::string bytes = bytes_of(run);
  const std::string cut =
      folder.file("cut.isorun", std::string_view(bytes).substr(0, bytes.size() * 9 / 10)).string();
  const Ended refused = run_batch({"replay", cut});
  CHECK(refused.status == 3);
  CHECK(refused.says("isoscope-run recover " + cut));
  const Ended recovered = run_batch({"recover", cut, "-o", saved});
  CAPTURE(recovered.error);
  REQUIRE(recovered.status == 0);
  CHECK(recovered.says("Saved"));
  CHECK(recovered.says("Lost"));
  CHECK(bytes_of(cut) == bytes.substr(0, bytes.size() * 9 / 10));
  CHECK(run_batch({"replay", saved}).status == 4); // it ended without finishing
  CHECK(run_batch({"replay", saved, "--check"}).status == 0);
  const Ended quick = run_batch({"recover", cut, "-o", saved, "--quick", "--quiet"});
  // On a fast machine all is one commit, and nothing of it is proven without running again.
  CHECK((quick.status == 0 || quick.status == 3));
  CHECK(quick.out.empty());
  CHECK(run_batch({"replay", saved, "--check"}).status == 0);

  CHECK(run_batch({"recover", run, "-o", saved}).says("nothing that the file holds"));
  CHECK(run_batch({"replay", saved}).says("finished, certified"));
  CHECK(run_batch({"recover", cut, "-o", cut}).status == 2);
  CHECK(run_batch({"recover", cut}).status == 2);
  CHECK(run_batch({"recover", cut, "-o", (folder / "none" / "x.isorun").string()}).status == 1);
  CHECK(run_batch({"recover", (folder / "missing.isorun").string(), "-o", saved}).status == 3);
}
