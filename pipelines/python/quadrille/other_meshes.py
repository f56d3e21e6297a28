"""Meshes for other packages of Python, which read Gmsh's format: meshio, dolfinx. They are imported only here."""
import collections
import importlib

from .memory_files import MemoryFiles
from .tool_errors import ToolError

DolfinxMesh = collections.namedtuple("DolfinxMesh", "mesh cell_tags facet_tags names")


def to_meshio(mesh, options):
    meshio = package("meshio", "python3-meshio")
    with MemoryFiles() as files:
        return meshio.read(files.path(mesh.bytes_of("msh", **options)), file_format="gmsh")


def to_dolfinx(mesh, comm, options):
    gmsh = package("gmsh", "python3-gmsh")
    gmshio = package("dolfinx.io.gmshio", "python3-dolfinx")
    mpi = package("mpi4py.MPI", "python3-mpi4py")
    comm = comm or mpi.COMM_WORLD
    names = {}
    with MemoryFiles() as files:
        gmsh.initialize()
        try:
            gmsh.option.setNumber("General.Terminal", 0)
            if comm.rank == 0:
                gmsh.merge(files.path(mesh.bytes_of("msh", **options)))
                names = {(dim, gmsh.model.getPhysicalName(dim, tag)): tag for dim, tag in gmsh.model.getPhysicalGroups()}
            made = gmshio.model_to_mesh(gmsh.model, comm, 0, gdim=mesh.points.shape[1])
        except KeyError:
            raise ToolError(1, "dolfinx", f"this version does not read elements of order {mesh.order}: make the mesh "
                                          "with a lower order") from None
        finally:
            gmsh.finalize()
    return DolfinxMesh(*made[:3], comm.bcast(names, 0))


def package(name, debian):
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ToolError(1, name, f"cannot be imported ({error}): install the package {debian} of Debian") from error
