// Writes a mesh in the format that the name of the file asks for.
#include "base/numbers.h"
#include "base/pending_file.h"
#include "input/file_scanner.h"
#include "input/mesh_io.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace isoscope {

namespace {

namespace fs = std::filesystem;

enum class Format { off, obj, ply, stl };

Result<Format> format_of(const fs::path& file) {
  std::string e = file.extension().string();
  for (char& c : e) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (e == ".off") return Format::off;
  if (e == ".obj") return Format::obj;
  if (e == ".ply") return Format::ply;
  if (e == ".stl") return Format::stl;
  return Error{ErrorCode::usage,
               printable(file.native(), 1000) + ": the name does not say in which format to write.",
               "End it in .off, .obj, .ply or .stl."};
}

std::string coordinates(Vec3 p) {
  return shortest(p.x) + ' ' + shortest(p.y) + ' ' + shortest(p.z) + '\n';
}

template <class T> void append_little_endian(PendingFile& out, T value) {
  std::array<char, sizeof(T)> bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  out.append(bytes.data(), bytes.size());
}

void write_off(PendingFile& out, const TriangleMesh& mesh) {
  out.append("OFF\n" + std::to_string(mesh.points.size()) + ' ' + std::to_string(mesh.triangles.size()) +
             " 0\n");
  for (const Vec3 p : mesh.points) out.append(coordinates(p));
  for (const auto& [a, b, c] : mesh.triangles)
    out.append("3 " + std::to_string(a) + ' ' + std::to_string(b) + ' ' + std::to_string(c) + '\n');
}

void write_obj(PendingFile& out, const TriangleMesh& mesh) {
  for (const Vec3 p : mesh.points) out.append("v " + coordinates(p));
  // A group for each two labels, the larger one, which facets are seen from, first.
  std::vector<std::size_t> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto pair = [&](std::size_t i) { return std::pair(-mesh.labels[i].front, -mesh.labels[i].back); };
  if (!mesh.labels.empty())
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return pair(i) < pair(j); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k];
    if (!mesh.labels.empty() && (k == 0 || pair(i) != pair(order[k - 1])))
      out.append("g front_" + std::to_string(mesh.labels[i].front) + "_back_" +
                 std::to_string(mesh.labels[i].back) + '\n');
    const auto& [a, b, c] = mesh.triangles[i];
    out.append("f " + std::to_string(std::uint64_t{a} + 1) + ' ' + std::to_string(std::uint64_t{b} + 1) +
               ' ' + std::to_string(std::uint64_t{c} + 1) + '\n');
  }
}

void write_ply(PendingFile& out, const TriangleMesh& mesh) {
  out.append("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\n" +
             (mesh.labels.empty() ? "" : "property char front\nproperty char back\n") + "end_header\n");
  for (const Vec3 p : mesh.points)
    for (int i = 0; i < 3; ++i) append_little_endian(out, p[i]);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    append_little_endian(out, std::uint8_t{3});
    for (const std::uint32_t v : mesh.triangles[i]) append_little_endian(out, v);
    if (mesh.labels.empty()) continue;
    append_little_endian(out, mesh.labels[i].front);
    append_little_endian(out, mesh.labels[i].back);
  }
}

void write_stl(PendingFile& out, const TriangleMesh& mesh) {
  std::array<char, 80> header{};
  const std::string_view title = "Isoscope binary STL";
  std::copy(title.begin(), title.end(), header.begin());
  out.append(header.data(), header.size());
  append_little_endian(out, static_cast<std::uint32_t>(mesh.triangles.size()));
  const auto append_point = [&](Vec3 p) {
    for (int i = 0; i < 3; ++i) append_little_endian(out, static_cast<float>(p[i]));
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    append_point(normalized(cross(b - a, c - a)));
    for (const Vec3 p : {a, b, c}) append_point(p);
    append_little_endian(out, std::uint16_t{0});
  }
}

Status check_mesh(const fs::path& file, const TriangleMesh& mesh, Format format) {
  const std::string name = printable(file.native(), 1000);
  for (const auto& t : mesh.triangles)
    for (const std::uint32_t v : t)
      if (v >= mesh.points.size())
        return Error{
            ErrorCode::internal, name + ": a triangle to be written refers to a missing vertex.", {}};
  const double limit =
      format == Format::stl ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
  for (const Vec3 p : mesh.points)
    for (int i = 0; i < 3; ++i)
      if (!(std::abs(p[i]) <= limit))
        return Error{ErrorCode::io, name + ": a coordinate is beyond what this format can hold.",
                     "Write OFF instead."};
  return {};
}

} // namespace

Status write_mesh(const fs::path& file, const TriangleMesh& mesh) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  if (mesh.triangles.empty())
    return Error{ErrorCode::io, printable(file.native(), 1000) + " is not written: the mesh is empty.", ""};
  if (Status sound = check_mesh(file, mesh, *format); !sound) return sound;
  PendingFile out;
  if (Status opened = out.open(file); !opened) return opened;
  switch (*format) {
  case Format::off:
    write_off(out, mesh);
    break;
  case Format::obj:
    write_obj(out, mesh);
    break;
  case Format::ply:
    write_ply(out, mesh);
    break;
  case Format::stl:
    write_stl(out, mesh);
    break;
  }
  return out.commit();
}

Status check_writable_mesh(const fs::path& file) {
  const Result<Format> format = format_of(file);
  if (!format) return format.error();
  // Only trying tells: permissions, read-only disks and exhausted inodes all show themselves here.
  PendingFile trial;
  return trial.open(file);
}

} // namespace isoscope
