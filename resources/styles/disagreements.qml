<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="RuleRenderer">
  <rules>
   <rule symbol="0" label="The maps disagree"/>
  </rules>
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="179,38,30,40" type="QString"/>
      <Option name="outline_color" value="179,38,30,255" type="QString"/>
      <Option name="outline_width" value="0.5" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <previewExpression><![CDATA["rank" || ': ' || "annotated_class" || ' → ' || "predicted_class"]]></previewExpression>
 <mapTip><![CDATA[<b>[% "rank" %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Annotated class') || '</td><td><b>' || replace(replace(to_string("annotated_class"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Predicted class') || '</td><td><b>' || replace(replace(to_string("predicted_class"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Area') || '</td><td><b>' || format_number("area", 0) || ' m²' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
