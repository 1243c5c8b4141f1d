"""Figure 21: the vertices of Z over time."""
from lab.experiments import helpers
from lab.experiments.over_delta import runs_over_delta
from lab.page import Section
from lab.plot import Line, plot


def fig21(lab, paper):
    published = paper["fig19"]
    model, rows = runs_over_delta(lab, "fig19", published["model"])
    section = Section("fig21", "Figure 21: the vertices of Z over time")
    section.text(f"The runs of [fig19](#fig19) ({helpers.standing(model, published['model'])}), in CPU seconds since the "
                 "refinement began; each mark is the end of a stage: refinement, ∂Γ, tessellation, Z, all edges, and the "
                 "improver, which the paper does not have. The paper says that refinement is substantially faster than "
                 "simplification, and that collapses of ∂Γ and Z bring the count down fast.")
    lines, table, data, shares = [], [], [], []
    for d, row in rows.items():
        if not row["vertices"]:
            continue
        begin = row["began_at"]
        points = [(cpu - begin, v) for cpu, v in row["curve"]]
        lines.append(Line(f"δ = {d} %", points,
                          marks=[(s["ends_at"] - begin, s["vertices"]) for s in row["stages"] if s["vertices"]]))
        total = sum(s["cpu_seconds"] for s in row["stages"])
        inside = sum(s["cpu_seconds"] for s in row["stages"] if s["name"] != "improve")
        by_name = {s["name"]: s["cpu_seconds"] for s in row["stages"]}
        if inside > 0:
            shares.append(by_name.get("refinement", 0) / inside)
        table.append([d + " %"] + [f"{100 * by_name.get(n, 0) / max(total, 1e-9):.0f} %" for n in
                                   ("refinement", "gamma", "tessellation", "zero-set", "all", "improve")]
                     + [helpers.number(total, 1)])
        data += [[d, cpu, v] for cpu, v in points]
    section.table(["δ", "refinement", "∂Γ", "tessellation", "Z", "all edges", "improver", "CPU s"], table)
    section.csv(["delta_percent", "cpu_seconds", "vertices"], data)
    name = helpers.write(lab, "fig21.svg", plot(f"Vertices of Z over time, {model.name}", "CPU seconds (+ 0.1)",
                                               "vertices of Z",
                                               [Line(line.name, [(x + 0.1, y) for x, y in line.points],
                                                     marks=[(x + 0.1, y) for x, y in line.marks]) for line in lines],
                                               log_x=True, log_y=True))
    section.pictures([(name, "Vertices of Z over CPU time for several δ")])
    section.gist = ("refinement takes " + " to ".join(sorted({f"{100 * s:.0f} %" for s in (min(shares), max(shares))}))
                    + " of the time of the paper's stages" if shares else "nothing")
    return section
