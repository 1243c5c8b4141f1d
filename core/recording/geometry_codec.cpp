// Neighbours in the list are near in space: differences are short.
#include "recording/geometry_codec.h"

#include "recording/bytes.h"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <new>

namespace isoscope {

namespace {

/// Integers up to here are doubles without loss.
constexpr double exact_limit = 9007199254740992.0;

bool is_multiple(double value, double unit) {
  const double q = value / unit;
  return std::abs(q) < exact_limit &&
         same_bits(static_cast<double>(static_cast<std::int64_t>(q)) * unit, value);
}

bool all_multiples(const BoundarySamples& samples) {
  if (!(samples.snap_unit > 0)) return false;
  for (const Vec3& p : samples.positions)
    for (int a = 0; a < 3; ++a)
      if (!is_multiple(p[a], samples.snap_unit)) return false;
  return true;
}

constexpr std::uint64_t most_extent = 1 << 20;

/// Floats by their bytes, all first ones first: neighbours are alike in most, which packs better.
std::string planes_of(const std::vector<float>& values) {
  std::string planes(4 * values.size(), '\0');
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto bits = std::bit_cast<std::uint32_t>(values[i]);
    for (std::size_t b = 0; b < 4; ++b, bits >>= 8)
      planes[b * values.size() + i] = static_cast<char>(bits & 0xff);
  }
  return planes;
}

void write_grid(ByteWriter& out, const ScalarGrid& grid) {
  for (const std::size_t n : grid.size) out.number(n);
  for (int a = 0; a < 3; ++a) out.real(grid.origin[a]);
  for (int a = 0; a < 3; ++a) out.real(grid.spacing[a]);
  const std::string planes = planes_of(grid.values);
  uLongf size = compressBound(static_cast<uLong>(planes.size()));
  std::string packed(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(planes.data()),
                static_cast<uLong>(planes.size()), Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc(); // the only way to fail with room enough
  out.number(size);
  for (std::size_t i = 0; i < size; ++i) out.byte(static_cast<std::uint8_t>(packed[i]));
}

std::shared_ptr<const ScalarGrid> read_stored_grid(ByteReader& in) {
  constexpr std::uint64_t most_expansion = 1032; // of deflate
  auto grid = std::make_shared<ScalarGrid>();
  std::uint64_t count = 1;
  for (std::size_t& n : grid->size) {
    const std::uint64_t extent = in.number();
    if (extent < 2 || extent > most_extent) return nullptr;
    n = static_cast<std::size_t>(extent);
    count *= extent;
  }
  for (int a = 0; a < 3; ++a) grid->origin[a] = in.real();
  for (int a = 0; a < 3; ++a) grid->spacing[a] = in.real();
  std::string packed(in.count(1), '\0');
  for (char& c : packed) c = static_cast<char>(in.byte());
  const bool sound = is_finite(grid->origin) && is_finite(grid->spacing) && grid->spacing.x > 0 &&
                     grid->spacing.y > 0 && grid->spacing.z > 0;
  if (in.failed() || !sound || 4 * count > most_expansion * (packed.size() + 1)) return nullptr;
  std::string planes(4 * count, '\0');
  uLongf size = static_cast<uLongf>(planes.size());
  if (uncompress(reinterpret_cast<Bytef*>(planes.data()), &size,
                 reinterpret_cast<const Bytef*>(packed.data()), static_cast<uLong>(packed.size())) != Z_OK ||
      size != planes.size())
    return nullptr;
  grid->values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t b = 0; b < 4; ++b)
      bits |= std::uint32_t{static_cast<std::uint8_t>(planes[b * count + i])} << (8 * b);
    grid->values[i] = std::bit_cast<float>(bits);
    if (!std::isfinite(grid->values[i])) return nullptr;
  }
  return grid;
}

/// What follows the triangles besides notes.
enum class Addition : std::uint8_t { none, walls, grid };

/// What is stored of a volume, if anything is.
bool read_volume(ByteReader& in, TriangleSoup& soup) {
  if (in.exhausted()) return true;
  switch (static_cast<Addition>(in.byte())) {
  case Addition::walls:
    soup.outer_triangles = static_cast<std::size_t>(in.number());
    return soup.outer_triangles > 0 && soup.outer_triangles < soup.triangles.size();
  case Addition::grid:
    soup.grid = read_stored_grid(in);
    return soup.grid != nullptr;
  case Addition::none:
    break;
  }
  return false;
}

} // namespace

std::string encode(const TriangleSoup& given, const std::vector<InputNote>& notes) {
  // Triangles that only show a grid are made again from it.
  const TriangleSoup nothing;
  const TriangleSoup& soup = given.grid ? nothing : given;
  ByteWriter out;
  out.number(soup.points.size());
  for (const Vec3& p : soup.points)
    for (int a = 0; a < 3; ++a) out.real(p[a]);
  out.number(soup.triangles.size());
  std::int64_t last = 0;
  for (const auto& t : soup.triangles)
    for (const std::uint32_t v : t) {
      out.signed_number(std::int64_t{v} - last);
      last = v;
    }
  if (notes.empty() && !given.gives_volume()) return out.take();
  out.number(notes.size());
  for (const InputNote& note : notes) {
    out.number(note.text.size());
    for (const char c : note.text) out.byte(static_cast<std::uint8_t>(c));
    out.real(note.deviation);
  }
  if (given.grid) {
    out.byte(static_cast<std::uint8_t>(Addition::grid));
    write_grid(out, *given.grid);
  } else if (given.outer_triangles > 0) {
    out.byte(static_cast<std::uint8_t>(Addition::walls));
    out.number(given.outer_triangles);
  }
  return out.take();
}

std::optional<TriangleSoup> decode_soup(std::string_view bytes, std::vector<InputNote>* notes) {
  ByteReader in(bytes);
  TriangleSoup soup;
  soup.points.resize(in.count(24));
  for (Vec3& p : soup.points) {
    for (int a = 0; a < 3; ++a) p[a] = in.real();
    if (!is_finite(p)) return std::nullopt;
  }
  soup.triangles.resize(in.count(3));
  std::int64_t last = 0;
  for (auto& t : soup.triangles)
    for (std::uint32_t& v : t) {
      last = moved_by(last, in.signed_number());
      if (last < 0 || last >= static_cast<std::int64_t>(soup.points.size())) return std::nullopt;
      v = static_cast<std::uint32_t>(last);
    }
  if (in.exhausted()) return soup; // without notes, as most are
  std::vector<InputNote> stored(in.count(9));
  for (InputNote& note : stored) {
    note.text.resize(in.count(1));
    for (char& c : note.text) c = static_cast<char>(in.byte());
    note.deviation = in.real();
  }
  if (!read_volume(in, soup) || !in.exhausted()) return std::nullopt;
  if (notes != nullptr) *notes = std::move(stored);
  return soup;
}

std::string encode(const Triangle3& triangle) {
  ByteWriter out;
  for (const Vec3& p : triangle)
    for (int a = 0; a < 3; ++a) out.real(p[a]);
  return out.take();
}

std::optional<Triangle3> decode_triangle(std::string_view bytes) {
  ByteReader in(bytes);
  Triangle3 triangle;
  for (Vec3& p : triangle)
    for (int a = 0; a < 3; ++a) p[a] = in.real();
  if (!in.exhausted()) return std::nullopt;
  return triangle;
}

std::string encode(const BoundarySamples& samples) {
  ByteWriter out;
  const bool multiples = all_multiples(samples);
  out.number(samples.size());
  out.byte(multiples ? 1 : 0);
  out.real(samples.sigma);
  out.real(samples.covering_radius);
  out.number(samples.undecided_cells);
  out.real(samples.snap_unit);
  std::int64_t last[3] = {0, 0, 0};
  for (const Vec3& p : samples.positions)
    for (int a = 0; a < 3; ++a) {
      if (!multiples) {
        out.real(p[a]);
        continue;
      }
      const auto q = static_cast<std::int64_t>(p[a] / samples.snap_unit);
      out.signed_number(q - last[a]);
      last[a] = q;
    }
  out.number(samples.labels.size());
  for (const std::int8_t label : samples.labels) out.byte(static_cast<std::uint8_t>(label));
  out.number(samples.components.size());
  for (const std::uint16_t component : samples.components) out.number(component);
  out.number(samples.over_rim.size());
  for (const Vec3& p : samples.over_rim)
    for (int a = 0; a < 3; ++a) out.real(p[a]);
  return out.take();
}

std::optional<BoundarySamples> decode_samples(std::string_view bytes) {
  ByteReader in(bytes);
  BoundarySamples samples;
  samples.positions.resize(in.count(3));
  const bool multiples = in.byte() != 0;
  samples.sigma = in.real();
  samples.covering_radius = in.real();
  samples.undecided_cells = in.number();
  samples.snap_unit = in.real();
  std::int64_t last[3] = {0, 0, 0};
  for (Vec3& p : samples.positions) {
    for (int a = 0; a < 3; ++a) {
      if (!multiples) {
        p[a] = in.real();
        continue;
      }
      last[a] = moved_by(last[a], in.signed_number());
      p[a] = static_cast<double>(last[a]) * samples.snap_unit;
    }
    if (!is_finite(p)) return std::nullopt;
  }
  samples.labels.resize(in.count(1));
  for (std::int8_t& label : samples.labels) label = static_cast<std::int8_t>(in.byte());
  samples.components.resize(in.count(1));
  for (std::uint16_t& component : samples.components) component = static_cast<std::uint16_t>(in.number());
  samples.over_rim.resize(in.count(24));
  for (Vec3& p : samples.over_rim)
    for (int a = 0; a < 3; ++a) p[a] = in.real();
  if (!in.exhausted() || samples.labels.size() != samples.positions.size()) return std::nullopt;
  return samples;
}

} // namespace isoscope
