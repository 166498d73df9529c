"""Builds the package from a checkout: CMake makes the module, setuptools the wheel.

Offline, with Debian's packages: pip install --no-build-isolation ./tools/python
"""
import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WORK = ROOT / "build/pip"  # keeps build files out of the sources


def version():
    text = (ROOT / "lib/include/flashbvh/version.hpp").read_text()
    return ".".join(re.findall(r"#define FLASHBVH_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text))


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        build = Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DFLASHBVH_BUILD_PYTHON=ON",
                        "-DFLASHBVH_BUILD_TESTS=OFF", f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "-j", str(os.cpu_count()), "--target", "flashbvh_python"],
                       check=True)
        module, = (build / "python/flashbvh").glob("_native.*.so")
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(module), str(target))


WORK.mkdir(parents=True, exist_ok=True)
setup(name="flashbvh", version=version(), license="MIT", python_requires=">=3.9", install_requires=["numpy"],
      description="Exact collision and distance of triangle meshes, and guards of robots, as on microcontrollers",
      packages=["flashbvh"],
      package_dir={"flashbvh": os.path.relpath(ROOT / "tools/python/flashbvh", HERE)},
      package_data={"flashbvh": ["py.typed", "*.pyi"]},
      options={"build": {"build_base": str(WORK)}, "egg_info": {"egg_base": str(WORK)}},
      ext_modules=[Extension("flashbvh._native", [])], cmdclass={"build_ext": BuildByCMake})
