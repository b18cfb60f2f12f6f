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


def radius_of_contact(overlap, radius, modulus, surface_energy):
    """By the law of Johnson, Kendall and Roberts: a with overlap = a^2/R - 2 sqrt(pi G a/E), the greater root, from above."""
    a = np.sqrt(2 * radius * overlap) + np.cbrt(16 * np.pi * surface_energy * radius ** 2 / modulus)
    for _ in range(60):
        rest = a ** 2 / radius - 2 * np.sqrt(np.pi * surface_energy * a / modulus) - overlap
        a -= rest / (2 * a / radius - np.sqrt(np.pi * surface_energy / (modulus * a)))
    return a


def normal_force(ri, rj, distance, modulus, law="hertz", cohesion=0.0):
    """Of grains that overlap: by Hertz; less K times the area of the lens's circle (sjkr); or with a surface energy (jkr)."""
    overlap, radius = ri + rj - distance, ri * rj / (ri + rj)
    if law == "jkr":
        a = radius_of_contact(overlap, radius, modulus, cohesion)
        return 4 * modulus * a ** 3 / (3 * radius) - 2 * np.pi * a ** 2 * np.sqrt(4 * cohesion * modulus / (np.pi * a))
    hertz = 4 / 3 * modulus * np.sqrt(radius) * overlap ** 1.5
    half = (distance ** 2 + ri ** 2 - rj ** 2) / (2 * distance)
    return hertz - cohesion * np.pi * (ri ** 2 - half ** 2)


def contacts(at, r, modulus, box=None, law="hertz", cohesion=0.0):
    """The sum of f l over the contacts of grains, and how many others each touches: contacts are overlaps, with the normal force f
    by the law and the distance l of the centres. The box, where there is one, is repeated on all sides."""
    n = len(r)
    fl, z = 0.0, np.zeros(n)
    for i in range(n - 1):
        step = at[i + 1:] - at[i]
        if box is not None:
            step -= box * np.round(step / box)
        distance = np.sqrt((step ** 2).sum(axis=1))
        touching = distance < r[i] + r[i + 1:]
        z[i] += touching.sum()
        z[i + 1:][touching] += 1
        force = normal_force(r[i], r[i + 1:][touching], distance[touching], modulus, law, cohesion)
        fl += (force * distance[touching]).sum()
    return fl, z
