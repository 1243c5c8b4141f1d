// The grammar of queries as a parser of recursive descent, in three files: types and levels, forms, words.
#pragma once

#include "query/expression.h"
#include "query/names.h"
#include "query/tokens.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isoscope::grammar {

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

/// Reads one query; what is wrong first ends it.
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

} // namespace isoscope::grammar
