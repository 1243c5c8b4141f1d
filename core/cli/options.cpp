// Options by CLI11, values judged by parameters.h.
#include "cli/options.h"

#include "input/gallery.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>

namespace isoscope {

struct RunOptions::Raw {
  std::string input;
  std::string tolerance;
  std::optional<double> sigma, alpha, shrink, time_limit;
  std::optional<unsigned> threads;
  std::string until = "refinement", containment = "certified", topology = "keep";
  std::vector<int> off;
  bool no_normals = false;
  std::optional<int> effort;
  std::string record, breakpoint;
};

namespace {

Error later(const std::string& option) {
  return {ErrorCode::unsupported, option + " belongs to a later stage, which this version does not have.",
          "Leave it out; --until refinement is what there is."};
}

Error unknown(const std::string& option, const std::string& value, const std::string& choices) {
  return {ErrorCode::usage, option + " is '" + value + "', which is not one of " + choices + ".", ""};
}

constexpr std::array<std::string_view, 5> later_stages{"gamma", "tessellation", "zero-set", "all", "improve"};

} // namespace

RunOptions::RunOptions(CLI::App& app, bool input_required) : raw_(std::make_unique<Raw>()) {
  Raw& r = *raw_;
  auto* input = app.add_option("INPUT", r.input,
                               "a mesh file (OFF, OBJ, PLY, STL), or gallery:NAME for a bundled model");
  if (input_required) input->required();
  app.add_option(
      "--tolerance", r.tolerance,
      "δ: a percentage of the longest edge of the bounding box (0.6%) or a length; default 0.6%, for bundled "
      "models their own");
  app.add_option(
      "--sigma", r.sigma,
      "σ/δ, density of the samples, in (0, 1]; default 0.5, or what keeps them to about two million, at most "
      "0.95; sampled mode 0.125");
  app.add_option("--alpha", r.alpha, "α, margin of the classification, in (0, 1); default 0.2");
  app.add_option("--shrink", r.shrink, "factor of the shrunk copy in condition 3, in (0, 1]; default 0.7");
  app.add_option("--until", r.until, "the last stage to run: refinement");
  app.add_option("--threads", r.threads,
                 "number of threads, 0 for all cores; the result does not depend on it");
  app.add_option("--containment", r.containment,
                 "certified (facets proven inside the volume) or sampled (the paper to the letter)");
  app.add_option("--topology", r.topology, "keep (the input's) or separate (only the sides)");
  app.add_option("--no-condition", r.off,
                 "switch a condition of the refinement off: 1, 2, 3 or 4; repeatable");
  app.add_flag("--no-normals", r.no_normals, "the same as --no-condition 3");
  app.add_option("--time-limit", r.time_limit, "seconds after which the run stops with what it has; 0: none");
  for (const auto& [option, target] :
       {std::pair{"--record", &r.record}, std::pair{"--break", &r.breakpoint}}) {
    app.add_option(option, *target)->group("");
  }
  app.add_option("--effort", r.effort)->group("");
}

RunOptions::~RunOptions() = default;

Result<RunParameters> RunOptions::finish() const {
  const Raw& r = *raw_;
  if (r.effort) return later("--effort");
  if (!r.record.empty()) return later("--record");
  if (!r.breakpoint.empty()) return later("--break");
  if (r.input == "replay") return later("replay");
  if (std::find(later_stages.begin(), later_stages.end(), r.until) != later_stages.end()) {
    return later("--until " + r.until);
  }
  if (r.until != "refinement") return unknown("--until", r.until, "refinement");

  RunParameters p;
  p.input = r.input;
  for (const GalleryEntry& entry : gallery()) {
    if (r.input == "gallery:" + std::string(entry.name)) p.tolerance = {entry.tolerance_percent, true};
  }
  if (!r.tolerance.empty()) {
    const auto tolerance = parse_tolerance(r.tolerance);
    if (!tolerance) return tolerance.error();
    p.tolerance = *tolerance;
  }
  if (r.containment == "sampled") {
    p.containment = Containment::sampled;
  } else if (r.containment != "certified") {
    return unknown("--containment", r.containment, "certified, sampled");
  }
  if (r.topology == "separate") {
    p.topology = TopologyMode::separate;
  } else if (r.topology != "keep") {
    return unknown("--topology", r.topology, "keep, separate");
  }
  if (r.sigma) {
    if (*r.sigma == 0)
      return Error{ErrorCode::usage, "--sigma is 0, which is not in (0, 1].", "It is relative to δ."};
    p.sigma = *r.sigma;
  }
  p.alpha = r.alpha.value_or(p.alpha);
  p.shrink = r.shrink.value_or(p.shrink);
  p.threads = r.threads.value_or(p.threads);
  p.time_limit = r.time_limit.value_or(p.time_limit);
  p.condition_3 = !r.no_normals;
  for (const int condition : r.off) {
    switch (condition) {
    case 1:
      p.condition_1 = false;
      break;
    case 2:
      p.condition_2 = false;
      break;
    case 3:
      p.condition_3 = false;
      break;
    case 4:
      p.condition_4 = false;
      break;
    default:
      return unknown("--no-condition", std::to_string(condition), "1, 2, 3, 4");
    }
  }
  if (Status valid = check(p); !valid) return valid.error();
  return p;
}

std::string gallery_table() {
  std::string table;
  for (const GalleryEntry& e : gallery()) {
    char line[512];
    std::snprintf(line, sizeof line, "gallery:%-15s δ %5.2f%%  χ %3ld  %s\n", std::string(e.name).c_str(),
                  e.tolerance_percent, e.euler_characteristic, std::string(e.lesson).c_str());
    table += line;
  }
  return table;
}

} // namespace isoscope
