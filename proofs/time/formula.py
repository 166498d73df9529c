"""The most instructions of a run, like flashbvh::most_instructions(): lib/docs/bounded_time.md.

cost: the values of prove.py and guard_prove.py, by name; leaf_size: of the larger leaves."""

# Units of work that guard_prove.py compares with work.hpp.
PAIR, PLACED, EXACT, POSE, AIM, LEVER, NEAR = 1, 4, 24, 16, 56, 1, 8
# The least work before the measurement of a witness that is nearer than the limit.
NEARER = PAIR + PLACED + EXACT + AIM
# The most that a period overdraws, without the joints' levers.
OVERDRAWN = POSE + AIM - 1


def most_instructions(cost, depths, siblings, leaf_size, work):
    step = max(leaf_size + 8, 32)
    unit = cost["work"] + (siblings * cost["later-sibling"] + 31) // 32
    return (cost["start"] + depths * cost["ascent"] + siblings * cost["later-sibling"]
            + (leaf_size - 1) * cost["leaf-triangle"] + (work + step - 1) * unit)


def most_of_itself(cost, depths, siblings, leaf_size, work):
    """The bound for a mesh against itself; `depths` is twice its depth."""
    passed = (siblings + 1) * cost["later-sibling"]
    return (cost["start"] + depths * (cost["ascent"] + passed) + siblings * cost["later-sibling"]
            + (leaf_size - 1) * cost["leaf-triangle"] + (work + 31) * (cost["work"] + passed))


def measured_pairs(pairs, work):
    """The largest number of pairs that a period begins to measure: each costs POSE, and none is measured twice."""
    return min(pairs, (work + POSE - 1) // POSE)


def most_of_period(cost, joints, pairs, between, tabled, depth, leaf_size, work):
    """The bound of a guard's period. between: joints between the links of all pairs; tabled: pairs with one or two such
    joints; depth: the sum for two meshes."""
    of = {name.removeprefix("guard-"): value for name, value in cost.items()}
    measured = measured_pairs(pairs, work)
    turns = joints + pairs * joints
    look = (pairs * of["pair"] + between * of["between"] + turns * of["turn"]
            + tabled * 2 * (pairs + tabled + 2) * of["table"])
    around = (6 * pairs + 2 * joints) * of["turn"] + 2 * joints * of["between"]
    unit = of["work"] + (joints * of["between"] + pairs * of["turn"] + NEARER - 1) // NEARER
    return (of["start"] + joints * (of["joint"] + joints * of["turn"]) + (measured + 2) * look
            + measured * of["measure"] + (measured + 1) * around + depth * of["ascent"]
            + 4 * leaf_size * leaf_size * of["within"] + (work + OVERDRAWN + joints) * unit)
