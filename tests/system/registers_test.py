#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The package of the registers, the driver's header and the page's table are what rtl/system/registers.py prints, and
it refuses a table that is wrong. Usage: registers_test.py ROOT"""
import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1]).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "rtl" / "system"))
import registers  # noqa: E402

# A table each, and what has to be said of it.
WRONG = {"twice": ('[[register]]\nname = "a"\naddress = 0\naccess = "ro"\n' * 2, "a stands twice"),
         "access": ('[[register]]\nname = "a"\naddress = 0\naccess = "x"\n', "its access"),
         "address": ('[[register]]\nname = "a"\naddress = 2\naccess = "ro"\n', "no multiple of 4"),
         "same": ('[[register]]\nname = "a"\naddress = 0\naccess = "ro"\n[[register]]\nname = "b"\naddress = 0\n'
                  'access = "ro"\n', "at 0x0 is a"),
         "field": ('[[register]]\nname = "a"\naddress = 0\naccess = "ro"\n'
                   'fields = [["x", 0, 4, ""], ["y", 3, 1, ""]]\n', "a.y lies on another field")}


def faults():
    table = registers.registers()
    page = (ROOT / "docs" / "package.md").read_text()
    marked = re.search(r"<!-- registers -->\n(.*?)<!-- /registers -->", page, re.DOTALL)
    for name, text, form in (("rtl/system/hs_registers_pkg.sv", None, "sv"),
                             ("driver/halfspace_registers.h", None, "c"),
                             ("docs/package.md", marked.group(1) if marked else "", "markdown")):
        text = (ROOT / name).read_text() if text is None else text
        if text != getattr(registers, form)(table):
            yield f"{name} is not what `python3 rtl/system/registers.py {form}` prints"
    if len(table) < 20:
        yield f"only {len(table)} registers"
    with tempfile.TemporaryDirectory() as folder:
        for name, (text, says) in WRONG.items():
            path = pathlib.Path(folder) / f"{name}.toml"
            path.write_text(text)
            try:
                registers.registers(path)
                yield f"self-test: nothing is said of the table {name}"
            except registers.Fault as fault:
                if says not in str(fault):
                    yield f"self-test: {name}: {fault}"


def main():
    found = list(faults())
    print("\n".join(found) or "registers: package, header and page agree")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
