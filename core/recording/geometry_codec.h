// Input soups and sample sets as bytes.
#pragma once

#include "input/input_note.h"
#include "input/triangle_soup.h"
#include "tolerance/boundary_sampler.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isoscope {

/// Points bit for bit, triangles as differences, notes where there are any. Without the name.
std::string encode(const TriangleSoup& soup, const std::vector<InputNote>& notes = {});
/// Nothing when the bytes are no soup: indices out of range, coordinates that are not finite. Fills `notes`
/// where given.
std::optional<TriangleSoup> decode_soup(std::string_view bytes, std::vector<InputNote>* notes = nullptr);

/// Nine coordinates, bit for bit.
std::string encode(const Triangle3& triangle);
std::optional<Triangle3> decode_triangle(std::string_view bytes);

/// Positions as multiples of snap_unit where all are (some 15 bytes a sample), else bit for bit.
std::string encode(const BoundarySamples& samples);
std::optional<BoundarySamples> decode_samples(std::string_view bytes);

} // namespace isoscope
