"""Runs the scripts of this directory and `cargo bench --bench peers`, several times each, and writes results.json.

Of each line the smallest processor seconds are kept (PEERS_RUNS=1: of one run).  Needs scikit-fem, ngsolve, numpy and scipy (pip) and Cargo; a
script whose package is not there is left out and named.  With arguments only the scripts whose names contain one run.
"""

import importlib.metadata
import json
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
RUNS = int(os.environ.get("PEERS_RUNS", "3"))
# Task, program, package, command; one thread each, as processor seconds count all of them.
SCRIPTS = [
    ("contact", "scikit-fem", "scikit-fem", ["contact_scikit_fem.py"]),
    ("contact", "NGSolve", "ngsolve", ["contact_ngsolve.py"]),
    ("laplacian", "NumPy", "numpy", ["laplacian_numpy.py"]),
    ("seminorm", "SciPy", "scipy", ["seminorm_scipy.py"]),
]


def tables(text):
    """The tables of a text as lists of dictionaries: columns are set apart by two blanks, cells have none."""
    found, heads = [], None
    for line in text.splitlines():
        cells = line.split()
        if heads and len(cells) == len(heads):
            number = lambda cell: float(cell) if re.fullmatch(r"[-+.e0-9]+", cell) else cell
            found[-1].append(dict(zip(heads, map(number, cells))))
        elif cells:
            heads = re.split(r"\s{2,}", line.strip())
            found.append([])
        else:
            heads = None
    return found


def fastest(command):
    """The tables that a command prints, with the smallest of each number of seconds over all runs."""
    best = None
    for _ in range(RUNS):
        environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1", RAYON_NUM_THREADS="1")
        done = subprocess.run(command, cwd=HERE, env=environment, capture_output=True, text=True, check=True)
        found = tables(done.stdout)
        for old, new in zip(best or [], found):
            for a, b in zip(old, new):
                for key in b:
                    if key == "processor s" or key.endswith(" s"):
                        b[key] = min(a[key], b[key])
        best = found
    return best


def main():
    file = HERE / "results.json"
    kept = json.loads(file.read_text()) if file.exists() else {"versions": {}, "lines": []}
    chosen = sys.argv[1:]
    for task, program, package, command in SCRIPTS:
        if chosen and not any(word in command[0] for word in chosen):
            continue
        try:
            version = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            print(f"{command[0]}: skipped, {package} is not installed", file=sys.stderr)
            continue
        print(command[0], file=sys.stderr)
        (table,) = fastest([sys.executable, *command])
        add(kept, program, task, table)
        kept["versions"][program] = version
    if not chosen or "peers" in chosen:
        print("cargo bench --bench peers", file=sys.stderr)
        command = os.environ.get("PEERS", "cargo bench --package signorini-benches --bench peers").split()
        for task, table in zip(("contact", "laplacian", "seminorm"), fastest(command)):
            add(kept, "this library", task, table)
    lines = ",\n  ".join(json.dumps(line) for line in kept["lines"])
    versions = json.dumps(kept["versions"], sort_keys=True)
    file.write_text(f'{{"versions": {versions},\n "lines": [\n  {lines}\n]}}\n')


def add(kept, program, task, table):
    kept["lines"] = [line for line in kept["lines"] if (line["program"], line["task"]) != (program, task)]
    kept["lines"] += [{"task": task, "program": program, **line} for line in table]


main()
