// The fields by their names.
#include "run/parameters_json.h"

#include "base/fields_json.h"

namespace isoscope {

std::string parameters_json(const RunParameters& p) {
  return fields_json(p).dump(-1, ' ', false, FieldJson::error_handler_t::replace);
}

Result<RunParameters> parse_parameters(std::string_view text) {
  RunParameters parameters;
  try {
    read_fields(FieldJson::parse(text), parameters);
  } catch (const FieldJson::exception&) {
    return Error{ErrorCode::bad_input, "The parameters of the recording cannot be read.",
                 "The file is damaged; record the run again."};
  }
  if (Status valid = check(parameters); !valid)
    return Error{ErrorCode::bad_input,
                 "The parameters of the recording make no sense. " + valid.error().message,
                 "The file is damaged; record the run again."};
  return parameters;
}

} // namespace isoscope
