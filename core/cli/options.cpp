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
  std::optional<double> sigma, alpha, shrink, time_limit, memory_limit, drop_small;
  std::optional<unsigned> threads;
  std::string until, containment = "certified", topology = "keep", sides = "auto", cover = "3", target,
                     improver = "free";
  std::vector<std::string> skip;
  std::vector<int> off;
  bool no_normals = false, drop_thin = false;
  int effort = 2, cost_ring = 1;
  std::string record;
  std::vector<std::string> breakpoints;
  const CLI::App* app = nullptr; ///< on which they are registered
};

namespace {

Error unknown(const std::string& option, const std::string& value, const std::string& choices) {
  return {ErrorCode::usage, option + " is '" + value + "', which is not one of " + choices + ".", ""};
}

/// The stage of that name, if it is one of those a user may name.
std::optional<Stage> stage_named(const std::string& text, Stage first) {
  for (int i = static_cast<int>(first); i < stage_count; ++i) {
    if (name(static_cast<Stage>(i)) == text) return static_cast<Stage>(i);
  }
  return std::nullopt;
}

std::optional<TargetStrategy> strategy_named(const std::string& text) {
  for (const TargetStrategy s : {TargetStrategy::optimum, TargetStrategy::constraints,
                                 TargetStrategy::sampling, TargetStrategy::octree}) {
    if (name(s) == text) return s;
  }
  return std::nullopt;
}

} // namespace

RunOptions::RunOptions(CLI::App& app, bool input_required) : raw_(std::make_unique<Raw>()) {
  Raw& r = *raw_;
  r.app = &app;
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
  app.add_option(
      "--until", r.until,
      "the last stage to run: refinement, gamma, tessellation, zero-set, all or improve; default improve, "
      "sampled mode all");
  app.add_option("--skip", r.skip, "a stage to leave out: gamma, zero-set, all or improve; repeatable");
  app.add_option(
      "--target", r.target,
      "how targets of collapses are found: optimum, constraints, sampling or octree (the paper's); default "
      "constraints, sampled mode sampling");
  app.add_option("--cost-ring", r.cost_ring,
                 "facets whose planes make the error of a collapse: 1 or 2 rings; default 1");
  app.add_option("--effort", r.effort, "of the improver: 0 (least) to 3 (fewest vertices); default 2");
  app.add_option("--improver", r.improver,
                 "where it works: free (Z leaves T, fewest vertices) or embedded (inside T); default free");
  app.add_option(
      "--drop-small", r.drop_small,
      "leave out connected components of the input whose box is smaller than so many δ; default 0: none");
  app.add_option("--threads", r.threads,
                 "number of threads, 0 for all cores; the result does not depend on it");
  app.add_option("--containment", r.containment,
                 "certified (facets proven inside the volume) or sampled (the paper to the letter)");
  app.add_option("--topology", r.topology, "keep (the input's) or separate (only the sides)");
  app.add_option("--cover", r.cover,
                 "how far from the result a point of the input may be, in δ, or off; default 3");
  app.add_flag(
      "--drop-thin", r.drop_thin,
      "leave out parts of the input that are thinner than twice the tolerance everywhere, and say so; "
      "without it they are refused");
  app.add_option(
      "--sides", r.sides,
      "what tells inside from outside: auto (parity; where closed parts meet, the winding number), "
      "winding or parity");
  app.add_option("--no-condition", r.off,
                 "switch a condition of the refinement off: 1, 2, 3 or 4; repeatable");
  app.add_flag("--no-normals", r.no_normals, "the same as --no-condition 3");
  app.add_option("--time-limit", r.time_limit, "seconds after which the run stops with what it has; 0: none");
  app.add_option(
      "--memory-limit", r.memory_limit,
      "MiB that the volume and its samples may take, foreseen before they are made; 0, the default: two "
      "thirds of the machine's memory");
  app.add_option("--record", r.record,
                 "keep the run, event by event, in a file RUN.isorun; it can be opened while it grows");
  app.add_option("--break", r.breakpoints,
                 "stop at the first event for which a condition holds, such as "
                 "'reject && reason == kernel_empty'; repeatable, each stops");
}

RunOptions::~RunOptions() = default;

const std::string& RunOptions::recording() const {
  return raw_->record;
}

Result<RunParameters> RunOptions::finish() const {
  const Raw& r = *raw_;
  if (Status whole = check_values(*r.app); !whole) return whole.error();

  RunParameters p;
  p.input = r.input;
  if (!r.until.empty()) {
    p.until = stage_named(r.until, Stage::refinement);
    if (!p.until) {
      return unknown("--until", r.until, "refinement, gamma, tessellation, zero-set, all, improve");
    }
  }
  for (const std::string& skip : r.skip) {
    const auto stage = stage_named(skip, Stage::gamma);
    if (!stage || *stage == Stage::tessellation)
      return unknown("--skip", skip, "gamma, zero-set, all, improve");
    p.skipped[static_cast<std::size_t>(*stage)] = true;
  }
  if (r.cost_ring != 1 && r.cost_ring != 2)
    return unknown("--cost-ring", std::to_string(r.cost_ring), "1, 2");
  p.cost_ring = r.cost_ring == 1 ? CostRing::one : CostRing::two;
  p.effort = r.effort;
  if (r.improver == "embedded") {
    p.improver = ImproverPlace::embedded;
  } else if (r.improver != "free") {
    return unknown("--improver", r.improver, "free, embedded");
  }
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
  // Half-spaces are learnt from facets that leave Ω, which sampled mode does not look at.
  if (p.containment == Containment::sampled) p.target = TargetStrategy::sampling;
  if (!r.target.empty()) {
    const auto strategy = strategy_named(r.target);
    if (!strategy) return unknown("--target", r.target, "optimum, constraints, sampling, octree");
    p.target = *strategy;
  }
  if (r.topology == "separate") {
    p.topology = TopologyMode::separate;
  } else if (r.topology != "keep") {
    return unknown("--topology", r.topology, "keep, separate");
  }
  const auto sides = sides_mode(r.sides);
  if (!sides) return unknown("--sides", r.sides, "auto, winding, parity");
  p.sides = *sides;
  if (r.sigma) {
    if (*r.sigma == 0)
      return Error{ErrorCode::usage, "--sigma is 0, which is not in (0, 1].", "It is relative to δ."};
    p.sigma = *r.sigma;
  }
  p.alpha = r.alpha.value_or(p.alpha);
  p.shrink = r.shrink.value_or(p.shrink);
  p.threads = r.threads.value_or(p.threads);
  p.drop_small = r.drop_small.value_or(p.drop_small);
  p.time_limit = r.time_limit.value_or(p.time_limit);
  p.drop_thin = r.drop_thin;
  const auto cover = parse_cover(r.cover);
  if (!cover) return cover.error();
  p.cover = *cover;
  p.memory_limit = r.memory_limit.value_or(p.memory_limit);
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

const std::vector<std::string>& RunOptions::breakpoints() const {
  return raw_->breakpoints;
}

Status check_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options())
    for (const std::string& value : option->results())
      if (value.empty())
        return Error{ErrorCode::usage, option->get_name() + " has an empty value.",
                     "Give one, or leave the option out."};
  return {};
}

Status add_breakpoints(const std::vector<std::string>& texts, BreakpointSet& set) {
  for (const std::string& text : texts) {
    const auto added = set.add(text);
    if (const auto* wrong = std::get_if<QueryError>(&added))
      return Error{ErrorCode::usage, "--break: " + wrong->picture(text), ""};
  }
  return {};
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
