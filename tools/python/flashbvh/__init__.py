"""Exact collision and distance queries of triangle meshes, and guards of robots: firmware's code, in batches.

Baking rounds meshes to a lattice; queries are exact for the baked meshes, as on a microcontroller. Poses are
homogeneous matrices, (4, 4) or (N, 4, 4), of B in A's frame, in the meshes' unit. Results have the poses'
leading shape: () for one pose, (N,) for a batch. Batches run without Python's lock.

`Error`, a ValueError, has the message of the program `flashbvh` for inputs that it refuses. Arguments of another
shape or dtype, or with a number that is not finite, raise a ValueError that names the argument.
"""
from ._errors import BakeWarning, Error
from ._meshes import Baked, Mesh, bake
from ._motions import BodyMotion, ContactOutcome, FirstContacts, first_contact
from ._queries import (Distances, Hits, closer_than, distance, first_pair, inside, intersects, nearest_hit, pairs,
                       solids_intersect)
from ._robot import (ALL_WORK, Checked, Guard, GuardAnswer, GuardedPair, MatrixRow, Motion, MotionAnswer, Robot,
                     UnguardedPair, Verdict)
from .collision import CollisionManager

__all__ = [
    "ALL_WORK", "BakeWarning", "Baked", "BodyMotion", "Checked", "CollisionManager", "ContactOutcome", "Distances",
    "Error", "FirstContacts", "Guard", "GuardAnswer", "GuardedPair", "Hits", "MatrixRow", "Mesh", "Motion",
    "MotionAnswer", "Robot", "UnguardedPair", "Verdict", "bake", "closer_than", "distance", "first_contact",
    "first_pair", "inside", "intersects", "nearest_hit", "pairs", "solids_intersect",
]
