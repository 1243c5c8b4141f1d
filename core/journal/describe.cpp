// The sentences of the vocabulary with an event's figures in their braces.
#include "journal/describe.h"

#include "base/numbers.h"

#include <cmath>
#include <string_view>

namespace isoscope {

namespace {

/// The audience hears fewer digits.
enum class Style : std::uint8_t { full, plain };

class Sentence {
 public:
  Sentence(const Journal& journal, const Event& event, Style style)
      : journal_(journal), e_(event), criteria_(journal.parameters_at(event.step)), style_(style) {}

  /// A text of the vocabulary with every figure filled in.
  std::string filled(std::string_view text) const {
    std::string out;
    const bool beside_limit = !plain() && text.find("{limit") != text.npos;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t open = text.find('{', at), close = text.find('}', open);
      out += text.substr(at, open - at);
      if (open == text.npos) break;
      const std::string_view what = text.substr(open + 1, close - open - 1);
      out += beside_limit ? figure_beside_limit(what) : figure(what);
      at = close + 1;
    }
    return out;
  }
  std::string whole_sentence() const {
    return filled(plain() ? words(e_.kind).plain : words(e_.kind).sentence);
  }

 private:
  bool plain() const { return style_ == Style::plain; }

  std::string number(double value, int digits) const {
    if (std::isinf(value)) return value > 0 ? "∞" : "−∞";
    if (std::isnan(value)) return "unknown";
    const std::string text = fixed(value, digits);
    return plain() && text.front() == '-' ? "−" + text.substr(1) : text;
  }
  std::string in_delta(double length, int more = 0) const {
    if (criteria_.delta > 0) return number(length / criteria_.delta, (plain() ? 2 : 3) + more) + " δ";
    return number(length, (plain() ? 2 : 6) + more);
  }
  std::string in_unit(double value, bool length, int more) const {
    return length ? in_delta(value, more) : number(value, 2 + more);
  }
  /// How many digits more than usual tell the value apart from the limit that stands beside it.
  int more_beside_limit(bool length) const {
    constexpr int most = 8;
    int more = 0;
    while (more < most && e_.value != e_.limit &&
           in_unit(e_.value, length, more) == in_unit(e_.limit, length, more))
      ++more;
    return more;
  }
  /// Two, or as many as show that a small number is not zero.
  static int digits_of(double value) {
    constexpr int most = 8;
    int digits = 2;
    while (digits < most && std::abs(value) > 0 && std::abs(value) < 0.5 * std::pow(10.0, -digits)) ++digits;
    return digits;
  }
  static std::string whole(double value) {
    if (!std::isfinite(value)) return "unknown";
    const long rounded = std::lround(value);
    return (rounded < 0 ? "−" : "") + std::to_string(std::abs(rounded));
  }
  static std::string element(const char* what, std::uint32_t id) {
    return std::string(what) + " " + (id == 0xffffffffu ? std::string("unknown") : std::to_string(id));
  }
  /// "facet 5–17–40", or "a facet" where none is named.
  std::string facet() const {
    if (!e_.facet[0].valid()) return "a facet";
    return "facet " + std::to_string(e_.facet[0].value) + "–" + std::to_string(e_.facet[1].value) + "–" +
           std::to_string(e_.facet[2].value);
  }
  /// What the reason says in a role that it may not have.
  std::string reason_as(ReasonRole role, std::string_view otherwise) const {
    const ReasonWords& reason = words(e_.reason);
    if (reason.role != role) return std::string(otherwise);
    return filled(plain() ? reason.plain : reason.sentence);
  }
  std::string expected() const {
    if (!std::isfinite(e_.limit)) return "";
    if (!plain()) return ", expected χ = " + whole(e_.limit);
    return e_.value == e_.limit ? ", as it should" : ", but χ = " + whole(e_.limit) + " is expected";
  }

  /// Of a sentence that names value and limit: what differs does not read alike.
  std::string figure_beside_limit(std::string_view what) const {
    if (what == "value") return in_unit(e_.value, false, more_beside_limit(false));
    if (what == "value δ") return in_unit(e_.value, true, more_beside_limit(true));
    if (what == "excess δ") return in_unit(e_.value - e_.limit, true, more_beside_limit(true));
    return figure(what);
  }
  std::string figure(std::string_view what) const {
    const ConditionWords& asked = words(e_.condition);
    if (what == "value") return number(e_.value, digits_of(e_.value));
    if (what == "limit") return number(e_.limit, 2);
    if (what == "value δ") return in_delta(e_.value);
    if (what == "limit δ") return in_delta(e_.limit);
    if (what == "excess δ") return in_delta(e_.value - e_.limit);
    if (what == "n") return std::to_string(e_.count);
    if (what.starts_with("n|")) {
      const std::size_t second = what.find('|', 2);
      return std::to_string(e_.count) + " " +
             std::string(e_.count == 1 ? what.substr(2, second - 2) : what.substr(second + 1));
    }
    if (what == "χ") return whole(e_.value);
    if (what == "expected") return expected();
    if (what == "edge")
      return "edge " + std::to_string(e_.vertex.value) + "–" + std::to_string(e_.other.value);
    if (what == "sample") return element("sample", e_.sample.value);
    if (what == "tet") return element("tetrahedron", e_.tet.value);
    if (what == "in tet") return e_.tet.valid() ? " in " + element("tetrahedron", e_.tet.value) : "";
    if (what == "facet") return facet();
    if (what == "at facet") return e_.facet[0].valid() ? " at " + facet() : "";
    if (what == "stage") return std::string(plain() ? words(e_.stage).plain : words(e_.stage).name);
    if (what == "insertion") return filled(plain() ? asked.plain_insertion : asked.insertion);
    if (what == "stays") return filled(plain() ? asked.plain_stays : asked.stays);
    if (what == "place") return reason_as(ReasonRole::place, "a point goes in");
    if (what == "why exhausted") return reason_as(ReasonRole::exhaustion, "no candidate is left");
    if (what == "target") return reason_as(ReasonRole::target, "a point");
    if (what == "why")
      return reason_as(ReasonRole::rejection,
                       plain() ? "the limit of work was reached" : "a limit of work was reached");
    if (what == "sweeps")
      return std::to_string(e_.detail < journal_.repairs().size() ? journal_.repairs()[e_.detail].size() : 0);
    if (what == "α") return number(criteria_.alpha, 2);
    if (what == "σ") return in_delta(criteria_.sigma);
    if (what == "shrink") return number(criteria_.shrink, 2);
    return "?";
  }

  const Journal& journal_;
  const Event& e_;
  const CriteriaParameters criteria_;
  const Style style_;
};

std::string note_of(const Journal& journal, const Event& e) {
  return e.text < journal.texts().size() ? journal.texts()[e.text] : std::string();
}

} // namespace

std::string describe_event(const Journal& journal, const Event& e) {
  const std::string sentence = Sentence(journal, e, Style::full).whole_sentence();
  const std::string note = note_of(journal, e);
  if (e.kind == EventKind::warning) return note.empty() ? sentence : note;
  return note.empty() ? sentence : sentence + ": " + note;
}

std::string describe(const Journal& journal, const Event& e) {
  const bool numbered = e.operation && e.kind != EventKind::warning;
  return (numbered ? std::to_string(e.step + 1) + " · " : "") + describe_event(journal, e);
}

std::string plain_words(const Journal& journal, const Event& e) {
  const std::string sentence = Sentence(journal, e, Style::plain).whole_sentence();
  switch (e.kind) {
  case EventKind::warning: {
    const std::string note = note_of(journal, e);
    return note.empty() ? sentence : note;
  }
  case EventKind::stage_begin:
  case EventKind::stage_end:
  case EventKind::stopped:
    return sentence;
  default:
    return std::string(words(e.stage).plain) + (e.operation ? " " + std::to_string(e.step + 1) : "") + ": " +
           sentence;
  }
}

Measure measure_of(const Event& e) {
  for (const Measure measure : {words(e.kind).measure, words(e.reason).measure})
    if (measure != Measure::none) return measure;
  return words(e.condition).measure;
}

} // namespace isoscope
