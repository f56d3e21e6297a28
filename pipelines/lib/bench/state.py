"""What was done in the workbench, as its page sends it (pipelines/quadbench.md, "Requests"), and the options of
quadmesh that do it. An option is a pair (name, value), of a flag (name, None)."""
import math

import command_frame as frame

STAGES = ("cad2tri", "fieldsolve", "padapt", "critpoints", "separatrix", "blocksplit", "quadrefine", "quadexport")
OF_PAGE = STAGES[3:]  # stages whose options the page may set
NODE_RULES = ("auto", "none", "fewest", "field")  # values of --nodes that are no file
IN_STATE = ("--name", "--size", "--size-near", "--wall", "--corner-valence")  # what the state has keys for
LONGEST = 4096  # characters of a text


def empty_state():
    return {"names": [], "size": None, "near": {}, "walls": {}, "valences": [], "moves": [], "options": []}


def checked(state):
    """The state with all its keys. A Failure says what is not as it must be; the page is not trusted."""
    if not isinstance(state, dict) or not set(state) <= set(empty_state()):
        raise frame.mistake(f"a state is an object with the keys {', '.join(empty_state())}")
    state = empty_state() | state
    for key, kind in {"names": list, "near": dict, "walls": dict, "valences": list, "moves": list, "options": list}.items():
        if not isinstance(state[key], kind):
            raise frame.mistake(f"{key}: expected {'a list' if kind is list else 'an object'}")
    return state


def text(value, what):
    """A text that can be a part of a word of a command."""
    if not isinstance(value, str) or not 0 < len(value) <= LONGEST or not value.isprintable():
        raise frame.mistake(f"{what}: expected a text of 1 to {LONGEST} printable characters")
    return value


def number_text(value, what):
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise frame.mistake(f"{what}: expected a number")
    return repr(value)


def position(value, what):
    if not isinstance(value, list) or len(value) != 2:
        raise frame.mistake(f"{what}: expected a position, [x, y]")
    return complex(*(float(number_text(part, what)) for part in value))


def members(entry, keys, what):
    """The values of these keys of an object that has no others."""
    if not isinstance(entry, dict) or set(entry) != set(keys):
        raise frame.mistake(f"{what}: expected an object with the keys {', '.join(keys)}")
    return [entry[key] for key in keys]


def name_option(entry):
    """NAME=3,4 of curves, NAME=SELECTOR or NAME@X,Y of a selector."""
    if isinstance(entry, dict) and "curves" in entry:
        curves, name = members(entry, ("curves", "name"), "names")
        is_sound = isinstance(curves, list) and curves and all(type(c) is int and 0 <= c < 10**6 for c in curves)
        if not is_sound or len(curves) > 10000:
            raise frame.mistake("names: expected the numbers of 1 to 10000 curves")
        selector = ",".join(map(str, curves))
    else:
        selector, name = members(entry, ("selector", "name"), "names")
    return "--name", text(name, "names") + ("" if text(selector, "names").startswith("@") else "=") + selector


def valence_option(entry):
    corner, valence = members(entry, ("corner", "valence"), "valences")
    if not isinstance(corner, list) or len(corner) != 2 or type(valence) is not int:
        raise frame.mistake("valences: expected a corner, [A, B], and its number of blocks")
    curves = (str(curve) if type(curve) is int else text(curve, "valences") for curve in corner)
    return "--corner-valence", f"{':'.join(curves)}={valence}"


def is_for_page(option, value):
    """Whether the page may set an option: one of a stage that makes nodes, blocks or quads of the field, and never one
    that names a file or a program."""
    kinds = [kind for stage in OF_PAGE if (kind := frame.option_kinds(stage).get(option))]
    names_file = option == "--nodes" and value not in NODE_RULES
    return bool(kinds) and option in frame.option_kinds("quadmesh") and "file" not in kinds and not names_file


def page_options(words):
    texts = [text(word, "options") for word in words]
    for option, value in frame.option_pairs(texts, frame.listed_options("quadmesh").get):
        if option is None or option in IN_STATE or not is_for_page(option, value):
            raise frame.mistake(f"options: {option or value} cannot be set in the page")
        yield option, value


def options_of(state):
    """The options of quadmesh that do what the state holds, but for `moves`, in the order of its keys."""
    state = checked(state)
    options = [name_option(entry) for entry in state["names"]]
    if state["size"] is not None:
        options.append(("--size", number_text(state["size"], "size")))
    for name, size in state["near"].items():
        shown = text(size, "near") if isinstance(size, str) else number_text(size, "near")
        options.append(("--size-near", f"{text(name, 'near')}={shown}"))
    options += [("--wall", f"{text(name, 'walls')}:{text(rule, 'walls')}") for name, rule in state["walls"].items()]
    options += [valence_option(entry) for entry in state["valences"]]
    return options + list(page_options(state["options"]))


def words_of(options):
    """The words of options for a command line: a value that begins with - is joined to its option, which it would
    otherwise end."""
    words = []
    for option, value in options:
        is_joined = value is not None and value.startswith("-")
        words += [f"{option}={value}"] if is_joined else [option] if value is None else [option, value]
    return words


def moves_of(state):
    """The moves of irregular nodes, in order: (from, to) as complex numbers, in coordinates of the CAD file."""
    return [tuple(map(position, members(move, ("node", "to"), "moves"), ("moves", "moves")))
            for move in checked(state)["moves"]]


def state_of(options):
    """The state of the options of a command line, and the options that the page cannot set."""
    state, others = empty_state(), []
    for option, value in options:
        if option in IN_STATE:
            add_to(state, option, value)
        elif is_for_page(option, value):
            state["options"] += [option] if value is None else [option, value]
        else:
            others.append((option, value))
    return state, others


def add_to(state, option, value):
    if option == "--size":
        state["size"] = frame.number(option, value, 0, math.inf, is_open=True)
        return
    separator = {"--name": "=" if "=" in value else "@", "--wall": ":"}.get(option, "=")
    name, found, rest = value.partition(separator)
    if not (name and found and rest):
        raise frame.mistake(f"{option}: '{value}' has no {separator} between a name and what it means")
    if option == "--name":
        state["names"].append({"selector": rest if separator == "=" else "@" + rest, "name": name})
    elif option == "--corner-valence":
        state["valences"].append({"corner": name.split(":"), "valence": frame.number(option, rest, 0, 4, int)})
    else:
        values = state["near" if option == "--size-near" else "walls"]
        if name in values:
            raise frame.mistake(f"{option} is given twice for {name}")
        values[name] = rest
