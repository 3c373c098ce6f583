# SPDX-License-Identifier: Apache-2.0
"""Longest paths between registers, in cells."""

import collections

from tools import AreaError


class Paths:
    """Longest paths over bits. `arcs`: bit -> [(bit, cells)]; `starts`, `ends`: bit -> cells on its side of a
    register."""

    def __init__(self):
        self.arcs = collections.defaultdict(list)
        self.starts, self.ends = {}, {}

    def arc(self, source, sink, cells):
        self.arcs[source].append((sink, cells))

    def start(self, bit, cells=0):
        self.starts[bit] = max(cells, self.starts.get(bit, 0))

    def end(self, bit, cells=0):
        self.ends[bit] = max(cells, self.ends.get(bit, 0))

    def order(self):
        """Bits with arcs, sources first."""
        waiting = collections.Counter(sink for arcs in self.arcs.values() for sink, _ in arcs)
        ready = [bit for bit in self.arcs if not waiting[bit]]
        done = []
        while ready:
            bit = ready.pop()
            done.append(bit)
            for sink, _ in self.arcs.get(bit, ()):
                waiting[sink] -= 1
                if not waiting[sink]:
                    ready.append(sink)
        if any(waiting.values()):
            raise AreaError("the mapped netlist has a combinational loop: look at the RTL, or at rtl/synth/cells.py")
        return done

    def arrivals(self, starts, order):
        """The longest path from `starts` to each bit that they reach."""
        found = dict(starts)
        for bit in order:
            if bit in found:
                for sink, cells in self.arcs.get(bit, ()):
                    found[sink] = max(found[bit] + cells, found.get(sink, 0))
        return found

    def departures(self, ends, order):
        """The longest path from each bit that reaches one of `ends`."""
        found = dict(ends)
        for bit in reversed(order):
            for sink, cells in self.arcs.get(bit, ()):
                if sink in found:
                    found[bit] = max(found[sink] + cells, found.get(bit, 0))
        return found
