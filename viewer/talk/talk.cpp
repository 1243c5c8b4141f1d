// Keeping the bookmarks of the run that is open, and staying at its moments.
#include "talk/talk.h"

#include <utility>

namespace isoscope {
namespace {

/// The first steps change the picture most: they can be followed one by one.
constexpr Step slow_steps = 30;
constexpr double slow_speed = 2; ///< steps a second

} // namespace

void Talk::update() {
  if (window.shows_recording() && window.run.recording->file != recording_) fetch_bookmarks();
  if (moments_.journal() != window.run.journal) {
    moments_.reset(window.run.journal);
    turned_.reset();
    dwelled_.reset();
  }
  moments_.update();
  const Presenter& p = window.presenter;
  const bool slowly = p.on && p.slow_down;
  Transport& transport = window.transport;
  transport.dwell_at(slowly ? moments_.steps() : std::span<const Step>());
  transport.slow_before(slowly ? slow_steps : 0, slow_speed);
  if (turned_ && (transport.moving() || transport.step() != moments_.all()[*turned_].step)) turned_.reset();
  // What a moment is about is selected as long as playing stays at it.
  const auto dwelling = slowly ? transport.dwelling() : std::nullopt;
  if (dwelling == dwelled_) return;
  if (dwelling || transport.moving()) window.selection.pick({});
  if (dwelling)
    show_moment(moments_.all()[*dwelling]);
  else if (!transport.moving())
    turned_ = dwelled_; // held there, or at the end
  dwelled_ = dwelling;
}

const TalkMoment* Talk::moment() const {
  const auto at = window.transport.dwelling();
  const auto which = at ? at : turned_;
  if (!which || *which >= moments_.all().size()) return nullptr;
  const TalkMoment& found = moments_.all()[*which];
  return found.step == window.transport.step() ? &found : nullptr;
}

void Talk::show_moment(const TalkMoment& moment) {
  const Event& e = moments_.journal()->events()[moment.event];
  Pick pick;
  if (e.kind == EventKind::rejection && e.vertex.valid() && e.other.valid())
    pick = {Pick::Kind::edge, e.vertex.value, e.witness, e.other.value};
  else if (e.operation && moment.step == e.step && e.tet.valid())
    pick = {Pick::Kind::tet, e.tet.value, e.witness};
  window.selection.pick(pick);
  if (e.kind == EventKind::rejection) window.selection.event = moment.event;
}

void Talk::turn_to_moment(int direction) {
  const auto& all = moments_.all();
  const Step step = window.transport.step();
  const Moments::Range here = moments_.at(step);
  std::size_t next = direction > 0 ? here.end : here.begin;
  if (turned_)
    next = *turned_ + (direction > 0 ? 1 : 0);
  else if (window.transport.step() == 0 && direction > 0)
    next = here.begin;
  if (direction < 0) --next; // past the first one is behind the last one
  turned_.reset();
  window.selection.pick({});
  if (next < all.size()) {
    turned_ = next;
    window.transport.jump(all[next].step);
    show_moment(all[next]);
  } else {
    window.transport.jump(direction > 0 ? window.live_step() : 0);
  }
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

} // namespace isoscope
