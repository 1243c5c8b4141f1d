"""Inputs that are made, not found: an undulating surface, samples with noise, torn soups. The same ones every time."""
import math
import random

from lab.mesh import Mesh, cross, dot, minus


def torus(around=48, across=24, inner=0.4):
    """A ring of radius 1 and thickness `inner`."""
    points, triangles = [], []
    for i in range(around):
        u = 2 * math.pi * i / around
        for j in range(across):
            v = 2 * math.pi * j / across
            r = 1 + inner * math.cos(v)
            points.append((r * math.cos(u), r * math.sin(u), inner * math.sin(v)))
    for i in range(around):
        for j in range(across):
            a, b = i * across + j, (i + 1) % around * across + j
            c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
            triangles += [(a, b, c), (a, c, d)]
    return Mesh(points, triangles)


def undulating(rings=72, waves=9, height=0.12):
    """A ball whose surface goes up and down like that of Fig. 25: waves along and across."""
    points = [(0.0, 0.0, 1.0)]
    for i in range(1, rings):
        theta = math.pi * i / rings
        for j in range(2 * rings):
            phi = math.pi * j / rings
            # No waves at the poles, where meridians meet.
            r = 1 + height * math.sin(theta) ** 2 * math.sin(waves * theta) * math.sin(waves * phi)
            points.append((r * math.sin(theta) * math.cos(phi), r * math.sin(theta) * math.sin(phi),
                           r * math.cos(theta)))
    points.append((0.0, 0.0, -1.0))
    n, last = 2 * rings, len(points) - 1
    triangles = []
    for j in range(n):
        k = (j + 1) % n
        triangles += [(0, 1 + j, 1 + k), (last, last - n + k, last - n + j)]
        for i in range(rings - 2):
            a, b = 1 + i * n + j, 1 + i * n + k
            triangles += [(a, a + n, b + n), (a, b + n, b)]
    return Mesh(points, triangles)


def sampled(mesh, count, noise, seed=1):
    """Points spread evenly by area, each moved by a normal distribution of deviation `noise` along every axis."""
    dice = random.Random(seed)
    areas = []
    for t in mesh.triangles:
        a, b, c = (mesh.points[i] for i in t)
        n = cross(minus(b, a), minus(c, a))
        areas.append(math.sqrt(dot(n, n)))
    points = []
    for t in dice.choices(mesh.triangles, weights=areas, k=count):
        a, b, c = (mesh.points[i] for i in t)
        u, v = dice.random(), dice.random()
        if u + v > 1:
            u, v = 1 - u, 1 - v
        points.append(tuple(a[k] + u * (b[k] - a[k]) + v * (c[k] - a[k]) + dice.gauss(0, noise) for k in range(3)))
    return points


def soup(mesh, noise, seed=1):
    """Every triangle for itself, its corners moved by up to `noise` along every axis: gaps and crossings everywhere."""
    dice = random.Random(seed)
    points, triangles = [], []
    for t in mesh.triangles:
        base = len(points)
        for i in t:
            points.append(tuple(x + dice.uniform(-noise, noise) for x in mesh.points[i]))
        triangles.append((base, base + 1, base + 2))
    return Mesh(points, triangles)
