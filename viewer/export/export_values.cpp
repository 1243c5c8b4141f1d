// What scripts can expect of pictures, figures and films, and the memory of the history.
#include "command/named_table.h"

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
    return "unsupported";
  case ErrorCode::cancelled:
    return "cancelled";
  case ErrorCode::internal:
    break;
  }
  return "internal";
}

} // namespace

void add_export_values(NamedTable& t) {
  const auto count = [&](const char* name, const char* help, auto get) {
    t.push_back({name, help, [get](const AppModel& m) { return std::to_string(get(m)); }, nullptr});
  };
  count("export.pictures", "pictures written", [](const AppModel& m) { return m.exports.pictures; });
  count("export.figures", "sections written as SVG", [](const AppModel& m) { return m.exports.figures; });
  count("export.frames", "frames of sequences written", [](const AppModel& m) { return m.exports.frames; });
  count("export.films", "films made", [](const AppModel& m) { return m.exports.films; });
  t.push_back({"export.error", "of the last export: none or what kind of error",
               [](const AppModel& m) {
                 return std::string(m.exports.error ? error_word(m.exports.error->code) : "none");
               },
               nullptr});
  count("history.disk", "bytes of the journal that are on the disk",
        [](const AppModel& m) { return m.history_memory().disk; });
  count("history.bytes", "bytes of journal and keyframes in memory",
        [](const AppModel& m) { return m.history_memory().bytes(); });
  count("history.journal", "bytes of the journal in memory",
        [](const AppModel& m) { return m.history_memory().journal; });
  count("history.keyframes", "bytes of the keyframes",
        [](const AppModel& m) { return m.history_memory().keyframes; });
  t.push_back({"history.limit", "what journal and keyframes may take together, MiB, 1 to 1048576",
               [](const AppModel& m) { return text_of(m.settings.history_limit); },
               [](AppModel& m, const std::string& text) -> Status {
                 const auto value = parse_number(text);
                 if (!value) return value.error();
                 if (*value < 1 || *value > 1048576)
                   return Error{ErrorCode::usage, "\"" + text + "\" is no limit of the history.",
                                "It lies between 1 and 1048576 MiB."};
                 m.settings.history_limit = *value;
                 return {};
               }});
}

} // namespace isoscope
