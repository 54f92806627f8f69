<qgis version="3.22.16">
 <fieldConfiguration>
  <field name="image">
   <editWidget type="ExternalResource">
    <config>
     <Option type="Map">
      <Option name="DocumentViewer" value="1" type="int"/>
      <Option name="DocumentViewerHeight" value="260" type="int"/>
      <Option name="FileWidget" value="true" type="bool"/>
      <Option name="StorageMode" value="0" type="int"/>
     </Option>
    </config>
   </editWidget>
  </field>
  <field name="message">
   <editWidget type="TextEdit">
    <config>
     <Option type="Map">
      <Option name="IsMultiline" value="true" type="bool"/>
     </Option>
    </config>
   </editWidget>
  </field>
  <field name="reason">
   <editWidget type="TextEdit">
    <config>
     <Option type="Map">
      <Option name="IsMultiline" value="true" type="bool"/>
     </Option>
    </config>
   </editWidget>
  </field>
 </fieldConfiguration>
 <aliases>
  <alias field="name" name="Name"/>
  <alias field="level" name="Level"/>
  <alias field="size" name="Size (m)"/>
  <alias field="center_x" name="Easting of the center"/>
  <alias field="center_y" name="Northing of the center"/>
  <alias field="longitude" name="Longitude"/>
  <alias field="latitude" name="Latitude"/>
  <alias field="reference_count" name="Landmarks"/>
  <alias field="vector" name="Topology vector"/>
  <alias field="distinctiveness" name="Distinctiveness"/>
  <alias field="class" name="Class value"/>
  <alias field="class_name" name="Class"/>
  <alias field="area" name="Area (m²)"/>
  <alias field="touches_edge" name="Touches the edge"/>
  <alias field="image" name="Image"/>
  <alias field="status" name="Status"/>
  <alias field="x" name="Easting"/>
  <alias field="y" name="Northing"/>
  <alias field="heading" name="Heading (° from grid north)"/>
  <alias field="pixel_size" name="Pixel size (m)"/>
  <alias field="confidence" name="Confidence"/>
  <alias field="distance" name="Distance of the topology vectors"/>
  <alias field="inliers" name="Matched landmarks"/>
  <alias field="references" name="Landmarks in the image"/>
  <alias field="log_odds" name="Log odds"/>
  <alias field="error_95" name="95 % radius (m)"/>
  <alias field="window" name="Window"/>
  <alias field="method" name="Method"/>
  <alias field="reason" name="Reason"/>
  <alias field="camera_x" name="Easting of the camera"/>
  <alias field="camera_y" name="Northing of the camera"/>
  <alias field="jump" name="Faster than the maximum speed"/>
  <alias field="error_95_minor" name="Minor semi-axis of the 95 % ellipse (m)"/>
  <alias field="error_95_direction" name="Direction of the major semi-axis (°)"/>
  <alias field="heading_deviation" name="Heading deviation (°)"/>
  <alias field="pixel_size_deviation" name="Standard deviation of the pixel size (m)"/>
  <alias field="search_capped" name="Limited search"/>
  <alias field="sigma_east" name="Standard deviation to the east (m)"/>
  <alias field="sigma_north" name="Standard deviation to the north (m)"/>
  <alias field="correlation" name="Correlation of east and north"/>
  <alias field="sigma_heading" name="Standard deviation of the heading (°)"/>
  <alias field="sigma_scale" name="Relative standard deviation of the scale"/>
  <alias field="camera" name="Camera"/>
  <alias field="gps_distance" name="Distance of the photo’s GPS from the database (m)"/>
  <alias field="time" name="Time (UTC)"/>
  <alias field="rank" name="Rank"/>
  <alias field="number" name="Number"/>
  <alias field="source" name="Source"/>
  <alias field="track" name="Track"/>
  <alias field="outvoted" name="Own position outvoted"/>
  <alias field="images" name="Images"/>
  <alias field="own" name="Images with an own position"/>
  <alias field="first" name="First image"/>
  <alias field="last" name="Last image"/>
  <alias field="length" name="Length (m)"/>
  <alias field="largest_error_95" name="Largest 95 % radius (m)"/>
  <alias field="start" name="Start (UTC)"/>
  <alias field="end" name="End (UTC)"/>
  <alias field="image_column" name="Column in the image"/>
  <alias field="image_row" name="Row in the image"/>
  <alias field="seen_x" name="Observed easting"/>
  <alias field="seen_y" name="Observed northing"/>
  <alias field="residual" name="Residual (m)"/>
  <alias field="column" name="Column"/>
  <alias field="row" name="Row"/>
  <alias field="center_distance" name="Distance from the center (px)"/>
  <alias field="footprint" name="Footprint (m)"/>
  <alias field="success" name="Expected success"/>
  <alias field="success_low" name="Expected success, lower limit (95 %)"/>
  <alias field="success_high" name="Expected success, upper limit (95 %)"/>
  <alias field="error" name="Error (m)"/>
  <alias field="objects" name="Landmarks in view"/>
  <alias field="classes" name="Classes in view"/>
  <alias field="look_alikes" name="Similar windows"/>
  <alias field="wrong" name="Wrong positions (share)"/>
  <alias field="trials" name="Simulated images"/>
  <alias field="verdict" name="Verdict"/>
  <alias field="route" name="Route"/>
  <alias field="along" name="Along the route (m)"/>
  <alias field="gap" name="Stretch without an expected position (m)"/>
  <alias field="gap_seconds" name="Stretch without an expected position (s)"/>
  <alias field="shift" name="Suggested shift to the right (m)"/>
  <alias field="shift_success" name="Expected success after the shift"/>
  <alias field="stretch" name="Stretch of the route (WKT)"/>
  <alias field="flight_placed" name="Share of the flights with a position"/>
  <alias field="flight_radius" name="95 % radius in flight (m)"/>
  <alias field="flight_lost" name="Share of the flights that lose the track"/>
  <alias field="kind" name="Kind"/>
  <alias field="severity" name="Severity"/>
  <alias field="message" name="Message"/>
  <alias field="feature_id" name="Feature"/>
  <alias field="other_id" name="Other feature"/>
  <alias field="annotated_class" name="Annotated class"/>
  <alias field="predicted_class" name="Predicted class"/>
  <alias field="annotated_value" name="Annotated value"/>
  <alias field="predicted_value" name="Predicted value"/>
  <alias field="trial" name="Trial"/>
  <alias field="right" name="Correct"/>
  <alias field="heading_error" name="Heading error (°)"/>
  <alias field="scale_error" name="Scale error"/>
  <alias field="true_x" name="True easting"/>
  <alias field="true_y" name="True northing"/>
  <alias field="scale" name="Scale"/>
  <alias field="offset" name="Offset from the window"/>
  <alias field="missed" name="Missed landmarks (%)"/>
  <alias field="invented" name="Spurious landmarks (%)"/>
  <alias field="misnamed" name="Mislabeled landmarks (%)"/>
  <alias field="ragged" name="Boundary jitter (m)"/>
  <alias field="landmarks" name="Landmarks in the database"/>
  <alias field="background" name="Mislabeled background (%)"/>
  <alias field="displaced" name="Map displacement (m)"/>
  <alias field="shifted" name="Class offset (m)"/>
  <alias field="leaning" name="Building lean (%)"/>
  <alias field="lens" name="Lens distortion (%)"/>
  <alias field="tilt" name="Camera tilt (°)"/>
  <alias field="road" name="Method of the position"/>
  <alias field="radius_ratio" name="Error / 95 % radius"/>
 </aliases>
</qgis>
