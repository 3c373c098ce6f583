#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The arrows go one way: fails on an #include that points against them. Usage: arrows_test.py ROOT"""
import pathlib
import re
import sys

# What a file of hls/ may include, lowest first. Files of one level do not include each other.
LEVELS = [["config"], ["low", "middle", "high"], ["fixed_rules"], ["fixed_native", "fixed_library"],
          ["fixed_systemc", "fixed_ap", "fixed_ac"], ["fixed"], ["formats"], ["records", "stream"],
          ["buffers", "reciprocal", "reciprocal_sqrt", "reciprocal_lookup", "lanes", "key_records", "object_records"],
          ["plane", "lighting", "key_filter", "key_cache"],
          ["triangle_setup", "shade_setup", "raster_pineda", "ztest_index", "ztest_plane", "scan_index", "scan_object", "ztest_merge", "shade_gouraud", "light_vertex",
           "phong_setup", "shade_phong", "texture_setup", "shade_texture", "motion_setup", "motion_field", "motion_compensate",
           "visible_select"],
          ["pipeline"],
          ["fields"],
          ["triangle_setup_top", "shade_setup_top", "raster_pineda_top", "ztest_index_top", "ztest_plane_top",
           "scan_index_top", "scan_object_top", "ztest_merge_top", "shade_gouraud_top", "light_vertex_top", "phong_setup_top", "shade_phong_top", "texture_setup_top",
           "shade_texture_top", "motion_setup_top", "motion_field_top", "motion_compensate_top",
           "shade_setup_lit_top", "visible_select_top"]]
# Which folders a folder may include from.
FOLDERS = {"hls": {"hls"}, "ref": {"ref"}, "vectors": {"vectors", "ref", "hls"}, "tb": {"tb"},
           "cli": {"cli", "vectors", "ref"}, "tests": {"tests", "vectors", "ref", "hls"}}


def faults(root):
    level = {stem: n for n, stems in enumerate(LEVELS) for stem in stems}
    checked = 0
    for folder, allowed in FOLDERS.items():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".hpp", ".cpp", ".h"):
                continue
            for number, line in enumerate(path.read_text().splitlines(), 1):
                match = re.match(r'\s*#\s*include\s+"([^"]+)"', line)
                if not match:
                    continue
                checked += 1
                target = match.group(1)
                here = f"{path.relative_to(root)}:{number}"
                other = (path.parent / target).resolve()
                top = other.relative_to(root.resolve()).parts[0] if other.exists() else target.split("/")[0]
                if "/" not in target and not other.exists():
                    continue  # generated
                if top not in allowed:
                    yield f"{here}: {folder}/ must not include {target}"
                if folder == "hls" and top == "hls":
                    a, b = path.stem, pathlib.PurePath(target).stem
                    if a not in level or b not in level:
                        yield f"{here}: {a} or {b} has no place in the order: add it to tests/house/arrows_test.py"
                    elif level[b] >= level[a]:
                        yield f"{here}: {a} must not include {b}"
    if checked < 50:
        yield f"only {checked} includes were found: is {root} the project?"


def main():
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "arrows: all includes point down")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
