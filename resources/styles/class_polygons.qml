<qgis version="3.22.16" labelsEnabled="0">
 <previewExpression><![CDATA["class_name"]]></previewExpression>
 <mapTip><![CDATA[<b>[% replace(replace(to_string("class_name"), '&', '&amp;'), map('<', '&lt;', '>', '&gt;')) %]</b>
<table cellpadding="2">
[% coalesce('<tr><td>' || _('Area') || '</td><td><b>' || format_number("area", 0) || ' m²' || '</b></td></tr>', '') %]
</table>]]></mapTip>
 <layerGeometryType>2</layerGeometryType>
</qgis>
