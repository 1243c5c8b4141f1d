"""Table 1 and Figure 14: what each stage makes of Z and how long it takes."""
from lab.experiments import helpers
from lab.experiments.choices import SAMPLED, STAGES
from lab.models import Model
from lab.page import Section

# Our stages beside the rows of Table 1 that make them up.
ROWS = (("refinement", "refinement"), ("gamma", "collapses of ∂Γ"), ("tessellation", "mutual tessellation"),
        ("zero-set", "collapses of Z"), ("all", "all edges"), ("improve", "improver"))


def stage_rows(row):
    """Cells of a run by our stage: vertices, CPU seconds, share of the paper's stages, milliseconds an operation."""
    inside = sum(s["cpu_seconds"] for s in row["stages"] if s["name"] != "improve") or 1e-9
    cells = {}
    for s in row["stages"]:
        share = "–" if s["name"] == "improve" else f"{100 * s['cpu_seconds'] / inside:.0f} %"
        cells[s["name"]] = [helpers.number(s["vertices"]), helpers.number(s["cpu_seconds"], 2), share,
                            helpers.number(1000 * s["cpu_seconds"] / s["operations"], 1) if s["operations"] else "–",
                            f"{s['halfedge']:,} of {s['operations']:,}"]
    return cells


def table1(lab, paper):
    published = paper["table1"]
    section = Section("table1", "Table 1: time of each stage")
    model = lab.models.of_paper(published["model"])
    delta = STAGES[lab.size]
    certified = lab.ours(model, delta + "%")
    name, sampled_delta, sigma = SAMPLED[lab.size]
    sampled = lab.ours(Model(name, name, name, False), sampled_delta + "%", "--containment", "sampled", "--sigma", sigma)
    total = sum(s["seconds"] for s in published["stages"])
    theirs = {}
    for s in published["stages"]:
        held = theirs.setdefault(s["stage"], {"vertices": 0, "seconds": 0, "operations": 0.0})
        held["vertices"] = s["vertices"]
        held["seconds"] += s["seconds"]
        held["operations"] += s["seconds"] / s["per_operation"]
    section.text(f"The paper: {published['model']} at δ = {published['delta_percent']} %, 16 cores, halfedge and general "
                 f"collapses of a stage added up here. Ours, in CPU seconds: certified mode on "
                 f"{helpers.standing(model, published['model'])} at {delta} %; sampled mode, which keeps to the paper, on "
                 f"{name} at {sampled_delta} % with σ = {sigma} δ, as its dense samples take longest. "
                 "Shares are of the paper's own stages, without the improver.")
    head = ["stage", "paper: vertices", "seconds", "share", "ms/operation"]
    rows = [[label] + ([helpers.number(t["vertices"]), helpers.number(t["seconds"]),
                        f"{100 * t['seconds'] / total:.0f} %", helpers.number(1000 * t["seconds"] / t["operations"], 1)]
                       if (t := theirs.get(stage)) else ["–"] * 4) for stage, label in ROWS if stage != "improve"]
    section.table(head, rows)
    data = []
    for label, row in ((f"certified, {model.name} {delta} %", certified), (f"sampled, {name} {sampled_delta} %", sampled)):
        if not row["vertices"]:
            section.text(f"{label}: {helpers.trouble(row)}.")
            continue
        cells = stage_rows(row)
        section.table([label, "vertices", "CPU s", "share", "ms/operation", "halfedge collapses"],
                      [[text, *cells[stage]] for stage, text in ROWS if stage in cells])
        data += [[label, s["name"], s["vertices"], s["cpu_seconds"], s["operations"], s["halfedge"]]
                 for s in row["stages"]]
    section.csv(["run", "stage", "vertices", "cpu_seconds", "operations", "halfedge"], data)
    if certified["vertices"]:
        shares = stage_rows(certified)
        section.gist = (f"refinement {shares['refinement'][2]} of the time of the paper's stages (paper: "
                        f"{100 * theirs['refinement']['seconds'] / total:.0f} %), the last stage {shares['all'][2]} "
                        f"(paper: {100 * theirs['all']['seconds'] / total:.0f} %)")
    else:
        section.gist = helpers.trouble(certified)
    return section


def fig14(lab, paper):
    published = paper["table1"]
    model = lab.models.of_paper(published["model"])
    delta = STAGES[lab.size]
    theirs = {s["stage"]: s["vertices"] for s in published["stages"]}
    section = Section("fig14", "Figure 14: Z after each stage")
    section.text(f"{helpers.standing(model, published['model']).capitalize()} at δ = {delta} %; the paper's at "
                 f"{published['delta_percent']} %. Each picture is what a run with `--until` that stage writes.")
    pictures, table, data = [], [], []
    for stage, label in ROWS:
        if stage == "tessellation":
            continue
        until = [] if stage == "improve" else ["--until", stage]
        row = lab.ours(model, delta + "%", *until)
        # Before the tessellation Z has triangles and quadrilaterals; the mesh that is written has triangles alone.
        at_end = helpers.vertices_at(row, stage) if row["vertices"] else None
        table.append([label, helpers.number(theirs.get(stage)), helpers.number(at_end)])
        data.append([stage, theirs.get(stage), at_end])
        if row["vertices"]:
            pictures.append((helpers.picture(lab, f"fig14-{stage}.png", row["mesh"], model.name),
                             f"{label}: {at_end:,} vertices"))
    section.table(["stage", "paper", "ours"], table)
    section.csv(["stage", "paper", "ours"], data)
    if pictures:
        section.pictures(pictures)
    section.gist = " → ".join(row[2] for row in table) + " vertices; paper " + \
        " → ".join(row[1] for row in table if row[1] != "–")
    return section
