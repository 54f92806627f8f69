<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>SemRef</name>
  <message>
   <source>1 is a perfect match, 0 none</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add a folder of label images</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add database to map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add files…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add folder…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add images.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add label images</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Add label images, or drop files and folders here.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Adds the positions to the project as a temporary point layer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Ambiguous</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Annotation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Annotation layer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Annotation to reference database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Area to rasterize, widened to whole pixels; the extent of the polygons if left out.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Automatic (not in this version)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Build reference database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Burning polygons</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, 0 where no polygon lies.

Classes come from the class table, else from the layer’s categorized style, else from the values of the class field. Invalid polygons are repaired, empty ones skipped; the log says how many.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. Every class value of the layer must be in it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h 0–180, s and v 0–255; the hue may wrap).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Cancel</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Canceled.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Canceled; nothing was written.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Canceling…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a GeoPackage</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a database.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Class field</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Class table</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Classes whose regions are landmarks: names or values separated by “;”, for example building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Color label image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Comparing windows</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Confidence</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Constellation (not in this version)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy longitude, latitude</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Copy x, y</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Decode color labels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Describe image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Describing windows</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance from window to window; at most the window size.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance of the topology vectors; 0 is a perfect match, above 2 there is none</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Distance ratios, angle differences and class ranks, with the classes used.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Edge length of a window on the ground: about what an image shows.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Extent</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fewer than three landmarks: the image has no topology vector.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>File name of the image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Finding reference objects</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Finds where images were taken: each label image is described by its landmarks and matched with the windows of a reference database.

Every image gives one point; without a fix it has no geometry and its reason says why. The topology vector method finds images centered on a window of the database and is known to accept images from elsewhere: check what it finds.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fix</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Footprints</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Fraction of the map that is labeled</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GeoPackage (*.gpkg)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, on the grid of the image.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the class table, colors and class names.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>HSV ranges</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>HSV ranges follow the publication; nearest color forgives blended edges.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>How many of the landmarks nearest to the center a vector holds.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Image with at least three bands (red, green, blue) of 8 bits.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Images</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Keep results as layer</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Label image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Label images, or folders of them: single-band class values, or colors decoded by the database’s class table. They need no georeference.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Label map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Landmarks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Levels</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Localization</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Localize</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Localize images</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Localizing images</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Map correlation (not in this version)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Method</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Minimum area</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Minimum area (m²)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for flights twice as high.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Name of the matched window: its first column and row on the map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Nearest color</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No match</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>No polygon lies in the extent: the label map is empty.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw order of the class table counts, else later polygons lie on top.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of classes on the map</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of fixes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Number of windows</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One point an image: status, position, confidence, distance, window and, without a fix, the reason.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>One polygon a fix: the matched window.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Overview</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Pixel size (m)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Points with class, area and pixel position; in pixels (y up, negative) without georeference.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Positions</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Priority field</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Rasterize annotation</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reading the database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Ready to localize.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reference classes</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Reference database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Remove</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Results</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Results appear here.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Select a result to see its hit on the map.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it for QGIS’s Python, for example with “python3 -m pip install {packages}”, or “apt install python3-opencv” on Debian and Ubuntu.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>SemRef positions</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Show or hide the SemRef dock: find where images were taken</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Shows what localization sees in a label image: its landmarks as points and its topology vector.

The image is described in its largest centered square, exactly as the windows of a database are. With a database its classes, minimum area and vector length are used; without one, give them here.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Single-band class values, or colors decoded by the class table. It needs no georeference.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.

The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks get no vector; the log says how many.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Smaller regions are no landmarks.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Starting…</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Status</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Stride (map units)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Target CRS</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Text or number field that tells the class of each polygon.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The Processing provider SemRef is switched off; switch it on in the options.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The disk is full while writing {name}; free some space or choose another place.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The hit lies outside the area of the project’s CRS; choose another one to see it.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The image is described as this database’s windows are; the settings below are then not used.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The label map brings no class names; its classes are named by their values.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The positions are a temporary layer of the project now; export it to keep them.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>There is no database {path}; choose another file.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>This version has one method: choose METHOD 1 (topology vector).</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Topology vector</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Topology vector (He &amp; Wu 2025)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as published or by the nearest class color.

Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is black.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Unreadable</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Whether a position was found</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Window</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Window size (map units)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Windows</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Windows are whole pixels: window size {size:g}, stride {stride:g}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Without a database: how many of the landmarks nearest to the center the vector holds.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Without a database: names or values separated by “;”. If left out, the role in the class table counts.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Without a database: smallest landmark in square map units, in pixels without georeference.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Without a database: the classes. If left out, those that the label image itself carries.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Writing the database</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>Zoom to hit</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>distance {value:.3f}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>the output</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>window {value}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>within {value:.1f} m (95 %)</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{fixes} of {images} images have a fix.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name} can’t be written; choose a place where you may write.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{name}: window {window}, position {x:.1f} {y:.1f}, distance {distance:.4f}, confidence {confidence:.2f}</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{share:.1%} of the pixels match no class.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{source} does not measure in meters; the label map is made in {target}.</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{value} landmarks in the image</source>
   <translation type="unfinished" />
  </message>
  <message>
   <source>{windows} windows, {references} landmarks.</source>
   <translation type="unfinished" />
  </message>
 </context>
</TS>
