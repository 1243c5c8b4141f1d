// What an expression needs, and the picture of an error.
#include "query/expression.h"

#include "base/sort_unique.h"

#include <algorithm>
#include <utility>

namespace isoscope {

std::string QueryError::picture(std::string_view text) const {
  // The caret goes by characters, not by bytes of UTF-8.
  const std::string_view before = text.substr(0, std::min(place, text.size()));
  const auto column = static_cast<std::size_t>(std::count_if(
      before.begin(), before.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
  std::string picture = message + "\n  " + std::string(text) + "\n  " + std::string(column, ' ') + "^";
  if (!remedy.empty()) picture += "\n" + remedy;
  return picture;
}

void QueryNeeds::add(const QueryNeeds& other) {
  topology |= other.topology;
  positions |= other.positions;
  stall |= other.stall;
  samples.insert(samples.end(), other.samples.begin(), other.samples.end());
  sort_unique(samples);
}

Expression::Expression(std::string text, std::vector<Node> nodes)
    : text_(std::move(text)), nodes_(std::move(nodes)) {
  for (const Node& n : nodes_) {
    switch (n.op) {
    case Op::quantity:
      needs_.topology |= n.quantity == Quantity::genus || n.quantity == Quantity::components ||
                         n.quantity == Quantity::euler || n.quantity == Quantity::expected ||
                         n.quantity == Quantity::loops;
      break;
    case Op::near:
    case Op::edge_near:
      needs_.positions = true;
      break;
    case Op::stall:
      needs_.stall = true;
      break;
    case Op::sample_is:
    case Op::sample_changes:
      needs_.samples.push_back(SampleId(n.a));
      break;
    default:
      break;
    }
  }
  sort_unique(needs_.samples);
}

} // namespace isoscope
