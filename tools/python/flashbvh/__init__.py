"""Exact collision and distance queries of triangle meshes, and guards of robots: firmware's code, called from Python.

Meshes and robots are baked by the program `flashbvh`: the file in the variable FLASHBVH, or beside this package, or in
PATH. Baking rounds meshes to a lattice; queries are exact for the baked meshes, as on a microcontroller. Poses are
homogeneous matrices, (4, 4) or (N, 4, 4), of B in A's frame, in the meshes' unit; float64 is rounded to the lattice's
fixed point alone. Results have the poses' leading shape: () for one pose, (N,) for a batch.

`Error`, a ValueError, has the program's message, or a place and the C interface's status, which `Error.status` names.
Arguments of another shape or dtype, or with a number that is not finite, raise a ValueError that names the argument.

Each call of the C interface runs without Python's lock. Threads may share meshes and robots, but no Guard.
"""
from ._c import Error
from ._mesh import Baked, Mesh, bake
from ._program import BakeWarning
from ._queries import closer_than, distance, inside, intersects, pairs, solids_intersect
from ._robot import ALL_WORK, Guard, GuardAnswer, LimitAnswer, LimitVerdict, Robot, Verdict

__all__ = ["ALL_WORK", "BakeWarning", "Baked", "Error", "Guard", "GuardAnswer", "LimitAnswer",
           "LimitVerdict", "Mesh", "Robot", "Verdict", "bake", "closer_than", "distance", "inside", "intersects", "pairs", "solids_intersect"]
