"""The ROS 2 node of the docs publishes the localizer's positions; ROS is simulated."""

import math
import runpy
import sys
from types import ModuleType, SimpleNamespace

import numpy as np
import pytest
from onboard_area import CENTER, HERE


class Stand(SimpleNamespace):
    """Message with attributes that appear when they are read."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        made = Stand()
        setattr(self, name, made)
        return made


class Node:
    def __init__(self, name):
        self.published = {}

    def declare_parameter(self, name, default):
        return SimpleNamespace(value=PARAMETERS[name])

    def create_publisher(self, kind, topic, depth):
        return SimpleNamespace(publish=lambda message: self.published.setdefault(topic, []).append(message))

    def create_subscription(self, *arguments):
        pass

    def get_logger(self):
        return SimpleNamespace(info=print)


PARAMETERS: dict[str, str] = {}


def test_the_node_publishes_where_an_image_was_taken(repository, area, monkeypatch):
    for name in ("rclpy", "rclpy.node", "geometry_msgs", "geometry_msgs.msg", "sensor_msgs", "sensor_msgs.msg"):
        monkeypatch.setitem(sys.modules, name, ModuleType(name))
    sys.modules["rclpy.node"].Node = Node
    sys.modules["geometry_msgs.msg"].PoseWithCovarianceStamped = Stand
    messages = sys.modules["sensor_msgs.msg"]
    messages.Image, messages.NavSatFix = Stand, Stand
    messages.NavSatStatus = SimpleNamespace(STATUS_FIX=0, STATUS_NO_FIX=-1)
    example = runpy.run_path(str(repository / "docs" / "examples" / "ros2_node.py"))
    PARAMETERS.update(database=area, model="")
    names = example["SemRef"].__init__.__globals__
    made = SimpleNamespace(classes=SimpleNamespace(values_in=lambda table, model: None))
    monkeypatch.setitem(names, "SegmentationModel", lambda path, threads: made)

    def labels(model, image, values, size):
        return SimpleNamespace(found=lambda: image.read(0, 0, *image.shape_hw[::-1])[0][:, :, 0])

    monkeypatch.setitem(names, "PhotoLabels", labels)
    node = example["SemRef"]()
    height, width = HERE.shape
    step = 3 * width + 4
    data = np.zeros((height, step), np.uint8)
    data[:, : 3 * width] = np.repeat(HERE[:, :, None], 3, axis=2).reshape(height, -1)
    node.localize(Stand(height=height, width=width, step=step, data=data.tobytes()))
    (fix,), (pose,) = node.published["fix"], node.published["pose"]
    assert fix.status.status == 0 and 9 < fix.longitude < 9.01
    assert (pose.pose.pose.position.x, pose.pose.pose.position.y) == pytest.approx(CENTER, abs=1)
    # The image's top points east: yaw 0 in ROS's axes.
    assert abs(pose.pose.pose.orientation.z) < 0.02 and pose.pose.pose.orientation.w == pytest.approx(1, abs=1e-3)
    assert len(pose.pose.covariance) == 36 and 0 < pose.pose.covariance[0] < 9
    assert math.isnan(fix.altitude)
