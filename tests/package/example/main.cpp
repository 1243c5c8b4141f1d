// A soup and a tolerance in, a mesh and its certificate out: approximate MODEL PERCENT OUT.off
#include <input/mesh_io.h>
#include <run/approximate.h>
#include <run/run_input.h>

#include <cstdio>
#include <cstdlib>

static int fail(const isoscope::Error& error) {
  std::fprintf(stderr, "%s\n", error.line().c_str());
  return 2;
}

int main(int argc, char** argv) {
  if (argc != 4) return fail({isoscope::ErrorCode::usage, "approximate MODEL PERCENT OUT.off", ""});
  isoscope::RunParameters parameters;
  parameters.input = argv[1];                        // a file, or gallery:NAME
  parameters.tolerance = {std::atof(argv[2]), true}; // percent of the longest edge
  auto soup = isoscope::load_input(parameters);      // or points and triangles of your own
  if (!soup) return fail(soup.error());
  isoscope::RunControl control; // control.cancel() on another thread ends it with the mesh of the moment
  const auto made = isoscope::approximate(std::move(*soup), parameters, control);
  if (!made) return fail(made.error());
  const isoscope::RunResult& result = made->result;
  if (auto written = isoscope::write_mesh(argv[3], result.mesh); !written) return fail(written.error());
  std::printf("%zu vertices, %s\n", result.mesh.points.size(),
              result.certificate.holds() ? "certified" : "not certified");
  for (const std::string& failure : result.certificate.failures) std::puts(failure.c_str());
  return result.exit_status();
}
