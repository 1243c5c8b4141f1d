// The query language: what parses is judged at every event of two journals.
#include "fuzz/target.h"
#include "journal/synthetic.h"
#include "query/expression.h"
#include "query/hand_made_events.h"
#include "query/search.h"

namespace isoscope::fuzz {

namespace {

const std::vector<std::shared_ptr<const Journal>>& journals() {
  static const auto made = [] {
    auto grown = std::make_shared<Journal>();
    test::record_insertions(*grown, 20, 30, 5);
    return std::vector<std::shared_ptr<const Journal>>{test::hand_made_events(), grown};
  }();
  return made;
}

std::vector<std::string> seeds() {
  return {"reject && reason == kernel_empty",
          "sample(12).class changes",
          "sample(1).class != good",
          "!(reject || insertion) && height < 2*sigma/alpha",
          "value - -limit >= 2*3/4 && genus != expected",
          "edge near (1, 2, 3) 0.25 || near(0, -1.5, 2e-3, .5)",
          "edge(3, 9) || vertex(17) || tet(5)",
          "+reject +(kernel normals) -halfedge",
          "\"no point sees\" && stall(3)",
          "zero-set kernel-empty normals",
          "((reject)) && took > 0.1 || bad_samples == 0 && components + euler > 1"};
}

bool accepts(std::string_view bytes) {
  const ParsedQuery parsed = parse_query(bytes);
  if (const auto* error = std::get_if<QueryError>(&parsed)) {
    require(error->place <= bytes.size(), "an error's place is outside the text");
    require(!error->message.empty(), "an error without a message");
    require(error->picture(bytes).find('^') != std::string::npos, "a picture without a caret");
    return false;
  }
  const auto& expression = std::get<std::shared_ptr<const Expression>>(parsed);
  require(expression != nullptr && expression->text() == bytes, "an expression that forgot its text");
  for (const auto& journal : journals()) {
    const auto end = static_cast<std::uint32_t>(complete_events(*journal));
    JournalWatch watch(journal, expression->needs());
    std::uint32_t last = 0;
    for (const std::uint32_t event : matches(*expression, *journal, 0, end, &watch)) {
      require(event < end && event >= last, "matches out of order");
      last = event;
    }
  }
  return true;
}

} // namespace

const Target& target() {
  static const Target made{"query",
                           seeds,
                           {"(",
                            ")",
                            "!",
                            "&&",
                            "||",
                            "==",
                            "!=",
                            "<",
                            ">=",
                            "+",
                            "-",
                            "*",
                            "/",
                            "1e308",
                            "1e400",
                            "4294967295",
                            "18446744073709551616",
                            "\"",
                            "near",
                            "stall(",
                            "edge(",
                            ".class",
                            " changes",
                            "genus",
                            "expected",
                            "value",
                            "reason",
                            "all",
                            " "},
                           accepts,
                           1 << 20,
                           1000};
  return made;
}

} // namespace isoscope::fuzz
