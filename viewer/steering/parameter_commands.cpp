// What is typed into the parameters' panel, by name, and what scripts read of the draft.
#include "steering/steering.h"

#include "command/commands.h"

namespace isoscope {
namespace {

using P = RunParameters;

/// Sets a number whatever its range is; false where the field holds none.
template <class T> bool take_number(T& value, double number) {
  if constexpr (std::is_same_v<T, Tolerance>)
    value.value = number, value.automatic = false;
  else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>)
    value = number;
  else
    return false;
  return true;
}

} // namespace

Status Steering::type_parameter(const std::string& parameter, const std::string& text) {
  if (Status may = may_set(parameter); !may) return may;
  P& draft = window.draft;
  const auto number = read_number<double>(text);
  bool typed = false;
  if (number)
    for_each_field<P>([&](const auto& f) {
      if (!f.words.empty() && f.script_name() == parameter) typed = take_number(draft.*(f.member), *number);
    });
  if (typed) return {};
  for (const NamedField<P>& f : named_fields<P>())
    if (f.name == parameter) return f.set(draft, text);
  return wrong_arguments("There is no parameter " + parameter + ".");
}

void Steering::add_parameter_commands(CommandTable& table) {
  table.add(
      {{.name = "type",
        .title = "Type a parameter…",
        .usage = "PARAMETER VALUE",
        .help = "Puts a value into the panel of the parameters as if it were typed there: one out of its "
                "range is shown in red and blocks Apply and Restart.",
        .run = [this](const Arguments& a) -> Status {
          if (a.size() != 2) return wrong_arguments("Which parameter, and what?");
          return type_parameter(a[0], a[1]);
        },
        .for_scripts = true}});
}

void Steering::add_plan_values(NamedValues& t) {
  t.add("apply.would", "what Apply would do: nothing, wrong, restart, too-late, go-on or branch",
        [this] { return plan().way; });
  t.add("apply.possible", "whether Apply would do something", [this] {
    const ApplyWay way = plan().way;
    return way == ApplyWay::go_on || way == ApplyWay::branch;
  });
  t.add("apply.step", "the step that it would go on from, too late: the last one that is not", [this] {
    const ApplyPlan p = plan();
    return p.step_known ? std::to_string(p.step) : std::string("nan");
  });
  t.add("apply.words", "the line that says so", [this] { return plan().words; });
  t.add("draft.differs", "whether the panel's parameters are not those of the run at the step shown",
        [this] { return draft_differs(); });
  t.add("draft.errors", "parameters of the panel that are out of their range", [this] {
    std::size_t wrong = 0;
    for_each_field<P>(
        [&](const auto& f) { wrong += check_field(f, "", window.draft.*(f.member)).ok() ? 0 : 1; });
    return wrong;
  });
  for_each_field<P>([&](const auto& f) {
    if (f.words.empty() || f.place == 0) return;
    t.add("draft.error." + f.script_name(), "what is wrong with it in the panel", [this, &f] {
      const Status right = check_field(f, std::string(f.symbol), window.draft.*(f.member));
      return right ? std::string("none") : right.error().message;
    });
  });
  const auto preview = t.readings(
      "preview.", [this] { return window.would_violate; }, "nan");
  preview("samples", "samples that would violate condition 1 with the panel's parameters",
          &ViolationPreview::beyond_margin);
  preview("flat", "tetrahedra that would violate condition 2", &ViolationPreview::too_flat);
  preview("misoriented", "tetrahedra that would violate condition 3", &ViolationPreview::misoriented);
  const auto foreseen = t.readings(
      "forecast.", [this] { return window.forecast; }, "nan");
  foreseen("from", "the step from which the rest of the run is foreseen", &Forecast::from);
  foreseen("seconds", "what it would take", &Forecast::seconds);
}

} // namespace isoscope
