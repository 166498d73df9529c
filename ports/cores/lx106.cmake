set(FLASHBVH_CORE "Xtensa LX106")
set(FLASHBVH_CPU_FLAGS "")
# No figures, budgets or proofs: answers alone are tested.
set(FLASHBVH_IS_MEASURED FALSE)
