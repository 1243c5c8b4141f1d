// Every number, switch and choice that has a name: scripts set and expect them, help lists them.
#pragma once

#include "app/app_model.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace isoscope {

/// A value by name; numbers, "on"/"off", or a word. `set` is empty for what can only be read.
struct NamedValue {
  std::string name;
  std::string help;
  std::function<std::string(const AppModel&)> get;
  std::function<Status(AppModel&, const std::string&)> set;
};

/// All of them, by group and then by name.
std::span<const NamedValue> named_values();
const NamedValue* find_value(std::string_view name);

/// Reads a finite number; fails with usage.
Result<double> parse_number(const std::string& text);
/// Reads on/off, true/false, 1/0; fails with usage.
Result<bool> parse_switch(const std::string& text);

/// Judges "bad_samples == 0 and phase == finished": comparisons (== != < <= > >=) of a named value with a
/// number, a word or "several words", joined by `and`. Success when all hold; otherwise a usage error for
/// what cannot be read, or an internal error whose message says what was found.
Status expect(const AppModel& model, const std::string& expression);

} // namespace isoscope
