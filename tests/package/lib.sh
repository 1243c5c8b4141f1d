# What the tests of packages share. Sourced; gives $temporary, a folder that goes with the test.
# shellcheck shell=bash
temporary=$(mktemp -d)
trap 'rm -rf -- "$temporary"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# Ends the test as skipped where a tool is missing: need TOOL...
need() {
  local tool
  for tool; do
    command -v "$tool" >/dev/null || {
      echo "SKIPPED: $tool is missing" >&2
      exit 77
    }
  done
}
# Runs a check where its tool is there, and says so where it is not.
where_there() {
  if command -v "$1" >/dev/null; then
    "$@" || fail "$*"
  else
    echo "not checked: $1 is missing" >&2
  fi
}
# What is in a folder, one file a line.
files_in() { (cd "$1" && find . ! -type d -printf '%P\n' | sort); }
same() { diff <(printf '%s\n' "$1") <(printf '%s\n' "$2") >&2 || fail "$3 (above: < is wanted, > is there)"; }

# What is installed below the prefix for people who use the programs.
installed_files() {
  sort <<'FILES'
bin/isoscope
bin/isoscope-run
bin/isoscope-sweep
share/applications/isoscope.desktop
share/doc/isoscope/commands.md
share/doc/isoscope/grammar.md
share/icons/hicolor/scalable/apps/isoscope.svg
share/man/man1/isoscope-run-diff.1.gz
share/man/man1/isoscope-run-recover.1.gz
share/man/man1/isoscope-run-replay.1.gz
share/man/man1/isoscope-run-tiles-cut.1.gz
share/man/man1/isoscope-run-tiles-join.1.gz
share/man/man1/isoscope-run-tiles-rerun.1.gz
share/man/man1/isoscope-run-tiles-status.1.gz
share/man/man1/isoscope-run-tiles-step.1.gz
share/man/man1/isoscope-run-tiles.1.gz
share/man/man1/isoscope-run.1.gz
share/man/man1/isoscope-sweep-compare.1.gz
share/man/man1/isoscope-sweep-merge.1.gz
share/man/man1/isoscope-sweep-missing.1.gz
share/man/man1/isoscope-sweep-step.1.gz
share/man/man1/isoscope-sweep.1.gz
share/man/man1/isoscope.1.gz
share/metainfo/org.isoscope.Isoscope.metainfo.xml
share/mime/packages/isoscope.xml
FILES
}
