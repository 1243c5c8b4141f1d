// Keeping the bookmarks of the run that is open, and what is said of a step.
#include "talk/talk.h"

#include "journal/describe.h"

#include <utility>

namespace isoscope {

void Talk::update() {
  if (window.shows_recording() && window.run.recording->file != recording_) fetch_bookmarks();
  if (moments_.journal() != window.run.journal) moments_.reset(window.run.journal);
  moments_.update();
  const Presenter& p = window.presenter;
  window.transport.dwell_at(p.on && p.slow_down ? moments_.steps() : std::span<const Step>());
}

// A run that goes on with other parameters keeps the bookmarks it began with.
void Talk::fetch_bookmarks() {
  recording_ = window.shows_recording() ? window.run.recording->file : std::filesystem::path();
  files_ = bookmark_files(bookmarks_home, recording_, window.run.parameters);
  told_ = false;
  auto kept = kept_bookmarks(files_);
  if (!kept) window.report(kept.error());
  bookmarks = kept ? std::move(*kept) : Bookmarks();
}

void Talk::keep_bookmarks() {
  const auto file = isoscope::keep_bookmarks(files_, bookmarks, window.run.parameters);
  if (!file) return window.report(file.error());
  if (files_.beside.empty() || *file == files_.beside || std::exchange(told_, true)) return;
  window.tell("Nothing can be written beside the input: the bookmarks are kept in " + file->string() + ".");
}

const Event* Talk::caption_event() const {
  const auto shown = window.state();
  const auto chosen = window.selection.event ? window.selected_event() : std::nullopt;
  if (chosen) return &window.run.journal->events()[*chosen];
  return shown && shown->event ? &*shown->event : nullptr;
}

std::string Talk::caption() const {
  if (!window.state() || !window.run.journal)
    return window.running() ? "the model is being prepared" : "no model is open";
  if (const Event* event = caption_event()) return plain_words(*window.run.journal, *event);
  return "a box around the samples, before the first point goes in";
}

} // namespace isoscope
