#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tb/verilog.py writes of the pipeline and of a unit goes through Icarus, and gives the words of the vectors of a
frame, with stalls; with a word of them changed the bench says so. The bench is written here, from the manifest and the
ports. Usage: icarus_test.py HALFSPACE ROOT FOLDER CONFIG LANES YOSYS"""
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys

HALFSPACE, ROOT, FOLDER = (pathlib.Path(word).resolve() for word in sys.argv[1:4])
CONFIG, LANES, YOSYS = sys.argv[4:7]
PORT = re.compile(r"^  (input|output) (?:signed )?(?:\[(\d+):0\] )?(\w+);", re.MULTILINE)
MOST_CYCLES = 20_000


def run(*words):
    result = subprocess.run([str(word) for word in words], cwd=FOLDER, capture_output=True, text=True, check=False)
    if result.returncode:
        raise SystemExit(f"{words[0]} failed: {result.stdout}{result.stderr}")
    return result.stdout


def sender(name, bits, words):
    return f"""
  reg [{bits - 1}:0] {name}[0:{words - 1}];
  integer {name}_at = 0;
  reg {name}_moved = 0;
  initial $readmemh("{name}.hex", {name});
  assign {name}_i = {name}[{name}_at];
  always @(negedge clk_i) if (rst_ni && (!{name}_valid_i || {name}_moved))
    {name}_valid_i <= {name}_at < {words} && $random(seed) % 4 != 0;
  always @(posedge clk_i) begin
    {name}_moved <= {name}_valid_i && {name}_ready_o;
    if (rst_ni && {name}_valid_i && {name}_ready_o) {name}_at <= {name}_at + 1;
  end"""


def receiver(name, bits, words):
    return f"""
  reg [{bits - 1}:0] {name}[0:{words - 1}];
  integer {name}_at = 0;
  initial $readmemh("{name}.hex", {name});
  always @(negedge clk_i) {name}_ready_i <= $random(seed) % 4 != 0;
  always @(posedge clk_i) if (rst_ni && {name}_valid_o && {name}_ready_i) begin
    if ({name}_at >= {words} || {name}_o !== {name}[{name}_at]) wrong = wrong + 1;
    {name}_at <= {name}_at + 1;
  end"""


def bench(top, ports, manifest):
    """The text, and the streams that it compares."""
    streams = {stream["name"]: stream for stream in manifest["streams"]}
    frame, lines, outs, driven = manifest["frames"][0], [], [], []
    for name, (direction, bits) in ports.items():
        stream = name.removesuffix("_i")
        driven_here = direction == "input" and stream in streams and f"{stream}_valid_i" in ports
        kind = "wire" if direction == "output" or driven_here else "reg"
        lines.append(f"  {kind} [{bits - 1}:0] {name}{' = 0' if kind == 'reg' else ''};")
    for name, stream in streams.items():
        if f"{name}_valid_i" in ports and f"{name}_ready_o" in ports and stream["words"]:
            lines.append(sender(name, stream["bits"], stream["words"]))
            driven.append(name)
        elif f"{name}_valid_o" in ports and stream["words"]:
            lines.append(receiver(name, stream["bits"], stream["words"]))
            outs.append((name, stream["words"]))
    red, green, blue = frame["background"]
    colour_bits = ports.get("background_i", ("", 3))[1] // 3
    given = {"frame_width_i": frame["width"], "frame_height_i": frame["height"],
             "background_i": "{" + ", ".join(f"{colour_bits}'d{part}" for part in (red, green, blue)) + "}"}
    through = " && ".join(f"{name}_at == {words}" for name, words in outs)
    seen = ", ".join(f"{name}_at" for name, _ in outs)
    return "\n".join([
        "`timescale 1ns / 1ns", "module bench;", "  integer seed = 1, wrong = 0, cycles = 0;", *lines,
        f"  {top} unit ({', '.join(f'.{name}({name})' for name in ports)});", "  always #5 clk_i = !clk_i;",
        "  initial begin", *(f"    {name} = {value};" for name, value in given.items() if name in ports),
        "    #42 rst_ni = 1;", "  end", "  always @(posedge clk_i) begin", "    cycles = cycles + 1;",
        f"    if (({through}) || cycles == {MOST_CYCLES}) begin",
        f"      $display(\"{' '.join('%0d' for _ in outs)} words, %0d wrong, %0d cycles\", {seen}, wrong, cycles);",
        "      $finish;", "    end", "  end", "endmodule", ""]), outs


def scene(path):
    """Triangles of any place, also outside the frame, which is small: Icarus takes seconds for some thousand cycles."""
    draw = random.Random(1)
    lines = ["size 17 13"]
    for _ in range(40):
        vertices = [f" {draw.uniform(-6, 22):.2f} {draw.uniform(-6, 18):.2f} {draw.uniform(0.1, 0.9):.3f}"
                    f" {draw.randrange(256)} {draw.randrange(256)} {draw.randrange(256)}" for _ in range(3)]
        lines.append("t" + "".join(vertices))
    path.write_text("\n".join(lines) + "\n")


def simulate(top, package, manifest):
    """What the bench prints, and what it has to begin with."""
    source = FOLDER / f"{top}.v"
    run(sys.executable, ROOT / "tb/verilog.py", "--package", package, "--top", top, "--lanes", LANES, "--yosys", YOSYS,
        "-o", source)
    text = source.read_text()
    body = text[text.index(f"module {top}("):]
    body = body[:body.index("endmodule")]
    ports = {name: (direction, int(msb or 0) + 1) for direction, msb, name in PORT.findall(body)}
    written, outs = bench(top, ports, manifest)
    (FOLDER / f"bench_{top}.v").write_text(written)
    run("iverilog", "-g2005", "-o", f"bench_{top}", f"bench_{top}.v", source)
    return run("vvp", "-n", f"bench_{top}"), " ".join(str(words) for _, words in outs) + " words, 0 wrong"


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.parent.mkdir(parents=True, exist_ok=True)
    FOLDER.mkdir()
    scene(FOLDER / "scene.tri")
    run(HALFSPACE, "vectors", "scene.tri", "--config", CONFIG, "--lanes", LANES, "--no-corners", "--out", "set")
    for path in (FOLDER / "set").iterdir():
        path.rename(FOLDER / path.name)
    package = FOLDER / "hs_formats_pkg.sv"
    run(HALFSPACE, "package", "--config", CONFIG, "-o", package)
    manifest = json.loads((FOLDER / "manifest.json").read_text())
    for top in ("hs_raster_pineda", "hs_pipeline"):
        said, expected = simulate(top, package, manifest)
        print(f"{top}: {said.strip()}")
        if not said.startswith(expected):
            raise SystemExit(f"{top}: expected {expected}")
    words = (FOLDER / "pixel.hex").read_text().splitlines()
    words[-1] = words[-1][:-1] + ("0" if words[-1][-1] != "0" else "1")
    (FOLDER / "pixel.hex").write_text("\n".join(words) + "\n")
    said = run("vvp", "-n", "bench_hs_pipeline")
    if " 1 wrong," not in said:
        raise SystemExit(f"a word of pixel is changed, and the bench says: {said}")
    shutil.rmtree(FOLDER, ignore_errors=True)


if __name__ == "__main__":
    main()
