// The questions about the state shown that take longer than a frame, each with a worker of its own, and what
// their answers draw.
#pragma once

#include "command/commands.h"
#include "command/named_values.h"
#include "journal/history.h"
#include "model/window_state.h"
#include "model/worker.h"
#include "questions/edge_advice.h"
#include "questions/element_questions.h"
#include "questions/point_questions.h"
#include "questions/refused_facet.h"
#include "questions/rim_questions.h"
#include "questions/state_check.h"
#include "questions/topology_report.h"
#include "questions/work_map.h"
#include "scene/annotation.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace isoscope {

struct Ui;
class Debugger;
class EdgeProbe;

/// Which list "next violation" walks through.
enum class ViolationKind : std::uint8_t { misoriented, flat };

struct HistoryQuestion {
  std::shared_ptr<const Journal> journal;
  ElementRef element;
  std::shared_ptr<const StateSnapshot> state;
  bool last_only = false; ///< the last class change of a sample before the state, and nothing else
};
struct WorkQuestion {
  std::shared_ptr<const Journal> journal;
  std::size_t begin = 0, end = 0; ///< events of the map and of the times
  std::size_t stall_end = 0;      ///< the event before which attempts are looked at
  WorkKind kind = WorkKind::attempts;
  std::size_t attempts = 500;
  double cell = 0;
};
struct WorkAnswer {
  WorkMap map;
  StallReport stall;
  std::vector<WorkTime> times;
};
struct TopologyQuestion {
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const Scene> scene;
};
struct AdviceQuestion {
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const Journal> journal;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const SampleIndex> index;
  RunParameters parameters;
  ElementRef element;
};
struct CheckQuestion {
  std::shared_ptr<const Journal> journal;
  std::shared_ptr<const StateSnapshot> state;
  std::shared_ptr<const Scene> scene;
  bool search = false; ///< bisect up to the state's step
};
struct CheckAnswer {
  StateReport report;
  std::optional<FirstInvalid> first;
};
using Advice = std::vector<ParameterAdvice>;

/// Methods are for one thread, the window's.
class Investigation {
 public:
  Investigation(WindowState& shared, const std::function<void()>& notify);
  ~Investigation();

  WindowState& window;

  // What is asked; panels, commands and scripts set it.
  ViolationKind violations = ViolationKind::misoriented;
  std::optional<double> shrink; ///< of the copy that is drawn; absent: condition 3's
  WorkKind work_kind = WorkKind::attempts;
  std::size_t stall_attempts = 500;
  double cell_deltas = 1;           ///< size of the heat map's cells in δ
  bool edge_advice = false;         ///< also ask the evaluator of edges over values: it takes a while
  bool topology_shown = false;      ///< follow the state shown
  std::vector<Segment3> loop_shown; ///< a loop of the rim that is looked at, marked while holes are listed

  /// Once a frame: asks what is shown and stale. True while something is under way.
  bool update();
  void ask_check(bool search);
  void stop_check() { check_.stop(); }
  /// Begins the end of all that is asked, and waits for nothing.
  void abandon();
  /// Goes to the last change of the selected element as soon as it is known.
  void want_last_change() { jump_ = true; }
  bool idle() const;

  // Answers to what is asked now; null while they are made.
  std::shared_ptr<const ElementHistory> history() const { return history_; }
  std::shared_ptr<const WorkAnswer> work() const { return work_; }
  std::shared_ptr<const TopologyReport> topology() const { return topology_; }
  std::shared_ptr<const Advice> advice() const { return advice_; }
  /// Of the selected point of the input.
  std::shared_ptr<const PointInspection> point() const { return point_; }
  /// Of the selected sample or boundary sample, where the input has an open rim.
  const std::optional<RimInspection>& beside_rim() const { return beside_rim_; }
  /// The loops of the rim at the state shown.
  const std::optional<RimReport>& rim_report();
  /// Of the step that was checked last, whichever is shown.
  std::shared_ptr<const CheckAnswer> check() const;
  bool checking() const { return !check_.idle(); }
  double check_fraction() const { return check_.fraction(); }
  std::shared_ptr<const Annotation> annotation() const { return annotation_; }

  /// The tetrahedra around a vertex: how many, and the first of them. Counted once for a state.
  struct VertexStar {
    std::shared_ptr<const StateSnapshot> state;
    VertexId vertex;
    std::size_t degree = 0;
    std::optional<TetId> first;
  };
  const VertexStar& star_of(const std::shared_ptr<const StateSnapshot>& state, VertexId vertex);

  void add_commands(CommandTable& table);
  void add_rim_commands(CommandTable& table);
  void add_values(NamedValues& values);
  void add_rim_values(NamedValues& values);

 private:
  void update_history();
  void update_work();
  void update_topology();
  void update_advice();
  void update_point();
  void update_rim();
  void jump();
  void annotate();
  /// The lines and marks for the state shown and the answers there are.
  Annotation make_annotation() const;

  Worker<HistoryQuestion, ElementHistory> history_worker_;
  Worker<WorkQuestion, WorkAnswer> work_worker_;
  Worker<TopologyQuestion, TopologyReport> topology_worker_;
  Worker<AdviceQuestion, Advice> advice_worker_;
  Worker<CheckQuestion, CheckAnswer> check_;
  std::optional<HistoryQuestion> history_asked_;
  std::shared_ptr<const void> asked_at_; ///< the answer before the present question
  std::optional<WorkQuestion> work_asked_;
  std::optional<TopologyQuestion> topology_asked_;
  std::optional<AdviceQuestion> advice_asked_;
  std::shared_ptr<const Journal> check_journal_;
  VertexStar star_;
  std::shared_ptr<const ElementHistory> history_;
  std::shared_ptr<const WorkAnswer> work_;
  std::shared_ptr<const TopologyReport> topology_;
  std::shared_ptr<const Advice> advice_;
  std::shared_ptr<const PointInspection> point_;
  std::shared_ptr<const Scene> point_scene_; ///< and the point, for which that was found
  std::uint32_t point_id_ = 0;
  std::optional<RimInspection> beside_rim_;
  std::shared_ptr<const Scene> rim_scene_; ///< and the place, for which that was found
  std::optional<Vec3> rim_place_;
  std::optional<RimReport> rim_report_;
  std::shared_ptr<const StateSnapshot> reported_state_; ///< for which that was made
  std::shared_ptr<const Annotation> annotation_;
  struct AnnotationKey;
  std::unique_ptr<AnnotationKey> annotated_;
  bool jump_ = false;
};

/// The selected element as histories and advice know it; nothing for facets and without selection.
std::optional<ElementRef> selected_element(const Selection& selection);
/// The facet that the selected event of the improver left above δ; stepping through its sweeps, the worst one
/// after the sweep shown.
std::optional<RefusedFacet> shown_refusal(const WindowState& window);
/// The violations of the kind looked at, in the order in which "next" goes through them.
std::vector<TetId> violating_tets(const StateSnapshot& state, ViolationKind kind);
/// A row of a history in words: "absorbed vertex 12".
std::string history_words(const HistoryRow& row, ElementRef::Kind kind);

namespace panels {

/// The bottom tab with the history of the selected element.
void history_tab(Ui& ui, const Investigation& asked);
/// The bottom tab that tells where the work goes.
void work_tab(Ui& ui, Investigation& asked);
/// Everything about the picked element.
void inspector(Ui& ui, EdgeProbe& probe, const Debugger& debugger, Investigation& asked);
/// Violations, topology, validity.
void state_questions(Ui& ui, Investigation& asked, const StateSnapshot& state);
/// Under a tetrahedron: next and previous violation, the factor of the copy that is drawn, what goes in.
void tet_questions(Ui& ui, Investigation& asked, const StateSnapshot& state, std::uint32_t id);
/// Under a sample: who mends it.
void sample_questions(Ui& ui, const StateSnapshot& state, std::uint32_t id);
/// A point of the input: its neighbours, their mean and weight, its ball, and why it was dropped.
void point_details(Ui& ui, const Investigation& asked, std::uint32_t id);
/// A boundary sample: what of the rim it is over.
void over_rim_details(Ui& ui, const Investigation& asked, const StateSnapshot& state, std::uint32_t id);
/// Under a sample of an open input: where it lies beside the rim.
void rim_rows(Ui& ui, const Investigation& asked);
/// The bottom tab with the loops of the rim: which holes are kept and which are filled.
void loops_tab(Ui& ui, Investigation& asked);
/// What is known of all points, under the summary of a step.
void points_summary(Ui& ui);
/// At the end of the run: what is proven of its mesh.
void certificate(Ui& ui);
/// The distances of the points to the finished mesh.
void point_distances(Ui& ui, const RunResult& result, double delta);
/// Under tetrahedra, samples and edges: which parameters would change the verdict.
void advice(Ui& ui, const Investigation& asked);
/// Buttons for the history and the last change of the selection.
void history_buttons(Ui& ui);

} // namespace panels

} // namespace isoscope
