"""Settings that give the scenes of inputs/exact/ another spacing or dimension."""

ROW = {2: (1.0, 0.75**0.5, 0.0), 3: (1.0, 0.75**0.5, (2 / 3) ** 0.5)}
"""Distances between close-packed rows and layers, in spacings."""


def vector(values, dimension):
    return "[" + ", ".join(f"{x:.12g}" for x in values[:dimension]) + "]"


def slab(bodies, spacing, dimension, rows=8):
    """Plates that fill a periodic cross-section of `rows` rows; `bodies`: name -> (ends along x, velocity along x or None)."""
    across = [rows * spacing * step for step in ROW[dimension][1:]]
    axes = zip("yz"[: dimension - 1], across)
    settings = [f"dimension={dimension}"]
    settings.append("domain={ periodic = { " + ", ".join(f"{axis} = [0, {length:.12g}]" for axis, length in axes) + " } }")
    for name, (low, high, velocity) in bodies.items():
        settings.append(f"{name}.spacing={spacing}")
        settings.append(f"{name}.size={vector([high - low, *across], dimension)}")
        settings.append(f"{name}.position={vector([0.5 * (low + high), *(0.5 * length for length in across)], dimension)}")
        if velocity is not None:
            settings.append(f"{name}.velocity={vector([velocity, 0, 0], dimension)}")
    return settings


def wave(spacing, dimension, rows=8):
    """A body one wavelength of 1 m long that closes on itself everywhere."""
    size = [1.0] + [rows * spacing * step for step in ROW[dimension][1:]]
    axes = ", ".join(f"{axis} = [{-0.5 * s:.12g}, {0.5 * s:.12g}]" for axis, s in zip("xyz"[:dimension], size))
    return [
        f"dimension={dimension}",
        "domain={ periodic = { " + axes + " } }",
        f"rock.size={vector(size, dimension)}",
        f"rock.spacing={spacing}",
    ]
