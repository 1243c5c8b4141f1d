"""Pictures of meshes as PNG, shaded by a depth buffer of our own, so that no display and no library is needed."""
import math
import struct
import zlib

from lab.mesh import cross, dot, minus, unit

FINE = 2  # samples along each side of a pixel
PAPER = (255, 255, 255)
CLAY = (214, 205, 190)
EDGE = (60, 66, 76)


def write_png(path, width, rows):
    """`rows`: bytes of RGB, one object a row."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    packed = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows), 9)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def frame(towards, up):
    """Axes of the picture: right, up, towards the eye."""
    towards = unit(towards)
    right = unit(cross(up, towards))
    return right, cross(towards, right), towards


def clay(normal, axes):
    """Shaded by a light over the left shoulder; the far side of a facet is as bright as the near one."""
    light = unit(tuple(-0.3 * axes[0][k] + 0.5 * axes[1][k] + 0.9 * axes[2][k] for k in range(3)))
    shade = 0.42 + 0.58 * abs(dot(normal, light))
    return tuple(int(c * shade) for c in CLAY)


def by_normal(normal, axes):
    """A colour for each direction: red right, green up, blue towards the eye."""
    return tuple(int(127.5 * (1 + dot(normal, axis))) for axis in axes)


def draw(path, mesh, towards, up, size=360, edges=True, colour=clay):
    """An orthographic view of the whole mesh."""
    axes = frame(towards, up)
    places = [tuple(dot(p, axis) for axis in axes) for p in mesh.points]
    side = size * FINE
    low = [min(p[k] for p in places) for k in range(2)]
    high = [max(p[k] for p in places) for k in range(2)]
    scale = 0.94 * side / max(high[0] - low[0], high[1] - low[1], 1e-300)
    height = max(FINE, int((high[1] - low[1]) * scale + 0.06 * side))
    height -= height % FINE
    shift = (side / 2 - scale * (low[0] + high[0]) / 2, height / 2 + scale * (low[1] + high[1]) / 2)
    seen = [(shift[0] + scale * x, shift[1] - scale * y, scale * z) for x, y, z in places]
    depth = [-math.inf] * (side * height)
    pixels = [PAPER] * (side * height)
    for t in mesh.triangles:
        a, b, c = (seen[i] for i in t)
        twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if twice == 0:
            continue
        p, q, r = (mesh.points[i] for i in t)
        fill = colour(unit(cross(minus(q, p), minus(r, p))), axes)
        # Barycentric coordinates times these are distances from the edges in samples.
        heights = [abs(twice) / max(math.dist(u[:2], v[:2]), 1e-9) for u, v in ((b, c), (c, a), (a, b))]
        for y in range(max(0, math.ceil(min(a[1], b[1], c[1]))), min(height - 1, int(max(a[1], b[1], c[1]))) + 1):
            row = y * side
            for x in range(max(0, math.ceil(min(a[0], b[0], c[0]))), min(side - 1, int(max(a[0], b[0], c[0]))) + 1):
                w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / twice
                v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / twice
                u = 1 - v - w
                if u < 0 or v < 0 or w < 0:
                    continue
                z = u * a[2] + v * b[2] + w * c[2]
                if z > depth[row + x]:
                    depth[row + x] = z
                    near = min(u * heights[0], v * heights[1], w * heights[2])
                    pixels[row + x] = EDGE if edges and near < 0.9 else fill
    rows = []
    for y in range(0, height, FINE):
        line = bytearray()
        for x in range(0, side, FINE):
            block = [pixels[(y + j) * side + x + i] for j in range(FINE) for i in range(FINE)]
            line += bytes(sum(p[k] for p in block) // len(block) for k in range(3))
        rows.append(line)
    write_png(path, size, rows)
