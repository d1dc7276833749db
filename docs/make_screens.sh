#!/usr/bin/env bash
# Makes pictures of the window, of every panel, menu and dialog, in each language, theme and scale, and sheets of them:
#     docs/make_screens.sh FOLDER
# FOLDER/de-dark-1.25/dialog-settings.png is the settings dialog in German, dark, at a scale of 1.25; FOLDER/sheet-*.png
# show many at once where imagemagick is there. LANGUAGES, THEMES and SCALES choose fewer. Needs build/bin/test_gui, no
# display. Look at them after every change of what the window shows; nobody else does.
set -euo pipefail
[ $# = 1 ] || { sed -n '2,6s/^# \{0,1\}//p' "$0"; exit 2; }
mkdir -p "$1"
out=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
program=${TEST_GUI:-build/bin/test_gui}
for scale in ${SCALES:-1 1.25 1.5 2}; do
    for language in ${LANGUAGES:-en de}; do
        for theme in ${THEMES:-dark light}; do
            folder=$out/$language-$theme-$scale
            QT_QPA_PLATFORM=offscreen QT_SCALE_FACTOR=$scale LACUNA_SHOTS=$folder LACUNA_SHOTS_LANGUAGE=$language \
                LACUNA_SHOTS_THEME=$theme "$program" --gtest_brief=1 --gtest_filter='GalleryTest.*'
            if command -v montage >/dev/null; then
                for kind in window dialog menu; do
                    montage "$folder/$kind"-*.png -tile 3x -geometry '900x700>+8+8' -background gray40 \
                        "$out/sheet-$kind-$language-$theme-$scale.png"
                done
            fi
        done
    done
done
