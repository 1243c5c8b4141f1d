// Applies operations to T and writes them to the journal with their figures.
#include "refine/context.h"

#include "base/snap.h"
#include "refine/loose_box.h"

namespace isoscope {
namespace {

/// Vertices keep this fraction of δ apart, so that packing bounds their number.
constexpr double spacing_ratio = 0.005;

} // namespace

RefinementContext::RefinementContext(ToleranceVolume& volume, SearchedSamples samples,
                                     const CriteriaParameters& criteria, Recorder& recorder,
                                     const RunControl& control)
    : volume_(volume), live_(samples.samples), samples_(std::move(samples)), criteria_(criteria),
      recorder_(recorder), control_(control) {
  live_.set_delta(volume.thresholds().delta);
}

void RefinementContext::set_criteria(const CriteriaParameters& criteria) {
  criteria_ = criteria;
  recorder_.journal().add_parameters(criteria);
  Event event;
  event.kind = EventKind::parameter_change;
  note(event);
  requeue_all();
}

Vec3 RefinementContext::snapped(Vec3 p) const {
  return isoscope::snapped(p, samples_.samples->snap_unit);
}

Vertex RefinementContext::free_vertex(Vec3 p, int label, VertexKind kind) const {
  Vertex vertex;
  vertex.position = snapped(p);
  vertex.value = label > 0 ? +1 : -1;
  vertex.room = room_of(label);
  vertex.kind = kind;
  return vertex;
}

Vertex RefinementContext::sample_vertex(SampleId s) const {
  Vertex vertex;
  vertex.position = samples_.samples->positions[s.index()];
  const std::int8_t label = samples_.samples->labels[s.index()];
  vertex.value = label > 0 ? +1 : -1;
  vertex.room = room_of(label);
  vertex.kind = VertexKind::sample;
  vertex.sample_set = live_.sample_set();
  vertex.sample = s;
  return vertex;
}

double RefinementContext::spacing(Vec3 p, TetId hint) const {
  return distance(p, live_.complex().position(live_.delaunay().nearest_vertex(p, hint)));
}

double RefinementContext::smallest_spacing() const {
  return spacing_ratio * volume_.thresholds().delta;
}

void RefinementContext::start() {
  std::vector<Vertex> corners = loose_box_corners(volume_, *samples_.samples);
  Delta delta = live_.start(corners);
  hint_ = live_.changed().empty() ? TetId() : live_.changed().front();
  update_checklists();
  Event event;
  event.kind = EventKind::insertion;
  event.stage = Stage::setup;
  event.operation = true;
  event.count = static_cast<std::uint32_t>(corners.size());
  hear(recorder_.operation(event, std::move(delta), figures()));
}

bool RefinementContext::insert(const Vertex& vertex, TetId hint, Event event) {
  std::optional<Delta> delta = live_.insert(vertex, live_.alive(hint) ? hint : hint_);
  if (!delta) return false;
  hint_ = live_.changed().front();
  update_checklists();
  ++insertions_[static_cast<std::size_t>(event.condition)];
  event.kind = EventKind::insertion;
  event.operation = true;
  event.point = vertex.position;
  event.sample = vertex.sample;
  event.vertex = VertexId(live_.complex().vertices.size() - 1);
  hear(recorder_.operation(event, std::move(*delta), figures()));
  return true;
}

void RefinementContext::relabel(std::span<const VertexId> vertices, Event event) {
  Delta delta = live_.relabel(vertices);
  update_checklists();
  event.kind = EventKind::relabel;
  event.operation = true;
  hear(recorder_.operation(event, std::move(delta), figures()));
}

void RefinementContext::replace_samples(std::shared_ptr<const BoundarySamples> samples) {
  const std::uint16_t set = recorder_.journal().add_sample_set(samples);
  samples_ = SearchedSamples(std::move(samples));
  Delta delta = live_.replace_samples(samples_.samples, set);
  criteria_.sigma = samples_.samples->sigma;
  recorder_.journal().add_parameters(criteria_);
  requeue_all();
  Event event;
  event.kind = EventKind::parameter_change;
  event.operation = true;
  event.value = samples_.samples->sigma;
  hear(recorder_.operation(event, std::move(delta), figures()));
}

void RefinementContext::note(Event event) {
  hear(recorder_.event(event));
}

void RefinementContext::warn(std::string text, EventKind kind) {
  Event event;
  event.kind = kind;
  event.text = recorder_.journal().add_text(std::move(text));
  note(event);
}

void RefinementContext::update_checklists() {
  for (Checklist* checklist : checklists_) {
    for (const TetId t : live_.gone()) checklist->forget(t);
    for (const TetId t : live_.changed()) {
      checklist->forget(t);
      if (live_.heterogeneous(t)) checklist->add(t);
    }
  }
}

void RefinementContext::requeue_all() {
  for (Checklist* checklist : checklists_) {
    checklist->clear();
    for (std::uint32_t i = 0; i < live_.complex().tets.size(); ++i) {
      if (live_.alive(TetId(i)) && live_.heterogeneous(TetId(i))) checklist->add(TetId(i));
    }
  }
}

void RefinementContext::hear(Gate::Verdict verdict) {
  if (verdict_ == Gate::Verdict::stop || verdict == Gate::Verdict::go_on) return;
  verdict_ = verdict;
}

Gate::Verdict RefinementContext::take_verdict() {
  return std::exchange(verdict_, Gate::Verdict::go_on);
}

StepFigures RefinementContext::figures() {
  StepFigures figures = live_.step_figures();
  // A run that follows another one has its clock.
  if (const Rehearsal* ahead = recorder_.rehearsal(); ahead != nullptr && ahead->event().operation)
    began_ =
        std::chrono::steady_clock::now() - std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                               std::chrono::duration<double>(ahead->seconds()));
  figures.seconds = std::chrono::duration<float>(std::chrono::steady_clock::now() - began_).count();
  return figures;
}

} // namespace isoscope
