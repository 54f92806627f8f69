<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="singleSymbol">
  <symbols>
   <symbol name="0" type="line">
    <layer class="SimpleLine">
     <Option type="Map">
      <Option name="line_color" value="255,255,255,255" type="QString"/>
      <Option name="line_width" value="1" type="QString"/>
     </Option>
    </layer>
    <layer class="SimpleLine">
     <Option type="Map">
      <Option name="line_color" value="58,65,71,255" type="QString"/>
      <Option name="line_width" value="0.45" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <previewExpression><![CDATA[_('Track') || ' ' || "track"]]></previewExpression>
 <mapTip><![CDATA[<b>[% _('Track') || ' ' || "track" %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Images') || '</td><td><b>' || format_number("images", 0) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Images with an own position') || '</td><td><b>' || format_number("own", 0) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Length') || '</td><td><b>' || format_number(0.001 * "length", 2) || ' km' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Largest 95 % radius') || '</td><td><b>' || format_number("largest_error_95", 1) || ' m' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>1</layerGeometryType>
</qgis>
