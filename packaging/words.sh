#!/usr/bin/env bash
# Brings the files of the translators up to date: resources/translations/*.ts with the words in the code, and
# docs/manual/translations/*.po with the manual. What is new stands there as unfinished, and what was translated stays.
#
# Usage: packaging/words.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

case "${1-}" in
    -h | --help) print_help; exit 0 ;;
    "") ;;
    *) refuse_argument "$1" ;;
esac

lupdate="$(qmake6 -query QT_INSTALL_BINS 2>/dev/null)/lupdate"
[[ -x "$lupdate" ]] || fail "there is no lupdate; packaging/install.sh build installs it."
cd "$root"
scratch="$(mktemp --directory)"
trap 'rm -rf "$scratch"' EXIT
packaging/engine_words.py list "$scratch/engine_words.cpp"
for language in en ja sv zh_TW; do
    "$lupdate" -silent -locations none -no-obsolete -tr-function-alias QT_TR_NOOP+=PASTOSO_WORDS -tr-function-alias QT_TR_NOOP+=step_name app engine/document/actions tests/screens/keys_table.cpp "$scratch/engine_words.cpp" -ts "resources/translations/pastoso_$language.ts" \
        -source-language en -target-language "$language" 2>&1 |
        sed '/lacks Q_OBJECT macro/d; /Qualifying with unknown/d'  # of tables that are translated by their namespace
done
po4a --quiet --no-translations --master-charset UTF-8 --localized-charset UTF-8 --porefs file --wrap-po no --msgid-bugs-address "" \
    --package-name Pastoso --package-version manual --copyright-holder "The Pastoso authors" docs/manual/translations/po4a.cfg
