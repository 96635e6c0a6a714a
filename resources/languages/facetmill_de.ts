<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>core</name>
    <message>
        <source> (about {1} in all)</source>
        <translation> (etwa {1} insgesamt)</translation>
    </message>
    <message>
        <source> but {1}</source>
        <translation> sondern {1}</translation>
    </message>
    <message>
        <source> in the fixture '{1}'</source>
        <translation> im Spannmittel '{1}'</translation>
    </message>
    <message>
        <source> in the part</source>
        <translation> im Teil</translation>
    </message>
    <message>
        <source> in the stock</source>
        <translation> im Rohteil</translation>
    </message>
    <message>
        <source> of '{1}'</source>
        <translation> von '{1}'</translation>
    </message>
    <message>
        <source>'solid' expected</source>
        <translation>'solid' erwartet</translation>
    </message>
    <message>
        <source>'{1}' begins inside the part.</source>
        <translation>'{1}' beginnt im Teil.</translation>
    </message>
    <message>
        <source>'{1}' cannot be read</source>
        <translation>'{1}' kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>'{1}' cannot change tools, and the operations have several</source>
        <translation>'{1}' kann keine Werkzeuge wechseln, und die Operationen haben mehrere</translation>
    </message>
    <message>
        <source>'{1}' defines geometry or a variable</source>
        <translation>'{1}' definiert Geometrie oder eine Variable</translation>
    </message>
    <message>
        <source>'{1}' followed '{2}', which this setup does not have: it follows the outline now</source>
        <translation>„{1}“ folgte „{2}“, das es in dieser Aufspannung nicht gibt: sie folgt jetzt dem Umriss</translation>
    </message>
    <message>
        <source>'{1}' has a comma</source>
        <translation>'{1}' hat ein Komma</translation>
    </message>
    <message>
        <source>'{1}' has no '{2}'</source>
        <translation>'{1}' hat kein '{2}'</translation>
    </message>
    <message>
        <source>'{1}' has no decimal point, and the control would count its last digits</source>
        <translation>'{1}' hat keinen Dezimalpunkt, und die Steuerung würde die letzten Stellen zählen</translation>
    </message>
    <message>
        <source>'{1}' has no keys</source>
        <translation>'{1}' hat keine Schlüssel</translation>
    </message>
    <message>
        <source>'{1}' has two meanings</source>
        <translation>'{1}' hat zwei Bedeutungen</translation>
    </message>
    <message>
        <source>'{1}' is a length, the field has none</source>
        <translation>'{1}' ist eine Länge, das Feld hat keine</translation>
    </message>
    <message>
        <source>'{1}' is left over</source>
        <translation>'{1}' ist übrig</translation>
    </message>
    <message>
        <source>'{1}' is no code of this control</source>
        <translation>'{1}' ist kein Code dieser Steuerung</translation>
    </message>
    <message>
        <source>'{1}' is no format of a tool library</source>
        <translation>'{1}' ist kein Format einer Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>'{1}' is no host</source>
        <translation>„{1}“ ist kein Rechner</translation>
    </message>
    <message>
        <source>'{1}' is no letter and number</source>
        <translation>'{1}' ist nicht Buchstabe und Zahl</translation>
    </message>
    <message>
        <source>'{1}' is no limit</source>
        <translation>„{1}“ ist keine Grenze</translation>
    </message>
    <message>
        <source>'{1}' is no list</source>
        <translation>'{1}' ist keine Liste</translation>
    </message>
    <message>
        <source>'{1}' is no meaning of a code</source>
        <translation>'{1}' ist keine Bedeutung eines Codes</translation>
    </message>
    <message>
        <source>'{1}' is no name</source>
        <translation>'{1}' ist kein Name</translation>
    </message>
    <message>
        <source>'{1}' is no number</source>
        <translation>'{1}' ist keine Zahl</translation>
    </message>
    <message>
        <source>'{1}' is no number or range of {2}</source>
        <translation>'{1}' ist keine Nummer und kein Bereich: {2}</translation>
    </message>
    <message>
        <source>'{1}' is no operation, or stands twice</source>
        <translation>'{1}' ist keine Operation oder steht zweimal da</translation>
    </message>
    <message>
        <source>'{1}' is no rung of a study</source>
        <translation>'{1}' ist keine Stufe einer Studie</translation>
    </message>
    <message>
        <source>'{1}' is no share</source>
        <translation>'{1}' ist kein Anteil</translation>
    </message>
    <message>
        <source>'{1}' is no such count</source>
        <translation>'{1}' ist keine solche Anzahl</translation>
    </message>
    <message>
        <source>'{1}' is no unit that this field can have</source>
        <translation>'{1}' ist keine Einheit, die dieses Feld haben kann</translation>
    </message>
    <message>
        <source>'{1}' is no word</source>
        <translation>'{1}' ist kein Wort</translation>
    </message>
    <message>
        <source>'{1}' is no word of this control</source>
        <translation>'{1}' ist kein Wort dieser Steuerung</translation>
    </message>
    <message>
        <source>'{1}' is no word, or has a meaning</source>
        <translation>'{1}' ist kein Wort oder hat eine Bedeutung</translation>
    </message>
    <message>
        <source>'{1}' is not a finite number</source>
        <translation>'{1}' ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>'{1}' is not a number</source>
        <translation>'{1}' ist keine Zahl</translation>
    </message>
    <message>
        <source>'{1}' is not a statement</source>
        <translation>'{1}' ist keine Anweisung</translation>
    </message>
    <message>
        <source>'{1}' is not a tool number</source>
        <translation>'{1}' ist keine Werkzeugnummer</translation>
    </message>
    <message>
        <source>'{1}' is not in the packed file</source>
        <translation>'{1}' ist nicht in der gepackten Datei</translation>
    </message>
    <message>
        <source>'{1}' is not known</source>
        <translation>'{1}' ist nicht bekannt</translation>
    </message>
    <message>
        <source>'{1}' is out of place</source>
        <translation>'{1}' ist fehl am Platz</translation>
    </message>
    <message>
        <source>'{1}' names no property</source>
        <translation>'{1}' benennt keine Eigenschaft</translation>
    </message>
    <message>
        <source>'{1}' names no tool (LOADTL), and its cutter is not that of tool {2}: shank and holder are not known and were not judged.</source>
        <translation>'{1}' nennt kein Werkzeug (LOADTL), und sein Fräser ist nicht der von Werkzeug {2}: Schaft und Halter sind nicht bekannt und wurden nicht beurteilt.</translation>
    </message>
    <message>
        <source>'{1}' names no tool (LOADTL): its cutter is that of tool {2}, so shank and holder of that were judged.</source>
        <translation>'{1}' nennt kein Werkzeug (LOADTL): sein Fräser ist der von Werkzeug {2}, also wurden dessen Schaft und Halter beurteilt.</translation>
    </message>
    <message>
        <source>'{1}' occurs twice</source>
        <translation>'{1}' kommt zweimal vor</translation>
    </message>
    <message>
        <source>'{1}' stands behind what has a unit already</source>
        <translation>'{1}' steht hinter etwas, das schon eine Einheit hat</translation>
    </message>
    <message>
        <source>'{1}' stands for no values</source>
        <translation>'{1}' steht für keine Werte</translation>
    </message>
    <message>
        <source>'{1}' stands where values should</source>
        <translation>'{1}' steht, wo Werte stehen sollten</translation>
    </message>
    <message>
        <source>'{1}' was bounded by '{2}', which this setup does not have: it cuts everywhere now</source>
        <translation>'{1}' war durch '{2}' begrenzt, das diese Aufspannung nicht hat: sie fräst jetzt überall</translation>
    </message>
    <message>
        <source>'{1}', GOTO {2}</source>
        <translation>'{1}', GOTO {2}</translation>
    </message>
    <message>
        <source>'{1}', GOTO {2}, where the axis turns {3}</source>
        <translation>'{1}', GOTO {2}, wo sich die Achse um {3} dreht</translation>
    </message>
    <message>
        <source>'{1}', line {2}</source>
        <translation>'{1}', Zeile {2}</translation>
    </message>
    <message>
        <source>'{1}', line {2}, where the axis turns {3}</source>
        <translation>'{1}', Zeile {2}, wo sich die Achse um {3} dreht</translation>
    </message>
    <message>
        <source>'{1}': '{2}' belongs to places of another part and was left behind</source>
        <translation>'{1}': '{2}' gehört zu Stellen eines anderen Teils und blieb zurück</translation>
    </message>
    <message>
        <source>'{1}': the project has no tool {2}, so shank and holder are not known and were not judged.</source>
        <translation>'{1}': das Projekt hat kein Werkzeug {2}, Schaft und Halter sind also nicht bekannt und wurden nicht beurteilt.</translation>
    </message>
    <message>
        <source>'{1}': {2} of {3} motions at feed are outside the stock.</source>
        <translation>'{1}': {2} von {3} Bewegungen im Vorschub liegen außerhalb des Rohteils.</translation>
    </message>
    <message>
        <source>'{1}=' is no word of this control</source>
        <translation>'{1}=' ist kein Wort dieser Steuerung</translation>
    </message>
    <message>
        <source>, as at {1}, {2}, {3}</source>
        <translation>, etwa bei {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>, or a larger tilt limit</source>
        <translation>, oder eine größere Neigungsgrenze</translation>
    </message>
    <message>
        <source>, or a tilt limit on a machine of five axes</source>
        <translation>, oder eine Neigungsgrenze auf einer Maschine mit fünf Achsen</translation>
    </message>
    <message>
        <source>, or a tool that tilts (finish5)</source>
        <translation>, oder ein Werkzeug, das sich neigt (finish5)</translation>
    </message>
    <message>
        <source>0 for a sharp corner; half the diameter for a ball end.</source>
        <translation>0 für eine scharfe Ecke; der halbe Durchmesser für einen Kugelkopf.</translation>
    </message>
    <message>
        <source>0 or more and below 90°</source>
        <translation>0 oder mehr und unter 90°</translation>
    </message>
    <message>
        <source>0, 0, 0 of the part's coordinates, in which the programs are written; it is {1}, {2}, {3} (X, Y, Z) from the stock's lowest corner</source>
        <translation>0, 0, 0 der Koordinaten des Teils, in denen die Programme geschrieben sind; er ist {1}, {2}, {3} (X, Y, Z) von der niedrigsten Ecke des Rohteils</translation>
    </message>
    <message>
        <source>1 change of tools, not in the time.</source>
        <translation>1 Werkzeugwechsel, nicht in der Zeit enthalten.</translation>
    </message>
    <message>
        <source>1 collision, the deepest {1}</source>
        <translation>1 Kollision, die tiefste {1}</translation>
    </message>
    <message>
        <source>: it is no text</source>
        <translation>: es ist kein Text</translation>
    </message>
    <message>
        <source>; more points are put in where it turns more</source>
        <translation>; wo sie sich stärker dreht, kommen Punkte hinzu</translation>
    </message>
    <message>
        <source>A car body with four steep concave scoops, 12 × 6 in.</source>
        <translation>Eine Karosserie mit vier steilen hohlen Mulden, 12 × 6 in.</translation>
    </message>
    <message>
        <source>A corner of the curve.</source>
        <translation>Eine Ecke der Kurve.</translation>
    </message>
    <message>
        <source>A domed surface with a winding gap between two walls, 6 × 5 in.</source>
        <translation>Eine gewölbte Fläche mit gewundenem Spalt zwischen zwei Wänden, 6 × 5 in.</translation>
    </message>
    <message>
        <source>A long curved strip with concave blends, like a car's A-pillar, 20 × 6 in.</source>
        <translation>Ein langer gebogener Streifen mit hohlen Übergängen, wie die A-Säule eines Autos, 20 × 6 in.</translation>
    </message>
    <message>
        <source>A picture does not say how large it is: where the job does not either, it was taken as 100 mm wide and 5 mm high.</source>
        <translation>Ein Bild sagt nicht, wie groß es ist: wo es auch der Auftrag nicht tut, gilt es als 100 mm breit und 5 mm hoch.</translation>
    </message>
    <message>
        <source>A piece of the stock, {1} long, comes off at {2}.</source>
        <translation>Ein Stück des Rohteils, {1} lang, löst sich bei {2}.</translation>
    </message>
    <message>
        <source>A place on the part: the region nearest to it is meant.</source>
        <translation>Eine Stelle auf dem Teil: gemeint ist der nächste Bereich.</translation>
    </message>
    <message>
        <source>A pocket with walls at 3° of draft, sharp inner corners and a boss on its floor, 100 × 80 mm.</source>
        <translation>Eine Tasche mit Wänden von 3° Entformungsschräge, scharfen Innenecken und einem Zapfen am Boden, 100 × 80 mm.</translation>
    </message>
    <message>
        <source>A program for each operation, or one for all with tool changes between.</source>
        <translation>Ein Programm je Operation, oder eines für alle mit Werkzeugwechseln dazwischen.</translation>
    </message>
    <message>
        <source>A solid without facets is in the file; it was ignored.</source>
        <translation>In der Datei ist ein Körper ohne Facetten; er wurde übergangen.</translation>
    </message>
    <message>
        <source>A square prism of side 45 mm, 60 mm long, that makes a quarter turn about the X axis.</source>
        <translation>Ein quadratisches Prisma, Seite 45 mm, 60 mm lang, mit einer Vierteldrehung um die X-Achse.</translation>
    </message>
    <message>
        <source>A tool that cuts into the part is not inclined: the depth is above 0</source>
        <translation>Ein Werkzeug, das ins Teil fräst, wird nicht geneigt: die Tiefe ist über 0</translation>
    </message>
    <message>
        <source>A turns about X, B about Y, C about Z: mend the name or the direction</source>
        <translation>A dreht um X, B um Y, C um Z: den Namen oder die Richtung berichtigen</translation>
    </message>
    <message>
        <source>About the middle</source>
        <translation>Um die Mitte</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>Beschleunigungen</translation>
    </message>
    <message>
        <source>Advance along the axis in a turn: adaptive is everywhere the largest that leaves no cusp above the tolerance; a length is kept whatever it leaves. Of lengthwise lines: their distance at the part's largest radius.</source>
        <translation>Vorschub entlang der Achse je Umdrehung: adaptiv ist überall der größte, der keine Rille über der Toleranz lässt; eine Länge wird eingehalten, was sie auch lässt. Bei Längslinien: ihr Abstand am größten Radius des Teils.</translation>
    </message>
    <message>
        <source>All but that: what was inside is outside.</source>
        <translation>Alles außer dem: was innen war, ist außen.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Aufmaß</translation>
    </message>
    <message>
        <source>Along a curve</source>
        <translation>Entlang einer Kurve</translation>
    </message>
    <message>
        <source>Along which the cylinder lies, through the middle of the part's box.</source>
        <translation>Entlang der der Zylinder liegt, durch die Mitte des Quaders um das Teil.</translation>
    </message>
    <message>
        <source>Also points left out</source>
        <translation>Auch ausgelassene Punkte</translation>
    </message>
    <message>
        <source>Angle tolerance</source>
        <translation>Winkeltoleranz</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>Approach, retract</source>
        <translation>Anfahren, Rückzug</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Bögen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Assumed lead limit</source>
        <translation>Angenommene Grenze</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Meiden</translation>
    </message>
    <message>
        <source>Avoid by</source>
        <translation>Meiden um</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Axes of the machine</source>
        <translation>Achsen der Maschine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis from</source>
        <translation>Achse von</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Achse durch</translation>
    </message>
    <message>
        <source>Axis to</source>
        <translation>Achse bis</translation>
    </message>
    <message>
        <source>Back of the surface</source>
        <translation>Rückseite der Fläche</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>Kugelkopf</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>Beginnen an</translation>
    </message>
    <message>
        <source>Below the bottom</source>
        <translation>Unter dem Boden</translation>
    </message>
    <message>
        <source>Between passes; 0 where nobody says.</source>
        <translation>Zwischen Bahnen; 0, wo niemand ihn nennt.</translation>
    </message>
    <message>
        <source>Beyond the machine</source>
        <translation>Außerhalb der Maschine</translation>
    </message>
    <message>
        <source>Black is the top of a picture's relief and white its ground. What is transparent lies on the ground all the same.</source>
        <translation>Schwarz ist oben im Relief eines Bildes und Weiß sein Grund. Was durchsichtig ist, liegt trotzdem auf dem Grund.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Sätze</translation>
    </message>
    <message>
        <source>Body shell</source>
        <translation>Karosserie</translation>
    </message>
    <message>
        <source>Bolt</source>
        <translation>Schraube</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Bottom angle</source>
        <translation>Stirnwinkel</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Schranke</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Begrenzung</translation>
    </message>
    <message>
        <source>Boundary drags</source>
        <translation>Gezogene Begrenzungen</translation>
    </message>
    <message>
        <source>Bull</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>Bytes follow every facet of the binary STL file, as many as its attribute word says; they were skipped.</source>
        <translation>Jeder Facette der binären STL-Datei folgen so viele Bytes, wie ihr Attributwort sagt; sie wurden übersprungen.</translation>
    </message>
    <message>
        <source>Bytes follow the end of the mesh; they were ignored.</source>
        <translation>Dem Ende des Netzes folgen Bytes; sie wurden übergangen.</translation>
    </message>
    <message>
        <source>CUTTER has {1} values</source>
        <translation>CUTTER hat {1} Werte</translation>
    </message>
    <message>
        <source>CUTTER is not a convex cutter: {1}</source>
        <translation>CUTTER ist kein konvexer Fräser: {1}</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>Checking passes</source>
        <translation>Bahnen werden geprüft</translation>
    </message>
    <message>
        <source>Chip load</source>
        <translation>Zahnvorschub</translation>
    </message>
    <message>
        <source>Chipload</source>
        <translation>Zahnvorschub</translation>
    </message>
    <message>
        <source>Choose global postures, and count the time, with what the machine's axes take to change their speed, where its file says.</source>
        <translation>Globale Stellungen wählen und die Zeit zählen mit dem, was die Achsen der Maschine zum Ändern ihrer Geschwindigkeit brauchen, wo ihre Datei es sagt.</translation>
    </message>
    <message>
        <source>Choosing axes</source>
        <translation>Achsen werden gewählt</translation>
    </message>
    <message>
        <source>Choosing layers</source>
        <translation>Ebenen werden gewählt</translation>
    </message>
    <message>
        <source>Choosing levels</source>
        <translation>Höhen werden gewählt</translation>
    </message>
    <message>
        <source>Chord tolerance</source>
        <translation>Sehnentoleranz</translation>
    </message>
    <message>
        <source>Chosen: {1}</source>
        <translation>Gewählt: {1}</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>Futter</translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation>Spannpratze</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Sicherheitsabstand</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Kommentar</translation>
    </message>
    <message>
        <source>Comparing tools</source>
        <translation>Werkzeuge werden verglichen</translation>
    </message>
    <message>
        <source>Comparing with the part</source>
        <translation>Mit dem Teil wird verglichen</translation>
    </message>
    <message>
        <source>Complex surface</source>
        <translation>Komplexe Fläche</translation>
    </message>
    <message>
        <source>Concave surface</source>
        <translation>Hohle Fläche</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Cone-bottom bull nose</source>
        <translation>Torus mit Kegelstirn</translation>
    </message>
    <message>
        <source>Constant scallop</source>
        <translation>Gleiche Rillenhöhe</translation>
    </message>
    <message>
        <source>Contact points</source>
        <translation>Berührpunkte</translation>
    </message>
    <message>
        <source>Contact points (CC)</source>
        <translation>Berührpunkte (CC)</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>Convex surface</source>
        <translation>Gewölbte Fläche</translation>
    </message>
    <message>
        <source>Core radius</source>
        <translation>Kernradius</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Eckenradius</translation>
    </message>
    <message>
        <source>Corners of a closed curve, which is looked at along Z.</source>
        <translation>Ecken einer geschlossenen Kurve, entlang Z betrachtet.</translation>
    </message>
    <message>
        <source>Counting steps from the border</source>
        <translation>Schritte vom Rand werden gezählt</translation>
    </message>
    <message>
        <source>Course of the passes: parallel drive planes.</source>
        <translation>Verlauf der Bahnen: parallele Führungsebenen.</translation>
    </message>
    <message>
        <source>Course of the tool: one helix, rings with steps between them, or lengthwise lines to and fro with turns between them.</source>
        <translation>Verlauf des Werkzeugs: eine Wendel, Ringe mit Schritten dazwischen, oder Längslinien hin und her mit Drehungen dazwischen.</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation>Spitzenhöhe</translation>
    </message>
    <message>
        <source>Cusps are known point by point for 5-axis operations only; the report has the largest one.</source>
        <translation>Spitzenhöhen sind nur bei 5-Achs-Operationen Punkt für Punkt bekannt; der Bericht hat die größte.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Fräsen</translation>
    </message>
    <message>
        <source>Cut, {1}</source>
        <translation>Schnitt, {1}</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Schnitte</translation>
    </message>
    <message>
        <source>Cuts only where more than the tolerance stands of the stock, as raw material and the operations before left it.</source>
        <translation>Fräst nur, wo vom Rohteil mehr als die Toleranz steht, wie das Rohmaterial und die Operationen davor es ließen.</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>Cutter, elsewhere</source>
        <translation>Fräser, anderswo</translation>
    </message>
    <message>
        <source>Cutter, near the contact</source>
        <translation>Fräser, nahe am Berührpunkt</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Wird geschnitten</translation>
    </message>
    <message>
        <source>Cutting diameter. With a taper angle: where bottom and side line meet, below the corner rounding.</source>
        <translation>Schneidendurchmesser. Mit Flankenwinkel: wo sich Boden- und Seitenlinie treffen, unter der Eckenrundung.</translation>
    </message>
    <message>
        <source>Cutting edges; 0 where nobody says. Feeds are worked out from a chip load by it.</source>
        <translation>Anzahl der Schneiden; 0, wo niemand sie nennt. Vorschübe werden damit aus dem Zahnvorschub berechnet.</translation>
    </message>
    <message>
        <source>Cutting layers</source>
        <translation>Ebenen werden gefräst</translation>
    </message>
    <message>
        <source>Cutting steep surface by levels</source>
        <translation>Steiles wird in Höhenlinien gefräst</translation>
    </message>
    <message>
        <source>CuttingEdgeHeight is not said: all of its length is taken for flutes</source>
        <translation>CuttingEdgeHeight fehlt: die ganze Länge gilt als Schneide</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Decimating</source>
        <translation>Wird ausgedünnt</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>Tiefste Verletzung</translation>
    </message>
    <message>
        <source>Deepest gouges</source>
        <translation>Tiefste Verletzungen</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth of a cut</source>
        <translation>Tiefe eines Schnitts</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Schnitttiefe</translation>
    </message>
    <message>
        <source>Depth, {1}</source>
        <translation>Tiefe, {1}</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Deviation ({1})</source>
        <translation>Abweichung ({1})</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Durchmesser</translation>
    </message>
    <message>
        <source>Diameter of the section.</source>
        <translation>Durchmesser des Abschnitts.</translation>
    </message>
    <message>
        <source>Diameter, {1}</source>
        <translation>Durchmesser, {1}</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Direction from the tip to the spindle in the setup's coordinates, kept all along; 0, 0, 1 is upright. With another one the operation is planned as seen along it, X and Y turned with it the shortest way, and keeps above the bottom of the stock.</source>
        <translation>Richtung von der Spitze zur Spindel in Koordinaten der Aufspannung, durchweg gehalten; 0, 0, 1 ist senkrecht. Mit einer anderen wird die Operation so geplant, wie sie entlang dieser aussieht, X und Y auf dem kürzesten Weg mitgedreht, und bleibt über dem Boden des Rohteils.</translation>
    </message>
    <message>
        <source>Direction in which the trajectories are looked at to tell forward from backward motion.</source>
        <translation>Richtung, in der die Spuren betrachtet werden, um Vor- von Rückwärtsbewegung zu unterscheiden.</translation>
    </message>
    <message>
        <source>Direction of travel of the main path: auto follows the assumed path along x and y and takes the one with less estimated time of main path and rework; a number is an angle from X.</source>
        <translation>Fahrtrichtung des Hauptwegs: auto folgt dem angenommenen Weg entlang x und y und nimmt den mit der kürzeren geschätzten Zeit von Hauptweg und Nacharbeit; eine Zahl ist ein Winkel von X.</translation>
    </message>
    <message>
        <source>Direction of travel of the rework path: auto is that of the main path; a number is an angle from X.</source>
        <translation>Fahrtrichtung des Nacharbeitswegs: auto ist die des Hauptwegs; eine Zahl ist ein Winkel von X.</translation>
    </message>
    <message>
        <source>Direction of travel: auto picks x or y by the change of normals, 3-axis finishing the other one where that travels or leaves less; a number is an angle from X.</source>
        <translation>Fahrtrichtung: auto wählt x oder y nach der Änderung der Normalen, 3-achsiges Schlichten die andere, wo das weniger fährt oder lässt; eine Zahl ist ein Winkel von X.</translation>
    </message>
    <message>
        <source>Distance between neighbouring drive planes: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Abstand benachbarter Führungsebenen: adaptiv ist überall der größte, den die Toleranz erlaubt; eine Länge wird eingehalten, welche Rillen sie auch lässt.</translation>
    </message>
    <message>
        <source>Distance between neighbouring drive planes: adaptive is everywhere the largest that the tolerance allows; a length is kept.</source>
        <translation>Abstand benachbarter Führungsebenen: adaptiv ist überall der größte, den die Toleranz erlaubt; eine Länge wird eingehalten.</translation>
    </message>
    <message>
        <source>Distance between neighbouring layers; from_tolerance is everywhere the largest that leaves no more than the tolerance above the allowance, at most the diameter, and puts lines closer where a floor stays.</source>
        <translation>Abstand benachbarter Ebenen; aus der Toleranz ist überall der größte, der nicht mehr als die Toleranz über dem Aufmaß lässt, höchstens der Durchmesser, und legt Linien dichter, wo ein Boden bleibt.</translation>
    </message>
    <message>
        <source>Distance between neighbouring passes over the surface: adaptive is everywhere what leaves cusps of the tolerance; a length is kept whatever cusps it leaves.</source>
        <translation>Abstand benachbarter Bahnen über die Oberfläche: adaptiv ist überall der, der Rillen von der Höhe der Toleranz lässt; eine Länge wird eingehalten, welche Rillen sie auch lässt.</translation>
    </message>
    <message>
        <source>Distance between neighbouring passes, looked at from above: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Abstand benachbarter Bahnen, von oben gesehen: adaptiv ist überall der größte, den die Toleranz erlaubt; eine Länge wird eingehalten, welche Rillen sie auch lässt.</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the part.</source>
        <translation>Abstand, den Schaft und Halter vom Teil halten.</translation>
    </message>
    <message>
        <source>Divide</source>
        <translation>Teilung</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>Schwalbenschwanz</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Bohrer</translation>
    </message>
    <message>
        <source>Drill point</source>
        <translation>Bohrspitze</translation>
    </message>
    <message>
        <source>Elapsed time</source>
        <translation>Verstrichene Zeit</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Eintauchen</translation>
    </message>
    <message>
        <source>Even steps of the turning angle; more points are put in where the part asks for them. auto takes as few as the chord tolerance allows. Of lengthwise lines: lines per turn.</source>
        <translation>Gleiche Schritte des Drehwinkels; wo das Teil es verlangt, kommen Punkte hinzu. auto nimmt so wenige, wie die Sehnentoleranz erlaubt. Bei Längslinien: Linien je Umdrehung.</translation>
    </message>
    <message>
        <source>Evens out a picture's relief, across six pixels or so; no height moves by more than this. A 500th of the relief height takes the steps of 256 greys away. 0: none.</source>
        <translation>Ebnet das Relief eines Bildes über etwa sechs Pixel; keine Höhe ändert sich um mehr als das. Ein 500stel der Reliefhöhe nimmt die Stufen von 256 Grauwerten weg. 0: keine.</translation>
    </message>
    <message>
        <source>Extruded pattern</source>
        <translation>Erhabenes Muster</translation>
    </message>
    <message>
        <source>FEDRAT without a value</source>
        <translation>FEDRAT ohne Wert</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Facet edges</source>
        <translation>Facettenkanten</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Facets for surfaces</source>
        <translation>Facetten für Flächen</translation>
    </message>
    <message>
        <source>Fanuc, TCP with rotary axes (G43.4)</source>
        <translation>Fanuc, TCP mit Drehachsen (G43.4)</translation>
    </message>
    <message>
        <source>Fanuc, TCP with tool vectors (G43.5)</source>
        <translation>Fanuc, TCP mit Werkzeugvektoren (G43.5)</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Merkmalwinkel</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Vorschub</translation>
    </message>
    <message>
        <source>Feed, {1}/min</source>
        <translation>Vorschub, {1}/min</translation>
    </message>
    <message>
        <source>Feeds and speeds</source>
        <translation>Vorschübe und Drehzahlen</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Files of this format have Y pointing up: the part was turned so that Z does.</source>
        <translation>In Dateien dieses Formats zeigt Y nach oben: Das Teil wurde gedreht, sodass Z es tut.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Füllung</translation>
    </message>
    <message>
        <source>Filling a hole</source>
        <translation>Ein Loch wird gefüllt</translation>
    </message>
    <message>
        <source>Filling holes</source>
        <translation>Löcher werden gefüllt</translation>
    </message>
    <message>
        <source>Finding rework regions</source>
        <translation>Nacharbeitsbereiche werden gesucht</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Finish, 3-axis</source>
        <translation>Schlichten, 3-achsig</translation>
    </message>
    <message>
        <source>Finish, 5-axis</source>
        <translation>Schlichten, 5-achsig</translation>
    </message>
    <message>
        <source>Finish, turning part</source>
        <translation>Schlichten, drehendes Teil</translation>
    </message>
    <message>
        <source>Finishing allowance</source>
        <translation>Schlichtaufmaß</translation>
    </message>
    <message>
        <source>Finishing with five axes</source>
        <translation>Schlichten mit fünf Achsen</translation>
    </message>
    <message>
        <source>First curve</source>
        <translation>Erste Kurve</translation>
    </message>
    <message>
        <source>First point of an axis through two points.</source>
        <translation>Erster Punkt einer Achse durch zwei Punkte.</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Fixture '{1}'</source>
        <translation>Spannmittel '{1}'</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Spannmittel</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>Flute length</source>
        <translation>Schneidenlänge</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Following curves</source>
        <translation>Kurven werden verfolgt</translation>
    </message>
    <message>
        <source>Following levels</source>
        <translation>Höhenlinien werden verfolgt</translation>
    </message>
    <message>
        <source>Following the assumed path</source>
        <translation>Dem angenommenen Weg wird gefolgt</translation>
    </message>
    <message>
        <source>Following the part</source>
        <translation>Das Teil wird abgefahren</translation>
    </message>
    <message>
        <source>Following valleys</source>
        <translation>Kehlen werden verfolgt</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Free volume</source>
        <translation>Freier Raum</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From a radial line through the tip up to the bottom: 0 for a flat bottom; a cone of half angle w has 90° less w.</source>
        <translation>Von einer radialen Linie durch die Spitze zur Stirn: 0 für eine flache Stirn; ein Kegel vom halben Winkel w hat 90° weniger w.</translation>
    </message>
    <message>
        <source>From and to: 0 is level, 90 an upright wall, more an underside.</source>
        <translation>Von und bis: 0 ist waagrecht, 90 eine senkrechte Wand, mehr eine Unterseite.</translation>
    </message>
    <message>
        <source>From radius</source>
        <translation>Ab Radius</translation>
    </message>
    <message>
        <source>From the axis to the side: positive when the tool widens upward, negative for a dovetail.</source>
        <translation>Von der Achse zur Seite: positiv, wenn das Werkzeug nach oben breiter wird, negativ bei einem Schwalbenschwanz.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorn</translation>
    </message>
    <message>
        <source>Front jaw</source>
        <translation>Vordere Backe</translation>
    </message>
    <message>
        <source>GODLTA has no place to start from</source>
        <translation>GODLTA hat keinen Ort, von dem es ausgeht</translation>
    </message>
    <message>
        <source>GODLTA has {1} values</source>
        <translation>GODLTA hat {1} Werte</translation>
    </message>
    <message>
        <source>GODLTA leaves the range of coordinates</source>
        <translation>GODLTA verlässt den Bereich der Koordinaten</translation>
    </message>
    <message>
        <source>GOTO {1} of '{2}'</source>
        <translation>GOTO {1} von '{2}'</translation>
    </message>
    <message>
        <source>Generic mill (3-axis)</source>
        <translation>Allgemeine Fräsmaschine (3-achsig)</translation>
    </message>
    <message>
        <source>Generic mill with rotary table A (4-axis)</source>
        <translation>Allgemeine Fräsmaschine mit Drehtisch A (4-achsig)</translation>
    </message>
    <message>
        <source>Generic tilting head B, rotary table C (5-axis, head-table)</source>
        <translation>Allgemeiner Schwenkkopf B, Drehtisch C (5-achsig, Kopf-Tisch)</translation>
    </message>
    <message>
        <source>Generic trunnion A/C (5-axis, table-table)</source>
        <translation>Allgemeine Schwenkwiege A/C (5-achsig, Tisch-Tisch)</translation>
    </message>
    <message>
        <source>Generic trunnion B/C (5-axis, table-table)</source>
        <translation>Allgemeine Schwenkwiege B/C (5-achsig, Tisch-Tisch)</translation>
    </message>
    <message>
        <source>Global-local CM²</source>
        <translation>Global-lokal CM²</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Gouge limit</source>
        <translation>Grenze der Verletzung</translation>
    </message>
    <message>
        <source>Grbl 1.1</source>
        <translation>Grbl 1.1</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Haas, TCPC (G234)</source>
        <translation>Haas, TCPC (G234)</translation>
    </message>
    <message>
        <source>Heidenhain, TCPM with rotary axes (M128)</source>
        <translation>Heidenhain, TCPM mit Drehachsen (M128)</translation>
    </message>
    <message>
        <source>Heidenhain, TCPM with tool vectors (LN)</source>
        <translation>Heidenhain, TCPM mit Werkzeugvektoren (LN)</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Height between neighbouring levels: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Höhe zwischen benachbarten Höhenlinien: adaptiv ist überall die größte, die die Toleranz zulässt; eine Länge wird eingehalten, welche Rillen sie auch lässt.</translation>
    </message>
    <message>
        <source>Height of level rapid moves above part and stock on their way; to the first pass and from the last, above the highest of them.</source>
        <translation>Höhe waagrechter Eilgänge über Teil und Rohteil auf ihrem Weg; zur ersten Bahn hin und von der letzten weg über dem Höchsten von beiden.</translation>
    </message>
    <message>
        <source>Height of the cutting part above the tip.</source>
        <translation>Höhe des schneidenden Teils über der Spitze.</translation>
    </message>
    <message>
        <source>Highest lift that clears the strip</source>
        <translation>Größter Abhub, der den Streifen abträgt</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Holder clearance</source>
        <translation>Halterabstand</translation>
    </message>
    <message>
        <source>Hole, left open</source>
        <translation>Loch, offen gelassen</translation>
    </message>
    <message>
        <source>Hole, to be filled</source>
        <translation>Loch, zu füllen</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Mulde</translation>
    </message>
    <message>
        <source>How deep surface may come to lie inside a cutter before it counts as a gouge; `auto`: twice the chord tolerance that the paths keep.</source>
        <translation>Wie tief Fläche in einem Fräser liegen darf, bevor es als Verletzung gilt; auto: das Doppelte der Sehnentoleranz, die die Wege halten.</translation>
    </message>
    <message>
        <source>How far below the surface the cutter goes, along its axis. 0 stays on it.</source>
        <translation>Wie weit der Fräser unter die Oberfläche geht, längs seiner Achse. 0 bleibt auf ihr.</translation>
    </message>
    <message>
        <source>How far beside the centre line the cutter runs, so that a ball does not cut with its tip.</source>
        <translation>Wie weit der Fräser neben der Mittellinie läuft, damit eine Kugel nicht mit der Spitze schneidet.</translation>
    </message>
    <message>
        <source>How far beside the curve, on the side that is chosen. auto is the cutter's radius and the allowance, so that the cutter touches the curve.</source>
        <translation>Wie weit neben der Kurve, auf der gewählten Seite. auto ist der Radius des Fräsers und das Aufmaß, sodass der Fräser die Kurve berührt.</translation>
    </message>
    <message>
        <source>How far cutter, shank and holder keep from these facets.</source>
        <translation>Wie weit Fräser, Schaft und Halter von diesen Facetten bleiben.</translation>
    </message>
    <message>
        <source>How far facets may lie from the surfaces of a STEP or IGES file. auto is a tenth of the finest tolerance of the operations; painted facets stay what they are where a length is given.</source>
        <translation>Wie weit Facetten von den Flächen einer STEP- oder IGES-Datei liegen dürfen. auto ist ein Zehntel der feinsten Toleranz der Operationen; gemalte Facetten bleiben, was sie sind, wo eine Länge angegeben ist.</translation>
    </message>
    <message>
        <source>How far its boundary lies outside the offset; inside below 0, but never inside of what is uncut.</source>
        <translation>Wie weit die Begrenzung außerhalb des Versatzes liegt; innerhalb unter 0, aber nie in dem, was stehen bleibt.</translation>
    </message>
    <message>
        <source>How far motions may run beside the exact path</source>
        <translation>Wie weit Bewegungen neben dem genauen Weg verlaufen dürfen</translation>
    </message>
    <message>
        <source>How far motions may run beside the exact path, to either side</source>
        <translation>Wie weit Bewegungen neben dem genauen Weg verlaufen dürfen, nach beiden Seiten</translation>
    </message>
    <message>
        <source>How far one of several cuts goes below the one before.</source>
        <translation>Wie weit einer von mehreren Schnitten unter den vorigen geht.</translation>
    </message>
    <message>
        <source>How far passes go on over what the previous tool has cut; auto is half the tool's radius.</source>
        <translation>Wie weit Bahnen über das hinausgehen, was das vorherige Werkzeug gefräst hat; auto ist der halbe Werkzeugradius.</translation>
    </message>
    <message>
        <source>How far rework goes beyond the uncut places, so that the two paths overlap.</source>
        <translation>Wie weit die Nacharbeit über die stehen gebliebenen Stellen hinausgeht, damit sich die Wege überlappen.</translation>
    </message>
    <message>
        <source>How far straight moves may run beside the exact path, to either side</source>
        <translation>Wie weit gerade Bewegungen neben dem genauen Weg verlaufen dürfen, nach beiden Seiten</translation>
    </message>
    <message>
        <source>How far the cutter leans along the axis, away from square to it.</source>
        <translation>Wie weit sich der Fräser entlang der Achse neigt, weg vom rechten Winkel dazu.</translation>
    </message>
    <message>
        <source>How far the cutter may go below the bottom of the stock, where something holds it. With 0 steep surface near the bottom keeps what only a lower tip would cut.</source>
        <translation>Wie weit der Fräser unter den Boden des Rohteils gehen darf, wo es etwas hält. Mit 0 behält steile Fläche nahe am Boden, was nur eine tiefere Spitze fräsen würde.</translation>
    </message>
    <message>
        <source>How far the inclination is turned about the surface normal, to the left of the travel; to the right below 0.</source>
        <translation>Wie weit die Neigung um die Flächennormale gedreht ist, nach links der Fahrt; nach rechts unter 0.</translation>
    </message>
    <message>
        <source>How far the inclination may turn about the surface normal, to the right (below 0) and to the left of the travel.</source>
        <translation>Wie weit sich die Neigung um die Flächennormale drehen darf, nach rechts (unter 0) und nach links der Fahrt.</translation>
    </message>
    <message>
        <source>How far the true surface may lie outside and inside the mesh. 0 takes the mesh as the part; of STEP and IGES files what was measured counts, where that is more.</source>
        <translation>Wie weit die wahre Fläche außerhalb und innerhalb des Netzes liegen darf. 0 nimmt das Netz als das Teil; bei STEP- und IGES-Dateien zählt das Gemessene, wo es mehr ist.</translation>
    </message>
    <message>
        <source>How far white lies above black, which is Z 0; of floating point numbers the highest above the lowest. `auto`: 5 mm, with a warning.</source>
        <translation>Wie weit Weiß über Schwarz liegt, das Z 0 ist; bei Fließkommazahlen die höchste über der niedrigsten. auto: 5 mm, mit Warnung.</translation>
    </message>
    <message>
        <source>How long a picture is along Y, from its lowest row to its highest. `auto`: as its pixels are, square.</source>
        <translation>Wie lang ein Bild entlang Y ist, von der untersten bis zur obersten Zeile. auto: wie seine Pixel, quadratisch.</translation>
    </message>
    <message>
        <source>How many facets the part had when they were painted. Where it has another number now, they are no longer known.</source>
        <translation>Wie viele Facetten das Teil beim Malen hatte. Hat es jetzt eine andere Zahl, sind sie nicht mehr bekannt.</translation>
    </message>
    <message>
        <source>How much deeper each pass goes than the one before, from the stock's outside towards the axis.</source>
        <translation>Um wie viel jede Bahn tiefer geht als die vorherige, von der Außenseite des Rohteils zur Achse.</translation>
    </message>
    <message>
        <source>How much the normals of facets side by side may differ on a surface of a STEP or IGES file.</source>
        <translation>Wie stark sich die Normalen benachbarter Facetten auf einer Fläche einer STEP- oder IGES-Datei unterscheiden dürfen.</translation>
    </message>
    <message>
        <source>How often the curve is gone along, each time deeper; the last one is the depth.</source>
        <translation>Wie oft der Kurve gefolgt wird, jedes Mal tiefer; der letzte Schnitt hat die Tiefe.</translation>
    </message>
    <message>
        <source>How the allowance is kept: contact is exact; vertices moves every vertex along its normal, cruder, and says what it cuts beyond.</source>
        <translation>Wie das Aufmaß eingehalten wird: am Berührpunkt ist genau; durch verschobene Eckpunkte verschiebt jeden Eckpunkt entlang seiner Normalen, gröber, und sagt, was darüber hinaus gefräst wird.</translation>
    </message>
    <message>
        <source>How the tool comes into material where it cannot come from outside: auto takes a ramp along the first cut, or a helix where that is too short; plunge goes straight down.</source>
        <translation>Wie das Werkzeug ins Material kommt, wo es von außen nicht kann: auto nimmt eine Rampe entlang des ersten Schnitts, oder eine Wendel, wo der zu kurz ist; senkrecht geht gerade hinab.</translation>
    </message>
    <message>
        <source>How the tool is moved out of what it would cut: along a vector fitted to the strip, or along Z.</source>
        <translation>Wie das Werkzeug aus dem herausbewegt wird, was es verletzen würde: entlang eines an den Streifen angepassten Vektors oder entlang Z.</translation>
    </message>
    <message>
        <source>How the tool is run, by material. Operations take it over when they take the tool.</source>
        <translation>Wie das Werkzeug läuft, nach Werkstoff. Operationen übernehmen es mit dem Werkzeug.</translation>
    </message>
    <message>
        <source>How tool axes are chosen: cm2 matches curvatures, local stays closest to one axis point by point, global takes the path that needs least machining time.</source>
        <translation>Wie Werkzeugachsen gewählt werden: krümmungsgleich (CM²) gleicht Krümmungen an, lokal bleibt Punkt für Punkt einer Achse am nächsten, global nimmt den Weg mit der kürzesten Bearbeitungszeit.</translation>
    </message>
    <message>
        <source>How wide a picture (PNG, TIFF) is as a part, along X from its first column to its last. `auto`: 100 mm, with a warning.</source>
        <translation>Wie breit ein Bild (PNG, TIFF) als Teil ist, entlang X von der ersten bis zur letzten Spalte. auto: 100 mm, mit Warnung.</translation>
    </message>
    <message>
        <source>Inclination of the tool axis from the surface normal towards the travel. The lead limits do not hold it.</source>
        <translation>Neigung der Werkzeugachse von der Flächennormalen zur Fahrtrichtung. Die Grenzen des Anstellwinkels gelten nicht dafür.</translation>
    </message>
    <message>
        <source>Indexing the part</source>
        <translation>Das Teil wird erfasst</translation>
    </message>
    <message>
        <source>Into the material; 0: half the feed.</source>
        <translation>Ins Material; 0: der halbe Vorschub.</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isometrisch</translation>
    </message>
    <message>
        <source>Its axes and speeds decide the machining time.</source>
        <translation>Ihre Achsen und Geschwindigkeiten bestimmen die Bearbeitungszeit.</translation>
    </message>
    <message>
        <source>Jasra's turned cylinder: Ø40 mm, 25 mm long, about the X axis.</source>
        <translation>Jasras gedrehter Zylinder: Ø40 mm, 25 mm lang, um die X-Achse.</translation>
    </message>
    <message>
        <source>Jasra's turned prism: side 50 mm, 40 mm long, about the X axis.</source>
        <translation>Jasras gedrehtes Prisma: Seite 50 mm, 40 mm lang, um die X-Achse.</translation>
    </message>
    <message>
        <source>Joining scans</source>
        <translation>Scans werden verbunden</translation>
    </message>
    <message>
        <source>Joins closed passes that lie within each other to one, whose turns go evenly from each to the next.</source>
        <translation>Verbindet geschlossene Bahnen, die ineinander liegen, zu einer, deren Windungen gleichmäßig von einer zur nächsten gehen.</translation>
    </message>
    <message>
        <source>Joint rate</source>
        <translation>Achsgeschwindigkeit</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Kept off</source>
        <translation>Gemieden</translation>
    </message>
    <message>
        <source>Kept postures</source>
        <translation>Festgehaltene Stellungen</translation>
    </message>
    <message>
        <source>Kept within</source>
        <translation>Darin bleibt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>Art der Bewegung</translation>
    </message>
    <message>
        <source>Largest distance between neighbouring lines of a layer, at most the diameter; auto is 0.95 of the diameter.</source>
        <translation>Größter Abstand benachbarter Linien einer Ebene, höchstens der Durchmesser; auto ist 0,95 des Durchmessers.</translation>
    </message>
    <message>
        <source>Largest excess</source>
        <translation>Größter Überstand</translation>
    </message>
    <message>
        <source>Largest inclination of the assumed previous path, which tells how much lead every place needs; and of the rework path by cm2.</source>
        <translation>Größte Neigung des angenommenen vorherigen Wegs, der sagt, wie viel Anstellwinkel jede Stelle braucht; bei cm2 auch des Nacharbeitswegs.</translation>
    </message>
    <message>
        <source>Largest inclination of the main path's tool axis, alpha_M, where it is not raised. Smaller: wider strips and more to rework.</source>
        <translation>Größte Neigung der Werkzeugachse des Hauptwegs, alpha_M, wo sie nicht erhöht wird. Kleiner: breitere Streifen und mehr nachzuarbeiten.</translation>
    </message>
    <message>
        <source>Largest inclination of the tool axis, used where shank or holder would touch the part. 0 keeps the tool upright; above 0 the program is one of five axes.</source>
        <translation>Größte Neigung der Werkzeugachse, verwendet, wo Schaft oder Halter das Teil berühren würden. 0 hält das Werkzeug senkrecht; über 0 ist das Programm eines mit fünf Achsen.</translation>
    </message>
    <message>
        <source>Largest inclination on a part that is cut side by side, for pieces with places that no inclination within the lead limits reaches: undersides, faces of blades behind others. No larger than the upper lead limit: these are left, and said.</source>
        <translation>Größte Neigung auf einem Teil, das Seite für Seite gefräst wird, für Stücke mit Stellen, die keine Neigung innerhalb der Grenzen erreicht: Unterseiten, Schaufeln hinter anderen. Nicht größer als die obere Grenze: diese bleiben stehen und werden gesagt.</translation>
    </message>
    <message>
        <source>Largest step-down</source>
        <translation>Größte Zustellung</translation>
    </message>
    <message>
        <source>Largest turn of the surface normal between neighbouring points of a pass{1}.</source>
        <translation>Größte Drehung der Flächennormalen zwischen benachbarten Punkten einer Bahn{1}.</translation>
    </message>
    <message>
        <source>Largest turn of the tool axis between neighbouring points of a pass.</source>
        <translation>Größte Drehung der Werkzeugachse zwischen benachbarten Punkten einer Bahn.</translation>
    </message>
    <message>
        <source>Lathe-mill, part turns about X (4-axis)</source>
        <translation>Dreh-Fräsmaschine, Teil dreht um X (4-achsig)</translation>
    </message>
    <message>
        <source>Layer chosen</source>
        <translation>Gewählte Ebene</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Anstellwinkel</translation>
    </message>
    <message>
        <source>Lead limit</source>
        <translation>Grenze des Anstellwinkels</translation>
    </message>
    <message>
        <source>Lead limits</source>
        <translation>Grenzen des Anstellwinkels</translation>
    </message>
    <message>
        <source>Lead to reach</source>
        <translation>Anstellwinkel zum Erreichen</translation>
    </message>
    <message>
        <source>Lead, deg</source>
        <translation>Anstellwinkel, °</translation>
    </message>
    <message>
        <source>Leaves too much</source>
        <translation>Lässt zu viel stehen</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Left by</source>
        <translation>Gelassen von</translation>
    </message>
    <message>
        <source>Left to clean-up</source>
        <translation>Der Restbearbeitung überlassen</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length of the section along the axis.</source>
        <translation>Länge des Abschnitts entlang der Achse.</translation>
    </message>
    <message>
        <source>Length that the chuck holds, from the stock's low end, and its diameter: no part of the tool comes nearer than the clearance. Length 0: none.</source>
        <translation>Länge, die das Futter hält, vom unteren Ende des Rohteils, und sein Durchmesser: kein Teil des Werkzeugs kommt näher als der Sicherheitsabstand. Länge 0: keines.</translation>
    </message>
    <message>
        <source>Lies on the table</source>
        <translation>Liegt auf dem Tisch</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Abhub</translation>
    </message>
    <message>
        <source>Lift, {1}</source>
        <translation>Abhub, {1}</translation>
    </message>
    <message>
        <source>Lines that the format does not know were ignored.</source>
        <translation>Zeilen, die das Format nicht kennt, wurden übergangen.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Verbindungsvorschub</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>LinuxCNC, TCP by switched kinematics</source>
        <translation>LinuxCNC, TCP durch umgeschaltete Kinematik</translation>
    </message>
    <message>
        <source>Lollipop</source>
        <translation>Kugelfräser mit Hals</translation>
    </message>
    <message>
        <source>Longer than the tool's flutes, which are {1}</source>
        <translation>Länger als die Schneiden des Werkzeugs, die {1} lang sind</translation>
    </message>
    <message>
        <source>Looking at the part</source>
        <translation>Das Teil wird untersucht</translation>
    </message>
    <message>
        <source>Looking at the stock</source>
        <translation>Das Rohteil wird untersucht</translation>
    </message>
    <message>
        <source>Looking at what both paths clear</source>
        <translation>Gesucht wird, was beide Wege abtragen</translation>
    </message>
    <message>
        <source>Looking at what the main path clears</source>
        <translation>Gesucht wird, was der Hauptweg abträgt</translation>
    </message>
    <message>
        <source>Looking for air</source>
        <translation>Luftwege werden gesucht</translation>
    </message>
    <message>
        <source>Looking for crossings</source>
        <translation>Überschneidungen werden gesucht</translation>
    </message>
    <message>
        <source>Looking for faces to lie on</source>
        <translation>Flächen zum Auflegen werden gesucht</translation>
    </message>
    <message>
        <source>Looking for holes</source>
        <translation>Löcher werden gesucht</translation>
    </message>
    <message>
        <source>Looking for loose pieces</source>
        <translation>Lose Stücke werden gesucht</translation>
    </message>
    <message>
        <source>Looking for pieces</source>
        <translation>Stücke werden gesucht</translation>
    </message>
    <message>
        <source>Looking for sharp changes of normals</source>
        <translation>Scharfe Änderungen der Normalen werden gesucht</translation>
    </message>
    <message>
        <source>Looking for sides</source>
        <translation>Seiten werden gesucht</translation>
    </message>
    <message>
        <source>Looking for valleys</source>
        <translation>Täler werden gesucht</translation>
    </message>
    <message>
        <source>Looking for what stays</source>
        <translation>Gesucht wird, was bleibt</translation>
    </message>
    <message>
        <source>Looking for what stays uncut</source>
        <translation>Gesucht wird, was stehen bleibt</translation>
    </message>
    <message>
        <source>Looking where the previous cutter left something</source>
        <translation>Gesucht wird, wo der vorherige Fräser etwas ließ</translation>
    </message>
    <message>
        <source>Lowest free lift</source>
        <translation>Kleinster freier Abhub</translation>
    </message>
    <message>
        <source>Lowest free lift, stopped by:</source>
        <translation>Kleinster freier Abhub, begrenzt durch:</translation>
    </message>
    <message>
        <source>Lu's first benchmark: a ruled valley, 10 × 10 in.</source>
        <translation>Lus erste Prüffläche: ein geregeltes Tal, 10 × 10 in.</translation>
    </message>
    <message>
        <source>Lu's second benchmark: a ruled ridge, 10 × 10 in.</source>
        <translation>Lus zweite Prüffläche: ein geregelter Grat, 10 × 10 in.</translation>
    </message>
    <message>
        <source>Lu's third benchmark: convex, concave and saddle regions, 9 × 11 in.</source>
        <translation>Lus dritte Prüffläche: gewölbt, hohl und Sattel, 9 × 11 in.</translation>
    </message>
    <message>
        <source>Mach3 and Mach4</source>
        <translation>Mach3 und Mach4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machining direction</source>
        <translation>Richtung der Bearbeitung</translation>
    </message>
    <message>
        <source>Machining tolerance: the largest cusp that may be left. Gouges are not allowed at all.</source>
        <translation>Bearbeitungstoleranz: die größte Rille, die bleiben darf. Verletzungen sind überhaupt nicht erlaubt.</translation>
    </message>
    <message>
        <source>Makes the {1} so many times as large as its file and unit say, about the file's origin; 1 leaves it. Unit, scale, mirror, rotate and translate are applied in this order.</source>
        <translation>Macht das Objekt ({1}) so viele Male so groß, wie Datei und Einheit sagen, um den Ursprung der Datei; 1 lässt es. Einheit, Skalierung, Spiegelung, Drehung und Verschiebung folgen in dieser Reihenfolge.</translation>
    </message>
    <message>
        <source>Making passes</source>
        <translation>Bahnen werden gebildet</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Zugabe</translation>
    </message>
    <message>
        <source>Marlin</source>
        <translation>Marlin</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Measuring steps over the surface</source>
        <translation>Schritte über die Oberfläche werden gemessen</translation>
    </message>
    <message>
        <source>Measuring the part</source>
        <translation>Das Teil wird vermessen</translation>
    </message>
    <message>
        <source>Measuring what is left</source>
        <translation>Gemessen wird, was stehen blieb</translation>
    </message>
    <message>
        <source>Measuring what stays</source>
        <translation>Gemessen wird, was bleibt</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegelung</translation>
    </message>
    <message>
        <source>More than</source>
        <translation>Mehr als</translation>
    </message>
    <message>
        <source>More than the tool's radius, which is {1}</source>
        <translation>Mehr als der Werkzeugradius, der {1} ist</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>Mould cavity</source>
        <translation>Formnest</translation>
    </message>
    <message>
        <source>Moved ({1})</source>
        <translation>Verschoben ({1})</translation>
    </message>
    <message>
        <source>Moves it after it was turned.</source>
        <translation>Verschiebt es nach dem Drehen.</translation>
    </message>
    <message>
        <source>Moves the border outward by so much, inward below 0.</source>
        <translation>Verschiebt den Rand um so viel nach außen, unter 0 nach innen.</translation>
    </message>
    <message>
        <source>Moves the part after it was turned.</source>
        <translation>Verschiebt das Teil nach dem Drehen.</translation>
    </message>
    <message>
        <source>Moves the stock's mesh after it was turned.</source>
        <translation>Verschiebt das Netz des Rohteils nach dem Drehen.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, the curve or border of which is followed, seen from above. A drawn curve is taken without its offset. Empty: the outline of what is cut.</source>
        <translation>Name einer Begrenzung der Aufspannung, deren Kurve oder Rand gefolgt wird, von oben gesehen. Eine gezeichnete Kurve gilt ohne ihren Versatz. Leer: der Umriss dessen, was gefräst wird.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, the curve or border of which passes follow, with 'Begin at' curve, seen from above. Empty: the outline of what is cut.</source>
        <translation>Name einer Begrenzung der Aufspannung, deren Kurve oder Rand die Bahnen folgen, wenn sie an einer Kurve beginnen, von oben gesehen. Leer: der Umriss dessen, was gefräst wird.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, with the curve at which the passes begin. Empty, both: halves of the outline of what is cut.</source>
        <translation>Name einer Begrenzung der Aufspannung mit der Kurve, an der die Bahnen beginnen. Beide leer: Hälften des Umrisses dessen, was gefräst wird.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup: the operation cuts within it. Empty: everywhere.</source>
        <translation>Name einer Begrenzung der Aufspannung: die Operation fräst darin. Leer: überall.</translation>
    </message>
    <message>
        <source>Name of a boundary whose facets the tool keeps off. Empty: none.</source>
        <translation>Name einer Begrenzung, deren Facetten das Werkzeug meidet. Leer: keine.</translation>
    </message>
    <message>
        <source>Name of the boundary with the curve at which the passes end.</source>
        <translation>Name der Begrenzung mit der Kurve, an der die Bahnen enden.</translation>
    </message>
    <message>
        <source>Name of the operation; also names its output file.</source>
        <translation>Name der Operation; benennt auch ihre Ausgabedatei.</translation>
    </message>
    <message>
        <source>Names of strips that are found but not cut, separated by commas.</source>
        <translation>Namen gefundener, aber nicht gefräster Streifen, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>Neighbouring facets run along their common edge in the same direction: some are turned over. None was turned back.</source>
        <translation>Benachbarte Facetten laufen entlang ihrer gemeinsamen Kante in dieselbe Richtung: einige sind umgedreht. Keine wurde zurückgedreht.</translation>
    </message>
    <message>
        <source>New surface</source>
        <translation>Neue Fläche</translation>
    </message>
    <message>
        <source>No larger than the tool that is to come in after it: {1} and {2}</source>
        <translation>Nicht größer als das Werkzeug, das danach hineinkommen soll: {1} und {2}</translation>
    </message>
    <message>
        <source>No point</source>
        <translation>Kein Punkt</translation>
    </message>
    <message>
        <source>No posture is free here</source>
        <translation>Hier ist keine Stellung frei</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normal change limit</source>
        <translation>Grenze der Normalenänderung</translation>
    </message>
    <message>
        <source>Normal limit</source>
        <translation>Normalengrenze</translation>
    </message>
    <message>
        <source>Not moved</source>
        <translation>Nicht verschoben</translation>
    </message>
    <message>
        <source>Not verified, do not run: {1}</source>
        <translation>Nicht geprüft, nicht laufen lassen: {1}</translation>
    </message>
    <message>
        <source>Nothing to show</source>
        <translation>Nichts zu zeigen</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Number of the first program, for controls that want one; those after it count on.</source>
        <translation>Nummer des ersten Programms, für Steuerungen, die eine wollen; die folgenden zählen weiter.</translation>
    </message>
    <message>
        <source>Number of the tool in the tool list.</source>
        <translation>Nummer des Werkzeugs in der Werkzeugliste.</translation>
    </message>
    <message>
        <source>Number of the tool that cut the part before: clean-up looks for what it could not enter.</source>
        <translation>Nummer des Werkzeugs, das das Teil vorher fräste: die Restbearbeitung sucht, wo es nicht hineinkam.</translation>
    </message>
    <message>
        <source>Number of the tool that cuts the regions; 0: none, they are shown and left to other operations.</source>
        <translation>Nummer des Werkzeugs, das die Bereiche fräst; 0: keines, sie werden gezeigt und anderen Operationen überlassen.</translation>
    </message>
    <message>
        <source>Number of the tool. The region is what it leaves of the part where it has been everywhere: hollows narrower than it, inner edges.</source>
        <translation>Nummer des Werkzeugs. Der Bereich ist, was es vom Teil lässt, wo es überall war: Mulden, schmaler als es, Innenkanten.</translation>
    </message>
    <message>
        <source>Numbers have decimal commas; they were read as such.</source>
        <translation>Zahlen haben Dezimalkommas; sie wurden so gelesen.</translation>
    </message>
    <message>
        <source>Numbers of faces of the part's file, counted from 0: 0-3, 7. They are the same however finely the file is tessellated.</source>
        <translation>Nummern von Flächen der Datei des Teils, von 0 gezählt: 0-3, 7. Sie bleiben, wie fein die Datei auch vernetzt wird.</translation>
    </message>
    <message>
        <source>Numbers of the painted facets, counted from 0 in the part's file: 0-57, 60.</source>
        <translation>Nummern der gemalten Facetten, von 0 gezählt in der Datei des Teils: 0-57, 60.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objekte</translation>
    </message>
    <message>
        <source>Objects have slices beside their mesh, which may be a coarse stand-in for them; the mesh was read.</source>
        <translation>Objekte haben neben ihrem Netz Schichten, für die es ein grober Ersatz sein kann; gelesen wurde das Netz.</translation>
    </message>
    <message>
        <source>Objects of the file that are no part of the model (supports, modifiers) were left out.</source>
        <translation>Objekte der Datei, die nicht zum Modell gehören (Stützen, Modifikatoren), wurden weggelassen.</translation>
    </message>
    <message>
        <source>Of a tab as it is seen along its length. A triangular one is cut in ramps and breaks off more easily.</source>
        <translation>Eines Stegs, entlang seiner Länge gesehen. Ein dreieckiger wird in Rampen gefräst und bricht leichter ab.</translation>
    </message>
    <message>
        <source>Of cuts; 0: from spindle, chip load and flutes.</source>
        <translation>Beim Fräsen; 0: aus Drehzahl, Zahnvorschub und Schneiden.</translation>
    </message>
    <message>
        <source>Of layers; 0 where nobody says.</source>
        <translation>Von Ebenen; 0, wo niemand sie nennt.</translation>
    </message>
    <message>
        <source>Of so many</source>
        <translation>Von so vielen</translation>
    </message>
    <message>
        <source>Of the box along X, Y and Z, before it is turned; of a tab its length from the part outward, its width and its height.</source>
        <translation>Des Quaders entlang X, Y und Z, bevor er gedreht wird; eines Stegs seine Länge vom Teil nach außen, Breite und Höhe.</translation>
    </message>
    <message>
        <source>Of the cylinder, along Z before it is turned.</source>
        <translation>Des Zylinders, entlang Z, bevor er gedreht wird.</translation>
    </message>
    <message>
        <source>Of the cylinder.</source>
        <translation>Des Zylinders.</translation>
    </message>
    <message>
        <source>Of the cylinder; `auto`: what holds the part and the margin.</source>
        <translation>Des Zylinders; auto: was Teil und Zugabe enthält.</translation>
    </message>
    <message>
        <source>Of the plain part between flutes and holder.</source>
        <translation>Des glatten Teils zwischen Schneiden und Halter.</translation>
    </message>
    <message>
        <source>Of the plain part that is out of the holder.</source>
        <translation>Des glatten Teils, der aus dem Halter ragt.</translation>
    </message>
    <message>
        <source>Of the setup. Each has its own.</source>
        <translation>Der Aufspannung. Jede hat ihren eigenen.</translation>
    </message>
    <message>
        <source>Of the stock in all, X, Y and Z: the part and its margins. Either can be typed; the project keeps the margins.</source>
        <translation>Des ganzen Rohteils, X, Y und Z: das Teil und seine Zugaben. Beides lässt sich eintippen; das Projekt behält die Zugaben.</translation>
    </message>
    <message>
        <source>Of the stock that begins in setup '{1}'.</source>
        <translation>Vom Rohteil, das in Aufspannung '{1}' beginnt.</translation>
    </message>
    <message>
        <source>Of the work coordinates, from the place that `zero_from` says; from the part's origin a point of the part.</source>
        <translation>Der Werkstückkoordinaten, von der Stelle aus, die `zero_from` nennt; vom Ursprung des Teils aus ein Punkt des Teils.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Off centre</source>
        <translation>Außermittig</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot work with it: {1} {2}</source>
        <translation>OpenCASCADE kommt damit nicht zurecht: {1} {2}</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Operations name the boundary by it.</source>
        <translation>Operationen nennen die Begrenzung so.</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>Out of holder</source>
        <translation>Aus dem Halter</translation>
    </message>
    <message>
        <source>Over the tolerance</source>
        <translation>Über der Toleranz</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>PLY ASCII</source>
        <translation>PLY ASCII</translation>
    </message>
    <message>
        <source>PLY binary</source>
        <translation>PLY binär</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Part before</source>
        <translation>Teil zuvor</translation>
    </message>
    <message>
        <source>Part from</source>
        <translation>Teil von</translation>
    </message>
    <message>
        <source>Part in them</source>
        <translation>Teil darin</translation>
    </message>
    <message>
        <source>Part to</source>
        <translation>Teil bis</translation>
    </message>
    <message>
        <source>Part's size</source>
        <translation>Größe des Teils</translation>
    </message>
    <message>
        <source>Part, stock and machine</source>
        <translation>Teil, Rohteil und Maschine</translation>
    </message>
    <message>
        <source>Parts of the picture are transparent: the more so, the nearer they lie to the ground.</source>
        <translation>Teile des Bildes sind durchsichtig: je mehr, desto näher liegen sie am Grund.</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Passes about the centre</source>
        <translation>Bahnen um den Mittelpunkt</translation>
    </message>
    <message>
        <source>Passes along valleys</source>
        <translation>Bahnen entlang der Täler</translation>
    </message>
    <message>
        <source>Passes from curve to curve</source>
        <translation>Bahnen von Kurve zu Kurve</translation>
    </message>
    <message>
        <source>Passes from the centre outward</source>
        <translation>Bahnen vom Mittelpunkt nach außen</translation>
    </message>
    <message>
        <source>Passes on either side of the one along the valley. 0: that one alone.</source>
        <translation>Bahnen auf jeder Seite derjenigen entlang des Tals. 0: nur diese.</translation>
    </message>
    <message>
        <source>Passes over shallow surface</source>
        <translation>Bahnen über flache Flächen</translation>
    </message>
    <message>
        <source>Passes over what is less steep: parallel keeps to drive planes; scallop follows the border, with cusps of one height.</source>
        <translation>Bahnen über das, was flacher ist: parallel bleibt in Führungsebenen; gleiche Rillenhöhe folgt dem Rand.</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Muster</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Kehlbahnen</translation>
    </message>
    <message>
        <source>Picked point</source>
        <translation>Gewählter Punkt</translation>
    </message>
    <message>
        <source>Picture length</source>
        <translation>Bildlänge</translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation>Bildbreite</translation>
    </message>
    <message>
        <source>Pillar</source>
        <translation>Säule</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>Place in the magazine; operations name the tool by it.</source>
        <translation>Platz im Magazin; Operationen nennen das Werkzeug so.</translation>
    </message>
    <message>
        <source>Place of the centre, seen from above, where it is not the middle.</source>
        <translation>Ort des Mittelpunkts, von oben gesehen, wo er nicht die Mitte ist.</translation>
    </message>
    <message>
        <source>Place on the part whose nearest contact point it is for.</source>
        <translation>Stelle auf dem Teil, für deren nächsten Berührpunkt sie gilt.</translation>
    </message>
    <message>
        <source>Places looked at</source>
        <translation>Betrachtete Stellen</translation>
    </message>
    <message>
        <source>Placing drive planes</source>
        <translation>Führungsebenen werden gelegt</translation>
    </message>
    <message>
        <source>Placing turns</source>
        <translation>Windungen werden gelegt</translation>
    </message>
    <message>
        <source>Planning passes</source>
        <translation>Bahnen werden geplant</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Points of the regions' boundaries that were dragged over the surface.</source>
        <translation>Punkte der Begrenzungen, die über die Fläche gezogen wurden.</translation>
    </message>
    <message>
        <source>Points per turn</source>
        <translation>Punkte je Umdrehung</translation>
    </message>
    <message>
        <source>Polygons with more than three corners were cut into triangles.</source>
        <translation>Vielecke mit mehr als drei Ecken wurden in Dreiecke zerlegt.</translation>
    </message>
    <message>
        <source>Posting</source>
        <translation>Ausgeben</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Stellung</translation>
    </message>
    <message>
        <source>Posture grid</source>
        <translation>Stellungsraster</translation>
    </message>
    <message>
        <source>Posture kept by hand</source>
        <translation>Von Hand festgehaltene Stellung</translation>
    </message>
    <message>
        <source>Postures chosen by hand for single contact points, in the configuration space of the point; used wherever they are free.</source>
        <translation>Von Hand für einzelne Berührpunkte gewählte Stellungen, im Konfigurationsraum des Punktes; verwendet, wo sie frei sind.</translation>
    </message>
    <message>
        <source>Preparing the view</source>
        <translation>Die Ansicht wird vorbereitet</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Voreinstellung</translation>
    </message>
    <message>
        <source>Previous tool</source>
        <translation>Vorheriges Werkzeug</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Program number</source>
        <translation>Programmnummer</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Programs for the control</source>
        <translation>Programme für die Steuerung</translation>
    </message>
    <message>
        <source>Programs of three axes hold arcs (`G2`, `G3`) where the control has them and one stands for three motions or more: every end of a motion within a quarter of the chord tolerance of the arc, and the arc within half of it of the motions. Where the tool leans, in tilted planes alone.</source>
        <translation>Programme mit drei Achsen enthalten Bögen (`G2`, `G3`), wo die Steuerung sie kennt und einer für drei Bewegungen oder mehr steht: jedes Ende einer Bewegung innerhalb eines Viertels der Sehnentoleranz vom Bogen, und der Bogen innerhalb der Hälfte davon. Wo das Werkzeug geneigt ist, nur in geschwenkten Ebenen.</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Raise lead limit</source>
        <translation>Grenze erhöhen</translation>
    </message>
    <message>
        <source>Raised pads on a cylinder Ø40 mm, 54 mm long, about the X axis.</source>
        <translation>Erhabene Felder auf einem Zylinder Ø40 mm, 54 mm lang, um die X-Achse.</translation>
    </message>
    <message>
        <source>Ramp angle</source>
        <translation>Rampenwinkel</translation>
    </message>
    <message>
        <source>Ramp feed</source>
        <translation>Eintauchvorschub</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Rapid, {1}</source>
        <translation>Eilgang, {1}</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lesen</translation>
    </message>
    <message>
        <source>Reading the part</source>
        <translation>Das Teil wird gelesen</translation>
    </message>
    <message>
        <source>Reading the {1}</source>
        <translation>Wird gelesen: {1}</translation>
    </message>
    <message>
        <source>Reading {1}</source>
        <translation>{1} wird gelesen</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Hinten</translation>
    </message>
    <message>
        <source>Rear jaw</source>
        <translation>Hintere Backe</translation>
    </message>
    <message>
        <source>Region edits</source>
        <translation>Änderungen der Bereiche</translation>
    </message>
    <message>
        <source>Region {1}</source>
        <translation>Bereich {1}</translation>
    </message>
    <message>
        <source>Relief height</source>
        <translation>Reliefhöhe</translation>
    </message>
    <message>
        <source>Removing fins</source>
        <translation>Lappen werden entfernt</translation>
    </message>
    <message>
        <source>Removing material{1}</source>
        <translation>Material wird abgetragen{1}</translation>
    </message>
    <message>
        <source>Removing needles</source>
        <translation>Nadeln werden entfernt</translation>
    </message>
    <message>
        <source>Removing small pieces</source>
        <translation>Kleine Stücke werden entfernt</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Reparatur</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Rest material</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Rest only</source>
        <translation>Nur Restmaterial</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>Rework and clean-up regions</source>
        <translation>Nacharbeits- und Restbereiche</translation>
    </message>
    <message>
        <source>Rework cutting</source>
        <translation>Fräsen der Nacharbeit</translation>
    </message>
    <message>
        <source>Rework offset</source>
        <translation>Versatz der Nacharbeit</translation>
    </message>
    <message>
        <source>Rework regions that were switched off, grown or shrunk by hand.</source>
        <translation>Nacharbeitsbereiche, die von Hand ausgeschaltet, vergrößert oder verkleinert wurden.</translation>
    </message>
    <message>
        <source>Rework tool</source>
        <translation>Werkzeug der Nacharbeit</translation>
    </message>
    <message>
        <source>Ribs swept around a cylinder Ø40 mm, 54 mm long, about the X axis.</source>
        <translation>Rippen um einen Zylinder Ø40 mm, 54 mm lang, um die X-Achse.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Rough, turning part</source>
        <translation>Schruppen, drehendes Teil</translation>
    </message>
    <message>
        <source>STL ASCII</source>
        <translation>STL ASCII</translation>
    </message>
    <message>
        <source>STL binary</source>
        <translation>STL binär</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Second curve</source>
        <translation>Zweite Kurve</translation>
    </message>
    <message>
        <source>Second point of an axis through two points.</source>
        <translation>Zweiter Punkt einer Achse durch zwei Punkte.</translation>
    </message>
    <message>
        <source>Setup sheet</source>
        <translation>Einrichteblatt</translation>
    </message>
    <message>
        <source>Setup {1}</source>
        <translation>Aufspannung {1}</translation>
    </message>
    <message>
        <source>Shallow</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Shallow by</source>
        <translation>Flaches durch</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shank diameter</source>
        <translation>Schaftdurchmesser</translation>
    </message>
    <message>
        <source>Shank length</source>
        <translation>Schaftlänge</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Shape of the raw material. `rest`: what the setup before left of its stock, as it was verified; not in the first setup.</source>
        <translation>Form des Rohmaterials. Rest: was die vorherige Aufspannung von ihrem Rohteil ließ, wie es geprüft wurde; nicht in der ersten.</translation>
    </message>
    <message>
        <source>Shape of what holds the part: a vice's jaw or a clamp is a box, a bolt or a chuck a cylinder. A tab is a piece of the stock that is left between part and rest.</source>
        <translation>Form dessen, was das Teil hält: eine Backe oder Spannpratze ist ein Quader, ein Bolzen oder Futter ein Zylinder. Ein Steg ist ein Stück Rohteil, das zwischen Teil und Rest stehen bleibt.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>Shorter valleys are left out, and shorter gaps in one are passed over. auto is the cutter's radius.</source>
        <translation>Kürzere Täler werden ausgelassen und kürzere Lücken in einem übergangen. auto ist der Radius des Fräsers.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Side feed</source>
        <translation>Seitenvorschub</translation>
    </message>
    <message>
        <source>Side passes</source>
        <translation>Seitliche Bahnen</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>Siemens, TRAORI with tool vectors</source>
        <translation>Siemens, TRAORI mit Werkzeugvektoren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Slope at which ramps and helices go down.</source>
        <translation>Neigung, mit der Rampen und Wendeln hinabgehen.</translation>
    </message>
    <message>
        <source>Slope from level at which the part is divided: what is steeper is cut by levels, what is less steep by passes side by side.</source>
        <translation>Neigung gegen die Waagrechte, an der das Teil geteilt wird: was steiler ist, wird in Höhenlinien gefräst, was flacher ist, in Bahnen nebeneinander.</translation>
    </message>
    <message>
        <source>Slope limit</source>
        <translation>Neigungsgrenze</translation>
    </message>
    <message>
        <source>Slope limits</source>
        <translation>Neigungsgrenzen</translation>
    </message>
    <message>
        <source>Slopes that are cut, from level: 0 is a floor, 90 degrees a wall. What is less steep is for parallel passes.</source>
        <translation>Neigungen, die bearbeitet werden, von der Waagrechten an: 0 ist ein Boden, 90 Grad eine Wand. Was weniger steil ist, ist für parallele Bahnen.</translation>
    </message>
    <message>
        <source>Slopes that are so near to the divide are cut both ways.</source>
        <translation>Neigungen, die der Teilung so nahe sind, werden auf beide Arten gefräst.</translation>
    </message>
    <message>
        <source>Slurm is not here</source>
        <translation>Slurm ist nicht da</translation>
    </message>
    <message>
        <source>Smallest and largest inclination of the tool axis from the surface normal towards the travel.</source>
        <translation>Kleinste und größte Neigung der Werkzeugachse von der Flächennormalen zur Fahrtrichtung.</translation>
    </message>
    <message>
        <source>Smallest strip</source>
        <translation>Kleinster Streifen</translation>
    </message>
    <message>
        <source>Smallest valley</source>
        <translation>Kleinstes Tal</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Some edges have more than two facets; all facets were kept.</source>
        <translation>Einige Kanten haben mehr als zwei Facetten; alle wurden behalten.</translation>
    </message>
    <message>
        <source>Some edges have only one facet: the mesh is a sheet or has gaps. Nothing was healed; a cutter may enter a gap.</source>
        <translation>Einige Kanten haben nur eine Facette: das Netz ist eine offene Fläche oder hat Lücken. Nichts wurde geheilt; ein Fräser kann in eine Lücke geraten.</translation>
    </message>
    <message>
        <source>Some facets have no area (equal or collinear corners); they were left out.</source>
        <translation>Einige Facetten haben keine Fläche (gleiche oder kollineare Ecken); sie wurden weggelassen.</translation>
    </message>
    <message>
        <source>Some facets lie farther from their surface than the chord tolerance that was asked for; the deviation says how far.</source>
        <translation>Einige Facetten liegen weiter von ihrer Fläche als die verlangte Sehnentoleranz; die Abweichung sagt, wie weit.</translation>
    </message>
    <message>
        <source>Some facets occur more than once, in this or the other winding; all were kept.</source>
        <translation>Einige Facetten kommen mehrmals vor, in diesem oder jenem Umlauf; alle wurden behalten.</translation>
    </message>
    <message>
        <source>Some polygons cross themselves; they were cut into triangles that overlap.</source>
        <translation>Einige Vielecke überkreuzen sich; sie wurden in überlappende Dreiecke zerlegt.</translation>
    </message>
    <message>
        <source>Some stored normals are missing or not numbers; normals are computed from the corners, so nothing is lost.</source>
        <translation>Einige gespeicherte Normalen fehlen oder sind keine Zahlen; Normalen werden aus den Ecken berechnet, nichts geht verloren.</translation>
    </message>
    <message>
        <source>Some stored normals point against the winding of their facets; the winding counts.</source>
        <translation>Einige gespeicherte Normalen zeigen gegen den Umlauf ihrer Facetten; der Umlauf zählt.</translation>
    </message>
    <message>
        <source>Some surfaces of the file could not be tessellated: the mesh has gaps.</source>
        <translation>Einige Flächen der Datei konnten nicht vernetzt werden: das Netz hat Lücken.</translation>
    </message>
    <message>
        <source>Special</source>
        <translation>Sonderform</translation>
    </message>
    <message>
        <source>Speed of cutting motion.</source>
        <translation>Geschwindigkeit beim Fräsen.</translation>
    </message>
    <message>
        <source>Speed of motion between passes that is no rapid: over the surface and away from it. auto is the feed.</source>
        <translation>Geschwindigkeit zwischen Bahnen, wo kein Eilgang ist: über der Fläche und von ihr weg. auto ist der Vorschub.</translation>
    </message>
    <message>
        <source>Speed of motion into the material: down to a pass, along ramps and helices. auto is half the feed.</source>
        <translation>Geschwindigkeit ins Material: hinab zu einer Bahn, entlang Rampen und Wendeln. auto ist der halbe Vorschub.</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Spindle speed.</source>
        <translation>Spindeldrehzahl.</translation>
    </message>
    <message>
        <source>Spindle, rpm</source>
        <translation>Drehzahl, U/min</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Square prism</source>
        <translation>Quadratisches Prisma</translation>
    </message>
    <message>
        <source>Stands in the report, the verdict and the setup sheet.</source>
        <translation>Steht im Bericht, im Prüfergebnis und im Einrichteblatt.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Anfang</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Steil</translation>
    </message>
    <message>
        <source>Steep and shallow</source>
        <translation>Steil und flach</translation>
    </message>
    <message>
        <source>Step of inclination and yaw in the configuration space.</source>
        <translation>Schritt von Neigung und Taumelwinkel im Konfigurationsraum.</translation>
    </message>
    <message>
        <source>Step-down</source>
        <translation>Zustellung in Z</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>Steps that make the file's mesh worth machining, in their order, carried out again whenever the file has changed.</source>
        <translation>Schritte, die das Netz der Datei bearbeitbar machen, in ihrer Reihenfolge, erneut ausgeführt, wenn sich die Datei ändert.</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Stock from</source>
        <translation>Rohteil von</translation>
    </message>
    <message>
        <source>Stock in them</source>
        <translation>Rohteil darin</translation>
    </message>
    <message>
        <source>Stock left on the part for a later operation. 0 cuts to size.</source>
        <translation>Material, das für eine spätere Operation auf dem Teil bleibt. 0 fräst auf Maß.</translation>
    </message>
    <message>
        <source>Stock to</source>
        <translation>Rohteil bis</translation>
    </message>
    <message>
        <source>Stock's size</source>
        <translation>Größe des Rohteils</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Strips also around contact points that operations before left to clean-up, as those without a free posture.</source>
        <translation>Streifen auch um Berührpunkte, die vorherige Operationen der Restbearbeitung ließen, etwa ohne freie Stellung.</translation>
    </message>
    <message>
        <source>Strips also where more than the tolerance stands after the operations before: their programs are verified first.</source>
        <translation>Streifen auch, wo nach den Operationen davor mehr als die Toleranz steht: deren Programme werden zuerst geprüft.</translation>
    </message>
    <message>
        <source>Surface that is steeper, from level, is left to other operations.</source>
        <translation>Oberfläche, die gegen die Waagrechte steiler ist, bleibt anderen Operationen.</translation>
    </message>
    <message>
        <source>Surface with a gap</source>
        <translation>Fläche mit Spalt</translation>
    </message>
    <message>
        <source>Surfaces of the file belong to no solid; they were taken as sheets.</source>
        <translation>Flächen der Datei gehören zu keinem Körper; sie gelten als offene Flächen.</translation>
    </message>
    <message>
        <source>Surfaces that lie edge to edge within the chord tolerance were joined: the file does not say that they hang together.</source>
        <translation>Flächen, die innerhalb der Sehnentoleranz Kante an Kante liegen, wurden verbunden: die Datei sagt nicht, dass sie zusammenhängen.</translation>
    </message>
    <message>
        <source>Swept pattern</source>
        <translation>Gewundenes Muster</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Switched off: the operation is left out of plan, verification and programs, as if it were not there.</source>
        <translation>Ausgeschaltet: die Operation fehlt in Plan, Prüfung und Programmen, als gäbe es sie nicht.</translation>
    </message>
    <message>
        <source>TLAXIS has not three values</source>
        <translation>TLAXIS hat nicht drei Werte</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Stege</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>Reitstock</translation>
    </message>
    <message>
        <source>Taken away</source>
        <translation>Weggenommen</translation>
    </message>
    <message>
        <source>Takes the other side of open surfaces as their outside. By itself that is the upper side of a sheet, and the side that is seen of what nearly closes; of closed bodies it is always the outside.</source>
        <translation>Nimmt die andere Seite offener Flächen als außen. Von selbst ist das ihre Oberseite, und bei fast Geschlossenem die sichtbare Seite; bei geschlossenen Körpern immer außen.</translation>
    </message>
    <message>
        <source>Taper angle</source>
        <translation>Flankenwinkel</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>Konisch mit Kugel</translation>
    </message>
    <message>
        <source>Tapered bull nose</source>
        <translation>Konischer Torus</translation>
    </message>
    <message>
        <source>Tapered cone-bottom bull nose</source>
        <translation>Konischer Torus mit Kegelstirn</translation>
    </message>
    <message>
        <source>Tapered drill point</source>
        <translation>Konische Bohrspitze</translation>
    </message>
    <message>
        <source>Tapered flat</source>
        <translation>Konisch flach</translation>
    </message>
    <message>
        <source>Tarus TPI 2000 (5-axis, head-head)</source>
        <translation>Tarus TPI 2000 (5-achsig, Kopf-Kopf)</translation>
    </message>
    <message>
        <source>Tessellating</source>
        <translation>Wird vernetzt</translation>
    </message>
    <message>
        <source>Tessellation tolerance</source>
        <translation>Toleranz der Vernetzung</translation>
    </message>
    <message>
        <source>That is the whole part: nowhere is what the programs leave held against the tolerance, only gouges are judged.</source>
        <translation>Das ist das ganze Teil: nirgends wird an der Toleranz gemessen, was die Programme lassen, nur Verletzungen werden beurteilt.</translation>
    </message>
    <message>
        <source>The OBJ file has curves or surfaces beside its facets; they were ignored.</source>
        <translation>Die OBJ-Datei hat neben Facetten Kurven oder Flächen; sie wurden übergangen.</translation>
    </message>
    <message>
        <source>The adaptive step-down is no larger than this. auto is the cutter's diameter.</source>
        <translation>Die adaptive Zustellung ist nicht größer. Automatisch ist der Durchmesser des Fräsers.</translation>
    </message>
    <message>
        <source>The attribute words of the binary STL file are not zero (colours of some writers); they were ignored.</source>
        <translation>Die Attributwörter der binären STL-Datei sind nicht null (Farben mancher Programme); sie wurden übergangen.</translation>
    </message>
    <message>
        <source>The binary STL file has its bytes in reverse order; it was read accordingly.</source>
        <translation>Die binäre STL-Datei hat ihre Bytes in umgekehrter Reihenfolge; sie wurde entsprechend gelesen.</translation>
    </message>
    <message>
        <source>The binary STL file starts with the word 'solid' like a text; it was read as binary.</source>
        <translation>Die binäre STL-Datei beginnt wie ein Text mit 'solid'; sie wurde binär gelesen.</translation>
    </message>
    <message>
        <source>The centre is the middle of what is cut, seen from above, whatever the centre says.</source>
        <translation>Der Mittelpunkt ist die Mitte dessen, was gefräst wird, von oben gesehen, was auch immer als Mittelpunkt angegeben ist.</translation>
    </message>
    <message>
        <source>The control that programs are written for, see below, or a file of your own (`resources/posts/README.md`); its name ends with `.json`, a relative one starts at the project file. Without it programs are APT alone.</source>
        <translation>Die Steuerung, für die Programme geschrieben werden, oder eine eigene Datei (`resources/posts/README.md`); ihr Name endet auf `.json`, ein relativer beginnt bei der Projektdatei. Ohne sie sind Programme nur APT.</translation>
    </message>
    <message>
        <source>The control's work coordinate system that programs are told in: `G54`, or the number of a preset. Default: the control's first, or what is active in it.</source>
        <translation>Das Werkstückkoordinatensystem der Steuerung, in dem Programme stehen: `G54`, oder die Nummer einer Voreinstellung. Vorgabe: das erste der Steuerung, oder was darin aktiv ist.</translation>
    </message>
    <message>
        <source>The curve ends at its last corner, instead of going back to the first.</source>
        <translation>Die Kurve endet an ihrer letzten Ecke, statt zur ersten zurückzugehen.</translation>
    </message>
    <message>
        <source>The curves end at their last corners, instead of going back to the first.</source>
        <translation>Die Kurven enden an ihren letzten Ecken, statt zu den ersten zurückzugehen.</translation>
    </message>
    <message>
        <source>The cylinders that the holder is made of, from the shank upward.</source>
        <translation>Die Zylinder, aus denen der Halter besteht, vom Schaft aufwärts.</translation>
    </message>
    <message>
        <source>The facet count in the header is wrong; the facets up to the end of the file were read.</source>
        <translation>Die Facettenzahl im Kopf ist falsch; gelesen wurden die Facetten bis zum Ende der Datei.</translation>
    </message>
    <message>
        <source>The file has further pictures; the first was read.</source>
        <translation>Die Datei hat weitere Bilder; das erste wurde gelesen.</translation>
    </message>
    <message>
        <source>The file has points or lines beside its facets; they were ignored.</source>
        <translation>Die Datei hat neben Facetten Punkte oder Linien; sie wurden übergangen.</translation>
    </message>
    <message>
        <source>The file has several parts or solids; all are in their places.</source>
        <translation>Die Datei hat mehrere Teile oder Körper; alle sind an ihren Plätzen.</translation>
    </message>
    <message>
        <source>The file has several solids; their facets were put together.</source>
        <translation>Die Datei hat mehrere Körper; ihre Facetten wurden zusammengelegt.</translation>
    </message>
    <message>
        <source>The file moves its meshes by bones, or into other shapes: they were read as they are modelled.</source>
        <translation>Die Datei bewegt ihre Netze durch Knochen oder in andere Formen: Sie wurden gelesen, wie sie modelliert sind.</translation>
    </message>
    <message>
        <source>The file states its own unit, which is not the one that the job says: that of the file counts.</source>
        <translation>Die Datei nennt ihre eigene Einheit, die nicht die des Auftrags ist: die der Datei gilt.</translation>
    </message>
    <message>
        <source>The fixture '{1}' stands in the part.</source>
        <translation>Das Spannmittel '{1}' steht im Teil.</translation>
    </message>
    <message>
        <source>The fixture's mesh ({1}), closed; a relative path starts at the project file.</source>
        <translation>Das Netz des Spannmittels ({1}), geschlossen; ein relativer Pfad beginnt bei der Projektdatei.</translation>
    </message>
    <message>
        <source>The last line has no line end: the file may have been cut. It was read as it stands.</source>
        <translation>Der letzten Zeile fehlt das Zeilenende: die Datei ist vielleicht abgeschnitten. Sie wurde gelesen, wie sie ist.</translation>
    </message>
    <message>
        <source>The machine cannot hold this axis: choose one whose rotary axes can</source>
        <translation>Die Maschine kann diese Achse nicht halten: eine wählen, die ihre Drehachsen können</translation>
    </message>
    <message>
        <source>The machine has no rotary axis that turns the part: choose a lathe-mill.</source>
        <translation>Die Maschine hat keine Drehachse, die das Teil dreht: eine Dreh-Fräsmaschine wählen.</translation>
    </message>
    <message>
        <source>The mesh consists of several pieces that share no edge; all are machined.</source>
        <translation>Das Netz besteht aus mehreren Stücken ohne gemeinsame Kante; alle werden gefräst.</translation>
    </message>
    <message>
        <source>The mesh is closed but wound inside out; it was left so. Cutter contact does not depend on the winding.</source>
        <translation>Das Netz ist geschlossen, aber von innen nach außen gewunden; es blieb so. Der Fräserkontakt hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>The operation inclines the tool in five axes; the machine has no rotary axis: choose one with two.</source>
        <translation>Die Operation neigt das Werkzeug in fünf Achsen; die Maschine hat keine Drehachse: eine mit zweien wählen.</translation>
    </message>
    <message>
        <source>The operation inclines the tool in five axes; the machine has one rotary axis: choose one with two.</source>
        <translation>Die Operation neigt das Werkzeug in fünf Achsen; die Maschine hat eine Drehachse: eine mit zweien wählen.</translation>
    </message>
    <message>
        <source>The operation's own tool: it cannot clean up what it leaves itself</source>
        <translation>Das Werkzeug der Operation selbst: es kann nicht säubern, was es selbst lässt</translation>
    </message>
    <message>
        <source>The operation's own tool: it cannot rework what it leaves itself</source>
        <translation>Das Werkzeug der Operation selbst: es kann nicht nacharbeiten, was es selbst lässt</translation>
    </message>
    <message>
        <source>The part is cut free at {1}: what stood round it holds it no longer. Hold it from then on, or leave something between them.</source>
        <translation>Das Teil wird bei {1} freigeschnitten: was darum stand, hält es nicht mehr. Von da an halten oder etwas dazwischen stehen lassen.</translation>
    </message>
    <message>
        <source>The part is smaller than 1 mm or larger than 10 m: the file may be in another unit.</source>
        <translation>Das Teil ist kleiner als 1 mm oder größer als 10 m: die Datei ist vielleicht in einer anderen Einheit.</translation>
    </message>
    <message>
        <source>The part lies as in the project</source>
        <translation>Das Teil liegt wie im Projekt</translation>
    </message>
    <message>
        <source>The part lies as in the project.</source>
        <translation>Das Teil liegt wie im Projekt.</translation>
    </message>
    <message>
        <source>The part lies so far from the origin (or is so large) that 32-bit coordinates are more than 0.01 mm apart; export it near the origin.</source>
        <translation>Das Teil liegt so weit vom Ursprung (oder ist so groß), dass 32-Bit-Koordinaten mehr als 0,01 mm auseinander sind; nahe am Ursprung exportieren.</translation>
    </message>
    <message>
        <source>The part's mesh ({1}); a relative path starts at the project file.</source>
        <translation>Das Netz des Teils ({1}); ein relativer Pfad beginnt bei der Projektdatei.</translation>
    </message>
    <message>
        <source>The picture has 256 levels of grey or fewer, which become steps of the surface; smoothing takes them away.</source>
        <translation>Das Bild hat höchstens 256 Graustufen, die zu Stufen der Fläche werden; Glätten nimmt sie weg.</translation>
    </message>
    <message>
        <source>The picture has colours: their brightness (0.2126 red, 0.7152 green, 0.0722 blue) is the height.</source>
        <translation>Das Bild hat Farben: ihre Helligkeit (0,2126 Rot, 0,7152 Grün, 0,0722 Blau) ist die Höhe.</translation>
    </message>
    <message>
        <source>The picture has more pixels than a mesh of it may have points (4 million): each point is a mean of the pixels around it.</source>
        <translation>Das Bild hat mehr Pixel, als ein Netz davon Punkte haben darf (4 Millionen): jeder Punkt ist ein Mittel der Pixel um ihn.</translation>
    </message>
    <message>
        <source>The posted program, {1} blocks, {2}, was read back for '{3}'.</source>
        <translation>Das ausgegebene Programm, {1} Sätze, {2}, wurde für '{3}' zurückgelesen.</translation>
    </message>
    <message>
        <source>The probes are up to {1} apart, {2} times farther than asked: else there would be more than {3}. What is narrower may be missed.</source>
        <translation>Die Proben sind bis zu {1} auseinander, {2}-mal weiter als verlangt: sonst wären es mehr als {3}. Schmaleres kann entgehen.</translation>
    </message>
    <message>
        <source>The probes are up to {1} apart, {2} times farther than the stock's rays: else there would be more than {3}. What is narrower may be missed.</source>
        <translation>Die Proben sind bis zu {1} auseinander, {2}-mal weiter als die Strahlen des Rohteils: sonst wären es mehr als {3}. Schmaleres kann entgehen.</translation>
    </message>
    <message>
        <source>The project scales the part: it is not as large as its file and unit say.</source>
        <translation>Das Projekt skaliert das Teil: es ist nicht so groß, wie Datei und Einheit sagen.</translation>
    </message>
    <message>
        <source>The same of what holds the stock's high end.</source>
        <translation>Dasselbe für das, was das obere Ende des Rohteils hält.</translation>
    </message>
    <message>
        <source>The share of the surface to be cut, seen by a tool axis and away from open borders, on which more than twice the tolerance may stay: 0.02 is 2 %.</source>
        <translation>Der Anteil der zu fräsenden Fläche, von einer Werkzeugachse gesehen und abseits offener Ränder, auf dem mehr als die doppelte Toleranz stehen darf: 0,02 sind 2 %.</translation>
    </message>
    <message>
        <source>The step stays in the recipe and is left out.</source>
        <translation>Der Schritt bleibt im Rezept und wird ausgelassen.</translation>
    </message>
    <message>
        <source>The stock does not hold the part, which reaches up to {1} beyond the box of the stock's mesh.</source>
        <translation>Das Rohteil enthält das Teil nicht, das bis zu {1} über den Quader des Rohteilnetzes reicht.</translation>
    </message>
    <message>
        <source>The stock does not hold the part: its diameter is {1}, the part needs {2}.</source>
        <translation>Das Rohteil enthält das Teil nicht: sein Durchmesser ist {1}, das Teil braucht {2}.</translation>
    </message>
    <message>
        <source>The stock does not reach {1} of the part's area: there only gouges count.</source>
        <translation>{1} der Fläche des Teils erreicht das Rohteil nicht: dort zählen nur Verletzungen.</translation>
    </message>
    <message>
        <source>The stock stays what the setup before leaves.</source>
        <translation>Das Rohteil bleibt, was die vorherige Aufspannung lässt.</translation>
    </message>
    <message>
        <source>The stock's mesh ({1}), closed, such as the stock.stl that `simulate` leaves; a relative path starts at the project file.</source>
        <translation>Das Netz des Rohteils ({1}), geschlossen, wie das stock.stl, das simulate hinterlässt; ein relativer Pfad beginnt bei der Projektdatei.</translation>
    </message>
    <message>
        <source>The tip comes no nearer to the axis than this: nothing is cut off, and holes through the axis are not entered deeper.</source>
        <translation>Näher kommt die Spitze der Achse nicht: nichts wird abgestochen, und Löcher durch die Achse werden nicht tiefer befahren.</translation>
    </message>
    <message>
        <source>The tolerances of the setups differ: what is left was held against the largest, {1}.</source>
        <translation>Die Toleranzen der Aufspannungen sind verschieden: was bleibt, wurde an der größten gemessen, {1}.</translation>
    </message>
    <message>
        <source>The tool has no ball end, and only a ball cuts the same however it leans</source>
        <translation>Das Werkzeug hat kein Kugelende, und nur eine Kugel fräst gleich, wie sie sich auch neigt</translation>
    </message>
    <message>
        <source>The word endsolid is missing; the mesh is closed, so the file was taken as complete.</source>
        <translation>Das Wort endsolid fehlt; das Netz ist geschlossen, also gilt die Datei als vollständig.</translation>
    </message>
    <message>
        <source>There are none: {1}</source>
        <translation>Es gibt keine: {1}</translation>
    </message>
    <message>
        <source>There is no program for '{1}', which has nothing to do: {2}</source>
        <translation>Für '{1}' gibt es kein Programm, dort ist nichts zu tun: {2}</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Wird verdickt</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>Neigungsgrenze</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Time of the motion</source>
        <translation>Zeit der Bewegung</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>To radius</source>
        <translation>Bis Radius</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>Told as</source>
        <translation>Angegeben als</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>Tool path (CL)</source>
        <translation>Werkzeugweg (CL)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tools, gauge length</source>
        <translation>Werkzeuge, Messlänge</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Touches of the tool</source>
        <translation>Berührungen des Werkzeugs</translation>
    </message>
    <message>
        <source>Translate</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Turn limit</source>
        <translation>Drehgrenze</translation>
    </message>
    <message>
        <source>Turn of the surface's normal per length, in radians per mm, above which a hollow is a strip even where the previous tool could enter it; auto leaves that to the previous tool.</source>
        <translation>Drehung der Flächennormalen je Länge, in Radiant je mm, über der eine Mulde auch dann ein Streifen ist, wenn das vorherige Werkzeug hineinkäme; auto überlässt das dem vorherigen Werkzeug.</translation>
    </message>
    <message>
        <source>Turning angles in the table of positions: unwound they grow turn after turn, modulo they stay within 0 to 360 degrees.</source>
        <translation>Drehwinkel in der Tabelle der Positionen: fortlaufend wachsen sie Umdrehung um Umdrehung, modulo bleiben sie in 0 bis 360 Grad.</translation>
    </message>
    <message>
        <source>Turning facets</source>
        <translation>Facetten werden gewendet</translation>
    </message>
    <message>
        <source>Turns of the tool; 0 where nobody says.</source>
        <translation>Drehzahl des Werkzeugs; 0, wo niemand sie nennt.</translation>
    </message>
    <message>
        <source>Turns the fixture about X, then Y, then Z (fixed axes), about the middle of its bottom; a mesh about its file's origin.</source>
        <translation>Dreht das Spannmittel um X, dann Y, dann Z (feste Achsen), um die Mitte seines Bodens; ein Netz um den Ursprung seiner Datei.</translation>
    </message>
    <message>
        <source>Turns the part about X, then Y, then Z (fixed axes).</source>
        <translation>Dreht das Teil um X, dann Y, dann Z (feste Achsen).</translation>
    </message>
    <message>
        <source>Turns the part, as `part` places it, about X, then Y, then Z (fixed axes) into this setup.</source>
        <translation>Dreht das Teil, wie `part` es legt, um X, dann Y, dann Z (feste Achsen) in diese Aufspannung.</translation>
    </message>
    <message>
        <source>Turns the stock's mesh about X, then Y, then Z (fixed axes); the part's placement does not move it.</source>
        <translation>Dreht das Netz des Rohteils um X, dann Y, dann Z (feste Achsen); die Lage des Teils bewegt es nicht.</translation>
    </message>
    <message>
        <source>Turns the {1} into its mirror image, before it is turned: this coordinate of its points changes sign.</source>
        <translation>Macht daraus ({1}) das Spiegelbild, bevor es gedreht wird: diese Koordinate der Punkte wechselt das Vorzeichen.</translation>
    </message>
    <message>
        <source>Twisted prism</source>
        <translation>Verdrehtes Prisma</translation>
    </message>
    <message>
        <source>T{1}: left out: there is no '{2}' beside the library or in its Bit folder</source>
        <translation>T{1}: weggelassen: neben der Bibliothek oder in ihrem Ordner Bit gibt es kein '{2}'</translation>
    </message>
    <message>
        <source>UNITS changes after lengths were given</source>
        <translation>UNITS wechselt, nachdem Längen genannt wurden</translation>
    </message>
    <message>
        <source>UNITS names no unit</source>
        <translation>UNITS nennt keine Einheit</translation>
    </message>
    <message>
        <source>Uncut (over twice the tolerance)</source>
        <translation>Stehen geblieben (über das Doppelte der Toleranz)</translation>
    </message>
    <message>
        <source>Uncut limit</source>
        <translation>Grenze des Stehengebliebenen</translation>
    </message>
    <message>
        <source>Unit of the numbers in the mesh file. Default: the project's.</source>
        <translation>Einheit der Zahlen in der Netzdatei. Vorgabe: die des Projekts.</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Upright walls ask for no pass of their own: more than twice the tolerance stays on {1} of them, up to {2}, which is no part of the verdict.</source>
        <translation>Aufrechte Wände verlangen keine eigene Bahn: auf {1} von ihnen bleibt mehr als die doppelte Toleranz stehen, bis zu {2}, was nicht zum Urteil zählt.</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Kehle</translation>
    </message>
    <message>
        <source>Valleys shorter than this are left out as noise, and shorter interruptions are bridged; auto is the tool's radius.</source>
        <translation>Kürzere Kehlen gelten als Rauschen und fallen weg, kürzere Unterbrechungen werden überbrückt; auto ist der Werkzeugradius.</translation>
    </message>
    <message>
        <source>Vendor</source>
        <translation>Hersteller</translation>
    </message>
    <message>
        <source>Verification by removal of material</source>
        <translation>Prüfung durch Materialabtrag</translation>
    </message>
    <message>
        <source>Verified: no gouge, no collision.</source>
        <translation>Geprüft: keine Verletzung, keine Kollision.</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Wird geprüft</translation>
    </message>
    <message>
        <source>Vertices have rational weights other than 1; they were ignored.</source>
        <translation>Eckpunkte haben rationale Gewichte außer 1; sie wurden übergangen.</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>Blickrichtung</translation>
    </message>
    <message>
        <source>Waterline</source>
        <translation>Höhenlinien</translation>
    </message>
    <message>
        <source>What cutter, shank and holder keep from it, in cuts and in rapids.</source>
        <translation>Was Fräser, Schaft und Halter davon Abstand halten, beim Fräsen und im Eilgang.</translation>
    </message>
    <message>
        <source>What every edge takes in a turn; 0 where nobody says.</source>
        <translation>Was jede Schneide je Umdrehung nimmt; 0, wo niemand ihn nennt.</translation>
    </message>
    <message>
        <source>What is cut.</source>
        <translation>Was gefräst wird.</translation>
    </message>
    <message>
        <source>What is farther from the centre is not cut. auto goes as far as the part.</source>
        <translation>Was weiter vom Mittelpunkt entfernt ist, wird nicht gefräst. auto geht so weit wie das Teil.</translation>
    </message>
    <message>
        <source>What is left, 95 % below</source>
        <translation>Was übrig ist, 95 % darunter</translation>
    </message>
    <message>
        <source>What is left, 99 % below</source>
        <translation>Was übrig ist, 99 % darunter</translation>
    </message>
    <message>
        <source>What is left, largest</source>
        <translation>Was übrig ist, größtes</translation>
    </message>
    <message>
        <source>What is nearer to the centre is not cut.</source>
        <translation>Was näher am Mittelpunkt liegt, wird nicht gefräst.</translation>
    </message>
    <message>
        <source>What it is called.</source>
        <translation>Wie es heißt.</translation>
    </message>
    <message>
        <source>What makes the region: painted facets, a range of slope, a closed curve drawn on the part, the part's outline, what a tool leaves, or faces of a STEP or IGES file.</source>
        <translation>Was den Bereich ausmacht: gemalte Facetten, ein Neigungsbereich, eine auf dem Teil gezeichnete geschlossene Kurve, der Umriss des Teils, was ein Werkzeug lässt, oder Flächen einer STEP- oder IGES-Datei.</translation>
    </message>
    <message>
        <source>What roughing leaves on the part for finishing, beside the allowance that stays in the end.</source>
        <translation>Was das Schruppen zum Schlichten auf dem Teil lässt, neben dem Aufmaß, das am Ende bleibt.</translation>
    </message>
    <message>
        <source>What the boundary keeps within: the place where the cutter touches the part, the tip, or all of the cutter. Roughing keeps the tip or the cutter within.</source>
        <translation>Was die Begrenzung darin hält: die Stelle, an der der Fräser das Teil berührt, die Spitze oder den ganzen Fräser. Schruppen hält Spitze oder Fräser darin.</translation>
    </message>
    <message>
        <source>What the part turns about: a direction of the part, or a line through two points.</source>
        <translation>Worum sich das Teil dreht: eine Richtung des Teils oder eine Gerade durch zwei Punkte.</translation>
    </message>
    <message>
        <source>What the setup sheet calls the tool.</source>
        <translation>Wie das Einrichteblatt das Werkzeug nennt.</translation>
    </message>
    <message>
        <source>What the step does: takes small pieces away, turns facets to agree, takes needles away, fills holes, smooths noise, decimates, cuts by a plane, thickens a sheet, makes anew where the surface crosses itself, joins another scan on, takes sheets away that hang on the surface and end in the open, fills one hole or leaves it open.</source>
        <translation>Was der Schritt tut: kleine Stücke entfernen, Facetten einheitlich wenden, Nadeln entfernen, Löcher füllen, Rauschen glätten, ausdünnen, an einer Ebene schneiden, eine offene Fläche verdicken, neu machen, wo sich die Fläche selbst durchdringt, einen anderen Scan anfügen, Lappen entfernen, die an der Fläche hängen und im Freien enden, ein Loch füllen oder offen lassen.</translation>
    </message>
    <message>
        <source>What the stock is larger than the part: on both sides in x, on both sides in y, on top in z. Round a cylinder whose diameter is `auto` the larger one of those across its axis counts.</source>
        <translation>Um was das Rohteil größer ist als das Teil: beidseitig in x, beidseitig in y, oben in z. Um einen Zylinder mit Durchmesser auto zählt die größere quer zur Achse.</translation>
    </message>
    <message>
        <source>What the tool leaves counts where it is thicker than that.</source>
        <translation>Was das Werkzeug lässt, zählt, wo es dicker ist als das.</translation>
    </message>
    <message>
        <source>What the zero of the work coordinates is on: the part's origin, or the box of the stock or of the part. Posted programs and the setup sheet count from there; APT files are in part coordinates.</source>
        <translation>Worauf der Nullpunkt liegt: der Ursprung des Teils, oder der Quader um Rohteil oder Teil. Ausgegebene Programme und das Einrichteblatt zählen von dort; APT-Dateien stehen in Koordinaten des Teils.</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Where along the axis the path begins, from the axis' point; auto: where the part does, and as far before it as rounded ends ask for.</source>
        <translation>Wo entlang der Achse der Weg beginnt, vom Punkt der Achse aus; auto: wo das Teil beginnt, und so weit davor, wie gerundete Enden es verlangen.</translation>
    </message>
    <message>
        <source>Where along the axis the path ends.</source>
        <translation>Wo entlang der Achse der Weg endet.</translation>
    </message>
    <message>
        <source>Where an axis along x, y or z runs: through the part's origin or through the middle of its box.</source>
        <translation>Wo eine Achse entlang x, y oder z verläuft: durch den Ursprung des Teils oder die Mitte seines Quaders.</translation>
    </message>
    <message>
        <source>Where it was dragged to.</source>
        <translation>Wohin sie gezogen wurde.</translation>
    </message>
    <message>
        <source>Where leads up to the assumed limit on passes all over the part take less time than the lead limit and rework together, they are used. false: the lead limit is kept. Edited regions keep it too.</source>
        <translation>Wo Anstellwinkel bis zur angenommenen Grenze auf Bahnen über das ganze Teil weniger Zeit brauchen als Grenze und Nacharbeit zusammen, werden sie verwendet. Aus: die Grenze wird eingehalten. Bearbeitete Bereiche behalten sie auch.</translation>
    </message>
    <message>
        <source>Where no curves are named: the outline is divided where it reaches farthest in this direction, either way. auto picks x or y by the change of normals.</source>
        <translation>Wo keine Kurven genannt sind: Der Umriss wird dort geteilt, wo er in dieser Richtung am weitesten reicht, hin wie her. auto wählt x oder y nach der Änderung der Normalen.</translation>
    </message>
    <message>
        <source>Where on the box of stock or part the zero is, in X, Y and Z: -1 its low side, 0 its middle, 1 its high side. `0, 0, 1`: the middle of its top.</source>
        <translation>Wo am Quader um Rohteil oder Teil der Nullpunkt liegt, in X, Y und Z: -1 die niedrige Seite, 0 die Mitte, 1 die hohe Seite. `0, 0, 1`: die Mitte der Oberseite.</translation>
    </message>
    <message>
        <source>Where passes go round, with 'Begin at' place.</source>
        <translation>Worum die Bahnen gehen, wenn sie an einer Stelle beginnen.</translation>
    </message>
    <message>
        <source>Where the boundary was.</source>
        <translation>Wo die Begrenzung war.</translation>
    </message>
    <message>
        <source>Where the middle of its bottom is; how far a mesh is moved. The part's placement does not move it.</source>
        <translation>Wo die Mitte seines Bodens ist; wie weit ein Netz verschoben wird. Die Lage des Teils bewegt es nicht.</translation>
    </message>
    <message>
        <source>Where the tip runs: on the curve, to its left or to its right. Closed curves run counter-clockwise, so what is left lies within.</source>
        <translation>Wo die Spitze läuft: auf der Kurve, links oder rechts von ihr. Geschlossene Kurven laufen gegen den Uhrzeigersinn, links ist also innen.</translation>
    </message>
    <message>
        <source>Which objects of a 3MF or glTF file are the part, by name or number, separated by commas; `info` lists them. Empty: all on the file's build plate, or in its scene.</source>
        <translation>Welche Objekte einer 3MF- oder glTF-Datei das Teil sind, nach Name oder Nummer, durch Kommas getrennt; info listet sie auf. Leer: alle auf der Bauplatte der Datei oder in ihrer Szene.</translation>
    </message>
    <message>
        <source>Wider than the tool, whose diameter is {1}: walls would stay between the passes</source>
        <translation>Breiter als das Werkzeug, dessen Durchmesser {1} ist: Wände blieben zwischen den Bahnen</translation>
    </message>
    <message>
        <source>Winding</source>
        <translation>Winkelzählung</translation>
    </message>
    <message>
        <source>With three axes the tool stands upright everywhere.</source>
        <translation>Mit drei Achsen steht das Werkzeug überall senkrecht.</translation>
    </message>
    <message>
        <source>Within a cutter's radius of the part's open border no path goes on: that zone has figures of its own.</source>
        <translation>Innerhalb eines Fräserradius vom offenen Rand des Teils geht kein Weg weiter: diese Zone hat eigene Zahlen.</translation>
    </message>
    <message>
        <source>Work coordinates</source>
        <translation>Werkstückkoordinaten</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Schreiben</translation>
    </message>
    <message>
        <source>Writing programs</source>
        <translation>Programme werden geschrieben</translation>
    </message>
    <message>
        <source>Writing the part</source>
        <translation>Das Teil wird geschrieben</translation>
    </message>
    <message>
        <source>X or Y go home while the tool is down</source>
        <translation>X oder Y fahren zur Grundstellung, während das Werkzeug unten ist</translation>
    </message>
    <message>
        <source>X, Y, Z or the feed has no word</source>
        <translation>X, Y, Z oder der Vorschub hat kein Wort</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Taumelwinkel</translation>
    </message>
    <message>
        <source>Yaw limits</source>
        <translation>Grenzen des Taumelwinkels</translation>
    </message>
    <message>
        <source>Yaw, deg</source>
        <translation>Taumelwinkel, °</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>Zero at</source>
        <translation>Nullpunkt bei</translation>
    </message>
    <message>
        <source>Zero from</source>
        <translation>Nullpunkt von</translation>
    </message>
    <message>
        <source>Zero on box</source>
        <translation>Nullpunkt am Quader</translation>
    </message>
    <message>
        <source>a '{' is not closed</source>
        <translation>ein '{' ist nicht geschlossen</translation>
    </message>
    <message>
        <source>a '}' stands without '{'</source>
        <translation>ein '}' steht ohne '{'</translation>
    </message>
    <message>
        <source>a .fcholder file has one holder</source>
        <translation>eine .fcholder-Datei hat einen Halter</translation>
    </message>
    <message>
        <source>a .fctb file has one tool</source>
        <translation>eine .fctb-Datei hat ein Werkzeug</translation>
    </message>
    <message>
        <source>a 3MF file</source>
        <translation>eine 3MF-Datei</translation>
    </message>
    <message>
        <source>a BMP picture</source>
        <translation>ein BMP-Bild</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>eine Blender-Datei</translation>
    </message>
    <message>
        <source>a DXF file</source>
        <translation>eine DXF-Datei</translation>
    </message>
    <message>
        <source>a Draco file</source>
        <translation>eine Draco-Datei</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>ein GIF-Bild</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a PLY file</source>
        <translation>eine PLY-Datei</translation>
    </message>
    <message>
        <source>a PLY file holds at most 2 147 483 647 vertices</source>
        <translation>eine PLY-Datei enthält höchstens 2 147 483 647 Eckpunkte</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a Parasolid file</source>
        <translation>eine Parasolid-Datei</translation>
    </message>
    <message>
        <source>a RAR archive</source>
        <translation>ein RAR-Archiv</translation>
    </message>
    <message>
        <source>a RIFF sound or picture</source>
        <translation>ein RIFF-Klang oder -Bild</translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation>eine STEP-Datei</translation>
    </message>
    <message>
        <source>a TIFF picture</source>
        <translation>ein TIFF-Bild</translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation>eine VRML-Datei</translation>
    </message>
    <message>
        <source>a ZIP archive (perhaps 3MF)</source>
        <translation>ein ZIP-Archiv (vielleicht 3MF)</translation>
    </message>
    <message>
        <source>a Zstandard archive</source>
        <translation>ein Zstandard-Archiv</translation>
    </message>
    <message>
        <source>a block of its own time has no time</source>
        <translation>ein Satz mit eigener Zeit hat keine Zeit</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>eine Klammer ist nicht geschlossen</translation>
    </message>
    <message>
        <source>a bzip2 archive</source>
        <translation>ein bzip2-Archiv</translation>
    </message>
    <message>
        <source>a character is not plain text</source>
        <translation>ein Zeichen ist kein reiner Text</translation>
    </message>
    <message>
        <source>a closed curve has three corners or more</source>
        <translation>eine geschlossene Kurve hat drei Ecken oder mehr</translation>
    </message>
    <message>
        <source>a comment is not closed, or holds another one</source>
        <translation>ein Kommentar ist nicht geschlossen oder enthält einen anderen</translation>
    </message>
    <message>
        <source>a coordinate is beyond {1}</source>
        <translation>eine Koordinate ist jenseits von {1}</translation>
    </message>
    <message>
        <source>a coordinate is larger than {1} mm</source>
        <translation>eine Koordinate ist größer als {1} mm</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number</source>
        <translation>eine Koordinate ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>eine Koordinate ist zu groß</translation>
    </message>
    <message>
        <source>a coordinate is too large once the {1} is in its place</source>
        <translation>eine Koordinate ist zu groß, wenn das Objekt ({1}) an seinem Platz ist</translation>
    </message>
    <message>
        <source>a coordinate of {1} is too large</source>
        <translation>eine Koordinate von {1} ist zu groß</translation>
    </message>
    <message>
        <source>a corner cannot be written as a float</source>
        <translation>eine Ecke kann nicht als float geschrieben werden</translation>
    </message>
    <message>
        <source>a corner is further than {1} from the origin</source>
        <translation>eine Ecke ist weiter als {1} vom Ursprung</translation>
    </message>
    <message>
        <source>a corner is not a finite number</source>
        <translation>eine Ecke ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>a count expected, found '{1}'</source>
        <translation>eine Anzahl erwartet, gefunden: '{1}'</translation>
    </message>
    <message>
        <source>a dimension of the cutter is not a usable number</source>
        <translation>ein Maß des Fräsers ist keine brauchbare Zahl</translation>
    </message>
    <message>
        <source>a direction is given without an arc</source>
        <translation>eine Richtung ist ohne Bogen angegeben</translation>
    </message>
    <message>
        <source>a facet has fewer than 3 corners</source>
        <translation>eine Facette hat weniger als 3 Ecken</translation>
    </message>
    <message>
        <source>a facet stands outside of a solid</source>
        <translation>eine Facette steht außerhalb eines solid</translation>
    </message>
    <message>
        <source>a feed of {1} mm/min has no digits left</source>
        <translation>ein Vorschub von {1} mm/min hat keine Stellen mehr</translation>
    </message>
    <message>
        <source>a field has another number of values than vertices</source>
        <translation>ein Feld hat eine andere Anzahl Werte als Eckpunkte</translation>
    </message>
    <message>
        <source>a file in memory cannot be used: {1}</source>
        <translation>eine Datei im Speicher ist nicht nutzbar: {1}</translation>
    </message>
    <message>
        <source>a folder appeared in its place</source>
        <translation>an ihrer Stelle erschien ein Ordner</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>eine glTF-Datei</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>a hole would be filled with more than {1} facets</source>
        <translation>ein Loch würde mit mehr als {1} Facetten gefüllt</translation>
    </message>
    <message>
        <source>a kind of operation</source>
        <translation>eine Art von Operation</translation>
    </message>
    <message>
        <source>a lead limit of 0 leaves the main path no hollows</source>
        <translation>eine Grenze des Anstellwinkels von 0 lässt dem Hauptweg keine Mulden</translation>
    </message>
    <message>
        <source>a lead of at most {1} leaves the whole part uncut with this tool</source>
        <translation>ein Anstellwinkel von höchstens {1} lässt mit diesem Werkzeug das ganze Teil stehen</translation>
    </message>
    <message>
        <source>a list of {1} numbers</source>
        <translation>eine Liste von {1} Zahlen</translation>
    </message>
    <message>
        <source>a mesh has no described shape</source>
        <translation>ein Netz hat keine beschriebene Form</translation>
    </message>
    <message>
        <source>a minute</source>
        <translation>eine Minute</translation>
    </message>
    <message>
        <source>a name has a backslash, a colon or a control character</source>
        <translation>ein Name hat einen Rückstrich, Doppelpunkt oder ein Steuerzeichen</translation>
    </message>
    <message>
        <source>a name is absolute</source>
        <translation>ein Name ist absolut</translation>
    </message>
    <message>
        <source>a name is empty or too long</source>
        <translation>ein Name ist leer oder zu lang</translation>
    </message>
    <message>
        <source>a name is missing</source>
        <translation>ein Name fehlt</translation>
    </message>
    <message>
        <source>a name leads elsewhere</source>
        <translation>ein Name führt anderswohin</translation>
    </message>
    <message>
        <source>a name occurs twice</source>
        <translation>ein Name kommt zweimal vor</translation>
    </message>
    <message>
        <source>a newer Facetmill wrote this study</source>
        <translation>ein neueres Facetmill hat diese Studie geschrieben</translation>
    </message>
    <message>
        <source>a number expected, found '{1}'</source>
        <translation>eine Zahl erwartet, gefunden: '{1}'</translation>
    </message>
    <message>
        <source>a number has a comma where other numbers have a decimal point</source>
        <translation>eine Zahl hat ein Komma, wo andere einen Dezimalpunkt haben</translation>
    </message>
    <message>
        <source>a number is divided by a measure</source>
        <translation>eine Zahl wird durch ein Maß geteilt</translation>
    </message>
    <message>
        <source>a number is missing behind '{1}'</source>
        <translation>hinter '{1}' fehlt eine Zahl</translation>
    </message>
    <message>
        <source>a number or a word</source>
        <translation>eine Zahl oder ein Wort</translation>
    </message>
    <message>
        <source>a number or one of: {1}</source>
        <translation>eine Zahl oder eines von: {1}</translation>
    </message>
    <message>
        <source>a number or outer loop</source>
        <translation>eine Zahl oder outer loop</translation>
    </message>
    <message>
        <source>a number, "project" or { "project_times": 1.1 }</source>
        <translation>eine Zahl, "project" oder { "project_times": 1.1 }</translation>
    </message>
    <message>
        <source>a part of an object stands outside of any</source>
        <translation>ein Stück eines Objekts steht außerhalb von jedem</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} contact points of these tools</source>
        <translation>ein Teil von {1} mal {2} verlangt mehr als {3} Berührpunkte dieser Werkzeuge</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} contact points of this tool</source>
        <translation>ein Teil von {1} mal {2} verlangt mehr als {3} Berührpunkte dieses Werkzeugs</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} places of this tool</source>
        <translation>ein Teil von {1} mal {2} verlangt mehr als {3} Stellen dieses Werkzeugs</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for too many passes of this tool</source>
        <translation>ein Teil von {1} mal {2} verlangt zu viele Bahnen dieses Werkzeugs</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for too many places of this tool</source>
        <translation>ein Teil von {1} mal {2} verlangt zu viele Stellen dieses Werkzeugs</translation>
    </message>
    <message>
        <source>a pass goes {1} into the allowance at {2}</source>
        <translation>eine Bahn geht bei {2} um {1} in das Aufmaß</translation>
    </message>
    <message>
        <source>a place is given and no kind of motion</source>
        <translation>ein Ort ist angegeben und keine Art der Bewegung</translation>
    </message>
    <message>
        <source>a place of the machine's own is not known here</source>
        <translation>ein Ort der Maschine selbst ist hier nicht bekannt</translation>
    </message>
    <message>
        <source>a plane is tilted while the tip is led, or in another one</source>
        <translation>eine Ebene wird geschwenkt, während die Spitze geführt wird, oder in einer anderen</translation>
    </message>
    <message>
        <source>a plane is tilted, and the rotary axes have not turned to it</source>
        <translation>eine Ebene ist geschwenkt, und die Drehachsen stehen nicht dazu</translation>
    </message>
    <message>
        <source>a pointer of Git LFS to a file that was not fetched</source>
        <translation>ein Verweis von Git LFS auf eine Datei, die nicht geholt wurde</translation>
    </message>
    <message>
        <source>a primitive has no positions</source>
        <translation>ein Teil des Netzes hat keine Punkte</translation>
    </message>
    <message>
        <source>a program has taken the binary file for text and written it as UTF-8</source>
        <translation>ein Programm hat die binäre Datei für Text gehalten und als UTF-8 geschrieben</translation>
    </message>
    <message>
        <source>a project cannot be the {1} of a project</source>
        <translation>ein Projekt kann nicht Datei eines Projekts sein: {1}</translation>
    </message>
    <message>
        <source>a project has one setup at least</source>
        <translation>ein Projekt hat mindestens eine Aufspannung</translation>
    </message>
    <message>
        <source>a property before any element</source>
        <translation>eine Eigenschaft vor jedem Element</translation>
    </message>
    <message>
        <source>a radius and a height</source>
        <translation>einen Radius und eine Höhe</translation>
    </message>
    <message>
        <source>a rapid moves several axes, and they do not arrive together</source>
        <translation>ein Eilgang bewegt mehrere Achsen, und sie kommen nicht zugleich an</translation>
    </message>
    <message>
        <source>a rapid without a motion</source>
        <translation>ein Eilgang ohne Bewegung</translation>
    </message>
    <message>
        <source>a rapid{1}</source>
        <translation>einen Eilgang{1}</translation>
    </message>
    <message>
        <source>a relief needs two columns and two rows</source>
        <translation>ein Relief braucht zwei Spalten und zwei Zeilen</translation>
    </message>
    <message>
        <source>a rotary axis goes home</source>
        <translation>eine Drehachse fährt auf ihre Grundstellung</translation>
    </message>
    <message>
        <source>a rotary axis turns in a tilted plane</source>
        <translation>eine Drehachse dreht in einer geschwenkten Ebene</translation>
    </message>
    <message>
        <source>a setup turns and moves the part, and cannot mirror it</source>
        <translation>eine Aufspannung dreht und verschiebt das Teil und kann es nicht spiegeln</translation>
    </message>
    <message>
        <source>a sign is missing between two numbers</source>
        <translation>zwischen zwei Zahlen fehlt ein Zeichen</translation>
    </message>
    <message>
        <source>a step of kind {1} does not read it</source>
        <translation>ein Schritt der Art {1} liest es nicht</translation>
    </message>
    <message>
        <source>a step-down of {1} makes more than {2} levels</source>
        <translation>eine Zustellung von {1} ergibt mehr als {2} Höhenlinien</translation>
    </message>
    <message>
        <source>a step-over of {1} makes</source>
        <translation>ein Bahnabstand von {1} ergibt</translation>
    </message>
    <message>
        <source>a step-over of {1} makes more than {2} drive planes</source>
        <translation>ein Bahnabstand von {1} ergibt mehr als {2} Führungsebenen</translation>
    </message>
    <message>
        <source>a step-over of {1} with a cutter of diameter {2} leaves walls between the lines</source>
        <translation>ein Bahnabstand von {1} mit einem Fräser vom Durchmesser {2} lässt Wände zwischen den Linien</translation>
    </message>
    <message>
        <source>a stick-out of {1} below the holder instead of {2}</source>
        <translation>eine Auskraglänge von {1} unter dem Halter statt {2}</translation>
    </message>
    <message>
        <source>a strip names vertex {1}, the file has {2} (from 0)</source>
        <translation>ein Streifen nennt Eckpunkt {1}, die Datei hat {2} (ab 0)</translation>
    </message>
    <message>
        <source>a surface has a place that is not finite</source>
        <translation>eine Fläche hat eine Stelle, die nicht endlich ist</translation>
    </message>
    <message>
        <source>a table tells no shape and no lengths: taken for a ball end with usual flutes and shank</source>
        <translation>eine Tabelle nennt weder Form noch Längen: gilt als Kugelkopf mit üblichen Schneiden und Schaft</translation>
    </message>
    <message>
        <source>a table tells no shape and no lengths: taken for a flat end with usual flutes and shank</source>
        <translation>eine Tabelle nennt weder Form noch Längen: gilt als flach mit üblichen Schneiden und Schaft</translation>
    </message>
    <message>
        <source>a tar archive</source>
        <translation>ein tar-Archiv</translation>
    </message>
    <message>
        <source>a text that does not start with 'solid'</source>
        <translation>ein Text, der nicht mit 'solid' beginnt</translation>
    </message>
    <message>
        <source>a tool axis is given as a vector, and no code says so</source>
        <translation>eine Werkzeugachse ist als Vektor angegeben, und kein Code sagt das</translation>
    </message>
    <message>
        <source>a tool axis lies down</source>
        <translation>eine Werkzeugachse liegt</translation>
    </message>
    <message>
        <source>a tool fits but does not go there</source>
        <translation>ein Werkzeug passt, geht aber nicht dorthin</translation>
    </message>
    <message>
        <source>a tool is changed and none was named</source>
        <translation>ein Werkzeug wird gewechselt und keines wurde genannt</translation>
    </message>
    <message>
        <source>a tool length is called without a number</source>
        <translation>eine Werkzeuglänge wird ohne Nummer aufgerufen</translation>
    </message>
    <message>
        <source>a tool pose is not finite or its axis is no unit vector</source>
        <translation>eine Werkzeuglage ist nicht endlich oder ihre Achse kein Einheitsvektor</translation>
    </message>
    <message>
        <source>a tool that cuts into the part is not inclined</source>
        <translation>ein Werkzeug, das ins Teil fräst, wird nicht geneigt</translation>
    </message>
    <message>
        <source>a transfer as text has changed the binary file: there is a CR before every LF</source>
        <translation>eine Übertragung als Text hat die binäre Datei verändert: vor jedem LF steht ein CR</translation>
    </message>
    <message>
        <source>a triangle names a sample that there is not</source>
        <translation>ein Dreieck nennt eine Probe, die es nicht gibt</translation>
    </message>
    <message>
        <source>a triangle names the vertex {1} of {2}</source>
        <translation>ein Dreieck nennt den Eckpunkt {1} von {2}</translation>
    </message>
    <message>
        <source>a vertex has 5 numbers</source>
        <translation>ein Eckpunkt hat 5 Zahlen</translation>
    </message>
    <message>
        <source>a vertex has fewer than 3 numbers</source>
        <translation>ein Eckpunkt hat weniger als 3 Zahlen</translation>
    </message>
    <message>
        <source>a vertex has more than 7 numbers</source>
        <translation>ein Eckpunkt hat mehr als 7 Zahlen</translation>
    </message>
    <message>
        <source>a vertex has no {1}</source>
        <translation>einem Eckpunkt fehlt {1}</translation>
    </message>
    <message>
        <source>a vertex is further than {1} from the origin</source>
        <translation>ein Eckpunkt ist weiter als {1} vom Ursprung</translation>
    </message>
    <message>
        <source>a vertex number expected, found '{1}'</source>
        <translation>eine Eckpunktnummer erwartet, gefunden: '{1}'</translation>
    </message>
    <message>
        <source>a web page</source>
        <translation>eine Webseite</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a {1} of kind '{2}' has no such key</source>
        <translation>{1} der Art '{2}' kennt diesen Schlüssel nicht</translation>
    </message>
    <message>
        <source>about {1} million points, {2} GB, {3}</source>
        <translation>etwa {1} Millionen Punkte, {2} GB, {3}</translation>
    </message>
    <message>
        <source>above -90° and below 90°</source>
        <translation>über -90° und unter 90°</translation>
    </message>
    <message>
        <source>above 0° and at most 90°</source>
        <translation>über 0° und höchstens 90°</translation>
    </message>
    <message>
        <source>above {1}</source>
        <translation>über {1}</translation>
    </message>
    <message>
        <source>above {1} and at most {2}</source>
        <translation>über {1} und höchstens {2}</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptiv</translation>
    </message>
    <message>
        <source>add "facetmill": {1}; is this a project file?</source>
        <translation>"facetmill": {1} einfügen; ist das eine Projektdatei?</translation>
    </message>
    <message>
        <source>add CUTTER/d,r,e,f,alpha,beta,h before the first GOTO</source>
        <translation>CUTTER/d,r,e,f,alpha,beta,h vor dem ersten GOTO einfügen</translation>
    </message>
    <message>
        <source>add a CL between, which says in which plane it turns</source>
        <translation>ein CL dazwischen einfügen, das sagt, in welcher Ebene sie sich dreht</translation>
    </message>
    <message>
        <source>add a box, choose the kind "tab" and move it to its place</source>
        <translation>einen Quader hinzufügen, die Art Steg wählen und an seinen Platz schieben</translation>
    </message>
    <message>
        <source>add a tool</source>
        <translation>ein Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>add an operation</source>
        <translation>eine Operation hinzufügen</translation>
    </message>
    <message>
        <source>add i, j and k to words</source>
        <translation>i, j und k zu words hinzufügen</translation>
    </message>
    <message>
        <source>add i, j and k to words, or centre_x and so on</source>
        <translation>i, j und k zu words hinzufügen, oder centre_x und so weiter</translation>
    </message>
    <message>
        <source>add it to the project's tools</source>
        <translation>es zu den Werkzeugen des Projekts hinzufügen</translation>
    </message>
    <message>
        <source>add it to the words of the post</source>
        <translation>es bei den Wörtern des Postprozessors hinzufügen</translation>
    </message>
    <message>
        <source>add one to codes</source>
        <translation>einen zu codes hinzufügen</translation>
    </message>
    <message>
        <source>add one, or write true</source>
        <translation>einen hinzufügen oder true schreiben</translation>
    </message>
    <message>
        <source>add radius to words</source>
        <translation>radius zu words hinzufügen</translation>
    </message>
    <message>
        <source>all around</source>
        <translation>ringsum</translation>
    </message>
    <message>
        <source>all cutting data but the first</source>
        <translation>alle Schnittdaten außer den ersten</translation>
    </message>
    <message>
        <source>all facets of the part face along the turning axis</source>
        <translation>alle Facetten des Teils zeigen entlang der Drehachse</translation>
    </message>
    <message>
        <source>all is cut by levels: nothing is less steep than the divide</source>
        <translation>alles wird in Höhenlinien gefräst: nichts ist flacher als die Teilung</translation>
    </message>
    <message>
        <source>all is cut by levels: {1}</source>
        <translation>alles wird in Höhenlinien gefräst: {1}</translation>
    </message>
    <message>
        <source>all is cut by passes side by side: {1}</source>
        <translation>alles wird in Bahnen nebeneinander gefräst: {1}</translation>
    </message>
    <message>
        <source>all of it lies off the part</source>
        <translation>sie liegt ganz neben dem Teil</translation>
    </message>
    <message>
        <source>all of it lies off the part, as at {1}</source>
        <translation>sie liegt ganz außerhalb des Teils, etwa bei {1}</translation>
    </message>
    <message>
        <source>all of them are switched off</source>
        <translation>alle sind ausgeschaltet</translation>
    </message>
    <message>
        <source>all strips are switched off</source>
        <translation>alle Streifen sind ausgeschaltet</translation>
    </message>
    <message>
        <source>allow a larger chord tolerance, or export the parts one by one</source>
        <translation>eine größere Sehnentoleranz erlauben oder die Teile einzeln exportieren</translation>
    </message>
    <message>
        <source>allow a larger one</source>
        <translation>eine größere erlauben</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a side feed</source>
        <translation>eine größere Toleranz erlauben oder einen Seitenvorschub angeben</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a step-down</source>
        <translation>eine größere Toleranz zulassen oder eine Zustellung angeben</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a step-over</source>
        <translation>eine größere Toleranz erlauben oder einen Bahnabstand setzen</translation>
    </message>
    <message>
        <source>allow a larger tolerance or tessellate the part more finely</source>
        <translation>eine größere Toleranz erlauben oder das Teil feiner vernetzen</translation>
    </message>
    <message>
        <source>allow a larger tolerance, or use a tool with a larger corner radius</source>
        <translation>eine größere Toleranz erlauben oder ein Werkzeug mit größerem Eckenradius nehmen</translation>
    </message>
    <message>
        <source>allow a larger tolerance, set a depth, or take a tool with a flat end</source>
        <translation>eine größere Toleranz erlauben, eine Tiefe setzen oder ein Werkzeug mit flacher Stirn nehmen</translation>
    </message>
    <message>
        <source>allow a larger tolerance, use a tool with a larger corner radius, or switch strips off</source>
        <translation>eine größere Toleranz erlauben, ein Werkzeug mit größerem Eckenradius nehmen oder Streifen ausschalten</translation>
    </message>
    <message>
        <source>allowed: {1}</source>
        <translation>erlaubt: {1}</translation>
    </message>
    <message>
        <source>along the tool axis</source>
        <translation>entlang der Werkzeugachse</translation>
    </message>
    <message>
        <source>an AppleDouble file, which macOS puts beside the mesh</source>
        <translation>eine AppleDouble-Datei, die macOS neben das Netz legt</translation>
    </message>
    <message>
        <source>an IGES file</source>
        <translation>eine IGES-Datei</translation>
    </message>
    <message>
        <source>an OBJ file</source>
        <translation>eine OBJ-Datei</translation>
    </message>
    <message>
        <source>an OFF file</source>
        <translation>eine OFF-Datei</translation>
    </message>
    <message>
        <source>an Office or SolidWorks document</source>
        <translation>ein Office- oder SolidWorks-Dokument</translation>
    </message>
    <message>
        <source>an STL file</source>
        <translation>eine STL-Datei</translation>
    </message>
    <message>
        <source>an STL file holds at most 4 294 967 294 facets</source>
        <translation>eine STL-Datei enthält höchstens 4 294 967 294 Facetten</translation>
    </message>
    <message>
        <source>an XML document</source>
        <translation>ein XML-Dokument</translation>
    </message>
    <message>
        <source>an arc begins at a place that is not known</source>
        <translation>ein Bogen beginnt an einem unbekannten Ort</translation>
    </message>
    <message>
        <source>an arc begins {1} mm from its centre and ends {2} mm from it</source>
        <translation>ein Bogen beginnt {1} mm von seinem Mittelpunkt und endet {2} mm davon</translation>
    </message>
    <message>
        <source>an arc has a centre and a radius</source>
        <translation>ein Bogen hat einen Mittelpunkt und einen Radius</translation>
    </message>
    <message>
        <source>an arc has a word that is read over</source>
        <translation>ein Bogen hat ein Wort, das überlesen wird</translation>
    </message>
    <message>
        <source>an arc has neither centre nor radius</source>
        <translation>ein Bogen hat weder Mittelpunkt noch Radius</translation>
    </message>
    <message>
        <source>an arc has no centre</source>
        <translation>ein Bogen hat keinen Mittelpunkt</translation>
    </message>
    <message>
        <source>an arc has no direction</source>
        <translation>ein Bogen hat keine Richtung</translation>
    </message>
    <message>
        <source>an arc has no radius</source>
        <translation>ein Bogen hat keinen Radius</translation>
    </message>
    <message>
        <source>an arc has two directions</source>
        <translation>ein Bogen hat zwei Richtungen</translation>
    </message>
    <message>
        <source>an arc is given, and nothing says in which plane</source>
        <translation>ein Bogen ist angegeben, und nichts sagt, in welcher Ebene</translation>
    </message>
    <message>
        <source>an arc is no rapid</source>
        <translation>ein Bogen ist kein Eilgang</translation>
    </message>
    <message>
        <source>an arc turns a rotary axis</source>
        <translation>ein Bogen dreht eine Drehachse</translation>
    </message>
    <message>
        <source>an axis calls at a place of the part on its way home</source>
        <translation>eine Achse fährt auf dem Weg zur Grundstellung einen Ort des Teils an</translation>
    </message>
    <message>
        <source>an axis goes home while the tip is led or in a tilted plane</source>
        <translation>eine Achse fährt zur Grundstellung, während die Spitze geführt wird oder in einer geschwenkten Ebene</translation>
    </message>
    <message>
        <source>an axis has no number</source>
        <translation>eine Achse hat keine Zahl</translation>
    </message>
    <message>
        <source>an empty ZIP archive</source>
        <translation>ein leeres ZIP-Archiv</translation>
    </message>
    <message>
        <source>an entry has no name or no size</source>
        <translation>ein Eintrag hat keinen Namen oder keine Größe</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an object has too many vertices</source>
        <translation>ein Objekt hat zu viele Eckpunkte</translation>
    </message>
    <message>
        <source>an object stands in another one</source>
        <translation>ein Objekt steht in einem anderen</translation>
    </message>
    <message>
        <source>an object with the key "facetmill"</source>
        <translation>ein Objekt mit dem Schlüssel "facetmill"</translation>
    </message>
    <message>
        <source>an operation on a part that turns knows no boundaries</source>
        <translation>eine Operation an einem drehenden Teil kennt keine Begrenzungen</translation>
    </message>
    <message>
        <source>an order leaves operations out</source>
        <translation>eine Reihenfolge lässt Operationen aus</translation>
    </message>
    <message>
        <source>an order of operations is a list of their names</source>
        <translation>eine Reihenfolge von Operationen ist eine Liste ihrer Namen</translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation>ein xz-Archiv</translation>
    </message>
    <message>
        <source>and {1} more</source>
        <translation>und {1} weitere</translation>
    </message>
    <message>
        <source>another STL file follows the first in it</source>
        <translation>in ihr folgt auf die erste STL-Datei eine weitere</translation>
    </message>
    <message>
        <source>another program works on this study ({1}; this is {2})</source>
        <translation>ein anderes Programm arbeitet an dieser Studie ({1}; dieses ist {2})</translation>
    </message>
    <message>
        <source>another run works on this study</source>
        <translation>ein anderer Lauf arbeitet an dieser Studie</translation>
    </message>
    <message>
        <source>another {1} is called '{2}'</source>
        <translation>'{2}' heißt schon etwas anderes ({1})</translation>
    </message>
    <message>
        <source>arcs about a centre of their own block are told in XY and do not climb</source>
        <translation>Bögen um einen Mittelpunkt in einem eigenen Satz liegen in XY und steigen nicht</translation>
    </message>
    <message>
        <source>around</source>
        <translation>rundum</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>wie es ist</translation>
    </message>
    <message>
        <source>as many answers as points are needed</source>
        <translation>so viele Antworten wie Punkte sind nötig</translation>
    </message>
    <message>
        <source>as many lifts as poses are needed</source>
        <translation>so viele Abhübe wie Lagen sind nötig</translation>
    </message>
    <message>
        <source>as many lifts as postures are needed</source>
        <translation>so viele Abhübe wie Stellungen sind nötig</translation>
    </message>
    <message>
        <source>at least {1}</source>
        <translation>mindestens {1}</translation>
    </message>
    <message>
        <source>at most 1.4 thousand million are possible</source>
        <translation>höchstens 1,4 Milliarden sind möglich</translation>
    </message>
    <message>
        <source>at most {1}</source>
        <translation>höchstens {1}</translation>
    </message>
    <message>
        <source>at {1} % of the places looked at even the smallest side feed leaves more than {2}: walls that face along the passes, or a cutter with a sharp corner</source>
        <translation>an {1} % der untersuchten Stellen lässt selbst der kleinste Seitenvorschub mehr als {2}: Wände längs der Bahnen oder ein Fräser mit scharfer Ecke</translation>
    </message>
    <message>
        <source>at {1} of {2} places the tool meets nothing on its way to the axis and stops at the core radius of {3}: holes through the axis, or ends of the part that are cut down to it</source>
        <translation>an {1} von {2} Stellen trifft das Werkzeug auf dem Weg zur Achse nichts und hält am Kernradius von {3}: Löcher durch die Achse, oder Enden des Teils, die bis dorthin gefräst werden</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto: where parts of the surface that an axis reaches do not face up (walls, undersides, both faces of a blade), the part is cut side by side, each connected piece seen from its own side, with the yaw free and a posture grid twice as coarse; what no axis reaches is said. top: everything is cut as it is seen from above.</source>
        <translation>auto: wo Teile der Fläche, die eine Achse erreicht, nicht nach oben zeigen (Wände, Unterseiten, beide Seiten einer Schaufel), wird das Teil Seite für Seite gefräst, jedes zusammenhängende Stück von seiner Seite gesehen, mit freiem Taumelwinkel und doppelt so grobem Stellungsraster; was keine Achse erreicht, wird gesagt. oben: alles wird gefräst, wie es von oben zu sehen ist.</translation>
    </message>
    <message>
        <source>avoid fewer facets, or cut within a boundary that leaves them out</source>
        <translation>weniger Facetten meiden, oder innerhalb einer Begrenzung fräsen, die sie auslässt</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>ball cuts the regions with a ball and a vertical axis; cm2 with a smaller flat or bull-nosed tool whose lead matches the curvature.</source>
        <translation>Kugel fräst die Bereiche mit einem Kugelkopf und senkrechter Achse; krümmungsgleich (CM²) mit einem kleineren flachen oder torischen Werkzeug, dessen Anstellwinkel die Krümmung angleicht.</translation>
    </message>
    <message>
        <source>ball end mill</source>
        <translation>Kugelfräser</translation>
    </message>
    <message>
        <source>beside {1} of {2} contact points no posture clears the whole strip: it is cut under the pass, and left to clean-up beside it</source>
        <translation>neben {1} von {2} Berührpunkten trägt keine Stellung den ganzen Streifen ab: er wird unter der Bahn gefräst und bleibt daneben der Restbearbeitung</translation>
    </message>
    <message>
        <source>between its radii there is nothing</source>
        <translation>zwischen seinen Radien liegt nichts</translation>
    </message>
    <message>
        <source>border</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>border: passes follow the border of what is cut; curve: they lie on both sides of a curve; place: they go round a place on the part.</source>
        <translation>Rand: Bahnen folgen dem Rand dessen, was gefräst wird; Kurve: sie liegen zu beiden Seiten einer Kurve; Stelle: sie gehen um eine Stelle auf dem Teil.</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>bottom angle and taper angle make no convex cutter</source>
        <translation>Stirn- und Flankenwinkel ergeben keinen konvexen Fräser</translation>
    </message>
    <message>
        <source>bottom angle {1} and taper angle {2} make no convex cutter</source>
        <translation>Stirnwinkel {1} und Flankenwinkel {2} ergeben keinen konvexen Fräser</translation>
    </message>
    <message>
        <source>bottom {1}°</source>
        <translation>Boden {1}°</translation>
    </message>
    <message>
        <source>boundaries there are: {1}</source>
        <translation>vorhandene Begrenzungen: {1}</translation>
    </message>
    <message>
        <source>boundary '{1}'</source>
        <translation>Begrenzung '{1}'</translation>
    </message>
    <message>
        <source>boundary '{1}' is what this tool leaves</source>
        <translation>Begrenzung '{1}' ist, was dieses Werkzeug lässt</translation>
    </message>
    <message>
        <source>box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>box, {1}</source>
        <translation>Quader, {1}</translation>
    </message>
    <message>
        <source>bring rotary axes, X and Y to the start first</source>
        <translation>zuerst Drehachsen, X und Y an den Anfang bringen</translation>
    </message>
    <message>
        <source>bring rotary axes, X and Y to the start first, and give X, Y and Z</source>
        <translation>zuerst Drehachsen, X und Y an den Anfang bringen und X, Y und Z angeben</translation>
    </message>
    <message>
        <source>bring the rotary axes to where it is held before it</source>
        <translation>die Drehachsen davor dorthin bringen, wo sie gehalten wird</translation>
    </message>
    <message>
        <source>bring them there before it, so that the control has nothing to choose</source>
        <translation>sie davor dorthin bringen, damit die Steuerung nichts zu wählen hat</translation>
    </message>
    <message>
        <source>bull nose end mill</source>
        <translation>Torusfräser</translation>
    </message>
    <message>
        <source>call it</source>
        <translation>sie aufrufen</translation>
    </message>
    <message>
        <source>call it before</source>
        <translation>davor aufrufen</translation>
    </message>
    <message>
        <source>call its edge before it</source>
        <translation>davor seine Schneide aufrufen</translation>
    </message>
    <message>
        <source>call its own</source>
        <translation>seine eigene aufrufen</translation>
    </message>
    <message>
        <source>candidate {1}</source>
        <translation>Kandidat {1}</translation>
    </message>
    <message>
        <source>cannot be reached: {1} of the surface ({2}) around {3}: {4}</source>
        <translation>unerreichbar: {1} der Fläche ({2}) um {3}: {4}</translation>
    </message>
    <message>
        <source>cannot be reached: {1} smaller places; {2} of the surface in all</source>
        <translation>unerreichbar: {1} kleinere Stellen; {2} der Fläche insgesamt</translation>
    </message>
    <message>
        <source>cannot be unpacked for this run: {1}</source>
        <translation>kann für diesen Lauf nicht entpackt werden: {1}</translation>
    </message>
    <message>
        <source>cannot be unpacked: {1}</source>
        <translation>kann nicht entpackt werden: {1}</translation>
    </message>
    <message>
        <source>cannot make the folder: {1}</source>
        <translation>der Ordner kann nicht angelegt werden: {1}</translation>
    </message>
    <message>
        <source>cannot make the folder{1}</source>
        <translation>der Ordner kann nicht angelegt werden{1}</translation>
    </message>
    <message>
        <source>cannot open the file: {1}</source>
        <translation>die Datei kann nicht geöffnet werden: {1}</translation>
    </message>
    <message>
        <source>cannot write the file: {1}</source>
        <translation>die Datei kann nicht geschrieben werden: {1}</translation>
    </message>
    <message>
        <source>center drill</source>
        <translation>Zentrierbohrer</translation>
    </message>
    <message>
        <source>chamfer mill</source>
        <translation>Fasenfräser</translation>
    </message>
    <message>
        <source>change it</source>
        <translation>es ändern</translation>
    </message>
    <message>
        <source>change the operation's limits, or the part's place on the machine</source>
        <translation>die Grenzen der Operation oder den Ort des Teils auf der Maschine ändern</translation>
    </message>
    <message>
        <source>check `place` of both setups and where the stock's mesh is, or let the setup go on with the rest</source>
        <translation>`place` beider Aufspannungen prüfen und wo das Netz des Rohteils ist, oder die Aufspannung mit dem Rest weitermachen lassen</translation>
    </message>
    <message>
        <source>check boundary, slopes and tool</source>
        <translation>Begrenzung, Neigungen und Werkzeug prüfen</translation>
    </message>
    <message>
        <source>check commas, quotes and braces</source>
        <translation>Kommas, Anführungszeichen und Klammern prüfen</translation>
    </message>
    <message>
        <source>check its end and its centre</source>
        <translation>Ende und Mittelpunkt prüfen</translation>
    </message>
    <message>
        <source>check its end and its radius</source>
        <translation>Ende und Radius prüfen</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>die Rechte prüfen</translation>
    </message>
    <message>
        <source>check its place, permissions and the disk</source>
        <translation>Ort, Rechte und Datenträger prüfen</translation>
    </message>
    <message>
        <source>check part and boundary</source>
        <translation>Teil und Begrenzung prüfen</translation>
    </message>
    <message>
        <source>check part and curves</source>
        <translation>Teil und Kurven prüfen</translation>
    </message>
    <message>
        <source>check part and direction</source>
        <translation>Teil und Richtung prüfen</translation>
    </message>
    <message>
        <source>check part, centre and radii</source>
        <translation>Teil, Mittelpunkt und Radien prüfen</translation>
    </message>
    <message>
        <source>check part, tool and direction</source>
        <translation>Teil, Werkzeug und Richtung prüfen</translation>
    </message>
    <message>
        <source>check part, tool and divide</source>
        <translation>Teil, Werkzeug und Teilung prüfen</translation>
    </message>
    <message>
        <source>check part, tool and tolerance</source>
        <translation>Teil, Werkzeug und Toleranz prüfen</translation>
    </message>
    <message>
        <source>check part, tools and machine</source>
        <translation>Teil, Werkzeuge und Maschine prüfen</translation>
    </message>
    <message>
        <source>check start, stop, chuck and tailstock</source>
        <translation>Anfang, Ende, Futter und Reitstock prüfen</translation>
    </message>
    <message>
        <source>check that it is an APT CL file</source>
        <translation>prüfen, dass es eine APT-CL-Datei ist</translation>
    </message>
    <message>
        <source>check the axis</source>
        <translation>die Achse prüfen</translation>
    </message>
    <message>
        <source>check the axis, the core radius and where the path starts and stops</source>
        <translation>die Achse, den Kernradius und Anfang und Ende des Wegs prüfen</translation>
    </message>
    <message>
        <source>check the boundary</source>
        <translation>die Begrenzung prüfen</translation>
    </message>
    <message>
        <source>check the directions</source>
        <translation>die Richtungen prüfen</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>die Platte prüfen</translation>
    </message>
    <message>
        <source>check the file</source>
        <translation>die Datei prüfen</translation>
    </message>
    <message>
        <source>check the file and its units</source>
        <translation>die Datei und ihre Einheiten prüfen</translation>
    </message>
    <message>
        <source>check the folder, its permissions and the free space</source>
        <translation>den Ordner, seine Rechte und den freien Platz prüfen</translation>
    </message>
    <message>
        <source>check the folder, its permissions and the free space, or name another one in TMPDIR</source>
        <translation>den Ordner, seine Rechte und den freien Platz prüfen oder in TMPDIR einen anderen nennen</translation>
    </message>
    <message>
        <source>check the free space of temporary files</source>
        <translation>den freien Platz für temporäre Dateien prüfen</translation>
    </message>
    <message>
        <source>check the free space of temporary files, or name another folder in TMPDIR</source>
        <translation>den freien Platz für temporäre Dateien prüfen oder in TMPDIR einen anderen Ordner nennen</translation>
    </message>
    <message>
        <source>check the mesh</source>
        <translation>das Netz prüfen</translation>
    </message>
    <message>
        <source>check the mesh's units and numbers</source>
        <translation>Einheit und Zahlen des Netzes prüfen</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>den Namen prüfen</translation>
    </message>
    <message>
        <source>check the number for a point that was lost</source>
        <translation>die Zahl auf einen verlorenen Punkt prüfen</translation>
    </message>
    <message>
        <source>check the part</source>
        <translation>das Teil prüfen</translation>
    </message>
    <message>
        <source>check the part's place and the program</source>
        <translation>die Lage des Teils und das Programm prüfen</translation>
    </message>
    <message>
        <source>check the part's units</source>
        <translation>die Einheit des Teils prüfen</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool</source>
        <translation>die Einheit des Teils prüfen oder ein größeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool or step-over</source>
        <translation>die Einheit des Teils prüfen oder Werkzeug oder Bahnabstand größer wählen</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool or tolerance</source>
        <translation>die Einheit des Teils prüfen oder Werkzeug oder Toleranz größer wählen</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool, tolerance or side feed</source>
        <translation>die Einheit des Teils prüfen oder Werkzeug, Toleranz oder Seitenvorschub größer wählen</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool, tolerance or step-over</source>
        <translation>die Einheit des Teils prüfen oder Werkzeug, Toleranz oder Bahnabstand größer wählen</translation>
    </message>
    <message>
        <source>check the part's units, or take larger tools</source>
        <translation>die Einheit des Teils prüfen oder größere Werkzeuge nehmen</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>den Pfad prüfen</translation>
    </message>
    <message>
        <source>check the placements, or give the setup a stock of its own</source>
        <translation>die Lagen prüfen oder der Aufspannung ein eigenes Rohteil geben</translation>
    </message>
    <message>
        <source>check the program</source>
        <translation>das Programm prüfen</translation>
    </message>
    <message>
        <source>check the program and the machine</source>
        <translation>das Programm und die Maschine prüfen</translation>
    </message>
    <message>
        <source>check the program's units</source>
        <translation>die Einheit des Programms prüfen</translation>
    </message>
    <message>
        <source>check the stock's size and place</source>
        <translation>Größe und Lage des Rohteils prüfen</translation>
    </message>
    <message>
        <source>check the tool</source>
        <translation>das Werkzeug prüfen</translation>
    </message>
    <message>
        <source>check the units and the origin of the program</source>
        <translation>Einheit und Ursprung des Programms prüfen</translation>
    </message>
    <message>
        <source>check the {1}'s units and translate</source>
        <translation>Einheit und Verschiebung prüfen ({1})</translation>
    </message>
    <message>
        <source>check tool, allowance and stock</source>
        <translation>Werkzeug, Aufmaß und Rohteil prüfen</translation>
    </message>
    <message>
        <source>choose a ball, or let it match the curvature (CM2)</source>
        <translation>eine Kugel wählen, oder die Krümmung angleichen lassen (CM2)</translation>
    </message>
    <message>
        <source>choose a flat or bull-nosed tool, or cut the regions as with a ball</source>
        <translation>ein flaches oder torisches Werkzeug wählen, oder die Bereiche wie mit einer Kugel fräsen</translation>
    </message>
    <message>
        <source>choose a larger angle, such as 3°</source>
        <translation>einen größeren Winkel wählen, etwa 3°</translation>
    </message>
    <message>
        <source>choose a larger angle, such as 3°, or narrower limits</source>
        <translation>einen größeren Winkel wählen, etwa 3°, oder engere Grenzen</translation>
    </message>
    <message>
        <source>choose a larger depth of cut</source>
        <translation>eine größere Schnitttiefe wählen</translation>
    </message>
    <message>
        <source>choose a larger depth or tolerance</source>
        <translation>Tiefe oder Toleranz größer wählen</translation>
    </message>
    <message>
        <source>choose a larger side feed or tolerance</source>
        <translation>Seitenvorschub oder Toleranz größer wählen</translation>
    </message>
    <message>
        <source>choose a larger step-down</source>
        <translation>eine größere Zustellung wählen</translation>
    </message>
    <message>
        <source>choose a larger step-over</source>
        <translation>einen größeren Bahnabstand wählen</translation>
    </message>
    <message>
        <source>choose a larger step-over or tolerance</source>
        <translation>Bahnabstand oder Toleranz größer wählen</translation>
    </message>
    <message>
        <source>choose a larger tolerance or step-over</source>
        <translation>größere Toleranz oder größeren Bahnabstand wählen</translation>
    </message>
    <message>
        <source>choose a larger tool or a smaller tolerance</source>
        <translation>ein größeres Werkzeug oder eine kleinere Toleranz wählen</translation>
    </message>
    <message>
        <source>choose a smaller allowance, or a larger stock</source>
        <translation>ein kleineres Aufmaß oder ein größeres Rohteil wählen</translation>
    </message>
    <message>
        <source>choose a smaller core radius</source>
        <translation>einen kleineren Kernradius wählen</translation>
    </message>
    <message>
        <source>choose a smaller depth or a longer tool</source>
        <translation>eine kleinere Tiefe oder ein längeres Werkzeug wählen</translation>
    </message>
    <message>
        <source>choose a smaller offset or the other side</source>
        <translation>einen kleineren Versatz oder die andere Seite wählen</translation>
    </message>
    <message>
        <source>choose a smaller tool, or the one that cut before</source>
        <translation>ein kleineres Werkzeug wählen, oder das, das vorher fräste</translation>
    </message>
    <message>
        <source>choose another format or other tools</source>
        <translation>ein anderes Format oder andere Werkzeuge wählen</translation>
    </message>
    <message>
        <source>choose another machine or tool, turn the part, or place it elsewhere on the machine</source>
        <translation>eine andere Maschine oder ein anderes Werkzeug wählen, das Teil drehen oder anders auf die Maschine setzen</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>einen anderen Namen wählen</translation>
    </message>
    <message>
        <source>choose another part</source>
        <translation>ein anderes Teil wählen</translation>
    </message>
    <message>
        <source>choose another post</source>
        <translation>einen anderen Postprozessor wählen</translation>
    </message>
    <message>
        <source>choose another program number</source>
        <translation>eine andere Programmnummer wählen</translation>
    </message>
    <message>
        <source>choose at most the diameter</source>
        <translation>höchstens den Durchmesser wählen</translation>
    </message>
    <message>
        <source>choose one that is</source>
        <translation>eines wählen, das darin steht</translation>
    </message>
    <message>
        <source>choose other slopes</source>
        <translation>andere Neigungen wählen</translation>
    </message>
    <message>
        <source>choose some of its objects</source>
        <translation>einige ihrer Objekte wählen</translation>
    </message>
    <message>
        <source>choose the machine it runs on</source>
        <translation>die Maschine wählen, auf der es läuft</translation>
    </message>
    <message>
        <source>choose the machine that it runs on</source>
        <translation>die Maschine wählen, auf der es läuft</translation>
    </message>
    <message>
        <source>choose the setup's</source>
        <translation>das der Aufspannung wählen</translation>
    </message>
    <message>
        <source>chuck and tailstock keep the tool from {1} of the part's length, which stays uncut</source>
        <translation>Futter und Reitstock halten das Werkzeug von {1} der Länge des Teils ab, die stehen bleibt</translation>
    </message>
    <message>
        <source>chuck and tailstock leave no room for the tool between them</source>
        <translation>Futter und Reitstock lassen dem Werkzeug keinen Platz dazwischen</translation>
    </message>
    <message>
        <source>chuck or tailstock keep the cutter from the part</source>
        <translation>Futter oder Reitstock halten den Fräser vom Teil ab</translation>
    </message>
    <message>
        <source>clearance and chord tolerance must be above 0, the link distance at least 0</source>
        <translation>Sicherheitsabstand und Sehnentoleranz müssen über 0 sein, der Verbindungsabstand mindestens 0</translation>
    </message>
    <message>
        <source>click into a hole, on a boss, or on the flat face beside a hole</source>
        <translation>in ein Loch, auf einen Zapfen oder auf die ebene Fläche neben einem Loch klicken</translation>
    </message>
    <message>
        <source>close it, or use a box or cylinder</source>
        <translation>es schließen, oder Quader oder Zylinder nehmen</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>andere Programme schließen</translation>
    </message>
    <message>
        <source>cm2</source>
        <translation>cm2</translation>
    </message>
    <message>
        <source>come down straight</source>
        <translation>gerade herunterfahren</translation>
    </message>
    <message>
        <source>comments begin with ( or ;</source>
        <translation>Kommentare beginnen mit ( oder ;</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>Berührpunkt</translation>
    </message>
    <message>
        <source>content {1}</source>
        <translation>Inhalt {1}</translation>
    </message>
    <message>
        <source>copy it again as binary (FTP: type binary; Git: mark *.stl as binary)</source>
        <translation>sie binär neu kopieren (FTP: type binary; Git: *.stl als binary)</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>sie neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>copy or save it again</source>
        <translation>sie neu kopieren oder speichern</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>Ecken</translation>
    </message>
    <message>
        <source>correct e and f, or enter 0 for both</source>
        <translation>e und f berichtigen, oder für beide 0 eingeben</translation>
    </message>
    <message>
        <source>correct r, e and f, or give the diameter at which bottom and side line meet</source>
        <translation>r, e und f berichtigen, oder den Durchmesser angeben, bei dem sich Stirn- und Seitenlinie treffen</translation>
    </message>
    <message>
        <source>correct shank and holder</source>
        <translation>Schaft und Halter berichtigen</translation>
    </message>
    <message>
        <source>correct the operation's settings</source>
        <translation>die Einstellungen der Operation berichtigen</translation>
    </message>
    <message>
        <source>correct the program</source>
        <translation>das Programm berichtigen</translation>
    </message>
    <message>
        <source>correct the stock's place and size</source>
        <translation>Größe und Lage des Rohteils berichtigen</translation>
    </message>
    <message>
        <source>correct the table</source>
        <translation>die Tabelle berichtigen</translation>
    </message>
    <message>
        <source>correct them in the part's settings</source>
        <translation>sie in den Einstellungen des Teils berichtigen</translation>
    </message>
    <message>
        <source>counter bore</source>
        <translation>Flachsenker</translation>
    </message>
    <message>
        <source>counter sink</source>
        <translation>Kegelsenker</translation>
    </message>
    <message>
        <source>crossings</source>
        <translation>Überschneidungen</translation>
    </message>
    <message>
        <source>cubic B-spline</source>
        <translation>kubischer B-Spline</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>cut them with the part held another way</source>
        <translation>sie mit anders gehaltenem Teil fräsen</translation>
    </message>
    <message>
        <source>cut: closes the section with facets in the plane.</source>
        <translation>Schnitt: schließt die Schnittfläche mit Facetten in der Ebene.</translation>
    </message>
    <message>
        <source>cut: the plane's direction; what lies on this side of it goes.</source>
        <translation>Schnitt: die Richtung der Ebene; was auf dieser Seite liegt, fällt weg.</translation>
    </message>
    <message>
        <source>cut: the plane's distance from the file's origin along the normal.</source>
        <translation>Schnitt: der Abstand der Ebene vom Ursprung der Datei entlang der Normalen.</translation>
    </message>
    <message>
        <source>cuts nothing</source>
        <translation>fräst nichts</translation>
    </message>
    <message>
        <source>cutter '{1}'</source>
        <translation>Fräser '{1}'</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>cylinder, diameter {1}, height {2}</source>
        <translation>Zylinder, Durchmesser {1}, Höhe {2}</translation>
    </message>
    <message>
        <source>data compressed by zlib</source>
        <translation>mit zlib gepackte Daten</translation>
    </message>
    <message>
        <source>decimate</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <source>decimate: ends when this share of the facets is left. 0 goes as far as the bound allows.</source>
        <translation>Ausdünnen: endet, wenn dieser Anteil der Facetten übrig ist. 0 geht so weit, wie die Schranke erlaubt.</translation>
    </message>
    <message>
        <source>define it before</source>
        <translation>davor festlegen</translation>
    </message>
    <message>
        <source>diameter {1}, along {2}</source>
        <translation>Durchmesser {1}, entlang {2}</translation>
    </message>
    <message>
        <source>did you mean '{1}'?</source>
        <translation>ist '{1}' gemeint?</translation>
    </message>
    <message>
        <source>direction has no meaning for a part that turns: see pattern</source>
        <translation>direction hat bei einem drehenden Teil keine Bedeutung: siehe pattern</translation>
    </message>
    <message>
        <source>does not begin with its JSON</source>
        <translation>beginnt nicht mit seinem JSON</translation>
    </message>
    <message>
        <source>dragged point</source>
        <translation>gezogener Punkt</translation>
    </message>
    <message>
        <source>dragged points</source>
        <translation>gezogene Punkte</translation>
    </message>
    <message>
        <source>draw curves that run side by side</source>
        <translation>Kurven zeichnen, die nebeneinander verlaufen</translation>
    </message>
    <message>
        <source>draw the curve on the part, or list its corners</source>
        <translation>die Kurve auf das Teil zeichnen oder ihre Ecken auflisten</translation>
    </message>
    <message>
        <source>draw them apart</source>
        <translation>sie getrennt zeichnen</translation>
    </message>
    <message>
        <source>each</source>
        <translation>je eines</translation>
    </message>
    <message>
        <source>each facet has {1} bytes, those of a binary STL file have 50</source>
        <translation>jede Facette hat {1} Bytes, die einer binären STL-Datei haben 50</translation>
    </message>
    <message>
        <source>edited region</source>
        <translation>geänderter Bereich</translation>
    </message>
    <message>
        <source>edited regions</source>
        <translation>geänderte Bereiche</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>Elemente sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>enter 0 or more</source>
        <translation>0 oder mehr eingeben</translation>
    </message>
    <message>
        <source>enter a length above 0</source>
        <translation>eine Länge über 0 eingeben</translation>
    </message>
    <message>
        <source>enter a length above 0, or let it follow from the tolerance</source>
        <translation>eine Länge über 0 eingeben, oder sie aus der Toleranz folgen lassen</translation>
    </message>
    <message>
        <source>enter a number</source>
        <translation>eine Zahl eingeben</translation>
    </message>
    <message>
        <source>enter a number, or something like 25.4/2 or 1/4 in</source>
        <translation>eine Zahl eingeben, oder etwas wie 25,4/2 oder 1/4 in</translation>
    </message>
    <message>
        <source>enter a positive diameter</source>
        <translation>einen positiven Durchmesser eingeben</translation>
    </message>
    <message>
        <source>enter a positive height</source>
        <translation>eine positive Höhe eingeben</translation>
    </message>
    <message>
        <source>enter a positive length</source>
        <translation>eine positive Länge eingeben</translation>
    </message>
    <message>
        <source>enter a positive radius</source>
        <translation>einen positiven Radius eingeben</translation>
    </message>
    <message>
        <source>enter a smaller height or taper angle</source>
        <translation>eine kleinere Höhe oder einen kleineren Flankenwinkel eingeben</translation>
    </message>
    <message>
        <source>enter a smaller length</source>
        <translation>eine kleinere Länge eingeben</translation>
    </message>
    <message>
        <source>enter a smaller shank diameter or a larger holder</source>
        <translation>einen kleineren Schaftdurchmesser oder einen größeren Halter eingeben</translation>
    </message>
    <message>
        <source>enter an angle above 0</source>
        <translation>einen Winkel über 0 eingeben</translation>
    </message>
    <message>
        <source>every contact point needs its curves</source>
        <translation>jeder Berührpunkt braucht seine Krümmungen</translation>
    </message>
    <message>
        <source>everywhere on the path the cutter would be below the bottom of the stock</source>
        <translation>überall auf dem Weg wäre der Fräser unter dem Boden des Rohteils</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>excess {1}</source>
        <translation>Überstand {1}</translation>
    </message>
    <message>
        <source>expected a list of {1} numbers</source>
        <translation>eine Liste von {1} Zahlen erwartet</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>eine ganze Zahl erwartet</translation>
    </message>
    <message>
        <source>expected {1}</source>
        <translation>erwartet: {1}</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>neu exportieren</translation>
    </message>
    <message>
        <source>export it again, and copy it as binary</source>
        <translation>neu exportieren und binär kopieren</translation>
    </message>
    <message>
        <source>export it again, or end it with FINI</source>
        <translation>neu exportieren oder mit FINI beenden</translation>
    </message>
    <message>
        <source>export it again, without compression</source>
        <translation>ohne Kompression neu exportieren</translation>
    </message>
    <message>
        <source>export it as a plain mesh</source>
        <translation>als einfaches Netz exportieren</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>als glTF 2.0 exportieren</translation>
    </message>
    <message>
        <source>export it as one file, .glb</source>
        <translation>als eine einzige Datei exportieren, .glb</translation>
    </message>
    <message>
        <source>export it as plain triangles</source>
        <translation>als einfache Dreiecke exportieren</translation>
    </message>
    <message>
        <source>export it in micron, millimeter, centimeter, inch or meter</source>
        <translation>in micron, millimeter, centimeter, inch oder meter exportieren</translation>
    </message>
    <message>
        <source>export it in one unit</source>
        <translation>in einer Einheit exportieren</translation>
    </message>
    <message>
        <source>export it without compression, as plain triangles</source>
        <translation>ohne Kompression exportieren, als einfache Dreiecke</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>sie neu exportieren oder kopieren</translation>
    </message>
    <message>
        <source>export the library anew</source>
        <translation>die Bibliothek neu exportieren</translation>
    </message>
    <message>
        <source>export the part again</source>
        <translation>das Teil neu exportieren</translation>
    </message>
    <message>
        <source>export the part again, or as STL</source>
        <translation>das Teil neu exportieren, oder als STL</translation>
    </message>
    <message>
        <source>export the part again, without</source>
        <translation>das Teil ohne das neu exportieren</translation>
    </message>
    <message>
        <source>export the part as STL</source>
        <translation>das Teil als STL exportieren</translation>
    </message>
    <message>
        <source>export the part as a mesh</source>
        <translation>das Teil als Netz exportieren</translation>
    </message>
    <message>
        <source>export the part as solids or surfaces, not as curves or a mesh</source>
        <translation>das Teil als Körper oder Flächen exportieren, nicht als Kurven oder Netz</translation>
    </message>
    <message>
        <source>export the part as triangles</source>
        <translation>das Teil als Dreiecke exportieren</translation>
    </message>
    <message>
        <source>export the part as {1}</source>
        <translation>das Teil als {1} exportieren</translation>
    </message>
    <message>
        <source>export the part nearer to its origin, and check its unit</source>
        <translation>das Teil näher am Ursprung exportieren und die Einheit prüfen</translation>
    </message>
    <message>
        <source>export the part with a coarser tolerance</source>
        <translation>das Teil mit gröberer Toleranz exportieren</translation>
    </message>
    <message>
        <source>export the part with decimal points</source>
        <translation>das Teil mit Dezimalpunkten exportieren</translation>
    </message>
    <message>
        <source>face mill</source>
        <translation>Planfräser</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet oder endsolid</translation>
    </message>
    <message>
        <source>facet {1}</source>
        <translation>Facette {1}</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>false: the region is not cut.</source>
        <translation>Aus: der Bereich wird nicht gefräst.</translation>
    </message>
    <message>
        <source>fewer than four poles</source>
        <translation>weniger als vier Pole</translation>
    </message>
    <message>
        <source>fill gaps of the picture with a height</source>
        <translation>Lücken des Bildes mit einer Höhe füllen</translation>
    </message>
    <message>
        <source>fill it flat, or leave it with a smaller size</source>
        <translation>flach füllen oder mit kleinerer Größe offen lassen</translation>
    </message>
    <message>
        <source>fins</source>
        <translation>Lappen</translation>
    </message>
    <message>
        <source>fixture '{1}'</source>
        <translation>Spannmittel '{1}'</translation>
    </message>
    <message>
        <source>fixture's mesh</source>
        <translation>Netz des Spannmittels</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>flat end mill</source>
        <translation>Schaftfräser</translation>
    </message>
    <message>
        <source>flutes of {1} instead of {2}</source>
        <translation>Schneiden von {1} statt {2}</translation>
    </message>
    <message>
        <source>flutes of {1} instead of {2} and a stick-out of {3} below the holder instead of {4}</source>
        <translation>Schneiden von {1} statt {2} und eine Auskraglänge von {3} unter dem Halter statt {4}</translation>
    </message>
    <message>
        <source>free some memory</source>
        <translation>Speicher freimachen</translation>
    </message>
    <message>
        <source>free some room</source>
        <translation>Platz schaffen</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>von oben</translation>
    </message>
    <message>
        <source>from setup '{1}': {2}</source>
        <translation>aus Aufspannung '{1}': {2}</translation>
    </message>
    <message>
        <source>from tolerance</source>
        <translation>aus der Toleranz</translation>
    </message>
    <message>
        <source>from {1} to {2} of the centre there is nothing</source>
        <translation>von {1} bis {2} vom Mittelpunkt liegt nichts</translation>
    </message>
    <message>
        <source>from {1}° to {2}° is no range of postures</source>
        <translation>von {1}° bis {2}° ist kein Bereich von Stellungen</translation>
    </message>
    <message>
        <source>give I, J and K</source>
        <translation>I, J und K angeben</translation>
    </message>
    <message>
        <source>give a .png file</source>
        <translation>eine .png-Datei angeben</translation>
    </message>
    <message>
        <source>give a closed mesh, or a box or cylinder</source>
        <translation>ein geschlossenes Netz, einen Quader oder Zylinder angeben</translation>
    </message>
    <message>
        <source>give a direction from the tip to the spindle, upright is 0, 0, 1</source>
        <translation>eine Richtung von der Spitze zur Spindel angeben, senkrecht ist 0, 0, 1</translation>
    </message>
    <message>
        <source>give a feed</source>
        <translation>einen Vorschub angeben</translation>
    </message>
    <message>
        <source>give a length</source>
        <translation>eine Länge angeben</translation>
    </message>
    <message>
        <source>give a library of milling tools</source>
        <translation>eine Bibliothek von Fräswerkzeugen angeben</translation>
    </message>
    <message>
        <source>give a number from 0 to {1}</source>
        <translation>eine Zahl von 0 bis {1} angeben</translation>
    </message>
    <message>
        <source>give a part</source>
        <translation>ein Teil angeben</translation>
    </message>
    <message>
        <source>give a place in the region</source>
        <translation>eine Stelle im Bereich angeben</translation>
    </message>
    <message>
        <source>give a positive feed</source>
        <translation>einen Vorschub über 0 angeben</translation>
    </message>
    <message>
        <source>give a positive length</source>
        <translation>eine positive Länge angeben</translation>
    </message>
    <message>
        <source>give a solid, or use a box or cylinder</source>
        <translation>einen Körper angeben, oder Quader oder Zylinder nehmen</translation>
    </message>
    <message>
        <source>give a speed</source>
        <translation>eine Drehzahl angeben</translation>
    </message>
    <message>
        <source>give a whole number of at least 3</source>
        <translation>eine ganze Zahl von mindestens 3 angeben</translation>
    </message>
    <message>
        <source>give at least four poles</source>
        <translation>mindestens vier Pole angeben</translation>
    </message>
    <message>
        <source>give at least two each way</source>
        <translation>mindestens zwei je Richtung angeben</translation>
    </message>
    <message>
        <source>give each its own</source>
        <translation>jeder ihre eigene geben</translation>
    </message>
    <message>
        <source>give each tool a number of its own</source>
        <translation>jedem Werkzeug eine eigene Nummer geben</translation>
    </message>
    <message>
        <source>give estimate, coarse or fine</source>
        <translation>estimate, coarse oder fine angeben</translation>
    </message>
    <message>
        <source>give every axis its own name</source>
        <translation>jeder Achse ihren eigenen Namen geben</translation>
    </message>
    <message>
        <source>give every boundary its own name</source>
        <translation>jeder Begrenzung einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>give every fixture its own name</source>
        <translation>jedem Spannmittel einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>give every operation its own name</source>
        <translation>jeder Operation einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>give every setup its own name</source>
        <translation>jeder Aufspannung einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>give every tool its own number</source>
        <translation>jedem Werkzeug eine eigene Nummer geben</translation>
    </message>
    <message>
        <source>give it a feed</source>
        <translation>ihm einen Vorschub geben</translation>
    </message>
    <message>
        <source>give it a name</source>
        <translation>ihm einen Namen geben</translation>
    </message>
    <message>
        <source>give it a smaller limit</source>
        <translation>ihm eine kleinere Grenze geben</translation>
    </message>
    <message>
        <source>give it a stock of its own before</source>
        <translation>ihr vorher ein eigenes Rohteil geben</translation>
    </message>
    <message>
        <source>give it in a block before</source>
        <translation>ihn in einem Satz davor angeben</translation>
    </message>
    <message>
        <source>give it {1}</source>
        <translation>ihm {1} geben</translation>
    </message>
    <message>
        <source>give its length and its diameter</source>
        <translation>Länge und Durchmesser angeben</translation>
    </message>
    <message>
        <source>give numbers that no other setup has, from {1}</source>
        <translation>Nummern geben, die keine andere Aufspannung hat, ab {1}</translation>
    </message>
    <message>
        <source>give one for each vertex, or none</source>
        <translation>für jeden Eckpunkt einen angeben, oder keinen</translation>
    </message>
    <message>
        <source>give one of Facetmill, Fusion, CAMotics or Kiri:Moto</source>
        <translation>eine von Facetmill, Fusion, CAMotics oder Kiri:Moto angeben</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>eines davon angeben</translation>
    </message>
    <message>
        <source>give radii and heights that rise</source>
        <translation>Radien und steigende Höhen angeben</translation>
    </message>
    <message>
        <source>give size, facets, area or keep</source>
        <translation>size, facets, area oder keep angeben</translation>
    </message>
    <message>
        <source>give ssh:HOST, the host as ssh knows it</source>
        <translation>ssh:RECHNER angeben, den Rechner, wie ssh ihn kennt</translation>
    </message>
    <message>
        <source>give the boundary a name</source>
        <translation>der Begrenzung einen Namen geben</translation>
    </message>
    <message>
        <source>give the boundary another tool first</source>
        <translation>der Begrenzung zuerst ein anderes Werkzeug geben</translation>
    </message>
    <message>
        <source>give the boundary's place</source>
        <translation>die Stelle der Begrenzung angeben</translation>
    </message>
    <message>
        <source>give the file another name</source>
        <translation>der Datei einen anderen Namen geben</translation>
    </message>
    <message>
        <source>give the fixture a name</source>
        <translation>dem Spannmittel einen Namen geben</translation>
    </message>
    <message>
        <source>give the height that cuts</source>
        <translation>die schneidende Höhe angeben</translation>
    </message>
    <message>
        <source>give the holder's profile</source>
        <translation>das Profil des Halters angeben</translation>
    </message>
    <message>
        <source>give the inclination</source>
        <translation>die Neigung angeben</translation>
    </message>
    <message>
        <source>give the largest speed, in degrees per second</source>
        <translation>die größte Geschwindigkeit angeben, in Grad je Sekunde</translation>
    </message>
    <message>
        <source>give the largest speed, in units per second</source>
        <translation>die größte Geschwindigkeit angeben, in Einheiten je Sekunde</translation>
    </message>
    <message>
        <source>give the length from tip to spindle nose</source>
        <translation>die Länge von der Spitze zur Spindelnase angeben</translation>
    </message>
    <message>
        <source>give the library's tools</source>
        <translation>die Werkzeuge der Bibliothek angeben</translation>
    </message>
    <message>
        <source>give the number of a tool</source>
        <translation>die Nummer eines Werkzeugs angeben</translation>
    </message>
    <message>
        <source>give the number of the previous tool</source>
        <translation>die Nummer des vorherigen Werkzeugs angeben</translation>
    </message>
    <message>
        <source>give the operation a name</source>
        <translation>der Operation einen Namen geben</translation>
    </message>
    <message>
        <source>give the operation another tool first</source>
        <translation>der Operation zuerst ein anderes Werkzeug geben</translation>
    </message>
    <message>
        <source>give the place it moves to</source>
        <translation>die Stelle angeben, wohin sie geht</translation>
    </message>
    <message>
        <source>give the place on the part</source>
        <translation>die Stelle auf dem Teil angeben</translation>
    </message>
    <message>
        <source>give the right to write there</source>
        <translation>Schreibrecht dort geben</translation>
    </message>
    <message>
        <source>give the section's diameter</source>
        <translation>den Durchmesser des Abschnitts angeben</translation>
    </message>
    <message>
        <source>give the section's length</source>
        <translation>die Länge des Abschnitts angeben</translation>
    </message>
    <message>
        <source>give the setup a name</source>
        <translation>der Aufspannung einen Namen geben</translation>
    </message>
    <message>
        <source>give the setup a stock of its own, or use larger tools before it</source>
        <translation>der Aufspannung ein eigenes Rohteil geben oder vorher größere Werkzeuge verwenden</translation>
    </message>
    <message>
        <source>give the stock a margin</source>
        <translation>dem Rohteil eine Zugabe geben</translation>
    </message>
    <message>
        <source>give the stock of the first setup as box, cylinder or mesh</source>
        <translation>das Rohteil der ersten Aufspannung als Quader, Zylinder oder Netz angeben</translation>
    </message>
    <message>
        <source>give the tool a number</source>
        <translation>dem Werkzeug eine Nummer geben</translation>
    </message>
    <message>
        <source>give the tool a smaller number</source>
        <translation>dem Werkzeug eine kleinere Nummer geben</translation>
    </message>
    <message>
        <source>give the tool's diameter</source>
        <translation>den Durchmesser des Werkzeugs angeben</translation>
    </message>
    <message>
        <source>give the yaw</source>
        <translation>den Taumelwinkel angeben</translation>
    </message>
    <message>
        <source>give turns per minute</source>
        <translation>Umdrehungen je Minute angeben</translation>
    </message>
    <message>
        <source>give two angles between {1}° and {2}°, the smaller first</source>
        <translation>zwei Winkel zwischen {1}° und {2}° angeben, den kleineren zuerst</translation>
    </message>
    <message>
        <source>give two points of the axis</source>
        <translation>zwei Punkte der Achse angeben</translation>
    </message>
    <message>
        <source>give two to four sections at increasing, equally spaced X</source>
        <translation>zwei bis vier Schnitte mit steigendem X in gleichen Abständen angeben</translation>
    </message>
    <message>
        <source>global</source>
        <translation>global</translation>
    </message>
    <message>
        <source>go there straight first</source>
        <translation>zuerst gerade dorthin fahren</translation>
    </message>
    <message>
        <source>goes beyond its buffer</source>
        <translation>reicht über seinen Puffer hinaus</translation>
    </message>
    <message>
        <source>goes beyond its part of the buffer</source>
        <translation>reicht über seinen Teil des Puffers hinaus</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>gouge of {1} ({2}), limit {3}</source>
        <translation>Verletzung von {1} ({2}), Grenze {3}</translation>
    </message>
    <message>
        <source>gouge of {1}, limit {2}</source>
        <translation>Verletzung von {1}, Grenze {2}</translation>
    </message>
    <message>
        <source>grblHAL</source>
        <translation>grblHAL</translation>
    </message>
    <message>
        <source>has a corner that is not finite or out of range</source>
        <translation>hat eine Ecke, die nicht endlich oder außerhalb des Bereichs ist</translation>
    </message>
    <message>
        <source>has feeds of some motions only</source>
        <translation>hat nur für einige Bewegungen Vorschübe</translation>
    </message>
    <message>
        <source>has more facets than a tree of their boxes can hold</source>
        <translation>hat mehr Facetten, als ein Baum ihrer Quader fassen kann</translation>
    </message>
    <message>
        <source>has more facets than can be drawn</source>
        <translation>hat mehr Facetten, als gezeichnet werden können</translation>
    </message>
    <message>
        <source>has more facets than the contact index can hold</source>
        <translation>hat mehr Facetten, als der Kontaktindex fasst</translation>
    </message>
    <message>
        <source>has more points than can be drawn</source>
        <translation>hat mehr Punkte, als gezeichnet werden können</translation>
    </message>
    <message>
        <source>has no list of primitives</source>
        <translation>hat keine Liste seiner Teile (primitives)</translation>
    </message>
    <message>
        <source>has no positive radius and length</source>
        <translation>hat keinen positiven Radius und keine positive Länge</translation>
    </message>
    <message>
        <source>has no volume</source>
        <translation>hat kein Volumen</translation>
    </message>
    <message>
        <source>has not been verified</source>
        <translation>wurde nicht geprüft</translation>
    </message>
    <message>
        <source>has not been verified: {1}</source>
        <translation>wurde nicht geprüft: {1}</translation>
    </message>
    <message>
        <source>has too many sections</source>
        <translation>hat zu viele Abschnitte</translation>
    </message>
    <message>
        <source>have it packed again</source>
        <translation>es neu packen lassen</translation>
    </message>
    <message>
        <source>have it packed and sent again</source>
        <translation>es neu packen und schicken lassen</translation>
    </message>
    <message>
        <source>have it packed without a password</source>
        <translation>ohne Kennwort packen lassen</translation>
    </message>
    <message>
        <source>have one project packed, or unpack the archive by other means</source>
        <translation>ein einziges Projekt packen lassen oder das Archiv anders entpacken</translation>
    </message>
    <message>
        <source>have the project packed again, with all its files</source>
        <translation>das Projekt mit allen Dateien neu packen lassen</translation>
    </message>
    <message>
        <source>have the project packed with the files themselves</source>
        <translation>das Projekt mit den Dateien selbst packen lassen</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>Wendel</translation>
    </message>
    <message>
        <source>high {1}</source>
        <translation>{1} hoch</translation>
    </message>
    <message>
        <source>hold less of the stock, or take a smaller tool or clearance</source>
        <translation>weniger vom Rohteil halten, oder Werkzeug oder Abstand kleiner nehmen</translation>
    </message>
    <message>
        <source>holder '{1}'</source>
        <translation>Halter '{1}'</translation>
    </message>
    <message>
        <source>holder '{1}' is left out: this format has none</source>
        <translation>Halter '{1}' fällt weg: dieses Format kennt keine</translation>
    </message>
    <message>
        <source>holder '{1}' is left out: write it as .fcholder</source>
        <translation>Halter '{1}' fällt weg: als .fcholder schreiben</translation>
    </message>
    <message>
        <source>holder {1}</source>
        <translation>Halter {1}</translation>
    </message>
    <message>
        <source>holds changes to other numbers</source>
        <translation>enthält Änderungen an anderen Zahlen (sparse)</translation>
    </message>
    <message>
        <source>holds more numbers than the file has bytes</source>
        <translation>enthält mehr Zahlen, als die Datei Bytes hat</translation>
    </message>
    <message>
        <source>holds no tool</source>
        <translation>enthält kein Werkzeug</translation>
    </message>
    <message>
        <source>holds no tool that can be used: {1}</source>
        <translation>enthält kein verwendbares Werkzeug: {1}</translation>
    </message>
    <message>
        <source>holds no {1}</source>
        <translation>enthält nichts: {1}</translation>
    </message>
    <message>
        <source>holds two projects: {1} and {2}</source>
        <translation>enthält zwei Projekte: {1} und {2}</translation>
    </message>
    <message>
        <source>holds {1} files, more than {2}</source>
        <translation>enthält {1} Dateien, mehr als {2}</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>hole: where the hole is: the one whose middle is nearest, no farther than half its diameter.</source>
        <translation>Loch: wo das Loch ist: das, dessen Mitte am nächsten liegt, nicht weiter als sein halber Durchmesser.</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>holes, hole: smooth goes on as the surface around bends; flat takes the least area. hole: left stays open whatever later steps say.</source>
        <translation>Löcher, Loch: glatt setzt die Krümmung der Fläche ringsum fort; flach nimmt am wenigsten Fläche. Loch: offen bleibt offen, was immer spätere Schritte sagen.</translation>
    </message>
    <message>
        <source>in a file of version 2 every setup has its own</source>
        <translation>in einer Datei der Version 2 hat jede Aufspannung ihre eigenen</translation>
    </message>
    <message>
        <source>in places more stays than the layers leave on slopes ({1}): up to {2} above the allowance, most at {3}</source>
        <translation>stellenweise bleibt mehr, als die Ebenen auf Schrägen lassen ({1}): bis zu {2} über dem Aufmaß, am meisten bei {3}</translation>
    </message>
    <message>
        <source>install Facetmill again</source>
        <translation>Facetmill neu installieren</translation>
    </message>
    <message>
        <source>install Facetmill and {1} of the same version</source>
        <translation>Facetmill und {1} derselben Version installieren</translation>
    </message>
    <message>
        <source>install all of Facetmill</source>
        <translation>ganz Facetmill installieren</translation>
    </message>
    <message>
        <source>install all of Facetmill, or build it with OpenCASCADE; or export the part as STL</source>
        <translation>ganz Facetmill installieren oder mit OpenCASCADE bauen; oder das Teil als STL exportieren</translation>
    </message>
    <message>
        <source>install it (Debian: openssh-client), or let this machine do the work</source>
        <translation>es installieren (Debian: openssh-client) oder diesen Rechner arbeiten lassen</translation>
    </message>
    <message>
        <source>install its commands (Debian: slurm-client), or let this machine do the work</source>
        <translation>seine Befehle installieren (Debian: slurm-client) oder diesen Rechner arbeiten lassen</translation>
    </message>
    <message>
        <source>install the same one there, or name it: --remote-program</source>
        <translation>dort dasselbe installieren oder es nennen: --remote-program</translation>
    </message>
    <message>
        <source>inward</source>
        <translation>einwärts</translation>
    </message>
    <message>
        <source>is JSON, but no glTF: it has no asset</source>
        <translation>ist JSON, aber kein glTF: asset fehlt</translation>
    </message>
    <message>
        <source>is a file that the job reads</source>
        <translation>ist eine Datei, die der Auftrag liest</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is a link or no plain file</source>
        <translation>ist eine Verknüpfung oder keine einfache Datei</translation>
    </message>
    <message>
        <source>is a packed project: its files have no place of their own</source>
        <translation>ist ein gepacktes Projekt: seine Dateien haben keinen eigenen Ort</translation>
    </message>
    <message>
        <source>is a tool library of a newer Facetmill</source>
        <translation>ist eine Werkzeugbibliothek eines neueren Facetmill</translation>
    </message>
    <message>
        <source>is an archive without a project</source>
        <translation>ist ein Archiv ohne Projekt</translation>
    </message>
    <message>
        <source>is an archive, but no 3MF: it has no relationships</source>
        <translation>ist ein Archiv, aber kein 3MF: es hat keine Beziehungen</translation>
    </message>
    <message>
        <source>is binary glTF of version {1}</source>
        <translation>ist binäres glTF der Version {1}</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>ist verschlüsselt</translation>
    </message>
    <message>
        <source>is glTF of version '{1}'</source>
        <translation>ist glTF der Version „{1}“</translation>
    </message>
    <message>
        <source>is more than {1} bytes with those before it, unpacked</source>
        <translation>ist mit denen davor entpackt mehr als {1} Bytes</translation>
    </message>
    <message>
        <source>is needed by a step of kind {1}</source>
        <translation>ein Schritt der Art {1} braucht es</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>ist negativ</translation>
    </message>
    <message>
        <source>is no TIFF picture that can be read: {1}</source>
        <translation>ist kein lesbares TIFF-Bild: {1}</translation>
    </message>
    <message>
        <source>is no list</source>
        <translation>ist keine Liste</translation>
    </message>
    <message>
        <source>is no list of {1} numbers</source>
        <translation>ist keine Liste von {1} Zahlen</translation>
    </message>
    <message>
        <source>is no object</source>
        <translation>ist kein Objekt</translation>
    </message>
    <message>
        <source>is no outline of a holder</source>
        <translation>ist kein Umriss eines Halters</translation>
    </message>
    <message>
        <source>is no packed project</source>
        <translation>ist kein gepacktes Projekt</translation>
    </message>
    <message>
        <source>is no parameter of a turning part</source>
        <translation>ist kein Parameter eines drehenden Teils</translation>
    </message>
    <message>
        <source>is no place in space</source>
        <translation>ist keine Lage im Raum</translation>
    </message>
    <message>
        <source>is no rotation</source>
        <translation>ist keine Drehung</translation>
    </message>
    <message>
        <source>is no sound PNG picture: {1}</source>
        <translation>ist kein heiles PNG-Bild: {1}</translation>
    </message>
    <message>
        <source>is no sound XML: {1}</source>
        <translation>ist kein heiles XML: {1}</translation>
    </message>
    <message>
        <source>is no sound archive: {1}</source>
        <translation>ist kein heiles Archiv: {1}</translation>
    </message>
    <message>
        <source>is no tool library by its name</source>
        <translation>ist dem Namen nach keine Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>is no tool library that this program knows</source>
        <translation>ist keine Werkzeugbibliothek, die dieses Programm kennt</translation>
    </message>
    <message>
        <source>is no whole number</source>
        <translation>ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>is not a 3MF file</source>
        <translation>ist keine 3MF-Datei</translation>
    </message>
    <message>
        <source>is not a 3MF file but {1}</source>
        <translation>ist keine 3MF-Datei, sondern {1}</translation>
    </message>
    <message>
        <source>is not a PLY file: it does not start with 'ply'</source>
        <translation>ist keine PLY-Datei: sie beginnt nicht mit 'ply'</translation>
    </message>
    <message>
        <source>is not a PNG picture</source>
        <translation>ist kein PNG-Bild</translation>
    </message>
    <message>
        <source>is not a PNG picture but {1}</source>
        <translation>ist kein PNG-Bild, sondern {1}</translation>
    </message>
    <message>
        <source>is not a TIFF picture</source>
        <translation>ist kein TIFF-Bild</translation>
    </message>
    <message>
        <source>is not a TIFF picture but {1}</source>
        <translation>ist kein TIFF-Bild, sondern {1}</translation>
    </message>
    <message>
        <source>is not a glTF file</source>
        <translation>ist keine glTF-Datei</translation>
    </message>
    <message>
        <source>is not a glTF file but {1}</source>
        <translation>ist keine glTF-Datei, sondern {1}</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>is not above 0</source>
        <translation>ist nicht über 0</translation>
    </message>
    <message>
        <source>is not an OBJ file{1}</source>
        <translation>ist keine OBJ-Datei{1}</translation>
    </message>
    <message>
        <source>is not an STL file but {1}</source>
        <translation>ist keine STL-Datei, sondern {1}</translation>
    </message>
    <message>
        <source>is of another type than {1}</source>
        <translation>ist von anderer Art als {1}</translation>
    </message>
    <message>
        <source>is there already, and is another file</source>
        <translation>gibt es schon und ist eine andere Datei</translation>
    </message>
    <message>
        <source>is too large for a project</source>
        <translation>ist für ein Projekt zu groß</translation>
    </message>
    <message>
        <source>is what the project as it stands comes to, which is not known: {1}</source>
        <translation>ist das, worauf das Projekt, wie es ist, kommt, und das ist nicht bekannt: {1}</translation>
    </message>
    <message>
        <source>is {1}</source>
        <translation>ist {1}</translation>
    </message>
    <message>
        <source>it asks for more than {1} passes</source>
        <translation>das verlangt mehr als {1} Bahnen</translation>
    </message>
    <message>
        <source>it asks for more than {1} turns</source>
        <translation>das verlangt mehr als {1} Windungen</translation>
    </message>
    <message>
        <source>it asks for too many turns</source>
        <translation>das verlangt zu viele Umläufe</translation>
    </message>
    <message>
        <source>it begins with a point</source>
        <translation>er beginnt mit einem Punkt</translation>
    </message>
    <message>
        <source>it cannot be judged: {1}</source>
        <translation>nicht beurteilbar: {1}</translation>
    </message>
    <message>
        <source>it cannot be locked</source>
        <translation>sie kann nicht gesperrt werden</translation>
    </message>
    <message>
        <source>it cannot be started: </source>
        <translation>es kann nicht gestartet werden: </translation>
    </message>
    <message>
        <source>it cannot be started: {1}</source>
        <translation>es kann nicht gestartet werden: {1}</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>es kann nicht entpackt werden</translation>
    </message>
    <message>
        <source>it cannot be written as a number</source>
        <translation>es kann nicht als Zahl geschrieben werden</translation>
    </message>
    <message>
        <source>it cuts while the spindle stands</source>
        <translation>es fräst, während die Spindel steht</translation>
    </message>
    <message>
        <source>it cuts {1} into the part on purpose: the verification calls that a gouge, unless its limit is more</source>
        <translation>sie schneidet absichtlich {1} ins Teil: die Prüfung nennt das eine Verletzung, es sei denn, ihre Grenze ist größer</translation>
    </message>
    <message>
        <source>it cuts, and no speed of the spindle is given</source>
        <translation>es fräst, und keine Drehzahl ist angegeben</translation>
    </message>
    <message>
        <source>it divides by 0</source>
        <translation>es wird durch 0 geteilt</translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>es passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>it does not fit into the {1} MB of memory that reading it may take</source>
        <translation>es passt nicht in die {1} MB Speicher, die das Lesen belegen darf</translation>
    </message>
    <message>
        <source>it does not meet the stock of {1}: they are {2} apart as the part lies in both</source>
        <translation>es trifft nicht auf das Rohteil von {1}: sie sind {2} auseinander, wie das Teil in beiden liegt</translation>
    </message>
    <message>
        <source>it does not take the job: {1}</source>
        <translation>es nimmt den Auftrag nicht an: {1}</translation>
    </message>
    <message>
        <source>it ends where a number is missing</source>
        <translation>es endet, wo eine Zahl fehlt</translation>
    </message>
    <message>
        <source>it faces down; turn the part over and cut it in another setup</source>
        <translation>sie zeigt nach unten; das Teil wenden und in einer weiteren Aufspannung fräsen</translation>
    </message>
    <message>
        <source>it goes on with what the setup before it leaves, and would be the first</source>
        <translation>sie macht mit dem weiter, was die vorherige lässt, und wäre die erste</translation>
    </message>
    <message>
        <source>it has no value</source>
        <translation>das hat keinen Wert</translation>
    </message>
    <message>
        <source>it holds no solid and no surface</source>
        <translation>sie enthält keinen Körper und keine Fläche</translation>
    </message>
    <message>
        <source>it is alike in all directions and has no principal axes</source>
        <translation>es ist in allen Richtungen gleich und hat keine Hauptachsen</translation>
    </message>
    <message>
        <source>it is an upright wall, which asks for no pass of its own</source>
        <translation>sie ist eine aufrechte Wand, die keine eigene Bahn verlangt</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>er ist leer</translation>
    </message>
    <message>
        <source>it is larger than it says</source>
        <translation>es ist größer, als es sagt</translation>
    </message>
    <message>
        <source>it is left standing</source>
        <translation>er bleibt stehen</translation>
    </message>
    <message>
        <source>it is not as it was written</source>
        <translation>es ist nicht, wie es geschrieben wurde</translation>
    </message>
    <message>
        <source>it is not {1}</source>
        <translation>es ist nicht {1}</translation>
    </message>
    <message>
        <source>it is smaller than it says</source>
        <translation>es ist kleiner, als es sagt</translation>
    </message>
    <message>
        <source>it is switched off</source>
        <translation>sie ist ausgeschaltet</translation>
    </message>
    <message>
        <source>it is {1}, not {2}</source>
        <translation>es ist {1}, nicht {2}</translation>
    </message>
    <message>
        <source>it leaves more than the tolerance</source>
        <translation>sie lässt mehr als die Toleranz</translation>
    </message>
    <message>
        <source>it may be cut short: write it anew</source>
        <translation>es ist vielleicht abgeschnitten: neu schreiben</translation>
    </message>
    <message>
        <source>it may say how often it turns: leave it out</source>
        <translation>es sagt vielleicht, wie oft er dreht: weglassen</translation>
    </message>
    <message>
        <source>it names faces, and the part's file has none: only STEP and IGES files do</source>
        <translation>sie nennt Flächen, und die Datei des Teils hat keine: nur STEP- und IGES-Dateien haben welche</translation>
    </message>
    <message>
        <source>it stands upright: no turn about Z lays it along X</source>
        <translation>sie steht aufrecht: keine Drehung um Z legt sie entlang X</translation>
    </message>
    <message>
        <source>it takes more than {1} facets at this chord tolerance</source>
        <translation>es braucht bei dieser Sehnentoleranz mehr als {1} Facetten</translation>
    </message>
    <message>
        <source>it turns the other way, which is not carried</source>
        <translation>es dreht andersherum, was nicht übernommen wird</translation>
    </message>
    <message>
        <source>it was painted on a part of {1} facets, and this one has {2}</source>
        <translation>sie wurde auf einem Teil mit {1} Facetten gemalt, und dieses hat {2}</translation>
    </message>
    <message>
        <source>it was written meanwhile</source>
        <translation>es wurde inzwischen geschrieben</translation>
    </message>
    <message>
        <source>it, or a file that it reads, was changed since the study began</source>
        <translation>es oder eine Datei, die es liest, wurde geändert, seit die Studie begann</translation>
    </message>
    <message>
        <source>its attributes cannot be read</source>
        <translation>die Attribute sind nicht lesbar</translation>
    </message>
    <message>
        <source>its first bytes are not those of a PNG picture, as after a transfer as text</source>
        <translation>seine ersten Bytes sind nicht die eines PNG-Bildes, wie nach einer Übertragung als Text</translation>
    </message>
    <message>
        <source>its holder is narrower than its shank, and taken as wide</source>
        <translation>der Halter ist schmaler als der Schaft und wird so breit genommen</translation>
    </message>
    <message>
        <source>its neck is taken as wide as the widest of the shank</source>
        <translation>der Hals gilt als so breit wie die breiteste Stelle des Schafts</translation>
    </message>
    <message>
        <source>its numbers are no numbers of vertices</source>
        <translation>seine Zahlen sind keine Nummern von Eckpunkten</translation>
    </message>
    <message>
        <source>its numbers are of an unknown type</source>
        <translation>seine Zahlen sind von unbekannter Art</translation>
    </message>
    <message>
        <source>its numbers lie over each other</source>
        <translation>seine Zahlen liegen übereinander</translation>
    </message>
    <message>
        <source>its objects, put together, have more than 50 million facets</source>
        <translation>seine Objekte haben zusammen mehr als 50 Millionen Facetten</translation>
    </message>
    <message>
        <source>its objects, put together, have more than 50 million facets or a million parts</source>
        <translation>die Objekte haben zusammen mehr als 50 Millionen Facetten oder eine Million Teile</translation>
    </message>
    <message>
        <source>its pieces are planned beside different things</source>
        <translation>seine Stücke sind neben Verschiedenem geplant</translation>
    </message>
    <message>
        <source>its point is taken for one of 119°</source>
        <translation>die Spitze gilt als eine von 119°</translation>
    </message>
    <message>
        <source>its points lie on a line: there is no face to lie on</source>
        <translation>seine Punkte liegen auf einer Geraden: es gibt keine Fläche zum Auflegen</translation>
    </message>
    <message>
        <source>its programs have the numbers {1} to {2}, and those of setup '{3}' {4} to {5}</source>
        <translation>ihre Programme haben die Nummern {1} bis {2}, und die von Aufspannung '{3}' {4} bis {5}</translation>
    </message>
    <message>
        <source>its regions ask for more than {1} facets</source>
        <translation>die Bereiche verlangen mehr als {1} Facetten</translation>
    </message>
    <message>
        <source>its surface has more than {1} facets</source>
        <translation>seine Fläche hat mehr als {1} Facetten</translation>
    </message>
    <message>
        <source>its tool is not in the project any more</source>
        <translation>ihr Werkzeug ist nicht mehr im Projekt</translation>
    </message>
    <message>
        <source>its two curves cross or touch</source>
        <translation>seine zwei Kurven kreuzen oder berühren sich</translation>
    </message>
    <message>
        <source>its two curves cross or touch at {1}</source>
        <translation>ihre zwei Kurven kreuzen oder berühren sich bei {1}</translation>
    </message>
    <message>
        <source>its worker ended with status {1}</source>
        <translation>sein Arbeiter endete mit Status {1}</translation>
    </message>
    <message>
        <source>its worker was ended by signal {1}</source>
        <translation>sein Arbeiter wurde durch Signal {1} beendet</translation>
    </message>
    <message>
        <source>its {1} strips would take more than {2} points of passes</source>
        <translation>ihre {1} Streifen bräuchten mehr als {2} Punkte von Bahnen</translation>
    </message>
    <message>
        <source>join</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>join: the file of the scan that is joined on, in the unit and the coordinates of this one.</source>
        <translation>Verbinden: die Datei des Scans, der angefügt wird, in Einheit und Koordinaten von diesem.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>keep one</source>
        <translation>eines behalten</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>einen davon behalten</translation>
    </message>
    <message>
        <source>kept posture</source>
        <translation>festgehaltene Stellung</translation>
    </message>
    <message>
        <source>kept postures</source>
        <translation>festgehaltene Stellungen</translation>
    </message>
    <message>
        <source>known keys: {1}</source>
        <translation>bekannte Schlüssel: {1}</translation>
    </message>
    <message>
        <source>known meanings: {1}</source>
        <translation>bekannte Bedeutungen: {1}</translation>
    </message>
    <message>
        <source>known words: {1}</source>
        <translation>bekannte Wörter: {1}</translation>
    </message>
    <message>
        <source>known {1}s: {2}; a name that ends with .json is a file of your own</source>
        <translation>bekannt ({1}): {2}; ein Name, der auf .json endet, ist eine eigene Datei</translation>
    </message>
    <message>
        <source>lay it on a face, or turn it by an angle</source>
        <translation>es auf eine Fläche legen oder um einen Winkel drehen</translation>
    </message>
    <message>
        <source>lay the scans on each other first, or allow more</source>
        <translation>die Scans zuerst aufeinander legen oder mehr erlauben</translation>
    </message>
    <message>
        <source>layers of {1} are deeper than the flutes of the tool, {2}</source>
        <translation>Ebenen von {1} sind tiefer als die Schneiden des Werkzeugs, {2}</translation>
    </message>
    <message>
        <source>leave `wcs` out</source>
        <translation>`wcs` weglassen</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>sie weglassen</translation>
    </message>
    <message>
        <source>leave it out, or check its direction</source>
        <translation>weglassen oder ihre Richtung prüfen</translation>
    </message>
    <message>
        <source>leave it where it is</source>
        <translation>sie lassen, wo sie ist</translation>
    </message>
    <message>
        <source>leave out those that are clamped</source>
        <translation>die festgeklemmten weglassen</translation>
    </message>
    <message>
        <source>leave some out</source>
        <translation>einige weglassen</translation>
    </message>
    <message>
        <source>leave the operation out</source>
        <translation>die Operation weglassen</translation>
    </message>
    <message>
        <source>leave the operation out, or allow a smaller tolerance</source>
        <translation>die Operation weglassen oder eine kleinere Toleranz erlauben</translation>
    </message>
    <message>
        <source>leave the operation out, or cut everywhere (rest_only)</source>
        <translation>die Operation weglassen oder überall fräsen (rest_only)</translation>
    </message>
    <message>
        <source>leave the tool axis upright (0, 0, 1)</source>
        <translation>die Werkzeugachse senkrecht lassen (0, 0, 1)</translation>
    </message>
    <message>
        <source>leave the tool axis upright (0, 0, 1), or set the tilt limit to 0</source>
        <translation>die Werkzeugachse senkrecht lassen (0, 0, 1), oder die Neigungsgrenze auf 0 setzen</translation>
    </message>
    <message>
        <source>leave them out</source>
        <translation>sie weglassen</translation>
    </message>
    <message>
        <source>leave this operation out, or check what those before it cut</source>
        <translation>diese Operation weglassen oder prüfen, was die davor fräsen</translation>
    </message>
    <message>
        <source>left</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>left by the main path</source>
        <translation>vom Hauptweg gelassen</translation>
    </message>
    <message>
        <source>left out: '{1}' is no cutter that this program knows</source>
        <translation>weggelassen: '{1}' ist kein Fräser, den dieses Programm kennt</translation>
    </message>
    <message>
        <source>left out: its geometry makes no cutter</source>
        <translation>weggelassen: die Geometrie ergibt keinen Fräser</translation>
    </message>
    <message>
        <source>left out: its holder has sizes that none can have</source>
        <translation>weggelassen: der Halter hat unmögliche Maße</translation>
    </message>
    <message>
        <source>left out: the table has no diameter</source>
        <translation>weggelassen: die Tabelle hat keinen Durchmesser</translation>
    </message>
    <message>
        <source>left out: this format has no '{1}'</source>
        <translation>weggelassen: dieses Format kennt '{1}' nicht</translation>
    </message>
    <message>
        <source>left out: {1}</source>
        <translation>weggelassen: {1}</translation>
    </message>
    <message>
        <source>leftward</source>
        <translation>links</translation>
    </message>
    <message>
        <source>lengths in {1}</source>
        <translation>Längen in {1}</translation>
    </message>
    <message>
        <source>lengthwise</source>
        <translation>Längslinien</translation>
    </message>
    <message>
        <source>let coarser settings vary</source>
        <translation>gröbere Einstellungen variieren lassen</translation>
    </message>
    <message>
        <source>let it end farther out than it begins</source>
        <translation>sie weiter außen enden lassen, als sie beginnt</translation>
    </message>
    <message>
        <source>let less vary</source>
        <translation>weniger variieren lassen</translation>
    </message>
    <message>
        <source>let more vary, or allow more</source>
        <translation>mehr variieren lassen oder mehr erlauben</translation>
    </message>
    <message>
        <source>let the name end in .stl, .3mf or .ply</source>
        <translation>den Namen auf .stl, .3mf oder .ply enden lassen</translation>
    </message>
    <message>
        <source>let the operation name another boundary, or none, first</source>
        <translation>die Operation zuerst eine andere oder keine Begrenzung nennen lassen</translation>
    </message>
    <message>
        <source>list X, Y and Z</source>
        <translation>X, Y und Z nennen</translation>
    </message>
    <message>
        <source>list at least "machining_time"</source>
        <translation>mindestens "machining_time" nennen</translation>
    </message>
    <message>
        <source>list at least one</source>
        <translation>mindestens einen nennen</translation>
    </message>
    <message>
        <source>list at least one place of the project with two values</source>
        <translation>mindestens einen Ort des Projekts mit zwei Werten nennen</translation>
    </message>
    <message>
        <source>list at least one setup</source>
        <translation>mindestens eine Aufspannung auflisten</translation>
    </message>
    <message>
        <source>list the axes: X, Y, Z and up to two rotary ones</source>
        <translation>die Achsen nennen: X, Y, Z und bis zu zwei Drehachsen</translation>
    </message>
    <message>
        <source>list the axis that carries the other one first; check the directions</source>
        <translation>die Achse, die die andere trägt, zuerst nennen; die Richtungen prüfen</translation>
    </message>
    <message>
        <source>list the steps</source>
        <translation>die Schritte auflisten</translation>
    </message>
    <message>
        <source>list what is wanted, as ["machining_time"]</source>
        <translation>nennen, was gewünscht ist, wie ["machining_time"]</translation>
    </message>
    <message>
        <source>local</source>
        <translation>lokal</translation>
    </message>
    <message>
        <source>lofted surface</source>
        <translation>geloftete Fläche</translation>
    </message>
    <message>
        <source>look across it, as along 0, 0, 1</source>
        <translation>quer dazu blicken, etwa entlang 0, 0, 1</translation>
    </message>
    <message>
        <source>lost: {1}</source>
        <translation>verloren: {1}</translation>
    </message>
    <message>
        <source>low {1}</source>
        <translation>{1} niedrig</translation>
    </message>
    <message>
        <source>lower it, or raise the assumed lead limit</source>
        <translation>sie senken, oder die angenommene Grenze erhöhen</translation>
    </message>
    <message>
        <source>lower the feed</source>
        <translation>den Vorschub senken</translation>
    </message>
    <message>
        <source>make it smaller</source>
        <translation>es verkleinern</translation>
    </message>
    <message>
        <source>make it smaller in a picture editor</source>
        <translation>es in einem Bildprogramm verkleinern</translation>
    </message>
    <message>
        <source>make one, or leave the name empty</source>
        <translation>eine anlegen oder den Namen leer lassen</translation>
    </message>
    <message>
        <source>make room or give the right to write there</source>
        <translation>Platz schaffen oder Schreibrecht dort geben</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>Werkstoffe</translation>
    </message>
    <message>
        <source>measured are: {1}</source>
        <translation>gemessen werden: {1}</translation>
    </message>
    <message>
        <source>mend it, or leave it out</source>
        <translation>berichtigen oder weglassen</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>mesh {1}</source>
        <translation>Netz {1}</translation>
    </message>
    <message>
        <source>meshes are not written as {1} files</source>
        <translation>Netze werden nicht als {1}-Dateien geschrieben</translation>
    </message>
    <message>
        <source>meshes[{1}]</source>
        <translation>meshes[{1}]</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>middle height</source>
        <translation>mittlere Höhe</translation>
    </message>
    <message>
        <source>middle of {1}</source>
        <translation>Mitte von {1}</translation>
    </message>
    <message>
        <source>mirror the part itself, which all setups have</source>
        <translation>das Teil selbst spiegeln, das alle Aufspannungen haben</translation>
    </message>
    <message>
        <source>missing closing quote</source>
        <translation>das schließende Anführungszeichen fehlt</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>modulo</translation>
    </message>
    <message>
        <source>more than twice the tolerance stays on {1} of the surface near the part's open borders, where paths may end</source>
        <translation>mehr als die doppelte Toleranz bleibt auf {1} der Fläche nahe den offenen Rändern des Teils, wo Wege enden dürfen</translation>
    </message>
    <message>
        <source>more than {1} layers are asked for</source>
        <translation>verlangt sind mehr als {1} Ebenen</translation>
    </message>
    <message>
        <source>more than {1} lines a layer are asked for</source>
        <translation>verlangt sind mehr als {1} Linien je Ebene</translation>
    </message>
    <message>
        <source>morph</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>motion {1}: </source>
        <translation>Bewegung {1}: </translation>
    </message>
    <message>
        <source>move it onto the part</source>
        <translation>sie auf das Teil verschieben</translation>
    </message>
    <message>
        <source>move its curves or its centre onto the part</source>
        <translation>ihre Kurven oder ihren Mittelpunkt auf das Teil verschieben</translation>
    </message>
    <message>
        <source>move the part onto the axis, let the axis go through the part's middle, or give two points of it</source>
        <translation>das Teil auf die Achse schieben, die Achse durch die Mitte des Teils legen, oder zwei Punkte von ihr angeben</translation>
    </message>
    <message>
        <source>move the part, or change the operation's limits</source>
        <translation>das Teil verschieben oder die Grenzen der Operation ändern</translation>
    </message>
    <message>
        <source>move the part, or choose a shorter tool</source>
        <translation>das Teil verschieben oder ein kürzeres Werkzeug wählen</translation>
    </message>
    <message>
        <source>move them one by one, or at feed</source>
        <translation>einzeln oder im Vorschub bewegen</translation>
    </message>
    <message>
        <source>move what is in the way, make it smaller, or give it less clearance</source>
        <translation>wegrücken, was im Weg ist, verkleinern oder ihm weniger Abstand geben</translation>
    </message>
    <message>
        <source>moved by {1}</source>
        <translation>verschoben um {1}</translation>
    </message>
    <message>
        <source>name a .facetmill or a .json file</source>
        <translation>eine .facetmill- oder .json-Datei nennen</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>eine Datei nennen</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>eine Datei darin nennen</translation>
    </message>
    <message>
        <source>name a file on disk</source>
        <translation>eine Datei auf der Platte nennen</translation>
    </message>
    <message>
        <source>name a file that `facetmill-cli pack` has written</source>
        <translation>eine Datei nennen, die `facetmill-cli pack` geschrieben hat</translation>
    </message>
    <message>
        <source>name a file that `facetmill-cli pack` or File &gt; Save packed copy has written</source>
        <translation>eine Datei nennen, die `facetmill-cli pack` oder Datei &gt; Gepackte Kopie speichern geschrieben hat</translation>
    </message>
    <message>
        <source>name a folder that exists or can be made</source>
        <translation>einen Ordner nennen, den es gibt oder der angelegt werden kann</translation>
    </message>
    <message>
        <source>name a larger tool</source>
        <translation>ein größeres Werkzeug nennen</translation>
    </message>
    <message>
        <source>name a larger tool or a smaller thickness</source>
        <translation>ein größeres Werkzeug oder eine kleinere Dicke nennen</translation>
    </message>
    <message>
        <source>name a positive length</source>
        <translation>eine positive Länge nennen</translation>
    </message>
    <message>
        <source>name a tool of the project</source>
        <translation>ein Werkzeug des Projekts nennen</translation>
    </message>
    <message>
        <source>name an {1} file</source>
        <translation>eine Datei nennen: {1}</translation>
    </message>
    <message>
        <source>name each once: {1}</source>
        <translation>jede einmal nennen: {1}</translation>
    </message>
    <message>
        <source>name faces of the part's file</source>
        <translation>Flächen der Datei des Teils nennen</translation>
    </message>
    <message>
        <source>name it first</source>
        <translation>es zuerst nennen</translation>
    </message>
    <message>
        <source>name it in the project, as `wcs`</source>
        <translation>im Projekt nennen, als `wcs`</translation>
    </message>
    <message>
        <source>name its objects: {1}</source>
        <translation>die Objekte nennen: {1}</translation>
    </message>
    <message>
        <source>name the control as people call it</source>
        <translation>die Steuerung nennen, wie sie heißt</translation>
    </message>
    <message>
        <source>name the fixture's mesh file</source>
        <translation>die Netzdatei des Spannmittels nennen</translation>
    </message>
    <message>
        <source>name the kind of operation</source>
        <translation>die Art der Operation nennen</translation>
    </message>
    <message>
        <source>name the machine</source>
        <translation>die Maschine nennen</translation>
    </message>
    <message>
        <source>name the machine as people call it</source>
        <translation>die Maschine nennen, wie sie heißt</translation>
    </message>
    <message>
        <source>name the other one too, or none to take the outline</source>
        <translation>auch die andere nennen oder keine, um den Umriss zu nehmen</translation>
    </message>
    <message>
        <source>name the other scan's file</source>
        <translation>die Datei des anderen Scans nennen</translation>
    </message>
    <message>
        <source>name the part's file</source>
        <translation>die Datei des Teils nennen</translation>
    </message>
    <message>
        <source>name the project's file</source>
        <translation>die Datei des Projekts nennen</translation>
    </message>
    <message>
        <source>name the stock's mesh file</source>
        <translation>die Netzdatei des Rohteils nennen</translation>
    </message>
    <message>
        <source>name the tool</source>
        <translation>das Werkzeug nennen</translation>
    </message>
    <message>
        <source>name the tool, or write a .fctl library</source>
        <translation>das Werkzeug nennen oder eine .fctl-Bibliothek schreiben</translation>
    </message>
    <message>
        <source>name what varies</source>
        <translation>nennen, was variiert</translation>
    </message>
    <message>
        <source>names a vertex that does not exist</source>
        <translation>nennt einen Eckpunkt, den es nicht gibt</translation>
    </message>
    <message>
        <source>names a vertex that the mesh has not</source>
        <translation>nennt einen Eckpunkt, den das Netz nicht hat</translation>
    </message>
    <message>
        <source>names more than one 3D model</source>
        <translation>nennt mehr als ein 3D-Modell</translation>
    </message>
    <message>
        <source>names no 3D model</source>
        <translation>nennt kein 3D-Modell</translation>
    </message>
    <message>
        <source>names, separated by commas</source>
        <translation>Namen, durch Kommas getrennt</translation>
    </message>
    <message>
        <source>nearest comes {1} ({2}): {3}</source>
        <translation>am nächsten kommt {1} ({2}): {3}</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>Nadeln</translation>
    </message>
    <message>
        <source>needles, smooth, decimate: no place of the surface moves farther. join: nor does the other scan, which is laid on this one; 0: it stays where it is.</source>
        <translation>Nadeln, glatt, Ausdünnen: keine Stelle der Fläche bewegt sich weiter. Verbinden: auch nicht der andere Scan, der auf diesen gelegt wird; 0: er bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>needs a lead of up to {1}, allowed are {2}</source>
        <translation>braucht einen Anstellwinkel bis {1}, erlaubt sind {2}</translation>
    </message>
    <message>
        <source>no FINI or END: the file may be cut short</source>
        <translation>kein FINI oder END: die Datei ist vielleicht abgeschnitten</translation>
    </message>
    <message>
        <source>no arc of this radius leads there</source>
        <translation>kein Bogen dieses Radius führt dorthin</translation>
    </message>
    <message>
        <source>no candidate meets the limits; {1}</source>
        <translation>kein Kandidat hält die Grenzen ein; {1}</translation>
    </message>
    <message>
        <source>no code means '{1}'</source>
        <translation>kein Code bedeutet '{1}'</translation>
    </message>
    <message>
        <source>no code says what the unit of the numbers is</source>
        <translation>kein Code sagt die Einheit der Zahlen</translation>
    </message>
    <message>
        <source>no contact point has a free posture with a lead of at most {1}</source>
        <translation>kein Berührpunkt hat eine freie Stellung mit einem Anstellwinkel von höchstens {1}</translation>
    </message>
    <message>
        <source>no depth leaves what is allowed</source>
        <translation>keine Tiefe lässt nur, was erlaubt ist</translation>
    </message>
    <message>
        <source>no drive plane meets the part</source>
        <translation>keine Führungsebene trifft das Teil</translation>
    </message>
    <message>
        <source>no face has three corners</source>
        <translation>keine Fläche hat drei Ecken</translation>
    </message>
    <message>
        <source>no facet of the part can be cut {1}: all {2} stand upright or have no area</source>
        <translation>keine Facette des Teils kann {1} gefräst werden: alle {2} stehen aufrecht oder haben keine Fläche</translation>
    </message>
    <message>
        <source>no file can be called so</source>
        <translation>so kann keine Datei heißen</translation>
    </message>
    <message>
        <source>no file can be locked there</source>
        <translation>dort kann keine Datei gesperrt werden</translation>
    </message>
    <message>
        <source>no inclined tool that turns steadily is free of the part, and of what stands of the stock, along {1} of the passes, which are left out: rough closer, use a longer tool, or allow a larger tilt limit</source>
        <translation>auf {1} der Bahnen ist kein geneigtes Werkzeug, das sich stetig dreht, frei vom Teil und von dem, was vom Rohteil steht; sie bleiben aus: näher schruppen, ein längeres Werkzeug nehmen, oder eine größere Neigungsgrenze erlauben</translation>
    </message>
    <message>
        <source>no layer lies lower than {1}, where stock or part end, and over {2} of the part, seen {3}, the tool would have to be lower: up to {4} stays above the allowance, most at {5}: take a tool that is flatter at its end, or leave it to what comes after</source>
        <translation>keine Ebene liegt tiefer als {1}, wo Rohteil oder Teil enden, und über {2} des Teils, {3} gesehen, müsste das Werkzeug tiefer sein: bis zu {4} bleibt über dem Aufmaß, am meisten bei {5}: ein an der Stirn flacheres Werkzeug nehmen oder es dem Späteren überlassen</translation>
    </message>
    <message>
        <source>no lead up to {1} is free</source>
        <translation>kein Anstellwinkel bis {1} ist frei</translation>
    </message>
    <message>
        <source>no level lies within it</source>
        <translation>keine Höhenlinie liegt darin</translation>
    </message>
    <message>
        <source>no lines of this tool leave as little as {1}</source>
        <translation>keine Linien dieses Werkzeugs lassen so wenig wie {1}</translation>
    </message>
    <message>
        <source>no motion at feed comes near the stock</source>
        <translation>keine Bewegung im Vorschub kommt dem Rohteil nahe</translation>
    </message>
    <message>
        <source>no operation before it cuts with tool {1}, its previous tool: what that would have cut stays</source>
        <translation>keine Operation davor fräst mit Werkzeug {1}, ihrem vorherigen Werkzeug: was das gefräst hätte, bleibt stehen</translation>
    </message>
    <message>
        <source>no operation finishes there: only the tool{1} fits, and that operation leaves stock</source>
        <translation>keine Operation schlichtet dort: nur das Werkzeug{1} passt, und diese Operation lässt Material stehen</translation>
    </message>
    <message>
        <source>no operation was planned</source>
        <translation>keine Operation wurde geplant</translation>
    </message>
    <message>
        <source>no pass lies within it</source>
        <translation>keine Bahn liegt darin</translation>
    </message>
    <message>
        <source>no pass meets the part</source>
        <translation>keine Bahn trifft das Teil</translation>
    </message>
    <message>
        <source>no pass meets the stock</source>
        <translation>keine Bahn trifft das Rohteil</translation>
    </message>
    <message>
        <source>no place needs a lead above {1}: the main path cuts all of the part, there is nothing to rework</source>
        <translation>keine Stelle braucht einen Anstellwinkel über {1}: der Hauptweg fräst das ganze Teil, es gibt nichts nachzuarbeiten</translation>
    </message>
    <message>
        <source>no place of the part can be come to</source>
        <translation>keine Stelle des Teils ist erreichbar</translation>
    </message>
    <message>
        <source>no place of the part can be come to from above</source>
        <translation>keine Stelle des Teils ist von oben erreichbar</translation>
    </message>
    <message>
        <source>no setup comes before the first, so there is no rest of its stock</source>
        <translation>vor der ersten kommt keine Aufspannung, also gibt es keinen Rest ihres Rohteils</translation>
    </message>
    <message>
        <source>no stream</source>
        <translation>kein Datenstrom</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>no temporary folder can be made: {1}</source>
        <translation>kein temporärer Ordner kann angelegt werden: {1}</translation>
    </message>
    <message>
        <source>no tool axis sees it</source>
        <translation>keine Werkzeugachse sieht sie</translation>
    </message>
    <message>
        <source>no tool fits</source>
        <translation>kein Werkzeug passt</translation>
    </message>
    <message>
        <source>no tool is in the spindle</source>
        <translation>kein Werkzeug ist in der Spindel</translation>
    </message>
    <message>
        <source>no valley lies where something is to be cut</source>
        <translation>kein Tal liegt dort, wo etwas zu fräsen ist</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>no work coordinate system is chosen</source>
        <translation>kein Werkstückkoordinatensystem ist gewählt</translation>
    </message>
    <message>
        <source>nobody has said which tool leaves it</source>
        <translation>niemand hat gesagt, welches Werkzeug ihn lässt</translation>
    </message>
    <message>
        <source>nodes hold each other too deeply, or themselves</source>
        <translation>Knoten enthalten einander zu tief oder sich selbst</translation>
    </message>
    <message>
        <source>nodes[{1}]</source>
        <translation>nodes[{1}]</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none of its surfaces could be tessellated</source>
        <translation>keine ihrer Flächen konnte vernetzt werden</translation>
    </message>
    <message>
        <source>none of the operations looked at can be made: {1}: {2}</source>
        <translation>keine der betrachteten Operationen ist möglich: {1}: {2}</translation>
    </message>
    <message>
        <source>none of the operations looked at can be made{1}</source>
        <translation>keine der betrachteten Operationen ist möglich{1}</translation>
    </message>
    <message>
        <source>none of the {1} facets has an area</source>
        <translation>keine der {1} Facetten hat eine Fläche</translation>
    </message>
    <message>
        <source>none of {1} contact points has a free posture</source>
        <translation>keiner von {1} Berührpunkten hat eine freie Stellung</translation>
    </message>
    <message>
        <source>none was planned</source>
        <translation>keiner wurde geplant</translation>
    </message>
    <message>
        <source>normals turn by more than the limit</source>
        <translation>Normalen drehen sich um mehr als die Grenze</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>nicht angesehen</translation>
    </message>
    <message>
        <source>not one line has the word {wcs}</source>
        <translation>keine Zeile hat das Wort {wcs}</translation>
    </message>
    <message>
        <source>not one line has the words {plane_z} and {plane_x}</source>
        <translation>keine Zeile hat die Wörter {plane_z} und {plane_x}</translation>
    </message>
    <message>
        <source>not valid JSON near '{1}'</source>
        <translation>kein gültiges JSON bei '{1}'</translation>
    </message>
    <message>
        <source>nothing ends the tilted plane</source>
        <translation>nichts beendet die geschwenkte Ebene</translation>
    </message>
    <message>
        <source>nothing follows the header</source>
        <translation>dem Kopf folgt nichts</translation>
    </message>
    <message>
        <source>nothing has to be cleaned up, or allow less</source>
        <translation>nichts ist nachzuarbeiten, oder weniger erlauben</translation>
    </message>
    <message>
        <source>nothing is cut</source>
        <translation>nichts wird gefräst</translation>
    </message>
    <message>
        <source>nothing is left between its ends</source>
        <translation>zwischen seinen Enden bleibt nichts</translation>
    </message>
    <message>
        <source>nothing is measured that is called '{1}'</source>
        <translation>nichts, was gemessen wird, heißt '{1}'</translation>
    </message>
    <message>
        <source>nothing is wanted</source>
        <translation>nichts ist gewünscht</translation>
    </message>
    <message>
        <source>nothing lies on the file's build plate</source>
        <translation>auf der Bauplatte der Datei liegt nichts</translation>
    </message>
    <message>
        <source>nothing may vary</source>
        <translation>nichts darf variieren</translation>
    </message>
    <message>
        <source>nothing of it is left by {1}</source>
        <translation>nichts davon lässt {1}</translation>
    </message>
    <message>
        <source>nothing of the part goes round: its passes run from edge to edge</source>
        <translation>kein Stück des Teils läuft rundum: die Bahnen verlaufen von Kante zu Kante</translation>
    </message>
    <message>
        <source>nothing of the part holds the tool on its way to the axis</source>
        <translation>nichts am Teil hält das Werkzeug auf seinem Weg zur Achse auf</translation>
    </message>
    <message>
        <source>nothing of the part is as steep as asked for</source>
        <translation>nichts am Teil ist so steil wie verlangt</translation>
    </message>
    <message>
        <source>nothing of the part is to be cut</source>
        <translation>nichts am Teil ist zu fräsen</translation>
    </message>
    <message>
        <source>nothing of the part lies in it</source>
        <translation>nichts vom Teil liegt darin</translation>
    </message>
    <message>
        <source>nothing of the part lies so far within it that the cutter has room</source>
        <translation>nichts vom Teil liegt so weit darin, dass der Fräser Platz hat</translation>
    </message>
    <message>
        <source>nothing of the part lies where it is to cut</source>
        <translation>nichts vom Teil liegt dort, wo sie fräsen soll</translation>
    </message>
    <message>
        <source>nothing of the part that can be cut {1} has a slope from {2} to {3} degrees</source>
        <translation>nichts vom Teil, was {1} bearbeitet werden kann, hat eine Neigung von {2} bis {3} Grad</translation>
    </message>
    <message>
        <source>nothing of the part that can be cut {1} is less steep than {2} degrees</source>
        <translation>nichts vom Teil, was {1} bearbeitet werden kann, ist weniger steil als {2} Grad</translation>
    </message>
    <message>
        <source>nothing of the stock stands above the part and the allowance of {1}</source>
        <translation>vom Rohteil steht nichts über dem Teil und dem Aufmaß von {1}</translation>
    </message>
    <message>
        <source>nothing runs so far to that side of it</source>
        <translation>so weit auf dieser Seite verläuft nichts</translation>
    </message>
    <message>
        <source>nothing runs {1} to that side of it</source>
        <translation>nichts verläuft {1} auf dieser Seite von ihr</translation>
    </message>
    <message>
        <source>nothing says what the feed is per</source>
        <translation>nichts sagt, worauf sich der Vorschub bezieht</translation>
    </message>
    <message>
        <source>nothing takes the tool up</source>
        <translation>nichts hebt das Werkzeug ab</translation>
    </message>
    <message>
        <source>nothing turns the rotary axes: no code means 'plane_axes'</source>
        <translation>nichts dreht die Drehachsen: kein Code bedeutet 'plane_axes'</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>nowhere is the part's outline straight and free enough</source>
        <translation>nirgends ist der Umriss des Teils gerade und frei genug</translation>
    </message>
    <message>
        <source>nowhere more than the tolerance stands of the stock</source>
        <translation>nirgends steht vom Rohteil mehr als die Toleranz</translation>
    </message>
    <message>
        <source>nowhere on the part, away from its open borders, is what the programs leave held against the tolerance</source>
        <translation>nirgends am Teil, abseits offener Ränder, wird an der Toleranz gemessen, was die Programme lassen</translation>
    </message>
    <message>
        <source>number tools from 1</source>
        <translation>Werkzeuge von 1 an nummerieren</translation>
    </message>
    <message>
        <source>object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>object {1}</source>
        <translation>Objekt {1}</translation>
    </message>
    <message>
        <source>objects and lists are nested too deep</source>
        <translation>Objekte und Listen sind zu tief verschachtelt</translation>
    </message>
    <message>
        <source>objects are put together too deeply, or hold themselves: {1}</source>
        <translation>Objekte sind zu tief zusammengesetzt oder enthalten sich selbst: {1}</translation>
    </message>
    <message>
        <source>objects there are: {1}</source>
        <translation>vorhandene Objekte: {1}</translation>
    </message>
    <message>
        <source>of the largest speed</source>
        <translation>der größten Geschwindigkeit</translation>
    </message>
    <message>
        <source>of what stands above the allowance this tool reaches nothing</source>
        <translation>von dem, was über dem Aufmaß steht, erreicht dieses Werkzeug nichts</translation>
    </message>
    <message>
        <source>on</source>
        <translation>auf</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eines</translation>
    </message>
    <message>
        <source>one of: {1}</source>
        <translation>eines von: {1}</translation>
    </message>
    <message>
        <source>one place is left to clean-up because the tool cannot come there from its neighbours without gouging or turning too far</source>
        <translation>eine Stelle bleibt der Restbearbeitung, weil das Werkzeug von den Nachbarn nicht ohne Verletzung oder zu große Drehung dorthin kommt</translation>
    </message>
    <message>
        <source>oneway</source>
        <translation>einseitig</translation>
    </message>
    <message>
        <source>only UNITS/MM and UNITS/INCHES are read</source>
        <translation>nur UNITS/MM und UNITS/INCHES werden gelesen</translation>
    </message>
    <message>
        <source>only a ball cuts the same however it leans, and tool {1} has no ball end</source>
        <translation>nur eine Kugel fräst gleich, wie sie sich auch neigt, und Werkzeug {1} hat kein Kugelende</translation>
    </message>
    <message>
        <source>only a step of kind hole leaves a hole open</source>
        <translation>nur ein Schritt der Art Loch lässt ein Loch offen</translation>
    </message>
    <message>
        <source>only one of its two curves is named</source>
        <translation>nur eine ihrer zwei Kurven ist genannt</translation>
    </message>
    <message>
        <source>only {1}/OFF is read; output plain GOTO statements</source>
        <translation>nur {1}/OFF wird gelesen; reine GOTO-Anweisungen ausgeben</translation>
    </message>
    <message>
        <source>open the file itself, under a name that ends as its format does</source>
        <translation>die Datei selbst öffnen, unter einem Namen, der wie ihr Format endet</translation>
    </message>
    <message>
        <source>open the mesh itself, under a name that ends as its format does</source>
        <translation>das Netz selbst öffnen, unter einem Namen, der wie sein Format endet</translation>
    </message>
    <message>
        <source>open them one by one, or join them in the program that made them</source>
        <translation>einzeln öffnen, oder in dem Programm verbinden, das sie gemacht hat</translation>
    </message>
    <message>
        <source>operation '{1}'</source>
        <translation>Operation '{1}'</translation>
    </message>
    <message>
        <source>operation '{1}' cuts within it</source>
        <translation>Operation '{1}' fräst darin</translation>
    </message>
    <message>
        <source>operation '{1}' follows it</source>
        <translation>die Operation „{1}“ folgt ihr</translation>
    </message>
    <message>
        <source>operation '{1}' has a feed of {2} mm/min, and the machine goes {3} at most</source>
        <translation>Operation '{1}' hat einen Vorschub von {2} mm/min, und die Maschine fährt höchstens {3}</translation>
    </message>
    <message>
        <source>operation '{1}' has tool {2}, and the control numbers them to {3}</source>
        <translation>Operation '{1}' hat Werkzeug {2}, und die Steuerung zählt sie bis {3}</translation>
    </message>
    <message>
        <source>operation '{1}' inclines the tool, and the control has three axes</source>
        <translation>Operation '{1}' neigt das Werkzeug, und die Steuerung hat drei Achsen</translation>
    </message>
    <message>
        <source>operation '{1}' keeps off it</source>
        <translation>Operation '{1}' meidet sie</translation>
    </message>
    <message>
        <source>operation '{1}' turns the part, and the control has no inverse time feed</source>
        <translation>Operation '{1}' dreht das Teil, und die Steuerung hat keinen zeitreziproken Vorschub</translation>
    </message>
    <message>
        <source>operation '{1}' uses this tool</source>
        <translation>Operation '{1}' verwendet dieses Werkzeug</translation>
    </message>
    <message>
        <source>operation '{1}', motion {2}: the machine would have to rewind its rotary axes while it cuts, and there is no room to</source>
        <translation>Operation '{1}', Bewegung {2}: die Maschine müsste ihre Drehachsen beim Fräsen zurückdrehen, und dafür ist kein Platz</translation>
    </message>
    <message>
        <source>operation '{1}', {2}</source>
        <translation>Operation '{1}', {2}</translation>
    </message>
    <message>
        <source>operation '{1}': {2} would go from {3} to {4} of the machine, and its travel ends before</source>
        <translation>Operation '{1}': {2} ginge von {3} bis {4} der Maschine, und der Verfahrweg endet vorher</translation>
    </message>
    <message>
        <source>operations of this kind have no preview of their passes</source>
        <translation>Operationen dieser Art haben keine Vorschau ihrer Bahnen</translation>
    </message>
    <message>
        <source>operations there are: {1}</source>
        <translation>vorhandene Operationen: {1}</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>Ursprung</translation>
    </message>
    <message>
        <source>other postures would be free than this way of choosing tries: choose them by global</source>
        <translation>andere Stellungen wären frei als die, die diese Wahl versucht: sie global wählen</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>output straight GOTO statements (no arcs, cycles or transformations)</source>
        <translation>gerade GOTO-Anweisungen ausgeben (keine Bögen, Zyklen oder Transformationen)</translation>
    </message>
    <message>
        <source>outward</source>
        <translation>auswärts</translation>
    </message>
    <message>
        <source>paint facets, widen it, or move it onto the part</source>
        <translation>Facetten malen, sie erweitern oder auf das Teil schieben</translation>
    </message>
    <message>
        <source>paint it anew</source>
        <translation>neu malen</translation>
    </message>
    <message>
        <source>paint the boundary anew</source>
        <translation>die Begrenzung neu malen</translation>
    </message>
    <message>
        <source>paint the boundary, or take the part from such a file</source>
        <translation>die Begrenzung malen oder das Teil aus einer solchen Datei nehmen</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallel</translation>
    </message>
    <message>
        <source>parallel: in drive planes along the direction. morph: each piece of the surface by itself, in passes that go over from its one edge along the direction to the other, as the surface flows: blades and shrouds. around: in closed rings about each piece that goes round (blades, hubs, bottles), from its one border to the other or to its end; other pieces as with morph. A fixed step-over is kept where passes are farthest apart.</source>
        <translation>parallel: in Führungsebenen entlang der Richtung. morph: jedes Stück der Oberfläche für sich, in Bahnen, die von seiner einen Kante entlang der Richtung in die andere übergehen, wie die Oberfläche verläuft: Schaufeln und Deckscheiben. around: in geschlossenen Ringen um jedes Stück, das rundum läuft (Schaufeln, Naben, Flaschen), von seinem einen Rand zum anderen oder zu seinem Ende; andere Stücke wie mit morph. Ein fester Bahnabstand wird eingehalten, wo Bahnen am weitesten auseinander liegen.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>part.repair[{1}].file</source>
        <translation>part.repair[{1}].file</translation>
    </message>
    <message>
        <source>passes are up to {1} below the stock's outside, the flutes are {2} long: use a longer tool</source>
        <translation>Bahnen liegen bis zu {1} unter der Außenseite des Rohteils, die Schneiden sind {2} lang: ein längeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>pick another edge, or lay the part first</source>
        <translation>eine andere Kante wählen oder das Teil zuerst hinlegen</translation>
    </message>
    <message>
        <source>pick points of one side</source>
        <translation>Punkte einer Seite wählen</translation>
    </message>
    <message>
        <source>pick three points that are farther apart</source>
        <translation>drei weiter entfernte Punkte wählen</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>pieces: only so many with the largest areas stay.</source>
        <translation>Stücke: nur so viele mit den größten Flächen bleiben.</translation>
    </message>
    <message>
        <source>pieces: those whose box has a smaller diagonal go. holes: those of at most this diameter are filled, 0: all. crossings: as holes. fins: as pieces. join: how far two scans of one surface may lie apart, 0: three mean edges.</source>
        <translation>Stücke: die mit kleinerer Quaderdiagonale fallen weg. Löcher: die von höchstens diesem Durchmesser werden gefüllt, 0: alle. Überschneidungen: wie Löcher. Lappen: wie Stücke. Verbinden: wie weit zwei Scans einer Fläche auseinander liegen dürfen, 0: drei mittlere Kanten.</translation>
    </message>
    <message>
        <source>pieces: those with fewer facets go. decimate: ends when so few are left.</source>
        <translation>Stücke: die mit weniger Facetten fallen weg. Ausdünnen: endet, wenn so wenige übrig sind.</translation>
    </message>
    <message>
        <source>pieces: those with less area go.</source>
        <translation>Stücke: die mit weniger Fläche fallen weg.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>Stelle</translation>
    </message>
    <message>
        <source>places are not told from the origin</source>
        <translation>Orte sind nicht vom Ursprung aus angegeben</translation>
    </message>
    <message>
        <source>places lie under the part itself, seen along the tool</source>
        <translation>Stellen liegen in Werkzeugrichtung unter dem Teil selbst</translation>
    </message>
    <message>
        <source>places looked at are {1} apart, and a cutter has a radius of {2}: a resolution and a spacing of at most {3} would do</source>
        <translation>untersuchte Stellen sind {1} auseinander, und ein Fräser hat den Radius {2}: Auflösung und Abstand von höchstens {3} würden genügen</translation>
    </message>
    <message>
        <source>plan again</source>
        <translation>neu planen</translation>
    </message>
    <message>
        <source>plan again; report the project</source>
        <translation>neu planen; das Projekt melden</translation>
    </message>
    <message>
        <source>plan an operation first</source>
        <translation>zuerst eine Operation planen</translation>
    </message>
    <message>
        <source>plan at least one</source>
        <translation>mindestens eine planen</translation>
    </message>
    <message>
        <source>plan it again</source>
        <translation>neu planen</translation>
    </message>
    <message>
        <source>plan the operation to see its passes</source>
        <translation>die Operation planen, um ihre Bahnen zu sehen</translation>
    </message>
    <message>
        <source>plan the operation to see why</source>
        <translation>die Operation planen, um zu sehen, warum</translation>
    </message>
    <message>
        <source>plan the setups before this one</source>
        <translation>die Aufspannungen davor planen</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>plunge</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>points into the part</source>
        <translation>zeigt in das Teil</translation>
    </message>
    <message>
        <source>post '{1}'</source>
        <translation>Postprozessor '{1}'</translation>
    </message>
    <message>
        <source>preset {1}</source>
        <translation>Voreinstellung {1}</translation>
    </message>
    <message>
        <source>process the program to plain GOTO statements first</source>
        <translation>das Programm zuerst zu reinen GOTO-Anweisungen verarbeiten</translation>
    </message>
    <message>
        <source>program '{1}'</source>
        <translation>Programm '{1}'</translation>
    </message>
    <message>
        <source>put GOTO or FROM before it</source>
        <translation>GOTO oder FROM davorsetzen</translation>
    </message>
    <message>
        <source>put UNITS before CUTTER and the first GOTO</source>
        <translation>UNITS vor CUTTER und das erste GOTO setzen</translation>
    </message>
    <message>
        <source>put it into one of "setups"</source>
        <translation>es in eine der "setups" setzen</translation>
    </message>
    <message>
        <source>put it there, or name another one in the project</source>
        <translation>sie dorthin legen oder im Projekt eine andere nennen</translation>
    </message>
    <message>
        <source>put the zero elsewhere, or mend the file</source>
        <translation>den Nullpunkt anderswohin setzen oder die Datei in Ordnung bringen</translation>
    </message>
    <message>
        <source>raise the feed, or the feed's decimals in the post</source>
        <translation>den Vorschub oder seine Dezimalen im Postprozessor erhöhen</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>reading stopped before the end of the file</source>
        <translation>das Lesen endete vor dem Ende der Datei</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rechteckig</translation>
    </message>
    <message>
        <source>reduce the mesh</source>
        <translation>das Netz verkleinern</translation>
    </message>
    <message>
        <source>regions of rework</source>
        <translation>Nacharbeitsbereiche</translation>
    </message>
    <message>
        <source>remove its operations instead</source>
        <translation>stattdessen ihre Operationen entfernen</translation>
    </message>
    <message>
        <source>rename an operation, a setup or the part's file</source>
        <translation>eine Operation, eine Aufspannung oder die Datei des Teils umbenennen</translation>
    </message>
    <message>
        <source>rename or export it again</source>
        <translation>umbenennen oder neu exportieren</translation>
    </message>
    <message>
        <source>rename the file or the item</source>
        <translation>die Datei oder den Eintrag umbenennen</translation>
    </message>
    <message>
        <source>report the part</source>
        <translation>das Teil melden</translation>
    </message>
    <message>
        <source>report this</source>
        <translation>das melden</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>retract Z first</source>
        <translation>zuerst Z zurückziehen</translation>
    </message>
    <message>
        <source>retract before it</source>
        <translation>davor zurückziehen</translation>
    </message>
    <message>
        <source>retract otherwise</source>
        <translation>anders zurückziehen</translation>
    </message>
    <message>
        <source>retract to 0 of the machine</source>
        <translation>auf 0 der Maschine zurückziehen</translation>
    </message>
    <message>
        <source>rework: {1}</source>
        <translation>Nacharbeit: {1}</translation>
    </message>
    <message>
        <source>rightward</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>Ringe</translation>
    </message>
    <message>
        <source>rings need a border to lie along</source>
        <translation>Ringe brauchen einen Rand, an dem sie liegen</translation>
    </message>
    <message>
        <source>rotary axes turn to a tilted plane while the tool is down</source>
        <translation>Drehachsen drehen zu einer geschwenkten Ebene, während das Werkzeug unten ist</translation>
    </message>
    <message>
        <source>rotate the part</source>
        <translation>das Teil drehen</translation>
    </message>
    <message>
        <source>rough before it, or use flutes that are {1} longer</source>
        <translation>vorher schruppen oder um {1} längere Schneiden nehmen</translation>
    </message>
    <message>
        <source>rough before it, use a longer tool, or allow a larger tilt limit</source>
        <translation>vorher schruppen, ein längeres Werkzeug nehmen, oder eine größere Neigungsgrenze erlauben</translation>
    </message>
    <message>
        <source>rough with a tool whose taper angle is 0 or more</source>
        <translation>mit einem Werkzeug schruppen, dessen Flankenwinkel 0 oder mehr ist</translation>
    </message>
    <message>
        <source>roughing with a tool that is narrower above its end leaves material hanging over it</source>
        <translation>Schruppen mit einem Werkzeug, das über der Stirn schmaler ist, lässt überhängendes Material</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>U/min</translation>
    </message>
    <message>
        <source>run the study again</source>
        <translation>die Studie noch einmal laufen lassen</translation>
    </message>
    <message>
        <source>sample surface</source>
        <translation>Beispielfläche</translation>
    </message>
    <message>
        <source>save it as ASCII or UTF-8</source>
        <translation>als ASCII oder UTF-8 speichern</translation>
    </message>
    <message>
        <source>save it as ASCII or UTF-8 (PowerShell: Out-File -Encoding ascii)</source>
        <translation>ihn als ASCII oder UTF-8 speichern (PowerShell: Out-File -Encoding ascii)</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>sie als UTF-8 speichern</translation>
    </message>
    <message>
        <source>save it as one channel of grey, upright</source>
        <translation>als einen einzigen Graukanal speichern, aufrecht</translation>
    </message>
    <message>
        <source>save it as one channel of grey: 8 or 16 bits, or 32-bit floats</source>
        <translation>als einen einzigen Graukanal speichern: 8 oder 16 Bit, oder Gleitkommazahlen von 32 Bit</translation>
    </message>
    <message>
        <source>save it in binary form, as .glb</source>
        <translation>in binärer Form speichern, als .glb</translation>
    </message>
    <message>
        <source>save it in strips or smaller tiles</source>
        <translation>in Streifen oder kleineren Kacheln speichern</translation>
    </message>
    <message>
        <source>save it with 8 bits a channel</source>
        <translation>mit 8 Bit je Kanal speichern</translation>
    </message>
    <message>
        <source>save it without interlacing</source>
        <translation>ohne Interlacing speichern</translation>
    </message>
    <message>
        <source>save the file as UTF-8</source>
        <translation>die Datei als UTF-8 speichern</translation>
    </message>
    <message>
        <source>save the picture as PNG, 8 or 16 bits of grey</source>
        <translation>das Bild als PNG speichern, 8 oder 16 Bit Grau</translation>
    </message>
    <message>
        <source>save the picture as TIFF, 16 bits of grey</source>
        <translation>das Bild als TIFF speichern, 16 Bit Grau</translation>
    </message>
    <message>
        <source>say how far the surface may move</source>
        <translation>sagen, wie weit sich die Fläche bewegen darf</translation>
    </message>
    <message>
        <source>say how large a place may be made anew</source>
        <translation>sagen, wie groß eine Stelle sein darf, die neu gemacht wird</translation>
    </message>
    <message>
        <source>say how large a sheet may be that goes</source>
        <translation>sagen, wie groß ein Lappen sein darf, der wegfällt</translation>
    </message>
    <message>
        <source>say how thick the sheet becomes</source>
        <translation>sagen, wie dick die Fläche wird</translation>
    </message>
    <message>
        <source>say the plane's direction</source>
        <translation>die Richtung der Ebene nennen</translation>
    </message>
    <message>
        <source>say what the step does</source>
        <translation>sagen, was der Schritt tut</translation>
    </message>
    <message>
        <source>scallop</source>
        <translation>gleiche Rillenhöhe</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>see the codes of its post</source>
        <translation>siehe die Codes ihres Postprozessors</translation>
    </message>
    <message>
        <source>see the numbers in table.md</source>
        <translation>siehe die Zahlen in table.md</translation>
    </message>
    <message>
        <source>see the words and codes of its post</source>
        <translation>siehe die Wörter und Codes ihres Postprozessors</translation>
    </message>
    <message>
        <source>see the words of its post</source>
        <translation>siehe die Wörter ihres Postprozessors</translation>
    </message>
    <message>
        <source>see what ssh says to it</source>
        <translation>nachsehen, was ssh dazu sagt</translation>
    </message>
    <message>
        <source>see whether Slurm runs: sinfo</source>
        <translation>nachsehen, ob Slurm läuft: sinfo</translation>
    </message>
    <message>
        <source>send Z home first</source>
        <translation>zuerst Z zur Grundstellung schicken</translation>
    </message>
    <message>
        <source>send Z home first, alone</source>
        <translation>zuerst Z allein zur Grundstellung schicken</translation>
    </message>
    <message>
        <source>send it again as a binary file</source>
        <translation>noch einmal als Binärdatei senden</translation>
    </message>
    <message>
        <source>send the files as they are</source>
        <translation>die Dateien schicken, wie sie sind</translation>
    </message>
    <message>
        <source>set multi_axis to tcp or vectors</source>
        <translation>multi_axis auf tcp oder vectors setzen</translation>
    </message>
    <message>
        <source>set the tilt limit or the depth to 0</source>
        <translation>die Neigungsgrenze oder die Tiefe auf 0 setzen</translation>
    </message>
    <message>
        <source>set the {1}</source>
        <translation>setzen: {1}</translation>
    </message>
    <message>
        <source>setup '{1}'</source>
        <translation>Aufspannung '{1}'</translation>
    </message>
    <message>
        <source>setups there are: {1}</source>
        <translation>vorhandene Aufspannungen: {1}</translation>
    </message>
    <message>
        <source>shank or holder come into the stock, as operations with the upright tool leave it, along {1} of {2} of cuts, as far as passes before them have not cleared it: rough there first, or use longer flutes</source>
        <translation>Schaft oder Halter kommen in das Rohteil, wie Operationen mit senkrechtem Werkzeug es lassen, entlang {1} von {2} der Schnitte, soweit Bahnen davor es nicht abgetragen haben: dort zuerst schruppen oder längere Schneiden nehmen</translation>
    </message>
    <message>
        <source>shank or holder keep the cutter from hollows of the part</source>
        <translation>Schaft oder Halter halten den Fräser von Mulden des Teils ab</translation>
    </message>
    <message>
        <source>shank or holder would come into the part wherever the cutter could cut</source>
        <translation>Schaft oder Halter kämen in das Teil, wo immer der Fräser fräsen könnte</translation>
    </message>
    <message>
        <source>shank or holder would come into the part, or into what stands of the stock, wherever the cutter could cut, however far it is inclined within the tilt limit</source>
        <translation>Schaft oder Halter kämen ins Teil, oder in das, was vom Rohteil steht, wo immer der Fräser schneiden könnte, wie weit er sich innerhalb der Neigungsgrenze auch neigt</translation>
    </message>
    <message>
        <source>shank or holder would come into the stock wherever the cutter could cut</source>
        <translation>Schaft oder Halter kämen in das Rohteil, wo immer der Fräser fräsen könnte</translation>
    </message>
    <message>
        <source>shank or holder would come into what stands of the stock beside {1} of the passes, which are left out: flutes of {2} instead of {3}, or roughing closer, would reach it</source>
        <translation>Schaft oder Halter kämen in das, was vom Rohteil neben {1} der Bahnen steht, die wegfallen: Schneiden von {2} statt {3} oder genaueres Schruppen kämen hin</translation>
    </message>
    <message>
        <source>shank or holder would hit the stock</source>
        <translation>Schaft oder Halter träfen das Rohteil</translation>
    </message>
    <message>
        <source>shank or holder would hit the stock: {1} of cuts are left out, the first at {2}: use a longer tool</source>
        <translation>Schaft oder Halter träfen das Rohteil: {1} an Schnitten fallen weg, der erste bei {2}: ein längeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>shape and lengths are not carried</source>
        <translation>Form und Längen werden nicht übernommen</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>ihn kürzen</translation>
    </message>
    <message>
        <source>shorten the line of the post, or the names in it</source>
        <translation>die Zeile des Postprozessors oder die Namen darin kürzen</translation>
    </message>
    <message>
        <source>show one that does</source>
        <translation>eines zeigen, das es tut</translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>slot mill</source>
        <translation>Nutfräser</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>smooth: edges that bend by more are features and stay sharp.</source>
        <translation>glatt: Kanten, die stärker abknicken, sind Merkmale und bleiben scharf.</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>split the file: one program each</source>
        <translation>die Datei teilen: je ein Programm</translation>
    </message>
    <message>
        <source>spot drill</source>
        <translation>NC-Anbohrer</translation>
    </message>
    <message>
        <source>start before the stop, and where the part is</source>
        <translation>vor dem Ende anfangen, und wo das Teil ist</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>stock's mesh</source>
        <translation>Netz des Rohteils</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>strips</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>strips around what operations before left</source>
        <translation>Streifen um das, was frühere Operationen ließen</translation>
    </message>
    <message>
        <source>switch it on (off: false)</source>
        <translation>sie einschalten (off: false)</translation>
    </message>
    <message>
        <source>switch one on, or leave the operation out</source>
        <translation>einen einschalten oder die Operation weglassen</translation>
    </message>
    <message>
        <source>switch that off</source>
        <translation>das ausschalten</translation>
    </message>
    <message>
        <source>switch that off before it</source>
        <translation>das davor ausschalten</translation>
    </message>
    <message>
        <source>switch that on before it</source>
        <translation>das davor einschalten</translation>
    </message>
    <message>
        <source>switch the plane off before it</source>
        <translation>davor die Ebene ausschalten</translation>
    </message>
    <message>
        <source>switch the plane off first</source>
        <translation>zuerst die Ebene ausschalten</translation>
    </message>
    <message>
        <source>switched off · {1} · no tool yet</source>
        <translation>ausgeschaltet · {1} · noch kein Werkzeug</translation>
    </message>
    <message>
        <source>switched off · {1} · tool {2}</source>
        <translation>ausgeschaltet · {1} · Werkzeug {2}</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>Steg</translation>
    </message>
    <message>
        <source>take a larger tool, or leave the operation out</source>
        <translation>ein größeres Werkzeug nehmen oder die Operation weglassen</translation>
    </message>
    <message>
        <source>take a smaller tool, or allow it to plunge</source>
        <translation>ein kleineres Werkzeug nehmen oder ihm senkrechtes Eintauchen erlauben</translation>
    </message>
    <message>
        <source>take a tool that has one, set the tilt limit to 0, or finish with five axes (finish5)</source>
        <translation>ein Werkzeug nehmen, das eines hat, die Neigungsgrenze auf 0 setzen, oder mit fünf Achsen schlichten (finish5)</translation>
    </message>
    <message>
        <source>take the winner, or one of the front</source>
        <translation>den Sieger nehmen oder einen der Front</translation>
    </message>
    <message>
        <source>taper {1}°</source>
        <translation>Kegel {1}°</translation>
    </message>
    <message>
        <source>tapered mill</source>
        <translation>konischer Fräser</translation>
    </message>
    <message>
        <source>the 3D model has no name</source>
        <translation>das 3D-Modell hat keinen Namen</translation>
    </message>
    <message>
        <source>the 3D model is not in the file</source>
        <translation>das 3D-Modell ist nicht in der Datei</translation>
    </message>
    <message>
        <source>the PNG picture cannot be read</source>
        <translation>das PNG-Bild ist nicht lesbar</translation>
    </message>
    <message>
        <source>the XML declares a document type or entities</source>
        <translation>das XML erklärt einen Dokumenttyp oder Entitäten</translation>
    </message>
    <message>
        <source>the XML is no 3MF model: it begins with {1}</source>
        <translation>das XML ist kein 3MF-Modell: es beginnt mit {1}</translation>
    </message>
    <message>
        <source>the allowance is negative or not a finite number</source>
        <translation>das Aufmaß ist negativ oder keine endliche Zahl</translation>
    </message>
    <message>
        <source>the amount is not above 0</source>
        <translation>der Betrag ist nicht über 0</translation>
    </message>
    <message>
        <source>the angle of its point is not carried</source>
        <translation>der Winkel der Spitze wird nicht übernommen</translation>
    </message>
    <message>
        <source>the attribute {1} is missing</source>
        <translation>das Attribut {1} fehlt</translation>
    </message>
    <message>
        <source>the axes turn to a tilted plane, and there is none</source>
        <translation>die Achsen drehen zu einer geschwenkten Ebene, und es gibt keine</translation>
    </message>
    <message>
        <source>the axis {1} is missing</source>
        <translation>die Achse {1} fehlt</translation>
    </message>
    <message>
        <source>the ball's radius is not above 0</source>
        <translation>der Kugelradius ist nicht über 0</translation>
    </message>
    <message>
        <source>the block '{1}' is longer than {2} characters</source>
        <translation>der Satz '{1}' ist länger als {2} Zeichen</translation>
    </message>
    <message>
        <source>the block has more than {1} characters</source>
        <translation>der Satz hat mehr als {1} Zeichen</translation>
    </message>
    <message>
        <source>the bottom angle is out of range</source>
        <translation>der Stirnwinkel ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the bottom angle {1} is out of range</source>
        <translation>der Stirnwinkel {1} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the buffer has no data</source>
        <translation>der Puffer hat keine Daten</translation>
    </message>
    <message>
        <source>the buffer has {1} bytes, not {2}</source>
        <translation>der Puffer hat {1} Bytes, nicht {2}</translation>
    </message>
    <message>
        <source>the cells of a stock field are not above 0</source>
        <translation>die Zellen eines Rohteilfeldes sind nicht über 0</translation>
    </message>
    <message>
        <source>the centre has no words</source>
        <translation>der Mittelpunkt hat keine Wörter</translation>
    </message>
    <message>
        <source>the centre of an arc has a part across its plane</source>
        <translation>der Mittelpunkt eines Bogens hat einen Anteil quer zu seiner Ebene</translation>
    </message>
    <message>
        <source>the centre or radius of an arc is given without one</source>
        <translation>Mittelpunkt oder Radius eines Bogens ist ohne Bogen angegeben</translation>
    </message>
    <message>
        <source>the choice of a work coordinate system is not whole</source>
        <translation>die Wahl eines Werkstückkoordinatensystems ist nicht vollständig</translation>
    </message>
    <message>
        <source>the chord tolerance is not a length above 0</source>
        <translation>die Sehnentoleranz ist keine Länge über 0</translation>
    </message>
    <message>
        <source>the chord tolerance is so small that the mesh would have more than {1} million facets</source>
        <translation>die Sehnentoleranz ist so klein, dass das Netz mehr als {1} Millionen Facetten hätte</translation>
    </message>
    <message>
        <source>the coarse grid has too few lines</source>
        <translation>das grobe Raster hat zu wenige Linien</translation>
    </message>
    <message>
        <source>the control cannot change tools, and the program has several</source>
        <translation>die Steuerung kann keine Werkzeuge wechseln, und das Programm hat mehrere</translation>
    </message>
    <message>
        <source>the control chooses how to hold the tilted plane</source>
        <translation>die Steuerung wählt, wie die geschwenkte Ebene gehalten wird</translation>
    </message>
    <message>
        <source>the control has no word for the axis {1}</source>
        <translation>die Steuerung hat kein Wort für die Achse {1}</translation>
    </message>
    <message>
        <source>the control has no work coordinate system '{1}'</source>
        <translation>die Steuerung hat kein Werkstückkoordinatensystem '{1}'</translation>
    </message>
    <message>
        <source>the control would not read it</source>
        <translation>die Steuerung würde ihn nicht lesen</translation>
    </message>
    <message>
        <source>the control's, its zero in {1}</source>
        <translation>das der Steuerung, Nullpunkt in {1}</translation>
    </message>
    <message>
        <source>the coordinate {1} is beyond {2}</source>
        <translation>die Koordinate {1} ist jenseits von {2}</translation>
    </message>
    <message>
        <source>the coordinate {1} is too large</source>
        <translation>die Koordinate {1} ist zu groß</translation>
    </message>
    <message>
        <source>the core radius keeps the cutter from the part</source>
        <translation>der Kernradius hält den Fräser vom Teil ab</translation>
    </message>
    <message>
        <source>the corner circle of radius {1} about ({2}, {3}) does not round the corner between bottom and side to a convex cutter</source>
        <translation>der Eckenkreis vom Radius {1} um ({2}, {3}) rundet die Ecke zwischen Stirn und Seite nicht zu einem konvexen Fräser</translation>
    </message>
    <message>
        <source>the corner radius {1} does not fit the diameter {2}</source>
        <translation>der Eckenradius {1} passt nicht zum Durchmesser {2}</translation>
    </message>
    <message>
        <source>the corner radius {1} is negative</source>
        <translation>der Eckenradius {1} ist negativ</translation>
    </message>
    <message>
        <source>the count of a list must be an integer</source>
        <translation>die Anzahl einer Liste muss ganzzahlig sein</translation>
    </message>
    <message>
        <source>the cutter goes {1} below the bottom of the stock, as 'Below the bottom' allows</source>
        <translation>der Fräser geht {1} unter den Boden des Rohteils, wie 'Unter dem Boden' es erlaubt</translation>
    </message>
    <message>
        <source>the cutter has no place along {1} of its passes: they are left out there</source>
        <translation>der Fräser hat entlang {1} seiner Bahnen keinen Platz: dort fallen sie weg</translation>
    </message>
    <message>
        <source>the cutter has room there, and the holder would hit the part by every axis; use a longer tool or a smaller holder</source>
        <translation>der Fräser hat dort Platz, und der Halter träfe bei jeder Achse das Teil; ein längeres Werkzeug oder einen kleineren Halter nehmen</translation>
    </message>
    <message>
        <source>the cutter has room there, and the shank would hit the part by every axis; use a longer or thinner tool</source>
        <translation>der Fräser hat dort Platz, und der Schaft träfe bei jeder Achse das Teil; ein längeres oder dünneres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the cutter is too large for hollows of the part</source>
        <translation>der Fräser ist zu groß für Mulden des Teils</translation>
    </message>
    <message>
        <source>the cutter is too large for hollows of the part: {1} stays uncut by up to {2}, most at {3}: use a smaller tool there</source>
        <translation>der Fräser ist zu groß für Mulden des Teils: {1} bleiben um bis zu {2} stehen, am meisten bei {3}: dort ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the cutter is too large for the innermost of the strips: up to {1} stays, most at {2}: use a smaller tool there</source>
        <translation>der Fräser ist zu groß für die innersten Streifen: bis zu {1} bleibt stehen, am meisten bei {2}: dort ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the cutter leaves more than the tolerance: use a smaller step-over or tool</source>
        <translation>der Fräser lässt mehr als die Toleranz: einen kleineren Bahnabstand oder ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the cutter touches no two flanks of a valley that it leaves</source>
        <translation>der Fräser berührt nirgends zwei Flanken eines Tals, in dem er etwas lässt</translation>
    </message>
    <message>
        <source>the cutter touches the part nowhere at two places between which it leaves more than the tolerance</source>
        <translation>der Fräser berührt das Teil nirgends an zwei Stellen, zwischen denen er mehr als die Toleranz lässt</translation>
    </message>
    <message>
        <source>the cutter would cut into the part</source>
        <translation>der Fräser würde in das Teil schneiden</translation>
    </message>
    <message>
        <source>the cutter's radius {1} is too small</source>
        <translation>der Fräserradius {1} ist zu klein</translation>
    </message>
    <message>
        <source>the cutter{1} fits, but its shank or holder would touch the part</source>
        <translation>der Fräser{1} passt, aber Schaft oder Halter würden das Teil berühren</translation>
    </message>
    <message>
        <source>the data is no base64</source>
        <translation>die Daten sind kein base64</translation>
    </message>
    <message>
        <source>the data lies in another file, '{1}'</source>
        <translation>die Daten liegen in einer anderen Datei, „{1}“</translation>
    </message>
    <message>
        <source>the depth of cut asks for more than {1} passes</source>
        <translation>die Schnitttiefe verlangt mehr als {1} Bahnen</translation>
    </message>
    <message>
        <source>the depth of cut asks for too many passes</source>
        <translation>die Schnitttiefe verlangt zu viele Bahnen</translation>
    </message>
    <message>
        <source>the depth of cut of {1} is more than the {2} that stand above the part: one pass takes all</source>
        <translation>die Schnitttiefe von {1} ist mehr als die {2}, die über dem Teil stehen: eine Bahn nimmt alles</translation>
    </message>
    <message>
        <source>the depth of the layers is not above 0</source>
        <translation>die Tiefe der Ebenen ist nicht über 0</translation>
    </message>
    <message>
        <source>the diameter is not above 0</source>
        <translation>der Durchmesser ist nicht über 0</translation>
    </message>
    <message>
        <source>the diameter of what holds the part is 0</source>
        <translation>der Durchmesser dessen, was das Teil hält, ist 0</translation>
    </message>
    <message>
        <source>the diameter {1} is not above 0</source>
        <translation>der Durchmesser {1} ist nicht über 0</translation>
    </message>
    <message>
        <source>the diameter {1} is too large</source>
        <translation>der Durchmesser {1} ist zu groß</translation>
    </message>
    <message>
        <source>the direction has no length</source>
        <translation>die Richtung hat keine Länge</translation>
    </message>
    <message>
        <source>the element '{1}' occurs twice</source>
        <translation>das Element '{1}' kommt zweimal vor</translation>
    </message>
    <message>
        <source>the element has too many properties</source>
        <translation>das Element hat zu viele Eigenschaften</translation>
    </message>
    <message>
        <source>the face names vertex {1}, the file has {2} (from 0)</source>
        <translation>die Fläche nennt Eckpunkt {1}, die Datei hat {2} (ab 0)</translation>
    </message>
    <message>
        <source>the faces have no list vertex_indices of integers</source>
        <translation>die Flächen haben keine Liste vertex_indices ganzer Zahlen</translation>
    </message>
    <message>
        <source>the facet has more than three corners</source>
        <translation>die Facette hat mehr als drei Ecken</translation>
    </message>
    <message>
        <source>the facet names vertex {1}, the file has {2}</source>
        <translation>die Facette nennt Eckpunkt {1}, die Datei hat {2}</translation>
    </message>
    <message>
        <source>the facet names vertex {1}, {2} are known so far</source>
        <translation>die Facette nennt Eckpunkt {1}, bekannt sind bisher {2}</translation>
    </message>
    <message>
        <source>the facets cannot be written: {1}</source>
        <translation>die Facetten können nicht geschrieben werden: {1}</translation>
    </message>
    <message>
        <source>the feed is not above 0</source>
        <translation>der Vorschub ist nicht über 0</translation>
    </message>
    <message>
        <source>the feed {1} is out of range</source>
        <translation>der Vorschub {1} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the file ends here</source>
        <translation>die Datei endet hier</translation>
    </message>
    <message>
        <source>the file ends in its header</source>
        <translation>die Datei endet in ihrem Kopf</translation>
    </message>
    <message>
        <source>the file ends in these elements</source>
        <translation>die Datei endet in diesen Elementen</translation>
    </message>
    <message>
        <source>the file ends inside a facet</source>
        <translation>die Datei endet in einer Facette</translation>
    </message>
    <message>
        <source>the file ends inside a list of {1}</source>
        <translation>die Datei endet in einer Liste von {1}</translation>
    </message>
    <message>
        <source>the file ends inside a number</source>
        <translation>die Datei endet in einer Zahl</translation>
    </message>
    <message>
        <source>the file ends inside the header</source>
        <translation>die Datei endet im Kopf</translation>
    </message>
    <message>
        <source>the file ends inside the word facet</source>
        <translation>die Datei endet im Wort facet</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>die Datei endet zu früh</translation>
    </message>
    <message>
        <source>the file ends within a line, without FINI or END</source>
        <translation>die Datei endet in einer Zeile, ohne FINI oder END</translation>
    </message>
    <message>
        <source>the file ends within a statement</source>
        <translation>die Datei endet in einer Anweisung</translation>
    </message>
    <message>
        <source>the file ends within a value</source>
        <translation>die Datei endet in einem Wert</translation>
    </message>
    <message>
        <source>the file ends within its data</source>
        <translation>die Datei endet mitten in ihren Daten</translation>
    </message>
    <message>
        <source>the file has more than 4 thousand million elements</source>
        <translation>die Datei hat mehr als 4 Milliarden Elemente</translation>
    </message>
    <message>
        <source>the file has more than 4 thousand million vertices</source>
        <translation>die Datei hat mehr als 4 Milliarden Eckpunkte</translation>
    </message>
    <message>
        <source>the file has version {1}, this program reads up to {2}</source>
        <translation>die Datei hat Version {1}, dieses Programm liest bis {2}</translation>
    </message>
    <message>
        <source>the file has {1} bytes, a binary STL file at least 84</source>
        <translation>die Datei hat {1} Bytes, eine binäre STL-Datei mindestens 84</translation>
    </message>
    <message>
        <source>the file has {1} bytes, and should have more</source>
        <translation>die Datei hat {1} Bytes und sollte mehr haben</translation>
    </message>
    <message>
        <source>the file holds no face</source>
        <translation>die Datei enthält keine Fläche</translation>
    </message>
    <message>
        <source>the file holds no facet</source>
        <translation>die Datei enthält keine Facette</translation>
    </message>
    <message>
        <source>the file holds no mesh</source>
        <translation>die Datei enthält kein Netz</translation>
    </message>
    <message>
        <source>the file holds no triangles</source>
        <translation>die Datei enthält keine Dreiecke</translation>
    </message>
    <message>
        <source>the file holds no vertices</source>
        <translation>die Datei enthält keine Eckpunkte</translation>
    </message>
    <message>
        <source>the file holds points but no face</source>
        <translation>die Datei enthält Punkte, aber keine Fläche</translation>
    </message>
    <message>
        <source>the file is damaged or in another unit</source>
        <translation>die Datei ist beschädigt oder in einer anderen Einheit</translation>
    </message>
    <message>
        <source>the file is damaged or is not STL: export it again</source>
        <translation>die Datei ist beschädigt oder kein STL: neu exportieren</translation>
    </message>
    <message>
        <source>the file is damaged or of another kind: export it again</source>
        <translation>die Datei ist beschädigt oder anderer Art: neu exportieren</translation>
    </message>
    <message>
        <source>the file is damaged: export it again</source>
        <translation>die Datei ist beschädigt: neu exportieren</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>the file is for a newer Facetmill</source>
        <translation>die Datei ist für ein neueres Facetmill</translation>
    </message>
    <message>
        <source>the file is not UTF-8 text (UTF-16 or binary)</source>
        <translation>die Datei ist kein UTF-8-Text (UTF-16 oder binär)</translation>
    </message>
    <message>
        <source>the file is not plain text (UTF-16 or binary)</source>
        <translation>die Datei ist kein reiner Text (UTF-16 oder binär)</translation>
    </message>
    <message>
        <source>the file is too large for a project or a machine</source>
        <translation>die Datei ist für ein Projekt oder eine Maschine zu groß</translation>
    </message>
    <message>
        <source>the file was cut: copy or export it again</source>
        <translation>die Datei wurde abgeschnitten: neu kopieren oder exportieren</translation>
    </message>
    <message>
        <source>the first must be below the second</source>
        <translation>die erste muss unter der zweiten liegen</translation>
    </message>
    <message>
        <source>the fixture {1}</source>
        <translation>das Spannmittel {1}</translation>
    </message>
    <message>
        <source>the fixtures {1}</source>
        <translation>die Spannmittel {1}</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>der Ordner kann nicht angelegt werden</translation>
    </message>
    <message>
        <source>the folder cannot be made: {1}</source>
        <translation>der Ordner kann nicht angelegt werden: {1}</translation>
    </message>
    <message>
        <source>the format is not known</source>
        <translation>das Format ist nicht bekannt</translation>
    </message>
    <message>
        <source>the free postures are too far from those of the neighbours: allow a larger turn limit</source>
        <translation>die freien Stellungen sind zu weit von denen der Nachbarn: eine größere Drehgrenze erlauben</translation>
    </message>
    <message>
        <source>the gouge limit is {1}, and a cutter has a radius of {2}: allow at most {3}</source>
        <translation>die Grenze der Verletzung ist {1}, und ein Fräser hat den Radius {2}: höchstens {3} erlauben</translation>
    </message>
    <message>
        <source>the half angle {1} is out of range</source>
        <translation>der halbe Winkel {1} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the header</source>
        <translation>der Kopf</translation>
    </message>
    <message>
        <source>the header announces {1} facets, the file has bytes for {2}</source>
        <translation>der Kopf kündigt {1} Facetten an, die Datei hat Bytes für {2}</translation>
    </message>
    <message>
        <source>the header announces {1} of '{2}', more than the file has bytes for</source>
        <translation>der Kopf kündigt {1} von '{2}' an, mehr als die Datei Bytes hat</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>der Kopf nennt kein Format</translation>
    </message>
    <message>
        <source>the header names too many elements</source>
        <translation>der Kopf nennt zu viele Elemente</translation>
    </message>
    <message>
        <source>the height {1} is not above 0</source>
        <translation>die Höhe {1} ist nicht über 0</translation>
    </message>
    <message>
        <source>the holder</source>
        <translation>der Halter</translation>
    </message>
    <message>
        <source>the holder of {1} cannot hold a shank of {2}</source>
        <translation>der Halter von {1} kann keinen Schaft von {2} halten</translation>
    </message>
    <message>
        <source>the holder would hit the part</source>
        <translation>der Halter träfe das Teil</translation>
    </message>
    <message>
        <source>the holder would hit the part: use a longer tool or a smaller holder</source>
        <translation>der Halter träfe das Teil: ein längeres Werkzeug oder einen kleineren Halter nehmen</translation>
    </message>
    <message>
        <source>the host cannot be reached without a password</source>
        <translation>der Rechner ist ohne Passwort nicht zu erreichen</translation>
    </message>
    <message>
        <source>the job writes it twice</source>
        <translation>der Auftrag schreibt sie zweimal</translation>
    </message>
    <message>
        <source>the key is missing</source>
        <translation>der Schlüssel fehlt</translation>
    </message>
    <message>
        <source>the key occurs twice</source>
        <translation>der Schlüssel kommt zweimal vor</translation>
    </message>
    <message>
        <source>the last triangle has no three corners</source>
        <translation>das letzte Dreieck hat keine drei Ecken</translation>
    </message>
    <message>
        <source>the lead limit is raised to {1}: that takes about {2}, {3} and rework of {4} {5}</source>
        <translation>die Grenze wird auf {1} erhöht: das braucht etwa {2}, {3} und die Nacharbeit von {4} {5}</translation>
    </message>
    <message>
        <source>the lead limit {1} is above that of the assumed path, {2}</source>
        <translation>die Grenze {1} liegt über der des angenommenen Wegs, {2}</translation>
    </message>
    <message>
        <source>the leaning cutter is kept from going below the bottom of the stock, by up to {1} at {2} of the points: some material stays there unless 'Below the bottom' allows it</source>
        <translation>der geneigte Fräser wird davor bewahrt, unter den Boden des Rohteils zu gehen, um bis zu {1} bei {2} der Punkte: dort bleibt etwas Material stehen, wenn 'Unter dem Boden' es nicht erlaubt</translation>
    </message>
    <message>
        <source>the length of a tool is called by an edge or by a number, not by both</source>
        <translation>die Länge eines Werkzeugs wird durch eine Schneide oder durch eine Nummer aufgerufen, nicht durch beide</translation>
    </message>
    <message>
        <source>the length of the tool is negative or no number</source>
        <translation>die Länge des Werkzeugs ist negativ oder keine Zahl</translation>
    </message>
    <message>
        <source>the length of tool {1} is called, and another one is in the spindle</source>
        <translation>die Länge von Werkzeug {1} wird aufgerufen, und ein anderes ist in der Spindel</translation>
    </message>
    <message>
        <source>the levels leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller step-down, or wider slope limits</source>
        <translation>die Höhenlinien lassen mehr stehen als erwartet: {1} bleiben um bis zu {2} ungefräst, am meisten bei {3}: eine kleinere Zustellung oder weitere Neigungsgrenzen wählen</translation>
    </message>
    <message>
        <source>the limits {1} and {2} leave no travel</source>
        <translation>die Grenzen {1} und {2} lassen keinen Verfahrweg</translation>
    </message>
    <message>
        <source>the limits {1} are reversed or equal</source>
        <translation>die Grenzen {1} sind vertauscht oder gleich</translation>
    </message>
    <message>
        <source>the line '{1}': {2}</source>
        <translation>die Zeile '{1}': {2}</translation>
    </message>
    <message>
        <source>the line END-ISO-10303-21; of a STEP file</source>
        <translation>die Zeile END-ISO-10303-21; einer STEP-Datei</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>die Zeile ist zu lang</translation>
    </message>
    <message>
        <source>the line occurs twice, or has other words than {wcs}</source>
        <translation>die Zeile kommt zweimal vor oder hat andere Wörter als {wcs}</translation>
    </message>
    <message>
        <source>the list has {1} values</source>
        <translation>die Liste hat {1} Werte</translation>
    </message>
    <message>
        <source>the list length</source>
        <translation>die Länge der Liste</translation>
    </message>
    <message>
        <source>the machine cannot hold this place</source>
        <translation>die Maschine kann diesen Ort nicht halten</translation>
    </message>
    <message>
        <source>the machine has no axis {1}</source>
        <translation>die Maschine hat keine Achse {1}</translation>
    </message>
    <message>
        <source>the machine's axes do not reach, or the tool would lie down</source>
        <translation>die Achsen der Maschine reichen nicht, oder das Werkzeug läge</translation>
    </message>
    <message>
        <source>the machine's axes do not reach: turn the part or take another machine</source>
        <translation>die Achsen der Maschine reichen nicht: das Teil drehen oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>the mesh does not fit into memory</source>
        <translation>das Netz passt nicht in den Speicher</translation>
    </message>
    <message>
        <source>the mesh has {1} facets</source>
        <translation>das Netz hat {1} Facetten</translation>
    </message>
    <message>
        <source>the mesh has {1} facets, more than {2}</source>
        <translation>das Netz hat {1} Facetten, mehr als {2}</translation>
    </message>
    <message>
        <source>the mesh is not closed: a line enters it and does not leave</source>
        <translation>das Netz ist nicht geschlossen: eine Gerade tritt ein und nicht aus</translation>
    </message>
    <message>
        <source>the mesh to write has no facet</source>
        <translation>das zu schreibende Netz hat keine Facette</translation>
    </message>
    <message>
        <source>the middle of its bottom at {1}</source>
        <translation>die Mitte seines Bodens bei {1}</translation>
    </message>
    <message>
        <source>the model '{1}' is not in the file</source>
        <translation>das Modell '{1}' ist nicht in der Datei</translation>
    </message>
    <message>
        <source>the model cannot be read without the extension '{1}'</source>
        <translation>das Modell ist ohne die Erweiterung '{1}' nicht lesbar</translation>
    </message>
    <message>
        <source>the model's files have different units</source>
        <translation>die Dateien des Modells haben verschiedene Einheiten</translation>
    </message>
    <message>
        <source>the model's unit is '{1}'</source>
        <translation>die Einheit des Modells ist '{1}'</translation>
    </message>
    <message>
        <source>the name '{1}' occurs twice</source>
        <translation>der Name '{1}' kommt zweimal vor</translation>
    </message>
    <message>
        <source>the name is empty</source>
        <translation>der Name ist leer</translation>
    </message>
    <message>
        <source>the name occurs twice</source>
        <translation>der Name kommt zweimal vor</translation>
    </message>
    <message>
        <source>the node's place leaves nothing of an object</source>
        <translation>die Lage des Knotens lässt von einem Objekt nichts übrig</translation>
    </message>
    <message>
        <source>the number is not from {1} to {2}</source>
        <translation>die Zahl ist nicht von {1} bis {2}</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>die Zahl ist zu groß</translation>
    </message>
    <message>
        <source>the number {1} is too large</source>
        <translation>die Zahl {1} ist zu groß</translation>
    </message>
    <message>
        <source>the numbers from {1} to {2}</source>
        <translation>die Zahlen von {1} bis {2}</translation>
    </message>
    <message>
        <source>the object has too many keys</source>
        <translation>das Objekt hat zu viele Schlüssel</translation>
    </message>
    <message>
        <source>the object {1} occurs twice</source>
        <translation>das Objekt {1} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the object's mesh is a coarse stand-in for its slices</source>
        <translation>das Netz des Objekts ist ein grober Ersatz für seine Schichten</translation>
    </message>
    <message>
        <source>the offset of {1} is larger than the part, which is {2} by {3}</source>
        <translation>der Versatz von {1} ist größer als das Teil von {2} mal {3}</translation>
    </message>
    <message>
        <source>the one that begins at ({1}, {2}, {3}) mm would take more than {4} points of passes</source>
        <translation>der bei ({1}, {2}, {3}) mm beginnt, bräuchte mehr als {4} Punkte von Bahnen</translation>
    </message>
    <message>
        <source>the operation has no preview of layers</source>
        <translation>die Operation hat keine Vorschau der Ebenen</translation>
    </message>
    <message>
        <source>the operation has no rework regions</source>
        <translation>die Operation hat keine Nacharbeitsbereiche</translation>
    </message>
    <message>
        <source>the operation tilts the tool as it goes and keeps no axis</source>
        <translation>die Operation neigt das Werkzeug unterwegs und behält keine Achse</translation>
    </message>
    <message>
        <source>the operations before leave nothing of it</source>
        <translation>die Operationen davor lassen nichts davon</translation>
    </message>
    <message>
        <source>the operations before leave {1}</source>
        <translation>die Operationen davor lassen {1}</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>das Teil</translation>
    </message>
    <message>
        <source>the part asks for more than {1} places of this tool on a layer</source>
        <translation>das Teil verlangt mehr als {1} Stellen dieses Werkzeugs auf einer Ebene</translation>
    </message>
    <message>
        <source>the part close to the contact point stands in the cutter's way: use a smaller tool there</source>
        <translation>das Teil nahe am Berührpunkt ist dem Fräser im Weg: dort ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the part elsewhere stands in the cutter's way: use a smaller or longer tool there, or wider limits</source>
        <translation>das Teil an anderer Stelle ist dem Fräser im Weg: dort ein kleineres oder längeres Werkzeug nehmen, oder weitere Grenzen</translation>
    </message>
    <message>
        <source>the part has no extent along the turning axis</source>
        <translation>das Teil hat längs der Drehachse keine Ausdehnung</translation>
    </message>
    <message>
        <source>the part has no extent seen along the tool axis</source>
        <translation>das Teil hat, längs der Werkzeugachse gesehen, keine Ausdehnung</translation>
    </message>
    <message>
        <source>the part has no facets</source>
        <translation>das Teil hat keine Facetten</translation>
    </message>
    <message>
        <source>the part has {1} facets: passes are previewed up to {2}</source>
        <translation>das Teil hat {1} Facetten: eine Vorschau gibt es bis {2}</translation>
    </message>
    <message>
        <source>the part is in the cutter's way by every axis; use a smaller or longer tool, or turn the part</source>
        <translation>das Teil ist dem Fräser bei jeder Achse im Weg; ein kleineres oder längeres Werkzeug nehmen oder das Teil drehen</translation>
    </message>
    <message>
        <source>the part is larger along {1}</source>
        <translation>das Teil ist entlang {1} größer</translation>
    </message>
    <message>
        <source>the part is not there</source>
        <translation>das Teil ist nicht da</translation>
    </message>
    <message>
        <source>the part reaches {1} above the stock</source>
        <translation>das Teil ragt {1} über das Rohteil</translation>
    </message>
    <message>
        <source>the part to place has no size</source>
        <translation>das zu legende Teil hat keine Größe</translation>
    </message>
    <message>
        <source>the part's middle lies {1} off the turning axis: it turns unbalanced, and its stock needs a diameter of {2} about the axis</source>
        <translation>die Mitte des Teils liegt {1} neben der Drehachse: es dreht sich mit Unwucht, und sein Rohteil braucht einen Durchmesser von {2} um die Achse</translation>
    </message>
    <message>
        <source>the part's origin</source>
        <translation>der Ursprung des Teils</translation>
    </message>
    <message>
        <source>the part's {1}, {2}, {3}</source>
        <translation>Teil {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the passes end where the cutter would go below the bottom of the stock, by up to {1}: {2} of the points are left out unless 'Below the bottom' allows them</source>
        <translation>die Bahnen enden, wo der Fräser unter den Boden des Rohteils ginge, um bis zu {1}: {2} der Punkte fallen weg, wenn 'Unter dem Boden' sie nicht erlaubt</translation>
    </message>
    <message>
        <source>the passes leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller step-over or another direction</source>
        <translation>die Bahnen lassen mehr als erwartet: {1} bleiben um bis zu {2} stehen, am meisten bei {3}: einen kleineren Bahnabstand oder eine andere Richtung wählen</translation>
    </message>
    <message>
        <source>the passes leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller tolerance or step-over</source>
        <translation>die Bahnen lassen mehr als erwartet: {1} bleiben um bis zu {2} stehen, am meisten bei {3}: eine kleinere Toleranz oder einen kleineren Bahnabstand wählen</translation>
    </message>
    <message>
        <source>the passes{1} lie too far apart there</source>
        <translation>die Bahnen{1} liegen dort zu weit auseinander</translation>
    </message>
    <message>
        <source>the path asks for more than {1} places of this tool</source>
        <translation>der Weg verlangt mehr als {1} Stellen dieses Werkzeugs</translation>
    </message>
    <message>
        <source>the path of a turning part knows no axis</source>
        <translation>der Weg eines drehenden Teils kennt keine Achse</translation>
    </message>
    <message>
        <source>the path would run from {1} to {2} along the axis</source>
        <translation>der Weg liefe entlang der Achse von {1} bis {2}</translation>
    </message>
    <message>
        <source>the picture could not be encoded</source>
        <translation>das Bild konnte nicht kodiert werden</translation>
    </message>
    <message>
        <source>the picture ends before its last row</source>
        <translation>das Bild endet vor seiner letzten Zeile</translation>
    </message>
    <message>
        <source>the picture has {1}</source>
        <translation>das Bild hat {1}</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel</source>
        <translation>das Bild hat {1} Bit je Pixel</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, as floats</source>
        <translation>das Bild hat {1} Bit je Pixel, als Fließkomma</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, which are no plain numbers</source>
        <translation>das Bild hat {1} Bit je Pixel, die keine einfachen Zahlen sind</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, with a sign</source>
        <translation>das Bild hat {1} Bit je Pixel, mit Vorzeichen</translation>
    </message>
    <message>
        <source>the picture has {1}, more than 100 million in all or 100 000 a side</source>
        <translation>das Bild hat {1}, mehr als 100 Millionen insgesamt oder 100 000 je Seite</translation>
    </message>
    <message>
        <source>the picture is interlaced and has {1} × {2} pixels</source>
        <translation>das Bild ist interlaced und hat {1} × {2} Pixel</translation>
    </message>
    <message>
        <source>the picture is not plain grey and has {1} × {2} pixels</source>
        <translation>das Bild ist kein einfaches Grau und hat {1} × {2} Pixel</translation>
    </message>
    <message>
        <source>the picture's colours cannot be read: {1}</source>
        <translation>die Farben des Bildes können nicht gelesen werden: {1}</translation>
    </message>
    <message>
        <source>the picture's tiles of {1} × {2} pixels are too large</source>
        <translation>die Kacheln des Bildes von {1} × {2} Pixeln sind zu groß</translation>
    </message>
    <message>
        <source>the place of the part is no number</source>
        <translation>der Ort des Teils ist keine Zahl</translation>
    </message>
    <message>
        <source>the point {1}, {2}, {3}</source>
        <translation>den Punkt {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the position {1} is not a finite number</source>
        <translation>der Punkt {1} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not free and not used: {2}</source>
        <translation>die für {1} festgehaltene Stellung ist nicht frei und wird nicht verwendet: {2}</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not used: another one is kept for the same contact point</source>
        <translation>die für {1} festgehaltene Stellung wird nicht verwendet: eine andere ist für denselben Berührpunkt festgehalten</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not used: no pass comes there</source>
        <translation>die für {1} festgehaltene Stellung wird nicht verwendet: keine Bahn kommt dorthin</translation>
    </message>
    <message>
        <source>the preview found nothing to cut</source>
        <translation>die Vorschau fand nichts zu fräsen</translation>
    </message>
    <message>
        <source>the previous tool is not in the list</source>
        <translation>das vorige Werkzeug steht nicht in der Liste</translation>
    </message>
    <message>
        <source>the previous tool leaves nothing above the tolerance</source>
        <translation>das vorige Werkzeug lässt nichts über der Toleranz</translation>
    </message>
    <message>
        <source>the profile has too many pieces</source>
        <translation>das Profil hat zu viele Stücke</translation>
    </message>
    <message>
        <source>the program has no end</source>
        <translation>das Programm hat kein Ende</translation>
    </message>
    <message>
        <source>the program has no motion</source>
        <translation>das Programm hat keine Bewegung</translation>
    </message>
    <message>
        <source>the program number {1} is not from 1 to {2}</source>
        <translation>die Programmnummer {1} ist nicht von 1 bis {2}</translation>
    </message>
    <message>
        <source>the program that reads such files, {1}, is not here</source>
        <translation>das Programm, das solche Dateien liest, {1}, ist nicht da</translation>
    </message>
    <message>
        <source>the program that works on studies, facetmill-cli, is not here</source>
        <translation>das Programm, das an Studien arbeitet, facetmill-cli, ist nicht da</translation>
    </message>
    <message>
        <source>the program that wrote it is wrong: export the part by another one</source>
        <translation>das Programm, das sie geschrieben hat, macht es falsch: das Teil mit einem anderen exportieren</translation>
    </message>
    <message>
        <source>the project as it stands</source>
        <translation>das Projekt, wie es ist</translation>
    </message>
    <message>
        <source>the project has no operations</source>
        <translation>das Projekt hat keine Operationen</translation>
    </message>
    <message>
        <source>the project has no setup</source>
        <translation>das Projekt hat keine Aufspannung</translation>
    </message>
    <message>
        <source>the project has no tool {1}</source>
        <translation>das Projekt hat kein Werkzeug {1}</translation>
    </message>
    <message>
        <source>the project has no tools</source>
        <translation>das Projekt hat keine Werkzeuge</translation>
    </message>
    <message>
        <source>the project has no tools: add one</source>
        <translation>das Projekt hat keine Werkzeuge: eines hinzufügen</translation>
    </message>
    <message>
        <source>the project has several setups</source>
        <translation>das Projekt hat mehrere Aufspannungen</translation>
    </message>
    <message>
        <source>the radius at height {1} is too large</source>
        <translation>der Radius in Höhe {1} ist zu groß</translation>
    </message>
    <message>
        <source>the radius has no word</source>
        <translation>der Radius hat kein Wort</translation>
    </message>
    <message>
        <source>the record has {1} values</source>
        <translation>der Datensatz hat {1} Werte</translation>
    </message>
    <message>
        <source>the rework tool is not known</source>
        <translation>das Nacharbeitswerkzeug ist nicht bekannt</translation>
    </message>
    <message>
        <source>the rotary axes are parallel: together they turn no further than one of them</source>
        <translation>die Drehachsen sind parallel: zusammen drehen sie nicht weiter als eine</translation>
    </message>
    <message>
        <source>the rotary axes do not stand where the tilted plane is held</source>
        <translation>die Drehachsen stehen nicht, wo die geschwenkte Ebene gehalten wird</translation>
    </message>
    <message>
        <source>the same as {1}</source>
        <translation>dasselbe wie {1}</translation>
    </message>
    <message>
        <source>the scan would have to move by {1} to fit</source>
        <translation>der Scan müsste sich um {1} bewegen, um zu passen</translation>
    </message>
    <message>
        <source>the section T of an IGES file</source>
        <translation>der Abschnitt T einer IGES-Datei</translation>
    </message>
    <message>
        <source>the sections do not stand at equal distances</source>
        <translation>die Schnitte stehen nicht in gleichen Abständen</translation>
    </message>
    <message>
        <source>the setup's name '{1}' occurs twice</source>
        <translation>der Name der Aufspannung '{1}' kommt zweimal vor</translation>
    </message>
    <message>
        <source>the shank is not carried</source>
        <translation>der Schaft wird nicht übernommen</translation>
    </message>
    <message>
        <source>the shank would hit the part</source>
        <translation>der Schaft träfe das Teil</translation>
    </message>
    <message>
        <source>the shank would hit the part: use a longer or thinner tool</source>
        <translation>der Schaft träfe das Teil: ein längeres oder dünneres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the shape has no ':'</source>
        <translation>der Form fehlt ':'</translation>
    </message>
    <message>
        <source>the shape needs {1} number</source>
        <translation>die Form braucht {1} Zahl</translation>
    </message>
    <message>
        <source>the shape needs {1} numbers</source>
        <translation>die Form braucht {1} Zahlen</translation>
    </message>
    <message>
        <source>the side feed asks for more than {1} turns</source>
        <translation>der Seitenvorschub verlangt mehr als {1} Umdrehungen</translation>
    </message>
    <message>
        <source>the side feed of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>der Seitenvorschub von {1} lässt Rillen von {2}; die Toleranz erlaubt {3}</translation>
    </message>
    <message>
        <source>the side feed of {1} leaves places uncut; the tolerance allows {2}</source>
        <translation>der Seitenvorschub von {1} lässt Stellen stehen; die Toleranz erlaubt {2}</translation>
    </message>
    <message>
        <source>the spindle speed is not above 0</source>
        <translation>die Drehzahl ist nicht über 0</translation>
    </message>
    <message>
        <source>the spindle speed is out of range</source>
        <translation>die Drehzahl ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the statement has too many values</source>
        <translation>die Anweisung hat zu viele Werte</translation>
    </message>
    <message>
        <source>the step says no limit for pieces</source>
        <translation>der Schritt nennt keine Grenze für Stücke</translation>
    </message>
    <message>
        <source>the step {1} leaves no facet</source>
        <translation>der Schritt {1} lässt keine Facette</translation>
    </message>
    <message>
        <source>the step-down of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>die Zustellung von {1} lässt Rillen von {2}; die Toleranz erlaubt {3}</translation>
    </message>
    <message>
        <source>the step-over of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>der Bahnabstand von {1} lässt Rillen von {2}; die Toleranz erlaubt {3}</translation>
    </message>
    <message>
        <source>the step-over of {1} leaves places uncut; the tolerance allows {2}</source>
        <translation>der Bahnabstand von {1} lässt Stellen stehen; die Toleranz erlaubt {2}</translation>
    </message>
    <message>
        <source>the stock does not hold the part as it turns: it reaches {1} from the axis, the part {2}: take a stock of at least {3} in diameter</source>
        <translation>das Rohteil enthält das Teil beim Drehen nicht: es reicht {1} von der Achse, das Teil {2}: ein Rohteil von mindestens {3} Durchmesser nehmen</translation>
    </message>
    <message>
        <source>the stock does not reach there</source>
        <translation>das Rohteil reicht nicht dorthin</translation>
    </message>
    <message>
        <source>the stock ends at z = {1}, the part begins at z = {2}</source>
        <translation>das Rohteil endet bei z = {1}, das Teil beginnt bei z = {2}</translation>
    </message>
    <message>
        <source>the stock ends {1} above the part: the allowance of {2} cannot stay everywhere</source>
        <translation>das Rohteil endet {1} über dem Teil: das Aufmaß von {2} kann nicht überall bleiben</translation>
    </message>
    <message>
        <source>the stock has more than {1} GB of rays in {2}</source>
        <translation>das Rohteil hat mehr als {1} GB an Strahlen in {2}</translation>
    </message>
    <message>
        <source>the stock is not there</source>
        <translation>das Rohteil ist nicht da</translation>
    </message>
    <message>
        <source>the stock's {1}, {2}, {3}</source>
        <translation>Rohteil {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the surface offset by vertices lets the cutter up to {1} (upright) into the allowance of {2}, most at {3}: use offset contact</source>
        <translation>die durch Eckpunkte versetzte Fläche lässt den Fräser bis zu {1} (senkrecht) in das Aufmaß von {2}, am meisten bei {3}: Versatz am Berührpunkt verwenden</translation>
    </message>
    <message>
        <source>the surface's arrays do not fit each other</source>
        <translation>die Felder der Fläche passen nicht zueinander</translation>
    </message>
    <message>
        <source>the surfaces of the file lie at most {1} outside and {2} inside the facets that were planned on</source>
        <translation>die Flächen der Datei liegen höchstens {1} außerhalb und {2} innerhalb der Facetten, auf denen geplant wurde</translation>
    </message>
    <message>
        <source>the tab {1}</source>
        <translation>der Steg {1}</translation>
    </message>
    <message>
        <source>the table below the stock</source>
        <translation>der Tisch unter dem Rohteil</translation>
    </message>
    <message>
        <source>the tabs {1}</source>
        <translation>die Stege {1}</translation>
    </message>
    <message>
        <source>the tape ends here, and the program is not at its end</source>
        <translation>der Streifen endet hier, und das Programm ist nicht am Ende</translation>
    </message>
    <message>
        <source>the taper angle is out of range</source>
        <translation>der Flankenwinkel ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the taper angle {1} is out of range</source>
        <translation>der Flankenwinkel {1} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the tessellation tolerances (outward {1}, inward {2}) use up the machining tolerance of {3}</source>
        <translation>die Toleranzen der Vernetzung (außen {1}, innen {2}) verbrauchen die Bearbeitungstoleranz von {3}</translation>
    </message>
    <message>
        <source>the tessellation tolerances are not lengths of 0 or more</source>
        <translation>die Toleranzen der Vernetzung sind keine Längen von 0 oder mehr</translation>
    </message>
    <message>
        <source>the text has more than 60 MB</source>
        <translation>der Text hat mehr als 60 MB</translation>
    </message>
    <message>
        <source>the text holds control or invisible characters: '{1}'</source>
        <translation>der Text enthält Steuer- oder unsichtbare Zeichen: '{1}'</translation>
    </message>
    <message>
        <source>the text is UTF-16 or UTF-32</source>
        <translation>der Text ist UTF-16 oder UTF-32</translation>
    </message>
    <message>
        <source>the text is empty</source>
        <translation>der Text ist leer</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>der Text ist nicht UTF-8</translation>
    </message>
    <message>
        <source>the text is not UTF-8: '{1}'</source>
        <translation>der Text ist nicht UTF-8: '{1}'</translation>
    </message>
    <message>
        <source>the text is too long</source>
        <translation>der Text ist zu lang</translation>
    </message>
    <message>
        <source>the text of a study</source>
        <translation>der Text einer Studie</translation>
    </message>
    <message>
        <source>the text of an ASCII STL file has binary bytes in it</source>
        <translation>im Text einer ASCII-STL-Datei stehen binäre Bytes</translation>
    </message>
    <message>
        <source>the tilt of the tool</source>
        <translation>die Neigung des Werkzeugs</translation>
    </message>
    <message>
        <source>the tip is kept from going below the bottom of the stock, by up to {1} at {2} of the points: so much stays on the surface there unless 'Below the bottom' allows it</source>
        <translation>die Spitze wird daran gehindert, unter den Boden des Rohteils zu gehen, um bis zu {1} an {2} der Punkte: so viel bleibt dort auf der Fläche, wenn 'Unter dem Boden' es nicht erlaubt</translation>
    </message>
    <message>
        <source>the tip is led in a tilted plane</source>
        <translation>die Spitze wird in einer geschwenkten Ebene geführt</translation>
    </message>
    <message>
        <source>the tip is led on an arc</source>
        <translation>die Spitze wird auf einem Bogen geführt</translation>
    </message>
    <message>
        <source>the tip is to be led and the tool's length is not called</source>
        <translation>die Spitze soll geführt werden und die Länge des Werkzeugs ist nicht aufgerufen</translation>
    </message>
    <message>
        <source>the tolerance asks for</source>
        <translation>die Toleranz verlangt</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} drive planes</source>
        <translation>die Toleranz verlangt mehr als {1} Führungsebenen</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} passes</source>
        <translation>die Toleranz verlangt mehr als {1} Bahnen</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} passes side by side</source>
        <translation>die Toleranz verlangt mehr als {1} Bahnen nebeneinander</translation>
    </message>
    <message>
        <source>the tolerance asks for {1} levels</source>
        <translation>die Toleranz verlangt {1} Höhenlinien</translation>
    </message>
    <message>
        <source>the tolerance is not above 0</source>
        <translation>die Toleranz ist nicht über 0</translation>
    </message>
    <message>
        <source>the tool axis has no direction</source>
        <translation>die Werkzeugachse hat keine Richtung</translation>
    </message>
    <message>
        <source>the tool axis has no length</source>
        <translation>die Werkzeugachse hat keine Länge</translation>
    </message>
    <message>
        <source>the tool axis has not length 1</source>
        <translation>die Werkzeugachse hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>the tool axis is not of length 1</source>
        <translation>die Werkzeugachse hat nicht die Länge 1</translation>
    </message>
    <message>
        <source>the tool axis is told as a vector, and nothing leads the tip</source>
        <translation>die Werkzeugachse ist ein Vektor, und nichts führt die Spitze</translation>
    </message>
    <message>
        <source>the tool axis of a 3-axis program is not +Z</source>
        <translation>die Werkzeugachse eines 3-Achs-Programms ist nicht +Z</translation>
    </message>
    <message>
        <source>the tool axis of {1} is zero</source>
        <translation>die Werkzeugachse von {1} ist null</translation>
    </message>
    <message>
        <source>the tool axis turns by half a turn at once</source>
        <translation>die Werkzeugachse dreht sich auf einmal um eine halbe Drehung</translation>
    </message>
    <message>
        <source>the tool can stand nowhere along the {1} strips that tool {2} left</source>
        <translation>das Werkzeug kann nirgends entlang der {1} Streifen stehen, die Werkzeug {2} ließ</translation>
    </message>
    <message>
        <source>the tool comes down and nothing says where an axis stands</source>
        <translation>das Werkzeug kommt herunter, und nichts sagt, wo eine Achse steht</translation>
    </message>
    <message>
        <source>the tool comes down on an arc</source>
        <translation>das Werkzeug kommt auf einem Bogen herunter</translation>
    </message>
    <message>
        <source>the tool goes elsewhere before it goes home</source>
        <translation>das Werkzeug fährt anderswohin, bevor es zur Grundstellung fährt</translation>
    </message>
    <message>
        <source>the tool goes up and aside at the same time</source>
        <translation>das Werkzeug fährt zugleich hoch und zur Seite</translation>
    </message>
    <message>
        <source>the tool has room there, and the machine's axes do not take it in; turn the part or take another machine</source>
        <translation>das Werkzeug hat dort Platz, und die Achsen der Maschine nehmen es nicht auf; das Teil drehen oder eine andere Maschine nehmen</translation>
    </message>
    <message>
        <source>the tool is changed in a tilted plane</source>
        <translation>das Werkzeug wird in einer geschwenkten Ebene gewechselt</translation>
    </message>
    <message>
        <source>the tool is changed where it stands, and not up</source>
        <translation>das Werkzeug wird gewechselt, wo es steht, und nicht oben</translation>
    </message>
    <message>
        <source>the tool is led by its tip from a place that is not known</source>
        <translation>das Werkzeug wird an der Spitze von einem unbekannten Ort aus geführt</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out and {2} of the surface stays uncut by up to {3}, most at {4}: {5} would reach it{6}</source>
        <translation>das Werkzeug ist kurz: Schaft oder Halter kämen ins Teil, daher bleiben {1} der Bahnen aus und {2} der Fläche um bis zu {3} stehen, am meisten bei {4}: {5} würden hinreichen{6}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out: a tool that is {2} longer would reach it{3}</source>
        <translation>das Werkzeug ist kurz: Schaft oder Halter kämen ins Teil, deshalb werden {1} der Bahnen ausgelassen: ein um {2} längeres Werkzeug käme hin{3}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out: {2} would reach it{3}</source>
        <translation>das Werkzeug ist kurz: Schaft oder Halter kämen ins Teil, daher bleiben {1} der Bahnen aus: {2} würden hinreichen{3}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come nearer to the part than the allowance, so over {1} of the ground the cutter stays above where it could be, by up to {2}, most at {3}: use a longer tool</source>
        <translation>das Werkzeug ist kurz: Schaft oder Halter kämen dem Teil näher als das Aufmaß, deshalb bleibt der Fräser über {1} des Grundes höher, als er sein könnte, um bis zu {2}, am meisten bei {3}: ein längeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the tool is so small against the part that its rest cannot be looked for in {1} places</source>
        <translation>das Werkzeug ist gegenüber dem Teil so klein, dass sein Rest nicht an {1} Stellen gesucht werden kann</translation>
    </message>
    <message>
        <source>the tool is too large for hollows of the part: over {1} of it, seen {2}, up to {3} stays above the allowance, most at {4}: rough again there with a smaller tool</source>
        <translation>das Werkzeug ist zu groß für Mulden des Teils: über {1} davon, {2} gesehen, bleibt bis zu {3} über dem Aufmaß, am meisten bei {4}: dort mit einem kleineren Werkzeug nochmals schruppen</translation>
    </message>
    <message>
        <source>the tool keeps the axis ({1}, {2}, {3}), {4}° from upright.</source>
        <translation>das Werkzeug behält die Achse ({1}, {2}, {3}), {4}° von der Senkrechten.</translation>
    </message>
    <message>
        <source>the tool leaves nothing that is thicker than that</source>
        <translation>das Werkzeug lässt nichts, was dicker ist als das</translation>
    </message>
    <message>
        <source>the tool moves aside, and nothing says how high it is</source>
        <translation>das Werkzeug fährt zur Seite, und nichts sagt, wie hoch es ist</translation>
    </message>
    <message>
        <source>the tool moves in a tilted plane, and its length is not called</source>
        <translation>das Werkzeug bewegt sich in einer geschwenkten Ebene, und seine Länge ist nicht aufgerufen</translation>
    </message>
    <message>
        <source>the tool number {1} occurs twice</source>
        <translation>die Werkzeugnummer {1} kommt zweimal vor</translation>
    </message>
    <message>
        <source>the tool takes away nowhere more than {1} of what stands on the {2} strips</source>
        <translation>das Werkzeug nimmt nirgends mehr als {1} von dem weg, was auf den {2} Streifen steht</translation>
    </message>
    <message>
        <source>the tool that cut before is not known</source>
        <translation>das Werkzeug, das vorher fräste, ist nicht bekannt</translation>
    </message>
    <message>
        <source>the tool's {1} would touch the part wherever there is something to cut</source>
        <translation>des Werkzeugs {1} würde das Teil berühren, wo immer etwas zu fräsen ist</translation>
    </message>
    <message>
        <source>the tool{1} fits but does not go there</source>
        <translation>das Werkzeug{1} passt, geht aber nicht dorthin</translation>
    </message>
    <message>
        <source>the tool{1} fits, but a tab is to stay there</source>
        <translation>das Werkzeug{1} passt, aber dort soll ein Steg stehen bleiben</translation>
    </message>
    <message>
        <source>the tool{1} fits, but its boundary leaves the place out</source>
        <translation>das Werkzeug{1} passt, aber seine Begrenzung lässt die Stelle aus</translation>
    </message>
    <message>
        <source>the tool{1} fits, but its shank or holder would touch stock that stands</source>
        <translation>das Werkzeug{1} passt, aber Schaft oder Halter würden stehendes Rohmaterial berühren</translation>
    </message>
    <message>
        <source>the tool{1} fits, but would come too near to a fixture</source>
        <translation>das Werkzeug{1} passt, käme aber einem Spannmittel zu nahe</translation>
    </message>
    <message>
        <source>the tool{1} fits, but would go below the bottom of the stock</source>
        <translation>das Werkzeug{1} passt, ginge aber unter den Boden des Rohteils</translation>
    </message>
    <message>
        <source>the transform {1} is not twelve numbers</source>
        <translation>die Transformation {1} besteht nicht aus zwölf Zahlen</translation>
    </message>
    <message>
        <source>the transform {1} leaves nothing of an object</source>
        <translation>die Transformation {1} lässt nichts von einem Objekt</translation>
    </message>
    <message>
        <source>the turning axis passes {1} beside the part</source>
        <translation>die Drehachse läuft {1} neben dem Teil vorbei</translation>
    </message>
    <message>
        <source>the two points of the turning axis are the same</source>
        <translation>die zwei Punkte der Drehachse sind derselbe</translation>
    </message>
    <message>
        <source>the value has the wrong type</source>
        <translation>der Wert hat die falsche Art</translation>
    </message>
    <message>
        <source>the value is not a finite number</source>
        <translation>der Wert ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>the value is not a whole number</source>
        <translation>der Wert ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the value is {1}</source>
        <translation>der Wert ist {1}</translation>
    </message>
    <message>
        <source>the value {1} is out of range</source>
        <translation>der Wert {1} ist außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>the value {1} is too large</source>
        <translation>der Wert {1} ist zu groß</translation>
    </message>
    <message>
        <source>the vector has no words</source>
        <translation>der Vektor hat keine Wörter</translation>
    </message>
    <message>
        <source>the verification</source>
        <translation>die Prüfung</translation>
    </message>
    <message>
        <source>the version is negative</source>
        <translation>die Version ist negativ</translation>
    </message>
    <message>
        <source>the version is not a whole number</source>
        <translation>die Version ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>the version of the project file is missing</source>
        <translation>die Version der Projektdatei fehlt</translation>
    </message>
    <message>
        <source>the version, 1</source>
        <translation>die Version, 1</translation>
    </message>
    <message>
        <source>the vertex number</source>
        <translation>die Nummer des Eckpunkts</translation>
    </message>
    <message>
        <source>the vertices have no x, y and z</source>
        <translation>die Eckpunkte haben kein x, y und z</translation>
    </message>
    <message>
        <source>the view direction has no length or runs along the machining direction</source>
        <translation>die Blickrichtung hat keine Länge oder verläuft in der Bearbeitungsrichtung</translation>
    </message>
    <message>
        <source>the whole part is smaller than {1} mm</source>
        <translation>das ganze Teil ist kleiner als {1} mm</translation>
    </message>
    <message>
        <source>the word endsolid is missing and the mesh has {1} open edges</source>
        <translation>das Wort endsolid fehlt, und das Netz hat {1} offene Kanten</translation>
    </message>
    <message>
        <source>the word {1} is not read: it changes the path</source>
        <translation>das Wort {1} wird nicht gelesen: es ändert den Weg</translation>
    </message>
    <message>
        <source>the work coordinate system is {1}, and the part stands in {2}</source>
        <translation>das Werkstückkoordinatensystem ist {1}, und das Teil steht in {2}</translation>
    </message>
    <message>
        <source>the work coordinate system is {1}, and the project names none</source>
        <translation>das Werkstückkoordinatensystem ist {1}, und das Projekt nennt keines</translation>
    </message>
    <message>
        <source>the {1} has no file</source>
        <translation>keine Datei angegeben: {1}</translation>
    </message>
    <message>
        <source>the {1} is not a finite number</source>
        <translation>keine endliche Zahl: {1}</translation>
    </message>
    <message>
        <source>the {1} would touch the part along {2} of passes, which are left out: use a longer tool</source>
        <translation>{1} würde das Teil entlang {2} der Bahnen berühren, die wegfallen: ein längeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>the {1} would touch the part along {2} of passes, which are left out: use a longer tool, or allow it to be inclined by a tilt limit</source>
        <translation>{1} würde das Teil entlang {2} der Bahnen berühren, die wegfallen: ein längeres Werkzeug nehmen oder ihm durch eine Neigungsgrenze erlauben, sich zu neigen</translation>
    </message>
    <message>
        <source>the {1} {2} cannot be written</source>
        <translation>nicht schreibbar: {1} {2}</translation>
    </message>
    <message>
        <source>the {1}'s mesh encloses nothing</source>
        <translation>das Netz ({1}) umschließt nichts</translation>
    </message>
    <message>
        <source>the {1}'s mesh is not closed: {2} open edges, {3} of more than two facets, {4} between facets that face apart</source>
        <translation>das Netz ({1}) ist nicht geschlossen: {2} offene Kanten, {3} mit mehr als zwei Facetten, {4} zwischen Facetten, die auseinander zeigen</translation>
    </message>
    <message>
        <source>their plane goes through the middle of the part: there is no side to lie on</source>
        <translation>ihre Ebene geht durch die Mitte des Teils: es gibt keine Seite zum Auflegen</translation>
    </message>
    <message>
        <source>then by {1}° about {2}</source>
        <translation>dann um {1}° um {2}</translation>
    </message>
    <message>
        <source>then moved by {1}</source>
        <translation>dann verschoben um {1}</translation>
    </message>
    <message>
        <source>there are more than 10^15 combinations</source>
        <translation>es gibt mehr als 10^15 Kombinationen</translation>
    </message>
    <message>
        <source>there are more than two rotary axes</source>
        <translation>es gibt mehr als zwei Drehachsen</translation>
    </message>
    <message>
        <source>there are no values, or two kinds of them</source>
        <translation>es gibt keine Werte oder zwei Arten davon</translation>
    </message>
    <message>
        <source>there are statements after FINI</source>
        <translation>nach FINI stehen Anweisungen</translation>
    </message>
    <message>
        <source>there are too many brackets</source>
        <translation>es sind zu viele Klammern</translation>
    </message>
    <message>
        <source>there are too many lines</source>
        <translation>es sind zu viele Zeilen</translation>
    </message>
    <message>
        <source>there are two axes {1}</source>
        <translation>es gibt zwei Achsen {1}</translation>
    </message>
    <message>
        <source>there are: {1}</source>
        <translation>es gibt: {1}</translation>
    </message>
    <message>
        <source>there is motion after END</source>
        <translation>nach END stehen Bewegungen</translation>
    </message>
    <message>
        <source>there is no '='</source>
        <translation>es fehlt '='</translation>
    </message>
    <message>
        <source>there is no '{1}'; there are {2}</source>
        <translation>es gibt kein '{1}'; es gibt {2}</translation>
    </message>
    <message>
        <source>there is no CUTTER statement</source>
        <translation>es gibt keine CUTTER-Anweisung</translation>
    </message>
    <message>
        <source>there is no boundary '{1}'</source>
        <translation>es gibt keine Begrenzung '{1}'</translation>
    </message>
    <message>
        <source>there is no buffer {1}</source>
        <translation>es gibt keinen Puffer {1}</translation>
    </message>
    <message>
        <source>there is no contact point {1}: the operation has {2}</source>
        <translation>es gibt keinen Berührpunkt {1}: die Operation hat {2}</translation>
    </message>
    <message>
        <source>there is no feed</source>
        <translation>es gibt keinen Vorschub</translation>
    </message>
    <message>
        <source>there is no file {1}</source>
        <translation>es gibt keine Datei {1}</translation>
    </message>
    <message>
        <source>there is no key before '='</source>
        <translation>vor '=' steht kein Schlüssel</translation>
    </message>
    <message>
        <source>there is no motion at feed in the file</source>
        <translation>in der Datei ist keine Bewegung im Vorschub</translation>
    </message>
    <message>
        <source>there is no motion that cuts</source>
        <translation>keine Bewegung fräst</translation>
    </message>
    <message>
        <source>there is no number {1}</source>
        <translation>es gibt keine Nummer {1}</translation>
    </message>
    <message>
        <source>there is no object '{1}'</source>
        <translation>es gibt kein Objekt '{1}'</translation>
    </message>
    <message>
        <source>there is no operation '{1}'</source>
        <translation>es gibt keine Operation '{1}'</translation>
    </message>
    <message>
        <source>there is no operation in it</source>
        <translation>darin ist keine Operation</translation>
    </message>
    <message>
        <source>there is no operation name before the key</source>
        <translation>vor dem Schlüssel steht kein Name einer Operation</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>es gibt kein Bild zu schreiben</translation>
    </message>
    <message>
        <source>there is no point behind a bracket</source>
        <translation>hinter einer Klammer steht kein Punkt</translation>
    </message>
    <message>
        <source>there is no program</source>
        <translation>es gibt kein Programm</translation>
    </message>
    <message>
        <source>there is no program {1}</source>
        <translation>es gibt kein Programm {1}</translation>
    </message>
    <message>
        <source>there is no result</source>
        <translation>es gibt kein Ergebnis</translation>
    </message>
    <message>
        <source>there is no room for the tool to enter</source>
        <translation>das Werkzeug hat keinen Platz zum Eintauchen</translation>
    </message>
    <message>
        <source>there is no round wall or rim</source>
        <translation>dort ist keine runde Wand und kein Rand</translation>
    </message>
    <message>
        <source>there is no setup '{1}'</source>
        <translation>es gibt keine Aufspannung '{1}'</translation>
    </message>
    <message>
        <source>there is no setup {1}</source>
        <translation>es gibt keine Aufspannung {1}</translation>
    </message>
    <message>
        <source>there is no stock</source>
        <translation>es gibt kein Rohteil</translation>
    </message>
    <message>
        <source>there is no such candidate</source>
        <translation>einen solchen Kandidaten gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such end</source>
        <translation>ein solches Ende gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>eine solche Art gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such plane</source>
        <translation>eine solche Ebene gibt es nicht</translation>
    </message>
    <message>
        <source>there is no such program</source>
        <translation>es gibt kein solches Programm</translation>
    </message>
    <message>
        <source>there is no such program{1}</source>
        <translation>es gibt kein solches Programm{1}</translation>
    </message>
    <message>
        <source>there is no such version</source>
        <translation>eine solche Version gibt es nicht</translation>
    </message>
    <message>
        <source>there is no tool {1}</source>
        <translation>es gibt kein Werkzeug {1}</translation>
    </message>
    <message>
        <source>there is no value to try</source>
        <translation>es gibt keinen Wert, der zu versuchen wäre</translation>
    </message>
    <message>
        <source>there is no verdict in them</source>
        <translation>darin ist kein Prüfergebnis</translation>
    </message>
    <message>
        <source>there is no word {{1}}</source>
        <translation>es gibt kein Wort {{1}}</translation>
    </message>
    <message>
        <source>there is no {1}</source>
        <translation>{1} gibt es nicht</translation>
    </message>
    <message>
        <source>there is no {1} '{2}'</source>
        <translation>es gibt kein '{2}' ({1})</translation>
    </message>
    <message>
        <source>there is no {1} {2}: the part has {3}</source>
        <translation>{1} {2} gibt es nicht: das Teil hat {3}</translation>
    </message>
    <message>
        <source>there is nothing that this format can carry</source>
        <translation>nichts davon passt in dieses Format</translation>
    </message>
    <message>
        <source>these are too many values</source>
        <translation>das sind zu viele Werte</translation>
    </message>
    <message>
        <source>they are not what was written</source>
        <translation>sie sind nicht, was geschrieben wurde</translation>
    </message>
    <message>
        <source>they lie nearly on a line: no plane goes through them</source>
        <translation>sie liegen fast auf einer Geraden: keine Ebene geht hindurch</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>Verdicken</translation>
    </message>
    <message>
        <source>thicken: how far behind the sheet its back lies; in front of it below 0.</source>
        <translation>Verdicken: wie weit hinter der Fläche ihre Rückseite liegt; unter 0 davor.</translation>
    </message>
    <message>
        <source>this is no code</source>
        <translation>das ist kein Code</translation>
    </message>
    <message>
        <source>this is no code, or it has another meaning</source>
        <translation>das ist kein Code, oder er hat eine andere Bedeutung</translation>
    </message>
    <message>
        <source>this is no extension of a program</source>
        <translation>das ist keine Endung eines Programms</translation>
    </message>
    <message>
        <source>this is no letter</source>
        <translation>das ist kein Buchstabe</translation>
    </message>
    <message>
        <source>this is no other kind of comment</source>
        <translation>das ist keine andere Art von Kommentar</translation>
    </message>
    <message>
        <source>thousands or decimals? export the part again with decimal points</source>
        <translation>Tausender oder Dezimalen? das Teil mit Dezimalpunkten neu exportieren</translation>
    </message>
    <message>
        <source>three axes</source>
        <translation>drei Achsen</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>drei Zahlen</translation>
    </message>
    <message>
        <source>tilt the tool less</source>
        <translation>das Werkzeug weniger neigen</translation>
    </message>
    <message>
        <source>tilted planes are for controls that know the kinematics</source>
        <translation>geschwenkte Ebenen sind für Steuerungen, die die Kinematik kennen</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tip (TCP)</source>
        <translation>Spitze (TCP)</translation>
    </message>
    <message>
        <source>tip (TCP, tilted planes)</source>
        <translation>Spitze (TCP, geschwenkte Ebenen)</translation>
    </message>
    <message>
        <source>together at most 90°</source>
        <translation>zusammen höchstens 90°</translation>
    </message>
    <message>
        <source>too few numbers for one '{1}'</source>
        <translation>zu wenige Zahlen für ein '{1}'</translation>
    </message>
    <message>
        <source>too many numbers for one '{1}'</source>
        <translation>zu viele Zahlen für ein '{1}'</translation>
    </message>
    <message>
        <source>too many words in the header line</source>
        <translation>zu viele Wörter in der Kopfzeile</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>Werkzeugachse</translation>
    </message>
    <message>
        <source>tool {1}</source>
        <translation>Werkzeug {1}</translation>
    </message>
    <message>
        <source>tool {1} cannot enter, leaves {2}</source>
        <translation>Werkzeug {1} kommt nicht hinein, lässt {2}</translation>
    </message>
    <message>
        <source>tool {1} has no ball end</source>
        <translation>Werkzeug {1} hat keinen Kugelkopf</translation>
    </message>
    <message>
        <source>tool {1} is a ball, which matches no curvature by its lead</source>
        <translation>Werkzeug {1} ist eine Kugel, die mit ihrem Anstellwinkel keine Krümmung angleicht</translation>
    </message>
    <message>
        <source>tool {1} is another cutter in {2}</source>
        <translation>Werkzeug {1} ist in {2} ein anderer Fräser</translation>
    </message>
    <message>
        <source>tool {1} is to clean up what it left itself</source>
        <translation>Werkzeug {1} soll säubern, was es selbst ließ</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2}</source>
        <translation>Werkzeug {1} lässt nirgends mehr als {2}</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2} that the operations before have not cut</source>
        <translation>Werkzeug {1} lässt nirgends mehr als {2}, was die Operationen davor nicht gefräst haben</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2} that the operations before have not cut, nor do the operations before</source>
        <translation>Werkzeug {1} lässt nirgends mehr als {2}, was die Operationen davor nicht gefräst haben, diese auch nicht</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2}, nor do the operations before</source>
        <translation>Werkzeug {1} lässt nirgends mehr als {2}, die Operationen davor auch nicht</translation>
    </message>
    <message>
        <source>tool {1} touches both flanks, leaves {2}</source>
        <translation>Werkzeug {1} berührt beide Flanken, lässt {2}</translation>
    </message>
    <message>
        <source>tool {1} would go below the bottom of the stock, leaves {2}</source>
        <translation>Werkzeug {1} käme unter den Boden des Rohteils, lässt {2} stehen</translation>
    </message>
    <message>
        <source>tools keep {1}</source>
        <translation>Werkzeuge halten {1} Abstand</translation>
    </message>
    <message>
        <source>tools there are: {1}</source>
        <translation>vorhandene Werkzeuge: {1}</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>dreieckig</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>nochmals versuchen</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Wenden</translation>
    </message>
    <message>
        <source>turn it in a block of its own</source>
        <translation>sie in einem eigenen Satz drehen</translation>
    </message>
    <message>
        <source>turn the part</source>
        <translation>das Teil drehen</translation>
    </message>
    <message>
        <source>turn the part or choose another axis</source>
        <translation>das Teil drehen oder eine andere Achse wählen</translation>
    </message>
    <message>
        <source>turn the part or choose another tool axis</source>
        <translation>das Teil drehen oder eine andere Werkzeugachse wählen</translation>
    </message>
    <message>
        <source>turned by {1}</source>
        <translation>gedreht um {1}</translation>
    </message>
    <message>
        <source>turned by {1}° about {2}</source>
        <translation>gedreht um {1}° um {2}</translation>
    </message>
    <message>
        <source>turns by half a turn in one motion</source>
        <translation>dreht sich in einer Bewegung um eine halbe Drehung</translation>
    </message>
    <message>
        <source>turns of the spiral</source>
        <translation>Windungen der Spirale</translation>
    </message>
    <message>
        <source>two kinds of motion in one block</source>
        <translation>zwei Arten von Bewegung in einem Satz</translation>
    </message>
    <message>
        <source>two measures are multiplied</source>
        <translation>zwei Maße werden multipliziert</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>zwei Zahlen</translation>
    </message>
    <message>
        <source>two programs would have the name '{1}'</source>
        <translation>zwei Programme hätten den Namen '{1}'</translation>
    </message>
    <message>
        <source>two setups have such an operation: name the setup</source>
        <translation>zwei Aufspannungen haben eine solche Operation: die Aufspannung nennen</translation>
    </message>
    <message>
        <source>two work coordinate systems in '{1}'</source>
        <translation>zwei Werkstückkoordinatensysteme in '{1}'</translation>
    </message>
    <message>
        <source>unexpected end of input</source>
        <translation>unerwartetes Ende</translation>
    </message>
    <message>
        <source>unknown format '{1}'</source>
        <translation>unbekanntes Format '{1}'</translation>
    </message>
    <message>
        <source>unknown header word '{1}'</source>
        <translation>unbekanntes Wort im Kopf '{1}'</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>unknown kind of linking</source>
        <translation>unbekannte Art der Verbindung</translation>
    </message>
    <message>
        <source>unknown kind of parameter</source>
        <translation>unbekannte Art eines Parameters</translation>
    </message>
    <message>
        <source>unknown name '{1}'</source>
        <translation>unbekannter Name '{1}'</translation>
    </message>
    <message>
        <source>unknown number type '{1}'</source>
        <translation>unbekannte Zahlenart '{1}'</translation>
    </message>
    <message>
        <source>unknown operation '{1}'; did you mean '{2}'?</source>
        <translation>unbekannte Operation '{1}'; ist '{2}' gemeint?</translation>
    </message>
    <message>
        <source>unknown operation '{1}'{2}</source>
        <translation>unbekannte Operation '{1}'{2}</translation>
    </message>
    <message>
        <source>unknown shape '{1}'</source>
        <translation>unbekannte Form '{1}'</translation>
    </message>
    <message>
        <source>unknown unit '{1}'</source>
        <translation>unbekannte Einheit '{1}'</translation>
    </message>
    <message>
        <source>unknown value '{1}'</source>
        <translation>unbekannter Wert '{1}'</translation>
    </message>
    <message>
        <source>unknown version '{1}'</source>
        <translation>unbekannte Version '{1}'</translation>
    </message>
    <message>
        <source>unknown view '{1}'</source>
        <translation>unbekannte Ansicht '{1}'</translation>
    </message>
    <message>
        <source>unpack into another folder</source>
        <translation>in einen anderen Ordner entpacken</translation>
    </message>
    <message>
        <source>unpack it by other means, if you trust it</source>
        <translation>anders entpacken, wenn man ihm traut</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>zuerst auspacken</translation>
    </message>
    <message>
        <source>unwound</source>
        <translation>fortlaufend</translation>
    </message>
    <message>
        <source>up to {1} stays above the allowance; the tolerance is {2}</source>
        <translation>bis zu {1} bleibt über dem Aufmaß; die Toleranz ist {2}</translation>
    </message>
    <message>
        <source>update Facetmill</source>
        <translation>Facetmill aktualisieren</translation>
    </message>
    <message>
        <source>use .fmtools, .fctb, .fctl, .fcholder, .json, .tools or .tbl</source>
        <translation>.fmtools, .fctb, .fctl, .fcholder, .json, .tools oder .tbl verwenden</translation>
    </message>
    <message>
        <source>use a coarser mesh, or boxes and cylinders</source>
        <translation>ein gröberes Netz nehmen, oder Quader und Zylinder</translation>
    </message>
    <message>
        <source>use a coarser resolution</source>
        <translation>eine gröbere Auflösung verwenden</translation>
    </message>
    <message>
        <source>use a larger tolerance</source>
        <translation>eine größere Toleranz verwenden</translation>
    </message>
    <message>
        <source>use a longer tool, or allow a larger tilt limit</source>
        <translation>ein längeres Werkzeug nehmen oder eine größere Neigungsgrenze erlauben</translation>
    </message>
    <message>
        <source>use a longer tool, or allow it to be inclined by a tilt limit</source>
        <translation>ein längeres Werkzeug nehmen oder ihm durch eine Neigungsgrenze erlauben, sich zu neigen</translation>
    </message>
    <message>
        <source>use a longer tool, or less holder clearance</source>
        <translation>ein längeres Werkzeug oder weniger Halterabstand nehmen</translation>
    </message>
    <message>
        <source>use a mesh of at most {1} facets</source>
        <translation>ein Netz von höchstens {1} Facetten nehmen</translation>
    </message>
    <message>
        <source>use a mesh of at most {1} million facets</source>
        <translation>ein Netz von höchstens {1} Millionen Facetten nehmen</translation>
    </message>
    <message>
        <source>use a newer Facetmill</source>
        <translation>ein neueres Facetmill verwenden</translation>
    </message>
    <message>
        <source>use a newer Facetmill, or export it anew</source>
        <translation>ein neueres Facetmill verwenden oder neu exportieren</translation>
    </message>
    <message>
        <source>use a number or one of: {1}</source>
        <translation>eine Zahl verwenden oder eines von: {1}</translation>
    </message>
    <message>
        <source>use a smaller mesh</source>
        <translation>ein kleineres Netz nehmen</translation>
    </message>
    <message>
        <source>use a smaller or longer tool</source>
        <translation>ein kleineres oder längeres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>use a smaller tool</source>
        <translation>ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>use a smaller tool there</source>
        <translation>dort ein kleineres Werkzeug nehmen</translation>
    </message>
    <message>
        <source>use a smaller tool, or leave the operation out</source>
        <translation>ein kleineres Werkzeug nehmen oder die Operation weglassen</translation>
    </message>
    <message>
        <source>use a smaller tool: one of {1} does on half of the part</source>
        <translation>ein kleineres Werkzeug nehmen: eines von {1} genügt auf der Hälfte des Teils</translation>
    </message>
    <message>
        <source>use a stock that reaches lower, or allow it by 'Below the bottom'</source>
        <translation>ein Rohteil nehmen, das tiefer reicht, oder es mit 'Unter dem Boden' erlauben</translation>
    </message>
    <message>
        <source>use a tool that is {1} longer{2}</source>
        <translation>ein um {1} längeres Werkzeug nehmen{2}</translation>
    </message>
    <message>
        <source>use at least {1}</source>
        <translation>mindestens {1} verwenden</translation>
    </message>
    <message>
        <source>use at most {1}, half of the narrowest cutter's radius</source>
        <translation>höchstens {1} verwenden, die Hälfte des Radius des schmalsten Fräsers</translation>
    </message>
    <message>
        <source>use ball:D, flat:D, bull:D,r, cone:D,half_angle or apt:d,r,e,f,alpha,beta,h</source>
        <translation>ball:D, flat:D, bull:D,r, cone:D,half_angle oder apt:d,r,e,f,alpha,beta,h verwenden</translation>
    </message>
    <message>
        <source>use concave, convex or complex</source>
        <translation>concave, convex oder complex verwenden</translation>
    </message>
    <message>
        <source>use mm or in</source>
        <translation>mm oder in verwenden</translation>
    </message>
    <message>
        <source>use mm, cm, m, in or ft</source>
        <translation>mm, cm, m, in oder ft verwenden</translation>
    </message>
    <message>
        <source>use one of {1}</source>
        <translation>eines verwenden von {1}</translation>
    </message>
    <message>
        <source>use one of: {1}</source>
        <translation>eines verwenden von: {1}</translation>
    </message>
    <message>
        <source>use small letters and _</source>
        <translation>Kleinbuchstaben und _ verwenden</translation>
    </message>
    <message>
        <source>use the newer program</source>
        <translation>das neuere Programm benutzen</translation>
    </message>
    <message>
        <source>use the same one on all machines, or begin with this one: study run</source>
        <translation>auf allen Rechnern dasselbe benutzen oder mit diesem beginnen: study run</translation>
    </message>
    <message>
        <source>value {1} of {2}, '{3}', is not a number</source>
        <translation>Wert {1} von {2}, '{3}', ist keine Zahl</translation>
    </message>
    <message>
        <source>vary: no combination is possible</source>
        <translation>vary: keine Kombination ist möglich</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>wait for it, or end it</source>
        <translation>darauf warten oder ihn beenden</translation>
    </message>
    <message>
        <source>was asked for a pose that is not finite or has no unit axis</source>
        <translation>wurde nach einer Lage gefragt, die nicht endlich ist oder keine Einheitsachse hat</translation>
    </message>
    <message>
        <source>was asked for a space without a grid</source>
        <translation>wurde nach einem Raum ohne Raster gefragt</translation>
    </message>
    <message>
        <source>was asked for at a point without a normal</source>
        <translation>wurde an einem Punkt ohne Normale verlangt</translation>
    </message>
    <message>
        <source>was made without a tool</source>
        <translation>wurde ohne Werkzeug gemacht</translation>
    </message>
    <message>
        <source>what begins with ( ends with ), what begins with ; with the line</source>
        <translation>was mit ( beginnt, endet mit ), was mit ; beginnt, mit der Zeile</translation>
    </message>
    <message>
        <source>what holds the stock from below</source>
        <translation>was das Rohteil von unten hält</translation>
    </message>
    <message>
        <source>what is as steep as asked for lies below the bottom of the stock</source>
        <translation>was so steil ist wie verlangt, liegt unter dem Boden des Rohteils</translation>
    </message>
    <message>
        <source>what lies between the curves folds over, as at {1}</source>
        <translation>was zwischen den Kurven liegt, faltet sich, etwa bei {1}</translation>
    </message>
    <message>
        <source>what operations before have cut</source>
        <translation>was frühere Operationen abgetragen haben</translation>
    </message>
    <message>
        <source>what setup '{1}' left</source>
        <translation>was Aufspannung '{1}' übrig ließ</translation>
    </message>
    <message>
        <source>what the setup before leaves is not known yet</source>
        <translation>was die vorherige Aufspannung lässt, ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>where the part is said to be in the way it may be {1}, kept off like the part</source>
        <translation>wo es heißt, das Teil sei im Weg, kann es auch anderes sein: {1}, gemieden wie das Teil</translation>
    </message>
    <message>
        <source>widen it or the slope limits, or take a tool that reaches what lies in it</source>
        <translation>sie oder die Neigungsgrenzen weiter machen, oder ein Werkzeug nehmen, das erreicht, was darin liegt</translation>
    </message>
    <message>
        <source>widen it, or take a tool that reaches what lies in it</source>
        <translation>sie erweitern oder ein Werkzeug nehmen, das erreicht, was darin liegt</translation>
    </message>
    <message>
        <source>widen it, take a smaller tool, or keep only the contact within</source>
        <translation>sie erweitern, ein kleineres Werkzeug nehmen oder nur den Berührpunkt darin halten</translation>
    </message>
    <message>
        <source>widen the slope limit, or cut it by levels (waterline)</source>
        <translation>die Neigungsgrenze weiter machen oder mit Höhenlinien fräsen</translation>
    </message>
    <message>
        <source>widen the slope limits, or finish it by parallel passes</source>
        <translation>die Neigungsgrenzen weiter machen oder mit parallelen Bahnen schlichten</translation>
    </message>
    <message>
        <source>with corner radius 0 the centre (e, f) must be the corner ({1}, {2})</source>
        <translation>mit Eckenradius 0 muss die Mitte (e, f) die Ecke ({1}, {2}) sein</translation>
    </message>
    <message>
        <source>with taper angle {1}° the side meets the axis below the height {2}</source>
        <translation>bei Flankenwinkel {1}° trifft die Seite die Achse unter der Höhe {2}</translation>
    </message>
    <message>
        <source>without how it is run ('{1}'): {2}</source>
        <translation>ohne die Schnittdaten ('{1}'): {2}</translation>
    </message>
    <message>
        <source>without its flutes: {1}</source>
        <translation>ohne Schneidenzahl: {1}</translation>
    </message>
    <message>
        <source>words are read as they lie in memory</source>
        <translation>Wörter werden gelesen, wie sie im Speicher liegen</translation>
    </message>
    <message>
        <source>would hold {1} files, more than {2}</source>
        <translation>enthielte {1} Dateien, mehr als {2}</translation>
    </message>
    <message>
        <source>would make the archive hold more than {1} bytes</source>
        <translation>damit enthielte das Archiv mehr als {1} Bytes</translation>
    </message>
    <message>
        <source>would take {1}</source>
        <translation>würde {1} dauern</translation>
    </message>
    <message>
        <source>write "mm" or "in"</source>
        <translation>"mm" oder "in" schreiben</translation>
    </message>
    <message>
        <source>write "planes": ["xy"] and "helix": false</source>
        <translation>"planes": ["xy"] und "helix": false schreiben</translation>
    </message>
    <message>
        <source>write "samples" of at most {1}</source>
        <translation>"samples" von höchstens {1} schreiben</translation>
    </message>
    <message>
        <source>write "study": 1</source>
        <translation>"study": 1 schreiben</translation>
    </message>
    <message>
        <source>write "values", or "from", "to" and "steps"</source>
        <translation>"values" schreiben, oder "from", "to" und "steps"</translation>
    </message>
    <message>
        <source>write '%' first and last alone</source>
        <translation>'%' nur zuerst und zuletzt schreiben</translation>
    </message>
    <message>
        <source>write '{1}.'</source>
        <translation>'{1}.' schreiben</translation>
    </message>
    <message>
        <source>write 1 or -1</source>
        <translation>1 oder -1 schreiben</translation>
    </message>
    <message>
        <source>write 1: the version of the file</source>
        <translation>1 schreiben: die Version der Datei</translation>
    </message>
    <message>
        <source>write ASCII</source>
        <translation>ASCII schreiben</translation>
    </message>
    <message>
        <source>write CUTTER/d,r,e,f,alpha,beta,h</source>
        <translation>CUTTER/d,r,e,f,alpha,beta,h schreiben</translation>
    </message>
    <message>
        <source>write GODLTA/dx,dy,dz or GODLTA/d</source>
        <translation>GODLTA/dx,dy,dz oder GODLTA/d schreiben</translation>
    </message>
    <message>
        <source>write NAME.key=value, as in Finish.tolerance=0.01</source>
        <translation>NAME.schlüssel=wert schreiben, wie Finish.tolerance=0.01</translation>
    </message>
    <message>
        <source>write TLAXIS/i,j,k</source>
        <translation>TLAXIS/i,j,k schreiben</translation>
    </message>
    <message>
        <source>write UNITS/MM or UNITS/INCHES</source>
        <translation>UNITS/MM oder UNITS/INCHES schreiben</translation>
    </message>
    <message>
        <source>write WORD/values</source>
        <translation>WORT/Werte schreiben</translation>
    </message>
    <message>
        <source>write [lowest, highest], or leave it out for no limit</source>
        <translation>[niedrigste, höchste] schreiben, oder weglassen für keine Grenze</translation>
    </message>
    <message>
        <source>write a dot and letters, as .ngc</source>
        <translation>einen Punkt und Buchstaben schreiben, wie .ngc</translation>
    </message>
    <message>
        <source>write a list, "tools" or "orders"</source>
        <translation>eine Liste, "tools" oder "orders" schreiben</translation>
    </message>
    <message>
        <source>write a name without slashes</source>
        <translation>einen Namen ohne Schrägstriche schreiben</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>eine Zahl schreiben</translation>
    </message>
    <message>
        <source>write a number above 0, at most 1</source>
        <translation>eine Zahl über 0, höchstens 1 schreiben</translation>
    </message>
    <message>
        <source>write a number above 0, or leave it out</source>
        <translation>eine Zahl über 0 schreiben oder weglassen</translation>
    </message>
    <message>
        <source>write a number of ordinary size</source>
        <translation>eine Zahl üblicher Größe schreiben</translation>
    </message>
    <message>
        <source>write a number, or ×1.1 for 1.1 times what the project comes to</source>
        <translation>eine Zahl schreiben, oder ×1,1 für das 1,1-Fache dessen, worauf das Projekt kommt</translation>
    </message>
    <message>
        <source>write a place of the project's file, as operations[Finish].tolerance</source>
        <translation>einen Ort der Projektdatei schreiben, wie operations[Finish].tolerance</translation>
    </message>
    <message>
        <source>write a point on the rotation axis</source>
        <translation>einen Punkt auf der Drehachse schreiben</translation>
    </message>
    <message>
        <source>write a straight motion</source>
        <translation>eine gerade Bewegung schreiben</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>eine ganze Zahl schreiben</translation>
    </message>
    <message>
        <source>write a whole number from {1}</source>
        <translation>eine ganze Zahl ab {1} schreiben</translation>
    </message>
    <message>
        <source>write all of its lines</source>
        <translation>alle seine Zeilen schreiben</translation>
    </message>
    <message>
        <source>write at most {1}</source>
        <translation>höchstens {1} schreiben</translation>
    </message>
    <message>
        <source>write both in one line</source>
        <translation>beide in eine Zeile schreiben</translation>
    </message>
    <message>
        <source>write decimal numbers</source>
        <translation>Dezimalzahlen schreiben</translation>
    </message>
    <message>
        <source>write decimal numbers; formulas and variables are not read</source>
        <translation>Dezimalzahlen schreiben; Formeln und Variablen werden nicht gelesen</translation>
    </message>
    <message>
        <source>write how many times the project's</source>
        <translation>schreiben, das Wievielfache des Projekts</translation>
    </message>
    <message>
        <source>write how many values there are</source>
        <translation>schreiben, wie viele Werte es gibt</translation>
    </message>
    <message>
        <source>write it</source>
        <translation>es schreiben</translation>
    </message>
    <message>
        <source>write it as G1, G43.4 or TRAORI</source>
        <translation>wie G1, G43.4 oder TRAORI schreiben</translation>
    </message>
    <message>
        <source>write it as G54</source>
        <translation>wie G54 schreiben</translation>
    </message>
    <message>
        <source>write it on one line without them</source>
        <translation>ihn ohne sie in einer Zeile schreiben</translation>
    </message>
    <message>
        <source>write it once</source>
        <translation>es einmal schreiben</translation>
    </message>
    <message>
        <source>write it with the dot: .ngc</source>
        <translation>mit dem Punkt schreiben: .ngc</translation>
    </message>
    <message>
        <source>write its place behind it</source>
        <translation>ihren Ort dahinter schreiben</translation>
    </message>
    <message>
        <source>write letters with decimal numbers</source>
        <translation>Buchstaben mit Dezimalzahlen schreiben</translation>
    </message>
    <message>
        <source>write letters, or letters and digits that end with '='</source>
        <translation>Buchstaben schreiben, oder Buchstaben und Ziffern, die mit '=' enden</translation>
    </message>
    <message>
        <source>write lf or crlf</source>
        <translation>lf oder crlf schreiben</translation>
    </message>
    <message>
        <source>write numbers and ranges in ascending order, as 0-57, 60</source>
        <translation>Nummern und Bereiche aufsteigend schreiben, wie 0-57, 60</translation>
    </message>
    <message>
        <source>write one ( and one )</source>
        <translation>eine ( und eine ) schreiben</translation>
    </message>
    <message>
        <source>write one letter, or nothing</source>
        <translation>einen Buchstaben schreiben oder nichts</translation>
    </message>
    <message>
        <source>write one of them</source>
        <translation>eines davon schreiben</translation>
    </message>
    <message>
        <source>write one of: {1}</source>
        <translation>eines davon schreiben: {1}</translation>
    </message>
    <message>
        <source>write one program for each operation: "programs": "each"</source>
        <translation>je Operation ein Programm schreiben: "programs": "each"</translation>
    </message>
    <message>
        <source>write out those that are meant</source>
        <translation>die gemeinten ausschreiben</translation>
    </message>
    <message>
        <source>write setups[NAME]. before it; setups there are: {1}</source>
        <translation>setups[NAME]. davor schreiben; Aufspannungen gibt es: {1}</translation>
    </message>
    <message>
        <source>write smooth or flat</source>
        <translation>glatt oder flach schreiben</translation>
    </message>
    <message>
        <source>write some of: {1}</source>
        <translation>einige davon schreiben: {1}</translation>
    </message>
    <message>
        <source>write straight motions</source>
        <translation>gerade Bewegungen schreiben</translation>
    </message>
    <message>
        <source>write the direction of the rotation axis, as [1, 0, 0]</source>
        <translation>die Richtung der Drehachse schreiben, wie [1, 0, 0]</translation>
    </message>
    <message>
        <source>write the letters: { "x": "X", ... }</source>
        <translation>die Buchstaben schreiben: { "x": "X", ... }</translation>
    </message>
    <message>
        <source>write the lines</source>
        <translation>die Zeilen schreiben</translation>
    </message>
    <message>
        <source>write the lower limit first</source>
        <translation>die untere Grenze zuerst schreiben</translation>
    </message>
    <message>
        <source>write the orders of operations out, with the setup in the path</source>
        <translation>die Reihenfolgen der Operationen ausschreiben, mit der Aufspannung im Pfad</translation>
    </message>
    <message>
        <source>write the other one of ( and ;, or leave it out</source>
        <translation>das andere von ( und ; schreiben oder weglassen</translation>
    </message>
    <message>
        <source>write the part in pieces</source>
        <translation>das Teil in Stücken schreiben</translation>
    </message>
    <message>
        <source>write the place in the project that varies, as "operations[Finish].tolerance"</source>
        <translation>den Ort im Projekt schreiben, der variiert, wie "operations[Finish].tolerance"</translation>
    </message>
    <message>
        <source>write the tool's number before it</source>
        <translation>davor die Nummer des Werkzeugs schreiben</translation>
    </message>
    <message>
        <source>write to another file or folder</source>
        <translation>in eine andere Datei oder einen anderen Ordner schreiben</translation>
    </message>
    <message>
        <source>write what the codes mean: { "G0": "rapid", ... }</source>
        <translation>schreiben, was die Codes bedeuten: { "G0": "rapid", ... }</translation>
    </message>
    <message>
        <source>write where the middle of the part's bottom stands</source>
        <translation>schreiben, wo die Mitte des Bodens des Teils steht</translation>
    </message>
    <message>
        <source>write where the values end</source>
        <translation>schreiben, wo die Werte enden</translation>
    </message>
    <message>
        <source>write {1}</source>
        <translation>{1} schreiben</translation>
    </message>
    <message>
        <source>write {1} and the tool's number</source>
        <translation>{1} und die Nummer des Werkzeugs schreiben</translation>
    </message>
    <message>
        <source>write {1} at the start</source>
        <translation>{1} an den Anfang schreiben</translation>
    </message>
    <message>
        <source>write {1} before it</source>
        <translation>{1} davor schreiben</translation>
    </message>
    <message>
        <source>write {1} or more</source>
        <translation>{1} oder mehr schreiben</translation>
    </message>
    <message>
        <source>write {1} or {2}</source>
        <translation>{1} oder {2} schreiben</translation>
    </message>
    <message>
        <source>write {1} or {2} at the start</source>
        <translation>{1} oder {2} an den Anfang schreiben</translation>
    </message>
    <message>
        <source>write {1}/number</source>
        <translation>{1}/Nummer schreiben</translation>
    </message>
    <message>
        <source>write {1}/x,y,z or {2}/x,y,z,i,j,k</source>
        <translation>{1}/x,y,z oder {2}/x,y,z,i,j,k schreiben</translation>
    </message>
    <message>
        <source>write {word}</source>
        <translation>{word} schreiben</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>zero</source>
        <translation>Nullpunkt</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>Zickzack</translation>
    </message>
    <message>
        <source>zigzag cuts neighbouring passes to and fro; oneway all in the same direction.</source>
        <translation>Zickzack fräst benachbarte Bahnen hin und her; einseitig alle in derselben Richtung.</translation>
    </message>
    <message>
        <source>zigzag cuts open passes whichever way is nearer; oneway always with the part on the right of the travel (climb milling).</source>
        <translation>Zickzack fräst offene Bahnen, wie es näher ist; eine Richtung immer mit dem Teil rechts vom Weg (Gleichlauf).</translation>
    </message>
    <message>
        <source>zigzag cuts passes whichever way is nearer; oneway always one way round.</source>
        <translation>Zickzack fräst Bahnen, wie es näher ist; einseitig immer in derselben Richtung herum.</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro, and open levels whichever way is nearer; oneway always in the same direction, levels with the part on the right of the travel (climb milling).</source>
        <translation>Zickzack fräst hin und her, offene Höhenlinien, wie es näher ist; eine Richtung immer gleich herum, Höhenlinien mit dem Teil rechts vom Weg (Gleichlauf).</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro; oneway always cuts in the direction of travel and returns above the part.</source>
        <translation>Zickzack fräst hin und her; einseitig fräst immer in Fahrtrichtung und kehrt über dem Teil zurück.</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro; oneway always cuts in the direction of travel and returns above what stands.</source>
        <translation>Zickzack fräst hin und her; einseitig fräst immer in Fahrtrichtung und kehrt über dem zurück, was steht.</translation>
    </message>
    <message>
        <source>zigzag cuts whichever way is nearer; oneway always in the same direction and returns above the part.</source>
        <translation>Zickzack fräst, wie es näher ist; einseitig fräst immer in derselben Richtung und kehrt über dem Teil zurück.</translation>
    </message>
    <message>
        <source>{1} % of</source>
        <translation>{1} % von</translation>
    </message>
    <message>
        <source>{1} % of the strips stays uncut by up to {2}, as at {3}</source>
        <translation>{1} % der Streifen bleiben um bis zu {2} stehen, etwa bei {3}</translation>
    </message>
    <message>
        <source>{1} % of the strips stays uncut{2}, as at {3}</source>
        <translation>{1} % der Streifen bleiben stehen{2}, etwa bei {3}</translation>
    </message>
    <message>
        <source>{1} % of {2}</source>
        <translation>{1} % von {2}</translation>
    </message>
    <message>
        <source>{1} (line {2})</source>
        <translation>{1} (Zeile {2})</translation>
    </message>
    <message>
        <source>{1} ({2} of {3})</source>
        <translation>{1} ({2} von {3})</translation>
    </message>
    <message>
        <source>{1} and a rest, and they do not look like facets</source>
        <translation>{1} und ein Rest, und sie sehen nicht wie Facetten aus</translation>
    </message>
    <message>
        <source>{1} and the file ends there</source>
        <translation>{1} und dort endet die Datei</translation>
    </message>
    <message>
        <source>{1} and {2} more</source>
        <translation>{1} und {2} weitere</translation>
    </message>
    <message>
        <source>{1} and {2} to avoid</source>
        <translation>{1} und {2}, zu meiden</translation>
    </message>
    <message>
        <source>{1} arcs</source>
        <translation>{1} Bögen</translation>
    </message>
    <message>
        <source>{1} are switched off and not cut</source>
        <translation>{1} sind ausgeschaltet und werden nicht gefräst</translation>
    </message>
    <message>
        <source>{1} by {2} ({3})</source>
        <translation>{1} durch {2} ({3})</translation>
    </message>
    <message>
        <source>{1} cannot turn about {2}</source>
        <translation>{1} kann nicht um {2} drehen</translation>
    </message>
    <message>
        <source>{1} changes of tools, not in the time.</source>
        <translation>{1} Werkzeugwechsel, nicht in der Zeit enthalten.</translation>
    </message>
    <message>
        <source>{1} collisions, the deepest {2}</source>
        <translation>{1} Kollisionen, die tiefste {2}</translation>
    </message>
    <message>
        <source>{1} combinations are too many</source>
        <translation>{1} Kombinationen sind zu viele</translation>
    </message>
    <message>
        <source>{1} contact point was left by operations before</source>
        <translation>{1} Berührpunkt ließen vorherige Operationen</translation>
    </message>
    <message>
        <source>{1} contact points were left by operations before</source>
        <translation>{1} Berührpunkte ließen vorherige Operationen</translation>
    </message>
    <message>
        <source>{1} crashed at it (signal {2})</source>
        <translation>{1} stürzte daran ab (Signal {2})</translation>
    </message>
    <message>
        <source>{1} days</source>
        <translation>{1} Tage</translation>
    </message>
    <message>
        <source>{1} does not hold {2} of {3} motions as planned: {4}</source>
        <translation>{1} hält {2} von {3} Bewegungen nicht ein, wie sie geplant sind: {4}</translation>
    </message>
    <message>
        <source>{1} ends {2} too early</source>
        <translation>{1} endet {2} zu früh</translation>
    </message>
    <message>
        <source>{1} expected</source>
        <translation>{1} erwartet</translation>
    </message>
    <message>
        <source>{1} expected, found '{2}'</source>
        <translation>{1} erwartet, gefunden: '{2}'</translation>
    </message>
    <message>
        <source>{1} facets are to be avoided, more than {2}</source>
        <translation>{1} Facetten sind zu meiden, mehr als {2}</translation>
    </message>
    <message>
        <source>{1} facets are too many for connectivity</source>
        <translation>{1} Facetten sind zu viele für die Nachbarschaften</translation>
    </message>
    <message>
        <source>{1} facets are wound inward and were judged from the side that is outside.</source>
        <translation>{1} Facetten sind nach innen gewunden und wurden von der äußeren Seite beurteilt.</translation>
    </message>
    <message>
        <source>{1} failed at it (status {2})</source>
        <translation>{1} scheiterte daran (Status {2})</translation>
    </message>
    <message>
        <source>{1} files cannot be read</source>
        <translation>{1}-Dateien können nicht gelesen werden</translation>
    </message>
    <message>
        <source>{1} h {2} min</source>
        <translation>{1} h {2} min</translation>
    </message>
    <message>
        <source>{1} handed over something else</source>
        <translation>{1} übergab etwas anderes</translation>
    </message>
    <message>
        <source>{1} has no table that turns the part about this axis: choose a lathe-mill, or turn the part into its axis</source>
        <translation>{1} hat keinen Tisch, der das Teil um diese Achse dreht: eine Dreh-Fräsmaschine wählen oder das Teil in ihre Achse drehen</translation>
    </message>
    <message>
        <source>{1} has said nothing for {2} s and was stopped</source>
        <translation>{1} sagte {2} s lang nichts und wurde angehalten</translation>
    </message>
    <message>
        <source>{1} has {2} values</source>
        <translation>{1} hat {2} Werte</translation>
    </message>
    <message>
        <source>{1} inclines the tool, and {2} has no rotary axis</source>
        <translation>{1} neigt das Werkzeug, und {2} hat keine Drehachse</translation>
    </message>
    <message>
        <source>{1} is as long as the stock, in which nothing is seen then</source>
        <translation>{1} ist so lang wie das Rohteil, in dem dann nichts zu sehen ist</translation>
    </message>
    <message>
        <source>{1} is missing at its end</source>
        <translation>am Ende fehlt {1}</translation>
    </message>
    <message>
        <source>{1} is no number</source>
        <translation>{1} ist keine Zahl</translation>
    </message>
    <message>
        <source>{1} is no sign</source>
        <translation>{1} ist kein Vorzeichen</translation>
    </message>
    <message>
        <source>{1} is no whole number</source>
        <translation>{1} ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>{1} is not a finite number</source>
        <translation>{1} ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>{1} is not above 0, or too large</source>
        <translation>{1} ist nicht über 0 oder zu groß</translation>
    </message>
    <message>
        <source>{1} is not carried</source>
        <translation>{1} wird nicht übernommen</translation>
    </message>
    <message>
        <source>{1} is not carried: offsets have the tool's number</source>
        <translation>{1} wird nicht übernommen: Korrekturen haben die Nummer des Werkzeugs</translation>
    </message>
    <message>
        <source>{1} is switched off and not cut</source>
        <translation>{1} ist ausgeschaltet und wird nicht gefräst</translation>
    </message>
    <message>
        <source>{1} is {2}, at most {3} is allowed</source>
        <translation>{1} ist {2}, höchstens {3} ist erlaubt</translation>
    </message>
    <message>
        <source>{1} is {2}, not a whole number</source>
        <translation>{1} ist {2}, keine ganze Zahl</translation>
    </message>
    <message>
        <source>{1} jobs of Slurm ended without a result</source>
        <translation>{1} Aufträge von Slurm endeten ohne Ergebnis</translation>
    </message>
    <message>
        <source>{1} lines per turn leave cusps of {2}; the tolerance allows {3}</source>
        <translation>{1} Linien je Umdrehung lassen Rillen von {2}; die Toleranz erlaubt {3}</translation>
    </message>
    <message>
        <source>{1} lines per turn leave places uncut; the tolerance allows {2}</source>
        <translation>{1} Linien je Umdrehung lassen Stellen stehen; die Toleranz erlaubt {2}</translation>
    </message>
    <message>
        <source>{1} makes {2} rays through the stock, more than {3}</source>
        <translation>{1} ergibt {2} Strahlen durch das Rohteil, mehr als {3}</translation>
    </message>
    <message>
        <source>{1} makes {2} turns in one block, and {3} are the most</source>
        <translation>{1} macht {2} Umdrehungen in einem Satz, und {3} sind das Höchste</translation>
    </message>
    <message>
        <source>{1} min</source>
        <translation>{1} min</translation>
    </message>
    <message>
        <source>{1} min {2} s</source>
        <translation>{1} min {2} s</translation>
    </message>
    <message>
        <source>{1} mm</source>
        <translation>{1} mm</translation>
    </message>
    <message>
        <source>{1} model</source>
        <translation>{1}-Modell</translation>
    </message>
    <message>
        <source>{1} more collisions are in verify.json.</source>
        <translation>{1} weitere Kollisionen stehen in verify.json.</translation>
    </message>
    <message>
        <source>{1} more regions</source>
        <translation>{1} weitere Bereiche</translation>
    </message>
    <message>
        <source>{1} more than {2} drive planes</source>
        <translation>{1} mehr als {2} Führungsebenen</translation>
    </message>
    <message>
        <source>{1} names no tool</source>
        <translation>{1} nennt kein Werkzeug</translation>
    </message>
    <message>
        <source>{1} needs about {2} GB for the stock, more than {3} GB</source>
        <translation>{1} braucht etwa {2} GB für das Rohteil, mehr als {3} GB</translation>
    </message>
    <message>
        <source>{1} of the curve lies off the part, as at {2}, and is not followed</source>
        <translation>{1} der Kurve liegen außerhalb des Teils, etwa bei {2}, und ihnen wird nicht gefolgt</translation>
    </message>
    <message>
        <source>{1} of the part's area faces no tool axis of the programs (walls, undersides): there only gouges count.</source>
        <translation>{1} der Fläche des Teils zeigen zu keiner Werkzeugachse der Programme (Wände, Unterseiten): dort zählen nur Verletzungen.</translation>
    </message>
    <message>
        <source>{1} of the part's area is hidden from all tool axes by other parts of it: there only gouges count.</source>
        <translation>{1} der Fläche des Teils sind allen Werkzeugachsen durch andere Stellen verdeckt: dort zählen nur Verletzungen.</translation>
    </message>
    <message>
        <source>{1} of the part's coordinates</source>
        <translation>{1} der Koordinaten des Teils</translation>
    </message>
    <message>
        <source>{1} of the surface</source>
        <translation>{1} der Fläche</translation>
    </message>
    <message>
        <source>{1} of the surface ({2}) around {3} turns under so far that only leads above the lead limits reach it, and is not cut: turn the part over and cut it in another setup, or raise the upper lead limit for the whole part</source>
        <translation>{1} der Fläche ({2}) um {3} weichen so weit zurück, dass nur Anstellwinkel über den Grenzen sie erreichen, und werden nicht gefräst: das Teil wenden und in einer weiteren Aufspannung fräsen, oder die obere Grenze für das ganze Teil erhöhen</translation>
    </message>
    <message>
        <source>{1} of the surface is cleared by neither path{2}</source>
        <translation>{1} der Fläche trägt keiner der Wege ab{2}</translation>
    </message>
    <message>
        <source>{1} of the surface is cleared by neither path{2}: use a smaller rework tool</source>
        <translation>{1} der Fläche trägt keiner der Wege ab{2}: ein kleineres Nacharbeitswerkzeug nehmen</translation>
    </message>
    <message>
        <source>{1} of the surface is less steep than the slope limits and is left to other operations</source>
        <translation>{1} der Oberfläche sind weniger steil als die Neigungsgrenzen und bleiben anderen Operationen</translation>
    </message>
    <message>
        <source>{1} of the surface is steeper than the slope limit and is left to other operations</source>
        <translation>{1} der Oberfläche sind steiler als die Neigungsgrenze und bleiben anderen Operationen</translation>
    </message>
    <message>
        <source>{1} of the surface would only be cut by a tip below the lowest level: allow it by 'Below the bottom', where nothing holds the stock there</source>
        <translation>{1} der Oberfläche würde nur eine Spitze unter der tiefsten Höhenlinie fräsen: mit 'Unter dem Boden' zulassen, wo dort nichts das Rohteil hält</translation>
    </message>
    <message>
        <source>{1} of what is to be cut is left uncut, up to {2} ({3}), limit {4}</source>
        <translation>{1} des zu Fräsenden bleiben stehen, bis zu {2} ({3}), Grenze {4}</translation>
    </message>
    <message>
        <source>{1} of {2} contact points have no free posture and are left to clean-up; mostly {3}</source>
        <translation>{1} von {2} Berührpunkten haben keine freie Stellung und bleiben der Restbearbeitung; meistens: {3}</translation>
    </message>
    <message>
        <source>{1} of {2} drive planes cross places so steep that no step-over meets the tolerance: cusps of {3} stay there, {4} are allowed</source>
        <translation>{1} von {2} Führungsebenen kreuzen so steile Stellen, dass kein Bahnabstand die Toleranz einhält: dort bleiben Rillen von {3}, erlaubt sind {4}</translation>
    </message>
    <message>
        <source>{1} of {2} drive planes cross places where no step-over meets the tolerance</source>
        <translation>{1} von {2} Führungsebenen kreuzen Stellen, wo kein Bahnabstand die Toleranz einhält</translation>
    </message>
    <message>
        <source>{1} of {2} passes cross places where no step-over meets the tolerance</source>
        <translation>{1} von {2} Bahnen kreuzen Stellen, wo kein Bahnabstand die Toleranz einhält</translation>
    </message>
    <message>
        <source>{1} operations have too many orders</source>
        <translation>{1} Operationen haben zu viele Reihenfolgen</translation>
    </message>
    <message>
        <source>{1} or {2}</source>
        <translation>{1} oder {2}</translation>
    </message>
    <message>
        <source>{1} pieces of the stock, up to {2} long, come off, the first at {3}.</source>
        <translation>{1} Stücke des Rohteils, bis zu {2} lang, lösen sich, das erste bei {3}.</translation>
    </message>
    <message>
        <source>{1} place is left out that the tool has no room to enter by a ramp or a helix ({2} of cuts), the first at {3}: use a smaller tool, or allow it to plunge</source>
        <translation>{1} Stelle fällt weg, wo das Werkzeug keinen Platz für Rampe oder Wendel hat ({2} an Schnitten), die erste bei {3}: ein kleineres Werkzeug nehmen oder senkrechtes Eintauchen erlauben</translation>
    </message>
    <message>
        <source>{1} places are left out that the tool has no room to enter by a ramp or a helix ({2} of cuts), the first at {3}: use a smaller tool, or allow it to plunge</source>
        <translation>{1} Stellen fallen weg, wo das Werkzeug keinen Platz für Rampe oder Wendel hat ({2} an Schnitten), die erste bei {3}: ein kleineres Werkzeug nehmen oder senkrechtes Eintauchen erlauben</translation>
    </message>
    <message>
        <source>{1} places are left to clean-up because the tool cannot come there from its neighbours without gouging or turning too far</source>
        <translation>{1} Stellen bleiben der Restbearbeitung, weil das Werkzeug von den Nachbarn nicht ohne Verletzung oder zu große Drehung dorthin kommt</translation>
    </message>
    <message>
        <source>{1} program</source>
        <translation>{1} Programm</translation>
    </message>
    <message>
        <source>{1} programs</source>
        <translation>{1} Programme</translation>
    </message>
    <message>
        <source>{1} region</source>
        <translation>{1} Bereich</translation>
    </message>
    <message>
        <source>{1} regions</source>
        <translation>{1} Bereiche</translation>
    </message>
    <message>
        <source>{1} rework</source>
        <translation>{1}, Nacharbeit</translation>
    </message>
    <message>
        <source>{1} setups</source>
        <translation>{1} Aufspannungen</translation>
    </message>
    <message>
        <source>{1} stay uncut: choose a rework tool, or cut them by another operation</source>
        <translation>{1} bleiben stehen: ein Nacharbeitswerkzeug wählen oder sie mit einer anderen Operation fräsen</translation>
    </message>
    <message>
        <source>{1} swings the tool {2} off its path while it cuts</source>
        <translation>{1} schwenkt das Werkzeug beim Fräsen {2} von seinem Weg</translation>
    </message>
    <message>
        <source>{1} tab, {2}</source>
        <translation>Steg, {1}, {2}</translation>
    </message>
    <message>
        <source>{1} that faces up lies under the part itself, as at {2}, and is not cut: turn the part for another operation</source>
        <translation>{1}, nach oben gewandt, liegen unter dem Teil selbst, etwa bei {2}, und werden nicht gefräst: das Teil für eine weitere Operation drehen</translation>
    </message>
    <message>
        <source>{1} to avoid</source>
        <translation>{1} zu meiden</translation>
    </message>
    <message>
        <source>{1} to {2}</source>
        <translation>{1} bis {2}</translation>
    </message>
    <message>
        <source>{1} turns the part about the axis of the tool, which nothing inclines</source>
        <translation>{1} dreht das Teil um die Achse des Werkzeugs, die nichts neigt</translation>
    </message>
    <message>
        <source>{1} turns the tool about its own axis</source>
        <translation>{1} dreht das Werkzeug um seine eigene Achse</translation>
    </message>
    <message>
        <source>{1} values or colours do not fit {2} vertices</source>
        <translation>{1} Werte oder Farben passen nicht zu {2} Eckpunkten</translation>
    </message>
    <message>
        <source>{1} would be in the way of all passes, with the clearance</source>
        <translation>{1}: wäre allen Bahnen im Weg, mit dem Sicherheitsabstand</translation>
    </message>
    <message>
        <source>{1} would be in the way of {2} of the passes, which are left out</source>
        <translation>{1}: wäre {2} der Bahnen im Weg, die wegfallen</translation>
    </message>
    <message>
        <source>{1} would stand at {2}, and its travel is {3} to {4}</source>
        <translation>{1} stünde auf {2}, und der Verfahrweg ist {3} bis {4}</translation>
    </message>
    <message>
        <source>{1} {2} is not possible</source>
        <translation>{1} {2} ist nicht möglich</translation>
    </message>
    <message>
        <source>{1} · no tool yet</source>
        <translation>{1} · noch kein Werkzeug</translation>
    </message>
    <message>
        <source>{1} · tool {2}</source>
        <translation>{1} · Werkzeug {2}</translation>
    </message>
    <message>
        <source>{1} × {2} pixels</source>
        <translation>{1} × {2} Pixel</translation>
    </message>
    <message>
        <source>{1}, GOTO {2}</source>
        <translation>{1}, GOTO {2}</translation>
    </message>
    <message>
        <source>{1}, allowed {2}</source>
        <translation>{1}, erlaubt {2}</translation>
    </message>
    <message>
        <source>{1}, and they do not look like facets</source>
        <translation>{1}, und sie sehen nicht wie Facetten aus</translation>
    </message>
    <message>
        <source>{1}, facet {2}</source>
        <translation>{1}, Facette {2}</translation>
    </message>
    <message>
        <source>{1}, its zero in {2}</source>
        <translation>{1}, Nullpunkt in {2}</translation>
    </message>
    <message>
        <source>{1}, line {2}</source>
        <translation>{1}, Zeile {2}</translation>
    </message>
    <message>
        <source>{1}, operation {2}</source>
        <translation>{1}, Operation {2}</translation>
    </message>
    <message>
        <source>{1}, or raise the lead limit</source>
        <translation>{1}, oder die Grenze des Anstellwinkels erhöhen</translation>
    </message>
    <message>
        <source>{1}, pixel {2}, {3}</source>
        <translation>{1}, Pixel {2}, {3}</translation>
    </message>
    <message>
        <source>{1}, tool {2}</source>
        <translation>{1}, Werkzeug {2}</translation>
    </message>
    <message>
        <source>{1}, vertex {2}</source>
        <translation>{1}, Eckpunkt {2}</translation>
    </message>
    <message>
        <source>{1}, with the tip at ({2}, {3}, {4}) {5}; {6} cannot make {7} of {8} motions</source>
        <translation>{1}, mit der Spitze bei ({2}, {3}, {4}) {5}; {6} kann {7} von {8} Bewegungen nicht ausführen</translation>
    </message>
    <message>
        <source>{1}, {2} to {3} along the axis</source>
        <translation>{1}, {2} bis {3} entlang der Achse</translation>
    </message>
    <message>
        <source>{1}/{2} changes the path</source>
        <translation>{1}/{2} ändert den Weg</translation>
    </message>
    <message>
        <source>{1}: CUTTER</source>
        <translation>{1}: CUTTER</translation>
    </message>
    <message>
        <source>{1}: linking</source>
        <translation>{1}: Verbinden</translation>
    </message>
    <message>
        <source>{1}: main path</source>
        <translation>{1}: Hauptweg</translation>
    </message>
    <message>
        <source>{1}: motion {2}</source>
        <translation>{1}: Bewegung {2}</translation>
    </message>
    <message>
        <source>{1}: program_number</source>
        <translation>{1}: program_number</translation>
    </message>
    <message>
        <source>{1}: rework path</source>
        <translation>{1}: Nacharbeitsweg</translation>
    </message>
    <message>
        <source>{1}: stock left so far</source>
        <translation>{1}: bis hier gelassenes Rohteil</translation>
    </message>
    <message>
        <source>{1}: the feed is that of the tip; where an axis is slower, the control slows down.</source>
        <translation>{1}: der Vorschub ist der der Spitze; wo eine Achse langsamer ist, bremst die Steuerung.</translation>
    </message>
    <message>
        <source>{1}: the tool goes up {2} times so that rotary axes can turn.</source>
        <translation>{1}: das Werkzeug fährt {2}-mal hoch, damit Drehachsen drehen können.</translation>
    </message>
    <message>
        <source>{1}: {2} of passes, {3} of the surface uncut where the cutter could go</source>
        <translation>{1}: {2} der Bahnen, {3} der Fläche bleiben stehen, wo der Fräser hinkönnte</translation>
    </message>
    <message>
        <source>{1}: {2} of passes{3}</source>
        <translation>{1}: {2} der Bahnen{3}</translation>
    </message>
    <message>
        <source>{1}: {2} {3}² ({4} of the surface), where it stays up to {5} away, at {6}: {7}</source>
        <translation>{1}: {2} {3}² ({4} der Fläche), wo es bis zu {5} entfernt bleibt, bei {6}: {7}</translation>
    </message>
    <message>
        <source>{1}; the deepest gouge that the verification lets pass. auto is a twentieth of the tolerance, but at most 0.01 mm (0.0004 in). At most half the tolerance is used.</source>
        <translation>{1}; die tiefste Verletzung, die die Prüfung durchgehen lässt. auto ist ein Zwanzigstel der Toleranz, aber höchstens 0,01 mm (0,0004 in). Höchstens die halbe Toleranz wird verwendet.</translation>
    </message>
    <message>
        <source>{1}the machine cannot incline the tool like this</source>
        <translation>{1}die Maschine kann das Werkzeug nicht so neigen</translation>
    </message>
    <message>
        <source>{1}° asks for {2} postures at every point</source>
        <translation>{1}° verlangt an jedem Punkt {2} Stellungen</translation>
    </message>
    <message>
        <source>{1}° is no usable step between postures</source>
        <translation>{1}° ist kein brauchbarer Schritt zwischen Stellungen</translation>
    </message>
</context>
<context>
    <name>facetmill</name>
    <message>
        <source>   %1 to the next</source>
        <translation>   %1 bis zum nächsten</translation>
    </message>
    <message>
        <source>   %1 to the one before</source>
        <translation>   %1 zum vorherigen</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (%1 bis %2)</translation>
    </message>
    <message>
        <source> (preview)</source>
        <translation> (Vorschau)</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>%1 % of the surface</source>
        <translation>%1 % der Fläche</translation>
    </message>
    <message>
        <source>%1 % of the surface is no steeper than %2°: passes side by side lie far apart there</source>
        <translation>%1 % der Fläche sind nicht steiler als %2°: dort liegen Bahnen nebeneinander weit auseinander</translation>
    </message>
    <message>
        <source>%1 % of the surface is steeper than %2°: levels go round it</source>
        <translation>%1 % der Fläche sind steiler als %2°: Höhenlinien laufen darum</translation>
    </message>
    <message>
        <source>%1 % of the surface is steeper than %2°: levels there leave less, passes side by side cut the rest</source>
        <translation>%1 % der Fläche sind steiler als %2°: Höhenlinien lassen dort weniger, Bahnen nebeneinander fräsen den Rest</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2%3</source>
        <translation>%1 %2%3</translation>
    </message>
    <message>
        <source>%1 %2%3°</source>
        <translation>%1 %2%3°</translation>
    </message>
    <message>
        <source>%1 %2, %3: %4</source>
        <translation>%1 %2, %3: %4</translation>
    </message>
    <message>
        <source>%1 (%)</source>
        <translation>%1 (%)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 (library)</source>
        <translation>%1 (Bibliothek)</translation>
    </message>
    <message>
        <source>%1 (min)</source>
        <translation>%1 (min)</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (fehlt)</translation>
    </message>
    <message>
        <source>%1 About %2 on this computer, as long as the project itself took.</source>
        <translation>%1 Etwa %2 auf diesem Rechner, so lange, wie das Projekt selbst gebraucht hat.</translation>
    </message>
    <message>
        <source>%1 CC points</source>
        <translation>%1 CC-Punkte</translation>
    </message>
    <message>
        <source>%1 GOTO/s</source>
        <translation>%1 GOTO/s</translation>
    </message>
    <message>
        <source>%1 How long that takes is told here once the project is planned and verified.</source>
        <translation>%1 Wie lange das dauert, steht hier, sobald das Projekt geplant und geprüft ist.</translation>
    </message>
    <message>
        <source>%1 It goes on there: scancel ends it.</source>
        <translation>%1 Dort geht es weiter: scancel beendet es.</translation>
    </message>
    <message>
        <source>%1 Its peak load is %2 times the project's: nothing here knows whether machine and tool stand that.</source>
        <translation>%1 Seine Lastspitze ist %2-mal so hoch wie die des Projekts: Ob Maschine und Werkzeug das aushalten, weiß hier nichts.</translation>
    </message>
    <message>
        <source>%1 Looks that are missing: %2.</source>
        <translation>%1 Noch fehlende Blicke: %2.</translation>
    </message>
    <message>
        <source>%1 Lost: %2 (%3).</source>
        <translation>%1 Verloren: %2 (%3).</translation>
    </message>
    <message>
        <source>%1 Still about %2.</source>
        <translation>%1 Noch etwa %2.</translation>
    </message>
    <message>
        <source>%1 across</source>
        <translation>%1 im Durchmesser</translation>
    </message>
    <message>
        <source>%1 added to the project</source>
        <translation>%1 zum Projekt hinzugefügt</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>%1 can be read in two ways</source>
        <translation>%1 lässt sich auf zwei Arten lesen</translation>
    </message>
    <message numerus="yes">
        <source>%1 collisions</source>
        <translation><numerusform>%1 Kollision</numerusform><numerusform>%1 Kollisionen</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 corners</source>
        <translation><numerusform>%1 Ecke</numerusform><numerusform>%1 Ecken</numerusform></translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1 goes after it, with a smaller tool: alone it leaves about %2 % uncut, and %3 % is allowed</source>
        <translation>%1 folgt darauf, mit einem kleineren Werkzeug: allein lässt sie etwa %2 % stehen, erlaubt sind %3 %</translation>
    </message>
    <message>
        <source>%1 goes before it, with %2: the stock stands up to %3 above the part, and the finishing tool comes %4 deep into it</source>
        <translation>%1 geht voraus, mit %2: das Rohteil steht bis zu %3 über dem Teil, und das Schlichtwerkzeug kommt %4 tief hinein</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>noch %1 h</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 is missing. It was looked for in %2.</source>
        <translation>%1 fehlt. Gesucht wurde in %2.</translation>
    </message>
    <message>
        <source>%1 kept as “%2”</source>
        <translation>%1 aufbewahrt als „%2“</translation>
    </message>
    <message numerus="yes">
        <source>%1 layers</source>
        <translation><numerusform>%1 Ebene</numerusform><numerusform>%1 Ebenen</numerusform></translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>%1 lang</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>noch %1 min</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 facets</source>
        <translation><numerusform>%1 von %2 Facetten</numerusform><numerusform>%1 von %2 Facetten</numerusform></translation>
    </message>
    <message>
        <source>%1 of %2 postures free</source>
        <translation>%1 von %2 Stellungen frei</translation>
    </message>
    <message>
        <source>%1 of %2 strips cut</source>
        <translation>%1 von %2 Streifen gefräst</translation>
    </message>
    <message>
        <source>%1 of 3 points. Click the next one; Esc leaves it.</source>
        <translation>%1 von 3 Punkten. Nächsten anklicken; Esc bricht ab.</translation>
    </message>
    <message>
        <source>%1 of what is to be cut is left uncut (allowed %2)</source>
        <translation>%1 des zu Fräsenden bleibt stehen (erlaubt %2)</translation>
    </message>
    <message>
        <source>%1 on %2: rotary axes</source>
        <translation>%1 auf %2: Drehachsen</translation>
    </message>
    <message>
        <source>%1 on the table within an outline of %2, %3 of the surface faces down, %4 high, falls at %5°. Double click: lay the part on it.</source>
        <translation>%1 auf dem Tisch in einem Umriss von %2, %3 der Fläche zeigt nach unten, %4 hoch, kippt bei %5°. Doppelklick: Teil darauf legen.</translation>
    </message>
    <message>
        <source>%1 operations are as they were planned: they were kept with the project.</source>
        <translation>%1 Operationen sind, wie sie geplant waren: sie wurden mit dem Projekt aufbewahrt.</translation>
    </message>
    <message>
        <source>%1 programs (*%2);;All files (*)</source>
        <translation>%1-Programme (*%2);;Alle Dateien (*)</translation>
    </message>
    <message numerus="yes">
        <source>%1 regions</source>
        <translation><numerusform>%1 Bereich</numerusform><numerusform>%1 Bereiche</numerusform></translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>%1 setups as one job</source>
        <translation>%1 Aufspannungen als ein Auftrag</translation>
    </message>
    <message>
        <source>%1 setups as one job, as posted, %2 blocks</source>
        <translation>%1 Aufspannungen als ein Auftrag, wie ausgegeben, %2 Sätze</translation>
    </message>
    <message numerus="yes">
        <source>%1 smaller ones</source>
        <translation><numerusform>%1 kleineres</numerusform><numerusform>%1 kleinere</numerusform></translation>
    </message>
    <message>
        <source>%1 strips, all of them cut</source>
        <translation>%1 Streifen, alle gefräst</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 nach %2: %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 tools</source>
        <translation><numerusform>%1 Werkzeug</numerusform><numerusform>%1 Werkzeuge</numerusform></translation>
    </message>
    <message>
        <source>%1 was added to the project in place of %2 (switched off). Undo takes it back.</source>
        <translation>%1 wurde dem Projekt anstelle von %2 (ausgeschaltet) hinzugefügt. „Rückgängig“ nimmt es zurück.</translation>
    </message>
    <message>
        <source>%1 was added to the project. Undo takes it away.</source>
        <translation>%1 wurde ins Projekt aufgenommen. Rückgängig nimmt es wieder heraus.</translation>
    </message>
    <message>
        <source>%1 wide, %2 long</source>
        <translation>%1 breit, %2 lang</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 % of the surface</source>
        <translation>%1, %2 % der Fläche</translation>
    </message>
    <message>
        <source>%1, %2 of them passed</source>
        <translation>%1, davon bestanden: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %2 passes</source>
        <translation><numerusform>%1, %2 Bahn</numerusform><numerusform>%1, %2 Bahnen</numerusform></translation>
    </message>
    <message>
        <source>%1, %2: choose at least one value.</source>
        <translation>%1, %2: mindestens einen Wert wählen.</translation>
    </message>
    <message>
        <source>%1, at most %2</source>
        <translation>%1, höchstens %2</translation>
    </message>
    <message>
        <source>%1, or a Facetmill project</source>
        <translation>%1 oder ein Facetmill-Projekt</translation>
    </message>
    <message>
        <source>%1, up to %2</source>
        <translation>%1, bis zu %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 rpm, %3 %4</source>
        <translation>%1: %2 U/min, %3 %4</translation>
    </message>
    <message>
        <source>%1: %2 times what the project comes to</source>
        <translation>%1: %2-mal das, worauf das Projekt kommt</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>%1: a double click goes there</source>
        <translation>%1: Doppelklick wechselt dorthin</translation>
    </message>
    <message>
        <source>%1: a region that operations cut within or keep off</source>
        <translation>%1: ein Bereich, in dem Operationen fräsen oder den sie meiden</translation>
    </message>
    <message>
        <source>%1: lead %2, yaw %3, lift %4</source>
        <translation>%1: Anstellwinkel %2, Taumelwinkel %3, Abhub %4</translation>
    </message>
    <message>
        <source>%1: machine and stock</source>
        <translation>%1: Maschine und Rohteil</translation>
    </message>
    <message>
        <source>%1: no tool comes nearer than %2</source>
        <translation>%1: kein Werkzeug kommt näher als %2</translation>
    </message>
    <message>
        <source>%1: shown, planned and verified now</source>
        <translation>%1: wird jetzt gezeigt, geplant und geprüft</translation>
    </message>
    <message>
        <source>%1: step-over along the part</source>
        <translation>%1: Bahnabstand entlang des Teils</translation>
    </message>
    <message>
        <source>%1; %2 facets, %3.</source>
        <translation>%1; %2 Facetten, %3.</translation>
    </message>
    <message>
        <source>%1° from X</source>
        <translation>%1° von X</translation>
    </message>
    <message>
        <source>%1°: %2 % is steep</source>
        <translation>%1°: %2 % sind steil</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation><numerusform>%n weitere</numerusform><numerusform>%n weitere</numerusform></translation>
    </message>
    <message>
        <source>&amp;About Facetmill</source>
        <translation>&amp;Über Facetmill</translation>
    </message>
    <message>
        <source>&amp;Add to project</source>
        <translation>Zum Projekt hinzu&amp;fügen</translation>
    </message>
    <message>
        <source>&amp;Adopt</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;As the other holes</source>
        <translation>Wie die &amp;anderen Löcher</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>&amp;Vorher</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Durchsuchen…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>&amp;Close program</source>
        <translation>Programm s&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>&amp;Control</source>
        <translation>&amp;Steuerung</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Deviation…</source>
        <translation>&amp;Abweichung…</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>&amp;Export programs…</source>
        <translation>Programme &amp;exportieren…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>&amp;Feeds and speeds</source>
        <translation>&amp;Vorschübe und Drehzahlen</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;First job, step by step</source>
        <translation>Erster &amp;Auftrag, Schritt für Schritt</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>Ein&amp;passen</translation>
    </message>
    <message>
        <source>&amp;Flat</source>
        <translation>&amp;Flach</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Ordner</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Holder, from the shank upward</source>
        <translation>&amp;Halter, vom Schaft aufwärts</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>&amp;Inches</source>
        <translation>&amp;Zoll</translation>
    </message>
    <message>
        <source>&amp;Keep project’s tools</source>
        <translation>Werkzeuge des Projekts auf&amp;bewahren</translation>
    </message>
    <message>
        <source>&amp;Keep unsaved work every</source>
        <translation>&amp;Nicht Gespeichertes sichern alle</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>&amp;Leave open</source>
        <translation>&amp;Offen lassen</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Locate missing file…</source>
        <translation>Fehlende &amp;Datei suchen…</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Maschine</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Handbuch</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Millimetres</source>
        <translation>&amp;Millimeter</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>&amp;New study</source>
        <translation>Ne&amp;ue Studie</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Jetzt nicht</translation>
    </message>
    <message>
        <source>&amp;Open study…</source>
        <translation>Studie ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Part…</source>
        <translation>&amp;Teil…</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planen</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>Fo&amp;rtsetzen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Scan room…</source>
        <translation>S&amp;can-Raum…</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Geglättet</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Starten</translation>
    </message>
    <message>
        <source>&amp;Stock…</source>
        <translation>&amp;Rohteil…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&amp;Tilt from upright</source>
        <translation>&amp;Neigung zur Senkrechten</translation>
    </message>
    <message>
        <source>&amp;Turning</source>
        <translation>D&amp;rehung</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Unpack</source>
        <translation>&amp;Entpacken</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>P&amp;rüfen</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Wire</source>
        <translation>&amp;Drahtmodell</translation>
    </message>
    <message>
        <source>'%1'</source>
        <comment>a name in a message</comment>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>,  .</source>
        <translation>,  .</translation>
    </message>
    <message>
        <source>, %1 deep</source>
        <translation>, %1 tief</translation>
    </message>
    <message>
        <source>, %1 deep; at most %2 would stay above the allowance</source>
        <translation>, %1 tief; höchstens %2 bliebe über dem Aufmaß</translation>
    </message>
    <message>
        <source>, %1 switched off</source>
        <translation>, %1 ausgeschaltet</translation>
    </message>
    <message>
        <source>, GOTO %1</source>
        <translation>, GOTO %1</translation>
    </message>
    <message>
        <source>, facet %1</source>
        <translation>, Facette %1</translation>
    </message>
    <message>
        <source>, holders for the dialog of a tool: %1</source>
        <translation>, Halter für den Werkzeugdialog: %1</translation>
    </message>
    <message>
        <source>, into the fixture '%1'</source>
        <translation>, in das Spannmittel „%1“</translation>
    </message>
    <message>
        <source>, into the part</source>
        <translation>, in das Teil</translation>
    </message>
    <message>
        <source>, lift %1</source>
        <translation>, Abhub %1</translation>
    </message>
    <message>
        <source>. Stick-out: %1; the part needs %2</source>
        <translation>. Auskraglänge: %1; das Teil braucht %2</translation>
    </message>
    <message>
        <source>0 … 6</source>
        <translation>0 … 6</translation>
    </message>
    <message>
        <source>0° is upright, 90° level, 180° from below</source>
        <translation>0° ist senkrecht, 90° waagrecht, 180° von unten</translation>
    </message>
    <message>
        <source>1 strip, cut</source>
        <translation>1 Streifen, gefräst</translation>
    </message>
    <message>
        <source>1 strip, switched off</source>
        <translation>1 Streifen, ausgeschaltet</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between clauses</comment>
        <translation>; </translation>
    </message>
    <message>
        <source>; at most %1 stays above the allowance</source>
        <translation>; höchstens %1 bleibt über dem Aufmaß</translation>
    </message>
    <message>
        <source>; it does not fit in %1 places, which the log has. </source>
        <translation>; an %1 Stellen passt sie nicht, die im Protokoll stehen. </translation>
    </message>
    <message>
        <source>; it does not fit in one place. </source>
        <translation>; an einer Stelle passt sie nicht. </translation>
    </message>
    <message>
        <source>; lowest lift %1, highest %2</source>
        <translation>; kleinster Abhub %1, größter %2</translation>
    </message>
    <message>
        <source>; not carried:</source>
        <translation>; nicht übernommen:</translation>
    </message>
    <message>
        <source>; rework covers %1 of the surface</source>
        <translation>; die Nacharbeit deckt %1 der Fläche ab</translation>
    </message>
    <message>
        <source>; the path is out of date: plan again</source>
        <translation>; der Weg ist veraltet: neu planen</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; holds %2 facets and does not say in which unit. How large is the part?</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; enthält %2 Facetten und sagt nicht, in welcher Einheit. Wie groß ist das Teil?</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is a packed project. It is unpacked into a folder of its own and opened from there; the packed file stays as it is.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; ist ein gepacktes Projekt. Es wird in einen eigenen Ordner entpackt und von dort geöffnet; die gepackte Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Facetmill %1&lt;/h3&gt;&lt;p&gt;Plans tool paths on triangle meshes.&lt;/p&gt;&lt;p&gt;Built with Qt %2, VTK, Eigen, OpenMesh and oneTBB.&lt;br&gt;Licensed under the Apache License 2.0.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Facetmill %1&lt;/h3&gt;&lt;p&gt;Plant Werkzeugwege auf Dreiecksnetzen.&lt;/p&gt;&lt;p&gt;Gebaut mit Qt %2, VTK, Eigen, OpenMesh und oneTBB.&lt;br&gt;Unter der Apache-Lizenz 2.0.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A bar per candidate, as high as its machining time, in a strip for each stage of the study</source>
        <translation>Ein Balken je Kandidat, so hoch wie seine Bearbeitungszeit, in einem Streifen für jede Stufe der Studie</translation>
    </message>
    <message>
        <source>A closed curve has three corners or more: click on the part.</source>
        <translation>Eine geschlossene Kurve hat drei Ecken oder mehr: auf das Teil klicken.</translation>
    </message>
    <message>
        <source>A fast main path with five axes, and a smaller tool for the regions it leaves</source>
        <translation>Ein schneller Hauptweg mit fünf Achsen, und ein kleineres Werkzeug für die Bereiche, die er lässt</translation>
    </message>
    <message>
        <source>A helix, rings or lengthwise lines over a part that turns</source>
        <translation>Eine Wendel, Ringe oder Längslinien über ein drehendes Teil</translation>
    </message>
    <message>
        <source>A line per candidate across an axis for everything that varies and for measures; a drag along an axis keeps a range of it</source>
        <translation>Eine Linie je Kandidat über eine Achse für alles, was sich ändert, und für Maße; Ziehen entlang einer Achse behält einen Bereich</translation>
    </message>
    <message>
        <source>A new study of this project</source>
        <translation>Eine neue Studie dieses Projekts</translation>
    </message>
    <message>
        <source>A number for all sides or three with blanks between them (x, y, z), %1; a semicolon between one value and the next</source>
        <translation>Eine Zahl für alle Seiten oder drei mit Leerzeichen dazwischen (x, y, z), %1; ein Semikolon zwischen einem Wert und dem nächsten</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before programs are written.</source>
        <translation>Ein Parameter ist ungültig: vor dem Schreiben von Programmen berichtigen.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the project is packed.</source>
        <translation>Ein Parameter ist ungültig: vor dem Packen des Projekts berichtigen.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the project is saved.</source>
        <translation>Ein Parameter ist ungültig: vor dem Speichern des Projekts berichtigen.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the setup sheet is written.</source>
        <translation>Ein Parameter ist ungültig: vor dem Schreiben des Einrichteblatts berichtigen.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the unit is changed.</source>
        <translation>Ein Parameter ist ungültig: vor dem Wechsel der Einheit berichtigen.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it, then plan.</source>
        <translation>Ein Parameter ist ungültig: berichtigen, dann planen.</translation>
    </message>
    <message>
        <source>A program from a file, shown in place of the plan.</source>
        <translation>Ein Programm aus einer Datei, gezeigt anstelle des Plans.</translation>
    </message>
    <message>
        <source>A program is shown over its part: open the project or the mesh first, then drop the program.</source>
        <translation>Ein Programm wird über seinem Teil gezeigt: zuerst das Projekt oder das Netz öffnen, dann das Programm hineinziehen.</translation>
    </message>
    <message>
        <source>A setup sheet begins with the verdict of the verification. Press Verify (F6) first.</source>
        <translation>Ein Einrichteblatt beginnt mit dem Ergebnis der Prüfung. Zuerst Prüfen (F6).</translation>
    </message>
    <message>
        <source>A step of its own: goes on as the surface around bends</source>
        <translation>Ein eigener Schritt: setzt die Krümmung der Fläche ringsum fort</translation>
    </message>
    <message>
        <source>A step of its own: it stays open whatever the others say</source>
        <translation>Ein eigener Schritt: es bleibt offen, was immer die anderen sagen</translation>
    </message>
    <message>
        <source>A step of its own: takes the least area</source>
        <translation>Ein eigener Schritt: nimmt am wenigsten Fläche</translation>
    </message>
    <message>
        <source>A study works on the project as it is saved: save it first.</source>
        <translation>Eine Studie arbeitet mit dem Projekt, wie es gespeichert ist: zuerst speichern.</translation>
    </message>
    <message>
        <source>A value is not valid</source>
        <translation>Ein Wert ist ungültig</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>About %1, by a preview of its passes</source>
        <translation>Etwa %1, nach einer Vorschau der Bahnen</translation>
    </message>
    <message>
        <source>About %1; leaves at most %2 on 99 % of the surface, and %3 % of it uncut</source>
        <translation>Etwa %1; lässt auf 99 % der Fläche höchstens %2 und davon %3 % ungefräst</translation>
    </message>
    <message>
        <source>About Facetmill</source>
        <translation>Über Facetmill</translation>
    </message>
    <message>
        <source>Above the view: what comes next, ticked off as it is done</source>
        <translation>Über der Ansicht: was als Nächstes kommt, abgehakt, wenn es getan ist</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add &amp;%1</source>
        <translation>&amp;%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add Rough before it: the stock stands up to %1 above the part, and the tool comes %2 deep into it.</source>
        <translation>Davor Schruppen hinzufügen: das Rohteil steht bis zu %1 über dem Teil, und das Werkzeug kommt %2 tief hinein.</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Werkstoff hinzufügen</translation>
    </message>
    <message>
        <source>Add a section above the others</source>
        <translation>Einen Abschnitt über den anderen hinzufügen</translation>
    </message>
    <message>
        <source>Add a step behind the chosen one</source>
        <translation>Hinter dem gewählten einen Schritt hinzufügen</translation>
    </message>
    <message>
        <source>Add a tool below the tree; a double click edits one.</source>
        <translation>Ein Werkzeug unter dem Baum hinzufügen; Doppelklick bearbeitet eines.</translation>
    </message>
    <message>
        <source>Add an operation below the tree. They run from top to bottom.</source>
        <translation>Eine Operation unter dem Baum hinzufügen. Sie laufen von oben nach unten.</translation>
    </message>
    <message>
        <source>Add an operation, a tool, a fixture, a boundary or a setup</source>
        <translation>Operation, Werkzeug, Spannmittel, Begrenzung oder Aufspannung hinzufügen</translation>
    </message>
    <message>
        <source>Add boundary</source>
        <translation>Begrenzung hinzufügen</translation>
    </message>
    <message>
        <source>Add fixture</source>
        <translation>Spannmittel hinzufügen</translation>
    </message>
    <message>
        <source>Add operation</source>
        <translation>Operation hinzufügen</translation>
    </message>
    <message>
        <source>Add setup</source>
        <translation>Aufspannung hinzufügen</translation>
    </message>
    <message>
        <source>Add this operation to the project; undo takes it away again</source>
        <translation>Diese Operation ins Projekt aufnehmen; Rückgängig nimmt sie wieder heraus</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Werkzeug hinzufügen</translation>
    </message>
    <message>
        <source>Add tools of the library</source>
        <translation>Werkzeuge der Bibliothek hinzufügen</translation>
    </message>
    <message>
        <source>Add tool…</source>
        <translation>Werkzeug hinzufügen…</translation>
    </message>
    <message>
        <source>Adopt candidate %1</source>
        <translation>Kandidat %1 übernehmen</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Af&amp;ter</source>
        <translation>&amp;Nachher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
    <message>
        <source>Against neighbours</source>
        <translation>Gegen Nachbarn</translation>
    </message>
    <message>
        <source>Align edge with X</source>
        <translation>Kante nach X ausrichten</translation>
    </message>
    <message>
        <source>All candidates as a table (CSV)</source>
        <translation>Alle Kandidaten als Tabelle (CSV)</translation>
    </message>
    <message>
        <source>All chapters</source>
        <translation>Alle Kapitel</translation>
    </message>
    <message>
        <source>All facets up to sharp edges, as a boundary for operations</source>
        <translation>Alle Facetten bis zu scharfen Kanten, als Begrenzung für Operationen</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>All motions of all operations</source>
        <translation>Alle Bewegungen aller Operationen</translation>
    </message>
    <message>
        <source>All of it is switched off below the view</source>
        <translation>Alles davon ist unter der Ansicht ausgeschaltet</translation>
    </message>
    <message>
        <source>All operations are switched off: switch one on in its menu.</source>
        <translation>Alle Operationen sind ausgeschaltet: eine in ihrem Menü einschalten.</translation>
    </message>
    <message>
        <source>All others</source>
        <translation>Alle anderen</translation>
    </message>
    <message>
        <source>All setups are planned.</source>
        <translation>Alle Aufspannungen sind geplant.</translation>
    </message>
    <message>
        <source>Alone it does not pass the verification: %1</source>
        <translation>Allein besteht sie die Prüfung nicht: %1</translation>
    </message>
    <message>
        <source>Along the axis (%1)</source>
        <translation>Entlang der Achse (%1)</translation>
    </message>
    <message>
        <source>Alt+1 … Alt+0</source>
        <translation>Alt+1 … Alt+0</translation>
    </message>
    <message>
        <source>An unknown exception ended the job</source>
        <translation>Eine unbekannte Ausnahme beendete die Arbeit</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Winkel (°)</translation>
    </message>
    <message>
        <source>Another boundary has this name</source>
        <translation>Eine andere Begrenzung hat diesen Namen</translation>
    </message>
    <message>
        <source>Another fixture has this name</source>
        <translation>Ein anderes Spannmittel hat diesen Namen</translation>
    </message>
    <message>
        <source>Another operation has this name</source>
        <translation>Eine andere Operation hat diesen Namen</translation>
    </message>
    <message>
        <source>Another setup has this name</source>
        <translation>Eine andere Aufspannung hat diesen Namen</translation>
    </message>
    <message>
        <source>Another setup is shown. A double click in the tree goes to this one.</source>
        <translation>Gezeigt wird eine andere Aufspannung. Ein Doppelklick im Baum wechselt zu dieser.</translation>
    </message>
    <message>
        <source>Appl&amp;y</source>
        <translation>An&amp;wenden</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Apply &amp;template</source>
        <translation>&amp;Vorlage anwenden</translation>
    </message>
    <message>
        <source>Apply template</source>
        <translation>Vorlage anwenden</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Fläche (%1)</translation>
    </message>
    <message>
        <source>Area of the part that lies on the table</source>
        <translation>Fläche des Teils, die auf dem Tisch liegt</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>As the file is</source>
        <translation>Wie die Datei ist</translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 holes are filled.</source>
        <translation><numerusform>Wie die Datei ist, wird %1 von %2 Löchern gefüllt.</numerusform><numerusform>Wie die Datei ist, werden %1 von %2 Löchern gefüllt.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 pieces go.</source>
        <translation><numerusform>Wie die Datei ist, fällt %1 von %2 Stücken weg.</numerusform><numerusform>Wie die Datei ist, fallen %1 von %2 Stücken weg.</numerusform></translation>
    </message>
    <message>
        <source>As the part lies</source>
        <translation>Wie das Teil liegt</translation>
    </message>
    <message>
        <source>As the workbench showed it</source>
        <translation>Wie die Arbeitsumgebung es zeigte</translation>
    </message>
    <message>
        <source>Ask anew, from the project as it is now</source>
        <translation>Neu fragen, ausgehend vom Projekt, wie es jetzt ist</translation>
    </message>
    <message>
        <source>At %1: </source>
        <translation>Bei %1: </translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>An einem Punkt</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>At most: %1</source>
        <translation>Höchstens: %1</translation>
    </message>
    <message>
        <source>At once</source>
        <translation>Gleichzeitig</translation>
    </message>
    <message>
        <source>At which height of the box the zero is</source>
        <translation>In welcher Höhe des Quaders der Nullpunkt liegt</translation>
    </message>
    <message>
        <source>Axes over path</source>
        <translation>Achsen über dem Weg</translation>
    </message>
    <message>
        <source>Axes over time</source>
        <translation>Achsen über der Zeit</translation>
    </message>
    <message>
        <source>A−</source>
        <translation>A−</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Zurück zur Vorgabe</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>Kugelkopf</translation>
    </message>
    <message>
        <source>Before planning: %1. As planned, where the paths were looked at: %2, %3 %</source>
        <translation>Vor dem Planen: %1. Wie geplant, wo die Wege untersucht wurden: %2, %3 %</translation>
    </message>
    <message>
        <source>Being planned</source>
        <translation>Wird geplant</translation>
    </message>
    <message>
        <source>Best first</source>
        <translation>Beste zuerst</translation>
    </message>
    <message>
        <source>Best: the least surface that faces the table, where no tool from above comes to, the most that lies on it, and a firm stand. Largest: the most area on the table.</source>
        <translation>Beste: am wenigsten Fläche zum Tisch hin, an die kein Werkzeug von oben kommt, am meisten, was aufliegt, und sicherer Stand. Größte: am meisten Fläche auf dem Tisch.</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Unten</translation>
    </message>
    <message>
        <source>Boundary of a face</source>
        <translation>Begrenzung aus einer Fläche</translation>
    </message>
    <message>
        <source>Boundary of this face</source>
        <translation>Begrenzung aus dieser Fläche</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Quader</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinsel</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>By Wang's (1) a tool of up to D %1 matches all but 5 % of the hollow places at this limit.</source>
        <translation>Nach Wang (1) passt ein Werkzeug bis D %1 an alle bis auf 5 % der hohlen Stellen bei dieser Grenze.</translation>
    </message>
    <message>
        <source>By a value</source>
        <translation>Um einen Wert</translation>
    </message>
    <message>
        <source>By how much</source>
        <translation>Um wie viel</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>CC</source>
        <translation>CC</translation>
    </message>
    <message>
        <source>CC points</source>
        <translation>CC-Punkte</translation>
    </message>
    <message>
        <source>CL cuts</source>
        <translation>CL-Schnitte</translation>
    </message>
    <message>
        <source>CL points</source>
        <translation>CL-Punkte</translation>
    </message>
    <message>
        <source>CM²</source>
        <translation>CM²</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Wird abgebrochen…</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Kandidat %1</translation>
    </message>
    <message>
        <source>Candidate %1 is the project now. Undo takes it back.</source>
        <translation>Kandidat %1 ist jetzt das Projekt. Rückgängig nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>Candidate %1 is the project now; what was changed since the study began is as it was then. Undo takes it back.</source>
        <translation>Kandidat %1 ist jetzt das Projekt; was seit Beginn der Studie geändert wurde, ist wieder wie damals. Rückgängig nimmt ihn zurück.</translation>
    </message>
    <message>
        <source>Candidate %1 wins: %2 of machining, against %3 of the project as it stands.</source>
        <translation>Kandidat %1 gewinnt: %2 Bearbeitung gegenüber %3 beim Projekt, wie es ist.</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>Candidates by two measures; a line joins those that no other surpasses</source>
        <translation>Kandidaten nach zwei Maßen; eine Linie verbindet die, die kein anderer übertrifft</translation>
    </message>
    <message>
        <source>Candidates that are worked on at once; what comes out does not depend on it</source>
        <translation>Kandidaten, an denen gleichzeitig gearbeitet wird; das Ergebnis hängt nicht davon ab</translation>
    </message>
    <message>
        <source>Candidates: %1 to plan, about %2 to judge coarsely and %3 finely.</source>
        <translation>Kandidaten: %1 zu planen, etwa %2 grob und %3 fein zu prüfen.</translation>
    </message>
    <message>
        <source>Cannot be judged</source>
        <translation>Nicht beurteilbar</translation>
    </message>
    <message>
        <source>Cannot be judged: %1</source>
        <translation>Nicht beurteilbar: %1</translation>
    </message>
    <message>
        <source>Carries the recipe out and shows what it would make; the project stays as it is</source>
        <translation>Führt das Rezept aus und zeigt, was es machte; das Projekt bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Carry the step out earlier</source>
        <translation>Den Schritt früher ausführen</translation>
    </message>
    <message>
        <source>Carry the step out later</source>
        <translation>Den Schritt später ausführen</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Centre part</source>
        <translation>Teil zentrieren</translation>
    </message>
    <message>
        <source>Change kind of boundary</source>
        <translation>Art der Begrenzung ändern</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Einheit wechseln</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramm</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Choose a candidate in a picture or in the table</source>
        <translation>Einen Kandidaten in einem Bild oder in der Tabelle wählen</translation>
    </message>
    <message>
        <source>Choose a candidate in a picture or in the table.</source>
        <translation>Einen Kandidaten in einem Bild oder in der Tabelle wählen.</translation>
    </message>
    <message>
        <source>Choose a folder that is there</source>
        <translation>Einen vorhandenen Ordner wählen</translation>
    </message>
    <message>
        <source>Choose fixture</source>
        <translation>Spannmittel wählen</translation>
    </message>
    <message>
        <source>Choose mesh…</source>
        <translation>Netz wählen…</translation>
    </message>
    <message>
        <source>Choose stock</source>
        <translation>Rohteil wählen</translation>
    </message>
    <message>
        <source>Choose the control in Machine; Ctrl+E writes one program an operation.</source>
        <translation>Unter Maschine die Steuerung wählen; Strg+E schreibt je Operation ein Programm.</translation>
    </message>
    <message>
        <source>Choose the folder in which the new one is made</source>
        <translation>Den Ordner wählen, in dem der neue entsteht</translation>
    </message>
    <message>
        <source>Choose the tool and its values in the form; + adds Rough before Finish.</source>
        <translation>Werkzeug und Werte im Formular wählen; + fügt Schruppen vor Schlichten ein.</translation>
    </message>
    <message>
        <source>Choosing layers</source>
        <translation>Ebenen werden gewählt</translation>
    </message>
    <message>
        <source>Clamp over the edge</source>
        <translation>Spannpratze über die Kante</translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation>Restbearbeitung</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>%1 leeren</translation>
    </message>
    <message>
        <source>Clear painted facets</source>
        <translation>Gemalte Facetten löschen</translation>
    </message>
    <message>
        <source>Clearance moves at rapid speed</source>
        <translation>Bewegungen im Sicherheitsabstand im Eilgang</translation>
    </message>
    <message>
        <source>Click a face of the part: the tool will stand upright on it. Ctrl+click takes the direction that you look along. Esc leaves it.</source>
        <translation>Eine Fläche des Teils anklicken: das Werkzeug steht dann senkrecht darauf. Strg+Klick nimmt die Blickrichtung. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click a flat face of the part: it comes down to Z 0</source>
        <translation>Eine ebene Fläche des Teils anklicken: sie kommt auf Z 0</translation>
    </message>
    <message>
        <source>Click a point of the part for the work zero; a corner nearby is taken exactly. Esc leaves it.</source>
        <translation>Einen Punkt des Teils für den Werkstücknullpunkt anklicken; eine nahe Ecke wird genau genommen. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click a point of the part for the zero; a corner nearby is taken exactly</source>
        <translation>Einen Punkt des Teils für den Nullpunkt anklicken; eine nahe Ecke wird genau genommen</translation>
    </message>
    <message>
        <source>Click a point of the part for “%1”; a corner nearby is taken exactly. Ctrl+click takes the middle of the flat face there. Esc leaves it.</source>
        <translation>Einen Punkt des Teils für „%1“ anklicken; eine nahe Ecke wird genau genommen. Strg+Klick nimmt die Mitte der ebenen Fläche dort. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click beside an edge of the part: the part turns about Z until the edge runs along X</source>
        <translation>Neben eine Kante des Teils klicken: das Teil dreht sich um Z, bis die Kante entlang X läuft</translation>
    </message>
    <message>
        <source>Click into a round hole, on a boss, or beside a hole on its flat face. Esc leaves it.</source>
        <translation>In ein rundes Loch, auf einen Zapfen oder neben ein Loch auf seine ebene Fläche klicken. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click into a round hole, on a boss, or beside a hole on its flat face: the zero comes to its axis, at its upper end</source>
        <translation>In ein rundes Loch, auf einen Zapfen oder neben ein Loch auf seine ebene Fläche klicken: der Nullpunkt kommt auf die Achse, an ihr oberes Ende</translation>
    </message>
    <message>
        <source>Click on a path</source>
        <translation>Auf einen Weg klicken</translation>
    </message>
    <message>
        <source>Click on a strip, here or in the view.</source>
        <translation>Einen Streifen anklicken, hier oder in der Ansicht.</translation>
    </message>
    <message>
        <source>Click on the part beside the edge that is to run along X. Esc leaves it.</source>
        <translation>Auf das Teil neben die Kante klicken, die entlang X laufen soll. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click or drag: the tool goes there. Arrows: along the path. Wheel: zoom. Right drag: move. Double click, Home: all.</source>
        <translation>Klicken oder ziehen: das Werkzeug geht dorthin. Pfeile: am Weg entlang. Rad: Zoom. Rechts ziehen: verschieben. Doppelklick, Pos1: alles.</translation>
    </message>
    <message>
        <source>Click or drag: the tool goes there. Wheel: zoom (Ctrl: the upright axis). Right drag: move.</source>
        <translation>Klicken oder ziehen: das Werkzeug geht dorthin. Rad: Zoom (Strg: senkrechte Achse). Rechts ziehen: verschieben.</translation>
    </message>
    <message>
        <source>Click the flat face that the part is to lie on. Esc leaves it.</source>
        <translation>Die ebene Fläche anklicken, auf der das Teil liegen soll. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click three points of the part, one after the other, that are to be down; a corner nearby is taken exactly. Esc leaves it.</source>
        <translation>Nacheinander drei Punkte des Teils anklicken, die unten sein sollen; eine nahe Ecke wird genau genommen. Esc bricht ab.</translation>
    </message>
    <message>
        <source>Click three points of the part: their plane comes down to Z 0</source>
        <translation>Drei Punkte des Teils anklicken: ihre Ebene kommt auf Z 0</translation>
    </message>
    <message>
        <source>Click two points of the part; corners nearby are taken exactly. Esc ends measuring.</source>
        <translation>Zwei Punkte des Teils anklicken; nahe Ecken werden genau genommen. Esc beendet das Messen.</translation>
    </message>
    <message>
        <source>Click: shown in the view</source>
        <translation>Klick: wird in der Ansicht gezeigt</translation>
    </message>
    <message>
        <source>Click: shown in the view. Double click: laid on it.</source>
        <translation>Klick: wird in der Ansicht gezeigt. Doppelklick: Teil darauf legen.</translation>
    </message>
    <message>
        <source>Click: shown in the view. Right click: how it is filled</source>
        <translation>Klick: wird in der Ansicht gezeigt. Rechtsklick: wie es gefüllt wird</translation>
    </message>
    <message>
        <source>Click: the view goes there. Check mark: whether the strip is cut.</source>
        <translation>Klick: die Ansicht geht dorthin. Häkchen: ob der Streifen gefräst wird.</translation>
    </message>
    <message>
        <source>Clicks on the part add corners; a double click or Enter closes the curve, Backspace takes the last corner back. Corners of a closed one can be dragged. Esc ends it.</source>
        <translation>Klicks auf das Teil fügen Ecken hinzu; Doppelklick oder Eingabe schließt die Kurve, Rücktaste nimmt die letzte Ecke zurück. Ecken einer geschlossenen lassen sich ziehen. Esc beendet.</translation>
    </message>
    <message>
        <source>Closed curve</source>
        <translation>Geschlossene Kurve</translation>
    </message>
    <message>
        <source>Closed curves of open edges; the rim of an open sheet is one of them. A click goes to one.</source>
        <translation>Geschlossene Kurven offener Kanten; der Rand einer offenen Fläche ist eine davon. Ein Klick geht zu einer.</translation>
    </message>
    <message>
        <source>Closes holes up to a diameter; nothing else changes.</source>
        <translation>Schließt Löcher bis zu einem Durchmesser; sonst ändert sich nichts.</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Comparing tools and limits…</source>
        <translation>Werkzeuge und Grenzen werden verglichen…</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Kegel</translation>
    </message>
    <message>
        <source>Cones of the holder are kept clear as the steps above, which stand out of them by up to %1.</source>
        <translation>Kegel des Halters werden als die Stufen oben freigehalten, die bis zu %1 aus ihnen herausstehen.</translation>
    </message>
    <message>
        <source>Configuration space</source>
        <translation>Konfigurationsraum</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Durchdringungen</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Strg+C, Strg+V</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Strg+E</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Shift+Z</source>
        <translation>Strg+Z, Strg+Umschalt+Z</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Cut a model of the stock with all operations and compare it with the part (F6)</source>
        <translation>Ein Modell des Rohteils mit allen Operationen fräsen und mit dem Teil vergleichen (F6)</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>An einer Ebene schneiden</translation>
    </message>
    <message>
        <source>Cut by the rework tool; uncheck to leave it out</source>
        <translation>Vom Nacharbeitswerkzeug gefräst; Häkchen entfernen, um ihn auszulassen</translation>
    </message>
    <message>
        <source>Cut length</source>
        <translation>Schnittlänge</translation>
    </message>
    <message>
        <source>Cut the stock up to this operation, and judge what it is to leave</source>
        <translation>Das Rohteil bis zu dieser Operation fräsen und beurteilen, was sie stehen lassen soll</translation>
    </message>
    <message>
        <source>Cuts the valleys that a larger tool could not enter</source>
        <translation>Fräst die Kehlen, in die ein größeres Werkzeug nicht kam</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fräser</translation>
    </message>
    <message>
        <source>Cutter contacts: the points of the part that are cut</source>
        <translation>Eingriffspunkte (CC): die Punkte des Teils, die gefräst werden</translation>
    </message>
    <message>
        <source>Cutter locations: the path of the tool tip while it cuts</source>
        <translation>Fräserpositionen (CL): der Weg der Werkzeugspitze beim Fräsen</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>Decimate</source>
        <translation>Ausdünnen</translation>
    </message>
    <message>
        <source>Deeper gouges than this have the last red</source>
        <translation>Tiefere Verletzungen als diese haben das letzte Rot</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>Tiefste Verletzung</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Vorgabe: %1</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Depth (%1)</source>
        <translation>Tiefe (%1)</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>Tiefe, %1</translation>
    </message>
    <message>
        <source>Descriptions (*.json);;All files (*)</source>
        <translation>Beschreibungen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>Diameter (%1)</source>
        <translation>Durchmesser (%1)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Distance %1, X %2, Y %3, Z %4; faces at %5°</source>
        <translation>Abstand %1, X %2, Y %3, Z %4; Flächen unter %5°</translation>
    </message>
    <message>
        <source>Distance and angle between two points of the part (M)</source>
        <translation>Abstand und Winkel zwischen zwei Punkten des Teils (M)</translation>
    </message>
    <message>
        <source>Divide</source>
        <translation>Teilung</translation>
    </message>
    <message>
        <source>Divide between steep and shallow</source>
        <translation>Teilung zwischen steil und flach</translation>
    </message>
    <message>
        <source>Divide by slope</source>
        <translation>Nach Neigung teilen</translation>
    </message>
    <message>
        <source>Divides the part by slope: levels round what is steep, passes over the rest</source>
        <translation>Teilt das Teil nach Neigung: Höhenlinien um Steiles, Bahnen über den Rest</translation>
    </message>
    <message>
        <source>Do not ask again for this file</source>
        <translation>Bei dieser Datei nicht mehr fragen</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Done: that was a whole job. F1 tells more.</source>
        <translation>Fertig: das war ein ganzer Auftrag. F1 sagt mehr.</translation>
    </message>
    <message>
        <source>Double click, F</source>
        <translation>Doppelklick, F</translation>
    </message>
    <message>
        <source>Doubled facets</source>
        <translation>Doppelte Facetten</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Nach
unten</translation>
    </message>
    <message>
        <source>Drag a dot on a boundary in the view to move it.</source>
        <translation>Einen Punkt einer Begrenzung in der Ansicht ziehen, um sie zu verschieben.</translation>
    </message>
    <message>
        <source>Drag boundary point</source>
        <translation>Punkt der Begrenzung ziehen</translation>
    </message>
    <message>
        <source>Draw curve</source>
        <translation>Kurve zeichnen</translation>
    </message>
    <message>
        <source>Drawing operations</source>
        <translation>Operationen werden gezeichnet</translation>
    </message>
    <message>
        <source>Drawing regions</source>
        <translation>Bereiche werden gezeichnet</translation>
    </message>
    <message>
        <source>Drawing the path</source>
        <translation>Weg wird gezeichnet</translation>
    </message>
    <message>
        <source>Drawing the strips</source>
        <translation>Streifen werden gezeichnet</translation>
    </message>
    <message>
        <source>Drill point</source>
        <translation>Bohrspitze</translation>
    </message>
    <message>
        <source>Drop edits</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Drop part to Z 0</source>
        <translation>Teil auf Z 0 setzen</translation>
    </message>
    <message>
        <source>Drop region edits</source>
        <translation>Änderungen der Bereiche verwerfen</translation>
    </message>
    <message>
        <source>Drop to Z 0</source>
        <translation>Auf Z 0 setzen</translation>
    </message>
    <message>
        <source>Dropped were %1; there is one part at a time. Drop the part alone: stock and fixtures are chosen in the project.</source>
        <translation>Hineingezogen wurden %1; es gibt ein Teil auf einmal. Nur das Teil hineinziehen: Rohteil und Spannmittel werden im Projekt gewählt.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Duplicate boundary</source>
        <translation>Begrenzung duplizieren</translation>
    </message>
    <message>
        <source>Duplicate fixture</source>
        <translation>Spannmittel duplizieren</translation>
    </message>
    <message>
        <source>Duplicate operation</source>
        <translation>Operation duplizieren</translation>
    </message>
    <message>
        <source>Duplicate setup</source>
        <translation>Aufspannung duplizieren</translation>
    </message>
    <message>
        <source>Duplicate tool</source>
        <translation>Werkzeug duplizieren</translation>
    </message>
    <message>
        <source>Edge along X</source>
        <translation>Kante nach X</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edges along which two facets face opposite sides</source>
        <translation>Kanten, an denen zwei Facetten nach verschiedenen Seiten zeigen</translation>
    </message>
    <message>
        <source>Edges of one facet</source>
        <translation>Kanten einer einzigen Facette</translation>
    </message>
    <message>
        <source>Edges of three facets and more</source>
        <translation>Kanten von drei Facetten und mehr</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>Edit region settings</source>
        <translation>Einstellungen der Bereiche ändern</translation>
    </message>
    <message>
        <source>Edit tool</source>
        <translation>Werkzeug bearbeiten</translation>
    </message>
    <message>
        <source>Edit tool…</source>
        <translation>Werkzeug bearbeiten…</translation>
    </message>
    <message>
        <source>End the run at once; what was found is kept, and Resume goes on</source>
        <translation>Den Lauf sofort beenden; was gefunden ist, bleibt, und Fortsetzen geht weiter</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter in the field does the same</source>
        <translation>Die Eingabetaste im Feld bewirkt dasselbe</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Radieren</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Estimated machining time</source>
        <translation>Geschätzte Bearbeitungszeit</translation>
    </message>
    <message>
        <source>Everything that varies beside what comes of it; drag along an axis to keep a range, click it to let go</source>
        <translation>Alles, was sich ändert, neben dem, was daraus wird; entlang einer Achse ziehen behält einen Bereich, ein Klick auf sie gibt ihn frei</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>Excess of 95 %</source>
        <translation>Überstand von 95 %</translation>
    </message>
    <message>
        <source>Excess of 99 %</source>
        <translation>Überstand von 99 %</translation>
    </message>
    <message>
        <source>Excess, half below</source>
        <translation>Überstand, Hälfte unter</translation>
    </message>
    <message>
        <source>Expected cusp</source>
        <translation>Erwartete Spitzenhöhe</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Trotzdem exportieren</translation>
    </message>
    <message>
        <source>Export configuration space</source>
        <translation>Konfigurationsraum exportieren</translation>
    </message>
    <message>
        <source>Export its program…</source>
        <translation>Ihr Programm exportieren…</translation>
    </message>
    <message>
        <source>Export mes&amp;h</source>
        <translation>Netz ex&amp;portieren</translation>
    </message>
    <message>
        <source>Export p&amp;icture…</source>
        <translation>Bild e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Export postures</source>
        <translation>Stellungen exportieren</translation>
    </message>
    <message>
        <source>Export programs</source>
        <translation>Programme exportieren</translation>
    </message>
    <message>
        <source>Export programs into</source>
        <translation>Programme exportieren nach</translation>
    </message>
    <message>
        <source>Export programs of which only some are verified?</source>
        <translation>Programme exportieren, von denen nur einige geprüft sind?</translation>
    </message>
    <message>
        <source>Export programs that cannot be judged?</source>
        <translation>Programme exportieren, die sich nicht beurteilen lassen?</translation>
    </message>
    <message>
        <source>Export programs that failed?</source>
        <translation>Programme exportieren, die nicht bestanden haben?</translation>
    </message>
    <message>
        <source>Export programs that were verified as they no longer are?</source>
        <translation>Programme exportieren, die seit der Prüfung andere sind?</translation>
    </message>
    <message>
        <source>Export set&amp;up sheet…</source>
        <translation>Einric&amp;hteblatt exportieren…</translation>
    </message>
    <message>
        <source>Export setup sheet</source>
        <translation>Einrichteblatt exportieren</translation>
    </message>
    <message>
        <source>Export ta&amp;ble…</source>
        <translation>Ta&amp;belle exportieren…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Tabelle exportieren</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Das Diagramm exportieren</translation>
    </message>
    <message>
        <source>Export the chart as a picture (PNG)</source>
        <translation>Das Diagramm als Bild exportieren (PNG)</translation>
    </message>
    <message>
        <source>Export the chart's values</source>
        <translation>Die Werte des Diagramms exportieren</translation>
    </message>
    <message>
        <source>Export the configuration space as a picture (PNG)</source>
        <translation>Den Konfigurationsraum als Bild exportieren (PNG)</translation>
    </message>
    <message>
        <source>Export the deviation as a mesh</source>
        <translation>Die Abweichung als Netz exportieren</translation>
    </message>
    <message>
        <source>Export the part as a mesh</source>
        <translation>Das Teil als Netz exportieren</translation>
    </message>
    <message>
        <source>Export the postures as a table (CSV)</source>
        <translation>Die Stellungen als Tabelle exportieren (CSV)</translation>
    </message>
    <message>
        <source>Export the stock as a mesh</source>
        <translation>Das Rohteil als Netz exportieren</translation>
    </message>
    <message>
        <source>Export the unrolled path</source>
        <translation>Den abgewickelten Weg exportieren</translation>
    </message>
    <message>
        <source>Export the unrolled path as a picture (PNG)</source>
        <translation>Den abgewickelten Weg als Bild exportieren (PNG)</translation>
    </message>
    <message>
        <source>Export the values as a table (CSV)</source>
        <translation>Die Werte als Tabelle exportieren (CSV)</translation>
    </message>
    <message>
        <source>Export tools</source>
        <translation>Werkzeuge exportieren</translation>
    </message>
    <message>
        <source>Export unverified programs?</source>
        <translation>Ungeprüfte Programme exportieren?</translation>
    </message>
    <message>
        <source>F1</source>
        <translation>F1</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>F5 plans, F6 verifies. Look at what the list finds before you go on.</source>
        <translation>F5 plant, F6 prüft. Ansehen, was die Liste findet, bevor es weitergeht.</translation>
    </message>
    <message>
        <source>F5, Ctrl+P</source>
        <translation>F5, Strg+P</translation>
    </message>
    <message>
        <source>F6</source>
        <translation>F6</translation>
    </message>
    <message>
        <source>F7 … F10</source>
        <translation>F7 … F10</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces of the file</source>
        <translation>Flächen der Datei</translation>
    </message>
    <message>
        <source>Faces to lie on</source>
        <translation>Flächen zum Auflegen</translation>
    </message>
    <message>
        <source>Facetmill</source>
        <translation>Facetmill</translation>
    </message>
    <message>
        <source>Facetmill (*.fmtools);;Fusion (*.json);;Fusion, packed (*.tools);;FreeCAD (*.fctl);;LinuxCNC (*.tbl)</source>
        <translation>Facetmill (*.fmtools);;Fusion (*.json);;Fusion, gepackt (*.tools);;FreeCAD (*.fctl);;LinuxCNC (*.tbl)</translation>
    </message>
    <message>
        <source>Facetmill ended without saving “%1”.</source>
        <translation>Facetmill endete, ohne „%1“ zu speichern.</translation>
    </message>
    <message>
        <source>Facetmill manual</source>
        <translation>Handbuch von Facetmill</translation>
    </message>
    <message>
        <source>Facetmill projects (*.facetmill)</source>
        <translation>Facetmill-Projekte (*.facetmill)</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facetten</translation>
    </message>
    <message>
        <source>Facets so low that their direction is noise</source>
        <translation>Facetten, so niedrig, dass ihre Richtung Rauschen ist</translation>
    </message>
    <message>
        <source>Facets that are out come in, those that are in go out</source>
        <translation>Facetten außerhalb kommen hinein, die darin kommen heraus</translation>
    </message>
    <message>
        <source>Facets with the corners of another one</source>
        <translation>Facetten mit den Ecken einer anderen</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Failed verification</source>
        <translation>Prüfung nicht bestanden</translation>
    </message>
    <message>
        <source>Failed verification: %1</source>
        <translation>Prüfung nicht bestanden: %1</translation>
    </message>
    <message>
        <source>Failed verification: the part is gouged at more places than are listed, so this operation is not cleared</source>
        <translation>Prüfung nicht bestanden: das Teil wird an mehr Stellen verletzt, als aufgelistet sind; diese Operation ist damit nicht freigegeben</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Fehlgeschlagen: %1</translation>
    </message>
    <message>
        <source>Failed: %1: %2</source>
        <translation>Fehlgeschlagen: %1: %2</translation>
    </message>
    <message>
        <source>Falls at</source>
        <translation>Kippt
bei</translation>
    </message>
    <message>
        <source>Feed and spindle as the operation’s tool has them for a material; of roughing depth and step-over, too</source>
        <translation>Vorschub und Drehzahl, wie das Werkzeug der Operation sie für einen Werkstoff hat; beim Schruppen auch Tiefe und Bahnabstand</translation>
    </message>
    <message>
        <source>Feeds and speeds, row</source>
        <translation>Vorschübe und Drehzahlen, Zeile</translation>
    </message>
    <message>
        <source>Feeds for</source>
        <translation>Vorschübe für</translation>
    </message>
    <message>
        <source>Feeds of the tool</source>
        <translation>Vorschübe des Werkzeugs</translation>
    </message>
    <message>
        <source>Feeds: %1</source>
        <translation>Vorschübe: %1</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File unit</source>
        <translation>Einheit der Datei</translation>
    </message>
    <message>
        <source>Fill &amp;flat</source>
        <translation>&amp;Flach füllen</translation>
    </message>
    <message>
        <source>Fill &amp;smooth</source>
        <translation>&amp;Glatt füllen</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Löcher füllen</translation>
    </message>
    <message>
        <source>Fills one hole as you choose, or leaves it open; other steps fill the rest.</source>
        <translation>Füllt ein Loch, wie es gewählt ist, oder lässt es offen; andere Schritte füllen die übrigen.</translation>
    </message>
    <message>
        <source>Find by name, shape, material or library</source>
        <translation>Nach Name, Form, Werkstoff oder Bibliothek suchen</translation>
    </message>
    <message>
        <source>Find out which tools and settings serve best: many are planned and verified (S)</source>
        <translation>Herausfinden, welche Werkzeuge und Einstellungen am besten taugen: viele werden geplant und geprüft (S)</translation>
    </message>
    <message>
        <source>Finding facets in a box</source>
        <translation>Facetten in einem Quader werden gesucht</translation>
    </message>
    <message>
        <source>Finding rework regions</source>
        <translation>Nacharbeitsbereiche werden gesucht</translation>
    </message>
    <message>
        <source>Finding what lies in a boundary</source>
        <translation>Gesucht wird, was in einer Begrenzung liegt</translation>
    </message>
    <message>
        <source>Fins</source>
        <translation>Lappen</translation>
    </message>
    <message>
        <source>Fixture mesh</source>
        <translation>Netz eines Spannmittels</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>Flach</translation>
    </message>
    <message>
        <source>Flood</source>
        <translation>Füllen</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Following the path on the machine…</source>
        <translation>Dem Weg auf der Maschine folgen…</translation>
    </message>
    <message>
        <source>Follows a curve drawn on the part or the outline, on it or beside it: engraving, trimming</source>
        <translation>Folgt einer auf das Teil gezeichneten Kurve oder dem Umriss, darauf oder daneben: Gravieren, Besäumen</translation>
    </message>
    <message>
        <source>Foot of a wall</source>
        <translation>Fuß einer Wand</translation>
    </message>
    <message>
        <source>Forget the posture kept for this point</source>
        <translation>Die für diesen Punkt festgehaltene Stellung vergessen</translation>
    </message>
    <message>
        <source>Forget what was switched off, grown, shrunk and dragged by hand</source>
        <translation>Vergessen, was von Hand ausgeschaltet, vergrößert, verkleinert und gezogen wurde</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Found %1 in %2.</source>
        <translation>%1 in %2 gefunden.</translation>
    </message>
    <message>
        <source>Found %1 places; the first %2 of them:</source>
        <translation>%1 Stellen gefunden; die ersten %2 davon:</translation>
    </message>
    <message>
        <source>Found (click to go there):</source>
        <translation>Gefunden (Klick geht dorthin):</translation>
    </message>
    <message>
        <source>Found in the mesh</source>
        <translation>Im Netz gefunden</translation>
    </message>
    <message>
        <source>Found there too: %1.</source>
        <translation>Auch dort gefunden: %1.</translation>
    </message>
    <message>
        <source>FreeCAD</source>
        <translation>FreeCAD</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>From setup “%1”: </source>
        <translation>Aus Aufspannung „%1“: </translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Front of the study</source>
        <translation>Front der Studie</translation>
    </message>
    <message>
        <source>Fusion</source>
        <translation>Fusion</translation>
    </message>
    <message>
        <source>GOTO</source>
        <translation>GOTO</translation>
    </message>
    <message>
        <source>GOTO </source>
        <translation>GOTO </translation>
    </message>
    <message>
        <source>Give the boundary a name</source>
        <translation>Der Begrenzung einen Namen geben</translation>
    </message>
    <message>
        <source>Give the fixture a name</source>
        <translation>Dem Spannmittel einen Namen geben</translation>
    </message>
    <message>
        <source>Give the operation a name</source>
        <translation>Der Operation einen Namen geben</translation>
    </message>
    <message>
        <source>Give the setup a name</source>
        <translation>Der Aufspannung einen Namen geben</translation>
    </message>
    <message>
        <source>Gives a sheet a back and walls, so that it becomes a solid.</source>
        <translation>Gibt einer offenen Fläche eine Rückseite und Wände, so dass sie ein Körper wird.</translation>
    </message>
    <message>
        <source>Go to setup “%1”</source>
        <translation>Zu Aufspannung „%1“ wechseln</translation>
    </message>
    <message>
        <source>Go to this setup</source>
        <translation>Zu dieser Aufspannung wechseln</translation>
    </message>
    <message>
        <source>Goes back to the recipe of the project; nothing is changed</source>
        <translation>Zurück zum Rezept des Projekts; nichts wird geändert</translation>
    </message>
    <message>
        <source>Goes on with another scan where this one ends; the two overlap.</source>
        <translation>Setzt diesen Scan, wo er endet, mit einem anderen fort; die beiden überlappen sich.</translation>
    </message>
    <message>
        <source>Goes round steep walls and flanks at one height after another</source>
        <translation>Umfährt steile Wände und Flanken Höhe um Höhe</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Grow (%1)</source>
        <translation>Vergrößern (%1)</translation>
    </message>
    <message>
        <source>Grow and shrink by</source>
        <translation>Vergrößern und verkleinern um</translation>
    </message>
    <message>
        <source>Grow painted facets</source>
        <translation>Gemalte Facetten vergrößern</translation>
    </message>
    <message>
        <source>Grow region</source>
        <translation>Bereich vergrößern</translation>
    </message>
    <message>
        <source>Handing the study over</source>
        <translation>Die Studie wird übergeben</translation>
    </message>
    <message>
        <source>Height of the part as it lies</source>
        <translation>Höhe des Teils, wie es liegt</translation>
    </message>
    <message>
        <source>Hidden ones too</source>
        <translation>Auch verdeckte</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Teil ausblenden</translation>
    </message>
    <message>
        <source>Hide paths</source>
        <translation>Wege ausblenden</translation>
    </message>
    <message>
        <source>Hide stock</source>
        <translation>Rohteil ausblenden</translation>
    </message>
    <message>
        <source>High,
%1</source>
        <translation>Hoch,
%1</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Holder %1</source>
        <translation>Halter %1</translation>
    </message>
    <message>
        <source>Holder section</source>
        <translation>Halterabschnitt</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Mulde</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>How far its boundary lies outside the offset; double click to enter it</source>
        <translation>Wie weit die Begrenzung außerhalb des Versatzes liegt; Doppelklick zum Eingeben</translation>
    </message>
    <message>
        <source>How far the study is</source>
        <translation>Wie weit die Studie ist</translation>
    </message>
    <message>
        <source>How far the table may be tilted before the part falls</source>
        <translation>Wie weit der Tisch gekippt werden darf, bevor das Teil fällt</translation>
    </message>
    <message>
        <source>How the passes of the chosen operation will about run, until it is planned</source>
        <translation>Wie die Bahnen der gewählten Operation etwa verlaufen werden, bis sie geplant ist</translation>
    </message>
    <message>
        <source>Import tools</source>
        <translation>Werkzeuge importieren</translation>
    </message>
    <message>
        <source>In a chart or the unrolled path</source>
        <translation>In einem Diagramm oder dem abgewickelten Weg</translation>
    </message>
    <message>
        <source>In a hole</source>
        <translation>In einem Loch</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>Invert painted facets</source>
        <translation>Gemalte Facetten umkehren</translation>
    </message>
    <message>
        <source>It is offered again at the next start</source>
        <translation>Beim nächsten Start wird es wieder angeboten</translation>
    </message>
    <message>
        <source>It was kept as it stood on %1, in %2.</source>
        <translation>Es wurde gesichert, wie es am %1 war, in %2.</translation>
    </message>
    <message>
        <source>It was never saved under a name.</source>
        <translation>Es wurde nie unter einem Namen gespeichert.</translation>
    </message>
    <message>
        <source>It was painted on a part of %1 facets, and this one has %2: paint it anew.</source>
        <translation>Sie wurde auf einem Teil mit %1 Facetten gemalt, und dieses hat %2: neu malen.</translation>
    </message>
    <message>
        <source>Join a scan</source>
        <translation>Scan anfügen</translation>
    </message>
    <message>
        <source>Keep for this point</source>
        <translation>Für diesen Punkt festhalten</translation>
    </message>
    <message>
        <source>Keep libraries and templates in</source>
        <translation>Bibliotheken und Vorlagen aufbewahren in</translation>
    </message>
    <message>
        <source>Keep operations, tools and settings of this setup for other parts</source>
        <translation>Operationen, Werkzeuge und Einstellungen dieser Aufspannung für andere Teile aufbewahren</translation>
    </message>
    <message>
        <source>Keep posture</source>
        <translation>Stellung festhalten</translation>
    </message>
    <message>
        <source>Keep the tried posture for this point; planning again uses it</source>
        <translation>Die probierte Stellung für diesen Punkt festhalten; neues Planen verwendet sie</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Festgehalten</translation>
    </message>
    <message>
        <source>Kept as template “%1”: %2.</source>
        <translation>Als Vorlage „%1“ aufbewahrt: %2.</translation>
    </message>
    <message>
        <source>Kept lead %1, yaw %2 for the point. Plan again to use it.</source>
        <translation>Anstellwinkel %1, Taumelwinkel %2 für den Punkt festgehalten. Neu planen, um sie zu verwenden.</translation>
    </message>
    <message>
        <source>Kept with the project what was planned and verified: %1 MB in %2.</source>
        <translation>Mit dem Projekt aufbewahrt, was geplant und geprüft war: %1 MB in %2.</translation>
    </message>
    <message>
        <source>Kept: %1</source>
        <translation>Festgehalten: %1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>L&amp;ibraries and templates in</source>
        <translation>B&amp;ibliotheken und Vorlagen in</translation>
    </message>
    <message>
        <source>Larger letters (Ctrl++)</source>
        <translation>Größere Schrift (Strg++)</translation>
    </message>
    <message>
        <source>Largest cusp</source>
        <translation>Größte Spitzenhöhe</translation>
    </message>
    <message>
        <source>Largest excess</source>
        <translation>Größter Überstand</translation>
    </message>
    <message>
        <source>Largest first</source>
        <translation>Größte zuerst</translation>
    </message>
    <message>
        <source>Lay down, zero</source>
        <translation>Hinlegen, Nullpunkt</translation>
    </message>
    <message>
        <source>Lay it on a face</source>
        <translation>Auf eine Fläche legen</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Auf Fläche legen</translation>
    </message>
    <message>
        <source>Lay on this face</source>
        <translation>Auf diese Fläche legen</translation>
    </message>
    <message>
        <source>Lay part by its principal axes</source>
        <translation>Teil nach seinen Hauptachsen legen</translation>
    </message>
    <message>
        <source>Lay part on face</source>
        <translation>Teil auf Fläche legen</translation>
    </message>
    <message>
        <source>Lay part on three points</source>
        <translation>Teil auf drei Punkte legen</translation>
    </message>
    <message>
        <source>Lay the part on a face of the list, then put the zero on the stock: press P.</source>
        <translation>Das Teil auf eine Fläche der Liste legen, dann den Nullpunkt auf das Rohteil setzen: P drücken.</translation>
    </message>
    <message>
        <source>Lay the part on a face, turn, move or mirror it (P)</source>
        <translation>Das Teil auf eine Fläche legen, drehen, verschieben oder spiegeln (P)</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Layer %1 of %2, z %3</source>
        <translation>Ebene %1 von %2, z %3</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Ebenen</translation>
    </message>
    <message>
        <source>Lead limit (°), tool D %1</source>
        <translation>Grenze des Anstellwinkels (°), Werkzeug D %1</translation>
    </message>
    <message>
        <source>Least by this estimate: lead limit %1 with this tool, %2; of all tools D %3 with %4, %5.</source>
        <translation>Am wenigsten nach dieser Schätzung: Grenze %1 mit diesem Werkzeug, %2; von allen Werkzeugen D %3 mit %4, %5.</translation>
    </message>
    <message>
        <source>Leave it out of plan, verification and programs, as if it were not there</source>
        <translation>Aus Plan, Prüfung und Programmen lassen, als gäbe es sie nicht</translation>
    </message>
    <message>
        <source>Leaves about %1 % of what the tool sees of the part uncut</source>
        <translation>Lässt etwa %1 % von dem ungefräst, was das Werkzeug vom Teil sieht</translation>
    </message>
    <message>
        <source>Leaves least of these</source>
        <translation>Lässt von diesen am wenigsten</translation>
    </message>
    <message>
        <source>Left end: all layers; then one layer alone, from the top down</source>
        <translation>Linkes Ende: alle Ebenen; dann eine allein, von oben nach unten</translation>
    </message>
    <message>
        <source>Left for clean-up</source>
        <translation>Der Restbearbeitung überlassen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Length, %1</source>
        <translation>Länge, %1</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Lies,
%1</source>
        <translation>Liegt
auf, %1</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Links between cuts, approach and retract, at feed</source>
        <translation>Verbindungen zwischen Schnitten, Anfahren und Rückzug, im Vorschub</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>Locate it, or put it back: the rest of the project stays as it is.</source>
        <translation>Suchen oder zurücklegen: das übrige Projekt bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Locate “%1”</source>
        <translation>„%1“ suchen</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Suchen…</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Look &amp;again</source>
        <translation>Noch ein&amp;mal suchen</translation>
    </message>
    <message>
        <source>Look for suggestions once more, for the project as it is now</source>
        <translation>Noch einmal nach Vorschlägen suchen, für das Projekt, wie es jetzt ist</translation>
    </message>
    <message>
        <source>Looked at</source>
        <translation>Angesehen</translation>
    </message>
    <message>
        <source>Looking at the candidate</source>
        <translation>Der Kandidat wird angesehen</translation>
    </message>
    <message>
        <source>Looking at the pass…</source>
        <translation>Die Bahn wird untersucht…</translation>
    </message>
    <message>
        <source>Looking at the path</source>
        <translation>Der Weg wird untersucht</translation>
    </message>
    <message>
        <source>Looking at the study</source>
        <translation>Die Studie wird angesehen</translation>
    </message>
    <message>
        <source>Looking at what is known…</source>
        <translation>Was bekannt ist, wird gelesen…</translation>
    </message>
    <message>
        <source>Looking for a hole</source>
        <translation>Ein Loch wird gesucht</translation>
    </message>
    <message>
        <source>Looking for faces to lie on</source>
        <translation>Flächen zum Auflegen werden gesucht</translation>
    </message>
    <message>
        <source>Looking for faces to lie on…</source>
        <translation>Flächen zum Auflegen werden gesucht…</translation>
    </message>
    <message>
        <source>Looking for holes, pieces and other flaws…</source>
        <translation>Löcher, Stücke und andere Mängel werden gesucht…</translation>
    </message>
    <message>
        <source>Looking for suggestions</source>
        <translation>Vorschläge werden gesucht</translation>
    </message>
    <message>
        <source>Looking for the face</source>
        <translation>Die Fläche wird gesucht</translation>
    </message>
    <message>
        <source>Looking over the part</source>
        <translation>Das Teil wird durchgesehen</translation>
    </message>
    <message>
        <source>Loose pieces, holes, noise, facets: what is wrong with the mesh, and a recipe that mends it</source>
        <translation>Lose Stücke, Löcher, Rauschen, Facetten: was am Netz nicht stimmt, und ein Rezept dagegen</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Machine and control</source>
        <translation>Maschine und Steuerung</translation>
    </message>
    <message>
        <source>Machine and stock</source>
        <translation>Maschine und Rohteil</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>Bearbeitungszeit</translation>
    </message>
    <message>
        <source>Machining time until here, and of all operations</source>
        <translation>Bearbeitungszeit bis hier und aller Operationen</translation>
    </message>
    <message>
        <source>Make another mesh the part; operations, tools and the rest stay as they are</source>
        <translation>Ein anderes Netz zum Teil machen; Operationen, Werkzeuge und alles Übrige bleiben</translation>
    </message>
    <message>
        <source>Makes the part its mirror image: left and right along %1 change places. A part made so is another one.</source>
        <translation>Macht aus dem Teil sein Spiegelbild: links und rechts entlang %1 tauschen die Plätze. Ein so gefertigtes Teil ist ein anderes.</translation>
    </message>
    <message>
        <source>Makes the surface anew where it runs through itself.</source>
        <translation>Macht die Fläche neu, wo sie sich selbst durchdringt.</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>%1 wird erzeugt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Werkstoff</translation>
    </message>
    <message>
        <source>Material is left on %1 of the area to be cut.</source>
        <translation>Auf %1 der zu fräsenden Fläche bleibt Material stehen.</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Measuring slopes</source>
        <translation>Neigungen werden gemessen</translation>
    </message>
    <message>
        <source>Mend the part's mesh: loose pieces, holes, noise, facets (R)</source>
        <translation>Das Netz des Teils in Ordnung bringen: lose Stücke, Löcher, Rauschen, Facetten (R)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Netze (%1)</translation>
    </message>
    <message>
        <source>Meshes and projects (%1 *.facetmill);;All files (*)</source>
        <translation>Netze und Projekte (%1 *.facetmill);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Meshes are in</source>
        <translation>Netze sind in</translation>
    </message>
    <message>
        <source>Mesh…</source>
        <translation>Netz…</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>An %1 spiegeln</translation>
    </message>
    <message>
        <source>Mirror part in %1</source>
        <translation>Teil an %1 spiegeln</translation>
    </message>
    <message>
        <source>Missing too: %1.</source>
        <translation>Es fehlen auch: %1.</translation>
    </message>
    <message>
        <source>Mo&amp;use like</source>
        <translation>Ma&amp;us wie</translation>
    </message>
    <message>
        <source>More excess than this has the last blue</source>
        <translation>Größere Überstände als dieser haben das letzte Blau</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>Mouse, colours, machine of new projects, threads (Ctrl+,)</source>
        <translation>Maus, Farben, Maschine neuer Projekte, Threads (Strg+,)</translation>
    </message>
    <message>
        <source>Move along X</source>
        <translation>Entlang X verschieben</translation>
    </message>
    <message>
        <source>Move along Y</source>
        <translation>Entlang Y verschieben</translation>
    </message>
    <message>
        <source>Move along Z</source>
        <translation>Entlang Z verschieben</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Nach unten</translation>
    </message>
    <message>
        <source>Move fixture “%1”</source>
        <translation>Spannmittel „%1“ verschieben</translation>
    </message>
    <message>
        <source>Move operation</source>
        <translation>Operation verschieben</translation>
    </message>
    <message>
        <source>Move part along %1</source>
        <translation>Teil entlang %1 verschieben</translation>
    </message>
    <message>
        <source>Move setup</source>
        <translation>Aufspannung verschieben</translation>
    </message>
    <message>
        <source>Move the boundary of the chosen region inward, never inside of what is uncut</source>
        <translation>Die Begrenzung des gewählten Bereichs nach innen schieben, nie in das hinein, was stehen bleibt</translation>
    </message>
    <message>
        <source>Move the boundary of the chosen region outward</source>
        <translation>Die Begrenzung des gewählten Bereichs nach außen schieben</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Move: Ctrl + middle</source>
        <translation>Verschieben: Strg + Mitte</translation>
    </message>
    <message>
        <source>Move: Shift + middle</source>
        <translation>Verschieben: Umschalt + Mitte</translation>
    </message>
    <message>
        <source>Move: middle button</source>
        <translation>Verschieben: mittlere Taste</translation>
    </message>
    <message>
        <source>Move: middle button, or Ctrl + right</source>
        <translation>Verschieben: mittlere Taste oder Strg + rechts</translation>
    </message>
    <message>
        <source>Move: middle, or Shift + left</source>
        <translation>Verschieben: Mitte oder Umschalt + links</translation>
    </message>
    <message>
        <source>Moved at most %1</source>
        <translation>Verschoben um höchstens %1</translation>
    </message>
    <message>
        <source>Moves the middle of the part's box to X 0, Y 0</source>
        <translation>Verschiebt die Mitte des Quaders um das Teil nach X 0, Y 0</translation>
    </message>
    <message>
        <source>Moves the part along Z until its lowest point has Z 0</source>
        <translation>Verschiebt das Teil entlang Z, bis sein tiefster Punkt Z 0 hat</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name a mesh file</source>
        <translation>Eine Netzdatei angeben</translation>
    </message>
    <message>
        <source>Name the host that is to work, as ssh knows it.</source>
        <translation>Den Rechner nennen, der arbeiten soll, wie ssh ihn kennt.</translation>
    </message>
    <message>
        <source>Needles</source>
        <translation>Nadeln</translation>
    </message>
    <message>
        <source>New from sa&amp;mple</source>
        <translation>Neu aus Be&amp;ispiel</translation>
    </message>
    <message>
        <source>New from sample</source>
        <translation>Neu aus Beispiel</translation>
    </message>
    <message>
        <source>New projects</source>
        <translation>Neue Projekte</translation>
    </message>
    <message>
        <source>New projects are for</source>
        <translation>Neue Projekte sind für</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Next pass (↓)</source>
        <translation>Nächste Bahn (↓)</translation>
    </message>
    <message>
        <source>Next point on the pass (→; Shift: ten)</source>
        <translation>Nächster Punkt der Bahn (→; Umschalt: zehn)</translation>
    </message>
    <message>
        <source>No candidate has been looked at yet.</source>
        <translation>Noch ist kein Kandidat angesehen worden.</translation>
    </message>
    <message>
        <source>No defects found.</source>
        <translation>Keine Fehler gefunden.</translation>
    </message>
    <message>
        <source>No holder: nothing above the shank is watched. + adds a section.</source>
        <translation>Kein Halter: über dem Schaft wird nichts überwacht. + fügt einen Abschnitt hinzu.</translation>
    </message>
    <message>
        <source>No material yet: operations have feeds of their own. + adds one.</source>
        <translation>Noch kein Werkstoff: Operationen haben eigene Vorschübe. + fügt einen hinzu.</translation>
    </message>
    <message>
        <source>No operation turns the part: there is nothing to unroll</source>
        <translation>Keine Operation dreht das Teil: es gibt nichts abzuwickeln</translation>
    </message>
    <message>
        <source>No part has been read.</source>
        <translation>Es wurde kein Teil gelesen.</translation>
    </message>
    <message>
        <source>No path is planned.</source>
        <translation>Kein Weg ist geplant.</translation>
    </message>
    <message>
        <source>No place is hollow: any tool matches.</source>
        <translation>Keine Stelle ist hohl: jedes Werkzeug passt.</translation>
    </message>
    <message>
        <source>No place needs a lead above %1°: the main path cuts all of the part, there is nothing to rework.</source>
        <translation>Keine Stelle braucht einen Anstellwinkel über %1°: der Hauptweg fräst das ganze Teil, es gibt nichts nachzuarbeiten.</translation>
    </message>
    <message>
        <source>No point</source>
        <translation>Kein Punkt</translation>
    </message>
    <message>
        <source>No posture</source>
        <translation>Keine Stellung</translation>
    </message>
    <message>
        <source>No posture is free: the point is left to clean-up</source>
        <translation>Keine Stellung ist frei: der Punkt bleibt der Restbearbeitung</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Keine Vorschau</translation>
    </message>
    <message>
        <source>No step yet: the file is taken as it is. Suggest makes a recipe for what was found; Add takes single steps.</source>
        <translation>Noch kein Schritt: die Datei wird genommen, wie sie ist. Vorschlagen macht ein Rezept für das Gefundene; Hinzufügen nimmt einzelne Schritte.</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
    <message>
        <source>No tool has “%1”.</source>
        <translation>Kein Werkzeug hat „%1“.</translation>
    </message>
    <message>
        <source>No tool is kept yet. Import a library of another program, or keep the tools of this project.</source>
        <translation>Noch ist kein Werkzeug aufbewahrt. Die Bibliothek eines anderen Programms importieren oder die Werkzeuge dieses Projekts aufbewahren.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Nobody knows what these programs leave of part, tool and machine.</source>
        <translation>Niemand weiß, was diese Programme von Teil, Werkzeug und Maschine übrig lassen.</translation>
    </message>
    <message>
        <source>None is kept yet</source>
        <translation>Noch keine aufbewahrt</translation>
    </message>
    <message>
        <source>Normal change</source>
        <translation>Änderung der Normalen</translation>
    </message>
    <message>
        <source>Not all that was planned is kept with the project: it would be more than %1 MB. It is planned again when the project is opened.</source>
        <translation>Nicht alles Geplante wird mit dem Projekt aufbewahrt: es wäre mehr als %1 MB. Beim Öffnen des Projekts wird es neu geplant.</translation>
    </message>
    <message>
        <source>Not enough memory (close other programs or use a smaller part)</source>
        <translation>Zu wenig Speicher (andere Programme schließen oder ein kleineres Teil nehmen)</translation>
    </message>
    <message>
        <source>Not enough memory to play back the stock</source>
        <translation>Zu wenig Speicher, um das Rohteil abzuspielen</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Nicht geplant</translation>
    </message>
    <message>
        <source>Not restored: %1. It is offered again at the next start.</source>
        <translation>Nicht wiederhergestellt: %1. Beim nächsten Start wird es wieder angeboten.</translation>
    </message>
    <message>
        <source>Not studied. Step on, or pick a point.</source>
        <translation>Nicht untersucht. Weitergehen oder einen Punkt wählen.</translation>
    </message>
    <message>
        <source>Not verified</source>
        <translation>Nicht geprüft</translation>
    </message>
    <message>
        <source>Not verified (in %1), it cannot be judged: %2.</source>
        <translation>Nicht geprüft (in %1), nicht beurteilbar: %2.</translation>
    </message>
    <message>
        <source>Nothing can be compared while a value is not right.</source>
        <translation>Solange ein Wert falsch ist, kann nichts verglichen werden.</translation>
    </message>
    <message>
        <source>Nothing can be written into this folder: choose another one.</source>
        <translation>In diesen Ordner kann nichts geschrieben werden: einen anderen wählen.</translation>
    </message>
    <message>
        <source>Nothing has all these words.</source>
        <translation>Nichts enthält alle diese Wörter.</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Noch ist nichts geschehen.</translation>
    </message>
    <message>
        <source>Nothing is cut</source>
        <translation>Nichts wird gefräst</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Nichts ist geöffnet.</translation>
    </message>
    <message>
        <source>Nothing is wanted: choose a measure.</source>
        <translation>Nichts ist gewünscht: ein Maß wählen.</translation>
    </message>
    <message>
        <source>Nothing may vary: choose at least two values of something, such as two tools.</source>
        <translation>Nichts darf sich ändern: mindestens zwei Werte von etwas wählen, etwa zwei Werkzeuge.</translation>
    </message>
    <message>
        <source>Nothing moved</source>
        <translation>Nichts verschoben</translation>
    </message>
    <message>
        <source>Nothing to do: %1. No program is written for it.</source>
        <translation>Nichts zu tun: %1. Dafür wird kein Programm geschrieben.</translation>
    </message>
    <message>
        <source>Nothing to play back yet: plan first (F5).</source>
        <translation>Noch nichts abzuspielen: zuerst planen (F5).</translation>
    </message>
    <message>
        <source>Nothing was found that a recipe would mend.</source>
        <translation>Nichts wurde gefunden, was ein Rezept behöbe.</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Nichts wurde gefunden.</translation>
    </message>
    <message>
        <source>Nothing was judged</source>
        <translation>Nichts wurde beurteilt</translation>
    </message>
    <message>
        <source>Nothing was kept</source>
        <translation>Nichts wurde aufbewahrt</translation>
    </message>
    <message>
        <source>Nothing was taken over</source>
        <translation>Nichts wurde übernommen</translation>
    </message>
    <message>
        <source>Nothing was written</source>
        <translation>Nichts wurde geschrieben</translation>
    </message>
    <message>
        <source>Number %1 belongs to another tool</source>
        <translation>Nummer %1 gehört einem anderen Werkzeug</translation>
    </message>
    <message>
        <source>Number of regions</source>
        <translation>Anzahl der Bereiche</translation>
    </message>
    <message>
        <source>Number of rework regions</source>
        <translation>Anzahl der Nacharbeitsbereiche</translation>
    </message>
    <message>
        <source>Number of the GOTO in the operation's program</source>
        <translation>Nummer des GOTO im Programm der Operation</translation>
    </message>
    <message>
        <source>Numbers or %1, with a semicolon between them</source>
        <translation>Zahlen oder %1, mit einem Semikolon dazwischen</translation>
    </message>
    <message>
        <source>Numbers with a semicolon between them, %1</source>
        <translation>Zahlen mit einem Semikolon dazwischen, %1</translation>
    </message>
    <message>
        <source>Of earlier jobs there: %1.</source>
        <translation>Von früheren Aufträgen dort: %1.</translation>
    </message>
    <message>
        <source>Of the part</source>
        <translation>Des Teils</translation>
    </message>
    <message>
        <source>Of the stock</source>
        <translation>Des Rohteils</translation>
    </message>
    <message>
        <source>Of those that meet all limits, the one with the least of this wins</source>
        <translation>Von denen, die alle Grenzen einhalten, gewinnt der mit dem Geringsten davon</translation>
    </message>
    <message>
        <source>Of which operation</source>
        <translation>Welcher Operation</translation>
    </message>
    <message>
        <source>On 3 points</source>
        <translation>Auf 3 Punkte</translation>
    </message>
    <message>
        <source>On →</source>
        <translation>Weiter →</translation>
    </message>
    <message>
        <source>One hole</source>
        <translation>Ein Loch</translation>
    </message>
    <message>
        <source>One motion back (,)</source>
        <translation>Eine Bewegung zurück (,)</translation>
    </message>
    <message>
        <source>One motion on (.)</source>
        <translation>Eine Bewegung weiter (.)</translation>
    </message>
    <message>
        <source>One operation is as it was planned: it was kept with the project.</source>
        <translation>Eine Operation ist, wie sie geplant war: sie wurde mit dem Projekt aufbewahrt.</translation>
    </message>
    <message>
        <source>One pass that winds about a centre, for what is round</source>
        <translation>Eine Bahn, die sich um einen Mittelpunkt windet, für Rundes</translation>
    </message>
    <message>
        <source>One pass that winds over the part needs few links</source>
        <translation>Eine Bahn, die sich über das Teil windet, braucht wenige Verbindungen</translation>
    </message>
    <message>
        <source>Only what is cut up to “%1” has been verified.</source>
        <translation>Geprüft ist nur, was bis „%1“ gefräst wird.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a mesh or a project, and this panel tells what it holds.</source>
        <translation>Ein Netz oder ein Projekt öffnen: hier steht dann, was es enthält.</translation>
    </message>
    <message>
        <source>Open a mesh or drop one here</source>
        <translation>Netz öffnen oder hierher ziehen</translation>
    </message>
    <message>
        <source>Open a mesh, drop one here, or take a sample. STL files carry no unit: the sizes tell.</source>
        <translation>Ein Netz öffnen, hierher ziehen oder ein Beispiel nehmen. STL-Dateien haben keine Einheit: die Größen sagen sie.</translation>
    </message>
    <message>
        <source>Open a study's file, or the folder of one</source>
        <translation>Die Datei einer Studie öffnen, oder ihren Ordner</translation>
    </message>
    <message>
        <source>Open edges</source>
        <translation>Offene Kanten</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Open pro&amp;gram…</source>
        <translation>Pro&amp;gramm öffnen…</translation>
    </message>
    <message>
        <source>Open program</source>
        <translation>Programm öffnen</translation>
    </message>
    <message>
        <source>Open study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 geöffnet.</translation>
    </message>
    <message>
        <source>Opening the study</source>
        <translation>Die Studie wird geöffnet</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operation</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operationen</translation>
    </message>
    <message>
        <source>Operations, tools and settings as</source>
        <translation>Operationen, Werkzeuge und Einstellungen als</translation>
    </message>
    <message>
        <source>Order of operations</source>
        <translation>Reihenfolge der Operationen</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Out of date: plan again</source>
        <translation>Veraltet: neu planen</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Unerreichbar</translation>
    </message>
    <message>
        <source>Over the lead limit: click or drag to set it. Wheel: zoom. Right drag: move.</source>
        <translation>Über der Grenze des Anstellwinkels: klicken oder ziehen, um sie zu setzen. Rad: Zoom. Rechts ziehen: verschieben.</translation>
    </message>
    <message>
        <source>Over the tolerance %1</source>
        <translation>Über der Toleranz %1</translation>
    </message>
    <message>
        <source>Overfull edges</source>
        <translation>Überzählige Kanten</translation>
    </message>
    <message>
        <source>P&amp;lace part…</source>
        <translation>Teil &amp;legen…</translation>
    </message>
    <message>
        <source>P&amp;review</source>
        <translation>V&amp;orschau</translation>
    </message>
    <message>
        <source>Packed %1 files into %2.</source>
        <translation>%1 Dateien in %2 gepackt.</translation>
    </message>
    <message>
        <source>Packing %1</source>
        <translation>%1 wird gepackt</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Seite des Handbuchs</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Malen</translation>
    </message>
    <message>
        <source>Paint a face: up to edges where the surface turns by more</source>
        <translation>Eine Fläche malen: bis zu Kanten, an denen sie um mehr abknickt</translation>
    </message>
    <message>
        <source>Paint facets</source>
        <translation>Facetten malen</translation>
    </message>
    <message>
        <source>Paint what lies wholly in a rectangle</source>
        <translation>Malen, was ganz in einem Rechteck liegt</translation>
    </message>
    <message>
        <source>Paint what the ring touches</source>
        <translation>Malen, was der Ring berührt</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Gemalt</translation>
    </message>
    <message>
        <source>Painted facets</source>
        <translation>Gemalte Facetten</translation>
    </message>
    <message>
        <source>Pairs of facets that run through each other</source>
        <translation>Paare von Facetten, die sich durchdringen</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Part &amp;shading</source>
        <translation>&amp;Darstellung des Teils</translation>
    </message>
    <message>
        <source>Part's origin</source>
        <translation>Ursprung des Teils</translation>
    </message>
    <message>
        <source>Pass %1 of %2</source>
        <translation>Bahn %1 von %2</translation>
    </message>
    <message>
        <source>Pass %1, point %2 of %3 · %4</source>
        <translation>Bahn %1, Punkt %2 von %3 · %4</translation>
    </message>
    <message>
        <source>Pass %1, point %2: lead %3, yaw %4</source>
        <translation>Bahn %1, Punkt %2: Anstellwinkel %3, Taumelwinkel %4</translation>
    </message>
    <message>
        <source>Pass before (↑)</source>
        <translation>Vorherige Bahn (↑)</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Bahnen</translation>
    </message>
    <message>
        <source>Passes follow the border, everywhere as far apart as the tolerance allows</source>
        <translation>Bahnen folgen dem Rand, überall so weit auseinander, wie die Toleranz erlaubt</translation>
    </message>
    <message>
        <source>Passes follow the part's outline</source>
        <translation>Die Bahnen folgen dem Umriss des Teils</translation>
    </message>
    <message>
        <source>Passes from a centre outward, like the spokes of a wheel</source>
        <translation>Bahnen von einem Mittelpunkt nach außen, wie die Speichen eines Rads</translation>
    </message>
    <message>
        <source>Passes from the middle outward meet its rims head on</source>
        <translation>Bahnen von der Mitte nach außen treffen seine Ränder gerade</translation>
    </message>
    <message>
        <source>Passes side by side over the surface, with an upright tool</source>
        <translation>Bahnen nebeneinander über die Fläche, mit senkrechtem Werkzeug</translation>
    </message>
    <message>
        <source>Passes that follow a border or a curve or go round a place, with cusps of one height</source>
        <translation>Bahnen, die einem Rand oder einer Kurve folgen oder um eine Stelle gehen, mit Rillen von einer Höhe</translation>
    </message>
    <message>
        <source>Passes that go over from one curve to another, the way the part flows</source>
        <translation>Bahnen, die von einer Kurve in eine andere übergehen, wie das Teil verläuft</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Paste operation</source>
        <translation>Operation einfügen</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Bahn</translation>
    </message>
    <message>
        <source>Path by</source>
        <translation>Weg nach</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Pe&amp;rspective</source>
        <translation>Perspe&amp;ktive</translation>
    </message>
    <message>
        <source>Peak load</source>
        <translation>Lastspitze</translation>
    </message>
    <message>
        <source>Pick %1</source>
        <translation>%1 wählen</translation>
    </message>
    <message>
        <source>Pick a point on the path of a planned 5-axis operation</source>
        <translation>Einen Punkt auf dem Weg einer geplanten 5-Achs-Operation wählen</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>In der Ansicht wählen</translation>
    </message>
    <message>
        <source>Pick it in the view</source>
        <translation>In der Ansicht wählen</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Place along the strip</source>
        <translation>Stelle entlang des Streifens</translation>
    </message>
    <message>
        <source>Place along the strip; a click on the strip in the view goes there, too</source>
        <translation>Stelle entlang des Streifens; ein Klick auf den Streifen in der Ansicht geht auch dorthin</translation>
    </message>
    <message>
        <source>Place of the pass across the travel (%1)</source>
        <translation>Lage der Bahn quer zur Fahrt (%1)</translation>
    </message>
    <message>
        <source>Place part</source>
        <translation>Teil legen</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>Gefundene Stellen</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planen</translation>
    </message>
    <message>
        <source>Plan all &amp;setups</source>
        <translation>Alle &amp;Aufspannungen planen</translation>
    </message>
    <message>
        <source>Plan all operations (F5)</source>
        <translation>Alle Operationen planen (F5)</translation>
    </message>
    <message>
        <source>Plan an operation to see it here</source>
        <translation>Eine Operation planen, um sie hier zu sehen</translation>
    </message>
    <message>
        <source>Plan and judge finishing operations of all kinds, and suggest the three best (G)</source>
        <translation>Schlichtoperationen aller Arten planen und beurteilen und die drei besten vorschlagen (G)</translation>
    </message>
    <message>
        <source>Plan and verify</source>
        <translation>Planen und prüfen</translation>
    </message>
    <message>
        <source>Plan and verify the candidates in the background</source>
        <translation>Die Kandidaten im Hintergrund planen und prüfen</translation>
    </message>
    <message>
        <source>Plan anyway</source>
        <translation>Trotzdem planen</translation>
    </message>
    <message>
        <source>Plan every setup, each on the stock that those before it leave (Shift+F5)</source>
        <translation>Jede Aufspannung planen, jede auf dem Rohteil, das die vorherigen lassen (Umschalt+F5)</translation>
    </message>
    <message>
        <source>Plan that much?</source>
        <translation>So viel planen?</translation>
    </message>
    <message>
        <source>Plan this operation</source>
        <translation>Diese Operation planen</translation>
    </message>
    <message>
        <source>Plan what is not planned yet, and judge all setups as one job (Shift+F6)</source>
        <translation>Planen, was noch nicht geplant ist, und alle Aufspannungen als einen Auftrag beurteilen (Umschalt+F6)</translation>
    </message>
    <message>
        <source>Plan “%1” to see its strips here</source>
        <translation>„%1“ planen, um die Streifen hier zu sehen</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Geplant</translation>
    </message>
    <message>
        <source>Planned %1 of %2, judged coarsely %3 of about %4, finely %5 of about %6.</source>
        <translation>Geplant %1 von %2, grob geprüft %3 von etwa %4, fein %5 von etwa %6.</translation>
    </message>
    <message>
        <source>Planned as kept: </source>
        <translation>Geplant wie festgehalten: </translation>
    </message>
    <message>
        <source>Planned in</source>
        <translation>Geplant in</translation>
    </message>
    <message numerus="yes">
        <source>Planned “%1” in %2: %3 passes, cut length %4, machining time %5.</source>
        <translation><numerusform>„%1“ in %2 geplant: %3 Bahn, Schnittlänge %4, Bearbeitungszeit %5.</numerusform><numerusform>„%1“ in %2 geplant: %3 Bahnen, Schnittlänge %4, Bearbeitungszeit %5.</numerusform></translation>
    </message>
    <message>
        <source>Planned: </source>
        <translation>Geplant: </translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Wird geplant</translation>
    </message>
    <message>
        <source>Planning all setups</source>
        <translation>Alle Aufspannungen werden geplant</translation>
    </message>
    <message>
        <source>Planning and judging operations for this part</source>
        <translation>Operationen für dieses Teil werden geplant und beurteilt</translation>
    </message>
    <message>
        <source>Planning and judging operations for this part: %1</source>
        <translation>Operationen für dieses Teil werden geplant und beurteilt: %1</translation>
    </message>
    <message>
        <source>Planning and verifying it takes about %1</source>
        <translation>Planen und Prüfen brauchen etwa %1</translation>
    </message>
    <message>
        <source>Planning it takes %1.</source>
        <translation>Das Planen braucht %1.</translation>
    </message>
    <message>
        <source>Plate below</source>
        <translation>Platte darunter</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Abspielen (Leertaste)</translation>
    </message>
    <message>
        <source>Point before on the pass (←; Shift: ten)</source>
        <translation>Vorheriger Punkt der Bahn (←; Umschalt: zehn)</translation>
    </message>
    <message>
        <source>Points with a posture kept by hand</source>
        <translation>Punkte mit von Hand festgehaltener Stellung</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Press Plan (F5) to plan it.</source>
        <translation>Mit Planen (F5) planen.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message numerus="yes">
        <source>Preview: %1 layers</source>
        <translation><numerusform>Vorschau: %1 Ebene</numerusform><numerusform>Vorschau: %1 Ebenen</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Preview: about %1 passes</source>
        <translation><numerusform>Vorschau: etwa %1 Bahn</numerusform><numerusform>Vorschau: etwa %1 Bahnen</numerusform></translation>
    </message>
    <message>
        <source>Previewing passes</source>
        <translation>Bahnen werden vorgezeigt</translation>
    </message>
    <message>
        <source>Previous tool at the picked point</source>
        <translation>Vorheriges Werkzeug am gewählten Punkt</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>Hauptachsen</translation>
    </message>
    <message>
        <source>Programs count from here; a corner or an edge nearby is taken exactly</source>
        <translation>Programme zählen von hier; eine nahe Ecke oder Kante wird genau genommen</translation>
    </message>
    <message>
        <source>Programs count from the origin of the part's coordinates</source>
        <translation>Programme zählen vom Ursprung der Koordinaten des Teils</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Progress of the preview</source>
        <translation>Fortschritt der Vorschau</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projekt</translation>
    </message>
    <message>
        <source>Put the chosen candidate into the project, as one step that Undo takes back</source>
        <translation>Den gewählten Kandidaten in das Projekt übernehmen, als ein Schritt, den Rückgängig zurücknimmt</translation>
    </message>
    <message>
        <source>Put the steps away</source>
        <translation>Die Schritte wegräumen</translation>
    </message>
    <message>
        <source>Put the steps away; Help shows them again</source>
        <translation>Die Schritte wegräumen; Hilfe zeigt sie wieder</translation>
    </message>
    <message>
        <source>Put the tools of the project into a library of its name</source>
        <translation>Die Werkzeuge des Projekts in eine Bibliothek seines Namens legen</translation>
    </message>
    <message>
        <source>Puts steps for what was found in the place of the recipe, to be changed</source>
        <translation>Setzt Schritte für das Gefundene an die Stelle des Rezepts, zum Ändern</translation>
    </message>
    <message>
        <source>Puts the recipe into the project, as one step that can be undone</source>
        <translation>Setzt das Rezept in das Projekt, als einen Schritt, der sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Range from the tolerance</source>
        <translation>Bereich aus der Toleranz</translation>
    </message>
    <message>
        <source>Range of slope</source>
        <translation>Neigungsbereich</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>Bereich: %1</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Eilgang</translation>
    </message>
    <message>
        <source>Rapid length</source>
        <translation>Eilganglänge</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Eilgänge</translation>
    </message>
    <message>
        <source>Re&amp;place part…</source>
        <translation>Teil erse&amp;tzen…</translation>
    </message>
    <message>
        <source>Read %1: %2 facets.</source>
        <translation>%1 gelesen: %2 Facetten.</translation>
    </message>
    <message>
        <source>Read over: %1</source>
        <translation>Übergangen: %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Reading what was planned</source>
        <translation>Geplantes wird gelesen</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Zuletzt geöffnete Dateien</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Rezept</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Bereich</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove boundary</source>
        <translation>Begrenzung entfernen</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Spannmittel entfernen</translation>
    </message>
    <message>
        <source>Remove kept posture</source>
        <translation>Festgehaltene Stellung entfernen</translation>
    </message>
    <message>
        <source>Remove operation</source>
        <translation>Operation entfernen</translation>
    </message>
    <message>
        <source>Remove setup</source>
        <translation>Aufspannung entfernen</translation>
    </message>
    <message>
        <source>Remove the selected material</source>
        <translation>Den gewählten Werkstoff entfernen</translation>
    </message>
    <message>
        <source>Remove the selected section</source>
        <translation>Den gewählten Abschnitt entfernen</translation>
    </message>
    <message>
        <source>Remove the step (Del)</source>
        <translation>Den Schritt entfernen (Entf)</translation>
    </message>
    <message>
        <source>Remove tool</source>
        <translation>Werkzeug entfernen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Rename boundary</source>
        <translation>Begrenzung umbenennen</translation>
    </message>
    <message>
        <source>Rename fixture</source>
        <translation>Spannmittel umbenennen</translation>
    </message>
    <message>
        <source>Rename operation</source>
        <translation>Operation umbenennen</translation>
    </message>
    <message>
        <source>Rename setup</source>
        <translation>Aufspannung umbenennen</translation>
    </message>
    <message>
        <source>Repair part</source>
        <translation>Teil reparieren</translation>
    </message>
    <message>
        <source>Replace part</source>
        <translation>Teil ersetzen</translation>
    </message>
    <message>
        <source>Replaced there: %1.</source>
        <translation>Dort ersetzt: %1.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Report of the candidate</source>
        <translation>Bericht des Kandidaten</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Rest</translation>
    </message>
    <message>
        <source>Rest material</source>
        <translation>Restmaterial</translation>
    </message>
    <message>
        <source>Restored “%1” as it stood on %2. Save it: until then it is kept in %3.</source>
        <translation>„%1“ wiederhergestellt, wie es am %2 war. Speichern: bis dahin liegt es in %3.</translation>
    </message>
    <message>
        <source>Rework</source>
        <translation>Nacharbeit</translation>
    </message>
    <message>
        <source>Rework (% of the surface)</source>
        <translation>Nacharbeit (% der Fläche)</translation>
    </message>
    <message>
        <source>Rework and clean-up regions on the part's surface</source>
        <translation>Bereiche der Nacharbeit und Restbearbeitung auf der Fläche des Teils</translation>
    </message>
    <message>
        <source>Rework regions</source>
        <translation>Nacharbeitsbereiche</translation>
    </message>
    <message>
        <source>Rework regions…</source>
        <translation>Nacharbeitsbereiche…</translation>
    </message>
    <message>
        <source>Roll anticlockwise</source>
        <translation>Gegen den Uhrzeigersinn rollen</translation>
    </message>
    <message>
        <source>Roll clockwise</source>
        <translation>Im Uhrzeigersinn rollen</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Schruppen</translation>
    </message>
    <message>
        <source>Running these programs can damage part, tool and machine.</source>
        <translation>Diese Programme laufen zu lassen kann Teil, Werkzeug und Maschine beschädigen.</translation>
    </message>
    <message>
        <source>Runs along the valleys that the cutter touches on both sides, and beside them</source>
        <translation>Läuft in den Tälern, die der Fräser auf beiden Seiten berührt, und daneben</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>S&amp;uggest an operation…</source>
        <translation>&amp;Operation vorschlagen…</translation>
    </message>
    <message>
        <source>Sa&amp;ve as template…</source>
        <translation>&amp;Als Vorlage speichern…</translation>
    </message>
    <message>
        <source>Same tool axis for all operations</source>
        <translation>Dieselbe Werkzeugachse für alle Operationen</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Samples</source>
        <comment>places looked at</comment>
        <translation>Messpunkte</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Save as template</source>
        <translation>Als Vorlage speichern</translation>
    </message>
    <message>
        <source>Save pac&amp;ked copy…</source>
        <translation>Gepac&amp;kte Kopie speichern…</translation>
    </message>
    <message>
        <source>Save packed copy</source>
        <translation>Gepackte Kopie speichern</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 gespeichert.</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert…</translation>
    </message>
    <message>
        <source>Say where a file is that the project names and that is not there</source>
        <translation>Sagen, wo eine Datei ist, die das Projekt nennt und die fehlt</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Skalieren mit</translation>
    </message>
    <message>
        <source>Scale part by %1</source>
        <translation>Teil mit %1 skalieren</translation>
    </message>
    <message>
        <source>Scan room</source>
        <translation>Scan-Raum</translation>
    </message>
    <message numerus="yes">
        <source>Scan room: %1 steps…</source>
        <translation><numerusform>Scan-Raum: %1 Schritt…</numerusform><numerusform>Scan-Raum: %1 Schritte…</numerusform></translation>
    </message>
    <message>
        <source>Scan room…</source>
        <translation>Scan-Raum…</translation>
    </message>
    <message>
        <source>Scan that goes on where this one ends</source>
        <translation>Scan, der weitergeht, wo dieser endet</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Im Handbuch suchen</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>Im Handbuch suchen (Strg+F)</translation>
    </message>
    <message>
        <source>See the part turn under a standing tool, as on the machine</source>
        <translation>Das Teil unter stehendem Werkzeug drehen sehen, wie auf der Maschine</translation>
    </message>
    <message>
        <source>Seen from above: 0° leans towards X, 90° towards Y</source>
        <translation>Von oben gesehen: 0° neigt nach X, 90° nach Y</translation>
    </message>
    <message>
        <source>Select something in the project to see its parameters.</source>
        <translation>Etwas im Projekt auswählen, um seine Parameter zu sehen.</translation>
    </message>
    <message>
        <source>Set the lead limit to it</source>
        <translation>Die Grenze des Anstellwinkels darauf setzen</translation>
    </message>
    <message>
        <source>Set work zero</source>
        <translation>Werkstücknullpunkt setzen</translation>
    </message>
    <message>
        <source>Sets corner radius and angles; every value can be changed afterwards.</source>
        <translation>Setzt Eckenradius und Winkel; jeder Wert kann danach geändert werden.</translation>
    </message>
    <message>
        <source>Settings of Rework Region</source>
        <translation>Einstellungen der Nacharbeitsbereiche</translation>
    </message>
    <message>
        <source>Settings of Rework Region – %1</source>
        <translation>Einstellungen der Nacharbeitsbereiche – %1</translation>
    </message>
    <message>
        <source>Settings of Rework Region: see, limit and edit what the smaller tool cuts</source>
        <translation>Einstellungen der Nacharbeitsbereiche: sehen, begrenzen und ändern, was das kleinere Werkzeug fräst</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Aufspannung</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Schaft</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Share of the area, highest %1</source>
        <translation>Anteil der Fläche, höchstens %1</translation>
    </message>
    <message>
        <source>Share of the surface that faces the table without lying on it: no tool from above comes there</source>
        <translation>Anteil der Fläche, die zum Tisch zeigt, ohne aufzuliegen: dorthin kommt kein Werkzeug von oben</translation>
    </message>
    <message>
        <source>Shells</source>
        <translation>Schalen</translation>
    </message>
    <message>
        <source>Shells: facets that are joined by edges. A click goes to one.</source>
        <translation>Hüllen: Facetten, die durch Kanten verbunden sind. Ein Klick geht zu einer.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show all of it (double click, Home)</source>
        <translation>Alles zeigen (Doppelklick, Pos1)</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Teil zeigen</translation>
    </message>
    <message>
        <source>Show paths</source>
        <translation>Wege zeigen</translation>
    </message>
    <message>
        <source>Show stock</source>
        <translation>Rohteil zeigen</translation>
    </message>
    <message>
        <source>Show the &amp;steps of a first job</source>
        <translation>Die &amp;Schritte eines ersten Auftrags zeigen</translation>
    </message>
    <message>
        <source>Show the whole chart (double click, Home)</source>
        <translation>Das ganze Diagramm zeigen (Doppelklick, Pos1)</translation>
    </message>
    <message>
        <source>Show their folder</source>
        <translation>Ihren Ordner zeigen</translation>
    </message>
    <message>
        <source>Show, play back and verify an existing program (%1) without planning</source>
        <translation>Ein vorhandenes Programm (%1) ohne Planen zeigen, abspielen und prüfen</translation>
    </message>
    <message>
        <source>Showing %1 in place of the plan, until something is planned or File &gt; Close program.</source>
        <translation>Gezeigt wird %1 anstelle des Plans, bis etwas geplant wird oder Datei &gt; Programm schließen.</translation>
    </message>
    <message>
        <source>Shows the stock as it stands after “%1”</source>
        <translation>Zeigt das Rohteil, wie es nach „%1“ steht</translation>
    </message>
    <message>
        <source>Shows the tool that cut before, where it touches the part at two places over the strip and can go no deeper. Clicks on a strip in the view then mean the strip, not the path on it.</source>
        <translation>Zeigt das vorher fräsende Werkzeug, wo es das Teil an zwei Stellen über dem Streifen berührt und nicht tiefer kommt. Klicks auf einen Streifen in der Ansicht meinen dann den Streifen, nicht den Weg darauf.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Shrink painted facets</source>
        <translation>Gemalte Facetten verkleinern</translation>
    </message>
    <message>
        <source>Side feed</source>
        <translation>Seitenvorschub</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>Silhouette of the part</source>
        <translation>Umriss des Teils</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Größe: %1</translation>
    </message>
    <message>
        <source>Size: %1, scaled by %2</source>
        <translation>Größe: %1, skaliert mit %2</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>Slope from level at which the part is divided: what is steeper is cut by levels</source>
        <translation>Neigung gegen die Waagrechte, an der das Teil geteilt wird: was steiler ist, wird in Höhenlinien gefräst</translation>
    </message>
    <message>
        <source>Small pieces</source>
        <translation>Kleine Stücke</translation>
    </message>
    <message>
        <source>Smaller letters (Ctrl+−)</source>
        <translation>Kleinere Schrift (Strg+−)</translation>
    </message>
    <message>
        <source>Smallest stock</source>
        <translation>Kleinstes Rohteil</translation>
    </message>
    <message>
        <source>Smooth noise</source>
        <translation>Rauschen glätten</translation>
    </message>
    <message>
        <source>So many of the combinations, chosen by chance, the same each time; 0: all</source>
        <translation>So viele der Kombinationen, zufällig gewählt, jedes Mal dieselben; 0: alle</translation>
    </message>
    <message>
        <source>SolidWorks</source>
        <translation>SolidWorks</translation>
    </message>
    <message>
        <source>Some libraries cannot be read</source>
        <translation>Einige Bibliotheken sind nicht lesbar</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Special</source>
        <translation>Sonderform</translation>
    </message>
    <message>
        <source>Square up</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Square up part</source>
        <translation>Teil ausrichten</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Stages of the study</source>
        <translation>Stufen der Studie</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Step %1 could not be carried out.</source>
        <translation>Schritt %1 konnte nicht ausgeführt werden.</translation>
    </message>
    <message>
        <source>Step %1 is with Slurm, jobs %2 and %3.</source>
        <translation>Schritt %1 ist bei Slurm, Aufträge %2 und %3.</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Bahnabstand</translation>
    </message>
    <message>
        <source>Step-over (%1)</source>
        <translation>Bahnabstand (%1)</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>Schritte des Rezepts</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>Stock after it</source>
        <translation>Rohteil danach</translation>
    </message>
    <message>
        <source>Stock after “%1”</source>
        <translation>Rohteil nach „%1“</translation>
    </message>
    <message>
        <source>Stock mesh</source>
        <translation>Netz des Rohteils</translation>
    </message>
    <message>
        <source>Stock turns in</source>
        <translation>Rohteil dreht sich in</translation>
    </message>
    <message>
        <source>Stock: %1</source>
        <translation>Rohteil: %1</translation>
    </message>
    <message>
        <source>Stock: box</source>
        <translation>Rohteil: Quader</translation>
    </message>
    <message>
        <source>Stock: cylinder</source>
        <translation>Rohteil: Zylinder</translation>
    </message>
    <message>
        <source>Stock: rest of “%1”</source>
        <translation>Rohteil: Rest von „%1“</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop the preview (Esc)</source>
        <translation>Die Vorschau anhalten (Esc)</translation>
    </message>
    <message>
        <source>Stopped. Nothing is suggested.</source>
        <translation>Angehalten. Nichts wird vorgeschlagen.</translation>
    </message>
    <message>
        <source>Stopped. Resume goes on with what was found.</source>
        <translation>Angehalten. Fortsetzen macht mit dem weiter, was gefunden ist.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten…</translation>
    </message>
    <message>
        <source>Straighten, move, mirror</source>
        <translation>Geraderichten, verschieben, spiegeln</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Strategie</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Strips of clean-up come here: add a clean-up operation and plan it</source>
        <translation>Hier stehen die Streifen der Restbearbeitung: eine solche Operation hinzufügen und planen</translation>
    </message>
    <message>
        <source>Stud&amp;y…</source>
        <translation>Stud&amp;ie…</translation>
    </message>
    <message>
        <source>Studies (*.study.json request.json)</source>
        <translation>Studien (*.study.json request.json)</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Su&amp;ggest</source>
        <translation>Vorschla&amp;gen</translation>
    </message>
    <message>
        <source>Suggest an operation</source>
        <translation>Operation vorschlagen</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Vorschläge</translation>
    </message>
    <message>
        <source>Surface to rework</source>
        <translation>Nachzuarbeitende Fläche</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <translation>%1 ausschalten</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <translation>%1 einschalten</translation>
    </message>
    <message>
        <source>Switch off operation</source>
        <translation>Operation ausschalten</translation>
    </message>
    <message>
        <source>Switch on operation</source>
        <translation>Operation einschalten</translation>
    </message>
    <message>
        <source>Switch region off</source>
        <translation>Bereich ausschalten</translation>
    </message>
    <message>
        <source>Switch region on</source>
        <translation>Bereich einschalten</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Ausgeschaltet</translation>
    </message>
    <message>
        <source>Switched off: it is not cut</source>
        <translation>Ausgeschaltet: wird nicht gefräst</translation>
    </message>
    <message>
        <source>T%1</source>
        <translation>T%1</translation>
    </message>
    <message>
        <source>T%1  %2</source>
        <translation>T%1  %2</translation>
    </message>
    <message>
        <source>T%1  %2
%3, %4</source>
        <translation>T%1  %2
%3, %4</translation>
    </message>
    <message>
        <source>T%1 %2</source>
        <translation>T%1 %2</translation>
    </message>
    <message>
        <source>T%1 in regions</source>
        <translation>T%1 in Bereichen</translation>
    </message>
    <message>
        <source>T%1, %2 %3</source>
        <translation>T%1, %2 %3</translation>
    </message>
    <message>
        <source>T&amp;hreads</source>
        <translation>T&amp;hreads</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Tabs round the part</source>
        <translation>Haltestege um das Teil</translation>
    </message>
    <message>
        <source>Take a holder of the tool library</source>
        <translation>Einen Halter der Werkzeugbibliothek nehmen</translation>
    </message>
    <message>
        <source>Take all facets out</source>
        <translation>Alle Facetten herausnehmen</translation>
    </message>
    <message>
        <source>Take facets out. Shift does the other of the two.</source>
        <translation>Facetten herausnehmen. Umschalt tut das jeweils andere.</translation>
    </message>
    <message>
        <source>Take in what lies so near, along edges</source>
        <translation>Hinzunehmen, was so nahe liegt, entlang der Kanten</translation>
    </message>
    <message>
        <source>Take out what lies so near to the border, along edges</source>
        <translation>Wegnehmen, was so nahe am Rand liegt, entlang der Kanten</translation>
    </message>
    <message>
        <source>Take over tools of FreeCAD, Fusion, LinuxCNC, CAMotics or Kiri:Moto</source>
        <translation>Werkzeuge von FreeCAD, Fusion, LinuxCNC, CAMotics oder Kiri:Moto übernehmen</translation>
    </message>
    <message>
        <source>Takes %1 times as long as the quickest</source>
        <translation>Dauert %1-mal so lange wie die schnellste</translation>
    </message>
    <message>
        <source>Takes away what lies beyond a plane and closes the section.</source>
        <translation>Entfernt, was jenseits einer Ebene liegt, und schließt den Schnitt.</translation>
    </message>
    <message>
        <source>Takes facets away that say nothing, within the bound.</source>
        <translation>Entfernt Facetten, die nichts besagen, innerhalb der Grenze.</translation>
    </message>
    <message>
        <source>Takes facets without height away; nothing moves farther than the bound.</source>
        <translation>Entfernt Facetten ohne Höhe; nichts bewegt sich weiter als die Grenze.</translation>
    </message>
    <message>
        <source>Takes loose pieces away that are smaller than a limit.</source>
        <translation>Entfernt lose Stücke, die kleiner als eine Grenze sind.</translation>
    </message>
    <message>
        <source>Takes sheets away that hang on the surface and end in the open.</source>
        <translation>Entfernt Flächen, die an der Oberfläche hängen und im Freien enden.</translation>
    </message>
    <message>
        <source>Takes short waves away; nothing moves farther than the bound, sharp edges stay.</source>
        <translation>Entfernt kurze Wellen; nichts bewegt sich weiter als die Grenze, scharfe Kanten bleiben.</translation>
    </message>
    <message>
        <source>Takes the stock down layer by layer, and leaves an allowance</source>
        <translation>Nimmt das Rohteil Ebene für Ebene ab und lässt ein Aufmaß</translation>
    </message>
    <message>
        <source>Takes the stock of a turning part down in passes</source>
        <translation>Nimmt das Rohteil eines drehenden Teils in Bahnen ab</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>Konisch mit Kugel</translation>
    </message>
    <message>
        <source>Tapered flat</source>
        <translation>Konisch flach</translation>
    </message>
    <message>
        <source>Templates (*%1)</source>
        <translation>Vorlagen (*%1)</translation>
    </message>
    <message>
        <source>Texts and numbers of the window; programs and files are the same in all of them</source>
        <translation>Texte und Zahlen des Fensters; Programme und Dateien sind in allen gleich</translation>
    </message>
    <message>
        <source>That is beside the part: click on it, or press Esc.</source>
        <translation>Das ist neben dem Teil: darauf klicken oder Esc drücken.</translation>
    </message>
    <message>
        <source>The 3D view cannot be shown: %1.

Install a graphics driver, or use facetmill-cli.</source>
        <translation>Die 3D-Ansicht kann nicht gezeigt werden: %1.

Einen Grafiktreiber installieren oder facetmill-cli verwenden.</translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations by previews of their passes. Planning all of them, to judge what they leave, would take long: add one, then plan and verify it.</source>
        <translation><numerusform>Die beste von %1 Operation nach der Vorschau ihrer Bahnen. Alle zu planen, um zu beurteilen, was sie lassen, dauerte lange: eine hinzufügen, dann planen und prüfen.</numerusform><numerusform>Die besten von %1 Operationen nach der Vorschau ihrer Bahnen. Alle zu planen, um zu beurteilen, was sie lassen, dauerte lange: eine hinzufügen, dann planen und prüfen.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations that were planned for this part and the project's tools, by time and by what they leave</source>
        <translation><numerusform>Die beste von %1 Operation, die für dieses Teil und die Werkzeuge des Projekts geplant wurde, nach Zeit und nach dem, was sie lässt</numerusform><numerusform>Die besten von %1 Operationen, die für dieses Teil und die Werkzeuge des Projekts geplant wurden, nach Zeit und nach dem, was sie lassen</numerusform></translation>
    </message>
    <message>
        <source>The box takes facets that are not seen from here as well</source>
        <translation>Das Rechteck nimmt auch Facetten, die von hier nicht zu sehen sind</translation>
    </message>
    <message>
        <source>The candidate is planned and judged</source>
        <translation>Der Kandidat wird geplant und geprüft</translation>
    </message>
    <message>
        <source>The clipboard holds no operation: copy one in the tree first (Ctrl+C).</source>
        <translation>In der Zwischenablage ist keine Operation: zuerst eine im Baum kopieren (Strg+C).</translation>
    </message>
    <message>
        <source>The edges of all facets</source>
        <translation>Die Kanten aller Facetten</translation>
    </message>
    <message>
        <source>The face is level now and %1 above the table: something else of the part reaches lower.</source>
        <translation>Die Fläche liegt jetzt waagrecht und %1 über dem Tisch: etwas anderes am Teil reicht tiefer.</translation>
    </message>
    <message>
        <source>The face under the pointer comes down on the table</source>
        <translation>Die Fläche unter dem Zeiger kommt auf den Tisch</translation>
    </message>
    <message>
        <source>The file of the part is missing</source>
        <translation>Die Datei des Teils fehlt</translation>
    </message>
    <message>
        <source>The file of the part is missing.</source>
        <translation>Die Datei des Teils fehlt.</translation>
    </message>
    <message>
        <source>The folder is made.</source>
        <translation>Der Ordner wird angelegt.</translation>
    </message>
    <message>
        <source>The folder is not empty: write the name of a new one.</source>
        <translation>Der Ordner ist nicht leer: den Namen eines neuen eingeben.</translation>
    </message>
    <message>
        <source>The left button paints, with Shift it erases; beside the part and with Ctrl it turns the view. Esc ends it.</source>
        <translation>Die linke Taste malt, mit Umschalt radiert sie; neben dem Teil und mit Strg dreht sie die Ansicht. Esc beendet.</translation>
    </message>
    <message>
        <source>The library has no holders</source>
        <translation>Die Bibliothek hat keine Halter</translation>
    </message>
    <message>
        <source>The list had no tool for this operation: T%1 %2 was added to it. Change it to one that you have.</source>
        <translation>In der Liste war kein Werkzeug für diese Operation: T%1 %2 wurde hinzugefügt. In eines ändern, das vorhanden ist.</translation>
    </message>
    <message>
        <source>The machine “%1” has no rotary axis</source>
        <translation>Die Maschine „%1“ hat keine Drehachse</translation>
    </message>
    <message>
        <source>The manual at the place of what has the keys (F1)</source>
        <translation>Das Handbuch an der Stelle dessen, was die Tasten hat (F1)</translation>
    </message>
    <message>
        <source>The mesh has %1. It is machined as it is; the scan room makes it worth machining.</source>
        <translation>Das Netz hat %1. Es wird bearbeitet, wie es ist; im Scan-Raum lässt es sich instand setzen.</translation>
    </message>
    <message>
        <source>The other computer as ssh knows it, such as mill2 or user@mill2; it lets you in by a key</source>
        <translation>Der andere Rechner, wie ssh ihn kennt, etwa mill2 oder user@mill2; er lässt Sie mit einem Schlüssel ein</translation>
    </message>
    <message>
        <source>The page after (Alt+→)</source>
        <translation>Die nächste Seite (Alt+→)</translation>
    </message>
    <message>
        <source>The page before (Alt+←)</source>
        <translation>Die vorige Seite (Alt+←)</translation>
    </message>
    <message>
        <source>The part as it lies, as STL, 3MF or PLY</source>
        <translation>Das Teil, wie es liegt, als STL, 3MF oder PLY</translation>
    </message>
    <message>
        <source>The part as it lies, its stock and fixtures (F7)</source>
        <translation>Das Teil, wie es liegt, Rohteil und Spannmittel (F7)</translation>
    </message>
    <message>
        <source>The part has not been read.</source>
        <translation>Das Teil wurde nicht gelesen.</translation>
    </message>
    <message>
        <source>The part in the colours of what the verification found</source>
        <translation>Das Teil in den Farben dessen, was die Prüfung fand</translation>
    </message>
    <message>
        <source>The part in the colours of what the verification found (F9)</source>
        <translation>Das Teil in den Farben dessen, was die Prüfung fand (F9)</translation>
    </message>
    <message>
        <source>The part is %1 now, no longer as large as its file says. Cutters, allowances and tolerances stay as they are.</source>
        <translation>Das Teil ist jetzt %1 und nicht mehr so groß, wie seine Datei sagt. Fräser, Aufmaße und Toleranzen bleiben.</translation>
    </message>
    <message>
        <source>The part is %1 times as large as its file says; cutters and tolerances are not.</source>
        <translation>Das Teil ist %1-mal so groß, wie seine Datei sagt; Fräser und Toleranzen sind es nicht.</translation>
    </message>
    <message>
        <source>The part is being read…</source>
        <translation>Das Teil wird gelesen…</translation>
    </message>
    <message>
        <source>The part is not read yet: there is nothing to pick.</source>
        <translation>Das Teil ist noch nicht gelesen: es gibt nichts zu wählen.</translation>
    </message>
    <message>
        <source>The part is still being turned. Do that again when it stands.</source>
        <translation>Das Teil wird noch gedreht. Bitte wiederholen, wenn es steht.</translation>
    </message>
    <message>
        <source>The part lies across its stock: squared up, the block about it is %1 % smaller.</source>
        <translation>Das Teil liegt quer in seinem Rohteil: ausgerichtet wäre der Quader darum %1 % kleiner.</translation>
    </message>
    <message>
        <source>The part lies so already.</source>
        <translation>Das Teil liegt schon so.</translation>
    </message>
    <message>
        <source>The part turns under the tool</source>
        <translation>Das Teil dreht sich unter dem Werkzeug</translation>
    </message>
    <message>
        <source>The part was not read</source>
        <translation>Das Teil wurde nicht gelesen</translation>
    </message>
    <message>
        <source>The part's chord tolerance is fixed from now on: with another one the painted facets would be others. A boundary of faces stays without that.</source>
        <translation>Die Sehnentoleranz des Teils liegt von nun an fest: mit einer anderen wären die gemalten Facetten andere. Eine Begrenzung aus Flächen kommt ohne das aus.</translation>
    </message>
    <message>
        <source>The part's surface</source>
        <translation>Die Fläche des Teils</translation>
    </message>
    <message>
        <source>The path cannot be judged: %1.</source>
        <translation>Der Weg ist nicht beurteilbar: %1.</translation>
    </message>
    <message>
        <source>The path failed verification: %1.</source>
        <translation>Der Weg hat die Prüfung nicht bestanden: %1.</translation>
    </message>
    <message>
        <source>The path has not been verified since the project was changed.</source>
        <translation>Der Weg wurde seit der Änderung des Projekts nicht geprüft.</translation>
    </message>
    <message>
        <source>The path has not been verified.</source>
        <translation>Der Weg wurde nicht geprüft.</translation>
    </message>
    <message>
        <source>The path has not been verified. Verifying cuts an independent model of the stock with it and compares what is left with the part (F6).</source>
        <translation>Der Weg wurde nicht geprüft. Das Prüfen fräst damit ein unabhängiges Modell des Rohteils und vergleicht den Rest mit dem Teil (F6).</translation>
    </message>
    <message>
        <source>The paths of all operations, not that of the chosen one alone</source>
        <translation>Die Wege aller Operationen, nicht nur der gewählten</translation>
    </message>
    <message>
        <source>The paths on the part (F8)</source>
        <translation>Die Wege auf dem Teil (F8)</translation>
    </message>
    <message>
        <source>The picture that is seen, as PNG</source>
        <translation>Das Bild, das zu sehen ist, als PNG</translation>
    </message>
    <message>
        <source>The posture kept for the point is forgotten. Plan again to choose one.</source>
        <translation>Die festgehaltene Stellung des Punktes ist vergessen. Neu planen, um eine zu wählen.</translation>
    </message>
    <message>
        <source>The programs and their report are written into a folder: %1.</source>
        <translation>Die Programme und ihr Bericht werden in einen Ordner geschrieben: %1.</translation>
    </message>
    <message>
        <source>The project as it stands</source>
        <translation>Das Projekt, wie es ist</translation>
    </message>
    <message>
        <source>The project has changed since. What is shown here is of the plan as it was.</source>
        <translation>Das Projekt hat sich seither geändert. Gezeigt wird der Plan, wie er war.</translation>
    </message>
    <message>
        <source>The project has changed since: look again to be sure.</source>
        <translation>Das Projekt hat sich seither geändert: noch einmal suchen, um sicher zu sein.</translation>
    </message>
    <message>
        <source>The project's own file, %1, is newer: it was saved on %2. Restored, the older state is shown, and the file stays as it is until you save.</source>
        <translation>Die Datei des Projekts, %1, ist neuer: gespeichert am %2. Wiederhergestellt wird der ältere Stand gezeigt; die Datei bleibt bis zum Speichern, wie sie ist.</translation>
    </message>
    <message>
        <source>The project's own file, %1, is not there any more.</source>
        <translation>Die Datei des Projekts, %1, ist nicht mehr da.</translation>
    </message>
    <message>
        <source>The project's own file, %1, was last saved on %2, and stays as it is until you save.</source>
        <translation>Die Datei des Projekts, %1, wurde zuletzt am %2 gespeichert und bleibt bis zum Speichern, wie sie ist.</translation>
    </message>
    <message>
        <source>The quickest of these</source>
        <translation>Die schnellste von diesen</translation>
    </message>
    <message>
        <source>The raw material; during playback as it is cut</source>
        <translation>Das Rohmaterial; beim Abspielen, wie es gefräst wird</translation>
    </message>
    <message>
        <source>The recipe is not the one of the preview.</source>
        <translation>Das Rezept ist nicht das der Vorschau.</translation>
    </message>
    <message>
        <source>The recipe of the scan room was carried out</source>
        <translation>Das Rezept des Scan-Raums wurde ausgeführt</translation>
    </message>
    <message>
        <source>The setup that is shown</source>
        <translation>Die Aufspannung, die gezeigt wird</translation>
    </message>
    <message>
        <source>The stock as the tool cuts it (F10)</source>
        <translation>Das Rohteil, wie das Werkzeug es fräst (F10)</translation>
    </message>
    <message>
        <source>The study is not at its end: Resume goes on with it.</source>
        <translation>Die Studie ist nicht am Ende: Fortsetzen macht mit ihr weiter.</translation>
    </message>
    <message>
        <source>The study is of another part, %1: open its project first.</source>
        <translation>Die Studie gehört zu einem anderen Teil, %1: zuerst dessen Projekt öffnen.</translation>
    </message>
    <message>
        <source>The surface of the verdict with its deviations: as figures in PLY, as colours in 3MF and STL</source>
        <translation>Die Fläche des Urteils mit ihren Abweichungen: in PLY als Zahlen, in 3MF und STL als Farben</translation>
    </message>
    <message>
        <source>The template cannot be applied: %1</source>
        <translation>Die Vorlage kann nicht angewandt werden: %1</translation>
    </message>
    <message>
        <source>The template was not kept. %1</source>
        <translation>Die Vorlage wurde nicht aufbewahrt. %1</translation>
    </message>
    <message>
        <source>The tool at the picked point of the path</source>
        <translation>Das Werkzeug am gewählten Punkt des Wegs</translation>
    </message>
    <message>
        <source>The tool leans as little as it has to here: postures are kept for operations that choose them</source>
        <translation>Das Werkzeug neigt sich hier so wenig wie nötig: Stellungen werden bei Operationen behalten, die sie wählen</translation>
    </message>
    <message>
        <source>The tool leans with the surface, and leaves wide strips</source>
        <translation>Das Werkzeug neigt sich mit der Fläche und lässt breite Streifen</translation>
    </message>
    <message>
        <source>The tool leans, so that a flat or bull-nosed cutter leaves wide strips</source>
        <translation>Das Werkzeug neigt sich, sodass ein flacher oder torischer Fräser breite Streifen fräst</translation>
    </message>
    <message>
        <source>The tool's path</source>
        <translation>Die Bahn des Werkzeugs</translation>
    </message>
    <message>
        <source>The tried posture is not free: it would not be used</source>
        <translation>Die probierte Stellung ist nicht frei: sie würde nicht verwendet</translation>
    </message>
    <message>
        <source>The view shows the file's mesh, and tinted what the recipe takes away</source>
        <translation>Die Ansicht zeigt das Netz der Datei, getönt, was das Rezept wegnimmt</translation>
    </message>
    <message>
        <source>The view shows the stock as it stands when this operation has ended. The bar below the view plays it back.</source>
        <translation>Die Ansicht zeigt das Rohteil, wie es am Ende dieser Operation steht. Die Leiste darunter spielt es ab.</translation>
    </message>
    <message>
        <source>The view shows what the recipe makes, in colours of how far it moved, and tinted what is new</source>
        <translation>Die Ansicht zeigt, was das Rezept macht, in Farben dafür, wie weit es sich bewegte, getönt, was neu ist</translation>
    </message>
    <message>
        <source>The window speaks it after the next start.</source>
        <translation>Das Fenster spricht sie nach dem nächsten Start.</translation>
    </message>
    <message>
        <source>The winner has the least</source>
        <translation>Der Gewinner hat am wenigsten</translation>
    </message>
    <message>
        <source>The zero is on the axis of a %1 of Ø %2, which is round to %3.</source>
        <translation>Der Nullpunkt liegt auf der Achse: %1, Ø %2, rund auf %3.</translation>
    </message>
    <message>
        <source>There are no regions while a value is not right.</source>
        <translation>Solange ein Wert falsch ist, gibt es keine Bereiche.</translation>
    </message>
    <message>
        <source>There is a file of this name: write another one.</source>
        <translation>Eine Datei dieses Namens gibt es: einen anderen eingeben.</translation>
    </message>
    <message>
        <source>There is a template “%1”. Replace it?</source>
        <translation>Eine Vorlage „%1“ gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>There is no operation to plan: add one below the project tree.</source>
        <translation>Es gibt keine Operation zu planen: unter dem Projektbaum eine hinzufügen.</translation>
    </message>
    <message>
        <source>There is no operation to verify.</source>
        <translation>Es gibt keine Operation zu prüfen.</translation>
    </message>
    <message>
        <source>There is no operation yet. Add one below the tree.</source>
        <translation>Noch keine Operation. Unter dem Baum eine hinzufügen.</translation>
    </message>
    <message>
        <source>There is no sample “%1”</source>
        <translation>Es gibt kein Beispiel „%1“</translation>
    </message>
    <message>
        <source>There is nothing to adopt.</source>
        <translation>Es gibt nichts zu übernehmen.</translation>
    </message>
    <message>
        <source>There is nothing to compare</source>
        <translation>Es gibt nichts zu vergleichen</translation>
    </message>
    <message>
        <source>There is nothing to export yet: not every operation is planned as it stands. Press Plan (F5) first.</source>
        <translation>Noch nichts zu exportieren: nicht jede Operation ist geplant, wie sie dasteht. Zuerst Planen (F5).</translation>
    </message>
    <message>
        <source>There is nothing to export yet: this operation is not planned as it stands.</source>
        <translation>Noch nichts zu exportieren: diese Operation ist nicht geplant, wie sie dasteht.</translation>
    </message>
    <message>
        <source>There is nothing to tell yet: not every operation is planned as it stands. Press Plan (F5) first.</source>
        <translation>Noch nichts zu berichten: nicht jede Operation ist geplant, wie sie dasteht. Zuerst Planen (F5).</translation>
    </message>
    <message>
        <source>These are more than %1 combinations: let less vary, or try some of them.</source>
        <translation>Das sind mehr als %1 Kombinationen: weniger sich ändern lassen, oder einige davon versuchen.</translation>
    </message>
    <message>
        <source>These values make no cutter.
%1</source>
        <translation>Diese Werte ergeben keinen Fräser.
%1</translation>
    </message>
    <message>
        <source>Thicken a sheet</source>
        <translation>Fläche verdicken</translation>
    </message>
    <message>
        <source>This candidate has not been verified finely.</source>
        <translation>Dieser Kandidat ist nicht fein geprüft worden.</translation>
    </message>
    <message>
        <source>This is a file: choose a folder.</source>
        <translation>Das ist eine Datei: einen Ordner wählen.</translation>
    </message>
    <message>
        <source>This is more work than usual: a tolerance or a step-over may be too small.</source>
        <translation>Das ist mehr Arbeit als üblich: eine Toleranz oder ein Bahnabstand ist vielleicht zu klein.</translation>
    </message>
    <message>
        <source>This lead limit leaves the whole part uncut: raise it, or take a smaller tool.</source>
        <translation>Diese Grenze lässt das ganze Teil stehen: sie erhöhen oder ein kleineres Werkzeug nehmen.</translation>
    </message>
    <message>
        <source>This operation belongs to another setup. A double click in the tree goes there.</source>
        <translation>Diese Operation gehört zu einer anderen Aufspannung. Ein Doppelklick im Baum wechselt dorthin.</translation>
    </message>
    <message>
        <source>This recipe is in the project.</source>
        <translation>Dieses Rezept ist im Projekt.</translation>
    </message>
    <message>
        <source>This setup alone was judged, not the whole job.</source>
        <translation>Beurteilt wurde nur diese Aufspannung, nicht der ganze Auftrag.</translation>
    </message>
    <message>
        <source>Those that are ticked make the front; a limit is a number, or ×1.1 for 1.1 times what the project comes to</source>
        <translation>Die angekreuzten bilden die Front; eine Grenze ist eine Zahl, oder ×1,1 für das 1,1-Fache dessen, worauf das Projekt kommt</translation>
    </message>
    <message>
        <source>Tick the tools and strategies that may serve; write several numbers with a semicolon between them</source>
        <translation>Werkzeuge und Strategien ankreuzen, die taugen könnten; mehrere Zahlen mit einem Semikolon dazwischen schreiben</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>Zeit (%1)</translation>
    </message>
    <message>
        <source>Time (h)</source>
        <translation>Zeit (h)</translation>
    </message>
    <message>
        <source>Time (min)</source>
        <translation>Zeit (min)</translation>
    </message>
    <message>
        <source>Times as fast as the machine, or motions per second</source>
        <translation>Wievielmal so schnell wie die Maschine, oder Bewegungen je Sekunde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>To be kept small</source>
        <translation>Klein zu halten</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Nach rechts</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To&amp;wards, from X</source>
        <translation>Nac&amp;h, ab X</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Tool %1 does not touch at two places along it.</source>
        <translation>Werkzeug %1 berührt entlang davon nicht an zwei Stellen.</translation>
    </message>
    <message>
        <source>Tool %1 fits into it: its normals turn faster than the limit.</source>
        <translation>Werkzeug %1 passt hinein: die Normalen drehen sich schneller als die Grenze.</translation>
    </message>
    <message>
        <source>Tool %1 touches at %2 and %3 %4; it stays %5 above the bottom.</source>
        <translation>Werkzeug %1 berührt bei %2 und %3 %4; es bleibt %5 über dem Grund.</translation>
    </message>
    <message>
        <source>Tool axis by angles</source>
        <translation>Werkzeugachse durch Winkel</translation>
    </message>
    <message>
        <source>Tool axis by angles…</source>
        <translation>Werkzeugachse durch Winkel…</translation>
    </message>
    <message>
        <source>Tool axis of &lt;b&gt;%1&lt;/b&gt;, from the tip to the spindle, as the setup holds the part</source>
        <translation>Werkzeugachse von &lt;b&gt;%1&lt;/b&gt;, von der Spitze zur Spindel, wie die Aufspannung das Teil hält</translation>
    </message>
    <message>
        <source>Tool back to the planned posture</source>
        <translation>Werkzeug zurück in die geplante Stellung</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Werkzeugwechsel</translation>
    </message>
    <message>
        <source>Tool diameter (%1), lead limit %2</source>
        <translation>Werkzeugdurchmesser (%1), Grenze des Anstellwinkels %2</translation>
    </message>
    <message>
        <source>Tool libraries (*.fmtools *.json *.tools *.fctb *.fctl *.fcholder *.tbl);;All files (*)</source>
        <translation>Werkzeugbibliotheken (*.fmtools *.json *.tools *.fctb *.fctl *.fcholder *.tbl);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>Werkzeugbibliothek</translation>
    </message>
    <message>
        <source>Tool library…</source>
        <translation>Werkzeugbibliothek…</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Tools and templates are kept here; those of another folder stay there. Empty: %1</source>
        <translation>Werkzeuge und Vorlagen werden hier aufbewahrt; die eines anderen Ordners bleiben dort. Leer: %1</translation>
    </message>
    <message>
        <source>Tools of the library</source>
        <translation>Werkzeuge der Bibliothek</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Oben</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Trade-off</source>
        <translation>Abwägung</translation>
    </message>
    <message>
        <source>Triangles of the mesh</source>
        <translation>Dreiecke des Netzes</translation>
    </message>
    <message>
        <source>Tried: </source>
        <translation>Probiert: </translation>
    </message>
    <message>
        <source>Try a posture first: click in the configuration space, or drag a marker</source>
        <translation>Zuerst eine Stellung probieren: in den Konfigurationsraum klicken oder eine Marke ziehen</translation>
    </message>
    <message>
        <source>Trying the recipe</source>
        <translation>Das Rezept wird probiert</translation>
    </message>
    <message>
        <source>Turn about X</source>
        <translation>Um X drehen</translation>
    </message>
    <message>
        <source>Turn about Y</source>
        <translation>Um Y drehen</translation>
    </message>
    <message>
        <source>Turn about Z</source>
        <translation>Um Z drehen</translation>
    </message>
    <message>
        <source>Turn by 90°</source>
        <translation>Um 90° drehen</translation>
    </message>
    <message>
        <source>Turn facets</source>
        <translation>Facetten wenden</translation>
    </message>
    <message>
        <source>Turn part</source>
        <translation>Teil drehen</translation>
    </message>
    <message>
        <source>Turn part about %1</source>
        <translation>Teil um %1 drehen</translation>
    </message>
    <message>
        <source>Turn: Shift + middle button</source>
        <translation>Drehen: Umschalt + mittlere Taste</translation>
    </message>
    <message>
        <source>Turn: left button</source>
        <translation>Drehen: linke Taste</translation>
    </message>
    <message>
        <source>Turn: middle and left button, or Shift + right</source>
        <translation>Drehen: mittlere und linke Taste oder Umschalt + rechts</translation>
    </message>
    <message>
        <source>Turn: middle button</source>
        <translation>Drehen: mittlere Taste</translation>
    </message>
    <message>
        <source>Turned over about X, same zero</source>
        <translation>Um X gewendet, gleicher Nullpunkt</translation>
    </message>
    <message>
        <source>Turned over about Y, same zero</source>
        <translation>Um Y gewendet, gleicher Nullpunkt</translation>
    </message>
    <message>
        <source>Turning angle</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>Turns are by the right hand about the middle of the part's box. Rings and arrows in the view do the same by the mouse, with Shift in round steps. Scaling keeps that and the lowest point; cutters and tolerances stay as they are.</source>
        <translation>Drehungen erfolgen nach der rechten Hand um die Mitte des Quaders. Ringe und Pfeile in der Ansicht tun dasselbe mit der Maus, mit Umschalt in runden Schritten. Skalieren behält sie und den tiefsten Punkt; Fräser und Toleranzen bleiben.</translation>
    </message>
    <message>
        <source>Turns facets to agree with their neighbours and shells outward; doubles go.</source>
        <translation>Wendet Facetten wie ihre Nachbarn und Hüllen nach außen; doppelte gehen.</translation>
    </message>
    <message>
        <source>Turns the part about Z until its box is smallest, the longer side along X</source>
        <translation>Dreht das Teil um Z, bis sein Quader am kleinsten ist, die längere Seite entlang X</translation>
    </message>
    <message>
        <source>Turns the part by %190° about %2, by the right hand; its lowest point comes to Z 0</source>
        <translation>Dreht das Teil um %190° um %2, nach der rechten Hand; sein tiefster Punkt kommt auf Z 0</translation>
    </message>
    <message>
        <source>Turns the part so that it is longest along X and shortest along Z, by the moments of its surface</source>
        <translation>Dreht das Teil so, dass es entlang X am längsten und entlang Z am kürzesten ist, nach den Momenten seiner Fläche</translation>
    </message>
    <message>
        <source>Turns the part so that the face marked in the view comes down to Z 0</source>
        <translation>Dreht das Teil so, dass die in der Ansicht markierte Fläche auf Z 0 kommt</translation>
    </message>
    <message>
        <source>Two contacts</source>
        <translation>Zwei Berührpunkte</translation>
    </message>
    <message>
        <source>Two measures against each other; the line joins the best</source>
        <translation>Zwei Maße gegeneinander; die Linie verbindet die besten</translation>
    </message>
    <message>
        <source>Two numbers with a blank between them, %1; a semicolon between one pair and the next</source>
        <translation>Zwei Zahlen mit einem Leerzeichen dazwischen, %1; ein Semikolon zwischen einem Paar und dem nächsten</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>E&amp;inheit</translation>
    </message>
    <message>
        <source>Uncut</source>
        <translation>Stehen geblieben</translation>
    </message>
    <message>
        <source>Uncut, allowed %1</source>
        <translation>Stehen geblieben, erlaubt %1</translation>
    </message>
    <message>
        <source>Unit of the part</source>
        <translation>Einheit des Teils</translation>
    </message>
    <message>
        <source>Unit of the project: of all fields, reports and written programs</source>
        <translation>Einheit des Projekts: aller Felder, Berichte und geschriebenen Programme</translation>
    </message>
    <message>
        <source>Unpack in</source>
        <translation>Entpacken in</translation>
    </message>
    <message>
        <source>Unpack project</source>
        <translation>Projekt entpacken</translation>
    </message>
    <message>
        <source>Unpacked %1 files into %2.</source>
        <translation>%1 Dateien in %2 entpackt.</translation>
    </message>
    <message>
        <source>Unpacking %1</source>
        <translation>%1 wird entpackt</translation>
    </message>
    <message>
        <source>Unrolled</source>
        <translation>Abgewickelt</translation>
    </message>
    <message>
        <source>Unrolled path</source>
        <translation>Abgewickelter Weg</translation>
    </message>
    <message>
        <source>Unrolling the path</source>
        <translation>Der Weg wird abgewickelt</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Nicht gespeicherte Arbeit</translation>
    </message>
    <message>
        <source>Upward</source>
        <translation>Nach oben</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Verification failed (in %1): %2.</source>
        <translation>Prüfung nicht bestanden (in %1): %2.</translation>
    </message>
    <message>
        <source>Verification limits</source>
        <translation>Grenzen der Prüfung</translation>
    </message>
    <message>
        <source>Verification out of date</source>
        <translation>Prüfung veraltet</translation>
    </message>
    <message>
        <source>Verification out of date: the project has changed since</source>
        <translation>Prüfung veraltet: das Projekt hat sich seither geändert</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Verified in %1: %2: no gouge, no collision.</source>
        <translation>Geprüft in %1: %2: keine Verletzung, keine Kollision.</translation>
    </message>
    <message>
        <source>Verified in %1: no gouge, no collision.</source>
        <translation>Geprüft in %1: keine Verletzung, keine Kollision.</translation>
    </message>
    <message>
        <source>Verified: %1: no gouge, no collision</source>
        <translation>Geprüft: %1: keine Verletzung, keine Kollision</translation>
    </message>
    <message>
        <source>Verified: no gouge, no collision</source>
        <translation>Geprüft: keine Verletzung, keine Kollision</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Verify again</source>
        <translation>Erneut prüfen</translation>
    </message>
    <message>
        <source>Verify again (F6), or export programs that nobody has checked since.</source>
        <translation>Neu prüfen (F6), oder Programme exportieren, die seither niemand geprüft hat.</translation>
    </message>
    <message>
        <source>Verify all of them (F6), or export some that nobody has checked.</source>
        <translation>Alle prüfen (F6), oder einige exportieren, die niemand geprüft hat.</translation>
    </message>
    <message>
        <source>Verify all se&amp;tups</source>
        <translation>Alle Aufspann&amp;ungen prüfen</translation>
    </message>
    <message>
        <source>Verify all setups</source>
        <translation>Alle Aufspannungen prüfen</translation>
    </message>
    <message>
        <source>Verify anyway</source>
        <translation>Trotzdem prüfen</translation>
    </message>
    <message>
        <source>Verify first (F6), or export programs that nobody has checked.</source>
        <translation>Zuerst prüfen (F6) oder Programme exportieren, die niemand geprüft hat.</translation>
    </message>
    <message>
        <source>Verify up to this operation</source>
        <translation>Bis zu dieser Operation prüfen</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Wird geprüft</translation>
    </message>
    <message>
        <source>Verifying all setups</source>
        <translation>Alle Aufspannungen werden geprüft</translation>
    </message>
    <message>
        <source>Verifying was not begun, as it cannot be judged: %1.</source>
        <translation>Die Prüfung wurde nicht begonnen, weil es nicht beurteilbar ist: %1.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Eckpunkte</translation>
    </message>
    <message>
        <source>Vice: two jaws</source>
        <translation>Schraubstock: zwei Backen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>View of the candidate</source>
        <translation>Ansicht des Kandidaten</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Wasserdicht</translation>
    </message>
    <message>
        <source>Way of the tool tip (%1)</source>
        <translation>Weg der Werkzeugspitze (%1)</translation>
    </message>
    <message>
        <source>Wear</source>
        <translation>Verschleiß</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>What a tool leaves</source>
        <translation>Was ein Werkzeug stehen lässt</translation>
    </message>
    <message>
        <source>What all operations leave of the stock, as STL, 3MF or PLY</source>
        <translation>Was alle Operationen vom Rohteil übrig lassen, als STL, 3MF oder PLY</translation>
    </message>
    <message>
        <source>What came of each candidate, planned, judged coarsely and finely</source>
        <translation>Was aus jedem Kandidaten wurde: geplant, grob und fein geprüft</translation>
    </message>
    <message>
        <source>What is drawn to the right</source>
        <translation>Was nach rechts aufgetragen ist</translation>
    </message>
    <message>
        <source>What is drawn upward</source>
        <translation>Was nach oben aufgetragen ist</translation>
    </message>
    <message>
        <source>What is left and what is missing, in colours</source>
        <translation>Was stehen bleibt und was fehlt, in Farben</translation>
    </message>
    <message>
        <source>What is nearer is larger; there is no scale bar then (Shift+P)</source>
        <translation>Näheres ist größer; einen Maßstab gibt es dann nicht (Umschalt+P)</translation>
    </message>
    <message>
        <source>What is not saved cannot be kept for the case of a crash: %1. Save the project.</source>
        <translation>Nicht Gespeichertes kann für den Fall eines Absturzes nicht gesichert werden: %1. Das Projekt speichern.</translation>
    </message>
    <message>
        <source>What is wanted</source>
        <translation>Was gewünscht ist</translation>
    </message>
    <message>
        <source>What may vary</source>
        <translation>Was sich ändern darf</translation>
    </message>
    <message>
        <source>What the chart shows: the angles of the rotary axes, or the step-over along the part</source>
        <translation>Was das Diagramm zeigt: die Winkel der Drehachsen oder den Bahnabstand entlang des Teils</translation>
    </message>
    <message>
        <source>What the colours of the path mean; their scale stands in the view</source>
        <translation>Was die Farben des Wegs bedeuten; ihre Skala steht in der Ansicht</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Was die Datei enthält</translation>
    </message>
    <message>
        <source>What the recipe makes of it; of single holes and pieces what becomes of them</source>
        <translation>Was das Rezept daraus macht; bei einzelnen Löchern und Stücken, was aus ihnen wird</translation>
    </message>
    <message>
        <source>What the steps for all holes say of its size</source>
        <translation>Was die Schritte für alle Löcher zu seiner Größe sagen</translation>
    </message>
    <message>
        <source>What the study asks</source>
        <translation>Was die Studie fragt</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Was die Ansicht zeigt</translation>
    </message>
    <message>
        <source>What to do: a finish with the tool that fits; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: Schlichten mit dem Werkzeug, das dort passt; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What to do: a larger stock.</source>
        <translation>Was zu tun ist: ein größeres Rohteil.</translation>
    </message>
    <message>
        <source>What to do: a larger tool in %1, or verify up to the operation before it.</source>
        <translation>Was zu tun ist: ein größeres Werkzeug in %1, oder nur bis zu der Operation davor prüfen.</translation>
    </message>
    <message>
        <source>What to do: a larger tool in %1.</source>
        <translation>Was zu tun ist: ein größeres Werkzeug in %1.</translation>
    </message>
    <message>
        <source>What to do: a longer shank or flutes, a slimmer holder, or the part laid another way.</source>
        <translation>Was zu tun ist: längerer Schaft oder längere Schneiden, ein schlankerer Halter, oder das Teil anders legen.</translation>
    </message>
    <message>
        <source>What to do: a longer shank, a slimmer holder, or the part laid another way.</source>
        <translation>Was zu tun ist: ein längerer Schaft, ein schlankerer Halter, oder das Teil anders legen.</translation>
    </message>
    <message>
        <source>What to do: a smaller tool in Clean-up; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: ein kleineres Werkzeug in Restbearbeitung; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What to do: a stock that reaches lower, or Below the bottom where nothing holds it there.</source>
        <translation>Was zu tun ist: ein Rohteil, das tiefer reicht, oder „Unter dem Boden“, wo es dort nichts hält.</translation>
    </message>
    <message>
        <source>What to do: a tilt limit in %1, by which the tool leans there; or a longer shank, or a slimmer holder.</source>
        <translation>Was zu tun ist: eine Neigungsgrenze in %1, mit der sich das Werkzeug dort neigt; oder ein längerer Schaft, oder ein schlankerer Halter.</translation>
    </message>
    <message>
        <source>What to do: a tool with longer flutes, or a smaller allowance in Rough.</source>
        <translation>Was zu tun ist: ein Werkzeug mit längeren Schneiden, oder ein kleineres Aufmaß in Schruppen.</translation>
    </message>
    <message>
        <source>What to do: accept what stays, by Uncut limit in Verification limits: what a smaller tool than %1 leaves on a part so large is too fine to be judged.</source>
        <translation>Was zu tun ist: zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“. Was ein kleineres Werkzeug als %1 auf einem so großen Teil stehen lässt, ist zu fein, um beurteilt zu werden.</translation>
    </message>
    <message>
        <source>What to do: add %1, which cuts what is more level than %2 does.</source>
        <translation>Was zu tun ist: %1 hinzufügen, das fräst, was flacher ist, als %2 geht.</translation>
    </message>
    <message>
        <source>What to do: add %1, which goes round what is steeper than %2 cuts.</source>
        <translation>Was zu tun ist: %1 hinzufügen, das umfährt, was steiler ist, als %2 geht.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up with %1, which fits there.</source>
        <translation>Was zu tun ist: Restbearbeitung mit %1 hinzufügen, das dort passt.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up, or finish with a smaller tolerance.</source>
        <translation>Was zu tun ist: Restbearbeitung hinzufügen, oder mit kleinerer Toleranz schlichten.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up, which takes a smaller tool; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: Restbearbeitung hinzufügen, die ein kleineres Werkzeug nimmt; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What to do: add Rough before it, so that less stock stands there, or take a tool with longer flutes.</source>
        <translation>Was zu tun ist: davor Schruppen hinzufügen, damit dort weniger Rohteil steht, oder ein Werkzeug mit längeren Schneiden nehmen.</translation>
    </message>
    <message>
        <source>What to do: add Rough before the finish, which takes the stock away that is in the way.</source>
        <translation>Was zu tun ist: vor dem Schlichten Schruppen hinzufügen, das wegnimmt, was im Weg steht.</translation>
    </message>
    <message>
        <source>What to do: add another Clean-up, with a smaller tool after %1; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: eine weitere Restbearbeitung hinzufügen, mit einem kleineren Werkzeug nach %1; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What to do: finish with a smaller tolerance.</source>
        <translation>Was zu tun ist: mit kleinerer Toleranz schlichten.</translation>
    </message>
    <message>
        <source>What to do: move the fixture, or cut that place in a second setup.</source>
        <translation>Was zu tun ist: das Spannmittel versetzen oder diese Stelle in einer zweiten Aufspannung fräsen.</translation>
    </message>
    <message>
        <source>What to do: move the fixture, or keep the operation out of its way by a boundary.</source>
        <translation>Was zu tun ist: das Spannmittel versetzen oder die Operation durch eine Begrenzung davon fernhalten.</translation>
    </message>
    <message>
        <source>What to do: raise the clearance of the operation that the list names.</source>
        <translation>Was zu tun ist: den Sicherheitsabstand der Operation vergrößern, die in der Liste steht.</translation>
    </message>
    <message>
        <source>What to do: smaller tabs; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: kleinere Stege; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What to do: widen the boundary; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Was zu tun ist: die Begrenzung weiter fassen; oder zulassen, was stehen bleibt: „Grenze des Stehengebliebenen“ in „Grenzen der Prüfung“.</translation>
    </message>
    <message>
        <source>What varies, and what comes of it</source>
        <translation>Was sich ändert, und was daraus wird</translation>
    </message>
    <message>
        <source>What was kept of %1 is damaged, and is not used: plan again.</source>
        <translation>Was von %1 aufbewahrt war, ist beschädigt und wird nicht verwendet: neu planen.</translation>
    </message>
    <message>
        <source>What was planned before is kept: %1.</source>
        <translation>Was vorher geplant wurde, bleibt: %1.</translation>
    </message>
    <message>
        <source>What was planned is not kept with the project: %1.</source>
        <translation>Geplantes wird nicht mit dem Projekt aufbewahrt: %1.</translation>
    </message>
    <message>
        <source>Where candidates are planned and verified; a cluster and other computers see the folder under the same name, and have the same program in the same place</source>
        <translation>Wo Kandidaten geplant und geprüft werden; ein Cluster und andere Rechner sehen den Ordner unter demselben Namen und haben dasselbe Programm am selben Platz</translation>
    </message>
    <message>
        <source>While a boundary is painted</source>
        <translation>Während eine Begrenzung gemalt wird</translation>
    </message>
    <message>
        <source>Whose box the zero is on; it goes with it</source>
        <translation>Auf wessen Quader der Nullpunkt liegt; er geht mit ihm</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Warum nicht</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width, %1</source>
        <translation>Breite, %1</translation>
    </message>
    <message>
        <source>With D %1: </source>
        <translation>Mit D %1: </translation>
    </message>
    <message>
        <source>Words to look for</source>
        <translation>Zu suchende Wörter</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Arbeit</translation>
    </message>
    <message>
        <source>Work on</source>
        <translation>Arbeiten auf</translation>
    </message>
    <message>
        <source>Work zero</source>
        <translation>Werkstücknullpunkt</translation>
    </message>
    <message>
        <source>Working on the study</source>
        <translation>An der Studie wird gearbeitet</translation>
    </message>
    <message>
        <source>Write the chosen tools, or all that are shown, for another program</source>
        <translation>Die gewählten Werkzeuge, oder alle gezeigten, für ein anderes Programm schreiben</translation>
    </message>
    <message>
        <source>Write the project with its meshes, machines and posts into one file, to be sent</source>
        <translation>Das Projekt mit Netzen, Maschinen und Postprozessoren in eine Datei zum Verschicken schreiben</translation>
    </message>
    <message>
        <source>Write the whole path of a folder.</source>
        <translation>Den ganzen Pfad eines Ordners eingeben.</translation>
    </message>
    <message>
        <source>Writing a mesh</source>
        <translation>Ein Netz wird geschrieben</translation>
    </message>
    <message>
        <source>Writing programs</source>
        <translation>Programme werden geschrieben</translation>
    </message>
    <message>
        <source>Writing the setup sheet</source>
        <translation>Das Einrichteblatt wird geschrieben</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>In %1 geschrieben</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 geschrieben.</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n files into %1.</source>
        <translation><numerusform>%n Datei in %1 geschrieben.</numerusform><numerusform>%n Dateien in %1 geschrieben.</numerusform></translation>
    </message>
    <message>
        <source>Zero at %1 X, %2 Y of the box, as seen from above</source>
        <translation>Nullpunkt bei %1 X, %2 Y des Quaders, von oben gesehen</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>Nullpunkt hier</translation>
    </message>
    <message>
        <source>Zoom: wheel</source>
        <translation>Zoom: Rad</translation>
    </message>
    <message>
        <source>Zoom: wheel, or Ctrl + middle</source>
        <translation>Zoom: Rad oder Strg + Mitte</translation>
    </message>
    <message>
        <source>Zoom: wheel, or Shift + middle</source>
        <translation>Zoom: Rad oder Umschalt + Mitte</translation>
    </message>
    <message>
        <source>Zoom: wheel, or right button</source>
        <translation>Zoom: Rad oder rechte Taste</translation>
    </message>
    <message>
        <source>a Slurm cluster</source>
        <translation>einem Slurm-Cluster</translation>
    </message>
    <message>
        <source>a comma is not a decimal mark</source>
        <translation>ein Komma ist kein Dezimalzeichen</translation>
    </message>
    <message>
        <source>a few s left</source>
        <translation>noch einige s</translation>
    </message>
    <message>
        <source>a number has two marks</source>
        <translation>eine Zahl hat zwei Trennzeichen</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>über %1: %2</translation>
    </message>
    <message>
        <source>against</source>
        <translation>gegen</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>all combinations</source>
        <translation>alle Kombinationen</translation>
    </message>
    <message>
        <source>all of the cutter</source>
        <translation>der ganze Fräser</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>entlang Z</translation>
    </message>
    <message>
        <source>another computer, by SSH</source>
        <translation>einem anderen Rechner, über SSH</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>wie es ist</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>wie die Arbeitsumgebung</translation>
    </message>
    <message>
        <source>as the strip asks</source>
        <translation>wie es der Streifen verlangt</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>wie das System</translation>
    </message>
    <message>
        <source>ask each time</source>
        <translation>jedes Mal fragen</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>dahinter</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>below %1: %2</source>
        <translation>unter %1: %2</translation>
    </message>
    <message>
        <source>boss</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>by moved vertices</source>
        <translation>durch verschobene Eckpunkte</translation>
    </message>
    <message>
        <source>cancel the running job</source>
        <translation>die laufende Arbeit abbrechen</translation>
    </message>
    <message>
        <source>click or drag: the tool there; wheel: zoom; right drag: move; Home: all</source>
        <translation>klicken oder ziehen: Werkzeug dorthin; Rad: Zoom; rechts ziehen: verschieben; Pos1: alles</translation>
    </message>
    <message>
        <source>copy an operation in the tree, paste it here or in another project</source>
        <translation>eine Operation im Baum kopieren, hier oder in einem anderen Projekt einfügen</translation>
    </message>
    <message>
        <source>crossing found</source>
        <translation>Durchdringung gefunden</translation>
    </message>
    <message>
        <source>crossing left</source>
        <translation>Durchdringung bleibt</translation>
    </message>
    <message>
        <source>crossings found</source>
        <translation>Durchdringungen gefunden</translation>
    </message>
    <message>
        <source>crossings left</source>
        <translation>Durchdringungen bleiben</translation>
    </message>
    <message>
        <source>curvature matched (CM²)</source>
        <translation>krümmungsgleich (CM²)</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>did not pass</source>
        <translation>nicht bestanden</translation>
    </message>
    <message>
        <source>doubled facet gone</source>
        <translation>doppelte Facette entfernt</translation>
    </message>
    <message>
        <source>doubled facets gone</source>
        <translation>doppelte Facetten entfernt</translation>
    </message>
    <message>
        <source>edge gone</source>
        <translation>Kante entfernt</translation>
    </message>
    <message>
        <source>edge still against its neighbour</source>
        <translation>Kante noch gegen ihren Nachbarn</translation>
    </message>
    <message>
        <source>edge turned</source>
        <translation>Kante gedreht</translation>
    </message>
    <message>
        <source>edges between facets of opposite winding</source>
        <translation>Kanten zwischen Facetten entgegengesetzten Umlaufs</translation>
    </message>
    <message>
        <source>edges gone</source>
        <translation>Kanten entfernt</translation>
    </message>
    <message>
        <source>edges of more than two facets</source>
        <translation>Kanten von mehr als zwei Facetten</translation>
    </message>
    <message>
        <source>edges still against their neighbours</source>
        <translation>Kanten noch gegen ihre Nachbarn</translation>
    </message>
    <message>
        <source>edges turned</source>
        <translation>Kanten gedreht</translation>
    </message>
    <message>
        <source>edit the selected tool or the parameters of the selection</source>
        <translation>das gewählte Werkzeug oder die Parameter der Auswahl bearbeiten</translation>
    </message>
    <message>
        <source>end of a sheet</source>
        <translation>Ende einer Fläche</translation>
    </message>
    <message>
        <source>ends of sheets</source>
        <translation>Enden von Flächen</translation>
    </message>
    <message>
        <source>enter a number</source>
        <translation>eine Zahl eingeben</translation>
    </message>
    <message>
        <source>every order</source>
        <translation>jede Reihenfolge</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>exact, at the contact</source>
        <translation>genau, am Berührpunkt</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>Überstand</translation>
    </message>
    <message>
        <source>export programs and the report</source>
        <translation>Programme und den Bericht exportieren</translation>
    </message>
    <message>
        <source>faces %1</source>
        <translation>Flächen %1</translation>
    </message>
    <message>
        <source>facet added</source>
        <translation>Facette hinzugefügt</translation>
    </message>
    <message>
        <source>facet divided</source>
        <translation>Facette geteilt</translation>
    </message>
    <message>
        <source>facet gone</source>
        <translation>Facette entfernt</translation>
    </message>
    <message>
        <source>facet gone where both lie</source>
        <translation>Facette entfernt, wo beide liegen</translation>
    </message>
    <message>
        <source>facet in the section</source>
        <translation>Facette im Schnitt</translation>
    </message>
    <message>
        <source>facet joined on</source>
        <translation>Facette angefügt</translation>
    </message>
    <message>
        <source>facet left out: more than two on an edge</source>
        <translation>Facette ausgelassen: mehr als zwei an einer Kante</translation>
    </message>
    <message>
        <source>facet made anew</source>
        <translation>Facette neu gemacht</translation>
    </message>
    <message>
        <source>facet of the back</source>
        <translation>Facette der Rückseite</translation>
    </message>
    <message>
        <source>facet of the seam</source>
        <translation>Facette der Naht</translation>
    </message>
    <message>
        <source>facet of walls</source>
        <translation>Facette der Wände</translation>
    </message>
    <message>
        <source>facet turned</source>
        <translation>Facette gewendet</translation>
    </message>
    <message>
        <source>facets added</source>
        <translation>Facetten hinzugefügt</translation>
    </message>
    <message>
        <source>facets divided</source>
        <translation>Facetten geteilt</translation>
    </message>
    <message>
        <source>facets gone</source>
        <translation>Facetten entfernt</translation>
    </message>
    <message>
        <source>facets gone where both lie</source>
        <translation>Facetten entfernt, wo beide liegen</translation>
    </message>
    <message>
        <source>facets in the section</source>
        <translation>Facetten im Schnitt</translation>
    </message>
    <message>
        <source>facets joined on</source>
        <translation>Facetten angefügt</translation>
    </message>
    <message>
        <source>facets left out: more than two on an edge</source>
        <translation>Facetten ausgelassen: mehr als zwei an einer Kante</translation>
    </message>
    <message>
        <source>facets made anew</source>
        <translation>Facetten neu gemacht</translation>
    </message>
    <message>
        <source>facets of the back</source>
        <translation>Facetten der Rückseite</translation>
    </message>
    <message>
        <source>facets of the seam</source>
        <translation>Facetten der Naht</translation>
    </message>
    <message>
        <source>facets of walls</source>
        <translation>Facetten der Wände</translation>
    </message>
    <message>
        <source>facets that face the wrong side</source>
        <translation>verkehrt gewendete Facetten</translation>
    </message>
    <message>
        <source>facets that occur twice, kept</source>
        <translation>doppelt vorhandene Facetten, behalten</translation>
    </message>
    <message>
        <source>facets turned</source>
        <translation>Facetten gewendet</translation>
    </message>
    <message>
        <source>facets without area, left out</source>
        <translation>Facetten ohne Fläche, weggelassen</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>gefüllt</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>einpassen</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>flach</translation>
    </message>
    <message>
        <source>from edge to edge</source>
        <translation>von Kante zu Kante</translation>
    </message>
    <message>
        <source>from the tolerance</source>
        <translation>aus der Toleranz</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>goes</source>
        <translation>fällt weg</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>Verletzung</translation>
    </message>
    <message>
        <source>gouges up to %1</source>
        <translation>Verletzungen bis %1</translation>
    </message>
    <message>
        <source>half of the outline</source>
        <translation>die Hälfte des Umrisses</translation>
    </message>
    <message>
        <source>high</source>
        <translation>hoch</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>hole filled</source>
        <translation>Loch gefüllt</translation>
    </message>
    <message>
        <source>hole left as asked</source>
        <translation>Loch wie gewünscht offen</translation>
    </message>
    <message>
        <source>hole left that no patch fits</source>
        <translation>Loch bleibt, in das kein Flicken passt</translation>
    </message>
    <message>
        <source>hole that is not there</source>
        <translation>Loch, das es nicht gibt</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>Löcher</translation>
    </message>
    <message>
        <source>holes filled</source>
        <translation>Löcher gefüllt</translation>
    </message>
    <message>
        <source>holes left as asked</source>
        <translation>Löcher wie gewünscht offen</translation>
    </message>
    <message>
        <source>holes left that no patch fits</source>
        <translation>Löcher bleiben, in die kein Flicken passt</translation>
    </message>
    <message>
        <source>holes that are not there</source>
        <translation>Löcher, die es nicht gibt</translation>
    </message>
    <message>
        <source>in rings</source>
        <translation>in Ringen</translation>
    </message>
    <message>
        <source>into the panels: project, parameters, report and so on</source>
        <translation>in die Fenster: Projekt, Parameter, Bericht und so weiter</translation>
    </message>
    <message>
        <source>isometric, front, top, right, rear, bottom, left</source>
        <translation>isometrisch, vorn, oben, rechts, hinten, unten, links</translation>
    </message>
    <message>
        <source>judged coarsely</source>
        <translation>grob geprüft</translation>
    </message>
    <message>
        <source>judged finely</source>
        <translation>fein geprüft</translation>
    </message>
    <message>
        <source>keeps Z upright</source>
        <translation>hält Z aufrecht</translation>
    </message>
    <message>
        <source>larger hole left</source>
        <translation>größeres Loch bleibt</translation>
    </message>
    <message>
        <source>larger holes left</source>
        <translation>größere Löcher bleiben</translation>
    </message>
    <message>
        <source>larger place left</source>
        <translation>größere Stelle bleibt</translation>
    </message>
    <message>
        <source>larger places left</source>
        <translation>größere Stellen bleiben</translation>
    </message>
    <message>
        <source>lead %1, yaw %2</source>
        <translation>Anstellwinkel %1, Taumelwinkel %2</translation>
    </message>
    <message>
        <source>least</source>
        <translation>am wenigsten</translation>
    </message>
    <message>
        <source>left</source>
        <translation>übrig</translation>
    </message>
    <message>
        <source>left drag: paint (Shift: erase); Ctrl + left drag: turn; Esc: end</source>
        <translation>links ziehen: malen (Umschalt: radieren); Strg + links ziehen: drehen; Esc: beenden</translation>
    </message>
    <message>
        <source>left open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>left to clean-up</source>
        <translation>der Restbearbeitung überlassen</translation>
    </message>
    <message>
        <source>lengths as in the file</source>
        <translation>Längen wie in der Datei</translation>
    </message>
    <message>
        <source>less than %1 s</source>
        <translation>unter %1 s</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>loose pieces</source>
        <translation>lose Stücke</translation>
    </message>
    <message>
        <source>low</source>
        <translation>niedrig</translation>
    </message>
    <message>
        <source>main</source>
        <translation>Haupt</translation>
    </message>
    <message>
        <source>main %1 + rework %2 = %3; %4, %5 % of the surface</source>
        <translation>Haupt %1 + Nacharbeit %2 = %3; %4, %5 % der Fläche</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>messen</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>moved at most %1</source>
        <translation>höchstens %1 bewegt</translation>
    </message>
    <message>
        <source>needle left</source>
        <translation>Nadel bleibt</translation>
    </message>
    <message>
        <source>needles left</source>
        <translation>Nadeln bleiben</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>no faces yet</source>
        <translation>noch keine Flächen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>none: APT only</source>
        <translation>keine: nur APT</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>nicht angesehen</translation>
    </message>
    <message>
        <source>not planned, not checked</source>
        <translation>nicht geplant, nicht geprüft</translation>
    </message>
    <message>
        <source>not reached by any</source>
        <translation>von keinem erreicht</translation>
    </message>
    <message>
        <source>not watertight</source>
        <translation>nicht wasserdicht</translation>
    </message>
    <message>
        <source>nothing is entered</source>
        <translation>nichts ist eingegeben</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>nichts bewegt</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>nichts zu tun</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>of it the main path</source>
        <translation>davon der Hauptweg</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>one for each operation</source>
        <translation>eines für jede Operation</translation>
    </message>
    <message>
        <source>one motion back, on (← and → too while playing back; Shift: ten)</source>
        <translation>eine Bewegung zurück, weiter (beim Abspielen auch ← und →; Umschalt: zehn)</translation>
    </message>
    <message>
        <source>one ring</source>
        <translation>ein Ring</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>einseitig</translation>
    </message>
    <message>
        <source>one with tool changes</source>
        <translation>eines mit Werkzeugwechseln</translation>
    </message>
    <message>
        <source>open edges</source>
        <translation>offene Kanten</translation>
    </message>
    <message>
        <source>out</source>
        <translation>ausgeschieden</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>veraltet</translation>
    </message>
    <message>
        <source>over diameter</source>
        <translation>über dem Durchmesser</translation>
    </message>
    <message>
        <source>over lead limit</source>
        <translation>über der Grenze des Anstellwinkels</translation>
    </message>
    <message>
        <source>part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>pass %1, point %2</source>
        <translation>Bahn %1, Punkt %2</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>piece gone</source>
        <translation>Stück entfernt</translation>
    </message>
    <message>
        <source>pieces gone</source>
        <translation>Stücke entfernt</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>planen</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>geplant</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>abspielen, anhalten</translation>
    </message>
    <message>
        <source>remove the selected tool or operation</source>
        <translation>das gewählte Werkzeug oder die Operation entfernen</translation>
    </message>
    <message>
        <source>rename what is selected in the tree</source>
        <translation>umbenennen, was im Baum gewählt ist</translation>
    </message>
    <message>
        <source>rework</source>
        <translation>Nacharbeit</translation>
    </message>
    <message>
        <source>rolls freely</source>
        <translation>rollt frei</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>seam left open</source>
        <translation>Naht bleibt offen</translation>
    </message>
    <message>
        <source>seams left open</source>
        <translation>Nähte bleiben offen</translation>
    </message>
    <message>
        <source>section left open</source>
        <translation>Schnitt bleibt offen</translation>
    </message>
    <message>
        <source>sections left open</source>
        <translation>Schnitte bleiben offen</translation>
    </message>
    <message>
        <source>see what belongs to: prepare, plan, verify, simulate</source>
        <translation>sehen, was dazugehört: vorbereiten, planen, prüfen, simulieren</translation>
    </message>
    <message>
        <source>show the tool there; ← and → step along the path (Shift: by ten)</source>
        <translation>das Werkzeug dort zeigen; ← und → gehen am Weg entlang (Umschalt: zehn)</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>glatt</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>Rohteil</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>the %1's file “%2”</source>
        <translation>die Datei „%2“ (%1)</translation>
    </message>
    <message>
        <source>the display offers OpenGL %1.%2 only; 3.2 is needed</source>
        <translation>die Anzeige bietet nur OpenGL %1.%2; nötig ist 3.2</translation>
    </message>
    <message>
        <source>the display offers no OpenGL</source>
        <translation>die Anzeige bietet kein OpenGL</translation>
    </message>
    <message>
        <source>the manual, at the place of what has the keys</source>
        <translation>das Handbuch, an der Stelle dessen, was die Tasten hat</translation>
    </message>
    <message>
        <source>the other half</source>
        <translation>die andere Hälfte</translation>
    </message>
    <message>
        <source>the outline</source>
        <translation>der Umriss</translation>
    </message>
    <message>
        <source>the part's box</source>
        <translation>der Quader des Teils</translation>
    </message>
    <message>
        <source>the part's origin</source>
        <translation>der Ursprung des Teils</translation>
    </message>
    <message>
        <source>the posted program, %1 blocks</source>
        <translation>das ausgegebene Programm, %1 Sätze</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>das Projekt</translation>
    </message>
    <message>
        <source>the stock's box</source>
        <translation>der Quader des Rohteils</translation>
    </message>
    <message>
        <source>the tip</source>
        <translation>die Spitze</translation>
    </message>
    <message>
        <source>this computer</source>
        <translation>diesem Rechner</translation>
    </message>
    <message>
        <source>through two points</source>
        <translation>durch zwei Punkte</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>tried</source>
        <translation>probiert</translation>
    </message>
    <message>
        <source>turns back</source>
        <translation>kehrt um</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>rückgängig, wiederholen</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>unbenannt</translation>
    </message>
    <message>
        <source>up to Ø %1</source>
        <translation>bis Ø %1</translation>
    </message>
    <message>
        <source>up to “%1”</source>
        <translation>bis „%1“</translation>
    </message>
    <message>
        <source>use a point: 0.5</source>
        <translation>einen Punkt verwenden: 0.5</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>geprüft</translation>
    </message>
    <message>
        <source>verify</source>
        <translation>prüfen</translation>
    </message>
    <message>
        <source>vertex held against folds</source>
        <translation>Ecke gegen Falten gehalten</translation>
    </message>
    <message>
        <source>vertex moved</source>
        <translation>Ecke bewegt</translation>
    </message>
    <message>
        <source>vertex without a direction</source>
        <translation>Ecke ohne Richtung</translation>
    </message>
    <message>
        <source>vertices held against folds</source>
        <translation>Ecken gegen Falten gehalten</translation>
    </message>
    <message>
        <source>vertices moved</source>
        <translation>Ecken bewegt</translation>
    </message>
    <message>
        <source>vertices where shells touch</source>
        <translation>Eckpunkte, an denen sich Schalen berühren</translation>
    </message>
    <message>
        <source>vertices without a direction</source>
        <translation>Ecken ohne Richtung</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>watertight</source>
        <translation>wasserdicht</translation>
    </message>
    <message>
        <source>where it touches</source>
        <translation>wo er berührt</translation>
    </message>
    <message>
        <source>winner</source>
        <translation>Gewinner</translation>
    </message>
    <message>
        <source>with the configuration space in view: points along the pass, passes</source>
        <translation>wenn der Konfigurationsraum zu sehen ist: Punkte der Bahn, Bahnen</translation>
    </message>
    <message>
        <source>within %1</source>
        <translation>innerhalb %1</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>ohne %1</translation>
    </message>
    <message>
        <source>write %1 or %2</source>
        <translation>%1 oder %2 schreiben</translation>
    </message>
    <message>
        <source>write it without marks between thousands</source>
        <translation>sie ohne Tausendertrennzeichen schreiben</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>Ø %1</source>
        <translation>Ø %1</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>“%1” applied: %2</source>
        <translation>„%1“ angewandt: %2</translation>
    </message>
    <message>
        <source>“%1” cuts with three axes: no rotary axis moves</source>
        <translation>„%1“ fräst mit drei Achsen: keine Drehachse bewegt sich</translation>
    </message>
    <message>
        <source>“%1” has nothing to do: %2.</source>
        <translation>„%1“ hat nichts zu tun: %2.</translation>
    </message>
    <message>
        <source>“%1” has one pass only: there is no step-over</source>
        <translation>„%1“ hat nur eine Bahn: es gibt keinen Bahnabstand</translation>
    </message>
    <message>
        <source>“%1” is a folder: drop a project, or a mesh (%2).</source>
        <translation>„%1“ ist ein Ordner: ein Projekt oder ein Netz hineinziehen (%2).</translation>
    </message>
    <message>
        <source>“%1” is a picture of a kind that is not read as a relief: save it as PNG or TIFF, 8 or 16 bits of grey.</source>
        <translation>„%1“ ist ein Bild einer Art, die nicht als Relief gelesen wird: als PNG oder TIFF speichern, 8 oder 16 Bit Grau.</translation>
    </message>
    <message>
        <source>“%1” is not a length to grow by: enter a number, below 0 to shrink</source>
        <translation>„%1“ ist keine Länge zum Vergrößern: eine Zahl eingeben, unter 0 zum Verkleinern</translation>
    </message>
    <message>
        <source>“%1” is the part already.</source>
        <translation>„%1“ ist schon das Teil.</translation>
    </message>
    <message>
        <source>“%1” is the part now: %2 facets.</source>
        <translation>„%1“ ist jetzt das Teil: %2 Facetten.</translation>
    </message>
    <message>
        <source>“by moved vertices”</source>
        <translation>„durch verschobene Eckpunkte“</translation>
    </message>
    <message>
        <source>“from edge to edge”</source>
        <translation>„von Kante zu Kante“</translation>
    </message>
    <message>
        <source>“from the tolerance”</source>
        <translation>„aus der Toleranz“</translation>
    </message>
    <message>
        <source>“in rings”</source>
        <translation>„in Ringen“</translation>
    </message>
    <message>
        <source>“one way”</source>
        <translation>„einseitig“</translation>
    </message>
    <message>
        <source>… %1</source>
        <translation>… %1</translation>
    </message>
    <message>
        <source>… 95 % below</source>
        <translation>… 95 % unter</translation>
    </message>
    <message>
        <source>… 99 % below</source>
        <translation>… 99 % unter</translation>
    </message>
    <message>
        <source>… largest</source>
        <translation>… größter</translation>
    </message>
    <message>
        <source>… near open borders</source>
        <translation>… nahe offenen Rändern</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← Zurück</translation>
    </message>
    <message>
        <source>← →  ↑ ↓</source>
        <translation>← →  ↑ ↓</translation>
    </message>
</context>
</TS>
