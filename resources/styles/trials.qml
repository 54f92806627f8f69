<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="RuleRenderer">
  <rules>
   <rule symbol="0" filter="&quot;right&quot; = 1" label="correct position"/>
   <rule symbol="1" filter="&quot;status&quot; = 'fix' AND &quot;right&quot; = 0" label="wrong position"/>
   <rule symbol="2" filter="&quot;status&quot; = 'ambiguous'" label="ambiguous"/>
   <rule symbol="4" filter="&quot;status&quot; = 'likely'" label="likely position"/>
   <rule symbol="3" filter="ELSE" label="no position"/>
  </rules>
  <symbols>
   <symbol name="0" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="0,103,165,255" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
      <Option name="size" value="2.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="1" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="179,38,30,255" type="QString"/>
      <Option name="name" value="cross2" type="QString"/>
      <Option name="outline_color" value="179,38,30,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="size" value="2.8" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="2" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="224,138,0,255" type="QString"/>
      <Option name="name" value="triangle" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
      <Option name="size" value="2.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="3" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="74,127,181,255" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
      <Option name="size" value="1.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="4" type="marker">
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="224,138,0,255" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="0.2" type="QString"/>
      <Option name="size" value="2.2" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <previewExpression><![CDATA["trial"]]></previewExpression>
 <mapTip><![CDATA[<b>[% to_string("trial") %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Status') || '</td><td><b>' || if("status" <> '', replace(replace(represent_value("status"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Method') || '</td><td><b>' || if("method" <> '', replace(replace(represent_value("method"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Error') || '</td><td><b>' || format_number("error", 1) || ' m' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Landmarks in the image') || '</td><td><b>' || format_number("references", 0) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Reason') || '</td><td><b>' || replace(replace(to_string("reason"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>0</layerGeometryType>
</qgis>
