// Which lanes there are.
#include "timeline/timeline_lanes.h"

#include "debug/event_list.h"
#include "journal/vocabulary.h"
#include "model/words.h"
#include "timeline/loop_lanes.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace isoscope {
namespace {

/// The kinds that have a lane, from above.
constexpr std::array kinds{EventKind::split, EventKind::collapse, EventKind::relaxation, EventKind::repair,
                           EventKind::shake};

/// Moves those that `keeps` says no to behind `out`, in their order.
template <class Keeps>
void leave_out(std::vector<TimelineLane>& lanes, std::vector<TimelineLane>& out, Keeps keeps) {
  std::vector<TimelineLane> kept;
  for (std::size_t i = 0; i < lanes.size(); ++i) (keeps(i) ? kept : out).push_back(std::move(lanes[i]));
  lanes = std::move(kept);
}

/// The `most` with the largest numbers stay.
void keep_largest(std::vector<TimelineLane>& lanes, std::vector<TimelineLane>& out, std::size_t most) {
  std::vector<std::size_t> order(lanes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lanes[a].total > lanes[b].total; });
  order.resize(std::min(most, order.size()));
  leave_out(lanes, out,
            [&](std::size_t i) { return std::find(order.begin(), order.end(), i) != order.end(); });
}

std::uint32_t number_of(const TimelineLane& loop) {
  return loop_of_lane(loop.name).value_or(other_loops);
}

/// The `most` longest stay, by number, and the one that the others share where there is room for two.
void keep_longest(std::vector<TimelineLane>& loops, std::vector<TimelineLane>& out, std::size_t most) {
  const bool shared = most > 1 && !loops.empty() && number_of(loops.back()) == other_loops;
  const std::size_t longest = shared ? most - 1 : most, last = loops.size() - (shared ? 1 : 0);
  leave_out(loops, out, [&](std::size_t i) { return i < longest || i >= last; });
  for (auto* part : {&loops, &out})
    std::sort(part->begin(), part->end(),
              [](const TimelineLane& a, const TimelineLane& b) { return number_of(a) < number_of(b); });
}

void append(std::vector<TimelineLane>& to, std::vector<TimelineLane> more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

} // namespace

LanesInRoom timeline_lanes(const Debugger& debugger, ThemeKind theme, std::size_t rows) {
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
  std::vector<TimelineLane> loops = loop_lanes(debugger, theme, begin, operations_end);
  constexpr std::size_t share_of_loops = 3; ///< the part of the room that loops keep
  std::size_t most = rows - std::min(rows, filters.size());
  if (lanes.size() + loops.size() > most && most > 0) --most; // the sign that says so
  const std::size_t left = most - std::min(most, lanes.size());
  std::vector<TimelineLane> no_lane, no_loop;
  keep_longest(loops, no_loop, std::max(left, most / share_of_loops));
  keep_largest(lanes, no_lane, most - std::min(most, loops.size()));
  append(filters, std::move(lanes));
  append(filters, std::move(loops));
  append(no_lane, std::move(no_loop));
  return {std::move(filters), std::move(no_lane)};
}

std::string left_out_words(const std::vector<TimelineLane>& left_out) {
  const auto loops =
      static_cast<std::size_t>(std::count_if(left_out.begin(), left_out.end(), [](const TimelineLane& l) {
        return loop_of_lane(l.name).has_value();
      }));
  const std::size_t others = left_out.size() - loops;
  const auto part = [](std::size_t n, const char* word) {
    return n == 0 ? std::string() : "+" + grouped(n) + " " + word + (n == 1 ? "" : "s");
  };
  const std::string of_lanes = part(others, "lane"), of_loops = part(loops, "hole");
  return of_lanes + (of_lanes.empty() || of_loops.empty() ? "" : ", ") + of_loops;
}

} // namespace isoscope
