// Chooses the kind of field by the input.
#include "run/make_field.h"

#include "tolerance/index_building.h"

namespace isoscope {

Result<FieldInput> make_field(const std::shared_ptr<const TriangleSoup>& input,
                              const RunParameters& parameters, const RunControl& control) {
  FieldInput made;
  made.field = build_index(*input, control);
  if (!control.cancelled()) made.topology = analyse_input(*input, parameters.sides, control);
  return made;
}

} // namespace isoscope
