// Values are judged by parameters.h.
#include "cli/options.h"

#include "base/field_options.h"
#include "input/gallery.h"
#include "input/point_files.h"

#include <cstdio>
#include <optional>

namespace isoscope {

struct RunOptions::Raw {
  RunParameters parameters;
  std::optional<Error> wrong; ///< the first value that a field cannot have
  bool no_normals = false;
  std::string outside;
  std::string record;
  std::vector<std::string> breakpoints;
};

RunOptions::RunOptions(CommandLine& line) : line_(line), raw_(std::make_unique<Raw>()) {
  Raw& r = *raw_;
  line.fields(field_options(r.parameters), r.wrong);
  line.option("--outside", r.outside, "the outer surface, a mesh file, where --inside gives the inner one");
  line.flag("--no-normals", r.no_normals, "the same as --no-condition 3");
  line.option("--record", r.record,
              "keep the run, event by event, in a file RUN.isorun; it can be opened while it grows");
  line.option("--break", r.breakpoints,
              "stop at the first event for which a condition holds, such as "
              "'reject && reason == kernel_empty'; repeatable, each stops");
}

RunOptions::~RunOptions() = default;

const std::string& RunOptions::recording() const {
  return raw_->record;
}

Result<RunParameters> RunOptions::finish() const {
  const Raw& r = *raw_;
  if (Status whole = line_.check_values(); !whole) return whole.error();
  if (r.wrong) return *r.wrong;
  RunParameters p = r.parameters;
  const auto given = [&](const char* option) { return line_.given(option); };
  if (given("--outside") != given("--inside"))
    return Error{ErrorCode::usage,
                 std::string(given("--outside") ? "--inside" : "--outside") +
                     " is missing: a volume has two walls.",
                 "Give --inside INNER --outside OUTER."};
  if (given("--outside") && given("INPUT"))
    return Error{ErrorCode::usage, "INPUT is given, and a volume by --inside and --outside.",
                 "Give one of both."};
  if (given("--outside")) p.input = r.outside;
  if (given("--tolerance") && (given("--inside") || given("--levels") || given("--label")))
    return Error{ErrorCode::usage, "--tolerance is given where the volume itself is: it tells δ.",
                 "Leave --tolerance out."};
  if (const GalleryEntry* entry = gallery_entry(p.input)) {
    if (entry->gives_volume() && given("--tolerance"))
      return Error{ErrorCode::usage, "--tolerance is given where the volume itself is: it tells δ.",
                   "Leave --tolerance out."};
    if (!entry->gives_volume() && !given("--tolerance")) p.tolerance = {entry->tolerance_percent, true};
    if (!given("--levels")) p.levels = {entry->low, entry->high};
  }
  if (!given("--tolerance") && holds_points_alone(p.input)) p.tolerance.automatic = true;
  // Half-spaces are learnt from facets that leave Ω, which sampled mode does not look at.
  if (p.containment == Containment::sampled && !line_.given("--target")) p.target = TargetStrategy::sampling;
  if (r.no_normals) p.conditions[2] = false;
  if (Status valid = check(p); !valid) return valid.error();
  return p;
}

const std::vector<std::string>& RunOptions::breakpoints() const {
  return raw_->breakpoints;
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
    char delta[16];
    std::snprintf(delta, sizeof delta, "%5.2f%%", e.tolerance_percent);
    std::snprintf(line, sizeof line, "%-23s δ %s  χ %3ld  %s\n", gallery_input(e.name).c_str(),
                  e.gives_volume() ? " given" : delta, e.euler_characteristic, std::string(e.lesson).c_str());
    table += line;
  }
  return table;
}

} // namespace isoscope
