<qgis version="3.22.16">
 <renderer-v2 type="singleSymbol">
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="224,138,0,18" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1" type="QString"/>
     </Option>
    </layer>
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="outline_color" value="224,138,0,255" type="QString"/>
      <Option name="outline_style" value="dash" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="style" value="no" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple">
  <settings>
   <text-style textColor="28,33,38,255" fontSize="8" fieldName="base_file_name(&quot;image&quot;) || ' ' || &quot;rank&quot;" isExpression="1" fontWeight="50">
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
 <previewExpression><![CDATA[base_file_name("image") || ' ' || "rank"]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(file_name("image"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
[% CASE WHEN regexp_match("image", '^[/\\\\]{2}|^/vsi|^[A-Za-z][^/\\\\]+:') > 0 THEN ''
WHEN file_exists("image") THEN '<br><img width="260" src="file:///' || regexp_replace(replace(replace(replace("image", '\\', '/'), '%', '%25'),
map('"', '%22', '#', '%23', '<', '%3C', '>', '%3E', '?', '%3F', ' ', '%20')), '^/+', '') || '">' ELSE '' END %]
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Rank') || '</td><td><b>' || to_string("rank") || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Heading') || '</td><td><b>' || format_number("heading", 1) || '°' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Pixel size') || '</td><td><b>' || format_number("pixel_size", 2) || ' m' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
