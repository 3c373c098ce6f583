#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each fault of the list is told by the row that it is said to be told by; the kernels as they are, by none.
Usage: fault_test.py LIST CONFIGS DRIVER FAULTY... (drivers whose names end with that of their fault)"""
import pathlib
import subprocess
import sys

from patch import read_faults


def rows(driver, config):
    run = subprocess.run([driver, config], capture_output=True, text=True, timeout=300, check=False)
    if run.returncode not in (0, 1):
        sys.exit(f"{driver} {config} ended with {run.returncode}: {run.stderr}")
    return run.stdout.splitlines()


def main():
    path, configs, driver, *faulty = sys.argv[1:]
    faults = {fault["fault"]: fault for fault in read_faults(path)}
    config_of = {file.stem: file for file in pathlib.Path(configs).glob("*/*.toml")}
    wrong, sound = [], set()
    for program in faulty:
        fault = faults[pathlib.Path(program).name.split("-")[-1]]
        config = config_of[fault["config"]]
        if config not in sound and (alarm := rows(driver, config)):
            wrong.append(f"without a fault {config.name} does not hold: {', '.join(alarm)}")
        sound.add(config)
        told = rows(program, config)
        print(f"{fault['fault']}: {', '.join(told) or 'nothing'}")
        if fault["row"] not in told:
            wrong.append(f"{fault['fault']} ({fault['why']}): {fault['row']} does not tell of it")
    if not faulty:
        wrong.append("no faults")
    sys.exit("\n".join(wrong) or 0)


if __name__ == "__main__":
    main()
