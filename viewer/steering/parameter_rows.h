// A row of the parameters: what is told beside its control, in the panel and in its foot.
#pragma once

#include "run/parameters.h"
#include "ui/ui.h"

#include <string>

namespace isoscope::panels {

/// A field of the draft beside the run's.
struct FieldState {
  bool differs = false;
  std::string used;  ///< what the run has, with its unit
  std::string error; ///< empty: the draft's value is in its range
};

template <class T>
FieldState field_state(const Field<RunParameters, T>& f, const RunParameters& draft,
                       const RunParameters& used) {
  FieldState state;
  state.differs = !(f.value(draft) == f.value(used));
  if (state.differs) state.used = field_told(f, f.value(used));
  if (const Status right = check_field(f, std::string(f.symbol), draft.*(f.member)); !right)
    state.error = right.error().message;
  return state;
}

/// The label on the left, `units` high: a dot where the draft is another value than the run's, which the
/// tooltip tells; red where it is out of its range.
void parameter_label(const Ui& ui, const FieldFacts& f, const FieldState& state, float units);
/// After the control, the last item: a red frame around a wrong one, and below what is wrong.
void parameter_verdict(const Ui& ui, const FieldState& state);
/// That frame alone, around the last item.
void wrong_value_frame(const Ui& ui);
/// The identifier of a control that has its label on the left.
std::string unlabelled(const FieldFacts& f);

} // namespace isoscope::panels
