#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints registers.toml as the package of the RTL, as the header of the driver, or as a table of the documentation.
The three are committed: rtl/system/hs_registers_pkg.sv, driver/halfspace_registers.h, and between the marks of
docs/package.md.

Usage: registers.py sv|c|markdown"""
import pathlib
import re
import sys
import tomllib

TABLE = pathlib.Path(__file__).resolve().parent / "registers.toml"
ACCESS = ("ro", "rw", "wo", "w1c")


class Fault(Exception):
    """A sentence."""


def registers(path=TABLE):
    """The table, checked: names once, addresses and fields apart from each other."""
    found, names, taken = tomllib.loads(path.read_text())["register"], set(), {}
    for register in found:
        name = register["name"]
        if name in names or not re.fullmatch(r"[a-z][a-z_0-9]*", name):
            raise Fault(f"{name} stands twice, or is no name")
        names.add(name)
        if register["access"] not in ACCESS:
            raise Fault(f"{name}: its access is none of {', '.join(ACCESS)}")
        for i in range(len(register.get("clients", [0]))):
            address = register["address"] + 4 * i
            if address % 4 or address in taken:
                raise Fault(f"{name}: at {address:#x} is {taken.get(address, 'no multiple of 4')}")
            taken[address] = name
        bits = set()
        for field, lsb, width, _ in register.get("fields", []):
            of_field = set(range(lsb, lsb + width))
            if bits & of_field or lsb + width > 32:
                raise Fault(f"{name}.{field} lies on another field, or beyond 32 bits")
            bits |= of_field
    return found


def camel(name):
    return "".join(word.capitalize() for word in name.split("_"))


def sv(table):
    top = max(register["address"] + 4 * len(register.get("clients", [0])) for register in table)
    bits = (top - 1).bit_length()
    lines = ["// SPDX-License-Identifier: Apache-2.0",
             "// Addresses and fields of the registers. Printed by rtl/system/registers.py from registers.toml:",
             "// change that, not this file.", "package hs_registers_pkg;",
             f"  localparam int unsigned AddressBits = {bits};"]
    for register in table:
        name = camel(register["name"])
        lines.append(f"\n  localparam logic [{bits - 1}:0] {name} = {bits}'h{register['address']:02x};")
        if "clients" in register:
            lines.append(f"  localparam int unsigned {name}Clients = {len(register['clients'])};")
        for field, lsb, width, _ in register.get("fields", []):
            lines += [f"  localparam int unsigned {name}{camel(field)} = {lsb};",
                      f"  localparam int unsigned {name}{camel(field)}Bits = {width};"]
    return "\n".join(lines) + "\nendpackage\n"


def c(table):
    lines = ["/* SPDX-License-Identifier: Apache-2.0 */",
             "/* Addresses and fields of the registers of hs_system. Printed by rtl/system/registers.py from",
             "   registers.toml: change that, not this file. */", "#ifndef HALFSPACE_DRIVER_HALFSPACE_REGISTERS_H_",
             "#define HALFSPACE_DRIVER_HALFSPACE_REGISTERS_H_", ""]
    for register in table:
        name = "HS_" + register["name"].upper()
        lines.append(f"#define {name} 0x{register['address']:02x}u")
        for i, client in enumerate(register.get("clients", [])):
            lines.append(f"#define {name}_{client.upper()} {i}u")
        for field, lsb, width, _ in register.get("fields", []):
            lines += [f"#define {name}_{field.upper()}_LSB {lsb}u",
                      f"#define {name}_{field.upper()}_MASK 0x{((1 << width) - 1) << lsb:x}u"]
    return "\n".join([*lines, "", "#endif /* HALFSPACE_DRIVER_HALFSPACE_REGISTERS_H_ */", ""])


def markdown(table):
    lines = ["| address | register | access | bits | what |", "|---|---|---|---|---|"]
    for register in table:
        name, address = register["name"], register["address"]
        clients = register.get("clients", [])
        where = f"{address:#04x}" + (f" … {address + 4 * len(clients) - 4:#04x}" if clients else "")
        what = register["what"] + (": " + ", ".join(clients) if clients else "")
        lines.append(f"| {where} | `{name}` | {register['access']} | | {what} |")
        for field, lsb, width, meaning in register.get("fields", []):
            bits = f"{lsb + width - 1}:{lsb}" if width > 1 else f"{lsb}"
            lines.append(f"| | `{name}.{field}` | | {bits} | {meaning} |")
    return "\n".join(lines) + "\n"


def main():
    forms = {"sv": sv, "c": c, "markdown": markdown}
    if len(sys.argv) != 2 or sys.argv[1] not in forms:
        print(f"registers: say one of {', '.join(forms)}", file=sys.stderr)
        return 2
    try:
        sys.stdout.write(forms[sys.argv[1]](registers()))
        return 0
    except Fault as fault:
        print(f"registers: {TABLE}: {fault}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
