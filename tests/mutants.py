#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Breaks fast/ and exact/ on purpose, one change at a time, and shows that the tests notice.

    tests/mutants.py --all       every mutant (about a quarter of an hour)
    tests/mutants.py --subset    the ones that CI runs
    tests/mutants.py --only ID   one, with the tests' output
    tests/mutants.py --family batch     those whose ID starts so
    tests/mutants.py --family constant --filter 'ProofsConstants*'
    tests/mutants.py --list

Needs the release preset to be built. The tree is left alone: each mutant is a copy of its folder, compiled and
linked with the tests' own objects in place of the library's. A mutant is killed when the tests fail, crash or run over
time. Exit status 1 when one survives that is not listed in tests/mutants.txt as equivalent, with its proof; 2 when a
mutant no longer applies (its text has to occur exactly once).
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "release"
# Tests that say nothing about fast/ and exact/, or run the unmutated binary.
LEFT_OUT = ("CommandLine*:BadInput*:*Plugin*:*Mesh*:Read*:*Report*:*Picture*:*Html*:*BoundingHierarchy*:*Corpus*:*FloatText*:"
            "*AtomicFile*:*Random*:Ledger*:Merge*:Compare*:ShardSet*:ShadowCommands*")
SECONDS = 240


class Mutant:
    def __init__(self, block):
        lines = block.strip("\n").split("\n")
        head = lines[0].split()
        self.id, self.file = head[0], head[1]
        self.tags = {tag for tag in head[2:] if not tag.startswith("first=")}
        self.first = next((tag[len("first="):] for tag in head[2:] if tag.startswith("first=")), None)
        self.before = self.after = self.why = ""
        for line in lines[1:]:
            mark, text = line[:2], line[2:]
            if mark == "- ":
                self.before += ("\n" if self.before else "") + text
            elif mark == "+ ":
                self.after += ("\n" if self.after else "") + text
            elif mark == "= ":
                self.why += (" " if self.why else "") + text
            else:
                raise SystemExit(f"mutants.txt: {self.id}: expected '- ', '+ ' or '= ', found {line!r}")


def load():
    blocks = re.split(r"\n\s*\n", (ROOT / "tests" / "mutants.txt").read_text())
    kept = ["\n".join(l for l in b.split("\n") if not l.startswith("#")) for b in blocks]
    return [Mutant(block) for block in kept if block.strip()]


def link_command():
    out = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", "tests/gnomon_tests"], check=True,
                         capture_output=True, text=True).stdout
    line = [l for l in out.splitlines() if "-o tests/gnomon_tests" in l][-1]
    words = [w for w in shlex.split(line)]
    start = next(i for i, w in enumerate(words) if re.search(r"(g\+\+|c\+\+|clang\+\+)[-0-9]*$", w))
    end = words.index("&&", start) if "&&" in words[start:] else len(words)
    return words[start:end]


def squeeze(text):
    return re.sub(r"\s+", " ", text).strip()


def apply(mutant, text):
    """White space is free, so that formatting does not break mutants."""
    pattern = r"\s*".join(re.escape(w) for w in re.findall(r"\w+|[^\w\s]", mutant.before))
    hits = list(re.finditer(pattern, text))
    if len(hits) != 1:
        raise SystemExit(f"{mutant.id}: expected its text once in {mutant.file}, found it {len(hits)} times")
    return text[:hits[0].start()] + mutant.after + text[hits[0].end():]


def run(mutant, link, tests_of, show=False):
    started = time.time()
    with tempfile.TemporaryDirectory(prefix="gnomon-mutant-") as folder:
        work = pathlib.Path(folder)
        layer = mutant.file.split("/")[0]
        shutil.copytree(ROOT / layer, work / layer)
        target = work / mutant.file
        target.write_text(apply(mutant, target.read_text()))
        is_header, is_build_file = mutant.file.endswith(".h"), target.name == "CMakeLists.txt"
        sources = sorted((work / layer).glob("*.cpp")) if is_header or is_build_file else [target]
        # The library's own options, as the mutant has them (its definitions are for sanitizers).
        options = re.findall(rf"^target_compile_options\(gnomon_{layer} (?:PUBLIC|PRIVATE) ([^)]*)\)",
                             (work / layer / "CMakeLists.txt").read_text(), re.MULTILINE)
        if is_header:
            name = pathlib.Path(mutant.file).name
            users = {name}
            while True:  # sources that include the header, over other headers too
                more = {p.name for p in (work / layer).iterdir() if p.suffix in (".h", ".cpp")
                        and any(f'"{layer}/{u}"' in p.read_text() for u in users)}
                if more <= users:
                    break
                users |= more
            sources = [s for s in sources if s.name in users]
        objects = []
        for source in sources:
            objects.append(str(source.with_suffix(".o")))
            built = subprocess.run(["c++", "-std=c++20", "-O2", *" ".join(options).split(), "-w", f"-I{work}",
                                    f"-I{ROOT}", "-c", str(source), "-o", objects[-1]], capture_output=True, text=True)
            if built.returncode != 0:
                return mutant, "does not compile: " + built.stderr.splitlines()[0], time.time() - started
        words = list(link)
        words[words.index("-o") + 1] = str(work / "mutant")
        first_library = next(i for i, w in enumerate(words) if w.endswith(".a"))
        words[first_library:first_library] = objects
        linked = subprocess.run(words, cwd=BUILD, capture_output=True, text=True)
        if linked.returncode != 0:
            return mutant, "does not link: " + (linked.stderr.splitlines() or ["?"])[-1], time.time() - started
        environment = dict(os.environ, GTEST_FAIL_FAST="1", GTEST_BRIEF="1")
        # The tests that are known to notice go first; the others are asked when these do not.
        for chosen in ([mutant.first] if mutant.first else []) + [tests_of]:
            try:
                tests = subprocess.run([str(work / "mutant"), f"--gtest_filter={chosen}"], env=environment, cwd=folder,
                                       capture_output=not show, text=True, timeout=SECONDS)
            except subprocess.TimeoutExpired:
                return mutant, "killed (over time)", time.time() - started
            if tests.returncode != 0:
                break
        if tests.returncode == 0:
            return mutant, "SURVIVED", time.time() - started
        found = re.findall(r"\[  FAILED  \] (\S+)", tests.stdout or "")
        return mutant, "killed by " + (found[0].rstrip(",") if found else f"status {tests.returncode}"), time.time() - started


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--all", action="store_true")
    what.add_argument("--subset", action="store_true")
    what.add_argument("--only", metavar="ID")
    what.add_argument("--family", metavar="START")
    what.add_argument("--list", action="store_true")
    parser.add_argument("--filter", default=f"-{LEFT_OUT}", help="tests, as --gtest_filter takes them: fewer are quicker")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    options = parser.parse_args()
    mutants = load()
    if options.list:
        for m in mutants:
            print(f"{m.id:28}{m.file:30}{squeeze(m.before)[:50]:52}-> {squeeze(m.after)[:50]}")
        return 0
    if options.subset:
        mutants = [m for m in mutants if "subset" in m.tags]
    if options.family:
        mutants = [m for m in mutants if m.id.startswith(options.family)]
    if options.only:
        mutants = [m for m in mutants if m.id == options.only]
    if not mutants:
        print("mutants: expected at least one, found none", file=sys.stderr)
        return 2
    for m in mutants:
        apply(m, (ROOT / m.file).read_text())  # said before minutes of work, not after
    link = link_command()
    bad = killed = equivalent = 0
    with concurrent.futures.ThreadPoolExecutor(1 if options.only else options.jobs) as pool:
        for m, result, seconds in pool.map(lambda m: run(m, link, options.filter, bool(options.only)), mutants):
            if result.startswith("killed"):
                killed += 1
                if "equivalent" in m.tags:
                    result += " (listed as equivalent: wrongly)"
                    bad += 1
            elif result == "SURVIVED" and "equivalent" in m.tags:
                equivalent += 1
                result = "survived, equivalent: " + m.why
            else:
                bad += 1
            print(f"{m.id:28}{seconds:6.0f} s  {result}", flush=True)
    print(f"{killed} mutants killed, {equivalent} equivalent, {bad} not as they should be")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
