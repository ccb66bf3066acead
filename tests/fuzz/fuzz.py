# SPDX-License-Identifier: BSD-3-Clause
"""Import and check of files that are wrong in all ways: none may crash, hang or end in a defect.
usage: fuzz.py --kind feb|inp|msh|deck --count N --harness abut_fuzz_import [--seed S] [--keep FOLDER]

Mutants are made from the files of tests/fuzz/corpus, and decks from those of input/ too; the same seed
makes the same mutants. Each is a file with one to four changes, of its tree (elements, attributes, keys,
values) or of its text. Mutants at fault are kept in FOLDER.
"""
import argparse
import collections
import copy
import functools
import os
import pathlib
import random
import re
import resource
import selectors
import shutil
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml

import yaml

HERE = pathlib.Path(__file__).resolve().parent
INPUT = HERE.parents[1] / "input"
FINE = ("ok", "input_error", "solve_error")
BATCH = 250
MEMORY = 6 << 30  # of a harness without sanitizers, in bytes

NUMBERS = ["nan", "inf", "-inf", "1e308", "-1e308", "1e400", "1e-320", "0", "-0", "-1", "1", "2", "0.5",
           "-3.5", "1e9", "2147483647", "2147483648", "-2147483649", "9223372036854775807",
           "99999999999999999999999", "1e", "0x10", "1,2", "1 2", "", " ", ".", "--1", "1_000", "true",
           "null", "~", "[]", "{}", "0,0,0", "1:1000000000", "5:1", "1:9:0", "a"]
WORDS = ["", " ", "a", "a" * 70000, "name with spaces", "\u00e4\u4e2d\U0001f600", "%s%n%d", "../../x", "/dev/zero",
         "@surface:", "@elem_set:all", "@nothing:x", "*", "&a", "<", "]]>", "'", '"', "\\", "\n", "\t", "#", ":",
         "- ", "|", "!!binary x", "y", "off", "AUGLAG", "sliding-elastic", "hex8", "tet10", "rigid body", "0", "-1",
         "automatic", "unlimited", "none", "end", "end_of_step", "dual", "inclined_ray", "as_given"]
INP_WORDS = ["S1", "S6", "SPOS", "SNEG", "P4", "GRAV", "ENCASTRE", "GENERATE", "OP=NEW", "NLGEOM", "AMPLITUDE=A",
             "TYPE=NODE", "TYPE=C3D10", "TYPE=R3D4", "INSTANCE=I", "HARD", "TIED", "EXPONENTIAL", "ADJUST=1", "*STEP",
             "*INCLUDE, INPUT=/dev/zero", "*INCLUDE, INPUT=.", "*PART, NAME=P", "*INSTANCE, NAME=I, PART=P", "**"]
BYTES = [b"\xff", b"\xc3", b"\xed\xa0\x80", b"\x00", b"\xf0\x9f", b"\xef\xbb\xbf", b"\x1b", b"\r", b"\xfe\xff"]


class Random(random.Random):
    def span(self, length, most):
        """A piece [a, b) of so many items."""
        a = self.randrange(length + 1)
        return a, min(length, a + self.randrange(1, most + 1))


def number_in(text, rng):
    """The text with one of its numbers changed."""
    found = list(re.finditer(r"-?\d+\.?\d*(e[-+]?\d+)?", text))
    if not found:
        return rng.choice(NUMBERS)
    hit = rng.choice(found)
    return text[:hit.start()] + rng.choice(NUMBERS) + text[hit.end():]


# Text -----------------------------------------------------------------------------------------

def cut(data, rng):
    return data[:rng.randrange(len(data) + 1)]


def without_span(data, rng):
    a, b = rng.span(len(data), 40)
    return data[:a] + data[b:]


def doubled_span(data, rng):
    a, b = rng.span(len(data), 200)
    return data[:b] + data[a:b] + data[b:]


def moved_span(data, rng):
    a, b = rng.span(len(data), 60)
    rest = data[:a] + data[b:]
    at = rng.randrange(len(rest) + 1)
    return rest[:at] + data[a:b] + rest[at:]


def swapped_lines(data, rng):
    lines = data.split(b"\n")
    i, k = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[i], lines[k] = lines[k], lines[i]
    return b"\n".join(lines)


def foreign_bytes(data, rng):
    at = rng.randrange(len(data) + 1)
    return data[:at] + rng.choice(BYTES) * rng.choice([1, 1, 3]) + data[at:]


def flipped_bit(data, rng):
    if not data:
        return data
    at = rng.randrange(len(data))
    return data[:at] + bytes([data[at] ^ 1 << rng.randrange(8)]) + data[at + 1:]


def other_number(data, rng):
    return number_in(data.decode("latin-1"), rng).encode()


def swapped_words(data, rng):
    words = [m.span() for m in re.finditer(rb"\S+", data)]
    if len(words) < 2:
        return data
    (a, b), (c, d) = sorted(rng.sample(words, 2))
    return data[:a] + data[c:d] + data[b:c] + data[a:b] + data[d:]


def deep(data, rng):
    at = rng.randrange(len(data) + 1)
    opening, closing = rng.choice([(b"<a>", b"</a>"), (b"<Elements>", b""), (b"[", b"]"), (b"{a: ", b"}"),
                                   (b"(", b")"), (b"- ", b""), (b"<!--", b""), (b"&a [", b"]")])
    depth = rng.choice([10, 1000, 100000])
    return data[:at] + opening * depth + closing * depth + data[at:]


def anchors(data, rng):
    lines = data.split(b"\n")
    at = rng.randrange(len(lines))
    lines.insert(at, rng.choice([
        b"a: &a {b: *a}", b"a: *b", b"<<: *a", b"title: &t [*t, *t]", b"? [a]\n: b", b"--- a", b"...", b"%YAML 9.9",
        b"a: &a [x, x]\nb: &b [*a, *a, *a]\nc: &c [*b, *b, *b]\nmaterials: *c", b"? ? ? a", b"!!map a: b",
        b"<!DOCTYPE a [<!ENTITY x 'y'><!ENTITY z '&x;&x;'>]>", b"&z;&#0;&#xFFFFFFFF;", b"<![CDATA[", b"<?php ?>"]))
    return b"\n".join(lines)


def other_field(data, rng):
    """A field between commas becomes another one of the file, or a word that means something."""
    fields = [m.span() for m in re.finditer(rb"[^,\n=]+", data)]
    if len(fields) < 2:
        return data
    (a, b), (c, d) = rng.choice(fields), rng.choice(fields)
    new = rng.choice([data[c:d], data[c:d], rng.choice(INP_WORDS + NUMBERS).encode()])
    return data[:a] + new + data[b:]


def moved_card(data, rng):
    """A keyword with its lines, doubled, moved or taken away."""
    cards = re.split(rb"(?m)^(?=\*)", data)
    i, k = rng.randrange(len(cards)), rng.randrange(len(cards))
    card = cards[i]
    if rng.random() < 0.7:
        del cards[i]
    if rng.random() < 0.7:
        cards.insert(k, card)
    return b"".join(cards)


TEXT = [cut, without_span, doubled_span, moved_span, swapped_lines, foreign_bytes, flipped_bit, other_number,
        other_number, deep, anchors]


# XML ------------------------------------------------------------------------------------------

def mutate_element(root, rng):
    """One change of a tree; leaves and inner elements come up alike."""
    parents = [(p, i) for p in root.iter() for i in range(len(p))]
    if not parents:
        return
    tags = collections.defaultdict(list)
    for p, i in parents:
        tags[p[i].tag].append((p, i))
    parent, i = rng.choice(tags[rng.choice(sorted(tags))])
    element = parent[i]
    other, k = rng.choice(parents)
    change = rng.randrange(11)
    if change == 0:
        del parent[i]
    elif change == 1:
        parent.insert(rng.randrange(len(parent) + 1), copy.deepcopy(element))
    elif change == 2:
        parent[i], other[k] = copy.deepcopy(other[k]), copy.deepcopy(element)
    elif change == 3:
        other.insert(k, copy.deepcopy(element))
    elif change == 4:
        element.tag = rng.choice(sorted(tags))
    elif change == 5 and element.attrib:
        del element.attrib[rng.choice(sorted(element.attrib))]
    elif change == 6:
        names = sorted({a for p, j in parents for a in p[j].attrib})
        element.set(rng.choice(names), rng.choice(NUMBERS + WORDS))
    elif change == 7:
        values = [(a, v) for p, j in parents for a, v in p[j].attrib.items()]
        name, value = rng.choice(values)
        if element.attrib and rng.random() < 0.7:
            name = rng.choice(sorted(element.attrib))
        element.set(name, value)
    elif change == 8:
        element.text = rng.choice(NUMBERS + WORDS)
    elif change == 9:
        element.text = number_in(element.text or "", rng)
    else:
        element.text = rng.choice([p[j].text or "" for p, j in parents])


def from_xml(data, rng):
    root = xml.fromstring(data)
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        mutate_element(root, rng)
    text = xml.tostring(root, encoding="unicode")
    return re.sub("[\ud800-\udfff]", "?", text).encode()


# YAML -----------------------------------------------------------------------------------------

def places(tree):
    """(container, key) of all that a tree holds."""
    stack, found = [tree], []
    while stack:
        node = stack.pop()
        keys = list(node) if isinstance(node, dict) else range(len(node)) if isinstance(node, list) else []
        for key in keys:
            found.append((node, key))
            stack.append(node[key])
    return found


def value(rng):
    text = rng.choice(NUMBERS + WORDS)
    return rng.choice([text, text, [], {}, None, True, [text], {"a": text}, [text] * 3, float("nan"), 1e308, -1,
                       0, 10**30, [[0, 1], [0, 2]], [[0, float("inf")]], "sin(", "1/0*t", "x^9^9", "(" * 5000])


def mutate_deck(tree, rng):
    all_places = places(tree)
    if not all_places:
        return
    node, key = rng.choice(all_places)
    other, other_key = rng.choice(all_places)
    change = rng.randrange(8)
    if change == 0:
        del node[key]
    elif change == 1:
        node[key] = value(rng)
    elif change == 2:
        node[key] = copy.deepcopy(other[other_key])
    elif change == 3:
        node[key], other[other_key] = copy.deepcopy(other[other_key]), copy.deepcopy(node[key])
    elif change == 4 and isinstance(node, dict):
        node[rng.choice([str(other_key), rng.choice(WORDS), "title", "x", "curve", "set"])] = node.pop(key)
    elif change == 5 and isinstance(node, list):
        node.insert(key, copy.deepcopy(node[key]))
    elif change == 6 and isinstance(node, dict):
        node[str(rng.choice(all_places)[1])] = value(rng)
    else:
        node[key] = number_in(str(node[key]), rng)
        if rng.random() < 0.8:
            try:
                node[key] = yaml.safe_load(node[key])
            except yaml.YAMLError:
                pass


def from_yaml(data, rng):
    tree = yaml.safe_load(data)
    for _ in range(rng.choice([1, 1, 1, 2, 3])):
        mutate_deck(tree, rng)
    return yaml.safe_dump(tree, default_flow_style=rng.choice([None, True, False]), allow_unicode=True,
                          sort_keys=False).encode()


def mutant(seed_file, rng):
    data = seed_file.read_bytes()
    has_tree = seed_file.suffix not in (".msh", ".inp")
    if has_tree and rng.random() < 0.7:
        data = (from_yaml if seed_file.suffix == ".yaml" else from_xml)(data, rng)
        if rng.random() < 0.8:
            return data
    kinds = TEXT if has_tree else TEXT + [swapped_words] * len(TEXT)
    if seed_file.suffix == ".inp":
        kinds = TEXT + [other_field] * len(TEXT) + [moved_card] * (len(TEXT) // 2)
    for _ in range(rng.choice([1, 1, 2])):
        data = rng.choice(kinds)(data, rng)
    return data


# Runs -----------------------------------------------------------------------------------------

@functools.lru_cache(None)
def has_sanitizer(program):
    return b"__asan_init" in pathlib.Path(program).read_bytes()


class Harness:
    """Feeds files to the harness, which is started anew after a crash."""

    def __init__(self, program, folder, seconds):
        self.program, self.folder, self.seconds = program, folder, seconds
        self.outcomes = {}  # file: (word, message)

    def run(self, files):
        files = list(files)
        while files:
            done = self.run_until_crash(files)
            files = files[done:]

    def limit_memory(self):
        if not has_sanitizer(self.program):
            resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))

    def run_until_crash(self, files):
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
        environment.setdefault("ASAN_OPTIONS", "detect_leaks=0:max_allocation_size_mb=4096")
        environment.setdefault("UBSAN_OPTIONS", "halt_on_error=1:print_stacktrace=1")
        with open(self.folder / "errors", "w+b") as errors, open(self.folder / "list", "w+") as names:
            names.write("".join(f"{f}\n" for f in files))
            names.seek(0)
            process = subprocess.Popen([self.program, str(self.folder)], stdin=names, stdout=subprocess.PIPE,
                                       stderr=errors, env=environment, preexec_fn=self.limit_memory)
            done, why = self.follow(process, files)
            if done < len(files):
                errors.seek(0)
                tail = errors.read().decode("latin-1")
                self.outcomes[files[done]] = why, tail[-6000:]
                done += 1
        return done

    def follow(self, process, files):
        """How many files came to an end, and what became of the next one."""
        done, buffer = 0, b""
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            limit = time.monotonic() + self.seconds
            while True:
                if not selector.select(max(0.0, limit - time.monotonic())):
                    process.kill()
                    process.wait()
                    return done, "timeout"
                chunk = os.read(process.stdout.fileno(), 1 << 16)
                if not chunk:
                    break
                buffer += chunk
                *lines, buffer = buffer.split(b"\n")
                for line in lines:
                    limit = time.monotonic() + self.seconds
                    word = line.decode("utf-8", "replace")
                    if word.startswith("end "):
                        outcome, _, message = word[len(f"end {files[done]} "):].partition(": ")
                        self.outcomes[files[done]] = outcome, message
                        done += 1
        process.wait()
        return done, f"crash {process.returncode}"


def seeds(kind, folder, harness, seconds):
    corpus = sorted((HERE / "corpus").glob("*.yaml" if kind == "deck" else f"*.{kind}"))
    if kind == "deck":
        corpus += sorted((HERE / "corpus").glob("*.xml")) + sorted(INPUT.glob("*/*.yaml"))
    run = Harness(harness, folder, seconds)
    run.run(corpus)
    for file in corpus:
        assert run.outcomes[file][0] == "ok", (file, run.outcomes[file])
    return corpus


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--kind", choices=("feb", "inp", "msh", "deck"), required=True)
    arguments.add_argument("--count", type=int, default=150)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--harness", required=True)
    arguments.add_argument("--seconds", type=float, default=60, help="of one file, after which it counts as hanging")
    arguments.add_argument("--keep", type=pathlib.Path)
    known = arguments.parse_args()

    folder = pathlib.Path(tempfile.mkdtemp(prefix="abut_fuzz_"))
    counts, faults = collections.Counter(), []
    try:
        corpus = seeds(known.kind, folder, known.harness, known.seconds)
        start = time.monotonic()
        for first in range(0, known.count, BATCH):
            files = []
            for number in range(first, min(first + BATCH, known.count)):
                rng = Random(f"{known.seed} {known.kind} {number}")
                seed_file = rng.choice(corpus)
                file = folder / f"{known.kind}_{known.seed}_{number}{seed_file.suffix}"
                file.write_bytes(mutant(seed_file, rng))
                files.append(file)
            harness = Harness(known.harness, folder, known.seconds)
            harness.run(files)
            for file in files:
                word, message = harness.outcomes[file]
                counts[word] += 1
                if word not in FINE:
                    faults.append(file.name)
                    print(f"{file.name}: {word}: {message}", flush=True)
                    if known.keep:
                        known.keep.mkdir(parents=True, exist_ok=True)
                        shutil.copy(file, known.keep)
                file.unlink()
        print(f"{known.kind}: {known.count} mutants of {len(corpus)} files in {time.monotonic() - start:.0f} s: "
              + ", ".join(f"{n} {word}" for word, n in counts.most_common()))
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    # A mutator that breaks everything, or nothing, tests little.
    assert counts["ok"] > 0 and counts["input_error"] > known.count // 4, counts
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
