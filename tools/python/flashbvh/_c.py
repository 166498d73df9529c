"""The C interface by ctypes, which calls without Python's lock; flashbvh.h and robot.h describe the functions."""
import ctypes
from ctypes import POINTER, c_bool, c_char_p, c_int, c_int32, c_int64, c_size_t, c_uint8, c_uint16, c_uint32, c_uint64
from ctypes import c_void_p
from pathlib import Path

UNITS = ("", "nm", "um", "mm", "cm", "m", "mil", "in", "ft")
NO_PAIR, NO_LIMIT, OUTSIDE = 0xFFFF, 0xFFFFFFFF, 0
DONE, FULL = 0, 2
MAX_TRANSLATION, ROTATION_ONE, FINE_ONE = 1 << 29, 1 << 30, 256
FULL_TURN, FRAME_CELL = 1 << 28, 2048  # units of a coordinate: of a turn, of a cell
TOO_LONG = 0xFFFFFFFF  # a length that every query refuses


class Error(ValueError):
    """A refusal: the program's message, or the C interface's status, which `status` names."""

    __module__ = "flashbvh"

    def __init__(self, message: str, status: str = "") -> None:
        super().__init__(message)
        self.status = status


def struct(name, *fields):
    return type(name, (ctypes.Structure,), {"_fields_": fields})


def opaque(name, size):
    return struct(name, ("words", c_uint64 * (size // 8)))


Mesh, Query, GuardObject = opaque("Mesh", 96), opaque("Query", 152), opaque("GuardObject", 120)
Pose = struct("Pose", ("words", c_uint32 * 17))
Pair, Witness = (struct(name, ("a", c_uint16), ("b", c_uint16)) for name in ("Pair", "Witness"))
FineLength = struct("FineLength", ("count", c_uint32))
RunResult = struct("RunResult", ("status", c_uint8), ("count", c_uint32), ("work", c_uint32))
Clearance = struct(
    "Clearance", ("point_a", c_int64 * 3), ("point_b", c_int64 * 3), ("direction", c_int32 * 3), ("lower", c_uint32),
    ("upper", c_uint32), ("triangles", Pair), ("witness", Witness), ("status", c_int), ("in_range", c_bool))
Point = struct("Point", ("at", c_int32 * 3))
Robot = struct(
    "Robot", ("arrays", c_void_p * 6), ("joint_count", c_uint8), ("link_count", c_uint8), ("variable_count", c_uint8),
    ("padding", c_uint8), ("pair_count", c_uint16), ("reach_count", c_uint16), ("slack", c_uint32),
    ("distance_table_bytes", c_uint32), ("hash", c_uint32), ("cell_bits", c_uint64))
GuardAnswer = struct("GuardAnswer", ("status", c_uint8), ("verdict", c_uint8), ("pair", c_uint16),
                     ("distance", c_uint32), ("work", c_uint32))
LimitAnswer = struct("LimitAnswer", ("status", c_uint8), ("verdict", c_uint8), ("share", c_uint16), ("pair", c_uint16),
                     ("opposed", c_uint16), ("floor", c_uint32), ("distance", c_uint32), ("work", c_uint32))


def guard_state_size(joints, pairs, pair_joints):
    """FLASHBVH_GUARD_STATE_SIZE."""
    return 124 + 72 * joints + 28 * pairs + 4 * pair_joints + (joints + pair_joints + 3) // 4 * 4


_library = ctypes.CDLL(str(Path(__file__).with_name("_flashbvh.so")))
_sizes = [ctypes.sizeof(kind) for kind in (Mesh, Pose, Query, Pair, Witness, RunResult, Clearance, Point, Robot,
                                           GuardObject, GuardAnswer, LimitAnswer)] + [guard_state_size(5, 7, 11)]
if list((c_uint32 * len(_sizes)).in_dll(_library, "flashbvh_python_layout")) != _sizes:
    raise ImportError("flashbvh: _flashbvh.so has other structs than this package; build both again")


def _function(name: str, result, *arguments):
    function = getattr(_library, f"flashbvh_{name}")
    function.restype, function.argtypes = result, arguments
    return function


_two_posed = (POINTER(Mesh), POINTER(Mesh), POINTER(Pose))
status_name = _function("status_name", c_char_p, c_int)
open_mesh = _function("open", c_int, c_void_p, c_size_t, POINTER(Mesh))
mesh_unit = _function("mesh_unit", c_int, POINTER(Mesh))
mesh_is_closed = _function("mesh_is_closed", c_bool, POINTER(Mesh))
pose_rigid = _function("pose_rigid", c_int, c_void_p, c_void_p, c_void_p, POINTER(Pose))
query_start = _function("query_start", c_int, POINTER(Query), *_two_posed)
query_run = _function("query_run", RunResult, POINTER(Query), c_uint32, c_void_p, c_uint32)
intersects = _function("intersects", c_int, *_two_posed, POINTER(c_bool))
one_is_inside = _function("one_is_inside", c_int, *_two_posed, POINTER(c_bool))
closer_than = _function("closer_than", c_int, *_two_posed, FineLength, POINTER(c_bool))
distance = _function("distance", c_int, *_two_posed, POINTER(Witness), POINTER(Clearance))
inside = _function("inside", c_int, POINTER(Mesh), POINTER(Point), POINTER(c_int))
open_robot = _function("open_robot", c_int, c_void_p, c_size_t, POINTER(Mesh), c_uint32, POINTER(Robot))
set_values = _function("set_values", None, POINTER(Robot), c_void_p, c_void_p)
guard_init = _function("guard_init", c_int, POINTER(GuardObject), POINTER(Robot), c_void_p, c_size_t)
guard_update = _function("guard_update", GuardAnswer, POINTER(GuardObject), c_void_p, c_uint32)
guard_limit = _function("guard_limit", LimitAnswer, POINTER(GuardObject), c_void_p, c_void_p, c_uint32)
guard_release = _function("guard_release", c_int, POINTER(GuardObject), c_uint16, FineLength)
guard_go_on = _function("guard_go_on", GuardAnswer, POINTER(GuardObject), c_uint32)


def name_of(status):
    """A status's name, such as cell_mismatch."""
    return status_name(status).decode()


def check(status, place):
    """Raises Error unless the status is `done`."""
    if status != DONE:
        raise Error(f"{place}: {name_of(status)}", name_of(status))
