// What is an expression, and where a wrong one is wrong.
#include "query/expression.h"

#include <doctest/doctest.h>

#include <string>

using namespace isoscope;

namespace {

struct Wrong {
  std::string text;
  std::size_t place;
  std::string says; ///< part of message and remedy
};

} // namespace

TEST_CASE("expressions that are right") {
  for (const char* text : {"",
                           "  ",
                           "reject",
                           "rejection",
                           "collapse && reason == halfedge",
                           "reason == kernel_empty",
                           "reason==kernel-empty",
                           "reject && reason == kernel_empty",
                           "stage == zero_set",
                           "stage == all",
                           "zero-set",
                           "condition != none",
                           "kind == repair || kind == relaxation",
                           "!(reject || insertion)",
                           "!!reject",
                           "value > limit",
                           "value-limit > 0",
                           "value - -limit >= 2*3/4",
                           "height < 2*sigma/alpha",
                           "genus != expected",
                           "(value + 1) * 2 < limit",
                           "((reject))",
                           "sample(4412).class changes",
                           "sample(1).class == bad",
                           "sample(1).class != good",
                           "sample(7)",
                           "vertex(17)",
                           "edge(3, 9)",
                           "tet(5)",
                           "near(0, -1.5, 2e-3, .5)",
                           "edge near (1, 2, 3) 0.25",
                           "stall(500)",
                           "took > 0.1",
                           "bad_samples == 0",
                           "bad-samples == 0",
                           "\"no point sees\"",
                           "reject && !\"kernel\"",
                           "all",
                           "+reject +(kernel normals) -halfedge",
                           "zero-set kernel-empty normals",
                           "-halfedge",
                           "+\"shrunk\" rejection",
                           "Reject && Reason == Kernel_Empty",
                           "step >= 3 && step <= 8"}) {
    CAPTURE(text);
    const ParsedQuery parsed = parse_query(text);
    const auto* error = std::get_if<QueryError>(&parsed);
    CHECK_MESSAGE(error == nullptr, (error != nullptr ? error->picture(text) : ""));
  }
}

TEST_CASE("a wrong expression says where and what would be right") {
  const std::vector<Wrong> cases{
      {"rejct", 0, "Did you mean rejection?"},
      {"reject && reason == kernl_empty", 20, "Did you mean kernel-empty?"},
      {"stage == zeroset", 9, "Did you mean zero-set?"},
      {"stage == kernel-empty", 9, "No stage is called kernel-empty"},
      {"reason == 3", 10, "reason is compared with a name"},
      {"reason < normals", 7, "no order"},
      {"reason", 0, "reason == "},
      {"value", 0, "Compare it: value > 0"},
      {"reject && value", 10, "value is a number"},
      {"valu > 3", 0, "Did you mean value?"},
      {"value > reject", 8, "reject is a name, not a number"},
      {"value >", 7, "ends too soon"},
      {"value > 3 < 4", 10, "cannot be chained"},
      {"(value > 3", 10, "closing parenthesis"},
      {"value > 3)", 9, "The condition ends before this"},
      {"value > 3 reject", 10, "&&"},
      {"&& reject", 0, "missing before this"},
      {"value = 3", 6, "Write == to compare"},
      {"reject & collapse", 7, "Write &&"},
      {"reject | collapse", 7, "Write ||"},
      {"value > $3", 8, "no meaning"},
      {"\"open", 0, "closing quote"},
      {"3x > 2", 1, "letter follows a number"},
      {"1e999 > 2", 0, "too large"},
      {"vertex(", 7, "number is asked for"},
      {"vertex(1.5)", 7, "whole number"},
      {"vertex(17", 9, "vertex(17)"},
      {"edge(3)", 6, "edge(3, 9)"},
      {"edge near (1, 2) 3", 15, "edge near (x, y, z) r"},
      {"near(1,2,3)", 10, "near(x, y, z, r)"},
      {"sample(3).label", 10, "only .class"},
      {"sample(3).class", 15, "changes"},
      {"sample(3).class == rotten", 19, "good, margin, bad"},
      {"stall(0)", 6, "at least one"},
      {"stal(3)", 0, "Did you mean stall?"},
      {"3", 0, "a number, where a condition is asked for"},
      {"!value", 1, "Compare it"},
      {"(reject) + 1 > 2", 1, "reject is a name, not a number"},
      {"(value > 1) + 1 > 2", 0, "a number is asked for"},
      {"+reject -halfedg3x", 9, "Nothing is called halfedg3x"},
      {"δ > 3", 0, "No number is called δ"},
      {"≤ 3", 0, "no meaning"},
      {"reason == Ω", 10, "Did you mean outside-tolerance (outside Ω)?"},
      {"reason == outsid_Ω", 10, "Did you mean outside-tolerance (outside Ω)?"},
      {"reason == xy", 10, "Valid here: "},
  };
  for (const Wrong& wrong : cases) {
    CAPTURE(wrong.text);
    const ParsedQuery parsed = parse_query(wrong.text);
    const auto* error = std::get_if<QueryError>(&parsed);
    REQUIRE(error != nullptr);
    CAPTURE(error->picture(wrong.text));
    CHECK(error->place == wrong.place);
    CHECK((error->message + " " + error->remedy).find(wrong.says) != std::string::npos);
  }
}

TEST_CASE("the caret stands below the place, by characters") {
  const std::string text = "\"δδ\" && valu > 3";
  const auto error = std::get<QueryError>(parse_query(text));
  CHECK(error.picture(text) ==
        "No number is called valu.\n  \"δδ\" && valu > 3\n          ^\nDid you mean value?");
}

TEST_CASE("nesting is bounded") {
  const std::string deep(100000, '(');
  CHECK(std::holds_alternative<QueryError>(parse_query(deep + "reject")));
  const std::string shallow = std::string(50, '(') + "reject" + std::string(50, ')');
  CHECK(!std::holds_alternative<QueryError>(parse_query(shallow)));
}

TEST_CASE("only what is asked for is needed") {
  const auto needs = [](const char* text) {
    return std::get<std::shared_ptr<const Expression>>(parse_query(text))->needs();
  };
  CHECK(!needs("reject && reason == kernel_empty && height < 2*sigma/alpha && took > 1").any());
  CHECK(needs("genus != expected").topology);
  CHECK(!needs("genus != expected").positions);
  CHECK(needs("edge near (0,0,0) 1").positions);
  CHECK(needs("stall(3)").stall);
  CHECK(needs("sample(9).class changes || sample(4).class == bad || sample(9).class == good").samples ==
        std::vector<SampleId>{SampleId(4), SampleId(9)});
}
