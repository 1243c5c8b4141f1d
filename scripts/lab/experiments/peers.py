"""Figures 22, 23 and 24: both one-sided Hausdorff distances against the number of vertices, ours and the peers'."""
from lab.experiments import helpers
from lab.experiments.choices import COUNTS, COUNTS_ELSE, DELTAS, LEFT_OUT
from lab.page import Section
from lab.plot import Line, plot

BOUNDED = (("certificate", "LT, proven within δ"), ("envelope", "LT, polyhedral envelope"),
           ("meshoptimizer", "meshoptimizer"))


def gathered(lab, figure, model_name):
    """The model, and for each method its name and its rows from fine to coarse, by what each was asked."""
    model = lab.models.of_paper(model_name)
    deltas = DELTAS[figure][lab.size]
    methods = [("Isoscope", [(d + " %", lab.ours(model, d + "%")) for d in deltas])]
    counts = COUNTS.get(lab.size, COUNTS_ELSE)
    methods.append(("LT, no bound", [(f"{n} vertices", lab.peer("lindstrom-turk", model, "--vertices", str(n)))
                                     for n in counts]))
    for method, label in BOUNDED:
        if method in left_out(lab, figure):
            continue
        methods.append((label, [(d + " %", lab.peer(method, model, "--tolerance", d + "%")) for d in deltas]))
    return model, methods


def left_out(lab, figure):
    """The peers that are not run on this figure's model at this size."""
    return LEFT_OUT.get(lab.size, {}).get(figure, ())


def compare(lab, figure, section, model, methods, key, direction):
    """Table, plot and CSV of one direction of the distance; what ours has beside the others goes into the gist."""
    lines, table, data = [], [], []
    for label, rows in methods:
        points, dots = [], []
        for asked, row in rows:
            distance = helpers.percent_of_edge(row, key)
            crosses = row.get("intersects_itself")
            table.append([label, asked, helpers.number(row["vertices"]), helpers.number(distance, 3),
                          "–" if crosses is None else "yes" if crosses else "no", helpers.number(row["cpu_seconds"], 1)
                          if row["vertices"] else helpers.trouble(row)])
            data.append([label, asked, row["vertices"], distance, crosses, row["cpu_seconds"]])
            if distance is not None:
                points.append((row["vertices"], distance))
                if crosses:
                    dots.append(points[-1])
        lines.append(Line(label, sorted(points), dots=dots))
    name = helpers.write(lab, figure + ".svg", plot(f"{direction}, {model.name}", "vertices",
                                                   "distance, % of the longest edge", lines, log_x=True, log_y=True))
    section.pictures([(name, f"{direction} against vertices for Isoscope and its peers")])
    section.table(["method", "asked for", "vertices", "distance, %", "intersects itself", "CPU s"], table)
    section.csv(["method", "asked", "vertices", "distance_percent", "intersects_itself", "cpu_seconds"], data)
    section.gist = ratios(methods)


def ratios(methods):
    """Our vertices over those of each peer that was asked the same δ."""
    ours = {asked: row["vertices"] for asked, row in methods[0][1] if row["vertices"]}
    told = []
    for label, rows in methods[1:]:
        common = [(ours[asked], row["vertices"]) for asked, row in rows if asked in ours and row["vertices"]]
        if common:
            told.append(f"{sum(a for a, _ in common) / sum(b for _, b in common):.2f} of the vertices of {label}")
    crossing = [f"{label} in {n} of {len(rows)} runs" for label, rows in methods
                if (n := sum(bool(row.get("intersects_itself")) for _, row in rows))]
    return "; ".join(told) + (". Outputs that intersect themselves: " + ", ".join(crossing) if crossing else
                              ". No output intersects itself")


ABOUT = ("LT is CGAL's Lindstrom–Turk collapse: without a bound, down to the number of vertices that was asked for; with "
         "each new triangle proven within δ by our exact filter; within CGAL's polyhedral envelope of half-width δ. "
         "meshoptimizer aims at an error of δ by its own estimate. Distances are upper bounds, proven to 0.01 % of the "
         "longest edge or better. The paper compares with simplification envelopes, Lindstrom–Turk, MMGS and OpenFlipper "
         "in plots without numbers.")


def fig22(lab, paper):
    name = paper["fig19"]["model"]
    model, methods = gathered(lab, "fig19", name)
    section = Section("fig22", "Figure 22: distance from output to input")
    section.text(f"On {helpers.standing(model, name)}. {ABOUT}")
    compare(lab, "fig22", section, model, methods, "output_distance", "Output to input")
    return section


def fig23(lab, paper):
    name = paper["fig19"]["model"]
    model, methods = gathered(lab, "fig19", name)
    section = Section("fig23", "Figure 23: distance from input to output")
    section.text("The same results as in [fig22](#fig22), measured the other way round. The paper's bound is one-sided; "
                 "ours keeps the input within 3 δ of the output (`--cover`).")
    compare(lab, "fig23", section, model, methods, "input_distance", "Input to output")
    return section


def fig24(lab, paper):
    name = paper["fig20"]["model"]
    model, methods = gathered(lab, "fig20", name)
    section = Section("fig24", "Figure 24: Armadillo beside the peers")
    section.text(f"On {helpers.standing(model, name)}, as in [fig22](#fig22). The paper has on average 10 % fewer vertices "
                 "than simplification envelopes there, which nobody distributes any more.")
    for method, label in BOUNDED:
        if method in left_out(lab, "fig20"):
            section.text(f"{label} is not run at this size.")
    compare(lab, "fig24", section, model, methods, "output_distance", "Output to input")
    return section
