"""Compares pictures so that other fonts and other smoothing of lines pass, and a missing layer does not.

A drawing without texts: the share of pixels that differ by more than 12 of 255 levels, both pictures smoothed over
3 x 3 pixels; above 0.25 % it is another drawing. A page with texts, whose place and shape depend on the fonts of the
machine: the share of squares of 16 x 16 pixels whose mean colours differ by more than 14 levels; above 6 % it is
another page. tests/peers/browser.bats measures both sides of the limits.
"""
import numpy as np
from PIL import Image

WIDTH = 480  # pixels
LEVELS = {"drawing": 12, "page": 14}
LARGEST = {"drawing": 0.0025, "page": 0.06}


def shrunk(picture):
    """At the width of the stored pictures."""
    return picture.convert("RGB").resize((WIDTH, round(picture.height * WIDTH / picture.width)), Image.BOX)


def smoothed(levels):
    padded = np.pad(levels, ((1, 1), (1, 1), (0, 0)), mode="edge")
    rows, columns = levels.shape[:2]
    return sum(padded[i:i + rows, j:j + columns] for i in range(3) for j in range(3)) / 9


def mean_of_squares(levels, size=16):
    rows, columns = (n // size for n in levels.shape[:2])
    return levels[:rows * size, :columns * size].reshape(rows, size, columns, size, 3).mean((1, 3))


def difference(kind, picture, reference):
    """The share of what differs, from 0 to 1; 1 if the sizes differ. `kind`: "drawing" or "page"."""
    if picture.size != reference.size:
        return 1.0
    prepare = smoothed if kind == "drawing" else mean_of_squares
    a, b = (prepare(np.asarray(p.convert("RGB"), dtype=float)) for p in (picture, reference))
    return float((np.abs(a - b).max(axis=2) > LEVELS[kind]).mean())


def is_same(kind, picture, reference):
    return difference(kind, picture, reference) <= LARGEST[kind]
