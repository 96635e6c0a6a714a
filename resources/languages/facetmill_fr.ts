<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>core</name>
    <message>
        <source> (about {1} in all)</source>
        <translation> (environ {1} en tout)</translation>
    </message>
    <message>
        <source> but {1}</source>
        <translation> mais {1}</translation>
    </message>
    <message>
        <source> in the fixture '{1}'</source>
        <translation> dans le bridage '{1}'</translation>
    </message>
    <message>
        <source> in the part</source>
        <translation> dans la pièce</translation>
    </message>
    <message>
        <source> in the stock</source>
        <translation> dans le brut</translation>
    </message>
    <message>
        <source> of '{1}'</source>
        <translation> de '{1}'</translation>
    </message>
    <message>
        <source>'solid' expected</source>
        <translation>'solid' attendu</translation>
    </message>
    <message>
        <source>'{1}' begins inside the part.</source>
        <translation>'{1}' commence dans la pièce.</translation>
    </message>
    <message>
        <source>'{1}' cannot be read</source>
        <translation>'{1}' ne peut pas être lu</translation>
    </message>
    <message>
        <source>'{1}' cannot change tools, and the operations have several</source>
        <translation>'{1}' ne peut changer d'outil, et les opérations en ont plusieurs</translation>
    </message>
    <message>
        <source>'{1}' defines geometry or a variable</source>
        <translation>'{1}' définit de la géométrie ou une variable</translation>
    </message>
    <message>
        <source>'{1}' followed '{2}', which this setup does not have: it follows the outline now</source>
        <translation>« {1} » suivait « {2} », que ce montage n’a pas : elle suit maintenant le contour</translation>
    </message>
    <message>
        <source>'{1}' has a comma</source>
        <translation>'{1}' a une virgule</translation>
    </message>
    <message>
        <source>'{1}' has no '{2}'</source>
        <translation>'{1}' n'a pas de '{2}'</translation>
    </message>
    <message>
        <source>'{1}' has no decimal point, and the control would count its last digits</source>
        <translation>'{1}' n'a pas de point décimal, et la commande compterait ses derniers chiffres</translation>
    </message>
    <message>
        <source>'{1}' has no keys</source>
        <translation>'{1}' n'a pas de clés</translation>
    </message>
    <message>
        <source>'{1}' has two meanings</source>
        <translation>'{1}' a deux significations</translation>
    </message>
    <message>
        <source>'{1}' is a length, the field has none</source>
        <translation>'{1}' est une longueur, le champ n'en a pas</translation>
    </message>
    <message>
        <source>'{1}' is left over</source>
        <translation>'{1}' est en trop</translation>
    </message>
    <message>
        <source>'{1}' is no code of this control</source>
        <translation>'{1}' n'est pas un code de cette commande</translation>
    </message>
    <message>
        <source>'{1}' is no format of a tool library</source>
        <translation>'{1}' n'est pas un format de bibliothèque d'outils</translation>
    </message>
    <message>
        <source>'{1}' is no host</source>
        <translation>« {1} » n’est pas un hôte</translation>
    </message>
    <message>
        <source>'{1}' is no letter and number</source>
        <translation>'{1}' n'est pas une lettre et un nombre</translation>
    </message>
    <message>
        <source>'{1}' is no limit</source>
        <translation>« {1} » n'est pas une limite</translation>
    </message>
    <message>
        <source>'{1}' is no list</source>
        <translation>'{1}' n'est pas une liste</translation>
    </message>
    <message>
        <source>'{1}' is no meaning of a code</source>
        <translation>'{1}' n'est pas la signification d'un code</translation>
    </message>
    <message>
        <source>'{1}' is no name</source>
        <translation>'{1}' n'est pas un nom</translation>
    </message>
    <message>
        <source>'{1}' is no number</source>
        <translation>'{1}' n'est pas un nombre</translation>
    </message>
    <message>
        <source>'{1}' is no number or range of {2}</source>
        <translation>'{1}' n'est ni un numéro ni une plage : {2}</translation>
    </message>
    <message>
        <source>'{1}' is no operation, or stands twice</source>
        <translation>'{1}' n'est pas une opération, ou est écrit deux fois</translation>
    </message>
    <message>
        <source>'{1}' is no rung of a study</source>
        <translation>'{1}' n'est pas un échelon d'une étude</translation>
    </message>
    <message>
        <source>'{1}' is no share</source>
        <translation>'{1}' n'est pas une part</translation>
    </message>
    <message>
        <source>'{1}' is no such count</source>
        <translation>'{1}' n'est pas un tel nombre</translation>
    </message>
    <message>
        <source>'{1}' is no unit that this field can have</source>
        <translation>'{1}' n'est pas une unité que ce champ peut avoir</translation>
    </message>
    <message>
        <source>'{1}' is no word</source>
        <translation>'{1}' n'est pas un mot</translation>
    </message>
    <message>
        <source>'{1}' is no word of this control</source>
        <translation>'{1}' n'est pas un mot de cette commande</translation>
    </message>
    <message>
        <source>'{1}' is no word, or has a meaning</source>
        <translation>'{1}' n'est pas un mot, ou a une signification</translation>
    </message>
    <message>
        <source>'{1}' is not a finite number</source>
        <translation>'{1}' n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>'{1}' is not a number</source>
        <translation>'{1}' n'est pas un nombre</translation>
    </message>
    <message>
        <source>'{1}' is not a statement</source>
        <translation>'{1}' n'est pas une instruction</translation>
    </message>
    <message>
        <source>'{1}' is not a tool number</source>
        <translation>'{1}' n'est pas un numéro d'outil</translation>
    </message>
    <message>
        <source>'{1}' is not in the packed file</source>
        <translation>'{1}' n'est pas dans le fichier compressé</translation>
    </message>
    <message>
        <source>'{1}' is not known</source>
        <translation>'{1}' n'est pas connu</translation>
    </message>
    <message>
        <source>'{1}' is out of place</source>
        <translation>'{1}' n'est pas à sa place</translation>
    </message>
    <message>
        <source>'{1}' names no property</source>
        <translation>'{1}' ne nomme aucune propriété</translation>
    </message>
    <message>
        <source>'{1}' names no tool (LOADTL), and its cutter is not that of tool {2}: shank and holder are not known and were not judged.</source>
        <translation>'{1}' ne nomme pas d'outil (LOADTL), et sa fraise n'est pas celle de l'outil {2} : queue et porte-outil ne sont pas connus et n'ont pas été jugés.</translation>
    </message>
    <message>
        <source>'{1}' names no tool (LOADTL): its cutter is that of tool {2}, so shank and holder of that were judged.</source>
        <translation>'{1}' ne nomme pas d'outil (LOADTL) : sa fraise est celle de l'outil {2}, sa queue et son porte-outil ont donc été jugés.</translation>
    </message>
    <message>
        <source>'{1}' occurs twice</source>
        <translation>'{1}' apparaît deux fois</translation>
    </message>
    <message>
        <source>'{1}' stands behind what has a unit already</source>
        <translation>'{1}' suit ce qui a déjà une unité</translation>
    </message>
    <message>
        <source>'{1}' stands for no values</source>
        <translation>'{1}' ne désigne aucune valeur</translation>
    </message>
    <message>
        <source>'{1}' stands where values should</source>
        <translation>'{1}' est là où des valeurs devraient être</translation>
    </message>
    <message>
        <source>'{1}' was bounded by '{2}', which this setup does not have: it cuts everywhere now</source>
        <translation>'{1}' était limitée par '{2}', que ce posage n'a pas : elle usine partout maintenant</translation>
    </message>
    <message>
        <source>'{1}', GOTO {2}</source>
        <translation>'{1}', GOTO {2}</translation>
    </message>
    <message>
        <source>'{1}', GOTO {2}, where the axis turns {3}</source>
        <translation>'{1}', GOTO {2}, où l'axe tourne de {3}</translation>
    </message>
    <message>
        <source>'{1}', line {2}</source>
        <translation>'{1}', ligne {2}</translation>
    </message>
    <message>
        <source>'{1}', line {2}, where the axis turns {3}</source>
        <translation>'{1}', ligne {2}, où l'axe tourne de {3}</translation>
    </message>
    <message>
        <source>'{1}': '{2}' belongs to places of another part and was left behind</source>
        <translation>'{1}' : '{2}' appartient à des endroits d'une autre pièce et a été laissé</translation>
    </message>
    <message>
        <source>'{1}': the project has no tool {2}, so shank and holder are not known and were not judged.</source>
        <translation>'{1}' : le projet n'a pas d'outil {2}, queue et porte-outil ne sont donc pas connus et n'ont pas été jugés.</translation>
    </message>
    <message>
        <source>'{1}': {2} of {3} motions at feed are outside the stock.</source>
        <translation>'{1}' : {2} des {3} mouvements en avance sont hors du brut.</translation>
    </message>
    <message>
        <source>'{1}=' is no word of this control</source>
        <translation>'{1}=' n'est pas un mot de cette commande</translation>
    </message>
    <message>
        <source>, as at {1}, {2}, {3}</source>
        <translation>, comme à {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>, or a larger tilt limit</source>
        <translation>, ou une limite d’inclinaison plus grande</translation>
    </message>
    <message>
        <source>, or a tilt limit on a machine of five axes</source>
        <translation>, ou une limite d’inclinaison sur une machine à cinq axes</translation>
    </message>
    <message>
        <source>, or a tool that tilts (finish5)</source>
        <translation>, ou un outil qui s’incline (finish5)</translation>
    </message>
    <message>
        <source>0 for a sharp corner; half the diameter for a ball end.</source>
        <translation>0 pour un coin vif ; la moitié du diamètre pour une hémisphérique.</translation>
    </message>
    <message>
        <source>0 or more and below 90°</source>
        <translation>0 ou plus et sous 90°</translation>
    </message>
    <message>
        <source>0, 0, 0 of the part's coordinates, in which the programs are written; it is {1}, {2}, {3} (X, Y, Z) from the stock's lowest corner</source>
        <translation>0, 0, 0 des coordonnées de la pièce, dans lesquelles les programmes sont écrits ; elle est à {1}, {2}, {3} (X, Y, Z) du coin le plus bas du brut</translation>
    </message>
    <message>
        <source>1 change of tools, not in the time.</source>
        <translation>1 changement d'outil, non compris dans le temps.</translation>
    </message>
    <message>
        <source>1 collision, the deepest {1}</source>
        <translation>1 collision, la plus profonde de {1}</translation>
    </message>
    <message>
        <source>: it is no text</source>
        <translation> : ce n'est pas du texte</translation>
    </message>
    <message>
        <source>; more points are put in where it turns more</source>
        <translation> ; des points s'ajoutent où elle tourne davantage</translation>
    </message>
    <message>
        <source>A car body with four steep concave scoops, 12 × 6 in.</source>
        <translation>Une carrosserie avec quatre creux raides, 12 × 6 in.</translation>
    </message>
    <message>
        <source>A corner of the curve.</source>
        <translation>Un sommet de la courbe.</translation>
    </message>
    <message>
        <source>A domed surface with a winding gap between two walls, 6 × 5 in.</source>
        <translation>Une surface bombée avec une fente sinueuse entre deux parois, 6 × 5 in.</translation>
    </message>
    <message>
        <source>A long curved strip with concave blends, like a car's A-pillar, 20 × 6 in.</source>
        <translation>Une longue bande courbe à raccords concaves, comme un montant de pare-brise, 20 × 6 in.</translation>
    </message>
    <message>
        <source>A picture does not say how large it is: where the job does not either, it was taken as 100 mm wide and 5 mm high.</source>
        <translation>Une image ne dit pas sa taille : si le travail non plus, elle est prise pour 100 mm de large et 5 mm de haut.</translation>
    </message>
    <message>
        <source>A piece of the stock, {1} long, comes off at {2}.</source>
        <translation>Un morceau du brut, long de {1}, se détache à {2}.</translation>
    </message>
    <message>
        <source>A place on the part: the region nearest to it is meant.</source>
        <translation>Un endroit de la pièce : la zone la plus proche est visée.</translation>
    </message>
    <message>
        <source>A pocket with walls at 3° of draft, sharp inner corners and a boss on its floor, 100 × 80 mm.</source>
        <translation>Une poche aux parois à 3° de dépouille, coins rentrants vifs et un bossage au fond, 100 × 80 mm.</translation>
    </message>
    <message>
        <source>A program for each operation, or one for all with tool changes between.</source>
        <translation>Un programme par opération, ou un pour toutes avec des changements d'outil.</translation>
    </message>
    <message>
        <source>A solid without facets is in the file; it was ignored.</source>
        <translation>Le fichier contient un solide sans facettes ; il a été ignoré.</translation>
    </message>
    <message>
        <source>A square prism of side 45 mm, 60 mm long, that makes a quarter turn about the X axis.</source>
        <translation>Un prisme carré de côté 45 mm, 60 mm de long, qui fait un quart de tour autour de l'axe X.</translation>
    </message>
    <message>
        <source>A tool that cuts into the part is not inclined: the depth is above 0</source>
        <translation>Un outil qui usine dans la pièce n’est pas incliné : la profondeur est au-dessus de 0</translation>
    </message>
    <message>
        <source>A turns about X, B about Y, C about Z: mend the name or the direction</source>
        <translation>A tourne autour de X, B de Y, C de Z : corriger le nom ou la direction</translation>
    </message>
    <message>
        <source>About the middle</source>
        <translation>Autour du milieu</translation>
    </message>
    <message>
        <source>Accelerations</source>
        <translation>Accélérations</translation>
    </message>
    <message>
        <source>Advance along the axis in a turn: adaptive is everywhere the largest that leaves no cusp above the tolerance; a length is kept whatever it leaves. Of lengthwise lines: their distance at the part's largest radius.</source>
        <translation>Avance le long de l'axe par tour : adaptatif est partout la plus grande qui ne laisse pas de crête au-dessus de la tolérance ; une longueur est tenue, quoi qu'elle laisse. En lignes en long : leur distance au plus grand rayon de la pièce.</translation>
    </message>
    <message>
        <source>All but that: what was inside is outside.</source>
        <translation>Tout sauf cela : ce qui était dedans est dehors.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Surépaisseur</translation>
    </message>
    <message>
        <source>Along a curve</source>
        <translation>Le long d’une courbe</translation>
    </message>
    <message>
        <source>Along which the cylinder lies, through the middle of the part's box.</source>
        <translation>Selon lequel le cylindre est couché, par le milieu de la boîte de la pièce.</translation>
    </message>
    <message>
        <source>Also points left out</source>
        <translation>Aussi les points omis</translation>
    </message>
    <message>
        <source>Angle tolerance</source>
        <translation>Tolérance d'angle</translation>
    </message>
    <message>
        <source>Approach</source>
        <translation>Approche</translation>
    </message>
    <message>
        <source>Approach, retract</source>
        <translation>Approche, retrait</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Arcs</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Assumed lead limit</source>
        <translation>Limite supposée</translation>
    </message>
    <message>
        <source>Avoid</source>
        <translation>Éviter</translation>
    </message>
    <message>
        <source>Avoid by</source>
        <translation>Éviter de</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Axes of the machine</source>
        <translation>Axes de la machine</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis from</source>
        <translation>Axe de</translation>
    </message>
    <message>
        <source>Axis through</source>
        <translation>Axe par</translation>
    </message>
    <message>
        <source>Axis to</source>
        <translation>Axe à</translation>
    </message>
    <message>
        <source>Back of the surface</source>
        <translation>Dos de la surface</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Hémisphérique</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>Hémisphérique</translation>
    </message>
    <message>
        <source>Begin at</source>
        <translation>Commencer à</translation>
    </message>
    <message>
        <source>Below the bottom</source>
        <translation>Sous le fond</translation>
    </message>
    <message>
        <source>Between passes; 0 where nobody says.</source>
        <translation>Entre passes ; 0 si personne ne le dit.</translation>
    </message>
    <message>
        <source>Beyond the machine</source>
        <translation>Hors de la machine</translation>
    </message>
    <message>
        <source>Black is the top of a picture's relief and white its ground. What is transparent lies on the ground all the same.</source>
        <translation>Le noir est le haut du relief d'une image et le blanc son fond. Ce qui est transparent reste sur le fond.</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Cale</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Blocs</translation>
    </message>
    <message>
        <source>Body shell</source>
        <translation>Carrosserie</translation>
    </message>
    <message>
        <source>Bolt</source>
        <translation>Vis</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Dessous</translation>
    </message>
    <message>
        <source>Bottom angle</source>
        <translation>Angle de fond</translation>
    </message>
    <message>
        <source>Bound</source>
        <translation>Borne</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Boundary drags</source>
        <translation>Limites tirées</translation>
    </message>
    <message>
        <source>Bull</source>
        <translation>Torique</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>Torique</translation>
    </message>
    <message>
        <source>Bytes follow every facet of the binary STL file, as many as its attribute word says; they were skipped.</source>
        <translation>Des octets suivent chaque facette du fichier STL binaire, autant que dit son mot d'attribut ; ils ont été sautés.</translation>
    </message>
    <message>
        <source>Bytes follow the end of the mesh; they were ignored.</source>
        <translation>Des octets suivent la fin du maillage ; ils ont été ignorés.</translation>
    </message>
    <message>
        <source>CUTTER has {1} values</source>
        <translation>CUTTER a {1} valeurs</translation>
    </message>
    <message>
        <source>CUTTER is not a convex cutter: {1}</source>
        <translation>CUTTER n'est pas une fraise convexe : {1}</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Checking passes</source>
        <translation>Contrôle des passes</translation>
    </message>
    <message>
        <source>Chip load</source>
        <translation>Avance par dent</translation>
    </message>
    <message>
        <source>Chipload</source>
        <translation>Avance par dent</translation>
    </message>
    <message>
        <source>Choose global postures, and count the time, with what the machine's axes take to change their speed, where its file says.</source>
        <translation>Choisir les postures globales et compter le temps avec ce qu'il faut aux axes de la machine pour changer de vitesse, où son fichier le dit.</translation>
    </message>
    <message>
        <source>Choosing axes</source>
        <translation>Choix des axes</translation>
    </message>
    <message>
        <source>Choosing layers</source>
        <translation>Choix des niveaux</translation>
    </message>
    <message>
        <source>Choosing levels</source>
        <translation>Choix des niveaux</translation>
    </message>
    <message>
        <source>Chord tolerance</source>
        <translation>Tolérance de corde</translation>
    </message>
    <message>
        <source>Chosen: {1}</source>
        <translation>Choisi : {1}</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>Mandrin</translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation>Bride</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Distance de sécurité</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisions</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>Commentaire</translation>
    </message>
    <message>
        <source>Comparing tools</source>
        <translation>Comparaison des outils</translation>
    </message>
    <message>
        <source>Comparing with the part</source>
        <translation>Comparaison avec la pièce</translation>
    </message>
    <message>
        <source>Complex surface</source>
        <translation>Surface complexe</translation>
    </message>
    <message>
        <source>Concave surface</source>
        <translation>Surface concave</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>Cone-bottom bull nose</source>
        <translation>Torique à fond conique</translation>
    </message>
    <message>
        <source>Constant scallop</source>
        <translation>Crête constante</translation>
    </message>
    <message>
        <source>Contact points</source>
        <translation>Points de contact</translation>
    </message>
    <message>
        <source>Contact points (CC)</source>
        <translation>Points de contact (CC)</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Convex surface</source>
        <translation>Surface convexe</translation>
    </message>
    <message>
        <source>Core radius</source>
        <translation>Rayon du noyau</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Rayon de coin</translation>
    </message>
    <message>
        <source>Corners of a closed curve, which is looked at along Z.</source>
        <translation>Sommets d'une courbe fermée, regardée selon Z.</translation>
    </message>
    <message>
        <source>Counting steps from the border</source>
        <translation>Comptage des pas depuis le bord</translation>
    </message>
    <message>
        <source>Course of the passes: parallel drive planes.</source>
        <translation>Tracé des passes : plans directeurs parallèles.</translation>
    </message>
    <message>
        <source>Course of the tool: one helix, rings with steps between them, or lengthwise lines to and fro with turns between them.</source>
        <translation>Tracé de l'outil : une hélice, des anneaux avec des pas entre eux, ou des lignes en long aller et retour avec des rotations entre elles.</translation>
    </message>
    <message>
        <source>Crease</source>
        <translation>Pli</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Cusp</source>
        <translation>Crête</translation>
    </message>
    <message>
        <source>Cusps are known point by point for 5-axis operations only; the report has the largest one.</source>
        <translation>Les crêtes ne sont connues point par point que pour les opérations 5 axes ; le rapport a la plus grande.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Cut, {1}</source>
        <translation>Coupe, {1}</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Coupes</translation>
    </message>
    <message>
        <source>Cuts only where more than the tolerance stands of the stock, as raw material and the operations before left it.</source>
        <translation>N'usine que là où il reste du brut plus que la tolérance, tel que la matière brute et les opérations précédentes l'ont laissé.</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fraise</translation>
    </message>
    <message>
        <source>Cutter, elsewhere</source>
        <translation>Fraise, ailleurs</translation>
    </message>
    <message>
        <source>Cutter, near the contact</source>
        <translation>Fraise, près du contact</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>Cutting diameter. With a taper angle: where bottom and side line meet, below the corner rounding.</source>
        <translation>Diamètre de coupe. Avec un angle de cône : où se rencontrent les lignes de fond et de côté, sous l'arrondi du coin.</translation>
    </message>
    <message>
        <source>Cutting edges; 0 where nobody says. Feeds are worked out from a chip load by it.</source>
        <translation>Nombre de dents ; 0 si personne ne le dit. Les avances en sont calculées d'après l'avance par dent.</translation>
    </message>
    <message>
        <source>Cutting layers</source>
        <translation>Usinage des niveaux</translation>
    </message>
    <message>
        <source>Cutting steep surface by levels</source>
        <translation>Usinage des surfaces raides par niveaux</translation>
    </message>
    <message>
        <source>CuttingEdgeHeight is not said: all of its length is taken for flutes</source>
        <translation>CuttingEdgeHeight n'est pas dit : toute sa longueur est prise comme coupante</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Decimating</source>
        <translation>Décimation</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>Entaille la plus profonde</translation>
    </message>
    <message>
        <source>Deepest gouges</source>
        <translation>Entailles les plus profondes</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Depth of a cut</source>
        <translation>Profondeur d’une coupe</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Profondeur de passe</translation>
    </message>
    <message>
        <source>Depth, {1}</source>
        <translation>Profondeur, {1}</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Description</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Deviation ({1})</source>
        <translation>Écart ({1})</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Diamètre</translation>
    </message>
    <message>
        <source>Diameter of the section.</source>
        <translation>Diamètre de la section.</translation>
    </message>
    <message>
        <source>Diameter, {1}</source>
        <translation>Diamètre, {1}</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Direction from the tip to the spindle in the setup's coordinates, kept all along; 0, 0, 1 is upright. With another one the operation is planned as seen along it, X and Y turned with it the shortest way, and keeps above the bottom of the stock.</source>
        <translation>Direction de la pointe à la broche en coordonnées du posage, gardée tout du long ; 0, 0, 1 est vertical. Avec une autre, l'opération est planifiée comme vue le long d'elle, X et Y tournés avec elle par le plus court, et reste au-dessus du fond du brut.</translation>
    </message>
    <message>
        <source>Direction in which the trajectories are looked at to tell forward from backward motion.</source>
        <translation>Direction dans laquelle les trajectoires sont regardées pour distinguer marche avant et arrière.</translation>
    </message>
    <message>
        <source>Direction of travel of the main path: auto follows the assumed path along x and y and takes the one with less estimated time of main path and rework; a number is an angle from X.</source>
        <translation>Sens de l'avance du parcours principal : auto suit le parcours supposé selon x et y et prend celui au temps estimé le plus court avec la reprise ; un nombre est un angle depuis X.</translation>
    </message>
    <message>
        <source>Direction of travel of the rework path: auto is that of the main path; a number is an angle from X.</source>
        <translation>Sens de l'avance du parcours de reprise : auto est celui du parcours principal ; un nombre est un angle depuis X.</translation>
    </message>
    <message>
        <source>Direction of travel: auto picks x or y by the change of normals, 3-axis finishing the other one where that travels or leaves less; a number is an angle from X.</source>
        <translation>Sens de l'avance : auto choisit x ou y d'après la variation des normales, la finition 3 axes l'autre où cela parcourt ou laisse moins ; un nombre est un angle depuis X.</translation>
    </message>
    <message>
        <source>Distance between neighbouring drive planes: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Distance entre plans directeurs voisins : adaptatif est partout la plus grande que permet la tolérance ; une longueur est tenue, quelles que soient les crêtes.</translation>
    </message>
    <message>
        <source>Distance between neighbouring drive planes: adaptive is everywhere the largest that the tolerance allows; a length is kept.</source>
        <translation>Distance entre plans directeurs voisins : adaptatif est partout la plus grande que permet la tolérance ; une longueur est tenue.</translation>
    </message>
    <message>
        <source>Distance between neighbouring layers; from_tolerance is everywhere the largest that leaves no more than the tolerance above the allowance, at most the diameter, and puts lines closer where a floor stays.</source>
        <translation>Distance entre niveaux voisins ; d'après la tolérance est partout la plus grande qui ne laisse pas plus que la tolérance au-dessus de la surépaisseur, au plus le diamètre, et serre les lignes où un fond reste.</translation>
    </message>
    <message>
        <source>Distance between neighbouring passes over the surface: adaptive is everywhere what leaves cusps of the tolerance; a length is kept whatever cusps it leaves.</source>
        <translation>Distance entre passes voisines sur la surface : adaptatif est partout celle qui laisse des crêtes de la tolérance ; une longueur est tenue, quelles que soient les crêtes.</translation>
    </message>
    <message>
        <source>Distance between neighbouring passes, looked at from above: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Distance entre passes voisines, vue de dessus : adaptative, elle est partout la plus grande que la tolérance permette ; une longueur est respectée quelles que soient les crêtes qu’elle laisse.</translation>
    </message>
    <message>
        <source>Distance that shank and holder keep from the part.</source>
        <translation>Distance que queue et porte-outil gardent de la pièce.</translation>
    </message>
    <message>
        <source>Divide</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Dovetail</source>
        <translation>Queue d'aronde</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>Foret</translation>
    </message>
    <message>
        <source>Drill point</source>
        <translation>Pointe de foret</translation>
    </message>
    <message>
        <source>Elapsed time</source>
        <translation>Temps écoulé</translation>
    </message>
    <message>
        <source>Entry</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Even steps of the turning angle; more points are put in where the part asks for them. auto takes as few as the chord tolerance allows. Of lengthwise lines: lines per turn.</source>
        <translation>Pas égaux de l'angle de rotation ; des points s'ajoutent où la pièce le demande. auto en prend aussi peu que la tolérance de corde le permet. En lignes en long : lignes par tour.</translation>
    </message>
    <message>
        <source>Evens out a picture's relief, across six pixels or so; no height moves by more than this. A 500th of the relief height takes the steps of 256 greys away. 0: none.</source>
        <translation>Égalise le relief d'une image sur six pixels environ ; aucune hauteur ne bouge de plus. Un 500e de la hauteur du relief enlève les marches de 256 gris. 0 : aucun.</translation>
    </message>
    <message>
        <source>Extruded pattern</source>
        <translation>Motif extrudé</translation>
    </message>
    <message>
        <source>FEDRAT without a value</source>
        <translation>FEDRAT sans valeur</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Faces</translation>
    </message>
    <message>
        <source>Facet edges</source>
        <translation>Arêtes des facettes</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facettes</translation>
    </message>
    <message>
        <source>Facets for surfaces</source>
        <translation>Facettes pour surfaces</translation>
    </message>
    <message>
        <source>Fanuc, TCP with rotary axes (G43.4)</source>
        <translation>Fanuc, TCP à axes rotatifs (G43.4)</translation>
    </message>
    <message>
        <source>Fanuc, TCP with tool vectors (G43.5)</source>
        <translation>Fanuc, TCP à vecteurs d'outil (G43.5)</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Angle d'arête</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Feed, {1}/min</source>
        <translation>Avance, {1}/min</translation>
    </message>
    <message>
        <source>Feeds and speeds</source>
        <translation>Avances et vitesses</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>Files of this format have Y pointing up: the part was turned so that Z does.</source>
        <translation>Dans les fichiers de ce format, Y pointe vers le haut : la pièce a été tournée pour que ce soit Z.</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplissage</translation>
    </message>
    <message>
        <source>Filling a hole</source>
        <translation>Remplissage d'un trou</translation>
    </message>
    <message>
        <source>Filling holes</source>
        <translation>Remplissage des trous</translation>
    </message>
    <message>
        <source>Finding rework regions</source>
        <translation>Recherche des zones de reprise</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Constats</translation>
    </message>
    <message>
        <source>Finish, 3-axis</source>
        <translation>Finition, 3 axes</translation>
    </message>
    <message>
        <source>Finish, 5-axis</source>
        <translation>Finition, 5 axes</translation>
    </message>
    <message>
        <source>Finish, turning part</source>
        <translation>Finition, pièce tournante</translation>
    </message>
    <message>
        <source>Finishing allowance</source>
        <translation>Surépaisseur de finition</translation>
    </message>
    <message>
        <source>Finishing with five axes</source>
        <translation>Finition en cinq axes</translation>
    </message>
    <message>
        <source>First curve</source>
        <translation>Première courbe</translation>
    </message>
    <message>
        <source>First point of an axis through two points.</source>
        <translation>Premier point d'un axe par deux points.</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Bridage</translation>
    </message>
    <message>
        <source>Fixture '{1}'</source>
        <translation>Bridage '{1}'</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Bridages</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>Plat</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>Plat</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Flute length</source>
        <translation>Longueur de coupe</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Dents</translation>
    </message>
    <message>
        <source>Following curves</source>
        <translation>Suivi des courbes</translation>
    </message>
    <message>
        <source>Following levels</source>
        <translation>Suivi des niveaux</translation>
    </message>
    <message>
        <source>Following the assumed path</source>
        <translation>Suivi du parcours supposé</translation>
    </message>
    <message>
        <source>Following the part</source>
        <translation>Suivi de la pièce</translation>
    </message>
    <message>
        <source>Following valleys</source>
        <translation>Suivi des vallées</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pied</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Free volume</source>
        <translation>Volume libre</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>From a radial line through the tip up to the bottom: 0 for a flat bottom; a cone of half angle w has 90° less w.</source>
        <translation>D'une ligne radiale par la pointe jusqu'au fond : 0 pour un fond plat ; un cône de demi-angle w a 90° moins w.</translation>
    </message>
    <message>
        <source>From and to: 0 is level, 90 an upright wall, more an underside.</source>
        <translation>De et à : 0 est horizontal, 90 une paroi verticale, plus un dessous.</translation>
    </message>
    <message>
        <source>From radius</source>
        <translation>À partir du rayon</translation>
    </message>
    <message>
        <source>From the axis to the side: positive when the tool widens upward, negative for a dovetail.</source>
        <translation>De l'axe au côté : positif quand l'outil s'élargit vers le haut, négatif pour une queue d'aronde.</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Avant</translation>
    </message>
    <message>
        <source>Front jaw</source>
        <translation>Mors avant</translation>
    </message>
    <message>
        <source>GODLTA has no place to start from</source>
        <translation>GODLTA n'a pas d'endroit d'où partir</translation>
    </message>
    <message>
        <source>GODLTA has {1} values</source>
        <translation>GODLTA a {1} valeurs</translation>
    </message>
    <message>
        <source>GODLTA leaves the range of coordinates</source>
        <translation>GODLTA sort de l'étendue des coordonnées</translation>
    </message>
    <message>
        <source>GOTO {1} of '{2}'</source>
        <translation>GOTO {1} de '{2}'</translation>
    </message>
    <message>
        <source>Generic mill (3-axis)</source>
        <translation>Fraiseuse générique (3 axes)</translation>
    </message>
    <message>
        <source>Generic mill with rotary table A (4-axis)</source>
        <translation>Fraiseuse générique à table rotative A (4 axes)</translation>
    </message>
    <message>
        <source>Generic tilting head B, rotary table C (5-axis, head-table)</source>
        <translation>Tête inclinable B générique, table rotative C (5 axes, tête-table)</translation>
    </message>
    <message>
        <source>Generic trunnion A/C (5-axis, table-table)</source>
        <translation>Berceau générique A/C (5 axes, table-table)</translation>
    </message>
    <message>
        <source>Generic trunnion B/C (5-axis, table-table)</source>
        <translation>Berceau générique B/C (5 axes, table-table)</translation>
    </message>
    <message>
        <source>Global-local CM²</source>
        <translation>CM² global-local</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Entaille</translation>
    </message>
    <message>
        <source>Gouge limit</source>
        <translation>Limite d'entaille</translation>
    </message>
    <message>
        <source>Grbl 1.1</source>
        <translation>Grbl 1.1</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Haas, TCPC (G234)</source>
        <translation>Haas, TCPC (G234)</translation>
    </message>
    <message>
        <source>Heidenhain, TCPM with rotary axes (M128)</source>
        <translation>Heidenhain, TCPM à axes rotatifs (M128)</translation>
    </message>
    <message>
        <source>Heidenhain, TCPM with tool vectors (LN)</source>
        <translation>Heidenhain, TCPM à vecteurs d'outil (LN)</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height between neighbouring levels: adaptive is everywhere the largest that the tolerance allows; a length is kept whatever cusps it leaves.</source>
        <translation>Hauteur entre deux niveaux voisins : adaptatif est partout la plus grande que la tolérance permet ; une longueur est respectée quelles que soient les crêtes qu'elle laisse.</translation>
    </message>
    <message>
        <source>Height of level rapid moves above part and stock on their way; to the first pass and from the last, above the highest of them.</source>
        <translation>Hauteur des rapides horizontaux au-dessus de la pièce et du brut sur leur chemin ; vers la première passe et depuis la dernière, au-dessus du plus haut des deux.</translation>
    </message>
    <message>
        <source>Height of the cutting part above the tip.</source>
        <translation>Hauteur de la partie coupante au-dessus de la pointe.</translation>
    </message>
    <message>
        <source>Highest lift that clears the strip</source>
        <translation>Plus haute levée qui enlève la bande</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Porte-outil</translation>
    </message>
    <message>
        <source>Holder clearance</source>
        <translation>Distance du porte-outil</translation>
    </message>
    <message>
        <source>Hole, left open</source>
        <translation>Trou, laissé ouvert</translation>
    </message>
    <message>
        <source>Hole, to be filled</source>
        <translation>Trou, à remplir</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Creux</translation>
    </message>
    <message>
        <source>How deep surface may come to lie inside a cutter before it counts as a gouge; `auto`: twice the chord tolerance that the paths keep.</source>
        <translation>De combien la surface peut entrer dans une fraise avant que ce soit une entaille ; auto : le double de la tolérance de corde que tiennent les parcours.</translation>
    </message>
    <message>
        <source>How far below the surface the cutter goes, along its axis. 0 stays on it.</source>
        <translation>De combien la fraise descend sous la surface, le long de son axe. 0 reste dessus.</translation>
    </message>
    <message>
        <source>How far beside the centre line the cutter runs, so that a ball does not cut with its tip.</source>
        <translation>De combien la fraise passe à côté de la ligne médiane, pour qu'une boule ne coupe pas de sa pointe.</translation>
    </message>
    <message>
        <source>How far beside the curve, on the side that is chosen. auto is the cutter's radius and the allowance, so that the cutter touches the curve.</source>
        <translation>À quelle distance de la courbe, du côté choisi. auto est le rayon de la fraise plus la surépaisseur, de sorte que la fraise touche la courbe.</translation>
    </message>
    <message>
        <source>How far cutter, shank and holder keep from these facets.</source>
        <translation>À quelle distance fraise, queue et porte-outil restent de ces facettes.</translation>
    </message>
    <message>
        <source>How far facets may lie from the surfaces of a STEP or IGES file. auto is a tenth of the finest tolerance of the operations; painted facets stay what they are where a length is given.</source>
        <translation>De combien les facettes peuvent s'écarter des surfaces d'un fichier STEP ou IGES. auto est un dixième de la plus fine tolérance des opérations ; les facettes peintes restent ce qu'elles sont quand une longueur est donnée.</translation>
    </message>
    <message>
        <source>How far its boundary lies outside the offset; inside below 0, but never inside of what is uncut.</source>
        <translation>De combien la limite dépasse le décalage ; en dedans sous 0, mais jamais dans ce qui n'est pas usiné.</translation>
    </message>
    <message>
        <source>How far motions may run beside the exact path</source>
        <translation>De combien les mouvements peuvent s'écarter du parcours exact</translation>
    </message>
    <message>
        <source>How far motions may run beside the exact path, to either side</source>
        <translation>De combien les mouvements peuvent s'écarter du parcours exact, de chaque côté</translation>
    </message>
    <message>
        <source>How far one of several cuts goes below the one before.</source>
        <translation>De combien une coupe, parmi plusieurs, descend sous la précédente.</translation>
    </message>
    <message>
        <source>How far passes go on over what the previous tool has cut; auto is half the tool's radius.</source>
        <translation>De combien les passes continuent sur ce que l'outil précédent a usiné ; auto est la moitié du rayon de l'outil.</translation>
    </message>
    <message>
        <source>How far rework goes beyond the uncut places, so that the two paths overlap.</source>
        <translation>De combien la reprise dépasse les endroits non usinés, pour que les deux parcours se recouvrent.</translation>
    </message>
    <message>
        <source>How far straight moves may run beside the exact path, to either side</source>
        <translation>De combien les mouvements droits peuvent s'écarter du parcours exact, de chaque côté</translation>
    </message>
    <message>
        <source>How far the cutter leans along the axis, away from square to it.</source>
        <translation>De combien la fraise penche le long de l'axe, hors de la perpendiculaire.</translation>
    </message>
    <message>
        <source>How far the cutter may go below the bottom of the stock, where something holds it. With 0 steep surface near the bottom keeps what only a lower tip would cut.</source>
        <translation>De combien la fraise peut aller sous le fond du brut, où quelque chose le tient. Avec 0, une surface raide près du fond garde ce que seule une pointe plus basse usinerait.</translation>
    </message>
    <message>
        <source>How far the inclination is turned about the surface normal, to the left of the travel; to the right below 0.</source>
        <translation>De combien l'inclinaison est tournée autour de la normale, à gauche de l'avance ; à droite sous 0.</translation>
    </message>
    <message>
        <source>How far the inclination may turn about the surface normal, to the right (below 0) and to the left of the travel.</source>
        <translation>De combien l'inclinaison peut tourner autour de la normale, à droite (sous 0) et à gauche de l'avance.</translation>
    </message>
    <message>
        <source>How far the true surface may lie outside and inside the mesh. 0 takes the mesh as the part; of STEP and IGES files what was measured counts, where that is more.</source>
        <translation>De combien la vraie surface peut être hors et dans le maillage. 0 prend le maillage pour la pièce ; des fichiers STEP et IGES compte ce qui a été mesuré, si c'est plus.</translation>
    </message>
    <message>
        <source>How far white lies above black, which is Z 0; of floating point numbers the highest above the lowest. `auto`: 5 mm, with a warning.</source>
        <translation>De combien le blanc est au-dessus du noir, qui est Z 0 ; en nombres flottants le plus haut au-dessus du plus bas. auto : 5 mm, avec un avertissement.</translation>
    </message>
    <message>
        <source>How long a picture is along Y, from its lowest row to its highest. `auto`: as its pixels are, square.</source>
        <translation>Longueur d'une image selon Y, de la ligne la plus basse à la plus haute. auto : selon ses pixels, carrés.</translation>
    </message>
    <message>
        <source>How many facets the part had when they were painted. Where it has another number now, they are no longer known.</source>
        <translation>Combien de facettes la pièce avait quand elles ont été peintes. Si elle en a un autre nombre, elles ne sont plus connues.</translation>
    </message>
    <message>
        <source>How much deeper each pass goes than the one before, from the stock's outside towards the axis.</source>
        <translation>De combien chaque passe va plus bas que la précédente, de l'extérieur du brut vers l'axe.</translation>
    </message>
    <message>
        <source>How much the normals of facets side by side may differ on a surface of a STEP or IGES file.</source>
        <translation>De combien les normales de facettes voisines peuvent différer sur une surface d'un fichier STEP ou IGES.</translation>
    </message>
    <message>
        <source>How often the curve is gone along, each time deeper; the last one is the depth.</source>
        <translation>Combien de fois la courbe est suivie, chaque fois plus bas ; la dernière est à la profondeur.</translation>
    </message>
    <message>
        <source>How the allowance is kept: contact is exact; vertices moves every vertex along its normal, cruder, and says what it cuts beyond.</source>
        <translation>Comment la surépaisseur est tenue : au contact est exact ; par sommets déplacés déplace chaque sommet le long de sa normale, plus grossier, et dit ce qui est coupé au-delà.</translation>
    </message>
    <message>
        <source>How the tool comes into material where it cannot come from outside: auto takes a ramp along the first cut, or a helix where that is too short; plunge goes straight down.</source>
        <translation>Comment l'outil entre dans la matière où il ne peut venir du dehors : auto prend une rampe le long de la première coupe, ou une hélice où elle est trop courte ; plongée descend tout droit.</translation>
    </message>
    <message>
        <source>How the tool is moved out of what it would cut: along a vector fitted to the strip, or along Z.</source>
        <translation>Comment l'outil est sorti de ce qu'il entaillerait : le long d'un vecteur ajusté à la bande, ou selon Z.</translation>
    </message>
    <message>
        <source>How the tool is run, by material. Operations take it over when they take the tool.</source>
        <translation>Conditions de coupe de l'outil, par matière. Les opérations les reprennent avec l'outil.</translation>
    </message>
    <message>
        <source>How tool axes are chosen: cm2 matches curvatures, local stays closest to one axis point by point, global takes the path that needs least machining time.</source>
        <translation>Choix des axes d'outil : à courbure ajustée (CM²) accorde les courbures, locale reste point par point au plus près d'un axe, globale prend le parcours au temps d'usinage le plus court.</translation>
    </message>
    <message>
        <source>How wide a picture (PNG, TIFF) is as a part, along X from its first column to its last. `auto`: 100 mm, with a warning.</source>
        <translation>Largeur d'une image (PNG, TIFF) comme pièce, selon X de la première colonne à la dernière. auto : 100 mm, avec un avertissement.</translation>
    </message>
    <message>
        <source>Inclination of the tool axis from the surface normal towards the travel. The lead limits do not hold it.</source>
        <translation>Inclinaison de l'axe d'outil depuis la normale vers l'avance. Les limites d'attaque ne la concernent pas.</translation>
    </message>
    <message>
        <source>Indexing the part</source>
        <translation>Indexation de la pièce</translation>
    </message>
    <message>
        <source>Into the material; 0: half the feed.</source>
        <translation>Dans la matière ; 0 : la moitié de l'avance.</translation>
    </message>
    <message>
        <source>Invalid</source>
        <translation>Non valable</translation>
    </message>
    <message>
        <source>Invert</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Isometric</source>
        <translation>Isométrique</translation>
    </message>
    <message>
        <source>Its axes and speeds decide the machining time.</source>
        <translation>Ses axes et ses vitesses décident du temps d'usinage.</translation>
    </message>
    <message>
        <source>Jasra's turned cylinder: Ø40 mm, 25 mm long, about the X axis.</source>
        <translation>Cylindre tourné de Jasra : Ø40 mm, 25 mm de long, autour de l'axe X.</translation>
    </message>
    <message>
        <source>Jasra's turned prism: side 50 mm, 40 mm long, about the X axis.</source>
        <translation>Prisme tourné de Jasra : côté 50 mm, 40 mm de long, autour de l'axe X.</translation>
    </message>
    <message>
        <source>Joining scans</source>
        <translation>Jonction des scans</translation>
    </message>
    <message>
        <source>Joins closed passes that lie within each other to one, whose turns go evenly from each to the next.</source>
        <translation>Joint les passes fermées emboîtées en une seule, dont les tours vont régulièrement de chacune à la suivante.</translation>
    </message>
    <message>
        <source>Joint rate</source>
        <translation>Vitesse des axes</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Kept off</source>
        <translation>Évité</translation>
    </message>
    <message>
        <source>Kept postures</source>
        <translation>Postures gardées</translation>
    </message>
    <message>
        <source>Kept within</source>
        <translation>Gardé dedans</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Kind of motion</source>
        <translation>Type de mouvement</translation>
    </message>
    <message>
        <source>Largest distance between neighbouring lines of a layer, at most the diameter; auto is 0.95 of the diameter.</source>
        <translation>Plus grande distance entre lignes voisines d'un niveau, au plus le diamètre ; auto est 0,95 du diamètre.</translation>
    </message>
    <message>
        <source>Largest excess</source>
        <translation>Plus grand excédent</translation>
    </message>
    <message>
        <source>Largest inclination of the assumed previous path, which tells how much lead every place needs; and of the rework path by cm2.</source>
        <translation>Plus grande inclinaison du parcours précédent supposé, qui dit quelle attaque chaque endroit demande ; et du parcours de reprise par cm2.</translation>
    </message>
    <message>
        <source>Largest inclination of the main path's tool axis, alpha_M, where it is not raised. Smaller: wider strips and more to rework.</source>
        <translation>Plus grande inclinaison de l'axe d'outil du parcours principal, alpha_M, où elle n'est pas relevée. Plus petite : bandes plus larges et plus de reprise.</translation>
    </message>
    <message>
        <source>Largest inclination of the tool axis, used where shank or holder would touch the part. 0 keeps the tool upright; above 0 the program is one of five axes.</source>
        <translation>Plus grande inclinaison de l'axe d'outil, utilisée où queue ou porte-outil toucheraient la pièce. 0 garde l'outil vertical ; au-dessus de 0 le programme est à cinq axes.</translation>
    </message>
    <message>
        <source>Largest inclination on a part that is cut side by side, for pieces with places that no inclination within the lead limits reaches: undersides, faces of blades behind others. No larger than the upper lead limit: these are left, and said.</source>
        <translation>Plus grande inclinaison sur une pièce usinée côté par côté, pour des morceaux dont des endroits ne sont atteints par aucune inclinaison dans les limites : dessous, aubes derrière d'autres. Si elle ne dépasse pas la limite haute, ils sont laissés, et c'est dit.</translation>
    </message>
    <message>
        <source>Largest step-down</source>
        <translation>Plus grande descente</translation>
    </message>
    <message>
        <source>Largest turn of the surface normal between neighbouring points of a pass{1}.</source>
        <translation>Plus grande rotation de la normale entre points voisins d'une passe{1}.</translation>
    </message>
    <message>
        <source>Largest turn of the tool axis between neighbouring points of a pass.</source>
        <translation>Plus grande rotation de l'axe d'outil entre points voisins d'une passe.</translation>
    </message>
    <message>
        <source>Lathe-mill, part turns about X (4-axis)</source>
        <translation>Tour-fraiseuse, la pièce tourne autour de X (4 axes)</translation>
    </message>
    <message>
        <source>Layer chosen</source>
        <translation>Niveau choisi</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Attaque</translation>
    </message>
    <message>
        <source>Lead limit</source>
        <translation>Limite d'attaque</translation>
    </message>
    <message>
        <source>Lead limits</source>
        <translation>Limites d'attaque</translation>
    </message>
    <message>
        <source>Lead to reach</source>
        <translation>Attaque pour atteindre</translation>
    </message>
    <message>
        <source>Lead, deg</source>
        <translation>Attaque, °</translation>
    </message>
    <message>
        <source>Leaves too much</source>
        <translation>Laisse trop</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Left by</source>
        <translation>Laissé par</translation>
    </message>
    <message>
        <source>Left to clean-up</source>
        <translation>Laissé au nettoyage</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length of the section along the axis.</source>
        <translation>Longueur de la section le long de l'axe.</translation>
    </message>
    <message>
        <source>Length that the chuck holds, from the stock's low end, and its diameter: no part of the tool comes nearer than the clearance. Length 0: none.</source>
        <translation>Longueur que tient le mandrin, depuis l'extrémité basse du brut, et son diamètre : aucune partie de l'outil ne vient plus près que la distance de sécurité. Longueur 0 : aucun.</translation>
    </message>
    <message>
        <source>Lies on the table</source>
        <translation>Repose sur la table</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Levée</translation>
    </message>
    <message>
        <source>Lift, {1}</source>
        <translation>Levée, {1}</translation>
    </message>
    <message>
        <source>Lines that the format does not know were ignored.</source>
        <translation>Les lignes que le format ne connaît pas ont été ignorées.</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Link feed</source>
        <translation>Avance de liaison</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>LinuxCNC, TCP by switched kinematics</source>
        <translation>LinuxCNC, TCP par cinématique commutée</translation>
    </message>
    <message>
        <source>Lollipop</source>
        <translation>Sucette</translation>
    </message>
    <message>
        <source>Longer than the tool's flutes, which are {1}</source>
        <translation>Plus long que la partie coupante de l'outil, qui est de {1}</translation>
    </message>
    <message>
        <source>Looking at the part</source>
        <translation>Examen de la pièce</translation>
    </message>
    <message>
        <source>Looking at the stock</source>
        <translation>Examen du brut</translation>
    </message>
    <message>
        <source>Looking at what both paths clear</source>
        <translation>Examen de ce que les deux parcours enlèvent</translation>
    </message>
    <message>
        <source>Looking at what the main path clears</source>
        <translation>Examen de ce que le parcours principal enlève</translation>
    </message>
    <message>
        <source>Looking for air</source>
        <translation>Recherche des trajets à vide</translation>
    </message>
    <message>
        <source>Looking for crossings</source>
        <translation>Recherche des croisements</translation>
    </message>
    <message>
        <source>Looking for faces to lie on</source>
        <translation>Recherche de faces d'appui</translation>
    </message>
    <message>
        <source>Looking for holes</source>
        <translation>Recherche des trous</translation>
    </message>
    <message>
        <source>Looking for loose pieces</source>
        <translation>Recherche de morceaux détachés</translation>
    </message>
    <message>
        <source>Looking for pieces</source>
        <translation>Recherche des morceaux</translation>
    </message>
    <message>
        <source>Looking for sharp changes of normals</source>
        <translation>Recherche de variations brusques des normales</translation>
    </message>
    <message>
        <source>Looking for sides</source>
        <translation>Recherche des côtés</translation>
    </message>
    <message>
        <source>Looking for valleys</source>
        <translation>Recherche des vallées</translation>
    </message>
    <message>
        <source>Looking for what stays</source>
        <translation>Recherche de ce qui reste</translation>
    </message>
    <message>
        <source>Looking for what stays uncut</source>
        <translation>Recherche de ce qui reste non usiné</translation>
    </message>
    <message>
        <source>Looking where the previous cutter left something</source>
        <translation>Recherche de ce que la fraise précédente a laissé</translation>
    </message>
    <message>
        <source>Lowest free lift</source>
        <translation>Plus basse levée libre</translation>
    </message>
    <message>
        <source>Lowest free lift, stopped by:</source>
        <translation>Plus basse levée libre, arrêtée par :</translation>
    </message>
    <message>
        <source>Lu's first benchmark: a ruled valley, 10 × 10 in.</source>
        <translation>Premier essai de Lu : une vallée réglée, 10 × 10 in.</translation>
    </message>
    <message>
        <source>Lu's second benchmark: a ruled ridge, 10 × 10 in.</source>
        <translation>Deuxième essai de Lu : une crête réglée, 10 × 10 in.</translation>
    </message>
    <message>
        <source>Lu's third benchmark: convex, concave and saddle regions, 9 × 11 in.</source>
        <translation>Troisième essai de Lu : zones convexes, concaves et en selle, 9 × 11 in.</translation>
    </message>
    <message>
        <source>Mach3 and Mach4</source>
        <translation>Mach3 et Mach4</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Machining direction</source>
        <translation>Direction d'usinage</translation>
    </message>
    <message>
        <source>Machining tolerance: the largest cusp that may be left. Gouges are not allowed at all.</source>
        <translation>Tolérance d'usinage : la plus grande crête qui peut rester. Les entailles ne sont pas permises du tout.</translation>
    </message>
    <message>
        <source>Makes the {1} so many times as large as its file and unit say, about the file's origin; 1 leaves it. Unit, scale, mirror, rotate and translate are applied in this order.</source>
        <translation>Rend l'objet ({1}) tant de fois plus grand que ne disent son fichier et l'unité, autour de l'origine du fichier ; 1 le laisse. Unité, échelle, miroir, rotation et translation s'appliquent dans cet ordre.</translation>
    </message>
    <message>
        <source>Making passes</source>
        <translation>Formation des passes</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Marge</translation>
    </message>
    <message>
        <source>Marlin</source>
        <translation>Marlin</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matière</translation>
    </message>
    <message>
        <source>Measuring steps over the surface</source>
        <translation>Mesure des pas sur la surface</translation>
    </message>
    <message>
        <source>Measuring the part</source>
        <translation>Mesure de la pièce</translation>
    </message>
    <message>
        <source>Measuring what is left</source>
        <translation>Mesure de ce qui est laissé</translation>
    </message>
    <message>
        <source>Measuring what stays</source>
        <translation>Mesure de ce qui reste</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Miroir</translation>
    </message>
    <message>
        <source>More than</source>
        <translation>Plus de</translation>
    </message>
    <message>
        <source>More than the tool's radius, which is {1}</source>
        <translation>Plus que le rayon de l'outil, qui est {1}</translation>
    </message>
    <message>
        <source>Morph</source>
        <translation>Transition</translation>
    </message>
    <message>
        <source>Mould cavity</source>
        <translation>Empreinte de moule</translation>
    </message>
    <message>
        <source>Moved ({1})</source>
        <translation>Déplacé ({1})</translation>
    </message>
    <message>
        <source>Moves it after it was turned.</source>
        <translation>La déplace après la rotation.</translation>
    </message>
    <message>
        <source>Moves the border outward by so much, inward below 0.</source>
        <translation>Déplace le bord d'autant vers l'extérieur, vers l'intérieur sous 0.</translation>
    </message>
    <message>
        <source>Moves the part after it was turned.</source>
        <translation>Déplace la pièce après sa rotation.</translation>
    </message>
    <message>
        <source>Moves the stock's mesh after it was turned.</source>
        <translation>Déplace le maillage du brut après sa rotation.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, the curve or border of which is followed, seen from above. A drawn curve is taken without its offset. Empty: the outline of what is cut.</source>
        <translation>Nom d’une limite du montage dont la courbe ou le bord est suivi, vu de dessus. Une courbe dessinée est prise sans son décalage. Vide : le contour de ce qui est usiné.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, the curve or border of which passes follow, with 'Begin at' curve, seen from above. Empty: the outline of what is cut.</source>
        <translation>Nom d'une limite de la mise en place, dont les passes suivent la courbe ou le bord quand elles commencent à une courbe, vue de dessus. Vide : le contour de ce qui est usiné.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup, with the curve at which the passes begin. Empty, both: halves of the outline of what is cut.</source>
        <translation>Nom d’une limite du montage dont la courbe est celle où les passes commencent. Les deux vides : des moitiés du contour de ce qui est usiné.</translation>
    </message>
    <message>
        <source>Name of a boundary of the setup: the operation cuts within it. Empty: everywhere.</source>
        <translation>Nom d'une limite du posage : l'opération usine dedans. Vide : partout.</translation>
    </message>
    <message>
        <source>Name of a boundary whose facets the tool keeps off. Empty: none.</source>
        <translation>Nom d'une limite dont l'outil évite les facettes. Vide : aucune.</translation>
    </message>
    <message>
        <source>Name of the boundary with the curve at which the passes end.</source>
        <translation>Nom de la limite dont la courbe est celle où les passes finissent.</translation>
    </message>
    <message>
        <source>Name of the operation; also names its output file.</source>
        <translation>Nom de l'opération ; nomme aussi son fichier de sortie.</translation>
    </message>
    <message>
        <source>Names of strips that are found but not cut, separated by commas.</source>
        <translation>Noms des bandes trouvées mais non usinées, séparés par des virgules.</translation>
    </message>
    <message>
        <source>Neighbouring facets run along their common edge in the same direction: some are turned over. None was turned back.</source>
        <translation>Des facettes voisines parcourent leur arête commune dans le même sens : certaines sont retournées. Aucune n'a été remise.</translation>
    </message>
    <message>
        <source>New surface</source>
        <translation>Nouvelle surface</translation>
    </message>
    <message>
        <source>No larger than the tool that is to come in after it: {1} and {2}</source>
        <translation>Pas plus grand que l'outil qui doit y entrer ensuite : {1} et {2}</translation>
    </message>
    <message>
        <source>No point</source>
        <translation>Aucun point</translation>
    </message>
    <message>
        <source>No posture is free here</source>
        <translation>Aucune posture n'est libre ici</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Normal change limit</source>
        <translation>Limite de variation de la normale</translation>
    </message>
    <message>
        <source>Normal limit</source>
        <translation>Limite des normales</translation>
    </message>
    <message>
        <source>Not moved</source>
        <translation>Non déplacé</translation>
    </message>
    <message>
        <source>Not verified, do not run: {1}</source>
        <translation>Non vérifié, ne pas exécuter : {1}</translation>
    </message>
    <message>
        <source>Nothing to show</source>
        <translation>Rien à afficher</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numéro</translation>
    </message>
    <message>
        <source>Number of the first program, for controls that want one; those after it count on.</source>
        <translation>Numéro du premier programme, pour les commandes qui en veulent un ; les suivants continuent.</translation>
    </message>
    <message>
        <source>Number of the tool in the tool list.</source>
        <translation>Numéro de l'outil dans la liste d'outils.</translation>
    </message>
    <message>
        <source>Number of the tool that cut the part before: clean-up looks for what it could not enter.</source>
        <translation>Numéro de l'outil qui a usiné la pièce avant : le nettoyage cherche où il n'a pas pu entrer.</translation>
    </message>
    <message>
        <source>Number of the tool that cuts the regions; 0: none, they are shown and left to other operations.</source>
        <translation>Numéro de l'outil qui usine les zones ; 0 : aucun, elles sont montrées et laissées à d'autres opérations.</translation>
    </message>
    <message>
        <source>Number of the tool. The region is what it leaves of the part where it has been everywhere: hollows narrower than it, inner edges.</source>
        <translation>Numéro de l'outil. La zone est ce qu'il laisse de la pièce après être passé partout : creux plus étroits que lui, arêtes rentrantes.</translation>
    </message>
    <message>
        <source>Numbers have decimal commas; they were read as such.</source>
        <translation>Des nombres ont des virgules décimales ; ils ont été lus ainsi.</translation>
    </message>
    <message>
        <source>Numbers of faces of the part's file, counted from 0: 0-3, 7. They are the same however finely the file is tessellated.</source>
        <translation>Numéros de faces du fichier de la pièce, comptés depuis 0 : 0-3, 7. Ils restent, aussi finement que le fichier soit maillé.</translation>
    </message>
    <message>
        <source>Numbers of the painted facets, counted from 0 in the part's file: 0-57, 60.</source>
        <translation>Numéros des facettes peintes, comptés depuis 0 dans le fichier de la pièce : 0-57, 60.</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Objects have slices beside their mesh, which may be a coarse stand-in for them; the mesh was read.</source>
        <translation>Des objets ont des couches à côté de leur maillage, qui peut en être un substitut grossier ; le maillage a été lu.</translation>
    </message>
    <message>
        <source>Objects of the file that are no part of the model (supports, modifiers) were left out.</source>
        <translation>Des objets du fichier qui ne sont pas du modèle (supports, modificateurs) ont été omis.</translation>
    </message>
    <message>
        <source>Of a tab as it is seen along its length. A triangular one is cut in ramps and breaks off more easily.</source>
        <translation>D'une attache vue le long de sa longueur. Une triangulaire est usinée en rampes et se casse plus facilement.</translation>
    </message>
    <message>
        <source>Of cuts; 0: from spindle, chip load and flutes.</source>
        <translation>En coupe ; 0 : d'après broche, avance par dent et dents.</translation>
    </message>
    <message>
        <source>Of layers; 0 where nobody says.</source>
        <translation>Des niveaux ; 0 si personne ne le dit.</translation>
    </message>
    <message>
        <source>Of so many</source>
        <translation>Sur combien</translation>
    </message>
    <message>
        <source>Of the box along X, Y and Z, before it is turned; of a tab its length from the part outward, its width and its height.</source>
        <translation>De la boîte selon X, Y et Z, avant sa rotation ; d'une attache sa longueur depuis la pièce, sa largeur et sa hauteur.</translation>
    </message>
    <message>
        <source>Of the cylinder, along Z before it is turned.</source>
        <translation>Du cylindre, selon Z avant sa rotation.</translation>
    </message>
    <message>
        <source>Of the cylinder.</source>
        <translation>Du cylindre.</translation>
    </message>
    <message>
        <source>Of the cylinder; `auto`: what holds the part and the margin.</source>
        <translation>Du cylindre ; auto : ce qui contient la pièce et la marge.</translation>
    </message>
    <message>
        <source>Of the plain part between flutes and holder.</source>
        <translation>De la partie lisse entre dents et porte-outil.</translation>
    </message>
    <message>
        <source>Of the plain part that is out of the holder.</source>
        <translation>De la partie lisse hors du porte-outil.</translation>
    </message>
    <message>
        <source>Of the setup. Each has its own.</source>
        <translation>Du posage. Chacun a le sien.</translation>
    </message>
    <message>
        <source>Of the stock in all, X, Y and Z: the part and its margins. Either can be typed; the project keeps the margins.</source>
        <translation>Du brut en tout, X, Y et Z : la pièce et ses marges. L'un ou l'autre peut être tapé ; le projet garde les marges.</translation>
    </message>
    <message>
        <source>Of the stock that begins in setup '{1}'.</source>
        <translation>Du brut qui commence au posage '{1}'.</translation>
    </message>
    <message>
        <source>Of the work coordinates, from the place that `zero_from` says; from the part's origin a point of the part.</source>
        <translation>Des coordonnées pièce, depuis l'endroit que dit `zero_from` ; depuis l'origine de la pièce un point de la pièce.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Désactivé</translation>
    </message>
    <message>
        <source>Off centre</source>
        <translation>Décentré</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouverte</translation>
    </message>
    <message>
        <source>OpenCASCADE cannot work with it: {1} {2}</source>
        <translation>OpenCASCADE ne peut le traiter : {1} {2}</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Operations name the boundary by it.</source>
        <translation>Les opérations nomment la limite ainsi.</translation>
    </message>
    <message>
        <source>Origin</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Out of holder</source>
        <translation>Hors du porte-outil</translation>
    </message>
    <message>
        <source>Over the tolerance</source>
        <translation>Au-delà de la tolérance</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Recouvrement</translation>
    </message>
    <message>
        <source>PLY ASCII</source>
        <translation>PLY ASCII</translation>
    </message>
    <message>
        <source>PLY binary</source>
        <translation>PLY binaire</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Part before</source>
        <translation>Pièce avant</translation>
    </message>
    <message>
        <source>Part from</source>
        <translation>Pièce de</translation>
    </message>
    <message>
        <source>Part in them</source>
        <translation>Pièce dans celles-ci</translation>
    </message>
    <message>
        <source>Part to</source>
        <translation>Pièce à</translation>
    </message>
    <message>
        <source>Part's size</source>
        <translation>Taille de la pièce</translation>
    </message>
    <message>
        <source>Part, stock and machine</source>
        <translation>Pièce, brut et machine</translation>
    </message>
    <message>
        <source>Parts of the picture are transparent: the more so, the nearer they lie to the ground.</source>
        <translation>Des parties de l'image sont transparentes : plus elles le sont, plus elles sont près du fond.</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Passes about the centre</source>
        <translation>Passes autour du centre</translation>
    </message>
    <message>
        <source>Passes along valleys</source>
        <translation>Passes le long des vallées</translation>
    </message>
    <message>
        <source>Passes from curve to curve</source>
        <translation>Passes de courbe à courbe</translation>
    </message>
    <message>
        <source>Passes from the centre outward</source>
        <translation>Passes du centre vers l’extérieur</translation>
    </message>
    <message>
        <source>Passes on either side of the one along the valley. 0: that one alone.</source>
        <translation>Passes de chaque côté de celle qui suit la vallée. 0 : celle-là seule.</translation>
    </message>
    <message>
        <source>Passes over shallow surface</source>
        <translation>Passes sur les surfaces douces</translation>
    </message>
    <message>
        <source>Passes over what is less steep: parallel keeps to drive planes; scallop follows the border, with cusps of one height.</source>
        <translation>Passes sur ce qui est moins raide : parallèle reste dans des plans directeurs ; crête constante suit le bord.</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Motif</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>Fond de vallée</translation>
    </message>
    <message>
        <source>Picked point</source>
        <translation>Point choisi</translation>
    </message>
    <message>
        <source>Picture length</source>
        <translation>Longueur de l'image</translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation>Largeur de l'image</translation>
    </message>
    <message>
        <source>Pillar</source>
        <translation>Montant</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Endroit</translation>
    </message>
    <message>
        <source>Place in the magazine; operations name the tool by it.</source>
        <translation>Place dans le magasin ; les opérations nomment l'outil ainsi.</translation>
    </message>
    <message>
        <source>Place of the centre, seen from above, where it is not the middle.</source>
        <translation>Position du centre, vu de dessus, quand ce n’est pas le milieu.</translation>
    </message>
    <message>
        <source>Place on the part whose nearest contact point it is for.</source>
        <translation>Endroit de la pièce dont le point de contact le plus proche est concerné.</translation>
    </message>
    <message>
        <source>Places looked at</source>
        <translation>Endroits examinés</translation>
    </message>
    <message>
        <source>Placing drive planes</source>
        <translation>Placement des plans directeurs</translation>
    </message>
    <message>
        <source>Placing turns</source>
        <translation>Placement des tours</translation>
    </message>
    <message>
        <source>Planning passes</source>
        <translation>Planification des passes</translation>
    </message>
    <message>
        <source>Plate</source>
        <translation>Plaque</translation>
    </message>
    <message>
        <source>Plunge feed</source>
        <translation>Avance de plongée</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Points of the regions' boundaries that were dragged over the surface.</source>
        <translation>Points des limites des zones qui ont été tirés sur la surface.</translation>
    </message>
    <message>
        <source>Points per turn</source>
        <translation>Points par tour</translation>
    </message>
    <message>
        <source>Polygons with more than three corners were cut into triangles.</source>
        <translation>Les polygones de plus de trois sommets ont été coupés en triangles.</translation>
    </message>
    <message>
        <source>Posting</source>
        <translation>Post-traitement</translation>
    </message>
    <message>
        <source>Posture</source>
        <translation>Posture</translation>
    </message>
    <message>
        <source>Posture grid</source>
        <translation>Grille de postures</translation>
    </message>
    <message>
        <source>Posture kept by hand</source>
        <translation>Posture gardée à la main</translation>
    </message>
    <message>
        <source>Postures chosen by hand for single contact points, in the configuration space of the point; used wherever they are free.</source>
        <translation>Postures choisies à la main pour certains points de contact, dans l'espace des configurations du point ; utilisées où elles sont libres.</translation>
    </message>
    <message>
        <source>Preparing the view</source>
        <translation>Préparation de la vue</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Préréglage</translation>
    </message>
    <message>
        <source>Previous tool</source>
        <translation>Outil précédent</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programme</translation>
    </message>
    <message>
        <source>Program number</source>
        <translation>Numéro de programme</translation>
    </message>
    <message>
        <source>Programs</source>
        <translation>Programmes</translation>
    </message>
    <message>
        <source>Programs for the control</source>
        <translation>Programmes pour la commande</translation>
    </message>
    <message>
        <source>Programs of three axes hold arcs (`G2`, `G3`) where the control has them and one stands for three motions or more: every end of a motion within a quarter of the chord tolerance of the arc, and the arc within half of it of the motions. Where the tool leans, in tilted planes alone.</source>
        <translation>Les programmes à trois axes contiennent des arcs (`G2`, `G3`) où la commande les a et où l'un remplace trois mouvements ou plus : chaque fin de mouvement à un quart de la tolérance de corde de l'arc, et l'arc à la moitié des mouvements. Où l'outil penche, seulement dans les plans inclinés.</translation>
    </message>
    <message>
        <source>Radial</source>
        <translation>Radial</translation>
    </message>
    <message>
        <source>Raise lead limit</source>
        <translation>Relever la limite</translation>
    </message>
    <message>
        <source>Raised pads on a cylinder Ø40 mm, 54 mm long, about the X axis.</source>
        <translation>Plots en relief sur un cylindre Ø40 mm, 54 mm de long, autour de l'axe X.</translation>
    </message>
    <message>
        <source>Ramp angle</source>
        <translation>Angle de rampe</translation>
    </message>
    <message>
        <source>Ramp feed</source>
        <translation>Avance de rampe</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Rapid, {1}</source>
        <translation>Rapide, {1}</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Reading the part</source>
        <translation>Lecture de la pièce</translation>
    </message>
    <message>
        <source>Reading the {1}</source>
        <translation>Lecture : {1}</translation>
    </message>
    <message>
        <source>Reading {1}</source>
        <translation>Lecture de {1}</translation>
    </message>
    <message>
        <source>Rear</source>
        <translation>Arrière</translation>
    </message>
    <message>
        <source>Rear jaw</source>
        <translation>Mors arrière</translation>
    </message>
    <message>
        <source>Region edits</source>
        <translation>Modifications des zones</translation>
    </message>
    <message>
        <source>Region {1}</source>
        <translation>Zone {1}</translation>
    </message>
    <message>
        <source>Relief height</source>
        <translation>Hauteur du relief</translation>
    </message>
    <message>
        <source>Removing fins</source>
        <translation>Suppression des lambeaux</translation>
    </message>
    <message>
        <source>Removing material{1}</source>
        <translation>Enlèvement de matière{1}</translation>
    </message>
    <message>
        <source>Removing needles</source>
        <translation>Suppression des aiguilles</translation>
    </message>
    <message>
        <source>Removing small pieces</source>
        <translation>Suppression des petits morceaux</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Réparation</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Rest material</source>
        <translation>Matière restante</translation>
    </message>
    <message>
        <source>Rest only</source>
        <translation>Reste seulement</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Retrait</translation>
    </message>
    <message>
        <source>Rework and clean-up regions</source>
        <translation>Zones de reprise et de nettoyage</translation>
    </message>
    <message>
        <source>Rework cutting</source>
        <translation>Usinage de la reprise</translation>
    </message>
    <message>
        <source>Rework offset</source>
        <translation>Décalage de reprise</translation>
    </message>
    <message>
        <source>Rework regions that were switched off, grown or shrunk by hand.</source>
        <translation>Zones de reprise désactivées, agrandies ou réduites à la main.</translation>
    </message>
    <message>
        <source>Rework tool</source>
        <translation>Outil de reprise</translation>
    </message>
    <message>
        <source>Ribs swept around a cylinder Ø40 mm, 54 mm long, about the X axis.</source>
        <translation>Nervures balayées autour d'un cylindre Ø40 mm, 54 mm de long, autour de l'axe X.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Rough, turning part</source>
        <translation>Ébauche, pièce tournante</translation>
    </message>
    <message>
        <source>STL ASCII</source>
        <translation>STL ASCII</translation>
    </message>
    <message>
        <source>STL binary</source>
        <translation>STL binaire</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Second curve</source>
        <translation>Seconde courbe</translation>
    </message>
    <message>
        <source>Second point of an axis through two points.</source>
        <translation>Second point d'un axe par deux points.</translation>
    </message>
    <message>
        <source>Setup sheet</source>
        <translation>Fiche de réglage</translation>
    </message>
    <message>
        <source>Setup {1}</source>
        <translation>Posage {1}</translation>
    </message>
    <message>
        <source>Shallow</source>
        <translation>Doux</translation>
    </message>
    <message>
        <source>Shallow by</source>
        <translation>Doux par</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Queue</translation>
    </message>
    <message>
        <source>Shank diameter</source>
        <translation>Diamètre de queue</translation>
    </message>
    <message>
        <source>Shank length</source>
        <translation>Longueur de queue</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Shape of the raw material. `rest`: what the setup before left of its stock, as it was verified; not in the first setup.</source>
        <translation>Forme de la matière brute. reste : ce que le posage précédent a laissé de son brut, tel que vérifié ; pas dans le premier posage.</translation>
    </message>
    <message>
        <source>Shape of what holds the part: a vice's jaw or a clamp is a box, a bolt or a chuck a cylinder. A tab is a piece of the stock that is left between part and rest.</source>
        <translation>Forme de ce qui tient la pièce : un mors ou une bride est une boîte, un boulon ou un mandrin un cylindre. Une attache est un morceau du brut laissé entre la pièce et le reste.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>Shorter valleys are left out, and shorter gaps in one are passed over. auto is the cutter's radius.</source>
        <translation>Les vallées plus courtes sont omises, et les lacunes plus courtes dans l’une d’elles sont franchies. auto est le rayon de la fraise.</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Côté</translation>
    </message>
    <message>
        <source>Side feed</source>
        <translation>Avance latérale</translation>
    </message>
    <message>
        <source>Side passes</source>
        <translation>Passes latérales</translation>
    </message>
    <message>
        <source>Sides</source>
        <translation>Côtés</translation>
    </message>
    <message>
        <source>Siemens, TRAORI with tool vectors</source>
        <translation>Siemens, TRAORI à vecteurs d'outil</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
    <message>
        <source>Slope at which ramps and helices go down.</source>
        <translation>Pente à laquelle descendent rampes et hélices.</translation>
    </message>
    <message>
        <source>Slope from level at which the part is divided: what is steeper is cut by levels, what is less steep by passes side by side.</source>
        <translation>Pente par rapport à l'horizontale où la pièce est divisée : ce qui est plus raide est usiné par niveaux, ce qui l'est moins par passes côte à côte.</translation>
    </message>
    <message>
        <source>Slope limit</source>
        <translation>Limite de pente</translation>
    </message>
    <message>
        <source>Slope limits</source>
        <translation>Limites de pente</translation>
    </message>
    <message>
        <source>Slopes that are cut, from level: 0 is a floor, 90 degrees a wall. What is less steep is for parallel passes.</source>
        <translation>Pentes qui sont usinées, depuis l'horizontale : 0 est un fond, 90 degrés une paroi. Ce qui est moins raide est pour des passes parallèles.</translation>
    </message>
    <message>
        <source>Slopes that are so near to the divide are cut both ways.</source>
        <translation>Les pentes aussi proches de la limite sont usinées des deux façons.</translation>
    </message>
    <message>
        <source>Slurm is not here</source>
        <translation>Slurm n'est pas là</translation>
    </message>
    <message>
        <source>Smallest and largest inclination of the tool axis from the surface normal towards the travel.</source>
        <translation>Plus petite et plus grande inclinaison de l'axe d'outil depuis la normale vers le sens de l'avance.</translation>
    </message>
    <message>
        <source>Smallest strip</source>
        <translation>Plus petite bande</translation>
    </message>
    <message>
        <source>Smallest valley</source>
        <translation>Plus petite vallée</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>Some edges have more than two facets; all facets were kept.</source>
        <translation>Des arêtes ont plus de deux facettes ; toutes ont été gardées.</translation>
    </message>
    <message>
        <source>Some edges have only one facet: the mesh is a sheet or has gaps. Nothing was healed; a cutter may enter a gap.</source>
        <translation>Des arêtes n'ont qu'une facette : le maillage est une feuille ou a des lacunes. Rien n'a été réparé ; une fraise peut entrer dans une lacune.</translation>
    </message>
    <message>
        <source>Some facets have no area (equal or collinear corners); they were left out.</source>
        <translation>Des facettes n'ont pas d'aire (sommets égaux ou alignés) ; elles ont été omises.</translation>
    </message>
    <message>
        <source>Some facets lie farther from their surface than the chord tolerance that was asked for; the deviation says how far.</source>
        <translation>Des facettes sont plus loin de leur surface que la tolérance de corde demandée ; l'écart dit de combien.</translation>
    </message>
    <message>
        <source>Some facets occur more than once, in this or the other winding; all were kept.</source>
        <translation>Des facettes apparaissent plusieurs fois, dans un sens ou l'autre ; toutes ont été gardées.</translation>
    </message>
    <message>
        <source>Some polygons cross themselves; they were cut into triangles that overlap.</source>
        <translation>Des polygones se croisent ; ils ont été coupés en triangles qui se recouvrent.</translation>
    </message>
    <message>
        <source>Some stored normals are missing or not numbers; normals are computed from the corners, so nothing is lost.</source>
        <translation>Des normales enregistrées manquent ou ne sont pas des nombres ; les normales se calculent des sommets, rien n'est perdu.</translation>
    </message>
    <message>
        <source>Some stored normals point against the winding of their facets; the winding counts.</source>
        <translation>Des normales enregistrées vont contre le sens de leurs facettes ; c'est le sens qui compte.</translation>
    </message>
    <message>
        <source>Some surfaces of the file could not be tessellated: the mesh has gaps.</source>
        <translation>Des surfaces du fichier n'ont pu être maillées : le maillage a des lacunes.</translation>
    </message>
    <message>
        <source>Special</source>
        <translation>Spécial</translation>
    </message>
    <message>
        <source>Speed of cutting motion.</source>
        <translation>Vitesse du mouvement de coupe.</translation>
    </message>
    <message>
        <source>Speed of motion between passes that is no rapid: over the surface and away from it. auto is the feed.</source>
        <translation>Vitesse entre passes hors rapide : au-dessus de la surface et en s'en éloignant. auto est l'avance.</translation>
    </message>
    <message>
        <source>Speed of motion into the material: down to a pass, along ramps and helices. auto is half the feed.</source>
        <translation>Vitesse du mouvement dans la matière : vers une passe, le long de rampes et d'hélices. auto est la moitié de l'avance.</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Broche</translation>
    </message>
    <message>
        <source>Spindle speed.</source>
        <translation>Vitesse de broche.</translation>
    </message>
    <message>
        <source>Spindle, rpm</source>
        <translation>Broche, tr/min</translation>
    </message>
    <message>
        <source>Spiral</source>
        <translation>Spirale</translation>
    </message>
    <message>
        <source>Square prism</source>
        <translation>Prisme carré</translation>
    </message>
    <message>
        <source>Stands in the report, the verdict and the setup sheet.</source>
        <translation>Figure dans le rapport, le verdict et la fiche de réglage.</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>Steep</source>
        <translation>Raide</translation>
    </message>
    <message>
        <source>Steep and shallow</source>
        <translation>Raide et doux</translation>
    </message>
    <message>
        <source>Step of inclination and yaw in the configuration space.</source>
        <translation>Pas de l'inclinaison et du lacet dans l'espace des configurations.</translation>
    </message>
    <message>
        <source>Step-down</source>
        <translation>Descente en Z</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Pas latéral</translation>
    </message>
    <message>
        <source>Steps that make the file's mesh worth machining, in their order, carried out again whenever the file has changed.</source>
        <translation>Étapes qui rendent le maillage du fichier usinable, dans leur ordre, refaites chaque fois que le fichier a changé.</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Brut</translation>
    </message>
    <message>
        <source>Stock from</source>
        <translation>Brut de</translation>
    </message>
    <message>
        <source>Stock in them</source>
        <translation>Brut dans celles-ci</translation>
    </message>
    <message>
        <source>Stock left on the part for a later operation. 0 cuts to size.</source>
        <translation>Matière laissée sur la pièce pour une opération ultérieure. 0 usine à la cote.</translation>
    </message>
    <message>
        <source>Stock to</source>
        <translation>Brut à</translation>
    </message>
    <message>
        <source>Stock's size</source>
        <translation>Taille du brut</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Strips also around contact points that operations before left to clean-up, as those without a free posture.</source>
        <translation>Bandes aussi autour des points de contact que des opérations précédentes ont laissés au nettoyage, comme ceux sans posture libre.</translation>
    </message>
    <message>
        <source>Strips also where more than the tolerance stands after the operations before: their programs are verified first.</source>
        <translation>Bandes aussi où il reste plus que la tolérance après les opérations précédentes : leurs programmes sont d'abord vérifiés.</translation>
    </message>
    <message>
        <source>Surface that is steeper, from level, is left to other operations.</source>
        <translation>La surface plus raide, par rapport à l'horizontale, est laissée à d'autres opérations.</translation>
    </message>
    <message>
        <source>Surface with a gap</source>
        <translation>Surface à fente</translation>
    </message>
    <message>
        <source>Surfaces of the file belong to no solid; they were taken as sheets.</source>
        <translation>Des surfaces du fichier n'appartiennent à aucun solide ; elles sont prises comme feuilles.</translation>
    </message>
    <message>
        <source>Surfaces that lie edge to edge within the chord tolerance were joined: the file does not say that they hang together.</source>
        <translation>Des surfaces bord à bord dans la tolérance de corde ont été jointes : le fichier ne dit pas qu'elles se tiennent.</translation>
    </message>
    <message>
        <source>Swept pattern</source>
        <translation>Motif balayé</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Désactivées</translation>
    </message>
    <message>
        <source>Switched off: the operation is left out of plan, verification and programs, as if it were not there.</source>
        <translation>Désactivée : l'opération est omise du plan, de la vérification et des programmes, comme si elle n'existait pas.</translation>
    </message>
    <message>
        <source>TLAXIS has not three values</source>
        <translation>TLAXIS n'a pas trois valeurs</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Attache</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Attaches</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>Contre-pointe</translation>
    </message>
    <message>
        <source>Taken away</source>
        <translation>Enlevé</translation>
    </message>
    <message>
        <source>Takes the other side of open surfaces as their outside. By itself that is the upper side of a sheet, and the side that is seen of what nearly closes; of closed bodies it is always the outside.</source>
        <translation>Prend l'autre côté des surfaces ouvertes comme extérieur. De soi c'est le dessus d'une feuille, et le côté visible de ce qui est presque fermé ; pour des corps fermés c'est toujours l'extérieur.</translation>
    </message>
    <message>
        <source>Taper angle</source>
        <translation>Angle de cône</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>Conique hémisphérique</translation>
    </message>
    <message>
        <source>Tapered bull nose</source>
        <translation>Conique torique</translation>
    </message>
    <message>
        <source>Tapered cone-bottom bull nose</source>
        <translation>Conique torique à fond conique</translation>
    </message>
    <message>
        <source>Tapered drill point</source>
        <translation>Pointe de foret conique</translation>
    </message>
    <message>
        <source>Tapered flat</source>
        <translation>Conique à bout plat</translation>
    </message>
    <message>
        <source>Tarus TPI 2000 (5-axis, head-head)</source>
        <translation>Tarus TPI 2000 (5 axes, tête-tête)</translation>
    </message>
    <message>
        <source>Tessellating</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Tessellation tolerance</source>
        <translation>Tolérance de maillage</translation>
    </message>
    <message>
        <source>That is the whole part: nowhere is what the programs leave held against the tolerance, only gouges are judged.</source>
        <translation>C'est toute la pièce : nulle part ce que laissent les programmes n'est comparé à la tolérance, seules les entailles sont jugées.</translation>
    </message>
    <message>
        <source>The OBJ file has curves or surfaces beside its facets; they were ignored.</source>
        <translation>Le fichier OBJ a des courbes ou surfaces à côté de ses facettes ; elles ont été ignorées.</translation>
    </message>
    <message>
        <source>The adaptive step-down is no larger than this. auto is the cutter's diameter.</source>
        <translation>La descente adaptative ne dépasse pas cette valeur. auto est le diamètre de la fraise.</translation>
    </message>
    <message>
        <source>The attribute words of the binary STL file are not zero (colours of some writers); they were ignored.</source>
        <translation>Les mots d'attribut du fichier STL binaire ne sont pas nuls (couleurs de certains programmes) ; ils ont été ignorés.</translation>
    </message>
    <message>
        <source>The binary STL file has its bytes in reverse order; it was read accordingly.</source>
        <translation>Le fichier STL binaire a ses octets en ordre inverse ; il a été lu en conséquence.</translation>
    </message>
    <message>
        <source>The binary STL file starts with the word 'solid' like a text; it was read as binary.</source>
        <translation>Le fichier STL binaire commence par 'solid' comme un texte ; il a été lu comme binaire.</translation>
    </message>
    <message>
        <source>The centre is the middle of what is cut, seen from above, whatever the centre says.</source>
        <translation>Le centre est le milieu de ce qui est usiné, vu de dessus, quel que soit le centre indiqué.</translation>
    </message>
    <message>
        <source>The control that programs are written for, see below, or a file of your own (`resources/posts/README.md`); its name ends with `.json`, a relative one starts at the project file. Without it programs are APT alone.</source>
        <translation>La commande pour laquelle les programmes sont écrits, ou un fichier à soi (`resources/posts/README.md`) ; son nom finit par `.json`, un chemin relatif part du fichier de projet. Sans elle les programmes sont en APT seul.</translation>
    </message>
    <message>
        <source>The control's work coordinate system that programs are told in: `G54`, or the number of a preset. Default: the control's first, or what is active in it.</source>
        <translation>Le système de coordonnées pièce de la commande, dans lequel les programmes sont dits : `G54`, ou le numéro d'un préréglage. Par défaut : le premier de la commande, ou celui qui y est actif.</translation>
    </message>
    <message>
        <source>The curve ends at its last corner, instead of going back to the first.</source>
        <translation>La courbe finit à son dernier sommet, au lieu de revenir au premier.</translation>
    </message>
    <message>
        <source>The curves end at their last corners, instead of going back to the first.</source>
        <translation>Les courbes finissent à leurs derniers sommets, au lieu de revenir aux premiers.</translation>
    </message>
    <message>
        <source>The cylinders that the holder is made of, from the shank upward.</source>
        <translation>Les cylindres dont est fait le porte-outil, en remontant depuis la queue.</translation>
    </message>
    <message>
        <source>The facet count in the header is wrong; the facets up to the end of the file were read.</source>
        <translation>Le nombre de facettes de l'en-tête est faux ; les facettes ont été lues jusqu'à la fin du fichier.</translation>
    </message>
    <message>
        <source>The file has further pictures; the first was read.</source>
        <translation>Le fichier a d'autres images ; la première a été lue.</translation>
    </message>
    <message>
        <source>The file has points or lines beside its facets; they were ignored.</source>
        <translation>Le fichier a des points ou lignes à côté de ses facettes ; ils ont été ignorés.</translation>
    </message>
    <message>
        <source>The file has several parts or solids; all are in their places.</source>
        <translation>Le fichier a plusieurs pièces ou solides ; tous sont à leur place.</translation>
    </message>
    <message>
        <source>The file has several solids; their facets were put together.</source>
        <translation>Le fichier a plusieurs solides ; leurs facettes ont été réunies.</translation>
    </message>
    <message>
        <source>The file moves its meshes by bones, or into other shapes: they were read as they are modelled.</source>
        <translation>Le fichier déplace ses maillages par des os ou vers d’autres formes : ils ont été lus tels qu’ils sont modélisés.</translation>
    </message>
    <message>
        <source>The file states its own unit, which is not the one that the job says: that of the file counts.</source>
        <translation>Le fichier dit sa propre unité, qui n'est pas celle du travail : celle du fichier compte.</translation>
    </message>
    <message>
        <source>The fixture '{1}' stands in the part.</source>
        <translation>Le bridage '{1}' est dans la pièce.</translation>
    </message>
    <message>
        <source>The fixture's mesh ({1}), closed; a relative path starts at the project file.</source>
        <translation>Le maillage du bridage ({1}), fermé ; un chemin relatif part du fichier de projet.</translation>
    </message>
    <message>
        <source>The last line has no line end: the file may have been cut. It was read as it stands.</source>
        <translation>La dernière ligne n'a pas de fin : le fichier a peut-être été coupé. Il a été lu tel quel.</translation>
    </message>
    <message>
        <source>The machine cannot hold this axis: choose one whose rotary axes can</source>
        <translation>La machine ne peut tenir cet axe : en choisir un que ses axes rotatifs peuvent</translation>
    </message>
    <message>
        <source>The machine has no rotary axis that turns the part: choose a lathe-mill.</source>
        <translation>La machine n'a pas d'axe rotatif qui tourne la pièce : choisir un tour-fraiseuse.</translation>
    </message>
    <message>
        <source>The mesh consists of several pieces that share no edge; all are machined.</source>
        <translation>Le maillage est fait de plusieurs morceaux sans arête commune ; tous sont usinés.</translation>
    </message>
    <message>
        <source>The mesh is closed but wound inside out; it was left so. Cutter contact does not depend on the winding.</source>
        <translation>Le maillage est fermé mais orienté vers l'intérieur ; il a été laissé ainsi. Le contact de la fraise n'en dépend pas.</translation>
    </message>
    <message>
        <source>The operation inclines the tool in five axes; the machine has no rotary axis: choose one with two.</source>
        <translation>L'opération incline l'outil en cinq axes ; la machine n'a pas d'axe rotatif : en choisir une à deux.</translation>
    </message>
    <message>
        <source>The operation inclines the tool in five axes; the machine has one rotary axis: choose one with two.</source>
        <translation>L'opération incline l'outil en cinq axes ; la machine a un axe rotatif : en choisir une à deux.</translation>
    </message>
    <message>
        <source>The operation's own tool: it cannot clean up what it leaves itself</source>
        <translation>L'outil de l'opération elle-même : il ne peut nettoyer ce qu'il laisse</translation>
    </message>
    <message>
        <source>The operation's own tool: it cannot rework what it leaves itself</source>
        <translation>L'outil de l'opération elle-même : il ne peut reprendre ce qu'il laisse</translation>
    </message>
    <message>
        <source>The part is cut free at {1}: what stood round it holds it no longer. Hold it from then on, or leave something between them.</source>
        <translation>La pièce est libérée à {1} : ce qui l'entourait ne la tient plus. La tenir à partir de là, ou laisser quelque chose entre eux.</translation>
    </message>
    <message>
        <source>The part is smaller than 1 mm or larger than 10 m: the file may be in another unit.</source>
        <translation>La pièce est plus petite que 1 mm ou plus grande que 10 m : le fichier est peut-être dans une autre unité.</translation>
    </message>
    <message>
        <source>The part lies as in the project</source>
        <translation>La pièce est posée comme dans le projet</translation>
    </message>
    <message>
        <source>The part lies as in the project.</source>
        <translation>La pièce est posée comme dans le projet.</translation>
    </message>
    <message>
        <source>The part lies so far from the origin (or is so large) that 32-bit coordinates are more than 0.01 mm apart; export it near the origin.</source>
        <translation>La pièce est si loin de l'origine (ou si grande) que les coordonnées 32 bits sont à plus de 0,01 mm l'une de l'autre ; l'exporter près de l'origine.</translation>
    </message>
    <message>
        <source>The part's mesh ({1}); a relative path starts at the project file.</source>
        <translation>Le maillage de la pièce ({1}) ; un chemin relatif part du fichier de projet.</translation>
    </message>
    <message>
        <source>The picture has 256 levels of grey or fewer, which become steps of the surface; smoothing takes them away.</source>
        <translation>L'image a 256 niveaux de gris ou moins, qui deviennent des marches de la surface ; le lissage les enlève.</translation>
    </message>
    <message>
        <source>The picture has colours: their brightness (0.2126 red, 0.7152 green, 0.0722 blue) is the height.</source>
        <translation>L'image a des couleurs : leur luminosité (0,2126 rouge, 0,7152 vert, 0,0722 bleu) est la hauteur.</translation>
    </message>
    <message>
        <source>The picture has more pixels than a mesh of it may have points (4 million): each point is a mean of the pixels around it.</source>
        <translation>L'image a plus de pixels qu'un maillage ne peut avoir de points (4 millions) : chaque point est une moyenne des pixels autour.</translation>
    </message>
    <message>
        <source>The posted program, {1} blocks, {2}, was read back for '{3}'.</source>
        <translation>Le programme post-traité, {1} blocs, {2}, a été relu pour '{3}'.</translation>
    </message>
    <message>
        <source>The probes are up to {1} apart, {2} times farther than asked: else there would be more than {3}. What is narrower may be missed.</source>
        <translation>Les sondes sont jusqu'à {1} l'une de l'autre, {2} fois plus loin que demandé : sinon il y en aurait plus de {3}. Ce qui est plus étroit peut échapper.</translation>
    </message>
    <message>
        <source>The probes are up to {1} apart, {2} times farther than the stock's rays: else there would be more than {3}. What is narrower may be missed.</source>
        <translation>Les sondes sont jusqu'à {1} l'une de l'autre, {2} fois plus loin que les rayons du brut : sinon il y en aurait plus de {3}. Ce qui est plus étroit peut échapper.</translation>
    </message>
    <message>
        <source>The project scales the part: it is not as large as its file and unit say.</source>
        <translation>Le projet met la pièce à l'échelle : elle n'est pas de la taille que disent son fichier et l'unité.</translation>
    </message>
    <message>
        <source>The same of what holds the stock's high end.</source>
        <translation>De même pour ce qui tient l'extrémité haute du brut.</translation>
    </message>
    <message>
        <source>The share of the surface to be cut, seen by a tool axis and away from open borders, on which more than twice the tolerance may stay: 0.02 is 2 %.</source>
        <translation>La part de la surface à usiner, vue par un axe d'outil et loin des bords ouverts, où plus du double de la tolérance peut rester : 0,02 est 2 %.</translation>
    </message>
    <message>
        <source>The step stays in the recipe and is left out.</source>
        <translation>L'étape reste dans la recette et est omise.</translation>
    </message>
    <message>
        <source>The stock does not hold the part, which reaches up to {1} beyond the box of the stock's mesh.</source>
        <translation>Le brut ne contient pas la pièce, qui dépasse jusqu'à {1} la boîte du maillage du brut.</translation>
    </message>
    <message>
        <source>The stock does not hold the part: its diameter is {1}, the part needs {2}.</source>
        <translation>Le brut ne contient pas la pièce : son diamètre est {1}, la pièce demande {2}.</translation>
    </message>
    <message>
        <source>The stock does not reach {1} of the part's area: there only gouges count.</source>
        <translation>Le brut n'atteint pas {1} de l'aire de la pièce : là ne comptent que les entailles.</translation>
    </message>
    <message>
        <source>The stock stays what the setup before leaves.</source>
        <translation>Le brut reste ce que laisse le posage précédent.</translation>
    </message>
    <message>
        <source>The stock's mesh ({1}), closed, such as the stock.stl that `simulate` leaves; a relative path starts at the project file.</source>
        <translation>Le maillage du brut ({1}), fermé, comme le stock.stl que laisse simulate ; un chemin relatif part du fichier de projet.</translation>
    </message>
    <message>
        <source>The tip comes no nearer to the axis than this: nothing is cut off, and holes through the axis are not entered deeper.</source>
        <translation>La pointe ne s'approche pas plus de l'axe : rien n'est tronçonné, et les trous par l'axe ne sont pas pénétrés plus avant.</translation>
    </message>
    <message>
        <source>The tolerances of the setups differ: what is left was held against the largest, {1}.</source>
        <translation>Les tolérances des posages diffèrent : ce qui reste a été comparé à la plus grande, {1}.</translation>
    </message>
    <message>
        <source>The tool has no ball end, and only a ball cuts the same however it leans</source>
        <translation>L’outil n’a pas de bout en boule, et seule une boule usine pareil quelle que soit son inclinaison</translation>
    </message>
    <message>
        <source>The word endsolid is missing; the mesh is closed, so the file was taken as complete.</source>
        <translation>Le mot endsolid manque ; le maillage est fermé, le fichier est donc pris pour complet.</translation>
    </message>
    <message>
        <source>There are none: {1}</source>
        <translation>Il n'y en a pas : {1}</translation>
    </message>
    <message>
        <source>There is no program for '{1}', which has nothing to do: {2}</source>
        <translation>Il n'y a pas de programme pour '{1}', qui n'a rien à faire : {2}</translation>
    </message>
    <message>
        <source>Thickening</source>
        <translation>Épaississement</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Épaisseur</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Inclinaison</translation>
    </message>
    <message>
        <source>Tilt limit</source>
        <translation>Limite d'inclinaison</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Time of the motion</source>
        <translation>Temps du mouvement</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titre</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To radius</source>
        <translation>Jusqu’au rayon</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Ensemble</translation>
    </message>
    <message>
        <source>Told as</source>
        <translation>Donné comme</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Tool axis</source>
        <translation>Axe d'outil</translation>
    </message>
    <message>
        <source>Tool path (CL)</source>
        <translation>Parcours d'outil (CL)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Tools, gauge length</source>
        <translation>Outils, longueur de jauge</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Dessus</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Touches of the tool</source>
        <translation>Contacts de l'outil</translation>
    </message>
    <message>
        <source>Translate</source>
        <translation>Translation</translation>
    </message>
    <message>
        <source>Turn limit</source>
        <translation>Limite de rotation</translation>
    </message>
    <message>
        <source>Turn of the surface's normal per length, in radians per mm, above which a hollow is a strip even where the previous tool could enter it; auto leaves that to the previous tool.</source>
        <translation>Rotation de la normale par longueur, en radians par mm, au-dessus de laquelle un creux est une bande même où l'outil précédent pouvait entrer ; auto s'en remet à l'outil précédent.</translation>
    </message>
    <message>
        <source>Turning angles in the table of positions: unwound they grow turn after turn, modulo they stay within 0 to 360 degrees.</source>
        <translation>Angles de rotation dans le tableau des positions : continus ils croissent tour après tour, modulo ils restent de 0 à 360 degrés.</translation>
    </message>
    <message>
        <source>Turning facets</source>
        <translation>Orientation des facettes</translation>
    </message>
    <message>
        <source>Turns of the tool; 0 where nobody says.</source>
        <translation>Tours de l'outil ; 0 si personne ne le dit.</translation>
    </message>
    <message>
        <source>Turns the fixture about X, then Y, then Z (fixed axes), about the middle of its bottom; a mesh about its file's origin.</source>
        <translation>Tourne le bridage autour de X, puis Y, puis Z (axes fixes), autour du milieu de son fond ; un maillage autour de l'origine de son fichier.</translation>
    </message>
    <message>
        <source>Turns the part about X, then Y, then Z (fixed axes).</source>
        <translation>Tourne la pièce autour de X, puis Y, puis Z (axes fixes).</translation>
    </message>
    <message>
        <source>Turns the part, as `part` places it, about X, then Y, then Z (fixed axes) into this setup.</source>
        <translation>Tourne la pièce, telle que `part` la place, autour de X, puis Y, puis Z (axes fixes) dans ce posage.</translation>
    </message>
    <message>
        <source>Turns the stock's mesh about X, then Y, then Z (fixed axes); the part's placement does not move it.</source>
        <translation>Tourne le maillage du brut autour de X, puis Y, puis Z (axes fixes) ; la mise en place de la pièce ne le bouge pas.</translation>
    </message>
    <message>
        <source>Turns the {1} into its mirror image, before it is turned: this coordinate of its points changes sign.</source>
        <translation>En fait ({1}) l'image en miroir, avant la rotation : cette coordonnée de ses points change de signe.</translation>
    </message>
    <message>
        <source>Twisted prism</source>
        <translation>Prisme vrillé</translation>
    </message>
    <message>
        <source>T{1}: left out: there is no '{2}' beside the library or in its Bit folder</source>
        <translation>T{1} : omis : il n'y a pas de '{2}' à côté de la bibliothèque ou dans son dossier Bit</translation>
    </message>
    <message>
        <source>UNITS changes after lengths were given</source>
        <translation>UNITS change après que des longueurs ont été données</translation>
    </message>
    <message>
        <source>UNITS names no unit</source>
        <translation>UNITS ne nomme pas d'unité</translation>
    </message>
    <message>
        <source>Uncut (over twice the tolerance)</source>
        <translation>Non usiné (plus de deux fois la tolérance)</translation>
    </message>
    <message>
        <source>Uncut limit</source>
        <translation>Limite du non-usiné</translation>
    </message>
    <message>
        <source>Unit of the numbers in the mesh file. Default: the project's.</source>
        <translation>Unité des nombres du fichier de maillage. Par défaut : celle du projet.</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Unités</translation>
    </message>
    <message>
        <source>Upright walls ask for no pass of their own: more than twice the tolerance stays on {1} of them, up to {2}, which is no part of the verdict.</source>
        <translation>Les parois verticales ne demandent pas de passe à elles : sur {1} d'entre elles, il reste plus du double de la tolérance, jusqu'à {2}, ce qui ne compte pas dans le verdict.</translation>
    </message>
    <message>
        <source>Valley</source>
        <translation>Vallée</translation>
    </message>
    <message>
        <source>Valleys shorter than this are left out as noise, and shorter interruptions are bridged; auto is the tool's radius.</source>
        <translation>Les vallées plus courtes sont omises comme bruit, les interruptions plus courtes sont enjambées ; auto est le rayon de l'outil.</translation>
    </message>
    <message>
        <source>Vendor</source>
        <translation>Fabricant</translation>
    </message>
    <message>
        <source>Verification by removal of material</source>
        <translation>Vérification par enlèvement de matière</translation>
    </message>
    <message>
        <source>Verified: no gouge, no collision.</source>
        <translation>Vérifié : aucune entaille, aucune collision.</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Vertices have rational weights other than 1; they were ignored.</source>
        <translation>Des sommets ont des poids rationnels autres que 1 ; ils ont été ignorés.</translation>
    </message>
    <message>
        <source>View direction</source>
        <translation>Direction de vue</translation>
    </message>
    <message>
        <source>Waterline</source>
        <translation>Niveaux constants</translation>
    </message>
    <message>
        <source>What cutter, shank and holder keep from it, in cuts and in rapids.</source>
        <translation>Ce que fraise, queue et porte-outil en gardent comme distance, en coupe et en rapide.</translation>
    </message>
    <message>
        <source>What every edge takes in a turn; 0 where nobody says.</source>
        <translation>Ce que chaque dent prend par tour ; 0 si personne ne le dit.</translation>
    </message>
    <message>
        <source>What is cut.</source>
        <translation>Ce qui est usiné.</translation>
    </message>
    <message>
        <source>What is farther from the centre is not cut. auto goes as far as the part.</source>
        <translation>Ce qui est plus loin du centre n’est pas usiné. auto va aussi loin que la pièce.</translation>
    </message>
    <message>
        <source>What is left, 95 % below</source>
        <translation>Ce qui reste, 95 % au-dessous</translation>
    </message>
    <message>
        <source>What is left, 99 % below</source>
        <translation>Ce qui reste, 99 % au-dessous</translation>
    </message>
    <message>
        <source>What is left, largest</source>
        <translation>Ce qui reste, au plus</translation>
    </message>
    <message>
        <source>What is nearer to the centre is not cut.</source>
        <translation>Ce qui est plus près du centre n’est pas usiné.</translation>
    </message>
    <message>
        <source>What it is called.</source>
        <translation>Comment il s'appelle.</translation>
    </message>
    <message>
        <source>What makes the region: painted facets, a range of slope, a closed curve drawn on the part, the part's outline, what a tool leaves, or faces of a STEP or IGES file.</source>
        <translation>Ce qui fait la zone : facettes peintes, plage de pente, courbe fermée dessinée sur la pièce, contour de la pièce, ce que laisse un outil, ou faces d'un fichier STEP ou IGES.</translation>
    </message>
    <message>
        <source>What roughing leaves on the part for finishing, beside the allowance that stays in the end.</source>
        <translation>Ce que l'ébauche laisse sur la pièce pour la finition, en plus de la surépaisseur qui reste à la fin.</translation>
    </message>
    <message>
        <source>What the boundary keeps within: the place where the cutter touches the part, the tip, or all of the cutter. Roughing keeps the tip or the cutter within.</source>
        <translation>Ce que la limite garde dedans : l'endroit où la fraise touche la pièce, la pointe, ou toute la fraise. L'ébauche garde dedans la pointe ou la fraise.</translation>
    </message>
    <message>
        <source>What the part turns about: a direction of the part, or a line through two points.</source>
        <translation>Autour de quoi tourne la pièce : une direction de la pièce, ou une droite par deux points.</translation>
    </message>
    <message>
        <source>What the setup sheet calls the tool.</source>
        <translation>Nom de l'outil dans la fiche de réglage.</translation>
    </message>
    <message>
        <source>What the step does: takes small pieces away, turns facets to agree, takes needles away, fills holes, smooths noise, decimates, cuts by a plane, thickens a sheet, makes anew where the surface crosses itself, joins another scan on, takes sheets away that hang on the surface and end in the open, fills one hole or leaves it open.</source>
        <translation>Ce que fait l'étape : enlever de petits morceaux, orienter les facettes, enlever les aiguilles, remplir les trous, lisser le bruit, décimer, couper par un plan, épaissir une feuille, refaire où la surface se croise, joindre un autre scan, enlever les lambeaux qui pendent de la surface et finissent dans le vide, remplir un trou ou le laisser ouvert.</translation>
    </message>
    <message>
        <source>What the stock is larger than the part: on both sides in x, on both sides in y, on top in z. Round a cylinder whose diameter is `auto` the larger one of those across its axis counts.</source>
        <translation>De combien le brut dépasse la pièce : des deux côtés en x, des deux côtés en y, en haut en z. Autour d'un cylindre de diamètre auto compte la plus grande en travers de son axe.</translation>
    </message>
    <message>
        <source>What the tool leaves counts where it is thicker than that.</source>
        <translation>Ce que l'outil laisse compte où c'est plus épais que cela.</translation>
    </message>
    <message>
        <source>What the zero of the work coordinates is on: the part's origin, or the box of the stock or of the part. Posted programs and the setup sheet count from there; APT files are in part coordinates.</source>
        <translation>Sur quoi est l'origine : celle de la pièce, ou la boîte du brut ou de la pièce. Les programmes post-traités et la fiche de réglage comptent de là ; les fichiers APT sont en coordonnées de la pièce.</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Where along the axis the path begins, from the axis' point; auto: where the part does, and as far before it as rounded ends ask for.</source>
        <translation>Où le parcours commence le long de l'axe, depuis le point de l'axe ; auto : où commence la pièce, et avant elle autant que des bouts arrondis le demandent.</translation>
    </message>
    <message>
        <source>Where along the axis the path ends.</source>
        <translation>Où le parcours finit le long de l'axe.</translation>
    </message>
    <message>
        <source>Where an axis along x, y or z runs: through the part's origin or through the middle of its box.</source>
        <translation>Où passe un axe selon x, y ou z : par l'origine de la pièce ou le milieu de sa boîte.</translation>
    </message>
    <message>
        <source>Where it was dragged to.</source>
        <translation>Où elle a été tirée.</translation>
    </message>
    <message>
        <source>Where leads up to the assumed limit on passes all over the part take less time than the lead limit and rework together, they are used. false: the lead limit is kept. Edited regions keep it too.</source>
        <translation>Où des attaques jusqu'à la limite supposée sur des passes sur toute la pièce prennent moins de temps que la limite et la reprise ensemble, elles sont utilisées. Non : la limite est gardée. Les zones modifiées la gardent aussi.</translation>
    </message>
    <message>
        <source>Where no curves are named: the outline is divided where it reaches farthest in this direction, either way. auto picks x or y by the change of normals.</source>
        <translation>Quand aucune courbe n’est nommée : le contour est coupé là où il va le plus loin dans cette direction, dans les deux sens. auto choisit x ou y d’après le changement des normales.</translation>
    </message>
    <message>
        <source>Where on the box of stock or part the zero is, in X, Y and Z: -1 its low side, 0 its middle, 1 its high side. `0, 0, 1`: the middle of its top.</source>
        <translation>Où est l'origine sur la boîte du brut ou de la pièce, en X, Y et Z : -1 son côté bas, 0 son milieu, 1 son côté haut. `0, 0, 1` : le milieu du dessus.</translation>
    </message>
    <message>
        <source>Where passes go round, with 'Begin at' place.</source>
        <translation>Ce que les passes entourent, quand elles commencent à un point.</translation>
    </message>
    <message>
        <source>Where the boundary was.</source>
        <translation>Où était la limite.</translation>
    </message>
    <message>
        <source>Where the middle of its bottom is; how far a mesh is moved. The part's placement does not move it.</source>
        <translation>Où est le milieu de son fond ; de combien un maillage est déplacé. La mise en place de la pièce ne le bouge pas.</translation>
    </message>
    <message>
        <source>Where the tip runs: on the curve, to its left or to its right. Closed curves run counter-clockwise, so what is left lies within.</source>
        <translation>Où passe la pointe : sur la courbe, à sa gauche ou à sa droite. Les courbes fermées tournent en sens antihoraire ; la gauche est donc à l’intérieur.</translation>
    </message>
    <message>
        <source>Which objects of a 3MF or glTF file are the part, by name or number, separated by commas; `info` lists them. Empty: all on the file's build plate, or in its scene.</source>
        <translation>Quels objets d’un fichier 3MF ou glTF forment la pièce, par nom ou numéro, séparés par des virgules ; info en donne la liste. Vide : tous ceux du plateau du fichier, ou de sa scène.</translation>
    </message>
    <message>
        <source>Wider than the tool, whose diameter is {1}: walls would stay between the passes</source>
        <translation>Plus large que l'outil, dont le diamètre est {1} : des parois resteraient entre les passes</translation>
    </message>
    <message>
        <source>Winding</source>
        <translation>Comptage des tours</translation>
    </message>
    <message>
        <source>With three axes the tool stands upright everywhere.</source>
        <translation>En trois axes l'outil est vertical partout.</translation>
    </message>
    <message>
        <source>Within a cutter's radius of the part's open border no path goes on: that zone has figures of its own.</source>
        <translation>À moins d'un rayon de fraise du bord ouvert de la pièce aucun parcours ne continue : cette zone a ses propres chiffres.</translation>
    </message>
    <message>
        <source>Work coordinates</source>
        <translation>Coordonnées pièce</translation>
    </message>
    <message>
        <source>Writing</source>
        <translation>Écriture</translation>
    </message>
    <message>
        <source>Writing programs</source>
        <translation>Écriture des programmes</translation>
    </message>
    <message>
        <source>Writing the part</source>
        <translation>Écriture de la pièce</translation>
    </message>
    <message>
        <source>X or Y go home while the tool is down</source>
        <translation>X ou Y vont à leur origine pendant que l'outil est en bas</translation>
    </message>
    <message>
        <source>X, Y, Z or the feed has no word</source>
        <translation>X, Y, Z ou l'avance n'a pas de mot</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Lacet</translation>
    </message>
    <message>
        <source>Yaw limits</source>
        <translation>Limites de lacet</translation>
    </message>
    <message>
        <source>Yaw, deg</source>
        <translation>Lacet, °</translation>
    </message>
    <message>
        <source>Zero</source>
        <translation>Origine</translation>
    </message>
    <message>
        <source>Zero at</source>
        <translation>Origine en</translation>
    </message>
    <message>
        <source>Zero from</source>
        <translation>Origine depuis</translation>
    </message>
    <message>
        <source>Zero on box</source>
        <translation>Origine sur la boîte</translation>
    </message>
    <message>
        <source>a '{' is not closed</source>
        <translation>un '{' n'est pas fermé</translation>
    </message>
    <message>
        <source>a '}' stands without '{'</source>
        <translation>un '}' est sans '{'</translation>
    </message>
    <message>
        <source>a .fcholder file has one holder</source>
        <translation>un fichier .fcholder a un porte-outil</translation>
    </message>
    <message>
        <source>a .fctb file has one tool</source>
        <translation>un fichier .fctb a un outil</translation>
    </message>
    <message>
        <source>a 3MF file</source>
        <translation>un fichier 3MF</translation>
    </message>
    <message>
        <source>a BMP picture</source>
        <translation>une image BMP</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>un fichier Blender</translation>
    </message>
    <message>
        <source>a DXF file</source>
        <translation>un fichier DXF</translation>
    </message>
    <message>
        <source>a Draco file</source>
        <translation>un fichier Draco</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>une image GIF</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>une image JPEG</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>a PLY file</source>
        <translation>un fichier PLY</translation>
    </message>
    <message>
        <source>a PLY file holds at most 2 147 483 647 vertices</source>
        <translation>un fichier PLY contient au plus 2 147 483 647 sommets</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>une image PNG</translation>
    </message>
    <message>
        <source>a Parasolid file</source>
        <translation>un fichier Parasolid</translation>
    </message>
    <message>
        <source>a RAR archive</source>
        <translation>une archive RAR</translation>
    </message>
    <message>
        <source>a RIFF sound or picture</source>
        <translation>un son ou une image RIFF</translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation>un fichier STEP</translation>
    </message>
    <message>
        <source>a TIFF picture</source>
        <translation>une image TIFF</translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation>un fichier VRML</translation>
    </message>
    <message>
        <source>a ZIP archive (perhaps 3MF)</source>
        <translation>une archive ZIP (peut-être 3MF)</translation>
    </message>
    <message>
        <source>a Zstandard archive</source>
        <translation>une archive Zstandard</translation>
    </message>
    <message>
        <source>a block of its own time has no time</source>
        <translation>un bloc à temps propre n'a pas de temps</translation>
    </message>
    <message>
        <source>a bracket is not closed</source>
        <translation>une parenthèse n'est pas fermée</translation>
    </message>
    <message>
        <source>a bzip2 archive</source>
        <translation>une archive bzip2</translation>
    </message>
    <message>
        <source>a character is not plain text</source>
        <translation>un caractère n'est pas du texte simple</translation>
    </message>
    <message>
        <source>a closed curve has three corners or more</source>
        <translation>une courbe fermée a trois sommets ou plus</translation>
    </message>
    <message>
        <source>a comment is not closed, or holds another one</source>
        <translation>un commentaire n'est pas fermé, ou en contient un autre</translation>
    </message>
    <message>
        <source>a coordinate is beyond {1}</source>
        <translation>une coordonnée est au-delà de {1}</translation>
    </message>
    <message>
        <source>a coordinate is larger than {1} mm</source>
        <translation>une coordonnée dépasse {1} mm</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number</source>
        <translation>une coordonnée n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>a coordinate is too large</source>
        <translation>une coordonnée est trop grande</translation>
    </message>
    <message>
        <source>a coordinate is too large once the {1} is in its place</source>
        <translation>une coordonnée est trop grande une fois l'objet ({1}) à sa place</translation>
    </message>
    <message>
        <source>a coordinate of {1} is too large</source>
        <translation>une coordonnée de {1} est trop grande</translation>
    </message>
    <message>
        <source>a corner cannot be written as a float</source>
        <translation>un sommet ne peut être écrit en float</translation>
    </message>
    <message>
        <source>a corner is further than {1} from the origin</source>
        <translation>un sommet est à plus de {1} de l'origine</translation>
    </message>
    <message>
        <source>a corner is not a finite number</source>
        <translation>un sommet n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>a count expected, found '{1}'</source>
        <translation>un compte est attendu, trouvé : '{1}'</translation>
    </message>
    <message>
        <source>a dimension of the cutter is not a usable number</source>
        <translation>une dimension de la fraise n'est pas un nombre utilisable</translation>
    </message>
    <message>
        <source>a direction is given without an arc</source>
        <translation>un sens est donné sans arc</translation>
    </message>
    <message>
        <source>a facet has fewer than 3 corners</source>
        <translation>une facette a moins de 3 sommets</translation>
    </message>
    <message>
        <source>a facet stands outside of a solid</source>
        <translation>une facette est hors d'un solid</translation>
    </message>
    <message>
        <source>a feed of {1} mm/min has no digits left</source>
        <translation>une avance de {1} mm/min n'a plus de chiffres</translation>
    </message>
    <message>
        <source>a field has another number of values than vertices</source>
        <translation>un champ n'a pas autant de valeurs que de sommets</translation>
    </message>
    <message>
        <source>a file in memory cannot be used: {1}</source>
        <translation>un fichier en mémoire est inutilisable : {1}</translation>
    </message>
    <message>
        <source>a folder appeared in its place</source>
        <translation>un dossier est apparu à sa place</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un fichier glTF</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>une archive gzip</translation>
    </message>
    <message>
        <source>a hole would be filled with more than {1} facets</source>
        <translation>un trou serait rempli de plus de {1} facettes</translation>
    </message>
    <message>
        <source>a kind of operation</source>
        <translation>un type d'opération</translation>
    </message>
    <message>
        <source>a lead limit of 0 leaves the main path no hollows</source>
        <translation>une limite d'attaque de 0 ne laisse pas de creux au parcours principal</translation>
    </message>
    <message>
        <source>a lead of at most {1} leaves the whole part uncut with this tool</source>
        <translation>une attaque d'au plus {1} n'usine rien de la pièce avec cet outil</translation>
    </message>
    <message>
        <source>a list of {1} numbers</source>
        <translation>une liste de {1} nombres</translation>
    </message>
    <message>
        <source>a mesh has no described shape</source>
        <translation>un maillage n'a pas de forme décrite</translation>
    </message>
    <message>
        <source>a minute</source>
        <translation>une minute</translation>
    </message>
    <message>
        <source>a name has a backslash, a colon or a control character</source>
        <translation>un nom a une barre inverse, un deux-points ou un caractère de contrôle</translation>
    </message>
    <message>
        <source>a name is absolute</source>
        <translation>un nom est absolu</translation>
    </message>
    <message>
        <source>a name is empty or too long</source>
        <translation>un nom est vide ou trop long</translation>
    </message>
    <message>
        <source>a name is missing</source>
        <translation>il manque un nom</translation>
    </message>
    <message>
        <source>a name leads elsewhere</source>
        <translation>un nom mène ailleurs</translation>
    </message>
    <message>
        <source>a name occurs twice</source>
        <translation>un nom apparaît deux fois</translation>
    </message>
    <message>
        <source>a newer Facetmill wrote this study</source>
        <translation>un Facetmill plus récent a écrit cette étude</translation>
    </message>
    <message>
        <source>a number expected, found '{1}'</source>
        <translation>un nombre est attendu, trouvé : '{1}'</translation>
    </message>
    <message>
        <source>a number has a comma where other numbers have a decimal point</source>
        <translation>un nombre a une virgule où d'autres ont un point décimal</translation>
    </message>
    <message>
        <source>a number is divided by a measure</source>
        <translation>un nombre est divisé par une mesure</translation>
    </message>
    <message>
        <source>a number is missing behind '{1}'</source>
        <translation>il manque un nombre derrière '{1}'</translation>
    </message>
    <message>
        <source>a number or a word</source>
        <translation>un nombre ou un mot</translation>
    </message>
    <message>
        <source>a number or one of: {1}</source>
        <translation>un nombre ou un de : {1}</translation>
    </message>
    <message>
        <source>a number or outer loop</source>
        <translation>un nombre ou outer loop</translation>
    </message>
    <message>
        <source>a number, "project" or { "project_times": 1.1 }</source>
        <translation>un nombre, "project" ou { "project_times": 1.1 }</translation>
    </message>
    <message>
        <source>a part of an object stands outside of any</source>
        <translation>une partie d'objet est hors de tout objet</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} contact points of these tools</source>
        <translation>une pièce de {1} sur {2} demande plus de {3} points de contact de ces outils</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} contact points of this tool</source>
        <translation>une pièce de {1} sur {2} demande plus de {3} points de contact de cet outil</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for more than {3} places of this tool</source>
        <translation>une pièce de {1} sur {2} demande plus de {3} places de cet outil</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for too many passes of this tool</source>
        <translation>une pièce de {1} sur {2} demande trop de passes de cet outil</translation>
    </message>
    <message>
        <source>a part of {1} by {2} asks for too many places of this tool</source>
        <translation>une pièce de {1} sur {2} demande trop de positions de cet outil</translation>
    </message>
    <message>
        <source>a pass goes {1} into the allowance at {2}</source>
        <translation>une passe entre de {1} dans la surépaisseur à {2}</translation>
    </message>
    <message>
        <source>a place is given and no kind of motion</source>
        <translation>un endroit est donné et aucune sorte de mouvement</translation>
    </message>
    <message>
        <source>a place of the machine's own is not known here</source>
        <translation>un endroit propre à la machine n'est pas connu ici</translation>
    </message>
    <message>
        <source>a plane is tilted while the tip is led, or in another one</source>
        <translation>un plan est incliné pendant que la pointe est guidée, ou dans un autre</translation>
    </message>
    <message>
        <source>a plane is tilted, and the rotary axes have not turned to it</source>
        <translation>un plan est incliné, et les axes rotatifs n'y ont pas tourné</translation>
    </message>
    <message>
        <source>a pointer of Git LFS to a file that was not fetched</source>
        <translation>un pointeur de Git LFS vers un fichier qui n’a pas été récupéré</translation>
    </message>
    <message>
        <source>a primitive has no positions</source>
        <translation>une partie du maillage n’a pas de points</translation>
    </message>
    <message>
        <source>a program has taken the binary file for text and written it as UTF-8</source>
        <translation>un programme a pris le fichier binaire pour du texte et l’a écrit en UTF-8</translation>
    </message>
    <message>
        <source>a project cannot be the {1} of a project</source>
        <translation>un projet ne peut être le fichier d'un projet : {1}</translation>
    </message>
    <message>
        <source>a project has one setup at least</source>
        <translation>un projet a au moins un posage</translation>
    </message>
    <message>
        <source>a property before any element</source>
        <translation>une propriété avant tout élément</translation>
    </message>
    <message>
        <source>a radius and a height</source>
        <translation>un rayon et une hauteur</translation>
    </message>
    <message>
        <source>a rapid moves several axes, and they do not arrive together</source>
        <translation>un rapide déplace plusieurs axes, et ils n'arrivent pas ensemble</translation>
    </message>
    <message>
        <source>a rapid without a motion</source>
        <translation>un rapide sans mouvement</translation>
    </message>
    <message>
        <source>a rapid{1}</source>
        <translation>un rapide{1}</translation>
    </message>
    <message>
        <source>a relief needs two columns and two rows</source>
        <translation>un relief demande deux colonnes et deux lignes</translation>
    </message>
    <message>
        <source>a rotary axis goes home</source>
        <translation>un axe rotatif va à son origine</translation>
    </message>
    <message>
        <source>a rotary axis turns in a tilted plane</source>
        <translation>un axe rotatif tourne dans un plan incliné</translation>
    </message>
    <message>
        <source>a setup turns and moves the part, and cannot mirror it</source>
        <translation>un posage tourne et déplace la pièce, et ne peut la refléter</translation>
    </message>
    <message>
        <source>a sign is missing between two numbers</source>
        <translation>il manque un signe entre deux nombres</translation>
    </message>
    <message>
        <source>a step of kind {1} does not read it</source>
        <translation>une étape du type {1} ne le lit pas</translation>
    </message>
    <message>
        <source>a step-down of {1} makes more than {2} levels</source>
        <translation>une descente de {1} donne plus de {2} niveaux</translation>
    </message>
    <message>
        <source>a step-over of {1} makes</source>
        <translation>un pas latéral de {1} fait</translation>
    </message>
    <message>
        <source>a step-over of {1} makes more than {2} drive planes</source>
        <translation>un pas latéral de {1} fait plus de {2} plans directeurs</translation>
    </message>
    <message>
        <source>a step-over of {1} with a cutter of diameter {2} leaves walls between the lines</source>
        <translation>un pas latéral de {1} avec une fraise de diamètre {2} laisse des parois entre les lignes</translation>
    </message>
    <message>
        <source>a stick-out of {1} below the holder instead of {2}</source>
        <translation>une sortie de {1} sous le porte-outil au lieu de {2}</translation>
    </message>
    <message>
        <source>a strip names vertex {1}, the file has {2} (from 0)</source>
        <translation>une bande nomme le sommet {1}, le fichier en a {2} (depuis 0)</translation>
    </message>
    <message>
        <source>a surface has a place that is not finite</source>
        <translation>une surface a un endroit qui n'est pas fini</translation>
    </message>
    <message>
        <source>a table tells no shape and no lengths: taken for a ball end with usual flutes and shank</source>
        <translation>une table ne dit ni forme ni longueurs : pris pour une hémisphérique aux longueurs usuelles</translation>
    </message>
    <message>
        <source>a table tells no shape and no lengths: taken for a flat end with usual flutes and shank</source>
        <translation>une table ne dit ni forme ni longueurs : pris pour une fraise plate aux longueurs usuelles</translation>
    </message>
    <message>
        <source>a tar archive</source>
        <translation>une archive tar</translation>
    </message>
    <message>
        <source>a text that does not start with 'solid'</source>
        <translation>un texte qui ne commence pas par 'solid'</translation>
    </message>
    <message>
        <source>a tool axis is given as a vector, and no code says so</source>
        <translation>un axe d'outil est donné par un vecteur, et aucun code ne le dit</translation>
    </message>
    <message>
        <source>a tool axis lies down</source>
        <translation>un axe d'outil est couché</translation>
    </message>
    <message>
        <source>a tool fits but does not go there</source>
        <translation>un outil y passe, mais n'y va pas</translation>
    </message>
    <message>
        <source>a tool is changed and none was named</source>
        <translation>un outil est changé et aucun n'a été nommé</translation>
    </message>
    <message>
        <source>a tool length is called without a number</source>
        <translation>une longueur d'outil est appelée sans numéro</translation>
    </message>
    <message>
        <source>a tool pose is not finite or its axis is no unit vector</source>
        <translation>une pose d'outil n'est pas finie ou son axe n'est pas un vecteur unité</translation>
    </message>
    <message>
        <source>a tool that cuts into the part is not inclined</source>
        <translation>un outil qui usine dans la pièce n’est pas incliné</translation>
    </message>
    <message>
        <source>a transfer as text has changed the binary file: there is a CR before every LF</source>
        <translation>un transfert en mode texte a changé le fichier binaire : il y a un CR avant chaque LF</translation>
    </message>
    <message>
        <source>a triangle names a sample that there is not</source>
        <translation>un triangle nomme un échantillon qui n'existe pas</translation>
    </message>
    <message>
        <source>a triangle names the vertex {1} of {2}</source>
        <translation>un triangle nomme le sommet {1} sur {2}</translation>
    </message>
    <message>
        <source>a vertex has 5 numbers</source>
        <translation>un sommet a 5 nombres</translation>
    </message>
    <message>
        <source>a vertex has fewer than 3 numbers</source>
        <translation>un sommet a moins de 3 nombres</translation>
    </message>
    <message>
        <source>a vertex has more than 7 numbers</source>
        <translation>un sommet a plus de 7 nombres</translation>
    </message>
    <message>
        <source>a vertex has no {1}</source>
        <translation>il manque {1} à un sommet</translation>
    </message>
    <message>
        <source>a vertex is further than {1} from the origin</source>
        <translation>un sommet est à plus de {1} de l'origine</translation>
    </message>
    <message>
        <source>a vertex number expected, found '{1}'</source>
        <translation>un numéro de sommet est attendu, trouvé : '{1}'</translation>
    </message>
    <message>
        <source>a web page</source>
        <translation>une page web</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a {1} of kind '{2}' has no such key</source>
        <translation>{1} du type '{2}' n'a pas cette clé</translation>
    </message>
    <message>
        <source>about {1} million points, {2} GB, {3}</source>
        <translation>environ {1} millions de points, {2} Go, {3}</translation>
    </message>
    <message>
        <source>above -90° and below 90°</source>
        <translation>au-dessus de -90° et sous 90°</translation>
    </message>
    <message>
        <source>above 0° and at most 90°</source>
        <translation>au-dessus de 0° et au plus 90°</translation>
    </message>
    <message>
        <source>above {1}</source>
        <translation>au-dessus de {1}</translation>
    </message>
    <message>
        <source>above {1} and at most {2}</source>
        <translation>au-dessus de {1} et au plus {2}</translation>
    </message>
    <message>
        <source>adaptive</source>
        <translation>adaptatif</translation>
    </message>
    <message>
        <source>add "facetmill": {1}; is this a project file?</source>
        <translation>ajouter "facetmill": {1} ; est-ce un fichier de projet ?</translation>
    </message>
    <message>
        <source>add CUTTER/d,r,e,f,alpha,beta,h before the first GOTO</source>
        <translation>ajouter CUTTER/d,r,e,f,alpha,beta,h avant le premier GOTO</translation>
    </message>
    <message>
        <source>add a CL between, which says in which plane it turns</source>
        <translation>ajouter entre eux un CL, qui dit dans quel plan il tourne</translation>
    </message>
    <message>
        <source>add a box, choose the kind "tab" and move it to its place</source>
        <translation>ajouter une boîte, choisir le type attache et la déplacer à sa place</translation>
    </message>
    <message>
        <source>add a tool</source>
        <translation>ajoutez un outil</translation>
    </message>
    <message>
        <source>add an operation</source>
        <translation>ajouter une opération</translation>
    </message>
    <message>
        <source>add i, j and k to words</source>
        <translation>ajouter i, j et k à words</translation>
    </message>
    <message>
        <source>add i, j and k to words, or centre_x and so on</source>
        <translation>ajouter i, j et k à words, ou centre_x et ainsi de suite</translation>
    </message>
    <message>
        <source>add it to the project's tools</source>
        <translation>l'ajouter aux outils du projet</translation>
    </message>
    <message>
        <source>add it to the words of the post</source>
        <translation>l'ajouter aux mots du post-processeur</translation>
    </message>
    <message>
        <source>add one to codes</source>
        <translation>en ajouter un à codes</translation>
    </message>
    <message>
        <source>add one, or write true</source>
        <translation>en ajouter un, ou écrire true</translation>
    </message>
    <message>
        <source>add radius to words</source>
        <translation>ajouter radius à words</translation>
    </message>
    <message>
        <source>all around</source>
        <translation>tout autour</translation>
    </message>
    <message>
        <source>all cutting data but the first</source>
        <translation>toutes les conditions de coupe sauf les premières</translation>
    </message>
    <message>
        <source>all facets of the part face along the turning axis</source>
        <translation>toutes les facettes de la pièce regardent le long de l'axe de rotation</translation>
    </message>
    <message>
        <source>all is cut by levels: nothing is less steep than the divide</source>
        <translation>tout est usiné par niveaux : rien n'est moins raide que la limite</translation>
    </message>
    <message>
        <source>all is cut by levels: {1}</source>
        <translation>tout est usiné par niveaux : {1}</translation>
    </message>
    <message>
        <source>all is cut by passes side by side: {1}</source>
        <translation>tout est usiné par passes côte à côte : {1}</translation>
    </message>
    <message>
        <source>all of it lies off the part</source>
        <translation>elle est tout entière hors de la pièce</translation>
    </message>
    <message>
        <source>all of it lies off the part, as at {1}</source>
        <translation>elle est entièrement hors de la pièce, par exemple en {1}</translation>
    </message>
    <message>
        <source>all of them are switched off</source>
        <translation>toutes sont désactivées</translation>
    </message>
    <message>
        <source>all strips are switched off</source>
        <translation>toutes les bandes sont désactivées</translation>
    </message>
    <message>
        <source>allow a larger chord tolerance, or export the parts one by one</source>
        <translation>permettre une tolérance de corde plus grande, ou exporter les pièces une à une</translation>
    </message>
    <message>
        <source>allow a larger one</source>
        <translation>en permettre une plus grande</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a side feed</source>
        <translation>admettez une tolérance plus grande ou indiquez une avance latérale</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a step-down</source>
        <translation>permettre une plus grande tolérance ou donner une descente</translation>
    </message>
    <message>
        <source>allow a larger tolerance or set a step-over</source>
        <translation>permettre une tolérance plus grande ou fixer un pas latéral</translation>
    </message>
    <message>
        <source>allow a larger tolerance or tessellate the part more finely</source>
        <translation>permettre une tolérance plus grande ou mailler la pièce plus finement</translation>
    </message>
    <message>
        <source>allow a larger tolerance, or use a tool with a larger corner radius</source>
        <translation>permettre une tolérance plus grande, ou prendre un outil de plus grand rayon de coin</translation>
    </message>
    <message>
        <source>allow a larger tolerance, set a depth, or take a tool with a flat end</source>
        <translation>permettre une tolérance plus grande, fixer une profondeur, ou prendre un outil à bout plat</translation>
    </message>
    <message>
        <source>allow a larger tolerance, use a tool with a larger corner radius, or switch strips off</source>
        <translation>permettre une tolérance plus grande, prendre un outil de plus grand rayon de coin, ou désactiver des bandes</translation>
    </message>
    <message>
        <source>allowed: {1}</source>
        <translation>permis : {1}</translation>
    </message>
    <message>
        <source>along the tool axis</source>
        <translation>le long de l'axe d'outil</translation>
    </message>
    <message>
        <source>an AppleDouble file, which macOS puts beside the mesh</source>
        <translation>un fichier AppleDouble, que macOS pose à côté du maillage</translation>
    </message>
    <message>
        <source>an IGES file</source>
        <translation>un fichier IGES</translation>
    </message>
    <message>
        <source>an OBJ file</source>
        <translation>un fichier OBJ</translation>
    </message>
    <message>
        <source>an OFF file</source>
        <translation>un fichier OFF</translation>
    </message>
    <message>
        <source>an Office or SolidWorks document</source>
        <translation>un document Office ou SolidWorks</translation>
    </message>
    <message>
        <source>an STL file</source>
        <translation>un fichier STL</translation>
    </message>
    <message>
        <source>an STL file holds at most 4 294 967 294 facets</source>
        <translation>un fichier STL contient au plus 4 294 967 294 facettes</translation>
    </message>
    <message>
        <source>an XML document</source>
        <translation>un document XML</translation>
    </message>
    <message>
        <source>an arc begins at a place that is not known</source>
        <translation>un arc commence à un endroit inconnu</translation>
    </message>
    <message>
        <source>an arc begins {1} mm from its centre and ends {2} mm from it</source>
        <translation>un arc commence à {1} mm de son centre et finit à {2} mm</translation>
    </message>
    <message>
        <source>an arc has a centre and a radius</source>
        <translation>un arc a un centre et un rayon</translation>
    </message>
    <message>
        <source>an arc has a word that is read over</source>
        <translation>un arc a un mot qui est ignoré</translation>
    </message>
    <message>
        <source>an arc has neither centre nor radius</source>
        <translation>un arc n'a ni centre ni rayon</translation>
    </message>
    <message>
        <source>an arc has no centre</source>
        <translation>un arc n'a pas de centre</translation>
    </message>
    <message>
        <source>an arc has no direction</source>
        <translation>un arc n'a pas de sens</translation>
    </message>
    <message>
        <source>an arc has no radius</source>
        <translation>un arc n'a pas de rayon</translation>
    </message>
    <message>
        <source>an arc has two directions</source>
        <translation>un arc a deux sens</translation>
    </message>
    <message>
        <source>an arc is given, and nothing says in which plane</source>
        <translation>un arc est donné, et rien ne dit dans quel plan</translation>
    </message>
    <message>
        <source>an arc is no rapid</source>
        <translation>un arc n'est pas un rapide</translation>
    </message>
    <message>
        <source>an arc turns a rotary axis</source>
        <translation>un arc tourne un axe rotatif</translation>
    </message>
    <message>
        <source>an axis calls at a place of the part on its way home</source>
        <translation>un axe passe par un endroit de la pièce en allant à son origine</translation>
    </message>
    <message>
        <source>an axis goes home while the tip is led or in a tilted plane</source>
        <translation>un axe va à son origine pendant que la pointe est guidée ou dans un plan incliné</translation>
    </message>
    <message>
        <source>an axis has no number</source>
        <translation>un axe n'a pas de nombre</translation>
    </message>
    <message>
        <source>an empty ZIP archive</source>
        <translation>une archive ZIP vide</translation>
    </message>
    <message>
        <source>an entry has no name or no size</source>
        <translation>une entrée n'a pas de nom ou de taille</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>an object has too many vertices</source>
        <translation>un objet a trop de sommets</translation>
    </message>
    <message>
        <source>an object stands in another one</source>
        <translation>un objet est dans un autre</translation>
    </message>
    <message>
        <source>an object with the key "facetmill"</source>
        <translation>un objet avec la clé "facetmill"</translation>
    </message>
    <message>
        <source>an operation on a part that turns knows no boundaries</source>
        <translation>une opération sur une pièce tournante ne connaît pas de limites</translation>
    </message>
    <message>
        <source>an order leaves operations out</source>
        <translation>un ordre omet des opérations</translation>
    </message>
    <message>
        <source>an order of operations is a list of their names</source>
        <translation>un ordre d'opérations est une liste de leurs noms</translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation>une archive xz</translation>
    </message>
    <message>
        <source>and {1} more</source>
        <translation>et {1} autres</translation>
    </message>
    <message>
        <source>another STL file follows the first in it</source>
        <translation>un autre fichier STL y suit le premier</translation>
    </message>
    <message>
        <source>another program works on this study ({1}; this is {2})</source>
        <translation>un autre programme travaille à cette étude ({1} ; celui-ci est {2})</translation>
    </message>
    <message>
        <source>another run works on this study</source>
        <translation>une autre exécution travaille à cette étude</translation>
    </message>
    <message>
        <source>another {1} is called '{2}'</source>
        <translation>autre chose ({1}) s'appelle déjà '{2}'</translation>
    </message>
    <message>
        <source>arcs about a centre of their own block are told in XY and do not climb</source>
        <translation>les arcs autour d'un centre dans un bloc à part sont en XY et ne montent pas</translation>
    </message>
    <message>
        <source>around</source>
        <translation>autour</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>as many answers as points are needed</source>
        <translation>il faut autant de réponses que de points</translation>
    </message>
    <message>
        <source>as many lifts as poses are needed</source>
        <translation>il faut autant de levées que de poses</translation>
    </message>
    <message>
        <source>as many lifts as postures are needed</source>
        <translation>il faut autant de levées que de postures</translation>
    </message>
    <message>
        <source>at least {1}</source>
        <translation>au moins {1}</translation>
    </message>
    <message>
        <source>at most 1.4 thousand million are possible</source>
        <translation>au plus 1,4 milliard sont possibles</translation>
    </message>
    <message>
        <source>at most {1}</source>
        <translation>au plus {1}</translation>
    </message>
    <message>
        <source>at {1} % of the places looked at even the smallest side feed leaves more than {2}: walls that face along the passes, or a cutter with a sharp corner</source>
        <translation>à {1} % des endroits examinés, même la plus petite avance latérale laisse plus de {2} : parois le long des passes, ou fraise à coin vif</translation>
    </message>
    <message>
        <source>at {1} of {2} places the tool meets nothing on its way to the axis and stops at the core radius of {3}: holes through the axis, or ends of the part that are cut down to it</source>
        <translation>à {1} des {2} endroits l'outil ne rencontre rien vers l'axe et s'arrête au rayon du noyau de {3} : trous par l'axe, ou bouts de la pièce usinés jusque-là</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>auto</translation>
    </message>
    <message>
        <source>auto: where parts of the surface that an axis reaches do not face up (walls, undersides, both faces of a blade), the part is cut side by side, each connected piece seen from its own side, with the yaw free and a posture grid twice as coarse; what no axis reaches is said. top: everything is cut as it is seen from above.</source>
        <translation>auto : où des parties de la surface qu'un axe atteint ne regardent pas vers le haut (parois, dessous, deux faces d'une aube), la pièce est usinée côté par côté, chaque morceau connexe vu de son côté, le lacet libre et une grille de postures deux fois plus grossière ; ce qu'aucun axe n'atteint est dit. haut : tout est usiné comme vu d'en haut.</translation>
    </message>
    <message>
        <source>avoid fewer facets, or cut within a boundary that leaves them out</source>
        <translation>éviter moins de facettes, ou usiner dans une limite qui les exclut</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>boule</translation>
    </message>
    <message>
        <source>ball cuts the regions with a ball and a vertical axis; cm2 with a smaller flat or bull-nosed tool whose lead matches the curvature.</source>
        <translation>boule usine les zones avec une hémisphérique et un axe vertical ; à courbure ajustée (CM²) avec un outil plat ou torique plus petit dont l'attaque ajuste la courbure.</translation>
    </message>
    <message>
        <source>ball end mill</source>
        <translation>fraise hémisphérique</translation>
    </message>
    <message>
        <source>beside {1} of {2} contact points no posture clears the whole strip: it is cut under the pass, and left to clean-up beside it</source>
        <translation>à côté de {1} des {2} points de contact, aucune posture n'enlève toute la bande : elle est usinée sous la passe et laissée au nettoyage à côté</translation>
    </message>
    <message>
        <source>between its radii there is nothing</source>
        <translation>il n’y a rien entre ses rayons</translation>
    </message>
    <message>
        <source>border</source>
        <translation>bord</translation>
    </message>
    <message>
        <source>border: passes follow the border of what is cut; curve: they lie on both sides of a curve; place: they go round a place on the part.</source>
        <translation>bord : les passes suivent le bord de ce qui est usiné ; courbe : elles se rangent des deux côtés d'une courbe ; point : elles entourent un point de la pièce.</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>bottom angle and taper angle make no convex cutter</source>
        <translation>angle de fond et angle de cône ne font pas une fraise convexe</translation>
    </message>
    <message>
        <source>bottom angle {1} and taper angle {2} make no convex cutter</source>
        <translation>angle de fond {1} et angle de cône {2} ne font pas une fraise convexe</translation>
    </message>
    <message>
        <source>bottom {1}°</source>
        <translation>fond {1}°</translation>
    </message>
    <message>
        <source>boundaries there are: {1}</source>
        <translation>limites existantes : {1}</translation>
    </message>
    <message>
        <source>boundary '{1}'</source>
        <translation>limite '{1}'</translation>
    </message>
    <message>
        <source>boundary '{1}' is what this tool leaves</source>
        <translation>la limite '{1}' est ce que laisse cet outil</translation>
    </message>
    <message>
        <source>box</source>
        <translation>boîte</translation>
    </message>
    <message>
        <source>box, {1}</source>
        <translation>boîte, {1}</translation>
    </message>
    <message>
        <source>bring rotary axes, X and Y to the start first</source>
        <translation>amener d'abord les axes rotatifs, X et Y au début</translation>
    </message>
    <message>
        <source>bring rotary axes, X and Y to the start first, and give X, Y and Z</source>
        <translation>amener d'abord les axes rotatifs, X et Y au début, et donner X, Y et Z</translation>
    </message>
    <message>
        <source>bring the rotary axes to where it is held before it</source>
        <translation>amener avant les axes rotatifs où il est tenu</translation>
    </message>
    <message>
        <source>bring them there before it, so that the control has nothing to choose</source>
        <translation>les y amener avant, pour que la commande n'ait rien à choisir</translation>
    </message>
    <message>
        <source>bull nose end mill</source>
        <translation>fraise torique</translation>
    </message>
    <message>
        <source>call it</source>
        <translation>l'appeler</translation>
    </message>
    <message>
        <source>call it before</source>
        <translation>l'appeler avant</translation>
    </message>
    <message>
        <source>call its edge before it</source>
        <translation>appeler son arête avant</translation>
    </message>
    <message>
        <source>call its own</source>
        <translation>appeler la sienne</translation>
    </message>
    <message>
        <source>candidate {1}</source>
        <translation>candidat {1}</translation>
    </message>
    <message>
        <source>cannot be reached: {1} of the surface ({2}) around {3}: {4}</source>
        <translation>hors d'atteinte : {1} de la surface ({2}) autour de {3} : {4}</translation>
    </message>
    <message>
        <source>cannot be reached: {1} smaller places; {2} of the surface in all</source>
        <translation>hors d'atteinte : {1} endroits plus petits ; {2} de la surface en tout</translation>
    </message>
    <message>
        <source>cannot be unpacked for this run: {1}</source>
        <translation>ne peut être décompressé pour cette exécution : {1}</translation>
    </message>
    <message>
        <source>cannot be unpacked: {1}</source>
        <translation>ne peut être décompressé : {1}</translation>
    </message>
    <message>
        <source>cannot make the folder: {1}</source>
        <translation>le dossier ne peut être créé : {1}</translation>
    </message>
    <message>
        <source>cannot make the folder{1}</source>
        <translation>le dossier ne peut être créé{1}</translation>
    </message>
    <message>
        <source>cannot open the file: {1}</source>
        <translation>le fichier ne peut être ouvert : {1}</translation>
    </message>
    <message>
        <source>cannot write the file: {1}</source>
        <translation>le fichier ne peut être écrit : {1}</translation>
    </message>
    <message>
        <source>center drill</source>
        <translation>foret à centrer</translation>
    </message>
    <message>
        <source>chamfer mill</source>
        <translation>fraise à chanfreiner</translation>
    </message>
    <message>
        <source>change it</source>
        <translation>le changer</translation>
    </message>
    <message>
        <source>change the operation's limits, or the part's place on the machine</source>
        <translation>changer les limites de l'opération, ou la place de la pièce sur la machine</translation>
    </message>
    <message>
        <source>check `place` of both setups and where the stock's mesh is, or let the setup go on with the rest</source>
        <translation>vérifier `place` des deux posages et où est le maillage du brut, ou laisser le posage continuer avec le reste</translation>
    </message>
    <message>
        <source>check boundary, slopes and tool</source>
        <translation>vérifiez limite, pentes et outil</translation>
    </message>
    <message>
        <source>check commas, quotes and braces</source>
        <translation>vérifier virgules, guillemets et accolades</translation>
    </message>
    <message>
        <source>check its end and its centre</source>
        <translation>vérifier sa fin et son centre</translation>
    </message>
    <message>
        <source>check its end and its radius</source>
        <translation>vérifier sa fin et son rayon</translation>
    </message>
    <message>
        <source>check its permissions</source>
        <translation>vérifier ses permissions</translation>
    </message>
    <message>
        <source>check its place, permissions and the disk</source>
        <translation>vérifier son emplacement, les droits et le disque</translation>
    </message>
    <message>
        <source>check part and boundary</source>
        <translation>vérifier la pièce et la limite</translation>
    </message>
    <message>
        <source>check part and curves</source>
        <translation>vérifier la pièce et les courbes</translation>
    </message>
    <message>
        <source>check part and direction</source>
        <translation>vérifier pièce et direction</translation>
    </message>
    <message>
        <source>check part, centre and radii</source>
        <translation>vérifier la pièce, le centre et les rayons</translation>
    </message>
    <message>
        <source>check part, tool and direction</source>
        <translation>vérifier pièce, outil et direction</translation>
    </message>
    <message>
        <source>check part, tool and divide</source>
        <translation>vérifier pièce, outil et limite</translation>
    </message>
    <message>
        <source>check part, tool and tolerance</source>
        <translation>vérifier pièce, outil et tolérance</translation>
    </message>
    <message>
        <source>check part, tools and machine</source>
        <translation>vérifiez pièce, outils et machine</translation>
    </message>
    <message>
        <source>check start, stop, chuck and tailstock</source>
        <translation>vérifiez début, fin, mandrin et contre-pointe</translation>
    </message>
    <message>
        <source>check that it is an APT CL file</source>
        <translation>vérifier que c'est un fichier CL APT</translation>
    </message>
    <message>
        <source>check the axis</source>
        <translation>vérifier l'axe</translation>
    </message>
    <message>
        <source>check the axis, the core radius and where the path starts and stops</source>
        <translation>vérifier l'axe, le rayon du noyau et où le parcours commence et finit</translation>
    </message>
    <message>
        <source>check the boundary</source>
        <translation>vérifiez la limite</translation>
    </message>
    <message>
        <source>check the directions</source>
        <translation>vérifier les directions</translation>
    </message>
    <message>
        <source>check the disk</source>
        <translation>vérifier le disque</translation>
    </message>
    <message>
        <source>check the file</source>
        <translation>vérifier le fichier</translation>
    </message>
    <message>
        <source>check the file and its units</source>
        <translation>vérifier le fichier et ses unités</translation>
    </message>
    <message>
        <source>check the folder, its permissions and the free space</source>
        <translation>vérifier le dossier, ses permissions et la place libre</translation>
    </message>
    <message>
        <source>check the folder, its permissions and the free space, or name another one in TMPDIR</source>
        <translation>vérifier le dossier, ses permissions et la place libre, ou en nommer un autre dans TMPDIR</translation>
    </message>
    <message>
        <source>check the free space of temporary files</source>
        <translation>vérifier la place des fichiers temporaires</translation>
    </message>
    <message>
        <source>check the free space of temporary files, or name another folder in TMPDIR</source>
        <translation>vérifier la place des fichiers temporaires, ou nommer un autre dossier dans TMPDIR</translation>
    </message>
    <message>
        <source>check the mesh</source>
        <translation>vérifier le maillage</translation>
    </message>
    <message>
        <source>check the mesh's units and numbers</source>
        <translation>vérifier les unités et nombres du maillage</translation>
    </message>
    <message>
        <source>check the name</source>
        <translation>vérifier le nom</translation>
    </message>
    <message>
        <source>check the number for a point that was lost</source>
        <translation>vérifier si un point du nombre s'est perdu</translation>
    </message>
    <message>
        <source>check the part</source>
        <translation>vérifier la pièce</translation>
    </message>
    <message>
        <source>check the part's place and the program</source>
        <translation>vérifier la place de la pièce et le programme</translation>
    </message>
    <message>
        <source>check the part's units</source>
        <translation>vérifier les unités de la pièce</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool</source>
        <translation>vérifier l'unité de la pièce, ou prendre un outil plus grand</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool or step-over</source>
        <translation>vérifier les unités de la pièce, ou prendre outil ou pas latéral plus grands</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool or tolerance</source>
        <translation>vérifier les unités de la pièce, ou prendre outil ou tolérance plus grands</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool, tolerance or side feed</source>
        <translation>vérifier les unités de la pièce, ou prendre outil, tolérance ou avance latérale plus grands</translation>
    </message>
    <message>
        <source>check the part's units, or take a larger tool, tolerance or step-over</source>
        <translation>vérifier les unités de la pièce, ou prendre outil, tolérance ou pas latéral plus grands</translation>
    </message>
    <message>
        <source>check the part's units, or take larger tools</source>
        <translation>vérifier les unités de la pièce, ou prendre de plus grands outils</translation>
    </message>
    <message>
        <source>check the path</source>
        <translation>vérifier le chemin</translation>
    </message>
    <message>
        <source>check the placements, or give the setup a stock of its own</source>
        <translation>vérifier les mises en place, ou donner au posage un brut à lui</translation>
    </message>
    <message>
        <source>check the program</source>
        <translation>vérifier le programme</translation>
    </message>
    <message>
        <source>check the program and the machine</source>
        <translation>vérifier le programme et la machine</translation>
    </message>
    <message>
        <source>check the program's units</source>
        <translation>vérifier les unités du programme</translation>
    </message>
    <message>
        <source>check the stock's size and place</source>
        <translation>vérifier la taille et la place du brut</translation>
    </message>
    <message>
        <source>check the tool</source>
        <translation>vérifier l'outil</translation>
    </message>
    <message>
        <source>check the units and the origin of the program</source>
        <translation>vérifier les unités et l'origine du programme</translation>
    </message>
    <message>
        <source>check the {1}'s units and translate</source>
        <translation>vérifier unité et translation ({1})</translation>
    </message>
    <message>
        <source>check tool, allowance and stock</source>
        <translation>vérifier outil, surépaisseur et brut</translation>
    </message>
    <message>
        <source>choose a ball, or let it match the curvature (CM2)</source>
        <translation>choisir une hémisphérique, ou laisser ajuster la courbure (CM2)</translation>
    </message>
    <message>
        <source>choose a flat or bull-nosed tool, or cut the regions as with a ball</source>
        <translation>choisir un outil plat ou torique, ou usiner les zones comme avec une boule</translation>
    </message>
    <message>
        <source>choose a larger angle, such as 3°</source>
        <translation>choisir un angle plus grand, comme 3°</translation>
    </message>
    <message>
        <source>choose a larger angle, such as 3°, or narrower limits</source>
        <translation>choisir un angle plus grand, comme 3°, ou des limites plus étroites</translation>
    </message>
    <message>
        <source>choose a larger depth of cut</source>
        <translation>choisir une profondeur de passe plus grande</translation>
    </message>
    <message>
        <source>choose a larger depth or tolerance</source>
        <translation>choisir une profondeur ou une tolérance plus grande</translation>
    </message>
    <message>
        <source>choose a larger side feed or tolerance</source>
        <translation>choisir une avance latérale ou une tolérance plus grande</translation>
    </message>
    <message>
        <source>choose a larger step-down</source>
        <translation>choisir une plus grande descente</translation>
    </message>
    <message>
        <source>choose a larger step-over</source>
        <translation>choisir un pas latéral plus grand</translation>
    </message>
    <message>
        <source>choose a larger step-over or tolerance</source>
        <translation>choisir un pas latéral ou une tolérance plus grands</translation>
    </message>
    <message>
        <source>choose a larger tolerance or step-over</source>
        <translation>choisir une tolérance ou un pas latéral plus grand</translation>
    </message>
    <message>
        <source>choose a larger tool or a smaller tolerance</source>
        <translation>choisissez un outil plus grand ou une tolérance plus petite</translation>
    </message>
    <message>
        <source>choose a smaller allowance, or a larger stock</source>
        <translation>choisir une surépaisseur plus petite ou un brut plus grand</translation>
    </message>
    <message>
        <source>choose a smaller core radius</source>
        <translation>choisir un rayon de noyau plus petit</translation>
    </message>
    <message>
        <source>choose a smaller depth or a longer tool</source>
        <translation>choisir une profondeur plus petite ou un outil plus long</translation>
    </message>
    <message>
        <source>choose a smaller offset or the other side</source>
        <translation>choisir un décalage plus petit ou l’autre côté</translation>
    </message>
    <message>
        <source>choose a smaller tool, or the one that cut before</source>
        <translation>choisir un outil plus petit, ou celui qui a usiné avant</translation>
    </message>
    <message>
        <source>choose another format or other tools</source>
        <translation>choisir un autre format ou d'autres outils</translation>
    </message>
    <message>
        <source>choose another machine or tool, turn the part, or place it elsewhere on the machine</source>
        <translation>choisir une autre machine ou un autre outil, tourner la pièce, ou la placer ailleurs sur la machine</translation>
    </message>
    <message>
        <source>choose another name</source>
        <translation>choisir un autre nom</translation>
    </message>
    <message>
        <source>choose another part</source>
        <translation>choisir une autre pièce</translation>
    </message>
    <message>
        <source>choose another post</source>
        <translation>choisir un autre post-processeur</translation>
    </message>
    <message>
        <source>choose another program number</source>
        <translation>choisir un autre numéro de programme</translation>
    </message>
    <message>
        <source>choose at most the diameter</source>
        <translation>choisir au plus le diamètre</translation>
    </message>
    <message>
        <source>choose one that is</source>
        <translation>choisissez-en un qui y est</translation>
    </message>
    <message>
        <source>choose other slopes</source>
        <translation>choisissez d’autres pentes</translation>
    </message>
    <message>
        <source>choose some of its objects</source>
        <translation>choisir certains de ses objets</translation>
    </message>
    <message>
        <source>choose the machine it runs on</source>
        <translation>choisir la machine sur laquelle il tourne</translation>
    </message>
    <message>
        <source>choose the machine that it runs on</source>
        <translation>choisir la machine où il s'exécute</translation>
    </message>
    <message>
        <source>choose the setup's</source>
        <translation>choisir celui du posage</translation>
    </message>
    <message>
        <source>chuck and tailstock keep the tool from {1} of the part's length, which stays uncut</source>
        <translation>mandrin et contre-pointe écartent l'outil de {1} de la longueur de la pièce, qui reste non usinée</translation>
    </message>
    <message>
        <source>chuck and tailstock leave no room for the tool between them</source>
        <translation>mandrin et contre-pointe ne laissent pas de place à l'outil entre eux</translation>
    </message>
    <message>
        <source>chuck or tailstock keep the cutter from the part</source>
        <translation>mandrin ou contre-pointe écartent la fraise de la pièce</translation>
    </message>
    <message>
        <source>clearance and chord tolerance must be above 0, the link distance at least 0</source>
        <translation>distance de sécurité et tolérance de corde doivent être au-dessus de 0, la distance de liaison au moins 0</translation>
    </message>
    <message>
        <source>click into a hole, on a boss, or on the flat face beside a hole</source>
        <translation>cliquer dans un trou, sur un bossage, ou sur la face plane à côté d'un trou</translation>
    </message>
    <message>
        <source>close it, or use a box or cylinder</source>
        <translation>le fermer, ou prendre une boîte ou un cylindre</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>fermer d'autres programmes</translation>
    </message>
    <message>
        <source>cm2</source>
        <translation>cm2</translation>
    </message>
    <message>
        <source>come down straight</source>
        <translation>descendre droit</translation>
    </message>
    <message>
        <source>comments begin with ( or ;</source>
        <translation>les commentaires commencent par ( ou ;</translation>
    </message>
    <message>
        <source>contact</source>
        <translation>contact</translation>
    </message>
    <message>
        <source>content {1}</source>
        <translation>contenu {1}</translation>
    </message>
    <message>
        <source>copy it again as binary (FTP: type binary; Git: mark *.stl as binary)</source>
        <translation>le copier de nouveau en binaire (FTP : type binary ; Git : marquer *.stl binary)</translation>
    </message>
    <message>
        <source>copy or export it again</source>
        <translation>le copier ou l'exporter de nouveau</translation>
    </message>
    <message>
        <source>copy or save it again</source>
        <translation>le copier ou l'enregistrer de nouveau</translation>
    </message>
    <message>
        <source>corner</source>
        <translation>sommet</translation>
    </message>
    <message>
        <source>corners</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>correct e and f, or enter 0 for both</source>
        <translation>corriger e et f, ou entrer 0 pour les deux</translation>
    </message>
    <message>
        <source>correct r, e and f, or give the diameter at which bottom and side line meet</source>
        <translation>corriger r, e et f, ou donner le diamètre où se rencontrent les lignes de fond et de côté</translation>
    </message>
    <message>
        <source>correct shank and holder</source>
        <translation>corriger queue et porte-outil</translation>
    </message>
    <message>
        <source>correct the operation's settings</source>
        <translation>corriger les réglages de l'opération</translation>
    </message>
    <message>
        <source>correct the program</source>
        <translation>corriger le programme</translation>
    </message>
    <message>
        <source>correct the stock's place and size</source>
        <translation>corriger la taille et la place du brut</translation>
    </message>
    <message>
        <source>correct the table</source>
        <translation>corriger la table</translation>
    </message>
    <message>
        <source>correct them in the part's settings</source>
        <translation>les corriger dans les réglages de la pièce</translation>
    </message>
    <message>
        <source>counter bore</source>
        <translation>fraise à lamer</translation>
    </message>
    <message>
        <source>counter sink</source>
        <translation>fraise à noyer</translation>
    </message>
    <message>
        <source>crossings</source>
        <translation>croisements</translation>
    </message>
    <message>
        <source>cubic B-spline</source>
        <translation>B-spline cubique</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>courbe</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>coupe</translation>
    </message>
    <message>
        <source>cut them with the part held another way</source>
        <translation>les usiner avec la pièce tenue autrement</translation>
    </message>
    <message>
        <source>cut: closes the section with facets in the plane.</source>
        <translation>coupe : ferme la section par des facettes dans le plan.</translation>
    </message>
    <message>
        <source>cut: the plane's direction; what lies on this side of it goes.</source>
        <translation>coupe : la direction du plan ; ce qui est de ce côté part.</translation>
    </message>
    <message>
        <source>cut: the plane's distance from the file's origin along the normal.</source>
        <translation>coupe : la distance du plan à l'origine du fichier le long de la normale.</translation>
    </message>
    <message>
        <source>cuts nothing</source>
        <translation>n'usine rien</translation>
    </message>
    <message>
        <source>cutter '{1}'</source>
        <translation>fraise '{1}'</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>cylindre</translation>
    </message>
    <message>
        <source>cylinder, diameter {1}, height {2}</source>
        <translation>cylindre, diamètre {1}, hauteur {2}</translation>
    </message>
    <message>
        <source>data compressed by zlib</source>
        <translation>des données compressées par zlib</translation>
    </message>
    <message>
        <source>decimate</source>
        <translation>décimer</translation>
    </message>
    <message>
        <source>decimate: ends when this share of the facets is left. 0 goes as far as the bound allows.</source>
        <translation>décimer : finit quand il reste cette part des facettes. 0 va aussi loin que la borne le permet.</translation>
    </message>
    <message>
        <source>define it before</source>
        <translation>le définir avant</translation>
    </message>
    <message>
        <source>diameter {1}, along {2}</source>
        <translation>diamètre {1}, selon {2}</translation>
    </message>
    <message>
        <source>did you mean '{1}'?</source>
        <translation>s'agit-il de '{1}' ?</translation>
    </message>
    <message>
        <source>direction has no meaning for a part that turns: see pattern</source>
        <translation>direction n'a pas de sens pour une pièce tournante : voir pattern</translation>
    </message>
    <message>
        <source>does not begin with its JSON</source>
        <translation>ne commence pas par son JSON</translation>
    </message>
    <message>
        <source>dragged point</source>
        <translation>point tiré</translation>
    </message>
    <message>
        <source>dragged points</source>
        <translation>points tirés</translation>
    </message>
    <message>
        <source>draw curves that run side by side</source>
        <translation>dessiner des courbes qui courent côte à côte</translation>
    </message>
    <message>
        <source>draw the curve on the part, or list its corners</source>
        <translation>dessiner la courbe sur la pièce, ou énumérer ses sommets</translation>
    </message>
    <message>
        <source>draw them apart</source>
        <translation>les dessiner séparées</translation>
    </message>
    <message>
        <source>each</source>
        <translation>chacun</translation>
    </message>
    <message>
        <source>each facet has {1} bytes, those of a binary STL file have 50</source>
        <translation>chaque facette a {1} octets, celles d’un fichier STL binaire en ont 50</translation>
    </message>
    <message>
        <source>edited region</source>
        <translation>zone modifiée</translation>
    </message>
    <message>
        <source>edited regions</source>
        <translation>zones modifiées</translation>
    </message>
    <message>
        <source>elements are nested too deeply</source>
        <translation>les éléments sont trop imbriqués</translation>
    </message>
    <message>
        <source>enter 0 or more</source>
        <translation>entrer 0 ou plus</translation>
    </message>
    <message>
        <source>enter a length above 0</source>
        <translation>entrer une longueur au-dessus de 0</translation>
    </message>
    <message>
        <source>enter a length above 0, or let it follow from the tolerance</source>
        <translation>entrer une longueur au-dessus de 0, ou la laisser suivre de la tolérance</translation>
    </message>
    <message>
        <source>enter a number</source>
        <translation>entrer un nombre</translation>
    </message>
    <message>
        <source>enter a number, or something like 25.4/2 or 1/4 in</source>
        <translation>entrer un nombre, ou quelque chose comme 25,4/2 ou 1/4 in</translation>
    </message>
    <message>
        <source>enter a positive diameter</source>
        <translation>entrer un diamètre positif</translation>
    </message>
    <message>
        <source>enter a positive height</source>
        <translation>entrer une hauteur positive</translation>
    </message>
    <message>
        <source>enter a positive length</source>
        <translation>entrer une longueur positive</translation>
    </message>
    <message>
        <source>enter a positive radius</source>
        <translation>entrer un rayon positif</translation>
    </message>
    <message>
        <source>enter a smaller height or taper angle</source>
        <translation>entrer une hauteur ou un angle de cône plus petits</translation>
    </message>
    <message>
        <source>enter a smaller length</source>
        <translation>entrer une longueur plus petite</translation>
    </message>
    <message>
        <source>enter a smaller shank diameter or a larger holder</source>
        <translation>entrer un diamètre de queue plus petit ou un porte-outil plus grand</translation>
    </message>
    <message>
        <source>enter an angle above 0</source>
        <translation>entrer un angle au-dessus de 0</translation>
    </message>
    <message>
        <source>every contact point needs its curves</source>
        <translation>chaque point de contact demande ses courbures</translation>
    </message>
    <message>
        <source>everywhere on the path the cutter would be below the bottom of the stock</source>
        <translation>partout sur le parcours la fraise serait sous le fond du brut</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>excédent</translation>
    </message>
    <message>
        <source>excess {1}</source>
        <translation>excédent {1}</translation>
    </message>
    <message>
        <source>expected a list of {1} numbers</source>
        <translation>une liste de {1} nombres attendue</translation>
    </message>
    <message>
        <source>expected a whole number</source>
        <translation>un nombre entier est attendu</translation>
    </message>
    <message>
        <source>expected {1}</source>
        <translation>attendu : {1}</translation>
    </message>
    <message>
        <source>export it again</source>
        <translation>l'exporter à nouveau</translation>
    </message>
    <message>
        <source>export it again, and copy it as binary</source>
        <translation>exportez-le de nouveau et copiez-le en binaire</translation>
    </message>
    <message>
        <source>export it again, or end it with FINI</source>
        <translation>l'exporter à nouveau, ou le terminer par FINI</translation>
    </message>
    <message>
        <source>export it again, without compression</source>
        <translation>l'exporter de nouveau, sans compression</translation>
    </message>
    <message>
        <source>export it as a plain mesh</source>
        <translation>l'exporter comme simple maillage</translation>
    </message>
    <message>
        <source>export it as glTF 2.0</source>
        <translation>l’exporter en glTF 2.0</translation>
    </message>
    <message>
        <source>export it as one file, .glb</source>
        <translation>l’exporter en un seul fichier, .glb</translation>
    </message>
    <message>
        <source>export it as plain triangles</source>
        <translation>l’exporter en simples triangles</translation>
    </message>
    <message>
        <source>export it in micron, millimeter, centimeter, inch or meter</source>
        <translation>l'exporter en micron, millimeter, centimeter, inch ou meter</translation>
    </message>
    <message>
        <source>export it in one unit</source>
        <translation>l'exporter dans une seule unité</translation>
    </message>
    <message>
        <source>export it without compression, as plain triangles</source>
        <translation>l’exporter sans compression, en simples triangles</translation>
    </message>
    <message>
        <source>export or copy it again</source>
        <translation>l'exporter ou le copier de nouveau</translation>
    </message>
    <message>
        <source>export the library anew</source>
        <translation>exporter de nouveau la bibliothèque</translation>
    </message>
    <message>
        <source>export the part again</source>
        <translation>exporter de nouveau la pièce</translation>
    </message>
    <message>
        <source>export the part again, or as STL</source>
        <translation>exporter de nouveau la pièce, ou en STL</translation>
    </message>
    <message>
        <source>export the part again, without</source>
        <translation>exporter de nouveau la pièce, sans cela</translation>
    </message>
    <message>
        <source>export the part as STL</source>
        <translation>exporter la pièce en STL</translation>
    </message>
    <message>
        <source>export the part as a mesh</source>
        <translation>exporter la pièce comme maillage</translation>
    </message>
    <message>
        <source>export the part as solids or surfaces, not as curves or a mesh</source>
        <translation>exporter la pièce en solides ou surfaces, pas en courbes ou maillage</translation>
    </message>
    <message>
        <source>export the part as triangles</source>
        <translation>exporter la pièce en triangles</translation>
    </message>
    <message>
        <source>export the part as {1}</source>
        <translation>exporter la pièce en {1}</translation>
    </message>
    <message>
        <source>export the part nearer to its origin, and check its unit</source>
        <translation>exporter la pièce plus près de son origine, et vérifier son unité</translation>
    </message>
    <message>
        <source>export the part with a coarser tolerance</source>
        <translation>exporter la pièce avec une tolérance plus grossière</translation>
    </message>
    <message>
        <source>export the part with decimal points</source>
        <translation>exporter la pièce avec des points décimaux</translation>
    </message>
    <message>
        <source>face mill</source>
        <translation>fraise à surfacer</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>faces</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet ou endsolid</translation>
    </message>
    <message>
        <source>facet {1}</source>
        <translation>facette {1}</translation>
    </message>
    <message>
        <source>facets</source>
        <translation>facettes</translation>
    </message>
    <message>
        <source>false: the region is not cut.</source>
        <translation>Non : la zone n'est pas usinée.</translation>
    </message>
    <message>
        <source>fewer than four poles</source>
        <translation>moins de quatre pôles</translation>
    </message>
    <message>
        <source>fill gaps of the picture with a height</source>
        <translation>remplir les lacunes de l'image avec une hauteur</translation>
    </message>
    <message>
        <source>fill it flat, or leave it with a smaller size</source>
        <translation>le remplir à plat, ou le laisser avec une taille plus petite</translation>
    </message>
    <message>
        <source>fins</source>
        <translation>lambeaux</translation>
    </message>
    <message>
        <source>fixture '{1}'</source>
        <translation>bridage '{1}'</translation>
    </message>
    <message>
        <source>fixture's mesh</source>
        <translation>maillage du bridage</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plat</translation>
    </message>
    <message>
        <source>flat end mill</source>
        <translation>fraise cylindrique</translation>
    </message>
    <message>
        <source>flutes of {1} instead of {2}</source>
        <translation>une partie coupante de {1} au lieu de {2}</translation>
    </message>
    <message>
        <source>flutes of {1} instead of {2} and a stick-out of {3} below the holder instead of {4}</source>
        <translation>une partie coupante de {1} au lieu de {2} et une sortie de {3} sous le porte-outil au lieu de {4}</translation>
    </message>
    <message>
        <source>free some memory</source>
        <translation>libérer de la mémoire</translation>
    </message>
    <message>
        <source>free some room</source>
        <translation>faire de la place</translation>
    </message>
    <message>
        <source>from above</source>
        <translation>d'en haut</translation>
    </message>
    <message>
        <source>from setup '{1}': {2}</source>
        <translation>du posage '{1}' : {2}</translation>
    </message>
    <message>
        <source>from tolerance</source>
        <translation>d'après la tolérance</translation>
    </message>
    <message>
        <source>from {1} to {2} of the centre there is nothing</source>
        <translation>de {1} à {2} du centre, il n’y a rien</translation>
    </message>
    <message>
        <source>from {1}° to {2}° is no range of postures</source>
        <translation>de {1}° à {2}° n'est pas une plage de postures</translation>
    </message>
    <message>
        <source>give I, J and K</source>
        <translation>donner I, J et K</translation>
    </message>
    <message>
        <source>give a .png file</source>
        <translation>donner un fichier .png</translation>
    </message>
    <message>
        <source>give a closed mesh, or a box or cylinder</source>
        <translation>donner un maillage fermé, ou une boîte ou un cylindre</translation>
    </message>
    <message>
        <source>give a direction from the tip to the spindle, upright is 0, 0, 1</source>
        <translation>donner une direction de la pointe à la broche, vertical est 0, 0, 1</translation>
    </message>
    <message>
        <source>give a feed</source>
        <translation>donner une avance</translation>
    </message>
    <message>
        <source>give a length</source>
        <translation>donner une longueur</translation>
    </message>
    <message>
        <source>give a library of milling tools</source>
        <translation>donner une bibliothèque d'outils de fraisage</translation>
    </message>
    <message>
        <source>give a number from 0 to {1}</source>
        <translation>donner un nombre de 0 à {1}</translation>
    </message>
    <message>
        <source>give a part</source>
        <translation>donner une pièce</translation>
    </message>
    <message>
        <source>give a place in the region</source>
        <translation>donner un endroit dans la zone</translation>
    </message>
    <message>
        <source>give a positive feed</source>
        <translation>donner une avance positive</translation>
    </message>
    <message>
        <source>give a positive length</source>
        <translation>donner une longueur positive</translation>
    </message>
    <message>
        <source>give a solid, or use a box or cylinder</source>
        <translation>donner un solide, ou prendre une boîte ou un cylindre</translation>
    </message>
    <message>
        <source>give a speed</source>
        <translation>donner une vitesse</translation>
    </message>
    <message>
        <source>give a whole number of at least 3</source>
        <translation>donner un nombre entier d'au moins 3</translation>
    </message>
    <message>
        <source>give at least four poles</source>
        <translation>donner au moins quatre pôles</translation>
    </message>
    <message>
        <source>give at least two each way</source>
        <translation>en donner au moins deux dans chaque sens</translation>
    </message>
    <message>
        <source>give each its own</source>
        <translation>donner à chacun le sien</translation>
    </message>
    <message>
        <source>give each tool a number of its own</source>
        <translation>donner à chaque outil un numéro à lui</translation>
    </message>
    <message>
        <source>give estimate, coarse or fine</source>
        <translation>donner estimate, coarse ou fine</translation>
    </message>
    <message>
        <source>give every axis its own name</source>
        <translation>donner à chaque axe son nom</translation>
    </message>
    <message>
        <source>give every boundary its own name</source>
        <translation>donner à chaque limite un nom à elle</translation>
    </message>
    <message>
        <source>give every fixture its own name</source>
        <translation>donner à chaque bridage un nom à lui</translation>
    </message>
    <message>
        <source>give every operation its own name</source>
        <translation>donner à chaque opération un nom à elle</translation>
    </message>
    <message>
        <source>give every setup its own name</source>
        <translation>donner à chaque posage un nom à lui</translation>
    </message>
    <message>
        <source>give every tool its own number</source>
        <translation>donner à chaque outil un numéro à lui</translation>
    </message>
    <message>
        <source>give it a feed</source>
        <translation>lui donner une avance</translation>
    </message>
    <message>
        <source>give it a name</source>
        <translation>lui donner un nom</translation>
    </message>
    <message>
        <source>give it a smaller limit</source>
        <translation>lui donner une limite plus petite</translation>
    </message>
    <message>
        <source>give it a stock of its own before</source>
        <translation>lui donner avant un brut à lui</translation>
    </message>
    <message>
        <source>give it in a block before</source>
        <translation>le donner dans un bloc avant</translation>
    </message>
    <message>
        <source>give it {1}</source>
        <translation>lui en donner {1}</translation>
    </message>
    <message>
        <source>give its length and its diameter</source>
        <translation>donner sa longueur et son diamètre</translation>
    </message>
    <message>
        <source>give numbers that no other setup has, from {1}</source>
        <translation>donner des numéros qu'aucun autre posage n'a, à partir de {1}</translation>
    </message>
    <message>
        <source>give one for each vertex, or none</source>
        <translation>en donner une par sommet, ou aucune</translation>
    </message>
    <message>
        <source>give one of Facetmill, Fusion, CAMotics or Kiri:Moto</source>
        <translation>en donner une de Facetmill, Fusion, CAMotics ou Kiri:Moto</translation>
    </message>
    <message>
        <source>give one of them</source>
        <translation>en donner un</translation>
    </message>
    <message>
        <source>give radii and heights that rise</source>
        <translation>donner des rayons et des hauteurs croissantes</translation>
    </message>
    <message>
        <source>give size, facets, area or keep</source>
        <translation>donner size, facets, area ou keep</translation>
    </message>
    <message>
        <source>give ssh:HOST, the host as ssh knows it</source>
        <translation>donner ssh:HÔTE, l’hôte tel que ssh le connaît</translation>
    </message>
    <message>
        <source>give the boundary a name</source>
        <translation>donner un nom à la limite</translation>
    </message>
    <message>
        <source>give the boundary another tool first</source>
        <translation>donner d'abord un autre outil à la limite</translation>
    </message>
    <message>
        <source>give the boundary's place</source>
        <translation>donner l'endroit de la limite</translation>
    </message>
    <message>
        <source>give the file another name</source>
        <translation>donner un autre nom au fichier</translation>
    </message>
    <message>
        <source>give the fixture a name</source>
        <translation>donner un nom au bridage</translation>
    </message>
    <message>
        <source>give the height that cuts</source>
        <translation>donner la hauteur qui coupe</translation>
    </message>
    <message>
        <source>give the holder's profile</source>
        <translation>donner le profil du porte-outil</translation>
    </message>
    <message>
        <source>give the inclination</source>
        <translation>donner l'inclinaison</translation>
    </message>
    <message>
        <source>give the largest speed, in degrees per second</source>
        <translation>donner la plus grande vitesse, en degrés par seconde</translation>
    </message>
    <message>
        <source>give the largest speed, in units per second</source>
        <translation>donner la plus grande vitesse, en unités par seconde</translation>
    </message>
    <message>
        <source>give the length from tip to spindle nose</source>
        <translation>donner la longueur de la pointe au nez de broche</translation>
    </message>
    <message>
        <source>give the library's tools</source>
        <translation>donner les outils de la bibliothèque</translation>
    </message>
    <message>
        <source>give the number of a tool</source>
        <translation>donner le numéro d'un outil</translation>
    </message>
    <message>
        <source>give the number of the previous tool</source>
        <translation>donner le numéro de l'outil précédent</translation>
    </message>
    <message>
        <source>give the operation a name</source>
        <translation>donner un nom à l'opération</translation>
    </message>
    <message>
        <source>give the operation another tool first</source>
        <translation>donner d'abord un autre outil à l'opération</translation>
    </message>
    <message>
        <source>give the place it moves to</source>
        <translation>donner l'endroit où elle va</translation>
    </message>
    <message>
        <source>give the place on the part</source>
        <translation>donner l'endroit de la pièce</translation>
    </message>
    <message>
        <source>give the right to write there</source>
        <translation>donner le droit d'y écrire</translation>
    </message>
    <message>
        <source>give the section's diameter</source>
        <translation>donner le diamètre de la section</translation>
    </message>
    <message>
        <source>give the section's length</source>
        <translation>donner la longueur de la section</translation>
    </message>
    <message>
        <source>give the setup a name</source>
        <translation>donner un nom au posage</translation>
    </message>
    <message>
        <source>give the setup a stock of its own, or use larger tools before it</source>
        <translation>donner au posage un brut à lui, ou utiliser avant de plus grands outils</translation>
    </message>
    <message>
        <source>give the stock a margin</source>
        <translation>donner une marge au brut</translation>
    </message>
    <message>
        <source>give the stock of the first setup as box, cylinder or mesh</source>
        <translation>donner le brut du premier posage comme boîte, cylindre ou maillage</translation>
    </message>
    <message>
        <source>give the tool a number</source>
        <translation>donner un numéro à l'outil</translation>
    </message>
    <message>
        <source>give the tool a smaller number</source>
        <translation>donner à l'outil un numéro plus petit</translation>
    </message>
    <message>
        <source>give the tool's diameter</source>
        <translation>donner le diamètre de l'outil</translation>
    </message>
    <message>
        <source>give the yaw</source>
        <translation>donner le lacet</translation>
    </message>
    <message>
        <source>give turns per minute</source>
        <translation>donner des tours par minute</translation>
    </message>
    <message>
        <source>give two angles between {1}° and {2}°, the smaller first</source>
        <translation>donner deux angles entre {1}° et {2}°, le plus petit d'abord</translation>
    </message>
    <message>
        <source>give two points of the axis</source>
        <translation>donner deux points de l'axe</translation>
    </message>
    <message>
        <source>give two to four sections at increasing, equally spaced X</source>
        <translation>donner de deux à quatre sections à X croissants et également espacés</translation>
    </message>
    <message>
        <source>global</source>
        <translation>globale</translation>
    </message>
    <message>
        <source>go there straight first</source>
        <translation>y aller d'abord tout droit</translation>
    </message>
    <message>
        <source>goes beyond its buffer</source>
        <translation>dépasse son tampon</translation>
    </message>
    <message>
        <source>goes beyond its part of the buffer</source>
        <translation>dépasse sa partie du tampon</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>entaille</translation>
    </message>
    <message>
        <source>gouge of {1} ({2}), limit {3}</source>
        <translation>entaille de {1} ({2}), limite {3}</translation>
    </message>
    <message>
        <source>gouge of {1}, limit {2}</source>
        <translation>entaille de {1}, limite {2}</translation>
    </message>
    <message>
        <source>grblHAL</source>
        <translation>grblHAL</translation>
    </message>
    <message>
        <source>has a corner that is not finite or out of range</source>
        <translation>a un sommet qui n'est pas fini ou est hors de la plage</translation>
    </message>
    <message>
        <source>has feeds of some motions only</source>
        <translation>n'a d'avances que pour certains mouvements</translation>
    </message>
    <message>
        <source>has more facets than a tree of their boxes can hold</source>
        <translation>a plus de facettes qu'un arbre de leurs boîtes ne peut en contenir</translation>
    </message>
    <message>
        <source>has more facets than can be drawn</source>
        <translation>a plus de facettes qu'on n'en peut dessiner</translation>
    </message>
    <message>
        <source>has more facets than the contact index can hold</source>
        <translation>a plus de facettes que l'index de contact n'en peut tenir</translation>
    </message>
    <message>
        <source>has more points than can be drawn</source>
        <translation>a plus de points qu'on n'en peut dessiner</translation>
    </message>
    <message>
        <source>has no list of primitives</source>
        <translation>n’a pas de liste de parties (primitives)</translation>
    </message>
    <message>
        <source>has no positive radius and length</source>
        <translation>n'a pas de rayon et de longueur positifs</translation>
    </message>
    <message>
        <source>has no volume</source>
        <translation>n'a pas de volume</translation>
    </message>
    <message>
        <source>has not been verified</source>
        <translation>n'a pas été vérifié</translation>
    </message>
    <message>
        <source>has not been verified: {1}</source>
        <translation>n'a pas été vérifié : {1}</translation>
    </message>
    <message>
        <source>has too many sections</source>
        <translation>a trop de sections</translation>
    </message>
    <message>
        <source>have it packed again</source>
        <translation>le faire compresser de nouveau</translation>
    </message>
    <message>
        <source>have it packed and sent again</source>
        <translation>la faire compresser et envoyer de nouveau</translation>
    </message>
    <message>
        <source>have it packed without a password</source>
        <translation>le faire compresser sans mot de passe</translation>
    </message>
    <message>
        <source>have one project packed, or unpack the archive by other means</source>
        <translation>faire compresser un seul projet, ou décompresser l'archive autrement</translation>
    </message>
    <message>
        <source>have the project packed again, with all its files</source>
        <translation>faire compresser de nouveau le projet avec tous ses fichiers</translation>
    </message>
    <message>
        <source>have the project packed with the files themselves</source>
        <translation>faire compresser le projet avec les fichiers eux-mêmes</translation>
    </message>
    <message>
        <source>helix</source>
        <translation>hélice</translation>
    </message>
    <message>
        <source>high {1}</source>
        <translation>{1} haut</translation>
    </message>
    <message>
        <source>hold less of the stock, or take a smaller tool or clearance</source>
        <translation>tenir moins du brut, ou prendre outil ou distance plus petits</translation>
    </message>
    <message>
        <source>holder '{1}'</source>
        <translation>porte-outil '{1}'</translation>
    </message>
    <message>
        <source>holder '{1}' is left out: this format has none</source>
        <translation>le porte-outil '{1}' est omis : ce format n'en a pas</translation>
    </message>
    <message>
        <source>holder '{1}' is left out: write it as .fcholder</source>
        <translation>le porte-outil '{1}' est omis : l'écrire en .fcholder</translation>
    </message>
    <message>
        <source>holder {1}</source>
        <translation>porte-outil {1}</translation>
    </message>
    <message>
        <source>holds changes to other numbers</source>
        <translation>contient des modifications d’autres nombres (sparse)</translation>
    </message>
    <message>
        <source>holds more numbers than the file has bytes</source>
        <translation>contient plus de nombres que le fichier n’a d’octets</translation>
    </message>
    <message>
        <source>holds no tool</source>
        <translation>ne contient pas d'outil</translation>
    </message>
    <message>
        <source>holds no tool that can be used: {1}</source>
        <translation>ne contient aucun outil utilisable : {1}</translation>
    </message>
    <message>
        <source>holds no {1}</source>
        <translation>ne contient rien : {1}</translation>
    </message>
    <message>
        <source>holds two projects: {1} and {2}</source>
        <translation>contient deux projets : {1} et {2}</translation>
    </message>
    <message>
        <source>holds {1} files, more than {2}</source>
        <translation>contient {1} fichiers, plus de {2}</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>trou</translation>
    </message>
    <message>
        <source>hole: where the hole is: the one whose middle is nearest, no farther than half its diameter.</source>
        <translation>trou : où est le trou : celui dont le milieu est le plus proche, pas plus loin que la moitié de son diamètre.</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>trous</translation>
    </message>
    <message>
        <source>holes, hole: smooth goes on as the surface around bends; flat takes the least area. hole: left stays open whatever later steps say.</source>
        <translation>trous, trou : lisse continue la courbure de la surface autour ; plat prend le moins d'aire. trou : ouvert reste ouvert quoi que disent les étapes suivantes.</translation>
    </message>
    <message>
        <source>in a file of version 2 every setup has its own</source>
        <translation>dans un fichier de version 2 chaque posage a les siens</translation>
    </message>
    <message>
        <source>in places more stays than the layers leave on slopes ({1}): up to {2} above the allowance, most at {3}</source>
        <translation>par endroits il reste plus que les niveaux ne laissent sur les pentes ({1}) : jusqu'à {2} au-dessus de la surépaisseur, le plus à {3}</translation>
    </message>
    <message>
        <source>install Facetmill again</source>
        <translation>réinstaller Facetmill</translation>
    </message>
    <message>
        <source>install Facetmill and {1} of the same version</source>
        <translation>installer Facetmill et {1} de la même version</translation>
    </message>
    <message>
        <source>install all of Facetmill</source>
        <translation>installer tout Facetmill</translation>
    </message>
    <message>
        <source>install all of Facetmill, or build it with OpenCASCADE; or export the part as STL</source>
        <translation>installer tout Facetmill, ou le construire avec OpenCASCADE ; ou exporter la pièce en STL</translation>
    </message>
    <message>
        <source>install it (Debian: openssh-client), or let this machine do the work</source>
        <translation>l’installer (Debian : openssh-client), ou laisser cet ordinateur faire le travail</translation>
    </message>
    <message>
        <source>install its commands (Debian: slurm-client), or let this machine do the work</source>
        <translation>installer ses commandes (Debian : slurm-client), ou laisser cet ordinateur faire le travail</translation>
    </message>
    <message>
        <source>install the same one there, or name it: --remote-program</source>
        <translation>y installer le même, ou le nommer : --remote-program</translation>
    </message>
    <message>
        <source>inward</source>
        <translation>vers le dedans</translation>
    </message>
    <message>
        <source>is JSON, but no glTF: it has no asset</source>
        <translation>est du JSON, mais pas du glTF : il n’a pas d’asset</translation>
    </message>
    <message>
        <source>is a file that the job reads</source>
        <translation>est un fichier que le travail lit</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>est un dossier, pas un fichier</translation>
    </message>
    <message>
        <source>is a link or no plain file</source>
        <translation>est un lien ou n'est pas un fichier simple</translation>
    </message>
    <message>
        <source>is a packed project: its files have no place of their own</source>
        <translation>est un projet compressé : ses fichiers n'ont pas d'emplacement propre</translation>
    </message>
    <message>
        <source>is a tool library of a newer Facetmill</source>
        <translation>est une bibliothèque d'outils d'un Facetmill plus récent</translation>
    </message>
    <message>
        <source>is an archive without a project</source>
        <translation>est une archive sans projet</translation>
    </message>
    <message>
        <source>is an archive, but no 3MF: it has no relationships</source>
        <translation>est une archive, mais pas un 3MF : elle n'a pas de relations</translation>
    </message>
    <message>
        <source>is binary glTF of version {1}</source>
        <translation>est du glTF binaire de version {1}</translation>
    </message>
    <message>
        <source>is encrypted</source>
        <translation>est chiffré</translation>
    </message>
    <message>
        <source>is glTF of version '{1}'</source>
        <translation>est du glTF de version « {1} »</translation>
    </message>
    <message>
        <source>is more than {1} bytes with those before it, unpacked</source>
        <translation>dépasse {1} octets avec les précédents, une fois décompressé</translation>
    </message>
    <message>
        <source>is needed by a step of kind {1}</source>
        <translation>une étape du type {1} en a besoin</translation>
    </message>
    <message>
        <source>is negative</source>
        <translation>est négatif</translation>
    </message>
    <message>
        <source>is no TIFF picture that can be read: {1}</source>
        <translation>n'est pas une image TIFF lisible : {1}</translation>
    </message>
    <message>
        <source>is no list</source>
        <translation>n’est pas une liste</translation>
    </message>
    <message>
        <source>is no list of {1} numbers</source>
        <translation>n’est pas une liste de {1} nombres</translation>
    </message>
    <message>
        <source>is no object</source>
        <translation>n’est pas un objet</translation>
    </message>
    <message>
        <source>is no outline of a holder</source>
        <translation>n'est pas un contour de porte-outil</translation>
    </message>
    <message>
        <source>is no packed project</source>
        <translation>n'est pas un projet compressé</translation>
    </message>
    <message>
        <source>is no parameter of a turning part</source>
        <translation>n'est pas un paramètre d'une pièce tournante</translation>
    </message>
    <message>
        <source>is no place in space</source>
        <translation>n’est pas une position dans l’espace</translation>
    </message>
    <message>
        <source>is no rotation</source>
        <translation>n’est pas une rotation</translation>
    </message>
    <message>
        <source>is no sound PNG picture: {1}</source>
        <translation>n'est pas une image PNG saine : {1}</translation>
    </message>
    <message>
        <source>is no sound XML: {1}</source>
        <translation>n'est pas un XML sain : {1}</translation>
    </message>
    <message>
        <source>is no sound archive: {1}</source>
        <translation>n'est pas une archive saine : {1}</translation>
    </message>
    <message>
        <source>is no tool library by its name</source>
        <translation>n'est pas une bibliothèque d'outils d'après son nom</translation>
    </message>
    <message>
        <source>is no tool library that this program knows</source>
        <translation>n'est pas une bibliothèque d'outils que ce programme connaît</translation>
    </message>
    <message>
        <source>is no whole number</source>
        <translation>n’est pas un nombre entier</translation>
    </message>
    <message>
        <source>is not a 3MF file</source>
        <translation>n'est pas un fichier 3MF</translation>
    </message>
    <message>
        <source>is not a 3MF file but {1}</source>
        <translation>n'est pas un fichier 3MF mais {1}</translation>
    </message>
    <message>
        <source>is not a PLY file: it does not start with 'ply'</source>
        <translation>n'est pas un fichier PLY : il ne commence pas par 'ply'</translation>
    </message>
    <message>
        <source>is not a PNG picture</source>
        <translation>n'est pas une image PNG</translation>
    </message>
    <message>
        <source>is not a PNG picture but {1}</source>
        <translation>n'est pas une image PNG mais {1}</translation>
    </message>
    <message>
        <source>is not a TIFF picture</source>
        <translation>n'est pas une image TIFF</translation>
    </message>
    <message>
        <source>is not a TIFF picture but {1}</source>
        <translation>n'est pas une image TIFF mais {1}</translation>
    </message>
    <message>
        <source>is not a glTF file</source>
        <translation>n’est pas un fichier glTF</translation>
    </message>
    <message>
        <source>is not a glTF file but {1}</source>
        <translation>n’est pas un fichier glTF mais {1}</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n'est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>is not above 0</source>
        <translation>n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>is not an OBJ file{1}</source>
        <translation>n'est pas un fichier OBJ{1}</translation>
    </message>
    <message>
        <source>is not an STL file but {1}</source>
        <translation>n'est pas un fichier STL mais {1}</translation>
    </message>
    <message>
        <source>is of another type than {1}</source>
        <translation>est d’un autre type que {1}</translation>
    </message>
    <message>
        <source>is there already, and is another file</source>
        <translation>existe déjà, et c'est un autre fichier</translation>
    </message>
    <message>
        <source>is too large for a project</source>
        <translation>est trop grand pour un projet</translation>
    </message>
    <message>
        <source>is what the project as it stands comes to, which is not known: {1}</source>
        <translation>est ce à quoi arrive le projet tel quel, ce qui n'est pas connu : {1}</translation>
    </message>
    <message>
        <source>is {1}</source>
        <translation>est {1}</translation>
    </message>
    <message>
        <source>it asks for more than {1} passes</source>
        <translation>cela demande plus de {1} passes</translation>
    </message>
    <message>
        <source>it asks for more than {1} turns</source>
        <translation>cela demande plus de {1} tours</translation>
    </message>
    <message>
        <source>it asks for too many turns</source>
        <translation>cela demande trop de tours</translation>
    </message>
    <message>
        <source>it begins with a point</source>
        <translation>il commence par un point</translation>
    </message>
    <message>
        <source>it cannot be judged: {1}</source>
        <translation>impossible à juger : {1}</translation>
    </message>
    <message>
        <source>it cannot be locked</source>
        <translation>il ne peut être verrouillé</translation>
    </message>
    <message>
        <source>it cannot be started: </source>
        <translation>il ne peut être lancé : </translation>
    </message>
    <message>
        <source>it cannot be started: {1}</source>
        <translation>il ne peut être lancé : {1}</translation>
    </message>
    <message>
        <source>it cannot be unpacked</source>
        <translation>il ne peut être décompressé</translation>
    </message>
    <message>
        <source>it cannot be written as a number</source>
        <translation>il ne peut s'écrire comme un nombre</translation>
    </message>
    <message>
        <source>it cuts while the spindle stands</source>
        <translation>il usine alors que la broche est arrêtée</translation>
    </message>
    <message>
        <source>it cuts {1} into the part on purpose: the verification calls that a gouge, unless its limit is more</source>
        <translation>elle entre volontairement de {1} dans la pièce : la vérification appelle cela une entaille, sauf si sa limite est plus grande</translation>
    </message>
    <message>
        <source>it cuts, and no speed of the spindle is given</source>
        <translation>il usine, et aucune vitesse de broche n'est donnée</translation>
    </message>
    <message>
        <source>it divides by 0</source>
        <translation>il y a une division par 0</translation>
    </message>
    <message>
        <source>it does not fit into memory</source>
        <translation>il ne tient pas en mémoire</translation>
    </message>
    <message>
        <source>it does not fit into the {1} MB of memory that reading it may take</source>
        <translation>il ne tient pas dans les {1} Mo de mémoire que sa lecture peut prendre</translation>
    </message>
    <message>
        <source>it does not meet the stock of {1}: they are {2} apart as the part lies in both</source>
        <translation>il ne rencontre pas le brut de {1} : ils sont à {2} l'un de l'autre, la pièce étant posée comme dans les deux</translation>
    </message>
    <message>
        <source>it does not take the job: {1}</source>
        <translation>il ne prend pas la tâche : {1}</translation>
    </message>
    <message>
        <source>it ends where a number is missing</source>
        <translation>cela finit où manque un nombre</translation>
    </message>
    <message>
        <source>it faces down; turn the part over and cut it in another setup</source>
        <translation>elle regarde vers le bas ; retourner la pièce et l'usiner dans un autre posage</translation>
    </message>
    <message>
        <source>it goes on with what the setup before it leaves, and would be the first</source>
        <translation>il continue avec ce que laisse le précédent, et serait le premier</translation>
    </message>
    <message>
        <source>it has no value</source>
        <translation>cela n'a pas de valeur</translation>
    </message>
    <message>
        <source>it holds no solid and no surface</source>
        <translation>il ne contient ni solide ni surface</translation>
    </message>
    <message>
        <source>it is alike in all directions and has no principal axes</source>
        <translation>elle est pareille dans toutes les directions et n'a pas d'axes principaux</translation>
    </message>
    <message>
        <source>it is an upright wall, which asks for no pass of its own</source>
        <translation>c'est une paroi verticale, qui ne demande pas de passe à elle</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>il est vide</translation>
    </message>
    <message>
        <source>it is larger than it says</source>
        <translation>il est plus grand qu'il ne dit</translation>
    </message>
    <message>
        <source>it is left standing</source>
        <translation>elle reste en place</translation>
    </message>
    <message>
        <source>it is not as it was written</source>
        <translation>ce n'est pas comme cela a été écrit</translation>
    </message>
    <message>
        <source>it is not {1}</source>
        <translation>ce n'est pas {1}</translation>
    </message>
    <message>
        <source>it is smaller than it says</source>
        <translation>il est plus petit qu'il ne dit</translation>
    </message>
    <message>
        <source>it is switched off</source>
        <translation>elle est désactivée</translation>
    </message>
    <message>
        <source>it is {1}, not {2}</source>
        <translation>c'est {1}, pas {2}</translation>
    </message>
    <message>
        <source>it leaves more than the tolerance</source>
        <translation>elle laisse plus que la tolérance</translation>
    </message>
    <message>
        <source>it may be cut short: write it anew</source>
        <translation>il est peut-être tronqué : l'écrire à nouveau</translation>
    </message>
    <message>
        <source>it may say how often it turns: leave it out</source>
        <translation>il dit peut-être combien de fois il tourne : l'omettre</translation>
    </message>
    <message>
        <source>it names faces, and the part's file has none: only STEP and IGES files do</source>
        <translation>elle nomme des faces, et le fichier de la pièce n'en a pas : seuls les fichiers STEP et IGES en ont</translation>
    </message>
    <message>
        <source>it stands upright: no turn about Z lays it along X</source>
        <translation>elle est verticale : aucune rotation autour de Z ne la met selon X</translation>
    </message>
    <message>
        <source>it takes more than {1} facets at this chord tolerance</source>
        <translation>il demande plus de {1} facettes à cette tolérance de corde</translation>
    </message>
    <message>
        <source>it turns the other way, which is not carried</source>
        <translation>il tourne dans l'autre sens, ce qui n'est pas repris</translation>
    </message>
    <message>
        <source>it was painted on a part of {1} facets, and this one has {2}</source>
        <translation>elle a été peinte sur une pièce de {1} facettes, et celle-ci en a {2}</translation>
    </message>
    <message>
        <source>it was written meanwhile</source>
        <translation>cela a été écrit entre-temps</translation>
    </message>
    <message>
        <source>it, or a file that it reads, was changed since the study began</source>
        <translation>il, ou un fichier qu'il lit, a été modifié depuis le début de l'étude</translation>
    </message>
    <message>
        <source>its attributes cannot be read</source>
        <translation>ses attributs sont illisibles</translation>
    </message>
    <message>
        <source>its first bytes are not those of a PNG picture, as after a transfer as text</source>
        <translation>ses premiers octets ne sont pas ceux d’une image PNG, comme après un transfert en mode texte</translation>
    </message>
    <message>
        <source>its holder is narrower than its shank, and taken as wide</source>
        <translation>son porte-outil est plus étroit que sa queue, et pris aussi large</translation>
    </message>
    <message>
        <source>its neck is taken as wide as the widest of the shank</source>
        <translation>son col est pris aussi large que le plus large de la queue</translation>
    </message>
    <message>
        <source>its numbers are no numbers of vertices</source>
        <translation>ses nombres ne sont pas des numéros de sommets</translation>
    </message>
    <message>
        <source>its numbers are of an unknown type</source>
        <translation>ses nombres sont d’un type inconnu</translation>
    </message>
    <message>
        <source>its numbers lie over each other</source>
        <translation>ses nombres se chevauchent</translation>
    </message>
    <message>
        <source>its objects, put together, have more than 50 million facets</source>
        <translation>ses objets, assemblés, ont plus de 50 millions de facettes</translation>
    </message>
    <message>
        <source>its objects, put together, have more than 50 million facets or a million parts</source>
        <translation>ses objets réunis ont plus de 50 millions de facettes ou un million de parties</translation>
    </message>
    <message>
        <source>its pieces are planned beside different things</source>
        <translation>ses morceaux sont planifiés à côté de choses différentes</translation>
    </message>
    <message>
        <source>its point is taken for one of 119°</source>
        <translation>sa pointe est prise pour une de 119°</translation>
    </message>
    <message>
        <source>its points lie on a line: there is no face to lie on</source>
        <translation>ses points sont alignés : il n'y a pas de face d'appui</translation>
    </message>
    <message>
        <source>its programs have the numbers {1} to {2}, and those of setup '{3}' {4} to {5}</source>
        <translation>ses programmes ont les numéros {1} à {2}, et ceux du posage '{3}' {4} à {5}</translation>
    </message>
    <message>
        <source>its regions ask for more than {1} facets</source>
        <translation>ses zones demandent plus de {1} facettes</translation>
    </message>
    <message>
        <source>its surface has more than {1} facets</source>
        <translation>sa surface a plus de {1} facettes</translation>
    </message>
    <message>
        <source>its tool is not in the project any more</source>
        <translation>son outil n'est plus dans le projet</translation>
    </message>
    <message>
        <source>its two curves cross or touch</source>
        <translation>ses deux courbes se croisent ou se touchent</translation>
    </message>
    <message>
        <source>its two curves cross or touch at {1}</source>
        <translation>ses deux courbes se croisent ou se touchent en {1}</translation>
    </message>
    <message>
        <source>its worker ended with status {1}</source>
        <translation>son travailleur a fini avec l'état {1}</translation>
    </message>
    <message>
        <source>its worker was ended by signal {1}</source>
        <translation>son travailleur a été arrêté par le signal {1}</translation>
    </message>
    <message>
        <source>its {1} strips would take more than {2} points of passes</source>
        <translation>ses {1} bandes demanderaient plus de {2} points de passes</translation>
    </message>
    <message>
        <source>join</source>
        <translation>joindre</translation>
    </message>
    <message>
        <source>join: the file of the scan that is joined on, in the unit and the coordinates of this one.</source>
        <translation>joindre : le fichier du scan qui est ajouté, dans l'unité et les coordonnées de celui-ci.</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>axes</translation>
    </message>
    <message>
        <source>keep one</source>
        <translation>n'en garder qu'un</translation>
    </message>
    <message>
        <source>keep one of them</source>
        <translation>n'en garder qu'une</translation>
    </message>
    <message>
        <source>kept posture</source>
        <translation>posture gardée</translation>
    </message>
    <message>
        <source>kept postures</source>
        <translation>postures gardées</translation>
    </message>
    <message>
        <source>known keys: {1}</source>
        <translation>clés connues : {1}</translation>
    </message>
    <message>
        <source>known meanings: {1}</source>
        <translation>significations connues : {1}</translation>
    </message>
    <message>
        <source>known words: {1}</source>
        <translation>mots connus : {1}</translation>
    </message>
    <message>
        <source>known {1}s: {2}; a name that ends with .json is a file of your own</source>
        <translation>connus ({1}) : {2} ; un nom qui finit par .json est un fichier à soi</translation>
    </message>
    <message>
        <source>lay it on a face, or turn it by an angle</source>
        <translation>la poser sur une face, ou la tourner d'un angle</translation>
    </message>
    <message>
        <source>lay the scans on each other first, or allow more</source>
        <translation>poser d'abord les scans l'un sur l'autre, ou permettre plus</translation>
    </message>
    <message>
        <source>layers of {1} are deeper than the flutes of the tool, {2}</source>
        <translation>des niveaux de {1} sont plus profonds que la partie coupante de l'outil, {2}</translation>
    </message>
    <message>
        <source>leave `wcs` out</source>
        <translation>omettre `wcs`</translation>
    </message>
    <message>
        <source>leave it out</source>
        <translation>l'omettre</translation>
    </message>
    <message>
        <source>leave it out, or check its direction</source>
        <translation>l'omettre, ou vérifier sa direction</translation>
    </message>
    <message>
        <source>leave it where it is</source>
        <translation>le laisser où il est</translation>
    </message>
    <message>
        <source>leave out those that are clamped</source>
        <translation>omettre ceux qui sont bloqués</translation>
    </message>
    <message>
        <source>leave some out</source>
        <translation>en omettre</translation>
    </message>
    <message>
        <source>leave the operation out</source>
        <translation>omettre l'opération</translation>
    </message>
    <message>
        <source>leave the operation out, or allow a smaller tolerance</source>
        <translation>omettre l'opération, ou permettre une tolérance plus petite</translation>
    </message>
    <message>
        <source>leave the operation out, or cut everywhere (rest_only)</source>
        <translation>omettre l'opération, ou usiner partout (rest_only)</translation>
    </message>
    <message>
        <source>leave the tool axis upright (0, 0, 1)</source>
        <translation>laisser l'axe d'outil vertical (0, 0, 1)</translation>
    </message>
    <message>
        <source>leave the tool axis upright (0, 0, 1), or set the tilt limit to 0</source>
        <translation>laisser l'axe d'outil vertical (0, 0, 1), ou mettre la limite d'inclinaison à 0</translation>
    </message>
    <message>
        <source>leave them out</source>
        <translation>les omettre</translation>
    </message>
    <message>
        <source>leave this operation out, or check what those before it cut</source>
        <translation>omettre cette opération, ou vérifier ce que les précédentes usinent</translation>
    </message>
    <message>
        <source>left</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>left by the main path</source>
        <translation>laissé par le parcours principal</translation>
    </message>
    <message>
        <source>left out: '{1}' is no cutter that this program knows</source>
        <translation>omis : '{1}' n'est pas une fraise que ce programme connaît</translation>
    </message>
    <message>
        <source>left out: its geometry makes no cutter</source>
        <translation>omis : sa géométrie ne fait pas une fraise</translation>
    </message>
    <message>
        <source>left out: its holder has sizes that none can have</source>
        <translation>omis : son porte-outil a des dimensions impossibles</translation>
    </message>
    <message>
        <source>left out: the table has no diameter</source>
        <translation>omis : la table n'a pas de diamètre</translation>
    </message>
    <message>
        <source>left out: this format has no '{1}'</source>
        <translation>omis : ce format n'a pas '{1}'</translation>
    </message>
    <message>
        <source>left out: {1}</source>
        <translation>omis : {1}</translation>
    </message>
    <message>
        <source>leftward</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>lengths in {1}</source>
        <translation>longueurs en {1}</translation>
    </message>
    <message>
        <source>lengthwise</source>
        <translation>en long</translation>
    </message>
    <message>
        <source>let coarser settings vary</source>
        <translation>faire varier des réglages plus grossiers</translation>
    </message>
    <message>
        <source>let it end farther out than it begins</source>
        <translation>la faire finir plus loin qu’elle ne commence</translation>
    </message>
    <message>
        <source>let less vary</source>
        <translation>faire varier moins</translation>
    </message>
    <message>
        <source>let more vary, or allow more</source>
        <translation>faire varier davantage, ou permettre davantage</translation>
    </message>
    <message>
        <source>let the name end in .stl, .3mf or .ply</source>
        <translation>faire finir le nom par .stl, .3mf ou .ply</translation>
    </message>
    <message>
        <source>let the operation name another boundary, or none, first</source>
        <translation>faire d'abord nommer à l'opération une autre limite, ou aucune</translation>
    </message>
    <message>
        <source>list X, Y and Z</source>
        <translation>nommer X, Y et Z</translation>
    </message>
    <message>
        <source>list at least "machining_time"</source>
        <translation>nommer au moins "machining_time"</translation>
    </message>
    <message>
        <source>list at least one</source>
        <translation>en nommer au moins un</translation>
    </message>
    <message>
        <source>list at least one place of the project with two values</source>
        <translation>nommer au moins un endroit du projet avec deux valeurs</translation>
    </message>
    <message>
        <source>list at least one setup</source>
        <translation>énumérer au moins un posage</translation>
    </message>
    <message>
        <source>list the axes: X, Y, Z and up to two rotary ones</source>
        <translation>nommer les axes : X, Y, Z et jusqu'à deux rotatifs</translation>
    </message>
    <message>
        <source>list the axis that carries the other one first; check the directions</source>
        <translation>nommer d'abord l'axe qui porte l'autre ; vérifier les directions</translation>
    </message>
    <message>
        <source>list the steps</source>
        <translation>énumérer les étapes</translation>
    </message>
    <message>
        <source>list what is wanted, as ["machining_time"]</source>
        <translation>nommer ce qui est voulu, comme ["machining_time"]</translation>
    </message>
    <message>
        <source>local</source>
        <translation>locale</translation>
    </message>
    <message>
        <source>lofted surface</source>
        <translation>surface lissée</translation>
    </message>
    <message>
        <source>look across it, as along 0, 0, 1</source>
        <translation>regarder en travers, comme selon 0, 0, 1</translation>
    </message>
    <message>
        <source>lost: {1}</source>
        <translation>perdu : {1}</translation>
    </message>
    <message>
        <source>low {1}</source>
        <translation>{1} bas</translation>
    </message>
    <message>
        <source>lower it, or raise the assumed lead limit</source>
        <translation>l'abaisser, ou relever la limite supposée</translation>
    </message>
    <message>
        <source>lower the feed</source>
        <translation>baisser l'avance</translation>
    </message>
    <message>
        <source>make it smaller</source>
        <translation>la réduire</translation>
    </message>
    <message>
        <source>make it smaller in a picture editor</source>
        <translation>la réduire dans un éditeur d'images</translation>
    </message>
    <message>
        <source>make one, or leave the name empty</source>
        <translation>en faire une, ou laisser le nom vide</translation>
    </message>
    <message>
        <source>make room or give the right to write there</source>
        <translation>faire de la place ou donner le droit d'y écrire</translation>
    </message>
    <message>
        <source>material</source>
        <translation>matière</translation>
    </message>
    <message>
        <source>materials</source>
        <translation>matières</translation>
    </message>
    <message>
        <source>measured are: {1}</source>
        <translation>sont mesurés : {1}</translation>
    </message>
    <message>
        <source>mend it, or leave it out</source>
        <translation>le corriger ou l'omettre</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>maillage</translation>
    </message>
    <message>
        <source>mesh {1}</source>
        <translation>maillage {1}</translation>
    </message>
    <message>
        <source>meshes are not written as {1} files</source>
        <translation>les maillages ne s'écrivent pas en fichiers {1}</translation>
    </message>
    <message>
        <source>meshes[{1}]</source>
        <translation>meshes[{1}]</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>middle height</source>
        <translation>mi-hauteur</translation>
    </message>
    <message>
        <source>middle of {1}</source>
        <translation>milieu de {1}</translation>
    </message>
    <message>
        <source>mirror the part itself, which all setups have</source>
        <translation>refléter la pièce elle-même, que tous les posages ont</translation>
    </message>
    <message>
        <source>missing closing quote</source>
        <translation>il manque le guillemet fermant</translation>
    </message>
    <message>
        <source>modulo</source>
        <translation>modulo</translation>
    </message>
    <message>
        <source>more than twice the tolerance stays on {1} of the surface near the part's open borders, where paths may end</source>
        <translation>plus du double de la tolérance reste sur {1} de la surface près des bords ouverts de la pièce, où les parcours peuvent finir</translation>
    </message>
    <message>
        <source>more than {1} layers are asked for</source>
        <translation>plus de {1} niveaux sont demandés</translation>
    </message>
    <message>
        <source>more than {1} lines a layer are asked for</source>
        <translation>plus de {1} lignes par niveau sont demandées</translation>
    </message>
    <message>
        <source>morph</source>
        <translation>transition</translation>
    </message>
    <message>
        <source>motion {1}: </source>
        <translation>mouvement {1} : </translation>
    </message>
    <message>
        <source>move it onto the part</source>
        <translation>la déplacer sur la pièce</translation>
    </message>
    <message>
        <source>move its curves or its centre onto the part</source>
        <translation>déplacer ses courbes ou son centre sur la pièce</translation>
    </message>
    <message>
        <source>move the part onto the axis, let the axis go through the part's middle, or give two points of it</source>
        <translation>déplacer la pièce sur l'axe, faire passer l'axe par le milieu de la pièce, ou en donner deux points</translation>
    </message>
    <message>
        <source>move the part, or change the operation's limits</source>
        <translation>déplacer la pièce, ou changer les limites de l'opération</translation>
    </message>
    <message>
        <source>move the part, or choose a shorter tool</source>
        <translation>déplacer la pièce, ou choisir un outil plus court</translation>
    </message>
    <message>
        <source>move them one by one, or at feed</source>
        <translation>les déplacer un par un, ou en avance</translation>
    </message>
    <message>
        <source>move what is in the way, make it smaller, or give it less clearance</source>
        <translation>déplacer ce qui gêne, le réduire, ou lui donner moins de distance</translation>
    </message>
    <message>
        <source>moved by {1}</source>
        <translation>déplacé de {1}</translation>
    </message>
    <message>
        <source>name a .facetmill or a .json file</source>
        <translation>nommer un fichier .facetmill ou .json</translation>
    </message>
    <message>
        <source>name a file</source>
        <translation>nommer un fichier</translation>
    </message>
    <message>
        <source>name a file in it</source>
        <translation>y nommer un fichier</translation>
    </message>
    <message>
        <source>name a file on disk</source>
        <translation>nommer un fichier sur disque</translation>
    </message>
    <message>
        <source>name a file that `facetmill-cli pack` has written</source>
        <translation>nommer un fichier que `facetmill-cli pack` a écrit</translation>
    </message>
    <message>
        <source>name a file that `facetmill-cli pack` or File &gt; Save packed copy has written</source>
        <translation>nommer un fichier écrit par `facetmill-cli pack` ou Fichier &gt; Enregistrer une copie compressée</translation>
    </message>
    <message>
        <source>name a folder that exists or can be made</source>
        <translation>nommer un dossier qui existe ou peut être créé</translation>
    </message>
    <message>
        <source>name a larger tool</source>
        <translation>nommer un outil plus grand</translation>
    </message>
    <message>
        <source>name a larger tool or a smaller thickness</source>
        <translation>nommer un outil plus grand ou une épaisseur plus petite</translation>
    </message>
    <message>
        <source>name a positive length</source>
        <translation>nommer une longueur positive</translation>
    </message>
    <message>
        <source>name a tool of the project</source>
        <translation>nommer un outil du projet</translation>
    </message>
    <message>
        <source>name an {1} file</source>
        <translation>nommer un fichier : {1}</translation>
    </message>
    <message>
        <source>name each once: {1}</source>
        <translation>nommer chacune une fois : {1}</translation>
    </message>
    <message>
        <source>name faces of the part's file</source>
        <translation>nommer des faces du fichier de la pièce</translation>
    </message>
    <message>
        <source>name it first</source>
        <translation>le nommer d'abord</translation>
    </message>
    <message>
        <source>name it in the project, as `wcs`</source>
        <translation>le nommer dans le projet, `wcs`</translation>
    </message>
    <message>
        <source>name its objects: {1}</source>
        <translation>nommer ses objets : {1}</translation>
    </message>
    <message>
        <source>name the control as people call it</source>
        <translation>nommer la commande comme on l'appelle</translation>
    </message>
    <message>
        <source>name the fixture's mesh file</source>
        <translation>nommer le fichier de maillage du bridage</translation>
    </message>
    <message>
        <source>name the kind of operation</source>
        <translation>nommer le type de l'opération</translation>
    </message>
    <message>
        <source>name the machine</source>
        <translation>nommer la machine</translation>
    </message>
    <message>
        <source>name the machine as people call it</source>
        <translation>nommer la machine comme on l'appelle</translation>
    </message>
    <message>
        <source>name the other one too, or none to take the outline</source>
        <translation>nommer aussi l’autre, ou aucune pour prendre le contour</translation>
    </message>
    <message>
        <source>name the other scan's file</source>
        <translation>nommer le fichier de l'autre scan</translation>
    </message>
    <message>
        <source>name the part's file</source>
        <translation>nommer le fichier de la pièce</translation>
    </message>
    <message>
        <source>name the project's file</source>
        <translation>nommer le fichier du projet</translation>
    </message>
    <message>
        <source>name the stock's mesh file</source>
        <translation>nommer le fichier de maillage du brut</translation>
    </message>
    <message>
        <source>name the tool</source>
        <translation>nommer l'outil</translation>
    </message>
    <message>
        <source>name the tool, or write a .fctl library</source>
        <translation>nommer l'outil, ou écrire une bibliothèque .fctl</translation>
    </message>
    <message>
        <source>name what varies</source>
        <translation>nommer ce qui varie</translation>
    </message>
    <message>
        <source>names a vertex that does not exist</source>
        <translation>nomme un sommet qui n'existe pas</translation>
    </message>
    <message>
        <source>names a vertex that the mesh has not</source>
        <translation>nomme un sommet que le maillage n'a pas</translation>
    </message>
    <message>
        <source>names more than one 3D model</source>
        <translation>nomme plus d'un modèle 3D</translation>
    </message>
    <message>
        <source>names no 3D model</source>
        <translation>ne nomme aucun modèle 3D</translation>
    </message>
    <message>
        <source>names, separated by commas</source>
        <translation>des noms, séparés par des virgules</translation>
    </message>
    <message>
        <source>nearest comes {1} ({2}): {3}</source>
        <translation>le plus proche est {1} ({2}) : {3}</translation>
    </message>
    <message>
        <source>needles</source>
        <translation>aiguilles</translation>
    </message>
    <message>
        <source>needles, smooth, decimate: no place of the surface moves farther. join: nor does the other scan, which is laid on this one; 0: it stays where it is.</source>
        <translation>aiguilles, lisse, décimer : aucun endroit de la surface ne bouge davantage. joindre : l'autre scan, posé sur celui-ci, non plus ; 0 : il reste où il est.</translation>
    </message>
    <message>
        <source>needs a lead of up to {1}, allowed are {2}</source>
        <translation>demande une attaque jusqu'à {1}, permis : {2}</translation>
    </message>
    <message>
        <source>no FINI or END: the file may be cut short</source>
        <translation>ni FINI ni END : le fichier est peut-être tronqué</translation>
    </message>
    <message>
        <source>no arc of this radius leads there</source>
        <translation>aucun arc de ce rayon n'y mène</translation>
    </message>
    <message>
        <source>no candidate meets the limits; {1}</source>
        <translation>aucun candidat ne respecte les limites ; {1}</translation>
    </message>
    <message>
        <source>no code means '{1}'</source>
        <translation>aucun code ne signifie '{1}'</translation>
    </message>
    <message>
        <source>no code says what the unit of the numbers is</source>
        <translation>aucun code ne dit l'unité des nombres</translation>
    </message>
    <message>
        <source>no contact point has a free posture with a lead of at most {1}</source>
        <translation>aucun point de contact n'a de posture libre avec une attaque d'au plus {1}</translation>
    </message>
    <message>
        <source>no depth leaves what is allowed</source>
        <translation>aucune profondeur ne laisse ce qui est permis</translation>
    </message>
    <message>
        <source>no drive plane meets the part</source>
        <translation>aucun plan directeur ne rencontre la pièce</translation>
    </message>
    <message>
        <source>no face has three corners</source>
        <translation>aucune face n'a trois sommets</translation>
    </message>
    <message>
        <source>no facet of the part can be cut {1}: all {2} stand upright or have no area</source>
        <translation>aucune facette de la pièce ne peut être usinée {1} : les {2} sont verticales ou sans aire</translation>
    </message>
    <message>
        <source>no file can be called so</source>
        <translation>aucun fichier ne peut s'appeler ainsi</translation>
    </message>
    <message>
        <source>no file can be locked there</source>
        <translation>aucun fichier ne peut y être verrouillé</translation>
    </message>
    <message>
        <source>no inclined tool that turns steadily is free of the part, and of what stands of the stock, along {1} of the passes, which are left out: rough closer, use a longer tool, or allow a larger tilt limit</source>
        <translation>sur {1} des passes aucun outil incliné qui tourne régulièrement n’est libre de la pièce et de ce qui reste du brut, elles sont omises : ébaucher plus près, prendre un outil plus long, ou permettre une limite d’inclinaison plus grande</translation>
    </message>
    <message>
        <source>no layer lies lower than {1}, where stock or part end, and over {2} of the part, seen {3}, the tool would have to be lower: up to {4} stays above the allowance, most at {5}: take a tool that is flatter at its end, or leave it to what comes after</source>
        <translation>aucun niveau n'est plus bas que {1}, où finissent brut ou pièce, et sur {2} de la pièce, vue {3}, l'outil devrait être plus bas : jusqu'à {4} reste au-dessus de la surépaisseur, le plus à {5} : prendre un outil au bout plus plat, ou le laisser à la suite</translation>
    </message>
    <message>
        <source>no lead up to {1} is free</source>
        <translation>aucune attaque jusqu'à {1} n'est libre</translation>
    </message>
    <message>
        <source>no level lies within it</source>
        <translation>aucun niveau n'y passe</translation>
    </message>
    <message>
        <source>no lines of this tool leave as little as {1}</source>
        <translation>aucune ligne de cet outil ne laisse aussi peu que {1}</translation>
    </message>
    <message>
        <source>no motion at feed comes near the stock</source>
        <translation>aucun mouvement en avance n'approche du brut</translation>
    </message>
    <message>
        <source>no operation before it cuts with tool {1}, its previous tool: what that would have cut stays</source>
        <translation>aucune opération précédente n'usine avec l'outil {1}, son outil précédent : ce qu'il aurait usiné reste</translation>
    </message>
    <message>
        <source>no operation finishes there: only the tool{1} fits, and that operation leaves stock</source>
        <translation>aucune opération ne finit à cet endroit : seul l'outil{1} y passe, et cette opération laisse de la matière</translation>
    </message>
    <message>
        <source>no operation was planned</source>
        <translation>aucune opération n'a été planifiée</translation>
    </message>
    <message>
        <source>no pass lies within it</source>
        <translation>aucune passe ne s'y trouve</translation>
    </message>
    <message>
        <source>no pass meets the part</source>
        <translation>aucune passe ne rencontre la pièce</translation>
    </message>
    <message>
        <source>no pass meets the stock</source>
        <translation>aucune passe ne rencontre le brut</translation>
    </message>
    <message>
        <source>no place needs a lead above {1}: the main path cuts all of the part, there is nothing to rework</source>
        <translation>aucun endroit ne demande une attaque au-dessus de {1} : le parcours principal usine toute la pièce, il n'y a rien à reprendre</translation>
    </message>
    <message>
        <source>no place of the part can be come to</source>
        <translation>aucun endroit de la pièce n'est accessible</translation>
    </message>
    <message>
        <source>no place of the part can be come to from above</source>
        <translation>aucun endroit de la pièce n'est accessible d'en haut</translation>
    </message>
    <message>
        <source>no setup comes before the first, so there is no rest of its stock</source>
        <translation>aucun posage ne précède le premier, il n'y a donc pas de reste de son brut</translation>
    </message>
    <message>
        <source>no stream</source>
        <translation>aucun flux</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>fichier introuvable</translation>
    </message>
    <message>
        <source>no temporary folder can be made: {1}</source>
        <translation>aucun dossier temporaire ne peut être créé : {1}</translation>
    </message>
    <message>
        <source>no tool axis sees it</source>
        <translation>aucun axe d'outil ne le voit</translation>
    </message>
    <message>
        <source>no tool fits</source>
        <translation>aucun outil n'y passe</translation>
    </message>
    <message>
        <source>no tool is in the spindle</source>
        <translation>aucun outil n'est dans la broche</translation>
    </message>
    <message>
        <source>no valley lies where something is to be cut</source>
        <translation>aucune vallée ne se trouve là où il y a à usiner</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>aucune valeur</translation>
    </message>
    <message>
        <source>no work coordinate system is chosen</source>
        <translation>aucun système de coordonnées pièce n'est choisi</translation>
    </message>
    <message>
        <source>nobody has said which tool leaves it</source>
        <translation>personne n'a dit quel outil le laisse</translation>
    </message>
    <message>
        <source>nodes hold each other too deeply, or themselves</source>
        <translation>des nœuds s’emboîtent trop profondément, ou se contiennent eux-mêmes</translation>
    </message>
    <message>
        <source>nodes[{1}]</source>
        <translation>nodes[{1}]</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none of its surfaces could be tessellated</source>
        <translation>aucune de ses surfaces n'a pu être maillée</translation>
    </message>
    <message>
        <source>none of the operations looked at can be made: {1}: {2}</source>
        <translation>aucune des opérations examinées n’est possible : {1} : {2}</translation>
    </message>
    <message>
        <source>none of the operations looked at can be made{1}</source>
        <translation>aucune des opérations examinées n’est possible{1}</translation>
    </message>
    <message>
        <source>none of the {1} facets has an area</source>
        <translation>aucune des {1} facettes n'a d'aire</translation>
    </message>
    <message>
        <source>none of {1} contact points has a free posture</source>
        <translation>aucun des {1} points de contact n'a de posture libre</translation>
    </message>
    <message>
        <source>none was planned</source>
        <translation>aucun n'a été planifié</translation>
    </message>
    <message>
        <source>normals turn by more than the limit</source>
        <translation>les normales tournent de plus que la limite</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>non examiné</translation>
    </message>
    <message>
        <source>not one line has the word {wcs}</source>
        <translation>aucune ligne n'a le mot {wcs}</translation>
    </message>
    <message>
        <source>not one line has the words {plane_z} and {plane_x}</source>
        <translation>aucune ligne n'a les mots {plane_z} et {plane_x}</translation>
    </message>
    <message>
        <source>not valid JSON near '{1}'</source>
        <translation>JSON non valable près de '{1}'</translation>
    </message>
    <message>
        <source>nothing ends the tilted plane</source>
        <translation>rien ne termine le plan incliné</translation>
    </message>
    <message>
        <source>nothing follows the header</source>
        <translation>rien ne suit l'en-tête</translation>
    </message>
    <message>
        <source>nothing has to be cleaned up, or allow less</source>
        <translation>il n’y a rien à reprendre, ou admettez moins</translation>
    </message>
    <message>
        <source>nothing is cut</source>
        <translation>rien n'est usiné</translation>
    </message>
    <message>
        <source>nothing is left between its ends</source>
        <translation>il ne reste rien entre ses extrémités</translation>
    </message>
    <message>
        <source>nothing is measured that is called '{1}'</source>
        <translation>rien de ce qui est mesuré ne s'appelle '{1}'</translation>
    </message>
    <message>
        <source>nothing is wanted</source>
        <translation>rien n'est voulu</translation>
    </message>
    <message>
        <source>nothing lies on the file's build plate</source>
        <translation>rien n'est sur le plateau du fichier</translation>
    </message>
    <message>
        <source>nothing may vary</source>
        <translation>rien ne peut varier</translation>
    </message>
    <message>
        <source>nothing of it is left by {1}</source>
        <translation>rien n'en est laissé par {1}</translation>
    </message>
    <message>
        <source>nothing of the part goes round: its passes run from edge to edge</source>
        <translation>rien de la pièce ne fait le tour : ses passes vont d’un bord à l’autre</translation>
    </message>
    <message>
        <source>nothing of the part holds the tool on its way to the axis</source>
        <translation>rien de la pièce n'arrête l'outil sur son chemin vers l'axe</translation>
    </message>
    <message>
        <source>nothing of the part is as steep as asked for</source>
        <translation>rien de la pièce n’est aussi raide que demandé</translation>
    </message>
    <message>
        <source>nothing of the part is to be cut</source>
        <translation>rien de la pièce n’est à usiner</translation>
    </message>
    <message>
        <source>nothing of the part lies in it</source>
        <translation>rien de la pièce ne s'y trouve</translation>
    </message>
    <message>
        <source>nothing of the part lies so far within it that the cutter has room</source>
        <translation>rien de la pièce n'y est assez loin du bord pour que la fraise ait de la place</translation>
    </message>
    <message>
        <source>nothing of the part lies where it is to cut</source>
        <translation>rien de la pièce ne se trouve là où elle doit usiner</translation>
    </message>
    <message>
        <source>nothing of the part that can be cut {1} has a slope from {2} to {3} degrees</source>
        <translation>rien de la pièce qui puisse être usiné {1} n'a une pente de {2} à {3} degrés</translation>
    </message>
    <message>
        <source>nothing of the part that can be cut {1} is less steep than {2} degrees</source>
        <translation>rien de la pièce qui puisse être usiné {1} n'est moins raide que {2} degrés</translation>
    </message>
    <message>
        <source>nothing of the stock stands above the part and the allowance of {1}</source>
        <translation>rien du brut ne dépasse la pièce et la surépaisseur de {1}</translation>
    </message>
    <message>
        <source>nothing runs so far to that side of it</source>
        <translation>rien ne passe aussi loin de ce côté</translation>
    </message>
    <message>
        <source>nothing runs {1} to that side of it</source>
        <translation>rien ne passe à {1} de ce côté-là</translation>
    </message>
    <message>
        <source>nothing says what the feed is per</source>
        <translation>rien ne dit à quoi l'avance se rapporte</translation>
    </message>
    <message>
        <source>nothing takes the tool up</source>
        <translation>rien ne relève l'outil</translation>
    </message>
    <message>
        <source>nothing turns the rotary axes: no code means 'plane_axes'</source>
        <translation>rien ne tourne les axes rotatifs : aucun code ne signifie 'plane_axes'</translation>
    </message>
    <message>
        <source>nothing was written</source>
        <translation>rien n'a été écrit</translation>
    </message>
    <message>
        <source>nowhere is the part's outline straight and free enough</source>
        <translation>nulle part le contour de la pièce n'est assez droit et libre</translation>
    </message>
    <message>
        <source>nowhere more than the tolerance stands of the stock</source>
        <translation>nulle part il ne reste du brut plus que la tolérance</translation>
    </message>
    <message>
        <source>nowhere on the part, away from its open borders, is what the programs leave held against the tolerance</source>
        <translation>nulle part sur la pièce, loin de ses bords ouverts, ce que laissent les programmes n'est comparé à la tolérance</translation>
    </message>
    <message>
        <source>number tools from 1</source>
        <translation>numéroter les outils à partir de 1</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objet</translation>
    </message>
    <message>
        <source>object {1}</source>
        <translation>objet {1}</translation>
    </message>
    <message>
        <source>objects and lists are nested too deep</source>
        <translation>objets et listes sont trop imbriqués</translation>
    </message>
    <message>
        <source>objects are put together too deeply, or hold themselves: {1}</source>
        <translation>des objets sont assemblés trop profondément, ou se contiennent : {1}</translation>
    </message>
    <message>
        <source>objects there are: {1}</source>
        <translation>objets existants : {1}</translation>
    </message>
    <message>
        <source>of the largest speed</source>
        <translation>de la plus grande vitesse</translation>
    </message>
    <message>
        <source>of what stands above the allowance this tool reaches nothing</source>
        <translation>de ce qui dépasse la surépaisseur, cet outil n'atteint rien</translation>
    </message>
    <message>
        <source>on</source>
        <translation>dessus</translation>
    </message>
    <message>
        <source>one</source>
        <translation>un seul</translation>
    </message>
    <message>
        <source>one of: {1}</source>
        <translation>un de : {1}</translation>
    </message>
    <message>
        <source>one place is left to clean-up because the tool cannot come there from its neighbours without gouging or turning too far</source>
        <translation>un endroit est laissé au nettoyage parce que l'outil n'y vient pas des voisins sans entailler ou trop tourner</translation>
    </message>
    <message>
        <source>oneway</source>
        <translation>sens unique</translation>
    </message>
    <message>
        <source>only UNITS/MM and UNITS/INCHES are read</source>
        <translation>seuls UNITS/MM et UNITS/INCHES sont lus</translation>
    </message>
    <message>
        <source>only a ball cuts the same however it leans, and tool {1} has no ball end</source>
        <translation>seule une boule usine pareil quelle que soit son inclinaison, et l’outil {1} n’a pas de bout en boule</translation>
    </message>
    <message>
        <source>only a step of kind hole leaves a hole open</source>
        <translation>seule une étape du genre trou laisse un trou ouvert</translation>
    </message>
    <message>
        <source>only one of its two curves is named</source>
        <translation>une seule de ses deux courbes est nommée</translation>
    </message>
    <message>
        <source>only {1}/OFF is read; output plain GOTO statements</source>
        <translation>seul {1}/OFF est lu ; sortir des instructions GOTO simples</translation>
    </message>
    <message>
        <source>open the file itself, under a name that ends as its format does</source>
        <translation>ouvrir le fichier lui-même, sous un nom qui finit comme son format</translation>
    </message>
    <message>
        <source>open the mesh itself, under a name that ends as its format does</source>
        <translation>ouvrir le maillage lui-même, sous un nom qui finit comme son format</translation>
    </message>
    <message>
        <source>open them one by one, or join them in the program that made them</source>
        <translation>ouvrez-les un par un, ou réunissez-les dans le programme qui les a faits</translation>
    </message>
    <message>
        <source>operation '{1}'</source>
        <translation>opération '{1}'</translation>
    </message>
    <message>
        <source>operation '{1}' cuts within it</source>
        <translation>l'opération '{1}' y usine</translation>
    </message>
    <message>
        <source>operation '{1}' follows it</source>
        <translation>l’opération « {1} » la suit</translation>
    </message>
    <message>
        <source>operation '{1}' has a feed of {2} mm/min, and the machine goes {3} at most</source>
        <translation>l'opération '{1}' a une avance de {2} mm/min, et la machine va au plus à {3}</translation>
    </message>
    <message>
        <source>operation '{1}' has tool {2}, and the control numbers them to {3}</source>
        <translation>l'opération '{1}' a l'outil {2}, et la commande les numérote jusqu'à {3}</translation>
    </message>
    <message>
        <source>operation '{1}' inclines the tool, and the control has three axes</source>
        <translation>l'opération '{1}' incline l'outil, et la commande a trois axes</translation>
    </message>
    <message>
        <source>operation '{1}' keeps off it</source>
        <translation>l'opération '{1}' l'évite</translation>
    </message>
    <message>
        <source>operation '{1}' turns the part, and the control has no inverse time feed</source>
        <translation>l'opération '{1}' tourne la pièce, et la commande n'a pas d'avance en temps inverse</translation>
    </message>
    <message>
        <source>operation '{1}' uses this tool</source>
        <translation>l'opération '{1}' utilise cet outil</translation>
    </message>
    <message>
        <source>operation '{1}', motion {2}: the machine would have to rewind its rotary axes while it cuts, and there is no room to</source>
        <translation>opération '{1}', mouvement {2} : la machine devrait rembobiner ses axes rotatifs pendant la coupe, et il n'y a pas la place</translation>
    </message>
    <message>
        <source>operation '{1}', {2}</source>
        <translation>opération '{1}', {2}</translation>
    </message>
    <message>
        <source>operation '{1}': {2} would go from {3} to {4} of the machine, and its travel ends before</source>
        <translation>opération '{1}' : {2} irait de {3} à {4} de la machine, et sa course finit avant</translation>
    </message>
    <message>
        <source>operations of this kind have no preview of their passes</source>
        <translation>les opérations de ce type n’ont pas d’aperçu de leurs passes</translation>
    </message>
    <message>
        <source>operations there are: {1}</source>
        <translation>opérations existantes : {1}</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>origine</translation>
    </message>
    <message>
        <source>other postures would be free than this way of choosing tries: choose them by global</source>
        <translation>d'autres postures seraient libres que celles essayées par ce choix : les choisir par globale</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>output straight GOTO statements (no arcs, cycles or transformations)</source>
        <translation>sortir des instructions GOTO droites (ni arcs, ni cycles, ni transformations)</translation>
    </message>
    <message>
        <source>outward</source>
        <translation>vers le dehors</translation>
    </message>
    <message>
        <source>paint facets, widen it, or move it onto the part</source>
        <translation>peindre des facettes, l'élargir, ou la déplacer sur la pièce</translation>
    </message>
    <message>
        <source>paint it anew</source>
        <translation>la repeindre</translation>
    </message>
    <message>
        <source>paint the boundary anew</source>
        <translation>repeindre la limite</translation>
    </message>
    <message>
        <source>paint the boundary, or take the part from such a file</source>
        <translation>peindre la limite, ou prendre la pièce d'un tel fichier</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>parallèle</translation>
    </message>
    <message>
        <source>parallel: in drive planes along the direction. morph: each piece of the surface by itself, in passes that go over from its one edge along the direction to the other, as the surface flows: blades and shrouds. around: in closed rings about each piece that goes round (blades, hubs, bottles), from its one border to the other or to its end; other pieces as with morph. A fixed step-over is kept where passes are farthest apart.</source>
        <translation>parallel : dans des plans le long de la direction. morph : chaque morceau de la surface à part, en passes qui vont de l’un de ses bords le long de la direction à l’autre, comme la surface s’écoule : aubes et flasques. around : en anneaux fermés autour de chaque morceau qui fait le tour (aubes, moyeux, bouteilles), de l’un de ses bords à l’autre ou jusqu’au bout ; les autres morceaux comme avec morph. Un écart fixe est tenu là où les passes sont le plus éloignées.</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>part.repair[{1}].file</source>
        <translation>part.repair[{1}].file</translation>
    </message>
    <message>
        <source>passes are up to {1} below the stock's outside, the flutes are {2} long: use a longer tool</source>
        <translation>des passes sont jusqu'à {1} sous l'extérieur du brut, la partie coupante a {2} : prendre un outil plus long</translation>
    </message>
    <message>
        <source>pick another edge, or lay the part first</source>
        <translation>choisir une autre arête, ou coucher d'abord la pièce</translation>
    </message>
    <message>
        <source>pick points of one side</source>
        <translation>choisir des points d'un côté</translation>
    </message>
    <message>
        <source>pick three points that are farther apart</source>
        <translation>choisir trois points plus éloignés</translation>
    </message>
    <message>
        <source>pieces</source>
        <translation>morceaux</translation>
    </message>
    <message>
        <source>pieces: only so many with the largest areas stay.</source>
        <translation>morceaux : seuls restent autant des plus grandes aires.</translation>
    </message>
    <message>
        <source>pieces: those whose box has a smaller diagonal go. holes: those of at most this diameter are filled, 0: all. crossings: as holes. fins: as pieces. join: how far two scans of one surface may lie apart, 0: three mean edges.</source>
        <translation>morceaux : ceux dont la boîte a une diagonale plus petite partent. trous : ceux d'au plus ce diamètre sont remplis, 0 : tous. croisements : comme les trous. lambeaux : comme les morceaux. joindre : de combien deux scans d'une surface peuvent s'écarter, 0 : trois arêtes moyennes.</translation>
    </message>
    <message>
        <source>pieces: those with fewer facets go. decimate: ends when so few are left.</source>
        <translation>morceaux : ceux de moins de facettes partent. décimer : finit quand il en reste si peu.</translation>
    </message>
    <message>
        <source>pieces: those with less area go.</source>
        <translation>morceaux : ceux de moins d'aire partent.</translation>
    </message>
    <message>
        <source>place</source>
        <translation>point</translation>
    </message>
    <message>
        <source>places are not told from the origin</source>
        <translation>les endroits ne sont pas donnés depuis l'origine</translation>
    </message>
    <message>
        <source>places lie under the part itself, seen along the tool</source>
        <translation>des endroits sont sous la pièce elle-même, vus le long de l'outil</translation>
    </message>
    <message>
        <source>places looked at are {1} apart, and a cutter has a radius of {2}: a resolution and a spacing of at most {3} would do</source>
        <translation>les endroits examinés sont à {1} l'un de l'autre, et une fraise a un rayon de {2} : une résolution et un espacement d'au plus {3} suffiraient</translation>
    </message>
    <message>
        <source>plan again</source>
        <translation>planifier de nouveau</translation>
    </message>
    <message>
        <source>plan again; report the project</source>
        <translation>planifier de nouveau ; signaler le projet</translation>
    </message>
    <message>
        <source>plan an operation first</source>
        <translation>planifier d'abord une opération</translation>
    </message>
    <message>
        <source>plan at least one</source>
        <translation>en planifier au moins une</translation>
    </message>
    <message>
        <source>plan it again</source>
        <translation>planifier de nouveau</translation>
    </message>
    <message>
        <source>plan the operation to see its passes</source>
        <translation>planifiez l’opération pour voir ses passes</translation>
    </message>
    <message>
        <source>plan the operation to see why</source>
        <translation>planifiez l’opération pour voir pourquoi</translation>
    </message>
    <message>
        <source>plan the setups before this one</source>
        <translation>planifier les posages précédents</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planifiée</translation>
    </message>
    <message>
        <source>plunge</source>
        <translation>plongée</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>points into the part</source>
        <translation>pointe dans la pièce</translation>
    </message>
    <message>
        <source>post '{1}'</source>
        <translation>post-processeur '{1}'</translation>
    </message>
    <message>
        <source>preset {1}</source>
        <translation>préréglage {1}</translation>
    </message>
    <message>
        <source>process the program to plain GOTO statements first</source>
        <translation>traiter d'abord le programme en instructions GOTO simples</translation>
    </message>
    <message>
        <source>program '{1}'</source>
        <translation>programme '{1}'</translation>
    </message>
    <message>
        <source>put GOTO or FROM before it</source>
        <translation>mettre GOTO ou FROM avant</translation>
    </message>
    <message>
        <source>put UNITS before CUTTER and the first GOTO</source>
        <translation>mettre UNITS avant CUTTER et le premier GOTO</translation>
    </message>
    <message>
        <source>put it into one of "setups"</source>
        <translation>le mettre dans un des "setups"</translation>
    </message>
    <message>
        <source>put it there, or name another one in the project</source>
        <translation>l'y mettre, ou en nommer un autre dans le projet</translation>
    </message>
    <message>
        <source>put the zero elsewhere, or mend the file</source>
        <translation>mettre l'origine ailleurs, ou réparer le fichier</translation>
    </message>
    <message>
        <source>raise the feed, or the feed's decimals in the post</source>
        <translation>relever l'avance, ou ses décimales dans le post-processeur</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampe</translation>
    </message>
    <message>
        <source>reading stopped before the end of the file</source>
        <translation>la lecture s'est arrêtée avant la fin du fichier</translation>
    </message>
    <message>
        <source>rectangular</source>
        <translation>rectangulaire</translation>
    </message>
    <message>
        <source>reduce the mesh</source>
        <translation>réduire le maillage</translation>
    </message>
    <message>
        <source>regions of rework</source>
        <translation>zones de reprise</translation>
    </message>
    <message>
        <source>remove its operations instead</source>
        <translation>supprimer plutôt ses opérations</translation>
    </message>
    <message>
        <source>rename an operation, a setup or the part's file</source>
        <translation>renommer une opération, un posage ou le fichier de la pièce</translation>
    </message>
    <message>
        <source>rename or export it again</source>
        <translation>le renommer ou l'exporter de nouveau</translation>
    </message>
    <message>
        <source>rename the file or the item</source>
        <translation>renommer le fichier ou l'élément</translation>
    </message>
    <message>
        <source>report the part</source>
        <translation>signaler la pièce</translation>
    </message>
    <message>
        <source>report this</source>
        <translation>le signaler</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>retract Z first</source>
        <translation>retirer d'abord Z</translation>
    </message>
    <message>
        <source>retract before it</source>
        <translation>se retirer avant</translation>
    </message>
    <message>
        <source>retract otherwise</source>
        <translation>se retirer autrement</translation>
    </message>
    <message>
        <source>retract to 0 of the machine</source>
        <translation>se retirer au 0 de la machine</translation>
    </message>
    <message>
        <source>rework: {1}</source>
        <translation>reprise : {1}</translation>
    </message>
    <message>
        <source>rightward</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>rings</source>
        <translation>anneaux</translation>
    </message>
    <message>
        <source>rings need a border to lie along</source>
        <translation>les anneaux demandent un bord le long duquel passer</translation>
    </message>
    <message>
        <source>rotary axes turn to a tilted plane while the tool is down</source>
        <translation>des axes rotatifs tournent vers un plan incliné pendant que l'outil est en bas</translation>
    </message>
    <message>
        <source>rotate the part</source>
        <translation>tourner la pièce</translation>
    </message>
    <message>
        <source>rough before it, or use flutes that are {1} longer</source>
        <translation>ébaucher avant, ou prendre une partie coupante plus longue de {1}</translation>
    </message>
    <message>
        <source>rough before it, use a longer tool, or allow a larger tilt limit</source>
        <translation>ébaucher avant, prendre un outil plus long, ou permettre une limite d’inclinaison plus grande</translation>
    </message>
    <message>
        <source>rough with a tool whose taper angle is 0 or more</source>
        <translation>ébaucher avec un outil dont l'angle de cône est 0 ou plus</translation>
    </message>
    <message>
        <source>roughing with a tool that is narrower above its end leaves material hanging over it</source>
        <translation>ébaucher avec un outil plus étroit au-dessus de son bout laisse de la matière en surplomb</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>tr/min</translation>
    </message>
    <message>
        <source>run the study again</source>
        <translation>relancer l'étude</translation>
    </message>
    <message>
        <source>sample surface</source>
        <translation>surface d'exemple</translation>
    </message>
    <message>
        <source>save it as ASCII or UTF-8</source>
        <translation>l'enregistrer en ASCII ou UTF-8</translation>
    </message>
    <message>
        <source>save it as ASCII or UTF-8 (PowerShell: Out-File -Encoding ascii)</source>
        <translation>l'enregistrer en ASCII ou UTF-8 (PowerShell : Out-File -Encoding ascii)</translation>
    </message>
    <message>
        <source>save it as UTF-8</source>
        <translation>l'enregistrer en UTF-8</translation>
    </message>
    <message>
        <source>save it as one channel of grey, upright</source>
        <translation>l’enregistrer en un seul canal de gris, à l’endroit</translation>
    </message>
    <message>
        <source>save it as one channel of grey: 8 or 16 bits, or 32-bit floats</source>
        <translation>l’enregistrer en un seul canal de gris : 8 ou 16 bits, ou flottants de 32 bits</translation>
    </message>
    <message>
        <source>save it in binary form, as .glb</source>
        <translation>l’enregistrer sous forme binaire, en .glb</translation>
    </message>
    <message>
        <source>save it in strips or smaller tiles</source>
        <translation>l'enregistrer en bandes ou tuiles plus petites</translation>
    </message>
    <message>
        <source>save it with 8 bits a channel</source>
        <translation>l'enregistrer en 8 bits par canal</translation>
    </message>
    <message>
        <source>save it without interlacing</source>
        <translation>l'enregistrer sans entrelacement</translation>
    </message>
    <message>
        <source>save the file as UTF-8</source>
        <translation>enregistrer le fichier en UTF-8</translation>
    </message>
    <message>
        <source>save the picture as PNG, 8 or 16 bits of grey</source>
        <translation>enregistrer l'image en PNG, 8 ou 16 bits de gris</translation>
    </message>
    <message>
        <source>save the picture as TIFF, 16 bits of grey</source>
        <translation>enregistrer l'image en TIFF, 16 bits de gris</translation>
    </message>
    <message>
        <source>say how far the surface may move</source>
        <translation>dire de combien la surface peut bouger</translation>
    </message>
    <message>
        <source>say how large a place may be made anew</source>
        <translation>dire quelle taille peut avoir un endroit refait</translation>
    </message>
    <message>
        <source>say how large a sheet may be that goes</source>
        <translation>dire quelle taille peut avoir une feuille qui part</translation>
    </message>
    <message>
        <source>say how thick the sheet becomes</source>
        <translation>dire quelle épaisseur prend la feuille</translation>
    </message>
    <message>
        <source>say the plane's direction</source>
        <translation>dire la direction du plan</translation>
    </message>
    <message>
        <source>say what the step does</source>
        <translation>dire ce que fait l'étape</translation>
    </message>
    <message>
        <source>scallop</source>
        <translation>crête constante</translation>
    </message>
    <message>
        <source>section</source>
        <translation>section</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>sections</translation>
    </message>
    <message>
        <source>see the codes of its post</source>
        <translation>voir les codes de son post-processeur</translation>
    </message>
    <message>
        <source>see the numbers in table.md</source>
        <translation>voir les nombres dans table.md</translation>
    </message>
    <message>
        <source>see the words and codes of its post</source>
        <translation>voir les mots et codes de son post-processeur</translation>
    </message>
    <message>
        <source>see the words of its post</source>
        <translation>voir les mots de son post-processeur</translation>
    </message>
    <message>
        <source>see what ssh says to it</source>
        <translation>voir ce qu’en dit ssh</translation>
    </message>
    <message>
        <source>see whether Slurm runs: sinfo</source>
        <translation>voir si Slurm tourne : sinfo</translation>
    </message>
    <message>
        <source>send Z home first</source>
        <translation>envoyer d'abord Z à son origine</translation>
    </message>
    <message>
        <source>send Z home first, alone</source>
        <translation>envoyer d'abord Z à son origine, seul</translation>
    </message>
    <message>
        <source>send it again as a binary file</source>
        <translation>l’envoyer de nouveau comme fichier binaire</translation>
    </message>
    <message>
        <source>send the files as they are</source>
        <translation>envoyer les fichiers tels quels</translation>
    </message>
    <message>
        <source>set multi_axis to tcp or vectors</source>
        <translation>mettre multi_axis à tcp ou vectors</translation>
    </message>
    <message>
        <source>set the tilt limit or the depth to 0</source>
        <translation>mettre à 0 la limite d’inclinaison ou la profondeur</translation>
    </message>
    <message>
        <source>set the {1}</source>
        <translation>fixer : {1}</translation>
    </message>
    <message>
        <source>setup '{1}'</source>
        <translation>posage '{1}'</translation>
    </message>
    <message>
        <source>setups there are: {1}</source>
        <translation>posages existants : {1}</translation>
    </message>
    <message>
        <source>shank or holder come into the stock, as operations with the upright tool leave it, along {1} of {2} of cuts, as far as passes before them have not cleared it: rough there first, or use longer flutes</source>
        <translation>queue ou porte-outil entrent dans le brut, tel que le laissent les opérations à outil vertical, le long de {1} sur {2} de coupes, où des passes précédentes ne l'ont pas enlevé : y ébaucher d'abord, ou prendre une partie coupante plus longue</translation>
    </message>
    <message>
        <source>shank or holder keep the cutter from hollows of the part</source>
        <translation>queue ou porte-outil écartent la fraise de creux de la pièce</translation>
    </message>
    <message>
        <source>shank or holder would come into the part wherever the cutter could cut</source>
        <translation>queue ou porte-outil entreraient dans la pièce partout où la fraise pourrait usiner</translation>
    </message>
    <message>
        <source>shank or holder would come into the part, or into what stands of the stock, wherever the cutter could cut, however far it is inclined within the tilt limit</source>
        <translation>la queue ou le porte-outil entrerait dans la pièce, ou dans ce qui reste du brut, partout où la fraise pourrait usiner, aussi loin qu’elle s’incline dans la limite</translation>
    </message>
    <message>
        <source>shank or holder would come into the stock wherever the cutter could cut</source>
        <translation>queue ou porte-outil entreraient dans le brut partout où la fraise pourrait usiner</translation>
    </message>
    <message>
        <source>shank or holder would come into what stands of the stock beside {1} of the passes, which are left out: flutes of {2} instead of {3}, or roughing closer, would reach it</source>
        <translation>queue ou porte-outil entreraient dans ce qui reste du brut à côté de {1} des passes, qui sont omises : une partie coupante de {2} au lieu de {3}, ou une ébauche plus proche, y arriverait</translation>
    </message>
    <message>
        <source>shank or holder would hit the stock</source>
        <translation>queue ou porte-outil heurteraient le brut</translation>
    </message>
    <message>
        <source>shank or holder would hit the stock: {1} of cuts are left out, the first at {2}: use a longer tool</source>
        <translation>queue ou porte-outil heurteraient le brut : {1} de coupes sont omis, la première à {2} : prendre un outil plus long</translation>
    </message>
    <message>
        <source>shape and lengths are not carried</source>
        <translation>forme et longueurs ne sont pas reprises</translation>
    </message>
    <message>
        <source>shorten it</source>
        <translation>le raccourcir</translation>
    </message>
    <message>
        <source>shorten the line of the post, or the names in it</source>
        <translation>raccourcir la ligne du post-processeur, ou les noms qu'elle contient</translation>
    </message>
    <message>
        <source>show one that does</source>
        <translation>en montrer un qui le fait</translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation>silhouette</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>pente</translation>
    </message>
    <message>
        <source>slot mill</source>
        <translation>fraise à rainurer</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>lisse</translation>
    </message>
    <message>
        <source>smooth: edges that bend by more are features and stay sharp.</source>
        <translation>lisse : les arêtes qui plient davantage sont marquantes et restent vives.</translation>
    </message>
    <message>
        <source>spindle speed</source>
        <translation>vitesse de broche</translation>
    </message>
    <message>
        <source>split the file: one program each</source>
        <translation>diviser le fichier : un programme chacun</translation>
    </message>
    <message>
        <source>spot drill</source>
        <translation>foret à pointer</translation>
    </message>
    <message>
        <source>start before the stop, and where the part is</source>
        <translation>commencer avant la fin, et où est la pièce</translation>
    </message>
    <message>
        <source>step</source>
        <translation>étape</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>étapes</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>brut</translation>
    </message>
    <message>
        <source>stock's mesh</source>
        <translation>maillage du brut</translation>
    </message>
    <message>
        <source>strip</source>
        <translation>bande</translation>
    </message>
    <message>
        <source>strips</source>
        <translation>bandes</translation>
    </message>
    <message>
        <source>strips around what operations before left</source>
        <translation>bandes autour de ce que les opérations précédentes ont laissé</translation>
    </message>
    <message>
        <source>switch it on (off: false)</source>
        <translation>l'activer (off: false)</translation>
    </message>
    <message>
        <source>switch one on, or leave the operation out</source>
        <translation>en activer une, ou omettre l'opération</translation>
    </message>
    <message>
        <source>switch that off</source>
        <translation>le désactiver</translation>
    </message>
    <message>
        <source>switch that off before it</source>
        <translation>le désactiver avant</translation>
    </message>
    <message>
        <source>switch that on before it</source>
        <translation>l'activer avant</translation>
    </message>
    <message>
        <source>switch the plane off before it</source>
        <translation>désactiver le plan avant</translation>
    </message>
    <message>
        <source>switch the plane off first</source>
        <translation>désactiver d'abord le plan</translation>
    </message>
    <message>
        <source>switched off · {1} · no tool yet</source>
        <translation>désactivée · {1} · encore sans outil</translation>
    </message>
    <message>
        <source>switched off · {1} · tool {2}</source>
        <translation>désactivée · {1} · outil {2}</translation>
    </message>
    <message>
        <source>tab</source>
        <translation>attache</translation>
    </message>
    <message>
        <source>take a larger tool, or leave the operation out</source>
        <translation>prendre un outil plus grand, ou laisser l’opération de côté</translation>
    </message>
    <message>
        <source>take a smaller tool, or allow it to plunge</source>
        <translation>prendre un outil plus petit, ou lui permettre de plonger</translation>
    </message>
    <message>
        <source>take a tool that has one, set the tilt limit to 0, or finish with five axes (finish5)</source>
        <translation>prendre un outil qui en a un, mettre la limite d’inclinaison à 0, ou finir à cinq axes (finish5)</translation>
    </message>
    <message>
        <source>take the winner, or one of the front</source>
        <translation>prendre le gagnant, ou l'un du front</translation>
    </message>
    <message>
        <source>taper {1}°</source>
        <translation>cône {1}°</translation>
    </message>
    <message>
        <source>tapered mill</source>
        <translation>fraise conique</translation>
    </message>
    <message>
        <source>the 3D model has no name</source>
        <translation>le modèle 3D n'a pas de nom</translation>
    </message>
    <message>
        <source>the 3D model is not in the file</source>
        <translation>le modèle 3D n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>the PNG picture cannot be read</source>
        <translation>l'image PNG est illisible</translation>
    </message>
    <message>
        <source>the XML declares a document type or entities</source>
        <translation>le XML déclare un type de document ou des entités</translation>
    </message>
    <message>
        <source>the XML is no 3MF model: it begins with {1}</source>
        <translation>le XML n'est pas un modèle 3MF : il commence par {1}</translation>
    </message>
    <message>
        <source>the allowance is negative or not a finite number</source>
        <translation>la surépaisseur est négative ou n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>the amount is not above 0</source>
        <translation>la quantité n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the angle of its point is not carried</source>
        <translation>l'angle de sa pointe n'est pas repris</translation>
    </message>
    <message>
        <source>the attribute {1} is missing</source>
        <translation>l'attribut {1} manque</translation>
    </message>
    <message>
        <source>the axes turn to a tilted plane, and there is none</source>
        <translation>les axes tournent vers un plan incliné, et il n'y en a pas</translation>
    </message>
    <message>
        <source>the axis {1} is missing</source>
        <translation>l'axe {1} manque</translation>
    </message>
    <message>
        <source>the ball's radius is not above 0</source>
        <translation>le rayon de la boule n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the block '{1}' is longer than {2} characters</source>
        <translation>le bloc '{1}' dépasse {2} caractères</translation>
    </message>
    <message>
        <source>the block has more than {1} characters</source>
        <translation>le bloc a plus de {1} caractères</translation>
    </message>
    <message>
        <source>the bottom angle is out of range</source>
        <translation>l'angle de fond est hors de la plage</translation>
    </message>
    <message>
        <source>the bottom angle {1} is out of range</source>
        <translation>l'angle de fond {1} est hors de la plage</translation>
    </message>
    <message>
        <source>the buffer has no data</source>
        <translation>le tampon n’a pas de données</translation>
    </message>
    <message>
        <source>the buffer has {1} bytes, not {2}</source>
        <translation>le tampon a {1} octets, et non {2}</translation>
    </message>
    <message>
        <source>the cells of a stock field are not above 0</source>
        <translation>les cellules d'un champ de brut ne sont pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the centre has no words</source>
        <translation>le centre n'a pas de mots</translation>
    </message>
    <message>
        <source>the centre of an arc has a part across its plane</source>
        <translation>le centre d'un arc a une part en travers de son plan</translation>
    </message>
    <message>
        <source>the centre or radius of an arc is given without one</source>
        <translation>le centre ou le rayon d'un arc est donné sans arc</translation>
    </message>
    <message>
        <source>the choice of a work coordinate system is not whole</source>
        <translation>le choix d'un système de coordonnées pièce n'est pas complet</translation>
    </message>
    <message>
        <source>the chord tolerance is not a length above 0</source>
        <translation>la tolérance de corde n'est pas une longueur au-dessus de 0</translation>
    </message>
    <message>
        <source>the chord tolerance is so small that the mesh would have more than {1} million facets</source>
        <translation>la tolérance de corde est si petite que le maillage aurait plus de {1} millions de facettes</translation>
    </message>
    <message>
        <source>the coarse grid has too few lines</source>
        <translation>la grille grossière a trop peu de lignes</translation>
    </message>
    <message>
        <source>the control cannot change tools, and the program has several</source>
        <translation>la commande ne peut changer d'outil, et le programme en a plusieurs</translation>
    </message>
    <message>
        <source>the control chooses how to hold the tilted plane</source>
        <translation>la commande choisit comment tenir le plan incliné</translation>
    </message>
    <message>
        <source>the control has no word for the axis {1}</source>
        <translation>la commande n'a pas de mot pour l'axe {1}</translation>
    </message>
    <message>
        <source>the control has no work coordinate system '{1}'</source>
        <translation>la commande n'a pas de système de coordonnées pièce '{1}'</translation>
    </message>
    <message>
        <source>the control would not read it</source>
        <translation>la commande ne le lirait pas</translation>
    </message>
    <message>
        <source>the control's, its zero in {1}</source>
        <translation>celles de la commande, leur origine dans {1}</translation>
    </message>
    <message>
        <source>the coordinate {1} is beyond {2}</source>
        <translation>la coordonnée {1} est au-delà de {2}</translation>
    </message>
    <message>
        <source>the coordinate {1} is too large</source>
        <translation>la coordonnée {1} est trop grande</translation>
    </message>
    <message>
        <source>the core radius keeps the cutter from the part</source>
        <translation>le rayon du noyau écarte la fraise de la pièce</translation>
    </message>
    <message>
        <source>the corner circle of radius {1} about ({2}, {3}) does not round the corner between bottom and side to a convex cutter</source>
        <translation>le cercle de coin de rayon {1} autour de ({2}, {3}) n'arrondit pas le coin entre fond et côté en une fraise convexe</translation>
    </message>
    <message>
        <source>the corner radius {1} does not fit the diameter {2}</source>
        <translation>le rayon de coin {1} ne va pas avec le diamètre {2}</translation>
    </message>
    <message>
        <source>the corner radius {1} is negative</source>
        <translation>le rayon de coin {1} est négatif</translation>
    </message>
    <message>
        <source>the count of a list must be an integer</source>
        <translation>le compte d'une liste doit être entier</translation>
    </message>
    <message>
        <source>the cutter goes {1} below the bottom of the stock, as 'Below the bottom' allows</source>
        <translation>la fraise va {1} sous le fond du brut, comme 'Sous le fond' le permet</translation>
    </message>
    <message>
        <source>the cutter has no place along {1} of its passes: they are left out there</source>
        <translation>la fraise n'a pas de place le long de {1} de ses passes : elles y sont omises</translation>
    </message>
    <message>
        <source>the cutter has room there, and the holder would hit the part by every axis; use a longer tool or a smaller holder</source>
        <translation>la fraise y a de la place, mais le porte-outil heurterait la pièce quel que soit l'axe ; prendre un outil plus long ou un porte-outil plus petit</translation>
    </message>
    <message>
        <source>the cutter has room there, and the shank would hit the part by every axis; use a longer or thinner tool</source>
        <translation>la fraise y a de la place, mais la queue heurterait la pièce quel que soit l'axe ; prendre un outil plus long ou plus mince</translation>
    </message>
    <message>
        <source>the cutter is too large for hollows of the part</source>
        <translation>la fraise est trop grande pour des creux de la pièce</translation>
    </message>
    <message>
        <source>the cutter is too large for hollows of the part: {1} stays uncut by up to {2}, most at {3}: use a smaller tool there</source>
        <translation>la fraise est trop grande pour des creux de la pièce : {1} restent non usinés de {2} au plus, le plus à {3} : y prendre un outil plus petit</translation>
    </message>
    <message>
        <source>the cutter is too large for the innermost of the strips: up to {1} stays, most at {2}: use a smaller tool there</source>
        <translation>la fraise est trop grande pour le fond des bandes : jusqu'à {1} reste, le plus à {2} : y prendre un outil plus petit</translation>
    </message>
    <message>
        <source>the cutter leaves more than the tolerance: use a smaller step-over or tool</source>
        <translation>la fraise laisse plus que la tolérance : prendre un pas latéral ou un outil plus petit</translation>
    </message>
    <message>
        <source>the cutter touches no two flanks of a valley that it leaves</source>
        <translation>la fraise ne touche nulle part deux flancs d’un creux où elle laisse de la matière</translation>
    </message>
    <message>
        <source>the cutter touches the part nowhere at two places between which it leaves more than the tolerance</source>
        <translation>la fraise ne touche nulle part la pièce en deux endroits entre lesquels elle laisse plus que la tolérance</translation>
    </message>
    <message>
        <source>the cutter would cut into the part</source>
        <translation>la fraise couperait dans la pièce</translation>
    </message>
    <message>
        <source>the cutter's radius {1} is too small</source>
        <translation>le rayon de la fraise {1} est trop petit</translation>
    </message>
    <message>
        <source>the cutter{1} fits, but its shank or holder would touch the part</source>
        <translation>la fraise{1} y passe, mais sa queue ou son porte-outil toucheraient la pièce</translation>
    </message>
    <message>
        <source>the data is no base64</source>
        <translation>les données ne sont pas du base64</translation>
    </message>
    <message>
        <source>the data lies in another file, '{1}'</source>
        <translation>les données sont dans un autre fichier, « {1} »</translation>
    </message>
    <message>
        <source>the depth of cut asks for more than {1} passes</source>
        <translation>la profondeur de passe demande plus de {1} passes</translation>
    </message>
    <message>
        <source>the depth of cut asks for too many passes</source>
        <translation>la profondeur de coupe demande trop de passes</translation>
    </message>
    <message>
        <source>the depth of cut of {1} is more than the {2} that stand above the part: one pass takes all</source>
        <translation>la profondeur de passe de {1} dépasse les {2} qui restent sur la pièce : une passe prend tout</translation>
    </message>
    <message>
        <source>the depth of the layers is not above 0</source>
        <translation>la profondeur des niveaux n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the diameter is not above 0</source>
        <translation>le diamètre n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the diameter of what holds the part is 0</source>
        <translation>le diamètre de ce qui tient la pièce est 0</translation>
    </message>
    <message>
        <source>the diameter {1} is not above 0</source>
        <translation>le diamètre {1} n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the diameter {1} is too large</source>
        <translation>le diamètre {1} est trop grand</translation>
    </message>
    <message>
        <source>the direction has no length</source>
        <translation>la direction n'a pas de longueur</translation>
    </message>
    <message>
        <source>the element '{1}' occurs twice</source>
        <translation>l'élément '{1}' apparaît deux fois</translation>
    </message>
    <message>
        <source>the element has too many properties</source>
        <translation>l'élément a trop de propriétés</translation>
    </message>
    <message>
        <source>the face names vertex {1}, the file has {2} (from 0)</source>
        <translation>la face nomme le sommet {1}, le fichier en a {2} (depuis 0)</translation>
    </message>
    <message>
        <source>the faces have no list vertex_indices of integers</source>
        <translation>les faces n'ont pas de liste vertex_indices d'entiers</translation>
    </message>
    <message>
        <source>the facet has more than three corners</source>
        <translation>la facette a plus de trois sommets</translation>
    </message>
    <message>
        <source>the facet names vertex {1}, the file has {2}</source>
        <translation>la facette nomme le sommet {1}, le fichier en a {2}</translation>
    </message>
    <message>
        <source>the facet names vertex {1}, {2} are known so far</source>
        <translation>la facette nomme le sommet {1}, {2} sont connus jusqu'ici</translation>
    </message>
    <message>
        <source>the facets cannot be written: {1}</source>
        <translation>les facettes ne peuvent être écrites : {1}</translation>
    </message>
    <message>
        <source>the feed is not above 0</source>
        <translation>l'avance n'est pas supérieure à 0</translation>
    </message>
    <message>
        <source>the feed {1} is out of range</source>
        <translation>l'avance {1} est hors limites</translation>
    </message>
    <message>
        <source>the file ends here</source>
        <translation>le fichier finit ici</translation>
    </message>
    <message>
        <source>the file ends in its header</source>
        <translation>le fichier se termine dans son en-tête</translation>
    </message>
    <message>
        <source>the file ends in these elements</source>
        <translation>le fichier finit dans ces éléments</translation>
    </message>
    <message>
        <source>the file ends inside a facet</source>
        <translation>le fichier finit dans une facette</translation>
    </message>
    <message>
        <source>the file ends inside a list of {1}</source>
        <translation>le fichier finit dans une liste de {1}</translation>
    </message>
    <message>
        <source>the file ends inside a number</source>
        <translation>le fichier finit dans un nombre</translation>
    </message>
    <message>
        <source>the file ends inside the header</source>
        <translation>le fichier finit dans l'en-tête</translation>
    </message>
    <message>
        <source>the file ends inside the word facet</source>
        <translation>le fichier finit dans le mot facet</translation>
    </message>
    <message>
        <source>the file ends too early</source>
        <translation>le fichier finit trop tôt</translation>
    </message>
    <message>
        <source>the file ends within a line, without FINI or END</source>
        <translation>le fichier se termine dans une ligne, sans FINI ni END</translation>
    </message>
    <message>
        <source>the file ends within a statement</source>
        <translation>le fichier se termine dans une instruction</translation>
    </message>
    <message>
        <source>the file ends within a value</source>
        <translation>le fichier finit dans une valeur</translation>
    </message>
    <message>
        <source>the file ends within its data</source>
        <translation>le fichier se termine au milieu de ses données</translation>
    </message>
    <message>
        <source>the file has more than 4 thousand million elements</source>
        <translation>le fichier a plus de 4 milliards d'éléments</translation>
    </message>
    <message>
        <source>the file has more than 4 thousand million vertices</source>
        <translation>le fichier a plus de 4 milliards de sommets</translation>
    </message>
    <message>
        <source>the file has version {1}, this program reads up to {2}</source>
        <translation>le fichier a la version {1}, ce programme lit jusqu'à {2}</translation>
    </message>
    <message>
        <source>the file has {1} bytes, a binary STL file at least 84</source>
        <translation>le fichier a {1} octets, un fichier STL binaire au moins 84</translation>
    </message>
    <message>
        <source>the file has {1} bytes, and should have more</source>
        <translation>le fichier a {1} octets et devrait en avoir plus</translation>
    </message>
    <message>
        <source>the file holds no face</source>
        <translation>le fichier ne contient aucune face</translation>
    </message>
    <message>
        <source>the file holds no facet</source>
        <translation>le fichier ne contient aucune facette</translation>
    </message>
    <message>
        <source>the file holds no mesh</source>
        <translation>le fichier ne contient pas de maillage</translation>
    </message>
    <message>
        <source>the file holds no triangles</source>
        <translation>le fichier ne contient pas de triangles</translation>
    </message>
    <message>
        <source>the file holds no vertices</source>
        <translation>le fichier ne contient aucun sommet</translation>
    </message>
    <message>
        <source>the file holds points but no face</source>
        <translation>le fichier contient des points mais aucune face</translation>
    </message>
    <message>
        <source>the file is damaged or in another unit</source>
        <translation>le fichier est abîmé ou dans une autre unité</translation>
    </message>
    <message>
        <source>the file is damaged or is not STL: export it again</source>
        <translation>le fichier est abîmé ou n'est pas STL : l'exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is damaged or of another kind: export it again</source>
        <translation>le fichier est abîmé ou d'un autre type : l'exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is damaged: export it again</source>
        <translation>le fichier est abîmé : l'exporter de nouveau</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the file is for a newer Facetmill</source>
        <translation>le fichier est pour un Facetmill plus récent</translation>
    </message>
    <message>
        <source>the file is not UTF-8 text (UTF-16 or binary)</source>
        <translation>le fichier n'est pas un texte UTF-8 (UTF-16 ou binaire)</translation>
    </message>
    <message>
        <source>the file is not plain text (UTF-16 or binary)</source>
        <translation>le fichier n'est pas du texte simple (UTF-16 ou binaire)</translation>
    </message>
    <message>
        <source>the file is too large for a project or a machine</source>
        <translation>le fichier est trop grand pour un projet ou une machine</translation>
    </message>
    <message>
        <source>the file was cut: copy or export it again</source>
        <translation>le fichier a été coupé : le copier ou l'exporter de nouveau</translation>
    </message>
    <message>
        <source>the first must be below the second</source>
        <translation>la première doit être sous la seconde</translation>
    </message>
    <message>
        <source>the fixture {1}</source>
        <translation>le bridage {1}</translation>
    </message>
    <message>
        <source>the fixtures {1}</source>
        <translation>les bridages {1}</translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation>le dossier ne peut pas être créé</translation>
    </message>
    <message>
        <source>the folder cannot be made: {1}</source>
        <translation>le dossier ne peut être créé : {1}</translation>
    </message>
    <message>
        <source>the format is not known</source>
        <translation>le format n'est pas connu</translation>
    </message>
    <message>
        <source>the free postures are too far from those of the neighbours: allow a larger turn limit</source>
        <translation>les postures libres sont trop loin de celles des voisins : permettre une limite de rotation plus grande</translation>
    </message>
    <message>
        <source>the gouge limit is {1}, and a cutter has a radius of {2}: allow at most {3}</source>
        <translation>la limite d'entaille est {1}, et une fraise a un rayon de {2} : permettre au plus {3}</translation>
    </message>
    <message>
        <source>the half angle {1} is out of range</source>
        <translation>le demi-angle {1} est hors de la plage</translation>
    </message>
    <message>
        <source>the header</source>
        <translation>l'en-tête</translation>
    </message>
    <message>
        <source>the header announces {1} facets, the file has bytes for {2}</source>
        <translation>l'en-tête annonce {1} facettes, le fichier a des octets pour {2}</translation>
    </message>
    <message>
        <source>the header announces {1} of '{2}', more than the file has bytes for</source>
        <translation>l'en-tête annonce {1} de '{2}', plus que le fichier n'a d'octets</translation>
    </message>
    <message>
        <source>the header names no format</source>
        <translation>l'en-tête ne nomme pas de format</translation>
    </message>
    <message>
        <source>the header names too many elements</source>
        <translation>l'en-tête nomme trop d'éléments</translation>
    </message>
    <message>
        <source>the height {1} is not above 0</source>
        <translation>la hauteur {1} n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the holder</source>
        <translation>le porte-outil</translation>
    </message>
    <message>
        <source>the holder of {1} cannot hold a shank of {2}</source>
        <translation>le porte-outil de {1} ne peut tenir une queue de {2}</translation>
    </message>
    <message>
        <source>the holder would hit the part</source>
        <translation>le porte-outil heurterait la pièce</translation>
    </message>
    <message>
        <source>the holder would hit the part: use a longer tool or a smaller holder</source>
        <translation>le porte-outil heurterait la pièce : prendre un outil plus long ou un porte-outil plus petit</translation>
    </message>
    <message>
        <source>the host cannot be reached without a password</source>
        <translation>l’hôte ne peut être atteint sans mot de passe</translation>
    </message>
    <message>
        <source>the job writes it twice</source>
        <translation>le travail l'écrit deux fois</translation>
    </message>
    <message>
        <source>the key is missing</source>
        <translation>la clé manque</translation>
    </message>
    <message>
        <source>the key occurs twice</source>
        <translation>la clé apparaît deux fois</translation>
    </message>
    <message>
        <source>the last triangle has no three corners</source>
        <translation>le dernier triangle n’a pas trois sommets</translation>
    </message>
    <message>
        <source>the lead limit is raised to {1}: that takes about {2}, {3} and rework of {4} {5}</source>
        <translation>la limite d'attaque est relevée à {1} : cela prend environ {2}, {3} et la reprise de {4} {5}</translation>
    </message>
    <message>
        <source>the lead limit {1} is above that of the assumed path, {2}</source>
        <translation>la limite d'attaque {1} dépasse celle du parcours supposé, {2}</translation>
    </message>
    <message>
        <source>the leaning cutter is kept from going below the bottom of the stock, by up to {1} at {2} of the points: some material stays there unless 'Below the bottom' allows it</source>
        <translation>la fraise inclinée est retenue d'aller sous le fond du brut, de {1} au plus sur {2} des points : il y reste un peu de matière, sauf si 'Sous le fond' le permet</translation>
    </message>
    <message>
        <source>the length of a tool is called by an edge or by a number, not by both</source>
        <translation>la longueur d'un outil est appelée par une arête ou par un numéro, pas par les deux</translation>
    </message>
    <message>
        <source>the length of the tool is negative or no number</source>
        <translation>la longueur de l'outil est négative ou n'est pas un nombre</translation>
    </message>
    <message>
        <source>the length of tool {1} is called, and another one is in the spindle</source>
        <translation>la longueur de l'outil {1} est appelée, et un autre est dans la broche</translation>
    </message>
    <message>
        <source>the levels leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller step-down, or wider slope limits</source>
        <translation>les niveaux laissent plus que prévu : {1} restent non usinés de {2} au plus, le plus en {3} : choisir une plus petite descente, ou des limites de pente plus larges</translation>
    </message>
    <message>
        <source>the limits {1} and {2} leave no travel</source>
        <translation>les limites {1} et {2} ne laissent pas de course</translation>
    </message>
    <message>
        <source>the limits {1} are reversed or equal</source>
        <translation>les limites {1} sont inversées ou égales</translation>
    </message>
    <message>
        <source>the line '{1}': {2}</source>
        <translation>la ligne '{1}' : {2}</translation>
    </message>
    <message>
        <source>the line END-ISO-10303-21; of a STEP file</source>
        <translation>la ligne END-ISO-10303-21; d'un fichier STEP</translation>
    </message>
    <message>
        <source>the line is too long</source>
        <translation>la ligne est trop longue</translation>
    </message>
    <message>
        <source>the line occurs twice, or has other words than {wcs}</source>
        <translation>la ligne apparaît deux fois, ou a d'autres mots que {wcs}</translation>
    </message>
    <message>
        <source>the list has {1} values</source>
        <translation>la liste a {1} valeurs</translation>
    </message>
    <message>
        <source>the list length</source>
        <translation>la longueur de la liste</translation>
    </message>
    <message>
        <source>the machine cannot hold this place</source>
        <translation>la machine ne peut pas tenir cet endroit</translation>
    </message>
    <message>
        <source>the machine has no axis {1}</source>
        <translation>la machine n'a pas d'axe {1}</translation>
    </message>
    <message>
        <source>the machine's axes do not reach, or the tool would lie down</source>
        <translation>les axes de la machine n'y arrivent pas, ou l'outil serait couché</translation>
    </message>
    <message>
        <source>the machine's axes do not reach: turn the part or take another machine</source>
        <translation>les axes de la machine n'y arrivent pas : tourner la pièce ou prendre une autre machine</translation>
    </message>
    <message>
        <source>the mesh does not fit into memory</source>
        <translation>le maillage ne tient pas en mémoire</translation>
    </message>
    <message>
        <source>the mesh has {1} facets</source>
        <translation>le maillage a {1} facettes</translation>
    </message>
    <message>
        <source>the mesh has {1} facets, more than {2}</source>
        <translation>le maillage a {1} facettes, plus de {2}</translation>
    </message>
    <message>
        <source>the mesh is not closed: a line enters it and does not leave</source>
        <translation>le maillage n'est pas fermé : une droite y entre et n'en sort pas</translation>
    </message>
    <message>
        <source>the mesh to write has no facet</source>
        <translation>le maillage à écrire n'a aucune facette</translation>
    </message>
    <message>
        <source>the middle of its bottom at {1}</source>
        <translation>le milieu de son fond en {1}</translation>
    </message>
    <message>
        <source>the model '{1}' is not in the file</source>
        <translation>le modèle '{1}' n'est pas dans le fichier</translation>
    </message>
    <message>
        <source>the model cannot be read without the extension '{1}'</source>
        <translation>le modèle est illisible sans l'extension '{1}'</translation>
    </message>
    <message>
        <source>the model's files have different units</source>
        <translation>les fichiers du modèle ont des unités différentes</translation>
    </message>
    <message>
        <source>the model's unit is '{1}'</source>
        <translation>l'unité du modèle est '{1}'</translation>
    </message>
    <message>
        <source>the name '{1}' occurs twice</source>
        <translation>le nom '{1}' apparaît deux fois</translation>
    </message>
    <message>
        <source>the name is empty</source>
        <translation>le nom est vide</translation>
    </message>
    <message>
        <source>the name occurs twice</source>
        <translation>le nom apparaît deux fois</translation>
    </message>
    <message>
        <source>the node's place leaves nothing of an object</source>
        <translation>la position du nœud ne laisse rien d’un objet</translation>
    </message>
    <message>
        <source>the number is not from {1} to {2}</source>
        <translation>le nombre n'est pas de {1} à {2}</translation>
    </message>
    <message>
        <source>the number is too large</source>
        <translation>le nombre est trop grand</translation>
    </message>
    <message>
        <source>the number {1} is too large</source>
        <translation>le nombre {1} est trop grand</translation>
    </message>
    <message>
        <source>the numbers from {1} to {2}</source>
        <translation>les nombres de {1} à {2}</translation>
    </message>
    <message>
        <source>the object has too many keys</source>
        <translation>l'objet a trop de clés</translation>
    </message>
    <message>
        <source>the object {1} occurs twice</source>
        <translation>l'objet {1} apparaît deux fois</translation>
    </message>
    <message>
        <source>the object's mesh is a coarse stand-in for its slices</source>
        <translation>le maillage de l'objet est un substitut grossier de ses couches</translation>
    </message>
    <message>
        <source>the offset of {1} is larger than the part, which is {2} by {3}</source>
        <translation>le décalage de {1} est plus grand que la pièce, de {2} sur {3}</translation>
    </message>
    <message>
        <source>the one that begins at ({1}, {2}, {3}) mm would take more than {4} points of passes</source>
        <translation>celle qui commence à ({1}, {2}, {3}) mm demanderait plus de {4} points de passes</translation>
    </message>
    <message>
        <source>the operation has no preview of layers</source>
        <translation>l'opération n'a pas d'aperçu des niveaux</translation>
    </message>
    <message>
        <source>the operation has no rework regions</source>
        <translation>l'opération n'a pas de zones de reprise</translation>
    </message>
    <message>
        <source>the operation tilts the tool as it goes and keeps no axis</source>
        <translation>l'opération incline l'outil en chemin et ne garde pas d'axe</translation>
    </message>
    <message>
        <source>the operations before leave nothing of it</source>
        <translation>les opérations précédentes n'en laissent rien</translation>
    </message>
    <message>
        <source>the operations before leave {1}</source>
        <translation>les opérations précédentes laissent {1}</translation>
    </message>
    <message>
        <source>the part</source>
        <translation>la pièce</translation>
    </message>
    <message>
        <source>the part asks for more than {1} places of this tool on a layer</source>
        <translation>la pièce demande plus de {1} places de cet outil sur un niveau</translation>
    </message>
    <message>
        <source>the part close to the contact point stands in the cutter's way: use a smaller tool there</source>
        <translation>la pièce près du point de contact gêne la fraise : y prendre un outil plus petit</translation>
    </message>
    <message>
        <source>the part elsewhere stands in the cutter's way: use a smaller or longer tool there, or wider limits</source>
        <translation>la pièce ailleurs gêne la fraise : y prendre un outil plus petit ou plus long, ou des limites plus larges</translation>
    </message>
    <message>
        <source>the part has no extent along the turning axis</source>
        <translation>la pièce n’a pas d’étendue le long de l’axe de rotation</translation>
    </message>
    <message>
        <source>the part has no extent seen along the tool axis</source>
        <translation>la pièce n’a pas d’étendue vue le long de l’axe de l’outil</translation>
    </message>
    <message>
        <source>the part has no facets</source>
        <translation>la pièce n'a pas de facettes</translation>
    </message>
    <message>
        <source>the part has {1} facets: passes are previewed up to {2}</source>
        <translation>la pièce a {1} facettes : il y a un aperçu jusqu’à {2}</translation>
    </message>
    <message>
        <source>the part is in the cutter's way by every axis; use a smaller or longer tool, or turn the part</source>
        <translation>la pièce gêne la fraise quel que soit l'axe ; prendre un outil plus petit ou plus long, ou tourner la pièce</translation>
    </message>
    <message>
        <source>the part is larger along {1}</source>
        <translation>la pièce est plus grande selon {1}</translation>
    </message>
    <message>
        <source>the part is not there</source>
        <translation>la pièce n'est pas là</translation>
    </message>
    <message>
        <source>the part reaches {1} above the stock</source>
        <translation>la pièce dépasse le brut de {1}</translation>
    </message>
    <message>
        <source>the part to place has no size</source>
        <translation>la pièce à placer n'a pas de taille</translation>
    </message>
    <message>
        <source>the part's middle lies {1} off the turning axis: it turns unbalanced, and its stock needs a diameter of {2} about the axis</source>
        <translation>le milieu de la pièce est à {1} de l'axe de rotation : elle tourne déséquilibrée, et son brut demande un diamètre de {2} autour de l'axe</translation>
    </message>
    <message>
        <source>the part's origin</source>
        <translation>l'origine de la pièce</translation>
    </message>
    <message>
        <source>the part's {1}, {2}, {3}</source>
        <translation>pièce, {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the passes end where the cutter would go below the bottom of the stock, by up to {1}: {2} of the points are left out unless 'Below the bottom' allows them</source>
        <translation>les passes finissent où la fraise irait sous le fond du brut, de {1} au plus : {2} des points sont omis, sauf si 'Sous le fond' les permet</translation>
    </message>
    <message>
        <source>the passes leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller step-over or another direction</source>
        <translation>les passes laissent plus que prévu : {1} restent non usinés de {2} au plus, le plus à {3} : choisir un pas latéral plus petit ou une autre direction</translation>
    </message>
    <message>
        <source>the passes leave more than expected: {1} stays uncut by up to {2}, most at {3}: choose a smaller tolerance or step-over</source>
        <translation>les passes laissent plus que prévu : {1} restent non usinés de {2} au plus, le plus à {3} : choisir une tolérance ou un pas latéral plus petits</translation>
    </message>
    <message>
        <source>the passes{1} lie too far apart there</source>
        <translation>les passes{1} y sont trop écartées</translation>
    </message>
    <message>
        <source>the path asks for more than {1} places of this tool</source>
        <translation>le parcours demande plus de {1} places de cet outil</translation>
    </message>
    <message>
        <source>the path of a turning part knows no axis</source>
        <translation>le parcours d'une pièce tournante ne connaît pas d'axe</translation>
    </message>
    <message>
        <source>the path would run from {1} to {2} along the axis</source>
        <translation>le parcours irait de {1} à {2} le long de l'axe</translation>
    </message>
    <message>
        <source>the picture could not be encoded</source>
        <translation>l'image n'a pu être codée</translation>
    </message>
    <message>
        <source>the picture ends before its last row</source>
        <translation>l'image finit avant sa dernière ligne</translation>
    </message>
    <message>
        <source>the picture has {1}</source>
        <translation>l'image a {1}</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel</source>
        <translation>l'image a {1} bits par pixel</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, as floats</source>
        <translation>l'image a {1} bits par pixel, en flottants</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, which are no plain numbers</source>
        <translation>l’image a {1} bits par pixel, qui ne sont pas de simples nombres</translation>
    </message>
    <message>
        <source>the picture has {1} bits a pixel, with a sign</source>
        <translation>l’image a {1} bits par pixel, avec signe</translation>
    </message>
    <message>
        <source>the picture has {1}, more than 100 million in all or 100 000 a side</source>
        <translation>l'image a {1}, plus de 100 millions en tout ou 100 000 par côté</translation>
    </message>
    <message>
        <source>the picture is interlaced and has {1} × {2} pixels</source>
        <translation>l'image est entrelacée et a {1} × {2} pixels</translation>
    </message>
    <message>
        <source>the picture is not plain grey and has {1} × {2} pixels</source>
        <translation>l’image n’est pas en simple gris et a {1} × {2} pixels</translation>
    </message>
    <message>
        <source>the picture's colours cannot be read: {1}</source>
        <translation>les couleurs de l’image ne peuvent être lues : {1}</translation>
    </message>
    <message>
        <source>the picture's tiles of {1} × {2} pixels are too large</source>
        <translation>les tuiles de l'image de {1} × {2} pixels sont trop grandes</translation>
    </message>
    <message>
        <source>the place of the part is no number</source>
        <translation>la place de la pièce n'est pas un nombre</translation>
    </message>
    <message>
        <source>the point {1}, {2}, {3}</source>
        <translation>le point {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the position {1} is not a finite number</source>
        <translation>le point {1} n’est pas un nombre fini</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not free and not used: {2}</source>
        <translation>la posture gardée pour {1} n'est pas libre et n'est pas utilisée : {2}</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not used: another one is kept for the same contact point</source>
        <translation>la posture gardée pour {1} n'est pas utilisée : une autre est gardée pour le même point de contact</translation>
    </message>
    <message>
        <source>the posture kept for {1} is not used: no pass comes there</source>
        <translation>la posture gardée pour {1} n'est pas utilisée : aucune passe n'y vient</translation>
    </message>
    <message>
        <source>the preview found nothing to cut</source>
        <translation>l’aperçu n’a rien trouvé à usiner</translation>
    </message>
    <message>
        <source>the previous tool is not in the list</source>
        <translation>l’outil précédent n’est pas dans la liste</translation>
    </message>
    <message>
        <source>the previous tool leaves nothing above the tolerance</source>
        <translation>l’outil précédent ne laisse rien au-dessus de la tolérance</translation>
    </message>
    <message>
        <source>the profile has too many pieces</source>
        <translation>le profil a trop de morceaux</translation>
    </message>
    <message>
        <source>the program has no end</source>
        <translation>le programme n'a pas de fin</translation>
    </message>
    <message>
        <source>the program has no motion</source>
        <translation>le programme n'a aucun mouvement</translation>
    </message>
    <message>
        <source>the program number {1} is not from 1 to {2}</source>
        <translation>le numéro de programme {1} n'est pas de 1 à {2}</translation>
    </message>
    <message>
        <source>the program that reads such files, {1}, is not here</source>
        <translation>le programme qui lit ces fichiers, {1}, n'est pas là</translation>
    </message>
    <message>
        <source>the program that works on studies, facetmill-cli, is not here</source>
        <translation>le programme qui travaille aux études, facetmill-cli, n'est pas là</translation>
    </message>
    <message>
        <source>the program that wrote it is wrong: export the part by another one</source>
        <translation>le programme qui l’a écrit est fautif : exporter la pièce avec un autre</translation>
    </message>
    <message>
        <source>the project as it stands</source>
        <translation>le projet tel quel</translation>
    </message>
    <message>
        <source>the project has no operations</source>
        <translation>le projet n'a pas d'opérations</translation>
    </message>
    <message>
        <source>the project has no setup</source>
        <translation>le projet n'a pas de posage</translation>
    </message>
    <message>
        <source>the project has no tool {1}</source>
        <translation>le projet n'a pas d'outil {1}</translation>
    </message>
    <message>
        <source>the project has no tools</source>
        <translation>le projet n’a pas d’outils</translation>
    </message>
    <message>
        <source>the project has no tools: add one</source>
        <translation>le projet n'a pas d'outils : en ajouter un</translation>
    </message>
    <message>
        <source>the project has several setups</source>
        <translation>le projet a plusieurs posages</translation>
    </message>
    <message>
        <source>the radius at height {1} is too large</source>
        <translation>le rayon à la hauteur {1} est trop grand</translation>
    </message>
    <message>
        <source>the radius has no word</source>
        <translation>le rayon n'a pas de mot</translation>
    </message>
    <message>
        <source>the record has {1} values</source>
        <translation>l'enregistrement a {1} valeurs</translation>
    </message>
    <message>
        <source>the rework tool is not known</source>
        <translation>l'outil de reprise n'est pas connu</translation>
    </message>
    <message>
        <source>the rotary axes are parallel: together they turn no further than one of them</source>
        <translation>les axes rotatifs sont parallèles : ensemble ils ne tournent pas plus que l'un d'eux</translation>
    </message>
    <message>
        <source>the rotary axes do not stand where the tilted plane is held</source>
        <translation>les axes rotatifs ne sont pas où le plan incliné est tenu</translation>
    </message>
    <message>
        <source>the same as {1}</source>
        <translation>le même que {1}</translation>
    </message>
    <message>
        <source>the scan would have to move by {1} to fit</source>
        <translation>le scan devrait bouger de {1} pour convenir</translation>
    </message>
    <message>
        <source>the section T of an IGES file</source>
        <translation>la section T d'un fichier IGES</translation>
    </message>
    <message>
        <source>the sections do not stand at equal distances</source>
        <translation>les sections ne sont pas à distances égales</translation>
    </message>
    <message>
        <source>the setup's name '{1}' occurs twice</source>
        <translation>le nom de posage '{1}' apparaît deux fois</translation>
    </message>
    <message>
        <source>the shank is not carried</source>
        <translation>la queue n'est pas reprise</translation>
    </message>
    <message>
        <source>the shank would hit the part</source>
        <translation>la queue heurterait la pièce</translation>
    </message>
    <message>
        <source>the shank would hit the part: use a longer or thinner tool</source>
        <translation>la queue heurterait la pièce : prendre un outil plus long ou plus mince</translation>
    </message>
    <message>
        <source>the shape has no ':'</source>
        <translation>il manque ':' à la forme</translation>
    </message>
    <message>
        <source>the shape needs {1} number</source>
        <translation>la forme demande {1} nombre</translation>
    </message>
    <message>
        <source>the shape needs {1} numbers</source>
        <translation>la forme demande {1} nombres</translation>
    </message>
    <message>
        <source>the side feed asks for more than {1} turns</source>
        <translation>l'avance latérale demande plus de {1} tours</translation>
    </message>
    <message>
        <source>the side feed of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>l'avance latérale de {1} laisse des crêtes de {2} ; la tolérance permet {3}</translation>
    </message>
    <message>
        <source>the side feed of {1} leaves places uncut; the tolerance allows {2}</source>
        <translation>l'avance latérale de {1} laisse des endroits non usinés ; la tolérance permet {2}</translation>
    </message>
    <message>
        <source>the spindle speed is not above 0</source>
        <translation>la vitesse de broche n'est pas supérieure à 0</translation>
    </message>
    <message>
        <source>the spindle speed is out of range</source>
        <translation>la vitesse de broche est hors limites</translation>
    </message>
    <message>
        <source>the statement has too many values</source>
        <translation>l'instruction a trop de valeurs</translation>
    </message>
    <message>
        <source>the step says no limit for pieces</source>
        <translation>l'étape ne dit pas de limite pour les morceaux</translation>
    </message>
    <message>
        <source>the step {1} leaves no facet</source>
        <translation>l'étape {1} ne laisse aucune facette</translation>
    </message>
    <message>
        <source>the step-down of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>la descente de {1} laisse des crêtes de {2} ; la tolérance en permet {3}</translation>
    </message>
    <message>
        <source>the step-over of {1} leaves cusps of {2}; the tolerance allows {3}</source>
        <translation>le pas latéral de {1} laisse des crêtes de {2} ; la tolérance permet {3}</translation>
    </message>
    <message>
        <source>the step-over of {1} leaves places uncut; the tolerance allows {2}</source>
        <translation>le pas latéral de {1} laisse des endroits non usinés ; la tolérance permet {2}</translation>
    </message>
    <message>
        <source>the stock does not hold the part as it turns: it reaches {1} from the axis, the part {2}: take a stock of at least {3} in diameter</source>
        <translation>le brut ne contient pas la pièce qui tourne : il va à {1} de l'axe, la pièce à {2} : prendre un brut d'au moins {3} de diamètre</translation>
    </message>
    <message>
        <source>the stock does not reach there</source>
        <translation>le brut n'y va pas</translation>
    </message>
    <message>
        <source>the stock ends at z = {1}, the part begins at z = {2}</source>
        <translation>le brut finit à z = {1}, la pièce commence à z = {2}</translation>
    </message>
    <message>
        <source>the stock ends {1} above the part: the allowance of {2} cannot stay everywhere</source>
        <translation>le brut finit {1} au-dessus de la pièce : la surépaisseur de {2} ne peut rester partout</translation>
    </message>
    <message>
        <source>the stock has more than {1} GB of rays in {2}</source>
        <translation>le brut a plus de {1} Go de rayons dans {2}</translation>
    </message>
    <message>
        <source>the stock is not there</source>
        <translation>le brut n'est pas là</translation>
    </message>
    <message>
        <source>the stock's {1}, {2}, {3}</source>
        <translation>brut, {1}, {2}, {3}</translation>
    </message>
    <message>
        <source>the surface offset by vertices lets the cutter up to {1} (upright) into the allowance of {2}, most at {3}: use offset contact</source>
        <translation>la surface décalée par sommets laisse la fraise entrer jusqu'à {1} (vertical) dans la surépaisseur de {2}, le plus à {3} : utiliser le décalage au contact</translation>
    </message>
    <message>
        <source>the surface's arrays do not fit each other</source>
        <translation>les tableaux de la surface ne vont pas ensemble</translation>
    </message>
    <message>
        <source>the surfaces of the file lie at most {1} outside and {2} inside the facets that were planned on</source>
        <translation>les surfaces du fichier sont au plus à {1} au-dehors et {2} au-dedans des facettes sur lesquelles on a planifié</translation>
    </message>
    <message>
        <source>the tab {1}</source>
        <translation>l'attache {1}</translation>
    </message>
    <message>
        <source>the table below the stock</source>
        <translation>la table sous le brut</translation>
    </message>
    <message>
        <source>the tabs {1}</source>
        <translation>les attaches {1}</translation>
    </message>
    <message>
        <source>the tape ends here, and the program is not at its end</source>
        <translation>la bande finit ici, et le programme n'est pas à sa fin</translation>
    </message>
    <message>
        <source>the taper angle is out of range</source>
        <translation>l'angle de cône est hors de la plage</translation>
    </message>
    <message>
        <source>the taper angle {1} is out of range</source>
        <translation>l'angle de cône {1} est hors de la plage</translation>
    </message>
    <message>
        <source>the tessellation tolerances (outward {1}, inward {2}) use up the machining tolerance of {3}</source>
        <translation>les tolérances de maillage (dehors {1}, dedans {2}) épuisent la tolérance d'usinage de {3}</translation>
    </message>
    <message>
        <source>the tessellation tolerances are not lengths of 0 or more</source>
        <translation>les tolérances de maillage ne sont pas des longueurs de 0 ou plus</translation>
    </message>
    <message>
        <source>the text has more than 60 MB</source>
        <translation>le texte a plus de 60 Mo</translation>
    </message>
    <message>
        <source>the text holds control or invisible characters: '{1}'</source>
        <translation>le texte contient des caractères de contrôle ou invisibles : '{1}'</translation>
    </message>
    <message>
        <source>the text is UTF-16 or UTF-32</source>
        <translation>le texte est en UTF-16 ou UTF-32</translation>
    </message>
    <message>
        <source>the text is empty</source>
        <translation>le texte est vide</translation>
    </message>
    <message>
        <source>the text is not UTF-8</source>
        <translation>le texte n'est pas en UTF-8</translation>
    </message>
    <message>
        <source>the text is not UTF-8: '{1}'</source>
        <translation>le texte n'est pas en UTF-8 : '{1}'</translation>
    </message>
    <message>
        <source>the text is too long</source>
        <translation>le texte est trop long</translation>
    </message>
    <message>
        <source>the text of a study</source>
        <translation>le texte d'une étude</translation>
    </message>
    <message>
        <source>the text of an ASCII STL file has binary bytes in it</source>
        <translation>le texte d'un fichier STL ASCII contient des octets binaires</translation>
    </message>
    <message>
        <source>the tilt of the tool</source>
        <translation>l’inclinaison de l’outil</translation>
    </message>
    <message>
        <source>the tip is kept from going below the bottom of the stock, by up to {1} at {2} of the points: so much stays on the surface there unless 'Below the bottom' allows it</source>
        <translation>la pointe est empêchée d'aller sous le fond du brut, de {1} au plus à {2} des points : autant y reste sur la surface, sauf si 'Sous le fond' le permet</translation>
    </message>
    <message>
        <source>the tip is led in a tilted plane</source>
        <translation>la pointe est guidée dans un plan incliné</translation>
    </message>
    <message>
        <source>the tip is led on an arc</source>
        <translation>la pointe est guidée sur un arc</translation>
    </message>
    <message>
        <source>the tip is to be led and the tool's length is not called</source>
        <translation>la pointe doit être guidée et la longueur de l'outil n'est pas appelée</translation>
    </message>
    <message>
        <source>the tolerance asks for</source>
        <translation>la tolérance demande</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} drive planes</source>
        <translation>la tolérance demande plus de {1} plans directeurs</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} passes</source>
        <translation>la tolérance demande plus de {1} passes</translation>
    </message>
    <message>
        <source>the tolerance asks for more than {1} passes side by side</source>
        <translation>la tolérance demande plus de {1} passes côte à côte</translation>
    </message>
    <message>
        <source>the tolerance asks for {1} levels</source>
        <translation>la tolérance demande {1} niveaux</translation>
    </message>
    <message>
        <source>the tolerance is not above 0</source>
        <translation>la tolérance n'est pas au-dessus de 0</translation>
    </message>
    <message>
        <source>the tool axis has no direction</source>
        <translation>l'axe d'outil n'a pas de direction</translation>
    </message>
    <message>
        <source>the tool axis has no length</source>
        <translation>l'axe d'outil n'a pas de longueur</translation>
    </message>
    <message>
        <source>the tool axis has not length 1</source>
        <translation>l'axe d'outil n'est pas de longueur 1</translation>
    </message>
    <message>
        <source>the tool axis is not of length 1</source>
        <translation>l'axe d'outil n'est pas de longueur 1</translation>
    </message>
    <message>
        <source>the tool axis is told as a vector, and nothing leads the tip</source>
        <translation>l'axe d'outil est un vecteur, et rien ne guide la pointe</translation>
    </message>
    <message>
        <source>the tool axis of a 3-axis program is not +Z</source>
        <translation>l'axe d'outil d'un programme 3 axes n'est pas +Z</translation>
    </message>
    <message>
        <source>the tool axis of {1} is zero</source>
        <translation>l'axe d'outil de {1} est nul</translation>
    </message>
    <message>
        <source>the tool axis turns by half a turn at once</source>
        <translation>l'axe d'outil tourne d'un demi-tour d'un coup</translation>
    </message>
    <message>
        <source>the tool can stand nowhere along the {1} strips that tool {2} left</source>
        <translation>l'outil ne peut se tenir nulle part le long des {1} bandes que l'outil {2} a laissées</translation>
    </message>
    <message>
        <source>the tool comes down and nothing says where an axis stands</source>
        <translation>l'outil descend et rien ne dit où est un axe</translation>
    </message>
    <message>
        <source>the tool comes down on an arc</source>
        <translation>l'outil descend sur un arc</translation>
    </message>
    <message>
        <source>the tool goes elsewhere before it goes home</source>
        <translation>l'outil va ailleurs avant d'aller à son origine</translation>
    </message>
    <message>
        <source>the tool goes up and aside at the same time</source>
        <translation>l'outil monte et s'écarte en même temps</translation>
    </message>
    <message>
        <source>the tool has room there, and the machine's axes do not take it in; turn the part or take another machine</source>
        <translation>l'outil y a de la place, mais les axes de la machine ne l'atteignent pas ; tourner la pièce ou prendre une autre machine</translation>
    </message>
    <message>
        <source>the tool is changed in a tilted plane</source>
        <translation>l'outil est changé dans un plan incliné</translation>
    </message>
    <message>
        <source>the tool is changed where it stands, and not up</source>
        <translation>l'outil est changé où il est, et pas en haut</translation>
    </message>
    <message>
        <source>the tool is led by its tip from a place that is not known</source>
        <translation>l'outil est guidé par sa pointe depuis un endroit inconnu</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out and {2} of the surface stays uncut by up to {3}, most at {4}: {5} would reach it{6}</source>
        <translation>l'outil est court : queue ou porte-outil entreraient dans la pièce, donc {1} des passes sont omises et {2} de la surface restent non usinés jusqu'à {3}, surtout en {4} : {5} suffirait{6}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out: a tool that is {2} longer would reach it{3}</source>
        <translation>l'outil est court : la queue ou le porte-outil entrerait dans la pièce, {1} des passes sont donc omises : un outil plus long de {2} les atteindrait{3}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come into the part, so {1} of the passes are left out: {2} would reach it{3}</source>
        <translation>l'outil est court : queue ou porte-outil entreraient dans la pièce, donc {1} des passes sont omises : {2} suffirait{3}</translation>
    </message>
    <message>
        <source>the tool is short: shank or holder would come nearer to the part than the allowance, so over {1} of the ground the cutter stays above where it could be, by up to {2}, most at {3}: use a longer tool</source>
        <translation>l'outil est court : queue ou porte-outil viendraient plus près de la pièce que la surépaisseur, la fraise reste donc sur {1} du sol plus haut qu'elle ne pourrait, de {2} au plus, le plus à {3} : prendre un outil plus long</translation>
    </message>
    <message>
        <source>the tool is so small against the part that its rest cannot be looked for in {1} places</source>
        <translation>l'outil est si petit pour la pièce que son reste ne peut être cherché en {1} endroits</translation>
    </message>
    <message>
        <source>the tool is too large for hollows of the part: over {1} of it, seen {2}, up to {3} stays above the allowance, most at {4}: rough again there with a smaller tool</source>
        <translation>l'outil est trop grand pour des creux de la pièce : sur {1} de celle-ci, vue {2}, jusqu'à {3} reste au-dessus de la surépaisseur, le plus à {4} : y ébaucher de nouveau avec un outil plus petit</translation>
    </message>
    <message>
        <source>the tool keeps the axis ({1}, {2}, {3}), {4}° from upright.</source>
        <translation>l'outil garde l'axe ({1}, {2}, {3}), à {4}° de la verticale.</translation>
    </message>
    <message>
        <source>the tool leaves nothing that is thicker than that</source>
        <translation>l'outil ne laisse rien de plus épais</translation>
    </message>
    <message>
        <source>the tool moves aside, and nothing says how high it is</source>
        <translation>l'outil s'écarte, et rien ne dit à quelle hauteur il est</translation>
    </message>
    <message>
        <source>the tool moves in a tilted plane, and its length is not called</source>
        <translation>l'outil se déplace dans un plan incliné, et sa longueur n'est pas appelée</translation>
    </message>
    <message>
        <source>the tool number {1} occurs twice</source>
        <translation>le numéro d'outil {1} apparaît deux fois</translation>
    </message>
    <message>
        <source>the tool takes away nowhere more than {1} of what stands on the {2} strips</source>
        <translation>l'outil n'enlève nulle part plus de {1} de ce qui reste sur les {2} bandes</translation>
    </message>
    <message>
        <source>the tool that cut before is not known</source>
        <translation>l'outil qui a usiné avant n'est pas connu</translation>
    </message>
    <message>
        <source>the tool's {1} would touch the part wherever there is something to cut</source>
        <translation>l'outil ({1}) toucherait la pièce partout où il y a quelque chose à usiner</translation>
    </message>
    <message>
        <source>the tool{1} fits but does not go there</source>
        <translation>l'outil{1} y passe, mais n'y va pas</translation>
    </message>
    <message>
        <source>the tool{1} fits, but a tab is to stay there</source>
        <translation>l'outil{1} y passe, mais une attache doit y rester</translation>
    </message>
    <message>
        <source>the tool{1} fits, but its boundary leaves the place out</source>
        <translation>l'outil{1} y passe, mais sa limite exclut l'endroit</translation>
    </message>
    <message>
        <source>the tool{1} fits, but its shank or holder would touch stock that stands</source>
        <translation>l'outil{1} y passe, mais sa queue ou son porte-outil toucheraient le brut qui reste</translation>
    </message>
    <message>
        <source>the tool{1} fits, but would come too near to a fixture</source>
        <translation>l'outil{1} y passe, mais viendrait trop près d'un bridage</translation>
    </message>
    <message>
        <source>the tool{1} fits, but would go below the bottom of the stock</source>
        <translation>l'outil{1} y passe, mais irait sous le fond du brut</translation>
    </message>
    <message>
        <source>the transform {1} is not twelve numbers</source>
        <translation>la transformation {1} n'est pas de douze nombres</translation>
    </message>
    <message>
        <source>the transform {1} leaves nothing of an object</source>
        <translation>la transformation {1} ne laisse rien d'un objet</translation>
    </message>
    <message>
        <source>the turning axis passes {1} beside the part</source>
        <translation>l'axe de rotation passe à {1} à côté de la pièce</translation>
    </message>
    <message>
        <source>the two points of the turning axis are the same</source>
        <translation>les deux points de l'axe de rotation sont le même</translation>
    </message>
    <message>
        <source>the value has the wrong type</source>
        <translation>la valeur n'a pas le bon type</translation>
    </message>
    <message>
        <source>the value is not a finite number</source>
        <translation>la valeur n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>the value is not a whole number</source>
        <translation>la valeur n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>the value is {1}</source>
        <translation>la valeur est {1}</translation>
    </message>
    <message>
        <source>the value {1} is out of range</source>
        <translation>la valeur {1} est hors de la plage</translation>
    </message>
    <message>
        <source>the value {1} is too large</source>
        <translation>la valeur {1} est trop grande</translation>
    </message>
    <message>
        <source>the vector has no words</source>
        <translation>le vecteur n'a pas de mots</translation>
    </message>
    <message>
        <source>the verification</source>
        <translation>la vérification</translation>
    </message>
    <message>
        <source>the version is negative</source>
        <translation>la version est négative</translation>
    </message>
    <message>
        <source>the version is not a whole number</source>
        <translation>la version n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>the version of the project file is missing</source>
        <translation>la version du fichier de projet manque</translation>
    </message>
    <message>
        <source>the version, 1</source>
        <translation>la version, 1</translation>
    </message>
    <message>
        <source>the vertex number</source>
        <translation>le numéro du sommet</translation>
    </message>
    <message>
        <source>the vertices have no x, y and z</source>
        <translation>les sommets n'ont pas x, y et z</translation>
    </message>
    <message>
        <source>the view direction has no length or runs along the machining direction</source>
        <translation>la direction de vue n'a pas de longueur ou suit la direction d'usinage</translation>
    </message>
    <message>
        <source>the whole part is smaller than {1} mm</source>
        <translation>toute la pièce est plus petite que {1} mm</translation>
    </message>
    <message>
        <source>the word endsolid is missing and the mesh has {1} open edges</source>
        <translation>le mot endsolid manque et le maillage a {1} arêtes ouvertes</translation>
    </message>
    <message>
        <source>the word {1} is not read: it changes the path</source>
        <translation>le mot {1} n'est pas lu : il change le parcours</translation>
    </message>
    <message>
        <source>the work coordinate system is {1}, and the part stands in {2}</source>
        <translation>le système de coordonnées pièce est {1}, et la pièce est dans {2}</translation>
    </message>
    <message>
        <source>the work coordinate system is {1}, and the project names none</source>
        <translation>le système de coordonnées pièce est {1}, et le projet n'en nomme aucun</translation>
    </message>
    <message>
        <source>the {1} has no file</source>
        <translation>pas de fichier : {1}</translation>
    </message>
    <message>
        <source>the {1} is not a finite number</source>
        <translation>pas un nombre fini : {1}</translation>
    </message>
    <message>
        <source>the {1} would touch the part along {2} of passes, which are left out: use a longer tool</source>
        <translation>{1} toucherait la pièce le long de {2} des passes, qui sont omises : prendre un outil plus long</translation>
    </message>
    <message>
        <source>the {1} would touch the part along {2} of passes, which are left out: use a longer tool, or allow it to be inclined by a tilt limit</source>
        <translation>{1} toucherait la pièce le long de {2} des passes, qui sont omises : prendre un outil plus long, ou lui permettre de s'incliner par une limite d'inclinaison</translation>
    </message>
    <message>
        <source>the {1} {2} cannot be written</source>
        <translation>impossible à écrire : {1} {2}</translation>
    </message>
    <message>
        <source>the {1}'s mesh encloses nothing</source>
        <translation>le maillage ({1}) n'enferme rien</translation>
    </message>
    <message>
        <source>the {1}'s mesh is not closed: {2} open edges, {3} of more than two facets, {4} between facets that face apart</source>
        <translation>le maillage ({1}) n'est pas fermé : {2} arêtes ouvertes, {3} de plus de deux facettes, {4} entre facettes de sens opposés</translation>
    </message>
    <message>
        <source>their plane goes through the middle of the part: there is no side to lie on</source>
        <translation>leur plan passe par le milieu de la pièce : il n'y a pas de côté où la poser</translation>
    </message>
    <message>
        <source>then by {1}° about {2}</source>
        <translation>puis de {1}° autour de {2}</translation>
    </message>
    <message>
        <source>then moved by {1}</source>
        <translation>puis déplacé de {1}</translation>
    </message>
    <message>
        <source>there are more than 10^15 combinations</source>
        <translation>il y a plus de 10^15 combinaisons</translation>
    </message>
    <message>
        <source>there are more than two rotary axes</source>
        <translation>il y a plus de deux axes rotatifs</translation>
    </message>
    <message>
        <source>there are no values, or two kinds of them</source>
        <translation>il n'y a pas de valeurs, ou il y en a de deux sortes</translation>
    </message>
    <message>
        <source>there are statements after FINI</source>
        <translation>il y a des instructions après FINI</translation>
    </message>
    <message>
        <source>there are too many brackets</source>
        <translation>il y a trop de parenthèses</translation>
    </message>
    <message>
        <source>there are too many lines</source>
        <translation>il y a trop de lignes</translation>
    </message>
    <message>
        <source>there are two axes {1}</source>
        <translation>il y a deux axes {1}</translation>
    </message>
    <message>
        <source>there are: {1}</source>
        <translation>il y a : {1}</translation>
    </message>
    <message>
        <source>there is motion after END</source>
        <translation>il y a des mouvements après END</translation>
    </message>
    <message>
        <source>there is no '='</source>
        <translation>il manque '='</translation>
    </message>
    <message>
        <source>there is no '{1}'; there are {2}</source>
        <translation>il n'y a pas de '{1}' ; il y a {2}</translation>
    </message>
    <message>
        <source>there is no CUTTER statement</source>
        <translation>il n'y a pas d'instruction CUTTER</translation>
    </message>
    <message>
        <source>there is no boundary '{1}'</source>
        <translation>il n'y a pas de limite '{1}'</translation>
    </message>
    <message>
        <source>there is no buffer {1}</source>
        <translation>il n’y a pas de tampon {1}</translation>
    </message>
    <message>
        <source>there is no contact point {1}: the operation has {2}</source>
        <translation>il n'y a pas de point de contact {1} : l'opération en a {2}</translation>
    </message>
    <message>
        <source>there is no feed</source>
        <translation>il n'y a pas d'avance</translation>
    </message>
    <message>
        <source>there is no file {1}</source>
        <translation>il n'y a pas de fichier {1}</translation>
    </message>
    <message>
        <source>there is no key before '='</source>
        <translation>il n'y a pas de clé avant '='</translation>
    </message>
    <message>
        <source>there is no motion at feed in the file</source>
        <translation>il n'y a pas de mouvement en avance dans le fichier</translation>
    </message>
    <message>
        <source>there is no motion that cuts</source>
        <translation>aucun mouvement ne coupe</translation>
    </message>
    <message>
        <source>there is no number {1}</source>
        <translation>il n’y a pas de numéro {1}</translation>
    </message>
    <message>
        <source>there is no object '{1}'</source>
        <translation>il n'y a pas d'objet '{1}'</translation>
    </message>
    <message>
        <source>there is no operation '{1}'</source>
        <translation>il n'y a pas d'opération '{1}'</translation>
    </message>
    <message>
        <source>there is no operation in it</source>
        <translation>il n'y a pas d'opération dedans</translation>
    </message>
    <message>
        <source>there is no operation name before the key</source>
        <translation>il n'y a pas de nom d'opération avant la clé</translation>
    </message>
    <message>
        <source>there is no picture to write</source>
        <translation>il n'y a pas d'image à écrire</translation>
    </message>
    <message>
        <source>there is no point behind a bracket</source>
        <translation>il n'y a pas de point derrière un crochet</translation>
    </message>
    <message>
        <source>there is no program</source>
        <translation>il n'y a pas de programme</translation>
    </message>
    <message>
        <source>there is no program {1}</source>
        <translation>il n’y a pas de programme {1}</translation>
    </message>
    <message>
        <source>there is no result</source>
        <translation>il n'y a pas de résultat</translation>
    </message>
    <message>
        <source>there is no room for the tool to enter</source>
        <translation>l'outil n'a pas la place d'entrer</translation>
    </message>
    <message>
        <source>there is no round wall or rim</source>
        <translation>il n'y a ni paroi ni bord rond</translation>
    </message>
    <message>
        <source>there is no setup '{1}'</source>
        <translation>il n'y a pas de posage '{1}'</translation>
    </message>
    <message>
        <source>there is no setup {1}</source>
        <translation>il n'y a pas de posage {1}</translation>
    </message>
    <message>
        <source>there is no stock</source>
        <translation>il n'y a pas de brut</translation>
    </message>
    <message>
        <source>there is no such candidate</source>
        <translation>il n'y a pas de tel candidat</translation>
    </message>
    <message>
        <source>there is no such end</source>
        <translation>il n'y a pas de telle fin</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>il n'y a pas de telle sorte</translation>
    </message>
    <message>
        <source>there is no such plane</source>
        <translation>il n'y a pas de tel plan</translation>
    </message>
    <message>
        <source>there is no such program</source>
        <translation>il n'y a pas de tel programme</translation>
    </message>
    <message>
        <source>there is no such program{1}</source>
        <translation>il n'y a pas de tel programme{1}</translation>
    </message>
    <message>
        <source>there is no such version</source>
        <translation>il n'y a pas de telle version</translation>
    </message>
    <message>
        <source>there is no tool {1}</source>
        <translation>il n'y a pas d'outil {1}</translation>
    </message>
    <message>
        <source>there is no value to try</source>
        <translation>il n'y a aucune valeur à essayer</translation>
    </message>
    <message>
        <source>there is no verdict in them</source>
        <translation>il n'y a pas de verdict dedans</translation>
    </message>
    <message>
        <source>there is no word {{1}}</source>
        <translation>il n'y a pas de mot {{1}}</translation>
    </message>
    <message>
        <source>there is no {1}</source>
        <translation>il n'y a pas de {1}</translation>
    </message>
    <message>
        <source>there is no {1} '{2}'</source>
        <translation>il n'y a pas de {1} '{2}'</translation>
    </message>
    <message>
        <source>there is no {1} {2}: the part has {3}</source>
        <translation>il n'y a pas de {1} {2} : la pièce en a {3}</translation>
    </message>
    <message>
        <source>there is nothing that this format can carry</source>
        <translation>il n'y a rien que ce format puisse reprendre</translation>
    </message>
    <message>
        <source>these are too many values</source>
        <translation>ce sont trop de valeurs</translation>
    </message>
    <message>
        <source>they are not what was written</source>
        <translation>ils ne sont pas ce qui a été écrit</translation>
    </message>
    <message>
        <source>they lie nearly on a line: no plane goes through them</source>
        <translation>ils sont presque alignés : aucun plan n'y passe</translation>
    </message>
    <message>
        <source>thicken</source>
        <translation>épaissir</translation>
    </message>
    <message>
        <source>thicken: how far behind the sheet its back lies; in front of it below 0.</source>
        <translation>épaissir : à quelle distance derrière la feuille est son dos ; devant elle sous 0.</translation>
    </message>
    <message>
        <source>this is no code</source>
        <translation>ce n'est pas un code</translation>
    </message>
    <message>
        <source>this is no code, or it has another meaning</source>
        <translation>ce n'est pas un code, ou il a une autre signification</translation>
    </message>
    <message>
        <source>this is no extension of a program</source>
        <translation>ce n'est pas une extension de programme</translation>
    </message>
    <message>
        <source>this is no letter</source>
        <translation>ce n'est pas une lettre</translation>
    </message>
    <message>
        <source>this is no other kind of comment</source>
        <translation>ce n'est pas une autre sorte de commentaire</translation>
    </message>
    <message>
        <source>thousands or decimals? export the part again with decimal points</source>
        <translation>milliers ou décimales ? exporter de nouveau la pièce avec des points décimaux</translation>
    </message>
    <message>
        <source>three axes</source>
        <translation>trois axes</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>trois nombres</translation>
    </message>
    <message>
        <source>tilt the tool less</source>
        <translation>moins incliner l'outil</translation>
    </message>
    <message>
        <source>tilted planes are for controls that know the kinematics</source>
        <translation>les plans inclinés sont pour les commandes qui connaissent la cinématique</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>pointe</translation>
    </message>
    <message>
        <source>tip (TCP)</source>
        <translation>pointe (TCP)</translation>
    </message>
    <message>
        <source>tip (TCP, tilted planes)</source>
        <translation>pointe (TCP, plans inclinés)</translation>
    </message>
    <message>
        <source>together at most 90°</source>
        <translation>ensemble au plus 90°</translation>
    </message>
    <message>
        <source>too few numbers for one '{1}'</source>
        <translation>trop peu de nombres pour un '{1}'</translation>
    </message>
    <message>
        <source>too many numbers for one '{1}'</source>
        <translation>trop de nombres pour un '{1}'</translation>
    </message>
    <message>
        <source>too many words in the header line</source>
        <translation>trop de mots dans la ligne d'en-tête</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>outil</translation>
    </message>
    <message>
        <source>tool axis</source>
        <translation>axe d'outil</translation>
    </message>
    <message>
        <source>tool {1}</source>
        <translation>outil {1}</translation>
    </message>
    <message>
        <source>tool {1} cannot enter, leaves {2}</source>
        <translation>l'outil {1} ne peut entrer, laisse {2}</translation>
    </message>
    <message>
        <source>tool {1} has no ball end</source>
        <translation>l'outil {1} n'a pas de bout hémisphérique</translation>
    </message>
    <message>
        <source>tool {1} is a ball, which matches no curvature by its lead</source>
        <translation>l'outil {1} est hémisphérique, son attaque n'ajuste aucune courbure</translation>
    </message>
    <message>
        <source>tool {1} is another cutter in {2}</source>
        <translation>l'outil {1} est une autre fraise dans {2}</translation>
    </message>
    <message>
        <source>tool {1} is to clean up what it left itself</source>
        <translation>l'outil {1} doit nettoyer ce qu'il a laissé lui-même</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2}</source>
        <translation>l'outil {1} ne laisse nulle part plus de {2}</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2} that the operations before have not cut</source>
        <translation>l'outil {1} ne laisse nulle part plus de {2} que les opérations précédentes n'ont pas usiné</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2} that the operations before have not cut, nor do the operations before</source>
        <translation>l'outil {1} ne laisse nulle part plus de {2} que les opérations précédentes n'ont pas usiné, elles non plus</translation>
    </message>
    <message>
        <source>tool {1} leaves nowhere more than {2}, nor do the operations before</source>
        <translation>l'outil {1} ne laisse nulle part plus de {2}, les opérations précédentes non plus</translation>
    </message>
    <message>
        <source>tool {1} touches both flanks, leaves {2}</source>
        <translation>l'outil {1} touche les deux flancs, laisse {2}</translation>
    </message>
    <message>
        <source>tool {1} would go below the bottom of the stock, leaves {2}</source>
        <translation>l’outil {1} irait sous le fond du brut, laisse {2}</translation>
    </message>
    <message>
        <source>tools keep {1}</source>
        <translation>les outils gardent {1}</translation>
    </message>
    <message>
        <source>tools there are: {1}</source>
        <translation>outils existants : {1}</translation>
    </message>
    <message>
        <source>top</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>triangular</source>
        <translation>triangulaire</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>try again</source>
        <translation>essayer de nouveau</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>orienter</translation>
    </message>
    <message>
        <source>turn it in a block of its own</source>
        <translation>le tourner dans un bloc à part</translation>
    </message>
    <message>
        <source>turn the part</source>
        <translation>tourner la pièce</translation>
    </message>
    <message>
        <source>turn the part or choose another axis</source>
        <translation>tournez la pièce ou choisissez un autre axe</translation>
    </message>
    <message>
        <source>turn the part or choose another tool axis</source>
        <translation>tournez la pièce ou choisissez un autre axe d’outil</translation>
    </message>
    <message>
        <source>turned by {1}</source>
        <translation>tourné de {1}</translation>
    </message>
    <message>
        <source>turned by {1}° about {2}</source>
        <translation>tourné de {1}° autour de {2}</translation>
    </message>
    <message>
        <source>turns by half a turn in one motion</source>
        <translation>tourne d'un demi-tour en un mouvement</translation>
    </message>
    <message>
        <source>turns of the spiral</source>
        <translation>spires de la spirale</translation>
    </message>
    <message>
        <source>two kinds of motion in one block</source>
        <translation>deux sortes de mouvement dans un bloc</translation>
    </message>
    <message>
        <source>two measures are multiplied</source>
        <translation>deux mesures sont multipliées</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>deux nombres</translation>
    </message>
    <message>
        <source>two programs would have the name '{1}'</source>
        <translation>deux programmes porteraient le nom '{1}'</translation>
    </message>
    <message>
        <source>two setups have such an operation: name the setup</source>
        <translation>deux posages ont une telle opération : nommer le posage</translation>
    </message>
    <message>
        <source>two work coordinate systems in '{1}'</source>
        <translation>deux systèmes de coordonnées pièce dans '{1}'</translation>
    </message>
    <message>
        <source>unexpected end of input</source>
        <translation>fin inattendue</translation>
    </message>
    <message>
        <source>unknown format '{1}'</source>
        <translation>format inconnu '{1}'</translation>
    </message>
    <message>
        <source>unknown header word '{1}'</source>
        <translation>mot d'en-tête inconnu '{1}'</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>clé inconnue</translation>
    </message>
    <message>
        <source>unknown kind of linking</source>
        <translation>type de liaison inconnu</translation>
    </message>
    <message>
        <source>unknown kind of parameter</source>
        <translation>type de paramètre inconnu</translation>
    </message>
    <message>
        <source>unknown name '{1}'</source>
        <translation>nom inconnu '{1}'</translation>
    </message>
    <message>
        <source>unknown number type '{1}'</source>
        <translation>type de nombre inconnu '{1}'</translation>
    </message>
    <message>
        <source>unknown operation '{1}'; did you mean '{2}'?</source>
        <translation>opération inconnue '{1}' ; s'agit-il de '{2}' ?</translation>
    </message>
    <message>
        <source>unknown operation '{1}'{2}</source>
        <translation>opération inconnue '{1}'{2}</translation>
    </message>
    <message>
        <source>unknown shape '{1}'</source>
        <translation>forme inconnue '{1}'</translation>
    </message>
    <message>
        <source>unknown unit '{1}'</source>
        <translation>unité inconnue '{1}'</translation>
    </message>
    <message>
        <source>unknown value '{1}'</source>
        <translation>valeur inconnue '{1}'</translation>
    </message>
    <message>
        <source>unknown version '{1}'</source>
        <translation>version inconnue '{1}'</translation>
    </message>
    <message>
        <source>unknown view '{1}'</source>
        <translation>vue inconnue '{1}'</translation>
    </message>
    <message>
        <source>unpack into another folder</source>
        <translation>décompresser dans un autre dossier</translation>
    </message>
    <message>
        <source>unpack it by other means, if you trust it</source>
        <translation>la décompresser autrement, si elle est de confiance</translation>
    </message>
    <message>
        <source>unpack it first</source>
        <translation>le décompresser d'abord</translation>
    </message>
    <message>
        <source>unwound</source>
        <translation>continus</translation>
    </message>
    <message>
        <source>up to {1} stays above the allowance; the tolerance is {2}</source>
        <translation>jusqu'à {1} reste au-dessus de la surépaisseur ; la tolérance est {2}</translation>
    </message>
    <message>
        <source>update Facetmill</source>
        <translation>mettre Facetmill à jour</translation>
    </message>
    <message>
        <source>use .fmtools, .fctb, .fctl, .fcholder, .json, .tools or .tbl</source>
        <translation>utiliser .fmtools, .fctb, .fctl, .fcholder, .json, .tools ou .tbl</translation>
    </message>
    <message>
        <source>use a coarser mesh, or boxes and cylinders</source>
        <translation>prendre un maillage plus grossier, ou des boîtes et cylindres</translation>
    </message>
    <message>
        <source>use a coarser resolution</source>
        <translation>utiliser une résolution plus grossière</translation>
    </message>
    <message>
        <source>use a larger tolerance</source>
        <translation>utiliser une tolérance plus grande</translation>
    </message>
    <message>
        <source>use a longer tool, or allow a larger tilt limit</source>
        <translation>prendre un outil plus long, ou permettre une limite d'inclinaison plus grande</translation>
    </message>
    <message>
        <source>use a longer tool, or allow it to be inclined by a tilt limit</source>
        <translation>prendre un outil plus long, ou lui permettre de s'incliner par une limite d'inclinaison</translation>
    </message>
    <message>
        <source>use a longer tool, or less holder clearance</source>
        <translation>prendre un outil plus long, ou moins de distance du porte-outil</translation>
    </message>
    <message>
        <source>use a mesh of at most {1} facets</source>
        <translation>utiliser un maillage d'au plus {1} facettes</translation>
    </message>
    <message>
        <source>use a mesh of at most {1} million facets</source>
        <translation>utiliser un maillage d'au plus {1} millions de facettes</translation>
    </message>
    <message>
        <source>use a newer Facetmill</source>
        <translation>utiliser un Facetmill plus récent</translation>
    </message>
    <message>
        <source>use a newer Facetmill, or export it anew</source>
        <translation>utiliser un Facetmill plus récent, ou l'exporter de nouveau</translation>
    </message>
    <message>
        <source>use a number or one of: {1}</source>
        <translation>utiliser un nombre ou un de : {1}</translation>
    </message>
    <message>
        <source>use a smaller mesh</source>
        <translation>prendre un maillage plus petit</translation>
    </message>
    <message>
        <source>use a smaller or longer tool</source>
        <translation>prendre un outil plus petit ou plus long</translation>
    </message>
    <message>
        <source>use a smaller tool</source>
        <translation>prendre un outil plus petit</translation>
    </message>
    <message>
        <source>use a smaller tool there</source>
        <translation>y prendre un outil plus petit</translation>
    </message>
    <message>
        <source>use a smaller tool, or leave the operation out</source>
        <translation>prendre un outil plus petit, ou omettre l'opération</translation>
    </message>
    <message>
        <source>use a smaller tool: one of {1} does on half of the part</source>
        <translation>prendre un outil plus petit : un de {1} convient sur la moitié de la pièce</translation>
    </message>
    <message>
        <source>use a stock that reaches lower, or allow it by 'Below the bottom'</source>
        <translation>prendre un brut qui descend plus bas, ou le permettre par 'Sous le fond'</translation>
    </message>
    <message>
        <source>use a tool that is {1} longer{2}</source>
        <translation>prendre un outil plus long de {1}{2}</translation>
    </message>
    <message>
        <source>use at least {1}</source>
        <translation>utiliser au moins {1}</translation>
    </message>
    <message>
        <source>use at most {1}, half of the narrowest cutter's radius</source>
        <translation>utiliser au plus {1}, la moitié du rayon de la fraise la plus étroite</translation>
    </message>
    <message>
        <source>use ball:D, flat:D, bull:D,r, cone:D,half_angle or apt:d,r,e,f,alpha,beta,h</source>
        <translation>utiliser ball:D, flat:D, bull:D,r, cone:D,half_angle ou apt:d,r,e,f,alpha,beta,h</translation>
    </message>
    <message>
        <source>use concave, convex or complex</source>
        <translation>utiliser concave, convex ou complex</translation>
    </message>
    <message>
        <source>use mm or in</source>
        <translation>utiliser mm ou in</translation>
    </message>
    <message>
        <source>use mm, cm, m, in or ft</source>
        <translation>utiliser mm, cm, m, in ou ft</translation>
    </message>
    <message>
        <source>use one of {1}</source>
        <translation>utiliser un de {1}</translation>
    </message>
    <message>
        <source>use one of: {1}</source>
        <translation>utiliser un de : {1}</translation>
    </message>
    <message>
        <source>use small letters and _</source>
        <translation>utiliser des minuscules et _</translation>
    </message>
    <message>
        <source>use the newer program</source>
        <translation>utiliser le programme plus récent</translation>
    </message>
    <message>
        <source>use the same one on all machines, or begin with this one: study run</source>
        <translation>utiliser le même sur tous les ordinateurs, ou commencer avec celui-ci : study run</translation>
    </message>
    <message>
        <source>value {1} of {2}, '{3}', is not a number</source>
        <translation>la valeur {1} de {2}, '{3}', n'est pas un nombre</translation>
    </message>
    <message>
        <source>vary: no combination is possible</source>
        <translation>vary : aucune combinaison n'est possible</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>wait for it, or end it</source>
        <translation>l'attendre, ou y mettre fin</translation>
    </message>
    <message>
        <source>was asked for a pose that is not finite or has no unit axis</source>
        <translation>une pose non finie ou sans axe unité lui a été demandée</translation>
    </message>
    <message>
        <source>was asked for a space without a grid</source>
        <translation>un espace sans grille lui a été demandé</translation>
    </message>
    <message>
        <source>was asked for at a point without a normal</source>
        <translation>a été demandé en un point sans normale</translation>
    </message>
    <message>
        <source>was made without a tool</source>
        <translation>a été fait sans outil</translation>
    </message>
    <message>
        <source>what begins with ( ends with ), what begins with ; with the line</source>
        <translation>ce qui commence par ( finit par ), ce qui commence par ; avec la ligne</translation>
    </message>
    <message>
        <source>what holds the stock from below</source>
        <translation>ce qui tient le brut par dessous</translation>
    </message>
    <message>
        <source>what is as steep as asked for lies below the bottom of the stock</source>
        <translation>ce qui est aussi raide que demandé se trouve sous le bas du brut</translation>
    </message>
    <message>
        <source>what lies between the curves folds over, as at {1}</source>
        <translation>ce qui est entre les courbes se replie, par exemple en {1}</translation>
    </message>
    <message>
        <source>what operations before have cut</source>
        <translation>ce que les opérations précédentes ont enlevé</translation>
    </message>
    <message>
        <source>what setup '{1}' left</source>
        <translation>ce que le posage '{1}' a laissé</translation>
    </message>
    <message>
        <source>what the setup before leaves is not known yet</source>
        <translation>ce que laisse le posage précédent n'est pas encore connu</translation>
    </message>
    <message>
        <source>where the part is said to be in the way it may be {1}, kept off like the part</source>
        <translation>où la pièce est dite gêner, ce peut être {1}, évités comme la pièce</translation>
    </message>
    <message>
        <source>widen it or the slope limits, or take a tool that reaches what lies in it</source>
        <translation>l'élargir, elle ou les limites de pente, ou prendre un outil qui atteint ce qui s'y trouve</translation>
    </message>
    <message>
        <source>widen it, or take a tool that reaches what lies in it</source>
        <translation>l'élargir, ou prendre un outil qui atteint ce qui s'y trouve</translation>
    </message>
    <message>
        <source>widen it, take a smaller tool, or keep only the contact within</source>
        <translation>l'élargir, prendre un outil plus petit, ou ne garder que le contact dedans</translation>
    </message>
    <message>
        <source>widen the slope limit, or cut it by levels (waterline)</source>
        <translation>élargissez la limite de pente, ou usinez par niveaux constants</translation>
    </message>
    <message>
        <source>widen the slope limits, or finish it by parallel passes</source>
        <translation>élargir les limites de pente, ou finir par des passes parallèles</translation>
    </message>
    <message>
        <source>with corner radius 0 the centre (e, f) must be the corner ({1}, {2})</source>
        <translation>avec un rayon de coin 0 le centre (e, f) doit être le coin ({1}, {2})</translation>
    </message>
    <message>
        <source>with taper angle {1}° the side meets the axis below the height {2}</source>
        <translation>avec un angle de cône de {1}° le côté rencontre l'axe sous la hauteur {2}</translation>
    </message>
    <message>
        <source>without how it is run ('{1}'): {2}</source>
        <translation>sans ses conditions de coupe ('{1}') : {2}</translation>
    </message>
    <message>
        <source>without its flutes: {1}</source>
        <translation>sans ses dents : {1}</translation>
    </message>
    <message>
        <source>words are read as they lie in memory</source>
        <translation>les mots sont lus comme ils sont en mémoire</translation>
    </message>
    <message>
        <source>would hold {1} files, more than {2}</source>
        <translation>contiendrait {1} fichiers, plus de {2}</translation>
    </message>
    <message>
        <source>would make the archive hold more than {1} bytes</source>
        <translation>ferait dépasser à l'archive {1} octets</translation>
    </message>
    <message>
        <source>would take {1}</source>
        <translation>prendrait {1}</translation>
    </message>
    <message>
        <source>write "mm" or "in"</source>
        <translation>écrire "mm" ou "in"</translation>
    </message>
    <message>
        <source>write "planes": ["xy"] and "helix": false</source>
        <translation>écrire "planes": ["xy"] et "helix": false</translation>
    </message>
    <message>
        <source>write "samples" of at most {1}</source>
        <translation>écrire "samples" d'au plus {1}</translation>
    </message>
    <message>
        <source>write "study": 1</source>
        <translation>écrire "study": 1</translation>
    </message>
    <message>
        <source>write "values", or "from", "to" and "steps"</source>
        <translation>écrire "values", ou "from", "to" et "steps"</translation>
    </message>
    <message>
        <source>write '%' first and last alone</source>
        <translation>n'écrire '%' qu'en premier et en dernier</translation>
    </message>
    <message>
        <source>write '{1}.'</source>
        <translation>écrire '{1}.'</translation>
    </message>
    <message>
        <source>write 1 or -1</source>
        <translation>écrire 1 ou -1</translation>
    </message>
    <message>
        <source>write 1: the version of the file</source>
        <translation>écrire 1 : la version du fichier</translation>
    </message>
    <message>
        <source>write ASCII</source>
        <translation>écrire en ASCII</translation>
    </message>
    <message>
        <source>write CUTTER/d,r,e,f,alpha,beta,h</source>
        <translation>écrire CUTTER/d,r,e,f,alpha,beta,h</translation>
    </message>
    <message>
        <source>write GODLTA/dx,dy,dz or GODLTA/d</source>
        <translation>écrire GODLTA/dx,dy,dz ou GODLTA/d</translation>
    </message>
    <message>
        <source>write NAME.key=value, as in Finish.tolerance=0.01</source>
        <translation>écrire NOM.clé=valeur, comme Finish.tolerance=0.01</translation>
    </message>
    <message>
        <source>write TLAXIS/i,j,k</source>
        <translation>écrire TLAXIS/i,j,k</translation>
    </message>
    <message>
        <source>write UNITS/MM or UNITS/INCHES</source>
        <translation>écrire UNITS/MM ou UNITS/INCHES</translation>
    </message>
    <message>
        <source>write WORD/values</source>
        <translation>écrire MOT/valeurs</translation>
    </message>
    <message>
        <source>write [lowest, highest], or leave it out for no limit</source>
        <translation>écrire [plus bas, plus haut], ou l'omettre pour aucune limite</translation>
    </message>
    <message>
        <source>write a dot and letters, as .ngc</source>
        <translation>écrire un point et des lettres, comme .ngc</translation>
    </message>
    <message>
        <source>write a list, "tools" or "orders"</source>
        <translation>écrire une liste, "tools" ou "orders"</translation>
    </message>
    <message>
        <source>write a name without slashes</source>
        <translation>écrire un nom sans barres obliques</translation>
    </message>
    <message>
        <source>write a number</source>
        <translation>écrire un nombre</translation>
    </message>
    <message>
        <source>write a number above 0, at most 1</source>
        <translation>écrire un nombre au-dessus de 0, au plus 1</translation>
    </message>
    <message>
        <source>write a number above 0, or leave it out</source>
        <translation>écrire un nombre supérieur à 0, ou l'omettre</translation>
    </message>
    <message>
        <source>write a number of ordinary size</source>
        <translation>écrire un nombre de taille ordinaire</translation>
    </message>
    <message>
        <source>write a number, or ×1.1 for 1.1 times what the project comes to</source>
        <translation>écrire un nombre, ou ×1,1 pour 1,1 fois ce à quoi le projet arrive</translation>
    </message>
    <message>
        <source>write a place of the project's file, as operations[Finish].tolerance</source>
        <translation>écrire un endroit du fichier du projet, comme operations[Finish].tolerance</translation>
    </message>
    <message>
        <source>write a point on the rotation axis</source>
        <translation>écrire un point de l'axe de rotation</translation>
    </message>
    <message>
        <source>write a straight motion</source>
        <translation>écrire un mouvement droit</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>écrire un nombre entier</translation>
    </message>
    <message>
        <source>write a whole number from {1}</source>
        <translation>écrire un nombre entier à partir de {1}</translation>
    </message>
    <message>
        <source>write all of its lines</source>
        <translation>écrire toutes ses lignes</translation>
    </message>
    <message>
        <source>write at most {1}</source>
        <translation>écrire au plus {1}</translation>
    </message>
    <message>
        <source>write both in one line</source>
        <translation>écrire les deux dans une ligne</translation>
    </message>
    <message>
        <source>write decimal numbers</source>
        <translation>écrire des nombres décimaux</translation>
    </message>
    <message>
        <source>write decimal numbers; formulas and variables are not read</source>
        <translation>écrire des nombres décimaux ; formules et variables ne sont pas lues</translation>
    </message>
    <message>
        <source>write how many times the project's</source>
        <translation>écrire combien de fois celui du projet</translation>
    </message>
    <message>
        <source>write how many values there are</source>
        <translation>écrire combien il y a de valeurs</translation>
    </message>
    <message>
        <source>write it</source>
        <translation>l'écrire</translation>
    </message>
    <message>
        <source>write it as G1, G43.4 or TRAORI</source>
        <translation>l'écrire comme G1, G43.4 ou TRAORI</translation>
    </message>
    <message>
        <source>write it as G54</source>
        <translation>l'écrire comme G54</translation>
    </message>
    <message>
        <source>write it on one line without them</source>
        <translation>l'écrire sur une ligne sans eux</translation>
    </message>
    <message>
        <source>write it once</source>
        <translation>l'écrire une fois</translation>
    </message>
    <message>
        <source>write it with the dot: .ngc</source>
        <translation>l'écrire avec le point : .ngc</translation>
    </message>
    <message>
        <source>write its place behind it</source>
        <translation>écrire sa place derrière</translation>
    </message>
    <message>
        <source>write letters with decimal numbers</source>
        <translation>écrire des lettres avec des nombres décimaux</translation>
    </message>
    <message>
        <source>write letters, or letters and digits that end with '='</source>
        <translation>écrire des lettres, ou des lettres et chiffres terminés par '='</translation>
    </message>
    <message>
        <source>write lf or crlf</source>
        <translation>écrire lf ou crlf</translation>
    </message>
    <message>
        <source>write numbers and ranges in ascending order, as 0-57, 60</source>
        <translation>écrire numéros et plages en ordre croissant, comme 0-57, 60</translation>
    </message>
    <message>
        <source>write one ( and one )</source>
        <translation>écrire une ( et une )</translation>
    </message>
    <message>
        <source>write one letter, or nothing</source>
        <translation>écrire une lettre, ou rien</translation>
    </message>
    <message>
        <source>write one of them</source>
        <translation>écrire l'un d'eux</translation>
    </message>
    <message>
        <source>write one of: {1}</source>
        <translation>écrire l'un de : {1}</translation>
    </message>
    <message>
        <source>write one program for each operation: "programs": "each"</source>
        <translation>écrire un programme par opération : "programs": "each"</translation>
    </message>
    <message>
        <source>write out those that are meant</source>
        <translation>écrire en entier ceux qui sont visés</translation>
    </message>
    <message>
        <source>write setups[NAME]. before it; setups there are: {1}</source>
        <translation>écrire setups[NAME]. devant ; posages présents : {1}</translation>
    </message>
    <message>
        <source>write smooth or flat</source>
        <translation>écrire lisse ou plat</translation>
    </message>
    <message>
        <source>write some of: {1}</source>
        <translation>écrire quelques-uns de : {1}</translation>
    </message>
    <message>
        <source>write straight motions</source>
        <translation>écrire des mouvements droits</translation>
    </message>
    <message>
        <source>write the direction of the rotation axis, as [1, 0, 0]</source>
        <translation>écrire la direction de l'axe de rotation, comme [1, 0, 0]</translation>
    </message>
    <message>
        <source>write the letters: { "x": "X", ... }</source>
        <translation>écrire les lettres : { "x": "X", ... }</translation>
    </message>
    <message>
        <source>write the lines</source>
        <translation>écrire les lignes</translation>
    </message>
    <message>
        <source>write the lower limit first</source>
        <translation>écrire d'abord la limite basse</translation>
    </message>
    <message>
        <source>write the orders of operations out, with the setup in the path</source>
        <translation>écrire en entier les ordres des opérations, avec le posage dans le chemin</translation>
    </message>
    <message>
        <source>write the other one of ( and ;, or leave it out</source>
        <translation>écrire l'autre de ( et ;, ou l'omettre</translation>
    </message>
    <message>
        <source>write the part in pieces</source>
        <translation>écrire la pièce en morceaux</translation>
    </message>
    <message>
        <source>write the place in the project that varies, as "operations[Finish].tolerance"</source>
        <translation>écrire l'endroit du projet qui varie, comme "operations[Finish].tolerance"</translation>
    </message>
    <message>
        <source>write the tool's number before it</source>
        <translation>écrire le numéro de l'outil avant</translation>
    </message>
    <message>
        <source>write to another file or folder</source>
        <translation>écrire dans un autre fichier ou dossier</translation>
    </message>
    <message>
        <source>write what the codes mean: { "G0": "rapid", ... }</source>
        <translation>écrire ce que les codes signifient : { "G0": "rapid", ... }</translation>
    </message>
    <message>
        <source>write where the middle of the part's bottom stands</source>
        <translation>écrire où est le milieu du fond de la pièce</translation>
    </message>
    <message>
        <source>write where the values end</source>
        <translation>écrire où les valeurs finissent</translation>
    </message>
    <message>
        <source>write {1}</source>
        <translation>écrire {1}</translation>
    </message>
    <message>
        <source>write {1} and the tool's number</source>
        <translation>écrire {1} et le numéro de l'outil</translation>
    </message>
    <message>
        <source>write {1} at the start</source>
        <translation>écrire {1} au début</translation>
    </message>
    <message>
        <source>write {1} before it</source>
        <translation>écrire {1} avant</translation>
    </message>
    <message>
        <source>write {1} or more</source>
        <translation>écrire {1} ou plus</translation>
    </message>
    <message>
        <source>write {1} or {2}</source>
        <translation>écrire {1} ou {2}</translation>
    </message>
    <message>
        <source>write {1} or {2} at the start</source>
        <translation>écrire {1} ou {2} au début</translation>
    </message>
    <message>
        <source>write {1}/number</source>
        <translation>écrire {1}/numéro</translation>
    </message>
    <message>
        <source>write {1}/x,y,z or {2}/x,y,z,i,j,k</source>
        <translation>écrire {1}/x,y,z ou {2}/x,y,z,i,j,k</translation>
    </message>
    <message>
        <source>write {word}</source>
        <translation>écrire {word}</translation>
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
        <translation>origine</translation>
    </message>
    <message>
        <source>zigzag</source>
        <translation>zigzag</translation>
    </message>
    <message>
        <source>zigzag cuts neighbouring passes to and fro; oneway all in the same direction.</source>
        <translation>zigzag usine les passes voisines en aller et retour ; sens unique toutes dans la même direction.</translation>
    </message>
    <message>
        <source>zigzag cuts open passes whichever way is nearer; oneway always with the part on the right of the travel (climb milling).</source>
        <translation>zigzag usine les passes ouvertes dans le sens le plus proche ; un sens toujours avec la pièce à droite de l'avance (en avalant).</translation>
    </message>
    <message>
        <source>zigzag cuts passes whichever way is nearer; oneway always one way round.</source>
        <translation>zigzag usine les passes dans le sens le plus proche ; sens unique toujours dans le même sens.</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro, and open levels whichever way is nearer; oneway always in the same direction, levels with the part on the right of the travel (climb milling).</source>
        <translation>zigzag usine en va-et-vient, et les niveaux ouverts dans le sens le plus proche ; un sens toujours dans la même direction, les niveaux avec la pièce à droite de l'avance (en avalant).</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro; oneway always cuts in the direction of travel and returns above the part.</source>
        <translation>zigzag usine en aller et retour ; sens unique usine toujours dans le sens de l'avance et revient au-dessus de la pièce.</translation>
    </message>
    <message>
        <source>zigzag cuts to and fro; oneway always cuts in the direction of travel and returns above what stands.</source>
        <translation>zigzag usine en aller et retour ; sens unique usine toujours dans le sens de l'avance et revient au-dessus de ce qui reste.</translation>
    </message>
    <message>
        <source>zigzag cuts whichever way is nearer; oneway always in the same direction and returns above the part.</source>
        <translation>zigzag usine dans le sens le plus proche ; sens unique toujours dans le même sens et revient au-dessus de la pièce.</translation>
    </message>
    <message>
        <source>{1} % of</source>
        <translation>{1} % de</translation>
    </message>
    <message>
        <source>{1} % of the strips stays uncut by up to {2}, as at {3}</source>
        <translation>{1} % des bandes restent non usinés de {2} au plus, comme à {3}</translation>
    </message>
    <message>
        <source>{1} % of the strips stays uncut{2}, as at {3}</source>
        <translation>{1} % des bandes restent non usinés{2}, comme à {3}</translation>
    </message>
    <message>
        <source>{1} % of {2}</source>
        <translation>{1} % de {2}</translation>
    </message>
    <message>
        <source>{1} (line {2})</source>
        <translation>{1} (ligne {2})</translation>
    </message>
    <message>
        <source>{1} ({2} of {3})</source>
        <translation>{1} ({2} sur {3})</translation>
    </message>
    <message>
        <source>{1} and a rest, and they do not look like facets</source>
        <translation>{1} et un reste, et ils ne ressemblent pas à des facettes</translation>
    </message>
    <message>
        <source>{1} and the file ends there</source>
        <translation>{1} et le fichier finit là</translation>
    </message>
    <message>
        <source>{1} and {2} more</source>
        <translation>{1} et {2} autres</translation>
    </message>
    <message>
        <source>{1} and {2} to avoid</source>
        <translation>{1} et {2}, à éviter</translation>
    </message>
    <message>
        <source>{1} arcs</source>
        <translation>{1} arcs</translation>
    </message>
    <message>
        <source>{1} are switched off and not cut</source>
        <translation>{1} sont désactivées et ne sont pas usinées</translation>
    </message>
    <message>
        <source>{1} by {2} ({3})</source>
        <translation>{1} par {2} ({3})</translation>
    </message>
    <message>
        <source>{1} cannot turn about {2}</source>
        <translation>{1} ne peut pas tourner autour de {2}</translation>
    </message>
    <message>
        <source>{1} changes of tools, not in the time.</source>
        <translation>{1} changements d'outil, non compris dans le temps.</translation>
    </message>
    <message>
        <source>{1} collisions, the deepest {2}</source>
        <translation>{1} collisions, la plus profonde de {2}</translation>
    </message>
    <message>
        <source>{1} combinations are too many</source>
        <translation>{1} combinaisons, c'est trop</translation>
    </message>
    <message>
        <source>{1} contact point was left by operations before</source>
        <translation>{1} point de contact a été laissé par des opérations précédentes</translation>
    </message>
    <message>
        <source>{1} contact points were left by operations before</source>
        <translation>{1} points de contact ont été laissés par des opérations précédentes</translation>
    </message>
    <message>
        <source>{1} crashed at it (signal {2})</source>
        <translation>{1} s'y est planté (signal {2})</translation>
    </message>
    <message>
        <source>{1} days</source>
        <translation>{1} jours</translation>
    </message>
    <message>
        <source>{1} does not hold {2} of {3} motions as planned: {4}</source>
        <translation>{1} ne tient pas {2} des {3} mouvements comme prévu : {4}</translation>
    </message>
    <message>
        <source>{1} ends {2} too early</source>
        <translation>{1} finit {2} trop tôt</translation>
    </message>
    <message>
        <source>{1} expected</source>
        <translation>{1} attendu</translation>
    </message>
    <message>
        <source>{1} expected, found '{2}'</source>
        <translation>{1} attendu, trouvé : '{2}'</translation>
    </message>
    <message>
        <source>{1} facets are to be avoided, more than {2}</source>
        <translation>{1} facettes sont à éviter, plus de {2}</translation>
    </message>
    <message>
        <source>{1} facets are too many for connectivity</source>
        <translation>{1} facettes sont trop pour la connectivité</translation>
    </message>
    <message>
        <source>{1} facets are wound inward and were judged from the side that is outside.</source>
        <translation>{1} facettes sont orientées vers l'intérieur et ont été jugées du côté extérieur.</translation>
    </message>
    <message>
        <source>{1} failed at it (status {2})</source>
        <translation>{1} y a échoué (état {2})</translation>
    </message>
    <message>
        <source>{1} files cannot be read</source>
        <translation>les fichiers {1} ne peuvent être lus</translation>
    </message>
    <message>
        <source>{1} h {2} min</source>
        <translation>{1} h {2} min</translation>
    </message>
    <message>
        <source>{1} handed over something else</source>
        <translation>{1} a transmis autre chose</translation>
    </message>
    <message>
        <source>{1} has no table that turns the part about this axis: choose a lathe-mill, or turn the part into its axis</source>
        <translation>{1} n'a pas de table qui tourne la pièce autour de cet axe : choisir un tour-fraiseuse, ou tourner la pièce dans son axe</translation>
    </message>
    <message>
        <source>{1} has said nothing for {2} s and was stopped</source>
        <translation>{1} n'a rien dit pendant {2} s et a été arrêté</translation>
    </message>
    <message>
        <source>{1} has {2} values</source>
        <translation>{1} a {2} valeurs</translation>
    </message>
    <message>
        <source>{1} inclines the tool, and {2} has no rotary axis</source>
        <translation>{1} incline l'outil, et {2} n'a pas d'axe rotatif</translation>
    </message>
    <message>
        <source>{1} is as long as the stock, in which nothing is seen then</source>
        <translation>{1} est aussi long que le brut, où rien n'est alors visible</translation>
    </message>
    <message>
        <source>{1} is missing at its end</source>
        <translation>{1} manque à sa fin</translation>
    </message>
    <message>
        <source>{1} is no number</source>
        <translation>{1} n'est pas un nombre</translation>
    </message>
    <message>
        <source>{1} is no sign</source>
        <translation>{1} n'est pas un signe</translation>
    </message>
    <message>
        <source>{1} is no whole number</source>
        <translation>{1} n'est pas un nombre entier</translation>
    </message>
    <message>
        <source>{1} is not a finite number</source>
        <translation>{1} n'est pas un nombre fini</translation>
    </message>
    <message>
        <source>{1} is not above 0, or too large</source>
        <translation>{1} n'est pas supérieur à 0, ou trop grand</translation>
    </message>
    <message>
        <source>{1} is not carried</source>
        <translation>{1} n'est pas repris</translation>
    </message>
    <message>
        <source>{1} is not carried: offsets have the tool's number</source>
        <translation>{1} n'est pas repris : les correcteurs ont le numéro de l'outil</translation>
    </message>
    <message>
        <source>{1} is switched off and not cut</source>
        <translation>{1} est désactivée et n'est pas usinée</translation>
    </message>
    <message>
        <source>{1} is {2}, at most {3} is allowed</source>
        <translation>{1} est {2}, {3} au plus est permis</translation>
    </message>
    <message>
        <source>{1} is {2}, not a whole number</source>
        <translation>{1} est {2}, pas un nombre entier</translation>
    </message>
    <message>
        <source>{1} jobs of Slurm ended without a result</source>
        <translation>{1} tâches de Slurm ont fini sans résultat</translation>
    </message>
    <message>
        <source>{1} lines per turn leave cusps of {2}; the tolerance allows {3}</source>
        <translation>{1} lignes par tour laissent des crêtes de {2} ; la tolérance permet {3}</translation>
    </message>
    <message>
        <source>{1} lines per turn leave places uncut; the tolerance allows {2}</source>
        <translation>{1} lignes par tour laissent des endroits non usinés ; la tolérance permet {2}</translation>
    </message>
    <message>
        <source>{1} makes {2} rays through the stock, more than {3}</source>
        <translation>{1} fait {2} rayons par le brut, plus de {3}</translation>
    </message>
    <message>
        <source>{1} makes {2} turns in one block, and {3} are the most</source>
        <translation>{1} fait {2} tours dans un bloc, et {3} est le maximum</translation>
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
        <translation>modèle {1}</translation>
    </message>
    <message>
        <source>{1} more collisions are in verify.json.</source>
        <translation>{1} autres collisions sont dans verify.json.</translation>
    </message>
    <message>
        <source>{1} more regions</source>
        <translation>{1} zones de plus</translation>
    </message>
    <message>
        <source>{1} more than {2} drive planes</source>
        <translation>{1} plus de {2} plans directeurs</translation>
    </message>
    <message>
        <source>{1} names no tool</source>
        <translation>{1} ne nomme pas d'outil</translation>
    </message>
    <message>
        <source>{1} needs about {2} GB for the stock, more than {3} GB</source>
        <translation>{1} demande environ {2} Go pour le brut, plus de {3} Go</translation>
    </message>
    <message>
        <source>{1} of the curve lies off the part, as at {2}, and is not followed</source>
        <translation>{1} de la courbe est hors de la pièce, par exemple en {2}, et n’est pas suivi</translation>
    </message>
    <message>
        <source>{1} of the part's area faces no tool axis of the programs (walls, undersides): there only gouges count.</source>
        <translation>{1} de l'aire de la pièce ne regardent aucun axe d'outil des programmes (parois, dessous) : là ne comptent que les entailles.</translation>
    </message>
    <message>
        <source>{1} of the part's area is hidden from all tool axes by other parts of it: there only gouges count.</source>
        <translation>{1} de l'aire de la pièce sont cachés de tous les axes d'outil par d'autres endroits : là ne comptent que les entailles.</translation>
    </message>
    <message>
        <source>{1} of the part's coordinates</source>
        <translation>{1} des coordonnées de la pièce</translation>
    </message>
    <message>
        <source>{1} of the surface</source>
        <translation>{1} de la surface</translation>
    </message>
    <message>
        <source>{1} of the surface ({2}) around {3} turns under so far that only leads above the lead limits reach it, and is not cut: turn the part over and cut it in another setup, or raise the upper lead limit for the whole part</source>
        <translation>{1} de la surface ({2}) autour de {3} rentrent si loin dessous que seules des attaques au-dessus des limites les atteignent, et ne sont pas usinés : retourner la pièce et l'usiner dans un autre posage, ou relever la limite haute pour toute la pièce</translation>
    </message>
    <message>
        <source>{1} of the surface is cleared by neither path{2}</source>
        <translation>{1} de la surface ne sont enlevés par aucun parcours{2}</translation>
    </message>
    <message>
        <source>{1} of the surface is cleared by neither path{2}: use a smaller rework tool</source>
        <translation>{1} de la surface ne sont enlevés par aucun parcours{2} : prendre un outil de reprise plus petit</translation>
    </message>
    <message>
        <source>{1} of the surface is less steep than the slope limits and is left to other operations</source>
        <translation>{1} de la surface sont moins raides que les limites de pente et sont laissés à d'autres opérations</translation>
    </message>
    <message>
        <source>{1} of the surface is steeper than the slope limit and is left to other operations</source>
        <translation>{1} de la surface sont plus raides que la limite de pente et sont laissés à d'autres opérations</translation>
    </message>
    <message>
        <source>{1} of the surface would only be cut by a tip below the lowest level: allow it by 'Below the bottom', where nothing holds the stock there</source>
        <translation>{1} de la surface ne seraient usinés que par une pointe sous le niveau le plus bas : permettez-le par 'Sous le fond', là où rien n'y tient le brut</translation>
    </message>
    <message>
        <source>{1} of what is to be cut is left uncut, up to {2} ({3}), limit {4}</source>
        <translation>{1} de ce qui est à usiner restent non usinés, jusqu'à {2} ({3}), limite {4}</translation>
    </message>
    <message>
        <source>{1} of {2} contact points have no free posture and are left to clean-up; mostly {3}</source>
        <translation>{1} des {2} points de contact n'ont pas de posture libre et sont laissés au nettoyage ; surtout : {3}</translation>
    </message>
    <message>
        <source>{1} of {2} drive planes cross places so steep that no step-over meets the tolerance: cusps of {3} stay there, {4} are allowed</source>
        <translation>{1} des {2} plans directeurs croisent des endroits si raides qu'aucun pas latéral ne tient la tolérance : il y reste des crêtes de {3}, {4} sont permises</translation>
    </message>
    <message>
        <source>{1} of {2} drive planes cross places where no step-over meets the tolerance</source>
        <translation>{1} des {2} plans directeurs croisent des endroits où aucun pas latéral ne tient la tolérance</translation>
    </message>
    <message>
        <source>{1} of {2} passes cross places where no step-over meets the tolerance</source>
        <translation>{1} des {2} passes traversent des endroits où aucun écart ne respecte la tolérance</translation>
    </message>
    <message>
        <source>{1} operations have too many orders</source>
        <translation>{1} opérations ont trop d'ordres</translation>
    </message>
    <message>
        <source>{1} or {2}</source>
        <translation>{1} ou {2}</translation>
    </message>
    <message>
        <source>{1} pieces of the stock, up to {2} long, come off, the first at {3}.</source>
        <translation>{1} morceaux du brut, longs de {2} au plus, se détachent, le premier à {3}.</translation>
    </message>
    <message>
        <source>{1} place is left out that the tool has no room to enter by a ramp or a helix ({2} of cuts), the first at {3}: use a smaller tool, or allow it to plunge</source>
        <translation>{1} endroit est omis où l'outil n'a pas la place d'entrer en rampe ou en hélice ({2} de coupes), le premier à {3} : prendre un outil plus petit, ou lui permettre de plonger</translation>
    </message>
    <message>
        <source>{1} places are left out that the tool has no room to enter by a ramp or a helix ({2} of cuts), the first at {3}: use a smaller tool, or allow it to plunge</source>
        <translation>{1} endroits sont omis où l'outil n'a pas la place d'entrer en rampe ou en hélice ({2} de coupes), le premier à {3} : prendre un outil plus petit, ou lui permettre de plonger</translation>
    </message>
    <message>
        <source>{1} places are left to clean-up because the tool cannot come there from its neighbours without gouging or turning too far</source>
        <translation>{1} endroits sont laissés au nettoyage parce que l'outil n'y vient pas des voisins sans entailler ou trop tourner</translation>
    </message>
    <message>
        <source>{1} program</source>
        <translation>{1} programme</translation>
    </message>
    <message>
        <source>{1} programs</source>
        <translation>{1} programmes</translation>
    </message>
    <message>
        <source>{1} region</source>
        <translation>{1} zone</translation>
    </message>
    <message>
        <source>{1} regions</source>
        <translation>{1} zones</translation>
    </message>
    <message>
        <source>{1} rework</source>
        <translation>{1}, reprise</translation>
    </message>
    <message>
        <source>{1} setups</source>
        <translation>{1} posages</translation>
    </message>
    <message>
        <source>{1} stay uncut: choose a rework tool, or cut them by another operation</source>
        <translation>{1} restent non usinés : choisir un outil de reprise, ou les usiner par une autre opération</translation>
    </message>
    <message>
        <source>{1} swings the tool {2} off its path while it cuts</source>
        <translation>{1} écarte l'outil de {2} de son parcours pendant qu'il coupe</translation>
    </message>
    <message>
        <source>{1} tab, {2}</source>
        <translation>attache, {1}, {2}</translation>
    </message>
    <message>
        <source>{1} that faces up lies under the part itself, as at {2}, and is not cut: turn the part for another operation</source>
        <translation>{1}, tournés vers le haut, sont sous la pièce elle-même, comme à {2}, et ne sont pas usinés : tourner la pièce pour une autre opération</translation>
    </message>
    <message>
        <source>{1} to avoid</source>
        <translation>{1} à éviter</translation>
    </message>
    <message>
        <source>{1} to {2}</source>
        <translation>{1} à {2}</translation>
    </message>
    <message>
        <source>{1} turns the part about the axis of the tool, which nothing inclines</source>
        <translation>{1} tourne la pièce autour de l'axe de l'outil, que rien n'incline</translation>
    </message>
    <message>
        <source>{1} turns the tool about its own axis</source>
        <translation>{1} tourne l'outil autour de son propre axe</translation>
    </message>
    <message>
        <source>{1} values or colours do not fit {2} vertices</source>
        <translation>{1} valeurs ou couleurs ne vont pas avec {2} sommets</translation>
    </message>
    <message>
        <source>{1} would be in the way of all passes, with the clearance</source>
        <translation>{1} : gênerait toutes les passes, avec la distance de sécurité</translation>
    </message>
    <message>
        <source>{1} would be in the way of {2} of the passes, which are left out</source>
        <translation>{1} : gênerait {2} des passes, qui sont omises</translation>
    </message>
    <message>
        <source>{1} would stand at {2}, and its travel is {3} to {4}</source>
        <translation>{1} serait à {2}, et sa course va de {3} à {4}</translation>
    </message>
    <message>
        <source>{1} {2} is not possible</source>
        <translation>{1} {2} n'est pas possible</translation>
    </message>
    <message>
        <source>{1} · no tool yet</source>
        <translation>{1} · encore sans outil</translation>
    </message>
    <message>
        <source>{1} · tool {2}</source>
        <translation>{1} · outil {2}</translation>
    </message>
    <message>
        <source>{1} × {2} pixels</source>
        <translation>{1} × {2} pixels</translation>
    </message>
    <message>
        <source>{1}, GOTO {2}</source>
        <translation>{1}, GOTO {2}</translation>
    </message>
    <message>
        <source>{1}, allowed {2}</source>
        <translation>{1}, permis {2}</translation>
    </message>
    <message>
        <source>{1}, and they do not look like facets</source>
        <translation>{1}, et ils ne ressemblent pas à des facettes</translation>
    </message>
    <message>
        <source>{1}, facet {2}</source>
        <translation>{1}, facette {2}</translation>
    </message>
    <message>
        <source>{1}, its zero in {2}</source>
        <translation>{1}, origine dans {2}</translation>
    </message>
    <message>
        <source>{1}, line {2}</source>
        <translation>{1}, ligne {2}</translation>
    </message>
    <message>
        <source>{1}, operation {2}</source>
        <translation>{1}, opération {2}</translation>
    </message>
    <message>
        <source>{1}, or raise the lead limit</source>
        <translation>{1}, ou relever la limite d'attaque</translation>
    </message>
    <message>
        <source>{1}, pixel {2}, {3}</source>
        <translation>{1}, pixel {2}, {3}</translation>
    </message>
    <message>
        <source>{1}, tool {2}</source>
        <translation>{1}, outil {2}</translation>
    </message>
    <message>
        <source>{1}, vertex {2}</source>
        <translation>{1}, sommet {2}</translation>
    </message>
    <message>
        <source>{1}, with the tip at ({2}, {3}, {4}) {5}; {6} cannot make {7} of {8} motions</source>
        <translation>{1}, la pointe à ({2}, {3}, {4}) {5} ; {6} ne peut faire {7} des {8} mouvements</translation>
    </message>
    <message>
        <source>{1}, {2} to {3} along the axis</source>
        <translation>{1}, de {2} à {3} le long de l'axe</translation>
    </message>
    <message>
        <source>{1}/{2} changes the path</source>
        <translation>{1}/{2} change le parcours</translation>
    </message>
    <message>
        <source>{1}: CUTTER</source>
        <translation>{1} : CUTTER</translation>
    </message>
    <message>
        <source>{1}: linking</source>
        <translation>{1} : liaisons</translation>
    </message>
    <message>
        <source>{1}: main path</source>
        <translation>{1} : parcours principal</translation>
    </message>
    <message>
        <source>{1}: motion {2}</source>
        <translation>{1} : mouvement {2}</translation>
    </message>
    <message>
        <source>{1}: program_number</source>
        <translation>{1} : program_number</translation>
    </message>
    <message>
        <source>{1}: rework path</source>
        <translation>{1} : parcours de reprise</translation>
    </message>
    <message>
        <source>{1}: stock left so far</source>
        <translation>{1} : brut laissé jusqu'ici</translation>
    </message>
    <message>
        <source>{1}: the feed is that of the tip; where an axis is slower, the control slows down.</source>
        <translation>{1} : l'avance est celle de la pointe ; où un axe est plus lent, la commande ralentit.</translation>
    </message>
    <message>
        <source>{1}: the tool goes up {2} times so that rotary axes can turn.</source>
        <translation>{1} : l'outil remonte {2} fois pour que les axes rotatifs puissent tourner.</translation>
    </message>
    <message>
        <source>{1}: {2} of passes, {3} of the surface uncut where the cutter could go</source>
        <translation>{1} : {2} des passes, {3} de la surface non usinés où la fraise pourrait aller</translation>
    </message>
    <message>
        <source>{1}: {2} of passes{3}</source>
        <translation>{1} : {2} des passes{3}</translation>
    </message>
    <message>
        <source>{1}: {2} {3}² ({4} of the surface), where it stays up to {5} away, at {6}: {7}</source>
        <translation>{1} : {2} {3}² ({4} de la surface), où elle reste à {5} au plus, à {6} : {7}</translation>
    </message>
    <message>
        <source>{1}; the deepest gouge that the verification lets pass. auto is a twentieth of the tolerance, but at most 0.01 mm (0.0004 in). At most half the tolerance is used.</source>
        <translation>{1} ; l'entaille la plus profonde que la vérification laisse passer. auto est un vingtième de la tolérance, mais au plus 0,01 mm (0,0004 in). Au plus la moitié de la tolérance est utilisée.</translation>
    </message>
    <message>
        <source>{1}the machine cannot incline the tool like this</source>
        <translation>{1}la machine ne peut incliner l'outil ainsi</translation>
    </message>
    <message>
        <source>{1}° asks for {2} postures at every point</source>
        <translation>{1}° demande {2} postures en chaque point</translation>
    </message>
    <message>
        <source>{1}° is no usable step between postures</source>
        <translation>{1}° n'est pas un pas utilisable entre postures</translation>
    </message>
</context>
<context>
    <name>facetmill</name>
    <message>
        <source>   %1 to the next</source>
        <translation>   %1 jusqu'au suivant</translation>
    </message>
    <message>
        <source>   %1 to the one before</source>
        <translation>   %1 jusqu'au précédent</translation>
    </message>
    <message>
        <source> (%1 to %2)</source>
        <translation> (de %1 à %2)</translation>
    </message>
    <message>
        <source> (preview)</source>
        <translation> (aperçu)</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>%1 % of the surface</source>
        <translation>%1 % de la surface</translation>
    </message>
    <message>
        <source>%1 % of the surface is no steeper than %2°: passes side by side lie far apart there</source>
        <translation>%1 % de la surface ne sont pas plus raides que %2° : des passes côte à côte y sont bien espacées</translation>
    </message>
    <message>
        <source>%1 % of the surface is steeper than %2°: levels go round it</source>
        <translation>%1 % de la surface sont plus raides que %2° : des niveaux en font le tour</translation>
    </message>
    <message>
        <source>%1 % of the surface is steeper than %2°: levels there leave less, passes side by side cut the rest</source>
        <translation>%1 % de la surface sont plus raides que %2° : des niveaux y laissent moins, des passes côte à côte usinent le reste</translation>
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
        <translation>%1 %2, %3 : %4</translation>
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
        <translation>%1 (bibliothèque)</translation>
    </message>
    <message>
        <source>%1 (min)</source>
        <translation>%1 (min)</translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation>%1 (manque)</translation>
    </message>
    <message>
        <source>%1 About %2 on this computer, as long as the project itself took.</source>
        <translation>%1 Environ %2 sur cet ordinateur, d'après ce que le projet lui-même a pris.</translation>
    </message>
    <message>
        <source>%1 CC points</source>
        <translation>%1 points CC</translation>
    </message>
    <message>
        <source>%1 GOTO/s</source>
        <translation>%1 GOTO/s</translation>
    </message>
    <message>
        <source>%1 How long that takes is told here once the project is planned and verified.</source>
        <translation>%1 La durée est dite ici dès que le projet est planifié et vérifié.</translation>
    </message>
    <message>
        <source>%1 It goes on there: scancel ends it.</source>
        <translation>%1 Le travail y continue : scancel y met fin.</translation>
    </message>
    <message>
        <source>%1 Its peak load is %2 times the project's: nothing here knows whether machine and tool stand that.</source>
        <translation>%1 Sa pointe de charge est %2 fois celle du projet : rien ici ne sait si la machine et l’outil la supportent.</translation>
    </message>
    <message>
        <source>%1 Looks that are missing: %2.</source>
        <translation>%1 Examens qui manquent : %2.</translation>
    </message>
    <message>
        <source>%1 Lost: %2 (%3).</source>
        <translation>%1 Perdus : %2 (%3).</translation>
    </message>
    <message>
        <source>%1 Still about %2.</source>
        <translation>%1 Encore %2 environ.</translation>
    </message>
    <message>
        <source>%1 across</source>
        <translation>%1 de large</translation>
    </message>
    <message>
        <source>%1 added to the project</source>
        <translation>Ajout au projet : %1</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>%1 can be read in two ways</source>
        <translation>%1 peut se lire de deux façons</translation>
    </message>
    <message numerus="yes">
        <source>%1 collisions</source>
        <translation><numerusform>%1 collision</numerusform><numerusform>%1 collisions</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>%1 corners</source>
        <translation><numerusform>%1 sommet</numerusform><numerusform>%1 sommets</numerusform></translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>%1 goes after it, with a smaller tool: alone it leaves about %2 % uncut, and %3 % is allowed</source>
        <translation>%1 la suit, avec un outil plus petit : seule, elle laisse environ %2 % non usinés, et %3 % sont permis</translation>
    </message>
    <message>
        <source>%1 goes before it, with %2: the stock stands up to %3 above the part, and the finishing tool comes %4 deep into it</source>
        <translation>%1 la précède, avec %2 : le brut dépasse la pièce de %3 au plus, et l'outil de finition y entre de %4</translation>
    </message>
    <message>
        <source>%1 h left</source>
        <translation>encore %1 h</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1 is missing. It was looked for in %2.</source>
        <translation>Il manque %1. La recherche s'est faite dans %2.</translation>
    </message>
    <message>
        <source>%1 kept as “%2”</source>
        <translation>%1 gardés sous « %2 »</translation>
    </message>
    <message numerus="yes">
        <source>%1 layers</source>
        <translation><numerusform>%1 niveau</numerusform><numerusform>%1 niveaux</numerusform></translation>
    </message>
    <message>
        <source>%1 long</source>
        <translation>%1 de long</translation>
    </message>
    <message>
        <source>%1 min left</source>
        <translation>encore %1 min</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 facets</source>
        <translation><numerusform>%1 facette sur %2</numerusform><numerusform>%1 facettes sur %2</numerusform></translation>
    </message>
    <message>
        <source>%1 of %2 postures free</source>
        <translation>%1 postures libres sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 strips cut</source>
        <translation>%1 bandes usinées sur %2</translation>
    </message>
    <message>
        <source>%1 of 3 points. Click the next one; Esc leaves it.</source>
        <translation>%1 points sur 3. Cliquer le suivant ; Échap annule.</translation>
    </message>
    <message>
        <source>%1 of what is to be cut is left uncut (allowed %2)</source>
        <translation>%1 de ce qui est à usiner reste (permis : %2)</translation>
    </message>
    <message>
        <source>%1 on %2: rotary axes</source>
        <translation>%1 sur %2 : axes rotatifs</translation>
    </message>
    <message>
        <source>%1 on the table within an outline of %2, %3 of the surface faces down, %4 high, falls at %5°. Double click: lay the part on it.</source>
        <translation>%1 sur la table dans un contour de %2, %3 de la surface regarde vers le bas, hauteur %4, bascule à %5°. Double-clic : poser la pièce dessus.</translation>
    </message>
    <message>
        <source>%1 operations are as they were planned: they were kept with the project.</source>
        <translation>%1 opérations sont comme planifiées : elles ont été gardées avec le projet.</translation>
    </message>
    <message>
        <source>%1 programs (*%2);;All files (*)</source>
        <translation>Programmes %1 (*%2);;Tous les fichiers (*)</translation>
    </message>
    <message numerus="yes">
        <source>%1 regions</source>
        <translation><numerusform>%1 zone</numerusform><numerusform>%1 zones</numerusform></translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>encore %1 s</translation>
    </message>
    <message>
        <source>%1 setups as one job</source>
        <translation>%1 posages en un seul travail</translation>
    </message>
    <message>
        <source>%1 setups as one job, as posted, %2 blocks</source>
        <translation>%1 posages en un seul travail, tels que post-traités, %2 blocs</translation>
    </message>
    <message numerus="yes">
        <source>%1 smaller ones</source>
        <translation><numerusform>%1 plus petit</numerusform><numerusform>%1 plus petits</numerusform></translation>
    </message>
    <message>
        <source>%1 strips, all of them cut</source>
        <translation>%1 bandes, toutes usinées</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 to %2: %3</source>
        <translation>%1 à %2 : %3</translation>
    </message>
    <message numerus="yes">
        <source>%1 tools</source>
        <translation><numerusform>%1 outil</numerusform><numerusform>%1 outils</numerusform></translation>
    </message>
    <message>
        <source>%1 was added to the project in place of %2 (switched off). Undo takes it back.</source>
        <translation>%1 a été ajoutée au projet à la place de %2 (désactivée). « Annuler » la retire.</translation>
    </message>
    <message>
        <source>%1 was added to the project. Undo takes it away.</source>
        <translation>%1 a été ajouté au projet. Annuler le retire.</translation>
    </message>
    <message>
        <source>%1 wide, %2 long</source>
        <translation>%1 de large, %2 de long</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1, %2 % of the surface</source>
        <translation>%1, %2 % de la surface</translation>
    </message>
    <message>
        <source>%1, %2 of them passed</source>
        <translation>%1, dont réussis : %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %2 passes</source>
        <translation><numerusform>%1, %2 passe</numerusform><numerusform>%1, %2 passes</numerusform></translation>
    </message>
    <message>
        <source>%1, %2: choose at least one value.</source>
        <translation>%1, %2 : choisir au moins une valeur.</translation>
    </message>
    <message>
        <source>%1, at most %2</source>
        <translation>%1, au plus %2</translation>
    </message>
    <message>
        <source>%1, or a Facetmill project</source>
        <translation>%1 ou un projet Facetmill</translation>
    </message>
    <message>
        <source>%1, up to %2</source>
        <translation>%1, jusqu'à %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>%1: %2 rpm, %3 %4</source>
        <translation>%1 : %2 tr/min, %3 %4</translation>
    </message>
    <message>
        <source>%1: %2 times what the project comes to</source>
        <translation>%1 : %2 fois ce à quoi le projet arrive</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1 : %2. %3</translation>
    </message>
    <message>
        <source>%1: a double click goes there</source>
        <translation>%1 : un double-clic y va</translation>
    </message>
    <message>
        <source>%1: a region that operations cut within or keep off</source>
        <translation>%1 : une zone où les opérations usinent ou qu'elles évitent</translation>
    </message>
    <message>
        <source>%1: lead %2, yaw %3, lift %4</source>
        <translation>%1 : attaque %2, lacet %3, levée %4</translation>
    </message>
    <message>
        <source>%1: machine and stock</source>
        <translation>%1 : machine et brut</translation>
    </message>
    <message>
        <source>%1: no tool comes nearer than %2</source>
        <translation>%1 : aucun outil n'approche à moins de %2</translation>
    </message>
    <message>
        <source>%1: shown, planned and verified now</source>
        <translation>%1 : affiché, planifié et vérifié maintenant</translation>
    </message>
    <message>
        <source>%1: step-over along the part</source>
        <translation>%1 : pas latéral le long de la pièce</translation>
    </message>
    <message>
        <source>%1; %2 facets, %3.</source>
        <translation>%1 ; %2 facettes, %3.</translation>
    </message>
    <message>
        <source>%1° from X</source>
        <translation>%1° depuis X</translation>
    </message>
    <message>
        <source>%1°: %2 % is steep</source>
        <translation>%1° : %2 % est raide</translation>
    </message>
    <message numerus="yes">
        <source>%n more</source>
        <translation><numerusform>%n autre</numerusform><numerusform>%n autres</numerusform></translation>
    </message>
    <message>
        <source>&amp;About Facetmill</source>
        <translation>À &amp;propos de Facetmill</translation>
    </message>
    <message>
        <source>&amp;Add to project</source>
        <translation>&amp;Ajouter au projet</translation>
    </message>
    <message>
        <source>&amp;Adopt</source>
        <translation>Ado&amp;pter</translation>
    </message>
    <message>
        <source>&amp;As the other holes</source>
        <translation>Comme les &amp;autres trous</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>A&amp;vant</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Parcourir…</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>&amp;Close program</source>
        <translation>&amp;Fermer le programme</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>Cou&amp;leurs</translation>
    </message>
    <message>
        <source>&amp;Control</source>
        <translation>&amp;Commande</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>&amp;Deviation…</source>
        <translation>&amp;Écart…</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>A&amp;bandonner</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Édition</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exporter</translation>
    </message>
    <message>
        <source>&amp;Export programs…</source>
        <translation>Expor&amp;ter les programmes…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>&amp;Feeds and speeds</source>
        <translation>&amp;Avances et vitesses</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;First job, step by step</source>
        <translation>Premier &amp;travail, pas à pas</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Cadrer</translation>
    </message>
    <message>
        <source>&amp;Flat</source>
        <translation>&amp;Plat</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>&amp;Dossier</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Holder, from the shank upward</source>
        <translation>&amp;Porte-outil, en remontant depuis la queue</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>&amp;Inches</source>
        <translation>&amp;Pouces</translation>
    </message>
    <message>
        <source>&amp;Keep project’s tools</source>
        <translation>&amp;Garder les outils du projet</translation>
    </message>
    <message>
        <source>&amp;Keep unsaved work every</source>
        <translation>&amp;Garder le travail non enregistré toutes les</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Clavier et souris</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>&amp;Leave open</source>
        <translation>Laisser &amp;ouvert</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>&amp;Locate missing file…</source>
        <translation>Localiser un fichier manq&amp;uant…</translation>
    </message>
    <message>
        <source>&amp;Machine</source>
        <translation>&amp;Machine</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Millimetres</source>
        <translation>&amp;Millimètres</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>&amp;New study</source>
        <translation>&amp;Nouvelle étude</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>&amp;Pas maintenant</translation>
    </message>
    <message>
        <source>&amp;Open study…</source>
        <translation>&amp;Ouvrir une étude…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>&amp;Part…</source>
        <translation>&amp;Pièce…</translation>
    </message>
    <message>
        <source>&amp;Plan</source>
        <translation>&amp;Planifier</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>&amp;Restaurer</translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Scan room…</source>
        <translation>Atelier de &amp;scan…</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>&amp;Lissé</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>&amp;Stock…</source>
        <translation>&amp;Brut…</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>A&amp;rrêter</translation>
    </message>
    <message>
        <source>&amp;Tilt from upright</source>
        <translation>&amp;Inclinaison par rapport à la verticale</translation>
    </message>
    <message>
        <source>&amp;Turning</source>
        <translation>&amp;Rotation</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Unpack</source>
        <translation>Déco&amp;mpresser</translation>
    </message>
    <message>
        <source>&amp;Verify</source>
        <translation>&amp;Vérifier</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Wire</source>
        <translation>&amp;Filaire</translation>
    </message>
    <message>
        <source>'%1'</source>
        <comment>a name in a message</comment>
        <translation>« %1 »</translation>
    </message>
    <message>
        <source>,  .</source>
        <translation>,  .</translation>
    </message>
    <message>
        <source>, %1 deep</source>
        <translation>, %1 de profondeur</translation>
    </message>
    <message>
        <source>, %1 deep; at most %2 would stay above the allowance</source>
        <translation>, %1 de profondeur ; au plus %2 resterait au-dessus de la surépaisseur</translation>
    </message>
    <message>
        <source>, %1 switched off</source>
        <translation>, %1 désactivés</translation>
    </message>
    <message>
        <source>, GOTO %1</source>
        <translation>, GOTO %1</translation>
    </message>
    <message>
        <source>, facet %1</source>
        <translation>, facette %1</translation>
    </message>
    <message>
        <source>, holders for the dialog of a tool: %1</source>
        <translation>, porte-outils pour le dialogue d'un outil : %1</translation>
    </message>
    <message>
        <source>, into the fixture '%1'</source>
        <translation>, dans le bridage « %1 »</translation>
    </message>
    <message>
        <source>, into the part</source>
        <translation>, dans la pièce</translation>
    </message>
    <message>
        <source>, lift %1</source>
        <translation>, levée %1</translation>
    </message>
    <message>
        <source>. Stick-out: %1; the part needs %2</source>
        <translation>. Sortie : %1 ; la pièce demande %2</translation>
    </message>
    <message>
        <source>0 … 6</source>
        <translation>0 … 6</translation>
    </message>
    <message>
        <source>0° is upright, 90° level, 180° from below</source>
        <translation>0° : vertical, 90° : horizontal, 180° : par dessous</translation>
    </message>
    <message>
        <source>1 strip, cut</source>
        <translation>1 bande, usinée</translation>
    </message>
    <message>
        <source>1 strip, switched off</source>
        <translation>1 bande, désactivée</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>; </source>
        <comment>between clauses</comment>
        <translation> ; </translation>
    </message>
    <message>
        <source>; at most %1 stays above the allowance</source>
        <translation> ; au plus %1 reste au-dessus de la surépaisseur</translation>
    </message>
    <message>
        <source>; it does not fit in %1 places, which the log has. </source>
        <translation> ; elle ne convient pas à %1 endroits, que le journal indique. </translation>
    </message>
    <message>
        <source>; it does not fit in one place. </source>
        <translation> ; elle ne convient pas à un endroit. </translation>
    </message>
    <message>
        <source>; lowest lift %1, highest %2</source>
        <translation> ; levée la plus basse %1, la plus haute %2</translation>
    </message>
    <message>
        <source>; not carried:</source>
        <translation> ; non repris :</translation>
    </message>
    <message>
        <source>; rework covers %1 of the surface</source>
        <translation> ; la reprise couvre %1 de la surface</translation>
    </message>
    <message>
        <source>; the path is out of date: plan again</source>
        <translation> ; le parcours est périmé : planifier de nouveau</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; holds %2 facets and does not say in which unit. How large is the part?</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; contient %2 facettes et n'indique pas l'unité. Quelle est la taille de la pièce ?</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; is a packed project. It is unpacked into a folder of its own and opened from there; the packed file stays as it is.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; est un projet compressé. Il est décompressé dans un dossier à lui et ouvert de là ; le fichier compressé reste tel quel.</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Facetmill %1&lt;/h3&gt;&lt;p&gt;Plans tool paths on triangle meshes.&lt;/p&gt;&lt;p&gt;Built with Qt %2, VTK, Eigen, OpenMesh and oneTBB.&lt;br&gt;Licensed under the Apache License 2.0.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Facetmill %1&lt;/h3&gt;&lt;p&gt;Planifie des parcours d'outil sur des maillages de triangles.&lt;/p&gt;&lt;p&gt;Construit avec Qt %2, VTK, Eigen, OpenMesh et oneTBB.&lt;br&gt;Sous licence Apache 2.0.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A bar per candidate, as high as its machining time, in a strip for each stage of the study</source>
        <translation>Une barre par candidat, haute comme son temps d'usinage, dans une bande pour chaque étape de l'étude</translation>
    </message>
    <message>
        <source>A closed curve has three corners or more: click on the part.</source>
        <translation>Une courbe fermée a trois sommets ou plus : cliquer sur la pièce.</translation>
    </message>
    <message>
        <source>A fast main path with five axes, and a smaller tool for the regions it leaves</source>
        <translation>Un parcours principal rapide en cinq axes, et un outil plus petit pour les zones qu'il laisse</translation>
    </message>
    <message>
        <source>A helix, rings or lengthwise lines over a part that turns</source>
        <translation>Une hélice, des anneaux ou des lignes en long sur une pièce qui tourne</translation>
    </message>
    <message>
        <source>A line per candidate across an axis for everything that varies and for measures; a drag along an axis keeps a range of it</source>
        <translation>Une ligne par candidat à travers un axe pour tout ce qui varie et pour les mesures ; glisser le long d'un axe en garde une plage</translation>
    </message>
    <message>
        <source>A new study of this project</source>
        <translation>Une nouvelle étude de ce projet</translation>
    </message>
    <message>
        <source>A number for all sides or three with blanks between them (x, y, z), %1; a semicolon between one value and the next</source>
        <translation>Un nombre pour tous les côtés ou trois séparés par des espaces (x, y, z), %1 ; un point-virgule entre une valeur et la suivante</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before programs are written.</source>
        <translation>Un paramètre n'est pas valable : le corriger avant d'écrire les programmes.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the project is packed.</source>
        <translation>Un paramètre n'est pas valable : le corriger avant de compresser le projet.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the project is saved.</source>
        <translation>Un paramètre n'est pas valable : le corriger avant d'enregistrer le projet.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the setup sheet is written.</source>
        <translation>Un paramètre n'est pas valable : le corriger avant d'écrire la fiche de réglage.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it before the unit is changed.</source>
        <translation>Un paramètre n'est pas valable : le corriger avant de changer d'unité.</translation>
    </message>
    <message>
        <source>A parameter is not valid: correct it, then plan.</source>
        <translation>Un paramètre n'est pas valable : le corriger, puis planifier.</translation>
    </message>
    <message>
        <source>A program from a file, shown in place of the plan.</source>
        <translation>Un programme lu d'un fichier, affiché à la place du plan.</translation>
    </message>
    <message>
        <source>A program is shown over its part: open the project or the mesh first, then drop the program.</source>
        <translation>Un programme s'affiche sur sa pièce : ouvrir d'abord le projet ou le maillage, puis déposer le programme.</translation>
    </message>
    <message>
        <source>A setup sheet begins with the verdict of the verification. Press Verify (F6) first.</source>
        <translation>Une fiche de réglage commence par le verdict de la vérification. Vérifier d'abord (F6).</translation>
    </message>
    <message>
        <source>A step of its own: goes on as the surface around bends</source>
        <translation>Une étape à part : continue la courbure de la surface autour</translation>
    </message>
    <message>
        <source>A step of its own: it stays open whatever the others say</source>
        <translation>Une étape à part : il reste ouvert quoi que disent les autres</translation>
    </message>
    <message>
        <source>A step of its own: takes the least area</source>
        <translation>Une étape à part : prend le moins d'aire</translation>
    </message>
    <message>
        <source>A study works on the project as it is saved: save it first.</source>
        <translation>Une étude travaille sur le projet tel qu'il est enregistré : enregistrez-le d'abord.</translation>
    </message>
    <message>
        <source>A value is not valid</source>
        <translation>Une valeur n'est pas valable</translation>
    </message>
    <message>
        <source>A+</source>
        <translation>A+</translation>
    </message>
    <message>
        <source>About %1, by a preview of its passes</source>
        <translation>Environ %1, d’après un aperçu des passes</translation>
    </message>
    <message>
        <source>About %1; leaves at most %2 on 99 % of the surface, and %3 % of it uncut</source>
        <translation>Environ %1 ; laisse au plus %2 sur 99 % de la surface, dont %3 % non usinés</translation>
    </message>
    <message>
        <source>About Facetmill</source>
        <translation>À propos de Facetmill</translation>
    </message>
    <message>
        <source>Above the view: what comes next, ticked off as it is done</source>
        <translation>Au-dessus de la vue : ce qui vient ensuite, coché à mesure</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Add &amp;%1</source>
        <translation>Ajouter &amp;%1</translation>
    </message>
    <message>
        <source>Add Rough before it: the stock stands up to %1 above the part, and the tool comes %2 deep into it.</source>
        <translation>Ajouter Ébauche avant : le brut dépasse la pièce de %1 au plus, et l'outil y entre de %2.</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Ajouter une matière</translation>
    </message>
    <message>
        <source>Add a section above the others</source>
        <translation>Ajouter une section au-dessus des autres</translation>
    </message>
    <message>
        <source>Add a step behind the chosen one</source>
        <translation>Ajouter une étape derrière celle choisie</translation>
    </message>
    <message>
        <source>Add a tool below the tree; a double click edits one.</source>
        <translation>Ajouter un outil sous l'arbre ; un double-clic en modifie un.</translation>
    </message>
    <message>
        <source>Add an operation below the tree. They run from top to bottom.</source>
        <translation>Ajouter une opération sous l'arbre. Elles s'exécutent de haut en bas.</translation>
    </message>
    <message>
        <source>Add an operation, a tool, a fixture, a boundary or a setup</source>
        <translation>Ajouter une opération, un outil, un bridage, une limite ou un posage</translation>
    </message>
    <message>
        <source>Add boundary</source>
        <translation>Ajouter une limite</translation>
    </message>
    <message>
        <source>Add fixture</source>
        <translation>Ajouter un bridage</translation>
    </message>
    <message>
        <source>Add operation</source>
        <translation>Ajouter une opération</translation>
    </message>
    <message>
        <source>Add setup</source>
        <translation>Ajouter un posage</translation>
    </message>
    <message>
        <source>Add this operation to the project; undo takes it away again</source>
        <translation>Ajouter cette opération au projet ; Annuler la retire</translation>
    </message>
    <message>
        <source>Add tool</source>
        <translation>Ajouter un outil</translation>
    </message>
    <message>
        <source>Add tools of the library</source>
        <translation>Ajouter des outils de la bibliothèque</translation>
    </message>
    <message>
        <source>Add tool…</source>
        <translation>Ajouter un outil…</translation>
    </message>
    <message>
        <source>Adopt candidate %1</source>
        <translation>Adopter le candidat %1</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>Af&amp;ter</source>
        <translation>Aprè&amp;s</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Après</translation>
    </message>
    <message>
        <source>Against neighbours</source>
        <translation>Contre les voisines</translation>
    </message>
    <message>
        <source>Align edge with X</source>
        <translation>Aligner l'arête sur X</translation>
    </message>
    <message>
        <source>All candidates as a table (CSV)</source>
        <translation>Tous les candidats en tableau (CSV)</translation>
    </message>
    <message>
        <source>All chapters</source>
        <translation>Tous les chapitres</translation>
    </message>
    <message>
        <source>All facets up to sharp edges, as a boundary for operations</source>
        <translation>Toutes les facettes jusqu'aux arêtes vives, comme limite pour les opérations</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>All motions of all operations</source>
        <translation>Tous les mouvements de toutes les opérations</translation>
    </message>
    <message>
        <source>All of it is switched off below the view</source>
        <translation>Tout est désactivé sous la vue</translation>
    </message>
    <message>
        <source>All operations are switched off: switch one on in its menu.</source>
        <translation>Toutes les opérations sont désactivées : en activer une par son menu.</translation>
    </message>
    <message>
        <source>All others</source>
        <translation>Tous les autres</translation>
    </message>
    <message>
        <source>All setups are planned.</source>
        <translation>Tous les posages sont planifiés.</translation>
    </message>
    <message>
        <source>Alone it does not pass the verification: %1</source>
        <translation>Seule, elle ne passe pas la vérification : %1</translation>
    </message>
    <message>
        <source>Along the axis (%1)</source>
        <translation>Le long de l'axe (%1)</translation>
    </message>
    <message>
        <source>Alt+1 … Alt+0</source>
        <translation>Alt+1 … Alt+0</translation>
    </message>
    <message>
        <source>An unknown exception ended the job</source>
        <translation>Une exception inconnue a terminé le travail</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation>Angle (°)</translation>
    </message>
    <message>
        <source>Another boundary has this name</source>
        <translation>Une autre limite a ce nom</translation>
    </message>
    <message>
        <source>Another fixture has this name</source>
        <translation>Un autre bridage a ce nom</translation>
    </message>
    <message>
        <source>Another operation has this name</source>
        <translation>Une autre opération a ce nom</translation>
    </message>
    <message>
        <source>Another setup has this name</source>
        <translation>Un autre posage a ce nom</translation>
    </message>
    <message>
        <source>Another setup is shown. A double click in the tree goes to this one.</source>
        <translation>Un autre posage est affiché. Un double-clic dans l'arbre va à celui-ci.</translation>
    </message>
    <message>
        <source>Appl&amp;y</source>
        <translation>Appli&amp;quer</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Apply &amp;template</source>
        <translation>&amp;Appliquer un modèle</translation>
    </message>
    <message>
        <source>Apply template</source>
        <translation>Appliquer un modèle</translation>
    </message>
    <message>
        <source>Area (%1)</source>
        <translation>Aire (%1)</translation>
    </message>
    <message>
        <source>Area of the part that lies on the table</source>
        <translation>Aire de la pièce posée sur la table</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Co&amp;mme le système</translation>
    </message>
    <message>
        <source>As the file is</source>
        <translation>Tel que le fichier</translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 holes are filled.</source>
        <translation><numerusform>Tel que le fichier, %1 trou sur %2 est rempli.</numerusform><numerusform>Tel que le fichier, %1 trous sur %2 sont remplis.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>As the file is, %1 of %2 pieces go.</source>
        <translation><numerusform>Tel que le fichier, %1 morceau sur %2 part.</numerusform><numerusform>Tel que le fichier, %1 morceaux sur %2 partent.</numerusform></translation>
    </message>
    <message>
        <source>As the part lies</source>
        <translation>Comme la pièce est posée</translation>
    </message>
    <message>
        <source>As the workbench showed it</source>
        <translation>Tel que l'atelier l'a montré</translation>
    </message>
    <message>
        <source>Ask anew, from the project as it is now</source>
        <translation>Demander à nouveau, à partir du projet tel qu'il est</translation>
    </message>
    <message>
        <source>At %1: </source>
        <translation>À %1 : </translation>
    </message>
    <message>
        <source>At a point</source>
        <translation>En un point</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>At most: %1</source>
        <translation>Au plus : %1</translation>
    </message>
    <message>
        <source>At once</source>
        <translation>À la fois</translation>
    </message>
    <message>
        <source>At which height of the box the zero is</source>
        <translation>À quelle hauteur de la boîte se trouve l'origine</translation>
    </message>
    <message>
        <source>Axes over path</source>
        <translation>Axes le long du parcours</translation>
    </message>
    <message>
        <source>Axes over time</source>
        <translation>Axes dans le temps</translation>
    </message>
    <message>
        <source>A−</source>
        <translation>A−</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Revenir à la valeur par défaut</translation>
    </message>
    <message>
        <source>Ball end</source>
        <translation>Hémisphérique</translation>
    </message>
    <message>
        <source>Before planning: %1. As planned, where the paths were looked at: %2, %3 %</source>
        <translation>Avant la planification : %1. Comme planifié, où les parcours ont été examinés : %2, %3 %</translation>
    </message>
    <message>
        <source>Being planned</source>
        <translation>En cours de planification</translation>
    </message>
    <message>
        <source>Best first</source>
        <translation>Meilleures d'abord</translation>
    </message>
    <message>
        <source>Best: the least surface that faces the table, where no tool from above comes to, the most that lies on it, and a firm stand. Largest: the most area on the table.</source>
        <translation>Meilleures : le moins de surface vers la table, qu'aucun outil n'atteint d'en haut, le plus d'appui et une assise stable. Plus grandes : le plus de surface sur la table.</translation>
    </message>
    <message>
        <source>Blender</source>
        <translation>Blender</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Boundary of a face</source>
        <translation>Limite d'une face</translation>
    </message>
    <message>
        <source>Boundary of this face</source>
        <translation>Limite de cette face</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>Pinceau</translation>
    </message>
    <message>
        <source>Bull nose</source>
        <translation>Torique</translation>
    </message>
    <message>
        <source>By Wang's (1) a tool of up to D %1 matches all but 5 % of the hollow places at this limit.</source>
        <translation>D'après Wang (1), un outil jusqu'à D %1 convient à tous les creux sauf 5 % avec cette limite.</translation>
    </message>
    <message>
        <source>By a value</source>
        <translation>D'une valeur</translation>
    </message>
    <message>
        <source>By how much</source>
        <translation>De combien</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>C&amp;ouleurs</translation>
    </message>
    <message>
        <source>CC</source>
        <translation>CC</translation>
    </message>
    <message>
        <source>CC points</source>
        <translation>Points CC</translation>
    </message>
    <message>
        <source>CL cuts</source>
        <translation>Coupes CL</translation>
    </message>
    <message>
        <source>CL points</source>
        <translation>Points CL</translation>
    </message>
    <message>
        <source>CM²</source>
        <translation>CM²</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Annulé.</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Annulation…</translation>
    </message>
    <message>
        <source>Candidate %1</source>
        <translation>Candidat %1</translation>
    </message>
    <message>
        <source>Candidate %1 is the project now. Undo takes it back.</source>
        <translation>Le candidat %1 est maintenant le projet. Annuler revient en arrière.</translation>
    </message>
    <message>
        <source>Candidate %1 is the project now; what was changed since the study began is as it was then. Undo takes it back.</source>
        <translation>Le candidat %1 est maintenant le projet ; ce qui a changé depuis le début de l'étude est comme alors. Annuler revient en arrière.</translation>
    </message>
    <message>
        <source>Candidate %1 wins: %2 of machining, against %3 of the project as it stands.</source>
        <translation>Le candidat %1 gagne : %2 d'usinage, contre %3 pour le projet tel quel.</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidats</translation>
    </message>
    <message>
        <source>Candidates by two measures; a line joins those that no other surpasses</source>
        <translation>Candidats selon deux mesures ; une ligne joint ceux qu'aucun autre ne surpasse</translation>
    </message>
    <message>
        <source>Candidates that are worked on at once; what comes out does not depend on it</source>
        <translation>Candidats traités à la fois ; le résultat n'en dépend pas</translation>
    </message>
    <message>
        <source>Candidates: %1 to plan, about %2 to judge coarsely and %3 finely.</source>
        <translation>Candidats : %1 à planifier, environ %2 à juger grossièrement et %3 finement.</translation>
    </message>
    <message>
        <source>Cannot be judged</source>
        <translation>Impossible à juger</translation>
    </message>
    <message>
        <source>Cannot be judged: %1</source>
        <translation>Impossible à juger : %1</translation>
    </message>
    <message>
        <source>Carries the recipe out and shows what it would make; the project stays as it is</source>
        <translation>Exécute la recette et montre ce qu'elle ferait ; le projet reste tel quel</translation>
    </message>
    <message>
        <source>Carry the step out earlier</source>
        <translation>Exécuter l'étape plus tôt</translation>
    </message>
    <message>
        <source>Carry the step out later</source>
        <translation>Exécuter l'étape plus tard</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Centimètres</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Centre part</source>
        <translation>Centrer la pièce</translation>
    </message>
    <message>
        <source>Change kind of boundary</source>
        <translation>Changer le type de limite</translation>
    </message>
    <message>
        <source>Change unit</source>
        <translation>Changer d'unité</translation>
    </message>
    <message>
        <source>Chart</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Charts</source>
        <translation>Diagrammes</translation>
    </message>
    <message>
        <source>Choose a candidate in a picture or in the table</source>
        <translation>Choisir un candidat dans une image ou dans le tableau</translation>
    </message>
    <message>
        <source>Choose a candidate in a picture or in the table.</source>
        <translation>Choisir un candidat dans une image ou dans le tableau.</translation>
    </message>
    <message>
        <source>Choose a folder that is there</source>
        <translation>Choisir un dossier existant</translation>
    </message>
    <message>
        <source>Choose fixture</source>
        <translation>Choisir un bridage</translation>
    </message>
    <message>
        <source>Choose mesh…</source>
        <translation>Choisir un maillage…</translation>
    </message>
    <message>
        <source>Choose stock</source>
        <translation>Choisir le brut</translation>
    </message>
    <message>
        <source>Choose the control in Machine; Ctrl+E writes one program an operation.</source>
        <translation>Choisir la commande dans Machine ; Ctrl+E écrit un programme par opération.</translation>
    </message>
    <message>
        <source>Choose the folder in which the new one is made</source>
        <translation>Choisir le dossier où le nouveau est créé</translation>
    </message>
    <message>
        <source>Choose the tool and its values in the form; + adds Rough before Finish.</source>
        <translation>Choisir l'outil et ses valeurs dans le formulaire ; + ajoute l'ébauche avant la finition.</translation>
    </message>
    <message>
        <source>Choosing layers</source>
        <translation>Choix des niveaux</translation>
    </message>
    <message>
        <source>Clamp over the edge</source>
        <translation>Bride sur l'arête</translation>
    </message>
    <message>
        <source>Clean-up</source>
        <translation>Nettoyage</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Clear %1</source>
        <translation>Vider %1</translation>
    </message>
    <message>
        <source>Clear painted facets</source>
        <translation>Effacer les facettes peintes</translation>
    </message>
    <message>
        <source>Clearance moves at rapid speed</source>
        <translation>Mouvements de dégagement en rapide</translation>
    </message>
    <message>
        <source>Click a face of the part: the tool will stand upright on it. Ctrl+click takes the direction that you look along. Esc leaves it.</source>
        <translation>Cliquer une face de la pièce : l'outil s'y tiendra perpendiculaire. Ctrl+clic prend la direction du regard. Échap annule.</translation>
    </message>
    <message>
        <source>Click a flat face of the part: it comes down to Z 0</source>
        <translation>Cliquer une face plane de la pièce : elle descend à Z 0</translation>
    </message>
    <message>
        <source>Click a point of the part for the work zero; a corner nearby is taken exactly. Esc leaves it.</source>
        <translation>Cliquer un point de la pièce pour l'origine ; un sommet proche est pris exactement. Échap annule.</translation>
    </message>
    <message>
        <source>Click a point of the part for the zero; a corner nearby is taken exactly</source>
        <translation>Cliquer un point de la pièce pour l'origine ; un sommet proche est pris exactement</translation>
    </message>
    <message>
        <source>Click a point of the part for “%1”; a corner nearby is taken exactly. Ctrl+click takes the middle of the flat face there. Esc leaves it.</source>
        <translation>Cliquer un point de la pièce pour « %1 » ; un sommet proche est pris exactement. Ctrl+clic prend le milieu de la face plane à cet endroit. Échap annule.</translation>
    </message>
    <message>
        <source>Click beside an edge of the part: the part turns about Z until the edge runs along X</source>
        <translation>Cliquer à côté d'une arête de la pièce : elle tourne autour de Z jusqu'à ce que l'arête suive X</translation>
    </message>
    <message>
        <source>Click into a round hole, on a boss, or beside a hole on its flat face. Esc leaves it.</source>
        <translation>Cliquer dans un trou rond, sur un bossage ou à côté d'un trou sur sa face plane. Échap annule.</translation>
    </message>
    <message>
        <source>Click into a round hole, on a boss, or beside a hole on its flat face: the zero comes to its axis, at its upper end</source>
        <translation>Cliquer dans un trou rond, sur un bossage ou à côté d'un trou sur sa face plane : l'origine vient sur son axe, à son extrémité supérieure</translation>
    </message>
    <message>
        <source>Click on a path</source>
        <translation>Cliquer sur un parcours</translation>
    </message>
    <message>
        <source>Click on a strip, here or in the view.</source>
        <translation>Cliquer sur une bande, ici ou dans la vue.</translation>
    </message>
    <message>
        <source>Click on the part beside the edge that is to run along X. Esc leaves it.</source>
        <translation>Cliquer sur la pièce à côté de l'arête qui doit suivre X. Échap annule.</translation>
    </message>
    <message>
        <source>Click or drag: the tool goes there. Arrows: along the path. Wheel: zoom. Right drag: move. Double click, Home: all.</source>
        <translation>Cliquer ou tirer : l'outil y va. Flèches : le long du parcours. Molette : zoom. Tirer à droite : déplacer. Double-clic, Début : tout.</translation>
    </message>
    <message>
        <source>Click or drag: the tool goes there. Wheel: zoom (Ctrl: the upright axis). Right drag: move.</source>
        <translation>Cliquer ou tirer : l'outil y va. Molette : zoom (Ctrl : axe vertical). Tirer à droite : déplacer.</translation>
    </message>
    <message>
        <source>Click the flat face that the part is to lie on. Esc leaves it.</source>
        <translation>Cliquer la face plane sur laquelle la pièce doit reposer. Échap annule.</translation>
    </message>
    <message>
        <source>Click three points of the part, one after the other, that are to be down; a corner nearby is taken exactly. Esc leaves it.</source>
        <translation>Cliquer l'un après l'autre trois points de la pièce qui doivent être en bas ; un sommet proche est pris exactement. Échap annule.</translation>
    </message>
    <message>
        <source>Click three points of the part: their plane comes down to Z 0</source>
        <translation>Cliquer trois points de la pièce : leur plan descend à Z 0</translation>
    </message>
    <message>
        <source>Click two points of the part; corners nearby are taken exactly. Esc ends measuring.</source>
        <translation>Cliquer deux points de la pièce ; les sommets proches sont pris exactement. Échap termine la mesure.</translation>
    </message>
    <message>
        <source>Click: shown in the view</source>
        <translation>Clic : montré dans la vue</translation>
    </message>
    <message>
        <source>Click: shown in the view. Double click: laid on it.</source>
        <translation>Clic : montrée dans la vue. Double-clic : pièce posée dessus.</translation>
    </message>
    <message>
        <source>Click: shown in the view. Right click: how it is filled</source>
        <translation>Clic : montré dans la vue. Clic droit : comment il est rempli</translation>
    </message>
    <message>
        <source>Click: the view goes there. Check mark: whether the strip is cut.</source>
        <translation>Clic : la vue y va. Coche : si la bande est usinée.</translation>
    </message>
    <message>
        <source>Clicks on the part add corners; a double click or Enter closes the curve, Backspace takes the last corner back. Corners of a closed one can be dragged. Esc ends it.</source>
        <translation>Les clics sur la pièce ajoutent des sommets ; un double-clic ou Entrée ferme la courbe, Retour arrière reprend le dernier sommet. Les sommets d'une courbe fermée se tirent. Échap termine.</translation>
    </message>
    <message>
        <source>Closed curve</source>
        <translation>Courbe fermée</translation>
    </message>
    <message>
        <source>Closed curves of open edges; the rim of an open sheet is one of them. A click goes to one.</source>
        <translation>Courbes fermées d'arêtes ouvertes ; le bord d'une feuille ouverte en est une. Un clic va à l'une d'elles.</translation>
    </message>
    <message>
        <source>Closes holes up to a diameter; nothing else changes.</source>
        <translation>Ferme les trous jusqu'à un diamètre ; rien d'autre ne change.</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisions</translation>
    </message>
    <message>
        <source>Comparing tools and limits…</source>
        <translation>Comparaison des outils et des limites…</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Cône</translation>
    </message>
    <message>
        <source>Cones of the holder are kept clear as the steps above, which stand out of them by up to %1.</source>
        <translation>Les cônes du porte-outil sont tenus libres comme les marches ci-dessus, qui en dépassent de %1 au plus.</translation>
    </message>
    <message>
        <source>Configuration space</source>
        <translation>Espace des configurations</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Crossings</source>
        <translation>Croisements</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>Ctrl+Z, Ctrl+Shift+Z</source>
        <translation>Ctrl+Z, Ctrl+Maj+Z</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>Cut a model of the stock with all operations and compare it with the part (F6)</source>
        <translation>Usiner un modèle du brut avec toutes les opérations et le comparer à la pièce (F6)</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Couper par un plan</translation>
    </message>
    <message>
        <source>Cut by the rework tool; uncheck to leave it out</source>
        <translation>Usinée par l'outil de reprise ; décocher pour l'omettre</translation>
    </message>
    <message>
        <source>Cut length</source>
        <translation>Longueur de coupe</translation>
    </message>
    <message>
        <source>Cut the stock up to this operation, and judge what it is to leave</source>
        <translation>Usiner le brut jusqu'à cette opération et juger ce qu'elle doit laisser</translation>
    </message>
    <message>
        <source>Cuts the valleys that a larger tool could not enter</source>
        <translation>Usine les vallées où un outil plus grand n'a pu entrer</translation>
    </message>
    <message>
        <source>Cutter</source>
        <translation>Fraise</translation>
    </message>
    <message>
        <source>Cutter contacts: the points of the part that are cut</source>
        <translation>Contacts de fraise (CC) : les points de la pièce qui sont usinés</translation>
    </message>
    <message>
        <source>Cutter locations: the path of the tool tip while it cuts</source>
        <translation>Positions de fraise (CL) : le parcours de la pointe pendant la coupe</translation>
    </message>
    <message>
        <source>Cylinder</source>
        <translation>Cylindre</translation>
    </message>
    <message>
        <source>Decimate</source>
        <translation>Décimer</translation>
    </message>
    <message>
        <source>Deeper gouges than this have the last red</source>
        <translation>Les entailles plus profondes ont le dernier rouge</translation>
    </message>
    <message>
        <source>Deepest gouge</source>
        <translation>Entaille la plus profonde</translation>
    </message>
    <message>
        <source>Default: %1</source>
        <translation>Par défaut : %1</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Depth (%1)</source>
        <translation>Profondeur (%1)</translation>
    </message>
    <message>
        <source>Depth, %1</source>
        <translation>Profondeur, %1</translation>
    </message>
    <message>
        <source>Descriptions (*.json);;All files (*)</source>
        <translation>Descriptions (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>Diameter (%1)</source>
        <translation>Diamètre (%1)</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Dismiss</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Distance %1, X %2, Y %3, Z %4; faces at %5°</source>
        <translation>Distance %1, X %2, Y %3, Z %4 ; faces à %5°</translation>
    </message>
    <message>
        <source>Distance and angle between two points of the part (M)</source>
        <translation>Distance et angle entre deux points de la pièce (M)</translation>
    </message>
    <message>
        <source>Divide</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Divide between steep and shallow</source>
        <translation>Limite entre raide et doux</translation>
    </message>
    <message>
        <source>Divide by slope</source>
        <translation>Diviser selon la pente</translation>
    </message>
    <message>
        <source>Divides the part by slope: levels round what is steep, passes over the rest</source>
        <translation>Divise la pièce par pente : des niveaux autour du raide, des passes sur le reste</translation>
    </message>
    <message>
        <source>Do not ask again for this file</source>
        <translation>Ne plus demander pour ce fichier</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Done: that was a whole job. F1 tells more.</source>
        <translation>Terminé : c'était un travail complet. F1 en dit plus.</translation>
    </message>
    <message>
        <source>Double click, F</source>
        <translation>Double-clic, F</translation>
    </message>
    <message>
        <source>Doubled facets</source>
        <translation>Facettes doublées</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Vers le bas</translation>
    </message>
    <message>
        <source>Drag a dot on a boundary in the view to move it.</source>
        <translation>Tirer un point d'une limite dans la vue pour la déplacer.</translation>
    </message>
    <message>
        <source>Drag boundary point</source>
        <translation>Tirer un point de la limite</translation>
    </message>
    <message>
        <source>Draw curve</source>
        <translation>Dessiner une courbe</translation>
    </message>
    <message>
        <source>Drawing operations</source>
        <translation>Dessin des opérations</translation>
    </message>
    <message>
        <source>Drawing regions</source>
        <translation>Dessin des zones</translation>
    </message>
    <message>
        <source>Drawing the path</source>
        <translation>Dessin du parcours</translation>
    </message>
    <message>
        <source>Drawing the strips</source>
        <translation>Dessin des bandes</translation>
    </message>
    <message>
        <source>Drill point</source>
        <translation>Pointe de foret</translation>
    </message>
    <message>
        <source>Drop edits</source>
        <translation>Oublier les modifications</translation>
    </message>
    <message>
        <source>Drop part to Z 0</source>
        <translation>Poser la pièce à Z 0</translation>
    </message>
    <message>
        <source>Drop region edits</source>
        <translation>Oublier les modifications des zones</translation>
    </message>
    <message>
        <source>Drop to Z 0</source>
        <translation>Poser à Z 0</translation>
    </message>
    <message>
        <source>Dropped were %1; there is one part at a time. Drop the part alone: stock and fixtures are chosen in the project.</source>
        <translation>Ont été déposés %1 ; il n'y a qu'une pièce à la fois. Déposer la pièce seule : le brut et les bridages se choisissent dans le projet.</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Dupliquer</translation>
    </message>
    <message>
        <source>Duplicate boundary</source>
        <translation>Dupliquer la limite</translation>
    </message>
    <message>
        <source>Duplicate fixture</source>
        <translation>Dupliquer le bridage</translation>
    </message>
    <message>
        <source>Duplicate operation</source>
        <translation>Dupliquer l'opération</translation>
    </message>
    <message>
        <source>Duplicate setup</source>
        <translation>Dupliquer le posage</translation>
    </message>
    <message>
        <source>Duplicate tool</source>
        <translation>Dupliquer l'outil</translation>
    </message>
    <message>
        <source>Edge along X</source>
        <translation>Arête selon X</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Edges along which two facets face opposite sides</source>
        <translation>Arêtes le long desquelles deux facettes regardent de côtés opposés</translation>
    </message>
    <message>
        <source>Edges of one facet</source>
        <translation>Arêtes d'une seule facette</translation>
    </message>
    <message>
        <source>Edges of three facets and more</source>
        <translation>Arêtes de trois facettes et plus</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Edit region settings</source>
        <translation>Modifier les réglages des zones</translation>
    </message>
    <message>
        <source>Edit tool</source>
        <translation>Modifier l'outil</translation>
    </message>
    <message>
        <source>Edit tool…</source>
        <translation>Modifier l'outil…</translation>
    </message>
    <message>
        <source>End the run at once; what was found is kept, and Resume goes on</source>
        <translation>Terminer aussitôt ; ce qui est trouvé est gardé, et Reprendre continue</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Enter in the field does the same</source>
        <translation>La touche Entrée dans le champ fait de même</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gomme</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Estimated machining time</source>
        <translation>Temps d'usinage estimé</translation>
    </message>
    <message>
        <source>Everything that varies beside what comes of it; drag along an axis to keep a range, click it to let go</source>
        <translation>Tout ce qui varie à côté de ce qui en résulte ; glisser le long d'un axe garde une plage, un clic la libère</translation>
    </message>
    <message>
        <source>Excess</source>
        <translation>Excédent</translation>
    </message>
    <message>
        <source>Excess of 95 %</source>
        <translation>Excédent de 95 %</translation>
    </message>
    <message>
        <source>Excess of 99 %</source>
        <translation>Excédent de 99 %</translation>
    </message>
    <message>
        <source>Excess, half below</source>
        <translation>Excédent, moitié en dessous</translation>
    </message>
    <message>
        <source>Expected cusp</source>
        <translation>Hauteur de crête attendue</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Export anyway</source>
        <translation>Exporter quand même</translation>
    </message>
    <message>
        <source>Export configuration space</source>
        <translation>Exporter l'espace des configurations</translation>
    </message>
    <message>
        <source>Export its program…</source>
        <translation>Exporter son programme…</translation>
    </message>
    <message>
        <source>Export mes&amp;h</source>
        <translation>Ex&amp;porter un maillage</translation>
    </message>
    <message>
        <source>Export p&amp;icture…</source>
        <translation>Exporter une &amp;image…</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exporter une image</translation>
    </message>
    <message>
        <source>Export postures</source>
        <translation>Exporter les postures</translation>
    </message>
    <message>
        <source>Export programs</source>
        <translation>Exporter les programmes</translation>
    </message>
    <message>
        <source>Export programs into</source>
        <translation>Exporter les programmes vers</translation>
    </message>
    <message>
        <source>Export programs of which only some are verified?</source>
        <translation>Exporter des programmes dont seuls certains sont vérifiés ?</translation>
    </message>
    <message>
        <source>Export programs that cannot be judged?</source>
        <translation>Exporter des programmes qui ne peuvent pas être jugés ?</translation>
    </message>
    <message>
        <source>Export programs that failed?</source>
        <translation>Exporter des programmes qui ont échoué ?</translation>
    </message>
    <message>
        <source>Export programs that were verified as they no longer are?</source>
        <translation>Exporter des programmes qui ont changé depuis leur vérification ?</translation>
    </message>
    <message>
        <source>Export set&amp;up sheet…</source>
        <translation>Exporter la fic&amp;he de réglage…</translation>
    </message>
    <message>
        <source>Export setup sheet</source>
        <translation>Exporter la fiche de réglage</translation>
    </message>
    <message>
        <source>Export ta&amp;ble…</source>
        <translation>Exporter le ta&amp;bleau…</translation>
    </message>
    <message>
        <source>Export table</source>
        <translation>Exporter le tableau</translation>
    </message>
    <message>
        <source>Export the chart</source>
        <translation>Exporter le diagramme</translation>
    </message>
    <message>
        <source>Export the chart as a picture (PNG)</source>
        <translation>Exporter le diagramme en image (PNG)</translation>
    </message>
    <message>
        <source>Export the chart's values</source>
        <translation>Exporter les valeurs du diagramme</translation>
    </message>
    <message>
        <source>Export the configuration space as a picture (PNG)</source>
        <translation>Exporter l'espace des configurations en image (PNG)</translation>
    </message>
    <message>
        <source>Export the deviation as a mesh</source>
        <translation>Exporter l'écart comme maillage</translation>
    </message>
    <message>
        <source>Export the part as a mesh</source>
        <translation>Exporter la pièce comme maillage</translation>
    </message>
    <message>
        <source>Export the postures as a table (CSV)</source>
        <translation>Exporter les postures en tableau (CSV)</translation>
    </message>
    <message>
        <source>Export the stock as a mesh</source>
        <translation>Exporter le brut comme maillage</translation>
    </message>
    <message>
        <source>Export the unrolled path</source>
        <translation>Exporter le parcours déroulé</translation>
    </message>
    <message>
        <source>Export the unrolled path as a picture (PNG)</source>
        <translation>Exporter le parcours déroulé en image (PNG)</translation>
    </message>
    <message>
        <source>Export the values as a table (CSV)</source>
        <translation>Exporter les valeurs en tableau (CSV)</translation>
    </message>
    <message>
        <source>Export tools</source>
        <translation>Exporter des outils</translation>
    </message>
    <message>
        <source>Export unverified programs?</source>
        <translation>Exporter des programmes non vérifiés ?</translation>
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
        <translation>F5 planifie, F6 vérifie. Regarder ce que la liste trouve avant de continuer.</translation>
    </message>
    <message>
        <source>F5, Ctrl+P</source>
        <translation>F5, Ctrl+P</translation>
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
        <translation>Faces</translation>
    </message>
    <message>
        <source>Faces of the file</source>
        <translation>Faces du fichier</translation>
    </message>
    <message>
        <source>Faces to lie on</source>
        <translation>Faces d'appui</translation>
    </message>
    <message>
        <source>Facetmill</source>
        <translation>Facetmill</translation>
    </message>
    <message>
        <source>Facetmill (*.fmtools);;Fusion (*.json);;Fusion, packed (*.tools);;FreeCAD (*.fctl);;LinuxCNC (*.tbl)</source>
        <translation>Facetmill (*.fmtools);;Fusion (*.json);;Fusion, compressé (*.tools);;FreeCAD (*.fctl);;LinuxCNC (*.tbl)</translation>
    </message>
    <message>
        <source>Facetmill ended without saving “%1”.</source>
        <translation>Facetmill s'est arrêté sans enregistrer « %1 ».</translation>
    </message>
    <message>
        <source>Facetmill manual</source>
        <translation>Manuel de Facetmill</translation>
    </message>
    <message>
        <source>Facetmill projects (*.facetmill)</source>
        <translation>Projets Facetmill (*.facetmill)</translation>
    </message>
    <message>
        <source>Facets</source>
        <translation>Facettes</translation>
    </message>
    <message>
        <source>Facets so low that their direction is noise</source>
        <translation>Facettes si basses que leur direction n'est que du bruit</translation>
    </message>
    <message>
        <source>Facets that are out come in, those that are in go out</source>
        <translation>Les facettes du dehors entrent, celles du dedans sortent</translation>
    </message>
    <message>
        <source>Facets with the corners of another one</source>
        <translation>Facettes avec les coins d'une autre</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Échec</translation>
    </message>
    <message>
        <source>Failed verification</source>
        <translation>Vérification échouée</translation>
    </message>
    <message>
        <source>Failed verification: %1</source>
        <translation>Vérification échouée : %1</translation>
    </message>
    <message>
        <source>Failed verification: the part is gouged at more places than are listed, so this operation is not cleared</source>
        <translation>Vérification échouée : la pièce est entaillée à plus d'endroits qu'il n'y en a dans la liste ; cette opération n'est donc pas validée</translation>
    </message>
    <message>
        <source>Failed: %1</source>
        <translation>Échec : %1</translation>
    </message>
    <message>
        <source>Failed: %1: %2</source>
        <translation>Échec : %1 : %2</translation>
    </message>
    <message>
        <source>Falls at</source>
        <translation>Bascule à</translation>
    </message>
    <message>
        <source>Feed and spindle as the operation’s tool has them for a material; of roughing depth and step-over, too</source>
        <translation>Avance et vitesse de broche que l'outil de l'opération a pour une matière ; en ébauche aussi profondeur et pas latéral</translation>
    </message>
    <message>
        <source>Feeds and speeds, row</source>
        <translation>Avances et vitesses, ligne</translation>
    </message>
    <message>
        <source>Feeds for</source>
        <translation>Avances pour</translation>
    </message>
    <message>
        <source>Feeds of the tool</source>
        <translation>Avances de l'outil</translation>
    </message>
    <message>
        <source>Feeds: %1</source>
        <translation>Avances : %1</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>File unit</source>
        <translation>Unité du fichier</translation>
    </message>
    <message>
        <source>Fill &amp;flat</source>
        <translation>Remplir &amp;plat</translation>
    </message>
    <message>
        <source>Fill &amp;smooth</source>
        <translation>Remplir &amp;lisse</translation>
    </message>
    <message>
        <source>Fill holes</source>
        <translation>Remplir les trous</translation>
    </message>
    <message>
        <source>Fills one hole as you choose, or leaves it open; other steps fill the rest.</source>
        <translation>Remplit un trou comme choisi, ou le laisse ouvert ; d'autres étapes remplissent le reste.</translation>
    </message>
    <message>
        <source>Find by name, shape, material or library</source>
        <translation>Chercher par nom, forme, matière ou bibliothèque</translation>
    </message>
    <message>
        <source>Find out which tools and settings serve best: many are planned and verified (S)</source>
        <translation>Trouver les outils et réglages qui servent le mieux : beaucoup sont planifiés et vérifiés (S)</translation>
    </message>
    <message>
        <source>Finding facets in a box</source>
        <translation>Recherche des facettes dans une boîte</translation>
    </message>
    <message>
        <source>Finding rework regions</source>
        <translation>Recherche des zones de reprise</translation>
    </message>
    <message>
        <source>Finding what lies in a boundary</source>
        <translation>Recherche de ce qui est dans une limite</translation>
    </message>
    <message>
        <source>Fins</source>
        <translation>Lambeaux</translation>
    </message>
    <message>
        <source>Fixture mesh</source>
        <translation>Maillage d'un bridage</translation>
    </message>
    <message>
        <source>Flat end</source>
        <translation>Plat</translation>
    </message>
    <message>
        <source>Flood</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Flutes</source>
        <translation>Dents</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Dossier</translation>
    </message>
    <message>
        <source>Following the path on the machine…</source>
        <translation>Suivi du parcours sur la machine…</translation>
    </message>
    <message>
        <source>Follows a curve drawn on the part or the outline, on it or beside it: engraving, trimming</source>
        <translation>Suit une courbe dessinée sur la pièce ou le contour, dessus ou à côté : gravure, détourage</translation>
    </message>
    <message>
        <source>Foot of a wall</source>
        <translation>Pied de paroi</translation>
    </message>
    <message>
        <source>Forget the posture kept for this point</source>
        <translation>Oublier la posture gardée pour ce point</translation>
    </message>
    <message>
        <source>Forget what was switched off, grown, shrunk and dragged by hand</source>
        <translation>Oublier ce qui a été désactivé, agrandi, réduit et tiré à la main</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>Found %1 in %2.</source>
        <translation>%1 trouvé dans %2.</translation>
    </message>
    <message>
        <source>Found %1 places; the first %2 of them:</source>
        <translation>%1 endroits trouvés ; les %2 premiers :</translation>
    </message>
    <message>
        <source>Found (click to go there):</source>
        <translation>Trouvés (un clic y va) :</translation>
    </message>
    <message>
        <source>Found in the mesh</source>
        <translation>Trouvé dans le maillage</translation>
    </message>
    <message>
        <source>Found there too: %1.</source>
        <translation>Trouvé là aussi : %1.</translation>
    </message>
    <message>
        <source>FreeCAD</source>
        <translation>FreeCAD</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D'un fichier…</translation>
    </message>
    <message>
        <source>From setup “%1”: </source>
        <translation>Du posage « %1 » : </translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Front</translation>
    </message>
    <message>
        <source>Front of the study</source>
        <translation>Front de l'étude</translation>
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
        <translation>Donner un nom à la limite</translation>
    </message>
    <message>
        <source>Give the fixture a name</source>
        <translation>Donner un nom au bridage</translation>
    </message>
    <message>
        <source>Give the operation a name</source>
        <translation>Donner un nom à l'opération</translation>
    </message>
    <message>
        <source>Give the setup a name</source>
        <translation>Donner un nom au posage</translation>
    </message>
    <message>
        <source>Gives a sheet a back and walls, so that it becomes a solid.</source>
        <translation>Donne à une feuille un dos et des parois, pour qu'elle devienne un solide.</translation>
    </message>
    <message>
        <source>Go to setup “%1”</source>
        <translation>Aller au posage « %1 »</translation>
    </message>
    <message>
        <source>Go to this setup</source>
        <translation>Aller à ce posage</translation>
    </message>
    <message>
        <source>Goes back to the recipe of the project; nothing is changed</source>
        <translation>Revient à la recette du projet ; rien n'est changé</translation>
    </message>
    <message>
        <source>Goes on with another scan where this one ends; the two overlap.</source>
        <translation>Continue par un autre scan là où celui-ci finit ; les deux se recouvrent.</translation>
    </message>
    <message>
        <source>Goes round steep walls and flanks at one height after another</source>
        <translation>Contourne parois et flancs raides, une hauteur après l'autre</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Entaille</translation>
    </message>
    <message>
        <source>Grow</source>
        <translation>Agrandir</translation>
    </message>
    <message>
        <source>Grow (%1)</source>
        <translation>Agrandir (%1)</translation>
    </message>
    <message>
        <source>Grow and shrink by</source>
        <translation>Agrandir et réduire de</translation>
    </message>
    <message>
        <source>Grow painted facets</source>
        <translation>Agrandir les facettes peintes</translation>
    </message>
    <message>
        <source>Grow region</source>
        <translation>Agrandir la zone</translation>
    </message>
    <message>
        <source>Handing the study over</source>
        <translation>Remise de l'étude</translation>
    </message>
    <message>
        <source>Height of the part as it lies</source>
        <translation>Hauteur de la pièce posée</translation>
    </message>
    <message>
        <source>Hidden ones too</source>
        <translation>Cachées aussi</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Masquer la pièce</translation>
    </message>
    <message>
        <source>Hide paths</source>
        <translation>Masquer les parcours</translation>
    </message>
    <message>
        <source>Hide stock</source>
        <translation>Masquer le brut</translation>
    </message>
    <message>
        <source>High,
%1</source>
        <translation>Haut,
%1</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Porte-outil</translation>
    </message>
    <message>
        <source>Holder %1</source>
        <translation>Porte-outil %1</translation>
    </message>
    <message>
        <source>Holder section</source>
        <translation>Section du porte-outil</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>Hollow</source>
        <translation>Creux</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Hôte</translation>
    </message>
    <message>
        <source>How far its boundary lies outside the offset; double click to enter it</source>
        <translation>De combien la limite dépasse le décalage ; double-clic pour la saisir</translation>
    </message>
    <message>
        <source>How far the study is</source>
        <translation>Avancement de l'étude</translation>
    </message>
    <message>
        <source>How far the table may be tilted before the part falls</source>
        <translation>De combien la table peut pencher avant que la pièce tombe</translation>
    </message>
    <message>
        <source>How the passes of the chosen operation will about run, until it is planned</source>
        <translation>Comment les passes de l’opération choisie iront à peu près, jusqu’à ce qu’elle soit planifiée</translation>
    </message>
    <message>
        <source>Import tools</source>
        <translation>Importer des outils</translation>
    </message>
    <message>
        <source>In a chart or the unrolled path</source>
        <translation>Dans un diagramme ou le parcours déroulé</translation>
    </message>
    <message>
        <source>In a hole</source>
        <translation>Dans un trou</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>Pouces</translation>
    </message>
    <message>
        <source>Invert painted facets</source>
        <translation>Inverser les facettes peintes</translation>
    </message>
    <message>
        <source>It is offered again at the next start</source>
        <translation>Il est proposé de nouveau au prochain démarrage</translation>
    </message>
    <message>
        <source>It was kept as it stood on %1, in %2.</source>
        <translation>Il a été gardé tel qu'il était le %1, dans %2.</translation>
    </message>
    <message>
        <source>It was never saved under a name.</source>
        <translation>Il n'a jamais été enregistré sous un nom.</translation>
    </message>
    <message>
        <source>It was painted on a part of %1 facets, and this one has %2: paint it anew.</source>
        <translation>Elle a été peinte sur une pièce de %1 facettes, celle-ci en a %2 : la repeindre.</translation>
    </message>
    <message>
        <source>Join a scan</source>
        <translation>Joindre un scan</translation>
    </message>
    <message>
        <source>Keep for this point</source>
        <translation>Garder pour ce point</translation>
    </message>
    <message>
        <source>Keep libraries and templates in</source>
        <translation>Garder bibliothèques et modèles dans</translation>
    </message>
    <message>
        <source>Keep operations, tools and settings of this setup for other parts</source>
        <translation>Garder opérations, outils et réglages de ce posage pour d'autres pièces</translation>
    </message>
    <message>
        <source>Keep posture</source>
        <translation>Garder la posture</translation>
    </message>
    <message>
        <source>Keep the tried posture for this point; planning again uses it</source>
        <translation>Garder la posture essayée pour ce point ; une nouvelle planification l'utilise</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Gardée</translation>
    </message>
    <message>
        <source>Kept as template “%1”: %2.</source>
        <translation>Gardé comme modèle « %1 » : %2.</translation>
    </message>
    <message>
        <source>Kept lead %1, yaw %2 for the point. Plan again to use it.</source>
        <translation>Attaque %1, lacet %2 gardés pour le point. Planifier de nouveau pour les utiliser.</translation>
    </message>
    <message>
        <source>Kept with the project what was planned and verified: %1 MB in %2.</source>
        <translation>Gardé avec le projet ce qui était planifié et vérifié : %1 Mo dans %2.</translation>
    </message>
    <message>
        <source>Kept: %1</source>
        <translation>Gardé : %1</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>L&amp;ibraries and templates in</source>
        <translation>B&amp;ibliothèques et modèles dans</translation>
    </message>
    <message>
        <source>Larger letters (Ctrl++)</source>
        <translation>Lettres plus grandes (Ctrl++)</translation>
    </message>
    <message>
        <source>Largest cusp</source>
        <translation>Crête la plus haute</translation>
    </message>
    <message>
        <source>Largest excess</source>
        <translation>Plus grand excédent</translation>
    </message>
    <message>
        <source>Largest first</source>
        <translation>Plus grandes d'abord</translation>
    </message>
    <message>
        <source>Lay down, zero</source>
        <translation>Poser, origine</translation>
    </message>
    <message>
        <source>Lay it on a face</source>
        <translation>La poser sur une face</translation>
    </message>
    <message>
        <source>Lay on face</source>
        <translation>Poser sur une face</translation>
    </message>
    <message>
        <source>Lay on this face</source>
        <translation>Poser sur cette face</translation>
    </message>
    <message>
        <source>Lay part by its principal axes</source>
        <translation>Poser la pièce selon ses axes principaux</translation>
    </message>
    <message>
        <source>Lay part on face</source>
        <translation>Poser la pièce sur une face</translation>
    </message>
    <message>
        <source>Lay part on three points</source>
        <translation>Poser la pièce sur trois points</translation>
    </message>
    <message>
        <source>Lay the part on a face of the list, then put the zero on the stock: press P.</source>
        <translation>Poser la pièce sur une face de la liste, puis mettre l'origine sur le brut : appuyer sur P.</translation>
    </message>
    <message>
        <source>Lay the part on a face, turn, move or mirror it (P)</source>
        <translation>Poser la pièce sur une face, la tourner, la déplacer ou la refléter (P)</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Layer %1 of %2, z %3</source>
        <translation>Niveau %1 sur %2, z %3</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Niveaux</translation>
    </message>
    <message>
        <source>Lead limit (°), tool D %1</source>
        <translation>Limite d'attaque (°), outil D %1</translation>
    </message>
    <message>
        <source>Least by this estimate: lead limit %1 with this tool, %2; of all tools D %3 with %4, %5.</source>
        <translation>Le moins d'après cette estimation : limite %1 avec cet outil, %2 ; de tous les outils D %3 avec %4, %5.</translation>
    </message>
    <message>
        <source>Leave it out of plan, verification and programs, as if it were not there</source>
        <translation>L'écarter du plan, de la vérification et des programmes, comme si elle n'existait pas</translation>
    </message>
    <message>
        <source>Leaves about %1 % of what the tool sees of the part uncut</source>
        <translation>Laisse environ %1 % de ce que l’outil voit de la pièce non usinés</translation>
    </message>
    <message>
        <source>Leaves least of these</source>
        <translation>Laisse le moins parmi celles-ci</translation>
    </message>
    <message>
        <source>Left end: all layers; then one layer alone, from the top down</source>
        <translation>À gauche : tous les niveaux ; puis un seul, de haut en bas</translation>
    </message>
    <message>
        <source>Left for clean-up</source>
        <translation>Laissé au nettoyage</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Length, %1</source>
        <translation>Longueur, %1</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Lies,
%1</source>
        <translation>Appui,
%1</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Liaisons</translation>
    </message>
    <message>
        <source>Links between cuts, approach and retract, at feed</source>
        <translation>Liaisons entre les coupes, approche et retrait, en avance</translation>
    </message>
    <message>
        <source>Locate %1</source>
        <translation>Localiser %1</translation>
    </message>
    <message>
        <source>Locate it, or put it back: the rest of the project stays as it is.</source>
        <translation>Le localiser ou le remettre en place : le reste du projet demeure.</translation>
    </message>
    <message>
        <source>Locate “%1”</source>
        <translation>Localiser « %1 »</translation>
    </message>
    <message>
        <source>Locate…</source>
        <translation>Localiser…</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Look &amp;again</source>
        <translation>Chercher de &amp;nouveau</translation>
    </message>
    <message>
        <source>Look for suggestions once more, for the project as it is now</source>
        <translation>Chercher encore des propositions, pour le projet tel qu’il est</translation>
    </message>
    <message>
        <source>Looked at</source>
        <translation>Examiné</translation>
    </message>
    <message>
        <source>Looking at the candidate</source>
        <translation>Examen du candidat</translation>
    </message>
    <message>
        <source>Looking at the pass…</source>
        <translation>Examen de la passe…</translation>
    </message>
    <message>
        <source>Looking at the path</source>
        <translation>Examen du parcours</translation>
    </message>
    <message>
        <source>Looking at the study</source>
        <translation>Examen de l'étude</translation>
    </message>
    <message>
        <source>Looking at what is known…</source>
        <translation>Lecture de ce qui est connu…</translation>
    </message>
    <message>
        <source>Looking for a hole</source>
        <translation>Recherche d'un trou</translation>
    </message>
    <message>
        <source>Looking for faces to lie on</source>
        <translation>Recherche de faces d'appui</translation>
    </message>
    <message>
        <source>Looking for faces to lie on…</source>
        <translation>Recherche de faces d'appui…</translation>
    </message>
    <message>
        <source>Looking for holes, pieces and other flaws…</source>
        <translation>Recherche de trous, morceaux et autres défauts…</translation>
    </message>
    <message>
        <source>Looking for suggestions</source>
        <translation>Recherche de propositions</translation>
    </message>
    <message>
        <source>Looking for the face</source>
        <translation>Recherche de la face</translation>
    </message>
    <message>
        <source>Looking over the part</source>
        <translation>Inspection de la pièce</translation>
    </message>
    <message>
        <source>Loose pieces, holes, noise, facets: what is wrong with the mesh, and a recipe that mends it</source>
        <translation>Morceaux détachés, trous, bruit, facettes : ce qui ne va pas dans le maillage, et une recette qui le répare</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Machine and control</source>
        <translation>Machine et commande</translation>
    </message>
    <message>
        <source>Machine and stock</source>
        <translation>Machine et brut</translation>
    </message>
    <message>
        <source>Machining time</source>
        <translation>Temps d'usinage</translation>
    </message>
    <message>
        <source>Machining time until here, and of all operations</source>
        <translation>Temps d'usinage jusqu'ici, et de toutes les opérations</translation>
    </message>
    <message>
        <source>Make another mesh the part; operations, tools and the rest stay as they are</source>
        <translation>Prendre un autre maillage comme pièce ; opérations, outils et le reste demeurent</translation>
    </message>
    <message>
        <source>Makes the part its mirror image: left and right along %1 change places. A part made so is another one.</source>
        <translation>Remplace la pièce par son image en miroir : gauche et droite selon %1 s'échangent. Une pièce ainsi faite en est une autre.</translation>
    </message>
    <message>
        <source>Makes the surface anew where it runs through itself.</source>
        <translation>Refait la surface là où elle se traverse.</translation>
    </message>
    <message>
        <source>Making %1</source>
        <translation>Création de %1</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Matière</translation>
    </message>
    <message>
        <source>Material is left on %1 of the area to be cut.</source>
        <translation>Il reste de la matière sur %1 de la surface à usiner.</translation>
    </message>
    <message>
        <source>Max</source>
        <translation>Max</translation>
    </message>
    <message>
        <source>Measuring slopes</source>
        <translation>Mesure des pentes</translation>
    </message>
    <message>
        <source>Mend the part's mesh: loose pieces, holes, noise, facets (R)</source>
        <translation>Réparer le maillage de la pièce : morceaux détachés, trous, bruit, facettes (R)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Maillages (%1)</translation>
    </message>
    <message>
        <source>Meshes and projects (%1 *.facetmill);;All files (*)</source>
        <translation>Maillages et projets (%1 *.facetmill);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Meshes are in</source>
        <translation>Les maillages sont en</translation>
    </message>
    <message>
        <source>Mesh…</source>
        <translation>Maillage…</translation>
    </message>
    <message>
        <source>Metres</source>
        <translation>Mètres</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Milieu</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimètres</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Refléter en %1</translation>
    </message>
    <message>
        <source>Mirror part in %1</source>
        <translation>Refléter la pièce en %1</translation>
    </message>
    <message>
        <source>Missing too: %1.</source>
        <translation>Il manque aussi : %1.</translation>
    </message>
    <message>
        <source>Mo&amp;use like</source>
        <translation>&amp;Souris comme</translation>
    </message>
    <message>
        <source>More excess than this has the last blue</source>
        <translation>Les excédents plus grands ont le dernier bleu</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Mouvements</translation>
    </message>
    <message>
        <source>Mouse, colours, machine of new projects, threads (Ctrl+,)</source>
        <translation>Souris, couleurs, machine des nouveaux projets, threads (Ctrl+,)</translation>
    </message>
    <message>
        <source>Move along X</source>
        <translation>Déplacer selon X</translation>
    </message>
    <message>
        <source>Move along Y</source>
        <translation>Déplacer selon Y</translation>
    </message>
    <message>
        <source>Move along Z</source>
        <translation>Déplacer selon Z</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>Descendre</translation>
    </message>
    <message>
        <source>Move fixture “%1”</source>
        <translation>Déplacer le bridage « %1 »</translation>
    </message>
    <message>
        <source>Move operation</source>
        <translation>Déplacer l'opération</translation>
    </message>
    <message>
        <source>Move part along %1</source>
        <translation>Déplacer la pièce selon %1</translation>
    </message>
    <message>
        <source>Move setup</source>
        <translation>Déplacer le posage</translation>
    </message>
    <message>
        <source>Move the boundary of the chosen region inward, never inside of what is uncut</source>
        <translation>Déplacer la limite de la zone choisie vers l'intérieur, jamais dans ce qui n'est pas usiné</translation>
    </message>
    <message>
        <source>Move the boundary of the chosen region outward</source>
        <translation>Déplacer la limite de la zone choisie vers l'extérieur</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>Monter</translation>
    </message>
    <message>
        <source>Move: Ctrl + middle</source>
        <translation>Déplacer : Ctrl + milieu</translation>
    </message>
    <message>
        <source>Move: Shift + middle</source>
        <translation>Déplacer : Maj + milieu</translation>
    </message>
    <message>
        <source>Move: middle button</source>
        <translation>Déplacer : bouton du milieu</translation>
    </message>
    <message>
        <source>Move: middle button, or Ctrl + right</source>
        <translation>Déplacer : bouton du milieu, ou Ctrl + droit</translation>
    </message>
    <message>
        <source>Move: middle, or Shift + left</source>
        <translation>Déplacer : milieu, ou Maj + gauche</translation>
    </message>
    <message>
        <source>Moved at most %1</source>
        <translation>Déplacé d'au plus %1</translation>
    </message>
    <message>
        <source>Moves the middle of the part's box to X 0, Y 0</source>
        <translation>Déplace le milieu de la boîte de la pièce en X 0, Y 0</translation>
    </message>
    <message>
        <source>Moves the part along Z until its lowest point has Z 0</source>
        <translation>Déplace la pièce selon Z jusqu'à ce que son point le plus bas soit à Z 0</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name a mesh file</source>
        <translation>Indiquer un fichier de maillage</translation>
    </message>
    <message>
        <source>Name the host that is to work, as ssh knows it.</source>
        <translation>Nommer l’hôte qui doit travailler, tel que ssh le connaît.</translation>
    </message>
    <message>
        <source>Needles</source>
        <translation>Aiguilles</translation>
    </message>
    <message>
        <source>New from sa&amp;mple</source>
        <translation>Nouveau d'un e&amp;xemple</translation>
    </message>
    <message>
        <source>New from sample</source>
        <translation>Nouveau d'un exemple</translation>
    </message>
    <message>
        <source>New projects</source>
        <translation>Nouveaux projets</translation>
    </message>
    <message>
        <source>New projects are for</source>
        <translation>Les nouveaux projets sont pour</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Next pass (↓)</source>
        <translation>Passe suivante (↓)</translation>
    </message>
    <message>
        <source>Next point on the pass (→; Shift: ten)</source>
        <translation>Point suivant de la passe (→ ; Maj : dix)</translation>
    </message>
    <message>
        <source>No candidate has been looked at yet.</source>
        <translation>Aucun candidat n'a encore été examiné.</translation>
    </message>
    <message>
        <source>No defects found.</source>
        <translation>Aucun défaut trouvé.</translation>
    </message>
    <message>
        <source>No holder: nothing above the shank is watched. + adds a section.</source>
        <translation>Pas de porte-outil : au-dessus de la queue, rien n'est surveillé. + ajoute une section.</translation>
    </message>
    <message>
        <source>No material yet: operations have feeds of their own. + adds one.</source>
        <translation>Pas encore de matière : les opérations ont leurs propres avances. + en ajoute une.</translation>
    </message>
    <message>
        <source>No operation turns the part: there is nothing to unroll</source>
        <translation>Aucune opération ne tourne la pièce : il n'y a rien à dérouler</translation>
    </message>
    <message>
        <source>No part has been read.</source>
        <translation>Aucune pièce n'a été lue.</translation>
    </message>
    <message>
        <source>No path is planned.</source>
        <translation>Aucun parcours n'est planifié.</translation>
    </message>
    <message>
        <source>No place is hollow: any tool matches.</source>
        <translation>Aucun endroit n'est creux : tout outil convient.</translation>
    </message>
    <message>
        <source>No place needs a lead above %1°: the main path cuts all of the part, there is nothing to rework.</source>
        <translation>Aucun endroit n'exige une attaque au-dessus de %1° : le parcours principal usine toute la pièce, il n'y a rien à reprendre.</translation>
    </message>
    <message>
        <source>No point</source>
        <translation>Aucun point</translation>
    </message>
    <message>
        <source>No posture</source>
        <translation>Aucune posture</translation>
    </message>
    <message>
        <source>No posture is free: the point is left to clean-up</source>
        <translation>Aucune posture n'est libre : le point est laissé au nettoyage</translation>
    </message>
    <message>
        <source>No preview</source>
        <translation>Pas d’aperçu</translation>
    </message>
    <message>
        <source>No step yet: the file is taken as it is. Suggest makes a recipe for what was found; Add takes single steps.</source>
        <translation>Pas encore d'étape : le fichier est pris tel quel. Suggérer fait une recette pour ce qui a été trouvé ; Ajouter prend des étapes isolées.</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Aucun outil</translation>
    </message>
    <message>
        <source>No tool has “%1”.</source>
        <translation>Aucun outil n'a « %1 ».</translation>
    </message>
    <message>
        <source>No tool is kept yet. Import a library of another program, or keep the tools of this project.</source>
        <translation>Aucun outil n'est encore gardé. Importer la bibliothèque d'un autre programme, ou garder les outils de ce projet.</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Nobody knows what these programs leave of part, tool and machine.</source>
        <translation>Personne ne sait ce que ces programmes laissent de la pièce, de l'outil et de la machine.</translation>
    </message>
    <message>
        <source>None is kept yet</source>
        <translation>Aucun n'est encore gardé</translation>
    </message>
    <message>
        <source>Normal change</source>
        <translation>Variation de la normale</translation>
    </message>
    <message>
        <source>Not all that was planned is kept with the project: it would be more than %1 MB. It is planned again when the project is opened.</source>
        <translation>Tout ce qui était planifié n'est pas gardé avec le projet : cela dépasserait %1 Mo. Il est planifié de nouveau à l'ouverture du projet.</translation>
    </message>
    <message>
        <source>Not enough memory (close other programs or use a smaller part)</source>
        <translation>Pas assez de mémoire (fermer d'autres programmes ou prendre une pièce plus petite)</translation>
    </message>
    <message>
        <source>Not enough memory to play back the stock</source>
        <translation>Pas assez de mémoire pour rejouer le brut</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Non planifié</translation>
    </message>
    <message>
        <source>Not restored: %1. It is offered again at the next start.</source>
        <translation>Non restauré : %1. Il est proposé de nouveau au prochain démarrage.</translation>
    </message>
    <message>
        <source>Not studied. Step on, or pick a point.</source>
        <translation>Non examiné. Avancer, ou choisir un point.</translation>
    </message>
    <message>
        <source>Not verified</source>
        <translation>Non vérifié</translation>
    </message>
    <message>
        <source>Not verified (in %1), it cannot be judged: %2.</source>
        <translation>Non vérifié (en %1), impossible à juger : %2.</translation>
    </message>
    <message>
        <source>Nothing can be compared while a value is not right.</source>
        <translation>Rien ne peut être comparé tant qu'une valeur est fausse.</translation>
    </message>
    <message>
        <source>Nothing can be written into this folder: choose another one.</source>
        <translation>Rien ne peut être écrit dans ce dossier : en choisir un autre.</translation>
    </message>
    <message>
        <source>Nothing has all these words.</source>
        <translation>Rien ne contient tous ces mots.</translation>
    </message>
    <message>
        <source>Nothing has happened yet.</source>
        <translation>Rien ne s'est encore passé.</translation>
    </message>
    <message>
        <source>Nothing is cut</source>
        <translation>Rien n'est usiné</translation>
    </message>
    <message>
        <source>Nothing is open.</source>
        <translation>Rien n'est ouvert.</translation>
    </message>
    <message>
        <source>Nothing is wanted: choose a measure.</source>
        <translation>Rien n'est souhaité : choisir une mesure.</translation>
    </message>
    <message>
        <source>Nothing may vary: choose at least two values of something, such as two tools.</source>
        <translation>Rien ne peut varier : choisir au moins deux valeurs de quelque chose, par exemple deux outils.</translation>
    </message>
    <message>
        <source>Nothing moved</source>
        <translation>Rien n'a bougé</translation>
    </message>
    <message>
        <source>Nothing to do: %1. No program is written for it.</source>
        <translation>Rien à faire : %1. Aucun programme n'est écrit pour elle.</translation>
    </message>
    <message>
        <source>Nothing to play back yet: plan first (F5).</source>
        <translation>Rien à rejouer : planifier d'abord (F5).</translation>
    </message>
    <message>
        <source>Nothing was found that a recipe would mend.</source>
        <translation>Rien n'a été trouvé qu'une recette réparerait.</translation>
    </message>
    <message>
        <source>Nothing was found.</source>
        <translation>Rien n'a été trouvé.</translation>
    </message>
    <message>
        <source>Nothing was judged</source>
        <translation>Rien n'a été jugé</translation>
    </message>
    <message>
        <source>Nothing was kept</source>
        <translation>Rien n'a été gardé</translation>
    </message>
    <message>
        <source>Nothing was taken over</source>
        <translation>Rien n'a été repris</translation>
    </message>
    <message>
        <source>Nothing was written</source>
        <translation>Rien n'a été écrit</translation>
    </message>
    <message>
        <source>Number %1 belongs to another tool</source>
        <translation>Le numéro %1 appartient à un autre outil</translation>
    </message>
    <message>
        <source>Number of regions</source>
        <translation>Nombre de zones</translation>
    </message>
    <message>
        <source>Number of rework regions</source>
        <translation>Nombre de zones de reprise</translation>
    </message>
    <message>
        <source>Number of the GOTO in the operation's program</source>
        <translation>Numéro du GOTO dans le programme de l'opération</translation>
    </message>
    <message>
        <source>Numbers or %1, with a semicolon between them</source>
        <translation>Nombres ou %1, séparés par un point-virgule</translation>
    </message>
    <message>
        <source>Numbers with a semicolon between them, %1</source>
        <translation>Nombres séparés par un point-virgule, %1</translation>
    </message>
    <message>
        <source>Of earlier jobs there: %1.</source>
        <translation>De travaux antérieurs à cet endroit : %1.</translation>
    </message>
    <message>
        <source>Of the part</source>
        <translation>De la pièce</translation>
    </message>
    <message>
        <source>Of the stock</source>
        <translation>Du brut</translation>
    </message>
    <message>
        <source>Of those that meet all limits, the one with the least of this wins</source>
        <translation>De ceux qui respectent toutes les limites, celui qui en a le moins gagne</translation>
    </message>
    <message>
        <source>Of which operation</source>
        <translation>De quelle opération</translation>
    </message>
    <message>
        <source>On 3 points</source>
        <translation>Sur 3 points</translation>
    </message>
    <message>
        <source>On →</source>
        <translation>Suivant →</translation>
    </message>
    <message>
        <source>One hole</source>
        <translation>Un trou</translation>
    </message>
    <message>
        <source>One motion back (,)</source>
        <translation>Un mouvement en arrière (,)</translation>
    </message>
    <message>
        <source>One motion on (.)</source>
        <translation>Un mouvement en avant (.)</translation>
    </message>
    <message>
        <source>One operation is as it was planned: it was kept with the project.</source>
        <translation>Une opération est comme planifiée : elle a été gardée avec le projet.</translation>
    </message>
    <message>
        <source>One pass that winds about a centre, for what is round</source>
        <translation>Une passe qui s’enroule autour d’un centre, pour ce qui est rond</translation>
    </message>
    <message>
        <source>One pass that winds over the part needs few links</source>
        <translation>Une passe qui s’enroule sur la pièce demande peu de liaisons</translation>
    </message>
    <message>
        <source>Only what is cut up to “%1” has been verified.</source>
        <translation>Seul ce qui est usiné jusqu'à « %1 » a été vérifié.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>Open a mesh or a project, and this panel tells what it holds.</source>
        <translation>Ouvrir un maillage ou un projet : ce panneau dit ce qu'il contient.</translation>
    </message>
    <message>
        <source>Open a mesh or drop one here</source>
        <translation>Ouvrir un maillage ou le déposer ici</translation>
    </message>
    <message>
        <source>Open a mesh, drop one here, or take a sample. STL files carry no unit: the sizes tell.</source>
        <translation>Ouvrir un maillage, en déposer un ici, ou prendre un exemple. Les fichiers STL n'ont pas d'unité : les tailles la disent.</translation>
    </message>
    <message>
        <source>Open a study's file, or the folder of one</source>
        <translation>Ouvrir le fichier d'une étude, ou son dossier</translation>
    </message>
    <message>
        <source>Open edges</source>
        <translation>Arêtes ouvertes</translation>
    </message>
    <message>
        <source>Open folder</source>
        <translation>Ouvrir le dossier</translation>
    </message>
    <message>
        <source>Open pro&amp;gram…</source>
        <translation>Ouvrir un pro&amp;gramme…</translation>
    </message>
    <message>
        <source>Open program</source>
        <translation>Ouvrir un programme</translation>
    </message>
    <message>
        <source>Open study</source>
        <translation>Ouvrir une étude</translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 ouvert.</translation>
    </message>
    <message>
        <source>Opening the study</source>
        <translation>Ouverture de l'étude</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Opération</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Opérations</translation>
    </message>
    <message>
        <source>Operations, tools and settings as</source>
        <translation>Opérations, outils et réglages comme</translation>
    </message>
    <message>
        <source>Order of operations</source>
        <translation>Ordre des opérations</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Autres</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Périmé</translation>
    </message>
    <message>
        <source>Out of date: plan again</source>
        <translation>Périmé : planifier de nouveau</translation>
    </message>
    <message>
        <source>Out of reach</source>
        <translation>Hors d'atteinte</translation>
    </message>
    <message>
        <source>Over the lead limit: click or drag to set it. Wheel: zoom. Right drag: move.</source>
        <translation>En fonction de la limite d'attaque : cliquer ou tirer pour la fixer. Molette : zoom. Tirer à droite : déplacer.</translation>
    </message>
    <message>
        <source>Over the tolerance %1</source>
        <translation>Au-dessus de la tolérance %1</translation>
    </message>
    <message>
        <source>Overfull edges</source>
        <translation>Arêtes surchargées</translation>
    </message>
    <message>
        <source>P&amp;lace part…</source>
        <translation>&amp;Placer la pièce…</translation>
    </message>
    <message>
        <source>P&amp;review</source>
        <translation>Ape&amp;rçu</translation>
    </message>
    <message>
        <source>Packed %1 files into %2.</source>
        <translation>%1 fichiers compressés dans %2.</translation>
    </message>
    <message>
        <source>Packing %1</source>
        <translation>Compression de %1</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Page du manuel</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Paint a face: up to edges where the surface turns by more</source>
        <translation>Peindre une face : jusqu'aux arêtes où la surface tourne de plus de</translation>
    </message>
    <message>
        <source>Paint facets</source>
        <translation>Peindre des facettes</translation>
    </message>
    <message>
        <source>Paint what lies wholly in a rectangle</source>
        <translation>Peindre ce qui est entièrement dans un rectangle</translation>
    </message>
    <message>
        <source>Paint what the ring touches</source>
        <translation>Peindre ce que l'anneau touche</translation>
    </message>
    <message>
        <source>Painted</source>
        <translation>Peinte</translation>
    </message>
    <message>
        <source>Painted facets</source>
        <translation>Facettes peintes</translation>
    </message>
    <message>
        <source>Pairs of facets that run through each other</source>
        <translation>Paires de facettes qui se traversent</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Panneaux</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallèles</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Pièce</translation>
    </message>
    <message>
        <source>Part &amp;shading</source>
        <translation>Aspect de la &amp;pièce</translation>
    </message>
    <message>
        <source>Part's origin</source>
        <translation>Origine de la pièce</translation>
    </message>
    <message>
        <source>Pass %1 of %2</source>
        <translation>Passe %1 sur %2</translation>
    </message>
    <message>
        <source>Pass %1, point %2 of %3 · %4</source>
        <translation>Passe %1, point %2 sur %3 · %4</translation>
    </message>
    <message>
        <source>Pass %1, point %2: lead %3, yaw %4</source>
        <translation>Passe %1, point %2 : attaque %3, lacet %4</translation>
    </message>
    <message>
        <source>Pass before (↑)</source>
        <translation>Passe précédente (↑)</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Passes</translation>
    </message>
    <message>
        <source>Passes follow the border, everywhere as far apart as the tolerance allows</source>
        <translation>Les passes suivent le bord, partout aussi espacées que la tolérance le permet</translation>
    </message>
    <message>
        <source>Passes follow the part's outline</source>
        <translation>Les passes suivent le contour de la pièce</translation>
    </message>
    <message>
        <source>Passes from a centre outward, like the spokes of a wheel</source>
        <translation>Des passes d’un centre vers l’extérieur, comme les rayons d’une roue</translation>
    </message>
    <message>
        <source>Passes from the middle outward meet its rims head on</source>
        <translation>Des passes du centre vers l’extérieur abordent ses bords de face</translation>
    </message>
    <message>
        <source>Passes side by side over the surface, with an upright tool</source>
        <translation>Des passes côte à côte sur la surface, avec un outil vertical</translation>
    </message>
    <message>
        <source>Passes that follow a border or a curve or go round a place, with cusps of one height</source>
        <translation>Passes qui suivent un bord ou une courbe ou entourent un point, aux crêtes de même hauteur</translation>
    </message>
    <message>
        <source>Passes that go over from one curve to another, the way the part flows</source>
        <translation>Des passes qui vont d’une courbe à l’autre, dans le sens de la pièce</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Paste operation</source>
        <translation>Coller l'opération</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Path by</source>
        <translation>Parcours par</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Espace)</translation>
    </message>
    <message>
        <source>Pe&amp;rspective</source>
        <translation>Perspecti&amp;ve</translation>
    </message>
    <message>
        <source>Peak load</source>
        <translation>Pointe de charge</translation>
    </message>
    <message>
        <source>Pick %1</source>
        <translation>Choisir %1</translation>
    </message>
    <message>
        <source>Pick a point on the path of a planned 5-axis operation</source>
        <translation>Choisir un point sur le parcours d'une opération 5 axes planifiée</translation>
    </message>
    <message>
        <source>Pick in the view</source>
        <translation>Choisir dans la vue</translation>
    </message>
    <message>
        <source>Pick it in the view</source>
        <translation>Le choisir dans la vue</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Images (*.png)</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Morceaux</translation>
    </message>
    <message>
        <source>Place along the strip</source>
        <translation>Endroit le long de la bande</translation>
    </message>
    <message>
        <source>Place along the strip; a click on the strip in the view goes there, too</source>
        <translation>Endroit le long de la bande ; un clic sur la bande dans la vue y va aussi</translation>
    </message>
    <message>
        <source>Place of the pass across the travel (%1)</source>
        <translation>Position de la passe en travers de l'avance (%1)</translation>
    </message>
    <message>
        <source>Place part</source>
        <translation>Placer la pièce</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>Endroits trouvés</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Planifier</translation>
    </message>
    <message>
        <source>Plan all &amp;setups</source>
        <translation>Planifier tous les p&amp;osages</translation>
    </message>
    <message>
        <source>Plan all operations (F5)</source>
        <translation>Planifier toutes les opérations (F5)</translation>
    </message>
    <message>
        <source>Plan an operation to see it here</source>
        <translation>Planifier une opération pour la voir ici</translation>
    </message>
    <message>
        <source>Plan and judge finishing operations of all kinds, and suggest the three best (G)</source>
        <translation>Planifier et juger des opérations de finition de toutes sortes, et proposer les trois meilleures (G)</translation>
    </message>
    <message>
        <source>Plan and verify</source>
        <translation>Planifier et vérifier</translation>
    </message>
    <message>
        <source>Plan and verify the candidates in the background</source>
        <translation>Planifier et vérifier les candidats en arrière-plan</translation>
    </message>
    <message>
        <source>Plan anyway</source>
        <translation>Planifier quand même</translation>
    </message>
    <message>
        <source>Plan every setup, each on the stock that those before it leave (Shift+F5)</source>
        <translation>Planifier chaque posage, chacun sur le brut que laissent les précédents (Maj+F5)</translation>
    </message>
    <message>
        <source>Plan that much?</source>
        <translation>Planifier autant ?</translation>
    </message>
    <message>
        <source>Plan this operation</source>
        <translation>Planifier cette opération</translation>
    </message>
    <message>
        <source>Plan what is not planned yet, and judge all setups as one job (Shift+F6)</source>
        <translation>Planifier ce qui ne l'est pas encore, et juger tous les posages en un seul travail (Maj+F6)</translation>
    </message>
    <message>
        <source>Plan “%1” to see its strips here</source>
        <translation>Planifier « %1 » pour voir ses bandes ici</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Planifié</translation>
    </message>
    <message>
        <source>Planned %1 of %2, judged coarsely %3 of about %4, finely %5 of about %6.</source>
        <translation>Planifiés %1 sur %2, jugés grossièrement %3 sur environ %4, finement %5 sur environ %6.</translation>
    </message>
    <message>
        <source>Planned as kept: </source>
        <translation>Planifié comme gardé : </translation>
    </message>
    <message>
        <source>Planned in</source>
        <translation>Planifié en</translation>
    </message>
    <message numerus="yes">
        <source>Planned “%1” in %2: %3 passes, cut length %4, machining time %5.</source>
        <translation><numerusform>« %1 » planifié en %2 : %3 passe, longueur de coupe %4, temps d'usinage %5.</numerusform><numerusform>« %1 » planifié en %2 : %3 passes, longueur de coupe %4, temps d'usinage %5.</numerusform></translation>
    </message>
    <message>
        <source>Planned: </source>
        <translation>Planifié : </translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planification</translation>
    </message>
    <message>
        <source>Planning all setups</source>
        <translation>Planification de tous les posages</translation>
    </message>
    <message>
        <source>Planning and judging operations for this part</source>
        <translation>Des opérations pour cette pièce sont planifiées et jugées</translation>
    </message>
    <message>
        <source>Planning and judging operations for this part: %1</source>
        <translation>Des opérations pour cette pièce sont planifiées et jugées : %1</translation>
    </message>
    <message>
        <source>Planning and verifying it takes about %1</source>
        <translation>La planifier et la vérifier demande environ %1</translation>
    </message>
    <message>
        <source>Planning it takes %1.</source>
        <translation>La planifier demande %1.</translation>
    </message>
    <message>
        <source>Plate below</source>
        <translation>Plaque dessous</translation>
    </message>
    <message>
        <source>Play (Space)</source>
        <translation>Lecture (Espace)</translation>
    </message>
    <message>
        <source>Point before on the pass (←; Shift: ten)</source>
        <translation>Point précédent de la passe (← ; Maj : dix)</translation>
    </message>
    <message>
        <source>Points with a posture kept by hand</source>
        <translation>Points à posture gardée à la main</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>Pré&amp;férences…</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>Préférences</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Préparer</translation>
    </message>
    <message>
        <source>Press Plan (F5) to plan it.</source>
        <translation>Planifier (F5) pour la planifier.</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message numerus="yes">
        <source>Preview: %1 layers</source>
        <translation><numerusform>Aperçu : %1 niveau</numerusform><numerusform>Aperçu : %1 niveaux</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>Preview: about %1 passes</source>
        <translation><numerusform>Aperçu : environ %1 passe</numerusform><numerusform>Aperçu : environ %1 passes</numerusform></translation>
    </message>
    <message>
        <source>Previewing passes</source>
        <translation>Aperçu des passes</translation>
    </message>
    <message>
        <source>Previous tool at the picked point</source>
        <translation>Outil précédent au point choisi</translation>
    </message>
    <message>
        <source>Principal axes</source>
        <translation>Axes principaux</translation>
    </message>
    <message>
        <source>Programs count from here; a corner or an edge nearby is taken exactly</source>
        <translation>Les programmes comptent d'ici ; un sommet ou une arête proche est pris exactement</translation>
    </message>
    <message>
        <source>Programs count from the origin of the part's coordinates</source>
        <translation>Les programmes comptent de l'origine des coordonnées de la pièce</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Progress of the preview</source>
        <translation>Progression de l'aperçu</translation>
    </message>
    <message>
        <source>Project</source>
        <translation>Projet</translation>
    </message>
    <message>
        <source>Put the chosen candidate into the project, as one step that Undo takes back</source>
        <translation>Mettre le candidat choisi dans le projet, en une étape qu'Annuler défait</translation>
    </message>
    <message>
        <source>Put the steps away</source>
        <translation>Ranger les étapes</translation>
    </message>
    <message>
        <source>Put the steps away; Help shows them again</source>
        <translation>Ranger les étapes ; Aide les montre de nouveau</translation>
    </message>
    <message>
        <source>Put the tools of the project into a library of its name</source>
        <translation>Mettre les outils du projet dans une bibliothèque à son nom</translation>
    </message>
    <message>
        <source>Puts steps for what was found in the place of the recipe, to be changed</source>
        <translation>Met à la place de la recette des étapes pour ce qui a été trouvé, à modifier</translation>
    </message>
    <message>
        <source>Puts the recipe into the project, as one step that can be undone</source>
        <translation>Met la recette dans le projet, en une étape que l'on peut annuler</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Question</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Plage</translation>
    </message>
    <message>
        <source>Range from the tolerance</source>
        <translation>Plage selon la tolérance</translation>
    </message>
    <message>
        <source>Range of slope</source>
        <translation>Plage de pente</translation>
    </message>
    <message>
        <source>Range: %1</source>
        <translation>Plage : %1</translation>
    </message>
    <message>
        <source>Rapid</source>
        <translation>Rapide</translation>
    </message>
    <message>
        <source>Rapid length</source>
        <translation>Longueur en rapide</translation>
    </message>
    <message>
        <source>Rapids</source>
        <translation>Rapides</translation>
    </message>
    <message>
        <source>Re&amp;place part…</source>
        <translation>Remp&amp;lacer la pièce…</translation>
    </message>
    <message>
        <source>Read %1: %2 facets.</source>
        <translation>%1 lu : %2 facettes.</translation>
    </message>
    <message>
        <source>Read over: %1</source>
        <translation>Ignoré : %1</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>Reading what was planned</source>
        <translation>Lecture de ce qui était planifié</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Recette</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Zones</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove boundary</source>
        <translation>Supprimer la limite</translation>
    </message>
    <message>
        <source>Remove fixture</source>
        <translation>Supprimer le bridage</translation>
    </message>
    <message>
        <source>Remove kept posture</source>
        <translation>Supprimer la posture gardée</translation>
    </message>
    <message>
        <source>Remove operation</source>
        <translation>Supprimer l'opération</translation>
    </message>
    <message>
        <source>Remove setup</source>
        <translation>Supprimer le posage</translation>
    </message>
    <message>
        <source>Remove the selected material</source>
        <translation>Supprimer la matière choisie</translation>
    </message>
    <message>
        <source>Remove the selected section</source>
        <translation>Supprimer la section choisie</translation>
    </message>
    <message>
        <source>Remove the step (Del)</source>
        <translation>Supprimer l'étape (Suppr)</translation>
    </message>
    <message>
        <source>Remove tool</source>
        <translation>Supprimer l'outil</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Rename boundary</source>
        <translation>Renommer la limite</translation>
    </message>
    <message>
        <source>Rename fixture</source>
        <translation>Renommer le bridage</translation>
    </message>
    <message>
        <source>Rename operation</source>
        <translation>Renommer l'opération</translation>
    </message>
    <message>
        <source>Rename setup</source>
        <translation>Renommer le posage</translation>
    </message>
    <message>
        <source>Repair part</source>
        <translation>Réparer la pièce</translation>
    </message>
    <message>
        <source>Replace part</source>
        <translation>Remplacer la pièce</translation>
    </message>
    <message>
        <source>Replaced there: %1.</source>
        <translation>Remplacés là : %1.</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Rapport</translation>
    </message>
    <message>
        <source>Report of the candidate</source>
        <translation>Rapport du candidat</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Résolution</translation>
    </message>
    <message>
        <source>Rest</source>
        <translation>Reste</translation>
    </message>
    <message>
        <source>Rest material</source>
        <translation>Matière restante</translation>
    </message>
    <message>
        <source>Restored “%1” as it stood on %2. Save it: until then it is kept in %3.</source>
        <translation>« %1 » restauré tel qu'il était le %2. L'enregistrer : jusque-là il est gardé dans %3.</translation>
    </message>
    <message>
        <source>Rework</source>
        <translation>Reprise</translation>
    </message>
    <message>
        <source>Rework (% of the surface)</source>
        <translation>Reprise (% de la surface)</translation>
    </message>
    <message>
        <source>Rework and clean-up regions on the part's surface</source>
        <translation>Zones de reprise et de nettoyage sur la surface de la pièce</translation>
    </message>
    <message>
        <source>Rework regions</source>
        <translation>Zones de reprise</translation>
    </message>
    <message>
        <source>Rework regions…</source>
        <translation>Zones de reprise…</translation>
    </message>
    <message>
        <source>Roll anticlockwise</source>
        <translation>Rouler vers la gauche</translation>
    </message>
    <message>
        <source>Roll clockwise</source>
        <translation>Rouler vers la droite</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>Ébauche</translation>
    </message>
    <message>
        <source>Running these programs can damage part, tool and machine.</source>
        <translation>Exécuter ces programmes peut abîmer pièce, outil et machine.</translation>
    </message>
    <message>
        <source>Runs along the valleys that the cutter touches on both sides, and beside them</source>
        <translation>Suit les vallées que la fraise touche des deux côtés, et leurs abords</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>Arrê&amp;ter</translation>
    </message>
    <message>
        <source>S&amp;uggest an operation…</source>
        <translation>Propo&amp;ser une opération…</translation>
    </message>
    <message>
        <source>Sa&amp;ve as template…</source>
        <translation>Enregistrer comme &amp;modèle…</translation>
    </message>
    <message>
        <source>Same tool axis for all operations</source>
        <translation>Même axe d'outil pour toutes les opérations</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Samples</source>
        <comment>places looked at</comment>
        <translation>Points mesurés</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save as template</source>
        <translation>Enregistrer comme modèle</translation>
    </message>
    <message>
        <source>Save pac&amp;ked copy…</source>
        <translation>Enregistrer une &amp;copie compressée…</translation>
    </message>
    <message>
        <source>Save packed copy</source>
        <translation>Enregistrer une copie compressée</translation>
    </message>
    <message>
        <source>Save project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Enregistrer les modifications de « %1 » ?</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 enregistré.</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>Enregistrement de %1…</translation>
    </message>
    <message>
        <source>Say where a file is that the project names and that is not there</source>
        <translation>Dire où est un fichier que le projet nomme et qui manque</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Scale part by %1</source>
        <translation>Mettre la pièce à l'échelle %1</translation>
    </message>
    <message>
        <source>Scan room</source>
        <translation>Atelier de scan</translation>
    </message>
    <message numerus="yes">
        <source>Scan room: %1 steps…</source>
        <translation><numerusform>Atelier de scan : %1 étape…</numerusform><numerusform>Atelier de scan : %1 étapes…</numerusform></translation>
    </message>
    <message>
        <source>Scan room…</source>
        <translation>Atelier de scan…</translation>
    </message>
    <message>
        <source>Scan that goes on where this one ends</source>
        <translation>Numérisation qui continue là où celle-ci s’arrête</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Search the manual (Ctrl+F)</source>
        <translation>Chercher dans le manuel (Ctrl+F)</translation>
    </message>
    <message>
        <source>See the part turn under a standing tool, as on the machine</source>
        <translation>Voir la pièce tourner sous un outil fixe, comme sur la machine</translation>
    </message>
    <message>
        <source>Seen from above: 0° leans towards X, 90° towards Y</source>
        <translation>Vu d'en haut : 0° penche vers X, 90° vers Y</translation>
    </message>
    <message>
        <source>Select something in the project to see its parameters.</source>
        <translation>Choisir quelque chose dans le projet pour voir ses paramètres.</translation>
    </message>
    <message>
        <source>Set the lead limit to it</source>
        <translation>Y fixer la limite d'attaque</translation>
    </message>
    <message>
        <source>Set work zero</source>
        <translation>Fixer l'origine de la pièce</translation>
    </message>
    <message>
        <source>Sets corner radius and angles; every value can be changed afterwards.</source>
        <translation>Fixe rayon de coin et angles ; chaque valeur peut être changée ensuite.</translation>
    </message>
    <message>
        <source>Settings of Rework Region</source>
        <translation>Réglages des zones de reprise</translation>
    </message>
    <message>
        <source>Settings of Rework Region – %1</source>
        <translation>Réglages des zones de reprise – %1</translation>
    </message>
    <message>
        <source>Settings of Rework Region: see, limit and edit what the smaller tool cuts</source>
        <translation>Réglages des zones de reprise : voir, limiter et modifier ce que l'outil plus petit usine</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Posage</translation>
    </message>
    <message>
        <source>Shank</source>
        <translation>Queue</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Share of the area, highest %1</source>
        <translation>Part de l'aire, au plus %1</translation>
    </message>
    <message>
        <source>Share of the surface that faces the table without lying on it: no tool from above comes there</source>
        <translation>Part de la surface qui regarde la table sans y reposer : aucun outil n'y vient d'en haut</translation>
    </message>
    <message>
        <source>Shells</source>
        <translation>Coques</translation>
    </message>
    <message>
        <source>Shells: facets that are joined by edges. A click goes to one.</source>
        <translation>Coques : facettes jointes par des arêtes. Un clic va à l'une d'elles.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Show all of it (double click, Home)</source>
        <translation>Tout afficher (double-clic, Début)</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Afficher la pièce</translation>
    </message>
    <message>
        <source>Show paths</source>
        <translation>Afficher les parcours</translation>
    </message>
    <message>
        <source>Show stock</source>
        <translation>Afficher le brut</translation>
    </message>
    <message>
        <source>Show the &amp;steps of a first job</source>
        <translation>Montrer les étap&amp;es d'un premier travail</translation>
    </message>
    <message>
        <source>Show the whole chart (double click, Home)</source>
        <translation>Afficher tout le diagramme (double-clic, Début)</translation>
    </message>
    <message>
        <source>Show their folder</source>
        <translation>Afficher leur dossier</translation>
    </message>
    <message>
        <source>Show, play back and verify an existing program (%1) without planning</source>
        <translation>Afficher, rejouer et vérifier un programme existant (%1) sans planifier</translation>
    </message>
    <message>
        <source>Showing %1 in place of the plan, until something is planned or File &gt; Close program.</source>
        <translation>%1 est affiché à la place du plan, jusqu'à ce que quelque chose soit planifié ou Fichier &gt; Fermer le programme.</translation>
    </message>
    <message>
        <source>Shows the stock as it stands after “%1”</source>
        <translation>Montre le brut tel qu'il est après « %1 »</translation>
    </message>
    <message>
        <source>Shows the tool that cut before, where it touches the part at two places over the strip and can go no deeper. Clicks on a strip in the view then mean the strip, not the path on it.</source>
        <translation>Montre l'outil qui a usiné avant, là où il touche la pièce en deux endroits au-dessus de la bande et ne peut aller plus bas. Les clics sur une bande dans la vue désignent alors la bande, pas le parcours qui s'y trouve.</translation>
    </message>
    <message>
        <source>Shrink</source>
        <translation>Réduire</translation>
    </message>
    <message>
        <source>Shrink painted facets</source>
        <translation>Réduire les facettes peintes</translation>
    </message>
    <message>
        <source>Side feed</source>
        <translation>Avance latérale</translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation>Silhouette</translation>
    </message>
    <message>
        <source>Silhouette of the part</source>
        <translation>Silhouette de la pièce</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simuler</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Taille : %1</translation>
    </message>
    <message>
        <source>Size: %1, scaled by %2</source>
        <translation>Taille : %1, à l'échelle %2</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Pente</translation>
    </message>
    <message>
        <source>Slope from level at which the part is divided: what is steeper is cut by levels</source>
        <translation>Pente par rapport à l’horizontale à laquelle la pièce est divisée : ce qui est plus raide est usiné par niveaux</translation>
    </message>
    <message>
        <source>Small pieces</source>
        <translation>Petits morceaux</translation>
    </message>
    <message>
        <source>Smaller letters (Ctrl+−)</source>
        <translation>Lettres plus petites (Ctrl+−)</translation>
    </message>
    <message>
        <source>Smallest stock</source>
        <translation>Brut le plus petit</translation>
    </message>
    <message>
        <source>Smooth noise</source>
        <translation>Lisser le bruit</translation>
    </message>
    <message>
        <source>So many of the combinations, chosen by chance, the same each time; 0: all</source>
        <translation>Autant de combinaisons, choisies au hasard, les mêmes à chaque fois ; 0 : toutes</translation>
    </message>
    <message>
        <source>SolidWorks</source>
        <translation>SolidWorks</translation>
    </message>
    <message>
        <source>Some libraries cannot be read</source>
        <translation>Certaines bibliothèques sont illisibles</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Special</source>
        <translation>Spécial</translation>
    </message>
    <message>
        <source>Square up</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Square up part</source>
        <translation>Redresser la pièce</translation>
    </message>
    <message>
        <source>Stages</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Stages of the study</source>
        <translation>Étapes de l'étude</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Rang</translation>
    </message>
    <message>
        <source>Step %1 could not be carried out.</source>
        <translation>L'étape %1 n'a pu être exécutée.</translation>
    </message>
    <message>
        <source>Step %1 is with Slurm, jobs %2 and %3.</source>
        <translation>L'étape %1 est chez Slurm, travaux %2 et %3.</translation>
    </message>
    <message>
        <source>Step-over</source>
        <translation>Pas latéral</translation>
    </message>
    <message>
        <source>Step-over (%1)</source>
        <translation>Pas latéral (%1)</translation>
    </message>
    <message>
        <source>Steps of the recipe</source>
        <translation>Étapes de la recette</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Brut</translation>
    </message>
    <message>
        <source>Stock after it</source>
        <translation>Brut ensuite</translation>
    </message>
    <message>
        <source>Stock after “%1”</source>
        <translation>Brut après « %1 »</translation>
    </message>
    <message>
        <source>Stock mesh</source>
        <translation>Maillage du brut</translation>
    </message>
    <message>
        <source>Stock turns in</source>
        <translation>Le brut tourne dans</translation>
    </message>
    <message>
        <source>Stock: %1</source>
        <translation>Brut : %1</translation>
    </message>
    <message>
        <source>Stock: box</source>
        <translation>Brut : boîte</translation>
    </message>
    <message>
        <source>Stock: cylinder</source>
        <translation>Brut : cylindre</translation>
    </message>
    <message>
        <source>Stock: rest of “%1”</source>
        <translation>Brut : reste de « %1 »</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stop the preview (Esc)</source>
        <translation>Arrêter l'aperçu (Échap)</translation>
    </message>
    <message>
        <source>Stopped. Nothing is suggested.</source>
        <translation>Arrêté. Rien n’est proposé.</translation>
    </message>
    <message>
        <source>Stopped. Resume goes on with what was found.</source>
        <translation>Arrêté. Reprendre continue avec ce qui est trouvé.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Arrêt…</translation>
    </message>
    <message>
        <source>Straighten, move, mirror</source>
        <translation>Redresser, déplacer, refléter</translation>
    </message>
    <message>
        <source>Strategy</source>
        <translation>Stratégie</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Bande</translation>
    </message>
    <message>
        <source>Strips</source>
        <translation>Bandes</translation>
    </message>
    <message>
        <source>Strips of clean-up come here: add a clean-up operation and plan it</source>
        <translation>Ici viennent les bandes du nettoyage : ajouter une opération de nettoyage et la planifier</translation>
    </message>
    <message>
        <source>Stud&amp;y…</source>
        <translation>Étu&amp;de…</translation>
    </message>
    <message>
        <source>Studies (*.study.json request.json)</source>
        <translation>Études (*.study.json request.json)</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Étude</translation>
    </message>
    <message>
        <source>Su&amp;ggest</source>
        <translation>Su&amp;ggérer</translation>
    </message>
    <message>
        <source>Suggest an operation</source>
        <translation>Proposer une opération</translation>
    </message>
    <message>
        <source>Suggestions</source>
        <translation>Propositions</translation>
    </message>
    <message>
        <source>Surface to rework</source>
        <translation>Surface à reprendre</translation>
    </message>
    <message>
        <source>Switch %1 off</source>
        <translation>Désactiver %1</translation>
    </message>
    <message>
        <source>Switch %1 on</source>
        <translation>Activer %1</translation>
    </message>
    <message>
        <source>Switch off operation</source>
        <translation>Désactiver l'opération</translation>
    </message>
    <message>
        <source>Switch on operation</source>
        <translation>Activer l'opération</translation>
    </message>
    <message>
        <source>Switch region off</source>
        <translation>Désactiver la zone</translation>
    </message>
    <message>
        <source>Switch region on</source>
        <translation>Activer la zone</translation>
    </message>
    <message>
        <source>Switched off</source>
        <translation>Désactivé</translation>
    </message>
    <message>
        <source>Switched off: it is not cut</source>
        <translation>Désactivée : elle n'est pas usinée</translation>
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
        <translation>T%1 dans les zones</translation>
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
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Tabs round the part</source>
        <translation>Attaches autour de la pièce</translation>
    </message>
    <message>
        <source>Take a holder of the tool library</source>
        <translation>Prendre un porte-outil de la bibliothèque</translation>
    </message>
    <message>
        <source>Take all facets out</source>
        <translation>Retirer toutes les facettes</translation>
    </message>
    <message>
        <source>Take facets out. Shift does the other of the two.</source>
        <translation>Retirer des facettes. Maj fait l'autre des deux.</translation>
    </message>
    <message>
        <source>Take in what lies so near, along edges</source>
        <translation>Prendre ce qui est aussi près, le long des arêtes</translation>
    </message>
    <message>
        <source>Take out what lies so near to the border, along edges</source>
        <translation>Retirer ce qui est aussi près du bord, le long des arêtes</translation>
    </message>
    <message>
        <source>Take over tools of FreeCAD, Fusion, LinuxCNC, CAMotics or Kiri:Moto</source>
        <translation>Reprendre les outils de FreeCAD, Fusion, LinuxCNC, CAMotics ou Kiri:Moto</translation>
    </message>
    <message>
        <source>Takes %1 times as long as the quickest</source>
        <translation>Dure %1 fois plus que la plus rapide</translation>
    </message>
    <message>
        <source>Takes away what lies beyond a plane and closes the section.</source>
        <translation>Enlève ce qui est au-delà d'un plan et ferme la section.</translation>
    </message>
    <message>
        <source>Takes facets away that say nothing, within the bound.</source>
        <translation>Enlève les facettes qui ne disent rien, dans la limite.</translation>
    </message>
    <message>
        <source>Takes facets without height away; nothing moves farther than the bound.</source>
        <translation>Enlève les facettes sans hauteur ; rien ne bouge plus que la limite.</translation>
    </message>
    <message>
        <source>Takes loose pieces away that are smaller than a limit.</source>
        <translation>Enlève les morceaux détachés plus petits qu'une limite.</translation>
    </message>
    <message>
        <source>Takes sheets away that hang on the surface and end in the open.</source>
        <translation>Enlève les feuilles qui pendent de la surface et finissent dans le vide.</translation>
    </message>
    <message>
        <source>Takes short waves away; nothing moves farther than the bound, sharp edges stay.</source>
        <translation>Enlève les ondes courtes ; rien ne bouge plus que la limite, les arêtes vives restent.</translation>
    </message>
    <message>
        <source>Takes the stock down layer by layer, and leaves an allowance</source>
        <translation>Enlève le brut niveau par niveau, et laisse une surépaisseur</translation>
    </message>
    <message>
        <source>Takes the stock of a turning part down in passes</source>
        <translation>Enlève en passes le brut d'une pièce qui tourne</translation>
    </message>
    <message>
        <source>Tapered ball</source>
        <translation>Conique hémisphérique</translation>
    </message>
    <message>
        <source>Tapered flat</source>
        <translation>Conique à bout plat</translation>
    </message>
    <message>
        <source>Templates (*%1)</source>
        <translation>Modèles (*%1)</translation>
    </message>
    <message>
        <source>Texts and numbers of the window; programs and files are the same in all of them</source>
        <translation>Textes et nombres de la fenêtre ; programmes et fichiers sont les mêmes dans toutes</translation>
    </message>
    <message>
        <source>That is beside the part: click on it, or press Esc.</source>
        <translation>C'est à côté de la pièce : cliquer dessus, ou Échap.</translation>
    </message>
    <message>
        <source>The 3D view cannot be shown: %1.

Install a graphics driver, or use facetmill-cli.</source>
        <translation>La vue 3D ne peut être affichée : %1.

Installer un pilote graphique, ou utiliser facetmill-cli.</translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations by previews of their passes. Planning all of them, to judge what they leave, would take long: add one, then plan and verify it.</source>
        <translation><numerusform>La meilleure de %1 opération d’après l’aperçu de ses passes. Les planifier toutes, pour juger ce qu’elles laissent, serait long : en ajouter une, puis la planifier et la vérifier.</numerusform><numerusform>Les meilleures de %1 opérations d’après l’aperçu de leurs passes. Les planifier toutes, pour juger ce qu’elles laissent, serait long : en ajouter une, puis la planifier et la vérifier.</numerusform></translation>
    </message>
    <message numerus="yes">
        <source>The best of %1 operations that were planned for this part and the project's tools, by time and by what they leave</source>
        <translation><numerusform>La meilleure de %1 opération planifiée pour cette pièce et les outils du projet, selon le temps et ce qu’elle laisse</numerusform><numerusform>Les meilleures de %1 opérations planifiées pour cette pièce et les outils du projet, selon le temps et ce qu’elles laissent</numerusform></translation>
    </message>
    <message>
        <source>The box takes facets that are not seen from here as well</source>
        <translation>Le rectangle prend aussi les facettes qu'on ne voit pas d'ici</translation>
    </message>
    <message>
        <source>The candidate is planned and judged</source>
        <translation>Le candidat est planifié et jugé</translation>
    </message>
    <message>
        <source>The clipboard holds no operation: copy one in the tree first (Ctrl+C).</source>
        <translation>Le presse-papiers ne contient pas d'opération : en copier d'abord une dans l'arbre (Ctrl+C).</translation>
    </message>
    <message>
        <source>The edges of all facets</source>
        <translation>Les arêtes de toutes les facettes</translation>
    </message>
    <message>
        <source>The face is level now and %1 above the table: something else of the part reaches lower.</source>
        <translation>La face est horizontale maintenant et à %1 au-dessus de la table : autre chose de la pièce descend plus bas.</translation>
    </message>
    <message>
        <source>The face under the pointer comes down on the table</source>
        <translation>La face sous le pointeur vient sur la table</translation>
    </message>
    <message>
        <source>The file of the part is missing</source>
        <translation>Le fichier de la pièce manque</translation>
    </message>
    <message>
        <source>The file of the part is missing.</source>
        <translation>Le fichier de la pièce manque.</translation>
    </message>
    <message>
        <source>The folder is made.</source>
        <translation>Le dossier est créé.</translation>
    </message>
    <message>
        <source>The folder is not empty: write the name of a new one.</source>
        <translation>Le dossier n'est pas vide : écrire le nom d'un nouveau.</translation>
    </message>
    <message>
        <source>The left button paints, with Shift it erases; beside the part and with Ctrl it turns the view. Esc ends it.</source>
        <translation>Le bouton gauche peint, avec Maj il efface ; à côté de la pièce et avec Ctrl il tourne la vue. Échap termine.</translation>
    </message>
    <message>
        <source>The library has no holders</source>
        <translation>La bibliothèque n'a pas de porte-outils</translation>
    </message>
    <message>
        <source>The list had no tool for this operation: T%1 %2 was added to it. Change it to one that you have.</source>
        <translation>La liste n'avait pas d'outil pour cette opération : T%1 %2 y a été ajouté. Le remplacer par un outil disponible.</translation>
    </message>
    <message>
        <source>The machine “%1” has no rotary axis</source>
        <translation>La machine « %1 » n'a pas d'axe rotatif</translation>
    </message>
    <message>
        <source>The manual at the place of what has the keys (F1)</source>
        <translation>Le manuel à l'endroit de ce qui a le clavier (F1)</translation>
    </message>
    <message>
        <source>The mesh has %1. It is machined as it is; the scan room makes it worth machining.</source>
        <translation>Le maillage a %1. Il est usiné tel quel ; l'atelier de scan permet de le réparer.</translation>
    </message>
    <message>
        <source>The other computer as ssh knows it, such as mill2 or user@mill2; it lets you in by a key</source>
        <translation>L’autre ordinateur tel que ssh le connaît, comme mill2 ou user@mill2 ; il vous laisse entrer par une clé</translation>
    </message>
    <message>
        <source>The page after (Alt+→)</source>
        <translation>La page suivante (Alt+→)</translation>
    </message>
    <message>
        <source>The page before (Alt+←)</source>
        <translation>La page précédente (Alt+←)</translation>
    </message>
    <message>
        <source>The part as it lies, as STL, 3MF or PLY</source>
        <translation>La pièce comme elle est posée, en STL, 3MF ou PLY</translation>
    </message>
    <message>
        <source>The part as it lies, its stock and fixtures (F7)</source>
        <translation>La pièce posée, son brut et ses bridages (F7)</translation>
    </message>
    <message>
        <source>The part has not been read.</source>
        <translation>La pièce n'a pas été lue.</translation>
    </message>
    <message>
        <source>The part in the colours of what the verification found</source>
        <translation>La pièce aux couleurs de ce que la vérification a trouvé</translation>
    </message>
    <message>
        <source>The part in the colours of what the verification found (F9)</source>
        <translation>La pièce aux couleurs de ce que la vérification a trouvé (F9)</translation>
    </message>
    <message>
        <source>The part is %1 now, no longer as large as its file says. Cutters, allowances and tolerances stay as they are.</source>
        <translation>La pièce mesure %1 maintenant, plus la taille que dit son fichier. Fraises, surépaisseurs et tolérances ne changent pas.</translation>
    </message>
    <message>
        <source>The part is %1 times as large as its file says; cutters and tolerances are not.</source>
        <translation>La pièce est %1 fois aussi grande que le dit son fichier ; fraises et tolérances ne le sont pas.</translation>
    </message>
    <message>
        <source>The part is being read…</source>
        <translation>Lecture de la pièce…</translation>
    </message>
    <message>
        <source>The part is not read yet: there is nothing to pick.</source>
        <translation>La pièce n'est pas encore lue : il n'y a rien à choisir.</translation>
    </message>
    <message>
        <source>The part is still being turned. Do that again when it stands.</source>
        <translation>La pièce est encore en train d'être tournée. Recommencer quand elle est en place.</translation>
    </message>
    <message>
        <source>The part lies across its stock: squared up, the block about it is %1 % smaller.</source>
        <translation>La pièce est en travers de son brut : redressée, le bloc qui l'entoure est plus petit de %1 %.</translation>
    </message>
    <message>
        <source>The part lies so already.</source>
        <translation>La pièce est déjà posée ainsi.</translation>
    </message>
    <message>
        <source>The part turns under the tool</source>
        <translation>La pièce tourne sous l’outil</translation>
    </message>
    <message>
        <source>The part was not read</source>
        <translation>La pièce n'a pas été lue</translation>
    </message>
    <message>
        <source>The part's chord tolerance is fixed from now on: with another one the painted facets would be others. A boundary of faces stays without that.</source>
        <translation>La tolérance de corde de la pièce est fixée désormais : avec une autre les facettes peintes seraient différentes. Une limite de faces s'en passe.</translation>
    </message>
    <message>
        <source>The part's surface</source>
        <translation>La surface de la pièce</translation>
    </message>
    <message>
        <source>The path cannot be judged: %1.</source>
        <translation>Le parcours ne peut être jugé : %1.</translation>
    </message>
    <message>
        <source>The path failed verification: %1.</source>
        <translation>Le parcours a échoué à la vérification : %1.</translation>
    </message>
    <message>
        <source>The path has not been verified since the project was changed.</source>
        <translation>Le parcours n'a pas été vérifié depuis que le projet a changé.</translation>
    </message>
    <message>
        <source>The path has not been verified.</source>
        <translation>Le parcours n'a pas été vérifié.</translation>
    </message>
    <message>
        <source>The path has not been verified. Verifying cuts an independent model of the stock with it and compares what is left with the part (F6).</source>
        <translation>Le parcours n'a pas été vérifié. La vérification usine avec lui un modèle indépendant du brut et compare ce qui reste à la pièce (F6).</translation>
    </message>
    <message>
        <source>The paths of all operations, not that of the chosen one alone</source>
        <translation>Les parcours de toutes les opérations, pas seulement de celle choisie</translation>
    </message>
    <message>
        <source>The paths on the part (F8)</source>
        <translation>Les parcours sur la pièce (F8)</translation>
    </message>
    <message>
        <source>The picture that is seen, as PNG</source>
        <translation>L'image visible, en PNG</translation>
    </message>
    <message>
        <source>The posture kept for the point is forgotten. Plan again to choose one.</source>
        <translation>La posture gardée pour le point est oubliée. Planifier de nouveau pour en choisir une.</translation>
    </message>
    <message>
        <source>The programs and their report are written into a folder: %1.</source>
        <translation>Les programmes et leur rapport sont écrits dans un dossier : %1.</translation>
    </message>
    <message>
        <source>The project as it stands</source>
        <translation>Le projet tel quel</translation>
    </message>
    <message>
        <source>The project has changed since. What is shown here is of the plan as it was.</source>
        <translation>Le projet a changé depuis. Ce qui est montré ici vient du plan tel qu'il était.</translation>
    </message>
    <message>
        <source>The project has changed since: look again to be sure.</source>
        <translation>Le projet a changé depuis : cherchez de nouveau pour en être sûr.</translation>
    </message>
    <message>
        <source>The project's own file, %1, is newer: it was saved on %2. Restored, the older state is shown, and the file stays as it is until you save.</source>
        <translation>Le fichier du projet, %1, est plus récent : enregistré le %2. La restauration montre l'état plus ancien ; le fichier reste tel quel jusqu'à l'enregistrement.</translation>
    </message>
    <message>
        <source>The project's own file, %1, is not there any more.</source>
        <translation>Le fichier du projet, %1, n'existe plus.</translation>
    </message>
    <message>
        <source>The project's own file, %1, was last saved on %2, and stays as it is until you save.</source>
        <translation>Le fichier du projet, %1, a été enregistré le %2 et reste tel quel jusqu'au prochain enregistrement.</translation>
    </message>
    <message>
        <source>The quickest of these</source>
        <translation>La plus rapide parmi celles-ci</translation>
    </message>
    <message>
        <source>The raw material; during playback as it is cut</source>
        <translation>La matière brute ; pendant la lecture, telle qu'elle est usinée</translation>
    </message>
    <message>
        <source>The recipe is not the one of the preview.</source>
        <translation>La recette n'est pas celle de l'aperçu.</translation>
    </message>
    <message>
        <source>The recipe of the scan room was carried out</source>
        <translation>La recette de l'atelier de scan a été exécutée</translation>
    </message>
    <message>
        <source>The setup that is shown</source>
        <translation>Le posage affiché</translation>
    </message>
    <message>
        <source>The stock as the tool cuts it (F10)</source>
        <translation>Le brut tel que l'outil l'usine (F10)</translation>
    </message>
    <message>
        <source>The study is not at its end: Resume goes on with it.</source>
        <translation>L'étude n'est pas finie : Reprendre la continue.</translation>
    </message>
    <message>
        <source>The study is of another part, %1: open its project first.</source>
        <translation>L'étude est celle d'une autre pièce, %1 : ouvrir d'abord son projet.</translation>
    </message>
    <message>
        <source>The surface of the verdict with its deviations: as figures in PLY, as colours in 3MF and STL</source>
        <translation>La surface du verdict avec ses écarts : en chiffres dans PLY, en couleurs dans 3MF et STL</translation>
    </message>
    <message>
        <source>The template cannot be applied: %1</source>
        <translation>Le modèle ne peut être appliqué : %1</translation>
    </message>
    <message>
        <source>The template was not kept. %1</source>
        <translation>Le modèle n'a pas été gardé. %1</translation>
    </message>
    <message>
        <source>The tool at the picked point of the path</source>
        <translation>L'outil au point choisi du parcours</translation>
    </message>
    <message>
        <source>The tool leans as little as it has to here: postures are kept for operations that choose them</source>
        <translation>L’outil s’incline ici aussi peu que nécessaire : les postures sont gardées pour les opérations qui les choisissent</translation>
    </message>
    <message>
        <source>The tool leans with the surface, and leaves wide strips</source>
        <translation>L’outil s’incline avec la surface, et laisse de larges bandes</translation>
    </message>
    <message>
        <source>The tool leans, so that a flat or bull-nosed cutter leaves wide strips</source>
        <translation>L'outil penche, si bien qu'une fraise plate ou torique laisse de larges bandes</translation>
    </message>
    <message>
        <source>The tool's path</source>
        <translation>La trajectoire de l'outil</translation>
    </message>
    <message>
        <source>The tried posture is not free: it would not be used</source>
        <translation>La posture essayée n'est pas libre : elle ne serait pas utilisée</translation>
    </message>
    <message>
        <source>The view shows the file's mesh, and tinted what the recipe takes away</source>
        <translation>La vue montre le maillage du fichier, et teinté ce que la recette enlève</translation>
    </message>
    <message>
        <source>The view shows the stock as it stands when this operation has ended. The bar below the view plays it back.</source>
        <translation>La vue montre le brut tel qu'il est à la fin de cette opération. La barre sous la vue la rejoue.</translation>
    </message>
    <message>
        <source>The view shows what the recipe makes, in colours of how far it moved, and tinted what is new</source>
        <translation>La vue montre ce que fait la recette, en couleurs de son déplacement, et teinté ce qui est nouveau</translation>
    </message>
    <message>
        <source>The window speaks it after the next start.</source>
        <translation>La fenêtre la parle après le prochain démarrage.</translation>
    </message>
    <message>
        <source>The winner has the least</source>
        <translation>Le gagnant a le moins de</translation>
    </message>
    <message>
        <source>The zero is on the axis of a %1 of Ø %2, which is round to %3.</source>
        <translation>L'origine est sur l'axe : %1, Ø %2, rond à %3 près.</translation>
    </message>
    <message>
        <source>There are no regions while a value is not right.</source>
        <translation>Il n'y a pas de zones tant qu'une valeur est fausse.</translation>
    </message>
    <message>
        <source>There is a file of this name: write another one.</source>
        <translation>Un fichier porte ce nom : en écrire un autre.</translation>
    </message>
    <message>
        <source>There is a template “%1”. Replace it?</source>
        <translation>Il existe un modèle « %1 ». Le remplacer ?</translation>
    </message>
    <message>
        <source>There is no operation to plan: add one below the project tree.</source>
        <translation>Il n'y a pas d'opération à planifier : en ajouter une sous l'arbre du projet.</translation>
    </message>
    <message>
        <source>There is no operation to verify.</source>
        <translation>Il n'y a pas d'opération à vérifier.</translation>
    </message>
    <message>
        <source>There is no operation yet. Add one below the tree.</source>
        <translation>Pas encore d'opération. En ajouter une sous l'arbre.</translation>
    </message>
    <message>
        <source>There is no sample “%1”</source>
        <translation>Il n'y a pas d'exemple « %1 »</translation>
    </message>
    <message>
        <source>There is nothing to adopt.</source>
        <translation>Il n'y a rien à adopter.</translation>
    </message>
    <message>
        <source>There is nothing to compare</source>
        <translation>Il n'y a rien à comparer</translation>
    </message>
    <message>
        <source>There is nothing to export yet: not every operation is planned as it stands. Press Plan (F5) first.</source>
        <translation>Rien à exporter encore : toutes les opérations ne sont pas planifiées telles quelles. Planifier d'abord (F5).</translation>
    </message>
    <message>
        <source>There is nothing to export yet: this operation is not planned as it stands.</source>
        <translation>Rien à exporter encore : cette opération n'est pas planifiée telle quelle.</translation>
    </message>
    <message>
        <source>There is nothing to tell yet: not every operation is planned as it stands. Press Plan (F5) first.</source>
        <translation>Rien à dire encore : toutes les opérations ne sont pas planifiées telles quelles. Planifier d'abord (F5).</translation>
    </message>
    <message>
        <source>These are more than %1 combinations: let less vary, or try some of them.</source>
        <translation>Cela fait plus de %1 combinaisons : faire varier moins, ou n'en essayer qu'une partie.</translation>
    </message>
    <message>
        <source>These values make no cutter.
%1</source>
        <translation>Ces valeurs ne font pas une fraise.
%1</translation>
    </message>
    <message>
        <source>Thicken a sheet</source>
        <translation>Épaissir une feuille</translation>
    </message>
    <message>
        <source>This candidate has not been verified finely.</source>
        <translation>Ce candidat n'a pas été vérifié finement.</translation>
    </message>
    <message>
        <source>This is a file: choose a folder.</source>
        <translation>C'est un fichier : choisir un dossier.</translation>
    </message>
    <message>
        <source>This is more work than usual: a tolerance or a step-over may be too small.</source>
        <translation>C'est plus de travail que d'habitude : une tolérance ou un pas latéral est peut-être trop petit.</translation>
    </message>
    <message>
        <source>This lead limit leaves the whole part uncut: raise it, or take a smaller tool.</source>
        <translation>Cette limite d'attaque n'usine rien de la pièce : la relever ou prendre un outil plus petit.</translation>
    </message>
    <message>
        <source>This operation belongs to another setup. A double click in the tree goes there.</source>
        <translation>Cette opération appartient à un autre posage. Un double-clic dans l'arbre y va.</translation>
    </message>
    <message>
        <source>This recipe is in the project.</source>
        <translation>Cette recette est dans le projet.</translation>
    </message>
    <message>
        <source>This setup alone was judged, not the whole job.</source>
        <translation>Seul ce posage a été jugé, pas tout le travail.</translation>
    </message>
    <message>
        <source>Those that are ticked make the front; a limit is a number, or ×1.1 for 1.1 times what the project comes to</source>
        <translation>Ceux qui sont cochés forment le front ; une limite est un nombre, ou ×1,1 pour 1,1 fois ce à quoi le projet arrive</translation>
    </message>
    <message>
        <source>Tick the tools and strategies that may serve; write several numbers with a semicolon between them</source>
        <translation>Cocher les outils et les stratégies qui peuvent servir ; écrire plusieurs nombres séparés par un point-virgule</translation>
    </message>
    <message>
        <source>Time (%1)</source>
        <translation>Temps (%1)</translation>
    </message>
    <message>
        <source>Time (h)</source>
        <translation>Temps (h)</translation>
    </message>
    <message>
        <source>Time (min)</source>
        <translation>Temps (min)</translation>
    </message>
    <message>
        <source>Times as fast as the machine, or motions per second</source>
        <translation>Combien de fois plus vite que la machine, ou mouvements par seconde</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>To be kept small</source>
        <translation>À garder petit</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>À la fin</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>Vers la droite</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>To&amp;wards, from X</source>
        <translation>&amp;Vers, depuis X</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Outil</translation>
    </message>
    <message>
        <source>Tool %1 does not touch at two places along it.</source>
        <translation>L'outil %1 ne touche pas en deux endroits le long d'elle.</translation>
    </message>
    <message>
        <source>Tool %1 fits into it: its normals turn faster than the limit.</source>
        <translation>L'outil %1 y entre : ses normales tournent plus vite que la limite.</translation>
    </message>
    <message>
        <source>Tool %1 touches at %2 and %3 %4; it stays %5 above the bottom.</source>
        <translation>L'outil %1 touche à %2 et %3 %4 ; il reste à %5 au-dessus du fond.</translation>
    </message>
    <message>
        <source>Tool axis by angles</source>
        <translation>Axe d'outil par angles</translation>
    </message>
    <message>
        <source>Tool axis by angles…</source>
        <translation>Axe d'outil par angles…</translation>
    </message>
    <message>
        <source>Tool axis of &lt;b&gt;%1&lt;/b&gt;, from the tip to the spindle, as the setup holds the part</source>
        <translation>Axe d'outil de &lt;b&gt;%1&lt;/b&gt;, de la pointe à la broche, comme le posage tient la pièce</translation>
    </message>
    <message>
        <source>Tool back to the planned posture</source>
        <translation>Remettre l'outil à la posture planifiée</translation>
    </message>
    <message>
        <source>Tool changes</source>
        <translation>Changements d'outil</translation>
    </message>
    <message>
        <source>Tool diameter (%1), lead limit %2</source>
        <translation>Diamètre d'outil (%1), limite d'attaque %2</translation>
    </message>
    <message>
        <source>Tool libraries (*.fmtools *.json *.tools *.fctb *.fctl *.fcholder *.tbl);;All files (*)</source>
        <translation>Bibliothèques d'outils (*.fmtools *.json *.tools *.fctb *.fctl *.fcholder *.tbl);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Tool library</source>
        <translation>Bibliothèque d'outils</translation>
    </message>
    <message>
        <source>Tool library…</source>
        <translation>Bibliothèque d'outils…</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Tools and templates are kept here; those of another folder stay there. Empty: %1</source>
        <translation>Outils et modèles sont gardés ici ; ceux d'un autre dossier y restent. Vide : %1</translation>
    </message>
    <message>
        <source>Tools of the library</source>
        <translation>Outils de la bibliothèque</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>Trade-off</source>
        <translation>Compromis</translation>
    </message>
    <message>
        <source>Triangles of the mesh</source>
        <translation>Triangles du maillage</translation>
    </message>
    <message>
        <source>Tried: </source>
        <translation>Essayé : </translation>
    </message>
    <message>
        <source>Try a posture first: click in the configuration space, or drag a marker</source>
        <translation>Essayer d'abord une posture : cliquer dans l'espace des configurations, ou tirer un repère</translation>
    </message>
    <message>
        <source>Trying the recipe</source>
        <translation>Essai de la recette</translation>
    </message>
    <message>
        <source>Turn about X</source>
        <translation>Tourner autour de X</translation>
    </message>
    <message>
        <source>Turn about Y</source>
        <translation>Tourner autour de Y</translation>
    </message>
    <message>
        <source>Turn about Z</source>
        <translation>Tourner autour de Z</translation>
    </message>
    <message>
        <source>Turn by 90°</source>
        <translation>Tourner de 90°</translation>
    </message>
    <message>
        <source>Turn facets</source>
        <translation>Orienter les facettes</translation>
    </message>
    <message>
        <source>Turn part</source>
        <translation>Tourner la pièce</translation>
    </message>
    <message>
        <source>Turn part about %1</source>
        <translation>Tourner la pièce autour de %1</translation>
    </message>
    <message>
        <source>Turn: Shift + middle button</source>
        <translation>Tourner : Maj + bouton du milieu</translation>
    </message>
    <message>
        <source>Turn: left button</source>
        <translation>Tourner : bouton gauche</translation>
    </message>
    <message>
        <source>Turn: middle and left button, or Shift + right</source>
        <translation>Tourner : boutons milieu et gauche, ou Maj + droit</translation>
    </message>
    <message>
        <source>Turn: middle button</source>
        <translation>Tourner : bouton du milieu</translation>
    </message>
    <message>
        <source>Turned over about X, same zero</source>
        <translation>Retourné autour de X, même origine</translation>
    </message>
    <message>
        <source>Turned over about Y, same zero</source>
        <translation>Retourné autour de Y, même origine</translation>
    </message>
    <message>
        <source>Turning angle</source>
        <translation>Angle de rotation</translation>
    </message>
    <message>
        <source>Turns are by the right hand about the middle of the part's box. Rings and arrows in the view do the same by the mouse, with Shift in round steps. Scaling keeps that and the lowest point; cutters and tolerances stay as they are.</source>
        <translation>Les rotations suivent la main droite autour du milieu de la boîte de la pièce. Anneaux et flèches dans la vue font de même à la souris, avec Maj par pas ronds. L'échelle garde ce milieu et le point le plus bas ; fraises et tolérances ne changent pas.</translation>
    </message>
    <message>
        <source>Turns facets to agree with their neighbours and shells outward; doubles go.</source>
        <translation>Oriente les facettes comme leurs voisines et les coques vers l'extérieur ; les doubles partent.</translation>
    </message>
    <message>
        <source>Turns the part about Z until its box is smallest, the longer side along X</source>
        <translation>Tourne la pièce autour de Z jusqu'à ce que sa boîte soit la plus petite, le grand côté selon X</translation>
    </message>
    <message>
        <source>Turns the part by %190° about %2, by the right hand; its lowest point comes to Z 0</source>
        <translation>Tourne la pièce de %190° autour de %2, selon la main droite ; son point le plus bas vient à Z 0</translation>
    </message>
    <message>
        <source>Turns the part so that it is longest along X and shortest along Z, by the moments of its surface</source>
        <translation>Tourne la pièce pour qu'elle soit la plus longue selon X et la plus courte selon Z, d'après les moments de sa surface</translation>
    </message>
    <message>
        <source>Turns the part so that the face marked in the view comes down to Z 0</source>
        <translation>Tourne la pièce pour que la face marquée dans la vue descende à Z 0</translation>
    </message>
    <message>
        <source>Two contacts</source>
        <translation>Deux contacts</translation>
    </message>
    <message>
        <source>Two measures against each other; the line joins the best</source>
        <translation>Deux mesures l'une contre l'autre ; la ligne joint les meilleurs</translation>
    </message>
    <message>
        <source>Two numbers with a blank between them, %1; a semicolon between one pair and the next</source>
        <translation>Deux nombres séparés par une espace, %1 ; un point-virgule entre une paire et la suivante</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Un&amp;it</source>
        <translation>Un&amp;ité</translation>
    </message>
    <message>
        <source>Uncut</source>
        <translation>Non usiné</translation>
    </message>
    <message>
        <source>Uncut, allowed %1</source>
        <translation>Non usiné, permis : %1</translation>
    </message>
    <message>
        <source>Unit of the part</source>
        <translation>Unité de la pièce</translation>
    </message>
    <message>
        <source>Unit of the project: of all fields, reports and written programs</source>
        <translation>Unité du projet : de tous les champs, rapports et programmes écrits</translation>
    </message>
    <message>
        <source>Unpack in</source>
        <translation>Décompresser dans</translation>
    </message>
    <message>
        <source>Unpack project</source>
        <translation>Décompresser le projet</translation>
    </message>
    <message>
        <source>Unpacked %1 files into %2.</source>
        <translation>%1 fichiers décompressés dans %2.</translation>
    </message>
    <message>
        <source>Unpacking %1</source>
        <translation>Décompression de %1</translation>
    </message>
    <message>
        <source>Unrolled</source>
        <translation>Déroulé</translation>
    </message>
    <message>
        <source>Unrolled path</source>
        <translation>Parcours déroulé</translation>
    </message>
    <message>
        <source>Unrolling the path</source>
        <translation>Déroulement du parcours</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>Upward</source>
        <translation>Vers le haut</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Verification</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Verification failed (in %1): %2.</source>
        <translation>Vérification échouée (en %1) : %2.</translation>
    </message>
    <message>
        <source>Verification limits</source>
        <translation>Limites de la vérification</translation>
    </message>
    <message>
        <source>Verification out of date</source>
        <translation>Vérification périmée</translation>
    </message>
    <message>
        <source>Verification out of date: the project has changed since</source>
        <translation>Vérification périmée : le projet a changé depuis</translation>
    </message>
    <message>
        <source>Verified</source>
        <translation>Vérifié</translation>
    </message>
    <message>
        <source>Verified in %1: %2: no gouge, no collision.</source>
        <translation>Vérifié en %1 : %2 : aucune entaille, aucune collision.</translation>
    </message>
    <message>
        <source>Verified in %1: no gouge, no collision.</source>
        <translation>Vérifié en %1 : aucune entaille, aucune collision.</translation>
    </message>
    <message>
        <source>Verified: %1: no gouge, no collision</source>
        <translation>Vérifié : %1 : aucune entaille, aucune collision</translation>
    </message>
    <message>
        <source>Verified: no gouge, no collision</source>
        <translation>Vérifié : aucune entaille, aucune collision</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Verify again</source>
        <translation>Vérifier de nouveau</translation>
    </message>
    <message>
        <source>Verify again (F6), or export programs that nobody has checked since.</source>
        <translation>Vérifier de nouveau (F6), ou exporter des programmes que personne n'a contrôlés depuis.</translation>
    </message>
    <message>
        <source>Verify all of them (F6), or export some that nobody has checked.</source>
        <translation>Tout vérifier (F6), ou en exporter que personne n'a contrôlés.</translation>
    </message>
    <message>
        <source>Verify all se&amp;tups</source>
        <translation>Vérifier tous les posa&amp;ges</translation>
    </message>
    <message>
        <source>Verify all setups</source>
        <translation>Vérifier tous les posages</translation>
    </message>
    <message>
        <source>Verify anyway</source>
        <translation>Vérifier quand même</translation>
    </message>
    <message>
        <source>Verify first (F6), or export programs that nobody has checked.</source>
        <translation>Vérifier d'abord (F6), ou exporter des programmes que personne n'a vérifiés.</translation>
    </message>
    <message>
        <source>Verify up to this operation</source>
        <translation>Vérifier jusqu'à cette opération</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Vérification</translation>
    </message>
    <message>
        <source>Verifying all setups</source>
        <translation>Vérification de tous les posages</translation>
    </message>
    <message>
        <source>Verifying was not begun, as it cannot be judged: %1.</source>
        <translation>La vérification n'a pas été commencée, car il est impossible de juger : %1.</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Vice: two jaws</source>
        <translation>Étau : deux mors</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>View of the candidate</source>
        <translation>Vue du candidat</translation>
    </message>
    <message>
        <source>Watertight</source>
        <translation>Étanche</translation>
    </message>
    <message>
        <source>Way of the tool tip (%1)</source>
        <translation>Trajet de la pointe (%1)</translation>
    </message>
    <message>
        <source>Wear</source>
        <translation>Usure</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>What a tool leaves</source>
        <translation>Ce que laisse un outil</translation>
    </message>
    <message>
        <source>What all operations leave of the stock, as STL, 3MF or PLY</source>
        <translation>Ce que toutes les opérations laissent du brut, en STL, 3MF ou PLY</translation>
    </message>
    <message>
        <source>What came of each candidate, planned, judged coarsely and finely</source>
        <translation>Ce que chaque candidat a donné : planifié, jugé grossièrement et finement</translation>
    </message>
    <message>
        <source>What is drawn to the right</source>
        <translation>Ce qui est porté vers la droite</translation>
    </message>
    <message>
        <source>What is drawn upward</source>
        <translation>Ce qui est porté vers le haut</translation>
    </message>
    <message>
        <source>What is left and what is missing, in colours</source>
        <translation>Ce qui reste et ce qui manque, en couleurs</translation>
    </message>
    <message>
        <source>What is nearer is larger; there is no scale bar then (Shift+P)</source>
        <translation>Ce qui est plus près est plus grand ; il n'y a alors pas d'échelle (Maj+P)</translation>
    </message>
    <message>
        <source>What is not saved cannot be kept for the case of a crash: %1. Save the project.</source>
        <translation>Ce qui n'est pas enregistré ne peut être gardé en cas de plantage : %1. Enregistrer le projet.</translation>
    </message>
    <message>
        <source>What is wanted</source>
        <translation>Ce qui est souhaité</translation>
    </message>
    <message>
        <source>What may vary</source>
        <translation>Ce qui peut varier</translation>
    </message>
    <message>
        <source>What the chart shows: the angles of the rotary axes, or the step-over along the part</source>
        <translation>Ce que montre le diagramme : les angles des axes rotatifs, ou le pas latéral le long de la pièce</translation>
    </message>
    <message>
        <source>What the colours of the path mean; their scale stands in the view</source>
        <translation>Ce que signifient les couleurs du parcours ; leur échelle est dans la vue</translation>
    </message>
    <message>
        <source>What the file holds</source>
        <translation>Ce que contient le fichier</translation>
    </message>
    <message>
        <source>What the recipe makes of it; of single holes and pieces what becomes of them</source>
        <translation>Ce que la recette en fait ; pour chaque trou et morceau ce qu'il devient</translation>
    </message>
    <message>
        <source>What the steps for all holes say of its size</source>
        <translation>Ce que les étapes pour tous les trous disent de sa taille</translation>
    </message>
    <message>
        <source>What the study asks</source>
        <translation>Ce que demande l'étude</translation>
    </message>
    <message>
        <source>What the view shows</source>
        <translation>Ce que montre la vue</translation>
    </message>
    <message>
        <source>What to do: a finish with the tool that fits; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : une finition avec l'outil qui y entre ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What to do: a larger stock.</source>
        <translation>Que faire : un brut plus grand.</translation>
    </message>
    <message>
        <source>What to do: a larger tool in %1, or verify up to the operation before it.</source>
        <translation>Que faire : un outil plus grand dans %1, ou vérifier seulement jusqu'à l'opération qui la précède.</translation>
    </message>
    <message>
        <source>What to do: a larger tool in %1.</source>
        <translation>Que faire : un outil plus grand dans %1.</translation>
    </message>
    <message>
        <source>What to do: a longer shank or flutes, a slimmer holder, or the part laid another way.</source>
        <translation>Que faire : une queue ou des dents plus longues, un porte-outil plus mince, ou la pièce posée autrement.</translation>
    </message>
    <message>
        <source>What to do: a longer shank, a slimmer holder, or the part laid another way.</source>
        <translation>Que faire : une queue plus longue, un porte-outil plus mince, ou la pièce posée autrement.</translation>
    </message>
    <message>
        <source>What to do: a smaller tool in Clean-up; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : un outil plus petit dans Nettoyage ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What to do: a stock that reaches lower, or Below the bottom where nothing holds it there.</source>
        <translation>Que faire : un brut qui descend plus bas, ou « Sous le fond » là où rien ne le tient.</translation>
    </message>
    <message>
        <source>What to do: a tilt limit in %1, by which the tool leans there; or a longer shank, or a slimmer holder.</source>
        <translation>Que faire : une limite d’inclinaison dans %1, par laquelle l’outil s’y incline ; ou une queue plus longue, ou un porte-outil plus fin.</translation>
    </message>
    <message>
        <source>What to do: a tool with longer flutes, or a smaller allowance in Rough.</source>
        <translation>Que faire : un outil à dents plus longues, ou une surépaisseur plus petite dans Ébauche.</translation>
    </message>
    <message>
        <source>What to do: accept what stays, by Uncut limit in Verification limits: what a smaller tool than %1 leaves on a part so large is too fine to be judged.</source>
        <translation>Que faire : accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ». Ce qu'un outil plus petit que %1 laisse sur une pièce si grande est trop fin pour être jugé.</translation>
    </message>
    <message>
        <source>What to do: add %1, which cuts what is more level than %2 does.</source>
        <translation>Que faire : ajouter %1, qui usine ce qui est plus plat que ce que fait %2.</translation>
    </message>
    <message>
        <source>What to do: add %1, which goes round what is steeper than %2 cuts.</source>
        <translation>Que faire : ajouter %1, qui contourne ce qui est plus raide que ce que fait %2.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up with %1, which fits there.</source>
        <translation>Que faire : ajouter Nettoyage avec %1, qui y entre.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up, or finish with a smaller tolerance.</source>
        <translation>Que faire : ajouter Nettoyage, ou finir avec une tolérance plus petite.</translation>
    </message>
    <message>
        <source>What to do: add Clean-up, which takes a smaller tool; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : ajouter Nettoyage, qui prend un outil plus petit ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What to do: add Rough before it, so that less stock stands there, or take a tool with longer flutes.</source>
        <translation>Que faire : ajouter Ébauche avant, pour qu'il y reste moins de brut, ou prendre un outil à dents plus longues.</translation>
    </message>
    <message>
        <source>What to do: add Rough before the finish, which takes the stock away that is in the way.</source>
        <translation>Que faire : ajouter Ébauche avant la finition, pour enlever le brut qui gêne.</translation>
    </message>
    <message>
        <source>What to do: add another Clean-up, with a smaller tool after %1; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : ajouter un autre Nettoyage, avec un outil plus petit après %1 ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What to do: finish with a smaller tolerance.</source>
        <translation>Que faire : finir avec une tolérance plus petite.</translation>
    </message>
    <message>
        <source>What to do: move the fixture, or cut that place in a second setup.</source>
        <translation>Que faire : déplacer le bridage, ou usiner cet endroit dans un second posage.</translation>
    </message>
    <message>
        <source>What to do: move the fixture, or keep the operation out of its way by a boundary.</source>
        <translation>Que faire : déplacer le bridage, ou en éloigner l'opération par une limite.</translation>
    </message>
    <message>
        <source>What to do: raise the clearance of the operation that the list names.</source>
        <translation>Que faire : augmenter la distance de sécurité de l'opération nommée dans la liste.</translation>
    </message>
    <message>
        <source>What to do: smaller tabs; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : des attaches plus petites ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What to do: widen the boundary; or accept what stays, by Uncut limit in Verification limits.</source>
        <translation>Que faire : élargir la limite ; ou accepter ce qui reste, par « Limite du non-usiné » dans « Limites de la vérification ».</translation>
    </message>
    <message>
        <source>What varies, and what comes of it</source>
        <translation>Ce qui varie, et ce qui en résulte</translation>
    </message>
    <message>
        <source>What was kept of %1 is damaged, and is not used: plan again.</source>
        <translation>Ce qui était gardé de %1 est abîmé, et n'est pas utilisé : planifier de nouveau.</translation>
    </message>
    <message>
        <source>What was planned before is kept: %1.</source>
        <translation>Ce qui était planifié avant est gardé : %1.</translation>
    </message>
    <message>
        <source>What was planned is not kept with the project: %1.</source>
        <translation>Ce qui était planifié n'est pas gardé avec le projet : %1.</translation>
    </message>
    <message>
        <source>Where candidates are planned and verified; a cluster and other computers see the folder under the same name, and have the same program in the same place</source>
        <translation>Où les candidats sont planifiés et vérifiés ; une grappe et d’autres ordinateurs voient le dossier sous le même nom, et ont le même programme au même endroit</translation>
    </message>
    <message>
        <source>While a boundary is painted</source>
        <translation>Pendant qu'une limite est peinte</translation>
    </message>
    <message>
        <source>Whose box the zero is on; it goes with it</source>
        <translation>Sur la boîte de quoi se trouve l'origine ; elle la suit</translation>
    </message>
    <message>
        <source>Why not</source>
        <translation>Pourquoi pas</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width, %1</source>
        <translation>Largeur, %1</translation>
    </message>
    <message>
        <source>With D %1: </source>
        <translation>Avec D %1 : </translation>
    </message>
    <message>
        <source>Words to look for</source>
        <translation>Mots à chercher</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Travail</translation>
    </message>
    <message>
        <source>Work on</source>
        <translation>Travailler sur</translation>
    </message>
    <message>
        <source>Work zero</source>
        <translation>Origine pièce</translation>
    </message>
    <message>
        <source>Working on the study</source>
        <translation>Travail sur l'étude</translation>
    </message>
    <message>
        <source>Write the chosen tools, or all that are shown, for another program</source>
        <translation>Écrire les outils choisis, ou tous ceux affichés, pour un autre programme</translation>
    </message>
    <message>
        <source>Write the project with its meshes, machines and posts into one file, to be sent</source>
        <translation>Écrire le projet avec maillages, machines et post-processeurs dans un seul fichier, à envoyer</translation>
    </message>
    <message>
        <source>Write the whole path of a folder.</source>
        <translation>Écrire le chemin complet d'un dossier.</translation>
    </message>
    <message>
        <source>Writing a mesh</source>
        <translation>Écriture d'un maillage</translation>
    </message>
    <message>
        <source>Writing programs</source>
        <translation>Écriture des programmes</translation>
    </message>
    <message>
        <source>Writing the setup sheet</source>
        <translation>Écriture de la fiche de réglage</translation>
    </message>
    <message>
        <source>Written to %1</source>
        <translation>Écrit dans %1</translation>
    </message>
    <message>
        <source>Wrote %1.</source>
        <translation>%1 écrit.</translation>
    </message>
    <message numerus="yes">
        <source>Wrote %n files into %1.</source>
        <translation><numerusform>%n fichier écrit dans %1.</numerusform><numerusform>%n fichiers écrits dans %1.</numerusform></translation>
    </message>
    <message>
        <source>Zero at %1 X, %2 Y of the box, as seen from above</source>
        <translation>Origine à %1 X, %2 Y de la boîte, vue d'en haut</translation>
    </message>
    <message>
        <source>Zero here</source>
        <translation>Origine ici</translation>
    </message>
    <message>
        <source>Zoom: wheel</source>
        <translation>Zoom : molette</translation>
    </message>
    <message>
        <source>Zoom: wheel, or Ctrl + middle</source>
        <translation>Zoom : molette, ou Ctrl + milieu</translation>
    </message>
    <message>
        <source>Zoom: wheel, or Shift + middle</source>
        <translation>Zoom : molette, ou Maj + milieu</translation>
    </message>
    <message>
        <source>Zoom: wheel, or right button</source>
        <translation>Zoom : molette, ou bouton droit</translation>
    </message>
    <message>
        <source>a Slurm cluster</source>
        <translation>une grappe Slurm</translation>
    </message>
    <message>
        <source>a comma is not a decimal mark</source>
        <translation>une virgule n'est pas une marque décimale</translation>
    </message>
    <message>
        <source>a few s left</source>
        <translation>encore quelques s</translation>
    </message>
    <message>
        <source>a number has two marks</source>
        <translation>un nombre a deux séparateurs</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>au-dessus de %1 : %2</translation>
    </message>
    <message>
        <source>against</source>
        <translation>contre</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>all combinations</source>
        <translation>toutes les combinaisons</translation>
    </message>
    <message>
        <source>all of the cutter</source>
        <translation>toute la fraise</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>selon Z</translation>
    </message>
    <message>
        <source>another computer, by SSH</source>
        <translation>un autre ordinateur, par SSH</translation>
    </message>
    <message>
        <source>any</source>
        <translation>quelconque</translation>
    </message>
    <message>
        <source>as it stands</source>
        <translation>tel quel</translation>
    </message>
    <message>
        <source>as the desktop</source>
        <translation>comme le bureau</translation>
    </message>
    <message>
        <source>as the strip asks</source>
        <translation>comme la bande le demande</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>comme le système</translation>
    </message>
    <message>
        <source>ask each time</source>
        <translation>demander chaque fois</translation>
    </message>
    <message>
        <source>behind</source>
        <translation>derrière</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>moins de %1</translation>
    </message>
    <message>
        <source>below %1: %2</source>
        <translation>en dessous de %1 : %2</translation>
    </message>
    <message>
        <source>boss</source>
        <translation>bossage</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>by moved vertices</source>
        <translation>par sommets déplacés</translation>
    </message>
    <message>
        <source>cancel the running job</source>
        <translation>annuler le travail en cours</translation>
    </message>
    <message>
        <source>click or drag: the tool there; wheel: zoom; right drag: move; Home: all</source>
        <translation>cliquer ou tirer : l'outil y va ; molette : zoom ; tirer à droite : déplacer ; Début : tout</translation>
    </message>
    <message>
        <source>copy an operation in the tree, paste it here or in another project</source>
        <translation>copier une opération dans l'arbre, la coller ici ou dans un autre projet</translation>
    </message>
    <message>
        <source>crossing found</source>
        <translation>croisement trouvé</translation>
    </message>
    <message>
        <source>crossing left</source>
        <translation>croisement restant</translation>
    </message>
    <message>
        <source>crossings found</source>
        <translation>croisements trouvés</translation>
    </message>
    <message>
        <source>crossings left</source>
        <translation>croisements restants</translation>
    </message>
    <message>
        <source>curvature matched (CM²)</source>
        <translation>à courbure ajustée (CM²)</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>sombre</translation>
    </message>
    <message>
        <source>deviation</source>
        <translation>écart</translation>
    </message>
    <message>
        <source>did not pass</source>
        <translation>non réussi</translation>
    </message>
    <message>
        <source>doubled facet gone</source>
        <translation>facette doublée enlevée</translation>
    </message>
    <message>
        <source>doubled facets gone</source>
        <translation>facettes doublées enlevées</translation>
    </message>
    <message>
        <source>edge gone</source>
        <translation>arête enlevée</translation>
    </message>
    <message>
        <source>edge still against its neighbour</source>
        <translation>arête encore contre sa voisine</translation>
    </message>
    <message>
        <source>edge turned</source>
        <translation>arête tournée</translation>
    </message>
    <message>
        <source>edges between facets of opposite winding</source>
        <translation>arêtes entre facettes de sens opposés</translation>
    </message>
    <message>
        <source>edges gone</source>
        <translation>arêtes enlevées</translation>
    </message>
    <message>
        <source>edges of more than two facets</source>
        <translation>arêtes de plus de deux facettes</translation>
    </message>
    <message>
        <source>edges still against their neighbours</source>
        <translation>arêtes encore contre leurs voisines</translation>
    </message>
    <message>
        <source>edges turned</source>
        <translation>arêtes tournées</translation>
    </message>
    <message>
        <source>edit the selected tool or the parameters of the selection</source>
        <translation>modifier l'outil choisi ou les paramètres de la sélection</translation>
    </message>
    <message>
        <source>end of a sheet</source>
        <translation>fin d'une feuille</translation>
    </message>
    <message>
        <source>ends of sheets</source>
        <translation>fins de feuilles</translation>
    </message>
    <message>
        <source>enter a number</source>
        <translation>entrer un nombre</translation>
    </message>
    <message>
        <source>every order</source>
        <translation>tout ordre</translation>
    </message>
    <message>
        <source>everywhere</source>
        <translation>partout</translation>
    </message>
    <message>
        <source>exact, at the contact</source>
        <translation>exact, au contact</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>excédent</translation>
    </message>
    <message>
        <source>export programs and the report</source>
        <translation>exporter les programmes et le rapport</translation>
    </message>
    <message>
        <source>faces %1</source>
        <translation>faces %1</translation>
    </message>
    <message>
        <source>facet added</source>
        <translation>facette ajoutée</translation>
    </message>
    <message>
        <source>facet divided</source>
        <translation>facette divisée</translation>
    </message>
    <message>
        <source>facet gone</source>
        <translation>facette enlevée</translation>
    </message>
    <message>
        <source>facet gone where both lie</source>
        <translation>facette enlevée où les deux se trouvent</translation>
    </message>
    <message>
        <source>facet in the section</source>
        <translation>facette dans la section</translation>
    </message>
    <message>
        <source>facet joined on</source>
        <translation>facette jointe</translation>
    </message>
    <message>
        <source>facet left out: more than two on an edge</source>
        <translation>facette laissée de côté : plus de deux sur une arête</translation>
    </message>
    <message>
        <source>facet made anew</source>
        <translation>facette refaite</translation>
    </message>
    <message>
        <source>facet of the back</source>
        <translation>facette du dos</translation>
    </message>
    <message>
        <source>facet of the seam</source>
        <translation>facette de la couture</translation>
    </message>
    <message>
        <source>facet of walls</source>
        <translation>facette des parois</translation>
    </message>
    <message>
        <source>facet turned</source>
        <translation>facette tournée</translation>
    </message>
    <message>
        <source>facets added</source>
        <translation>facettes ajoutées</translation>
    </message>
    <message>
        <source>facets divided</source>
        <translation>facettes divisées</translation>
    </message>
    <message>
        <source>facets gone</source>
        <translation>facettes enlevées</translation>
    </message>
    <message>
        <source>facets gone where both lie</source>
        <translation>facettes enlevées où les deux se trouvent</translation>
    </message>
    <message>
        <source>facets in the section</source>
        <translation>facettes dans la section</translation>
    </message>
    <message>
        <source>facets joined on</source>
        <translation>facettes jointes</translation>
    </message>
    <message>
        <source>facets left out: more than two on an edge</source>
        <translation>facettes laissées de côté : plus de deux sur une arête</translation>
    </message>
    <message>
        <source>facets made anew</source>
        <translation>facettes refaites</translation>
    </message>
    <message>
        <source>facets of the back</source>
        <translation>facettes du dos</translation>
    </message>
    <message>
        <source>facets of the seam</source>
        <translation>facettes de la couture</translation>
    </message>
    <message>
        <source>facets of walls</source>
        <translation>facettes des parois</translation>
    </message>
    <message>
        <source>facets that face the wrong side</source>
        <translation>des facettes tournées du mauvais côté</translation>
    </message>
    <message>
        <source>facets that occur twice, kept</source>
        <translation>facettes en double, gardées</translation>
    </message>
    <message>
        <source>facets turned</source>
        <translation>facettes tournées</translation>
    </message>
    <message>
        <source>facets without area, left out</source>
        <translation>facettes sans aire, omises</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>rempli</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>cadrer</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>plat</translation>
    </message>
    <message>
        <source>from edge to edge</source>
        <translation>d’un bord à l’autre</translation>
    </message>
    <message>
        <source>from the tolerance</source>
        <translation>d'après la tolérance</translation>
    </message>
    <message>
        <source>front</source>
        <translation>front</translation>
    </message>
    <message>
        <source>goes</source>
        <translation>part</translation>
    </message>
    <message>
        <source>gouge</source>
        <translation>entaille</translation>
    </message>
    <message>
        <source>gouges up to %1</source>
        <translation>entailles jusqu'à %1</translation>
    </message>
    <message>
        <source>half of the outline</source>
        <translation>la moitié du contour</translation>
    </message>
    <message>
        <source>high</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>trou</translation>
    </message>
    <message>
        <source>hole filled</source>
        <translation>trou rempli</translation>
    </message>
    <message>
        <source>hole left as asked</source>
        <translation>trou laissé comme demandé</translation>
    </message>
    <message>
        <source>hole left that no patch fits</source>
        <translation>trou restant auquel aucune pièce ne va</translation>
    </message>
    <message>
        <source>hole that is not there</source>
        <translation>trou qui n'existe pas</translation>
    </message>
    <message>
        <source>holes</source>
        <translation>des trous</translation>
    </message>
    <message>
        <source>holes filled</source>
        <translation>trous remplis</translation>
    </message>
    <message>
        <source>holes left as asked</source>
        <translation>trous laissés comme demandé</translation>
    </message>
    <message>
        <source>holes left that no patch fits</source>
        <translation>trous restants auxquels aucune pièce ne va</translation>
    </message>
    <message>
        <source>holes that are not there</source>
        <translation>trous qui n'existent pas</translation>
    </message>
    <message>
        <source>in rings</source>
        <translation>en anneaux</translation>
    </message>
    <message>
        <source>into the panels: project, parameters, report and so on</source>
        <translation>dans les panneaux : projet, paramètres, rapport, etc.</translation>
    </message>
    <message>
        <source>isometric, front, top, right, rear, bottom, left</source>
        <translation>isométrique, avant, dessus, droite, arrière, dessous, gauche</translation>
    </message>
    <message>
        <source>judged coarsely</source>
        <translation>jugé grossièrement</translation>
    </message>
    <message>
        <source>judged finely</source>
        <translation>jugé finement</translation>
    </message>
    <message>
        <source>keeps Z upright</source>
        <translation>garde Z vertical</translation>
    </message>
    <message>
        <source>larger hole left</source>
        <translation>trou plus grand restant</translation>
    </message>
    <message>
        <source>larger holes left</source>
        <translation>trous plus grands restants</translation>
    </message>
    <message>
        <source>larger place left</source>
        <translation>endroit plus grand restant</translation>
    </message>
    <message>
        <source>larger places left</source>
        <translation>endroits plus grands restants</translation>
    </message>
    <message>
        <source>lead %1, yaw %2</source>
        <translation>attaque %1, lacet %2</translation>
    </message>
    <message>
        <source>least</source>
        <translation>le moins</translation>
    </message>
    <message>
        <source>left</source>
        <translation>restant</translation>
    </message>
    <message>
        <source>left drag: paint (Shift: erase); Ctrl + left drag: turn; Esc: end</source>
        <translation>tirer à gauche : peindre (Maj : effacer) ; Ctrl + tirer à gauche : tourner ; Échap : terminer</translation>
    </message>
    <message>
        <source>left open</source>
        <translation>ouvert</translation>
    </message>
    <message>
        <source>left to clean-up</source>
        <translation>laissé au nettoyage</translation>
    </message>
    <message>
        <source>lengths as in the file</source>
        <translation>longueurs comme dans le fichier</translation>
    </message>
    <message>
        <source>less than %1 s</source>
        <translation>moins de %1 s</translation>
    </message>
    <message>
        <source>light</source>
        <translation>clair</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limites</translation>
    </message>
    <message>
        <source>loose pieces</source>
        <translation>des morceaux détachés</translation>
    </message>
    <message>
        <source>low</source>
        <translation>bas</translation>
    </message>
    <message>
        <source>main</source>
        <translation>principal</translation>
    </message>
    <message>
        <source>main %1 + rework %2 = %3; %4, %5 % of the surface</source>
        <translation>principal %1 + reprise %2 = %3 ; %4, %5 % de la surface</translation>
    </message>
    <message>
        <source>measure</source>
        <translation>mesurer</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>moved at most %1</source>
        <translation>déplacé de %1 au plus</translation>
    </message>
    <message>
        <source>needle left</source>
        <translation>aiguille restante</translation>
    </message>
    <message>
        <source>needles left</source>
        <translation>aiguilles restantes</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>no faces yet</source>
        <translation>pas encore de faces</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>none: APT only</source>
        <translation>aucune : APT seul</translation>
    </message>
    <message>
        <source>not looked at</source>
        <translation>non examiné</translation>
    </message>
    <message>
        <source>not planned, not checked</source>
        <translation>ni planifié ni vérifié</translation>
    </message>
    <message>
        <source>not reached by any</source>
        <translation>atteint par aucun</translation>
    </message>
    <message>
        <source>not watertight</source>
        <translation>non étanche</translation>
    </message>
    <message>
        <source>nothing is entered</source>
        <translation>rien n'est entré</translation>
    </message>
    <message>
        <source>nothing moved</source>
        <translation>rien n'a bougé</translation>
    </message>
    <message>
        <source>nothing to do</source>
        <translation>rien à faire</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>sur %1</translation>
    </message>
    <message>
        <source>of it the main path</source>
        <translation>dont le parcours principal</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>one for each operation</source>
        <translation>un par opération</translation>
    </message>
    <message>
        <source>one motion back, on (← and → too while playing back; Shift: ten)</source>
        <translation>un mouvement en arrière, en avant (← et → aussi pendant la lecture ; Maj : dix)</translation>
    </message>
    <message>
        <source>one ring</source>
        <translation>un anneau</translation>
    </message>
    <message>
        <source>one way</source>
        <translation>sens unique</translation>
    </message>
    <message>
        <source>one with tool changes</source>
        <translation>un seul avec changements d'outil</translation>
    </message>
    <message>
        <source>open edges</source>
        <translation>arêtes ouvertes</translation>
    </message>
    <message>
        <source>out</source>
        <translation>écarté</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>périmé</translation>
    </message>
    <message>
        <source>over diameter</source>
        <translation>selon le diamètre</translation>
    </message>
    <message>
        <source>over lead limit</source>
        <translation>selon la limite d'attaque</translation>
    </message>
    <message>
        <source>part</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>pass %1, point %2</source>
        <translation>passe %1, point %2</translation>
    </message>
    <message>
        <source>passed</source>
        <translation>réussi</translation>
    </message>
    <message>
        <source>piece gone</source>
        <translation>morceau enlevé</translation>
    </message>
    <message>
        <source>pieces gone</source>
        <translation>morceaux enlevés</translation>
    </message>
    <message>
        <source>plan</source>
        <translation>planifier</translation>
    </message>
    <message>
        <source>planned</source>
        <translation>planifié</translation>
    </message>
    <message>
        <source>play, pause</source>
        <translation>lecture, pause</translation>
    </message>
    <message>
        <source>remove the selected tool or operation</source>
        <translation>supprimer l'outil ou l'opération choisie</translation>
    </message>
    <message>
        <source>rename what is selected in the tree</source>
        <translation>renommer ce qui est choisi dans l'arbre</translation>
    </message>
    <message>
        <source>rework</source>
        <translation>reprise</translation>
    </message>
    <message>
        <source>rolls freely</source>
        <translation>roule librement</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>seam left open</source>
        <translation>couture restée ouverte</translation>
    </message>
    <message>
        <source>seams left open</source>
        <translation>coutures restées ouvertes</translation>
    </message>
    <message>
        <source>section left open</source>
        <translation>section restée ouverte</translation>
    </message>
    <message>
        <source>sections left open</source>
        <translation>sections restées ouvertes</translation>
    </message>
    <message>
        <source>see what belongs to: prepare, plan, verify, simulate</source>
        <translation>voir ce qui s'y rapporte : préparer, planifier, vérifier, simuler</translation>
    </message>
    <message>
        <source>show the tool there; ← and → step along the path (Shift: by ten)</source>
        <translation>y montrer l'outil ; ← et → avancent le long du parcours (Maj : par dix)</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>lisse</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>reste</translation>
    </message>
    <message>
        <source>stock</source>
        <translation>brut</translation>
    </message>
    <message>
        <source>study</source>
        <translation>etude</translation>
    </message>
    <message>
        <source>the %1's file “%2”</source>
        <translation>le fichier « %2 » (%1)</translation>
    </message>
    <message>
        <source>the display offers OpenGL %1.%2 only; 3.2 is needed</source>
        <translation>l'affichage n'offre qu'OpenGL %1.%2 ; il faut 3.2</translation>
    </message>
    <message>
        <source>the display offers no OpenGL</source>
        <translation>l'affichage n'offre pas OpenGL</translation>
    </message>
    <message>
        <source>the manual, at the place of what has the keys</source>
        <translation>le manuel, à l'endroit de ce qui a le clavier</translation>
    </message>
    <message>
        <source>the other half</source>
        <translation>l’autre moitié</translation>
    </message>
    <message>
        <source>the outline</source>
        <translation>le contour</translation>
    </message>
    <message>
        <source>the part's box</source>
        <translation>la boîte de la pièce</translation>
    </message>
    <message>
        <source>the part's origin</source>
        <translation>l'origine de la pièce</translation>
    </message>
    <message>
        <source>the posted program, %1 blocks</source>
        <translation>le programme post-traité, %1 blocs</translation>
    </message>
    <message>
        <source>the project</source>
        <translation>le projet</translation>
    </message>
    <message>
        <source>the stock's box</source>
        <translation>la boîte du brut</translation>
    </message>
    <message>
        <source>the tip</source>
        <translation>la pointe</translation>
    </message>
    <message>
        <source>this computer</source>
        <translation>cet ordinateur</translation>
    </message>
    <message>
        <source>through two points</source>
        <translation>par deux points</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>tried</source>
        <translation>essayé</translation>
    </message>
    <message>
        <source>turns back</source>
        <translation>revient en arrière</translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation>annuler, rétablir</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>sans nom</translation>
    </message>
    <message>
        <source>up to Ø %1</source>
        <translation>jusqu'à Ø %1</translation>
    </message>
    <message>
        <source>up to “%1”</source>
        <translation>jusqu'à « %1 »</translation>
    </message>
    <message>
        <source>use a point: 0.5</source>
        <translation>utiliser un point : 0.5</translation>
    </message>
    <message>
        <source>verified</source>
        <translation>vérifié</translation>
    </message>
    <message>
        <source>verify</source>
        <translation>vérifier</translation>
    </message>
    <message>
        <source>vertex held against folds</source>
        <translation>sommet retenu contre les plis</translation>
    </message>
    <message>
        <source>vertex moved</source>
        <translation>sommet déplacé</translation>
    </message>
    <message>
        <source>vertex without a direction</source>
        <translation>sommet sans direction</translation>
    </message>
    <message>
        <source>vertices held against folds</source>
        <translation>sommets retenus contre les plis</translation>
    </message>
    <message>
        <source>vertices moved</source>
        <translation>sommets déplacés</translation>
    </message>
    <message>
        <source>vertices where shells touch</source>
        <translation>sommets où des coques se touchent</translation>
    </message>
    <message>
        <source>vertices without a direction</source>
        <translation>sommets sans direction</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>attend</translation>
    </message>
    <message>
        <source>watertight</source>
        <translation>étanche</translation>
    </message>
    <message>
        <source>where it touches</source>
        <translation>là où elle touche</translation>
    </message>
    <message>
        <source>winner</source>
        <translation>gagnant</translation>
    </message>
    <message>
        <source>with the configuration space in view: points along the pass, passes</source>
        <translation>quand l'espace des configurations est visible : points de la passe, passes</translation>
    </message>
    <message>
        <source>within %1</source>
        <translation>dans %1</translation>
    </message>
    <message>
        <source>without %1</source>
        <translation>sans %1</translation>
    </message>
    <message>
        <source>write %1 or %2</source>
        <translation>écrire %1 ou %2</translation>
    </message>
    <message>
        <source>write it without marks between thousands</source>
        <translation>l'écrire sans séparateurs de milliers</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
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
        <translation>« %1 » appliqué : %2</translation>
    </message>
    <message>
        <source>“%1” cuts with three axes: no rotary axis moves</source>
        <translation>« %1 » usine en trois axes : aucun axe rotatif ne bouge</translation>
    </message>
    <message>
        <source>“%1” has nothing to do: %2.</source>
        <translation>« %1 » n'a rien à faire : %2.</translation>
    </message>
    <message>
        <source>“%1” has one pass only: there is no step-over</source>
        <translation>« %1 » n'a qu'une passe : il n'y a pas de pas latéral</translation>
    </message>
    <message>
        <source>“%1” is a folder: drop a project, or a mesh (%2).</source>
        <translation>« %1 » est un dossier : déposer un projet ou un maillage (%2).</translation>
    </message>
    <message>
        <source>“%1” is a picture of a kind that is not read as a relief: save it as PNG or TIFF, 8 or 16 bits of grey.</source>
        <translation>« %1 » est une image d'un type qui n'est pas lu comme relief : l'enregistrer en PNG ou TIFF, 8 ou 16 bits de gris.</translation>
    </message>
    <message>
        <source>“%1” is not a length to grow by: enter a number, below 0 to shrink</source>
        <translation>« %1 » n'est pas une longueur pour agrandir : entrer un nombre, sous 0 pour réduire</translation>
    </message>
    <message>
        <source>“%1” is the part already.</source>
        <translation>« %1 » est déjà la pièce.</translation>
    </message>
    <message>
        <source>“%1” is the part now: %2 facets.</source>
        <translation>« %1 » est la pièce maintenant : %2 facettes.</translation>
    </message>
    <message>
        <source>“by moved vertices”</source>
        <translation>« par sommets déplacés »</translation>
    </message>
    <message>
        <source>“from edge to edge”</source>
        <translation>« d’un bord à l’autre »</translation>
    </message>
    <message>
        <source>“from the tolerance”</source>
        <translation>« d'après la tolérance »</translation>
    </message>
    <message>
        <source>“in rings”</source>
        <translation>« en anneaux »</translation>
    </message>
    <message>
        <source>“one way”</source>
        <translation>« sens unique »</translation>
    </message>
    <message>
        <source>… %1</source>
        <translation>… %1</translation>
    </message>
    <message>
        <source>… 95 % below</source>
        <translation>… 95 % en dessous</translation>
    </message>
    <message>
        <source>… 99 % below</source>
        <translation>… 99 % en dessous</translation>
    </message>
    <message>
        <source>… largest</source>
        <translation>… le plus grand</translation>
    </message>
    <message>
        <source>… near open borders</source>
        <translation>… près des bords ouverts</translation>
    </message>
    <message>
        <source>← Back</source>
        <translation>← Retour</translation>
    </message>
    <message>
        <source>← →  ↑ ↓</source>
        <translation>← →  ↑ ↓</translation>
    </message>
</context>
</TS>
