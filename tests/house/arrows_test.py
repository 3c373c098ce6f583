#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The arrows go one way: fails on an #include, and on an instance in the RTL, that points against them. A folder of the
root is a floor, a folder of a floor a room. It shows first, on a small tree, that it finds wrong ones.
Usage: arrows_test.py ROOT"""
import pathlib
import re
import sys
import tempfile

# Which floors a floor may include from, besides itself. The bench sees vector files and Verilated models alone.
FLOORS = {"ref": "", "hls": "", "driver": "", "tb": "driver", "model": "ref hls", "vectors": "model ref hls",
          "study": "vectors model ref hls",
          "cli": "study vectors model ref tb", "tests": "study vectors model ref hls"}
# The rooms of a floor, lowest first: a room includes from itself and from rooms before it. Rooms with a + between them
# are one. `.hpp` and `.cpp`: files in no room. What a floor has no order of is not held.
ROOMS = {"ref": ".hpp scene+builtin geometry raster objects motion",
         "hls": "numbers formats setup raster ztest shade texture motion objects pipeline top",
         "model": "formats texture shade motion objects pipeline package drivers",
         "vectors": "frames .hpp+.cpp",
         "study": "proofs bounds stability trade fit papers",
         "cli": ".hpp common parts plots motion sweep+repro+inspect .cpp",
         "rtl": "common memory setup raster ztest shade texture motion objects pipeline system board"}
# Where units are put together: elsewhere none includes another or has it as an instance.
COMPOSE = ("pipeline", "system", "board", "top")

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
INSTANCE = re.compile(r"^\s*(hs_\w+)\s+(?:#\s*\(|u_\w+)")


def order(floor):
    return {room: n for n, rooms in enumerate(ROOMS.get(floor, "").split()) for room in rooms.split("+")}


def room_of(path):
    """Of a path below the root."""
    return path.parts[1] if len(path.parts) > 2 else path.suffix


def room_fault(floor, path, other, units):
    """Why a file of a floor must not use another of it, or ''."""
    rooms = order(floor)
    here, there = room_of(path), room_of(other)
    if rooms:
        for room in (here, there):
            if room not in rooms:
                return f"the room {floor}/{room} has no place in the order: add it to tests/house/arrows_test.py"
        if rooms[here] < rooms[there]:
            return f"{floor}/{here} comes before {floor}/{there}"
    both = [p.stem.removeprefix("hs_") for p in (path, other)]
    if floor in ("hls", "rtl") and here not in COMPOSE and both[0] != both[1] and set(both) <= units:
        return "a unit must not know another"
    return ""


def include_faults(root, units):
    """Faults, and at the end the number of arrows that were looked at."""
    looked = 0
    for floor, below in FLOORS.items():
        for path in sorted((root / floor).rglob("*")):
            if path.suffix not in (".hpp", ".cpp", ".h"):
                continue
            path = path.relative_to(root)
            for number, line in enumerate((root / path).read_text().splitlines(), 1):
                match = INCLUDE.match(line)
                if not match or ("/" not in match.group(1) and not (root / path.parent / match.group(1)).exists()):
                    continue  # the latter is generated
                looked += 1
                other = pathlib.PurePath(match.group(1))
                why = ""
                if not (root / other).exists():
                    why = "there is no such file: name it from the root"
                elif other.parts[0] == floor:
                    why = room_fault(floor, path, other, units)
                elif other.parts[0] not in below.split():
                    why = f"{floor}/ knows " + (f"{', '.join(below.split())} alone" if below else "no other floor")
                if why:
                    yield f"{path}:{number}: must not include {other}: {why}"
    yield looked


def instance_faults(root, units):
    modules = {path.stem: path.relative_to(root) for path in sorted(root.glob("rtl/*/hs_*.sv"))}
    looked = 0
    for path in modules.values():
        for number, line in enumerate((root / path).read_text().splitlines(), 1):
            match = INSTANCE.match(line)
            if match and (other := modules.get(match.group(1))):
                looked += 1
                if why := room_fault("rtl", path, other, units):
                    yield f"{path}:{number}: must not have {other.stem} as an instance: {why}"
    yield looked


def unit_faults(root, names):
    """What of a unit is not where hls/units.txt has it."""
    for name in names:
        room, unit = name.split("/")
        for path in (f"hls/{room}/{unit}.hpp", f"rtl/{room}/hs_{unit}.sv"):
            if not (root / path).exists():
                yield f"hls/units.txt: {name}, but there is no {path}"


def faults(root):
    names = [line for line in (root / "hls/units.txt").read_text().split("\n") if line and line[0] != "#"]
    units = {name.split("/")[1] for name in names}
    *found, includes = include_faults(root, units)
    *more, instances = instance_faults(root, units)
    return found + more + list(unit_faults(root, names)), includes, instances


# A wrong arrow each, and what has to be said of it.
WRONG = {"ref/scene/a.hpp": ('#include "hls/numbers/n.hpp"', "ref/ knows no other floor"),
         "hls/numbers/b.hpp": ('#include "hls/shade/s.hpp"', "hls/numbers comes before hls/shade"),
         "hls/shade/c.hpp": ('#include "hls/attic/t.hpp"', "hls/attic has no place"),
         "hls/shade/u.hpp": ('#include "hls/ztest/v.hpp"', "a unit must not know another"),
         "tb/d.cpp": ('#include "model/formats/m.hpp"', "tb/ knows driver alone"),
         "cli/common/e.cpp": ('#include "hls/numbers/n.hpp"', "cli/ knows study, vectors, model, ref, tb alone"),
         "model/formats/f.cpp": ('#include "model/pipeline/gone.hpp"', "there is no such file"),
         "rtl/ztest/hs_g.sv": ("  hs_s u_s (", "rtl/ztest comes before rtl/shade"),
         "rtl/shade/hs_u.sv": ("  hs_v #(", "a unit must not know another")}
RIGHT = {"hls/units.txt": "shade/u\nztest/v", "hls/numbers/n.hpp": "", "hls/attic/t.hpp": "", "rtl/shade/hs_s.sv": "",
         "model/formats/m.hpp": "", "hls/shade/s.hpp": '#include "hls/numbers/n.hpp"', "hls/ztest/v.hpp": "",
         "hls/pipeline/p.hpp": '#include "hls/shade/u.hpp"',
         "rtl/ztest/hs_v.sv": "", "rtl/pipeline/hs_p.sv": "  hs_u u_u (",
         "model/formats/r.hpp": '#include "hls/numbers/n.hpp"'}


def self_test():
    """What is not found, or found too much, in a small tree."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in {**RIGHT, **{name: text for name, (text, _) in WRONG.items()}}.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text + "\n")
        found, _, _ = faults(root)
    for name, (_, says) in WRONG.items():
        if not any(fault.startswith(f"{name}:1:") and says in fault for fault in found):
            yield f"self-test: {name} is not found to be wrong"
    for fault in found:
        if fault.split(":")[0] not in WRONG:
            yield f"self-test: nothing is wrong with {fault}"


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    found, includes, instances = faults(root)
    found += self_test()
    if includes < 500 or instances < 50:
        found.append(f"only {includes} includes and {instances} instances were found: is {root} the project?")
    print("\n".join(found)
          or f"arrows: {includes} includes and {instances} instances point down; {len(WRONG)} wrong ones were found")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
