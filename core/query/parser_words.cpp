// Words without signs of comparison, as one types them into a search box.
#include "query/grammar.h"

#include <algorithm>

namespace isoscope::grammar {

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

} // namespace isoscope::grammar
