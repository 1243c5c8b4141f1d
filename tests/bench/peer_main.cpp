// isoscope-peer: one peer on one model, its mesh and a line of JSON; scripts/experiments calls it.
#include "bench/peer.h"

#include "input/gallery.h"
#include "input/mesh_io.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace {

using namespace isoscope;

int fail(const Error& error) {
  std::fprintf(stderr, "isoscope-peer: %s\n", error.line().c_str());
  return error.code == ErrorCode::usage ? 2 : 3;
}

int run(const std::string& model, const bench::Asked& asked, const std::string& output) {
  const auto input = model.starts_with(gallery_prefix)
                         ? make_gallery_model(model.substr(gallery_prefix.size()))
                         : read_mesh(model);
  if (!input) return fail(input.error());
  const auto result = bench::ask_peer(*input, asked);
  if (!result) return fail(result.error());
  if (!output.empty())
    if (const Status written = write_mesh(output, result->mesh); !written) return fail(written.error());
  std::printf("%s\n", bench::json_line(*result).c_str());
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Simplifies a model by another tool and measures the result: vertices, bounds of both one-sided "
      "Hausdorff distances, self-intersections, CPU seconds.",
      "isoscope-peer"};
  std::string peer, model, tolerance, output;
  bench::Asked asked;
  app.add_option(
         "PEER", peer,
         "lindstrom-turk (CGAL's, to a number of vertices), certificate (the same, each triangle proven "
         "within the tolerance), envelope (the same within CGAL's polyhedral envelope), meshoptimizer, "
         "alpha-wrap")
      ->required()
      ->check(CLI::IsMember(bench::peer_names()));
  app.add_option("MODEL", model, "a mesh file or gallery:NAME")->required();
  app.add_option("--tolerance", tolerance, "δ: a percentage of the longest edge (0.6%) or a length");
  app.add_option("--vertices", asked.vertices, "of lindstrom-turk");
  app.add_option("-o,--output", output, "the mesh");
  app.footer("Exit status: 0 done, 2 usage, 3 what the peer cannot take.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  asked.peer = *bench::peer_of(peer);
  if (!tolerance.empty()) {
    const auto read = Tolerance::read(tolerance);
    if (!read)
      return fail({ErrorCode::usage, "--tolerance " + tolerance + " is no tolerance.",
                   "Give a percentage of the longest edge, as 0.6%, or a length."});
    asked.tolerance = *read;
  }
  return run(model, asked, output);
}
