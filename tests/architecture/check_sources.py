#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fails on sources that break the layer rule or the house rules of docs/developer/house-rules.md.

Usage: check_sources.py REPOSITORY
"""
import pathlib
import re
import sys

# The packages whose headers a package may include, beside its own.
ALLOWED = {
    "core": set(),
    "multigrid": {"core"},
    "fem": {"core"},
    "mesh": {"core", "fem"},
    "meshgen": {"core", "fem", "mesh"},
    "io": {"core", "fem", "mesh"},
    "search": {"core", "fem", "mesh"},
    "audit": {"core", "fem", "mesh"},
    "contact": {"core", "fem", "mesh", "search"},
    "solid": {"core", "fem", "mesh"},
    "unknowns": {"core", "mesh"},
    "rigid": {"core", "mesh", "unknowns"},
    "assembly": {"core", "mesh", "unknowns", "rigid"},
    "solver": {"core", "mesh", "multigrid", "assembly"},
    "scene": {"core", "fem", "mesh", "search", "audit", "io", "contact", "solid", "unknowns", "rigid", "assembly",
              "solver"},
    "translation": {"core"},
    "abaqus": {"core", "fem", "mesh", "translation"},
    "febio": {"core", "fem", "mesh", "translation"},
    "gmsh": {"core", "fem", "mesh", "translation"},
    "deck": {"core"},  # and everybody's options.hpp
}
CPP_SUFFIXES = {".hpp", ".cpp"}
SCRIPT_SUFFIXES = {".py", ".cmake", ".sh"}
LONGEST_FUNCTION = 60
MOST_DATA, MOST_FUNCTIONS = 25, 40  # members of a class
# Records of what a user or a host may say: one member for each key, no state that code has to keep consistent.
RECORDS = {"ContactOptions", "Settings"}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# Comments and literals, in the order in which the first one that starts wins.
HIDDEN = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"([^()\\ ]*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
FORBIDDEN = {
    r"\bMPI_COMM_WORLD\b": "takes a communicator from its caller",
    r"\bstd\s*::\s*(cout|cerr|clog)\b": "writes through the log that its caller passed in",
    r"\b(f|v|vf)?printf\s*\(|\bputs\s*\(|\bfmt\s*::\s*print\s*\(": "writes through the log that its caller passed in",
    r"\b(_|_E|quick_)?exit\s*\(|\babort\s*\(|\bMPI_Abort\b": "throws; ending the process is the "
                                                              "program's choice",
}
OLD_WORDS = re.compile("ma" "ster|sla" "ve", re.IGNORECASE)
LICENSE = "SPDX-License-Identifier: BSD-3-Clause"


def blank(match):
    """Same length and lines, no content; digit separators (1'000) are left as they are."""
    text = match.group(0)
    before = match.string[match.start() - 1:match.start()]
    if text.startswith("'") and (before.isalnum() or before == "_"):
        return text
    return re.sub(r"[^\n]", " ", text)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def files_below(folder, suffixes, names=()):
    for path in sorted(folder.rglob("*")):
        hidden = any(part == "__pycache__" for part in path.parts)
        if path.is_file() and not hidden and (path.suffix in suffixes or path.name in names):
            yield path


def edge_error(package, header, from_options):
    """Why `package` must not include "abut/..." `header`; None when it may."""
    parts = header.split("/")
    if len(parts) < 3 or parts[1] not in ALLOWED:
        return f"{header} is no header of a package"
    target = parts[1]
    is_options = parts[2:] == ["options.hpp"]
    if from_options and target != "core" and not is_options:
        return f"options.hpp includes {header}: options know core and other options only"
    if target == package or target in ALLOWED[package] or (package == "deck" and is_options):
        return None
    return f"{package} includes {header}: {package} may know {sorted(ALLOWED[package]) or 'nothing'}"


def include_errors(root, path, package, text):
    for match in INCLUDE.finditer(text):
        header = match.group(2)
        where = f"{path.relative_to(root)}:{line_of(text, match.start())}"
        if header.endswith("exodusII.h") and package != "io":
            yield f"{where}: only io includes exodusII.h"
        if header.startswith("abut/"):
            if package is not None:
                error = edge_error(package, header, path.name == "options.hpp")
                if error:
                    yield f"{where}: {error}"
        elif match.group(1) == '"':
            if ".." in header or not any((folder / header).is_file() for folder in (
                    path.parent, root / "packages" / str(package) / "src")):
                yield f'{where}: "{header}" is neither abut/... nor beside this file nor below src/'


def link_errors(root, package):
    """CMake must not offer what the includes may not use."""
    path = root / "packages" / package / "CMakeLists.txt"
    if not path.is_file():
        return
    text = re.sub(r"#[^\n]*", "", path.read_text())
    for target in re.findall(r"\babut(?:::|_)(\w+)", text):
        if target in ALLOWED and target != package and target not in ALLOWED[package]:
            yield f"{path.relative_to(root)}: {package} links {target}"


def package_errors(root):
    packages = root / "packages"
    for folder in sorted(p for p in packages.iterdir() if p.is_dir() and p.name != "cmake"):
        package = folder.name
        if package not in ALLOWED:
            yield f"packages/{package}: give it a row in {pathlib.Path(__file__).name}"
            continue
        yield from link_errors(root, package)
        for path in files_below(folder, CPP_SUFFIXES):
            text = path.read_text()
            yield from include_errors(root, path, package, text)
            code = HIDDEN.sub(blank, text)
            for pattern, reason in FORBIDDEN.items():
                for match in re.finditer(pattern, code):
                    yield (f"{path.relative_to(root)}:{line_of(code, match.start())}: "
                           f"{match.group(0).strip()}: a package {reason}")
    for path in files_below(root / "apps", CPP_SUFFIXES):
        yield from include_errors(root, path, None, path.read_text())


def text_errors(root):
    for top in ("packages", "apps", "tests", "input"):
        for path in files_below(root / top, CPP_SUFFIXES | SCRIPT_SUFFIXES, {"CMakeLists.txt"}):
            name = path.relative_to(root)
            text = path.read_text()
            if LICENSE not in "\n".join(text.split("\n", 2)[:2]):
                yield f"{name}:1: no line '{LICENSE}'"
            if path.suffix == ".hpp" and "#pragma once" not in text:
                yield f"{name}:1: no #pragma once"
            for match in OLD_WORDS.finditer(text):
                yield (f"{name}:{line_of(text, match.start())}: '{match.group(0)}': "
                       "say primary and secondary")


def function_lengths(text):
    """(first line, length) of functions, by the layout that clang-format gives them."""
    opener = re.compile(r"( {0,2})(?!(?:if|for|while|switch|else|do|try|catch|namespace|class|struct|"
                        r"enum|union|extern|return)\b)[A-Za-z~].*\(")
    start = end = None
    for number, line in enumerate(text.split("\n"), 1):
        if end is not None:  # inside a body
            if line.startswith(end):
                yield start, number - start + 1
                start = end = None
            continue
        match = opener.match(line)
        if start is None and match:
            start, indent = number, match.group(1)
        if start is not None:
            if line.endswith("{"):
                end = indent + "}"
            elif line.endswith((";", "}")):
                start = None


CLASS = re.compile(r"\b(?:class|struct)\s+(?:\[\[\w+\]\]\s*)?(\w+)(?:\s+final)?\s*(?::[^;{]*)?\{")
NO_MEMBER = re.compile(r"(?:using|typedef|friend|enum|static_assert|class|struct|union)\b")


def closing(code, start):
    """Position of the brace that closes the one at `start`."""
    depth = 0
    for position in range(start, len(code)):
        depth += {"{": 1, "}": -1}.get(code[position], 0)
        if depth == 0:
            return position
    return len(code)


def without_arguments(text):
    """The text without what stands in angle brackets: types such as function<void(int)>."""
    while True:
        shorter = re.sub(r"(\w\s*)<[^<>;{}]*>", r"\1", text)
        if shorter == text:
            return text
        text = shorter


def statements(body):
    """Declarations of a class body, initialisers and function bodies left out."""
    flat = ""
    while body:
        brace = body.find("{")
        if brace < 0:
            flat += body
            break
        end = closing(body, brace)
        before = re.split(r"[;}]", flat + body[:brace])[-1]
        outside = re.sub(r"\([^()]*\)", "", before)  # default arguments are none
        is_initialiser = "=" in outside or "(" not in without_arguments(before)
        nested = NO_MEMBER.match(re.sub(r"^(?:\s|public:|private:|protected:|template)*", "",
                                        without_arguments(before).strip()))
        flat += body[:brace] + ("" if is_initialiser or nested else ";")
        body = body[end + 1:]
    for statement in flat.split(";"):
        statement = re.sub(r"\b(?:public|private|protected)\s*:(?!:)", "", statement)
        statement = re.sub(r"^\s*template\s*", "", without_arguments(statement)).strip()
        statement = re.sub(r"^template\s+", "", statement)
        if statement and not NO_MEMBER.match(statement):
            yield statement


def member_counts(code):
    """(name, position, data members, member functions) of each class; nested ones by themselves."""
    for match in CLASS.finditer(code):
        if re.search(r"\benum\s+$", code[:match.start()][-8:]):
            continue
        brace = match.end() - 1
        data = functions = 0
        for statement in statements(code[brace + 1:closing(code, brace)]):
            head = statement.split("=", 1)[0]
            if "(" in head or "operator" in statement:
                functions += 1
            elif not head.startswith("static "):
                data += 1 + re.sub(r"=[^,]*", "", statement).count(",")
        yield match.group(1), match.start(), data, functions


def class_errors(root):
    for top in ("packages", "apps"):
        for path in files_below(root / top, CPP_SUFFIXES):
            code = HIDDEN.sub(blank, path.read_text())
            for name, position, data, functions in member_counts(code):
                where = f"{path.relative_to(root)}:{line_of(code, position)}"
                if data > MOST_DATA and name not in RECORDS:
                    yield f"{where}: {name} has {data} data members"
                if functions > MOST_FUNCTIONS:
                    yield f"{where}: {name} has {functions} member functions"


KERNEL_FORBIDDEN = {
    r"\bstd\s*::\s*(vector|function|map|string|unique_ptr|shared_ptr)\b": "kernels are device code",
    r"\bdual_\w*": "kernels know sites, not spaces",
}
LABELLED = re.compile(r'\bparallel_(?:for|reduce|scan)\(\s*"(?!abut::)')


def kernel_errors(root):
    for path in files_below(root / "packages", CPP_SUFFIXES):
        name, text = path.relative_to(root), path.read_text()
        for match in LABELLED.finditer(text):
            yield f"{name}:{line_of(text, match.start())}: labels of kernels begin with abut::"
        if "kernels" not in path.parent.parts[len(root.parts):]:
            continue
        code = HIDDEN.sub(blank, text)
        for pattern, reason in KERNEL_FORBIDDEN.items():
            for match in re.finditer(pattern, code):
                yield f"{name}:{line_of(code, match.start())}: {match.group(0)}: {reason}"


def long_functions(root):
    """Warnings only: a long table or switch may be the clearest."""
    for top in ("packages", "apps"):
        for path in files_below(root / top, CPP_SUFFIXES):
            for start, length in function_lengths(path.read_text()):
                if length > LONGEST_FUNCTION:
                    yield f"{path.relative_to(root)}:{start}: function of {length} lines"


def errors(root):
    yield from package_errors(root)
    yield from text_errors(root)
    yield from class_errors(root)
    yield from kernel_errors(root)


def main(arguments):
    if len(arguments) != 1:
        sys.exit(__doc__)
    root = pathlib.Path(arguments[0]).resolve()
    if not (root / "packages" / "core").is_dir():
        sys.exit(f"{root} has no packages/core")
    for warning in long_functions(root):
        print(f"warning: {warning}")
    found = list(errors(root))
    for error in found:
        print(f"error: {error}")
    print(f"{len(found)} errors")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
