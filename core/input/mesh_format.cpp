// Keywords, sizes and first bytes.
#include "input/mesh_format.h"

#include "input/foreign_formats.h"
#include "input/mesh_readers.h"

#include <algorithm>
#include <string>

namespace isoscope {

namespace {

const std::string known_formats = "Isoscope reads OFF, OBJ, PLY, STL and lists of points (XYZ).";

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// The first word of the first line that is neither empty nor a comment, and that line.
struct FirstLine {
  std::string_view word, line;
};

FirstLine first_line(std::string_view head) {
  while (!head.empty()) {
    const std::size_t end = std::min(head.find_first_of("\r\n"), head.size());
    std::string_view line = head.substr(0, end);
    head.remove_prefix(std::min(end + 1, head.size()));
    while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
    if (line.empty() || line.front() == '#') continue;
    const auto* stop = std::find_if(line.begin(), line.end(), is_space);
    return {line.substr(0, static_cast<std::size_t>(stop - line.begin())), line};
  }
  return {};
}

bool is_obj_keyword(std::string_view word) {
  constexpr std::string_view keywords[] = {"v", "vn", "vt", "vp", "f",      "g",
                                           "o", "s",  "l",  "p",  "mtllib", "usemtl"};
  return std::find(std::begin(keywords), std::end(keywords), word) != std::end(keywords);
}

/// Whether it begins as OFF does after its keyword, with two whole numbers.
bool begins_with_counts(std::string_view line) {
  for (int i = 0; i < 2; ++i) {
    const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
    if (digits == 0 || (digits < line.size() && !is_space(line[digits]))) return false;
    line.remove_prefix(digits);
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  }
  return true;
}

/// Whether it holds bytes that no text has, in whatever encoding of 8 bits.
bool is_binary(std::string_view head) {
  return std::any_of(head.begin(), head.end(), [](char c) {
    return (static_cast<unsigned char>(c) < 0x20 && !is_space(c)) || c == 0x7f;
  });
}

bool holds_word(std::string_view text, std::string_view word) {
  for (std::size_t i = 0; i + word.size() <= text.size(); ++i)
    if (same_word(text.substr(i, word.size()), word)) return true;
  return false;
}

/// Binary files may begin with "solid" too, and names in text files may hold any byte.
bool is_ascii_stl(std::string_view head, std::string_view first_word) {
  if (!same_word(first_word, "solid") && !same_word(first_word, "facet")) return false;
  return !is_binary(head) || (holds_word(head, "facet") && holds_word(head, "vertex"));
}

/// Passes over the mark that editors put in front of text, and decodes what is in two bytes a character.
void pass_byte_order_mark(FileScanner& in) {
  const std::string_view head = in.head();
  if (head.starts_with("\xef\xbb\xbf")) in.skip(3);
  if (head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff")) in.decode_utf16(head[0] == '\xfe');
}

[[noreturn]] void fail_unknown(const FileScanner& in, std::string_view extension, bool text) {
  if (same_word(extension, ".off"))
    in.fail("does not begin with the word OFF", "Is it an OFF file? Export it anew.");
  if (same_word(extension, ".ply"))
    in.fail("does not begin with the word ply", "Is it a PLY file? Export it anew.");
  in.fail(text ? "is in no format that we know" : "holds binary data in no format that we know",
          known_formats + " Export it in one of them.");
}

} // namespace

bool is_points_extension(std::string_view extension) {
  constexpr std::string_view extensions[] = {".xyz", ".asc",  ".txt",  ".pts",    ".csv",
                                             ".pwn", ".xyzn", ".npts", ".xyzrgb", ".neu"};
  return std::any_of(std::begin(extensions), std::end(extensions),
                     [&](auto e) { return same_word(e, extension); });
}

MeshFormat detect_format(FileScanner& in) {
  // Before any mark is believed: the header of binary STL may hold anything.
  if (is_whole_binary_stl(in.head(), in.size())) return MeshFormat::stl_binary;
  pass_byte_order_mark(in);
  const std::string_view head = in.head();
  const std::string extension = in.file().extension().string();
  const FirstLine first = first_line(head);
  if (head.starts_with("ply") && head.size() > 3 && is_space(head[3])) return MeshFormat::ply;
  if (is_off_keyword(first.word)) return MeshFormat::off;
  if (const ForeignFormat* foreign = foreign_format(head))
    in.fail("is " + std::string(foreign->name), std::string(foreign->remedy));
  if (is_ascii_stl(head, first.word)) return MeshFormat::stl_ascii;
  if (same_word(first.word, "solid")) return MeshFormat::stl_binary;
  if (is_obj_keyword(first.word)) return MeshFormat::obj;
  const bool text = head.find('\0') == std::string_view::npos;
  if (same_word(extension, ".off") && begins_with_counts(first.line)) return MeshFormat::off;
  if (looks_like_points(first.line) || (is_points_extension(extension) && !is_binary(head)))
    return MeshFormat::xyz;
  if (same_word(extension, ".stl") && is_binary(head)) return MeshFormat::stl_binary;
  if (same_word(extension, ".obj") && text) return MeshFormat::obj;
  fail_unknown(in, extension, text);
}

} // namespace isoscope
