"""The block of the case files that tests write."""

BLOCK = """
dimension = 2
[grid]
cell_size = 0.5e-3
[[body]]
shape = "box"
center = [0.0, 0.0]
size = [5e-3, 10e-3]
material = "rock"
[material.rock]
density = 2600.0
youngs_modulus = 17e9
poisson_ratio = 0.14
"""
