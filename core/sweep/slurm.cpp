// The script's text, and sbatch.
#include "sweep/slurm.h"

#include "base/pending_file.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include <sys/wait.h>

namespace isoscope::sweep {

namespace {

/// For the shell.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::size_t tasks_of(const ArrayPlan& array, std::size_t runs) {
  return std::min(std::max<std::size_t>(array.most_tasks, 1), std::max<std::size_t>(runs, 1));
}

/// What the command prints and its exit status.
std::pair<std::string, int> output_of(const std::string& command) {
  std::string text;
  std::FILE* const pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) return {text, 127};
  char bytes[512];
  for (std::size_t n = 0; (n = std::fread(bytes, 1, sizeof bytes, pipe)) > 0;) text.append(bytes, n);
  const int status = ::pclose(pipe);
  return {text, WIFEXITED(status) ? WEXITSTATUS(status) : 127};
}

std::string first_word(const std::string& text) {
  return text.substr(0, text.find_first_of(" ;\n"));
}

} // namespace

std::string array_tasks(const ArrayPlan& array, std::size_t runs) {
  std::set<std::size_t> tasks;
  for (const std::size_t run : array.runs) tasks.insert(run % tasks_of(array, runs));
  std::string text;
  for (auto at = tasks.begin(); at != tasks.end();) {
    const std::size_t first = *at;
    std::size_t last = first;
    while (++at != tasks.end() && *at == last + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(first);
    if (last > first) text += "-" + std::to_string(last);
  }
  return text;
}

std::string array_script(const Folder& folder, const Plan& plan, const ArrayPlan& array,
                         const std::string& program) {
  const std::string place = std::filesystem::absolute(folder.path()).string();
  std::string text = "#!/bin/sh\n"
                     "# Written by isoscope-sweep --slurm: sbatch " +
                     folder.script().filename().string() +
                     " submits it again; isoscope-sweep merge joins what its tasks have done.\n"
                     "#SBATCH --job-name=isoscope-sweep\n"
                     "#SBATCH --array=" +
                     array_tasks(array, plan.runs()) +
                     "\n#SBATCH --cpus-per-task=" + std::to_string(array.threads) +
                     "\n#SBATCH --output=" + quoted(place + "/parts/%a.log") + "\n";
  for (const std::string& option : array.options) text += "#SBATCH " + option + "\n";
  return text + "exec " + quoted(program) + " step " + quoted(place) +
         " --run \"$SLURM_ARRAY_TASK_ID\" --every " + std::to_string(tasks_of(array, plan.runs())) + "\n";
}

Result<std::string> submit(const Folder& folder, const Plan& plan, const ArrayPlan& array,
                           const std::string& program) {
  PendingFile out;
  if (Status opened = out.open(folder.script()); !opened) return opened.error();
  out.append(array_script(folder, plan, array, program));
  if (Status written = out.commit(); !written) return written.error();
  const Error refused{ErrorCode::io, "sbatch did not take " + folder.script().string() + ".",
                      "Is Slurm there? The script can be submitted by hand."};
  const auto [number, status] = output_of("sbatch --parsable " + quoted(folder.script().string()));
  const std::string job = first_word(number);
  if (status != 0 || job.empty()) return refused;
  std::string options;
  for (const std::string& option : array.options) options += " " + quoted(option);
  const std::string merging =
      quoted(program) + " merge " + quoted(std::filesystem::absolute(folder.path()).string());
  const auto [merge_number, merge_status] =
      output_of("sbatch --parsable --job-name=isoscope-merge --dependency=afterany:" + job + options +
                " --output=" + quoted((std::filesystem::absolute(folder.parts()) / "merge.log").string()) +
                " --wrap=" + quoted(merging));
  if (merge_status != 0 || merge_number.empty())
    return Error{ErrorCode::io, "sbatch took the array as job " + job + ", but not the job that merges.",
                 "Once it has ended: " + merging};
  return job;
}

} // namespace isoscope::sweep
