# The most instructions of a run, as flashbvh::most_instructions(): lib/docs/bounded_time.md.
# cost["start"] and so on are what prove.py wrote; leaf_size: of the larger leaves.
function most_instructions(cost, depths, siblings, leaf_size, work,    step, unit) {
  step = leaf_size + 8 > 32 ? leaf_size + 8 : 32
  unit = cost["work"] + int((siblings * cost["later-sibling"] + 31) / 32)
  return cost["start"] + depths * cost["ascent"] + siblings * cost["later-sibling"] + \
    (leaf_size - 1) * cost["leaf-triangle"] + (work + step - 1) * unit
}
# The same of a mesh against itself, `depths` being twice its own.
function most_of_itself(cost, depths, siblings, leaf_size, work,    passed) {
  passed = (siblings + 1) * cost["later-sibling"]
  return cost["start"] + depths * (cost["ascent"] + passed) + siblings * cost["later-sibling"] + \
    (leaf_size - 1) * cost["leaf-triangle"] + (work + 31) * (cost["work"] + passed)
}
