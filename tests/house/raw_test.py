#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kernels compute on numbers whose width is in their type. raw(x), the bits of x as an integer, is what is left for
addresses of tables and memories, counts of places to shift by, and comparisons of bits; an integer of 64 bits is what a
synthesis tool builds of arithmetic on it. So the uses are counted, by file: more of them are a fault, and fewer have to
be written down here. hls/numbers, which makes numbers, and hls/top, which packs words, are not looked at.
Usage: raw_test.py ROOT"""
import pathlib
import re
import sys

RAW = re.compile(r"(?<![A-Za-z0-9_])raw\(")
COMMENT = re.compile(r"//[^\n]*")
FREE = ("numbers", "top")
USES = {
    "formats/buffers.hpp": 2,
    "formats/lanes.hpp": 1,
    "formats/scan_pixels.hpp": 2,
    "motion/film_memories.hpp": 6,
    "motion/film_scan.hpp": 4,
    "motion/hole_find.hpp": 2,
    "motion/key_cache.hpp": 2,
    "motion/key_place.hpp": 2,
    "motion/motion_field.hpp": 4,
    "motion/motion_order.hpp": 4,
    "motion/pixel_store.hpp": 4,
    "objects/scan_object.hpp": 1,
    "raster/raster_pineda.hpp": 5,
    "setup/plane.hpp": 2,
    "shade/lighting.hpp": 6,
    "shade/reciprocal_sqrt.hpp": 1,
    "shade/shade_gouraud.hpp": 3,
    "shade/shade_phong.hpp": 5,
    "texture/reciprocal_lookup.hpp": 1,
    "texture/shade_texture.hpp": 6,
    "texture/texel_fetch.hpp": 6,
    "ztest/ztest_plane.hpp": 3,
}


def faults(texts, uses):
    """texts: of each file below hls/."""
    for name, text in sorted(texts.items()):
        found, held = len(RAW.findall(COMMENT.sub("", text))), uses.get(name, 0)
        if found > held:
            yield f"hls/{name}: {found} uses of raw(), more than {held}: compute with hls/numbers/arithmetic.hpp"
        elif found < held:
            yield f"hls/{name}: {found} uses of raw(), fewer than {held}: write {found} in tests/house/raw_test.py"
    for name in sorted(set(uses) - set(texts)):
        yield f"hls/{name} is in the table of tests/house/raw_test.py, and there is no such file"


def prove_that_it_fails():
    texts = {"more.hpp": "raw(a) + raw(b)", "fewer.hpp": "from_raw<T>(1) // raw(x)", "right.hpp": "raw(x)"}
    found = [fault.split()[0].rstrip(":") for fault in faults(texts, {"more.hpp": 1, "fewer.hpp": 1, "right.hpp": 1,
                                                                      "gone.hpp": 2})]
    if found != ["hls/fewer.hpp", "hls/more.hpp", "hls/gone.hpp"]:
        sys.exit(f"the test itself is broken: {found}")


def main():
    prove_that_it_fails()
    root = pathlib.Path(sys.argv[1]).resolve() / "hls"
    files = [path for suffix in ("hpp", "cpp") for path in root.rglob(f"*.{suffix}")]
    texts = {str(path.relative_to(root)): path.read_text(encoding="utf-8") for path in files
             if path.relative_to(root).parts[0] not in FREE}
    found = list(faults(texts, USES))
    print("\n".join(found) or f"raw: {sum(USES.values())} uses in {len(USES)} files, as the table says")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
