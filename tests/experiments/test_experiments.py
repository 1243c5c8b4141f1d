"""Tests scripts/experiments: a whole run at its smallest size and at the quick one, stopping and going on, errors, and
its parts alone.

Called with the folder of the programs; further arguments go to unittest."""
import contextlib
import csv
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree as xml
import zlib

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
SCRIPT = os.path.join(ROOT, "scripts", "experiments")
PROGRAMS = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 else ""
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "scripts"))

from lab import process, shapes  # noqa: E402
from lab.errors import LabError  # noqa: E402
from lab.experiments import EXPERIMENTS  # noqa: E402
from lab.experiments.choices import DELTAS, SIZES  # noqa: E402
from lab.command import parsed  # noqa: E402
from lab.laboratory import Laboratory, thinned  # noqa: E402
from lab.mesh import Mesh, read_off, write_off  # noqa: E402
from lab.models import ARCHIVES, Models  # noqa: E402
from lab.page import Section, as_html, markdown  # noqa: E402
from lab.picture import draw  # noqa: E402
from lab.plot import Line, plot  # noqa: E402
from lab.programs import NEEDED  # noqa: E402
from lab.store import Store  # noqa: E402


def experiments(*arguments, programs=PROGRAMS):
    return subprocess.run([sys.executable, SCRIPT, "--programs", programs, *arguments], capture_output=True, text=True,
                          check=False)


def rows_of(folder, name):
    with open(os.path.join(folder, name + ".csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def pixels_of(path):
    """Width and rows of RGB of a PNG that the pictures write."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    width, height = struct.unpack(">II", data[16:24])
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += 12 + size
    raw = zlib.decompress(packed)
    assert len(raw) == height * (3 * width + 1)
    return width, [raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)] for y in range(height)]


class Whole(unittest.TestCase):
    """Everything once, at the smallest size."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = cls.folder.name
        cls.done = experiments("--size", "tiny", "-o", cls.out)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def read(self, name):
        with open(os.path.join(self.out, name), encoding="utf-8") as file:
            return file.read()

    def test_every_experiment_has_its_section_and_numbers(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(self.done.stdout.strip(), os.path.join(self.out, "README.md"))
        page = self.read("README.md")
        for name in EXPERIMENTS:
            self.assertIn(f'<a id="{name}"></a>', page)
            self.assertTrue(rows_of(self.out, name), name)

    def test_every_file_that_the_page_names_is_there_and_sound(self):
        page = self.read("README.md")
        files = set(re.findall(r"\]\(([^#)]+)\)", page))
        self.assertEqual(files, {f for f in re.findall(r'(?:src|href)="([^#"]+)"', self.read("index.html"))})
        for file in files:
            path = os.path.join(self.out, file)
            self.assertTrue(os.path.getsize(path) > 0, file)
            if file.endswith(".svg"):
                self.assertTrue(xml.parse(path).getroot().tag.endswith("svg"))
            elif file.endswith(".png"):
                width, rows = pixels_of(path)
                self.assertTrue(any(set(row) != {255} for row in rows), file)
                self.assertEqual(width, 360)

    def test_published_numbers_are_the_papers(self):
        with open(os.path.join(ROOT, "assets", "experiments", "paper.json"), encoding="utf-8") as file:
            paper = json.load(file)
        self.assertEqual(sum(s["seconds"] for s in paper["table1"]["stages"]), 11807)  # the total of Table 1
        published = {r["delta_percent"]: r["paper"] for r in rows_of(self.out, "fig19")}
        self.assertEqual(published["0.8"], "767")
        self.assertIn("| 8 % | 120 |", self.read("README.md"))

    def test_results_agree_with_the_meshes(self):
        with open(os.path.join(self.out, "runs", "results.jsonl"), encoding="utf-8") as file:
            rows = [json.loads(line) for line in file]
        self.assertEqual(len({r["key"] for r in rows}), len(rows))
        meshes = [r for r in rows if r["vertices"]]
        self.assertGreater(len(meshes), 15)
        for row in meshes:
            mesh = read_off(os.path.join(self.out, "runs", row["key"] + ".off"))
            self.assertEqual(len(mesh.points), row["vertices"], row)
        certified = [r for r in rows if r["program"] == "isoscope-run" and r["certified"]]
        self.assertGreater(len(certified), 8)
        for row in certified:
            self.assertFalse(row["intersects_itself"])
            self.assertLessEqual(row["output_distance"], row["delta"] * (1 + 1e-9))

    def test_bounded_methods_keep_their_bound(self):
        rows = [r for r in rows_of(self.out, "fig22") if r["asked"].endswith("%") and r["vertices"]]
        bounded = [r for r in rows if r["method"] in ("Isoscope", "LT, proven within δ", "LT, polyhedral envelope")]
        self.assertEqual(len(bounded), 3)
        for row in bounded:
            # Distances of the peers are bounds, to 0.01 % of the longest edge.
            self.assertLessEqual(float(row["distance_percent"]), float(row["asked"].split()[0]) + 0.011, row)
        counts = [int(r["vertices"]) for r in rows_of(self.out, "fig22") if r["asked"].endswith("vertices")]
        self.assertEqual(counts, [200, 100, 50])

    def test_stages_are_in_order_of_time(self):
        stages = [r for r in rows_of(self.out, "table1") if r["run"].startswith("certified")]
        self.assertEqual([r["stage"] for r in stages],
                         ["refinement", "gamma", "tessellation", "zero-set", "all", "improve"])
        curve = [float(r["cpu_seconds"]) for r in rows_of(self.out, "fig21")]
        self.assertEqual(curve, sorted(curve))
        self.assertGreater(len(curve), 20)

    def test_a_second_call_runs_nothing_and_writes_the_same(self):
        before = self.read("README.md"), self.read("index.html"), self.read("runs/results.jsonl")
        again = experiments("--size", "tiny", "-o", self.out)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual(again.stderr.count("(kept)"), len(before[2].splitlines()))
        self.assertEqual((self.read("README.md"), self.read("index.html"), self.read("runs/results.jsonl")), before)


# What a quick run may take in CPU seconds, so that it ends within ten minutes also where nothing of it runs in parallel.
QUICK_SECONDS = 540


class Quick(unittest.TestCase):
    """The quick size as a whole: it ends complete, not by its time limit."""

    def test_a_quick_run_is_complete_within_its_bound(self):
        with tempfile.TemporaryDirectory() as out:
            # Other programs on the machine take time on the wall; what counts is that of the processors.
            before = os.times()
            done = experiments("--quick", "--time-limit", "7200", "-o", out)
            after = os.times()
            self.assertEqual(done.returncode, 0, done.stderr)
            used = after.children_user + after.children_system - before.children_user - before.children_system
            print(f"a quick run: {used:.0f} CPU seconds", file=sys.stderr)
            self.assertLess(used, QUICK_SECONDS, done.stderr)
            for name in EXPERIMENTS:
                self.assertTrue(rows_of(out, name), name)


class Plan(Laboratory):
    """Notes what would be run, by program, model and arguments, and runs nothing."""

    def __init__(self, size, work):
        for name in NEEDED:
            path = os.path.join(work, name)
            with open(path, "w", encoding="utf-8") as file:
                file.write(name)
            os.chmod(path, 0o700)
        super().__init__(work, None, size, 1, work, 1, 0)
        self.plan = set()

    def _once(self, program, model, arguments, work):
        self.plan.add((program, model.name, *arguments))
        with open(os.devnull, "w", encoding="utf-8") as nowhere, contextlib.redirect_stderr(nowhere):
            return super()._once(program, model, arguments, work)


def planned(size):
    with open(os.path.join(ROOT, "assets", "experiments", "paper.json"), encoding="utf-8") as file:
        paper = json.load(file)
    with tempfile.TemporaryDirectory() as work:
        os.mkdir(os.path.join(work, "runs"))
        lab = Plan(size, work)
        for experiment in EXPERIMENTS.values():
            experiment(lab, paper)
        return lab.plan


class Stopped(unittest.TestCase):
    def test_an_interrupted_run_goes_on_where_it_was(self):
        with tempfile.TemporaryDirectory() as out:
            child = subprocess.Popen([sys.executable, SCRIPT, "--programs", PROGRAMS, "--size", "tiny", "-o", out, "fig14"],
                                     stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
            results = os.path.join(out, "runs", "results.jsonl")
            while child.poll() is None and not (os.path.exists(results) and os.path.getsize(results) > 0):
                time.sleep(0.02)
            child.send_signal(signal.SIGINT)
            said = child.communicate()[1]
            self.assertEqual(child.returncode, 130, said)
            self.assertIn("goes on from here", said)
            with open(results, encoding="utf-8") as file:
                kept = len(file.read().splitlines())
            with open(results, "a", encoding="utf-8") as file:
                file.write('{"key": "torn')
            again = experiments("--size", "tiny", "-o", out, "fig14")
            self.assertEqual(again.returncode, 0, again.stderr)
            self.assertEqual(again.stderr.count("(kept)"), kept)
            self.assertEqual(len(rows_of(out, "fig14")), 5)


class Errors(unittest.TestCase):
    def fails(self, status, words, *arguments, programs=PROGRAMS):
        done = experiments(*arguments, programs=programs)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertIn(words, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def test_usage(self):
        with tempfile.TemporaryDirectory() as out:
            self.fails(2, "there is no experiment 'fig99'", "fig99", "-o", out)
            self.fails(2, "--quick is --size quick, not tiny", "--quick", "--size", "tiny", "-o", out)
            self.fails(2, "is no folder", "--models", os.path.join(out, "nothing"), "-o", out)
            self.fails(2, "--cpu-limit takes seconds", "--cpu-limit", "0", "-o", out)
            self.fails(2, "--time-limit takes seconds", "--time-limit", "-1", "-o", out)
            self.fails(2, "there is no isoscope-run in", "-o", out, programs=out)
            file = os.path.join(out, "file")
            with open(file, "w", encoding="utf-8"):
                pass
            self.fails(2, file, "-o", os.path.join(file, "below"))

    def test_a_model_that_is_missing_is_named(self):
        with tempfile.TemporaryDirectory() as work:
            with self.assertRaises(LabError) as caught:
                Models(None, "whole", work, archives=("/nowhere.tar.gz",)).of_paper("fertility")
            self.assertEqual(caught.exception.status, 3)
            self.assertIn("elephant.off", str(caught.exception))

    def test_what_there_is_no_time_for_is_told_and_left_to_the_next_call(self):
        with tempfile.TemporaryDirectory() as out:
            done = experiments("--size", "tiny", "--time-limit", "0", "-o", out)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("no time left", done.stderr)
            self.assertFalse(os.path.exists(os.path.join(out, "runs", "results.jsonl")))
            with open(os.path.join(out, "README.md"), encoding="utf-8") as file:
                page = file.read()
            for name in EXPERIMENTS:
                self.assertIn(f'<a id="{name}"></a>', page)
            later = experiments("--size", "tiny", "-o", out, "fig20")
            self.assertEqual(later.returncode, 0, later.stderr)

    def test_a_run_that_fails_is_told_and_the_rest_goes_on(self):
        with tempfile.TemporaryDirectory() as out:
            write_off(os.path.join(out, "armadillo.off"), Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], []))
            done = experiments("--size", "tiny", "--models", out, "-o", out, "fig20", "fig25")
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("armadillo.off --tolerance 8%", done.stderr)
            self.assertEqual(rows_of(out, "fig20")[-1]["improved"], "")
            self.assertTrue(rows_of(out, "fig25")[0]["vertices"])


class Parts(unittest.TestCase):
    def test_a_process_that_does_not_end_is_given_up(self):
        done = process.run([sys.executable, "-c", "while True: pass"], 1)
        self.assertEqual(done.signal, signal.SIGXCPU)
        self.assertGreater(done.cpu_seconds, 0.5)  # the system counts in ticks
        self.assertLess(done.cpu_at(done.wall_seconds / 2), done.cpu_at(done.wall_seconds))
        self.assertAlmostEqual(done.cpu_at(done.wall_seconds), done.cpu_seconds)

    def test_a_process_is_killed_at_the_time_limit(self):
        done = process.run([sys.executable, "-c", "import time; time.sleep(600)"], 10, 0.2)
        self.assertFalse(done.in_time)
        self.assertLess(done.wall_seconds, 60)

    def test_a_process_tells_what_it_said(self):
        done = process.run([sys.executable, "-c", "import sys; print('out'); sys.exit('err')"], 10)
        self.assertEqual((done.status, done.signal, done.output, done.errors), (1, 0, "out\n", "err\n"))

    def test_results_survive_a_torn_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "results.jsonl")
            Store(path).add({"key": "a", "vertices": 3})
            with open(path, "a", encoding="utf-8") as file:
                file.write('{"key": "b", "ver')
            store = Store(path)
            self.assertIsNone(store.get("b"))
            store.add({"key": "c", "vertices": 4})
            self.assertEqual([Store(path).get(k)["vertices"] for k in "ac"], [3, 4])

    def test_a_plot_shows_what_a_logarithm_knows(self):
        text = plot("T & t", "x", "y", [Line("one", [(1, 10), (10, 100), (0, 5)], dots=[(10, 100)]),
                                        Line("two", [(2, 20)], dashed=True)], log_x=True, log_y=True)
        root = xml.fromstring(text)
        name = "{http://www.w3.org/2000/svg}"
        line = root.findall(name + "polyline")
        self.assertEqual(len(line), 1)
        (x0, y0), (x1, y1) = [map(float, p.split(",")) for p in line[0].get("points").split()]
        self.assertTrue(x0 < x1 and y0 > y1)
        labels = [t.text for t in root.findall(name + "text")]
        for label in ("T & t", "one", "two", "intersects itself"):
            self.assertIn(label, labels)

    def test_a_picture_shows_the_near_side(self):
        square = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
        near = [(-0.5, -0.5, 1), (0.5, -0.5, 1), (0, 0.5, 1)]
        mesh = Mesh(square + near, [(0, 1, 2), (0, 2, 3), (4, 5, 6)])
        seen = []

        def colour(normal, axes):
            seen.append(normal)
            return (200, 0, 0) if len(seen) == 3 else (0, 200, 0)

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "p.png")
            draw(path, mesh, (0, 0, 1), (0, 1, 0), size=60, edges=False, colour=colour)
            width, rows = pixels_of(path)
        self.assertEqual(width, 60)
        at = lambda x, y: tuple(rows[y][3 * x:3 * x + 3])  # noqa: E731
        self.assertEqual(at(30, 30), (200, 0, 0))
        self.assertEqual(at(6, 30), (0, 200, 0))
        self.assertEqual(at(0, 0), (255, 255, 255))

    def test_shapes_are_closed_and_the_same_each_time(self):
        for mesh in (shapes.torus(), shapes.undulating(12)):
            edges = {}
            for t in mesh.triangles:
                for k in range(3):
                    edge = (t[k], t[(k + 1) % 3])
                    self.assertNotIn(edge, edges)
                    edges[edge] = True
            self.assertTrue(all((b, a) in edges for a, b in edges))
        torus = shapes.torus()
        self.assertEqual(shapes.sampled(torus, 50, 0.01), shapes.sampled(torus, 50, 0.01))
        torn = shapes.soup(torus, 0.01)
        self.assertEqual(len(torn.points), 3 * len(torus.triangles))

    def test_a_page_is_the_same_in_both_forms(self):
        section = Section("fig0", "Figure 0: a < b")
        section.gist = "less"
        section.text("See [fig0](#fig0) & `x < y`.")
        section.table(["a", "b"], [[1, 2]])
        section.pictures([("a.png", "one"), ("b.png", "two")])
        self.assertIn("| 1 | 2 |", markdown("T", ["p"], [section]))
        self.assertIn("![one](a.png) | ![two](b.png)", markdown("T", ["p"], [section]))
        page = as_html("T", ["p"], [section])
        self.assertIn("<code>x &lt; y</code>", page)
        self.assertIn('<a href="#fig0">fig0</a> &amp;', page)
        self.assertEqual(page.count("<figcaption>"), 2)

    def test_curves_keep_their_ends(self):
        points = list(range(1001))
        kept = thinned(points)
        self.assertLess(len(kept), 200)
        self.assertEqual((kept[0], kept[-1]), (0, 1000))
        self.assertEqual(thinned([]), [])

    @unittest.skipUnless(any(os.path.exists(archive) for archive in ARCHIVES), "needs the models of libcgal-demo")
    def test_the_quick_plan_is_small(self):
        quick, short = planned("quick"), planned("short")
        self.assertLess(len(quick), len(short))
        self.assertLessEqual(len(quick), 45)
        asked = [(run, run[run.index("--tolerance") + 1]) for run in quick if "--tolerance" in run]
        deltas = [(run, float(delta.rstrip("%"))) for run, delta in asked if delta != "auto"]
        self.assertGreater(len(deltas), 20)
        for run, delta in deltas:
            self.assertGreaterEqual(delta, 1.5, run)
        # The envelope alone takes two minutes and a half on it.
        self.assertFalse([run for run in quick if run[1] == "armadillo.off" and "envelope" in run])
        self.assertTrue([run for run in quick if "envelope" in run])
        asked = parsed(["--quick"])
        self.assertEqual((asked.size, asked.effort, asked.time_limit), ("quick", 1, 540))

    def test_sizes_grow(self):
        for by_size in DELTAS.values():
            self.assertEqual(set(by_size), set(SIZES))
            smallest = [min(map(float, by_size[size])) for size in SIZES]
            self.assertEqual(smallest, sorted(smallest, reverse=True))


if __name__ == "__main__":
    unittest.main()
