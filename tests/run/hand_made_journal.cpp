// Events and operations one by one; deltas are empty, since statistics do not look at them.
#include "run/hand_made_journal.h"

namespace isoscope::test {

namespace {

class Writer {
 public:
  explicit Writer(Journal& journal) : journal_(&journal) {}
  void begin(Stage stage) {
    stage_ = stage;
    event(EventKind::stage_begin);
  }
  void end() { event(EventKind::stage_end); }
  void event(EventKind kind, Reason reason = Reason::none, RepairDetail sweeps = {}) {
    journal_->add_event(make(kind, reason, std::move(sweeps)));
  }
  /// An operation `seconds` after its stage began, that leaves so many vertices of Z.
  void operation(EventKind kind, Reason reason, double seconds, std::uint32_t vertices,
                 RepairDetail sweeps = {}) {
    Event e = make(kind, reason, std::move(sweeps));
    e.condition = kind == EventKind::insertion ? Condition::containment : Condition::none;
    StepFigures figures;
    figures.seconds = static_cast<float>(seconds);
    figures.zero_set_vertices = vertices;
    journal_->add_operation(e, {}, figures);
  }

 private:
  Event make(EventKind kind, Reason reason, RepairDetail sweeps) {
    Event e;
    e.kind = kind;
    e.stage = stage_;
    e.reason = reason;
    if (!sweeps.empty()) e.detail = journal_->add_repair(std::move(sweeps));
    return e;
  }
  Journal* journal_;
  Stage stage_ = Stage::setup;
};

} // namespace

std::shared_ptr<const Journal> hand_made_journal() {
  auto journal = std::make_shared<Journal>();
  Writer w(*journal);
  w.event(EventKind::warning);

  w.begin(Stage::refinement);
  for (int i = 1; i <= 4; ++i) w.operation(EventKind::insertion, Reason::projected, 16 * i, 300 * i);
  w.event(EventKind::exhausted, Reason::too_close);
  w.end();

  w.begin(Stage::gamma);
  w.operation(EventKind::collapse, Reason::halfedge, 8, 1100);
  w.event(EventKind::rejection, Reason::link_condition);
  w.event(EventKind::rejection, Reason::link_condition);
  w.event(EventKind::rejection, Reason::kernel_empty);
  w.operation(EventKind::collapse, Reason::sample_candidate, 16, 1000);
  w.end();

  w.begin(Stage::tessellation);
  w.operation(EventKind::tessellation, Reason::none, 32, 1000);
  w.end();

  // Nothing to collapse: as many vertices as before. Without an end no time is known, not even a little.
  w.begin(Stage::zero_set);
  w.event(EventKind::rejection, Reason::outside_tolerance);

  // Two rounds, each with a clock of its own.
  w.begin(Stage::all);
  w.operation(EventKind::collapse, Reason::quadric_optimum, 20, 900);
  w.operation(EventKind::collapse, Reason::lazy_constraints, 24, 800);
  w.end();
  w.begin(Stage::all);
  w.operation(EventKind::collapse, Reason::kernel_sampling, 8, 700);
  w.event(EventKind::rejection, Reason::unproven);
  w.end();

  w.begin(Stage::improve);
  w.operation(EventKind::departure, Reason::none, 1, 700);
  w.operation(EventKind::relaxation, Reason::none, 2, 700);
  w.operation(EventKind::repair, Reason::minimax_placement, 4, 699, RepairDetail(3));
  w.event(EventKind::rejection, Reason::stays_above, RepairDetail(12));
  w.event(EventKind::rejection, Reason::stays_above, RepairDetail(5));
  w.event(EventKind::rejection, Reason::folded);
  w.operation(EventKind::repair, Reason::minimax_placement, 8, 698, RepairDetail(2));
  w.operation(EventKind::relaxation, Reason::none, 16, 698);
  w.end();
  return journal;
}

} // namespace isoscope::test
