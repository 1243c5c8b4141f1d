// The sentences, by stage, condition, reason and kind.
#include "talk/meaning.h"

#include <algorithm>
#include <array>

namespace isoscope {
namespace {

/// What is said of one value, and its figure.
template <class Value> struct Said {
  Value value;
  std::string_view why, figure = {};
};

template <class Value, std::size_t n>
const Said<Value>* find(const std::array<Said<Value>, n>& table, Value value) {
  const auto at =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.value == value; });
  return at == table.end() ? nullptr : &*at;
}

constexpr std::array<Said<Stage>, 8> stages{{
    {Stage::setup, "The samples of both boundaries say on which side each point has to come to lie.",
     "Figure 1"},
    {Stage::refinement, "Points go in where f is most wrong, until Z lies in Ω with the right topology.",
     "Figures 2 to 5"},
    {Stage::gamma, "Points around Z that no sample needs go away; what follows has more room then.",
     "Figure 8"},
    {Stage::tessellation, "Z is only a level of f so far; as facets of T its own edges can collapse.",
     "Figure 10"},
    {Stage::rim, "Nobody asks anything beyond the rim: Z has to be cut where the surface ends.", "Figure 15"},
    {Stage::zero_set, "Here most vertices go, the cheapest first, and nothing may leave Ω.",
     "Figures 11 and 12"},
    {Stage::all, "Collapses between Z and Γ leave Z as it is and make room for edges that were stuck.",
     "Figure 13"},
    {Stage::improve, "Without T around it Z can move freely, and more edges can go; each change is proven."},
}};

constexpr std::array<Said<Condition>, 7> conditions{{
    {Condition::none, "f is positive at all corners: there is no Z yet, and all samples inside are wrong."},
    {Condition::classification,
     "Where a sample is on the wrong side, Z has left Ω. At the new point f is right.", "Figure 3"},
    {Condition::height, "A flat tetrahedron makes f steep: between samples Z could leave Ω unseen.",
     "Figure 5"},
    {Condition::orientation, "All samples may be right while Z runs across Ω instead of along it.",
     "Figure 4"},
    {Condition::topology, "Collapses will keep the topology, so it has to be right before them."},
    {Condition::containment, "Samples are only points: it takes a proof for whole facets to keep Z in Ω."},
    {Condition::witness, "A thin region may lie between all samples; its deepest point speaks for it."},
}};

constexpr std::array<Said<Reason>, 15> rejections{{
    {Reason::link_condition, "Parts that are apart would be pressed together, and the topology would change.",
     "Figure 6"},
    {Reason::zero_link_condition, "T may allow what Z forbids: as a surface it would be pinched.",
     "Figure 6"},
    {Reason::kernel_empty,
     "Wherever the target was put, a tetrahedron would turn over. A neighbour may open the way.", "Figure 7"},
    {Reason::no_candidate, "Where all tetrahedra stay upright, none of the points that were asked lies.",
     "Figure 7"},
    {Reason::misclassified, "A sample that changes sides would mean that Z has crossed a boundary of Ω.",
     "Figure 9"},
    {Reason::outside_tolerance, "Here δ decides: a larger tolerance would let this edge go.", "Figure 12"},
    {Reason::unproven, "What cannot be proven is not done."},
    {Reason::normals, "Z would lie in Ω, but its facets would stand across the surface.", "Figure 4"},
    {Reason::witness_side, "A whole region would end up on the other side of Z, between all samples."},
    {Reason::intersection, "A mesh that cuts itself bounds nothing."},
    {Reason::folded, "Facets that lie over each other hide that Z has turned back."},
    {Reason::stays_above, "A collapse may leave Ω for a moment, but not for good: all of it is taken back."},
    {Reason::ineligible, "Another stage looks at this edge."},
    {Reason::border_distance, "Border and rim must be near each other both ways, or a part would be lost.",
     "Figure 15"},
    {Reason::budget, "The search ends somewhere; nothing is said of what was not looked at."},
}};

constexpr std::array<Said<EventKind>, 9> kinds{{
    {EventKind::topology_check,
     "With the right handles and parts Z can be deformed into the input within Ω."},
    {EventKind::departure,
     "Tetrahedra no longer limit what may move; facets are proven inside Ω themselves."},
    {EventKind::relaxation, "Farther from the boundary of Ω there is more room for collapses."},
    {EventKind::repair, "It left Ω for a moment; as its neighbours could be moved back, it stays."},
    {EventKind::shake,
     "Where nothing collapses any more, a detour over a worse mesh leads to a coarser one."},
    {EventKind::split, "Only where edges follow the wall over the rim can Z be cut along it.", "Figure 15"},
    {EventKind::cut, "Beyond the rim Z approximated nothing.", "Figure 15"},
    {EventKind::fill, "Outside of Ω by intent: the hole is closed as it was asked for.", "Figure 16"},
    {EventKind::exhausted, "It stays as it is; the certificate judges it at the end."},
}};

template <class Row> std::string_view why_of(const Row* row) {
  return row == nullptr ? std::string_view() : row->why;
}
template <class Row> std::string_view figure(const Row* row) {
  return row == nullptr ? std::string_view() : row->figure;
}

} // namespace

std::string_view meaning(Stage stage) {
  return why_of(find(stages, stage));
}

std::string_view meaning(const Event& e) {
  switch (e.kind) {
  case EventKind::insertion:
    return why_of(find(conditions, e.condition));
  case EventKind::rejection:
    return why_of(find(rejections, e.reason));
  case EventKind::stage_begin:
  case EventKind::collapse:
  case EventKind::tessellation:
    return meaning(e.stage);
  default:
    return why_of(find(kinds, e.kind));
  }
}

std::string_view figure_of(Stage stage) {
  return figure(find(stages, stage));
}

std::string_view figure_of(const Event& e) {
  std::string_view own;
  if (e.kind == EventKind::insertion) own = figure(find(conditions, e.condition));
  if (e.kind == EventKind::rejection) own = figure(find(rejections, e.reason));
  if (own.empty()) own = figure(find(kinds, e.kind));
  return own.empty() ? figure_of(e.stage) : own;
}

} // namespace isoscope
