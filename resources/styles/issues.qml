<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 enableorderby="1" type="categorizedSymbol" attr="severity">
  <categories>
   <category value="error" symbol="0" label="Error"/>
   <category value="warning" symbol="1" label="Warning"/>
   <category value="information" symbol="2" label="Information"/>
  </categories>
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="179,38,30,60" type="QString"/>
      <Option name="outline_color" value="179,38,30,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="1" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="224,138,0,60" type="QString"/>
      <Option name="outline_color" value="224,138,0,255" type="QString"/>
      <Option name="outline_width" value="0.5" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol alpha="0.5" name="2" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="74,127,181,0" type="QString"/>
      <Option name="outline_color" value="74,127,181,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
  <orderby>
   <orderByClause asc="1">array_find(array('information', 'warning', 'error'), "severity")</orderByClause>
  </orderby>
 </renderer-v2>
 <previewExpression><![CDATA["message"]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(to_string("message"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Severity') || '</td><td><b>' || if("severity" <> '', replace(replace(represent_value("severity"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Area') || '</td><td><b>' || format_number("area", 2) || ' m²' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Feature') || '</td><td><b>' || to_string("feature_id") || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
