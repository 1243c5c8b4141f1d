// Written out by hand.
#include "sweep/tiny_models.h"

#include <array>
#include <cstdio>
#include <fstream>

#include <sys/wait.h>

namespace isoscope::test {

namespace fs = std::filesystem;

std::string box(double x, double y, double z) {
  std::string text = "OFF\n8 6 0\n";
  for (const double c : {0.0, z})
    for (const auto& [a, b] : {std::pair(0.0, 0.0), std::pair(x, 0.0), std::pair(x, y), std::pair(0.0, y)})
      text += std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  return text + "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
}

std::string ring() {
  std::string text = "OFF\n16 16 0\n";
  for (const int z : {0, 1})
    for (const double half : {3.0, 1.0})
      for (const auto& [a, b] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        text += std::to_string(a * half) + " " + std::to_string(b * half) + " " + std::to_string(z) + "\n";
  const auto face = [&](int a, int b, int c, int d) {
    text += "4 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + " " +
            std::to_string(d) + "\n";
  };
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    face(i, j, 8 + j, 8 + i);           // outer wall
    face(4 + j, 4 + i, 12 + i, 12 + j); // inner wall
    face(8 + i, 8 + j, 12 + j, 12 + i); // top
    face(j, i, 4 + i, 4 + j);           // bottom
  }
  return text;
}

fs::path make_models(const TemporaryFolder& folder) {
  const fs::path models = folder / "models";
  fs::create_directories(models / "deep");
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(models / name) << text; };
  write("box.off", box(2, 1, 1));
  write("deep/ring.off", ring());
  write("broken.off", "OFF\n3 1");
  write("notes.md", "no model");
  return models;
}

fs::path script(const TemporaryFolder& folder, const std::string& name, const std::string& text) {
  const auto file = folder.file(name, "#!/bin/sh\n" + text + "\n");
  fs::permissions(file, fs::perms::owner_all);
  return file;
}

std::string quoted(const fs::path& path) {
  return "'" + path.string() + "'";
}

Said shell(const std::string& line) {
  const std::string command = "SWEEP='" ISOSCOPE_SWEEP_PROGRAM "'; { " + line + "\n} 2>&1";
  Said said;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return said;
  std::array<char, 4096> bytes{};
  for (std::size_t n = 0; (n = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    said.text.append(bytes.data(), n);
  const int status = ::pclose(pipe);
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return said;
}

std::string steady_table(const fs::path& table) {
  const auto rows = sweep::read_table(table);
  std::string text;
  if (!rows) return rows.error().message;
  for (sweep::Row row : *rows) {
    row.seconds = row.memory = 0;
    text += sweep::json_line(row) + "\n";
  }
  return text;
}

} // namespace isoscope::test
