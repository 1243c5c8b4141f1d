"""What several experiments share: numbers as text, pictures of results, and the files they go to."""
import os

from lab.experiments.choices import views
from lab.mesh import read_off
from lab.picture import clay, draw


def number(value, digits=None):
    """With thousands marked; a dash for what is not known."""
    if value is None:
        return "–"
    return f"{value:,.0f}" if digits is None else f"{value:,.{digits}f}"


def vertices_at(row, stage):
    """Of Z at the end of a stage; None where the run has no such stage."""
    for s in row.get("stages", []):
        if s["name"] == stage:
            return s["vertices"]
    return None


def percent_of_edge(row, key):
    """A distance in percent of the longest edge, as the paper has it."""
    if row["vertices"] is None or row.get(key) is None:
        return None
    return 100 * row[key] / row["longest_edge"]


def standing(model, name):
    """How the model is called in a sentence."""
    return f"{model.name} in place of the paper's {name}" if model.stands_in else f"the paper's {name}"


def command(row):
    """How to do a run by hand."""
    return f"`isoscope-run {row['model']} {' '.join(row['arguments'])}`"


def trouble(row):
    """What keeps a result from being certified, shortly."""
    if row["vertices"] is None:
        return f"given up after {row['cpu_seconds']:.0f} CPU s" if row["signal"] else row["message"] or "failed"
    return "yes" if row["certified"] else "no: " + row["failures"][0].split(",")[0].rstrip(".")


def write(lab, name, text):
    with open(os.path.join(lab.output, name), "w", encoding="utf-8") as file:
        file.write(text)
    return name


def picture(lab, name, path, model_name, edges=True, colour=clay):
    """Draws the mesh of a file; the picture's name."""
    mesh = read_off(path)
    towards, up = views(model_name)
    draw(os.path.join(lab.output, name), mesh, towards, up, edges=edges and len(mesh.triangles) < 12000, colour=colour)
    return name
