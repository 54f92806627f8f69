<qgis version="3.22.16">
 <temporal enabled="1" accumulate="1" mode="1" startField="time"/>
 <renderer-v2 type="RuleRenderer">
  <rules>
   <rule symbol="0" filter="coalesce(&quot;status&quot;, '') &lt;> 'likely' AND &quot;source&quot; = 'own'" label="Own position"/>
   <rule symbol="1" filter="coalesce(&quot;status&quot;, '') &lt;> 'likely' AND &quot;source&quot; = 'flight' AND NOT coalesce(&quot;outvoted&quot;, false)" label="Position from the flight"/>
   <rule symbol="2" filter="coalesce(&quot;status&quot;, '') &lt;> 'likely' AND &quot;source&quot; = 'flight' AND &quot;outvoted&quot;" label="Own position outvoted"/>
   <rule symbol="3" filter="&quot;status&quot; = 'likely'" label="Likely position"/>
  </rules>
  <symbols>
   <symbol name="0" type="marker">
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="0,103,165,45" type="QString"/>
      <Option name="outline_color" value="0,103,165,255" type="QString"/>
      <Option name="outline_width" value="0.3" type="QString"/>
      <Option name="symbol_height_unit" value="MapUnit" type="QString"/>
      <Option name="symbol_width" value="4" type="QString"/>
      <Option name="symbol_width_unit" value="MapUnit" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;error_95_direction&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="height" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * &quot;error_95&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="width" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * coalesce(&quot;error_95_minor&quot;, &quot;error_95&quot;), 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1.4" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="0,103,165,255" type="QString"/>
      <Option name="outline_color" value="0,103,165,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
   </symbol>
   <symbol name="1" type="marker">
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="198,81,2,45" type="QString"/>
      <Option name="outline_color" value="198,81,2,255" type="QString"/>
      <Option name="outline_width" value="0.3" type="QString"/>
      <Option name="symbol_height_unit" value="MapUnit" type="QString"/>
      <Option name="symbol_width" value="4" type="QString"/>
      <Option name="symbol_width_unit" value="MapUnit" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;error_95_direction&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="height" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * &quot;error_95&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="width" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * coalesce(&quot;error_95_minor&quot;, &quot;error_95&quot;), 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1.4" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="outline_color" value="198,81,2,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
   </symbol>
   <symbol name="2" type="marker">
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="179,38,30,45" type="QString"/>
      <Option name="outline_color" value="179,38,30,255" type="QString"/>
      <Option name="outline_width" value="0.3" type="QString"/>
      <Option name="symbol_height_unit" value="MapUnit" type="QString"/>
      <Option name="symbol_width" value="4" type="QString"/>
      <Option name="symbol_width_unit" value="MapUnit" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;error_95_direction&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="height" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * &quot;error_95&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="width" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * coalesce(&quot;error_95_minor&quot;, &quot;error_95&quot;), 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="255,255,255,255" type="QString"/>
      <Option name="name" value="cross2" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1.4" type="QString"/>
      <Option name="size" value="2.6" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="SimpleMarker">
     <Option type="Map">
      <Option name="color" value="179,38,30,255" type="QString"/>
      <Option name="name" value="cross2" type="QString"/>
      <Option name="outline_color" value="179,38,30,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="size" value="2.6" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
   </symbol>
   <symbol name="3" type="marker">
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="224,138,0,45" type="QString"/>
      <Option name="outline_color" value="224,138,0,255" type="QString"/>
      <Option name="outline_width" value="0.3" type="QString"/>
      <Option name="symbol_height_unit" value="MapUnit" type="QString"/>
      <Option name="symbol_width" value="4" type="QString"/>
      <Option name="symbol_width_unit" value="MapUnit" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;error_95_direction&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="height" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * &quot;error_95&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
        <Option name="width" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(2 * coalesce(&quot;error_95_minor&quot;, &quot;error_95&quot;), 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1.4" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
    <layer class="EllipseMarker">
     <Option type="Map">
      <Option name="color" value="224,138,0,255" type="QString"/>
      <Option name="outline_color" value="224,138,0,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="symbol_height" value="5" type="QString"/>
      <Option name="symbol_name" value="triangle" type="QString"/>
      <Option name="symbol_width" value="3.2" type="QString"/>
     </Option>
     <data_defined_properties>
      <Option type="Map">
       <Option name="properties" type="Map">
        <Option name="angle" type="Map">
         <Option name="active" value="true" type="bool"/>
         <Option name="expression" value="coalesce(&quot;heading&quot;, 0)" type="QString"/>
         <Option name="type" value="3" type="int"/>
        </Option>
       </Option>
      </Option>
     </data_defined_properties>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <labeling type="simple">
  <settings>
   <text-style textColor="28,33,38,255" fontSize="8" fieldName="base_file_name(&quot;image&quot;)" isExpression="1" fontWeight="50">
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
 <editorlayout>tablayout</editorlayout>
 <attributeEditorForm>
  <attributeEditorContainer columnCount="1" name="Image">
   <attributeEditorField name="image"/>
   <attributeEditorField name="status"/>
   <attributeEditorField name="reason"/>
   <attributeEditorField name="number"/>
   <attributeEditorField name="time"/>
   <attributeEditorField name="source"/>
   <attributeEditorField name="track"/>
   <attributeEditorField name="outvoted"/>
  </attributeEditorContainer>
  <attributeEditorContainer columnCount="1" name="Position">
   <attributeEditorField name="x"/>
   <attributeEditorField name="y"/>
   <attributeEditorField name="longitude"/>
   <attributeEditorField name="latitude"/>
   <attributeEditorField name="heading"/>
   <attributeEditorField name="pixel_size"/>
  </attributeEditorContainer>
  <attributeEditorContainer columnCount="1" name="Accuracy">
   <attributeEditorField name="confidence"/>
   <attributeEditorField name="error_95"/>
   <attributeEditorField name="error_95_minor"/>
   <attributeEditorField name="error_95_direction"/>
   <attributeEditorField name="heading_deviation"/>
   <attributeEditorField name="pixel_size_deviation"/>
   <attributeEditorField name="sigma_east"/>
   <attributeEditorField name="sigma_north"/>
   <attributeEditorField name="correlation"/>
   <attributeEditorField name="sigma_heading"/>
   <attributeEditorField name="sigma_scale"/>
  </attributeEditorContainer>
  <attributeEditorContainer columnCount="1" name="Method">
   <attributeEditorField name="method"/>
   <attributeEditorField name="distance"/>
   <attributeEditorField name="inliers"/>
   <attributeEditorField name="references"/>
   <attributeEditorField name="log_odds"/>
   <attributeEditorField name="window"/>
   <attributeEditorField name="search_capped"/>
   <attributeEditorField name="jump"/>
   <attributeEditorField name="camera"/>
   <attributeEditorField name="camera_x"/>
   <attributeEditorField name="camera_y"/>
   <attributeEditorField name="gps_distance"/>
  </attributeEditorContainer>
 </attributeEditorForm>
 <previewExpression><![CDATA[base_file_name("image")]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(file_name("image"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
[% CASE WHEN regexp_match("image", '^[/\\\\]{2}|^/vsi|^[A-Za-z][^/\\\\]+:') > 0 THEN ''
WHEN file_exists("image") THEN '<br><img width="260" src="file:///' || regexp_replace(replace(replace(replace("image", '\\', '/'), '%', '%25'),
map('"', '%22', '#', '%23', '<', '%3C', '>', '%3E', '?', '%3F', ' ', '%20')), '^/+', '') || '">' ELSE '' END %]
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Status') || '</td><td><b>' || if("status" <> '', replace(replace(represent_value("status"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('95 % radius') || '</td><td><b>' || format_number("error_95", 1) || ' m' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Heading') || '</td><td><b>' || format_number("heading", 1) || '°' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Pixel size') || '</td><td><b>' || format_number("pixel_size", 2) || ' m' || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Error probability') || '</td><td><b>' || (CASE WHEN "method" = 'topology vector' THEN NULL
WHEN "confidence" >= 0.9999 THEN replace(_('below 1 in {count:,.0f}'), '{count:,.0f}', format_number(10000, 0))
ELSE with_variable('times', 1 / max(1 - "confidence", 0.0001),
replace(_('1 in {count:,.0f}'), '{count:,.0f}', format_number(round(@times, 1 - to_int(floor(log10(@times)))), 0))) END) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Method') || '</td><td><b>' || if("method" <> '', replace(replace(represent_value("method"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Reason') || '</td><td><b>' || replace(replace(to_string("reason"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Source') || '</td><td><b>' || if("source" <> '', replace(replace(represent_value("source"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')), NULL) || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Track') || '</td><td><b>' || to_string("track") || '</b></td></tr>', '') %]
[% coalesce('<tr><td>' || _('Time') || '</td><td><b>' || format_date("time", 'yyyy-MM-dd HH:mm:ss') || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>0</layerGeometryType>
</qgis>
