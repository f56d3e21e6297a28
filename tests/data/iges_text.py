"""IGES 5.3 files as text, in millimetres, for make_shapes.py."""


def word(value):
    return f"{len(value)}H{value}" if isinstance(value, str) else str(value)


def pieces(text, width):
    return [text[i : i + width] for i in range(0, len(text), width)]


class Iges:
    """Entities, each added with its parameters; what refers to one takes the number that `add` gave."""

    def __init__(self):
        self.entities = []

    def add(self, kind, *parameters, form=0, level=0, colour=0):
        self.entities.append((kind, parameters, form, level, colour))
        return 2 * len(self.entities) - 1

    def text(self, name):
        head = ("1H,,1H;," + ",".join(map(word, (name, name + ".iges", "test", "1", 32, 38, 6, 308, 15, name)))
                + ",1.0,2,2HMM,1,0.01,15H20000101.000000,1.0E-7,2.0,4Hnone,4Hnone,11,0,15H20000101.000000;")
        directory, data = [], []
        has_surface = any(entity[0] == 144 for entity in self.entities)
        for kind, parameters, form, level, colour in self.entities:
            # In two lines: nine numbers, and nine more; subordinate but for the roots: trimmed surfaces, or loose curves.
            status = "00000000" if kind == 144 or not has_surface else "00010000"
            lines = pieces(",".join(map(word, (kind, *parameters))) + ";", 64)
            first = (kind, len(data) + 1, 0, 0, level, 0, 0, 0)
            second = (kind, 0, colour, len(lines), form, "", "", "", 0)
            directory.append("".join(f"{n:>8}" for n in first) + status)
            directory.append("".join(f"{n:>8}" for n in second))
            data += [f"{line:<64}{len(directory) - 1:>8}" for line in lines]
        sections = {"S": [name], "G": pieces(head, 72), "D": directory, "P": data}
        sections["T"] = ["".join(f"{letter}{len(lines):>7}" for letter, lines in sections.items())]
        return "".join(f"{line:<72}{letter}{number + 1:>7}\n"
                       for letter, lines in sections.items() for number, line in enumerate(lines))
