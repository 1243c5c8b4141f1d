// What the user should know about Ω and the sides of its input, in sentences.
#include "base/place.h"
#include "tolerance/contacts.h"
#include "tolerance/tolerance_volume.h"

#include <algorithm>

namespace isoscope {

std::string ToleranceVolume::thickening_note(const RunControl& control) const {
  if (thickening()) return {};
  std::size_t outer = 0, inner = 0;
  long outer_euler = 0, inner_euler = 0;
  for (const BoundaryComponent& c : boundary_components_) {
    ++(c.label > 0 ? outer : inner);
    (c.label > 0 ? outer_euler : inner_euler) += c.euler_characteristic;
  }
  if (!topology_told() && has_paired_boundaries())
    return "Whether the volume is a thickening at this tolerance could not be told: between walls or gaps of "
           "about twice the tolerance it leaves regions too thin to count what they are.";
  const auto part = [&](std::size_t n, long euler) {
    return std::to_string(n) + (n == 1 ? " boundary component" : " boundary components") +
           (topology_told() ? " of Euler characteristic " + std::to_string(euler) : "");
  };
  return "At this tolerance the volume is no thickening: it has " + part(outer, outer_euler) +
         " outside and " + part(inner, inner_euler) + " inside" +
         (pockets() == 0 ? "" : " and " + std::to_string(pockets()) + " small pockets of one side") +
         ", because " + cause_in_words(control) + ".";
}

std::string ToleranceVolume::cause_in_words(const RunControl& control) const {
  if (sides_.rule() == SideRule::given) return "it was given so";
  if (has_inner_walls()) return overlap_in_words();
  if (input_.sides_known() && (input_.components > 1 || !input_.embedded())) {
    std::vector<Contact> contacts;
    if (!input_.embedded()) contacts = find_contacts(index(), control);
    if (contacts.empty() && input_.components > 1)
      contacts = find_near_contacts(index(), sides_, thresholds_.delta, thresholds_.boundary, control);
    if (!contacts.empty())
      return "parts of the input touch, near " +
             place(0.5 * (contacts.front()[0] + contacts.front()[1]), place_digits) +
             " for one, and are joined there";
  }
  return "it closes gaps, tunnels or walls narrower than twice the tolerance";
}

std::string ToleranceVolume::overlap_in_words() const {
  const auto deepest =
      std::max_element(regions_.begin(), regions_.end(), [](const Region& a, const Region& b) {
        return std::pair{std::abs(a.winding_number) > 1, a.depth} <
               std::pair{std::abs(b.winding_number) > 1, b.depth};
      });
  return "the input winds " + std::to_string(std::abs(deepest->winding_number)) + " times around " +
         place(deepest->deepest, place_digits) +
         ", where parts overlap: their union counts as inside, walls in it as none";
}

std::vector<std::string> ToleranceVolume::side_notes() const {
  std::vector<std::string> notes = input_.notes;
  const auto find = [&](const auto& is) { return std::find_if(regions_.begin(), regions_.end(), is); };
  if (sides_.rule() == SideRule::winding) {
    if (has_inner_walls() && thickening()) {
      std::string words = overlap_in_words() + ".";
      words.front() = 'T';
      notes.push_back(words);
    }
    const auto turned = find([](const Region& r) { return r.winding_number < 0; });
    const auto other = find([](const Region& r) { return r.winding_number > 0; });
    if (turned != regions_.end() && other != regions_.end())
      notes.push_back(
          "The part around " + place(turned->deepest, place_digits) +
          " is turned inside out: what it shares with parts that are not counts as outside. Turn it "
          "round unless that is meant.");
  } else if (winds()) {
    const auto odd = find([](const Region& r) { return r.label > 0 && r.winding_number != 0; });
    if (odd != regions_.end())
      notes.push_back("The part around " + place(odd->deepest, place_digits) +
                      " is oriented like the one around it, which is odd for a cavity: it counts as one, as "
                      "the two do not meet. With --sides winding it is solid.");
  }
  return notes;
}

} // namespace isoscope
