"""Figure 29: speed-up over the number of threads."""
import os

from lab.experiments import helpers
from lab.experiments.choices import THREADS
from lab.page import Section
from lab.plot import Line, plot


def thread_counts():
    """1, 2, 4 and so on up to the cores that there are."""
    cores, counts = len(os.sched_getaffinity(0)), [1]
    while counts[-1] * 2 <= cores:
        counts.append(counts[-1] * 2)
    return counts if counts[-1] == cores else counts + [cores]


def fig29(lab, paper):
    published = paper["fig29"]
    model = lab.models.of_paper(published["model"])
    delta = THREADS[lab.size]
    counts = thread_counts()
    rows = [(n, lab.ours(model, delta + "%", "--threads", str(n))) for n in counts]
    section = Section("fig29", "Figure 29: speed-up over threads")
    section.text(f"On {helpers.standing(model, published['model'])} at δ = {delta} %; the paper has {published['delta_percent']} % "
                 f"on {published['cores']} cores, where its time is inversely proportional to their number. Speed-up is of the "
                 "time on the wall. The load is that of the machine when a run began: where it is not near 0, other programs "
                 "took part of the cores and the figure says little. The busy cores are CPU seconds over seconds on the wall.")
    done = [(n, r) for n, r in rows if r["vertices"]]
    first = done[0][1]["wall_seconds"] if done else 0
    table = [[str(n), helpers.number(r["wall_seconds"], 1), helpers.number(r["cpu_seconds"], 1),
              f"{first / r['wall_seconds']:.2f}", f"{r['cpu_seconds'] / r['wall_seconds']:.2f}", f"{r['load']:.1f}",
              helpers.number(r["vertices"])] for n, r in done]
    section.table(["threads", "seconds", "CPU s", "speed-up", "busy cores", "load before", "vertices"], table)
    section.csv(["threads", "seconds", "cpu_seconds", "load", "vertices"],
                [[n, r["wall_seconds"], r["cpu_seconds"], r["load"], r["vertices"]] for n, r in done])
    if len(done) > 1:
        name = helpers.write(lab, "fig29.svg", plot(f"Speed-up over threads, {model.name}", "threads", "speed-up", [
            Line("ours", [(n, first / r["wall_seconds"]) for n, r in done]),
            Line("proportional, as in the paper", [(n, n) for n, _ in done], dashed=True)]))
        section.pictures([(name, "Speed-up over threads")])
    same = len({r["vertices"] for _, r in done}) == 1
    section.gist = (f"{first / done[-1][1]['wall_seconds']:.2f} times as fast on {done[-1][0]} threads, load "
                    f"{max(r['load'] for _, r in done):.1f}; the results are {'the same' if same else 'not the same'}"
                    if done else "nothing")
    return section
