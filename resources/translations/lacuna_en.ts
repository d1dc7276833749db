<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>lacuna::ui::BatchDialog</name>
    <message numerus="yes">
        <source>Cancelled after %n part(s); start again to go on.</source>
        <translation>
            <numerusform>Cancelled after %n part; start again to go on.</numerusform>
            <numerusform>Cancelled after %n parts; start again to go on.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::BatchModel</name>
    <message numerus="yes">
        <source>%1 (and %n more)</source>
        <translation>
            <numerusform>%1 (and %n more)</numerusform>
            <numerusform>%1 (and %n more)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::DicomBrowser</name>
    <message numerus="yes">
        <source>%n series</source>
        <translation>
            <numerusform>%n series</numerusform>
            <numerusform>%n series</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> in %n files</source>
        <translation>
            <numerusform> in %n file</numerusform>
            <numerusform> in %n files</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n cannot be read</source>
        <translation>
            <numerusform>; %n cannot be read</numerusform>
            <numerusform>; %n cannot be read</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>; %n named in the directory are missing</source>
        <translation>
            <numerusform>; %n named in the directory is missing</numerusform>
            <numerusform>; %n named in the directory are missing</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::ImportFeature</name>
    <message numerus="yes">
        <source>%n anonymised images were written.</source>
        <translation>
            <numerusform>%n anonymised image was written.</numerusform>
            <numerusform>%n anonymised images were written.</numerusform>
        </translation>
    </message>
</context>
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
    <name>lacuna::ui::MainWindow</name>
    <message numerus="yes">
        <source>One thing is open at a time: %n others are left out.</source>
        <translation>
            <numerusform>One thing is open at a time: %n other is left out.</numerusform>
            <numerusform>One thing is open at a time: %n others are left out.</numerusform>
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
    <name>lacuna::ui::PacsDialog</name>
    <message numerus="yes">
        <source>%n studies found.</source>
        <translation>
            <numerusform>%n study found.</numerusform>
            <numerusform>%n studies found.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files retrieved.</source>
        <translation>
            <numerusform>%n file retrieved.</numerusform>
            <numerusform>%n files retrieved.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> The server could not send %n.</source>
        <translation>
            <numerusform> The server could not send %n.</numerusform>
            <numerusform> The server could not send %n.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files sent.</source>
        <translation>
            <numerusform>%n file sent.</numerusform>
            <numerusform>%n files sent.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source> The server did not take %n.</source>
        <translation>
            <numerusform> The server did not take %n.</numerusform>
            <numerusform> The server did not take %n.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lacuna::ui::RawImportDialog</name>
    <message numerus="yes">
        <source>, behind %n header bytes</source>
        <translation>
            <numerusform>, behind %n header byte</numerusform>
            <numerusform>, behind %n header bytes</numerusform>
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
