// The fields of a struct as options of a command line, for any library that parses one.
#pragma once

#include "base/fields.h"

#include <functional>
#include <memory>
#include <variant>

namespace isoscope {

/// One option. `take` gets its values once; it fails with usage on what the field cannot be.
struct FieldOption {
  template <class T> using Take = std::function<Status(const T&)>;
  std::string name, help;
  int values = 1; ///< words that make one text
  /// A switch gets whether it was given.
  std::variant<Take<bool>, Take<double>, Take<int>, Take<unsigned>, Take<std::string>, Take<std::vector<int>>,
               Take<std::vector<std::string>>>
      take;
};

/// Flags that are named are not what they are by default.
template <class S, class T> Status take_flag(const Field<S, T>& f, S& into, std::string_view word) {
  const auto at = offered_at(f, word);
  if (!at) return unreadable_field(f, f.option_name(), word, "not one of " + offered_words(f));
  (into.*(f.member))[*at] = !(S{}.*(f.member))[*at];
  return {};
}

template <class S, class T> Status take_text(const Field<S, T>& f, S& into, const std::string& text) {
  auto value = read_field<T>(f, f.option_name(), text);
  if (!value) return value.error();
  into.*(f.member) = std::move(*value);
  return {};
}

template <class S, class T> FieldOption option_of(const Field<S, T>& f, S& into) {
  FieldOption option{f.option_name(), std::string(f.help), f.values, {}};
  if constexpr (std::is_same_v<T, bool>) {
    option.take = FieldOption::Take<bool>([&f, &into](bool given) -> Status {
      into.*(f.member) = given;
      return {};
    });
  } else if constexpr (FieldNumber<T>) {
    option.take = FieldOption::Take<T>([&f, &into](T value) -> Status {
      into.*(f.member) = value;
      return check_range(f, f.option_name(), static_cast<double>(value));
    });
  } else if constexpr (FlagField<T>::value) {
    const auto take_all = [&f, &into](const auto& words, auto&& text) -> Status {
      for (const auto& word : words)
        if (Status s = take_flag(f, into, text(word)); !s) return s;
      return {};
    };
    if (f.numbered)
      option.take = FieldOption::Take<std::vector<int>>([=](const std::vector<int>& words) {
        return take_all(words, [](int word) { return std::to_string(word); });
      });
    else
      option.take = FieldOption::Take<std::vector<std::string>>([=](const std::vector<std::string>& words) {
        return take_all(words, [](const std::string& word) { return word; });
      });
  } else if (f.numbered) {
    option.take =
        FieldOption::Take<int>([&f, &into](int word) { return take_text(f, into, std::to_string(word)); });
  } else {
    option.take = FieldOption::Take<std::string>(
        [&f, &into](const std::string& text) { return take_text(f, into, text); });
  }
  return option;
}

/// The options of all fields, in their order; `into` must outlive them.
template <class S> std::vector<FieldOption> field_options(S& into) {
  std::vector<FieldOption> options;
  for_each_field<S>([&](const auto& f) { options.push_back(option_of(f, into)); });
  return options;
}

} // namespace isoscope
