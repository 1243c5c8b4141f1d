// Where triangles meet that are no neighbours: corners that they share are no contacts, all else is.
#include "tolerance/contacts.h"

#include <doctest/doctest.h>

using namespace isoscope;

namespace {

/// The contacts of two triangles with the first corner in common.
std::vector<Contact> contacts_of(Vec3 apex, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const ClosestPointIndex index(TriangleSoup{{apex, a, b, c, d}, {{0, 1, 2}, {0, 3, 4}}, {}});
  std::vector<Contact> found = find_contacts(index, {});
  // Two triangles without a common edge are two fans of their corner.
  std::erase_if(found, [&](const Contact& x) { return x[0] == apex && x[1] == apex; });
  return found;
}

/// Whether the only contact is the segment between the two points.
bool is_one(const std::vector<Contact>& found, Vec3 from, Vec3 to) {
  return found.size() == 1 && ((distance(found[0][0], from) < 1e-12 && distance(found[0][1], to) < 1e-12) ||
                               (distance(found[0][1], from) < 1e-12 && distance(found[0][0], to) < 1e-12));
}

} // namespace

TEST_CASE("Triangles that share a corner alone have no contact, however they lie to each other's planes") {
  const Vec3 o{0.5, 0.25, -1}, x = o + Vec3{1, 0, 0}, y = o + Vec3{0, 1, 0};
  SUBCASE("both corners above") {
    CHECK(contacts_of(o, x, y, o + Vec3{1, 0, 1}, o + Vec3{0, 1, 2}).empty());
  }
  SUBCASE("one plane, side by side") {
    CHECK(contacts_of(o, x, y, o + Vec3{-1, 0.5, 0}, o + Vec3{-1, -1, 0}).empty());
  }
  SUBCASE("one plane, edges in line") {
    CHECK(contacts_of(o, x, y, o + Vec3{-1, 0, 0}, o + Vec3{0, -1, 0}).empty());
  }
  SUBCASE("each across the other's plane, behind the corner") {
    CHECK(contacts_of(o, o + Vec3{1, 0, -1}, o + Vec3{1, 0, 1}, o + Vec3{-1, -1, 0}, o + Vec3{-1, 1, 0})
              .empty());
  }
}

TEST_CASE("Triangles that share more than a corner touch along a segment or in a part of their plane") {
  const Vec3 o{0.5, 0.25, -1}, x = o + Vec3{1, 0, 0}, y = o + Vec3{0, 1, 0};
  SUBCASE("each across the other's plane, in front of the corner") {
    CHECK(is_one(contacts_of(o, o + Vec3{1, 0, -1}, o + Vec3{1, 0, 1}, o + Vec3{2, -1, 0}, o + Vec3{2, 1, 0}),
                 o, x));
  }
  SUBCASE("an edge in the other's inside") {
    CHECK(
        is_one(contacts_of(o, x, y, o + Vec3{0.25, 0.25, 0}, o + Vec3{0, 0, 1}), o, o + Vec3{0.25, 0.25, 0}));
  }
  SUBCASE("an edge along the other's") {
    CHECK(is_one(contacts_of(o, x, y, o + Vec3{0.5, 0, 0}, o + Vec3{0, 0, 1}), o, o + Vec3{0.5, 0, 0}));
    CHECK(is_one(contacts_of(o, x, y, o + Vec3{0.5, 0, 0}, o + Vec3{0, -1, 0}), o, o + Vec3{0.5, 0, 0}));
  }
  SUBCASE("one plane, overlapping") {
    CHECK(contacts_of(o, x, y, o + Vec3{1, 0.5, 0}, o + Vec3{-1, 0.5, 0}).size() >= 3);
    CHECK(contacts_of(o, x, y, o + Vec3{2, 1, 0}, o + Vec3{1, 2, 0}).size() >= 3);
  }
}
