"""Figure 25: an undulating surface at a δ larger than its waves."""
from lab.experiments import helpers
from lab.experiments.choices import UNDULATING
from lab.mesh import write_off
from lab.page import Section
from lab.plot import Line, plot
from lab.shapes import undulating


def fig25(lab, paper):
    rings, delta = UNDULATING[lab.size]
    model = lab.models.made("undulating", lambda path: write_off(path, undulating(rings)))
    published = paper["fig25"]["percent"]
    rows = [("Isoscope", lab.ours(model, delta + "%")),
            ("LT, proven within δ", lab.peer("certificate", model, "--tolerance", delta + "%")),
            ("LT, polyhedral envelope", lab.peer("envelope", model, "--tolerance", delta + "%")),
            ("meshoptimizer", lab.peer("meshoptimizer", model, "--tolerance", delta + "%"))]
    section = Section("fig25", "Figure 25: an undulating surface")
    section.text(f"A ball with waves, made by the laboratory, at δ = {delta} %: the waves lie inside Ω, so that next to "
                 "nothing of them need be kept. In the paper simplification envelopes, which move along normals, end at a "
                 f"distance of {published['simplification envelopes']} % with more than ours has at {published['ours']} %.")
    section.table(["method", "vertices", "distance to the input, %", "intersects itself"],
                  [[label, helpers.number(r["vertices"]), helpers.number(helpers.percent_of_edge(r, "output_distance"), 2),
                    "yes" if r.get("intersects_itself") else "no"] if r["vertices"] else [label, helpers.trouble(r), "–", "–"]
                   for label, r in rows])
    section.csv(["method", "vertices", "distance_percent", "intersects_itself"],
                [[label, r["vertices"], helpers.percent_of_edge(r, "output_distance"), r.get("intersects_itself")]
                 for label, r in rows])
    lines = [Line(label, [(r["vertices"], helpers.percent_of_edge(r, "output_distance"))],
                  dots=[(r["vertices"], helpers.percent_of_edge(r, "output_distance"))] if r["intersects_itself"] else [])
             for label, r in rows if r["vertices"]]
    if lines:
        name = helpers.write(lab, "fig25.svg", plot("An undulating surface", "vertices", "distance, % of the longest edge",
                                                   lines, log_x=True))
        section.pictures([(name, "Distance against vertices on an undulating surface")])
    section.pictures([(helpers.picture(lab, "fig25-input.png", model.path, model.name, edges=False), "input")] +
                     [(helpers.picture(lab, f"fig25-{i}.png", r["mesh"], model.name), f"{label}: {r['vertices']:,} vertices")
                      for i, (label, r) in enumerate(rows) if r["vertices"]])
    section.gist = "; ".join(f"{label} {helpers.number(r['vertices'])}" for label, r in rows) + " vertices"
    return section
