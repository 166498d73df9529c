"""The most instructions of a run, like flashbvh::most_instructions(): lib/docs/bounded_time.md.

cost: the values of prove.py, by name; leaf_size: of the larger leaves."""


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
