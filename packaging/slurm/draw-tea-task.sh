#!/usr/bin/env bash
# One task of the array that draw-tea.sh submits: draws its range of the kept frames. Slurm copies this file, so it
# uses no other. It may be stopped and started again at any moment: what is drawn stays.
#
# Usage, under Slurm: draw-tea-task.sh PROGRAM CACHE FRAMES FRAMES_PER_TASK COUNT [OPTION of "tea render"...]
set -euo pipefail

program="$1" cache="$2" frames="$3" per_task="$4" count="$5"
shift 5
first=$(((SLURM_ARRAY_TASK_ID - 1) * per_task + 1))
last=$((first + per_task - 1))
((last <= count)) || last=$count
printf '%s: frames %d to %d on %s\n' "$(date '+%F %T')" "$first" "$last" "$(uname -n)"
# In the shell's place, so that Slurm's signal to stop reaches the program, which then leaves whole files only.
exec "$program" tea render "$cache" --range "$first-$last" --frames "$frames" \
    --threads "${SLURM_CPUS_PER_TASK:-0}" --quiet "$@"
