// The worker's question, the table of maps, their commands and values.
#include "view/zero_maps.h"

#include "scene/view_fields.h"

#include <array>

namespace isoscope {
namespace {

constexpr std::array<ZeroMapWords, zero_map_count> maps{
    {{ZeroMapKind::none, "none", "nothing", "", "Z in its own colour."},
     {ZeroMapKind::distance, "distance", "distance d/δ", "δ",
      "How far Z is from the input, of the tolerance. The limit is 1."},
     {ZeroMapKind::normals, "normals", "deviation of normals", "°",
      "The angle between the normal of Z and that of the closest input triangle. Figure 26"},
     {ZeroMapKind::valence, "valence", "valence", "edges", "Edges of Z at each vertex; 6 is regular."},
     {ZeroMapKind::age, "age", "age of facets", "steps",
      "Steps since each facet was made or moved: bright is old."}}};

Status choose_map(WindowState& m, const Arguments& a) {
  if (a.empty()) {
    m.view.zero_map = static_cast<ZeroMapKind>((static_cast<int>(m.view.zero_map) + 1) % zero_map_count);
    return {};
  }
  for (const ZeroMapWords& map : maps)
    if (map.name == a[0]) {
      m.view.zero_map = map.kind;
      return {};
    }
  return wrong_arguments("\"" + a[0] + "\" is nothing that Z can be coloured by.");
}

} // namespace

const ZeroMapWords& words(ZeroMapKind kind) {
  return maps.at(static_cast<std::size_t>(kind));
}

ZeroMaps::ZeroMaps(WindowState& shared, std::function<void()> notify)
    : window(shared), worker_(
                          [](const Question& q, RunControl& control) -> std::shared_ptr<const ZeroMap> {
                            auto map = zero_map(*q.state, *q.scene, *q.journal, q.kind, control);
                            return map ? std::make_shared<const ZeroMap>(std::move(*map)) : nullptr;
                          },
                          std::move(notify), Overtaken::cancelled) {}

ZeroMaps::Question ZeroMaps::wanted() const {
  Question q;
  if (window.view.zero_map == ZeroMapKind::none || !window.state() || !window.run.scene ||
      !window.run.journal)
    return q;
  return {window.state(), window.run.scene, window.run.journal, window.view.zero_map};
}

bool ZeroMaps::update() {
  Question q = wanted();
  if (asked_ != q) {
    asked_ = q;
    if (q.kind != ZeroMapKind::none)
      worker_.ask(std::move(q));
    else
      worker_.stop();
  }
  return !worker_.idle();
}

std::shared_ptr<const ZeroMap> ZeroMaps::map() const {
  const auto newest = worker_.answered();
  return newest && newest->question.kind != ZeroMapKind::none && newest->question == wanted() ? newest->answer
                                                                                              : nullptr;
}

bool ZeroMaps::makes_no_sense() const {
  const Question q = wanted();
  const auto newest = worker_.answered();
  return q.kind != ZeroMapKind::none && newest && newest->question == q && newest->answer == nullptr;
}

void ZeroMaps::add_commands(CommandTable& table) {
  add_group(table, {.menu = "View"},
            {{.name = "colour-by",
              .title = "Colour Z by the next map",
              .usage = "[none | distance | normals | valence | age]",
              .help = "Colours Z by its distance over δ, the deviation of its normals, the valence of its "
                      "vertices or the age of its facets, with a colour bar.",
              .keys = {{'Q'}},
              .run = on(window, choose_map)},
             {.name = "legend",
              .title = "Legend of the scene",
              .help = "Tells what colours and marks mean, in the view and in exported pictures.",
              .keys = {{'O'}},
              .run = flips(window.view.legend),
              .checked = is_on(window.view.legend)}});
}

void ZeroMaps::add_values(NamedValues& values) {
  const auto map_value = values.readings(
      "map.", [this] { return map(); }, "nan");
  map_value("least", "the least value of the map of Z", &ZeroMap::least);
  map_value("largest", "the largest one", &ZeroMap::largest);
  map_value("mean", "its mean over the area", &ZeroMap::mean);
  map_value("low", "where its colours begin", &ZeroMap::low);
  map_value("high", "where they end", &ZeroMap::high);
}

} // namespace isoscope
