"""Figure 28: point sets and torn soups, clean and noisy."""
from lab.experiments import helpers
from lab.experiments.choices import ROBUSTNESS
from lab.mesh import read_off, write_off, write_points
from lab.page import Section
from lab.shapes import sampled, soup

# Noise in percent of the longest edge, which the paper does not tell.
NOISE = {"points": 0.0, "soup": 0.2, "noisy points": 0.5, "noisy soup": 1.0}
# The paper takes the robust distance for soups too; of points it is the usual one.
NEIGHBORS = 12
HEADER = ["input", "noise", "paper: δ", "paper: vertices", "Ω encloses for δ", "k", "δ", "regions", "χ", "vertices", "CPU s",
          "certified", "alpha wrap: vertices"]
COLUMNS = ["input", "noise_percent", "least_percent", "most_percent", "neighbors", "delta_percent", "regions",
           "euler_characteristic", "vertices", "cpu_seconds", "certified", "alpha_wrap_vertices"]


def made_input(lab, base, kind, count):
    """A sample or a soup of the model, as a file."""
    mesh = read_off(base.path)
    noise = NOISE[kind] / 100 * mesh.longest_edge()
    name = f"{base.name.split('.')[0]}-{kind.replace(' ', '-')}"
    if kind.endswith("points"):
        return lab.models.made(f"{name}-{count}", lambda path: write_points(path, sampled(mesh, count, noise)), ".xyz")
    return lab.models.made(name, lambda path: write_off(path, soup(mesh, noise)))


def tolerances(lab, model, kind, published):
    """Runs at the tolerance that is found, and at the paper's where Ω encloses something then: with each the paper's
    or none."""
    options = [] if kind.endswith("points") else ["--robust", str(NEIGHBORS)]
    row = lab.ours(model, "auto", *options)
    yield row
    theirs = published["delta_percent"]
    if row["vertices"] and row["study"] and row["study"]["least"] <= theirs / 100 * row["longest_edge"] <= row["study"]["most"]:
        yield lab.ours(model, f"{theirs}%", *options)


def fig28(lab, paper):
    published = paper["fig28"]
    base = lab.models.of_paper(published["model"])
    count, kinds = ROBUSTNESS[lab.size]
    section = Section("fig28", "Figure 28: noise and kinds of input")
    section.text(f"Points and soups of {base.name}: {count:,} points drawn by area; each triangle for itself with its corners "
                 "moved. Noise is in percent of the longest edge, a deviation of points, a bound for soups; the paper does "
                 "not tell its own. As in the paper all go by a robust distance, the witnessed k-distance, soups by samples of "
                 f"their area (`--robust {NEIGHBORS}`). δ is found (`--tolerance auto`), from where Ω first encloses what is "
                 "meant up to where it closes it up; where the paper's lies between, there is a run with it too. Ω has as many "
                 "regions as are told here. Beside them CGAL's alpha wrap of the soups, which is closed too but does not "
                 "simplify.")
    table, data, pictures, told = [], [], [], []
    for kind, theirs in published["cases"].items():
        known = [kind, f"{NOISE[kind]:g} %", f"{theirs['delta_percent']:g} %", helpers.number(theirs["vertices"])]
        if kind not in kinds:
            table.append([*known, "not run at this size", *["–"] * 8])
            continue
        model = made_input(lab, base, kind, count)
        for i, row in enumerate(tolerances(lab, model, kind, theirs)):
            if not row["vertices"]:
                table.append([*known, helpers.trouble(row), *["–"] * 8])
                continue
            delta, study = helpers.percent_of_edge(row, "delta"), row["study"]
            ends = [100 * study[end] / row["longest_edge"] for end in ("least", "most")] if study else [None, None]
            wrap = None if kind.endswith("points") else lab.peer("alpha-wrap", model, "--tolerance", f"{delta:.4g}%")
            wrapped = wrap["vertices"] if wrap else None
            table.append([*known, f"{ends[0]:.2g} to {ends[1]:.2g} %" if study else "–", helpers.number(row["neighbors"]),
                          f"{delta:.2g} %", helpers.number(row["regions"]), helpers.number(row["euler_characteristic"]),
                          helpers.number(row["vertices"]), f"{row['cpu_seconds']:.1f}", helpers.trouble(row),
                          helpers.number(wrapped)])
            data.append([kind, NOISE[kind], *ends, row["neighbors"], delta, row["regions"], row["euler_characteristic"],
                         row["vertices"], row["cpu_seconds"], row["certified"], wrapped])
            if i > 0:
                continue
            pictures.append((helpers.picture(lab, f"fig28-{kind.replace(' ', '-')}.png", row["mesh"], base.name),
                             f"{kind}, δ = {delta:.2g} %: {row['vertices']:,} vertices"))
            told.append(f"{kind} {row['vertices']:,} at {delta:.2g} % (paper {theirs['vertices']:,} at "
                        f"{theirs['delta_percent']:g} %)")
    section.table(HEADER, table)
    section.csv(COLUMNS, data)
    if pictures:
        section.pictures(pictures)
    section.gist = "; ".join(told) or "nothing"
    return section
