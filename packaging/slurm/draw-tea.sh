#!/usr/bin/env bash
# Draws the frames that "pastoso-cli tea --cache CACHE" kept, on many machines: one Slurm job array, each task of
# which draws its own range into FRAMES. What is there already is kept, so the same command resumes.
#
# Usage: packaging/slurm/draw-tea.sh CACHE FRAMES [OPTION...] [-- SBATCH_OPTION...]
#   CACHE            the folder of kept frames; every machine sees it under the same path, as it does FRAMES
#   FRAMES           folder for milk_0001.png and so on
#   --per-task N     frames of one task; otherwise 30, or more where that would be over 1000 tasks
#   --cpus N         processors of one task (2)
#   --program FILE   pastoso-cli as every machine sees it; otherwise that on the PATH, or that of this build
#   --dry-run        only say what would be submitted
#   --format NAME, --size WxH, --samples N, --pbrt N, --every N   as of "pastoso-cli tea render"
#   SBATCH_OPTION    handed on to sbatch, for example: -- --partition=night --time=2:00:00
source "$(dirname -- "${BASH_SOURCE[0]}")/../common.sh"
source "$root/packaging/slurm/farm.sh"

readonly too_long="Where it is about the array's size, --per-task makes it shorter."
readonly most_tasks=1000  # as many as Slurm takes where nobody set MaxArraySize

places=() drawing=() scheduling=()
per_task="" cpus=2 program="" every=1 format=png dry_run=no

read_arguments() {
    while [[ $# -gt 0 ]]; do
        case "$1" in
            -h | --help) print_help; exit 0 ;;
            --dry-run) dry_run=yes; shift ;;
            --) shift; scheduling=("$@"); return ;;
            --per-task | --cpus | --program | --format | --size | --samples | --pbrt | --every)
                [[ $# -ge 2 ]] || fail "$1 needs a value after it."
                read_option "$1" "$2"
                shift 2 ;;
            -*) refuse_argument "$1" ;;
            *) places+=("$1"); shift ;;
        esac
    done
}

read_option() {
    case "$1" in
        --per-task) whole_number "$1" "$2"; per_task="$2" ;;
        --cpus) whole_number "$1" "$2"; cpus="$2" ;;
        --program) program="$2" ;;
        --every) whole_number "$1" "$2"; every="$2"; drawing+=("$1" "$2") ;;
        --format) format="$2"; drawing+=("$1" "$2") ;;
        *) drawing+=("$1" "$2") ;;
    esac
}

# Frames of the sequence, as its index has it: one key a line at the outermost level.
count_frames() {
    local index="$cache/tea.json"
    [[ -f $index ]] || fail "\"$cache\" keeps no tea: there is no tea.json in it; \"pastoso-cli tea --cache\" fills such a folder."
    grep -q '^  "format": "pastoso-tea-cache",\?$' "$index" || fail "\"$index\" is not the index of kept tea."
    count="$(sed -n 's/^  "count": \([0-9]\{1,7\}\),\{0,1\}$/\1/p' "$index")"
    [[ -n $count ]] || fail "\"$index\" does not say how many frames there are."
    ((count >= every)) || fail "\"$cache\" has $count frames, of which --every $every draws none."
}

# Kept frames take their names when they are whole, so one that is there can be drawn.
check_cache_is_whole() {
    local frame missing=0 first_missing=""
    for ((frame = every; frame <= count; frame += every)); do
        [[ -s $(printf '%s/frame_%06d.tea' "$cache" "$frame") ]] && continue
        missing=$((missing + 1))
        [[ -n $first_missing ]] || first_missing="$frame"
    done
    ((missing == 0)) ||
        fail "\"$cache\" is not whole: $missing of $count frames are missing, the first is $first_missing; run \"pastoso-cli tea --cache\" again, which goes on."
}

is_drawn() {
    local name="milk_%04d.$format"
    [[ $format != pbrt-scene ]] || name="scene_%04d.pbrt"
    # shellcheck disable=SC2059
    [[ -e $frames/$(printf "$name" "$1") ]]
}

# The tasks that there are to do, as sbatch wants them, "1-3,7": `tasks`, and how many: `task_count`. Between
# begin_tasks and end_tasks come calls of add_task NUMBER, in ascending order; the same number may come again.
begin_tasks() {
    tasks="" task_count=0 last_task=0 run_start=0
}

add_task() {
    (($1 != last_task)) || return 0
    task_count=$((task_count + 1))
    if (($1 != last_task + 1 || run_start == 0)); then
        end_tasks
        run_start=$1
    fi
    last_task=$1
}

end_tasks() {
    ((run_start > 0)) || return 0
    tasks+="${tasks:+,}$run_start"
    ((last_task == run_start)) || tasks+="-$last_task"
}

# Those that have something to draw, and how many frames: `wanted`.
list_tasks() {
    local frame
    wanted=0
    begin_tasks
    for ((frame = every; frame <= count; frame += every)); do
        is_drawn "$frame" && continue
        wanted=$((wanted + 1))
        add_task $(((frame - 1) / per_task + 1))
    done
    end_tasks
}

read_arguments "$@"
[[ ${#places[@]} -eq 2 ]] || fail "give the folder of kept frames and a folder for what is drawn; --help tells the rest."
[[ -d ${places[0]} ]] || fail "there is no folder \"${places[0]}\"."
cache="$(realpath -- "${places[0]}")"
frames="$(realpath -m -- "${places[1]}")"
find_program
count_frames
[[ -n $per_task ]] || per_task=$((count > 30 * most_tasks ? (count + most_tasks - 1) / most_tasks : 30))
check_cache_is_whole
list_tasks
if ((wanted == 0)); then
    say "All frames stand in $frames; nothing is left to draw."
    exit 0
fi
[[ $dry_run == yes ]] || check_sbatch
submit_tasks pastoso-tea "$cpus" "$frames" "$root/packaging/slurm/draw-tea-task.sh" "$program" "$cache" "$frames" \
    "$per_task" "$count" "${drawing[@]}"
say "$wanted frames to draw, $task_count tasks of up to $per_task frames: job $job"
tell_job "$frames" drawn
