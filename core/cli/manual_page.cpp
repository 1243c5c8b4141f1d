// The order of sections is that of man-pages(7).
#include "cli/manual_page.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace isoscope {
namespace {

/// Text that is no request: hyphens are those that a terminal takes when they are copied.
std::string escaped(std::string_view text) {
  std::string out;
  if (text.starts_with('.') || text.starts_with('\'')) out = "\\&";
  for (const char c : text) {
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

/// An argument of a macro, in quotes.
std::string argument(std::string_view text) {
  std::string out = escaped(text);
  for (std::size_t at = out.find('"'); at != std::string::npos; at = out.find('"', at + 2))
    out.replace(at, 1, "\"\"");
  return "\"" + out + "\"";
}

std::string paragraphs(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out += end == 0 ? ".PP\n" : escaped(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

std::string_view first_sentence(std::string_view text) {
  const std::size_t end = text.find(". ");
  if (end != text.npos) return text.substr(0, end);
  if (text.ends_with('.')) text.remove_suffix(1);
  return text;
}

std::string capital(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string hyphenated(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '-');
  return text;
}

std::string section(const std::string& title) {
  return ".SH " + argument(title) + "\n";
}

/// What is listed: the name in bold, what it takes in italics, the text below.
std::string entry(std::string name, const std::string& values, const std::string& text) {
  if (const std::size_t comma = name.find(','); comma != name.npos) name.insert(comma + 1, " ");
  return ".TP\n.BI " + argument(name) + (values.empty() ? "" : " " + argument(" " + values)) + "\n" +
         escaped(text) + "\n";
}

std::string entries(const std::string& title, const std::vector<ManualEntry>& all) {
  if (all.empty()) return {};
  std::string out = section(title);
  for (const ManualEntry& e : all) out += entry(e.name, e.values, e.text);
  return out;
}

} // namespace

std::string ManualPage::name() const {
  return hyphenated(program);
}

std::string ManualPage::troff() const {
  std::string out = ".TH " + argument(upper(name())) + " 1 \"\" " + argument("isoscope " + version) + "\n";
  out += section("NAME") + escaped(name()) + " \\- " + escaped(first_sentence(about)) + "\n";
  out += section("SYNOPSIS") + ".BI " + argument(program) + " " + argument(" " + usage) + "\n";
  for (const ManualVerb& v : verbs)
    out += ".br\n.BI " + argument(program + " " + v.name) + " " + argument(" " + v.arguments) + "\n";
  out += section("DESCRIPTION") + escaped(about) + "\n";
  out += entries("ARGUMENTS", arguments) + entries("OPTIONS", options);
  std::vector<std::string> others;
  if (const std::size_t verb = program.rfind(' '); verb != program.npos)
    others.push_back(hyphenated(program.substr(0, verb)));
  if (!verbs.empty()) out += section("COMMANDS");
  for (const ManualVerb& v : verbs) {
    others.push_back(hyphenated(program + " " + v.name));
    out += entry(program + " " + v.name, v.arguments, capital(v.does) + "; see " + others.back() + "(1).");
  }
  if (!notes.empty()) out += section("NOTES") + paragraphs(notes);
  if (!exit_status.empty()) out += section("EXIT STATUS") + escaped(capital(exit_status)) + "\n";
  others.insert(others.end(), see_also.begin(), see_also.end());
  if (!others.empty()) out += section("SEE ALSO");
  for (const std::string& other : others)
    out += ".BR " + argument(other) + (&other == &others.back() ? " (1)\n" : " (1),\n");
  return out;
}

} // namespace isoscope
