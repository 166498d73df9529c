"""An example of the package's use, for `mypy --strict`."""
from typing import Optional

import numpy as np
import numpy.typing as npt
from typing_extensions import assert_type

import flashbvh
from flashbvh import Baked, Guard, GuardAnswer, Mesh, Motion, Robot, Verdict

a: Mesh = Mesh.from_file("a.stl", scale=0.001)
b: Mesh = Mesh.from_arrays(np.zeros((3, 3)), [[0, 1, 2]], cell=0.1)
assert_type(flashbvh.bake(a, unit="m"), Baked)
baked_a, baked_b = flashbvh.bake([a, b])
assert_type(baked_a, Baked)
assert_type(baked_a.image, bytes)
assert_type(baked_a.bounds, npt.NDArray[np.float64])

poses = np.tile(np.eye(4), (9, 1, 1))
assert_type(flashbvh.intersects(baked_a, baked_b, poses), npt.NDArray[np.bool_])
assert_type(flashbvh.distance(baked_a, baked_b, poses).point_a, npt.NDArray[np.float64])
assert_type(flashbvh.pairs(baked_a, baked_b, poses[0]), npt.NDArray[np.int64])
assert_type(flashbvh.nearest_hit(baked_a, [0, 0, 0], [0, 0, 1], 5).hit, npt.NDArray[np.bool_])
assert_type(flashbvh.inside(baked_a, [[0, 0, 0]]), npt.NDArray[np.bool_])
contacts = flashbvh.first_contact(baked_a, baked_b, flashbvh.BodyMotion(poses, poses), within=0.1)
assert_type(contacts.is_free, npt.NDArray[np.bool_])
assert_type(contacts.pose, npt.NDArray[np.float64])
assert_type(flashbvh.BodyMotion.of_moves(poses[0], np.zeros((1, 10))), flashbvh.BodyMotion)

robot = Robot.from_urdf("arm.urdf", stop=0.01, pairs={("a", "b"): (0.1, 0.2)}, zones={"elbow": 0.1})
assert_type(robot.limits, npt.NDArray[np.float64])
assert_type(robot.matrix, Optional[list[flashbvh.MatrixRow]])
guard = Guard(robot)
answer = guard.update([0.0] * len(robot.joint_names))
assert_type(answer, GuardAnswer)
assert_type(answer.verdict, Verdict)
assert_type(guard.check(np.zeros((5, 6)), work=100).verdicts, npt.NDArray[np.uint8])
assert_type(Motion(robot).certify([0], [1]).is_free, bool)

manager = flashbvh.CollisionManager()
manager.add_object("a", a)
assert_type(manager.in_collision_internal(), bool)
assert_type(manager.in_collision_internal(return_names=True), tuple[bool, set[tuple[str, str]]])
assert_type(manager.in_collision_single(b, return_names=True), tuple[bool, set[str]])
assert_type(manager.min_distance_internal(), float)
assert_type(manager.min_distance_other(manager, return_names=True), tuple[float, tuple[str, str]])
try:
    Baked.load(b"")
except flashbvh.Error as error:
    assert_type(error, flashbvh.Error)
