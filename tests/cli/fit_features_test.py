#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`halfspace fit` on a file with a texture, one with lights and one that moves: what it finds keeps the goal when the
pictures are rendered by other commands and held together here, its RTL is equal to the kernels to the bit, and one
step less of any number, rendered so, misses the goal or is refused. Costs and goals that are named are kept.
Usage: fit_features_test.py HALFSPACE MODELS CONFIGS FOLDER"""
import csv
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys

HALFSPACE, MODELS, CONFIGS, FOLDER = sys.argv[1], *map(pathlib.Path, sys.argv[2:5])
SIZE = ["--size", "96x72"]
# Name: file, what fit is told, whose look the ideal picture has, dB, seconds of the frames.
CASES = {"textured": ("Collada/duck.dae", [], "textured/textured_middle", 35, [0]),
         "lit": ("Collada/COLLADA.dae", ["--shading", "phong"], "lit/phong_middle", 47, [0]),
         "phong": ("teapot", ["--shading", "phong"], "lit/phong_middle", 41, [0]),
         "moving": ("X/Testwuson.X", ["--frames", "0:2", "--texture", "none"], "", 38, [0, 1 / 25, 2 / 25])}


def run(*command):
    return subprocess.run([str(part) for part in (HALFSPACE, *command)], capture_output=True, text=True, timeout=300,
                          check=False)


def good(*command):
    result = run(*command)
    assert result.returncode == 0, f"{' '.join(map(str, command))}: {result.stderr}"
    return result.stdout


def psnr(a, b):
    squares = sum((x - y) ** 2 for n, (x, y) in enumerate(zip(a, b)) if n % 4 != 3)
    return math.inf if squares == 0 else 10 * math.log10(255 ** 2 * len(a) * 3 / 4 / squares)


def rendered(scene, engine, config, time):
    """None where the configuration is refused."""
    done = run("render", scene, "--camera", "auto", *SIZE, "--time", time, "--engine", engine, "--config", config,
               "--dump", FOLDER / engine)
    if done.returncode and "refused" in done.stderr:
        return None
    assert done.returncode == 0, done.stderr
    return (FOLDER / engine / "colour.rgba8").read_bytes()


def worst(scene, ideals, config, times):
    """dB of the worst frame against the ideal pictures, rounded to 8 bits; −1 where the configuration is refused."""
    pictures = [rendered(scene, "hls", config, time) for time in times]
    return -1 if None in pictures else min(map(psnr, ideals, pictures))


def check(name):
    file, told, look, goal, times = CASES[name]
    scene, toml, report = MODELS / file if "/" in file else file, FOLDER / f"{name}.toml", FOLDER / f"{name}.json"
    good("fit", scene, "--camera", "auto", *SIZE, *told, "--psnr", goal, "--area", "none", "-o", toml, "--json",
         report, "--work", FOLDER / name)
    found = json.loads(report.read_text())
    numbers, cosim = found["configuration"], found["proof"]["cosim"]
    ideals = [rendered(scene, "ideal", CONFIGS / f"{look}.toml" if look else "middle", time) for time in times]
    seen = worst(scene, ideals, toml, times)
    print(f"{name}: {numbers['shading']}, {numbers['texture']}, {numbers['lights']} lights: {seen:.2f} dB, "
          f"{cosim['words']} words, {cosim['mismatches']} mismatches, {len(found['one_bit_less'])} steps less")
    assert cosim["mismatches"] == 0 < cosim["words"] and found["frames"] == len(times)
    assert seen >= goal - 0.3, f"{name}: {seen:.2f} dB at a second look"
    assert found["proof"]["psnr_db"] >= goal and abs(found["proof"]["psnr_db"] - seen) < 0.5, found["proof"]
    tried = 0
    for less in found["one_bit_less"]:
        assert less["result"] != "holds", f"{name}: {less}"
        step = re.fullmatch(r"(\w+) (\d+) -> (\d+)", less["change"])
        if not step or step[1] in ("triangles",):
            continue
        text = toml.read_text()
        changed = re.sub(rf"^{step[1]} = {step[2]}\b", f"{step[1]} = {step[3]}", text, flags=re.MULTILINE)
        assert changed != text, less
        broken = FOLDER / "less.toml"
        broken.write_text(changed)
        worse = worst(scene, ideals, broken, times)
        refused = less["result"].startswith("refused")
        assert (worse == -1) == refused and worse < goal + 0.3, f"{name}: {less}, and {worse:.2f} dB here"
        tried += 1
    assert tried >= 7, tried
    return found


def row_of(scene, config):
    """With room for the triangles that the pan of a sweep adds, as far as no number gets another width."""
    out, roomy = FOLDER / "sweep", FOLDER / "roomy.toml"
    shutil.rmtree(out, ignore_errors=True)
    roomy.write_text(re.sub(r"^triangles = (\d+)", lambda found: f"triangles = {(1 << int(found[1]).bit_length()) - 1}",
                            config.read_text(), flags=re.MULTILINE))
    good("sweep", scene, "--camera", "auto", *SIZE, "--config", roomy, "--no-named", "--out", out)
    with open(out / "sweep.csv", encoding="utf-8") as file:
        return next(csv.DictReader(file))


def check_costs():
    """What costs least by each cost does, as a sweep counts it."""
    columns, rows = {"memory": "memory_bits", "bytes": "bytes", "cycles": "cycles"}, {}
    for cost, column in columns.items():
        toml, report = FOLDER / f"{cost}.toml", FOLDER / f"{cost}.json"
        good("fit", "teapot", *SIZE, "--psnr", 42, "--cost", cost, "--area", "none", "--no-cosim", "-o", toml, "--json",
             report, "--work", FOLDER / "x")
        toml.write_text(toml.read_text().replace('"gamma"', '"delta"'))
        rows[cost] = row_of("teapot", toml)
        assert float(rows[cost][column]) == json.loads(report.read_text())["cost"], cost
    for cost, column in columns.items():
        values = {name: int(row[column]) for name, row in rows.items()}
        print(f"least {cost}: {values}")
        assert values[cost] == min(values.values()), f"{cost}: {values}"
    assert len({row["cycles"] for row in rows.values()}) > 1, "the cost that is named changes nothing"


def check_motion():
    """Frames in between: what is found holds, a step less of each number does not, and the file says what was found."""
    scene, toml, report = MODELS / CASES["moving"][0], FOLDER / "motion.toml", FOLDER / "motion.json"
    good("fit", scene, "--camera", "auto", *SIZE, "--keys", 1, "--frames", "0:4", "--rate", 30, "--psnr", 56, "-o",
         toml, "--json", report, "--work", FOLDER / "motion")
    found = json.loads(report.read_text())
    numbers, changes = found["configuration"], [less["change"].split()[0] for less in found["one_bit_less"]]
    print(f"motion: {numbers['filter']}, vector_fraction {numbers['vector_fraction']}, weight_bits "
          f"{numbers['weight_bits']}: {found['outcome']['worst_reference_psnr_db']:.2f} dB, {found['proof']['cosim']}")
    assert found["outcome"]["worst_reference_psnr_db"] >= 56 and found["outcome"]["frames_between"] == 2
    assert found["proof"]["cosim"]["mismatches"] == 0 < found["proof"]["cosim"]["words"]
    assert {"vector_fraction", "vector_range", "weight_bits", "filter", "coordinate_bits"} <= set(changes), changes
    for less in found["one_bit_less"]:
        assert less["result"].startswith("refused") or float(less["result"].split()[0]) < 56, less
    out = FOLDER / "sweep_motion"
    good("sweep", scene, "--camera", "auto", *SIZE, "--config", toml, "--frames", "0:4", "--out", out)
    with open(out / "sweep.csv", encoding="utf-8") as file:
        row = next(csv.DictReader(file))
    assert float(row["memory_bits"]) == found["cost"], (row["memory_bits"], found["cost"])
    assert abs(float(row["reference_psnr_db"]) - found["proof"]["reference_psnr_db"]) < 1e-9, row
    still = run("fit", "teapot", "--keys", 1, "--work", FOLDER / "x")
    assert still.returncode == 1 and "nothing moves" in still.stderr, still.stderr


def check_goals():
    for told, holds in ((["--wrong-pixels", 5, "--psnr", 0], lambda proof: proof["wrong_pixels"] <= 5),
                        (["--max-lsb", 3, "--psnr", 0], lambda proof: proof["largest_lsb"] <= 3)):
        report = FOLDER / "goal.json"
        good("fit", "teapot", *SIZE, *told, "--area", "none", "--no-cosim", "--json", report, "--work", FOLDER / "x")
        found = json.loads(report.read_text())
        assert holds(found["proof"]), found["proof"]
        assert any("pixels" in less["result"] or "LSB" in less["result"] for less in found["one_bit_less"]), told
    asked = run("fit", FOLDER / "one.tri", "--lit", "--area", "none", "--work", FOLDER / "x")
    assert asked.returncode == 1 and "no normals" in asked.stderr, asked.stderr
    missing = run("fit", "teapot", *SIZE, "--psnr", 0, "--wrong-pixels", 0, "--max-lsb", 0.01, "--area", "none",
                  "--work", FOLDER / "x")
    assert missing.returncode == 1 and "no configuration reaches 0.01 LSB and 0 wrong pixels" in missing.stderr


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    (FOLDER / "one.tri").write_text("size 40 30\nt 1 1 .5 9 9 9  30 2 .5 9 9 9  4 20 .5 9 9 9\n")
    found = {name: check(name) for name in CASES}
    assert found["phong"]["configuration"]["shading"] == "phong" and found["phong"]["configuration"]["normal_fraction"]
    assert found["textured"]["configuration"]["texels"] and found["lit"]["configuration"]["lights"] == 2
    check_costs()
    check_motion()
    check_goals()


if __name__ == "__main__":
    main()
