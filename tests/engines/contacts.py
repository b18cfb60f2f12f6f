"""What state.py and discs.py find of the grains that a model left, and of what it says of them."""

import re

import numpy as np


def result_line(log):
    """The last RESULT line of what the engine printed."""
    with open(log, encoding="utf-8", errors="replace") as file:
        return re.findall(r"^RESULT .*$", file.read(), re.MULTILINE)[-1]


def number_in(line, pattern):
    return float(re.search(pattern, line)[1])


def modulus_of(young, poisson):
    """Of two grains of this material, in Hertz's law of spheres."""
    return young / (2 * (1 - poisson ** 2))


def contacts(at, r, modulus, box=None):
    """The sum of f l over the contacts of grains, and how many others each touches: contacts are overlaps, with the normal force f
    by Hertz's law and the distance l of the centres. The box, where there is one, is repeated on all sides."""
    n = len(r)
    fl, z = 0.0, np.zeros(n)
    for i in range(n - 1):
        step = at[i + 1:] - at[i]
        if box is not None:
            step -= box * np.round(step / box)
        distance = np.sqrt((step ** 2).sum(axis=1))
        overlap = r[i] + r[i + 1:] - distance
        touching = overlap > 0
        z[i] += touching.sum()
        z[i + 1:][touching] += 1
        other = r[i + 1:][touching]
        force = 4 / 3 * modulus * np.sqrt(r[i] * other / (r[i] + other)) * overlap[touching] ** 1.5
        fl += (force * distance[touching]).sum()
    return fl, z
