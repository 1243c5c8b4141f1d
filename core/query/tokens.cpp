// Cutting a text into tokens.
#include "query/tokens.h"

#include "query/names.h"

#include <cctype>
#include <charconv>

namespace isoscope {
namespace {

/// The bytes of the letter at `at`, Greek ones and ∂ included; 0 where there is none.
std::size_t letter_at(std::string_view text, std::size_t at) {
  if (at >= text.size()) return 0;
  const char c = text[at];
  if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') return 1;
  if ((c == '\xce' || c == '\xcf') && at + 1 < text.size()) return 2;
  constexpr std::string_view del = "∂";
  return text.substr(at).starts_with(del) ? del.size() : 0;
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

std::size_t end_of_word(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const std::size_t bytes = is_digit(text[at]) ? 1 : letter_at(text, at);
    if (bytes == 0) break;
    at += bytes;
  }
  return at;
}

/// The end of the longest name with hyphens that begins at `at`, else of the plain word.
std::size_t end_of_name(std::string_view text, std::size_t at) {
  std::size_t end = end_of_word(text, at), longest = end;
  while (end + 1 < text.size() && text[end] == '-' && letter_at(text, end + 1) > 0) {
    end = end_of_word(text, end + 1);
    if (is_hyphenated_name(text.substr(at, end - at))) longest = end;
  }
  return longest;
}

} // namespace

std::variant<std::vector<Token>, QueryError> tokenize(std::string_view text) {
  constexpr std::array<std::string_view, 8> pairs{"==", "!=", "<=", ">=", "&&", "||", "=", "&"};
  constexpr std::string_view signs = "<>!+-*/().,";
  std::vector<Token> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at;
      continue;
    }
    Token token;
    token.place = at;
    if (letter_at(text, at) > 0) {
      const std::size_t end = end_of_name(text, at);
      token.kind = Token::Kind::word;
      token.spelling = as_name(text.substr(at, end - at));
      at = end;
    } else if (is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]))) {
      token.kind = Token::Kind::number;
      const auto [end, error] = std::from_chars(text.data() + at, text.data() + text.size(), token.number);
      if (error != std::errc()) return QueryError{at, "This number is too large.", ""};
      const auto length = static_cast<std::size_t>(end - (text.data() + at));
      token.spelling = text.substr(at, length);
      at += length;
      if (letter_at(text, at) > 0)
        return QueryError{at, "A letter follows a number.", "Put a blank or an operator between them."};
    } else if (c == '"') {
      const std::size_t end = text.find('"', at + 1);
      if (end == text.npos) return QueryError{at, "This text has no closing quote.", "Put a \" at its end."};
      token.kind = Token::Kind::text;
      token.spelling = text.substr(at + 1, end - at - 1);
      at = end + 1;
    } else {
      token.kind = Token::Kind::sign;
      for (const std::string_view pair : pairs)
        if (token.spelling.empty() && text.substr(at).starts_with(pair)) token.spelling = pair;
      if (token.spelling == "=") return QueryError{at, "= is no operator here.", "Write == to compare."};
      if (token.spelling == "&") return QueryError{at, "& is no operator here.", "Write && for \"and\"."};
      if (token.spelling.empty() && c == '|')
        return QueryError{at, "| is no operator here.", "Write || for \"or\"."};
      if (token.spelling.empty() && signs.find(c) == signs.npos)
        return QueryError{at, "This character has no meaning here.",
                          "Operators are == != < <= > >= && || ! + - * / and parentheses."};
      if (token.spelling.empty()) token.spelling = c;
      at += token.spelling.size();
    }
    tokens.push_back(std::move(token));
  }
  Token end;
  end.place = text.size();
  tokens.push_back(end);
  return tokens;
}

} // namespace isoscope
