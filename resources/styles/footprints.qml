<qgis version="3.22.16" labelsEnabled="0">
 <renderer-v2 type="RuleRenderer">
  <rules>
   <rule symbol="0" filter="coalesce(&quot;status&quot;, '') &lt;> 'likely'" label="Position"/>
   <rule symbol="1" filter="&quot;status&quot; = 'likely'" label="Likely position"/>
  </rules>
  <symbols>
   <symbol name="0" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="0,103,165,22" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1" type="QString"/>
     </Option>
    </layer>
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="outline_color" value="0,103,165,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="style" value="no" type="QString"/>
     </Option>
    </layer>
   </symbol>
   <symbol name="1" type="fill">
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="color" value="224,138,0,22" type="QString"/>
      <Option name="outline_color" value="255,255,255,255" type="QString"/>
      <Option name="outline_width" value="1" type="QString"/>
     </Option>
    </layer>
    <layer class="SimpleFill">
     <Option type="Map">
      <Option name="outline_color" value="224,138,0,255" type="QString"/>
      <Option name="outline_width" value="0.6" type="QString"/>
      <Option name="style" value="no" type="QString"/>
     </Option>
    </layer>
   </symbol>
  </symbols>
 </renderer-v2>
 <previewExpression><![CDATA[base_file_name("image")]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(file_name("image"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
[% CASE WHEN regexp_match("image", '^[/\\\\]{2}|^/vsi|^[A-Za-z][^/\\\\]+:') > 0 THEN ''
WHEN file_exists("image") THEN '<br><img width="260" src="file:///' || regexp_replace(replace(replace(replace("image", '\\', '/'), '%', '%25'),
map('"', '%22', '#', '%23', '<', '%3C', '>', '%3E', '?', '%3F', ' ', '%20')), '^/+', '') || '">' ELSE '' END %]
<table cellpadding="2">
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
