// The whole method as one call does what a run step by step does.
#include "input/gallery.h"
#include "journal/digest.h"
#include "run/approximate.h"
#include "run/complete_run.h"

#include <doctest/doctest.h>

#include <utility>

using namespace isoscope;
using namespace isoscope::test;

TEST_CASE("one call gives journal, mesh and certificate of a run step by step") {
  CompleteRun run(complete_parameters("sphere"));
  REQUIRE(run.run());
  auto soup = make_gallery_model("sphere");
  REQUIRE(soup);
  RunParameters parameters = run.parameters;
  parameters.input.clear();
  parameters.threads = 2;
  RunControl control;
  const auto made = approximate(std::move(*soup), parameters, control);
  REQUIRE(made);
  CHECK(digest(*made->journal) == digest(*run.journal));
  CHECK(made->scene->delta == run.scene->delta);
  CHECK(made->result.end == RunResult::End::finished);
  CHECK(made->result.certificate.holds());
  CHECK(made->result.mesh.triangles == run.result->mesh.triangles);
}

TEST_CASE("what one call cannot do is told as an error") {
  RunParameters parameters = gallery_parameters("sphere");
  const auto code = [&](TriangleSoup soup, RunControl& control) {
    const auto made = approximate(std::move(soup), parameters, control);
    REQUIRE(!made);
    CHECK(!made.error().message.empty());
    return made.error().code;
  };
  auto sphere = make_gallery_model("sphere");
  REQUIRE(sphere);
  RunControl control, cancelled;
  cancelled.cancel();
  CHECK(code(TriangleSoup(), control) == ErrorCode::bad_input);
  parameters.tolerance.value = 0;
  CHECK(code(*sphere, control) == ErrorCode::usage);
  parameters.tolerance.value = 2;
  CHECK(code(*sphere, cancelled) == ErrorCode::cancelled);
}
