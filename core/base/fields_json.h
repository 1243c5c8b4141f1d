// The fields of a struct as one JSON object and back.
#pragma once

#include "base/fields.h"

#include <nlohmann/json.hpp>

namespace isoscope {

using FieldJson = nlohmann::ordered_json;

/// Whether a set of flags begins full: then files hold a switch for each flag, else the names of those set.
template <class S, class T> bool begins_full(const Field<S, T>& f) {
  return (S{}.*(f.member))[0];
}

/// An optional word that is absent is left out, an optional number is null.
template <class Json, class S, class T> void write_field(Json& json, const Field<S, T>& f, const T& value) {
  const std::string name(f.name);
  if constexpr (FieldParts<T>) {
    for_each_field<T>([&](const auto& part) {
      json[name + (part.name.empty() ? "" : "_") + std::string(part.name)] = value.*(part.member);
    });
  } else if constexpr (FlagField<T>::value) {
    if (begins_full(f)) {
      json[name] = value;
      return;
    }
    json[name] = Json::array();
    for (std::size_t i = 0; i < value.size(); ++i)
      if (value[i]) json[name].push_back(f.choices[i].name);
  } else if constexpr (OptionalField<T>::value && std::is_enum_v<typename OptionalField<T>::type>) {
    if (value) json[name] = field_choice(f, *value).name;
  } else if constexpr (OptionalField<T>::value) {
    json[name] = value ? Json(*value) : Json(nullptr);
  } else if constexpr (std::is_enum_v<T>) {
    const std::string_view word = field_choice(f, value).name;
    if (f.ordinal)
      json[name] = static_cast<int>(value);
    else if (f.numbered)
      json[name] = std::stoi(std::string(word));
    else
      json[name] = word;
  } else {
    json[name] = value;
  }
}

template <class S> FieldJson fields_json(const S& s) {
  FieldJson json = FieldJson::object();
  for_each_field<S>([&](const auto& f) { write_field(json, f, s.*(f.member)); });
  return json;
}

/// A whole number; throws on any other, which get() would cast.
template <class Json> std::int64_t whole_number(const Json& json) {
  return json.template get_ref<const typename Json::number_integer_t&>();
}

/// Leaves the value where its word is not known; of a number that is not, check_field() tells.
template <class Json, class E> void read_word(const FieldFacts& f, const Json& json, E& value) {
  if (f.ordinal) {
    value = static_cast<E>(std::min(static_cast<std::size_t>(whole_number(json)), f.choices.size()));
    return;
  }
  const std::string word = f.numbered ? std::to_string(whole_number(json)) : json.template get<std::string>();
  for (std::size_t i = 0; i < f.choices.size(); ++i)
    if (f.choices[i].name == word) value = static_cast<E>(i);
}

template <class Json, class S, class T> void read_member(const Json& json, const Field<S, T>& f, T& value) {
  const std::string name(f.name);
  if constexpr (FieldParts<T>) {
    for_each_field<T>([&](const auto& part) {
      auto& place = value.*(part.member);
      place = json.value(name + (part.name.empty() ? "" : "_") + std::string(part.name), place);
    });
    return;
  }
  if constexpr (OptionalField<T>::value) value.reset();
  const auto found = json.find(name);
  if (found == json.end()) return;
  if constexpr (FlagField<T>::value) {
    if (begins_full(f)) {
      value = found->template get<T>();
      return;
    }
    for (const Json& word : *found)
      for (std::size_t i = 0; i < value.size(); ++i)
        if (f.choices[i].name == word.template get<std::string>()) value[i] = true;
  } else if constexpr (OptionalField<T>::value) {
    using Inner = typename OptionalField<T>::type;
    if (found->is_null()) return;
    if constexpr (std::is_enum_v<Inner>) {
      Inner inner{};
      const std::string word = found->template get<std::string>();
      const bool known =
          std::any_of(f.choices.begin(), f.choices.end(), [&](const Choice& c) { return c.name == word; });
      if (!known) return;
      read_word(f, *found, inner);
      value = inner;
    } else {
      value = found->template get<Inner>();
    }
  } else if constexpr (std::is_enum_v<T>) {
    read_word(f, *found, value);
  } else if constexpr (FieldNumber<T> && std::is_integral_v<T>) {
    value = static_cast<T>(whole_number(*found));
  } else if constexpr (!FieldParts<T>) {
    value = found->template get<T>();
  }
}

/// Reads what fields_json() gave. A field that is missing keeps its value; an optional one is absent then.
/// Throws FieldJson::exception on what is no such object.
template <class S> void read_fields(const FieldJson& json, S& s) {
  static_cast<void>(json.get_ref<const FieldJson::object_t&>());
  for_each_field<S>([&](const auto& f) { read_member(json, f, s.*(f.member)); });
}

} // namespace isoscope
