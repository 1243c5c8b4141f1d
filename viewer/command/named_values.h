// Every number, switch and choice that has a name: scripts set and expect them, help lists them. Features add
// theirs, bound to where they are kept.
#pragma once

#include "base/fields.h"

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace isoscope {

/// A number with all digits that tell it apart, but for the last two, which sums lose.
inline std::string text_of(double value) {
  return general(value, std::numeric_limits<double>::max_digits10 - 2);
}
inline std::string on_off(bool on) {
  return on ? "on" : "off";
}
/// What scripts read of a value: a number, a word, on or off; `absent` where there is nothing.
template <class T> std::string value_text(const T& value, const std::string& absent = "none") {
  if constexpr (std::is_same_v<T, bool>)
    return on_off(value);
  else if constexpr (std::is_integral_v<T>)
    return std::to_string(value);
  else if constexpr (std::is_floating_point_v<T>)
    return text_of(static_cast<double>(value));
  else if constexpr (std::is_enum_v<T>)
    return std::string(name(value));
  else if constexpr (std::is_constructible_v<std::string, T>)
    return std::string(value);
  else if constexpr (requires { value.valid(); })
    return value.valid() ? std::to_string(value.value) : absent;
  else
    return value ? value_text(*value, absent) : absent;
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
  /// `get` gives anything that value_text() takes.
  template <class Get>
  void add(std::string name, std::string help, Get get,
           std::function<Status(const std::string&)> set = nullptr) {
    values_.push_back({std::move(name), std::move(help), [get = std::move(get)] { return value_text(get()); },
                       std::move(set)});
  }
  /// Adds readings, by a member or a function, of what `find` points to; `absent` is read where it is empty.
  template <class Find> auto readings(std::string prefix, Find find, std::string absent = "none") {
    return [this, prefix, find, absent](const std::string& name, std::string help, auto get) {
      add(prefix + name, std::move(help), [find, get, absent] {
        const auto found = find();
        return found ? value_text(std::invoke(get, *found), absent) : absent;
      });
    };
  }
  /// Bound to a place, whose range and words the facts give.
  template <class T> void bind(std::string name, std::string help, const FieldFacts& facts, T& place);
  /// The fields of a struct that have words.
  template <class S> void bind_fields(S& settings);

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

template <class T>
void NamedValues::bind(std::string name, std::string help, const FieldFacts& facts, T& place) {
  add(
      name, std::move(help), [facts, &place] { return field_text(facts, place); },
      [facts, name, &place](const std::string& text) -> Status {
        auto value = read_field<T>(facts, name, text);
        if (!value) return value.error();
        place = std::move(*value);
        return {};
      });
}

template <class S> void NamedValues::bind_fields(S& settings) {
  for (NamedField<S>& f : named_fields<S>())
    add(
        std::move(f.name), std::move(f.help), [&settings, get = std::move(f.get)] { return get(settings); },
        [&settings, set = std::move(f.set)](const std::string& text) { return set(settings, text); });
}

} // namespace isoscope
