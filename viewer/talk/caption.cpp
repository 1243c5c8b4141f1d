// What is said of the step shown: what happened, and why it matters.
#include "talk/talk.h"

#include "journal/describe.h"
#include "model/words.h"
#include "talk/meaning.h"

namespace isoscope {
namespace {

constexpr std::uint32_t fewest_alike = 3; ///< operations that are told as one

/// "simplifying Z: 37 edges have collapsed in a row, Z has 412 vertices"; empty for what does not add up.
std::string summed_up(const Event& e, std::uint32_t n, const StateSnapshot& state) {
  const std::string stage = std::string(words(e.stage).plain) + ": ";
  const std::string left = ", Z has " + grouped(state.zero_set.vertices.size()) + " vertices";
  switch (e.kind) {
  case EventKind::insertion:
    return stage + grouped(n) + " points in a row went in for " + std::string(words(e.condition).cause) +
           "; " + grouped(state.bad_samples) + " samples are bad";
  case EventKind::collapse:
    return stage + grouped(n) + " edges in a row have collapsed" + left;
  case EventKind::repair:
    return stage + grouped(n) + " edges in a row have collapsed with repair" + left;
  default:
    return {};
  }
}

} // namespace

const Event* Talk::caption_event() const {
  const auto shown = window.state();
  const auto chosen = window.selection.event ? window.selected_event() : std::nullopt;
  if (chosen) return &window.run.journal->events()[*chosen];
  if (const TalkMoment* told = moment(); told != nullptr && shown)
    return &moments_.journal()->events()[told->event];
  return shown && shown->event ? &*shown->event : nullptr;
}

std::uint32_t Talk::alike() const {
  const JournalIndex& index = window.index;
  const auto shown = window.state();
  if (!shown || shown->step == 0 || shown->step > index.steps()) return 0;
  const Step last = shown->step - 1;
  std::uint32_t n = 0;
  for (Step at = last + 1; at-- > 0 && index.kind(at) == index.kind(last) &&
                           index.stage(at) == index.stage(last) &&
                           index.condition(at) == index.condition(last);)
    ++n;
  return n;
}

std::string Talk::caption() const {
  const auto shown = window.state();
  if (!shown || !window.run.journal)
    return window.running() ? "the model is being prepared" : "no model is open";
  const Event* event = caption_event();
  const bool in_t = window.run.parameters.start == FirstZ::delaunay;
  if (event == nullptr && !in_t) return "both boundaries of Ω, before the first Z is there";
  if (event == nullptr) return "samples on both boundaries of Ω, before there is a T";
  if (shown->event && event == &*shown->event)
    if (const std::uint32_t n = alike(); n >= fewest_alike)
      if (std::string all = summed_up(*event, n, *shown); !all.empty()) return all;
  if (event->stage == Stage::setup && event->operation) return "set-up: T begins as a box around the samples";
  return plain_words(*window.run.journal, *event);
}

std::string Talk::caption_why() const {
  if (!window.state() || !window.run.journal) return {};
  const Event* event = caption_event();
  if (event == nullptr && window.run.parameters.start != FirstZ::delaunay) return "Z begins next, without T.";
  if (event == nullptr) return "Both boundaries of Ω have their samples; T comes next, as a box around them.";
  return std::string(meaning(*event));
}

std::string Talk::caption_figure() const {
  if (!window.state() || !window.run.journal) return {};
  const Event* event = caption_event();
  return std::string(event == nullptr ? figure_of(Stage::setup) : figure_of(*event));
}

} // namespace isoscope
