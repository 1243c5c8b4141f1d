"""Figure 28: point sets and torn soups, clean and noisy."""
from lab.experiments import helpers
from lab.experiments.choices import ROBUSTNESS
from lab.mesh import read_off, write_off, write_points
from lab.page import Section
from lab.shapes import sampled, soup

# Noise in percent of the longest edge, which the paper does not tell.
NOISE = {"points": 0.0, "soup": 0.2, "noisy points": 0.5, "noisy soup": 1.0}


def made_input(lab, base, kind, count):
    """A sample or a soup of the model, as a file."""
    mesh = read_off(base.path)
    noise = NOISE[kind] / 100 * mesh.longest_edge()
    name = f"{base.name.split('.')[0]}-{kind.replace(' ', '-')}"
    if kind.endswith("points"):
        return lab.models.made(f"{name}-{count}", lambda path: write_points(path, sampled(mesh, count, noise)), ".xyz")
    return lab.models.made(name, lambda path: write_off(path, soup(mesh, noise)))


def fig28(lab, paper):
    published = paper["fig28"]
    base = lab.models.of_paper(published["model"])
    count, deltas = ROBUSTNESS[lab.size]
    section = Section("fig28", "Figure 28: noise and kinds of input")
    section.text(f"Points and soups of {base.name}: {count:,} points drawn by area; each triangle for itself with its corners "
                 "moved. Noise is in percent of the longest edge, a deviation of points, a bound for soups; the paper does "
                 "not tell its own. Points are averaged with their neighbours (witnessed k-distance), soups go by the plain "
                 "distance. Beside them CGAL's alpha wrap of the soups, which is closed too but does not simplify.")
    table, data, pictures, told = [], [], [], []
    for kind, theirs in published["cases"].items():
        if kind not in deltas:
            table.append([kind, f"{NOISE[kind]:g} %", f"{theirs['delta_percent']:g} %", helpers.number(theirs["vertices"]),
                          "not run at this size", "–", "–", "–"])
            continue
        model = made_input(lab, base, kind, count)
        row = lab.ours(model, deltas[kind] + "%")
        wrap = None if kind.endswith("points") else lab.peer("alpha-wrap", model, "--tolerance", deltas[kind] + "%")
        table.append([kind, f"{NOISE[kind]:g} %", f"{theirs['delta_percent']:g} %", helpers.number(theirs["vertices"]),
                      deltas[kind] + " %", helpers.number(row["vertices"]), helpers.trouble(row),
                      helpers.number(wrap["vertices"]) if wrap else "–"])
        data.append([kind, NOISE[kind], deltas[kind], row["vertices"], row.get("certified"),
                     wrap["vertices"] if wrap else None])
        if row["vertices"]:
            pictures.append((helpers.picture(lab, f"fig28-{kind.replace(' ', '-')}.png", row["mesh"], base.name),
                             f"{kind}, δ = {deltas[kind]} %: {row['vertices']:,} vertices"))
            told.append(f"{kind} {row['vertices']:,} at {deltas[kind]} % (paper {theirs['vertices']:,} at "
                        f"{theirs['delta_percent']:g} %)")
    section.table(["input", "noise", "paper: δ", "paper: vertices", "δ", "vertices", "certified", "alpha wrap: vertices"], table)
    section.csv(["input", "noise_percent", "delta_percent", "vertices", "certified", "alpha_wrap_vertices"], data)
    if pictures:
        section.pictures(pictures)
    section.gist = "; ".join(told) or "nothing"
    return section
