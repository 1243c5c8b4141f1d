// The value of an expression at an event.
#include "base/folded.h"
#include "journal/describe.h"
#include "query/watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isoscope {
namespace {

using Node = Expression::Node;
using Op = Expression::Op;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

template <class Tag> double number_of(Id<Tag> id) {
  return id.valid() ? static_cast<double>(id.value) : unknown;
}

double distance_to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const Vec3 ab = b - a;
  const double square = dot(ab, ab);
  const double t = square > 0 ? std::clamp(dot(p - a, ab) / square, 0.0, 1.0) : 0.0;
  return length(p - (a + t * ab));
}

/// One event with what surrounds it.
class Evaluation {
 public:
  Evaluation(const Expression& expression, const Journal& journal, std::uint32_t index,
             const JournalWatch* watch)
      : expression_(expression), journal_(journal), event_(journal.events()[index]), watch_(watch) {}

  bool truth(std::uint32_t i) const;

 private:
  double number(std::uint32_t i) const;
  double quantity(Quantity quantity) const;
  double of_figures(Quantity quantity) const;
  double of_parameters(Quantity quantity) const;
  double of_topology(Quantity quantity) const;
  double took() const;
  bool named(const NameMasks& masks) const;
  bool near(const Node& node, bool edges_only) const;
  const StepFigures* figures() const {
    const Step after = step_showing(event_);
    return after == 0 || after > journal_.operations().size() ? nullptr
                                                              : &journal_.operations()[after - 1].figures;
  }

  const Expression& expression_;
  const Journal& journal_;
  const Event& event_;
  const JournalWatch* watch_;
};

double Evaluation::took() const {
  if (!event_.operation || event_.step >= journal_.operations().size()) return unknown;
  const double until = journal_.operations()[event_.step].figures.seconds;
  if (event_.step == 0) return until;
  const Operation& before = journal_.operations()[event_.step - 1];
  // A stage has a clock of its own, also where it begins again.
  const double from = before.figures.seconds;
  return journal_.events()[before.event].stage == event_.stage && from <= until ? until - from : until;
}

double Evaluation::of_figures(Quantity quantity) const {
  const StepFigures* f = figures();
  if (f == nullptr) return unknown;
  switch (quantity) {
  case Quantity::seconds:
    return f->seconds;
  case Quantity::vertices:
    return f->zero_set_vertices;
  case Quantity::tets:
    return f->tets;
  case Quantity::bad_samples:
    return f->bad_samples;
  case Quantity::largest_error:
    return f->largest_error;
  default: // height: the figure is in units of δ
    return f->smallest_height * journal_.parameters_at(event_.step).delta;
  }
}

double Evaluation::of_parameters(Quantity quantity) const {
  const CriteriaParameters p = journal_.parameters_at(event_.step);
  switch (quantity) {
  case Quantity::sigma:
    return p.sigma;
  case Quantity::alpha:
    return p.alpha;
  case Quantity::delta:
    return p.delta;
  default:
    return p.shrink;
  }
}

double Evaluation::of_topology(Quantity quantity) const {
  if (watch_ == nullptr) return unknown;
  if (quantity == Quantity::expected) return watch_->expected_genus();
  if (!watch_->has_topology() || watch_->components() == 0) return unknown;
  const auto components = static_cast<double>(watch_->components());
  const auto euler = static_cast<double>(watch_->euler_characteristic());
  const auto loops = static_cast<double>(watch_->boundary_loops());
  return quantity == Quantity::components ? components
         : quantity == Quantity::euler    ? euler
         : quantity == Quantity::loops    ? loops
                                          : components - (euler + loops) / 2;
}

double Evaluation::quantity(Quantity quantity) const {
  switch (quantity) {
  case Quantity::step:
    return event_.step;
  case Quantity::vertex:
    return number_of(event_.vertex);
  case Quantity::other:
    return number_of(event_.other);
  case Quantity::tet:
    return number_of(event_.tet);
  case Quantity::sample:
    return number_of(event_.sample);
  case Quantity::value:
    return event_.value;
  case Quantity::limit:
    return event_.limit;
  case Quantity::count:
    return event_.count;
  case Quantity::ratio:
    return event_.limit == 0 ? unknown : event_.value / event_.limit;
  case Quantity::sweeps:
    return static_cast<double>(journal_.repairs()[event_.detail].size());
  case Quantity::took:
    return took();
  case Quantity::seconds:
  case Quantity::vertices:
  case Quantity::tets:
  case Quantity::bad_samples:
  case Quantity::largest_error:
  case Quantity::height:
    return of_figures(quantity);
  case Quantity::sigma:
  case Quantity::alpha:
  case Quantity::delta:
  case Quantity::shrink:
    return of_parameters(quantity);
  case Quantity::genus:
  case Quantity::expected:
  case Quantity::components:
  case Quantity::euler:
  case Quantity::loops:
    return of_topology(quantity);
  }
  return unknown;
}

double Evaluation::number(std::uint32_t i) const {
  const Node& n = expression_.node(i);
  switch (n.op) {
  case Op::number:
    return n.number;
  case Op::quantity:
    return quantity(n.quantity);
  case Op::negate:
    return -number(n.a);
  case Op::add:
    return number(n.a) + number(n.b);
  case Op::subtract:
    return number(n.a) - number(n.b);
  case Op::multiply:
    return number(n.a) * number(n.b);
  case Op::divide:
    return number(n.a) / number(n.b);
  default:
    return unknown;
  }
}

bool Evaluation::named(const NameMasks& masks) const {
  const std::array<std::size_t, name_sort_count> values{
      static_cast<std::size_t>(event_.stage), static_cast<std::size_t>(event_.kind),
      static_cast<std::size_t>(event_.condition), static_cast<std::size_t>(event_.reason)};
  for (std::size_t s = 0; s < values.size(); ++s)
    if ((masks[s] >> values[s] & 1u) != 0) return true;
  return false;
}

bool Evaluation::near(const Node& node, bool edges_only) const {
  if (watch_ != nullptr)
    if (const auto edge = watch_->edge())
      return distance_to_segment(node.point, (*edge)[0], (*edge)[1]) <= node.number;
  if (edges_only || (event_.kind != EventKind::insertion && event_.kind != EventKind::collapse)) return false;
  return length(node.point - event_.point) <= node.number;
}

bool Evaluation::truth(std::uint32_t i) const {
  const Node& n = expression_.node(i);
  switch (n.op) {
  case Op::everything:
    return true;
  case Op::no:
    return !truth(n.a);
  case Op::both:
    return truth(n.a) && truth(n.b);
  case Op::either:
    return truth(n.a) || truth(n.b);
  case Op::equal:
    return number(n.a) == number(n.b);
  case Op::different: {
    const double a = number(n.a), b = number(n.b);
    return a < b || a > b; // not with what is unknown
  }
  case Op::less:
    return number(n.a) < number(n.b);
  case Op::at_most:
    return number(n.a) <= number(n.b);
  case Op::greater:
    return number(n.a) > number(n.b);
  case Op::at_least:
    return number(n.a) >= number(n.b);
  case Op::named:
    return named(n.masks);
  case Op::says:
    return contains_folded(describe(journal_, event_), n.text);
  case Op::names_vertex:
    return event_.vertex == VertexId(n.a) || event_.other == VertexId(n.a);
  case Op::names_edge:
    return (event_.vertex == VertexId(n.a) && event_.other == VertexId(n.b)) ||
           (event_.vertex == VertexId(n.b) && event_.other == VertexId(n.a));
  case Op::names_tet:
    return event_.tet == TetId(n.a);
  case Op::names_sample:
    return event_.sample == SampleId(n.a);
  case Op::sample_is:
    return watch_ != nullptr &&
           (static_cast<unsigned>(n.number) >> static_cast<unsigned>(watch_->sample_class(SampleId(n.a))) &
            1u) != 0;
  case Op::sample_changes:
    return watch_ != nullptr && watch_->sample_changed(SampleId(n.a));
  case Op::near:
    return near(n, false);
  case Op::edge_near:
    return near(n, true);
  case Op::stall:
    return watch_ != nullptr && watch_->stalled() > 0 && watch_->stalled() % n.a == 0;
  default:
    return false;
  }
}

} // namespace

bool holds(const Expression& expression, const Journal& journal, std::uint32_t event,
           const JournalWatch* watch) {
  return Evaluation(expression, journal, event, watch).truth(expression.root());
}

} // namespace isoscope
