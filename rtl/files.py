#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The files that a tool reads for a module: the package of a configuration first, then modules, each after those that
it instantiates. halfspace.core (FuseSoC) and Bender.yml are printed from the same list, and committed.

A module in a branch that a configuration does not take is in its list too: only elaboration knows which those are."""
import argparse
import pathlib
import re
import sys

sys.dont_write_bytecode = True  # no __pycache__ between the sources
from units import BESIDE, RTL, WHOLES, ordered  # noqa: E402

CONFIGS, DEFAULT = ("low", "middle", "high"), "middle"
TOP = "hs_pipeline"
PROJECT = re.compile(r'^project\(halfspace VERSION ([\d.]+) DESCRIPTION "([^"]+)"', re.MULTILINE)


class Fault(Exception):
    """A sentence."""


def closure(top, rtl=RTL):
    """{stem: path} of a module and of all below it, each after those that it instantiates."""
    found = ordered([top], rtl)
    if not found:
        raise Fault(f"there is no module {top} in {rtl}")
    return found


def package_of(config, rtl=RTL):
    """The package of a named configuration, or `config` itself, which is a file."""
    named = rtl / "formats" / config / "hs_formats_pkg.sv"
    path = named if named.is_file() else pathlib.Path(config).resolve()
    if not path.is_file():
        raise Fault(f"there is no configuration {config}: name one of {', '.join(CONFIGS)}, or a file that `halfspace "
                    "package` printed")
    return path


def project(root):
    """Version and description."""
    lists = root / "CMakeLists.txt"
    found = PROJECT.search(lists.read_text()) if lists.is_file() else None
    if not found:
        raise Fault(f"{lists} has no line project(halfspace VERSION … DESCRIPTION …): print halfspace.core and "
                    "Bender.yml in the source tree")
    return found.groups()


def filesets(rtl=RTL):
    """{name: paths below the root of the project}: the pipeline, and what each module beside it or around it has
    besides."""
    sets, listed = {}, set()
    for top in (TOP, *(f"hs_{unit}" for unit in (*BESIDE, *WHOLES))):
        new = {stem: path for stem, path in closure(top, rtl).items() if stem not in listed}
        listed.update(new)
        sets[top.removeprefix("hs_")] = [f"rtl/{path.relative_to(rtl)}" for path in new.values()]
    return sets


def package_path(config):
    return f"rtl/formats/{config}/hs_formats_pkg.sv"


def lines_of(names, indent):
    return "".join(f"{indent}- {name}\n" for name in names)


def core(rtl=RTL):
    version, description = project(rtl.parent)
    text = ["CAPI=2:\n# SPDX-License-Identifier: Apache-2.0\n"
            "# FuseSoC. Printed by `rtl/files.py --format core`: change the modules, not this.\n"
            "# Targets: hs_pipeline of a named configuration, its lint, and `modules`, to which you add a package\n"
            "# that `halfspace package` printed.\n"
            f'name: "::halfspace:{version}"\ndescription: "{description}"\n\nfilesets:\n']
    for config in CONFIGS:
        text.append(f"  {config}:\n    files:\n      - {package_path(config)}\n    file_type: systemVerilogSource\n")
    for name, paths in filesets(rtl).items():
        text.append(f"  {name}:\n    files:\n{lines_of(paths, '      ')}    file_type: systemVerilogSource\n")
    text.append("  waivers:\n    files:\n      - tb/lint.vlt\n    file_type: vlt\n\ntargets:\n")
    parameters = "    parameters: [LanesX, LanesY]\n"
    for target, config in [("default", DEFAULT), *((config, config) for config in CONFIGS)]:
        text.append(f"  {target}:\n    filesets: [{config}, pipeline]\n    toplevel: {TOP}\n{parameters}")
    for config in CONFIGS:
        text.append(f"  lint_{config}:\n    default_tool: verilator\n    filesets: [{config}, pipeline, waivers]\n"
                    f"    toplevel: {TOP}\n{parameters}"
                    "    tools:\n      verilator:\n        mode: lint-only\n        verilator_options: [-Wall]\n")
    text.append(f"  modules:\n    filesets: [{', '.join(filesets(rtl))}]\n    toplevel: {TOP}\n{parameters}"
                "\nparameters:\n")
    for side in "XY":
        text.append(f"  Lanes{side}:\n    datatype: int\n    default: 2\n    paramtype: vlogparam\n"
                    f"    description: Pixels of a stamp in {side.lower()}\n")
    return "".join(text)


def bender(rtl=RTL):
    version, description = project(rtl.parent)
    others = ", ".join(f"not({config})" for config in CONFIGS if config != DEFAULT)
    text = ["# SPDX-License-Identifier: Apache-2.0\n"
            f"# halfspace {version} for Bender. Printed by `rtl/files.py --format bender`: change modules, not this.\n"
            f"# Targets: {', '.join(CONFIGS)}: the package of a configuration, {DEFAULT} if none is named;\n"
            "# own_package: none of these, for one that `halfspace package` printed, which you list in your sources;\n"
            f"# {', '.join(BESIDE)}: the unit beside the pipeline too;\n"
            f"# {', '.join(WHOLES)}: what stands round the pipeline.\n"
            f'package:\n  name: halfspace\n  description: "{description}"\n  authors: ["the authors of halfspace"]\n\n'
            "sources:\n"]
    for config in CONFIGS:
        target = f"all({others}, not(own_package))" if config == DEFAULT else config
        text.append(f"  - target: {target}\n    files:\n      - {package_path(config)}\n")
    for name, paths in filesets(rtl).items():
        target = "" if f"hs_{name}" == TOP else f"target: {name}\n    "
        text.append(f"  - {target}files:\n{lines_of(paths, '      ')}")
    return "".join(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--config", default=DEFAULT, help="low, middle, high, or a package file (default: %(default)s)")
    parser.add_argument("--top", default=TOP, help="module or unit (default: %(default)s)")
    parser.add_argument("--format", default="f", choices=["f", "core", "bender", "cmake"],
                        help="a file list for -f, FuseSoC, Bender, or set(HALFSPACE_RTL …) (default: %(default)s)")
    args = parser.parse_args()
    try:
        if args.format in ("core", "bender"):
            sys.stdout.write(core() if args.format == "core" else bender())
            return 0
        top = args.top if args.top.startswith("hs_") else f"hs_{args.top}"
        paths = [str(path) for path in [package_of(args.config), *closure(top).values()]]
        quoted = "".join(f'  "{path}"\n' for path in paths)
        print("\n".join(paths) if args.format == "f" else f"set(HALFSPACE_RTL\n{quoted})")
        return 0
    except Fault as fault:
        print(f"files: {fault}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())
