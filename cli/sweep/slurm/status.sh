#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# What became of a Slurm job, in Snakemake's words: without it a job that was cancelled or killed is waited for without
# end. A controller that does not answer says nothing about the job.
case $(scontrol --oneliner show job "$1" 2> /dev/null | sed -n 's/.* JobState=\([A-Z_]*\).*/\1/p') in
  COMPLETED) echo success ;;
  PENDING | CONFIGURING | RUNNING | COMPLETING | SUSPENDED | REQUEUED | '') echo running ;;
  *) echo failed ;;
esac
