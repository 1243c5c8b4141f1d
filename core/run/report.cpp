// The report's JSON.
#include "run/report.h"

#include "base/fields_json.h"
#include "base/pending_file.h"

#include <algorithm>

namespace isoscope {

namespace {

using Json = nlohmann::ordered_json;

Json optional_number(const std::optional<long>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json reasons_json(const StageStatistics::ReasonCounts& counts) {
  Json reasons = Json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) reasons[std::string(name(static_cast<Reason>(i)))] = counts[i];
  }
  return reasons;
}

Json stage_json(const StageStatistics& s) {
  Json insertions = Json::object();
  for (std::size_t i = 0; i < s.insertions.size(); ++i) {
    if (s.insertions[i] > 0) insertions[std::string(name(static_cast<Condition>(i)))] = s.insertions[i];
  }
  return {{"name", name(s.stage)},
          {"seconds", s.seconds},
          {"operations", s.operations},
          {"seconds_per_operation", s.seconds_per_operation()},
          {"insertions", insertions},
          {"collapses", s.collapses},
          {"found", reasons_json(s.found)},
          {"rejected", reasons_json(s.rejected)},
          {"relaxation_sweeps", s.relaxations},
          {"repairs", s.repairs},
          {"repair_sweeps", s.repair_sweeps},
          {"failed_repairs", s.failed_repairs},
          {"failed_repair_sweeps", s.failed_repair_sweeps},
          {"zero_set_vertices", s.zero_set_vertices}};
}

Json point_json(Vec3 p) {
  return {p.x, p.y, p.z};
}

Json left_out_json(const std::vector<ThinPart>& parts) {
  Json list = Json::array();
  for (const ThinPart& part : parts) {
    list.push_back({{"place", point_json(part.place)},
                    {"thickness", part.thickness},
                    {"size", part.box.longest_edge()},
                    {"triangles", part.triangles}});
  }
  return list;
}

/// The regions of several rooms, the outside first; null where there is one inside.
Json regions_json(const Scene& scene, const Certificate& certificate) {
  if (certificate.regions.empty()) return nullptr;
  Json list = Json::array();
  for (const RegionCertificate& r : certificate.regions) {
    Json places = Json::array();
    for (const Region& region : scene.regions)
      if (region.label == r.label && !region.shallow && !region.unbounded)
        places.push_back(point_json(region.deepest));
    list.push_back({{"label", r.label},
                    {"places", places},
                    {"vertices", r.vertices},
                    {"faces", r.facets},
                    {"components", r.components},
                    {"euler_characteristic", r.euler_characteristic},
                    {"closed_manifold", r.closed_manifold},
                    {"oriented", r.oriented},
                    {"volume", r.volume}});
  }
  return list;
}

Json uncovered_json(const std::vector<UncoveredPlace>& places, double delta) {
  Json list = Json::array();
  for (const UncoveredPlace& p : places) {
    list.push_back({{"point", point_json(p.point)},
                    {"distance", p.distance},
                    {"distance_in_delta", p.distance / delta},
                    {"size", p.size}});
  }
  return list;
}

Json normals_json(const NormalDeviation& n) {
  return {{"oriented", n.oriented},
          {"points", n.points},
          {"bin_degrees", NormalDeviation::bin_degrees},
          {"histogram", n.histogram},
          {"mean", n.mean},
          {"percentile_90", n.percentile_90},
          {"percentile_99", n.percentile_99},
          {"above_30", n.above_30},
          {"above_90", n.above_90}};
}

Json region_json(const LastingRegion& r) {
  return {{"separation", r.separation},
          {"depth", r.depth},
          {"saddle", point_json(r.saddle)},
          {"deepest", point_json(r.deepest)}};
}

/// The tolerances that were studied; null where none were.
Json study_json(const Scene& scene) {
  if (!scene.study) return nullptr;
  const DeltaStudy& study = *scene.study;
  Json curve = Json::array(), insides = Json::array();
  for (const DeltaStudy::Step& s : study.curve)
    curve.push_back(
        {{"delta", s.delta}, {"components", s.components}, {"regions", s.regions}, {"deep", s.deep}});
  for (const LastingRegion& r : study.insides) insides.push_back(region_json(r));
  return {{"found", study.found()},     {"least", study.least}, {"most", study.most},
          {"proposed", study.proposed}, {"insides", insides},   {"curve", curve}};
}

Json quantiles_json(const PointDistances::Quantiles& q) {
  return {{"median", q.median},
          {"percentile_90", q.percentile_90},
          {"percentile_99", q.percentile_99},
          {"most", q.most}};
}

/// What was made of points; null for other inputs.
Json points_json(const Scene& scene, const RunResult& result) {
  if (!scene.points) return nullptr;
  const PointField& field = *scene.points;
  Json dropped = Json::array();
  for (const DroppedPoints& d : field.dropped)
    dropped.push_back(
        {{"why", d.why == DroppedPoints::Why::outliers ? "outliers" : "blob"},
         {"points", d.points},
         {"share", static_cast<double>(d.points) / static_cast<double>(field.points->points.size())},
         {"place", point_json(d.place)},
         {"size", d.size},
         {"parts", d.parts}});
  Json json{{"count", field.points->points.size()},
            {"drawn_from_triangles", field.drawn},
            {"neighbors", field.neighbors},
            {"neighbors_found", field.automatic},
            {"outlying", field.outlying},
            {"dropped", dropped},
            {"distances", nullptr}};
  if (result.points)
    json["distances"] = {{"kept", quantiles_json(result.points->kept)},
                         {"all", quantiles_json(result.points->all)},
                         {"beyond_cover", result.points->far},
                         {"farthest", point_json(result.points->farthest)}};
  return json;
}

/// Of open surfaces; null where there are none.
Json border_json(const Certificate& c) {
  if (!c.border) return nullptr;
  return {{"to_rim", c.border->to_rim}, {"from_rim", c.border->from_rim}, {"failures", c.border->failures}};
}

Json rim_json(const Scene& scene) {
  const OpenSides* sides = scene.volume ? scene.volume->open_sides() : nullptr;
  if (sides == nullptr) return nullptr;
  Json loops = Json::array();
  for (const RimLoop& loop : sides->rim().loops())
    loops.push_back({{"center", point_json(loop.center)},
                     {"length", loop.length},
                     {"diameter", loop.diameter},
                     {"flatness", loop.flatness}});
  Json json{{"samples", scene.samples->over_rim.size()}, {"loops", loops}};
  if (scene.sheets)
    json["ball_test"] = {{"gamma", scene.sheets->gamma},
                         {"samples", scene.sheets->samples},
                         {"boundary_samples", scene.sheets->boundary_samples}};
  return json;
}

Json curve_json(const std::vector<CurvePoint>& curve) {
  Json list = Json::array();
  for (const CurvePoint& p : curve)
    list.push_back({{"seconds", p.seconds}, {"vertices", p.vertices}, {"stage", name(p.stage)}});
  return list;
}

/// The least vertices as an estimate, where it can be told.
Json optimum_json(const Scene& scene, const RunResult& result) {
  if (!scene.optimum) return nullptr;
  const AsymptoticCount& optimum = *scene.optimum;
  return {{"vertices", optimum.vertices},
          {"ratio", static_cast<double>(result.size().vertices) / optimum.vertices},
          {"elliptic", optimum.elliptic},
          {"hyperbolic", optimum.hyperbolic}};
}

/// What was in force, δ and σ as they were for this input; what says which input it is stands with that.
Json used_parameters_json(const RunParameters& p, const Scene& scene) {
  Json json{{"tolerance", scene.delta},
            {"tolerance_given", tolerance_text(p, scene)},
            {"sigma", p.sigma_ratio(scene.default_sigma)}};
  for_each_field<RunParameters>([&]<class T>(const Field<RunParameters, T>& f) {
    const bool of_input = f.name == "input" || f.name == "inside" || f.name == "levels" || f.name == "label";
    if (of_input || json.contains(f.name)) return;
    if constexpr (FieldParts<T>)
      json[std::string(f.name)] = f.value(p).text();
    else
      write_field(json, f, f.value(p));
  });
  return json;
}

} // namespace

std::string_view name(RunResult::End end) {
  switch (end) {
  case RunResult::End::finished:
    return "finished";
  case RunResult::End::stopped:
    return "stopped";
  case RunResult::End::limit:
    return "time limit";
  }
  return "unknown";
}

std::string_view version() {
  return ISOSCOPE_VERSION;
}

std::string report_json(const RunParameters& p, const Scene& scene, const RunResult& result,
                        const std::vector<StageStatistics>& stages) {
  const Certificate& c = result.certificate;
  Json stage_list = Json::array();
  for (const StageStatistics& s : stages) stage_list.push_back(stage_json(s));
  Json components = Json::array();
  for (const BoundaryComponent& b : scene.boundary_components) {
    components.push_back({{"label", b.label}, {"euler_characteristic", b.euler_characteristic}});
  }
  Json warnings = Json::array();
  for (const ParameterWarning& w : scene.warnings) warnings.push_back(w.message);
  if (!scene.thickening_note.empty()) warnings.push_back(scene.thickening_note);
  if (const std::string note = crumbs_note(result.crumbs, result.size().vertices); !note.empty())
    warnings.push_back(note);
  const long chi = c.euler_characteristic;

  Json report{
      {"version", version()},
      {"input",
       {{"path", p.input},
        {"inside", p.inside},
        {"levels", p.levels.text()},
        {"label", p.label ? Json(*p.label) : Json(nullptr)},
        {"vertices", scene.input_size.vertices},
        {"faces", scene.input_size.triangles},
        {"longest_edge", scene.longest_edge},
        {"closed_manifold", scene.input_topology.closed_manifold},
        {"self_intersection_free", scene.input_topology.self_intersection_free},
        {"consistently_oriented", scene.input_topology.consistently_oriented},
        {"euler_characteristic", optional_number(scene.input_topology.euler_characteristic)},
        {"boundary_loops",
         scene.input_topology.boundary_loops ? Json(*scene.input_topology.boundary_loops) : Json(nullptr)},
        {"sides_by", name(scene.volume ? scene.volume->sides().rule() : scene.input_topology.side_rule)},
        {"left_out", left_out_json(scene.left_out)}}},
      {"parameters", used_parameters_json(p, scene)},
      {"samples",
       {{"count", scene.samples->size()},
        {"components", components},
        {"covering_radius", scene.samples->covering_radius},
        {"held_in_thin_parts", scene.held},
        {"undecided_cells", scene.samples->undecided_cells},
        {"regions", scene.regions.size()}}},
      {"expected",
       {{"euler_characteristic", optional_number(scene.expected.euler_characteristic)},
        {"components", scene.expected.components ? Json(*scene.expected.components) : Json(nullptr)},
        {"boundary_loops",
         scene.expected.boundary_loops ? Json(*scene.expected.boundary_loops) : Json(nullptr)},
        {"loops_untold", scene.expected.loops_untold},
        {"required", scene.expected.required},
        {"source", scene.expected.source}}},
      {"rim", rim_json(scene)},
      {"points", points_json(scene, result)},
      {"tolerances", study_json(scene)},
      {"warnings", warnings},
      {"parts",
       {{"input_seconds", scene.input_seconds},
        {"volume_seconds", scene.volume_seconds},
        {"sampling_seconds", scene.sampling_seconds}}},
      {"stages", stage_list},
      {"unmet",
       {{"height", result.refinement.unmet_height},
        {"orientation", result.refinement.unmet_orientation},
        {"containment", result.refinement.uncertified}}},
      {"output",
       {{"vertices", result.size().vertices},
        {"faces", result.size().triangles},
        {"components", c.components},
        {"euler_characteristic", chi},
        {"boundary_loops", c.boundary_loops},
        {"filled_faces", std::count(result.holes.facets.begin(), result.holes.facets.end(), 1)},
        {"genus",
         c.regions.empty()
             ? Json((2 * static_cast<long>(c.components) - chi - static_cast<long>(c.boundary_loops)) / 2)
             : Json(nullptr)},
        {"regions", regions_json(scene, c)},
        {"crumbs", {{"components", result.crumbs.components}, {"vertices", result.crumbs.vertices}}},
        {"embedding", result.form == ZeroForm::free ? "Z alone" : "T"},
        {"empty", result.size().triangles == 0}}},
      {"asymptotic_optimum", optimum_json(scene, result)},
      {"curve", curve_json(result.curve)},
      {"normals", normals_json(result.normals)},
      {"certificate",
       {{"holds", c.holds()},
        {"closed_manifold", c.closed_manifold},
        {"manifold", c.manifold},
        {"oriented", c.oriented},
        {"border", border_json(c)},
        {"intersection_free", c.intersection_free},
        {"within_tolerance", c.within_tolerance},
        {"max_distance", c.max_distance},
        {"covers", c.covers},
        {"cover_limit", c.cover_limit ? Json(*c.cover_limit) : Json(nullptr)},
        {"max_input_distance", c.input_distance.upper},
        {"uncovered", uncovered_json(c.uncovered, scene.delta)},
        {"uncovered_places", c.uncovered_count},
        {"cover_note", c.cover_note},
        {"gap_note", c.gap_note},
        {"input_distance", {{"lower", c.input_distance.lower}, {"upper", c.input_distance.upper}}},
        {"separates", c.separates},
        {"topology_as_expected",
         c.topology == Certificate::Topology::not_asked ? Json(nullptr) : Json(c.topology_as_expected())},
        {"topology", name(c.topology)},
        {"topology_note", c.topology_note},
        {"failures", c.failures}}},
      {"branch", result.branch.empty() ? Json(nullptr) : Json(result.branch)},
      {"end", name(result.end)},
      {"without_end", result.without_end},
      {"seconds", result.seconds},
      {"peak_memory_bytes", result.peak_memory_bytes},
  };
  if (result.failure) report["failure"] = result.failure->line();
  return report.dump(2) + "\n";
}

Status write_text_file(const std::filesystem::path& file, const std::string& text) {
  PendingFile out;
  if (Status opened = out.open(file, WriteTarget::file_or_device); !opened) return opened;
  out.append(text);
  return out.commit();
}

} // namespace isoscope
