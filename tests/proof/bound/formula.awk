# The most instructions of a run, as flashbvh::most_instructions(): lib/docs/bounded_time.md.
# cost["visit-rotated"] and so on are what prove.py wrote; kind: translated or rotated.
function most_instructions(cost, kind, visits, leaf_pairs, pairs, ascents, siblings, others) {
  return cost["run-" kind] + ascents * cost["ascent-" kind] + \
    visits * (cost["visit-" kind] + others * cost["leaf-triangle"]) + \
    leaf_pairs * cost["leaf-pair-" kind] + pairs * cost["triangle-pair"] + \
    (leaf_pairs + 1) * siblings * cost["later-sibling-" kind]
}
