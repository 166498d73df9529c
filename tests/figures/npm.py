#!/usr/bin/env python3
"""npm.py: prints the sizes in KB of the modules of the npm package NPM_LIBRARY: each file, and compressed."""
import gzip
import os
from pathlib import Path

for name in "meshes", "robot":
    module = Path(os.environ["NPM_LIBRARY"], f"{name}.wasm").read_bytes()
    for way, size in ("file", len(module)), ("compressed", len(gzip.compress(module, 9, mtime=0))):
        print(f"count npm.{name}.{way} {size / 1000:.0f}")
