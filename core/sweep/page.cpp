// The parts of the page in their order; the table's rows are JSON, which the script turns into lines as they
// come into sight.
#include "sweep/page.h"

#include "base/markup.h"
#include "base/numbers.h"
#include "base/pending_file.h"
#include "sweep/histogram.h"
#include "sweep/page_parts.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace isoscope::sweep {

namespace {

using Json = nlohmann::ordered_json;
using Rows = std::map<std::size_t, Row>;

constexpr std::size_t most_embedded = 24u << 20;

/// The names of the outcomes' colours in the style sheet.
constexpr std::array<const char*, outcome_count> color_names{
    "certified", "uncertified", "stopped", "refused", "missing", "time", "memory", "crashed", "failed"};

std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A path below the folder as a reference of the page.
std::string reference(const std::string& path) {
  std::string out;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (byte >= '0' && byte <= '9') || (byte >= 'A' && byte <= 'Z') ||
                       (byte >= 'a' && byte <= 'z') ||
                       std::string_view("/-_.~").find(c) != std::string_view::npos;
    constexpr const char* digits = "0123456789ABCDEF";
    if (plain)
      out += c;
    else
      out += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return out;
}

/// What a person reads of a run that is not certified: lines of the certificate that do not hold, and the
/// program's last words.
std::string words_of(const Row& row) {
  std::string words;
  if (row.outcome != Outcome::certified)
    for (const auto& [line, holds] : row.certificate) {
      if (holds || line == "holds") continue;
      std::string plain = line;
      std::replace(plain.begin(), plain.end(), '_', ' ');
      words += (words.empty() ? "Not: " : ", ") + plain;
    }
  if (words.empty() || row.message.empty()) return words + row.message;
  return words + ". " + row.message;
}

template <class T> Json value(const std::optional<T>& v) {
  return v ? Json(*v) : Json(nullptr);
}

Json rows_of(const Folder& folder, const Plan& plan, const Rows& rows) {
  Json lines = Json::array();
  std::size_t embedded = 0;
  for (const auto& [run, row] : rows) {
    std::string picture = file_text(folder.picture(run));
    if (!picture.empty()) {
      embedded += picture.size();
      picture = embedded <= most_embedded ? "data:image/png;base64," + base64(picture)
                                          : "pictures/" + folder.picture(run).filename().string();
    }
    lines.push_back({run, row.asked.model, run % plan.tolerances.size(), static_cast<int>(row.outcome),
                     value(row.vertices), value(row.euler_characteristic), value(row.covers), row.seconds,
                     std::round(row.memory), words_of(row), reference(row.output), picture});
  }
  return lines;
}

std::string data_of(const Folder& folder, const Plan& plan, const Rows& rows) {
  Json outcomes = Json::array();
  for (int i = 0; i < outcome_count; ++i)
    outcomes.push_back(
        {std::string(name(static_cast<Outcome>(i))), color_names[static_cast<std::size_t>(i)]});
  const Json data{
      {"tolerances", plan.tolerances}, {"outcomes", outcomes}, {"rows", rows_of(folder, plan, rows)}};
  const std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "\\u003c"; // no text can end the script
    else
      out += c;
  }
  return out;
}

std::array<std::size_t, outcome_count> counts_of(const Rows& rows) {
  std::array<std::size_t, outcome_count> counts{};
  for (const auto& [run, row] : rows) ++counts[static_cast<std::size_t>(row.outcome)];
  return counts;
}

std::string time_text(double seconds) {
  if (seconds < 120) return general(seconds, 3) + " s";
  if (seconds < 7200) return general(seconds / 60, 3) + " minutes";
  return general(seconds / 3600, 3) + " hours";
}

std::string head(const Plan& plan, const Rows& rows) {
  double seconds = 0;
  for (const auto& [run, row] : rows) seconds += row.seconds;
  const std::size_t certified = counts_of(rows)[0];
  std::string tolerances, options;
  for (const std::string& t : plan.tolerances) tolerances += (tolerances.empty() ? "" : ", ") + t;
  for (const std::string& o : plan.options) options += (options.empty() ? "" : " ") + o;
  std::string text = "<h1>" + grouped(certified) + " of " + counted(plan.runs(), "run") +
                     " certified</h1>\n<p>" + counted(plan.models.size(), "model") +
                     " at δ = " + escaped_markup(tolerances) + "; " + time_text(seconds) + " of CPU time";
  if (!options.empty()) text += "; each with <code>" + escaped_markup(options) + "</code>";
  text += ".</p>\n";
  if (rows.size() < plan.runs())
    text += "<p>" + counted(plan.runs() - rows.size(), "run") + " to go: the sweep is not finished.</p>\n";
  return text;
}

std::string outcomes_bar(const Rows& rows) {
  const auto counts = counts_of(rows);
  std::string bar = "<div class=\"bar\">", chips = "<div class=\"chips\">";
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const std::string color = std::string("--c:var(--") + color_names[i] + ")";
    const std::string word(name(static_cast<Outcome>(i)));
    bar += "<span style=\"flex:" + std::to_string(counts[i]) + ";" + color + "\" title=\"" +
           grouped(counts[i]) + " " + word + "\"></span>";
    chips += "<button aria-pressed=\"false\" data-outcome=\"" + std::to_string(i) + "\" style=\"" + color +
             "\"><span class=\"dot\"></span>" + word + " " + grouped(counts[i]) + "</button>";
  }
  return bar + "</div>\n" + chips +
         "<p id=\"told\"></p><input type=\"search\" placeholder=\"Find a model or a word\" "
         "aria-label=\"Find\"></div>\n";
}

std::string histograms(const Plan& plan, const Rows& rows) {
  const std::size_t series = plan.tolerances.size();
  std::array<Histogram, 4> all{Histogram{"Vertices", "", {}, true}, Histogram{"CPU time", " s", {}, true},
                               Histogram{"Peak memory", " MB", {}, true},
                               Histogram{"Input covered within", " δ", {}, false}};
  for (Histogram& h : all) h.series.resize(series);
  for (const auto& [run, row] : rows) {
    const std::size_t s = run % series;
    if (row.vertices) all[0].series[s].push_back(static_cast<double>(*row.vertices));
    if (row.vertices && row.seconds > 0) all[1].series[s].push_back(row.seconds);
    if (row.vertices && row.memory > 0) all[2].series[s].push_back(row.memory);
    if (row.covers) all[3].series[s].push_back(*row.covers);
  }
  std::string plots, key;
  for (const Histogram& h : all)
    if (const std::string picture = svg(h); !picture.empty()) plots += "<figure>" + picture + "</figure>\n";
  if (plots.empty()) return {};
  if (series > 1)
    for (std::size_t s = 0; s < series; ++s)
      key += "<span><i class=\"s" + std::to_string(s % 6) +
             "\"></i>δ = " + escaped_markup(plan.tolerances[s]) + "</span>";
  return "<div class=\"plots\">" + plots + "</div>\n<div class=\"key\">" + key + "</div>\n";
}

constexpr const char* table_head = R"html(<table><thead><tr><th data-key="run" title="Order of the runs"></th>
<th class="l" data-key="model">Model</th><th data-key="tolerance">δ</th><th class="l" data-key="outcome">Outcome</th>
<th data-key="vertices" data-first="down">Vertices</th><th data-key="chi">χ</th>
<th data-key="covers" data-first="down" title="Largest distance from the input to the result, in δ">Covers, δ</th>
<th data-key="seconds" data-first="down">CPU, s</th><th data-key="memory" data-first="down">Memory, MB</th>
<th class="l words" data-key="words">Words</th></tr></thead><tbody></tbody></table>
<div id="end"></div><noscript><p>The table is in runs.jsonl beside this page; here it needs JavaScript.</p></noscript>
)html";

} // namespace

std::string page(const Folder& folder, const Plan& plan, const Rows& rows) {
  const std::string title = std::filesystem::absolute(folder.path()).lexically_normal().filename().string();
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
         "content=\"width=device-width,initial-scale=1\">\n<title>" +
         escaped_markup(title.empty() ? "Sweep" : title) + "</title>\n<style>" + page_style +
         "</style></head><body>\n" + head(plan, rows) + outcomes_bar(rows) + histograms(plan, rows) +
         table_head + "<script type=\"application/json\" id=\"rows\">" + data_of(folder, plan, rows) +
         "</script>\n<script>" + page_script + "</script>\n</body></html>\n";
}

Status write_page(const Folder& folder, const Plan& plan, const Rows& rows) {
  PendingFile out;
  if (Status opened = out.open(folder.page()); !opened) return opened;
  out.append(page(folder, plan, rows));
  return out.commit();
}

} // namespace isoscope::sweep
