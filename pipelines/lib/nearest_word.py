"""The word that a mistyped one stands for; the rule is that of lib/core/base/name_text."""

LEAST_BEGINNING = 5


def num_errors(a, b):
    """Edit distance in which the exchange of two neighbours is one error."""
    rows = [list(range(len(b) + 1))]
    for i in range(1, len(a) + 1):
        row = [i]
        for j in range(1, len(b) + 1):
            row.append(min(rows[-1][j] + 1, row[j - 1] + 1, rows[-1][j - 1] + (a[i - 1] != b[j - 1])))
            if i > 1 and j > 1 and a[i - 1] == b[j - 2] and a[i - 2] == b[j - 1]:
                row[j] = min(row[j], rows[-2][j - 2] + 1)
        rows.append(row)
    return rows[-1][-1]


def num_errors_or_beginning(word, other):
    errors = num_errors(word, other)
    return min(errors, 1) if len(word) >= LEAST_BEGINNING and other.startswith(word) else errors


def nearest_word(word, words):
    """Empty if none has at most one error in four letters."""
    errors, nearest = min(((num_errors_or_beginning(word, other), other) for other in words),
                          key=lambda pair: pair[0], default=(len(word), ""))
    return nearest if errors <= (len(word) + 2) // 4 else ""

