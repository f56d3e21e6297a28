"""The workbench without its page: makes the mesh of a state, one run after another, and saves files of a state."""
import json
import os
import pathlib
import shlex
import threading
import time

import command_frame as frame
from bench.processes import Overtaken, Processes
from bench.state import STAGES, moves_of, options_of, words_of
from bench.work_folder import WorkFolder, commands_of_stages
from node_search.compass_search import moved_nodes, node_positions
from node_search.symmetries import SAME

SHOWN = ("critpoints", "separatrix", "blocksplit", "quadrefine")  # stages whose files are tabs of the page
BLOCKS_END = STAGES.index("blocksplit") + 1


class Made:
    """What a state leads to: the folder with its files, and the options of the command that makes them anew."""

    def __init__(self, folder, options, nodes_text=None):
        self.folder, self.options, self.nodes_text = folder, options, nodes_text


class Workbench:
    """`shape`: path; `others`: options of the command line that are no part of states; `output`: mesh of the saved
    command; `scratch`: a folder that is the workbench's alone."""

    def __init__(self, shape, others, saved, scratch, environment):
        self.shape, self.others, self.saved = str(shape), others, saved
        self.processes, self.work = Processes(environment), threading.Lock()
        self.scratch = pathlib.Path(scratch)
        stem = pathlib.PurePath(shape).stem
        self.found = WorkFolder(self.scratch / "found", stem)  # with the nodes that the chain finds
        self.moved = WorkFolder(self.scratch / "moved", stem)  # with nodes that were moved by hand
        self.asked = None, {}  # options with inputs, and the commands that quadmesh printed for them

    def made(self, run, state):
        """Brings the files of a state up to date."""
        options, moves = self.others + options_of(state), moves_of(state)
        commands = self.commands(run, options)
        self.found.update(run, self.shape, options, commands, self.saved.output, BLOCKS_END if moves else len(STAGES))
        return self.made_with(run, options, commands, moves) if moves else Made(self.found, options)

    def commands(self, run, options):
        """The commands of the stages, by which the files of these options are recognised. quadmesh is asked again only
        where options or inputs have changed."""
        inputs = [(path, stat.st_mtime_ns, stat.st_size) for path in self.saved.inputs if (stat := os.stat(path))]
        if self.asked[0] != (options, inputs):
            commands = commands_of_stages(run.output_of(
                ["quadmesh", "-q", self.shape, *words_of(options), "--dry-run", "-o", self.found.mesh(self.saved.output),
                 "--workdir", self.scratch / "none"]))  # a folder with files would change what is printed
            commands["cad2tri"] += f"{inputs}\n"
            if any(option == "--wall" for option, _ in options):  # then quadmesh does not try other nodes
                commands["critpoints"] += "without trials of other nodes\n"
            self.asked = (options, inputs), commands
        return self.asked[1]

    def made_with(self, run, options, commands, moves):
        """The same with moved nodes, whose file takes the place of critpoints."""
        nodes = with_moves(self.found.nodes(), moves, self.found.diameter())
        nodes_text = json.dumps(nodes, indent=1) + "\n"
        options = [(option, value) for option, value in options if not is_of_critpoints_alone(option)]
        commands = commands | {"critpoints": nodes_text}
        if self.moved.first_changed(commands) < STAGES.index("critpoints"):
            self.moved.link(self.found, commands)
        nodes_file = self.scratch / self.saved.name("nodes")
        nodes_file.write_text(nodes_text, encoding="utf-8")
        self.moved.update(run, self.shape, [*options, ("--nodes", str(nodes_file))], commands, self.saved.output)
        return Made(self.moved, [*options, ("--nodes", str(self.saved.folder / self.saved.name("nodes")))], nodes_text)

    def page(self, run, made, state, ending):
        """The page of the files, "html", or its data, "json"."""
        facts = {"state": state, "shape": pathlib.PurePath(self.shape).name, "command": self.command(made.options),
                 "folder": str(self.saved.folder), "report": made.folder.report,
                 "warnings": [f"{w['tool']}: {w['message']}" for w in made.folder.report["warnings"]],
                 **places_of(made.folder.nodes())}
        workbench, report, page = (self.scratch / name for name in ("workbench.json", "report.json", f"page.{ending}"))
        if not page.is_symlink():
            page.symlink_to("/dev/stdout")  # a pipe: a file would be flushed to the disk, which takes longer
        workbench.write_text(json.dumps(facts), encoding="utf-8")
        report.write_text(json.dumps(made.folder.report), encoding="utf-8")
        files = [file for stage in SHOWN if (file := made.folder.file(stage)).exists()]
        return run.output_of(["stageview", "-q", *files, "--run-report", report, "--workbench", workbench, "-o", page])

    def command(self, options):
        """For a shell in the folder."""
        return shlex.join(self.saved.words(options))

    def first_page(self, state):
        """The page; the state's failures are those of the command."""
        self.processes.begin(0)
        run = self.processes.of(0)
        return self.page(run, self.made(run, state), state, "html")

    def run(self, number, state):
        """The answer to a request, JSON."""
        start, command = time.monotonic(), None
        try:
            self.processes.begin(number)
            with self.work:
                run = self.processes.of(number)
                made = self.made(run, state)
                command = self.command(made.options)
                data = self.page(run, made, state, "json")
                self.processes.require_newest(number)
        except Overtaken:
            return json.dumps({"number": number, "ok": False, "overtaken": True})
        except Exception as error:
            return json.dumps({"number": number, "ok": False, "message": str(frame.failure_of(error)), "command": command})
        answer = {"number": number, "ok": True, "command": command, "report": made.folder.report,
                  "warnings": [f"{w['tool']}: {w['message']}" for w in made.folder.report["warnings"]],
                  "seconds": time.monotonic() - start}
        return f'{json.dumps(answer)[:-1]}, "page": {data}}}'  # the data are JSON already

    def save(self, state, what):
        """Writes a file of a state, and the nodes that it names. The answer to a request, JSON."""
        try:
            with self.work:
                return json.dumps(self.saved_file(self.made(self.processes.of(self.processes.newest), state), what))
        except Overtaken:
            return json.dumps({"ok": False, "message": "another change came before the file was saved: save it again"})
        except Exception as error:
            return json.dumps({"ok": False, "message": str(frame.failure_of(error))})

    def saved_file(self, made, what):
        """The answer to a request to save, after what it names was written."""
        has_nodes = made.nodes_text is not None
        if what == "nodes" and made.folder.nodes() is None:
            raise frame.Failure(frame.NO_RESULT, "these blocks were made without irregular nodes: there are none to save")
        if has_nodes or what == "nodes":
            text = made.nodes_text or made.folder.file("critpoints").read_text(encoding="utf-8")
            name = self.saved.write("nodes", text)
        if what == "command":
            text = self.saved.script(made.options)
        elif what == "makefile":
            text = self.saved.makefile(made.options, has_nodes)
        if what != "nodes":
            name = self.saved.write(what, text)
        return {"ok": True, "file": name, "text": text}

    def close(self):
        """Stops what runs, and waits for its end."""
        self.processes.close()
        self.work.acquire(timeout=5)


def is_of_critpoints_alone(option):
    takers = [stage for stage in STAGES if option in frame.option_kinds(stage)]
    return takers == ["critpoints"] or option == "--nodes"


def with_moves(nodes, moves, diameter):
    """The content of x.crit.json with the nodes moved, one after another."""
    if nodes is None:
        raise frame.Failure(frame.NO_RESULT, "these blocks were made without irregular nodes: there is nothing to move")
    origin = complex(*nodes["origin"])
    for start, end in moves:
        places = node_positions(nodes)
        nearest = min(range(len(places)), key=lambda k: abs(places[k] + origin - start), default=None)
        if nearest is None or abs(places[nearest] + origin - start) > SAME * diameter:
            raise frame.Failure(frame.NO_RESULT, f"there is no irregular node at ({start.real:.6g}, {start.imag:.6g}), as "
                                                 "the other changes have others: undo this move")
        nodes = moved_nodes(nodes, {nearest: end - origin - places[nearest]})
    return nodes


def places_of(nodes):
    """Irregular nodes and corners for the page, in coordinates of the CAD file."""
    if nodes is None:
        return {"nodes": [], "corners": []}
    place = lambda entry: [x + x0 for x, x0 in zip(entry["position"], nodes["origin"])]
    return {"nodes": [{"position": place(n), "valence": n["valence"]} for n in nodes["critical_points"]],
            "corners": [{"position": place(c), "valence": c["valence"], "curves": c["curves"]} for c in nodes["corners"]]}
