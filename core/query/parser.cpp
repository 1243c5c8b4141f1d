// Recursive descent with types: a word becomes a truth, a number or a name where its neighbours decide.
#include "query/grammar.h"

#include <algorithm>
#include <cmath>

namespace isoscope {
namespace grammar {
namespace {

std::vector<NameAndTitle> truth_names() {
  std::vector<NameAndTitle> all;
  for (int s = 0; s < name_sort_count; ++s)
    for (const NameAndTitle& row : all_names(static_cast<NameSort>(s)))
      if (row.name != "none") all.push_back(row);
  return all;
}

/// Words in a row that are a title, as `outside Ω` or `learnt half-spaces`, are one word.
std::vector<Token> with_titles(std::vector<Token> tokens) {
  constexpr std::size_t longest = 6;
  const auto is_part = [](const Token& t) {
    return t.kind == Token::Kind::word || t.kind == Token::Kind::number;
  };
  const auto is_hyphen = [&](std::size_t i) {
    const Token &before = tokens[i - 1], &t = tokens[i];
    return t.is("-") && is_part(before) && before.place + before.spelling.size() == t.place &&
           is_part(tokens[i + 1]) && tokens[i + 1].place == t.place + 1;
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!is_part(tokens[i])) continue;
    std::string title = tokens[i].spelling, longest_title;
    std::size_t found = 0;
    for (std::size_t end = i + 1; end < std::min(tokens.size(), i + longest); ++end) {
      if (is_hyphen(end)) continue;
      if (!is_part(tokens[end])) break;
      title += "-" + tokens[end].spelling;
      if (is_title(title)) longest_title = title, found = end + 1;
    }
    if (found == 0) continue;
    tokens[i].kind = Token::Kind::word;
    tokens[i].spelling = longest_title;
    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                 tokens.begin() + static_cast<std::ptrdiff_t>(found));
  }
  return tokens;
}

} // namespace

std::uint32_t Parser::named(const Token& token) {
  if (is_all(token)) return add({});
  Node node;
  node.op = Op::named;
  node.masks = names_of(token.spelling);
  if (!any(node.masks)) {
    if (sort_named(token.spelling))
      fail(token.place, token.spelling + " is no condition by itself.",
           "Compare it with a name: " + token.spelling + " == …");
    else if (quantity_named(token.spelling))
      fail(token.place, token.spelling + " is a number, where a condition is asked for.",
           "Compare it: " + token.spelling + " > 0");
    else
      fail(token.place, "Nothing is called " + token.spelling + ".",
           suggestion(token.spelling, truth_names()));
  }
  return add(std::move(node));
}

std::uint32_t Parser::truth(const Operand& operand) {
  switch (operand.type) {
  case Operand::Type::truth:
    break;
  case Operand::Type::number:
    fail(operand.place, "This is a number, where a condition is asked for.", "Compare it: … > 0");
    break;
  case Operand::Type::word:
    return named(operand.word);
  }
  return operand.node;
}

std::uint32_t Parser::number(const Operand& operand) {
  switch (operand.type) {
  case Operand::Type::number:
    break;
  case Operand::Type::truth:
    fail(operand.place, "This is a condition, where a number is asked for.", "Join conditions by && or ||.");
    break;
  case Operand::Type::word: {
    const Token& word = operand.word;
    if (const auto quantity = quantity_named(word.spelling)) {
      Node node;
      node.op = Op::quantity;
      node.quantity = *quantity;
      return add(std::move(node));
    }
    if (sort_named(word.spelling)) {
      fail(word.place, word.spelling + " is no number.", "Compare it with a name by == or !=.");
    } else if (any(names_of(word.spelling))) {
      fail(word.place, word.spelling + " is a name, not a number.",
           "Names stand alone, or behind stage, kind, condition or reason ==.");
    } else {
      fail(word.place, "No number is called " + word.spelling + ".",
           suggestion(word.spelling, quantity_names()));
    }
    break;
  }
  }
  return operand.node;
}

Operand Parser::either() {
  if (++depth_ > deepest) fail(now().place, "This is nested too deeply.", "");
  Operand left = error_ ? Operand{} : both();
  while (!error_ && take("||")) {
    const std::uint32_t a = truth(left), b = truth(both());
    left = of(Operand::Type::truth, add(Op::either, a, b), left.place);
  }
  --depth_;
  return left;
}

Operand Parser::both() {
  Operand left = negated();
  while (!error_ && take("&&")) {
    const std::uint32_t a = truth(left), b = truth(negated());
    left = of(Operand::Type::truth, add(Op::both, a, b), left.place);
  }
  return left;
}

Operand Parser::negated() {
  const std::size_t place = now().place;
  int times = 0;
  while (take("!")) ++times;
  Operand operand = comparison();
  if (times == 0) return operand;
  std::uint32_t node = truth(operand);
  if (times % 2 == 1) node = add(Op::no, node);
  return of(Operand::Type::truth, node, place);
}

Operand Parser::compare_names(const Operand& sort, const Operand& value, bool equal) {
  const NameSort of_sort = *sort_named(sort.word.spelling);
  const std::string sort_name(name(of_sort));
  if (value.word.spelling.empty()) {
    fail(value.place, sort_name + " is compared with a name.", suggestion("", all_names(of_sort)));
    return sort;
  }
  Node node;
  node.op = Op::named;
  const std::uint64_t mask = names_of(of_sort, value.word.spelling, true);
  node.masks[static_cast<std::size_t>(of_sort)] = mask;
  if (mask == 0)
    fail(value.place, "No " + sort_name + " is called " + value.word.spelling + ".",
         suggestion(value.word.spelling, all_names(of_sort)));
  std::uint32_t result = add(std::move(node));
  if (!equal) result = add(Op::no, result);
  return of(Operand::Type::truth, result, sort.place);
}

Operand Parser::comparison() {
  static constexpr std::array<std::pair<std::string_view, Op>, 6> operators{{{"==", Op::equal},
                                                                             {"!=", Op::different},
                                                                             {"<", Op::less},
                                                                             {"<=", Op::at_most},
                                                                             {">", Op::greater},
                                                                             {">=", Op::at_least}}};
  const Operand left = sum();
  if (error_) return left;
  for (const auto& [sign, op] : operators) {
    const std::size_t at = now().place;
    if (!take(sign)) continue;
    const Operand right = sum();
    if (error_) return left;
    const auto is_sort = [](const Operand& o) {
      return o.type == Operand::Type::word && sort_named(o.word.spelling).has_value();
    };
    if (is_sort(left) || is_sort(right)) {
      if (op != Op::equal && op != Op::different) {
        fail(at, "Names have no order.", "Compare them by == or !=.");
        return left;
      }
      return is_sort(left) ? compare_names(left, right, op == Op::equal)
                           : compare_names(right, left, op == Op::equal);
    }
    const std::uint32_t a = number(left), b = number(right);
    for (const auto& [again, other] : operators)
      if (now().is(again)) fail(now().place, "Comparisons cannot be chained.", "Write a < b && b < c.");
    return of(Operand::Type::truth, add(op, a, b), left.place);
  }
  return left;
}

Operand Parser::chain(Operand (Parser::*next)(), std::string_view sign, Op op, std::string_view other,
                      Op other_op) {
  Operand left = (this->*next)();
  while (!error_ && (now().is(sign) || now().is(other))) {
    const Op which = now().is(sign) ? op : other_op;
    ++at_;
    const std::uint32_t a = number(left), b = number((this->*next)());
    left = of(Operand::Type::number, add(which, a, b), left.place);
  }
  return left;
}

Operand Parser::factor() {
  const std::size_t place = now().place;
  int times = 0;
  while (take("-")) ++times;
  Operand operand = primary();
  if (times == 0) return operand;
  std::uint32_t node = number(operand);
  if (times % 2 == 1) node = add(Op::negate, node);
  return of(Operand::Type::number, node, place);
}

Operand Parser::primary() {
  const Token token = now();
  switch (token.kind) {
  case Token::Kind::number: {
    ++at_;
    Node node;
    node.op = Op::number;
    node.number = token.number;
    return of(Operand::Type::number, add(std::move(node)), token.place);
  }
  case Token::Kind::text:
    ++at_;
    return {Operand::Type::truth, says(token), token, token.place};
  case Token::Kind::word:
    if (ahead(1).is("(") || (token.spelling == "edge" && ahead(1).is_word("near"))) return form();
    ++at_;
    return {Operand::Type::word, 0, token, token.place};
  case Token::Kind::sign:
    if (take("(")) {
      Operand inner = either();
      if (!error_ && !take(")"))
        fail(now().place, "A closing parenthesis is missing.",
             "It belongs to the one at character " + std::to_string(token.place + 1) + ".");
      inner.place = token.place;
      return inner;
    }
    fail(token.place, "Something to compare or a name is missing before this.", "");
    break;
  case Token::Kind::end:
    fail(token.place, "The condition ends too soon.",
         "A number, a name or a form like vertex(17) is missing.");
    break;
  }
  return {Operand::Type::truth, 0, {}, token.place};
}

} // namespace grammar

ParsedQuery parse_query(std::string_view text) {
  auto tokens = tokenize(text);
  if (const auto* error = std::get_if<QueryError>(&tokens)) return *error;
  return grammar::Parser(grammar::with_titles(std::move(std::get<std::vector<Token>>(tokens)))).parse(text);
}

} // namespace isoscope
