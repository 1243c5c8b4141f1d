// A look at names, headers and the first words of lines.
#include "input/point_files.h"

#include "input/mesh_format.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace isoscope {
namespace {

constexpr std::size_t longest_line = 4096; ///< no header has a longer one

/// The next line, of any line ends, without what follows a '#'; nothing at the end or where it is too long.
std::optional<std::string> next_line(std::istream& in) {
  std::string line;
  for (int c = in.get(); c != std::istream::traits_type::eof(); c = in.get()) {
    if (c == '\n' || c == '\r') {
      if (c == '\r' && in.peek() == '\n') in.get();
      return line.substr(0, line.find('#'));
    }
    if (line.size() == longest_line) return {};
    line.push_back(static_cast<char>(c));
  }
  if (line.empty()) return {};
  return line.substr(0, line.find('#'));
}

bool is_ply_of_points(std::istream& in) {
  bool vertices = false;
  while (const auto line = next_line(in)) {
    std::istringstream words(*line);
    std::string word, element;
    long long count = 0;
    words >> word >> element >> count;
    if (word == "end_header") return vertices;
    if (word != "element" || count <= 0) continue;
    if (element == "vertex")
      vertices = true;
    else if (element == "face" || element == "tristrips")
      return false;
  }
  return false;
}

/// The counts stand behind the keyword, on its line or on the next one with words.
bool is_off_of_points(std::istream& in) {
  bool keyword = false;
  while (const auto line = next_line(in)) {
    std::istringstream words(*line);
    std::string word;
    if (!keyword && words >> word) keyword = true;
    long long vertices = 0, faces = -1;
    if (words >> vertices >> faces) return vertices > 0 && faces == 0;
    if (!words.eof()) return false;
  }
  return false;
}

bool is_obj_of_points(std::istream& in) {
  bool vertices = false;
  while (const auto line = next_line(in)) {
    const std::size_t begin = line->find_first_not_of(" \t");
    if (begin == std::string::npos || begin + 1 >= line->size()) continue;
    const char kind = (*line)[begin], after = (*line)[begin + 1];
    if (after != ' ' && after != '\t') continue;
    if (kind == 'f') return false;
    vertices = vertices || kind == 'v';
  }
  return vertices;
}

} // namespace

bool holds_points_alone(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (is_points_extension(extension)) return true;
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return false; // a pipe can be read but once
  std::ifstream in(file, std::ios::binary);
  if (extension == ".ply" || extension == ".PLY") return is_ply_of_points(in);
  if (extension == ".off" || extension == ".OFF") return is_off_of_points(in);
  if (extension == ".obj" || extension == ".OBJ") return is_obj_of_points(in);
  return false;
}

} // namespace isoscope
