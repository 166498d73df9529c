set(FLASHBVH_CORE LX106)
set(FLASHBVH_CPU_FLAGS "")
# No budgets or proofs; its figures are not on the page.
set(FLASHBVH_IS_MEASURED FALSE)
