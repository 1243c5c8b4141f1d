"""Triangle meshes as OFF files: reading, writing, what plots and pictures ask of them."""
import math


class Mesh:
    """Points and triangles."""

    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles

    def bounds(self):
        low = [min(p[k] for p in self.points) for k in range(3)]
        high = [max(p[k] for p in self.points) for k in range(3)]
        return low, high

    def longest_edge(self):
        """Of the bounding box: what percentages of δ are taken of (§5 of the paper)."""
        low, high = self.bounds()
        return max(b - a for a, b in zip(low, high))


def read_off(path):
    """Reads OFF with faces of any number of corners, cut into fans."""
    with open(path, encoding="utf-8", errors="replace") as file:
        words = [w for line in file for w in line.split("#")[0].split()]
    if not words or not words[0].upper().endswith("OFF"):
        raise ValueError(f"{path} is no OFF file")
    count, faces = int(words[1]), int(words[2])
    at = 4
    points = [tuple(float(w) for w in words[at + 3 * i:at + 3 * i + 3]) for i in range(count)]
    at += 3 * count
    triangles = []
    for _ in range(faces):
        corners = int(words[at])
        face = [int(w) for w in words[at + 1:at + 1 + corners]]
        triangles += [(face[0], face[k], face[k + 1]) for k in range(1, corners - 1)]
        at += 1 + corners
    return Mesh(points, triangles)


def write_off(path, mesh):
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"OFF\n{len(mesh.points)} {len(mesh.triangles)} 0\n")
        for p in mesh.points:
            file.write(" ".join(f"{x:.9g}" for x in p) + "\n")
        for t in mesh.triangles:
            file.write("3 " + " ".join(map(str, t)) + "\n")


def write_points(path, points):
    with open(path, "w", encoding="utf-8") as file:
        for p in points:
            file.write(" ".join(f"{x:.9g}" for x in p) + "\n")


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    """The direction of a; of a null vector itself."""
    size = math.sqrt(dot(a, a))
    return (a[0] / size, a[1] / size, a[2] / size) if size > 0 else a
