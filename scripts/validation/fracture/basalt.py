"""Elements of basalt that are pulled apart at a constant strain rate, without time steps: from one flaw that opens to the next the
damage is known, as D^(1/3) grows evenly. Written for comparison, with random numbers of its own.

Constants are those of the library: flaws of Benz & Asphaug 1999, k in 1/m^3."""

import numpy

K, M = 4.0e35, 9.0
BULK, SHEAR, DENSITY = 26.7e9, 22.7e9, 2700.0
YOUNG = 9 * BULK * SHEAR / (3 * BULK + SHEAR)
CRACK_SPEED = 0.4 * ((BULK + 4 / 3 * SHEAR) / DENSITY) ** 0.5


def break_time(rate):
    """When all is broken in the theory of Grady & Kipp, s."""
    spheres = 8 * numpy.pi * CRACK_SPEED**3 * K / ((M + 1) * (M + 2) * (M + 3))
    return (spheres * rate**M) ** (-1 / (M + 3))


def theory(rate):
    """Strength in the theory of Grady & Kipp, Pa: D = 1 / (m + 4) at the peak."""
    return YOUNG * rate * break_time(rate) * (M + 4) ** (-1 / (M + 3)) * (M + 3) / (M + 4)


def half_reach(rate):
    """Edge of an element: half of how far a crack comes in the time of breaking, m."""
    return 0.5 * CRACK_SPEED * break_time(rate)


def strength(rate, edge, particles, reach=None, count=20000, seed=1):
    """Largest mean stress of `count` elements, Pa, and its standard error; `reach`: R_s, 2h if not given, m."""
    draws = numpy.random.default_rng(seed)
    # Numbers of flaws below each threshold: a Poisson process that ends at the mean number of flaws.
    numbers = numpy.cumsum(draws.exponential(size=(count, 64)), axis=1)
    total = numpy.maximum(1, (numbers < numpy.log(particles) + 0.577).sum(axis=1))
    opens = (numbers / (K * edge**3)) ** (1 / M) / rate
    growth = CRACK_SPEED / (reach or 2.4 * edge)
    root = numpy.zeros((count, 65))
    for j in range(64):
        # From flaw j + 1 to the next one; the last stays last.
        active = numpy.minimum(j + 1, total)
        grown = root[:, j] + numpy.cbrt(active) * growth * (opens[:, j + 1] - opens[:, j]) if j < 63 else root[:, j]
        bound = numpy.maximum(numpy.cbrt(active / total), root[:, j])
        root[:, j + 1] = numpy.where(j + 1 < total, numpy.minimum(grown, bound), root[:, j])
    peak, error, every = 0.0, 0.0, numpy.arange(count)
    for time in opens[:, 0].min() * numpy.geomspace(1, 100, 4000):
        active = numpy.minimum((opens < time).sum(axis=1), total)
        last = numpy.maximum(active - 1, 0)
        now = root[every, last] + numpy.cbrt(active) * growth * (time - opens[every, last])
        damage = numpy.where(active > 0, numpy.minimum(now**3, active / total), 0)
        stress = YOUNG * rate * time * (1 - damage)
        if stress.mean() > peak:
            peak, error = stress.mean(), stress.std() / count**0.5
        elif stress.mean() < 0.5 * peak:
            break
    return peak, error
