// The text of an expression cut into tokens with their places.
#pragma once

#include "query/expression.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace isoscope {

struct Token {
  enum class Kind : std::uint8_t { number, word, text, sign, end };
  Kind kind = Kind::end;
  std::size_t place = 0;
  std::string spelling; ///< words with hyphens, as names are; signs as written; texts without quotes
  double number = 0;
  bool is(std::string_view sign) const { return kind == Kind::sign && spelling == sign; }
  bool is_word(std::string_view word) const { return kind == Kind::word && spelling == word; }
};

/// The last token is the end. A hyphen joins words only where a name is spelt so.
std::variant<std::vector<Token>, QueryError> tokenize(std::string_view text);

} // namespace isoscope
