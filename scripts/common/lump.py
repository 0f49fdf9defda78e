"""Writes a shape model as OBJ: a ball of triangles whose radius swells and sinks along random directions.

python scripts/common/lump.py SEED > inputs/shapes/lump.obj
"""

import sys

import numpy as np

SPLITS = 3
"""Times that each triangle of an icosahedron is cut into four: 1280 triangles."""
AXES = (1.0, 0.8, 0.65)
WAVES = 12
ROUGHNESS = 0.25


def icosahedron():
    golden = 0.5 * (1 + 5**0.5)
    corners = [(s, t * golden, 0.0) for s in (-1, 1) for t in (-1, 1)]
    corners = np.array([np.roll(corner, turn) for turn in range(3) for corner in corners])
    near = np.isclose(np.linalg.norm(corners[:, None] - corners[None], axis=2), 2.0)
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b) if near[a, b] and near[b, c] and near[c, a]]
    return list(corners / np.linalg.norm(corners[0])), faces


def split(vertices, faces):
    middles = {}

    def middle(a, b):
        edge = (min(a, b), max(a, b))
        if edge not in middles:
            point = vertices[a] + vertices[b]
            middles[edge] = len(vertices)
            vertices.append(point / np.linalg.norm(point))
        return middles[edge]

    finer = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return finer


def lump(seed):
    """Vertices and triangles, about 1 in size."""
    draw = np.random.default_rng(seed)
    vertices, faces = icosahedron()
    for _ in range(SPLITS):
        faces = split(vertices, faces)
    directions = np.array(vertices)
    radius = np.ones(len(vertices))
    for wave in range(1, WAVES + 1):
        axis = draw.normal(size=3)
        height = directions @ (axis / np.linalg.norm(axis))
        radius += ROUGHNESS / wave * draw.uniform(-1, 1) * np.cos(wave**0.5 * np.pi * (height - draw.uniform()))
    return directions * radius[:, None] * AXES, faces


if __name__ == "__main__":
    seed = int(sys.argv[1])
    vertices, faces = lump(seed)
    print(f"# A lump, {len(faces)} triangles: scripts/common/lump.py {seed}")
    for x, y, z in vertices:
        print(f"v {x:.5f} {y:.5f} {z:.5f}")
    for face in faces:
        print("f", *(corner + 1 for corner in face))
