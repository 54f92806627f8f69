"""A ROS 2 node: images in, positions on the map out. An example to start from; it needs the wheel ``semref``.

ros2 run … --ros-args -p database:=area.npz -p model:=landcover.onnx

It reads ``image`` (sensor_msgs/Image, rgb8) and publishes ``fix`` (sensor_msgs/NavSatFix) and ``pose``
(geometry_msgs/PoseWithCovarianceStamped: x east and y north along the map's axes, yaw from east to the image's top).
"""

import math

import numpy as np
import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped
from rclpy.node import Node
from sensor_msgs.msg import Image, NavSatFix, NavSatStatus

from semref.core.labels.image_source import ArrayImage
from semref.core.localization import Method, Prior
from semref.core.localizer.localizer import Localizer
from semref.core.onboard.read import read_onboard
from semref.core.segmentation.model import SegmentationModel
from semref.core.segmentation.photo_labels import PhotoLabels


class SemRef(Node):
    def __init__(self):
        super().__init__("semref")
        path = self.declare_parameter("database", "area.npz").value
        self.onboard = read_onboard(path)
        self.localizer = Localizer(self.onboard.database)
        model = self.declare_parameter("model", "landcover.onnx").value
        self.model = SegmentationModel(model, 1)
        self.values = self.model.classes.values_in(self.onboard.database.class_table, model)
        self.pose = self.create_publisher(PoseWithCovarianceStamped, "pose", 10)
        self.fix = self.create_publisher(NavSatFix, "fix", 10)
        self.create_subscription(Image, "image", self.localize, 1)

    def localize(self, image):
        rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
        photo = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
        labels = PhotoLabels(self.model, ArrayImage(photo), self.values, None).found()
        found = self.localizer.localize(labels, Method.AUTOMATIC, Prior())
        fix = NavSatFix(header=image.header)
        fix.status.status = NavSatStatus.STATUS_FIX if found.is_fix else NavSatStatus.STATUS_NO_FIX
        if found.is_fix and self.onboard.lon_lat is not None:
            longitudes, latitudes = self.onboard.lon_lat(np.array([found.position]))
            fix.longitude, fix.latitude, fix.altitude = float(longitudes[0]), float(latitudes[0]), math.nan
        self.fix.publish(fix)
        if not found.is_fix:
            self.get_logger().info(str(found.status))
            return
        pose = PoseWithCovarianceStamped()
        pose.header.stamp, pose.header.frame_id = image.header.stamp, "map"
        pose.pose.pose.position.x, pose.pose.pose.position.y = found.position
        yaw = math.radians(90 - found.heading_deg)
        pose.pose.pose.orientation.z, pose.pose.pose.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        # Not known: height, roll and pitch.
        covariance = np.diag([0, 0, 1e4, 1e4, 1e4, math.radians(found.covariance.heading_deviation_deg) ** 2])
        covariance[:2, :2] = found.covariance.position
        pose.pose.covariance = covariance.ravel().tolist()
        self.pose.publish(pose)


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(SemRef())
