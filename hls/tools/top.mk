# SPDX-License-Identifier: Apache-2.0
# What every tool is given of a top: its sources, macros and vectors. A makefile for a tool includes this.
#
#   TOP     a name of hls/top/tops.txt
#   CONFIG  low, middle, high or a .toml file, from the root of the project; that of the list if none is given
#   LANES   pixels a stamp
ROOT := $(abspath $(dir $(lastword $(MAKEFILE_LIST)))/../..)
HALFSPACE ?= $(ROOT)/build/cli/halfspace
OUT := $(ROOT)/build/hls
TOP ?=
LANES ?= 1

TOPS := $(shell sed '/^\#/d; s/ .*//' $(ROOT)/hls/top/tops.txt)
ROW := $(shell awk '$$1 == "$(TOP)"' $(ROOT)/hls/top/tops.txt)
SCENE := $(word 2,$(ROW))
CONFIG ?= $(word 3,$(ROW))
# One file, as Bambu composes what it sees at once.
FILE := $(if $(TOP),$(wildcard $(ROOT)/hls/top/$(TOP)_top.cpp $(ROOT)/hls/top/film/$(TOP)_top.cpp \
                             $(ROOT)/hls/top/composed/$(TOP)_top.cpp))
ifneq ($(TOP),)
ifeq ($(ROW),)
$(error TOP=$(TOP): the tops are $(TOPS))
endif
endif
BENCH := $(ROOT)/hls/top/bench/main.cpp $(ROOT)/hls/top/bench/bench.cpp

# lit_low is LitLow in C++. A configuration of its own has a header, which is printed.
NAME := $(basename $(notdir $(CONFIG)))
TYPE := $(shell echo $(NAME) | sed -E 's/(^|_)([a-z0-9])/\U\2/g')
TOML := $(if $(filter %.toml,$(CONFIG)),$(if $(filter /%,$(CONFIG)),,$(ROOT)/)$(CONFIG))
HEADER := $(if $(TOML),$(OUT)/headers/$(NAME).hpp)
DEFINES := -DHALFSPACE_TOP_CONFIG=$(TYPE) -DHALFSPACE_TOP_STAMP=Stamp$(LANES)
DEFINES += $(if $(HEADER),-DHALFSPACE_TOP_HEADER=$(notdir $(HEADER)))
INCLUDES := -I$(ROOT) $(if $(HEADER),-I$(OUT)/headers)
VECTORS := $(OUT)/vectors/$(NAME).$(SCENE).$(LANES)
# What a tool reads of the project: a change means another run.
READ := $(FILE) $(BENCH) $(HEADER) $(shell find $(ROOT)/hls -name '*.hpp' -o -name '*_top.cpp')

# The first target of a makefile for a tool.
.PHONY: help known program
help:
	@sed -n '2,/^[^#]/s/^# \?//p' $(firstword $(MAKEFILE_LIST))
	@echo
	@echo "tops: $(TOPS)"

known:
	@[ -n "$(TOP)" ] || { echo "TOP=name: the tops are $(TOPS)." >&2; exit 2; }

program:
	@[ -x "$(HALFSPACE)" ] || { echo "$(HALFSPACE) is not there: \`make build\`, or HALFSPACE=path." >&2; exit 2; }

$(OUT)/headers/%.hpp: $(TOML) | known program
	@mkdir -p $(@D)
	$(HALFSPACE) config $(TOML) --header $@

$(VECTORS)/manifest.json: $(TOML) $(wildcard $(HALFSPACE)) | known program
	@mkdir -p $(@D)
	$(HALFSPACE) vectors $(SCENE) --config $(or $(TOML),$(CONFIG)) --lanes $(LANES) --out $(@D) > $(VECTORS).log
