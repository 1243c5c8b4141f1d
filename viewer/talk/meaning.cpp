// What the tables of the vocabulary say for an audience.
#include "talk/meaning.h"

namespace isoscope {

std::string_view meaning(Stage stage) {
  return words(stage).why;
}

std::string_view meaning(const Event& e) {
  switch (e.kind) {
  case EventKind::insertion:
    return words(e.condition).why;
  case EventKind::rejection:
    return words(e.reason).why;
  case EventKind::stage_begin:
  case EventKind::collapse:
  case EventKind::tessellation:
    return meaning(e.stage);
  default:
    return words(e.kind).why;
  }
}

std::string_view figure_of(Stage stage) {
  return words(stage).figure;
}

std::string_view figure_of(const Event& e) {
  std::string_view own;
  if (e.kind == EventKind::insertion) own = words(e.condition).figure;
  if (e.kind == EventKind::rejection) own = words(e.reason).figure;
  if (own.empty()) own = words(e.kind).figure;
  return own.empty() ? figure_of(e.stage) : own;
}

} // namespace isoscope
