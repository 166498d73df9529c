"""readme.py: holds the README's table of costs equal to tests/figures/budgets.csv, on a Cortex-M4F."""
import csv
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Each function's flash, RAM, stack and instructions.
ROWS = {
    "PairQuery": ("code.find_pairs_once.Os", "object.PairQuery", "stack.rigid_query.graph", "kr5.rotated.close.query.mean"),
    "intersects": ("code.intersects_once.Os", None, "stack.intersects_once.graph", "kr5.rotated.intersecting.first.mean"),
    "distance": ("code.distance_once.Os", None, "stack.distance_once.graph", "distance.rotated.close.hint.mean"),
    "nearest_hit": ("code.nearest_hit_once.Os", None, "stack.nearest_hit_once.graph", "ray.cold.aimed.mean"),
    "Guard": ("code.guard_update.Os", "guard.state", "stack.guard_update.graph", "guard.half.mean"),
    "open_image": ("code.open_an_image.Os", None, "stack.open_an_image.graph", "kr5.open_image"),
}
FORMS = (lambda n: f"{n / 1000:.1f} KB", lambda n: f"{n:,} B", lambda n: f"{n:,} B",
         lambda n: f"{round(n, 2 - len(str(n))):,}")  # two digits

with open(ROOT / "tests/figures/budgets.csv") as file:
    figures = {row["figure"]: row["Cortex-M4F"] for row in csv.DictReader(file)}
page = (ROOT / "README.md").read_text()
for function, names in ROWS.items():
    cells = [form(int(figures[name])) if name else "-" for form, name in zip(FORMS, names)]
    if not re.search(re.escape(f"(`{function}`) | {' | '.join(cells)} |"), page):
        sys.exit(f"README.md: no row (`{function}`) | {' | '.join(cells)} |")
