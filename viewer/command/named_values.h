// Every number, switch and choice that has a name: scripts set and expect them, help lists them. Features add
// theirs, bound to where they are kept.
#pragma once

#include "base/status.h"

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isoscope {

/// Reads a finite number; fails with usage.
Result<double> parse_number(const std::string& text);
/// Reads on/off, true/false, 1/0; fails with usage.
Result<bool> parse_switch(const std::string& text);
/// A number with all digits that tell it apart.
std::string text_of(double value);
inline std::string on_off(bool on) {
  return on ? "on" : "off";
}
/// "\"red\" is not one of dark, light, paper."
Error wrong_value(const std::string& text, const std::string& wanted);

/// A value by name; numbers, "on"/"off", or a word. `set` is empty for what can only be read.
struct NamedValue {
  std::string name;
  std::string help;
  std::function<std::string()> get;
  std::function<Status(const std::string&)> set;
};

/// By group and then by name. What it is bound to must outlive it.
class NamedValues {
 public:
  void add(std::string name, std::string help, std::function<std::string()> get,
           std::function<Status(const std::string&)> set = nullptr);
  template <class Number>
  void add_number(std::string name, std::string help, Number& place, double low, double high);
  void add_switch(std::string name, std::string help, bool& place);
  /// `words` in the order of the enumeration.
  template <class Choice>
  void add_choice(std::string name, std::string help, std::vector<std::string> words, Choice& place);

  const std::vector<NamedValue>& all() const { return values_; }
  const NamedValue* find(std::string_view name) const;
  /// Judges "bad_samples == 0 and phase == finished": comparisons (== != < <= > >=) of a named value with a
  /// number, a word or "several words", joined by `and`. Success when all hold; otherwise a usage error for
  /// what cannot be read, or an internal error whose message says what was found.
  Status expect(const std::string& expression) const;

 private:
  Status judge(const std::string& name, const std::string& op, const std::string& word) const;
  std::vector<NamedValue> values_;
};

template <class Number>
void NamedValues::add_number(std::string name, std::string help, Number& place, double low, double high) {
  add(
      std::move(name), std::move(help), [&place] { return text_of(static_cast<double>(place)); },
      [&place, low, high](const std::string& text) -> Status {
        const auto number = parse_number(text);
        if (!number) return number.error();
        if (*number < low || *number > high)
          return wrong_value(text, "between " + text_of(low) + " and " + text_of(high));
        place = static_cast<Number>(*number);
        return {};
      });
}

template <class Choice>
void NamedValues::add_choice(std::string name, std::string help, std::vector<std::string> words,
                             Choice& place) {
  add(
      std::move(name), std::move(help), [&place, words] { return words.at(static_cast<std::size_t>(place)); },
      [&place, words](const std::string& text) -> Status {
        const auto found = std::find(words.begin(), words.end(), text);
        if (found != words.end()) {
          place = static_cast<Choice>(found - words.begin());
          return {};
        }
        std::string all;
        for (const std::string& word : words) all += (all.empty() ? "" : ", ") + word;
        return wrong_value(text, "one of " + all);
      });
}

} // namespace isoscope
