"""The command line of scripts/experiments: which experiments, how large, from where and to where."""
import argparse
import json
import os
import signal
import sys

from lab.errors import LabError
from lab.experiments import EXPERIMENTS
from lab.experiments.choices import SIZES
from lab.laboratory import Laboratory
from lab.page import as_html, markdown
from lab.programs import built

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
TITLE = "The paper's evaluation, and ours"


def parsed(arguments):
    parser = argparse.ArgumentParser(
        prog="experiments", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Reproduces the evaluation of the paper: one page with the published numbers beside ours, plots, "
                    "pictures, and a CSV file an experiment.",
        epilog="experiments: " + " ".join(EXPERIMENTS) + "\n\nStopped by Ctrl-C or otherwise, the same command goes on "
               "where it was, and what there was no time for is run by the next call.\nExit status: 0 done, 1 done but some runs failed, 2 usage, 3 a model is missing, "
               "130 interrupted.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="experiments; all without any")
    parser.add_argument("--models", metavar="FOLDER",
                        help="where the paper's own models are (fertility, blade, lucy, armadillo, elephant; all .off); "
                             "without it libcgal-demo's stand in")
    parser.add_argument("--quick", action="store_true", help="large tolerances alone: within 10 minutes on two cores")
    parser.add_argument("--size", choices=SIZES, help="tiny (seconds, to try this program), quick, short (half an hour of "
                                                      "CPU time at most), whole (the paper's tolerances: hours); default whole")
    parser.add_argument("-o", "--output", metavar="FOLDER", default=os.path.join(ROOT, "out", "experiments"),
                        help="the page and everything beside it; default out/experiments")
    parser.add_argument("--programs", metavar="FOLDER",
                        help="where isoscope-run and isoscope-peer are; without it they are built first")
    parser.add_argument("--no-install", action="store_true", help="installs nothing before the build")
    parser.add_argument("--effort", type=int, choices=range(4), default=None,
                        help="of the improver in each run: 0 (least time) to 3 (fewest vertices); default 0 for tiny, 1 for "
                             "quick, else 2")
    parser.add_argument("--cpu-limit", metavar="S", type=float, default=None,
                        help="CPU seconds after which a run is given up; default 120 for quick, 600 for short, else 36000")
    parser.add_argument("--time-limit", metavar="S", type=float, default=None,
                        help="seconds after which nothing more is run; default 540 for quick, else none")
    asked = parser.parse_args(arguments)
    unknown = [name for name in asked.names if name not in EXPERIMENTS]
    if unknown:
        parser.error(f"there is no experiment '{unknown[0]}': {', '.join(EXPERIMENTS)}")
    if asked.quick and asked.size not in (None, "quick"):
        parser.error(f"--quick is --size quick, not {asked.size}")
    asked.size = "quick" if asked.quick else asked.size or "whole"
    if asked.effort is None:
        asked.effort = {"tiny": 0, "quick": 1}.get(asked.size, 2)
    if asked.cpu_limit is None:
        asked.cpu_limit = {"tiny": 120, "quick": 120, "short": 600}.get(asked.size, 36000)
    if asked.time_limit is None:
        asked.time_limit = 540 if asked.size == "quick" else float("inf")
    if asked.cpu_limit < 1:
        parser.error("--cpu-limit takes seconds from 1 on")
    if asked.time_limit < 0:
        parser.error("--time-limit takes seconds from 0 on")
    return asked


def preface(names, lab, paper):
    chosen = "" if len(names) == len(EXPERIMENTS) else " ".join(names) + " "
    cores = len(os.sched_getaffinity(0))
    return [
        f"Published numbers are those of {paper['source']}; ours are of a run of "
        f"`scripts/experiments {chosen}--size {lab.size} --effort {lab.effort}` on {cores} cores: "
        f"{lab.runs} runs, {lab.cpu_seconds / 60:.1f} minutes of CPU time. Times are CPU seconds, so that other programs on "
        "the machine do not count.",
        "Models differ: where the paper's own are not at hand, others stand in, as each section says, so counts are beside "
        "each other for their order and their slope, not for a contest. Tolerances are percentages of the longest edge of the "
        "bounding box. Our δ is the distance to the input, Ω = {d ≤ δ}, as §2.4 of the paper has it for its Figure 14; §2.2 "
        "and the caption of Figure 18 call δ the separation of the two boundaries, which would be twice as much. Plots "
        "over δ have the paper's numbers both ways.",
    ]


def make_page(names, lab, paper):
    sections = []
    for name in names:
        section = EXPERIMENTS[name](lab, paper)
        section.write_csv(os.path.join(lab.output, name + ".csv"))
        sections.append(section)
        # After each, so that what is there can be read while the rest runs.
        for file, text in (("README.md", markdown(TITLE, preface(names, lab, paper), sections)),
                           ("index.html", as_html(TITLE, preface(names, lab, paper), sections))):
            with open(os.path.join(lab.output, file), "w", encoding="utf-8") as out:
                out.write(text)


def main(arguments):
    asked = parsed(arguments)
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    try:
        os.makedirs(os.path.join(asked.output, "runs"), exist_ok=True)
        with open(os.path.join(ROOT, "assets", "experiments", "paper.json"), encoding="utf-8") as file:
            paper = json.load(file)
        programs = asked.programs or built(ROOT, not asked.no_install)
        lab = Laboratory(programs, asked.models, asked.size, asked.effort, asked.output,
                         asked.cpu_limit, asked.time_limit)
        make_page([n for n in EXPERIMENTS if not asked.names or n in asked.names], lab, paper)
    except LabError as error:
        print(f"experiments: {error}", file=sys.stderr)
        return error.status
    except OSError as error:
        print(f"experiments: {error.strerror}: {error.filename}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("experiments: stopped; the same command goes on from here", file=sys.stderr)
        return 130
    print(os.path.join(asked.output, "README.md"))
    for failure in lab.failures:
        print(f"experiments: {failure}", file=sys.stderr)
    return 1 if lab.failures else 0
