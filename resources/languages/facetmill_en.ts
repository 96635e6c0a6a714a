<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>facetmill</name>
    <message numerus="yes">
        <source>%1 collisions</source>
        <translation><numerusform>%1 collision</numerusform><numerusform>%1 collisions</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 corners</source>
        <translation><numerusform>%1 corner</numerusform><numerusform>%1 corners</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 layers</source>
        <translation><numerusform>%1 layer</numerusform><numerusform>%1 layers</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 facets</source>
        <translation><numerusform>%1 of %2 facets</numerusform><numerusform>%1 of %2 facets</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 regions</source>
        <translation><numerusform>%1 region</numerusform><numerusform>%1 regions</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 smaller ones</source>
        <translation><numerusform>%1 smaller one</numerusform><numerusform>%1 smaller ones</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 tools</source>
        <translation><numerusform>%1 tool</numerusform><numerusform>%1 tools</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1, %2 passes</source>
        <translation><numerusform>%1, %2 pass</numerusform><numerusform>%1, %2 passes</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation><numerusform>%n more</numerusform><numerusform>%n more</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 holes are filled.</source>
        <translation><numerusform>As the file is, %1 of %2 holes is filled.</numerusform><numerusform>As the file is, %1 of %2 holes are filled.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 pieces go.</source>
        <translation><numerusform>As the file is, %1 of %2 pieces goes.</numerusform><numerusform>As the file is, %1 of %2 pieces go.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Planned “%1” in %2: %3 passes, cut length %4, machining time %5.</source>
        <translation><numerusform>Planned “%1” in %2: %3 pass, cut length %4, machining time %5.</numerusform><numerusform>Planned “%1” in %2: %3 passes, cut length %4, machining time %5.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Preview: %1 layers</source>
        <translation><numerusform>Preview: %1 layer</numerusform><numerusform>Preview: %1 layers</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Preview: about %1 passes</source>
        <translation><numerusform>Preview: about %1 pass</numerusform><numerusform>Preview: about %1 passes</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Scan room: %1 steps…</source>
        <translation><numerusform>Scan room: %1 step…</numerusform><numerusform>Scan room: %1 steps…</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations by previews of their passes. Planning all of them, to judge what they leave, would take long: add one, then plan and verify it.</source>
        <translation><numerusform>The best of %1 operation by a preview of its passes. Planning all of them, to judge what they leave, would take long: add one, then plan and verify it.</numerusform><numerusform>The best of %1 operations by previews of their passes. Planning all of them, to judge what they leave, would take long: add one, then plan and verify it.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations that were planned for this part and the project's tools, by time and by what they leave</source>
        <translation><numerusform>The best of %1 operation that was planned for this part and the project's tools, by time and by what it leaves</numerusform><numerusform>The best of %1 operations that were planned for this part and the project's tools, by time and by what they leave</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n files into %1.</source>
        <translation><numerusform>Wrote %n file into %1.</numerusform><numerusform>Wrote %n files into %1.</numerusform></translation>
    </message>
</context>
</TS>
