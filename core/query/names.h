// The names of the language: of events by sort, of quantities, and the nearest one to a misspelt word.
#pragma once

#include "query/expression.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// A name, and what the screen calls the same: "outside-tolerance", "outside Ω". Either may be typed, blanks
/// as hyphens or underscores.
struct NameAndTitle {
  std::string name, title;
};

/// As names are spelt: small letters, hyphens for blanks and underscores.
std::string as_name(std::string_view words);

/// What the word stands for in one sort: the value of that very name or title, else all whose names begin
/// with it where it has three letters or more; 0 none. `none` is a name only when asked for.
std::uint64_t names_of(NameSort sort, std::string_view word, bool with_none);
/// The same in every sort; an exact name in any sort wins over beginnings. A stage's name wins over the kind
/// of the same name, since the stage holds both.
NameMasks names_of(std::string_view word);
bool any(const NameMasks& masks);

std::optional<NameSort> sort_named(std::string_view word);
/// With hyphens or underscores.
std::optional<Quantity> quantity_named(std::string_view word);
std::optional<SampleClass> sample_class_named(std::string_view word);

/// Whether a name with hyphens is spelt so.
bool is_hyphenated_name(std::string_view word);

/// Whether words joined by hyphens are a title.
bool is_title(std::string_view words);

const std::vector<NameAndTitle>& all_names(NameSort sort);
std::vector<NameAndTitle> quantity_names();
/// "Did you mean kernel-empty?" where one of them is near, "… outside-tolerance (outside Ω)?" where a title
/// is; else the first few of them as a list.
std::string suggestion(std::string_view word, const std::vector<NameAndTitle>& valid);

} // namespace isoscope
