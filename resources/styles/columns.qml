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
  <alias field="confidence" name="Probability to be right"/>
  <alias field="distance" name="Distance of topology vectors"/>
  <alias field="inliers" name="Landmarks that agree"/>
  <alias field="references" name="Landmarks in the image"/>
  <alias field="log_odds" name="Logarithm of the odds"/>
  <alias field="error_95" name="95 % radius (m)"/>
  <alias field="window" name="Window"/>
  <alias field="method" name="Method"/>
  <alias field="reason" name="Reason"/>
  <alias field="camera_x" name="Easting below the camera"/>
  <alias field="camera_y" name="Northing below the camera"/>
  <alias field="jump" name="Out of reach in time"/>
  <alias field="error_95_minor" name="Shorter semi-axis of the 95 % ellipse (m)"/>
  <alias field="error_95_direction" name="Direction of its longer semi-axis (°)"/>
  <alias field="heading_deviation" name="Deviation of the heading (°)"/>
  <alias field="pixel_size_deviation" name="Deviation of the pixel size (m)"/>
  <alias field="search_capped" name="Search was capped"/>
  <alias field="sigma_east" name="Deviation eastwards (m)"/>
  <alias field="sigma_north" name="Deviation northwards (m)"/>
  <alias field="correlation" name="Correlation of both"/>
  <alias field="sigma_heading" name="Standard deviation of the heading (°)"/>
  <alias field="sigma_scale" name="Relative deviation of the scale"/>
  <alias field="camera" name="Camera"/>
  <alias field="gps_distance" name="Distance of the photo’s GPS from the database (m)"/>
  <alias field="time" name="Time (UTC)"/>
  <alias field="rank" name="Rank"/>
  <alias field="number" name="Number"/>
  <alias field="source" name="Held by"/>
  <alias field="track" name="Track"/>
  <alias field="outvoted" name="Its own fix was outvoted"/>
  <alias field="images" name="Images"/>
  <alias field="own" name="Images with a fix of their own"/>
  <alias field="first" name="First image"/>
  <alias field="last" name="Last image"/>
  <alias field="length" name="Length (m)"/>
  <alias field="largest_error_95" name="Largest 95 % radius (m)"/>
  <alias field="start" name="Start (UTC)"/>
  <alias field="end" name="End (UTC)"/>
  <alias field="image_column" name="Column in the image"/>
  <alias field="image_row" name="Row in the image"/>
  <alias field="seen_x" name="Easting where it is seen"/>
  <alias field="seen_y" name="Northing where it is seen"/>
  <alias field="residual" name="Residual (m)"/>
  <alias field="column" name="Column"/>
  <alias field="row" name="Row"/>
  <alias field="center_distance" name="Distance from the center (px)"/>
  <alias field="footprint" name="Footprint (m)"/>
  <alias field="success" name="Expected success"/>
  <alias field="success_low" name="Expected success, at least (95 %)"/>
  <alias field="success_high" name="Expected success, at most (95 %)"/>
  <alias field="error" name="Error (m)"/>
  <alias field="objects" name="Landmarks in view"/>
  <alias field="classes" name="Classes in view"/>
  <alias field="look_alikes" name="Look-alikes"/>
  <alias field="wrong" name="Wrong fixes (share)"/>
  <alias field="trials" name="Simulated images"/>
  <alias field="verdict" name="Verdict"/>
  <alias field="route" name="Route"/>
  <alias field="along" name="Along the route (m)"/>
  <alias field="gap" name="Stretch without an expected fix (m)"/>
  <alias field="gap_seconds" name="Stretch without an expected fix (s)"/>
  <alias field="shift" name="Shift to the right that helps (m)"/>
  <alias field="shift_success" name="Expected success when shifted"/>
  <alias field="stretch" name="Stretch of the route (WKT)"/>
  <alias field="flight_placed" name="Share of the flights with a position"/>
  <alias field="flight_radius" name="95 % radius in flight (m)"/>
  <alias field="flight_lost" name="Share of the flights that lose their track"/>
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
  <alias field="right" name="Right"/>
  <alias field="heading_error" name="Error of the heading (°)"/>
  <alias field="scale_error" name="Error of the scale"/>
  <alias field="true_x" name="True easting"/>
  <alias field="true_y" name="True northing"/>
  <alias field="scale" name="Scale"/>
  <alias field="offset" name="Offset from the window"/>
  <alias field="missed" name="Landmarks missed (%)"/>
  <alias field="invented" name="Landmarks invented (%)"/>
  <alias field="misnamed" name="Landmarks misnamed (%)"/>
  <alias field="ragged" name="Ragged edges (map units)"/>
  <alias field="landmarks" name="Landmarks in the database"/>
  <alias field="background" name="Background misnamed (%)"/>
  <alias field="displaced" name="Map displaced (map units)"/>
  <alias field="shifted" name="Classes shifted (map units)"/>
  <alias field="leaning" name="Leaning roofs (%)"/>
  <alias field="lens" name="Lens distortion (%)"/>
  <alias field="tilt" name="Camera tilt (°)"/>
  <alias field="road" name="Road to the fix"/>
  <alias field="radius_ratio" name="Error over 95 % radius"/>
 </aliases>
</qgis>
