// What the commands on the selection do, and their table.
#include "view/view.h"

#include "command/named_values.h"
#include "scene/pick_geometry.h"
#include "ui/icons.h"

#include <GLFW/glfw3.h>

#include <array>

namespace isoscope {
namespace {

Status pick_element(WindowState& m, const Arguments& a) {
  const auto state = m.state();
  const bool edge = !a.empty() && a[0] == "edge";
  if (a.size() != (edge ? 3 : 2) || !state) return wrong_arguments("A kind and a number are needed.");
  std::array<std::uint32_t, 2> ids{Pick().id, Pick().id};
  for (std::size_t i = 1; i < a.size(); ++i) {
    const auto id = whole_argument(a, i, 0);
    if (!id) return wrong_arguments("\"" + a[i] + "\" is not a number of an element.");
    ids.at(i - 1) = static_cast<std::uint32_t>(*id);
  }
  Pick pick;
  pick.id = ids[0];
  pick.other = ids[1];
  const Complex& t = state->complex;
  const Error absent{ErrorCode::usage, "There is no " + a[0] + " " + a[1] + " at this step.", ""};
  if (a[0] == "vertex") {
    if (pick.id >= t.vertices.size()) return absent;
    pick.kind = Pick::Kind::vertex;
    pick.point = t.vertices[pick.id].position;
  } else if (edge) {
    pick.kind = Pick::Kind::edge;
    const auto ends = edge_positions(*state, pick);
    if (!ends || pick.id == pick.other) return absent;
    pick.point = 0.5 * ((*ends)[0] + (*ends)[1]);
  } else if (a[0] == "facet") {
    pick.kind = Pick::Kind::facet;
    const Box3 box = pick_bounds(*state, pick);
    if (box.empty()) return absent;
    pick.point = box.center();
  } else if (a[0] == "tet") {
    if (pick.id >= t.tets.size() || !t.tets[pick.id].alive()) return absent;
    pick.kind = Pick::Kind::tet;
    const auto p = t.positions(TetId(pick.id));
    pick.point = 0.25 * (p[0] + p[1] + p[2] + p[3]);
  } else if (a[0] == "sample") {
    if (!state->samples || pick.id >= state->samples->size()) return absent;
    pick.kind = Pick::Kind::sample;
    pick.point = state->samples->positions[pick.id];
  } else if (a[0] == "over-rim") {
    if (!state->samples || pick.id >= state->samples->over_rim.size()) return absent;
    pick.kind = Pick::Kind::over_rim;
    pick.point = state->samples->over_rim[pick.id];
  } else if (a[0] == "point") {
    const auto& scene = m.run.scene;
    if (!scene || !scene->points || pick.id >= scene->points->points->points.size())
      return Error{ErrorCode::usage, "The input has no point " + a[1] + ".", ""};
    pick.kind = Pick::Kind::point;
    pick.point = scene->points->points->points[pick.id];
  } else {
    return wrong_arguments("\"" + a[0] + "\" is not a kind of element.");
  }
  m.selection.pick(pick);
  return {};
}

Status pick_worst(WindowState& m, const Arguments&) {
  const auto state = m.state();
  if (!state || !state->worst_sample.valid()) return usage("There is no sample yet.");
  return pick_element(m, {"sample", std::to_string(state->worst_sample.value)});
}

Status clear_selection(WindowState& m, const Arguments&) {
  if (m.overlay != Overlay::none)
    m.overlay = Overlay::none;
  else if (m.pane_of_keys != PaneOfKeys::none)
    m.pane_of_keys = PaneOfKeys::none;
  else if (m.range)
    m.range.reset();
  else if (m.presenter.on)
    m.presenter.on = false;
  else if (m.preview_delta)
    m.preview_delta.reset();
  else
    m.selection.pick({});
  return {};
}

struct KindCommand {
  const char *name, *title, *help;
  int key;
  PickKinds kinds;
};
constexpr std::array<KindCommand, 6> kind_commands{
    {{"kind-vertex", "Pick vertices only", "A click selects vertices alone; again for all kinds.", '1',
      PickKinds::vertices},
     {"kind-edge", "Pick edges only", "A click selects edges alone; again for all kinds.", '2',
      PickKinds::edges},
     {"kind-tet", "Pick cells only",
      "A click selects tetrahedra or, once Z is free, its facets alone; again for all kinds.", '3',
      PickKinds::tetrahedra},
     {"kind-sample", "Pick samples only", "A click selects samples alone; again for all kinds.", '4',
      PickKinds::samples},
     {"kind-point", "Pick points only", "A click selects points of the input alone; again for all kinds.",
      '9', PickKinds::points},
     {"kind-all", "Pick every kind", "A click selects whatever is nearest.", '0', PickKinds::all}}};

} // namespace

void add_pick_commands(CommandTable& table, WindowState& m) {
  const auto has_state = [&m] { return m.has_state(); };
  table.add({{.name = "pick",
              .title = "Select…",
              .usage = "vertex | tet | facet | sample | over-rim | point ID, edge ID ID",
              .help = "Selects an element by its number, an edge by its ends.",
              .run = on(m, pick_element),
              .enabled = has_state},
             {.name = "pick-worst",
              .title = "Select the worst sample",
              .help = "Selects the sample with the largest ε.",
              .menu = "Select",
              .icon = icon::target,
              .keys = {{'W'}},
              .run = on(m, pick_worst),
              .enabled = has_state}});
}

void add_selection_commands(CommandTable& table, WindowState& m) {
  table.add(
      {{.name = "clear",
        .title = "Clear the selection",
        .help =
            "Selects nothing; before that it closes what lies over the window, takes the keys back from a "
            "pane, ends the presenter mode and shows Ω at the run's δ again.",
        .menu = "Select",
        .keys = {{GLFW_KEY_ESCAPE}},
        .run = on(m, clear_selection)},
       {.name = "frame",
        .title = "Frame the selection",
        .help = "Moves the camera to what is selected, or to everything.",
        .menu = "Select",
        .icon = icon::search,
        .keys = {{'F'}},
        .run = does([&m] { m.requests.frame_selection = true; })}});
  for (const KindCommand& k : kind_commands)
    table.add({{.name = k.name,
                .title = k.title,
                .help = k.help,
                .menu = "Select",
                .keys = {{k.key}},
                .run = does([&m, kinds = k.kinds] {
                  PickKinds& now = m.selection.kinds;
                  now = now == kinds ? PickKinds::all : kinds;
                }),
                .checked = [&m, kinds = k.kinds] { return m.selection.kinds == kinds; }}});
}

} // namespace isoscope
