// Named values of the parameters that the panel shows.
#include "steering/steering.h"

namespace isoscope {
namespace {

void add_parameters(NamedValues& t, WindowState& m) {
  t.add_number("alpha", "α, margin of condition 1", m.draft.alpha, 0.01, 0.99);
  t.add_number("sigma", "σ/δ, density of the samples; 0 is the mode's own", m.draft.sigma, 0, 1);
  t.add_number("shrink", "factor of condition 3's copy", m.draft.shrink, 0.01, 1);
  t.add(
      "tolerance", "δ: a percentage of the longest edge, or a length",
      [&m] { return m.draft.tolerance.text(); },
      [&m](const std::string& text) -> Status {
        const auto tolerance = parse_tolerance(text);
        if (!tolerance) return tolerance.error();
        m.draft.tolerance = *tolerance;
        return {};
      });
  t.add_number("drop-small", "components of the input smaller than so many δ are left out; 0: none",
               m.draft.drop_small, 0, 1e6);
  t.add_choice("containment", "how Z is kept inside Ω", {"certified", "sampled"}, m.draft.containment);
  t.add_choice("topology", "what is asked of Z where Ω is no thickening", {"keep", "separate"},
               m.draft.topology);
  t.add_choice("sides", "what tells inside from outside", {"auto", "winding", "parity"}, m.draft.sides);
  t.add_switch("condition-1", "classification", m.draft.condition_1);
  t.add_switch("condition-2", "heights", m.draft.condition_2);
  t.add_switch("condition-3", "orientation", m.draft.condition_3);
  t.add_switch("condition-4", "topology", m.draft.condition_4);
}

void add_stages(NamedValues& t, WindowState& m) {
  t.add(
      "until", "the last stage; default: improve in certified mode, all in sampled mode",
      [&m] { return std::string(name(m.draft.last_stage())); },
      [&m](const std::string& text) -> Status {
        if (text == "default") {
          m.draft.until.reset();
          return {};
        }
        for (int i = static_cast<int>(Stage::refinement); i < stage_count; ++i)
          if (name(static_cast<Stage>(i)) == text) {
            m.draft.until = static_cast<Stage>(i);
            return {};
          }
        return wrong_value(text, "a stage, or default");
      });
  for (const Stage stage : {Stage::gamma, Stage::zero_set, Stage::all, Stage::improve}) {
    const auto i = static_cast<std::size_t>(stage);
    t.add_switch("skip." + std::string(name(stage)), "the stage is left out", m.draft.skipped[i]);
  }
  t.add(
      "cover", "how far the input may be from the result, in δ, or off",
      [&m] { return m.draft.cover ? text_of(*m.draft.cover) : std::string("off"); },
      [&m](const std::string& text) -> Status {
        const auto cover = parse_cover(text);
        if (!cover) return cover.error();
        m.draft.cover = *cover;
        return {};
      });
  t.add_switch("drop-thin", "parts thinner than twice the tolerance everywhere are left out",
               m.draft.drop_thin);
  t.add_choice("target", "how targets of collapses are looked for",
               {"optimum", "constraints", "sampling", "octree"}, m.draft.target);
  t.add_choice("cost-ring", "whose planes make the error of a collapse", {"one", "two"}, m.draft.cost_ring);
  t.add_number("effort", "of the improver, 0 to 3", m.draft.effort, 0, 3);
  t.add_choice("improver", "on Z alone or inside T", {"free", "embedded"}, m.draft.improver);
}

} // namespace

void Steering::add_parameter_values(NamedValues& values) {
  add_parameters(values, window);
  add_stages(values, window);
}

} // namespace isoscope
