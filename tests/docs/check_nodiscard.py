#!/usr/bin/env python3
# check_nodiscard.py CLANG INCLUDE_FOLDER    Checks that dropping a public function's status, verdict or outcome gives
# a warning: each function that returns one, or a struct with one, is marked, or its type is. The functions are taken
# from clang's syntax trees of all public headers, C++ and C.
import json
import pathlib
import re
import subprocess
import sys
import tempfile

# Results that may be dropped, since the error stays in the object: in a pose or a motion, with which each query then
# ends; in a query, a guard or a workcell, whose later calls report it.
STICKY = {"flashbvh_" + name for name in (
    "pose_relative", "pose_of_matrix", "pose_rigid", "body_motion_between", "first_contact_start", "query_start",
    "clearance_start", "guard_init", "motion_init", "motion_start", "workcell_init")}
# A query's state, which no function returns.
MEMORY = {"MotionCore", "MotionStateOf"}
CARRIED_FIELDS = {"status", "verdict", "outcome"}
SEEDS = {"Status", "Verdict", "MotionOutcome", "ContactOutcome"}


def tree_of(clang, folder, names, language):
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as source:
        source.write("".join(f'#include "{name}"\n' for name in names))
        source.flush()
        out = subprocess.run(
            [clang, "-x", *language, "-I", str(folder), "-fsyntax-only", "-Xclang", "-ast-dump=json",
             source.name], check=True, stdout=subprocess.PIPE).stdout
    return json.loads(out)


def is_marked(node):
    return any(child.get("kind") == "WarnUnusedResultAttr" for child in node.get("inner", []))


def declarations(node, scope=(), access="public"):
    """All public declarations in any template or namespace, except detail's."""
    for child in node.get("inner", []):
        kind, name = child.get("kind"), child.get("name", "")
        if kind == "AccessSpecDecl":
            access = child["access"]
        elif kind == "NamespaceDecl":
            if name not in ("detail", "std", ""):
                yield from declarations(child, scope + (name,))
        elif kind in ("LinkageSpecDecl", "ClassTemplateDecl", "FunctionTemplateDecl"):
            if access == "public":
                yield from declarations(child, scope)
        elif access == "public" and not child.get("isImplicit"):
            yield child, scope
            if kind in ("CXXRecordDecl", "ClassTemplatePartialSpecializationDecl", "RecordDecl"):
                start = "private" if child.get("tagUsed") == "class" else "public"
                yield from declarations(child, scope + (name,), start)


def base_name(written):
    """A type's name without qualifiers, scopes and template arguments."""
    plain = re.sub(r"<.*>", "", written)
    plain = re.sub(r"\b(const|volatile|struct|enum|class|typename)\b|&&?", "", plain)
    return plain.strip().split("::")[-1].strip()


def returned_type(function):
    return base_name(function["type"]["qualType"].split("(")[0])


def is_pointer(function):
    return "*" in function["type"]["qualType"].split("(")[0]


def aliases_in(found):
    return {node["name"]: base_name(node["type"]["qualType"]) for node, _ in found
            if node["kind"] == "TypeAliasDecl"}


def carriers_of(found, seeds):
    """Names of types with a public field that is a status, or of such a type."""
    fields = {alias: [(None, kind)] for alias, kind in aliases_in(found).items()}
    for node, scope in found:
        if node["kind"] == "FieldDecl" and scope:
            kind = base_name(node["type"]["qualType"])
            fields.setdefault(scope[-1], []).append((node.get("name"), kind))
    carriers = set(seeds)
    while True:
        more = {owner for owner, of in fields.items()
                if any(kind in carriers or (name in CARRIED_FIELDS and kind == "uint8_t")
                       for name, kind in of)}
        if more <= carriers:
            return carriers
        carriers |= more


def check(found, carriers, say):
    marked = {node["name"] for node, _ in found
              if "name" in node and is_marked(node) and "Decl" in node["kind"]
              and node["kind"] not in ("FunctionDecl", "CXXMethodDecl")}
    marked |= {alias for alias, kind in aliases_in(found).items() if kind in marked}
    functions = {}
    for node, scope in found:
        if node["kind"] in ("FunctionDecl", "CXXMethodDecl") and not is_pointer(node):
            functions.setdefault(("::".join(scope + (node["name"],))), []).append(node)
    seen = 0
    for name, declared in sorted(functions.items()):
        kind = returned_type(declared[0])
        if kind not in carriers:
            continue
        seen += 1
        is_safe = kind in marked or all(is_marked(node) for node in declared)
        if is_safe and name in STICKY:
            say(f"{name}() is marked, and no exception: take it from the list")
        elif not is_safe and name not in STICKY:
            say(f"{name}() returns {kind}, which can be dropped: mark it")
    return seen, marked


def main():
    clang, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    headers = [path for path in folder.rglob("*") if path.suffix in (".h", ".hpp")
               and "detail" not in path.parts]
    names = {suffix: sorted(str(path.relative_to(folder)) for path in headers
                            if path.suffix == suffix) for suffix in (".h", ".hpp")}
    wrong = []
    cpp = list(declarations(tree_of(clang, folder, names[".hpp"], ["c++", "-std=c++17"])))
    carriers = carriers_of(cpp, SEEDS)
    seen, marked = check(cpp, carriers, wrong.append)
    for name in sorted(carriers - marked - MEMORY):
        wrong.append(f"{name} carries a status and can be dropped: mark it [[nodiscard]]")
    c = list(declarations(tree_of(clang, folder, names[".h"], ["c", "-std=c99"])))
    in_c = carriers_of(c, {node["name"] for node, _ in c if node["kind"] == "TypedefDecl" and
                           re.fullmatch("flashbvh_(status|verdict|motion_outcome)", node["name"])})
    seen_in_c, _ = check(c, in_c, wrong.append)
    print(f"{seen} functions of C++ and {seen_in_c} of C return a status, {len(carriers)} types and "
          f"{len(in_c)} carry one")
    if seen < 40 or seen_in_c < 30 or not {"GuardAnswer", "PairDetail"} <= carriers:
        wrong.append("too few were found: this script no longer reads the tree")
    print("\n".join(wrong))
    sys.exit(1 if wrong else 0)


main()
