// What scripts can expect of the window's times.
#include "command/named_table.h"

namespace isoscope {

void add_time_readings(NamedTable& t) {
  const auto add = [&](const std::string& name, const std::string& what,
                       const Quantiles& (WindowTimes::*times)() const) {
    t.push_back({name + ".count", what + ", since times reset",
                 [times](const AppModel& m) { return std::to_string((m.times.*times)().size()); }, nullptr});
    for (const auto& [part, word] : {std::pair{0.5, ".median"}, {0.95, ".95"}, {1.0, ".largest"}})
      t.push_back(
          {name + word, "milliseconds of real time",
           [times, part = part](const AppModel& m) { return text_of(1e3 * (m.times.*times)().at(part)); },
           nullptr});
  };
  add("frame", "frames made", &WindowTimes::frames);
  add("picture", "steps whose picture appeared", &WindowTimes::pictures);
}

} // namespace isoscope
