<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="singleSymbol">
  <symbols>
   <symbol alpha="0.5" name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="255,234,70,255" type="QString"/>
      <Option name="outline_style" value="no" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <mapTip><![CDATA[<b>[% format_number(100 * "success", 0) || ' %' %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('95 % interval') || '</td><td><b>' || format_number(100 * "success_low", 0) || ' %' || '–' || format_number(100 * "success_high", 0) || ' %' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Expected error') || '</td><td><b>' || format_number("error", 1) || ' m' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Landmarks in view') || '</td><td><b>' || format_number("objects", 0) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Reason') || '</td><td><b>' || nullif(replace(replace(to_string("reason"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), '') || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Verdict') || '</td><td><b>' || if("verdict" <> '', replace(replace(represent_value("verdict"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Distinctiveness') || '</td><td><b>' || format_number("distinctiveness", 2) || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
