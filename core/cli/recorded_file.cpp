// Commit by commit to the end.
#include "cli/recorded_file.h"

#include "run/parameters_json.h"

namespace isoscope {

Result<RecordedRun> read_recorded_run(const std::string& file) {
  auto opened = RecordingReader::open(file);
  if (!opened) return opened.error();
  RecordedRun r;
  r.reader = std::move(*opened);
  auto parameters = parse_parameters(r.reader->header().parameters);
  if (!parameters) return parameters.error();
  r.parameters = std::move(*parameters);
  for (;;) {
    const auto more = r.reader->read_commit(*r.journal);
    if (!more) return more.error();
    if (!*more) break;
  }
  auto end = r.reader->end();
  if (!end) return end.error();
  r.end = std::move(*end);
  return r;
}

} // namespace isoscope
