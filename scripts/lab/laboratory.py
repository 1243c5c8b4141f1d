"""What experiments are given: models, runs of ours and of the peers with their results kept, and a place for files."""
import hashlib
import json
import os
import sqlite3
import sys
import time

from lab import process
from lab.models import Models
from lab.programs import Programs
from lab.store import Store

CURVE_POINTS = 160
# Of a run that was not begun or not ended before the time limit; it is not kept, so that the next call makes it.
NO_TIME = {"exit": None, "signal": 0, "cpu_seconds": 0.0, "wall_seconds": 0.0, "peak_mb": 0.0, "load": 0.0,
           "message": "no time left", "vertices": None}


class Laboratory:
    """Runs programs at most once: what the store has is taken from there."""

    def __init__(self, programs, models_folder, size, effort, output, cpu_limit, time_limit):
        self.size, self.effort, self.output = size, effort, output
        self._work = os.path.join(output, "runs")
        self.models = Models(models_folder, size, os.path.join(self._work, "models"))
        self._programs = Programs(programs)
        self._store = Store(os.path.join(self._work, "results.jsonl"))
        self._cpu_limit = cpu_limit
        self._deadline = time.monotonic() + time_limit
        self.failures = []
        self.cpu_seconds = 0.0
        self.runs = 0
        self._seen = set()

    def ours(self, model, tolerance, *options):
        """A run of isoscope-run: its row, with the mesh in row["mesh"] where there is one."""
        arguments = ["--tolerance", tolerance, "--effort", str(self.effort), *options]
        return self._once("isoscope-run", model, arguments, self._run_ours)

    def peer(self, method, model, *options):
        """A run of isoscope-peer."""
        return self._once("isoscope-peer", model, [method, *options], self._run_peer)

    def _once(self, program, model, arguments, work):
        key = hashlib.sha256(json.dumps([program, self._programs.digest(program), model.digest, arguments])
                             .encode()).hexdigest()[:12]
        mesh = os.path.join(self._work, key + ".off")
        row = self._store.get(key)
        kept = row is not None and (not row["vertices"] or os.path.exists(mesh))
        if not kept:
            row = {"key": key, "program": program, "model": model.name, "arguments": arguments}
            done = work(model, arguments, mesh) if time.monotonic() < self._deadline else None
            row.update(done or NO_TIME)
            if done is not None:
                self._store.add(row)
        if key not in self._seen:
            self._seen.add(key)
            self.runs += 1
            self.cpu_seconds += row["cpu_seconds"]
            told = f"{program} {model.name} {' '.join(arguments)}: {outcome(row)}"
            print(told + (" (kept)" if kept else ""), file=sys.stderr, flush=True)
            if row["vertices"] is None and not declined(program, row):
                self.failures.append(told)
        return dict(row, mesh=mesh if row["vertices"] else None)

    def _measured(self, command):
        load = os.getloadavg()[0]
        done = process.run(command, self._cpu_limit, self._deadline - time.monotonic())
        lines = done.errors.strip().splitlines()
        row = {"exit": done.status, "signal": done.signal, "cpu_seconds": round(done.cpu_seconds, 2),
               "wall_seconds": round(done.wall_seconds, 2), "peak_mb": round(done.peak_mb, 1), "load": load,
               "message": lines[-1] if lines else "", "vertices": None}
        return done, row

    def _run_ours(self, model, arguments, mesh):
        stem = mesh[:-len(".off")]
        report, recording = stem + ".json", stem + ".isorun"
        remove(report, recording, mesh)
        done, row = self._measured([self._programs.path("isoscope-run"), model.path, *arguments, "--quiet",
                                    "--report", report, "--record", recording, "-o", mesh])
        if done.signal == 0 and done.status in (0, 1, 4) and os.path.exists(report):
            with open(report, encoding="utf-8") as file:
                told = json.load(file)
            row.update(facts_of_report(told), **facts_of_recording(recording, done.cpu_at))
        remove(report, recording, recording + "-wal", recording + "-shm")
        return row if done.in_time else None

    def _run_peer(self, model, arguments, mesh):
        remove(mesh)
        done, row = self._measured([self._programs.path("isoscope-peer"), arguments[0], model.path, *arguments[1:],
                                    "-o", mesh])
        if done.signal == 0 and done.status == 0:
            told = json.loads(done.output)
            row.update(told)
        return row if done.in_time else None


def remove(*paths):
    for path in paths:
        if os.path.exists(path):
            os.remove(path)


def declined(program, row):
    """Whether a peer said that it cannot take this input or was not built in, which is a result too."""
    return program == "isoscope-peer" and row["exit"] == 3


def outcome(row):
    """How a run ended, in a few words."""
    if row["signal"] in (9, 24):
        return f"given up after {row['cpu_seconds']:.0f} CPU s"
    if row["signal"]:
        return f"crashed by signal {row['signal']}"
    if row["vertices"] is None:
        return row["message"] or f"exit status {row['exit']}"
    return f"{row['vertices']:,} vertices, {row['cpu_seconds']:.1f} CPU s"


def facts_of_report(told):
    """What plots and tables take of a report."""
    bounds, points = told["certificate"]["input_distance"], told.get("points")
    return {
        "vertices": told["output"]["vertices"],
        "euler_characteristic": told["output"]["euler_characteristic"],
        "regions": told["samples"]["regions"],
        "neighbors": points["neighbors"] if points else None,
        "study": told.get("tolerances"),
        "delta": told["parameters"]["tolerance"],
        "longest_edge": told["input"]["longest_edge"],
        "certified": told["certificate"]["holds"],
        "failures": told["certificate"]["failures"],
        "thickening": not any("no thickening" in w for w in told["warnings"]),
        "intersects_itself": not told["certificate"]["intersection_free"],
        "output_distance": told["certificate"]["max_distance"],
        "input_distance": bounds["upper"] if bounds else None,
        "normals": told["normals"],
        "samples": told["samples"]["count"],
        "end": told["end"],
    }


def facts_of_recording(path, cpu_at):
    """Stages and the vertices of Z over CPU time, from what the recording says of each operation."""
    with sqlite3.connect(path) as db:
        names = dict(db.execute("SELECT id, name FROM stages"))
        marks = list(db.execute("SELECT m.event, m.seconds, e.stage, k.name FROM stage_marks m "
                                "JOIN event_rows e ON e.id = m.event JOIN kinds k ON k.id = e.kind ORDER BY m.id"))
        operations = list(db.execute("SELECT o.event, o.seconds, o.zero_set_vertices, e.stage, r.name FROM operations o "
                                     "JOIN event_rows e ON e.id = o.event JOIN reasons r ON r.id = e.reason "
                                     "ORDER BY o.step"))
    begins, stages = {}, []
    for event, seconds, stage, kind in marks:
        name = names[stage]
        if kind == "stage-begin":
            if not stages or stages[-1]["name"] != name:
                stages.append({"name": name, "from": seconds, "to": seconds, "operations": 0, "halfedge": 0,
                               "vertices": None})
            begins[event] = seconds
        elif stages and stages[-1]["name"] == name:
            stages[-1]["to"] = seconds
    by_name = {s["name"]: s for s in stages}
    starts = sorted(begins)
    curve, at = [], 0
    for event, since, vertices, stage, reason in operations:
        while at + 1 < len(starts) and starts[at + 1] <= event:
            at += 1
        s = by_name.get(names[stage])
        if s is None:
            continue
        s["operations"] += 1
        s["halfedge"] += reason == "halfedge"
        s["vertices"] = vertices
        when = begins[starts[at]] + since
        s["to"] = max(s["to"], when)
        curve.append((when, vertices))
    told = []
    for s in stages:
        cpu = cpu_at(s["to"]) - cpu_at(s["from"])
        told.append({"name": s["name"], "cpu_seconds": round(cpu, 3), "ends_at": round(cpu_at(s["to"]), 3),
                     "operations": s["operations"], "halfedge": s["halfedge"], "vertices": s["vertices"]})
    return {"stages": told, "curve": [[round(cpu_at(w), 3), v] for w, v in thinned(curve)],
            "began_at": round(cpu_at(stages[0]["from"]), 3) if stages else 0}


def thinned(points):
    """At most CURVE_POINTS of them, the first and the last among them."""
    step = max(1, -(-len(points) // CURVE_POINTS))
    kept = points[::step]
    return kept if not points or kept[-1] == points[-1] else kept + [points[-1]]
