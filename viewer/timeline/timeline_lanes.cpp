// Which lanes there are.
#include "timeline/timeline_lanes.h"

#include "debug/event_list.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "timeline/loop_lanes.h"

#include <algorithm>
#include <iterator>

namespace isoscope {
namespace {

/// The kinds that have a lane, from above.
constexpr std::array kinds{EventKind::split, EventKind::collapse, EventKind::relaxation, EventKind::repair,
                           EventKind::shake};

} // namespace

std::vector<TimelineLane> timeline_lanes(const Debugger& debugger, ThemeKind theme, std::size_t most) {
  const JournalIndex& index = debugger.window.index;
  const auto& range = debugger.window.range;
  const Step begin = range ? range->begin : 0;
  // Rejections after the last operation have a step of their own.
  const Step end = range ? std::min(range->end, index.steps()) + 1 : index.steps() + 1;
  const Step operations_end = std::max(begin, std::min(end, index.steps()));
  std::vector<TimelineLane> filters;
  for (std::size_t i = 0; i < debugger.lanes.size(); ++i) {
    const FilteredEvents& lane = debugger.lanes[i];
    filters.push_back({"filter-" + std::to_string(i + 1),
                       debugger.window.settings.filters[i],
                       "A saved filter of the events.",
                       lane_color(i),
                       MarkerShape::square,
                       true,
                       lane.count(begin, end),
                       {{lane_color(i), [&lane](Step a, Step b) { return lane.count(a, b); }}},
                       lane_letter(i)});
  }
  std::vector<TimelineLane> lanes;
  const auto conditions = index.counts(std::min(begin, index.steps()), operations_end);
  for (std::size_t c = 1; c < conditions.size(); ++c)
    lanes.push_back({std::string(name(static_cast<Condition>(c))),
                     std::string(words(static_cast<Condition>(c)).title),
                     "Points inserted for this condition. §2.3",
                     condition_color(theme, static_cast<int>(c)),
                     MarkerShape::square,
                     false,
                     conditions[c],
                     {{condition_color(theme, static_cast<int>(c)),
                       [&index, c](Step a, Step b) { return index.counts(a, b)[c]; }}},
                     {}});
  for (const EventKind kind : kinds) {
    const KindWords& k = words(kind);
    lanes.push_back({std::string(k.name),
                     std::string(k.title),
                     k.help,
                     k.color,
                     k.shape,
                     false,
                     index.count(kind, begin, operations_end),
                     {{k.color, [&index, kind](Step a, Step b) { return index.count(kind, a, b); }}},
                     {}});
  }
  for (const Reason reason : rejecting_reasons) {
    const ReasonWords& style = words(reason);
    lanes.push_back(
        {std::string(style.name),
         std::string(style.title),
         style.help,
         style.color,
         style.shape,
         true,
         index.rejections(reason, begin, end),
         {{style.color, [&index, reason](Step a, Step b) { return index.rejections(reason, a, b); }}},
         {}});
  }
  std::erase_if(lanes, [](const TimelineLane& lane) { return lane.total == 0; });
  constexpr std::size_t share_of_loops = 3; ///< the part of the room that loops keep
  most -= std::min(most, filters.size());
  const std::size_t left = most - std::min(most, lanes.size());
  std::vector<TimelineLane> loops =
      loop_lanes(debugger, theme, std::max(left, most / share_of_loops), begin, operations_end);
  most -= std::min(most, loops.size());
  while (lanes.size() > most && !lanes.empty())
    lanes.erase(
        std::min_element(lanes.begin(), lanes.end(),
                         [](const TimelineLane& a, const TimelineLane& b) { return a.total < b.total; }));
  for (auto* more : {&lanes, &loops})
    filters.insert(filters.end(), std::make_move_iterator(more->begin()),
                   std::make_move_iterator(more->end()));
  return filters;
}

} // namespace isoscope
