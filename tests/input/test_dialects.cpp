// What programs and people make of the formats: read as meant, with a note where something was guessed.
#include "input/input_mesh.h"
#include "input/input_note.h"
#include "input/mesh_io.h"
#include "input/temporary_folder.h"

#include <doctest/doctest.h>

#include <array>
#include <cctype>
#include <cstring>
#include <string>

using namespace isoscope;

namespace {

constexpr float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// The tetrahedron of `corners` with the outside outside; `note` is part of its only note, empty: none.
void check_tetrahedron(const std::filesystem::path& file, const std::string& note = {}) {
  CAPTURE(file.filename().string());
  const auto mesh = read_input_mesh(file, RunControl{});
  if (!mesh) FAIL(mesh.error().line());
  CHECK(mesh->soup.points.size() == 4);
  REQUIRE(mesh->soup.triangles.size() == 4);
  double volume = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Triangle3 t = mesh->soup.triangle(i);
    volume += dot(t[0], cross(t[1], t[2])) / 6;
  }
  CHECK(volume == doctest::Approx(1.0 / 6));
  REQUIRE(mesh->notes.size() == (note.empty() ? 0 : 1));
  if (!note.empty()) {
    const std::string text = told(mesh->notes[0], 0.1);
    CAPTURE(text);
    CHECK(text.find(note) != std::string::npos);
  }
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string utf16(const std::string& text, bool big_endian) {
  std::string bytes = big_endian ? "\xfe\xff" : "\xff\xfe";
  for (const char c : text) {
    const char pair[2] = {big_endian ? '\0' : c, big_endian ? c : '\0'};
    bytes.append(pair, 2);
  }
  return bytes;
}

std::string ascii_stl() {
  std::string text = "solid part of many words\n";
  for (const auto& f : faces) {
    text += "  facet normal 0 0 nan\n    outer loop\n";
    for (const int v : f)
      text += "      vertex " + std::to_string(corners[v][0]) + " " + std::to_string(corners[v][1]) + " " +
              std::to_string(corners[v][2]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid part\n";
}

/// Binary STL of the tetrahedron with that count in its header.
std::string binary_stl(std::uint32_t count, const std::string& title = "made by hand") {
  std::string bytes = title;
  bytes.resize(80, ' ');
  const auto add = [&](const auto& value) {
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    bytes += raw;
  };
  add(count);
  for (const auto& f : faces) {
    add(std::array<float, 3>{});
    for (const int v : f)
      for (const float c : corners[v]) add(c);
    add(std::uint16_t{0});
  }
  return bytes;
}

const std::string off = "OFF\n# of a tetrahedron\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 "
                        "3\n3 2 0 3\n";
const std::string obj =
    "# of a tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"
    "f 3 1 4\n";

std::string ply(const std::string& list, const std::string& format = "ascii") {
  return "ply\nformat " + format +
         " 1.0\ncomment of a tetrahedron\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
         "float z\nelement face 4\nproperty list uchar int " +
         list + "\nend_header\n";
}

const std::string ply_rows = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string binary_ply_rows() {
  std::string bytes(reinterpret_cast<const char*>(corners), sizeof corners);
  for (const auto& f : faces) {
    bytes += '\3';
    bytes.append(reinterpret_cast<const char*>(f), sizeof f);
  }
  return bytes;
}

} // namespace

TEST_CASE("keywords of ASCII STL in any case, ends with a blank, names missing or differing") {
  const TemporaryFolder folder;
  const std::string stl = ascii_stl();
  check_tetrahedron(folder.file("plain.stl", stl));
  check_tetrahedron(folder.file("upper.stl", upper(stl)));
  check_tetrahedron(folder.file("mixed.stl", replaced(replaced(stl, "facet", "Facet"), "vertex", "VERTEX")));
  check_tetrahedron(folder.file("blanks.stl", replaced(stl, "end", "end ")));
  check_tetrahedron(folder.file("upper_blanks.stl", upper(replaced(stl, "end", "end  "))));
  check_tetrahedron(folder.file("glued.stl", replaced(stl, "outer loop", "outerloop")));
  check_tetrahedron(
      folder.file("nameless.stl", replaced(replaced(stl, " part of many words", ""), " part", "")));
  check_tetrahedron(folder.file("other_name.stl", replaced(stl, "endsolid part", "endsolid of another")));
  check_tetrahedron(folder.file("no_end.stl", replaced(stl, "endsolid part\n", "")));
  check_tetrahedron(folder.file("no_solid.stl", replaced(stl, "solid part of many words\n", "")));
  check_tetrahedron(folder.file("facet_name.stl", replaced(stl, "part of many", "facet of many")));
  check_tetrahedron(folder.file("latin1_name.stl", replaced(stl, "many words", "M\xfcnchen \x01")));
  check_tetrahedron(folder.file("long_name.stl", replaced(stl, "many", std::string(5000, 'x'))));
  check_tetrahedron(folder.file("no_normals.stl", replaced(stl, " normal 0 0 nan", "")));
  check_tetrahedron(folder.file("odd_normals.stl", replaced(stl, "0 0 nan", "-nan(ind) 1,#IND 1.#QNAN")));
  check_tetrahedron(folder.file("one_line.stl", replaced(stl, "\n", " ")));
  check_tetrahedron(folder.file("extension", stl));
}

TEST_CASE("binary STL is read by its triangles, with a note where the header says something else") {
  const TemporaryFolder folder;
  const std::string some(33, '\x55');
  check_tetrahedron(folder.file("sound.stl", binary_stl(4)));
  check_tetrahedron(folder.file("zero.stl", binary_stl(0)), "announces 0 triangles, but 4");
  check_tetrahedron(folder.file("open.stl", binary_stl(0xffffffff)),
                    "announces 4,294,967,295 triangles, but 4");
  check_tetrahedron(folder.file("few.stl", binary_stl(1)), "announces 1 triangles, but 4");
  check_tetrahedron(folder.file("many.stl", binary_stl(1000)), "announces 1,000 triangles, but 4");
  check_tetrahedron(folder.file("trailing.stl", binary_stl(4) + some), "33 bytes follow");
  check_tetrahedron(folder.file("one_more.stl", binary_stl(4) + "\n"), "1 byte follows");
  check_tetrahedron(folder.file("record_of_text.stl", binary_stl(4) + std::string(150, 'q')),
                    "150 bytes follow");
  check_tetrahedron(folder.file("padded.stl", binary_stl(4) + std::string(5000, '\0')), "5,000 bytes follow");
  check_tetrahedron(folder.file("solid.stl", binary_stl(4, "solid part")));
  check_tetrahedron(folder.file("solid_open.stl", binary_stl(0, "SOLID part")), "announces 0");
  check_tetrahedron(folder.file("solid_trailing.stl", binary_stl(4, "solid part") + some), "33 bytes follow");
  check_tetrahedron(folder.file("solid_without_extension", binary_stl(4, "solid part") + "x"), "1 byte");
  check_tetrahedron(folder.file("marked.stl", binary_stl(4, "\xff\xfe of a scanner")));
  const auto both = read_input_mesh(folder.file("both.stl", binary_stl(0) + some), RunControl{});
  REQUIRE(both.ok());
  CHECK(both->soup.triangles.size() == 4);
  CHECK(both->notes.size() == 2);
  // Cut within a triangle there is no telling what else is missing.
  CHECK_FALSE(read_mesh(folder.file("cut.stl", binary_stl(4).substr(0, 84 + 120))).ok());
  CHECK_FALSE(read_mesh(folder.file("nothing.stl", binary_stl(0xffffffff).substr(0, 84))).ok());
  CHECK_FALSE(read_mesh(folder.file("zeros.stl", binary_stl(7).substr(0, 84) + std::string(500, '\0'))).ok());
}

TEST_CASE("lines end with CR, LF or CR LF in every text format") {
  const TemporaryFolder folder;
  const std::string text_ply = ply("vertex_indices") + ply_rows;
  for (const std::string end : {"\r", "\n", "\r\n"}) {
    check_tetrahedron(folder.file("a.off", replaced(off, "\n", end)));
    check_tetrahedron(folder.file("a.obj", replaced(obj, "\n", end)));
    check_tetrahedron(folder.file("a.ply", replaced(text_ply, "\n", end)));
    check_tetrahedron(folder.file("a.stl", replaced(ascii_stl(), "\n", end)));
    check_tetrahedron(folder.file(
        "b.ply", replaced(ply("vertex_indices", "binary_little_endian"), "\n", end) + binary_ply_rows()));
  }
  // Data whose first byte is that of an LF: an element before the vertices makes it so.
  const std::string first = replaced(ply("vertex_indices", "binary_little_endian"), "element vertex",
                                     "element dummy 1\nproperty uchar a\nelement vertex");
  for (const std::string end : {"\r", "\n", "\r\n"})
    check_tetrahedron(folder.file("c.ply", replaced(first, "\n", end) + "\n" + binary_ply_rows()));
  // The line of an error counts each end once.
  for (const std::string end : {"\r", "\n", "\r\n"}) {
    const auto bad = read_mesh(folder.file("bad.obj", replaced("v 0 0 0\nv 1 0 0\n\nv x 0 0\n", "\n", end)));
    REQUIRE_FALSE(bad.ok());
    CHECK(bad.error().message.find("line 4") != std::string::npos);
  }
}

TEST_CASE("OFF by words where its lines are others, with its keyword in any case or missing") {
  const TemporaryFolder folder;
  const std::string plain = replaced(off, "# of a tetrahedron\n", "");
  check_tetrahedron(folder.file("one_line.off", replaced(plain, "\n", " ")));
  check_tetrahedron(folder.file("two_lines.off", "OFF\n" + replaced(plain.substr(4), "\n", "\t")));
  check_tetrahedron(folder.file("word_a_line.off", replaced(plain, " ", "\n")));
  check_tetrahedron(folder.file("vertices_two_a_line.off",
                                "OFF 4 4 0\n0 0 0 1 0 0\n0 1 0 0 0 1\n3 0 2 1\n3 0 1 "
                                "3\n3 1 2 3\n3 2 0 3\n"));
  check_tetrahedron(folder.file("ragged.off",
                                "OFF\n4 4 0\n0 0 0\n1 0 0 0 1\n0 0 0 1 3 0 2 1\n3 0 1 3 3 1\n2 3 "
                                "3 2 0 3"));
  check_tetrahedron(folder.file("faces_on_one_line.off",
                                "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 3 0 1 3 "
                                "3 1 2 3 3 2 0 3\n"));
  check_tetrahedron(folder.file("colours.off",
                                "COFF 4 4 0 0 0 0 .5 .5 .5 1 1 0 0 .5 .5 .5 1 0 1 0 .5 .5 .5 1 0 0 "
                                "1 .5 .5 nan 1 3 0 2 1 3 0 1 3 3 1 2 3 3 2 0 3"));
  check_tetrahedron(folder.file("three_colours.off",
                                "COFF 4 4 0 0 0 0 9 9 9 1 0 0 9 9 9 0 1 0 9 9 9 0 0 1 9 9 9 3 "
                                "0 2 1 3 0 1 3 3 1 2 3 3 2 0 3"));
  check_tetrahedron(folder.file("normals.off",
                                "NOFF 4 4 0 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 0 0 1 0 0 1 3 0 2 1 "
                                "3 0 1 3 3 1 2 3 3 2 0 3"));
  check_tetrahedron(folder.file("nan_colours.off",
                                "OFF 4 4 0\n0 0 0 nan nan nan\n1 0 0 nan nan -nan(ind)\n0 1 0 inf "
                                "0 0\n0 0 1 0 0 0\n3 0 2 1 nan 0 0\n3 0 1 3\n3 1 2 3\n3 2 0 "
                                "3\n"));
  check_tetrahedron(folder.file("lower.off", "off" + plain.substr(3)));
  check_tetrahedron(folder.file("lower_without_extension", "off" + plain.substr(3)));
  check_tetrahedron(folder.file("glued.off", "Off4 4 0\n" + ply_rows));
  check_tetrahedron(folder.file("lower_normals.off",
                                "noff\n4 4 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 "
                                "1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"));
  check_tetrahedron(folder.file("missing.off", plain.substr(4)));
  check_tetrahedron(folder.file("missing_on_one_line.off", replaced(plain.substr(4), "\n", " ")));
  check_tetrahedron(folder.file("no_edges.off", replaced(plain, "4 4 6", "4 4")));
  check_tetrahedron(folder.file("wrapped_face.off", replaced(off, "3 1 2 3", "3\n1 2\n3")));
  // Nothing may be left over where words alone tell.
  CHECK_FALSE(read_mesh(folder.file("more.off", replaced(plain, "\n", " ") + " 3 0 1 2")).ok());
  CHECK_FALSE(
      read_mesh(folder.file("less.off", replaced(plain.substr(0, plain.size() - 3), "\n", " "))).ok());
}

TEST_CASE("OBJ with backslashes glued to numbers and colours that are nan") {
  const TemporaryFolder folder;
  check_tetrahedron(folder.file("glued.obj", replaced(obj, "f 1 3 2", "f 1 3\\\n2")));
  check_tetrahedron(folder.file("twice.obj", replaced(obj, "f 1 3 2", "f 1\\\n3 \\\n 2")));
  check_tetrahedron(folder.file("blank_behind.obj", replaced(obj, "v 0 1 0", "v 0 1\\ \n0")));
  check_tetrahedron(
      folder.file("windows.obj", replaced(replaced(obj, "f 1 3 2", "f 1 3\\\n2"), "\n", "\r\n")));
  check_tetrahedron(folder.file("slashes.obj", replaced(obj, "f 1 3 2", "f 1//1 3//1\\\n2//1")));
  for (const std::string colour : {" nan nan nan", " NaN 0 inf", " -nan(ind) 1.#QNAN 0", " 1.0 0.5 0.25 1"})
    check_tetrahedron(folder.file("colours.obj", replaced(obj, "v 0 1 0", "v 0 1 0" + colour)));
  CHECK_FALSE(read_mesh(folder.file("words.obj", replaced(obj, "v 0 1 0", "v 0 1 0 v 0 1 0"))).ok());
  CHECK_FALSE(read_mesh(folder.file("no_number.obj", replaced(obj, "v 0 1 0", "v 0 nan 0"))).ok());
}

TEST_CASE("the corners of PLY faces under all their names") {
  const TemporaryFolder folder;
  for (const char* name : {"vertex_indices", "vertex_index", "vertex_ids", "vertex_id", "VertexIndices",
                           "vertices", "indices", "corners_of_somebody"})
    check_tetrahedron(folder.file("a.ply", ply(name) + ply_rows));
  check_tetrahedron(
      folder.file("faces.ply", replaced(ply("vertex_ids"), "element face", "element faces") + ply_rows));
  // The named list, not the one before it.
  const std::string two =
      replaced(ply("vertex_ids"), "property list", "property list uchar int material\nproperty list");
  check_tetrahedron(
      folder.file("two.ply", two + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 9 3 0 2 1\n0 3 0 1 3\n0 3 1 2 3\n0 3 "
                                   "2 0 3\n"));
  // Texture coordinates are a list too, but no corners.
  const std::string texture =
      replaced(ply("vertex_ids"), "vertex_ids", "vertex_ids\nproperty list uchar float texcoord");
  check_tetrahedron(
      folder.file("texture.ply", texture + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 0\n3 0 1 3 2 .5 .5\n3 1 "
                                           "2 3 0\n3 2 0 3 0\n"));
}

TEST_CASE("text in UTF-16 and behind marks") {
  const TemporaryFolder folder;
  const std::string text_ply = ply("vertex_indices") + ply_rows;
  for (const bool big_endian : {false, true}) {
    check_tetrahedron(folder.file("a.off", utf16(off, big_endian)));
    check_tetrahedron(folder.file("a.obj", utf16(replaced(obj, "\n", "\r\n"), big_endian)));
    check_tetrahedron(folder.file("a.ply", utf16(text_ply, big_endian)));
    check_tetrahedron(folder.file("a.stl", utf16(ascii_stl(), big_endian)));
    check_tetrahedron(folder.file("a", utf16(off, big_endian)));
  }
  for (const std::string& text : {off, obj, text_ply, ascii_stl()})
    check_tetrahedron(folder.file("b", "\xef\xbb\xbf" + text));
  // Other letters than ASCII, in a comment, and a byte too many at the end.
  std::string accents = utf16(off, false);
  accents[2 + 2 * 6] = '\x0a';
  accents[2 + 2 * 6 + 1] = '\x0a';
  check_tetrahedron(folder.file("accents.off", accents + "\x20"));
  // More than one buffer of the scanner.
  std::string long_comment = "OFF\n";
  for (int i = 0; i < 20000; ++i) long_comment += "# a line of a long comment\n";
  check_tetrahedron(folder.file("long.off", utf16(long_comment + off.substr(4), true)));
  check_tetrahedron(
      folder.file("long_line.off", utf16(long_comment + replaced(off.substr(23), "\n", " "), false)));
}

TEST_CASE("faces that are not flat are told once, with their number and how far they are off") {
  const TemporaryFolder folder;
  const std::string rows =
      "\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 "
      "6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const auto flat = read_input_mesh(folder.file("flat.off", "OFF 8 6 0\n0 0 0" + rows), RunControl{});
  REQUIRE(flat.ok());
  CHECK(flat->notes.empty());
  const auto rounded =
      read_input_mesh(folder.file("rounded.off", "OFF 8 6 0\n0 0 1e-7" + rows), RunControl{});
  REQUIRE(rounded.ok());
  CHECK(rounded->notes.empty());
  // Pushing one corner by 0.2 along the diagonal bends its three faces.
  const auto bent =
      read_input_mesh(folder.file("bent.off", "OFF 8 6 0\n-0.2 -0.2 -0.2" + rows), RunControl{});
  REQUIRE(bent.ok());
  CHECK(bent->soup.triangles.size() == 12);
  REQUIRE(bent->notes.size() == 1);
  CHECK(bent->notes[0].text.find("3 of 6 faces") != std::string::npos);
  CHECK(bent->notes[0].text.find("shortest diagonals") != std::string::npos);
  // The four corners of a face stand 0.05 off its plane, up and down, seen nearly along it.
  CHECK(bent->notes[0].deviation == doctest::Approx(0.05).epsilon(0.1));
  CHECK(told({"by up to", 0.05}, 0.5) == "by up to 0.1 δ.");
}

TEST_CASE("a cancelled control ends reading in every format") {
  const TemporaryFolder folder;
  RunControl control;
  control.cancel();
  for (const std::string& text : {off, obj, ply("vertex_ids") + ply_rows, ascii_stl(), binary_stl(4)}) {
    const auto mesh = read_input_mesh(folder.file("a.stl", text), control);
    REQUIRE_FALSE(mesh.ok());
    CHECK(mesh.error().code == ErrorCode::cancelled);
  }
}
