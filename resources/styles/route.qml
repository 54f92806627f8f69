<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="singleSymbol" symbollevels="1">
  <symbols>
   <symbol name="0" type="marker">
    <layer class="GeometryGenerator">
     <Option type="Map">
      <Option name="SymbolType" value="Line" type="QString"/>
      <Option name="geometryModifier" value="coalesce(geom_from_wkt(&quot;stretch&quot;), make_line(translate($geometry, -7, 0), translate($geometry, 7, 0)))" type="QString"/>
     </Option>
     <symbol name="@0@0" type="line">
      <layer class="SimpleLine">
       <Option type="Map">
        <Option name="capstyle" value="round" type="QString"/>
        <Option name="line_color" value="28,33,38,255" type="QString"/>
        <Option name="line_width" value="2.8" type="QString"/>
       </Option>
      </layer>
     </symbol>
    </layer>
    <layer class="GeometryGenerator" pass="1">
     <Option type="Map">
      <Option name="SymbolType" value="Line" type="QString"/>
      <Option name="geometryModifier" value="coalesce(geom_from_wkt(&quot;stretch&quot;), make_line(translate($geometry, -7, 0), translate($geometry, 7, 0)))" type="QString"/>
     </Option>
     <symbol name="@0@1" type="line">
      <layer class="SimpleLine">
       <Option type="Map">
        <Option name="capstyle" value="round" type="QString"/>
        <Option name="line_color" value="255,255,255,255" type="QString"/>
        <Option name="line_width" value="2.3" type="QString"/>
       </Option>
      </layer>
     </symbol>
    </layer>
    <layer class="GeometryGenerator" pass="2">
     <Option type="Map">
      <Option name="SymbolType" value="Line" type="QString"/>
      <Option name="geometryModifier" value="coalesce(geom_from_wkt(&quot;stretch&quot;), make_line(translate($geometry, -7, 0), translate($geometry, 7, 0)))" type="QString"/>
     </Option>
     <symbol name="@0@2" type="line">
      <layer class="SimpleLine">
       <Option type="Map">
        <Option name="capstyle" value="round" type="QString"/>
        <Option name="line_color" value="255,234,70,255" type="QString"/>
        <Option name="line_width" value="1.6" type="QString"/>
       </Option>
      </layer>
     </symbol>
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
[% coalesce('<tr><td>' || _('Along the route') || '</td><td><b>' || format_number(0.001 * "along", 2) || ' km' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Stretch without an expected position') || '</td><td><b>' || if("gap" > 0, format_number("gap", 0) || ' m', NULL) || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>0</layerGeometryType>
</qgis>
