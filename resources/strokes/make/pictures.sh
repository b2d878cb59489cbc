#!/bin/sh
# Renders the pictures of the examples on the start page anew, from the recordings as they are.
# usage: pictures.sh PASTOSO-CLI
set -eu
strokes=$(cd "$(dirname "$0")/.." && pwd)
for example in still-life surf poppies evening; do
    "$1" replay "$strokes/$example.json" --quiet --scale 0.5 -o "$strokes/$example.png"
done
