# SPDX-License-Identifier: Apache-2.0
"""The pins of a simulated board, of its RTL or of what synthesis makes of it, against the kernels' pictures."""

import pathlib

from flow import FlowError, parameters, run, sources

BENCH = pathlib.Path(__file__).resolve().parent.parent.parent / "tb" / "board"
WAIVERS = BENCH.parent / "lint.vlt"
COLUMNS, ROWS = 640, 480
# As tb/verilate.py; a netlist has no names for widths.
FLAGS = ["-O3", "--x-assign", "fast", "--x-initial", "unique", "--noassert", "-Wno-fatal", "-Wno-lint", "-Wno-style",
         "-Wno-MULTIDRIVEN", "-Wno-MODDUP"]


def build(board, package, lists, background, out, netlist=None, cells=None, verilator="verilator", optimize="-O1"):
    """The program OUT/model/video."""
    given = parameters(board, lists, background)
    if netlist:
        # Verilator takes no defaults of ports.
        inputs = ["-DNO_ICE40_DEFAULT_ASSIGNMENTS", BENCH / "ice40_pads.v", netlist, cells]
    else:
        inputs = [*(f"-G{name}={value}" for name, value in given.items()), WAIVERS, BENCH / "ice40_pads.v",
                  *sources(board, package)]
    folder = out / "model"
    run([verilator, "--cc", "--exe", "--build", "--prefix", "Vboard", "--Mdir", folder, "--top-module", board.name,
         *FLAGS, "-MAKEFLAGS", f"OPT_FAST={optimize} OPT_SLOW=-O0 OPT_GLOBAL=-O1", *inputs,
         BENCH / "video.cpp", "-o", "video"], out / "verilator.log", cwd=out)
    return folder / "video"


def picture(path):
    """The channels of a P6 file of a frame."""
    head, _, data = path.read_bytes().partition(b"\n")
    if head != b"P6 640 480 15" or len(data) != 3 * COLUMNS * ROWS:
        raise FlowError(f"{path} is not a frame of {COLUMNS}×{ROWS}")
    return data


def expected(rows, colour_bits):
    """What pins show of a picture of the kernels: each pixel a square, its colour in 4 bits."""
    scale = COLUMNS // len(rows[0])
    out = bytearray()
    for row in rows:
        line = b"".join(bytes(widened(value, colour_bits) for value in pixel) * scale for pixel in row)
        out += line * (ROWS // len(rows))
    return bytes(out)


def widened(value, bits):
    """The bits repeated, the first four of them."""
    repeated = (f"{value:0{bits}b}" * 4)[:4]
    return int(repeated, 2)


def shown(program, out, frames, pictures, colour_bits, pressed=()):
    """Which picture each frame of video is; −1: it is black."""
    run([program, out, frames, *pressed], out / "video.log", cwd=out)
    known = {expected(rows, colour_bits): number for number, rows in reversed(list(enumerate(pictures)))}
    known[bytes(3 * COLUMNS * ROWS)] = -1
    found = []
    for number in range(frames):
        data = picture(out / f"frame_{number}.ppm")
        if data not in known:
            nearest = min(sum(a != b for a, b in zip(data, want)) for want in known)
            raise FlowError(f"frame {number} of the video pins is no picture of the kernels: {nearest} bytes differ "
                            f"from the nearest ({out / f'frame_{number}.ppm'})")
        found.append(known[data])
    return found
