// Chooses the kind of field by the input.
#include "run/make_field.h"

#include "tolerance/index_building.h"

namespace isoscope {

Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, std::optional<double> delta,
                              const RunControl& control) {
  FieldInput made;
  if (is_field_of_points(*input, parameters)) {
    made.points = make_point_field(input, parameters, delta, control);
    made.field = made.points.index;
    made.topology.side_rule = SideRule::depth;
    return made;
  }
  made.field = build_index(*input, control);
  if (!control.cancelled()) made.topology = analyse_input(*input, parameters.sides, control);
  return made;
}

} // namespace isoscope
