// Recursive descent with types: a word becomes a truth, a number or a name where its neighbours decide.
#include "query/expression.h"
#include "query/names.h"
#include "query/tokens.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace isoscope {
namespace {

using Node = Expression::Node;
using Op = Expression::Op;
constexpr int deepest = 200;

/// What was read so far: a node of known type, or a word whose type is still open.
struct Operand {
  enum class Type : std::uint8_t { truth, number, word };
  Type type = Type::truth;
  std::uint32_t node = 0;
  Token word;
  std::size_t place = 0;
};

class Parser {
 public:
  explicit Parser(std::vector<Token> tokens) : tokens_(std::move(tokens)) {}

  ParsedQuery parse(std::string_view text) {
    if (now().kind == Token::Kind::end) {
      add({});
    } else if (is_words()) {
      words();
    } else {
      truth(either());
      if (!error_ && now().kind != Token::Kind::end)
        fail(now().place, "The condition ends before this.", "Join conditions by && or ||.");
    }
    if (error_) return *error_;
    return std::make_shared<const Expression>(std::string(text), std::move(nodes_));
  }

 private:
  const Token& now() const { return tokens_[at_]; }
  const Token& ahead(std::size_t n) const { return tokens_[std::min(at_ + n, tokens_.size() - 1)]; }
  bool take(std::string_view sign) {
    if (!now().is(sign)) return false;
    ++at_;
    return true;
  }
  void fail(std::size_t place, std::string message, std::string remedy) {
    if (!error_) error_ = QueryError{place, std::move(message), std::move(remedy)};
  }
  std::uint32_t add(Node node) {
    nodes_.push_back(std::move(node));
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  std::uint32_t add(Op op, std::uint32_t a, std::uint32_t b = 0) {
    Node node;
    node.op = op;
    node.a = a;
    node.b = b;
    return add(std::move(node));
  }
  Operand of(Operand::Type type, std::uint32_t node, std::size_t place) const {
    return {type, node, {}, place};
  }

  // Types.
  static bool is_all(const Token& token) { return token.is_word("all"); }
  std::uint32_t named(const Token& token);
  /// Its sentence says so, or that is what the screen calls it.
  std::uint32_t says(const Token& token) {
    Node node;
    node.op = Op::says;
    node.text = token.spelling;
    const std::uint32_t said = add(std::move(node));
    const std::string title = as_name(token.spelling);
    if (!is_title(title)) return said;
    Node called;
    called.op = Op::named;
    called.masks = names_of(title);
    return add(Op::either, said, add(std::move(called)));
  }
  std::uint32_t truth(const Operand& operand);
  std::uint32_t number(const Operand& operand);

  // Levels, from the loosest.
  Operand either();
  Operand both();
  Operand negated();
  Operand comparison();
  Operand compare_names(const Operand& sort, const Operand& value, bool equal);
  Operand sum() { return chain(&Parser::product, "+", Op::add, "-", Op::subtract); }
  Operand product() { return chain(&Parser::factor, "*", Op::multiply, "/", Op::divide); }
  /// Numbers joined by one of two signs.
  Operand chain(Operand (Parser::*next)(), std::string_view sign, Op op, std::string_view other, Op other_op);
  Operand factor();
  Operand primary();

  // Forms.
  Operand form();
  Operand sample_form(std::size_t place);
  Operand edge_near(std::size_t place);
  double signed_number();
  Vec3 point(std::string_view form);
  std::uint32_t id();
  void expect(std::string_view sign, std::string_view after);

  // Words.
  bool is_words() const;
  void words();
  std::uint32_t word_group();

  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::vector<Node> nodes_;
  std::optional<QueryError> error_;
};

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

double Parser::signed_number() {
  const bool negative = take("-");
  if (now().kind != Token::Kind::number) {
    fail(now().place, "A number is asked for here.", "");
    return 0;
  }
  const double value = now().number;
  ++at_;
  return negative ? -value : value;
}

Vec3 Parser::point(std::string_view form) {
  Vec3 p;
  for (int a = 0; a < 3; ++a) {
    if (a > 0) expect(",", form);
    p[a] = signed_number();
  }
  return p;
}

std::uint32_t Parser::id() {
  const std::size_t place = now().place;
  const double value = signed_number();
  if (value < 0 || value > 4e9 || value != std::floor(value)) {
    fail(place, "A whole number is asked for here.", "");
    return 0;
  }
  return static_cast<std::uint32_t>(value);
}

void Parser::expect(std::string_view sign, std::string_view after) {
  if (!take(sign))
    fail(now().place, std::string(sign) + " is missing here.", "It is written so: " + std::string(after));
}

Operand Parser::edge_near(std::size_t place) {
  constexpr std::string_view form = "edge near (x, y, z) r";
  Node node;
  node.op = Op::edge_near;
  expect("(", form);
  node.point = point(form);
  expect(")", form);
  node.number = signed_number();
  return of(Operand::Type::truth, add(std::move(node)), place);
}

Operand Parser::sample_form(std::size_t place) {
  constexpr std::string_view form = "sample(7).class changes, or .class == bad";
  expect("(", form);
  Node node;
  node.op = Op::names_sample;
  node.a = id();
  expect(")", form);
  bool different = false;
  if (!error_ && take(".")) {
    if (!now().is_word("class")) {
      fail(now().place, "Of a sample only .class can be asked.", "It is written so: " + std::string(form));
      return {};
    }
    ++at_;
    if (now().is_word("changes")) {
      ++at_;
      node.op = Op::sample_changes;
    } else if (now().is("==") || now().is("!=")) {
      different = now().is("!=");
      ++at_;
      const auto found = sample_class_named(now().spelling);
      if (!found)
        fail(now().place, "No class of samples is called so.",
             suggestion(now().spelling, {{"good", {}}, {"margin", {}}, {"bad", {}}, {"outside", {}}}));
      else
        node.number = static_cast<double>(1u << static_cast<unsigned>(*found));
      ++at_;
      node.op = Op::sample_is;
    } else {
      fail(now().place, "What about the class?", "It is written so: " + std::string(form));
    }
  }
  std::uint32_t result = add(std::move(node));
  if (different) result = add(Op::no, result);
  return of(Operand::Type::truth, result, place);
}

Operand Parser::form() {
  const Token word = now();
  ++at_;
  if (word.spelling == "edge" && now().is_word("near")) {
    ++at_;
    return edge_near(word.place);
  }
  if (word.spelling == "sample") return sample_form(word.place);
  Node node;
  take("(");
  if (word.spelling == "vertex" || word.spelling == "tet") {
    node.op = word.spelling == "tet" ? Op::names_tet : Op::names_vertex;
    node.a = id();
    expect(")", word.spelling + "(17)");
  } else if (word.spelling == "edge") {
    node.op = Op::names_edge;
    node.a = id();
    expect(",", "edge(3, 9)");
    node.b = id();
    expect(")", "edge(3, 9)");
  } else if (word.spelling == "near") {
    constexpr std::string_view form = "near(x, y, z, r)";
    node.op = Op::near;
    node.point = point(form);
    expect(",", form);
    node.number = signed_number();
    expect(")", form);
  } else if (word.spelling == "stall") {
    const std::size_t place = now().place;
    node.op = Op::stall;
    node.a = id();
    if (node.a == 0) fail(place, "A stall takes at least one attempt.", "It is written so: stall(500)");
    expect(")", "stall(500)");
  } else {
    fail(
        word.place, "There is no form " + word.spelling + "(…).",
        suggestion(word.spelling,
                   {{"vertex", {}}, {"edge", {}}, {"tet", {}}, {"sample", {}}, {"near", {}}, {"stall", {}}}));
  }
  return of(Operand::Type::truth, add(std::move(node)), word.place);
}

// Words: signs only before a word or a group, nothing else; and at least one sign or two words beside each
// other, since a word alone is a condition anyway.
bool Parser::is_words() const {
  bool sign_or_two = false, in_group = false;
  for (std::size_t i = 0; tokens_[i].kind != Token::Kind::end; ++i) {
    const Token& t = tokens_[i];
    const bool word = t.kind == Token::Kind::word || t.kind == Token::Kind::text;
    const Token& next = tokens_[i + 1];
    const bool before_word = next.kind == Token::Kind::word || next.kind == Token::Kind::text;
    if (word) {
      if (!in_group && next.is("(")) return false;
      // "edge near" is a form.
      if (t.is_word("edge") && next.is_word("near")) return false;
      sign_or_two |= before_word;
    } else if (t.is("+") || t.is("-")) {
      // Between two words a sign has a blank before it and none after it; else it is arithmetic.
      if (in_group || !(before_word || next.is("(")) || next.place != t.place + 1) return false;
      sign_or_two = true;
    } else if (t.is("(")) {
      if (in_group || !before_word) return false;
      in_group = true;
    } else if (t.is(")")) {
      if (!in_group) return false;
      in_group = false;
    } else {
      return false;
    }
  }
  return sign_or_two;
}

std::uint32_t Parser::word_group() {
  const bool group = take("(");
  std::optional<std::uint32_t> all;
  while (now().kind == Token::Kind::word || now().kind == Token::Kind::text) {
    const Token token = now();
    ++at_;
    const std::uint32_t one = token.kind == Token::Kind::text ? says(token) : named(token);
    all = all ? add(Op::either, *all, one) : one;
    if (!group) break;
  }
  if (group && !take(")")) fail(now().place, "A closing parenthesis is missing.", "");
  return all ? *all : add({});
}

void Parser::words() {
  std::optional<std::uint32_t> all;
  NameMasks plain{};
  const auto join = [&](std::uint32_t node) { all = all ? add(Op::both, *all, node) : node; };
  while (!error_ && now().kind != Token::Kind::end) {
    if (take("-")) {
      join(add(Op::no, word_group()));
    } else if (take("+")) {
      join(word_group());
    } else if (now().kind == Token::Kind::word && !is_all(now())) {
      const std::uint32_t node = named(now());
      ++at_;
      const NameMasks masks = nodes_[node].masks;
      // The beginning of names of several sorts stands for any of them.
      if (std::count(masks.begin(), masks.end(), std::uint64_t{0}) + 1 < name_sort_count) {
        join(node);
        continue;
      }
      for (std::size_t s = 0; s < plain.size(); ++s) plain[s] |= masks[s];
      nodes_.pop_back();
    } else {
      join(word_group());
    }
  }
  for (std::size_t s = 0; s < plain.size(); ++s) {
    if (plain[s] == 0) continue;
    Node node;
    node.op = Op::named;
    node.masks[s] = plain[s];
    join(add(std::move(node)));
  }
  if (!all) all = add({});
}

} // namespace

ParsedQuery parse_query(std::string_view text) {
  auto tokens = tokenize(text);
  if (const auto* error = std::get_if<QueryError>(&tokens)) return *error;
  return Parser(with_titles(std::move(std::get<std::vector<Token>>(tokens)))).parse(text);
}

} // namespace isoscope
