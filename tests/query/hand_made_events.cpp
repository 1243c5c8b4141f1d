// The short journal.
#include "query/hand_made_events.h"

namespace isoscope::test {

std::shared_ptr<Journal> hand_made_events() {
  auto journal = std::make_shared<Journal>();
  CriteriaParameters criteria;
  criteria.delta = 2;
  criteria.sigma = 0.5;
  journal->add_parameters(criteria);
  Event e;
  e.kind = EventKind::stage_begin;
  journal->add_event(e);

  e.kind = EventKind::insertion;
  e.condition = Condition::height;
  e.reason = Reason::circumcenter_sample;
  e.vertex = VertexId(8);
  e.sample = SampleId(41);
  e.tet = TetId(5);
  e.point = {1, 0, 0};
  e.value = 0.25;
  e.limit = 5;
  StepFigures figures;
  figures.smallest_height = 0.5f;
  figures.bad_samples = 12;
  figures.zero_set_vertices = 30;
  figures.seconds = 1;
  journal->add_operation(e, {}, figures);

  e.condition = Condition::classification;
  e.reason = Reason::largest_error;
  e.vertex = VertexId(9);
  e.sample = SampleId(42);
  e.point = {0, 4, 0};
  e.value = 1.5;
  e.limit = 0.8;
  figures.smallest_height = 3;
  figures.bad_samples = 0;
  figures.zero_set_vertices = 40;
  figures.seconds = 4;
  journal->add_operation(e, {}, figures);
  Event end;
  end.kind = EventKind::stage_end;
  journal->add_event(end);

  Event z;
  z.stage = Stage::zero_set;
  z.kind = EventKind::stage_begin;
  journal->add_event(z);
  z.kind = EventKind::rejection;
  z.reason = Reason::kernel_empty;
  z.vertex = VertexId(3);
  z.other = VertexId(9);
  z.value = 2;
  z.limit = 1;
  journal->add_event(z);
  z.reason = Reason::normals;
  z.other = VertexId(8);
  journal->add_event(z);
  Event collapse = z;
  collapse.kind = EventKind::collapse;
  collapse.reason = Reason::halfedge;
  collapse.vertex = VertexId(8);
  collapse.other = VertexId(9);
  collapse.value = 0.125;
  figures.zero_set_vertices = 39;
  figures.seconds = 0.5f;
  journal->add_operation(collapse, {}, figures);
  z.reason = Reason::kernel_empty;
  z.vertex = VertexId(9);
  z.other = VertexId(3);
  journal->add_event(z);
  z = {};
  z.stage = Stage::zero_set;
  z.kind = EventKind::stage_end;
  journal->add_event(z);
  return journal;
}

} // namespace isoscope::test
