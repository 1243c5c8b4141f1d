// What looks like a call: edge(3, 9), near(x, y, z, r), sample(7).class changes.
#include "query/grammar.h"

#include <cmath>

namespace isoscope::grammar {

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

} // namespace isoscope::grammar
