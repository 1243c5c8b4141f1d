"""Figures 18, 19 and 20: how many vertices are left at each δ, with pictures."""
from lab.experiments import helpers
from lab.experiments.choices import DELTAS
from lab.page import Section
from lab.plot import Line, plot


def runs_over_delta(lab, figure, model_name):
    """The model and a row for each δ in percent; other experiments take the same runs from here."""
    model = lab.models.of_paper(model_name)
    return model, {d: lab.ours(model, d + "%") for d in DELTAS[figure][lab.size]}


def over_delta(lab, paper, figure, title):
    published = paper[figure]
    model, rows = runs_over_delta(lab, figure, published["model"])
    section = Section(figure, title)
    section.text(f"{published['where']} shows {published['model']}; here it is {helpers.standing(model, published['model'])}. "
                 "“All edges” is where the paper's algorithm ends, “improved” has the improver's stage too. "
                 f"One of the runs: {helpers.command(next(iter(rows.values())))}.")
    theirs = published["vertices"]
    table, data = [], []
    for d in sorted({*theirs, *rows}, key=float):
        row = rows.get(d)
        inside = helpers.vertices_at(row, "all") if row else None
        final = row["vertices"] if row else None
        table.append([d + " %", helpers.number(theirs.get(d)), helpers.number(inside), helpers.number(final),
                      helpers.trouble(row) if row else "not run at this size",
                      helpers.number(row["cpu_seconds"], 1) if row else "–"])
        data.append([d, theirs.get(d), inside, final, row["cpu_seconds"] if row else None])
    section.table(["δ", "paper", "ours, all edges", "ours, improved", "certified", "CPU s"], table)
    section.csv(["delta_percent", "paper", "all_edges", "improved", "cpu_seconds"], data)
    done = [(float(d), r) for d, r in sorted(rows.items(), key=lambda item: float(item[0])) if r["vertices"]]
    paper_points = [(float(d), n) for d, n in theirs.items()]
    lines = [Line("paper, its own model", paper_points),
             Line("paper, if its δ is a width", [(d / 2, n) for d, n in paper_points], dashed=True),
             Line("ours, all edges", [(d, v) for d, r in done if (v := helpers.vertices_at(r, "all"))]),
             Line("ours, improved", [(d, r["vertices"]) for d, r in done])]
    name = helpers.write(lab, figure + ".svg", plot(f"Vertices over δ, {model.name}", "δ, % of the longest edge",
                                                   "vertices", lines, log_x=True, log_y=True))
    section.pictures([(name, f"Vertices over δ, the paper's and ours")])
    if done:
        section.pictures([(helpers.picture(lab, f"{figure}-{d:g}.png", r["mesh"], model.name),
                           f"δ = {d:g} %, {r['vertices']:,} vertices") for d, r in done])
    common = [(d, r["vertices"], theirs[f"{d:g}"]) for d, r in done if f"{d:g}" in theirs]
    ends = [f"{ours:,} vertices at {d:g} % where the paper has {his:,}" for d, ours, his in common]
    section.gist = "; ".join(ends) or "; ".join(f"{r['vertices']:,} vertices at {d:g} %" for d, r in done) or "nothing"
    section.gist += f" ({helpers.standing(model, published['model'])})"
    return section


def fig18(lab, paper):
    return over_delta(lab, paper, "fig18", "Figure 18: a mechanical part over δ")


def fig19(lab, paper):
    return over_delta(lab, paper, "fig19", "Figure 19: a smooth model over δ")


def fig20(lab, paper):
    return over_delta(lab, paper, "fig20", "Figure 20: Armadillo")
