"""poses.py COUNT SEED REACH: prints poses, one a line, of 17 digits: a unit quaternion of any direction, every
fourth about an axis by whole quarters, and a translation within +-REACH."""
import random
import sys
from math import sqrt


def matrix(w, x, y, z):
    return (w * w + x * x - y * y - z * z, 2 * (x * y - z * w), 2 * (x * z + y * w),
            2 * (x * y + z * w), w * w - x * x + y * y - z * z, 2 * (y * z - x * w),
            2 * (x * z - y * w), 2 * (y * z + x * w), w * w - x * x - y * y + z * z)


def any_poses(count, any_of, reach):
    for n in range(count):
        if n % 4 == 0:
            turned = [1, 0, 0, 0]
            turned[any_of.randint(1, 3)] = any_of.randint(-1, 1)
        else:
            turned = [any_of.uniform(-1, 1) for _ in range(4)]
        length = sqrt(sum(part * part for part in turned))
        place = [any_of.uniform(-reach, reach) for _ in range(3)]
        yield " ".join(f"{entry:.17g}" for entry in (*matrix(*(part / length for part in turned)), *place))


if __name__ == "__main__":
    print("\n".join(any_poses(int(sys.argv[1]), random.Random(int(sys.argv[2])), float(sys.argv[3]))))
