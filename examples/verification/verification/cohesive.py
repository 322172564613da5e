"""Strength of a centre-cracked plate by a cohesive crack: a reference of its own.

Hillerborg, Modeer and Petersson (Cement and Concrete Research 6, 1976): closing stress
sigma_t (1 - w / w_c) on the process zone, w the opening, w_c = 2 G_f / sigma_t. Opening and stress
intensity of the pair of point forces of an infinite plate, with the finite width's factor on the
load at the whole crack (both: Tada, Paris and Irwin, The stress analysis of cracks handbook).
"""

import numpy as np
from numpy import pi, sqrt

PANELS = 80
PER_PANEL = 40


def width_factor(half_crack, width):
    """Stress intensity over that of an infinite plate, within 0.1 % (Tada)."""
    share = 2.0 * half_crack / width
    return (1.0 - 0.025 * share**2 + 0.06 * share**4) / sqrt(np.cos(0.5 * pi * share))


def openings(half_crack, x, edges, modulus):
    """[i, j]: opening (m) at x[i] per unit stress (Pa) on the panel of angles edges[j], edges[j+1],
    both sides of the centre; t = half_crack sin(angle)."""
    middle = (np.arange(PER_PANEL) + 0.5) / PER_PANEL
    steps = np.diff(edges)
    angle = edges[:-1, None] + steps[:, None] * middle
    at_x = sqrt(half_crack**2 - x**2)[:, None, None]
    at_t = half_crack * np.cos(angle)
    kernel = np.log(np.abs((at_x + at_t) / (at_x - at_t))) * at_t
    return 4.0 / (pi * modulus) * kernel.sum(2) * steps / PER_PANEL


def load_at(half_crack, notch, width, modulus, strength, energy):
    """Remote stress (Pa) that holds a crack whose zone reaches from `notch` to `half_crack`, and the
    closing stress left at the notch: no stress intensity at the end of the zone, and the law
    between stress and opening along it."""
    edges = np.linspace(np.arcsin(notch / half_crack), pi / 2.0, PANELS + 1)
    x = half_crack * np.sin(0.5 * (edges[1:] + edges[:-1]))
    per_load = width_factor(half_crack, width)
    system = np.zeros((PANELS + 1, PANELS + 1))
    full_opening = 2.0 * energy / strength
    system[:-1, :-1] = (np.eye(PANELS) * full_opening / strength
                        - openings(half_crack, x, edges, modulus))
    system[:-1, -1] = 4.0 / modulus * sqrt(half_crack**2 - x**2) * per_load
    system[-1, :-1] = 2.0 * sqrt(half_crack / pi) * np.diff(edges)
    system[-1, -1] = -sqrt(pi * half_crack) * per_load
    solution = np.linalg.solve(system, np.append(np.full(PANELS, full_opening), 0.0))
    return solution[-1], solution[0]


def strength(notch, width, modulus, tensile_strength, energy):
    """Largest remote stress, Pa; `notch` is half the crack's length, m, modulus that of plane
    strain. Valid while closing stress is left at the notch when it is reached."""
    loads = []
    for zone in np.arange(0.01, 2.0, 0.01) * modulus * energy / tensile_strength**2:
        if notch + zone >= 0.5 * width:
            break
        load, left = load_at(notch + zone, notch, width, modulus, tensile_strength, energy)
        if left < 0.0:
            break
        loads.append(load)
    return max(loads)


def irwin_strength(notch, width, modulus, tensile_strength, energy):
    """The estimate with a crack longer by Irwin's (K / sigma_t)^2 / 2 pi, Pa."""
    crack = notch + modulus * energy / tensile_strength**2 / (2.0 * pi)
    return sqrt(modulus * energy / (pi * crack)) / width_factor(crack, width)
