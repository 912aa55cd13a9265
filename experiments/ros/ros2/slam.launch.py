# SPDX-License-Identifier: BSD-3-Clause
"""In place of a launch file of slam_gmapping: its parameters, and flags of gmapping_spa."""

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

DEFAULTS = {"base_frame": "base_link", "odom_frame": "odom", "map_frame": "map", "output_dir": "",
            "save_session": "", "map_session": "", "localize": "false"}


def generate_launch_description():
    arguments = {"scan": "scan", "use_sim_time": "false", **DEFAULTS}
    parameters = {name: LaunchConfiguration(name) for name in ["use_sim_time", *DEFAULTS]}
    node = Node(
        package="gmapping_spa_ros2",
        executable="slam_node",
        name="slam_gmapping",
        output="screen",
        parameters=[parameters],
        remappings=[("scan", LaunchConfiguration("scan"))],
    )
    return LaunchDescription(
        [DeclareLaunchArgument(name, default_value=value) for name, value in arguments.items()] + [node]
    )
