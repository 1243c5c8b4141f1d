"""Figures 26 and 27: how far normals deviate, by the factor of condition 3 and in a picture."""
from lab.experiments import helpers
from lab.experiments.choices import LUCY, NORMALS
from lab.page import Section
from lab.picture import by_normal
from lab.plot import Line, plot

FACTORS = (("off", ["--no-condition", "3"]), ("0.3", ["--shrink", "0.3"]), ("0.7", ["--shrink", "0.7"]),
           ("1", ["--shrink", "1"]))


def fig26(lab, paper):
    published = paper["fig26"]
    model = lab.models.of_paper(published["model"])
    delta = NORMALS[lab.size]
    section = Section("fig26", "Figure 26: deviation of normals by the factor of condition 3")
    section.text(f"On {helpers.standing(model, published['model'])} at δ = {delta} % (the paper: {published['delta_percent']} %), "
                 "up to the paper's last stage (`--until all`). The shrunk copy of a tetrahedron is off, or 30, 70, 100 % "
                 "of its size. Shares are of the area; the paper says that without the condition deviations may exceed 90°.")
    lines, table, data, beyond, counts = [], [], [], [], []
    for factor, asked in FACTORS:
        row = lab.ours(model, delta + "%", "--until", "all", *asked)
        theirs = published["vertices"][factor]
        label = "off" if factor == "off" else f"{100 * float(factor):.0f} %"
        if not row["vertices"]:
            table.append([label, helpers.number(theirs), helpers.trouble(row), "–", "–", "–"])
            continue
        n = row["normals"]
        width = n["bin_degrees"]
        points = [((i + 0.5) * width, share) for i, share in enumerate(n["histogram"]) if share > 0]
        lines.append(Line(label, points))
        data += [[label, x, share] for x, share in points]
        table.append([label, helpers.number(theirs), helpers.number(row["vertices"]), f"{n['mean']:.1f}°",
                      f"{n['percentile_99']:.1f}°", f"{100 * n['above_90']:.3f} %"])
        beyond.append(f"{100 * n['above_90']:.2g} %")
        counts.append(f"{row['vertices']:,}")
    section.table(["shrunk copy", "paper: vertices", "vertices", "mean", "99 % below", "beyond 90°"], table)
    section.csv(["shrink", "degrees", "share_of_area"], data)
    if lines:
        name = helpers.write(lab, "fig26.svg", plot(f"Normals of the output, {model.name}", "deviation, degrees",
                                                   "share of the area", lines, log_y=True))
        section.pictures([(name, "Distribution of the deviation of normals for four factors")])
    section.gist = (f"{', '.join(counts)} vertices with condition 3 off, at 30, 70, 100 %; paper "
                    + ", ".join(f"{v:,}" for v in published["vertices"].values())
                    + f"; beyond 90°: {', '.join(beyond)} of the area")
    return section


def fig27(lab, paper):
    published = paper["fig27"]
    model = lab.models.of_paper(published["model"])
    delta = LUCY[lab.size]
    row = lab.ours(model, delta + "%")
    section = Section("fig27", "Figure 27: normals of input and output")
    section.text(f"{helpers.standing(model, published['model']).capitalize()} at δ = {delta} %; the paper's Lucy has "
                 f"{published['vertices']:,} vertices at {published['delta_percent']} %. Colours are directions: red to the "
                 "right, green up, blue towards the eye.")
    section.csv(["model", "delta_percent", "vertices", "mean_degrees", "percentile_99_degrees"],
                [[model.name, delta, row["vertices"], row["normals"]["mean"] if row["vertices"] else None,
                  row["normals"]["percentile_99"] if row["vertices"] else None]])
    if not row["vertices"]:
        section.gist = helpers.trouble(row)
        section.text(section.gist + ".")
        return section
    pictures = []
    if model.is_file() and model.path.endswith(".off"):
        pictures.append((helpers.picture(lab, "fig27-input.png", model.path, model.name, edges=False, colour=by_normal),
                         "input"))
    pictures.append((helpers.picture(lab, "fig27-output.png", row["mesh"], model.name, edges=False, colour=by_normal),
                     f"output, {row['vertices']:,} vertices"))
    section.pictures(pictures)
    section.gist = (f"normals deviate by {row['normals']['mean']:.1f}° on average, by at most "
                    f"{row['normals']['percentile_99']:.1f}° on 99 % of the area, at {row['vertices']:,} vertices")
    return section
