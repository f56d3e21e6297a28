"""The chain in Python: results are those of the tools, failures are exceptions, and nothing is left behind."""
import os
import pathlib
import pickle
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import warnings

import numpy as np

import quadrille

DATA = pathlib.Path(os.environ["ROOT"]) / "tests" / "data"
CHAINS = pathlib.Path(os.environ["CHAINS"])
HALF_DISC = DATA / "half_disc.step"


def open_files():
    return len(os.listdir("/proc/self/fd"))


def processes(name):
    """Numbers of the processes with this word in their command line."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            if name.encode() in path.read_bytes() and int(path.parent.name) != os.getpid():
                found.append(path.parent.name)
        except OSError:
            pass
    return found


class StagesTest(unittest.TestCase):
    def test_each_stage_makes_the_bytes_of_the_tool(self):
        read = lambda ending: (CHAINS / f"half_disc.{ending}").read_bytes()
        triangles = quadrille.cad2tri(HALF_DISC)
        self.assertEqual(triangles.data, read("tri.h5"))
        field = quadrille.padapt(quadrille.fieldsolve(triangles))
        nodes = quadrille.critpoints(field)
        self.assertEqual((field.data, nodes.data), (read("field.h5"), read("crit.json")))
        graph = quadrille.separatrix(field, nodes)
        blocks = quadrille.blocksplit(graph)
        self.assertEqual((graph.data, blocks.data), (read("sep.json"), read("blocks.h5")))
        quads = quadrille.quadrefine(blocks)
        self.assertEqual(quads.data, read("quad.h5"))
        self.assertEqual(quadrille.mesh(HALF_DISC).data, quads.data)
        self.assertEqual(quads.bytes_of("msh"), read("msh"))
        self.assertEqual(quadrille.hexsweep(quads, one_layer=True).num_elements, quads.num_elements)

    def test_results_are_read_saved_drawn_and_used_again(self):
        blocks = quadrille.read(CHAINS / "half_disc.blocks.h5")
        quads = quadrille.quadrefine(blocks, size=0.2, order=2)
        self.assertEqual(quads.report["tool"], "quadrefine")
        self.assertEqual((quads.points.shape, quads.cells.shape), (quads.nodes.shape, (quads.num_elements, 9)))
        self.assertIn("<svg", quads._repr_svg_())
        self.assertIn("<svg", blocks._repr_svg_())
        with tempfile.TemporaryDirectory() as folder:
            quads.save(f"{folder}/x.quad.h5")
            self.assertEqual(repr(quadrille.read(f"{folder}/x.quad.h5")), repr(quads))
            self.assertEqual(quads.write(f"{folder}/x.xml", unit="m")["unit"], "metre")
            quadrille.export(blocks, f"{folder}/x.step")
            self.assertEqual(sorted(os.listdir(folder)), ["x.quad.h5", "x.step", "x.xml"])

    def test_the_representation_is_the_last_line_of_quadmesh(self):
        made = subprocess.run([os.environ["BIN"] + "/quadmesh", HALF_DISC, "-o", "/dev/null", "--format", "msh"],
                              capture_output=True, text=True, check=True)
        self.assertEqual(repr(quadrille.mesh(HALF_DISC)), f"<QuadMesh: {made.stdout.strip()}>")
        without_verdict = made.stdout.strip().removesuffix("; good")
        self.assertEqual(repr(quadrille.read(CHAINS / "half_disc.quad.h5")), f"<QuadMesh: {without_verdict}>")

    def test_options_of_quadexport_are_kept_for_write(self):
        mesh = quadrille.mesh(HALF_DISC, size=0.3, unit="m", format="mfem13")
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(mesh.write(f"{folder}/x.mesh")["format"], "mfem13")
            self.assertEqual(mesh.write(f"{folder}/x.vtu", format="auto")["unit"], "metre")

    def test_a_sweep_and_a_chart(self):
        hexes = quadrille.mesh(HALF_DISC.read_bytes(), size=0.4, sweep=True, height=1, layers=2)
        self.assertEqual((type(hexes), hexes.num_layers, hexes.points.shape[1]), (quadrille.HexMesh, 2, 3))
        chart = quadrille.cad2chart(DATA / "curved" / "torus_patch.step", face=0)
        self.assertEqual(quadrille.cad2tri(chart).order, quadrille.cad2tri(HALF_DISC).order)
        self.assertTrue(quadrille.cad2tri(HALF_DISC, list=True).startswith("face "))

    def test_content_of_files_may_be_given(self):
        mesh = quadrille.mesh(HALF_DISC, size=0.4, boundary_names=[{"near": [0, 1], "name": "wall"}])
        self.assertIn("wall", mesh.boundary_names)

    def test_failures_have_code_stage_text_and_remedy(self):
        with self.assertRaises(quadrille.ToolError) as caught, warnings.catch_warnings():
            warnings.simplefilter("ignore", quadrille.ToolWarning)
            quadrille.mesh(HALF_DISC, walls={"curve_0": {"first": 1e-3, "layers": 60}})
        error = caught.exception
        self.assertEqual((error.code, error.stage, error.report["exit_code"]), (1, "quadrefine", 1))
        self.assertIn("at most", error.text)
        self.assertTrue(error.remedy.startswith("ask for as many as fit"), error.remedy)
        self.assertEqual(pickle.loads(pickle.dumps(error)).text, error.text)

    def test_failures_by_exit_code(self):
        field = quadrille.read(CHAINS / "half_disc.field.h5")
        other = quadrille.read(CHAINS / "plate_hole.crit.json")
        for code, stage, text, call in (
                (2, "quadmesh", "--size: -1.0 is outside its interval (at least 0)", lambda: quadrille.mesh(HALF_DISC, size=-1.0)),
                (2, "quadmesh", "there is no option workdir", lambda: quadrille.mesh(HALF_DISC, workdir="w")),
                (3, "quadmesh", "none.step: no such file", lambda: quadrille.mesh("none.step")),
                (3, "quadrefine", "the Field: ", lambda: quadrille.quadrefine(field)),
                (3, "separatrix", "the CriticalPoints was not made from the Field", lambda: quadrille.separatrix(field, other)),
                (4, "quadexport", "/none/x.msh: cannot be written",
                 lambda: quadrille.read(CHAINS / "half_disc.quad.h5").write("/none/x.msh"))):
            with self.assertRaises(quadrille.ToolError) as caught:
                call()
            self.assertEqual((caught.exception.code, caught.exception.stage), (code, stage))
            self.assertTrue(caught.exception.text.startswith(text), caught.exception.text)

    def test_warnings_point_to_the_caller(self):
        quads = quadrille.read(CHAINS / "half_disc.quad.h5")
        with tempfile.TemporaryDirectory() as folder, self.assertWarns(quadrille.ToolWarning) as caught:
            quads.write(f"{folder}/blockMeshDict", format="blockmesh")
        self.assertEqual((caught.warning.code, caught.filename), ("W-EXP-001", __file__))
        with self.assertWarns(quadrille.ToolWarning) as caught:
            quadrille.quadrefine(quadrille.read(CHAINS / "plate_hole.blocks.h5"), size=100, target_edge_ratio=0, per_curve=0,
                                 geometry_tol=1)
        self.assertEqual(caught.filename, __file__)

    def test_meshio_has_the_names(self):
        try:
            import meshio  # noqa: F401
        except ImportError:
            self.skipTest("no meshio: apt-get install python3-meshio")
        mesh = quadrille.read(CHAINS / "half_disc.quad.h5")
        made = mesh.to_meshio()
        self.assertEqual(sum(len(block.data) for block in made.cells if block.type == "quad25"), mesh.num_elements)
        self.assertEqual(sorted(made.field_data), ["curve_0", "curve_1", "domain"])

    def test_dolfinx_has_the_names(self):
        try:
            import dolfinx  # noqa: F401
            import gmsh  # noqa: F401
        except ImportError:
            self.skipTest("no dolfinx: apt-get install python3-dolfinx python3-gmsh")
        mesh = quadrille.mesh(HALF_DISC, size=0.3, order=2)
        made = mesh.to_dolfinx()
        self.assertEqual(sorted(made.names), [(1, "curve_0"), (1, "curve_1"), (2, "domain")])
        self.assertEqual(len(made.cell_tags.find(made.names[2, "domain"])), mesh.num_elements)
        edges = sum(len(made.facet_tags.find(made.names[1, f"curve_{k}"])) for k in range(2))
        self.assertEqual(edges, len(mesh.boundary_edges["elem"]))
        with self.assertRaisesRegex(quadrille.ToolError, "order 4: make the mesh with a lower order"):
            quadrille.read(CHAINS / "half_disc.quad.h5").to_dolfinx()

    def test_a_package_that_is_missing_is_named(self):
        from quadrille.other_meshes import package
        with self.assertRaisesRegex(quadrille.ToolError, "install the package python3-none of Debian"):
            package("no_such_package", "python3-none")


class NothingLeftTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def slow(self, end):
        """A Python process that meshes, with quadmesh replaced by one that lasts; `end` is called when it has begun."""
        folder = pathlib.Path(self.folder.name)
        (folder / "temp").mkdir()
        marker = f"slow-{os.getpid()}"
        program = ("import quadrille\ntry:\n quadrille.mesh(%r, stage={'padapt': 'touch %s/begun; sleep 100; : %s'})\n"
                   "except BaseException as error:\n print(type(error).__name__)\n" % (str(HALF_DISC), folder, marker))
        environment = os.environ | {"TMPDIR": f"{folder}/temp"}
        with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, env=environment) as child:
            while not (folder / "begun").exists():
                time.sleep(0.02)
            end(child)
            printed = child.communicate(timeout=60)[0].strip()
        self.assertEqual(os.listdir(folder / "temp"), [])
        self.assertEqual(processes(marker), [])
        return printed

    def test_an_interrupt_ends_the_tool(self):
        self.assertEqual(self.slow(lambda child: child.send_signal(signal.SIGINT)), "KeyboardInterrupt")

    def test_success_and_failure_leave_no_descriptor_and_no_file(self):
        os.environ["TMPDIR"], before = self.folder.name, os.environ.get("TMPDIR")
        try:
            quadrille.mesh(HALF_DISC, size=0.4)
            count = open_files()
            for options in ({"size": 0.4}, {"size": -1}, {"siz": 1}, {"max_elements": 1}):
                try:
                    quadrille.mesh(HALF_DISC, **options)
                except quadrille.ToolError:
                    pass
        finally:
            os.environ.pop("TMPDIR")
            if before is not None:
                os.environ["TMPDIR"] = before
        self.assertEqual(open_files(), count)
        self.assertEqual(os.listdir(self.folder.name), [])
        with self.assertRaises(ChildProcessError):
            os.waitpid(-1, os.WNOHANG)


if __name__ == "__main__":
    unittest.main()
