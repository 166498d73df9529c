#!/usr/bin/env python3
"""npm.py: prints how many KB the npm package's module takes, NPM_MODULE: the file, and compressed."""
import gzip
import os
from pathlib import Path

module = Path(os.environ["NPM_MODULE"]).read_bytes()
for name, size in ("file", len(module)), ("compressed", len(gzip.compress(module, 9, mtime=0))):
    print(f"count npm.{name} {size / 1000:.0f}")
