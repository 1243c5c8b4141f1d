// The schema: plain columns for what people ask about, blobs for the rest.
#include "recording/layout.h"

namespace isoscope {

const char* const recording_schema = R"sql(
-- What the run was asked: program, parameters (JSON).
CREATE TABLE run(key TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;
-- The input itself: points and triangles, or a grid, as bytes.
CREATE TABLE input(id INTEGER PRIMARY KEY, name TEXT, points INTEGER, triangles INTEGER, digest TEXT, data BLOB);
-- The names that the numbers of event_rows stand for.
CREATE TABLE kinds(id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE stages(id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE conditions(id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE reasons(id INTEGER PRIMARY KEY, name TEXT);
-- Every decision. step: operations applied before it; operation: 1 when it has a delta.
CREATE TABLE event_rows(id INTEGER PRIMARY KEY, step INTEGER, kind INTEGER, stage INTEGER, condition INTEGER,
  reason INTEGER, operation INTEGER, tet INTEGER, sample INTEGER, vertex INTEGER, other INTEGER, x, y, z,
  witness_x, witness_y, witness_z, value, limit_value, count INTEGER, text INTEGER, detail INTEGER,
  facet_a INTEGER, facet_b INTEGER, facet_c INTEGER);
-- Every operation: it leads from step to step + 1. delta: bytes.
CREATE TABLE operations(step INTEGER PRIMARY KEY, event INTEGER, bad_samples INTEGER, zero_set_vertices INTEGER,
  tets INTEGER, largest_error, smallest_height, seconds, delta BLOB);
-- S: the samples of the boundary, in the order in which they were used.
CREATE TABLE sample_sets(id INTEGER PRIMARY KEY, samples INTEGER, sigma, data BLOB);
-- The parameters in force from a step on; lengths are absolute.
CREATE TABLE criteria(id INTEGER PRIMARY KEY, step INTEGER, delta, sigma, alpha, shrink, certified INTEGER,
  condition_1 INTEGER, condition_2 INTEGER, condition_3 INTEGER, condition_4 INTEGER);
CREATE TABLE texts(id INTEGER PRIMARY KEY, text TEXT);
-- Collapses with repair: one row each, and one row a sweep. worst_facet: nine coordinates.
CREATE TABLE repairs(id INTEGER PRIMARY KEY, sweeps INTEGER);
CREATE TABLE sweeps(repair INTEGER, sweep INTEGER, largest_distance, energy, moved INTEGER, flipped INTEGER,
  points_added INTEGER, distance_left, worst_facet BLOB, PRIMARY KEY(repair, sweep)) WITHOUT ROWID;
CREATE TABLE stage_marks(id INTEGER PRIMARY KEY, event INTEGER, seconds);
-- How far each commit went, and the checksum of everything up to there.
CREATE TABLE commits(id INTEGER PRIMARY KEY, events INTEGER, operations INTEGER, texts INTEGER, repairs INTEGER,
  sample_sets INTEGER, criteria INTEGER, marks INTEGER, checksum TEXT);
-- How the run ended; absent, or of fewer events than there are: it did not.
CREATE TABLE ending(id INTEGER PRIMARY KEY, events INTEGER, state TEXT, certified INTEGER, report TEXT);
-- The events with words instead of numbers: SELECT reason, count(*) FROM events GROUP BY reason;
CREATE VIEW events AS SELECT e.id, e.step, k.name AS kind, s.name AS stage, c.name AS condition,
  r.name AS reason, e.operation, e.tet, e.sample, e.vertex, e.other, e.x, e.y, e.z, e.witness_x, e.witness_y,
  e.witness_z, e.value, e.limit_value, e.count, t.text, e.detail AS repair, e.facet_a, e.facet_b, e.facet_c
  FROM event_rows e JOIN kinds k ON k.id = e.kind JOIN stages s ON s.id = e.stage
  JOIN conditions c ON c.id = e.condition JOIN reasons r ON r.id = e.reason
  LEFT JOIN texts t ON t.id = e.text AND e.text > 0;
)sql";

void add_to(Digest& digest, const Journal::ParameterRecord& record) {
  const CriteriaParameters& c = record.criteria;
  digest.add(record.step);
  for (const double value : {c.delta, c.sigma, c.alpha, c.shrink}) digest.add(value);
  for (const bool on : {c.certified, c.condition_1, c.condition_2, c.condition_3, c.condition_4})
    digest.add(on);
}

void add_to(Digest& digest, const Journal::StageMark& mark) {
  digest.add(mark.event);
  digest.add(mark.seconds);
}

void add_to(Digest& digest, const StepFigures& figures) {
  digest.add(figures.bad_samples);
  digest.add(figures.zero_set_vertices);
  digest.add(figures.tets);
  for (const float value : {figures.largest_error, figures.smallest_height, figures.seconds})
    digest.add(static_cast<double>(value));
}

std::uint64_t digest(const TriangleSoup& soup) {
  Digest d;
  if (soup.grid) {
    for (const std::size_t n : soup.grid->size) d.add(n);
    d.add(soup.grid->origin);
    d.add(soup.grid->spacing);
    for (const float v : soup.grid->values) d.add(static_cast<double>(v));
    return d.value();
  }
  if (soup.outer_triangles > 0) d.add(soup.outer_triangles);
  for (const Vec3& p : soup.points) d.add(p);
  for (const auto& t : soup.triangles)
    for (const std::uint32_t v : t) d.add(v);
  return d.value();
}

} // namespace isoscope
