// Neighbours in the list are near in space: differences are short.
#include "recording/geometry_codec.h"

#include "recording/bytes.h"

#include <cmath>

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

} // namespace

std::string encode(const TriangleSoup& soup, const std::vector<InputNote>& notes) {
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
  if (notes.empty()) return out.take();
  out.number(notes.size());
  for (const InputNote& note : notes) {
    out.number(note.text.size());
    for (const char c : note.text) out.byte(static_cast<std::uint8_t>(c));
    out.real(note.deviation);
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
  if (!in.exhausted()) return std::nullopt;
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
  if (!in.exhausted() || samples.labels.size() != samples.positions.size()) return std::nullopt;
  return samples;
}

} // namespace isoscope
