<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>lacuna::ui::InspectionPanel</name>
    <message numerus="yes">
        <source>%n defect(s)</source>
        <translation>
            <numerusform>%n defect</numerusform>
            <numerusform>%n defects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n decided by hand</source>
        <translation>
            <numerusform>%n decided by hand</numerusform>
            <numerusform>%n decided by hand</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::LimitsFeature</name>
    <message numerus="yes">
        <source>The scene on screen meets %n of these failures:</source>
        <translation>
            <numerusform>The scene on screen meets %n of these failures:</numerusform>
            <numerusform>The scene on screen meets %n of these failures:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::MeasureFeature</name>
    <message numerus="yes">
        <source>The table of %n measurement(s) is on the clipboard.</source>
        <translation>
            <numerusform>The table of %n measurement is on the clipboard.</numerusform>
            <numerusform>The table of %n measurements is on the clipboard.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::TaskList</name>
    <message numerus="yes">
        <source>about %n min left</source>
        <translation>
            <numerusform>about %n min left</numerusform>
            <numerusform>about %n min left</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::TransferPlot</name>
    <message numerus="yes">
        <source>%n points selected</source>
        <translation>
            <numerusform>%n point selected</numerusform>
            <numerusform>%n points selected</numerusform>
        </translation>
    </message>
</context>
</TS>
