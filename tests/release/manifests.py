"""manifests.py PACKAGES PAGE    Each package's manifest keeps its readers' rules: Arduino's library specification and
arduino-lint, PlatformIO's and ESP-IDF's manifests, Zephyr's modules, CMSIS-Pack. The rules are written here as facts,
so the test needs none of their tools. The packages contain all that PAGE, lib/docs/packages.md, names, and PAGE has at
most ten lines per package."""
from __future__ import annotations

import json
import os
import re
import sys
import tempfile
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

import jsonschema
import kconfiglib
import yaml
from pykwalify.core import Core

SEMVER = r"^(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)$"
URL = r"^https?://[^ ]+$"
CATEGORIES = ["Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing",
              "Data Storage", "Data Processing", "Other"]
TEXT = {"type": "string", "minLength": 1}


def an_object(properties: dict, required: str) -> dict:
    """Requires the properties in `required`, allows the other ones, and no more."""
    return {"type": "object", "properties": properties, "required": required.split(),
            "additionalProperties": False}


ARDUINO = an_object({
    "name": {"type": "string", "pattern": r"^[a-zA-Z0-9][a-zA-Z0-9 _.\-]{0,62}$",
             "not": {"pattern": "(?i)arduino"}},
    "version": {"type": "string", "pattern": SEMVER},
    "author": TEXT, "maintainer": TEXT,
    "sentence": {"type": "string", "minLength": 1, "pattern": r"^[A-Z].*\.$"},
    # The IDE shows this text after the sentence.
    "paragraph": TEXT,
    "category": {"enum": CATEGORIES},
    "url": {"type": "string", "pattern": URL},
    "architectures": {"type": "string", "pattern": r"^(\*|[a-z0-9_]+(,[a-z0-9_]+)*)$"},
    "includes": TEXT, "license": TEXT,
}, "name version author maintainer sentence paragraph category url architectures")

PLATFORMIO = an_object({
    "name": {"type": "string", "pattern": r"^[^:;/,@<>]{1,100}$"},
    "version": {"type": "string", "pattern": SEMVER},
    "description": {"type": "string", "minLength": 1, "maxLength": 255},
    "keywords": {"type": "array", "minItems": 1, "uniqueItems": True,
                 "items": {"type": "string", "pattern": r"^[a-z0-9+\-]{1,50}$"}},
    "license": {"enum": ["MIT"]},
    "homepage": {"type": "string", "pattern": URL},
    "authors": {"type": "array", "minItems": 1, "items": an_object(
        {"name": TEXT, "email": {"type": "string", "pattern": "@"}, "maintainer": {"type": "boolean"}}, "name")},
    "frameworks": TEXT, "platforms": TEXT,
    "headers": {"type": "array", "items": TEXT},
    "build": an_object({"srcDir": TEXT, "includeDir": TEXT, "flags": TEXT,
                        "unflags": {"type": "array", "items": TEXT}}, "srcDir includeDir flags"),
}, "name version description keywords license authors frameworks platforms build")

ESP_IDF = an_object({
    "version": {"type": "string", "pattern": SEMVER},
    "description": TEXT, "license": TEXT,
    "url": {"type": "string", "pattern": URL},
    "tags": {"type": "array", "items": {"type": "string", "pattern": r"^[A-Za-z0-9_\-]{3,32}$"}},
    "dependencies": an_object({"idf": {"type": "string", "pattern": r"^>=\d+\.\d+$"}}, "idf"),
}, "version description url")

ZEPHYR = {"type": "map", "mapping": {
    "name": {"required": True, "type": "str"},
    "build": {"required": True, "type": "map", "mapping": {
        "cmake": {"required": True, "type": "str"}, "kconfig": {"required": True, "type": "str"}}}}}

# The part of Zephyr's Kconfig on which the module's depends.
KCONFIG = """mainmenu "test"
config CPP
\tbool "C++"
choice STD_CPP
\tprompt "standard"
\tdepends on CPP
\tdefault STD_CPP11
config STD_CPP98
\tbool "98"
config STD_CPP11
\tbool "11"
config STD_CPP14
\tbool "14"
config STD_CPP17
\tbool "17"
config STD_CPP20
\tbool "20"
endchoice
source "%s"
"""


def require(condition: bool, what: str) -> None:
    if not condition:
        sys.exit(f"manifests: {what}")


def check_arduino(folder: Path) -> str:
    lines = (folder / "library.properties").read_text().splitlines()
    properties = dict(line.split("=", 1) for line in lines)
    require(len(properties) == len(lines), "library.properties: a key stands twice")
    jsonschema.validate(properties, ARDUINO)
    for header in properties["includes"].split(","):
        require((folder / "src" / header).is_file(), f"Arduino: no {header}")
    for example in (folder / "examples").iterdir():
        require((example / f"{example.name}.ino").is_file(), f"Arduino: {example.name} has no sketch")
    for path in folder.rglob("*"):
        require(re.fullmatch(r"[A-Za-z0-9_.\-]+", path.name) is not None, f"Arduino: {path.name}")
    return properties["version"]


def check_platformio(folder: Path) -> str:
    manifest = json.loads((folder / "library.json").read_text())
    jsonschema.validate(manifest, PLATFORMIO)
    require("c++17" in manifest["build"]["flags"].replace("gnu++", "c++"), "PlatformIO: not C++17")
    for header in manifest["headers"]:
        require((folder / manifest["build"]["includeDir"] / header).is_file(), f"PlatformIO: no {header}")
    return manifest["version"]


def check_esp_idf(folder: Path) -> str:
    manifest = yaml.safe_load((folder / "idf_component.yml").read_text())
    jsonschema.validate(manifest, ESP_IDF)
    return manifest["version"]


def check_zephyr(folder: Path) -> None:
    module = folder / "zephyr/module.yml"
    Core(source_data=yaml.safe_load(module.read_text()), schema_data=ZEPHYR).validate()
    build = yaml.safe_load(module.read_text())["build"]
    require((folder / build["cmake"] / "CMakeLists.txt").is_file(), "Zephyr: no CMakeLists.txt")
    with tempfile.NamedTemporaryFile("w", suffix="Kconfig") as top:
        top.write(KCONFIG % (folder / build["kconfig"]))
        top.flush()
        os.environ["KCONFIG_WARN_UNDEF"] = "y"
        config = kconfiglib.Kconfig(top.name, warn_to_stderr=False)
    require(not config.warnings, f"Kconfig: {config.warnings}")
    flashbvh, robot, symbols = config.syms["FLASHBVH"], config.syms["FLASHBVH_ROBOT"], config.syms

    def values(standard: str | None) -> tuple[str, str]:
        config.unset_values()
        symbols["CPP"].set_value("y" if standard else "n")
        if standard:
            symbols[standard].set_value("y")
        flashbvh.set_value("y")
        robot.set_value("y")
        return flashbvh.str_value, robot.str_value

    for standard, value in ((None, "n"), ("STD_CPP11", "n"), ("STD_CPP14", "n"), ("STD_CPP17", "y"),
                            ("STD_CPP20", "y")):
        require(values(standard) == (value, value), f"Kconfig: with {standard} not {value}")
    flashbvh.set_value("n")
    require(robot.str_value == "n", "Kconfig: the robot's layer without the library")


def check_cmsis(folder: Path) -> str:
    description, = folder.glob("*.pdsc")
    package = xml.parse(description).getroot()
    listed = [file.get("name") for file in package.iter("file")]
    require(len(listed) == len(set(listed)), "CMSIS: a file stands twice")
    for name in [*listed, package.findtext("license")]:
        require((folder / name).exists(), f"CMSIS: no {name}")
    sources = {path.relative_to(folder).as_posix() for path in folder.glob("src/**/*.cpp")}
    require(sources == {name for name in listed if name.endswith(".cpp")}, "CMSIS: other sources")
    version = package.find("releases/release").get("version")
    require({component.get("Cversion") for component in package.iter("component")} == {version},
            "CMSIS: versions differ")
    conditions = {condition.get("id") for condition in package.iter("condition")}
    require({c.get("condition") for c in package.iter("component")} - {None} <= conditions,
            "CMSIS: an unknown condition")
    archive = folder.parent / f"{package.findtext('vendor')}.{package.findtext('name')}.{version}.pack"
    require(description.stem == f"{package.findtext('vendor')}.{package.findtext('name')}", "CMSIS: names")
    with zipfile.ZipFile(archive) as packed:
        require(set(packed.namelist()) == {p.relative_to(folder).as_posix() for p in folder.rglob("*")
                                           if p.is_file()}, "CMSIS: the archive holds something else")
    return version


def check_page(packages: Path, page: str) -> None:
    for title, text in re.findall(r"^## (.+)\n((?:(?!## ).*\n)*)", page, re.M):
        count = sum(line != "" and not line.startswith("```") for line in text.splitlines())
        require(count <= 10, f"the page: {count} lines of {title}")
    named = re.findall(r"`((?:arduino|platformio|zephyr|esp-idf|cmsis|amalgamation|debian|python|npm|archives)(?:/[^`*]+)?)`", page)
    for name in named:
        # Debian's packages are not always made.
        is_made = (packages / name.split("/")[0]).exists()
        require((packages / name).exists() or not is_made, f"the page: no {name}")
    folders = {name.split("/")[0] for name in named}
    require(folders >= {path.name for path in packages.iterdir()}, f"the page: {folders} alone")
    options = (packages / "zephyr/flashbvh/zephyr/Kconfig").read_text()
    for option in re.findall(r"CONFIG_(FLASHBVH\w*)=y", page):
        require(f"config {option}\n" in options, f"the page: no option {option}")
    pack = xml.parse(next((packages / "cmsis/flashbvh").glob("*.pdsc"))).getroot()
    components = {f"{c.get('Cclass')}:{c.get('Cgroup')}" for c in pack.iter("component")}
    shown = set(re.findall(r"- component: (\S+)", page))
    require(shown == components, f"the page: components {shown}, not {components}")


def main(packages: Path, page: Path) -> None:
    versions = {check_arduino(packages / "arduino/flashbvh"), check_platformio(packages / "platformio/flashbvh"),
                check_esp_idf(packages / "esp-idf/flashbvh"), check_cmsis(packages / "cmsis/flashbvh")}
    check_zephyr(packages / "zephyr/flashbvh")
    require(len(versions) == 1, f"versions differ: {versions}")
    check_page(packages, page.read_text())


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]))
