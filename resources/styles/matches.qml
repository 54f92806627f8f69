<qgis version="3.22.16">
 <renderer-v2 type="singleSymbol">
  <symbols>
   <symbol name="0" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="0,0,0,0" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="0.9" type="QString"/>
      <Option name="size" value="3.4" type="QString"/>
     </Option>
    </layer>
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="0,0,0,0" type="QString"/>
      <Option name="outline_color" value="0,103,165,255" type="QString"/>
      <Option name="outline_width" value="0.5" type="QString"/>
      <Option name="size" value="3.4" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple">
  <settings>
   <text-style textColor="28,33,38,255" fontSize="8" fieldName="&quot;number&quot;" isExpression="1" fontWeight="50">
    <text-buffer bufferSize="0.9" bufferNoFill="1" bufferDraw="1"/>
    <text-mask maskSize="1.5"/>
    <background shapeRadiiUnit="MM" shapeBorderWidthUnit="MM" shapeSizeUnit="MM" shapeOffsetUnit="MM"/>
    <shadow shadowRadiusUnit="MM" shadowOffsetUnit="MM" shadowOpacity="0.7"/>
   </text-style>
   <text-format decimals="3"/>
   <placement offsetUnits="MM" placementFlags="10" priority="5" dist="2.2"/>
   <rendering obstacleType="1" scaleMax="250000" scaleVisibility="1" scaleMin="1"/>
  </settings>
 </labeling>
 <previewExpression><![CDATA["number"]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(file_name("image"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || ' ' || "number" %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Class') || '</td><td><b>' || replace(replace(to_string("class_name"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Residual') || '</td><td><b>' || format_number("residual", 2) || ' m' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>0</layerGeometryType>
</qgis>
