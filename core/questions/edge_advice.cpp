// From the value in force downwards to the first that works, then halving the gap.
#include "questions/edge_advice.h"

namespace isoscope {

std::vector<ParameterAdvice> advise_edge(const StateSnapshot& state, const EdgeQuestion& question,
                                         const XrayContext& context, const RunControl& control) {
  const auto now = edge_xray(state, question, context);
  if (!now) return {};
  using Parameter = ParameterAdvice::Parameter;
  std::vector<ParameterAdvice> out;
  const auto ask = [&](Parameter parameter, Condition condition, double CriteriaParameters::*member) {
    ParameterAdvice advice{parameter, condition, now->criteria.*member, now->attempt.possible(), {}, false};
    const auto possible = [&](double value) {
      XrayContext other = context;
      other.criteria = now->criteria;
      (*other.criteria).*member = value;
      const auto x = edge_xray(state, question, other);
      return x && x->attempt.possible();
    };
    double bad = advice.now;
    for (const double part : {0.9, 0.75, 0.5, 0.25, 0.1, 0.02}) {
      if (advice.holds || control.cancelled()) break;
      const double value = part * advice.now;
      if (!possible(value)) {
        bad = value;
        continue;
      }
      advice.works = value;
      for (int i = 0; i < 5; ++i) {
        const double middle = 0.5 * (*advice.works + bad);
        if (possible(middle))
          advice.works = middle;
        else
          bad = middle;
      }
      break;
    }
    out.push_back(advice);
  };
  if (!now->criteria.certified) ask(Parameter::alpha, Condition::classification, &CriteriaParameters::alpha);
  if (now->criteria.condition_3) ask(Parameter::shrink, Condition::orientation, &CriteriaParameters::shrink);
  return out;
}

} // namespace isoscope
