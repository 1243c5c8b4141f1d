// Conditions over events as a small typed language: for breakpoints, filters and jumps (grammar.md).
#pragma once

#include "base/ids.h"
#include "journal/event.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace isoscope {

/// What is wrong with an expression, and where.
struct QueryError {
  std::size_t place = 0; ///< byte offset into the text; its length where the text ends too soon
  std::string message;   ///< a full sentence
  std::string remedy;    ///< what would be valid; may be empty
  /// Message, the text with a caret below the place, remedy: up to four lines.
  std::string picture(std::string_view text) const;
};

/// A number of an event, of the figures after it, or of the parameters in force. Unknown ones are NaN.
enum class Quantity : std::uint8_t {
  step,
  vertex,
  other,
  tet,
  sample,
  value,
  limit,
  count,
  ratio,
  sweeps,
  took,
  seconds,
  vertices,
  tets,
  bad_samples,
  largest_error,
  height,
  sigma,
  alpha,
  delta,
  shrink,
  genus,
  expected,
  components,
  euler,
  loops
};
constexpr int quantity_count = 26;
std::string_view name(Quantity quantity); ///< "bad_samples"
std::string_view help(Quantity quantity); ///< one sentence with the unit

/// How a sample stands: ε against 1 and 1 − α. `outside`: no tetrahedron holds it, or Z has left T.
enum class SampleClass : std::uint8_t { outside, good, margin, bad };
constexpr int sample_class_count = 4;
std::string_view name(SampleClass sample_class);

/// The four enumerations of an event by which it can be named.
enum class NameSort : std::uint8_t { stage, kind, condition, reason };
constexpr int name_sort_count = 4;
std::string_view name(NameSort sort);

/// A set of values of each sort, one bit a value.
using NameMasks = std::array<std::uint64_t, name_sort_count>;

/// What has to be followed over the journal for an expression to be judged; nothing for most of them.
struct QueryNeeds {
  bool topology = false;         ///< χ and components of Z
  bool positions = false;        ///< of the vertices
  bool stall = false;            ///< attempts since the last accepted operation
  std::vector<SampleId> samples; ///< their classes, ascending
  bool any() const { return topology || positions || stall || !samples.empty(); }
  void add(const QueryNeeds& other);
  friend bool operator==(const QueryNeeds&, const QueryNeeds&) = default;
};

/// A parsed and type-checked expression whose value is a truth. Immutable.
class Expression {
 public:
  enum class Op : std::uint8_t {
    number,
    quantity,
    negate,
    add,
    subtract,
    multiply,
    divide,
    equal,
    different,
    less,
    at_most,
    greater,
    at_least,
    everything,
    no,
    both,
    either,
    named,          ///< the event's value of one of the sorts is in the masks
    says,           ///< its sentence contains the text
    names_vertex,   ///< id a
    names_edge,     ///< ids a, b
    names_tet,      ///< id a
    names_sample,   ///< id a
    sample_is,      ///< class of sample a is one of the bits in `number`
    sample_changes, ///< class of sample a
    near,           ///< `point` within `number`
    edge_near,      ///< the same, only for events that name an edge
    stall           ///< `a` attempts
  };
  struct Node {
    Op op = Op::everything;
    Quantity quantity = Quantity::step;
    std::uint32_t a = 0, b = 0; ///< children, or ids
    double number = 0;
    Vec3 point;
    NameMasks masks{};
    std::string text;
  };
  Expression(std::string text, std::vector<Node> nodes);
  const std::string& text() const { return text_; }
  const QueryNeeds& needs() const { return needs_; }
  const Node& node(std::uint32_t i) const { return nodes_[i]; }
  std::uint32_t root() const { return static_cast<std::uint32_t>(nodes_.size() - 1); }

 private:
  std::string text_;
  std::vector<Node> nodes_; ///< children before parents; the last one is the root
  QueryNeeds needs_;
};

using ParsedQuery = std::variant<std::shared_ptr<const Expression>, QueryError>;
/// Reads an expression or filter words. An empty text lets everything pass.
ParsedQuery parse_query(std::string_view text);

} // namespace isoscope
