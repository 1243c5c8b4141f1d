// What scripts can expect of pictures, figures and films.
#include "export/exports.h"

namespace isoscope {

namespace {

std::string_view error_word(ErrorCode code) {
  switch (code) {
  case ErrorCode::io:
    return "io";
  case ErrorCode::device:
    return "device";
  case ErrorCode::usage:
    return "usage";
  case ErrorCode::bad_input:
    return "bad-input";
  case ErrorCode::unsupported:
  case ErrorCode::open_surface:
  case ErrorCode::joined_sheets:
    return "unsupported";
  case ErrorCode::cancelled:
    return "cancelled";
  case ErrorCode::internal:
    break;
  }
  return "internal";
}

} // namespace

void Exports::add_values(NamedValues& t) {
  const auto count = [&](const char* name, const char* help, const std::size_t& number) {
    t.add(name, help, [&number] { return number; });
  };
  count("export.pictures", "pictures written", pictures);
  count("export.figures", "sections written as SVG", figures);
  count("export.frames", "frames of sequences written", frames);
  count("export.films", "films made", films);
  t.add("export.error", "of the last export: none or what kind of error",
        [this] { return error ? error_word(error->code) : "none"; });
}

} // namespace isoscope
