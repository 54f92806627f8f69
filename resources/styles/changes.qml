<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="RuleRenderer">
  <rules>
   <rule symbol="0" label="Changed"/>
  </rules>
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="0,103,165,40" type="QString"/>
      <Option name="outline_color" value="0,103,165,255" type="QString"/>
      <Option name="outline_width" value="0.5" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <previewExpression><![CDATA["message"]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(to_string("message"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Kind') || '</td><td><b>' || if("kind" <> '', replace(replace(represent_value("kind"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Area') || '</td><td><b>' || format_number("area", 2) || ' m²' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
