#!/usr/bin/env bash
# Starts Pastoso as whoever has just installed it does, closes the start page, paints a line with the mouse, and tells how long it
# took until the window was there, and until the painting's journal (docs/journal-format.md) held the line. Takes a display and
# xdotool.
#
# Usage: packaging/first-stroke.sh PASTOSO
set -euo pipefail

readonly longest_ms=60000
home="$(mktemp -d)"
now_ms() { date +%s%3N; }
start_ms="$(now_ms)"
XDG_STATE_HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" XDG_CACHE_HOME="$home" "$1" >"$home/log" 2>&1 &
program=$!
stop_program() {
    kill -KILL "$program" 2>/dev/null || true
    wait "$program" 2>/dev/null || true
    rm -rf -- "$home"
}
trap stop_program EXIT

# wait_until WHAT COMMAND...: asks again and again, and tells the time since the start.
wait_until() {
    local what="$1" passed_ms
    until "${@:2}"; do
        passed_ms=$(($(now_ms) - start_ms))
        if ! kill -0 "$program" 2>/dev/null || ((passed_ms > longest_ms)); then
            cat "$home/log" >&2
            printf 'first-stroke.sh: after %d ms there was no %s.\n' "$passed_ms" "$what" >&2
            exit 1
        fi
    done
    passed_ms=$(($(now_ms) - start_ms))
    printf '%d.%d s after the start: %s\n' $((passed_ms / 1000)) $((passed_ms % 1000 / 100)) "$what"
}

find_window() { window="$(xdotool search --onlyvisible --pid "$program" 2>/dev/null | head -n 1)" && [[ -n $window ]]; }

# Once more each time: what is drawn before the window takes input is not heard.
paint_line() {
    local x
    xdotool windowfocus "$window" key Escape mousemove --window "$window" 500 400 mousedown 1
    for ((x = 510; x <= 700; x += 10)); do xdotool mousemove --window "$window" "$x" 400 sleep 0.01; done
    xdotool mouseup 1
    grep -qa '"samples":\[\[' "$home"/pastoso/journals/*/strokes.journal
}

wait_until "window" find_window
wait_until "paint on the canvas" paint_line
