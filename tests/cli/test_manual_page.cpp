// Manual pages: what a command line tells of itself, as troff.
#include "cli/command_line.h"
#include "cli/manual_page.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace isoscope;

namespace {

bool holds(const std::string& page, const std::string& lines) {
  return page.find(lines) != std::string::npos;
}

/// What a command line answers to these words.
std::string answered(CommandLine& line, const std::vector<const char*>& words) {
  const auto asked = line.read(static_cast<int>(words.size()), words.data());
  REQUIRE(asked.ok());
  REQUIRE(asked->has_value());
  return **asked;
}

} // namespace

TEST_CASE("a page has its sections in order, and no text of it is taken for a request") {
  ManualPage page;
  page.program = "lamp light";
  page.version = "1.2";
  page.about = "Lights a lamp. It stays lit.";
  page.usage = "[OPTIONS] LAMP";
  page.arguments = {{"LAMP", "TEXT", ".lamprc names them"}};
  page.options = {{"-b,--brightness", "FLOAT", "of \"1\" or C:\\lamp"}, {"--red", "", "'red' light"}};
  page.verbs = {{"twice", "LAMP LAMP", "lights two"}};
  page.notes = "One.\n\nTwo.";
  page.exit_status = "0 lit; 1 dark.";
  page.see_also = {"candle"};
  CHECK(page.name() == "lamp-light");
  CHECK(page.troff() == R"(.TH "LAMP\-LIGHT" 1 "" "isoscope 1.2"
.SH "NAME"
lamp\-light \- Lights a lamp
.SH "SYNOPSIS"
.BI "lamp light" " [OPTIONS] LAMP"
.br
.BI "lamp light twice" " LAMP LAMP"
.SH "DESCRIPTION"
Lights a lamp. It stays lit.
.SH "ARGUMENTS"
.TP
.BI "LAMP" " TEXT"
\&.lamprc names them
.SH "OPTIONS"
.TP
.BI "\-b, \-\-brightness" " FLOAT"
of "1" or C:\elamp
.TP
.BI "\-\-red"
\&'red' light
.SH "COMMANDS"
.TP
.BI "lamp light twice" " LAMP LAMP"
Lights two; see lamp\-light\-twice(1).
.SH "NOTES"
One.
.PP
Two.
.SH "EXIT STATUS"
0 lit; 1 dark.
.SH "SEE ALSO"
.BR "lamp" (1),
.BR "lamp\-light\-twice" (1),
.BR "candle" (1)
)");
}

TEST_CASE("a command line writes its page, whatever is missing on it, and help ends with the same facts") {
  std::string lamp, colour;
  double brightness = 1;
  CommandLine line("Lights a lamp.", "lamp");
  line.option("LAMP", lamp, "which one", true);
  line.option("-b,--brightness", brightness, "of its light", 0, 1.5);
  line.choice("--colour", colour, {"red", "blue"}, "of its light");
  line.verb({"test", "LAMP", "lights it for a moment"});
  line.notes("It stays lit.");
  line.exit_status("0 lit; 1 dark.");
  const std::string page = answered(line, {"lamp", "--man"});
  CHECK(page.starts_with(".TH \"LAMP\" 1 "));
  CHECK(page.ends_with("(1)\n"));
  for (const char* lines :
       {".BI \"lamp\" \" [OPTIONS] LAMP\"\n", ".BI \"LAMP\" \" TEXT REQUIRED\"\nwhich one\n",
        ".BI \"\\-b, \\-\\-brightness\" \" FLOAT\"\nof its light; 0 to 1.5\n",
        ".BI \"\\-\\-colour\" \" red|blue\"\nof its light\n", ".BI \"\\-\\-man\"\n",
        ".BR \"lamp\\-test\" (1)\n"}) {
    CAPTURE(lines);
    CHECK(holds(page, lines));
  }
  const std::string help = answered(line, {"lamp", "--help"});
  CHECK(holds(help, "--man "));
  CHECK(holds(help, "\nlamp test LAMP lights it for a moment; test --help tells more.\n\nIt stays lit.\n\n"
                    "Exit status: 0 lit; 1 dark.\n"));
}
