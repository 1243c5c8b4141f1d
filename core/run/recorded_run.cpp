// The report carries the certificate; the journal carries Z.
#include "run/recorded_run.h"

#include "mesh/zero_set.h"
#include "run/parameters_json.h"
#include "run/passing_gate.h"
#include "run/report.h"
#include "run/statistics.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace isoscope {

namespace {

using Json = nlohmann::ordered_json;

/// A whole number; throws on any other, which get() would cast.
template <class T> T whole(const Json& json) {
  return static_cast<T>(json.get_ref<const Json::number_integer_t&>());
}

/// Reports older than the limit say nothing of it: they did not judge it.
void read_coverage(const Json& json, Certificate& c) {
  c.covers = json.value("covers", true);
  if (json.contains("cover_limit") && json.at("cover_limit").is_number())
    c.cover_limit = json.at("cover_limit").get<double>();
  for (const Json& place : json.value("uncovered", Json::array())) {
    const auto p = place.at("point").get<std::array<double, 3>>();
    c.uncovered.push_back(
        {{p[0], p[1], p[2]}, place.at("distance").get<double>(), place.at("size").get<double>()});
  }
  c.uncovered_count = whole<std::size_t>(json.value("uncovered_places", Json(0)));
  c.cover_note = json.value("cover_note", "");
  c.gap_note = json.value("gap_note", "");
}

void read_certificate(const Json& json, Certificate& c) {
  c.closed_manifold = json.at("closed_manifold").get<bool>();
  c.manifold = json.value("manifold", c.closed_manifold);
  c.oriented = json.at("oriented").get<bool>();
  if (const Json border = json.value("border", Json()); border.is_object()) {
    c.border.emplace();
    c.border->to_rim = border.at("to_rim").get<double>();
    c.border->from_rim = border.at("from_rim").get<double>();
    c.border->failures = border.at("failures").get<std::vector<std::string>>();
  }
  c.intersection_free = json.at("intersection_free").get<bool>();
  c.within_tolerance = json.at("within_tolerance").get<bool>();
  // JSON has no infinity: no bound is null.
  const Json& bound = json.at("max_distance");
  c.max_distance = bound.is_null() ? std::numeric_limits<double>::infinity() : bound.get<double>();
  const Json& distance = json.at("input_distance");
  if (distance.at("lower").is_number()) c.input_distance.lower = distance.at("lower").get<double>();
  if (distance.at("upper").is_number()) c.input_distance.upper = distance.at("upper").get<double>();
  c.separates = json.at("separates").get<bool>();
  const Json& told = json.at("topology_as_expected"); // null: nothing was asked
  const bool as_expected = told.is_null() || told.get<bool>();
  c.topology_note = json.value("topology_note", "");
  // Older reports called as expected what was not required.
  using Topology = Certificate::Topology;
  c.topology = !as_expected              ? Topology::wrong
               : c.topology_note.empty() ? Topology::as_expected
                                         : Topology::missed;
  const std::string topology = json.value("topology", "");
  for (const Topology t : {Topology::as_expected, Topology::wrong, Topology::missed, Topology::not_asked})
    if (name(t) == topology) c.topology = t;
  read_coverage(json, c);
  c.failures = json.at("failures").get<std::vector<std::string>>();
}

void read_normals(const Json& json, NormalDeviation& n) {
  n.oriented = json.at("oriented").get<bool>();
  n.points = whole<std::size_t>(json.at("points"));
  n.histogram = json.at("histogram").get<std::array<double, NormalDeviation::bin_count>>();
  n.mean = json.at("mean").get<double>();
  n.percentile_90 = json.at("percentile_90").get<double>();
  n.percentile_99 = json.at("percentile_99").get<double>();
  n.above_30 = json.at("above_30").get<double>();
  n.above_90 = json.at("above_90").get<double>();
}

void read_report(const Json& json, RunResult& result) {
  read_certificate(json.at("certificate"), result.certificate);
  result.certificate.components = whole<std::size_t>(json.at("output").at("components"));
  result.certificate.boundary_loops = whole<std::size_t>(json.at("output").value("boundary_loops", Json(0)));
  result.certificate.euler_characteristic = whole<long>(json.at("output").at("euler_characteristic"));
  read_normals(json.at("normals"), result.normals);
  result.refinement.unmet_height = whole<std::size_t>(json.at("unmet").at("height"));
  result.refinement.unmet_orientation = whole<std::size_t>(json.at("unmet").at("orientation"));
  result.refinement.uncertified = whole<std::size_t>(json.at("unmet").at("containment"));
  result.without_end = json.value("without_end", false);
  result.seconds = json.at("seconds").get<double>();
  result.peak_memory_bytes = whole<std::size_t>(json.at("peak_memory_bytes"));
}

} // namespace

RecordingHeader recording_header(const RunParameters& parameters, std::shared_ptr<const TriangleSoup> input,
                                 std::vector<InputNote> notes) {
  return {"isoscope " + std::string(version()), parameters_json(parameters), std::move(input),
          std::move(notes)};
}

RecordingEnd recording_end(const RunParameters& parameters, const Scene& scene, const RunResult& result,
                           const Journal& journal) {
  RecordingEnd end;
  end.state = name(result.end);
  end.certified = result.certificate.holds();
  end.report = report_json(parameters, scene, result, gather_statistics(journal));
  return end;
}

Result<std::shared_ptr<const Scene>> rebuild_scene(const RunParameters& parameters,
                                                   std::shared_ptr<const TriangleSoup> input,
                                                   const Journal& journal, RunControl& control,
                                                   std::vector<InputNote> notes) {
  RunParameters unlimited = parameters;
  unlimited.time_limit = unlimited.memory_limit = 0;
  PassingGate gate; // preparing needs one, but passes none
  Pipeline pipeline(unlimited, std::make_shared<Journal>(), gate, control);
  auto prepared = pipeline.prepare(std::move(input), std::move(notes), ThinParts::accept);
  if (!prepared) return prepared.error();
  auto scene = std::make_shared<Scene>(**prepared);
  if (!journal.sample_sets().empty()) scene->samples = journal.sample_sets()[0];
  return std::shared_ptr<const Scene>(std::move(scene));
}

Complex final_state(const Journal& journal) {
  Complex complex;
  for (std::size_t k = 0, n = journal.operations().size(); k < n; ++k)
    complex.apply(journal.operations()[k].delta());
  return complex;
}

Result<RunResult> recorded_result(const RecordingEnd& end, const Journal& journal) {
  RunResult result;
  try {
    read_report(Json::parse(end.report), result);
  } catch (const Json::exception&) {
    return Error{ErrorCode::bad_input, "The report in the recording cannot be read.",
                 "The events are sound; the certificate is lost."};
  }
  for (const RunResult::End e : {RunResult::End::finished, RunResult::End::stopped, RunResult::End::limit})
    if (name(e) == end.state) result.end = e;
  for (std::size_t i = 0, n = journal.events().size(); i < n; ++i)
    if (journal.events()[i].kind == EventKind::stage_begin) result.last_stage = journal.events()[i].stage;
  const Complex complex = final_state(journal);
  result.form = complex.form;
  result.mesh = triangulate(extract_zero_set(complex));
  if (!journal.parameters().empty())
    result.crumbs = count_small_parts(result.mesh, crumb_size * journal.parameters()[0].criteria.delta);
  return result;
}

} // namespace isoscope
