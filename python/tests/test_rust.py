"""The numbers of the package are those of the Rust libraries, bit by bit."""

import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

import fractional_sobolev as fs

HERE = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def rust():
    if shutil.which("cargo") is None:
        pytest.skip("cargo is not there")
    command = ["cargo", "run", "--release", "--locked", "--quiet", "--example", "values"]
    lines = subprocess.run(command, cwd=HERE, capture_output=True, text=True, check=True).stdout.splitlines()
    number = lambda bits: struct.unpack(">d", bytes.fromhex(bits))[0]
    return {name: (number(value), number(error)) for name, value, error in map(str.split, lines)}


def calls():
    kink = (lambda x: abs(x - 0.3)), (0, 0.3, 1)
    nodes = np.arange(1001) / 1000.0
    corners = [(0, 0), (1, 0), (1, 1), (0, 1)]
    square = [[0, 0], [1, 0], [0, 1], [1, 1]], [[0, 1, 3], [0, 3, 2]]
    return {
        "norm": lambda: fs.norm(kink[0], 0.45, kink[1]),
        "seminorm": lambda: fs.seminorm(kink[0], 0.7, kink[1]),
        "distances": lambda: fs.seminorm(lambda x, d: d[1] ** 0.5, 0.6, (0, 0.3, 1), distances=True),
        "array": lambda: fs.norm(nodes * (1.0 - nodes), 0.5, nodes),
        "dual": lambda: fs.dual_norm([1.0, -1.0], 0.5, (0, 0.5, 1)),
        "error": lambda: fs.error_norm(lambda x: x * x, (0, 0.5, 1), 0.5),
        "boundary": lambda: fs.boundary_norm(corners, lambda x, y: x * y, -0.5, elements=8, exponent=2.0),
        "plane": lambda: fs.plane_norm(*square, [0, 1, 0, 1], 0.5, 1e-6),
        "poincare": lambda: fs.poincare(0.5, (0, 1e-6)),
        "interpolation": lambda: fs.interpolation_constant(0.5, norm="derivative", tol=1e-9),
    }


@pytest.mark.parametrize("name", calls())
def test_same_bits(rust, name):
    found = calls()[name]()
    assert (found.value, found.error) == rust[name]


def test_same_products(rust):
    found = fs.gram([0, 0.25, 0.5, 1], 0.3) @ np.array([1.0, 2.0, -1.0, 0.5])
    assert found.tolist() == [rust[f"gram{k}"][0] for k in range(4)]


def test_same_contact_force(rust):
    n = 8
    x = np.linspace(0.0, 1.0, n + 1)
    nodes = np.array([(a, b) for b in x for a in x])
    k = np.array([k for k in range(n * (n + 1)) if k % (n + 1) < n])
    triangles = np.concatenate([np.c_[k, k + 1, k + n + 2], np.c_[k, k + n + 2, k + n + 1]])
    values = np.c_[np.zeros(len(nodes)), 1.0 - 3.0 * nodes[:, 0]]
    found = fs.contact.solve(
        (nodes, triangles), values, groups={"contact": lambda x, y: y == 0.0, "clamped": lambda x, y: y == 1.0}
    )
    assert found.contact_force == rust["contact"][0]
