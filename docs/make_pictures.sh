#!/usr/bin/env bash
# Makes the pictures of README.md with the commands it names. Needs build/bin (./run builds it); the window's pictures
# also need xvfb and imagemagick, those of the walk build/bin/test_gui too, and are left as they are without them.
set -euo pipefail
cd "$(dirname "$0")/.."
lacuna=${LACUNA:-build/bin/lacuna}
mkdir -p docs/images
for sample in casting head; do
    for mode in iso ea mip shear-warp; do
        "$lacuna" render "sample:$sample@192" --mode "$mode" --azimuth 30 --elevation 20 --zoom 1.5 --size 400x400 \
            -o "docs/images/$sample-$mode.png"
    done
done
"$lacuna" render sample:casting@192 --mode iso --azimuth 30 --elevation 20 --zoom 1.5 --size 400x400 \
    --cut 0,1,0,0 -o docs/images/casting-cut.png
"$lacuna" bench sample:casting --quick --chart docs/images/bench-casting.png --quiet

if command -v Xvfb >/dev/null && command -v import >/dev/null; then
    Xvfb :97 -screen 0 1480x940x24 >/dev/null 2>&1 &
    server=$!
    sleep 1
    DISPLAY=:97 QT_QPA_PLATFORM=xcb "${lacuna%lacuna}lacuna-workstation" sample:head &
    window=$!
    sleep 12   # the window shows no sign of its own that a picture is final
    DISPLAY=:97 import -window root -quality 95 docs/images/window.png
    kill "$window" "$server"
    # The steps of the newcomer's path, each as tests/gui/walk_test.cpp finds it.
    if [ -x "${lacuna%lacuna}test_gui" ]; then
        walk=$(mktemp -d)
        QT_QPA_PLATFORM=xcb LACUNA_SHOTS=$walk xvfb-run -a -s "-screen 0 1480x940x24" "${lacuna%lacuna}test_gui" \
            --gtest_filter='WalkTest.From*' >/dev/null
        for step in 4-measure 5-inspect; do cp "$walk/walk-$step.png" docs/images/; done
        rm -r "$walk"
    fi
fi
