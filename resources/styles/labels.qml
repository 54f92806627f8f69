<qgis version="3.22.16">
 <pipe>
  <rasterrenderer type="paletted" band="1" alphaBand="-1" opacity="1">
   <colorPalette/>
  </rasterrenderer>
 </pipe>
</qgis>
