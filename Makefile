# SPDX-License-Identifier: Apache-2.0
# `make` is `make -f Makefile.sim`.
include Makefile.sim
