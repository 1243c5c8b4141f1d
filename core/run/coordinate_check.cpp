// The spacing of doubles against δ, and their range against powers of the size.
#include "run/coordinate_check.h"

#include "base/place.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace isoscope {

namespace {

/// Spacing of coordinates in δ from which on proofs fail, and from which on it is told.
constexpr double largest_step = 1e-5, told_step = 1e-8;
/// Sizes between which products of eight lengths, each down to 1e-10 of the size, keep all their digits.
constexpr double smallest_size = 1e-25, largest_size = 1e25;

std::string lost_digits(const CoordinateDigits& digits, double delta) {
  char text[280];
  std::snprintf(
      text, sizeof text,
      "The model lies %.2g times its size from the origin: of the 16 digits of its coordinates %d are "
      "left at its size, and they go in steps of %.3g (%.2g%% of the tolerance).",
      digits.distance_ratio, digits.left, digits.step, 100 * digits.step / delta);
  return text;
}

} // namespace

CoordinateDigits coordinate_digits(const TriangleSoup& soup) {
  const Box3 box = soup.bounds();
  double largest = 0;
  for (const double c : {box.lo.x, box.lo.y, box.lo.z, box.hi.x, box.hi.y, box.hi.z})
    largest = std::max(largest, std::abs(c));
  CoordinateDigits digits;
  digits.step = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  digits.distance_ratio = largest / box.longest_edge();
  digits.left = std::max(0, static_cast<int>(std::floor(std::log10(box.longest_edge() / digits.step))));
  return digits;
}

Status check_coordinates(const TriangleSoup& soup, double delta) {
  const CoordinateDigits digits = coordinate_digits(soup);
  if (digits.step <= largest_step * delta) return {};
  const double least = digits.step / largest_step;
  const double share = least / soup.bounds().longest_edge();
  std::string remedy =
      "Move it by -" + place(soup.bounds().center(), 6) + " where it was made, before digits are lost";
  if (share < 0.5) {
    char text[120];
    std::snprintf(text, sizeof text, ", or choose a tolerance of at least %.3g (%.3g%% of the longest edge)",
                  least, 100 * share);
    remedy += text;
  }
  return Error{ErrorCode::bad_input, lost_digits(digits, delta), remedy + "."};
}

std::optional<std::string> coordinate_note(const TriangleSoup& soup, double delta) {
  const CoordinateDigits digits = coordinate_digits(soup);
  if (digits.step > told_step * delta)
    return lost_digits(digits, delta) + " What is finer than that in the model is lost already.";
  const double size = soup.bounds().longest_edge();
  if (size > smallest_size && size < largest_size) return std::nullopt;
  char text[320];
  std::snprintf(
      text, sizeof text,
      "The longest edge of the model is %.3g: products of many lengths, by which choices are ranked, lose "
      "their digits beyond the range of a double (1e-308 to 1e308). What is proven holds all the same; "
      "times 2^%d, which loses no digit, the model gives the mesh that is best.",
      size, -std::ilogb(size));
  return text;
}

} // namespace isoscope
