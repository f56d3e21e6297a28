"""Points of aerofoils for tests."""
import math


def side(count, gap=0.0):
    """Of a symmetric aerofoil, half 6 % thick, from the trailing edge to the nose; `gap`: half of its trailing edge."""
    xs = [(1 + math.cos(math.pi * k / count)) / 2 for k in range(count + 1)]
    return [complex(x, 0.16 * (math.sqrt(x) - x) * (1 - 0.2 * x) + gap * x) for x in xs]


def selig(count=20, gap=0.0):
    """From the trailing edge around the nose and back to it."""
    upper = side(count, gap)
    return upper + [z.conjugate() for z in upper[-2::-1]]


def text(points, heading="", digits=6):
    return heading + "".join(f"{z.real:.{digits}f} {z.imag:.{digits}f}\n" for z in points)
