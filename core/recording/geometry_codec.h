// Input soups and sample sets as bytes.
#pragma once

#include "input/triangle_soup.h"
#include "tolerance/boundary_sampler.h"

#include <optional>
#include <string>
#include <string_view>

namespace isoscope {

/// Points bit for bit, triangles as differences. Without the name.
std::string encode(const TriangleSoup& soup);
/// Nothing when the bytes are no soup: indices out of range, coordinates that are not finite.
std::optional<TriangleSoup> decode_soup(std::string_view bytes);

/// Nine coordinates, bit for bit.
std::string encode(const Triangle3& triangle);
std::optional<Triangle3> decode_triangle(std::string_view bytes);

/// Positions as multiples of snap_unit where all are (some 15 bytes a sample), else bit for bit.
std::string encode(const BoundarySamples& samples);
std::optional<BoundarySamples> decode_samples(std::string_view bytes);

} // namespace isoscope
