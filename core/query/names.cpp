// Looking names up.
#include "query/names.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace isoscope {
namespace {

constexpr std::size_t least_beginning = 3;

struct QuantityWords {
  std::string_view name, help;
};
constexpr std::array<QuantityWords, quantity_count> quantities{
    {{"step", "Operations applied before the event."},
     {"vertex", "The number of the vertex that was made or stays."},
     {"other", "The number of the edge's other end."},
     {"tet", "The number of the violating tetrahedron."},
     {"sample", "The number of the sample."},
     {"value", "What was measured."},
     {"limit", "What it had to keep."},
     {"count", "Candidates judged, vertices moved or components found, as the kind says."},
     {"ratio", "value / limit."},
     {"sweeps", "Sweeps of the repair."},
     {"took", "Seconds since the operation before it in its stage."},
     {"seconds", "Seconds since the stage began."},
     {"vertices", "Vertices of Z."},
     {"tets", "Tetrahedra of T."},
     {"bad_samples", "Samples with ε >= 1."},
     {"largest_error", "The largest ε over S."},
     {"height", "The smallest height of a tetrahedron that carries Z, a length."},
     {"sigma", "σ in force, a length."},
     {"alpha", "α in force."},
     {"delta", "δ, a length."},
     {"shrink", "The factor of the shrunk copy in force."},
     {"genus", "Of Z: components − (χ + loops) / 2."},
     {"expected", "The genus that Z should have."},
     {"components", "Of Z."},
     {"euler", "χ of Z."},
     {"loops", "Closed curves of the border of Z."}}};

/// Names with what the screen calls the same.
template <class Table> std::vector<NameAndTitle> rows(const Table& table) {
  std::vector<NameAndTitle> all;
  for (const auto& row : table) all.push_back({std::string(row.name), std::string(row.title)});
  return all;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      const std::size_t changed = diagonal + (a[i - 1] == b[k - 1] ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({row[k] + 1, row[k - 1] + 1, changed});
    }
  }
  return row.back();
}

std::uint64_t exact(NameSort sort, std::string_view word, bool with_none) {
  const auto& all = all_names(sort);
  for (const auto part : {&NameAndTitle::name, &NameAndTitle::title})
    for (std::size_t i = 0; i < all.size(); ++i)
      if (as_name(all[i].*part) == word && (with_none || all[i].name != "none")) return std::uint64_t{1} << i;
  return 0;
}

std::uint64_t beginning(NameSort sort, std::string_view word) {
  if (word.size() < least_beginning) return 0;
  const auto& all = all_names(sort);
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name != "none" && all[i].name.starts_with(word)) mask |= std::uint64_t{1} << i;
  return mask;
}

} // namespace

std::string as_name(std::string_view word) {
  std::string spelt(word);
  for (char& c : spelt)
    c = c == '_' || c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return spelt;
}

std::string_view name(Quantity quantity) {
  return quantities.at(static_cast<std::size_t>(quantity)).name;
}

std::string_view help(Quantity quantity) {
  return quantities.at(static_cast<std::size_t>(quantity)).help;
}

std::string_view name(SampleClass sample_class) {
  constexpr std::array<std::string_view, sample_class_count> words{"outside", "good", "margin", "bad"};
  return words.at(static_cast<std::size_t>(sample_class));
}

std::string_view name(NameSort sort) {
  constexpr std::array<std::string_view, name_sort_count> words{"stage", "kind", "condition", "reason"};
  return words.at(static_cast<std::size_t>(sort));
}

const std::vector<NameAndTitle>& all_names(NameSort sort) {
  static const std::array<std::vector<NameAndTitle>, name_sort_count> all{
      rows(stage_table), rows(kind_table), rows(condition_table), rows(reason_table)};
  return all.at(static_cast<std::size_t>(sort));
}

std::vector<NameAndTitle> quantity_names() {
  std::vector<NameAndTitle> all;
  for (const QuantityWords& quantity : quantities) all.push_back({std::string(quantity.name), {}});
  return all;
}

std::uint64_t names_of(NameSort sort, std::string_view word, bool with_none) {
  const std::string spelt = as_name(word);
  const std::uint64_t found = exact(sort, spelt, with_none);
  return found != 0 ? found : beginning(sort, spelt);
}

NameMasks names_of(std::string_view word) {
  const std::string spelt = as_name(word);
  NameMasks masks{};
  for (int s = 0; s < name_sort_count; ++s) {
    masks[static_cast<std::size_t>(s)] = exact(static_cast<NameSort>(s), spelt, false);
    if (any(masks)) return masks;
  }
  for (int s = 0; s < name_sort_count; ++s)
    masks[static_cast<std::size_t>(s)] = beginning(static_cast<NameSort>(s), spelt);
  return masks;
}

bool any(const NameMasks& masks) {
  return std::any_of(masks.begin(), masks.end(), [](std::uint64_t mask) { return mask != 0; });
}

std::optional<NameSort> sort_named(std::string_view word) {
  for (int s = 0; s < name_sort_count; ++s)
    if (name(static_cast<NameSort>(s)) == word) return static_cast<NameSort>(s);
  return std::nullopt;
}

std::optional<Quantity> quantity_named(std::string_view word) {
  const std::string spelt = as_name(word);
  for (int q = 0; q < quantity_count; ++q)
    if (as_name(name(static_cast<Quantity>(q))) == spelt) return static_cast<Quantity>(q);
  return std::nullopt;
}

std::optional<SampleClass> sample_class_named(std::string_view word) {
  for (int c = 0; c < sample_class_count; ++c)
    if (name(static_cast<SampleClass>(c)) == word) return static_cast<SampleClass>(c);
  return std::nullopt;
}

bool is_hyphenated_name(std::string_view word) {
  const std::string spelt = as_name(word);
  if (spelt.find('-') == std::string::npos) return false;
  if (quantity_named(spelt)) return true;
  for (int s = 0; s < name_sort_count; ++s)
    if (exact(static_cast<NameSort>(s), spelt, false) != 0) return true;
  return false;
}

bool is_title(std::string_view words) {
  for (int s = 0; s < name_sort_count; ++s)
    for (const NameAndTitle& row : all_names(static_cast<NameSort>(s)))
      if (row.name != "none" && as_name(row.title) == words) return true;
  return false;
}

std::string suggestion(std::string_view word, const std::vector<NameAndTitle>& valid) {
  constexpr std::size_t shown = 8;
  const std::string spelt = as_name(word);
  // Twice the edits; a name's beginning counts one more than the whole name.
  std::size_t least = 2 * (std::max<std::size_t>(2, spelt.size() / 3) + 1);
  std::string nearest;
  const auto try_one = [&](const std::string& candidate, const std::string& told) {
    const std::string whole = as_name(candidate);
    std::size_t distance = 2 * edit_distance(spelt, whole);
    for (const std::size_t length : {spelt.size(), spelt.size() + 1})
      if (spelt.size() > least_beginning && length < whole.size())
        distance = std::min(distance, 2 * edit_distance(spelt, whole.substr(0, length)) + 1);
    if (distance < least) {
      least = distance;
      nearest = told;
    }
  };
  for (const NameAndTitle& row : valid) try_one(row.name, row.name);
  for (const NameAndTitle& row : valid) {
    if (row.title.size() <= least_beginning || row.title == row.name) continue;
    const std::string told = row.name + " (" + row.title + ")";
    // The title, or the word at its end, which tells it from others: Ω.
    try_one(row.title, told);
    if (const std::size_t last = row.title.rfind(' ');
        last != row.title.npos && as_name(row.title.substr(last + 1)) == spelt && least > 1) {
      least = 1;
      nearest = told;
    }
  }
  if (!nearest.empty()) return "Did you mean " + nearest + "?";
  std::string list = "Valid here: ";
  for (std::size_t i = 0; i < std::min(shown, valid.size()); ++i) list += (i > 0 ? ", " : "") + valid[i].name;
  return list + (valid.size() > shown ? ", …" : ".");
}

} // namespace isoscope
