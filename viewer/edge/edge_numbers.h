// Kernel, candidates and cost of the edge under the X-ray, and what the search left out.
#pragma once

#include "questions/target_study.h"
#include "ui/ui.h"

#include <string>

namespace isoscope::panels {

/// The number of a check beside its limit, in short: "0.97 / 1 δ".
std::string check_text(CollapseCheck check, const CheckVerdict& verdict, const CollapseAttempt& attempt,
                       double delta);
/// Bars of the candidates by reason, and the list of them: hovering one shows its ghost.
void candidates(Ui& ui, const EdgeXray& xray);
/// What the search left out, Ψ and cells of the octree, with switches of the view: a legend in words.
void search_regions(Ui& ui, const EdgeXray& xray);
/// The half-spaces and the polyhedron; the slider that pushes the planes of an empty one.
void kernel(Ui& ui, const EdgeXray& xray);
/// What the constraints cost, at the target or where one is tried.
void cost(Ui& ui, const EdgeXray& xray, const TargetStudy* study);

} // namespace isoscope::panels
