<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="singleSymbol">
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="style" value="no" type="QString"/>
      <Option name="outline_color" value="31,95,191,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <layerGeometryType>2</layerGeometryType>
</qgis>
