#!/usr/bin/env bash
# Paints the paintings of a folder again from their strokes, on finer or coarser cells, on many machines: one Slurm job
# array, each task of which paints one. What is there already is kept, so the same command resumes.
#
# Usage: packaging/slurm/paint-again.sh PAINTINGS RESULTS --px-per-mm N [OPTION...] [-- SBATCH_OPTION...]
#   PAINTINGS        folder with NAME.pastoso and so on; every machine sees it under the same path, as it does RESULTS
#   RESULTS          folder for NAME.pastoso, or NAME.png and so on
#   --px-per-mm N    cells per millimetre
#   --format NAME    pastoso, or an ending of pictures: png, tif, jpg, webp or exr (pastoso)
#   --cpus N         processors of one task (2)
#   --program FILE   pastoso-cli as every machine sees it; otherwise that on the PATH, or that of this build
#   --dry-run        only say what would be submitted
#   SBATCH_OPTION    handed on to sbatch, for example: -- --partition=night --mem=8G
source "$(dirname -- "${BASH_SOURCE[0]}")/../common.sh"
source "$root/packaging/slurm/farm.sh"

readonly most_tasks=1000  # as many as Slurm takes where nobody set MaxArraySize

places=() scheduling=()
px_per_mm="" format=pastoso cpus=2 program="" dry_run=no

read_arguments() {
    while [[ $# -gt 0 ]]; do
        case "$1" in
            -h | --help) print_help; exit 0 ;;
            --dry-run) dry_run=yes; shift ;;
            --) shift; scheduling=("$@"); return ;;
            --px-per-mm | --format | --cpus | --program)
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
        --px-per-mm)
            [[ $2 =~ ^[0-9]{1,2}(\.[0-9]{1,6})?$ ]] && awk "BEGIN { exit !($2 >= 0.25 && $2 <= 64) }" ||
                fail "$1: \"$2\" is not a number of cells per millimetre from 0.25 to 64."
            px_per_mm="$2" ;;
        --format)
            [[ $2 =~ ^(pastoso|png|tif|jpg|webp|exr)$ ]] || fail "$1: \"$2\" is none of pastoso, png, tif, jpg, webp and exr."
            format="$2" ;;
        --cpus) whole_number "$1" "$2"; cpus="$2" ;;
        --program) program="$2" ;;
    esac
}

# Task n paints the n-th of `paintings`: those that are not there yet, as many as an array takes.
list_paintings() {
    local painting name
    shopt -s nullglob
    local all=("$source"/*.pastoso)
    ((${#all[@]} > 0)) || fail "\"$source\" holds no paintings: no file in it ends in .pastoso."
    paintings=() missing=0
    for painting in "${all[@]}"; do
        name="$(basename -- "$painting" .pastoso)"
        [[ $name != *$'\n'* ]] || fail "\"$source\" holds a painting with a line break in its name."
        [[ ! -e $results/$name.$format ]] || continue
        missing=$((missing + 1))
        ((missing > most_tasks)) || paintings+=("$painting")
    done
}

# A folder is of one resolution, or nobody could tell what is missing in it.
check_results() {
    local cells="$results/slurm/px-per-mm"
    [[ ! -e $cells || $(<"$cells") == "$px_per_mm" ]] ||
        fail "\"$results\" holds paintings on $(<"$cells") cells per millimetre; name another folder."
}

# Tasks find their painting by their number, whatever comes into the folder meanwhile.
write_list() {
    mkdir -p -- "$results/slurm" || fail "\"$results\" cannot be made."
    printf '%s\n' "$px_per_mm" >"$results/slurm/px-per-mm" || fail "\"$results/slurm\" cannot be written into."
    list="$(mktemp -- "$results/slurm/paintings-XXXXXX")" || fail "\"$results/slurm\" cannot be written into."
    printf '%s\n' "${paintings[@]}" >"$list"
}

read_arguments "$@"
[[ ${#places[@]} -eq 2 ]] || fail "give the folder of paintings and a folder for the results; --help tells the rest."
[[ -n $px_per_mm ]] || fail "--px-per-mm N says on how many cells per millimetre they are painted."
[[ -d ${places[0]} ]] || fail "there is no folder \"${places[0]}\"."
source="$(realpath -- "${places[0]}")"
results="$(realpath -m -- "${places[1]}")"
[[ $source != "$results" ]] || fail "\"$source\" holds the paintings themselves; name another folder for the results."
find_program
check_results
list_paintings
if ((missing == 0)); then
    say "All paintings stand in $results; nothing is left to paint."
    exit 0
fi
list="$results/slurm/paintings"
[[ $dry_run == yes ]] || { check_sbatch; write_list; }
tasks="1-${#paintings[@]}"
submit_tasks pastoso-paint "$cpus" "$results" "$root/packaging/slurm/paint-again-task.sh" "$program" "$list" "$results" \
    "$px_per_mm" "$format"
say "${#paintings[@]} of $missing paintings to paint at $px_per_mm cells per millimetre: job $job"
tell_job "$results" painted
