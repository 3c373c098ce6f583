# SPDX-License-Identifier: Apache-2.0
"""What paths a mapped cell has: the cells of Yosys' 7-series, ECP5 and iCE40 libraries."""

import re

from tools import AreaError

# Types whose outputs depend on all inputs, at once.
LOGIC = re.compile(r"LUT[1-6]|INV|MUXF[78]|PFUMX|L6MUX21|SB_LUT4|MULT18X18D")
REGISTER = re.compile(r"FD\w+|TRELLIS_FF|SB_DFF\w*|RAMB18E1|RAMB36E1|DP16KD|SB_RAM40_4K")
# What an output depends on, where not on all: pins are ports with the number of their bit.
OUTPUTS = {
    "SB_CARRY": {"CO0": r"(I0|I1|CI)0"},
    "CCU2C": {"S00": r"([ABCD]0|CIN)0", "S10": r"([ABCD][01]|CIN)0", "COUT0": r"([ABCD][01]|CIN)0"},
    "CARRY4": {f"{port}{bit}": rf"(CI|CYINIT)0|(DI|S)[0-{bit}]" for port in ("O", "CO") for bit in range(4)},
}
# Storage that is read without a clock: by output, the address it is read at. All other inputs are kept.
STORAGE = {
    "SRL16E": {"Q0": r"A[0-3]0"},
    "SRLC32E": {"Q0": r"A\d", "Q310": r"-"},
    "RAM32X1D": {"SPO0": r"A\d0", "DPO0": r"DPRA\d0"},
    "RAM64X1D": {"SPO0": r"A\d0", "DPO0": r"DPRA\d0"},
    "RAM128X1D": {"SPO0": r"A\d", "DPO0": r"DPRA\d"},
    "RAM32M": {f"DO{bank}{bit}": rf"ADDR{bank}\d" for bank in "ABCD" for bit in range(2)},
    "RAM64M": {f"DO{bank}0": rf"ADDR{bank}\d" for bank in "ABCD"},
    "TRELLIS_DPR16X4": {f"DO{bit}": r"RAD\d" for bit in range(4)},
}


def add_cell(paths, cell):
    """Adds the paths of a cell of Yosys' JSON."""
    kind = cell["type"]
    pins = [(direction, f"{port}{number}", bit) for port, direction in cell["port_directions"].items()
            for number, bit in enumerate(cell["connections"].get(port, [])) if isinstance(bit, int)]
    inputs = [(pin, bit) for direction, pin, bit in pins if direction == "input"]
    outputs = [(pin, bit) for direction, pin, bit in pins if direction == "output"]
    if LOGIC.fullmatch(kind):
        connect(paths, inputs, outputs, {})
    elif kind in OUTPUTS:
        connect(paths, inputs, outputs, OUTPUTS[kind])
    elif kind in STORAGE:
        connect(paths, inputs, outputs, STORAGE[kind])
        for pin, bit in inputs:
            if not any(re.fullmatch(address, pin) for address in STORAGE[kind].values()):
                paths.end(bit)
        for _, bit in outputs:
            paths.start(bit, 1)
    elif kind == "DSP48E1":
        add_dsp(paths, cell["parameters"], inputs, outputs)
    elif REGISTER.fullmatch(kind):
        add_register(paths, inputs, outputs)
    else:
        raise AreaError(f"cell type {kind} has no rule: add it to rtl/synth/cells.py")


def connect(paths, inputs, outputs, needed):
    for pin, sink in outputs:
        for other, source in inputs:
            if pin not in needed or re.fullmatch(needed[pin], other):
                paths.arc(source, sink, 1)


def add_register(paths, inputs, outputs):
    for _, bit in inputs:
        paths.end(bit)
    for _, bit in outputs:
        paths.start(bit)


def add_dsp(paths, parameters, inputs, outputs):
    """Registers at the inputs, behind the multiplier and at the output are there or not."""
    registered = {name[:-3] for name, value in parameters.items() if name.endswith("REG") and int(value, 2)}
    for pin, bit in inputs:
        port = pin.rstrip("0123456789")
        if port in registered or not re.fullmatch(r"A|B|C|D|[ABP]CIN|OPMODE|ALUMODE|INMODE|CARRYIN", port):
            paths.end(bit)
        elif registered & {"M", "P"}:
            paths.end(bit, 1)
        else:
            connect(paths, [(pin, bit)], outputs, {})
    for _, bit in outputs:
        paths.start(bit, 0 if "P" in registered else 1)
