// isoscope-corpus: all models of libcgal-demo in a sweep, compared with the table of the last time.
#include "support/models.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace {

namespace fs = std::filesystem;

/// Runs isoscope-sweep with these words; its exit status.
int sweep(const std::vector<std::string>& words) {
  std::string command = "'" ISOSCOPE_SWEEP_PROGRAM "'";
  for (const std::string& word : words) command += " '" + word + "'";
  const int status = std::system(command.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : 4;
}

/// The models whose names contain one of these parts, all without any, as a list for the sweep.
bool write_list(const fs::path& file, const std::vector<std::string>& parts) {
  std::ofstream out(file);
  bool any = false;
  for (const fs::path& model : isoscope::demo_models()) {
    const std::string name = model.filename().string();
    const auto is_part = [&](const std::string& part) { return name.find(part) != std::string::npos; };
    if (!parts.empty() && std::none_of(parts.begin(), parts.end(), is_part)) continue;
    // Beside the models, so that tables have their bare names.
    std::error_code failure;
    fs::create_symlink(model, file.parent_path() / name, failure);
    out << name << '\n';
    any = true;
  }
  return any;
}

} // namespace

int main(int argc, char** argv) {
  std::vector<std::string> models;
  std::string tolerances = "8%,3%,1%,0.3%", output, table = ISOSCOPE_CORPUS_TABLE;
  CLI::App app("Runs isoscope-run on all models of libcgal-demo and compares them with the table of the last "
               "time. What follows -- is passed to isoscope-sweep.");
  app.add_option("models", models, "parts of file names; all without any");
  app.add_option("--tolerances", tolerances, "for each model")->capture_default_str();
  app.add_option("--table", table, "what to compare with")->capture_default_str();
  app.add_option("-o,--output", output, "the folder of the sweep, which goes on where it was")->required();
  app.footer("Exit status: 0 nothing is worse, 1 something is, 2 usage.");
  const auto behind = std::find(argv, argv + argc, std::string("--"));
  try {
    app.parse(static_cast<int>(behind - argv), argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  const fs::path inputs = fs::absolute(output) / "models";
  std::error_code failure;
  fs::create_directories(inputs, failure);
  if (!write_list(inputs / "list", models)) {
    std::printf("Nothing to do: no model fits, or libcgal-demo is not installed.\n");
    return 0;
  }
  std::vector<std::string> words{(inputs / "list").string(), "--tolerance", tolerances, "-o", output};
  for (auto word = behind; word != argv + argc && ++word != argv + argc;) words.emplace_back(*word);
  if (std::find(words.begin(), words.end(), "--effort") == words.end())
    words.insert(words.end(), {"--effort", "0"});
  if (const int status = sweep(words); status >= 2) return status;
  return sweep({"compare", table, output});
}
