// Each option is taken twice: by its field, which judges it, and as words.
#include "cli/passed_options.h"

#include "base/field_options.h"
#include "base/numbers.h"

#include <algorithm>
#include <type_traits>

namespace isoscope {

namespace {

template <class T>
void add_words(std::vector<std::string>& words, const FieldOption& option, const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (value) words.push_back(option.name);
  } else if constexpr (std::is_floating_point_v<T>) {
    words.insert(words.end(), {option.name, shortest(value)});
  } else if constexpr (std::is_arithmetic_v<T>) {
    words.insert(words.end(), {option.name, std::to_string(value)});
  } else if constexpr (std::is_same_v<T, std::string>) {
    words.push_back(option.name);
    // A text of several arguments was joined by blanks.
    std::size_t at = 0, end = 0;
    for (int i = 1; i < option.values && (end = value.find(' ', at)) != std::string::npos; ++i, at = end + 1)
      words.push_back(value.substr(at, end - at));
    words.push_back(value.substr(at));
  } else {
    for (const auto& one : value) add_words(words, option, one);
  }
}

} // namespace

PassedOptions::PassedOptions(CommandLine& line, std::initializer_list<std::string_view> without) {
  std::vector<FieldOption> options;
  for (FieldOption& option : field_options(parameters_)) {
    if (std::find(without.begin(), without.end(), option.name) != without.end()) continue;
    const FieldOption told{option.name, option.help, option.values, {}};
    std::visit(
        [&]<class T>(FieldOption::Take<T>& take) {
          take = [this, told, judge = take](const T& value) {
            add_words(words_, told, value);
            return judge(value);
          };
        },
        option.take);
    options.push_back(std::move(option));
  }
  line.fields(options, wrong_);
}

Result<std::vector<std::string>> PassedOptions::words() const {
  if (wrong_) return *wrong_;
  RunParameters p = parameters_;
  if (Status valid = check(p); !valid) return valid.error();
  return words_;
}

} // namespace isoscope
