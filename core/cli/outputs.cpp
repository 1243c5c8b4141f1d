// Tries each output's folder, since a run of an hour must not end at a missing one.
#include "cli/outputs.h"

#include "base/pending_file.h"
#include "input/mesh_io.h"
#include "run/report.h"

#include <cstdio>
#include <filesystem>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

bool same_file(const std::string& a, const std::string& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code failure;
  if (fs::equivalent(a, b, failure)) return true;
  return fs::weakly_canonical(behind_links(a), failure) == fs::weakly_canonical(behind_links(b), failure);
}

Error clash(const std::string& option, const std::string& file, const std::string& what) {
  return {ErrorCode::usage, option + " " + file + " is " + what + ".", "Give another file."};
}

Status check_writable(const std::string& file) {
  std::error_code failure;
  if (fs::is_directory(file, failure)) {
    return Error{ErrorCode::io, "Cannot write " + file + ": it is a folder.", "Give a file in it."};
  }
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure)) return {}; // a device or a pipe
  const std::string probe = behind_links(file).string() + ".probe";
  if (!write_text_file(probe, "").ok()) {
    return Error{ErrorCode::io, "Cannot write " + file + ": its folder is missing or not writable.",
                 "Make the folder, or give another file."};
  }
  std::remove(probe.c_str());
  return {};
}

} // namespace

Status check_outputs(const Outputs& outputs, const std::string& input) {
  if (!outputs.recording.empty()) {
    if (same_file(outputs.recording, input)) return clash("--record", outputs.recording, "the input itself");
    if (same_file(outputs.recording, outputs.mesh))
      return clash("--record", outputs.recording, "the mesh of -o too");
    if (same_file(outputs.recording, outputs.report))
      return clash("--record", outputs.recording, "the report too");
  }
  if (!outputs.mesh.empty()) {
    if (same_file(outputs.mesh, input)) return clash("-o", outputs.mesh, "the input itself");
    if (Status s = check_writable_mesh(outputs.mesh); !s) return s;
  }
  if (outputs.report.empty() || outputs.report == "-") return {};
  if (same_file(outputs.report, input)) return clash("--report", outputs.report, "the input itself");
  if (same_file(outputs.report, outputs.mesh)) return clash("--report", outputs.report, "the mesh of -o too");
  return check_writable(outputs.report);
}

} // namespace isoscope
