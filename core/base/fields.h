// What a struct of parameters says of each of its fields, once: whatever reads, writes, judges or shows the
// struct visits it.
//
// A struct S has fields when fields_of(const S*) gives a tuple of field(...): see run/parameters.h.
// Everything here is over S; files are in base/fields_json.h, the command line in base/field_options.h.
#pragma once

#include "base/numbers.h"
#include "base/status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace isoscope {

/// The word of a value: of an enumeration or a switch in order, or of each flag of a set.
struct Choice {
  std::string_view name;        ///< in files and on the command line
  std::string_view shown = {};  ///< in the window, where it is another
  std::string_view told = {};   ///< in comparisons, where it is another
  std::string_view script = {}; ///< in scripts, where it is another
  std::string_view words = {};  ///< a flag's own words
  std::string_view tip = {};    ///< a flag's own tooltip
  std::string_view until = {};  ///< a flag's own FieldFacts::until
  bool offered = true;          ///< false: old files may hold it, nobody may ask for it
};

/// What a number may be.
struct FieldRange {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_included = true, high_included = true;
  std::string_view wrong = {}; ///< what any other is, "no time"; empty: "not in [low, high]"
  std::string_view remedy = {};
  /// "[low, high]", with round brackets at ends that are not part of it.
  std::string text() const {
    return std::string(low_included ? "[" : "(") + shortest(low) + ", " + shortest(high) +
           (high_included ? "]" : ")");
  }
};

/// What a change of the field changes of the journal: nothing, only where it ends, anything.
enum class JournalChange : std::uint8_t { none, end, any };

struct FieldFacts {
  std::string_view name = {};   ///< in files; with hyphens in scripts and as the option
  std::string_view script = {}; ///< in scripts, where it is not the name
  std::string_view option = {}; ///< where it is not --name; "INPUT": an argument without a name
  std::string_view symbol = {}; ///< the paper's, or a word; in comparisons
  std::string_view unit = {};   ///< with the blank before it
  std::string_view help = {};   ///< on the command line
  std::string_view words = {};  ///< in scripts; empty: it has no name there
  std::string_view prefix = {}; ///< of the flags of a set in scripts
  std::span<const Choice> choices = {};
  FieldRange range = {};
  std::string_view unreadable = {}; ///< what a text is that cannot be read, "no positive number"
  std::string_view unreadable_remedy = {};
  std::string_view absent = {}; ///< the word for an optional without a value
  bool zero_is_default = false; ///< 0, outside of the range, leaves the value to the run
  bool numbered = false;        ///< its words are whole numbers, also in files
  bool ordinal = false;         ///< files hold the number of the word instead
  int values = 1;               ///< words that make one text on the command line
  bool restart = true;          ///< a run that goes on cannot take a change
  JournalChange journal = JournalChange::any;
  std::string_view until = {}; ///< the last stage that asks for it, where a run that goes on takes a change
  // In the window's panel.
  int place = 0;               ///< rows ascend by it, tens make groups; 0: no row
  std::string_view label = {}; ///< where it is not the symbol
  std::string_view title = {}, tip = {};
  std::string_view counted_in = {}; ///< the unit behind its number, where it is not `unit`
  std::string_view format = {};     ///< of a slider; empty: a number is typed
  double slider_from = 0;           ///< the least that a slider offers, where it is not the range's
  bool logarithmic = false;         ///< a slider's scale

  /// The option, and what errors call the field.
  std::string option_name() const { return option.empty() ? "--" + script_name() : std::string(option); }
  std::string script_name() const {
    if (!script.empty()) return std::string(script);
    std::string spelt(name);
    std::replace(spelt.begin(), spelt.end(), '_', '-');
    return spelt;
  }
};

template <class S, class T> struct Field : FieldFacts {
  T S::*member = nullptr;
  T (*in_force)(const S&) = nullptr; ///< the value that holds where the member leaves it open
  T value(const S& s) const { return in_force != nullptr ? in_force(s) : s.*member; }
};

template <class S, class T>
constexpr Field<S, T> field(T S::*member, FieldFacts facts,
                            std::type_identity_t<T (*)(const S&)> in_force = nullptr) {
  return {facts, member, in_force};
}

template <class S> inline constexpr auto all_fields = fields_of(static_cast<const S*>(nullptr));

/// Calls visit(const Field<S, T>&) for every field in the order of the struct's list.
template <class S, class Visit> void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... each) { (visit(each), ...); }, all_fields<S>);
}

/// The field of a member.
template <class S, class T> const Field<S, T>& field_of(T S::*member) {
  const Field<S, T>* found = nullptr;
  for_each_field<S>([&]<class F>(const F& f) {
    if constexpr (std::is_same_v<F, Field<S, T>>)
      if (f.member == member) found = &f;
  });
  return *found;
}

/// A value of several parts that files hold side by side, with a text of its own.
template <class T>
concept FieldParts = requires(const T& value) {
  fields_of(&value);
};
template <class T>
concept FieldNumber = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;
template <class T> struct OptionalField : std::false_type {};
template <class T> struct OptionalField<std::optional<T>> : std::true_type { using type = T; };
template <class T> struct FlagField : std::false_type {};
template <std::size_t n> struct FlagField<std::array<bool, n>> : std::true_type {};

/// The word of a value of an enumeration.
template <class T> const Choice& field_choice(const FieldFacts& f, T value) {
  return f.choices[static_cast<std::size_t>(value)];
}

/// As scripts spell it, and without loss.
template <class T> std::string field_text(const FieldFacts& f, const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (FieldParts<T>) {
    return value.text();
  } else if constexpr (OptionalField<T>::value) {
    return value ? field_text(f, *value) : std::string(f.absent);
  } else if constexpr (FlagField<T>::value) {
    std::string all;
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i]) all += (all.empty() ? "" : " ") + std::string(f.choices[i].name);
    return all.empty() ? "none" : all;
  } else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
    return std::to_string(value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return shortest(value);
  } else if (std::is_same_v<T, bool> && f.choices.empty()) {
    return static_cast<bool>(value) ? "on" : "off";
  } else {
    const Choice& c = field_choice(f, value);
    return std::string(c.script.empty() ? c.name : c.script);
  }
}

/// As comparisons tell it.
template <class T> std::string field_told(const FieldFacts& f, const T& value) {
  if constexpr (OptionalField<T>::value) {
    return value ? field_told(f, *value) : std::string(f.absent);
  } else if constexpr (FieldNumber<T>) {
    if (f.zero_is_default && value == 0) return "default";
    return general(static_cast<double>(value), 4) + std::string(f.unit);
  } else if constexpr (std::is_enum_v<T> || std::is_same_v<T, bool>) {
    if (f.choices.empty()) return field_text(f, value);
    const Choice& c = field_choice(f, value);
    return std::string(c.told.empty() ? c.name : c.told);
  } else {
    return field_text(f, value);
  }
}

/// Whether a number is in the field's range; the error calls the field what it was `asked` as.
inline Status check_range(const FieldFacts& f, const std::string& asked, double value) {
  const FieldRange& r = f.range;
  if ((r.low_included ? value >= r.low : value > r.low) &&
      (r.high_included ? value <= r.high : value < r.high) && std::isfinite(value))
    return {};
  const std::string wrong = !r.wrong.empty() ? std::string(r.wrong) : "not in " + r.text();
  return Error{ErrorCode::usage, asked + " is " + shortest(value) + ", which is " + wrong + ".",
               std::string(r.remedy)};
}

template <class T> Status check_field(const FieldFacts& f, const std::string& asked, const T& value) {
  if constexpr (FieldParts<T>) {
    return value.check(f, asked);
  } else if constexpr (OptionalField<T>::value) {
    return value ? check_field(f, asked, *value) : Status();
  } else if constexpr (FieldNumber<T>) {
    return f.zero_is_default && value == 0 ? Status() : check_range(f, asked, static_cast<double>(value));
  } else if constexpr (std::is_enum_v<T>) {
    if (static_cast<std::size_t>(value) < f.choices.size()) return {};
    return Error{ErrorCode::usage, asked + " has no such value.", ""};
  } else {
    return {};
  }
}

/// Judges every field; the error says what is `called` how, the value and the range.
template <class S, class Called> Status check_fields(const S& s, const Called& called) {
  Status first;
  for_each_field<S>([&](const auto& f) {
    if (first) first = check_field(f, called(f), s.*(f.member));
  });
  return first;
}
/// By their options.
template <class S> Status check_fields(const S& s) {
  return check_fields(s, [](const FieldFacts& f) { return f.option_name(); });
}

/// "a, b, c": the words that may be asked for.
inline std::string offered_words(const FieldFacts& f, bool in_scripts = false) {
  std::string all;
  for (const Choice& c : f.choices)
    if (c.offered)
      all += (all.empty() ? "" : ", ") + std::string(in_scripts && !c.script.empty() ? c.script : c.name);
  return all;
}

/// "--sides is 'left', which is not one of auto, winding, parity."
inline Error unreadable_field(const FieldFacts& f, const std::string& asked, std::string_view text,
                              const std::string& why) {
  return {ErrorCode::usage,
          asked + " is '" + std::string(text) + "', which is " +
              (f.unreadable.empty() ? why : std::string(f.unreadable)) + ".",
          std::string(f.unreadable_remedy)};
}

/// Which of the words that may be asked for a text is.
inline std::optional<std::size_t> offered_at(const FieldFacts& f, std::string_view text) {
  for (std::size_t i = 0; i < f.choices.size(); ++i)
    if (const Choice& c = f.choices[i];
        c.offered && (c.name == text || (!c.script.empty() && c.script == text)))
      return i;
  return std::nullopt;
}

/// Reads what field_text() gives, or an option's value; fails with usage.
template <class T>
Result<T> read_field(const FieldFacts& f, const std::string& asked, std::string_view text) {
  if constexpr (std::is_same_v<T, std::string>) {
    return std::string(text);
  } else if constexpr (FieldParts<T>) {
    const std::optional<T> value = T::read(text);
    if (!value) return unreadable_field(f, asked, text, "");
    return *value;
  } else if constexpr (OptionalField<T>::value) {
    if (text == f.absent) return T();
    const auto value = read_field<typename T::value_type>(f, asked, text);
    if (!value) return f.unreadable.empty() ? value.error() : unreadable_field(f, asked, text, "");
    return T(*value);
  } else if constexpr (std::is_same_v<T, bool>) {
    if (const auto at = offered_at(f, text)) return *at == 1;
    if (const auto on = read_switch(text)) return *on;
    return unreadable_field(f, asked, text,
                            f.choices.empty() ? "not on or off" : "not one of " + offered_words(f, true));
  } else if constexpr (FieldNumber<T>) {
    const std::optional<T> value = read_number<T>(text);
    if (!value)
      return unreadable_field(f, asked, text,
                              std::is_integral_v<T> ? "not a whole number" : "not a finite number");
    if (Status in = check_field(f, asked, *value); !in) return in.error();
    return *value;
  } else {
    const auto at = offered_at(f, text);
    if (!at)
      return unreadable_field(f, asked, text, "not one of " + offered_words(f, asked == f.script_name()));
    return static_cast<T>(*at);
  }
}

/// Whether a field that `counts` accepts has another value in force.
template <class S, class Counts> bool fields_differ(const S& a, const S& b, Counts&& counts) {
  bool differ = false;
  for_each_field<S>([&](const auto& f) { differ |= counts(f) && !(f.value(a) == f.value(b)); });
  return differ;
}

/// A field with the values that two structs have, as people write them.
struct FieldDifference {
  std::string name, a, b;
  friend bool operator==(const FieldDifference&, const FieldDifference&) = default;
};

/// Those that may change a journal and are told differently.
template <class S> std::vector<FieldDifference> differing_fields(const S& a, const S& b) {
  std::vector<FieldDifference> rows;
  for_each_field<S>([&](const auto& f) {
    if (f.journal == JournalChange::none) return;
    std::string of_a = field_told(f, f.value(a)), of_b = field_told(f, f.value(b));
    if (of_a != of_b) rows.push_back({std::string(f.symbol), std::move(of_a), std::move(of_b)});
  });
  return rows;
}

/// One line for each field that may change any event and is not what a run takes by default: equal texts mean
/// equal journals, and a field that is new changes no text.
template <class S> std::string fields_key(const S& s) {
  const S plain{};
  std::string key;
  for_each_field<S>([&](const auto& f) {
    if (f.journal == JournalChange::any && !(f.value(s) == f.value(plain)))
      key += std::string(f.name) + "=" + field_text(f, f.value(s)) + "\n";
  });
  return key;
}

/// A field, or a flag of a set, that scripts read and set by name.
template <class S> struct NamedField {
  std::string name, help;
  std::function<std::string(const S&)> get;
  std::function<Status(S&, const std::string&)> set;
};

/// All that have words.
template <class S> std::vector<NamedField<S>> named_fields() {
  std::vector<NamedField<S>> all;
  for_each_field<S>([&]<class T>(const Field<S, T>& f) {
    if (f.words.empty()) return;
    if constexpr (FlagField<T>::value) {
      for (std::size_t i = 0; i < f.choices.size(); ++i) {
        const Choice& flag = f.choices[i];
        if (!flag.offered) continue;
        const std::string name = std::string(f.prefix) + std::string(flag.name);
        all.push_back({name, std::string(flag.words.empty() ? f.words : flag.words),
                       [&f, i](const S& s) { return field_text(FieldFacts(), (s.*(f.member))[i]); },
                       [&f, i, name](S& s, const std::string& text) -> Status {
                         const auto on = read_field<bool>(FieldFacts(), name, text);
                         if (!on) return on.error();
                         (s.*(f.member))[i] = *on;
                         return {};
                       }});
      }
    } else {
      all.push_back({f.script_name(), std::string(f.words),
                     [&f](const S& s) { return field_text(f, f.value(s)); },
                     [&f](S& s, const std::string& text) -> Status {
                       const auto value = read_field<T>(f, f.script_name(), text);
                       if (!value) return value.error();
                       s.*(f.member) = *value;
                       return {};
                     }});
    }
  });
  return all;
}

} // namespace isoscope
