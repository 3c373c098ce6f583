# SPDX-License-Identifier: Apache-2.0
"""Runs of Yosys and nextpnr: one part, one target; each once, its result kept in the cache."""

import concurrent.futures
import dataclasses
import json
import pathlib
import tempfile

import clock
import netlist
from rtlil import TOP, reordered
from targets import TARGETS, counts
from tools import Cache, run, say

# The sources of this tool that a count depends on, and those that a clock does besides.
RULES = ("cells", "netlist", "paths", "rtlil"), ("clock",)


@dataclasses.dataclass
class Job:
    """One part mapped for one target, and placed if a clock is wanted."""
    part: object
    target: str
    clock: bool
    title: str


class Runner:
    """Runs jobs, each once, and keeps what they give in the cache."""

    def __init__(self, args):
        self.args, self.cache = args, Cache(args.cache)
        self.yosys = run([args.yosys, "-V"], "area").strip()
        self.nextpnr = run([args.nextpnr, "--version"], "area").strip() if args.clock else None
        here = pathlib.Path(__file__).resolve().parent
        self.counting, self.timing = ([(here / f"{name}.py").read_text() for name in names] for names in RULES)

    def keys(self, job):
        """The key of the counts, and that of the clock or None."""
        target = TARGETS[job.target]
        area = Cache.key(self.yosys, target.to_gates, target.to_luts, self.args.tries, self.counting, job.part.text)
        return area, Cache.key(area, self.nextpnr, self.timing, self.args.seed) if job.clock else None

    def known(self, job):
        area, timing = self.keys(job)
        counted, timed = self.cache.load(area), self.cache.load(timing) if timing else {}
        return None if counted is None or timed is None else {**counted, **timed}

    def run(self, jobs):
        """The results of the jobs, in their order."""
        found = {self.keys(job): self.known(job) for job in jobs}
        missing = {self.keys(job): job for job in jobs if found[self.keys(job)] is None}
        with concurrent.futures.ThreadPoolExecutor(self.args.jobs) as pool:
            running = {key: pool.submit(self.work, job, f"{number} of {len(missing)}")
                       for number, (key, job) in enumerate(missing.items(), 1)}
            try:
                found.update((key, future.result()) for key, future in running.items())
            except BaseException:
                pool.shutdown(cancel_futures=True)
                raise
        return [found[self.keys(job)] for job in jobs]

    def work(self, job, progress):
        say(f"{job.title} ({progress})")
        area, timing = self.keys(job)
        with tempfile.TemporaryDirectory(prefix="halfspace-area-") as folder:
            folder = pathlib.Path(folder)
            best, result = self.map(job, folder)
            self.cache.store(area, result)
            if job.clock:
                number = counts(job.target, result["cells"])
                timed = clock.place_and_route(self.args.nextpnr, folder / f"clocked{best}.json", self.args.seed,
                                              number["lut"], number["bram"])
                self.cache.store(timing, timed)
                result = {**result, **timed}
            return result

    def map(self, job, folder):
        """The try with the fewest LUTs, and what was measured of it."""
        yosys, target = [self.args.yosys, "-q", "-p"], TARGETS[job.target]
        (folder / "part.il").write_text(job.part.text)
        run([*yosys, f'read_rtlil "{folder}/part.il"; {target.to_gates}; write_rtlil "{folder}/gates.il"'], job.title)
        gates = (folder / "gates.il").read_text()
        if job.clock:
            (folder / "frame.v").write_text(clock.frame(job.part.ports))
        script = []
        for number in range(self.args.tries):
            (folder / f"gates{number}.il").write_text(reordered(gates, number))
            script += ["design -reset", f'read_rtlil "{folder}/gates{number}.il"', target.to_luts,
                       f'json -o "{folder}/part{number}.json" {TOP}']
            if job.clock:
                script += [f'read_verilog "{folder}/frame.v"', "hierarchy -top clocked", "flatten", "opt_clean -purge",
                           f'json -o "{folder}/clocked{number}.json" clocked']
        run([*yosys, "; ".join(script)], job.title)
        results = [netlist.measure(json.loads((folder / f"part{number}.json").read_text())["modules"][TOP])
                   for number in range(self.args.tries)]
        return min(enumerate(results),
                   key=lambda tried: (counts(job.target, tried[1]["cells"])["lut"], tried[1]["depth"]))
